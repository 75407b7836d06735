"""How fast and how large: this project beside CGAL, GEL and skeletor, as Markdown tables.

    python -m tests.benchmarks.speed [--only NAME,..] [--sizes VERTICES,..] [--methods NAME,..] [--meshes FOLDER]
        [--repeats N] [--slow SECONDS] [--limit SECONDS] [--float32] [--no-cold] [--output FILE] [--plot FILE]

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
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

import numpy as np
import trimesh

from tests.benchmarks import curves
from tests.benchmarks.curves import OURS, PACKAGES, PEERS, ROOT, line

# A forked process would begin with its parent's memory. A spawned one still inherits the parent's high-water mark: the
# parent therefore imports little and holds no mesh.
PROCESSES = multiprocessing.get_context("spawn")
MB = 1e6
Source = Path | int  # a file, or the number of vertices of a hand


@dataclass
class Timing:
    """One method on one mesh; what there is of it where the method failed."""

    mesh: str
    method: str
    is_hand: bool
    vertices: int = 0
    calls: list[float] = field(default_factory=list)  # seconds, in order
    reports: list[dict[str, Any]] = field(default_factory=list)  # of these calls; ours only
    before: float = math.nan  # bytes
    peak: float = math.nan
    failure: str = ""

    @property
    def counted(self) -> list[float]:
        return self.calls[1:] or self.calls

    @property
    def median(self) -> float:
        return statistics.median(self.counted)


class Worker:
    """A method in a process of its own, which keeps the mesh and computes when it is told to."""

    def __init__(self, timing: Timing, file: Path, wanted: argparse.Namespace) -> None:
        self.timing, self.limit, self.slow = timing, wanted.limit, wanted.slow
        self.connection, theirs = PROCESSES.Pipe()
        arguments = (timing.method, file, wanted.float32, theirs)
        self.process = PROCESSES.Process(target=work, args=arguments, daemon=True)
        self.process.start()
        theirs.close()  # so that the connection ends with the process
        ready = self.answer()
        timing.vertices, timing.before = ready.get("vertices", 0), ready.get("memory", math.nan)

    def answer(self, request: str = "") -> dict[str, Any]:
        """What the process sends, or why it does not."""
        try:
            if request:
                self.connection.send(request)
            if self.connection.poll(self.limit):
                answer = self.connection.recv()
            else:
                answer = {"failure": f"timed out after {self.limit:g} s"}
                self.process.kill()
        except (EOFError, ConnectionError):
            self.process.join()
            answer = {"failure": curves.stopped(self.process.exitcode or 0)}
        self.timing.failure = answer.get("failure", "")
        return answer

    def is_worth_a_call(self) -> bool:
        calls = self.timing.calls[1:] if self.timing.method == OURS else self.timing.calls  # our first one compiles
        return not self.timing.failure and all(seconds <= self.slow for seconds in calls)

    def call(self) -> None:
        timing = self.timing
        answer = self.answer("compute")
        if not timing.failure:
            timing.calls.append(answer["seconds"])
            timing.reports.append(answer["report"])
            timing.peak = answer["memory"]
        print(f"{timing.mesh}, {timing.method}: {timing.failure or f'{timing.calls[-1]:.2f} s'}", file=sys.stderr)

    def close(self) -> None:
        self.connection.close()
        self.process.join()


def work(method: str, file: Path, float32: bool, connection: Connection) -> None:
    """What the process of a worker does."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # what a method prints is no part of the tables
    try:
        call = ours(float32) if method == OURS else peer(method)
        mesh = dict(np.load(file))
        connection.send({"vertices": len(mesh["vertices"]), "memory": high_water_mark()})
        while connection.recv():
            given = {name: values.copy() for name, values in mesh.items()}
            start = time.perf_counter()
            curve = call(**given)
            seconds = time.perf_counter() - start
            report = curve.report.to_dict() if method == OURS else {}
            connection.send({"seconds": seconds, "memory": high_water_mark(), "report": report})
    except EOFError:  # the parent has closed its end
        pass
    except Exception as error:  # a mesh that it cannot do: a row, not the end of the table
        connection.send({"failure": f"{type(error).__name__}: {error}"})


def ours(float32: bool) -> Callable[..., Any]:
    import msf_jax

    curves.configure_jax(float32=float32)
    return lambda vertices, faces: msf_jax.skeletonize((vertices, faces))


def peer(method: str) -> Callable[..., Any]:
    call, module = PEERS[method]
    importlib.import_module(module)
    return call


