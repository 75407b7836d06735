"""The compiled loops of a solid: what is nearest to a point, what a ray meets, and which loop a plane cuts out.

Most of them walk down a tree of boxes (see `triangles.Tree`) of n triangles. It is a heap: below node k are 2 k and
2 k + 1, and node n + i is the box of triangle ``order[i]``, of a point's lowest and highest x, y and z. Such a walk needs
no stack: after node k, and all below it, comes k + 1, or that node above it which begins there.

The distance to a triangle is that to the nearest of its edges, or to its plane where the foot of the perpendicular is
inside (Ericson 2005, 5.1.5).
"""

from math import atan2, sqrt

import numpy as np

from msf_jax.host.compiled import Flags, Ints, Points, Reals, Triangles, kernel, part

FLAT = 1e-14  # of the square of a triangle's size: less area than that, seen along a ray, is rounding
SLACK = 1 + 1e-12  # on the square of a distance, by which a box may seem farther than what is in it
DESCENT = 30  # triangles from a given one to the plane, after which all around are searched


@part
def dot(ax: float, ay: float, az: float, bx: float, by: float, bz: float) -> float:
    """a . b, added as NumPy's `einsum` does."""
    return (ax * bx + az * bz) + ay * by


@part
def norm(x: float, y: float, z: float) -> float:
    """|x|, added as `numpy.linalg.norm` does."""
    return sqrt((x * x + y * y) + z * z)


@part
def onward(node: int) -> int:
    """The node after ``node`` and all that is below it; 1 after the last."""
    node += 1
    while not node & 1:
        node >>= 1
    return node


@part
def box_distance2(x: float, y: float, z: float, boxes: Points, node: int) -> float:
    """Squared distance from a point to a box; 0 inside."""
    dx = max(boxes[node, 0] - x, x - boxes[node, 3], 0.0)
    dy = max(boxes[node, 1] - y, y - boxes[node, 4], 0.0)
    dz = max(boxes[node, 2] - z, z - boxes[node, 5], 0.0)
    return dx * dx + dy * dy + dz * dz


@part
def triangle_distance2(x: float, y: float, z: float, triangles: Triangles, row: int) -> float:
    """Squared distance from a point to a triangle, which may be a segment or a point."""
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
    points: Points,
    triangles: Triangles,
    sample: Ints,
    first: Ints,
    fan: Ints,
    boxes: Points,
    order: Ints,
    is_exact: bool,
    found2: Reals,
    found: Ints,
) -> None:
    """``found`` (P,): the nearest triangle of those in ``fan[first[sample] : first[sample + 1]]`` or, if ``is_exact``,
    of all, the first if several are; and ``found2``, the squared distance."""
    num = len(order)
    for row in range(len(points)):
        x, y, z = points[row, 0], points[row, 1], points[row, 2]
        best, which = np.inf, len(triangles)
        for place in range(first[sample[row]], first[sample[row] + 1]):
            triangle = fan[place]
            away = triangle_distance2(x, y, z, triangles, triangle)
            if away < best or (away == best and triangle < which):
                best, which = away, triangle
        node = 1
        while is_exact:
            if box_distance2(x, y, z, boxes, node) <= best * SLACK:
                if node < num:
                    node *= 2
                    continue
                triangle = order[node - num]
                away = triangle_distance2(x, y, z, triangles, triangle)
                if away < best or (away == best and triangle < which):
                    best, which = away, triangle
            node = onward(node)
            if node == 1:
                break
        found2[row], found[row] = best, which


@kernel
def around(
    points: Points, reach: Reals, start: int, boxes: Points, order: Ints, ends: Ints, point: Ints, triangle: Ints
) -> int:
    """Pairs of points, from ``start`` on, and triangles whose boxes are within reach, as many as there is room for.

    Returns the first point whose pairs are not all there; those of point p end before ``ends[p]``.
    """
    num, count = len(order), 0
    for row in range(start, len(points)):
        x, y, z = points[row, 0], points[row, 1], points[row, 2]
        node = 1
        while True:
            if box_distance2(x, y, z, boxes, node) <= reach[row] * reach[row] * SLACK:
                if node < num:
                    node *= 2
                    continue
                if count == len(point):
                    return row
                point[count], triangle[count] = row, order[node - num]
                count += 1
            node = onward(node)
            if node == 1:
                break
        ends[row] = count
    return len(points)


