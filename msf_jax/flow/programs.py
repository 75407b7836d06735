"""Compiled iterations, one for each layout: compiled once in a process, and shared by all its runs.

A run meets several layouts, and XLA takes seconds for each, without Python's lock. So the later ones are traced and
compiled on the worker, while the first one is compiled and poles are found here. Programs are kept beside JAX's, by
names that need no tracing, which takes longer than to load them.
"""

import hashlib
import os
import pickle
import threading
import zlib
from collections.abc import Callable
from concurrent.futures import Future
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import Any

import jax
import numpy as np
import platformdirs
from jax.experimental import serialize_executable
from jax.experimental.compilation_cache import compilation_cache
from jaxlib import utils, version  # pyright: ignore[reportAttributeAccessIssue]
from llvmlite import binding as llvm

from msf_jax.base.clock import begin
from msf_jax.base.errors import ConfigError
from msf_jax.base.layout import Layout
from msf_jax.base.options import FACTORED, StepSettings, Weights
from msf_jax.base.writing import write_whole
from msf_jax.device import cg
from msf_jax.device.buffers import Buffers, Rings, real_dtype
from msf_jax.device.iteration import Moved, jitted_move, move, move_factored
from msf_jax.numerics.factors import factored

Program = Callable[[Buffers, Weights], Moved]

WORTH_KEEPING = 0.2  # seconds: programs that compile faster are not stored
# Options of JAX that a program depends on.
SAME_FOR_ALL = ("jax_enable_x64", "jax_default_matmul_precision", "jax_debug_nans", "jax_numpy_dtype_promotion")

# Since jaxlib 0.10.2, XLA on the CPU hands reductions to a library, where those of a step take several times as long.
# Slots written as additions need no option, but jaxlib 0.10.1 then computes other bits with two threads than with one.
OPTIONS: dict[str, str | bool] = {"xla_cpu_experimental_ynn_fusion_type": ""}

Key = tuple[StepSettings, Layout, bool, str, Any, tuple[str, ...]]  # what a program depends on, see `_key`
_programs: dict[Key, Program] = {}
_begun: dict[Key, "Future[Program | None]"] = {}  # on the worker
_lock = threading.Lock()

# Events of JAX: a look-up of a program, its end, and that the program was in JAX's cache.
BEGUN, ENDED = "/jax/compilation_cache/compile_requests_use_cache", "/jax/core/compile/backend_compile_duration"
FOUND = "/jax/compilation_cache/cache_hits"
_looking: set[int] = set()  # threads that look a program up
_found: set[int] = set()  # threads whose last one was found


def compiled_move(settings: StepSettings, layout: Layout, of_vertices: bool) -> Program:
    """`iteration.move` compiled for these settings and layout, as a function of buffers and weights: scalars, or one
    value for each row (``of_vertices``). The first call takes seconds."""
    if settings.solver.preconditioner == FACTORED:
        return lambda buffers, weights: move_factored(buffers, weights, settings, layout, factored)
    if jax.config.jax_disable_jit:  # pyright: ignore[reportAttributeAccessIssue]
        return lambda buffers, weights: move(buffers, weights, settings, layout)
    key = _key(settings, layout, of_vertices)
    if key not in _programs:
        with _lock:
            if key not in _programs:
                begun = _begun.pop(key, None)
                _programs[key] = (begun.result() if begun else None) or _compiled(key)
    return _programs[key]


def compile_moves(settings: StepSettings, layouts: list[Layout], of_vertices: bool) -> None:
    """Compile the programs that `compiled_move` returns for ``layouts``: the first one here, others on the worker."""
    if settings.solver.preconditioner != FACTORED and not jax.config.jax_disable_jit:  # pyright: ignore
        for key in (_key(settings, layout, of_vertices) for layout in layouts[1:]):
            if key not in _programs and key not in _begun:
                _begun[key] = begin(_compiled, key)
    compiled_move(settings, layouts[0], of_vertices)


def _compiled(key: Key) -> Any:
    """The program: from its file, or else traced and compiled, and then kept. None on the worker, if the caller's
    thread has other settings of JAX, with which it is traced."""
    settings, layout, of_vertices, _, device, _ = key
    if _key(settings, layout, of_vertices) != key:
        return None
    arguments, path = _arguments(layout, of_vertices), _file(key)
    if path and path.is_file():
        with suppress(Exception):  # of many types, where the file is damaged: then the program is compiled
            data, results = pickle.loads(zlib.decompress(path.read_bytes()))  # zlib has a checksum
            given = jax.tree.structure((arguments, {}))
            _hear(BEGUN)
            program = serialize_executable.deserialize_and_load(data, given, results, execution_devices=[device])
            _hear(ENDED)
            return program
    lowered = jitted_move.lower(*arguments, settings, layout)
    try:
        program = lowered.compile(compiler_options=OPTIONS)
    except jax.errors.JaxRuntimeError:  # this version has no such option
        program = lowered.compile()
    if path and threading.get_ident() not in _found:
        data, _, results = serialize_executable.serialize(program)
        begin(write_whole, path, zlib.compress(pickle.dumps((data, results)), 1))
    return program


