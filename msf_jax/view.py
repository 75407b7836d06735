"""Pictures of surfaces, points and curves: the public names."""

from msf_jax.skeleton.pictures import Panel, figure, panels, picture

__all__ = ["Panel", "figure", "panels", "picture"]
