"""Girdles: where pairs of limbs meet the body; which of them is the pelvis, and which carries the head.

A body is a row of girdles in its mirror plane: pelvis, shoulders, and often a head with ears or horns. Its trunk lies
between the two girdles whose connection is thickest at its narrowest place, since a neck is narrower than a trunk. Of
these two the shoulders are those with the head beyond: with more pairs (ears, horns), or, if as many, with the larger
volume, which a head has and a tail has not. The other one is the pelvis. No direction in space decides, so turned and
mirrored shapes have the same.
"""

from itertools import combinations
from typing import NamedTuple

import networkx as nx
import numpy as np

from msf_jax.skeleton.rigging.mirror import Mirror, images
from msf_jax.solid.geometry import arc_length
from msf_jax.topology import graphs

MAIN_LIMB = 0.5  # of the longest pair of limbs: shorter pairs, such as fingers of a hand, make no girdle


class BodyGirdles(NamedTuple):
    """girdles: nodes where pairs of long limbs begin. pelvis and shoulders: two of them, if there are two."""

    girdles: list[int]
    pelvis: int | None = None
    shoulders: int | None = None


class Pair(NamedTuple):
    """Two limbs that are mirror images: the node in the middle where they begin, the nodes from tip to tip, and the
    length of both, outside the ball there."""

    girdle: int
    nodes: list[int]
    length: float


def body_of(
    vertices: np.ndarray, edges: np.ndarray, radii: np.ndarray, tips: np.ndarray, plane: Mirror | None
) -> BodyGirdles:
    """The girdles of a tree ``(vertices (N, 3), edges (E, 2))`` in limbs of ``radii`` (N,) with ends ``tips``."""
    pairs = [] if plane is None else _pairs(vertices, edges, radii, tips, plane)
    longest = max((pair.length for pair in pairs), default=0.0)
    main = [pair for pair in pairs if pair.length >= MAIN_LIMB * longest]
    tree = nx.Graph(edges.tolist())
    trunks = []
    for one, other in combinations(sorted({pair.girdle for pair in main}), 2):
        if nx.has_path(tree, one, other):
            nodes = nx.shortest_path(tree, one, other)
            trunks.append((float(radii[nodes].min()), -len(nodes), one, other))
    girdles = [pair.girdle for pair in main]
    if not trunks:
        return BodyGirdles(girdles)
    ends = max(trunks)[2:]
    pelvis, shoulders = sorted(ends, key=lambda end: _beyond(vertices, radii, tree, end, sum(ends) - end, pairs, main))
    return BodyGirdles(girdles, pelvis, shoulders)


def _pairs(vertices: np.ndarray, edges: np.ndarray, radii: np.ndarray, tips: np.ndarray, plane: Mirror) -> list[Pair]:
    """The pairs of limbs that begin at a junction in the mirror plane."""
    degree = graphs.degrees(len(vertices), edges)
    tree = nx.Graph(edges.tolist())
    image = images(plane, vertices[tips])
    found = []
    for k in np.flatnonzero(image > np.arange(len(tips))):
        one, other = int(tips[k]), int(tips[image[k]])
        if not nx.has_path(tree, one, other):
            continue
        nodes = nx.shortest_path(tree, one, other)
        is_middle = (np.abs(plane.height(vertices[nodes])) < radii[nodes]) & (degree[nodes] > 2)
        if is_middle.any():
            girdle = nodes[int(np.where(is_middle, radii[nodes], -1.0).argmax())]
            found.append(Pair(girdle, nodes, float(arc_length(vertices[nodes])[-1]) - 2 * float(radii[girdle])))
    return found


def _beyond(
    vertices: np.ndarray, radii: np.ndarray, tree: nx.Graph, end: int, other: int, pairs: list[Pair], main: list[Pair]
) -> tuple[int, float]:
    """What is beyond the ``end`` of a trunk, without the end's own long limbs: the number of pairs, and the integral of
    radius^2 along the curve outside the end's ball."""
    before = nx.shortest_path(tree, end, other)[1]
    own = {node for pair in main if pair.girdle == end for node in pair.nodes} - {end}
    rest = nx.restricted_view(tree, [before, *own], [])
    nodes = nx.node_connected_component(rest, end)
    count = sum(pair.girdle in nodes and pair.girdle != end for pair in pairs)
    a, b = np.array(list(rest.subgraph(nodes).edges), dtype=np.int64).reshape(-1, 2).T
    step = np.linalg.norm(vertices[a] - vertices[b], axis=1)
    is_out = np.linalg.norm((vertices[a] + vertices[b]) / 2 - vertices[end], axis=1) > radii[end]
    return count, float((step * radii[a] * radii[b])[is_out].sum())
