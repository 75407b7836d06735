"""The compiled loops of a solid: nearest triangles, winding numbers, ray hits, segments inside, and pairs of
triangles that cross.

They search a tree of bounding boxes of n triangles. The tree is a heap: the children of node k are 2 k and 2 k + 1, and
node n + i is the box of triangle ``order[i]``: its lowest and its highest x, y and z. The search needs no stack. After
node k and its descendants comes k + 1 or, if k + 1 is a left child, its first ancestor that is not a left child.

The distance to a triangle is the distance to its nearest edge, or to its plane if the foot of the perpendicular is
inside (Ericson 2005, 5.1.5).
"""

from math import sqrt
from typing import NamedTuple

import numpy as np

from msf_jax.numerics.compiled import Flags, Ints, Points, Reals, Triangles, kernel, part
from msf_jax.solid.geometry import ROUNDING

FLAT = 1e-14  # squared sizes of a triangle: a smaller area, seen along a ray, is a rounding error


class Mesh(NamedTuple):
    """vertices: (V, 3). corners: (3F,) of the faces. triangles: (F, 3, 3) their coordinates. twins: (3F,) the opposite
    of half-edge 3 f + k, from corner k of face f to the next. boxes: (2F, 6) and order: (F,), the tree of boxes.
    """

    vertices: Points
    corners: Ints
    triangles: Triangles
    twins: Ints
    boxes: Points
    order: Ints


@part
def dot(ax: float, ay: float, az: float, bx: float, by: float, bz: float) -> float:
    """a . b, summed in the order of NumPy's `einsum`."""
    return (ax * bx + az * bz) + ay * by


@part
def norm(x: float, y: float, z: float) -> float:
    """|x|, summed in the order of `numpy.linalg.norm`."""
    return sqrt((x * x + y * y) + z * z)


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
def overlaps(
    boxes: Points, node: int, low_x: float, low_y: float, low_z: float, high_x: float, high_y: float, high_z: float
) -> bool:
    """Whether the box of a node overlaps the given box."""
    is_beside = boxes[node, 0] > high_x or boxes[node, 1] > high_y or boxes[node, 2] > high_z
    return not (is_beside or boxes[node, 3] < low_x or boxes[node, 4] < low_y or boxes[node, 5] < low_z)


@part
def is_within(x: float, y: float, z: float, boxes: Points, node: int, distance2: float) -> bool:
    """Whether the box of a node is within a distance of a point; ``distance2`` is the square of the distance."""
    dx = max(boxes[node, 0] - x, x - boxes[node, 3], 0.0)
    dy = max(boxes[node, 1] - y, y - boxes[node, 4], 0.0)
    dz = max(boxes[node, 2] - z, z - boxes[node, 5], 0.0)
    return dx * dx + dy * dy + dz * dz <= distance2 * (1 + ROUNDING)


@part
def triangle_distance2(x: float, y: float, z: float, triangles: Triangles, row: int) -> float:
    """Squared distance from a point to a triangle, which may be degenerate."""
    best = np.inf
    for k in range(3):
        j = (k + 1) % 3
        ax, ay, az = triangles[row, k, 0], triangles[row, k, 1], triangles[row, k, 2]
        ux, uy, uz = triangles[row, j, 0] - ax, triangles[row, j, 1] - ay, triangles[row, j, 2] - az
        ox, oy, oz = x - ax, y - ay, z - az
        length2 = dot(ux, uy, uz, ux, uy, uz)
        t = min(max(dot(ox, oy, oz, ux, uy, uz) / length2, 0.0), 1.0) if length2 > 0 else 0.0
        rx, ry, rz = ox - t * ux, oy - t * uy, oz - t * uz
        best = min(best, dot(rx, ry, rz, rx, ry, rz))
    ax, ay, az = triangles[row, 0, 0], triangles[row, 0, 1], triangles[row, 0, 2]
    ux, uy, uz = triangles[row, 1, 0] - ax, triangles[row, 1, 1] - ay, triangles[row, 1, 2] - az
    vx, vy, vz = triangles[row, 2, 0] - ax, triangles[row, 2, 1] - ay, triangles[row, 2, 2] - az
    ox, oy, oz = x - ax, y - ay, z - az
    nx, ny, nz = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
    area2 = dot(nx, ny, nz, nx, ny, nz)
    if area2 > 0:
        v = dot(oy * vz - oz * vy, oz * vx - ox * vz, ox * vy - oy * vx, nx, ny, nz) / area2
        w = dot(uy * oz - uz * oy, uz * ox - ux * oz, ux * oy - uy * ox, nx, ny, nz) / area2
        if v >= 0 and w >= 0 and v + w <= 1:
            height = dot(ox, oy, oz, nx, ny, nz)
            best = min(best, height * height / area2)
    return best


