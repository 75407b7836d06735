"""Plane sections of a surface around points of a curve: where the middle of a limb is.

The section of a closed surface by a plane is a set of closed loops. The one that goes around a point is what a curve
should be in the middle of. It is walked along from triangle to triangle, for all points in step, so that the cost is
that of the loops, not of the surface.
"""

from typing import NamedTuple

import numpy as np

from msf_jax.host.solid.enclosure import Enclosure
from msf_jax.host.solid.geometry import cross, unit

SEARCHES = 3  # for the nearest loop, each three times as far as the last, the first this many radii:
NEAREST, FARTHEST = 1.5, 1.5 * 3 ** (SEARCHES - 1)
DESCENT = 30  # triangles from a given one to the plane, after which all around are searched
LONGEST_LOOP = 20_000  # triangles, after which a walk is given up
FLATTEST = 0.2  # a wall that leans more than that from the plane counts as leaning so much


class Corners(NamedTuple):
    """The corners of loops, one loop after the other, each in its order.

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
    start = np.full(len(points), -1) if near is None else _crossings_below(shape, points, normals, near)
    left = np.flatnonzero(start < 0)
    reach = NEAREST * np.maximum(radii[left], 1e-3 * np.ptp(shape.vertices, axis=0).max())
    for _ in range(SEARCHES):
        if not len(left):
            break
        start[left] = _nearest_crossings(shape, points[left], normals[left], reach)
        is_left = start[left] < 0
        left, reach = left[is_left], 3 * reach[is_left]
    rows = np.flatnonzero(start >= 0)
    is_closed = np.zeros(len(points), dtype=bool)
    if not len(rows):
        nothing = np.empty(0, dtype=np.int64)
        return Corners(nothing, nothing, nothing, np.empty(0), nothing, is_closed)
    found = _walk(shape, points[rows], normals[rows], start[rows])
    is_closed[rows] = found.is_closed
    return found._replace(loop=rows[found.loop], is_closed=is_closed)


def nowhere(points: np.ndarray) -> Sections:
    """What is found where there is no loop."""
    zero, none = np.zeros(len(points)), np.zeros(len(points), dtype=bool)
    slide, turn = np.zeros_like(points), np.zeros((*points.shape, 3))
    return Sections(points.copy(), zero, zero.copy(), none, none.copy(), slide, turn)


def _heights(shape: Enclosure, vertex: np.ndarray, points: np.ndarray, normals: np.ndarray) -> np.ndarray:
    """Height (...,) of each vertex over its plane; the same bits whichever triangle asks."""
    away = shape.vertices[vertex] - points
    return away[..., 0] * normals[..., 0] + away[..., 1] * normals[..., 1] + away[..., 2] * normals[..., 2]


def _nearest_crossings(shape: Enclosure, points: np.ndarray, normals: np.ndarray, reach: np.ndarray) -> np.ndarray:
    """(P,) the directed edge that leads down in the triangle of the plane's nearest segment; -1 if that is too far."""
    start = np.full(len(points), -1)
    for point, triangle in shape.triangles_near(points, reach):
        height = _heights(shape, shape.faces[triangle], points[point][:, None], normals[point][:, None])
        is_up = height >= 0
        is_cut = is_up.any(axis=1) & ~is_up.all(axis=1)
        point, triangle, height, is_up = point[is_cut], triangle[is_cut], height[is_cut], is_up[is_cut]
        rows = np.arange(len(point))
        ends = []
        following = np.roll(is_up, -1, axis=1)
        for leads in (is_up & ~following, ~is_up & following):
            k = leads.argmax(axis=1)
            a, b = height[rows, k], height[rows, (k + 1) % 3]
            corner = shape.triangles[triangle]
            ends.append(corner[rows, k] + (a / (a - b))[:, None] * (corner[rows, (k + 1) % 3] - corner[rows, k]))
        along, offset = ends[1] - ends[0], points[point] - ends[0]
        length2 = np.einsum("ij,ij->i", along, along)
        t = np.clip(np.einsum("ij,ij->i", along, offset) / np.where(length2 > 0, length2, 1.0), 0, 1)
        distance = np.linalg.norm(offset - t[:, None] * along, axis=1)
        down = (is_up & ~following).argmax(axis=1)
        near = np.flatnonzero(distance <= reach[point])
        order = near[np.lexsort((triangle[near], distance[near], point[near]))]
        first = order[np.r_[True, point[order][1:] != point[order][:-1]]] if len(order) else order
        start[point[first]] = 3 * triangle[first] + down[first]
    return start


def _crossings_below(shape: Enclosure, points: np.ndarray, normals: np.ndarray, triangle: np.ndarray) -> np.ndarray:
    """(P,) a directed edge that leads down, reached from ``triangle`` (P,) from neighbour to neighbour; -1 if not."""
    start = np.full(len(points), -1)
    twin_of_next = shape.links().twin_of_next
    active, triangle = np.arange(len(points)), triangle.copy()
    for _ in range(DESCENT):
        height = _heights(shape, shape.faces[triangle], points[active, None], normals[active, None])
        is_up = height >= 0
        leads_down = is_up & ~np.roll(is_up, -1, axis=1)
        is_cut = leads_down.any(axis=1)
        start[active[is_cut]] = 3 * triangle[is_cut] + leads_down[is_cut].argmax(axis=1)
        active, triangle, height = active[~is_cut], triangle[~is_cut], height[~is_cut]
        if not len(active):
            break
        # Away from the farthest corner, over the edge opposite to it, which is the next edge.
        triangle = twin_of_next[3 * triangle + np.abs(height).argmax(axis=1)] // 3
    return start


