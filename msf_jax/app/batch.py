"""Batches: a curve and a report for each of many meshes, on all cores or on a cluster.

For each mesh a batch writes the curve, and then a row with the report or the error; each file is whole at any time. So
a batch that was killed goes on with the meshes that have no row, and an error of one mesh does not affect the others.
The table of all rows is written every few seconds, and at the end. Meshes are sorted by file size, so that successive
meshes use the same compiled programs.
"""

import csv
import errno
import hashlib
import io
import json
import multiprocessing
import os
import signal
import sys
import threading
import time
from collections import deque
from collections.abc import Callable, Generator, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, CancelledError, Executor, ProcessPoolExecutor, wait
from contextlib import AbstractContextManager, closing, contextmanager, suppress
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

import jax

import msf_jax
from msf_jax.app.interrupts import held_interrupts
from msf_jax.app.shaping import UNCHANGED, Shaping, scaled, shaped
from msf_jax.base.errors import ConfigError, FlowError, MeshError
from msf_jax.base.options import Config, Weights
from msf_jax.base.progress import showing
from msf_jax.base.version import VERSION
from msf_jax.base.writing import made_folder, write_whole
from msf_jax.flow.loop import checked_options
from msf_jax.meshes import reading
from msf_jax.meshes.repair import Repair, as_repair
from msf_jax.skeleton.formats import export

MANIFEST = "manifest.csv"  # the table, in the folder of the results
ROWS = ".rows"  # the folder of the rows, likewise
TABLE_EVERY = 10.0  # seconds between two writes of the table
DIED = "its worker died, twice: out of memory?"  # the error in the row of such a mesh

Row = dict[str, Any]
Pool = Callable[[], AbstractContextManager[Executor]]


@dataclass(frozen=True)
class Settings:
    """What all meshes of a batch have in common, as plain values that can be sent to another process."""

    weights: tuple[float, ...]
    config: Config
    repair: Repair | None
    max_vertices: int
    timeout: float | None
    is_double: bool
    shaping: Shaping


@dataclass(frozen=True)
class BatchJob:
    """One mesh: the paths of its file, its curve and its row, a hash of all that the curve depends on, and settings."""

    source: str
    target: str
    row: str
    key: str
    settings: Settings


@dataclass(frozen=True)
class BatchResult:
    """The result of a batch.

    rows: one dictionary for each mesh of this call, as in the table. manifest: the table's file, which has the rows of
    earlier batches into the same folder, too. num_done: meshes computed by this call; the others had a row already.
    """

    rows: tuple[Row, ...]
    manifest: Path
    num_done: int

    def __repr__(self) -> str:
        return f"BatchResult({len(self.rows)} meshes, {self.num_failed} failed, {str(self.manifest)!r})"

    @property
    def num_failed(self) -> int:
        """Meshes without a curve."""
        return sum(bool(row["error"]) for row in self.rows)


