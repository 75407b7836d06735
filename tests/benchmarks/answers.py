"""Curves beside those that people drew: which ends are found, and how far are drawn joints and bones from the curve?

    python -m tests.benchmarks.answers FOLDER [--detail X] [--only NAME,..] [--peers]
        [--pictures FOLDER] [--output FILE]

Run from the project's root. The folder has pairs of a mesh and a drawn curve of the same name: ``.graph`` (GEL: ``n x
y z`` and ``c i j``, from 0), ``.tgf`` (``i x y z``, ``#``, ``i j``) or ``.swc``. With ``--peers``, CGAL and GEL are
scored beside.

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
from scipy import spatial
from scipy.optimize import linear_sum_assignment

from tests.benchmarks import curves
from tests.benchmarks.curves import Graph, configure_jax, line, opening, publish

REACH = 0.05  # diagonals: an end this near to a drawn one is that one
SPACING = 0.002  # diagonals between points of a curve
COLUMNS = ["shape", "method", "found", "drawn", "matched", "precision", "recall", "J2B", "B2C", "C2B"]


def drawn_curve(file: Path) -> Graph:
    """The nodes (N, 3) and edges (E, 2) of a file; nodes without an edge, such as removed ones, stay."""
    rows = [words for text in file.read_text().splitlines() if (words := text.split("!")[0].split())]
    if file.suffix == ".graph":
        nodes = [words[1:4] for words in rows if words[0] == "n"]
        edges = [words[1:3] for words in rows if words[0] == "c"]
        return np.array(nodes, dtype=float), np.array(edges, dtype=np.int64).reshape(-1, 2)
    if file.suffix == ".tgf":
        cut = next((number for number, words in enumerate(rows) if words[0] == "#"), len(rows))
        names = {words[0]: number for number, words in enumerate(rows[:cut])}
        edges = [[names[words[0]], names[words[1]]] for words in rows[cut + 1 :]]
        return np.array([words[1:4] for words in rows[:cut]], dtype=float), np.array(edges, np.int64).reshape(-1, 2)
    rows = [words for words in rows if words[0][0] != "#"]
    names = {words[0]: number for number, words in enumerate(rows)}
    edges = [[names[words[6]], names[words[0]]] for words in rows if words[6] in names]
    return np.array([words[2:5] for words in rows], dtype=float), np.array(edges, np.int64).reshape(-1, 2)


def pairs(folder: Path, only: list[str] | None) -> Iterator[tuple[str, Path, Path]]:
    """Name, mesh and drawn curve of each shape of a folder."""
    for file in sorted(path for suffix in ("graph", "tgf", "swc") for path in folder.glob(f"*.{suffix}")):
        meshes = [path for suffix in ("obj", "off", "ply", "stl") if (path := file.with_suffix(f".{suffix}")).exists()]
        if meshes and (only is None or file.stem in only):
            yield file.stem, meshes[0], file


def ends(curve: Graph) -> np.ndarray:
    return curve[0][np.bincount(curve[1].ravel(), minlength=len(curve[0])) == 1]


def scored(found: Graph, drawn: Graph, diagonal: float) -> list[float]:
    """Counts of ends found, drawn and matched, and J2B, B2C, C2B in per cent of the diagonal."""
    from msf_jax import metrics

    one, other = ends(found), ends(drawn)
    away = np.linalg.norm(one[:, None] - other[None], axis=2)
    rows, columns = linear_sum_assignment(np.where(away < REACH * diagonal, away, 1e9))
    matched = int((away[rows, columns] < REACH * diagonal).sum())
    ours, theirs = (metrics.sample_curve(*curve, SPACING * diagonal)[0] for curve in (found, drawn))
    degree = np.bincount(drawn[1].ravel(), minlength=len(drawn[0]))
    joints = drawn[0][(degree > 0) & (degree != 2)]
    tree = spatial.KDTree(ours)
    far = [tree.query(joints)[0].mean() if len(joints) else 0.0, tree.query(theirs)[0].mean()]
    far.append(spatial.KDTree(theirs).query(ours)[0].mean())
    return [len(one), len(other), matched, *(100 * float(each) / diagonal for each in far)]


def cells(name: str, method: str, figures: list[float]) -> list[str]:
    found, drawn, matched, *far = figures
    shares = [f"{matched / whole:.2f}" if whole else "1.00" for whole in (found, drawn)]
    return [name, method, *(f"{count:.0f}" for count in figures[:3]), *shares, *(f"{each:.2f}" for each in far)]


def pictured(mesh: trimesh.Trimesh, found: Graph, drawn: Graph, title: str, file: Path) -> None:
    """The curve in black, the drawn one in red, from two sides."""
    import matplotlib.pyplot as plt

    figure = plt.figure(figsize=(12, 6))
    for number, view in enumerate(((20, 30), (20, 120)), 1):
        axes = figure.add_subplot(1, 2, number, projection="3d", title=title if number == 1 else "")
        axes.plot_trisurf(*mesh.vertices.T, triangles=mesh.faces, color="0.8", alpha=0.15, linewidth=0)
        for (x, edges), colour in ((drawn, "red"), (found, "black")):
            for a, b in edges:
                axes.plot(*x[[a, b]].T, color=colour, linewidth=1)
        axes.view_init(*view)
        axes.set_aspect("equal")
        axes.set_axis_off()
    file.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(file, dpi=110, bbox_inches="tight")
    plt.close(figure)


def report(wanted: argparse.Namespace) -> Iterator[str]:
    import msf_jax

    configure_jax()
    yield opening("Curves that people drew", [], []) + f"\nDetail {wanted.detail:g}.\n\n"
    yield line(COLUMNS) + line(["---"] * len(COLUMNS))
    peers = {"cgal": curves.cgal, "gel": curves.gel} if wanted.peers else {}
    total: dict[str, list[list[float]]] = {}
    for name, mesh_file, file in pairs(wanted.folder, wanted.only):
        drawn = drawn_curve(file)
        skeleton = msf_jax.skeletonize(mesh_file, config=msf_jax.Config(detail=wanted.detail))
        mesh = trimesh.load_mesh(mesh_file, process=False)
        results = {"msf_jax": (skeleton.vertices, skeleton.edges)}
        results |= {method: peer(np.array(mesh.vertices), np.array(mesh.faces)) for method, peer in peers.items()}
        for method, curve in results.items():
            figures = scored(curve, drawn, float(np.linalg.norm(np.ptp(mesh.vertices, axis=0))))
            total.setdefault(method, []).append(figures)
            yield line(cells(name, method, figures))
        if wanted.pictures:
            pictured(mesh, results["msf_jax"], drawn, name, wanted.pictures / f"{name}.png")
    for method, rows in total.items():
        counts = np.array(rows)
        yield line(cells("all", method, [*counts[:, :3].sum(axis=0), *counts[:, 3:].mean(axis=0)]))


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.answers", description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path, help="of meshes and drawn curves")
    parser.add_argument("--detail", type=float, default=0.5, help="see Config")
    parser.add_argument("--only", type=lambda text: text.split(","), help="names, with commas between")
    parser.add_argument("--peers", action="store_true", help="CGAL and GEL beside")
    parser.add_argument("--pictures", type=Path, help="folder for pictures")
    parser.add_argument("--output", type=Path, help="file for the table")
    wanted = parser.parse_args()
    publish(report(wanted), wanted.output)


if __name__ == "__main__":
    main()
