"""The compiled loops of edits: finding edges that are short, or opposite wide angles, and editing ordered one-rings.

The loops go through a ring table (see `ring_tables`) row by row, and visit every edge once, as (a, b) with a < b. They
visit only edges at `touched` vertices; at first all vertices are touched.
"""

from math import sqrt

from msf_jax.host.compiled import Flags, Ints, Points, Reals, Rows, kernel, part


@part
def slot_of(rings: Rows, vertex: int, neighbour: int) -> int:
    """The slot of ``neighbour``, which must exist, in the ring of ``vertex``."""
    slot = 0
    while rings[vertex, slot] != neighbour:
        slot += 1
    return slot


@part
def dot(x: Points, a: int, b: int, c: int, d: int) -> float:
    """(b - a) . (d - c), summed in the order of NumPy's `einsum`, for the same bits."""
    last = (x[b, 2] - x[a, 2]) * (x[d, 2] - x[c, 2])
    return (x[b, 0] - x[a, 0]) * (x[d, 0] - x[c, 0]) + last + (x[b, 1] - x[a, 1]) * (x[d, 1] - x[c, 1])


@part
def cosine(x: Points, apex: int, a: int, b: int) -> float:
    """The cosine of the angle that ab subtends at ``apex``; 1 if the apex coincides with an end."""
    product = sqrt(dot(x, apex, a, apex, a) * dot(x, apex, b, apex, b))
    return dot(x, apex, a, apex, b) / product if product > 0 else 1.0


@part
def is_met_later(rings: Rows, touched: Flags, vertex: int, slot: int) -> bool:
    """Whether the slot of a touched vertex is empty, or its edge is visited from its other end."""
    other = rings[vertex, slot]
    return bool(other < 0 or (other < vertex and touched[other]))


@kernel
def short_edges(x: Points, rings: Rows, degree: Ints, scale: Reals, limit: float, touched: Flags, found: Rows) -> int:
    """Find the edges at ``touched`` (n,) vertices shorter than ``limit`` times the smaller ``scale`` of their ends.

    Rows of ``found``: a, b, the apexes to the left and to the right, and the number of common neighbours of a and b.
    Returns the number of edges.
    """
    count = 0
    for vertex in range(len(rings)):
        for slot in range(degree[vertex] if touched[vertex] else 0):
            a, b = min(vertex, rings[vertex, slot]), max(vertex, rings[vertex, slot])
            if is_met_later(rings, touched, vertex, slot) or sqrt(dot(x, b, a, b, a)) >= limit * min(
                scale[a], scale[b]
            ):
                continue
            common = 0
            for i in range(degree[a]):
                for j in range(degree[b]):
                    common += rings[a, i] == rings[b, j]
            place = slot_of(rings, a, b)
            found[count, 0], found[count, 1], found[count, 4] = a, b, common
            found[count, 2] = rings[a, (place + 1) % degree[a]]
            found[count, 3] = rings[a, (place - 1) % degree[a]]
            count += 1
    return count


@kernel
def wide_edges(
    x: Points, rings: Rows, degree: Ints, scale: Reals, limit: float, least: float, touched: Flags, found: Rows
) -> int:
    """Find the edges at ``touched`` (n,) vertices that are longer than ``limit`` times the smaller ``scale`` of their
    ends, and opposite two angles whose cosines are below ``least``.

    Rows of ``found``: a, b, the apexes to the left and to the right, the apex with the wider angle. Returns the number.
    """
    count = 0
    for vertex in range(len(rings)):
        for slot in range(degree[vertex] if touched[vertex] else 0):
            a, b = min(vertex, rings[vertex, slot]), max(vertex, rings[vertex, slot])
            if is_met_later(rings, touched, vertex, slot) or sqrt(dot(x, b, a, b, a)) <= limit * min(
                scale[a], scale[b]
            ):
                continue
            place = slot_of(rings, a, b)
            left, right = rings[a, (place + 1) % degree[a]], rings[a, (place - 1) % degree[a]]
            at_left, at_right = cosine(x, left, a, b), cosine(x, right, a, b)
            if at_left < least and at_right < least:
                found[count, 0], found[count, 1], found[count, 2], found[count, 3] = a, b, left, right
                found[count, 4] = left if at_left <= at_right else right
                count += 1
    return count


