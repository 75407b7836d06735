"""Extend the leaves of a curve to the ends of their limbs.

The contraction shortens limbs: a tip shrinks before its limb is thin. From a leaf the curve is extended in small steps
along the limb's axis. Each step is followed by a move to the centroid of the cross-section. The extension ends where
the surface ahead is nearer than a fraction of the limb's radius.
"""

import itertools
from typing import NamedTuple

import numpy as np
from scipy import spatial

from msf_jax.host.curve import branches
from msf_jax.host.solid import sections
from msf_jax.host.solid.enclosure import Enclosure
from msf_jax.host.solid.geometry import arc_length, at, unit

FOLDED = np.pi / 2  # sums of the radii of two balls that meet: a path between them that is longer runs back
GAP = 0.3  # limb radii between the end of the curve and the surface ahead
BACK = 1.0  # limb radii by which a leaf is first moved back, as the end of a contracted curve is bent
STEP = 0.4  # limb radii: length of a step
TURN = 1.0  # step lengths: largest sideways move of a step
MOST_STEPS = 80  # steps of a leaf, after which it goes on only from one cross-section of a limb to the next
MOST_STEPS_IN_A_LIMB = 1000  # steps of a leaf in all: on a coarse mesh hundreds of radii can be missing


class Tip(NamedTuple):
    """nodes: of the leaf's branch, from the leaf on. last: the position of the last one that may move."""

    nodes: np.ndarray
    last: int


