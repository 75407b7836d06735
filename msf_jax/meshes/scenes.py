"""Files that place meshes in a scene: glTF, whose JSON is checked before trimesh loads it, and 3MF.

A small file can unpack to more than memory, name the same bytes many times, or show the same triangles many times: the
sums of what is loaded and shown are limited. What would be read as another mesh is refused by its name.

3MF is not read by trimesh, which leaves out an item with the part number of another, parts beyond some number of nested
parts, and objects that are not there.
"""

import io
import json
import math
import struct
import zipfile
from array import array
from pathlib import Path
from typing import IO, Any
from xml.etree import ElementTree

import numpy as np
import trimesh
from trimesh import resolvers

from msf_jax.meshes.formats import MeshArrays, decoded
from msf_jax.solid.geometry import unit

# Limits of the unpacked bytes: ratio to the packed bytes; bytes always allowed; the largest.
LARGEST_RATIO, SMALL_ARCHIVE, LARGEST_UNPACKED = 50, 10_000_000, 2**28
# Of the parts, at most: triangles of all instances, which take up to 0.8 GB with all attributes, and instances.
MOST_TRIANGLES, MOST_INSTANCES = 2_000_000, 20_000
MOST_ELEMENTS = 100_000  # of a 3MF but for vertices and triangles
MOST_TIMES = 2  # times that the triangles of a file may be shown, if they are over MOST_TRIANGLES
SHOWN = ""  # the parent of what a 3MF shows
SEVERAL = "it has several models, of which one is supported: export it as one"
JSON, BINARY = b"JSON", b"BIN\0"  # types of chunks
MOST_OBJECTS = 1_000_000  # objects and lists of the JSON, each of which takes some hundred bytes
FLOAT = 5126  # the number of float32 among glTF's component types, which are OpenGL's
SIZES = {5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, FLOAT: 4}  # bytes of each component type
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}  # components
MOST_READ = 4  # times that the bytes of all buffers may be read, over SMALL_ARCHIVE
OF_SKIN = ("_JOINTS_", "_WEIGHTS_", "_BINDS_")  # beginnings of the attributes of a skin, see `_name_skins`
FAN = 6  # mode of a primitive
WITH_VERTICES = "export it with plain vertices"
INSTANCES = "EXT_mesh_gpu_instancing"  # the extension of nodes that are shown many times
QUANTIZED = "KHR_mesh_quantization"  # positions are whole numbers, which the matrices of nodes scale
# Beginnings of the names of extensions that do not change the triangles.
HARMLESS = ("KHR_materials_", "KHR_texture_", "EXT_texture_", "KHR_lights_", "KHR_xmp", QUANTIZED)


def check_shown(instances: int, triangles: int, own: int) -> None:
    """Raise a ValueError if a file with ``own`` triangles shows too many."""
    if instances > MOST_INSTANCES or triangles > max(MOST_TRIANGLES, MOST_TIMES * own):
        raise ValueError(f"its parts have {instances} instances and {triangles} triangles, which is too many")


def meshes_of_3mf(path: Path) -> list[MeshArrays]:
    """Vertices and triangles of each object that the file at ``path`` shows, as it places them, turned right side out
    where it mirrors them.

    Raises:
        ValueError: the file would need too much memory for its size, has several models, or is damaged.
    """
    with zipfile.ZipFile(path) as archive:
        unpacked = sum(member.file_size for member in archive.infolist())
        most = min(max(LARGEST_RATIO * path.stat().st_size, SMALL_ARCHIVE), LARGEST_UNPACKED)
        if unpacked > most:
            raise ValueError(f"it unpacks to {unpacked} bytes: expected at most {most}")
        models = [name for name in archive.namelist() if name.lower().endswith(".model")]
        if len(models) != 1:  # their objects have the same ids
            raise ValueError(SEVERAL)
        with archive.open(models[0]) as stream:
            objects, parts = _model(stream)

    size = {name: max(map(len, both)) for name, both in objects.items()}  # vertices or triangles, which are more
    rest, shown, triangles, own = parts[SHOWN][::-1], [], 0, sum(size.values())
    while rest:
        name, matrix = rest.pop()
        if name not in objects:
            raise ValueError(f"it shows an object {name!r} that it does not have")
        shown.append((name, matrix))
        rest += [(part, matrix @ place) for part, place in reversed(parts[name])]
        triangles += size[name]
        check_shown(len(shown) + len(rest), triangles, own)  # also of an object that is a part of itself
    meshes = []
    for name, matrix in shown:
        vertices, faces = objects[name]
        if len(vertices) or len(faces):
            is_mirrored = np.linalg.det(matrix[:3, :3]) < 0
            meshes.append((vertices @ matrix[:3, :3].T + matrix[:3, 3], faces[:, ::-1] if is_mirrored else faces))
    return meshes


