"""One known false alarm of XLA's kept off standard error, and nothing else, nor for longer than it takes to load.

For every program that it takes from a file on a CPU, XLA prints two lines of kilobytes each about tuning flags that
are "not supported on the host machine" (jax issue 38445, xla issue 44565). It listens to no option that can still be
set. So while one is loaded, a few milliseconds, what native code writes to standard error goes to a file, and is
passed on right after without those lines.
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

ALARM = b"cpu_aot_loader"  # in each of its lines
LOADER = "jax._src.compilation_cache", "get_executable_and_time"  # JAX has no public place to take it at

_lock = threading.Lock()
_num_loading = 0
_restore: Callable[[], None] | None = None


def quieten_cache() -> bool:
    """Keep the false alarm back whenever JAX loads a program, in this process. Returns whether JAX has that place."""
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
    """Hold back what is written to standard error, and pass it on at the end but for the alarm; also in many threads
    at once, of which the first begins and the last ends it."""
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
            if _num_loading == 0 and _restore is not None:
                _restore()


def _held_back() -> Callable[[], None] | None:
    """Let file descriptor 2 lead to a file; the function that is returned undoes that, and passes on what it holds.

    None where it is closed.
    """
    try:
        if sys.stderr is not None:
            sys.stderr.flush()
        original = os.dup(2)
    except (OSError, ValueError):  # closed: nobody would see it
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
