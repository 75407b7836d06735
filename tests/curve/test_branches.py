"""Branches of a curve: junctions in one ball become one, and what is beside a branch."""

from itertools import pairwise

import manifold3d
import numpy as np
import pytest
from graph_cases import as_edges, chain

from msf_jax.curve import branches
from msf_jax.curve.branches import merge_junctions
from msf_jax.solid.handles import Handles
from msf_jax.topology.graphs import cycle_count

FOUR = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])


NO_HANDLES = Handles(50.0 * np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]) - 10, FOUR)  # a tetrahedron


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


@pytest.mark.parametrize("number", [[0, 1, 2], [2, 1, 0], [1, 0, 2], [1, 2, 0]])
def test_the_nearest_junctions_merge_first_in_any_order_of_the_nodes(number):
    """Three in a row. Each of the outer ones can take the middle one, and not both can: the nearer one does."""
    vertices, legs = np.zeros((8, 3)), [(0, 3), (0, 4), (1, 5), (2, 6), (2, 7)]
    vertices[number, 0], vertices[3:, 1] = (0.0, 0.9, 1.4), 3.0
    radii = np.ones(8)
    radii[number] = 1.0, 1.0, 1.05
    at = np.r_[number, 3:8]
    edges = at[as_edges([(0, 1), (1, 2), *legs])]
    target = merge_junctions(vertices, edges, radii, np.zeros(8, dtype=bool), NO_HANDLES)[1]
    assert target[number].tolist() == [number[0], number[2], number[2]]


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


def test_points_go_to_the_nearest_node_of_their_own_branch():
    # A Y: branches 0-1-2, 0-3-4 and 0-5-6.
    nodes = np.array([[0.0, 0, 0], [2, 0, 0], [4, 0, 0], [0, 2, 0], [0, 4, 0], [-2, 0, 0], [-4, 0, 0]])
    edges = np.array([[0, 1], [1, 2], [0, 3], [3, 4], [0, 5], [5, 6]])
    points = np.array([[3.9, 1, 0], [0.1, 1, 0], [0, 3.9, 0], [-1.9, 0, 0], [-1.9, 0, 0]])
    found = branches.nearest_on_branch(nodes, edges, points, np.array([1, 2, 1, 1, 0]))
    assert found.tolist() == [2, 0, 0, 0, 5]


def test_a_limb_is_on_its_own_where_no_ball_of_another_branch_is_near():
    """Against all pairs of nodes, one by one; with a loop, a leaf, balls of very different sizes."""
    random = np.random.default_rng(4)
    turn = np.linspace(0, 2 * np.pi, 12, endpoint=False)
    ring = np.stack([2 * np.cos(turn), 2 * np.sin(turn), 0 * turn], axis=1)
    arm = np.array([[2 + 0.4 * k, 0, 0.3 * k] for k in range(1, 9)])
    twig = arm[3] + np.array([[0.1 * k, 0.3 * k, 0] for k in range(1, 6)])
    x = np.concatenate([ring, arm, twig]) + 0.02 * random.normal(size=(25, 3))
    edges = np.array(
        [*((k, (k + 1) % 12) for k in range(12)), (0, 12), *pairwise(range(12, 20)), (15, 20), *pairwise(range(20, 25))]
    )
    paths = branches.paths_of(x, edges, np.zeros(25, dtype=bool))
    tangent = random.normal(size=(25, 3))
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    size, ball = random.uniform(0.05, 0.6, 25), random.uniform(0.02, 1.0, 25)
    of = [{0, 15}, set(range(1, 12)), {12, 13, 14}, {16, 17, 18, 19}, {20, 21, 22, 23, 24}]
    found = branches.clear_of_others(x, paths, tangent, size, ball)
    for i in range(25):
        least = 1.0
        for j in range(25):
            if i != j and not any({i, j} <= group for group in of[1:]):
                height = float((x[j] - x[i]) @ tangent[i])
                aside = float(np.linalg.norm(x[j] - x[i] - height * tangent[i]))
                gap = float(np.hypot(height, max(aside - size[i], 0.0))) / ball[j]
                t = min(max((gap - 1) / branches.MARGIN + 0.5, 0.0), 1.0)
                least = min(least, t * t * (3 - 2 * t))
        assert found[i] == pytest.approx(0.0 if i in of[0] else least, abs=1e-12)
