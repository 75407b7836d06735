"""Reading of OFF, OBJ, PLY and STL: polygons of any number of corners, with or without colours.

Sizes are compared with the file's before memory is allocated, and a file that is cut off is refused. Trimesh's readers
cut polygons into fans, and count negative indices of OBJ from the end of the file. Here polygons are cut into
triangles: a quad by the shorter of the diagonals that do not fold it, a polygon of more corners by ear clipping.
"""

import re
import warnings
from typing import Any, NamedTuple

import numpy as np

from msf_jax.meshes.holes import lid_of

OFF_HEADER = re.compile(r"\s*(?:ST)?C?N?OFF\b(?!\s*BINARY)", re.IGNORECASE)
MeshArrays = tuple[np.ndarray, np.ndarray]
PLY_HEADER = re.compile(rb"\A(?:\xef\xbb\xbf)?(ply\b.*?[\r\n])end_header[ \t]*(?:\r\n|\n|\r)", re.DOTALL)
KINDS = "char uchar short ushort int uint float double int8 uint8 int16 uint16 int32 uint32 float32 float64"
TYPES: dict[str, str] = dict(zip(KINDS.split(), 2 * ["i1", "u1", "i2", "u2", "i4", "u4", "f4", "f8"], strict=True))
WIDEST = 256  # numbers in a row that are read by column
CORNERS = ("vertex_indices", "vertex_index")  # names of the list of a face's corners
# Of a binary file: 80 bytes of text and the number of facets (uint32), then a row for each facet.
HEADER_BYTES, ROW = 84, np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
WORDS, VERTICES = 21, (7, 11, 15)  # of a facet in text: how many, and where "vertex" is
FIXED = {0: "facet", 5: "outer", 6: "loop", **dict.fromkeys(VERTICES, "vertex"), 19: "endloop", 20: "endfacet"}
ONE_LINE = re.IGNORECASE | re.MULTILINE


def decoded(content: bytes) -> str:
    """The text in ``content``: UTF-8, with or without a byte-order mark, else Latin-1.

    Raises:
        ValueError: it is no text; the message says what it has.
    """
    if b"\0" in content:
        raise ValueError("it is no text, or UTF-16: save it as UTF-8")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return content.decode("latin-1")  # only comments and names can differ: numbers are ASCII


def lines_of(content: bytes) -> list[str]:
    """The lines of a text. `str.splitlines` would also split at characters that may be in a comment or a name."""
    return re.split(r"\r\n|\r|\n", decoded(content))


def of_off(content: bytes) -> MeshArrays:
    """Vertices (V, 3) and triangles (F, 3) of an OFF file.

    Raises:
        ValueError: the text is no OFF file; the message says what it has instead.
    """
    lines = [words for words in (line.split("#")[0].split() for line in lines_of(content)) if words]
    first = " ".join(lines[0]) if lines else ""
    header = OFF_HEADER.match(" ".join(word for line in lines[:2] for word in line))
    if header is None:
        raise ValueError(f"it begins with {first[:30]!r}: expected OFF, as text, with three coordinates")
    rest = first[header.end() :].split()
    lines = [rest, *lines[1:]] if rest else lines[1:]
    try:
        num, num_faces = (int(word) for word in lines[0][:2])
    except (IndexError, ValueError):
        raise ValueError("the line after OFF has no counts of vertices and faces") from None
    if min(num, num_faces) < 0:
        raise ValueError(f"it counts {num} vertices and {num_faces} faces")
    rows, sides = lines[1 : num + 1], lines[num + 1 : num + 1 + num_faces]
    is_by_line = (len(rows), len(sides)) == (num, num_faces) and all(len(row) >= 3 for row in rows)
    if not (is_by_line and all(len(side) > int(side[0]) for side in sides)):  # lines have no meaning, or it is cut
        words, sides = [word for line in lines[1:] for word in line], []
        rows = [words[start : start + 3] for start in range(0, min(3 * num, len(words)), 3)]
        start = 3 * num
        while len(sides) < num_faces and start < len(words):
            sides.append(words[start : start + 1 + max(int(words[start]), 0)])
            start += len(sides[-1])
        if len(sides) < num_faces or start != len(words) or (sides and len(sides[-1]) <= int(sides[-1][0])):
            raise ValueError(f"its counts, {num} vertices and {num_faces} faces, do not fit what follows them")
    vertices = np.array([row[:3] for row in rows], dtype=np.float64).reshape(-1, 3)
    return vertices, triangulated(vertices, [[int(word) for word in side[1 : int(side[0]) + 1]] for side in sides])


