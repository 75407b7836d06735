"""The compiled loops of a solid: nearest triangles, winding numbers, and hits of rays.

They search a tree of bounding boxes of n triangles, or points. The tree is a heap: the children of node k are 2 k and
2 k + 1, and node n + i is the box of triangle ``order[i]``: its lowest and its highest x, y and z. The search needs no
stack. After node k and its descendants comes k + 1 or, if k + 1 is a left child, its first ancestor that is not a left
child.

The distance to a triangle is the distance to its nearest edge, or to its plane if the foot of the perpendicular is
inside (Ericson 2005, 5.1.5).
"""

from math import sqrt
from typing import NamedTuple

import numpy as np
from scipy import spatial

from msf_jax.numerics.compiled import Ints, Points, Reals, Triangles, kernel, part
from msf_jax.solid.geometry import ROUNDING

Vector = tuple[float, float, float]


class Mesh(NamedTuple):
    """vertices: (V, 3). corners: (3F,) of the faces. triangles: (F, 3, 3) their coordinates. twins: (3F,) the opposite
    of half-edge 3 f + k, from corner k of face f to the next. boxes: (2F, 6) and order: (F,), the tree of boxes."""

    vertices: Points
    corners: Ints
    triangles: Triangles
    twins: Ints
    boxes: Points
    order: Ints


