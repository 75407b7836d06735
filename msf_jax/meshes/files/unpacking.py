"""Reading of 3MF, and checks of other files in XML before they are read: a small file can need more than memory.

XML is parsed as a stream: of a 3MF, only numbers are stored. The unpacked size of an archive is limited. A vertex or
triangle must have its attributes. The number of other elements is limited. Entities are refused. Parts can consist of
other parts: the triangles of all instances of all parts are limited.
"""

import zipfile
from array import array
from collections import defaultdict
from pathlib import Path
from typing import Any, BinaryIO
from xml.parsers import expat

import numpy as np

IN_XML = {"3dxml", "xaml"}  # mesh formats of XML that trimesh reads; the first is an archive
# Limits of the unpacked bytes: ratio to the packed bytes; bytes always allowed; largest unpacked size of any archive.
LARGEST_RATIO, SMALL_ARCHIVE, LARGEST_UNPACKED = 50, 10_000_000, 2**29
MESH_ELEMENTS = {"vertex": "xyz", "triangle": ("v1", "v2", "v3")}  # elements of a mesh, their attributes
FEWEST_ATTRIBUTES = 3  # of each of these elements, at least
MOST_ELEMENTS = 100_000  # other elements, at most
# Of the parts, at most: triangles of all instances, instances, and levels of parts in parts. Two million triangles with
# normals, colours and texture coordinates take up to 0.8 GB.
MOST_TRIANGLES, MOST_INSTANCES, DEEPEST = 2_000_000, 20_000, 100
MOST_TIMES = 2  # times that the triangles of a file may be shown, if they are over MOST_TRIANGLES
CHUNK = 1 << 16  # bytes that are read at a time
ROOT = "3d/3dmodel.model"  # the member that says what is shown
IMAGES = (".png", ".jpg", ".jpeg")


def check(path: Path) -> None:
    """Raise a ValueError if the file at ``path`` would need too much memory for its size."""
    if path.suffix.lower() == ".xaml":
        with path.open("rb") as stream:
            _Elements().read(stream)
        return
    with zipfile.ZipFile(path) as archive:
        _read_members(archive, _Elements(), path.stat().st_size)


def meshes_of_3mf(path: Path) -> list[tuple[np.ndarray, np.ndarray]]:
    """Vertices and triangles of each object that the file at ``path`` shows, as it places them.

    In 3MF's production extension a component names the member and the id of an object.

    Raises:
        ValueError: the file would need too much memory for its size, or is damaged.
    """
    with zipfile.ZipFile(path) as archive:
        models = _Models()
        _read_members(archive, models, path.stat().st_size)
    models.check_instances()
    return models.placed("", np.eye(4))


def _read_members(archive: zipfile.ZipFile, elements: "_Elements", size: int) -> None:
    """Parse the members of an ``archive`` of ``size`` bytes."""
    members = archive.infolist()
    unpacked = sum(member.file_size for member in members)
    most = min(max(LARGEST_RATIO * size, SMALL_ARCHIVE), LARGEST_UNPACKED)
    if unpacked > most:
        raise ValueError(f"it unpacks to {unpacked} bytes: expected at most {most}")
    for member in members:
        if Path(member.filename).suffix.lower() not in IMAGES:
            with archive.open(member) as stream:
                elements.read(stream, member.filename)


def check_shown(instances: int, triangles: int, own: int) -> None:
    """Raise a ValueError if a file with ``own`` triangles shows too many."""
    if instances > MOST_INSTANCES or triangles > max(MOST_TRIANGLES, MOST_TIMES * own):
        raise ValueError(f"its parts have {instances} instances and {triangles} triangles, which is too many")


