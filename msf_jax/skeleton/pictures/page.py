"""A self-contained interactive page of surface, curve, iterations and pruning, drawn by plotly."""

import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy import spatial

from msf_jax.base.errors import ConfigError
from msf_jax.base.writing import write_whole
from msf_jax.meshes import reading
from msf_jax.meshes.reading import MeshLike
from msf_jax.skeleton.pictures import segmentation
from msf_jax.skeleton.pictures.camera import looking

if TYPE_CHECKING:
    from plotly.graph_objects import Figure

    from msf_jax.skeleton.skeleton import Skeleton

LINE_WIDTH = 6  # pixels: width of the curve
PRUNED = (0.0, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 10.0)  # slenderness at the stops of the slider
LARGEST_FLOAT32 = 1e30  # coordinates above this, in the caller's units, are written in float64
GREY = "#8c9eb8"  # colour of the surface
RADIUS = "radius %{customdata:.4g}<extra></extra>"  # plotly's template of the text at the pointer
SLOPE = np.tan(np.radians(22.5))  # tangent of half of plotly's angle of view
LANDSCAPE = 1.3  # width over height of a picture, at least
LEAST_EXTENT = 0.01  # least ratio of the scene's extents: the box of a line or a point would be empty


def view(skeleton: "Skeleton", mesh: "MeshLike | None" = None, path: str | os.PathLike[str] | None = None) -> "Figure":
    """See `Skeleton.view`."""
    import plotly.graph_objects as go

    if isinstance(mesh, str | os.PathLike) and str(mesh).lower().endswith(".html"):
        raise ConfigError(f"{str(mesh)!r} is given as the mesh, the first argument: expected path={str(mesh)!r}")
    if path is not None and Path(path).suffix.lower() != ".html":
        raise ConfigError(f"a page is written as .html, not as {Path(path).suffix!r}")
    middle = (skeleton.vertices.min(axis=0) + skeleton.vertices.max(axis=0)) / 2  # float32 is precise enough around it
    traces, node = _surfaces(skeleton, mesh, middle)
    stages = skeleton.source.stages if skeleton.source else ()
    num_surfaces = len(traces)
    for stage in stages:
        name = f"after {stage.iteration} iterations"
        traces.append(_mesh(stage.vertices - middle, stage.faces, name, opacity=0.9, color="#5b8c5a", visible=False))
        fixed = stage.vertices[stage.is_fixed] - middle
        dots = dict(zip("xyz", fixed.T, strict=True)) | {"marker": {"size": 2, "color": "black"}}
        traces.append(go.Scatter3d(**dots, mode="markers", name="fixed vertices", visible=False, hoverinfo="name"))
    kept = _pruned(skeleton)
    num_stages = len(traces) - num_surfaces
    low, high = float(skeleton.radii.min()), float(skeleton.radii.max())
    for number, (_, curve) in enumerate(kept):
        traces.append(_line(curve, middle, (low, high), visible=number == 0))
    drawing = go.Figure(traces)
    first = num_surfaces + num_stages
    drawing.update_layout(
        template="plotly_white",
        margin={"l": 0, "r": 0, "t": 40, "b": 90},
        title={"text": _title(skeleton), "font": {"size": 14}},
        showlegend=False,
        **_scene(traces),
        sliders=[
            _slider("contraction: ", ["none", *(f"{stage.iteration}" for stage in stages)], num_surfaces, 2, 0.02, 1),
            _slider("pruned at slenderness: ", [text for text, _ in kept], first, 1, 0.53, 0),
        ],
        updatemenus=[_menu(num_surfaces, node)],
    )
    if path is not None:
        write_whole(path, drawing.to_html(include_plotlyjs=True))
    return drawing


def _title(skeleton: "Skeleton") -> str:
    report = skeleton.report
    cycles = f"{report.cycles} {'cycle' if report.cycles == 1 else 'cycles'} for genus {report.genus}"
    counts = f"{len(skeleton.vertices)} nodes, {cycles}"
    inside = "" if np.isnan(report.inside) else f", {100 * report.inside:.1f} % inside"
    return f"{counts}{inside}; {report.reason}"


def _surfaces(skeleton: "Skeleton", mesh: "MeshLike | None", middle: np.ndarray) -> tuple[list[Any], bool]:
    """The mesh in grey, and coloured by node if the curve has a map of it; and whether it has."""
    if mesh is None:
        if skeleton.source is None:
            return [], False
        solid = skeleton.source.solid
        vertices, faces = solid.centre + solid.diagonal * solid.shape.vertices, solid.shape.faces
    else:
        vertices, faces = reading.read(mesh, finite=False)
        if len(skeleton.mesh_map):
            reading.check_map(skeleton.mesh_map, len(vertices))
    node = _node_of(skeleton, vertices, len(vertices) if mesh is not None else -1)
    # The pointer meets the surface before the curve, so the surface shows the radius, too.
    hover = {"hoverinfo": None, "customdata": _short(skeleton.radii)[node], "hovertemplate": RADIUS}
    found = [_mesh(vertices - middle, faces, "surface", opacity=0.18, color=GREY, visible=True, **hover)]
    if mesh is None or len(skeleton.mesh_map) == 0:  # a curve of another program has no map
        return found, False
    colour = segmentation.colours(len(skeleton.vertices))[skeleton.mesh_map]
    rgb = [f"rgb({r},{g},{b})" for r, g, b, _ in colour]
    style = {"opacity": 0.5, "vertexcolor": rgb, "visible": False}
    found.append(_mesh(vertices - middle, faces, "surface by node", **style, **hover))
    return found, True


