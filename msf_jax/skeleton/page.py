"""A self-contained interactive page of surface, curve and iterations, drawn by plotly."""

import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy import spatial

from msf_jax.base.errors import ConfigError
from msf_jax.base.writing import write_whole
from msf_jax.meshes import reading
from msf_jax.meshes.reading import MeshLike
from msf_jax.view import ABOVE, looking

if TYPE_CHECKING:
    from plotly.graph_objects import Figure

    from msf_jax.skeleton.skeleton import Skeleton

GREY = "#8c9eb8"  # colour of the surface
RADIUS = "radius %{customdata:.4g}<extra></extra>"  # plotly's template of the text at the pointer
AWAY = 1.4  # diagonals: at 1.31, a ball with the box's diagonal fills plotly's angle of view of 45 degrees
LEAST_EXTENT = 0.01  # least ratio of the scene's extents: the box of a line or a point would be empty


def view(skeleton: "Skeleton", mesh: "MeshLike | None" = None, path: str | os.PathLike[str] | None = None) -> "Figure":
    """See `Skeleton.view`."""
    import plotly.graph_objects as go

    if path is not None and Path(path).suffix.lower() != ".html":
        raise ConfigError(f"a page is written as .html, not as {Path(path).suffix!r}")
    middle = (skeleton.vertices.min(axis=0) + skeleton.vertices.max(axis=0)) / 2  # float32 is precise enough around it
    traces = _surfaces(skeleton, mesh, middle)
    box = np.concatenate([skeleton.vertices - middle, *(np.stack([one.x, one.y, one.z], axis=1) for one in traces[:1])])
    stages, first = skeleton.source.stages if skeleton.source else (), len(traces)
    for stage in stages:
        name = f"after {stage.iteration} iterations"
        style = {"opacity": 0.9, "color": "#5b8c5a", "visible": False, "hoverinfo": "skip"}
        traces.append(_mesh(stage.vertices - middle, stage.faces, name, **style))
    traces.append(_line(skeleton, middle))
    shown = list(range(first, first + len(stages)))
    steps = [
        {"method": "restyle", "label": label, "args": [{"visible": [trace == first + k for trace in shown]}, shown]}
        for k, label in enumerate(["none", *(f"{stage.iteration}" for stage in stages)], -1)
    ]
    slider = {"currentvalue": {"prefix": "contraction: "}, "x": 0.02, "len": 0.9, "pad": {"t": 10}, "steps": steps}
    drawing = go.Figure(traces)
    drawing.update_layout(
        template="plotly_white",
        margin={"l": 0, "r": 0, "t": 40, "b": 90},
        title={"text": f"{skeleton!r}; {skeleton.report.reason}", "font": {"size": 14}},
        legend={"x": 0, "y": 1},
        scene=_scene(box[np.isfinite(box).all(axis=1)]),
        sliders=[slider],
    )
    if path is not None:
        write_whole(path, drawing.to_html(include_plotlyjs=True))
    return drawing


def _surfaces(skeleton: "Skeleton", mesh: "MeshLike | None", middle: np.ndarray) -> list[Any]:
    """The mesh in grey, if it is known. The legend shows and hides it."""
    if mesh is not None:
        vertices, faces = reading.read(mesh)
        if len(skeleton.mesh_map):
            reading.check_map(skeleton.mesh_map, len(vertices))
    elif skeleton.source is not None:
        vertices, faces = skeleton.source.solid.vertices, skeleton.source.solid.shape.faces
    else:
        return []
    has_map = mesh is not None and len(skeleton.mesh_map) > 0  # a curve of another program has none
    node = skeleton.mesh_map if has_map else np.asarray(spatial.KDTree(skeleton.vertices).query(vertices)[1])
    # The pointer meets the surface before the curve, so the surface shows the radius, too.
    style = {"customdata": skeleton.radii[node].astype(np.float32), "hovertemplate": RADIUS, "showlegend": True}
    return [_mesh(vertices - middle, faces, "surface", opacity=0.18, color=GREY, **style)]


def _mesh(vertices: np.ndarray, faces: np.ndarray, name: str, **style: Any) -> Any:
    import plotly.graph_objects as go

    corners = dict(zip("ijk", np.asarray(faces, dtype=np.int32).T, strict=True))
    return go.Mesh3d(**dict(zip("xyz", vertices.astype(np.float32).T, strict=True)), **corners, name=name, **style)


def _scene(box: np.ndarray) -> dict[str, Any]:
    """Axes and camera such that ``box`` (n, 3) is in view, and stays in place when parts are hidden. Plotly's unit of
    length is the diagonal of the scene's box."""
    middle, half = (box.max(axis=0) + box.min(axis=0)) / 2, np.ptp(box, axis=0) / 2
    half = np.maximum(half, LEAST_EXTENT * (float(half.max()) or 1.0))
    upright, around = looking(box)
    above, around = np.radians([ABOVE, around])
    eye = AWAY * np.array([np.cos(above) * np.cos(around), np.cos(above) * np.sin(around), np.sin(above)])
    of_axes = 2 * half / np.linalg.norm(2 * half), np.roll(eye, upright - 2), np.eye(3)[upright]
    ratio, eye, up = (dict(zip("xyz", values.tolist(), strict=True)) for values in of_axes)
    axes = {
        f"{axis}axis": {"visible": False, "range": [a, b]}
        for axis, a, b in zip("xyz", (middle - half).tolist(), (middle + half).tolist(), strict=True)
    }
    return {"aspectmode": "manual", "aspectratio": ratio, "camera": {"eye": eye, "up": up}, **axes}


def _line(curve: "Skeleton", middle: np.ndarray) -> Any:
    """Every edge as a line, coloured by radius, with a gap after it; a curve without edges as dots."""
    import plotly.graph_objects as go

    bar = {"title": "radius", "len": 0.5, "thickness": 14, "x": 1, "xanchor": "right"}
    colour: dict[str, Any] = {"colorscale": "Plasma", "colorbar": bar}
    points, radius = (curve.vertices - middle).astype(np.float32), curve.radii.astype(np.float32)
    if len(curve.edges):
        points = np.pad(points[curve.edges], ((0, 0), (0, 1), (0, 0)), constant_values=np.nan).reshape(-1, 3)
        radius = np.repeat(radius[curve.edges], [1, 2], axis=1).ravel()  # the gap has one, too
        style = {"mode": "lines", "line": {"color": radius, "width": 6, **colour}}
    else:
        style = {"mode": "markers", "marker": {"color": radius, "size": 6, **colour}}
    style |= {"customdata": radius, "hovertemplate": RADIUS, "name": "curve", "showlegend": False}
    return go.Scatter3d(**dict(zip("xyz", points.T, strict=True)), **style)
