"""Is the curve the shape's, or the mesh's: the same solid in other triangles, with noise, and turned.

    python -m tests.benchmarks.stability [--only NAME,..] [--rotations N] [--methods NAME,..] [--meshes FOLDER]
        [--limit SECONDS] [--output FILE] [--bars FOLDER]

Run from the project's root. No true curve is needed: each shape's own, in the triangles that it came in, is compared
with that of every variant:
- split: every triangle in four, the same surface exactly. fewer: a third of the triangles (quadric decimation).
- noise: of 0.1 and 0.3 % of the diagonal at every vertex, along each axis.
- turned: at random, and the curve turned back.

Distances are means over both curves to the other, in median radii of the first: of balls inside the mesh, for peers,
too. A peer is CGAL, where it is installed; others by --methods, as in `tests.benchmarks.curves`.

With --bars: how much a curve moves for no reason. Each shape's own is compared with that in float32, with those of
noise of 0.01 % of the diagonal, and with those that other environments have kept in FOLDER, where it is kept, too.
"""

import argparse
import platform
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import trimesh
from scipy.spatial.transform import Rotation

from tests.benchmarks import curves, frame
from tests.benchmarks.frame import Curve, Mesh

RESEARCH = ("homer", "indorelax", "elephant", "cheburashka", "armadillo", "horse")
WILD = ("human-man", "sword", "skull-coarse", "fish")
KNOWN = ("hand", "comb", "tree", "sheet_and_limb")
KINDS = ("split", "fewer", "noise 0.1 %", "noise 0.3 %", "turned")
STEP = 0.002  # diagonals, between the points by which curves are compared
FEWER = 2 / 3  # of the triangles, that go


class Variant(NamedTuple):
    """kind: of ``KINDS``. mesh: (vertices, faces). turn: from the shape's place to its own."""

    kind: str
    mesh: Mesh
    turn: Rotation


def shapes(wanted: argparse.Namespace) -> Iterator[tuple[str, Mesh]]:
    from msf_jax.meshes import reading
    from tests.benchmarks import ground_truth

    places = [*(wanted.meshes / f"{name}.off" for name in RESEARCH)]
    places += [path for name in WILD for path in wanted.meshes.parent.glob(f"wild/{name}.*")]
    for path in places:
        if path.exists() and (wanted.only == ["*"] or path.stem in wanted.only):
            yield path.stem, reading.read(path)
    for name in KNOWN:
        if wanted.only == ["*"] or name in wanted.only:
            mesh = ground_truth.make(name).mesh
            yield name, (np.array(mesh.vertices), np.array(mesh.faces))


def variants(mesh: Mesh, rotations: int) -> Iterator[Variant]:
    x, faces = mesh
    random, still = np.random.default_rng(11), Rotation.identity()
    yield Variant("split", trimesh.remesh.subdivide(x, faces), still)
    if (few := fewer(mesh)) is not None:
        yield Variant("fewer", few, still)
    size = frame.diagonal(x)
    for percent in (0.1, 0.3):
        yield Variant(f"noise {percent} %", (x + random.normal(0, percent / 100 * size, x.shape), faces), still)
    for _ in range(rotations):
        turn = Rotation.random(rng=random)
        yield Variant("turned", (turn.apply(x), faces), turn)


def fewer(mesh: Mesh) -> Mesh | None:
    """A third of the triangles, if that leaves a closed manifold; None without pyvista."""
    try:
        import pyvista
    except ImportError:
        return None
    found = pyvista.PolyData.from_regular_faces(*mesh).decimate(FEWER)
    x, faces = np.array(found.points, dtype=float), found.regular_faces
    return (x, faces) if trimesh.Trimesh(x, faces, process=False).is_watertight else None


def curve_of(method: str, name: str, variant: Variant, wanted: argparse.Namespace) -> Curve | None:
    """In the shape's place. None where the method has failed, which standard error says."""
    import msf_jax

    try:
        if method == curves.OURS:
            found = msf_jax.skeletonize(variant.mesh, repair=True)
            return variant.turn.inv().apply(found.vertices), found.edges
        result = curves.peer_result(method, curves.Case(name, variant.mesh), wanted.limit, wanted.cache)
        return variant.turn.inv().apply(result["vertices"]), result["edges"]
    except Exception as error:
        print(f"{name}, {variant.kind}, {method}: {type(error).__name__}: {error}", file=sys.stderr)
        return None


def apart(mesh: Mesh, one: Curve, other: Curve) -> float:
    """Mean distance between two curves of the mesh, in median radii of the first."""
    from msf_jax.solid.enclosure import Enclosure

    points = [frame.sampled(each, STEP * frame.diagonal(mesh[0])) for each in (one, other)]
    shape = Enclosure(*mesh)
    inside = points[0][shape.contains(points[0])]
    radius = np.median(shape.distances(inside)) if len(inside) else np.nan
    return float(frame.apart(*points) / radius)


