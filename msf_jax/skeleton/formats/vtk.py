"""VTK's XML PolyData, of curves and frames."""

import base64
from typing import TYPE_CHECKING

import numpy as np

from msf_jax.skeleton.centrelines import branch_columns, node_columns
from msf_jax.skeleton.formats.text import point
from msf_jax.topology import graphs

if TYPE_CHECKING:
    from msf_jax.skeleton.skeleton import Skeleton


def vtp(skeleton: "Skeleton") -> str:
    """A line for each branch, or a vertex for an isolated node; point data are the columns of nodes, cell data those of
    branches."""
    paths = graphs.trace(len(skeleton.vertices), skeleton.edges)
    order = sorted(range(len(paths)), key=lambda number: len(paths[number]) > 1)  # VTK has vertices before lines
    lines, lone = [path for path in paths if len(path) > 1], [path for path in paths if len(path) == 1]
    of_node = node_columns(skeleton)
    tangent = np.stack([of_node.pop(f"tangent_{axis}") for axis in "xyz"], axis=1)
    of_node = {name: values for name, values in of_node.items() if name not in ("node", "x", "y", "z", "radius")}
    of_branch = {name: values[order] for name, values in branch_columns(skeleton).items()}
    of_point = {"radius": skeleton.radii, "tangent": tangent, **of_node}
    return polydata(skeleton.vertices, lone, lines, of_point, of_branch)


def polydata(
    points: np.ndarray,
    lone: list[list[int]],
    lines: list[list[int]],
    of_point: dict[str, np.ndarray],
    of_cell: dict[str, np.ndarray],
) -> str:
    """The text of vertices ``lone`` and ``lines`` between ``points`` (N, 3), with columns of data.

    The first column of points is shown first. Columns of cells have the vertices before the lines. A column without a
    known value is left out."""

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
    counts = f'NumberOfPoints="{len(points)}" NumberOfLines="{len(lines)}" NumberOfVerts="{len(lone)}"'
    piece = f'<PointData Scalars="{next(iter(of_point))}">{point_data}</PointData><CellData>{cell_data}</CellData>'
    piece += f"<Points>{array('Float64', 'points', ' '.join(map(point, points)), 3)}</Points>"
    piece += cells("Verts", lone) + cells("Lines", lines)
    return (
        '<?xml version="1.0"?>\n<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" '
        f'header_type="UInt64"><PolyData><Piece {counts}>{piece}</Piece></PolyData></VTKFile>\n'
    )
