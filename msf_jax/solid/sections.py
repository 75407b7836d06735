"""Plane sections of a surface around points of a curve: they say where the middle of a limb is.

A plane cuts a closed surface in loops, which are followed from triangle to triangle, so the cost depends on the loop's
length only. The middle of a loop is the centroid of its area, unless that is outside the loop, as in an angle, a
channel or half a pipe. There it is the middle of the shortest chord that halves the area (see `held_in`):

    min |q - p|  with  A(p, q) = A / 2

over points p and q of the loop, where A(p, q) is the area between the chord and the loop from p to q.
"""

from math import atan2, isqrt, sqrt
from typing import NamedTuple

import numpy as np

from msf_jax.numerics.compiled import Ints, Points, Reals, kernel, part
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import arc_length, at, axes_across
from msf_jax.solid.kernels import Mesh, Vector, dot, is_within, minus, norm, off_segment, onward, point_of, times

CHORDS = 24  # from points evenly along a loop, and again, twice, from points around that of the shortest one
ADDED_SINE = 0.2  # sine added, as a square, between wall and plane: nearly tangent walls get bounded derivatives


class Corners(NamedTuple):
    """The corners of closed loops, loop by loop and in order.

    loop: (C,) the loop of each corner. tail, head: (C,) ends of its mesh edge, above and below the plane. part: (C,)
    fraction of the edge from tail to corner. triangle: (C,) the triangle from this corner to the next."""

    loop: np.ndarray
    tail: np.ndarray
    head: np.ndarray
    part: np.ndarray
    triangle: np.ndarray

    def places(self, shape: Enclosure) -> np.ndarray:
        """(C, 3) the corners on ``shape``."""
        t = self.part[:, None]
        # `take` gathers rows faster than an index.
        return (1 - t) * shape.vertices.take(self.tail, axis=0) + t * shape.vertices.take(self.head, axis=0)


class Sections(NamedTuple):
    """The loop around each of P points.

    centroid: (P, 3) of the area inside the loop; the point itself without a loop.
    middle: (P, 3) the same, but for a centroid outside, after `held_in`.
    radius: (P,) mean distance of the loop from its centroid; 0 without a loop.
    area: (P,) inside the loop, negative for one around a cavity; 0 without a loop.
    size: (P,) twice the area over the loop's length: the radius of a disc, the thickness of a sheet; 0 without a loop.
    is_found: (P,) whether there is a loop that bounds the solid from outside.
    is_around: (P,) whether the loop goes around the point. has_middle: (P,) whether it goes around its centroid.
    slide: (P, 3) motion of the middle within the plane, when the plane moves along its normal n by a unit of length.
    turn: (P, 3, 3) motion of the middle when the plane turns about the point: turn @ dn for a change dn of n.
    corners: of the loops."""

    centroid: np.ndarray
    middle: np.ndarray
    radius: np.ndarray
    area: np.ndarray
    size: np.ndarray
    is_found: np.ndarray
    is_around: np.ndarray
    has_middle: np.ndarray
    slide: np.ndarray
    turn: np.ndarray
    corners: Corners

    def only(self, is_kept: np.ndarray) -> "Sections":
        """The sections of ``is_kept`` (P,)."""
        loop = self.corners.loop
        corners = Corners(*(field[is_kept[loop]] for field in self.corners))
        corners = corners._replace(loop=(np.cumsum(is_kept) - 1)[corners.loop])
        return Sections._make([*(field[is_kept] for field in self[:-1]), corners])


@part
def height(mesh: Mesh, vertex: int, point: Vector, normal: Vector) -> float:
    """Height of a vertex above the plane through a point: the same bits for every triangle at the vertex."""
    away = minus(point_of(mesh.vertices, vertex), point)
    return away[0] * normal[0] + away[1] * normal[1] + away[2] * normal[2]


@part
def edge_down(mesh: Mesh, point: Vector, normal: Vector, face: int) -> int:
    """The half-edge of a face that leads from above the plane to below it; -1 if there is none."""
    for k in range(3):
        tail, head = mesh.corners[3 * face + k], mesh.corners[3 * face + (k + 1) % 3]
        if height(mesh, tail, point, normal) >= 0 > height(mesh, head, point, normal):
            return 3 * face + k
    return -1


@part
def segment_distance(mesh: Mesh, point: Vector, normal: Vector, face: int) -> float:
    """Distance from a point to the segment in which its plane cuts a face."""
    start = end = point
    for k in range(3):
        tail, head = mesh.corners[3 * face + k], mesh.corners[3 * face + (k + 1) % 3]
        a, b = height(mesh, tail, point, normal), height(mesh, head, point, normal)
        if (a >= 0) != (b >= 0):
            t, u, v = a / (a - b), point_of(mesh.vertices, tail), point_of(mesh.vertices, head)
            place = u[0] + t * (v[0] - u[0]), u[1] + t * (v[1] - u[1]), u[2] + t * (v[2] - u[2])
            start, end = (place, end) if a >= 0 else (start, place)
    return norm(off_segment(minus(point, start), minus(end, start)))


