"""Normals at the corners of faces: smooth over a ball, flat at sharp edges."""

import numpy as np
import trimesh

from msf_jax.meshes import shading


def test_a_mesh_without_normals_gets_smooth_ones_and_sharp_creases():
    """Of a ball those of its radii, also across a seam; of a box those of its faces; of a prism of six sides, with
    creases of 60 degrees, those of its cylinder; of one of four sides those of its faces."""
    ball = trimesh.creation.icosphere(subdivisions=3)
    halves = [
        ball.submesh([np.flatnonzero(side)], append=True)
        for side in (ball.triangles_center[:, 0] > 0, ball.triangles_center[:, 0] <= 0)
    ]
    apart = trimesh.util.concatenate(halves)
    assert len(apart.vertices) > len(ball.vertices)
    normals, fans = shading.corner_normals(apart.vertices, apart.faces)
    assert np.linalg.norm(normals - apart.vertices[apart.faces], axis=2).max() < 0.02
    assert fans.max() + 1 == len(ball.vertices)
    box = trimesh.creation.box()
    normals, fans = shading.corner_normals(box.vertices, box.faces)
    np.testing.assert_allclose(normals, np.repeat(box.face_normals[:, None], 3, axis=1), atol=1e-12)
    assert fans.max() + 1 == 24
    for sides, num in ((6, 12), (4, 16)):
        angle = 2 * np.pi * np.arange(sides) / sides
        low, high = (np.c_[np.cos(angle), np.sin(angle), np.full(sides, z)] for z in (0.0, 1.0))
        a, b = np.arange(sides), (np.arange(sides) + 1) % sides
        wall = np.concatenate([np.c_[a, b, b + sides], np.c_[a, b + sides, a + sides]])
        normals, fans = shading.corner_normals(np.concatenate([low, high]), wall)
        assert fans.max() + 1 == num
        if sides == 6:
            outward = np.concatenate([low, high])[wall] * [1, 1, 0]
            assert np.einsum("fcx,fcx->fc", normals, outward).min() > 1 - 1e-9
    flat = shading.corner_normals(np.array([[0.0, 0, 0], [1, 0, 0], [2, 0, 0]]), np.array([[0, 1, 2]]))[0]
    np.testing.assert_array_equal(flat[0], np.tile([0.0, 0, 1], (3, 1)))