def cut_back(
    shape: Enclosure, vertices: np.ndarray, edges: np.ndarray, is_held: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Remove ends that run back beside their own branch: which nodes stay (N,), and the target of each node (N,).

    The ball of such a leaf meets that of a node that is, along the branch, more than ``FOLDED`` times the sum of their
    radii away. The branch then ends where it is farthest from the old leaf, on the path to the nearest such node. At
    least one edge is left, and nothing is removed beyond a node of ``is_held``.
    """
    stays, target = np.ones(len(vertices), dtype=bool), np.arange(len(vertices))
    degree, radii = np.bincount(edges.ravel(), minlength=len(vertices)), shape.approximate_clearance(vertices)[0]
    for path in branches.trace(len(vertices), edges):
        for nodes in (np.array(path), np.array(path[::-1])):
            if degree[nodes[0]] != 1:
                continue
            nodes = nodes[stays[nodes]]  # without the branch's other end, if that was removed
            along, away = arc_length(vertices[nodes]), np.linalg.norm(vertices[nodes] - vertices[nodes[0]], axis=1)
            both = radii[nodes] + radii[nodes[0]]
            over = np.flatnonzero((away <= both) & (along > FOLDED * both))
            beside = over[away[over].argmin()] if len(over) else 0
            end = min(int(away[: beside + 1].argmax()), len(nodes) - 2)
            if not is_held[nodes[:end]].any():
                stays[nodes[:end]], target[nodes[:end]] = False, nodes[end]
    return stays, target


def extend(
    shape: Enclosure, vertices: np.ndarray, edges: np.ndarray, is_held: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """The curve with its leaves at the ends of their limbs: nodes, new ones last, and edges.

    Each leaf is extended by itself: two that face each other in one limb pass each other.
    The nodes of a leaf's branch are spread evenly over its new part.
    """
    x = vertices.copy()
    degree = np.bincount(edges.ravel(), minlength=len(x))
    tips = []
    for path in branches.trace(len(x), edges):
        for nodes in (np.array(path), np.array(path[::-1])):
            if degree[nodes[0]] == 1 and not is_held[nodes[0]]:
                # A branch with two leaves can be moved back to its middle from both sides; held nodes stay.
                last = (len(nodes) - 1) // 2 if degree[nodes[-1]] == 1 else len(nodes) - 1
                tips.append(Tip(nodes, int(np.argmax(np.append(is_held[nodes[:last]], True)))))
    if not tips:
        return x, edges
    radii = shape.approximate_closest(x)[0]
    polylines = _march(shape, vertices, radii, tips)
    added, joined, count = [], [], len(x)
    for (nodes, _), (kept, polyline) in zip(tips, polylines, strict=True):
        along = arc_length(polyline)
        away = np.linalg.norm(polyline - vertices[nodes[0]], axis=1)
        if not along[-1] or (away > shape.approximate_clearance(polyline)[0]).all():
            continue  # it ends before the old leaf, which is in no ball of it
        # Nodes that were moved back are spread over the new polyline; more nodes fill it to the usual spacing.
        moved = nodes[:kept]
        radius = max(float(radii[nodes[: kept + 1]].max()), 1e-300)
        num_new = max(0, int(np.ceil(along[-1] / (STEP * radius))) - len(moved))
        stops = np.linspace(0, along[-1], len(moved) + num_new + 1)[1:]
        places = at(polyline, along, stops)
        x[moved[::-1]] = places[: len(moved)]
        chain = [int(nodes[0]), *range(count, count + num_new)]
        joined += list(itertools.pairwise(chain))
        added.append(places[len(moved) :])
        count += num_new
    return np.concatenate([x, *added]), np.concatenate([edges, np.array(joined, dtype=np.int64).reshape(-1, 2)])


def _march(shape: Enclosure, vertices: np.ndarray, radii: np.ndarray, tips: list[Tip]) -> list[tuple[int, np.ndarray]]:
    """For each leaf, how many nodes of its branch are moved back, and the polyline (k, 3) from there to the end."""
    start, direction, limb, kept = [], [], [], []
    for nodes, last in tips:
        points, radius = vertices[nodes], radii[nodes]
        along = arc_length(points)
        # The limb's radius is that of the branch's largest ball with the leaf in it.
        size = float(radius[np.append(True, np.linalg.norm(points[1:] - points[0], axis=1) <= radius[1:])].max())
        back = min(BACK * size, 0.5 * along[-1])
        first = min(int(np.searchsorted(along, back)), last)
        ahead = at(points, along, np.array([along[first], min(along[first] + size, along[-1])]))
        kept.append(first)
        start.append(points[first])
        direction.append(ahead[0] - ahead[1] if np.ptp(ahead, axis=0).any() else points[0] - points[-1])
        limb.append(size)
    place, heading, size = np.array(start), unit(np.array(direction)), np.array(limb)
    stride = np.full(len(place), STEP)
    polylines = [[point.copy()] for point in place]
    active = np.flatnonzero(size > 0)
    rest = _Rest(vertices, [nodes[:first] for (nodes, _), first in zip(tips, kept, strict=True)])
    away = np.zeros(len(place))
    for count in range(MOST_STEPS_IN_A_LIMB):
        ahead = shape.ray_lengths(place[active], heading[active], 4 * size[active])
        clearance = ahead - GAP * size[active]
        step = np.minimum(stride[active] * size[active], clearance)
        goal = place[active] + step[:, None] * heading[active]
        found = sections.cut(shape, goal, heading[active], size[active], shape.approximate_closest(goal)[1])
        off = found.centroid - goal
        length = np.linalg.norm(off, axis=1)
        is_limb = found.is_around & (found.radius < 2 * size[active])
        # A step turns by at most 45 degrees. Sections of a cap are unreliable, so they count less towards the end.
        share = np.minimum(1.0, TURN * step / np.maximum(length, 1e-300)) * np.clip(clearance / size[active], 0, 1)
        goal = goal + np.where(is_limb, share, 0.0)[:, None] * off
        is_open = (clearance > 0.02 * size[active]) & (
            shape.approximate_clearance(goal)[0] > 0.1 * np.minimum(size[active], ahead)
        )
        # A limb leads away from the rest of the curve: a march that comes back, within the limb's radius, is over.
        beyond = rest.distance(active, goal, size[active])
        is_back = beyond < np.minimum(away[active], size[active])
        is_open &= ~is_back
        away[active[is_open]] = beyond[is_open]
        for row, point in zip(active[is_open], goal[is_open], strict=True):
            polylines[row].append(point)
        heading[active[is_open]] = unit(heading[active] + unit(goal - place[active]))[is_open]
        place[active[is_open]] = goal[is_open]
        # The radius follows a limb that tapers, but not into its cap.
        is_full = is_open & is_limb & (ahead > 2 * size[active])
        size[active[is_full]] = np.minimum(size[active], found.radius)[is_full]
        # Where a step is blocked, a shorter one may follow the bend.
        stride[active] = np.where(is_open, np.minimum(2 * stride[active], STEP), stride[active] / 2)
        goes_on = (clearance > 0.02 * size[active]) & (stride[active] > STEP / 5) & ~is_back
        if count >= MOST_STEPS:
            goes_on &= is_limb
        active = active[goes_on]
        if not len(active):
            break
    return [(number, np.array(polyline)) for number, polyline in zip(kept, polylines, strict=True)]


class _Rest:
    """The rest of the curve for each tip: all nodes but those of its ``moved`` ones, which the march replaces."""

    def __init__(self, vertices: np.ndarray, moved: list[np.ndarray]):
        self._vertices, self._tree = vertices, spatial.KDTree(vertices)
        self._moved = [set(nodes.tolist()) for nodes in moved]

    def distance(self, tip: np.ndarray, place: np.ndarray, most: np.ndarray) -> np.ndarray:
        """The distance (k,) of each place (k, 3) of a tip (k,) from the rest; infinite beyond ``most`` (k,)."""
        found = np.full(len(tip), np.inf)
        for row, near in enumerate(self._tree.query_ball_point(place, most)):
            left = [node for node in near if node not in self._moved[tip[row]]]
            if left:
                found[row] = np.linalg.norm(self._vertices[left] - place[row], axis=1).min()
        return found
