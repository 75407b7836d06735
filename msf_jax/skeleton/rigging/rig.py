"""`Rig`: bones for a mesh, with skinning weights, to pose here or in another program.

Weights are smooth, by heat diffusion over the surface. As in Pinocchio (Baran and Popovic 2007) and in Blender's
automatic weights, the weights w_b of bone b are the heat in equilibrium

    (L + H) w_b = H p_b,    H = M / d^2,

with L the cotangent Laplacian, M the areas of vertices, and d the size of the limb at a vertex. In Pinocchio p_b is 1
where b is the nearest visible bone. Here it is 1 at vertices that the flow maps to b's part of the curve, so that an
arm that touches a leg keeps its own bones. Weights sum to 1 as p does, and none is negative.

A file is binary glTF 2.0: trimesh writes the mesh, with materials, UVs, normals and colours, and this module adds the
skin. A vertex at a seam is written several times. A joint has the name of its bone, and its "extras" the end. Numbers
are float32, so a mesh should be near the origin.
"""

import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import jax
import jax.numpy as jnp
import numpy as np
import trimesh
from scipy import sparse
from trimesh.exchange.gltf import export_glb

from msf_jax.base.errors import ConfigError
from msf_jax.base.version import VERSION
from msf_jax.base.writing import write_whole
from msf_jax.curve import branches
from msf_jax.limbs.ends import laplacian
from msf_jax.meshes import reading, scenes
from msf_jax.numerics.factors import surface_factor
from msf_jax.skeleton import trees
from msf_jax.skeleton.rigging.bones import STANDARDS, bones_of
from msf_jax.solid.geometry import repeated
from msf_jax.topology import graphs

if TYPE_CHECKING:
    from msf_jax.skeleton.skeleton import Skeleton

INFLUENCES = 4  # bones of a vertex at most, as game engines have it
HEAT_REACH = 2.0  # ratio of d to the limb's size
NEIGHBOURS = 3  # edges along the curve: the size of a limb at a node is averaged over nodes within this distance
LEAST_DISTANCE = 0.003  # diagonals: the least size of a limb for heat, so that smaller details move together
LARGEST_T = 0.45  # largest t of `reduce_along_tree`, below 1/2; a share of a row's sum
LEAST = 1e-6  # weights below this count as 0


@dataclass(frozen=True, eq=False)
class Rig:
    """Bones, and the weight of each bone at each vertex.

    Attributes:
        joints: (B, 3) the start of each bone, about which it turns; in the caller's units, parents first.
        tails: (B, 3) the end of each bone.
        parents: (B,) int, the parent of each bone; -1 for a root.
        names: of the bones: root, trunk1_1, limb2_3.L (the third bone of the second limb on the left side).
        weights: sparse (V, B), of at most four bones for each vertex; each row sums to 1.
        notes: where loops were cut, and what is not known of a body.
    """

    joints: np.ndarray
    tails: np.ndarray
    parents: np.ndarray
    names: tuple[str, ...]
    weights: sparse.csr_matrix = field(repr=False)
    notes: tuple[str, ...] = ()

    def __repr__(self) -> str:
        head = f"Rig({len(self.joints)} bones, {self.num_vertices} vertices with up to {INFLUENCES} weights)"
        return "\n  ".join([head, *self.notes])

    @property
    def num_vertices(self) -> int:
        """The number of vertices of the mesh."""
        return len(self.weights.indptr) - 1

    def save(self, path: str | os.PathLike[str], mesh: "reading.MeshLike") -> None:
        """Write ``mesh``, as `skeletonize` took it, on these bones to a ``.glb`` file, atomically.

        Raises:
            ConfigError: the suffix is not ``.glb``, or there are more bones than the format can number.
            MeshError: the mesh has another number of vertices than the rig.
            OSError: the file cannot be written.
        """
        if not os.fspath(path).lower().endswith(".glb"):
            raise ConfigError(f"no format for a rig in {os.fspath(path)!r}: expected the suffix .glb")
        write_whole(path, glb_of(self, mesh))

    def posed(self, vertices: Any, turns: Mapping[str, Any]) -> Any:
        """The positions of ``vertices`` (V, 3) when bones turn, by linear blend skinning, as in other programs.

        Differentiable in: the vertices and the rotations, if one of them is an array of JAX; then so is the result.
        It is float32 unless ``jax_enable_x64`` is set.

        Args:
            vertices: of the mesh at rest.
            turns: rotation matrices (3, 3) about joints, by the name of the bone. A bone's descendants turn with it.

        Raises:
            ConfigError: there is no bone of that name, or a rotation or the vertices have another shape.
        """
        library = jnp if any(isinstance(each, jax.Array) for each in (vertices, *turns.values())) else np
        points = library.asarray(vertices, dtype=float)
        if points.shape != (self.num_vertices, 3):
            raise ConfigError(f"vertices has shape {points.shape}: expected ({self.num_vertices}, 3)")
        for name, turn in turns.items():
            if name not in self.names or np.shape(turn) != (3, 3):
                found = f"turns has {name!r} with shape {np.shape(turn)}"
                raise ConfigError(f"{found}: expected a bone's name, and a matrix (3, 3)")
        turned, shift = list[Any](), list[Any]()  # of each bone: x -> turned x + shift
        for name, joint, above in zip(self.names, self.joints, self.parents, strict=True):
            turn = library.asarray(turns.get(name, np.eye(3)))
            turned.append(turn if above < 0 else turned[above] @ turn)
            rest = joint - turn @ joint
            shift.append(rest if above < 0 else turned[above] @ rest + shift[above])
        bones, weights = _influences(self.weights)
        turned, shift = library.stack(turned)[bones], library.stack(shift)[bones]
        return library.einsum("vi,viab,vb->va", weights, turned, points) + library.einsum("vi,via->va", weights, shift)


