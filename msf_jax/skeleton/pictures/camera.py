"""Where a picture is seen from: about along the shortest principal axis, the longest upright or level, head up."""

from typing import NamedTuple

import numpy as np

EVEN = np.diag([0.02, 0.0, 0.01])  # what is as long one way as another lies along x, stands along z, is seen along y
STEEPEST = 89.9  # degrees: straight from above there is no way up
ALONG = 0.85  # cosine at which an axis is that of the file, more or less
LONG = 1.7  # so many times as long as wide has a direction of its own
STANDS = 1.5  # so many times as high as wide is a thing that stands; people are 2 to 4, animals are longer than high
ASIDE, ABOVE = np.radians(18.0), np.radians(8.0)  # straight on, half of what is symmetric hides behind the other half
# From which side, by the axis that is up (x, y, z): CAD looks along y where z is up, games against z where y is.
FRONT = np.array([[0.0, -1.0, 0.5], [0.5, 0.0, 1.0], [0.5, -1.0, 0.0]])


class Camera(NamedTuple):
    """towards: (3,) from what is seen to the eye. up: (3,). Both of length 1, at right angles."""

    towards: np.ndarray
    up: np.ndarray

    @property
    def right(self) -> np.ndarray:
        """(3,)"""
        return np.cross(self.up, self.towards)

    def angles(self) -> tuple[float, float, float]:
        """Elevation, azimuth and roll in degrees, as matplotlib has them."""
        elevation = np.clip(np.degrees(np.arcsin(np.clip(self.towards[2], -1, 1))), -STEEPEST, STEEPEST)
        azimuth = np.arctan2(self.towards[1], self.towards[0])
        across = np.array([-np.sin(azimuth), np.cos(azimuth), 0.0])  # to the right of whoever does not roll
        roll = np.arctan2(self.up @ across, self.up @ np.cross(self.towards, across))
        return float(elevation), float(np.degrees(azimuth)), float(np.degrees(roll))


def looking(vertices: np.ndarray, faces: np.ndarray | None = None) -> Camera:
    """The camera for a surface, or for points (N, 3) if there are no faces.

    Files have y or z up. Seen along z it is y, and seen along y it is z. Seen along x it is the longer of both for what
    is slender, as people are, and the shorter else, as for horses. What lies askew in its file is turned: its longest
    axis is level if that is nearest to x, and upright else.
    """
    vertices = np.asarray(vertices, dtype=np.float64)
    vertices = vertices / max(float(np.abs(vertices).max(initial=0.0)), 1e-300)  # squares of the large are no numbers
    points, weight = vertices, np.ones(len(vertices))
    if faces is not None and len(faces):
        corner = vertices[faces]
        area = np.linalg.norm(np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]), axis=1)
        if area.sum() > 0:
            points, weight = corner.mean(axis=1), area
    away = points - np.average(points, axis=0, weights=weight)
    away = away / max(float(np.abs(away).max(initial=0.0)), 1e-300)  # nor are those of the small
    spread = (weight[:, None] * away).T @ away
    values, axes = np.linalg.eigh(spread / max(float(np.trace(spread)), 1e-300) + EVEN)
    towards, middle, longest = axes.T
    up = middle if np.abs(longest).argmax() == 0 else longest
    seen_along = int(np.abs(towards).argmax())
    if abs(towards[seen_along]) > ALONG:
        _, y, z = np.ptp(away, axis=0)
        stands = max(y, z) > STANDS * min(y, z)
        of_file = np.eye(3)[(2 if (z > y) == stands else 1, 2, 1)[seen_along]]
        upright = of_file - (of_file @ towards) * towards
        upright /= np.linalg.norm(upright)
        is_askew = ALONG > abs(upright @ longest) > np.sqrt(1 - ALONG**2)
        if not (is_askew and values[2] > LONG**2 * values[1]):
            up = upright
    nearest = int(np.abs(up).argmax())
    up = up * np.sign(up[nearest])
    front = Camera(towards if towards @ FRONT[nearest] >= 0 else -towards, up)
    towards = np.cos(ASIDE) * front.towards + np.sin(ASIDE) * front.right
    return Camera(
        np.cos(ABOVE) * towards + np.sin(ABOVE) * front.up, np.cos(ABOVE) * front.up - np.sin(ABOVE) * towards
    )