@kernel
def windings(points: Points, triangles: Triangles, corners: Ints, boxes: Points, order: Ints, found: Ints) -> None:
    """``found`` (P,): how often the surface winds around each point: signed crossings of the ray that goes up from it.

    Seen from above the ray is a point. It is in a triangle if it is on the same side of all three edges. The side is
    computed with an edge's ends in order of index, so that both faces at the edge agree; a point on the line is taken
    as shifted by (e, e^2) for a vanishing e, so that a ray through a vertex or along a wall is no exception.
    """
    num = len(order)
    for row in range(len(points)):
        x, y, z = points[row, 0], points[row, 1], points[row, 2]
        winding, node = 0, 1
        while True:
            if (
                boxes[node, 0] <= x <= boxes[node, 3]
                and boxes[node, 1] <= y <= boxes[node, 4]
                and z < boxes[node, 5]
            ):
                if node < num:
                    node *= 2
                    continue
                face = order[node - num]
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
                    winding += (num_left == 3) - (num_left == 0)
            node = onward(node)
            if node == 1:
                break
        found[row] = winding


@kernel
def hits(
    points: Points,
    axes: Triangles,
    reach: Reals,
    slack: float,
    triangles: Triangles,
    boxes: Points,
    order: Ints,
    seen: Points,
    ray: Ints,
    distance: Reals,
) -> int:
    """Every hit of the rays from ``points`` (P, 3) along the last of their ``axes`` (P, 3, 3), up to ``reach`` (P,).

    ``seen`` (3, 3) is room for a triangle as seen along the ray, where that is a point. Returns how many there are; as
    many as there is room for are in ``ray`` and ``distance``.
    """
    num, count = len(order), 0
    for row in range(len(points)):
        px, py, pz = points[row, 0], points[row, 1], points[row, 2]
        qx, qy, qz = (
            px + reach[row] * axes[row, 2, 0],
            py + reach[row] * axes[row, 2, 1],
            pz + reach[row] * axes[row, 2, 2],
        )
        node = 1
        while True:
            if (
                boxes[node, 0] <= max(px, qx) + slack
                and boxes[node, 3] >= min(px, qx) - slack
                and boxes[node, 1] <= max(py, qy) + slack
                and boxes[node, 4] >= min(py, qy) - slack
                and boxes[node, 2] <= max(pz, qz) + slack
                and boxes[node, 5] >= min(pz, qz) - slack
            ):
                if node < num:
                    node *= 2
                    continue
                triangle = order[node - num]
                size2 = 0.0
                for k in range(3):
                    dx = triangles[triangle, k, 0] - px
                    dy = triangles[triangle, k, 1] - py
                    dz = triangles[triangle, k, 2] - pz
                    for i in range(3):
                        seen[k, i] = dot(dx, dy, dz, axes[row, i, 0], axes[row, i, 1], axes[row, i, 2])
                    size2 = max(size2, seen[k, 0] * seen[k, 0] + seen[k, 1] * seen[k, 1])
                one = seen[0, 0] * seen[1, 1] - seen[1, 0] * seen[0, 1]  # twice the areas with the edges
                two = seen[1, 0] * seen[2, 1] - seen[2, 0] * seen[1, 1]
                three = seen[2, 0] * seen[0, 1] - seen[0, 0] * seen[2, 1]
                total = one + two + three
                # Seen edge-on a triangle has no area but rounding errors, and is no hit.
                if (min(one, two, three) >= 0 or max(one, two, three) <= 0) and abs(total) > FLAT * size2:
                    t = dot(one, two, three, seen[2, 2], seen[0, 2], seen[1, 2]) / total
                    t = max(t, min(seen[0, 2], seen[1, 2], seen[2, 2]))
                    t = min(t, max(seen[0, 2], seen[1, 2], seen[2, 2]))
                    if 0 <= t <= reach[row]:
                        if count < len(ray):
                            ray[count], distance[count] = row, t
                        count += 1
            node = onward(node)
            if node == 1:
                break
    return count


