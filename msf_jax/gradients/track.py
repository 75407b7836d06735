"""`track`: one curve through a sequence of meshes with the same faces; the same nodes in each, and its validity.

The recorded cross-sections can look right although a limb has entered another one, or a new limb has grown. So a frame
is checked against its whole moved surface. A fold inside a bend, or limbs that touch, are no faults.
"""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Any

import jax
import numpy as np
from tqdm import tqdm

from msf_jax.base.errors import ConfigError, MeshError
from msf_jax.gradients.follow import binding_of, checked_vertices, evaluated
from msf_jax.meshes import reading
from msf_jax.metrics import inside_fraction
from msf_jax.skeleton.skeleton import Skeleton
from msf_jax.solid.geometry import ROUNDING, triangle_areas
from msf_jax.solid.solid import Solid

# Chosen on three bent bodies, and tested on others. Ratios are to what was recorded, and to the mesh's growth.
MOST_LOST = 0.01  # share of the curve's length, or of the surface's area, that may be lost
NEAR = 0.3  # of a node's radius, below which walls are too near
FAR = 2.0  # of a vertex's distance from its node, above which a limb has grown there


@dataclass(frozen=True, eq=False)
class TrackedFrame:
    """The curve in one mesh of a sequence.

    Attributes:
        number: of the frame, from 0.
        nodes: (N, 3), in the mesh's units; NaN for ``vanished`` nodes.
        radii: (N,) exact distance to the whole surface of the frame, negative for a node outside; NaN for ``vanished``.
        vanished: (k,) nodes whose cross-section no longer exists. If there are any, the shares are NaN.
        inside: share of the curve's length that is inside.
        crowded: share of the recorded length that has become too narrow, with less than 0.3 of its radius, or is in
            another part, too, with a winding number above 1, and higher than in the run.
        grown: share of the surface's area that is more than twice as far from its nodes as in the run. Both are
            relative to the growth of the whole mesh.
    """

    number: int
    nodes: np.ndarray
    radii: np.ndarray
    vanished: np.ndarray
    inside: float = np.nan
    crowded: float = np.nan
    grown: float = np.nan

    @property
    def wants_run(self) -> bool:
        """Whether the frame needs `msf_jax.skeletonize`: nodes have ``vanished``, or over 1 % of the curve is not
        ``inside``, or ``crowded``, or of the surface ``grown``."""
        return bool(len(self.vanished)) or max(1 - self.inside, self.crowded, self.grown) > MOST_LOST

    def __repr__(self) -> str:
        about = f"curve {self.inside:.2%} inside, {self.crowded:.2%} crowded; surface {self.grown:.2%} grown"
        if len(self.vanished):
            about = f"{len(self.vanished)} nodes without a section, the first {self.vanished[0]}"
        return f"frame {self.number}: {about}{'; needs a fresh run' if self.wants_run else ''}"


@dataclass(frozen=True, eq=False)
class Track:
    """A curve through a sequence of meshes, with the nodes and edges of ``skeleton`` in each of ``frames``."""

    skeleton: Skeleton
    frames: tuple[TrackedFrame, ...]

    @property
    def nodes(self) -> np.ndarray:
        """(T, N, 3), for all T frames."""
        return np.stack([frame.nodes for frame in self.frames])

    @property
    def radii(self) -> np.ndarray:
        """(T, N), as `TrackedFrame.radii`."""
        return np.stack([frame.radii for frame in self.frames])

    def curve(self, number: int) -> Skeleton:
        """The curve of frame ``number``, to save or draw. It has no source mesh; its report is that of the run. A
        `ConfigError` is raised if nodes have vanished, or there is no such frame."""
        if not -len(self.frames) <= number < len(self.frames):
            raise ConfigError(f"no frame {number}: expected one of the {len(self.frames)}, counted from 0")
        frame, skeleton = self.frames[number], self.skeleton
        if len(frame.vanished):
            raise ConfigError(f"frame {frame.number} has no curve, {frame}")
        note = f"followed from another mesh, not run: {frame}"
        report = replace(skeleton.report, inside=frame.inside, figures={}, notes=(*skeleton.report.notes, note))
        return replace(skeleton, vertices=frame.nodes, radii=np.maximum(frame.radii, 0), report=report, source=None)

    def __repr__(self) -> str:
        lines = [str(frame) for frame in self.frames if frame.wants_run]
        return "\n".join([f"{len(self.frames)} frames, {len(lines)} of them need a fresh run", *lines])


