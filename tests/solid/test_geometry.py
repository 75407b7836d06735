"""Normals of vertices, one corner at a time."""

import numpy as np
from conftest import blob
from solid_cases import arrays, outward_normals

from msf_jax.solid.geometry import vertex_normals


def test_vertex_normals_weigh_faces_by_their_angle():
    vertices, faces = arrays(blob(12, 2))
    np.testing.assert_allclose(vertex_normals(vertices, faces), outward_normals(vertices, faces), atol=1e-12)
