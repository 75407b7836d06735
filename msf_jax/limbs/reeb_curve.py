"""The curve of a coarse solid, whose limbs have three to five sides: its Reeb curve by geodesic distance.

Decimated neurons, vessels and wires are of this kind: their edges are longer than their limbs are thick, so merging and
splitting edges leaves no shape to contract. Instead, wavefronts of equal geodesic distance spread from the thickest
point of the solid. The middles of the fronts' rings, about a radius apart, are the curve. Where two fronts meet, it
closes a loop.
"""

from typing import NamedTuple

import numpy as np
from scipy import spatial
from scipy.sparse import csgraph

from msf_jax.inside import balls
from msf_jax.inside.containment import is_inside
from msf_jax.limbs.levels import Levels, levels
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import repeated, unit, vertex_normals
from msf_jax.topology import graphs

# Radii: a surface is coarse if more than half of its edges, by length, are longer; in a thin solid than one radius, as
# in a limb with six sides. Nine tenths of a frame of bars are longer, half of a slab's.
FRAME = 8.0
ROUND = 2.0  # largest median of the rings' perimeters over those of circles of their size: a bar of 4 : 1 has it
MOST_AROUND = 32  # rings of a piece that are joined by a shortest tree; if there are more, all are joined to the first
OUTSIDE = 3.0  # factor on the length of an edge that is not inside, when the tree is chosen


class ReebCurve(NamedTuple):
    """A curve: vertices (N, 3), edges (E, 2), and node_of_vertex (V,), a node near each vertex of the surface."""

    vertices: np.ndarray
    edges: np.ndarray
    node_of_vertex: np.ndarray


def reeb_curve(shape: Enclosure, only_thin: bool = True) -> ReebCurve | None:
    """The curve of a connected solid of diagonal 1; None if the solid is not coarse, a plate, or, with ``only_thin``,
    not thin."""
    x, faces = shape.vertices, shape.faces
    tail, head = faces.ravel(), np.roll(faces, -1, axis=1).ravel()
    length = np.linalg.norm(x[tail] - x[head], axis=1)
    longest = np.zeros(len(x))
    np.maximum.at(longest, np.r_[tail, head], np.r_[length, length])
    asked, every = (x, unit(vertex_normals(x, faces)), spatial.KDTree(x)), np.arange(len(x))
    # Balls as large as their vertex's longest edge: on a fine surface nearly all are empty, and found at once.
    reach = balls.shrinking_balls(*asked, longest, longest, every)[0]
    reach = np.minimum(reach[tail], reach[head])
    if 2 * length[length > reach].sum() <= length.sum():
        return None
    radius = balls.shrinking_balls(*asked, balls.FIRST, 1.0, every)[0]
    step = float(np.median(radius))
    is_thin = step < balls.THIN
    if not is_thin and (only_thin or 2 * length[length > FRAME * reach].sum() <= length.sum()):
        return None
    # A ball between few vertices can be too large, so the nearest vertices of all middles are asked for.
    middles = x - radius[:, None] * asked[1]
    seed = int(np.where(shape.contains(middles), asked[2].query(middles)[0], 0.0).argmax())
    # Wavefronts begin all around the largest ball: from one vertex of a rim, they would run obliquely along the limb.
    beyond = np.maximum(np.linalg.norm(x - middles[seed], axis=1) - radius[seed], 0.0)
    near = np.flatnonzero(beyond <= radius[seed])
    tail, head = np.append(tail, np.full(len(near), len(x))), np.append(head, near)
    length = np.maximum(np.append(length, beyond[near]), 1e-12)
    away = csgraph.dijkstra(graphs.weighted(len(x) + 1, tail, head, length), directed=False, indices=len(x))[:-1]
    found = levels(x, faces, away, step)
    if not len(found.centre) or np.median(found.perimeter / np.maximum(found.size, 1e-300)) > ROUND * 2 * np.pi:
        return None
    place = int(found.piece[np.linalg.norm(x - middles[seed], axis=1).argmin()])
    vertices, edges = _joined(shape, found, middles[seed], place)
    node_of_piece = np.full(len(found.contents), len(found.centre))
    node_of_piece[found.below] = node_of_piece[found.above] = np.arange(len(found.centre))
    return ReebCurve(vertices, edges, node_of_piece[found.piece])


def _joined(shape: Enclosure, found: Levels, start: np.ndarray, piece_of_start: int) -> tuple[np.ndarray, np.ndarray]:
    """The curve through the rings' centres, joined by a shortest tree in each piece, and the ``start`` (3,) in its
    piece, to which all rings there are joined.

    Edges inside the solid are preferred. The curve has as many cycles as the graph of rings and pieces."""
    num = len(found.centre)
    vertices = np.concatenate([found.centre, start[None]])
    piece = np.concatenate([found.below, found.above, [piece_of_start]])
    node = np.concatenate([np.arange(num), np.arange(num), [num]])
    order = np.lexsort((node, piece))
    piece, node = piece[order], node[order]
    count = np.bincount(piece, minlength=len(found.contents))[piece]
    first = np.searchsorted(piece, piece)
    row, place = repeated(np.where(count > MOST_AROUND, 1, count))
    other = first[row] + place
    row, other = row[other < row], other[other < row]
    a, b = vertices[node[row]], vertices[node[other]]
    cost = np.linalg.norm(a - b, axis=1) + 1e-12
    cost[(node[row] == num) | (node[other] == num)] = 1e-12
    is_choice = count[row] > 2
    cost[is_choice] *= np.where(is_inside(shape, a[is_choice], b[is_choice]), 1.0, OUTSIDE)
    tree = csgraph.minimum_spanning_tree(graphs.weighted(len(node), row, other, cost)).tocoo()
    edges = np.stack([node[tree.row], node[tree.col]], axis=1)
    return vertices, edges[edges[:, 0] != edges[:, 1]]
