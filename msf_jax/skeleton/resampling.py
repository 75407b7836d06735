"""Other nodes along the branches of a curve: evenly, inside its solid, or at its corners."""

import itertools
from collections.abc import Callable

import numpy as np

from msf_jax.solid.geometry import arc_length, at, to_segment
from msf_jax.solid.solid import Solid
from msf_jax.topology import graphs

Stops = Callable[[np.ndarray, np.ndarray, int], np.ndarray]


def resample(
    vertices: np.ndarray, edges: np.ndarray, is_held: np.ndarray, stops_of: Stops
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Other nodes along the branches of a curve ``(vertices (N, 3), edges (E, 2))``; ends of branches and nodes of
    ``is_held`` (N,) stay.

    ``stops_of`` gives the arc lengths (s,) of the nodes of a stretch between these, from its points (k, 3), their arc
    lengths (k,), and the least number of edges: a loop needs three, the second stretch between the same ends two.

    Returns:
        The nodes, the edges, and the new node (N,) of each old node.
    """
    degree = np.bincount(edges.ravel(), minlength=len(vertices))
    is_end = (degree != 2) | is_held
    stretches: list[tuple[np.ndarray, np.ndarray, np.ndarray]] = []  # the nodes, their arc lengths, those of new ones
    joined_ends: set[tuple[int, int]] = set()
    for path in graphs.trace(len(vertices), edges):
        cuts = [0, *(np.flatnonzero(is_end[path[1:-1]]) + 1).tolist(), len(path) - 1]
        for first, last in itertools.pairwise(cuts) if len(path) > 1 else ():
            nodes = np.array(path[first : last + 1])
            is_end[nodes[[0, -1]]] = True
            ends = (int(nodes[[0, -1]].min()), int(nodes[[0, -1]].max()))
            along = arc_length(vertices[nodes])
            least = 3 if ends[0] == ends[1] else 2 if ends in joined_ends else 1
            joined_ends.add(ends)
            stretches.append((nodes, along, stops_of(vertices[nodes], along, least)))
    rank = np.cumsum(is_end) - 1
    node_of_old = np.where(is_end, rank, -1)
    new_vertices, new_edges, count = [vertices[is_end]], [np.empty((0, 2), dtype=np.int64)], int(is_end.sum())
    for nodes, along, stop in stretches:
        chain = np.r_[rank[nodes[0]], np.arange(count, count + len(stop) - 2), rank[nodes[-1]]]
        new_vertices.append(at(vertices[nodes], along, stop[1:-1]))
        new_edges.append(np.stack([chain[:-1], chain[1:]], axis=1))
        count += len(stop) - 2
        node_of_old[nodes[1:-1]] = chain[np.searchsorted((stop[:-1] + stop[1:]) / 2, along[1:-1])]  # the nearest
    return np.concatenate(new_vertices), np.concatenate(new_edges), node_of_old


def corner_stops(points: np.ndarray, along: np.ndarray, least: int, tolerance: float) -> np.ndarray:
    """Arc lengths of the corners of a polyline of ``least`` or more edges within ``tolerance`` of ``points`` (k, 3)."""
    first = np.linspace(0, len(points) - 1, least + 1).round().astype(int)
    return along[add_corners(points, first.tolist(), tolerance)]


def add_corners(points: np.ndarray, stops: list[int], tolerance: float) -> list[int]:
    """``stops`` of a path through ``points`` (n, 3), and those between them, in order, such that no point is farther
    than ``tolerance`` from the line between the stops before and after it (Douglas and Peucker 1973)."""
    corners, stack = list(stops), list(itertools.pairwise(stops))
    while stack:
        first, last = stack.pop()
        away = to_segment(points[first : last + 1], points[first], points[last])
        if away.max() > tolerance:
            corners.append(first + int(away.argmax()))
            stack += [(first, corners[-1]), (corners[-1], last)]
    return sorted(corners)


def even_stops(points: np.ndarray, along: np.ndarray, least: int, spacing: float, solid: Solid | None) -> np.ndarray:
    """Arc lengths of the ends of edges about ``spacing`` long along ``points`` (k, 3), as few as stay inside ``solid``,
    where an edge that would leave it is bisected. Instead of many bisections, a few more equal edges may be enough: so
    a larger spacing never needs more nodes."""
    num = max(least, round(along[-1] / spacing))
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
        rows = rows[~solid.shape.holds(entered[rows], entered[rows + 1])]
        if not len(rows):
            break
        stops = np.sort(np.concatenate([stops, along[(first[rows] + last[rows]) // 2]]))
    return stops
