"""Edge split: an edge with two obtuse opposite angles is split where an apex projects on it (article 3.2.4).

Collapses leave long thin triangles. A split of their longest edge adds a vertex that the contraction can move. The new
vertex is on the old edge, so the shape does not change. Its pole is interpolated at the same fraction, but does not
pull.
"""

from typing import NamedTuple

import numpy as np

from msf_jax.host.meso import kernels, ring_tables
from msf_jax.host.meso.collapse import edge_lengths, first_apart, shortest_first
from msf_jax.host.meso.meso import Meso


class SplitRound(NamedTuple):
    """One round of independent splits, (c,) each: the new vertex is (1 - fraction) a + fraction b.

    ``apex`` projects on ab there; it is None if the fraction was given.
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

    Returns the rounds, and whether it stopped early because the surface would have more than ``max_rows`` vertices.
    """
    euler = ring_tables.euler_characteristic(meso.rings) if check else 0
    cosine = np.cos(np.radians(angle))
    rounds = []
    edges, is_touched = np.empty((5, 0), dtype=np.int64), np.ones(meso.num_rows, dtype=bool)
    while True:
        found = np.empty((int(meso.degree[is_touched].sum()), 5), dtype=np.int64)
        surface = meso.positions, meso.rings, meso.degree, meso.scales()
        count = kernels.wide_edges(*surface, shortest, cosine, is_touched, found)
        edges = np.concatenate([edges, found[:count].T], axis=1)
        a, b, _, _, apex = edges
        along = meso.positions[b] - meso.positions[a]
        length2 = np.einsum("ij,ij->i", along, along)
        fraction = np.einsum("ij,ij->i", meso.positions[apex] - meso.positions[a], along) / length2
        order = shortest_first(a, b, -np.sqrt(length2), shortest)
        chosen = _disjoint(edges[:4].T, order, meso.num_rows)
        is_full = meso.num_live + len(chosen) > max_rows
        if len(chosen) == 0 or is_full:
            return rounds, is_full
        rounds.append(split_edges(meso, a[chosen], b[chosen], fraction[chosen], apex[chosen]))
        if check:
            ring_tables.check_closed_manifold(meso.rings, euler)
        # Test the edges of the split faces again; waiting edges elsewhere have not changed.
        is_touched = np.zeros(meso.num_rows, dtype=bool)
        is_touched[np.r_[rounds[-1].new, edges[:4, chosen].ravel()]] = True
        edges = edges[:, ~(is_touched[a] | is_touched[b])]


def split_long_edges(meso: Meso, longest: float | np.ndarray, *, check: bool = False) -> None:
    """Halve every edge longer than ``longest``, longest first, until none is left.

    ``longest`` may be an array (n,): the limit of an edge, and of the vertex that halves it, is the mean of its ends'.
    """
    euler = ring_tables.euler_characteristic(meso.rings) if check else 0
    limit = np.broadcast_to(np.asarray(longest, dtype=np.float64), meso.num_rows)
    a, b = ring_tables.edges_from_rings(meso.rings)
    while True:
        excess = edge_lengths(meso.positions, a, b) * 2 / (limit[a] + limit[b])
        is_long = excess > 1
        a, b, excess = a[is_long], b[is_long], excess[is_long]
        left, right = ring_tables.apexes(meso.rings, meso.degree, a, b)
        claims = np.stack([a, b, left, right], axis=1)
        chosen = _disjoint(claims, shortest_first(a, b, -excess, 1.0), meso.num_rows)
        if len(chosen) == 0:
            return
        limit = np.concatenate([limit, (limit[a] + limit[b])[chosen] / 2])
        new = split_edges(meso, a[chosen], b[chosen], np.full(len(chosen), 0.5)).new
        if check:
            ring_tables.check_closed_manifold(meso.rings, euler)
        # The other edges have not changed.
        near = meso.rings[new, :4].ravel()
        a, b = np.r_[np.delete(a, chosen), near], np.r_[np.delete(b, chosen), np.repeat(new, 4)]
        order = np.lexsort((b, a))
        a, b = a[order], b[order]


def split_edges(
    meso: Meso, a: np.ndarray, b: np.ndarray, fraction: np.ndarray, apex: np.ndarray | None = None
) -> SplitRound:
    """Split the edges ab (c,), which share no face, at ``fraction`` from a to b, where ``apex`` projects."""
    left, right = ring_tables.apexes(meso.rings, meso.degree, a, b)
    meso.widen(int(meso.degree.max(initial=0)) + 1)
    new = np.arange(meso.num_rows, meso.num_rows + len(a))
    more = ((0, len(a)), (0, 0))
    meso.rings, meso.degree = np.pad(meso.rings, more, constant_values=-1), np.pad(meso.degree, more[0])
    meso.classes = None if meso.classes is None else np.pad(meso.classes, more)
    classes = np.zeros_like(meso.rings) if meso.classes is None else meso.classes
    kernels.cut(a, b, left, right, meso.rings, meso.degree, classes)
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


def _disjoint(claims: np.ndarray, order: np.ndarray, num_vertices: int) -> np.ndarray:
    """A maximal set of rows of ``claims`` (c, 4), chosen greedily in ``order``, no two of which share a vertex."""
    return first_apart(claims, order, np.empty((num_vertices, 0), dtype=np.int64))
