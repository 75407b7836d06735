"""What the benchmarks share: jobs in time and in processes, curves compared, tables in Markdown, pictures of misses.

A benchmark is a function from a name to a `Job`, a mesh with a judge of its curve; `report` makes a table of the rows.
"""

import argparse
import faulthandler
import fnmatch
import multiprocessing
import os
import platform
import signal
import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from scipy import spatial
from scipy.optimize import linear_sum_assignment

ROOT = Path(__file__).parents[2]
SHARED = ROOT.parent / "shared"  # folders of meshes, where they are at hand
Mesh = tuple[np.ndarray, np.ndarray]  # vertices (V, 3), faces (F, 3)
Curve = tuple[np.ndarray, np.ndarray]  # vertices (N, 3), edges (E, 2)
Pieces = Iterator[str]  # of a report


@dataclass
class Job:
    """A mesh and what is right for its curve.

    Attributes:
        mesh: as `skeletonize` takes it.
        judge: from a skeleton to the cells of its row, by column, and what is wrong with it, in words.
        options: of `skeletonize`.
        shown: the mesh in the place in which ``back`` puts the curve, for a picture of a miss; none if not given.
        places: (K, 3) where ends belong, in that picture.
        back: (3, 3) what the curve is multiplied by there.
    """

    mesh: Any
    judge: Callable[[Any], tuple[dict[str, str], list[str]]]
    options: dict[str, Any] = field(default_factory=dict)
    shown: Mesh | None = None
    places: np.ndarray = field(default_factory=lambda: np.zeros((0, 3)))
    back: np.ndarray = field(default_factory=lambda: np.eye(3))


class Row(NamedTuple):
    """cells: by column, none where there is no curve. wrong: in words. seconds: without compiling."""

    name: str
    cells: dict[str, str]
    wrong: list[str]
    is_sound: bool = False
    seconds: float = 0.0


class TooLong(BaseException):
    """A job took longer than its limit. No `Exception`, so that nobody takes it for an error of a mesh."""


@contextmanager
def limited(seconds: float) -> Iterator[None]:
    """A `TooLong` after so many seconds. A process of a pool that a library does not let go of ends soon after."""

    def stop(*_: object) -> None:
        raise TooLong(f"no end in {seconds:g} s")

    before = signal.signal(signal.SIGALRM, stop)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    if multiprocessing.parent_process():
        faulthandler.dump_traceback_later(seconds + 5, exit=True)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        faulthandler.cancel_dump_traceback_later()
        signal.signal(signal.SIGALRM, before)


def row_of(name: str, make: Callable[[str], Job], limit: float, pictures: Path | None) -> Row:
    """The row of the job of that name; what is raised is what is wrong."""
    import msf_jax

    start = time.perf_counter()
    try:
        with limited(limit):
            job = make(name)
            start = time.perf_counter()
            skeleton = msf_jax.skeletonize(job.mesh, **job.options)
            took = time.perf_counter() - start - skeleton.report.seconds.get("compile", 0.0)
            cells, wrong = job.judge(skeleton)
    except (Exception, TooLong) as error:  # a row, not the end of the table
        return Row(name, {}, [f"{type(error).__name__}: {error}"[:120]], seconds=time.perf_counter() - start)
    if pictures and wrong and job.shown:
        curve = (skeleton.vertices @ job.back, skeleton.edges)
        file = pictures / f"{Path(name).stem.replace(' ', '-')}.png"
        draw(job.shown, {"crimson": curve}, job.places, f"{name}: {'; '.join(wrong)}", file)
    is_sound = skeleton.report.is_sound
    cells = {"vertices": f"{len(skeleton.mesh_map):,}", **cells, "sound": "yes" if is_sound else "no"}
    return Row(name, cells, wrong, is_sound, took)


def in_turn(work: Callable[[Any], Any], jobs: Sequence[Any], num: int = 1) -> Iterator[Any]:
    """What ``work`` makes of each job, in their order, by ``num`` processes that stay; or, for 0, by one for each job,
    and a row that says so where that ends in the midst of the job."""
    context = multiprocessing.get_context("spawn")
    if num:
        with ProcessPoolExecutor(num, mp_context=context, initializer=configure_jax) as pool:
            yield from pool.map(work, jobs)
    for job in jobs if not num else ():
        with ProcessPoolExecutor(1, mp_context=context, initializer=configure_jax) as pool:
            try:
                yield pool.submit(work, job).result()
            except BrokenProcessPool:
                yield Row(str(job), {}, ["its process ended"])


def configure_jax(*, float32: bool = False) -> None:
    """As the command line does it."""
    import jax  # not in a peer's process

    jax.config.update("jax_enable_x64", not float32)
    jax.config.update("jax_persistent_cache_min_compile_time_secs", 0.2)


# Curves


def degree(curve: Curve) -> np.ndarray:
    return np.bincount(curve[1].ravel(), minlength=len(curve[0]))


def ends(curve: Curve) -> np.ndarray:
    return curve[0][degree(curve) == 1]


def junctions(curve: Curve) -> np.ndarray:
    return curve[0][degree(curve) > 2]


def length(curve: Curve) -> float:
    return float(np.linalg.norm(np.diff(curve[0][curve[1]], axis=1), axis=2).sum())


def sampled(curve: Curve, spacing: float) -> np.ndarray:
    """Points on a curve, at most ``spacing`` apart."""
    from msf_jax import metrics

    return metrics.sample_curve(*curve, spacing)[0]


