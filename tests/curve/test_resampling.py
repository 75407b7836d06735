"""Corners of a curve: cut where the shortcut is inside, rounded where it is not, and no loop is folded flat."""

import manifold3d
import numpy as np
import pytest
import trimesh
from conftest import torus
from curve_cases import bow, is_inside, none_held, path, tube, turns_of, unit_shape

from msf_jax.curve import resampling
from msf_jax.topology.graphs import cycle_count


def test_a_loop_around_a_hole_is_not_folded_flat():
    """Of a triangle around it, with two more nodes on one side: each turns, and all shortcuts are inside."""
    shape, scale = unit_shape(torus(1.0, 0.6, 48, 24))
    angle = np.radians([0, 120, 240])
    x = 1.2 * scale * np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    edges = np.array([[0, 1], [1, 2], [0, 2]])
    assert is_inside(shape, x, edges)
    np.testing.assert_array_equal(resampling.straighten(shape, x, edges, none_held(x), 90.0), x)
    spike = np.concatenate([x, [x[0] * 1.2]])  # there and back, beside the way from 0 to 1
    chain = np.array([[0, 3], [1, 3], [1, 2], [0, 2]])
    straight = resampling.straighten(shape, spike, chain, np.arange(4) < 3, 90.0)
    np.testing.assert_allclose(straight[3], (x[0] + x[1]) / 2, atol=1e-12)


def test_where_the_corner_cannot_be_cut_a_half_of_it_is():
    shape, scale = unit_shape(tube(bow(0.6)))
    x, edges = path(scale * np.array([1, 1.1, 1])[:, None] * bow(0.6)[[2, 14, 26]])
    assert is_inside(shape, x, edges) and not is_inside(shape, x[[0, 2]], np.array([[0, 1]]))
    found = resampling.straighten(shape, x, edges, np.arange(3) != 1, most=40.0)
    assert is_inside(shape, found, edges) and 0 < turns_of(found, edges)[0] < turns_of(x, edges)[0] - 5


def test_a_corner_that_cannot_be_cut_is_rounded_in_its_ball():
    """In an angle of two bars, where all shortcuts leave it: small turns, inside, and no node but the corner moves."""
    angle = manifold3d.Manifold.cube([2, 2, 0.1])
    angle -= manifold3d.Manifold.cube([1.9, 1.9, 0.2]).translate([0.1, 0.1, -0.05])
    found = angle.to_mesh()
    shape, scale = unit_shape(trimesh.Trimesh(found.vert_properties[:, :3].astype(float), found.tri_verts))
    x, edges = path(scale * np.array([[1.5, 0.06, 0.05], [0.8, 0.06, 0.05], [0.09, 0.09, 0.05], [0.06, 1.5, 0.05]]))
    np.testing.assert_array_equal(resampling.straighten(shape, x, edges, none_held(x), 40.0), x)
    y, led = resampling.round_corners(shape, x, edges, none_held(x), 40.0)
    assert is_inside(shape, y, led) and cycle_count(len(y), led) == (1, 0)
    assert resampling.turns(x, edges).max() > 80 and resampling.turns(y, led).max() < 40
    np.testing.assert_array_equal(y[[0, 1, 3]], x[[0, 1, 3]])
    assert np.linalg.norm(y[2] - x[2]) < shape.clearance(x[[2]])[0]
    held = np.arange(4) == 2
    np.testing.assert_array_equal(resampling.round_corners(shape, x, edges, held, 40.0)[0], x)


@pytest.mark.parametrize("num_cycles", [0, 1])
def test_corners_side_by_side_are_rounded(num_cycles):
    """Of a ring, all; of a zigzag, those between its ends."""
    shape, _ = unit_shape(trimesh.creation.icosphere(3))
    x, edges = path(0.2 * np.array([[1.0, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]]))
    if num_cycles:
        edges = np.concatenate([edges, [[0, 3]]])
    else:
        x, edges = path(0.02 * np.array([[k, k % 2, 0] for k in range(-5, 6)]))
    y, led = resampling.round_corners(shape, x, edges, none_held(x), 40.0)
    assert np.count_nonzero(resampling.turns(x, edges) > 80) == (4 if num_cycles else 9)
    assert resampling.turns(y, led).max() < 40
    assert cycle_count(len(y), led) == (1, num_cycles)


def test_corners_are_rounded_whatever_is_beside_them():
    """A sharper one that is outside, and a held node that another is in one place with."""
    shape, _ = unit_shape(trimesh.creation.icosphere(3))
    x, edges = path(0.2 * np.array([[-1, 5, 0], [0, 5, 0], [-3, 0, 0], [-1, 0, 0], [0, 0, 0], [0, 1, 0], [0, 1.5, 0]]))
    y, led = resampling.round_corners(shape, x, edges, np.arange(7) == 2, 40.0)
    turn = resampling.turns(y, led)
    assert turn[1] > 120 and np.delete(turn, [1, 2]).max() < 40
    x, edges = path(0.2 * np.array([[-1, 0, 0], [-0.2, 0, 0], [-0.2, 0, 0], [0, 0, 0], [0, 1, 0]]))
    y, led = resampling.round_corners(shape, x, edges, np.arange(5) == 2, 40.0)
    np.testing.assert_array_equal(y[2], x[2])
    assert resampling.turns(y, led)[3:].max() < 40
