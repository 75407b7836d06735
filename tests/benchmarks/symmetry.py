"""Left as right: is the curve of a symmetric solid symmetric, and that of the mirrored solid its mirror image?

    python -m tests.benchmarks.symmetry FILE .. [--detail X] [--forms FORM,..] [--jobs N] [--output FILE]

Run from the project's root. Each mesh is taken as made, with normal noise of 0.1 % of its diagonal (seed 0), turned at
random (seed 0), and mirrored, which reverses its faces. Its plane of symmetry goes through the middle of its surface,
across an axis or a principal direction: the one with the nearest mirror image.

- skew: mean distance of the surface from its mirror image; ground: of two samples of the surface alike.
- ends, junctions: how many, and how many of them are alone: without a mirror image within `REACH` of them.
- apart: mean and largest distance of the curve from its mirror image; of the mirrored form, from the mirrored curve.

Distances are in per cent of the diagonal.
"""

from functools import partial
from typing import Any

import numpy as np
import trimesh

from tests.benchmarks import frame

FORMS = "made", "noise", "turned", "mirrored"
REACH = 0.03  # diagonals
NOISE = 0.001  # diagonals
SPACING = 0.002  # diagonals between points of a curve
SAMPLES = 20_000  # of the surface
COLUMNS = ["skew", "ground", "ends", "ends alone", "junctions", "junctions alone", "apart", "most"]


def plane_of(mesh: trimesh.Trimesh) -> tuple[np.ndarray, np.ndarray, float, float]:
    """A point of the plane, its normal, and the mean distances of the surface from its mirror image and of its samples
    from each other."""
    points = trimesh.sample.sample_surface(mesh, SAMPLES, seed=1)[0]
    other = trimesh.sample.sample_surface(mesh, SAMPLES, seed=2)[0]
    middle = points.mean(axis=0)
    directions = [*np.eye(3), *np.linalg.eigh(np.cov(points.T))[1].T]
    away = [float(frame.away(mirrored(other, middle, each), points).mean()) for each in directions]
    best = int(np.argmin(away))
    return middle, directions[best], away[best], float(frame.away(other, points).mean())


def mirrored(points: np.ndarray, middle: np.ndarray, normal: np.ndarray) -> np.ndarray:
    return points - 2 * ((points - middle) @ normal)[:, None] * normal


def form_of(
    mesh: trimesh.Trimesh, form: str, middle: np.ndarray, normal: np.ndarray
) -> tuple[trimesh.Trimesh, np.ndarray]:
    """The mesh in a form, and the matrix (3, 3) that turns it back."""
    random, x, faces = np.random.default_rng(0), np.array(mesh.vertices, dtype=float), np.array(mesh.faces)
    turn = np.eye(3)
    if form == "noise":
        x = x + NOISE * frame.diagonal(x) * random.normal(size=x.shape)
    elif form == "turned":
        turn = np.linalg.qr(random.normal(size=(3, 3)))[0]
        turn *= np.linalg.det(turn)
        x = x @ turn
    elif form == "mirrored":
        x, faces = mirrored(x, middle, normal), faces[:, ::-1]
    return trimesh.Trimesh(x, faces, process=False), turn.T


def job_of(name: str, detail: float) -> frame.Job:
    """Of "FILE FORM"."""
    import msf_jax

    file, form = name.rsplit(" ", 1)
    mesh = trimesh.load_mesh(file)
    mesh.merge_vertices(merge_tex=True, merge_norm=True)  # else noise would open seams of textures
    middle, normal, *skews = plane_of(mesh)
    size, options = frame.diagonal(mesh.vertices), {"config": msf_jax.Config(detail=detail), "repair": True}
    own, back = form_of(mesh, form, middle, normal)

    def judge(skeleton: Any) -> tuple[dict[str, str], list[str]]:
        curve = (skeleton.vertices @ back, skeleton.edges)
        image, against = (mirrored(curve[0], middle, normal), curve[1]), curve
        if form == "mirrored":
            made = msf_jax.skeletonize(form_of(mesh, "made", middle, normal)[0], **options)
            against = made.vertices, made.edges
        cells = [f"{100 * skew / size:.2f}" for skew in skews]
        for nodes in (frame.ends, frame.junctions):
            num = len(nodes(image))
            cells += [str(num), str(num - frame.matched(nodes(image), nodes(against), REACH * size))]
        far = 100 * frame.away(*(frame.sampled(each, SPACING * size) for each in (image, against))) / size
        cells += [f"{far.mean():.2f}", f"{far.max():.2f}"]
        return dict(zip(COLUMNS, cells, strict=True)), [] if cells[3] == "0" else ["ends alone"]

    return frame.Job(own, judge, options)


def main() -> None:
    parser = frame.parser_for("symmetry", __doc__)
    parser.add_argument("files", nargs="+", help="meshes that are symmetric")
    parser.add_argument("--detail", type=float, default=0.5, help="see Config")
    parser.add_argument("--forms", type=frame.words, default=list(FORMS), help=",".join(FORMS))
    wanted = parser.parse_args()
    names = [f"{file} {form}" for file in wanted.files for form in wanted.forms]
    title = f"Left as right, detail {wanted.detail:g}"
    frame.publish(frame.report(title, COLUMNS, names, partial(job_of, detail=wanted.detail), wanted), wanted.output)


if __name__ == "__main__":
    main()
