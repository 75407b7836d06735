"""Is `tune` better than what people would use instead? At equal wall time, compiling included.

    python -m tests.benchmarks.tuning [--shapes SHAPE,..] [--starts N] [--steps N]

A table in Markdown: for each of ``--shapes``, the median and the worst over the starts of the objective of the finished
curve, as `tune` finds it in ``--steps`` fresh runs, and as a grid, random weights and CMA-ES (the ``cma`` package, if
it is installed) find it in the time that this took. All begin with the same start and know the defaults. The shapes are
those of `msf_jax.ground_truth`, or of a file.
"""

import argparse
import itertools
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import jax
import numpy as np

import msf_jax
from msf_jax import Config, Weights, ground_truth, objectives
from msf_jax.tuning.runs import Runs

OBJECTIVE = objectives.explained() + 0.02 * objectives.centred() + objectives.inside()
STARTS = [(10, 0.1, 0.1, 10), (0.1, 10, 10, 0.1), (10, 10, 0.1, 0.1)]  # times the defaults
SHAPES = "arc_coarse,y_coarse,s_curve,wavy_radius,octopus_low,tree_coarse"
REACH = np.log(10.0)  # of a grid and of random weights, to either side of the defaults, in logarithms


def weights_at(point: np.ndarray) -> Weights:
    """Weights by the logarithms of w_H, w_M and smoothing over their defaults; only ratios matter, so w_L is 1."""
    usual = Weights()
    return Weights(
        1.0, *(base * np.exp(one) for base, one in zip((usual.w_H, usual.w_M, usual.smoothing), point, strict=True))
    )


def point_of(factors: tuple[float, ...]) -> np.ndarray:
    """The logarithms of a start."""
    w_L, w_H, w_M, smoothing = np.log(factors)
    return np.array([w_H - w_L, w_M - w_L, smoothing])


def by_grid(start: np.ndarray, seed: int) -> Iterator[np.ndarray]:
    """Three, then five, ... values of each, in any order."""
    for count in (3, 5, 7, 9):
        points = list(itertools.product(np.linspace(-REACH, REACH, count), repeat=3))
        yield from np.random.default_rng(seed).permutation(points)


def by_chance(start: np.ndarray, seed: int) -> Iterator[np.ndarray]:
    """Even in the logarithms."""
    random = np.random.default_rng(seed)
    while True:
        yield random.uniform(-REACH, REACH, 3)


METHODS: dict[str, Callable[[np.ndarray, int], Iterator[np.ndarray]]] = {"grid": by_grid, "random": by_chance}


def found_by(points: Iterator[np.ndarray], runs: Runs, start: np.ndarray, seconds: float) -> float:
    """The best value of the points that there is time for."""
    end = time.perf_counter() + seconds
    best = min((one.value for one in runs.found([weights_at(start), Weights()]) if one.converges), default=np.inf)
    for point in points:
        if time.perf_counter() > end:
            break
        found = runs.found([weights_at(point)])[0]
        best = min(best, found.value if found.converges else np.inf)
    return best


def found_by_cma(cma: Any, runs: Runs, start: np.ndarray, seconds: float, seed: int) -> float:
    """The same by CMA-ES, with the spread that its authors advise: a third of the range."""
    end = time.perf_counter() + seconds
    best = min((one.value for one in runs.found([weights_at(start), Weights()]) if one.converges), default=np.inf)
    search = cma.CMAEvolutionStrategy(start, 2 * REACH / 3, {"verbose": -9, "seed": seed + 1})
    while time.perf_counter() < end:
        points, values = search.ask(), []
        for point in points:
            found = runs.found([weights_at(point)])[0]
            values.append(found.value if found.converges else 10.0)
            if time.perf_counter() > end:
                break
        best = min(best, *values)
        if len(values) < len(points):
            break
        search.tell(points, values)
    return best


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument(
        "--shapes", default="arc_coarse,y_coarse,s_curve,wavy_radius,octopus_low,tree_coarse", help="which"
    )
    parser.add_argument("--starts", type=int, default=3, help="how many of three")
    parser.add_argument("--steps", type=int, default=24, help="fresh runs of tune, which say how much time there is")
    arguments = parser.parse_args()
    jax.config.update("jax_enable_x64", True)
    try:
        import cma
    except ImportError:
        cma = None
    names = ["tune", *METHODS, *(["CMA-ES"] if cma else [])]
    print(f"| shape | defaults | {' | '.join(names)} | s |\n| --- {'| --- ' * (len(names) + 2)}|")
    for name in arguments.shapes.split(","):
        mesh = name if Path(name).suffix else ground_truth.make(name).mesh

        def fresh(mesh: Any = mesh) -> Runs:
            return Runs([mesh], OBJECTIVE, Config(), "skeleton")

        usual = fresh().found([Weights()])[0].value  # and everything is compiled once
        best: dict[str, list[float]] = {method: [] for method in names}
        spent = []
        for seed, factors in enumerate(STARTS[: arguments.starts]):
            start = point_of(factors)
            begin = time.perf_counter()
            best["tune"].append(msf_jax.tune(mesh, OBJECTIVE, weights_at(start), steps=arguments.steps).value)
            spent.append(time.perf_counter() - begin)
            for method, points in METHODS.items():
                best[method].append(found_by(points(start, seed), fresh(), start, spent[-1]))
            if cma:
                best["CMA-ES"].append(found_by_cma(cma, fresh(), start, spent[-1], seed))
        row = " | ".join(f"{np.median(best[method]):.5f}, {max(best[method]):.5f}" for method in names)
        print(f"| {name} | {usual:.5f} | {row} | {np.mean(spent):.0f} |", flush=True)


if __name__ == "__main__":
    main()
