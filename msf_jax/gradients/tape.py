"""The tape of a run: what was decided in it, so that `replay` can compute the same curve as a differentiable program.

It holds neighbours, merges, cuts, which pole each vertex has, who is fixed, how vertices become nodes, and where the
linear solves stopped. It is a pytree of padded arrays, can be saved and loaded, and knows the mesh it belongs to.
"""

import hashlib
import os
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any, NamedTuple

import jax
import numpy as np

from msf_jax.base import archive
from msf_jax.base.errors import ConfigError, MeshError
from msf_jax.base.layout import Layout, Level
from msf_jax.base.options import Config, Weights
from msf_jax.device.playback import Basis, Mixing, Part, Polynomial, Shape, Stretch
from msf_jax.host.mesh import reading
from msf_jax.host.mesh.repair import placed_between_neighbours
from msf_jax.host.recording import padded
from msf_jax.host.recording.decisions import decisions, num_unlike
from msf_jax.host.recording.records import Recording
from msf_jax.skeleton.skeleton import Skeleton
from msf_jax.skeleton.source import Source

KIND, VERSION = "tape", 2


class Comparison(NamedTuple):
    """Of ``total`` decisions that a run made, ``different`` are not those of the tape that it is compared with."""

    different: int
    total: int


@jax.tree_util.register_dataclass
@dataclass(frozen=True, eq=False)
class Tape:
    """What a run decided. Made by `contract`, as ``flow.tape``; `replay` is what it is for. A pytree of arrays.

    Attributes:
        parts: one for each component of the mesh.
        vertices: (V, 3) of the mesh, in the caller's units.
        areas: (V,) share of the surface that belongs to each.
        node_of_vertex: (V,) the node of each.
        edges: (E, 2) of the recorded curve.
        triangles: (N, 3) vertices of the triangle of the mesh that is nearest to each node of the recorded curve.
        offsets: (N, 3, 3) from those vertices to the triangle's corners, which are others where parts were joined.
        is_inside: (N,) whether that node is inside.
        decisions: (D,) a hash of each decision.
        weights: of the run.
        shapes, sizes: layouts of the parts' buffers; vertices of their meso-skeletons and nodes of their curves.
        config: of the run.
        mesh_id: a hash of the mesh's vertices and faces.
        num_made: vertices of the surface that are none of the mesh's, but were made where its parts were joined.
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
    weights: Weights
    shapes: tuple[Shape, ...] = field(metadata={"static": True})
    sizes: tuple[tuple[int, int], ...] = field(metadata={"static": True})
    config: Config = field(metadata={"static": True})
    mesh_id: str = field(metadata={"static": True})
    num_made: int = field(metadata={"static": True})

    def __repr__(self) -> str:
        return f"Tape({self.num_nodes} nodes, {len(self.decisions)} decisions, mesh {self.mesh_id[:8]})"

    @property
    def num_nodes(self) -> int:
        """Nodes of the recorded curve."""
        return sum(nodes for _, nodes in self.sizes)

    @property
    def diagonal(self) -> Any:
        """Length of the bounding box's diagonal."""
        extent = self.vertices.max(axis=0) - self.vertices.min(axis=0)
        return (extent * extent).sum() ** 0.5

    def check_movable(self) -> None:
        """Raise a `MeshError` if the surface would not follow the mesh's vertices."""
        if self.num_made:
            raise MeshError(
                f"{self.num_made} vertices of the surface were made where parts of the mesh were joined, and do not "
                'follow the mesh\'s vertices: expected a run without repair="join", or no vertices to move'
            )

    def compare(self, other: "Tape") -> Comparison:
        """How many decisions ``other``, the tape of another run on the same mesh, made differently.

        A gradient through this tape knows nothing of them.
        """
        if other.mesh_id != self.mesh_id:
            raise MeshError("the tapes are of different meshes: expected two runs on one mesh")
        return Comparison(num_unlike(np.asarray(self.decisions), np.asarray(other.decisions)), len(other.decisions))

    def check(self, mesh: Any) -> None:
        """Raise a `MeshError` unless this is a tape of ``mesh``: the same vertices and faces in the same order."""
        vertices, faces = reading.read(mesh, finite=False)
        if not np.isfinite(vertices).all():  # a repaired run has put them between their neighbours
            vertices, _ = placed_between_neighbours(vertices, faces)
        if mesh_id(vertices, faces) != self.mesh_id:
            raise MeshError(
                f"the tape is of another mesh: it was recorded for one of {len(self.vertices)} vertices with hash "
                f"{self.mesh_id[:8]}, this has {len(vertices)} and {mesh_id(vertices, faces)[:8]}; run contract on it"
            )

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the tape to ``path``, an ``.npz`` file, whole or not at all.

        Raises:
            ConfigError: the suffix is another.
            OSError: the file cannot be written; what was there before is untouched.
        """
        if Path(path).suffix.lower() != ".npz":
            raise ConfigError(f"a tape is saved as .npz, not as {Path(path).suffix!r}")
        leaves = jax.tree_util.tree_flatten_with_path(self)[0]
        arrays = {"/".join(_name(key) for key in keys): np.asarray(leaf) for keys, leaf in leaves}
        header = {
            "mesh_id": self.mesh_id,
            "config": asdict(self.config),
            "shapes": self.shapes,
            "sizes": self.sizes,
            "num_made": self.num_made,
        }
        archive.write(path, KIND, VERSION, header, arrays, compress=True)

    @classmethod
    def load(cls, path: str | os.PathLike[str], mesh: Any = None) -> "Tape":
        """The tape that `save` wrote to ``path``; with ``mesh``, only if it is that mesh's.

        Raises:
            ConfigError: the file is no tape, is damaged, or was written by another version.
            MeshError: the tape is of another mesh.
        """
        with archive.reading(path, KIND, VERSION, "record one with contract, and Tape.save") as (header, arrays):
            tape = _from_arrays(header, arrays)
        if mesh is not None:
            tape.check(mesh)
        return tape


def mesh_id(vertices: np.ndarray, faces: np.ndarray) -> str:
    """A hash of a mesh as the caller has it."""
    digest = hashlib.sha256(np.ascontiguousarray(vertices, dtype="<f8").tobytes())
    digest.update(np.ascontiguousarray(faces, dtype="<i8").tobytes())
    return digest.hexdigest()


def record(run: Recording, weights: Weights, config: Config, curve: Skeleton, source: Source) -> Tape:
    """The tape of a run that left ``curve``, made from ``source``."""
    parts, shapes = [], []
    for component in run.components:
        arrays, layouts, mesh_layout = padded.record_component(component)
        parts.append(_part(arrays))
        shapes.append(Shape(tuple(layouts), mesh_layout))
    shape, nodes = source.solid.shape, source.solid.enter(curve.vertices)
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
        weights=weights,
        shapes=tuple(shapes),
        sizes=tuple((component.num_meso, component.num_nodes) for component in run.components),
        config=config,
        mesh_id=mesh_id(run.vertices, run.faces),
        num_made=int(run.is_made.sum()),
    )


def _part(arrays: dict[str, Any]) -> Part:
    """`device.replay.Part` from nested dictionaries of arrays; raises what a missing or unknown name raises."""
    named = dict(arrays)
    for name in ("mesh_filter", "site_filter"):
        values = named.setdefault(name, None)
        if values is not None:
            named[name] = Basis(**values) if "basis" in values else Polynomial(**values)
    for name in ("gather", "nodes"):
        named[name] = Mixing(**named[name])
    named["stretches"] = tuple(Stretch(**values) for values in named.get("stretches", ()))
    return Part(**named)


def _name(key: Any) -> str:
    """A step of the way to a leaf of a pytree, as it is called in a file."""
    return str(key.idx) if isinstance(key, jax.tree_util.SequenceKey) else str(key.name)


def _from_arrays(header: dict[str, Any], arrays: dict[str, np.ndarray]) -> Tape:
    nested: dict[str, Any] = {}
    for name, values in arrays.items():
        *way, last = name.split("/")
        into = nested
        for step in way:
            into = into.setdefault(step, {})
        into[last] = values
    tree = _with_tuples(nested)
    shapes = tuple(
        Shape(tuple(_layout(layout) for layout in layouts), None if mesh is None else _layout(mesh))
        for layouts, mesh in header["shapes"]
    )
    try:
        config = Config(**header["config"])
        weights = Weights(**{name: tree["weights"][name][()] for name in vars(Weights())})
    except ConfigError as error:
        raise ValueError(str(error)) from error
    tape = Tape(
        **{name: values for name, values in tree.items() if name not in ("parts", "weights")},
        parts=tuple(_part(part) for part in tree["parts"]),
        weights=weights,
        shapes=shapes,
        sizes=tuple((int(meso), int(nodes)) for meso, nodes in header["sizes"]),
        config=config,
        mesh_id=str(header["mesh_id"]),
        num_made=int(header["num_made"]),
    )
    num, nodes = len(tape.vertices), tape.num_nodes
    expected = {"vertices": (num, 3), "areas": (num,), "node_of_vertex": (num,), "triangles": (nodes, 3)}
    expected |= {"offsets": (nodes, 3, 3)}
    wrong = [name for name, shape in expected.items() if np.shape(getattr(tape, name)) != shape]
    is_whole = len(tape.parts) == len(shapes) == len(tape.sizes) and all(
        len(part.stretches) == len(shape.layouts)
        and part.vertex_of_input.max() < num
        and len(part.is_held) >= held
        and len(part.meso_row) >= meso
        for part, shape, (meso, held) in zip(tape.parts, shapes, tape.sizes, strict=True)
    )
    if wrong or not is_whole or tape.triangles.max() >= num or tape.node_of_vertex.max() >= nodes:
        raise ValueError(f"its arrays do not fit together: {', '.join(wrong) or 'parts'}")
    return tape


def _with_tuples(tree: Any) -> Any:
    """Nested dictionaries whose keys are "0", "1", ... as tuples."""
    if not isinstance(tree, dict):
        return tree
    if all(name.isdigit() for name in tree):
        return tuple(_with_tuples(tree[str(number)]) for number in range(len(tree)))
    return {name: _with_tuples(values) for name, values in tree.items()}


def _layout(values: Any) -> Layout:
    capacity, levels = values
    return Layout(int(capacity), tuple(Level(*map(int, level)) for level in levels))