def _model(stream: IO[bytes]) -> tuple[dict[str, MeshArrays], dict[str, list[tuple[str, np.ndarray]]]]:
    """The objects of a 3MF model, and of each, and of `SHOWN`, its parts: their objects and places."""
    objects: dict[str, MeshArrays] = {}
    parts: dict[str, list[tuple[str, np.ndarray]]] = {SHOWN: []}
    vertices, corners, own, others, is_mesh = array("d"), array("q"), [], 0, False
    for event, element in ElementTree.iterparse(stream, events=("start", "end")):
        tag, attributes = element.tag.rpartition("}")[2], element.attrib
        if event == "start":
            others += tag not in ("vertex", "triangle")
            is_mesh |= tag == "mesh"
            if others > MOST_ELEMENTS:
                raise ValueError(f"it has over {MOST_ELEMENTS} elements that are no part of a mesh")
            continue
        match tag:
            case "mesh":
                is_mesh = False
            case "vertex" if is_mesh:  # slices have some, too
                vertices.extend(float(attributes[key]) for key in ("x", "y", "z"))
            case "triangle" if is_mesh:
                corners.extend(int(attributes[key]) for key in ("v1", "v2", "v3"))
            case "component" | "item":
                if any(key.endswith("path") for key in attributes):
                    raise ValueError(SEVERAL)
                matrix = np.eye(4)
                if "transform" in attributes:  # rows, without the last column
                    matrix[:3] = np.array(attributes["transform"].split(), dtype=np.float64).reshape(4, 3).T
                (own if tag == "component" else parts[SHOWN]).append((attributes["objectid"], matrix))
            case "object":
                name = attributes["id"]
                if name in parts:
                    raise ValueError(f"it has an object {name!r} twice")
                objects[name] = np.array(vertices).reshape(-1, 3), np.array(corners).reshape(-1, 3)
                parts[name] = own
                vertices, corners, own = array("d"), array("q"), []
        element.clear()
    return objects, parts


def meshes_of_gltf(path: Path) -> list[trimesh.Trimesh]:
    """The meshes in the file at ``path``, with all their attributes, each as the file shows it: a mesh with a skin is
    where its joints hold it, wherever its own node is.

    Raises:
        ValueError, or another error of damage: the file would be read as another mesh, or would need much more memory
            than its bytes.
    """
    content, rest = path.read_bytes(), b""
    is_binary = path.suffix.lower() == ".glb"
    if is_binary:
        content, rest = _chunks(content)
    if content.count(b"{") + content.count(b"[") > MOST_OBJECTS:
        raise ValueError(f"its JSON has over {MOST_OBJECTS} objects")
    document = json.loads(decoded(content))
    _check_kinds(document)
    _check_sizes(document, path.parent, len(rest))
    _name_skins(document)
    content = json.dumps(document).encode()
    if is_binary:
        content += b" " * (-len(content) % 4)
        size = struct.pack("<III", 2, 20 + len(content) + len(rest), len(content))
        content = b"glTF" + size + JSON + content + rest
    resolver = resolvers.FilePathResolver(str(path))
    scene = trimesh.load_scene(io.BytesIO(content), file_type=path.suffix[1:].lower(), resolver=resolver, process=False)
    return _placed(scene, document)