class _Elements:
    """Counts the elements in a stream of XML."""

    def __init__(self) -> None:
        self.num_others = 0

    def read(self, stream: BinaryIO | Any, member: str = "") -> None:
        """Parse one stream. A stream that is no XML is left to the file's reader."""
        first = stream.read(CHUNK)
        if not first.lstrip(b"\xef\xbb\xbf \t\r\n").startswith((b"<", b"\xff\xfe", b"\xfe\xff")):
            return
        parser = expat.ParserCreate()
        parser.StartElementHandler = lambda name, attributes: self.begun(name.rpartition(":")[2], attributes)
        parser.EndElementHandler = lambda name: self.ended(name.rpartition(":")[2])
        parser.StartDoctypeDeclHandler = self.declared
        chunk = first
        while chunk:
            parser.Parse(chunk, False)
            chunk = stream.read(CHUNK)
        parser.Parse(b"", True)

    def begun(self, name: str, attributes: dict[str, str]) -> None:
        """An element begins."""
        if name in MESH_ELEMENTS:
            if len(attributes) < FEWEST_ATTRIBUTES:
                raise ValueError(f"a {name} has {len(attributes)} numbers: expected at least {FEWEST_ATTRIBUTES}")
            return
        self.num_others += 1
        if self.num_others > MOST_ELEMENTS:
            raise ValueError(f"it has over {MOST_ELEMENTS} elements that are no part of a mesh")

    def ended(self, name: str) -> None:
        """An element ends."""

    def declared(self, *_: Any) -> None:
        """Refuse entities."""
        raise ValueError("it declares entities, which no mesh needs")


class _Models(_Elements):
    """The objects in the models of a 3MF file, each by its member and id; "" is what the file shows."""

    def __init__(self) -> None:
        super().__init__()
        self.member = self.inside = ""  # that are read: the archive's member, and the object in it
        self.numbers: dict[str, dict[str, array]] = {}  # of each object
        self.parts: dict[str, list[tuple[str, np.ndarray]]] = defaultdict(list)  # of each object, and their places

    def read(self, stream: BinaryIO | Any, member: str = "") -> None:
        self.member, self.inside = member, ""
        if member.lower().endswith(".model"):
            super().read(stream, member)

    def begun(self, name: str, attributes: dict[str, str]) -> None:
        super().begun(name, attributes)
        if name in MESH_ELEMENTS and self.inside:
            read = float if name == "vertex" else int
            self.numbers[self.inside][name].extend([read(attributes[key]) for key in MESH_ELEMENTS[name]])
        elif name == "object":
            if self.inside:
                raise ValueError("it has an object in another")
            self.inside = f"{self.member} {attributes.get('id')}"
            self.numbers[self.inside] = {"vertex": array("d"), "triangle": array("q")}
        elif name == "component" or (name == "item" and self.member.lower().endswith(ROOT)):
            path = next((value.strip("/") for key, value in attributes.items() if key.endswith("path")), self.member)
            matrix = np.eye(4)
            if "transform" in attributes:  # rows, without the last column
                matrix[:3] = np.array(attributes["transform"].split(), dtype=np.float64).reshape(4, 3).T
            self.parts[self.inside if name == "component" else ""].append((f"{path} {attributes['objectid']}", matrix))

    def ended(self, name: str) -> None:
        self.inside = "" if name == "object" else self.inside

    def check_instances(self) -> None:
        """Raise a ValueError if the parts, with the parts that they consist of, are too many."""
        done: dict[str, tuple[int, int]] = {}
        ancestors: set[str] = set()

        def own(name: str) -> int:
            """Triangles or vertices of an object, whichever are more."""
            return max((len(values) // 3 for values in self.numbers.get(name, {}).values()), default=0)

        def total(name: str) -> tuple[int, int]:
            """The numbers of instances and triangles of an object, with its parts."""
            if name in done:
                return done[name]
            if name in ancestors or len(ancestors) > DEEPEST:
                raise ValueError("its parts contain themselves, or are nested too deeply")
            ancestors.add(name)
            found = [total(part) for part, _ in self.parts.get(name, [])]
            ancestors.discard(name)
            done[name] = 1 + sum(one for one, _ in found), own(name) + sum(num for _, num in found)
            return done[name]

        check_shown(*total(""), sum(map(own, self.numbers)))

    def placed(self, name: str, matrix: np.ndarray) -> list[tuple[np.ndarray, np.ndarray]]:
        """The meshes of an object and its parts, turned right side out where ``matrix`` mirrors them."""
        found = []
        if any(self.numbers.get(name, {}).values()):
            vertices, faces = (np.array(values).reshape(-1, 3) for values in self.numbers[name].values())
            is_mirrored = np.linalg.det(matrix[:3, :3]) < 0
            found = [(vertices @ matrix[:3, :3].T + matrix[:3, 3], faces[:, ::-1] if is_mirrored else faces)]
        elif name and name not in self.numbers:
            raise ValueError(f"it shows an object {name!r} that it does not have")
        return found + [mesh for part, place in self.parts.get(name, []) for mesh in self.placed(part, matrix @ place)]
