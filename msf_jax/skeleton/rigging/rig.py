"""`Rig`: bones for a mesh, with skinning weights, to pose here or in another program."""

import numbers
import os
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy import sparse

from msf_jax.base.errors import ConfigError
from msf_jax.base.writing import write_whole
from msf_jax.curve import branches
from msf_jax.meshes import reading
from msf_jax.meshes.reading import MeshLike
from msf_jax.skeleton.formats import gltf
from msf_jax.skeleton.rigging import binding
from msf_jax.skeleton.rigging.body import STANDARDS
from msf_jax.skeleton.rigging.bones import FOR_LIMBS, Bones, bones_of
from msf_jax.skeleton.rigging.cutting import FEWEST_HELD
from msf_jax.solid.geometry import to_segment
from msf_jax.topology import graphs

if TYPE_CHECKING:
    from msf_jax.skeleton.skeleton import Skeleton

MOST_BONES = 65535  # bones that glTF can number
USUAL = 50  # bones at most, where no number is asked for
TRIES = 5  # times that bones are made, until as many have vertices as are asked for
NEIGHBOURS = 3  # edges along the curve: the size of a limb at a node is averaged over nodes within this distance
LEAST_DISTANCE = 0.003  # diagonals: the least distance from the curve for heat, so that smaller details move together
HELD = 0.25  # a bone whose largest weight at any vertex is below this is joined to another


@dataclass(frozen=True, eq=False)
class Rig:
    """Bones, and the weight of each bone at each vertex.

    Attributes:
        joints: (B, 3) the start of each bone, about which it turns; in the caller's units, parents first.
        tails: (B, 3) the end of each bone.
        parents: (B,) int, the parent of each bone; -1 for a root.
        names: of the bones: root, trunk1_1, limb2_3.L (the third bone of the second limb on the left side).
        weights: sparse (V, B); each row sums to 1.
        notes: what is not as it was asked for, or was cut; empty if there is nothing to tell.
    """

    joints: np.ndarray
    tails: np.ndarray
    parents: np.ndarray
    names: tuple[str, ...]
    weights: sparse.csr_matrix = field(repr=False)
    notes: tuple[str, ...] = ()
    _binding: binding.SkinBinding | None = field(default=None, repr=False)

    def __repr__(self) -> str:
        most = int(np.diff(self.weights.indptr).max(initial=0))
        return f"Rig({len(self.joints)} bones, {self.num_vertices} vertices with up to {most} weights)" + "".join(
            f"\n  {note}" for note in self.notes
        )

    @property
    def num_vertices(self) -> int:
        """The number of vertices of the mesh."""
        return len(self.weights.indptr) - 1

    def save(self, path: str | os.PathLike[str], mesh: "MeshLike") -> None:
        """Write ``mesh``, as `skeletonize` took it, on these bones to a ``.glb`` file, atomically.

        Raises:
            ConfigError: the suffix is not ``.glb``, or there are more bones than the format can number.
            MeshError: the mesh has another number of vertices than the rig.
            OSError: the file cannot be written.
        """
        if not os.fspath(path).lower().endswith(".glb"):
            raise ConfigError(f"no format for a rig in {os.fspath(path)!r}: expected the suffix .glb")
        write_whole(path, gltf.of_rig(self, mesh))

    def posed(self, vertices: Any, turns: Mapping[str, Any]) -> np.ndarray:
        """The positions of ``vertices`` (V, 3) when bones turn, by linear blend skinning, as in other programs.

        Args:
            vertices: of the mesh at rest.
            turns: rotation matrices (3, 3) about joints, by the name of the bone. A bone's descendants turn with it.

        Raises:
            ConfigError: there is no bone of that name, or a rotation or the vertices have another shape.
        """
        points = np.asarray(vertices, dtype=np.float64)
        if points.shape != (self.num_vertices, 3):
            raise ConfigError(f"vertices has shape {points.shape}: expected ({self.num_vertices}, 3)")
        for name, turn in turns.items():
            if name not in self.names or np.shape(turn) != (3, 3):
                raise ConfigError(
                    f"turns has {name!r} with shape {np.shape(turn)}: expected a bone's name, and a matrix (3, 3)"
                )
        posed = np.zeros_like(points)
        columns = self.weights.tocsc()
        linear, shift = np.empty((len(self.joints), 3, 3)), np.empty((len(self.joints), 3))
        for bone, (name, above) in enumerate(zip(self.names, self.parents, strict=True)):
            turn = np.asarray(turns.get(name, np.eye(3)), dtype=np.float64)
            offset = self.joints[bone] - turn @ self.joints[bone]
            linear[bone] = turn if above < 0 else linear[above] @ turn
            shift[bone] = offset if above < 0 else linear[above] @ offset + shift[above]
            rows = columns.indices[columns.indptr[bone] : columns.indptr[bone + 1]]
            share = columns.data[columns.indptr[bone] : columns.indptr[bone + 1]]
            posed[rows] += share[:, None] * (points[rows] @ linear[bone].T + shift[bone])
        return posed

    def moved(self, joints: Mapping[str, Any]) -> "Rig":
        """The rig with some joints at other places, and weights made anew for all bones.

        The bone that ends at such a joint ends at its new place. Vertices of both bones go to the one that their place
        on the curve is nearer to.

        Args:
            joints: positions (3,) by the name of the bone that begins there; ``rig.joints`` has the present ones.

        Raises:
            ConfigError: no bone has that name, a position is not three finite numbers, or the rig has end bones.
        """
        if self._binding is None:
            raise ConfigError("a rig with end bones has no weights to make anew: expected moved(...).with_ends()")
        starts, tails, bone = self.joints.copy(), self.tails.copy(), self._binding.bone.copy()
        for name, place in joints.items():
            if name not in self.names or np.shape(place) != (3,) or not np.isfinite(place).all():
                raise ConfigError(f"joints has {name!r} at {place!r}: expected a bone's name, and three finite numbers")
            number = self.names.index(name)
            above = int(self.parents[number])
            if above >= 0 and (tails[above] == starts[number]).all():
                tails[above] = place
            starts[number] = place
        for number in sorted(self.names.index(name) for name in joints):
            both = np.array([self.parents[number], number])
            if both[0] >= 0:
                near = np.flatnonzero(np.isin(bone, both))
                away = [to_segment(self._binding.places[near], starts[each], tails[each]) for each in both]
                bone[near] = both[np.argmin(away, axis=0)]
        anew = self._binding._replace(bone=bone)
        return replace(self, joints=starts, tails=tails, weights=anew.weights(starts, self.parents), _binding=anew)

    def with_ends(self) -> "Rig":
        """The rig with a bone of length 0 and without vertices at the end of each last bone, named like it with
        ``_end``. Formats in which a bone ends at the next joint need them, such as BVH, FBX and Mixamo's. glTF does
        not, but with them Blender shows the true length of last bones."""
        last = np.setdiff1d(np.arange(len(self.parents)), self.parents)
        names = (*self.names, *(f"{self.names[bone]}_end" for bone in last))
        joints, tails = (np.concatenate([both, self.tails[last]]) for both in (self.joints, self.tails))
        weights = sparse.hstack([self.weights, sparse.csr_matrix((self.num_vertices, len(last)))]).tocsr()
        return replace(
            self,
            joints=joints,
            tails=tails,
            parents=np.r_[self.parents, last],
            names=names,
            weights=weights,
            _binding=None,
        )


