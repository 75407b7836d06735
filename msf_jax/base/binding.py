"""`Binding`: the finished curve as a function of the vertices of its mesh. The host makes it, the device evaluates it.

With c_j(V) the centroids of the recorded cross-sections, node i is

    x_i(V) = sum_j a_ij c_j(V) + sum_v b_iv V_v + r_i,

where a smooths along the branches. At the recorded vertices node i differs from sum_j a_ij c_j by a vector; the entries
of b turn, stretch and shear this vector with the limb.

A binding is a pytree of arrays without static fields. Arrays are padded to one of few capacities, so that bindings of
one capacity share a compiled program. Padding is assigned to the last node and the last section, which no curve uses,
and refers to vertices that the curve uses: it changes no value and no gradient.
"""

from typing import Any, NamedTuple

import numpy as np

FACES_TOGETHER = 32  # faces: each group of this many consecutive faces is near each other, and so are groups of 64, ...
# The smallest capacity of each field of `Sizes`. Capacities of the mesh grow by factors of two, those of the curve by
# factors of four, independently, because a finer mesh has no more nodes. Each pair of capacities is a compiled program.
SMALLEST_SIZES = {"vertices": 1024, "faces": 2560, "nodes": 320, "edges": 320, "sections": 320, "smoothing": 8192}
SMALLEST_SIZES |= {"corners": 6144, "turning": 28672}
ROWS = {  # of a `Binding`: the fields whose rows each capacity counts
    "nodes": ("rest", "side"),
    "faces": ("faces", "twin"),
    "edges": ("edges", "branch"),
    "corners": ("tail", "head", "part", "onward", "section", "share"),
    "sections": ("is_loop", "node"),
    "smoothing": ("a_row", "a_column", "a_value"),
    "turning": ("b_row", "b_column", "b_value"),
}
MESH = ("vertices", "faces")  # fields that grow with the mesh
BOTH = ("corners", "turning")  # fields that grow with the nodes, and with the square root of the vertices


class Sizes(NamedTuple):
    """Numbers of vertices of the caller's mesh, faces of the surface, nodes and edges of the curve, cross-sections,
    corners of cross-sections, entries of a (``smoothing``) and of b (``turning``)."""

    vertices: Any
    faces: Any
    nodes: Any
    edges: Any
    sections: Any
    corners: Any
    smoothing: Any
    turning: Any


