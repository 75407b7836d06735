"""Tables of measurements: a row for each branch, node, axis of a plant, or cylinder of a model of a tree.

Branches lead away from roots. An axis, as botanists count them, goes on through a fork: of the branches that leave the
fork, the one that continues the axis is thick, straight, and leads far. That is the one with the largest

    r (1 + cos a) / 2 l^(1/3),

r its mean radius, a its angle to the branch before the fork, 0 if straight, and l the length of the longest path beyond
the fork's ball: a stub there ends no axis. The others begin axes of the next order.
The main axis has order 0. The Strahler order of a branch that ends in a tip is 1. Before a fork it is the largest after
the fork, or one more if several have that (Strahler 1957).
"""

from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from scipy import spatial

from msf_jax.curve import branches
from msf_jax.curve.junctions import AXIS, Branches
from msf_jax.skeleton.measures import limb_sections, profile_of, section_of, tangents_of, volumes_of
from msf_jax.solid.geometry import arc_length, unit
from msf_jax.topology import graphs

if TYPE_CHECKING:
    from msf_jax.skeleton.skeleton import Skeleton

SURE = 0.3  # least weight of a section that counts, however wide beside the ball: 1.35 times the usual radius has it
ROUND = 1.2  # largest ratio of a disc's radius to the ball's at a node whose section counts, however wide on its branch

Columns = dict[str, np.ndarray]


def direct_paths(
    paths: Iterable[np.ndarray], roots: Iterable[int]
) -> tuple[list[np.ndarray], dict[int, int], list[int]]:
    """The nodes of each of ``paths``, split at roots within it, away from the ``roots``; the one before each, -1 at a
    root, for those that are connected to a root, in the order in which they are reached; and which path each is of."""
    pieces, whole, above = list[np.ndarray](), list[int](), dict[int, int]()
    at_node: dict[int, list[int]] = {}
    for number, nodes in enumerate(paths):
        inner = np.flatnonzero(np.isin(nodes[1:-1], list(roots))) + 1
        for first, last in pairwise([0, *inner.tolist(), len(nodes) - 1]):
            for end in {int(nodes[first]), int(nodes[last])}:
                at_node.setdefault(end, []).append(len(pieces))
            pieces.append(nodes[first : last + 1])
            whole.append(number)
    queue = [(int(root), -1) for root in roots]  # a junction, and the path by which it was reached
    for node, before in queue:
        for number in at_node.get(node, []):
            if number not in above:
                above[number] = before
                if pieces[number][0] != node:
                    pieces[number] = pieces[number][::-1]
                queue.append((int(pieces[number][-1]), number))
    return pieces, above, whole


class Directed(NamedTuple):
    """The branches of a curve, away from its roots. paths: the nodes of each, the end nearer to the root first. parent:
    (B,) the branch before each, -1 for those at a root. outwards: their numbers, from roots on. whole: (B,) which of
    `Skeleton.branches` each is, or is a part of. degree: (N,) the number of edges at each node."""

    paths: list[np.ndarray]
    parent: np.ndarray
    outwards: list[int]
    whole: np.ndarray
    degree: np.ndarray


def direct_branches(skeleton: "Skeleton") -> Directed:
    """The branches of ``skeleton``, in the order of its ``branches``, from its roots, or in each component from the tip
    of its thickest limb, or from its thickest junction if it has no tip. A root within a branch splits it."""
    num, roots = len(skeleton.vertices), skeleton.roots
    degree = graphs.degrees(num, skeleton.edges)
    paths = [np.array(nodes) for nodes in graphs.trace(num, skeleton.edges)]
    if not roots:
        size = np.full(num, -1.0)
        for nodes in paths:
            for end in nodes[[0, -1]]:  # tips go first: sizes of junctions are below 1
                shrunk = skeleton.radii[end] / (1 + skeleton.radii.max())
                size[end] = 1 + np.median(skeleton.radii[nodes]) if degree[end] == 1 else shrunk
        roots = branches.roots_of(num, skeleton.edges, size, None)
    pieces, above, whole = direct_paths(paths, roots)
    parent = [above.get(number, -1) for number in range(len(pieces))]
    return Directed(pieces, _whole(parent), list(above), _whole(whole), degree)


def _whole(numbers: Sequence[int]) -> np.ndarray:
    return np.array(numbers, dtype=np.int64)


