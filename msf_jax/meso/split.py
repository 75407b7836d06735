"""Edge split: an edge with two obtuse opposite angles is split where an apex projects on it (article 3.2.4).

Collapses leave long thin triangles. A split of their longest edge adds a vertex that the contraction can move. The new
vertex is on the old edge, so the shape does not change. Its pole is interpolated at the same fraction, but does not
pull.
"""

from typing import NamedTuple

import numpy as np

from msf_jax.meso import kernels, ring_tables
from msf_jax.meso.collapse import Waiting, edge_lengths, first_apart, shortest_first
from msf_jax.meso.meso import Meso


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
    rounds, waiting, is_touched = [], Waiting(), np.ones(meso.num_rows, dtype=bool)
    whole: dict[str, np.ndarray] = {}
    while True:
        found = waiting.find(kernels.wide_edges, meso, is_touched, shortest, cosine)
        a, b, apex = found.T[[0, 1, 4]]
        order = shortest_first(a, b, -waiting.value[:, 0], shortest)
        chosen = first_apart(found[:, :4], order, meso.num_rows)
        is_full = meso.num_live + len(chosen) > max_rows
        if len(chosen) == 0 or is_full:
            return rounds, is_full
        rounds.append(split_edges(meso, a[chosen], b[chosen], waiting.value[chosen, 1], apex[chosen], whole))
        if check:
            ring_tables.check_closed_manifold(meso.rings, euler)
        # The edges of the split faces are tested again; waiting edges elsewhere have not changed.
        is_touched = np.zeros(meso.num_rows, dtype=bool)
        is_touched[np.r_[rounds[-1].new, found[chosen, :4].ravel()]] = True


def split_long_edges(meso: Meso, longest: float | np.ndarray, *, check: bool = False) -> None:
    """Halve every edge longer than ``longest``, longest first, until none is left.

    ``longest`` may be an array (n,): the limit of an edge, and of the vertex that halves it, is the mean of its ends'.
    """
    euler = ring_tables.euler_characteristic(meso.rings) if check else 0
    limit = np.broadcast_to(np.asarray(longest, dtype=np.float64), meso.num_rows)
    a, b = ring_tables.edges_from_rings(meso.rings)
    whole: dict[str, np.ndarray] = {}
    while True:
        excess = edge_lengths(meso.positions, a, b) * 2 / (limit[a] + limit[b])
        is_long = excess > 1
        a, b, excess = a[is_long], b[is_long], excess[is_long]
        left, right = ring_tables.apexes(meso.rings, meso.degree, a, b)
        claims = np.stack([a, b, left, right], axis=1)
        chosen = first_apart(claims, shortest_first(a, b, -excess, 1.0), meso.num_rows)
        if len(chosen) == 0:
            return
        limit = np.concatenate([limit, (limit[a] + limit[b])[chosen] / 2])
        new = split_edges(meso, a[chosen], b[chosen], np.full(len(chosen), 0.5), None, whole).new
        if check:
            ring_tables.check_closed_manifold(meso.rings, euler)
        # The other edges have not changed.
        near = meso.rings[new, :4].ravel()
        a, b = np.r_[np.delete(a, chosen), near], np.r_[np.delete(b, chosen), np.repeat(new, 4)]
        order = np.lexsort((b, a))
        a, b = a[order], b[order]


def split_edges(
    meso: Meso,
    a: np.ndarray,
    b: np.ndarray,
    fraction: np.ndarray,
    apex: np.ndarray | None,
    whole: dict[str, np.ndarray],
) -> SplitRound:
    """Split the edges ab (c,), which share no face, at ``fraction`` from a to b, where ``apex`` projects. ``whole``:
    see `Meso.append`."""
    meso.widen(int(meso.degree.max(initial=0)) + 1)
    new = np.arange(meso.num_rows, meso.num_rows + len(a))
    meso.append(len(a), whole)
    kernels.cut(meso.surface(), a, b, fraction)
    done = SplitRound(a, b, new, fraction, apex)
    meso.edits.append(done)
    return done
