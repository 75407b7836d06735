"""Branches of a curve: on graphs small enough to list by hand, and on random ones against a plain search."""

from itertools import pairwise

import manifold3d
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from msf_jax.curve.branches import merge_coincident, merge_junctions
from msf_jax.solid.handles import Handles
from msf_jax.topology.graphs import core, cycle_count, loop_along, nearest_along, trace

NONE = np.empty((0, 2), dtype=np.int64)
FOUR = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
NO_HANDLES = Handles(50.0 * np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]) - 10, FOUR)  # a tetrahedron


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


def one_way(nodes: list[int]) -> tuple[int, ...]:
    """The same for a branch and its reverse, and for a closed one that starts elsewhere."""
    return min(tuple(nodes), tuple(nodes[::-1]))


def degrees(num: int, edges: np.ndarray) -> np.ndarray:
    """Number of edges (N,) at each node."""
    return np.bincount(edges.ravel(), minlength=num)


# Paths


@pytest.mark.parametrize("name", GRAPHS)
def test_branches_are_the_paths_between_ends_and_junctions(name):
    num, pairs, expected = GRAPHS[name]
    assert sorted(map(one_way, trace(num, as_edges(pairs)))) == sorted(map(one_way, expected))


@pytest.mark.parametrize("name", GRAPHS)
def test_the_order_and_direction_of_edges_does_not_matter(name):
    num, pairs, expected = GRAPHS[name]
    random = np.random.default_rng(1)
    for _ in range(5):
        edges = as_edges(pairs)[random.permutation(len(pairs))]
        edges = np.where(random.random((len(edges), 1)) < 0.5, edges, edges[:, ::-1])
        assert sorted(map(one_way, trace(num, edges))) == sorted(map(one_way, expected))


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


@settings(max_examples=150, deadline=None)
@given(graphs())
def test_every_edge_is_in_one_branch_and_every_node_in_at_least_one(graph):
    num, edges = graph
    degree, paths = degrees(num, edges), trace(num, edges)
    steps = [frozenset(step) for path in paths for step in pairwise(path)]
    assert len(steps) == len(edges) and set(steps) == {frozenset(edge) for edge in edges.tolist()}
    assert {node for path in paths for node in path} == set(range(num))
    for path in paths:
        assert (degree[path[1:-1]] == 2).all()
        if degree[path[0]] == 2 or degree[path[-1]] == 2:
            assert path[0] == path[-1] and (degree[path] == 2).all() and len(path) > 3


# Junctions in one ball, and edges in one place


def test_junctions_in_one_ball_are_one():
    """Three of them in a row: two within the ball of the first, which takes their legs; the last is farther off."""
    vertices = np.array([[0, 0, 0], [0.4, 0, 0], [0.8, 0, 0], [2.0, 0, 0]] + [[k, 3.0, 0] for k in range(8)], float)
    edges = as_edges(chain(0, 1, 2, 3) + [(0, 4), (0, 5), (1, 6), (2, 7), (2, 8), (3, 9), (3, 10)])
    radii = np.r_[1.0, 0.9, 0.8, 1.0, np.ones(8)]
    free = np.zeros(len(vertices), dtype=bool)
    stays, target, left = merge_junctions(vertices, edges, radii, free, NO_HANDLES)
    assert np.flatnonzero(~stays).tolist() == [1, 2] and target[:4].tolist() == [0, 0, 0, 3]
    assert sorted(map(tuple, left.tolist())) == [(0, k) for k in range(3, 9)] + [(3, 9), (3, 10)]
    held = free.copy()
    held[2] = True
    assert np.flatnonzero(~merge_junctions(vertices, edges, radii, held, NO_HANDLES)[0]).tolist() == [1]


def test_a_loop_in_one_ball_stays():
    """Two paths between two junctions: one of them would be lost."""
    vertices = np.array([[0, 0, 0], [0.2, 0, 0], [0.1, 0.1, 0], [0.1, -0.1, 0], [-2, 0, 0], [2, 0, 0]], float)
    edges = as_edges(chain(0, 2, 1) + chain(0, 3, 1) + [(0, 4), (1, 5)])
    stays, _, left = merge_junctions(vertices, edges, np.ones(6), np.zeros(6, dtype=bool), NO_HANDLES)
    assert stays.all() and len(left) == len(edges)


def test_of_two_near_pairs_only_the_one_without_a_loop_is_merged():
    """A triangle of junctions in one ball keeps its loop; an H far away becomes an X all the same."""
    vertices = np.array([[0, 0, 0], [0.2, 0, 0], [0, 2, 0], [0, -2, 0], [0.2, 2, 0], [0.2, -2, 0]], float)
    triangle = np.array([[9, 0, 0], [9.2, 0, 0], [9.1, 0.2, 0], [8, 0, 0], [11, 0, 0], [9.1, 3, 0]], float)
    edges = as_edges([(0, 1), (0, 2), (0, 3), (1, 4), (1, 5), (6, 7), (7, 8), (6, 8), (6, 9), (7, 10), (8, 11)])
    free = np.zeros(12, dtype=bool)
    stays, _, left = merge_junctions(np.concatenate([vertices, triangle]), edges, np.ones(12), free, NO_HANDLES)
    assert np.flatnonzero(~stays).tolist() == [1]
    assert len(left) == len(edges) - 1


