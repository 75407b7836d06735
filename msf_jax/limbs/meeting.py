"""Caps of discs that grow together around several tips, such as the two ends of a hammer's head.

A disc around one end is oblique at the middle of the head, and passes it before its cap is slender enough: so do both.
With the geodesic distances d_i from the tips and the radii r_i, the disc of tip i is where

    min(r_i - d_i, max(d_j - d_i, d_j - r_j) for all j)

is positive: within its own radius, and nearer to its tip than to another one whose disc is there, too.
"""

from typing import NamedTuple

import numpy as np

from msf_jax.limbs import ends
from msf_jax.topology import graphs


class Cap(NamedTuple):
    """tip: a vertex. slenderness, area: of the cap, see `caps`. region: (r,) the cap's vertices."""

    tip: int
    slenderness: float
    area: float
    region: np.ndarray


class Part(NamedTuple):
    """A component of a surface. member: (v,) its vertices. points: (v, 3). faces: (f, 3). share: (v,) their areas."""

    member: np.ndarray
    points: np.ndarray
    faces: np.ndarray
    share: np.ndarray


def grown(part: Part, tips: np.ndarray, away: np.ndarray, radius: np.ndarray, ratio: float) -> list[Cap]:
    """The caps around ``tips`` (t,), with the distances ``away`` (t, v) from them, from the radii ``radius`` (t,) on.

    All radii grow by ``ratio`` while the least slender cap gets more slender.
    """
    found: list[Cap] = []
    while True:
        value = radius[:, None] - away
        for one, other in np.ndindex(len(away), len(away)):
            if one != other:
                beside = np.maximum(away[other] - away[one], away[other] - radius[other])
                value[one] = np.minimum(value[one], beside)
        caps = [inside(part, tip, own) for tip, own in zip(tips.tolist(), value, strict=True)]
        if found and min(cap.slenderness for cap in caps) <= min(cap.slenderness for cap in found):
            return found
        found, radius = caps, ratio * radius


def inside(part: Part, tip: int, value: np.ndarray) -> Cap:
    """The cap around ``tip`` where ``value`` (v,) is positive: all but the largest piece where it is not."""
    tail, head = part.faces.ravel(), np.roll(part.faces, -1, axis=1).ravel()
    is_out = (value[tail] <= 0) & (value[head] <= 0)
    piece = graphs.labels(len(value), tail[is_out], head[is_out])
    is_beyond = piece == np.bincount(piece, np.where(value <= 0, part.share, 0.0)).argmax()
    area = float(part.share[~is_beyond].sum())
    perimeter = ends.zero_line(part.points, part.faces[is_beyond[part.faces].any(axis=1)], value)
    return Cap(tip, 2 * np.pi * area / perimeter**2 - 0.5, area, part.member[~is_beyond])
