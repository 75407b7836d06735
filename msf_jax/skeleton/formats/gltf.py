"""A mesh skinned to its curve, as one binary glTF 2.0 file: every node a joint, every vertex bound to its node's.

Joints form the tree that an SWC file has, too: loops are cut. Turning or moving a joint moves the part of the surface
that is mapped to it and to what hangs on it. The format's numbers are float32: far from the origin, they count from the
middle of the curve, where both the mesh and the curve are placed.
"""

import json
import struct
from typing import TYPE_CHECKING, Any

import numpy as np

from msf_jax.base.errors import ConfigError
from msf_jax.host.curve import branches
from msf_jax.host.mesh import reading

if TYPE_CHECKING:
    from msf_jax.skeleton.skeleton import Skeleton

MOST_JOINTS = 65535
FAR = 100  # of the curve's size from the origin
FLOAT, USHORT, UINT = 5126, 5123, 5125  # component types of the format
ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER = 34962, 34963


def skinned(skeleton: "Skeleton", mesh: Any) -> bytes:
    """The bytes of a ``.glb`` file with ``mesh``, as `skeletonize` took it, bound to ``skeleton``.

    Raises:
        ConfigError: the curve has more nodes than the format numbers.
        MeshError: the mesh cannot be read, or has not the vertices that the curve's map speaks of.
    """
    vertices, faces = reading.read(mesh, finite=False)
    reading.check_map(skeleton.mesh_map, len(vertices))
    vertices = np.where(np.isfinite(vertices), vertices, 0.0)
    num = len(skeleton.vertices)
    if num > MOST_JOINTS:
        raise ConfigError(f"the curve has {num} nodes: glTF joins a mesh to at most {MOST_JOINTS}; resample it first")
    parent = branches.tree(num, skeleton.edges, skeleton.roots)
    order = np.array(list(parent))  # parents first
    children: list[list[int]] = [[] for _ in range(num)]
    for node, above in parent.items():
        if above >= 0:
            children[above].append(node)
    low, high = skeleton.vertices.min(axis=0), skeleton.vertices.max(axis=0)
    size = np.linalg.norm(high - low) + 2 * skeleton.radii.max()
    is_far = np.linalg.norm(low + high) / 2 > FAR * size
    middle = (low + high) / 2 if is_far else np.zeros(3)
    placed = {"translation": middle.tolist()} if is_far else {}
    position = (skeleton.vertices - middle).astype(np.float32)
    joints = []
    for node in range(num):
        above = parent[node]
        offset = position[node] - (position[above] if above >= 0 else 0)
        joint: dict[str, Any] = {"name": f"node {node}", "translation": offset.tolist()}
        joint["extras"] = {"radius": float(skeleton.radii[node])}
        joints.append(joint | ({"children": children[node]} if children[node] else {}))
    inverse = np.tile(np.eye(4, dtype=np.float32), (num, 1, 1))
    inverse[:, 3, :3] = -position  # columns come first in the format
    bound = np.zeros((len(vertices), 4), dtype=np.uint16)
    bound[:, 0] = skeleton.mesh_map
    weights = np.tile(np.array([1, 0, 0, 0], dtype=np.float32), (len(vertices), 1))
    views: list[dict[str, Any]] = []
    accessors: list[dict[str, Any]] = []
    content = bytearray()

    def add(array: np.ndarray, kind: str, component: int, target: int | None = None) -> int:
        data = np.ascontiguousarray(array).tobytes()
        view: dict[str, Any] = {"buffer": 0, "byteOffset": len(content), "byteLength": len(data)}
        views.append(view | ({"target": target} if target else {}))
        content.extend(data + b"\0" * (-len(data) % 4))
        accessors.append({"bufferView": len(views) - 1, "componentType": component, "count": len(array), "type": kind})
        return len(accessors) - 1

    points = (vertices - middle).astype(np.float32)
    at = add(points, "VEC3", FLOAT, ARRAY_BUFFER)
    accessors[at] |= {"min": points.min(axis=0).tolist(), "max": points.max(axis=0).tolist()}
    attributes = {
        "POSITION": at,
        "JOINTS_0": add(bound, "VEC4", USHORT, ARRAY_BUFFER),
        "WEIGHTS_0": add(weights, "VEC4", FLOAT, ARRAY_BUFFER),
    }
    corners = add(faces.astype(np.uint32).ravel(), "SCALAR", UINT, ELEMENT_ARRAY_BUFFER)
    binds = add(inverse, "MAT4", FLOAT)
    roots = [int(node) for node in order if parent[int(node)] < 0]
    document = {
        "asset": {"version": "2.0", "generator": "msf_jax"},
        "scene": 0,
        "scenes": [{"nodes": [num, num + 1]}],
        "nodes": [
            *joints,
            {"name": "mesh", "mesh": 0, "skin": 0, **placed},
            {"name": "curve skeleton", "children": roots, **placed},
        ],
        "meshes": [{"primitives": [{"attributes": attributes, "indices": corners, "mode": 4}]}],
        "skins": [{"inverseBindMatrices": binds, "joints": list(range(num)), "skeleton": num + 1}],
        "buffers": [{"byteLength": len(content)}],
        "bufferViews": views,
        "accessors": accessors,
    }
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text
    chunks += struct.pack("<II", len(content), 0x004E4942) + bytes(content)
    return struct.pack("<III", 0x46546C67, 2, 12 + len(chunks)) + chunks
