"""`Frame`: a solid of bars as beams for structural analysis, and its files, for Abaqus and CalculiX.

Joints whose balls are nearer than the tolerance are one, and a branch that ends nearer to a joint's ball is no member.
A branch is cut where it bends (Douglas and Peucker 1973), but not near a joint, where it bends towards its middle. The
axis of a member is the line nearest to the centroids of its limb's cross-sections in its middle half. A joint is where
the axes of its members meet (see `curve.junctions`), and an end without one where the axis leaves the solid.

The torsion constant is Saint-Venant's estimate from the area A and the second moments, exact for an ellipse,

    J = A^4 / (4 pi^2 (I_1 + I_2)).
"""

import os
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from msf_jax.base.errors import ConfigError
from msf_jax.base.writing import write_whole
from msf_jax.curve.junctions import nearest_to_lines
from msf_jax.skeleton.centrelines import SectionLoop, limb_sections, section_of
from msf_jax.skeleton.formats.writers import number
from msf_jax.skeleton.resampling import add_corners
from msf_jax.solid.geometry import arc_length, axes_across, cross, unit
from msf_jax.topology import graphs

if TYPE_CHECKING:
    from msf_jax.skeleton.skeleton import Skeleton

BENT = 2.5  # median radii from a joint, within which a branch may bend without a corner
SOLVERS = ("abaqus", "calculix")
STEEL = (210000.0, 0.3)  # Young's modulus in N/mm^2, Poisson's ratio
SHEAR = 0.85  # Timoshenko's shear coefficient, between that of a rectangle, 5/6, and of a disc, 0.9


@dataclass(frozen=True, eq=False)
class Frame:
    """Straight members between joints.

    Attributes:
        joints: (J, 3) positions, in the mesh's units.
        members: (M, 2) int, the two joints of each.
        area: (M,) of the cross-section, the mean along the member.
        axes: (M, 3, 3) unit vectors: along the member, and the two principal axes of its section, 1 and 2.
        moments: (M, 2) second moments of area about the axes 1 and 2, the larger one first.
        torsion: (M,) torsion constants of solid sections: of rectangles within 9 %, of a triangle 14 % too large.
        eccentricity: (M,) the largest distance between the member's axis and its joints, where axes do not meet.
        variation: (M,) standard deviation of the area along the member over its mean: 0 if it is prismatic.
    """

    joints: np.ndarray
    members: np.ndarray
    area: np.ndarray
    axes: np.ndarray
    moments: np.ndarray
    torsion: np.ndarray
    eccentricity: np.ndarray
    variation: np.ndarray

    def __repr__(self) -> str:
        return f"Frame({len(self.members)} members, {len(self.joints)} joints, length {self.lengths.sum():.4g})"

    @property
    def lengths(self) -> np.ndarray:
        """(M,) from joint to joint."""
        return np.linalg.norm(self.joints[self.members[:, 1]] - self.joints[self.members[:, 0]], axis=1)

    def save(self, path: str | os.PathLike[str], solver: str = "abaqus") -> None:
        """Write the frame as ``.inp``, atomically: nodes, a beam element and a section for each member, without loads.
        For "abaqus" elements are B31, with general sections, for "calculix" U1, whose torsion constant is the sum of
        the second moments. The elastic constants are those of steel in newtons and millimetres: change them.

        Raises:
            ConfigError: the suffix or the ``solver`` is another.
            OSError: the file cannot be written.
        """
        if solver not in SOLVERS:
            raise ConfigError(f"solver is {solver!r}: expected one of {', '.join(map(repr, SOLVERS))}")
        if not os.fspath(path).lower().endswith(".inp"):
            raise ConfigError(f"no format for a frame in {os.fspath(path)!r}: expected the suffix .inp")
        is_user = solver == "calculix"
        kind, head = ("U1", "SECTION, ELSET=M{}, MATERIAL=STEEL") if is_user else ("B31", "GENERAL SECTION, ELSET=M{}")
        lines = ["*HEADING", "frame written by msf_jax; the elastic constants are those of steel in N and mm"]
        lines += ["*NODE, NSET=ALL"]
        lines += [f"{k}, {', '.join(map(number, place))}" for k, place in enumerate(self.joints, 1)]
        lines += ["*USER ELEMENT, TYPE=U1, NODES=2, INTEGRATION POINTS=2, MAXDOF=6"] * is_user
        for k, (a, b) in enumerate(self.members.tolist(), 1):
            lines += [f"*ELEMENT, TYPE={kind}, ELSET=M{k}", f"{k}, {a + 1}, {b + 1}"]
        modulus, ratio = STEEL
        lines += ["*MATERIAL, NAME=STEEL", "*ELASTIC", f"{number(modulus)}, {number(ratio)}"] * is_user
        each_member = zip(self.area, self.moments, self.torsion, self.axes, strict=True)
        for k, (area, moments, torsion, axes) in enumerate(each_member, 1):
            values = [area, moments[0], 0.0, moments[1], SHEAR if is_user else torsion]
            lines += [f"*BEAM {head}, SECTION=GENERAL".format(k)]
            lines += [", ".join(map(number, each)) for each in (values, axes[1])]
            lines += [f"{number(modulus)}, {number(modulus / (2 + 2 * ratio))}"] * (not is_user)
        write_whole(path, "\n".join(lines) + "\n")


