"""A self-contained interactive page of surface, curve and iterations, drawn by plotly."""

import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import plotly.graph_objects as go
from scipy import spatial

from msf_jax.base.errors import ConfigError
from msf_jax.base.writing import write_whole
from msf_jax.meshes import reading
from msf_jax.view import ABOVE, looking

if TYPE_CHECKING:
    from msf_jax.skeleton.skeleton import Skeleton

GREY, GREEN = "#8c9eb8", "#5b8c5a"  # colours of the surface, and of the contraction
RADIUS = "radius %{customdata:.4g}<extra></extra>"  # plotly's template of the text at the pointer


def view(skeleton: "Skeleton", mesh: "reading.MeshLike | None", path: str | os.PathLike[str] | None) -> go.Figure:
    """See `Skeleton.view`."""
    if path is not None and Path(path).suffix.lower() != ".html":
        raise ConfigError(f"a page is written as .html, not as {Path(path).suffix!r}")
    middle = (skeleton.vertices.min(axis=0) + skeleton.vertices.max(axis=0)) / 2  # float32 is precise enough around it
    box, traces = skeleton.vertices - middle, []
    if mesh is not None or skeleton.source is not None:
        vertices, faces, node = _surface(skeleton, mesh)
        # The pointer meets the surface before the curve, so the surface shows the radius, too.
        style = {"customdata": skeleton.radii[node].astype(np.float32), "hovertemplate": RADIUS, "showlegend": True}
        traces.append(_mesh(vertices - middle, faces, "surface", opacity=0.18, color=GREY, **style))
        box = np.concatenate([box, vertices - middle])
    stages, first = skeleton.source.stages if skeleton.source else (), len(traces)
    for stage in stages:
        style = {"opacity": 0.9, "color": GREEN, "visible": False, "hoverinfo": "skip"}
        traces.append(_mesh(stage.vertices - middle, stage.faces, f"after {stage.iteration} iterations", **style))
    traces.append(_line(skeleton, middle))
    shown = list(range(first, first + len(stages)))
    steps = [
        {"method": "restyle", "label": label, "args": [{"visible": [trace == first + k for trace in shown]}, shown]}
        for k, label in enumerate(["none", *(f"{stage.iteration}" for stage in stages)], -1)
    ]
    drawing = go.Figure(traces)
    drawing.update_layout(
        template="plotly_white",
        margin={"l": 0, "r": 0, "t": 40, "b": 90},
        title={"text": f"{skeleton!r}; {skeleton.report.reason}", "font": {"size": 14}},
        legend={"x": 0, "y": 1},
        scene=_scene(box[np.isfinite(box).all(axis=1)]),
        sliders=[
            {"currentvalue": {"prefix": "contraction: "}, "x": 0.02, "len": 0.9, "pad": {"t": 10}, "steps": steps}
        ],
    )
    if path is not None:
        write_whole(path, drawing.to_html(include_plotlyjs=True))
    return drawing


def _surface(skeleton: "Skeleton", mesh: "reading.MeshLike | None") -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Vertices and faces of the ``mesh``, or of that which the curve was made from, and the node of each vertex."""
    if mesh is None:
        solid = skeleton.known_source.solid
        vertices, faces = solid.vertices, solid.shape.faces
    else:
        vertices, faces = reading.read(mesh)
        if len(skeleton.mesh_map):  # a curve of another program has none
            reading.check_map(skeleton.mesh_map, len(vertices))
            return vertices, faces, skeleton.mesh_map
    return vertices, faces, np.asarray(spatial.KDTree(skeleton.vertices).query(vertices)[1])


def _mesh(vertices: np.ndarray, faces: np.ndarray, name: str, **style: Any) -> go.Mesh3d:
    corners = dict(zip("ijk", np.asarray(faces, dtype=np.int32).T, strict=True))
    return go.Mesh3d(**dict(zip("xyz", vertices.astype(np.float32).T, strict=True)), **corners, name=name, **style)


def _scene(box: np.ndarray) -> dict[str, Any]:
    """Axes and camera such that ``box`` (n, 3) is in view, and stays in place when parts are hidden. Plotly's unit of
    length is the diagonal of the scene's box."""
    middle, half = (box.max(axis=0) + box.min(axis=0)) / 2, np.ptp(box, axis=0) / 2
    half = np.maximum(half, 0.01 * (float(half.max()) or 1.0))  # the box of a line or a point would be empty
    upright, around = looking(box)
    above, around = np.radians([ABOVE, around])
    # At 1.31 diagonals, a ball with the box's diagonal fills plotly's angle of view of 45 degrees.
    eye = 1.4 * np.array([np.cos(above) * np.cos(around), np.cos(above) * np.sin(around), np.sin(above)])
    of_axes = 2 * half / np.linalg.norm(2 * half), np.roll(eye, upright - 2), np.eye(3)[upright]
    ratio, eye, up = (dict(zip("xyz", values.tolist(), strict=True)) for values in of_axes)
    axes = {
        f"{axis}axis": {"visible": False, "range": [a, b]}
        for axis, a, b in zip("xyz", (middle - half).tolist(), (middle + half).tolist(), strict=True)
    }
    return {"aspectmode": "manual", "aspectratio": ratio, "camera": {"eye": eye, "up": up}, **axes}


def _line(curve: "Skeleton", middle: np.ndarray) -> go.Scatter3d:
    """Every edge as a line, coloured by radius, with a gap after it; a curve without edges as dots."""
    bar = {"title": "radius", "len": 0.5, "thickness": 14, "x": 1, "xanchor": "right"}
    points, radius = (curve.vertices - middle).astype(np.float32), curve.radii.astype(np.float32)
    if len(curve.edges):
        points = np.pad(points[curve.edges], ((0, 0), (0, 1), (0, 0)), constant_values=np.nan).reshape(-1, 3)
        radius = np.repeat(radius[curve.edges], [1, 2], axis=1).ravel()  # the gap has one, too
    kind, width = ("line", "width") if len(curve.edges) else ("marker", "size")
    style: dict[str, Any] = {kind: {"color": radius, width: 6, "colorscale": "Plasma", "colorbar": bar}}
    style |= {"mode": f"{kind}s", "customdata": radius, "hovertemplate": RADIUS, "name": "curve", "showlegend": False}
    return go.Scatter3d(**dict(zip("xyz", points.T, strict=True)), **style)
