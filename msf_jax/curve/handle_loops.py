"""One loop of the curve around every handle of the solid: false loops are cut open, and missing ones are added.

The flow tracks, on its edges, which loops of the surface vanish in the solid, so its graph has a cycle for each handle.
But on a coarse or thin solid its nodes can slide across holes, and then a cycle may go around nothing in space. Cycles
are linear combinations of each other exactly if their linking numbers with the surface's loops are (see `Handles`).
A cycle is cut at its longest edge if it goes around no handle, or only around handles of other cycles. For each
remaining handle, the shortest path inside from the curve, around the handle and back to the curve is added: that whose
linking numbers are independent of those of the present loops (see `Roadmap.loops_from`).
"""

from itertools import islice
from typing import NamedTuple

import numpy as np

from msf_jax.inside.containment import Roadmap
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import RESOLUTION, signed_volume
from msf_jax.solid.handles import BLOCK, Span
from msf_jax.solid.solid import bodies
from msf_jax.topology import graphs

FACTORS = (2, 3)  # moduli with a smaller rank if loops go around handles several times
# Linking numbers, of edges of a curve with loops of the surface, that are computed for one curve (1 GB), and those of
# all paths that are tried for one curve. One of 13,000 edges in a solid of genus 1,409 has 4e7, its search takes 8e7.
MOST_LINKING = 2**27
AT_ONCE = 8  # loops added in a round: at least so many, or a quarter of the missing ones


class Proof(NamedTuple):
    """rank: independent handles of the solid that a curve's cycles go around. unproved: handles of solids that have too
    many for a proof, see `MOST_LINKING`. The others are edges (k,) of the curve, one for each doubtful cycle. none: it
    goes around no handle. again: it depends on the cycles before it. several: it goes around a handle several times,
    also after cycles before it are subtracted, so the cycles are no basis of the solid's loops. outside: it leaves the
    solid, which proves nothing."""

    rank: int
    none: np.ndarray
    again: np.ndarray
    several: np.ndarray
    outside: np.ndarray
    unproved: int


def proof(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray, node_of_vertex: np.ndarray | None = None) -> Proof:
    """Which cycles of the curve ``(vertices (N, 3), edges (E, 2))`` go around handles of the solid ``shape``.

    Of a solid of several components, which may overlap, each part of the curve is tested in its own: that of the
    vertices that ``node_of_vertex`` (V,) maps to its nodes, or else the smallest that contains it."""
    part = graphs.labels(len(vertices), *edges.T)
    is_closing = ~graphs.shortest_forest(len(vertices), edges, np.zeros(len(edges)))
    with_cycles = np.unique(part[edges[is_closing, 0]])
    rank, unproved, doubtful = 0, 0, [[np.empty(0, dtype=np.int64)] for _ in range(4)]
    for solid, mine in _solids(shape, vertices, part, with_cycles, node_of_vertex):
        own = np.flatnonzero(np.isin(part[edges[:, 0]], mine))
        if are_too_many(solid, edges[own]):
            unproved += solid.handles.genus
            continue
        edge, winding, is_out = _cycles(solid, vertices, edges[own])
        is_new, is_several = np.zeros((2, len(edge)), dtype=bool)
        is_new[~is_out] = Span().add(winding[~is_out])
        is_several[is_new] = ~np.logical_and.reduce([Span(factor).add(winding[is_new]) for factor in FACTORS])
        is_none = ~is_out & ~winding.any(axis=1)
        rank += int(is_new.sum())
        for found, which in zip(doubtful, (is_none, ~(is_out | is_none | is_new), is_several, is_out), strict=True):
            found.append(own[edge[which]])
    return Proof(rank, *map(np.concatenate, doubtful), unproved=unproved)


def are_too_many(shape: Enclosure, edges: np.ndarray) -> bool:
    """Whether a curve with ``edges`` (E, 2) would have more than `MOST_LINKING` linking numbers in a solid."""
    return 2 * shape.handles.genus * len(edges) > MOST_LINKING


