"""Junctions of tubes: where the axes of their branches meet.

Near a junction sections are no guide, and the nodes there follow what is wide: the flow's junction of a narrow fork is
in front of the crotch, where its branches bend around it. Farther on, where each branch has its usual radius, it is on
its axis. A line continues that, or a parabola if it is bent, with the tangent p + t d at the place of the junction. The
point m nearest to all tangents,

    minimise  sum over the branches |(I - d d^T) (m - p)|^2,

is the junction, if it is nearly on each, and sees the places where the branches are on their axes. Limbs that leave a
large ball side by side begin near its middle, and each turns into its axis gradually.

Thin side branches begin where their axes meet their trunk, whose sections count nothing where they bulge. The flow
leaves the junction of a thin branch anywhere in its trunk, whose ball is larger. Farther on, where it has its usual
radius, it is on its axis; the line that continues it meets the trunk's axis, or passes it near by.
"""

from itertools import pairwise
from typing import NamedTuple

import numpy as np
from scipy import spatial

from msf_jax.curve import branches
from msf_jax.inside.containment import is_inside
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import ROUNDING, arc_length, at, cross, nearest_to_ray, unit
from msf_jax.topology import graphs

BENT = 0.05  # radii: a stretch whose middle is nearer to its chord is straight; 0.08 for an arc of 6 radii
APART = 0.35  # radii: axes meet if one point is that near to all; on a plant's stem, they pass each other by a third
BALL = 1.3  # radii of a branch: larger than of all is a junction's ball; that of a T of equal tubes has 1.25
SPOTS = 20  # places on each branch in such a ball, of which one is near its middle
BEGIN = 1.5  # radii from the place from which on it keeps its usual radius: there a branch is on its axis
AXIS = 2.0  # radii: length of the stretch that gives a branch's axis
LATER = 4.0  # radii: so much later at most that stretch begins; a branch of 35 degrees is bent over three
# least eigenvalue of the sum: 0.13 for a fork of 30 degrees; below it, axes are parallel and meet nowhere
SPREAD = 0.05
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
    paths = branches.paths_of(x, trunk, is_held) if sides and len(trunk) else []
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


class OwnStretch(NamedTuple):
    """Where a branch is on its own. path: (k,) its nodes from its junction. size: its usual radius. along: (k,) the arc
    length of each node. start, last: from where to where, as arc lengths. ball: how far the junction's ball reaches.
    axis: (3, 3) the coefficients of its axis there as a function of the arc length, the square's first."""

    path: np.ndarray
    size: float
    along: np.ndarray
    start: float
    last: float
    ball: float
    axis: np.ndarray


def met(shape: Enclosure, x: np.ndarray, edges: np.ndarray, is_held: np.ndarray, radii: np.ndarray) -> np.ndarray:
    """The nodes (N, 3) with junctions of tubes where the axes of their branches meet, and the nodes on the line to each
    branch's own stretch on its line. Where rods cross, the flow has two junctions: if the axes of all branches of both
    meet, these are at one place, with the stretch between. An acute bend is such a junction of two branches."""
    x, degree = x.copy(), np.bincount(edges.ravel(), minlength=len(x))
    traced = graphs.trace(len(x), edges)
    bends = [bend for path in traced for bend in _bends(x, np.array(path), radii)]
    is_meeting = degree > 2
    is_meeting[bends] = True
    at_node: dict[int, list[np.ndarray]] = {}
    links: dict[tuple[int, int], list[np.ndarray]] = {}
    for nodes in traced:
        cuts = [0, *(np.flatnonzero(is_meeting[nodes[1:-1]]) + 1).tolist(), len(nodes) - 1]
        for each in (nodes[first : last + 1] for first, last in pairwise(cuts)):
            for path in (each, each[::-1]):
                at_node.setdefault(path[0], []).append(np.array(path))
            if min(degree[each[0]], degree[each[-1]]) > 2 and each[0] != each[-1]:
                links.setdefault((min(each[0], each[-1]), max(each[0], each[-1])), []).append(np.array(each))
    is_done = np.zeros(len(x), dtype=bool)
    middles = [(ends, between[0]) for ends, between in links.items() if len(between) == 1]
    middles += [((node, node), np.array([node])) for node in at_node if is_meeting[node]]
    for ends, middle in middles:
        paths = [path for node in dict.fromkeys(ends) for path in at_node[node]]
        if ends[0] != ends[1]:  # without the stretch between; a loop at one junction is two branches of it
            paths = [path for path in paths if {*path[[0, -1]].tolist()} != {*ends}]
        if not is_done[list(ends)].any() and len(paths) == sum(degree[list({*ends})]) - 2 * (len(middle) > 1):
            is_done[middle] = _put(shape, x, middle, paths, is_meeting, is_held, radii)
    return x


