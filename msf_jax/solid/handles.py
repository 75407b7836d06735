"""Which handles of a solid a curve inside it goes around, from linking numbers with loops of its surface.

The loops of a closed surface, from a tree and a cotree (Eppstein 2003), span the homology of the outside, which
Alexander duality pairs with that of the inside. A curve inside never meets the surface, so its linking numbers with
these loops are well defined. The rank of their matrix is the number of independent handles that its cycles go around.

The curtain of a loop is the half-infinite strip that the loop sweeps along one fixed direction. The linking number of a
closed curve with the loop is the sum of the curve's signed crossings with the curtain (Gauss's count in a projection).
So each segment has a class, and the classes along a path add up. Two paths inside with the same ends go around the same
handles exactly if their classes are equal: passes over a curve keep its loops.

Edges of the surface have classes, too. That of a loop of the surface is zero exactly if the loop bounds in the solid,
as loops around limbs do: such a loop may be pinched. The curve keeps the others.
"""

from typing import NamedTuple

import numpy as np
from scipy import sparse

from msf_jax.numerics.compiled import Ints, Points, Rows, kernel, part
from msf_jax.solid.geometry import RESOLUTION, ROUNDING, unit, vertex_normals
from msf_jax.solid.kernels import Vector, onward, overlaps, point_of, tree_of
from msf_jax.topology import graphs
from msf_jax.topology.graphs import HalfEdges, half_edges

PRIME = 2**20 - 3  # modulus of linear algebra: a rank is too small only if it divides a minor, which is unlikely
BLOCK = 64  # vectors that are reduced together
TURN = np.linalg.qr(np.random.default_rng(1987).normal(size=(3, 3)))[0]
TURN *= np.linalg.det(TURN)  # a rotation in general position: two axes across the curtains, then the curtains' own


class SurfaceLoops(NamedTuple):
    """2g loops of a closed surface that generate its homology.

    edges: the half-edges. closing: (2g,) the half-edge of each loop that is not in the tree of vertices. loops: (2g,)
    the vertices of each. to_parent: (F,) the half-edge from each face to its parent in a tree of faces, which no loop
    crosses, -1 at the root."""

    edges: HalfEdges
    closing: np.ndarray
    loops: list[list[int]]
    to_parent: np.ndarray


def surface_loops(faces: np.ndarray) -> SurfaceLoops:
    """Loops of the closed surface ``faces`` (F, 3), which may have several components."""
    edges = half_edges(faces)
    origin, target, twin = edges
    is_first = np.arange(len(origin)) < twin
    face = np.arange(len(origin)) // 3
    parent = graphs.forest(origin[is_first], target[is_first], int(faces.max(initial=-1)) + 1)
    in_tree = (parent[origin] == target) | (parent[target] == origin)
    is_left = is_first & ~in_tree
    face_parent = graphs.forest(face[is_left], face[twin[is_left]], len(faces))
    # Two faces can share several edges outside the tree; the cotree crosses the first of them.
    to_parent = np.full(len(faces), -1)
    leads_up = np.flatnonzero(~in_tree & (face_parent[face] == face[twin]))
    to_parent[face[leads_up[::-1]]] = leads_up[::-1]
    up = to_parent[to_parent >= 0]
    is_left[up] = is_left[twin[up]] = False
    closing, loops = np.flatnonzero(is_left), []
    for start, end in zip(origin[closing].tolist(), target[closing].tolist(), strict=True):
        one, other = [start], [end]  # the loop goes along the edge, and back along the tree
        for path in (one, other):
            while parent[path[-1]] >= 0:
                path.append(int(parent[path[-1]]))
        while len(one) > 1 and len(other) > 1 and one[-2] == other[-2]:
            one.pop()
            other.pop()
        loops.append([start, *(other[:-1] if len(one) == 1 else other), *one[-2:0:-1]])
    return SurfaceLoops(edges, closing, loops, to_parent)


