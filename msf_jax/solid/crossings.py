"""Where a surface crosses itself apart from the folds of noise, and where a curve passes through it."""

import numpy as np
from scipy.sparse import csgraph

from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import TOUCHING, unit
from msf_jax.topology import graphs

ALONG = 2.0  # radii: least distance along the curve of nodes whose faces are apart


def apart_pairs(
    shape: Enclosure, node: np.ndarray, radii: np.ndarray, edges: np.ndarray, length: np.ndarray
) -> np.ndarray:
    """(P, 2) the pairs of faces of ``shape`` that cross, see `Crossed`, whose nodes are far from each other along the
    curve. Those of neighbours that noise folds over each other are not, nor those of the inner side of a bend.

    node: (V,) the node of the curve that each vertex goes to. radii: (N,) of the nodes. edges: (E, 2) of the curve,
    length: (E,) theirs."""
    pairs = shape.crossed.pairs
    here, there = node[shape.faces[pairs][:, :, 0]].T
    away, nearest = np.zeros(len(pairs)), ALONG * np.maximum(radii[here], radii[there])
    curve = graphs.weighted(len(radii), *edges.T, weight=np.maximum(length, 1e-300))  # an entry of 0 is no edge
    for start in np.unique(here):
        own = here == start
        away[own] = csgraph.dijkstra(curve, directed=False, indices=start, limit=float(nearest[own].max()))[there[own]]
    return pairs[away > nearest]


def passed(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray) -> np.ndarray:
    """The edges of the curve ``(vertices (N, 3), edges (E, 2))``, by number, that pass through the surface from inside
    to inside. Where parts of it touch, as a ring's coincident ends, no triangles cross."""
    a, along = vertices[edges[:, 0]], vertices[edges[:, 1]] - vertices[edges[:, 0]]
    length, along = np.linalg.norm(along, axis=1), unit(along)
    edge, _, distance, _ = shape.ray_hits(a, along, length)
    sides = (a[edge] + (distance + side * shape.extent)[:, None] * along[edge] for side in (-TOUCHING, TOUCHING))
    return np.unique(edge[np.logical_and(*map(shape.contains, sides))])
