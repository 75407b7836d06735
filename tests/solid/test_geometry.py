"""Normals of vertices, one corner at a time."""

import numpy as np
from conftest import blob
from solid_cases import arrays, outward_normals

from msf_jax.solid.geometry import distinct, vertex_normals


def test_vertex_normals_weigh_faces_by_their_angle():
    vertices, faces = arrays(blob(12, 2))
    np.testing.assert_allclose(vertex_normals(vertices, faces), outward_normals(vertices, faces), atol=1e-12)


def test_distinct_numbers_are_those_of_numpy():
    for numbers in ([], [3], [5, 2, 5, 5, -1, 2], [0, 0]):
        found = distinct(np.array(numbers, dtype=np.int64))
        np.testing.assert_array_equal(found, np.unique(np.array(numbers, dtype=np.int64)))
