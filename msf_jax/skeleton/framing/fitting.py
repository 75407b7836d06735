"""Beams from a curve and its solid: the axes of members, their sections, and the joints where axes meet.

The axis of a member is the line nearest to the centroids c of cross-sections in its middle. A joint p is where the axes
of its members, with directions d, meet: the minimum of

    sum |(I - d d^T) (p - c)|^2 + LOOSE |p - q|^2,

q the place of the joint on the curve. The end of a member without a joint is where its axis leaves the solid.
"""

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from msf_jax.base.errors import ConfigError
from msf_jax.skeleton.framing.frame import Frame
from msf_jax.skeleton.framing.joints import Wire, wires_of
from msf_jax.skeleton.framing.section_properties import Section, section_of, torsion_of
from msf_jax.skeleton.source import known
from msf_jax.solid import sections
from msf_jax.solid.geometry import arc_length, at, cross, unit
from msf_jax.solid.solid import Solid

if TYPE_CHECKING:
    from msf_jax.skeleton.skeleton import Skeleton

STATIONS = 9  # cross-sections of a member; its properties are their means
OWN = 0.5  # share of a member's length, in its middle, where cross-sections are cut: at its ends it is in the joints
WIDER = 1.3  # of the median area: larger cross-sections are in an acute joint, too
LOOSE = 1e-3  # weight of the place on the curve: it decides only where axes are nearly parallel


class Cut(NamedTuple):
    """A cross-section. centre: (3,) its centroid. axes: (2, 3) unit vectors in its plane. corners: (n, 2) in them."""

    section: Section
    centre: np.ndarray
    axes: np.ndarray
    corners: np.ndarray


def frame_of(skeleton: "Skeleton", tolerance: Any = None) -> Frame:
    """See `Skeleton.frame`."""
    solid = known(skeleton.source).solid
    usual = float(np.median(skeleton.radii)) if tolerance is None else tolerance
    if isinstance(usual, bool) or not isinstance(usual, int | float | np.number) or not 0 < float(usual) < np.inf:
        raise ConfigError(f"tolerance is {tolerance!r}: expected a length above 0, in the mesh's units")
    places, is_end, wires = wires_of(skeleton.vertices, skeleton.edges, skeleton.radii, float(usual))
    if not wires:
        raise ConfigError(f"no branch is longer than the tolerance, {float(usual):.3g}: expected a smaller one")
    bars = [_bar(solid, skeleton, wire) for wire in wires]
    middle, along = (np.array([bar[k] for bar in bars]) for k in (0, 1))
    members = np.array([wire.joints for wire in wires])
    joints = _met(places, members, middle, along)
    for number, (one, other) in enumerate(members.tolist()):  # carry ends to the end faces
        for joint, sign in ((one, -1.0), (other, 1.0)):
            if is_end[joint]:
                ray = solid.enter(middle[number])[None], sign * along[number][None]
                length = float(solid.shape.ray_lengths(*ray, np.ones(1))[0]) * solid.diagonal
                joints[joint] = middle[number] + sign * length * along[number]
    line = unit(joints[members[:, 1]] - joints[members[:, 0]])
    offset = joints[members] - middle[:, None]
    off_axis = np.linalg.norm(offset - (offset @ along[:, :, None]) * along[:, None], axis=2)
    size = [bar[2] for bar in bars]
    axes, moments = zip(*(_principal(*each) for each in zip(line, [bar[4] for bar in bars], strict=True)), strict=True)
    area = np.array([each[:, 0].mean() for each in size])
    return Frame(
        joints=joints,
        members=members,
        area=area,
        axes=np.array(axes),
        moments=np.array(moments),
        torsion=np.array([bar[3] for bar in bars]),
        eccentricity=off_axis.max(axis=1),
        variation=np.array([each[:, 0].std() for each in size]) / area,
    )