def run(
    paths: Iterable[str | os.PathLike[str]],
    out: str | os.PathLike[str],
    *,
    weights: Weights | None = None,
    config: Config | None = None,
    repair: bool | str | Repair = False,
    suffix: str = ".swc",
    jobs: int | None = None,
    scheduler: str | None = None,
    retry: bool = False,
    max_vertices: int = 2_000_000,
    timeout: float | None = None,
    shaping: Shaping = UNCHANGED,
    progress: bool = False,
) -> BatchResult:
    """Skeletonise every mesh of ``paths`` into the folder ``out``.

    Args:
        paths: mesh files, in any format that trimesh reads.
        out: a folder, created if missing. The curve of ``a/b.off`` is ``a/b.off.swc`` in it; all reports are in
            ``manifest.csv``. One batch after another may write to one folder: the table has all rows.
        weights, config, repair: as `skeletonize` takes them; weights are numbers.
        suffix: the format of the curves; see `Skeleton.save`.
        jobs: processes; by default one for each core.
        scheduler: address of a Dask scheduler whose workers see the same folders (``pip install "msf_jax[dask]"``). No
            processes are started then.
        retry: try failed meshes again. Otherwise only curves that are missing, or were made with other settings, are
            computed.
        max_vertices: a larger mesh gets an error in its row, because a run needs about 4 kB of memory for each vertex.
        timeout: seconds for each mesh. The run of one that takes longer is ended, and its row has an error;
            ``Config(max_seconds=...)`` keeps the curve so far instead.
        shaping: changes of each curve before it is written: another scale, a tree, other nodes, ...
        progress: show a progress bar on standard error, or plain lines if that is no terminal.

    Raises:
        ConfigError: an option is out of range, a path is given twice, there are no paths, another batch writes to the
            folder, or an earlier one wrote the curve of another mesh to the same file.
        OSError: the folder cannot be written, or the scheduler has ended.
        KeyboardInterrupt: after Ctrl-C, at once; it says how many meshes are done. Their curves and the table are
            written.
    """
    settings = _checked_settings(weights, config, repair, max_vertices, timeout, shaping)
    if suffix not in export.WRITERS:
        raise ConfigError(f"suffix is {suffix!r}: expected one of {', '.join(export.WRITERS)}")
    _check_whole("jobs", jobs)
    folder = Path(out)
    planned = _planned_jobs(paths, folder, suffix, settings)
    made_folder(folder / ROWS)
    with _locked(folder):
        for job in planned:
            _check_owner(job)
        known = {job: _known_row(job) for job in planned}
        missing = [job for job, row in known.items() if row is None or (retry and row["error"])]
        num_processes = min(jobs or os.cpu_count() or 1, max(len(missing), 1))
        cache = getattr(jax.config, "jax_compilation_cache_dir", None)
        pool = partial(_cluster, scheduler) if scheduler else partial(_processes, num_processes, settings, cache)
        window = len(missing) if scheduler else 2 * num_processes
        written = time.monotonic()
        try:
            shown = showing(len(missing), "batch", "meshes", progress)
            with shown as bar, closing(_finished_jobs(missing, pool, window)) as finished:
                for job in finished:
                    bar.update(1, Path(job.source).name)
                    if time.monotonic() - written > TABLE_EVERY:
                        _write_table(folder, planned)
                        written = time.monotonic()
        except KeyboardInterrupt:
            num_done = sum(_known_row(job) is not None for job in planned)
            raise KeyboardInterrupt(f"interrupted: {num_done} of {len(planned)} done; start again to go on") from None
        finally:
            _write_table(folder, planned)
    return BatchResult(tuple(filter(None, map(_known_row, planned))), folder / MANIFEST, len(missing))


def _check_whole(name: str, value: object) -> None:
    if value is not None and (isinstance(value, bool) or not isinstance(value, int) or value < 1):
        raise ConfigError(f"{name} is {value!r}: expected a whole number of 1 or more")


def _checked_settings(
    weights: Weights | None,
    config: Config | None,
    repair: bool | str | Repair,
    max_vertices: int,
    timeout: float | None,
    shaping: Shaping,
) -> Settings:
    weights, config = checked_options(weights, config)
    _check_whole("max_vertices", max_vertices)
    if timeout is not None and (isinstance(timeout, bool) or not isinstance(timeout, int | float) or not timeout > 0):
        raise ConfigError(f"timeout is {timeout!r}: expected seconds, more than 0")
    try:
        numbers = tuple(float(weight) for weight in vars(weights).values())
    except (TypeError, ValueError):
        raise ConfigError(
            "a batch takes weights that are numbers: expected no array with one for each vertex"
        ) from None
    is_double = bool(jax.config.jax_enable_x64)  # type: ignore[attr-defined]
    return Settings(numbers, config, as_repair(repair), max_vertices, timeout, is_double, shaping)


def _planned_jobs(
    paths: Iterable[str | os.PathLike[str]], folder: Path, suffix: str, settings: Settings
) -> list[BatchJob]:
    """A job for each mesh, smallest file first."""
    if isinstance(paths, str | os.PathLike):
        raise ConfigError(f"paths is {os.fspath(paths)!r}: expected a list of paths, one for each mesh")
    sources = [Path(os.path.normpath(Path(path).absolute())) for path in paths]
    if not sources:
        raise ConfigError("there are no meshes: expected at least one path")
    if len(set(sources)) < len(sources):
        twice = next(path for path in sources if sources.count(path) > 1)
        raise ConfigError(f"{str(twice)!r} is given twice: expected each mesh once")
    base = Path(os.path.commonpath([path.parent for path in sources]))
    of_curve = (
        f"{VERSION} {suffix} {replace(settings, timeout=None)}"  # a curve that is there stays, whatever the timeout
    )
    jobs = []
    for path in sources:
        name = str(path.relative_to(base))
        state = path.stat() if path.exists() else None
        size, stamp = (state.st_size, state.st_mtime_ns) if state else (0, 0)
        row = folder / ROWS / f"{hashlib.sha256(os.fsencode(name)).hexdigest()[:32]}.json"
        key = hashlib.sha256(os.fsencode(f"{name} {size} {stamp} {of_curve}")).hexdigest()
        target = (folder / (name + suffix)).absolute()
        jobs.append((size, name, BatchJob(str(path), str(target), str(row.absolute()), key, settings)))
    return [job for _, _, job in sorted(jobs, key=lambda each: each[:2])]


