"""The tape of a run: its decisions, with which `replay` computes the same curve as a differentiable program.

It has the one-rings, collapses and splits, the pole of each vertex, the fixed vertices, the map from vertices to nodes,
and the residuals of the linear solves. It is a pytree of padded arrays, can be saved and loaded, and identifies its
mesh. Only layouts and options are static, so that tapes of the same capacities share a program.
"""

import hashlib
import os
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, NamedTuple

import jax
import numpy as np

from msf_jax.base import archive
from msf_jax.base.errors import ConfigError, MeshError
from msf_jax.base.layout import Layout, Level
from msf_jax.base.options import GROUPS, Config, Weights, is_traced
from msf_jax.device.playback import Basis, Mixing, Part, Polynomial, Shape, Stretch
from msf_jax.gradients.tape_checks import check_part, flags, indices, numbers
from msf_jax.meshes import reading
from msf_jax.meshes.reading import MeshLike
from msf_jax.meshes.repair import placed_between_neighbours
from msf_jax.recording import padded
from msf_jax.recording.padded import Capacity, size_for
from msf_jax.recording.records import Recording, decisions, num_unlike
from msf_jax.skeleton.skeleton import Skeleton
from msf_jax.skeleton.source import Source

KIND = "tape"  # of the file, see `archive`
FORMAT_VERSION = 4  # of the format: files of other versions are refused
RECORDS = {  # the types that a file may contain, by name
    kind.__name__: kind
    for kind in (Part, Mixing, Basis, Polynomial, Stretch, Shape, Layout, Level, Weights, *GROUPS.values())
} | {"Config": Config}
FEWEST_NODES = 64  # rows of nodes in a padded tape, at least: capacities are 64, 128, 256, ...
FEWEST_MESO = 512  # rows of vertices of the contracted surface, at least: 512, 1024, 2048, ...


class Comparison(NamedTuple):
    """A run made ``total`` decisions; ``different`` of them are not in the tape that it is compared with."""

    different: int
    total: int


