"""The clock of a run: the seconds of its stages, and when the run has to end, by Ctrl-C or because its time is over.

Every long stage is a `Clock.call`: it is computed on another thread, while the caller's thread waits and looks at the
clock. So a run ends within a tick, even in a single call of SciPy that takes a minute. The other thread is abandoned:
it is told to end, does so when that call returns, and a process that ends does not wait for it. Work in JAX stays on
the caller's thread, which has the caller's settings of JAX.
"""

import contextvars
import ctypes
import importlib
import math
import signal
import threading
import time
import weakref
from collections.abc import Callable, Iterator
from concurrent.futures import Future, wait
from contextlib import contextmanager, suppress
from types import FrameType
from typing import Any, TypeVar

from msf_jax.base.errors import FlowError

Result = TypeVar("Result")

TICK = 0.05  # seconds between two looks at the clock, while another thread computes
PATIENCE = 1.0  # seconds after which a run that has to end abandons the iteration that it is in
GRACE = 1.0  # seconds that it then has left, to finish the curve so far and to check it
INTERRUPTED = "interrupted"


class Stopped(BaseException):
    """The run has to end. No code that catches every `Exception` keeps it."""


class Work(Future):
    """A call on a daemon thread of its own, and its future result."""

    def __init__(self, function: Callable[..., Any], *arguments: Any) -> None:
        super().__init__()
        context = contextvars.copy_context()  # NumPy's and Python's settings are those of the caller

        def compute() -> None:
            with suppress(Stopped):  # also if it comes late
                try:
                    try:
                        result = context.run(function, *arguments)
                    except BaseException as error:
                        self.set_exception(error)
                    else:
                        self.set_result(result)
                finally:
                    with self._lock:
                        self._is_over = True

        self._lock, self._is_over = threading.Lock(), False
        self._thread = threading.Thread(target=compute, name="msf_jax", daemon=True)
        self._thread.start()

    def end(self) -> None:
        """Raise `Stopped` in the thread, at its next step in Python."""
        with self._lock:  # the number of a thread that has ended can be another thread's
            if not self._is_over:
                self._is_over = True
                number = ctypes.c_ulong(self._thread.ident or 0)
                ctypes.pythonapi.PyThreadState_SetAsyncExc(number, ctypes.py_object(Stopped))


class Presses:
    """A handler of Ctrl-C that counts. The count is kept if other code swallows the KeyboardInterrupt, as an import of
    an optional module, or a destructor, can do. While ``is_held``, the first press is only counted."""

    def __init__(self) -> None:
        self.num, self.is_held, self.first = 0, False, 0.0  # the time of the first one
        self.begun = time.monotonic()

    def __call__(self, number: int, frame: FrameType | None) -> None:
        self.num += 1
        self.first = self.first or time.monotonic()
        if not self.is_held or self.num > 1:
            signal.default_int_handler(number, frame)


@contextmanager
def counted() -> Iterator[Presses | None]:
    """In this context, presses of Ctrl-C are counted, by one counter if contexts are nested.

    It is None outside Python's main thread, which alone is interrupted, and if another handler is there.
    """
    handler = signal.getsignal(signal.SIGINT)
    if threading.current_thread() is not threading.main_thread():
        yield None
    elif isinstance(handler, Presses):
        yield handler
    elif handler is not signal.default_int_handler:
        yield None
    else:
        presses = Presses()
        signal.signal(signal.SIGINT, presses)
        try:
            yield presses
        finally:
            signal.signal(signal.SIGINT, signal.default_int_handler)


def imported(name: str) -> Any:
    """The module ``name``. A Ctrl-C during the import is kept until its end: JAX crashes if its import is interrupted,
    and a callback of JAX's would swallow the KeyboardInterrupt."""
    with counted() as presses:
        if presses is None or presses.is_held:
            return importlib.import_module(name)
        num, presses.is_held = presses.num, True
        try:
            module = importlib.import_module(name)
        finally:
            presses.is_held = False
        if presses.num > num:
            raise KeyboardInterrupt
        return module


