"""A prism over an L, and a ball, as files have them."""

import json
import struct
from pathlib import Path

import numpy as np
import trimesh

L_SHAPE = np.array([[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]], dtype=float)


def prism() -> tuple[list[list[float]], list[list[int]]]:
    """A prism over an L: two faces of six corners, not convex, and six quads; its volume is 3 x 0.7."""
    vertices = [[x, y, z] for z in (0.0, 0.7) for x, y in L_SHAPE.tolist()]
    sides = [[k, (k + 1) % 6, (k + 1) % 6 + 6, k + 6] for k in range(6)]
    return vertices, [[5, 4, 3, 2, 1, 0], [6, 7, 8, 9, 10, 11], *sides]


def written(path: Path, between: str, header: str = "OFF", colour: str = "") -> Path:
    """The prism as OFF, with ``between`` the words of a face."""
    vertices, faces = prism()
    rows = [" ".join(map(str, vertex)) for vertex in vertices]
    rows += [between.join(map(str, [len(face), *face])) + colour for face in faces]
    path.write_text("\n".join([header, f"# a prism\n\n{len(vertices)} {len(faces)} 0", *rows]) + "\n")
    return path


def volume(vertices: np.ndarray, faces: np.ndarray) -> float:
    """By the divergence theorem."""
    return float(np.linalg.det(vertices[faces]).sum() / 6)


def obj_of(vertices, faces) -> str:
    return "".join(f"v {x} {y} {z}\n" for x, y, z in vertices) + "".join(
        f"f {' '.join(str(corner + 1) for corner in face)}\n" for face in faces
    )


def glb(path: Path, change=lambda _: None) -> Path:
    """A ball as a binary glTF, its JSON changed."""
    content = trimesh.Scene(trimesh.creation.icosphere(1)).export(file_type="glb")
    size = struct.unpack("<I", content[12:16])[0]
    document = json.loads(content[20 : 20 + size])
    change(document)
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    rest = struct.pack("<I", len(text)) + b"JSON" + text + content[20 + size :]
    path.write_bytes(b"glTF" + struct.pack("<II", 2, 12 + len(rest)) + rest)
    return path
