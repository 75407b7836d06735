"""The compiled loops of edits: finding edges that are short, or opposite wide angles, and editing the surface there.

The loops that find edges go through a ring table (see `ring_tables`) row by row, and visit every edge once, as (a, b)
with a < b. They visit only edges at `touched` vertices; at first all vertices are touched. Edges found before wait in
the first rows of a table: they stay there if both ends are untouched, and the row was not struck out (a = -1).
"""

from math import inf, sqrt
from typing import NamedTuple

from msf_jax.numerics.compiled import Flags, Ints, Points, Reals, Rows, kernel, part


class MesoArrays(NamedTuple):
    """The arrays of a `meso.Meso`, with neutral values for those that are None there: 0 for classes, 1 for scale,
    and weights of shape (n, 0)."""

    positions: Points
    rings: Rows
    degree: Ints
    classes: Rows
    poles: Points
    has_pole: Flags
    is_fixed: Flags
    scale: Reals
    weights: Points


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


@part
def still_waiting(found: Rows, value: Points, waiting: int, touched: Flags) -> int:
    """Move the edges of the first ``waiting`` rows that still wait to the first rows, and return their number."""
    count = 0
    for row in range(waiting):
        if found[row, 0] >= 0 and not touched[found[row, 0]] and not touched[found[row, 1]]:
            for k in range(5):
                found[count, k] = found[row, k]
            value[count, 0], value[count, 1] = value[row, 0], value[row, 1]
            count += 1
    return count


@kernel
def short_edges(
    x: Points,
    rings: Rows,
    degree: Ints,
    scale: Reals,
    limit: float,
    touched: Flags,
    waiting: int,
    found: Rows,
    value: Points,
) -> int:
    """Find the edges at ``touched`` (n,) vertices shorter than ``limit`` times the smaller ``scale`` of their ends.

    Rows of ``found``: a, b, the apexes to the left and to the right, and the number of common neighbours of a and b.
    ``value``: the length, 0. The first ``waiting`` rows are edges found before. Returns the number of edges.
    """
    count = still_waiting(found, value, waiting, touched)
    for vertex in range(len(rings)):
        for slot in range(degree[vertex] if touched[vertex] else 0):
            if is_met_later(rings, touched, vertex, slot):
                continue
            a, b = min(vertex, rings[vertex, slot]), max(vertex, rings[vertex, slot])
            length = sqrt(dot(x, b, a, b, a))
            if length >= limit * min(scale[a], scale[b]):
                continue
            common = 0
            for i in range(degree[a]):
                for j in range(degree[b]):
                    common += rings[a, i] == rings[b, j]
            place = slot_of(rings, a, b)
            found[count, 0], found[count, 1], found[count, 4] = a, b, common
            found[count, 2] = rings[a, (place + 1) % degree[a]]
            found[count, 3] = rings[a, (place - 1) % degree[a]]
            value[count, 0], value[count, 1] = length, 0.0
            count += 1
    return count


@kernel
def wide_edges(
    x: Points,
    rings: Rows,
    degree: Ints,
    scale: Reals,
    limit: float,
    least: float,
    touched: Flags,
    waiting: int,
    found: Rows,
    value: Points,
) -> int:
    """Find the edges at ``touched`` (n,) vertices that are longer than ``limit`` times the smaller ``scale`` of their
    ends, and opposite two angles whose cosines are below ``least``.

    Rows of ``found``: a, b, the apexes to the left and to the right, the apex with the wider angle. ``value``: the
    length, and the fraction of it from a to where that apex projects. The first ``waiting`` rows are edges found
    before. Returns the number of edges.
    """
    count = still_waiting(found, value, waiting, touched)
    for vertex in range(len(rings)):
        for slot in range(degree[vertex] if touched[vertex] else 0):
            if is_met_later(rings, touched, vertex, slot):
                continue
            a, b = min(vertex, rings[vertex, slot]), max(vertex, rings[vertex, slot])
            length2 = dot(x, a, b, a, b)
            if sqrt(length2) <= limit * min(scale[a], scale[b]):
                continue
            place = slot_of(rings, a, b)
            left, right = rings[a, (place + 1) % degree[a]], rings[a, (place - 1) % degree[a]]
            at_left, at_right = cosine(x, left, a, b), cosine(x, right, a, b)
            if at_left < least and at_right < least:
                apex = left if at_left <= at_right else right
                found[count, 0], found[count, 1], found[count, 2], found[count, 3] = a, b, left, right
                found[count, 4] = apex
                value[count, 0], value[count, 1] = sqrt(length2), dot(x, a, apex, a, b) / length2
                count += 1
    return count


