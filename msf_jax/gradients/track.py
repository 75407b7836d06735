"""`track`: one curve through a sequence of meshes of the same faces, with the same nodes in each, and how it holds.

One run, then `follow` for each frame. What a frame is checked for: whether every section is still there, flat, and
across its branch; and what `holding` asks of the whole moved surface, which sections cannot fool.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from tqdm import tqdm

from msf_jax.base import forking
from msf_jax.base.binding import Binding, unpadded
from msf_jax.base.errors import ConfigError, MeshError
from msf_jax.device import following
from msf_jax.gradients.follow import binding_of, checked_vertices
from msf_jax.gradients.holding import SLIGHT, Holding
from msf_jax.host.mesh import reading
from msf_jax.skeleton.skeleton import Skeleton

WARPED = 0.5  # corners so far off their plane, in parts of how far they are from the centroid, are no section
TILTED, STRAIGHT = 0.3, 0.7  # cosine of a section's normal and its branch, at which it lies over; at first it was above
INSIDE = 0.99  # of the curve's length, at least
NODES = {  # attributes of a `Frame` that name nodes, and what is said of them
    "vanished": "without a section",
    "loose": "whose section no longer holds",
    "overlaps": "around which the surface winds once more",
    "misjudged": "whose followed radius was wrong",
    "pinched": "whose ball has shrunk by half",
    "strained": "in a stretch that has become much longer, or shorter",
}
FAULTS = (*NODES, "overlapped", "crossings", "unexplained")


@dataclass(frozen=True, eq=False)
class Frame:
    """The curve in one mesh of a sequence.

    Attributes:
        number: which frame, from 0.
        nodes: (N, 3), in the mesh's units; NaN for those of ``vanished``.
        radii: (N,) exact distance to the whole surface of the frame, negative for a node outside; NaN as ``nodes``.
        inside: fraction of the curve's length that is inside, of the edges between nodes that are there.
        vanished: (k,) nodes whose section is no more.
        loose: (k,) nodes whose section no longer holds: it is warped, or lies along its branch.
        overlapped: fraction of the curve's length around which the surface winds more often than in the mesh of the
            run: another part of the solid has come there.
        overlaps: (k,) nodes around which it does.
        crossings: pairs of faces that cross, although they are apart along the surface; more than in the mesh of the
            run.
        unexplained: fraction of the surface that is outside of the balls along the curve, by a radius more than it
            was: a limb has grown there.
        misjudged: (k,) nodes whose radius `msf_jax.follow` has wrong, by more than a third of it.
        pinched: (k,) nodes whose ball is less than half as large as it was.
        strained: (k,) nodes whose sections have left each other, or met: a stretch of the branch that was about a
            radius long is 2.5 times as long, or 0.4 times.

    Lengths are compared as the mesh has grown, or been stretched as a whole.
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
        """Whether the curve no longer holds: run `msf_jax.skeletonize` on this frame, if it is a solid at all."""
        return bool(self.faults) or not self.inside >= INSIDE

    @property
    def faults(self) -> dict[str, float]:
        """What is wrong, by the names of the attributes: how many nodes or pairs of faces, or what fraction."""
        counts = {name: len(getattr(self, name)) if name in NODES else getattr(self, name) for name in FAULTS}
        return {name: count for name, count in counts.items() if count}

    def __repr__(self) -> str:
        return f"Frame({self})"

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
        return "; ".join(parts) + ("; wants a fresh run" if self.wants_run else "")


