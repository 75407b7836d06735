"""Ordered one-rings: the connectivity of a closed oriented surface as one table.

Row i of ``rings`` (n, K) lists the neighbours of vertex i counter-clockwise seen from outside, padded with -1. So the
faces at i are ``(i, rings[i, k], rings[i, k + 1])``, cyclically: the table defines the surface. A vertex has one row,
and so one fan: pinched vertices cannot be represented.
"""

import numpy as np

from msf_jax.base.errors import MeshError
from msf_jax.topology.graphs import half_edges


def ring_capacity(degree: int) -> int:
    """The slots of a row for ``degree`` neighbours: the next multiple of 8."""
    return -(-degree // 8) * 8


def rings_from_faces(faces: np.ndarray, num_vertices: int) -> np.ndarray:
    """Ring table (n, K) of a closed, oriented, vertex-manifold triangle list.

    Raises:
        MeshError: a vertex is in no face, or its faces do not form one closed fan.
    """
    edges = half_edges(faces)
    step = np.roll(edges.twin.reshape(-1, 3), 1, axis=1).ravel()  # from i -> j of face (i, j, k) to i -> k
    degree = np.bincount(edges.origin, minlength=num_vertices)
    if len(edges.origin) == 0 or degree.min() == 0 or (edges.twin < 0).any():
        raise MeshError(
            "the faces do not cover every vertex with a closed surface: check the mesh with meshes.checking first"
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
            raise MeshError("the faces around a vertex form several fans: split it with meshes.checking first")
    return rings


def beside_rings(rings: np.ndarray, faces: np.ndarray, values: np.ndarray) -> np.ndarray:
    """The ``values`` (3F,) of the half-edges of ``faces`` as a table (n, K) beside their ``rings``, 0 elsewhere."""
    edges, table = half_edges(faces), np.zeros(rings.shape, dtype=values.dtype)
    table[edges.origin, find_slot(rings[edges.origin], edges.target)] = values
    return table


def ring_degrees(rings: np.ndarray) -> np.ndarray:
    """Number of neighbours (n,) in each row."""
    return np.count_nonzero(rings >= 0, axis=1)


def find_slot(rows: np.ndarray, neighbour: np.ndarray) -> np.ndarray:
    """The slot (c,) of ``neighbour`` (c,) in each of ``rows`` (c, K); it must exist."""
    return (rows == neighbour[:, None]).argmax(axis=1)


def apexes(rings: np.ndarray, degree: np.ndarray, a: np.ndarray, b: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """For edges ab (c,), the third vertices of the faces to the left (a, b, left) and to the right (b, a, right)."""
    slot = find_slot(rings[a], b)
    return rings[a, (slot + 1) % degree[a]], rings[a, (slot - 1) % degree[a]]


def edges_from_rings(rings: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Every edge once, as (a, b) with a < b, in ascending order of a."""
    a, slot = np.nonzero(rings > np.arange(len(rings))[:, None])
    return a, rings[a, slot]


def faces_from_rings(rings: np.ndarray) -> np.ndarray:
    """Every face (F, 3) once, its smallest vertex first."""
    vertex, slot = np.divmod(np.flatnonzero(rings > np.arange(len(rings))[:, None]), rings.shape[1])
    degree = ring_degrees(rings)
    following = rings[vertex, np.where(slot + 1 < degree[vertex], slot + 1, 0)]
    faces = np.stack([vertex, rings[vertex, slot], following], axis=1)
    return faces[following > vertex]
