"""Tables of measurements: a row for each branch, node, axis of a plant, or cylinder of a model of a tree.

Branches lead away from roots. An axis, as botanists count them, goes on through a fork: of the branches that leave the
fork, the one that continues the axis is thick, straight, and leads far. That is the one with the largest

    r (1 + cos a) / 2 l^(1/3),

r its mean radius, a its angle to the branch before the fork, 0 if straight, and l the length of the longest path beyond
the fork's ball: a stub there ends no axis. The others begin axes of the next order; the main axis has order 0. The
Strahler order of a branch that ends in a tip is 1; before a fork it is the largest after it, or one more if several
have that (Strahler 1957).

With s the arc length and x(s) the least-squares cubic over the nodes within a few radii,

    tangent x' / |x'|,   curvature |x' x x''| / |x'|^3.
"""

from collections.abc import Iterable, Sequence
from functools import reduce
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from scipy import spatial
from trimesh import remesh

from msf_jax.curve import branches, centring
from msf_jax.curve.junctions import AXIS, Branches
from msf_jax.skeleton import trees
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import arc_length, axes_across, cross, unit
from msf_jax.solid.solid import Solid, moved_inside
from msf_jax.topology import graphs

if TYPE_CHECKING:
    from msf_jax.skeleton.skeleton import Skeleton

FIT_REACH = 3.0  # radii: a cubic is fitted to the nodes within this distance along the branch, in both directions
FEWEST_FITTED = 3  # nodes in each direction that a fit uses at least, if the branch has them
LONGEST_FACE = 2.0  # radii: a longer face is split in four before its volume is given to branches
MOST_SPLITS = 6  # times that a face is split
MOST_FACES = 10_000  # long faces, beyond which none is split: a branch of a thin plate then differs by 1 % of the whole
SURE = 0.3  # least weight of a section that counts, however wide beside the ball: 1.35 times the usual radius has it
ROUND = 1.2  # largest ratio of a disc's radius to the ball's at a node whose section counts, however wide on its branch

Columns = dict[str, np.ndarray]
Paths = Sequence[list[int] | np.ndarray]  # the nodes of each branch


