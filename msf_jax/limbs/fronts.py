"""The compiled loops of geodesic discs: distances on a surface, and the caps that discs around a point cut off."""

from math import inf, pi, sqrt
from typing import NamedTuple

from msf_jax.numerics.compiled import Ints, Points, Reals, Rows, kernel, part

SMALLER = 0.5  # factor on the slenderness of a cap below the area that is given: it must be twice as slender
LEAST_COUNT = 6  # vertices in a disc: below it, a disc is noise of the tessellation
# A disc that cuts off no cap while its radius grows by this factor goes around a handle or a large limb.
HANDLE_GROWTH = 1.5


class FrontSurface(NamedTuple):
    """points: (V, 3). faces: (F, 3), closed and oriented. twins: (3F,) of half-edges. first: (V + 1,) of each vertex'
    part of ``around``, the faces around it, one after another. size: (F, 5) of a face its area, its area vector, and
    the signed volume of its tetrahedron with the origin; a part of a face has the same share of all five."""

    points: Points
    faces: Rows
    twins: Ints
    first: Ints
    around: Ints
    size: Points


class Scratch(NamedTuple):
    """Space for a front. distance: (V,), infinite. state: (V,), 0: see `cap`. order, filled, stack: (V,). key, value:
    (9F,) a heap of distances and vertices. ring: (F,), -1."""

    distance: Reals
    state: Ints
    order: Ints
    filled: Ints
    stack: Ints
    key: Reals
    value: Ints
    ring: Ints


