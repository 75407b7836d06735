"""Does tuning recover from poor weights, and do weights tuned on some shapes serve others?

    python -m tests.benchmarks.tuning [--starts SHAPE,..] [--train SHAPE,..] [--test SHAPE,..] [--steps N]

Two tables, in Markdown. First, for each of ``--starts``: the objective with poor weights, after tuning from them, and
with the defaults. Then weights tuned jointly on ``--train``, from the defaults, are tried on ``--test``. The shapes are
those of `msf_jax.ground_truth`, or of a file; every objective is of a fresh run.
"""

import argparse
import time
from pathlib import Path
from typing import Any

import jax

import msf_jax
from msf_jax import Weights, ground_truth, objectives

OBJECTIVE = objectives.explained() + 0.02 * objectives.centred() + objectives.inside()
STARTS = {
    "all x 10": (10, 10, 10, 10),
    "all / 10": (0.1, 0.1, 0.1, 0.1),
    "w_L, smoothing x 10; w_H, w_M / 10": (10, 0.1, 0.1, 10),
    "w_L, smoothing / 10; w_H, w_M x 10": (0.1, 10, 10, 0.1),
}


def shape(name: str) -> Any:
    """A mesh by name, or the path of one."""
    return name if Path(name).suffix else ground_truth.make(name).mesh


def found(mesh: Any, weights: Weights) -> float:
    """The objective of a fresh run."""
    run = msf_jax.contract(mesh, weights)
    return float(objectives.value_at(OBJECTIVE, run.tape, run.curve.vertices))


def shown(weights: Weights) -> str:
    """The four numbers."""
    return ", ".join(f"{float(weight):.3g}" for weight in vars(weights).values())


def recoveries(names: list[str], steps: int) -> None:
    """Print the first table."""
    print("| shape | start | objective there | tuned | defaults | no worse | runs | s | weights found |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- | --- |")
    for name in names:
        mesh = shape(name)
        best = found(mesh, Weights())
        for start, factors in STARTS.items():
            poor = Weights(*(f * w for f, w in zip(factors, vars(Weights()).values(), strict=True)))
            begin = time.perf_counter()
            tuned = msf_jax.tune(mesh, OBJECTIVE, poor, steps=steps)
            spent = time.perf_counter() - begin
            print(
                f"| {Path(name).stem} | {start} | {tuned.trajectory[0].found:.4f} | {tuned.value:.4f} | {best:.4f} | "
                f"{tuned.value <= best} | {len(tuned.trajectory)} | {spent:.0f} | {shown(tuned.weights)} |",
                flush=True,
            )


def generalisation(train: list[str], test: list[str], steps: int) -> None:
    """Print the second table."""
    begin = time.perf_counter()
    tuned = msf_jax.tune([shape(name) for name in train], OBJECTIVE, steps=steps)
    spent = time.perf_counter() - begin
    print(f"\n{tuned}\ntuned on {', '.join(train)} in {spent:.0f} s, {tuned.reason}: {shown(tuned.weights)}\n")
    print("| shape | | defaults | tuned |\n| --- | --- | --- | --- |")
    for part, names in (("tuned on", train), ("not seen", test)):
        pairs = [(found(shape(name), Weights()), found(shape(name), tuned.weights)) for name in names]
        for name, (before, after) in zip(names, pairs, strict=True):
            print(f"| {Path(name).stem} | {part} | {before:.4f} | {after:.4f} |")
        before, after = (sum(column) / len(pairs) for column in zip(*pairs, strict=True))
        print(f"| mean | {part} | {before:.4f} | {after:.4f} |", flush=True)


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--starts", default="y,tree_coarse,wavy_radius", help="shapes of the first table; '' for none")
    parser.add_argument("--train", default="y_coarse,arc,octopus_low,straight_round", help="shapes to tune on")
    parser.add_argument("--test", default="tree_coarse,s_curve,pawn_low,taper", help="shapes to try that on")
    parser.add_argument("--steps", type=int, default=12, help="fresh runs of each")
    arguments = parser.parse_args()
    jax.config.update("jax_enable_x64", True)
    names = [[name for name in text.split(",") if name] for text in (arguments.starts, arguments.train, arguments.test)]
    if names[0]:
        recoveries(names[0], arguments.steps)
    if names[1]:
        generalisation(names[1], names[2], arguments.steps)


if __name__ == "__main__":
    main()