def _node_of(skeleton: "Skeleton", vertices: np.ndarray, num: int) -> np.ndarray:
    """(V,) the node of each vertex: by the map if it has ``num`` entries, else the nearest."""
    if len(skeleton.mesh_map) == num:
        return skeleton.mesh_map
    return np.asarray(spatial.KDTree(skeleton.vertices).query(vertices)[1])


def _mesh(vertices: np.ndarray, faces: np.ndarray, name: str, **options: Any) -> Any:
    import plotly.graph_objects as go

    corners = dict(zip("ijk", np.asarray(faces, dtype=np.int32).T, strict=True))
    at = dict(zip("xyz", _short(vertices).T, strict=True))
    return go.Mesh3d(**at, **corners, name=name, flatshading=False, **({"hoverinfo": "skip"} | options))


def _short(points: np.ndarray) -> np.ndarray:
    """Coordinates as float32, for a smaller page, unless they are too large for that."""
    return points.astype(np.float32 if np.nanmax(np.abs(points), initial=0.0) < LARGEST_FLOAT32 else np.float64)


def _scene(traces: list[Any]) -> dict[str, Any]:
    """Axes and camera such that all is in view, and stays in place when parts are hidden. Plotly's unit of length is
    the diagonal of the scene's box."""
    parts = [np.stack([np.asarray(trace[axis], dtype=np.float64) for axis in "xyz"], axis=1) for trace in traces]
    points = np.concatenate(parts)
    points = points[np.isfinite(points).all(axis=1)]  # there are gaps in lines
    faces = np.stack([traces[0][corner] for corner in "ijk"], axis=1) if traces[0].type == "mesh3d" else None
    seen = looking(points if faces is None else parts[0], faces)
    middle, half = (points.max(axis=0) + points.min(axis=0)) / 2, np.ptp(points, axis=0) / 2
    half = np.maximum(half, LEAST_EXTENT * (float(half.max()) or 1.0))
    diagonal = 2 * float(np.linalg.norm(half / half.max())) * float(half.max())
    reach = np.abs((points - middle) @ np.stack([seen.right, seen.up, seen.towards], axis=1)).max(axis=0)
    wide, high, deep = (reach / diagonal).tolist()
    away = deep + max(high, wide / LANDSCAPE) / SLOPE
    axes = {
        f"{axis}axis": {"visible": False, "range": [a, b]}
        for axis, a, b in zip("xyz", (middle - half).tolist(), (middle + half).tolist(), strict=True)
    }
    ratio, eye, up = (
        dict(zip("xyz", v.tolist(), strict=True)) for v in (2 * half / diagonal, away * seen.towards, seen.up)
    )
    return {"scene": {"aspectmode": "manual", "aspectratio": ratio, "camera": {"eye": eye, "up": up}, **axes}}


def _pruned(skeleton: "Skeleton") -> list[tuple[str, "Skeleton"]]:
    """The curve at each stop of the slider, without stops that change nothing."""
    kept = [("none", skeleton)]
    for slenderness in PRUNED[1:]:
        curve = skeleton.prune(slenderness)
        if len(curve.edges) < len(kept[-1][1].edges):
            kept.append((f"{slenderness:g}", curve))
    return kept


def _line(curve: "Skeleton", middle: np.ndarray, limits: tuple[float, float], *, visible: bool) -> Any:
    """Every edge as a line, coloured by radius, with a gap after it; a curve without edges as dots."""
    import plotly.graph_objects as go

    bar = {"title": "radius", "len": 0.5, "thickness": 14, "x": 1, "xanchor": "right"}
    scale = {"colorscale": "Plasma", "cmin": limits[0], "cmax": limits[1], "colorbar": bar}
    points, radius = curve.vertices - middle, curve.radii
    if len(curve.edges):
        points = np.pad(points[curve.edges], ((0, 0), (0, 1), (0, 0)), constant_values=np.nan).reshape(-1, 3)
        radius = np.repeat(radius[curve.edges], [1, 2], axis=1).ravel()  # the gap has one, too
        style = {"mode": "lines", "line": {"color": _short(radius), "width": LINE_WIDTH, **scale}}
    else:
        style = {"mode": "markers", "marker": {"color": radius, "size": 6, **scale}}
    hover = {"customdata": _short(radius), "hovertemplate": RADIUS}
    return go.Scatter3d(
        **dict(zip("xyz", _short(points).T, strict=True)), **style, **hover, name="curve", visible=visible
    )


def _slider(prefix: str, labels: list[str], first: int, width: int, at: float, skip: int) -> dict[str, Any]:
    """A slider that shows ``width`` traces for each label, from ``first`` on; none for the first ``skip`` labels."""
    num = (len(labels) - skip) * width
    traces = list(range(first, first + num))
    steps = []
    for number, label in enumerate(labels):
        shown = [trace // width == number - skip for trace in range(num)]
        steps.append({"method": "restyle", "label": label, "args": [{"visible": shown}, traces]})
    return {"active": 0, "currentvalue": {"prefix": prefix}, "x": at, "len": 0.45, "pad": {"t": 10}, "steps": steps}


def _menu(num_surfaces: int, by_node: bool) -> dict[str, Any]:
    names = ["surface", "surface by node", "no surface"] if by_node else ["surface", "no surface"]
    buttons = []
    for number, name in enumerate(names):
        shown = [number == k for k in range(num_surfaces)]
        buttons.append({"method": "restyle", "label": name, "args": [{"visible": shown}, list(range(num_surfaces))]})
    return {"buttons": buttons, "x": 0.0, "xanchor": "left", "y": 1.0}