def rigged(skeleton: "Skeleton", bones: int | None, influences: int, mesh: "MeshLike | None", names: str | None) -> Rig:
    """See `Skeleton.rig`."""
    if names is not None and names not in STANDARDS:
        raise ConfigError(f"names is {names!r}: expected None or one of {', '.join(STANDARDS)}")
    for name, value in (("bones", USUAL if bones is None else bones), ("influences", influences)):
        if isinstance(value, bool) or not isinstance(value, numbers.Integral) or not 1 <= value <= MOST_BONES:
            raise ConfigError(f"{name} is {value!r}: expected a whole number from 1 to {MOST_BONES}")
    vertices, faces = _surface(skeleton) if mesh is None else reading.read(mesh, finite=False)
    reading.check_map(skeleton.mesh_map, len(vertices))
    node = skeleton.mesh_map
    is_lost = np.logical_not(np.isfinite(vertices).all(axis=1))
    vertices = np.where(is_lost[:, None], skeleton.vertices[node], vertices)
    size = _sizes(skeleton, node, np.linalg.norm(vertices - skeleton.vertices[node], axis=1))
    stays = branches.cut_loops(len(skeleton.vertices), skeleton.edges, size)
    node = binding.walked(vertices, skeleton.vertices, skeleton.edges, node)
    away = np.linalg.norm(vertices - skeleton.vertices[node], axis=1)
    chosen = _choose_bones(skeleton, size, node, bones, names is not None)
    thinnest = LEAST_DISTANCE * float(np.linalg.norm(np.ptp(vertices, axis=0)))
    heat = binding.Heat(vertices, faces, np.maximum(np.maximum(away, size[node]), thinnest))
    bind = binding.SkinBinding(heat, chosen.of_node[node], skeleton.vertices[node], int(influences))
    weights = bind.weights(chosen.joints, chosen.parents)
    if bones is None:
        chosen, held = without_idle(chosen, weights.toarray())
        bind, weights = bind._replace(bone=chosen.of_node[node]), sparse.csr_matrix(held)
    cuts = skeleton.vertices[skeleton.edges[np.logical_not(stays)]].mean(axis=1)
    where = ["({:.4g}, {:.4g}, {:.4g})".format(*place) for place in cuts]
    notes = [f"a loop was cut at {place}, where it is thinnest or parts merely touch" for place in where]
    if bones is not None and len(chosen.joints) != bones:
        notes.append(f"{len(chosen.joints)} bones for {bones}: more would be shorter than thick, or without vertices")
    return Rig(chosen.joints, chosen.tails, chosen.parents, chosen.names(names), weights, tuple(notes), bind)


