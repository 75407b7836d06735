"""Edge collapse: every edge shorter than t_c is collapsed to its midpoint (article 3.2.4).

Collapses are applied in rounds. A round is a maximal set of edges whose ends are neither shared nor neighbours,
shortest first and ties by index. Such collapses do not change each other's rings or link conditions, so they can be
applied at once, and the surface stays a closed manifold. After a round only the edges around survivors, and those that
had to wait, are tested again: the cost depends on the number of edits, not on the size of the mesh.
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
            meso.merge_map(survivor, removed)
            rounds.append(CollapseRound(survivor, removed, fraction[:count].copy(), takes_pole.astype(bool)))
            meso.edits.append(rounds[-1])
            if check:
                ring_tables.check_closed_manifold(meso.rings, euler)
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
