"""Plane sections of a surface around points of a curve: they say where the middle of a limb is.

A plane cuts a closed surface in closed walks. A curve should pass through the middle of the loop around it. The loop is
followed from triangle to triangle (see `loops`), so the cost depends on the loop's length and not on the surface.

The middle of a loop is the centroid of its area, unless that is outside the loop, as in an angle, a channel or half a
pipe. There it is the middle of the shortest chord that halves the area (see `held_in`):

    min |q - p|  with  A(p, q) = A / 2

over points p and q of the loop, where A(p, q) is the area between the chord and the loop from p to q.
"""

from typing import NamedTuple

import numpy as np

from msf_jax.solid import walks
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import arc_length, at, cross, repeated, unit

SEARCHES = 3  # searches for the nearest loop, each three times as far as the one before
FIRST_REACH = 1.5  # radii: reach of the first search
LONGEST_LOOP = 20_000  # triangles after which a loop is given up
CAPACITY = 1_000  # corners a loop for which memory is allocated first; it doubles when it is full
CHORDS, ROUNDS = 24, 3  # from points evenly along a loop; rounds, each around the point of the shortest one before
ADDED_SINE = 0.2  # sine added, as a square, between wall and plane: nearly tangent walls get bounded derivatives


class Corners(NamedTuple):
    """The corners of closed loops, loop by loop and in order.

    loop: (C,) the loop of each corner. tail, head: (C,) ends of its mesh edge, above and below the plane. part: (C,)
    fraction of the edge from tail to corner. triangle: (C,) the triangle from this corner to the next.
    is_closed: (P,) which loops returned to their first corner.
    """

    loop: np.ndarray
    tail: np.ndarray
    head: np.ndarray
    part: np.ndarray
    triangle: np.ndarray
    is_closed: np.ndarray

    def places(self, shape: Enclosure) -> np.ndarray:
        """(C, 3) the corners on ``shape``."""
        t = self.part[:, None]
        # `take` gathers rows faster than an index.
        return (1 - t) * shape.vertices.take(self.tail, axis=0) + t * shape.vertices.take(self.head, axis=0)


class Sections(NamedTuple):
    """The loop around each of P points.

    centroid: (P, 3) of the area inside the loop; the point itself without a loop.
    radius: (P,) mean distance of the loop from its centroid; 0 without a loop.
    size: (P,) twice the area over the loop's length: the radius of a disc, the thickness of a sheet; 0 without a loop.
    is_found: (P,) whether there is a loop that bounds the solid from outside.
    is_around: (P,) whether the loop goes around the point.
    slide: (P, 3) motion of the centroid within the plane, when the plane moves along its normal n by a unit of length.
    turn: (P, 3, 3) motion of the centroid when the plane turns about the point: turn @ dn for a change dn of n.
    """

    centroid: np.ndarray
    radius: np.ndarray
    size: np.ndarray
    is_found: np.ndarray
    is_around: np.ndarray
    slide: np.ndarray
    turn: np.ndarray


def cut(
    shape: Enclosure, points: np.ndarray, normals: np.ndarray, radii: np.ndarray, near: np.ndarray | None = None
) -> Sections:
    """Cut ``shape`` through ``points`` (P, 3) across the unit vectors ``normals`` (P, 3).

    A point's loop is the nearest loop in its plane: the outer boundary, unless a cavity is nearer. ``radii`` (P,) are
    estimates of its distance; the search begins within 1.5 of them. With ``near`` (P,), triangles near the points, the
    loop reached from such a triangle is taken instead, which is fast.
    """
    return measured(shape, points, normals, corners(shape, points, normals, radii, near))