def rigged(skeleton: "Skeleton", mesh: "reading.MeshLike | None", names: str | None) -> Rig:
    """See `Skeleton.rig`."""
    if names is not None and names not in STANDARDS:
        raise ConfigError(f"names is {names!r}: expected None or one of {', '.join(STANDARDS)}")
    if mesh is None:
        surface, num = skeleton.bound_surface, len(skeleton.mesh_map)
        if len(np.unique(surface.vertex)) < num:
            raise ConfigError("the mesh was welded or repaired, and not all its vertices are known: expected rig(mesh)")
        vertices, faces = surface.given(num), surface.vertex[surface.solid.shape.faces]
    else:
        vertices, faces = reading.read(mesh)
        reading.check_map(skeleton.mesh_map, len(vertices))
    nodes, edges, node = skeleton.vertices, skeleton.edges, skeleton.mesh_map
    vertices = np.where(np.isfinite(vertices).all(axis=1, keepdims=True), vertices, nodes[node])
    size = _sizes(skeleton, np.linalg.norm(vertices - nodes[node], axis=1))
    node = branches.nearest_on_branch(nodes, edges, vertices, node)
    bones = bones_of(nodes, edges, skeleton.radii, size, names)
    least = LEAST_DISTANCE * float(np.linalg.norm(np.ptp(vertices, axis=0)))
    away = np.maximum.reduce([np.linalg.norm(vertices - nodes[node], axis=1), size[node], np.full(len(node), least)])
    weights = heat_weights(vertices, faces, HEAT_REACH * away, bones.of_node[node], len(bones.joints))
    cuts = edges[np.logical_not(trees.cut_loops(len(nodes), edges, size))]
    weights = subtract_rest(weights) if len(cuts) else reduce_along_tree(weights, bones.parents)
    notes = list(bones.notes)
    if len(cuts):
        place = "({:.4g}, {:.4g}, {:.4g})".format(*nodes[cuts[0]].mean(axis=0))
        more = f" and {len(cuts) - 1} more at other places" if len(cuts) > 1 else ""
        notes.append(f"a loop was cut at {place}{more}, where it is thinnest or parts merely touch")
    return Rig(bones.joints, bones.tails, bones.parents, bones.names, sparse.csr_matrix(weights), tuple(notes))


def _sizes(skeleton: "Skeleton", away: np.ndarray) -> np.ndarray:
    """(N,) the size of the limb at each node: the larger of its ball's radius and the mean distance ``away`` (V,) of
    its vertices and its neighbours'. In a sheet the ball has half the thickness; bones are as long as it is wide."""
    num, node = len(skeleton.vertices), skeleton.mesh_map
    ends = np.concatenate([skeleton.edges, skeleton.edges[:, ::-1]])
    beside = graphs.weighted(num, *ends.T) + sparse.eye(num)
    total = np.stack([np.bincount(node, away, num), np.bincount(node, minlength=num)], axis=1)
    for _ in range(NEIGHBOURS):
        total = beside @ total
    return np.maximum(skeleton.radii, total[:, 0] / np.maximum(total[:, 1], 1e-300))


