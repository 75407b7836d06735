"""Junctions of narrow forks: where the axes of their branches meet.

The flow's junction of a narrow fork is in front of the crotch, where its ball is small, and its branches bend around
the crotch. Their axes p + t d are known farther on, where each has its usual radius. The point m nearest to all axes,

    minimise  sum over the branches |(I - d d^T) (m - p)|^2,

is the junction, if it is nearly on each axis, has a larger ball, and sees each p.
"""

import numpy as np

from msf_jax.host import graphs
from msf_jax.host.curve.containment import is_inside
from msf_jax.host.solid.enclosure import Enclosure
from msf_jax.host.solid.geometry import arc_length, at, unit

NARROW = 0.75  # of the least usual radius of the branches: a junction whose ball is smaller is in front of a crotch
USUAL = 0.9  # of the usual radius of a branch: a radius beyond the place where it has as much, its axis begins
AXIS = 2.0  # radii: length of the stretch that gives a branch's axis
OFF = 0.5  # radii: largest distance of the meeting point from an axis
SPREAD = (
    0.05  # least eigenvalue of the sum: 0.13 for a fork of 30 degrees; below it, axes are parallel and meet nowhere
)


def met(shape: Enclosure, x: np.ndarray, edges: np.ndarray, is_held: np.ndarray, radii: np.ndarray) -> np.ndarray:
    """The nodes (N, 3) with junctions of narrow forks where the axes of their branches meet, and the nodes on the way
    to each branch's own section on a straight line."""
    x = x.copy()
    at_node: dict[int, list[np.ndarray]] = {}
    for each in graphs.trace(len(x), edges):
        for path in (each, each[::-1]):
            at_node.setdefault(path[0], []).append(np.array(path))
    for node, paths in at_node.items():
        usual = np.array([float(np.median(radii[path[1:]])) for path in paths if len(path) > 1])
        if len(paths) < 3 or is_held[node] or radii[node] > NARROW * usual.min():
            continue
        begins, points, headings = [], [], []
        for path, size in zip(paths, usual, strict=True):
            along, is_own = arc_length(x[path]), radii[path] >= USUAL * size
            begin = int(np.searchsorted(along, along[is_own.argmax()] + size))
            end = along[min(begin, len(path) - 1)] + AXIS * size
            if end > along[-1] or is_held[path[:begin]].any():
                break
            begins.append(begin)
            points.append(x[path[begin]])
            headings.append(at(x[path], along, np.array([end]))[0] - x[path[begin]])
        if len(begins) < len(paths):
            continue
        p, d = np.array(points), unit(np.array(headings))
        flat = np.eye(3) - d[:, :, None] * d[:, None, :]
        total = flat.sum(axis=0)
        if np.linalg.eigvalsh(total)[0] < SPREAD:
            continue
        meet = np.linalg.solve(total, np.einsum("bij,bj->i", flat, p))
        off = np.linalg.norm(np.einsum("bij,bj->bi", flat, meet - p), axis=1)
        is_nearer = (off > OFF * usual).any() or shape.clearance(meet[None])[0] < radii[node]
        if is_nearer or not is_inside(shape, np.repeat(meet[None], len(p), axis=0), p).all():
            continue
        for path, begin in zip(paths, begins, strict=True):
            x[path[: begin + 1]] = meet + np.linspace(0, 1, begin + 1)[:, None] * (x[path[begin]] - meet)
    return x
