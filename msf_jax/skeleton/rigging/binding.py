"""Smooth skinning weights, by heat diffusion over the surface.

As in Pinocchio (Baran and Popovic 2007) and in Blender's automatic weights, the weights w_b of bone b are the heat in
equilibrium

    (L + H) w_b = H p_b,    H = M / d^2,

with L the cotangent Laplacian, M the areas of vertices, and d the distance of a vertex from the curve. In Pinocchio p_b
is 1 where b is the nearest visible bone. Here it is 1 at vertices that the flow maps to b's part of the curve, so that
an arm that touches a leg keeps its own bones. One factorisation serves all bones of a round. Weights sum to 1 as p
does, and none is negative. If an edge still stretches too much when a bone turns, d is increased around it, and the
weights are computed again.
"""

import copy
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from scipy import sparse
from scipy.sparse import csgraph

from msf_jax.numerics.factors import surface_factor
from msf_jax.solid.geometry import cross, repeated

ANGLE = np.radians(40.0)  # radians: the turn of a bone at which the stretch of edges is tested
STRETCH = 1.9  # ratio of an edge's length after that turn to its length at rest: larger ones need another round
HEAT_REACH = 1.3  # ratio of d to the distance from the curve
LOOSER = 1.5  # factor on d in each round, where edges stretch too much
LARGEST_T = 0.45  # largest t of `fewest`, below 1/2; a share of a row's sum
LEAST = 1e-6  # weights below this count as 0
LARGEST_COTANGENT = 1e4  # bound on cotangents of angles


class Tree(NamedTuple):
    """A tree of bones. order: (B,) all bones, parents first. parents: (B,) -1 for a root."""

    order: np.ndarray
    parents: np.ndarray


class Heat:
    """The surface for heat diffusion. Coincident vertices count as one.

    Args:
        vertices: (V, 3), finite. faces: (F, 3). away: (V,) distance from the curve, above 0.
    """

    def __init__(self, vertices: np.ndarray, faces: np.ndarray, away: np.ndarray):
        self.points, self.of_given = np.unique(vertices, axis=0, return_inverse=True)
        self.of_given = self.of_given.ravel()
        num = len(self.points)
        corners = self.of_given[faces]
        corner = self.points[corners]
        weight, ends = [], []
        for k in range(3):
            u, v = corner[:, (k + 1) % 3] - corner[:, k], corner[:, (k + 2) % 3] - corner[:, k]
            sine = np.linalg.norm(cross(u, v), axis=1)
            cotangent = np.einsum("ij,ij->i", u, v) / np.maximum(sine, 1e-300)
            weight.append(np.clip(cotangent, -LARGEST_COTANGENT, LARGEST_COTANGENT) / 2)
            ends.append(corners[:, [(k + 1) % 3, (k + 2) % 3]])
        pair, value = np.concatenate(ends), np.concatenate(weight)
        is_edge = pair[:, 0] != pair[:, 1]
        pair, value = pair[is_edge], value[is_edge]
        half = sparse.coo_matrix((value, pair.T), shape=(num, num))
        joined: sparse.csr_matrix = (half + half.T).tocsr()
        self.laplacian = sparse.diags(np.asarray(joined.sum(axis=1)).ravel()) - joined
        self.edges = np.unique(np.sort(pair, axis=1), axis=0)
        area = np.bincount(
            corners.ravel(),
            np.repeat(np.linalg.norm(cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]), axis=1) / 6, 3),
            num,
        )
        self.area = np.maximum(area, 1e-6 * area.mean())
        count = np.bincount(self.of_given, minlength=num)
        self.away = HEAT_REACH * np.bincount(self.of_given, away, num) / count
        self._factor: Any = None

    def spread(self, bone: np.ndarray, num_bones: int) -> np.ndarray:
        """(n, B) weights at the points of the surface, for vertices that belong to the bones ``bone`` (V,)."""
        num = len(self.points)
        share = sparse.coo_matrix((np.ones(len(bone)), (self.of_given, bone)), shape=(num, num_bones)).toarray()
        share /= share.sum(axis=1, keepdims=True)
        found = np.maximum(self._balance(share), 0.0)
        return found / found.sum(axis=1, keepdims=True)

    def loosen(self, is_tight: np.ndarray) -> None:
        """Increase d around the points ``is_tight`` (n,), where the surface stretches too much."""
        near = np.maximum(self._balance(is_tight.astype(float)[:, None])[:, 0], 0.0)
        self.away = self.away * (1 + (LOOSER - 1) * near / near.max())
        self._factor = None

    def _balance(self, source: np.ndarray) -> np.ndarray:
        """The w (n, k) with (L + H) w = H ``source`` (n, k)."""
        pull = self.area / self.away**2
        if self._factor is None:
            self._factor = surface_factor((self.laplacian + sparse.diags(pull)).tocsc())
        return self._factor.solve(np.asfortranarray(pull[:, None] * source))