def branch_columns(skeleton: "Skeleton") -> Columns:
    """The columns of the table of branches."""
    paths, parent, _, whole, degree = direct_branches(skeleton)
    known, points = skeleton.branches, [skeleton.vertices[nodes] for nodes in paths]
    length = np.array([arc_length(path)[-1] for path in points])
    chord = np.array([np.linalg.norm(path[-1] - path[0]) for path in points])
    size = np.array([radii_without_ends(skeleton, nodes, degree) for nodes in paths]).reshape(len(paths), 3)
    surface = [known[number].surface for number in whole]
    for number in np.flatnonzero(np.bincount(whole)[whole] > 1).tolist():  # parts of a branch, which a root splits
        own = np.isin(skeleton.mesh_map, paths[number][1:][degree[paths[number][1:]] < 3])
        surface[number] = np.nan if skeleton.source is None else skeleton.source.areas[own].sum()
    with np.errstate(divide="ignore", invalid="ignore"):
        tortuosity = np.where(chord > 0, length / chord, np.where(length > 0, np.inf, np.nan))
    return {
        "branch": np.arange(len(paths)),
        "start": _whole([nodes[0] for nodes in paths]),
        "end": _whole([nodes[-1] for nodes in paths]),
        "parent": parent,
        "is_tip": np.array([degree[nodes[-1]] == 1 for nodes in paths], dtype=bool),
        "length": length,
        "chord": chord,
        "tortuosity": tortuosity,
        "mean_radius": size[:, 0],
        "least_radius": size[:, 1],
        "largest_radius": size[:, 2],
        "volume": _branch_volumes(skeleton, paths),
        "angle": _fork_angles(skeleton, paths, parent),
        "slenderness": np.array([known[number].slenderness for number in whole], dtype=float),
        "surface": np.array(surface, dtype=float),
    }


def node_columns(skeleton: "Skeleton") -> Columns:
    """The columns of the table of nodes. A junction belongs to the first of its branches."""
    num, branch = len(skeleton.vertices), np.full(len(skeleton.vertices), -1)
    along, curvature = np.full((2, num), np.nan)
    tangent = np.full((num, 3), np.nan)
    for number, nodes in reversed(list(enumerate(direct_branches(skeleton).paths))):
        points = skeleton.vertices[nodes]
        branch[nodes], along[nodes] = number, arc_length(points)
        if len(nodes) > 1 and arc_length(points)[-1] > 0:
            tangent[nodes], curvature[nodes] = tangents_of(points, skeleton.radii[nodes])
    profiles = np.full((num, 4), np.nan)
    if skeleton.source is not None:
        for node, loop in limb_sections(skeleton.source.solid, skeleton.vertices, skeleton.edges).items():
            profiles[node] = profile_of(loop.corners)
    return {
        "node": np.arange(num),
        **dict(zip("xyz", skeleton.vertices.T, strict=True)),
        "radius": skeleton.radii,
        "branch": branch,
        "along": along,
        **dict(zip(("tangent_x", "tangent_y", "tangent_z"), tangent.T, strict=True)),
        "curvature": curvature,
        **dict(zip(("area", "perimeter", "largest_diameter", "least_diameter"), profiles.T, strict=True)),
    }


def radii_without_ends(skeleton: "Skeleton", nodes: np.ndarray, degree: np.ndarray) -> tuple[float, float, float]:
    """Mean, least and largest radius of a branch without its ends: within a radius of a tip balls are smaller, and
    within the ball of a junction larger, than along the branch."""
    radii, along = skeleton.radii[nodes], arc_length(skeleton.vertices[nodes])
    usual = float(np.median(radii))
    first, last = (
        radii[k] if degree[nodes[k]] > 2 else usual if degree[nodes[k]] == 1 and not is_open else 0.0
        for k, is_open in ((0, nodes[0] in skeleton.openings), (-1, nodes[-1] in skeleton.openings))
    )
    is_own = (along >= first) & (along <= along[-1] - last)
    if not is_own.any():
        is_own[np.abs(along - along[-1] / 2).argmin()] = True
    own, stops = radii[is_own], along[is_own]
    mean = np.trapezoid(own, stops) / (stops[-1] - stops[0]) if stops[-1] > stops[0] else own.mean()
    return float(mean), float(own.min()), float(own.max())


def _heading(curve: Branches, vertices: np.ndarray, path: np.ndarray) -> np.ndarray:
    """The direction (3,) of a path that leaves a junction at its first node, in the middle of the stretch that gives
    its axis (see `curve.junctions`); its chord if it is too short for one."""
    axis = curve.axis(path)
    if axis is None:
        return unit(vertices[path[-1]] - vertices[path[0]])
    middle = float(axis.along[axis.first]) + AXIS / 2 * axis.size
    return unit(axis.parabola[1] + 2 * middle * axis.parabola[2])


def _turn(curve: Branches, vertices: np.ndarray, path: np.ndarray, before: np.ndarray) -> float:
    """The angle in degrees, 0 if straight, between a path and the one before it; both leave their junction."""
    ahead, back = (_heading(curve, vertices, each) for each in (path, before))
    return float(np.degrees(np.arccos(np.clip(-ahead @ back, -1.0, 1.0))))


