"""A loop around every handle of the solid: the false ones are cut open, and the missing ones laid.

The flow carries on its edges which loops of the surface vanish in the solid, so its graph has a cycle for every handle.
But where its nodes come to be is another matter: on a coarse or thin solid they slide across holes, and a cycle may go
around nothing in space. A cycle that goes around no handle, or around none but those that others go around already, is
cut at its longest edge. For a handle that is left, the shortest path inside that leads from the curve around it and
back to the curve is added. It is found as the shortest loops of a surface are (Erickson, Whittlesey 2005): every edge
of a roadmap of the solid (see `roadmap`) closes one loop with a forest of shortest paths from the curve; the shortest
is taken whose linking numbers do not depend on those of the loops that are there.
"""

from typing import NamedTuple

import numpy as np
from scipy import sparse
from scipy.sparse import csgraph

from msf_jax.host.curve.containment import is_inside
from msf_jax.host.poles.roadmap import Roadmap
from msf_jax.host.solid.enclosure import Enclosure
from msf_jax.host.solid.geometry import signed_volume
from msf_jax.host.solid.handles import along_forest, shortest_forest

PRIME = 2**31 - 1  # numbers are compared modulo that: a rank is too small if it divides a minor, which is unlikely
FACTORS = (2, 3)  # modulo these, too, the rank of loops that each go around something once is the same
AT_ONCE = 8  # loops that are laid in one round, at least; of many more a quarter


class Span:
    """The vectors that are combinations of some given ones, as far as integers modulo a ``prime`` tell."""

    def __init__(self, size: int, prime: int = PRIME):
        self._prime = prime
        self._rows = np.empty((0, size), dtype=np.int64)  # each has a 1 at its pivot, where all others have a 0
        self._pivots: list[int] = []

    def adds(self, vector: np.ndarray) -> bool:
        """Whether ``vector`` (size,) depends on none of those that were given before; then it is one of them."""
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

    none, again, several, outside: (k,) edges of the curve, each in a cycle that goes around no handle, or only around
    handles that the cycles before it go around, or around one several times (twice, or once more than twice what those
    before it do, say: then they are no basis of the solid's loops), or that leaves the solid, which proves nothing.
    """

    rank: int
    none: np.ndarray
    again: np.ndarray
    several: np.ndarray
    outside: np.ndarray


def proof(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray, node_of_vertex: np.ndarray | None = None) -> Proof:
    """Which cycles of the curve ``(vertices (N, 3), edges (E, 2))`` go around handles of the solid ``shape``.

    Where that has several components, which may overlap, each part of the curve is asked about its own: the one whose
    vertices go to its nodes by ``node_of_vertex`` (V,), or else the smallest that it is in.
    """
    closing = np.flatnonzero(~shortest_forest(len(vertices), edges, np.zeros(len(edges))))
    part = _parts(len(vertices), edges)
    has_cycle = np.zeros(len(vertices), dtype=bool)
    has_cycle[part[edges[closing, 0]]] = True
    rank, found = 0, {name: [np.empty(0, dtype=np.int64)] for name in Proof._fields[1:]}
    for solid, of_part in _solids(shape, vertices, part, has_cycle, node_of_vertex):
        own = np.flatnonzero((has_cycle & of_part)[part[edges[:, 0]]])
        length, is_out = _lengths(solid, vertices, edges[own])
        closing, windings = solid.handles.windings(vertices, edges[own], length)
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
    """Components of the solid, each with which parts of the curve are its own, of those that are asked about.

    ``part`` (N,) is that of each node, ``is_asked`` (N,) and the answers are for each part.
    """
    if not is_asked.any():
        return []
    label = _parts(len(shape.vertices), shape.faces[:, :2], shape.faces[:, 1:])
    used = np.unique(label[shape.faces[:, 0]])
    if len(used) == 1:
        return [(shape, is_asked)]
    solids: list[Enclosure] = []
    for number in used:
        member = np.flatnonzero(label == number)
        faces = shape.faces[label[shape.faces[:, 0]] == number]
        solids.append(Enclosure(shape.vertices[member], np.searchsorted(member, faces)))
    asked = np.flatnonzero(is_asked)
    count = np.zeros((len(asked), len(solids)))
    rows = np.flatnonzero(is_asked[part])
    row_of_part = np.cumsum(is_asked) - 1
    if node_of_vertex is None:
        for column, solid in enumerate(solids):
            is_in = solid.contains(x[rows])
            count[:, column] = np.bincount(row_of_part[part[rows]], weights=is_in, minlength=len(asked))
    else:
        column = np.searchsorted(used, label)
        is_used = np.isin(label, used) & is_asked[part[node_of_vertex]]
        np.add.at(count, (row_of_part[part[node_of_vertex[is_used]]], column[is_used]), 1)
    size = np.array([abs(signed_volume(solid.vertices, solid.faces)) for solid in solids])
    order = np.argsort(size, kind="stable")
    owner = order[count[:, order].argmax(axis=1)]
    return [(solids[own], np.isin(np.arange(len(part)), asked[owner == own])) for own in np.unique(owner)]


def _parts(num: int, *pairs: np.ndarray) -> np.ndarray:
    """(num,) the connected component of each node of a graph with edges ``pairs`` (E, 2)."""
    a, b = np.concatenate(pairs).T
    graph = sparse.coo_matrix((np.ones(len(a)), (a, b)), shape=(num, num))
    return csgraph.connected_components(graph, directed=False)[1]


def _lengths(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(E,) the length of each edge, more than all together for one outside, and which those are."""
    a, b = vertices[edges[:, 0]], vertices[edges[:, 1]]
    length, is_out = np.linalg.norm(a - b, axis=1), ~is_inside(shape, a, b)
    return length + np.where(is_out, length.sum(), 0.0), is_out


def independent(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray) -> np.ndarray:
    """(E,) which edges stay when each cycle that goes around no handle of its own is cut at its longest edge.

    An edge outside counts as longer than all others.
    """
    length, _ = _lengths(shape, vertices, edges)
    closing, windings = shape.handles.windings(vertices, edges, length)
    stays, span = np.ones(len(edges), dtype=bool), Span(windings.shape[1])
    for cycle in np.argsort(length[closing], kind="stable").tolist():
        stays[closing[cycle]] = span.adds(windings[cycle])
    return stays


def completed(roadmap: Roadmap, vertices: np.ndarray, edges: np.ndarray, missing: int) -> tuple[np.ndarray, np.ndarray]:
    """The curve with ``missing`` more loops, each around a handle that none goes around yet: nodes, new ones last, and
    edges. There are fewer of them where the roadmap has no such loop."""
    handles, is_complete = roadmap.shape.handles, False
    while missing:
        part = _parts(len(vertices), edges)
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
        for start, end, path in roadmap.loops_from(vertices, edges, is_complete):
            if part[start] != part[end]:  # no loop
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
