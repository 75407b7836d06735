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


class Patch(NamedTuple):
    """A component of a surface. member: (v,) its vertices. points: (v, 3). faces: (f, 3). area: (f,)."""

    member: np.ndarray
    points: np.ndarray
    faces: np.ndarray
    area: np.ndarray


def grown(part: Patch, tips: np.ndarray, away: np.ndarray, radius: np.ndarray, ratio: float) -> list[Cap]:
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


def inside(part: Patch, tip: int, value: np.ndarray) -> Cap:
    """The cap around ``tip`` where ``value`` (v,) is positive: all but the largest piece where it is not."""
    tail, head = part.faces.ravel(), np.roll(part.faces, -1, axis=1).ravel()
    is_out = (value[tail] <= 0) & (value[head] <= 0)
    piece = graphs.labels(len(value), tail[is_out], head[is_out])
    share = np.bincount(part.faces.ravel(), np.repeat(part.area, 3), len(value))
    is_beyond = piece == np.bincount(piece, np.where(value <= 0, share, 0.0)).argmax()
    # Of a face with one corner on one side, that side has the part s t, if it has the parts s and t of the edges there.
    is_in = ~is_beyond[part.faces]
    count, corner = is_in.sum(axis=1), value[part.faces]
    odd = (is_in == (count == 1)[:, None]).argmax(axis=1)
    p, a, b = (np.take_along_axis(corner, (odd[:, None] + k) % 3, axis=1)[:, 0] for k in range(3))
    is_cut = (count == 1) | (count == 2)
    cut = p**2 / np.where(is_cut, (p - a) * (p - b), 1.0)
    area = float(part.area @ np.where(is_cut, np.where(count == 1, cut, 1 - cut), count == 3))
    perimeter = ends.zero_line(part.points, part.faces[is_cut], value)
    return Cap(tip, 2 * np.pi * area / perimeter**2 - 0.5, area, part.member[~is_beyond])