@kernel
def distances2(points: Points, triangles: Triangles, found: Reals) -> None:
    """``found`` (c,): squared distance from each point to the triangle beside it."""
    for row in range(len(points)):
        found[row] = triangle_distance2(points[row, 0], points[row, 1], points[row, 2], triangles, row)


@kernel
def nearest(
    points: Points, mesh: Mesh, sample: Ints, first: Ints, fan: Ints, is_exact: bool, found2: Reals, found: Ints
) -> None:
    """``found`` (P,): the nearest triangle among ``fan[first[sample] : first[sample + 1]]``, or among all triangles if
    ``is_exact``; the first of several at the same distance. ``found2`` (P,): the squared distance."""
    triangles, num = mesh.triangles, len(mesh.order)
    for row in range(len(points)):
        x, y, z = points[row, 0], points[row, 1], points[row, 2]
        best, which = np.inf, num
        place, node = first[sample[row]], 1 if is_exact else 0
        while node or place < first[sample[row] + 1]:
            if place < first[sample[row] + 1]:
                triangle = fan[place]
                place += 1
            else:
                is_met = is_within(x, y, z, mesh.boxes, node, best)
                triangle = mesh.order[node - num] if is_met and node >= num else -1
                node = onward(node, num, is_met)
            if triangle >= 0:
                away = triangle_distance2(x, y, z, triangles, triangle)
                if away < best or (away == best and triangle < which):
                    best, which = away, triangle
        found2[row], found[row] = best, which


@part
def winding(x: float, y: float, z: float, mesh: Mesh) -> int:
    """The winding number of the surface around a point: signed crossings of the ray upwards.

    Seen from above, the ray is a point. It is in a triangle if it is on the same side of all three edges. The side is
    computed with an edge's ends in order of index, so both faces at the edge agree. A point on an edge's line counts as
    shifted by (e, e^2) for a vanishing e, so a ray through a vertex or along a wall needs no special case.
    """
    corners, triangles, boxes, num = mesh.corners, mesh.triangles, mesh.boxes, len(mesh.order)
    found, node = 0, 1
    while node:
        is_met = overlaps(boxes, node, x, y, z, x, y, np.inf)
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
                found += (num_left == 3) - (num_left == 0)
        node = onward(node, num, is_met)
    return found


@kernel
def windings(points: Points, mesh: Mesh, found: Ints) -> None:
    """``found`` (P,): the winding number of the surface around each point."""
    for row in range(len(points)):
        found[row] = winding(points[row, 0], points[row, 1], points[row, 2], mesh)


@part
def hits_of(
    x: float,
    y: float,
    z: float,
    row: int,
    axes: Triangles,
    reach: float,
    slack: float,
    mesh: Mesh,
    seen: Points,
    count: int,
    ray: Ints,
    distance: Reals,
) -> int:
    """Every hit of the ray number ``row`` from a point, see `hits`, after the first ``count``; returns the number of
    all."""
    triangles, num = mesh.triangles, len(mesh.order)
    u, v, w = x + reach * axes[row, 2, 0], y + reach * axes[row, 2, 1], z + reach * axes[row, 2, 2]
    low_x, low_y, low_z = min(x, u) - slack, min(y, v) - slack, min(z, w) - slack
    high_x, high_y, high_z = max(x, u) + slack, max(y, v) + slack, max(z, w) + slack
    node = 1
    while node:
        is_met = overlaps(mesh.boxes, node, low_x, low_y, low_z, high_x, high_y, high_z)
        if is_met and node >= num:
            triangle, size2 = mesh.order[node - num], 0.0
            for k in range(3):
                dx, dy, dz = triangles[triangle, k, 0] - x, triangles[triangle, k, 1] - y, triangles[triangle, k, 2] - z
                for i in range(3):
                    seen[k, i] = dot(dx, dy, dz, axes[row, i, 0], axes[row, i, 1], axes[row, i, 2])
                size2 = max(size2, seen[k, 0] ** 2 + seen[k, 1] ** 2)
            one = seen[0, 0] * seen[1, 1] - seen[1, 0] * seen[0, 1]  # twice the areas with the edges
            two = seen[1, 0] * seen[2, 1] - seen[2, 0] * seen[1, 1]
            three = seen[2, 0] * seen[0, 1] - seen[0, 0] * seen[2, 1]
            total = one + two + three
            # A triangle seen edge-on has an area of rounding errors only: it is no hit.
            if (min(one, two, three) >= 0 or max(one, two, three) <= 0) and abs(total) > FLAT * size2:
                t = dot(one, two, three, seen[2, 2], seen[0, 2], seen[1, 2]) / total
                t = max(t, min(seen[0, 2], seen[1, 2], seen[2, 2]))
                t = min(t, max(seen[0, 2], seen[1, 2], seen[2, 2]))
                if 0 <= t <= reach:
                    if count < len(ray):
                        ray[count], distance[count] = row, t
                    count += 1
        node = onward(node, num, is_met)
    return count


