"""The compiled kernels of plane sections: the loop in which a plane cuts a surface around a point, and its measures."""

from math import atan2, sqrt

from msf_jax.numerics.compiled import Ints, Points, Reals, kernel, part
from msf_jax.solid.kernels import Mesh, dot, is_within, norm, onward

DESCENT = 30  # triangles from the given one to the plane, after which the tree is searched instead


@part
def height(mesh: Mesh, vertex: int, points: Points, normals: Points, row: int) -> float:
    """Height of a vertex above the plane through a point: the same bits for every triangle at the vertex."""
    x = (mesh.vertices[vertex, 0] - points[row, 0]) * normals[row, 0]
    y = (mesh.vertices[vertex, 1] - points[row, 1]) * normals[row, 1]
    return x + y + (mesh.vertices[vertex, 2] - points[row, 2]) * normals[row, 2]


@part
def edge_down(mesh: Mesh, points: Points, normals: Points, row: int, face: int) -> int:
    """The half-edge of a face that leads from above the plane to below it; -1 if there is none."""
    for k in range(3):
        tail, head = mesh.corners[3 * face + k], mesh.corners[3 * face + (k + 1) % 3]
        if height(mesh, tail, points, normals, row) >= 0 > height(mesh, head, points, normals, row):
            return 3 * face + k
    return -1


@part
def descended(mesh: Mesh, points: Points, normals: Points, row: int, face: int) -> int:
    """The half-edge down through the plane that is reached from a face, face by face; -1 if it is too far."""
    for _ in range(DESCENT):
        edge = edge_down(mesh, points, normals, row, face)
        if edge >= 0:
            return edge
        # To the neighbour across the edge opposite to the corner that is farthest from the plane.
        farthest, most = 0, -1.0
        for k in range(3):
            away = abs(height(mesh, mesh.corners[3 * face + k], points, normals, row))
            if away > most:
                farthest, most = k, away
        face = mesh.twins[3 * face + (farthest + 1) % 3] // 3
    return -1


@part
def segment_distance(mesh: Mesh, points: Points, normals: Points, row: int, face: int, ends: Points) -> float:
    """Distance from a point to the segment in which its plane cuts a face; ``ends`` (2, 3) is scratch space."""
    for k in range(3):
        tail, head = mesh.corners[3 * face + k], mesh.corners[3 * face + (k + 1) % 3]
        a, b = height(mesh, tail, points, normals, row), height(mesh, head, points, normals, row)
        if (a >= 0) != (b >= 0):
            end = 0 if a >= 0 else 1
            for i in range(3):
                ends[end, i] = mesh.vertices[tail, i] + a / (a - b) * (mesh.vertices[head, i] - mesh.vertices[tail, i])
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
    mesh: Mesh,
    searches: int,
    longest: int,
    segment: Points,
    ends: Ints,
    edges: Ints,
    parts: Reals,
) -> bool:
    """For each point, the half-edges down through its plane along one loop.

    The loop is reached from triangle ``near[p]``. If that is -1, or if the plane is far from there, it is the nearest
    loop within ``reach[p]``, three times ``reach[p]`` and so on, ``searches`` times; of several at the same distance,
    that of the first triangle. A loop of more than ``longest`` corners is left out.

    The half-edges of point p end before ``ends[p]``; ``parts`` is the fraction of each above the plane. ``segment``
    (2, 3) is scratch space. Returns False if ``edges`` is too short.
    """
    num, count = len(mesh.order), 0
    for row in range(len(points)):
        first, best = -1, reach[row]
        if near[row] >= 0:
            first = descended(mesh, points, normals, row, near[row])
        for _ in range(searches):
            if first >= 0:
                break
            node, which = 1, num
            while node:
                is_met = is_within(points[row, 0], points[row, 1], points[row, 2], mesh.boxes, node, best * best)
                if is_met and node >= num:
                    face = mesh.order[node - num]
                    edge = edge_down(mesh, points, normals, row, face)
                    if edge >= 0:
                        away = segment_distance(mesh, points, normals, row, face, segment)
                        if away < best or (away == best and face < which):
                            first, best, which = edge, away, face
                node = onward(node, num, is_met)
            best *= 3
        edge, begin = first, count
        while edge >= 0:
            if count - begin == longest:
                count = begin
                break
            if count == len(edges):
                return False
            face, k = edge // 3, edge % 3
            a = height(mesh, mesh.corners[edge], points, normals, row)
            b = height(mesh, mesh.corners[3 * face + (k + 1) % 3], points, normals, row)
            edges[count], parts[count] = edge, a / (a - b)
            count += 1
            # The loop leaves over the next edge if the opposite corner is above the plane, else over the one after.
            opposite = (k + 2) % 3
            is_up = height(mesh, mesh.corners[3 * face + opposite], points, normals, row) >= 0
            edge = mesh.twins[3 * face + (k + 1) % 3 if is_up else 3 * face + opposite]
            if edge == first:
                break
        ends[row] = count
    return True


@kernel
def measures(
    places: Points, leans: Reals, normals: Points, ends: Ints, rows: Ints, flattest: float, found: Points
) -> None:
    """Sums over loops with corners at ``places`` (C, 3) relative to their points, in planes with ``normals`` (P, 3).

    Loop k belongs to point ``rows[k]``, and ends before ``ends[k]``. ``leans`` (C,) is the inward slope of the wall
    after each corner: minus the product of the wall's and the plane's normals. Columns of ``found`` (P, 19), which are
    0 at first: 0 to 2 the centroid, 3 twice the area, 4 the angle around the point, 5 the length, 6 the length times
    the mean distance from the centroid; 7 to 9 and, row by row, 10 to 18 sums of the centroid's derivatives.
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
