"""Is `tune` better than what people would use instead, at an equal number of runs?

    python -m tests.benchmarks.tuning [--fields] [--shapes SHAPE,..] [--steps N] [--starts N]

A table in Markdown. Without ``--fields``: the median and the worst over poor starts of the objective of the finished
curve, by `tune`, and by as many points of a grid and random weights, which know the start and the defaults, too. With
``--fields``: the mean distance between the contracted surface and the true curve, then that of the finished curve, in
thousandths of the diagonal, with the default weights, random numbers, and the numbers and fields of `tune`.
"""

import argparse
import itertools
from collections.abc import Callable, Iterable
from dataclasses import replace

import jax
import numpy as np

import msf_jax
from msf_jax import Config, Weights, metrics, objectives
from msf_jax.gradients.replay import replay_meso
from msf_jax.tuning.tuner import FIELD_BOUNDS, MOST_PAIRS
from tests.benchmarks import frame, ground_truth
from tests.benchmarks.ground_truth import KnownShape

OBJECTIVE = objectives.explained() + 0.02 * objectives.centred() + objectives.inside()
STARTS = [(1, 0.01, 0.01, 10), (1, 100, 100, 0.1), (1, 1, 0.01, 0.1)]  # times the defaults; only ratios matter
SHAPES = "arc_coarse,y_coarse,s_curve,wavy_radius,octopus_low,tree_coarse"
REACH = np.log(10.0)  # of a grid and of random weights, to either side of the defaults, in logarithms
SPACING = 0.005  # diagonals: between points of the true curve
LINE = np.linspace(0, 1, 401)
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
    return replace(ground_truth.swept(line, radius, 8, ends), name=name)


def times_defaults(factors: Iterable[float]) -> Weights:
    return Weights(*(value * factor for value, factor in zip(vars(Weights()).values(), factors, strict=True)))


def row_of_numbers(shape: KnownShape, steps: int, starts: int) -> list[str]:
    def value_at(weights: Weights) -> float:
        skeleton = msf_jax.skeletonize(shape.mesh, weights)
        return objectives.of_skeleton(OBJECTIVE, skeleton, shape.mesh) if skeleton.report.converged else np.inf

    def best_of(points: Iterable[np.ndarray]) -> float:
        return min(usual, *(value_at(times_defaults([1.0, *np.exp(point)])) for point in points))

    usual = value_at(Weights())
    grid = [*itertools.product(np.linspace(-REACH, REACH, 3), repeat=3)]
    found: dict[str, list[float]] = {"tune": [], "grid": [], "random": []}
    for seed, factors in enumerate(STARTS[:starts]):
        random = np.random.default_rng(seed)
        found["tune"].append(msf_jax.tune(shape.mesh, OBJECTIVE, times_defaults(factors), steps=steps).value)
        found["grid"].append(best_of(random.permutation(grid)[: steps - 1]))
        found["random"].append(best_of(random.uniform(-REACH, REACH, (steps - 1, 3))))
    return [f"{usual:.5f}", *(f"{np.median(values):.5f}, {max(values):.5f}" for values in found.values())]


def row_of_fields(shape: KnownShape, steps: int) -> list[str]:
    config = Config.smooth()
    objective = objectives.near(metrics.sample_curve(shape.points, shape.edges, SPACING * shape.mesh.scale)[0])
    tuned = msf_jax.tune(shape.mesh, objective, of="surface", steps=steps)
    tape = msf_jax.contract(shape.mesh, config=config).tape

    def numbers_at(pair: np.ndarray) -> Weights:
        return Weights(w_H=float(pair[0]), w_M=float(pair[1]))

    value: Callable = jax.jit(lambda tape, weights: objectives.of_surface(objective, tape, replay_meso(tape, weights)))
    pairs = np.exp(np.random.default_rng(0).uniform(*np.log(FIELD_BOUNDS), size=(MOST_PAIRS + steps, 2)))
    values = [float(value(tape, numbers_at(pair))) for pair in pairs]

    def shown(weights: Weights, config: Config) -> str:
        run = msf_jax.contract(shape.mesh, weights, config)
        surface = float(objectives.of_surface(objective, run.tape, run.meso_skeleton[0]))
        return f"{1e3 * surface:.2f}, {1e3 * objectives.of_skeleton(objective, run.skeleton, shape.mesh):.2f}"

    _, numbers, last = tuned.trajectory
    tried = [Weights(), numbers_at(pairs[np.nanargmin(values)]), numbers.weights, last.weights]
    off = abs(last.found / last.expected - 1)
    return [*(shown(weights, config) for weights in tried), f"{off:.0e}", shown(Weights(), Config())]


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--fields", action="store_true", help="weights per vertex")
    parser.add_argument("--shapes", default="", help="which")
    parser.add_argument("--steps", type=int, default=0, help="runs of tune (24), or steps of Adam (60)")
    parser.add_argument("--starts", type=int, default=3, help="how many of three")
    options = parser.parse_args()
    jax.config.update("jax_enable_x64", True)
    columns = ["default weights", "tune", "grid", "random"]
    if options.fields:
        columns = ["default weights", "random numbers", "numbers", "fields", "tape and run", "Config()"]
    print(frame.head(["shape", *columns]), end="")
    coarse = ",".join(["straight_coarse", "arc_coarse", "helix_coarse", "y_coarse", *SWEPT])
    for name in (options.shapes or (coarse if options.fields else SHAPES)).split(","):
        shape = made(name)
        if options.fields:
            cells = row_of_fields(shape, options.steps or 60)
        else:
            cells = row_of_numbers(shape, options.steps or 24, options.starts)
        print(frame.line([name, *cells]), end="", flush=True)


if __name__ == "__main__":
    main()
