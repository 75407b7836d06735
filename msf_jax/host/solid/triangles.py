"""Triangles and edges near points: in classes of like size, in pieces, and how far away they are."""

from collections.abc import Callable, Iterator
from functools import reduce
from itertools import chain
from typing import NamedTuple

import numpy as np
from scipy import spatial

from msf_jax.host.solid.geometry import cross

PAIRS_AT_ONCE = 2_000_000  # bounds the memory of one vectorised batch
POINTS_AT_ONCE = 2_000  # and that of the lists that a tree answers with


class SizeClass(NamedTuple):
    """Faces or edges of like size: a tree of their centres, their numbers, and the largest reach among them."""

    tree: spatial.KDTree
    number: np.ndarray
    reach: float


def near(
    classes: list[SizeClass], points: np.ndarray, radius: Callable[[float], np.ndarray]
) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Batches of index pairs (point, member of a class), all of a point's in one batch and side by side.

    ``radius`` says how far (P,) the centres of a class of a given reach may be from each point.
    """
    for first in range(0, len(points), POINTS_AT_ONCE):
        chunk = slice(first, first + POINTS_AT_ONCE)
        found = [
            size_class.tree.query_ball_point(
                points[chunk], radius(size_class.reach)[chunk] * (1 + 1e-12), return_sorted=False
            )
            for size_class in classes
        ]
        counts = [np.fromiter(map(len, near), dtype=np.int64, count=len(near)) for near in found]
        batch = np.cumsum(np.sum(counts, axis=0)) // PAIRS_AT_ONCE
        for number in np.unique(batch):
            chosen = np.flatnonzero(batch == number)
            point = [np.repeat(first + chosen, count[chosen]) for count in counts]
            member = [
                size_class.number[np.fromiter(chain.from_iterable(near[chosen]), dtype=np.int64, count=len(own))]
                for size_class, near, own in zip(classes, found, point, strict=True)
            ]
            yield np.concatenate(point), np.concatenate(member)


def size_classes(centroid: np.ndarray, reach: np.ndarray) -> list[SizeClass]:
    """One class for each power of four of the reach, the largest distance from a triangle's centroid to a corner."""
    level = np.floor(np.log2(np.maximum(reach, 1e-6 * reach.max())) / 2)
    classes = []
    for value in np.unique(level):
        rows = np.flatnonzero(level == value)
        classes.append(SizeClass(spatial.KDTree(centroid[rows]), rows, float(reach[rows].max())))
    return classes


# Corner by corner, as NumPy is slow in reductions over axes of two or three.


def middles(corners: np.ndarray) -> np.ndarray:
    """(F, 3) the middle of each face or edge (F, k, 3)."""
    num = corners.shape[1]
    return sum((corners[:, k] for k in range(1, num)), corners[:, 0]) / num


def boxes(corners: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(F, 3) the lowest and (F, 3) the highest coordinates of each face or edge (F, k, 3)."""
    each = [corners[:, k] for k in range(corners.shape[1])]
    return reduce(np.minimum, each), reduce(np.maximum, each)


def reaches(corners: np.ndarray) -> np.ndarray:
    """(F,) the largest distance from the middle of each face or edge (F, k, 3) to one of its corners."""
    middle = middles(corners)
    away = [corners[:, k] - middle for k in range(corners.shape[1])]
    return np.sqrt(reduce(np.maximum, [x[:, 0] ** 2 + x[:, 1] ** 2 + x[:, 2] ** 2 for x in away]))


def pieces(corners: np.ndarray, largest: float) -> tuple[np.ndarray, np.ndarray]:
    """Faces or edges (F, k, 3) cut in halves, across their longest side, until none reaches farther than ``largest``;
    and the row that each piece is of."""
    row = np.arange(len(corners))
    done, rows = [corners[:0]], [row[:0]]
    while len(corners):
        is_large = reaches(corners) > largest
        done.append(corners[~is_large])
        rows.append(row[~is_large])
        corners, row = corners[is_large], row[is_large]
        side = np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2).argmax(axis=1)
        every, after = np.arange(len(corners)), (side + 1) % corners.shape[1]
        middle = (corners[every, side] + corners[every, after]) / 2
        one, other = corners.copy(), corners.copy()
        one[every, after], other[every, side] = middle, middle
        corners, row = np.concatenate([one, other]), np.concatenate([row, row])
    return np.concatenate(done), np.concatenate(rows)


def point_triangle_distance2(point: np.ndarray, triangle: np.ndarray) -> np.ndarray:
    """Squared distance (c,) from each point (c, 3) to each triangle (c, 3, 3), degenerate ones included."""
    best = np.full(len(point), np.inf)
    for k in range(3):  # to the three edges
        a, b = triangle[:, k], triangle[:, (k + 1) % 3]
        along, offset = b - a, point - a
        length2 = np.einsum("ij,ij->i", along, along)
        t = np.einsum("ij,ij->i", offset, along) / np.where(length2 > 0, length2, 1.0)
        rest = offset - np.clip(t, 0.0, 1.0)[:, None] * along
        best = np.minimum(best, np.einsum("ij,ij->i", rest, rest))
    # To the plane, where the foot of the perpendicular lies in the triangle.
    a, ab, ac = triangle[:, 0], triangle[:, 1] - triangle[:, 0], triangle[:, 2] - triangle[:, 0]
    normal, offset = cross(ab, ac), point - triangle[:, 0]
    area2 = np.einsum("ij,ij->i", normal, normal)
    safe = np.where(area2 > 0, area2, 1.0)
    v = np.einsum("ij,ij->i", cross(offset, ac), normal) / safe
    w = np.einsum("ij,ij->i", cross(ab, offset), normal) / safe
    is_over = (v >= 0) & (w >= 0) & (v + w <= 1) & (area2 > 0)
    return np.where(is_over, np.minimum(best, np.einsum("ij,ij->i", offset, normal) ** 2 / safe), best)
