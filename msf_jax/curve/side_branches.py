"""Thin side branches: they begin where their axes meet their trunk, whose sections count nothing where they bulge.

The flow leaves the junction of a thin branch anywhere in its trunk, whose ball is larger. Farther on, where it has its
usual radius, it is on its axis; the line that continues it meets the trunk's axis, or passes it near by.
"""

from itertools import pairwise
from typing import NamedTuple

import numpy as np
from scipy import spatial

from msf_jax.curve import branch_paths
from msf_jax.inside.containment import is_inside
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import ROUNDING, arc_length, at, cross, nearest_to_ray, unit
from msf_jax.topology import graphs

OFF = 0.2  # radii: a branch that is farther from its axis, or an axis from its trunk, is not on it
THIN = 0.6  # of the trunk's radius: largest usual radius of a side branch that is attached anew
CLEAR, STRETCH = 3.0, 6.0  # radii of a branch: on its axis it keeps its radius so far; the length that gives the axis
# of its usual radius: with less, a branch is not on its axis; triangles as long as the radius make 0.85 of it
KEPT = 0.75
AXIS_REACH = 4.0  # of the trunk's radius: so far a branch runs in it from where their axes meet, at 15 degrees or more
# Of the width of a side branch along its trunk, where its axis leaves that: the height over which sections of the trunk
# have a bulge. At its base a branch is thicker than usual, and sections are not quite across.
BULGE = 2.0
SHARED = 0.5  # radii of a side branch: if it begins that near to a junction of its trunk, it begins there


class Side(NamedTuple):
    """A thin side branch. path: its nodes from its junction to its leaf or, if it forks itself, to its fork. size: its
    usual radius. exit: (3,) its last node in a ball of the trunk. begin: the position in ``path`` where it is on its
    axis. place, heading: (3,) that node, and the unit vector of its axis away from the trunk."""

    path: np.ndarray
    size: float
    exit: np.ndarray
    begin: int
    place: np.ndarray
    heading: np.ndarray


class Meeting(NamedTuple):
    """Where the axis of a side branch meets its trunk. edge: the number of the trunk's edge. place: (3,). ball: the
    trunk's radius there."""

    edge: int
    place: np.ndarray
    ball: float


def thin_sides(
    x: np.ndarray, edges: np.ndarray, is_held: np.ndarray, radii: np.ndarray
) -> tuple[list[Side], np.ndarray]:
    """The thin side branches that are long enough to have an axis, those that fork themselves first; and which
    ``edges`` (E,) may be a trunk's: those of no thin branch that ends in a leaf.

    One that forks is only taken if it is straight up to there: an arm with a hand stays as it was centred."""
    degree = np.bincount(edges.ravel(), minlength=len(x))
    paths = [np.array(path) for path in graphs.trace(len(x), edges)]
    at_node: dict[int, list[float]] = {}  # of each branch there, the usual radius in the half that is far away
    for each in (*paths, *(path[::-1] for path in paths)):
        at_node.setdefault(int(each[0]), []).append(_far_radius(each, radii))
    # A trunk passes a junction, so two branches are as thick there: the second thickest counts.
    trunk = {node: sorted(own)[-2] if len(own) > 1 else 0.0 for node, own in at_node.items()}
    in_side, thin, sides = np.zeros(len(x), dtype=bool), [], []
    for each in sorted(paths, key=lambda path: bool((degree[path[[0, -1]]] == 1).any())):  # those that fork first
        is_onward = (degree[each[-1]] == 1, trunk[each[0]]) > (degree[each[0]] == 1, trunk[each[-1]])
        path = each if is_onward else each[::-1]
        size, is_leaf = _far_radius(path, radii), degree[path[-1]] == 1
        is_link = degree[path[-1]] > 2 and THIN * trunk[path[-1]] <= size  # no bridge from trunk to trunk
        if not ((is_leaf or is_link) and degree[path[0]] > 2 and size < THIN * trunk[path[0]]):
            continue
        in_side[path[1:]] |= is_leaf  # a side branch that forks is a trunk, too
        thin.append((path, size, is_link))
    is_trunk = ~(in_side[edges[:, 0]] | in_side[edges[:, 1]])
    nodes = np.unique(edges[is_trunk])
    # Points within a ball of the trunk: |p - x| <= r, as |p - x|^2 + R^2 - r^2 <= R^2, where R is the largest radius.
    largest = float(radii[nodes].max(initial=0.0))
    balls = np.column_stack([x, np.sqrt(np.maximum(largest**2 - radii**2, 0.0))])
    whole = spatial.KDTree(balls[nodes])
    for path, size, is_link in thin:
        others = spatial.KDTree(balls[np.setdiff1d(nodes, path[1:])]) if is_link else whole
        away = others.query(np.pad(x[path], ((0, 0), (0, 1))))[0]
        along, inner = arc_length(x[path]), np.flatnonzero(away <= largest * (1 + ROUNDING))
        inner = inner[inner < len(path) / 2]  # a side branch that forks may come to another trunk
        if not len(inner):  # thin branches that meet have no trunk
            continue
        # A radius beyond, its ball has left the trunk. In front of the crotch of its own fork, it is narrow again.
        last = along[-1] - is_link * size
        own = np.where(along <= last, radii[path], size)
        is_on_axis = keeps_radius(along, own, size) & (along >= along[inner[-1]] + size)
        gap = np.diff(along)  # an edge that is twice as long as usual leads through a fork to the first ring beyond
        is_on_axis[:-1] &= gap <= np.maximum(2 * np.median(gap), size)
        begin = int(is_on_axis.argmax()) if is_on_axis.any() else len(path)
        # A fork is on the axis, too: a radius of it is enough, where a thin limb of that length may end anywhere.
        least = size if is_link else STRETCH * size
        if begin < len(path) and along[begin] + least <= last and not is_held[path[: begin + 1]].any():
            stretch = min(STRETCH * size, last - along[begin])
            half, beyond = (along[begin] + last) / 2, along[begin] + stretch * np.array([0.5, 1.0])
            near, far, middle, end = at(x[path], along, np.array([*beyond, half, last]))
            if is_link and np.linalg.norm(middle - (x[path[begin]] + end) / 2) > OFF * size:
                continue
            # Before it is on its axis, a branch may be as thick as it is there, where the solid is not much thicker.
            off = np.linalg.norm(np.cross(x[path] - near, unit(far - near)), axis=1)
            begin = int(np.flatnonzero((along <= beyond[0]) & (off > OFF * size)).max(initial=begin - 1)) + 1
            place = x[path[begin]]
            sides.append(Side(path, size, x[path[inner[-1]]], begin, place, unit(far - place)))
    return sides, is_trunk


