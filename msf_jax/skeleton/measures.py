"""Measures at places of a curve: tangents and curvature, cross-sections of the solid, volumes of branches.

With s the arc length and x(s) the least-squares cubic over the nodes within a few radii,

    tangent x' / |x'|,   curvature |x' x x''| / |x'|^3.
"""

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from scipy import spatial
from trimesh import remesh

from msf_jax.curve import branches, centring
from msf_jax.solid import sections
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import arc_length, cross, to_segment, unit
from msf_jax.solid.solid import Solid, moved_inside

FIT_REACH = 3.0  # radii: a cubic is fitted to the nodes within this distance along the branch, in both directions
FEWEST_FITTED = 3  # nodes in each direction that a fit uses at least, if the branch has them
LONGEST_FACE = 2.0  # radii: a longer face is split in four before its volume is given to branches
MOST_SPLITS = 6  # times that a face is split
MOST_FACES = 50_000  # faces, beyond which none is split; bounds time and memory


def tangents_of(points: np.ndarray, radii: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The tangents (n, 3), unit vectors, and the curvature (n,), in 1/length, of a branch through ``points`` (n, 3),
    n >= 2, of some length, in a limb of ``radii`` (n,)."""
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


def add_corners(points: np.ndarray, stops: list[int], tolerance: float) -> list[int]:
    """``stops`` of a path through ``points`` (n, 3), and those between them, in order, such that no point is farther
    than ``tolerance`` from the line between the stops before and after it (Douglas and Peucker 1973)."""
    corners, stack = list(stops), list(pairwise(stops))
    while stack:
        first, last = stack.pop()
        away = to_segment(points[first : last + 1], points[first], points[last])
        if away.max() > tolerance:
            corners.append(first + int(away.argmax()))
            stack += [(first, corners[-1]), (corners[-1], last)]
    return sorted(corners)


def axes_across(normals: np.ndarray) -> np.ndarray:
    """(P, 2, 3) two unit vectors across each of the unit vectors ``normals`` (P, 3)."""
    u = unit(cross(normals, np.eye(3)[np.abs(normals).argmin(axis=1)]))
    return np.stack([u, cross(normals, u)], axis=1)


class SectionLoop(NamedTuple):
    """The edge of a cross-section. place: (3,) of its plane. axes: (2, 3) unit vectors in the plane. corners: (n, 2)
    along the axes from the place, counterclockwise. weight: from 0 to 1, how sure it is to be that of one limb, and
    usual along its branch.
    """

    place: np.ndarray
    axes: np.ndarray
    corners: np.ndarray
    weight: float


def limb_sections(solid: Solid, vertices: np.ndarray, edges: np.ndarray) -> dict[int, SectionLoop]:
    """The sections of the limbs of ``solid`` across a curve ``(vertices (N, 3), edges (E, 2))``, by node; none for a
    node where several limbs are one. In the caller's units.

    A node at an opening, or so near an oblique or uneven one that the plane cuts its lid, has the section just inside
    the rim, across the limb: of a tube that was cut off obliquely the tube's, and not the larger one of the rim.
    """
    shape, given, none = solid.shape, solid.enter(vertices), np.zeros(len(vertices), dtype=bool)
    paths = branches.paths_of(given, edges, none)
    if not paths:
        return {}
    size = solid.radii(vertices) / solid.diagonal
    x = moved_inside(given, unit(branches.chords(given, paths, size) @ given), solid.openings)
    ball, near = shape.approximate_clearance(x)
    limbs = centring.limb_sections(shape, x, edges, paths, none, ball, near)
    node, weight, normal = limbs.node, limbs.weight, limbs.tangent[limbs.node]
    cut, axes = sections.corners(shape, x[node], normal, limbs.size[node], near[node]), axes_across(normal)
    middle = vertices[node] + solid.diagonal * (x - given)[node]
    corners, bounds = solid.leave(cut.places(shape)), np.searchsorted(cut.loop, np.arange(len(node) + 1))
    return {
        number: SectionLoop(at, across, (corners[first:last] - at) @ across.T, float(value))
        for number, at, across, first, last, value in zip(
            node.tolist(), middle, axes, bounds[:-1], bounds[1:], weight, strict=True
        )
    }


class Section(NamedTuple):
    """area. centroid: (2,). moments: (2, 2), the integrals of u u, u v, v v over the area, about the centroid."""

    area: float
    centroid: np.ndarray
    moments: np.ndarray


def section_of(corners: np.ndarray) -> Section:
    """The properties of the polygon ``corners`` (n, 2), counterclockwise: sums over its edges (Green's theorem)."""
    start = corners[0]
    a = corners - start
    b = np.roll(a, -1, axis=0)
    twice = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    area = twice.sum() / 2
    centroid = (twice[:, None] * (a + b)).sum(axis=0) / (6 * area)
    a, b = a - centroid, b - centroid
    twice = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    pairs = sum(np.einsum("n,ni,nj->ij", twice, each, each) for each in (a, b, a + b))
    return Section(float(area), start + centroid, np.asarray(pairs) / 24)


def profile_of(corners: np.ndarray) -> tuple[float, float, float, float]:
    """Of the polygon ``corners`` (n, 2): the area, the perimeter, and the largest and least diameter between parallel
    lines, as measured by a calliper; NaN for these if all corners are in a line."""
    perimeter = float(np.linalg.norm(np.roll(corners, -1, axis=0) - corners, axis=1).sum())
    try:
        hull = spatial.ConvexHull(corners)
    except spatial.QhullError:  # all in a line, but for rounding
        return section_of(corners).area, perimeter, np.nan, np.nan
    extreme = corners[hull.vertices]
    # The least width of a polygon is across an edge of its convex hull.
    widths = np.ptp(extreme @ hull.equations[:, :2].T, axis=0)
    return section_of(corners).area, perimeter, float(spatial.distance.pdist(extreme).max()), float(widths.min())


def swept_volumes(corners: np.ndarray, feet: np.ndarray, group: np.ndarray, num: int) -> np.ndarray:
    """(num,) the volume between the faces of each ``group`` (F,) and the curve.

    ``corners`` (F, 3, 3) of each face move straight to their ``feet`` (F, 3, 3) on the curve. The sides of the volume
    that a face sweeps are shared with its neighbours, so the volumes of all faces of a closed surface add up to the
    enclosed volume, because a curve encloses none.
    """

    # Six times the volume: the corners' part, less the feet's, and of each side, a ruled surface, the mean of its two
    # triangulations.
    a, b = np.moveaxis(corners, 1, 0), np.moveaxis(feet, 1, 0)
    six = np.einsum("fi,fi->f", a[0], cross(a[1], a[2])) - np.einsum("fi,fi->f", b[0], cross(b[1], b[2]))
    for p, q in ((0, 1), (1, 2), (2, 0)):
        six += np.einsum("fi,fi->f", cross(a[q], a[p]), b[p] + b[q]) / 2
        six += np.einsum("fi,fi->f", cross(b[p], b[q]), a[p] + a[q]) / 2
    return np.bincount(group, weights=six / 6, minlength=num)


def volumes_of(
    shape: Enclosure,
    nodes: np.ndarray,
    paths: Sequence[list[int] | np.ndarray],
    radii: np.ndarray,
    node_of_vertex: np.ndarray | None,
) -> np.ndarray:
    """(B,) the volume between each branch of a curve through ``nodes`` (N, 3) and the faces that belong to it.

    ``paths``: the nodes of each branch.
    A face belongs to the branch of its first corner's node: ``node_of_vertex`` (V,), for the vertices of ``shape``, or
    the nearest if None. A face longer than the limb is thick, by the ``radii`` (N,), is split, and its new corners
    belong to the nearest node.
    """
    branch = np.full(len(nodes), -1)
    for number, path in reversed(list(enumerate(paths))):
        branch[path] = number
    x, faces, tree = shape.vertices, shape.faces, spatial.KDTree(nodes)
    node = np.asarray(tree.query(x)[1]) if node_of_vertex is None else node_of_vertex
    for _ in range(MOST_SPLITS):
        longest = np.linalg.norm(x[faces] - np.roll(x[faces], 1, axis=1), axis=2).max(axis=1)
        long = np.flatnonzero(longest > LONGEST_FACE * radii[node[faces]].max(axis=1))
        if not len(long) or len(long) > MOST_FACES:
            break
        x, faces = remesh.subdivide(x, faces, face_index=long)[:2]
        node = np.append(node, tree.query(x[len(node) :])[1])
    return swept_volumes(x[faces], nodes[node[faces]], branch[node[faces[:, 0]]], len(paths))
