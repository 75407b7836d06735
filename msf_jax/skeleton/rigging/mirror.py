"""The mirror plane of a curve, if it has one, and which of its parts are mirror images of each other.

Left is the side with the larger coordinate across the plane: the left of a figure that looks along z with y up, as in
glTF, or along -y with z up, as in Blender.
"""

from typing import NamedTuple

import numpy as np
from scipy import spatial

ALIKE = 0.1  # diagonals of the curve: distance between a part's ends and those of its mirror image, at most
NEAR = 0.04  # diagonals: distance of a mirrored node from the curve, at most, if it counts as matched
BETTER = 0.02  # share of the length: a plane that is tried later must match so much more, so that coordinates win
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
    """The best mirror plane of a curve ``(vertices (N, 3), edges (E, 2))`` with ends ``tips`` (T,).

    Tried are planes across the coordinate axes, and across the principal axes of the curve, as a plane of symmetry is
    across one of these. Each is moved to where it fits best, and counts by the length that has a mirror image; at least
    two tips must be each other's image.
    """
    if len(tips) < 2:
        return None
    used = np.unique(edges)
    points, is_tip = vertices[used], np.isin(used, tips)
    step = np.linalg.norm(vertices[edges[:, 0]] - vertices[edges[:, 1]], axis=1)
    weight = np.bincount(edges.ravel(), np.repeat(step / 2, 2), len(vertices))[used]
    weight /= max(float(weight.sum()), 1e-300)
    size = float(np.linalg.norm(np.ptp(points, axis=0)))
    middle, tree = weight @ points, spatial.KDTree(points)
    principal = np.linalg.eigh((points - middle).T @ ((points - middle) * weight[:, None]))[1].T
    best, found = 0.0, None
    for axis in (*np.eye(3), *principal):  # later ones count only if they are clearly better
        normal = axis * np.sign(axis[np.abs(axis).argmax()])
        tried = _centred(Mirror(normal, float(middle @ normal), size), vertices[tips])
        if tried is None:
            continue
        tried = _fitted(tried, points, weight, is_tip, tree)
        share = float(weight @ (tree.query(tried.flipped(points))[0] < NEAR * size))
        if share > max(best + BETTER, ENOUGH):
            best, found = share, tried
    return found


def _fitted(mirror: Mirror, points: np.ndarray, weight: np.ndarray, is_tip: np.ndarray, tree: spatial.KDTree) -> Mirror:
    """The plane that fits best, so that it does not depend on the axes that were tried. ``weight`` (P,) of ``points``.

    With q the point nearest to the mirror image of p, the sum of w |flip(p) - q|^2 is least where the normal is the
    first eigenvector of the symmetric part of -sum w p q^T, about the means of p and q. Only the better half counts, as
    a limb may be bent on one side, and the tips, without which nothing fixes a plane through a straight trunk. It ends
    when each q is that of an earlier step.
    """
    seen: set[bytes] = set()
    while True:
        away, match = tree.query(mirror.flipped(points))
        if match.tobytes() in seen:
            return mirror
        seen.add(match.tobytes())
        order = np.argsort(away, kind="stable")
        half = away[order[np.searchsorted(np.cumsum(weight[order]), weight.sum() / 2)]]
        share = weight * ((away <= half) | (is_tip & (away < NEAR * mirror.size)))
        middle, partner = share @ points / share.sum(), share @ points[match] / share.sum()
        moment = -((points - middle) * share[:, None]).T @ (points[match] - partner)
        normal = np.linalg.eigh(moment + moment.T)[1][:, -1]
        normal *= np.sign(normal @ mirror.normal) or 1.0
        mirror = mirror._replace(normal=normal, offset=float((middle + partner) @ normal / 2))


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
