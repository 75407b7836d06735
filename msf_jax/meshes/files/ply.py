"""Reading of PLY files, as bytes or as text: the triangles of a mesh.

Sizes are compared with the file's before memory is allocated. Lists may have any lengths, which trimesh cannot read in
bytes and does not check in text.
"""

import re
import warnings
from typing import Any, NamedTuple

import numpy as np

from msf_jax.meshes.files.text import decoded, lines_of, triangulated

HEADER = re.compile(rb"\A(?:\xef\xbb\xbf)?(ply\b.*?[\r\n])end_header[ \t]*(?:\r\n|\n|\r)", re.DOTALL)
KINDS = "char uchar short ushort int uint float double int8 uint8 int16 uint16 int32 uint32 float32 float64"
TYPES: dict[str, str] = dict(zip(KINDS.split(), 2 * ["i1", "u1", "i2", "u2", "i4", "u4", "f4", "f8"], strict=True))
WIDEST = 256  # numbers in a row that are read by column
CORNERS = ("vertex_indices", "vertex_index")  # names of the list of a face's corners


class Property(NamedTuple):
    """A property of an element, with NumPy types: a list has a type of its length, too."""

    name: str
    kind: str
    length: str


def mesh(content: bytes) -> tuple[np.ndarray, np.ndarray]:
    """Vertices (V, 3) and triangles (F, 3) of a file; none for a file of points or lines.

    Raises:
        ValueError: it is no PLY, or is damaged; the message says where.
    """
    head = HEADER.match(content)
    if head is None:
        raise ValueError("it does not begin with ply, or its header has no end_header")
    form, elements = _header(decoded(head[1]))
    data = content[head.end() :]
    if form == "ascii":
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", DeprecationWarning)  # older NumPy stops at a word that is no number
            source = _Source(np.fromstring(data.decode("latin-1"), sep=" "), "<")
    else:
        source = _Source(data, "<" if form == "binary_little_endian" else ">")
    columns = {name: _columns(source, num, properties) for name, num, properties in elements}
    vertices = np.stack([np.asarray(columns["vertex"][axis], dtype=np.float64) for axis in "xyz"], axis=1)
    lists = [one.name for name, _, properties in elements if name == "face" for one in properties if one.length]
    name = next((name for name in (*CORNERS, *lists) if name in lists), None)
    rows = [] if name is None else columns["face"][name]
    flat = rows.ravel() if isinstance(rows, np.ndarray) else np.concatenate([np.empty(0), *rows])
    if not ((flat == np.floor(flat)) & (np.abs(flat) < 2**53)).all():
        raise ValueError("a corner of a face is no whole number")
    if isinstance(rows, np.ndarray) and rows.shape[1:] == (3,):
        return vertices, rows.astype(np.int64)
    return vertices, triangulated(vertices, [np.asarray(row).astype(np.int64).tolist() for row in rows])


def _header(text: str) -> tuple[str, list[tuple[str, int, list[Property]]]]:
    """The form of the file, and its elements: name, number, properties."""
    elements: list[tuple[str, int, list[Property]]] = []
    form = ""
    for line in lines_of(text)[1:]:
        match line.split():
            case ["format", "ascii" | "binary_little_endian" | "binary_big_endian" as form, *_]:
                pass
            case ["element", name, num] if num.isdigit():
                elements.append((name, int(num), []))
            case ["property", "list", length, kind, name] if elements and {length, kind} <= set(TYPES):
                elements[-1][2].append(Property(name, TYPES[kind], TYPES[length]))
            case ["property", kind, name] if elements and kind in TYPES:
                elements[-1][2].append(Property(name, TYPES[kind], ""))
            case [] | ["comment" | "obj_info", *_]:
                pass
            case _:
                raise ValueError(f"its header has a line {line[:60]!r}")
    if not form:
        raise ValueError("its header has no format")
    return form, elements


class _Source:
    """The data after the header, read from front to back: numbers of a text, or bytes."""

    def __init__(self, data: np.ndarray | bytes, order: str) -> None:
        self.data, self.order, self.at = data, order, 0

    def take(self, kinds: list[str], num: int) -> list[np.ndarray]:
        """The columns of ``num`` rows, each with a number of each of ``kinds``.

        Raises:
            ValueError: there are not as many.
        """
        row = np.dtype([(str(place), self.order + kind) for place, kind in enumerate(kinds)])
        size = num * (len(kinds) if isinstance(self.data, np.ndarray) else row.itemsize)
        if self.at + size > len(self.data):
            raise ValueError("it is cut off: it has less than its header says")
        start, self.at = self.at, self.at + size
        if isinstance(self.data, np.ndarray):
            return list(self.data[start : self.at].reshape(num, len(kinds)).T)
        table = np.frombuffer(self.data, row, num, start)
        return [table[name] for name in row.names or ()]

    def row(self, properties: list[Property]) -> list[np.ndarray]:
        """One row: (1,) for a number, (n,) for a list."""
        found = []
        for _, kind, length in properties:
            num = float(self.take([length], 1)[0][0]) if length else 1.0
            if num < 0 or num != np.floor(num):
                raise ValueError(f"a list has the length {num:g}")
            found.append(self.take([kind], int(num))[0])
        return found


def _columns(source: _Source, num: int, properties: list[Property]) -> dict[str, Any]:
    """Of each property of one element, (n,) an array, or for lists a list of n arrays or an array (n, c)."""
    if not num or not properties:
        return {one.name: np.empty(0) for one in properties}
    start = source.at
    widths = [len(values) for values in source.row(properties)]
    after, source.at = source.at, start
    if sum(widths) <= WIDEST and start + num * (after - start) <= len(source.data):
        kinds: list[str] = []
        for one, width in zip(properties, widths, strict=True):
            kinds += [one.length] * bool(one.length) + [one.kind] * width
        columns, found = iter(source.take(kinds, num)), {}
        for one, width in zip(properties, widths, strict=True):
            if one.length and (next(columns) != width).any():
                break
            values = [next(columns) for _ in range(width)]
            found[one.name] = np.stack(values, axis=1) if one.length and width else values[0] if width else [[]] * num
        else:
            return found
        source.at = start
    rows = [source.row(properties) for _ in range(num)]
    lists = zip(properties, zip(*rows, strict=True), strict=True)
    return {one.name: list(values) if one.length else np.concatenate(values) for one, values in lists}
