"""Compiled iterations, one for each layout: compiled once in a process, on another thread, and shared by all runs.

XLA takes seconds to compile `iteration.move`, and releases Python's lock meanwhile. So `announce` starts to compile a
step while the host computes poles. If JAX has a folder for compiled programs (see `caching.cache_compilations`), the
steps are also stored there by this module. Their file name is a hash of all that they depend on, so that they are found
without tracing. JAX's own cache needs the traced program, and tracing takes longer than loading. If a file is damaged,
the step is compiled again: the same program, and the same bits.
"""

import hashlib
import importlib.metadata
import os
import platform
import threading
import warnings
from collections.abc import Callable, Hashable
from concurrent.futures import Future, ThreadPoolExecutor
from functools import cache
from pathlib import Path
from typing import Any

import jax
import numpy as np
from jax.experimental import serialize_executable

from msf_jax.base.layout import Layout
from msf_jax.base.options import FACTORED, StepSettings, Weights
from msf_jax.base.writing import write_whole
from msf_jax.device.buffers import Buffers, Rings, real_dtype
from msf_jax.device.cg import SolveReport
from msf_jax.device.iteration import Moved, jitted_move, move, move_factored
from msf_jax.gradients import compiler
from msf_jax.numerics.factors import factored

Program = Callable[[Buffers, Weights], Moved]

KEPT = "steps"  # folder of the programs, in the folder of JAX's cache
# Options of JAX that a program depends on.
SAME_FOR_ALL = ("jax_enable_x64", "jax_default_matmul_precision", "jax_debug_nans", "jax_numpy_dtype_promotion")

# Since jaxlib 0.10.2, XLA on the CPU hands reductions to a library, where those of a step take several times as long. A
# function that is traced in a user's program cannot have options, so a replay there stays slower. Slots written as
# additions need no option, but then jaxlib 0.10.1 computes other bits with two threads than with one.
OPTIONS: dict[str, str | bool] = {"xla_cpu_experimental_ynn_fusion_type": ""}

_programs: dict[Hashable, "Future[Program]"] = {}
_lock = threading.Lock()
_workers = ThreadPoolExecutor(2, "msf_jax-compile")


def compiled_move(
    settings: StepSettings, layout: Layout, of_vertices: bool, wait: Callable[[Future], Any] = Future.exception
) -> Program:
    """`iteration.move` compiled for these settings and layout, as a function of buffers and weights.

    Weights are scalars, or one value for each row (``of_vertices``). The first call waits seconds for the compiler, by
    ``wait``, which returns when a future is done.

    Raises:
        FlowError: the installed compiler computes wrong sums.
    """
    compiler.check()
    if settings.solver.preconditioner == FACTORED:
        return lambda buffers, weights: move_factored(buffers, weights, settings, layout, factored)
    if jax.config.jax_disable_jit:  # pyright: ignore[reportAttributeAccessIssue]
        return lambda buffers, weights: move(buffers, weights, settings, layout)
    program = _announced(settings, layout, of_vertices)
    wait(program)
    if program.exception() is not None:  # probably a damaged file: compile it
        program = _announced(settings, layout, of_vertices)
        wait(program)
    return program.result()


def announce(settings: StepSettings, layout: Layout, of_vertices: bool) -> None:
    """Start to compile the program that `compiled_move` will return, without waiting for it."""
    _workers.submit(compiler.check)  # `compiled_move` calls it again, and gets the error if there is one
    is_jitted = not jax.config.jax_disable_jit  # pyright: ignore[reportAttributeAccessIssue]
    if is_jitted and settings.solver.preconditioner != FACTORED:
        _announced(settings, layout, of_vertices)


def _announced(settings: StepSettings, layout: Layout, of_vertices: bool) -> "Future[Program]":
    flags = tuple(repr(getattr(jax.config, name, None)) for name in SAME_FOR_ALL)
    key = settings, layout, of_vertices, str(real_dtype()), _device(), flags
    with _lock:
        found = _programs.get(key)
        has_failed = found is not None and found.done() and found.exception() is not None
        if found is None or has_failed:
            file = _file(key)
            if file is not None and file.exists() and not has_failed:
                found = _workers.submit(_read, file, layout, of_vertices)
            else:
                found = _begun(file, settings, layout, of_vertices)
            _programs[key] = found
        return found


def _begun(file: Path | None, settings: StepSettings, layout: Layout, of_vertices: bool) -> "Future[Program]":
    """Trace on this thread, because JAX's settings can differ between threads; compile on another."""
    lowered = jitted_move.lower(*_arguments(layout, of_vertices), settings, layout)

    def compiled() -> Program:
        try:
            program = lowered.compile(compiler_options=OPTIONS)
        except jax.errors.JaxRuntimeError:  # this version has no such option
            program = lowered.compile()
        if file is not None:
            _workers.submit(_keep, file, program, layout, of_vertices)
        return program

    return _workers.submit(compiled)


