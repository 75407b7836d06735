"""A thin side branch begins where its axis meets its trunk."""

from itertools import pairwise

import numpy as np
import pytest

from msf_jax import shapes
from msf_jax.curve import junctions
from msf_jax.solid.enclosure import Enclosure


def test_the_axis_of_a_side_branch_ends_at_the_first_stretch_of_trunk():
    """Of a trunk that turns back: it passes the first stretch at a tenth of a radius, and crosses the second."""
    x = np.array([[4, 0, -6], [4, 0, -1], [4, 0, 0], [4, 0, 1], [4, 0, 6], [0, 0, 6], [0, 0, 1], [0, 0, 0], [0, 0, -6]])
    x = np.concatenate([x + [0, 0, 0.0], [[4 + k, 0.1, 0] for k in (0.0, 1.0, 2.0, 3.0, 8.0)]])
    x[:5, 1] = -0.1
    edges = np.array([*pairwise(range(9)), (2, 9), *pairwise(range(9, 14))])
    side = junctions.Side(np.r_[2, 9:14], 0.3, x[10], 3, np.array([7.0, 0, 0]), np.array([1.0, 0, 0]))
    radii, is_trunk = np.where(np.arange(14) < 9, 1.0, 0.3), np.arange(len(edges)) < 8
    found = junctions.meeting(side, x, edges, is_trunk, radii)
    assert found is not None and found.edge in (1, 2)
    np.testing.assert_allclose(found.place, [4, -0.1, 0], atol=1e-9)


def side_branch(astray, num=60):
    """A solid of a trunk of radius 3 along z and a side branch of radius 1 from 0, 45 degrees up, and a curve whose
    side branch runs along the trunk for ``astray`` before it leaves it."""
    top = np.array([0, 30, 30])
    points = np.array([[0, 0, -30], [0, 0, 40], [0, 0, 0], top], dtype=float)
    mesh = shapes.solid_around(points, np.array([[0, 1], [2, 3]]), np.array([3.0, 3.0, 1.0, 1.0]), 1.0)
    line = np.linspace(0, 1, num)[:, None]
    trunk = points[0] + line * (points[1] - points[0])
    first = int(np.abs(trunk[:, 2] - astray).argmin())
    leaves = np.array([0, 0.5, 0.5])  # on the side branch's axis, in the trunk
    legs = np.concatenate(
        [trunk[first] + line[1:10] / line[9] * (leaves - trunk[first]), leaves + line * (top - leaves)]
    )
    chain = np.r_[first, num + np.arange(len(legs))]
    edges = np.concatenate([np.stack([c[:-1], c[1:]], axis=1) for c in (np.arange(num), chain)])
    return Enclosure(np.asarray(mesh.vertices), np.asarray(mesh.faces)), np.concatenate([trunk, legs]), edges, first


@pytest.mark.parametrize("astray", [-8.0, 8.0])
def test_a_side_branch_begins_where_its_axis_meets_the_trunk(astray):
    """`THIN`, `STRETCH`: wherever it ran along the trunk."""
    shape, x, edges, first = side_branch(astray)
    held = np.zeros(len(x), dtype=bool)
    found, found_edges = junctions.attached(shape, x, edges, held, shape.clearance(x))
    degree = np.bincount(found_edges.ravel())
    assert (degree > 2).sum() == 1 and degree[first] == 2
    assert np.linalg.norm(found[degree > 2]) < 0.1
    assert len(found) == len(x) + 1 and len(found_edges) == len(edges) + 1
    np.testing.assert_array_equal(found[:60], x[:60])  # the trunk stays


def test_a_node_without_edges_is_no_side_branch():
    """A curve of one node, of a ball. No median is taken of nothing."""
    with np.errstate(all="raise"):
        sides, is_trunk = junctions.thin_sides(
            np.zeros((1, 3)), np.empty((0, 2), np.int64), np.zeros(1, bool), np.ones(1)
        )
    assert sides == [] and is_trunk.shape == (0,)
