"""Tables of measurements: a row for each branch, or for each node."""

from collections import deque
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from scipy import spatial

from msf_jax.curve import branches
from msf_jax.skeleton.centrelines.frames import frames_of
from msf_jax.skeleton.centrelines.profiles import Profiles, profiles_of, volumes_of
from msf_jax.solid.geometry import arc_length, at, unit
from msf_jax.topology import graphs

if TYPE_CHECKING:
    from msf_jax.skeleton.skeleton import Skeleton

AWAY = 1.5  # radii of a junction: nearer to it, a branch still bends towards its middle
BEYOND = 2.0  # radii of a junction: a branch's direction is taken over this length, from `AWAY` on
LEAST_BEYOND = 1.0  # radii of a junction: the least such length, where another junction is near
Columns = dict[str, np.ndarray]


class Oriented(NamedTuple):
    """Branches directed away from the root. nodes: those of each branch, the end nearer to the root first. parent: (B,)
    the branch before each, -1 for those at a root."""

    nodes: list[np.ndarray]
    parent: np.ndarray


def oriented(skeleton: "Skeleton") -> Oriented:
    """The branches of ``skeleton``, in the order of its ``branches``, from its roots, or from the tips of its
    thickest limbs."""
    num = len(skeleton.vertices)
    paths = [np.array(nodes) for nodes in graphs.trace(num, skeleton.edges)]
    roots = skeleton.roots or _inlets(skeleton, paths)
    at_node: dict[int, list[int]] = {}
    for number, nodes in enumerate(paths):
        for end in {int(nodes[0]), int(nodes[-1])}:
            at_node.setdefault(end, []).append(number)
    parent = np.full(len(paths), -2)
    inside = {int(node): number for number, nodes in enumerate(paths) for node in nodes[1:-1]}
    for root in roots:
        queue: deque[tuple[int, int]] = deque()  # a junction, and the branch by which it was reached
        if root in inside:
            first = inside[root]
            parent[first] = -1
            queue += [(int(paths[first][0]), first), (int(paths[first][-1]), first)]
        else:
            queue.append((int(root), -1))
        while queue:
            node, above = queue.popleft()
            for number in at_node.get(node, []):
                if parent[number] == -2:
                    parent[number] = above
                    if paths[number][0] != node:
                        paths[number] = paths[number][::-1]
                    queue.append((int(paths[number][-1]), number))
    return Oriented(paths, np.where(parent == -2, -1, parent))


def _inlets(skeleton: "Skeleton", paths: list[np.ndarray]) -> tuple[int, ...]:
    """A root for each component: the tip of its thickest limb, or its thickest node if it has no tip."""
    degree = np.bincount(skeleton.edges.ravel(), minlength=len(skeleton.vertices))
    size = skeleton.radii / (1 + skeleton.radii.max())  # below 1, so that tips, with sizes above 1, go first
    for nodes in paths:
        for tip in nodes[[0, -1]][degree[nodes[[0, -1]]] == 1]:
            size[tip] = 1 + np.median(skeleton.radii[nodes])
    return branches.roots_of(len(size), skeleton.edges, size, None)


def branch_columns(skeleton: "Skeleton") -> Columns:
    """The columns of the table of branches."""
    paths, parent = oriented(skeleton)
    num, degree = len(paths), np.bincount(skeleton.edges.ravel(), minlength=len(skeleton.vertices))
    points = [skeleton.vertices[nodes] for nodes in paths]
    length = np.array([arc_length(path)[-1] for path in points])
    chord = np.array([np.linalg.norm(path[-1] - path[0]) for path in points])
    size = np.array([radii_without_ends(skeleton, nodes, degree) for nodes in paths]).reshape(num, 3)
    measured = skeleton.branches
    with np.errstate(divide="ignore", invalid="ignore"):
        tortuosity = np.where(chord > 0, length / chord, np.where(length > 0, np.inf, np.nan))
    return {
        "branch": np.arange(num),
        "start": np.array([nodes[0] for nodes in paths], dtype=np.int64),
        "end": np.array([nodes[-1] for nodes in paths], dtype=np.int64),
        "parent": parent,
        "is_tip": np.array([degree[nodes[-1]] == 1 for nodes in paths], dtype=bool),
        "length": length,
        "chord": chord,
        "tortuosity": tortuosity,
        "mean_radius": size[:, 0],
        "least_radius": size[:, 1],
        "largest_radius": size[:, 2],
        "volume": branch_volumes(skeleton, num),
        "angle": fork_angles(skeleton, paths, parent),
        "slenderness": np.array([branch.slenderness for branch in measured], dtype=float),
        "surface": np.array([branch.surface for branch in measured], dtype=float),
    }


