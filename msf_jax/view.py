"""Pictures of surfaces, points and curves, as users import them; they are drawn in `skeleton.pictures`."""

from msf_jax.skeleton.pictures.panels import Panel, figure, panels, picture, trajectory

__all__ = ["Panel", "figure", "panels", "picture", "trajectory"]
