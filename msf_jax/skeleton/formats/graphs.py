"""Text formats that hold a graph: OBJ, CG, PLY, VTK PolyData, GraphML; one writer each."""

from typing import TYPE_CHECKING

import networkx as nx
import numpy as np

from msf_jax.host.curve import branches
from msf_jax.skeleton.formats.text import number, point

if TYPE_CHECKING:
    from msf_jax.skeleton.skeleton import Skeleton


def obj(skeleton: "Skeleton") -> str:
    """Wavefront OBJ: vertices and line elements."""
    vertices = [f"v {point(position)}" for position in skeleton.vertices]
    lines = [f"l {a + 1} {b + 1}" for a, b in skeleton.edges.tolist()]
    return "\n".join(["# curve skeleton written by msf_jax", *vertices, *lines]) + "\n"


def cg(skeleton: "Skeleton") -> str:
    """A curve graph: vertices and edges, counted in its first line."""
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

    points = array("Float64", "points", " ".join(map(point, skeleton.vertices)), 3)
    radii = array("Float64", "radius", " ".join(map(number, skeleton.radii)))
    counts = f'NumberOfPoints="{len(skeleton.vertices)}" NumberOfLines="{len(lines)}" NumberOfVerts="{len(lone)}"'
    piece = f'<PointData Scalars="radius">{radii}</PointData><Points>{points}</Points>'
    piece += cells("Verts", lone) + cells("Lines", lines)
    return (
        '<?xml version="1.0"?>\n<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" '
        f'header_type="UInt64"><PolyData><Piece {counts}>{piece}</Piece></PolyData></VTKFile>\n'
    )


def graphml(skeleton: "Skeleton") -> str:
    """Nodes with x, y, z and radius, edges with length, by NetworkX."""
    graph = skeleton.to_networkx()
    for _, data in graph.nodes(data=True):
        data["x"], data["y"], data["z"] = data.pop("position")
    return "\n".join(nx.generate_graphml(graph)) + "\n"
