"""`track`: one curve through a sequence of meshes with the same faces; the same nodes in each, and its validity.

It evaluates `follow` for each frame. The recorded cross-sections can look right although a limb has entered another
one, or a new limb has grown. So a frame is checked against its whole moved surface: the curve is inside, its radii are
the recorded ones, the surface does not cross itself, and the loops go around its handles. Lengths are compared relative
to the growth of the mesh, and a change counts only if it also shows under the affine map that fits the moved mesh best:
stretching the whole mesh is no fault.
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
from msf_jax.skeleton.report import loops_of
from msf_jax.skeleton.skeleton import Skeleton
from msf_jax.solid.crossings import apart_pairs
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.solid import Solid

# Chosen on three shapes (a capsule, a hand, three limbs), and tested on others.
INSIDE = 0.99  # share of the curve's length that must be inside
PINCHED = 0.5  # ratio of a node's radius to the recorded one, below which its ball has shrunk
GROWN = 1.0  # radii: growth of a vertex's distance from its node that counts as a new limb
WIDE = 0.25  # share of the recorded distance that the growth must exceed in addition; the distance is large in sheets
SLIGHT = 0.005  # diagonals: radii count as at least this, because noise dominates shorter lengths
PINNED = 1e-6  # diagonals: nodes this near to the recorded surface were pinned to it, and are not checked
FAULTS = {  # attributes of a `TrackedFrame` that are faults if they are not 0 or empty, and what they count
    "vanished": "nodes without a section",
    "overlaps": "nodes around which the surface winds once more",
    "changed": "nodes whose distance from the surface has changed",
    "crossings": "pairs of faces in which the surface crosses itself",
    "loops": "loops that go around no handle of their own any more",
}


@dataclass(frozen=True, eq=False)
class TrackedFrame:
    """The curve in one mesh of a sequence.

    Attributes:
        number: of the frame, from 0.
        nodes: (N, 3), in the mesh's units; NaN for ``vanished`` nodes.
        radii: (N,) exact distance to the whole surface of the frame, negative for a node outside; NaN for ``vanished``.
        inside: fraction of the curve's length inside. NaN if nodes have ``vanished``: then nothing else is checked.
        vanished: (k,) nodes whose cross-section no longer exists.
        overlaps: (k,) nodes whose winding number is above 1, and higher than in the mesh of the run.
        changed: (k,) nodes whose ball has shrunk by more than half, or of which a vertex has moved away by more than a
            radius: a limb has grown there, or was crushed.
        crossings: number of pairs of faces that cross although they are far apart along the surface.
        loops: number of loops that go around no handle of their own any more; as ``crossings``, 0 if the mesh of the
            run crossed itself.
    """

    number: int
    nodes: np.ndarray
    radii: np.ndarray
    inside: float
    vanished: np.ndarray
    overlaps: np.ndarray
    changed: np.ndarray
    crossings: int
    loops: int

    @property
    def wants_run(self) -> bool:
        """Whether the curve is no longer valid, so that this frame needs `msf_jax.skeletonize`, if it is a solid."""
        return bool(self.faults) or not self.inside >= INSIDE

    @property
    def faults(self) -> dict[str, int]:
        """The faults by the names of their attributes: the number of nodes, pairs of faces, or loops."""
        found = {name: getattr(self, name) for name in FAULTS}
        counts = {name: len(some) if isinstance(some, np.ndarray) else some for name, some in found.items()}
        return {name: count for name, count in counts.items() if count}

    def __repr__(self) -> str:
        inside = "not checked further" if len(self.vanished) else f"{100 * self.inside:.2f} % inside"
        parts = [f"frame {self.number}: {inside}"]
        for name, count in self.faults.items():
            found = getattr(self, name)
            first = f", the first {found[0]}" if isinstance(found, np.ndarray) else ""
            parts.append(f"{FAULTS[name]}: {count}{first}")
        return "; ".join(parts) + ("; needs a fresh run" if self.wants_run else "")


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
        """The curve of frame ``number``, to save or draw. It has no source mesh; its report is that of the run.

        Raises:
            ConfigError: nodes of that frame have vanished, or there is no such frame.
        """
        if not -len(self.frames) <= number < len(self.frames):
            raise ConfigError(f"no frame {number}: expected one of the {len(self.frames)}, counted from 0")
        frame, skeleton = self.frames[number], self.skeleton
        if len(frame.vanished):
            raise ConfigError(f"frame {frame.number} has no curve, {frame}")
        note = f"followed from another mesh, not run: {frame}"
        report = replace(skeleton.report, inside=frame.inside, figures={}, notes=(*skeleton.report.notes, note))
        return replace(skeleton, vertices=frame.nodes, radii=np.maximum(frame.radii, 0), report=report, source=None)

    def __repr__(self) -> str:
        wanting = [frame for frame in self.frames if frame.wants_run]
        lines = [f"{len(self.frames)} frames, {len(wanting)} of them need a fresh run"]
        return "\n".join(lines + [str(frame) for frame in wanting])


def track(skeleton: Skeleton, frames: Iterable[Any], *, progress: bool = False) -> Track:
    """The ``skeleton`` in every mesh of a sequence: an animation, a 4-D scan, an ensemble. It makes no run.

    Args:
        skeleton: of a mesh with the same faces as all ``frames``, usually the first; as `msf_jax.follow` takes it.
        frames: at least one; each (V, 3) vertices, or a mesh as `msf_jax.skeletonize` takes it: a path, an object with
            vertices and faces, a pair of them.
        progress: show a progress bar on standard error, if that is a terminal.

    Returns:
        Nodes and radii for each frame, with the same ids in all. ``wants_run`` is True for a frame that is bent,
        flattened or torn too far, in which limbs intersect, or in which a limb has grown. See `TrackedFrame`.

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
    """Follows a skeleton frame by frame. It holds the data that all frames share, and raises as `track` does."""

    def __init__(self, skeleton: Skeleton):
        binding, surface = binding_of(skeleton), skeleton.bound_surface
        self.skeleton, self.edges, self.node = skeleton, skeleton.edges, surface.node
        self.binding, self.solid, self.vertex = jax.device_put(binding), surface.solid, surface.vertex
        # Repair changes faces, so the caller's faces of a repaired mesh are not compared.
        self.faces = None if skeleton.report.repairs else _sorted(self.vertex[self.solid.shape.faces])
        shape, x = self.solid.shape, self.solid.enter(skeleton.vertices)
        self.recorded = _measured(shape, x, self.node)
        self.most, self.is_free = np.maximum(shape.winding_numbers(x), 1), self.recorded[0] > PINNED
        self.is_embedded = not self._crossings(shape, x)
        self.loops = self._loops(shape, x)

    def frame(self, number: int, given: Any) -> TrackedFrame:
        """The curve in the mesh ``given``, with its checks."""
        try:
            array = checked_vertices(self.skeleton, self._vertices_of(given))
        except MeshError as error:
            raise MeshError(f"frame {number}: {error}") from error
        nodes, radii = (part[: len(self.most)].astype(float) for part in evaluated(self.binding, array))
        moved, none = np.asarray(array, dtype=np.float64)[self.vertex], np.zeros(0, dtype=np.int64)
        vanished = np.flatnonzero(np.isnan(nodes).any(axis=1)) if np.ptp(moved, axis=0).any() else np.arange(len(nodes))
        if len(vanished):
            return TrackedFrame(number, nodes, radii, np.nan, vanished, none, none, 0, 0)
        solid = Solid(moved, self.solid.shape.faces)
        shape, x = solid.shape, solid.enter(nodes)
        now, winding = _measured(shape, x, self.node), shape.winding_numbers(x)
        scale = float(np.median(shape.reaches / np.maximum(self.solid.shape.reaches, 1e-300)))
        changed = self._changed(now, tuple(scale * lengths for lengths in self.recorded))
        if changed.any() and (stretched := self._stretched(shape)) is not None:
            changed &= self._changed(now, stretched)
        return TrackedFrame(
            number,
            nodes,
            np.where(winding > 0, 1.0, -1.0) * solid.diagonal * now[0],
            inside_fraction(shape, x, self.edges, np.where(winding > 0, now[0], 0.0)),
            vanished,
            overlaps=np.flatnonzero(self.is_free & (winding > self.most)),
            changed=np.flatnonzero(changed),
            crossings=self._crossings(shape, x) if self.is_embedded else 0,
            loops=max(self.loops - self._loops(shape, x), 0) if self.is_embedded else 0,
        )

    def _changed(self, now: tuple[np.ndarray, ...], was: tuple[np.ndarray, ...]) -> np.ndarray:
        """(N,) nodes whose ball has shrunk, or of which a vertex has moved away, by `_measured` lengths."""
        changed = now[0] < PINCHED * (was[0] - SLIGHT)
        thick = np.maximum(np.maximum(was[0], now[0]), SLIGHT)[self.node]
        is_away = now[1] - was[1] > GROWN * thick + WIDE * was[1]
        changed[self.node[is_away]] = True
        return changed & self.is_free

    def _stretched(self, shape: Enclosure) -> tuple[np.ndarray, ...] | None:
        """What is measured under the affine map that best fits the moved mesh; None if that reflects."""
        before, after = self.solid.shape.vertices, shape.vertices
        mean, away = before.mean(axis=0), after.mean(axis=0)
        matrix = np.linalg.lstsq(before - mean, after - away, rcond=None)[0]
        if np.linalg.det(matrix) <= 0:
            return None
        x = (self.solid.enter(self.skeleton.vertices) - mean) @ matrix + away
        return _measured(Enclosure((before - mean) @ matrix + away, shape.faces), x, self.node)

    def _crossings(self, shape: Enclosure, x: np.ndarray) -> int:
        length = np.linalg.norm(x[self.edges[:, 0]] - x[self.edges[:, 1]], axis=1)
        return len(apart_pairs(shape, self.node, np.maximum(shape.distances(x), SLIGHT), self.edges, length))

    def _loops(self, shape: Enclosure, x: np.ndarray) -> int:
        """How many handles the curve's loops go around; 0 if they are too many to tell."""
        return loops_of(shape, x, self.edges, self.node)["loops"] or 0

    def _vertices_of(self, given: Any) -> Any:
        if isinstance(given, np.ndarray | jax.Array) or (isinstance(given, list | tuple) and len(given) != 2):
            return given
        vertices, faces = reading.read(given)
        if self.faces is not None and not np.array_equal(_sorted(faces), self.faces):
            raise MeshError(f"its {len(faces)} faces are not those of the mesh that the skeleton was made from")
        return vertices


def _measured(shape: Enclosure, x: np.ndarray, node: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The exact radii (N,) of nodes at ``x`` (N, 3), and the distance (V,) of each vertex from its own node."""
    return shape.distances(x), np.linalg.norm(shape.vertices - x[node], axis=1)


def _sorted(faces: np.ndarray) -> np.ndarray:
    """Faces in an order that does not depend on their first corner, their orientation or their order."""
    return np.unique(np.sort(faces, axis=1), axis=0)