def _solids(
    shape: Enclosure, x: np.ndarray, part: np.ndarray, asked: np.ndarray, node_of_vertex: np.ndarray | None
) -> list[tuple[Enclosure, np.ndarray]]:
    """The solids of a surface, each with those of the ``asked`` parts of the curve, by number, that belong to it."""
    found = bodies(shape) if len(asked) else []
    if len(found) < 2:
        return [(shape, asked)] * len(found)
    solids, count = [], np.zeros((len(found), len(part)))
    is_asked = np.isin(part, asked)
    for row, body in enumerate(found):
        faces = np.searchsorted(body.vertices, shape.faces[body.faces])
        solids.append(Enclosure(shape.vertices[body.vertices], faces))
        if node_of_vertex is None:
            mine = part[is_asked][solids[-1].contains(x[is_asked])]
        else:
            mine = part[node_of_vertex[body.vertices]]
        count[row] = np.bincount(mine, minlength=len(part))
    order = np.argsort([abs(signed_volume(solid.vertices, solid.faces)) for solid in solids], kind="stable")
    owner = order[count[order][:, asked].argmax(axis=0)]
    return [(solids[row], asked[owner == row]) for row in np.unique(owner).tolist()]


def _cycles(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The edge (C,) that closes each cycle of a curve, shortest first, its linking numbers (C, 2g), and whether it
    leaves the solid (C,). An edge outside counts as longer than all edges inside. An edge may graze the surface: a
    stretch outside that is shorter than the solid's resolution proves nothing."""
    a, b = vertices[edges[:, 0]], vertices[edges[:, 1]]
    length, is_out = np.linalg.norm(a - b, axis=1), ~shape.holds(a, b, sliver=RESOLUTION)
    length += np.where(is_out, length.sum(), 0.0)
    closing, windings, _ = graphs.cycles(len(vertices), edges, shape.handles.linking(a, b), length)
    return closing, windings, is_out[closing]


def independent(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray) -> np.ndarray:
    """(E,) which edges stay if each cycle that depends on others, or goes around no handle, is cut at its longest edge;
    all if there are too many handles."""
    stays = np.ones(len(edges), dtype=bool)
    if not are_too_many(shape, edges):
        closing, windings, _ = _cycles(shape, vertices, edges)
        stays[closing] = Span().add(windings, shape.handles.genus)
    return stays


def completed(roadmap: Roadmap, vertices: np.ndarray, edges: np.ndarray, missing: int) -> tuple[np.ndarray, np.ndarray]:
    """The curve with ``missing`` more loops, each around a handle without a loop: nodes, new ones last, and edges.
    Fewer are added if the roadmap has no more such loops, or the search reaches a limit. Then ``roadmap.num_unsought``
    is the number of those that are missing."""
    if are_too_many(roadmap.shape, edges):
        roadmap.num_unsought = missing
        return vertices, edges
    while missing and (paths := _new_loops(roadmap, vertices, edges, min(max(AT_ONCE, missing // 4), missing))):
        missing -= len(paths)
        for start, end, path in paths:
            number = np.array([start, *range(len(vertices), len(vertices) + len(path)), end])
            vertices = np.concatenate([vertices, path])
            edges = np.concatenate([edges, np.stack([number[:-1], number[1:]], axis=1)])
    roadmap.num_unsought = missing if roadmap.is_cut_short else 0
    return vertices, edges


def _new_loops(roadmap: Roadmap, x: np.ndarray, edges: np.ndarray, most: int) -> list[tuple[int, int, np.ndarray]]:
    """Up to ``most`` paths of `Roadmap.loops_from` that close loops independent of the curve's and of each other."""
    a, b = x[edges[:, 0]], x[edges[:, 1]]
    handles, chosen, span = roadmap.shape.handles, [], Span()
    _, windings, along = graphs.cycles(len(x), edges, handles.linking(a, b), np.linalg.norm(a - b, axis=1))
    span.add(windings)
    found = roadmap.loops_from(x, edges)
    while len(chosen) < most and (some := list(islice(found, BLOCK))):
        roadmap.num_linked += 2 * handles.genus * len(some)
        if roadmap.num_linked > MOST_LINKING:
            roadmap.is_cut_short = True
            break
        lines = [np.concatenate([x[[start]], path, x[[end]]]) for start, end, path in some]
        row = np.repeat(np.arange(len(some)), [len(line) - 1 for line in lines])
        a, b = (np.concatenate([line[ends] for line in lines]) for ends in (slice(None, -1), slice(1, None)))
        start, end = np.array([each[:2] for each in some]).T
        is_new = span.add(along[start] - along[end] + handles.linking(a, b, row), most - len(chosen))
        chosen += [each for each, is_one in zip(some, is_new, strict=True) if is_one]
    return chosen
