"""Where a solid is flat: the largest disc inside it around a point of a curve, beside the largest ball.

In a plate, a fin or an ear the ball says how thick the sheet is, and not how wide. The disc lies along the sheet,
across the mean normal of the surface around the point, and is as wide as the shortest ray in its plane.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from scipy import spatial

from msf_jax.host.solid.enclosure import Enclosure
from msf_jax.host.solid.geometry import unit

AROUND = 2.5  # radii of the ball, within which the surface tells how the disc lies
RAYS = 12  # in its plane
WIDEST = 12.0  # radii of the ball, that a disc is at most
REACHES = 1.5, 2.5, 5.0, WIDEST  # that rays go, one after the other: most are stopped by the first
FLAT, FLATTER = 1.1, 1.3  # a disc no wider than that, in radii of the ball, is none; from this on it counts in full
ROUND, LEVEL = 0.02, 0.05  # of all normals around: so far ahead of the next is the main one of a ball, and of a sheet
WIDE = 3.0  # a disc so many times as wide as its ball is one of a sheet, out of which limbs grow
BESIDE = 3.0  # radii of the disc at a junction, within which nodes are near it
MOST_POINTS = 5_000  # of the surface
AT_ONCE = 500  # points of a curve, which bounds memory


class Discs(NamedTuple):
    """normal: (P, 3) unit vectors across the discs. radius: (P,) of each, that of the ball where there is none."""

    normal: np.ndarray
    radius: np.ndarray


class Flats(NamedTuple):
    """discs: of a curve's nodes. size: (N,) radius of the disc at each, or of a wider one of a sheet that it is in: at
    the rim discs are small, and a limb there grows out of all of the sheet."""

    discs: Discs
    size: np.ndarray


def discs(shape: Enclosure, points: np.ndarray, radii: np.ndarray) -> Discs:
    """The largest discs inside ``shape`` around ``points`` (P, 3), whose largest balls have ``radii`` (P,)."""
    if len(points) > AT_ONCE:
        halves = [discs(shape, points[rows], radii[rows]) for rows in np.array_split(np.arange(len(points)), 2)]
        return Discs(*(np.concatenate(fields) for fields in zip(*halves, strict=True)))
    samples, normals = shape.surface_points(MOST_POINTS)
    near = spatial.KDTree(samples).query_ball_point(points, AROUND * radii)
    count = np.fromiter(map(len, near), np.int64, len(near))
    point, sample = np.repeat(np.arange(len(points)), count), np.concatenate([*near, np.empty(0)]).astype(np.int64)
    n = normals[sample]
    # The direction that these normals have most of, whichever side of the sheet they are on.
    sums = [np.bincount(point, n[:, i] * n[:, j], len(points)) for i in range(3) for j in range(3)]
    much, axes = np.linalg.eigh(np.stack(sums, axis=1).reshape(-1, 3, 3))
    normal, lead = axes[:, :, -1], (much[:, 2] - much[:, 1]) / np.maximum(count, 1)
    first = unit(np.cross(normal, np.eye(3)[np.abs(normal).argmin(axis=1)]))
    angle = np.linspace(0, 2 * np.pi, RAYS, endpoint=False)[:, None, None]
    ways = np.cos(angle) * first + np.sin(angle) * np.cross(normal, first)
    radius, is_open = radii.astype(float), (lead > ROUND) & (radii > 0) & shape.contains(points)
    for reach in REACHES:
        rows = np.flatnonzero(is_open)
        far = np.tile(reach * radii[rows], RAYS)
        length = shape.ray_lengths(np.tile(points[rows], (RAYS, 1)), ways[:, rows].reshape(-1, 3), far)
        radius[rows] = length.reshape(RAYS, -1).min(axis=0)
        is_open[rows] = radius[rows] >= reach * radii[rows]
    share = np.clip((radius / np.maximum(radii, 1e-300) - FLAT) / (FLATTER - FLAT), 0, 1)
    share *= np.clip((lead - ROUND) / (LEVEL - ROUND), 0, 1)
    return Discs(normal, radii + share * (radius - radii))


def away_from(places: np.ndarray, radii: np.ndarray, discs: Discs | None, points: np.ndarray) -> np.ndarray:
    """How far each of ``points`` (P, 3) is from each ball (Q,) at ``places`` (Q, 3), negative inside: (P, Q).

    With ``discs`` it is from what the ball covers when its middle moves about until it touches the disc's rim.
    """
    away = spatial.distance.cdist(points, places)
    if discs is not None:
        rise = points @ discs.normal.T - np.einsum("qi,qi->q", discs.normal, places)
        beside = np.sqrt(np.maximum(away**2 - rise**2, 0)) - (discs.radius - radii)
        away = np.hypot(np.maximum(beside, 0), rise)
    return away - radii


def flats_of(
    places: np.ndarray, radii: np.ndarray, degree: np.ndarray, discs: Callable[[np.ndarray], Discs]
) -> Flats | None:
    """Where branches part in sheets: the ``discs`` of a curve's nodes near junctions that have one, and a leaf near by.

    ``degree`` (N,) is that of the nodes, at ``places`` (N, 3). Others have the balls of ``radii`` (N,); None if all do,
    as in tubes.
    """
    junction, leaf = np.flatnonzero(degree > 2), np.flatnonzero(degree == 1)
    radius = discs(junction).radius
    reach = np.where(radius > radii[junction], BESIDE * radius, -1.0)
    away = spatial.distance.cdist(places[junction], places)
    reach[(away[:, leaf] > reach[:, None]).all(axis=1)] = -1.0
    nodes = np.flatnonzero((away <= reach[:, None]).any(axis=0))
    if not len(nodes):
        return None
    found = Discs(np.zeros_like(places), radii.copy())
    found.normal[nodes], found.radius[nodes] = discs(nodes)
    size, wide = found.radius.copy(), np.flatnonzero(found.radius > WIDE * radii)
    sheet = Discs(found.normal[wide], found.radius[wide])
    junction = np.intersect1d(junction, nodes)
    is_in = away_from(places[wide], radii[wide], sheet, places[junction]) < 0
    size[junction] = np.maximum(size[junction], np.where(is_in, sheet.radius, 0.0).max(axis=1, initial=0.0))
    return Flats(found, size)
