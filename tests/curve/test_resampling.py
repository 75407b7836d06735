"""Corners of a curve are rounded."""

import manifold3d
import numpy as np
import pytest
import trimesh
from curve_cases import is_inside, none_held, path, unit_shape

from msf_jax.curve import resampling
from msf_jax.topology.graphs import cycle_count


def test_a_corner_is_rounded_in_its_ball():
    """In an angle of two bars, where all shortcuts leave it: small turns, inside, and no node but the corner moves."""
    angle = manifold3d.Manifold.cube([2, 2, 0.1])
    angle -= manifold3d.Manifold.cube([1.9, 1.9, 0.2]).translate([0.1, 0.1, -0.05])
    found = angle.to_mesh()
    shape, scale = unit_shape(trimesh.Trimesh(found.vert_properties[:, :3].astype(float), found.tri_verts))
    x, edges = path(scale * np.array([[1.5, 0.06, 0.05], [0.8, 0.06, 0.05], [0.09, 0.09, 0.05], [0.06, 1.5, 0.05]]))
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
