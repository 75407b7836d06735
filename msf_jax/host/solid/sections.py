"""Plane sections of a surface around points of a curve: where the middle of a limb is.

The section of a closed surface by a plane is a set of closed loops. The one that goes around a point is what a curve
should be in the middle of. It is walked along from triangle to triangle (see `loops`), so that the cost is that
of the loops, not of the surface.
"""

from typing import NamedTuple

import numpy as np

from msf_jax.host.solid import loops
from msf_jax.host.solid.enclosure import Enclosure

SEARCHES = 3  # for the nearest loop, each three times as far as the last, the first this many radii:
NEAREST, FARTHEST = 1.5, 1.5 * 3 ** (SEARCHES - 1)
LONGEST_LOOP = 20_000  # triangles, after which a walk is given up
ROOM = 1_000  # corners of a loop, that there is room for at first
FLATTEST = 0.2  # a wall that leans more than that from the plane counts as leaning so much


class Corners(NamedTuple):
    """The corners of closed loops, one loop after the other, each in its order.

    loop: (C,) the loop of each. tail, head: (C,) ends of the edge that it is on, over and under the plane. part: (C,)
    how far from the tail to the head it is, as a fraction. triangle: (C,) which the loop crosses to the next corner.
    is_closed: (P,) which loops came back to where they began.
    """

    loop: np.ndarray
    tail: np.ndarray
    head: np.ndarray
    part: np.ndarray
    triangle: np.ndarray
    is_closed: np.ndarray


class Sections(NamedTuple):
    """The loop around each of P points.

    centroid: (P, 3) of the area that the loop encloses, the point itself where there is no loop.
    radius: (P,) mean distance of the loop from its centroid, 0 where there is none.
    size: (P,) twice its area over its length: the radius of a disc, the thickness of a sheet; 0 where there is none.
    is_found: (P,) whether there is a loop that bounds the solid from outside.
    is_around: (P,) whether it goes around the point.
    slide: (P, 3) how the centroid moves, but for going along, when the plane goes a unit of length along its normal n,
    turn: (P, 3, 3) and, times (dn, the change of n), when the plane turns about the point.
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

    The nearest loop in the plane is the point's: the outer one of its region, but where there is a cavity. ``radii``
    (P,) are guesses at how far it is; it is looked for within one and a half of that, and then ever farther. With
    ``near`` (P,), triangles near the points, a loop that can be reached from there is taken instead, which is fast.
    """
    return measured(shape, points, normals, corners(shape, points, normals, radii, near))


def corners(
    shape: Enclosure, points: np.ndarray, normals: np.ndarray, radii: np.ndarray, near: np.ndarray | None = None
) -> Corners:
    """The corners of the loops that `cut` measures."""
    num, corner = len(points), shape.faces.ravel()
    near = np.full(num, -1) if near is None else near
    reach = NEAREST * np.maximum(radii, 1e-3 * np.ptp(shape.vertices, axis=0).max())
    room, ends = ROOM * num, np.empty(num, dtype=np.int64)
    while True:
        edge, part = np.empty(room, dtype=np.int64), np.empty(room)
        limits, segment = (SEARCHES, LONGEST_LOOP), np.empty((2, 3))
        if loops.loops(points, normals, reach, near, shape.mesh, *limits, segment, ends, edge, part):
            break
        room *= 2
    count = np.diff(ends, prepend=0)
    loop = np.repeat(np.arange(num), count)
    edge, part = edge[: len(loop)], part[: len(loop)]
    triangle = edge // 3
    head = corner[3 * triangle + (edge + 1) % 3]
    return Corners(loop, corner[edge], head, part, triangle, count > 0)


def nowhere(points: np.ndarray) -> Sections:
    """What is found where there is no loop."""
    zero, none = np.zeros(len(points)), np.zeros(len(points), dtype=bool)
    slide, turn = np.zeros_like(points), np.zeros((*points.shape, 3))
    return Sections(points.copy(), zero, zero.copy(), none, none.copy(), slide, turn)


def measured(shape: Enclosure, points: np.ndarray, normals: np.ndarray, corners: Corners) -> Sections:
    """The loops with these ``corners`` through ``points`` (P, 3), across ``normals`` (P, 3)."""
    loop, t = corners.loop, corners.part[:, None]
    places = (1 - t) * shape.vertices[corners.tail] + t * shape.vertices[corners.head] - points[loop]
    leans = -np.einsum("ci,ci->c", shape.normals[corners.triangle], normals[loop])
    sums = np.zeros((len(points), 19))
    ends = np.flatnonzero(np.diff(loop, append=-1)) + 1
    loops.measures(places, leans, normals, ends, loop[ends - 1], FLATTEST, sums)
    area2, angle, perimeter = sums[:, 3], sums[:, 4], np.maximum(sums[:, 5], 1e-300)
    is_found = area2 > 0
    size, radius = (np.where(is_found, column, 0.0) / perimeter for column in (area2, sums[:, 6]))
    safe = np.where(is_found, area2, np.inf)[:, None]
    slide, turn = sums[:, 7:10] / (safe / 2), -sums[:, 10:] / (safe / 2)
    centroid = np.where(is_found[:, None], sums[:, :3], 0.0)
    is_around = is_found & (angle > np.pi)
    return Sections(points + centroid, radius, size, is_found, is_around, slide, turn.reshape(-1, 3, 3))
