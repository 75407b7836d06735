"""Where a surface crosses itself, and where a curve passes through it.

Neighbours that noise folds over each other do not count, nor does the inner side of a bend: two faces are apart if
their nodes are far from each other along the curve. Nor does a lid, which may cross the wall at a jagged rim.
"""

import numpy as np
from scipy.sparse import csgraph

from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import TOUCHING, unit
from msf_jax.topology import graphs

ALONG = 2.0  # radii: least distance along the curve of nodes whose faces are apart


def apart_pairs(
    shape: Enclosure,
    lids: np.ndarray | tuple[int, ...],
    node: np.ndarray,
    radii: np.ndarray,
    edges: np.ndarray,
    length: np.ndarray,
) -> np.ndarray:
    """(P, 2) the pairs of faces of ``shape`` that cross and are apart, see `Crossed`, without ``lids`` (L,).

    node: (V,) the node of the curve that each vertex goes to. radii: (N,) of the nodes. edges: (E, 2) of the curve,
    length: (E,) theirs."""
    pairs = shape.crossed.pairs
    pairs = pairs[~np.isin(pairs, lids).any(axis=1)]
    here, there = node[shape.faces[pairs, 0]].T
    is_apart, nearest = np.zeros(len(pairs), dtype=bool), ALONG * np.maximum(radii[here], radii[there])
    curve = graphs.weighted(len(radii), *edges.T, weight=np.maximum(length, 1e-300))  # an entry of 0 is no edge
    for start in np.unique(here):
        own = here == start
        away = csgraph.dijkstra(curve, directed=False, indices=start, limit=float(nearest[own].max()))
        is_apart[own] = away[there[own]] > nearest[own]
    return pairs[is_apart]


def passed(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray) -> np.ndarray:
    """The edges of the curve ``(vertices (N, 3), edges (E, 2))``, by number, that pass through the surface from inside
    to inside. Where parts of it touch, as a ring's coincident ends, no triangles cross."""
    a, along = vertices[edges[:, 0]], vertices[edges[:, 1]] - vertices[edges[:, 0]]
    length, along = np.linalg.norm(along, axis=1), unit(along)
    edge, _, distance, _ = shape.ray_hits(a, along, length)
    sides = (a[edge] + (distance + side * shape.extent)[:, None] * along[edge] for side in (-TOUCHING, TOUCHING))
    return np.unique(edge[np.logical_and(*map(shape.contains, sides))])