def track(skeleton: Skeleton, frames: Iterable[Any], *, progress: bool = False) -> Track:
    """The ``skeleton`` in every mesh of a sequence: an animation, a 4-D scan, an ensemble. It makes no run.

    Args:
        skeleton: of a mesh with the same faces as all ``frames``; as `msf_jax.follow` takes it.
        frames: at least one; each (V, 3) vertices, or a mesh as `msf_jax.skeletonize` takes it.
        progress: show a progress bar on standard error, if that is a terminal.

    Returns:
        Nodes and radii for each frame, with the same ids in all; see `TrackedFrame`.

    Raises:
        ConfigError: ``skeleton`` has no source mesh, or ``frames`` is no sequence.
        MeshError: a frame, which the message names, cannot be read, has other vertices or faces, or is not finite.
    """
    if not isinstance(frames, Iterable) or isinstance(frames, str):
        raise ConfigError(f"frames is a {type(frames).__name__}: expected a sequence of vertices (V, 3) or of meshes")
    tracker = Tracker(skeleton)
    each = tqdm(frames, desc="track", unit="frame", disable=None if progress else True)
    found = tuple(tracker.frame(number, given) for number, given in enumerate(each))
    if not found:
        raise ConfigError("frames is empty: expected at least one mesh")
    return Track(skeleton, found)


class Tracker:
    """Follows a skeleton frame by frame, with what all frames share. It raises as `track` does."""

    def __init__(self, skeleton: Skeleton):
        binding, surface = binding_of(skeleton), skeleton.bound_surface
        self.skeleton, self.edges, self.node = skeleton, skeleton.edges, surface.node
        self.binding, self.solid, self.vertex = jax.device_put(binding), surface.solid, surface.vertex
        # Repair changes faces, so the caller's faces of a repaired mesh are not compared.
        self.faces = None if skeleton.report.repairs else _sorted(self.vertex[self.solid.shape.faces])
        shape, x = self.solid.shape, self.solid.enter(skeleton.vertices)
        self.radii, self.away = shape.distances(x), np.linalg.norm(shape.vertices - x[self.node], axis=1)
        length = np.linalg.norm(x[self.edges[:, 0]] - x[self.edges[:, 1]], axis=1)
        self.share = length / max(length.sum(), 1e-300)
        self.most = np.maximum(shape.winding_numbers(x), 1)

    def frame(self, number: int, given: Any) -> TrackedFrame:
        """The curve in the mesh ``given``, with its checks."""
        try:
            _, array = checked_vertices(self.skeleton, self._vertices_of(given))
        except MeshError as error:
            raise MeshError(f"frame {number}: {error}") from error
        nodes, radii = (part[: len(self.most)].astype(float) for part in evaluated(self.binding, array))
        moved = np.asarray(array, dtype=np.float64)[self.vertex]
        vanished = np.flatnonzero(np.isnan(nodes).any(axis=1)) if np.ptp(moved, axis=0).any() else np.arange(len(nodes))
        if len(vanished):
            return TrackedFrame(number, nodes, radii, vanished)
        solid = Solid(moved, self.solid.shape.faces)
        shape, x = solid.shape, solid.enter(nodes)
        radius, winding = shape.distances(x), shape.winding_numbers(x)
        scale = float(np.median(shape.reaches / np.maximum(self.solid.shape.reaches, 1e-300)))
        # A pin is on the surface: its radius and the distance from its own vertex are rounding.
        is_crowded = (winding > self.most) | (radius < NEAR * scale * self.radii - ROUNDING)
        is_far = np.linalg.norm(shape.vertices - x[self.node], axis=1) > FAR * scale * self.away + ROUNDING
        area = triangle_areas(shape.triangles)
        return TrackedFrame(
            number,
            nodes,
            np.where(winding > 0, 1.0, -1.0) * solid.diagonal * radius,
            vanished,
            inside_fraction(shape, x, self.edges, np.where(winding > 0, radius, 0.0)),
            float(is_crowded[self.edges].mean(axis=1) @ self.share),
            float(is_far[shape.faces].mean(axis=1) @ area / area.sum()),
        )

    def _vertices_of(self, given: Any) -> Any:
        if isinstance(given, np.ndarray | jax.Array) or (isinstance(given, list | tuple) and len(given) != 2):
            return given
        vertices, faces = reading.read(given)
        if self.faces is not None and not np.array_equal(_sorted(faces), self.faces):
            raise MeshError(f"its {len(faces)} faces are not those of the mesh that the skeleton was made from")
        return vertices


def _sorted(faces: np.ndarray) -> np.ndarray:
    """Faces in an order that does not depend on their first corner, their orientation or their order."""
    return np.unique(np.sort(faces, axis=1), axis=0)
