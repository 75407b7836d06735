"""The axes of a plant, as botanists count them, and cylinders along them, as models of trees have them.

An axis goes on through a fork: of the branches that leave it, the thickest and straightest continues the axis. That is
the one with the largest

    r (1 + cos a) / 2,

r its mean radius, a its angle to the branch before the fork, 0 if straight. The others begin axes of the next order.
The main axis has order 0. The Strahler order of a branch that ends in a tip is 1. Before a fork it is the largest after
the fork, or one more if several have that (Strahler 1957).
"""

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from scipy import spatial

from msf_jax.skeleton.centrelines import table
from msf_jax.skeleton.centrelines.table import Columns
from msf_jax.solid.geometry import arc_length, at, unit

if TYPE_CHECKING:
    from msf_jax.skeleton.skeleton import Skeleton

INSERTION_REACH = 3.0  # mean radii of the parent: length, in one direction, over which directions are taken


class Axis(NamedTuple):
    """branches: their numbers, from the base to the tip. nodes: along all of them. parent: the number of the axis that
    it leaves, or -1. order: 0 of a main axis. position: length of the parent up to the fork."""

    branches: list[int]
    nodes: np.ndarray
    parent: int
    order: int
    position: float


class Plant(NamedTuple):
    """All axes, parents first, those of a parent from its base to its tip. strahler: (B,) the Strahler order of each
    branch. paths: the nodes of each branch, away from the root."""

    axes: list[Axis]
    strahler: np.ndarray
    paths: list[np.ndarray]


def axes_of(skeleton: "Skeleton") -> Plant:
    """The axes of the branches of ``skeleton``, from its roots, or from the tips of its thickest limbs."""
    paths, parent = table.oriented(skeleton)
    degree = np.bincount(skeleton.edges.ravel(), minlength=len(skeleton.vertices))
    radius = np.array([table.radii_without_ends(skeleton, nodes, degree)[0] for nodes in paths])
    angle = np.nan_to_num(table.fork_angles(skeleton, paths, parent))
    worth = radius * (1 + np.cos(np.radians(angle))) / 2
    after: list[list[int]] = [[] for _ in paths]
    for number, above in enumerate(parent.tolist()):
        if above >= 0:
            after[above].append(number)
    axes: list[Axis] = []
    waiting = [(number, -1, 0, 0.0) for number in np.flatnonzero(parent < 0).tolist()]
    while waiting:
        number, above, order, position = waiting.pop(0)
        own, leaving = [number], []
        along = arc_length(skeleton.vertices[paths[number]])[-1]
        while after[own[-1]]:
            last = own[-1]
            # A root in the middle of a branch has branches at both of its ends.
            onward = [each for each in after[last] if paths[each][0] == paths[last][-1]]
            goes_on = max(onward, key=lambda each: worth[each], default=-1)
            leaving += [(each, len(axes), order + 1, float(along)) for each in onward if each != goes_on]
            leaving += [(each, len(axes), order + 1, 0.0) for each in after[last] if each not in onward]
            if goes_on < 0:
                break
            own.append(goes_on)
            along += arc_length(skeleton.vertices[paths[goes_on]])[-1]
        nodes = np.concatenate([paths[own[0]], *(paths[each][1:] for each in own[1:])])
        axes.append(Axis(own, nodes, above, order, position))
        waiting += sorted(leaving, key=lambda each: each[3])
    return Plant(axes, _strahler(after, parent), paths)


def _strahler(after: list[list[int]], parent: np.ndarray) -> np.ndarray:
    found = np.ones(len(parent), dtype=np.int64)
    order, queue = [], np.flatnonzero(parent < 0).tolist()
    while queue:
        order.append(queue.pop())
        queue += after[order[-1]]
    for number in reversed(order):
        if after[number]:
            beyond = found[after[number]]
            found[number] = beyond.max() + (np.sum(beyond == beyond.max()) > 1)
    return found


def axis_columns(skeleton: "Skeleton") -> Columns:
    """The columns of the table of axes."""
    axes, strahler, paths = axes_of(skeleton)
    num, degree = len(axes), np.bincount(skeleton.edges.ravel(), minlength=len(skeleton.vertices))
    volume = table.branch_volumes(skeleton, len(paths))
    size = np.array([table.radii_without_ends(skeleton, axis.nodes, degree)[:2] for axis in axes]).reshape(num, 2)
    along = np.array([arc_length(skeleton.vertices[axis.nodes])[-1] for axis in axes])
    found = [_insertion(skeleton, axes, axis, size[axis.parent, 0]) for axis in axes]
    position, angle, length = np.array(found).reshape(num, 3).T
    above = np.array([axis.parent for axis in axes], dtype=np.int64)
    position += np.where(above >= 0, (length - along)[above], 0.0)  # from where the parent itself begins
    internode, last = np.full(num, np.nan), dict[int, float]()
    for number in np.argsort(position, kind="stable").tolist():
        mother, place = axes[number].parent, float(position[number])
        if mother >= 0:
            internode[number] = place - last.get(mother, 0.0)
            last[mother] = place
    return {
        "axis": np.arange(num),
        "parent": above,
        "order": np.array([axis.order for axis in axes], dtype=np.int64),
        "strahler": np.array([strahler[axis.branches[0]] for axis in axes], dtype=np.int64),
        "start": np.array([axis.nodes[0] for axis in axes], dtype=np.int64),
        "end": np.array([axis.nodes[-1] for axis in axes], dtype=np.int64),
        "position": position,
        "internode": internode,
        "angle": angle,
        "length": length,
        "chord": np.array([np.linalg.norm(np.diff(skeleton.vertices[axis.nodes[[0, -1]]], axis=0)) for axis in axes]),
        "mean_radius": size[:, 0],
        "least_radius": size[:, 1],
        "volume": np.array([volume[axis.branches].sum() for axis in axes]),
    }


