"""Reading of STL files, as bytes or as text: the corners of every solid. A file that is cut off is refused."""

import re

import numpy as np

from msf_jax.meshes.files.text import decoded

# Of a binary file: 80 bytes of text and the number of facets (uint32), then a row for each facet.
HEADER_BYTES, ROW = 84, np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
WORDS, VERTICES = 21, (7, 11, 15)  # of a facet in text: how many, and where "vertex" is
FIXED = {0: "facet", 5: "outer", 6: "loop", **dict.fromkeys(VERTICES, "vertex"), 19: "endloop", 20: "endfacet"}
ONE_LINE = re.IGNORECASE | re.MULTILINE


def solids(content: bytes) -> list[np.ndarray]:
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
    found = [_corners(piece) for piece in pieces[:-1]]
    return [corners for corners in found if len(corners)]


def _corners(text: str) -> np.ndarray:
    """(T, 3, 3) those of one solid; its first line may have any words as its name."""
    text = re.sub(r"^[ \t]*solid\b.*$", "", text, count=1, flags=ONE_LINE)
    words = text.lower().split()
    num, rest = divmod(len(words), WORDS)
    if rest or any(words[at::WORDS] != [word] * num for at, word in FIXED.items()):
        raise ValueError("a facet is not of three vertices")
    columns = [list(map(float, words[at + k :: WORDS])) for at in VERTICES for k in (1, 2, 3)]
    return np.array(columns).reshape(3, 3, num).transpose(2, 0, 1)
