"""Text formats of other programs: SWC, OBJ, PLY, GraphML, CGAL's polylines. A writer and a reader of each.

A reader takes the file's name and its lines, and gives nodes (N, 3), edges (E, 2) and radii (N,).
"""

import itertools
import json
import re
from typing import TYPE_CHECKING, Any

import networkx as nx
import numpy as np

from msf_jax.base.errors import ConfigError
from msf_jax.topology import graphs

if TYPE_CHECKING:
    from msf_jax.skeleton.skeleton import Skeleton

Parsed = tuple[np.ndarray, Any, np.ndarray]
WRITTEN = "curve skeleton written by msf_jax"
CUT = "# cut edge"  # begins the comment of an SWC file that lists a cut edge by its two ids
REPORT = "# report: "  # begins the comment with a line of the report
UNITS = "# units: "  # begins the comment with the unit of lengths
SOMA, FORK, END, OTHER = 1, 5, 6, 0  # labels of SWC, as CNIC counts them
RADII = {"ball": "of the largest ball inside", "section": "of a disc with the area of the cross-section"}


def number(value: float) -> str:
    """The shortest text that reads back to the same float64."""
    return repr(float(value))


def point(position: np.ndarray) -> str:
    """The coordinates, separated by spaces."""
    return " ".join(map(number, position))


def swc(skeleton: "Skeleton") -> str:
    """SWC (id, label, x, y, z, radius, parent): ids from 1, parents before children, -1 for the parent of a root; a
    tree's root first. The root is labelled as soma only if that is sure."""
    parent = graphs.tree(len(skeleton.vertices), skeleton.edges, skeleton.roots)
    row_of = {node: row for row, node in enumerate(parent, 1)} | {-1: -1}
    cut = [f"{CUT} {row_of[a]} {row_of[b]}" for a, b in skeleton.edges.tolist() if parent[a] != b and parent[b] != a]
    header = [f"# {WRITTEN}"]
    if not np.isnan(skeleton.report.inside):  # a curve that was read from a file has no report
        header += [REPORT + " ".join(line.split()) for line in skeleton.report.lines()]
    header.append(f"# labels: {SOMA} soma, {FORK} fork, {END} end, {OTHER} other")
    header.append(f"# radius: {RADII[skeleton.radius_of]}")
    if units := " ".join(skeleton.units.split()):
        header += [UNITS + units, f"# Meta: {json.dumps({'units': units})}"]  # navis reads the second
    header.append(f"# loops cut: {len(cut)}; each cut edge is listed by its two ids")
    label = swc_labels(skeleton, parent)
    rows = [
        f"{row_of[node]} {label[node]} {point(skeleton.vertices[node])} {number(skeleton.radii[node])} {row_of[above]}"
        for node, above in parent.items()
    ]
    return "\n".join([*header, *cut, *rows]) + "\n"


def swc_labels(skeleton: "Skeleton", parent: dict[int, int]) -> np.ndarray:
    """(N,) the label of each node in the tree of ``parent``."""
    above = np.array([value for value in parent.values() if value >= 0], dtype=np.int64)
    children = np.bincount(above, minlength=len(skeleton.vertices))
    label = np.select([children > 1, children == 0], [FORK, END], OTHER)
    if skeleton.roots and (soma := skeleton.soma()).is_sure and soma.node == skeleton.roots[0]:
        label[soma.node] = SOMA
    return label


def comments(lines: list[str], start: str) -> list[str]:
    """The rest of each comment that begins with ``start``, `REPORT` or `UNITS`."""
    return [line.removeprefix(start).strip() for line in lines if line.startswith(start)]


def read_swc(name: str, lines: list[str]) -> Parsed:
    """Edges that `swc` cut are joined again."""
    rows, parents, cuts = {}, {}, []
    for row, line in enumerate(lines, 1):
        if ours := re.match(CUT + r" (\d+) (\d+)\b", line):
            cuts.append(tuple(map(int, ours.groups())))
        words = line.split("#")[0].split()
        if not words:
            continue
        try:
            key, parent = float(words[0]), float(words[6])  # some programs write 1.0
            if key in rows or parent == key or not (key.is_integer() and parent.is_integer()):
                raise ValueError
            rows[key], parents[key] = [float(value) for value in words[2:6]], parent
        except (ValueError, IndexError):
            raise ConfigError(
                f"line {row} of {name!r} is {line[:60]!r}: expected id, type, x, y, z, radius, parent, each id once, "
                "and -1 for no parent"
            ) from None
    place = {key: row for row, key in enumerate(rows)}
    pairs = [*((key, parent) for key, parent in parents.items() if parent >= 0), *cuts]
    if missing := [key for pair in pairs for key in pair if key not in place]:
        raise ConfigError(f"{name!r} refers to a node {missing[0]:.0f} that it does not have: expected one of its ids")
    table = np.array(list(rows.values()), dtype=np.float64).reshape(-1, 4)
    return table[:, :3], [(place[a], place[b]) for a, b in pairs], table[:, 3]


def obj(skeleton: "Skeleton") -> str:
    """Wavefront OBJ: vertices and line elements."""
    vertices = [f"v {point(position)}" for position in skeleton.vertices]
    return "\n".join([f"# {WRITTEN}", *vertices, *(f"l {a + 1} {b + 1}" for a, b in skeleton.edges.tolist())]) + "\n"


