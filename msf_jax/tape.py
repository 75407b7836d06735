"""The tape of a run: what was decided in it, so that `replay` can compute the same curve as a differentiable program.

It holds neighbours, merges, cuts, which pole each vertex has, who is fixed, how vertices become nodes, and where the
linear solves stopped. It is a pytree of padded arrays, can be saved and loaded, and knows the mesh it belongs to.
"""

import hashlib
from dataclasses import dataclass, field
from typing import Any

import jax
import numpy as np

from msf_jax.device.replay import Basis, Mixing, Part, Polynomial, Shape, Stretch
from msf_jax.host import recording
from msf_jax.host.records import Recording
from msf_jax.options import Config, Weights
from msf_jax.skeleton import Skeleton

VERSION = 1


@jax.tree_util.register_dataclass
@dataclass(frozen=True, eq=False)
class Tape:
    """What a run decided. Made by `contract`, as ``flow.tape``; `replay` is what it is for.

    Attributes:
        parts: one for each component of the mesh.
        vertices: (V, 3) of the mesh, in the caller's units.
        edges: (E, 2) of the recorded curve.
        triangles: (N, 3) vertices of the triangle of the mesh that is nearest to each node of the recorded curve.
        is_inside: (N,) whether that node is inside.
        weights: of the run.
        config: of the run.
        mesh_id: a hash of the mesh's vertices and faces.
    """

    parts: tuple[Part, ...]
    vertices: Any
    edges: Any
    triangles: Any
    is_inside: Any
    weights: Weights
    shapes: tuple[Shape, ...] = field(metadata={"static": True})
    sizes: tuple[tuple[int, int], ...] = field(metadata={"static": True})
    config: Config = field(metadata={"static": True})
    mesh_id: str = field(metadata={"static": True})

    @property
    def num_nodes(self) -> int:
        """Nodes of the recorded curve."""
        return sum(nodes for _, nodes in self.sizes)


def mesh_id(vertices: np.ndarray, faces: np.ndarray) -> str:
    """A hash of a mesh as the caller has it."""
    digest = hashlib.sha256(np.ascontiguousarray(vertices, dtype="<f8").tobytes())
    digest.update(np.ascontiguousarray(faces, dtype="<i8").tobytes())
    return digest.hexdigest()


def record(run: Recording, weights: Weights, config: Config, curve: Skeleton) -> Tape:
    """The tape of a run that left ``curve``."""
    parts, shapes = [], []
    for component in run.components:
        arrays, layouts, mesh_layout = recording.record_component(component)
        parts.append(_part(arrays))
        shapes.append(Shape(tuple(layouts), mesh_layout))
    solid = curve.source.solid if curve.source else None
    assert solid is not None
    inside = solid.enter(curve.vertices)
    return Tape(
        parts=tuple(parts),
        vertices=run.vertices,
        edges=curve.edges,
        triangles=run.input_of_vertex[solid.shape.faces[solid.shape.nearest(inside)[1]]],
        is_inside=solid.shape.contains(inside),
        weights=weights,
        shapes=tuple(shapes),
        sizes=tuple((component.num_meso, component.num_nodes) for component in run.components),
        config=config,
        mesh_id=mesh_id(run.vertices, run.faces),
    )


def _part(arrays: dict[str, Any]) -> Part:
    """`device.replay.Part` from nested dictionaries of arrays."""
    named = dict(arrays)
    for name in ("mesh_filter", "site_filter"):
        values = named[name]
        if values is not None:
            named[name] = Basis(**values) if "basis" in values else Polynomial(**values)
    for name in ("gather", "nodes"):
        named[name] = Mixing(**named[name])
    named["stretches"] = tuple(Stretch(**values) for values in named["stretches"])
    return Part(**named)
