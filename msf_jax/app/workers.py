"""Processes of a batch. They are spawned, hear no Ctrl-C, and end at once when the batch ends or its process dies.

This module imports nothing that is slow, so that a process that still imports JAX ends at once, too.
"""

import multiprocessing
import os
import signal
import threading
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager, suppress
from multiprocessing.connection import Connection

from tqdm import tqdm

PATIENCE = 1.5  # seconds that processes have to end, after which they are no longer waited for


class Workers:
    """Pools of processes that end with this object's `end`."""

    def __init__(self) -> None:
        self._context = multiprocessing.get_context("spawn")  # a forked one would lack JAX's threads, and could hang
        self._until, self._alive = self._context.Pipe(duplex=False)

    @contextmanager
    def pool(self, num: int) -> Iterator[ProcessPoolExecutor]:
        """A pool of ``num`` processes. After an error its waiting and running jobs are dropped."""
        made = ProcessPoolExecutor(num, self._context, _start, (self._until,))
        try:
            yield made
        except BaseException:
            self.end()
            closing = threading.Thread(target=made.shutdown, kwargs={"cancel_futures": True}, daemon=True)
            closing.start()
            closing.join(PATIENCE)
            raise
        made.shutdown()

    def end(self) -> None:
        """End all processes, without waiting for what they do."""
        self._alive.close()


@contextmanager
def deaf() -> Iterator[None]:
    """Processes that are started in this context hear no Ctrl-C, from their first moment. The caller hears it later."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _start(until: Connection) -> None:
    """Ignore Ctrl-C, which a terminal sends to all processes; end when the other end of ``until`` is closed."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    tqdm.set_lock(threading.RLock())  # its own is shared by processes, and would outlive this one

    def watch() -> None:
        with suppress(EOFError, OSError):
            until.recv()
        os._exit(1)

    threading.Thread(target=watch, daemon=True).start()
