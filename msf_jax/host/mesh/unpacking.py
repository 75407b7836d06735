"""What a mesh file in XML would take to read, before it is: a small one can unpack to more than memory.

An archive may unpack to a multiple of its size. Its XML is then gone through as a stream, which keeps nothing: elements
that are not numbers of a mesh are few, those that are have their numbers, entities of its own there are none, and what
parts are put together of other parts comes to so many triangles.
"""

import zipfile
from collections import defaultdict
from pathlib import Path
from typing import Any, BinaryIO
from xml.parsers import expat

ZIPPED = {"3mf", "3dxml"}  # mesh formats that are archives
IN_XML = ZIPPED | {"xaml"}
LARGEST_RATIO, SMALL, LARGEST = 50, 10_000_000, 2**29  # bytes unpacked: times those packed, in any case, at most
NUMBERS = ("vertex", "triangle")  # elements of a mesh, with so many attributes each:
FEWEST = 3
MOST_ELEMENTS = 100_000  # of all others
MOST_TRIANGLES = 20_000_000  # of all instances
MOST_INSTANCES = 100_000
CHUNK = 1 << 16


def check(path: Path) -> None:
    """Raise a ValueError if the file at ``path`` would take more memory than its size lets one expect."""
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
    """Counts what is in a stream of XML."""

    def __init__(self) -> None:
        self.num_others = 0
        self.inside = ""  # the object that is being read
        self.triangles: dict[str, int] = defaultdict(int)  # of each object
        self.parts: dict[str, list[str]] = defaultdict(list)  # that each object is put together of; of "" the whole

    def read(self, stream: BinaryIO | Any) -> None:
        """Go through one stream; what is no XML is left to whoever reads it."""
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
            return  # damaged: its reader says how, and has seen no more of it than this one

    def check_instances(self) -> None:
        """Raise a ValueError if all the parts of parts together are too many."""
        done: dict[str, tuple[int, int]] = {}
        on_the_way: set[str] = set()

        def total(name: str) -> tuple[int, int]:
            """Instances and triangles of an object, by depth."""
            if name in done:
                return done[name]
            if name in on_the_way or len(on_the_way) > 100:
                raise ValueError("its parts are put together of themselves, or too deeply")
            on_the_way.add(name)
            found = [total(part) for part in self.parts.get(name, [])]
            on_the_way.discard(name)
            done[name] = 1 + sum(one for one, _ in found), self.triangles[name] + sum(num for _, num in found)
            return done[name]

        instances, triangles = total("")
        if instances > MOST_INSTANCES or triangles > MOST_TRIANGLES:
            raise ValueError(f"its parts come to {instances} instances and {triangles} triangles, which is too many")

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
        raise ValueError("it declares entities of its own, which no mesh needs")
