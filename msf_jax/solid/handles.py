"""Which handles of a solid a curve inside it goes around, from linking numbers with loops of its surface.

The loops of a closed surface span the homology of the outside, which Alexander duality pairs with that of the inside. A
curve inside never meets the surface, so its linking numbers with the surface's loops are well defined. The rank of
their matrix is the number of independent handles that its cycles go around.

The curtain of a loop is the half-infinite strip that the loop sweeps along one fixed direction. The linking number of a
closed curve with the loop is the sum of the curve's signed crossings with the curtain (Gauss's count in a projection).
This sum is a sum over segments, so each segment has a class, and the classes along a path add up. Two paths inside with
the same ends go around the same handles exactly if their classes are equal. So passes over a curve keep its loops.

Edges of the surface have classes, too. The class of a loop of the surface is zero if, and only if, it bounds in the
solid, as loops around limbs do: such a loop may be pinched. The others are the cycles of the curve.

The surface's loops come from a tree and a cotree (Eppstein 2003).
"""

from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from scipy import sparse

from msf_jax.numerics.compiled import Ints, Points, Reals, Rows, kernel, part
from msf_jax.solid.geometry import ROUNDING, repeated, unit, vertex_normals
from msf_jax.topology import graphs
from msf_jax.topology.graphs import forest, loop_along
from msf_jax.topology.half_edges import HalfEdges, half_edges

SEED = 2003  # of the weights that combine linking numbers into one
CELLS = 96  # cells along each axis of the grid that finds pairs of segments
CROSSINGS_AT_FIRST = 8  # crossings a segment for which memory is allocated first; few segments have more
PUSH = 1e-3  # mean edge lengths, by which loops lie outside the surface where its own edges have classes
SMOOTHINGS = (0, 1, 1, 2, 4, 8, 16)  # successive numbers of rounds that smooth a surface which crosses itself
PRIME = 2**20 - 3  # modulus of linear algebra: a rank is too small only if it divides a minor, which is unlikely
BLOCK = 64  # vectors that are reduced together
TURN = np.linalg.qr(np.random.default_rng(1987).normal(size=(3, 3)))[0]
TURN *= np.linalg.det(TURN)  # a rotation in general position: two axes across the curtains, then the curtains' own


