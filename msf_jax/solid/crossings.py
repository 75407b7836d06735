"""Where a moved mesh crosses itself: pairs of faces that intersect, although they are apart along the surface.

Two triangles cross where a side of one passes through the other. Neighbours that noise folds over each other do not
count, nor does the inner side of a bend. Two faces are apart if more than `RINGS` edges separate them, and if they were
far from each other when the curve was recorded: in space or along the curve. Candidate pairs share a cell of a grid. In
most cells no two faces are apart; the pairs of these cells are not listed.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from scipy import sparse
from scipy.sparse import csgraph

from msf_jax.solid.enclosure import MOST_CROSSED, Enclosure
from msf_jax.solid.geometry import cross, repeated
from msf_jax.solid.triangles import boxes, middles
from msf_jax.topology import graphs

RINGS = 3  # edges: faces that so few edges join are neighbours, and never apart
ALONG = 2.0  # radii: least distance along the curve of nodes whose faces are apart
ACROSS = 1.2  # radii: least distance in space of faces that are apart
CELL = 2.0  # mean sizes of a face's box: width of a grid cell, which grows until the faces meet `MOST_CELLS`
MOST_CELLS = 16  # mean number of cells that the box of a face overlaps
LONGEST = 100_000  # cells along the longest axis of the grid
PAIRS_AT_ONCE = 500_000  # pairs of faces in a batch: bounds memory


class Crossings:
    """Finds crossing faces of a moved mesh; which faces are apart is decided by the mesh that a curve was recorded in.

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
        """(P, 2) the pairs of faces that are apart and cross, for the moved ``vertices`` (V, 3).

        The search stops after ``MOST_CROSSED`` pairs: the mesh is a tangle in any case.
        """
        corners = vertices[self.faces]
        low, high = boxes(corners)
        grid = _grid_of(low, high)
        pairs = [np.empty((0, 2), dtype=np.int64)]
        for one, other, cell in self._candidates(grid, low, high):
            meet = ((low[one] <= high[other]) & (low[other] <= high[one])).all(axis=1)
            one, other, cell = one[meet], other[meet], cell[meet]
            # A pair that shares several cells counts once: in the cell of the lowest corner of the boxes' overlap.
            is_first = grid.number(grid.cell(np.maximum(low[one], low[other]))) == cell
            one, other = one[is_first], other[is_first]
            apart = self.apart(one, other)
            one, other = one[apart], other[apart]
            is_crossed = _cross(corners[one], corners[other])
            pairs.append(np.stack([one[is_crossed], other[is_crossed]], axis=1))
            if sum(map(len, pairs)) > MOST_CROSSED:
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
        # A batch is a range of faces, because in a tangled mesh one cell may hold nearly all faces.
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
        """(c,) which cells have no faces that are apart: all are within half the limits of the cell's first face."""
        first = np.repeat(face[start], count)
        here, there = self.node[face], self.node[first]
        is_near = np.linalg.norm(self.place[face] - self.place[first], axis=1) <= ACROSS / 2 * np.minimum(
            self.radii[here], self.radii[there]
        )
        is_near &= _among(here * len(self.radii) + there, self._close)
        return np.logical_and.reduceat(is_near, start)