def _choose_bones(skeleton: "Skeleton", size: np.ndarray, node: np.ndarray, asked: int | None, is_biped: bool) -> Bones:
    """``asked`` bones that have vertices, or as many as there is length for; None: as the shape has bends."""
    curve, held = (skeleton.vertices, skeleton.edges, skeleton.radii), np.bincount(node, minlength=len(size))
    if asked is None:
        return without_empty(bones_of(*curve, USUAL, size, held, is_biped=is_biped), node)
    best = without_empty(bones_of(*curve, 1, size, held), node)
    for for_limbs in (FOR_LIMBS, 1.0):  # where branches cannot be cut so often, more of them have bones
        most = asked
        for _ in range(TRIES):
            made = without_empty(bones_of(*curve, most, size, held, for_limbs, True, is_biped), node)
            if len(best.joints) < len(made.joints) <= asked:
                best = made
            if len(best.joints) == asked:
                return best
            most += asked - len(made.joints)
    return best


def _surface(skeleton: "Skeleton") -> tuple[np.ndarray, np.ndarray]:
    """Vertices and faces of the mesh that the curve was made from, if they can be known without the mesh."""
    surface, num = skeleton.bound_surface, len(skeleton.mesh_map)
    if len(np.unique(surface.vertex)) < num:
        raise ConfigError("the mesh was welded or repaired, and not all its vertices are known: expected rig(mesh=...)")
    return surface.given(num), surface.vertex[surface.solid.shape.faces]


def _sizes(skeleton: "Skeleton", node: np.ndarray, away: np.ndarray) -> np.ndarray:
    """(N,) the size of the limb at each node: the larger of its ball's radius and the mean distance of its vertices.

    In a sheet the ball has half its thickness, but bones should be as long as the sheet is wide. The mean is over the
    node's neighbours along the curve, too.
    """
    num = len(skeleton.vertices)
    ends = np.concatenate([skeleton.edges, skeleton.edges[:, ::-1]])
    beside = graphs.weighted(num, *ends.T) + sparse.eye(num)
    total = np.stack([np.bincount(node, away, num), np.bincount(node, minlength=num)], axis=1)
    for _ in range(NEIGHBOURS):
        total = beside @ total
    return np.maximum(skeleton.radii, total[:, 0] / np.maximum(total[:, 1], 1e-300))


def without_empty(bones: Bones, node: np.ndarray) -> Bones:
    """The bones without those that have few vertices. ``node`` (V,) is that of each vertex.

    The only bone of a branch may have few, but not none: a limb of few triangles is still a limb. A spine keeps its
    joints, which animations expect, and a biped all that have a name.
    """
    while True:
        count = np.bincount(bones.of_node[node], minlength=len(bones.parents))
        is_only = np.bincount(bones.branch + 1)[bones.branch + 1] == 1
        is_few = (count < np.where(is_only, 1, FEWEST_HELD)) & ~bones.is_needed
        if not is_few.any():
            return bones
        bone = int(is_few.argmax())
        bones = bones.without({bone, int(bones.twin[bone])} - {-1})[0]


def without_idle(bones: Bones, weights: np.ndarray) -> tuple[Bones, np.ndarray]:
    """Join each bone with small ``weights`` (V, B) at all vertices, and its mirror image, to others, which keep theirs.

    Such bones occur where heat had to spread far.
    """
    while True:
        most = np.where(bones.is_needed, np.inf, weights.max(axis=0))
        bone = int(most.argmin())
        if most[bone] >= HELD:
            return bones, weights
        bones, number = bones.without({bone, int(bones.twin[bone])} - {-1})
        joined = np.zeros((len(weights), len(bones.parents)))
        np.add.at(joined.T, number, weights.T)
        weights = joined
