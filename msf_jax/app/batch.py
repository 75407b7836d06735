"""Batches: a curve and a report for each of many meshes, on all cores or on a cluster.

For each mesh a batch writes the curve, and then a row with the report or the error; each file is whole at any time. So
a batch that was killed goes on with the meshes that have no row. Meshes are sorted by file size, so that successive
meshes use the same compiled programs.
"""

import csv
import hashlib
import io
import json
import multiprocessing
import os
import signal
import sqlite3
import threading
import time
from collections import deque
from collections.abc import Callable, Generator, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, CancelledError, Executor, ProcessPoolExecutor, wait
from contextlib import AbstractContextManager, closing, contextmanager
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import jax
import numpy as np
from tqdm import tqdm

import msf_jax
from msf_jax.app.shaping import UNCHANGED, Shaping
from msf_jax.base.clock import held_interrupts
from msf_jax.base.errors import ConfigError
from msf_jax.base.options import Config, Weights
from msf_jax.base.version import VERSION
from msf_jax.base.writing import made_folder, write_whole
from msf_jax.flow.loop import checked_options
from msf_jax.meshes import reading
from msf_jax.meshes.repair import Repair, as_repair
from msf_jax.skeleton.formats import writers

MANIFEST = "manifest.csv"  # the table, in the folder of the results
ROWS = ".rows"  # the folder of the rows, likewise
DIED = "its worker died, twice: out of memory?"  # the error in the row of such a mesh

Row = dict[str, Any]
Pool = Callable[[], AbstractContextManager[Executor]]
Settings = tuple[Weights, Config, Repair | None, Shaping, bool]  # the last one: whether to compute in float64


class BatchJob(NamedTuple):
    """One mesh: the paths of its file, curve and row, and a hash of all that the curve depends on."""

    source: str
    target: str
    row: str
    key: str
    settings: Settings


@dataclass(frozen=True)
class BatchResult:
    """rows: one for each mesh of the call. manifest: the table's file, with the rows of earlier batches, too. num_done:
    meshes computed by this call; others had a row already. num_failed: meshes of this call without a curve."""

    rows: tuple[Row, ...] = field(repr=False)
    manifest: Path
    num_done: int
    num_failed: int


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
    shaping: Shaping = UNCHANGED,
    progress: bool = False,
) -> BatchResult:
    """Skeletonise every mesh of ``paths`` into the folder ``out``.

    Args:
        paths: mesh files. Each is done once.
        out: a folder, created if missing. It has the curve ``a/b.off.swc`` of ``a/b.off``, and ``manifest.csv``.
        weights, config, repair: as `skeletonize` takes them; weights are numbers.
        suffix: the format of the curves; see `Skeleton.save`.
        jobs: processes; by default one for each core.
        scheduler: address of a Dask scheduler whose workers see the same folders, in place of processes.
        retry: try failed meshes again, and not only those whose curve is missing or was made with other settings.
        shaping: changes of each curve before it is written: another scale, a tree, other nodes, ...
        progress: show a progress bar on standard error, if that is a terminal.

    Raises:
        ConfigError: an option is out of range, there are no paths, another batch writes to the folder, or an earlier
            one wrote the curve of another mesh to the same file.
        OSError: the folder cannot be written, or the scheduler has ended.
        KeyboardInterrupt: after Ctrl-C, at once. The curves of the meshes that are done and the table are written.
    """
    weights, config = checked_options(weights, config)
    if any(np.ndim(weight) for weight in vars(weights).values()):
        raise ConfigError("a batch takes weights that are numbers: expected no array with one for each vertex")
    writers.writer_for(f"curve{suffix}", shaping.label)  # refuses a wrong suffix before the runs
    if jobs is not None and jobs < 1:
        raise ConfigError(f"jobs is {jobs}: expected a whole number of 1 or more")
    is_double = bool(jax.config.jax_enable_x64)  # type: ignore[attr-defined]
    weights = Weights(*map(float, vars(weights).values()))
    folder, settings = Path(out).absolute(), (weights, config, as_repair(repair), shaping, is_double)
    planned = _planned_jobs(paths, folder, suffix, settings)
    made_folder(folder / ROWS)
    # The lock of an empty database, on every system, ends with this process, however that ends.
    with closing(sqlite3.connect(folder / ROWS / "lock", timeout=0)) as lock:
        try:
            lock.execute("BEGIN EXCLUSIVE")
        except sqlite3.Error:
            raise ConfigError(f"another batch writes to {str(folder)!r}: wait for it, or name another folder") from None
        known = [_known_row(job) for job in planned]
        missing = [job for job, row in zip(planned, known, strict=True) if row is None or (retry and row["error"])]
        num = min(jobs or os.cpu_count() or 1, max(len(missing), 1))
        pool = partial(_cluster, scheduler) if scheduler else partial(_processes, num, is_double)
        try:
            with closing(_finished_jobs(missing, pool, len(missing) if scheduler else 2 * num)) as finished:
                for _ in tqdm(finished, "batch", len(missing), unit="mesh", disable=None if progress else True):
                    pass
        except KeyboardInterrupt:
            num_done = sum(_known_row(job) is not None for job in planned)
            raise KeyboardInterrupt(f"interrupted: {num_done} of {len(planned)} done; start again to go on") from None
        finally:
            _write_table(folder, planned)
    rows = tuple(filter(None, map(_known_row, planned)))
    return BatchResult(rows, folder / MANIFEST, len(missing), sum(bool(row["error"]) for row in rows))