def _insertion(skeleton: "Skeleton", axes: list[Axis], axis: Axis, size: float) -> tuple[float, float, float]:
    """Where ``axis`` begins on its parent, of the mean radius ``size``: the length of the parent up to there, the angle
    between both in degrees, and the length of the axis from there; NaN and its length for a main axis.

    Within its parent the curve bends towards the fork. So its first part outside is extended backwards, straight, to
    where it is nearest to the parent."""
    points, radii = skeleton.vertices[axis.nodes], skeleton.radii[axis.nodes]
    along = arc_length(points)
    if axis.parent < 0 or along[-1] == 0:
        return np.nan, np.nan, float(along[-1])
    mother = skeleton.vertices[axes[axis.parent].nodes]
    above = arc_length(mother)
    near = np.abs(above - axis.position) <= along[-1] + size
    away = spatial.KDTree(mother[near]).query(points)[0]
    outside = np.flatnonzero(away > size + radii)
    begin = float(along[outside[0]]) if len(outside) else 0.0
    end = min(begin + INSERTION_REACH * size, float(along[-1]))
    base, ahead = at(points, along, np.array([begin, end if end > begin else along[-1]]))
    onward = unit(ahead - base)
    t, foot = _nearest_to_ray(base, -onward, mother, above)
    reach = INSERTION_REACH * size
    before, after = at(mother, above, np.clip([t - reach, t + reach], 0.0, above[-1]))
    angle = np.degrees(np.arccos(np.clip(onward @ unit(after - before), -1.0, 1.0)))
    return t, float(angle), float(along[-1] - begin + np.linalg.norm(base - foot))


def _nearest_to_ray(
    start: np.ndarray, onward: np.ndarray, line: np.ndarray, along: np.ndarray
) -> tuple[float, np.ndarray]:
    """Where a ``line`` (n, 3) is nearest to a ray: its length up to there, ``along`` (n,) at its nodes, and the point.

    For a point x of an edge the ray's nearest one is at (x - start) . onward, or at its start; the distance is convex
    along the edge, and its minimum over the whole line of the ray is that of a quadratic function."""
    a, step = line[:-1] - start, np.diff(line, axis=0)
    # Across the ray, the distance from edge a + s step is |across(a) + s across(step)|.
    across_a, across = (each - (each @ onward)[:, None] * onward for each in (a, step))
    s = -np.einsum("ij,ij->i", across_a, across) / np.maximum(np.einsum("ij,ij->i", across, across), 1e-300)
    points = a + np.clip(s, 0.0, 1.0)[:, None] * step
    ahead = np.maximum(points @ onward, 0.0)
    best = int(np.linalg.norm(points - ahead[:, None] * onward, axis=1).argmin())
    return float(along[best] + np.linalg.norm(points[best] - a[best])), points[best] + start


def cylinder_columns(skeleton: "Skeleton") -> Columns:
    """The columns of the table of cylinders: one along each edge, by the names of TreeQSM as rTwig reads them.

    Numbers of cylinders and branches begin with 1, and 0 is none. ``UnmodRadius`` is the mean of the radii at both
    ends. In ``radius`` the part of an axis within its parent is as thick as the axis is outside.
    """
    axes = axes_of(skeleton).axes
    first = np.cumsum([0, *(len(axis.nodes) - 1 for axis in axes)])
    a, b, radius = [], [], []
    parent, extension = np.zeros(first[-1], dtype=np.int64), np.zeros(first[-1], dtype=np.int64)
    into: dict[tuple[int, int], int] = {}  # the cylinder of an axis that ends in a node
    for number, axis in enumerate(axes):
        nodes, mine = axis.nodes, np.arange(first[number], first[number + 1])
        a.append(nodes[:-1])
        b.append(nodes[1:])
        own, along = skeleton.radii[nodes], arc_length(skeleton.vertices[nodes])
        if axis.parent >= 0:
            outside = np.flatnonzero(along > own[0])
            own = np.where(along <= own[0], np.minimum(own, own[outside[0]] if len(outside) else own[-1]), own)
        radius.append((own[:-1] + own[1:]) / 2)
        into |= {(number, int(node)): int(k) + 1 for node, k in zip(nodes[1:], mine, strict=True)}
        if len(mine):
            parent[mine[1:]], extension[mine[:-1]] = mine[:-1] + 1, mine[1:] + 1
            parent[mine[0]] = into.get((axis.parent, int(nodes[0])), 0)
    ends = [np.concatenate([np.empty(0, dtype=np.int64), *nodes]) for nodes in (a, b)]
    tail, head = (skeleton.vertices[nodes] for nodes in ends)
    along = head - tail
    branch = np.repeat(np.arange(len(axes)), np.diff(first))
    return {
        "radius": np.concatenate([np.empty(0), *radius]),
        "length": np.linalg.norm(along, axis=1),
        **dict(zip(("start.x", "start.y", "start.z"), tail.T, strict=True)),
        **dict(zip(("axis.x", "axis.y", "axis.z"), unit(along).T, strict=True)),
        "parent": parent,
        "extension": extension,
        "added": np.zeros(first[-1], dtype=np.int64),
        "UnmodRadius": skeleton.radii[np.stack(ends)].mean(axis=0),
        "branch": branch + 1,
        "BranchOrder": np.array([axis.order for axis in axes], dtype=np.int64)[branch],
        "PositionInBranch": np.arange(first[-1]) - first[:-1][branch] + 1,
    }
