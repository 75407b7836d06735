"""Branches as paths: how they bend, and which sections are theirs."""

import numpy as np
import pytest
import trimesh
from curve_cases import none_held, path

import msf_jax
from msf_jax.curve import branches


def ring(angle: np.ndarray) -> tuple[np.ndarray, list]:
    """Nodes on a circle of radius 1, and their path."""
    nodes = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    edges = np.stack([np.arange(len(angle)), np.roll(np.arange(len(angle)), -1)], axis=1)
    return nodes, branches.paths_of(nodes, edges, none_held(nodes))


def test_a_line_and_a_circle_are_at_rest_however_their_nodes_are_spaced():
    """A node in a gap of a hundredth of the next one has no weight of a hundred."""
    gaps = np.random.default_rng(5).uniform(0.2, 1.0, 40)
    line, edges = path(np.cumsum(gaps)[:, None] * [[0.6, 0.0, 0.8]])
    bend, stiffness, rest = branches.bending(line, branches.paths_of(line, edges, none_held(line)), gaps)
    assert np.abs(bend @ line).max() < 1e-12 and not rest.any()
    assert stiffness[[10, 20]] == pytest.approx((2 * gaps[[11, 21]] / (gaps[11:13].sum(), gaps[21:23].sum())) ** 4)
    nodes, paths = ring(2 * np.pi * np.cumsum(gaps) / gaps.sum())
    bend, _, rest = branches.bending(nodes, paths, np.ones(40))
    plain = bend @ nodes
    assert np.linalg.norm(plain - rest, axis=1).max() < 0.15 * np.linalg.norm(plain, axis=1).max()
    assert np.linalg.norm(rest, axis=1).min() > 0.2 * np.linalg.norm(plain, axis=1).min()
    near = path(np.array([[0.0, 0, 0], [0.01, 0, 0], [1, 0, 0]]))
    bend = branches.bending(near[0], branches.paths_of(*near, none_held(near[0])), np.ones(3))[0]
    assert 9 < abs(bend).max() < 12


def test_a_loop_that_comes_back_through_a_section_is_seen():
    """Its section through both sides has its middle in the hole; one through its own side has not."""
    nodes, paths = ring(np.linspace(0, 2 * np.pi, 30, endpoint=False))
    tangent = np.cross([0.0, 0, 1], nodes)
    through_both = branches.crossed_again(nodes, paths, tangent, 0 * nodes, np.full(30, 1.3))
    own = branches.crossed_again(nodes, paths, tangent, nodes, np.full(30, 0.9))
    assert through_both.all() and not own.any()


def test_the_loop_of_a_torus_with_a_small_hole_is_a_circle():
    skeleton = msf_jax.skeletonize(trimesh.creation.torus(1.0, 0.95, major_sections=32, minor_sections=20))
    x = skeleton.vertices
    assert skeleton.report.cycles == 1 and skeleton.report.are_limbs
    assert np.abs(np.linalg.norm(x[:, :2], axis=1) - 1).max() < 0.02 and np.abs(x[:, 2]).max() < 0.02


def test_how_large_a_limb_is_near_by_is_a_mean_over_the_branch():
    """With weights of a bell over the way along it, and next to none, but not none, far away."""
    random = np.random.default_rng(3)
    curve, edges = path(np.cumsum(random.uniform(0.1, 1.0, (400, 3)), axis=0))
    size, weight, clearance = random.uniform(0.5, 2.0, (3, len(curve)))
    weight[100:150] = 0.0
    weight[300:] = 0.0  # nothing is known within many sizes of the end
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(curve, axis=0), axis=1))])
    usual = np.average(size, weights=weight)
    bell = (np.exp(-0.5 * ((along[:, None] - along) / usual) ** 2) + 1e-9) * weight
    expected = bell @ size / bell.sum(axis=1)
    found = branches.sizes(curve, branches.paths_of(curve, edges, none_held(curve)), size, weight, clearance)
    np.testing.assert_allclose(found, expected, rtol=1e-5)
