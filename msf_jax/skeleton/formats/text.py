"""Numbers as text, for all formats that are text."""

import numpy as np


def number(value: float) -> str:
    """The shortest text that reads back to the same float64."""
    return repr(float(value))


def point(position: np.ndarray) -> str:
    """The coordinates, with a space between."""
    return " ".join(map(number, position))
