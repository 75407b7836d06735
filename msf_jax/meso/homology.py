"""Which loops of the surface are contractible in the solid: these may be pinched, the others must be kept.

A surface of genus g has 2g independent loops. Half of them, around its limbs, are zero in the homology of the solid;
the other half are the cycles of its curve. By Alexander duality a loop is zero in the solid if and only if it links no
loop outside. The surface's own loops, pushed out slightly, span the loops outside. So every directed edge gets an
integer, its class, such that the sum along a loop is a fixed random combination of its linking numbers with these
loops. The sum is zero if, and with an error probability of 1 in 10^9 only if, the loop is zero in the solid.

Noise and slivers make a surface cross itself in places, where linking numbers are not valid. Then they are computed on
the slightly smoothed surface, whose loops have the same classes.

The loops are those of `solid.handles`, which has the same classes for paths through the solid. Linking numbers are
computed from signed crossings in a projection.

Where no linking numbers are valid, lengths tell on the contracted surface, see `short_classes`: loops around limbs have
shrunk to almost 0, and the loops that the curve keeps have not. From the 2g shortest independent loops through one
vertex (Erickson, Whittlesey 2005), g loops that do not cross each other are chosen, short ones first, or sums of loops
where necessary. These count as contractible in the solid, and so does every loop that crosses none of them. The class
of an edge is its number of crossings with a fixed random combination of them.
"""

import numpy as np
from scipy import sparse
from scipy.sparse import csgraph

from msf_jax.meso import ring_tables
from msf_jax.meso.ring_tables import find_slot
from msf_jax.solid.geometry import vertex_normals
from msf_jax.solid.handles import SEED, surface_loops
from msf_jax.topology import graphs
from msf_jax.topology.graphs import loop_along, shortest_forest
from msf_jax.topology.half_edges import half_edges

PUSH = 1e-3  # mean edge lengths, by which loops are pushed out
SMOOTHINGS = (1, 1, 2, 4, 8, 16)  # successive numbers of smoothing rounds for a surface that crosses itself
MANY_HANDLES = 16  # handles: with more, smoothing hardly ever removes all crossings, and is tried once
MOST_PAIRS = 200_000_000  # pairs of edges of two loops; with more, no linking numbers are computed
LARGEST_GENUS = 64  # with a larger genus, linking numbers would take too long
MOST_HANDLES = 400  # handles: with more, the table of crossings of short loops would be too large
MOST_TIMES = 2**14  # largest coefficient of a loop in a sum, so that classes of edges do not overflow 64 bits


def half_edge_classes(positions: np.ndarray, faces: np.ndarray) -> np.ndarray | None:
    """The class (3F,) of every half-edge of a connected closed surface; twins have opposite classes.

    In a solid, the rank of the linking numbers is the genus, and their skew part, the crossings of loops on the
    surface, has determinant 1. Otherwise the result is None: the surface crosses itself, or is so coarse that pushed
    loops are inside. It is also None if there are more than ``MOST_PAIRS`` pairs of edges.
    """
    edges, generator, loops, to_parent, depth = surface_loops(faces)
    if sum(map(len, loops)) ** 2 > MOST_PAIRS:
        return None
    normal = vertex_normals(positions, faces)
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
    spacing = np.linalg.norm(positions[edges.origin] - positions[edges.target], axis=1).mean()
    linking = linking_numbers(
        [positions[loop] for loop in loops], [(positions + PUSH * spacing * normal)[loop] for loop in loops]
    )
    crossings = np.linalg.det(linking - linking.T)  # the loops span the surface's homology if this is 1
    if 2 * np.linalg.matrix_rank(linking) != len(generator) or round(abs(crossings)) != 1:
        return None
    weight = np.random.default_rng(SEED).integers(1, 2**30, size=len(generator))

    # Classes are zero on the tree, and known on generators. On the cotree, from its leaves, those of a face sum to
    # zero.
    value = np.zeros(len(edges.origin), dtype=np.int64)
    value[generator] = linking @ weight
    value[edges.twin[generator]] = -value[generator]
    by_depth = np.argsort(-depth, kind="stable")
    for level in np.split(by_depth, np.flatnonzero(np.diff(depth[by_depth])) + 1):
        up = to_parent[level]
        level, up = level[up >= 0], up[up >= 0]
        value[up] = -value.reshape(-1, 3)[level].sum(axis=1)
        value[edges.twin[up]] = -value[up]
    return value


