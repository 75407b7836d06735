"""Which branches of a curve are limbs of the solid: how far each reaches out, over its own half width across.

A plane across a branch cuts the solid in a section, and half of the section's largest extent is how wide the limb is
there: the radius of a tube, half the width of an ear or a blade, however thin those are. Where the section holds another
part of the curve, the two are in one limb or in one sheet, and that place says nothing for a limb of its own. So the
*slenderness* of a branch that ends in a leaf is

    max over s of  (own length from the end of the limb to s) / (largest half width from the end to s),

where own length counts only places whose section holds nothing else of the curve. A finger has 4 to 8, a cylinder that
sticks out by h from a larger body h / radius, a cone with half an angle a at its tip 1 / tan a, a corner of a cube 0.8,
of a flat plate 1. All branches are kept or pruned by that one number; of equal ones the order of nodes decides.

It is related to the erosion thickness of a medial axis (Yan, Sykes, Chambers, Letscher, Ju 2016), which tells how far a
part of the solid reaches against its thickness; here it is against its width, so that a sheet is one limb.
"""

import heapq
from typing import NamedTuple

import numpy as np
from scipy import spatial

from msf_jax.host.curve import ways
from msf_jax.host.solid import sections
from msf_jax.host.solid.enclosure import Enclosure
from msf_jax.host.solid.geometry import repeated, unit

LEAST_SHARE = 0.25  # of the ball at its junction, that a limb reaches out at least: less is roughness of the surface
CHORD = 1.0  # radii, before and behind a node, between which its branch gives the direction across which it is cut
MOST_NODES = 4_000  # of a curve, whose sections are cut; of a longer one every second, third, ... node's


class Limbs(NamedTuple):
    """What a solid says of the nodes of a curve.

    radius: (N,) of the largest ball. width: (N,) half of the section's largest extent; NaN where there is no section
    around the node. ahead: (N,) from a leaf onward to the surface, 0 for other nodes. node, edge: (k,) pairs of a node
    and an edge that goes through its section.
    """

    radius: np.ndarray
    width: np.ndarray
    ahead: np.ndarray
    node: np.ndarray
    edge: np.ndarray


