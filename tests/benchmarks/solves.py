"""How far from their solutions do the contraction's solves end?

python -m tests.benchmarks.solves [NAME ...] [--tight]      (python -m tests.benchmarks.solves --help)

Each solve of a run's first iterations is compared with a sparse factorisation, refined in float64, with the default
weights and with weights that make it hard. Lengths are RMS over free vertices, in the least t_c of any limb.
"""

import argparse
from dataclasses import replace
from typing import Any

import jax
import numpy as np
import scipy.sparse as sp
import trimesh
from scipy.sparse.linalg import splu

from msf_jax import Config, Weights
from msf_jax.base.clock import Clock
from msf_jax.device.contraction import Gram
from msf_jax.device.iteration import _energies, _equations, jitted_move
from msf_jax.flow import starting, stepping
from msf_jax.meshes import checking
from tests.benchmarks import frame, ground_truth

NAMES = ("arc_coarse", "y_coarse", "helix_coarse", "tree_coarse", "octopus_low", "hand", "pawn_low", "comb", "theta")
WEIGHTS = {
    "default": Weights(),
    "w_H 0.001": Weights(w_H=0.001),
    "w_H 0.001, w_M 0": Weights(w_H=0.001, w_M=0.0),
    "w_H 0.02, w_M 0.1": Weights(w_H=0.02, w_M=0.1),
    "w_M 0": Weights(w_M=0.0),
    "w_H 1": Weights(w_H=1.0),
}
UNEVEN = "w_H 1 or 0.001, w_M 0"  # 1 on one half of the vertices, along the longest axis
ITERATIONS = 8, 4  # with the default weights, and with others
REFINEMENTS = 3


def matrix(operator: Gram) -> sp.csr_matrix:
    """The equations of the free vertices."""
    num, free, own = len(operator.own), np.asarray(operator.free), np.asarray(operator.own)
    row = np.concatenate([np.tile(np.arange(level.rows), level.slots) for level in operator.layout.levels])
    first, second = (
        sp.csr_matrix((weights, (row, np.asarray(operator.neighbour))), shape=(num, num)) + sp.diags(own)
        for weights in np.asarray(operator.weights)
    )
    whole = second @ first + sp.diags(np.asarray(operator.shift))
    return whole.tocsr()[free > 0][:, free > 0]


def solved(A: sp.csr_matrix, b: np.ndarray) -> np.ndarray:
    """The solution to rounding."""
    factors = splu(A.tocsc(), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})
    x = factors.solve(b)
    for _ in range(REFINEMENTS):
        x += factors.solve(b - A @ x)
    return x


def uneven(vertices: np.ndarray) -> np.ndarray:
    """(n, 4) a row of weights for each of the ``vertices``."""
    along = vertices[:, np.ptp(vertices, axis=0).argmax()]
    w_H = np.where(along > np.median(along), 0.001, 1.0)
    return np.stack([np.ones_like(w_H), w_H, np.zeros_like(w_H), np.zeros_like(w_H)], axis=1)


def solves(mesh: trimesh.Trimesh, weights: Weights | None, config: Config, most: int) -> list[dict[str, Any]]:
    """The figures of each solve of a run's first iterations, with `uneven` weights if none are given."""
    component, found = checking.prepare(mesh).components[0], []
    of_vertices = None if weights else uneven(component.vertices)
    weights = weights or Weights()
    state = starting.init(component, 0, config, Clock(), weights=of_vertices)
    while len(found) < most and not state.failure and state.meso.num_live - int(state.meso.is_fixed.sum()) > 20:
        layout, _, _, buffers, given = stepping.packed(state, weights)
        given = jax.tree_util.tree_map(lambda value: jax.numpy.asarray(value, float), given)
        given, buffers = replace(given, smoothing=jax.numpy.zeros(())), jax.device_put(buffers)
        settings = config.on_device
        operator, b = _equations(buffers, _energies(buffers, given, settings, layout)[0], settings, layout)
        moved = jitted_move(buffers, given, settings, layout)
        free = np.asarray(operator.free) > 0
        exact = solved(matrix(operator), np.asarray(b)[free])
        error = np.asarray(moved.positions - buffers.positions)[free] - exact
        report, unit = moved.solves, float(buffers.t_c) * free.sum() ** 0.5
        figures = {"steps": report.steps[0].item(), "has_ended": report.has_ended[0].item()}
        found.append(figures | {"error": np.linalg.norm(error) / unit})
        stepping.step(state, weights, config, Clock())
    return found


def cells_of(found: list[dict[str, Any]]) -> list[str]:
    error = [each["error"] for each in found]
    steps = f"{len(found)}, {sum(each['steps'] for each in found):,}"
    return [steps, f"{min(error):.2f} to {max(error):.2f}", f"{sum(not each['has_ended'] for each in found)}"]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", default=NAMES, help="shapes of known truth")
    parser.add_argument("--tight", action="store_true", help="with Config.tight()")
    options = parser.parse_args()
    jax.config.update("jax_enable_x64", True)
    config = Config().tight() if options.tight else Config()
    meshes = [ground_truth.make(name).mesh for name in options.names]
    print(frame.head(["weights", "solves, steps", "error", "out of steps"]), end="")
    for label, weights in (WEIGHTS | {UNEVEN: None}).items():
        found = [each for mesh in meshes for each in solves(mesh, weights, config, ITERATIONS[label != "default"])]
        print(frame.line([label, *cells_of(found)]), end="", flush=True)


if __name__ == "__main__":
    main()
