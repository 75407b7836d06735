"""Pictures of surfaces, points, curves and of what `tune` did, in one place for users to import them from."""

from msf_jax.skeleton.pictures.panels import Panel, figure, panels, picture
from msf_jax.tuning.picture import trajectory

__all__ = ["Panel", "figure", "panels", "picture", "trajectory"]
