"""The apex of a mitre, where two bars meet in an acute corner: it looks like a limb, and is the outside of a bend.

A disc around the apex grows until its front divides into two rings, around the two bars. Let lines along their axes,
in the unit directions d and e from the corner, pass each other at p, and let u = -(d + e) / |d + e|. Beyond p the solid
of a mitre is where both bars go on:

    (x - p) . u > 0   only for x within the section of each bar, moved along its axis.

A limb sticks out of one of them. If it does so by h in the direction u, a point at its end is h sin(a / 2) outside the
sides of bars that meet at the angle a.
"""

import numpy as np

from msf_jax.limbs import ends
from msf_jax.limbs.levels import Levels, levels
from msf_jax.solid import sections
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import ROUNDING, cross, unit

STEP = 0.1  # of their distance from the tip: rings of the front are that far apart
WIDER = 3  # rings that are compared: fewer apart, their lengths are noise of the triangles
RINGS = 6  # of a bar beyond the corner, over almost the distance from the tip to the corner


def is_apex(shape: Enclosure, away: np.ndarray, region: np.ndarray, least: float) -> bool:
    """Whether the cap ``region`` (r,) of the solid ``shape`` is the apex of a mitre, and no limb that sticks out of the
    bars there by ``least`` of their half widths. ``away`` (V,) is the distance from the cap's tip."""
    first = last = float(away[region].max())
    while True:
        last *= np.exp(STEP * RINGS)
        near, local = np.unique(shape.faces[(away < last)[shape.faces].any(axis=1)], return_inverse=True)
        height = np.log(np.clip(away[near], first / 2, last)) / STEP
        found = levels(shape.vertices[near], local.reshape(-1, 3), height, 1.0)
        pieces, rings, arms = _followed(found, int(found.piece[away[near].argmin()]))
        if arms and len(rings) < 2 * WIDER:  # the cap reaches beyond
            first, last = first / 2, last / np.exp(STEP * RINGS)
            continue
        if not _is_widening(found.perimeter[rings]):
            return False
        if arms and len(rings) + RINGS <= np.log(2 * last / first) / STEP:
            apex = shape.vertices[near[np.isin(found.piece, pieces)]]
            return len(arms) == 2 and min(map(len, arms)) > 1 and _is_in_both(shape, found, arms, apex, least)
        if last >= away[np.isfinite(away)].max():
            return False


def _above(found: Levels, piece: int) -> np.ndarray:
    """The rings upon a piece, without those around bumps."""
    above = np.flatnonzero(found.below == piece)
    return above[found.perimeter[above] > ends.HALF * found.perimeter[above].max(initial=0.0)]


def _followed(found: Levels, piece: int) -> tuple[list[int], list[int], list[list[int]]]:
    """Where the front goes from ``piece`` on: its pieces and rings up to where it divides, and the rings of each of
    the parts beyond, up to the narrowest."""
    pieces, rings = [piece], []
    while len(above := _above(found, pieces[-1])) == 1:
        rings.append(int(above[0]))
        pieces.append(int(found.above[above[0]]))
    arms = [[ring] for ring in above.tolist()]
    for arm in arms:
        while len(arm) < RINGS and len(above := _above(found, int(found.above[arm[-1]]))) == 1:
            arm.append(int(above[0]))
        arm[:] = arm[: int(found.perimeter[arm].argmin()) + 1]
    return pieces, rings, arms


def _is_widening(length: np.ndarray) -> bool:
    """Whether rings of ``length`` (k,) get longer, as those of a wedge do, and no faster than their distance from the
    tip. The first ones, around a tip on an edge, need not, and the last ones may where the front divides."""
    growth = length[WIDER:] / length[:-WIDER]
    if not len(growth):
        return False
    is_longer = growth[min(WIDER, len(growth) - 1) :] > 1
    return bool(is_longer.all() and (growth[:-WIDER] <= np.exp(STEP * WIDER) + ROUNDING).all())


def _is_in_both(shape: Enclosure, found: Levels, arms: list[list[int]], apex: np.ndarray, least: float) -> bool:
    """Whether the points ``apex`` (k, 3) beyond the axes of two ``arms``, and there are some, are within both."""
    (p, d, one), (q, e, other) = (_axis(shape, found, arm) for arm in arms)
    if d @ e <= 0 or np.linalg.norm(cross(d, e)) < ROUNDING:
        return False
    s, t = np.linalg.lstsq(np.stack([d, -e], axis=1), q - p, rcond=None)[0]
    u = -unit(d + e)
    apex = apex[(apex - (p + s * d + q + t * e) / 2) @ u > 0]
    sine = np.linalg.norm(cross(d, u))
    bars = (p, d, one), (q, e, other)
    return len(apex) > 0 and all(_outside(shape, *bar, apex) <= least * bar[2] * sine for bar in bars)


def _axis(shape: Enclosure, found: Levels, rings: list[int]) -> tuple[np.ndarray, np.ndarray, float]:
    """A point (3,) on the axis of a bar, its direction (3,), and half of its width."""
    pair = [rings[-1], rings[len(rings) // 2 - 1]]
    places, size = found.centre[pair], found.size[pair]
    for _ in range(ends.LINE_ROUNDS):
        places = ends.centred(shape, places, unit(places[0] - places[1]), size)
    return places[0], unit(places[0] - places[1]), float(size[0])


def _outside(shape: Enclosure, place: np.ndarray, along: np.ndarray, size: float, points: np.ndarray) -> float:
    """How far ``points`` (k, 3) are outside a bar ``along`` (3,) with the section at ``place`` (3,), the largest."""
    corners = sections.corners(shape, place[None], along[None], np.array([size]))
    if not corners.is_closed[0]:
        return np.inf
    aside = points - place
    aside = aside - (aside @ along)[:, None] * along
    edge = (unit(aside) @ (corners.places(shape) - place).T).max(axis=1)
    return float((np.linalg.norm(aside, axis=1) - edge).max())
