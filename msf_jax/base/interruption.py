"""Ctrl-C during a run: delayed until the iteration has ended, so that a partial curve can be returned."""

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType


class Request:
    """Whether Ctrl-C was pressed."""

    is_made = False

    def __bool__(self) -> bool:
        return self.is_made


@contextmanager
def held_back() -> Iterator[Request]:
    """In this context, the first Ctrl-C only sets the request; the second one raises a KeyboardInterrupt.

    It does nothing outside Python's main thread, which alone is interrupted, and does not replace another handler.
    """
    request = Request()
    is_main = threading.current_thread() is threading.main_thread()
    if not is_main or signal.getsignal(signal.SIGINT) is not signal.default_int_handler:
        yield request
        return

    def note(number: int, frame: FrameType | None) -> None:
        if request:
            signal.default_int_handler(number, frame)
        request.is_made = True

    signal.signal(signal.SIGINT, note)
    try:
        yield request
    finally:
        signal.signal(signal.SIGINT, signal.default_int_handler)
