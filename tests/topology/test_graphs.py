"""Graphs: on those that are small enough to list by hand, and on random ones against a plain search."""

from itertools import pairwise

import numpy as np
import pytest
from graph_cases import GRAPHS, as_edges, degrees, graphs
from hypothesis import given, settings
from loop_cases import NO_EDGES

from msf_jax.topology.graphs import core, cycles, nearest_along, shortest_forest, trace


def test_a_forest_takes_the_shortest_of_edges_side_by_side():
    edges = np.array([[0, 1], [1, 0], [1, 2], [0, 2], [2, 2], [0, 1], [3, 4]])
    length = np.array([2.0, 1.0, 0.5, 3.0, 0.0, 5.0, 9.0])
    assert np.flatnonzero(shortest_forest(6, edges, length)).tolist() == [1, 2, 6]
    assert shortest_forest(3, NO_EDGES, np.empty(0)).shape == (0,)
    tied = shortest_forest(3, np.array([[0, 1], [1, 2], [0, 2]]), np.zeros(3))
    assert tied.tolist() == [True, True, False]


def test_sums_along_a_forest_are_those_of_its_paths():
    random = np.random.default_rng(5)
    edges = np.array([[k, random.integers(k)] for k in range(1, 40) if k != 20])
    edges = np.where(random.random((len(edges), 1)) < 0.5, edges, edges[:, ::-1])
    place = random.integers(-9, 9, (40, 3))
    step = place[edges[:, 1]] - place[edges[:, 0]]
    found = cycles(40, edges, step, np.ones(len(edges)))[2]
    np.testing.assert_array_equal(found[edges[:, 1]] - found[edges[:, 0]], step)
    assert not found[[0, 20]].any()


def one_way(nodes: list[int]) -> tuple[int, ...]:
    """The same for a branch and its reverse, and for a closed one that starts elsewhere."""
    return min(tuple(nodes), tuple(nodes[::-1]))


@pytest.mark.parametrize("name", GRAPHS)
def test_branches_are_the_paths_between_ends_and_junctions(name):
    num, pairs, expected = GRAPHS[name]
    assert sorted(map(one_way, trace(num, as_edges(pairs)))) == sorted(map(one_way, expected))


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
