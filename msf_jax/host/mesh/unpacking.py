"""Checks of a mesh file in XML, or of an archive with XML, before it is read: a small file can need more than memory.

The unpacked size of an archive is limited. Its XML is parsed as a stream, and not stored. A vertex or triangle must
have its attributes. The number of other elements is limited. Entities are refused. Parts can consist of other parts:
the triangles of all instances of all parts are limited.
"""

import importlib
import io
import zipfile
from collections import defaultdict
from pathlib import Path
from typing import Any, BinaryIO
from xml.parsers import expat

ZIPPED = {"3mf", "3dxml"}  # mesh formats that are archives
IN_XML = ZIPPED | {"xaml"}
# Limits of the unpacked bytes: ratio to the packed bytes; bytes always allowed; largest unpacked size of any archive.
LARGEST_RATIO, SMALL, LARGEST = 50, 10_000_000, 2**29
MESH_ELEMENTS, FEWEST = ("vertex", "triangle"), 3  # elements of a mesh; attributes of each, at least
MOST_ELEMENTS = 100_000  # other elements, at most
# Of the parts, at most: triangles of all instances, instances, and levels of parts in parts.
MOST_TRIANGLES, MOST_INSTANCES, DEEPEST = 20_000_000, 100_000, 100
CHUNK = 1 << 16  # bytes that are read at a time


def check(path: Path) -> bool:
    """Raise a ValueError if the file at ``path`` would need too much memory for its size. Returns whether its objects
    refer to members of the archive: `merged` then makes it readable."""
    if path.suffix.lower().lstrip(".") not in ZIPPED:
        with path.open("rb") as stream:
            _Elements().read(stream)
        return False
    with zipfile.ZipFile(path) as archive:
        members = archive.infolist()
        size = sum(member.file_size for member in members)
        most = min(max(LARGEST_RATIO * path.stat().st_size, SMALL), LARGEST)
        if size > most:
            raise ValueError(f"it unpacks to {size} bytes: expected at most {most}")
        elements = _Elements()
        for member in members:
            if Path(member.filename).suffix.lower() not in (".png", ".jpg", ".jpeg"):
                with archive.open(member) as stream:
                    elements.read(stream, member.filename)
        elements.check_instances()
        return elements.has_paths


def merged(path: Path) -> io.BytesIO:
    """The 3MF file at ``path`` with the objects of all its models in one, and ids that are unique in the whole file. In
    3MF's production extension a component names the member and the id of an object, but trimesh uses only the id."""
    etree: Any = importlib.import_module("lxml.etree")
    with zipfile.ZipFile(path) as archive:
        names = [name for name in archive.namelist() if name.lower().endswith(".model")]
        models = {name: etree.fromstring(archive.read(name)) for name in names}
    root = next(models[name] for name in names if "3d/3dmodel.model" in name.lower())
    for name, model in models.items():
        for part in model.findall(".//{*}component") + model.findall(".//{*}item"):
            part.set("objectid", _referred(part.attrib, name))
            for attribute in [each for each in part.attrib if each.endswith("path")]:
                del part.attrib[attribute]
        for element in model.findall(".//{*}object"):
            element.set("id", f"{name} {element.get('id')}")
            root.find("{*}resources").append(element)
    found = io.BytesIO()
    with zipfile.ZipFile(found, "w") as archive:
        archive.writestr("3D/3dmodel.model", etree.tostring(root))
    return found


def _referred(attributes: Any, member: str) -> str:
    """The member and the id of the object that a component or item in ``member`` refers to."""
    path = next((value.strip("/") for key, value in attributes.items() if key.endswith("path")), member)
    return f"{path} {attributes['objectid']}"


class _Elements:
    """Counts the elements in a stream of XML."""

    def __init__(self) -> None:
        self.num_others = 0
        self.member = ""  # the archive's member that is read
        self.inside = ""  # the current object: its member and id; "" is the whole file
        self.has_paths = False
        self.triangles: dict[str, int] = defaultdict(int)  # of each object
        self.parts: dict[str, list[str]] = defaultdict(list)  # the parts of each object

    def read(self, stream: BinaryIO | Any, member: str = "") -> None:
        """Parse one stream. A stream that is no XML is left to the file's reader."""
        self.member, self.inside = member, ""
        first = stream.read(CHUNK)
        if not first.lstrip(b"\xef\xbb\xbf \t\r\n").startswith((b"<", b"\xff\xfe", b"\xfe\xff")):
            return
        parser = expat.ParserCreate()
        parser.StartElementHandler = self._begun
        parser.EndElementHandler = self._ended
        parser.StartDoctypeDeclHandler = self._declared
        try:
            chunk = first
            while chunk:
                parser.Parse(chunk, False)
                chunk = stream.read(CHUNK)
            parser.Parse(b"", True)
        except expat.ExpatError:
            return  # it is damaged: the file's reader stops at the same place, so nothing unchecked is read

    def check_instances(self) -> None:
        """Raise a ValueError if the parts, with the parts that they consist of, are too many."""
        done: dict[str, tuple[int, int]] = {}
        ancestors: set[str] = set()

        def total(name: str) -> tuple[int, int]:
            """The numbers of instances and triangles of an object, with its parts."""
            if name in done:
                return done[name]
            if name in ancestors or len(ancestors) > DEEPEST:
                raise ValueError("its parts contain themselves, or are nested too deeply")
            ancestors.add(name)
            found = [total(part) for part in self.parts.get(name, [])]
            ancestors.discard(name)
            done[name] = 1 + sum(one for one, _ in found), self.triangles[name] + sum(num for _, num in found)
            return done[name]

        instances, triangles = total("")
        if instances > MOST_INSTANCES or triangles > MOST_TRIANGLES:
            raise ValueError(f"its parts have {instances} instances and {triangles} triangles, which is too many")

    def _begun(self, name: str, attributes: dict[str, str]) -> None:
        name = name.rpartition(":")[2]
        if name in MESH_ELEMENTS:
            if len(attributes) < FEWEST:
                raise ValueError(f"a {name} has {len(attributes)} numbers: expected at least {FEWEST}")
            self.triangles[self.inside] += name == "triangle"
            return
        self.num_others += 1
        if self.num_others > MOST_ELEMENTS:
            raise ValueError(f"it has over {MOST_ELEMENTS} elements that are no part of a mesh")
        if name == "object" and self.inside:
            raise ValueError("it has an object in another")
        if name == "object":
            self.inside = f"{self.member} {attributes.get('id')}"
        elif name in ("component", "item") and "objectid" in attributes:
            self.has_paths |= any(key.endswith("path") for key in attributes)
            self.parts[self.inside if name == "component" else ""].append(_referred(attributes, self.member))

    def _ended(self, name: str) -> None:
        if name.rpartition(":")[2] == "object":
            self.inside = ""

    def _declared(self, *_: Any) -> None:
        raise ValueError("it declares entities, which no mesh needs")
