"""The edits of connectivity in an iteration: collapses, splits, and the fixing of vertices (article 3.2.4 to 3.2.6).

Every edge shorter than t_c is collapsed to its midpoint. Collapses leave long thin triangles: an edge with two obtuse
opposite angles is split where an apex projects on it, for a vertex that the contraction can move. Its pole does not
pull.

Edits are applied in rounds. A round is a maximal set of edges, of which none changes the rings or the link conditions
of another, shortest or longest first and ties by index. So the surface stays a closed manifold of the same genus. After
a round only the edges around edited vertices, and those that had to wait, are tested again.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from msf_jax.meso import kernels, ring_tables
from msf_jax.meso.meso import Meso


class CollapseRound(NamedTuple):
    """One round of independent collapses, (c,) each: ``removed`` is merged into ``survivor``."""

    survivor: np.ndarray
    removed: np.ndarray
    fraction: np.ndarray  # new position = (1 - fraction) survivor + fraction removed
    takes_pole: np.ndarray  # True where the survivor takes the removed vertex's pole


def edge_lengths(positions: np.ndarray, a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Lengths (c,) of the edges ab."""
    difference = positions[a] - positions[b]
    return np.sqrt(np.einsum("ij,ij->i", difference, difference))


def shortest_first(a: np.ndarray, b: np.ndarray, length: np.ndarray, unit: float) -> np.ndarray:
    """Order (c,) of the edges ab by length, ties by index. Lengths that agree to 1e-6 of ``unit`` count as tied, so
    that a symmetric, a scaled or a shifted mesh is edited alike in spite of rounding."""
    rounded = np.round(length / (1e-6 * unit))
    num_bits = int(max(a.max(initial=0), b.max(initial=0))).bit_length()
    if len(a) and rounded.min() >= 0 and rounded.max() < 2 ** (63 - 2 * num_bits):  # one key is sorted faster
        return np.argsort(rounded.astype(np.int64) << (2 * num_bits) | a.astype(np.int64) << num_bits | b)
    return np.lexsort((b, a, rounded))


def collapse_short_edges(meso: Meso, t_c: float, keep_faces: bool = False) -> list[CollapseRound]:
    """Collapse in place until no edge shorter than ``t_c`` can be collapsed; returns the rounds. With ``keep_faces`` no
    collapse turns a face by more than 60 degrees."""
    rounds, waiting, is_touched = [], Waiting(), np.ones(meso.num_rows, dtype=bool)
    surface = meso.surface()
    while len(waiting.find(kernels.short_edges, meso, is_touched, t_c)):
        a, b, _, _, common = waiting.found.T
        can_merge = (common == 2) & ~(meso.is_fixed[a] & meso.is_fixed[b])
        meso.widen(int((meso.degree[a] + meso.degree[b])[can_merge].max(initial=0)) - 4)
        order = shortest_first(a, b, waiting.value[:, 0], t_c)
        is_touched, is_taken = np.zeros((2, meso.num_rows), dtype=bool)
        done, fraction = np.empty((len(order), 3), dtype=np.int64), np.empty(len(order))
        scratch = np.empty((2, meso.rings.shape[1]), dtype=np.int64)
        if meso.rings is not surface.rings:
            surface = meso.surface()
        count = kernels.collapse(
            surface, order, waiting.found, keep_faces, is_taken, is_touched, scratch, done, fraction
        )
        if count:
            survivor, removed, takes_pole = done[:count].T.copy()
            target = np.arange(meso.num_rows)
            target[removed] = survivor
            meso.node_of_input = target[meso.node_of_input]
            rounds.append(CollapseRound(survivor, removed, fraction[:count].copy(), takes_pole.astype(bool)))
            meso.edits.append(rounds[-1])
    return rounds