def _name_skins(document: dict[str, Any]) -> None:
    """Name what trimesh leaves out so that it reads it: nodes by their numbers, and a skin's numbers as attributes, for
    which it takes names with an underscore."""
    nodes, meshes, skins = (document.get(name, []) for name in ("nodes", "meshes", "skins"))
    for number, node in enumerate(nodes):
        node["name"] = str(number)
    for node in nodes:
        for primitive in meshes[node["mesh"]]["primitives"] if {"mesh", "skin"} <= node.keys() else []:
            given, skin = primitive["attributes"], skins[_whole(node["skin"])]
            given |= {f"_{name}": of for name, of in given.items() if name.startswith(("JOINTS_", "WEIGHTS_"))}
            if "inverseBindMatrices" in skin:
                given[f"_BINDS_{node['skin']}"] = _whole(skin["inverseBindMatrices"])


def _placed(scene: trimesh.Scene, document: dict[str, Any]) -> list[trimesh.Trimesh]:
    """The meshes of a scene; unlike `trimesh.Scene.dump`, it keeps their normals."""
    parts, taken, matrices = [], {}, {}
    for name, mesh in scene.geometry.items():  # before meshes are copied, for each node that shows them
        named = [key for key in mesh.vertex_attributes if key.startswith(OF_SKIN)]
        taken[name] = {key: np.asarray(mesh.vertex_attributes.pop(key)) for key in named}
    for node in scene.graph.nodes_geometry:
        transform, name = scene.graph[node]
        part, given = scene.geometry[name].copy(include_cache=True), taken[name]
        skin = document["nodes"][int(node.split("_")[0])].get("skin")  # "3_a8f" is a primitive of node 3
        if not isinstance(part, trimesh.Trimesh):
            continue
        if skin is None or "_JOINTS_0" not in given:
            parts.append(part.apply_transform(transform))
            continue
        if skin not in matrices:
            joints = np.array([scene.graph[str(joint)][0] for joint in document["skins"][skin]["joints"]])
            binds = given.get(f"_BINDS_{skin}", np.tile(np.eye(4), (len(joints), 1, 1)))[: len(joints)]
            matrices[skin] = joints @ binds.swapaxes(1, 2)  # matrices of the format are column-major
        parts.append(_held(part, given, matrices[skin]))
    return parts


def _held(mesh: trimesh.Trimesh, given: dict[str, np.ndarray], matrices: np.ndarray) -> trimesh.Trimesh:
    """``mesh`` where its joints hold it: each vertex by the mean of their ``matrices`` (J, 4, 4), by its weights."""
    weights = np.concatenate([of for name, of in sorted(given.items()) if name.startswith("_WEIGHTS_")], axis=1)
    joint = np.concatenate([of for name, of in sorted(given.items()) if name.startswith("_JOINTS_")], axis=1)
    weights[~weights.any(axis=1), 0] = 1
    weights = weights / weights.sum(axis=1, keepdims=True, dtype=np.float64)  # they may be whole numbers
    mean = np.zeros((len(weights), 4, 4))
    for weight, of in zip(weights.T, joint.T.astype(int), strict=True):
        mean += weight[:, None, None] * matrices[of]
    normals = mesh.vertex_normals if has_normals(mesh) else None
    mesh.vertices = np.einsum("vij,vj->vi", mean[:, :3, :3], mesh.vertices) + mean[:, :3, 3]
    if normals is not None:
        mesh.vertex_normals = unit(np.einsum("vij,vj->vi", mean[:, :3, :3], normals))
    return mesh


def has_normals(mesh: trimesh.Trimesh) -> bool:
    """Whether the file or the caller has given normals of vertices, or trimesh has computed them."""
    return "vertex_normals" in mesh._cache.cache


def _chunks(content: bytes) -> tuple[bytes, bytes]:
    """The JSON of a binary file, and what follows it: the chunk of its buffer."""
    size = int.from_bytes(content[12:16], "little")
    if content[:4] != b"glTF" or content[16:20] != JSON or 20 + size > len(content):
        raise ValueError("it is cut off, or no binary glTF")
    rest = content[20 + size :]
    if rest[4:8] == BINARY and 8 + int.from_bytes(rest[:4], "little") > len(rest):
        raise ValueError("it is cut off: its buffer ends before it should")
    return content[20 : 20 + size], rest


