"""One loop of the curve around every handle of the solid: false loops are cut open, and missing ones are added.

The flow tracks, on its edges, which loops of the surface vanish in the solid, so its graph has a cycle for each handle.
But on a coarse or thin solid its nodes can slide across holes, and then a cycle may go around nothing in space. A cycle
is cut at its longest edge if it goes around no handle, or only around handles of other cycles. For each remaining
handle, the shortest path inside from the curve, around the handle and back to the curve is added. The search is like
that for the shortest loops of a surface (Erickson, Whittlesey 2005). Every edge of a roadmap of the solid (see
`roadmap`) closes one loop with a forest of shortest paths from the curve. The shortest loop is taken whose linking
numbers are independent of those of the present loops.
"""

from collections.abc import Iterator
from itertools import islice
from typing import NamedTuple

import numpy as np

from msf_jax.inside.containment import is_inside
from msf_jax.inside.roadmap import Roadmap
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.frame import RESOLUTION
from msf_jax.solid.geometry import signed_volume
from msf_jax.solid.handles import SEED
from msf_jax.solid.solid import bodies
from msf_jax.topology import graphs
from msf_jax.topology.graphs import shortest_forest

PRIME = 2**24 - 3  # modulus of linear algebra: a rank is too small only if it divides a minor, which is unlikely
BLOCK = 64  # vectors that are reduced together
FACTORS = (2, 3)  # moduli with a smaller rank if loops go around handles several times
# Linking numbers, of edges of a curve with loops of the surface, that are computed for one curve (1 GB), and those of
# all paths that are tried for one curve. One of 13,000 edges in a solid of genus 1,409 has 4e7, its search takes 8e7.
MOST_LINKING = 2**28
AT_ONCE = 8  # loops added in a round: at least so many, or a quarter of the missing ones


class _Basis(NamedTuple):
    """rows: (r, n), each 1 at its own pivot and 0 at those of the others. pivots: (r,)."""

    rows: np.ndarray
    pivots: np.ndarray


def _nothing(size: int) -> _Basis:
    return _Basis(np.empty((0, size)), np.empty(0, dtype=np.int64))


class Span:
    """The span of integer vectors modulo a ``prime`` of at most 24 bits.

    Most vectors that are asked for are in the span. So first they meet a sieve: random linear forms that are 0 on the
    span. If all are 0 on a vector, it is in the span, or outside with a probability of prime^-64. Vectors that are
    added are kept until there are `BLOCK` of them; meanwhile the sieve's values of vectors stand for the vectors. Then
    they become a block of an echelon basis: its rows are 0 at the pivots of blocks before it, and reduced among
    themselves. All is done by products of matrices, in floats that are exact integers.
    """

    def __init__(self, size: int, prime: int = PRIME):
        self._prime = prime
        self._random = np.random.default_rng(SEED)
        self._size, self._blocks, self._added = size, [], []
        self._refill()

    def adds_all(self, vectors: np.ndarray) -> np.ndarray:
        """Whether each of ``vectors`` (k, size), in their order, is outside the span of those before it: (k,)."""
        return np.fromiter(self.each_added(vectors), dtype=bool, count=len(vectors))

    def each_added(self, vectors: np.ndarray) -> Iterator[bool]:
        """Whether one of ``vectors`` (k, size) after the other is outside the span, and then added; those that are not
        asked for are not added."""
        done = 0
        while done < len(vectors):
            if len(self._added) == BLOCK:
                self._refill()
            some = self._residues((vectors[done : done + BLOCK] % self._prime).astype(np.float64))
            left = self._product(some, self._sieve)
            left = self._residues(left - self._product(left[:, self._values[1]], self._values[0]))
            for number in range(len(left)):
                done += 1
                is_new = bool(left[number].any())
                if is_new:
                    self._added.append(some[number])
                    self._values, left[number + 1 :] = self._with(self._values, left[number], left[number + 1 :])
                yield is_new
                if len(self._added) == BLOCK:
                    break

    def _refill(self) -> None:
        """Make a block of the vectors that were added, and a new sieve."""
        left = np.array(self._added, dtype=np.float64).reshape(len(self._added), self._size)
        basis = _nothing(self._size)
        for rows, pivots in self._blocks:
            left = self._residues(left - self._product(left[:, pivots], rows))
        for number in range(len(left)):
            if left[number].any():
                basis, left[number + 1 :] = self._with(basis, left[number], left[number + 1 :])
        self._blocks.append(basis)
        half = self._prime // 2
        self._sieve = self._random.integers(-half, half + 1, (self._size, 2 * BLOCK)).astype(np.float64)
        for rows, pivots in self._blocks[::-1]:  # a form is free where there is no pivot
            self._sieve[pivots] = 0.0
            self._sieve[pivots] = self._residues(-self._product(rows, self._sieve))
        self._added, self._values = [], _nothing(2 * BLOCK)

    def _with(self, basis: _Basis, row: np.ndarray, others: np.ndarray) -> tuple[_Basis, np.ndarray]:
        """A reduced ``basis`` with one more ``row``, which is not 0, and ``others`` (k, n) reduced by it, too."""
        rows, pivots = basis
        pivot = int(np.flatnonzero(row)[0])
        row = self._residues(row * pow(int(row[pivot]), -1, self._prime))
        rows, others = (self._residues(each - each[:, [pivot]] * row) for each in (rows, others))
        return _Basis(np.concatenate([rows, row[None]]), np.append(pivots, pivot)), others

    def _product(self, a: np.ndarray, b: np.ndarray) -> np.ndarray:
        """The residues of a @ b, by so many terms at a time that all sums are below 2^53."""
        largest = (np.abs(a).max(initial=1.0) + 1) * (np.abs(b).max(initial=1.0) + 1)
        terms, found = max(int(2.0**52 / largest), 1), np.zeros((len(a), b.shape[1]))
        for first in range(0, len(b), terms):
            found = self._residues(found + a[:, first : first + terms] @ b[first : first + terms])
        return found

    def _residues(self, values: np.ndarray) -> np.ndarray:
        """The residues of least size; 0 exactly for a multiple of the prime."""
        return values - self._prime * np.rint(values / self._prime)


