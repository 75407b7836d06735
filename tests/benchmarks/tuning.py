"""What does a weight for every vertex win, on the contracted surface and on the finished curve?

    python -m tests.benchmarks.tuning [--shapes SHAPE,..] [--steps N]

A table in Markdown: the mean distance between the contracted surface and the true curve, then that of the finished
curve, in thousandths of the diagonal, of `Config.smooth` with the default weights and with those of `tune`; and the
distance of the finished curve of `Config`.
"""

import argparse
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

import msf_jax
from msf_jax import Config, metrics
from tests.benchmarks import frame, ground_truth
from tests.benchmarks.ground_truth import KnownShape

SPACING = 0.005  # diagonals: between points of the true curve
SWEPT: dict[str, Any] = {
    "s_curve_8": ("s_curve", 0.12, "flat"),
    "ring_8": ("ring", 0.14, "none"),
}  # line, radius, ends: of eight sides


def made(name: str) -> KnownShape:
    if name not in SWEPT:
        return ground_truth.make(name)
    line, radius, ends = SWEPT[name]
    return replace(ground_truth.swept(line, radius, 8, ends), name=name)


def near(target: np.ndarray) -> Callable[[Any], jax.Array]:
    """Mean distance between points and those of a ``target`` (P, 3), the mean of both directions."""

    def objective(points: Any) -> jax.Array:
        away = jnp.sqrt(((points[:, None] - target) ** 2).sum(axis=2) + 1e-18)  # differentiable where points coincide
        return (away.min(axis=1).mean() + away.min(axis=0).mean()) / 2

    return objective


def row_of(shape: KnownShape, steps: int) -> list[str]:
    size = 1e-3 * frame.diagonal(shape.mesh.vertices)
    objective = near(metrics.sample_curve(shape.points, shape.edges, SPACING * shape.mesh.scale)[0])
    tuned = msf_jax.tune(shape.mesh, objective, steps=steps)
    cells = []
    for flow in (msf_jax.contract(shape.mesh, config=Config.smooth()), tuned.flow):
        cells += [", ".join(f"{objective(x) / size:.2f}" for x in (flow.meso_skeleton[0], flow.skeleton.vertices))]
    cells += [f"{objective(msf_jax.skeletonize(shape.mesh).vertices) / size:.2f}"]
    return [*cells, f"{abs(tuned.value / tuned.trajectory.min() - 1):.0e}"]


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--shapes", type=frame.words, default=["arc_coarse", "y_coarse", *SWEPT], help="which")
    parser.add_argument("--steps", type=int, default=60, help="of Adam")
    options = parser.parse_args()
    frame.configure_jax()
    print(frame.head(["shape", "default weights", "tuned", "finished, Config()", "tape and run differ by"]), end="")
    for name in options.shapes:
        print(frame.line([name, *row_of(made(name), options.steps)]), end="", flush=True)


if __name__ == "__main__":
    main()
