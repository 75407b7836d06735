"""Left as right: is the curve of a symmetric solid symmetric, and that of the mirrored solid its mirror image?

    python -m tests.benchmarks.symmetry FILE .. [--detail X] [--forms FORM,..] [--output FILE]

Run from the project's root. Each mesh is taken as made, with normal noise of 0.1 % of its diagonal (seed 0), turned at
random (seed 0), and mirrored, which reverses its faces. Its plane of symmetry goes through the middle of its surface,
across an axis or a principal direction: the one with the nearest mirror image.

- skew: mean distance of the surface from its mirror image; ground: of two samples of the surface alike.
- ends, junctions: how many, and how many of them are alone: without a mirror image within `REACH` of them.
- apart: mean and largest distance of the curve from its mirror image; of the mirrored form, from the mirrored curve.

Distances are in per cent of the diagonal.
"""

import argparse
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import trimesh
from scipy import spatial
from scipy.optimize import linear_sum_assignment

from tests.benchmarks.answers import SPACING
from tests.benchmarks.curves import Graph, configure_jax, line, opening, publish

FORMS = "made", "noise", "turned", "mirrored"
REACH = 0.03  # diagonals
NOISE = 0.001  # diagonals
SAMPLES = 20_000  # of the surface
COLUMNS = ["shape", "form", "skew", "ground", "ends", "alone", "junctions", "alone", "apart", "most", "sound"]


def plane_of(mesh: trimesh.Trimesh) -> tuple[np.ndarray, np.ndarray, float, float]:
    """A point of the plane, its normal, and the mean distances of the surface from its mirror image and of its samples
    from each other."""
    points = trimesh.sample.sample_surface(mesh, SAMPLES, seed=1)[0]
    other = trimesh.sample.sample_surface(mesh, SAMPLES, seed=2)[0]
    middle = points.mean(axis=0)
    tree = spatial.KDTree(points)
    directions = [*np.eye(3), *np.linalg.eigh(np.cov(points.T))[1].T]
    away = [float(tree.query(mirrored(other, middle, each))[0].mean()) for each in directions]
    best = int(np.argmin(away))
    return middle, directions[best], away[best], float(tree.query(other)[0].mean())


def mirrored(points: np.ndarray, middle: np.ndarray, normal: np.ndarray) -> np.ndarray:
    return points - 2 * ((points - middle) @ normal)[:, None] * normal


def form_of(
    mesh: trimesh.Trimesh, form: str, middle: np.ndarray, normal: np.ndarray
) -> tuple[trimesh.Trimesh, np.ndarray]:
    """The mesh in a form, and the matrix (3, 3) that turns it back."""
    random, x, faces = np.random.default_rng(0), np.array(mesh.vertices, dtype=float), np.array(mesh.faces)
    turn = np.eye(3)
    if form == "noise":
        x = x + NOISE * np.linalg.norm(np.ptp(x, axis=0)) * random.normal(size=x.shape)
    elif form == "turned":
        turn = np.linalg.qr(random.normal(size=(3, 3)))[0]
        turn *= np.linalg.det(turn)
        x = x @ turn
    elif form == "mirrored":
        x, faces = mirrored(x, middle, normal), faces[:, ::-1]
    return trimesh.Trimesh(x, faces, process=False), turn.T


def alone(nodes: np.ndarray, images: np.ndarray, reach: float) -> int:
    """How many of ``nodes`` (n, 3) have none of ``images`` (m, 3) within ``reach``, each used once."""
    away = np.linalg.norm(nodes[:, None] - images[None], axis=2)
    rows, columns = linear_sum_assignment(np.where(away < reach, away, 1e9))
    return len(nodes) - int((away[rows, columns] < reach).sum())


def apart(one: Graph, other: Graph, diagonal: float) -> tuple[float, float]:
    """Mean and largest distance of a curve from another one, in per cent."""
    from msf_jax import metrics

    ours, theirs = (metrics.sample_curve(*curve, SPACING * diagonal)[0] for curve in (one, other))
    away = spatial.KDTree(theirs).query(ours)[0]
    return 100 * float(away.mean()) / diagonal, 100 * float(away.max()) / diagonal


def rows_of(file: Path, forms: list[str], detail: float) -> Iterator[list[str]]:
    import msf_jax

    mesh = trimesh.load_mesh(file)
    mesh.merge_vertices(merge_tex=True, merge_norm=True)  # else noise would open seams of textures
    middle, normal, skew, ground = plane_of(mesh)
    diagonal, made = float(np.linalg.norm(np.ptp(mesh.vertices, axis=0))), None
    for form in forms:
        own, back = form_of(mesh, form, middle, normal)
        skeleton = msf_jax.skeletonize(own, config=msf_jax.Config(detail=detail), repair=True)
        x, edges = skeleton.vertices @ back, skeleton.edges
        image = mirrored(x, middle, normal)
        degree = np.bincount(edges.ravel(), minlength=len(x))
        made = (x, edges) if form == "made" else made
        against = made if form == "mirrored" and made is not None else (x, edges)
        theirs, counts = np.bincount(against[1].ravel(), minlength=len(against[0])), []
        for is_own, is_other in ((degree == 1, theirs == 1), (degree > 2, theirs > 2)):
            counts += [str(int(is_own.sum())), str(alone(image[is_own], against[0][is_other], REACH * diagonal))]
        far = apart((image, edges), against, diagonal)
        figures = [f"{100 * each / diagonal:.2f}" for each in (skew, ground)]
        yield [file.stem, form, *figures, *counts, *(f"{each:.2f}" for each in far), str(skeleton.report.is_sound)]


def report(wanted: argparse.Namespace) -> Iterator[str]:
    configure_jax()
    yield opening("Left as right", [], []) + f"\nDetail {wanted.detail:g}.\n\n"
    yield line(COLUMNS) + line(["---"] * len(COLUMNS))
    for file in wanted.files:
        for row in rows_of(file, wanted.forms, wanted.detail):
            yield line(row)


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.symmetry", description="Left as right.")
    parser.add_argument("files", type=Path, nargs="+", help="meshes that are symmetric")
    parser.add_argument("--detail", type=float, default=0.5, help="see Config")
    parser.add_argument("--forms", type=lambda text: text.split(","), default=list(FORMS), help=",".join(FORMS))
    parser.add_argument("--output", type=Path, help="file for the table")
    wanted = parser.parse_args()
    publish(report(wanted), wanted.output)


if __name__ == "__main__":
    main()
