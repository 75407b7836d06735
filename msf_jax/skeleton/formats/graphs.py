"""Writers of text formats for graphs: OBJ, CG, PLY, VTK PolyData, GraphML, GML."""

import base64
from typing import TYPE_CHECKING

import networkx as nx
import numpy as np

from msf_jax.skeleton.centrelines import branch_columns, node_columns
from msf_jax.skeleton.formats.text import number, point
from msf_jax.topology import graphs

if TYPE_CHECKING:
    from msf_jax.skeleton.skeleton import Skeleton


def obj(skeleton: "Skeleton") -> str:
    """Wavefront OBJ: vertices and line elements."""
    vertices = [f"v {point(position)}" for position in skeleton.vertices]
    lines = [f"l {a + 1} {b + 1}" for a, b in skeleton.edges.tolist()]
    return "\n".join(["# curve skeleton written by msf_jax", *vertices, *lines]) + "\n"


def cg(skeleton: "Skeleton") -> str:
    """A curve graph: vertices and edges, with their numbers in the first line."""
    header = f"# D:3 NV:{len(skeleton.vertices)} NE:{len(skeleton.edges)}"
    vertices = [f"v {point(position)}" for position in skeleton.vertices]
    edges = [f"e {a + 1} {b + 1}" for a, b in skeleton.edges.tolist()]
    return "\n".join([header, *vertices, *edges]) + "\n"


def ply(skeleton: "Skeleton") -> str:
    """PLY: vertices with radius, edges."""
    header = ["ply", "format ascii 1.0", "comment curve skeleton written by msf_jax"]
    header += [f"element vertex {len(skeleton.vertices)}", *(f"property double {name}" for name in ("x", "y", "z"))]
    header += ["property double radius", f"element edge {len(skeleton.edges)}"]
    header += ["property int vertex1", "property int vertex2", "end_header"]
    rows = [f"{point(at)} {number(radius)}" for at, radius in zip(skeleton.vertices, skeleton.radii, strict=True)]
    return "\n".join([*header, *rows, *(f"{a} {b}" for a, b in skeleton.edges.tolist())]) + "\n"


def vtp(skeleton: "Skeleton") -> str:
    """VTK's XML PolyData: a line for each branch, or a vertex for an isolated node, with the columns of both tables.

    Point data are the columns of nodes, cell data those of branches. A column without a known value is left out.
    """
    paths = graphs.trace(len(skeleton.vertices), skeleton.edges)
    order = sorted(range(len(paths)), key=lambda number: len(paths[number]) > 1)  # VTK has vertices before lines
    lines, lone = [path for path in paths if len(path) > 1], [path for path in paths if len(path) == 1]
    of_node = node_columns(skeleton)
    of_node = {"tangent": np.stack([of_node.pop(f"tangent_{axis}") for axis in "xyz"], axis=1)} | of_node
    of_node = {name: values for name, values in of_node.items() if name not in ("node", "x", "y", "z", "radius")}
    of_branch = {name: values[order] for name, values in branch_columns(skeleton).items()}
    return polydata(skeleton.vertices, lone, lines, {"radius": skeleton.radii} | of_node, of_branch)


def polydata(
    points: np.ndarray,
    lone: list[list[int]],
    lines: list[list[int]],
    of_point: dict[str, np.ndarray],
    of_cell: dict[str, np.ndarray],
) -> str:
    """VTK's XML PolyData of vertices ``lone`` and ``lines`` between ``points`` (N, 3), with columns of data.

    The first column of points is shown first. Columns of cells have the vertices before the lines."""

    def array(kind: str, name: str, values: str, components: int = 1, form: str = "ascii") -> str:
        head = f'type="{kind}" Name="{name}" NumberOfComponents="{components}" format="{form}"'
        return f"<DataArray {head}>{values}</DataArray>"

    def column(name: str, values: np.ndarray) -> str:
        """The number of bytes and the values in base64, because VTK's text has no NaN."""
        is_whole = values.dtype.kind in "bi"
        data = values.astype("<i8" if is_whole else "<f8").tobytes()
        text = base64.b64encode(len(data).to_bytes(8, "little") + data).decode()
        return array("Int64" if is_whole else "Float64", name, text, values[:1].size or 1, "binary")

    def cells(name: str, paths: list[list[int]]) -> str:
        numbers = array("Int64", "connectivity", " ".join(str(node) for path in paths for node in path))
        ends = array("Int64", "offsets", " ".join(map(str, np.cumsum([len(path) for path in paths], dtype=int))))
        return f"<{name}>{numbers}{ends}</{name}>"

    point_data, cell_data = (
        "".join(column(name, values) for name, values in columns.items() if not np.isnan(values.astype(float)).all())
        for columns in (of_point, of_cell)
    )
    places = array("Float64", "points", " ".join(map(point, points)), 3)
    counts = f'NumberOfPoints="{len(points)}" NumberOfLines="{len(lines)}" NumberOfVerts="{len(lone)}"'
    first = next(iter(of_point))
    piece = f'<PointData Scalars="{first}">{point_data}</PointData><CellData>{cell_data}</CellData>'
    piece += f"<Points>{places}</Points>" + cells("Verts", lone) + cells("Lines", lines)
    return (
        '<?xml version="1.0"?>\n<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" '
        f'header_type="UInt64"><PolyData><Piece {counts}>{piece}</Piece></PolyData></VTKFile>\n'
    )


def graphml(skeleton: "Skeleton") -> str:
    """Nodes with x, y, z and radius, edges with length, by NetworkX."""
    return "\n".join(nx.generate_graphml(_plain(skeleton))) + "\n"


def gml(skeleton: "Skeleton") -> str:
    """The same graph in the Graph Modelling Language, by NetworkX."""
    return "\n".join(nx.generate_gml(_plain(skeleton))) + "\n"


def _plain(skeleton: "Skeleton") -> nx.Graph:
    """The graph of `Skeleton.to_networkx`, with x, y and z instead of positions: attributes must be numbers."""
    graph = skeleton.to_networkx()
    for _, data in graph.nodes(data=True):
        data["x"], data["y"], data["z"] = data.pop("position")
    return graph
