"""A mesh on the bones of a rig, as one binary glTF 2.0 file, with its materials, UVs, normals and colours.

trimesh writes the mesh, and this module adds the skin: joints and weights. A vertex of the format has one of each
attribute, so a vertex with several, at a seam, is written several times. A joint has the name of its bone,
and the end of the bone in its "extras". Numbers in the format are float32, so a mesh should be near the origin.
"""

from typing import TYPE_CHECKING, Any

import numpy as np
import trimesh
from trimesh.exchange.gltf import export_glb

from msf_jax.base.errors import ConfigError
from msf_jax.base.version import VERSION
from msf_jax.meshes import reading, scenes
from msf_jax.meshes.reading import MeshLike
from msf_jax.solid.geometry import repeated

if TYPE_CHECKING:
    from msf_jax.skeleton.rigging.rig import Rig


def of_rig(rig: "Rig", mesh: "MeshLike") -> bytes:
    """The bytes of a ``.glb`` file with ``mesh``, as `skeletonize` took it, on the bones of ``rig``.

    Raises:
        ConfigError: there are more bones than the format can number.
        MeshError: the mesh cannot be read, or has another number of vertices than the rig.
    """
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


def _add_skin(document: dict[str, Any], data: Any, rig: "Rig", rows: list[np.ndarray]) -> None:
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
        bound, weights = _four_of_each(rig.weights[row])
        attributes |= {"JOINTS_0": add(bound, "VEC4"), "WEIGHTS_0": add(weights, "VEC4")}
        nodes.append({"name": name if len(rows) > 1 else "mesh", "mesh": meshes[name], "skin": 0})
    top = len(nodes)
    nodes.append({"name": "rig", "children": np.flatnonzero(rig.parents < 0).tolist()})
    inverse = np.tile(np.eye(4, dtype=np.float32), (num, 1, 1))
    inverse[:, 3, :3] = -position  # matrices of the format are column-major
    binds = add(inverse, "MAT4")
    document["nodes"], document["scenes"] = nodes, [{"nodes": list(range(num, top + 1))}]
    document["skins"] = [{"inverseBindMatrices": binds, "joints": list(range(num)), "skeleton": top}]
    document["asset"]["generator"] = f"msf_jax {VERSION}"


def _four_of_each(rows: Any) -> tuple[np.ndarray, np.ndarray]:
    """The joints (v, 4) uint16 and weights (v, 4) float32 in the sparse ``rows`` (v, B) of at most four values."""
    bound, weights = np.zeros((rows.shape[0], 4), dtype=np.uint16), np.zeros((rows.shape[0], 4), dtype=np.float32)
    place = repeated(np.diff(rows.indptr))
    bound[place], weights[place] = rows.indices, rows.data
    return bound, weights / weights.sum(axis=1, keepdims=True)
