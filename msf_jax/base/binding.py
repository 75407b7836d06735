"""`Binding`: the finished curve as a function of the vertices of its mesh. The host makes it, the device evaluates it.

With c_j(V) the centroids of the recorded cross-sections, node i is

    x_i(V) = sum_j a_ij c_j(V) + sum_v b_iv V_v + r_i,

where a smooths along the branches. At the recorded vertices node i differs from sum_j a_ij c_j by a vector; the entries
of b turn, stretch and shear this vector with the limb.

A binding is a pytree of arrays without static fields. Several are joined to one as graph libraries batch: rows of all
meshes follow each other. Arrays are padded to a capacity, whose bindings share a compiled program. Padding is assigned
to the last node and the last section, which no curve uses: it changes no value and no gradient.
"""

from typing import Any, NamedTuple

import numpy as np

from msf_jax.base.errors import ConfigError

FACES_TOGETHER = 32  # faces: each group of this many consecutive faces is near each other, and so are groups of 64, ...
SMALLEST = 64  # rows: the least capacity; each further one is larger by the square root of two
ROWS = {  # of a `Binding`: the fields whose rows each capacity counts
    "vertices": ("vertices",),
    "faces": ("faces", "twin", "is_wall"),
    "nodes": ("rest", "side"),
    "edges": ("edges", "branch"),
    "sections": ("is_loop", "node"),
    "corners": ("tail", "head", "part", "onward", "section", "share"),
    "smoothing": ("a_row", "a_column", "a_value"),
    "turning": ("b_row", "b_column", "b_value"),
}
REFERS = {  # the fields whose values are numbers of rows
    "vertices": ("tail", "head", "b_column", "faces"),
    "nodes": ("node", "a_row", "b_row", "edges"),
    "sections": ("section", "a_column"),
    "corners": ("onward",),
    "edges": ("branch",),
    "faces": ("twin",),  # three times
}
KIND = {name: kind for kind, names in REFERS.items() for name in names}


class Sizes(NamedTuple):
    """Numbers of rows; ``smoothing`` and ``turning`` are the entries of a and of b."""

    vertices: Any
    faces: Any
    nodes: Any
    edges: Any
    sections: Any
    corners: Any
    smoothing: Any
    turning: Any


class Binding(NamedTuple):
    """Arrays for N nodes, E edges, S sections, C corners of sections, F faces and V vertices of the caller's mesh, or
    of B meshes together. Lengths are in ``unit``.

    live: the numbers without padding, of B meshes (B,) each. vertices: (V, 3) as recorded, in the caller's units; 0 for
    one in no face, and in padding. tail, head, part: (C,) the mesh edge that each corner lies on, and its place there,
    0 to 1. onward: (C,) the next corner of the section. section: (C,) ascending. share: (C,) one over the number of
    corners in the section. is_loop: (S,) False for a cloud of points, whose centroid is their mean. node: (S,) of each
    section. a_row, a_column, a_value: entries of a, (N, S), sorted by rows. b_row, b_column, b_value: entries of b,
    (N, V). rest: (N, 3) r. faces: (F, 3) of the surface, neighbours close to each other. twin: (F, 3): edge 3 f + k
    leads from corner k of face f to the next corner; its twin is the same edge of the face on the other side.
    is_wall: (F,) False for the lid of an opening, which bounds no radius. side:
    (N,) -1 for a node whose nearest wall faces away from it, where the surface crosses itself; else 1. edges: (E, 2) of
    the curve, one branch after the other, each from end to end. branch: (E,) of each edge, ascending: its number among
    the branches that have an edge, plus the number of edges of the meshes before. centre: (3,), diagonal: () of the
    surface in the caller's units. unit: () a power of two near the diagonal, so that all compilers round alike. Of B
    meshes centre is (B, 3), diagonal and unit (B,).
    """

    live: Sizes
    vertices: Any
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
    is_wall: Any
    side: Any
    edges: Any
    branch: Any
    centre: Any
    diagonal: Any
    unit: Any

    def __repr__(self) -> str:
        of = f"{np.size(self.diagonal)} curves, " if np.shape(self.diagonal) else ""
        return f"Binding({of}capacity of {self.capacity.nodes} nodes and {self.capacity.vertices} vertices)"

    @property
    def capacity(self) -> Sizes:
        """The capacities of the arrays."""
        return Sizes(**{kind: np.shape(getattr(self, names[0]))[0] for kind, names in ROWS.items()})

    @property
    def vertex_mask(self) -> Any:
        """(V,) bool: rows that are vertices, not padding."""
        return self.live.vertices.sum() > np.arange(self.capacity.vertices, dtype=np.int32)

    @property
    def node_mask(self) -> Any:
        """(N,) bool: rows that are nodes, not padding."""
        return self.live.nodes.sum() > np.arange(self.capacity.nodes, dtype=np.int32)

    @property
    def edge_mask(self) -> Any:
        """(E,) bool: rows that are edges, not padding."""
        return self.live.edges.sum() > np.arange(self.capacity.edges, dtype=np.int32)

    @property
    def mesh_mask(self) -> Any:
        """(B,) bool: meshes that are some, not padding."""
        return self.live.vertices > 0

    def mesh_of(self, kind: str) -> Any:
        """The mesh of each row of ``kind``, a field of `Sizes`; the last mesh for padding."""
        stop = getattr(self.live, kind).reshape(-1).cumsum(dtype=np.int32)
        rows = np.arange(getattr(self.capacity, kind), dtype=np.int32)
        return stop.searchsorted(rows, side="right").clip(None, len(stop) - 1)

    def spread(self, values: Any, kind: str) -> Any:
        """``values`` of each mesh (B, ...) for each row of ``kind``; those of a binding of one mesh as they are."""
        return values[self.mesh_of(kind)] if np.ndim(self.diagonal) else values

    def split(self, values: Any, kind: str = "nodes") -> list[np.ndarray]:
        """``values`` with a row for each of the "nodes", "edges" or "vertices", mesh by mesh, without padding."""
        counts = np.reshape(getattr(self.live, kind), -1)
        parts = np.split(np.asarray(values)[: counts.sum()], np.cumsum(counts)[:-1])
        return [part for part, num in zip(parts, np.reshape(self.live.vertices, -1), strict=True) if num]

    def like(self, *others: "Binding") -> "Binding":
        """This binding in the largest capacities of ``others``, whose compiled programs then serve it. If one of these
        is of B meshes, so is the result: those that this one lacks are padding, see ``mesh_mask``. A `ConfigError` is
        raised if one of ``others`` is no binding, there are none, or a capacity is too small."""
        if not others or not all(isinstance(each, Binding) for each in others):
            kinds = ", ".join(type(each).__name__ for each in others) or "nothing"
            raise ConfigError(f"others are {kinds}: expected msf_jax.Binding, of skeletons or stack")
        bare, shape = unpadded(self), max(np.shape(each.diagonal) for each in others)
        most = Sizes(*map(max, zip(*(each.capacity for each in others), strict=True)))
        sizes = {"meshes": (np.size(self.diagonal), int(np.prod(shape)))}
        sizes |= {name: (need, getattr(most, name)) for name, need in _needed(bare.live)._asdict().items()}
        small = [f"{need} {name} in a capacity of {room}" for name, (need, room) in sizes.items() if need > room]
        if small:
            raise ConfigError(f"the binding needs {', '.join(small)}: expected one that fits into the others")
        if shape:
            bare, more = _of_meshes(bare), (0, shape[0] - np.size(self.diagonal))
            bare = bare._replace(
                live=Sizes(*(np.pad(count, more) for count in bare.live)),
                centre=np.pad(bare.centre, (more, (0, 0))),
                diagonal=np.pad(bare.diagonal, more, constant_values=1),
                unit=np.pad(bare.unit, more, constant_values=1),
            )
        return padded(bare, most)