def of_obj(content: bytes) -> MeshArrays:
    """Vertices (V, 3) and triangles (F, 3), in the order of their faces, of an OBJ file.

    Raises:
        ValueError: a line is not of the format; the message says which.
    """
    places: list[list[str]] = []
    polygons: list[list[int]] = []
    for number, line in enumerate(lines_of(re.sub(rb"\\(\r\n|\n)", b" ", content)), 1):
        kind, *words = line.partition("#")[0].split() or [""]
        if kind not in ("v", "f"):
            continue
        if len(words) < 3:
            raise ValueError(f"line {number} is {line[:60]!r}: expected at least three after {kind}")
        if kind == "v":
            places.append(words[:3])
            continue
        corners = [int(word.partition("/")[0]) for word in words]
        if 0 in corners:
            raise ValueError(f"line {number} has index 0: OBJ counts from 1")
        if min(corners) < -len(places):
            raise ValueError(f"line {number} has index {min(corners)}, out of range: {len(places)} are before it")
        polygons.append([corner - 1 if corner > 0 else len(places) + corner for corner in corners])
    vertices = np.array(places, dtype=np.float64).reshape(-1, 3)
    ids = np.array([corner for polygon in polygons for corner in polygon], dtype=np.int64)
    if len(ids) and ids.max() >= len(vertices):
        raise ValueError(f"a face has index {ids.max() + 1}, out of range: expected 1 to {len(vertices)}")
    # Each corner is a vertex of its own, which tells the polygon of a triangle.
    size = np.array([len(polygon) for polygon in polygons], dtype=np.int64)
    ends = np.cumsum(size)
    apart = [list(range(end - num, end)) for end, num in zip(ends.tolist(), size.tolist(), strict=True)]
    triangles = triangulated(vertices[ids], apart)
    order = np.argsort(np.repeat(np.arange(len(size)), size)[triangles[:, 0]], kind="stable")
    return vertices, ids[triangles[order]]


@np.errstate(all="ignore")  # coordinates may not be finite, or their squares: whoever asked for them checks that
def triangulated(vertices: np.ndarray, polygons: list[list[int]]) -> np.ndarray:
    """(F, 3) triangles of ``polygons``, lists of corners. Polygons of fewer than three corners are dropped.

    Raises:
        ValueError: a corner is no vertex, or a polygon cannot be cut into triangles.
    """
    count = np.array([len(polygon) for polygon in polygons], dtype=np.int64)
    corners = np.array([corner for polygon in polygons for corner in polygon], dtype=np.int64)
    if len(corners) and not (corners.min() >= 0 and corners.max() < len(vertices)):
        raise ValueError(f"a corner of a face is out of range: expected 0 to {len(vertices) - 1}")
    start = np.cumsum(count) - count
    quads = corners[start[count == 4][:, None] + np.arange(4)]
    ears: list[tuple[int, int, int]] = []
    for polygon in (polygons[row] for row in np.flatnonzero(count > 4)):
        lid = lid_of(vertices, polygon, set()) if len(set(polygon)) == len(polygon) else []
        if not lid:
            raise ValueError(f"a face of {len(polygon)} corners cannot be cut into triangles")
        ears += lid
    triangles, cut = corners[start[count == 3][:, None] + np.arange(3)], np.array(ears, dtype=np.int64).reshape(-1, 3)
    return np.concatenate([triangles, _halves(vertices, quads), cut])


