"""The curve of a coarse solid, whose limbs have three to five sides: its Reeb curve by geodesic distance.

Decimated neurons, vessels and wires are of this kind: their edges are longer than their limbs are thick, so merging and
splitting edges leaves no shape to contract. Instead, wavefronts of equal geodesic distance spread from the thickest
point of the solid. The middles of the fronts' rings, about a radius apart, are the curve. Where two fronts meet, it
closes a loop.
"""

from typing import NamedTuple

import numpy as np
from scipy import spatial

from msf_jax.inside import balls
from msf_jax.limbs.fronts import distances
from msf_jax.limbs.levels import levels
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import unit, vertex_normals
from msf_jax.solid.kernels import tree_of


class ReebCurve(NamedTuple):
    """A curve: vertices (N, 3), edges (E, 2), and node_of_vertex (V,), a node near each vertex of the surface."""

    vertices: np.ndarray
    edges: np.ndarray
    node_of_vertex: np.ndarray


def reeb_curve(shape: Enclosure) -> ReebCurve | None:
    """The curve of a connected solid of diagonal 1; None if it is not coarse: if half of its edges, by length, are no
    longer than the limb's radius, as in a limb with six sides."""
    x, faces = shape.vertices, shape.faces
    tail, head = faces.ravel(), np.roll(faces, -1, axis=1).ravel()
    length = np.linalg.norm(x[tail] - x[head], axis=1)
    longest = np.zeros(len(x))
    np.maximum.at(longest, np.concatenate([tail, head]), np.tile(length, 2))
    asked, every = (x, unit(vertex_normals(x, faces)), tree_of(x, x)), np.arange(len(x))
    # Balls as large as their vertex's longest edge: on a fine surface nearly all are empty, and found at once.
    reach = balls.shrinking_balls(*asked, longest, longest, every)[0]
    if 2 * length[length > np.minimum(reach[tail], reach[head])].sum() <= length.sum():
        return None
    radius = balls.shrinking_balls(*asked, 2 * balls.THIN, 1.0, every)[0]
    # A ball between few vertices can be too large, so the nearest vertices of all middles are asked for.
    middles = x - radius[:, None] * asked[1]
    seed = int(np.where(shape.contains(middles), spatial.KDTree(x).query(middles)[0], 0.0).argmax())
    start = middles[seed]
    # Wavefronts begin all around the largest ball: from one vertex of a rim, they would run obliquely along the limb.
    near = np.flatnonzero(np.linalg.norm(x - start, axis=1) <= 2 * radius[seed])
    found = levels(x, faces, distances(shape)(indices=near), float(np.median(radius)))
    # The middle of each ring is a node, and stands for the piece above it. Of a piece with several rings below, in
    # which wavefronts meet, one stands for it. From each ring, edges lead to the nodes of both of its pieces.
    node, of_piece = np.arange(len(found.centre)), np.full(len(found.contents), len(found.centre))
    of_piece[found.above] = node
    edges = np.stack([np.tile(node, 2), of_piece[np.concatenate([found.below, found.above])]], axis=1)
    vertices = np.concatenate([found.centre, start[None]])
    return ReebCurve(vertices, edges[edges[:, 0] != edges[:, 1]], of_piece[found.piece])
