"""The compiled loops of edits: which edges are short, or lie across from wide angles, and surgery on ordered one-rings.

A ring table (see `ring_tables`) is walked row by row; every edge is met once, as (a, b) with a < b. Edges are looked at
around vertices that are `touched` only, all of them at first.
"""

from math import sqrt

from msf_jax.host.compiled import Flags, Ints, Points, Reals, Rows, kernel, part


@part
def slot_of(rings: Rows, vertex: int, neighbour: int) -> int:
    """Where ``neighbour``, which must be there, stands in the ring of ``vertex``."""
    slot = 0
    while rings[vertex, slot] != neighbour:
        slot += 1
    return slot


@part
def dot(x: Points, a: int, b: int, c: int, d: int) -> float:
    """(b - a) . (d - c), added as NumPy's `einsum` does, or bits differ."""
    last = (x[b, 2] - x[a, 2]) * (x[d, 2] - x[c, 2])
    return (x[b, 0] - x[a, 0]) * (x[d, 0] - x[c, 0]) + last + (x[b, 1] - x[a, 1]) * (x[d, 1] - x[c, 1])


@part
def cosine(x: Points, apex: int, a: int, b: int) -> float:
    """Of the angle that ab subtends at ``apex``; 1 where the apex coincides with an end."""
    product = sqrt(dot(x, apex, a, apex, a) * dot(x, apex, b, apex, b))
    return dot(x, apex, a, apex, b) / product if product > 0 else 1.0


@part
def is_met_later(rings: Rows, touched: Flags, vertex: int, slot: int) -> bool:
    """Whether the edge in a slot of the ring of a touched vertex is taken from its other end, or is none."""
    other = rings[vertex, slot]
    return bool(other < 0 or (other < vertex and touched[other]))


@kernel
def short_edges(x: Points, rings: Rows, degree: Ints, scale: Reals, limit: float, touched: Flags, found: Rows) -> int:
    """How many edges at ``touched`` (n,) vertices are shorter than ``limit``, times the smaller ``scale`` of the ends.

    Rows of ``found``: a, b, the apexes to the left and to the right, and how many neighbours a and b have in common.
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
    """How many edges at ``touched`` (n,) vertices are longer than ``limit``, times the smaller ``scale`` of their ends,
    and across from two angles whose cosines are below ``least``.

    Rows of ``found``: a, b, the apexes to the left and to the right, and that with the wider angle.
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
    """``found`` (c,): a maximal set of rows of ``claims`` (c, k), vertices none of which is taken before, first in
    ``order`` first. One takes its vertices and their neighbours in ``rings``, which has no columns if it takes none."""
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
    """Merge b (c,) into a (c,): splice the two rings into one, rename b around it, drop the two faces.

    ``classes`` (n, K) go with ``rings``. ``merged`` (2, K) is room.
    """
    for row in range(len(a)):
        one, two = a[row], b[row]
        slot, twin = slot_of(rings, one, two), slot_of(rings, two, one)
        left, right = rings[one, (slot + 1) % degree[one]], rings[one, (slot - 1) % degree[one]]
        way = classes[one, slot]  # b's edges start at a now: the way a -> b comes before them
        # a's ring from `left` round to `right`, then b's ring from behind `right` to before `left`.
        count = degree[one] + degree[two] - 4
        for place in range(rings.shape[1]):
            merged[0, place], merged[1, place] = -1, 0
            if place < degree[one] - 1:
                source, at = one, (slot + 1 + place) % degree[one]
            else:
                source, at = two, (twin + 3 + place - degree[one]) % degree[two]
            if place < count:
                merged[0, place] = rings[source, at]
                merged[1, place] = classes[source, at] + (way if source == two else 0)
        # b's other neighbours now see a instead of b; the two apexes, which see a already, lose b.
        for place in range(degree[two]):
            other = rings[two, place]
            if other == one:
                continue
            at = slot_of(rings, other, two)
            if other != left and other != right:
                rings[other, at] = one
                classes[other, at] -= way
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
    """Put the last rows of ``rings`` in the middle of the edges ab (c,), each between its two apexes.

    ``classes`` go with ``rings``. The new vertex is as good as b: the way from there to b has class 0.
    """
    for row in range(len(a)):
        new = len(rings) - len(a) + row
        to_new, back = slot_of(rings, a[row], b[row]), slot_of(rings, b[row], a[row])
        rings[new, 0], rings[new, 1], rings[new, 2], rings[new, 3] = b[row], left[row], a[row], right[row]
        classes[new, 2], classes[b[row], back] = classes[b[row], back], 0
        rings[a[row], to_new], rings[b[row], back] = new, new
        # Around the left apex a comes before b, around the right one b before a: the new vertex goes between them.
        for side in range(2):
            beside, before = (left[row], a[row]) if side == 0 else (right[row], b[row])
            at = slot_of(rings, beside, before) + 1
            way = classes[beside, slot_of(rings, beside, b[row])]
            for place in range(degree[beside], at, -1):
                rings[beside, place], classes[beside, place] = rings[beside, place - 1], classes[beside, place - 1]
            rings[beside, at], classes[beside, at], classes[new, 1 + 2 * side] = new, way, -way
            degree[beside] += 1
        degree[new] = 4
