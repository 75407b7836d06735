"""Junctions: where the axes of their branches meet.

Near a junction several limbs are one, and the nodes there follow what is wide: the flow's junction of a narrow fork is
in front of the crotch, where its branches bend around it. Farther on, where a limb is on its own and has its usual
radius, its branch is on its axis. A parabola continues that, as a function of the arc length; its tangent at the
junction is the line p + t d. The junction is the point m nearest to these lines, and, in the directions in which they
do not tell, to the middle c of the largest ball there:

    minimise  sum over the branches |(I - d d^T) (m - p)|^2 + HOLD |m - c|^2.

Of limbs that meet in each other, two are about as thick as the largest ball there, as a trunk is on both sides of a
branch. In a wider body, as a palm, lines pass by chance, and its sections tell more: lines must meet the better, the
thinner the limbs. Where all are thin beside the ball, as the neurites of a soma, the junction is its middle.

The flow leaves the junction of a side branch anywhere in its trunk. Where the trunk is too short for an axis between
two of them, its axis is that of the thickest branch beyond, if that is as thick.
"""

import itertools
from typing import NamedTuple

import numpy as np
from numpy.polynomial.polynomial import polyval

from msf_jax.curve import branches
from msf_jax.limbs.ends import SPACING
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import arc_length, unit
from msf_jax.topology import graphs

# Lengths are in the usual radius of the branch, if nothing else is said.
# Least radius on the axis: triangles as long as it is thick make 0.85. A trunk keeps this share of its radius beyond a
# junction; a junction with a smaller ball than that is at a wall.
KEPT = 0.75
AXIS = 2.1  # the length of the part that gives the axis, a radius behind the start of a stretch of at least `SPACING`
HOLD = 0.003  # weight of the middle of the ball: squared sines of the angles of lines that do not tell
APART = 0.35  # lines meet if one point is that near to all, times the second largest radius over that of the ball
THIN = 0.3  # of the radius of their ball: branches that leave a junction to it

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
    branches. degree: (N,)."""

    def __init__(self, x: np.ndarray, edges: np.ndarray, radii: np.ndarray):
        traced = branches.paths_of(x, edges, np.zeros(len(x), dtype=bool))
        self.paths, self.degree = [each.nodes for each in traced], graphs.degrees(len(x), edges)
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
        if size <= 0 or length.max(initial=0.0) < SPACING * size:
            return None
        chosen = int((length >= min(AXIS * size, length.max())).argmax())
        start = min(begin[chosen] + size, max(begin[chosen], end[chosen] - size))
        row = np.flatnonzero((along >= start) & (along <= min(start + AXIS * size, end[chosen])))
        if not len(row) or along[row[-1]] - along[row[0]] < SPACING * size / 2:
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
    at one place, with the stretch between. A junction stays where a branch has no line, or a node on the way is held,
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
    at_node = {
        node: [(path, axis or _beyond(x, radii, path, at_node)) for path, axis in own] for node, own in at_node.items()
    }
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


def _beyond(
    x: np.ndarray, radii: np.ndarray, path: np.ndarray, at_node: dict[int, list[tuple[np.ndarray, Axis | None]]]
) -> Axis | None:
    """The axis of a stretch ``path`` (k,) between junctions that is too short for its own: the line of the stretches
    that continue it, each the thickest from the end of the one before, up to the first with an axis. None if there is
    none."""
    along, here = arc_length(x[path]), path
    length = along[-1]
    for _ in at_node:
        ahead = [each for each in at_node.get(int(here[-1]), []) if not np.array_equal(each[0], here[::-1])]
        if not ahead:
            return None
        here, axis = max(ahead, key=lambda each: usual_radius(each[0], radii))
        if usual_radius(here, radii) < KEPT * usual_radius(path, radii):
            return None
        if axis is not None:
            place, direction = axis.parabola[:2]
            line = np.stack([place - length * direction, direction, 0 * place])  # in the arc length from this junction
            return Axis(path, along, axis.size, len(path) - 1, line)
        length += arc_length(x[here])[-1]
    return None  # short stretches all around


def _put(
    shape: Enclosure, x: np.ndarray, middle: np.ndarray, axes: list[Axis], is_held: np.ndarray, radii: np.ndarray
) -> bool:
    """Put the nodes ``middle`` (m,), a junction, or two and the stretch between, where the lines of their branches
    meet, and those from there to each branch's axis on the way. ``x`` (N, 3) changes only if True is returned."""
    near = np.concatenate([middle, *(each.path[: each.first] for each in axes)])
    sizes, widest = np.array([each.size for each in axes]), near[radii[near].argmax()]
    meet, off = nearest_to_lines(np.array([each.parabola[:2] for each in axes]), x[widest])
    if sizes.max() < THIN * radii[widest]:
        meet, off = middle_of_ball(shape, x[widest]), 0 * off
    # Lines that pass each other tell less than sections beyond, but more than a junction in front of a crotch, whose
    # ball is smaller than those of its branches, or at the wall of a trunk, whose two sides are about as thick.
    *_, second, first = np.sort(sizes).tolist()
    usual = second if second >= KEPT * first else sizes.min()
    is_at_wall = len(middle) == 1 and radii[middle[0]] < KEPT * usual
    share = min(second / radii[widest], 1.0)
    # Where a branch bends on the way there, its line is as much less sure, up to twice the limit; a thin limb's hardly.
    bend = [np.linalg.norm(each.parabola[2]) * each.along[each.first] ** 2 for each in axes]
    more = sizes / radii[widest] * np.minimum(bend, APART * sizes)
    if (off > APART * share * sizes + more).any() and not is_at_wall:
        return False
    laid: list[tuple[np.ndarray, np.ndarray]] = []
    for path, along, size, first, parabola in axes:
        # The lines may meet beyond the first node on an axis, as in the trunk of a fork: it is laid until behind that.
        ahead = float(unit(parabola[1]) @ (meet - parabola[0]))
        last = min(int(np.searchsorted(along, max(along[first], ahead + size))), len(path) - 1)
        if along[last] <= ahead:
            return False
        nodes, share = path[: last + 1], (along[: last + 1] / along[last])[:, None]
        place = polyval(ahead + share * (along[last] - ahead), parabola, tensor=False)
        laid.append((nodes, place + (1 - share) * (meet - place[0]) + share * (x[path[last]] - place[-1])))
    stops = np.array([nodes[-1] for nodes, _ in laid])
    is_open = shape.holds(np.repeat(meet[None], len(laid), axis=0), x[stops])
    if is_held[np.concatenate([middle, *(nodes for nodes, _ in laid)])].any() or not is_open.all():
        return False
    for nodes, places in laid:
        x[nodes] = places
    x[middle] = meet
    return True


def middle_of_ball(shape: Enclosure, middle: np.ndarray) -> np.ndarray:
    """The middle (3,) of the largest ball in the solid, from that around ``middle`` (3,) on."""
    radius = float(shape.clearance(middle[None])[0])
    step, least = radius / 2, radius / 64
    for _ in range(32):  # rounds, each of at most half of the first radius
        around = middle + step * WAYS
        clearance = shape.clearance(around)
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