def away(points: np.ndarray, others: np.ndarray) -> np.ndarray:
    """The distance of each point from the nearest of others."""
    return spatial.KDTree(others).query(points)[0]


def apart(one: np.ndarray, other: np.ndarray) -> float:
    """Mean distance between two sets of points, both ways."""
    return float(np.mean([away(one, other).mean(), away(other, one).mean()]))


def matched(one: np.ndarray, other: np.ndarray, reach: float) -> int:
    """How many points have one of the other ones within ``reach``, each used once."""
    far = np.linalg.norm(one[:, None] - other[None], axis=2)
    return int((far[linear_sum_assignment(np.where(far < reach, far, 1e9))] < reach).sum())


def diagonal(points: np.ndarray) -> float:
    return float(np.linalg.norm(np.ptp(points, axis=0)))


def draw(mesh: Mesh, curves: dict[str, Curve], places: np.ndarray, title: str, file: Path) -> None:
    """A PNG: the mesh faint, curves by colour, places as crosses, from two sides."""
    from matplotlib.figure import Figure
    from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection

    vertices, faces = mesh
    figure = Figure(figsize=(12, 6), layout="constrained")
    figure.suptitle(title[:150], fontsize=9)
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    for number, (elevation, azimuth) in enumerate(((20, -70), (80, -85))):
        axes: Any = figure.add_subplot(1, 2, number + 1, projection="3d", proj_type="ortho")
        faint = {"facecolor": (0.55, 0.62, 0.72, 0.08), "edgecolor": (0.3, 0.35, 0.4, 0.12), "linewidth": 0.3}
        axes.add_collection3d(Poly3DCollection(vertices[faces], **faint))
        for colour, (x, edges) in curves.items():
            axes.add_collection3d(Line3DCollection(x[edges], color=colour, linewidth=2.5))
        axes.scatter(*places.T, marker="x", color="black", s=30, depthshade=False)
        axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
        axes.set_box_aspect(high - low)
        axes.view_init(elevation, azimuth)
        axes.set_axis_off()
    file.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(file, dpi=80)


# Tables


def line(cells: Sequence[str]) -> str:
    return "| " + " | ".join(text.replace("|", "\\|").replace("\n", " ") for text in cells) + " |\n"


def head(columns: Sequence[str]) -> str:
    return "\n" + line(columns) + line(["---"] * len(columns))


def opening(title: str) -> str:
    return f"# {title}\n\nPython {platform.python_version()}, {platform.machine()}, {os.cpu_count()} cores.\n"


def report(
    title: str, columns: Sequence[str], names: Sequence[str], make: Callable[[str], Job], wanted: argparse.Namespace
) -> Iterator[str]:
    """A table of the jobs whose names ``--only`` names, with ``columns`` of their judges, and how many are right."""
    names = [name for name in names if any(fnmatch.fnmatch(Path(name).name, pattern) for pattern in wanted.only)]
    columns = ["vertices", *columns, "sound"]
    yield opening(title) + head(["shape", *columns, "seconds", "ok", "what is wrong"])
    rows = []
    for row in in_turn(partial(row_of, make=make, limit=wanted.limit, pictures=wanted.pictures), names, wanted.jobs):
        rows.append(row)
        cells = [row.cells.get(column, "") for column in columns]
        end = [f"{row.seconds:.1f}", "NO" if row.wrong else "ok", "; ".join(row.wrong)]
        yield line([Path(row.name).name, *cells, *end])
    wrong = [row for row in rows if row.wrong]
    yield f"\n{len(rows) - len(wrong)} of {len(rows)} are right; of the others {sum(row.is_sound for row in wrong)} "
    yield f"are called sound. {sum(row.seconds for row in rows):.0f} s.\n"
    forms = {row.name.split(" ")[0]: [] for row in rows if " " in row.name}  # of names such as "bar fine"
    for row in rows if forms else ():
        forms[row.name.split(" ")[0]].append(not row.wrong)
    if forms:
        yield f"{sum(map(all, forms.values()))} of {len(forms)} are right in all their forms.\n"


def publish(pieces: Iterator[str], output: Path | None) -> None:
    """Print a report as it comes, and write it to a file; what was there stays until all is written."""
    if output:  # before the first piece is computed
        output.parent.mkdir(parents=True, exist_ok=True)
    text = ""
    for piece in pieces:
        print(piece, end="", flush=True)  # at once, since a whole run takes long
        text += piece
    if output:
        part = output.with_name(f"{output.name}.part")
        part.write_text(text)
        part.replace(output)


def words(text: str) -> list[str]:
    return text.split(",")


def parser_for(name: str, description: str | None, limit: float = 120) -> argparse.ArgumentParser:
    """The options that the benchmarks have in common."""
    parser = argparse.ArgumentParser(
        prog=f"python -m tests.benchmarks.{name}", description=(description or "").splitlines()[0]
    )
    parser.add_argument("--only", type=words, default=["*"], help="names, with commas between; * is any text")
    parser.add_argument("--jobs", type=int, default=1, help="processes at a time; 0: a new one for each shape")
    parser.add_argument("--limit", type=float, default=limit, help="seconds for one shape, or for a peer's call")
    parser.add_argument("--pictures", type=Path, help="folder for a picture of each miss")
    parser.add_argument("--output", type=Path, help="file for the tables")
    return parser
