"""How good are the curves: this project beside CGAL, GEL and skeletor, as Markdown tables.

    python -m tests.benchmarks.curves [--suite meshes|truth|all] [--only NAME,..] [--methods NAME,..]
        [--meshes FOLDER] [--cache FOLDER] [--limit SECONDS] [--output FILE]

Run from the project's root. The suite ``meshes`` is every closed ``*.off`` of a folder (``MSF_JAX_MESHES``, else
``../shared/meshes``); ``truth`` is `ground_truth`, solids around known curves. With ``--cache`` the peers' results,
failures included, are kept, a time-out for limits up to its own; a second run computes this project's curves only.
``JAX_COMPILATION_CACHE_DIR`` saves it its compilations. Peers are optional, and run in processes of their own.

Figures are those of `msf_jax.metrics.evaluate`, lengths in diagonals of the mesh's box. Changed or added here:
- seconds: of the call alone, without imports; ours compiles in its first calls.
- components, cycles and, where the curve is known, leaves: found/true; in the summary, how far they are apart.
- to_true/R, from_true/R: mean distance from the curve to the true one, and back, over the mean true radius along it.
- tip_gap/R: the worst, over the true tips, of the distance to the curve's nearest leaf over the tip's radius.

Each suite ends in a summary. There, and under each mesh, each peer is put beside this project on the part where both
curves run (`msf_jax.metrics.compare`): ours / theirs.
"""

import argparse
import hashlib
import importlib.metadata
import importlib.util
import multiprocessing
import os
import sys
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import trimesh

from tests.benchmarks import frame
from tests.benchmarks.frame import Curve, Mesh, line

OURS = "msf_jax"
Figures = dict[str, Any]  # of one method on one mesh; "failure" among them if there is no curve to score
Rows = dict[str, Figures]  # by method


def cgal(vertices: np.ndarray, faces: np.ndarray) -> Curve:
    """CGAL's mean curvature flow: separate segments, whose ends agree to the last bit where they meet."""
    from compas_cgal.skeletonization import mesh_skeleton

    ends = np.array(mesh_skeleton((vertices, faces)), dtype=np.float64).reshape(-1, 3)
    points, number = np.unique(ends, axis=0, return_inverse=True)
    return points, number.reshape(-1, 2)


def gel(vertices: np.ndarray, faces: np.ndarray) -> Curve:
    """GEL's local separators, with its default sampling."""
    from pygel3d import graph, hmesh

    skeleton = graph.LS_skeleton(graph.from_mesh(hmesh.Manifold.from_triangles(vertices, faces)))
    skeleton.cleanup()  # closes gaps in the numbering
    edges = [(node, other) for node in skeleton.nodes() for other in skeleton.neighbors(node) if node < other]
    return np.array(skeleton.positions()), np.array(edges)


def skeletor(vertices: np.ndarray, faces: np.ndarray, *, method: str, **options: Any) -> Curve:
    """A method of skeletor; its mean curvature flow contracts by itself."""
    from skeletor import skeletonize

    curve = getattr(skeletonize, method)(trimesh.Trimesh(vertices, faces, process=False), progress=False, **options)
    return curve.vertices, curve.edges


# What to call, and what to import before the clock starts.
PEERS: dict[str, tuple[Callable[..., Curve], str]] = {
    "cgal": (cgal, "compas_cgal.skeletonization"),
    "gel": (gel, "pygel3d.graph"),
    "mean_curvature": (partial(skeletor, method="by_mean_curvature"), "skeletor"),
    "wavefront": (partial(skeletor, method="by_wavefront", waves=1, step_size=1), "skeletor"),
}
PACKAGES = {OURS: OURS} | {name: module.partition(".")[0] for name, (_, module) in PEERS.items()}  # of all methods


class Column(NamedTuple):
    """A figure: its key, its digits, and for counts the key of the value to meet."""

    key: str
    digits: int = 4
    true: str = ""

    def value(self, figures: Figures) -> float:
        """The figure, for counts how far it is off; NaN where there is none."""
        found, true = figures.get(self.key, np.nan), figures.get(self.true, np.nan)
        return float(abs(found - true) if self.true else found)

    def text(self, figures: Figures) -> str:
        found, true = figures.get(self.key, np.nan), figures.get(self.true, np.nan)
        return ("-" if np.isnan(found) else f"{found:.{self.digits}f}") + ("" if np.isnan(true) else f"/{true:.0f}")


COLUMNS = [Column("seconds", 2), Column("components", 0, "mesh_components"), Column("cycles", 0, "genus")]
COLUMNS += [Column("leaves", 0, "true_leaves"), Column("inside"), Column("off_centre"), Column("missed_95")]
COLUMNS += [Column("missed_max"), Column("boundedness"), Column("smoothness"), Column("tip_gap"), Column("length", 3)]
TRUTH_COLUMNS = [Column("to_true/R"), Column("from_true/R"), Column("to_truth_max"), Column("from_truth_max")]
TRUTH_COLUMNS += [Column("tip_gap/R", 3)]
COMMON = {"common": 3, "off_centre": 4, "missed_95": 4}  # figures of `compare`, and their digits


