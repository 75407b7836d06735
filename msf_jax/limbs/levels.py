"""How the level sets of a function on a closed surface are connected: its Reeb graph, at the resolution of a step.

Levels, one step apart, cut the surface into pieces, and two pieces meet at a ring. If the function grows along a limb,
a ring is a cross-section of the limb, and the middles of successive rings are its curve (Lazarus, Verroust 1999, level
set diagrams). The graph has a cycle for each handle that is larger than the step, and no other cycles.

The levels cut an edge into stretches. Stretches of a face between the same two levels belong to one piece, and points
of a face on the same level belong to one ring.
"""

from typing import NamedTuple

import numpy as np

from msf_jax.numerics.compiled import Ints, Points, Rows, kernel
from msf_jax.solid.geometry import ROUNDING, cross, repeated, unit
from msf_jax.solid.kernels import norm
from msf_jax.topology import graphs

MOST_POINTS = 400_000  # intersections of levels and edges: if there are more, the step is doubled


class Levels(NamedTuple):
    """Rings between pieces of the surface.

    centre: (R, 3) centroid of the area inside a ring. normal: (R, 3) its unit normal, to where the function grows if
    the ring goes around the solid. perimeter: (R,) of a ring. size: (R,) twice its area over its perimeter, the radius
    of a disc. below, above: (R,) the pieces that meet there. level: (R,) the number of steps. height: (R,) the function
    there. piece: (V,) the piece of each vertex. contents: (P, 5) of each piece, also of those without a vertex, its
    area, its area vector, and the sum of x . n over it. step: between levels."""

    centre: np.ndarray
    normal: np.ndarray
    perimeter: np.ndarray
    size: np.ndarray
    below: np.ndarray
    above: np.ndarray
    level: np.ndarray
    height: np.ndarray
    piece: np.ndarray
    contents: np.ndarray
    step: float


@kernel
def measure_rings(points: Points, segments: Rows, ring: Ints, sums: Points) -> None:
    """Sums over the ``segments`` of each ring, in columns of ``sums`` (R, 14), which are 0 before: the length; the
    middle; the area of the triangles between the segments and the middle; their area times their middles; twice their
    area vector; and one of its points."""
    for row in range(len(segments)):
        a, b, own = points[segments[row, 0]], points[segments[row, 1]], sums[ring[segments[row, 0]]]
        length = norm((b[0] - a[0], b[1] - a[1], b[2] - a[2]))
        own[0] += length
        for i in range(3):
            own[1 + i] += length * ((a[i] + b[i]) / 2)
            own[11 + i] = a[i]
    for row in range(len(sums)):
        for i in range(3):
            sums[row, 1 + i] /= max(sums[row, 0], 1e-300)
    for row in range(len(segments)):
        a, b, own = points[segments[row, 0]], points[segments[row, 1]], sums[ring[segments[row, 0]]]
        ax, ay, az = a[0] - own[1], a[1] - own[2], a[2] - own[3]
        bx, by, bz = b[0] - own[1], b[1] - own[2], b[2] - own[3]
        x, y, z = ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx
        area = norm((x, y, z))
        own[4] += area
        for i in range(3):
            own[5 + i] += area * ((a[i] + b[i] + own[1 + i]) / 3)
        own[8] += x
        own[9] += y
        own[10] += z