def _halves(vertices: np.ndarray, quads: np.ndarray) -> np.ndarray:
    """(2n, 3) the triangles of ``quads`` (n, 4), cut from the first corner to the third, or from the second on."""
    paths = quads[:, [[0, 1, 2, 0, 2, 3], [1, 2, 3, 1, 3, 0]]].reshape(-1, 2, 2, 3)
    a, b, c = np.moveaxis(vertices[paths], 3, 0)
    normal = np.cross(b - a, c - a)
    is_folded = (normal[:, :, 0] * normal[:, :, 1]).sum(axis=-1) < 0
    length = np.linalg.norm(vertices[quads[:, [0, 1]]] - vertices[quads[:, [2, 3]]], axis=-1)
    best = np.lexsort((length, is_folded), axis=-1)[:, 0]
    return paths[np.arange(len(paths)), best].reshape(-1, 3)


class Property(NamedTuple):
    """A property of an element, with NumPy types: a list has a type of its length, too."""

    name: str
    kind: str
    length: str


def of_ply(content: bytes) -> MeshArrays:
    """Vertices (V, 3) and triangles (F, 3) of a file; none for a file of points or lines.

    Raises:
        ValueError: it is no PLY, or is damaged; the message says where.
    """
    head = PLY_HEADER.match(content)
    if head is None:
        raise ValueError("it does not begin with ply, or its header has no end_header")
    is_text, elements = _ply_header(head[1])
    data, at, columns = content[head.end() :], 0, {}
    if is_text:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", DeprecationWarning)  # older NumPy stops at a word that is no number
            data = np.fromstring(data.decode("latin-1"), sep=" ").tobytes()
    for name, num, properties in elements:
        columns[name], at = _columns(data, at, num, properties) if num and properties else ({}, at)
    axes = [columns["vertex"][axis] if columns["vertex"] else [] for axis in "xyz"]
    vertices = np.stack([np.asarray(axis, dtype=np.float64) for axis in axes], axis=1)
    of_faces = (one for name, num, properties in elements if name == "face" and num for one in properties)
    lists = [one.name for one in of_faces if one.length]
    name = next((name for name in (*CORNERS, *lists) if name in lists), None)
    rows = [] if name is None else columns["face"][name]
    flat = rows.ravel() if isinstance(rows, np.ndarray) else np.concatenate([np.empty(0), *map(np.ravel, rows)])
    if not ((flat == np.floor(flat)) & (np.abs(flat) < 2**53)).all():
        raise ValueError("a corner of a face is no whole number")
    if isinstance(rows, np.ndarray) and rows.shape[1:] == (3,):
        return vertices, rows.astype(np.int64)
    return vertices, triangulated(vertices, [np.asarray(row).astype(np.int64).tolist() for row in rows])


def _ply_header(header: bytes) -> tuple[bool, list[tuple[str, int, list[Property]]]]:
    """Whether the file is a text, whose numbers are all read as float64, and its elements: name, number, properties."""
    elements: list[tuple[str, int, list[Property]]] = []
    types: dict[str, str] = {}
    form = ""
    for line in lines_of(header)[1:]:
        match line.split():
            case ["format", "ascii" | "binary_little_endian" | "binary_big_endian" as form, *_] if not types:
                order = ">" if form == "binary_big_endian" else "<"
                types = {name: "=f8" if form == "ascii" else order + kind for name, kind in TYPES.items()}
            case ["element", name, num] if num.isdigit():
                elements.append((name, int(num), []))
            case ["property", "list", length, kind, name] if elements and {length, kind} <= set(types):
                elements[-1][2].append(Property(name, types[kind], types[length]))
            case ["property", kind, name] if elements and kind in types:
                elements[-1][2].append(Property(name, types[kind], ""))
            case [] | ["comment" | "obj_info", *_]:
                pass
            case _:
                raise ValueError(f"its header has a line {line[:60]!r}")
    if not form:
        raise ValueError("its header has no format")
    return form == "ascii", elements


