"""The tape of a run: its decisions, with which `replay` computes the same curve as a differentiable program.

It has the one-rings, collapses and splits, the pole of each vertex, the fixed vertices, the map from vertices to nodes,
and the residuals of the linear solves. Layouts and options are static.
"""

from dataclasses import dataclass, field
from typing import Any

import jax
import numpy as np

from msf_jax.base.decisions import Part
from msf_jax.base.layout import Layout
from msf_jax.base.options import Config, Weights
from msf_jax.recording.records import Recording, record_component
from msf_jax.skeleton.skeleton import Skeleton, Source


@jax.tree_util.register_dataclass
@dataclass(frozen=True, eq=False)
class Tape:
    """The decisions of a run, for `replay`. `contract` makes it, as ``flow.tape``. A pytree of arrays, for
    `jax.jit` and pickle.

    Attributes:
        parts, layouts: one for each component of the mesh, and the layouts of its buffers.
        vertices: (V, 3) of the mesh, in the caller's units.
        areas, node_of_vertex: (V,) the area and the node of each vertex.
        edges: (E, 2) of the recorded curve.
        triangles: (N, 3) vertices of the triangle of the mesh that is nearest to each node of the recorded curve.
        offsets: (N, 3, 3) from those vertices to the triangle's corners; 0, but for corners that repair made.
        is_inside: (N,) whether the node is inside.
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
    weights: Weights
    layouts: tuple[tuple[Layout, ...], ...] = field(metadata={"static": True})
    config: Config = field(metadata={"static": True})
    is_joined: bool = field(metadata={"static": True})

    def __repr__(self) -> str:
        return f"Tape({self.num_nodes} nodes, {len(self.vertices)} vertices)"

    @property
    def num_nodes(self) -> int:
        """The number of nodes of the recorded curve."""
        return len(self.is_inside)

    @property
    def diagonal(self) -> Any:
        """Length of the bounding box's diagonal."""
        extent = self.vertices.max(axis=0) - self.vertices.min(axis=0)
        return (extent * extent).sum() ** 0.5


def record(run: Recording, weights: Weights, config: Config, curve: Skeleton, source: Source) -> Tape:
    """The tape of a run with the flow's curve ``curve`` and its ``source``."""
    parts, layouts = zip(*map(record_component, run.components), strict=True)
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
        weights=Weights(*(np.asarray(weight, dtype=np.float64) for weight in vars(weights).values())),
        layouts=layouts,
        config=config,
        is_joined=bool(run.is_made.any()),
    )
