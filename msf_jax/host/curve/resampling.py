"""Other nodes on the same curve: spread evenly along its branches, or smoothed; both keep it inside its solid."""

import itertools

import numpy as np

from msf_jax.host.curve import branches, containment
from msf_jax.host.solid.geometry import arc_length, at
from msf_jax.host.solid.solid import Solid


def resample(
    vertices: np.ndarray, edges: np.ndarray, spacing: float, is_held: np.ndarray, solid: Solid | None
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Nodes about every ``spacing`` along the branches of a curve ``(vertices (N, 3), edges (E, 2))``.

    Ends of branches and nodes of ``is_held`` (N,) stay, and so do nodes that an edge would leave ``solid`` to skip.

    Returns:
        The nodes, the edges, and the new node (N,) of each old one.
    """
    degree = np.bincount(edges.ravel(), minlength=len(vertices))
    is_end = (degree != 2) | is_held
    courses, stops = [], []
    joined_ends: set[tuple[int, int]] = set()
    for way in branches.trace(len(vertices), edges):
        cuts = [0, *(np.flatnonzero(is_end[way[1:-1]]) + 1).tolist(), len(way) - 1]
        for first, last in itertools.pairwise(cuts) if len(way) > 1 else ():
            nodes = np.array(way[first : last + 1])
            is_end[nodes[[0, -1]]] = True
            ends = (int(nodes[[0, -1]].min()), int(nodes[[0, -1]].max()))
            along = arc_length(vertices[nodes])
            num = max(1, round(along[-1] / spacing))
            if ends[0] == ends[1]:
                num = max(3, num)  # a loop needs three edges,
            elif num == 1 and ends in joined_ends:
                num = 2  # and of two branches with the same ends one needs a node of its own
            joined_ends.add(ends)
            courses.append((nodes, along))
            stops.append(_stops_inside(vertices[nodes], along, np.linspace(0, along[-1], num + 1), solid))
    rank = np.cumsum(is_end) - 1
    node_of_old = np.where(is_end, rank, -1)
    new_vertices, new_edges, count = [vertices[is_end]], [np.empty((0, 2), dtype=np.int64)], int(is_end.sum())
    for (nodes, along), stop in zip(courses, stops, strict=True):
        chain = np.r_[rank[nodes[0]], np.arange(count, count + len(stop) - 2), rank[nodes[-1]]]
        new_vertices.append(at(vertices[nodes], along, stop[1:-1]))
        new_edges.append(np.stack([chain[:-1], chain[1:]], axis=1))
        count += len(stop) - 2
        node_of_old[nodes[1:-1]] = chain[np.abs(along[1:-1, None] - stop).argmin(axis=1)]
    return np.concatenate(new_vertices), np.concatenate(new_edges), node_of_old


def _stops_inside(points: np.ndarray, along: np.ndarray, stops: np.ndarray, solid: Solid | None) -> np.ndarray:
    """Arc lengths ``stops`` and those of the old ``points`` between two of them that the solid parts."""
    if solid is None:
        return stops
    entered = solid.enter(at(points, along, stops))
    is_bad = ~containment.is_inside(solid.shape, entered[:-1], entered[1:])
    span = np.clip(np.searchsorted(stops, along, side="right") - 1, 0, len(is_bad) - 1)
    return np.sort(np.concatenate([stops, np.setdiff1d(along[is_bad[span]], stops)]))


def smooth(
    vertices: np.ndarray, edges: np.ndarray, radii: np.ndarray, rounds: int, is_held: np.ndarray, solid: Solid | None
) -> tuple[np.ndarray, np.ndarray]:
    """The curve after ``rounds`` in which nodes go half of the way to the middle of their two neighbours.

    Ends of branches and nodes of ``is_held`` (N,) stay, and so does a node that would leave ``solid`` or lose half of
    its radius. Returns the nodes, new ones last where an edge had to be led through the solid, and the edges.
    """
    x = vertices.copy()
    degree = np.bincount(edges.ravel(), minlength=len(x))
    ways = branches.trace(len(x), edges)
    for _ in range(rounds):
        goal = x.copy()
        for way in ways:
            nodes = way[:-1] + way[:2] if degree[way[0]] == 2 else way  # a loop has no ends that stay
            goal[nodes[1:-1]] = x[nodes[1:-1]] / 2 + (x[nodes[:-2]] + x[nodes[2:]]) / 4
        is_safe = ~is_held
        if solid is not None:
            is_safe &= solid.radii(goal) >= radii / 2
        x[is_safe] = goal[is_safe]
    if solid is None:
        return x, edges
    entered, edges = containment.contain(solid.shape, solid.enter(x), edges, np.ones(len(x), dtype=bool))
    return np.concatenate([x, solid.leave(entered[len(x) :])]), edges
