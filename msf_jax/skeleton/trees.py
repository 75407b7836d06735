"""A curve as a tree: where its loops are cut, its roots, and the parent of each node."""

import networkx as nx
import numpy as np

from msf_jax.topology import graphs


def cut_loops(num_nodes: int, edges: np.ndarray, radii: np.ndarray) -> np.ndarray:
    """(E,) which edges stay if every loop is cut at its thinnest edge: the spanning forest of the thickest edges. The
    thickness of an edge is the smaller radius at its ends; the larger radius breaks ties."""
    order = np.lexsort((-radii[edges].max(axis=1), -radii[edges].min(axis=1)))
    return graphs.shortest_forest(num_nodes, edges, np.argsort(order))


def roots_of(num_nodes: int, edges: np.ndarray, radii: np.ndarray, root: int | None) -> tuple[int, ...]:
    """The node with the largest ball in each component, largest first; ``root``, if given, is first instead."""
    label, size = graphs.labels(num_nodes, *edges.T), radii.copy()
    size[[] if root is None else root] = np.inf
    order = np.argsort(-size, kind="stable")
    return tuple(order[np.sort(np.unique(label[order], return_index=True)[1])].tolist())


def tree(num_nodes: int, edges: np.ndarray, roots: tuple[int, ...] = ()) -> dict[int, int]:
    """The parent of every node, -1 for a root. Parents come before their children, and loops are cut.

    Components of the ``roots`` come first, in that order. The root of any other component is a leaf if it has one."""
    graph = nx.Graph()
    graph.add_nodes_from(range(num_nodes))
    graph.add_edges_from(edges.tolist())
    others = [component for component in nx.connected_components(graph) if component.isdisjoint(roots)]
    starts = [min([node for node in each if graph.degree[node] == 1] or each) for each in others]
    parent: dict[int, int] = {}
    for root in [*roots, *starts]:
        if root not in parent:
            parent[root] = -1
            parent.update({child: above for above, child in nx.bfs_edges(graph, root, sort_neighbors=sorted)})
    return parent