@jax.tree_util.register_dataclass
@dataclass(frozen=True, eq=False)
class Tape:
    """The decisions of a run, for `replay`. `contract` makes it, as ``flow.tape``. A pytree of arrays.

    Attributes:
        parts: one for each component of the mesh.
        vertices: (V, 3) of the mesh, in the caller's units.
        areas: (V,) the area that belongs to each vertex.
        node_of_vertex: (V,) the node of each vertex.
        edges: (E, 2) of the recorded curve.
        triangles: (N, 3) vertices of the triangle of the mesh that is nearest to each node of the recorded curve.
        offsets: (N, 3, 3) from those vertices to the triangle's corners; 0, but for corners that repair made.
        is_inside: (N,) whether the node is inside.
        decisions: (D,) a hash of each decision.
        node_row: (N,) the row of each node in the concatenated padded nodes of all parts.
        meso_row: (M,) the row of each vertex of the contracted surface in the concatenated padded ones of all parts.
        vertices_hash, faces_hash: (32,) uint8, of the mesh.
        weights: of the run.
        shapes: layouts of the parts' buffers.
        config: of the run.
        is_joined: whether the surface has vertices that repair made, where it joined parts or extruded a rim.
    """

    parts: tuple[Part, ...]
    vertices: Any
    areas: Any
    node_of_vertex: Any
    edges: Any
    triangles: Any
    offsets: Any
    is_inside: Any
    decisions: Any
    node_row: Any
    meso_row: Any
    vertices_hash: Any
    faces_hash: Any
    weights: Weights
    shapes: tuple[Shape, ...] = field(metadata={"static": True})
    config: Config = field(metadata={"static": True})
    is_joined: bool = field(metadata={"static": True})

    def __repr__(self) -> str:
        mesh = "traced" if is_traced(self.faces_hash) else self.mesh_id[:8]
        return f"Tape({self.num_nodes} nodes, {len(self.decisions)} decisions, mesh {mesh})"

    @property
    def num_nodes(self) -> int:
        """The number of nodes of the recorded curve; in a `padded` tape, the number of rows."""
        return len(self.node_row)

    @property
    def mesh_id(self) -> str:
        """A hash of the mesh's vertices and faces."""
        return mesh_id(np.asarray(self.vertices_hash), np.asarray(self.faces_hash))

    def padded(self, like: "Tape | None" = None) -> "Tape":
        """This tape with padded nodes, so that a jitted function of tapes is compiled once for each capacity.

        Without padding, each number of nodes needs its own program. Here the number of rows is that of ``like``, if it
        is sufficient. Else it is the first of 64, 128, 256, ... that is at least a quarter more than the nodes. Rows of
        padding repeat the last node. Edges and decisions are left out, because their numbers vary, too. So objectives
        that need edges, and `compare`, do not work. The buffers of the iterations keep their sizes; see
        `Flow.tape_like`.
        """
        nodes = size_for(self.num_nodes, FEWEST_NODES, like.num_nodes if like else 0)
        meso = size_for(len(self.meso_row), FEWEST_MESO, len(like.meso_row) if like else 0)
        return replace(
            self,
            triangles=_repeated(self.triangles, nodes),
            offsets=_repeated(self.offsets, nodes),
            is_inside=_repeated(self.is_inside, nodes),
            node_row=_repeated(self.node_row, nodes),
            meso_row=_repeated(self.meso_row, meso),
            edges=np.zeros((0, 2), dtype=np.int64),
            decisions=np.zeros(0, dtype=np.uint32),
        )

    @property
    def diagonal(self) -> Any:
        """Length of the bounding box's diagonal."""
        extent = self.vertices.max(axis=0) - self.vertices.min(axis=0)
        return (extent * extent).sum() ** 0.5

    def check_movable(self) -> None:
        """Raise a `MeshError` if the surface cannot follow the mesh's vertices, because repair made some of its own."""
        if self.is_joined:
            raise MeshError(
                "repair made vertices where it joined parts or extruded a rim, and these cannot follow the mesh: "
                'expected a run without repair="join" and without extruded rims, or a call without vertices'
            )

    def compare(self, other: "Tape") -> Comparison:
        """How many decisions of ``other``, the tape of another run on this mesh, are different.

        A gradient through this tape ignores these differences. Decisions refer to vertices by id, so the faces must be
        the same; the vertices may have moved.

        Raises:
            MeshError: the tapes are of meshes with different faces.
        """
        if not np.array_equal(other.faces_hash, self.faces_hash) or len(other.vertices) != len(self.vertices):
            raise MeshError(
                "the tapes are of meshes with different faces: expected the same faces; vertices may have moved"
            )
        return Comparison(num_unlike(np.asarray(self.decisions), np.asarray(other.decisions)), len(other.decisions))

    def check(self, mesh: "MeshLike") -> None:
        """Raise a `MeshError` unless this is a tape of ``mesh``: the same vertices and faces in the same order."""
        vertices, faces = reading.read(mesh, finite=False)
        if not np.isfinite(vertices).all():  # repair placed these vertices between their neighbours
            vertices, _ = placed_between_neighbours(vertices, faces)
        if (found := mesh_id(*hashes(vertices, faces))) != self.mesh_id:
            raise MeshError(
                f"the tape is of another mesh: it was recorded for one of {len(self.vertices)} vertices with hash "
                f"{self.mesh_id[:8]}, this has {len(vertices)} and {found[:8]}; run contract on it"
            )

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the tape to ``path``, an ``.npz`` file, atomically.

        Raises:
            ConfigError: the suffix is not ``.npz``.
            OSError: the file cannot be written; what was there before is untouched.
        """
        if Path(path).suffix.lower() != ".npz":
            raise ConfigError(f"a tape is saved as .npz, not as {Path(path).suffix!r}")
        arrays: dict[str, np.ndarray] = {}
        header = {"tape": archive.encoded(vars(self), arrays, RECORDS)}
        archive.write(path, KIND, FORMAT_VERSION, header, arrays)

    @classmethod
    def load(cls, path: str | os.PathLike[str], mesh: "MeshLike | None" = None) -> "Tape":
        """The tape that `save` wrote to ``path``. With ``mesh`` given, the tape must be of that mesh.

        Raises:
            ConfigError: the file is no tape, is damaged, or was written by another version.
            MeshError: the tape is of another mesh.
        """
        with archive.reading(path, KIND, FORMAT_VERSION, "make a tape with contract, and save it with Tape.save") as (
            header,
            arrays,
        ):
            tape = _checked(header, arrays)
        if mesh is not None:
            tape.check(mesh)
        return tape


def hashes(vertices: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Two hashes (32,) uint8 of the caller's mesh: of its vertices, and of its faces."""
    return _hash(np.ascontiguousarray(vertices, dtype="<f8")), _hash(np.ascontiguousarray(faces, dtype="<i8"))


def mesh_id(vertices_hash: np.ndarray, faces_hash: np.ndarray) -> str:
    """One hash from the two hashes of a mesh."""
    return hashlib.sha256(vertices_hash.tobytes() + faces_hash.tobytes()).hexdigest()


def _hash(array: np.ndarray) -> np.ndarray:
    return np.frombuffer(hashlib.sha256(array.tobytes()).digest(), dtype=np.uint8)


def _repeated(rows: Any, count: int) -> np.ndarray:
    """``rows`` (n, ...) with the last one repeated up to ``count``."""
    return np.asarray(rows)[np.minimum(np.arange(count), len(rows) - 1)]


