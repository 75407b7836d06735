"""How fast and how large: this project beside CGAL, GEL and skeletor, as Markdown tables.

    python -m tests.benchmarks.speed [--only NAME,..] [--sizes VERTICES,..] [--methods NAME,..] [--meshes FOLDER]
        [--repeats N] [--slow SECONDS] [--limit SECONDS] [--float32] [--no-cold] [--output FILE]

Run from the project's root. The meshes are every closed ``*.off`` of a folder (``MSF_JAX_MESHES``, else
``../shared/meshes``; ``--only ""`` for none of them), and the hand of `msf_jax.shapes` at other samplings, of about
``--sizes`` vertices each (``--sizes ""`` for none). Whether a fast curve is good, `tests.benchmarks.curves` tells.

For each mesh, each method gets a fresh process, which imports what it needs and loads the mesh before any clock starts.
One computes at a time: each once, to warm up, then all in turn, ``--repeats`` times. A method that takes more than
``--slow`` seconds is not called again. The columns:
- median, min, max: seconds of the calls that count: all but the first, unless there is no other (runs: 1).
- first: seconds of the first call. Ours compiles in it, unless ``JAX_COMPILATION_CACHE_DIR`` has it all.
- x ours: median over our median.
- before, peak, rise: the process's resident high-water mark in MB, before the first call and after the last, and the
  difference. Ours contains what compiling takes.
"""

import argparse
import importlib
import importlib.metadata
import math
import multiprocessing
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import trimesh

from tests.benchmarks import curves, frame
from tests.benchmarks.curves import OURS, PACKAGES, PEERS
from tests.benchmarks.frame import head, line

# A forked process would begin with its parent's memory. A spawned one still inherits the parent's high-water mark: the
# parent therefore imports little and holds no mesh.
SPAWN = multiprocessing.get_context("spawn")
MB = 1e6
LOADED: dict[str, Any] = {}  # in the process of a method: what to call, and the mesh
Source = Path | int  # a file, or the number of vertices of a hand


@dataclass
class Timing:
    """One method on one mesh; what there is of it where the method failed."""

    mesh: str
    method: str
    is_hand: bool
    vertices: int = 0
    calls: list[float] = field(default_factory=list)  # seconds, in order
    stages: list[dict[str, float]] = field(default_factory=list)  # seconds of these calls by stage; ours only
    before: float = math.nan  # bytes
    peak: float = math.nan
    failure: str = ""

    @property
    def counted(self) -> list[float]:
        return self.calls[1:] or self.calls

    @property
    def median(self) -> float:
        return statistics.median(self.counted)


def load(method: str, file: Path, float32: bool) -> tuple[int, int]:
    """In the process of a method: what it needs; returns how many vertices there are, and the memory."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # what a method prints is no part of the tables
    if method == OURS:
        import msf_jax

        frame.configure_jax(float32=float32)
        LOADED["call"] = lambda vertices, faces: msf_jax.skeletonize((vertices, faces))
    else:
        LOADED["call"], module = PEERS[method]
        importlib.import_module(module)
    LOADED["mesh"] = dict(np.load(file))
    return len(LOADED["mesh"]["vertices"]), high_water_mark()


def compute(method: str, limit: float) -> tuple[float, int, dict[str, float]]:
    """In the process of a method: seconds, memory, and our seconds by stage."""
    given = {name: values.copy() for name, values in LOADED["mesh"].items()}
    start = time.perf_counter()
    with frame.limited(limit):
        curve = LOADED["call"](**given)
    return time.perf_counter() - start, high_water_mark(), curve.report.seconds if method == OURS else {}


def high_water_mark() -> int:
    """The most bytes that this process has had resident."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * (1 if sys.platform == "darwin" else 1024)


