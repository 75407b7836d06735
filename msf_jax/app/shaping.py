"""What is changed in a curve before it is written: units, pieces, loops, a root, nodes, radii."""

from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    import numpy as np

    from msf_jax.skeleton.skeleton import Skeleton


class Shaping(NamedTuple):
    """Changes of a curve, which can be sent to another process. Lengths are in the units of the written file: the mesh
    is scaled first.

    scale: factor on the mesh's coordinates. units: name of the unit of length. resample: distance of nodes. simplify:
    the most by which the curve moves while it loses nodes. heal: the longest gap between pieces that is closed. root:
    of a tree, a point, "soma" or "thickest"; None keeps loops. radius: "ball" or "section", see `Skeleton.with_radii`.
    label: as `Skeleton.save` takes it.
    """

    scale: float = 1.0
    units: str = ""
    resample: float | None = None
    simplify: float | None = None
    heal: float | None = None
    root: tuple[float, ...] | str | None = None
    radius: str | None = None
    label: int | None = None

    def scaled(self, mesh: "tuple[np.ndarray, np.ndarray]") -> "tuple[np.ndarray, np.ndarray]":
        return (mesh[0] * self.scale, mesh[1]) if self.scale != 1 else mesh

    def shaped(self, skeleton: "Skeleton") -> "Skeleton":
        """The curve after the other changes: gaps, loops and root, nodes, radii, then the name of the unit."""
        if self.heal is not None:
            skeleton = skeleton.heal(self.heal)
        if self.root is not None:
            skeleton = skeleton.to_tree(None if self.root == "thickest" else self.root)
        if self.resample is not None:
            skeleton = skeleton.resample(self.resample)
        if self.simplify is not None:
            skeleton = skeleton.simplify(self.simplify)
        if self.radius is not None:
            skeleton = skeleton.with_radii(self.radius)
        return replace(skeleton, units=self.units)


UNCHANGED = Shaping()
