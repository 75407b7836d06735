"""The frame that a component is worked on in: centred, of diagonal 1, its axes and digits chosen by the mesh itself.

The flow takes thousands of yes-or-no decisions, and CG amplifies a difference in the last bit until some of them turn
out otherwise. A mesh that is scaled, shifted or turned by right angles differs in last bits only. So the axes are put
in an order, and given signs, that turn with the mesh, and the coordinates are rounded to 2^-20 of the diagonal: both
meshes then start from the same bits, and end in the same curve. The rounding is a two-hundredth of the smallest length
that the flow's defaults look at (t_f).
"""

from typing import NamedTuple

import numpy as np

RESOLUTION = 2.0**-20


class Frame(NamedTuple):
    """x = centre + diagonal * (y @ axes), for x in the caller's units and y in the frame.

    centre: (3,) of the bounding box. diagonal: its length. axes: (3, 3), a rotation by right angles.
    """

    centre: np.ndarray
    diagonal: float
    axes: np.ndarray

    def enter(self, points: np.ndarray) -> np.ndarray:
        """Points (P, 3) of the caller's, in the frame, rounded to RESOLUTION."""
        return np.round(((points - self.centre) / self.diagonal) @ self.axes.T / RESOLUTION) * RESOLUTION

    def leave(self, points: np.ndarray) -> np.ndarray:
        """Points (P, 3) of the frame, in the caller's units."""
        return self.centre + self.diagonal * (points @ self.axes)


def frame_of(vertices: np.ndarray) -> Frame:
    """The frame of a component with ``vertices`` (V, 3) that do not all coincide."""
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    centre, diagonal = (low + high) / 2, float(np.linalg.norm(high - low))
    # A moment with a weight for each vertex, so that it singles out axes even where the shape is symmetric.
    moment = np.cos(np.arange(len(vertices))) @ ((vertices - centre) / diagonal)
    order = np.argsort(-np.abs(moment), kind="stable")
    axes = np.where(moment[order] < 0, -1.0, 1.0)[:, None] * np.eye(3)[order]
    axes[2] *= np.linalg.det(axes)
    return Frame(centre, diagonal, axes)