def _fork_angles(skeleton: "Skeleton", paths: list[np.ndarray], parent: np.ndarray) -> np.ndarray:
    """(B,) the angle in degrees between the directions of each branch and its parent at their junction, 0 if straight;
    NaN at a root."""
    angles, curve = np.full(len(paths), np.nan), Branches(skeleton.vertices, skeleton.edges, skeleton.radii)
    for number in np.flatnonzero((parent >= 0) & [len(nodes) > 1 for nodes in paths]).tolist():
        nodes, mother = paths[number], paths[parent[number]]
        mother = mother if mother[-1] != nodes[0] else mother[::-1]
        angles[number] = _turn(curve, skeleton.vertices, nodes, mother)
    return angles


def _branch_volumes(skeleton: "Skeleton", paths: list[np.ndarray]) -> np.ndarray:
    """(B,) the volume between each branch and the faces that belong to it; NaN if the surface is not known."""
    if skeleton.source is None:
        return np.full(len(paths), np.nan)
    solid, vertex = skeleton.source.solid, skeleton.source.input_of_vertex
    node = None if vertex is None else skeleton.mesh_map[vertex]
    nodes, radii = solid.enter(skeleton.vertices), skeleton.radii / solid.diagonal
    return volumes_of(solid.shape, nodes, paths, radii, node) * solid.diagonal**3


class Axis(NamedTuple):
    """branches: their numbers, from the base to the tip. nodes: along all of them. parent: the number of the axis that
    it leaves, or -1. order: 0 of a main axis. position: length of the parent up to the fork."""

    branches: list[int]
    nodes: np.ndarray
    parent: int
    order: int
    position: float


def axes_of(skeleton: "Skeleton") -> tuple[list[Axis], np.ndarray, Directed]:
    """The axes of ``skeleton``, away from its roots, parents first, those of a parent from its base to its tip; the
    Strahler order (B,) of each branch; and the branches."""
    found = direct_branches(skeleton)
    paths, parent, outwards, _, degree = found
    radius = np.array([radii_without_ends(skeleton, nodes, degree)[0] for nodes in paths])
    beyond = np.array([arc_length(skeleton.vertices[nodes])[-1] for nodes in paths])
    strahler, after = np.ones(len(paths), dtype=np.int64), list[list[int]]([] for _ in paths)
    for branch in reversed(outwards):
        if after[branch]:
            beyond[branch] += beyond[after[branch]].max()
            orders = strahler[after[branch]]
            strahler[branch] = orders.max() + (np.sum(orders == orders.max()) > 1)
        if parent[branch] >= 0:
            after[parent[branch]].append(branch)
    angle = np.nan_to_num(_fork_angles(skeleton, paths, parent))
    outside = np.maximum(beyond - skeleton.radii[[nodes[0] for nodes in paths]], 0.0)
    worth = np.cbrt(outside) * radius * (1 + np.cos(np.radians(angle))) / 2
    axes: list[Axis] = []
    waiting = [(number, -1, 0, 0.0) for number in np.flatnonzero(parent < 0).tolist()]
    for number, above, order, position in waiting:
        own, leaving, along = [number], [], 0.0
        while True:
            last = own[-1]
            along += float(arc_length(skeleton.vertices[paths[last]])[-1])
            goes_on = max(after[last], key=lambda each: worth[each], default=-1)
            leaving += [(each, along) for each in sorted(after[last]) if each != goes_on]
            if goes_on < 0:
                break
            own.append(goes_on)
        nodes = np.concatenate([paths[own[0]], *(paths[each][1:] for each in own[1:])])
        waiting += [(each, len(axes), order + 1, place) for each, place in leaving]
        axes.append(Axis(own, nodes, above, order, position))
    return axes, strahler, found


def axis_columns(skeleton: "Skeleton") -> Columns:
    """The columns of the table of axes."""
    axes, strahler, found = axes_of(skeleton)
    num, volume = len(axes), _branch_volumes(skeleton, found.paths)
    size = np.array([radii_without_ends(skeleton, axis.nodes, found.degree)[:2] for axis in axes]).reshape(num, 2)
    curve = Branches(skeleton.vertices, skeleton.edges, skeleton.radii)
    position, angle, internode = np.full((3, num), np.nan)
    last = dict[int, float]()  # of each parent, the position of the axis before
    for number, axis in enumerate(axes):
        if axis.parent >= 0:
            mother, position[number] = axes[axis.parent].nodes, axis.position
            internode[number] = axis.position - last.get(axis.parent, 0.0)
            last[axis.parent] = axis.position
            if len(axis.nodes) > 1:
                below = mother[int((mother == axis.nodes[0]).argmax()) :: -1]
                angle[number] = _turn(curve, skeleton.vertices, axis.nodes, below)
    return {
        "axis": np.arange(num),
        "parent": _whole([axis.parent for axis in axes]),
        "order": _whole([axis.order for axis in axes]),
        "strahler": _whole([strahler[axis.branches[0]] for axis in axes]),
        "start": _whole([axis.nodes[0] for axis in axes]),
        "end": _whole([axis.nodes[-1] for axis in axes]),
        "position": position,
        "internode": internode,
        "angle": angle,
        "length": np.array([arc_length(skeleton.vertices[axis.nodes])[-1] for axis in axes]),
        "chord": np.array([np.linalg.norm(np.diff(skeleton.vertices[axis.nodes[[0, -1]]], axis=0)) for axis in axes]),
        "mean_radius": size[:, 0],
        "least_radius": size[:, 1],
        "volume": np.array([volume[axis.branches].sum() for axis in axes]),
    }


