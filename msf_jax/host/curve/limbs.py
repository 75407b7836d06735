"""Which branches of a curve are limbs of the solid: a limb's length over its own half width across, its slenderness.

A plane across a branch cuts the solid in a section. The half width w of the limb is half of the section's largest
extent: the radius of a tube, or half the width of an ear or a blade of any thickness. A section that another part of
the curve passes through belongs to a shared limb or sheet, and is no evidence for a limb of its own. So the
*slenderness* of a branch that ends in a leaf is

    max over s of  (integral of w from the end of the limb to s) / (largest w from the end to s)^2,

where the integral takes only sections that no other part of the curve passes through. It is length over half width of a
limb of constant width with the same integral. A cylinder that sticks out by h from a larger body has h / radius, a cone
or a wedge with the angle 2 a at its tip 1 / (2 tan a). A finger has 4 to 8, half a disc on a rim, or half a ball on a
wall, pi / 4, the corner of a square plate 0.6, and the corner of a cube, up to its centre, 0.7. A curve is pruned by
this number alone; the order of nodes breaks ties. Where there is no section, w is the ball's radius; nodes
outside add nothing. If no radius is known, all branches are kept.

It is related to the erosion thickness of a medial axis (Yan, Sykes, Chambers, Letscher, Ju 2016), which compares the
extent of a part of the solid with its thickness. Slenderness compares it with the width, so a sheet is one limb.
"""

import heapq
import itertools
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from msf_jax.host.curve import branch_paths
from msf_jax.host.curve.branches import Branch, core, trace
from msf_jax.host.solid import sections
from msf_jax.host.solid.enclosure import SURE, Enclosure
from msf_jax.host.solid.geometry import PAIRS_AT_ONCE, cross, repeated, unit

LEAST_SHARE = 0.25  # radii at the junction: least length of a limb; anything shorter is noise of the surface
CHORD = 1.0  # radii before and after a node: ends of the chord that is the normal of its section
AHEAD = 4.0  # radii: length of the rays that search for the surface
AT_ONCE = 500  # nodes whose sections are cut together: bounds memory


class Limbs(NamedTuple):
    """Measures of the solid at the nodes of a curve.

    radius: (N,) of the largest ball. width: (N,) half of the section's largest extent; NaN if no section goes around
    the node, or none was asked for. ahead: (N,) distance from a leaf to the surface along its branch, 0 for other
    nodes. node, edge: (k,) pairs of a node and an edge that passes through its section.
    """

    radius: np.ndarray
    width: np.ndarray
    ahead: np.ndarray
    node: np.ndarray
    edge: np.ndarray


