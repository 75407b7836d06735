"""A curve as an object of another library: NetworkX's graph, trimesh's path."""

from typing import TYPE_CHECKING

import networkx as nx
import numpy as np

from msf_jax.host import graphs

if TYPE_CHECKING:
    from trimesh.path import Path3D

    from msf_jax.skeleton.skeleton import Skeleton


def networkx_of(skeleton: "Skeleton") -> nx.Graph:
    """See `Skeleton.to_networkx`."""
    graph = nx.Graph()
    for number, (position, radius) in enumerate(zip(skeleton.vertices, skeleton.radii, strict=True)):
        graph.add_node(number, position=tuple(position.tolist()), radius=float(radius))
    a, b = skeleton.vertices[skeleton.edges[:, 0]], skeleton.vertices[skeleton.edges[:, 1]]
    for (one, other), size in zip(skeleton.edges.tolist(), np.linalg.norm(a - b, axis=1).tolist(), strict=True):
        graph.add_edge(one, other, length=size)
    return graph


def path3d_of(skeleton: "Skeleton") -> "Path3D":
    """See `Skeleton.to_path3d`."""
    from trimesh.path import Path3D
    from trimesh.path.entities import Line

    branches = graphs.trace(len(skeleton.vertices), skeleton.edges)
    return Path3D(entities=[Line(branch) for branch in branches], vertices=skeleton.vertices.copy(), process=False)
