"""Batches: a curve and a report for each of many meshes, on all cores or on a cluster.

For each mesh a batch writes the curve, and then a row with the report or the error, both atomically. So a batch that
was killed continues with the meshes that have no row. An error of one mesh does not affect others. The table of all
rows is written every few seconds, and at the end; see `manifest`. Meshes are sorted by file size, so that successive
meshes use the same compiled capacities. After Ctrl-C no mesh is waited for: the workers end by themselves.
"""

import concurrent.futures
import errno
import hashlib
import json
import os
import time
from collections.abc import Callable, Generator, Iterable, Iterator
from concurrent.futures.process import BrokenProcessPool
from contextlib import closing, contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import jax

import msf_jax
from msf_jax.app.manifest import Manifest
from msf_jax.app.shaping import Shaping, scaled, shaped
from msf_jax.app.workers import Workers, deaf
from msf_jax.base.clock import Clock, Stopped, counted
from msf_jax.base.errors import ConfigError, FlowError, MeshError
from msf_jax.base.options import Config, Weights
from msf_jax.base.progress import showing
from msf_jax.base.version import VERSION
from msf_jax.base.writing import made_folder, write_whole
from msf_jax.device.caching import cache_compilations
from msf_jax.flow.request import checked_options
from msf_jax.meshes import reading
from msf_jax.meshes.repair import Repair, as_repair
from msf_jax.skeleton.formats import export

MANIFEST = "manifest.csv"  # the table, in the folder of the results
ROWS = ".rows"  # the folder of the rows, likewise
TABLE_EVERY = 10.0  # seconds between two writes of the table
TASKS = 1000  # meshes for each worker, on average, until all workers are replaced, which frees their memory
DIED = "its worker died, twice: out of memory?"  # the error in the row of such a mesh
UNCHANGED = Shaping()


@dataclass(frozen=True)
class BatchJob:
    """One mesh and its settings, as plain values that can be sent to another process."""

    source: str
    target: str
    row: str
    key: str
    weights: tuple[float, ...]
    config: Config
    repair: Repair | None
    max_vertices: int
    timeout: float | None
    is_double: bool
    shaping: Shaping
    cache: str


