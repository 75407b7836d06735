"""Which handles of a solid a curve inside it goes around, from linking numbers with loops of its surface.

The loops of a closed surface span the homology of the outside, which Alexander duality pairs with that of the inside. A
curve inside never meets the surface, so its linking numbers with the surface's loops are well defined. The rank of
their matrix is the number of independent handles that its cycles go around.

The curtain of a loop is the half-infinite strip that the loop sweeps along one fixed direction. The linking number of a
closed curve with the loop is the sum of the curve's signed crossings with the curtain (Gauss's count in a projection).
This sum is a sum over segments, so each segment has a class, and the classes along a path add up. Two paths inside with
the same ends go around the same handles exactly if their classes are equal. So passes over a curve keep its loops.

The surface's loops come from a tree and a cotree (Eppstein 2003).
"""

from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from scipy import sparse

from msf_jax.numerics.compiled import Ints, Points, Reals, Rows, kernel, part
from msf_jax.solid.geometry import ROUNDING, repeated, unit, vertex_normals
from msf_jax.topology import graphs
from msf_jax.topology.graphs import along_forest, forest, loop_along, shortest_forest
from msf_jax.topology.half_edges import HalfEdges, half_edges

SEED = 2003  # of all random numbers: weights that combine linking numbers into one, and linear forms
CELLS = 96  # cells along each axis of the grid that finds pairs of segments
CROSSINGS_AT_FIRST = 8  # crossings a segment for which memory is allocated first; few segments have more
TURN = np.linalg.qr(np.random.default_rng(1987).normal(size=(3, 3)))[0]
TURN *= np.linalg.det(TURN)  # a rotation in general position: two axes across the curtains, then the curtains' own


class SurfaceLoops(NamedTuple):
    """2g loops of a closed surface that generate its homology.

    edges: the half-edges. generator: (2g,) the half-edge that closes each loop. loops: (2g,) lists of vertices.
    to_parent: (F,) the half-edge from each face to its parent in the cotree, -1 at the root.
    depth: (F,) of each face in the cotree.
    """

    edges: HalfEdges
    generator: np.ndarray
    loops: list[list[int]]
    to_parent: np.ndarray
    depth: np.ndarray


def surface_loops(faces: np.ndarray) -> SurfaceLoops:
    """Loops of the closed surface ``faces`` (F, 3), which may have several components."""
    edges = half_edges(faces)
    num_half, num_faces = len(edges.origin), len(faces)
    is_first = np.arange(num_half) < edges.twin
    face = np.arange(num_half) // 3
    parent, _ = forest(edges.origin[is_first], edges.target[is_first], int(faces.max()) + 1)
    in_tree = (parent[edges.origin] == edges.target) | (parent[edges.target] == edges.origin)
    crossed = is_first & ~in_tree
    face_parent, depth = forest(face[crossed], face[edges.twin[crossed]], num_faces)
    # Two faces can share several edges outside the tree; the cotree crosses the first of them.
    to_parent = np.full(num_faces, -1)
    leads_up = np.flatnonzero(~in_tree & (face_parent[face] == face[edges.twin]))
    to_parent[face[leads_up[::-1]]] = leads_up[::-1]
    in_cotree = np.zeros(num_half, dtype=bool)
    in_cotree[to_parent[to_parent >= 0]] = True
    in_cotree |= in_cotree[edges.twin]
    generator = np.flatnonzero(is_first & ~in_tree & ~in_cotree)
    loops = [loop_along(int(edges.origin[half]), int(edges.target[half]), parent) for half in generator]
    return SurfaceLoops(edges, generator, loops, to_parent, depth)


def _has_handles(faces: np.ndarray) -> bool:
    """Whether V - E + F of the closed surface is below 2 for a component: quicker than its loops."""
    num = int(faces.max()) + 1
    num_components = graphs.labels_of_faces(faces, num).max() + 1  # vertices without a face are components
    return num - len(faces) // 2 < 2 * num_components - np.count_nonzero(np.bincount(faces.ravel()) == 0)


class Grid(NamedTuple):
    """Edges in the cells of a grid of the plane across the curtains that their boxes touch.

    low, size: (2,) of the first cell. first: (K, 2) the first cell of each edge. listed: the edges by cells; those of
    cell k begin at ``start[k]``.
    """

    low: Reals
    size: Reals
    first: Rows
    start: Ints
    listed: Ints


