"""Edge split: an edge with two obtuse opposite angles is cut where an apex projects on it (article 3.2.4).

The collapse leaves long thin triangles; cutting their longest edge gives the contraction a vertex to move there. The
new vertex lies on the old edge, so the shape does not change, and has no pole of its own: the interpolated one, at the
same fraction of the edge, is carried along but does not pull.
"""

from typing import NamedTuple

import numpy as np

from msf_jax.host.meso import manifold, ring_tables
from msf_jax.host.meso.collapse import edge_lengths, shortest_first
from msf_jax.host.meso.meso import Meso
from msf_jax.host.meso.ring_tables import find_slot


class SplitRound(NamedTuple):
    """One round of independent splits, (c,) each: the new vertex is (1 - fraction) a + fraction b.

    That is where ``apex`` projects on ab; None where the fraction was given.
    """

    a: np.ndarray
    b: np.ndarray
    new: np.ndarray
    fraction: np.ndarray
    apex: np.ndarray | None


def split_obtuse_edges(
    meso: Meso, angle: float, shortest: float, max_rows: int, *, check: bool = False
) -> tuple[list[SplitRound], bool]:
    """Split in place until no edge longer than ``shortest`` has two opposite angles over ``angle`` degrees.

    Returns the rounds, and whether it stopped early rather than let the surface outgrow ``max_rows``.
    """
    euler = manifold.euler_characteristic(meso.rings) if check else 0
    cosine = np.cos(np.radians(angle))
    rounds = []
    a, b = ring_tables.edges_from_rings(meso.rings)
    while True:
        keep = edge_lengths(meso.positions, a, b) > meso.scaled(shortest, a, b)
        a, b = a[keep], b[keep]
        left, right = ring_tables.apexes(meso.rings, meso.degree, a, b)
        cos_left = _cos_at(meso.positions, left, a, b)
        cos_right = _cos_at(meso.positions, right, a, b)
        is_obtuse = (cos_left < cosine) & (cos_right < cosine)
        a, b, left, right = a[is_obtuse], b[is_obtuse], left[is_obtuse], right[is_obtuse]
        apex = np.where(cos_left[is_obtuse] <= cos_right[is_obtuse], left, right)
        along = meso.positions[b] - meso.positions[a]
        length2 = np.einsum("ij,ij->i", along, along)
        fraction = np.einsum("ij,ij->i", meso.positions[apex] - meso.positions[a], along) / length2
        chosen = _disjoint(
            np.stack([a, b, left, right], axis=1), shortest_first(a, b, -np.sqrt(length2), shortest), meso.num_rows
        )
        is_full = meso.num_live + len(chosen) > max_rows
        if len(chosen) == 0 or is_full:
            return rounds, is_full
        rounds.append(split_edges(meso, a[chosen], b[chosen], fraction[chosen], apex[chosen]))
        if check:
            manifold.check_closed_manifold(meso.rings, euler)
        # Look again at the edges of the cut faces, and at those that had to wait.
        is_touched = np.zeros(meso.num_rows, dtype=bool)
        is_touched[np.concatenate([rounds[-1].new, left[chosen], right[chosen], a[chosen], b[chosen]])] = True
        waits = ~(is_touched[a] | is_touched[b])
        around_a, around_b = ring_tables.edges_around(meso.rings, is_touched)
        a, b = np.concatenate([a[waits], around_a]), np.concatenate([b[waits], around_b])


def split_long_edges(meso: Meso, longest: float | np.ndarray, *, check: bool = False) -> None:
    """Halve every edge longer than ``longest``, longest first, until none is left.

    A limit for each vertex (n,) holds for an edge by the mean of its ends', and a new vertex has that mean.
    """
    euler = manifold.euler_characteristic(meso.rings) if check else 0
    limit = np.broadcast_to(np.asarray(longest, dtype=np.float64), meso.num_rows)
    while True:
        a, b = ring_tables.edges_from_rings(meso.rings)
        excess = edge_lengths(meso.positions, a, b) * 2 / (limit[a] + limit[b])
        is_long = excess > 1
        a, b, excess = a[is_long], b[is_long], excess[is_long]
        left, right = ring_tables.apexes(meso.rings, meso.degree, a, b)
        chosen = _disjoint(np.stack([a, b, left, right], axis=1), shortest_first(a, b, -excess, 1.0), meso.num_rows)
        if len(chosen) == 0:
            return
        limit = np.concatenate([limit, (limit[a] + limit[b])[chosen] / 2])
        split_edges(meso, a[chosen], b[chosen], np.full(len(chosen), 0.5))
        if check:
            manifold.check_closed_manifold(meso.rings, euler)


