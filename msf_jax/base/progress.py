"""Progress of a long job: a bar on a terminal, lines of text in a log."""

import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any, TypeVar

from tqdm import tqdm

Item = TypeVar("Item")
EVERY = 10.0  # seconds: the least time between two lines of a log


class Progress:
    """The progress of a job of ``total`` parts, on standard error if ``is_shown``: a bar on a terminal, else lines."""

    def __init__(self, total: int, what: str, unit: str, is_shown: bool):
        is_terminal = sys.stderr is not None and sys.stderr.isatty()
        self._bar: Any = tqdm(total=total, desc=what, unit=unit, disable=not (is_shown and is_terminal))
        self._is_plain = is_shown and not is_terminal and sys.stderr is not None
        self._total, self._what, self._unit = total, what, unit
        self._done, self._last = 0, -EVERY
        self._began = time.monotonic()

    def update(self, num: int = 1, note: str = "") -> None:
        """Count ``num`` more parts as done. ``note`` names them or their result."""
        self._done += num
        self._bar.update(num)
        self._bar.set_postfix_str(note)
        now = time.monotonic() - self._began
        if self._is_plain and (now - self._last >= EVERY or self._done == self._total):
            self._last = now
            tail = f", {note}" if note else ""
            print(
                f"{self._what}: {self._done} of {self._total} {self._unit}, {now:.0f} s{tail}",
                file=sys.stderr,
                flush=True,
            )

    def close(self) -> None:
        self._bar.close()


@contextmanager
def showing(total: int, what: str, unit: str, is_shown: bool) -> Iterator[Progress]:
    """A `Progress` that is closed at the end."""
    made = Progress(total, what, unit, is_shown)
    try:
        yield made
    finally:
        made.close()


def shown(parts: Sequence[Item], what: str, unit: str, is_shown: bool) -> Iterator[Item]:
    """Iterate over ``parts`` with a `Progress`; a part counts as done when the next one is requested."""
    with showing(len(parts), what, unit, is_shown) as bar:
        for part in parts:
            yield part
            bar.update()
