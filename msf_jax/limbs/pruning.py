"""Pruning: the removal of branches that end in leaves, the ones of least worth first.

The solid's surface says which of its parts are limbs, see `limbs.caps`. Of a curve without its solid only the balls of
its nodes are known. Then a branch stands for a tube of radius r(s) at the distance s from its leaf, with a round end.
The tip is r(0) beyond the leaf, at the depth d(s) = s + r(0). As long as the largest ball still touches the tip, the
round end up to that depth has the area A(s) = 2 pi r d (Archimedes); from there on, the integral of 2 pi r ds is added.
The curve that cuts the cap off has the length P(s) = 2 pi r(s), so its slenderness is 2 pi A / P^2 - 1 / 2, as on a
surface. The slenderness of the branch is the largest one outside of the ball at its junction: h / r - 1 / 2 of a tube
with a round end that sticks out by h. A branch in one ball, which holds its leaf and its junction, does not stick out.
"""

import heapq
from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np

from msf_jax.solid.geometry import arc_length
from msf_jax.topology.graphs import trace

TOUCHES = 0.9  # of the depth of a node: least radius of a ball that touches the tip of its limb

Worth = Callable[[Iterator[int]], float]  # of the branch with these nodes, its leaf first


class Branch(NamedTuple):
    """nodes: along the branch; a closed branch repeats its first node at its end. length: of the branch.

    slenderness: of the limb of a branch that ends in a leaf, as large as it can be without another leaf (see
    `limbs.caps`): a cylinder that sticks out by h has h / radius, and half of that if it is less than 0.12 %
    of the surface. Without the mesh, and for thin limbs in coarse triangles, it is measured by the nodes' balls (see
    `by_balls`). Infinite for a branch without a junction or between junctions: its removal would change the
    curve's components or cycles.

    surface: share of the mesh's area that belongs to the branch's nodes, without its junctions; NaN if unknown.
    """

    nodes: list[int]
    length: float
    slenderness: float
    surface: float

    def __repr__(self) -> str:
        ends = f"{self.nodes[0]} to {self.nodes[-1]}"
        numbers = f"length {self.length:.4g}, slenderness {self.slenderness:.3g}"
        return f"Branch({len(self.nodes)} nodes from {ends}, {numbers})"


def prune(
    num_nodes: int, edges: np.ndarray, worth: Worth, least: float, is_held: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Remove branches of a ``worth`` below ``least``, the one of least worth first, until none is left.

    When two branches are left at a junction, they become one, and the ``worth`` of its leaf may rise or fall.
    Components and cycles stay, and branches with a node of ``is_held`` (N,) besides their junction. Returns which nodes
    stay (N,), and the target of each node (N,): itself, or the nearest one that stays, along the branches that went.
    """
    beside: list[set[int]] = [set() for _ in range(num_nodes)]
    for a, b in edges.tolist():
        beside[a].add(b)
        beside[b].add(a)

    def walk(leaf: int) -> Iterator[int]:
        """The nodes from ``leaf`` to the end of its branch: a junction or another leaf."""
        last, node = -1, leaf
        while last < 0 or len(beside[node]) == 2:
            yield node
            last, node = node, next(each for each in sorted(beside[node]) if each != last)
        yield node

    stays, target = np.ones(num_nodes, dtype=bool), np.arange(num_nodes)
    is_done = False
    while not is_done:  # until a round removes nothing, as worths may have fallen
        is_done = True
        queue = [(worth(walk(leaf)), leaf) for leaf in range(num_nodes) if stays[leaf] and len(beside[leaf]) == 1]
        heapq.heapify(queue)
        while queue and queue[0][0] < least:
            known, leaf = heapq.heappop(queue)
            now = worth(walk(leaf))
            if now > known:
                heapq.heappush(queue, (now, leaf))
                continue
            nodes = list(walk(leaf))
            if len(beside[nodes[-1]]) < 3 or is_held[nodes[:-1]].any():
                continue
            is_done = False
            stays[nodes[:-1]], target[nodes[:-1]] = False, nodes[-1]
            beside[nodes[-1]].discard(nodes[-2])
    while (target != target[target]).any():
        target = target[target]
    return stays, target


def by_balls(vertices: np.ndarray, radii: np.ndarray) -> Worth:
    """The slenderness of branches with balls of ``radii`` (N,) around the nodes ``vertices`` (N, 3); infinite if no
    radius is known."""
    radii = np.nan_to_num(radii)
    is_known = bool((radii > 0).any())

    def slenderness(walk: Iterator[int]) -> float:
        nodes = np.fromiter(walk, dtype=np.int64)
        x, r = vertices[nodes], radii[nodes]
        is_out = (np.linalg.norm(x - x[-1], axis=1) >= r[-1]) & (r > 0)
        is_out[-1] = False
        if not is_known or not is_out.any():
            return 0.0 if is_known else np.inf
        if (np.maximum(np.linalg.norm(x - x[0], axis=1), np.linalg.norm(x - x[-1], axis=1)) <= r).any():
            return 0.0
        along = arc_length(x)
        depth, added = along + r[0], np.concatenate([[0.0], np.cumsum(np.diff(along) * (r[1:] + r[:-1]) / 2)])
        end = int(np.argmin(np.append(r >= TOUCHES * depth, False))) - 1  # the last node whose ball touches the tip
        area = np.where(np.arange(len(r)) <= end, r * depth, (r * depth - added)[end] + added)  # over 2 pi
        return float((area[is_out] / r[is_out] ** 2).max() - 0.5)

    return slenderness


def measure(
    vertices: np.ndarray, edges: np.ndarray, slenderness: np.ndarray | Worth, share: np.ndarray | None = None
) -> list[Branch]:
    """The branches of a curve ``(vertices (N, 3), edges (E, 2))``, with the ``slenderness`` (N,) of leaves, or of
    branches; ``share`` (N,) of the mesh's area by node."""
    degree, found = np.bincount(np.unique(np.sort(edges, axis=1), axis=0).ravel(), minlength=len(vertices)), []
    for nodes in trace(len(vertices), edges):
        length = float(np.linalg.norm(np.diff(vertices[nodes], axis=0), axis=1).sum())
        own = np.array(sorted({node for node in nodes if degree[node] < 3}), dtype=np.int64)
        value, ordered = np.inf, nodes if degree[nodes[0]] == 1 else nodes[::-1]
        if degree[ordered[0]] == 1 and degree[ordered[-1]] > 2:
            value = slenderness(iter(ordered)) if callable(slenderness) else float(slenderness[ordered[0]])
        found.append(Branch(nodes, length, value, np.nan if share is None else float(share[own].sum())))
    return found
