"""Blind holes drilled into shapes at their thick places: ends and junctions should stay as they were.

    python -m tests.benchmarks.drill [FILE ..] [--seed N] [--holes N] [--only NAME,..] [--jobs N] [--limit SECONDS]
        [--pictures FOLDER] [--output FILE]

Run from the project's root. Shapes are twelve of `ground_truth` and the files, closed meshes. A hole is a
quarter of the local clearance wide (its radius) and 0.7 of it deep, along the inward normal: it ends before the axis,
and has no volume to carry a branch. Clearance is that in the middle of the solid behind the point. A shape is right
(``ok``) with as many ends and junctions as before, and with each end within 0.05 diagonals of its own old one;
``moved`` is the largest such distance, in diagonals.
"""

from functools import partial
from pathlib import Path
from typing import Any

import manifold3d
import numpy as np
import trimesh
from scipy.optimize import linear_sum_assignment

from tests.benchmarks import frame
from tests.benchmarks.frame import Mesh

KNOWN = ("straight", "arc", "s_curve", "straight_round", "taper", "ring", "y", "tee", "tree", "star", "comb", "theta")
RADIUS, DEPTH = 0.25, 0.7  # of the local clearance
REACH = 0.05  # diagonals: an end this near to an old one is that one
THICK = 0.75  # quantile of the clearances behind the surface, from which on a place is thick
CENTRED = 0.8  # least clearance over half of the solid's depth behind the point: the axis is there
CLEAR = 2.5  # clearances: least distance of holes from each other, in the larger of the two
SAMPLES, TRIES = 3000, 200
COLUMNS = ["holes", "ends", "junctions", "cycles", "moved", "length"]


def mesh_of(name: str) -> Mesh:
    """A shape of `ground_truth`, or a file's."""
    from msf_jax.meshes import reading
    from tests.benchmarks import ground_truth

    if name not in KNOWN:
        return reading.read(Path(name))
    mesh = ground_truth.make(name).mesh
    return np.array(mesh.vertices), np.array(mesh.faces)


def solid_of(mesh: Mesh) -> manifold3d.Manifold:
    body = manifold3d.Manifold(manifold3d.Mesh64(mesh[0].astype(np.float64), mesh[1].astype(np.uint64)))
    if body.status() != manifold3d.Error.NoError or body.is_empty():
        raise ValueError(f"no solid for a boolean: {body.status()}")
    return body


def drilled(mesh: Mesh, num: int, random: np.random.Generator) -> tuple[Mesh, int]:
    """The mesh with up to ``num`` blind holes, and how many there are."""
    from msf_jax.solid.enclosure import Enclosure

    shape, surface = Enclosure(*mesh), trimesh.Trimesh(*mesh, process=False)
    points, face = trimesh.sample.sample_surface(surface, SAMPLES, seed=random)[:2]
    inward = -surface.face_normals[face]
    size = frame.diagonal(mesh[0])
    depth = shape.ray_lengths(points + 1e-6 * size * inward, inward, np.full(len(points), size))
    middle = points + depth[:, None] / 2 * inward
    clearance = np.where(shape.contains(middle), shape.distances(middle), 0.0)
    is_good = (clearance >= np.quantile(clearance, THICK)) & (clearance >= CENTRED * depth / 2)
    body, made = solid_of(mesh), []
    genus = body.genus()
    for k in random.permutation(np.flatnonzero(is_good))[:TRIES]:
        if len(made) == num:
            break
        if any(np.linalg.norm(points[k] - points[j]) < CLEAR * max(clearance[k], clearance[j]) for j in made):
            continue
        turn = np.array(trimesh.geometry.align_vectors([0, 0, 1], inward[k]))[:3, :3]
        radius = float(clearance[k])
        # From above the surface, which may bulge around the point, and down along the normal.
        tool = manifold3d.Manifold.cylinder((DEPTH + RADIUS) * radius, RADIUS * radius, RADIUS * radius, 24)
        tool = tool.translate((0.0, 0.0, -RADIUS * radius)).transform(np.hstack([turn, points[k][:, None]]))
        cut = body - tool
        if cut.genus() == genus and len(cut.decompose()) == len(body.decompose()) and cut.volume() < body.volume():
            body = cut
            made.append(k)
    found = body.to_mesh64()
    return (found.vert_properties[:, :3], found.tri_verts.astype(np.int64)), len(made)


def job_of(name: str, seed: int, num: int) -> frame.Job:
    import msf_jax

    mesh = mesh_of(name)
    cut, holes = drilled(mesh, num, np.random.default_rng(seed))
    before = msf_jax.skeletonize(mesh)

    def judge(after: Any) -> tuple[dict[str, str], list[str]]:
        one, other = ((each.vertices, each.edges) for each in (before, after))
        far = np.linalg.norm(frame.ends(one)[:, None] - frame.ends(other), axis=2) / frame.diagonal(mesh[0])
        moved = float(far[linear_sum_assignment(far)].max(initial=0.0))
        cells, wrong = (
            {"holes": str(holes), "moved": f"{moved:.3f}", "length": f"{after.length / before.length:.3f}"},
            [],
        )
        counts = [(len(frame.ends(each)), len(frame.junctions(each))) for each in (one, other)]
        counts = [(*own, each.report.cycles) for own, each in zip(counts, (before, after), strict=True)]
        for column, a, b in zip(COLUMNS[1:4], *counts, strict=True):
            cells[column] = f"{a} -> {b}"
            wrong += [f"{column} {a} -> {b}"] if a != b else []
        return cells, wrong + (["moved"] if moved > REACH else []) + (["no hole"] if not holes else [])

    return frame.Job(cut, judge, shown=cut)


def main() -> None:
    parser = frame.parser_for("drill", __doc__)
    parser.add_argument("files", nargs="*", help="closed meshes")
    parser.add_argument("--seed", type=int, default=0, help="of the holes' places")
    parser.add_argument("--holes", type=int, default=3, help="in each shape, at most")
    wanted = parser.parse_args()
    names = [*KNOWN, *wanted.files]
    make = partial(job_of, seed=wanted.seed, num=wanted.holes)
    frame.publish(frame.report(f"Blind holes, seed {wanted.seed}", COLUMNS, names, make, wanted), wanted.output)


if __name__ == "__main__":
    main()
