"""Triangles that cross: those of all pairs, none where solids touch, and where a side passes through."""

import numpy as np
import pytest
import trimesh

from msf_jax.solid import crossings
from msf_jax.solid.enclosure import Enclosure
from tests.benchmarks.faults import together


def enclosure(mesh: trimesh.Trimesh) -> Enclosure:
    return Enclosure(np.array(mesh.vertices), np.array(mesh.faces))


def passes(start, end, triangle):
    """Whether a segment passes through a triangle, by the signs of the volumes of five tetrahedra."""
    a, b, c = triangle
    above, below = (np.linalg.det([b - a, c - a, place - a]) for place in (start, end))
    turns = [np.linalg.det([end - start, u - start, v - start]) for u, v in ((a, b), (b, c), (c, a))]
    return above * below < 0 and (min(turns) >= 0 or max(turns) <= 0)


def test_crossing_triangles_are_those_of_all_pairs():
    """Of twenty tetrahedra."""
    random = np.random.default_rng(7)
    vertices = (random.random((20, 1, 3)) + random.normal(0, 0.15, (20, 4, 3))).reshape(-1, 3)
    faces = np.concatenate([np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]) + 4 * k for k in range(20)])
    corners = vertices[faces]
    expected = {
        (i, j)
        for i, j in zip(*np.triu_indices(80, 1), strict=True)
        for one, other in ((corners[i], corners[j]), (corners[j], corners[i]))
        if i // 4 != j // 4 and any(passes(one[k], one[(k + 1) % 3], other) for k in range(3))
    }
    assert len(expected) > 10 and set(map(tuple, Enclosure(vertices, faces).crossed.pairs.tolist())) == expected


def test_solids_that_touch_do_not_cross():
    boxes = [trimesh.creation.box().subdivide().apply_translation([k, 0.1 * k, 0]) for k in range(2)]
    assert not enclosure(together(*boxes)).crossed.pairs.size
    assert enclosure(together(boxes[0], boxes[1].apply_translation([-0.1, 0, 0]))).crossed.pairs.size


@pytest.mark.parametrize(("gap", "expected"), [(0.0, [1]), (1e-7, [1]), (0.1, [])])
def test_a_curve_passes_through_faces_that_touch(gap, expected):
    """From box to box; neither within one of them, nor where the curve leaves the solid between them."""
    boxes = [trimesh.creation.box().subdivide().apply_translation([(1 + gap) * k, 0.1 * k, 0]) for k in range(2)]
    nodes = np.array([[-0.3, 0.05, 0.1], [0.1, 0.05, 0.12], [0.8, 0.05, 0.14], [1.2, 0.05, 0.11]])
    found = crossings.passed(enclosure(together(*boxes)), nodes, np.array([[0, 1], [1, 2], [2, 3]]))
    assert found.tolist() == expected


@pytest.mark.parametrize(("along", "num"), [(1.0, 3), (0.1, 0)])
def test_faces_cross_if_they_are_apart_along_the_curve(along, num):
    """The corner of a tetrahedron within another cuts the slanted face with its own three. Each has its own node."""
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])
    faces = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
    shape = Enclosure(np.concatenate([corners, corners + [0.1, 0.1, 0.5]]), np.concatenate([faces, faces + 4]))
    node, radii = np.repeat([0, 1], 4), np.array([0.4, 0.4])
    found = crossings.apart_pairs(
        shape, (), node, radii if along > 0.5 else 3 * radii, np.array([[0, 1]]), np.array([along])
    )
    assert len(found) == num
