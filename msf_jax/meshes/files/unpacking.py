"""Reading of 3MF, and limits of what is read: a small file can unpack to more than memory, or show the same triangles
many times.

3MF is read here as a stream of XML, not by trimesh, which leaves out an item with the part number of another, parts
beyond some number of nested parts, and objects that are not there.
"""

import zipfile
from array import array
from collections import defaultdict
from pathlib import Path
from xml.parsers import expat

import numpy as np

# Limits of the unpacked bytes: ratio to the packed bytes; bytes always allowed; the largest.
LARGEST_RATIO, SMALL_ARCHIVE, LARGEST_UNPACKED = 50, 10_000_000, 2**29
# Of the parts, at most: triangles of all instances, and instances. Two million triangles with normals, colours and
# texture coordinates take up to 0.8 GB.
MOST_TRIANGLES, MOST_INSTANCES = 2_000_000, 20_000
MOST_ELEMENTS = 100_000  # of a 3MF but for vertices and triangles
MOST_TIMES = 2  # times that the triangles of a file may be shown, if they are over MOST_TRIANGLES
SHOWN = None  # the parent of what the file shows


def check_shown(instances: int, triangles: int, own: int) -> None:
    """Raise a ValueError if a file with ``own`` triangles shows too many."""
    if instances > MOST_INSTANCES or triangles > max(MOST_TRIANGLES, MOST_TIMES * own):
        raise ValueError(f"its parts have {instances} instances and {triangles} triangles, which is too many")


def meshes_of_3mf(path: Path) -> list[tuple[np.ndarray, np.ndarray]]:
    """Vertices and triangles of each object that the file at ``path`` shows, as it places them, turned right side out
    where it mirrors them.

    Raises:
        ValueError: the file would need too much memory for its size, has several models, or is damaged.
    """
    numbers: dict[str, tuple[array, array]] = {}  # of each object: x, y, z of vertices, corners of triangles
    named: list[tuple[str | None, str, np.ndarray]] = []  # parts: the object that has it, its own, its place there
    inside: str | None = SHOWN  # the object that is read
    others = 0  # elements that are no vertex or triangle

    def begin(tag: str, attributes: dict[str, str]) -> None:
        nonlocal inside, others
        others += 1
        match tag.rpartition(":")[2]:
            case "vertex" if inside is not None:
                numbers[inside][0].extend([float(attributes[key]) for key in ("x", "y", "z")])
                others -= 1
            case "triangle" if inside is not None:
                numbers[inside][1].extend([int(attributes[key]) for key in ("v1", "v2", "v3")])
                others -= 1
            case "object":
                if inside is not None or attributes["id"] in numbers:
                    raise ValueError(f"it has an object {attributes['id']!r} in another, or twice")
                inside = attributes["id"]
                numbers[inside] = array("d"), array("q")
            case "component" | "item":
                if any(key.endswith("path") for key in attributes):
                    raise ValueError("it has several models, of which one is supported: export it as one")
                matrix = np.eye(4)
                if "transform" in attributes:  # rows, without the last column
                    matrix[:3] = np.array(attributes["transform"].split(), dtype=np.float64).reshape(4, 3).T
                named.append((inside, attributes["objectid"], matrix))
        if others > MOST_ELEMENTS:
            raise ValueError(f"it has over {MOST_ELEMENTS} elements that are no part of a mesh")

    def end(tag: str) -> None:
        nonlocal inside
        inside = SHOWN if tag.rpartition(":")[2] == "object" else inside

    def refuse_entities(*_: object) -> None:
        raise ValueError("it declares entities, which no mesh needs")

    parser = expat.ParserCreate()
    parser.StartElementHandler, parser.EndElementHandler = begin, end
    parser.StartDoctypeDeclHandler = refuse_entities
    with zipfile.ZipFile(path) as archive:
        unpacked = sum(member.file_size for member in archive.infolist())
        most = min(max(LARGEST_RATIO * path.stat().st_size, SMALL_ARCHIVE), LARGEST_UNPACKED)
        if unpacked > most:
            raise ValueError(f"it unpacks to {unpacked} bytes: expected at most {most}")
        models = [name for name in archive.namelist() if name.lower().endswith(".model")]
        if len(models) != 1:  # their objects have the same ids
            raise ValueError(f"it has {len(models)} models, of which one is supported: export it as one")
        with archive.open(models[0]) as stream:
            parser.ParseFile(stream)

    size = {name: max(map(len, both)) // 3 for name, both in numbers.items()}  # vertices or triangles, which are more
    parts: dict[str | None, list[tuple[str, np.ndarray]]] = defaultdict(list)  # last first
    for parent, name, place in reversed(named):
        parts[parent].append((name, place))
    rest, shown, triangles, own = parts[SHOWN], [], 0, sum(size.values())
    while rest:
        name, matrix = rest.pop()
        if name not in numbers:
            raise ValueError(f"it shows an object {name!r} that it does not have")
        shown.append((name, matrix))
        rest += [(part, matrix @ place) for part, place in parts[name]]
        triangles += size[name]
        check_shown(len(shown) + len(rest), triangles, own)  # also of an object that is a part of itself
    meshes = []
    for name, matrix in shown:
        vertices, faces = (np.array(values).reshape(-1, 3) for values in numbers[name])
        if len(vertices) or len(faces):
            is_mirrored = np.linalg.det(matrix[:3, :3]) < 0
            placed = vertices @ matrix[:3, :3].T + matrix[:3, 3]
            meshes.append((placed, faces[:, ::-1] if is_mirrored else faces))
    return meshes
