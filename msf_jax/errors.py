"""The three ways in which a call can fail, each for one cause."""


class MeshError(ValueError):
    """The mesh cannot be skeletonised: says what was found, what was expected and what to do."""


class ConfigError(ValueError):
    """An option or a weight is outside its range, or a name is unknown."""


class FlowError(RuntimeError):
    """The flow broke down on a sound mesh with valid options."""
