"""Compiled iterations, one for each layout: compiled once in a process, and shared by all its runs.

A run meets several layouts, and XLA takes seconds for each, without Python's lock. So the later ones are traced and
compiled on the worker, while the first one is compiled and poles are found here.
"""

import os
import threading
from collections.abc import Callable
from concurrent.futures import Future
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import Any

import jax
import numpy as np
import platformdirs
from jax.experimental.compilation_cache import compilation_cache
from jaxlib import utils  # pyright: ignore[reportAttributeAccessIssue]

from msf_jax.base.clock import begin
from msf_jax.base.errors import ConfigError
from msf_jax.base.layout import Layout
from msf_jax.base.options import FACTORED, StepSettings, Weights
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

Key = tuple[StepSettings, Layout, bool, str, str, tuple[str, ...]]  # what a program depends on, see `_key`
_programs: dict[Key, Program] = {}
_begun: dict[Key, "Future[Program | None]"] = {}  # on the worker
_lock = threading.Lock()


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
                _begun[key] = begin(_compiled_alike, key)
    compiled_move(settings, layouts[0], of_vertices)


def _compiled_alike(key: Key) -> Program | None:
    """The program on the worker; None if the caller's thread has other settings of JAX, with which it is traced."""
    return _compiled(key) if _key(*key[:3]) == key else None


def _compiled(key: Key) -> Program:
    settings, layout, of_vertices, *_ = key
    lowered = jitted_move.lower(*_arguments(layout, of_vertices), settings, layout)
    try:
        return lowered.compile(compiler_options=OPTIONS)
    except jax.errors.JaxRuntimeError:  # this version has no such option
        return lowered.compile()


def _key(settings: StepSettings, layout: Layout, of_vertices: bool) -> Key:
    device = jax.config.jax_default_device or jax.devices()[0]  # pyright: ignore[reportAttributeAccessIssue]
    flags = tuple(repr(getattr(jax.config, name, None)) for name in SAME_FOR_ALL)
    return settings, layout, of_vertices, str(real_dtype()), repr(device), flags


def _arguments(layout: Layout, of_vertices: bool) -> tuple[Buffers, Weights]:
    """The shapes and types of a program's arguments."""

    def table(*shape: int, dtype: Any = None) -> Any:
        return jax.ShapeDtypeStruct(shape, real_dtype() if dtype is None else dtype)

    corner, column, points = table(layout.num_slots, dtype=np.int32), table(layout.capacity), table(layout.capacity, 3)
    rings = Rings(corner, corner, corner, table(layout.num_slots, dtype=np.bool_))
    weights = jax.tree.map(lambda _: column if of_vertices else table(), Weights())
    return Buffers(points, rings, column, column, points, column, table(), column), weights


def cache_compilations(folder: str | os.PathLike[str] | None = None) -> Path | None:
    """Let JAX store compiled programs in ``folder``: only the first run on a machine compiles. Call it once, early.

    Args:
        folder: created if missing. The default is the folder that JAX is configured to use, by
            ``JAX_COMPILATION_CACHE_DIR`` or its configuration; else the user's cache folder, such as
            ``~/.cache/msf_jax``. Nobody else should be able to write to it, because the programs in it are executed.

    Returns:
        The folder; None if none was given and the user's cache folder cannot be written to.

    Raises:
        ConfigError: ``folder`` cannot be created or written to.
    """
    _hide_false_alarms()
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
    if configured != str(path):
        jax.config.update("jax_compilation_cache_dir", str(path))
        compilation_cache.reset_cache()  # otherwise JAX keeps using its first folder
    jax.config.update("jax_persistent_cache_min_compile_time_secs", WORTH_KEEPING)
    return path


@cache
def _hide_false_alarms() -> None:
    """Let XLA print no errors while JAX has a program looked up, and compiled if none is stored: for every stored one,
    JAX 0.10 prints two long lines about features that are "not supported on the host machine" (jax issue 38445; JAX
    0.12 does not). Errors of compiling are raised, too."""
    looking: set[int] = set()  # threads
    named = os.environ.get("TF_CPP_MIN_LOG_LEVEL", "")
    usual = min(int(named), 3) if named.isdecimal() else 1

    def begin_lookup(event: str, **_: Any) -> None:
        if event == "/jax/compilation_cache/compile_requests_use_cache":
            looking.add(threading.get_ident())
            utils.absl_set_min_log_level(3)

    def end_lookup(event: str, *_: float, **__: Any) -> None:
        if event == "/jax/core/compile/backend_compile_duration":
            looking.discard(threading.get_ident())
            if not looking:
                utils.absl_set_min_log_level(usual)

    jax.monitoring.register_event_listener(begin_lookup)
    jax.monitoring.register_event_duration_secs_listener(end_lookup)
