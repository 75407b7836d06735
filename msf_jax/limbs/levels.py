"""How the level sets of a function on a closed surface are connected: its Reeb graph, at the resolution of a step.

Levels, one step apart, cut the surface into pieces, and two pieces meet at a ring. If the function grows along a limb,
a ring is a cross-section of the limb, and the middles of successive rings are its curve (Lazarus, Verroust 1999, level
set diagrams). The graph has a cycle for each handle that is larger than the step, and no other cycles.
"""

from typing import NamedTuple

import numpy as np

from msf_jax.solid.geometry import ROUNDING, cross, repeated, unit
from msf_jax.topology import graphs

MOST_POINTS = 2_000_000  # intersections of levels and edges: if there are more, the step is doubled


Measures = tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]


class Levels(NamedTuple):
    """Rings between pieces of the surface.

    centre: (R, 3) centroid of the area inside a ring. normal: (R, 3) its unit normal, to where the function grows if
    the ring goes around the solid. perimeter: (R,) of a ring. size: (R,) twice its area over its perimeter, the radius
    of a disc. below, above: (R,) the pieces that meet there. level: (R,) the number of steps. piece: (V,) the piece of
    each vertex. contents: (P, 5) of each piece its area, its area vector, and the sum of x . n over it.
    """

    centre: np.ndarray
    normal: np.ndarray
    perimeter: np.ndarray
    size: np.ndarray
    below: np.ndarray
    above: np.ndarray
    level: np.ndarray
    piece: np.ndarray
    contents: np.ndarray

    @property
    def num_pieces(self) -> int:
        """Number of all pieces, also of those without a vertex."""
        return len(self.contents)


def levels(vertices: np.ndarray, faces: np.ndarray, height: np.ndarray, step: float) -> Levels:
    """The level sets of ``height`` (V,), at multiples of ``step``, linear on each of ``faces`` (F, 3).

    The levels cut an edge into stretches. Stretches of a face between the same two levels belong to one piece, and
    points of a face on the same level belong to one ring.
    """
    side = np.sort(np.stack([faces, np.roll(faces, -1, axis=1)], axis=2).reshape(-1, 2), axis=1)
    key, edge_of = np.unique(side[:, 0] * len(vertices) + side[:, 1], return_inverse=True)
    ends, edge_of = np.stack(np.divmod(key, len(vertices)), axis=1), edge_of.reshape(faces.shape)
    ends = np.take_along_axis(ends, np.argsort(height[ends], axis=1, kind="stable"), axis=1)
    while (np.ptp(height[ends], axis=1) / step).sum() > MOST_POINTS:
        step *= 2
    low, high = np.floor(height[ends] / step).astype(np.int64).T
    count = high - low
    first = np.cumsum(count) - count  # the first point of each edge
    edge, place = repeated(count)
    level = low[edge] + 1 + place
    start, stop = height[ends[edge]].T
    share = ((level * step - start) / (stop - start))[:, None]
    points = (1 - share) * vertices[ends[edge, 0]] + share * vertices[ends[edge, 1]]
    # The graph's nodes are the vertices, then the stretches of every edge, from its lower end up.
    stretch = len(vertices) + np.cumsum(count + 1) - (count + 1)
    joined, beside = [np.stack([ends[:, 0], stretch]), np.stack([ends[:, 1], stretch + count])], []
    for k in range(3):
        one, other = edge_of[:, k], edge_of[:, (k + 1) % 3]
        bottom, top = np.maximum(low[one], low[other]), np.minimum(high[one], high[other])
        face, up = repeated(np.maximum(top - bottom + 1, 0))
        joined.append(np.stack([stretch[e[face]] + bottom[face] + up - low[e[face]] for e in (one, other)]))
        face, up = repeated(np.maximum(top - bottom, 0))
        pair = np.stack([first[e[face]] + bottom[face] + up - low[e[face]] for e in (one, other)])
        # All rings have their upper side on the left, seen from outside.
        is_top = height[faces[face, (k + 1) % 3]] > height[faces[face, k]]
        beside.append(np.where(is_top, pair[::-1], pair))
    piece = graphs.labels(len(vertices) + int((count + 1).sum()), *np.concatenate(joined, axis=1))
    num_pieces = int(piece.max(initial=-1)) + 1
    pairs = np.concatenate(beside, axis=1)
    ring = graphs.labels(len(points), *pairs)
    num = int(ring.max(initial=-1)) + 1
    below, above = np.zeros((2, num), dtype=np.int64)
    below[ring], above[ring] = piece[stretch[edge] + place], piece[stretch[edge] + place + 1]
    of_ring = np.zeros(num, dtype=np.int64)
    of_ring[ring] = level
    centre, normal, perimeter, size = _centroids(points[pairs[0]], points[pairs[1]], ring[pairs[0]], num)
    # All bands of a face are on the edge from its lowest to its highest corner.
    longest = edge_of[np.arange(len(faces)), np.ptp(height[ends], axis=1)[edge_of].argmax(axis=1)]
    face, band = repeated(high[longest] - low[longest] + 1)
    part = _shares_below(height[faces][face], (low[longest][face] + band + 1) * step)
    part -= np.where(band > 0, np.append(0.0, part[:-1]), 0.0)
    corners = vertices[faces]
    vector = cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) / 2
    moment = np.einsum("fi,fi->f", corners[:, 0], vector)
    size_of = np.column_stack([np.linalg.norm(vector, axis=1), vector, moment])
    owner = piece[stretch[longest][face] + band]
    contents = np.stack([np.bincount(owner, part * column[face], num_pieces) for column in size_of.T], axis=1)
    return Levels(centre, normal, perimeter, size, below, above, of_ring, piece[: len(vertices)], contents)