def frame_of(skeleton: "Skeleton", tolerance: float) -> Frame:
    """See `Skeleton.frame`."""
    solid = skeleton.known_source.solid
    places, members, wires = trace_wires(skeleton.vertices, skeleton.edges, skeleton.radii, tolerance)
    if not wires:
        raise ConfigError(f"no branch is longer than the tolerance, {tolerance:.3g}: expected a smaller one")
    loops = limb_sections(solid, skeleton.vertices, skeleton.edges)
    middles, lines, areas, moments = zip(*(_measure_bar(loops, skeleton, nodes) for nodes in wires), strict=True)
    middle, along = np.array(middles), np.array(lines)
    joints, off_axis, axes = places.copy(), np.zeros(len(wires)), np.stack([middle, along], axis=1)
    for joint, place in enumerate(places):
        own = np.flatnonzero((members == joint).any(axis=1))
        # From there again: the pull to a place beside well-determined axes is then gone.
        joints[joint], off = nearest_to_lines(axes[own], nearest_to_lines(axes[own], place)[0])
        off_axis[own] = np.maximum(off_axis[own], off)
    is_end = np.bincount(members.ravel()) == 1
    for member, end in np.argwhere(is_end[members]).tolist():  # carry ends to the end faces
        onward = (2 * end - 1.0) * along[member]
        ray = solid.enter(middle[member])[None], onward[None], np.ones(1)
        length = float(solid.shape.ray_lengths(*ray)[0]) * solid.diagonal
        joints[members[member, end]] = middle[member] + length * onward
    line = unit(joints[members[:, 1]] - joints[members[:, 0]])
    flat = axes_across(line)
    values, vectors = np.linalg.eigh(flat @ np.array(moments) @ flat.transpose(0, 2, 1))
    # The integral of x x over the section is the second moment about the other axis.
    one = np.einsum("mi,mij->mj", vectors[:, :, 0], flat)
    area = np.array([each.mean() for each in areas])
    return Frame(
        joints=joints,
        members=members,
        area=area,
        axes=np.stack([line, one, cross(line, one)], axis=1),
        moments=values[:, ::-1],
        torsion=area**4 / (4 * np.pi**2 * values.sum(axis=1)),
        eccentricity=off_axis,
        variation=np.array([each.std() for each in areas]) / area,
    )


