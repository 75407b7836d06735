"""Blind holes drilled into shapes at their thick places: ends and junctions should stay as they were.

    python -m tests.benchmarks.drill [FOLDER ..] [--seed N] [--holes N] [--only NAME,..] [--jobs N] [--limit SECONDS]
        [--most VERTICES] [--count N] [--pictures FOLDER] [--output FILE]

Run from the project's root. Shapes are twelve of `ground_truth` and the closed meshes of the folders, in turn,
``--count`` in all. A hole is a quarter of the local clearance wide (its radius) and 0.7 of it deep, along the inward
normal: it ends before the axis, and has no volume to carry a branch. Clearance is that in the middle of the solid
behind the point. A shape is right (``ok``) with as many ends and junctions as before, and with each end within 0.05
diagonals of its own old one; ``moved`` is the largest such distance, in diagonals.
"""

import argparse
import fnmatch
import signal
import time
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import NamedTuple

import manifold3d
import numpy as np
import trimesh
from scipy.optimize import linear_sum_assignment

from tests.benchmarks.curves import line, opening, publish
from tests.benchmarks.machined import drawn, in_turn, stop

KNOWN = ("straight", "arc", "s_curve", "straight_round", "taper", "ring", "y", "tee", "tree", "star", "comb", "theta")
RADIUS, DEPTH = 0.25, 0.7  # of the local clearance
REACH = 0.05  # diagonals: an end this near to an old one is that one
THICK = 0.75  # quantile of the clearances behind the surface, from which on a place is thick
CENTRED = 0.8  # least clearance over half of the solid's depth behind the point: the axis is there
CLEAR = 2.5  # clearances: least distance of holes from each other, in the larger of the two
SAMPLES, TRIES = 3000, 200
SUFFIXES = (".off", ".obj", ".ply", ".stl")
COLUMNS = ["shape", "vertices", "holes", "ends", "junctions", "cycles", "moved", "length", "sound", "seconds", "ok"]
Solid = tuple[np.ndarray, np.ndarray]


class Found(NamedTuple):
    """Of a curve: vertices and edges, and what counts of it."""

    vertices: np.ndarray
    edges: np.ndarray
    ends: np.ndarray
    junctions: int
    cycles: int
    length: float
    is_sound: bool


def shape_of(name: str) -> Solid:
    """A shape of `tests.benchmarks.ground_truth`, or a file's."""
    from msf_jax.meshes import reading
    from tests.benchmarks import ground_truth

    if name in KNOWN:
        mesh = ground_truth.make(name).mesh
        return np.array(mesh.vertices), np.array(mesh.faces)
    return reading.read(Path(name))


def drilled(mesh: Solid, num: int, random: np.random.Generator) -> tuple[Solid, int]:
    """The mesh with up to ``num`` blind holes, and how many there are."""
    from msf_jax.solid.enclosure import Enclosure

    x, faces = mesh
    size = float(np.linalg.norm(np.ptp(x, axis=0)))
    shape, surface = Enclosure(x, faces), trimesh.Trimesh(x, faces, process=False)
    points, face = trimesh.sample.sample_surface(surface, SAMPLES, seed=random)[:2]
    inward = -surface.face_normals[face]
    depth = shape.ray_lengths(points + 1e-6 * size * inward, inward, np.full(len(points), size))
    middle = points + depth[:, None] / 2 * inward
    clearance = np.where(shape.contains(middle), shape.distances(middle), 0.0)
    is_good = (clearance >= np.quantile(clearance, THICK)) & (clearance >= CENTRED * depth / 2)
    body, made = _manifold(x, faces), []
    genus = body.genus()
    for k in random.permutation(np.flatnonzero(is_good))[:TRIES]:
        if len(made) == num:
            break
        if any(np.linalg.norm(points[k] - points[j]) < CLEAR * max(clearance[k], clearance[j]) for j in made):
            continue
        frame = np.array(trimesh.geometry.align_vectors([0, 0, 1], inward[k]))
        radius = float(clearance[k])
        # From above the surface, which may bulge around the point.
        tool = manifold3d.Manifold.cylinder((DEPTH + RADIUS) * radius, RADIUS * radius, RADIUS * radius, 24)
        tool = tool.translate((0.0, 0.0, -RADIUS * radius)).transform(
            np.hstack([frame[:3, :3], points[k][:, None]])  # to the point, down along the normal
        )
        cut = body - tool
        if cut.genus() == genus and len(cut.decompose()) == len(body.decompose()) and cut.volume() < body.volume():
            body = cut
            made.append(k)
    found = body.to_mesh64()
    return (found.vert_properties[:, :3], found.tri_verts.astype(np.int64)), len(made)


def _manifold(x: np.ndarray, faces: np.ndarray) -> manifold3d.Manifold:
    body = manifold3d.Manifold(manifold3d.Mesh64(np.array(x, dtype=np.float64), np.array(faces, dtype=np.uint64)))
    if body.status() != manifold3d.Error.NoError or body.is_empty():
        raise ValueError(f"no solid for a boolean: {body.status()}")
    return body


