"""Branches of a curve, the paths between nodes that do not have two edges: edits of the graph, and measures along them.

Measures that are linear in the nodes are sparse matrices, for use as rows of a least-squares problem.
"""

from math import sqrt
from typing import NamedTuple

import numpy as np
from scipy import sparse, spatial

from msf_jax.numerics.compiled import Ints, Points, Reals, kernel
from msf_jax.solid.geometry import RESOLUTION, ROUNDING, arc_length, at
from msf_jax.solid.handles import Handles
from msf_jax.solid.kernels import dot, minus, norm, point_of
from msf_jax.topology import graphs

WIDE = 3.0  # sizes: a limb whose half width is larger is a sheet
CHUNK = 100  # nodes of a branch at a time that are held against the others: a table of them stays in the cache
UNEVEN = 10.0  # limit on the ratio of the mean of two gaps to one of them
STIFFEST = 1e5  # limit on the stiffness
MARGIN = 0.4  # radii of a ball: beside a ball, width of the step from a limb that is a part of it to one on its own


def nearest_on_branch(x: np.ndarray, edges: np.ndarray, points: np.ndarray, node_of_point: np.ndarray) -> np.ndarray:
    """(P,) the node of x (N, 3) nearest to each point (P, 3) on its own branch, or at a junction on any branch there.
    ``node_of_point`` (P,) is the point's node from before nodes moved along their branches and new ones were added."""
    found, least = node_of_point.copy(), np.full(len(points), np.inf)
    order = np.argsort(node_of_point, kind="stable")
    bounds = np.searchsorted(node_of_point[order], np.arange(len(x) + 1))
    for path in graphs.trace(len(x), edges):
        own = np.concatenate([order[bounds[node] : bounds[node + 1]] for node in dict.fromkeys(path)])
        if len(own):
            on_path = np.array(path)
            away, place = spatial.KDTree(x[on_path]).query(points[own])
            is_nearer = away < least[own]
            found[own[is_nearer]] = on_path[np.asarray(place)[is_nearer]]
            least[own[is_nearer]] = away[is_nearer]
    return found


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
        is_near = max(length, np.linalg.norm(vertices[a] - vertices[b])) < radii[a]
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


def _relabelled(edges: np.ndarray, target: np.ndarray) -> np.ndarray:
    """Edges (K, 2) between the targets of their ends, each once, and none from a node to itself."""
    left = np.sort(target[edges], axis=1)
    return np.unique(left[left[:, 0] != left[:, 1]], axis=0)


class BranchPath(NamedTuple):
    """A branch. nodes: (k,). is_loop: it has no junction, and its ends are one node. share: (k,) arc length to each
    node over the whole, to be kept. stops: positions in ``nodes`` of its ends and of the nodes that do not move."""

    nodes: np.ndarray
    is_loop: bool
    share: np.ndarray
    stops: np.ndarray


def paths_of(vertices: np.ndarray, edges: np.ndarray, is_held: np.ndarray) -> list[BranchPath]:
    """The branches of a curve that have at least one edge."""
    degree = np.bincount(edges.ravel(), minlength=len(vertices))
    found = []
    for branch in graphs.trace(len(vertices), edges):
        nodes = np.array(branch)
        if len(nodes) > 1:
            along = arc_length(vertices[nodes])
            stops = np.unique(np.r_[0, np.flatnonzero(is_held[nodes]), len(nodes) - 1])
            is_loop = bool(nodes[0] == nodes[-1] and degree[nodes[0]] == 2)
            found.append(BranchPath(nodes, is_loop, along / max(along[-1], 1e-300), stops))
    return found


def degree_of_ends(paths: list[BranchPath], num: int) -> np.ndarray:
    """(num,) the number of edges at the nodes where branches end, 0 within branches."""
    return np.bincount(np.concatenate([path.nodes[[0, -1]] for path in paths]), minlength=num)


def spread(x: np.ndarray, paths: list[BranchPath]) -> np.ndarray:
    """Move the nodes (N, 3) along their branches, so that each is at its share of its branch's length again."""
    spaced = x.copy()
    for nodes, _, share, stops in paths:
        along = arc_length(x[nodes])
        goal = np.interp(share, share[stops], along[stops])
        spaced[nodes[1:-1]] = at(x[nodes], along, goal)[1:-1]
    return spaced