def _planned_jobs(paths: Iterable[Any], folder: Path, suffix: str, settings: Settings) -> list[BatchJob]:
    """A job for each mesh, smallest file first. Names are relative to the folder that all meshes of the call are in."""
    if isinstance(paths, str | os.PathLike):
        raise ConfigError(f"paths is {os.fspath(paths)!r}: expected a list of paths, one for each mesh")
    sources = {Path(os.path.normpath(Path(path).absolute())) for path in paths}
    if not sources:
        raise ConfigError("there are no meshes: expected at least one path")
    base = os.path.commonpath([path.parent for path in sources])
    sized = []
    for path in sources:
        name = str(path.relative_to(base))
        size, stamp = (path.stat().st_size, path.stat().st_mtime_ns) if path.exists() else (0, 0)
        texts = name, f"{name} {size} {stamp} {VERSION} {suffix} {settings}"
        row, key = (hashlib.sha256(os.fsencode(text)).hexdigest()[:32] for text in texts)
        job = BatchJob(str(path), str(folder / (name + suffix)), str(folder / ROWS / f"{row}.json"), key, settings)
        sized.append((size, str(path), job))
    return [job for *_, job in sorted(sized)]


def _read_row(path: str | Path) -> Row | None:
    """The row in a file; None if there is none, or it is damaged."""
    try:
        row = json.loads(Path(path).read_text())
        return row if {"path", "output", "error", "key"} <= set(row) else None
    except (OSError, ValueError, TypeError):
        return None


def _known_row(job: BatchJob) -> Row | None:
    """The row of a mesh that was done with these settings, if its curve exists or it has an error; else None.

    Raises:
        ConfigError: an earlier batch used the same file for another mesh.
    """
    row = _read_row(job.row)
    if row is not None and row["path"] != job.source and os.path.exists(row["path"]):
        raise ConfigError(
            f"{job.target!r} is the curve of {row['path']!r}, by an earlier batch, and would be that of "
            f"{job.source!r}, too: expected another folder for the curves, or both meshes in one batch"
        )
    is_whole = row is not None and row["key"] == job.key and (row["error"] or os.path.exists(job.target))
    return row if is_whole else None


def work(job: BatchJob) -> None:
    """Skeletonise one mesh, in any process. All errors go into its row: a bug of this program ends no batch, either."""
    weights, config, repair, shaping, is_double = job.settings
    start = time.perf_counter()
    row: Row = {"path": job.source, "output": "", "error": "", "key": job.key, "vertices": 0}
    try:
        with jax.enable_x64(is_double):  # of this thread: a worker of a cluster may have others
            mesh = shaping.scaled(reading.read(job.source))
            row["vertices"] = len(mesh[0])
            skeleton = shaping.shaped(msf_jax.skeletonize(mesh, weights, config, repair=repair or False))
            content = writers.writer_for(job.target, shaping.label)(skeleton, mesh)
        report = skeleton.report
        row |= {"nodes": len(skeleton.vertices), "edges": len(skeleton.edges), "length": skeleton.length}
        row |= report.to_dict() | {"is_sound": report.is_sound, "are_limbs": report.are_limbs}
        row |= {"not_limbs": report.not_limbs} | row.pop("figures")
        row |= {name: "; ".join(value) for name, value in row.items() if isinstance(value, list | tuple)}
        made_folder(Path(job.target).parent)
        write_whole(job.target, content)
        row["output"] = job.target
    except Exception as error:
        row["error"] = f"{type(error).__name__}: {error}"
    row["seconds"] = round(time.perf_counter() - start, 3)
    write_whole(job.row, json.dumps(row) + "\n")


