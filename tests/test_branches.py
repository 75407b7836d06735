"""Branches of a curve: on graphs small enough to list by hand, and on random ones against a plain search."""

from itertools import pairwise

import manifold3d
import networkx as nx
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from msf_jax.host.curve.branches import (
    cut_corners,
    cycle_count,
    equals,
    lay_together,
    measure,
    merge_junctions,
    prune,
    trace,
)
from msf_jax.host.solid.handles import Handles

NONE = np.empty((0, 2), dtype=np.int64)
FOUR = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
NO_HANDLES = Handles(50.0 * np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]) - 10, FOUR)  # a tetrahedron


def chain(*nodes: int) -> list[tuple[int, int]]:
    """The edges of a way through ``nodes``."""
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


# Ways


@pytest.mark.parametrize("name", GRAPHS)
def test_branches_are_the_ways_between_ends_and_junctions(name):
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
    degree, ways = degrees(num, edges), trace(num, edges)
    steps = [frozenset(step) for way in ways for step in pairwise(way)]
    assert len(steps) == len(edges) and set(steps) == {frozenset(edge) for edge in edges.tolist()}
    assert {node for way in ways for node in way} == set(range(num))
    for way in ways:
        assert (degree[way[1:-1]] == 2).all()
        if degree[way[0]] == 2 or degree[way[-1]] == 2:
            assert way[0] == way[-1] and (degree[way] == 2).all() and len(way) > 3


# Persistence


def star_of(lengths: list[float], radius: float, step: float = 0.25) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Up to six legs out of node 0, at right angles, with a node every ``step``: of persistence 1 + length / radius."""
    vertices, pairs = [np.zeros(3)], []
    for way, length in zip(np.concatenate([np.eye(3), -np.eye(3)]), lengths, strict=False):
        first, num = len(vertices), round(length / step)
        pairs += chain(0, *range(first, first + num))
        vertices += [way * length * (k + 1) / num for k in range(num)]
    return np.array(vertices), as_edges(pairs), np.full(len(vertices), radius)


def tube_with_twig(height: float, radius: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """A tube of radius 1 along x, nodes 0 to 40, and out of its middle a twig of five more nodes along y."""
    vertices = np.zeros((46, 3))
    vertices[:41, 0] = np.linspace(-4, 4, 41)
    vertices[41:, 1] = np.linspace(0, height, 6)[1:]
    return vertices, as_edges(chain(*range(41)) + chain(20, *range(41, 46))), np.r_[np.ones(41), np.full(5, radius)]


def the_twig(vertices: np.ndarray, edges: np.ndarray, radii: np.ndarray, share: np.ndarray | None = None):
    """The one branch that ends in the last node."""
    (found,) = [branch for branch in measure(vertices, edges, radii, share) if len(vertices) - 1 in branch.nodes]
    return found


@pytest.mark.parametrize(("height", "radius"), [(0.3, 0.3), (0.7, 0.3), (0.95, 0.05)])
def test_a_twig_inside_a_tube_has_persistence_one(height, radius):
    twig = the_twig(*tube_with_twig(height, radius))
    assert twig.persistence == pytest.approx(1, abs=1e-12)
    assert twig.nodes in ([20, 41, 42, 43, 44, 45], [45, 44, 43, 42, 41, 20])
    assert twig.length == pytest.approx(height)


@pytest.mark.parametrize("scale", [1e-3, 1.0, 50.0])
@pytest.mark.parametrize("out", [0.01, 0.5, 3.0])
def test_a_limb_that_sticks_out_has_one_more_for_each_radius(out, scale):
    vertices, edges, radii = tube_with_twig(0.8 + out, 0.2)
    twig = the_twig(scale * vertices, edges, scale * radii)
    assert twig.persistence == pytest.approx(1 + out, rel=1e-9)


def test_a_ball_in_the_middle_of_a_limb_may_reach_the_farthest():
    vertices, edges, radii = tube_with_twig(2.0, 0.1)  # nodes at heights 0.4, 0.8, 1.2, 1.6, 2
    radii[44] = 1.5
    assert the_twig(vertices, edges, radii).persistence == pytest.approx(1 + 1.6 + 1.5 - 1)


def test_a_limb_is_measured_in_radii_of_its_junction():
    """The junction's ball is the nearest, and thinner than the tube: 3 high, 0.2 thick, from a ball of 0.5."""
    vertices, edges, radii = tube_with_twig(3.0, 0.2)
    radii[:41] = 0.5
    assert the_twig(vertices, edges, radii).persistence == pytest.approx(1 + (3.2 - 0.5) / 0.5)