@contextmanager
def _locked(folder: Path) -> Iterator[None]:
    """Refuse a second batch into the folder meanwhile. The lock ends with this process, however that ends."""
    with open(folder / ROWS / "lock", "a") as file:
        try:
            if sys.platform == "win32":
                import msvcrt

                msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)
            else:
                import fcntl

                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            raise ConfigError(f"another batch writes to {str(folder)!r}: wait for it, or name another folder") from None
        yield


def _check_owner(job: BatchJob) -> None:
    """Raise a `ConfigError` if an earlier batch used the same file for another mesh.

    Names are relative to the folder that all meshes of a call have in common, which can differ between calls.
    """
    row = _read_row(Path(job.row))
    if row is not None and row["path"] != job.source and os.path.exists(row["path"]):
        raise ConfigError(
            f"{job.target!r} is the curve of {row['path']!r}, by an earlier batch, and would be that of "
            f"{job.source!r}, too: expected another folder for the curves, or both meshes in one batch"
        )


def _read_row(path: Path) -> Row | None:
    """The row in a file; None if there is none, or it is damaged."""
    with suppress(OSError, ValueError, TypeError):
        row = json.loads(path.read_text())
        return row if {"path", "output", "error", "key"} <= set(row) else None
    return None


def _known_row(job: BatchJob) -> Row | None:
    """The row of a mesh that was done with these settings, if its curve exists or it has an error; else None."""
    row = _read_row(Path(job.row))
    is_whole = row is not None and row["key"] == job.key and (row["error"] or os.path.exists(job.target))
    return row if is_whole else None


def work(job: BatchJob) -> None:
    """Skeletonise one mesh, in any process. All errors go into the row, except a full disk, which is raised."""
    start, timeout = time.perf_counter(), job.settings.timeout
    row: Row = {"path": job.source, "output": "", "error": "", "key": job.key, "vertices": 0}
    try:
        with jax.enable_x64(job.settings.is_double):  # of this thread: a worker of a cluster may have others
            content = _content_of_curve(job, row)
        if timeout is not None and time.perf_counter() - start > timeout:
            raise FlowError(f"it took more than timeout, {timeout:g} seconds: --retry tries it again")
        Path(job.target).parent.mkdir(parents=True, exist_ok=True)
        write_whole(job.target, content)
        row["output"] = job.target
    except (MeshError, FlowError, ConfigError) as error:
        row["error"] = str(error)
    except Exception as error:  # a bug in this program must not end the batch, either
        if isinstance(error, OSError) and error.errno in (errno.ENOSPC, errno.EDQUOT):
            raise
        row["error"] = f"{type(error).__name__}: {error}"
    row["seconds"] = round(time.perf_counter() - start, 3)
    write_whole(job.row, json.dumps(row) + "\n")


def _content_of_curve(job: BatchJob, row: Row) -> str | bytes:
    """What the curve's file contains; the figures go into the mesh's ``row`` as they are known."""
    asked = job.settings
    mesh = scaled(reading.read(job.source, finite=asked.repair is None), asked.shaping)
    row["vertices"] = len(mesh[0])
    if len(mesh[0]) > asked.max_vertices:
        raise MeshError(f"the mesh has {len(mesh[0])} vertices: expected at most max_vertices, {asked.max_vertices}")
    limits = [seconds for seconds in (asked.config.max_seconds, asked.timeout) if seconds is not None]
    config = replace(asked.config, max_seconds=min(limits, default=None))
    skeleton = msf_jax.skeletonize(mesh, Weights(*asked.weights), config, repair=asked.repair or False)
    skeleton = shaped(skeleton, asked.shaping)
    report = skeleton.report
    row |= {"nodes": len(skeleton.vertices), "edges": len(skeleton.edges), "length": skeleton.length}
    row |= report.to_dict() | {"is_sound": report.is_sound, "are_limbs": report.are_limbs}
    row["not_limbs"] = list(report.not_limbs)
    return export.writer_for(job.target)(skeleton, mesh)