@kernel
def hits(
    points: Points, axes: Triangles, reach: Reals, slack: float, mesh: Mesh, seen: Points, ray: Ints, distance: Reals
) -> int:
    """Every hit of the rays from ``points`` (P, 3) along the last of their ``axes`` (P, 3, 3), up to ``reach`` (P,).

    ``seen`` (3, 3) is scratch space for a triangle in the ray's axes. Returns the number of hits; ``ray`` and
    ``distance`` hold the first of them, up to their length.
    """
    count = 0
    for row in range(len(points)):
        x, y, z = points[row, 0], points[row, 1], points[row, 2]
        count = hits_of(x, y, z, row, axes, reach[row], slack, mesh, seen, count, ray, distance)
    return count


@part
def set_axes(axes: Triangles, x: float, y: float, z: float) -> None:
    """Set the last of the first ``axes`` to a unit vector, and the others perpendicular to it, as `Enclosure` does."""
    k = 1 if abs(y) < abs(x) else 0
    k = 2 if abs(z) < min(abs(x), abs(y)) else k
    axes[0, 2, 0], axes[0, 2, 1], axes[0, 2, 2] = x, y, z
    axes[0, 0, k], axes[0, 0, (k + 1) % 3], axes[0, 0, (k + 2) % 3] = (
        0.0,
        axes[0, 2, (k + 2) % 3],
        -axes[0, 2, (k + 1) % 3],
    )
    size = max(norm(axes[0, 0, 0], axes[0, 0, 1], axes[0, 0, 2]), 1e-300)
    for i in range(3):
        axes[0, 0, i] /= size
    for i in range(3):
        j, m = (i + 1) % 3, (i + 2) % 3
        axes[0, 1, i] = axes[0, 2, j] * axes[0, 0, m] - axes[0, 2, m] * axes[0, 0, j]


@kernel
def within(
    points: Points,
    ends: Points,
    sliver: float,
    slack: float,
    mesh: Mesh,
    axes: Triangles,
    seen: Points,
    ray: Ints,
    hit: Reals,
    is_in: Flags,
) -> int:
    """``is_in`` (P,): whether each segment, from ``points`` (P, 3) to ``ends`` (P, 3), is inside the solid.

    At a hit the segment leaves the solid or crosses a fold inside: the middles of the stretches between hits that are
    longer than ``sliver`` decide. A ray along a face, or from the surface, may miss its exit, so the end is tested,
    too. ``axes`` (1, 3, 3), ``seen`` (3, 3), ``ray`` and ``hit`` are scratch space. Returns the number of hits of a
    segment that has more, else 0.
    """
    for row in range(len(points)):
        x, y, z = points[row, 0], points[row, 1], points[row, 2]
        is_in[row] = winding(x, y, z, mesh) > 0
        if not is_in[row]:
            continue
        dx, dy, dz = ends[row, 0] - x, ends[row, 1] - y, ends[row, 2] - z
        length = norm(dx, dy, dz)
        size = max(length, 1e-300)
        dx, dy, dz = dx / size, dy / size, dz / size
        set_axes(axes, dx, dy, dz)
        count = hits_of(x, y, z, 0, axes, length, slack, mesh, seen, 0, ray, hit)
        if count > len(hit):
            return count
        for last in range(1, count):  # in ascending order
            at = last
            while at and hit[at - 1] > hit[at]:
                hit[at - 1], hit[at] = hit[at], hit[at - 1]
                at -= 1
        stop = 0.0
        for number in range(count + 1 if count else 0):
            further = hit[number] if number < count else length
            if is_in[row] and further - stop > sliver:
                half = (stop + further) / 2
                is_in[row] = winding(x + half * dx, y + half * dy, z + half * dz, mesh) > 0
            stop = further
        is_in[row] = is_in[row] and winding(ends[row, 0], ends[row, 1], ends[row, 2], mesh) > 0
    return 0