def _read(file: Path, layout: Layout, of_vertices: bool) -> Program:
    """The program in ``file``; a damaged file raises an exception of any type."""
    data = file.read_bytes()
    if hashlib.sha256(data[32:]).digest() != data[:32]:
        raise ValueError(f"{str(file)!r} is truncated or damaged")
    return _checked(data[32:], layout, of_vertices)


def _keep(file: Path, program: Any, layout: Layout, of_vertices: bool) -> None:
    """Write the program to ``file``, if it can be read back. A program from JAX's own cache cannot be."""
    try:
        data = serialize_executable.serialize(program)[0]
        _checked(data, layout, of_vertices)
        file.parent.mkdir(parents=True, exist_ok=True)
        write_whole(file, hashlib.sha256(data).digest() + data)
    except Exception as error:  # without the file the next process compiles again; nothing else depends on it
        if isinstance(error, OSError):
            warnings.warn(f"a compiled step could not be saved in {str(file.parent)!r}: {error}", stacklevel=2)


def _checked(data: bytes, layout: Layout, of_vertices: bool) -> Program:
    """The program that was serialised as ``data``, tested on buffers in which every vertex is fixed."""
    ones = jax.tree_util.tree_map(lambda spec: np.ones(spec.shape, spec.dtype), _arguments(layout, of_vertices))
    rings = Rings(*(np.zeros_like(table) for table in ones[0].rings))
    nothing = jax.device_put((ones[0]._replace(free=np.zeros_like(ones[0].free), rings=rings), ones[1]))
    in_tree = jax.tree_util.tree_structure((nothing, {}))
    out_tree = jax.tree_util.tree_structure(Moved(0, SolveReport(0, 0, 0, 0)))  # type: ignore[arg-type]
    program = serialize_executable.deserialize_and_load(data, in_tree, out_tree)
    moved = program(*nothing)
    if not np.array_equal(jax.device_get(moved.positions), ones[0].positions):
        raise ValueError("the loaded program moves fixed vertices: the file is damaged")
    return program


def _arguments(layout: Layout, of_vertices: bool) -> tuple[Buffers, Weights]:
    """The shapes and types of a program's arguments."""
    dtype = real_dtype()

    def table(*shape: int, dtype: Any = dtype) -> Any:  # an array's shape and type, without values
        return jax.ShapeDtypeStruct(shape, dtype)

    rows, slots = layout.capacity, layout.num_slots
    corner = table(slots, dtype=np.int32)
    rings = Rings(corner, corner, corner, table(slots, dtype=np.bool_))
    column, points = table(rows), table(rows, 3)
    buffers = Buffers(points, rings, column, column, points, column, table(), column)
    weight = column if of_vertices else table()
    return buffers, jax.tree_util.tree_map(lambda _: weight, Weights())


def _file(key: Hashable) -> Path | None:
    """The file of a program, named by a hash of all that it depends on; None if JAX has no cache folder."""
    folder = getattr(jax.config, "jax_compilation_cache_dir", None)
    if not folder or "://" in str(folder) or not jax.config.jax_enable_compilation_cache:  # type: ignore[attr-defined]
        return None
    return Path(folder, KEPT, hashlib.sha256(repr((_machine(), key)).encode()).hexdigest())


def _device() -> str:
    device = jax.config.jax_default_device or jax.devices()[0]  # type: ignore[attr-defined]
    return repr(device)


@cache
def _machine() -> tuple[str, ...]:
    """What compiled code depends on besides its key: versions, the package's source, the processor."""
    device = jax.devices()[0]
    package = Path(__file__).parents[1]
    texts = [*sorted((package / "device").glob("*.py")), package / "base" / "layout.py", Path(__file__)]
    source = hashlib.sha256(b"".join(path.read_bytes() for path in texts)).hexdigest()
    try:
        lines = Path("/proc/cpuinfo").read_text().split("\n\n")[0].splitlines()
        processor = "".join(line for line in lines if line.startswith(("model name", "flags", "Features", "CPU part")))
    except OSError:
        processor = platform.processor() or platform.node()
    kind = device.platform, device.device_kind, str(device.client.platform_version)
    flags = os.environ.get("XLA_FLAGS", ""), os.environ.get("JAX_ENABLE_X64", "")
    versions = tuple(importlib.metadata.version(name) for name in ("jax", "jaxlib", "jaxopt"))
    return *versions, source, platform.machine(), processor, *kind, *flags
