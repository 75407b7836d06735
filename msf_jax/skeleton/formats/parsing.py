"""Reading of text formats: OBJ's lines, CG, PLY with edges, GraphML. Each gives nodes (N, 3), edges and radii (N,)."""

import itertools

import networkx as nx
import numpy as np

from msf_jax.base.errors import ConfigError
from msf_jax.meshes.files.ply import tables

Parsed = tuple[np.ndarray, list[tuple[int, int]], np.ndarray]


def obj(name: str, lines: list[str]) -> Parsed:
    """Wavefront OBJ: vertices, and line elements, which may be polylines."""
    return _listed(name, lines, "l")


def cg(name: str, lines: list[str]) -> Parsed:
    """A curve graph: vertices and edges."""
    return _listed(name, lines, "e")


def _listed(name: str, lines: list[str], kind: str) -> Parsed:
    """The graph in lines where ``v`` begins a node, and ``kind`` begins a chain of node numbers from 1."""
    nodes, edges = [], []
    for number, line in enumerate(lines, 1):
        words = line.split("#")[0].split()
        try:
            if words[:1] == ["v"]:
                nodes.append([float(word) for word in words[1:4]])
                if len(nodes[-1]) != 3:
                    raise ValueError
            elif words[:1] == [kind]:
                chain = [int(word.split("/")[0]) for word in words[1:]]
                chain = [len(nodes) + node if node < 0 else node - 1 for node in chain]
                edges += list(itertools.pairwise(chain))
        except ValueError:
            raise ConfigError(
                f"line {number} of {name!r} is {line[:60]!r}: expected v and three numbers, or {kind} and nodes from 1"
            ) from None
    return np.array(nodes, dtype=np.float64).reshape(-1, 3), edges, np.zeros(len(nodes))


def ply(name: str, lines: list[str]) -> Parsed:
    """PLY as text, with elements vertex (x, y, z, and radius if there is one) and edge (vertex1, vertex2)."""
    try:
        held = tables("\n".join(lines).encode(), only_text=True)
        nodes = np.stack([held["vertex"][axis] for axis in "xyz"], axis=1).astype(np.float64)
        radii = np.asarray(held["vertex"].get("radius", np.zeros(len(nodes))), dtype=np.float64)
        ends = [held["edge"][end] for end in ("vertex1", "vertex2")]
        return nodes, [(int(a), int(b)) for a, b in zip(*ends, strict=True)], radii
    except (ValueError, KeyError, OverflowError) as error:
        reason = f"there is no {error}" if isinstance(error, KeyError) else str(error)
        raise ConfigError(
            f"{name!r} is no PLY of a curve ({reason}): expected elements vertex, with x, y and z, and edge, with "
            "vertex1 and vertex2, as text"
        ) from None


def graphml(name: str, lines: list[str]) -> Parsed:
    """NetworkX's GraphML, whose nodes have x, y, z, and optionally radius."""
    if any("<!ENTITY" in line or "<!DOCTYPE" in line for line in lines):
        raise ConfigError(f"{name!r} declares entities: expected plain GraphML")
    try:
        graph = nx.parse_graphml("\n".join(lines))
        rank = {node: number for number, node in enumerate(graph)}
        data = [graph.nodes[node] for node in graph]
        nodes = np.array([[float(one[axis]) for axis in "xyz"] for one in data]).reshape(-1, 3)
        radii = np.array([float(one.get("radius", 0.0)) for one in data])
        return nodes, [(rank[edge[0]], rank[edge[1]]) for edge in graph.edges], radii
    except Exception as error:  # for a damaged file the parser raises exceptions of many types
        raise ConfigError(
            f"{name!r} is no GraphML of a curve ({type(error).__name__}: {str(error)[:100]}): expected nodes with x, y "
            "and z"
        ) from error
