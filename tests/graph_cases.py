"""Graphs that are small enough to list by hand, and random ones."""

from itertools import pairwise

import numpy as np
from hypothesis import strategies as st

NONE = np.empty((0, 2), dtype=np.int64)


def chain(*nodes: int) -> list[tuple[int, int]]:
    """The edges of a path through ``nodes``."""
    return list(pairwise(nodes))


GRAPHS = {  # number of nodes, edges, branches
    "path": (4, chain(2, 0, 3, 1), [[1, 3, 0, 2]]),
    "edge": (2, [(0, 1)], [[0, 1]]),
    "loop": (4, chain(0, 2, 1, 3, 0), [[0, 2, 1, 3, 0]]),
    "theta": (5, chain(0, 1) + chain(0, 2, 1) + chain(0, 3, 4, 1), [[0, 1], [0, 2, 1], [0, 3, 4, 1]]),
    "lollipop": (5, chain(0, 1, 2) + chain(2, 3, 4, 2), [[0, 1, 2], [2, 3, 4, 2]]),
    "star": (5, [(4, 0), (4, 1), (4, 2), (2, 3)], [[0, 4], [1, 4], [3, 2, 4]]),
    "lone node": (1, [], [[0]]),
    "lone nodes beside a path": (4, [(1, 3)], [[0], [1, 3], [2]]),
    "figure eight": (5, chain(0, 1, 2, 0) + chain(0, 3, 4, 0), [[0, 1, 2, 0], [0, 3, 4, 0]]),
    "spectacles": (7, chain(0, 1, 2, 0) + chain(0, 6, 3) + chain(3, 4, 5, 3), [[0, 1, 2, 0], [0, 6, 3], [3, 4, 5, 3]]),
    "loop beside a path": (5, chain(1, 2, 4, 1) + [(0, 3)], [[0, 3], [1, 2, 4, 1]]),
    "nothing": (0, [], []),
}


def as_edges(pairs: list[tuple[int, int]]) -> np.ndarray:
    """Pairs (E, 2) as an array, also where there are none."""
    return np.array(pairs, dtype=np.int64).reshape(-1, 2)


def degrees(num: int, edges: np.ndarray) -> np.ndarray:
    """Number of edges (N,) at each node."""
    return np.bincount(edges.ravel(), minlength=num)


@st.composite
def graphs(draw, *, is_connected: bool = False) -> tuple[int, np.ndarray]:
    """A tree or a forest of up to 14 nodes, and a few more edges."""
    num = draw(st.integers(1, 14))
    parents = [draw(st.integers(0 if is_connected else -1, node - 1)) for node in range(1, num)]
    pairs = {(parent, node) for node, parent in enumerate(parents, 1) if parent >= 0}
    node = st.integers(0, num - 1)
    pairs |= {(min(pair), max(pair)) for pair in draw(st.lists(st.tuples(node, node), max_size=4))}
    names = draw(st.permutations(range(num)))
    return num, as_edges([(names[a], names[b]) for a, b in sorted(pairs) if a != b])
