"""From the curve as the flow left it to the finished one: inside, pruned, centred, and out to the ends of the limbs.

The nodes of the flow that stay keep their order, and new ones come after them, so that whatever speaks of the flow's
nodes (a loss on a replay, say) speaks of the same ones in the finished curve.
"""

from typing import NamedTuple

import numpy as np
from scipy import spatial

from msf_jax.host import branches, centring, containment, tips
from msf_jax.host.enclosure import Enclosure

SPACING = 0.5  # radii, between the nodes of a finished curve
LATER_ROUNDS = 2  # of centring, once it has been centred


class Finished(NamedTuple):
    """vertices (N, 3) and edges (E, 2) of the finished curve.

    is_kept: (n,) which of the flow's nodes are in it, in their order, before all others.
    target: (n,) the flow's node that stands for each: itself, or the junction that its branch was pruned from.
    """

    vertices: np.ndarray
    edges: np.ndarray
    is_kept: np.ndarray
    target: np.ndarray


def finish(
    shape: Enclosure,
    nodes: np.ndarray,
    edges: np.ndarray,
    is_held: np.ndarray,
    *,
    persistence: float,
    centre: bool,
    extend: bool,
    rough: Enclosure | None = None,
) -> Finished:
    """Finish the curve ``(nodes (n, 3), edges)`` of a solid of diagonal 1; nodes of ``is_held`` (n,) do not move.

    ``persistence`` is that below which branches are pruned; ``centre`` and ``extend`` switch those steps. ``rough`` is
    much the same surface of fewer triangles, which is good enough to find the middle of.
    """
    rough = shape if rough is None else rough
    x, e = containment.contain(shape, nodes, edges, is_held)
    held = np.pad(is_held, (0, len(x) - len(is_held)))
    if centre:  # what to prune is decided on a curve that is centred already
        x = centring.centre(rough, containment.unfold(shape, x, e, held), e, held)
        x = containment.unfold(shape, x, e, held)
    stays, target = branches.prune(x, e, shape.approach(x)[0], persistence, held)
    rank = np.cumsum(stays) - 1
    x, e, held = x[stays], rank[e[stays[e].all(axis=1)]], held[stays]
    if centre:
        x, e = containment.refine(shape, x, e, SPACING)
        held = np.pad(held, (0, len(x) - len(held)))
        x = centring.centre(rough, x, e, held, LATER_ROUNDS)
    if extend:
        x, e = tips.extend(shape, x, e, held)
        held = np.pad(held, (0, len(x) - len(held)))
    if centre and extend:
        is_leaf = np.bincount(e.ravel(), minlength=len(x)) == 1
        x = centring.centre(rough, x, e, held | is_leaf, LATER_ROUNDS)
    if centre:
        x = containment.unfold(shape, x, e, held)
    x, e = containment.contain(shape, x, e, held)
    return Finished(x, in_order(e), stays[: len(nodes)], target[: len(nodes)])


def in_order(edges: np.ndarray) -> np.ndarray:
    """Edges with their smaller node first, in ascending order."""
    return np.unique(np.sort(edges, axis=1), axis=0).reshape(-1, 2)


def nearest_on_branch(
    nodes: np.ndarray, edges: np.ndarray, points: np.ndarray, node_of_point: np.ndarray
) -> np.ndarray:
    """Let each point (P, 3) go to the nearest node of its own branch; one at a junction, of any that meet there.

    Nodes have moved along their branches, and there are new ones, since a point was given its node. Returns (P,) nodes.
    """
    found = node_of_point.copy()
    least = np.full(len(points), np.inf)
    order = np.argsort(node_of_point, kind="stable")
    bounds = np.searchsorted(node_of_point[order], np.arange(len(nodes) + 1))
    for way in branches.trace(len(nodes), edges):
        own = np.concatenate([order[bounds[node] : bounds[node + 1]] for node in dict.fromkeys(way)])
        if len(own):
            on_way = np.array(way)
            away, place = spatial.KDTree(nodes[on_way]).query(points[own])
            is_nearer = away < least[own]
            found[own[is_nearer]] = on_way[np.asarray(place)[is_nearer]]
            least[own[is_nearer]] = away[is_nearer]
    return found
