"""Which of the faces that cross are apart along the surface.

Neighbours that noise folds over each other do not count, nor does the inner side of a bend. Two faces are apart if more
than `RINGS` edges separate them, and if they are far from each other: in space or along the curve.
"""

import numpy as np
from scipy import sparse
from scipy.sparse import csgraph

from msf_jax.solid.enclosure import Enclosure, middles
from msf_jax.topology import graphs

RINGS = 3  # edges: faces that so few edges join are neighbours, and never apart
ALONG = 2.0  # radii: least distance along the curve of nodes whose faces are apart
ACROSS = 1.2  # radii: least distance in space of faces that are apart
AT_ONCE = 256  # nodes whose distances along the curve are computed together: bounds memory


def apart_pairs(
    shape: Enclosure, node: np.ndarray, radii: np.ndarray, edges: np.ndarray, length: np.ndarray
) -> np.ndarray:
    """(P, 2) the pairs of faces of ``shape`` that cross and are apart, among those of `Crossed`.

    node: (V,) the node of the curve that each vertex goes to. radii: (N,) of the nodes. edges: (E, 2) of the curve,
    length: (E,) theirs.
    """
    pairs = shape.crossed.pairs
    if not len(pairs):
        return pairs
    corners = shape.faces[pairs]  # (P, 2, 3)
    place = middles(shape.vertices[corners].reshape(-1, 3, 3)).reshape(-1, 2, 3)
    here, there = node[corners[:, :, 0]].T
    is_apart = np.linalg.norm(place[:, 0] - place[:, 1], axis=1) > ACROSS * np.maximum(radii[here], radii[there])
    is_apart |= ~np.isin(here * len(radii) + there, _codes_near(edges, length, radii))
    beside = _codes_beside(shape.faces, pairs, len(shape.vertices))
    for a in corners[:, 0].T:
        for b in corners[:, 1].T:
            is_apart &= ~np.isin(a * len(shape.vertices) + b, beside)
    return pairs[is_apart]


def _codes_beside(faces: np.ndarray, pairs: np.ndarray, num: int) -> np.ndarray:
    """u V + v of all pairs of vertices that at most ``RINGS`` edges join; only near the faces of ``pairs``
    (P, 2), as a way from one of them to the other is near one of them."""
    near = np.zeros(num, dtype=bool)
    near[faces[pairs]] = True
    for _ in range(RINGS // 2):
        near[faces[near[faces].any(axis=1)]] = True
    faces = faces[near[faces].any(axis=1)]
    ends = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    table = graphs.weighted(num, *ends.T, weight=np.ones(len(ends), dtype=bool))
    step = sparse.csr_matrix(table + table.T + sparse.eye(num, dtype=bool, format="csr"))
    joined = sparse.coo_matrix(step**RINGS)
    return joined.row.astype(np.int64) * num + joined.col


def _codes_near(edges: np.ndarray, length: np.ndarray, radii: np.ndarray) -> np.ndarray:
    """i N + j of all pairs of nodes within ``ALONG`` times their larger radius along the curve."""
    num = len(radii)
    near = [np.arange(num) * (num + 1)]
    weight = np.maximum(length, 1e-300)  # SciPy takes an entry of 0 for a missing edge
    graph = graphs.weighted(num, *edges.T, weight=weight)
    for first in range(0, num, AT_ONCE):
        rows = np.arange(first, min(first + AT_ONCE, num))
        away = csgraph.dijkstra(graph, directed=False, indices=rows, limit=ALONG * float(radii.max()))
        i, j = np.nonzero(away <= ALONG * np.maximum(radii[rows, None], radii))
        near.append(rows[i] * num + j)
    return np.concatenate(near)