def _walk(shape: Enclosure, points: np.ndarray, normals: np.ndarray, start: np.ndarray) -> Corners:
    """Follow every loop from the directed edges ``start`` that lead down, both ways, until the two ends meet."""
    num = len(points)
    apex, twin, twin_of_next, twin_of_last = shape.links()
    next_edge = np.arange(len(apex)).reshape(-1, 3)[:, [1, 2, 0]].ravel()
    ahead: list[tuple[np.ndarray, np.ndarray]] = []  # points still under way, and the edges where they are
    behind: list[tuple[np.ndarray, np.ndarray]] = []
    is_closed = np.zeros(num, dtype=bool)
    active, front, back, p, n = np.arange(num), start, start, points, normals
    for _ in range(LONGEST_LOOP // 2):
        ahead.append((active, front))
        is_up = _heights(shape, apex[front], p, n) >= 0
        front = np.where(is_up, twin_of_next[front], twin_of_last[front])
        is_met = front == back
        if is_met.any():
            is_closed[active[is_met]] = True
            active, front, back, p, n = (values[~is_met] for values in (active, front, back, p, n))
            if not len(active):
                break
        over = twin[back]
        is_up = _heights(shape, apex[over], p, n) >= 0
        onward = next_edge[over]
        back = np.where(is_up, next_edge[onward], onward)
        is_met = front == back
        if is_met.any():
            ahead.append((active[is_met], front[is_met]))
            is_closed[active[is_met]] = True
            active, front, back, p, n = (values[~is_met] for values in (active, front, back, p, n))
            if not len(active):
                break
        behind.append((active, back))
    loop, edge = (np.concatenate(parts) for parts in zip(*ahead, *reversed(behind), strict=True))
    order = np.argsort(loop, kind="stable")
    loop, edge = loop[order], edge[order]
    tail, head = shape.faces.ravel()[edge], shape.faces[edge // 3, (edge + 1) % 3]
    a = _heights(shape, tail, points[loop], normals[loop])
    b = _heights(shape, head, points[loop], normals[loop])
    return Corners(loop, tail, head, a / (a - b), edge // 3, is_closed)


def measured(shape: Enclosure, points: np.ndarray, normals: np.ndarray, corners: Corners) -> Sections:
    """The loops with these ``corners`` through ``points`` (P, 3), across ``normals`` (P, 3)."""
    num = len(points)
    loop, tail, head = corners.loop, corners.tail, corners.head
    t = corners.part[:, None]
    p = points[loop]
    place = (1 - t) * shape.vertices[tail] + t * shape.vertices[head] - p
    last = np.r_[loop[1:] != loop[:-1], True] if len(loop) else np.empty(0, dtype=bool)
    first = np.flatnonzero(np.r_[True, last[:-1]]) if len(loop) else np.empty(0, dtype=np.int64)
    onward = np.r_[place[1:], place[:1]] if len(loop) else place
    onward[last] = place[first]

    def total(value: np.ndarray) -> np.ndarray:
        return np.bincount(loop, weights=value, minlength=num)

    twice = np.einsum("ci,ci->c", cross(place, onward), normals[loop])
    area2 = total(twice)
    winding = total(np.arctan2(twice, np.einsum("ci,ci->c", place, onward))) / (2 * np.pi)
    is_found = corners.is_closed & (area2 > 0)
    safe = np.where(is_found, area2, np.inf)
    centroid = np.stack([total(twice * (place + onward)[:, i]) for i in range(3)], axis=1) / (3 * safe[:, None])
    length = np.linalg.norm(onward - place, axis=1)
    at_start, at_middle, at_end = (
        np.linalg.norm(where - centroid[loop], axis=1) for where in (place, (place + onward) / 2, onward)
    )
    away = (at_start + 4 * at_middle + at_end) / 6  # Simpson's rule
    perimeter = np.maximum(total(length), 1e-300)
    radius = np.where(is_found, total(length * away) / perimeter, 0.0)
    size = np.where(is_found, area2 / perimeter, 0.0)
    # Where the plane rises by h, the loop goes outward by h times how much the wall leans away from its normal.
    corner = shape.triangles[corners.triangle]
    wall = unit(cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]))
    lean = -np.einsum("ci,ci->c", wall, normals[loop])
    lean *= length / np.sqrt(np.maximum(1 - lean**2, 0) + FLATTEST**2)
    middle = (place + onward) / 2
    off = (middle - centroid[loop]) * lean[:, None]
    slide = np.stack([total(off[:, i]) for i in range(3)], axis=1) / (safe / 2)[:, None]
    turn = np.stack([[total(off[:, i] * middle[:, j]) for j in range(3)] for i in range(3)])
    turn = -np.moveaxis(turn, 2, 0) / (safe / 2)[:, None, None]
    return Sections(points + centroid, radius, size, is_found, is_found & (winding > 0.5), slide, turn)