def write_mesh(source: Source, file: Path) -> None:
    """Load a mesh, or make the hand with about so many vertices; with fewer than 10,000 limbs of it may touch."""
    if isinstance(source, int):
        from msf_jax import shapes

        # Above 100,000 by Loop subdivision: a grid would fill the memory.
        rounds = max(0, math.ceil(math.log(source / 1e5, 4)))
        mesh = shapes.hand(math.sqrt(22.6 * 4**rounds / source))  # 22.6: its vertices times the spacing's square
        for _ in range(rounds):
            mesh = trimesh.Trimesh(*trimesh.remesh.subdivide_loop(mesh.vertices, mesh.faces), process=False)
    else:
        mesh = trimesh.load(source, process=False)
    if file.suffix == ".npz":
        np.savez(file, vertices=mesh.vertices, faces=mesh.faces)
    else:
        mesh.export(file)


def measure(name: str, source: Source, methods: list[str], wanted: argparse.Namespace) -> list[Timing]:
    """All methods on one mesh, in turn, each in a process that keeps it."""
    timings = [Timing(name, method, isinstance(source, int)) for method in methods]
    pools = [ProcessPoolExecutor(1, mp_context=SPAWN) for _ in methods]
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "mesh.npz")
        with ProcessPoolExecutor(1, mp_context=SPAWN) as maker:
            maker.submit(write_mesh, source, file).result()
        for number in range(-1, 1 + wanted.repeats):
            for timing, pool in zip(timings, pools, strict=True):
                calls = timing.calls[1:] if timing.method == OURS else timing.calls  # our first one compiles
                if timing.failure or any(seconds > wanted.slow for seconds in calls):
                    continue
                try:
                    if number < 0:
                        given = (timing.method, file, wanted.float32)
                        timing.vertices, timing.before = pool.submit(load, *given).result()
                        continue
                    seconds, timing.peak, by_stage = pool.submit(compute, timing.method, wanted.limit).result()
                    timing.calls.append(seconds)
                    timing.stages.append(by_stage)
                except (Exception, frame.TooLong) as error:  # a row, not the end of the table
                    timing.failure = f"{type(error).__name__}: {error}"
    for pool in pools:
        pool.shutdown()
    return timings


def start_to_end(source: Source, wanted: argparse.Namespace) -> dict[str, list[float]]:
    """Seconds of whole processes of this project, by what they do."""
    what_is_done = ("--help", "imports", "skeletonize, nothing compiled", "skeletonize, again")
    seconds: dict[str, list[float]] = {what: [] for what in what_is_done}
    environment = {name: value for name, value in os.environ.items() if name != "JAX_COMPILATION_CACHE_DIR"}
    with tempfile.TemporaryDirectory() as folder:
        mesh = Path(folder, "hand.off") if isinstance(source, int) else source.resolve()
        if isinstance(source, int):
            with ProcessPoolExecutor(1, mp_context=SPAWN) as maker:
                maker.submit(write_mesh, source, mesh).result()
        command = ["-m", "msf_jax", "skeletonize", str(mesh), "-o", str(Path(folder, "curve.npz")), "-q"]
        command += ["--float32"] * wanted.float32
        for number in range(wanted.repeats):
            environment["XDG_CACHE_HOME"] = str(Path(folder, f"cache_{number}"))  # where compiled steps go
            help_, imports = ["-m", "msf_jax", "--help"], ["-c", "import msf_jax.flow.loop"]
            for what, arguments in zip(seconds, (help_, imports, command, command), strict=True):
                start, whole = time.perf_counter(), [sys.executable, *arguments]
                subprocess.run(whole, cwd=frame.ROOT, env=environment, check=True, capture_output=True)
                seconds[what].append(time.perf_counter() - start)
    return seconds


def spread(seconds: list[float]) -> list[str]:
    return [f"{value:.3f}" for value in (statistics.median(seconds), min(seconds), max(seconds))]


def seconds_lines(timings: list[Timing]) -> Iterator[str]:
    our_median = next((timing.median for timing in timings if timing.method == OURS and timing.calls), math.nan)
    for timing in timings:
        cells = [timing.mesh, timing.method, f"{timing.vertices:,}"]
        if timing.failure:
            yield line([*cells, timing.failure, *[""] * 8])
            continue
        memory = [f"{value / MB:.0f}" for value in (timing.before, timing.peak, timing.peak - timing.before)]
        ratio = f"{timing.median / our_median:.3f}".replace("nan", "-")
        first = f"{timing.calls[0]:.3f}"
        yield line([*cells, *spread(timing.counted), str(len(timing.counted)), first, ratio, *memory])


