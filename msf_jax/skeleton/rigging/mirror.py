"""The mirror plane of a curve, if it has one, and which of its parts are mirror images of each other.

Left is the side with the larger coordinate across the plane: the left of a figure that looks along z with y up, as in
glTF, or along -y with z up, as in Blender.
"""

from typing import NamedTuple

import numpy as np
from scipy import spatial

ALIKE = 0.1  # diagonals of the curve: distance between a part's ends and those of its mirror image, at most
NEAR = 0.04  # diagonals: distance of a mirrored node from the curve, at most, if it counts as matched
BETTER = 0.05  # share of the length: a plane that is tried later must match so much more, so that coordinates win
ENOUGH = 0.6  # share of the curve's length that has a mirror image in a symmetric shape, at least


class Mirror(NamedTuple):
    """The plane of the points x with x . normal = offset. size: the diagonal of the curve."""

    normal: np.ndarray
    offset: float
    size: float

    def height(self, points: np.ndarray) -> np.ndarray:
        """(...,) the signed distance of points (..., 3) from the plane."""
        return points @ self.normal - self.offset

    def flipped(self, points: np.ndarray) -> np.ndarray:
        """(..., 3) the mirror images of points (..., 3)."""
        return points - 2 * self.height(points)[..., None] * self.normal

    def dropped(self, points: np.ndarray) -> np.ndarray:
        """(..., 3) the feet of points (..., 3) on the plane."""
        return points - self.height(points)[..., None] * self.normal


def mirror_of(vertices: np.ndarray, edges: np.ndarray, tips: np.ndarray) -> Mirror | None:
    """The best mirror plane of a curve ``(vertices (N, 3), edges (E, 2))`` whose ends are ``tips`` (T,).

    Tried are planes across the coordinate axes and the curve's principal axes, through its middle. A plane counts by
    the length that has a mirror image, and once more by the part of it that is not in the plane itself; at least two
    tips must be each other's image.
    """
    used = np.unique(edges)
    if len(tips) < 2:
        return None
    points = vertices[used]
    step = np.linalg.norm(vertices[edges[:, 0]] - vertices[edges[:, 1]], axis=1)
    weight = np.bincount(edges.ravel(), np.repeat(step / 2, 2), len(vertices))[used]
    weight /= max(float(weight.sum()), 1e-300)
    size = float(np.linalg.norm(np.ptp(points, axis=0)))
    middle = weight @ points
    axes = np.linalg.svd((points - middle) * np.sqrt(weight)[:, None], full_matrices=False)[2]
    tree = spatial.KDTree(points)
    best, found = 0.0, None
    for axis in np.concatenate([np.eye(3), axes]):  # later ones count only if they are clearly better
        normal = axis * np.sign(axis[np.abs(axis).argmax()])
        height = points @ normal
        for offset in ((height.max() + height.min()) / 2, float(middle @ normal)):
            tried = _centred(Mirror(normal, float(offset), size), vertices[tips])
            if tried is None:
                continue
            is_near = tree.query(tried.flipped(points))[0] < NEAR * size
            is_aside = np.abs(tried.height(points)) > NEAR * size
            share, aside = float(weight @ is_near), float(weight @ (is_near & is_aside))
            if share > ENOUGH and share + aside > best + BETTER:
                best, found = share + aside, tried
    return found


def _centred(mirror: Mirror, tips: np.ndarray) -> Mirror | None:
    """The plane moved to half-way between ``tips`` (T, 3) and their images; None if no two are each other's image."""
    image = images(mirror, tips)
    is_other = (image >= 0) & (image != np.arange(len(tips)))
    if not is_other.any():
        return None
    halfway = (tips[is_other] + tips[image[is_other]]) / 2
    return mirror._replace(offset=float(np.median(halfway @ mirror.normal)))


def images(mirror: Mirror, points: np.ndarray) -> np.ndarray:
    """(P,) the mirror image of each of ``points`` (P, 3), or of each row of several points (P, k, 3).

    It is the nearest to the mirrored one, if both say so and are within `ALIKE`; -1 without one. In the middle it is
    the point itself.
    """
    num = len(points)
    if num == 0:
        return np.empty(0, dtype=np.int64)
    away, image = map(
        np.asarray, spatial.KDTree(points.reshape(num, -1)).query(mirror.flipped(points).reshape(num, -1))
    )
    is_pair = (away < ALIKE * mirror.size) & (image[image] == np.arange(num))
    return np.where(is_pair, image, -1)
