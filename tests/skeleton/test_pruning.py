"""Pruning of branches by their balls: closed forms, and the order of removal against a plain search."""

from itertools import pairwise

import networkx as nx
import numpy as np
import pytest
from graph_cases import GRAPHS, as_edges, chain, degrees, graphs
from hypothesis import given, settings
from hypothesis import strategies as st

from msf_jax.skeleton import pruning
from msf_jax.skeleton.pruning import by_balls, measure

Balls = tuple[np.ndarray, np.ndarray, np.ndarray]


def star_of(lengths: list[float], radius: float, step: float = 0.25) -> Balls:
    """Up to six legs out of node 0, at right angles, with a node every ``step``."""
    vertices, pairs = [np.zeros(3)], []
    for direction, length in zip(np.concatenate([np.eye(3), -np.eye(3)]), lengths, strict=False):
        first, num = len(vertices), round(length / step)
        pairs += chain(0, *range(first, first + num))
        vertices += [direction * length * (k + 1) / num for k in range(num)]
    return np.array(vertices), as_edges(pairs), np.full(len(vertices), radius)


def prune(vertices, edges, radii, least: float, is_held: np.ndarray | None = None):
    is_held = np.zeros(len(vertices), dtype=bool) if is_held is None else is_held
    return pruning.prune(len(vertices), edges, by_balls(vertices, radii), least, is_held)


def branches_of(vertices, edges, radii, share=None):
    return measure(vertices, edges, by_balls(vertices, radii), share)


def by_leaf(vertices, edges, radii) -> dict[int, float]:
    """The slenderness of the branches that end in leaves."""
    degree = degrees(len(vertices), np.unique(np.sort(edges, axis=1), axis=0))
    branches = branches_of(vertices, edges, radii)
    return {leaf: one.slenderness for one in branches for leaf in one.nodes if degree[leaf] == 1}


@pytest.mark.parametrize("scale", [1e-9, 1.0, 1e6])
def test_a_tube_has_its_length_over_its_radius(scale):
    """From the tip, a radius beyond the leaf, to the ball at the junction, if a node lies at its edge."""
    vertices, edges, radii = star_of([1.0, 2.5, 0.75], 0.25)
    found = by_leaf(scale * vertices, edges, scale * radii)
    assert sorted(found.values()) == pytest.approx([(length - 0.25) / 0.25 + 0.5 for length in (0.75, 1.0, 2.5)])


def test_a_cone_has_its_closed_form():
    """r = s tan a at the depth s: 1 / tan a - 1 / 2, whatever s, and the tip adds little."""
    slope, num = 0.1, 2000
    s = np.linspace(1e-3, 10, num)
    x = np.concatenate([np.stack([10 - s, 0 * s, 0 * s], axis=1), [[0, 3, 0], [0, -3, 0]]])
    radii = np.append(slope * s, [0.1, 0.1])
    edges = as_edges([*pairwise(range(num)), (num - 1, num), (num - 1, num + 1)])
    assert by_leaf(x, edges, radii)[0] == pytest.approx(1 / slope - 0.5, rel=0.05)


@pytest.mark.parametrize("radius", [0.0, np.nan])
def test_where_no_radius_is_known_all_stays_and_what_is_outside_goes(radius):
    vertices, edges, radii = star_of([1.0, 2.5, 0.75], 0.1)
    unknown = vertices, edges, np.full(len(vertices), radius)
    assert set(by_leaf(*unknown).values()) == {np.inf} and prune(*unknown, 100.0)[0].all()
    radii[-3:] = 0.0
    assert by_leaf(vertices, edges, radii)[len(vertices) - 1] == 0
    assert not prune(vertices, edges, radii, 0.1)[0][-3:].any()


@pytest.mark.parametrize("name", ["path", "edge", "loop", "theta", "lone node", "figure eight", "spectacles"])
def test_what_cannot_go_is_infinitely_slender(name):
    """Loops, paths between junctions, and whole components."""
    num, pairs, _ = GRAPHS[name]
    balls = np.random.default_rng(2).normal(size=(num, 3)), as_edges(pairs), np.full(num, 100.0)
    found = branches_of(*balls)
    assert found and all(branch.slenderness == np.inf for branch in found)
    assert prune(*balls, np.inf)[0].all()


# The order of removal


def test_the_least_goes_first_and_the_rest_is_measured_again():
    """Of three legs all below the threshold only the shortest goes: the others are one branch then, without an end."""
    for order in ([1.0, 1.5, 2.0], [2.0, 1.0, 1.5], [1.5, 2.0, 1.0]):
        stays, target = prune(*star_of(order, 0.25), 12.0)
        start = 1 + round(sum(order[: order.index(1.0)]) / 0.25)
        np.testing.assert_array_equal(np.flatnonzero(~stays), np.arange(start, start + 4))
        assert (target[~stays] == 0).all()


def test_a_node_goes_to_a_junction_that_stays():
    """A spur on a spur: what went to the first junction goes on to the second with it."""
    vertices, edges, radii = star_of([3.0, 3.0, 1.0], 0.25)
    leaf = len(vertices) - 1
    vertices = np.concatenate([vertices, vertices[leaf - 1 : leaf] + [[0.1, 0, 0]]])
    edges = np.concatenate([edges, [[leaf - 1, leaf + 1]]])
    stays, target = prune(vertices, edges, np.r_[radii, 0.25], 9.0)
    np.testing.assert_array_equal(np.flatnonzero(~stays), np.arange(25, leaf + 2))
    assert (target[25:] == 0).all()


