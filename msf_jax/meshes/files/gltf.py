"""Checks of a glTF file, ``.gltf`` or ``.glb``, before trimesh loads it: from its JSON alone.

The sums of what is loaded and shown are limited: a small file can name the same bytes many times. What trimesh would
leave out, so that another mesh came out, is refused by its name.
"""

import json
import math
from pathlib import Path
from typing import Any

from msf_jax.meshes.files.text import decoded
from msf_jax.meshes.files.unpacking import SMALL_ARCHIVE, check_shown

JSON, BINARY = b"JSON", b"BIN\0"  # types of chunks
MOST_OBJECTS = 1_000_000  # objects and lists of the JSON, each of which takes some hundred bytes
FLOAT = 5126  # the number of float32 among glTF's component types, which are OpenGL's
SIZES = {5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, FLOAT: 4}  # bytes of each component type
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}  # components
MOST_TIMES = 4  # times that the bytes of all buffers may be read, over SMALL_ARCHIVE
FAN = 6  # mode of a primitive
WITH_VERTICES = "export it with plain vertices"
# Extensions that change the triangles, and what to do about each.
UNREAD = {
    "KHR_draco_mesh_compression": "export it without Draco compression",
    "EXT_meshopt_compression": "export it without meshopt compression",
    "KHR_meshopt_compression": "export it without meshopt compression",
    "EXT_mesh_gpu_instancing": "export its instances as nodes",
}
# Beginnings of the names of extensions that do not change them.
QUANTIZED = "KHR_mesh_quantization"  # positions are whole numbers, which the matrices of nodes scale
HARMLESS = ("KHR_materials_", "KHR_texture_", "EXT_texture_", "KHR_lights_", "KHR_xmp", QUANTIZED)


def check(path: Path) -> None:
    """Raise a ValueError, or another error of damage, if the file at ``path`` would be read as another mesh, or would
    need much more memory than its bytes."""
    content, binary = path.read_bytes(), 0
    if path.suffix.lower() == ".glb":
        content, binary = _chunks(content)
    if content.count(b"{") + content.count(b"[") > MOST_OBJECTS:
        raise ValueError(f"its JSON has over {MOST_OBJECTS} objects")
    document = json.loads(decoded(content))
    _check_extensions(document)
    _check_bytes(document, path.parent, binary)
    _check_shown(document)
    for mesh in document.get("meshes", []):
        for primitive in mesh["primitives"]:
            _check_primitive(document, primitive)


def _chunks(content: bytes) -> tuple[bytes, int]:
    """The JSON of a binary file, and the number of bytes of its buffer."""
    size = int.from_bytes(content[12:16], "little")
    if content[:4] != b"glTF" or content[16:20] != JSON or 20 + size > len(content):
        raise ValueError("it is cut off, or no binary glTF")
    place, binary = 20 + size, 0
    if content[place + 4 : place + 8] == BINARY:
        binary = int.from_bytes(content[place : place + 4], "little")
        if place + 8 + binary > len(content):
            raise ValueError("it is cut off: its buffer ends before it should")
    return content[20 : 20 + size], binary


def _check_extensions(document: dict[str, Any]) -> None:
    """Refuse what the file says that its reader must know, and is not known here; and what is shown otherwise."""
    named = list(document.get("extensionsRequired", []))
    named += [name for node in document.get("nodes", []) for name in node.get("extensions", {}) if name in UNREAD]
    for name in named:
        if not str(name).startswith(HARMLESS):
            raise ValueError(f"it needs {name}, which is not supported: {UNREAD.get(name, 'export it without it')}")
    for one in [*document.get("meshes", []), *document.get("nodes", [])]:
        if any(one.get("weights", [])):
            raise ValueError(f"it has morph targets with weights, which are not supported: {WITH_VERTICES}")


def _check_bytes(document: dict[str, Any], folder: Path, binary: int) -> None:
    """Refuse views and accessors that have many more bytes than all buffers, of which ``binary`` are in the file. That
    each has its bytes is trimesh's to check."""
    views, accessors, there = document.get("bufferViews", []), document.get("accessors", []), binary
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
        if size > MOST_TIMES * there + SMALL_ARCHIVE:
            raise ValueError(f"its {what} have {size} bytes, but its buffers {there}")


def _check_primitive(document: dict[str, Any], primitive: dict[str, Any]) -> None:
    """Refuse triangles that are not read as they are meant."""
    if primitive.get("mode") == FAN:
        raise ValueError("it has a triangle fan, which is not supported: export it with triangles")
    is_quantized = QUANTIZED in document.get("extensionsRequired", [])
    named = {"POSITION": primitive["attributes"]["POSITION"]}
    named |= {"indices": primitive["indices"]} if "indices" in primitive else {}
    for name, number in named.items():
        accessor = document["accessors"][_whole(number)]
        if "sparse" in accessor:
            raise ValueError(f"its {name} is a sparse accessor, which is not supported: {WITH_VERTICES}")
        if "bufferView" not in accessor:
            raise ValueError(f"its {name} has no bufferView, and so no data: {WITH_VERTICES}")
        is_float = accessor["componentType"] == FLOAT
        if is_float == (name == "indices") and not (name == "POSITION" and is_quantized):
            raise ValueError(f"its {name} has components of type {accessor['componentType']}, which the format forbids")
        if accessor.get("normalized"):
            raise ValueError(f"its {name} is normalized integers, which is not supported: {WITH_VERTICES}")


def _check_shown(document: dict[str, Any]) -> None:
    """Refuse too much in the primitives, by the nodes that show them."""
    nodes, accessors = document.get("nodes", []), document.get("accessors", [])
    sizes = []  # of each mesh, its vertices or triangles, whichever are more
    for mesh in document.get("meshes", []):
        named = [(one["attributes"]["POSITION"], one.get("indices")) for one in mesh["primitives"]]
        counts = [(accessors[at]["count"], 0 if of is None else accessors[of]["count"] // 3) for at, of in named]
        sizes.append((len(named), sum(map(max, counts))))
    shown = [sizes[_whole(node["mesh"])] for node in nodes if "mesh" in node]
    for one in (sizes, shown):
        check_shown(sum(num for num, _ in one), sum(size for _, size in one), sum(each["count"] for each in accessors))
    children = [_whole(child) for node in nodes for child in node.get("children", [])]
    if len(set(children)) < len(children):
        raise ValueError("a node has two parents")


def _whole(value: Any) -> int:
    """``value``, if it is a count or an index."""
    if isinstance(value, bool) or not isinstance(value, int | float) or value < 0 or math.floor(value) != value:
        raise ValueError(f"it has {str(value)[:30]!r} for a count or an index")
    return int(value)