@kernel
def apart(claims: Rows, order: Ints, is_taken: Flags, found: Flags) -> None:
    """``found`` (c,): a maximal set of rows of ``claims`` (c, k), ids of vertices, chosen greedily in ``order``, so
    that no row has a taken vertex. A chosen row takes its vertices."""
    for row in order:
        is_free = True
        for k in range(claims.shape[1]):
            is_free = is_free and not is_taken[claims[row, k]]
        for k in range(claims.shape[1] if is_free else 0):
            is_taken[claims[row, k]] = True
        found[row] = is_free


@part
def flag_around(rings: Rows, degree: Ints, vertex: int, flags: Flags) -> None:
    """Set the flags of a vertex and of its neighbours."""
    flags[vertex] = True
    for slot in range(degree[vertex]):
        flags[rings[vertex, slot]] = True


@part
def turns_a_face(surface: MesoArrays, end: int, one: int, two: int, share: float) -> bool:
    """Whether ``end``, if it moved the ``share`` of the way from ``one`` to ``two``, of which it is one, would turn a
    face at it that stays by more than 60 degrees, or make it degenerate."""
    x, rings, num = surface.positions, surface.rings, surface.degree[end]
    for slot in range(num):
        here, there = rings[end, slot], rings[end, (slot + 1) % num]
        if here in (one, two) or there in (one, two):
            continue
        product, before2, after2 = 0.0, 0.0, 0.0
        for axis in (0, 2, 1):  # in the order of `dot`
            i, j = (axis + 1) % 3, (axis + 2) % 3
            a_i, a_j, b_i, b_j, c_i, c_j = x[here, i], x[here, j], x[there, i], x[there, j], x[end, i], x[end, j]
            before = (a_i - c_i) * (b_j - c_j) - (a_j - c_j) * (b_i - c_i)
            c_i, c_j = x[one, i] + share * (x[two, i] - x[one, i]), x[one, j] + share * (x[two, j] - x[one, j])
            after = (a_i - c_i) * (b_j - c_j) - (a_j - c_j) * (b_i - c_i)
            product, before2, after2 = product + before * after, before2 + before * before, after2 + after * after
        if before2 > 0 and product <= 0.5 * sqrt(before2 * after2):
            return True
    return False


@part
def merge_rings(rings: Rows, degree: Ints, classes: Rows, one: int, two: int, merged: Rows) -> None:
    """Merge ``two`` into ``one``: splice the two rings into one, replace two by one in other rings, drop the two faces
    between them."""
    slot, twin = slot_of(rings, one, two), slot_of(rings, two, one)
    left, right = rings[one, (slot + 1) % degree[one]], rings[one, (slot - 1) % degree[one]]
    shift = classes[one, slot]  # the edges of `two` start at `one` now, so the class from one to two is added to theirs
    # The ring of `one` from `left` round to `right`, then that of `two` from after `right` to before `left`.
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
    # The other neighbours of `two` now have `one` instead; the two apexes, which have it already, lose `two`.
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


@part
def distance_to_pole(surface: MesoArrays, vertex: int, place: int) -> float:
    """From the vertex ``place`` to the pole of ``vertex``, infinite without one."""
    x, y = surface.positions, surface.poles
    squares = (y[vertex, 0] - x[place, 0]) ** 2 + (y[vertex, 1] - x[place, 1]) ** 2
    return sqrt(squares + (y[vertex, 2] - x[place, 2]) ** 2) if surface.has_pole[vertex] else inf


@part
def merge_data(surface: MesoArrays, one: int, two: int, share: float) -> bool:
    """Move ``one`` the ``share`` of the way to ``two``, and merge their data; returns whether it takes two's pole, the
    nearer one."""
    for axis in range(3):
        surface.positions[one, axis] += share * (surface.positions[two, axis] - surface.positions[one, axis])
    takes_pole = distance_to_pole(surface, two, one) < distance_to_pole(surface, one, one)
    if takes_pole:
        surface.has_pole[one] = True
        for axis in range(3):
            surface.poles[one, axis] = surface.poles[two, axis]
    surface.scale[one] = min(surface.scale[one], surface.scale[two])
    for k in range(surface.weights.shape[1]):
        surface.weights[one, k] += share * (surface.weights[two, k] - surface.weights[one, k])
    return takes_pole


