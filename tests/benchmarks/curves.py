"""How good are the curves: this project beside CGAL, GEL and skeletor, as Markdown tables.

    python -m tests.benchmarks.curves [--suite meshes|truth|all] [--only NAME,..] [--methods NAME,..]
        [--meshes FOLDER] [--cache FOLDER] [--limit SECONDS] [--output FILE]

Run from the project's root. The suite ``meshes`` is every closed ``*.off`` of a folder (``MSF_JAX_MESHES``, else
``../shared/meshes``); ``truth`` is `ground_truth`, solids around known curves. With ``--cache`` the peers' results,
failures included, are kept, a time-out for limits up to its own; a second run computes this project's curves only.
``JAX_COMPILATION_CACHE_DIR`` saves it its compilations. Peers are optional, and run in processes of their own.

Figures are those of `msf_jax.metrics.evaluate`, lengths in diagonals of the mesh's box. Changed or added here:
- seconds: of the call alone, without imports; ours compiles in its first calls. Never in bold.
- components, cycles and, where the curve is known, leaves: found/true; what counts is how far they are apart.
- to_true/R, from_true/R: mean distance from the curve to the true one, and back, over the mean true radius along it.
- tip_gap/R: the worst, over the true tips, of the distance to the curve's nearest leaf over the tip's radius.

Bold marks the best on a mesh, as printed; ties are all bold. Each suite ends in a summary. There, and under each mesh,
each peer is put beside this project on the part where both curves run (`msf_jax.metrics.compare`): ours / theirs.
"""

import argparse
import hashlib
import importlib.metadata
import importlib.util
import os
import platform
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import trimesh

ROOT = Path(__file__).parents[2]
OURS = "msf_jax"
Graph = tuple[np.ndarray, np.ndarray]  # vertices (N, 3), edges (E, 2)
Figures = dict[str, Any]  # of one method on one mesh; "failure" among them if there is no curve to score
Rows = dict[str, Figures]  # by method


def cgal(vertices: np.ndarray, faces: np.ndarray) -> Graph:
    """CGAL's mean curvature flow: separate segments, whose ends agree to the last bit where they meet."""
    from compas_cgal.skeletonization import mesh_skeleton

    ends = np.array(mesh_skeleton((vertices, faces)), dtype=np.float64).reshape(-1, 3)
    points, number = np.unique(ends, axis=0, return_inverse=True)
    return points, number.reshape(-1, 2)


def gel(vertices: np.ndarray, faces: np.ndarray) -> Graph:
    """GEL's local separators, with its default sampling."""
    from pygel3d import graph, hmesh

    skeleton = graph.LS_skeleton(graph.from_mesh(hmesh.Manifold.from_triangles(vertices, faces)))
    skeleton.cleanup()  # closes gaps in the numbering
    edges = [(node, other) for node in skeleton.nodes() for other in skeleton.neighbors(node) if node < other]
    return np.array(skeleton.positions()), np.array(edges)


def skeletor(vertices: np.ndarray, faces: np.ndarray, *, method: str, **options: Any) -> Graph:
    """A method of skeletor; its mean curvature flow contracts by itself."""
    from skeletor import skeletonize

    curve = getattr(skeletonize, method)(trimesh.Trimesh(vertices, faces, process=False), progress=False, **options)
    return curve.vertices, curve.edges


# What to call, and what to import before the clock starts.
PEERS: dict[str, tuple[Callable[..., Graph], str]] = {
    "cgal": (cgal, "compas_cgal.skeletonization"),
    "gel": (gel, "pygel3d.graph"),
    "mean_curvature": (partial(skeletor, method="by_mean_curvature"), "skeletor"),
    "wavefront": (partial(skeletor, method="by_wavefront", waves=1, step_size=1), "skeletor"),
}
PACKAGES = {OURS: OURS} | {name: module.partition(".")[0] for name, (_, module) in PEERS.items()}  # of all methods


class Column(NamedTuple):
    key: str
    sign: int = 0  # -1 where lower is better, 1 where higher is, 0 where neither
    digits: int = 4
    true: str = ""  # key of the value to meet, for counts

    def value(self, figures: Figures) -> float:
        """What is compared: the figure as printed, for counts how far it is off; NaN where there is none."""
        found, true = figures.get(self.key, np.nan), figures.get(self.true, np.nan)
        return float(abs(found - true) if self.true else round(found, self.digits))

    def text(self, figures: Figures) -> str:
        found, true = figures.get(self.key, np.nan), figures.get(self.true, np.nan)
        return ("-" if np.isnan(found) else f"{found:.{self.digits}f}") + ("" if np.isnan(true) else f"/{true:.0f}")

    def winners(self, rows: Rows) -> set[str]:
        """The methods with the best value, of two or more that have one."""
        values = {method: self.sign * self.value(figures) for method, figures in rows.items()}
        values = {method: value for method, value in values.items() if self.sign and not np.isnan(value)}
        return {method for method, value in values.items() if len(values) > 1 and value == max(values.values())}


