"""Curves of other programs, to score, to draw and to write anew: SWC and CGAL's polylines."""

import os
import re
from pathlib import Path

import numpy as np

from msf_jax.errors import ConfigError
from msf_jax.skeleton import Skeleton, curve_of

CUT = r"# cut edge (\d+) (\d+)\b"  # an edge that SWC cannot hold, by its two ids, as `Skeleton.save` writes it


def read_curve(path: str | os.PathLike[str]) -> Skeleton:
    """The curve in an ``.swc`` or a ``.polylines.txt`` file.

    Returns:
        A skeleton with an empty map, and a report that knows counts only. SWC has radii, and edges that this program
        cut are joined again; polylines have radii 0, and ends in the same place are one node.

    Raises:
        ConfigError: the suffix is another, or a line is not of the format: which, and what was expected.
        OSError: the file cannot be read.
    """
    name = Path(path).name
    content = Path(path).read_bytes()
    if b"\0" in content:
        raise ConfigError(f"{name!r} is no text: expected an .swc or a .polylines.txt file")
    try:
        lines = content.decode("utf-8-sig").splitlines()
    except UnicodeDecodeError:
        lines = content.decode("latin-1").splitlines()  # comments; numbers are the same in both
    if name.lower().endswith(".swc"):
        return _from_swc(name, lines)
    if name.lower().endswith(".polylines.txt"):
        return _from_polylines(name, lines)
    raise ConfigError(f"cannot read {name!r}: expected an .swc or a .polylines.txt file")


def _from_swc(name: str, lines: list[str]) -> Skeleton:
    rows, parents, cuts = {}, {}, []
    for number, line in enumerate(lines, 1):
        words = line.split("#")[0].split()
        if ours := re.match(CUT, line):
            cuts.append(ours.groups())
        if not words:
            continue
        try:
            key, parent = _whole(words[0]), _whole(words[6])
            if key in rows:
                raise ValueError
            rows[key] = [float(value) for value in words[2:6]]
            parents[key] = parent
        except (ValueError, IndexError):
            raise ConfigError(
                f"line {number} of {name!r} is {line[:60]!r}: expected id, type, x, y, z, radius, parent, each id once"
            ) from None
    place = {key: row for row, key in enumerate(rows)}
    joined = [(key, parent) for key, parent in parents.items() if parent >= 0]
    try:
        edges = [(place[a], place[b]) for a, b in joined] + [(place[int(a)], place[int(b)]) for a, b in cuts]
    except (KeyError, ValueError) as error:
        raise ConfigError(f"{name!r} names a node {error} that it does not hold: expected one of its ids") from None
    table = np.array(list(rows.values()), dtype=np.float64).reshape(-1, 4)
    return _checked(name, table[:, :3], edges, table[:, 3])


def _whole(word: str) -> int:
    """A whole number; some programs write it as 1.0."""
    value = float(word)
    if not value.is_integer():
        raise ValueError
    return int(value)


def _from_polylines(name: str, lines: list[str]) -> Skeleton:
    points, edges = [], []
    for number, line in enumerate(lines, 1):
        if not line.strip():
            continue
        try:
            count, *values = line.split()
            way = np.array(values, dtype=np.float64).reshape(max(int(count), 0), 3)
        except ValueError:
            raise ConfigError(
                f"line {number} of {name!r} is no polyline: expected a count, and as many points of three numbers"
            ) from None
        start = len(points)
        points += way.tolist()
        edges += [(k, k + 1) for k in range(start, len(points) - 1)]
    given = np.array(points).reshape(-1, 3)
    first, inverse = np.unique(given, axis=0, return_index=True, return_inverse=True)[1:]
    order = np.argsort(first)  # in the order of the file
    rank = np.empty(len(order), dtype=np.int64)
    rank[order] = np.arange(len(order))
    joined = rank[inverse.ravel()][np.array(edges, dtype=np.int64).reshape(-1, 2)]
    return _checked(name, given[first[order]], joined, np.zeros(len(order)))


def _checked(name: str, vertices: np.ndarray, edges: object, radii: np.ndarray) -> Skeleton:
    pairs = np.unique(np.sort(np.array(edges, dtype=np.int64).reshape(-1, 2), axis=1), axis=0)
    pairs = pairs[pairs[:, 0] != pairs[:, 1]]
    if len(vertices) == 0 or not np.isfinite(vertices).all() or not np.isfinite(radii).all():
        raise ConfigError(f"{name!r} holds {len(vertices)} nodes, not all finite: expected at least one, with numbers")
    return curve_of(vertices, pairs, radii)