@kernel
def loops(points: Points, normals: Points, size: Reals, mesh: Mesh, ends: Ints, edges: Ints, parts: Reals) -> bool:
    """For each point, the half-edges down through its plane along one loop.

    It is the nearest loop, of several at the same distance that of the first triangle. It is sought within twice
    ``size[p]`` and, while there is none, within twice as far, up to the size of the mesh. The half-edges of point p end
    before ``ends[p]``; ``parts`` is the fraction of each above the plane. Returns False if ``edges`` is too short."""
    num, count, boxes = len(mesh.order), 0, mesh.boxes
    farthest = norm((boxes[1, 3] - boxes[1, 0], boxes[1, 4] - boxes[1, 1], boxes[1, 5] - boxes[1, 2]))
    for row in range(len(points)):
        point, normal, first = point_of(points, row), point_of(normals, row), -1
        reach = min(size[row], farthest / 2)
        while first < 0 and reach < farthest:
            reach *= 2
            node, best, which = 1, reach, num
            while node:
                is_met = is_within(point, boxes, node, best * best)
                if is_met and node >= num:
                    face = mesh.order[node - num]
                    edge = edge_down(mesh, point, normal, face)
                    if edge >= 0:
                        away = segment_distance(mesh, point, normal, face)
                        if away < best or (away == best and face < which):
                            first, best, which = edge, away, face
                node = onward(node, num, is_met)
        edge = first
        while edge >= 0:
            if count == len(edges):
                return False
            face, k = edge // 3, edge % 3
            a = height(mesh, mesh.corners[edge], point, normal)
            b = height(mesh, mesh.corners[3 * face + (k + 1) % 3], point, normal)
            edges[count], parts[count] = edge, a / (a - b)
            count += 1
            # The loop leaves over the next edge if the opposite corner is above the plane, else over the one after.
            opposite = (k + 2) % 3
            is_up = height(mesh, mesh.corners[3 * face + opposite], point, normal) >= 0
            edge = mesh.twins[3 * face + (k + 1) % 3 if is_up else 3 * face + opposite]
            if edge == first:
                break
        ends[row] = count
    return True


