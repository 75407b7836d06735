"""Checking of OBJ files before trimesh reads them: every index is one of a vertex, and every face is a triangle.

Trimesh takes index 0 for the first vertex, a negative index from the end of the file and not from its line, and cuts
polygons into fans. It does not see lines that begin with white space or have a tab after the first word.
"""

import itertools
import re

import numpy as np

from msf_jax.meshes.decoding import lines_of
from msf_jax.meshes.files.off import triangulated

NUMBER, INDEX = r"(?: [-+.\deE]+)", r"[1-9]\d*"
# The first line that trimesh might not read as it is meant.
ODD = re.compile(
    rf"^(?!(?:v{NUMBER}{{3}}(?:{NUMBER}{{3}})?|vn{NUMBER}{{3}}|vt{NUMBER}{{2,3}}"
    rf"|f(?: {INDEX}(?:/{INDEX}(?:/{INDEX})?|//{INDEX})?){{3}}|(?:usemtl|mtllib|[ogs])(?: .*)?|#.*|)$)",
    re.MULTILINE,
)
NAMES = ("usemtl", "mtllib", "o", "g", "s")  # lines that are kept as they are


def plain(text: str) -> str:
    """The same mesh as an OBJ file of triangles, with indices from 1 and one space between words.

    Raises:
        ValueError: a line is not of the format; the message says which.
    """
    text = text.replace("\r\n", "\n")
    if not ODD.search(text):
        return text
    found: list[str] = []
    corners: list[list[str]] = []  # of each face, as words
    rows: list[int] = []  # of each face, its line in `found`
    places: list[list[str]] = []  # of each vertex, its coordinates as words
    num = {"v": 0, "vt": 0, "vn": 0}
    for number, line in enumerate(lines_of(text.replace("\\\n", " ")), 1):
        words = line.split()
        kind = words[0] if words else ""
        if kind in NAMES:
            found.append(" ".join(words))
        elif kind in num or kind == "f":
            words = line.partition("#")[0].split()
            if len(words) < (3 if kind == "vt" else 4) - (kind == "vt"):
                raise ValueError(f"line {number} is {line[:60]!r}: expected at least three after {kind}")
            if kind == "f":
                rows.append(len(found))
                corners.append([_resolved(word, num, number) for word in words[1:]])
            else:
                num[kind] += 1
                if kind == "v":
                    places.append(words[1:4])
                    words = words[:7] if len(words) >= 7 else words[:4]  # with a colour, or without
            found.append(" ".join(words))
    ids = [int(word.partition("/")[0]) for face in corners for word in face]
    if ids and max(ids) > num["v"]:
        raise ValueError(f"a face has index {max(ids)}, out of range: expected 1 to {num['v']}")
    _cut(found, rows, corners, np.array(ids, dtype=np.int64) - 1, places)
    return "\n".join(found) + "\n"


def numbered(text: str) -> str:
    """The OBJ file `plain` ``text`` with the index of each vertex, from 0, in place of its x; y and z are 0."""
    index = itertools.count()
    return re.sub(r"^v \S+ \S+ \S+", lambda _: f"v {next(index)} 0 0", text, flags=re.MULTILINE)


def _resolved(word: str, num: dict[str, int], line: int) -> str:
    """A corner of a face with all its indices counted from 1."""
    parts = word.split("/")
    for place, (part, total) in enumerate(zip(parts, num.values(), strict=False)):
        if not part and place:
            continue
        try:
            index = int(part)
        except ValueError:
            raise ValueError(f"line {line} has a corner {word[:30]!r}: expected whole numbers") from None
        if index == 0:
            raise ValueError(f"line {line} has index 0: OBJ counts from 1")
        if index < 0:
            if -index > total:
                raise ValueError(f"line {line} has index {index}, out of range: {total} are before it")
            parts[place] = str(total + 1 + index)
    return "/".join(parts)


def _cut(found: list[str], rows: list[int], corners: list[list[str]], ids: np.ndarray, places: list[list[str]]) -> None:
    """Write all faces, as triangles, to their lines in ``found``. ``ids`` are vertices of all corners, in a row."""
    if all(len(face) == 3 for face in corners):
        for row, face in zip(rows, corners, strict=True):
            found[row] = f"f {face[0]} {face[1]} {face[2]}"
        return
    words = [word for face in corners for word in face]
    size = np.array([len(face) for face in corners])
    points = np.array(places, dtype=np.float64)[ids]  # each corner has its own number, so that it keeps its word
    ends = np.cumsum(size)
    polygons = [list(range(end - num, end)) for end, num in zip(ends.tolist(), size.tolist(), strict=True)]
    triangles = triangulated(points, polygons)
    owner = np.repeat(np.arange(len(size)), size)[triangles[:, 0]]
    for row in rows:
        found[row] = ""
    for face, (a, b, c) in zip(owner.tolist(), triangles.tolist(), strict=True):
        found[rows[face]] += f"f {words[a]} {words[b]} {words[c]}\n"
