"""Strict parsers of OBJ, PLY, OFF and GLB with NumPy only, to judge `msf_jax.meshes.reading`: for `fuzz`.

They share no code with it. Each gives the corners of all triangles, (F, 3, 3), in the order of the file, or None for a
file that the format does not allow. They know what `fuzz.originals` has: triangles, in GLB also nodes with matrices.
"""

import json
import re
import struct

import numpy as np

INTEGER = re.compile(r"[-+]?[0-9]+")
MARKS = ((b"\xef\xbb\xbf", "utf-8"), (b"\xff\xfe", "utf-16-le"), (b"\xfe\xff", "utf-16-be"))
NUMPY = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I", "float": "f", "double": "d"}
COMPONENT = {5121: "<u1", 5123: "<u2", 5125: "<u4", 5126: "<f4"}


class Bad(Exception):
    """The file is not of the format."""


def need(is_right: object) -> None:
    """Raise `Bad` unless ``is_right``."""
    if not is_right:
        raise Bad


def text_of(content: bytes) -> str:
    """By its mark, or UTF-8, or Latin-1."""
    for mark, encoding in MARKS:
        if content.startswith(mark):
            return content[len(mark) :].decode(encoding)
    try:
        return content.decode("utf-8")
    except UnicodeDecodeError:
        return content.decode("latin-1")


def whole(word: str) -> int:
    """An integer."""
    need(INTEGER.fullmatch(word))
    return int(word)


def cornered(vertices: list[list[float]], faces: list[list[int]]) -> np.ndarray:
    """The corners of ``faces``."""
    points, index = np.array(vertices, dtype=float).reshape(-1, 3), np.array(faces, dtype=object).reshape(-1, 3)
    need(len(index) and all(0 <= corner < len(points) for corner in index.ravel()))
    return points[index.astype(int)]


def obj(content: bytes) -> np.ndarray:
    """Positions of corners; indices count from 1, or back from the line that they are in."""
    vertices, faces = [], []
    for line in re.split(r"\r\n|\n|\r", re.sub(r"\\(\r\n|\n)", " ", text_of(content))):
        words = line.split("#")[0].split()
        if words[:1] == ["v"]:
            vertices.append([float(word) for word in words[1:4]])
            need(len(vertices[-1]) == 3)
        elif words[:1] == ["f"]:
            face = [whole(word.split("/")[0]) for word in words[1:]]
            need(len(face) == 3 and 0 not in face)
            faces.append([corner - 1 if corner > 0 else len(vertices) + corner for corner in face])
            need(min(faces[-1]) >= 0)
    return cornered(vertices, faces)


def off(content: bytes) -> np.ndarray:
    """Word by word, without comments; no colours."""
    words = " ".join(line.split("#")[0] for line in re.split(r"\r\n|\n|\r", text_of(content))).split()
    need(words and words[0].upper() == "OFF")
    num, num_faces = whole(words[1]), whole(words[2])
    need(num >= 0 and num_faces >= 0)
    data = words[4:]
    if len(data) != 3 * num + 4 * num_faces:
        data = words[3:]  # without a count of edges
    need(len(data) == 3 * num + 4 * num_faces)
    vertices = [[float(word) for word in data[k : k + 3]] for k in range(0, 3 * num, 3)]
    rows = [[whole(word) for word in data[k : k + 4]] for k in range(3 * num, len(data), 4)]
    need(all(row[0] == 3 for row in rows))
    return cornered(vertices, [row[1:] for row in rows])


def ply(content: bytes) -> np.ndarray:
    """Row by row, of vertices and of faces."""
    for mark, encoding in MARKS:
        content = content[len(mark) :].decode(encoding).encode() if content.startswith(mark) else content
    end = re.search(rb"(?:\A|\n|\r)end_header[ \t]*(\r\n|\n|\r)", content)
    need(end is not None)
    lines = [line.split() for line in text_of(content[: end.start()] if end else b"").splitlines()]
    need(lines[0] == ["ply"])
    form, elements = "", []
    for words in lines[1:]:
        if words[:1] == ["format"]:
            form = words[1]
        elif words[:1] == ["element"]:
            need(len(words) == 3 and words[2].isdigit())
            elements.append((words[1], int(words[2]), []))
        elif words[:1] == ["property"]:
            need(len(words) == (5 if words[1] == "list" else 3))
            elements[-1][2].append((words[-1], [NUMPY[word] for word in words[1:-1] if word != "list"]))
    data, at = content[end.end() :] if end else b"", 0
    words = data.split() if form == "ascii" else []
    order = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}[form]

    def take(kind: str, num: int) -> list[float]:
        nonlocal at
        if form == "ascii":
            at += num
            need(at <= len(words))
            return [float(word) for word in words[at - num : at]]
        size = struct.calcsize(order + kind) * num
        at += size
        need(at <= len(data))
        return list(struct.unpack(f"{order}{num}{kind}", data[at - size : at]))

    vertices, faces = [], []
    for name, num, properties in elements:
        for _ in range(num):
            row = {}
            for key, kinds in properties:
                size = take(kinds[0], 1)[0] if len(kinds) == 2 else 1
                need(size == int(size) and size >= 0)
                row[key] = take(kinds[-1], int(size))
            if name == "vertex":
                vertices.append([row[axis][0] for axis in "xyz"])
            elif name == "face":
                face = row.get("vertex_indices", row.get("vertex_index", []))
                need(len(face) == 3 and all(corner == int(corner) for corner in face))
                faces.append([int(corner) for corner in face])
    return cornered(vertices, faces)


