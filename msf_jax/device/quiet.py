"""Removes one known false alarm of XLA from standard error.

For every program that it loads from a file on a CPU, XLA prints two lines of kilobytes each about tuning flags that
are "not supported on the host machine" (jax issue 38445, xla issue 44565). No option that can still be set disables it.
So during the few milliseconds of a load, the standard error of native code goes to a file; afterwards it is passed on
without those lines.
"""

import contextlib
import functools
import importlib
import os
import sys
import tempfile
import threading
from collections.abc import Callable, Iterator
from typing import Any

ALARM = b"cpu_aot_loader"  # occurs in each line of the alarm
LOADER = "jax._src.compilation_cache", "get_executable_and_time"  # JAX's private function that loads a program

_lock = threading.Lock()
_num_loading = 0
_restore: Callable[[], None] | None = None


def quieten_cache() -> bool:
    """Remove the false alarm whenever JAX loads a program in this process. Returns whether JAX has `LOADER`."""
    try:
        module = importlib.import_module(LOADER[0])
        load = getattr(module, LOADER[1])
    except (ImportError, AttributeError):
        return False
    if not getattr(load, "is_quiet", False):

        @functools.wraps(load)
        def quietly(*positional: Any, **named: Any) -> Any:
            with without_alarm():
                return load(*positional, **named)

        quietly.is_quiet = True  # type: ignore[attr-defined]
        setattr(module, LOADER[1], quietly)
    return True


@contextlib.contextmanager
def without_alarm() -> Iterator[None]:
    """Hold back standard error in this context, and pass it on at the end without the alarm. Several threads may be in
    it: the first begins to hold back, and the last passes on."""
    global _num_loading, _restore
    with _lock:
        _num_loading += 1
        if _num_loading == 1:
            _restore = _held_back()
    try:
        yield
    finally:
        with _lock:
            _num_loading -= 1
            if _num_loading == 0:
                _pass_on()


def pass_on() -> None:
    """Pass on what is held back, for a process that ends while another thread loads a program."""
    with _lock:
        _pass_on()


def _pass_on() -> None:
    global _restore
    if _restore is not None:
        _restore()
    _restore = None


def _held_back() -> Callable[[], None] | None:
    """Redirect file descriptor 2 to a file. The returned function undoes that, and passes the file's content on.

    Returns None if standard error is closed.
    """
    try:
        if sys.stderr is not None:
            sys.stderr.flush()
        original = os.dup(2)
    except (OSError, ValueError):  # it is closed
        return None
    held = tempfile.TemporaryFile()  # noqa: SIM115  until it is restored
    os.dup2(held.fileno(), 2)

    def restore() -> None:
        os.dup2(original, 2)
        os.close(original)
        with held:
            held.seek(0)
            rest = b"".join(line for line in held.read().splitlines(keepends=True) if ALARM not in line)
        with contextlib.suppress(OSError):
            os.write(2, rest)

    return restore
