"""Branches for thin limbs that a curve has missed, as they contracted away before the limb beside them was thin.

A vertex of the surface is explained if the curve is about as near to it as the solid is thick there. What is not hangs
together in patches. From where a patch borders on the rest, waves run over it along its edges, a step a wave; on a
thin limb each wave is a ring, and the middles of successive rings are its curve (as in skeletor's wavefront, here for
what is left only). Patches no longer than they are thick are bumps.
"""

from typing import NamedTuple

import numpy as np
from scipy import sparse, spatial
from scipy.sparse import csgraph

from msf_jax.host.poles import thickness
from msf_jax.host.poles.balls import shrinking_balls
from msf_jax.host.solid.enclosure import Enclosure
from msf_jax.host.solid.geometry import unit, vertex_normals

EXPLAINED = 2.0  # radii, that the curve is away from a vertex at most
SLENDER = 2.0  # half widths across, that a limb is longer than
THICKEST = 0.02  # diagonals, the radius of limbs that a curve may have missed
ROUND = 3.0  # radii of the balls in a ring, that it is wide at most: a wider one is in a sheet
ROUNDS = 2  # the second one finds what a limb of the first has hidden
SPACING = 0.5  # radii, between the points that stand for the curve
MOST_POINTS = 100  # of these on an edge


class Rings(NamedTuple):
    """Rings of the waves. parent: (R,) the ring before each, -1 for one at a border. middle: (R, 3).

    width: (R,) root mean square distance of a ring's vertices from their centroid: its radius around a limb, and about
    a third of its length in a sheet, however thin that is. is_round: (R,) whether it is no wider than a limb is thick.
    """

    parent: np.ndarray
    middle: np.ndarray
    width: np.ndarray
    is_round: np.ndarray


