"""Tangent, curvature and torsion of a branch at each of its nodes, from a cubic fitted around the node.

With s the arc length and x(s) the least-squares cubic over the nodes within a few radii,

    tangent x' / |x'|,   curvature |x' x x''| / |x'|^3,   torsion (x' x x'') . x''' / |x' x x''|^2.
"""

from typing import NamedTuple

import numpy as np

from msf_jax.solid.geometry import arc_length, cross, repeated, unit

FIT_REACH = 3.0  # radii: a cubic is fitted to the nodes within this distance along the branch, in both directions
FEWEST_FITTED = 3  # nodes in each direction that a fit uses at least, if the branch has them
STRAIGHT = 0.02  # curvature times reach: below it, torsion is 0, because a straight line has none
NEGLIGIBLE = 1e-9  # share of the largest eigenvalue of a fit: smaller ones, of too few nodes, count as 0


class Frames(NamedTuple):
    """Values at the nodes of a branch. tangent: (n, 3), unit. curvature, torsion: (n,), in 1/length."""

    tangent: np.ndarray
    curvature: np.ndarray
    torsion: np.ndarray


def frames_of(points: np.ndarray, radii: np.ndarray) -> Frames:
    """The frames of a branch through ``points`` (n, 3), n >= 2, in a limb of ``radii`` (n,)."""
    num, along = len(points), arc_length(points)
    index = np.arange(num)
    first, last = np.maximum(index - FEWEST_FITTED, 0), np.minimum(index + FEWEST_FITTED, num - 1)
    reach = np.maximum(FIT_REACH * radii, np.maximum(along - along[first], along[last] - along))
    # A little more, so that the nodes at its ends count whatever the rounding; and more than 0, for nodes in one place.
    reach = np.maximum(1.001 * reach, 1e-12 * max(along[-1], 1e-300))
    begin = np.searchsorted(along, along - reach)
    end = np.searchsorted(along, along + reach, side="right")
    row, k = repeated(end - begin)
    other = begin[row] + k
    away = (along[other] - along[row]) / reach[row]
    weight = np.maximum(1 - away**2, 0.0) ** 2
    power = np.stack([np.ones_like(away), away, away**2, away**3], axis=1)
    starts = np.cumsum(end - begin) - (end - begin)
    left = np.add.reduceat(weight[:, None, None] * power[:, :, None] * power[:, None, :], starts)
    offset = points[other] - points[row]
    right = np.add.reduceat(weight[:, None, None] * power[:, :, None] * offset[:, None, :], starts)
    fit = np.linalg.pinv(left, rcond=NEGLIGIBLE, hermitian=True) @ right
    one, two, three = (
        fit[:, 1] / reach[:, None],
        2 * fit[:, 2] / reach[:, None] ** 2,
        6 * fit[:, 3] / reach[:, None] ** 3,
    )
    binormal = cross(one, two)
    size, speed = np.linalg.norm(binormal, axis=1), np.maximum(np.linalg.norm(one, axis=1), 1e-300)
    curvature = size / speed**3
    is_straight = curvature * reach < STRAIGHT
    torsion = np.einsum("ij,ij->i", binormal, three) / np.where(is_straight, 1.0, size) ** 2
    return Frames(unit(one), curvature, np.where(is_straight, 0.0, torsion))