def _far_radius(path: np.ndarray, radii: np.ndarray) -> float:
    """The usual radius of a branch ``path`` (k,) in the half that is far from its first node."""
    return float(np.median(radii[path[len(path) // 2 :]]))


def keeps_radius(along: np.ndarray, radius: np.ndarray, size: float) -> np.ndarray:
    """(k,) the nodes ``along`` (k,) a branch from which on it keeps its usual radius, ``size``, for `CLEAR` of it. On
    its axis it does; nodes on a bend are nearer to the surface."""
    narrow = np.append(along[radius < KEPT * size], np.inf)
    return narrow[np.searchsorted(narrow, along)] > along + CLEAR * size


def meeting(side: Side, x: np.ndarray, edges: np.ndarray, is_trunk: np.ndarray, radii: np.ndarray) -> Meeting | None:
    """Where the axis of the side branch meets the trunk, of those of ``edges`` (E, 2) that may be one and that it does
    not lead to; ``x`` (N, 3), ``radii`` (N,): nodes. None if it passes all of them, is as thick, leaves the trunk far
    away, or is nearly parallel to it."""
    part = graphs.labels(len(x), *edges[~_is_first(edges, side)].T)
    numbers = np.flatnonzero(is_trunk & (part[edges[:, 0]] != part[side.path[1]]))
    trunk = edges[numbers]
    share, place, off = nearest_to_ray(x[trunk], side.place, -side.heading)
    ball = (1 - share) * radii[trunk[:, 0]] + share * radii[trunk[:, 1]]
    along = np.linalg.norm(place - side.exit, axis=1)
    is_by = (off < OFF * ball) & (along < AXIS_REACH * ball)
    # Legs that are nearly parallel to their trunk meet its axis anywhere.
    sine = np.linalg.norm(cross(side.heading, unit(x[trunk[:, 1]] - x[trunk[:, 0]])), axis=1)
    is_near = is_by & (side.size < THIN * ball) & (sine > 1 / AXIS_REACH)
    if not is_near.any():  # also where all branches end at one junction, and there is no trunk
        return None
    # It ends at the first stretch of trunk that it comes near to, at the nearest place there.
    stretch = graphs.labels(len(x), *trunk[is_by].T)[trunk[:, 0]]
    is_near &= stretch == stretch[np.where(is_near, along, np.inf).argmin()]
    best = int(np.where(is_near, off / np.maximum(ball, 1e-300), np.inf).argmin())
    return Meeting(int(numbers[best]), place[best], float(ball[best]))


def _is_first(edges: np.ndarray, side: Side) -> np.ndarray:
    """(E,) which edge is the first one of the side branch."""
    return (np.sort(edges, axis=1) == np.sort(side.path[:2])).all(axis=1)


def bulged(
    x: np.ndarray, edges: np.ndarray, is_held: np.ndarray, radii: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The edges (T, 2) of the trunks of thin side branches; which nodes (N,) are where a side branch leaves its trunk;
    and which are of a part of a trunk with such nodes, and may move: not those with a side branch that has no axis.

    A plane across the trunk cuts off a bulge of the side branch there, and its middle is aside: at a height from
    (R cos a - r) / sin a to (R cos a + r) / sin a above the meeting of the axes, where the trunk has the radius R, the
    branch r, and the angle between them is a.
    """
    sides, is_trunk = thin_sides(x, edges, is_held, radii)
    trunk = edges[is_trunk]
    is_aside, is_part = np.zeros((2, len(x)), dtype=bool)
    paths = branch_paths.paths_of(x, trunk, is_held) if sides and len(trunk) else []
    of_edge: dict[frozenset[int], tuple[np.ndarray, int]] = {}
    loose: list[int] = []  # junctions of side branches that get a new place
    for nodes, is_loop, *_ in paths:
        if not is_loop:
            of_edge |= {frozenset(pair): (nodes, k) for k, pair in enumerate(pairwise(nodes.tolist()))}
    for side in sides if paths else ():
        found = meeting(side, x, edges, is_trunk, radii)
        if found is None or frozenset(edges[found.edge].tolist()) not in of_edge:
            continue
        loose.append(int(side.path[0]))
        nodes, first = of_edge[frozenset(edges[found.edge].tolist())]
        along = arc_length(x[nodes])
        start = along[first] + np.linalg.norm(found.place - x[nodes[first]])
        cosine = float(side.heading @ unit(x[nodes[first + 1]] - x[nodes[first]]))
        sine = np.sqrt(1 - cosine**2)  # at least 1 / AXIS_REACH, see `meeting`
        ball = float(radii[nodes[np.abs(along - start) <= AXIS_REACH * found.ball]].max(initial=found.ball))
        is_aside[nodes[np.abs(along - start - ball * cosine / sine) <= BULGE * side.size / sine]] = True
        is_part[nodes] |= is_aside[nodes].any()
    is_part[np.setdiff1d(edges[~is_trunk], loose)] = False
    return trunk, is_aside, is_part


def attached(
    shape: Enclosure, x: np.ndarray, edges: np.ndarray, is_held: np.ndarray, radii: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """The curve with each thin side branch on a straight line to the place of its trunk that its axis meets: nodes
    (M, 3), new ones last, and edges (E, 2).

    The flow leaves the junction of a thin branch anywhere in the trunk, whose ball is larger, and the branch runs along
    the trunk until there. A new node of the trunk takes it; the old junction stays, and may be a leaf then.
    """
    x, radii = x.copy(), radii.copy()
    sides, is_trunk = thin_sides(x, edges, is_held, radii)
    for side in sides:
        path, begin, found = side.path, side.begin, meeting(side, x, edges, is_trunk, radii)
        if found is None or not is_inside(shape, found.place[None], side.place[None])[0]:
            continue
        # Branches that begin at one place share its node.
        nodes = np.intersect1d(edges[is_trunk], np.flatnonzero(np.bincount(edges.ravel()) > 2))
        away = np.linalg.norm(x[nodes] - found.place, axis=1)
        is_shared, new, meet = bool((away < SHARED * side.size).any()), len(x), found.place
        if is_shared:
            new = int(nodes[away.argmin()])
            meet = x[new]
        x[path[1 : begin + 1]] = meet + np.linspace(0, 1, begin + 1)[1:, None] * (side.place - meet)
        gone = np.flatnonzero(_is_first(edges, side)).tolist()
        added, is_added = [[new, int(path[1])]], [bool(is_trunk[gone].any())]
        if not is_shared:
            x, radii = np.append(x, meet[None], axis=0), np.append(radii, found.ball)
            gone.append(found.edge)
            added += [[int(edges[found.edge, 0]), new], [new, int(edges[found.edge, 1])]]
            is_added += [True, True]
        edges = np.concatenate([np.delete(edges, gone, axis=0), added])
        is_trunk = np.append(np.delete(is_trunk, gone), is_added)
    return x, edges
