"""A curve as branches: the ways between nodes that have other than two edges, and how much each of them matters."""

from typing import NamedTuple

import networkx as nx
import numpy as np
from scipy import sparse, spatial
from scipy.sparse import csgraph


class Branch(NamedTuple):
    """nodes: along the branch; a closed one names its first node again at its end. length: of the way.

    persistence: for a branch that ends in a leaf, 1 + (how far its balls reach out of those of the rest of the curve) /
    (radius at its junction). A twig inside a tube has 1, a limb that sticks out of it by h has 1 + h / radius. Infinite
    for a branch without a junction, and for one that joins two of them, or a junction to itself: taking it away would
    change the curve's components or cycles.

    surface: share of the mesh's area that goes to the branch's own nodes, its junctions not among them; NaN if unknown.
    """

    nodes: list[int]
    length: float
    persistence: float
    surface: float

    def __repr__(self) -> str:
        ends = f"{self.nodes[0]} to {self.nodes[-1]}"
        numbers = f"length {self.length:.4g}, persistence {self.persistence:.3g}"
        return f"Branch({len(self.nodes)} nodes from {ends}, {numbers})"


def trace(num_nodes: int, edges: np.ndarray) -> list[list[int]]:
    """Node lists between nodes that have other than two edges; a loop without one is closed.

    A lone node is a branch of its own, of one node.
    """
    graph = nx.Graph()
    graph.add_nodes_from(range(num_nodes))
    graph.add_edges_from(edges.tolist())
    ends = [node for node, degree in graph.degree if degree != 2]
    branches = [[node] for node in ends if graph.degree[node] == 0]
    seen: set[tuple[int, int]] = set()

    def follow(start: int, onward: int) -> list[int]:
        branch = [start, onward]
        while graph.degree[branch[-1]] == 2 and branch[-1] != start:
            a, b = graph[branch[-1]]
            branch.append(b if a == branch[-2] else a)
        seen.add((branch[0], branch[1]))
        seen.add((branch[-1], branch[-2]))
        return branch

    for node in ends:
        branches += [follow(node, onward) for onward in sorted(graph[node]) if (node, onward) not in seen]
    covered = {node for branch in branches for node in branch}
    for loop in nx.connected_components(graph):
        if not loop & covered:
            start = min(loop)
            branches.append(follow(start, min(graph[start])))
    return branches


def cycle_count(num_nodes: int, edges: np.ndarray) -> tuple[int, int]:
    """Components and independent cycles of a graph."""
    graph = sparse.coo_matrix((np.ones(len(edges)), (edges[:, 0], edges[:, 1])), shape=(num_nodes, num_nodes))
    components = int(csgraph.connected_components(graph, directed=False)[0])
    return components, len(edges) - num_nodes + components


def cut_loops(num_nodes: int, edges: np.ndarray, radii: np.ndarray) -> np.ndarray:
    """(E,) which edges stay when every loop is cut at the thinnest of its edges: a spanning tree of the thickest.

    An edge is as thick as the smaller of the balls at its ends; of equal ones that with the smaller other ball goes.
    """
    order = np.lexsort((-radii[edges].max(axis=1), -radii[edges].min(axis=1)))
    rank = np.empty(len(edges))
    rank[order] = np.arange(1, len(edges) + 1)  # no two weigh the same, and none nothing
    graph = sparse.coo_matrix((rank, (edges[:, 0], edges[:, 1])), shape=(num_nodes, num_nodes))
    left = np.rint(csgraph.minimum_spanning_tree(graph).data).astype(np.int64) - 1
    return np.isin(np.arange(len(edges)), order[left])


def roots_of(num_nodes: int, edges: np.ndarray, radii: np.ndarray, root: int | None) -> tuple[int, ...]:
    """The node with the largest ball in each component, the thickest first; ``root`` instead in its own, before all."""
    graph = sparse.coo_matrix((np.ones(len(edges)), (edges[:, 0], edges[:, 1])), shape=(num_nodes, num_nodes))
    label = csgraph.connected_components(graph, directed=False)[1]
    size = radii.copy()
    if root is not None:
        size[root] = np.inf
    order = np.argsort(-size, kind="stable")
    return tuple(order[np.sort(np.unique(label[order], return_index=True)[1])].tolist())


