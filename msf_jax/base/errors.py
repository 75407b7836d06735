"""The ways in which a call can fail, each for one cause."""

from typing import Any


class MeshError(ValueError):
    """The mesh cannot be skeletonised: says what was found, what was expected and what to do."""


class ConfigError(ValueError):
    """An option or a weight is outside its range, or a name is unknown."""


class FlowError(RuntimeError):
    """The flow broke down on a sound mesh with valid options."""


class Interrupted(KeyboardInterrupt):
    """Ctrl-C in the middle of a run.

    Attributes:
        flow: the `Flow` as far as it went, its curve read off the surface as it was; its report says so.
    """

    def __init__(self, message: str, flow: Any) -> None:
        super().__init__(message)
        self.flow = flow
