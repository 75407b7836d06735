"""Pictures of surfaces, points and curves, and of the progress of a tuning: the public names."""

from msf_jax.skeleton.pictures.panels import Panel, figure, panels, picture
from msf_jax.tuning.picture import trajectory

__all__ = ["Panel", "figure", "panels", "picture", "trajectory"]
