"""Half-edges of a triangle list with their twins; the mesh need not be closed or manifold."""

from typing import NamedTuple

import numpy as np
from scipy import sparse


class HalfEdges(NamedTuple):
    """Half-edges of a triangle list: half-edge 3f + c goes from corner c of face f to the next corner."""

    origin: np.ndarray
    target: np.ndarray
    twin: np.ndarray  # the half-edge in the other direction, or -1


def half_edges(faces: np.ndarray) -> HalfEdges:
    """Half-edges of ``faces`` (F, 3) with their twins. The mesh may be open, but no half-edge may occur twice."""
    origin, target = faces.ravel(), faces[:, [1, 2, 0]].ravel()
    if not len(faces):
        return HalfEdges(origin, target, origin)
    size = 2 * (int(faces.max()) + 1,)
    number = sparse.csr_matrix((np.arange(1, len(origin) + 1), (origin, target)), shape=size)  # from 1: 0 is no entry
    return HalfEdges(origin, target, np.asarray(number[target, origin]).ravel() - 1)


def next_in_ring(edges: HalfEdges) -> np.ndarray:
    """For the half-edge i -> j of face (i, j, k), the half-edge i -> k: one step around vertex i."""
    num = np.arange(len(edges.origin))
    previous = num - num % 3 + (num + 2) % 3
    return edges.twin[previous]


def edge_codes(faces: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """For each half-edge, its edge; for each edge, its smaller end and its number of faces."""
    ends = np.sort(np.stack([faces, faces[:, [1, 2, 0]]], axis=-1).reshape(-1, 2), axis=1).astype(np.int64)
    num = np.int64(faces.max(initial=-1)) + 1
    code, edge, count = np.unique(ends[:, 0] * num + ends[:, 1], return_inverse=True, return_counts=True)
    return edge.ravel(), code // max(num, 1), count


def by_label(label: np.ndarray) -> list[np.ndarray]:
    """For each label 0, 1, ..., up to the largest, its indices (n,) in ``label``, ascending."""
    return np.split(np.argsort(label, kind="stable"), np.cumsum(np.bincount(label))[:-1])