def test_a_held_branch_stays_and_others_go():
    """Also where it is held by a node in its middle; its junction stays anyhow, and holds nothing."""
    each = {1: range(1, 5), 2: range(5, 10), 3: range(10, 16), 4: range(16, 24)}  # lengths 1, 1.25, 1.5, 2
    vertices, edges, radii = star_of([1.0, 1.25, 1.5, 2.0], 0.25)
    for held, gone in ((None, (1, 2)), (2, (2, 3)), (4, (2, 3)), (11, (1, 2)), (23, (1, 2)), (0, (1, 2))):
        is_held = np.zeros(len(vertices), dtype=bool)
        is_held[[] if held is None else held] = True
        stays, _ = prune(vertices, edges, radii, 100.0, is_held)
        assert np.flatnonzero(~stays).tolist() == [node for leg in gone for node in each[leg]], held


@st.composite
def curves(draw) -> Balls:
    """A graph with random places and radii, one of them perhaps 0."""
    num, edges = draw(graphs(is_connected=draw(st.booleans())))
    random = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    radii = random.uniform(0, draw(st.sampled_from([0.2, 1.0, 4.0])), num)
    if draw(st.booleans()):
        radii[random.integers(num)] = 0.0
    return random.normal(size=(num, 3)), edges, radii


def plain_slenderness(balls: Balls, graph: nx.Graph) -> dict[int, tuple[list, float]]:
    """For each leaf that leads to a junction, the nodes up to there and its slenderness, by its definition."""
    x, _, radii = balls
    found = {}
    for leaf in [node for node in graph if graph.degree[node] == 1]:
        own, (onward,) = [leaf], set(graph[leaf])
        while graph.degree[onward] == 2:
            own.append(onward)
            (onward,) = set(graph[onward]) - set(own[-2:])
        if graph.degree[onward] < 3:
            continue
        depth, last, values = radii[leaf], leaf, []
        for node in own:
            depth += np.linalg.norm(x[node] - x[last])
            if radii[node] > 0 and np.linalg.norm(x[node] - x[onward]) >= radii[onward]:
                values.append(depth / radii[node] - 0.5)
            last = node
        far = [max(np.linalg.norm(x[k] - x[leaf]), np.linalg.norm(x[k] - x[onward])) for k in [*own, onward]]
        held = any(each <= radii[k] for k, each in zip([*own, onward], far, strict=True))
        most = (0.0 if held else max(values, default=0.0)) if (radii > 0).any() else np.inf
        found[leaf] = own, most
    return found


def graph_of(balls: Balls) -> nx.Graph:
    graph = nx.empty_graph(len(balls[0]))
    graph.add_edges_from(balls[1].tolist())
    return graph


@settings(max_examples=150, deadline=None)
@given(curves())
def test_slenderness_is_what_its_definition_says(balls):
    expected = plain_slenderness(balls, graph_of(balls))
    degree = degrees(len(balls[0]), balls[1])
    for branch in branches_of(*balls):
        leaves = [node for node in (branch.nodes[0], branch.nodes[-1]) if node in expected]
        if leaves:
            own, value = expected.pop(leaves[0])
            assert set(own) == set(branch.nodes) - set(np.flatnonzero(degree > 2)) and len(leaves) == 1
            assert branch.slenderness == pytest.approx(value, rel=1e-9)
        else:
            assert branch.slenderness == np.inf
    assert not expected


@settings(max_examples=80, deadline=None)
@given(curves(), st.floats(0.1, 8), st.data())
def test_pruning_leaves_cycles_and_components_and_nothing_below_the_threshold(balls, least, data):
    num = len(balls[0])
    flags = data.draw(st.none() | st.lists(st.booleans(), min_size=num, max_size=num))
    is_held = None if flags is None else np.array(flags)
    stays, target = prune(*balls, least, is_held)
    graph = graph_of(balls)
    left = graph.subgraph(np.flatnonzero(stays).tolist())
    assert nx.number_connected_components(left) == nx.number_connected_components(graph)
    assert left.number_of_edges() - left.number_of_nodes() == len(balls[1]) - num
    for own, value in plain_slenderness(balls, left).values():
        assert value >= least * (1 - 1e-9) or (is_held is not None and is_held[own].any())
    # What goes to a node hangs on it, and the node stays.
    np.testing.assert_array_equal(target[stays], np.flatnonzero(stays))
    assert stays[target].all()
    for node in np.unique(target).tolist():
        assert nx.is_connected(graph.subgraph([node, *np.flatnonzero((target == node) & ~stays).tolist()]))
    if is_held is not None:
        assert stays[is_held].all()


@settings(max_examples=100, deadline=None)
@given(curves(), st.lists(st.floats(0.1, 8), min_size=2, max_size=4))
def test_a_higher_threshold_keeps_fewer_nodes_and_all_of_them_stay_at_a_lower_one(balls, thresholds):
    kept = [prune(*balls, least)[0] for least in sorted(thresholds)]
    for lower, higher in pairwise(kept):
        assert not (higher & ~lower).any()