def ring_classes(positions: np.ndarray, faces: np.ndarray, rings: np.ndarray) -> np.ndarray | None:
    """The classes in the form of the ring table ``rings`` (n, K): entry [i, k] is the class of i -> rings[i, k]."""
    edges = half_edges(faces)
    count = np.bincount(edges.origin)[:, None]
    ends = edges.origin, edges.target
    neighbours = graphs.weighted(len(rings), *ends)
    values = None
    handles = 1 - (np.count_nonzero(count) - len(faces) // 2) // 2
    for rounds in (0, *SMOOTHINGS[: 1 if handles > MANY_HANDLES else None]):
        for _ in range(rounds):
            positions = (positions + neighbours @ positions / count) / 2
        values = half_edge_classes(positions, faces)
        if values is not None:
            break
    if values is None:
        return None
    classes = np.zeros(rings.shape, dtype=np.int64)
    classes[edges.origin, find_slot(rings[edges.origin], edges.target)] = values
    return classes


def linking_numbers(loops: list[np.ndarray], others: list[np.ndarray]) -> np.ndarray:
    """Linking number (A, B) of every closed polyline (P, 3) of ``loops`` with every one of ``others``, all disjoint.

    It is half of the signed crossings in a projection along a generic direction.
    """
    turn = np.linalg.qr(np.random.default_rng(1987).normal(size=(3, 3)))[0]
    turn[:, 0] *= np.linalg.det(turn)
    linking = np.zeros((len(loops), len(others)), dtype=np.int64)
    for i, one in enumerate(loops):
        p = one @ turn
        along_p = np.roll(p, -1, axis=0) - p
        for j, other in enumerate(others):
            q = other @ turn
            along_q = np.roll(q, -1, axis=0) - q
            offset = q[None] - p[:, None]
            area = along_p[:, None, 0] * along_q[None, :, 1] - along_p[:, None, 1] * along_q[None, :, 0]
            with np.errstate(divide="ignore", invalid="ignore"):
                s = (offset[..., 0] * along_q[None, :, 1] - offset[..., 1] * along_q[None, :, 0]) / area
                t = (offset[..., 0] * along_p[:, None, 1] - offset[..., 1] * along_p[:, None, 0]) / area
            a, b = np.nonzero((s >= 0) & (s < 1) & (t >= 0) & (t < 1))
            height = p[a, 2] + s[a, b] * along_p[a, 2] - q[b, 2] - t[a, b] * along_q[b, 2]
            linking[i, j] = round(float((np.sign(area[a, b]) * np.sign(height)).sum()) / 2)
    return linking


def short_classes(positions: np.ndarray, rings: np.ndarray) -> np.ndarray | None:
    """Classes (n, K) beside the ring table ``rings`` of a connected surface, as `ring_classes` gives them.

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
    # Half-edges that are in neither the tree nor a spanning tree of the faces, which crosses the edges of the longest
    # loops, close the 2g shortest loops with paths of the tree.
    in_tree = (parent[tail] == head) | (parent[head] == tail)
    around, face = away[tail] + away[head] + length, np.arange(num_half) // 3
    free = np.flatnonzero((np.arange(num_half) < twin) & ~in_tree)
    pairs = np.stack([face[free], face[twin[free]]], axis=1)
    generator = free[~shortest_forest(num_half // 3, pairs, -around[free])]
    loops = [loop_along(int(tail[half]), int(head[half]), parent) for half in generator]
    slot_of = find_slot(rings[tail], head)
    half_at = np.zeros(rings.shape, dtype=np.int64)
    half_at[tail, slot_of] = np.arange(num_half)
    ends = [(np.array(loop), np.roll(loop, -1)) for loop in loops]
    paths = [half_at[start, find_slot(rings[start], end)] for start, end in ends]
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
