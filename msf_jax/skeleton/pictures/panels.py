"""Pictures of surfaces, points and curves, by matplotlib: one, or several side by side."""

import io
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from msf_jax.base.errors import ConfigError
from msf_jax.meshes import reading
from msf_jax.meshes.reading import MeshLike
from msf_jax.skeleton.pictures import camera

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from msf_jax.skeleton.skeleton import Skeleton

GREY_BLUE = (0.55, 0.62, 0.72)  # colour of surfaces: red, green, blue from 0 to 1
HALF_WIDTH = 0.47  # half width of the drawing, as a share of the axes


@dataclass(frozen=True, eq=False)
class Panel:
    """The content of one picture of `panels`; all parts are optional.

    Attributes:
        title: above the picture.
        mesh: a surface, as `skeletonize` takes it; it need not be a closed manifold.
        curves: by name. A single curve is coloured by radius; several have one colour each, and a legend.
        points: (N, 3), drawn as dots.
        is_solid: whether the surface is opaque and shaded; else it is translucent.
        face_colours: (F, 3) colours of an opaque surface's faces, from 0 to 1.
    """

    title: str = ""
    mesh: "MeshLike | None" = None
    curves: "Mapping[str, Skeleton]" = field(default_factory=dict)
    points: np.ndarray | None = None
    is_solid: bool = False
    face_colours: np.ndarray | None = None