def _bar(
    solid: Solid, skeleton: "Skeleton", wire: Wire
) -> tuple[np.ndarray, np.ndarray, np.ndarray, float, np.ndarray]:
    """Of a member: a point on its axis, its direction, areas (k, 1), torsion constant, and second moments (3, 3), the
    integral of x x^T over the section."""
    path = skeleton.vertices[wire.nodes]
    along = arc_length(path)
    usual = float(np.median(skeleton.radii[wire.nodes]))
    begin, end = along[-1] * (1 - OWN) / 2, along[-1] * (1 + OWN) / 2
    points = at(path, along, np.linspace(begin, end, STATIONS))
    direction = unit(points[-1] - points[0])
    found: list[Cut] = []
    middle = points.mean(axis=0)
    for _ in range(2):  # across the curve, then across the axis that its sections have
        found = _sections(solid, points, direction, usual)
        if len(found) < 2:
            raise ConfigError(
                f"the member from node {wire.nodes[0]} to {wire.nodes[-1]} has no cross-section: expected solid bars"
            )
        area = np.array([cut.section.area for cut in found])
        found = [cut for cut, own in zip(found, area, strict=True) if own <= WIDER * np.median(area)]
        centres = np.array([cut.centre for cut in found])
        middle = centres.mean(axis=0)
        onward = np.linalg.svd(centres - middle)[2][0]
        direction = onward * np.sign(onward @ direction)
        points = middle + ((points - middle) @ direction)[:, None] * direction
    area = np.array([[cut.section.area] for cut in found])
    moments = np.mean([cut.axes.T @ cut.section.moments @ cut.axes for cut in found], axis=0)
    usual = found[int(np.argsort(area[:, 0])[len(found) // 2])]  # that of the median area
    torsion = torsion_of(usual.corners)
    return middle, direction, area, torsion, moments


def _sections(solid: Solid, points: np.ndarray, direction: np.ndarray, radius: float) -> list[Cut]:
    """The sections across ``direction`` through ``points`` (k, 3), with their centroids and their two axes (2, 3)."""
    u = unit(cross(direction, np.eye(3)[np.abs(direction).argmin()]))
    frame = np.stack([u, cross(direction, u)])
    entered, normals = solid.enter(points), np.tile(direction, (len(points), 1))
    cut = sections.corners(solid.shape, entered, normals, np.full(len(points), radius / solid.diagonal))
    places = solid.leave(cut.places(solid.shape))
    is_solid = cut.is_closed & (sections.areas(solid.shape, cut, normals) > 0)
    found = []
    for number in np.flatnonzero(is_solid).tolist():
        flat = (places[cut.loop == number] - points[number]) @ frame.T
        section = section_of(flat)
        found.append(Cut(section, points[number] + section.centroid @ frame, frame, flat))
    return found


def _met(places: np.ndarray, members: np.ndarray, middle: np.ndarray, along: np.ndarray) -> np.ndarray:
    """(J, 3) where the axes through ``middle`` (M, 3) along ``along`` meet at each joint."""
    left, right = np.tile(LOOSE * np.eye(3), (len(places), 1, 1)), LOOSE * places
    across = np.eye(3) - along[:, :, None] * along[:, None, :]
    for end in (0, 1):
        np.add.at(left, members[:, end], across)
        np.add.at(right, members[:, end], np.einsum("mij,mj->mi", across, middle))
    return np.linalg.solve(left, right[:, :, None])[:, :, 0]


def _principal(line: np.ndarray, moments: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The axes (3, 3) of a member along ``line`` (3,), and its second moments about the axes 1 and 2."""
    u = unit(cross(line, np.eye(3)[np.abs(line).argmin()]))
    flat = np.stack([u, cross(line, u)])
    values, vectors = np.linalg.eigh(flat @ moments @ flat.T)
    # The integral of x x over the section is the second moment about the other axis.
    one = vectors[:, 0] @ flat
    return np.stack([line, one, cross(line, one)]), values[::-1]