def tree(num_nodes: int, edges: np.ndarray, roots: tuple[int, ...] = ()) -> dict[int, int]:
    """The parent of every node, -1 for a root: parents come first, loops are cut.

    Components of the ``roots`` come first, in that order; the roots of others are leaves if there are any.
    """
    graph = nx.Graph()
    graph.add_nodes_from(range(num_nodes))
    graph.add_edges_from(edges.tolist())
    parent: dict[int, int] = {}

    def grow(root: int) -> None:
        parent[root] = -1
        parent.update({child: above for above, child in nx.bfs_edges(graph, root, sort_neighbors=sorted)})

    for root in roots:
        if root not in parent:
            grow(root)
    for component in nx.connected_components(graph):
        if not component.isdisjoint(roots):
            continue
        leaves = [node for node in component if graph.degree[node] == 1]
        grow(min(leaves or component))
    return parent


def measure(
    vertices: np.ndarray,
    edges: np.ndarray,
    radii: np.ndarray,
    share: np.ndarray | None = None,
    known: "dict[tuple[int, ...], Reach] | None" = None,
) -> list[Branch]:
    """The branches of a curve ``(vertices (N, 3), edges (E, 2), radii (N,))``; ``share`` (N,) of the area by node.

    ``known`` remembers what was measured, for a curve that loses branches.
    """
    degree = np.bincount(edges.ravel(), minlength=len(vertices))
    known = {} if known is None else known
    found = []
    for nodes in trace(len(vertices), edges):
        length = float(np.linalg.norm(np.diff(vertices[nodes], axis=0), axis=1).sum())
        junctions = [node for node in (nodes[0], nodes[-1]) if degree[node] > 2]
        own = np.array(sorted(set(nodes).difference(junctions)), dtype=np.int64)
        persistence = np.inf
        if len(junctions) == 1 and min(degree[nodes[0]], degree[nodes[-1]]) == 1:
            reach = known.get(tuple(own.tolist()))
            if reach is None or not degree[reach.cover].all():
                reach = known[tuple(own.tolist())] = _reach(vertices, radii, own, degree)
            persistence = 1 + reach.distance / max(float(radii[junctions[0]]), 1e-300)
        found.append(Branch(nodes, length, persistence, np.nan if share is None else float(share[own].sum())))
    return found


class Reach(NamedTuple):
    """How far the balls of a branch reach out of those of the rest, and the nodes whose balls cover it most."""

    distance: float
    cover: np.ndarray


def _reach(vertices: np.ndarray, radii: np.ndarray, own: np.ndarray, degree: np.ndarray) -> Reach:
    is_rest = degree > 0
    is_rest[own] = False
    rest = np.flatnonzero(is_rest)
    away = spatial.distance.cdist(vertices[own], vertices[rest]) - radii[rest]
    nearest = away.argmin(axis=1)
    out = away[np.arange(len(own)), nearest] + radii[own]
    return Reach(max(float(out.max()), 0.0), rest[nearest])


def prune(
    vertices: np.ndarray, edges: np.ndarray, radii: np.ndarray, persistence: float, is_held: np.ndarray | None = None
) -> tuple[np.ndarray, np.ndarray]:
    """Take away branches of less than ``persistence``, the least first, until none is left.

    Each time the rest is measured again: where two branches remain at a junction they become one. A branch with a node
    of ``is_held`` (N,) beyond its junction stays. Returns which nodes stay (N,), and the node that each goes to (N,):
    itself, or the junction that its branch grew out of.
    """
    is_kept = np.ones(len(vertices), dtype=bool)
    target = np.arange(len(vertices))
    known: dict[tuple[int, ...], Reach] = {}
    while True:
        left = edges[is_kept[edges].all(axis=1)]
        degree = np.bincount(left.ravel(), minlength=len(vertices))
        least, going = persistence, []
        for branch in measure(vertices, left, radii, known=known):
            if branch.persistence < least:
                nodes = branch.nodes if degree[branch.nodes[0]] > 2 else branch.nodes[::-1]
                if is_held is None or not is_held[nodes[1:]].any():
                    least, going = branch.persistence, nodes
        if not going:
            return is_kept, target
        is_kept[going[1:]] = False
        target[np.isin(target, going[1:])] = going[0]