def _file(key: Key) -> Path | None:
    """Where the program is kept, in JAX's folder, if it has one. The name is a hash of all that the program depends on,
    so that no other version's is read."""
    package, device, folder = Path(__file__).parents[1], key[4], getattr(jax.config, "jax_compilation_cache_dir", None)
    paths = [__file__, cg.loop.__file__, *package.glob("base/*.py"), *package.glob("device/*.py")]
    sources = b"".join(Path(path).read_bytes() for path in sorted(map(str, paths)))
    versions = jax.__version__, version.__version__, device.client.platform_version, device.device_kind
    machine = llvm.get_host_cpu_name(), llvm.get_host_cpu_features().flatten(), os.environ.get("XLA_FLAGS")
    name = hashlib.sha256(repr((key, versions, machine)).encode() + sources).hexdigest()
    return Path(folder, f"msf_jax-move-{name}") if folder else None


def _key(settings: StepSettings, layout: Layout, of_vertices: bool) -> Key:
    named = jax.config.jax_default_device or jax.devices()[0]  # pyright: ignore[reportAttributeAccessIssue]
    device = jax.devices(named)[0] if isinstance(named, str) else named
    flags = tuple(repr(getattr(jax.config, name, None)) for name in SAME_FOR_ALL)
    return settings, layout, of_vertices, str(real_dtype()), device, flags


def _arguments(layout: Layout, of_vertices: bool) -> tuple[Buffers, Weights]:
    """The shapes and types of a program's arguments."""
    table: Any = partial(jax.ShapeDtypeStruct, dtype=real_dtype())
    number, column, points = table(()), table((layout.capacity,)), table((layout.capacity, 3))
    corner, is_used = (table((layout.num_slots,), dtype=kind) for kind in (np.int32, np.bool_))
    weights = jax.tree.map(lambda _: column if of_vertices else number, Weights())
    rings = Rings(corner, corner, corner, is_used)
    return Buffers(points, rings, column, column, points, column, number, column), weights


def cache_compilations(folder: str | os.PathLike[str] | None = None) -> Path | None:
    """Store compiled programs in ``folder``, beside JAX's: only the first run on a machine compiles. Call it once, at
    the start.

    Args:
        folder: created if missing. The default is the folder that JAX is configured to use, by
            ``JAX_COMPILATION_CACHE_DIR`` or its configuration; else the user's cache folder, such as
            ``~/.cache/msf_jax``. Nobody else should be able to write to it, because the programs in it are executed.

    Returns:
        The folder; None if none was given and the user's cache folder cannot be written to.

    Raises:
        ConfigError: ``folder`` cannot be created or written to.
    """
    configured = getattr(jax.config, "jax_compilation_cache_dir", None)
    if folder is None and configured is not None:
        return Path(configured)
    path = Path(folder) if folder is not None else platformdirs.user_cache_path("msf_jax", appauthor=False)
    with suppress(OSError):
        path.mkdir(parents=True, exist_ok=True)
    if not (path.is_dir() and os.access(path, os.W_OK)):
        if folder is None:
            return None
        raise ConfigError(f"cannot write to {str(path)!r}: expected a folder for compiled programs")
    jax.config.update("jax_compilation_cache_dir", str(path))
    compilation_cache.reset_cache()  # otherwise JAX keeps using its first folder
    jax.config.update("jax_persistent_cache_min_compile_time_secs", WORTH_KEEPING)
    return path


def _hear(event: str, *_: float, **__: Any) -> None:
    """Let XLA print no errors while a program is looked up, and compiled if none is stored: for every stored one, JAX
    0.10 prints two long lines about features that are "not supported on the host machine" (jax issue 38445; JAX 0.12
    does not). Errors of compiling are raised, too. And note what JAX has stored: XLA cannot store that again."""
    thread = threading.get_ident()
    if event == FOUND:
        _found.add(thread)
    elif event == BEGUN:
        _found.discard(thread)
        _looking.add(thread)
        utils.absl_set_min_log_level(3)
    elif event == ENDED:
        _looking.discard(thread)
        if not _looking:
            named = os.environ.get("TF_CPP_MIN_LOG_LEVEL", "")
            utils.absl_set_min_log_level(min(int(named), 3) if named.isdecimal() else 1)


jax.monitoring.register_event_listener(_hear)
jax.monitoring.register_event_duration_secs_listener(_hear)
