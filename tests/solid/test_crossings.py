"""Triangles that cross: those of all pairs, none where solids touch, and where a side passes through."""

import numpy as np
import trimesh

from msf_jax.solid import crossings
from msf_jax.solid.crossings import Crossings
from msf_jax.solid.enclosure import Enclosure
from tests.benchmarks.voids import together


def enclosure(mesh: trimesh.Trimesh) -> Enclosure:
    return Enclosure(np.array(mesh.vertices), np.array(mesh.faces))


def test_crossing_triangles_are_those_of_all_pairs():
    random = np.random.default_rng(7)
    corners = random.random((60, 1, 3)) + random.normal(0, 0.15, (60, 3, 3))
    shape = Enclosure(corners.reshape(-1, 3), np.arange(180).reshape(-1, 3))
    one, other = np.triu_indices(60, 1)
    is_crossed = crossings._cross(corners[one], corners[other])
    expected = set(zip(one[is_crossed].tolist(), other[is_crossed].tolist(), strict=True))
    assert len(expected) > 10 and {tuple(sorted(pair)) for pair in shape.crossed.pairs.tolist()} == expected


def test_solids_that_touch_do_not_cross():
    boxes = [trimesh.creation.box().subdivide().apply_translation([k, 0.1 * k, 0]) for k in range(2)]
    assert not enclosure(together(*boxes)).crossed.num
    assert enclosure(together(boxes[0], boxes[1].apply_translation([-0.1, 0, 0]))).crossed.num


def crossings_of(parts, gap):
    """Of two tetrahedra, the second shifted to ``gap`` above the first: each with a node of its own."""
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])
    faces = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
    vertices = np.concatenate([corners, corners + [0.1, 0.1, 2]])
    asked = Crossings(
        vertices,
        np.concatenate([faces, faces + 4]),
        np.repeat(parts, 4),
        np.array([0.2, 0.2]),
        np.array([[0, 1]]),
        np.array([2.0]),
    )
    vertices[4:, 2] += gap - 2
    return asked.found(vertices)


def test_faces_cross_where_a_side_passes_through():
    """The corner of a tetrahedron within another cuts the slanted face with its own three; once it is out, nothing."""
    assert {tuple(pair) for pair in crossings_of([0, 1], 0.5).tolist()} == {(2, 4), (2, 5), (2, 7)}
    assert len(crossings_of([0, 1], 1.01)) == 0