@kernel
def collapse(
    surface: MesoArrays,
    order: Ints,
    found: Rows,
    keeps_faces: bool,
    is_taken: Flags,
    touched: Flags,
    merged: Rows,
    done: Rows,
    fraction: Reals,
) -> int:
    """Collapse a maximal set of the edges ``found``, greedily in ``order``, in which no ends are equal or neighbours.

    Edges that cannot be collapsed are struck out: the rings do not allow it, both ends are fixed, or, if
    ``keeps_faces``, a face would turn. A fixed end survives.

    Flags ``is_taken`` and ``touched`` (n,) are False at first; at the end ``touched`` has the vertices of edges that
    have changed. ``merged`` (2, K) is scratch memory. Rows of ``done``: the survivor, the removed vertex, and whether
    the survivor takes its pole; ``fraction``: of the way that the survivor moves to it. Returns how many there are.
    """
    rings, degree, is_fixed = surface.rings, surface.degree, surface.is_fixed
    count = 0
    for row in order:
        one, two, left, right = found[row, 0], found[row, 1], found[row, 2], found[row, 3]
        if found[row, 4] != 2 or (is_fixed[one] and is_fixed[two]) or min(degree[left], degree[right]) <= 3:
            found[row, 0] = -1
            continue
        if is_taken[one] or is_taken[two]:
            continue
        flag_around(rings, degree, one, is_taken)
        flag_around(rings, degree, two, is_taken)
        if is_fixed[two]:
            one, two = two, one
        share = 0.0 if is_fixed[one] else 0.5
        if keeps_faces and (turns_a_face(surface, one, one, two, share) or turns_a_face(surface, two, one, two, share)):
            found[row, 0] = -1
            continue
        merge_rings(rings, degree, surface.classes, one, two, merged)
        done[count, 0], done[count, 1], fraction[count] = one, two, share
        done[count, 2] = merge_data(surface, one, two, share)
        touched[two] = True
        flag_around(rings, degree, one, touched)
        count += 1
    return count


@kernel
def cut(surface: MesoArrays, a: Ints, b: Ints, fraction: Reals) -> None:
    """Insert the last rows of ``surface`` as vertices on the edges ab (c,), which share no face, each at its
    ``fraction`` from a to b.

    The edge from the new vertex to b has class 0. What the new vertex has of its ends is interpolated.
    """
    rings, degree, classes = surface.rings, surface.degree, surface.classes
    for row in range(len(a)):
        new, one, two, t = len(rings) - len(a) + row, a[row], b[row], fraction[row]
        to_new, back = slot_of(rings, one, two), slot_of(rings, two, one)
        left, right = rings[one, (to_new + 1) % degree[one]], rings[one, (to_new - 1) % degree[one]]
        rings[new, 0], rings[new, 1], rings[new, 2], rings[new, 3] = two, left, one, right
        classes[new, 2], classes[two, back] = classes[two, back], 0
        rings[one, to_new], rings[two, back] = new, new
        # The new vertex goes between a and b: a comes before b around the left apex, after b around the right one.
        for side in range(2):
            beside, before = (left, one) if side == 0 else (right, two)
            at = slot_of(rings, beside, before) + 1
            own = classes[beside, slot_of(rings, beside, two)]
            for place in range(degree[beside], at, -1):
                rings[beside, place], classes[beside, place] = rings[beside, place - 1], classes[beside, place - 1]
            rings[beside, at], classes[beside, at], classes[new, 1 + 2 * side] = new, own, -own
            degree[beside] += 1
        degree[new] = 4
        for axis in range(3):
            surface.positions[new, axis] = (1 - t) * surface.positions[one, axis] + t * surface.positions[two, axis]
            surface.poles[new, axis] = (1 - t) * surface.poles[one, axis] + t * surface.poles[two, axis]
        surface.scale[new] = (1 - t) * surface.scale[one] + t * surface.scale[two]
        for k in range(surface.weights.shape[1]):
            surface.weights[new, k] = (1 - t) * surface.weights[one, k] + t * surface.weights[two, k]
