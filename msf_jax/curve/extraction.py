"""From the meso-skeleton to the curve: collapse edges that still have faces, shortest first or by Au's surgery.

The contracted surface is thin but still a surface. Its edges are visited in the order of their initial length, ties by
index. Each edge that has a face at its turn is merged. When no face is left, the remaining edges are the curve. A node
is the centroid of the meso vertices merged into it. Au's surgery (2008) uses another order, and a node is the meso
vertex that is left (see `meso.surgery`).
"""

from typing import NamedTuple

import numpy as np

from msf_jax.meso import ring_tables, surgery
from msf_jax.meso.complex import Complex, cut_discs
from msf_jax.meso.edits import edge_lengths, shortest_first


class Curve(NamedTuple):
    """nodes: (N, 3). edges: (E, 2). node_of_meso: (n,) the node that each vertex of the meso-skeleton was merged into.
    is_counted: (n,) which of these vertices count in a node's centroid."""

    nodes: np.ndarray
    edges: np.ndarray
    node_of_meso: np.ndarray
    is_counted: np.ndarray


def extract_curve(
    positions: np.ndarray,
    rings: np.ndarray,
    classes: np.ndarray | None = None,
    pinned: np.ndarray | None = None,
    by_surgery: bool = False,
) -> Curve:
    """Collapse the closed surface ``(positions, rings)`` to a graph of the same components.

    With ``classes`` (n, K), no merge pinches a loop that the solid's curve must keep (see `solid.handles`). Vertices of
    ``pinned`` are merged with each other only if no other edge can be merged."""
    a, b = ring_tables.edges_from_rings(rings)
    complex_ = Complex(rings, classes, pinned)
    if by_surgery:
        surgery.operate(complex_, positions, a, b)
    else:
        order = shortest_first(a, b, edge_lengths(positions, a, b), 1e-3)
        edges = list(zip(a[order].tolist(), b[order].tolist(), strict=True))
        while edges:
            # An edge that has a face is merged. One that would pinch a cycle is tried after the others.
            waiting = [edge for edge in edges if not complex_.merge(*edge, force=False)]
            is_stuck = len(waiting) == len(edges)
            if is_stuck and not complex_.has_classes:
                for edge in edges:  # no merge is allowed any more; the report shows the lost cycles
                    complex_.merge(*edge, force=True)
                break
            if is_stuck and not complex_.open_face(edges[::-1]):
                break
            edges = waiting
    root = np.array([complex_.find(vertex) for vertex in range(len(rings))])
    is_counted = (root == np.arange(len(rings))) | (not by_surgery)
    node_of_meso = np.unique(root, return_inverse=True)[1]
    own = node_of_meso[is_counted]
    nodes = np.stack([np.bincount(own, axis) / np.bincount(own) for axis in positions[is_counted].T], axis=1)
    left = np.stack([a, b], axis=1)
    if complex_.has_classes:  # the complex lists its remaining edges, without those that were opened
        left, value = complex_.edges()
        length = np.linalg.norm(np.subtract(*nodes[node_of_meso[left.T]]), axis=1)
        left = left[cut_discs(len(root), left, value, shortest_first(*left.T, length, 1e-3))]
    ends = np.sort(node_of_meso[left], axis=1)
    return Curve(nodes, np.unique(ends[ends[:, 0] < ends[:, 1]], axis=0), node_of_meso, is_counted)
