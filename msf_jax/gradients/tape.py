"""The tape of a run: its decisions, with which `replay` computes the same curve as a differentiable program.

It has the one-rings, collapses and splits, the pole of each vertex, the fixed vertices, the map from vertices to nodes,
and the residuals of the linear solves. Layouts and options are static.
"""

import hashlib
import os
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import jax
import numpy as np

from msf_jax.base import archive
from msf_jax.base.decisions import Basis, Mixing, Part, Polynomial, Shape, Stretch
from msf_jax.base.errors import ConfigError, MeshError
from msf_jax.base.layout import Layout, Level
from msf_jax.base.options import GROUPS, Config, Weights, is_traced
from msf_jax.base.writing import write_whole
from msf_jax.meshes import reading
from msf_jax.meshes.reading import MeshLike
from msf_jax.meshes.repair import placed_between_neighbours
from msf_jax.recording import padded
from msf_jax.recording.records import Recording
from msf_jax.skeleton.skeleton import Skeleton, Source

KIND = "tape"  # of the file, see `archive`
FORMAT_VERSION = 6  # of the format: files of other versions are refused
KINDS = (Part, Mixing, Basis, Polynomial, Stretch, Shape, Layout, Level, Weights, Config, *GROUPS.values())
RECORDS = {kind.__name__: kind for kind in KINDS}  # the types that a file may contain, by name


@jax.tree_util.register_dataclass
@dataclass(frozen=True, eq=False)
class Tape:
    """The decisions of a run, for `replay`. `contract` makes it, as ``flow.tape``. A pytree of arrays.

    Attributes:
        parts, shapes: one for each component of the mesh, and the layouts of its buffers.
        vertices: (V, 3) of the mesh, in the caller's units.
        areas, node_of_vertex: (V,) the area and the node of each vertex.
        edges: (E, 2) of the recorded curve.
        triangles: (N, 3) vertices of the triangle of the mesh that is nearest to each node of the recorded curve.
        offsets: (N, 3, 3) from those vertices to the triangle's corners; 0, but for corners that repair made.
        is_inside: (N,) whether the node is inside.
        mesh_hash: (32,) uint8, of the mesh's vertices and faces.
        weights, config: of the run.
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
    mesh_hash: Any
    weights: Weights
    shapes: tuple[Shape, ...] = field(metadata={"static": True})
    config: Config = field(metadata={"static": True})
    is_joined: bool = field(metadata={"static": True})

    def __repr__(self) -> str:
        mesh = "traced" if is_traced(self.mesh_hash) else self.mesh_id[:8]
        return f"Tape({self.num_nodes} nodes, mesh {mesh})"

    @property
    def num_nodes(self) -> int:
        """The number of nodes of the recorded curve."""
        return len(self.is_inside)

    @property
    def mesh_id(self) -> str:
        """A hash of the mesh's vertices and faces."""
        return np.asarray(self.mesh_hash).tobytes().hex()

    @property
    def diagonal(self) -> Any:
        """Length of the bounding box's diagonal."""
        extent = self.vertices.max(axis=0) - self.vertices.min(axis=0)
        return (extent * extent).sum() ** 0.5

    def check(self, mesh: "MeshLike") -> None:
        """Raise a `MeshError` unless this is a tape of ``mesh``: the same vertices and faces in the same order."""
        vertices, faces = reading.read(mesh, finite=False)
        if not np.isfinite(vertices).all():  # repair placed these vertices between their neighbours
            vertices, _ = placed_between_neighbours(vertices, faces)
        if (found := _hash(vertices, faces).tobytes().hex()) != self.mesh_id:
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
        write_whole(path, archive.packed(KIND, FORMAT_VERSION, header, arrays))

    @classmethod
    def load(cls, path: str | os.PathLike[str], mesh: "MeshLike | None" = None) -> "Tape":
        """The tape that `save` wrote to ``path``. With ``mesh`` given, the tape must be of that mesh.

        Raises:
            ConfigError: the file is no tape, is damaged, or was written by another version.
            MeshError: the tape is of another mesh.
        """
        with archive.reading(
            path, KIND, FORMAT_VERSION, "make a tape with contract, and save it with Tape.save"
        ) as file:
            tape = _checked(*file)
        if mesh is not None:
            tape.check(mesh)
        return tape


