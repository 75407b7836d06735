"""Edge collapse: every edge shorter than t_c is collapsed to its midpoint (article 3.2.4).

Collapses are applied in rounds. A round is a maximal set of edges whose ends are neither shared nor neighbours,
shortest first and ties by index. Such collapses do not change each other's rings or link conditions, so they can be
applied at once, and the surface stays a closed manifold. After a round only the edges around survivors, and those that
had to wait, are tested again: the cost depends on the number of edits, not on the size of the mesh.
"""

from typing import NamedTuple

import numpy as np

from msf_jax.host.meso import kernels, ring_tables
from msf_jax.host.meso.meso import Meso
from msf_jax.host.solid.geometry import cross


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
    """Order (c,) of the edges ab by length, ties by index.

    Lengths that agree to 1e-6 of ``unit`` count as tied. So equal edges of a symmetric mesh stay tied although they
    differ by rounding, and a scaled or shifted mesh is edited alike.
    """
    rounded = np.round(length / (1e-6 * unit))
    num_bits = int(max(a.max(initial=0), b.max(initial=0))).bit_length()
    if len(a) and rounded.min() >= 0 and rounded.max() < 2 ** (63 - 2 * num_bits):  # one key is sorted faster
        return np.argsort(rounded.astype(np.int64) << (2 * num_bits) | a.astype(np.int64) << num_bits | b)
    return np.lexsort((b, a, rounded))


def collapse_short_edges(
    meso: Meso, t_c: float, *, keep_faces: bool = False, check: bool = False
) -> list[CollapseRound]:
    """Collapse in place until no edge shorter than ``t_c`` can be collapsed; returns the rounds.

    With ``keep_faces`` no collapse turns a face by more than 60 degrees.
    ``check`` verifies after each round that the surface is a closed manifold of the same genus.
    """
    euler = ring_tables.euler_characteristic(meso.rings) if check else 0
    rounds = []
    edges = _candidates(meso, np.ones(meso.num_rows, dtype=bool), t_c)
    while True:
        edges = edges.at((meso.degree[edges.left] > 3) & (meso.degree[edges.right] > 3))
        if len(edges.a) == 0:
            return rounds
        order = shortest_first(edges.a, edges.b, edges.length, t_c)
        chosen = first_apart(np.stack([edges.a, edges.b], axis=1), order, meso.rings)
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
            ring_tables.check_closed_manifold(meso.rings, euler)
        # Test the edges around the survivors again; waiting edges elsewhere have not changed.
        is_touched = np.zeros(meso.num_rows + 1, dtype=bool)  # the last entry serves the padding -1
        is_touched[meso.rings[done.survivor]] = True
        is_touched[done.survivor] = True
        is_touched = is_touched[:-1]
        gone = meso.degree == 0
        waiting = edges.at(~(is_touched | gone)[edges.a] & ~(is_touched | gone)[edges.b] & ~is_barred)
        around = _candidates(meso, is_touched, t_c)
        edges = Candidates(*(np.concatenate(pair) for pair in zip(waiting, around, strict=True)))


class Candidates(NamedTuple):
    """Short edges ab (c,) that can be collapsed if the degrees of their apexes ``left`` and ``right`` allow it."""

    a: np.ndarray
    b: np.ndarray
    left: np.ndarray
    right: np.ndarray
    length: np.ndarray

    def at(self, rows: np.ndarray) -> "Candidates":
        """The candidates in ``rows``."""
        return Candidates(*(values[rows] for values in self))


def _candidates(meso: Meso, is_touched: np.ndarray, t_c: float) -> Candidates:
    """The edges at vertices of ``is_touched`` (n,) that are shorter than ``t_c``, not fixed at both ends, and have no
    common neighbours but the two apexes."""
    a, b, left, right, common = short_edges(meso, is_touched, t_c)
    rows = np.flatnonzero(~(meso.is_fixed[a] & meso.is_fixed[b]) & (common == 2))
    a, b = a[rows], b[rows]
    return Candidates(a, b, left[rows], right[rows], edge_lengths(meso.positions, a, b))


def short_edges(meso: Meso, is_touched: np.ndarray, limit: float) -> np.ndarray:
    """(5, c) the edges ab at vertices of ``is_touched`` (n,) that are shorter than ``limit``: a, b, the apexes to the
    left and to the right, and the number of common neighbours of a and b."""
    found = np.empty((int(meso.degree[is_touched].sum()), 5), dtype=np.int64)
    surface = meso.positions, meso.rings, meso.degree, meso.scales()
    return found[: kernels.short_edges(*surface, limit, is_touched, found)].T.copy()


def _place(meso: Meso, a: np.ndarray, b: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The new place of a after the collapse of b into a: the fraction (c,) from a to b, and the position (c, 3)."""
    fraction = np.where(meso.is_fixed[a], 0.0, 0.5)
    return fraction, meso.positions[a] + fraction[:, None] * (meso.positions[b] - meso.positions[a])


def _turns_a_face(meso: Meso, a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """(c,) True where the collapse of ab would turn a remaining face by more than 60 degrees, or make it degenerate."""
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


def first_apart(claims: np.ndarray, order: np.ndarray, rings: np.ndarray) -> np.ndarray:
    """A maximal set of rows of ``claims`` (c, k), ids of vertices, chosen greedily in ``order``, in which no two rows
    share a vertex or have vertices that are neighbours in ``rings`` (n, K)."""
    found = np.empty(len(claims), dtype=bool)
    kernels.apart(claims, order, rings, np.zeros(len(rings), dtype=bool), found)
    return np.flatnonzero(found)


def _apply(meso: Meso, a: np.ndarray, b: np.ndarray) -> CollapseRound:
    """Merge the ends of the independent edges ab, and their poles, weights and other data."""
    swap = meso.is_fixed[b] & ~meso.is_fixed[a]  # the fixed end survives
    a, b = np.where(swap, b, a), np.where(swap, a, b)
    meso.widen(int((meso.degree[a] + meso.degree[b] - 4).max()))
    classes = np.zeros_like(meso.rings) if meso.classes is None else meso.classes
    kernels.merge(a, b, meso.rings, meso.degree, classes, np.empty((2, meso.rings.shape[1]), dtype=np.int64))
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
