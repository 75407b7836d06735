"""Which loops the curve must keep, for a surface that crosses itself, where linking numbers are not valid.

On a contracted surface lengths tell: loops around limbs have shrunk to almost 0, and the loops that the curve keeps
have not. From the 2g shortest independent loops through one vertex (Erickson, Whittlesey 2005), g loops that do not
cross each other are chosen, short ones first, or sums of loops where necessary. These count as contractible in the
solid, and so does every loop that crosses none of them. The class of an edge is its number of crossings with a fixed
random combination of them.
"""

import numpy as np
from scipy import sparse
from scipy.sparse import csgraph

from msf_jax.meso import ring_tables
from msf_jax.topology import graphs
from msf_jax.topology.graphs import loop_along, shortest_forest
from msf_jax.topology.half_edges import HalfEdges, half_edges

MOST_HANDLES = 400  # handles: with more, the table of crossings would be too large
MOST_TIMES = 2**14  # largest coefficient of a loop in a sum, so that classes of edges do not overflow 64 bits


def short_classes(positions: np.ndarray, rings: np.ndarray) -> np.ndarray | None:
    """Classes (n, K) beside the ring table ``rings`` of a connected surface, as `homology.ring_classes` gives them.

    Short loops count as contractible in the solid. None for a surface of more than ``MOST_HANDLES``, or if coefficients
    of loops exceed ``MOST_TIMES``.
    """
    degree = ring_tables.ring_degrees(rings)
    edges = half_edges(ring_tables.faces_from_rings(rings))
    tail, head, twin = edges.origin, edges.target, edges.twin
    num, num_half = len(rings), len(edges.origin)
    euler = int((degree > 0).sum()) - num_half // 6
    if 2 - euler > 2 * MOST_HANDLES:
        return None
    # In diagonals: a sparse graph would take a length of 0 for no edge.
    length = np.maximum(np.linalg.norm(positions[tail] - positions[head], axis=1), 1e-12)
    away, parent = csgraph.dijkstra(
        graphs.weighted(num, tail, head, length), indices=int(tail[0]), return_predecessors=True
    )
    generator = _generators(edges, away[tail] + away[head] + length, (parent[tail] == head) | (parent[head] == tail))
    loops = [loop_along(int(tail[half]), int(head[half]), parent) for half in generator]
    slot_of = np.zeros(num_half, dtype=np.int64)
    for k in range(rings.shape[1]):
        slot_of[rings[tail, k] == head] = k
    half_at = np.zeros(rings.shape, dtype=np.int64)
    half_at[tail, slot_of] = np.arange(num_half)
    code = ring_tables.encode_edges(tail, head, num)
    order = np.argsort(code)

    def along(loop: list[int]) -> np.ndarray:
        closed = np.array([*loop, loop[0]])
        return order[np.searchsorted(code, ring_tables.encode_edges(closed[:-1], closed[1:], num), sorter=order)]

    paths = [along(loop) for loop in loops]
    number = np.repeat(np.arange(len(paths)), [len(path) for path in paths])
    ahead = np.concatenate([*paths, np.empty(0, dtype=np.int64)])
    back = twin[np.concatenate([*(np.roll(path, 1) for path in paths), np.empty(0, dtype=np.int64)])]
    # Edges that are, counter-clockwise, between the next and the previous edge of a loop leave it to the left.
    count = (slot_of[back] - slot_of[ahead] - 1) % degree[tail[ahead]]
    row = np.repeat(np.arange(len(ahead)), count)
    step = np.arange(len(row)) - np.repeat(np.cumsum(count) - count, count) + 1
    at = tail[ahead[row]]
    leaving = half_at[at, (slot_of[ahead[row]] + step) % degree[at]]
    shape = len(loops), num_half
    left = sparse.csr_matrix((np.ones(len(row), dtype=np.int64), (number[row], leaving)), shape)
    crossed = left - left[:, twin]
    walked = sparse.csr_matrix((np.ones(len(ahead), dtype=np.int64), (number, ahead)), shape)
    crossings = (walked @ crossed.T).toarray()
    chosen = _apart(crossings, np.array([length[path].sum() for path in paths]))
    if chosen is None:
        return None
    weight = np.random.default_rng(2005).integers(1, 2**30, size=len(chosen)) @ chosen
    classes = np.zeros(rings.shape, dtype=np.int64)
    classes[tail, slot_of] = crossed.T @ weight
    return classes


def _generators(edges: HalfEdges, around: np.ndarray, in_tree: np.ndarray) -> np.ndarray:
    """The half-edges that close the 2g shortest loops with paths of the tree; ``around`` (H,) is the length of each
    loop.

    They are in neither the tree nor a spanning tree of the faces, which crosses the edges with the longest loops.
    """
    num_half, twin = len(edges.origin), edges.twin
    face = np.arange(num_half) // 3
    free = np.flatnonzero((np.arange(num_half) < twin) & ~in_tree)
    pairs = np.stack([face[free], face[twin[free]]], axis=1)
    return free[~shortest_forest(num_half // 3, pairs, -around[free])]


def _apart(crossings: np.ndarray, length: np.ndarray) -> np.ndarray | None:
    """(g, 2g) coefficients of short sums of the 2g loops that do not cross; ``crossings`` (2g, 2g) are the loops'.

    After each choice, another loop that crosses the chosen one is removed, and multiples of it are added to the others
    so that they do not cross the chosen one. Coefficients are divided by their greatest common divisor, so that they do
    not double in each round. None if they still exceed ``MOST_TIMES``.
    """
    left, length = np.eye(len(length), dtype=np.int64), length.copy()
    chosen = []
    while len(left):
        number = int(np.argmin(length))
        one = left[number]
        left, length = np.delete(left, number, axis=0), np.delete(length, number)
        chosen.append(one)
        times = left @ (crossings @ one)
        partners = np.flatnonzero(times)
        if not len(partners):
            continue
        other = partners[np.lexsort((length[partners], np.abs(times[partners])))[0]]
        both = np.gcd(times, times[other])
        own, its = times[other] // both, times // both
        length = np.abs(own) * length + np.abs(its) * length[other]
        left = own[:, None] * left - its[:, None] * left[other]
        is_left = np.arange(len(left)) != other
        around = np.maximum(np.gcd.reduce(left[is_left], axis=1), 1)
        left, length = left[is_left] // around[:, None], length[is_left] / around
        if np.abs(left).max(initial=0) > MOST_TIMES:
            return None
    return np.array(chosen, dtype=np.int64).reshape(-1, len(crossings))