def trace_wires(
    vertices: np.ndarray, edges: np.ndarray, radii: np.ndarray, tolerance: float
) -> tuple[np.ndarray, np.ndarray, list[np.ndarray]]:
    """The joints and members of a curve, see the module: the mean place (J, 3) of the nodes of each joint, the joints
    (M, 2) of each member, and the nodes along it, from its first joint to the second."""
    degree = graphs.degrees(len(vertices), edges)
    short, wires = [np.empty((0, 2), dtype=np.int64)], []
    for nodes in (np.array(path) for path in graphs.trace(len(vertices), edges) if len(path) > 1):
        ball = np.where(degree[nodes[[0, -1]]] > 2, radii[nodes[[0, -1]]], 0.0)
        is_short = arc_length(vertices[nodes])[-1] - ball.sum() <= tolerance
        if is_short and ball.any() and nodes[0] != nodes[-1]:
            short.append(np.stack([nodes[:-1], nodes[1:]], axis=1))
        else:
            stops = _find_corners(vertices[nodes], radii[nodes], tolerance, bool(nodes[0] == nodes[-1]))
            wires += [nodes[first : last + 1] for first, last in pairwise(stops)]
    ends = np.array([nodes[[0, -1]] for nodes in wires], dtype=np.int64).reshape(-1, 2)
    members = graphs.labels(len(vertices), *np.concatenate(short).T)[ends]
    shortest: dict[frozenset[int], int] = {}  # between two joints there is one straight member
    for wire in sorted(range(len(wires)), key=lambda wire: -arc_length(vertices[wires[wire]])[-1]):
        if members[wire, 0] != members[wire, 1]:
            shortest[frozenset(members[wire].tolist())] = wire
    chosen = sorted(shortest.values())
    labels, members = np.unique(members[chosen], return_inverse=True)
    members, ends = members.reshape(-1, 2), ends[chosen]
    places = [vertices[np.unique(ends[members == joint])].mean(axis=0) for joint in range(len(labels))]
    return np.array(places).reshape(-1, 3), members, [wires[wire] for wire in chosen]


def _find_corners(points: np.ndarray, radii: np.ndarray, tolerance: float, is_loop: bool) -> list[int]:
    """Positions of the ends of the straight members along a path."""
    along, usual = arc_length(points), float(np.median(radii))
    free = np.flatnonzero((along > BENT * usual) & (along < along[-1] - BENT * usual))
    stops = free[[0, -1]].tolist() if len(free) else []
    if is_loop:  # its ends are one point, so begin with a triangle
        stops = [0, len(points) // 3, 2 * len(points) // 3, len(points) - 1]
    merged: list[int] = []
    for corner in add_corners(points, stops, tolerance)[1:-1]:  # a rounded bend has several
        if merged and along[corner] - along[merged[-1]] < BENT * usual:
            merged[-1] = (merged[-1] + corner) // 2
        else:
            merged.append(corner)
    return [0, *merged, len(points) - 1]


def _measure_bar(loops: dict[int, SectionLoop], skeleton: "Skeleton", nodes: np.ndarray) -> tuple[np.ndarray, ...]:
    """Of the member along ``nodes``: a point (3,) on its axis, its direction (3,), the areas (k,) of its sections, and
    the mean of their integrals of x x^T (3, 3)."""
    along = arc_length(skeleton.vertices[nodes])
    in_middle = nodes[np.abs(along - along[-1] / 2) <= along[-1] / 4]
    own = [loops[node] for node in in_middle.tolist() if node in loops and loops[node].weight > 1 / 2]
    if len(own) < 2:
        raise ConfigError(
            f"the member from node {nodes[0]} to {nodes[-1]} has no cross-sections of its own: expected solid bars, "
            "longer than thick beyond the joints at their ends"
        )
    cuts = [section_of(loop.corners) for loop in own]
    moments = np.mean([loop.axes.T @ cut.moments @ loop.axes for loop, cut in zip(own, cuts, strict=True)], axis=0)
    centres = np.array([loop.place + cut.centroid @ loop.axes for loop, cut in zip(own, cuts, strict=True)])
    middle = centres.mean(axis=0)
    direction = np.linalg.svd(centres - middle)[2][0]
    onward = skeleton.vertices[nodes[-1]] - skeleton.vertices[nodes[0]]
    return middle, direction * np.sign(direction @ onward), np.array([cut.area for cut in cuts]), moments
