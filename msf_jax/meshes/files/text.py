"""The text of files of other programs; OFF and OBJ files from it: polygons of any number of corners, with or without
colours.

Trimesh's readers cut polygons into fans, expect one face a line in OFF, and count negative indices of OBJ from the end
of the file. Here polygons are cut into triangles: a quad by the shorter of the diagonals that do not fold it, a polygon
of more corners by ear clipping.
"""

import re

import numpy as np

from msf_jax.meshes.holes import lid_of

OFF_HEADER = re.compile(r"\s*(?:ST)?C?N?OFF\b(?!\s*BINARY)", re.IGNORECASE)
MeshArrays = tuple[np.ndarray, np.ndarray]


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


def lines_of(text: str) -> list[str]:
    """The lines of ``text``. `str.splitlines` would also split at characters that may be in a comment or a name."""
    return text.replace("\r\n", "\n").replace("\r", "\n").split("\n")


def of_off(text: str) -> MeshArrays:
    """Vertices (V, 3) and triangles (F, 3) of an OFF file's text.

    Raises:
        ValueError: the text is no OFF file; the message says what it has instead.
    """
    lines = [words for words in (line.split("#")[0].split() for line in lines_of(text)) if words]
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
    if not (is_by_line and all(len(side) > int(side[0]) for side in sides)):
        rows, sides = _by_word([word for line in lines[1:] for word in line], num, num_faces)
    vertices = np.array([row[:3] for row in rows], dtype=np.float64).reshape(-1, 3)
    return vertices, triangulated(vertices, [[int(word) for word in side[1 : int(side[0]) + 1]] for side in sides])


def _by_word(words: list[str], num: int, num_faces: int) -> tuple[list[list[str]], list[list[str]]]:
    """Rows of vertices and of faces in a file without colours, whose line breaks have no meaning."""
    rows = [words[start : start + 3] for start in range(0, min(3 * num, len(words)), 3)]
    sides, start = [], 3 * num
    while len(sides) < num_faces and start < len(words):
        sides.append(words[start : start + 1 + max(int(words[start]), 0)])
        start += len(sides[-1])
    if len(sides) < num_faces or start != len(words) or len(sides[-1]) <= int(sides[-1][0]):
        raise ValueError(f"its counts, {num} vertices and {num_faces} faces, do not fit what follows them")
    return rows, sides


def of_obj(text: str) -> MeshArrays:
    """Vertices (V, 3) and triangles (F, 3), in the order of their faces, of an OBJ file's text.

    Raises:
        ValueError: a line is not of the format; the message says which.
    """
    places: list[list[str]] = []
    polygons: list[list[int]] = []
    for number, line in enumerate(lines_of(re.sub(r"\\(\r\n|\n)", " ", text)), 1):
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
    ears = [face for row in np.flatnonzero(count > 4) for face in _ears(vertices, polygons[row])]
    return np.concatenate(
        [
            corners[start[count == 3][:, None] + np.arange(3)],
            _halves(vertices, quads),
            np.array(ears, dtype=np.int64).reshape(-1, 3),
        ]
    )


def _halves(vertices: np.ndarray, quads: np.ndarray) -> np.ndarray:
    """(2n, 3) the triangles of ``quads`` (n, 4), cut from the first corner to the third, or from the second on."""
    paths = quads[:, [[0, 1, 2, 0, 2, 3], [1, 2, 3, 1, 3, 0]]].reshape(-1, 2, 2, 3)
    a, b, c = np.moveaxis(vertices[paths], 3, 0)
    normal = np.cross(b - a, c - a)
    is_folded = (normal[:, :, 0] * normal[:, :, 1]).sum(axis=-1) < 0
    length = np.linalg.norm(vertices[quads[:, [0, 1]]] - vertices[quads[:, [2, 3]]], axis=-1)
    best = np.lexsort((length, is_folded), axis=-1)[:, 0]
    return paths[np.arange(len(paths)), best].reshape(-1, 3)


def _ears(vertices: np.ndarray, polygon: list[int]) -> list[tuple[int, int, int]]:
    found = lid_of(vertices, polygon, set()) if len(set(polygon)) == len(polygon) else []
    if not found:
        raise ValueError(f"a face of {len(polygon)} corners cannot be cut into triangles")
    return found