def _finished_jobs(jobs: list[BatchJob], pool: Pool, window: int, is_last_try: bool = False) -> Generator[BatchJob]:
    """The jobs whose rows are written, in the order of completion. At most ``window`` jobs are submitted at a time. A
    worker that dies, of too little memory, say, ends its pool: the jobs that were submitted then are tried once more,
    each in a pool of its own."""
    waiting, suspects = deque(jobs), list[BatchJob]()
    while waiting:
        running = {}
        try:
            with pool() as workers:
                while waiting or running:
                    while waiting and len(running) < window:
                        with held_interrupts():  # which a process that is started here inherits
                            running[workers.submit(work, waiting[0])] = waiting[0]
                        waiting.popleft()
                    for future in wait(running, return_when=FIRST_COMPLETED).done:
                        future.result()
                        yield running.pop(future)
        except CancelledError:  # by nobody here
            raise ConnectionError("the Dask scheduler has ended: start it and the batch again to go on") from None
        except Exception as error:  # `work` raises a full disk alone; a cluster that its workers died
            if not isinstance(error, BrokenExecutor) and type(error).__name__ != "KilledWorker":
                raise
            suspects += running.values()
    for job in suspects:
        if is_last_try:
            write_whole(job.row, json.dumps({"path": job.source, "output": "", "error": DIED, "key": job.key}) + "\n")
            yield job
        else:
            yield from _finished_jobs([job], pool, 1, is_last_try=True)


@contextmanager
def _processes(num: int, is_double: bool) -> Iterator[Executor]:
    """A pool of ``num`` processes of this machine. After an error or Ctrl-C they are ended and not waited for."""
    spawning = multiprocessing.get_context("spawn")  # a forked process would lack JAX's threads, and could hang
    others = set(multiprocessing.active_children())
    cache = getattr(jax.config, "jax_compilation_cache_dir", None)
    pool = ProcessPoolExecutor(num, spawning, _begin_worker, (is_double, cache))
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

    def end_with_batch() -> None:
        if (batch := multiprocessing.parent_process()) is not None:
            batch.join()
            os._exit(1)

    threading.Thread(target=end_with_batch, daemon=True).start()
    jax.config.update("jax_enable_x64", is_double)
    msf_jax.cache_compilations(cache)


@contextmanager
def _cluster(scheduler: str) -> Iterator[Executor]:
    """The workers of a Dask cluster, which see the same folders."""
    try:
        from distributed import Client

        client = Client(scheduler, timeout=5)
    except ImportError as error:
        raise ConfigError('a scheduler needs Dask: install it with pip install "msf_jax[dask]"') from error
    except (OSError, ValueError) as error:
        raise ConfigError(f"no Dask scheduler at {scheduler!r}: expected an address such as tcp://host:8786") from error
    with client:
        yield client.get_executor()


def _write_table(folder: Path, planned: list[BatchJob]) -> None:
    """Write the rows of all batches whose curve or, where it has an error, whose mesh is there, sorted by path; but no
    row of ``planned`` that was made with other settings."""
    keys = {Path(job.row).name: job.key for job in planned}
    rows = []
    for path in (folder / ROWS).glob("*.json"):
        row = _read_row(path)
        is_own = row is not None and keys.get(path.name, row["key"]) == row.pop("key")
        if row is not None and is_own and (path.name in keys or os.path.exists(row["output"] or row["path"])):
            rows.append(row)
    text = io.StringIO()
    table = csv.DictWriter(text, list(dict.fromkeys(name for row in rows for name in row)), lineterminator="\n")
    table.writeheader()
    table.writerows(sorted(rows, key=lambda row: row["path"]))
    write_whole(folder / MANIFEST, text.getvalue())
