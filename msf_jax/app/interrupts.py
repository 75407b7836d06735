"""Ctrl-C that is held back for a moment."""

import signal
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def held_interrupts() -> Iterator[None]:
    """Hear Ctrl-C only at the end of this context. JAX crashes if its import is interrupted, and processes that are
    started here never hear Ctrl-C, which a terminal sends to them, too."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