def _check_kinds(document: dict[str, Any]) -> None:
    """Refuse what would not be read as it is meant."""
    meshes, nodes, required = (document.get(name, []) for name in ("meshes", "nodes", "extensionsRequired"))
    for name in [*required, *(INSTANCES for node in nodes if INSTANCES in node.get("extensions", {}))]:
        if not str(name).startswith(HARMLESS):
            raise ValueError(f"it needs {name}, which is not supported: export it without it")
    if any(any(one.get("weights", [])) for one in (*meshes, *nodes)):
        raise ValueError(f"it has morph targets with weights, which are not supported: {WITH_VERTICES}")
    children = [_whole(child) for node in nodes for child in node.get("children", [])]
    if len(set(children)) < len(children):
        raise ValueError("a node has two parents")
    for primitive in (one for mesh in meshes for one in mesh["primitives"]):
        if primitive.get("mode") == FAN:
            raise ValueError("it has a triangle fan, which is not supported: export it with triangles")
        named = {"POSITION": primitive["attributes"]["POSITION"]}
        named |= {"indices": primitive["indices"]} if "indices" in primitive else {}
        for name, number in named.items():
            accessor = document["accessors"][_whole(number)]
            kind = accessor["componentType"]
            is_wrong = (kind == FLOAT) == (name == "indices") and not (name == "POSITION" and QUANTIZED in required)
            for is_so, what in (
                ("sparse" in accessor, "is a sparse accessor, which is not supported"),
                ("bufferView" not in accessor, "has no bufferView, and so no data"),
                (is_wrong, f"has components of type {kind}, which the format forbids"),
                (accessor.get("normalized"), "is normalized integers, which is not supported"),
            ):
                if is_so:
                    raise ValueError(f"its {name} {what}: {WITH_VERTICES}")


def _check_sizes(document: dict[str, Any], folder: Path, binary: int) -> None:
    """Refuse views and accessors that have many more bytes than all buffers, of which ``binary`` are in the file, and
    too much in what is shown. That each has its bytes is trimesh's to check."""
    views, accessors, nodes = (document.get(name, []) for name in ("bufferViews", "accessors", "nodes"))
    there = binary
    for uri in (buffer.get("uri", "") for buffer in document.get("buffers", [])):
        if uri.startswith("data:"):
            there += len(uri)
        elif uri and (folder / uri).is_file():
            there += (folder / uri).stat().st_size
    for one in (*views, *accessors):  # trimesh would count those below 0 from the end
        for name in ("buffer", "bufferView", "byteOffset", "byteLength", "byteStride", "count"):
            _whole(one.get(name, 0))
    widths = [one["count"] * WIDTHS[one["type"]] * SIZES[one["componentType"]] for one in accessors]
    for what, size in (("views", sum(view["byteLength"] for view in views)), ("accessors", sum(widths))):
        if size > MOST_READ * there + SMALL_ARCHIVE:
            raise ValueError(f"its {what} have {size} bytes, but its buffers {there}")
    sizes = []  # of each mesh, its primitives, and their vertices or triangles, whichever are more
    for mesh in document.get("meshes", []):
        named = [(one["attributes"]["POSITION"], one.get("indices")) for one in mesh["primitives"]]
        counts = [(accessors[at]["count"], 0 if of is None else accessors[of]["count"] // 3) for at, of in named]
        sizes.append((len(named), sum(map(max, counts))))
    for one in (sizes, [sizes[_whole(node["mesh"])] for node in nodes if "mesh" in node]):
        check_shown(sum(num for num, _ in one), sum(size for _, size in one), sum(each["count"] for each in accessors))


def _whole(value: Any) -> int:
    """``value``, if it is a count or an index."""
    if isinstance(value, bool) or not isinstance(value, int | float) or value < 0 or math.floor(value) != value:
        raise ValueError(f"it has {str(value)[:30]!r} for a count or an index")
    return int(value)
