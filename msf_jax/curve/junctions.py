"""Junctions: where the axes of their branches meet.

Near a junction several limbs are one, and the nodes there follow what is wide: the flow's junction of a narrow fork is
in front of the crotch, where its branches bend around it. Farther on, where a limb is on its own and has its usual
radius, its branch is on its axis. A parabola continues that, as a function of the arc length; its tangent at the
junction is the line p + t d. The junction is the point m nearest to these lines, and, in the directions in which they
do not tell, to the middle c of the largest ball there:

    minimise  sum over the branches |(I - d d^T) (m - p)|^2 + HOLD |m - c|^2.

Where all branches are thin beside the ball, as the neurites of a soma, their lines are too far away to tell its middle.

A side branch, much thinner than its trunk, begins where its line meets its trunk: the flow leaves it anywhere in there.
"""

import itertools
from typing import NamedTuple

import numpy as np
from numpy.polynomial.polynomial import polyval

from msf_jax.curve import branches
from msf_jax.inside.containment import is_inside
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import arc_length, cross, nearest_to_ray, unit
from msf_jax.topology import graphs

# Lengths are in the usual radius of the branch, if nothing else is said.
KEPT = 0.75  # least radius on the axis; triangles as long as it is thick make 0.85
AXIS = 2.1  # the length of the part that gives the axis, which begins a radius behind the start of a stretch
SHORTEST = 0.5  # the least length of such a stretch; one that is shorter than that part has a line for its axis
HOLD = 0.003  # weight of the middle of the ball: squared sines of the angles of lines that do not tell
APART = 0.35  # the lines of two junctions meet if one point is that near to all
THIN = 0.6  # of its trunk's radius: the largest side branch; half of that, of its ball's, leaves a junction to the ball
REACH = 4.0  # of its trunk's radius: so far a side branch runs in its trunk at most, at 15 degrees or more
OFF = 0.2  # of its trunk's radius: the largest distance at which a line meets its axis; on a plant's stem it has 0.15
SHARED = 0.5  # side branches that begin that near to a junction of their trunk begin there

WAYS = unit(np.array(list(itertools.product((-1.0, 0.0, 1.0), repeat=3))))  # (27, 3) all around, and none


class Axis(NamedTuple):
    """The axis of a branch. path: (k,) its nodes from its junction. along: (k,) their arc lengths. size: its usual
    radius. first: the position in ``path`` of the first node on the axis. parabola: (3, 3) the coefficients of the
    axis, as a function of the arc length, the constant first."""

    path: np.ndarray
    along: np.ndarray
    size: float
    first: int
    parabola: np.ndarray


class Branches:
    """The branches of a curve ``(x (N, 3), edges (E, 2))`` with balls of ``radii`` (N,) around its nodes. paths: of all
    branches. usual: the usual radius of each. degree: (N,)."""

    def __init__(self, x: np.ndarray, edges: np.ndarray, radii: np.ndarray):
        traced = branches.paths_of(x, edges, np.zeros(len(x), dtype=bool))
        self.paths, self.degree = [each.nodes for each in traced], graphs.degrees(len(x), edges)
        self.usual = [usual_radius(path, radii) for path in self.paths]
        self._x, self._radii, self._is_alone = x, radii, np.ones(len(x), dtype=bool)
        if traced:
            tangent = unit(branches.chords(x, traced, radii) @ x)
            self._is_alone = branches.clear_of_others(x, traced, tangent, radii, radii) > 0.5

    def axis(self, path: np.ndarray) -> Axis | None:
        """The axis of a branch ``path`` (k,) from its junction: of the first stretch on its own that is long enough, or
        else of the longest. None if that is too short."""
        along, size = arc_length(self._x[path]), usual_radius(path, self._radii)
        is_own = self._is_alone[path] & (self._radii[path] >= KEPT * size)
        change = np.flatnonzero(np.diff(is_own, prepend=False, append=False)).reshape(-1, 2)
        begin, end = along[change[:, 0]], along[change[:, 1] - 1]
        length = end - begin
        if size <= 0 or length.max(initial=0.0) < SHORTEST * size:
            return None
        chosen = int((length >= min(AXIS * size, length.max())).argmax())
        start = min(begin[chosen] + size, max(begin[chosen], end[chosen] - size))
        row = np.flatnonzero((along >= start) & (along <= min(start + AXIS * size, end[chosen])))
        if not len(row) or along[row[-1]] - along[row[0]] < SHORTEST * size / 2:
            return None
        # With u = s / size from the first node on, and back to powers of s. A short stretch does not tell its bend.
        degree = 2 if end[chosen] - start >= AXIS * size and len(row) > 3 else 1
        power = np.vander((along[row] - along[row[0]]) / size, degree + 1, increasing=True)
        fit = np.linalg.lstsq(power, self._x[path[row]])[0]
        p, d, q = np.pad(fit, ((0, 2 - degree), (0, 0))) / size ** np.arange(3)[:, None]
        s = along[row[0]]
        return Axis(path, along, size, int(row[0]), np.stack([p - s * d + s**2 * q, d - 2 * s * q, q]))