class SurfaceLoops(NamedTuple):
    """2g loops of a closed surface that generate its homology.

    edges: the half-edges. generator: (2g,) the half-edge that closes each loop. loops: (2g,) lists of vertices.
    to_parent: (F,) the half-edge from each face to its parent in the cotree, -1 at the root.
    """

    edges: HalfEdges
    generator: np.ndarray
    loops: list[list[int]]
    to_parent: np.ndarray

    def steps(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """The ends (k,) of all edges that loops run along, and the loop of each."""
        number, _ = repeated(np.array([len(loop) for loop in self.loops], dtype=np.int64))
        tail = np.array([vertex for loop in self.loops for vertex in loop], dtype=np.int64)
        return tail, np.array([v for loop in self.loops for v in [*loop[1:], loop[0]]], dtype=np.int64), number


def surface_loops(faces: np.ndarray) -> SurfaceLoops:
    """Loops of the closed surface ``faces`` (F, 3), which may have several components."""
    edges = half_edges(faces)
    is_first = np.arange(len(edges.origin)) < edges.twin
    face = np.arange(len(edges.origin)) // 3
    parent, _ = forest(edges.origin[is_first], edges.target[is_first], int(faces.max()) + 1)
    in_tree = (parent[edges.origin] == edges.target) | (parent[edges.target] == edges.origin)
    crossed = is_first & ~in_tree
    face_parent, _ = forest(face[crossed], face[edges.twin[crossed]], len(faces))
    # Two faces can share several edges outside the tree; the cotree crosses the first of them.
    to_parent = np.full(len(faces), -1)
    leads_up = np.flatnonzero(~in_tree & (face_parent[face] == face[edges.twin]))
    to_parent[face[leads_up[::-1]]] = leads_up[::-1]
    up = to_parent[to_parent >= 0]
    crossed[up] = crossed[edges.twin[up]] = False
    generator = np.flatnonzero(crossed)
    loops = [loop_along(int(edges.origin[half]), int(edges.target[half]), parent) for half in generator]
    return SurfaceLoops(edges, generator, loops, to_parent)


def half_edge_classes(vertices: np.ndarray, faces: np.ndarray, surface: SurfaceLoops) -> np.ndarray | None:
    """The class (3F,) of every half-edge of a connected ``surface``; twins have opposite classes.

    They are made of the linking numbers of the surface's loops with the same loops, pushed out. In a solid their matrix
    L has rank g, and L - L^T, the crossings of loops on the surface, has determinant 1. Where this fails the surface
    crosses itself, and L is taken from the slightly smoothed surface, whose loops have the same classes. None if that
    fails, too.
    """
    edges, generator, _, to_parent = surface
    tail, head, number = surface.steps()
    neighbours = graphs.weighted(len(vertices), edges.origin, edges.target)
    count = np.maximum(np.bincount(edges.origin, minlength=len(vertices)), 1)[:, None]
    for rounds in SMOOTHINGS:
        for _ in range(rounds):
            vertices = (vertices + neighbours @ vertices / count) / 2
        spacing = np.linalg.norm(vertices[edges.origin] - vertices[edges.target], axis=1).mean()
        handles = Handles(vertices, faces, surface, PUSH * float(spacing / np.ptp(vertices, axis=0).max()))
        linking = handles.linking(vertices[tail], vertices[head], number)
        sign, size = np.linalg.slogdet(linking - linking.T)
        if sign and abs(size) < 0.5 and 2 * Span().add(linking).sum() == len(generator):
            break
    else:
        return None
    # Classes are zero on the tree, and known on generators. As those of a face sum to zero, the class of a generator is
    # carried up the cotree from the faces on both sides.
    value = np.zeros(len(edges.origin), dtype=np.int64)
    value[generator] = linking @ handles.weight
    half, carried = np.r_[generator, edges.twin[generator]], np.r_[value[generator], -value[generator]]
    while len(half):
        half = to_parent[half // 3]
        half, carried = half[half >= 0], carried[half >= 0]
        np.subtract.at(value, half, carried)
        half = edges.twin[half]
    return value - value[edges.twin]


class Span:
    """The span of integer vectors (n,) modulo a ``prime`` of at most 20 bits.

    Each of the rows (r, n) of its basis is 1 at its own pivot and 0 at those of the others. A vector v is in the span
    if v - sum over rows of v[pivot] row is 0. Floats hold all sums of up to 2^15 products of residues exactly.
    """

    def __init__(self, prime: int = PRIME):
        self._prime = prime
        self._rows, self._pivots = np.empty((0, 0)), np.empty(0, dtype=np.int64)

    def add(self, vectors: np.ndarray, most: int | None = None) -> np.ndarray:
        """Add ``vectors`` (k, n) in their order, until ``most`` were outside the span of those before: which (k,)."""
        is_new = np.zeros(len(vectors), dtype=bool)
        if not len(self._rows):
            self._rows = np.empty((0, vectors.shape[1]))
        for first in range(0, len(vectors), BLOCK):
            left = self._residues(vectors[first : first + BLOCK].astype(np.float64))
            left = self._residues(left - left[:, self._pivots] @ self._rows)
            chosen, pivots = [], []
            for number in np.flatnonzero(left.any(axis=1)).tolist():
                if not left[number].any() or is_new.sum() == most:
                    continue
                pivots.append(int(np.flatnonzero(left[number])[0]))
                left[number] = self._residues(left[number] * pow(int(left[number, pivots[-1]]), -1, self._prime))
                others = np.arange(len(left)) != number
                left[others] = self._residues(left[others] - left[others][:, pivots[-1:]] * left[number])
                chosen.append(number)
                is_new[first + number] = True
            if chosen:
                rows = self._residues(self._rows - self._rows[:, pivots] @ left[chosen])
                self._rows, self._pivots = np.concatenate([rows, left[chosen]]), np.append(self._pivots, pivots)
        return is_new

    def _residues(self, values: np.ndarray) -> np.ndarray:
        """The residues of least size; 0 exactly for a multiple of the prime."""
        return values - self._prime * np.rint(values / self._prime)


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
        surface: their loops, if known.
        push: by how much these lie outside, in lengths of the solid.
    """

    def __init__(
        self, vertices: np.ndarray, faces: np.ndarray, surface: SurfaceLoops | None = None, push: float = ROUNDING
    ):
        self.surface = surface or surface_loops(faces)
        num = len(self.surface.generator)
        self.genus = num // 2
        tail, head, number = self.surface.steps()
        # Loops share most of their edges: each edge is tested once.
        ends, edge = np.unique(np.sort(np.stack([tail, head], axis=1), axis=1), axis=0, return_inverse=True)
        sign = np.where(tail == ends[edge.ravel(), 0], 1, -1) if len(tail) else tail
        times = sparse.coo_matrix((sign, (edge.ravel(), number)), shape=(len(ends), num))
        self._times = times.tocsr()  # (K, 2g) how often each loop runs along each edge
        self.weight = np.random.default_rng(SEED).integers(1, 2**30, size=num)
        self._value = self._times @ self.weight
        # Lengths are fractions of the extent, so that no square overflows or underflows.
        self._low = vertices.min(axis=0)
        self._extent = max(float((vertices.max(axis=0) - self._low).max()), 1e-300)
        placed = (vertices - self._low) / self._extent
        if num:  # loops lie outside the surface, as a pinned node lies on it; normals cost most of the time
            placed += push * unit(vertex_normals(placed, faces))
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