class Clock:
    """The clock of a run that ends after ``max_seconds``, if given, or when Ctrl-C is among ``presses``. The seconds
    count from when ``presses`` are counted, so that a command's run counts what the command did before it.

    Attributes:
        seconds: by stage, added up.
        reason: why the run had to end; empty if it had not.
    """

    def __init__(self, max_seconds: float | None = None, presses: Presses | None = None) -> None:
        self.seconds: dict[str, float] = {}
        self.reason, self._presses = "", presses
        self._end, self._why = math.inf, INTERRUPTED
        if max_seconds is not None:
            begun = presses.begun if presses else time.monotonic()
            self._end, self._why = begun + max_seconds, f"max_seconds ({max_seconds:g}) reached"
        self._works: weakref.WeakSet[Work] = weakref.WeakSet()

    @contextmanager
    def holding(self) -> Iterator[None]:
        """In this context, the first Ctrl-C ends the run at its next look at the clock, and the second one at once. At
        the end, all that other threads still compute is abandoned."""
        presses = self._presses or Presses()
        presses.is_held = True
        try:
            yield
        finally:
            presses.is_held = False
            for work in list(self._works):
                work.end()

    @contextmanager
    def tracing(self) -> Iterator[None]:
        """In this context Ctrl-C ends the run at once: JAX traces on this thread, for seconds."""
        presses = self._presses or Presses()
        presses.is_held = False
        try:
            yield
        except KeyboardInterrupt:
            self.check()
            raise
        finally:
            presses.is_held = True

    @contextmanager
    def stage(self, name: str) -> Iterator[None]:
        """Add the time spent inside to stage ``name``."""
        start = time.perf_counter()
        try:
            yield
        finally:
            self.seconds[name] = self.seconds.get(name, 0.0) + time.perf_counter() - start

    @property
    def was_pressed(self) -> bool:
        """Whether Ctrl-C was pressed."""
        return self._presses is not None and self._presses.num > 0

    def check(self, patience: float = 0.0) -> None:
        """Raise `Stopped` if the run had to end ``patience`` seconds ago. What follows then has ``GRACE`` seconds."""
        now = time.monotonic()
        if self._presses and self._presses.num and not self.reason:
            self._end, self._why = min(self._end, self._presses.first), INTERRUPTED
        if now < self._end + patience:
            return
        if not self.reason:
            self.reason, self._end = self._why, now + GRACE
        raise Stopped

    def begin(self, function: Callable[..., Any], *arguments: Any) -> Work:
        """Begin to compute, on another thread, what is asked for later, or never."""
        work = Work(function, *arguments)
        self._works.add(work)
        return work

    def wait(self, future: Future, patience: float = 0.0) -> None:
        """Wait for a result; it raises `Stopped` as `check` does."""
        while not wait([future], TICK).done:
            self.check(patience)

    def call(self, function: Callable[..., Result], *arguments: Any, patience: float = 0.0) -> Result:
        """The result of ``function``; it raises `Stopped` as `check` does, also while the function is computed."""
        if self._presses is None and self._end == math.inf:  # nothing can end this run
            return function(*arguments)
        self.check(patience)
        work = Work(function, *arguments)
        try:
            self.wait(work, patience)
        except BaseException:
            work.end()
            raise
        return work.result()

    def attempt(self, instead: Result, function: Callable[..., Result], *arguments: Any) -> Result:
        """The result of ``function``, or ``instead`` if the run has to end before."""
        try:
            return self.call(function, *arguments)
        except Stopped:
            return instead

    @contextmanager
    def before_curve(self) -> Iterator[None]:
        """In this context there is no curve yet: if the run has to end, the exception says so."""
        try:
            yield
        except Stopped:
            when = "before the first iteration has ended: there is no curve"
            if self.was_pressed:
                raise KeyboardInterrupt(f"interrupted {when} yet") from None
            raise FlowError(f"{self.reason} {when}; expected more seconds") from None