class Proof(NamedTuple):
    """rank: independent handles of the solid that a curve's cycles go around.

    The rest are edges (k,) of the curve, one for each doubtful cycle. none: it goes around no handle. again: it depends
    on the cycles before it. several: it goes around a handle several times, also after cycles before it are subtracted,
    so the cycles are no basis of the solid's loops. outside: it leaves the solid, which proves nothing.

    unproved: handles of solids that have too many for a proof, see `MOST_LINKING`.
    """

    rank: int
    none: np.ndarray
    again: np.ndarray
    several: np.ndarray
    outside: np.ndarray
    unproved: int


def proof(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray, node_of_vertex: np.ndarray | None = None) -> Proof:
    """Which cycles of the curve ``(vertices (N, 3), edges (E, 2))`` go around handles of the solid ``shape``.

    If the solid has several components, which may overlap, each part of the curve is tested in its own component: that
    of the vertices that ``node_of_vertex`` (V,) maps to its nodes, or else the smallest that contains it.
    """
    closing = np.flatnonzero(~shortest_forest(len(vertices), edges, np.zeros(len(edges))))
    part = graphs.labels(len(vertices), *edges.T)
    has_cycle = np.zeros(len(vertices), dtype=bool)
    has_cycle[part[edges[closing, 0]]] = True
    rank, found = 0, {name: [np.empty(0, dtype=np.int64)] for name in Proof._fields[1:-1]}
    unproved = 0
    for solid, of_part in _solids(shape, vertices, part, has_cycle, node_of_vertex):
        own = np.flatnonzero((has_cycle & of_part)[part[edges[:, 0]]])
        if are_too_many(solid, edges[own]):
            unproved += solid.handles.genus
            continue
        length, is_out = _lengths(solid, vertices, edges[own])
        closing, windings, _ = solid.handles.windings(vertices, edges[own], length)
        span, factors = Span(windings.shape[1]), [Span(windings.shape[1], factor) for factor in FACTORS]
        order = np.argsort(length[closing], kind="stable")
        edge, winding = closing[order], windings[order]
        is_none, is_new = ~is_out[edge] & ~winding.any(axis=1), np.zeros(len(edge), dtype=bool)
        asked = np.flatnonzero(~is_out[edge] & ~is_none)
        is_new[asked] = span.adds_all(winding[asked])
        is_once = np.logical_and.reduce([factor.adds_all(winding[is_new]) for factor in factors])
        rank += int(is_new.sum())
        found["outside"].append(own[edge[is_out[edge]]])
        found["none"].append(own[edge[is_none]])
        found["again"].append(own[edge[asked[~is_new[asked]]]])
        found["several"].append(own[edge[is_new][~is_once]])
    return Proof(rank, **{name: np.concatenate(edge) for name, edge in found.items()}, unproved=unproved)


def are_too_many(shape: Enclosure, edges: np.ndarray) -> bool:
    """Whether a curve with ``edges`` (E, 2) would have more than `MOST_LINKING` linking numbers in a solid."""
    return 2 * shape.handles.genus * len(edges) > MOST_LINKING


def _solids(
    shape: Enclosure, x: np.ndarray, part: np.ndarray, is_asked: np.ndarray, node_of_vertex: np.ndarray | None
) -> list[tuple[Enclosure, np.ndarray]]:
    """Components of the solid, each with a mask (N,) over parts of the curve: those of ``is_asked`` that belong to it.

    ``part`` (N,) is the part of each node; ``is_asked`` (N,) is indexed by part.
    """
    if not is_asked.any():
        return []
    parts = bodies(shape)
    if len(parts) == 1:
        return [(shape, is_asked)]
    solids: list[Enclosure] = []
    label = np.full(len(shape.vertices), -1)
    for number, body in enumerate(parts):
        label[body.vertices] = number
        faces = np.searchsorted(body.vertices, shape.faces[body.faces])
        solids.append(Enclosure(shape.vertices[body.vertices], faces))
    asked = np.flatnonzero(is_asked)
    count = np.zeros((len(asked), len(solids)))
    rows = np.flatnonzero(is_asked[part])
    row_of_part = np.cumsum(is_asked) - 1
    if node_of_vertex is None:
        for column, solid in enumerate(solids):
            is_in = solid.contains(x[rows])
            count[:, column] = np.bincount(row_of_part[part[rows]], weights=is_in, minlength=len(asked))
    else:
        is_used = (label >= 0) & is_asked[part[node_of_vertex]]
        np.add.at(count, (row_of_part[part[node_of_vertex[is_used]]], label[is_used]), 1)
    size = np.array([abs(signed_volume(solid.vertices, solid.faces)) for solid in solids])
    order = np.argsort(size, kind="stable")
    owner = order[count[:, order].argmax(axis=1)]
    return [(solids[own], np.isin(np.arange(len(part)), asked[owner == own])) for own in np.unique(owner)]


