"""The frame of a component, in which its surface contracts.

The flow takes thousands of yes-or-no decisions, and CG amplifies a difference in the last bit until some of them
change. So that a mesh that is scaled, shifted, turned by right angles or permuted starts from the same bits, and gives
the same curve, the axes of its frame turn with the mesh, coordinates are rounded to a two-hundredth of the smallest
length that the flow uses (t_f), and vertices and faces are sorted.
"""

from typing import NamedTuple

import numpy as np

from msf_jax.solid.geometry import RESOLUTION


class UnitFrame(NamedTuple):
    """x = centre + diagonal * (y @ axes), for x in the caller's units and y in the frame.

    centre: (3,) of the bounding box. diagonal: its length. axes: (3, 3), a rotation by right angles."""

    centre: np.ndarray
    diagonal: float
    axes: np.ndarray

    def enter(self, points: np.ndarray) -> np.ndarray:
        """Points (P, 3) in the caller's units to the frame, rounded to RESOLUTION."""
        return np.round(((points - self.centre) / self.diagonal) @ self.axes.T / RESOLUTION) * RESOLUTION

    def leave(self, points: np.ndarray) -> np.ndarray:
        """Points (P, 3) of the frame to the caller's units."""
        return self.centre + self.diagonal * (points @ self.axes)


def frame_of(vertices: np.ndarray) -> UnitFrame:
    """The frame of a component with ``vertices`` (V, 3) that do not all coincide.

    The axes are ordered by extent, the largest first, and point to the heavier side of the mesh. For a mesh that is
    symmetric up to the rounding, a moment with one weight a vertex decides instead, which depends on their order."""
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    centre, diagonal = (low + high) / 2, float(np.linalg.norm(high - low))
    scaled = (vertices - centre) / diagonal
    moment = np.cos(np.arange(len(vertices))) @ scaled
    skewness = (np.sort(scaled, axis=0) ** 3).mean(axis=0)
    extent = np.round((high - low) / diagonal / RESOLUTION)
    order = np.lexsort((-np.abs(moment), -extent))
    sign = np.where(np.where(np.abs(skewness) > RESOLUTION / 10, skewness, moment) < 0, -1.0, 1.0)
    axes = sign[order][:, None] * np.eye(3)[order]
    axes[2] *= np.linalg.det(axes)
    return UnitFrame(centre, diagonal, axes)


def sort_mesh(vertices: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The order (V,) of ``vertices`` by x, then y, then z, and the sorted ``faces``, of a closed surface, of these."""
    order = np.lexsort(vertices.T[::-1])
    rank = np.argsort(order)
    renamed = rank[faces]
    first = renamed.argmin(axis=1)[:, None]
    turned = np.take_along_axis(renamed, (first + np.arange(3)) % 3, axis=1)  # the smallest corner first
    return order, turned[np.argsort(turned[:, 0] * len(vertices) + turned[:, 1])]  # no two have the same half-edge