def test_a_limb_that_bends_into_another_is_inside_it():
    """Balls of any other branch count, not those of the junction alone."""
    vertices, edges, radii = tube_with_twig(3.0, 0.2)
    away = the_twig(vertices, edges, radii).persistence
    vertices[41:, 0], vertices[41:, 1] = np.linspace(0, 3.0, 6)[1:], 0.3  # along the tube, within it
    assert away == pytest.approx(3.2) and the_twig(vertices, edges, radii).persistence == 1.0


def test_a_junction_without_a_radius_makes_a_limb_persist():
    vertices, edges, radii = tube_with_twig(3.0, 0.2)
    radii[:41] = 0.0
    assert the_twig(vertices, edges, radii).persistence > 1e10


@pytest.mark.parametrize("name", ["path", "edge", "loop", "theta", "lone node", "figure eight", "spectacles"])
def test_what_cannot_go_persists_for_ever(name):
    """Loops, ways between junctions, and whole components."""
    num, pairs, _ = GRAPHS[name]
    vertices = np.random.default_rng(2).normal(size=(num, 3))
    found = measure(vertices, as_edges(pairs), np.full(num, 100.0))
    assert found and all(branch.persistence == np.inf for branch in found)


def test_only_the_stick_of_a_lollipop_can_go():
    num, pairs, _ = GRAPHS["lollipop"]
    stick, sweet = sorted(measure(np.random.default_rng(3).normal(size=(num, 3)), as_edges(pairs), np.full(num, 99.0)))
    assert stick.nodes[0] == 0 and 1 <= stick.persistence < 1.1
    assert sweet.nodes[0] == 2 and sweet.persistence == np.inf


def test_lengths_are_those_of_the_ways():
    vertices, edges, radii = star_of([1.0, 2.5, 0.75], 0.1)
    assert sorted(branch.length for branch in measure(vertices, edges, radii)) == pytest.approx([0.75, 1.0, 2.5])
    square = np.array([[0.0, 0, 0], [2, 0, 0], [2, 3, 0], [0, 3, 0]])
    (loop,) = measure(square, as_edges(chain(0, 1, 2, 3, 0)), np.ones(4))
    assert loop.length == pytest.approx(10) and loop.nodes[0] == loop.nodes[-1]
    (lone,) = measure(np.zeros((1, 3)), NONE, np.ones(1))
    assert lone.length == 0 and lone.nodes == [0]


def test_the_surface_of_a_branch_is_that_of_its_own_nodes():
    """Its junctions are not among them; a loop names its first node twice, and counts it once."""
    share = np.arange(1.0, 8.0)
    num, pairs, _ = GRAPHS["spectacles"]
    found = {
        one_way(branch.nodes): branch.surface
        for branch in measure(np.eye(7)[:, :3], as_edges(pairs), np.ones(num), share)
    }
    expected = {(0, 1, 2, 0): share[[1, 2]].sum(), (0, 6, 3): share[6], (3, 4, 5, 3): share[[4, 5]].sum()}
    assert found == pytest.approx(expected)
    (loop,) = measure(np.eye(4)[:, :3], as_edges(chain(0, 1, 2, 3, 0)), np.ones(4), np.ones(4))
    assert loop.surface == pytest.approx(4)
    assert np.isnan(measure(np.eye(2, 3), as_edges([(0, 1)]), np.ones(2))[0].surface)


# Pruning


def test_a_threshold_is_not_pruned_itself():
    vertices, edges, radii = tube_with_twig(1.6, 0.2)
    persistence = the_twig(vertices, edges, radii).persistence
    assert prune(vertices, edges, radii, persistence)[0].all()
    stays, target = prune(vertices, edges, radii, np.nextafter(persistence, 9))
    np.testing.assert_array_equal(np.flatnonzero(~stays), np.arange(41, 46))
    np.testing.assert_array_equal(target, np.r_[np.arange(41), np.full(5, 20)])