def _lengths(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(E,) the length of each edge, plus the total length for an edge outside, and which edges are outside.

    An edge may graze the surface: a stretch outside that is shorter than the solid's resolution proves nothing.
    """
    a, b = vertices[edges[:, 0]], vertices[edges[:, 1]]
    length, is_out = np.linalg.norm(a - b, axis=1), ~is_inside(shape, a, b, sliver=RESOLUTION)
    return length + np.where(is_out, length.sum(), 0.0), is_out


def independent(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray) -> np.ndarray:
    """(E,) which edges stay if each cycle that depends on others, or goes around no handle, is cut at its longest edge.

    An edge outside counts as longer than all edges inside. If there are too many handles, all edges stay.
    """
    if are_too_many(shape, edges):
        return np.ones(len(edges), dtype=bool)
    length, _ = _lengths(shape, vertices, edges)
    closing, windings, _ = shape.handles.windings(vertices, edges, length)
    stays, span = np.ones(len(edges), dtype=bool), Span(windings.shape[1])
    order = np.argsort(length[closing], kind="stable")
    stays[closing[order]] = span.adds_all(windings[order])
    return stays


def completed(roadmap: Roadmap, vertices: np.ndarray, edges: np.ndarray, missing: int) -> tuple[np.ndarray, np.ndarray]:
    """The curve with ``missing`` more loops, each around a handle without a loop: nodes, new ones last, and edges.
    Fewer are added if the roadmap has no more such loops, or the search reaches a limit. Then ``roadmap.num_unsought``
    is the number of those that are missing."""
    handles, is_complete = roadmap.shape.handles, False
    if are_too_many(roadmap.shape, edges):
        roadmap.num_unsought = missing
        return vertices, edges
    part = graphs.labels(len(vertices), *edges.T)
    _, windings, potential = handles.windings(vertices, edges)
    span = Span(windings.shape[1])
    span.adds_all(windings)
    while missing:
        laid, most = [(vertices, part, potential, edges)], min(max(AT_ONCE, missing // 4), missing)
        num = len(vertices)
        for start, end, path in _independent(roadmap, vertices, edges, is_complete, part, potential, span):
            polyline = np.concatenate([vertices[start][None], path])
            along = potential[start] + np.cumsum(handles.linking(polyline[:-1], polyline[1:]), axis=0)
            number = [start, *range(num, num + len(path)), end]
            num += len(path)
            both = np.stack([number[:-1], number[1:]], axis=1)
            laid.append((path, np.full(len(path), part[start]), along, both))
            if len(laid) > most:
                break
        vertices, part, potential, edges = (np.concatenate(each) for each in zip(*laid, strict=True))
        missing -= len(laid) - 1
        if len(laid) == 1:
            if is_complete:
                break
            is_complete = True
    roadmap.num_unsought = missing if roadmap.is_cut_short else 0
    return vertices, edges


def _independent(
    roadmap: Roadmap,
    vertices: np.ndarray,
    edges: np.ndarray,
    is_complete: bool,
    part: np.ndarray,
    potential: np.ndarray,
    span: Span,
) -> Iterator[tuple[int, int, np.ndarray]]:
    """The paths of `Roadmap.loops_from` that close loops outside the ``span``; each is added to it.

    ``part`` (N,) is the part of the curve of each node, and ``potential`` (N, 2g) the linking numbers along a forest.
    """
    found = roadmap.loops_from(vertices, edges, is_complete)
    found = (each for each in found if part[each[0]] == part[each[1]])  # others join two parts, and close no loop
    num = 2 * roadmap.shape.handles.genus
    while some := list(islice(found, BLOCK)):
        roadmap.num_linked += num * len(some)
        if roadmap.num_linked > MOST_LINKING:
            roadmap.is_cut_short = True
            return
        lines = [np.concatenate([vertices[[start]], path, vertices[[end]]]) for start, end, path in some]
        row = np.repeat(np.arange(len(some)), [len(line) - 1 for line in lines])
        a, b = (np.concatenate([line[ends] for line in lines]) for ends in (slice(None, -1), slice(1, None)))
        start, end = np.array([each[:2] for each in some]).T
        winding = potential[start] - potential[end] + roadmap.shape.handles.linking(a, b, row)
        yield from (each for each, is_new in zip(some, span.each_added(winding), strict=True) if is_new)
