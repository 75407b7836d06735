"""Compiled iterations, one for each layout: made once in a process, on another thread, and kept from run to run.

XLA takes seconds to compile `iteration.move` and does not hold Python's lock meanwhile, so that a step which is
announced is compiled while the host looks for poles. Where JAX keeps compiled programs in a folder (see
`caching.cache_compilations`), they are kept there a second time, under a name that can be had without tracing them:
everything that they depend on, hashed. JAX's own cache asks for the traced program, which takes longer than to load it.
Whatever is wrong with a file, it is compiled again: the same program, and the same bits.
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
from msf_jax.device.quiet import without_alarm
from msf_jax.host.factors import factored

Program = Callable[[Buffers, Weights], Moved]

KEPT = "steps"  # folder of the programs, inside that of JAX's cache
SAME_FOR_ALL = ("jax_enable_x64", "jax_default_matmul_precision", "jax_debug_nans", "jax_numpy_dtype_promotion")

_programs: dict[Hashable, "Future[Program]"] = {}
_lock = threading.Lock()
_workers = ThreadPoolExecutor(2, "msf_jax-compile")


def compiled_move(settings: StepSettings, layout: Layout, of_vertices: bool) -> Program:
    """`iteration.move` for such settings and layout, as a function of buffers and of weights.

    Weights are scalars or, ``of_vertices``, one value a row. Waits until it is compiled, which takes seconds the first
    time.
    """
    if settings.solver.preconditioner == FACTORED:
        return lambda buffers, weights: move_factored(buffers, weights, settings, layout, factored)
    if jax.config.jax_disable_jit:  # pyright: ignore[reportAttributeAccessIssue]
        return lambda buffers, weights: move(buffers, weights, settings, layout)
    program = _announced(settings, layout, of_vertices)
    if program.exception() is not None:  # a damaged file, most likely: it is compiled after all
        program = _announced(settings, layout, of_vertices)
    return program.result()


def announce(settings: StepSettings, layout: Layout, of_vertices: bool) -> None:
    """Begin to compile what `compiled_move` will be asked for, and do not wait."""
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
    """Trace here, as what JAX is set to can differ from thread to thread; compile on another."""
    lowered = jitted_move.lower(*_arguments(layout, of_vertices), settings, layout)

    def compiled() -> Program:
        program = lowered.compile()
        if file is not None:
            _workers.submit(_keep, file, program, layout, of_vertices)
        return program

    return _workers.submit(compiled)


def _read(file: Path, layout: Layout, of_vertices: bool) -> Program:
    """The program in ``file``; raises whatever a damaged one provokes."""
    data = file.read_bytes()
    if hashlib.sha256(data[32:]).digest() != data[:32]:
        raise ValueError(f"{str(file)!r} is cut short, or damaged")
    return _checked(data[32:], layout, of_vertices)


def _keep(file: Path, program: Any, layout: Layout, of_vertices: bool) -> None:
    """Write the program to ``file``, if what is written can be read: one that came from JAX's own cache cannot."""
    try:
        data = serialize_executable.serialize(program)[0]
        _checked(data, layout, of_vertices)
        file.parent.mkdir(parents=True, exist_ok=True)
        write_whole(file, hashlib.sha256(data).digest() + data)
    except Exception as error:  # the next start takes longer: nothing else depends on it
        if isinstance(error, OSError):
            warnings.warn(f"a compiled step could not be kept in {str(file.parent)!r}: {error}", stacklevel=2)


def _checked(data: bytes, layout: Layout, of_vertices: bool) -> Program:
    """The program that was serialised as ``data``, once it has run on a surface without vertices."""
    ones = jax.tree_util.tree_map(lambda spec: np.ones(spec.shape, spec.dtype), _arguments(layout, of_vertices))
    rings = Rings(*(np.zeros_like(table) for table in ones[0].rings))
    nothing = jax.device_put((ones[0]._replace(free=np.zeros_like(ones[0].free), rings=rings), ones[1]))
    in_tree = jax.tree_util.tree_structure((nothing, {}))
    out_tree = jax.tree_util.tree_structure(Moved(0, SolveReport(0, 0, 0, 0)))  # type: ignore[arg-type]
    with without_alarm():
        program = serialize_executable.deserialize_and_load(data, in_tree, out_tree)
    moved = program(*nothing)
    if not np.array_equal(jax.device_get(moved.positions), ones[0].positions):
        raise ValueError("it moves what is fixed")
    return program


def _arguments(layout: Layout, of_vertices: bool) -> tuple[Buffers, Weights]:
    """Shapes of what a program takes."""
    dtype = real_dtype()

    def table(*shape: int, dtype: Any = dtype) -> Any:  # stands for an array
        return jax.ShapeDtypeStruct(shape, dtype)

    rows, slots = layout.capacity, layout.num_slots
    corner = table(slots, dtype=np.int32)
    rings = Rings(corner, corner, corner, table(slots, dtype=np.bool_))
    column, points = table(rows), table(rows, 3)
    buffers = Buffers(points, rings, column, column, points, column, table(), column)
    weight = column if of_vertices else table()
    return buffers, jax.tree_util.tree_map(lambda _: weight, Weights())


def _file(key: Hashable) -> Path | None:
    """Where a program is kept: by all that it depends on; None where nothing is."""
    folder = getattr(jax.config, "jax_compilation_cache_dir", None)
    if not folder or "://" in str(folder) or not jax.config.jax_enable_compilation_cache:  # type: ignore[attr-defined]
        return None
    return Path(folder, KEPT, hashlib.sha256(repr((_machine(), key)).encode()).hexdigest())


def _device() -> str:
    device = jax.config.jax_default_device or jax.devices()[0]  # type: ignore[attr-defined]
    return repr(device)


@cache
def _machine() -> tuple[str, ...]:
    """Versions, this program's own text, and the processor, which is what code is made for."""
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