def stages(timings: list[Timing]) -> Iterator[str]:
    """Our seconds by stage, medians."""
    names = list(dict.fromkeys(stage for timing in timings for stage in timing.stages[-1]))
    yield f"\n## Seconds of {OURS} by stage, medians\n" + head(["mesh", "vertices", *names])
    for timing in timings:
        runs = timing.stages[1:] or timing.stages
        medians = [statistics.median(run.get(name, 0.0) for run in runs) for name in names]
        yield line([timing.mesh, f"{timing.vertices:,}", *(f"{value:.3f}" for value in medians)])


def growth(hands: list[Timing], methods: list[str]) -> Iterator[str]:
    """How time and memory grow with the number of vertices, by least squares."""
    yield "\n## Growth over the hands\n" + head(["method", "sizes", "exponent of seconds", "bytes per vertex"])
    for method in methods:
        own = [timing for timing in hands if timing.method == method]
        cells = ["-", "-"]
        if len(own) > 1:
            vertices, seconds = np.array([(timing.vertices, timing.median) for timing in own]).T
            exponent = np.polyfit(np.log(vertices), np.log(seconds), 1)[0]
            slope = np.polyfit(vertices, [timing.peak - timing.before for timing in own], 1)[0]
            cells = [f"{exponent:.2f}", f"{slope:,.0f}"]
        yield line([method, str(len(own)), *cells])


def report(wanted: argparse.Namespace) -> Iterator[str]:
    methods = curves.installed(wanted.methods)
    packages = dict.fromkeys(["jax", *(PACKAGES[name] for name in methods if name != OURS)])
    versions = [f"{package} {importlib.metadata.version(package)}" for package in packages]
    yield frame.opening("Speed") + f"\nfloat{32 if wanted.float32 else 64}; {', '.join(versions)}.\n"
    meshes: dict[str, Source] = dict(curves.mesh_files(wanted.meshes))
    meshes = {name: file for name, file in meshes.items() if wanted.only == ["*"] or name in wanted.only}
    meshes |= {f"hand {size:,}": size for size in wanted.sizes}
    if wanted.cold and OURS in methods and meshes:
        name = "homer" if "homer" in meshes else next(iter(meshes))
        yield f"\n## Seconds of whole processes on {name}\n" + head(["", "median", "min", "max", "runs"])
        for what, seconds in start_to_end(meshes[name], wanted).items():
            yield line([what, *spread(seconds), str(len(seconds))])
    columns = "vertices", "median", "min", "max", "runs", "first", "x ours", "before", "peak", "rise"
    yield "\n## Seconds of calls, and memory\n" + head(["mesh", "method", *columns])
    timings: list[Timing] = []
    for name, source in meshes.items():
        timings += (new := measure(name, source, methods, wanted))
        yield from seconds_lines(new)
    done = [timing for timing in timings if not timing.failure]
    if own := [timing for timing in done if timing.method == OURS]:
        yield from stages(own)
    if hands := [timing for timing in done if timing.is_hand]:
        yield from growth(hands, methods)


def main() -> None:
    parser = curves.parser_for("speed", __doc__, [*PACKAGES])
    sizes = [10_000, 30_000, 100_000]
    parser.add_argument("--sizes", type=lambda text: [int(size) for size in text.split(",") if size], default=sizes)
    parser.add_argument("--repeats", type=int, default=5, help="calls of each method on each mesh that count")
    parser.add_argument("--slow", type=float, default=20, help="seconds above which a method is not called again")
    parser.add_argument("--float32", action="store_true", help="compute in float32 instead of float64")
    parser.add_argument("--no-cold", dest="cold", action="store_false", help="no times of whole processes")
    wanted = parser.parse_args()
    frame.publish(report(wanted), wanted.output)


if __name__ == "__main__":
    main()