@part
def height(vertices: Points, vertex: int, points: Points, normals: Points, row: int) -> float:
    """Of a vertex over the plane through a point; the same bits whichever triangle asks."""
    x = (vertices[vertex, 0] - points[row, 0]) * normals[row, 0]
    y = (vertices[vertex, 1] - points[row, 1]) * normals[row, 1]
    return x + y + (vertices[vertex, 2] - points[row, 2]) * normals[row, 2]


@part
def way_down(vertices: Points, corners: Ints, points: Points, normals: Points, row: int, face: int) -> int:
    """The directed edge of a face that leads from above the plane to below it; -1 if there is none."""
    for k in range(3):
        tail, head = corners[3 * face + k], corners[3 * face + (k + 1) % 3]
        if height(vertices, tail, points, normals, row) >= 0 > height(vertices, head, points, normals, row):
            return 3 * face + k
    return -1


@part
def descended(
    vertices: Points, corners: Ints, twins: Ints, points: Points, normals: Points, row: int, face: int
) -> int:
    """The directed edge that leads down, reached from a face, from neighbour to neighbour; -1 if it is too far."""
    for _ in range(DESCENT):
        edge = way_down(vertices, corners, points, normals, row, face)
        if edge >= 0:
            return edge
        # Away from the farthest corner, over the edge opposite to it, which is the next edge.
        farthest, most = 0, -1.0
        for k in range(3):
            away = abs(height(vertices, corners[3 * face + k], points, normals, row))
            if away > most:
                farthest, most = k, away
        face = twins[3 * face + (farthest + 1) % 3] // 3
    return -1


@part
def segment_distance(
    vertices: Points, corners: Ints, points: Points, normals: Points, row: int, face: int, ends: Points
) -> float:
    """From a point to the segment that its plane cuts out of a face, if it cuts it; ``ends`` (2, 3) is room for it."""
    for k in range(3):
        tail, head = corners[3 * face + k], corners[3 * face + (k + 1) % 3]
        a, b = height(vertices, tail, points, normals, row), height(vertices, head, points, normals, row)
        if (a >= 0) != (b >= 0):
            end = 0 if a >= 0 else 1
            for i in range(3):
                ends[end, i] = vertices[tail, i] + a / (a - b) * (vertices[head, i] - vertices[tail, i])
    x, y, z = points[row, 0] - ends[0, 0], points[row, 1] - ends[0, 1], points[row, 2] - ends[0, 2]
    ux, uy, uz = ends[1, 0] - ends[0, 0], ends[1, 1] - ends[0, 1], ends[1, 2] - ends[0, 2]
    length2 = dot(ux, uy, uz, ux, uy, uz)
    t = min(max(dot(ux, uy, uz, x, y, z) / length2, 0.0), 1.0) if length2 > 0 else 0.0
    x, y, z = x - t * ux, y - t * uy, z - t * uz
    return norm(x, y, z)


