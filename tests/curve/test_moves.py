"""Nodes that are moved only as far as every loop stays around its handle."""

import manifold3d
import numpy as np
import pytest
import trimesh
from curve_cases import bored, draft_of, rank, unit_shape

from msf_jax.curve import centring


def moved_to(shape, edges, x, goal):
    """The nodes x, moved as far to their goals as the rule of moves allows."""
    return centring.take_steps(shape, shape.handles, centring.places_of(shape, x), goal - x, edges).x


@pytest.mark.parametrize(
    ("x", "edges", "moved"),
    [
        # A loop whose junctions alone were moved, with a leg at each; and a ring that begins with the node that was.
        ([[0, 0, 0], [2, 0, 0], [1, 1, 0], [-1, 0, 0], [3, 0, 0]], [[0, 1], [0, 2], [1, 2], [0, 3], [1, 4]], [0, 1]),
        ([[0, 0, 0], [1, 1, 0], [2, 0, 0]], [[0, 1], [1, 2], [0, 2]], [0]),
    ],
)
def test_loops_that_their_junctions_fold_are_put_back(x, edges, moved):
    """They go around a hole at (1, 0.4)."""
    plate = manifold3d.Manifold.cube([8, 6, 1], True).translate((1.0, 0.0, 0.0))
    shape, scale = unit_shape(bored(plate, (1.0, 0.4), 0.1))
    x, flat = scale * np.array(x, dtype=float), scale * np.array(x, dtype=float)
    flat[moved] = scale * np.array([[0, 1, 0], [2, 1, 0]] if len(moved) == 2 else [[3, -1, 0]])
    draft = draft_of(x, np.array(edges))
    assert rank(shape, draft) == 1 and rank(shape, draft.changed(flat)) == 0
    assert rank(shape, draft.changed(moved_to(shape, draft.edges, x, flat))) == 1


def test_a_loop_is_not_moved_over_a_hole():
    """To the other side, where it would be as long as before, and a node beside it goes where it is to."""
    plate = manifold3d.Manifold.cube([8, 6, 1], True).translate((1.0, 0.0, 0.0))
    shape, scale = unit_shape(bored(plate, (1.0, 0.4), 0.1))
    x = scale * np.array([[0, 0, 0], [2, 0, 0], [1, 1, 0], [-1, 0, 0]], dtype=float)
    draft = draft_of(x, np.array([[0, 1], [1, 2], [0, 2], [0, 3]]))
    over = x + scale * np.array([[0, 0, 0], [0, 0, 0], [0, -1.5, 0], [0, 0.2, 0]])
    assert rank(shape, draft) == 1 and rank(shape, draft.changed(over)) == 0
    kept = moved_to(shape, draft.edges, x, over)
    assert rank(shape, draft.changed(kept)) == 1
    np.testing.assert_array_equal(kept[3], over[3])


def test_a_node_outside_comes_in_where_the_others_go():
    shape, scale = unit_shape(trimesh.creation.box([4, 1, 1]))
    x = scale * np.array([[-1, 0, 0], [0, 0.6, 0], [1, 0, 0]])
    goal = scale * np.array([[-1, 0, 0], [0, 0.1, 0], [1, 0.1, 0]])
    np.testing.assert_allclose(moved_to(shape, np.array([[0, 1], [1, 2]]), x, goal), goal)
