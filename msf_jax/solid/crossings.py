"""Which of the faces that cross are apart along the surface.

Neighbours that noise folds over each other do not count, nor does the inner side of a bend. Two faces are apart if more
than `RINGS` edges separate them, and if their nodes are far from each other along the curve.
"""

import numpy as np
from scipy import sparse
from scipy.sparse import csgraph

from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import TOUCHING, unit
from msf_jax.topology import graphs

RINGS = 3  # edges: faces that so few edges join are neighbours, and never apart
ALONG = 2.0  # radii: least distance along the curve of nodes whose faces are apart


def apart_pairs(
    shape: Enclosure, node: np.ndarray, radii: np.ndarray, edges: np.ndarray, length: np.ndarray
) -> np.ndarray:
    """(P, 2) the pairs of faces of ``shape`` that cross and are apart, see `Crossed`.

    node: (V,) the node of the curve that each vertex goes to. radii: (N,) of the nodes. edges: (E, 2) of the curve,
    length: (E,) theirs."""
    pairs, num = shape.crossed.pairs, len(shape.vertices)
    if not len(pairs):
        return pairs
    corners = shape.faces[pairs]  # (P, 2, 3)
    here, there = node[corners[:, :, 0]].T
    is_apart, nearest = np.zeros(len(pairs), dtype=bool), ALONG * np.maximum(radii[here], radii[there])
    curve = graphs.weighted(len(radii), *edges.T, weight=np.maximum(length, 1e-300))  # an entry of 0 is no edge
    for start in np.unique(here):
        own = here == start
        away = csgraph.dijkstra(curve, directed=False, indices=start, limit=float(nearest[own].max()))
        is_apart[own] = away[there[own]] > nearest[own]
    # Vertices that at most `RINGS` edges join. A way from one of the faces to the other is near one of them.
    near = np.zeros(num, dtype=bool)
    near[corners] = True
    for _ in range(RINGS // 2):
        near[shape.faces[near[shape.faces].any(axis=1)]] = True
    faces = shape.faces[near[shape.faces].any(axis=1)]
    tail, head = faces.ravel(), np.roll(faces, -1, axis=1).ravel()
    table = graphs.weighted(num, tail, head, weight=np.ones(len(tail), dtype=bool))
    joined = sparse.coo_matrix(sparse.csr_matrix(table + table.T + sparse.eye(num, dtype=bool, format="csr")) ** RINGS)
    beside = joined.row.astype(np.int64) * num + joined.col
    codes = corners[:, 0, :, None] * num + corners[:, 1, None, :]
    return pairs[is_apart & ~np.isin(codes, beside).any(axis=(1, 2))]


def passed(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray) -> np.ndarray:
    """The edges of the curve ``(vertices (N, 3), edges (E, 2))``, by number, that pass through the surface from inside
    to inside. Where parts of it touch, as a ring's coincident ends, no triangles cross."""
    a, along = vertices[edges[:, 0]], vertices[edges[:, 1]] - vertices[edges[:, 0]]
    length, along = np.linalg.norm(along, axis=1), unit(along)
    edge, _, distance, _ = shape.ray_hits(a, along, length)
    sides = (a[edge] + (distance + side * shape.extent)[:, None] * along[edge] for side in (-TOUCHING, TOUCHING))
    return np.unique(edge[np.logical_and(*map(shape.contains, sides))])
