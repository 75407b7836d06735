"""Is the curve the shape's, or the mesh's: the same solid in other triangles, with noise, and turned.

    python -m tests.benchmarks.stability [--only NAME,..] [--rotations N] [--methods NAME,..] [--meshes FOLDER]
        [--limit SECONDS] [--output FILE]

Run from the project's root. No true curve is needed: each shape's own, in the triangles that it came in, is compared
with that of every variant:
- split: every triangle in four, the same surface exactly. fewer: a third of the triangles (quadric decimation).
- noise: of 0.1 and 0.3 % of the diagonal at every vertex, along each axis.
- turned: at random, and the curve turned back.

Distances are means over both curves to the other, in median radii of the first: of balls inside the mesh, for peers,
too. A peer is CGAL, where it is installed; others by --methods, as in `tests.benchmarks.curves`.
"""

import argparse
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import trimesh
from scipy import spatial
from scipy.spatial.transform import Rotation

from tests.benchmarks import curves

RESEARCH = ("homer", "indorelax", "elephant", "cheburashka", "armadillo", "horse")
WILD = ("human-man", "sword", "skull-coarse", "fish")
KNOWN = ("hand", "comb", "tree", "sheet_and_limb")
KINDS = ("split", "fewer", "noise 0.1 %", "noise 0.3 %", "turned")
STEP = 0.002  # diagonals, between the points by which curves are compared
FEWER = 2 / 3  # of the triangles, that go
Solid = tuple[np.ndarray, np.ndarray]


class Variant(NamedTuple):
    """kind: of ``KINDS``. mesh: (vertices, faces). turn: from the shape's place to its own."""

    kind: str
    mesh: Solid
    turn: Rotation


class Found(NamedTuple):
    """Of a curve: its vertices and edges, in the shape's place, and how many leaves and junctions it has."""

    vertices: np.ndarray
    edges: np.ndarray
    tips: int
    junctions: int


def shapes(only: list[str] | None, folder: Path) -> Iterator[tuple[str, Solid]]:
    from msf_jax.meshes import reading
    from tests.benchmarks import ground_truth

    places = [*(folder / f"{name}.off" for name in RESEARCH)]
    places += [path for name in WILD for path in folder.parent.glob(f"wild/{name}.*")]
    for path in places:
        if path.exists() and (not only or path.stem in only):
            yield path.stem, reading.read(path)
    for name in KNOWN:
        if not only or name in only:
            mesh = ground_truth.make(name).mesh
            yield name, (np.array(mesh.vertices), np.array(mesh.faces))


def variants(mesh: Solid, rotations: int) -> Iterator[Variant]:
    x, faces = mesh
    random, still = np.random.default_rng(11), Rotation.identity()
    yield Variant("split", trimesh.remesh.subdivide(x, faces), still)
    if (few := fewer(mesh)) is not None:
        yield Variant("fewer", few, still)
    size = np.linalg.norm(np.ptp(x, axis=0))
    for percent in (0.1, 0.3):
        yield Variant(f"noise {percent} %", (x + random.normal(0, percent / 100 * size, x.shape), faces), still)
    for _ in range(rotations):
        turn = Rotation.random(rng=random)
        yield Variant("turned", (turn.apply(x), faces), turn)


def fewer(mesh: Solid) -> Solid | None:
    """A third of the triangles, if that leaves a closed manifold; None without pyvista."""
    try:
        import pyvista
    except ImportError:
        return None
    found = pyvista.PolyData.from_regular_faces(*mesh).decimate(FEWER)
    x, faces = np.array(found.points, dtype=float), found.regular_faces
    return (x, faces) if trimesh.Trimesh(x, faces, process=False).is_watertight else None