COLUMNS = [Column("seconds", digits=2), Column("components", -1, 0, "mesh_components")]
COLUMNS += [Column("cycles", -1, 0, "genus"), Column("leaves", -1, 0, "true_leaves"), Column("inside", 1)]
COLUMNS += [Column("off_centre", -1), Column("missed_95", -1), Column("missed_max", -1), Column("boundedness", 1)]
# No winner in tip_gap: 0 is what a curve without leaves gets, and one whose leaves stick out.
COLUMNS += [Column("smoothness", 1), Column("tip_gap"), Column("length", digits=3)]
TRUTH_COLUMNS = [Column("to_true/R", -1), Column("from_true/R", -1), Column("to_truth_max", -1)]
TRUTH_COLUMNS += [Column("from_truth_max", -1), Column("tip_gap/R", -1, 3)]


class Case(NamedTuple):
    name: str
    vertices: np.ndarray
    faces: np.ndarray
    shape: Any = None  # its KnownShape, in the suite of known curves


def stopped(code: int) -> str:
    """How a process with this exit code ended."""
    return "stopped" + (f" by {signal.Signals(-code).name}" if code < 0 else "")


def run_peer(name: str, source: str, target: str) -> None:
    """What the process of a peer does: a mesh from one file, its curve into another."""
    importlib.import_module(PEERS[name][1])
    mesh = dict(np.load(source))
    start = time.perf_counter()
    vertices, edges = PEERS[name][0](**mesh)
    np.savez(target, vertices=vertices, edges=edges, seconds=time.perf_counter() - start)


def peer_result(name: str, case: Case, limit: float, cache: Path | None) -> Figures:
    """``vertices`` and ``edges``, or ``failure``; and ``seconds``. From the cache, or from a process of its own."""
    version = importlib.metadata.version(PACKAGES[name]).encode()
    digest = hashlib.sha256(version + case.vertices.tobytes() + case.faces.tobytes()).hexdigest()[:16]
    kept = cache / f"{case.name}-{name}-{digest}.npz" if cache else None
    if kept and kept.exists() and limit <= (result := dict(np.load(kept))).get("limit", np.inf):
        return result
    with tempfile.TemporaryDirectory(dir=cache) as folder:  # in the cache, so that the result can be moved into place
        source, target = Path(folder, "mesh.npz").resolve(), Path(folder, "curve.npz").resolve()
        np.savez(source, vertices=case.vertices, faces=case.faces)
        command = [sys.executable, "-m", "tests.benchmarks.curves", "--peer", name, str(source), str(target)]
        failure, code, start = {}, 0, time.perf_counter()
        try:
            done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, errors="replace", timeout=limit)
            if code := done.returncode:
                message = ["no message", *done.stderr.strip().splitlines()][-1][:100]
                failure = {"failure": f"{stopped(code)}: {message}"}
        except subprocess.TimeoutExpired:
            failure = {"failure": f"timed out after {limit:g} s", "limit": limit}
        if failure:
            np.savez(target, seconds=time.perf_counter() - start, **failure)
        result = dict(np.load(target))
        if kept and code != -signal.SIGKILL:  # killed from outside, for want of memory perhaps: not the peer's fault
            target.replace(kept)
    return result


def score(case: Case, result: Figures) -> Figures:
    """The figures of a row; only ``failure`` and ``seconds`` where there is no curve."""
    from msf_jax import metrics

    figures: Figures = {key: np.asarray(result[key]).item() for key in ("seconds", "failure") if key in result}
    if "failure" in figures:
        return figures
    vertices, edges = np.array(result["vertices"], np.float64), np.array(result["edges"], np.int64).reshape(-1, 2)
    edges = np.unique(np.sort(edges[edges[:, 0] != edges[:, 1]], axis=1), axis=0)  # each once, no loops
    if not len(edges):  # then nothing is off centre or rough, and it would win
        return figures | {"failure": "a curve without edges"}
    truth = (case.shape.points, case.shape.edges) if case.shape else None
    figures |= metrics.evaluate((case.vertices, case.faces), (vertices, edges), truth=truth)
    figures["curve"] = vertices, edges
    if shape := case.shape:
        figures |= {"genus": shape.genus, "true_leaves": shape.num_leaves}
        leaves = vertices[np.bincount(edges.ravel(), minlength=len(vertices)) == 1]
        gap = np.linalg.norm(shape.tips[:, None] - leaves, axis=-1).min(axis=1, initial=np.inf)
        figures["tip_gap/R"] = (gap / shape.tip_radii).max() if len(gap) else np.nan
        length = np.linalg.norm(np.diff(shape.points[shape.edges], axis=1)[:, 0], axis=1)
        radius = np.average(shape.radii[shape.edges].mean(axis=1), weights=length)
        unit = np.linalg.norm(np.ptp(case.vertices, axis=0)) / radius
        figures |= {f"{side}_true/R": unit * figures.get(f"{side}_truth_mean", np.nan) for side in ("to", "from")}
    return figures


