"""Where a mesh that has moved crosses itself: pairs of faces that meet, although they are apart along the surface.

Two triangles cross where a side of one passes through the other. Neighbours that a little noise has folded over each
other are not what is looked for, nor the inner side of a bend: faces are apart if no few edges lead from one to the
other, and they were far from each other when the curve was recorded, through the solid or along the curve. Candidates
share a cell of a grid; where all faces in a cell belong together, which is nearly everywhere, its pairs are not listed.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from scipy import sparse
from scipy.sparse import csgraph

from msf_jax.host.solid.geometry import cross, repeated
from msf_jax.host.solid.triangles import boxes, middles

RINGS = 3  # edges, that lead from a face to those that are beside it
ALONG = 2.0  # radii, along the curve, between nodes whose faces are apart
ACROSS = 1.2  # radii, between faces that are apart
CELL = 2.0  # sizes of the usual face, that a cell of the grid is wide; more where faces would fill so many cells each:
MOST_CELLS = 16
LONGEST = 100_000  # cells along the whole, at most
PAIRS_AT_ONCE = 500_000
MOST_FOUND = 10_000  # pairs, after which a mesh is in such a tangle that the others need not be counted


class Crossings:
    """Which faces of a mesh are apart, where a curve was recorded in it: asked of the same mesh when it has moved.

    Args:
        vertices: (V, 3), faces: (F, 3). Lengths in any unit.
        node: (V,) the node of the curve that each vertex goes to.
        radii: (N,) of the nodes.
        edges: (E, 2) of the curve, length: (E,) theirs.
    """

    def __init__(
        self,
        vertices: np.ndarray,
        faces: np.ndarray,
        node: np.ndarray,
        radii: np.ndarray,
        edges: np.ndarray,
        length: np.ndarray,
    ):
        self.faces, self.place = faces, middles(vertices[faces])
        self.node, self.radii, self.num = node[faces[:, 0]], radii, len(vertices)
        self._beside = _codes_beside(faces, self.num)
        self._near, self._close = _codes_near(edges, length, radii)

    def found(self, vertices: np.ndarray) -> np.ndarray:
        """(P, 2) the pairs of faces that are apart, and cross with the mesh's ``vertices`` (V, 3) where they are now.

        Of more than ``MOST_FOUND``, some.
        """
        corners = vertices[self.faces]
        low, high = boxes(corners)
        grid = _grid_of(low, high)
        pairs = [np.empty((0, 2), dtype=np.int64)]
        for one, other, cell in self._candidates(grid, low, high):
            meet = ((low[one] <= high[other]) & (low[other] <= high[one])).all(axis=1)
            one, other, cell = one[meet], other[meet], cell[meet]
            # Of the cells that both are in one counts: that where their boxes begin to overlap.
            is_first = grid.number(grid.cell(np.maximum(low[one], low[other]))) == cell
            one, other = one[is_first], other[is_first]
            apart = self.apart(one, other)
            one, other = one[apart], other[apart]
            is_crossed = _cross(corners[one], corners[other])
            pairs.append(np.stack([one[is_crossed], other[is_crossed]], axis=1))
            if sum(map(len, pairs)) > MOST_FOUND:
                break
        return np.concatenate(pairs)

    def apart(self, one: np.ndarray, other: np.ndarray) -> np.ndarray:
        """(c,) whether each face of ``one`` (c,) is apart from that of ``other``."""
        here, there = self.node[one], self.node[other]
        radius = np.maximum(self.radii[here], self.radii[there])
        found = np.linalg.norm(self.place[one] - self.place[other], axis=1) > ACROSS * radius
        found |= ~_among(here * len(self.radii) + there, self._near)
        rows = np.flatnonzero(found)
        a, b = self.faces[one[rows]], self.faces[other[rows]]
        is_beside = np.zeros(len(rows), dtype=bool)
        for i in range(3):
            for j in range(3):
                is_beside |= _among(a[:, i] * self.num + b[:, j], self._beside)
        found[rows[is_beside]] = False
        return found

    def _candidates(
        self, grid: "_Grid", low: np.ndarray, high: np.ndarray
    ) -> Iterator[tuple[np.ndarray, np.ndarray, np.ndarray]]:
        """Batches of (one, other, cell): pairs of faces whose boxes share a cell of the grid."""
        first = grid.cell(low)
        span = grid.cell(high) - first + 1
        face, step = repeated(span.prod(axis=1))
        across = span[face]
        offset = [step // (across[:, 1] * across[:, 2]), step // across[:, 2] % across[:, 1], step % across[:, 2]]
        code = grid.number(first[face] + np.stack(offset, axis=1))
        order = np.argsort(code, kind="stable")
        face, code = face[order], code[order]
        start = np.flatnonzero(np.r_[True, code[1:] != code[:-1]])
        count = np.diff(np.r_[start, len(code)])
        cells = np.flatnonzero(~self._belong_together(face, start, count) & (count > 1))
        # By faces, not by cells: of a mesh in a tangle one cell may hold nearly all.
        cell, step = repeated(count[cells])
        width, begin = count[cells][cell], start[cells][cell]
        batch = np.cumsum(width) // PAIRS_AT_ONCE
        for number in range(int(batch[-1]) + 1 if len(batch) else 0):
            rows = np.arange(*np.searchsorted(batch, [number, number + 1]))
            row, place = repeated(width[rows])
            first_of = begin[rows][row]
            one, other = face[first_of + step[rows][row]], face[first_of + place]
            is_once = one < other
            yield one[is_once], other[is_once], code[first_of][is_once]

    def _belong_together(self, face: np.ndarray, start: np.ndarray, count: np.ndarray) -> np.ndarray:
        """(c,) cells no two of whose faces can be apart: all are within half of what is apart of the first one."""
        first = np.repeat(face[start], count)
        here, there = self.node[face], self.node[first]
        is_near = np.linalg.norm(self.place[face] - self.place[first], axis=1) <= ACROSS / 2 * np.minimum(
            self.radii[here], self.radii[there]
        )
        is_near &= _among(here * len(self.radii) + there, self._close)
        return np.logical_and.reduceat(is_near, start)


class _Grid(NamedTuple):
    """Cubes of edge ``size`` from ``low`` (3,) on, ``shape`` (3,) of them along each axis."""

    low: np.ndarray
    size: float
    shape: np.ndarray

    def cell(self, places: np.ndarray) -> np.ndarray:
        return np.floor((places - self.low) / self.size).astype(np.int64)

    def number(self, cell: np.ndarray) -> np.ndarray:
        return (cell[:, 0] * self.shape[1] + cell[:, 1]) * self.shape[2] + cell[:, 2]


def _grid_of(low: np.ndarray, high: np.ndarray) -> _Grid:
    """For faces with such boxes (F, 3)."""
    first, extent = low.min(axis=0), float(np.ptp(np.concatenate([low, high]), axis=0).max())
    size = max(CELL * float((high - low).max(axis=1).mean()), extent / LONGEST)
    while True:
        grid = _Grid(first, size, np.floor((high.max(axis=0) - first) / size).astype(np.int64) + 1)
        if (grid.cell(high) - grid.cell(low) + 1).prod(axis=1).sum() <= MOST_CELLS * len(low):
            return grid
        size *= 1.5


def _among(codes: np.ndarray, sorted_codes: np.ndarray) -> np.ndarray:
    """(c,) whether each is one of ``sorted_codes``, of which there is at least one."""
    return sorted_codes[np.minimum(np.searchsorted(sorted_codes, codes), len(sorted_codes) - 1)] == codes


def _codes_beside(faces: np.ndarray, num: int) -> np.ndarray:
    """u V + v of all vertices that at most ``RINGS`` edges lead between, ascending."""
    ends = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    ones = np.ones(len(ends), dtype=bool)
    table = sparse.coo_matrix((ones, (ends[:, 0], ends[:, 1])), shape=(num, num)).tocsr()
    step = sparse.csr_matrix(table + table.T + sparse.eye(num, dtype=bool, format="csr"))
    found = step
    for _ in range(RINGS - 1):
        found = sparse.csr_matrix(found @ step)
    entries = found.tocoo()
    return np.sort(entries.row.astype(np.int64) * num + entries.col)


def _codes_near(edges: np.ndarray, length: np.ndarray, radii: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """i N + j of all nodes that are at most ``ALONG`` of the larger of their radii apart along the curve, ascending.

    And of those at half of the smaller: any two that are so near to a third are among the former.
    """
    num = len(radii)
    near, close = ([np.arange(num) * (num + 1)] for _ in range(2))
    weight = np.maximum(length, 1e-300)  # a length of 0 would be no edge
    graph = sparse.coo_matrix((weight, (edges[:, 0], edges[:, 1])), shape=(num, num)).tocsr()
    for first in range(0, num, 256):
        rows = np.arange(first, min(first + 256, num))
        away = csgraph.dijkstra(graph, directed=False, indices=rows, limit=ALONG * float(radii.max()))
        within = (
            (near, ALONG * np.maximum(radii[rows, None], radii)),
            (close, ALONG / 2 * np.minimum(radii[rows, None], radii)),
        )
        for codes, reach in within:
            i, j = np.nonzero(away <= reach)
            codes.append(rows[i] * num + j)
    return np.unique(np.concatenate(near)), np.unique(np.concatenate(close))


def _cross(one: np.ndarray, other: np.ndarray) -> np.ndarray:
    """(c,) whether triangles (c, 3, 3) cross: a side of either passes through the other."""
    found = np.zeros(len(one), dtype=bool)
    for a, b in ((one, other), (other, one)):
        for k in range(3):
            found |= _passes(a[:, k], a[:, (k + 1) % 3], b)
    return found


def _passes(start: np.ndarray, end: np.ndarray, triangle: np.ndarray) -> np.ndarray:
    """(c,) whether each segment passes through its triangle (c, 3, 3): its ends are on the two sides of the plane, and
    its line is on the same side of all three edges. Both are signs of volumes of tetrahedra."""
    a, b, c = np.moveaxis(triangle, 1, 0)
    normal, along = cross(b - a, c - a), end - start
    above, below = (np.einsum("ci,ci->c", place - a, normal) for place in (start, end))
    turns = np.stack([np.einsum("ci,ci->c", along, cross(u - start, v - start)) for u, v in ((a, b), (b, c), (c, a))])
    return (above * below < 0) & ((turns >= 0).all(axis=0) | (turns <= 0).all(axis=0))