def _finished_jobs(
    jobs: list[BatchJob], pool: Pool, window: int, *, is_second_try: bool = False
) -> Generator[BatchJob]:
    """The jobs whose rows are written, in the order of completion. At most ``window`` jobs are submitted at a time.

    A worker that dies, of too little memory, say, ends its pool. The jobs that were submitted then are tried once more,
    each in a pool of its own, so that a mesh that ends its worker again is known.
    """
    waiting, suspects = deque(jobs), list[BatchJob]()
    while waiting:
        with pool() as workers:
            running = {}
            try:
                while waiting or running:
                    while waiting and len(running) < window:
                        with held_interrupts():  # which a process that is started here inherits
                            running[workers.submit(work, waiting[0])] = waiting[0]
                        waiting.popleft()
                    for future in wait(running, return_when=FIRST_COMPLETED).done:
                        future.result()
                        yield running.pop(future)
            except CancelledError:  # by nobody here
                raise ConnectionError(
                    "the Dask scheduler has ended: the curves so far and their rows are written; start it again and "
                    "repeat the batch, which does the rest"
                ) from None
            except Exception as error:  # `work` raises a full disk alone; a cluster that its workers died
                if not isinstance(error, BrokenExecutor) and type(error).__name__ != "KilledWorker":
                    raise
                suspects += running.values()
    for job in suspects:
        if _known_row(job) is None and not is_second_try:
            yield from _finished_jobs([job], pool, 1, is_second_try=True)
            continue
        if _known_row(job) is None:
            row = {"path": job.source, "output": "", "error": DIED, "key": job.key}
            write_whole(job.row, json.dumps(row) + "\n")
        yield job


@contextmanager
def _processes(num: int, settings: Settings, cache: str | None) -> Iterator[Executor]:
    """A pool of ``num`` processes of this machine. After an error or Ctrl-C they are ended and not waited for."""
    spawning = multiprocessing.get_context("spawn")  # a forked process would lack JAX's threads, and could hang
    others = set(multiprocessing.active_children())
    pool = ProcessPoolExecutor(num, spawning, _begin_worker, (settings.is_double, cache))
    try:
        yield pool
    except BaseException:
        pool.shutdown(wait=False, cancel_futures=True)
        for process in set(multiprocessing.active_children()) - others:
            process.terminate()
        raise
    pool.shutdown()


def _begin_worker(is_double: bool, cache: str | None) -> None:
    """Ignore Ctrl-C, which a terminal sends to all processes; end when the process of the batch ends."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    batch = multiprocessing.parent_process()

    def end_with_batch() -> None:
        if batch is not None:
            batch.join()
            os._exit(1)

    threading.Thread(target=end_with_batch, daemon=True).start()
    jax.config.update("jax_enable_x64", is_double)
    msf_jax.cache_compilations(cache)


@contextmanager
def _cluster(scheduler: str) -> Iterator[Executor]:
    """The workers of a Dask cluster, which see the same folders."""
    try:
        import distributed
    except ImportError as error:
        raise ConfigError('a scheduler needs Dask: install it with pip install "msf_jax[dask]"') from error
    try:
        client = distributed.Client(scheduler, timeout=5)
    except (OSError, ValueError) as error:
        raise ConfigError(f"no Dask scheduler at {scheduler!r}: expected an address such as tcp://host:8786") from error
    with client:
        yield client.get_executor()


def _write_table(folder: Path, planned: list[BatchJob]) -> None:
    """Write the rows of all batches whose curve is there, or whose error and mesh are, sorted by path.

    A row of this batch that was made with other settings is out of date, and is left out. Lists have semicolons.
    """
    keys = {Path(job.row).name: job.key for job in planned}
    rows = []
    for path in (folder / ROWS).glob("*.json"):
        row = _read_row(path)
        if row is None or keys.get(path.name, row["key"]) != row["key"]:
            continue
        if os.path.exists(row["output"] or (folder if path.name in keys else row["path"])):
            rows.append(row)
    rows.sort(key=lambda row: row["path"])
    columns = list(dict.fromkeys(name for row in rows for name in row if name not in ("key", "figures")))
    figures = list(dict.fromkeys(name for row in rows for name in row.get("figures") or {}))
    buffer = io.StringIO()
    writer = csv.writer(buffer, lineterminator="\n")
    writer.writerow([*columns, *figures])
    for row in rows:
        values = [row.get(name, "") for name in columns]
        values += [(row.get("figures") or {}).get(name, "") for name in figures]
        writer.writerow(["; ".join(value) if isinstance(value, list) else value for value in values])
    write_whole(folder / MANIFEST, buffer.getvalue())