@dataclass(frozen=True)
class BatchResult:
    """The result of a batch.

    rows: one dictionary for each mesh of this call, as in the table. manifest: the table's file, which has the rows of
    other batches into the same folder, too. num_done: meshes computed by this call; the others had a row already.
    """

    rows: tuple[dict[str, Any], ...]
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
            ``manifest.csv``. Several batches may write to one folder, also at the same time: the table has all rows.
        weights, config, repair: as `skeletonize` takes them; weights are numbers.
        suffix: the format of the curves; see `Skeleton.save`.
        jobs: processes; by default one for each core.
        scheduler: address of a Dask scheduler whose workers see the same folders (``pip install "msf_jax[dask]"``). No
            processes are started then.
        retry: try failed meshes again. Otherwise only curves that are missing, or were made with other settings, are
            computed.
        max_vertices: a larger mesh gets an error in its row, because a run needs about 4 kB of memory for each vertex.
        timeout: seconds for each mesh, from its file to its curve's. One that takes longer gets an error in its row;
            ``Config(max_seconds=...)`` keeps the curve so far instead.
        shaping: changes of each curve before it is written: another scale, a tree, other nodes, ...
        progress: show a progress bar on standard error, or plain lines if that is no terminal.

    Raises:
        ConfigError: an option is out of range, a path is given twice, there are no paths, or an earlier batch wrote the
            curve of another mesh to the same file.
        OSError: the folder cannot be written, or the scheduler has ended.
        KeyboardInterrupt: after Ctrl-C, at once; it says how many meshes are done. Their curves and the table are
            written.
    """
    weights, config = checked_options(weights, config)
    if suffix not in export.WRITERS:
        raise ConfigError(f"suffix is {suffix!r}: expected one of {', '.join(export.WRITERS)}")
    for name, value in (("jobs", jobs), ("max_vertices", max_vertices)):
        if value is not None and (isinstance(value, bool) or not isinstance(value, int) or value < 1):
            raise ConfigError(f"{name} is {value!r}: expected a whole number of 1 or more")
    if timeout is not None and (isinstance(timeout, bool) or not isinstance(timeout, int | float) or not timeout > 0):
        raise ConfigError(f"timeout is {timeout!r}: expected seconds, more than 0")
    try:
        numbers = tuple(float(weight) for weight in vars(weights).values())
    except (TypeError, ValueError):
        raise ConfigError(
            "a batch takes weights that are numbers: expected no array with one for each vertex"
        ) from None
    folder = Path(out)
    settings = f"{VERSION} {numbers} {config} {as_repair(repair)} {suffix} {max_vertices}"
    is_double = bool(jax.config.jax_enable_x64)  # type: ignore[attr-defined]
    settings += f" {'float64' if is_double else 'float32'}" + (f" {shaping}" if shaping != UNCHANGED else "")
    shared = (numbers, config, as_repair(repair), max_vertices, timeout, is_double, shaping)
    cache = str(getattr(jax.config, "jax_compilation_cache_dir", None) or (folder / ROWS / "compiled").absolute())
    planned = [BatchJob(*names, *shared, cache) for names in _names(paths, folder, suffix, settings)]
    made_folder(folder / ROWS)
    for job in planned:
        _check_owner(job)
    known = {job.source: _known(job) for job in planned}
    missing = [job for job in planned if (row := known[job.source]) is None or (retry and row["error"])]
    started = _on_cluster(scheduler) if scheduler else _in_processes(jobs or os.cpu_count() or 1)
    manifest = Manifest(
        folder / MANIFEST, folder / ROWS, {Path(job.row).name: (job.key, job.target) for job in planned}
    )
    written, num_done = time.monotonic(), len(planned) - len(missing)
    try:
        shown = showing(len(missing), "batch", "meshes", progress)
        with counted() as presses, started as results, closing(results(missing)) as rows, shown as bar:
            if presses and presses.num:  # in an import, which has kept it
                raise KeyboardInterrupt
            for row in rows:
                num_done += 1
                bar.update(1, Path(row["path"]).name)
                if time.monotonic() - written > TABLE_EVERY:
                    manifest.write()
                    written = time.monotonic()
    except KeyboardInterrupt:
        raise KeyboardInterrupt(f"interrupted: {num_done} of {len(planned)} done; start again to go on") from None
    finally:  # the table is written after Ctrl-C, too
        manifest.complete()
    return BatchResult(tuple(filter(None, map(_known, planned))), manifest.file, len(missing))


def _names(
    paths: Iterable[str | os.PathLike[str]], folder: Path, suffix: str, settings: str
) -> list[tuple[str, str, str, str]]:
    """For each mesh, smallest file first: the paths of mesh, curve and row, and a hash of all inputs of the curve."""
    if isinstance(paths, str | os.PathLike):
        raise ConfigError(f"paths is {os.fspath(paths)!r}: expected a list of paths, one for each mesh")
    sources = [Path(os.path.normpath(Path(path).absolute())) for path in paths]
    if not sources:
        raise ConfigError("there are no meshes: expected at least one path")
    if len(set(sources)) < len(sources):
        twice = next(path for path in sources if sources.count(path) > 1)
        raise ConfigError(f"{str(twice)!r} is given twice: expected each mesh once")
    base = Path(os.path.commonpath([path.parent for path in sources]))
    found = []
    for path in sources:
        name = str(path.relative_to(base))
        state = path.stat() if path.exists() else None
        size, stamp = (state.st_size, state.st_mtime_ns) if state else (0, 0)
        key = hashlib.sha256(os.fsencode(f"{name} {size} {stamp} {settings}")).hexdigest()
        row = folder / ROWS / f"{hashlib.sha256(os.fsencode(name)).hexdigest()[:32]}.json"
        found.append((size, name, (str(path), str((folder / (name + suffix)).absolute()), str(row.absolute()), key)))
    return [names for _, _, names in sorted(found)]


def _check_owner(job: BatchJob) -> None:
    """Raise a `ConfigError` if an earlier batch used the same file for another mesh.

    Names are relative to the folder that all meshes of a call have in common, which can differ between calls.
    """
    try:
        owner = json.loads(Path(job.row).read_text())["path"]
    except (OSError, ValueError, KeyError):
        return
    if owner != job.source and os.path.exists(owner):
        raise ConfigError(
            f"{job.target!r} is the curve of {owner!r}, by an earlier batch, and would be that of "
            f"{job.source!r}, too: expected another folder for the curves, or both meshes in one batch"
        )


def _known(job: BatchJob) -> dict[str, Any] | None:
    """The row of a mesh that was done with these settings, if its curve exists or it has an error; else None."""
    try:
        row = json.loads(Path(job.row).read_text())
    except (OSError, ValueError):
        return None
    is_whole = row.get("key") == job.key and (row["error"] or os.path.exists(job.target))
    return row if is_whole else None


def work(job: BatchJob) -> dict[str, Any]:
    """Skeletonise one mesh, in any process. All errors go into the row, except a full disk, which is raised."""
    jax.config.update("jax_enable_x64", job.is_double)
    if getattr(jax.config, "jax_compilation_cache_dir", None) is None:
        cache_compilations(job.cache)
    start = time.perf_counter()
    row: dict[str, Any] = {"path": job.source, "output": "", "error": "", "key": job.key, "vertices": 0}
    try:
        Clock(job.timeout).call(_skeletonized, job, row)
    except Stopped:
        row["error"] = (
            f"it took more than {job.timeout:g} seconds: expected less, by timeout (--timeout); --retry tries it again"
        )
    except (MeshError, FlowError, ConfigError) as error:
        row["error"] = str(error)
    except Exception as error:  # a bug in this program must not end the batch, either
        if isinstance(error, OSError) and error.errno in (errno.ENOSPC, errno.EDQUOT):
            raise
        row["error"] = f"{type(error).__name__}: {error}"
    row["seconds"] = round(time.perf_counter() - start, 3)
    return _noted(job, row)


def _skeletonized(job: BatchJob, row: dict[str, Any]) -> None:
    """Read one mesh, and write its curve; the figures go into its ``row`` as they are known."""
    mesh = scaled(reading.read(job.source, finite=job.repair is None), job.shaping)
    row["vertices"] = len(mesh[0])
    if len(mesh[0]) > job.max_vertices:
        raise MeshError(f"the mesh has {len(mesh[0])} vertices: expected at most max_vertices, {job.max_vertices}")
    skeleton = msf_jax.skeletonize(mesh, Weights(*job.weights), job.config, repair=job.repair or False)
    skeleton = shaped(skeleton, job.shaping)
    row |= {"nodes": len(skeleton.vertices), "edges": len(skeleton.edges), "length": skeleton.length}
    report = skeleton.report
    row |= report.to_dict() | {"is_sound": report.is_sound, "are_limbs": report.are_limbs}
    row["not_limbs"] = list(report.not_limbs)
    content = export.writer_for(job.target)(skeleton, mesh)
    Path(job.target).parent.mkdir(parents=True, exist_ok=True)
    write_whole(job.target, content)
    row["output"] = job.target


def _noted(job: BatchJob, row: dict[str, Any]) -> dict[str, Any]:
    write_whole(job.row, json.dumps(row) + "\n")
    return row


Results = Callable[[list[BatchJob]], Generator[dict[str, Any], None, None]]


@contextmanager
def _in_processes(num: int) -> Iterator[Results]:
    """Rows, in the order of completion, from ``num`` processes on this machine."""
    processes = Workers()

    def results(jobs: list[BatchJob]) -> Generator[dict[str, Any], None, None]:
        suspects = []
        # Each share has its own pool, because the executor's max_tasks_per_child can hang (CPython issue 115634).
        for first in range(0, len(jobs), TASKS * num):
            share = jobs[first : first + TASKS * num]
            with processes.pool(min(num, len(share))) as pool:
                with deaf():
                    futures = {pool.submit(work, job): job for job in share}
                for future in concurrent.futures.as_completed(futures):
                    try:
                        yield future.result()
                    except BrokenProcessPool:  # one worker died, which ends all workers of the pool
                        suspects.append(futures[future])
        for job in suspects:
            if (row := _known(job)) is None:
                with processes.pool(1) as alone:
                    try:
                        row = alone.submit(work, job).result()
                    except BrokenProcessPool:
                        row = _noted(job, {"path": job.source, "output": "", "error": DIED, "key": job.key})
            yield row

    try:
        yield results
    finally:
        processes.end()


@contextmanager
def _on_cluster(scheduler: str) -> Iterator[Results]:
    """Rows, in the order of completion, from the workers of a Dask cluster."""
    try:
        import distributed
    except ImportError as error:
        raise ConfigError('a scheduler needs Dask: install it with pip install "msf_jax[dask]"') from error
    try:
        client = distributed.Client(scheduler, timeout=5)
    except (OSError, ValueError) as error:
        raise ConfigError(f"no Dask scheduler at {scheduler!r}: expected an address such as tcp://host:8786") from error

    def results(jobs: list[BatchJob]) -> Generator[dict[str, Any], None, None]:
        futures = dict(
            zip(client.map(work, jobs, key=[f"{job.key}-{time.time_ns()}" for job in jobs]), jobs, strict=True)
        )
        for future in distributed.as_completed(futures):
            if future.status == "error" and isinstance(future.exception(), distributed.KilledWorker):
                job = futures[future]
                yield _noted(job, {"path": job.source, "output": "", "error": DIED, "key": job.key})
            elif future.status == "cancelled":  # by nobody here
                raise ConnectionError(
                    f"the Dask scheduler at {scheduler!r} has ended: the curves so far and their rows are written; "
                    "start it again and repeat the batch, which does the rest"
                )
            else:
                yield future.result()

    with client:
        yield results
