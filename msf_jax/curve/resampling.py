"""Nodes evenly along the branches of a curve, inside its solid."""

import itertools

import numpy as np

from msf_jax.inside import containment
from msf_jax.solid.geometry import arc_length, at
from msf_jax.solid.solid import Solid
from msf_jax.topology import graphs


def resample(
    vertices: np.ndarray, edges: np.ndarray, spacing: float, is_held: np.ndarray, solid: Solid | None
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Nodes about every ``spacing`` along the branches of a curve ``(vertices (N, 3), edges (E, 2))``.

    Ends of branches and nodes of ``is_held`` (N,) stay. An edge that would leave ``solid`` is bisected.

    Returns:
        The nodes, the edges, and the new node (N,) of each old node.
    """
    degree = np.bincount(edges.ravel(), minlength=len(vertices))
    is_end = (degree != 2) | is_held
    polylines, stops = [], []
    joined_ends: set[tuple[int, int]] = set()
    for path in graphs.trace(len(vertices), edges):
        cuts = [0, *(np.flatnonzero(is_end[path[1:-1]]) + 1).tolist(), len(path) - 1]
        for first, last in itertools.pairwise(cuts) if len(path) > 1 else ():
            nodes = np.array(path[first : last + 1])
            is_end[nodes[[0, -1]]] = True
            ends = (int(nodes[[0, -1]].min()), int(nodes[[0, -1]].max()))
            along = arc_length(vertices[nodes])
            num = max(1, round(along[-1] / spacing))
            if ends[0] == ends[1]:
                num = max(3, num)  # a loop needs three edges
            elif num == 1 and ends in joined_ends:
                num = 2  # of two branches with the same ends, one needs an inner node
            joined_ends.add(ends)
            polylines.append((nodes, along))
            stops.append(_stops_inside(vertices[nodes], along, num, solid))
    rank = np.cumsum(is_end) - 1
    node_of_old = np.where(is_end, rank, -1)
    new_vertices, new_edges, count = [vertices[is_end]], [np.empty((0, 2), dtype=np.int64)], int(is_end.sum())
    for (nodes, along), stop in zip(polylines, stops, strict=True):
        chain = np.r_[rank[nodes[0]], np.arange(count, count + len(stop) - 2), rank[nodes[-1]]]
        new_vertices.append(at(vertices[nodes], along, stop[1:-1]))
        new_edges.append(np.stack([chain[:-1], chain[1:]], axis=1))
        count += len(stop) - 2
        node_of_old[nodes[1:-1]] = chain[nearest_of(stop, along[1:-1])]
    return np.concatenate(new_vertices), np.concatenate(new_edges), node_of_old


def nearest_of(stops: np.ndarray, along: np.ndarray) -> np.ndarray:
    """(P,) which of ``stops`` (S,), at least two in ascending order, is nearest to each of ``along`` (P,)."""
    after = np.clip(np.searchsorted(stops, along), 1, len(stops) - 1)
    return np.where(along - stops[after - 1] <= stops[after] - along, after - 1, after)


def _stops_inside(points: np.ndarray, along: np.ndarray, num: int, solid: Solid | None) -> np.ndarray:
    """Arc lengths of the ends of at least ``num`` edges along ``points`` (k, 3), as few as stay inside.

    Instead of many bisections, a few more equal edges may be enough. So a larger spacing never needs more nodes.
    """
    fewest = _bisected(points, along, num, solid)
    while num + 1 < len(fewest) - 1:
        num += 1
        fewest = min(fewest, _bisected(points, along, num, solid), key=len)
    return fewest


def _bisected(points: np.ndarray, along: np.ndarray, num: int, solid: Solid | None) -> np.ndarray:
    """Arc lengths of the ends of ``num`` equal edges; those outside are bisected at the middle one of the old nodes
    between their ends, until none is outside or no old node is left."""
    stops = np.linspace(0, along[-1], num + 1)
    while solid is not None:
        entered = solid.enter(at(points, along, stops))
        first = np.searchsorted(along, stops[:-1], side="right")
        last = np.searchsorted(along, stops[1:], side="left")
        rows = np.flatnonzero(first < last)
        rows = rows[~containment.is_inside(solid.shape, entered[rows], entered[rows + 1])]
        if not len(rows):
            break
        stops = np.sort(np.concatenate([stops, along[(first[rows] + last[rows]) // 2]]))
    return stops