def usual_radius(path: np.ndarray, radii: np.ndarray) -> float:
    """The median radius of the nodes within a branch ``path`` (k,); of a single edge, the smaller radius."""
    return float(np.median(radii[path[1:-1]]) if len(path) > 2 else radii[path].min())


def met(shape: Enclosure, x: np.ndarray, edges: np.ndarray, is_held: np.ndarray, radii: np.ndarray) -> np.ndarray:
    """The nodes (N, 3) with junctions where the lines of their branches meet, and the nodes from there to each branch's
    axis on the way. Where rods cross, the flow has two junctions: if the lines of all branches of both meet, these are
    at one place, with the stretch between. A junction stays where a branch has no axis, or a node on the way is held,
    and where the lines do not meet, unless it is at a wall."""
    x, curve = x.copy(), Branches(x, edges, radii)
    at_node: dict[int, list[tuple[np.ndarray, Axis | None]]] = {}
    between: dict[tuple[int, int], list[np.ndarray]] = {}
    for path in curve.paths:
        one, other = int(path[0]), int(path[-1])
        for each in (path, path[::-1]):
            if curve.degree[each[0]] > 2:
                at_node.setdefault(int(each[0]), []).append((each, curve.axis(each)))
        if one != other and min(curve.degree[one], curve.degree[other]) > 2:
            between.setdefault((min(one, other), max(one, other)), []).append(path)
    groups = [(ends, links[0]) for ends, links in between.items() if len(links) == 1]
    groups.sort(key=lambda group: arc_length(x[group[1]])[-1])  # the nearest first: the order of nodes does not decide
    groups += [((node, node), np.array([node])) for node in at_node]
    is_done = np.zeros(len(x), dtype=bool)
    for ends, middle in groups:
        if not is_done[list(ends)].any():
            own = [each for node in dict.fromkeys(ends) for each in at_node[node]]
            if ends[0] != ends[1]:  # without the stretch between
                own = [each for each in own if {int(each[0][0]), int(each[0][-1])} != {*ends}]
            axes = [axis for _, axis in own if axis is not None]
            if len(axes) == len(own):
                is_done[middle] = _put(shape, x, middle, axes, is_held, radii)
    return x


def _put(
    shape: Enclosure, x: np.ndarray, middle: np.ndarray, axes: list[Axis], is_held: np.ndarray, radii: np.ndarray
) -> bool:
    """Put the nodes ``middle`` (m,), a junction, or two and the stretch between, where the lines of their branches
    meet, and those from there to each branch's axis on the way. ``x`` (N, 3) changes only if True is returned."""
    near = np.concatenate([middle, *(each.path[: each.first] for each in axes)])
    sizes, widest = np.array([each.size for each in axes]), near[radii[near].argmax()]
    meet, off = nearest_to_lines(np.array([each.parabola[:2] for each in axes]), x[widest])
    if sizes.max() < THIN / 2 * radii[widest]:
        meet, off = middle_of_ball(shape, x[widest]), 0 * off
    # Lines that pass each other tell less than sections beyond, but more than a junction in front of a crotch, whose
    # ball is smaller than those of its branches.
    is_at_wall = len(middle) == 1 and radii[middle[0]] < KEPT * sizes.min()
    if (off > APART * sizes).any() and not is_at_wall:
        return False
    laid: list[tuple[np.ndarray, np.ndarray]] = []
    for path, along, size, first, parabola in axes:
        # The lines may meet beyond the first node on an axis, as in the trunk of a fork: it is laid until behind that.
        ahead = float(unit(parabola[1]) @ (meet - parabola[0]))
        last = int(np.searchsorted(along, max(along[first], ahead + size)))
        if last == len(path):
            return False
        nodes, share = path[: last + 1], (along[: last + 1] / along[last])[:, None]
        place = polyval(ahead + share * (along[last] - ahead), parabola, tensor=False)
        laid.append((nodes, place + (1 - share) * (meet - place[0]) + share * (x[path[last]] - place[-1])))
    stops = np.array([nodes[-1] for nodes, _ in laid])
    is_open = is_inside(shape, np.repeat(meet[None], len(laid), axis=0), x[stops])
    if is_held[np.concatenate([middle, *(nodes for nodes, _ in laid)])].any() or not is_open.all():
        return False
    for nodes, places in laid:
        x[nodes] = places
    x[middle] = meet
    return True