def limbs_of(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray) -> Limbs:
    """Measure the solid ``shape`` around the nodes of the curve ``(vertices (N, 3), edges (E, 2))``."""
    num = len(vertices)
    radius, near = shape.about_clearance(vertices)
    degree = np.bincount(edges.ravel(), minlength=num)
    paths = ways.ways_of(vertices, edges, np.zeros(num, dtype=bool))
    width, ahead = np.full(num, np.nan), np.zeros(num)
    nothing = np.empty(0, dtype=np.int64)
    if not paths:
        return Limbs(radius, width, ahead, nothing, nothing)
    along = unit(ways.chords(vertices, paths, CHORD * radius) @ vertices)
    leaf = np.flatnonzero((degree == 1) & (radius > 0))
    if len(leaf):
        beside = np.zeros(num, dtype=np.int64)
        beside[edges[:, 0]], beside[edges[:, 1]] = edges[:, 1], edges[:, 0]
        outward = unit(
            along[leaf] * np.sign(np.einsum("ni,ni->n", along[leaf], vertices[leaf] - vertices[beside[leaf]]))[:, None]
        )
        ahead[leaf] = shape.ray_lengths(vertices[leaf], outward, 4 * radius[leaf])
    asked = np.flatnonzero((degree > 0) & (degree < 3) & (radius > 0) & along.any(axis=1))
    asked = asked[:: max(1, -(-len(asked) // MOST_NODES))]
    x, normal = vertices[asked], along[asked]
    corners = sections.corners(shape, x, normal, radius[asked], near[asked])
    found = sections.measured(shape, x, normal, corners)
    place = _places(shape, corners) - found.centroid[corners.loop]
    extent = np.zeros(len(asked))
    np.maximum.at(extent, corners.loop, np.linalg.norm(place, axis=1))
    width[asked[found.is_around]] = extent[found.is_around]
    # What of the curve is in a section: where an edge goes through its plane, within its loop.
    rows = np.flatnonzero(found.is_around)
    middle = (vertices[edges[:, 0]] + vertices[edges[:, 1]]) / 2
    reach = extent[rows] + np.linalg.norm(vertices[edges[:, 0]] - vertices[edges[:, 1]], axis=1).max(initial=0.0) / 2
    close = spatial.KDTree(middle).query_ball_point(found.centroid[rows], reach)
    count = np.fromiter(map(len, close), np.int64, len(close))
    row, edge = np.repeat(rows, count), np.concatenate([*close, np.empty(0)]).astype(np.int64)
    a, b = (vertices[edges[edge, side]] - x[row] for side in (0, 1))
    height, height_of_b = (np.einsum("ki,ki->k", end, normal[row]) for end in (a, b))
    is_cut = (height >= 0) != (height_of_b >= 0)
    row, edge, a, b, height, height_of_b = (each[is_cut] for each in (row, edge, a, b, height, height_of_b))
    point = a + (height / (height - height_of_b))[:, None] * (b - a)
    is_in = _within(point, row, normal, corners, _places(shape, corners) - x[corners.loop])
    return Limbs(radius, width, ahead, asked[row[is_in]], edge[is_in])


def limbs_without(vertices: np.ndarray, edges: np.ndarray, radii: np.ndarray) -> Limbs:
    """The same for a curve whose solid is not known: every section is a disc of its node's radius."""
    nothing = np.empty(0, dtype=np.int64)
    degree = np.bincount(edges.ravel(), minlength=len(vertices))
    return Limbs(radii, np.where(degree < 3, radii, np.nan), np.where(degree == 1, radii, 0.0), nothing, nothing)


def _places(shape: Enclosure, corners: sections.Corners) -> np.ndarray:
    """Where the corners are (C, 3)."""
    part = corners.part[:, None]
    return (1 - part) * shape.vertices[corners.tail] + part * shape.vertices[corners.head]


def _within(
    point: np.ndarray, row: np.ndarray, normal: np.ndarray, corners: sections.Corners, place: np.ndarray
) -> np.ndarray:
    """(k,) whether each ``point`` (k, 3) of the plane of section ``row`` (k,) is within its loop: by the sum of angles.

    Points and the corners' ``place`` (C, 3) are from the section's node on.
    """
    size = np.bincount(corners.loop, minlength=len(normal))
    first = np.cumsum(size) - size
    pair, step = repeated(size[row])
    here = place[first[row[pair]] + step] - point[pair]
    onward = place[first[row[pair]] + (step + 1) % size[row[pair]]] - point[pair]
    turn = np.arctan2(
        np.einsum("ki,ki->k", np.cross(here, onward), normal[row[pair]]), np.einsum("ki,ki->k", here, onward)
    )
    return np.bincount(pair, weights=turn, minlength=len(row)) > np.pi


class Pruning:
    """The branches of a curve while the least slender are taken away.

    Args:
        vertices, edges: of the curve, (N, 3) and (E, 2).
        limbs: what the solid says of its nodes.
    """

    def __init__(self, vertices: np.ndarray, edges: np.ndarray, limbs: Limbs):
        self._limbs = limbs
        self._length = np.linalg.norm(vertices[edges[:, 0]] - vertices[edges[:, 1]], axis=1).tolist()
        self._beside: list[dict[int, int]] = [{} for _ in range(len(vertices))]  # neighbour: edge
        for edge, (a, b) in enumerate(edges.tolist()):
            self._beside[a][b] = self._beside[b][a] = edge
        self._through: dict[int, set[int]] = {}  # node: edges that go through its section
        self._sections: dict[int, list[int]] = {}  # edge: nodes whose sections it goes through
        for node, edge in zip(limbs.node.tolist(), limbs.edge.tolist(), strict=True):
            self._through.setdefault(node, set()).add(edge)
            self._sections.setdefault(edge, []).append(node)
        self._width = np.nan_to_num(limbs.width).tolist()
        self._radius = limbs.radius.tolist()
        self._ahead = limbs.ahead.tolist()

    def leaves(self) -> list[int]:
        """Nodes with one edge."""
        return [node for node, beside in enumerate(self._beside) if len(beside) == 1]

    def branch(self, leaf: int) -> list[int]:
        """The nodes from ``leaf`` to where its branch ends: a junction, or another leaf."""
        nodes, before = [leaf], -1
        while True:
            onward = [node for node in self._beside[nodes[-1]] if node != before]
            before = nodes[-1]
            nodes.append(onward[0])
            if len(self._beside[nodes[-1]]) != 2:
                return nodes

    def slenderness(self, nodes: list[int]) -> float:
        """Of the branch from a leaf on; infinite if it does not end in a junction."""
        if len(self._beside[nodes[-1]]) < 3:
            return np.inf
        own = {self._beside[a][b] for a, b in zip(nodes[:-1], nodes[1:], strict=True)}
        half = [self._length[self._beside[a][b]] / 2 for a, b in zip(nodes[:-1], nodes[1:], strict=True)]
        length, width, most = self._ahead[nodes[0]], 0.0, 0.0
        least = LEAST_SHARE * self._radius[nodes[-1]]
        for place, node in enumerate(nodes[:-1]):
            width = max(width, self._width[node] or self._radius[node])
            if self._through.get(node, own) <= own:
                length += half[place] + (half[place - 1] if place else 0.0)
            if length >= least:
                most = max(most, length / max(width, 1e-300))
        return most

    def take_away(self, nodes: list[int]) -> set[int]:
        """Take a branch away, but for its junction; the leaves whose slenderness may be another now."""
        touched = {nodes[-1]}
        for a, b in zip(nodes[:-1], nodes[1:], strict=True):
            edge = self._beside[a].pop(b)
            self._beside[b].pop(a)
            for node in self._sections.get(edge, ()):
                self._through[node].discard(edge)
                touched.add(node)
        return {leaf for node in touched for leaf in self._ends(node)}

    def _ends(self, node: int) -> list[int]:
        """The leaves of the branch that a node is in, none if it has none."""
        if not 0 < len(self._beside[node]) < 3:
            return []
        found = []
        for start in self._beside[node]:
            here, before = start, node
            while len(self._beside[here]) == 2 and here != node:
                here, before = next(other for other in self._beside[here] if other != before), here
            if len(self._beside[here]) == 1:
                found.append(here)
        return [*found, *([node] if len(self._beside[node]) == 1 else [])]


def slendernesses(vertices: np.ndarray, edges: np.ndarray, limbs: Limbs) -> dict[int, float]:
    """The slenderness of the branch of each leaf."""
    pruning = Pruning(vertices, edges, limbs)
    return {leaf: pruning.slenderness(pruning.branch(leaf)) for leaf in pruning.leaves()}


def prune(
    vertices: np.ndarray, edges: np.ndarray, limbs: Limbs, least: float, is_held: np.ndarray | None = None
) -> tuple[np.ndarray, np.ndarray]:
    """Take away branches of a slenderness below ``least``, the least slender first, until none is left.

    Each time those that it bears on are measured again: where two branches remain at a junction they become one, and a
    section that held the branch is free. A branch with a node of ``is_held`` (N,) beyond its junction stays. Returns
    which nodes stay (N,), and the node that each goes to (N,): itself, or the junction that its branch grew out of.
    """
    stays, target = np.ones(len(vertices), dtype=bool), np.arange(len(vertices))
    held = set() if is_held is None else set(np.flatnonzero(is_held).tolist())
    pruning = Pruning(vertices, edges, limbs)
    known: dict[int, float] = {}
    queue: list[tuple[float, int]] = []

    def look(leaf: int) -> None:
        nodes = pruning.branch(leaf)
        known[leaf] = np.inf if held.intersection(nodes[:-1]) else pruning.slenderness(nodes)
        if known[leaf] < least:
            heapq.heappush(queue, (known[leaf], leaf))

    for leaf in pruning.leaves():
        look(leaf)
    while queue:
        value, leaf = heapq.heappop(queue)
        if known.get(leaf) != value:
            continue
        nodes = pruning.branch(leaf)
        del known[leaf]
        stays[nodes[:-1]] = False
        target[nodes[:-1]] = nodes[-1]
        for other in pruning.take_away(nodes):
            look(other)
    while (target != target[target]).any():
        target = target[target]
    return stays, target
