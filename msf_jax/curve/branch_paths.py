"""Branches of a curve as paths, with measures along them: directions, bending, spacing, and the limb's size.

Measures that are linear in the nodes are sparse matrices, for use as rows of a least-squares problem.
"""

from typing import NamedTuple

import numpy as np
from scipy import sparse

from msf_jax.solid.geometry import arc_length, at
from msf_jax.topology import graphs

WIDE = 3.0  # sizes: a limb whose half width is larger is a sheet
CHUNK = 100  # nodes of a branch at a time that are held against the others: a table of them stays in the cache
UNEVEN = 10.0  # limit on the ratio of the mean of two gaps to one of them
STIFFEST = 1e5  # limit on the stiffness
FLOOR = 1e-9  # least weight of every node of the branch in a mean, relative to a node at distance 0


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
        turn = (
            np.pi * gaps[-1].sum(axis=1) / max(gap[: len(nodes) - 1].sum(), 1e-300)
            if is_loop
            else np.zeros(len(gap) - 1)
        )
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
    """(N,) the size of the limb around each node: a weighted mean of ``size`` along its branch, over nearby nodes.

    The ends of branches, and branches without any ``weight``, get their ``clearance``.
    """
    found = clearance.copy()
    degree = np.zeros(len(x), dtype=np.int64)
    for path in paths:
        np.add.at(degree, path.nodes[[0, -1]], 1)
    for nodes, is_loop, _, _ in paths:
        own = weight[nodes]
        if own.sum() > 1e-3:
            along = arc_length(x[nodes])
            usual = np.average(size[nodes], weights=own)
            farthest = usual * np.sqrt(-2 * np.log(FLOOR * np.finfo(float).eps))  # beyond, rounding hides the bell
            both, sums = np.stack([own * size[nodes], own]), np.empty((2, len(nodes)))
            for part in np.array_split(np.arange(len(nodes)), len(nodes) // CHUNK + 1):
                first, last = np.searchsorted(along, along[part[[0, -1]]] + (-farthest, farthest))
                bell = np.exp(-0.5 * ((along[part, None] - along[first:last]) / usual) ** 2)
                sums[:, part] = np.einsum("nm,bm->bn", bell, both[:, first:last])
            mean = (sums[0] + FLOOR * both[0].sum()) / (sums[1] + FLOOR * own.sum())
            is_own = (degree[nodes] <= 1) | is_loop
            is_own[1:-1] = True
            found[nodes[is_own]] = mean[is_own]
    return found


def clear_of_junctions(
    x: np.ndarray, paths: list[BranchPath], degree: np.ndarray, size: np.ndarray, zone: float, margin: float
) -> np.ndarray:
    """(N,) a smooth step: 0 within about ``zone`` times a junction's ``size``, 1 beyond, over a width of ``margin``."""
    clear = np.where(degree > 2, 0.0, 1.0)
    for nodes, _, _, _ in paths:
        along = arc_length(x[nodes])
        for end, distance in ((nodes[0], along), (nodes[-1], along[-1] - along)):
            if degree[end] > 2:
                t = np.clip((distance / max(size[end], 1e-300) - zone) / margin + 0.5, 0, 1)
                clear[nodes[1:-1]] *= (t * t * (3 - 2 * t))[1:-1]
    return clear


def crossed_again(
    x: np.ndarray, paths: list[BranchPath], tangent: np.ndarray, centroid: np.ndarray, radius: np.ndarray
) -> np.ndarray:
    """(N,) whether the branch of a loop comes back through the section of a node, within ``radius`` (N,) of its
    ``centroid`` (N, 3), in the plane across ``tangent`` (N, 3). So it does if the section goes through both sides."""
    found = np.zeros(len(x), dtype=bool)
    for nodes, is_loop, _, _ in paths:
        if is_loop:
            place = x[nodes]
            axes = np.ascontiguousarray(place.T)
            for part in np.array_split(np.arange(len(nodes) - 1), len(nodes) // CHUNK + 1):
                own = nodes[part]
                # A product of matrices would wake a thread on every core, for less than one has to do.
                height = np.einsum("ni,im->nm", tangent[own], axes)
                height -= np.einsum("ni,ni->n", tangent[own], x[own])[:, None]
                height[np.arange(len(own)), part] = 0.0
                is_over = height > 0
                is_crossing = is_over[:, :-1] != is_over[:, 1:]  # flat indices are found many times faster than pairs
                here, there = np.divmod(np.flatnonzero(is_crossing), len(nodes) - 1)
                is_other = (there != part[here]) & ((there + 1) % (len(nodes) - 1) != part[here])
                here, there = here[is_other], there[is_other]
                low, high = height[here, there], height[here, there + 1]
                t = (low / (low - high))[:, None]
                away = np.linalg.norm((1 - t) * place[there] + t * place[there + 1] - centroid[own[here]], axis=1)
                found[own[here[away < radius[own[here]]]]] = True
    return found


def usual(paths: list[BranchPath], known: np.ndarray) -> np.ndarray:
    """(N,) the median of ``known`` (N,) along each node's branch, without NaN; NaN if all are NaN."""
    found = np.full(len(known), np.nan)
    for path in paths:
        along = known[path.nodes]
        if not np.isnan(along).all():
            found[path.nodes] = np.nanmedian(along)
    return found