@kernel
def measures(places: Points, leans: Reals, normals: Points, ends: Ints, rows: Ints, found: Points) -> None:
    """Sums over loops with corners at ``places`` (C, 3) relative to their points, in planes with ``normals`` (P, 3).

    Loop k belongs to point ``rows[k]``, and ends before ``ends[k]``. ``leans`` (C,) is the inward slope of the wall
    after each corner: minus the product of the wall's and the plane's normals. Columns of ``found`` (P, 20), which are
    0 at first: 0 to 2 the centroid, 3 twice the area, 4 the angle around the point, 5 the length, 6 the length times
    the mean distance from the centroid; 7 to 9 and, row by row, 10 to 18 sums of the centroid's derivatives; 19 the
    angle around the centroid."""
    first = 0
    for loop in range(len(ends)):
        stop, sums, normal = ends[loop], found[rows[loop]], point_of(normals, rows[loop])
        for here in range(first, stop):
            a, b = point_of(places, here), point_of(places, here + 1 if here + 1 < stop else first)
            twice = dot(times(a, b), normal)
            for i in range(3):
                sums[i] += twice * (a[i] + b[i])
            sums[3] += twice
            sums[4] += atan2(twice, dot(a, b))
            sums[5] += norm(minus(b, a))
        if sums[3] > 0:
            for i in range(3):
                sums[i] /= 3 * sums[3]
            centroid = sums[0], sums[1], sums[2]
            for here in range(first, stop):
                a, b = point_of(places, here), point_of(places, here + 1 if here + 1 < stop else first)
                middle = (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2
                length, lean, off = norm(minus(b, a)), leans[here], minus(middle, centroid)
                from_a, from_b = minus(a, centroid), minus(b, centroid)
                sums[6] += length * ((norm(from_a) + 4 * norm(off) + norm(from_b)) / 6)  # Simpson's rule
                sums[19] += atan2(dot(times(from_a, from_b), normal), dot(from_a, from_b))
                lean *= length / sqrt(max(1 - lean * lean, 0.0) + ADDED_SINE * ADDED_SINE)
                for i in range(3):
                    sums[7 + i] += lean * off[i]
                    for j in range(3):
                        sums[10 + 3 * i + j] += lean * off[i] * middle[j]
        first = stop


def cut(shape: Enclosure, points: np.ndarray, normals: np.ndarray, radii: np.ndarray) -> Sections:
    """The sections of ``shape`` through ``points`` (P, 3) across the unit vectors ``normals`` (P, 3).

    A point's loop is the nearest loop in its plane: the outer boundary, unless a cavity is nearer. ``radii`` (P,) are
    estimates of its distance; the search begins within two of them."""
    num, num_faces = len(points), len(shape.faces)
    size, ends = np.maximum(radii, 1e-3 * shape.extent), np.empty(num, dtype=np.int64)
    capacity = num_faces + 4 * num * isqrt(num_faces)  # a plane across a ball cuts some 2.3 roots of its triangles
    while True:
        edge, share = np.empty(capacity, dtype=np.int64), np.empty(capacity)
        if loops(points, normals, size, shape.mesh, ends, edge, share):
            break
        capacity *= 2
    loop = np.repeat(np.arange(num), np.diff(ends, prepend=0))
    edge, share = edge[: len(loop)], share[: len(loop)]
    corners = Corners(loop, shape.edges.origin[edge], shape.edges.target[edge], share, edge // 3)
    places = corners.places(shape) - points.take(loop, axis=0)
    leans = -np.einsum("ci,ci->c", shape.normals.take(corners.triangle, axis=0), normals.take(loop, axis=0))
    sums = np.zeros((len(points), 20))
    ends = np.flatnonzero(np.diff(loop, append=-1)) + 1
    measures(places, leans, normals, ends, loop[ends - 1], sums)
    area2, angle, perimeter = sums[:, 3], sums[:, 4], np.maximum(sums[:, 5], 1e-300)
    is_found = area2 > 0
    size, radius = (np.where(is_found, column, 0.0) / perimeter for column in (area2, sums[:, 6]))
    safe = np.where(is_found, area2, np.inf)[:, None]
    slide, turn = sums[:, 7:10] / (safe / 2), -sums[:, 10:19] / (safe / 2)
    centroid = np.where(is_found[:, None], sums[:, :3], 0.0)
    is_around, has_middle = (is_found & (turned > np.pi) for turned in (angle, sums[:, 19]))
    turn, centroid, kinds = turn.reshape(-1, 3, 3), points + centroid, (is_found, is_around, has_middle)
    return Sections(centroid, centroid.copy(), radius, area2 / 2, size, *kinds, slide, turn, corners)


def held_in(shape: Enclosure, normals: np.ndarray, found: Sections) -> Sections:
    """Sections ``found`` in planes across ``normals`` (P, 3), with middles inside the loops.

    A centroid outside its loop, and outside ``shape``, gives way to the middle of the shortest chord that halves the
    area. That depends only on the walls there, which run along the limb: its derivatives are 0, and such a section
    counts as a round one, whose size is its radius."""
    rows = np.flatnonzero(found.is_found & ~found.has_middle)
    found = Sections._make([*(field.copy() for field in found[:-1]), found.corners])
    for row in rows[~shape.contains(found.centroid[rows])].tolist():
        (frame,) = axes_across(normals[[row]])
        own = slice(*np.searchsorted(found.corners.loop, [row, row + 1]))
        places = Corners(*(field[own] for field in found.corners)).places(shape)
        x = np.einsum("cj,ij->ci", places - found.centroid[row], frame)
        x = np.concatenate([x, x[:1]])
        found.middle[row] = _narrowest(shape, x, found.centroid[row], frame)
        found.size[row], found.slide[row], found.turn[row] = found.radius[row], 0.0, 0.0
    return found


def _narrowest(shape: Enclosure, x: np.ndarray, origin: np.ndarray, axes: np.ndarray) -> np.ndarray:
    """(3,) the middle of the shortest chord inside ``shape`` that halves a closed polygon ``x`` (C + 1, 2) along
    ``axes`` (2, 3) from ``origin`` (3,), counterclockwise; the origin if none is found."""
    along = arc_length(x)
    swept = np.append(0.0, np.cumsum(_cross(x[:-1], x[1:])))  # twice the area between the loop and its start
    stops, reach, middle = np.linspace(0.0, along[-1], CHORDS, endpoint=False), along[-1] / CHORDS, origin
    for _ in range(3):
        stops = stops % along[-1]
        p, begun = at(x, along, stops)[:, None], np.interp(stops, along, swept)[:, None]
        beyond = swept - begun + swept[-1] * (along <= stops[:, None]) + _cross(x, p) - swept[-1] / 2
        low, high = beyond[:, :-1], beyond[:, 1:]
        is_own = (along[:-1] <= stops[:, None]) & (stops[:, None] <= along[1:])
        row, side = np.nonzero(((low > 0) != (high > 0)) & ~is_own)
        part = (low[row, side] / (low[row, side] - high[row, side]))[:, None]
        q, p = (1 - part) * x[side] + part * x[side + 1], p[row, 0]
        middles = origin + (p + q) / 2 @ axes
        length = np.where(shape.contains(middles), np.linalg.norm(q - p, axis=1), np.inf)
        if not len(length) or length.min() == np.inf:
            break
        best = int(length.argmin())
        middle = middles[best]
        stops, reach = stops[row[best]] + reach * np.linspace(-1.0, 1.0, CHORDS + 1), reach * 2 / CHORDS
    return middle


def _cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
