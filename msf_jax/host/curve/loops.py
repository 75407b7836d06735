"""A loop around every handle of the solid: the false ones are cut open, and the missing ones laid.

The flow carries on its edges which loops of the surface vanish in the solid, so its graph has a cycle for every handle.
But where its nodes come to be is another matter: on a coarse or thin solid they slide across holes, and a cycle may go
around nothing in space. A cycle that goes around no handle, or around none but those that others go around already, is
cut at its longest edge. For a handle that is left, the shortest path inside that leads from the curve around it and
back to the curve is added. It is found as the shortest loops of a surface are (Erickson, Whittlesey 2005): every edge
of a roadmap of the solid (see `passages`) closes one loop with a forest of shortest paths from the curve; the shortest
is taken whose linking numbers do not depend on those of the loops that are there.
"""

from typing import NamedTuple

import numpy as np

from msf_jax.host.curve.containment import is_inside
from msf_jax.host.curve.passages import Passages
from msf_jax.host.solid.enclosure import Enclosure
from msf_jax.host.solid.handles import along_forest

PRIME = (
    2**31 - 1
)  # linking numbers are compared modulo that: the rank can come out too small, with a chance of 1 in 10^9
AT_ONCE = 8  # loops that are laid in one round, at least; of many more a quarter


class Span:
    """The vectors that are combinations of some given ones, as far as integers modulo a prime tell."""

    def __init__(self, size: int):
        self._rows = np.empty((0, size), dtype=np.int64)  # in echelon form, each with a 1 at its pivot
        self._pivots: list[int] = []

    def adds(self, vector: np.ndarray) -> bool:
        """Whether ``vector`` (size,) depends on none of those that were given before; then it is one of them."""
        left = vector.astype(np.int64) % PRIME
        for row, pivot in zip(self._rows, self._pivots, strict=True):
            left = (left - left[pivot] * row) % PRIME
        where = np.flatnonzero(left)
        if not len(where):
            return False
        pivot = int(where[0])
        self._rows = np.concatenate([self._rows, left[None] * pow(int(left[pivot]), -1, PRIME) % PRIME])
        self._pivots.append(pivot)
        return True


class Proof(NamedTuple):
    """rank: independent handles of the solid that a curve's cycles go around. none, again: (k,) edges of the curve,
    each in a cycle that goes around no handle, or only around handles that the cycles before it go around."""

    rank: int
    none: np.ndarray
    again: np.ndarray


def proof(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray) -> Proof:
    """Which cycles of the curve ``(vertices (N, 3), edges (E, 2))`` go around handles of the solid ``shape``."""
    closing, windings = shape.handles().windings(vertices, edges)
    span = Span(windings.shape[1])
    adds = np.array([span.adds(winding) for winding in windings], dtype=bool)
    is_zero = ~windings.any(axis=1)
    return Proof(int(adds.sum()), closing[is_zero], closing[~adds & ~is_zero])


def independent(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray) -> np.ndarray:
    """(E,) which edges stay when each cycle that goes around no handle of its own is cut at its longest edge.

    An edge outside counts as longer than all others.
    """
    a, b = vertices[edges[:, 0]], vertices[edges[:, 1]]
    length = np.linalg.norm(a - b, axis=1)
    length += np.where(is_inside(shape, a, b), 0.0, length.sum())
    closing, windings = shape.handles().windings(vertices, edges, length)
    stays, span = np.ones(len(edges), dtype=bool), Span(windings.shape[1])
    for cycle in np.argsort(length[closing], kind="stable").tolist():
        stays[closing[cycle]] = span.adds(windings[cycle])
    return stays


def completed(
    passages: Passages, vertices: np.ndarray, edges: np.ndarray, missing: int
) -> tuple[np.ndarray, np.ndarray]:
    """The curve with ``missing`` more loops, each around a handle that none goes around yet: nodes, new ones last, and
    edges. There are fewer of them where the roadmap has no such loop."""
    handles, is_complete = passages.shape.handles(), False
    while missing:
        closing, windings = handles.windings(vertices, edges)
        span = Span(windings.shape[1])
        for winding in windings:
            span.adds(winding)
        in_forest = np.ones(len(edges), dtype=bool)
        in_forest[closing] = False
        forest = edges[in_forest]
        potential = along_forest(
            len(vertices), forest, handles.linking(*(vertices[forest[:, side]] for side in (0, 1)))
        )
        laid, most = 0, max(AT_ONCE, missing // 4)
        for start, end, way in passages.loops_from(vertices, edges, is_complete):
            course = np.concatenate([vertices[start][None], way, vertices[end][None]])
            winding = potential[start] - potential[end] + handles.linking(course[:-1], course[1:]).sum(axis=0)
            if span.adds(winding):
                number = [start, *range(len(vertices), len(vertices) + len(way)), end]
                vertices = np.concatenate([vertices, way])
                edges = np.concatenate([edges, np.stack([number[:-1], number[1:]], axis=1)])
                laid += 1
                if laid in (most, missing):
                    break
        missing -= laid
        if not laid:
            if is_complete:
                break
            is_complete = True
    return vertices, edges
