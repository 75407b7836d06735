"""Triangles near points: a tree of bounding boxes, samples of triangles, and distances."""

from functools import reduce
from typing import NamedTuple

import numpy as np
from scipy import spatial

from msf_jax.solid import kernels

SAMPLE_SPACING = (
    0.02  # largest sides of the bounding box between samples of a triangle; more if `MOST_SAMPLES` requires it
)
MOST_SAMPLES = 200_000  # approximate limit on the samples of a surface, for memory


def tree_of(low: np.ndarray, high: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """``boxes`` (2n, 6) and ``order`` (n,) of the tree (see `kernels`) of boxes with corners ``low``, ``high`` (n, 3).

    The leaves have the order of a k-d tree of the boxes' middles.
    """
    num = len(low)
    order = spatial.KDTree((low + high) / 2, leafsize=4).indices.astype(np.int64)
    boxes = np.zeros((2 * num, 6))
    boxes[num:, :3], boxes[num:, 3:] = low[order], high[order]
    stop = num
    while stop > 1:
        start = (stop + 1) // 2
        left, right = boxes[2 * start : 2 * stop : 2], boxes[2 * start + 1 : 2 * stop : 2]
        boxes[start:stop, :3] = np.minimum(left[:, :3], right[:, :3])
        boxes[start:stop, 3:] = np.maximum(left[:, 3:], right[:, 3:])
        stop = start
    return boxes, order


class Samples(NamedTuple):
    """Samples of the surface: a tree of them; the triangles at sample s are ``fan[first[s] : first[s + 1]]``."""

    tree: spatial.KDTree
    first: np.ndarray
    fan: np.ndarray


def sampled(vertices: np.ndarray, faces: np.ndarray, reaches: np.ndarray) -> Samples:
    """Every used vertex with its fan, and a grid of points in every large triangle with that triangle."""
    spacing = max(
        SAMPLE_SPACING * float(np.ptp(vertices, axis=0).max()), float(np.sqrt((reaches**2).sum() / MOST_SAMPLES))
    )
    corner = faces.ravel()
    count = np.bincount(corner, minlength=len(vertices))
    points, owners = [vertices[count > 0]], []
    parts = np.ceil(reaches / spacing).astype(np.int64)
    for number in np.unique(parts[parts > 1]):
        i, j = (part.ravel() for part in np.indices((number + 1, number + 1)))
        i, j = i[i + j <= number], j[i + j <= number]
        weights = (np.stack([i, j, number - i - j], axis=1) + 1 / 3) / (number + 1)
        large = np.flatnonzero(parts == number)
        points.append(np.einsum("sk,fki->fsi", weights, vertices[faces[large]]).reshape(-1, 3))
        owners.append(np.repeat(large, len(weights)))
    fan = np.concatenate([np.argsort(corner, kind="stable") // 3, *owners])
    first = np.concatenate([[0], np.cumsum(count[count > 0]), len(corner) + 1 + np.arange(len(fan) - len(corner))])
    # Boxes that are split in the middle, and not shrunk, are built faster and are several times as fast for points
    # on the axis of a cone, as far from many samples.
    tree = spatial.KDTree(np.concatenate(points), leafsize=32, balanced_tree=False, compact_nodes=False)
    return Samples(tree, first, fan)


# The following go corner by corner, as NumPy is slow in reductions over axes of length 2 or 3.


def middles(triangles: np.ndarray) -> np.ndarray:
    """(F, 3) the middle of each triangle (F, 3, 3)."""
    return (triangles[:, 0] + triangles[:, 1] + triangles[:, 2]) / 3


def boxes(triangles: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(F, 3) the lowest and (F, 3) the highest coordinates of each triangle (F, 3, 3)."""
    corners = triangles[:, 0], triangles[:, 1], triangles[:, 2]
    return reduce(np.minimum, corners), reduce(np.maximum, corners)


def reaches(triangles: np.ndarray) -> np.ndarray:
    """(F,) the largest distance from the middle of each triangle (F, 3, 3) to one of its corners."""
    middle = middles(triangles)
    away = [triangles[:, k] - middle for k in range(3)]
    return np.sqrt(reduce(np.maximum, [x[:, 0] ** 2 + x[:, 1] ** 2 + x[:, 2] ** 2 for x in away]))


def point_triangle_distance2(point: np.ndarray, triangle: np.ndarray) -> np.ndarray:
    """Squared distance (c,) from each point (c, 3) to its triangle (c, 3, 3), which may be degenerate."""
    found = np.empty(len(point))
    kernels.distances2(point, triangle, found)
    return found
