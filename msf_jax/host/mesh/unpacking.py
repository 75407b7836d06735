"""Checks of a mesh file in XML before it is read, because a small file can unpack to more than memory.

The unpacked size of an archive is limited. Its XML is then parsed as a stream, without storing it. The checks limit the
number of elements that are not vertices or triangles, require the attributes of those, refuse entities, and limit the
triangles of parts that consist of other parts.
"""

import zipfile
from collections import defaultdict
from pathlib import Path
from typing import Any, BinaryIO
from xml.parsers import expat

ZIPPED = {"3mf", "3dxml"}  # mesh formats that are archives
IN_XML = ZIPPED | {"xaml"}
# Limits of the unpacked bytes: ratio to the packed bytes; bytes that are always allowed; bytes that are never exceeded.
LARGEST_RATIO, SMALL, LARGEST = 50, 10_000_000, 2**29
NUMBERS = ("vertex", "triangle")  # elements of a mesh
FEWEST = 3  # attributes of each of these, at least
MOST_ELEMENTS = 100_000  # other elements, at most
MOST_TRIANGLES = 20_000_000  # triangles of all instances of parts, at most
MOST_INSTANCES = 100_000  # instances of parts, at most
CHUNK = 1 << 16  # bytes that are read at a time


def check(path: Path) -> None:
    """Raise a ValueError if the file at ``path`` would need too much memory for its size."""
    if path.suffix.lower().lstrip(".") not in ZIPPED:
        with path.open("rb") as stream:
            _Elements().read(stream)
        return
    with zipfile.ZipFile(path) as archive:
        members = archive.infolist()
        size, most = sum(member.file_size for member in members), LARGEST_RATIO * path.stat().st_size
        if size > min(max(most, SMALL), LARGEST):
            raise ValueError(f"it unpacks to {size} bytes: expected at most {min(max(most, SMALL), LARGEST)}")
        elements = _Elements()
        for member in members:
            if Path(member.filename).suffix.lower() not in (".png", ".jpg", ".jpeg"):
                with archive.open(member) as stream:
                    elements.read(stream)
        elements.check_instances()


class _Elements:
    """Counts the elements in a stream of XML."""

    def __init__(self) -> None:
        self.num_others = 0
        self.inside = ""  # the current object
        self.triangles: dict[str, int] = defaultdict(int)  # of each object
        self.parts: dict[str, list[str]] = defaultdict(list)  # the parts of each object; "" is the whole file

    def read(self, stream: BinaryIO | Any) -> None:
        """Parse one stream. A stream that is no XML is left to the file's reader."""
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
            return  # it is damaged: the file's reader reports it, and reads no farther than this parser

    def check_instances(self) -> None:
        """Raise a ValueError if the parts, with the parts that they consist of, are too many."""
        done: dict[str, tuple[int, int]] = {}
        ancestors: set[str] = set()

        def total(name: str) -> tuple[int, int]:
            """The numbers of instances and triangles of an object, with its parts."""
            if name in done:
                return done[name]
            if name in ancestors or len(ancestors) > 100:
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
        if name in NUMBERS:
            if len(attributes) < FEWEST:
                raise ValueError(f"a {name} has {len(attributes)} numbers: expected {FEWEST}")
            self.triangles[self.inside] += name == "triangle"
            return
        self.num_others += 1
        if self.num_others > MOST_ELEMENTS:
            raise ValueError(f"it has over {MOST_ELEMENTS} elements that are no part of a mesh")
        if name == "object":
            self.inside = attributes.get("id", "")
        elif name in ("component", "item") and "objectid" in attributes:
            self.parts[self.inside if name == "component" else ""].append(attributes["objectid"])

    def _ended(self, name: str) -> None:
        if name.rpartition(":")[2] == "object":
            self.inside = ""

    def _declared(self, *_: Any) -> None:
        raise ValueError("it declares entities, which no mesh needs")
