"""A curve as tables, or as an object of another library: NetworkX's graph, trimesh's path, navis' neuron, pandas' data
frame; and as a folder of Neuroglancer's precomputed skeletons.

https://github.com/google/neuroglancer/blob/master/src/datasource/precomputed/skeletons.md. Such a folder has ``info``
and a binary file for each segment: the numbers of vertices and edges (uint32), positions (float32), edges (uint32), and
each attribute of ``info`` in its order. Neuroglancer has nanometres: ``transform`` in ``info`` leads to them from the
skeleton's units.
"""

import json
import numbers
import os
from typing import TYPE_CHECKING, Any

import networkx as nx
import numpy as np

from msf_jax.base.errors import ConfigError
from msf_jax.base.writing import made_folder, write_whole
from msf_jax.skeleton.centrelines import Columns, axis_columns, branch_columns, cylinder_columns, node_columns
from msf_jax.skeleton.formats.text import swc_labels
from msf_jax.topology import graphs

if TYPE_CHECKING:
    from pandas import DataFrame
    from trimesh.path import Path3D

    from msf_jax.skeleton.skeleton import Skeleton

TABLES = {"branches": branch_columns, "nodes": node_columns, "axes": axis_columns, "cylinders": cylinder_columns}
NANOMETRES = {"": 1.0, "nm": 1.0, "um": 1e3, "µm": 1e3, "μm": 1e3, "micron": 1e3, "microns": 1e3, "mm": 1e6, "m": 1e9}
ATTRIBUTES = (("radius", "float32"), ("vertex_types", "uint8"))  # cloud-volume reads both by these names


def columns_of(skeleton: "Skeleton", of: str) -> Columns:
    """See `Skeleton.columns`."""
    if of not in TABLES:
        raise ConfigError(f"there is no table of {of!r}: expected one of {', '.join(map(repr, TABLES))}")
    return TABLES[of](skeleton)


def networkx_of(skeleton: "Skeleton") -> nx.Graph:
    """See `Skeleton.to_networkx`."""
    graph = nx.Graph()
    for number, (position, radius) in enumerate(zip(skeleton.vertices, skeleton.radii, strict=True)):
        graph.add_node(number, position=tuple(position.tolist()), radius=float(radius))
    along = skeleton.vertices[skeleton.edges[:, 0]] - skeleton.vertices[skeleton.edges[:, 1]]
    for (a, b), length in zip(skeleton.edges.tolist(), np.linalg.norm(along, axis=1).tolist(), strict=True):
        graph.add_edge(a, b, length=length)
    return graph


def path3d_of(skeleton: "Skeleton") -> "Path3D":
    """See `Skeleton.to_path3d`."""
    from trimesh.path import Path3D
    from trimesh.path.entities import Line

    branches = graphs.trace(len(skeleton.vertices), skeleton.edges)
    return Path3D(entities=[Line(branch) for branch in branches], vertices=skeleton.vertices.copy(), process=False)


def pandas_of(skeleton: "Skeleton", of: str) -> "DataFrame":
    """See `Skeleton.to_pandas`."""
    columns = skeleton.columns(of)
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
    columns = {"node_id": nodes, "label": swc_labels(skeleton, parent)[nodes]}
    columns |= dict(zip("xyz", skeleton.vertices[nodes].T, strict=True))
    columns |= {"radius": skeleton.radii[nodes], "parent_id": np.array(list(parent.values()))}
    units = {"units": skeleton.units} if skeleton.units else {}
    return navis.TreeNeuron(pandas.DataFrame(columns), **units)


def save_precomputed(skeleton: "Skeleton", folder: str | os.PathLike[str], segment: Any) -> None:
    """See `Skeleton.save_precomputed`."""
    if isinstance(segment, bool) or not isinstance(segment, numbers.Integral) or not 0 <= int(segment) < 2**64:
        raise ConfigError(f"segment is {segment!r}: expected the id of a segment, a whole number of 0 or more")
    if (units := skeleton.units) not in NANOMETRES:
        raise ConfigError(f"the units are {units!r}: Neuroglancer has nanometres, expected one of {list(NANOMETRES)}")
    info = {
        "@type": "neuroglancer_skeletons",
        "transform": (NANOMETRES[units] * np.eye(3, 4)).ravel().tolist(),
        "vertex_attributes": [{"id": name, "data_type": kind, "num_components": 1} for name, kind in ATTRIBUTES],
    }
    place = made_folder(folder)
    known = place / "info"
    if known.exists() and json.loads(known.read_text()) != info:
        raise ConfigError(f"{str(known)!r} is of other skeletons, or other units: expected a folder of its own")
    num = len(skeleton.vertices)
    label = swc_labels(skeleton, graphs.tree(num, skeleton.edges, skeleton.roots))
    parts = (
        np.array([num, len(skeleton.edges)], dtype="<u4"),
        skeleton.vertices.astype("<f4"),
        skeleton.edges.astype("<u4"),
        skeleton.radii.astype("<f4"),
        label.astype("u1"),
    )
    write_whole(known, json.dumps(info) + "\n")
    write_whole(place / str(int(segment)), b"".join(part.tobytes() for part in parts))