def _bends(x: np.ndarray, path: np.ndarray, radii: np.ndarray) -> list[int]:
    """The nodes of ``path`` (k,) at which it turns back, between the places `CLEAR` radii before and behind. A fat ring
    does so all along, and has no bend."""
    along, reach = arc_length(x[path]), CLEAR * float(np.median(radii[path]))
    before, behind = (at(x[path], along, along + side) - x[path] for side in (-reach, reach))
    cosine = -np.einsum("ki,ki->k", unit(before), unit(behind))
    is_known = (along > reach) & (along < along[-1] - reach)
    runs = np.flatnonzero(np.diff((cosine < 0) & is_known, prepend=False, append=False)).reshape(-1, 2)
    runs = runs[is_known[runs - [1, 0]].all(axis=1)]
    return [int(path[start + cosine[start:stop].argmin()]) for start, stop in runs]


def _put(
    shape: Enclosure,
    x: np.ndarray,
    middle: np.ndarray,
    paths: list[np.ndarray],
    is_meeting: np.ndarray,
    is_held: np.ndarray,
    radii: np.ndarray,
) -> bool:
    """Put the nodes ``middle`` (m,), a junction, or two and the stretch between, where the axes of the ``paths`` from
    there meet, and those on lines to there. ``x`` (N, 3) changes only if True is returned."""
    usual = [float(np.median(radii[path[1:]])) for path in paths]
    has_ball = max(radii[path[: len(path) // 2]].max(initial=0.0) for path in paths) > BALL * max(usual)
    found = [
        _own_stretch(x, path, size, radii[path], bool(is_meeting[path[-1]]), has_ball)
        for path, size in zip(paths, usual, strict=True)
    ]
    own = [each for each in found if each is not None]
    if len(own) < len(paths):
        return False
    where = _common_place(shape, x, own, is_one=len(middle) == 1)
    if where is None:
        return False
    meet, power = where
    laid: list[tuple[np.ndarray, np.ndarray]] = []  # the nodes of each branch, and their places
    for path, size, along, start, last, _, axis in own:
        # The axes may meet in a branch's own stretch, as in the trunk of a fork: then it is laid until behind that.
        ahead = float(unit(axis[1]) @ (meet - axis[2]))
        begin = max(start, ahead + BEGIN * size)
        if begin > last:
            return False
        num = int(np.searchsorted(along, begin)) + 1
        share = (along[:num] / along[num - 1])[:, None]
        place = np.polynomial.polynomial.polyval(ahead + share * (along[num - 1] - ahead), axis[::-1], tensor=False)
        laid.append((path[:num], place + (1 - share) ** power * (meet - place[0])))
    is_open = is_inside(shape, np.repeat(meet[None], len(own), axis=0), x[[nodes[-1] for nodes, _ in laid]])
    if is_held[np.concatenate([middle, *(nodes for nodes, _ in laid)])].any() or not is_open.all():
        return False
    for nodes, places in laid:
        x[nodes] = places
    x[middle] = meet
    return True


def _own_stretch(
    x: np.ndarray, path: np.ndarray, size: float, radii: np.ndarray, is_link: bool, has_ball: bool
) -> OwnStretch | None:
    """Where the branch ``path`` (k,), with ``radii`` (k,), usually ``size``, is on its own, and its axis there. It may
    be a link, which ends at a junction, and begin in a ball. None if it is too short, or too bent for that ball."""
    along = arc_length(x[path])
    # Behind that ball: in there, the curve runs to its middle.
    in_ball = np.flatnonzero(has_ball & (radii[: len(path) // 2] > BALL * size))
    is_beyond = np.arange(len(path)) > in_ball.max(initial=-1)
    is_thick = is_beyond & (radii >= KEPT * size)
    is_own = is_beyond & keeps_radius(along, radii, size) & (along <= along[is_thick.argmax()] + LATER * size)
    is_own = is_own if is_own.any() else is_thick  # a short one, or one with a neck
    start, last = along[is_own.argmax()] + BEGIN * size, along[-1] - is_link * BEGIN * size
    # A line is prolonged by no more than its own length, so that a limb that is curved does not count as straight.
    ball = float(along[in_ball.max(initial=0)])
    length = min(max(AXIS * size, ball), last - start)
    if size <= 0 or length <= ROUNDING * size:  # most of it is on the surface, or it is too short
        return None
    # Through two points of its first straight stretch, as an oblique branch bends until it is on its axis. If none is
    # straight, through three of the first.
    shift = np.arange(0.0, min(LATER * size, last - start - length) + 1e-12, BEGIN * size / 2)
    place = start + shift[:, None] + length * np.array([0.0, 0.5, 1.0])
    three = at(x[path], along, place.ravel()).reshape(-1, 3, 3)
    bent = np.linalg.norm(three[:, 1] - (three[:, 0] + three[:, 2]) / 2, axis=1)
    is_straight = bent <= BENT * size
    first = int(is_straight.argmax())
    is_bent = not is_straight[first]
    if is_bent and length < ball:
        return None
    step = slice(None, None, 1 if is_bent else 2)
    axis = np.pad(np.polyfit(place[first][step], three[first][step], 1 + is_bent), ((1 - is_bent, 0), (0, 0)))
    return OwnStretch(path, size, along, start + shift[first], last, ball, axis)


def _common_place(
    shape: Enclosure, x: np.ndarray, own: list[OwnStretch], is_one: bool
) -> tuple[np.ndarray, int] | None:
    """Where the branches begin: the place (3,) nearest to all of their axes, and the power with which the distance
    from its axis falls along a branch. ``is_one`` says that it is for one junction. None if axes do not meet.

    Axes that are parallel, or pass each other, meet nowhere. But in a ball that is larger than all branches they come
    together nevertheless. With T m = q for the place nearest to them, and c for the middle of the ball, it is where
    |T m - q|^2 + s^2 |m - c|^2 is least: near c in the directions in which the axes do not tell, and nearest in others.
    """
    size = np.array([each.size for each in own])
    _, slope, p = np.array([each.axis for each in own]).swapaxes(0, 1)
    d = unit(slope)
    flat = np.eye(3) - d[:, :, None] * d[:, None, :]
    total, push = flat.sum(axis=0), np.einsum("bij,bj->i", flat, p)
    if np.linalg.eigvalsh(total)[0] >= SPREAD:
        meet = np.linalg.solve(total, push)
        if (np.linalg.norm(np.einsum("bij,bj->bi", flat, meet - p), axis=1) <= APART * size).all():
            return meet, 1
    if not is_one:
        return None
    spots = np.concatenate([at(x[each.path], each.along, np.linspace(0, each.ball, SPOTS)) for each in own])
    deepest = spots[shape.approximate_clearance(spots)[0].argmax()]
    meet = np.linalg.solve(total @ total + SPREAD**2 * np.eye(3), total @ push + SPREAD**2 * deepest)
    return (meet, 2) if shape.approximate_clearance(meet[None])[0][0] > BALL * size.max() else None
