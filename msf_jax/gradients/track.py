"""`track`: one curve through a sequence of meshes with the same faces; the same nodes in each, and its validity.

It needs one run, and evaluates `follow` for each frame. It checks that each cross-section still exists, is flat, and
lies across its branch. `holding` checks the curve against the whole moved surface, without using the cross-sections.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from tqdm import tqdm

from msf_jax.base.binding import Binding, unpadded
from msf_jax.base.errors import ConfigError, MeshError
from msf_jax.device import following
from msf_jax.gradients.follow import binding_of, checked_vertices
from msf_jax.gradients.holding import SLIGHT, Holding
from msf_jax.meshes import reading
from msf_jax.skeleton.skeleton import Skeleton
from msf_jax.skeleton.source import bound

WARPED = 0.5  # RMS distance of corners from their plane over that from the centroid: above, a section is warped
TILTED = 0.3  # cosine between a section's normal and its branch: below it, a section lies along its branch,
STRAIGHT = 0.7  # if its cosine in the recorded mesh was above this
INSIDE = 0.99  # share of the curve's length that must be inside, else a frame wants a run
NODES = {  # attributes of a `TrackedFrame` with ids of nodes, and their descriptions
    "vanished": "without a section",
    "loose": "whose section no longer holds",
    "overlaps": "around which the surface winds once more",
    "misjudged": "whose followed radius was wrong",
    "pinched": "whose ball has shrunk by half",
    "strained": "in a stretch of a branch that has become much longer or shorter",
}
# Attributes of a `TrackedFrame` that are faults if they are not 0 or empty.
FAULTS = (*NODES, "overlapped", "crossings", "unexplained")


@dataclass(frozen=True, eq=False)
class TrackedFrame:
    """The curve in one mesh of a sequence.

    Attributes:
        number: of the frame, from 0.
        nodes: (N, 3), in the mesh's units; NaN for ``vanished`` nodes.
        radii: (N,) exact distance to the whole surface of the frame, negative for a node outside; NaN for ``vanished``.
        inside: fraction of the curve's length that is inside; edges at ``vanished`` nodes are left out.
        vanished: (k,) nodes whose cross-section no longer exists.
        loose: (k,) nodes whose cross-section is warped, or lies along its branch.
        overlapped: fraction of the curve's length whose winding number is above 1, and higher than in the mesh of the
            run: another part of the solid has moved there.
        overlaps: (k,) nodes whose winding number is above 1, and higher than in the mesh of the run.
        crossings: number of pairs of faces that cross although they are far apart along the surface. Pairs next to
            faces that crossed in the mesh of the run do not count.
        unexplained: fraction of the surface whose distance from the balls along the curve, or from its own node, has
            grown by more than a radius: a limb has grown there.
        misjudged: (k,) nodes for which the radius of `msf_jax.follow` is wrong by more than a third.
        pinched: (k,) nodes whose ball has shrunk by more than half.
        strained: (k,) nodes in a stretch of a branch that has become longer than 2.5 times, or shorter than 0.4 times,
            its length. Stretches were about a radius long.

    Lengths are compared relative to the growth or the affine stretching of the whole mesh.
    """

    number: int
    nodes: np.ndarray = field(repr=False)
    radii: np.ndarray = field(repr=False)
    inside: float
    vanished: np.ndarray
    loose: np.ndarray
    overlapped: float
    overlaps: np.ndarray
    crossings: int
    unexplained: float
    misjudged: np.ndarray
    pinched: np.ndarray
    strained: np.ndarray

    @property
    def wants_run(self) -> bool:
        """Whether the curve is no longer valid, so that this frame needs `msf_jax.skeletonize`, if it is a solid."""
        return bool(self.faults) or not self.inside >= INSIDE

    @property
    def faults(self) -> dict[str, float]:
        """The faults by the names of their attributes: the number of nodes or pairs of faces, or the fraction."""
        counts = {name: len(getattr(self, name)) if name in NODES else getattr(self, name) for name in FAULTS}
        return {name: count for name, count in counts.items() if count}

    def __repr__(self) -> str:
        return f"TrackedFrame({self})"

    def __str__(self) -> str:
        parts = [f"frame {self.number}: {100 * self.inside:.2f} % inside"]
        for name, what in NODES.items():
            nodes = getattr(self, name)
            if len(nodes):
                parts.append(f"{len(nodes)} {'node' if len(nodes) == 1 else 'nodes'} {what}, the first {nodes[0]}")
        if self.overlapped > 0:
            parts.append(f"{100 * self.overlapped:.2g} % of the curve in another part of the solid")
        if self.crossings:
            parts.append(f"the surface crosses itself, in {self.crossings} pairs of faces")
        if self.unexplained > 0:
            parts.append(f"{100 * self.unexplained:.2g} % of the surface is far from the curve")
        return "; ".join(parts) + ("; needs a fresh run" if self.wants_run else "")


@dataclass(frozen=True, eq=False)
class Track:
    """A curve through a sequence of meshes. All frames have the same nodes and edges.

    Attributes:
        skeleton: of the mesh that was skeletonised, usually the first.
        frames: one for each mesh, in their order.
    """

    skeleton: Skeleton = field(repr=False)
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
        return curve_of(self.skeleton, self.frames[number])

    def __repr__(self) -> str:
        return f"Track({str(self).splitlines()[0]}, {self.skeleton!r})"

    def __str__(self) -> str:
        wanting = [frame for frame in self.frames if frame.wants_run]
        lines = [f"{len(self.frames)} frames, {len(wanting)} of them need a fresh run"]
        return "\n".join(lines + [str(frame) for frame in wanting])


def curve_of(skeleton: Skeleton, frame: TrackedFrame) -> Skeleton:
    """The curve of a ``frame`` of a track of ``skeleton``; see `Track.curve`."""
    if len(frame.vanished):
        raise ConfigError(f"frame {frame.number} has no curve, {frame}")
    note = f"followed from another mesh, not run: {frame}"
    report = replace(skeleton.report, inside=frame.inside, figures={}, notes=(*skeleton.report.notes, note))
    return replace(skeleton, vertices=frame.nodes, radii=np.maximum(frame.radii, 0), report=report, source=None)


def track(skeleton: Skeleton, frames: Iterable[Any], *, progress: bool = False) -> Track:
    """The ``skeleton`` in every mesh of a sequence: an animation, a 4-D scan, an ensemble. It makes no run.

    Args:
        skeleton: of a mesh with the same faces as all ``frames``, usually the first of them; as `msf_jax.follow`
            takes it.
        frames: at least one; each (V, 3) vertices, or a mesh as `msf_jax.skeletonize` takes it: a path, an object with
            vertices and faces, a pair of them.
        progress: show a progress bar on standard error, if that is a terminal.

    Returns:
        Nodes and radii for each frame, with the same ids in all, and a validity check of each. ``wants_run`` is True
        for a frame that is bent, flattened or torn too far, in which limbs intersect, or in which a limb has grown;
        the frame lists the nodes. See `TrackedFrame`.

    Raises:
        ConfigError: ``skeleton`` has no source mesh, or ``frames`` is no sequence.
        MeshError: a frame cannot be read, has other vertices or faces, or is not finite. The message says which frame,
            and what was expected.
        FlowError: this process was forked after a run.
    """
    if not isinstance(frames, Iterable) or isinstance(frames, str):
        raise ConfigError(f"frames is a {type(frames).__name__}: expected a sequence of vertices (V, 3) or of meshes")
    tracker = Tracker(skeleton)
    num = len(frames) if isinstance(frames, Sequence | np.ndarray) else None
    found = []
    with tqdm(total=num, desc="track", unit="frame", disable=None if progress else True) as bar:
        for number, given in enumerate(frames):
            found.append(tracker.frame(number, given))
            bar.update()
    if not found:
        raise ConfigError("frames is empty: expected at least one mesh")
    return Track(skeleton, tuple(found))


class Tracker:
    """Follows a skeleton frame by frame. It holds the data that all frames share, and raises as `track` does."""

    def __init__(self, skeleton: Skeleton):
        binding = unpadded(binding_of(skeleton))
        surface, edges = bound(skeleton.source, skeleton.mesh_map), skeleton.edges
        self.skeleton, self.edges = skeleton, edges
        self.binding: Binding = jax.device_put(jax.tree.map(jnp.asarray, binding))
        self.solid, self.vertex = surface.solid, surface.vertex
        # Repair changes faces, so the caller's faces of a repaired mesh are not compared.
        faces = self.vertex[self.solid.shape.faces]
        self.faces = None if skeleton.report.repairs else _sorted(faces)
        # For each edge at a node with a section: that node, the other node, the section.
        section_of_node = np.full(len(skeleton.vertices), -1)
        section_of_node[binding.node[binding.is_loop]] = np.flatnonzero(binding.is_loop)
        here, there = np.concatenate([edges, edges[:, ::-1]]).T
        self.here, self.there = here[section_of_node[here] >= 0], there[section_of_node[here] >= 0]
        self.section = section_of_node[self.here]
        normal = np.asarray(_tracked(self.binding, jnp.asarray(surface.given(len(skeleton.mesh_map))))[3])
        self.upright = self._cosines(skeleton.vertices, normal)
        self.holding = Holding(surface, skeleton.vertices, edges)

    def _cosines(self, nodes: np.ndarray, normal: np.ndarray) -> np.ndarray:
        along = nodes[self.there] - nodes[self.here]
        length = np.linalg.norm(along, axis=1)
        return np.einsum("ei,ei->e", along, normal[self.section]) / np.where(length > 0, length, 1.0)

    def frame(self, number: int, given: Any) -> TrackedFrame:
        """The curve in the mesh ``given``, with its checks."""
        try:
            vertices = self._vertices_of(given)
            array = checked_vertices(self.skeleton, vertices)
        except MeshError as error:
            raise MeshError(f"frame {number}: {error}") from error
        nodes, radii, is_warped, normal = (np.asarray(each, dtype=np.float64) for each in _tracked(self.binding, array))
        vanished = np.flatnonzero(np.isnan(nodes).any(axis=1))
        cosine = np.sign(self.upright) * self._cosines(nodes, normal)
        is_over = (np.abs(self.upright) > STRAIGHT) & (cosine < TILTED) & normal[self.section].any(axis=1)
        loose = np.union1d(np.asarray(self.binding.node)[is_warped > 0], self.here[is_over])
        moved = np.asarray(array, dtype=np.float64)[self.vertex]
        held = self.holding.held(moved, nodes, radii)
        return TrackedFrame(number, nodes, vanished=vanished, loose=np.setdiff1d(loose, vanished), **held._asdict())

    def _vertices_of(self, given: Any) -> Any:
        if isinstance(given, np.ndarray | jax.Array) or (isinstance(given, list | tuple) and len(given) != 2):
            return given
        vertices, faces = reading.read(given, finite=not self.skeleton.report.repairs)
        if self.faces is not None and not np.array_equal(_sorted(faces), self.faces):
            raise MeshError(f"its {len(faces)} faces are not those of the mesh that the skeleton was made from")
        return vertices


@jax.jit
def _tracked(binding: Binding, vertices: jax.Array) -> tuple[jax.Array, ...]:
    """Nodes, radii, whether each section is warped (S,), and the normals of sections (S, 3).

    The normal of a section smaller than half of `SLIGHT` is 0, because noise of the vertices turns it at random.
    """
    nodes, radii = following.follow(binding, vertices)
    entered = (vertices - binding.centre) / binding.diagonal
    found = following.centroids(binding, following.corners(binding, entered))
    size = jnp.sqrt(found.area / jnp.pi)
    is_warped = binding.is_loop & (found.warp * size > WARPED * jnp.maximum(size, SLIGHT))
    return nodes, radii, is_warped, jnp.where(size[:, None] < SLIGHT / 2, 0.0, found.normal)


def _sorted(faces: np.ndarray) -> np.ndarray:
    """Faces in an order that does not depend on their first corner, their orientation or their order."""
    return np.unique(np.sort(faces, axis=1), axis=0)
