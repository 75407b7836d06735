"""Which loops of the surface bound a disc inside it: what the curve may pinch, and what it must keep.

A surface of genus g has 2g independent loops; half of them, around its limbs, vanish in the solid, and the other half
are the cycles of its curve. A loop vanishes (in homology) exactly if it links no loop outside, by Alexander duality,
and the loops outside are spanned by the surface's own, pushed out a little. So every directed edge gets an integer, its
class, such that the sum along a loop is a fixed random combination of the loop's linking numbers with all of them: the
sum is zero if and (but for a chance of 1 in 10^9) only if the loop vanishes in the solid.

Noise and slivers make a surface cross itself here and there, which spoils linking numbers, but not what they are asked
for: then they are those of the surface after a little smoothing.

The loops are those of `host.solid.handles`, whose classes of ways through the solid are these on its surface. Linking
numbers come from signed crossings in a projection.
"""

import numpy as np
from scipy import sparse

from msf_jax.host.mesh.half_edges import half_edges
from msf_jax.host.meso import ring_tables
from msf_jax.host.solid.geometry import vertex_normals
from msf_jax.host.solid.handles import SEED, surface_loops

PUSH = 1e-3  # how far out, as a fraction of the mean edge length
SMOOTHINGS = (1, 1, 2, 4, 8, 16)  # rounds, one after the other, of a surface that small triangles make cross itself
MANY_HANDLES = 16  # of which smoothing all but never leaves a surface that does not cross itself: it is tried once
MOST_PAIRS = 200_000_000  # of a loop's edges with another's; beyond, linking numbers are not asked for
LARGEST_GENUS = 64  # beyond, the cost of all linking numbers is no longer small


def half_edge_classes(positions: np.ndarray, faces: np.ndarray) -> np.ndarray | None:
    """The class (3F,) of every half-edge of a connected closed surface; twins have opposite ones.

    None where the linking numbers are not those of a solid (their rank is the genus, and their skew part, how loops
    cross on the surface, has determinant 1): the surface crosses itself, or is so coarse that a push goes inside. None
    also where there are more than ``MOST_PAIRS`` to be looked at.
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
    crossings = np.linalg.det(linking - linking.T)  # of the loops with each other, on the surface: they span it all
    if 2 * np.linalg.matrix_rank(linking) != len(generator) or round(abs(crossings)) != 1:
        return None
    weight = np.random.default_rng(SEED).integers(1, 2**30, size=len(generator))

    # Zero on the tree, known on the generators; across the cotree, from the leaves up, a face's three add up to zero.
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
    """The same, beside the ring table ``rings`` (n, K) of ``faces``: entry [i, k] is the class of i -> rings[i, k]."""
    edges = half_edges(faces)
    count = np.bincount(edges.origin)[:, None]
    ends = edges.origin, edges.target
    neighbours = sparse.csr_matrix((np.ones(len(edges.origin)), ends), shape=(len(rings), len(rings)))
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

    Half the signed crossings in a projection along a direction in general position.
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
