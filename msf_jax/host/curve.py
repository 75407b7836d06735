"""From the meso-skeleton to the curve: collapse what still bears faces, shortest first (DESIGN "Curve").

The contracted surface is thin but still a surface. Its edges are taken in the order of their initial length, ties by
index, and each that bears a face when its turn comes is merged; when none is left, the edges that remain are the curve.
A node is the centroid of the meso vertices merged into it.
"""

from typing import NamedTuple

import numpy as np
from scipy import sparse
from scipy.sparse import csgraph

from msf_jax.host import connectivity
from msf_jax.host.collapse import edge_lengths, shortest_first


class Curve(NamedTuple):
    """nodes: (N, 3). edges: (E, 2). node_of_meso: (n,) the node that each vertex of the meso-skeleton went into."""

    nodes: np.ndarray
    edges: np.ndarray
    node_of_meso: np.ndarray


def extract_curve(positions: np.ndarray, rings: np.ndarray) -> Curve:
    """Collapse the closed surface ``(positions, rings)`` to a graph of the same components.

    The order makes this step sequential: a loop over the edges of the meso-skeleton, once, after the flow.
    """
    a, b = connectivity.edges_from_rings(rings)
    order = shortest_first(a, b, edge_lengths(positions, a, b), 1e-3)
    root = _merge_in_order(
        a[order].tolist(), b[order].tolist(), connectivity.faces_from_rings(rings).tolist(), len(rings)
    )
    node_of_meso = np.unique(root, return_inverse=True)[1]
    count = np.bincount(node_of_meso)
    nodes = np.stack([np.bincount(node_of_meso, weights=positions[:, axis]) / count for axis in range(3)], axis=1)
    ends = np.sort(node_of_meso[np.stack([a, b], axis=1)], axis=1)
    return Curve(nodes, np.unique(ends[ends[:, 0] < ends[:, 1]], axis=0), node_of_meso)


def _merge_in_order(a: list[int], b: list[int], faces: list[list[int]], num_vertices: int) -> np.ndarray:
    """The vertex (n,) that every vertex ends up in."""
    root = list(range(num_vertices))
    apexes: list[dict[int, set[int]]] = [{} for _ in range(num_vertices)]  # apexes[u][v]: third vertices of faces at uv

    def link(u: int, v: int, w: int) -> None:
        apexes[u].setdefault(v, set()).add(w)

    for u, v, w in faces:
        for x, y, z in ((u, v, w), (v, w, u), (w, u, v)):
            link(x, y, z)
            link(y, x, z)

    def find(u: int) -> int:
        while root[u] != u:
            root[u] = root[root[u]]
            u = root[u]
        return u

    for u, v in zip(a, b, strict=True):
        u, v = find(u), find(v)
        if u == v or not apexes[u].get(v):
            continue
        root[v] = u
        around_v = apexes[v]
        apexes[v] = {}
        for x, thirds in around_v.items():  # faces (v, x, z) become (u, x, z), those with u vanish
            around_x = apexes[x]
            around_x.pop(v, None)
            for z in thirds:
                if z != u and x != u:
                    link(u, x, z)
                    around_x.setdefault(u, set()).add(z)
                around_xz = around_x.get(z)
                if around_xz is not None:
                    around_xz.discard(v)
                    if x != u and z != u:
                        around_xz.add(u)
    return np.array([find(u) for u in range(num_vertices)])


def cycle_count(num_nodes: int, edges: np.ndarray) -> tuple[int, int]:
    """Components and independent cycles of a graph."""
    graph = sparse.coo_matrix((np.ones(len(edges)), (edges[:, 0], edges[:, 1])), shape=(num_nodes, num_nodes))
    components = int(csgraph.connected_components(graph, directed=False)[0])
    return components, len(edges) - num_nodes + components
