"""Half-edges of a triangle list, each with its twin: what is asked of a mesh before it is known to be sound."""

from typing import NamedTuple

import numpy as np
from scipy import sparse


class HalfEdges(NamedTuple):
    """Half-edges of a triangle list: number 3f + c runs from corner c of face f to the next corner."""

    origin: np.ndarray
    target: np.ndarray
    twin: np.ndarray  # -1 where no half-edge runs the other way


def half_edges(faces: np.ndarray) -> HalfEdges:
    """Half-edges of ``faces`` (F, 3) with their twins; they need not be closed, but no half-edge may occur twice."""
    origin = faces.ravel()
    target = faces[:, [1, 2, 0]].ravel()
    num = int(faces.max(initial=-1)) + 1
    number = np.arange(1, len(origin) + 1)  # of half-edges, from 1: a stored 0 would look like none
    there, back = (sparse.csr_matrix((number, pair), shape=(num, num)) for pair in ((origin, target), (target, origin)))
    there.sort_indices()
    back.sort_indices()
    is_closed = there.nnz == len(number) and np.array_equal(there.indptr, back.indptr)
    if is_closed and np.array_equal(there.indices, back.indices):  # entry by entry what runs there and what runs back
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
    """For the half-edge i -> j of face (i, j, k), the number of the half-edge i -> k: one step around vertex i."""
    num = np.arange(len(edges.origin))
    previous = num - num % 3 + (num + 2) % 3
    return edges.twin[previous]


def edge_codes(faces: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """For each half-edge, the number of its edge; for each edge, its smaller end and how many faces it has."""
    ends = np.sort(np.stack([faces, faces[:, [1, 2, 0]]], axis=-1).reshape(-1, 2), axis=1).astype(np.int64)
    num = np.int64(faces.max(initial=-1)) + 1
    code, edge, count = np.unique(ends[:, 0] * num + ends[:, 1], return_inverse=True, return_counts=True)
    return edge.ravel(), code // max(num, 1), count


def by_label(label: np.ndarray) -> list[np.ndarray]:
    """The places (n,) of 0, 1, ... in ``label``, ascending, for each up to the largest."""
    return np.split(np.argsort(label, kind="stable"), np.cumsum(np.bincount(label))[:-1])
