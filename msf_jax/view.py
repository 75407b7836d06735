"""Pictures of surfaces, points and curves: the public names."""

from msf_jax.skeleton.pictures import Panel, panels, picture

__all__ = ["Panel", "panels", "picture"]
