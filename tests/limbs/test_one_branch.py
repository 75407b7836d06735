"""One branch for each limb: which leaves stay, ends that are laid on the rings of their limbs, and lost limbs."""

import numpy as np
import pytest
from curve_cases import bow, draft_of, is_inside, job_of, length_of, none_held, path, tube, unit_shape
from graph_cases import as_edges
from limb_cases import LIMB, RADIUS, block, fingers, legs, solid
from scipy import spatial

import msf_jax
from msf_jax.curve import finishing
from msf_jax.limbs import one_branch
from msf_jax.limbs.tree import LimbTree
from msf_jax.topology.graphs import cycle_count
from tests.benchmarks import ground_truth

LINE = np.linspace([-1.0, 0, 0], [1, 0, 0], 41)


def limbed(shape, x, edges, is_held=None):
    """The curve with one branch to the end of each limb, as (vertices, edges)."""
    draft = draft_of(x, edges)
    found = finishing.prune_and_extend(
        draft if is_held is None else draft._replace(is_held=is_held), job_of(shape), extend=True
    )
    return found.vertices, found.edges


def leaves_at(x, edges):
    return x[one_branch.leaves_of(edges)]


def test_a_limb_keeps_the_leaf_farthest_from_its_base_and_others_are_missing():
    """Two leaves in the first of four fingers, four radii long, and one in the block below them."""
    shape = solid(fingers(), 0.15)
    tree = LimbTree(shape)
    limbs = tree.limbs(1.2, 0.0)
    at = [[-1.2, 0, 0.7], [-1.15, 0, 0.5], [1.2, 1, -1.0]]
    x, edges = np.array([[0, 0, -1.0], *at]), as_edges([(0, 1), (0, 2), (0, 3)])
    number = [int(np.argmin([abs(tree.shape.vertices[limb.tip, 0] - x) for limb in limbs.limbs])) for x in (-1.2, 1.2)]
    leaf, _ = one_branch.choose(tree, limbs, tree.shape, x, edges, none_held(x))
    assert leaf[number[0]] == 1 and leaf[number[1]] == -1 and sorted(leaf) == [-1, -1, -1, 1]
    # The limb's width is its radius, and the finger ends at 1.0.
    for height, stays in ((0.9, 2), (0.5, 1)):
        x[2, 2] = height
        x[1, 2] = 0.95
        assert one_branch.choose(tree, limbs, tree.shape, x, edges, np.arange(4) == 2)[0][number[0]] == stays


@pytest.mark.parametrize("turn", [0.02, 0.3])
def test_a_short_curve_is_carried_to_both_ends(turn):
    line = bow(turn) * (5 if turn < 0.1 else 1)
    shape, scale = unit_shape(tube(line))
    x, edges = limbed(shape, *path(scale * line[20:-20]))
    gap = spatial.KDTree(leaves_at(x, edges)).query(scale * line[[0, -1]])[0] / (0.15 * scale)
    assert (gap < 0.5).all()
    assert (gap > 0.1).all()
    assert is_inside(shape, x, edges)
    assert cycle_count(len(x), edges) == (1, 0)


def test_a_held_leaf_is_not_carried_on():
    line = bow(0.3)
    shape, scale = unit_shape(tube(line))
    short = scale * line[20:-20]
    x, edges = limbed(shape, *path(short), np.arange(len(short)) == 0)
    leaves = one_branch.leaves_of(edges)
    assert 0 in leaves and len(leaves) == 2
    np.testing.assert_array_equal(x[0], short[0])
    (other,) = leaves[leaves != 0]
    assert np.linalg.norm(x[other] - scale * line[-1]) < 0.5 * 0.15 * scale


def test_a_held_node_behind_a_leaf_is_not_moved():
    line = bow(0.3)[20:-20]
    shape, scale = unit_shape(tube(bow(0.3)))
    x, _ = limbed(shape, *path(scale * line), np.arange(len(line)) == 1)
    np.testing.assert_array_equal(x[1], scale * line[1])


@pytest.mark.parametrize("at", [[-0.1, 0.1], [-0.1, 0, 0.1], [-0.1, -0.03, 0.03, 0.1], [-0.1, -0.09, 0.1]])
def test_both_ends_of_a_short_branch_are_carried_on(at):
    """Neither takes the other's half."""
    shape, scale = unit_shape(tube(LINE, 0.3))
    line = np.array(at)[:, None] * [scale, 0, 0]
    x, edges = limbed(shape, *path(line))
    leaves = leaves_at(x, edges)
    assert len(leaves) == 2
    assert np.abs(np.sort(leaves[:, 0] / scale) - [-0.9, 0.9]).max() < 0.05
    assert length_of(x, edges) < 1.9 * scale


