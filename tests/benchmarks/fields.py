"""Weights per vertex: what they gain on the surface and on the finished curve.

``python -m tests.benchmarks.fields`` tunes a weight for every vertex of some shapes, each on its own, and prints the
mean distance between the contracted surface and the true curve, then that of the finished curve, in thousandths of the
diagonal: with the default weights, with the best of random numbers and of CMA-ES (the ``cma`` package, if it is
installed) at the same cost, with the best numbers of `tune`, and with fields.
"""

import argparse
import time
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import jax
import numpy as np

import msf_jax
from msf_jax import Config, Weights, ground_truth, metrics, objectives
from msf_jax.gradients.replay import replay_meso
from msf_jax.ground_truth import KnownShape
from msf_jax.tuning.objectives import Objective
from msf_jax.tuning.surface import FIELD_BOUNDS, TRIES

SPACING = 0.005  # diagonals: between points of the true curve
LINE = np.linspace(0, 1, 401)
COARSE = ("straight_coarse", "arc_coarse", "helix_coarse", "y_coarse")  # what `tune` was made with
SWEPT = {  # held out: line, radius, ends: tubes of eight sides, so that a run is short
    "s_curve_8": ("s_curve", 0.12, "flat"),
    "taper_8": ("straight", 0.21 - 0.14 * LINE, "round"),
    "wavy_8": ("straight", 0.13 + 0.03 * np.sin(5 * np.pi * LINE), "round"),
    "ring_8": ("ring", 0.14, "none"),
}


def made(name: str) -> KnownShape:
    if name not in SWEPT:
        return ground_truth.make(name)
    line, radius, ends = SWEPT[name]
    return replace(ground_truth._swept(line, radius, 8, ends), name=name)


def target(shape: KnownShape) -> Objective:
    return objectives.near(metrics.sample_curve(shape.points, shape.edges, SPACING * shape.mesh.scale)[0])


def found(shape: KnownShape, weights: Weights, config: Config) -> str:
    """Of the surface, and of the finished curve."""
    run, objective = msf_jax.contract(shape.mesh, weights, config), target(shape)
    surface = float(objectives.of_surface(objective, run.tape, run.meso_skeleton[0]))
    curve = objectives.of_skeleton(objective, run.skeleton, shape.mesh)
    return f"{1e3 * surface:.2f}, {1e3 * curve:.2f}"


def on_tape(shape: KnownShape, config: Config) -> Callable[[np.ndarray], float]:
    """The objective of the surface, by the tape, at the logarithms (2,) of w_H and w_M; inf where a solve fails."""
    tape, objective = msf_jax.contract(shape.mesh, config=config).tape, target(shape)

    @jax.jit
    def value(tape: Any, w_H: Any, w_M: Any) -> Any:
        return objectives.of_surface(objective, tape, replay_meso(tape, Weights(1.0, w_H, w_M, 0.001)))

    return lambda pair: float(np.nan_to_num(float(value(tape, *np.exp(pair))), nan=np.inf))


def numbers_at(pair: Any) -> Weights:
    return Weights(1.0, *np.exp(pair).tolist(), 0.001)


def by_chance(value: Callable[[np.ndarray], float], num: int) -> Weights:
    """The best of ``num`` random pairs of numbers."""
    return numbers_at(min(np.random.default_rng(0).uniform(*np.log(FIELD_BOUNDS), (num, 2)), key=value))


def by_cma(cma: Any, value: Callable[[np.ndarray], float], num: int) -> Weights:
    """The best of ``num`` pairs of numbers by CMA-ES from the default weights, with a third of the range as spread."""
    low, high = np.log(FIELD_BOUNDS)
    start, options = np.log([Weights().w_H, Weights().w_M]), {"verbose": -9, "seed": 1, "bounds": [low, high]}
    best = cma.fmin2(value, start, (high - low) / 3, {**options, "maxfevals": num})[1].result
    return numbers_at(best.xbest)


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--shapes", default=",".join([*COARSE, *SWEPT]), help="to tune on")
    parser.add_argument("--steps", type=int, default=60, help="of Adam")
    parser.add_argument("--iterations", type=int, default=6, help="of the flow")
    arguments = parser.parse_args()
    jax.config.update("jax_enable_x64", True)
    config, names = Config.smooth(arguments.iterations), arguments.shapes.split(",")
    shapes = {name: made(name) for name in names}
    options = {"of": "surface", "steps": arguments.steps, "config": config}
    try:
        import cma
    except ImportError:
        cma = None
    also = ["CMA-ES"] if cma else []
    columns = [
        "shape",
        "default weights",
        "random numbers",
        *also,
        "numbers",
        "fields",
        "tape and run",
        "Config()",
        "s",
    ]
    print(f"| {' | '.join(columns)} |\n{'| --- ' * len(columns)}|")
    for name, shape in shapes.items():
        begin = time.perf_counter()
        tuned = msf_jax.tune(shape.mesh, target(shape), **options)
        spent, last = time.perf_counter() - begin, tuned.trajectory[-1]
        value, num = on_tape(shape, config), TRIES + arguments.steps
        tried = [Weights(), by_chance(value, num), *([by_cma(cma, value, num)] if cma else [])]
        cells = [found(shape, each, config) for each in (*tried, tuned.trajectory[1].weights, last.weights)]
        cells += [f"{abs(last.found / last.expected - 1):.0e}", found(shape, Weights(), Config()), f"{spent:.0f}"]
        print(f"| {name} | {' | '.join(cells)} |", flush=True)


if __name__ == "__main__":
    main()
