"""Level sets of a height: their rings, pieces and sections."""

import numpy as np
import pytest
import trimesh

from msf_jax.limbs.levels import levels


@pytest.mark.parametrize(("mesh", "genus"), [(trimesh.creation.torus(1, 0.3), 1), (trimesh.creation.icosphere(2), 0)])
def test_rings_and_pieces_have_a_cycle_for_each_handle(mesh, genus):
    height = mesh.vertices @ [1.0, 0.3, 0.1]
    found = levels(mesh.vertices, mesh.faces, height, 0.07)
    assert len(found.centre) > 10
    assert len(found.centre) - len(found.contents) + 1 == genus  # edges and nodes of a connected graph
    level = found.centre @ [1, 0.3, 0.1] / 0.07 + 0.5
    np.testing.assert_allclose(level, level.round(), atol=1e-6)


def test_the_rings_of_a_cylinder_are_its_sections():
    mesh = trimesh.creation.cylinder(0.1, 2.0, sections=24)
    found = levels(mesh.vertices, mesh.faces, mesh.vertices[:, 2], 0.11)
    np.testing.assert_allclose(found.centre[:, :2], 0, atol=1e-12)
    np.testing.assert_allclose(found.perimeter, 24 * 2 * 0.1 * np.sin(np.pi / 24), rtol=1e-9)


def test_heights_on_a_level_but_for_rounding_lose_no_ring_and_no_area():
    """The floor of a cylinder, within 2 ulps of a level; and a box, whose floor and top are on levels."""
    mesh, random = trimesh.creation.cylinder(1.0, 3.0, sections=8), np.random.default_rng(6)
    is_floor = mesh.vertices[:, 2] < 0
    for _ in range(40):
        ulps = np.spacing(0.125) * random.integers(-2, 3, is_floor.sum())
        height = np.where(is_floor, 0.125, 3.2 + random.uniform(0, 0.01, len(is_floor)))
        height[is_floor] += ulps
        found = levels(mesh.vertices, mesh.faces, height, 0.25)
        assert len(found.centre) - len(found.contents) == -1
        assert found.contents[:, 0].sum() == pytest.approx(mesh.area, rel=1e-12)
    box = trimesh.creation.box((2, 2, 4))
    found = levels(box.vertices, box.faces, box.vertices[:, 2] + 2.5, 1.0)
    assert found.contents[:, 0].sum() == pytest.approx(box.area, rel=1e-12)


@pytest.mark.parametrize(("inner", "sign"), [(False, 1), (True, -1)])
def test_the_normal_of_a_ring_is_to_where_the_function_grows(inner, sign):
    """The other side for a ring around a hole; the triangles around a hole are those of a solid turned round."""
    mesh = trimesh.creation.cylinder(0.1, 2.0, sections=24)
    turn = trimesh.transformations.random_rotation_matrix(np.array([0.1, 0.5, 0.9]))[:3, :3]
    found = levels(mesh.vertices @ turn.T, mesh.faces[:, ::-1] if inner else mesh.faces, mesh.vertices[:, 2], 0.11)
    np.testing.assert_allclose(found.normal, sign * np.tile(turn[:, 2], (len(found.normal), 1)), atol=1e-9)


def test_the_step_grows_until_the_points_are_few_enough(monkeypatch):
    monkeypatch.setattr("msf_jax.limbs.levels.MOST_POINTS", 100_000)
    mesh = trimesh.creation.cylinder(0.1, 2.0, sections=8)
    found = levels(mesh.vertices, mesh.faces, mesh.vertices[:, 2], 1e-9)
    assert 500 < len(found.centre) < 10_000