COMMON = {"common": 3, "off_centre": 4, "missed_95": 4}  # figures of `compare`, and their digits


def beside(case: Case, rows: Rows) -> Rows:
    """By peer, the figures of `compare` for our curve and that peer's; nothing where one of the two is missing."""
    from msf_jax import metrics

    curves = {method: figures.pop("curve") for method, figures in rows.items() if "curve" in figures}
    found: Rows = {}
    for method in curves if OURS in curves else ():
        if method != OURS:
            figures = metrics.compare((case.vertices, case.faces), curves[OURS], curves[method])
            found[method] = {key: round(value, COMMON[key.removeprefix("other_")]) for key, value in figures.items()}
    return found


def common_table(found: Rows) -> str:
    """`beside` as a table; nothing where there is nothing."""
    if not found:
        return ""
    text = "\n" + line([f"common part, {OURS} / peer", *COMMON]) + line(["---", *["---:"] * len(COMMON)])
    for method, figures in found.items():
        pairs = [[f"{figures[name + key]:.{digits}f}" for name in ("", "other_")] for key, digits in COMMON.items()]
        text += line([method, *(" / ".join(pair) for pair in pairs)])
    return text


def common_summary(pairs: list[Rows]) -> str:
    """On how many meshes our figures on the common part are at or below a peer's, and their means."""
    text = ""
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


def row_of(method: str, case: Case, limit: float, cache: Path | None) -> Figures:
    import msf_jax

    stage, start = "", time.perf_counter()
    try:
        if method == OURS:
            curve = msf_jax.skeletonize((case.vertices, case.faces))
            result = {"vertices": curve.vertices, "edges": curve.edges, "seconds": time.perf_counter() - start}
        else:
            result = peer_result(method, case, limit, cache)
        stage = "not scored: "
        return score(case, result)
    except Exception as error:  # a mesh that we cannot do, a curve that is none: a row, not the end of the table
        return {"failure": f"{stage}{type(error).__name__}: {error}", "seconds": time.perf_counter() - start}


def line(cells: Sequence[str]) -> str:
    return "| " + " | ".join(text.replace("|", "\\|").replace("\n", " ") for text in cells) + " |\n"


def table(case: Case, rows: Rows, columns: list[Column]) -> str:
    text = f"\n### {case.name} ({len(case.vertices):,} vertices)\n\n"
    text += line(["method", *(column.key for column in columns)]) + line(["---", *["---:"] * len(columns)])
    for method, figures in rows.items():
        cells = [f"**{c.text(figures)}**" if method in c.winners(rows) else c.text(figures) for c in columns]
        if "failure" in figures:
            cells[1:] = [figures["failure"], *[""] * (len(columns) - 2)]
        text += line([method, *cells])
    return text


def summary(suite: str, methods: list[str], results: dict[str, Rows], columns: list[Column]) -> str:
    """``results`` goes by mesh."""
    done = [rows for rows in results.values() if not any("failure" in figures for figures in rows.values())]
    text = f"\n## Summary of {suite}\n\nMeans over the {len(done)} of {len(results)} meshes that all methods finished, "
    text += "for counts of how far they are off; in brackets on how many of all meshes the method is in bold.\n\n"
    text += line(["method", "finished", *(c.key for c in columns)]) + line(["---", *["---:"] * (len(columns) + 1)])
    for method in methods:
        cells = [method, str(sum("failure" not in rows[method] for rows in results.values()))]
        for column in columns:
            values = [[column.value(rows[name]) for name in (method, *methods)] for rows in done]
            values = [row[0] for row in values if not np.isnan(row).any()]  # a figure that one lacks counts for none
            wins = f" ({sum(method in column.winners(rows) for rows in results.values())})" if column.sign else ""
            cells.append((f"{np.mean(values):.{max(column.digits, 1)}f}" if values else "-") + wins)
        text += line(cells)
    if {OURS, "cgal"} <= set(methods):
        both = [rows for rows in results.values() if "failure" not in rows[OURS] and "failure" not in rows["cgal"]]
        keys = ("off_centre", "missed_95")
        below = [[rows[OURS].get(key, np.nan) <= rows["cgal"].get(key, np.nan) for key in keys] for rows in both]
        sums = [sum(a for a, _ in below), sum(b for _, b in below), sum(map(all, below))]
        text += f"\nOf the {len(both)} meshes that {OURS} and cgal finished, {OURS} is at or below cgal on "
        text += "{} in off_centre, {} in missed_95, {} in both.\n".format(*sums)
    return text