def heat_weights(
    vertices: np.ndarray, faces: np.ndarray, away: np.ndarray, bone: np.ndarray, num_bones: int
) -> np.ndarray:
    """(V, B) the weights of vertices (V, 3) that belong to the bones ``bone`` (V,), with d as ``away`` (V,), above 0.
    Rows sum to 1. Coincident vertices of ``faces`` (F, 3) count as one."""
    points, of_given, count = np.unique(vertices, axis=0, return_inverse=True, return_counts=True)
    of_given, num = of_given.ravel(), len(points)
    matrix, area = laplacian(points, of_given[faces])
    pull = np.maximum(area, 1e-6 * area.mean()) / (np.bincount(of_given, away, num) / count) ** 2
    share = sparse.csr_matrix((1 / count[of_given], (of_given, bone)), shape=(num, num_bones)).toarray()
    heat = surface_factor((matrix + sparse.diags_array(pull)).tocsc())
    weights = np.maximum(heat.solve(np.asfortranarray(pull[:, None] * share)), 0.0)
    return (weights / weights.sum(axis=1, keepdims=True))[of_given]


def reduce_along_tree(weights: np.ndarray, parents: np.ndarray) -> np.ndarray:
    """Reduce each row of ``weights`` (n, B) to at most `INFLUENCES` values with sum 1, still smooth over the surface.

    Each bone but a root represents the edge to its parent, one of ``parents`` (B,). This edge splits the sum of a row
    into c, for the bone and its descendants, and 1 - c. With t the `INFLUENCES`-th largest of all min(c, 1 - c), c
    becomes (c - t) / (1 - 2 t), clipped to 0 and 1. Fewer edges have c between t and 1 - t, and these are connected, so
    at most `INFLUENCES` bones remain. No weight jumps over the surface, as it would if the smallest were set to 0."""
    num = weights.shape[1]
    if num <= INFLUENCES:
        return weights
    step, child = np.eye(num), np.flatnonzero(parents >= 0)
    step[child, parents[child]] = -1.0
    beyond = weights @ np.linalg.inv(step)  # c, as the weights are c less those of the bone's children
    smaller = np.minimum(beyond, 1 - beyond)
    t = np.minimum(np.partition(smaller, num - INFLUENCES, axis=1)[:, num - INFLUENCES, None], LARGEST_T)
    few = np.clip((beyond - t) / (1 - 2 * t), 0.0, 1.0) @ step
    few = np.where(few > LEAST, few, 0.0)
    few[few < np.partition(few, num - INFLUENCES, axis=1)[:, num - INFLUENCES, None]] = 0.0  # rounding
    return few / few.sum(axis=1, keepdims=True)


def subtract_rest(weights: np.ndarray) -> np.ndarray:
    """Reduce each row (n, B) to at most `INFLUENCES` weights with sum 1: subtract the largest weight that is left out.
    No tree of bones is needed, which cannot follow the loops of a surface. Weights stay continuous here, too, but they
    change quickly where many of them are similar."""
    if weights.shape[1] <= INFLUENCES:
        return weights
    few = weights - np.sort(weights, axis=1)[:, -INFLUENCES - 1, None]
    few = np.where(few > LEAST, few, 0.0)
    is_even = ~few.any(axis=1)
    few[is_even, weights[is_even].argmax(axis=1)] = 1.0
    return few / few.sum(axis=1, keepdims=True)


def _influences(own: Any) -> tuple[np.ndarray, np.ndarray]:
    """The bones (V, `INFLUENCES`) of each vertex, and their weights, 0 for none; of a rig's weights (V, B), a sparse
    matrix with at most as many values in each row."""
    bones, weights = np.zeros((own.shape[0], INFLUENCES), dtype=np.int64), np.zeros((own.shape[0], INFLUENCES))
    place = repeated(np.diff(own.indptr))
    bones[place], weights[place] = own.indices, own.data
    return bones, weights


