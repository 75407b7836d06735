"""Pictures of surfaces, points and curves, by matplotlib, one or several side by side; and the camera's place."""

import io
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from msf_jax.base.errors import ConfigError
from msf_jax.meshes import reading
from msf_jax.meshes.reading import MeshLike

if TYPE_CHECKING:
    from matplotlib.figure import Figure

GREY_BLUE = (0.55, 0.62, 0.72)  # colour of surfaces: red, green, blue from 0 to 1
HALF_WIDTH = 0.47  # half width of the drawing, as a share of the axes
EVEN = (1.02, 1.0, 1.01)  # factors of the extents on x, y, z, so that of equal ones y is the least, then z
STANDS = 1.5  # ratio of height to width above which a shape stands; people have 2 to 4, animals less than 1
ABOVE = 8.0  # degrees: elevation of the camera
# Of the camera, in degrees, by the upright axis and the axis it looks along: 18 aside, because from the front one half
# of a shape can hide the other. CAD looks along y if z is up, games look along -z if y is up.
AZIMUTH = {(2, 1): -72.0, (2, 0): 18.0, (1, 2): 18.0, (1, 0): 108.0}


@dataclass(frozen=True, eq=False)
class Panel:
    """The content of one picture of `panels`; all parts are optional.

    Attributes:
        title: above the picture.
        mesh: a surface, as `skeletonize` takes it; it need not be a closed manifold.
        curves: by name, each a `Skeleton` or its ``vertices``, ``edges`` and ``radii``. A single curve is coloured by
            radius; several have one colour each, and a legend.
        points: (N, 3), drawn as dots.
        is_solid: whether the surface is opaque and shaded; else it is translucent.
        face_colours: (F, 3) colours of an opaque surface's faces, from 0 to 1.
    """

    title: str = ""
    mesh: "MeshLike | None" = None
    curves: Mapping[str, Any] = field(default_factory=dict)
    points: np.ndarray | None = None
    is_solid: bool = False
    face_colours: np.ndarray | None = None


def looking(points: np.ndarray) -> tuple[int, float]:
    """The upright axis of ``points`` (N, 3), 1 for y or 2 for z, and the azimuth around it of the camera, which looks
    about along the axis of the least extent. If that is z, y is up; if it is y, z. If it is x, the longer of both is up
    for a slender shape, such as a person, else the shorter, as for a horse."""
    extent = np.ptp(points, axis=0)
    along = int((extent * EVEN).argmin())
    _, y, z = extent
    stands = max(y, z) > STANDS * min(y, z)
    upright = (2 if (z > y) == stands else 1, 2, 1)[along]
    return upright, AZIMUTH[upright, along]


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
        elevation, azimuth: of the camera, in degrees, with z upright. If neither is given, see `looking`.

    Raises:
        ConfigError: there is nothing to show.
    """
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Normalize
    from matplotlib.figure import Figure

    surfaces = [None if panel.mesh is None else reading.read(panel.mesh) for panel in shown]
    points = [mesh[0] for mesh in surfaces if mesh is not None]
    points += [panel.points for panel in shown if panel.points is not None]
    points += [curve.vertices for panel in shown for curve in panel.curves.values()]
    if not points or columns < 1:
        raise ConfigError(f"{len(points)} things in {columns} columns: expected meshes, curves or points, and a column")
    box, columns = np.concatenate(points), min(columns, len(shown))
    upright, around = looking(box) if elevation is None and azimuth is None else (2, AZIMUTH[2, 1])
    radii = [curve.radii for panel in shown if len(panel.curves) == 1 for curve in panel.curves.values()]
    colours = ScalarMappable(Normalize(0, max((float(part.max()) for part in radii), default=1.0)), cmap="plasma")
    rows = -(-len(shown) // columns)
    drawing = Figure(figsize=(size * columns, size * rows), layout="constrained")
    every = []
    for number, (panel, surface) in enumerate(zip(shown, surfaces, strict=True)):
        axes: Any = drawing.add_subplot(rows, columns, number + 1, projection="3d", computed_zorder=False)
        every.append(axes)
        _draw(axes, panel, surface, colours)
        angles = ABOVE if elevation is None else elevation, around if azimuth is None else azimuth
        axes.view_init(*angles, vertical_axis="xyz"[upright])
        _frame(axes, box)
    if radii:
        drawing.colorbar(colours, ax=every, shrink=0.5 if rows == 1 else 0.3, label="radius")
    return drawing


def _draw(axes: Any, panel: Panel, surface: tuple[np.ndarray, np.ndarray] | None, colours: Any) -> None:
    from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection

    axes.set_title(panel.title, fontsize=10)
    if surface is not None:
        opaque: Any = GREY_BLUE if panel.face_colours is None else panel.face_colours
        style: Any = {"facecolors": opaque, "shade": True} if panel.is_solid else {"facecolors": (*GREY_BLUE, 0.10)}
        axes.add_collection3d(Poly3DCollection(surface[0][surface[1]], zorder=1, **style))
    if panel.points is not None:
        axes.scatter(*panel.points.T, s=2, color="tab:red", linewidths=0, zorder=2)
    is_one = len(panel.curves) == 1
    for number, (name, curve) in enumerate(panel.curves.items()):
        style = {"zorder": 3, "label": name}
        if len(curve.edges):
            colour = colours.to_rgba(curve.radii[curve.edges].mean(axis=1)) if is_one else f"C{number}"
            width = 2.5 if is_one else 1.8
            segments: Any = curve.vertices[curve.edges]
            axes.add_collection3d(Line3DCollection(segments, linewidths=width, colors=colour, **style))
        else:
            axes.scatter(*curve.vertices.T, color=colours.to_rgba(curve.radii) if is_one else f"C{number}", **style)
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


def picture(skeleton: Any, mesh: "MeshLike | None" = None) -> bytes:
    """`Skeleton.plot` as the bytes of a PNG file."""
    buffer = io.BytesIO()
    skeleton.plot(mesh).savefig(buffer, format="png", dpi=150)
    return buffer.getvalue()
