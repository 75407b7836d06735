"""A curve as branches: the paths between nodes that do not have two edges; and edits of the graph."""

from typing import NamedTuple

import numpy as np
from scipy import spatial

from msf_jax.solid.frame import RESOLUTION
from msf_jax.solid.geometry import arc_length
from msf_jax.solid.handles import Handles
from msf_jax.topology import graphs
from msf_jax.topology.graphs import shortest_forest

NEAR = 1.0  # radii, the larger of the two: junctions are merged that are joined by a shorter path


def nearest_on_branch(
    nodes: np.ndarray, edges: np.ndarray, points: np.ndarray, node_of_point: np.ndarray
) -> np.ndarray:
    """The nearest node (P,) of each point (P, 3) on its own branch; for a point at a junction, on any branch there.

    ``node_of_point`` (P,) is the point's node from before nodes moved along their branches and new ones were added.
    """
    found = node_of_point.copy()
    least = np.full(len(points), np.inf)
    order = np.argsort(node_of_point, kind="stable")
    bounds = np.searchsorted(node_of_point[order], np.arange(len(nodes) + 1))
    for path in graphs.trace(len(nodes), edges):
        own = np.concatenate([order[bounds[node] : bounds[node + 1]] for node in dict.fromkeys(path)])
        if len(own):
            on_path = np.array(path)
            away, place = spatial.KDTree(nodes[on_path]).query(points[own])
            is_nearer = away < least[own]
            found[own[is_nearer]] = on_path[np.asarray(place)[is_nearer]]
            least[own[is_nearer]] = away[is_nearer]
    return found


def cut_loops(num_nodes: int, edges: np.ndarray, radii: np.ndarray) -> np.ndarray:
    """(E,) which edges stay if every loop is cut at its thinnest edge: the spanning forest of the thickest edges.

    The thickness of an edge is the smaller radius at its ends; the larger radius breaks ties.
    """
    order = np.lexsort((-radii[edges].max(axis=1), -radii[edges].min(axis=1)))
    return shortest_forest(num_nodes, edges, np.argsort(order))


def roots_of(num_nodes: int, edges: np.ndarray, radii: np.ndarray, root: int | None) -> tuple[int, ...]:
    """The node with the largest ball in each component, largest first; ``root``, if given, is first instead."""
    label = graphs.labels(num_nodes, *edges.T)
    size = radii.copy()
    if root is not None:
        size[root] = np.inf
    order = np.argsort(-size, kind="stable")
    return tuple(order[np.sort(np.unique(label[order], return_index=True)[1])].tolist())