class Binding(NamedTuple):
    """Arrays for N nodes, E edges, S sections, C corners of sections, F faces and V vertices of the caller's mesh.
    Lengths are in ``unit``. In a batch, every array has one more axis, the first.

    live: the numbers without padding. tail, head: (C,) the vertices of the mesh edge that each corner lies on. part:
    (C,) the corner's place on it, as a fraction from tail to head. onward: (C,) the next corner of the section.
    section: (C,) the section of each corner, ascending. share: (C,) one over the number of corners in the section.
    is_loop: (S,) False for a cloud of points, whose centroid is their mean. node: (S,) the
    node of each section. a_row, a_column, a_value: entries of a, (N, S), sorted by rows. b_row, b_column, b_value:
    entries of b, (N, V). rest: (N, 3) r. faces: (F, 3) triangles of the surface, neighbours close to each other. twin:
    (F, 3): edge 3 f + k leads from corner k of face f to the next corner; its twin is the same edge of the face on the
    other side. side: (N,) -1 for a node whose nearest wall faces away from it, where the surface crosses itself; else
    1. edges: (E, 2) of the curve. branch: (E,) the branch of each edge, counted among those of `Skeleton.branches` that
    have an edge. centre: (3,), diagonal: () of the surface in the caller's units. unit: () a power of two near the
    diagonal; scaling by it is exact, so that all compilers round alike.
    """

    live: Sizes
    tail: Any
    head: Any
    part: Any
    onward: Any
    section: Any
    share: Any
    is_loop: Any
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
        return f"Binding({batch}capacity of {self.capacity.nodes} nodes and {self.capacity.vertices} vertices)"

    @property
    def capacity(self) -> Sizes:
        """The capacities of the arrays. That of vertices follows from the capacity of faces."""
        axis = np.ndim(self.diagonal)
        counts = {kind: np.shape(getattr(self, names[0]))[axis] for kind, names in ROWS.items()}
        return Sizes(**counts, vertices=counts["faces"] * SMALLEST_SIZES["vertices"] // SMALLEST_SIZES["faces"])

    @property
    def node_mask(self) -> Any:
        """(N,) bool: rows that are nodes, not padding."""
        return _mask(self.live.nodes, np.shape(self.rest)[-2])

    @property
    def edge_mask(self) -> Any:
        """(E,) bool: rows that are edges, not padding."""
        return _mask(self.live.edges, np.shape(self.edges)[-2])

    @property
    def vertex_mask(self) -> Any:
        """(V,) bool: rows that are vertices, not padding."""
        return _mask(self.live.vertices, self.capacity.vertices)

    @property
    def num_vertices(self) -> int:
        """The capacity of vertices."""
        return self.capacity.vertices


def _mask(count: Any, num: int) -> Any:
    count = np.asarray(count) if isinstance(count, int) else count
    return count[..., None] > np.arange(num, dtype=count.dtype)


def capacity_for(*sizes: Sizes) -> Sizes:
    """The smallest capacity for all of ``sizes``, and for the extra node and section that padding is assigned to."""
    needed = {
        name: max(getattr(each, name) + (name in ("nodes", "sections")) for each in sizes) for name in SMALLEST_SIZES
    }
    mesh = curve = 0
    while any(_capacity(name, mesh, 0) < needed[name] for name in MESH):
        mesh += 1
    while any(_capacity(name, mesh, curve) < need for name, need in needed.items()):
        curve += 1
    return Sizes(**{name: _capacity(name, mesh, curve) for name in SMALLEST_SIZES})


def _capacity(name: str, mesh: int, curve: int) -> int:
    """The capacity of field ``name``, after ``mesh`` steps of the mesh's capacities and ``curve`` of the curve's."""
    rung = mesh if name in MESH else 2 * curve + mesh / 2 if name in BOTH else 2 * curve
    return int(SMALLEST_SIZES[name] * 2**rung)


def padded(binding: Binding, capacity: Sizes) -> Binding:
    """``binding``, of NumPy arrays without padding, padded to ``capacity``; integers become int32."""
    node, section, vertex = capacity.nodes - 1, capacity.sections - 1, binding.faces[0, 0]
    filling: dict[str, Any] = dict.fromkeys(("tail", "head", "b_column"), vertex)
    filling |= dict.fromkeys(("section", "a_column"), section) | dict.fromkeys(
        ("node", "a_row", "b_row", "edges"), node
    )
    filling |= {"branch": capacity.edges - 1, "onward": np.arange(len(binding.onward), capacity.corners), "side": 1.0}
    filling |= {"faces": binding.faces[-1], "twin": binding.twin[-1]}  # padding repeats the last face; others are 0

    def filled(name: str, count: int) -> np.ndarray:
        values = np.asarray(getattr(binding, name))
        rest = np.broadcast_to(filling.get(name, 0), (count - len(values), *values.shape[1:]))
        return np.concatenate([values, rest]).astype(values.dtype if values.dtype.kind in "fb" else np.int32)

    rows = {name: filled(name, getattr(capacity, kind)) for kind, names in ROWS.items() for name in names}
    live = Sizes(*(np.asarray(count, dtype=np.int32) for count in binding.live))
    return binding._replace(live=live, **rows)


def unpadded(binding: Binding) -> Binding:
    """``binding`` without padding, as NumPy arrays; it must not be a batch."""
    live = Sizes(*(int(count) for count in binding.live))
    arrays = {name: np.asarray(value) for name, value in binding._asdict().items() if name != "live"}
    rows = {name: arrays[name][: getattr(live, kind)] for kind, names in ROWS.items() for name in names}
    return Binding(live=live, **arrays | rows)