class Span:
    """The span of integer vectors (n,) modulo a ``prime`` of at most 20 bits.

    Each of the rows (r, n) of its basis is 1 at its own pivot and 0 at those of the others. A vector v is in the span
    if v - sum over rows of v[pivot] row is 0. Floats hold all sums of up to 2^15 products of residues exactly."""

    def __init__(self, prime: int = PRIME):
        self._prime = prime
        self._rows, self._pivots = np.empty((0, 0)), np.empty(0, dtype=np.int64)

    def add(self, vectors: np.ndarray, most: int | None = None) -> np.ndarray:
        """Add ``vectors`` (k, n) in their order, until ``most`` were outside the span of those before: which (k,)."""
        is_new = np.zeros(len(vectors), dtype=bool)
        self._rows = self._rows.reshape(len(self._pivots), vectors.shape[1])
        for first in range(0, len(vectors), BLOCK):
            left = self._residues(vectors[first : first + BLOCK].astype(np.float64))
            left = self._residues(left - left[:, self._pivots] @ self._rows)
            chosen, pivots = [], []
            for number in np.flatnonzero(left.any(axis=1)).tolist():
                if not left[number].any() or is_new.sum() == most:
                    continue
                pivot = int(np.flatnonzero(left[number])[0])
                row = self._residues(left[number] * pow(int(left[number, pivot]), -1, self._prime))
                left = self._residues(left - left[:, [pivot]] * row)
                left[number], is_new[first + number] = row, True
                chosen, pivots = [*chosen, number], [*pivots, pivot]
            if chosen:
                rows = self._residues(self._rows - self._rows[:, pivots] @ left[chosen])
                self._rows, self._pivots = np.concatenate([rows, left[chosen]]), np.append(self._pivots, pivots)
        return is_new

    def _residues(self, values: np.ndarray) -> np.ndarray:
        """The residues of least size; 0 exactly for a multiple of the prime."""
        return values - self._prime * np.rint(values / self._prime)


class Curtains(NamedTuple):
    """The curtains of edges from tail to head (K, 3), upwards, and how often loop l runs along edge k: ``times[i]`` for
    ``loop[i]``, for i from ``first[k]`` to ``first[k + 1]``. boxes: (2K, 6), order: (K,), the tree of their boxes."""

    tail: Points
    head: Points
    boxes: Points
    order: Ints
    first: Ints
    loop: Ints
    times: Ints


@part
def side(point: Vector, start: Vector, end: Vector) -> float:
    """On which side of a line, seen along the curtains, a point is."""
    return (end[0] - start[0]) * (point[1] - start[1]) - (end[1] - start[1]) * (point[0] - start[0])


@kernel
def add_crossings(starts: Points, ends: Points, path: Ints, curtains: Curtains, found: Rows) -> None:
    """Add to ``found`` (R, L) the signed crossings of segments from ``starts`` to ``ends`` (E, 3), each in the row
    ``path`` (E,), with the curtains of each loop.

    Seen along the curtains, a segment crosses an edge if the ends of each are on different sides of the other.
    Segments that share an end compute the same side for it, so a path through it crosses once or not at all."""
    num = len(curtains.order)
    for row in range(len(starts)):
        p, p_end = point_of(starts, row), point_of(ends, row)
        low = min(p[0], p_end[0]), min(p[1], p_end[1]), -np.inf
        high = max(p[0], p_end[0]), max(p[1], p_end[1]), max(p[2], p_end[2])
        node = min(1, num)
        while node:
            is_met = overlaps(curtains.boxes, node, low, high)
            edge = curtains.order[node - num] if is_met and node >= num else -1
            node = onward(node, num, is_met)
            if edge < 0:
                continue
            q, q_end = point_of(curtains.tail, edge), point_of(curtains.head, edge)
            s, s_end, t, t_end = side(p, q, q_end), side(p_end, q, q_end), side(q, p, p_end), side(q_end, p, p_end)
            if (s >= 0) == (s_end >= 0) or (t >= 0) == (t_end >= 0):
                continue
            at_p, at_q = s / (s - s_end), t / (t - t_end)
            if p[2] + at_p * (p_end[2] - p[2]) - q[2] - at_q * (q_end[2] - q[2]) > 0:
                for k in range(curtains.first[edge], curtains.first[edge + 1]):
                    found[path[row], curtains.loop[k]] += -curtains.times[k] if s_end > s else curtains.times[k]


