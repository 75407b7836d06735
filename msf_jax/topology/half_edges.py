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
    origin = faces.ravel()
    target = faces[:, [1, 2, 0]].ravel()
    num = int(faces.max(initial=-1)) + 1
    number = np.arange(1, len(origin) + 1)  # of half-edges, from 1: a stored 0 would count as no entry
    there, back = (sparse.csr_matrix((number, pair), shape=(num, num)) for pair in ((origin, target), (target, origin)))
    there.sort_indices()
    back.sort_indices()
    is_closed = there.nnz == len(number) and np.array_equal(there.indptr, back.indptr)
    if is_closed and np.array_equal(there.indices, back.indices):  # then entries of both are twins
        twin = np.empty(len(number), dtype=np.int64)
        twin[np.asarray(there.data, dtype=np.int64) - 1] = np.asarray(back.data, dtype=np.int64) - 1
        return HalfEdges(origin, target, twin)
    forward = origin.astype(np.int64) * num + target
    backward = target.astype(np.int64) * num + origin
    order = np.argsort(forward, kind="stable")
    place = np.searchsorted(forward, backward, sorter=order).clip(max=len(order) - 1)
    twin = order[place] if len(order) else order
    return HalfEdges(origin, target, np.where(forward[twin] == backward, twin, -1))


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