def merge_junctions(
    vertices: np.ndarray, edges: np.ndarray, radii: np.ndarray, is_held: np.ndarray, handles: Handles
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Merge junctions whose path is within the ball of one of them, at the one with the largest radius.

    Returns which nodes stay (N,), the target of each node (N,), and the edges. Junctions whose merge would remove a
    loop, or lead it around other ``handles``, are not merged, and nodes of ``is_held`` (N,) stay."""
    degree = np.bincount(edges.ravel(), minlength=len(vertices))
    target = every = np.arange(len(vertices))
    moved = np.zeros(len(vertices), dtype=np.int64)  # class of the path from each node to its target
    cycles = graphs.cycle_count(len(vertices), edges)[1]
    own = handles.classes(vertices[edges[:, 0]], vertices[edges[:, 1]])
    paths = [path for path in graphs.trace(len(vertices), edges) if min(degree[path[0]], degree[path[-1]]) > 2]

    def apart(path: list[int]) -> float:
        return float(arc_length(vertices[path])[-1] / max(radii[path[0]], radii[path[-1]], 1e-300))

    for path in sorted(paths, key=apart):  # the nearest first, so that the order of the nodes does not decide
        if is_held[path[1:-1]].any():
            continue
        path = path if radii[target[path[0]]] >= radii[target[path[-1]]] else path[::-1]
        a, b = target[path[0]], target[path[-1]]
        length = float(arc_length(vertices[path])[-1])
        is_near = max(length, np.linalg.norm(vertices[a] - vertices[b])) < NEAR * radii[a]
        if a != b and is_near and not is_held[target == b].any():
            tried, added = target.copy(), moved.copy()
            steps = handles.classes(vertices[path[:-1]], vertices[path[1:]])
            inner, gone = np.array(path[1:-1], dtype=np.int64), np.flatnonzero(target == b)
            tried[inner] = tried[gone] = a
            added[inner] = moved[path[0]] - np.cumsum(steps)[:-1]
            added[gone] += moved[path[0]] - steps.sum() - moved[path[-1]]
            after = handles.classes(vertices[tried[edges[:, 0]]], vertices[tried[edges[:, 1]]])
            is_kept = after == own - added[edges[:, 0]] + added[edges[:, 1]]
            if is_kept.all() and graphs.cycle_count(len(vertices), _relabelled(edges, tried))[1] == cycles:
                target, moved = tried, added
    return target == every, target, _relabelled(edges, target)


def merge_coincident(
    vertices: np.ndarray, edges: np.ndarray, is_held: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Merge edges that coincide in space: which nodes stay (N,), the target of each node (N,), and the edges.

    This removes loops that are folded flat. An edge is split at nodes that lie on it, and coincident nodes are merged
    into the first of them, or into one of ``is_held`` (N,). Branches that only touch stay apart, so no loop is added.
    """
    num, every = len(vertices), np.arange(len(vertices))
    places = _places(vertices, edges, is_held)
    doubled = _doubled(_laid(edges, places, np.ones(num, dtype=bool))[1])
    group = graphs.labels(num, *doubled.T)
    is_glued, cycles = np.zeros(num, dtype=bool), graphs.cycle_count(num, edges)[1]
    for number in np.unique(group[doubled[:, 0]]):
        tried = is_glued | (group == number)
        goal, pieces = _laid(edges, places, tried)
        found = graphs.cycle_count(num, _relabelled(pieces, every))[1]
        if found <= cycles:
            is_glued, cycles = tried, found
    goal, pieces = _laid(edges, places, is_glued)
    return goal == every, goal, _relabelled(pieces, every)


class _Places(NamedTuple):
    """target: (N,) the first of the nodes that coincide with each node. edge, node, part: (k,) see `_nodes_on`."""

    target: np.ndarray
    edge: np.ndarray
    node: np.ndarray
    part: np.ndarray


def _places(vertices: np.ndarray, edges: np.ndarray, is_held: np.ndarray) -> _Places:
    """Which nodes coincide, those of ``is_held`` (N,) before others, and which nodes are on edges."""
    num, tree = len(vertices), spatial.KDTree(vertices)
    pairs = tree.query_pairs(RESOLUTION, output_type="ndarray")
    place = graphs.labels(num, *pairs.T)
    held_first = np.lexsort((np.arange(num), ~is_held))
    target = held_first[np.unique(place[held_first], return_index=True)[1]][place]
    return _Places(target, *_nodes_on(vertices, edges, tree))


def _laid(edges: np.ndarray, places: _Places, is_glued: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The target of each node (N,) and the pieces (P, 2) of edges, if they are merged at places ``is_glued`` (N,)."""
    target, edge, node, part = places
    goal, stops = np.where(is_glued[target], target, np.arange(len(target))), is_glued[target[node]]
    return goal, np.sort(goal[_pieces(edges, edge[stops], node[stops], part[stops])], axis=1)


def _doubled(pieces: np.ndarray) -> np.ndarray:
    """The pieces that occur several times or have equal ends."""
    single, count = np.unique(pieces, axis=0, return_counts=True)
    return single[(count > 1) | (single[:, 0] == single[:, 1])]


def _nodes_on(
    vertices: np.ndarray, edges: np.ndarray, tree: spatial.KDTree
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Edges (k,), nodes (k,) that lie on them between their ends, and the fraction (k,) of the edge before the node."""
    a, b = vertices[edges[:, 0]], vertices[edges[:, 1]]
    near = tree.query_ball_point((a + b) / 2, np.linalg.norm(b - a, axis=1) / 2 + RESOLUTION)
    edge = np.repeat(np.arange(len(edges)), np.fromiter(map(len, near), np.int64, len(near)))
    node = np.concatenate([*near, np.empty(0)]).astype(np.int64)
    along, offset = (b - a)[edge], vertices[node] - a[edge]
    length2 = np.maximum(np.einsum("ij,ij->i", along, along), 1e-300)
    part = np.einsum("ij,ij->i", along, offset) / length2
    is_on = np.linalg.norm(offset - part[:, None] * along, axis=1) < RESOLUTION
    is_on &= np.minimum(part, 1 - part) * np.sqrt(length2) > RESOLUTION
    return edge[is_on], node[is_on], part[is_on]


def _pieces(edges: np.ndarray, edge: np.ndarray, node: np.ndarray, part: np.ndarray) -> np.ndarray:
    """Pieces (P, 2) of edges: each edge is split at the nodes on it, from its tail to its head; see `_nodes_on`."""
    every, ends = np.arange(len(edges)), np.zeros(len(edges))
    owner, stop = np.concatenate([every, edge, every]), np.concatenate([edges[:, 0], node, edges[:, 1]])
    order = np.lexsort((np.concatenate([ends, part, ends + 1]), owner))
    owner, stop = owner[order], stop[order]
    return np.stack([stop[:-1], stop[1:]], axis=1)[owner[:-1] == owner[1:]]


def _relabelled(edges: np.ndarray, target: np.ndarray) -> np.ndarray:
    """Edges (K, 2) between the targets of their ends, each once, and none from a node to itself."""
    left = np.sort(target[edges], axis=1)
    return np.unique(left[left[:, 0] != left[:, 1]], axis=0)
