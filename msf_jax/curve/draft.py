"""A curve on its way to being finished, and what the passes over it may ask of its solid."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from msf_jax.curve import centring
from msf_jax.inside.roadmap import Roadmap
from msf_jax.limbs.caps import Caps
from msf_jax.solid.enclosure import Enclosure


class Draft(NamedTuple):
    """A curve on its way to being finished.

    vertices: (N, 3). edges: (E, 2). is_held: (N,) nodes that do not move. origin: (N,) the number of each node in the
    flow's curve, ascending; -1 for new nodes, which come last. node_of_flow: (n,) the node for each of the flow's
    nodes: itself, or the junction that its branch was pruned from.
    is_sparse: whether nodes are farther apart than `SPACING`, because of `MOST_NODES`. num_pruned, num_grown: branches
    that were removed because they are no limbs, and that were added because the flow had missed them, counted by ends.
    finer: limbs of a finer detail, as the least detail and the place (3,) of the end of each.
    """

    vertices: np.ndarray
    edges: np.ndarray
    is_held: np.ndarray
    origin: np.ndarray
    node_of_flow: np.ndarray
    is_sparse: bool = False
    num_pruned: int = 0
    num_grown: int = 0
    finer: tuple[tuple[float, np.ndarray], ...] = ()

    def changed(self, vertices: np.ndarray, edges: np.ndarray | None = None) -> "Draft":
        """The draft with moved nodes, new ones last, and with other edges if they are given."""
        new = (0, len(vertices) - len(self.vertices))
        return self._replace(
            vertices=vertices,
            edges=self.edges if edges is None else edges,
            is_held=np.pad(self.is_held, new),
            origin=np.pad(self.origin, new, constant_values=-1),
        )

    def degree(self) -> np.ndarray:
        """(N,) number of edges at each node."""
        return np.bincount(self.edges.ravel(), minlength=len(self.vertices))

    def is_leaf(self) -> np.ndarray:
        """(N,) True for a node with one edge."""
        return self.degree() == 1


class Job(NamedTuple):
    """The inputs of all passes.

    shape: the solid, of diagonal 1. coarse: about the same surface with fewer triangles, fine enough for centring.
    prune: least slenderness of a limb, 0 for no pruning (see `limbs.caps`). roadmap: paths through the solid.
    budget: of all centring together. caps: returns those of the coarse surface.
    """

    shape: Enclosure
    coarse: Enclosure
    prune: float
    roadmap: Roadmap
    budget: centring.Budget
    caps: Callable[[], Caps]


def reduced(draft: Draft, stays: np.ndarray, target: np.ndarray) -> Draft:
    """The draft with the nodes of ``stays`` (N,) only; the others are replaced by their ``target`` (N,)."""
    x, e, is_held = draft.vertices, draft.edges, draft.is_held
    rank = np.cumsum(stays) - 1
    left = rank[e[stays[e].all(axis=1)]]
    of_flow = rank[target[draft.node_of_flow]]
    return draft._replace(
        vertices=x[stays],
        edges=left,
        is_held=is_held[stays],
        origin=draft.origin[stays],
        node_of_flow=of_flow,
    )