def test_the_least_goes_first_and_the_rest_is_measured_again():
    """Of three legs all below the threshold only the shortest goes: the others are one branch then, without an end."""
    for order in ([1.0, 1.5, 2.0], [2.0, 1.0, 1.5], [1.5, 2.0, 1.0]):
        vertices, edges, radii = star_of(order, 0.5)
        assert sorted(branch.persistence for branch in measure(vertices, edges, radii)) == pytest.approx([3, 4, 5])
        stays, target = prune(vertices, edges, radii, 8.0)
        start = 1 + round(sum(order[: order.index(1.0)]) / 0.25)
        np.testing.assert_array_equal(np.flatnonzero(~stays), np.arange(start, start + 4))
        assert (target[~stays] == 0).all()


@pytest.mark.parametrize("thickness", [0.2, 1.0])
def test_a_fork_that_loses_a_prong_is_one_limb(thickness):
    """Its other prong, which alone would have stayed, is measured with the stem: out of a thick tube both go."""
    vertices, edges, radii = tube_with_twig(2.0, 0.2)
    radii[:41] = thickness
    vertices = np.concatenate([vertices, vertices[45] + np.array([[0, 0, 0.5], [0, 0, -0.6]])])
    edges, radii = np.concatenate([edges, [[45, 46], [45, 47]]]), np.r_[radii, 0.2, 0.2]
    before = {leaf: branch.persistence for branch in measure(vertices, edges, radii) for leaf in branch.nodes}
    assert before[46] == pytest.approx(1 + 0.5 / 0.2) and before[47] == pytest.approx(1 + 0.6 / 0.2)
    stays, target = prune(vertices, edges, radii, 3.8)
    limb = 1 + (np.hypot(2.0, 0.6) + 0.2 - thickness) / thickness
    assert np.flatnonzero(~stays).tolist() == ([46] if limb > 3.8 else [*range(41, 48)])
    assert (limb > 3.8) == (thickness == 0.2) and target[46] == (45 if limb > 3.8 else 20)


def test_a_limb_that_was_hidden_by_a_twig_is_not_when_the_twig_is_gone():
    """Two limbs side by side, each in the other but for 0.1: the thinner one goes, and then the other sticks out."""
    vertices, edges, radii = tube_with_twig(3.0, 0.3)
    beside = vertices[41:] + [0.02, 0, 0]
    vertices, radii = np.concatenate([vertices, beside]), np.r_[radii, np.full(5, 0.25)]
    edges = np.concatenate([edges, as_edges(chain(20, *range(46, 51)))])
    reaches = {leaf: branch.persistence for branch in measure(vertices, edges, radii) for leaf in branch.nodes}
    assert reaches[50] == pytest.approx(1) and reaches[45] == pytest.approx(1 + 0.05 + 0.02)
    stays, target = prune(vertices, edges, radii, 2.0)
    assert np.flatnonzero(~stays).tolist() == [*range(46, 51)] and (target[46:] == 20).all()


def test_a_node_goes_to_a_junction_that_stays():
    """A twig on a twig: what went to the first junction goes on to the second with it."""
    tube, edges, radii = tube_with_twig(0.9, 0.05)
    vertices, radii = np.concatenate([tube, tube[43:44] + [0, 0, 0.01]]), np.r_[radii, 0.02]
    edges = np.concatenate([edges, [[43, 46]]])
    stays, target = prune(vertices, edges, radii, 1.5)
    np.testing.assert_array_equal(np.flatnonzero(~stays), np.arange(41, 47))
    assert (target[41:] == 20).all()


def test_a_held_branch_stays_and_others_go():
    """Also where it is held by a node in its middle; its junction stays anyhow, and holds nothing."""
    legs = {1: range(1, 5), 2: range(5, 10), 3: range(10, 16), 4: range(16, 24)}  # lengths 1, 1.25, 1.5, 2
    vertices, edges, radii = star_of([1.0, 1.25, 1.5, 2.0], 0.5)
    for held, gone in ((None, (1, 2)), (2, (2, 3)), (4, (2, 3)), (11, (1, 2)), (23, (1, 2)), (0, (1, 2))):
        is_held = np.zeros(len(vertices), dtype=bool)
        is_held[[] if held is None else held] = True
        stays, _ = prune(vertices, edges, radii, 100.0, is_held)
        assert np.flatnonzero(~stays).tolist() == [node for leg in gone for node in legs[leg]], held