class SkinBinding(NamedTuple):
    """What weights are made of, to make them anew when a joint has moved.

    bone: (V,) of each vertex. places: (V, 3) on the curve. influences: the largest number of bones of a vertex.
    """

    heat: Heat
    bone: np.ndarray
    places: np.ndarray
    influences: int

    def weights(self, joints: np.ndarray, parents: np.ndarray) -> sparse.csr_matrix:
        """(V, B) the weights for bones with these ``joints`` (B, 3) and ``parents`` (B,)."""
        return sparse.csr_matrix(bound(self.heat, self.bone, joints, parents, self.influences))


def bound(heat: Heat, bone: np.ndarray, joints: np.ndarray, parents: np.ndarray, influences: int) -> np.ndarray:
    """(V, B) weights of the vertices of ``heat``; each row sums to 1, and has at most ``influences`` above 0."""
    heat = copy.copy(heat)  # `loosen` changes it
    best, least, own = np.empty(0), np.inf, Tree(np.arange(len(parents)), parents)
    while True:
        spread = heat.spread(bone, len(joints))
        is_tight = np.zeros(len(heat.points), dtype=bool)
        for weights in candidates(spread, own, influences):
            stretched = stretch(heat.points, heat.edges, joints, own, weights)
            worst = float(stretched.max(initial=1.0))
            if worst < least:
                best, least = weights, worst
                is_tight[:] = False
                is_tight[heat.edges[stretched > STRETCH]] = True
            if least <= STRETCH:
                return best[heat.of_given]
        if not is_tight.any():  # this round was no better than earlier ones
            return best[heat.of_given]
        heat.loosen(is_tight)


def fewest(weights: np.ndarray, tree: Tree, most: int) -> np.ndarray:
    """Reduce each row of ``weights`` (n, B) to at most ``most`` values with sum 1, still smooth over the surface.

    Each bone but a root represents the edge to its parent in ``tree``. This edge splits the sum of a row into c, for
    the bone and its descendants, and 1 - c. With t the ``most``-th largest of all min(c, 1 - c), c becomes
    (c - t) / (1 - 2 t), clipped to 0 and 1. Fewer than ``most`` edges have c between t and 1 - t, and these are
    connected, so at most ``most`` bones remain. No weight jumps over the surface, as it would if the smallest were set
    to 0.
    """
    num = weights.shape[1]
    if most == 1:
        return (np.arange(num) == weights.argmax(axis=1)[:, None]).astype(float)
    if num <= most:
        return weights
    beyond = carried(weights, tree)
    smaller = np.minimum(beyond, 1 - beyond)
    t = np.minimum(-np.partition(-smaller, most - 1, axis=1)[:, most - 1 : most], LARGEST_T)
    beyond = np.clip((beyond - t) / (1 - 2 * t), 0.0, 1.0)
    found = beyond.copy()
    for bone, parent in enumerate(tree.parents):
        if parent >= 0:
            found[:, parent] -= beyond[:, bone]
    found = np.where(found > LEAST, found, 0.0)
    found = np.where(found >= -np.partition(-found, most - 1, axis=1)[:, most - 1 : most], found, 0.0)  # rounding
    return found / found.sum(axis=1, keepdims=True)