def tangents_of(points: np.ndarray, radii: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The unit tangents (n, 3) and the curvature (n,), in 1/length, of a branch through ``points`` (n, 3), n >= 2, of
    some length, in a limb of ``radii`` (n,)."""
    num, along = len(points), arc_length(points)
    tangent, curvature = np.empty((num, 3)), np.empty(num)
    for k in range(num):
        first, last = max(k - FEWEST_FITTED, 0), min(k + FEWEST_FITTED, num - 1)
        reach = max(FIT_REACH * radii[k], along[k] - along[first], along[last] - along[k], 1e-12 * along[-1])
        reach *= 1.001  # so that the nodes at both ends count whatever the rounding
        is_fitted = np.abs(along - along[k]) <= reach
        t = (along[is_fitted] - along[k]) / reach
        weight = 1 - t[:, None] ** 2
        power = weight * t[:, None] ** np.arange(4)
        _, one, two, _ = np.linalg.lstsq(power, weight * (points[is_fitted] - points[k]), rcond=1e-5)[0]
        tangent[k] = unit(one)
        speed = max(float(np.linalg.norm(one)), 1e-300)
        curvature[k] = 2 * np.linalg.norm(cross(one, two)) / speed**3
    return tangent, curvature


class SectionLoop(NamedTuple):
    """The edge of a cross-section. place: (3,) of its plane. axes: (2, 3) unit vectors in the plane. corners: (n, 2)
    along the axes from the place, counterclockwise. weight: from 0 to 1, how sure and usual it is, see `centring`."""

    place: np.ndarray
    axes: np.ndarray
    corners: np.ndarray
    weight: float


def limb_sections(solid: Solid, vertices: np.ndarray, edges: np.ndarray) -> dict[int, SectionLoop]:
    """The sections of the limbs of ``solid`` across a curve ``(vertices (N, 3), edges (E, 2))``, by node; none for a
    node where several limbs are one. In the caller's units.

    A node at an opening, or so near an oblique or uneven one that the plane cuts its lid, has the section just inside
    the rim, across the limb: of a tube that was cut off obliquely the tube's, and not the larger one of the rim."""
    shape, given, none = solid.shape, solid.enter(vertices), np.zeros(len(vertices), dtype=bool)
    paths = branches.paths_of(given, edges, none)
    if not paths:
        return {}
    size = solid.radii(vertices) / solid.diagonal
    x = moved_inside(given, unit(branches.chords(given, paths, size) @ given), solid.openings)
    limbs = centring.limb_sections(shape, x, paths, none, shape.clearance(x))
    node, weight, normal = limbs.node, limbs.weight, limbs.tangent[limbs.node]
    cut, axes = limbs.found.corners, axes_across(normal)
    middle = vertices[node] + solid.diagonal * (x - given)[node]
    corners, bounds = solid.leave(cut.places(shape)), np.searchsorted(cut.loop, np.arange(len(node) + 1))
    found = zip(node.tolist(), middle, axes, bounds[:-1], bounds[1:], weight.tolist(), strict=True)
    return {
        number: SectionLoop(at, across, (corners[first:last] - at) @ across.T, value)
        for number, at, across, first, last, value in found
    }


class Section(NamedTuple):
    """area. centroid: (2,). moments: (2, 2), the integrals of u u, u v, v v over the area, about the centroid."""

    area: float
    centroid: np.ndarray
    moments: np.ndarray


def section_of(corners: np.ndarray) -> Section:
    """The properties of the polygon ``corners`` (n, 2), counterclockwise: sums over its edges (Green's theorem)."""
    start, corners = corners[0], corners - corners[0]
    after = np.roll(corners, -1, axis=0)
    twice = corners[:, 0] * after[:, 1] - corners[:, 1] * after[:, 0]
    area = twice.sum() / 2
    centroid = (twice[:, None] * (corners + after)).sum(axis=0) / (6 * area)
    a, b = corners - centroid, after - centroid
    twice = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    pairs = sum(np.einsum("n,ni,nj->ij", twice, each, each) for each in (a, b, a + b))
    return Section(float(area), start + centroid, np.asarray(pairs) / 24)


def profile_of(corners: np.ndarray) -> tuple[float, float, float, float]:
    """Of the polygon ``corners`` (n, 2): the area, the perimeter, and the largest and least diameter between parallel
    lines, by a calliper; NaN for these if all corners are in a line."""
    perimeter = float(np.linalg.norm(np.roll(corners, -1, axis=0) - corners, axis=1).sum())
    try:
        hull = spatial.ConvexHull(corners)
    except spatial.QhullError:  # all in a line, but for rounding
        return section_of(corners).area, perimeter, np.nan, np.nan
    extreme = corners[hull.vertices]
    # The least width of a polygon is across an edge of its convex hull.
    widths = np.ptp(extreme @ hull.equations[:, :2].T, axis=0)
    return section_of(corners).area, perimeter, float(spatial.distance.pdist(extreme).max()), float(widths.min())


def volumes_of(
    shape: Enclosure, nodes: np.ndarray, paths: Paths, radii: np.ndarray, node_of_vertex: np.ndarray | None
) -> np.ndarray:
    """(B,) the volume between each branch of a curve through ``nodes`` (N, 3), by its nodes in ``paths``, and the faces
    that belong to it: to that of their first corner's node, ``node_of_vertex`` (V,), or the nearest if None.

    The corners of each face move straight to their nodes. Neighbours share the sides of the volume that a face sweeps,
    so the volumes of all faces add up to the enclosed one, because a curve encloses none. A face longer than the limb
    is thick, by the ``radii`` (N,), is split, and its new corners belong to the nearest node."""
    branch, x, faces, tree = first_of(paths, len(nodes)), shape.vertices, shape.faces, spatial.KDTree(nodes)
    node = np.asarray(tree.query(x)[1]) if node_of_vertex is None else node_of_vertex
    for _ in range(MOST_SPLITS):
        a = [x[corner] for corner in faces.T]  # NumPy is slow over axes of length 3
        longest = reduce(np.maximum, [np.linalg.norm(a[k] - a[k - 1], axis=1) for k in range(3)])
        long = np.flatnonzero(longest > LONGEST_FACE * reduce(np.maximum, [radii[node[corner]] for corner in faces.T]))
        if not 0 < len(long) <= MOST_FACES:
            break
        x, faces = remesh.subdivide(x, faces, face_index=long)[:2]
        node = np.append(node, tree.query(x[len(node) :])[1])
    # Six times the volume: the corners' part, less the feet's, and of each side, a ruled surface, the mean of its two
    # triangulations.
    a, b = ([place[corner] for corner in faces.T] for place in (x, nodes[node]))
    six = np.einsum("fi,fi->f", a[0], cross(a[1], a[2])) - np.einsum("fi,fi->f", b[0], cross(b[1], b[2]))
    for p, q in ((0, 1), (1, 2), (2, 0)):
        six += np.einsum("fi,fi->f", cross(a[q], a[p]), b[p] + b[q]) / 2
        six += np.einsum("fi,fi->f", cross(b[p], b[q]), a[p] + a[q]) / 2
    return np.bincount(branch[node[faces[:, 0]]], weights=six / 6, minlength=len(paths))


def first_of(paths: Paths, num: int) -> np.ndarray:
    """(num,) the number of the first of ``paths`` that goes through each node, -1 for none."""
    first = np.full(num, -1)
    for number, nodes in reversed(list(enumerate(paths))):
        first[nodes] = number
    return first


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
    `Skeleton.branches` each is, or is a part of. degree: (N,)."""

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
        roots = trees.roots_of(num, skeleton.edges, size, None)
    pieces, above, whole = direct_paths(paths, roots)
    parent = [above.get(number, -1) for number in range(len(pieces))]
    return Directed(pieces, _whole(parent), list(above), _whole(whole), degree)


def _whole(numbers: Sequence[int]) -> np.ndarray:
    return np.array(numbers, dtype=np.int64)


def branch_columns(skeleton: "Skeleton") -> Columns:
    """The columns of the table of branches."""
    paths, parent, _, whole, degree = direct_branches(skeleton)
    known, along = skeleton.branches, measures_along(skeleton, paths, degree)
    length, chord = along.pop("length"), along.pop("chord")
    surface = np.full(len(paths), np.nan)
    if skeleton.source is not None:  # a root that splits a branch belongs to its first part, and a junction to none
        branch = np.where(degree < 3, first_of(paths, len(degree)), len(paths))[skeleton.mesh_map]
        surface = np.bincount(branch, skeleton.source.areas, len(paths) + 1)[:-1]
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
        **along,
        "volume": _branch_volumes(skeleton, paths),
        "angle": _fork_angles(skeleton, paths, parent),
        "slenderness": np.array([known[number].slenderness for number in whole], dtype=float),
        "surface": surface,
    }


def node_columns(skeleton: "Skeleton") -> Columns:
    """The columns of the table of nodes. A junction belongs to the first of its branches."""
    paths, num = direct_branches(skeleton).paths, len(skeleton.vertices)
    along, curvature = np.full((2, num), np.nan)
    tangent = np.full((num, 3), np.nan)
    for nodes in reversed(paths):
        points = skeleton.vertices[nodes]
        along[nodes] = arc_length(points)
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
        "branch": first_of(paths, num),
        "along": along,
        **dict(zip(("tangent_x", "tangent_y", "tangent_z"), tangent.T, strict=True)),
        "curvature": curvature,
        **dict(zip(("area", "perimeter", "largest_diameter", "least_diameter"), profiles.T, strict=True)),
    }


def measures_along(skeleton: "Skeleton", paths: list[np.ndarray], degree: np.ndarray) -> Columns:
    """Of each path the length, the chord, and the mean, least and largest radius without its ends: within a radius of a
    tip balls are smaller, and within the ball of a junction larger, than along the branch."""
    rows = np.empty((len(paths), 5))
    for row, nodes in zip(rows, paths, strict=True):
        radii, along = skeleton.radii[nodes], arc_length(skeleton.vertices[nodes])
        usual, is_own = float(np.median(radii)), np.ones(len(nodes), dtype=bool)
        for end, away in ((0, along), (-1, along[-1] - along)):
            is_tip = degree[nodes[end]] == 1 and nodes[end] not in skeleton.openings
            is_own &= away >= (radii[end] if degree[nodes[end]] > 2 else usual if is_tip else 0.0)
        if not is_own.any():
            is_own[np.abs(along - along[-1] / 2).argmin()] = True
        own, stops = radii[is_own], along[is_own]
        mean = np.trapezoid(own, stops) / (stops[-1] - stops[0]) if stops[-1] > stops[0] else own.mean()
        chord = np.linalg.norm(skeleton.vertices[nodes[-1]] - skeleton.vertices[nodes[0]])
        row[:] = along[-1], chord, mean, own.min(), own.max()
    return dict(zip(("length", "chord", "mean_radius", "least_radius", "largest_radius"), rows.T, strict=True))


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
    length, _, radius, *_ = measures_along(skeleton, paths, degree).values()
    beyond = length.copy()
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
            along += float(length[last])
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
    along = measures_along(skeleton, [axis.nodes for axis in axes], found.degree)
    along.pop("largest_radius")
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
        **along,
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

    Numbers begin with 1, and 0 is none. ``radius`` is that of a disc with the area of the limb's section, between known
    ones in proportion: balls are smaller in uneven limbs, and larger at forks. An axis begins at the surface of its
    parent. So cylinders have the solid's volume. ``UnmodRadius`` is the mean of the skeleton's radii at both ends."""
    (axes, *_), disc = axes_of(skeleton), _disc_radii(skeleton)
    sizes, rows, parent, branch = list[np.ndarray](), [np.empty((0, 8))], list[int](), list[int]()
    trees = {n: spatial.KDTree(skeleton.vertices[axes[n].nodes]) for n in {each.parent for each in axes} if n >= 0}
    into: dict[tuple[int, int], int] = {}  # the cylinder of an axis that ends in a node
    for number, axis in enumerate(axes):
        nodes, known, last = axis.nodes, np.isfinite(disc[axis.nodes]), 0
        points, along = skeleton.vertices[nodes], arc_length(skeleton.vertices[nodes])
        own = np.interp(along, along[known], disc[nodes[known]]) if known.any() else skeleton.radii[nodes]
        sizes.append(own)
        if axis.parent >= 0 and len(nodes) > 1:
            away, nearest = trees[axis.parent].query(points)
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
    axis_of = _whole(branch)
    first = np.searchsorted(axis_of, axis_of)
    own = np.arange(1, len(axis_of) + 1)
    extension = np.append(np.where(np.diff(axis_of) > 0, 0, own[1:]), 0)[: len(axis_of)]  # the next one of the axis
    tail, head, radii = np.split(np.concatenate(rows), [3, 6], axis=1)
    return {
        "radius": radii[:, 0],
        "length": np.linalg.norm(head - tail, axis=1),
        **dict(zip(("start.x", "start.y", "start.z"), tail.T, strict=True)),
        **dict(zip(("axis.x", "axis.y", "axis.z"), unit(head - tail).T, strict=True)),
        "parent": _whole(parent),
        "extension": extension,
        "added": np.zeros(len(axis_of), dtype=np.int64),
        "UnmodRadius": radii[:, 1],
        "branch": axis_of + 1,
        "BranchOrder": _whole([axis.order for axis in axes])[axis_of],
        "PositionInBranch": own - first,
    }
