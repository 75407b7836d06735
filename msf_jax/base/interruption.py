"""Ctrl-C during a run: held back until the surface is whole again, so that a partial curve can be given."""

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
    """Within, a first Ctrl-C makes the request true and no more; a second one is a KeyboardInterrupt, as ever.

    Only Python's main thread is ever interrupted, and a handler that is not Python's own keeps its place.
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
