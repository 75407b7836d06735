"""Branches for thin limbs that a curve has missed, because they contracted before the limb beside them was thin.

A vertex of the surface is explained if its distance from the curve is about the thickness of the solid there. Vertices
that are not explained form patches. From the border of a patch, a wavefront advances edge by edge. On a thin limb each
front is a ring, and the middles of successive rings are the limb's curve (as in skeletor's wavefront method, but only
for these patches). A patch that is no longer than thick is a bump.
"""

from typing import NamedTuple

import numpy as np
from scipy import sparse, spatial
from scipy.sparse import csgraph

from msf_jax.host.poles import thickness
from msf_jax.host.poles.balls import shrinking_balls
from msf_jax.host.solid.enclosure import Enclosure
from msf_jax.host.solid.geometry import unit, vertex_normals

EXPLAINED = 2.0  # radii: largest distance from the curve to an explained vertex
SLENDER = 2.0  # ring widths: least length of a limb, to its farthest end
THICKEST = 0.02  # diagonals: largest radius of the limbs that are looked for
ROUND = 3.0  # mean ball radii of a ring: a wider ring belongs to a sheet
ROUNDS = 2  # searches: the second one finds limbs that were hidden by a limb of the first
SPACING = 0.5  # radii between sample points of the curve
MOST_POINTS = 100  # sample points on an edge


class Rings(NamedTuple):
    """The rings of the wavefront. parent: (R,) the ring before each, -1 at a border. middle: (R, 3) of each ring.

    width: (R,) root mean square distance of a ring's vertices from their centroid: its radius around a limb, and about
    a third of its length in a sheet of any thickness. is_round: (R,) whether its width fits a limb, see ``ROUND``.
    """

    parent: np.ndarray
    middle: np.ndarray
    width: np.ndarray
    is_round: np.ndarray


def grow(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The curve with a branch for each missed thin limb of a solid of diagonal 1: nodes, new ones last, and edges. A
    branch begins at the node nearest to its first ring, and adds no loop."""
    x, normals = shape.vertices, unit(vertex_normals(shape.vertices, shape.faces))
    tree, most, beside = spatial.KDTree(x), 2 * THICKEST, _neighbours(shape.faces, len(x))
    radius, is_known = np.full(len(x), most), np.zeros(len(x), dtype=bool)
    for _ in range(ROUNDS):
        away, ball = _nearest_ball(shape, vertices, edges)
        is_far = away > EXPLAINED * ball
        # The curve's balls cover most vertices. Only the other vertices need shrinking balls.
        asked = np.flatnonzero((is_far | (beside @ is_far > 0)) & ~is_known)
        radius[asked] = shrinking_balls(x[asked], normals[asked], tree, most, most, asked).radius
        is_known[asked] = True
        least = radius.copy()  # of each vertex and its neighbours, as the ball behind a flat end can be too large
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
    tail, head = faces.ravel(), np.roll(faces, -1, axis=1).ravel()  # a closed surface has both half-edges
    return sparse.csr_matrix((np.ones(len(tail)), (tail, head)), shape=(num, num))


def _nearest_ball(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The distance (V,) of each surface vertex from the curve, and the limb's radius (V,) at the nearest point."""
    a, b = vertices[edges[:, 0]], vertices[edges[:, 1]]
    clear = shape.approximate_clearance(vertices)[0]
    # The ball at the end of a limb is too small: the limb's radius is that of balls a little before.
    clear = thickness.limb_radii(vertices, edges, np.arange(len(vertices)), clear, float(clear.max()))
    clearance = clear[edges].max(axis=1)
    pace = SPACING * np.maximum(clearance, float(np.median(clear)))
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
    """Rings of the wavefront over the vertices of ``is_left`` (V,) among ``points`` (V, 3), from their borders on.

    The middle of a ring is the mean of its balls' ``centres`` (V, 3); for a last ring it is the mean of its points.
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
    parent[links[order, 0]] = links[order, 1]  # the last one wins: the parent that most edges lead to
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
    """(R,) which rings are on limbs: on the longest path from a border, or on a slender side branch of it."""
    order = _borders_first(rings.parent)
    has_parent = rings.parent >= 0
    length = np.linalg.norm(rings.middle - rings.middle[rings.parent], axis=1)
    length[~has_parent] = 0.0
    reach = np.zeros(len(order))  # length from the parent of each ring to the farthest end
    first = np.full(len(order), -1)  # the next ring on the path to that end
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
    """An order (R,) of the rings in which each comes after its parent."""
    depth = np.where(parent < 0, 0, -1)
    while (depth < 0).any():
        now = (depth < 0) & (depth[parent] >= 0)
        depth[now] = depth[parent[now]] + 1
    return np.argsort(depth, kind="stable")
