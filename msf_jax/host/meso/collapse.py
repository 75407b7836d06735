"""Edge collapse: every edge shorter than t_c goes to its midpoint (article 3.2.4).

Collapses go in rounds. A round takes a maximal set of edges whose ends are not even neighbours of each other's ends,
shortest first and ties by index: such collapses neither touch each other's rings nor change each other's link
condition, so they can be applied at once and the surface stays a closed manifold. After a round only the edges around
the survivors, and those that had to wait, are looked at again: the cost follows the edits, not the mesh.
"""

from typing import NamedTuple

import numpy as np

from msf_jax.host.meso import manifold, ring_tables
from msf_jax.host.meso.meso import Meso
from msf_jax.host.meso.ring_tables import find_slot
from msf_jax.host.solid.geometry import cross


class CollapseRound(NamedTuple):
    """One round of independent collapses, (c,) each: ``removed`` goes into ``survivor``."""

    survivor: np.ndarray
    removed: np.ndarray
    fraction: np.ndarray  # new position = (1 - fraction) survivor + fraction removed
    takes_pole: np.ndarray  # True where the survivor takes the removed vertex's pole


def edge_lengths(positions: np.ndarray, a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Lengths (c,) of the edges ab."""
    difference = positions[a] - positions[b]
    return np.sqrt(np.einsum("ij,ij->i", difference, difference))


def shortest_first(a: np.ndarray, b: np.ndarray, length: np.ndarray, unit: float) -> np.ndarray:
    """Order (c,) of the edges ab by length, ties by index.

    Lengths count as tied when they agree to 1e-6 of ``unit``: equal edges of a symmetric mesh stay tied when rounding
    makes them differ in the last bit, so that a scaled or shifted mesh is edited alike.
    """
    rounded = np.round(length / (1e-6 * unit))
    num_bits = int(max(a.max(initial=0), b.max(initial=0))).bit_length()
    if len(a) and rounded.min() >= 0 and rounded.max() < 2 ** (63 - 2 * num_bits):  # one key is sorted faster
        return np.argsort(rounded.astype(np.int64) << (2 * num_bits) | a.astype(np.int64) << num_bits | b)
    return np.lexsort((b, a, rounded))


def collapse_short_edges(
    meso: Meso, t_c: float, *, keep_faces: bool = False, check: bool = False
) -> list[CollapseRound]:
    """Collapse in place until no edge shorter than ``t_c`` can go; returns the rounds.

    ``keep_faces`` leaves an edge alone where its collapse would turn a face by more than 60 degrees.
    ``check`` verifies after each round that the surface is a closed manifold of the same genus.
    """
    euler = manifold.euler_characteristic(meso.rings) if check else 0
    rounds = []
    edges = _candidates(meso, *ring_tables.edges_from_rings(meso.rings), t_c)
    while True:
        edges = edges.at((meso.degree[edges.left] > 3) & (meso.degree[edges.right] > 3))
        if len(edges.a) == 0:
            return rounds
        order = shortest_first(edges.a, edges.b, edges.length, t_c)
        chosen = _independent(meso.rings, edges.a, edges.b, order)
        is_barred = np.zeros(len(edges.a), dtype=bool)
        if keep_faces:
            is_barred[chosen] = _turns_a_face(meso, edges.a[chosen], edges.b[chosen])
            chosen = chosen[~is_barred[chosen]]
            if len(chosen) == 0:
                edges = edges.at(~is_barred)
                continue
        done = _apply(meso, edges.a[chosen], edges.b[chosen])
        rounds.append(done)
        if check:
            manifold.check_closed_manifold(meso.rings, euler)
        # Look again at the edges around the survivors; those that had to wait further away are what they were.
        is_touched = np.zeros(meso.num_rows + 1, dtype=bool)  # the last entry serves the padding -1
        is_touched[meso.rings[done.survivor]] = True
        is_touched[done.survivor] = True
        is_touched = is_touched[:-1]
        gone = meso.degree == 0
        waiting = edges.at(~(is_touched | gone)[edges.a] & ~(is_touched | gone)[edges.b] & ~is_barred)
        around = _candidates(meso, *ring_tables.edges_around(meso.rings, is_touched), t_c)
        edges = Candidates(*(np.concatenate(pair) for pair in zip(waiting, around, strict=True)))


class Candidates(NamedTuple):
    """Edges ab (c,) that are short and can be collapsed, but for the degrees of their apexes ``left`` and ``right``."""

    a: np.ndarray
    b: np.ndarray
    left: np.ndarray
    right: np.ndarray
    length: np.ndarray

    def at(self, rows: np.ndarray) -> "Candidates":
        """Those of ``rows``."""
        return Candidates(*(values[rows] for values in self))


def _candidates(meso: Meso, a: np.ndarray, b: np.ndarray, t_c: float) -> Candidates:
    """Those of the edges ab that are shorter than ``t_c``, not fixed at both ends, and meet the link condition."""
    length = edge_lengths(meso.positions, a, b)
    is_short = (length < meso.scaled(t_c, a, b)) & ~(meso.is_fixed[a] & meso.is_fixed[b])
    a, b, length = a[is_short], b[is_short], length[is_short]
    has_two = ring_tables.num_common_neighbours(meso.rings, meso.degree, a, b) == 2
    a, b, length = a[has_two], b[has_two], length[has_two]
    return Candidates(a, b, *ring_tables.apexes(meso.rings, meso.degree, a, b), length)


def _place(meso: Meso, a: np.ndarray, b: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Where a collapse of ab, of which b goes, puts a: the fraction (c,) of the way to b, and the position (c, 3)."""
    fraction = np.where(meso.is_fixed[a], 0.0, 0.5)
    return fraction, meso.positions[a] + fraction[:, None] * (meso.positions[b] - meso.positions[a])


def _turns_a_face(meso: Meso, a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """(c,) True where the collapse of ab would turn a face that it leaves by more than 60 degrees, or flatten it."""
    swap = meso.is_fixed[b] & ~meso.is_fixed[a]
    a, b = np.where(swap, b, a), np.where(swap, a, b)
    goal = _place(meso, a, b)[1][:, None]
    turns = np.zeros(len(a), dtype=bool)
    for end, other in ((a, b), (b, a)):
        rows = meso.rings[end, : max(1, int(meso.degree[end].max(initial=1)))]
        following = np.concatenate([rows[:, 1:], np.full((len(rows), 1), -1)], axis=1)
        following = np.where(following < 0, rows[:, :1], following)
        stays = (rows >= 0) & (rows != other[:, None]) & (following != other[:, None])
        one, two, here = meso.positions[rows], meso.positions[following], meso.positions[end][:, None]
        before, after = cross(one - here, two - here), cross(one - goal, two - goal)
        dot = np.einsum("cki,cki->ck", before, after)
        size2 = np.einsum("cki,cki->ck", before, before) * np.einsum("cki,cki->ck", after, after)
        has_area = np.einsum("cki,cki->ck", before, before) > 0
        turns |= (stays & has_area & (dot <= 0.5 * np.sqrt(size2))).any(axis=1)
    return turns


def _independent(rings: np.ndarray, a: np.ndarray, b: np.ndarray, order: np.ndarray) -> np.ndarray:
    """Indices of a maximal set of edges ab, first in ``order`` first, no two with equal or neighbouring ends."""
    num_vertices, num_edges = len(rings), len(a)
    chosen = []
    a, b = a[order], b[order]
    rank = np.arange(num_edges)
    is_blocked = np.zeros(num_vertices, dtype=bool)
    # One more entry than vertices: it stands for the padding -1, and no edge ends there.
    best = np.full(num_vertices + 1, num_edges)
    nearby = best.copy()
    while len(rank):
        best[:] = num_edges
        np.minimum.at(best, a, rank)
        np.minimum.at(best, b, rank)
        ends = np.flatnonzero(best < num_edges)
        least = best[ends]
        for neighbour in rings[ends].T:  # by columns: numpy is slow along short rows
            np.minimum(least, best[neighbour], out=least)
        nearby[ends] = least
        wins = np.minimum(nearby[a], nearby[b]) == rank
        chosen.append(order[rank[wins]])
        for end in (a[wins], b[wins]):
            is_blocked[end] = True
            reach = rings[end]
            is_blocked[reach[reach >= 0]] = True
        open_edges = ~(is_blocked[a] | is_blocked[b])
        a, b, rank = a[open_edges], b[open_edges], rank[open_edges]
    return np.sort(np.concatenate(chosen))


def _apply(meso: Meso, a: np.ndarray, b: np.ndarray) -> CollapseRound:
    """Merge the independent edges ab: splice the two rings into one, rename b around it, drop the two faces."""
    swap = meso.is_fixed[b] & ~meso.is_fixed[a]  # the fixed end survives
    a, b = np.where(swap, b, a), np.where(swap, a, b)
    merged_degree = meso.degree[a] + meso.degree[b] - 4
    meso.widen(int(merged_degree.max()))
    rings = meso.rings
    slot_b, slot_a = find_slot(rings[a], b)[:, None], find_slot(rings[b], a)[:, None]
    degree_a, degree_b = meso.degree[a][:, None], meso.degree[b][:, None]
    left = rings[a, ((slot_b + 1) % degree_a)[:, 0]]
    right = rings[a, ((slot_b - 1) % degree_a)[:, 0]]

    # a's ring from `left` round to `right`, then b's ring from behind `right` to before `left`.
    place = np.arange(rings.shape[1])[None, :]
    in_a, in_b = (slot_b + 1 + place) % degree_a, (slot_a + 2 + place - (degree_a - 1)) % degree_b
    is_from_a = place < degree_a - 1
    merged = np.where(is_from_a, rings[a[:, None], in_a], rings[b[:, None], in_b])
    merged = np.where(place < merged_degree[:, None], merged, -1)

    # b's other neighbours now see a instead of b; the two apexes, which see a already, lose b.
    is_other = (rings[b] >= 0) & (rings[b] != a[:, None])
    is_other &= (rings[b] != left[:, None]) & (rings[b] != right[:, None])
    owner, slot = np.nonzero(is_other)
    other = rings[b[owner], slot]
    other_slot = find_slot(rings[other], b[owner])
    left_slot, right_slot = find_slot(rings[left], b), find_slot(rings[right], b)
    if meso.classes is not None:  # b's edges start at a now: the way a -> b comes before them
        a_to_b = meso.classes[a, slot_b[:, 0]][:, None]
        merged_classes = np.where(is_from_a, meso.classes[a[:, None], in_a], a_to_b + meso.classes[b[:, None], in_b])
        meso.classes[other, other_slot] -= a_to_b[owner, 0]
        meso.classes[a] = merged_classes
    rings[other, other_slot] = a[owner]
    rings[left, left_slot] = -1
    rings[right, right_slot] = -1
    rings[a] = merged
    rings[b] = -1
    _close_gaps(meso, np.concatenate([left, right]))
    meso.degree[a], meso.degree[b] = merged_degree, 0

    fraction, position = _place(meso, a, b)
    reach_a = np.where(meso.has_pole[a], np.linalg.norm(meso.poles[a] - position, axis=1), np.inf)
    reach_b = np.where(meso.has_pole[b], np.linalg.norm(meso.poles[b] - position, axis=1), np.inf)
    takes_pole = reach_b < reach_a
    meso.positions[a] = position
    meso.poles[a] = np.where(takes_pole[:, None], meso.poles[b], meso.poles[a])
    meso.has_pole[a] |= takes_pole
    if meso.trust is not None:
        meso.trust[a] = np.where(takes_pole, meso.trust[b], meso.trust[a])
    if meso.scale is not None:
        meso.scale[a] = np.minimum(meso.scale[a], meso.scale[b])
    if meso.weights is not None:
        meso.weights[a] = (meso.weights[a] + meso.weights[b]) / 2
    meso.merge_map(a, b)
    done = CollapseRound(a, b, fraction, takes_pole)
    meso.edits.append(done)
    return done


def _close_gaps(meso: Meso, vertices: np.ndarray) -> None:
    """Move the neighbours of ``vertices`` to the front of their rows, in order, and count them again."""
    vertices = np.unique(vertices)
    rows = meso.rings[vertices]
    order = np.argsort(rows < 0, axis=1, kind="stable")
    meso.rings[vertices] = np.take_along_axis(rows, order, axis=1)
    if meso.classes is not None:
        meso.classes[vertices] = np.take_along_axis(meso.classes[vertices], order, axis=1)
    meso.degree[vertices] = ring_tables.ring_degrees(rows)