def glb(content: bytes) -> np.ndarray:
    """Of all nodes of the scene, with their matrices; without anything that changes a mesh."""
    need(content[:8] == b"glTF\x02\0\0\0" and content[16:20] == b"JSON")
    size = struct.unpack("<I", content[12:16])[0]
    document = json.loads(content[20 : 20 + size].decode("utf-8-sig"))
    blob = content[28 + size :]
    need(not document.get("extensionsRequired") and len(blob) >= struct.unpack("<I", content[20 + size : 24 + size])[0])

    def read(number: int, width: int) -> np.ndarray:
        one = document["accessors"][number]
        need("sparse" not in one and not one.get("normalized"))
        view, kind = document["bufferViews"][one["bufferView"]], np.dtype(COMPONENT[one["componentType"]])
        start, step = one.get("byteOffset", 0), view.get("byteStride", width * kind.itemsize)
        part = blob[view.get("byteOffset", 0) :][: view["byteLength"]]
        rows = [np.frombuffer(part, kind, width, start + k * step) for k in range(one["count"])]
        return np.array(rows)

    found = []

    def visit(number: int, above: np.ndarray, depth: int = 0) -> None:
        node = document["nodes"][number]
        need(depth < 20 and not {"rotation", "scale"} & set(node) and "EXT_mesh_gpu_instancing" not in str(node))
        matrix = np.reshape(node.get("matrix", np.eye(4)), (4, 4)).T.astype(float)
        matrix[:3, 3] += node.get("translation", [0, 0, 0])
        matrix = above @ matrix
        for one in document["meshes"][node["mesh"]]["primitives"] if "mesh" in node else []:
            need(one.get("mode", 4) == 4 and not any(document["meshes"][node["mesh"]].get("weights", [])))
            points, index = read(one["attributes"]["POSITION"], 3).astype(float), read(one["indices"], 1).astype(int)
            need(len(index) % 3 == 0 and index.max() < len(points))
            found.append((points @ matrix[:3, :3].T + matrix[:3, 3])[index.reshape(-1, 3)])
        for child in node.get("children", []):
            visit(child, matrix, depth + 1)

    for root in document["scenes"][document.get("scene", 0)]["nodes"]:
        visit(root, np.eye(4))
    need(found)
    return np.concatenate(found)


PARSERS = {"obj": obj, "off": off, "ply": ply, "glb": glb}


def corners(suffix: str, content: bytes) -> np.ndarray | None:
    """Those of a file; None if it is not of its format."""
    try:
        return PARSERS[suffix](content)
    except (Bad, ValueError, KeyError, IndexError, TypeError, AttributeError, struct.error, OverflowError):
        return None


def are_same(ours: np.ndarray, theirs: np.ndarray) -> bool:
    """Whether two lists of triangles are the same, in any order and from any first corner."""

    def canonical(triangles: np.ndarray) -> np.ndarray:
        triangles = np.nan_to_num(triangles, nan=7e77, posinf=8e88, neginf=-8e88).astype(np.float64)
        turned = np.stack([np.roll(triangles, turn, axis=1).reshape(-1, 9) for turn in range(3)], axis=1)
        first = np.array([np.lexsort(rows.T[::-1])[0] for rows in turned], dtype=int)
        rows = turned[np.arange(len(turned)), first]
        return rows[np.lexsort(rows.T[::-1])]

    if ours.shape != theirs.shape:
        return False
    return bool(np.allclose(canonical(ours), canonical(theirs), rtol=1e-6, atol=1e-9))
