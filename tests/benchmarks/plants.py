"""Plants of cones joined by booleans, whose axes are known: angles, windings and radii of the curve's branches.

    python -m tests.benchmarks.plants [--seeds N,..] [--sides N] [--finest LENGTH] [--output FILE]

Run from the project's root. A stem of radius 3.9 to 2 has 10 to 40 side branches by seed, 40 to 50 degrees from it, of
radius 1.2 to 1.7 at their bases, 0.55 of that at their ends. Each cone has ``--sides`` sides, and triangles from end
to end, unless ``--finest`` splits longer edges. A curve is right that has one branch for each axis and no other, all
angles within 5 degrees, windings (length over chord) under 1.05, and least radii within 20 % of the end's; else it
should not be called sound.
"""

import argparse
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import manifold3d
import numpy as np
import trimesh
from scipy import spatial
from scipy.spatial.transform import Rotation

from tests.benchmarks.curves import configure_jax, line, opening, publish

TAPER = 0.55  # of the radius at the base: that at the end
ANGLE, WINDING, RADIUS = 5.0, 1.05, 0.2  # degrees; length over chord; share
COLUMNS = ["seed", "axes", "vertices", "ends", "branches", "angle off", "winding", "least radius", "sound", "ok"]


class Plant(NamedTuple):
    """mesh: closed. base, tip: (n, 3) of the side branches. radius: (n,) at their ends. angle: (n,) to the stem."""

    mesh: trimesh.Trimesh
    base: np.ndarray
    tip: np.ndarray
    radius: np.ndarray
    angle: np.ndarray


def cone(start: np.ndarray, stop: np.ndarray, low: float, high: float, sides: int) -> manifold3d.Manifold:
    axis = stop - start
    turn = Rotation.align_vectors(axis[None], [[0, 0, 1]])[0].as_matrix()
    solid = manifold3d.Manifold.cylinder(float(np.linalg.norm(axis)), low, high, sides)
    return solid.transform(np.column_stack([turn, start]))


def plant(seed: int, num: int, sides: int = 16) -> Plant:
    """A plant with ``num`` side branches."""
    random, top = np.random.default_rng(seed), np.array([0.0, 0.0, 12 * num + 30])
    place = np.arange(num)
    height = 15 + 12 * place + random.uniform(-2, 2, num)
    angle, around = random.uniform(40, 50, num), 2.399 * place + random.uniform(-0.2, 0.2, num)
    sine, cosine = np.sin(np.radians(angle)), np.cos(np.radians(angle))
    heading = np.stack([sine * np.cos(around), sine * np.sin(around), cosine], axis=1)
    base = height[:, None] * [0.0, 0.0, 1.0]
    tip = base + random.uniform(25, 40, num)[:, None] * heading
    low = random.uniform(1.2, 1.7, num)
    parts = [cone(np.zeros(3), top, 3.9, 2.0, sides)]
    parts += [cone(b, t, r, TAPER * r, sides) for b, t, r in zip(base, tip, low, strict=True)]
    solid = manifold3d.Manifold.batch_boolean(parts, manifold3d.OpType.Add).to_mesh()
    mesh = trimesh.Trimesh(np.array(solid.vert_properties[:, :3], dtype=float), solid.tri_verts, process=False)
    return Plant(mesh, base, tip, TAPER * low, angle)


def row_of(seed: int, sides: int, finest: float | None) -> list[str]:
    import msf_jax

    num = int(np.random.default_rng(seed).integers(10, 41))
    made = plant(seed, num, sides)
    mesh = made.mesh
    if finest is not None:
        split = trimesh.remesh.subdivide_to_size(mesh.vertices, mesh.faces, finest, max_iter=20)
        mesh = trimesh.Trimesh(split[0], split[1])
    skeleton = msf_jax.skeletonize(mesh)
    angle, winding, radius = measured(skeleton, made)
    ends = skeleton.num_leaves
    is_right = ends == num + 2 and bool((angle <= ANGLE).all() and (winding < WINDING).all())
    is_right &= bool((np.abs(radius - 1) <= RADIUS).all()) and len(angle) == num
    cells = [str(seed), str(num), f"{len(mesh.vertices):,}", f"{ends}/{num + 2}", f"{len(angle)}/{num}"]
    cells += [f"{angle.max(initial=0):.1f}", f"{winding.max(initial=1):.3f}", f"{radius.min(initial=1):.2f}"]
    is_sound = skeleton.report.is_sound
    return [*cells, "yes" if is_sound else "no", "ok" if is_right else "NO" if is_sound else "doubted"]


def measured(skeleton: Any, made: Plant) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Of the axes that have a branch, how many degrees it is off, its length over its chord, and its least radius over
    that of the axis."""
    table = skeleton.columns("branches")
    leaf = skeleton.vertices[table["end"]]
    away, branch = spatial.KDTree(leaf).query(made.tip)
    has = away < 4 * made.radius
    off = np.abs(np.asarray(table["angle"])[branch] - made.angle)
    least = np.asarray(table["least_radius"])[branch] / made.radius
    return off[has], np.asarray(table["tortuosity"])[branch][has], least[has]


def report(wanted: argparse.Namespace) -> Iterator[str]:
    configure_jax()
    yield opening("Plants of cones", [], []) + "\n"
    yield line(COLUMNS) + line(["---"] * len(COLUMNS))
    rows = []
    for seed in wanted.seeds:
        rows.append(row_of(seed, wanted.sides, wanted.finest))
        yield line(rows[-1])
    right = sum(row[-1] == "ok" for row in rows)
    wrong = sum(row[-1] == "NO" for row in rows)
    yield f"\n{right} of {len(rows)} are right; of the others {wrong} are called sound.\n"


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.plants", description="Plants of cones.")
    numbers = {"type": lambda text: [int(each) for each in text.split(",")], "help": "of plants, with commas between"}
    parser.add_argument("--seeds", default=list(range(5)), **numbers)
    parser.add_argument("--sides", type=int, default=16, help="of each cone")
    parser.add_argument("--finest", type=float, help="longer edges are split")
    parser.add_argument("--output", type=Path, help="file for the table")
    wanted = parser.parse_args()
    publish(report(wanted), wanted.output)


if __name__ == "__main__":
    main()