def high_water_mark() -> int:
    """The most bytes that this process has had resident."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * (1 if sys.platform == "darwin" else 1024)


def hand(vertices: int) -> trimesh.Trimesh:
    """The hand with about so many vertices; with fewer than 10,000 limbs of it may touch."""
    from msf_jax import shapes

    # Above 100,000 by Loop subdivision: a grid would fill the memory.
    rounds = max(0, math.ceil(math.log(vertices / 1e5, 4)))
    mesh = shapes.hand(math.sqrt(22.6 * 4**rounds / vertices))  # 22.6: its vertices times the spacing's square
    for _ in range(rounds):
        mesh = trimesh.Trimesh(*trimesh.remesh.subdivide_loop(mesh.vertices, mesh.faces), process=False)
    return mesh


def write_mesh(source: Source, file: Path) -> None:
    mesh = hand(source) if isinstance(source, int) else trimesh.load(source, process=False)
    if file.suffix == ".npz":
        np.savez(file, vertices=mesh.vertices, faces=mesh.faces)
    else:
        mesh.export(file)


def prepare(source: Source, file: Path) -> None:
    """Make or load a mesh and write it to a file, in a process of its own."""
    maker = PROCESSES.Process(target=write_mesh, args=(source, file))
    maker.start()
    maker.join()


def measure(name: str, source: Source, methods: list[str], wanted: argparse.Namespace) -> list[Timing]:
    """All methods on one mesh, in turn."""
    timings = [Timing(name, method, isinstance(source, int)) for method in methods]
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "mesh.npz")
        prepare(source, file)
        workers = [Worker(timing, file, wanted) for timing in timings]
    for _ in range(1 + wanted.repeats):
        for worker in filter(Worker.is_worth_a_call, workers):
            worker.call()
    for worker in workers:
        worker.close()
    return timings


def start_to_end(source: Source, wanted: argparse.Namespace) -> dict[str, list[float]]:
    """Seconds of whole processes of this project, by what they do."""
    what_is_done = ("--help", "imports", "skeletonize, nothing compiled", "skeletonize, again")
    seconds: dict[str, list[float]] = {what: [] for what in what_is_done}
    environment = {name: value for name, value in os.environ.items() if name != "JAX_COMPILATION_CACHE_DIR"}
    with tempfile.TemporaryDirectory() as folder:
        mesh = Path(folder, "hand.off") if isinstance(source, int) else source.resolve()
        if isinstance(source, int):
            prepare(source, mesh)
        command = ["-m", "msf_jax", "skeletonize", str(mesh), "-o", str(Path(folder, "curve.json")), "-q"]
        command += ["--float32"] * wanted.float32
        for number in range(wanted.repeats):
            environment["XDG_CACHE_HOME"] = str(Path(folder, f"cache_{number}"))  # where compiled steps go
            help_, imports = ["-m", "msf_jax", "--help"], ["-c", "import msf_jax.flow.loop"]
            for what, arguments in zip(seconds, (help_, imports, command, command), strict=True):
                start = time.perf_counter()
                subprocess.run([sys.executable, *arguments], cwd=ROOT, env=environment, check=True, capture_output=True)
                seconds[what].append(time.perf_counter() - start)
                print(f"{what}: {seconds[what][-1]:.2f} s", file=sys.stderr)
    return seconds


def head(first: list[str], *numbers: str) -> str:
    return line([*first, *numbers]) + line(["---"] * len(first) + ["---:"] * len(numbers))


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
    """Our seconds by stage, medians, and our reports."""
    names = list(dict.fromkeys(stage for timing in timings for stage in timing.reports[-1]["seconds"]))
    yield f"\n## Seconds of {OURS} by stage, medians\n\n" + head(["mesh"], "vertices", *names)
    for timing in timings:
        runs = [report["seconds"] for report in timing.reports[1:] or timing.reports]
        medians = [statistics.median(run.get(name, 0.0) for run in runs) for name in names]
        yield line([timing.mesh, f"{timing.vertices:,}", *(f"{value:.3f}" for value in medians)])
    keys = "components", "cycles/genus", "inside", "iterations", "CG steps", "converged"
    yield f"\n## What {OURS} reports\n\n" + head(["mesh"], *keys)
    for timing in timings:
        report = timing.reports[-1]
        counts = ["{components}/{mesh_components}", "{cycles}/{genus}", "{inside:.4f}", "{iterations}", "{solve_steps}"]
        cells = [count.format(**report) for count in counts]
        yield line([timing.mesh, *cells, "yes" if report["converged"] else f"no: {report['reason']}"])


def growth(hands: list[Timing], methods: list[str]) -> Iterator[str]:
    """How time and memory grow with the number of vertices, by least squares."""
    yield "\n## Growth over the hands\n\n" + head(["method"], "sizes", "exponent of seconds", "bytes per vertex")
    for method in methods:
        own = [timing for timing in hands if timing.method == method]
        cells = ["-", "-"]
        if len(own) > 1:
            vertices, seconds = np.array([(timing.vertices, timing.median) for timing in own]).T
            exponent = np.polyfit(np.log(vertices), np.log(seconds), 1)[0]
            slope = np.polyfit(vertices, [timing.peak - timing.before for timing in own], 1)[0]
            cells = [f"{exponent:.2f}", f"{slope:,.0f}"]
        yield line([method, str(len(own)), *cells])


def plot(timings: list[Timing], file: Path) -> None:
    """Seconds against vertices: the hands with lines between them, the other meshes as hollow marks."""
    from matplotlib.figure import Figure

    drawing = Figure(figsize=(8, 5.5), layout="constrained")
    axes = drawing.add_subplot(xscale="log", yscale="log", xlabel="vertices", ylabel="seconds (median, min to max)")
    for number, method in enumerate(PACKAGES):
        look = {"color": f"C{number}", "marker": "osD^v"[number], "markersize": 5}
        if any(timing.method == method for timing in timings):
            axes.plot([], label=method, **look)  # for the legend
        for is_hand, options in ((True, {"ls": "-"}), (False, {"ls": "", "mfc": "none"})):
            own = [timing for timing in timings if (timing.method, timing.is_hand) == (method, is_hand)]
            rows = sorted((t.vertices, t.median, t.median - min(t.counted), max(t.counted) - t.median) for t in own)
            if rows:
                vertices, middle, below, above = zip(*rows, strict=True)
                axes.errorbar(vertices, middle, yerr=(below, above), capsize=2, elinewidth=1, **look, **options)
    axes.grid(which="both", alpha=0.25)
    drawing.legend(loc="outside right upper", title="lines: the hand\nhollow: other meshes")
    part = file.with_name(f"{file.name}.part")
    drawing.savefig(part, format="png", dpi=150)
    part.replace(file)


def report(wanted: argparse.Namespace) -> Iterator[str]:
    methods = curves.installed(wanted.methods)
    yield curves.opening("Speed", wanted.methods, methods)
    packages = dict.fromkeys(["jax", *(PACKAGES[name] for name in methods if name != OURS)])
    versions = [f"{package} {importlib.metadata.version(package)}" for package in packages]
    yield f"\nfloat{32 if wanted.float32 else 64}; {', '.join(versions)}.\n"
    meshes: dict[str, Source] = dict(curves.mesh_files(wanted.meshes))
    meshes = {name: file for name, file in meshes.items() if wanted.only is None or name in wanted.only}
    meshes |= {f"hand {size:,}": size for size in wanted.sizes}
    if wanted.cold and OURS in methods and meshes:
        name = "homer" if "homer" in meshes else next(iter(meshes))
        yield f"\n## Seconds of whole processes on {name}\n\n" + head([""], "median", "min", "max", "runs")
        for what, seconds in start_to_end(meshes[name], wanted).items():
            yield line([what, *spread(seconds), str(len(seconds))])
    columns = "vertices", "median", "min", "max", "runs", "first", "x ours", "before", "peak", "rise"
    yield "\n## Seconds of calls, and memory\n\n" + head(["mesh", "method"], *columns)
    timings: list[Timing] = []
    for name, source in meshes.items():
        timings += (new := measure(name, source, methods, wanted))
        yield from seconds_lines(new)
    done = [timing for timing in timings if not timing.failure]
    if own := [timing for timing in done if timing.method == OURS]:
        yield from stages(own)
    if hands := [timing for timing in done if timing.is_hand]:
        yield from growth(hands, methods)
    if wanted.plot:
        plot(done, wanted.plot)


def main() -> None:
    parser = curves.parser_for("speed", __doc__.splitlines()[0])
    sizes = [10_000, 30_000, 100_000]
    parser.add_argument("--sizes", type=lambda text: [int(size) for size in text.split(",") if size], default=sizes)
    parser.add_argument("--repeats", type=int, default=5, help="calls of each method on each mesh that count")
    parser.add_argument("--slow", type=float, default=20, help="seconds above which a method is not called again")
    parser.add_argument("--float32", action="store_true", help="compute in float32 instead of float64")
    parser.add_argument("--no-cold", dest="cold", action="store_false", help="no times of whole processes")
    parser.add_argument("--plot", type=Path, help="PNG file for seconds against vertices")
    wanted = parser.parse_args()
    if wanted.plot:
        wanted.plot.parent.mkdir(parents=True, exist_ok=True)
    curves.publish(report(wanted), wanted.output)


if __name__ == "__main__":
    main()
