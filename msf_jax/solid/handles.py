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

from collections.abc import Iterator
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from scipy import sparse

from msf_jax.solid.geometry import PAIRS_AT_ONCE, repeated, unit, vertex_normals
from msf_jax.topology import graphs
from msf_jax.topology.graphs import along_forest, forest, loop_along, shortest_forest
from msf_jax.topology.half_edges import HalfEdges, half_edges

SEED = 2003  # seed of the random weights that combine all linking numbers into one number
CELLS = 96  # cells along each axis of the grid that finds pairs of segments
PUSH = 1e-9  # extents that the loops lie outside the surface, as a pinned node lies on it
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
        if len(ends):  # the normals of all vertices cost most of the time
            placed += PUSH * unit(vertex_normals(placed, faces))
        self._tail, self._head = (_turned(placed[ends[:, side]]) for side in (0, 1))

    @cached_property
    def _grid(self) -> "_SegmentGrid":
        return _SegmentGrid((self._tail[:, :2], self._head[:, :2]))

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
        p, p_end = (_turned((points - self._low) / self._extent) for points in (a, b))
        q, q_end = self._tail, self._head
        found = [(np.empty(0, dtype=np.int64),) * 3]

        def side(point: np.ndarray, start: np.ndarray, end: np.ndarray) -> np.ndarray:
            along, away = end - start, point - start
            return along[:, 0] * away[:, 1] - along[:, 1] * away[:, 0]

        for one, other in self._grid.pairs((p[:, :2], p_end[:, :2])) if len(a) and len(q) else ():
            s, s_end = (side(x[one], q[other], q_end[other]) for x in (p, p_end))
            is_across = (s >= 0) != (s_end >= 0)
            one, other, s, s_end = one[is_across], other[is_across], s[is_across], s_end[is_across]
            t, t_end = (side(x[other], p[one], p_end[one]) for x in (q, q_end))
            is_across = (t >= 0) != (t_end >= 0)
            one, other, s, s_end, t, t_end = (each[is_across] for each in (one, other, s, s_end, t, t_end))
            at_p, at_q = (s / (s - s_end)), (t / (t - t_end))
            height = p[one, 2] + at_p * (p_end - p)[one, 2] - q[other, 2] - at_q * (q_end - q)[other, 2]
            is_over = height > 0
            found.append((one[is_over], other[is_over], np.where(s_end > s, -1, 1)[is_over]))
        segment, edge, sign = (np.concatenate(each) for each in zip(*found, strict=True))
        return segment, edge, sign


def _turned(points: np.ndarray) -> np.ndarray:
    """``points`` (P, 3) in the axes of `TURN`. In a matrix product, the bits of a point could depend on its row, so
    this is written out."""
    x, y, z = points.T
    return np.stack([x * axis[0] + y * axis[1] + z * axis[2] for axis in TURN], axis=1)


class _SegmentGrid:
    """Segments of the plane with ends (n, 2), in the cells of a grid that their boxes touch. It is made once for all
    queries; what is beyond it counts as in its outermost cells."""

    def __init__(self, ends: tuple[np.ndarray, np.ndarray]):
        least, most = np.minimum(*ends), np.maximum(*ends)
        self._low = least.min(axis=0)
        self._size = np.maximum(most.max(axis=0) - self._low, 1e-300) / CELLS
        row, cell, self._first = self._listed(ends)
        order = np.argsort(cell, kind="stable")
        self._row, self._start = row[order], np.searchsorted(cell[order], np.arange(CELLS**2 + 1))

    def _listed(self, ends: tuple[np.ndarray, np.ndarray]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """The row (k,) of each segment, once for each of its cells (k,), and its first cell (n, 2)."""
        first, last = (
            np.clip((corner(*ends) - self._low) / self._size, 0, CELLS - 1).astype(np.int64)
            for corner in (np.minimum, np.maximum)
        )
        span = last - first + 1
        row, place = repeated(span[:, 0] * span[:, 1])
        cell = first[row] + np.stack([place // span[row, 1], place % span[row, 1]], axis=1)
        return row, cell[:, 0] * CELLS + cell[:, 1], first

    def pairs(self, ends: tuple[np.ndarray, np.ndarray]) -> Iterator[tuple[np.ndarray, np.ndarray]]:
        """Batches (k,) of pairs that may cross: of segments with ``ends`` (m, 2), and of the grid's."""
        one, cell, first = self._listed(ends)
        count = (self._start[1:] - self._start[:-1])[cell]
        batch = np.cumsum(count) // PAIRS_AT_ONCE
        for number in np.unique(batch[count > 0]):
            rows = np.flatnonzero(batch == number)
            row, place = repeated(count[rows])
            row = rows[row]
            a, b = one[row], self._row[self._start[cell[row]] + place]
            # A pair whose boxes share several cells counts in the first of them only.
            shared = np.maximum(first[a], self._first[b])
            is_first = shared[:, 0] * CELLS + shared[:, 1] == cell[row]
            yield a[is_first], b[is_first]
