"""Plants of cones joined by booleans, whose axes are known: angles, windings and radii of the curve's branches.

    python -m tests.benchmarks.plants [--seeds N,..] [--sides N] [--finest LENGTH] [--output FILE]

Run from the project's root. A stem of radius 3.9 to 2 has 10 to 40 side branches by seed, 40 to 50 degrees from it, of
radius 1.2 to 1.7 at their bases, 0.55 of that at their ends. Each cone has ``--sides`` sides, and triangles from end
to end, unless ``--finest`` splits longer edges. A curve is right that has one branch for each axis and no other, all
angles within 5 degrees, windings (length over chord) under 1.05, and least radii within 20 % of the end's; else it
should not be called sound.
"""

from functools import partial
from typing import Any, NamedTuple

import manifold3d
import numpy as np
import trimesh
from scipy import spatial
from scipy.spatial.transform import Rotation

from tests.benchmarks import frame

TAPER = 0.55  # of the radius at the base: that at the end
ANGLE, WINDING, RADIUS = 5.0, 1.05, 0.2  # degrees; length over chord; share
COLUMNS = ["ends", "branches", "angle off", "winding", "least radius"]


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


def job_of(seed: str, sides: int, finest: float | None) -> frame.Job:
    num = int(np.random.default_rng(int(seed)).integers(10, 41))
    made = plant(int(seed), num, sides)
    mesh = (np.array(made.mesh.vertices), np.array(made.mesh.faces))
    if finest is not None:
        mesh = trimesh.remesh.subdivide_to_size(*mesh, finest, max_iter=20)[:2]
    return frame.Job(mesh, partial(judged, made=made), shown=mesh, places=made.tip)


def judged(skeleton: Any, made: Plant) -> tuple[dict[str, str], list[str]]:
    """Of the axes that have a branch: how many degrees it is off, its length over its chord, and its least radius over
    that of the axis."""
    table, num = skeleton.columns("branches"), len(made.tip)
    away, branch = spatial.KDTree(skeleton.vertices[table["end"]]).query(made.tip)
    branch, has = branch[away < 4 * made.radius], away < 4 * made.radius
    off = np.abs(np.asarray(table["angle"])[branch] - made.angle[has])
    winding = np.asarray(table["tortuosity"])[branch]
    radius = np.asarray(table["least_radius"])[branch] / made.radius[has]
    cells = [f"{skeleton.num_leaves}/{num + 2}", f"{has.sum()}/{num}", f"{off.max(initial=0):.1f}"]
    cells += [f"{winding.max(initial=1):.3f}", f"{radius.min(initial=1):.2f}"]
    is_right = [skeleton.num_leaves == num + 2, has.all(), (off <= ANGLE).all(), (winding < WINDING).all()]
    is_right.append((np.abs(radius - 1) <= RADIUS).all())
    return dict(zip(COLUMNS, cells, strict=True)), [c for c, right in zip(COLUMNS, is_right, strict=True) if not right]


def main() -> None:
    parser = frame.parser_for("plants", __doc__, limit=600)
    parser.add_argument("--seeds", type=frame.words, default=list("01234"), help="of plants, with commas between")
    parser.add_argument("--sides", type=int, default=16, help="of each cone")
    parser.add_argument("--finest", type=float, help="longer edges are split")
    wanted = parser.parse_args()
    make = partial(job_of, sides=wanted.sides, finest=wanted.finest)
    frame.publish(frame.report("Plants of cones", COLUMNS, wanted.seeds, make, wanted), wanted.output)


if __name__ == "__main__":
    main()
