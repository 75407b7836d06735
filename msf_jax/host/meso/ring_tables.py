"""Ordered one-rings: the connectivity of a closed oriented surface as one table.

Row i of ``rings`` (n, K) lists the neighbours of vertex i counter-clockwise seen from outside, padded with -1, so that
every face at i is ``(i, rings[i, k], rings[i, k + 1])``, cyclically. The table alone is the surface: faces, edges, the
two apexes of an edge and the link condition are read off it, an edit touches only the rows around it, and the same
table, transposed, is what the device gathers through. A vertex has one row and so one fan: pinches cannot be expressed.
"""

import numpy as np

from msf_jax.base.errors import MeshError
from msf_jax.host.mesh.half_edges import half_edges, next_in_ring

RING_CAPACITIES = (8, 12, 16, 24, 32)


def ring_capacity(degree: int) -> int:
    """The smallest ring capacity that holds ``degree`` neighbours: 8, 12, 16, 24, 32, then multiples of 32."""
    for capacity in RING_CAPACITIES:
        if degree <= capacity:
            return capacity
    return -(-degree // 32) * 32


def rings_from_faces(faces: np.ndarray, num_vertices: int) -> np.ndarray:
    """Ring table (n, K) of a closed, oriented, vertex-manifold triangle list.

    Raises:
        MeshError: a vertex is in no face, or its faces do not form one closed fan.
    """
    edges = half_edges(faces)
    step = next_in_ring(edges)
    degree = np.bincount(edges.origin, minlength=num_vertices)
    if len(edges.origin) == 0 or degree.min() == 0 or (edges.twin < 0).any():
        raise MeshError(
            "the faces do not cover every vertex with a closed surface: check the mesh with host.surface first"
        )
    rings = np.full((num_vertices, ring_capacity(int(degree.max()))), -1, dtype=np.int64)
    first = np.empty(num_vertices, dtype=np.int64)
    first[edges.origin[::-1]] = np.arange(len(edges.origin))[::-1]
    current = first.copy()
    for k in range(int(degree.max())):  # one step around every vertex at once
        open_ring = degree > k
        rings[open_ring, k] = edges.target[current[open_ring]]
        current = step[current]
        if (current[open_ring & (degree > k + 1)] == first[open_ring & (degree > k + 1)]).any():
            raise MeshError("the faces around a vertex form several fans: split the vertex with host.surface first")
    return rings


def ring_degrees(rings: np.ndarray) -> np.ndarray:
    """Number of neighbours (n,) in each row."""
    return np.count_nonzero(rings >= 0, axis=1)


def find_slot(rows: np.ndarray, neighbour: np.ndarray) -> np.ndarray:
    """The slot (c,) of ``neighbour`` (c,) in each of ``rows`` (c, K); it must be there."""
    return (rows == neighbour[:, None]).argmax(axis=1)


def apexes(rings: np.ndarray, degree: np.ndarray, a: np.ndarray, b: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """For edges ab (c,), the third vertices of the faces to the left (a, b, left) and to the right (b, a, right)."""
    slot = find_slot(rings[a], b)
    return rings[a, (slot + 1) % degree[a]], rings[a, (slot - 1) % degree[a]]


def edges_from_rings(rings: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Every edge once, as (a, b) with a < b, in ascending order of a."""
    a, slot = np.nonzero(rings > np.arange(len(rings))[:, None])
    return a, rings[a, slot]


def edges_around(rings: np.ndarray, is_center: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Every edge with at least one end in ``is_center`` (n,), once, as (a, b) with a < b."""
    center = np.flatnonzero(is_center)
    rows = rings[center]
    # An edge between two centres is met from both ends: it is taken from the smaller one.
    row, slot = np.nonzero((rows >= 0) & ((rows > center[:, None]) | ~is_center[rows]))
    one, other = center[row], rows[row, slot]
    return np.minimum(one, other), np.maximum(one, other)


def encode_edges(a: np.ndarray, b: np.ndarray, num_vertices: int) -> np.ndarray:
    """One sortable integer an edge."""
    return a * np.int64(num_vertices) + b


def faces_from_rings(rings: np.ndarray) -> np.ndarray:
    """Every face (F, 3) once, its smallest vertex first."""
    n, capacity = rings.shape
    degree = ring_degrees(rings)
    following = np.concatenate([rings[:, 1:], np.full((n, 1), -1)], axis=1)
    live = np.flatnonzero(degree)
    following[live, degree[live] - 1] = rings[live, 0]
    vertex = np.broadcast_to(np.arange(n)[:, None], (n, capacity))
    smallest = (rings > vertex) & (following > vertex)
    return np.stack([vertex[smallest], rings[smallest], following[smallest]], axis=1)