def glb_of(rig: Rig, mesh: "reading.MeshLike") -> bytes:
    """The bytes of a ``.glb`` file with ``mesh``, as `skeletonize` took it, on the bones of ``rig``; see `Rig.save`."""
    if len(rig.joints) > (most := np.iinfo(np.uint16).max):
        raise ConfigError(f"the rig has {len(rig.joints)} bones: glTF can number at most {most}")
    parts = reading.parts(mesh)
    num = sum(len(part.vertices) for part in parts)
    reading.check_map(np.empty(rig.num_vertices), num)
    rows = np.split(np.arange(num), np.cumsum([len(part.vertices) for part in parts])[:-1])
    for part in parts:
        part.vertices = np.where(np.isfinite(part.vertices), part.vertices, 0.0)
    _add_normals(parts, rows)
    scene = trimesh.Scene()
    for number, part in enumerate(parts):
        part.metadata.clear()
        scene.add_geometry(part, node_name=f"mesh {number}", geom_name=f"mesh {number}")
    return export_glb(scene, buffer_postprocessor=lambda data, document: _add_skin(document, data, rig, rows))


def _add_normals(parts: list[trimesh.Trimesh], rows: list[np.ndarray]) -> None:
    """Give smooth normals to those of ``parts`` that have none: without them, viewers show every face flat. Vertices at
    one place, as at the seam of a texture, have one normal."""
    places, place = np.unique(np.concatenate([part.vertices for part in parts]), axis=0, return_inverse=True)
    faces = np.concatenate([place.ravel()[row[part.faces]] for part, row in zip(parts, rows, strict=True)])
    normals = np.array(trimesh.Trimesh(places, faces, process=False).vertex_normals)
    normals[~normals.any(axis=1)] = [0.0, 0.0, 1.0]  # of vertices in no face
    for part, row in zip(parts, rows, strict=True):
        if not scenes.has_normals(part):
            part.vertex_normals = normals[place.ravel()[row]]


def _add_skin(document: dict[str, Any], data: Any, rig: Rig, rows: list[np.ndarray]) -> None:
    """Put the joints of ``rig``, and nodes of the meshes that are bound to them, in place of the document's nodes.
    ``rows`` are those of the rig's weights, for the vertices of each part."""

    def add(array: np.ndarray, kind: str) -> int:
        """Append ``array``, of a multiple of four bytes, to the binary content. Returns the index of its accessor."""
        number = len(document["accessors"])
        data["skin", number] = array.tobytes()  # trimesh numbers buffer views in their order
        component = {"float32": 5126, "uint16": 5123}[array.dtype.name]
        accessor = {"bufferView": len(data) - 1, "componentType": component, "count": len(array), "type": kind}
        document["accessors"]["skin", number] = accessor
        return number

    num, position = len(rig.joints), rig.joints.astype(np.float32)
    nodes: list[dict[str, Any]] = []
    for bone, (name, above) in enumerate(zip(rig.names, rig.parents.tolist(), strict=True)):
        offset = position[bone] - (position[above] if above >= 0 else 0)
        nodes.append({"name": name, "translation": offset.tolist()})
        nodes[-1]["extras"] = {"tail": (rig.tails[bone] - rig.joints[bone]).tolist()}
        if children := np.flatnonzero(rig.parents == bone).tolist():
            nodes[-1]["children"] = children
    meshes = {mesh["name"]: number for number, mesh in enumerate(document["meshes"])}
    for number, row in enumerate(rows):
        name = f"mesh {number}"
        if name not in meshes:  # a part without faces
            continue
        attributes = document["meshes"][meshes[name]]["primitives"][0]["attributes"]
        bound, weights = _influences(rig.weights[row])
        weights = weights.astype(np.float32)
        weights /= weights.sum(axis=1, keepdims=True)
        attributes |= {"JOINTS_0": add(bound.astype(np.uint16), "VEC4"), "WEIGHTS_0": add(weights, "VEC4")}
        nodes.append({"name": name if len(rows) > 1 else "mesh", "mesh": meshes[name], "skin": 0})
    top = len(nodes)
    nodes.append({"name": "rig", "children": np.flatnonzero(rig.parents < 0).tolist()})
    inverse = np.tile(np.eye(4, dtype=np.float32), (num, 1, 1))
    inverse[:, 3, :3] = -position  # matrices of the format are column-major
    binds = add(inverse, "MAT4")
    document["nodes"], document["scenes"] = nodes, [{"nodes": list(range(num, top + 1))}]
    document["skins"] = [{"inverseBindMatrices": binds, "joints": list(range(num)), "skeleton": top}]
    document["asset"]["generator"] = f"msf_jax {VERSION}"