@kernel
def apart(claims: Rows, order: Ints, rings: Rows, is_taken: Flags, found: Flags) -> None:
    """``found`` (c,): a maximal set of rows of ``claims`` (c, k), ids of vertices, chosen greedily in ``order``, so
    that no row has a taken vertex. A chosen row takes its vertices and their neighbours in ``rings``, if that has
    columns."""
    for row in order:
        is_free = True
        for k in range(claims.shape[1]):
            is_free = is_free and not is_taken[claims[row, k]]
        for k in range(claims.shape[1] if is_free else 0):
            is_taken[claims[row, k]] = True
            for slot in range(rings.shape[1]):
                if rings[claims[row, k], slot] >= 0:
                    is_taken[rings[claims[row, k], slot]] = True
        found[row] = is_free


@kernel
def merge(a: Ints, b: Ints, rings: Rows, degree: Ints, classes: Rows, merged: Rows) -> None:
    """Merge b (c,) into a (c,): splice the two rings into one, replace b by a in other rings, drop the two faces.

    ``classes`` (n, K) are those of ``rings``. ``merged`` (2, K) is scratch memory.
    """
    for row in range(len(a)):
        one, two = a[row], b[row]
        slot, twin = slot_of(rings, one, two), slot_of(rings, two, one)
        left, right = rings[one, (slot + 1) % degree[one]], rings[one, (slot - 1) % degree[one]]
        shift = classes[one, slot]  # b's edges start at a now, so the class of a -> b is added to theirs
        # a's ring from `left` round to `right`, then b's ring from after `right` to before `left`.
        count = degree[one] + degree[two] - 4
        for place in range(rings.shape[1]):
            merged[0, place], merged[1, place] = -1, 0
            if place < degree[one] - 1:
                source, at = one, (slot + 1 + place) % degree[one]
            else:
                source, at = two, (twin + 3 + place - degree[one]) % degree[two]
            if place < count:
                merged[0, place] = rings[source, at]
                merged[1, place] = classes[source, at] + (shift if source == two else 0)
        # b's other neighbours now have a instead of b; the two apexes, which have a already, lose b.
        for place in range(degree[two]):
            other = rings[two, place]
            if other == one:
                continue
            at = slot_of(rings, other, two)
            if other != left and other != right:
                rings[other, at] = one
                classes[other, at] -= shift
                continue
            degree[other] -= 1
            for after in range(at, degree[other]):
                rings[other, after], classes[other, after] = rings[other, after + 1], classes[other, after + 1]
            rings[other, degree[other]] = -1
        for place in range(rings.shape[1]):
            rings[one, place], rings[two, place] = merged[0, place], -1
            classes[one, place] = merged[1, place]
        degree[one], degree[two] = count, 0


@kernel
def cut(a: Ints, b: Ints, left: Ints, right: Ints, rings: Rows, degree: Ints, classes: Rows) -> None:
    """Insert the last rows of ``rings`` as vertices on the edges ab (c,), each between its two apexes.

    ``classes`` are those of ``rings``. The edge from the new vertex to b has class 0.
    """
    for row in range(len(a)):
        new = len(rings) - len(a) + row
        to_new, back = slot_of(rings, a[row], b[row]), slot_of(rings, b[row], a[row])
        rings[new, 0], rings[new, 1], rings[new, 2], rings[new, 3] = b[row], left[row], a[row], right[row]
        classes[new, 2], classes[b[row], back] = classes[b[row], back], 0
        rings[a[row], to_new], rings[b[row], back] = new, new
        # The new vertex goes between a and b: a comes before b around the left apex, after b around the right one.
        for side in range(2):
            beside, before = (left[row], a[row]) if side == 0 else (right[row], b[row])
            at = slot_of(rings, beside, before) + 1
            own = classes[beside, slot_of(rings, beside, b[row])]
            for place in range(degree[beside], at, -1):
                rings[beside, place], classes[beside, place] = rings[beside, place - 1], classes[beside, place - 1]
            rings[beside, at], classes[beside, at], classes[new, 1 + 2 * side] = new, own, -own
            degree[beside] += 1
        degree[new] = 4