def _taken(data: bytes, at: int, kind: Any, num: int) -> tuple[np.ndarray, int]:
    """The (num,) values of type ``kind`` from byte ``at`` on, and where they end.

    Raises:
        ValueError: there are not as many.
    """
    end = at + num * np.dtype(kind).itemsize
    if end > len(data):
        raise ValueError("it is cut off: it has less than its header says")
    return np.frombuffer(data[at:end], kind), end


def _row(data: bytes, at: int, properties: list[Property]) -> tuple[list[np.ndarray], int]:
    """One row from byte ``at`` on, (1,) for a number and (n,) for a list, and where it ends."""
    row = []
    for _, kind, length in properties:
        num = 1.0
        if length:
            (num,), at = _taken(data, at, length, 1)
            if num < 0 or num != np.floor(num):
                raise ValueError(f"a list has the length {num:g}")
        values, at = _taken(data, at, kind, int(num))
        row.append(values)
    return row, at


def _columns(data: bytes, at: int, num: int, properties: list[Property]) -> tuple[dict[str, Any], int]:
    """Of each property of an element, (n,) an array, or for lists an array (n, c) or a list of n arrays; and where the
    element ends."""
    widths = [len(values) for values in _row(data, at, properties)[0]]
    # If all lists are as long as those of the first row, a row is a record; else it is read value by value.
    fields: list[Any] = []
    for one, width in zip(properties, widths, strict=True):
        fields += [(f"length of {one.name}", one.length)] * bool(one.length) + [(one.name, one.kind, (width,))]
    record = np.dtype(fields)
    if sum(widths) <= WIDEST and at + num * record.itemsize <= len(data):
        table, end = _taken(data, at, record, num)
        lists = [(one.name, width) for one, width in zip(properties, widths, strict=True) if one.length]
        if all((table[f"length of {name}"] == width).all() for name, width in lists):
            return {one.name: table[one.name] if one.length else table[one.name][:, 0] for one in properties}, end
    rows = []
    for _ in range(num):
        row, at = _row(data, at, properties)
        rows.append(row)
    columns = zip(properties, zip(*rows, strict=True), strict=True)
    return {one.name: list(values) if one.length else np.concatenate(values) for one, values in columns}, at


def of_stl(content: bytes) -> list[np.ndarray]:
    """(T, 3, 3) corners of the triangles of each solid that has any.

    Raises:
        ValueError: the file is cut off, or a facet is no triangle.
    """
    num = int.from_bytes(content[HEADER_BYTES - 4 : HEADER_BYTES], "little")
    expected = HEADER_BYTES + num * ROW.itemsize
    if len(content) >= HEADER_BYTES and len(content) == expected:
        return [np.frombuffer(content, ROW, offset=HEADER_BYTES)["corners"].astype(np.float64)] if num else []
    if b"\0" in content:
        raise ValueError(f"it is cut off, or no STL: {num} triangles need {expected} bytes, it has {len(content)}")
    text = decoded(content)
    pieces = re.split(r"^[ \t]*endsolid\b.*$", text, flags=ONE_LINE)
    if re.search(r"^\s*solid\b", pieces[-1], ONE_LINE):
        raise ValueError("it is cut off: a solid has no endsolid")
    found = [_stl_corners(piece) for piece in pieces[:-1]]
    return [corners for corners in found if len(corners)]


def _stl_corners(text: str) -> np.ndarray:
    """(T, 3, 3) those of one solid; its first line may have any words as its name."""
    text = re.sub(r"^[ \t]*solid\b.*$", "", text, count=1, flags=ONE_LINE)
    words = text.lower().split()
    num, rest = divmod(len(words), WORDS)
    if rest or any(words[at::WORDS] != [word] * num for at, word in FIXED.items()):
        raise ValueError("a facet is not of three vertices")
    columns = [list(map(float, words[at + k :: WORDS])) for at in VERTICES for k in (1, 2, 3)]
    return np.array(columns).reshape(3, 3, num).transpose(2, 0, 1)