@pytest.mark.parametrize(("holes", "num_left"), [([1.3], 6), ([0.7, 1.3], 7)])
def test_junctions_are_not_merged_across_a_hole(holes, num_left):
    """Of a triangle around a hole, with a tail that forks: its corner may go to the fork, but not over another hole."""
    plate = manifold3d.Manifold.cube([8, 8, 1], True)
    for x in holes:
        plate -= manifold3d.Manifold.cylinder(2.0, 0.05, 0.05, 12, True).translate((x, 0.5, 0.0))
    found = plate.to_mesh()
    handles = Handles(found.vert_properties[:, :3].astype(float), found.tri_verts.astype(np.int64))
    vertices = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [2, 0.5, 0], [-1, 1, 0], [-1, -1, 0], [3, 0.5, 0]], float)
    edges = as_edges([(0, 1), (1, 2), (2, 3), (1, 3), (0, 4), (0, 5), (3, 6)])
    radii = np.r_[1.5, 1.0, np.full(5, 0.1)]
    stays, _, left = merge_junctions(vertices, edges, radii, np.zeros(7, dtype=bool), handles)
    assert (stays.sum(), len(left)) == (num_left, num_left)
    assert cycle_count(7, left)[1] == 1


def test_a_loop_that_is_folded_flat_is_no_loop():
    """A node on an edge, two nodes in one place, an edge without length; a true triangle stays, and so does a pin."""
    x = np.array([[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0], [1.5, 0, 0], [2.2, 1e-9, 0], [3, 0, 0], [0, 1, 0.0]])
    edges = np.array([[0, 1], [1, 2], [2, 3], [1, 4], [2, 4], [3, 6], [2, 5], [5, 6], [0, 7], [1, 7]])
    assert cycle_count(8, edges)[1] == 3
    is_pin = np.arange(8) == 6
    stays, target, left = merge_coincident(x, edges, is_pin)
    assert np.flatnonzero(~stays).tolist() == [3] and target[3] == 6
    assert left.tolist() == [[0, 1], [0, 7], [1, 4], [1, 7], [2, 4], [2, 5], [5, 6]]
    once = np.array([0, 1, 2, 4, 5, 6, 7])
    apart = merge_coincident(x[once], np.searchsorted(once, left), is_pin[once])
    assert apart[0].all() and np.array_equal(apart[2], np.searchsorted(once, left))
    crossing = np.array([[-1, 0, 0], [0, 0, 0], [1, 0, 0], [0, -1, 0], [0, 1, 0], [0, 0, 1.0]])  # they touch, no more
    paths = np.array([[0, 1], [1, 2], [3, 4], [0, 5], [3, 5]])
    touching = merge_coincident(crossing, paths, np.zeros(6, dtype=bool))
    assert touching[0].all() and np.array_equal(touching[2], np.unique(paths, axis=0))
    nothing = merge_coincident(x[:1], np.empty((0, 2), dtype=int), is_pin[:1])
    assert nothing[0].all() and nothing[2].shape == (0, 2)


def test_what_is_nearest_along_a_curve_is_not_what_is_nearest_in_space():
    """On a hairpin the other side is nearer in space. A source is its own nearest one."""
    x = np.array([[0.0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0], [3, 0.1, 0], [2, 0.1, 0], [1, 0.1, 0], [0, 0.1, 0]])
    edges = np.stack([np.arange(7), np.arange(1, 8)], axis=1)
    is_source = np.isin(np.arange(8), [0, 5])
    np.testing.assert_array_equal(nearest_along(x, edges, is_source), [0, 0, 0, 5, 5, 5, 5, 5])


def test_the_core_is_what_leaves_cannot_reach():
    """Two triangles, the path between them, a tail with a fork at one of them, and a chain apart."""
    loops = [(0, 1), (1, 2), (0, 2), (3, 4), (4, 5), (3, 5), (2, 6), (6, 3)]
    tails = [(0, 7), (7, 8), (7, 9), (10, 11), (11, 12)]
    assert np.flatnonzero(core(13, np.array(loops + tails))).tolist() == [0, 1, 2, 3, 4, 5, 6]
    assert np.flatnonzero(core(13, np.array(loops + tails + loops))).tolist() == [0, 1, 2, 3, 4, 5, 6]
    assert not core(13, np.array(tails)).any()


def test_a_loop_along_a_tree_has_each_vertex_once():
    """Also where one end is above the other one in the tree 0 - 1 - (2, 3)."""
    parent = np.array([-1, 0, 1, 1])
    assert loop_along(2, 3, parent) == [2, 3, 1]
    assert loop_along(2, 0, parent) == [2, 0, 1]
    assert loop_along(0, 2, parent) == [0, 2, 1]