class Waiting:
    """Edges that wait for an edit. found: (c, 5) and value: (c, 2), see `kernels.short_edges` and `wide_edges`."""

    def __init__(self) -> None:
        self.found, self.value = np.empty((0, 5), dtype=np.int64), np.empty((0, 2))

    def find(self, kernel: Callable[..., int], meso: Meso, is_touched: np.ndarray, *limits: float) -> np.ndarray:
        """``found``, after edges with vertices of ``is_touched`` (n,) were left out and found anew."""
        waiting, more = len(self.found), int(meso.degree[is_touched].sum())
        found, value = np.empty((waiting + more, 5), dtype=np.int64), np.empty((waiting + more, 2))
        found[:waiting], value[:waiting] = self.found, self.value
        scale = np.ones(meso.num_rows) if meso.scale is None else meso.scale
        count = kernel(meso.positions, meso.rings, meso.degree, scale, *limits, is_touched, waiting, found, value)
        self.found, self.value = found[:count], value[:count]
        return self.found


def first_apart(claims: np.ndarray, order: np.ndarray, num_vertices: int) -> np.ndarray:
    """A maximal set of rows of ``claims`` (c, k), ids of vertices, chosen greedily in ``order``, in which no two rows
    share a vertex."""
    found = np.empty(len(claims), dtype=bool)
    kernels.apart(claims, order, np.zeros(num_vertices, dtype=bool), found)
    return np.flatnonzero(found)


class SplitRound(NamedTuple):
    """One round of independent splits, (c,) each: the new vertex is (1 - fraction) a + fraction b, where ``apex``
    projects on ab; that is None if the fraction was given."""

    a: np.ndarray
    b: np.ndarray
    new: np.ndarray
    fraction: np.ndarray
    apex: np.ndarray | None


def split_obtuse_edges(meso: Meso, angle: float, shortest: float, max_rows: int) -> tuple[list[SplitRound], bool]:
    """Split in place until no edge longer than ``shortest`` has two opposite angles over ``angle`` degrees. Returns the
    rounds, and whether it stopped early because the surface would have more than ``max_rows`` vertices."""
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
        # The edges of the split faces are tested again; waiting edges elsewhere have not changed.
        is_touched = np.zeros(meso.num_rows, dtype=bool)
        is_touched[np.r_[rounds[-1].new, found[chosen, :4].ravel()]] = True


def split_long_edges(meso: Meso, longest: float | np.ndarray) -> None:
    """Halve every edge longer than ``longest``, longest first, until none is left. Of an array (n,), the limit of an
    edge, and of the vertex that halves it, is the mean of its ends'."""
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
    """Split the edges ab (c,), which share no face, at ``fraction`` from a to b, where ``apex`` projects; ``whole``:
    see `Meso.append`."""
    meso.widen(int(meso.degree.max(initial=0)) + 1)
    new = np.arange(meso.num_rows, meso.num_rows + len(a))
    meso.append(len(a), whole)
    kernels.cut(meso.surface(), a, b, fraction)
    done = SplitRound(a, b, new, fraction, apex)
    meso.edits.append(done)
    return done


def fix_degenerate_vertices(meso: Meso, t_f: float) -> None:
    """Fix, in place, every vertex with two or more incident edges shorter than ``t_f`` that cannot collapse."""
    every = np.ones(meso.num_rows, dtype=bool)
    a, b, left, right, common = Waiting().find(kernels.short_edges, meso, every, t_f).T
    is_stuck = (common != 2) | (meso.degree[left] <= 3) | (meso.degree[right] <= 3)
    meso.is_fixed |= np.bincount(np.concatenate([a[is_stuck], b[is_stuck]]), minlength=meso.num_rows) >= 2


def threshold(iteration: int, t_min: float, t_step: float, t_max: float) -> float:
    """The saw-tooth: t_c in an iteration, from 0. It rises by ``t_step``, and above ``t_max`` falls to ``t_min``."""
    return t_min + (iteration % num_periods(t_min, t_step, t_max)) * t_step


def num_periods(t_min: float, t_step: float, t_max: float) -> int:
    """Iterations from one fall of the threshold to the next."""
    # A quotient that is whole, but for rounding, is whole.
    return 1 if t_step == 0 else int((t_max - t_min) / t_step * (1 + 1e-9)) + 1
