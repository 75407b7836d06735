"""Solids that nobody has looked at: random ones, mutated, and how long the slowest takes beside others of its size.

    python -m tests.benchmarks.mutants [--solids N] [--first SEED]

Each solid is a few primitives, added to and taken from one another. It is mutated one to three times: squashed, bent,
made noisy, cut by a plane, punched, coarse, refined on one side, or beside a copy of itself that overlaps it. Prints a
table by size, then every solid that took more than ten times the median of its size, was refused, or whose curve has
other cycles than the solid has handles, or is not inside. Each is a line of JSON on standard error when it is done.
"""

import argparse
import itertools
import json
import sys
import time
from collections.abc import Callable
from typing import Any

import jax
import manifold3d
import numpy as np
import trimesh

import msf_jax

SLOWEST = 10.0  # times the median of its size
SIZES = (0, 300, 600, 1_200, 2_500, 5_000, 10_000, 100_000)  # vertices
Solid = tuple[np.ndarray, np.ndarray]


def primitive(random: np.random.Generator) -> manifold3d.Manifold:
    """A ball, a box, a cone, or a ring, anywhere near the origin."""
    kind, sides = random.integers(4), int(random.integers(8, 40))
    if kind == 0:
        found = manifold3d.Manifold.sphere(random.uniform(0.3, 0.8), 4 * (sides // 4))
    elif kind == 1:
        found = manifold3d.Manifold.cube(random.uniform(0.1, 1.5, 3).tolist(), True).refine(int(random.integers(1, 8)))
    elif kind == 2:
        low, high = random.uniform(0.05, 0.5, 2)
        found = manifold3d.Manifold.cylinder(random.uniform(0.5, 3), low, high, sides, True).refine(3)
    else:
        circle = manifold3d.CrossSection.circle(random.uniform(0.08, 0.25), sides // 2)
        found = circle.translate([random.uniform(0.5, 0.9), 0]).revolve(sides)
    turn = random.uniform(0, 360, 3).tolist()
    return found.rotate(turn).translate(random.normal(0, 0.45, 3).tolist())


def generated(random: np.random.Generator) -> manifold3d.Manifold:
    """The largest piece of what two to five primitives make."""
    solid = primitive(random)
    for _ in range(random.integers(1, 5)):
        other = primitive(random)
        solid = solid + other if random.random() < 0.75 else solid - other
    pieces = solid.decompose()
    return max(pieces, key=lambda piece: piece.volume()) if pieces else generated(random)


def arrays(solid: manifold3d.Manifold) -> Solid:
    found = solid.to_mesh()
    return np.array(found.vert_properties[:, :3], dtype=np.float64), np.array(found.tri_verts, dtype=np.int64)


def squashed(solid: Solid, random: np.random.Generator) -> Solid:
    return solid[0] * random.uniform(0.05, 1.0, 3), solid[1]


def bent(solid: Solid, random: np.random.Generator) -> Solid:
    x = solid[0] - solid[0].mean(axis=0)
    return x + random.uniform(0, 0.3) * np.sin(random.uniform(1, 3, 3) * x[:, [1, 2, 0]]), solid[1]


def noisy(solid: Solid, random: np.random.Generator) -> Solid:
    size = np.linalg.norm(np.ptp(solid[0], axis=0))
    return solid[0] + random.normal(0, 10 ** random.uniform(-5, -2.3) * size, solid[0].shape), solid[1]


def punched(solid: Solid, random: np.random.Generator) -> Solid:
    """Some of its faces gone."""
    return solid[0], solid[1][random.permutation(len(solid[1]))[random.integers(1, 6) :]]


def refined(solid: Solid, random: np.random.Generator) -> Solid:
    """Smaller faces on one side."""
    axis = random.normal(size=3)
    height = solid[0][solid[1]].mean(axis=1) @ axis
    found = trimesh.remesh.subdivide(*solid, np.flatnonzero(height > np.median(height)))
    mesh = trimesh.Trimesh(found[0], found[1], process=False)
    mesh.merge_vertices()
    return np.array(mesh.vertices), np.array(mesh.faces)


def doubled(solid: Solid, random: np.random.Generator) -> Solid:
    """With a copy of itself that overlaps it."""
    shift = random.uniform(0.1, 0.5) * np.ptp(solid[0], axis=0) * (np.arange(3) == random.integers(3))
    return np.concatenate([solid[0], solid[0] + shift]), np.concatenate([solid[1], solid[1] + len(solid[0])])


MUTATIONS: list[Callable[[Solid, np.random.Generator], Solid]] = [squashed, bent, noisy, punched, refined, doubled]


def mutant(seed: int) -> tuple[Solid, str]:
    """A solid, and what it is."""
    random = np.random.default_rng(seed)
    solid, names = arrays(generated(random)), []
    for number in random.integers(len(MUTATIONS), size=random.integers(1, 4)):
        solid = MUTATIONS[number](solid, random)
        names.append(MUTATIONS[number].__name__)
    return solid, " ".join(names)


def measured(seed: int) -> dict[str, Any]:
    """What came of one, warm."""
    solid, name = mutant(seed)
    row: dict[str, Any] = {"seed": seed, "name": name, "vertices": len(solid[0]), "wrong": ""}
    start = time.process_time()
    try:
        report = msf_jax.skeletonize(solid, repair="join").report
    except (msf_jax.MeshError, msf_jax.FlowError) as error:
        return row | {"cpu": time.process_time() - start, "wrong": f"refused: {error}"}
    spent = time.process_time() - start
    if report.seconds.get("compile", 0.0) > 0.05:
        start = time.process_time()
        msf_jax.skeletonize(solid, repair="join")
        spent = time.process_time() - start
    wrong = [] if report.converged else [report.reason]
    wrong += [f"cycles {report.cycles}/{report.genus}"] if report.cycles != report.genus else []
    wrong += [f"inside {report.inside:.4f}"] if report.inside < 0.99995 else []
    return row | {"cpu": spent, "wrong": ", ".join(wrong), "notes": list(report.notes)}


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--solids", type=int, default=500)
    parser.add_argument("--first", type=int, default=0)
    arguments = parser.parse_args()
    rows = []
    for seed in range(arguments.first, arguments.first + arguments.solids):
        rows.append(measured(seed))
        print(json.dumps(rows[-1]), file=sys.stderr, flush=True)
    print(
        "| vertices | solids | median CPU s | worst | over the median | wrong |\n| --- | --- | --- | --- | --- | --- |"
    )
    odd = [row for row in rows if row["wrong"]]
    for low, high in itertools.pairwise(SIZES):
        own = [row for row in rows if low <= row["vertices"] < high]
        if own:
            usual, worst = np.median([row["cpu"] for row in own]), max(row["cpu"] for row in own)
            num_wrong = sum(bool(row["wrong"]) for row in own)
            cells = [
                f"{low:,} to {high:,}",
                len(own),
                f"{usual:.2f}",
                f"{worst:.2f}",
                f"{worst / usual:.1f}",
                num_wrong,
            ]
            print(f"| {' | '.join(map(str, cells))} |")
            odd += [row for row in own if row["cpu"] > SLOWEST * usual and not row["wrong"]]
    for row in odd:
        print(f"\n{row['seed']}, {row['name']}, {row['vertices']} vertices, {row['cpu']:.1f} s: {row['wrong']}", end="")
        print("".join(f"\n    {note}" for note in row.get("notes", [])))


if __name__ == "__main__":
    jax.config.update("jax_enable_x64", True)
    main()