class Case(NamedTuple):
    name: str
    mesh: Mesh
    shape: Any = None  # its KnownShape, in the suite of known curves


def run_peer(name: str, mesh: Mesh, limit: float) -> Figures:
    """What the process of a peer does."""
    call, module = PEERS[name]
    importlib.import_module(module)
    start = time.perf_counter()
    with frame.limited(limit):
        vertices, edges = call(*mesh)
    return {"vertices": np.asarray(vertices), "edges": np.asarray(edges), "seconds": time.perf_counter() - start}


def peer_result(name: str, case: Case, limit: float, cache: Path | None) -> Figures:
    """``vertices`` and ``edges``, or ``failure``; and ``seconds``. From the cache, or from a process of its own."""
    version = importlib.metadata.version(PACKAGES[name]).encode()
    digest = hashlib.sha256(version + b"".join(array.tobytes() for array in case.mesh)).hexdigest()[:16]
    kept = cache / f"{case.name}-{name}-{digest}.npz" if cache else None
    if kept and kept.exists() and limit <= (result := dict(np.load(kept))).get("limit", np.inf):
        return result
    start = time.perf_counter()
    with ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("spawn")) as pool:
        try:
            result = pool.submit(run_peer, name, case.mesh, limit).result()
        except (Exception, frame.TooLong) as error:
            result = {"failure": f"{type(error).__name__}: {error}"[:100], "seconds": time.perf_counter() - start}
            result |= {"limit": limit} if isinstance(error, frame.TooLong) else {}
    if kept:
        part = kept.with_name(f"{kept.stem}.part.npz")
        part.parent.mkdir(parents=True, exist_ok=True)
        np.savez(part, **result)
        part.replace(kept)
    return result


def score(case: Case, result: Figures) -> Figures:
    """The figures of a row; only ``failure`` and ``seconds`` where there is no curve."""
    from msf_jax import metrics

    figures: Figures = {key: np.asarray(result[key]).item() for key in ("seconds", "failure") if key in result}
    if "failure" in figures:
        return figures
    vertices, edges = np.array(result["vertices"], np.float64), np.array(result["edges"], np.int64).reshape(-1, 2)
    edges = np.unique(np.sort(edges[edges[:, 0] != edges[:, 1]], axis=1), axis=0)  # each once, no loops
    if not len(edges):  # then nothing is off centre or rough
        return figures | {"failure": "a curve without edges"}
    truth = (case.shape.points, case.shape.edges) if case.shape else None
    figures |= metrics.evaluate(case.mesh, (vertices, edges), truth=truth)
    figures["curve"] = vertices, edges
    if shape := case.shape:
        figures |= {"genus": shape.genus, "true_leaves": shape.num_leaves}
        gap = np.linalg.norm(shape.tips[:, None] - frame.ends((vertices, edges)), axis=-1).min(axis=1, initial=np.inf)
        figures["tip_gap/R"] = (gap / shape.tip_radii).max() if len(gap) else np.nan
        length = np.linalg.norm(np.diff(shape.points[shape.edges], axis=1)[:, 0], axis=1)
        unit = frame.diagonal(case.mesh[0]) / np.average(shape.radii[shape.edges].mean(axis=1), weights=length)
        figures |= {f"{side}_true/R": unit * figures.get(f"{side}_truth_mean", np.nan) for side in ("to", "from")}
    return figures


def row_of(method: str, case: Case, limit: float, cache: Path | None) -> Figures:
    import msf_jax

    start = time.perf_counter()
    try:
        if method != OURS:
            return score(case, peer_result(method, case, limit, cache))
        curve = msf_jax.skeletonize(case.mesh)
        seconds = time.perf_counter() - start
        return score(case, {"vertices": curve.vertices, "edges": curve.edges, "seconds": seconds})
    except Exception as error:  # a mesh that we cannot do, a curve that is none: a row, not the end of the table
        return {"failure": f"{type(error).__name__}: {error}", "seconds": time.perf_counter() - start}


def beside(case: Case, rows: Rows) -> Rows:
    """By peer, the figures of `compare` for our curve and that peer's; nothing where one of the two is missing."""
    from msf_jax import metrics

    curves = {method: figures.pop("curve") for method, figures in rows.items() if "curve" in figures}
    peers = [method for method in curves if method != OURS] if OURS in curves else []
    return {method: metrics.compare(case.mesh, curves[OURS], curves[method]) for method in peers}


