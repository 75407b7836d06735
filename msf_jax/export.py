"""Files that other programs read, one writer a format. Written beside the target and renamed, so never by halves."""

import io
import json
import os
import secrets
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import networkx as nx
import numpy as np

from msf_jax import gltf
from msf_jax.errors import ConfigError
from msf_jax.host import branches

if TYPE_CHECKING:
    from msf_jax.skeleton import Skeleton


def save(skeleton: "Skeleton", path: str | os.PathLike[str], mesh: Any = None) -> None:
    """Write ``skeleton`` to ``path`` in the format of its suffix; see `Skeleton.save`."""
    write_whole(path, writer_for(path)(skeleton, mesh))


def writer_for(path: str | os.PathLike[str]) -> "Callable[[Skeleton, Any], str | bytes]":
    """What makes the content of a file, of a skeleton and its mesh, in the format that the suffix of ``path`` names.

    Raises:
        ConfigError: there is none.
    """
    name = Path(path).name.lower()
    for suffix, writer in WRITERS.items():
        if name.endswith(suffix):
            if suffix not in NEED_MESH:
                return lambda skeleton, mesh: writer(skeleton)
            return lambda skeleton, mesh: writer(skeleton, _needed(mesh, suffix))
    raise ConfigError(f"no format for {Path(path).name!r}: expected one of the suffixes {', '.join(WRITERS)}")


def _needed(mesh: Any, suffix: str) -> Any:
    if mesh is None:
        raise ConfigError(f"a {suffix} file holds the mesh, too: expected save(path, mesh)")
    return mesh


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
    parent = branches.tree(len(skeleton.vertices), skeleton.edges)
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


def _ply(skeleton: "Skeleton") -> str:
    header = ["ply", "format ascii 1.0", "comment curve skeleton written by msf_jax"]
    header += [f"element vertex {len(skeleton.vertices)}", *(f"property double {name}" for name in ("x", "y", "z"))]
    header += ["property double radius", f"element edge {len(skeleton.edges)}"]
    header += ["property int vertex1", "property int vertex2", "end_header"]
    rows = [f"{_point(at)} {_number(radius)}" for at, radius in zip(skeleton.vertices, skeleton.radii, strict=True)]
    return "\n".join([*header, *rows, *(f"{a} {b}" for a, b in skeleton.edges.tolist())]) + "\n"


def _vtp(skeleton: "Skeleton") -> str:
    """VTK's XML PolyData: a line for each branch, or a vertex for a lone node; point data "radius"."""
    ways = branches.trace(len(skeleton.vertices), skeleton.edges)
    lines, lone = [way for way in ways if len(way) > 1], [way for way in ways if len(way) == 1]

    def array(kind: str, name: str, values: str, components: int = 1) -> str:
        form = f'type="{kind}" Name="{name}" NumberOfComponents="{components}" format="ascii"'
        return f"<DataArray {form}>{values}</DataArray>"

    def cells(name: str, ways: list[list[int]]) -> str:
        numbers = array("Int64", "connectivity", " ".join(str(node) for way in ways for node in way))
        ends = array("Int64", "offsets", " ".join(map(str, np.cumsum([len(way) for way in ways], dtype=int))))
        return f"<{name}>{numbers}{ends}</{name}>"

    points = array("Float64", "points", " ".join(map(_point, skeleton.vertices)), 3)
    radii = array("Float64", "radius", " ".join(map(_number, skeleton.radii)))
    counts = f'NumberOfPoints="{len(skeleton.vertices)}" NumberOfLines="{len(lines)}" NumberOfVerts="{len(lone)}"'
    piece = f'<PointData Scalars="radius">{radii}</PointData><Points>{points}</Points>'
    piece += cells("Verts", lone) + cells("Lines", lines)
    return (
        '<?xml version="1.0"?>\n<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" '
        f'header_type="UInt64"><PolyData><Piece {counts}>{piece}</Piece></PolyData></VTKFile>\n'
    )


def _graphml(skeleton: "Skeleton") -> str:
    """Nodes with x, y, z and radius, edges with length, by NetworkX."""
    graph = skeleton.to_networkx()
    for _, data in graph.nodes(data=True):
        data["x"], data["y"], data["z"] = data.pop("position")
    return "\n".join(nx.generate_graphml(graph)) + "\n"


def _npz(skeleton: "Skeleton") -> bytes:
    """The arrays by their names, and the report as JSON."""
    buffer = io.BytesIO()
    arrays: dict[str, Any] = {name: getattr(skeleton, name) for name in ("vertices", "edges", "radii", "mesh_map")}
    np.savez_compressed(buffer, **arrays, report=np.array(json.dumps(skeleton.report.to_dict())))
    return buffer.getvalue()


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


# A writer takes the skeleton, and the mesh if it is one of those that need it.
NEED_MESH = (".glb",)
WRITERS: "dict[str, Callable[..., str | bytes]]" = {
    ".swc": _swc,
    ".obj": _obj,
    ".cg": _cg,
    ".polylines.txt": _polylines,
    ".ply": _ply,
    ".vtp": _vtp,
    ".graphml": _graphml,
    ".npz": _npz,
    ".json": _json,
    ".glb": gltf.skinned,
}