def test_no_threshold_prunes_what_reaches_nowhere():
    """Persistence is at least 1, so that 1 prunes nothing, and a little more every hidden twig."""
    vertices, edges, radii = tube_with_twig(0.5, 0.1)
    assert prune(vertices, edges, radii, 1.0)[0].all()
    assert not prune(vertices, edges, radii, 1.0 + 1e-9)[0][41:].any()


def test_at_no_limit_a_tree_becomes_a_way_and_a_lollipop_a_loop():
    vertices, edges, radii = star_of([1.0, 2.0, 3.0, 4.0, 5.0], 0.5)
    stays, _ = prune(vertices, edges, radii, np.inf)
    assert np.flatnonzero(stays).tolist() == [0, *range(25, 61)]  # the two longest legs
    num, pairs, _ = GRAPHS["lollipop"]
    stays, target = prune(np.random.default_rng(4).normal(size=(num, 3)), as_edges(pairs), np.ones(num), np.inf)
    assert stays.tolist() == [False, False, True, True, True] and target.tolist() == [2, 2, 2, 3, 4]


@st.composite
def curves(draw) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """A connected graph with random places, and radii from none to larger than all of it."""
    num, edges = draw(graphs(is_connected=True))
    random = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    radii = random.uniform(0, draw(st.sampled_from([0.2, 1.0, 4.0])), num)
    if draw(st.booleans()):
        radii[random.integers(num)] = 0.0
    return random.normal(size=(num, 3)), edges, radii


def plain_persistence(vertices: np.ndarray, graph: nx.Graph, radii: np.ndarray) -> dict[int, tuple[set[int], float]]:
    """For each leaf that leads to a junction, the nodes up to there and 1 + reach / radius, one ball at a time."""
    found = {}
    for leaf in (node for node, degree in graph.degree if degree == 1):
        own, onward = {leaf}, next(iter(graph[leaf]))
        while graph.degree[onward] == 2:
            own.add(onward)
            (onward,) = set(graph[onward]) - own
        if graph.degree[onward] > 2:
            reach = max(
                min(np.linalg.norm(vertices[a] - vertices[b]) + radii[a] - radii[b] for b in set(graph) - own)
                for a in own
            )
            found[leaf] = own, 1 + max(reach, 0) / max(radii[onward], 1e-300)
    return found


@settings(max_examples=150, deadline=None)
@given(curves())
def test_persistence_is_what_a_plain_search_finds(curve):
    vertices, edges, radii = curve
    graph = nx.Graph(edges.tolist())
    expected = plain_persistence(vertices, graph, radii)
    degree = degrees(len(vertices), edges)
    for branch in measure(vertices, edges, radii):
        leaves = [node for node in (branch.nodes[0], branch.nodes[-1]) if node in expected]
        if leaves and branch.persistence < np.inf:
            own, persistence = expected.pop(leaves[0])
            assert own == set(branch.nodes) - set(np.flatnonzero(degree > 2)) and len(leaves) == 1
            assert branch.persistence == pytest.approx(persistence, rel=1e-9)
        else:
            assert branch.persistence == np.inf and not leaves
    assert not expected


@settings(max_examples=150, deadline=None)
@given(curves(), st.floats(0.5, 12), st.data())
def test_pruning_leaves_cycles_and_components_and_nothing_below_the_threshold(curve, threshold, data):
    vertices, edges, radii = curve
    num = len(vertices)
    flags = data.draw(st.none() | st.lists(st.booleans(), min_size=num, max_size=num))
    is_held = None if flags is None else np.array(flags)
    stays, target = prune(vertices, edges, radii, threshold, is_held)
    graph = nx.empty_graph(num)
    graph.add_edges_from(edges.tolist())
    left = graph.subgraph(np.flatnonzero(stays).tolist())
    assert nx.is_connected(left)
    assert left.number_of_edges() - left.number_of_nodes() == len(edges) - num
    branches = measure(vertices, edges[stays[edges].all(axis=1)], radii)
    for branch in branches:
        if branch.persistence < threshold:
            assert is_held[[node for node in branch.nodes if left.degree[node] <= 2]].any()
    # What goes to a node hangs on it, and the node stays.
    np.testing.assert_array_equal(target[stays], np.flatnonzero(stays))
    assert stays[target].all()
    for node in np.unique(target).tolist():
        assert nx.is_connected(graph.subgraph([node, *np.flatnonzero((target == node) & ~stays).tolist()]))
    if is_held is not None:
        assert stays[is_held].all()