def _of_meshes(binding: Binding) -> Binding:
    """``binding`` of one mesh as one of B = 1; of more, as it is."""
    return binding._replace(
        live=Sizes(*map(np.atleast_1d, binding.live)),
        centre=np.atleast_2d(binding.centre),
        diagonal=np.atleast_1d(binding.diagonal),
        unit=np.atleast_1d(binding.unit),
    )


def joined(bindings: list[Binding]) -> Binding:
    """One binding of all meshes of ``bindings``, without padding as these. Shifts by Python's numbers keep int32."""
    every = list(map(_of_meshes, bindings))
    live = Sizes(*map(np.concatenate, zip(*(each.live for each in every), strict=True)))
    start = {kind: np.cumsum([0, *(getattr(each.live, kind).sum() for each in every)]).tolist() for kind in REFERS}

    def shifted(name: str) -> list[np.ndarray]:
        values, rows = [getattr(each, name) for each in every], 3 if name == "twin" else 1
        firsts = start[KIND[name]] if name in KIND else [0] * len(values)
        return [value + rows * first if first else value for value, first in zip(values, firsts, strict=False)]

    return Binding(live, *(np.concatenate(shifted(name)) for name in Binding._fields[1:]))


def _needed(sizes: Sizes) -> Sizes:
    """The rows of all meshes, and the extra node and section that padding is assigned to."""
    return Sizes(*(int(np.sum(count)) + (name in ("nodes", "sections")) for name, count in sizes._asdict().items()))


def capacity_for(sizes: Sizes) -> Sizes:
    """The smallest capacity for ``sizes``, each field by itself."""
    steps = (int(np.ceil(2 * np.log2(max(need / SMALLEST, 1)))) for need in _needed(sizes))
    return Sizes(*(int(SMALLEST * 2 ** (step / 2)) for step in steps))


def padded(binding: Binding, capacity: Sizes, made: Any = np.asarray) -> Binding:
    """``binding``, of NumPy arrays without padding, padded to ``capacity``; integers become int32. Of each array only
    what ``made`` makes of it is kept."""
    row = {kind: getattr(capacity, kind) - 1 for kind in REFERS} | {"vertices": binding.faces[0, 0]}
    filling: dict[str, Any] = {name: row[kind] for name, kind in KIND.items()}
    filling |= {"onward": np.arange(len(binding.onward), capacity.corners), "side": 1.0}
    filling |= {"faces": binding.faces[-1], "twin": binding.twin[-1]}  # padding repeats the last face; others are 0

    def filled(name: str, count: int) -> Any:
        values = np.asarray(getattr(binding, name))
        rest = np.broadcast_to(filling.get(name, 0), (count - len(values), *values.shape[1:]))
        dtype = values.dtype if values.dtype.kind in "fb" else np.int32
        return made(np.concatenate([values, rest], dtype=dtype, casting="unsafe"))

    rows = {name: filled(name, getattr(capacity, kind)) for kind, names in ROWS.items() for name in names}
    return binding._replace(live=Sizes(*(np.asarray(count, dtype=np.int32) for count in binding.live)), **rows)


def unpadded(binding: Binding) -> Binding:
    """``binding`` without padding, as NumPy arrays."""
    live = Sizes(*map(np.asarray, binding.live))
    arrays = {name: np.asarray(value) for name, value in binding._asdict().items() if name != "live"}
    rows = {name: arrays[name][: getattr(live, kind).sum()] for kind, names in ROWS.items() for name in names}
    return Binding(live=live, **arrays | rows)