def _disc_radii(skeleton: "Skeleton") -> np.ndarray:
    """(N,) the radius of a disc with the area of the limb's section at each node; NaN where it is not known, or not of
    one limb: neither as wide as is usual along its branch, nor, as where a stem begins, round."""
    disc = np.full(len(skeleton.vertices), np.nan)
    if skeleton.source is not None:
        solid = skeleton.source.solid
        balls = solid.radii(skeleton.vertices)
        for node, loop in limb_sections(solid, skeleton.vertices, skeleton.edges).items():
            radius = np.sqrt(max(section_of(loop.corners).area, 0.0) / np.pi)
            if loop.weight > SURE or radius < ROUND * balls[node]:
                disc[node] = radius
    return disc


def cylinder_columns(skeleton: "Skeleton") -> Columns:
    """The columns of the table of cylinders: one along each edge, by the names of TreeQSM as rTwig reads them.

    Numbers of cylinders and branches begin with 1, and 0 is none. ``radius`` is that of a disc with the area of the
    limb's section, between known ones in proportion: balls are smaller in uneven limbs, and larger at forks. An axis
    begins at the surface of its parent, not within it. So cylinders have the solid's volume. ``UnmodRadius`` is the
    mean of the skeleton's radii at both ends.
    """
    (axes, *_), disc = axes_of(skeleton), _disc_radii(skeleton)
    sizes, rows, parent, branch = list[np.ndarray](), [np.empty((0, 8))], list[int](), list[int]()
    into: dict[tuple[int, int], int] = {}  # the cylinder of an axis that ends in a node
    for number, axis in enumerate(axes):
        nodes, known, last = axis.nodes, np.isfinite(disc[axis.nodes]), 0
        points, along = skeleton.vertices[nodes], arc_length(skeleton.vertices[nodes])
        own = np.interp(along, along[known], disc[nodes[known]]) if known.any() else skeleton.radii[nodes]
        sizes.append(own)
        if axis.parent >= 0 and len(nodes) > 1:
            away, nearest = spatial.KDTree(skeleton.vertices[axes[axis.parent].nodes]).query(points)
            depth = sizes[axis.parent][nearest] - away
            last = int(np.append(depth[1:-1] < 0, True).argmax())  # the node before the parent's surface
            share = float(np.clip(depth[last] / max(depth[last] - depth[last + 1], 1e-300), 0.0, 1.0))
            points, own = (
                np.concatenate([[(1 - share) * each[last] + share * each[last + 1]], each[last + 1 :]])
                for each in (points, own)
            )
        for k, node in enumerate(nodes[1:].tolist()):
            into[number, node] = len(parent) + 1
            if k >= last:
                parent.append(into[number, int(nodes[k])] if k > last else into.get((axis.parent, int(nodes[0])), 0))
                branch.append(number)
        radii = np.stack([own, skeleton.radii[nodes[last:]]], axis=1)
        rows.append(np.hstack([points[:-1], points[1:], (radii[:-1] + radii[1:]) / 2]))
    axis_of, above = _whole(branch), _whole(parent)
    first = np.searchsorted(axis_of, axis_of)
    is_first = first == np.arange(len(axis_of))
    extension = np.append(np.where(is_first[1:], 0, np.arange(2, len(axis_of) + 1)), 0)[: len(axis_of)]
    tail, head, radii = np.split(np.concatenate(rows), [3, 6], axis=1)
    return {
        "radius": radii[:, 0],
        "length": np.linalg.norm(head - tail, axis=1),
        **dict(zip(("start.x", "start.y", "start.z"), tail.T, strict=True)),
        **dict(zip(("axis.x", "axis.y", "axis.z"), unit(head - tail).T, strict=True)),
        "parent": above,
        "extension": extension,
        "added": np.zeros(len(axis_of), dtype=np.int64),
        "UnmodRadius": radii[:, 1],
        "branch": axis_of + 1,
        "BranchOrder": _whole([axis.order for axis in axes])[axis_of],
        "PositionInBranch": np.arange(len(axis_of)) - first + 1,
    }