@part
def push(heap: Scratch, size: int, key: float, value: int) -> int:
    """Add an entry to a heap of ``size`` entries; returns the new size."""
    at = size
    while at > 0 and heap.key[(at - 1) // 2] > key:
        heap.key[at], heap.value[at] = heap.key[(at - 1) // 2], heap.value[(at - 1) // 2]
        at = (at - 1) // 2
    heap.key[at], heap.value[at] = key, value
    return size + 1


@part
def pop(heap: Scratch, size: int) -> int:
    """Remove the first entry of a heap of ``size`` entries; returns the new size."""
    size -= 1
    key, value, at = heap.key[size], heap.value[size], 0
    while 2 * at + 1 < size:
        child = 2 * at + 1
        if child + 1 < size and heap.key[child + 1] < heap.key[child]:
            child += 1
        if heap.key[child] >= key:
            break
        heap.key[at], heap.value[at] = heap.key[child], heap.value[child]
        at = child
    heap.key[at], heap.value[at] = key, value
    return size


@part
def product(x: Points, a: int, b: int, c: int) -> float:
    """(b - a) . (c - a)."""
    last = (x[b, 2] - x[a, 2]) * (x[c, 2] - x[a, 2])
    return (x[b, 0] - x[a, 0]) * (x[c, 0] - x[a, 0]) + (x[b, 1] - x[a, 1]) * (x[c, 1] - x[a, 1]) + last


@part
def through(x: Points, a: int, b: int, c: int, from_a: float, from_b: float) -> float:
    """The distance of c, straight through the edge ab, from the point of the unfolded plane that has the distances
    ``from_a`` and ``from_b`` from a and b; infinite if the line misses the edge."""
    length2 = product(x, a, b, b)
    length = sqrt(length2)
    if length <= 0:
        return inf
    cx = product(x, a, b, c) / length
    cy = sqrt(max(product(x, a, c, c) - cx * cx, 0.0))
    px = (from_a * from_a - from_b * from_b + length2) / (2 * length)
    py2 = from_a * from_a - px * px
    if py2 < 0:
        return inf
    py = sqrt(py2)
    meets = px + (cx - px) * py / (py + cy) if py + cy > 0 else -1.0
    return sqrt((cx - px) * (cx - px) + (cy + py) * (cy + py)) if 0 <= meets <= length else inf


@part
def settle(surface: FrontSurface, front: Scratch, vertex: int, size: int) -> int:
    """Update the neighbours' distances through ``vertex``: along edges, and through triangles with two settled corners.
    Returns the heap's new size."""
    x, faces, distance = surface.points, surface.faces, front.distance
    for at in range(surface.first[vertex], surface.first[vertex + 1]):
        face = surface.around[at]
        for k in range(3):
            near = faces[face, k]
            if near == vertex:
                continue
            far = faces[face, 0] + faces[face, 1] + faces[face, 2] - vertex - near
            if front.state[near] == 1:
                target, away = far, through(x, near, vertex, far, distance[near], distance[vertex])
            else:
                target, away = near, distance[vertex] + sqrt(product(x, vertex, near, near))
            if front.state[target] != 1 and away < distance[target]:
                distance[target] = away
                size = push(front, size, away, target)
    return size


@kernel
def spread(surface: FrontSurface, front: Scratch, sources: Ints) -> None:
    """Set ``front.distance`` to the geodesic distances from the nearest of the vertices ``sources`` (k,)."""
    size = 0
    for source in sources:
        front.distance[source] = 0.0
        size = push(front, size, 0.0, source)
    while size:
        vertex = front.value[0]
        size = pop(front, size)
        if front.state[vertex] != 1:
            front.state[vertex] = 1
            size = settle(surface, front, vertex, size)


@part
def odd_corner(surface: FrontSurface, front: Scratch, face: int) -> int:
    """The corner k of a face that alone is settled; k + 3 for the one that alone is not; 6 or 7 if none or all are."""
    count, k = 0, 0
    for each in range(3):
        count += front.state[surface.faces[face, each]] == 1
    if count == 0 or count == 3:
        return 6 + count // 3
    for each in range(3):
        if (front.state[surface.faces[face, each]] == 1) == (count == 1):
            k = each
    return k if count == 1 else k + 3


@part
def ring_through(surface: FrontSurface, front: Scratch, start: int, level: float, number: int, middle: Reals) -> float:
    """Follow the curve at distance ``level`` from the face ``start`` on, and mark its faces with its ``number``.

    Sets ``middle`` (9,) to the curve's length, its first moment, and the size of what is inside it on its faces.
    Returns the length.
    """
    x = surface.points
    for i in range(9):
        middle[i] = 0.0
    face = start
    while front.ring[face] < 0:
        front.ring[face] = number
        k = odd_corner(surface, front, face)
        corner = k % 3
        p, a, b = (
            surface.faces[face, corner],
            surface.faces[face, (corner + 1) % 3],
            surface.faces[face, (corner + 2) % 3],
        )
        s = (level - front.distance[p]) / (front.distance[a] - front.distance[p])
        t = (level - front.distance[p]) / (front.distance[b] - front.distance[p])
        length2 = 0.0
        for i in range(3):
            step = s * (x[a, i] - x[p, i]) - t * (x[b, i] - x[p, i])
            length2 += step * step
        length = sqrt(length2)
        middle[0] += length
        for i in range(3):
            middle[1 + i] += length * (x[p, i] + (s * (x[a, i] - x[p, i]) + t * (x[b, i] - x[p, i])) / 2)
        for i in range(5):
            middle[4 + i] += surface.size[face, i] * (s * t if k < 3 else 1 - s * t)
        # On through the edge that has the disc on its left: from the corner before, or from the corner that is out.
        face = surface.twins[3 * face + ((corner + 2) % 3 if k < 3 else corner)] // 3
    return middle[0]


@part
def islands(surface: FrontSurface, front: Scratch, count: int, longest: int, inside: float, extra: Reals) -> int:
    """Fill what smaller rings cut off besides the disc. Returns the number of filled vertices, -1 if one of these parts
    is larger than the disc of area ``inside``, or ends at the ring ``longest`` too. ``extra`` (5,) gets their size.
    """
    num, top = 0, 0
    for i in range(5):
        extra[i] = 0.0
    for number in range(count):
        vertex = front.order[number]
        for at in range(surface.first[vertex], surface.first[vertex + 1]):
            face = surface.around[at]
            if front.ring[face] < 0 or front.ring[face] == longest:
                continue
            for k in range(3):
                if front.state[surface.faces[face, k]] == 0:
                    front.state[surface.faces[face, k]] = 2
                    front.filled[num] = front.stack[top] = surface.faces[face, k]
                    num, top = num + 1, top + 1
            while top:
                top -= 1
                here = front.stack[top]
                for beside in range(surface.first[here], surface.first[here + 1]):
                    other = surface.around[beside]
                    for i in range(5):
                        extra[i] += surface.size[other, i] / 3
                    if front.ring[other] == longest or extra[0] > inside:
                        for each in range(num):
                            front.state[front.filled[each]] = 0
                        return -1
                    for k in range(3):
                        if front.state[surface.faces[other, k]] == 0:
                            front.state[surface.faces[other, k]] = 2
                            front.filled[num] = front.stack[top] = surface.faces[other, k]
                            num, top = num + 1, top + 1
    return num


@kernel
def cap(
    surface: FrontSurface,
    front: Scratch,
    tip: int,
    level: float,
    ratio: float,
    enough: float,
    small: float,
    most: float,
    is_other: Ints,
    found: Points,
    region: Ints,
) -> int:
    """Grow a disc around the vertex ``tip``, and measure the caps that it cuts off (see `caps`).

    Rows of ``found`` (k, 9): slenderness, radius, area and middle of each cap; the rest is scratch space. That of a cap
    below the area ``small`` is multiplied by `SMALLER`. That of a cap without volume, when a fan over its curve closes
    it, is 0: it is a pocket. Radii grow from ``level`` by the factor ``ratio``, until a cap has ``enough`` slenderness,
    or more than the area ``most``, or holds a vertex of ``is_other`` (V,) besides the tip. The last four rows are
    scratch space. ``region`` (V + 1,) gets the vertices of the slenderest cap, and -1 after them. Returns the number of
    rows.
    """
    rows, count, size_of_region, last, slenderest = 0, 0, 0, inf, -inf
    middle, best = found[len(found) - 1], found[len(found) - 2]
    extra, whole = found[len(found) - 3], found[len(found) - 4]
    front.distance[tip] = 0.0
    size = push(front, 0, 0.0, tip)
    goes_on = True
    while size and goes_on:
        vertex, away = front.value[0], front.key[0]
        if away < level:
            size = pop(front, size)
            if front.state[vertex] != 1:
                front.state[vertex] = 1
                front.order[count] = vertex
                count += 1
                goes_on = vertex == tip or is_other[vertex] == 0
                size = settle(surface, front, vertex, size)
            continue
        if count >= LEAST_COUNT and rows < len(found) - 4:
            rings, longest = 0, 0
            for i in range(5):
                whole[i] = 0.0
            best[0] = 0.0
            for number in range(count):
                for at in range(surface.first[front.order[number]], surface.first[front.order[number] + 1]):
                    face = surface.around[at]
                    kind = odd_corner(surface, front, face)
                    if kind == 7:
                        for i in range(5):
                            whole[i] += surface.size[face, i] / 3
                    elif front.ring[face] < 0:
                        if ring_through(surface, front, face, level, rings, middle) > best[0]:
                            longest = rings
                            for i in range(4):
                                best[i] = middle[i]
                        for i in range(5):
                            whole[i] += middle[4 + i]
                        rings += 1
            num = 0
            if rings > 1:
                num = islands(surface, front, count, longest, whole[0], extra)
                if num > 0:
                    for i in range(5):
                        whole[i] += extra[i]
                for number in range(num):
                    goes_on = goes_on and is_other[front.filled[number]] == 0
            for number in range(count):
                for at in range(surface.first[front.order[number]], surface.first[front.order[number] + 1]):
                    front.ring[surface.around[at]] = -1
            if whole[0] > most or level > HANDLE_GROWTH * last:
                goes_on = False
            elif goes_on and num >= 0 and best[0] > 0:
                slenderness, volume = 2 * pi * whole[0] / (best[0] * best[0]) - 0.5, whole[4]
                for i in range(3):
                    found[rows, 3 + i] = best[1 + i] / best[0]
                    volume -= found[rows, 3 + i] * whole[1 + i] / 3
                slenderness = slenderness if volume > 0 else 0.0
                found[rows, 0] = slenderness if whole[0] >= small else SMALLER * slenderness
                found[rows, 1], found[rows, 2], found[rows, 6] = level, whole[0], volume
                goes_on = found[rows, 0] < enough
                if found[rows, 0] > slenderest:
                    slenderest, size_of_region = found[rows, 0], count + num
                    for number in range(count):
                        region[number] = front.order[number]
                    for number in range(num):
                        region[count + number] = front.filled[number]
                rows, last = rows + 1, level
            for number in range(num):
                front.state[front.filled[number]] = 0
        level *= ratio
    if size_of_region < len(region):
        region[size_of_region] = -1
    for vertex in range(len(front.distance)):
        front.distance[vertex], front.state[vertex] = inf, 0
    return rows