def mesh_files(folder: Path) -> dict[str, Path]:
    """The closed meshes of a folder, by name."""
    return {path.stem: path for path in sorted(folder.glob("*.off")) if "open" not in path.stem}


def cases_of(suite: str, folder: Path, only: list[str] | None) -> Iterator[Case]:
    from tests.benchmarks import ground_truth

    files = mesh_files(folder)
    for name in files if suite == "meshes" else ground_truth.BUILDERS:
        if not only or name in only:
            shape = ground_truth.make(name) if suite == "truth" else None
            mesh = shape.mesh if shape else trimesh.load(files[name], process=False)
            yield Case(name, np.array(mesh.vertices), np.array(mesh.faces), shape)


def opening(title: str, wanted: list[str], methods: list[str]) -> str:
    """The head of a report on ``methods``, those of the wanted ones that are installed."""
    text = f"# {title}\n\nPython {platform.python_version()}, {platform.machine()}, {os.cpu_count()} cores.\n"
    for name in sorted({*wanted} - {*methods}):
        text += f"\nLeft out: {name}, whose package {PACKAGES[name]} is not installed.\n"
    return text


def installed(methods: list[str]) -> list[str]:
    return [name for name in methods if importlib.util.find_spec(PACKAGES[name])]


def report(wanted: argparse.Namespace) -> Iterator[str]:
    methods = installed(wanted.methods)
    yield opening("Curves", wanted.methods, methods)
    for suite in ["meshes", "truth"] if wanted.suite == "all" else [wanted.suite]:
        columns = COLUMNS + (TRUTH_COLUMNS if suite == "truth" else [])
        results: dict[str, Rows] = {}
        pairs: list[Rows] = []
        for case in cases_of(suite, wanted.meshes, wanted.only):
            rows = results[case.name] = {}
            for name in methods:
                rows[name] = row_of(name, case, wanted.limit, wanted.cache)
                print(f"{case.name}, {name}: {rows[name]['seconds']:.2f} s", file=sys.stderr)
            pairs.append(beside(case, rows))
            yield table(case, rows, columns) + common_table(pairs[-1])
        if results:
            yield summary(suite, methods, results, columns) + common_summary(pairs)


def publish(pieces: Iterator[str], output: Path | None) -> None:
    """Print a report as it comes, and write it to a file."""
    if output:  # before the first piece is computed
        output.parent.mkdir(parents=True, exist_ok=True)
    text = ""
    for piece in pieces:
        print(piece, end="", flush=True)  # at once, since a whole run takes long
        text += piece
    if output:
        write_whole(output, text.encode())


def write_whole(path: Path, content: bytes) -> None:
    """Write a file; what was there stays until all is written."""
    part = path.with_name(f"{path.name}.part")
    part.write_bytes(content)
    part.replace(path)


def configure_jax(*, float32: bool = False) -> None:
    """As the command line does it."""
    import jax  # not in a peer's process

    jax.config.update("jax_enable_x64", not float32)
    jax.config.update("jax_persistent_cache_min_compile_time_secs", 0.2)


def parser_for(name: str, description: str) -> argparse.ArgumentParser:
    """The options that the benchmarks have in common."""
    parser = argparse.ArgumentParser(prog=f"python -m tests.benchmarks.{name}", description=description)
    parser.add_argument("--meshes", type=Path, default=os.environ.get("MSF_JAX_MESHES", ROOT.parent / "shared/meshes"))
    parser.add_argument("--only", type=lambda text: text.split(","), help="names of meshes, with commas between")
    parser.add_argument("--methods", type=method_names, default=[*PACKAGES], help=",".join(PACKAGES))
    parser.add_argument("--limit", type=float, default=300, help="seconds for one call in another process")
    parser.add_argument("--output", type=Path, help="file for the tables")
    return parser


def method_names(text: str) -> list[str]:
    names = text.split(",")
    if set(names) - set(PACKAGES):
        raise argparse.ArgumentTypeError(f"takes {', '.join(PACKAGES)}")
    return names


def main() -> None:
    parser = parser_for("curves", __doc__.splitlines()[0])
    parser.add_argument("--suite", choices=["meshes", "truth", "all"], default="all")
    parser.add_argument("--cache", type=Path, help="folder that keeps the peers' results")
    parser.add_argument("--peer", nargs=3, help=argparse.SUPPRESS)
    wanted = parser.parse_args()
    if wanted.peer:
        return run_peer(*wanted.peer)
    configure_jax()
    if wanted.cache:
        wanted.cache.mkdir(parents=True, exist_ok=True)
    publish(report(wanted), wanted.output)


if __name__ == "__main__":
    main()
