"""Files that other programs read, one writer a format. Written beside the target and renamed, so never by halves."""

import json
import os
import secrets
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import networkx as nx
import numpy as np

from msf_jax.errors import ConfigError
from msf_jax.host import branches

if TYPE_CHECKING:
    from msf_jax.skeleton import Skeleton


def save(skeleton: "Skeleton", path: str | os.PathLike[str]) -> None:
    """Write ``skeleton`` to ``path`` in the format of its suffix; see `Skeleton.save`."""
    write_whole(path, writer_for(path)(skeleton))


def writer_for(path: str | os.PathLike[str]) -> "Callable[[Skeleton], str]":
    """The writer that the suffix of ``path`` names.

    Raises:
        ConfigError: there is none.
    """
    name = Path(path).name.lower()
    for suffix, writer in WRITERS.items():
        if name.endswith(suffix):
            return writer
    raise ConfigError(f"no format for {Path(path).name!r}: expected one of the suffixes {', '.join(WRITERS)}")


def write_whole(path: str | os.PathLike[str], content: str | bytes) -> None:
    """Write a file beside ``path`` and rename it, so that ``path`` is the old file or the new one, never half.

    A link is followed, and a file that is replaced keeps its permissions.
    """
    target = Path(os.path.realpath(path))
    data = content.encode() if isinstance(content, str) else content
    beside = target.with_name(f".msf_jax-{secrets.token_hex(8)}.tmp")
    try:
        with open(beside, "xb") as file:
            file.write(data)
        if target.exists():
            shutil.copymode(target, beside)
        os.replace(beside, target)
    except BaseException as error:
        beside.unlink(missing_ok=True)
        if isinstance(error, OSError):
            raise type(error)(error.errno, error.strerror, str(path)) from error
        raise


def _number(value: float) -> str:
    return repr(float(value))


def _point(position: np.ndarray) -> str:
    return " ".join(map(_number, position))


def _swc(skeleton: "Skeleton") -> str:
    """SWC: id, type, x, y, z, radius, parent. Ids from 1, parents before children, -1 for a root."""
    graph = nx.Graph()
    graph.add_nodes_from(range(len(skeleton.vertices)))
    graph.add_edges_from(skeleton.edges.tolist())
    parent: dict[int, int] = {}
    for component in nx.connected_components(graph):
        leaves = [node for node in component if graph.degree[node] == 1]
        root = min(leaves or component)
        parent[root] = -1
        parent.update({child: above for above, child in nx.bfs_edges(graph, root, sort_neighbors=sorted)})
    number = {node: index + 1 for index, node in enumerate(parent)}
    cut = [
        f"# cut edge {number[a]} {number[b]}" for a, b in skeleton.edges.tolist() if parent[a] != b and parent[b] != a
    ]
    header = ["# curve skeleton written by msf_jax", f"# loops cut: {len(cut)}; each cut edge is listed by its two ids"]
    rows = [
        f"{number[node]} 0 {_point(skeleton.vertices[node])} {_number(skeleton.radii[node])} "
        f"{number[above] if above >= 0 else -1}"
        for node, above in parent.items()
    ]
    return "\n".join([*header, *cut, *rows]) + "\n"


def _obj(skeleton: "Skeleton") -> str:
    vertices = [f"v {_point(position)}" for position in skeleton.vertices]
    lines = [f"l {a + 1} {b + 1}" for a, b in skeleton.edges.tolist()]
    return "\n".join(["# curve skeleton written by msf_jax", *vertices, *lines]) + "\n"


def _cg(skeleton: "Skeleton") -> str:
    header = f"# D:3 NV:{len(skeleton.vertices)} NE:{len(skeleton.edges)}"
    vertices = [f"v {_point(position)}" for position in skeleton.vertices]
    edges = [f"e {a + 1} {b + 1}" for a, b in skeleton.edges.tolist()]
    return "\n".join([header, *vertices, *edges]) + "\n"


def _polylines(skeleton: "Skeleton") -> str:
    return "".join(
        f"{len(branch)} {' '.join(_point(skeleton.vertices[node]) for node in branch)}\n"
        for branch in branches.trace(len(skeleton.vertices), skeleton.edges)
    )


def _json(skeleton: "Skeleton") -> str:
    content = {
        "format": "msf_jax skeleton",
        "version": 1,
        "vertices": skeleton.vertices.tolist(),
        "edges": skeleton.edges.tolist(),
        "radii": skeleton.radii.tolist(),
        "mesh_map": skeleton.mesh_map.tolist(),
        "report": skeleton.report.to_dict(),
    }
    return json.dumps(content) + "\n"


WRITERS: "dict[str, Callable[[Skeleton], str]]" = {
    ".swc": _swc,
    ".obj": _obj,
    ".cg": _cg,
    ".polylines.txt": _polylines,
    ".json": _json,
}
