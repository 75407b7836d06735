"""`Binding`: how a finished curve hangs on the vertices of its mesh. The host writes it, the device reads it.

With c_j(V) the centroids of the cross-sections that were recorded,

    x_i(V) = sum_j a_ij c_j(V) + sum_v b_iv V_v + r_i,

where a smooths along the branches, and b turns, stretches and shears with the limb what node i was off sum_j a_ij c_j.

A binding is a pytree of arrays, and no number of its mesh is static: arrays are padded to one of few capacities, so
that bindings of one capacity share a compiled program. What pads belongs to the last node and the last section, which
no curve ever uses, and names vertices that the curve uses: it adds nothing to a value, and no gradient comes from it.
"""

from typing import Any, NamedTuple

import numpy as np

FACES_TOGETHER = 32  # faces come in runs of so many that are near each other; so do runs of 64, 128, ...
# The smallest capacity, in numbers of what is counted. One ladder is for the mesh, by twos, and one for the curve, by
# fours: a finer mesh has no more nodes, and each pair of rungs is a program. Corners and entries of b go with the
# nodes, and with the square root of the vertices.
SMALLEST = {"vertices": 1024, "faces": 2560, "nodes": 320, "edges": 320, "sections": 320, "smoothing": 8192}
SMALLEST |= {"corners": 6144, "turning": 71680}
MESH, BOTH = ("vertices", "faces"), ("corners", "turning")
STEP = 64  # capacities are multiples of it


class Sizes(NamedTuple):
    """How many there are: vertices of the caller's mesh, faces of the surface, nodes and edges of the curve, sections,
    corners of sections, entries of a and of b."""

    vertices: Any
    faces: Any
    nodes: Any
    edges: Any
    sections: Any
    corners: Any
    smoothing: Any
    turning: Any


class Binding(NamedTuple):
    """Arrays, for N nodes, E edges, S sections, C corners of sections, F faces and V vertices of the caller's mesh;
    lengths in ``unit``. Of a batch, every array has one more axis, the first.

    live: how many of each are not padding. tail, head: (C,) the vertices that each corner is between. part: (C,) how
    far from tail to head, as a fraction. onward: (C,) the corner that comes next in its section. section: (C,)
    ascending. share: (C,) one over the number of corners in that section. is_loop: (S,) False for a cloud of points:
    its centroid is their mean. area: (S,) of each section. node: (S,) whose it is. a_row, a_column, a_value: entries of
    a, (N, S), in the order of rows; b_row, b_column, b_value: those of b, (N, V). rest: (N, 3) r. faces: (F, 3)
    vertices of the surface's triangles, those that are near each other together. twin: (F, 3) for the edge from corner
    k of face f to the next, number 3 f + k, the number of the same edge in the face on its other side. side: (N,) -1
    for a node whose nearest wall faces it the wrong way, since the surface runs through itself; else 1. edges: (E, 2)
    of the curve. branch: (E,) the branch that each edge belongs to: which of those of `Skeleton.branches` that have an
    edge. centre: (3,), diagonal: () of the surface in the caller's units. unit: () a power of two that is near the
    diagonal: to multiply by it is exact, so that compilers cannot round that in different ways.
    """

    live: Sizes
    tail: Any
    head: Any
    part: Any
    onward: Any
    section: Any
    share: Any
    is_loop: Any
    area: Any
    node: Any
    a_row: Any
    a_column: Any
    a_value: Any
    b_row: Any
    b_column: Any
    b_value: Any
    rest: Any
    faces: Any
    twin: Any
    side: Any
    edges: Any
    branch: Any
    centre: Any
    diagonal: Any
    unit: Any

    def __repr__(self) -> str:
        shape = np.shape(self.diagonal)
        batch = f"{shape[0]} curves, " if shape else ""
        return f"Binding({batch}room for {self.capacity.nodes} nodes and {self.capacity.vertices} vertices)"

    @property
    def capacity(self) -> Sizes:
        """How many of each there is room for. Of vertices, it is what the level of the others has."""
        nodes, faces = np.shape(self.rest)[-2], np.shape(self.faces)[-2]
        counts = {"nodes": nodes, "faces": faces, "edges": np.shape(self.edges)[-2], "corners": np.shape(self.tail)[-1]}
        counts |= {"sections": np.shape(self.node)[-1], "smoothing": np.shape(self.a_row)[-1]}
        vertices = faces * SMALLEST["vertices"] // SMALLEST["faces"]
        return Sizes(**counts, turning=np.shape(self.b_row)[-1], vertices=vertices)

    @property
    def node_mask(self) -> Any:
        """(N,) bool, which rows are nodes."""
        return _mask(self.live.nodes, np.shape(self.rest)[-2])

    @property
    def edge_mask(self) -> Any:
        """(E,) bool, which rows are edges."""
        return _mask(self.live.edges, np.shape(self.edges)[-2])

    @property
    def vertex_mask(self) -> Any:
        """(V,) bool, which rows are vertices."""
        return _mask(self.live.vertices, self.capacity.vertices)

    @property
    def num_vertices(self) -> int:
        """Rows of vertices that there is room for."""
        return self.capacity.vertices


