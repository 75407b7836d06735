"""Geodesic distances on a surface: a compiled loop that moves a front from triangle to triangle."""

from collections.abc import Callable
from functools import partial
from math import inf, sqrt
from typing import NamedTuple

import numpy as np

from msf_jax.numerics.compiled import Ints, Points, Reals, Rows, kernel, part
from msf_jax.solid.enclosure import Enclosure


class FrontSurface(NamedTuple):
    """faces: (F, 3), closed and oriented. first: (V + 1,) of each vertex' part of ``around``, the corners 3 f + k at
    it, one after another. sides: (F, 9) the lengths of the edges from each corner to the next; how far along each the
    foot of the third corner's perpendicular is; and how far from each that corner is."""

    faces: Rows
    first: Ints
    around: Ints
    sides: Points


class Front(NamedTuple):
    """distance: (V,), infinite before. vertex, key: (V + 1,) a heap of vertices and their distances, the nearest first.
    place: (V,) of each vertex in the heap: -1 before it is there, and V once it is settled."""

    distance: Reals
    vertex: Ints
    key: Reals
    place: Ints


@part
def lift(front: Front, vertex: int, key: float, at: int) -> None:
    """Put a vertex into the gap ``at`` of the heap, or as far above it as its distance demands."""
    above = (at - 1) // 2
    while at > 0 and front.key[above] > key:
        front.vertex[at], front.key[at], front.place[front.vertex[above]] = front.vertex[above], front.key[above], at
        at, above = above, (above - 1) // 2
    front.vertex[at], front.key[at], front.place[vertex] = vertex, key, at


@part
def lower(front: Front, vertex: int, distance: float, size: int) -> int:
    """Lower the distance of a vertex, in a heap of ``size`` vertices or not yet; returns the new size."""
    if not distance < front.distance[vertex]:
        return size
    front.distance[vertex] = distance
    at = front.place[vertex] if front.place[vertex] >= 0 else size
    lift(front, vertex, distance, at)
    return max(size, at + 1)


@part
def pop(front: Front, size: int) -> int:
    """Remove the first vertex of a heap of ``size`` vertices; returns the new size."""
    size -= 1
    vertex, key, gap = front.vertex[size], front.key[size], 0
    front.key[size] = inf
    while 2 * gap + 1 < size:  # the gap moves down, and the last vertex from there up: it is seldom far
        child = 2 * gap + 1
        child += front.key[child + 1] < front.key[child]
        front.vertex[gap], front.key[gap], front.place[front.vertex[child]] = front.vertex[child], front.key[child], gap
        gap = child
    lift(front, vertex, key, gap)
    return size


@part
def through(surface: FrontSurface, face: int, k: int, from_a: float, from_b: float) -> float:
    """The distance of a third corner, straight through the edge ab from corner k of a face to the next, from the point
    of the unfolded plane that has the distances ``from_a`` and ``from_b`` from its ends; infinite if the line misses
    the edge."""
    length, foot, height = surface.sides[face, k], surface.sides[face, 3 + k], surface.sides[face, 6 + k]
    along = (from_a * from_a - from_b * from_b + length * length) / (2 * length)
    behind2 = from_a * from_a - along * along
    if not behind2 >= 0 or not length > 0:
        return inf
    behind = sqrt(behind2)
    meets = along + (foot - along) * behind / (behind + height) if behind + height > 0 else -1.0
    return sqrt((foot - along) ** 2 + (height + behind) ** 2) if 0 <= meets <= length else inf


@kernel
def spread(surface: FrontSurface, front: Front, sources: Ints) -> None:
    """Set ``front.distance`` to the geodesic distances from the nearest of the vertices ``sources`` (k,).

    Each vertex, the nearest first, settles, and lowers its neighbours' distances: along edges, and through triangles
    with two settled corners."""
    distance, place, settled, size = front.distance, front.place, len(front.place), 0
    for source in sources:
        size = lower(front, source, 0.0, size)
    while size:
        vertex = front.vertex[0]
        size = pop(front, size)
        place[vertex] = settled
        for at in range(surface.first[vertex], surface.first[vertex + 1]):
            face, k = surface.around[at] // 3, surface.around[at] % 3
            one, other, away = surface.faces[face, (k + 1) % 3], surface.faces[face, (k + 2) % 3], distance[vertex]
            if place[one] != settled:
                size = lower(front, one, away + surface.sides[face, k], size)
                if place[other] == settled:
                    size = lower(front, one, through(surface, face, (k + 2) % 3, distance[other], away), size)
            elif place[other] != settled:
                size = lower(front, other, through(surface, face, k, away, distance[one]), size)


def distances(shape: Enclosure) -> Callable[[np.ndarray], np.ndarray]:
    """A function from vertices (k,) of a closed surface to the geodesic distance of each vertex (V,) from them."""
    x, faces, num = shape.vertices, shape.faces, len(shape.vertices)
    around = np.argsort(faces.ravel(), kind="stable")
    first = np.concatenate([[0], np.cumsum(np.bincount(faces.ravel(), minlength=num))])
    side = np.roll(x[faces], -1, axis=1) - x[faces]
    across = -np.roll(side, 1, axis=1)  # from each corner to the one before
    length = np.linalg.norm(side, axis=2)
    foot = np.einsum("fki,fki->fk", side, across) / np.maximum(length, 1e-300)
    height = np.sqrt(np.maximum(np.einsum("fki,fki->fk", across, across) - foot**2, 0.0))
    return partial(_spread_from, FrontSurface(faces, first, around, np.hstack([length, foot, height])))


def _spread_from(surface: FrontSurface, sources: np.ndarray) -> np.ndarray:
    num = len(surface.first) - 1
    distance, vertex, key = np.full(num, np.inf), np.empty(num + 1, dtype=np.int64), np.empty(num + 1)
    spread(surface, Front(distance, vertex, key, np.full(num, -1)), sources)
    return distance