def table(case: Case, rows: Rows, common: Rows, columns: list[Column]) -> str:
    text = f"\n### {case.name} ({len(case.mesh[0]):,} vertices)\n" + frame.head(["method", *(c.key for c in columns)])
    for method, figures in rows.items():
        cells = [column.text(figures) for column in columns]
        if "failure" in figures:
            cells[1:] = [figures["failure"], *[""] * (len(columns) - 2)]
        text += line([method, *cells])
    text += frame.head([f"common part, {OURS} / peer", *COMMON]) if common else ""
    for method, figures in common.items():
        pairs = [[f"{figures[name + key]:.{digits}f}" for name in ("", "other_")] for key, digits in COMMON.items()]
        text += line([method, *(" / ".join(pair) for pair in pairs)])
    return text


def summary(suite: str, methods: list[str], results: dict[str, Rows], pairs: list[Rows], columns: list[Column]) -> str:
    """``results`` goes by mesh."""
    done = [rows for rows in results.values() if not any("failure" in figures for figures in rows.values())]
    text = f"\n## Summary of {suite}\n\nMeans over the {len(done)} of {len(results)} meshes that all methods finished, "
    text += "for counts of how far they are off.\n" + frame.head(["method", "finished", *(c.key for c in columns)])
    for method in methods:
        cells = [method, str(sum("failure" not in rows[method] for rows in results.values()))]
        for column in columns:
            values = [[column.value(rows[name]) for name in (method, *methods)] for rows in done]
            values = [row[0] for row in values if not np.isnan(row).any()]  # a figure that one lacks counts for none
            cells.append(f"{np.mean(values):.{max(column.digits, 1)}f}" if values else "-")
        text += line(cells)
    for method in dict.fromkeys(method for found in pairs for method in found):
        own = [found[method] for found in pairs if method in found]
        parts = []
        for key in ("off_centre", "missed_95"):
            both = np.array([[figures[key], figures[f"other_{key}"]] for figures in own]).reshape(-1, 2)
            both = both[~np.isnan(both).any(axis=1)]
            means = " / ".join(f"{value:.4f}" for value in both.mean(axis=0)) if len(both) else "-"
            parts.append(f"{(both[:, 0] <= both[:, 1]).sum()} of {len(both)} in {key} ({means})")
        text += f"\nOn the part where both run, {OURS} is at or below {method} on {' and '.join(parts)}.\n"
    return text


def mesh_files(folder: Path) -> dict[str, Path]:
    """The closed meshes of a folder, by name."""
    return {path.stem: path for path in sorted(folder.glob("*.off")) if "open" not in path.stem}


def cases_of(suite: str, folder: Path, only: list[str]) -> Iterator[Case]:
    from tests.benchmarks import ground_truth

    files = mesh_files(folder)
    for name in files if suite == "meshes" else ground_truth.BUILDERS:
        if only == ["*"] or name in only:
            shape = ground_truth.make(name) if suite == "truth" else None
            mesh = shape.mesh if shape else trimesh.load(files[name], process=False)
            yield Case(name, (np.array(mesh.vertices), np.array(mesh.faces)), shape)


def installed(methods: list[str]) -> list[str]:
    """Those whose packages are; of the others standard error says so."""
    found = [name for name in methods if importlib.util.find_spec(PACKAGES[name])]
    for name in sorted({*methods} - {*found}):
        print(f"Left out: {name}, whose package {PACKAGES[name]} is not installed.", file=sys.stderr)
    return found


def report(wanted: argparse.Namespace) -> Iterator[str]:
    frame.configure_jax()
    methods = installed(wanted.methods)
    yield frame.opening("Curves")
    for suite in ["meshes", "truth"] if wanted.suite == "all" else [wanted.suite]:
        columns = COLUMNS + (TRUTH_COLUMNS if suite == "truth" else [])
        results: dict[str, Rows] = {}
        pairs: list[Rows] = []
        for case in cases_of(suite, wanted.meshes, wanted.only):
            rows = results[case.name] = {name: row_of(name, case, wanted.limit, wanted.cache) for name in methods}
            pairs.append(beside(case, rows))
            yield table(case, rows, pairs[-1], columns)
        if results:
            yield summary(suite, methods, results, pairs, columns)


def parser_for(name: str, description: str | None, methods: list[str]) -> argparse.ArgumentParser:
    """The options of benchmarks with peers."""
    parser = frame.parser_for(name, description, limit=300)
    folder = os.environ.get("MSF_JAX_MESHES", frame.SHARED / "meshes")
    parser.add_argument("--meshes", type=Path, default=folder, help="folder of meshes")
    parser.add_argument("--methods", type=frame.words, default=methods, help=",".join(PACKAGES))
    parser.add_argument("--cache", type=Path, help="folder that keeps the peers' results")
    return parser


def main() -> None:
    parser = parser_for("curves", __doc__, [*PACKAGES])
    parser.add_argument("--suite", choices=["meshes", "truth", "all"], default="all")
    wanted = parser.parse_args()
    frame.publish(report(wanted), wanted.output)


if __name__ == "__main__":
    main()