def levels(vertices: np.ndarray, faces: np.ndarray, height: np.ndarray, step: float) -> Levels:
    """The level sets of ``height`` (V,), at odd multiples of half a ``step``, linear on each of ``faces`` (F, 3).

    No level is at 0, where many vertices often are."""
    num, onward = len(vertices), np.roll(faces, -1, axis=1)
    key, of_face = np.unique(np.minimum(faces, onward) * num + np.maximum(faces, onward), return_inverse=True)
    of_face, ends = of_face.reshape(-1, 3), np.stack(np.divmod(key, num), axis=1)
    is_down = height[ends[:, 0]] > height[ends[:, 1]]
    ends[is_down] = ends[is_down, ::-1]
    rise = float((height[ends[:, 1]] - height[ends[:, 0]]).sum())
    while rise / step > MOST_POINTS:
        step *= 2
    height = height + step / 2
    low, high = np.floor(height[ends.T] / step).astype(np.int64)  # the levels below an edge's lower and upper end
    edge, place = repeated(high - low)  # the edge of each point, from the lower end up
    level, start, stop = low[edge] + place + 1, *height[ends[edge].T]
    share = ((level * step - start) / (stop - start))[:, None]
    points = (1 - share) * vertices[ends[edge, 0]] + share * vertices[ends[edge, 1]]
    # Of an edge's points and stretches, that of level k is k after these. Stretches follow the vertices.
    point = np.cumsum(high - low) - high - 1
    stretch = num + point + 1 + np.arange(len(ends))
    # The side of a face that crosses most levels has a point on all of its levels, of which another side has some.
    order = np.argsort((high - low)[of_face], axis=1)
    sides, is_rising = (np.take_along_axis(each, order, axis=1) for each in (of_face, ends[of_face, 1] == onward))
    longest, side, is_rising = sides[:, 2], sides[:, :2].ravel(), is_rising[:, :2].ravel()
    beside = np.repeat(longest, 2)
    row, band = repeated((high - low)[side] + 1)
    band += low[side[row]]
    tails = np.concatenate([ends.T.ravel(), stretch[side[row]] + band])
    heads = np.concatenate([stretch + low, stretch + high, stretch[beside[row]] + band])
    piece = graphs.labels(num + len(edge) + len(ends), tails, heads)
    row, at = repeated((high - low)[side])
    at += low[side[row]] + 1
    segments = np.stack([point[side[row]] + at, point[beside[row]] + at], axis=1)
    segments[is_rising[row]] = segments[is_rising[row], ::-1]  # the upper side on the left, seen from outside
    ring = graphs.labels(len(edge), *segments.T)
    below, above, own = np.zeros((3, int(ring.max(initial=-1)) + 1), dtype=np.int64)
    lower = stretch[edge] + level - 1  # the stretch below each point
    below[ring], above[ring], own[ring] = piece[lower], piece[lower + 1], level
    found = np.zeros((len(own), 14))
    measure_rings(points, segments, ring, found)
    perimeter, middle, area, centre, normal, last = np.split(found, [1, 4, 5, 8, 11], axis=1)
    # A ring without a length is a point: all of its segments start and end there.
    centre = np.where(area <= ROUNDING * perimeter**2, middle, centre / np.maximum(area, 1e-300))
    centre = np.where(perimeter > 0, centre, last)
    size = (area / np.maximum(perimeter, 1e-300))[:, 0]
    face, band = repeated((high - low)[longest] + 1)
    band += low[longest[face]]
    corners = np.sort(height[faces], axis=1).T[:, face]
    # All of a face is in its bands, also of a flat one on a level.
    part = np.where(band < high[longest[face]], share_below(corners, (band + 1) * step), 1.0)
    part -= np.where(band > low[longest[face]], share_below(corners, band * step), 0.0)
    measures = _of_faces(vertices[faces])[:, face]
    contents = sums(piece[stretch[longest[face]] + band], part * measures, int(piece.max()) + 1).T
    rings = centre, unit(normal), perimeter[:, 0], size
    return Levels(*rings, below, above, own, (own - 0.5) * step, piece[:num], contents, step)


def _of_faces(corners: np.ndarray) -> np.ndarray:
    """(5, F) what `Levels.contents` sums up, of faces with ``corners`` (F, 3, 3)."""
    vector = cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) / 2
    moment = np.einsum("fi,fi->f", corners[:, 0], vector)
    return np.stack([np.linalg.norm(vector, axis=1), *vector.T, moment])


def share_below(corners: np.ndarray, level: np.ndarray) -> np.ndarray:
    """(n,) the share of a triangle's area below the ``level`` (n,) of a function with the values ``corners`` (3, n) in
    ascending order."""
    low, middle, high = corners
    under = np.clip(level - low, 0.0, middle - low) ** 2 / np.maximum((middle - low) * (high - low), 1e-300)
    over = np.clip(high - level, 0.0, high - middle) ** 2 / np.maximum((high - middle) * (high - low), 1e-300)
    return np.where(level <= middle, under, 1.0 - over)


def sums(group: np.ndarray, values: np.ndarray, num: int) -> np.ndarray:
    """(c, num) the sums of ``values`` (c, n) in each ``group`` (n,)."""
    return np.stack([np.bincount(group, row, num) for row in values])
