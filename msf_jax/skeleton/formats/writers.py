"""The formats of files: a function of a skeleton for each, which returns the content as text or bytes.

The command line's help needs the suffixes, so nothing here that is slow to import is imported before it is used.
"""

import base64
import csv
import io
import json
import os
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from msf_jax.base.errors import ConfigError

if TYPE_CHECKING:
    from msf_jax.skeleton.skeleton import Skeleton

KIND = "skeleton"  # of an .npz file, see `archive`
FORMAT_VERSION = 2  # of such a file
WRITTEN = "curve skeleton written by msf_jax"
CUT = "# cut edge"  # begins the comment of an SWC file that lists a cut edge by its two ids
REPORT = "# report: "  # begins the comment with a line of the report
UNITS = "# units: "  # begins the comment with the unit of lengths
RADII = {"ball": "of the largest ball inside", "section": "of a disc with the area of the cross-section"}


def number(value: float) -> str:
    """The shortest text that reads back to the same float64."""
    return repr(float(value))


def _point(position: np.ndarray) -> str:
    return " ".join(map(number, position))


def swc(skeleton: "Skeleton", label: int | None = None) -> str:
    """SWC (id, label, x, y, z, radius, parent): ids from 1, parents before children, -1 for the parent of a root; a
    tree's root first. If that is surely a soma, it is one node, see `gather_soma`. All others have the ``label``."""
    from msf_jax.skeleton import trees

    vertices, edges, radii, roots = skeleton.vertices, skeleton.edges, skeleton.radii, skeleton.roots
    header = [f"# {WRITTEN}"]
    if not np.isnan(skeleton.report.inside):  # a curve that was read from a file has no report
        header += [REPORT + " ".join(line.split()) for line in skeleton.report.lines()]
    header.append(f"# labels: 1 soma, {'5 fork, 6 end, 0' if label is None else label} other")  # as CNIC counts them
    has_soma = bool(roots) and (soma := skeleton.soma()).is_sure and soma.node == roots[0]
    if has_soma:
        vertices, edges, radii, roots = gather_soma(skeleton)
        header.append("# soma: one node, in place of those within its radius, where neurites begin")
    header.append(f"# radius: {RADII[skeleton.radius_of]}")
    if units := " ".join(skeleton.units.split()):
        header += [UNITS + units, f"# Meta: {json.dumps({'units': units})}"]  # navis reads the second
    parent = trees.tree(len(vertices), edges, roots)
    row_of = {node: row for row, node in enumerate(parent, 1)} | {-1: -1}
    cut = [f"{CUT} {row_of[a]} {row_of[b]}" for a, b in edges.tolist() if parent[a] != b and parent[b] != a]
    header.append(f"# loops cut: {len(cut)}; each cut edge is listed by its two ids")
    above = np.array([value for value in parent.values() if value >= 0], dtype=np.int64)
    children = np.bincount(above, minlength=len(vertices))
    labels = np.select([children > 1, children == 0], [5, 6], 0) if label is None else np.full(len(vertices), label)
    labels[list(roots[:has_soma])] = 1
    rows = [
        f"{row_of[node]} {labels[node]} {_point(vertices[node])} {number(radii[node])} {row_of[above]}"
        for node, above in parent.items()
    ]
    return "\n".join([*header, *cut, *rows]) + "\n"


def gather_soma(skeleton: "Skeleton") -> tuple[np.ndarray, np.ndarray, np.ndarray, tuple[int, ...]]:
    """Vertices, edges, radii and roots of the curve with one node, 0, for the first root and all nodes in its ball,
    moved to where that is largest if the surface is known. Each edge out of the ball begins with a new node on the
    ball, as wide as the edge's other end: the area is the ball's and that of the cones along the edges outside."""
    from msf_jax.curve.junctions import middle_of_ball
    from msf_jax.solid.geometry import unit

    vertices, edges, radii, roots = skeleton.vertices, skeleton.edges, skeleton.radii, skeleton.roots
    centre, radius = vertices[roots[0]], radii[roots[0]]
    if skeleton.source is not None:
        solid = skeleton.source.solid
        centre = solid.leave(middle_of_ball(solid.shape, solid.enter(centre)))
        radius = max(radius, float(solid.radii(centre[None])[0]))
    is_out = np.linalg.norm(vertices - centre, axis=1) > radius
    is_out[roots[0]] = False
    rank, kept = np.where(is_out, np.cumsum(is_out), 0), np.append(roots[0], np.flatnonzero(is_out))
    vertices, radii, links = vertices[kept], radii[kept], np.sort(rank[edges], axis=1)
    vertices[0], radii[0] = centre, radius
    first = np.unique(links[(links[:, 0] == 0) & (links[:, 1] > 0), 1])
    begin = len(kept) + np.arange(len(first))
    edges = np.concatenate([links[links[:, 0] > 0], np.stack([0 * begin, begin], 1), np.stack([first, begin], 1)])
    begins = centre + radius * unit(vertices[first] - centre)
    return np.append(vertices, begins, 0), edges, np.append(radii, radii[first]), tuple(rank[list(roots)].tolist())