def corners(
    shape: Enclosure, points: np.ndarray, normals: np.ndarray, radii: np.ndarray, near: np.ndarray | None = None
) -> Corners:
    """The corners of the loops that `cut` measures."""
    num = len(points)
    near = np.full(num, -1) if near is None else near
    reach = FIRST_REACH * np.maximum(radii, 1e-3 * shape.extent)
    capacity, ends = CAPACITY * num, np.empty(num, dtype=np.int64)
    while True:
        edge, part = np.empty(capacity, dtype=np.int64), np.empty(capacity)
        limits, segment = (SEARCHES, LONGEST_LOOP), np.empty((2, 3))
        if walks.loops(points, normals, reach, near, shape.mesh, *limits, segment, ends, edge, part):
            break
        capacity *= 2
    count = np.diff(ends, prepend=0)
    loop = np.repeat(np.arange(num), count)
    edge, part = edge[: len(loop)], part[: len(loop)]
    return Corners(loop, shape.mesh.corners[edge], shape.heads[edge], part, edge // 3, count > 0)


def nowhere(points: np.ndarray) -> Sections:
    """The result for points without a loop."""
    zero, none = np.zeros(len(points)), np.zeros(len(points), dtype=bool)
    slide, turn = np.zeros_like(points), np.zeros((*points.shape, 3))
    return Sections(points.copy(), zero, zero.copy(), none, none.copy(), slide, turn)


def areas(shape: Enclosure, corners: Corners, normals: np.ndarray) -> np.ndarray:
    """(P,) the area inside each loop of ``corners``, in planes across ``normals`` (P, 3); 0 without a loop."""
    place, loop = corners.places(shape), corners.loop
    if not len(loop):
        return np.zeros(len(normals))
    first = np.searchsorted(loop, loop)
    is_last = np.append(loop[1:] != loop[:-1], True)
    place = place - place.take(first, axis=0)
    onward = place.take(np.where(is_last, first, np.arange(len(loop)) + 1), axis=0)
    twice = np.einsum("ci,ci->c", cross(place, onward), normals.take(loop, axis=0))
    return np.bincount(loop, weights=twice, minlength=len(normals)) / 2


def measured(shape: Enclosure, points: np.ndarray, normals: np.ndarray, corners: Corners) -> Sections:
    """Measure the loops with these ``corners``, in planes through ``points`` (P, 3) with ``normals`` (P, 3)."""
    loop = corners.loop
    places = corners.places(shape) - points.take(loop, axis=0)
    leans = -np.einsum("ci,ci->c", shape.normals.take(corners.triangle, axis=0), normals.take(loop, axis=0))
    sums = np.zeros((len(points), 19))
    ends = np.flatnonzero(np.diff(loop, append=-1)) + 1
    walks.measures(places, leans, normals, ends, loop[ends - 1], ADDED_SINE, sums)
    area2, angle, perimeter = sums[:, 3], sums[:, 4], np.maximum(sums[:, 5], 1e-300)
    is_found = area2 > 0
    size, radius = (np.where(is_found, column, 0.0) / perimeter for column in (area2, sums[:, 6]))
    safe = np.where(is_found, area2, np.inf)[:, None]
    slide, turn = sums[:, 7:10] / (safe / 2), -sums[:, 10:] / (safe / 2)
    centroid = np.where(is_found[:, None], sums[:, :3], 0.0)
    is_around = is_found & (angle > np.pi)
    return Sections(points + centroid, radius, size, is_found, is_around, slide, turn.reshape(-1, 3, 3))


def held_in(shape: Enclosure, normals: np.ndarray, corners: Corners, found: Sections) -> Sections:
    """``found``, measured on ``corners`` in planes across ``normals`` (P, 3), with middles inside the loops.

    A centroid outside its loop, and outside ``shape``, gives way to the middle of the shortest chord that halves the
    area: the corner of an angle, the middle of a channel's web, the back of half a pipe. It depends on the walls there
    only. They run along the limb, so its derivatives are 0, and such a section counts as a round one: its size is its
    radius."""
    out = np.flatnonzero(found.is_found & ~shape.contains(found.centroid))
    if not len(out):
        return found
    found = Sections(*(field.copy() for field in found))
    normal, centroid = normals[out], found.centroid[out]
    side = unit(cross(normal, np.eye(3)[np.abs(normal).argmin(axis=1)]))
    frames = np.stack([side, cross(normal, side)], axis=1)
    first, stop = np.searchsorted(corners.loop, out), np.searchsorted(corners.loop, out + 1)
    row, place = repeated(stop - first)
    each = first[row] + place
    own = corners._replace(tail=corners.tail[each], head=corners.head[each], part=corners.part[each])
    x = np.einsum("cij,cj->ci", frames[row], own.places(shape) - centroid[row])
    end = np.cumsum(stop - first)
    onward = np.roll(x, -1, axis=0)
    onward[end - 1] = x[end - (stop - first)]
    is_outside = np.bincount(row, weights=_is_crossed(x, onward), minlength=len(out)) % 2 == 0
    for k in np.flatnonzero(is_outside).tolist():
        loop = x[end[k] - stop[k] + first[k] : end[k]]
        found.centroid[out[k]] += _narrowest(np.concatenate([loop, loop[:1]])) @ frames[k]
    out = out[is_outside]
    found.size[out] = found.radius[out]
    found.slide[out], found.turn[out] = 0.0, 0.0
    return found


def _narrowest(x: np.ndarray) -> np.ndarray:
    """(2,) the middle of the shortest chord that halves a closed polygon ``x`` (C + 1, 2), counterclockwise; 0 if none
    is found."""
    along = arc_length(x)
    swept = np.append(0.0, np.cumsum(_cross(x[:-1], x[1:])))  # twice the area between the loop and its start
    stops, reach, middle = np.linspace(0.0, along[-1], CHORDS, endpoint=False), along[-1] / CHORDS, np.zeros(2)
    for _ in range(ROUNDS):
        stops = stops % along[-1]
        p, begun = at(x, along, stops)[:, None], np.interp(stops, along, swept)[:, None]
        beyond = swept - begun + swept[-1] * (along <= stops[:, None]) + _cross(x, p) - swept[-1] / 2
        low, high = beyond[:, :-1], beyond[:, 1:]
        is_own = (along[:-1] <= stops[:, None]) & (stops[:, None] <= along[1:])
        row, side = np.nonzero(((low > 0) != (high > 0)) & ~is_own)
        part = (low[row, side] / (low[row, side] - high[row, side]))[:, None]
        q, p = (1 - part) * x[side] + part * x[side + 1], p[row, 0]
        length, middles = np.linalg.norm(q - p, axis=1), (p + q) / 2
        best = next((k for k in length.argsort(kind="stable") if _is_around(x, middles[k])), None)
        if best is None:
            break
        middle = middles[best]
        stops, reach = stops[row[best]] + reach * np.linspace(-1.0, 1.0, CHORDS + 1), reach * 2 / CHORDS
    return middle


def _is_around(x: np.ndarray, point: np.ndarray) -> bool:
    """Whether the closed polygon ``x`` (C + 1, 2) is around ``point`` (2,): a ray crosses it an odd number of times."""
    return bool(_is_crossed(x[:-1] - point, x[1:] - point).sum() % 2)


def _is_crossed(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """(C,) whether the segments from ``a`` to ``b`` (C, 2) cross the ray from the origin to the right."""
    is_up = b[:, 1] > a[:, 1]
    return ((a[:, 1] > 0) != (b[:, 1] > 0)) & ((_cross(b - a, -a) > 0) == is_up)


def _cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
