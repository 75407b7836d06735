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
AS_THICK = 0.5  # ratio of radii, at least, if a node is matched: an arm is no image of a head
UNLIKE = 4.0  # lengths with an image that one without counts for: like front and hind legs make no plane of an animal
FARTHEST_TIPS = 16  # tips: planes are tried between any two of those farthest from the middle
FITS = 20  # steps to the plane that fits best, at most; about ten are enough
SETTLED = 1e-9  # radians: the last turn of the plane
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


def mirror_of(vertices: np.ndarray, edges: np.ndarray, radii: np.ndarray, tips: np.ndarray) -> Mirror | None:
    """The best mirror plane of a curve ``(vertices (N, 3), edges (E, 2))`` with ``radii`` (N,) and ends ``tips`` (T,).

    Tried are planes across the coordinate axes, through its middle, and half-way between any two of its far tips. A
    plane counts by the length beside it that has a mirror image, less `UNLIKE` times the length that has none; at least
    two tips must be each other's image.
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
    tree = spatial.KDTree(points)
    best, found = -np.inf, None
    far = vertices[tips]
    far = far[np.argsort(-np.linalg.norm(far - middle, axis=1), kind="stable")[:FARTHEST_TIPS]]
    one, other = np.triu_indices(len(far), 1)
    centre = (points.max(axis=0) + points.min(axis=0)) / 2
    starts = [
        *zip(np.eye(3), np.tile(centre, (3, 1)), strict=True),
        *zip(np.eye(3), np.tile(middle, (3, 1)), strict=True),
    ]
    starts += zip(far[one] - far[other], (far[one] + far[other]) / 2, strict=True)
    for axis, point in starts:  # later ones count only if they are clearly better
        normal = axis / max(float(np.linalg.norm(axis)), 1e-300) * np.sign(axis[np.abs(axis).argmax()])
        tried = _centred(Mirror(normal, float(point @ normal), size), vertices[tips])
        if tried is None:
            continue
        away, match = tree.query(tried.flipped(points))
        thickness = radii[used] / np.maximum(radii[used][match], 1e-300)
        is_near = (away < NEAR * size) & (thickness > AS_THICK) & (thickness < 1 / AS_THICK)
        is_aside = np.abs(tried.height(points)) > NEAR * size
        share, aside = float(weight @ is_near), float(weight @ (is_near & is_aside))
        score = aside - UNLIKE * (1 - share)
        if share > ENOUGH and score > best + BETTER:
            best, found = score, tried
    return None if found is None else _fitted(found, points, weight, np.isin(used, tips), tree)


def _fitted(mirror: Mirror, points: np.ndarray, weight: np.ndarray, is_tip: np.ndarray, tree: spatial.KDTree) -> Mirror:
    """The plane that fits best, so that it does not depend on the axes that were tried. ``weight`` (P,) of ``points``.

    With q the point nearest to the mirror image of p, the sum of w |flip(p) - q|^2 is least where the normal is the
    first eigenvector of the symmetric part of -sum w p q^T, about the means of p and q. Only the better half counts, as
    a limb may be bent on one side, and the tips, without which nothing fixes a plane through a straight trunk.
    """
    for _ in range(FITS):
        away, match = tree.query(mirror.flipped(points))
        order = np.argsort(away, kind="stable")
        half = away[order[np.searchsorted(np.cumsum(weight[order]), weight.sum() / 2)]]
        share = weight * ((away <= half) | (is_tip & (away < NEAR * mirror.size)))
        middle, partner = share @ points / share.sum(), share @ points[match] / share.sum()
        moment = -((points - middle) * share[:, None]).T @ (points[match] - partner)
        normal = np.linalg.eigh(moment + moment.T)[1][:, -1]
        normal *= np.sign(normal @ mirror.normal) or 1.0
        turn = np.linalg.norm(normal - mirror.normal)
        mirror = mirror._replace(normal=normal, offset=float((middle + partner) @ normal / 2))
        if turn < SETTLED:
            break
    return mirror


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