def chords(x: np.ndarray, paths: list[BranchPath], reach: np.ndarray) -> sparse.csr_matrix:
    """(N, N) matrix from nodes to chords of their branches, from ``reach`` (N,) before to as far after each node."""
    rows, columns, values = [], [], []
    for nodes, is_loop, _, _ in paths:
        along = arc_length(x[nodes])
        own = slice(0, len(nodes) - 1 if is_loop else len(nodes))
        for sign in (1, -1):
            if is_loop:
                stop = np.mod(along + sign * np.minimum(reach[nodes], along[-1] / 4), along[-1])
            else:
                stop = np.clip(along + sign * reach[nodes], 0, along[-1])
            before = np.clip(np.searchsorted(along, stop, side="right") - 1, 0, len(nodes) - 2)
            t = (stop - along[before]) / np.maximum(along[before + 1] - along[before], 1e-300)
            rows += [nodes[own], nodes[own]]
            columns += [nodes[before][own], nodes[before + 1][own]]
            values += [sign * (1 - t)[own], sign * t[own]]
    entries = np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))
    return sparse.csr_matrix(entries, (len(x), len(x)))


def bending(
    x: np.ndarray, paths: list[BranchPath], reach: np.ndarray
) -> tuple[sparse.csr_matrix, np.ndarray, np.ndarray]:
    """How branches bend at the nodes within them, as a matrix (T, N): h times the change of direction, which is the
    second difference where nodes are h apart; its stiffness (T,), which acts over a length ``reach`` (N,) for any h;
    and what it is at rest (T, 3): 0, and in a loop that of a circle, or stiffness would draw it to its hole."""
    found, gaps, rest = [np.empty((0, 3), dtype=np.int64)], [np.empty((0, 2))], [np.empty((0, 3))]
    for nodes, is_loop, _, _ in paths:
        polyline = np.r_[nodes, nodes[1]] if is_loop else nodes
        gap = np.diff(arc_length(x[polyline]))
        found.append(np.stack([polyline[:-2], polyline[1:-1], polyline[2:]], axis=1))
        gaps.append(np.stack([gap[:-1], gap[1:]], axis=1))
        turn = is_loop * np.pi * gaps[-1].sum(axis=1) / max(gap[: len(nodes) - 1].sum(), 1e-300)
        rest.append((2 * np.cos(turn) - 2)[:, None] * (x[polyline[1:-1]] - x[nodes[1:]].mean(axis=0)))
    triple, gap = np.concatenate(found), np.maximum(np.concatenate(gaps), 1e-12)
    spacing = gap.mean(axis=1)
    stiffness = np.minimum((reach[triple[:, 1]] / spacing) ** 4, STIFFEST)
    before, after = spacing / np.maximum(gap.T, spacing / UNEVEN)
    rows, values = np.repeat(np.arange(len(triple)), 3), np.stack([before, -before - after, after], axis=1)
    matrix = sparse.csr_matrix((values.ravel(), (rows, triple.ravel())), shape=(len(triple), len(x)))
    return matrix, stiffness, np.concatenate(rest)