def obj(skeleton: "Skeleton") -> str:
    """Wavefront OBJ: vertices and line elements."""
    vertices = [f"v {_point(position)}" for position in skeleton.vertices]
    return "\n".join([f"# {WRITTEN}", *vertices, *(f"l {a + 1} {b + 1}" for a, b in skeleton.edges.tolist())]) + "\n"


def polylines(skeleton: "Skeleton") -> str:
    """CGAL's polylines: a line for each branch, the number of points and their coordinates."""
    from msf_jax.topology import graphs

    paths = graphs.trace(len(skeleton.vertices), skeleton.edges)
    return "".join(f"{len(path)} {' '.join(map(_point, skeleton.vertices[path]))}\n" for path in paths)


def table(skeleton: "Skeleton", of: str) -> str:
    """One of the tables of `Skeleton.columns` as comma-separated text; unknown values are empty."""
    columns, buffer = skeleton.columns(of), io.StringIO()
    rows = csv.writer(buffer, lineterminator="\n")
    rows.writerow(columns)
    for row in zip(*(values.tolist() for values in columns.values()), strict=True):
        rows.writerow(["" if value != value else value for value in row])  # NaN is not itself
    return buffer.getvalue()


def vtp(skeleton: "Skeleton") -> str:
    """VTK's XML PolyData: a line for each branch, or a vertex for an isolated node; point data are the columns of
    nodes, cell data those of branches. A column without a known value is left out."""
    from msf_jax.skeleton.centrelines import branch_columns, direct_branches, node_columns

    def array(name: str, values: np.ndarray) -> str:
        """The number of bytes and the values in base64, because VTK's text has no NaN."""
        is_whole = values.dtype.kind in "bi"
        data = values.astype("<i8" if is_whole else "<f8").tobytes()
        text = base64.b64encode(len(data).to_bytes(8, "little") + data).decode()
        head = f'type="{"Int64" if is_whole else "Float64"}" Name="{name}" NumberOfComponents="{values[:1].size or 1}"'
        return f'<DataArray {head} format="binary">{text}</DataArray>'

    def cells(name: str, paths: list[np.ndarray]) -> str:
        nodes = np.array([node for path in paths for node in path], dtype=np.int64)
        ends = np.cumsum([len(path) for path in paths], dtype=np.int64)
        return f"<{name}>{array('connectivity', nodes)}{array('offsets', ends)}</{name}>"

    def data(columns: dict[str, np.ndarray]) -> str:
        is_known = {name: not np.isnan(values.astype(float)).all() for name, values in columns.items()}
        return "".join(array(name, values) for name, values in columns.items() if is_known[name])

    paths = direct_branches(skeleton).paths
    lone, lines = [path for path in paths if len(path) == 1], [path for path in paths if len(path) > 1]
    order = np.argsort([len(path) > 1 for path in paths], kind="stable")  # VTK has vertices before lines
    of_node = {name: values for name, values in node_columns(skeleton).items() if name not in ("node", "x", "y", "z")}
    of_node["tangent"] = np.stack([of_node.pop(f"tangent_{axis}") for axis in "xyz"], axis=1)
    of_branch = {name: values[order] for name, values in branch_columns(skeleton).items()}
    counts = f'NumberOfPoints="{len(skeleton.vertices)}" NumberOfLines="{len(lines)}" NumberOfVerts="{len(lone)}"'
    piece = f'<PointData Scalars="radius">{data(of_node)}</PointData><CellData>{data(of_branch)}</CellData>'
    piece += f"<Points>{array('points', skeleton.vertices)}</Points>{cells('Verts', lone)}{cells('Lines', lines)}"
    return (
        '<?xml version="1.0"?>\n<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" '
        f'header_type="UInt64"><PolyData><Piece {counts}>{piece}</Piece></PolyData></VTKFile>\n'
    )