def row_of(method: str, name: str, mesh: Mesh, wanted: argparse.Namespace) -> dict[str, Any] | None:
    """How many tips the shape has; by kind of variant how far its curves are; and of each variant whether it has as
    many tips, and as many junctions. None where the shape itself fails."""
    own = curve_of(method, name, Variant("as it is", mesh, Rotation.identity()), wanted)
    if own is None:
        return None
    far: dict[str, list[float]] = {kind: [] for kind in KINDS}
    same = []
    for variant in variants(mesh, wanted.rotations):
        other = curve_of(method, name, variant, wanted)
        if other is not None:
            far[variant.kind].append(apart(mesh, own, other))
        parts = (frame.ends, frame.junctions)
        same.append([other is not None and len(part(own)) == len(part(other)) for part in parts])
    return {"tips": len(frame.ends(own)), "far": far, "same": np.array(same)}


def bars(wanted: argparse.Namespace) -> Iterator[str]:
    """A row for each other curve of a shape, and a line for each kind of them."""
    import jax

    from msf_jax import metrics

    frame.configure_jax()
    label = f"Python {platform.python_version()}, JAX {jax.__version__}"
    wanted.bars.mkdir(parents=True, exist_ok=True)
    yield frame.opening(f"How much curves move for no reason: {label}")
    yield frame.head(["shape", "beside", "ends", "junctions", "apart, thousandths of the diagonal"])
    rows: dict[str, list[list[float]]] = {}
    for name, mesh in shapes(wanted):
        (x, faces), size, random, still = mesh, frame.diagonal(mesh[0]), np.random.default_rng(11), Rotation.identity()
        others = [Variant("noise", (x + random.normal(0, 1e-4 * size, x.shape), faces), still) for _ in range(3)]
        own = curve_of(curves.OURS, name, Variant("as it is", mesh, still), wanted)
        found = [(each.kind, curve_of(curves.OURS, name, each, wanted)) for each in others]
        frame.configure_jax(float32=True)
        found += [("float32", curve_of(curves.OURS, name, Variant("float32", mesh, still), wanted))]
        frame.configure_jax()
        kept = wanted.bars / f"{name} {label}.npz"
        for path in sorted({*wanted.bars.glob(f"{name} Python*.npz")} - {kept}):
            with np.load(path) as file:
                found += [(path.stem.removeprefix(f"{name} "), (file["vertices"], file["edges"]))]
        if own is not None:
            np.savez(kept, vertices=own[0], edges=own[1])
        for kind, other in found:
            if own is not None and other is not None:
                counts = [[len(part(curve)) for curve in (own, other)] for part in (frame.ends, frame.junctions)]
                pairs = ((frame.sampled(own, STEP * size), other), (frame.sampled(other, STEP * size), own))
                far = 1e3 * float(np.mean([metrics.curve_distance(x, *curve).mean() for x, curve in pairs])) / size
                rows.setdefault(kind, []).append([*(float(a == b) for a, b in counts), far])
                yield frame.line([name, kind, *(f"{a}, {b}" for a, b in counts), f"{far:.3f}"])
    for kind, done in rows.items():
        ends, forks, far = np.array(done).T
        yield (
            f"\n{kind}: of {len(done)} curves {ends.mean():.0%} have the same ends, {forks.mean():.0%} the same "
            f"junctions; apart {np.median(far):.3f} in the median, at most {far.max():.3f}.\n"
        )


def report(wanted: argparse.Namespace) -> Iterator[str]:
    frame.configure_jax()
    methods = curves.installed(wanted.methods)
    yield frame.opening("The same shape, the same curve")
    yield frame.head(["shape", "method", "tips", "same tips", "same junctions", *KINDS])
    rows: dict[str, list[dict[str, Any]]] = {method: [] for method in methods}
    for name, mesh in shapes(wanted):
        for method in methods:
            if found := row_of(method, name, mesh, wanted):
                rows[method].append(found)
                counts = [f"{count} of {len(found['same'])}" for count in found["same"].sum(axis=0)]
                means = [f"{np.mean(far):.2f}" if far else "-" for far in found["far"].values()]
                yield frame.line([name, method, str(found["tips"]), *counts, *means])
    for method, done in rows.items():
        if done:
            same = np.concatenate([found["same"] for found in done])
            far = np.concatenate([np.zeros(0), *(each for found in done for each in found["far"].values())])
            yield (
                f"\n{method}: of {len(same)} variants of {len(done)} shapes {same[:, 0].mean():.0%} have the same "
                f"tips, {same[:, 1].mean():.0%} the same junctions; distance {far.mean():.2f} radii in the mean, "
                f"{np.median(far):.2f} in the median, under 0.1 in {(far < 0.1).mean():.0%}.\n"
            )


def main() -> None:
    parser = curves.parser_for("stability", __doc__, [curves.OURS, "cgal"])
    parser.add_argument("--rotations", type=int, default=10)
    parser.add_argument("--bars", type=Path, help="folder of curves of other environments")
    wanted = parser.parse_args()
    frame.publish(bars(wanted) if wanted.bars else report(wanted), wanted.output)


if __name__ == "__main__":
    main()
