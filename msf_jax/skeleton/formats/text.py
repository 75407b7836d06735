"""Numbers as text, for all formats that are text."""

import numpy as np


def number(value: float) -> str:
    """The shortest text that reads back to the same float64."""
    return repr(float(value))


def point(position: np.ndarray) -> str:
    """The coordinates, with a space between."""
    return " ".join(map(number, position))


def plain(line: str) -> str:
    """``line`` as a terminal may see it: what is not to be printed, escapes above all, is spelled out."""
    return "".join(one if one.isprintable() else one.encode("unicode_escape").decode() for one in line)