def curve_of(mesh: Solid) -> Found:
    import msf_jax

    curve = msf_jax.skeletonize(mesh)
    degree = np.bincount(curve.edges.ravel(), minlength=len(curve.vertices))
    counts = int((degree > 2).sum()), curve.report.cycles
    return Found(curve.vertices, curve.edges, curve.vertices[degree == 1], *counts, curve.length, curve.report.is_sound)


def row_of(name: str, seed: int, num: int, limit: float, pictures: Path | None) -> tuple[list[str], bool]:
    """The cells of a shape's row, and whether it is right."""
    start, short = time.perf_counter(), Path(name).name
    signal.signal(signal.SIGALRM, stop)
    signal.setitimer(signal.ITIMER_REAL, limit)
    try:
        mesh = shape_of(name)
        cut, holes = drilled(mesh, num, np.random.default_rng(seed))
        before, after = curve_of(mesh), curve_of(cut)
        signal.setitimer(signal.ITIMER_REAL, 0)
    except Exception as error:  # a row, not the end of the table
        text = f"{type(error).__name__}: {error}"[:120]
        return [short, *[""] * (len(COLUMNS) - 3), text, "NO"], False
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
    away = np.linalg.norm(before.ends[:, None] - after.ends, axis=2) / np.linalg.norm(np.ptp(mesh[0], axis=0))
    moved = float(away[linear_sum_assignment(away)].max(initial=0.0))
    counts = [[len(each.ends), each.junctions, each.cycles] for each in (before, after)]
    is_right = counts[0] == counts[1] and moved <= REACH and holes > 0
    cells = [short, f"{len(cut[0]):,}", str(holes), *(f"{a} -> {b}" for a, b in zip(*counts, strict=True))]
    cells += [f"{moved:.3f}", f"{after.length / before.length:.3f}", "yes" if after.is_sound else "no"]
    if pictures and not is_right:
        title = f"{short}: ends {cells[3]}, junctions {cells[4]}, moved {cells[6]}"
        drawn(cut, (after.vertices, after.edges), None, title, pictures, "drill", Path(name).stem)
    return [*cells, f"{time.perf_counter() - start:.1f}", "ok" if is_right else "NO"], is_right


def shapes(folders: list[Path], only: list[str], most: int, count: int) -> list[str]:
    """Names and paths of the first ``count`` shapes; of meshes those that can be drilled, without one that is there."""
    from msf_jax.meshes import checking

    chosen = [name for name in KNOWN if any(fnmatch.fnmatch(name, pattern) for pattern in only)]
    stems: set[str] = set()
    for path in (path for folder in folders for path in sorted(folder.iterdir())):
        wanted = path.suffix in SUFFIXES and any(fnmatch.fnmatch(path.stem, pattern) for pattern in only)
        if len(chosen) >= count or not wanted or path.stem in stems:
            continue
        try:
            x, faces = shape_of(str(path))
            is_good = len(x) <= most and trimesh.Trimesh(x, faces, process=False).is_watertight
            is_good = is_good and bool(_manifold(x, faces) and checking.prepare((x, faces)))
        except ValueError:
            continue
        if is_good:
            chosen.append(str(path.resolve()))
            stems.add(path.stem)
    return chosen[:count]


def report(wanted: argparse.Namespace) -> Iterator[str]:
    yield opening("Blind holes", [], []) + f"\nSeed {wanted.seed}.\n\n" + line(COLUMNS)
    yield line(["---"] * len(COLUMNS))
    chosen = shapes(wanted.folders, wanted.only, wanted.most, wanted.count)
    work = partial(row_of, seed=wanted.seed, num=wanted.holes, limit=wanted.limit, pictures=wanted.pictures)
    right = 0
    for cells, is_right in in_turn(work, chosen, wanted.jobs):
        right += is_right
        yield line(cells)
    yield f"\n{right} of {len(chosen)} shapes have the ends and junctions that they had without holes.\n"


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.drill", description=__doc__.splitlines()[0])
    parser.add_argument("folders", nargs="*", type=Path, help="of meshes")
    parser.add_argument("--seed", type=int, default=0, help="of the holes' places")
    parser.add_argument("--holes", type=int, default=3, help="in each shape, at most")
    parser.add_argument("--only", type=lambda text: text.split(","), default=["*"], help="names, with commas between")
    parser.add_argument("--jobs", type=int, default=1, help="processes at a time")
    parser.add_argument("--limit", type=float, default=120, help="seconds for one shape")
    parser.add_argument("--most", type=int, default=20_000, help="vertices of a mesh")
    parser.add_argument("--count", type=int, default=20, help="shapes")
    parser.add_argument("--pictures", type=Path, help="folder for a picture of each miss")
    parser.add_argument("--output", type=Path, help="file for the table")
    wanted = parser.parse_args()
    publish(report(wanted), wanted.output)


if __name__ == "__main__":
    main()
