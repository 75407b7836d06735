"""The replay on a folder of meshes: does it equal the run, are gradients right and finite, and what do they cost?

python -m tests.benchmarks.replay FOLDER [NAME ...]      (python -m tests.benchmarks.replay --help)
"""

import argparse
import resource
import time
from functools import partial
from pathlib import Path
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

import msf_jax
from msf_jax import MeshError, Weights, objectives
from tests.device_cases import central_difference

NAMES = ("three-holes", "homer", "indorelax", "armadillo", "bunny", "elephant", "cheburashka", "sindorelax", "horse")
TIGHT = 1e-15  # of the solves, where differences are taken
STEPS = (1e-4, 1e-5, 1e-6, 1e-7)  # in the logarithm of a weight, of which each takes its best: noise or kinks


def seconds(function: Any, *arguments: Any) -> float:
    """Median of three calls."""
    spent = []
    for _ in range(3):
        start = time.perf_counter()
        jax.block_until_ready(function(*arguments))
        spent.append(time.perf_counter() - start)
    return float(np.median(spent))


def row(path: Path, num_vertices: int) -> str:
    """One line of the table for the mesh at ``path``; ``num_vertices`` of it are checked by central differences."""
    flow = msf_jax.contract(path)
    tape, random = flow.tape, np.random.default_rng(0)
    vertices = np.asarray(tape.vertices)
    diagonal = np.linalg.norm(np.ptp(vertices, axis=0))
    error = np.abs(np.asarray(msf_jax.replay(tape, flow.weights)) - flow.curve.vertices).max() / diagonal
    towards = random.normal(size=(tape.num_nodes, 3))

    def value(tolerance: float | None, tape: Any, logarithms: Any, vertices: Any) -> Any:
        nodes = msf_jax.replay(tape, Weights(*jnp.exp(logarithms)), vertices, tolerance=tolerance)
        balls = objectives.value_at(objectives.explained(), tape, nodes, vertices)
        return (towards * (nodes - flow.curve.vertices)).sum() / diagonal + balls

    at = np.log([float(weight) for weight in vars(flow.weights).values()])
    slope_of = jax.jit(jax.value_and_grad(partial(value, None), argnums=(1, 2)))
    value_of, tight = jax.jit(partial(value, None)), jax.jit(partial(value, TIGHT))
    _, (by_log, by_vertex) = slope_of(tape, at, vertices)
    is_finite = all(bool(np.isfinite(part).all()) for part in (by_log, by_vertex))
    ratio = seconds(slope_of, tape, at, vertices) / (once := seconds(value_of, tape, at, vertices))
    off_weight = off_vertex = np.nan
    if num_vertices:
        slopes = [
            [central_difference(lambda x: tight(tape, x, vertices), at, axis, step) for axis in np.eye(4)]
            for step in STEPS
        ]
        off_weight = np.max(np.min(np.abs(np.array(slopes) / by_log - 1), axis=0))
        pairs = []
        for vertex in random.choice(len(vertices), num_vertices, replace=False):
            step = np.zeros_like(vertices)
            step[vertex] = random.normal(size=3) * diagonal
            pairs.append(
                (
                    (by_vertex[vertex] * step[vertex]).sum(),
                    central_difference(lambda x: tight(tape, at, x), vertices, step, 1e-6),
                )
            )
        found, measured = np.array(pairs).T
        off_vertex = np.linalg.norm(found - measured) / np.linalg.norm(measured)
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6
    return (
        f"| {path.stem} | {len(vertices)} | {error:.1e} | {off_weight:.1e} | {off_vertex:.1e} | {is_finite} | "
        f"{once:.2f} | {ratio:.2f} | {peak:.1f} |"
    )


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path, help="of .off files")
    parser.add_argument("names", nargs="*", default=NAMES, help="of the meshes")
    parser.add_argument(
        "--vertices", type=int, default=20, help="to check by central differences; 0 for none, of weights, too"
    )
    parser.add_argument("--float32", action="store_true", help="all in float32")
    arguments = parser.parse_args()
    jax.config.update("jax_enable_x64", not arguments.float32)
    print("| mesh | vertices | replay - run | weights | vertices | finite | replay s | value and gradient | peak GB |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- | --- |")
    for name in arguments.names:
        try:
            print(row(arguments.folder / f"{name}.off", arguments.vertices), flush=True)
        except MeshError as error:
            print(f"| {name} | {error} |")


if __name__ == "__main__":
    main()