def grow(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The curve with a branch for each thin limb of a solid of diagonal 1 that it has missed: nodes, new ones last, and
    edges. A branch begins at the node that is nearest to its first ring, and adds no loop."""
    x, normals = shape.vertices, unit(vertex_normals(shape.vertices, shape.faces))
    tree, most, beside = spatial.KDTree(x), 2 * THICKEST, _neighbours(shape.faces, len(x))
    radius, is_known = np.full(len(x), most), np.zeros(len(x), dtype=bool)
    for _ in range(ROUNDS):
        away, ball = _nearest_ball(shape, vertices, edges)
        is_far = away > EXPLAINED * ball
        # Most vertices are explained by the curve's balls, and need none of their own.
        asked = np.flatnonzero((is_far | (beside @ is_far > 0)) & ~is_known)
        radius[asked] = shrinking_balls(x[asked], normals[asked], tree, most, most, asked).radius
        is_known[asked] = True
        least = radius.copy()  # the ball behind the middle of a flat end is as long as the limb
        np.minimum.at(least, shape.faces.ravel(), radius[np.roll(shape.faces, -1, axis=1).ravel()])
        is_left = is_far & (least < THICKEST) & (away > EXPLAINED * radius)
        rings = _wavefronts(x, x - radius[:, None] * normals, radius, beside, is_left)
        new = np.flatnonzero(_is_limb(rings))
        number = np.full(len(rings.parent), -1)
        number[new] = len(vertices) + np.arange(len(new))
        above = rings.parent[new]
        joint = spatial.KDTree(vertices).query(rings.middle[new])[1] if len(new) else new
        ends = np.stack([np.where(above < 0, joint, number[above]), number[new]], axis=1)
        vertices, edges = np.concatenate([vertices, rings.middle[new]]), np.concatenate([edges, ends])
    return vertices, edges


def _neighbours(faces: np.ndarray, num: int) -> sparse.csr_matrix:
    """(V, V) 1 where two vertices share an edge."""
    tail, head = faces.ravel(), np.roll(faces, -1, axis=1).ravel()  # closed: every edge is there both ways
    return sparse.csr_matrix((np.ones(len(tail)), (tail, head)), shape=(num, num))


def _nearest_ball(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """How far each vertex of the surface (V,) is from the curve, and how thick the limb (V,) is there at the curve."""
    a, b = vertices[edges[:, 0]], vertices[edges[:, 1]]
    clear = shape.approximate_clearance(vertices)[0]
    # At the end of a limb the ball is small: the limb is as thick as a little before.
    clear = thickness.limb_radii(vertices, edges, np.arange(len(vertices)), clear, float(clear.max()))
    clearance = clear[edges].max(axis=1)
    pace = SPACING * np.maximum(clearance, float(np.median(clearance)))
    num = np.clip(np.ceil(np.linalg.norm(b - a, axis=1) / pace), 1, MOST_POINTS).astype(int)
    row = np.repeat(np.arange(len(edges)), num)
    place = np.arange(len(row)) - np.repeat(np.cumsum(num) - num, num)
    share = ((place + 0.5) / num[row])[:, None]
    points = np.concatenate([vertices, a[row] * (1 - share) + b[row] * share])
    away, near = spatial.KDTree(points).query(shape.vertices)
    return np.asarray(away), np.concatenate([clear, clearance[row]])[near]


def _wavefronts(
    points: np.ndarray, centres: np.ndarray, radius: np.ndarray, beside: sparse.csr_matrix, is_left: np.ndarray
) -> Rings:
    """Rings of the waves over what is left of ``points`` (V, 3), from its borders on.

    The middle of a ring is the mean of the balls' ``centres`` (V, 3), but of its points where it is the last.
    """
    step = np.where(is_left, -1, 0)
    front, level = ~is_left, 0
    while front.any():
        level += 1
        front = (beside @ front.astype(float) > 0) & (step < 0)
        step[front] = level
    mine = np.flatnonzero(step > 0)
    pairs = beside[mine][:, mine].tocoo()
    difference = step[mine][pairs.col] - step[mine][pairs.row]
    same, down = difference == 0, difference == 1
    graph = sparse.coo_matrix((np.ones(same.sum()), (pairs.row[same], pairs.col[same])), shape=(len(mine), len(mine)))
    num, ring = csgraph.connected_components(graph, directed=False)
    links = np.stack([ring[pairs.col[down]], ring[pairs.row[down]]], axis=1).reshape(-1, 2)
    links, votes = np.unique(links, axis=0, return_counts=True)
    parent = np.full(num, -1)
    order = np.argsort(votes, kind="stable")
    parent[links[order, 0]] = links[order, 1]  # of several the one with the most edges to it
    count = np.maximum(np.bincount(ring, minlength=num), 1)

    def mean(of_vertex: np.ndarray) -> np.ndarray:
        return np.bincount(ring, weights=of_vertex[mine], minlength=num) / count

    is_last = np.bincount(parent[parent >= 0], minlength=num) == 0
    on_surface, inside = (np.stack([mean(axis) for axis in each.T], axis=1) for each in (points, centres))
    away = np.zeros(len(points))
    away[mine] = ((points[mine] - on_surface[ring]) ** 2).sum(axis=1)
    width = np.sqrt(mean(away))
    return Rings(parent, np.where(is_last[:, None], on_surface, inside), width, width < ROUND * mean(radius))


def _is_limb(rings: Rings) -> np.ndarray:
    """(R,) which rings are on limbs: on the longest way from a border, or on one that branches off and is slender."""
    order = _borders_first(rings.parent)
    has_parent = rings.parent >= 0
    length = np.linalg.norm(rings.middle - rings.middle[rings.parent], axis=1)
    length[~has_parent] = 0.0
    reach = np.zeros(len(order))  # from the ring before it to the farthest end
    first = np.full(len(order), -1)  # the ring after it that is on the way there
    for ring in order[::-1].tolist():
        reach[ring] += length[ring]
        above = int(rings.parent[ring])
        if above >= 0 and (first[above] < 0 or reach[ring] > reach[above]):
            reach[above], first[above] = reach[ring], ring
    is_limb = (reach > SLENDER * rings.width) & rings.is_round
    for ring in order.tolist():
        above = int(rings.parent[ring])
        if above >= 0:
            is_limb[ring] = is_limb[above] and (is_limb[ring] or first[above] == ring)
    return is_limb


def _borders_first(parent: np.ndarray) -> np.ndarray:
    """The rings, each after its parent."""
    depth = np.where(parent < 0, 0, -1)
    while (depth < 0).any():
        now = (depth < 0) & (depth[parent] >= 0)
        depth[now] = depth[parent[now]] + 1
    return np.argsort(depth, kind="stable")