def npz(skeleton: "Skeleton") -> bytes:
    """The arrays by name, the report as JSON, and the surface and pins that the curve was made from, if known."""
    from msf_jax.base import archive

    arrays: dict[str, Any] = {name: getattr(skeleton, name) for name in ("vertices", "edges", "radii", "mesh_map")}
    arrays |= {name: np.array(getattr(skeleton, name), dtype=np.int64) for name in ("roots", "openings")}
    arrays |= {name: np.array(getattr(skeleton, name)) for name in ("radius_of", "units")}
    if (source := skeleton.source) is not None:
        solid = source.solid
        arrays |= {"surface_vertices": solid.vertices, "surface_faces": solid.shape.faces.astype(np.int32)}
        arrays |= {"areas": source.areas, "pins": np.asarray(source.pins, dtype=np.int64), "lids": solid.lids}
        if source.input_of_vertex is not None:
            arrays["input_of_vertex"] = source.input_of_vertex
    arrays["report"] = np.array(json.dumps(skeleton.report.to_dict()))
    return archive.packed(KIND, FORMAT_VERSION, arrays)


def plain_json(skeleton: "Skeleton") -> str:
    """All of a skeleton but its report and surface, by name."""
    arrays = {name: getattr(skeleton, name).tolist() for name in ("vertices", "edges", "radii", "mesh_map")}
    others = {name: getattr(skeleton, name) for name in ("roots", "openings", "radius_of", "units")}
    return json.dumps({**arrays, **others}) + "\n"


def ply(skeleton: "Skeleton") -> str:
    """PLY: vertices with radius, edges."""
    header = ["ply", "format ascii 1.0", f"comment {WRITTEN}", f"element vertex {len(skeleton.vertices)}"]
    header += [f"property double {name}" for name in ("x", "y", "z", "radius")]
    header += [f"element edge {len(skeleton.edges)}", "property int vertex1", "property int vertex2", "end_header"]
    rows = map(_point, np.column_stack([skeleton.vertices, skeleton.radii]))
    return "\n".join([*header, *rows, *(f"{a} {b}" for a, b in skeleton.edges.tolist())]) + "\n"


def glb(skeleton: "Skeleton", mesh: Any) -> bytes:
    """The mesh on the bones of the skeleton, see `rigging.rig`."""
    from msf_jax.skeleton.rigging.rig import glb_of

    if mesh is None:
        raise ConfigError("a .glb file contains the mesh, too: expected save(path, mesh)")
    return glb_of(skeleton.rig(mesh=mesh), mesh)


# Of each suffix. Longer suffixes stand before those with which they end.
WRITERS: "dict[str, Callable[..., str | bytes]]" = {
    ".swc": swc,
    ".json": plain_json,
    ".obj": obj,
    ".ply": ply,
    ".polylines.txt": polylines,
    ".vtp": vtp,
    ".nodes.csv": partial(table, of="nodes"),
    ".axes.csv": partial(table, of="axes"),
    ".cylinders.csv": partial(table, of="cylinders"),
    ".csv": partial(table, of="branches"),
    ".npz": npz,
    ".glb": glb,
}


def writer_for(path: str | os.PathLike[str], label: int | None = None) -> "Callable[[Skeleton, Any], str | bytes]":
    """The function from a skeleton and its mesh to the content of a file, for the suffix of ``path``.

    Raises:
        ConfigError: no format has that suffix, or one without labels has a ``label``.
    """
    name = Path(path).name
    suffix = next((each for each in WRITERS if name.lower().endswith(each)), None)
    if suffix is None:
        beams = "; skeleton.frame().save(...) in Python writes beams" if name.lower().endswith(".inp") else ""
        raise ConfigError(f"no format for {name!r}: expected one of the suffixes {', '.join(WRITERS)}{beams}")
    if label is not None and (suffix != ".swc" or type(label) is not int or label < 0):
        raise ConfigError(f"label is {label!r} for {name!r}: expected a whole number of 0 or more, for an .swc file")
    write = WRITERS[suffix] if label is None else partial(swc, label=label)
    return write if suffix == ".glb" else lambda skeleton, mesh: write(skeleton)
