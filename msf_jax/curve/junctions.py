"""Junctions of tubes: where the axes of their branches meet.

Near a junction sections are no guide, and the nodes there follow what is wide: the flow's junction of a narrow fork is
in front of the crotch, where its branches bend around it. Farther on, where each branch has its usual radius, it is on
its axis. A line continues that, or a parabola if it is bent, with the tangent p + t d at the place of the junction. The
point m nearest to all tangents,

    minimise  sum over the branches |(I - d d^T) (m - p)|^2,

is the junction, if it is nearly on each, and sees the places where the branches are on their axes. Limbs that leave a
large ball side by side begin near its middle, and each turns into its axis gradually.
"""

from itertools import pairwise
from typing import NamedTuple

import numpy as np

from msf_jax.curve.side_branches import CLEAR, KEPT, keeps_radius
from msf_jax.inside.containment import is_inside
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import ROUNDING, arc_length, at, unit
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
