"""The branches of a finished curve, and how a curve without its solid is pruned.

Of a curve without its solid only the balls of its nodes are known. Then a branch stands for a tube with a round end,
and its slenderness is h / r - 1 / 2 at the node, outside of the ball at its junction, where that is largest: h is the
depth of the node below the tip, which is a ball's radius beyond the leaf. Branches of least worth are pruned first.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from msf_jax.solid.geometry import arc_length
from msf_jax.topology import graphs
from msf_jax.topology.graphs import trace

Worth = Callable[[list[int]], float]  # of the branch with these nodes, its leaf first


class Branch(NamedTuple):
    """nodes: along the branch; a closed branch repeats its first node at its end. length: of it.

    slenderness: of the limb of a branch that ends in a leaf, as large as it can be without another leaf (see
    `limbs.tree`): a cylinder that sticks out by h has h / radius. Without the mesh it is measured by the nodes' balls
    (see `by_balls`). Infinite for a branch without a junction or between junctions: its removal would change the
    curve's components or cycles.

    surface: share of the mesh's area that belongs to the branch's nodes, without its junctions; NaN if unknown."""

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
    """Remove branches of a ``worth`` below ``least`` in rounds: at each junction, those of least worth first, until two
    branches are left there. These become one, and the ``worth`` of its leaf may rise or fall.

    Components and cycles stay, and branches with a node of ``is_held`` (N,) besides their junction. Returns which nodes
    stay (N,), and the target of each node (N,): itself, or the nearest one that stays, along the branches that went."""
    edges = np.unique(np.sort(edges, axis=1), axis=0)
    stays, target, is_done = np.ones(num_nodes, dtype=bool), np.arange(num_nodes), False
    while not is_done:
        degree, tips = graphs.degrees(num_nodes, edges), dict[int, list[tuple[float, list[int]]]]()
        for nodes in trace(num_nodes, edges):
            nodes = nodes if degree[nodes[0]] == 1 else nodes[::-1]
            if degree[nodes[0]] == 1 and degree[nodes[-1]] > 2 and not is_held[nodes[:-1]].any():
                tips.setdefault(nodes[-1], []).append((worth(nodes), nodes))
        is_done = True
        for junction, own in tips.items():
            for value, nodes in sorted(own)[: degree[junction] - 2]:
                if value < least:
                    stays[nodes[:-1]], target[nodes[:-1]], is_done = False, junction, False
        edges = edges[stays[edges].all(axis=1)]
    while (target != target[target]).any():
        target = target[target]
    return stays, target


def by_balls(vertices: np.ndarray, radii: np.ndarray) -> Worth:
    """The slenderness of branches with balls of ``radii`` (N,) around the nodes ``vertices`` (N, 3); infinite if no
    radius is known. A branch in one ball, which holds its leaf and its junction, has 0."""
    radii = np.nan_to_num(radii)
    is_known = bool((radii > 0).any())

    def slenderness(nodes: list[int]) -> float:
        x, r = vertices[nodes], radii[nodes]
        to_leaf, to_end = np.linalg.norm(x - x[0], axis=1), np.linalg.norm(x - x[-1], axis=1)
        is_out = (to_end >= r[-1]) & (r > 0)
        is_out[-1] = False
        if not is_known or not is_out.any() or (np.maximum(to_leaf, to_end) <= r).any():
            return 0.0 if is_known else np.inf
        return float(((arc_length(x) + r[0])[is_out] / r[is_out]).max() - 0.5)

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
            value = slenderness(ordered) if callable(slenderness) else float(slenderness[ordered[0]])
        found.append(Branch(nodes, length, value, np.nan if share is None else float(share[own].sum())))
    return found
