"""Geodesic distances on a surface: a compiled loop that moves a front from triangle to triangle."""

from collections.abc import Callable
from math import inf, sqrt
from typing import NamedTuple

import numpy as np

from msf_jax.numerics.compiled import Ints, Points, Reals, Rows, kernel, part
from msf_jax.solid.enclosure import Enclosure


class FrontSurface(NamedTuple):
    """points: (V, 3). faces: (F, 3), closed and oriented. first: (V + 1,) of each vertex' part of ``around``, the faces
    around it, one after another."""

    points: Points
    faces: Rows
    first: Ints
    around: Ints


class Front(NamedTuple):
    """distance: (V,), infinite. is_settled: (V,), 0. key, value: (9F,) a heap of distances and vertices."""

    distance: Reals
    is_settled: Ints
    key: Reals
    value: Ints


@part
def push(heap: Front, size: int, key: float, value: int) -> int:
    """Add an entry to a heap of ``size`` entries; returns the new size."""
    at = size
    while at > 0 and heap.key[(at - 1) // 2] > key:
        heap.key[at], heap.value[at] = heap.key[(at - 1) // 2], heap.value[(at - 1) // 2]
        at = (at - 1) // 2
    heap.key[at], heap.value[at] = key, value
    return size + 1


@part
def pop(heap: Front, size: int) -> int:
    """Remove the first entry of a heap of ``size`` entries; returns the new size."""
    size -= 1
    key, value, at = heap.key[size], heap.value[size], 0
    while 2 * at + 1 < size:
        child = 2 * at + 1
        if child + 1 < size and heap.key[child + 1] < heap.key[child]:
            child += 1
        if heap.key[child] >= key:
            break
        heap.key[at], heap.value[at] = heap.key[child], heap.value[child]
        at = child
    heap.key[at], heap.value[at] = key, value
    return size


@part
def product(x: Points, a: int, b: int, c: int) -> float:
    """(b - a) . (c - a)."""
    last = (x[b, 2] - x[a, 2]) * (x[c, 2] - x[a, 2])
    return (x[b, 0] - x[a, 0]) * (x[c, 0] - x[a, 0]) + (x[b, 1] - x[a, 1]) * (x[c, 1] - x[a, 1]) + last


@part
def through(x: Points, a: int, b: int, c: int, from_a: float, from_b: float) -> float:
    """The distance of c, straight through the edge ab, from the point of the unfolded plane that has the distances
    ``from_a`` and ``from_b`` from a and b; infinite if the line misses the edge."""
    length2 = product(x, a, b, b)
    length = sqrt(length2)
    if length <= 0:
        return inf
    cx = product(x, a, b, c) / length
    cy = sqrt(max(product(x, a, c, c) - cx * cx, 0.0))
    px = (from_a * from_a - from_b * from_b + length2) / (2 * length)
    py2 = from_a * from_a - px * px
    if py2 < 0:
        return inf
    py = sqrt(py2)
    meets = px + (cx - px) * py / (py + cy) if py + cy > 0 else -1.0
    return sqrt((cx - px) * (cx - px) + (cy + py) * (cy + py)) if 0 <= meets <= length else inf


@part
def settle(surface: FrontSurface, front: Front, vertex: int, size: int) -> int:
    """Update the neighbours' distances through ``vertex``: along edges, and through triangles with two settled corners.
    Returns the heap's new size."""
    x, faces, distance = surface.points, surface.faces, front.distance
    for at in range(surface.first[vertex], surface.first[vertex + 1]):
        face = surface.around[at]
        for k in range(3):
            near = faces[face, k]
            if near == vertex:
                continue
            far = faces[face, 0] + faces[face, 1] + faces[face, 2] - vertex - near
            if front.is_settled[near] == 1:
                target, away = far, through(x, near, vertex, far, distance[near], distance[vertex])
            else:
                target, away = near, distance[vertex] + sqrt(product(x, vertex, near, near))
            if front.is_settled[target] != 1 and away < distance[target]:
                distance[target] = away
                size = push(front, size, away, target)
    return size


@kernel
def spread(surface: FrontSurface, front: Front, sources: Ints) -> None:
    """Set ``front.distance`` to the geodesic distances from the nearest of the vertices ``sources`` (k,)."""
    size = 0
    for source in sources:
        front.distance[source] = 0.0
        size = push(front, size, 0.0, source)
    while size:
        vertex = front.value[0]
        size = pop(front, size)
        if front.is_settled[vertex] != 1:
            front.is_settled[vertex] = 1
            size = settle(surface, front, vertex, size)


def distances(shape: Enclosure) -> Callable[[np.ndarray], np.ndarray]:
    """A function from vertices (k,) of a closed surface to the geodesic distance of each vertex (V,) from them."""
    x, faces = shape.vertices, shape.faces
    around = np.argsort(faces.ravel(), kind="stable") // 3
    first = np.concatenate([[0], np.cumsum(np.bincount(faces.ravel(), minlength=len(x)))])
    surface = FrontSurface(x, faces, first, around)
    key, value = np.empty(9 * len(faces)), np.empty(9 * len(faces), dtype=np.int64)

    def spread_from(sources: np.ndarray) -> np.ndarray:
        found, is_settled = np.full(len(x), np.inf), np.zeros(len(x), dtype=np.int64)
        spread(surface, Front(found, is_settled, key, value), sources)
        return found

    return spread_from