def middle_of_ball(shape: Enclosure, middle: np.ndarray) -> np.ndarray:
    """The middle (3,) of the largest ball in the solid, from that around ``middle`` (3,) on."""
    radius = float(shape.approximate_clearance(middle[None])[0][0])
    step, least = radius / 2, radius / 64
    for _ in range(32):  # rounds, each of at most half of the first radius
        around = middle + step * WAYS
        clearance = shape.approximate_clearance(around)[0]
        if clearance.max() > radius:
            middle, radius = around[clearance.argmax()], float(clearance.max())
        elif (step := step / 2) <= least:
            break
    return middle


def nearest_to_lines(line: np.ndarray, ball: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The point (3,) nearest to each ``line`` (B, 2, 3), a place and a direction, held at ``ball`` (3,) where these do
    not tell; and its distances (B,) from them."""
    place, direction = line[:, 0], unit(line[:, 1])
    flat = np.eye(3) - direction[:, :, None] * direction[:, None, :]
    push = np.einsum("bij,bj->i", flat, place) + HOLD * ball
    meet = np.linalg.solve(flat.sum(axis=0) + HOLD * np.eye(3), push)
    return meet, np.linalg.norm(np.einsum("bij,bj->bi", flat, meet - place), axis=1)


def attached(
    shape: Enclosure, x: np.ndarray, edges: np.ndarray, is_held: np.ndarray, radii: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """The curve with each side branch on a straight line from its axis to where that meets its trunk, at a new node:
    nodes (M, 3), new ones last, and edges (E, 2)."""
    x, radii = x.copy(), radii.copy()
    sides, is_trunk = side_branches(x, edges, is_held, radii)
    for side in sides:
        path, first, found = side.path, side.first, meeting(side, x, edges, is_trunk, radii)
        if found is None:
            continue
        # Branches that begin at one place share its node.
        nodes = np.setdiff1d(edges[is_trunk][np.bincount(edges.ravel())[edges[is_trunk]] > 2], path)
        away = np.linalg.norm(x[nodes] - found.place, axis=1)
        is_shared, new, meet = bool((away < SHARED * side.size).any()), len(x), found.place
        if is_shared:
            new = int(nodes[away.argmin()])
            meet = x[new]
        if not is_inside(shape, meet[None], x[path[first]][None])[0]:
            continue
        x[path[1 : first + 1]] = meet + np.linspace(0, 1, first + 1)[1:, None] * (x[path[first]] - meet)
        gone = np.flatnonzero(_is_first(edges, path)).tolist()
        added, is_added = [[new, int(path[1])]], [bool(is_trunk[gone].any())]
        if not is_shared:
            x, radii = np.append(x, meet[None], axis=0), np.append(radii, found.ball)
            gone.append(found.edge)
            added += [[int(edges[found.edge, 0]), new], [new, int(edges[found.edge, 1])]]
            is_added += [True, True]
        edges = np.concatenate([np.delete(edges, gone, axis=0), added])
        is_trunk = np.append(np.delete(is_trunk, gone), is_added)
    return x, edges


def side_branches(
    x: np.ndarray, edges: np.ndarray, is_held: np.ndarray, radii: np.ndarray
) -> tuple[list[Axis], np.ndarray]:
    """The axes of the thin side branches, those that fork themselves first; and which ``edges`` (E,) may be a trunk's:
    those of no thin branch that ends in a leaf."""
    curve = Branches(x, edges, radii)
    degree = curve.degree
    at_node: dict[int, list[float]] = {}
    for path, size in zip(curve.paths, curve.usual, strict=True):
        for node in path[[0, -1]].tolist():
            at_node.setdefault(node, []).append(size)
    # A trunk passes a junction, so two branches are as thick there: the second thickest counts.
    trunk = {node: sorted(sizes)[-2] if len(sizes) > 1 else 0.0 for node, sizes in at_node.items()}
    in_side, sides = np.zeros(len(x), dtype=bool), list[tuple[bool, Axis]]()
    for path, size in zip(curve.paths, curve.usual, strict=True):
        first, last = sorted(path[[0, -1]].tolist(), key=lambda node: (degree[node] == 1, -trunk[node]))
        is_leaf = degree[last] == 1
        is_link = degree[last] > 2 and THIN * trunk[last] <= size  # no bridge from trunk to trunk
        if (is_leaf or is_link) and degree[first] > 2 and size < THIN * trunk[first]:
            path = path if path[0] == first else path[::-1]
            in_side[path[1:]] |= is_leaf  # a side branch that forks is a trunk, too
            axis = curve.axis(path)
            if axis is not None and not is_held[path[: axis.first + 1]].any():
                sides.append((bool(is_leaf), axis))
    is_trunk = ~(in_side[edges[:, 0]] | in_side[edges[:, 1]])
    return [axis for _, axis in sorted(sides, key=lambda side: side[0])], is_trunk


class Meeting(NamedTuple):
    """Where the line of a side branch meets its trunk. edge: the number of the trunk's edge. place: (3,). ball: the
    trunk's radius there."""

    edge: int
    place: np.ndarray
    ball: float


def meeting(side: Axis, x: np.ndarray, edges: np.ndarray, is_trunk: np.ndarray, radii: np.ndarray) -> Meeting | None:
    """Where the line of the side branch meets the trunk, of those of ``edges`` (E, 2) that may be one and that it does
    not lead to; ``x`` (N, 3), ``radii`` (N,): nodes. None if it passes all of them, is as thick, leaves the trunk far
    away, or is nearly parallel to it."""
    part = graphs.labels(len(x), *edges[~_is_first(edges, side.path)].T)
    numbers = np.flatnonzero(is_trunk & (part[edges] != part[side.path[1]]).all(axis=1))
    trunk, start = edges[numbers], side.along[side.first]
    heading = unit(side.parabola[1] + 2 * start * side.parabola[2])
    share, place, off = nearest_to_ray(x[trunk], polyval(start, side.parabola), -heading)
    ball = (1 - share) * radii[trunk[:, 0]] + share * radii[trunk[:, 1]]
    along = np.linalg.norm(place - x[side.path[side.first]], axis=1)
    is_by = (off < OFF * ball) & (along < REACH * ball)
    # Legs that are nearly parallel to their trunk meet its axis anywhere.
    sine = np.linalg.norm(cross(heading, unit(x[trunk[:, 1]] - x[trunk[:, 0]])), axis=1)
    is_near = is_by & (side.size < THIN * ball) & (sine > 1 / REACH)
    if not is_near.any():  # also where all branches end at one junction, and there is no trunk
        return None
    # It ends at the first stretch of trunk that it comes near to, at the nearest place there.
    stretch = graphs.labels(len(x), *trunk[is_by].T)[trunk[:, 0]]
    is_near &= stretch == stretch[np.where(is_near, along, np.inf).argmin()]
    best = int(np.where(is_near, off / np.maximum(ball, 1e-300), np.inf).argmin())
    return Meeting(int(numbers[best]), place[best], float(ball[best]))


def _is_first(edges: np.ndarray, path: np.ndarray) -> np.ndarray:
    """(E,) which edge is the first one of the branch ``path`` (k,)."""
    return (np.sort(edges, axis=1) == np.sort(path[:2])).all(axis=1)