def sizes(
    x: np.ndarray, paths: list[BranchPath], size: np.ndarray, weight: np.ndarray, clearance: np.ndarray
) -> np.ndarray:
    """(N,) the size of the limb around each node: a weighted mean of ``size`` along its branch, over nearby nodes, and,
    with a weight of `ROUNDING`, all others. The ends of branches, and branches without any ``weight``, get their
    ``clearance``."""
    found, degree = clearance.copy(), degree_of_ends(paths, len(x))
    for nodes, is_loop, _, _ in paths:
        own = weight[nodes]
        if own.sum() > 1e-3:
            along = arc_length(x[nodes])
            usual = np.average(size[nodes], weights=own)
            farthest = usual * np.sqrt(-2 * np.log(ROUNDING * np.finfo(float).eps))  # beyond, rounding hides the bell
            both, sums = np.stack([own * size[nodes], own]), np.empty((2, len(nodes)))
            for part in np.array_split(np.arange(len(nodes)), len(nodes) // CHUNK + 1):
                first, last = np.searchsorted(along, along[part[[0, -1]]] + (-farthest, farthest))
                bell = np.exp(-0.5 * ((along[part, None] - along[first:last]) / usual) ** 2)
                sums[:, part] = np.einsum("nm,bm->bn", bell, both[:, first:last])
            mean = (sums[0] + ROUNDING * both[0].sum()) / (sums[1] + ROUNDING * own.sum())
            is_own = (degree[nodes] <= 1) | is_loop
            found[nodes[is_own]] = mean[is_own]
    return found


@kernel
def hold_apart(x: Points, tangent: Points, size: Reals, ball: Reals, branch: Ints, clear: Reals) -> None:
    """``clear`` (N,), 1 before, of `clear_of_others`; ``branch`` (N,): the branch of each node, -1 for a junction."""
    for i in range(len(x)):
        here, along = point_of(x, i), point_of(tangent, i)
        for j in range(len(x)):
            away, radius = minus(point_of(x, j), here), max(ball[j], RESOLUTION)
            far = size[i] + (1 + MARGIN / 2) * radius
            if (branch[i] == branch[j] and branch[i] >= 0) or dot(away, away) > far * far:
                continue
            height = dot(away, along)
            flat = away[0] - height * along[0], away[1] - height * along[1], away[2] - height * along[2]
            aside = max(norm(flat) - size[i], 0.0)
            gap = sqrt(height * height + aside * aside) / radius
            t = min(max((gap - 1) / MARGIN + 0.5, 0.0), 1.0)
            clear[i] = min(clear[i], t * t * (3 - 2 * t))


def clear_of_others(
    x: np.ndarray, paths: list[BranchPath], tangent: np.ndarray, size: np.ndarray, ball: np.ndarray
) -> np.ndarray:
    """(N,) a smooth step: 0 at nodes where several limbs are one, 1 where a limb is on its own: where no ball, of
    radius ``ball`` (N,), of a junction or of another branch is near the node's disc, of the limb's ``size`` (N,) and
    across its ``tangent`` (N, 3), by a radius of that ball, over a width of `MARGIN` radii."""
    branch, clear, degree = np.full(len(x), -1), np.ones(len(x)), degree_of_ends(paths, len(x))
    for number, (nodes, is_loop, *_) in enumerate(paths):  # a junction has none, and so is beside all of its branches
        branch[nodes] = np.where((degree[nodes] <= 1) | is_loop, number, -1)
    hold_apart(x, tangent, size, ball, branch, clear)
    return clear


def crossed_again(
    x: np.ndarray, paths: list[BranchPath], tangent: np.ndarray, centroid: np.ndarray, radius: np.ndarray
) -> np.ndarray:
    """(N,) whether the branch of a loop comes back through the section of a node, within ``radius`` (N,) of its
    ``centroid`` (N, 3), in the plane across ``tangent`` (N, 3). So it does if the section goes through both sides."""
    found = np.zeros(len(x), dtype=bool)
    for nodes in (path.nodes for path in paths if path.is_loop):
        place, num = x[nodes], len(nodes) - 1
        axes = np.ascontiguousarray(place.T)
        for part in np.array_split(np.arange(num), len(nodes) // CHUNK + 1):
            own = nodes[part]
            # A product of matrices would wake a thread on every core, for less than one has to do.
            height = np.einsum("ni,im->nm", tangent[own], axes)
            height -= np.einsum("ni,ni->n", tangent[own], x[own])[:, None]
            height[np.arange(len(own)), part] = 0.0
            is_over = height > 0
            # Flat indices are found many times faster than pairs.
            here, there = np.divmod(np.flatnonzero(is_over[:, :-1] != is_over[:, 1:]), num)
            is_other = (there != part[here]) & ((there + 1) % num != part[here])
            here, there = here[is_other], there[is_other]
            low, high = height[here, there], height[here, there + 1]
            t = (low / (low - high))[:, None]
            away = np.linalg.norm((1 - t) * place[there] + t * place[there + 1] - centroid[own[here]], axis=1)
            found[own[here[away < radius[own[here]]]]] = True
    return found


def usual(paths: list[BranchPath], num: int, node: np.ndarray, value: np.ndarray) -> np.ndarray:
    """(num,) the median along each node's branch of the ``value`` (L,) of ``node`` (L,); NaN if none has one there."""
    known, found = np.full((2, num), np.nan)
    known[node] = value
    for path in paths:
        along = known[path.nodes]
        if not np.isnan(along).all():
            found[path.nodes] = np.nanmedian(along)
    return found