def lowered(weights: np.ndarray, most: int) -> np.ndarray:
    """Reduce each row (n, B) to at most ``most`` weights with sum 1: subtract the largest weight that is left out.

    It needs no tree of bones, and a tree cannot follow the loops of a surface. Weights stay continuous here, too, but
    they change quickly where many of them are similar.
    """
    if weights.shape[1] <= most:
        return weights
    found = np.maximum(weights + np.partition(-weights, most, axis=1)[:, most : most + 1], 0.0)
    found = np.where(found > LEAST, found, 0.0)
    is_even = np.logical_not(found.any(axis=1))
    found[is_even, weights[is_even].argmax(axis=1)] = 1.0
    return found / found.sum(axis=1, keepdims=True)


def candidates(weights: np.ndarray, own: Tree, most: int) -> Iterator[np.ndarray]:
    """Alternative reductions of each row (n, B) to at most ``most`` weights; `bound` takes the least stretched one."""
    yield fewest(weights, own, most)
    yield fewest(weights, by_touch(weights), most)
    yield lowered(weights, most)


def by_touch(weights: np.ndarray) -> Tree:
    """A tree in which bones that share most vertices are neighbours. ``weights`` is (n, B).

    Where a loop was cut, such bones can be far apart in the tree of the rig.
    """
    common = weights.T @ weights
    apart = sparse.csr_matrix(np.where(common > 0, 1 / np.maximum(common, 1e-300), 0.0))
    spanning = csgraph.minimum_spanning_tree(apart)
    order, parents = np.empty(0, dtype=np.int64), np.full(len(common), -1)
    for root in range(len(common)):
        if root not in order:
            found, above = csgraph.breadth_first_order(spanning, root, directed=False)
            order = np.r_[order, found]
            parents[found] = np.maximum(above[found], -1)
    return Tree(order, parents)


def carried(weights: np.ndarray, tree: Tree) -> np.ndarray:
    """(n, B) the sum of the weights (n, B) of each bone and its descendants in ``tree``."""
    found = weights.copy()
    for bone in tree.order[::-1]:
        if tree.parents[bone] >= 0:
            found[:, tree.parents[bone]] += found[:, bone]
    return found


def stretch(points: np.ndarray, edges: np.ndarray, joints: np.ndarray, tree: Tree, weights: np.ndarray) -> np.ndarray:
    """(E,) an upper bound on the ratio by which each edge stretches when one bone turns by `ANGLE` about any axis.

    A bone's descendants turn with it. With s the sum of their weights at a vertex, the vertex moves by at most
    2 sin(angle / 2) s times its distance from the joint. An edge gains at most the difference of that at its ends.
    """
    beyond = np.ascontiguousarray(carried(weights, tree).T)
    a, b = edges.T
    length = np.maximum(np.linalg.norm(points[a] - points[b], axis=1), 1e-12 * np.ptp(points))
    largest = np.ones(len(edges))
    for bone, joint in enumerate(joints):
        change = np.abs(beyond[bone][a] - beyond[bone][b])
        rows = np.flatnonzero(change > LEAST)
        away = np.linalg.norm(points - joint, axis=1)
        gain = change[rows] * np.maximum(away[a[rows]], away[b[rows]]) / length[rows]
        largest[rows] = np.maximum(largest[rows], 1 + 2 * np.sin(ANGLE / 2) * gain)
    return largest


def walked(points: np.ndarray, nodes: np.ndarray, edges: np.ndarray, start: np.ndarray) -> np.ndarray:
    """(P,) a locally nearest node for each of ``points`` (P, 3): from ``start`` (P,), step to nearer neighbours."""
    ends = np.concatenate([edges, edges[:, ::-1]])
    ends = ends[np.argsort(ends[:, 0], kind="stable")]
    count = np.bincount(ends[:, 0], minlength=len(nodes))
    beside = np.repeat(np.arange(len(nodes))[:, None], max(int(count.max(initial=0)), 1), axis=1)
    beside[ends[:, 0], repeated(count)[1]] = ends[:, 1]
    place, active = start.copy(), np.arange(len(points))
    away = np.linalg.norm(points - nodes[start], axis=1)
    while len(active):
        offered = beside[place[active]]
        distance = np.linalg.norm(points[active, None] - nodes[offered], axis=2)
        k = distance.argmin(axis=1)
        nearest = distance[np.arange(len(k)), k]
        is_nearer = nearest < away[active]
        active, chosen = active[is_nearer], offered[np.arange(len(k)), k][is_nearer]
        place[active], away[active] = chosen, nearest[is_nearer]
    return place
