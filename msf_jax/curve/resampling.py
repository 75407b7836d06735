"""Move the nodes of a curve: spread them evenly along its branches, smooth it, or round its corners. All of these keep
the curve inside its solid."""

import itertools

import numpy as np

from msf_jax.inside import containment
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import arc_length, at, unit
from msf_jax.solid.solid import Solid
from msf_jax.topology import graphs

MOST_ROUNDS = 8  # each over all corners that are left; in later ones, one corner of 20 that are left is rounded


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


def smooth(
    vertices: np.ndarray, edges: np.ndarray, radii: np.ndarray, rounds: int, is_held: np.ndarray, solid: Solid | None
) -> tuple[np.ndarray, np.ndarray]:
    """The curve after ``rounds`` in which each node moves half of the distance to the middle of its two neighbours.

    Ends of branches and nodes of ``is_held`` (N,) stay, and so does a node that would leave ``solid`` or lose half of
    its radius. Returns the nodes and the edges; an edge that would leave the solid gets new nodes, which come last.
    """
    x = vertices.copy()
    degree = np.bincount(edges.ravel(), minlength=len(x))
    paths = graphs.trace(len(x), edges)
    for _ in range(rounds):
        goal = x.copy()
        for path in paths:
            nodes = path[:-1] + path[:2] if degree[path[0]] == 2 else path  # a loop has no fixed ends
            goal[nodes[1:-1]] = x[nodes[1:-1]] / 2 + (x[nodes[:-2]] + x[nodes[2:]]) / 4
        is_safe = ~is_held
        if solid is not None:
            is_safe &= solid.radii(goal) >= radii / 2
        x[is_safe] = goal[is_safe]
    if solid is None:
        return x, edges
    entered, edges = containment.contain(solid.shape, solid.enter(x), edges, np.ones(len(x), dtype=bool))
    return np.concatenate([x, solid.leave(entered[len(x) :])]), edges


def round_corners(
    shape: Enclosure, vertices: np.ndarray, edges: np.ndarray, is_held: np.ndarray, most: float
) -> tuple[np.ndarray, np.ndarray]:
    """The curve with corners that turn by more than ``most`` degrees rounded: its nodes, new ones last, and its edges.

    The ball around a corner is convex and inside, so any curve within it is inside. There the curve is replaced by a
    parabola that ends where it left the ball, and points to the corner there. It has no corner. It uses the old nodes,
    and new ones as needed. Ends of branches and nodes of ``is_held`` (N,) stay.
    """
    x = vertices
    for _ in range(MOST_ROUNDS):
        is_fixed = np.pad(is_held, (0, len(x) - len(is_held)))
        turn = np.where(is_fixed, 0.0, turns(x, edges))
        sharp = np.flatnonzero(turn > most)
        if not len(sharp):
            break
        clearance = np.zeros(len(x))
        clearance[sharp] = shape.clearance(x[sharp])
        before, polylines = x, []
        for path in graphs.trace(len(x), edges):
            nodes = np.array(path)
            corners = nodes[clearance[nodes] > 0]
            if len(corners) and nodes[0] == nodes[-1] and turn[nodes[0]] > 0:  # a ring begins at its straightest node
                first = int(turn[nodes].argmin())
                nodes = np.r_[nodes[first:-1], nodes[: first + 1]]
            for corner in corners[np.argsort(-turn[corners], kind="stable")]:
                x, nodes = _round_corner(x, nodes, int(corner), float(clearance[corner]), is_fixed, most)
            polylines.append(nodes)
        if x is before:
            break
        edges = np.concatenate([np.stack([nodes[:-1], nodes[1:]], axis=1) for nodes in polylines])
    return x, edges


def turns(vertices: np.ndarray, edges: np.ndarray) -> np.ndarray:
    """(N,) degrees by which the curve turns at its nodes; 0 for nodes without exactly two edges."""
    inner, before, after = containment.between(len(vertices), edges)
    found = np.zeros(len(vertices))
    found[inner] = _angles(vertices[inner] - vertices[before], vertices[after] - vertices[inner])
    return found


def _angles(one: np.ndarray, other: np.ndarray) -> np.ndarray:
    """Degrees (n,) between vectors (n, 3), 0 if one of them is zero."""
    found = np.degrees(np.arccos(np.clip(np.einsum("ni,ni->n", unit(one), unit(other)), -1.0, 1.0)))
    return np.where(one.any(axis=1) & other.any(axis=1), found, 0.0)


def _round_corner(
    x: np.ndarray, nodes: np.ndarray, corner: int, clearance: float, is_fixed: np.ndarray, most: float
) -> tuple[np.ndarray, np.ndarray]:
    """Round one ``corner`` of a branch within its ball: the curve's nodes (N, 3), new ones last, and the branch's (k,).

    Nodes of ``is_fixed`` and nodes that are newer than it stay. The nodes of a rounded corner become fixed.
    """
    here = int(np.flatnonzero(nodes == corner)[0])
    is_end = np.append(is_fixed, True)[np.minimum(nodes, len(is_fixed))]
    is_end[[0, -1]] = True
    if is_end[here]:  # fixed by another corner near by, or the start of a ring: left to the next round
        return x, nodes
    along, ends = arc_length(x[nodes]), np.flatnonzero(is_end)
    low, high = ends[ends < here].max(), ends[ends > here].min()
    first, last = max(along[low], along[here] - clearance), min(along[high], along[here] + clearance)
    if first == along[here] or last == along[here]:  # another node is in the place of the corner
        return x, nodes
    begin, end = np.searchsorted(along, first, side="right"), np.searchsorted(along, last)
    old, sharp = nodes[begin:end], _angles(*np.diff(x[nodes[here - 1 : here + 2]], axis=0)[:, None])[0]
    three = at(x[nodes], along, np.array([first, along[here], last]))
    num = max(len(old), int(np.ceil(2 * sharp / most)))
    chosen = _parabola(three, num + 2)
    at_first, at_last = along[begin - 1] == first, along[end] == last
    chain = np.full(num + 2, -1)
    chain[0], chain[-1] = nodes[begin - 1] if at_first else -1, nodes[end] if at_last else -1
    chain[1 + ((np.arange(len(old)) + 0.5) * num / len(old)).astype(np.int64)] = old
    is_new = chain < 0
    chain[is_new] = len(x) + np.arange(np.count_nonzero(is_new))
    y = np.concatenate([x, chosen[is_new]])
    y[old] = chosen[np.isin(chain, old)]
    path = np.r_[nodes[: begin - at_first], chain, nodes[end + at_last :]]
    around = np.diff(y[path[max(begin - at_first - 1, 0) : begin - at_first + len(chain) + 1]], axis=0)
    if _angles(around[:-1], around[1:]).max() >= sharp:
        return x, nodes
    is_fixed[old] = True
    return y, path


def _parabola(three: np.ndarray, num: int) -> np.ndarray:
    """(num, 3) points of the Bezier curve with the control points ``three`` (3, 3)."""
    t = np.linspace(0, 1, num)[:, None]
    return (1 - t) ** 2 * three[0] + 2 * t * (1 - t) * three[1] + t**2 * three[2]