def panels(
    shown: Sequence[Panel],
    *,
    columns: int = 4,
    size: float = 3.2,
    elevation: float | None = None,
    azimuth: float | None = None,
) -> "Figure":
    """A matplotlib figure of pictures side by side, all with the same limits.

    Args:
        shown: one `Panel` for each picture.
        columns: pictures in a row.
        size: of each picture, in inches.
        elevation, azimuth: of the camera, in degrees, with z upright. If only one is given, elevation is 15 or azimuth
            is -70. If neither is given, the camera looks nearly along the shortest principal axis, see
            `camera.looking`.

    Raises:
        ConfigError: there is nothing to show.
    """
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Normalize
    from matplotlib.figure import Figure

    if not shown or columns < 1:
        raise ConfigError(f"{len(shown)} panels in {columns} columns: expected at least one of each")
    columns = min(columns, len(shown))
    rows = -(-len(shown) // columns)
    drawing = Figure(figsize=(size * columns, size * rows), layout="constrained")
    surfaces = [None if panel.mesh is None else reading.read(panel.mesh) for panel in shown]
    points = [mesh[0] for mesh in surfaces if mesh is not None]
    points += [panel.points for panel in shown if panel.points is not None]
    points += [curve.vertices for panel in shown for curve in panel.curves.values()]
    if not points:
        raise ConfigError("no panel shows anything: expected a mesh, a curve or points")
    box = np.concatenate(points)
    roll = 0.0
    if elevation is None and azimuth is None:
        elevation, azimuth, roll = camera.looking(*_together(surfaces, box)).angles()
    radii = [curve.radii for panel in shown if len(panel.curves) == 1 for curve in panel.curves.values()]
    colours = ScalarMappable(Normalize(0, max((float(part.max()) for part in radii), default=1.0)), cmap="plasma")
    every = []
    for k, panel in enumerate(shown):
        axes: Any = drawing.add_subplot(rows, columns, k + 1, projection="3d", computed_zorder=False)
        every.append(axes)
        _draw(axes, panel, surfaces[k], colours)
        axes.view_init(15.0 if elevation is None else elevation, -70.0 if azimuth is None else azimuth, roll)
        _frame(axes, box)
    if radii:
        drawing.colorbar(colours, ax=every, shrink=0.5 if rows == 1 else 0.3, label="radius")
    return drawing


def _together(surfaces: list[tuple[np.ndarray, np.ndarray] | None], box: np.ndarray) -> tuple[np.ndarray, Any]:
    """All surfaces as one, or all points if there is no surface."""
    found = [surface for surface in surfaces if surface is not None]
    if not found:
        return box, None
    first = np.cumsum([0] + [len(vertices) for vertices, _ in found])
    faces = [part + start for (_, part), start in zip(found, first, strict=False)]
    return np.concatenate([vertices for vertices, _ in found]), np.concatenate(faces)


def _draw(axes: Any, panel: Panel, mesh: tuple[np.ndarray, np.ndarray] | None, colours: Any) -> None:
    from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection

    axes.set_title(panel.title, fontsize=10)
    if mesh is not None:
        triangles = mesh[0][mesh[1]]
        if panel.is_solid:
            colour: Any = GREY_BLUE if panel.face_colours is None else panel.face_colours
            axes.add_collection3d(Poly3DCollection(triangles, facecolors=colour, shade=True, zorder=1))
        else:
            axes.add_collection3d(Poly3DCollection(triangles, facecolor=(*GREY_BLUE, 0.10), zorder=1))
    if panel.points is not None:
        axes.scatter(*panel.points.T, s=2, color="tab:red", linewidths=0, zorder=2)
    one = len(panel.curves) == 1
    for number, (name, curve) in enumerate(panel.curves.items()):
        if len(curve.edges):
            lines: Any = Line3DCollection(
                curve.vertices[curve.edges], linewidths=2.5 if one else 1.8, zorder=3, label=name
            )
            if one:
                lines.set_color(colours.to_rgba(curve.radii[curve.edges].mean(axis=1)))
            else:
                lines.set_color(f"C{number}")
            axes.add_collection3d(lines)
        else:
            colour = colours.to_rgba(curve.radii) if one else f"C{number}"
            axes.scatter(*curve.vertices.T, color=colour, zorder=3, label=name)
    if len(panel.curves) > 1:
        axes.legend(fontsize=8, loc="lower left")


def _frame(axes: Any, points: np.ndarray) -> None:
    """Set limits around the points, and zoom in until they fill the view."""
    from mpl_toolkits.mplot3d import proj3d

    low, high = points.min(axis=0), points.max(axis=0)
    middle, half = (low + high) / 2, (high - low) / 2
    half = np.maximum(half, 1e-3 * max(float(half.max()), 1e-9))  # the box of a line or a point would be empty
    axes.set(**dict(zip(("xlim", "ylim", "zlim"), np.stack([middle - half, middle + half], axis=1), strict=True)))
    axes.set_axis_off()
    zoom = 1.0
    for _ in range(3):  # the perspective changes a little with the zoom
        axes.set_box_aspect(half, zoom=zoom)
        x, y, _ = proj3d.proj_transform(points[:, 0], points[:, 1], points[:, 2], axes.get_proj())
        zoom *= HALF_WIDTH / max(float(np.abs(axes.transLimits.transform(np.stack([x, y], axis=1)) - 0.5).max()), 0.01)
    axes.set_box_aspect(half, zoom=zoom)


def figure(
    skeleton: "Skeleton",
    mesh: "MeshLike | None" = None,
    *,
    elevation: float | None = None,
    azimuth: float | None = None,
) -> "Figure":
    """A matplotlib figure: the mesh translucent, the curve coloured by radius.

    Args:
        skeleton: the curve.
        mesh: the mesh that it was made from, as `skeletonize` takes it; if not given, only the curve is drawn.
        elevation, azimuth: of the camera; see `panels`.
    """
    return panels([Panel(mesh=mesh, curves={"": skeleton})], size=8, elevation=elevation, azimuth=azimuth)


def picture(
    skeleton: "Skeleton",
    mesh: "MeshLike | None" = None,
    *,
    elevation: float | None = None,
    azimuth: float | None = None,
) -> bytes:
    """`figure` as the bytes of a PNG file."""
    buffer = io.BytesIO()
    figure(skeleton, mesh, elevation=elevation, azimuth=azimuth).savefig(buffer, format="png", dpi=150)
    return buffer.getvalue()
