"""Numbers as text, for all text formats."""

import numpy as np


def number(value: float) -> str:
    """The shortest text that reads back to the same float64."""
    return repr(float(value))


def point(position: np.ndarray) -> str:
    """The coordinates, separated by spaces."""
    return " ".join(map(number, position))


def plain(line: str) -> str:
    """``line``, safe to print on a terminal: characters that are not printable are escaped."""
    return "".join(one if one.isprintable() else one.encode("unicode_escape").decode() for one in line)