@pytest.mark.parametrize("at", [2.0, pytest.param(7.5, marks=pytest.mark.slow)])
def test_a_pin_on_the_side_of_a_bar_leaves_both_its_ends(at):
    mesh = ground_truth.swept_tube(np.linspace([0, 0, 0], [10, 0, 0], 100), np.full(100, 0.6), 16)
    pin = int(np.linalg.norm(np.asarray(mesh.vertices) - [at, 0.6, 0], axis=1).argmin())
    skeleton = msf_jax.skeletonize(mesh, pins=[pin])
    assert skeleton.vertices[:, 0].min() < 0.4 and skeleton.vertices[:, 0].max() > 9.6
    assert np.isclose(skeleton.vertices, np.asarray(mesh.vertices)[pin]).all(axis=1).any()


def test_a_limb_keeps_its_leaf_and_the_one_farthest_from_it():
    x, edges = legs(
        [(0, 0, 0), (1, 0, 0)], [(0, 0, 0), (-1, 0, 0)], [(0, 0, 0), (0, 1, 0)], [(0, 0, 0), (0, 0, 2)], step=0.5
    )
    leaf = np.flatnonzero(np.bincount(edges.ravel()) == 1)
    is_end = np.arange(len(x)) == leaf[0]
    stays, target = one_branch.kept(x, edges, is_end, np.zeros(len(x), dtype=bool))
    left = np.flatnonzero(np.bincount(edges[stays[edges].all(axis=1)].ravel(), minlength=len(x)) == 1)
    assert left.tolist() == [leaf[0], leaf[3]]
    assert set(target[~stays].tolist()) == {0} and (target[stays] == np.flatnonzero(stays)).all()
    held = np.isin(np.arange(len(x)), leaf[1])
    stays, _ = one_branch.kept(x, edges, is_end, held)
    assert stays[leaf].tolist() == [True, True, False, False]


def test_components_keep_their_longest_path_unless_they_have_a_loop_or_two_limbs():
    tree = legs([(0, 0, 0), (1, 0, 0)], [(0, 0, 0), (-2, 0, 0)], [(0, 0, 0), (0, 3, 0)], step=1.0)
    ring = np.array([(0.0, 0, 9), (1, 0, 9), (0, 1, 9), (-4, 0, 9)]), as_edges([(0, 1), (1, 2), (2, 0), (0, 3)])
    parts = [tree, (tree[0] + (0, 0, 5), tree[1]), ring]
    first = np.cumsum([0] + [len(x) for x, _ in parts])
    x = np.concatenate([part[0] for part in parts])
    edges = np.concatenate([part[1] + at for part, at in zip(parts, first, strict=False)])
    leaf = one_branch.leaves_of(tree[1])
    stays = np.zeros(len(x), dtype=bool)
    stays[leaf[:2] + first[1]] = True
    assert np.flatnonzero(one_branch.ends(x, edges, stays)).tolist() == leaf[1:].tolist()
    stays[:] = False
    stays[leaf[0]] = True
    found = np.flatnonzero(one_branch.ends(x, edges, stays))
    assert found.tolist() == [leaf[0], leaf[2], *(leaf[1:] + first[1])]


def test_a_lost_limb_gets_a_branch_through_its_middle():
    shape = solid(block() + LIMB["long cylinder"][0], 0.15)
    x, edges = trunk = legs([(0, 0, -1.02), (1.4, 0, -1)], [(0, 0, -1.02), (-1.4, 0, -1)])
    tree, held = LimbTree(shape), none_held(trunk[0])
    leaf, axes = one_branch.choose(tree, tree.limbs(1.2, 0.5), tree.shape, x, edges, held)
    tops = [limb.place[2] > 1 for limb in tree.limbs(1.2, 0.5).limbs]
    (number,) = np.flatnonzero(tops)
    assert leaf[number] == -1
    x, edges, leaf = one_branch.grown(shape, *trunk, leaf, axes)
    assert leaf[number] >= len(held)
    assert cycle_count(len(x), edges) == (1, 0)
    np.testing.assert_array_equal(x[: len(held)], trunk[0])
    new = x[len(held) :]
    assert np.hypot(*new[:, :2].T).max() < 0.5 * RADIUS
    assert new[:, 2].max() == pytest.approx(1.5 - 0.3 * RADIUS, abs=0.03)


def test_limbs_without_a_leaf_get_one_and_leaves_in_the_body_go():
    """Three leaves in a block with four fingers: a component keeps two until fingers have theirs."""
    shape = solid(fingers(), 0.15)
    x, edges = legs(*[[(0, 0, -1.02), (a, b, -1)] for a, b in ((1.4, 1.4), (-1.4, -1.4), (-1.4, 1.4))])
    found = finishing.prune_and_extend(draft_of(x, edges), job_of(shape)._replace(prune=1.2), extend=True)
    leaves = found.vertices[found.is_leaf()]
    assert len(leaves) == 4 and (leaves[:, 2] > 0.8).all() and (found.num_grown, found.num_pruned) == (4, 3)
    assert cycle_count(len(found.vertices), found.edges) == (1, 0)
