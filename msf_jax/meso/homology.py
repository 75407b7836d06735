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
"""

import numpy as np

from msf_jax.meso import ring_tables
from msf_jax.solid.geometry import vertex_normals
from msf_jax.solid.handles import SEED, surface_loops
from msf_jax.topology import graphs
from msf_jax.topology.half_edges import half_edges

PUSH = 1e-3  # mean edge lengths, by which loops are pushed out
SMOOTHINGS = (1, 1, 2, 4, 8, 16)  # successive numbers of smoothing rounds for a surface that crosses itself
MANY_HANDLES = 16  # handles: with more, smoothing hardly ever removes all crossings, and is tried once
MOST_PAIRS = 200_000_000  # pairs of edges of two loops; with more, no linking numbers are computed
LARGEST_GENUS = 64  # with a larger genus, linking numbers would take too long


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
    values = half_edge_classes(positions, faces)
    handles = 1 - (np.count_nonzero(count) - len(faces) // 2) // 2
    for rounds in SMOOTHINGS[: 1 if handles > MANY_HANDLES else None]:
        if values is not None:
            break
        for _ in range(rounds):
            positions = (positions + neighbours @ positions / count) / 2
        values = half_edge_classes(positions, faces)
    if values is None:
        return None
    code = ring_tables.encode_edges(edges.origin, edges.target, len(rings))
    order = np.argsort(code)
    vertex, slot = np.nonzero(rings >= 0)
    wanted = ring_tables.encode_edges(vertex, rings[vertex, slot], len(rings))
    classes = np.zeros(rings.shape, dtype=np.int64)
    classes[vertex, slot] = values[order[np.searchsorted(code, wanted, sorter=order)]]
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