@part
def height(triangles: Triangles, row: int, other: int, k: int) -> float:
    """Height of corner ``k`` of triangle ``other`` above the plane of triangle ``row``; 0 if that has no area."""
    ax, ay, az = triangles[row, 0, 0], triangles[row, 0, 1], triangles[row, 0, 2]
    ux, uy, uz = triangles[row, 1, 0] - ax, triangles[row, 1, 1] - ay, triangles[row, 1, 2] - az
    vx, vy, vz = triangles[row, 2, 0] - ax, triangles[row, 2, 1] - ay, triangles[row, 2, 2] - az
    nx, ny, nz = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
    size = norm(nx, ny, nz)
    ox, oy, oz = triangles[other, k, 0] - ax, triangles[other, k, 1] - ay, triangles[other, k, 2] - az
    return dot(ox, oy, oz, nx, ny, nz) / size if size > 0 else 0.0


@part
def straddles(triangles: Triangles, row: int, other: int, least: float) -> bool:
    """Whether triangle ``other`` has corners on both sides of the plane of triangle ``row``, ``least`` off it."""
    first = height(triangles, row, other, 0)
    second, third = height(triangles, row, other, 1), height(triangles, row, other, 2)
    return min(first, second, third) < -least and max(first, second, third) > least


@part
def passes(triangles: Triangles, row: int, k: int, other: int, least: float) -> bool:
    """Whether side ``k`` of triangle ``row`` passes through triangle ``other``, its ends ``least`` off its plane."""
    j = (k + 1) % 3
    above, below = height(triangles, other, row, k), height(triangles, other, row, j)
    if not (min(above, below) < -least and max(above, below) > least):
        return False
    sx, sy, sz = triangles[row, k, 0], triangles[row, k, 1], triangles[row, k, 2]
    dx, dy, dz = triangles[row, j, 0] - sx, triangles[row, j, 1] - sy, triangles[row, j, 2] - sz
    num_left = num_right = 0
    for i in range(3):
        m = (i + 1) % 3
        ux, uy, uz = triangles[other, i, 0] - sx, triangles[other, i, 1] - sy, triangles[other, i, 2] - sz
        vx, vy, vz = triangles[other, m, 0] - sx, triangles[other, m, 1] - sy, triangles[other, m, 2] - sz
        turn = dot(dx, dy, dz, uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx)
        num_left += turn >= 0
        num_right += turn <= 0
    return num_left == 3 or num_right == 3


@kernel
def crossed(corners: Ints, mesh: Mesh, least: float, most: int, tested: Ints, one: Ints, other: Ints) -> int:
    """Pairs of triangles that cross: a side of one passes through the other, its ends ``least`` off the other's plane.

    Triangles that share one of ``corners`` (3F,) do not count. Returns the number of pairs; ``one`` and ``other`` hold
    the first of them, up to their length. The search ends after ``most`` pairs; ``tested`` (1,) counts them.
    """
    triangles, boxes, num, count = mesh.triangles, mesh.boxes, len(mesh.order), 0
    tested[0] = 0
    for leaf in range(num, 2 * num):
        row, node = mesh.order[leaf - num], onward(leaf, num, False)  # each pair is met from its first leaf
        while node and tested[0] < most:
            is_met = overlaps(
                boxes,
                node,
                boxes[leaf, 0],
                boxes[leaf, 1],
                boxes[leaf, 2],
                boxes[leaf, 3],
                boxes[leaf, 4],
                boxes[leaf, 5],
            )
            if is_met and node >= num:
                found = mesh.order[node - num]
                is_pair = True
                for k in range(9):
                    is_pair = is_pair and corners[3 * row + k // 3] != corners[3 * found + k % 3]
                if is_pair:
                    tested[0] += 1
                    is_pair = straddles(triangles, row, found, least) and straddles(triangles, found, row, least)
                    for k in range(3):
                        if is_pair and (
                            passes(triangles, row, k, found, least) or passes(triangles, found, k, row, least)
                        ):
                            is_pair = False
                            if count < len(one):
                                one[count], other[count] = row, found
                            count += 1
            node = onward(node, num, is_met)
    return count
