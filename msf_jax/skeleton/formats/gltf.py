"""A mesh on the bones of a rig, as one binary glTF 2.0 file, with its materials, UVs, normals and colours.

trimesh writes the mesh, and this module adds the skin: joints and weights. A vertex of the format has one of each
attribute, so a vertex with several, at a seam or a crease, is written several times. A joint has the name of its bone,
and the end of the bone in its "extras". Numbers in the format are float32. So coordinates of a mesh far from the origin
are relative to its centre.
"""

import json
import struct
from typing import TYPE_CHECKING, Any

import numpy as np
import trimesh
from trimesh.exchange.gltf import export_glb

from msf_jax.base.errors import ConfigError
from msf_jax.base.version import VERSION
from msf_jax.meshes import reading, shading
from msf_jax.meshes.reading import MeshLike

if TYPE_CHECKING:
    from msf_jax.skeleton.rigging.rig import Rig
    from msf_jax.skeleton.skeleton import Skeleton

MOST_JOINTS = 65535  # joints that the format can number
FAR_FROM_ORIGIN = 100  # bounding-box diagonals from the origin: beyond, coordinates are relative to the mesh's centre
AT_ONCE = 4  # influences in one set of attributes of the format
FLOAT, USHORT = 5126, 5123  # component types of the format
ARRAY_BUFFER = 34962  # buffer target of the format
JSON, BINARY = 0x4E4F534A, 0x004E4942  # types of chunks in the format


def skinned(skeleton: "Skeleton", mesh: "MeshLike") -> bytes:
    """The bytes of a ``.glb`` file with ``mesh``, as `skeletonize` took it, on the bones of ``skeleton``.

    Raises:
        MeshError: the mesh cannot be read, or has another number of vertices than the curve's map.
    """
    return of_rig(skeleton.rig(mesh=mesh), mesh)


def of_rig(rig: "Rig", mesh: "MeshLike") -> bytes:
    """The bytes of a ``.glb`` file with ``mesh``, as `skeletonize` took it, on the bones of ``rig``.

    Raises:
        ConfigError: there are more bones than the format can number.
        MeshError: the mesh cannot be read, or has another number of vertices than the rig.
    """
    if len(rig.joints) > MOST_JOINTS:
        raise ConfigError(f"the rig has {len(rig.joints)} bones: glTF can number at most {MOST_JOINTS}")
    parts, rows, num = reading.parts_with_seams(mesh)
    reading.check_map(np.empty(rig.num_vertices), num)
    points = np.concatenate([part.vertices for part in parts])
    points = points[np.isfinite(points).all(axis=1)]
    low, high = points.min(axis=0), points.max(axis=0)
    is_far = np.linalg.norm(low + high) / 2 > FAR_FROM_ORIGIN * np.linalg.norm(high - low)
    middle = (low + high) / 2 if is_far else np.zeros(3)
    for part in parts:
        part.vertices = np.where(np.isfinite(part.vertices), part.vertices, middle)
    rows = _shaded(parts, rows)
    document, content = _plain(parts, middle)
    start = _add_joints(document, rig, middle)
    _add_skin(document, content, rig, rows, start, middle)
    return _packed(document, bytes(content))


def _shaded(parts: list[trimesh.Trimesh], rows: list[np.ndarray]) -> list[np.ndarray]:
    """Give normals to those of ``parts`` that have none: without them, viewers show every face flat. Returns ``rows``
    with those of the vertices that are new, at creases."""
    first = np.cumsum([0, *(len(part.vertices) for part in parts)])
    faces = np.concatenate([part.faces + start for part, start in zip(parts, first[:-1], strict=True)])
    normals, fans = shading.corner_normals(np.concatenate([part.vertices for part in parts]), faces)
    found, last = [], 0
    for part, row in zip(parts, rows, strict=True):
        span = slice(last, last + len(part.faces))
        last = span.stop
        if not len(part.faces) or reading.has_normals(part):
            found.append(row)
            continue
        corners = np.stack([part.faces.ravel(), fans[span].ravel()], axis=1)
        pairs, at, inverse = np.unique(corners, axis=0, return_index=True, return_inverse=True)
        part.update_vertices(pairs[:, 0], np.arange(len(part.vertices)))  # this keeps colours and UVs
        part.faces = inverse.reshape(-1, 3)
        part.vertex_normals = normals[span].reshape(-1, 3)[at]
        found.append(row[pairs[:, 0]])
    return found


def _plain(parts: list[trimesh.Trimesh], middle: np.ndarray) -> tuple[dict[str, Any], bytearray]:
    """The JSON document and the binary content of a file with only the ``parts``, in their order."""
    scene = trimesh.Scene()
    for number, part in enumerate(parts):
        if middle.any():
            part.apply_translation(-middle)  # this keeps normals
        part.metadata.clear()
        scene.add_geometry(part, node_name=f"mesh {number}", geom_name=f"mesh {number}")
    data = export_glb(scene)
    size = struct.unpack("<I", data[12:16])[0]
    document = json.loads(data[20 : 20 + size])
    return document, bytearray(data[28 + size :])