def apart_pairs(
    shape: Enclosure, node: np.ndarray, radii: np.ndarray, edges: np.ndarray, length: np.ndarray
) -> np.ndarray:
    """(P, 2) the pairs of faces of ``shape`` that are apart and cross, see `Crossings`, among those of `Crossed`."""
    pairs = shape.crossed.pairs
    if not len(pairs):
        return pairs
    near = np.zeros(len(shape.vertices), dtype=bool)
    near[shape.faces[pairs]] = True
    for _ in range(RINGS // 2):  # a way from one face to the other is near one of them
        near[shape.faces[near[shape.faces].any(axis=1)]] = True
    rows = np.flatnonzero(near[shape.faces].any(axis=1))
    number = np.full(len(shape.faces), -1)
    number[rows] = np.arange(len(rows))
    one, other = number[pairs].T
    return pairs[Crossings(shape.vertices, shape.faces[rows], node, radii, edges, length).apart(one, other)]


class _Grid(NamedTuple):
    """A grid of ``shape`` (3,) cubes of edge ``size``, from its corner ``low`` (3,)."""

    low: np.ndarray
    size: float
    shape: np.ndarray

    def cell(self, places: np.ndarray) -> np.ndarray:
        return np.floor((places - self.low) / self.size).astype(np.int64)

    def number(self, cell: np.ndarray) -> np.ndarray:
        return (cell[:, 0] * self.shape[1] + cell[:, 1]) * self.shape[2] + cell[:, 2]


def _grid_of(low: np.ndarray, high: np.ndarray) -> _Grid:
    """The grid for faces whose boxes have the corners ``low`` and ``high`` (F, 3)."""
    first, extent = low.min(axis=0), float(np.ptp(np.concatenate([low, high]), axis=0).max())
    size = max(CELL * float((high - low).max(axis=1).mean()), extent / LONGEST)
    while True:
        grid = _Grid(first, size, np.floor((high.max(axis=0) - first) / size).astype(np.int64) + 1)
        if (grid.cell(high) - grid.cell(low) + 1).prod(axis=1).sum() <= MOST_CELLS * len(low):
            return grid
        size *= 1.5


def _among(codes: np.ndarray, sorted_codes: np.ndarray) -> np.ndarray:
    """(c,) whether each code is among ``sorted_codes``, which are not empty."""
    return sorted_codes[np.minimum(np.searchsorted(sorted_codes, codes), len(sorted_codes) - 1)] == codes


def _codes_beside(faces: np.ndarray, num: int) -> np.ndarray:
    """u V + v of all pairs of vertices that at most ``RINGS`` edges join, ascending."""
    ends = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    ones = np.ones(len(ends), dtype=bool)
    table = graphs.weighted(num, *ends.T, weight=ones)
    step = sparse.csr_matrix(table + table.T + sparse.eye(num, dtype=bool, format="csr"))
    found = step
    for _ in range(RINGS - 1):
        found = sparse.csr_matrix(found @ step)
    entries = found.tocoo()
    return np.sort(entries.row.astype(np.int64) * num + entries.col)


def _codes_near(edges: np.ndarray, length: np.ndarray, radii: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """i N + j of all pairs of nodes within ``ALONG`` times their larger radius along the curve, ascending; and of those
    within half of that for their smaller radius. Two nodes that are so near to the same node are in the first list.
    """
    num = len(radii)
    near, close = ([np.arange(num) * (num + 1)] for _ in range(2))
    weight = np.maximum(length, 1e-300)  # SciPy takes an entry of 0 for a missing edge
    graph = graphs.weighted(num, *edges.T, weight=weight)
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
    """(c,) whether the triangles (c, 3, 3) of each pair cross: a side of one passes through the other."""
    found = np.zeros(len(one), dtype=bool)
    for a, b in ((one, other), (other, one)):
        for k in range(3):
            found |= _passes(a[:, k], a[:, (k + 1) % 3], b)
    return found


def _passes(start: np.ndarray, end: np.ndarray, triangle: np.ndarray) -> np.ndarray:
    """(c,) whether each segment passes through its triangle (c, 3, 3): its ends are on different sides of the plane,
    and its line is on the same side of all three edges. Both are signs of tetrahedron volumes."""
    a, b, c = np.moveaxis(triangle, 1, 0)
    normal, along = cross(b - a, c - a), end - start
    above, below = (np.einsum("ci,ci->c", place - a, normal) for place in (start, end))
    turns = np.stack([np.einsum("ci,ci->c", along, cross(u - start, v - start)) for u, v in ((a, b), (b, c), (c, a))])
    return (above * below < 0) & ((turns >= 0).all(axis=0) | (turns <= 0).all(axis=0))