def node_columns(skeleton: "Skeleton") -> Columns:
    """The columns of the table of nodes. A junction belongs to the first of its branches."""
    paths, _ = oriented(skeleton)
    num = len(skeleton.vertices)
    branch, along, curvature, torsion = (
        np.full(num, -1),
        np.full(num, np.nan),
        np.full(num, np.nan),
        np.full(num, np.nan),
    )
    tangent = np.full((num, 3), np.nan)
    for number, nodes in reversed(list(enumerate(paths))):
        branch[nodes] = number
        points = skeleton.vertices[nodes]
        along[nodes] = arc_length(points)
        if len(nodes) > 1 and arc_length(points)[-1] > 0:
            found = frames_of(points, skeleton.radii[nodes])
            tangent[nodes], curvature[nodes], torsion[nodes] = found
    sections = Profiles(*np.full((4, num), np.nan))
    known = np.isfinite(tangent).all(axis=1)
    if skeleton.source is not None and known.any():
        found = profiles_of(skeleton.source.solid, skeleton.vertices[known], tangent[known], skeleton.radii[known])
        for whole, part in zip(sections, found, strict=True):
            whole[known] = part
    return {
        "node": np.arange(num),
        **dict(zip("xyz", skeleton.vertices.T, strict=True)),
        "radius": skeleton.radii,
        "branch": branch,
        "along": along,
        **dict(zip(("tangent_x", "tangent_y", "tangent_z"), tangent.T, strict=True)),
        "curvature": curvature,
        "torsion": torsion,
        "area": sections.area,
        "perimeter": sections.perimeter,
        "largest_diameter": sections.largest,
        "least_diameter": sections.least,
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


def fork_angles(skeleton: "Skeleton", paths: list[np.ndarray], parent: np.ndarray) -> np.ndarray:
    """(B,) the angle in degrees between the directions of each branch and its parent at their junction, 0 if straight;
    NaN at a root."""
    found = np.full(len(paths), np.nan)
    degree = np.bincount(skeleton.edges.ravel(), minlength=len(skeleton.vertices))
    for number, above in enumerate(parent.tolist()):
        if above < 0 or len(paths[number]) < 2:
            continue
        junction = paths[number][0]
        mother = paths[above] if paths[above][-1] != junction else paths[above][::-1]
        ahead, back = (direction_from(skeleton, nodes, degree) for nodes in (paths[number], mother))
        found[number] = np.degrees(np.arccos(np.clip(-(ahead @ back), -1.0, 1.0)))
    return found


def direction_from(skeleton: "Skeleton", nodes: np.ndarray, degree: np.ndarray) -> np.ndarray:
    """(3,) the direction of a branch away from the junction at its first node.

    It leaves out the part that bends towards this junction, and the part that bends towards one at the last node.
    """
    points = skeleton.vertices[nodes]
    along, radius = arc_length(points), float(skeleton.radii[nodes[0]])
    first, last = AWAY * radius, AWAY * float(skeleton.radii[nodes[-1]]) * (degree[nodes[-1]] > 2)
    least = min(LEAST_BEYOND * radius, along[-1] / 2)
    begin, end = first, min(first + BEYOND * radius, along[-1] - last)
    if end - begin < least:  # centred where both junctions are equally many radii away
        middle = along[-1] * first / (first + last) if first + last > 0 else along[-1]
        begin = min(max(middle - least / 2, 0.0), along[-1] - least)
        end = begin + least
    near, far = at(points, along, np.array([begin, end]))
    return unit(far - near)


def branch_volumes(skeleton: "Skeleton", num: int) -> np.ndarray:
    """(B,) the volume between each branch and the faces that belong to it; NaN if the surface is not known."""
    if skeleton.source is None:
        return np.full(num, np.nan)
    solid = skeleton.source.solid
    if skeleton.source.input_of_vertex is not None:
        node = skeleton.mesh_map[skeleton.source.input_of_vertex]
    else:
        node = np.asarray(spatial.KDTree(skeleton.vertices).query(solid.leave(solid.shape.vertices))[1])
    nodes = solid.enter(skeleton.vertices)
    radii = skeleton.radii / solid.diagonal
    return volumes_of(solid.shape, nodes, skeleton.edges, radii, node) * solid.diagonal**3
