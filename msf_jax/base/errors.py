"""The exceptions of this package, one for each kind of cause."""

from typing import Any


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