@settings(max_examples=100, deadline=None)
@given(curves(), st.lists(st.floats(0.5, 12), min_size=2, max_size=4))
def test_a_higher_threshold_keeps_fewer_nodes_and_all_of_them_stay_at_a_lower_one(curve, thresholds):
    kept = [prune(*curve, threshold)[0] for threshold in sorted(thresholds)]
    for lower, higher in pairwise(kept):
        assert not (higher & ~lower).any()


@settings(max_examples=60, deadline=None)
@given(curves(), st.floats(0.5, 12))
def test_pruning_takes_the_least_as_long_as_it_is_below_the_threshold(curve, threshold):
    """Against a loop in plain Python; branches that persist equally much can go in either order."""
    vertices, edges, radii = curve
    graph = nx.empty_graph(len(vertices))
    graph.add_edges_from(edges.tolist())
    while True:
        found = sorted(plain_persistence(vertices, graph, radii).values(), key=lambda one: one[1])
        if not found or found[0][1] >= threshold:
            break
        if len(found) > 1 and found[1][1] < found[0][1] + 1e-9:
            return
        graph.remove_nodes_from(found[0][0])
    assert np.flatnonzero(prune(vertices, edges, radii, threshold)[0]).tolist() == sorted(graph)


def test_the_curve_is_left_as_it_is():
    vertices, edges, radii = star_of([1.0, 1.5, 2.0], 0.5)
    copies = vertices.copy(), edges.copy(), radii.copy()
    prune(vertices, edges, radii, 5.0)
    for array, copy in zip((vertices, edges, radii), copies, strict=True):
        np.testing.assert_array_equal(array, copy)


# Corners, and junctions in one ball


def rays(ways: np.ndarray, reach: float) -> tuple[np.ndarray, np.ndarray]:
    """Legs of nine nodes out of node 0 along ``ways`` (W, 3)."""
    share = np.linspace(0, 1, 10)[1:]
    vertices = np.concatenate([np.zeros((1, 3)), *(reach * share[:, None] * way for way in ways)])
    pairs = [edge for leg in range(len(ways)) for edge in chain(0, *range(1 + 9 * leg, 10 + 9 * leg))]
    return vertices, as_edges(pairs)


CORNERS = np.array(np.meshgrid([-1.0, 1.0], [-1.0, 1.0], [-1.0, 1.0])).reshape(3, -1).T
AXES = np.concatenate([np.eye(3), -np.eye(3)])


def in_cube(points: np.ndarray) -> np.ndarray:
    """Radii in a cube from -1 to 1."""
    return 1 - np.abs(points).max(axis=1)


def test_a_cube_keeps_the_legs_to_two_opposite_corners():
    vertices, edges = rays(CORNERS, 0.9)
    stays, target = cut_corners(vertices, edges, np.zeros(len(vertices), dtype=bool), in_cube)
    leaves = vertices[stays & (degrees(len(vertices), edges) == 1)]
    np.testing.assert_array_equal(leaves[0], -leaves[1])
    assert stays.sum() == 19 and (target[~stays] == 0).all() and (target[stays] == np.flatnonzero(stays)).all()


def test_a_cube_with_limbs_keeps_those_alone():
    """Six thin rods out of its faces, as long as they have to be to persist, and eight corners; one of them is held."""

    def radius(points):
        along = np.abs(points).max(axis=1)
        is_rod = np.sort(np.abs(points), axis=1)[:, 1] < 1e-9
        return np.where(is_rod, np.maximum(1 - along, np.minimum(0.3, 2 - along)), 1 - along)

    vertices, edges = rays(np.concatenate([CORNERS, 2 * AXES]), 0.9)
    is_held = np.zeros(len(vertices), dtype=bool)
    stays, _ = cut_corners(vertices, edges, is_held, radius)
    assert not stays[1:73].any() and stays[73:].all()
    is_held[5] = True
    stays, _ = cut_corners(vertices, edges, is_held, radius)
    assert stays[1:10].all() and not stays[10:73].any()