@kernel
def loops(
    points: Points,
    normals: Points,
    reach: Reals,
    near: Ints,
    vertices: Points,
    corners: Ints,
    twins: Ints,
    boxes: Points,
    order: Ints,
    searches: int,
    longest: int,
    segment: Points,
    ends: Ints,
    edges: Ints,
    parts: Reals,
) -> bool:
    """Around each point the directed edges that lead down where a loop in its plane crosses them.

    The loop is that which is reached from triangle ``near[p]``; or, where that is -1 or the plane is far from there,
    the nearest one, within ``reach[p]`` or thrice as far and so on, ``searches`` times: that of the first triangle, if
    several are as near. It is walked once around. One of more than ``longest`` corners is left out.

    Those of point p end before ``ends[p]``; ``parts`` is how far the plane is from each edge's tail, as a fraction.
    ``segment`` (2, 3) is room. Returns whether there was room for all of them.
    """
    num, count = len(order), 0
    for row in range(len(points)):
        first, best = -1, reach[row]
        if near[row] >= 0:
            first = descended(vertices, corners, twins, points, normals, row, near[row])
        for _ in range(searches):
            if first >= 0:
                break
            node, which = 1, -1
            while True:
                if box_distance2(points[row, 0], points[row, 1], points[row, 2], boxes, node) <= best * best * SLACK:
                    if node < num:
                        node *= 2
                        continue
                    face = order[node - num]
                    edge = way_down(vertices, corners, points, normals, row, face)
                    if edge >= 0:
                        away = segment_distance(vertices, corners, points, normals, row, face, segment)
                        if away < best or (away == best and (which < 0 or face < which)):
                            first, best, which = edge, away, face
                node = onward(node)
                if node == 1:
                    break
            best *= 3
        edge, begin = first, count
        while edge >= 0:
            if count - begin == longest:
                count = begin
                break
            if count == len(edges):
                return False
            face, k = edge // 3, edge % 3
            a = height(vertices, corners[edge], points, normals, row)
            b = height(vertices, corners[3 * face + (k + 1) % 3], points, normals, row)
            edges[count], parts[count] = edge, a / (a - b)
            count += 1
            # Over the next edge if the corner opposite is up, else over the last.
            opposite = (k + 2) % 3
            is_up = height(vertices, corners[3 * face + opposite], points, normals, row) >= 0
            edge = twins[3 * face + (k + 1) % 3 if is_up else 3 * face + opposite]
            if edge == first:
                break
        ends[row] = count
    return True


@kernel
def measures(
    places: Points, leans: Reals, normals: Points, ends: Ints, rows: Ints, flattest: float, found: Points
) -> None:
    """Sums over loops with corners at ``places`` (C, 3), seen from points in their planes across ``normals`` (P, 3).

    Loop number k is around point ``rows[k]``, and ends before ``ends[k]``. ``leans`` (C,) says how far the wall after
    each corner leans inward. Columns of ``found`` (P, 19), which are 0 at first: 0 to 2 the centroid of the area, 3
    twice the area, 4 the angle that the loop turns, 5 its length, 6 its mean distance from the centroid; 7 to 9 and,
    row by row, 10 to 18 how the centroid moves when the plane slides and turns.
    """
    first = 0
    for loop in range(len(ends)):
        stop, sums = ends[loop], found[rows[loop]]
        nx, ny, nz = normals[rows[loop], 0], normals[rows[loop], 1], normals[rows[loop], 2]
        for here in range(first, stop):
            there = here + 1 if here + 1 < stop else first
            x, y, z = places[here, 0], places[here, 1], places[here, 2]
            u, v, w = places[there, 0], places[there, 1], places[there, 2]
            twice = dot(y * w - z * v, z * u - x * w, x * v - y * u, nx, ny, nz)
            sums[0] += twice * (x + u)
            sums[1] += twice * (y + v)
            sums[2] += twice * (z + w)
            sums[3] += twice
            sums[4] += atan2(twice, dot(x, y, z, u, v, w))
            sums[5] += norm(u - x, v - y, w - z)
        if sums[3] > 0:
            for i in range(3):
                sums[i] /= 3 * sums[3]
            for here in range(first, stop):
                there = here + 1 if here + 1 < stop else first
                x, y, z = places[here, 0], places[here, 1], places[here, 2]
                u, v, w = places[there, 0], places[there, 1], places[there, 2]
                mx, my, mz = (x + u) / 2, (y + v) / 2, (z + w) / 2
                cx, cy, cz = sums[0], sums[1], sums[2]
                length, lean = norm(u - x, v - y, w - z), leans[here]
                away = norm(x - cx, y - cy, z - cz) + 4 * norm(mx - cx, my - cy, mz - cz)
                sums[6] += length * ((away + norm(u - cx, v - cy, w - cz)) / 6)  # Simpson's rule
                lean *= length / sqrt(max(1 - lean * lean, 0.0) + flattest * flattest)
                for i in range(3):
                    off = lean * ((mx - cx) if i == 0 else (my - cy) if i == 1 else (mz - cz))
                    sums[7 + i] += off
                    sums[10 + 3 * i] += off * mx
                    sums[11 + 3 * i] += off * my
                    sums[12 + 3 * i] += off * mz
        first = stop
