"""The camera of a picture: it looks about along the shortest principal axis, with the longest upright or level."""

from typing import NamedTuple

import numpy as np

EVEN = np.diag([0.02, 0.0, 0.01])  # share of the variance added on x, y, z, to break ties between equal axes
STEEPEST = 89.9  # degrees: the largest elevation; at 90 the up direction is not defined
ALONG = 0.85  # cosine above which a principal axis counts as an axis of the file
STANDS = 1.5  # ratio of height to width above which a shape stands; people have 2 to 4, animals less than 1
ASIDE = np.radians(18.0)  # radians: turn to the side, because from the front one half of a shape can hide the other
ABOVE = np.radians(8.0)  # radians: turn upwards
# The side of the camera for each up axis (x, y, z): CAD looks along y if z is up, games look along -z if y is up.
FRONT = np.array([[0.0, -1.0, 0.5], [0.5, 0.0, 1.0], [0.5, -1.0, 0.0]])


class Camera(NamedTuple):
    """towards: (3,) the direction from the shape to the eye. up: (3,). Both are unit vectors at right angles."""

    towards: np.ndarray
    up: np.ndarray

    @property
    def right(self) -> np.ndarray:
        """(3,) the unit vector to the right."""
        return np.cross(self.up, self.towards)

    def angles(self) -> tuple[float, float, float]:
        """Elevation, azimuth and roll in degrees, as in matplotlib."""
        elevation = np.clip(np.degrees(np.arcsin(np.clip(self.towards[2], -1, 1))), -STEEPEST, STEEPEST)
        azimuth = np.arctan2(self.towards[1], self.towards[0])
        across = np.array([-np.sin(azimuth), np.cos(azimuth), 0.0])  # to the right, without roll
        roll = np.arctan2(self.up @ across, self.up @ np.cross(self.towards, across))
        return float(elevation), float(np.degrees(azimuth)), float(np.degrees(roll))


def looking(vertices: np.ndarray, faces: np.ndarray | None = None) -> Camera:
    """The camera for a surface, or for points (N, 3) if there are no faces.

    In files y or z is up. If the camera looks along z, up is y; along y, up is z. If it looks along x, up is the longer
    of both for a slender shape, such as a person, else the shorter, as for a horse. A shape that is not aligned with
    the file's axes is seen along its own shortest one: its longest axis is level if it is nearest to x, else upright.
    """
    vertices = np.asarray(vertices, dtype=np.float64)
    vertices = vertices / max(float(np.abs(vertices).max(initial=0.0)), 1e-300)  # else squares can overflow
    points, weight = vertices, np.ones(len(vertices))
    if faces is not None and len(faces):
        corner = vertices[faces]
        area = np.linalg.norm(np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]), axis=1)
        if area.sum() > 0:
            points, weight = corner.mean(axis=1), area
    away = points - np.average(points, axis=0, weights=weight)
    away = away / max(float(np.abs(away).max(initial=0.0)), 1e-300)  # else squares can underflow
    spread = (weight[:, None] * away).T @ away
    _, axes = np.linalg.eigh(spread / max(float(np.trace(spread)), 1e-300) + EVEN)
    towards, middle, longest = axes.T
    up = middle if np.abs(longest).argmax() == 0 else longest
    seen_along = int(np.abs(towards).argmax())
    if abs(towards[seen_along]) > ALONG:
        _, y, z = np.ptp(away, axis=0)
        stands = max(y, z) > STANDS * min(y, z)
        of_file = np.eye(3)[(2 if (z > y) == stands else 1, 2, 1)[seen_along]]
        upright = of_file - (of_file @ towards) * towards
        up = upright / np.linalg.norm(upright)
    nearest = int(np.abs(up).argmax())
    up = up * np.sign(up[nearest])
    front = Camera(towards if towards @ FRONT[nearest] >= 0 else -towards, up)
    towards = np.cos(ASIDE) * front.towards + np.sin(ASIDE) * front.right
    return Camera(
        np.cos(ABOVE) * towards + np.sin(ABOVE) * front.up, np.cos(ABOVE) * front.up - np.sin(ABOVE) * towards
    )