def limbs_of(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray, is_whole: bool = False) -> Limbs:
    """Measure the solid ``shape`` around the nodes of the curve ``(vertices (N, 3), edges (E, 2))``.

    Nodes of loops, and between loops, have no width unless ``is_whole``: they are on no branch that ends in a leaf, not
    even after others are pruned.
    """
    num = len(vertices)
    radius, near = shape.approximate_clearance(vertices)
    degree = np.bincount(np.unique(np.sort(edges, axis=1), axis=0).ravel(), minlength=num)
    paths = branch_paths.paths_of(vertices, edges, np.zeros(num, dtype=bool))
    width, ahead, pairs = np.full(num, np.nan), np.zeros(num), np.empty((2, 0), dtype=np.int64)
    if not paths:
        return Limbs(radius, width, ahead, *pairs)
    along = unit(branch_paths.chords(vertices, paths, CHORD * radius) @ vertices)
    has_section = (degree > 0) & (degree < 3) & (radius > 0) & along.any(axis=1)
    is_limb = has_section & ~core(num, edges)

    def cut(asked: np.ndarray, along: np.ndarray) -> np.ndarray:
        found = [np.empty((2, 0), dtype=np.int64)]
        for some in np.array_split(asked, max(1, -(-len(asked) // AT_ONCE))):
            width[some], row, edge = _across(
                shape, vertices, edges, some, along[some], radius[some], near[some], is_limb
            )
            found.append(np.stack([some[row], edge]))
        return np.concatenate(found, axis=1)

    pairs = cut(np.flatnonzero(has_section if is_whole else is_limb), along)
    # In a sheet the curve bends within a width, and sections are askew: now across chords as long as it is wide.
    first, is_sheet = width.copy(), is_limb & (width > branch_paths.WIDE * radius)
    if is_sheet.any():
        longer = unit(branch_paths.chords(vertices, paths, np.fmax(CHORD * radius, width)) @ vertices)
        again = cut(np.flatnonzero(is_sheet), longer)
        is_better = is_sheet & ~np.isnan(width)
        width = np.where(is_better, width, first)
        pairs = np.concatenate([pairs[:, ~is_better[pairs[0]]], again[:, is_better[again[0]]]], axis=1)
    onward = np.zeros((num, 1))  # sign of the outward direction: at the first node the chord points inward
    for path in paths:
        onward[path.nodes[0]], onward[path.nodes[-1]] = -1.0, 1.0
    leaf = np.flatnonzero((degree == 1) & has_section)
    ahead[leaf] = shape.ray_lengths(vertices[leaf], onward[leaf] * along[leaf], AHEAD * radius[leaf])
    return Limbs(radius, width, ahead, *pairs)


def _across(
    shape: Enclosure,
    vertices: np.ndarray,
    edges: np.ndarray,
    some: np.ndarray,
    normal: np.ndarray,
    radius: np.ndarray,
    near: np.ndarray,
    is_limb: np.ndarray,
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Half widths (P,) of the sections at the nodes ``some`` (P,), across ``normal`` (P, 3); NaN without one. And pairs
    of a row of ``some`` and an edge of the curve that passes through its section, for nodes of ``is_limb`` (N,)."""
    x, ends, width = vertices[some], vertices[edges], np.full(len(some), np.nan)
    corners = _outer(shape, x, normal, radius, near)
    found, place = sections.measured(shape, x, normal, corners), _places(shape, corners)
    extent = np.zeros(len(some))
    np.maximum.at(extent, corners.loop, np.linalg.norm(place - found.centroid[corners.loop], axis=1))
    width[found.is_around] = extent[found.is_around]
    is_open = np.bincount(corners.loop, minlength=len(some)) == 0  # in its plane no wall is near
    width[is_open] = sections.FARTHEST * radius[is_open]
    # Edges of the curve in a section: those that cross its plane within its loop.
    rows = np.flatnonzero(found.is_around & is_limb[some])
    height = normal[rows] @ vertices.T - np.einsum("ni,ni->n", normal[rows], x[rows])[:, None]
    is_up = height >= 0
    row, edge = np.nonzero(is_up[:, edges[:, 0]] != is_up[:, edges[:, 1]])
    share = height[row, edges[edge, 0]] / (height[row, edges[edge, 0]] - height[row, edges[edge, 1]])
    row = rows[row]
    point = ends[edge, 0] + share[:, None] * (ends[edge, 1] - ends[edge, 0])
    is_near = np.linalg.norm(point - found.centroid[row], axis=1) < extent[row]
    row, edge, point = row[is_near], edge[is_near], (point - x[row])[is_near]
    is_in = np.linalg.norm(point, axis=1) < SURE * radius[row]  # within the node's ball; else the loop tells
    left = ~is_in
    is_in[left] = _within(point[left], row[left], normal, corners.loop, place - x[corners.loop])
    return width, row[is_in], edge[is_in]


def limbs_without(vertices: np.ndarray, edges: np.ndarray, radii: np.ndarray) -> Limbs:
    """`Limbs` for a curve without its solid: every section is a disc of its node's radius, if that is known."""
    radii = radii if (radii > 0).any() else np.full(len(radii), np.nan)
    nothing = np.empty(0, dtype=np.int64)
    degree = np.bincount(edges.ravel(), minlength=len(vertices))
    return Limbs(radii, np.where(degree < 3, radii, np.nan), np.where(degree == 1, radii, 0.0), nothing, nothing)


def _places(shape: Enclosure, corners: sections.Corners) -> np.ndarray:
    """Coordinates of the corners (C, 3)."""
    share = corners.part[:, None]
    return (1 - share) * shape.vertices[corners.tail] + share * shape.vertices[corners.head]


def _outer(
    shape: Enclosure, x: np.ndarray, normal: np.ndarray, radius: np.ndarray, near: np.ndarray
) -> sections.Corners:
    """The outer loops of the sections at nodes ``x`` (P, 3). Where `sections.corners` finds the loop of a bore, the ray
    from the bore through the node leads to the outer loop."""
    found = sections.corners(shape, x, normal, radius, near)
    hole = np.flatnonzero(found.is_closed & ~sections.measured(shape, x, normal, found).is_found)
    if not len(hole):
        return found
    away = _places(shape, found) - x[found.loop]
    order = np.lexsort((np.einsum("ci,ci->c", away, away), found.loop))
    nearest = order[np.searchsorted(found.loop, hole)]
    onward = unit(-away[nearest])
    across = np.full(len(hole), np.linalg.norm(np.ptp(shape.vertices, axis=0)))  # near a wall, a ball is no measure
    there = x[hole] + shape.ray_lengths(x[hole], onward, across)[:, None] * onward
    again = sections.corners(shape, x[hole], normal[hole], radius[hole], shape.approximate_closest(there)[1])
    stays = ~np.isin(found.loop, hole)
    loop = np.concatenate([found.loop[stays], hole[again.loop]])
    order = np.argsort(loop, kind="stable")
    found.is_closed[hole] = again.is_closed
    tail, head, part, triangle = (
        np.concatenate([one[stays], other])[order] for one, other in zip(found[1:5], again[1:5], strict=True)
    )
    return sections.Corners(loop[order], tail, head, part, triangle, found.is_closed)


def _within(point: np.ndarray, row: np.ndarray, normal: np.ndarray, loop: np.ndarray, place: np.ndarray) -> np.ndarray:
    """(k,) whether each ``point`` (k, 3) in the plane of section ``row`` (k,) is within its loop: by the sum of angles.

    ``loop`` (C,) is the section of each corner, and ``place`` (C, 3) its coordinates. These and points are relative to
    the section's node.
    """
    size = np.bincount(loop, minlength=len(normal))
    first = np.cumsum(size) - size
    turn = np.zeros(len(row))
    batch = np.cumsum(size[row]) // PAIRS_AT_ONCE
    for number in np.unique(batch):
        some = np.flatnonzero(batch == number)
        pair, step = repeated(size[row[some]])
        at = row[some[pair]]
        here = place[first[at] + step] - point[some[pair]]
        onward = place[first[at] + (step + 1) % size[at]] - point[some[pair]]
        angle = np.arctan2(np.einsum("ki,ki->k", cross(here, onward), normal[at]), np.einsum("ki,ki->k", here, onward))
        turn[some] = np.bincount(pair, weights=angle, minlength=len(some))
    return turn > np.pi


class Pruning:
    """The branches of a curve while the least slender are removed.

    The edges of a branch are a set of a union-find structure, so two branches of any length are joined in constant
    time. A branch is followed only until its slenderness is known to be enough.

    Args:
        vertices, edges: of the curve, (N, 3) and (E, 2); a duplicate edge counts once.
        limbs: measures of the solid at the nodes.
    """

    def __init__(self, vertices: np.ndarray, edges: np.ndarray, limbs: Limbs):
        self._length = np.linalg.norm(vertices[edges[:, 0]] - vertices[edges[:, 1]], axis=1).tolist()
        self._width = np.where(np.isnan(limbs.width), limbs.radius, limbs.width).tolist()
        self._radius = limbs.radius.tolist()
        self._ahead = limbs.ahead.tolist()
        self._beside: list[dict[int, int]] = [{} for _ in range(len(vertices))]  # neighbour: edge
        pairs = edges.tolist()
        for edge, (a, b) in enumerate(pairs):
            self._beside[a][b] = self._beside[b][a] = self._beside[a].get(b, edge)
        self._through: dict[int, set[int]] = {}  # node: edges that pass through its section
        self._sections: dict[int, list[int]] = {}  # edge: nodes whose sections it passes through
        for node, twin in zip(limbs.node.tolist(), limbs.edge.tolist(), strict=True):
            edge = self._beside[pairs[twin][0]][pairs[twin][1]]
            self._through.setdefault(node, set()).add(edge)
            self._sections.setdefault(edge, []).append(node)
        self._above = list(range(len(pairs)))  # parent of each edge in the union-find tree; a root stands for a branch
        self._ends = pairs  # the two end nodes of each root's branch; none for a loop without a junction
        for node, beside in enumerate(self._beside):
            if len(beside) == 2:
                self._join(node)

    def leaves(self) -> list[int]:
        """Nodes with one edge."""
        return [node for node, beside in enumerate(self._beside) if len(beside) == 1]

    def branch(self, leaf: int) -> list[int]:
        """The nodes from ``leaf`` to the end of its branch: a junction or another leaf."""
        return [leaf, *(node for node, _ in self._walk(leaf))]

    def slenderness(self, leaf: int, enough: float = np.inf) -> float:
        """Of the branch that ends in ``leaf``, or some value of at least ``enough``; infinite without a junction."""
        own = self._branch_of(leaf)
        junction = next((end for end in self._ends[own] if len(self._beside[end]) > 2), None)
        if junction is None:
            return np.inf
        least = LEAST_SHARE * self._radius[junction]
        most, length, width = -np.inf, self._ahead[leaf], self._width[leaf]
        area, rise, last_step, last = length * width / 2, width / length if length else 0.0, 0.0, width
        cells = itertools.chain(self._cells(leaf, junction), [(junction, 0.0, np.inf)])
        for (node, step, here), (_, _, after) in itertools.pairwise(cells):
            if all(self._branch_at(other) == own for other in self._through.get(node, ())):
                length, area = length + (last_step + step) / 2, area + (last_step + step) / 2 * here
            # A cell ends at the middle of an edge: the width there follows the slope so far, up to the nodes' mean.
            rise = (here - last) / last_step if last_step else rise
            width = max(width, here, min(here + rise * step / 2, (here + after) / 2))
            if length >= least and width > 0:
                most = max(most, area / width**2)
                if most >= enough:
                    break
            last_step, last = step, here
        return most if most >= 0 else np.inf if np.isnan(width) else 0.0

    def take_away(self, leaf: int) -> set[int]:
        """Remove the branch of a leaf up to its junction; returns the leaves whose slenderness may have changed."""
        touched, nodes = set(), self.branch(leaf)
        for a, b in itertools.pairwise(nodes):
            edge = self._beside[a].pop(b)
            self._beside[b].pop(a)
            for node in self._sections.get(edge, ()):
                self._through[node].discard(edge)
                touched.add(node)
        if len(self._beside[nodes[-1]]) == 2:
            self._join(nodes[-1])
            touched.add(nodes[-1])
        found = {self._branch_of(node) for node in touched if 0 < len(self._beside[node]) < 3}
        return {end for branch in found for end in self._ends[branch] if len(self._beside[end]) == 1}

    def _cells(self, leaf: int, junction: int) -> Iterator[tuple[int, float, float]]:
        """For each node from ``leaf`` to before the junction: the node, the length of its next edge, its half width.

        A width that stands out at a single node is a section cut askew; a median of three removes it.
        """
        node, before = leaf, self._width[leaf]
        for onward, edge in self._walk(leaf):
            here = self._width[node]
            after = here if onward == junction else self._width[onward]
            yield node, self._length[edge], sorted((before, here, after))[1]
            node, before = onward, here

    def _walk(self, leaf: int) -> Iterator[tuple[int, int]]:
        """The nodes after ``leaf`` on its branch, each with the edge before it."""
        node, last = leaf, -1
        while True:
            onward, edge = next(each for each in self._beside[node].items() if each[1] != last)
            yield onward, edge
            if len(self._beside[onward]) != 2:
                return
            node, last = onward, edge

    def _branch_of(self, node: int) -> int:
        """The root edge of the branch of a node with one or two edges."""
        return self._branch_at(next(iter(self._beside[node].values())))

    def _branch_at(self, edge: int) -> int:
        """The root edge of the branch of ``edge``."""
        above = self._above
        while above[edge] != edge:
            above[edge] = above[above[edge]]
            edge = above[edge]
        return edge

    def _join(self, node: int) -> None:
        """Join the two branches that meet at a ``node`` with two edges."""
        one, other = (self._branch_at(edge) for edge in self._beside[node].values())
        ends = [end for branch in {one, other} for end in self._ends[branch] if end != node]
        self._above[one], self._ends[other] = other, ends


def measure(vertices: np.ndarray, edges: np.ndarray, limbs: Limbs, share: np.ndarray | None = None) -> list[Branch]:
    """The branches of a curve ``(vertices (N, 3), edges (E, 2))``; ``share`` (N,) of the mesh's area by node."""
    pruning = Pruning(vertices, edges, limbs)
    degree, found = np.bincount(np.unique(np.sort(edges, axis=1), axis=0).ravel(), minlength=len(vertices)), []
    for nodes in trace(len(vertices), edges):
        length = float(np.linalg.norm(np.diff(vertices[nodes], axis=0), axis=1).sum())
        own = np.array(sorted({node for node in nodes if degree[node] < 3}), dtype=np.int64)
        leaf = next((node for node in (nodes[0], nodes[-1]) if degree[node] == 1), None)
        slenderness = np.inf if leaf is None else pruning.slenderness(leaf)
        found.append(Branch(nodes, length, slenderness, np.nan if share is None else float(share[own].sum())))
    return found


def prune(
    vertices: np.ndarray, edges: np.ndarray, limbs: Limbs, least: float, is_held: np.ndarray | None = None
) -> tuple[np.ndarray, np.ndarray]:
    """Remove branches with a slenderness below ``least``, the least slender first, until none is left.

    After each removal the affected branches are measured again: two branches that remain at a junction become one, and
    sections lose the removed branch. A branch with a node of ``is_held`` (N,) besides its junction stays. Returns which
    nodes stay (N,), and the target of each node (N,): itself, or the junction that its branch began at.
    """
    stays, target = np.ones(len(vertices), dtype=bool), np.arange(len(vertices))
    held = set() if is_held is None else set(np.flatnonzero(is_held).tolist())
    pruning = Pruning(vertices, edges, limbs)
    known: dict[int, float] = {}
    queue: list[tuple[float, int]] = []

    def measure_branch(leaf: int) -> None:
        known[leaf] = pruning.slenderness(leaf, least)
        if known[leaf] < least:
            if held.isdisjoint(pruning.branch(leaf)[:-1]):
                heapq.heappush(queue, (known[leaf], leaf))
            else:
                known[leaf] = np.inf

    for leaf in pruning.leaves():
        measure_branch(leaf)
    while queue:
        value, leaf = heapq.heappop(queue)
        if known.get(leaf) != value:
            continue
        nodes = pruning.branch(leaf)
        del known[leaf]
        stays[nodes[:-1]] = False
        target[nodes[:-1]] = nodes[-1]
        for other in pruning.take_away(leaf):
            measure_branch(other)
    while (target != target[target]).any():
        target = target[target]
    return stays, target
