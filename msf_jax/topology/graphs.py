"""Graphs whose edges are pairs of nodes: components, forests, paths between ends; and half-edges of triangle lists.

A sparse matrix adds up the weights of edges that occur several times, and takes a weight of 0 for no edge.
"""

from typing import NamedTuple

import networkx as nx
import numpy as np
from scipy import sparse
from scipy.sparse import csgraph


def weighted(num: int, tail: np.ndarray, head: np.ndarray, weight: np.ndarray | None = None) -> sparse.csr_matrix:
    """The sparse matrix (num, num) with the ``weight`` (E,) of each edge from ``tail`` to ``head``, default 1."""
    weight = np.ones(len(tail)) if weight is None else weight
    return sparse.csr_matrix((weight, (tail, head)), shape=(num, num))


def labels(num: int, tail: np.ndarray, head: np.ndarray) -> np.ndarray:
    """(num,) the connected component of each node. Components are numbered in the order of their first nodes."""
    return csgraph.connected_components(weighted(num, tail, head), directed=False)[1]


def labels_of_faces(faces: np.ndarray, num: int) -> np.ndarray:
    """(num,) the connected component of each vertex of a surface ``faces`` (F, 3)."""
    return labels(num, faces[:, [0, 1]].ravel(), faces[:, [1, 2]].ravel())


def pieces(faces: np.ndarray, num: int) -> np.ndarray:
    """(F,) the connected piece of each of ``faces`` (F, 3) of ``num`` vertices, by number from 0 on."""
    label = labels_of_faces(faces, num)[faces[:, 0]]
    return (np.cumsum(np.bincount(label) > 0) - 1)[label]


def lengths(vertices: np.ndarray, edges: np.ndarray) -> np.ndarray:
    """(E,) the length of each edge, at least 1e-300: a sparse matrix takes 0 for no edge."""
    return np.maximum(np.linalg.norm(vertices[edges[:, 0]] - vertices[edges[:, 1]], axis=1), 1e-300)


def degrees(num: int, edges: np.ndarray) -> np.ndarray:
    """(num,) the number of edges at each node."""
    return np.bincount(edges.ravel(), minlength=num)


def trace(num_nodes: int, edges: np.ndarray) -> list[list[int]]:
    """The node list of each branch, between nodes that do not have two edges; a loop repeats its first node.

    An isolated node is a branch of one node."""
    near: list[list[int]] = [[] for _ in range(num_nodes)]  # neighbours of each node, ascending
    for a, b in np.unique(np.sort(edges, axis=1), axis=0).tolist():
        near[a].append(b)
        near[b].append(a)
    branches: list[list[int]] = []
    seen: set[tuple[int, int]] = set()  # first steps of branches, from both ends

    def follow(start: int, onward: int) -> None:
        branch = [start, onward]
        while len(near[branch[-1]]) == 2 and branch[-1] != start:
            a, b = near[branch[-1]]
            branch.append(b if a == branch[-2] else a)
        seen.update(((branch[0], branch[1]), (branch[-1], branch[-2])))
        branches.append(branch)

    ends = [node for node in range(num_nodes) if len(near[node]) != 2]
    branches += [[node] for node in ends if not near[node]]
    for node in ends:
        for onward in near[node]:
            if (node, onward) not in seen:
                follow(node, onward)
    covered = {node for branch in branches for node in branch}
    for node in range(num_nodes):
        if node not in covered:
            follow(node, near[node][0])
            covered.update(branches[-1])
    return branches


def cycle_count(num_nodes: int, edges: np.ndarray) -> tuple[int, int]:
    """The numbers of components and of independent cycles of a graph."""
    components = int(labels(num_nodes, *edges.T).max(initial=-1)) + 1
    return components, len(edges) - num_nodes + components


def core(num_nodes: int, edges: np.ndarray) -> np.ndarray:
    """(N,) which nodes are left when leaves are removed until there are none: of loops, and of paths between loops. An
    edge from a node to itself is no loop."""
    graph = nx.Graph()
    graph.add_edges_from(edges[edges[:, 0] != edges[:, 1]].tolist())
    number = nx.core_number(graph)
    return np.array([number.get(node, 0) > 1 for node in range(num_nodes)], dtype=bool)


def nearest_along(vertices: np.ndarray, edges: np.ndarray, is_source: np.ndarray) -> np.ndarray:
    """(N,) the nearest source along the curve, of ``is_source`` (N,); a source's is itself. Each component needs
    one."""
    graph = weighted(len(vertices), *edges.T, weight=lengths(vertices, edges))
    return csgraph.dijkstra(
        graph, directed=False, indices=np.flatnonzero(is_source), min_only=True, return_predecessors=True
    )[2]