def _mask(count: Any, num: int) -> Any:
    count = np.asarray(count) if isinstance(count, int) else count
    return count[..., None] > np.arange(num)


def capacity_for(*sizes: Sizes) -> Sizes:
    """The smallest capacity with room for each of ``sizes``, and for the node and the section that padding belongs
    to."""
    needed = {name: max(getattr(each, name) + (name in ("nodes", "sections")) for each in sizes) for name in SMALLEST}
    mesh = curve = 0
    while any(_room(name, mesh, 0) < needed[name] for name in MESH):
        mesh += 1
    while any(_room(name, mesh, curve) < need for name, need in needed.items()):
        curve += 1
    return Sizes(**{name: _room(name, mesh, curve) for name in SMALLEST})


def _room(name: str, mesh: int, curve: int) -> int:
    """Of that name, on those rungs of the two ladders."""
    rung = mesh if name in MESH else 2 * curve + mesh / 2 if name in BOTH else 2 * curve
    return -(-int(SMALLEST[name] * 2**rung) // STEP) * STEP


def padded(binding: Binding, capacity: Sizes) -> Binding:
    """``binding`` of NumPy arrays without padding, with room for ``capacity``; whole numbers as int32."""
    last_node, last_section, vertex = capacity.nodes - 1, capacity.sections - 1, binding.faces[0, 0]

    def filled(values: Any, count: int, value: Any) -> np.ndarray:
        values = np.asarray(values)
        dtype = values.dtype if values.dtype.kind in "fb" else np.dtype(np.int32)
        full = np.full((count, *values.shape[1:]), value, dtype=dtype)
        full[: len(values)] = values
        return full

    own = np.arange(capacity.corners)
    own[: len(binding.onward)] = binding.onward
    faces = np.minimum(np.arange(capacity.faces), len(binding.faces) - 1)  # a last one that is repeated changes no run
    return Binding(
        live=Sizes(*(np.asarray(count, dtype=np.int32) for count in binding.live)),
        tail=filled(binding.tail, capacity.corners, vertex),
        head=filled(binding.head, capacity.corners, vertex),
        part=filled(binding.part, capacity.corners, 0.0),
        onward=own.astype(np.int32),
        section=filled(binding.section, capacity.corners, last_section),
        share=filled(binding.share, capacity.corners, 0.0),
        is_loop=filled(binding.is_loop, capacity.sections, False),
        area=filled(binding.area, capacity.sections, 0.0),
        node=filled(binding.node, capacity.sections, last_node),
        a_row=filled(binding.a_row, capacity.smoothing, last_node),
        a_column=filled(binding.a_column, capacity.smoothing, last_section),
        a_value=filled(binding.a_value, capacity.smoothing, 0.0),
        b_row=filled(binding.b_row, capacity.turning, last_node),
        b_column=filled(binding.b_column, capacity.turning, vertex),
        b_value=filled(binding.b_value, capacity.turning, 0.0),
        rest=filled(binding.rest, capacity.nodes, 0.0),
        faces=binding.faces[faces].astype(np.int32),
        twin=binding.twin[faces].astype(np.int32),
        side=filled(binding.side, capacity.nodes, 1.0),
        edges=filled(binding.edges, capacity.edges, last_node),
        branch=filled(binding.branch, capacity.edges, capacity.edges - 1),
        centre=np.asarray(binding.centre),
        diagonal=np.asarray(binding.diagonal),
        unit=np.asarray(binding.unit),
    )


def unpadded(binding: Binding) -> Binding:
    """The live part of ``binding``, which is no batch, as NumPy arrays."""
    live = Sizes(*(int(count) for count in binding.live))
    count = dict.fromkeys(("tail", "head", "part", "onward", "section", "share"), live.corners)
    count |= dict.fromkeys(("is_loop", "area", "node"), live.sections)
    count |= dict.fromkeys(("a_row", "a_column", "a_value"), live.smoothing)
    count |= dict.fromkeys(("b_row", "b_column", "b_value"), live.turning)
    count |= {"rest": live.nodes, "side": live.nodes, "faces": live.faces, "twin": live.faces}
    count |= {"edges": live.edges, "branch": live.edges}
    cut = {name: np.asarray(value)[: count.get(name)] for name, value in binding._asdict().items() if name in count}
    whole = {name: np.asarray(getattr(binding, name)) for name in ("centre", "diagonal", "unit")}
    return binding._replace(live=live, **whole, **cut)
