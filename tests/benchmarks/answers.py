"""Curves beside those that people drew: which ends are found, and how far are drawn joints and bones from the curve?

    python -m tests.benchmarks.answers FOLDER [--detail X] [--only NAME,..] [--peers]
        [--pictures FOLDER] [--output FILE]

Run from the project's root. The folder has pairs of a mesh and a drawn curve of the same name, in GEL's ``.graph`` (``n
x y z`` and ``c i j``, from 0). With ``--peers``, CGAL and GEL are scored beside.

- ends: found, drawn, and matched one to one within 0.05 diagonals of the box.
- precision: matched of those found. recall: matched of those drawn. 1 without any.
- J2B: mean distance of drawn joints, nodes of degree other than 2, from the curve. B2C, C2B: of drawn bones from the
  curve, and of the curve from them. In per cent of the diagonal.
"""

import argparse
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import trimesh

from tests.benchmarks import curves, frame
from tests.benchmarks.frame import Curve

REACH = 0.05  # diagonals: an end this near to a drawn one is that one
SPACING = 0.002  # diagonals between points of a curve
COLUMNS = ["shape", "method", "found", "drawn", "matched", "precision", "recall", "J2B", "B2C", "C2B"]


def drawn_curve(file: Path) -> Curve:
    """The nodes (N, 3) and edges (E, 2) of a file; nodes without an edge, such as removed ones, stay."""
    rows = [words for text in file.read_text().splitlines() if (words := text.split("!")[0].split())]
    nodes = np.array([words[1:4] for words in rows if words[0] == "n"], dtype=float)
    return nodes, np.array([words[1:3] for words in rows if words[0] == "c"], dtype=np.int64).reshape(-1, 2)


def scored(found: Curve, drawn: Curve, size: float) -> list[float]:
    """Counts of ends found, drawn and matched, and J2B, B2C, C2B in per cent of the diagonal ``size``."""
    one, other = frame.ends(found), frame.ends(drawn)
    ours, theirs = (frame.sampled(curve, SPACING * size) for curve in (found, drawn))
    joints = drawn[0][(frame.degree(drawn) > 0) & (frame.degree(drawn) != 2)]
    far = [frame.away(joints, ours).mean() if len(joints) else 0.0]
    far += [frame.away(theirs, ours).mean(), frame.away(ours, theirs).mean()]
    return [len(one), len(other), frame.matched(one, other, REACH * size), *(100 * float(each) / size for each in far)]


def cells(name: str, method: str, figures: list[float]) -> list[str]:
    found, drawn, matched, *far = figures
    shares = [f"{matched / whole:.2f}" if whole else "1.00" for whole in (found, drawn)]
    return [name, method, *(f"{count:.0f}" for count in figures[:3]), *shares, *(f"{each:.2f}" for each in far)]


def report(wanted: argparse.Namespace) -> Iterator[str]:
    import msf_jax

    frame.configure_jax()
    yield frame.opening(f"Curves that people drew, detail {wanted.detail:g}") + frame.head(COLUMNS)
    peers = {"cgal": curves.cgal, "gel": curves.gel} if wanted.peers else {}
    total: dict[str, list[list[float]]] = {}
    for file in sorted(wanted.folder.glob("*.graph")):
        meshes = [path for suffix in ("obj", "off", "ply", "stl") if (path := file.with_suffix(f".{suffix}")).exists()]
        if not meshes or not (wanted.only == ["*"] or file.stem in wanted.only):
            continue
        drawn, mesh = drawn_curve(file), trimesh.load_mesh(meshes[0], process=False)
        arrays = np.array(mesh.vertices), np.array(mesh.faces)
        skeleton = msf_jax.skeletonize(meshes[0], config=msf_jax.Config(detail=wanted.detail))
        results = {"msf_jax": (skeleton.vertices, skeleton.edges)}
        results |= {method: peer(*arrays) for method, peer in peers.items()}
        for method, curve in results.items():
            total.setdefault(method, []).append(scored(curve, drawn, frame.diagonal(arrays[0])))
            yield frame.line(cells(file.stem, method, total[method][-1]))
        if wanted.pictures:
            both = {"red": drawn, "black": results["msf_jax"]}
            frame.draw(arrays, both, drawn[0][:0], file.stem, wanted.pictures / f"{file.stem}.png")
    for method, rows in total.items():
        counts = np.array(rows)
        yield frame.line(cells("all", method, [*counts[:, :3].sum(axis=0), *counts[:, 3:].mean(axis=0)]))


def main() -> None:
    parser = frame.parser_for("answers", __doc__)
    parser.add_argument("folder", type=Path, help="of meshes and drawn curves")
    parser.add_argument("--detail", type=float, default=0.5, help="see Config")
    parser.add_argument("--peers", action="store_true", help="CGAL and GEL beside")
    wanted = parser.parse_args()
    frame.publish(report(wanted), wanted.output)


if __name__ == "__main__":
    main()
