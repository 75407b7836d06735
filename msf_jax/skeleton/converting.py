"""A curve as an object of another library: NetworkX's graph, trimesh's path, navis' neuron, pandas' data frame."""

from typing import TYPE_CHECKING, Any

import networkx as nx
import numpy as np

from msf_jax.base.errors import ConfigError
from msf_jax.skeleton.formats import swc, tables
from msf_jax.topology import graphs

if TYPE_CHECKING:
    from pandas import DataFrame
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


def pandas_of(skeleton: "Skeleton", of: str) -> "DataFrame":
    """See `Skeleton.to_pandas`."""
    columns = tables.columns_of(skeleton, of)
    try:
        import pandas
    except ImportError as error:
        raise ConfigError("to_pandas needs pandas: install it with pip install pandas, or use columns") from error
    return pandas.DataFrame(columns)


def navis_of(skeleton: "Skeleton") -> Any:
    """See `Skeleton.to_navis`."""
    try:
        import navis
        import pandas
    except ImportError as error:
        raise ConfigError("to_navis needs navis: install it with pip install navis") from error
    parent = graphs.tree(len(skeleton.vertices), skeleton.edges, skeleton.roots)
    nodes = np.array(list(parent))
    columns = {"node_id": nodes, "label": swc.labels(skeleton, parent)[nodes]}
    columns |= dict(zip("xyz", skeleton.vertices[nodes].T, strict=True))
    columns |= {"radius": skeleton.radii[nodes], "parent_id": np.array(list(parent.values()))}
    units = {"units": skeleton.units} if skeleton.units else {}
    return navis.TreeNeuron(pandas.DataFrame(columns), **units)