def _shares_below(corner: np.ndarray, level: np.ndarray) -> np.ndarray:
    """(k,) the share of a triangle's area below each ``level`` (k,) of a function with the values ``corner`` (k, 3)."""
    a, b, c = np.sort(corner, axis=1).T
    low = np.clip(level - a, 0.0, b - a) ** 2 / np.maximum((b - a) * (c - a), 1e-300)
    top = np.clip(c - level, 0.0, c - b) ** 2 / np.maximum((c - b) * (c - a), 1e-300)
    return np.where(level >= c, 1.0, np.where(level <= b, low, 1.0 - top))


def _centroids(a: np.ndarray, b: np.ndarray, ring: np.ndarray, num: int) -> Measures:
    """The centroid (num, 3) of each ring's area, its unit normal (num, 3), its perimeter (num,), and twice the area
    over it (num,).

    ``a`` and ``b`` (S, 3) are the ends of the segments, which belong to each ``ring`` (S,) and lead around it.
    """

    def summed(vector: np.ndarray) -> np.ndarray:
        return np.stack([np.bincount(ring, weights=axis, minlength=num) for axis in vector.T], axis=1)

    def mean(points: np.ndarray, weight: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        total = np.bincount(ring, weights=weight, minlength=num)
        return summed(weight[:, None] * points) / np.maximum(total, 1e-300)[:, None], total

    middle, perimeter = mean((a + b) / 2, np.linalg.norm(b - a, axis=1))
    from_there = middle[ring]
    vector = cross(a - from_there, b - from_there)
    area = np.linalg.norm(vector, axis=1)
    centre, total = mean((a + b + from_there) / 3, area)
    is_flat = total <= ROUNDING * perimeter**2
    # A ring without a length is a point: all of its segments start and end there.
    point = np.zeros((num, 3))
    point[ring] = a
    centre = np.where(is_flat[:, None], middle, centre)
    centre = np.where(perimeter[:, None] > 0, centre, point)
    return centre, unit(summed(vector)), perimeter, total / np.maximum(perimeter, 1e-300)
