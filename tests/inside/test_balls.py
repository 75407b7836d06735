"""Shrinking balls: empty, touching twice, and as large as the tube."""

import numpy as np
import pytest
import trimesh
from conftest import blob, torus

import msf_jax
from msf_jax import Config, PreprocessingOptions
from msf_jax.base.errors import ConfigError
from msf_jax.inside import balls
from msf_jax.solid.geometry import unit, vertex_normals
from msf_jax.solid.kernels import tree_of


def test_balls_are_empty_and_touch_two_points():
    mesh = blob(3)
    points, faces = np.array(mesh.vertices), np.array(mesh.faces)
    normals = unit(vertex_normals(points, faces))
    every = np.arange(len(points))
    radius, touching = balls.shrinking_balls(points, normals, tree_of(points, points), 0.02, 5.0, every)
    assert (touching >= 0).all() and (touching != every).all()
    centre = points - radius[:, None] * normals
    np.testing.assert_allclose(np.linalg.norm(points[touching] - centre, axis=1), radius, rtol=1e-9)
    # By brute force: the least radius of all, but for points beside the vertex, which count as noise.
    away = points[:, None] - points[None]
    length2, depth = np.einsum("ijk,ijk->ij", away, away), np.einsum("ijk,ik->ij", away, normals)
    with np.errstate(divide="ignore", invalid="ignore"):
        found = np.where((depth > 0) & (length2 - 2 * depth**2 < balls.NOISE * length2), length2 / (2 * depth), np.inf)
    np.testing.assert_allclose(radius, found.min(axis=1), rtol=1e-9)
    cosine = np.einsum("ij,ij->i", unit(points - centre), unit(points[touching] - centre))
    assert cosine.max() < balls.NOISE + 1e-9


def test_balls_of_a_sphere_and_of_a_tube_have_its_radius():
    ball = trimesh.creation.icosphere(4, 0.3)
    found = balls.ball_poles(np.array(ball.vertices), np.array(ball.faces))
    assert found.is_found.all()
    assert np.abs(found.radius - 0.3).max() < 0.01
    ring = torus(1.0, 0.2, 80, 24)
    found = balls.ball_poles(np.array(ring.vertices), np.array(ring.faces))
    assert np.abs(found.radius - 0.2).max() < 0.01


@pytest.mark.slow  # centres of balls do in test_replay
@pytest.mark.usefixtures("few_rows_once")
def test_voronoi_poles_replay_to_the_run():
    run = msf_jax.contract(
        blob(3, 2), config=Config(max_iterations=3, preprocessing=PreprocessingOptions(poles="voronoi"))
    )
    assert np.abs(np.asarray(msf_jax.replay(run.tape, run.weights)) - run.curve.vertices).max() < 1e-9
    with pytest.raises(ConfigError, match="poles is 'ball': expected"):
        Config(preprocessing=PreprocessingOptions(poles="ball"))


def test_a_ball_ends_where_rounding_finds_the_same_one_again():
    rng = np.random.default_rng(0)
    for apart in 10 ** rng.uniform(-9.5, -6, 60):
        points = rng.uniform(-0.5, 0.5, (2, 3))
        normal = unit(rng.normal(size=3))
        points[1] = points[0] + apart * unit(rng.normal(size=3) - 2 * normal)
        radius, _ = balls.shrinking_balls(points[:1], normal[None], tree_of(points, points), 0.01, 1.0, np.arange(1))
        assert 0 < radius[0] <= 1.0