class Handles:
    """The handles of a solid, to be asked which of them a curve inside goes around.

    Args:
        vertices: (V, 3), any unit.
        faces: (F, 3), closed and oriented, of one component or several.
    """

    def __init__(self, vertices: np.ndarray, faces: np.ndarray):
        # V - E + F is 2 for a component without handles, and a vertex without a face is one.
        label = graphs.labels_of_faces(faces, int(faces.max()) + 1)
        num_used = np.count_nonzero(np.bincount(faces.ravel()))
        num_components = label.max() + 1 - (len(label) - num_used)
        self.surface = surface_loops(faces if num_used - len(faces) // 2 < 2 * num_components else faces[:0])
        loops = self.surface.loops
        self.genus = len(loops) // 2
        number = np.repeat(np.arange(len(loops)), np.array([len(loop) for loop in loops], dtype=np.int64))
        tail = np.array([vertex for loop in loops for vertex in loop], dtype=np.int64)
        head = np.array([vertex for loop in loops for vertex in [*loop[1:], loop[0]]], dtype=np.int64)
        # Loops share most of their edges: each edge is tested once.
        ends, edge = np.unique(np.sort(np.stack([tail, head], axis=1), axis=1), axis=0, return_inverse=True)
        sign = np.where(tail == ends[edge.ravel(), 0], 1, -1)
        times = sparse.csr_matrix((sign, (edge.ravel(), number)), shape=(len(ends), len(loops)))
        # Lengths are fractions of the extent, so that no square overflows or underflows.
        self._low = vertices.min(axis=0)
        self._extent = max(float((vertices.max(axis=0) - self._low).max()), 1e-300)
        placed = (vertices - self._low) / self._extent
        # Loops lie outside the surface, as a pinned node lies on it. Normals cost most of the time.
        normals = unit(vertex_normals(placed, faces)) if loops else np.zeros_like(placed)
        begin, end = (_turned((placed + ROUNDING * normals)[each]) for each in ends.T)
        boxes, order = tree_of(np.minimum(begin, end), np.maximum(begin, end))
        first, loop = times.indptr.astype(np.int64), times.indices.astype(np.int64)
        self._each = Curtains(begin, end, boxes, order, first, loop, times.data)
        value = times @ np.random.default_rng(2003).integers(1, 2**30, size=len(loops))
        rank = np.arange(len(ends) + 1)
        self._combined = self._each._replace(first=rank, loop=np.zeros_like(rank), times=value)
        inner = vertices - RESOLUTION * self._extent * normals
        self._inside = inner[tail], inner[head], number  # the edges of all loops, just inside

    def half_edge_classes(self) -> np.ndarray:
        """The class (3F,) of every half-edge of the surface; twins have opposite classes.

        Along a loop of the surface they add up to the class of the loop just inside, and around each face to zero. In
        the tree of vertices they are 0, so the edge that closes a loop has the loop's class. The tree of faces carries
        what is then left around a face to its root, where it cancels."""
        edges, closing, _, to_parent = self.surface
        found, of_loops = np.zeros(len(edges.twin), dtype=np.int64), self._sums(*self._inside, self._combined, 1)[:, 0]
        half, left = np.r_[closing, edges.twin[closing]], np.r_[of_loops, -of_loops]
        found[half] = left
        while len(half):
            half = to_parent[half // 3]
            half, left = half[half >= 0], left[half >= 0]
            np.subtract.at(found, half, left)
            half = edges.twin[half]
            np.add.at(found, half, left)
        return found

    def classes(self, a: np.ndarray, b: np.ndarray) -> np.ndarray:
        """The class (E,) of each segment from a (E, 3) to b (E, 3): a fixed random combination of its crossings.

        Along a closed curve inside, the classes add up to zero if it goes around no handle. If it goes around one, the
        sum is zero with a probability of 10^-9."""
        return self._sums(a, b, np.arange(len(a)), self._combined, 1)[:, 0]

    def linking(self, a: np.ndarray, b: np.ndarray, path: np.ndarray | None = None) -> np.ndarray:
        """The parts (E, 2g) of segments from a (E, 3) to b (E, 3) in the linking numbers with the surface's loops, or,
        if ``path`` (E,) is the number of the path that each belongs to, of each path."""
        return self._sums(a, b, np.arange(len(a)) if path is None else path, self._each, 2 * self.genus)

    def _sums(self, a: np.ndarray, b: np.ndarray, path: np.ndarray, curtains: Curtains, num: int) -> np.ndarray:
        found = np.zeros((int(path.max(initial=-1)) + 1, num), dtype=np.int64)
        add_crossings(*(_turned((points - self._low) / self._extent) for points in (a, b)), path, curtains, found)
        return found


def _turned(points: np.ndarray) -> np.ndarray:
    """``points`` (P, 3) in the axes of `TURN`. In a matrix product, the bits of a point could depend on its row, so
    this is written out."""
    x, y, z = points.T
    return np.stack([x * axis[0] + y * axis[1] + z * axis[2] for axis in TURN], axis=1)
