"""Cross-sections of the solid at nodes (area, perimeter, diameters), and the volume around each branch."""

from typing import NamedTuple

import numpy as np
from scipy import spatial

from msf_jax.solid import openings, sections
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import cross, unit
from msf_jax.solid.solid import Solid
from msf_jax.topology import graphs

LONGEST_FACE = 2.0  # radii: length of a face that is split before its volume is given to branches; a limb is as thick
MOST_PARTS = 64  # parts along a side of a face, at most
MOST_FACES = 50_000  # faces after splitting, about; bounds time and memory


class Profiles(NamedTuple):
    """Cross-sections at nodes (N,), in the caller's units, NaN where none was found. largest, least: diameters between
    parallel lines, as measured by a calliper."""

    area: np.ndarray
    perimeter: np.ndarray
    largest: np.ndarray
    least: np.ndarray


def profiles_of(solid: Solid, nodes: np.ndarray, tangents: np.ndarray, radii: np.ndarray) -> Profiles:
    """The sections of ``solid`` through ``nodes`` (N, 3), normal to ``tangents`` (N, 3), with radii of about ``radii``
    (N,).

    A node at an opening, or so near an oblique or uneven one that the plane cuts its lid, has the section just inside
    the rim, across the limb: of a tube that was cut off obliquely the tube's, and not the larger one of the rim.
    """
    num, points = len(nodes), openings.moved_inside(solid.enter(nodes), tangents, solid.openings)
    found = sections.corners(solid.shape, points, tangents, radii / solid.diagonal)
    unknown = np.full(num, np.nan)
    if not len(found.loop):
        return Profiles(unknown, unknown, unknown, unknown)
    place = found.places(solid.shape) - points[found.loop]
    first = np.flatnonzero(np.r_[True, found.loop[1:] != found.loop[:-1]])
    row = found.loop[first]
    onward = np.r_[place[1:], place[:1]]
    onward[np.r_[first[1:] - 1, len(place) - 1]] = place[first]
    area = sections.areas(solid.shape, found, tangents)[row]
    perimeter = np.add.reduceat(np.linalg.norm(onward - place, axis=1), first)
    across = unit(cross(tangents, np.eye(3)[np.abs(tangents).argmin(axis=1)]))
    beside = cross(tangents, across)
    u = np.einsum("ci,ci->c", place, across[found.loop])
    v = np.einsum("ci,ci->c", place, beside[found.loop])
    is_whole = found.is_closed[row] & (area > 0)
    parts = np.split(np.stack([u, v], axis=1), first[1:])
    width = np.array([_diameters(part) if whole else (0.0, 0.0) for part, whole in zip(parts, is_whole, strict=True)])

    def full(values: np.ndarray, power: int) -> np.ndarray:
        result = unknown.copy()
        result[row] = np.where(is_whole, values * solid.diagonal**power, np.nan)
        return result

    return Profiles(full(area, 2), full(perimeter, 1), full(width[:, 0], 1), full(width[:, 1], 1))


def _diameters(corners: np.ndarray) -> tuple[float, float]:
    """The largest and the least width of a polygon (k, 2): the least is across an edge of its convex hull."""
    try:
        hull = spatial.ConvexHull(corners)
    except spatial.QhullError:  # all in a line, but for rounding
        return np.nan, np.nan
    extreme = corners[hull.vertices]
    return float(spatial.distance.pdist(extreme).max()), float(np.ptp(extreme @ hull.equations[:, :2].T, axis=0).min())


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
    shape: Enclosure, nodes: np.ndarray, edges: np.ndarray, radii: np.ndarray, node_of_vertex: np.ndarray
) -> np.ndarray:
    """(B,) the volume between each branch of a curve ``(nodes (N, 3), edges (E, 2))`` and the faces that belong to it.

    A face belongs to the branch of its first corner's node: ``node_of_vertex`` (V,), for the vertices of ``shape``. A
    face longer than the limb is thick, by the ``radii`` (N,), is split, and its new corners belong to the nearest node.
    """
    branches = graphs.trace(len(nodes), edges)
    branch = np.full(len(nodes), -1)
    for number, path in reversed(list(enumerate(branches))):
        branch[path] = number
    corners, node = shape.triangles, node_of_vertex[shape.faces]
    longest = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)
    with np.errstate(divide="ignore"):
        parts = np.minimum(np.ceil(longest / (LONGEST_FACE * radii[node].max(axis=1))), MOST_PARTS)
    parts = np.maximum(np.floor(parts / max(np.sqrt((parts**2).sum() / MOST_FACES), 1.0)), 1).astype(int)
    found, tree = np.zeros(len(branches)), spatial.KDTree(nodes)
    for num in np.unique(parts).tolist():
        own, feet = corners[parts == num], node[parts == num]
        if num > 1:
            weights, corner = _split(num)
            points = np.einsum("sk,fkx->fsx", weights, own)
            own, feet = (
                each[:, corner].reshape(-1, 3, *each.shape[2:]) for each in (points, np.asarray(tree.query(points)[1]))
            )
        found += swept_volumes(own, nodes[feet], branch[feet[:, 0]], len(branches))
    return found


def _split(num: int) -> tuple[np.ndarray, np.ndarray]:
    """Barycentric coordinates (s, 3) of a grid of points in a triangle, ``num`` steps along each side, and the points
    (num^2, 3) at the corners of the parts between them."""
    i, j = (each.ravel() for each in np.indices((num + 1, num + 1)))
    number = np.cumsum(i + j <= num) - 1
    parts = []
    for steps, most in ((((0, 0), (1, 0), (0, 1)), num - 1), (((1, 1), (0, 1), (1, 0)), num - 2)):
        first = np.flatnonzero(i + j <= most)
        parts.append(np.stack([number[first + (num + 1) * a + b] for a, b in steps], axis=1))
    i, j = i[i + j <= num], j[i + j <= num]
    return np.stack([num - i - j, i, j], axis=1) / num, np.concatenate(parts)