@dataclass(frozen=True, eq=False)
class Track:
    """A curve through a sequence of meshes: the nodes of all frames are the same, and so are the edges.

    Attributes:
        skeleton: of the first mesh, or of whichever the run was on.
        frames: one for each mesh, in their order.
    """

    skeleton: Skeleton = field(repr=False)
    frames: tuple[Frame, ...]

    @property
    def nodes(self) -> np.ndarray:
        """(T, N, 3), for all T frames."""
        return np.stack([frame.nodes for frame in self.frames])

    @property
    def radii(self) -> np.ndarray:
        """(T, N), as `Frame.radii`."""
        return np.stack([frame.radii for frame in self.frames])

    def curve(self, number: int) -> Skeleton:
        """The curve of frame ``number``, to be saved or drawn: it has no source, its report is that of the run.

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
        lines = [f"{len(self.frames)} frames, {len(wanting)} of them want a fresh run"]
        return "\n".join(lines + [str(frame) for frame in wanting])


def curve_of(skeleton: Skeleton, frame: Frame) -> Skeleton:
    """The curve of a ``frame`` of a track of ``skeleton``; see `Track.curve`."""
    if len(frame.vanished):
        raise ConfigError(f"frame {frame.number} has no curve, {frame}")
    note = f"followed from another mesh, not run: {frame}"
    report = replace(skeleton.report, inside=frame.inside, figures={}, notes=(*skeleton.report.notes, note))
    return replace(skeleton, vertices=frame.nodes, radii=np.maximum(frame.radii, 0), report=report, source=None)


def track(skeleton: Skeleton, frames: Iterable[Any], *, progress: bool = False) -> Track:
    """The ``skeleton`` in every mesh of a sequence: an animation, a 4-D scan, an ensemble. No run is made.

    Args:
        skeleton: of a mesh with the same faces as all ``frames``, usually the first of them; as `msf_jax.follow`
            takes it.
        frames: at least one; each (V, 3) vertices, or a mesh as `msf_jax.skeletonize` takes it: a path, an object with
            vertices and faces, a pair of them.
        progress: show a progress bar on standard error, if that is a terminal.

    Returns:
        Nodes and radii for each frame, with the same numbers in all, and how far to trust each. A frame that is bent,
        flattened or torn too far, where limbs have come into each other, or where one has grown, says so,
        ``wants_run``, and with which nodes; see `msf_jax.Frame`.

    Raises:
        ConfigError: ``skeleton`` does not know the mesh that it was made from, or ``frames`` is no sequence.
        MeshError: a frame cannot be read, has other vertices or faces, or is not finite: which, and what was expected.
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
    """What does not change from frame to frame; raises as `track` does."""

    def __init__(self, skeleton: Skeleton):
        forking.check()
        binding = unpadded(binding_of(skeleton))
        surface, edges = skeleton.surface, skeleton.edges
        self.skeleton, self.edges = skeleton, edges
        self.binding: Binding = jax.device_put(jax.tree.map(jnp.asarray, binding))
        self.solid, self.vertex = surface.solid, surface.vertex
        # Faces of a mesh that was mended are others than the caller's: those are not compared.
        faces = self.vertex[self.solid.shape.faces]
        self.faces = None if skeleton.report.repairs else _sorted(faces)
        # Each section, and the edges of its node.
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

    def frame(self, number: int, given: Any) -> Frame:
        """The curve in ``given``, and how it holds."""
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
        return Frame(number, nodes, vanished=vanished, loose=np.setdiff1d(loose, vanished), **held._asdict())

    def _vertices_of(self, given: Any) -> Any:
        if isinstance(given, np.ndarray | jax.Array) or (isinstance(given, list | tuple) and len(given) != 2):
            return given
        vertices, faces = reading.read(given, finite=not self.skeleton.report.repairs)
        if self.faces is not None and not np.array_equal(_sorted(faces), self.faces):
            raise MeshError(f"its {len(faces)} faces are not those of the mesh that the skeleton was made from")
        return vertices


@jax.jit
def _tracked(binding: Binding, vertices: jax.Array) -> tuple[jax.Array, ...]:
    """Nodes, radii, which sections are warped (S,), and the normals of all (S, 3), 0 of those that are too small for
    one: what noise of the vertices is to them."""
    nodes, radii = following.follow(binding, vertices)
    entered = (vertices - binding.centre) / binding.diagonal
    found = following.centroids(binding, following.corners(binding, entered))
    size = jnp.sqrt(found.area / jnp.pi)
    is_warped = binding.is_loop & (found.warp * size > WARPED * jnp.maximum(size, SLIGHT))
    return nodes, radii, is_warped, jnp.where(size[:, None] < SLIGHT / 2, 0.0, found.normal)


def _sorted(faces: np.ndarray) -> np.ndarray:
    """Faces in an order that does not depend on where each begins, how it turns, or which comes first."""
    return np.unique(np.sort(faces, axis=1), axis=0)
