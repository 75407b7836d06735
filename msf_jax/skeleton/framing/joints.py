"""Straight members between merged joints, from a curve: the graph of a frame, before its geometry is made exact.

Joints whose balls are nearer than the tolerance are one. A branch that ends nearer to a joint's ball is no member. A
branch is cut where it bends, such that the members between (Douglas and Peucker 1973) are within the tolerance of it.
Near a joint it bends towards the middle of the joint, and is left out.
"""

from itertools import pairwise
from typing import NamedTuple

import numpy as np
from scipy.cluster.hierarchy import DisjointSet

from msf_jax.solid.geometry import arc_length
from msf_jax.topology import graphs

BENT = 2.5  # median radii from a joint, within which a branch may bend without a corner


class Wire(NamedTuple):
    """A member before its geometry is made exact. joints: numbers of both. nodes: of the curve, from the first
    joint to the second."""

    joints: tuple[int, int]
    nodes: np.ndarray


class Wires(NamedTuple):
    """places: (J, 3) the mean of each joint's nodes. is_end: (J,) joints at the end of one member. wires: members."""

    places: np.ndarray
    is_end: np.ndarray
    wires: list[Wire]


def wires_of(vertices: np.ndarray, edges: np.ndarray, radii: np.ndarray, tolerance: float) -> Wires:
    """The members and joints of a curve, see the module. Lengths are in the units of ``vertices``."""
    degree = graphs.degrees(len(vertices), edges)
    paths = [np.array(path) for path in graphs.trace(len(vertices), edges) if len(path) > 1]
    joined, kept = DisjointSet(range(len(vertices))), []
    for nodes in paths:
        ball = np.where(degree[nodes[[0, -1]]] > 2, radii[nodes[[0, -1]]], 0.0)
        is_short = arc_length(vertices[nodes])[-1] - ball.sum() <= tolerance
        if is_short and ball.any() and nodes[0] != nodes[-1]:
            for node in nodes[1:].tolist():
                joined.merge(int(nodes[0]), node)
        else:
            kept.append(nodes)
    number: dict[int, int] = {}
    groups: list[list[int]] = []

    def joint_of(node: int) -> int:
        root = joined[node]
        if root not in number:
            number[root] = len(groups)
            groups.append([])
        groups[number[root]].append(node)
        return number[root]

    wires = []
    for nodes in kept:
        stops = _corners(vertices[nodes], radii[nodes], tolerance, bool(nodes[0] == nodes[-1]))
        places = [joint_of(int(nodes[k])) for k in stops]
        for joints, (first, last) in zip(pairwise(places), pairwise(stops), strict=True):
            wires.append(Wire(joints, nodes[first : last + 1]))
    wires = _single(vertices, wires)
    count = np.bincount(np.array([wire.joints for wire in wires], dtype=int).ravel(), minlength=len(groups))
    places = np.array([vertices[np.unique(group)].mean(axis=0) for group in groups]).reshape(-1, 3)
    return Wires(places, count == 1, wires)


def _single(vertices: np.ndarray, wires: list[Wire]) -> list[Wire]:
    """One wire for each pair of joints, the shortest: between two joints there is one straight member."""
    shortest: dict[tuple[int, ...], tuple[float, Wire]] = {}
    for wire in wires:
        key, length = tuple(sorted(wire.joints)), float(arc_length(vertices[wire.nodes])[-1])
        if wire.joints[0] != wire.joints[1] and length < shortest.get(key, (np.inf, wire))[0]:
            shortest[key] = length, wire
    return [wire for _, wire in shortest.values()]


def _corners(points: np.ndarray, radii: np.ndarray, tolerance: float, is_loop: bool) -> list[int]:
    """Positions of the ends of the straight members along a path."""
    along, usual = arc_length(points), float(np.median(radii))
    free = np.flatnonzero((along > BENT * usual) & (along < along[-1] - BENT * usual))
    corners: set[int] = set()
    stack = [(int(free[0]), int(free[-1]))] if len(free) else []
    if is_loop:  # its ends are one point, so begin with a triangle
        corners = {len(points) // 3, 2 * len(points) // 3}
        stack = list(pairwise([0, *sorted(corners), len(points) - 1]))
    while stack:
        a, b = stack.pop()
        chord, offset = points[b] - points[a], points[a : b + 1] - points[a]
        t = np.clip(offset @ chord / max(float(chord @ chord), 1e-300), 0.0, 1.0)
        away = np.linalg.norm(offset - t[:, None] * chord, axis=1)
        if away.max() > tolerance:
            middle = a + int(away.argmax())
            corners.add(middle)
            stack += [(a, middle), (middle, b)]
    found: list[int] = []
    for corner in sorted(corners):  # a rounded bend has several
        if found and along[corner] - along[found[-1]] < BENT * usual:
            found[-1] = (found[-1] + corner) // 2
        else:
            found.append(corner)
    return [0, *found, len(points) - 1]