def record(
    run: Recording, weights: Weights, config: Config, curve: Skeleton, source: Source, like: Tape | None = None
) -> Tape:
    """The tape of a run with the flow's curve ``curve`` and its ``source``. The buffers have the sizes of those of
    ``like``, where these are sufficient."""
    parts, shapes = [], []
    capacities = [padded.Capacities()] * len(run.components)
    if like is not None and len(like.parts) == len(capacities):
        capacities = [_capacities(part, shape) for part, shape in zip(like.parts, like.shapes, strict=True)]
    for component, capacity in zip(run.components, capacities, strict=True):
        arrays, layouts, mesh_layout = padded.record_component(component, capacity)
        parts.append(_part(arrays))
        shapes.append(Shape(tuple(layouts), mesh_layout))
    shape, nodes = source.solid.shape, source.solid.enter(curve.vertices)
    vertices_hash, faces_hash = hashes(run.vertices, run.faces)
    near = shape.faces[shape.nearest(nodes)[1]]
    triangles = run.input_of_vertex[near]
    offsets = source.solid.leave(shape.vertices[near]) - run.vertices[triangles]
    return Tape(
        parts=tuple(parts),
        vertices=run.vertices,
        areas=source.areas,
        node_of_vertex=curve.mesh_map,
        edges=curve.edges,
        triangles=triangles,
        offsets=np.where(run.is_made[near][:, :, None], offsets, 0.0),
        is_inside=shape.contains(nodes),
        decisions=decisions(run.components),
        node_row=_live([part.is_held for part in parts], [component.num_nodes for component in run.components]),
        meso_row=_live([part.meso_row for part in parts], [component.num_meso for component in run.components]),
        vertices_hash=vertices_hash,
        faces_hash=faces_hash,
        weights=Weights(*(np.asarray(weight, dtype=np.float64) for weight in vars(weights).values())),
        shapes=tuple(shapes),
        config=config,
        is_joined=bool(run.is_made.any()),
    )


def _capacities(part: Part, shape: Shape) -> padded.Capacities:
    """The capacities of a component's tape."""
    stretches = tuple(
        Capacity(layout, *stretch.cut.shape[:3]) for stretch, layout in zip(part.stretches, shape.layouts, strict=True)
    )
    sizes = len(part.gather.row), len(part.nodes.row), len(part.meso_row), len(part.is_held)
    return padded.Capacities(stretches, *sizes)


def _live(arrays: list[np.ndarray], counts: list[int]) -> np.ndarray:
    """The live rows of concatenated padded arrays: the first ``counts[k]`` rows of array k."""
    first = np.cumsum([0, *map(len, arrays)])
    return np.concatenate([start + np.arange(count) for start, count in zip(first, counts, strict=False)])


def _part(arrays: dict[str, Any]) -> Part:
    """A `Part` from nested dictionaries of arrays; a missing or unknown name raises a KeyError or TypeError."""
    named = dict(arrays)
    for name in ("mesh_filter", "site_filter"):
        values = named.setdefault(name, None)
        if values is not None:
            named[name] = Basis(**values) if "basis" in values else Polynomial(**values)
    for name in ("gather", "nodes"):
        named[name] = Mixing(**named[name])
    named["stretches"] = tuple(Stretch(**values) for values in named.get("stretches", ()))
    return Part(**named)


def _checked(header: dict[str, Any], arrays: dict[str, np.ndarray]) -> Tape:
    """The tape in a file; a damaged file raises exceptions of many types."""
    try:
        tape = Tape(**archive.decoded(header["tape"], arrays, RECORDS))
    except ConfigError as error:
        raise ValueError(str(error)) from error
    num, nodes = len(tape.vertices), tape.num_nodes
    if not (isinstance(tape.weights, Weights) and isinstance(tape.config, Config) and isinstance(tape.is_joined, bool)):
        raise ValueError("it lacks weights or options")
    for name, value in vars(tape.weights).items():
        numbers(value, () if np.ndim(value) == 0 else (num,), name)
    numbers(tape.vertices, (num, 3), "vertices")
    numbers(tape.areas, (num,), "areas")
    numbers(tape.offsets, (nodes, 3, 3), "offsets")
    indices(tape.node_of_vertex, (num,), nodes, "node_of_vertex")
    indices(tape.edges, (len(tape.edges), 2), nodes, "edges")
    indices(tape.triangles, (nodes, 3), num, "triangles")
    indices(tape.decisions, (len(tape.decisions),), 2**32, "decisions")
    flags(tape.is_inside, (nodes,), "is_inside")
    for name in ("vertices_hash", "faces_hash"):
        indices(getattr(tape, name), (32,), 256, name)
    if len(tape.parts) != len(tape.shapes) or not all(isinstance(part, Part) for part in tape.parts):
        raise ValueError("it has other parts than shapes")
    rows = [check_part(part, shape, num) for part, shape in zip(tape.parts, tape.shapes, strict=True)]
    indices(tape.node_row, (nodes,), sum(rows), "node_row")
    indices(tape.meso_row, (len(tape.meso_row),), sum(len(part.meso_row) for part in tape.parts), "meso_row")
    return tape