def split_edges(
    meso: Meso, a: np.ndarray, b: np.ndarray, fraction: np.ndarray, apex: np.ndarray | None = None
) -> SplitRound:
    """Cut the edges ab (c,), which share no face, at ``fraction`` of the way from a to b, where ``apex`` projects."""
    left, right = ring_tables.apexes(meso.rings, meso.degree, a, b)
    meso.widen(int(meso.degree.max(initial=0)) + 1)
    rings = meso.rings
    new = np.arange(meso.num_rows, meso.num_rows + len(a))
    slot_b, slot_a = find_slot(rings[a], b), find_slot(rings[b], a)
    rings[a, slot_b] = new
    rings[b, slot_a] = new
    # Around the left apex a comes before b, around the right one b before a: the new vertex goes between them.
    place = np.arange(rings.shape[1])[None, :]
    from_b = None if meso.classes is None else np.zeros((len(a), 4), dtype=np.int64)  # new -> b, left, a, right
    if meso.classes is not None and from_b is not None:  # the new vertex is as good as b: new -> b has class 0
        from_b[:, 2] = meso.classes[b, slot_a]
        meso.classes[b, slot_a] = 0
    for beside, before, column in ((left, a, 1), (right, b, 3)):
        slot = find_slot(rings[beside], before)[:, None]
        source = np.where(place > slot + 1, place - 1, place)
        if meso.classes is not None and from_b is not None:
            from_beside = meso.classes[beside, find_slot(rings[beside], b)]
            shifted = np.take_along_axis(meso.classes[beside], source, axis=1)
            meso.classes[beside] = np.where(place == slot + 1, from_beside[:, None], shifted)
            from_b[:, column] = -from_beside
        rings[beside] = np.where(place == slot + 1, new[:, None], np.take_along_axis(rings[beside], source, axis=1))
        meso.degree[beside] += 1
    meso.rings = _with_rows(rings, np.stack([b, left, a, right], axis=1), -1)
    if meso.classes is not None and from_b is not None:
        meso.classes = _with_rows(meso.classes, from_b, 0)
    meso.degree = np.concatenate([meso.degree, np.full(len(a), 4)])
    weight = fraction[:, None]
    for name, share in (("positions", weight), ("poles", weight), ("weights", weight), ("scale", fraction)):
        old = getattr(meso, name)
        if old is not None:
            setattr(meso, name, np.concatenate([old, (1 - share) * old[a] + share * old[b]]))
    meso.has_pole = np.concatenate([meso.has_pole, np.zeros(len(a), dtype=bool)])
    if meso.trust is not None:
        meso.trust = np.concatenate([meso.trust, np.zeros(len(a))])
    meso.is_fixed = np.concatenate([meso.is_fixed, np.zeros(len(a), dtype=bool)])
    done = SplitRound(a, b, new, fraction, apex)
    meso.edits.append(done)
    return done


def _with_rows(table: np.ndarray, rows: np.ndarray, fill: int) -> np.ndarray:
    """``table`` (n, K) with ``rows`` (c, 4) appended, padded with ``fill``."""
    fresh = np.full((len(rows), table.shape[1]), fill, dtype=table.dtype)
    fresh[:, : rows.shape[1]] = rows
    return np.concatenate([table, fresh])


def _cos_at(positions: np.ndarray, apex: np.ndarray, a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Cosine (c,) of the angle that ab subtends at ``apex``; 1 where the apex coincides with an end."""
    to_a, to_b = positions[a] - positions[apex], positions[b] - positions[apex]
    product = np.sqrt(np.einsum("ij,ij->i", to_a, to_a) * np.einsum("ij,ij->i", to_b, to_b))
    dot = np.einsum("ij,ij->i", to_a, to_b)
    return np.where(product > 0, dot / np.where(product > 0, product, 1.0), 1.0)


def _disjoint(claims: np.ndarray, order: np.ndarray, num_vertices: int) -> np.ndarray:
    """Rows of ``claims`` (c, 4), first in ``order`` first, no two of which share a vertex."""
    chosen = []
    claims, rank = claims[order], np.arange(len(claims))
    is_taken = np.zeros(num_vertices, dtype=bool)
    best = np.empty(num_vertices, dtype=np.int64)
    while len(rank):
        best[claims.ravel()] = len(order)
        np.minimum.at(best, claims.ravel(), np.repeat(rank, claims.shape[1]))
        wins = (best[claims] == rank[:, None]).all(axis=1)
        chosen.append(order[rank[wins]])
        is_taken[claims[wins].ravel()] = True
        is_open = ~is_taken[claims].any(axis=1)
        claims, rank = claims[is_open], rank[is_open]
    return np.sort(np.concatenate(chosen)) if chosen else np.empty(0, dtype=np.int64)