def curve_of(method: str, name: str, variant: Variant, limit: float) -> Found | None:
    """None where the method has failed, which standard error says."""
    import msf_jax

    x, faces = variant.mesh
    try:
        if method == curves.OURS:
            found = msf_jax.skeletonize((x, faces), repair=True)
            vertices, edges = found.vertices, found.edges
        else:
            result = curves.peer_result(method, curves.Case(name, x, faces), limit, None)
            vertices, edges = result["vertices"], result["edges"]
    except Exception as error:
        print(f"{name}, {variant.kind}, {method}: {type(error).__name__}: {error}", file=sys.stderr)
        return None
    degree = np.bincount(edges.ravel(), minlength=len(vertices))
    return Found(variant.turn.inv().apply(vertices), edges, int((degree == 1).sum()), int((degree > 2).sum()))


def apart(mesh: Solid, one: Found, other: Found) -> float:
    """Mean distance between two curves of the mesh, in median radii of the first."""
    from msf_jax import metrics
    from msf_jax.solid.enclosure import Enclosure

    size = np.linalg.norm(np.ptp(mesh[0], axis=0))
    points = [metrics.sample_curve(each.vertices, each.edges, STEP * size)[0] for each in (one, other)]
    shape = Enclosure(*mesh)
    inside = points[0][shape.contains(points[0])]
    radius = np.median(shape.distances(inside)) if len(inside) else np.nan
    means = (spatial.KDTree(a).query(b)[0].mean() for a, b in (points, points[::-1]))
    return float(np.mean([*means]) / radius)


def row_of(method: str, name: str, mesh: Solid, wanted: argparse.Namespace) -> dict[str, Any] | None:
    """The cells of a row, by column; None where the shape itself fails."""
    own = curve_of(method, name, Variant("as it is", mesh, Rotation.identity()), wanted.limit)
    if own is None:
        return None
    far: dict[str, list[float]] = {kind: [] for kind in KINDS}
    same = []
    for variant in variants(mesh, wanted.rotations):
        other = curve_of(method, name, variant, wanted.limit)
        if other is not None:
            far[variant.kind].append(apart(mesh, own, other))
        same.append(other is not None and (own.tips == other.tips, own.junctions == other.junctions))
    same = [pair or (False, False) for pair in same]
    return {"tips": own.tips, "far": far, "same": same}


def cells(found: dict[str, Any]) -> list[str]:
    tips, junctions = (sum(pair[k] for pair in found["same"]) for k in (0, 1))
    text = [str(found["tips"]), *(f"{count} of {len(found['same'])}" for count in (tips, junctions))]
    return text + [f"{np.mean(far):.2f}" if far else "-" for far in found["far"].values()]


def report(wanted: argparse.Namespace) -> Iterator[str]:
    methods = curves.installed(wanted.methods)
    yield curves.opening("The same shape, the same curve", wanted.methods, methods)
    yield "\n" + curves.line(["shape", "method", "tips", "same tips", "same junctions", *KINDS])
    yield curves.line(["---", "---", *["---:"] * (len(KINDS) + 3)])
    rows: dict[str, list[dict[str, Any]]] = {method: [] for method in methods}
    for name, mesh in shapes(wanted.only, wanted.meshes):
        for method in methods:
            found = row_of(method, name, mesh, wanted)
            if found:
                rows[method].append(found)
                yield curves.line([name, method, *cells(found)])
    for method, done in rows.items():
        same = np.array([pair for found in done for pair in found["same"]]).reshape(-1, 2)
        far = np.concatenate([np.zeros(0), *(each for found in done for each in found["far"].values())])
        if len(same):
            yield (
                f"\n{method}: of {len(same)} variants of {len(done)} shapes {same[:, 0].mean():.0%} have the same "
                f"tips, {same[:, 1].mean():.0%} the same junctions; distance {far.mean():.2f} radii in the mean, "
                f"{np.median(far):.2f} in the median, under 0.1 in {(far < 0.1).mean():.0%}.\n"
            )


def main() -> None:
    parser = curves.parser_for("stability", __doc__.splitlines()[0])
    parser.set_defaults(methods=[curves.OURS, "cgal"])
    parser.add_argument("--rotations", type=int, default=10)
    wanted = parser.parse_args()
    curves.configure_jax()
    curves.publish(report(wanted), wanted.output)


if __name__ == "__main__":
    main()