def grid_of(tail: np.ndarray, head: np.ndarray) -> Grid:
    """The grid of the edges from ``tail`` to ``head`` (K, 2)."""
    least, most = np.minimum(tail, head), np.maximum(tail, head)
    low = least.min(axis=0)
    size = np.maximum(most.max(axis=0) - low, 1e-300) / CELLS
    first, last = (np.clip((ends - low) / size, 0, CELLS - 1).astype(np.int64) for ends in (least, most))
    span = last - first + 1
    row, place = repeated(span[:, 0] * span[:, 1])
    cell = (first[row, 0] + place // span[row, 1]) * CELLS + first[row, 1] + place % span[row, 1]
    order = np.argsort(cell, kind="stable")
    return Grid(low, size, first, np.searchsorted(cell[order], np.arange(CELLS**2 + 1)), row[order])


@part
def side(points: Points, row: int, start: Points, end: Points, line: int) -> float:
    """On which side of a line of the plane a point is."""
    x, y = end[line, 0] - start[line, 0], end[line, 1] - start[line, 1]
    return x * (points[row, 1] - start[line, 1]) - y * (points[row, 0] - start[line, 0])


@part
def cell_of(x: float, low: float, size: float) -> int:
    """The cell of a coordinate, along an axis; what is beyond the grid counts as in its outermost cells."""
    return int(min(max((x - low) / size, 0.0), CELLS - 1.0))


@kernel
def crossed(
    p: Points,
    p_end: Points,
    q: Points,
    q_end: Points,
    grid: Grid,
    segment: Ints,
    edge: Ints,
    sign: Ints,
) -> int:
    """Crossings of segments from p to p_end (E, 3) with the curtains of edges from q to q_end (K, 3) in a ``grid``.

    Returns the number of crossings; ``segment``, ``edge`` and ``sign`` hold the first of them, up to their length.
    """
    low, size, first, count = grid.low, grid.size, grid.first, 0
    for one in range(len(p)):
        left, right = min(p[one, 0], p_end[one, 0]), max(p[one, 0], p_end[one, 0])
        first_x, last_x = cell_of(left, low[0], size[0]), cell_of(right, low[0], size[0])
        left, right = min(p[one, 1], p_end[one, 1]), max(p[one, 1], p_end[one, 1])
        first_y, last_y = cell_of(left, low[1], size[1]), cell_of(right, low[1], size[1])
        for column in range(first_x, last_x + 1):
            for line in range(first_y, last_y + 1):
                for at in range(grid.start[column * CELLS + line], grid.start[column * CELLS + line + 1]):
                    other = grid.listed[at]
                    # A pair whose boxes share several cells counts in the first of them only.
                    if max(first_x, first[other, 0]) != column or max(first_y, first[other, 1]) != line:
                        continue
                    s, s_end = side(p, one, q, q_end, other), side(p_end, one, q, q_end, other)
                    t, t_end = side(q, other, p, p_end, one), side(q_end, other, p, p_end, one)
                    if (s >= 0) == (s_end >= 0) or (t >= 0) == (t_end >= 0):
                        continue
                    at_p, at_q = s / (s - s_end), t / (t - t_end)
                    height = p[one, 2] + at_p * (p_end[one, 2] - p[one, 2]) - q[other, 2]
                    if height - at_q * (q_end[other, 2] - q[other, 2]) > 0:
                        if count < len(segment):
                            segment[count], edge[count], sign[count] = one, other, -1 if s_end > s else 1
                        count += 1
    return count


class Handles:
    """The handles of a solid, to be asked which of them a curve inside goes around.

    Args:
        vertices: (V, 3), any unit.
        faces: (F, 3), closed and oriented, of one component or several.
    """

    def __init__(self, vertices: np.ndarray, faces: np.ndarray):
        loops = surface_loops(faces).loops if _has_handles(faces) else []
        self.genus = len(loops) // 2
        number, _ = repeated(np.array([len(loop) for loop in loops], dtype=np.int64))
        tail = np.array([vertex for loop in loops for vertex in loop], dtype=np.int64)
        head = np.array([vertex for loop in loops for vertex in [*loop[1:], loop[0]]], dtype=np.int64)
        # Loops share most of their edges: each edge is tested once.
        ends, edge = np.unique(np.sort(np.stack([tail, head], axis=1), axis=1), axis=0, return_inverse=True)
        sign = np.where(tail == ends[edge.ravel(), 0], 1, -1) if len(tail) else tail
        times = sparse.coo_matrix((sign, (edge.ravel(), number)), shape=(len(ends), len(loops)))
        self._times = times.tocsr()  # (K, 2g) how often each loop runs along each edge
        weight = np.random.default_rng(SEED).integers(1, 2**30, size=len(loops))
        self._value = self._times @ weight if len(loops) else np.empty(0, dtype=np.int64)
        # Lengths are fractions of the extent, so that no square overflows or underflows.
        self._low = vertices.min(axis=0)
        self._extent = max(float((vertices.max(axis=0) - self._low).max()), 1e-300)
        placed = (vertices - self._low) / self._extent
        if len(ends):  # loops lie outside the surface, as a pinned node lies on it; normals cost most of the time
            placed += ROUNDING * unit(vertex_normals(placed, faces))
        self._tail, self._head = (_turned(placed[ends[:, side]]) for side in (0, 1))

    @cached_property
    def _grid(self) -> Grid:
        return grid_of(self._tail[:, :2], self._head[:, :2])

    def classes(self, a: np.ndarray, b: np.ndarray) -> np.ndarray:
        """The class (E,) of each segment from a (E, 3) to b (E, 3): a fixed random combination of its crossings.

        Along a closed curve inside, the classes add up to zero if it goes around no handle. If it goes around one, the
        sum is zero with a probability of 10^-9.
        """
        segment, edge, sign = self._crossings(a, b)
        found = np.zeros(len(a), dtype=np.int64)
        np.add.at(found, segment, sign * self._value[edge])
        return found

    def windings(
        self, vertices: np.ndarray, edges: np.ndarray, length: np.ndarray | None = None
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """A basis of the curve's cycles: the edge (C,) that closes each cycle of a shortest spanning forest, and the
        cycles' linking numbers (C, 2g) with the surface's loops; and their parts (N, 2g) along the forest, from a root
        to each node. ``length`` (E,) replaces the edges' own, if given."""
        num, (a, b) = len(vertices), edges.T
        size = np.linalg.norm(vertices[a] - vertices[b], axis=1) if length is None else length
        in_forest = shortest_forest(num, edges, size)
        linking = self.linking(vertices[a], vertices[b])
        potential = along_forest(num, edges[in_forest], linking[in_forest])
        closing = np.flatnonzero(~in_forest)
        return closing, linking[closing] + potential[a[closing]] - potential[b[closing]], potential

    def linking(self, a: np.ndarray, b: np.ndarray, path: np.ndarray | None = None) -> np.ndarray:
        """The parts (E, 2g) of segments from a (E, 3) to b (E, 3) in the linking numbers with the surface's loops, or,
        if ``path`` (E,) is the number of the path that each belongs to, of each path."""
        segment, edge, sign = self._crossings(a, b)
        row, num = (segment, len(a)) if path is None else (path[segment], int(path.max()) + 1)
        crossed: Any = sparse.csr_matrix((sign, (row, edge)), shape=(num, len(self._tail)))
        return (crossed @ self._times).astype(np.int32).toarray()

    def _crossings(self, a: np.ndarray, b: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Crossings of segments from a (E, 3) to b (E, 3) with curtains: the segment, the edge that sweeps the curtain,
        and the sign, (k,) each.

        Seen along the curtains, a segment crosses an edge if the ends of each are on different sides of the other.
        Segments that share an end compute the same side for it, so a path through it crosses once or not at all.
        """
        found = np.empty((3, CROSSINGS_AT_FIRST * len(a)), dtype=np.int64)
        if not (len(a) and len(self._tail)):
            return found[0, :0], found[1, :0], found[2, :0]
        ends = [_turned((points - self._low) / self._extent) for points in (a, b)]
        while (count := crossed(*ends, self._tail, self._head, self._grid, *found)) > found.shape[1]:
            found = np.empty((3, count), dtype=np.int64)
        return found[0, :count], found[1, :count], found[2, :count]


def _turned(points: np.ndarray) -> np.ndarray:
    """``points`` (P, 3) in the axes of `TURN`. In a matrix product, the bits of a point could depend on its row, so
    this is written out."""
    x, y, z = points.T
    return np.stack([x * axis[0] + y * axis[1] + z * axis[2] for axis in TURN], axis=1)