def shortest_forest(num_nodes: int, edges: np.ndarray, length: np.ndarray) -> np.ndarray:
    """(E,) which edges are in the minimum spanning forest by ``length`` (E,), ties by number."""
    order = np.argsort(length, kind="stable")
    # Only the shortest edge between two nodes: a sparse matrix would add parallel edges up.
    order = order[np.sort(np.unique(np.sort(edges[order], axis=1), axis=0, return_index=True)[1])]
    rank = np.arange(1, len(order) + 1)  # distinct, and never 0
    ends = np.sort(edges[order], axis=1).T
    graph = weighted(num_nodes, *ends, weight=rank)
    is_in = np.zeros(len(edges), dtype=bool)
    is_in[order[np.rint(csgraph.minimum_spanning_tree(graph).data).astype(np.int64) - 1]] = True
    return is_in & (edges[:, 0] != edges[:, 1])


def forest(a: np.ndarray, b: np.ndarray, num: int) -> np.ndarray:
    """The parent (num,) of each node in a breadth-first tree of its component, -1 at the root."""
    roots = np.unique(labels(num, a, b), return_index=True)[1]
    tail, head = np.concatenate([a, np.full(len(roots), num)]), np.concatenate([b, roots])  # one root above them all
    joined = weighted(num + 1, np.concatenate([tail, head]), np.concatenate([head, tail]))
    parent = csgraph.dijkstra(joined, unweighted=True, indices=num, return_predecessors=True)[1][:num]
    return np.where(parent == num, -1, parent.astype(np.int64))


def down_forest(parent: np.ndarray, last: np.ndarray) -> np.ndarray:
    """(N, ...) sums along the paths from a root to each node. ``last`` (N, ...) are values of last steps, 0 at a root.

    ``parent`` (N,) is negative at a root."""
    above, total = np.where(parent < 0, np.arange(len(parent)), parent), last
    while (above != above[above]).any():  # pointer doubling: the summed paths double in length
        total, above = total + total[above], above[above]
    return total


def cycles(
    num_nodes: int, edges: np.ndarray, values: np.ndarray, length: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """A basis of a graph's cycles, each an edge with its path in the shortest spanning forest by ``length`` (E,).

    Returns the edge (C,) that closes each cycle, the shortest first, the sums (C, ...) of the ``values`` (E, ...)
    around the cycles, and those (N, ...) along the forest, from a root to each node. An edge that a path takes from
    its second node to its first counts with the opposite sign."""
    in_forest = shortest_forest(num_nodes, edges, length)
    a, b = edges[in_forest].T
    parent = forest(a, b, num_nodes)
    last = np.zeros((num_nodes, *values.shape[1:]), dtype=values.dtype)
    for tail, head, step in ((a, b, values[in_forest]), (b, a, -values[in_forest])):
        leads = parent[head] == tail
        last[head[leads]] = step[leads]
    along, closing = down_forest(parent, last), np.flatnonzero(~in_forest)
    closing = closing[np.argsort(length[closing], kind="stable")]
    a, b = edges[closing].T
    return closing, values[closing] + along[a] - along[b], along


class HalfEdges(NamedTuple):
    """Half-edges of a triangle list: half-edge 3f + c goes from corner c of face f to the next corner."""

    origin: np.ndarray
    target: np.ndarray
    twin: np.ndarray  # the half-edge in the other direction, or -1


def half_edges(faces: np.ndarray) -> HalfEdges:
    """Half-edges of ``faces`` (F, 3) with their twins. The mesh may be open, but no half-edge may occur twice."""
    origin, target = faces.ravel(), faces[:, [1, 2, 0]].ravel()
    if not len(faces):
        return HalfEdges(origin, target, origin)
    size = 2 * (int(faces.max()) + 1,)
    number = sparse.csr_matrix((np.arange(1, len(origin) + 1), (origin, target)), shape=size)  # from 1: 0 is no entry
    return HalfEdges(origin, target, np.asarray(number[target, origin]).ravel() - 1)


def edge_codes(faces: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """For each half-edge, its edge; for each edge, its smaller end and its number of faces."""
    ends = np.sort(np.stack([faces, faces[:, [1, 2, 0]]], axis=-1).reshape(-1, 2), axis=1).astype(np.int64)
    num = np.int64(faces.max(initial=-1)) + 1
    code, edge, count = np.unique(ends[:, 0] * num + ends[:, 1], return_inverse=True, return_counts=True)
    return edge.ravel(), code // max(num, 1), count


def by_label(label: np.ndarray) -> list[np.ndarray]:
    """For each label 0, 1, ..., up to the largest, its indices (n,) in ``label``, ascending."""
    return np.split(np.argsort(label, kind="stable"), np.cumsum(np.bincount(label))[:-1])
