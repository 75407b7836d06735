"""The exceptions of this package, one for each kind of cause, and how it warns of old names."""

import sys
import warnings
from typing import Any

OWN = ("msf_jax", "dataclasses", "copy")  # packages whose lines are no user's, in a warning of an old name


class MeshError(ValueError):
    """The mesh cannot be skeletonised. The message says what was found, what was expected and what to do."""


class ConfigError(ValueError):
    """An option or a weight is outside its range, or a name is unknown."""


class FlowError(RuntimeError):
    """The flow failed on a sound mesh with valid options."""


class Interrupted(KeyboardInterrupt):
    """Ctrl-C in the middle of a run.

    Attributes:
        flow: the unfinished `Flow`. Its curve is that of the surface so far, finished as far as the time sufficed; its
            report says that it was interrupted.
    """

    def __init__(self, message: str, flow: Any) -> None:
        super().__init__(message)
        self.flow = flow


def deprecated(message: str) -> None:
    """A `DeprecationWarning` at the line outside of this package, of `dataclasses` and of `copy`, that led here."""
    frame, level = sys._getframe(1), 2  # `warn` counts this function as 1
    while frame.f_back is not None and frame.f_globals.get("__name__", "").split(".")[0] in OWN:
        frame, level = frame.f_back, level + 1
    warnings.warn(message, DeprecationWarning, stacklevel=level)
