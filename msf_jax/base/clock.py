"""The clock of a run: the seconds of its stages, and when it has to end, by Ctrl-C or because its time is over; and the
worker thread, which computes what a run asks for later."""

import contextvars
import math
import os
import signal
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager
from typing import Any

GRACE = 1.0  # seconds that a run which has to end has left, to finish the curve so far


def _make_worker() -> None:
    global _worker
    _worker = ThreadPoolExecutor(1, "msf_jax")


_make_worker()
if hasattr(os, "register_at_fork"):  # a forked process has none of the threads
    os.register_at_fork(after_in_child=_make_worker)


class Stopped(BaseException):
    """The run has to end. No code that catches every `Exception` keeps it."""


def begin(function: Callable[..., Any], *arguments: Any) -> Future:
    """Compute on the worker, with the caller's settings of Python and NumPy; here, if the program ends meanwhile."""
    try:
        return _worker.submit(contextvars.copy_context().run, function, *arguments)
    except RuntimeError:  # a run in another thread than the main one, which has ended
        done = Future()
        done.set_result(function(*arguments))
        return done


def begin_in_turn(functions: Sequence[Callable[[], Any]]) -> Future:
    """Call the ``functions`` on the worker, one after the other. What is begun meanwhile, as it is needed first, comes
    before the next one."""
    done = Future()

    def call(number: int) -> None:
        try:
            functions[number]()
            begin(call, number + 1) if number + 1 < len(functions) else done.set_result(None)
        except BaseException as error:
            done.set_exception(error)

    begin(call, 0)
    return done


class Clock:
    """The clock of a run that ends after ``max_seconds``, if given, or after Ctrl-C.

    Attributes:
        seconds: by stage, added up.
        reason: why the run had to end; empty if it had not.
        was_pressed: whether Ctrl-C was pressed.
    """

    def __init__(self, max_seconds: float | None = None) -> None:
        self.seconds: dict[str, float] = {}
        self.reason, self.was_pressed = "", False
        self._end, self._why = math.inf, ""
        if max_seconds is not None:
            self._end, self._why = time.monotonic() + max_seconds, f"max_seconds ({max_seconds:g}) reached"

    @contextmanager
    def listening(self) -> Iterator[None]:
        """In this context the first Ctrl-C ends the run when it asks, and the second one raises KeyboardInterrupt; in
        Python's main thread only, and where no other handler is set."""

        def press(number: int, frame: Any) -> None:
            if self.was_pressed:
                signal.default_int_handler(number, frame)
            self.was_pressed = True
            self._end, self._why = min(self._end, time.monotonic()), "interrupted"

        is_main = threading.current_thread() is threading.main_thread()
        is_own = is_main and signal.getsignal(signal.SIGINT) is signal.default_int_handler
        if is_own:
            signal.signal(signal.SIGINT, press)
        try:
            yield
        finally:
            if is_own:
                signal.signal(signal.SIGINT, signal.default_int_handler)
            self._end = -math.inf  # for what the worker still computes

    @contextmanager
    def stage(self, name: str) -> Iterator[None]:
        """Add the time spent inside to stage ``name``."""
        start = time.perf_counter()
        try:
            yield
        finally:
            self.seconds[name] = self.seconds.get(name, 0.0) + time.perf_counter() - start

    def check(self) -> None:
        """Raise `Stopped` if the run has to end. What follows a first `Stopped` has ``GRACE`` seconds."""
        if time.monotonic() >= self._end:
            if not self.reason:
                self.reason, self._end = self._why, time.monotonic() + GRACE
            raise Stopped


@contextmanager
def held_interrupts() -> Iterator[None]:
    """Hear Ctrl-C only at the end of this context: JAX crashes if its import is interrupted, trimesh hides an interrupt
    of its own, and processes that are started here never hear it."""
    is_main, pressed = threading.current_thread() is threading.main_thread(), list[int]()
    # Other threads may hear what is blocked in this one, and wake its handler.
    handler = signal.signal(signal.SIGINT, lambda number, _: pressed.append(number)) if is_main else None
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT}) if hasattr(signal, "pthread_sigmask") else None
    try:
        yield
    finally:
        if before is not None:
            signal.pthread_sigmask(signal.SIG_SETMASK, before)
        if is_main:
            signal.signal(signal.SIGINT, handler or signal.SIG_DFL)
    if pressed and callable(handler):
        handler(signal.SIGINT, None)
