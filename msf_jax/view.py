"""Pictures of a curve in its mesh."""

import io
from typing import TYPE_CHECKING, Any

import numpy as np

from msf_jax.host import surface

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from msf_jax.skeleton import Skeleton
    from msf_jax.tuning import Tuned


def figure(skeleton: "Skeleton", mesh: Any = None, *, elevation: float = 15.0, azimuth: float = -70.0) -> "Figure":
    """A matplotlib figure: the mesh translucent, the curve coloured by radius.

    Args:
        skeleton: the curve.
        mesh: what it was made from, as `skeletonize` takes it; the curve alone if not given.
        elevation, azimuth: where it is seen from, in degrees.
    """
    from matplotlib.figure import Figure
    from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection

    drawing = Figure(figsize=(8, 8), layout="constrained")
    axes: Any = drawing.add_subplot(projection="3d", computed_zorder=False)
    shown = [skeleton.vertices]
    if mesh is not None:
        vertices, faces = surface.read(mesh)
        shown.append(vertices)
        axes.add_collection3d(Poly3DCollection(vertices[faces], facecolor=(0.55, 0.62, 0.72, 0.10), zorder=1))
    if len(skeleton.edges):
        lines: Any = Line3DCollection(skeleton.vertices[skeleton.edges], linewidths=2.5, cmap="plasma", zorder=2)
        lines.set_array(skeleton.radii[skeleton.edges].mean(axis=1))
        axes.add_collection3d(lines)
    else:
        lines = axes.scatter(*skeleton.vertices.T, c=skeleton.radii, cmap="plasma", zorder=2)
    points = np.concatenate(shown)
    low, high = points.min(axis=0), points.max(axis=0)
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
    axes.set_box_aspect(np.maximum(high - low, 1e-9 * np.linalg.norm(high - low)))
    axes.view_init(elev=elevation, azim=azimuth)
    axes.set_axis_off()
    drawing.colorbar(lines, ax=axes, shrink=0.5, label="radius")
    return drawing


def picture(skeleton: "Skeleton", mesh: Any = None, *, elevation: float = 15.0, azimuth: float = -70.0) -> bytes:
    """`figure` as the bytes of a PNG file."""
    buffer = io.BytesIO()
    figure(skeleton, mesh, elevation=elevation, azimuth=azimuth).savefig(buffer, format="png", dpi=150)
    return buffer.getvalue()


def trajectory(tuned: "Tuned") -> "Figure":
    """A matplotlib figure of what `tune` did: the objective of every proposal, and the weights that were tried."""
    from matplotlib.figure import Figure
    from matplotlib.ticker import MaxNLocator

    drawing = Figure(figsize=(10, 3.8), layout="constrained")
    left, right = drawing.subplots(1, 2)
    number = np.arange(len(tuned.trajectory))
    found = np.array([step.found for step in tuned.trajectory])
    is_taken = np.array([step.is_taken for step in tuned.trajectory])
    left.plot(number, [step.expected for step in tuned.trajectory], "--", color="0.6", label="expected by the tapes")
    left.plot(number[is_taken], found[is_taken], "o-", label="found by a fresh run, taken")
    left.plot(number[~is_taken], found[~is_taken], "x", color="tab:red", label="found, not taken")
    left.set(xlabel="proposal", ylabel="objective")
    left.legend()
    for name in ("w_L", "w_H", "w_M", "smoothing"):
        values = [
            float(np.exp(np.log(np.maximum(getattr(step.weights, name), 1e-300)).mean())) for step in tuned.trajectory
        ]
        right.semilogy(number, values, ".-", label=name)
    right.set(xlabel="proposal", ylabel="weight")
    right.legend()
    for axes in (left, right):
        axes.xaxis.set_major_locator(MaxNLocator(integer=True))
    return drawing