def read_obj(name: str, lines: list[str]) -> Parsed:
    """Line elements may be polylines, and count from the end with negative numbers. Radii are 0."""
    nodes, edges = [], []
    for row, line in enumerate(lines, 1):
        words = line.split("#")[0].split()
        try:
            if words[:1] == ["v"]:
                x, y, z = map(float, words[1:4])
                nodes.append((x, y, z))
            elif words[:1] == ["l"]:
                chain = [int(word.split("/")[0]) for word in words[1:]]
                edges += itertools.pairwise(len(nodes) + node if node < 0 else node - 1 for node in chain)
        except ValueError:
            raise ConfigError(
                f"line {row} of {name!r} is {line[:60]!r}: expected v and three numbers, or l and nodes from 1"
            ) from None
    return np.array(nodes, dtype=np.float64).reshape(-1, 3), edges, np.zeros(len(nodes))


def ply(skeleton: "Skeleton") -> str:
    """PLY: vertices with radius, edges."""
    header = ["ply", "format ascii 1.0", f"comment {WRITTEN}", f"element vertex {len(skeleton.vertices)}"]
    header += [f"property double {name}" for name in ("x", "y", "z", "radius")]
    header += [f"element edge {len(skeleton.edges)}", "property int vertex1", "property int vertex2", "end_header"]
    rows = [f"{point(at)} {number(radius)}" for at, radius in zip(skeleton.vertices, skeleton.radii, strict=True)]
    return "\n".join([*header, *rows, *(f"{a} {b}" for a, b in skeleton.edges.tolist())]) + "\n"


def read_ply(name: str, lines: list[str]) -> Parsed:
    """Text with elements vertex (x, y, z, and radius if there is one) and edge (vertex1, vertex2), without lists."""
    try:
        form = next((line.split()[1] for line in lines if line.startswith("format ")), "no PLY")
        if form != "ascii":
            raise ValueError(f"it is {form}: expected ascii")
        end = [line.strip() for line in lines].index("end_header")
        header, rows = [line.split() for line in lines[:end]], [line for line in lines[end + 1 :] if line.strip()]
        tables: dict[str, dict[str, np.ndarray]] = {}
        starts = [number for number, words in enumerate(header) if words[:1] == ["element"]]
        for start, stop in itertools.pairwise([*starts, len(header)]):
            num, names = int(header[start][2]), [words[2] for words in header[start:stop] if words[0] == "property"]
            if not 0 <= num <= len(rows):
                raise ValueError(f"it has fewer rows than {num}, as its header says")
            values = np.array([line.split() for line in rows[:num]], dtype=np.float64).reshape(num, len(names))
            tables[header[start][1]], rows = dict(zip(names, values.T, strict=True)), rows[num:]
        nodes = np.stack([tables["vertex"][axis] for axis in "xyz"], axis=1)
        edges = np.stack([tables["edge"][end] for end in ("vertex1", "vertex2")], axis=1)
        if rows or not ((edges >= 0) & (edges < len(nodes)) & (edges == np.rint(edges))).all():
            raise ValueError("it has more rows than its header says, or edges to nodes that it does not have")
        return nodes, edges, tables["vertex"].get("radius", np.zeros(len(nodes)))
    except (ValueError, KeyError, IndexError, OverflowError, MemoryError) as error:
        reason = f"there is no {error}" if isinstance(error, KeyError) else str(error)
        raise ConfigError(
            f"{name!r} is no PLY of a curve ({reason}): expected elements vertex, with x, y and z, and edge, with "
            "vertex1 and vertex2, as text"
        ) from None


def polylines(skeleton: "Skeleton") -> str:
    """CGAL's polylines: a line for each branch, the number of points and their coordinates."""
    return "".join(
        f"{len(branch)} {' '.join(map(point, skeleton.vertices[branch]))}\n"
        for branch in graphs.trace(len(skeleton.vertices), skeleton.edges)
    )


def read_polylines(name: str, lines: list[str]) -> Parsed:
    """Coincident ends become one node, in the order of the file. Radii are 0."""
    points, edges = [], []
    for row, line in enumerate(lines, 1):
        if not line.strip():
            continue
        try:
            count, *values = line.split()
            path = np.array(values, dtype=np.float64).reshape(max(int(count), 0), 3)
        except (ValueError, OverflowError):
            raise ConfigError(
                f"line {row} of {name!r} is no polyline: expected a count, and as many points of three numbers"
            ) from None
        edges += itertools.pairwise(range(len(points), len(points) + len(path)))
        points += path.tolist()
    given = np.array(points).reshape(-1, 3)
    first, inverse = np.unique(given, axis=0, return_index=True, return_inverse=True)[1:]
    order = np.argsort(first)
    joined = np.argsort(order)[inverse.ravel()][np.array(edges, dtype=np.int64).reshape(-1, 2)]
    return given[first[order]], joined, np.zeros(len(order))


def graphml(skeleton: "Skeleton") -> str:
    """Nodes with x, y, z and radius, edges with length, by NetworkX."""
    graph = skeleton.to_networkx()
    for _, data in graph.nodes(data=True):  # attributes must be numbers
        data["x"], data["y"], data["z"] = data.pop("position")
    return "\n".join(nx.generate_graphml(graph)) + "\n"


def read_graphml(name: str, lines: list[str]) -> Parsed:
    """Nodes with x, y, z, and radius if there is one."""
    if any("<!ENTITY" in line or "<!DOCTYPE" in line for line in lines):
        raise ConfigError(f"{name!r} declares entities: expected plain GraphML")
    try:
        graph = nx.convert_node_labels_to_integers(nx.parse_graphml("\n".join(lines)))
        data = [each for _, each in graph.nodes(data=True)]
        nodes = np.array([[float(one[axis]) for axis in "xyz"] for one in data]).reshape(-1, 3)
        return nodes, [edge[:2] for edge in graph.edges], np.array([float(one.get("radius", 0.0)) for one in data])
    except Exception as error:  # for a damaged file the parser raises exceptions of many types
        raise ConfigError(
            f"{name!r} is no GraphML of a curve ({type(error).__name__}: {str(error)[:100]}): expected nodes with x, y "
            "and z"
        ) from error
