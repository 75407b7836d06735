"""SWC, the format of trees in neuroscience (id, type, x, y, z, radius, parent): writing and reading."""

import json
import re
from typing import TYPE_CHECKING

import numpy as np

from msf_jax.base.errors import ConfigError
from msf_jax.meshes.decoding import lines_of
from msf_jax.skeleton.formats.text import number, point
from msf_jax.topology import graphs

if TYPE_CHECKING:
    from msf_jax.skeleton.skeleton import Skeleton

CUT = "# cut edge"  # begins the comment that lists a cut edge by its two ids
SOMA, FORK, END, OTHER = 1, 5, 6, 0  # labels of the format, without unit
RADII = {"ball": "of the largest ball inside", "section": "of a disc with the area of the cross-section"}
REPORT = "# report: "  # begins the comment with a line of the report
UNITS = "# units: "  # begins the comment with the unit of lengths


def written(skeleton: "Skeleton") -> str:
    """The text: ids from 1, parents before children, -1 for the parent of a root; a tree's root first.

    Labels are those of CNIC: 1 soma, 5 fork, 6 end, 0 other. The root is labelled as soma only if that is sure.
    """
    parent = graphs.tree(len(skeleton.vertices), skeleton.edges, skeleton.roots)
    row_of = {node: index + 1 for index, node in enumerate(parent)}
    cut = [f"{CUT} {row_of[a]} {row_of[b]}" for a, b in skeleton.edges.tolist() if parent[a] != b and parent[b] != a]
    is_known = not np.isnan(skeleton.report.inside)  # a curve that was read from a file has no report
    report = [REPORT + " ".join(line.split()) for line in skeleton.report.lines()] if is_known else []
    header = ["# curve skeleton written by msf_jax", *report]
    header.append("# labels: 1 soma, 5 fork, 6 end, 0 other")
    header.append(f"# radius: {RADII[skeleton.radius_of]}")
    if skeleton.units:
        header.append(UNITS + " ".join(skeleton.units.split()))
        header.append(f"# Meta: {json.dumps({'units': ' '.join(skeleton.units.split())})}")  # navis reads this line
    header.append(f"# loops cut: {len(cut)}; each cut edge is listed by its two ids")
    label = labels(skeleton, parent)
    rows = [
        f"{row_of[node]} {label[node]} {point(skeleton.vertices[node])} {number(skeleton.radii[node])} "
        f"{row_of[above] if above >= 0 else -1}"
        for node, above in parent.items()
    ]
    return "\n".join([*header, *cut, *rows]) + "\n"


def labels(skeleton: "Skeleton", parent: dict[int, int]) -> np.ndarray:
    """(N,) the label of each node in the tree of ``parent``."""
    above = np.array([value for value in parent.values() if value >= 0], dtype=np.int64)
    children = np.bincount(above, minlength=len(skeleton.vertices))
    label = np.select([children > 1, children == 0], [FORK, END], OTHER)
    if skeleton.roots:
        soma = skeleton.soma()
        if soma.is_sure and soma.node == skeleton.roots[0]:
            label[soma.node] = SOMA
    return label


def report_lines(text: str) -> list[str]:
    """The lines of the report in the comments of a file that `written` made; empty for a file of another program."""
    return [line.removeprefix(REPORT) for line in lines_of(text) if line.startswith(REPORT)]


def units_of(lines: list[str]) -> str:
    """The unit of lengths in the comments of a file that `written` made; empty if there is none."""
    return next((line.removeprefix(UNITS).strip() for line in lines if line.startswith(UNITS)), "")


def parsed(name: str, lines: list[str]) -> tuple[np.ndarray, list[tuple[int, int]], np.ndarray]:
    """Nodes (N, 3), edges and radii (N,) of an SWC file's lines; edges that `written` cut are joined again."""
    rows, parents, cuts = {}, {}, []
    for row, line in enumerate(lines, 1):
        words = line.split("#")[0].split()
        if ours := re.match(CUT + r" (\d+) (\d+)\b", line):
            cuts.append(ours.groups())
        if not words:
            continue
        try:
            key, parent = _whole(words[0]), _whole(words[6])
            if key in rows or parent == key:
                raise ValueError
            rows[key] = [float(value) for value in words[2:6]]
            parents[key] = parent
        except (ValueError, IndexError):
            raise ConfigError(
                f"line {row} of {name!r} is {line[:60]!r}: expected id, type, x, y, z, radius, parent, each id once, "
                "and -1 for no parent"
            ) from None
    place = {key: row for row, key in enumerate(rows)}
    joined = [(key, parent) for key, parent in parents.items() if parent >= 0]
    try:
        edges = [(place[a], place[b]) for a, b in joined] + [(place[int(a)], place[int(b)]) for a, b in cuts]
    except (KeyError, ValueError) as error:
        raise ConfigError(f"{name!r} refers to a node {error} that it does not have: expected one of its ids") from None
    table = np.array(list(rows.values()), dtype=np.float64).reshape(-1, 4)
    return table[:, :3], edges, table[:, 3]


def _whole(word: str) -> int:
    """The integer ``word``, which some programs write as 1.0."""
    value = float(word)
    if not value.is_integer():
        raise ValueError
    return int(value)