def _add_joints(document: dict[str, Any], rig: "Rig", middle: np.ndarray) -> int:
    """Append the joints to the document's nodes. Returns the index of the first."""
    start = len(document["nodes"])
    position = (rig.joints - middle).astype(np.float32)
    for bone, (name, above) in enumerate(zip(rig.names, rig.parents.tolist(), strict=True)):
        offset = position[bone] - (position[above] if above >= 0 else 0)
        joint: dict[str, Any] = {"name": name, "translation": offset.tolist()}
        joint["extras"] = {"tail": (rig.tails[bone] - rig.joints[bone]).tolist()}
        children = (start + np.flatnonzero(rig.parents == bone)).tolist()
        document["nodes"].append(joint | ({"children": children} if children else {}))
    return start


def _add_skin(
    document: dict[str, Any], content: bytearray, rig: "Rig", rows: list[np.ndarray], start: int, middle: Any
) -> None:
    """Bind the nodes of parts to the joints, whose nodes begin at index ``start``. ``rows`` are those of the rig's
    weights, for the vertices of each part."""
    num = len(rig.joints)
    placed = {"translation": middle.tolist()} if middle.any() else {}
    meshes = {mesh["name"]: number for number, mesh in enumerate(document["meshes"])}
    shown = []
    for number, row in enumerate(rows):
        mesh = meshes.get(f"mesh {number}")
        if mesh is None:  # a part without faces
            continue
        attributes = document["meshes"][mesh]["primitives"][0]["attributes"]
        for which, (bound, weights) in enumerate(_sets(rig.weights[row])):
            attributes[f"JOINTS_{which}"] = _add(document, content, bound, "VEC4", USHORT, ARRAY_BUFFER)
            attributes[f"WEIGHTS_{which}"] = _add(document, content, weights, "VEC4", FLOAT, ARRAY_BUFFER)
        shown.append(start + num + len(shown))
        document["nodes"].append({"name": f"mesh {number}" if len(rows) > 1 else "mesh", "mesh": mesh, "skin": 0})
        document["nodes"][-1] |= placed
    inverse = np.tile(np.eye(4, dtype=np.float32), (num, 1, 1))
    inverse[:, 3, :3] = -(rig.joints - middle).astype(np.float32)  # matrices of the format are column-major
    binds = _add(document, content, inverse, "MAT4", FLOAT)
    roots = (start + np.flatnonzero(rig.parents < 0)).tolist()
    document["nodes"].append({"name": "rig", "children": roots, **placed})
    top = len(document["nodes"]) - 1
    document["skins"] = [{"inverseBindMatrices": binds, "joints": list(range(start, start + num)), "skeleton": top}]
    document["scenes"], document["scene"] = [{"nodes": [*shown, top]}], 0
    document["asset"] = {"version": "2.0", "generator": f"msf_jax {VERSION}"}
    _drop_nodes(document, start)
    document["buffers"] = [{"byteLength": len(content)}]


def _sets(rows: Any) -> list[tuple[np.ndarray, np.ndarray]]:
    """Joints and weights in sets of four, the largest weights first: (v, 4) uint16 and (v, 4) float32 each."""
    num, most = rows.shape[0], int(np.diff(rows.indptr).max(initial=1))
    width = -(-most // AT_ONCE) * AT_ONCE
    bound, weights = np.zeros((num, width), dtype=np.uint16), np.zeros((num, width), dtype=np.float32)
    row = np.repeat(np.arange(num), np.diff(rows.indptr))
    order = np.lexsort((-rows.data, row))
    rank = np.arange(len(row)) - np.repeat(rows.indptr[:-1], np.diff(rows.indptr))
    bound[row, rank], weights[row, rank] = rows.indices[order], rows.data[order]
    weights /= weights.sum(axis=1, keepdims=True)
    return [(bound[:, k : k + AT_ONCE], weights[:, k : k + AT_ONCE]) for k in range(0, width, AT_ONCE)]


def _add(
    document: dict[str, Any],
    content: bytearray,
    array: np.ndarray,
    kind: str,
    component: int,
    target: int | None = None,
) -> int:
    """Append ``array`` to the binary content. Returns the index of its accessor."""
    content.extend(b"\0" * (-len(content) % 4))
    data = np.ascontiguousarray(array).tobytes()
    view: dict[str, Any] = {"buffer": 0, "byteOffset": len(content), "byteLength": len(data)}
    document["bufferViews"].append(view | ({"target": target} if target else {}))
    content.extend(data)
    number = len(document["bufferViews"]) - 1
    document["accessors"].append({"bufferView": number, "componentType": component, "count": len(array), "type": kind})
    return len(document["accessors"]) - 1


def _drop_nodes(document: dict[str, Any], start: int) -> None:
    """Remove the nodes before ``start``: those of the plain file, which the skinned nodes replace."""
    document["nodes"] = document["nodes"][start:]
    for node in document["nodes"]:
        if "children" in node:
            node["children"] = [child - start for child in node["children"]]
    for skin in document["skins"]:
        skin["joints"], skin["skeleton"] = [joint - start for joint in skin["joints"]], skin["skeleton"] - start
    document["scenes"] = [{"nodes": [node - start for node in document["scenes"][0]["nodes"]]}]


def _packed(document: dict[str, Any], content: bytes) -> bytes:
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    content += b"\0" * (-len(content) % 4)
    chunks = struct.pack("<II", len(text), JSON) + text + struct.pack("<II", len(content), BINARY) + content
    return struct.pack("<III", 0x46546C67, 2, 12 + len(chunks)) + chunks