def _hash(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """A hash (32,) uint8 of the caller's mesh."""
    given = np.ascontiguousarray(vertices, dtype="<f8").tobytes() + np.ascontiguousarray(faces, dtype="<i8").tobytes()
    return np.frombuffer(hashlib.sha256(given).digest(), dtype=np.uint8)


def record(run: Recording, weights: Weights, config: Config, curve: Skeleton, source: Source) -> Tape:
    """The tape of a run with the flow's curve ``curve`` and its ``source``."""
    parts, shapes = zip(*map(padded.record_component, run.components), strict=True)
    shape, nodes = source.solid.shape, source.solid.enter(curve.vertices)
    near = shape.faces[shape.nearest(nodes)[1]]
    triangles = run.input_of_vertex[near]
    offsets = source.solid.leave(shape.vertices[near]) - run.vertices[triangles]
    return Tape(
        parts=parts,
        vertices=run.vertices,
        areas=source.areas,
        node_of_vertex=curve.mesh_map,
        edges=curve.edges,
        triangles=triangles,
        offsets=np.where(run.is_made[near][:, :, None], offsets, 0.0),
        is_inside=shape.contains(nodes),
        mesh_hash=_hash(run.vertices, run.faces),
        weights=Weights(*(np.asarray(weight, dtype=np.float64) for weight in vars(weights).values())),
        shapes=shapes,
        config=config,
        is_joined=bool(run.is_made.any()),
    )


def _checked(header: dict[str, Any], arrays: dict[str, np.ndarray]) -> Tape:
    """The tape in a file. Types, finite numbers, and the arrays that are as many as vertices or nodes are checked."""
    try:
        tape = Tape(**archive.decoded(header["tape"], arrays, RECORDS))
    except ConfigError as error:
        raise ValueError(str(error)) from error
    kinds: list[tuple[Any, type]] = [(tape.weights, Weights), (tape.config, Config), (tape.is_joined, bool)]
    kinds += [(part, Part) for part in tape.parts] + [(shape, Shape) for shape in tape.shapes]
    if len(tape.parts) != len(tape.shapes) or not all(isinstance(each, kind) for each, kind in kinds):
        raise ValueError("it lacks weights, options, parts or shapes")
    num, nodes = len(tape.vertices), sum(len(part.is_held) for part in tape.parts)
    most = {"node_of_vertex": nodes, "edges": nodes, "triangles": num}  # of indices
    sizes = {"vertices": (num, 3), "areas": (num,), "node_of_vertex": (num,), "edges": (len(tape.edges), 2)}
    sizes |= {"triangles": (nodes, 3), "offsets": (nodes, 3, 3), "is_inside": (nodes,), "mesh_hash": (32,)}
    for name, shape in sizes.items():
        if np.shape(getattr(tape, name)) != shape:
            raise ValueError(f"{name} has shape {np.shape(getattr(tape, name))}: expected {shape}")
    for name, count in most.items():
        values = getattr(tape, name)
        if values.dtype.kind not in "iu" or values.max(initial=-1) >= count:
            raise ValueError(f"{name} is {values.dtype}, up to {values.max()}: expected whole numbers below {count}")
    for values in jax.tree.leaves(tape):
        if values.dtype.kind not in "fiub" or not np.isfinite(values).all():
            raise ValueError("it has values that are not finite numbers")
        if values.dtype.kind == "i" and values.min(initial=0) < 0:
            raise ValueError(f"it has an index of {values.min()}")
    return tape