def tree_of(low: np.ndarray, high: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """``boxes`` (2n, 6) and ``order`` (n,) of the tree of boxes with corners ``low``, ``high`` (n, 3). The leaves have
    the order of a k-d tree of the boxes' middles."""
    num = len(low)
    order = spatial.KDTree((low + high) / 2, leafsize=4).indices.astype(np.int64)
    boxes = np.zeros((2 * num, 6))
    boxes[num:, :3], boxes[num:, 3:] = low[order], high[order]
    stop = num
    while stop > 1:
        start = (stop + 1) // 2
        left, right = boxes[2 * start : 2 * stop : 2], boxes[2 * start + 1 : 2 * stop : 2]
        boxes[start:stop, :3] = np.minimum(left[:, :3], right[:, :3])
        boxes[start:stop, 3:] = np.maximum(left[:, 3:], right[:, 3:])
        stop = start
    return boxes, order


@part
def dot(a: Vector, b: Vector) -> float:
    """a . b, summed in the order of NumPy's `einsum`."""
    return (a[0] * b[0] + a[2] * b[2]) + a[1] * b[1]


@part
def norm(a: Vector) -> float:
    """|a|, summed in the order of `numpy.linalg.norm`."""
    return sqrt((a[0] * a[0] + a[1] * a[1]) + a[2] * a[2])


@part
def minus(a: Vector, b: Vector) -> Vector:
    """a - b."""
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


@part
def times(a: Vector, b: Vector) -> Vector:
    """a x b."""
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


@part
def point_of(points: Points, row: int) -> Vector:
    """A row of ``points``."""
    return points[row, 0], points[row, 1], points[row, 2]


@part
def corner_of(triangles: Triangles, row: int, k: int) -> Vector:
    """Corner ``k`` of a triangle."""
    return triangles[row, k, 0], triangles[row, k, 1], triangles[row, k, 2]


@part
def off_segment(away: Vector, along: Vector) -> Vector:
    """From the nearest point of a segment, which may have no length, to a point; both arguments are from its start."""
    length2 = dot(along, along)
    t = min(max(dot(away, along) / length2, 0.0), 1.0) if length2 > 0 else 0.0
    return away[0] - t * along[0], away[1] - t * along[1], away[2] - t * along[2]


@part
def onward(node: int, num: int, is_met: bool) -> int:
    """The node to visit after ``node`` in a tree of ``num`` triangles: a child if ``is_met``; 0 after the last."""
    if is_met and node < num:
        return 2 * node
    node += 1
    while not node & 1:
        node >>= 1
    return node if node > 1 else 0


@part
def overlaps(boxes: Points, node: int, low: Vector, high: Vector) -> bool:
    """Whether the box of a node overlaps the box from ``low`` to ``high``."""
    is_beside = boxes[node, 0] > high[0] or boxes[node, 1] > high[1] or boxes[node, 2] > high[2]
    return not (is_beside or boxes[node, 3] < low[0] or boxes[node, 4] < low[1] or boxes[node, 5] < low[2])


@part
def is_within(point: Vector, boxes: Points, node: int, distance2: float) -> bool:
    """Whether the box of a node is within a distance of a point; ``distance2`` is the square of the distance."""
    dx = max(boxes[node, 0] - point[0], point[0] - boxes[node, 3], 0.0)
    dy = max(boxes[node, 1] - point[1], point[1] - boxes[node, 4], 0.0)
    dz = max(boxes[node, 2] - point[2], point[2] - boxes[node, 5], 0.0)
    return dx * dx + dy * dy + dz * dz <= distance2 * (1 + ROUNDING)


@part
def triangle_distance2(point: Vector, triangles: Triangles, row: int) -> float:
    """Squared distance from a point to a triangle, which may be degenerate."""
    a, b, c = corner_of(triangles, row, 0), corner_of(triangles, row, 1), corner_of(triangles, row, 2)
    off_c = off_segment(minus(point, a), minus(b, a))
    off_a = off_segment(minus(point, b), minus(c, b))
    off_b = off_segment(minus(point, c), minus(a, c))
    best = min(dot(off_c, off_c), dot(off_a, off_a), dot(off_b, off_b))
    away, u, v = minus(point, a), minus(b, a), minus(c, a)
    normal = times(u, v)
    area2 = dot(normal, normal)
    if area2 > 0:
        of_b, of_c = dot(times(away, v), normal) / area2, dot(times(u, away), normal) / area2
        if of_b >= 0 and of_c >= 0 and of_b + of_c <= 1:
            height = dot(away, normal)
            best = min(best, height * height / area2)
    return best


@kernel
def nearest(points: Points, mesh: Mesh, near: Ints, found2: Reals, found: Ints) -> None:
    """``found`` (P,): the nearest triangle, the first of several at the same distance. ``found2`` (P,): the squared
    distance. The search begins with the triangles ``near`` (P,)."""
    num = len(mesh.order)
    for row in range(len(points)):
        point, which, node = point_of(points, row), near[row], 1
        best = triangle_distance2(point, mesh.triangles, which)
        while node:
            is_met = is_within(point, mesh.boxes, node, best)
            if is_met and node >= num:
                triangle = mesh.order[node - num]
                away = triangle_distance2(point, mesh.triangles, triangle)
                if away < best or (away == best and triangle < which):
                    best, which = away, triangle
            node = onward(node, num, is_met)
        found2[row], found[row] = best, which


@kernel
def windings(points: Points, mesh: Mesh, found: Ints) -> None:
    """``found`` (P,): the winding number of the surface around each point: signed crossings of the ray upwards.

    Seen from above, the ray is a point. It is in a triangle if it is on the same side of all three edges. The side is
    computed with an edge's ends in order of index, so both faces at the edge agree. A point on an edge's line counts as
    shifted by (e, e^2) for a vanishing e, so a ray through a vertex or along a wall needs no special case."""
    corners, triangles, boxes, num = mesh.corners, mesh.triangles, mesh.boxes, len(mesh.order)
    for row in range(len(points)):
        x, y, z = point_of(points, row)
        found[row], node = 0, 1
        while node:
            is_met = overlaps(boxes, node, (x, y, z), (x, y, np.inf))
            if is_met and node >= num:
                face = mesh.order[node - num]
                num_left, total, weighted = 0, 0.0, 0.0
                for opposite in range(3):
                    k, j = (opposite + 1) % 3, (opposite + 2) % 3
                    is_up = corners[3 * face + k] < corners[3 * face + j]
                    low, high = (k, j) if is_up else (j, k)
                    dx = triangles[face, high, 0] - triangles[face, low, 0]
                    dy = triangles[face, high, 1] - triangles[face, low, 1]
                    side = dx * (y - triangles[face, low, 1]) - dy * (x - triangles[face, low, 0])
                    is_left = side > 0 or (side == 0 and (dy < 0 or (dy == 0 and dx > 0)))
                    num_left += is_left == is_up
                    side = side if is_up else -side
                    total += side
                    weighted += side * triangles[face, opposite, 2]
                # Height at which the ray meets the plane, by barycentric weights.
                height = weighted / total if total != 0 else weighted
                if min(max(height, boxes[node, 2]), boxes[node, 5]) > z:
                    found[row] += (num_left == 3) - (num_left == 0)
            node = onward(node, num, is_met)


@part
def seen_along(axes: Triangles, row: int, away: Vector) -> Vector:
    """A vector in the axes of a ray."""
    return dot(away, corner_of(axes, row, 0)), dot(away, corner_of(axes, row, 1)), dot(away, corner_of(axes, row, 2))


@kernel
def hits(
    points: Points,
    axes: Triangles,
    reach: Reals,
    slack: float,
    mesh: Mesh,
    tests: Ints,
    ray: Ints,
    face: Ints,
    distance: Reals,
) -> int:
    """Every hit of the rays from ``points`` (P, 3) along the last of their ``axes`` (P, 3, 3), up to ``reach`` (P,).

    Boxes around rays are enlarged by ``slack``. Returns the number of hits; ``ray``, ``face`` and ``distance`` hold the
    first of them, up to their length. The search ends when no ``tests`` (1,) of a ray and a triangle are left."""
    num, count = len(mesh.order), 0
    for row in range(len(points)):
        x, y, z = point_of(points, row)
        u, v, w = x + reach[row] * axes[row, 2, 0], y + reach[row] * axes[row, 2, 1], z + reach[row] * axes[row, 2, 2]
        low = min(x, u) - slack, min(y, v) - slack, min(z, w) - slack
        high = max(x, u) + slack, max(y, v) + slack, max(z, w) + slack
        node = 1
        while node and tests[0]:
            is_met = overlaps(mesh.boxes, node, low, high)
            if is_met and node >= num:
                triangle = mesh.order[node - num]
                tests[0] -= 1
                a = seen_along(axes, row, minus(corner_of(mesh.triangles, triangle, 0), (x, y, z)))
                b = seen_along(axes, row, minus(corner_of(mesh.triangles, triangle, 1), (x, y, z)))
                c = seen_along(axes, row, minus(corner_of(mesh.triangles, triangle, 2), (x, y, z)))
                size2 = max(a[0] * a[0] + a[1] * a[1], b[0] * b[0] + b[1] * b[1], c[0] * c[0] + c[1] * c[1])
                # Twice the areas with the edges.
                of_c, of_a, of_b = a[0] * b[1] - b[0] * a[1], b[0] * c[1] - c[0] * b[1], c[0] * a[1] - a[0] * c[1]
                total = of_c + of_a + of_b
                # A triangle seen edge-on has an area of rounding errors only: it is no hit.
                is_hit = min(of_a, of_b, of_c) >= 0 or max(of_a, of_b, of_c) <= 0
                if is_hit and abs(total) > ROUNDING * size2:
                    t = dot((of_c, of_a, of_b), (c[2], a[2], b[2])) / total
                    t = min(max(t, min(a[2], b[2], c[2])), max(a[2], b[2], c[2]))
                    if 0 <= t <= reach[row]:
                        if count < len(ray):
                            ray[count], face[count], distance[count] = row, triangle, t
                        count += 1
            node = onward(node, num, is_met)
    return count