def test_limbs_that_taper_are_no_corners():
    """Cones of a half angle of 20 degrees, whose balls shrink by 0.34 of each step."""
    vertices, edges = rays(AXES, 2.5)
    none = np.zeros(len(vertices), dtype=bool)
    assert cut_corners(vertices, edges, none, lambda points: 1 - 0.34 * np.linalg.norm(points, axis=1))[0].all()


def test_a_limb_of_one_edge_is_no_corner():
    """Its balls are looked at between its nodes: two long cubes and a thin rod, which shrinks at once and then not."""
    vertices = np.array([[0.0, 0, 0], [3, 0, 0], [-3, 0, 0], [0, 1.8, 0]])

    def radius(points):
        return np.maximum(1 - np.abs(points[:, 1]), np.where(points[:, 1] < 1.8, 0.25, 0.2))

    assert cut_corners(vertices, as_edges([(0, 1), (0, 2), (0, 3)]), np.zeros(4, dtype=bool), radius)[0].all()


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
    """Two ways between two junctions: one of them would be lost."""
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


def test_equal_limbs_stay_together_and_no_other_is_held():
    """Of legs of persistence 2.6, 2.45 and 1.9, at a threshold of 2.5, the second stays by the first's side."""
    vertices, edges, radii = star_of([1.6 * 2, 1.45 * 2, 0.9 * 2, 8.0, 8.0], 2.0, 0.05)
    leaves = [
        branch.nodes[-1] if branch.nodes[0] == 0 else branch.nodes[0] for branch in measure(vertices, edges, radii)
    ]
    found = equals(vertices, edges, radii, 2.5)
    assert np.flatnonzero(found).tolist() == [sorted(leaves)[1]]
    assert not equals(vertices, edges, radii, 1.5).any()


def test_limbs_that_are_all_a_little_too_short_stay_together():
    """Of a star two stay in any case, and so do those that are as long; where a trunk stays, none need do."""
    vertices, edges, radii = star_of([0.99, 0.98, 0.97, 0.5], 2.0, 0.05)
    leaves = np.flatnonzero(np.bincount(edges.ravel()) == 1)
    found = equals(vertices, edges, radii, 1.5)
    assert np.flatnonzero(found).tolist() == leaves[:3].tolist()
    num = len(vertices)
    forked = np.concatenate([vertices, vertices[leaves[3]] + 9 * np.eye(3)[:2]])
    joined = np.concatenate([edges, [[leaves[3], num], [leaves[3], num + 1]]])
    assert not equals(forked, joined, np.r_[radii, 2.0, 2.0], 1.5)[leaves].any()


def test_a_loop_that_is_folded_flat_is_no_loop():
    """A node on an edge, two nodes in one place, an edge without length; a true triangle stays, and so does a pin."""
    x = np.array([[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0], [1.5, 0, 0], [2.2, 1e-9, 0], [3, 0, 0], [0, 1, 0.0]])
    edges = np.array([[0, 1], [1, 2], [2, 3], [1, 4], [2, 4], [3, 6], [2, 5], [5, 6], [0, 7], [1, 7]])
    assert cycle_count(8, edges)[1] == 3
    is_pin = np.arange(8) == 6
    stays, target, left = lay_together(x, edges, is_pin)
    assert np.flatnonzero(~stays).tolist() == [3] and target[3] == 6
    assert left.tolist() == [[0, 1], [0, 7], [1, 4], [1, 7], [2, 4], [2, 5], [5, 6]]
    once = np.array([0, 1, 2, 4, 5, 6, 7])
    apart = lay_together(x[once], np.searchsorted(once, left), is_pin[once])
    assert apart[0].all() and np.array_equal(apart[2], np.searchsorted(once, left))
    crossing = np.array([[-1, 0, 0], [0, 0, 0], [1, 0, 0], [0, -1, 0], [0, 1, 0], [0, 0, 1.0]])  # they touch, no more
    ways = np.array([[0, 1], [1, 2], [3, 4], [0, 5], [3, 5]])
    touching = lay_together(crossing, ways, np.zeros(6, dtype=bool))
    assert touching[0].all() and np.array_equal(touching[2], np.unique(ways, axis=0))
    nothing = lay_together(x[:1], np.empty((0, 2), dtype=int), is_pin[:1])
    assert nothing[0].all() and nothing[2].shape == (0, 2)
