"""One loop of the curve around every handle of the solid: false loops are cut open, and missing ones are added.

The flow tracks, on its edges, which loops of the surface vanish in the solid, so its graph has a cycle for each handle.
But on a coarse or thin solid its nodes can slide across holes, and then a cycle may go around nothing in space. A cycle
is cut at its longest edge if it goes around no handle, or only around handles of other cycles. For each remaining
handle, the shortest path inside from the curve, around the handle and back to the curve is added. The search is like
that for the shortest loops of a surface (Erickson, Whittlesey 2005). Every edge of a roadmap of the solid (see
`roadmap`) closes one loop with a forest of shortest paths from the curve. The shortest loop is taken whose linking
numbers are independent of those of the present loops.
"""

from typing import NamedTuple

import numpy as np

from msf_jax.host import graphs
from msf_jax.host.curve.containment import is_inside
from msf_jax.host.graphs import shortest_forest
from msf_jax.host.poles.roadmap import Roadmap
from msf_jax.host.solid.enclosure import Enclosure
from msf_jax.host.solid.frame import RESOLUTION
from msf_jax.host.solid.geometry import signed_volume
from msf_jax.host.solid.solid import bodies

PRIME = 2**31 - 1  # modulus of linear algebra: a rank is too small only if it divides a minor, which is unlikely
FACTORS = (2, 3)  # moduli with a smaller rank if loops go around handles several times
AT_ONCE = 8  # loops added in a round: at least so many, or a quarter of the missing ones


class Span:
    """The span of integer vectors modulo a ``prime``."""

    def __init__(self, size: int, prime: int = PRIME):
        self._prime = prime
        self._rows = np.empty((0, size), dtype=np.int64)  # reduced rows: 1 at the own pivot, 0 at other pivots
        self._pivots: list[int] = []

    def adds(self, vector: np.ndarray) -> bool:
        """Whether ``vector`` (size,) is outside the span; then it is added."""
        left = vector.astype(np.int64) % self._prime
        left = (left - (left[self._pivots, None] * self._rows % self._prime).sum(axis=0)) % self._prime
        where = np.flatnonzero(left)
        if not len(where):
            return False
        pivot = int(where[0])
        left = left * pow(int(left[pivot]), -1, self._prime) % self._prime
        self._rows = np.concatenate([(self._rows - self._rows[:, [pivot]] * left) % self._prime, left[None]])
        self._pivots.append(pivot)
        return True


class Proof(NamedTuple):
    """rank: independent handles of the solid that a curve's cycles go around.

    The rest are edges (k,) of the curve, one for each doubtful cycle. none: it goes around no handle. again: it depends
    on the cycles before it. several: it goes around a handle several times, also after cycles before it are subtracted,
    so the cycles are no basis of the solid's loops. outside: it leaves the solid, which proves nothing.
    """

    rank: int
    none: np.ndarray
    again: np.ndarray
    several: np.ndarray
    outside: np.ndarray


def proof(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray, node_of_vertex: np.ndarray | None = None) -> Proof:
    """Which cycles of the curve ``(vertices (N, 3), edges (E, 2))`` go around handles of the solid ``shape``.

    If the solid has several components, which may overlap, each part of the curve is tested in its own component: that
    of the vertices that ``node_of_vertex`` (V,) maps to its nodes, or else the smallest that contains it.
    """
    closing = np.flatnonzero(~shortest_forest(len(vertices), edges, np.zeros(len(edges))))
    part = graphs.labels(len(vertices), *edges.T)
    has_cycle = np.zeros(len(vertices), dtype=bool)
    has_cycle[part[edges[closing, 0]]] = True
    rank, found = 0, {name: [np.empty(0, dtype=np.int64)] for name in Proof._fields[1:]}
    for solid, of_part in _solids(shape, vertices, part, has_cycle, node_of_vertex):
        own = np.flatnonzero((has_cycle & of_part)[part[edges[:, 0]]])
        length, is_out = _lengths(solid, vertices, edges[own])
        closing, windings, _ = solid.handles.windings(vertices, edges[own], length)
        span, factors = Span(windings.shape[1]), [Span(windings.shape[1], factor) for factor in FACTORS]
        for cycle in np.argsort(length[closing], kind="stable").tolist():
            edge, winding = closing[cycle], windings[cycle]
            if is_out[edge]:
                found["outside"].append(own[[edge]])
            elif not winding.any():
                found["none"].append(own[[edge]])
            elif not span.adds(winding):
                found["again"].append(own[[edge]])
            else:
                rank += 1
                once = [factor.adds(winding) for factor in factors]
                if not all(once):
                    found["several"].append(own[[edge]])
    return Proof(rank, **{name: np.concatenate(edge) for name, edge in found.items()})


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

    An edge outside counts as longer than all edges inside.
    """
    length, _ = _lengths(shape, vertices, edges)
    closing, windings, _ = shape.handles.windings(vertices, edges, length)
    stays, span = np.ones(len(edges), dtype=bool), Span(windings.shape[1])
    for cycle in np.argsort(length[closing], kind="stable").tolist():
        stays[closing[cycle]] = span.adds(windings[cycle])
    return stays


def completed(roadmap: Roadmap, vertices: np.ndarray, edges: np.ndarray, missing: int) -> tuple[np.ndarray, np.ndarray]:
    """The curve with ``missing`` more loops, each around a handle without a loop: nodes, new ones last, and edges.
    Fewer are added if the roadmap has no more such loops."""
    handles, is_complete = roadmap.shape.handles, False
    while missing:
        part = graphs.labels(len(vertices), *edges.T)
        _, windings, potential = handles.windings(vertices, edges)
        span = Span(windings.shape[1])
        for winding in windings:
            span.adds(winding)
        laid, most = 0, max(AT_ONCE, missing // 4)
        for start, end, path in roadmap.loops_from(vertices, edges, is_complete):
            if part[start] != part[end]:  # it joins two parts of the curve, and closes no loop
                continue
            polyline = np.concatenate([vertices[start][None], path, vertices[end][None]])
            winding = potential[start] - potential[end] + handles.linking(polyline[:-1], polyline[1:]).sum(axis=0)
            if span.adds(winding):
                number = [start, *range(len(vertices), len(vertices) + len(path)), end]
                vertices = np.concatenate([vertices, path])
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
