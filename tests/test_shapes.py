"""Solids made in code: closed, oriented outwards, and around the curve that they are made from."""

import numpy as np
import pytest
import trimesh

from msf_jax import shapes
from msf_jax.meshes import checking


def assert_closed_manifold(mesh: trimesh.Trimesh) -> None:
    """Every directed edge once with its reverse, and every vertex in one fan."""
    directed = {(u, v) for a, b, c in mesh.faces.tolist() for u, v in ((a, b), (b, c), (c, a))}
    assert len(directed) == 3 * len(mesh.faces)
    assert directed == {(v, u) for u, v in directed}
    follows: list[dict[int, int]] = [{} for _ in mesh.vertices]
    for a, b, c in mesh.faces.tolist():
        follows[a][b], follows[b][c], follows[c][a] = c, a, b
    for step in follows:
        start = at = next(iter(step))
        length = 0
        while length == 0 or at != start:
            at, length = step[at], length + 1
        assert length == len(step)


def euler(mesh: trimesh.Trimesh) -> int:
    """V - E + F of a closed mesh."""
    return len(mesh.vertices) - len(mesh.faces) // 2


def grid_of(function, spacing: float, reach: float) -> np.ndarray:
    """``function`` of x, y, z on a cubic grid around the origin."""
    axis = np.arange(-reach, reach + spacing / 2, spacing)
    return function(*np.meshgrid(axis, axis, axis, indexing="ij"))


@pytest.fixture(scope="module")
def hand() -> trimesh.Trimesh:
    return shapes.hand()


def test_the_hand_is_a_closed_solid_with_one_handle(hand):
    assert_closed_manifold(hand)
    assert euler(hand) == 0  # genus 1
    assert hand.body_count == 1
    assert hand.volume > 0
    assert np.isfinite(hand.vertices).all() and len(np.unique(hand.faces)) == len(hand.vertices)


def test_the_curve_of_the_hand_has_five_tips_a_forearm_and_one_loop(hand):
    points, edges, radii = shapes.hand_curve()
    degree = np.bincount(edges.ravel(), minlength=len(points))
    assert (degree == 1).sum() == 5  # the tips; the forearm's end carries the handle
    assert len(edges) - len(points) + 1 == 1  # independent cycles of a connected graph
    assert len(radii) == len(points) and (radii > 0).all()
    # The hand is built around it: every point is inside, about its radius from the surface.
    from_surface = np.array([np.linalg.norm(hand.vertices - point, axis=1).min() for point in points])
    assert (from_surface > 0.6 * radii).all()
    solid_angle = [
        2
        * np.arctan2(
            np.einsum("fi,fi->f", a, np.cross(b, c)),
            np.prod([np.linalg.norm(v, axis=1) for v in (a, b, c)], axis=0)
            + (a * b).sum(1) * np.linalg.norm(c, axis=1)
            + (b * c).sum(1) * np.linalg.norm(a, axis=1)
            + (c * a).sum(1) * np.linalg.norm(b, axis=1),
        ).sum()
        for a, b, c in ([hand.triangles[:, k] - point for k in range(3)] for point in points)
    ]
    np.testing.assert_allclose(solid_angle, 4 * np.pi, rtol=1e-9)


@pytest.mark.parametrize("seed", range(8))
def test_a_random_field_has_a_closed_surface(seed):
    """White noise inside a positive border: the surface has many parts and handles, and is closed all the same."""
    field = np.pad(np.random.default_rng(seed).normal(size=(7, 6, 5)), 1, constant_values=1.0)
    mesh = shapes.level_set(field, np.zeros(3), 1.0)
    assert len(mesh.faces) > 100
    assert_closed_manifold(mesh)
    assert mesh.volume > 0
    assert (mesh.area_faces > 0).all()


@pytest.mark.parametrize("seed", range(4))
def test_the_surface_parts_the_inside_from_the_outside(seed):
    """The parity of the surface's parts follows the field: negative samples are wound once, the others not at all."""
    field = np.pad(np.random.default_rng(seed).normal(size=(4, 4, 4)), 1, constant_values=1.0)
    field = np.where(np.abs(field) < 0.2, 0.2, field)  # keep samples off the surface
    mesh = shapes.level_set(field, np.zeros(3), 1.0)
    samples = np.stack(np.meshgrid(*(np.arange(n) for n in field.shape), indexing="ij"), axis=-1).reshape(-1, 3)
    a, b, c = (mesh.triangles[None, :, k] - samples[:, None] for k in range(3))
    la, lb, lc = (np.linalg.norm(v, axis=2) for v in (a, b, c))
    bottom = la * lb * lc + (a * b).sum(2) * lc + (b * c).sum(2) * la + (c * a).sum(2) * lb
    winding = 2 * np.arctan2((a * np.cross(b, c)).sum(2), bottom).sum(axis=1) / (4 * np.pi)
    np.testing.assert_allclose(winding, (field.ravel() < 0).astype(float), atol=1e-9)


def test_the_level_set_of_a_ball():
    """Volume, area and place of a ball of radius 1; every vertex about on it, every normal outwards."""
    spacing = 0.1
    field = grid_of(lambda x, y, z: np.sqrt(x**2 + y**2 + z**2) - 1, spacing, 1.3)
    mesh = shapes.level_set(field, np.full(3, -1.3), spacing)
    assert_closed_manifold(mesh)
    assert euler(mesh) == 2
    assert np.abs(np.linalg.norm(mesh.vertices, axis=1) - 1).max() < spacing / 20
    assert mesh.volume == pytest.approx(4 / 3 * np.pi, rel=0.02)
    assert (np.einsum("ij,ij->i", mesh.triangles_center, mesh.face_normals) > 0).all()


def test_the_level_set_of_a_torus():
    field = grid_of(lambda x, y, z: np.hypot(np.hypot(x, y) - 1, z) - 0.4, 0.1, 1.7)
    mesh = shapes.level_set(field, np.full(3, -1.7), 0.1)
    assert_closed_manifold(mesh)
    assert euler(mesh) == 0
    assert mesh.volume == pytest.approx(2 * np.pi**2 * 0.4**2, rel=0.03)


def test_a_solid_around_one_edge_is_a_capsule():
    """The volume of a cylinder and two half balls, and the radius all along."""
    points, edges, radii = np.array([[0.0, 0, 0], [2, 0, 0]]), np.array([[0, 1]]), np.array([0.5, 0.5])
    mesh = shapes.solid_around(points, edges, radii, 0.08)
    assert_closed_manifold(mesh)
    assert euler(mesh) == 2
    assert mesh.volume == pytest.approx(np.pi * 0.25 * 2 + 4 / 3 * np.pi * 0.125, rel=0.03)
    from_axis = np.linalg.norm(mesh.vertices - np.clip(mesh.vertices @ [1, 0, 0], 0, 2)[:, None] * [1, 0, 0], axis=1)
    assert np.abs(from_axis - 0.5).max() < 0.01


@pytest.mark.parametrize(("sides", "genus"), [(3, 1), (5, 1)])
def test_a_solid_around_a_polygon_has_its_loop(sides, genus):
    angle = 2 * np.pi * np.arange(sides) / sides
    points = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    edges = np.stack([np.arange(sides), (np.arange(sides) + 1) % sides], axis=1)
    mesh = shapes.solid_around(points, edges, np.full(sides, 0.2), 0.08)
    assert_closed_manifold(mesh)
    assert euler(mesh) == 2 - 2 * genus and mesh.volume > 0


# Machined parts, and rings


def polygon_area(radius: float, sides: int) -> float:
    return sides / 2 * np.sin(2 * np.pi / sides) * radius**2


def genus_of(mesh: trimesh.Trimesh) -> list[int]:
    """Of each component, which needs no repair."""
    assert_closed_manifold(mesh)
    checked = checking.prepare(mesh)
    assert checked.repairs == ()
    return [component.genus for component in checked.components]


@pytest.mark.parametrize("num_holes", [0, 1, 2, 4, 9, 16])
def test_a_plate_has_its_holes(num_holes):
    mesh = shapes.plate(num_holes)
    assert genus_of(mesh) == [num_holes] and len(mesh.vertices) == 2 * (4 + 32 * num_holes)
    cells = {0: 6.0, 1: 6.0, 2: 5.0, 4: 3.0, 9: 2.0, 16: 2.0 / 1.2}[num_holes]
    holes = num_holes * polygon_area(0.2 * cells, 32)
    assert mesh.volume == pytest.approx(60 - holes, rel=1e-6)
    np.testing.assert_allclose(mesh.bounds, [[0, 0, 0], [10, 6, 1]])


@pytest.mark.parametrize("wall", [0.5, 0.1, 0.02])
def test_a_pipe_has_its_wall(wall):
    mesh = shapes.pipe(wall)
    assert genus_of(mesh) == [1] and len(mesh.vertices) == 4 * 48
    assert mesh.volume == pytest.approx(4 * (polygon_area(1, 48) - polygon_area(1 - wall, 48)), rel=1e-5)


@pytest.mark.parametrize("num_holes", [0, 1, 4, 5, 8])
def test_a_bracket_has_its_holes(num_holes):
    mesh = shapes.bracket(num_holes)
    assert genus_of(mesh) == [num_holes]
    plates = 2 * 6 * 4 * 0.5 - 0.5 * 0.5 * 4
    assert mesh.volume == pytest.approx(plates - num_holes * 0.5 * polygon_area(0.4, 32), rel=1e-6)


def test_long_edges_of_a_part_are_cut_and_the_solid_stays():
    coarse, fine = shapes.plate(2), shapes.plate(2, 0.6)
    assert genus_of(fine) == [2] and fine.edges_unique_length.max() <= 0.6 < coarse.edges_unique_length.max()
    assert fine.volume == pytest.approx(coarse.volume)


@pytest.mark.parametrize("are_linked", [True, False])
def test_two_rings_are_apart_and_their_curves_in_their_middle(are_linked):
    mesh, (points, edges) = shapes.rings(are_linked, minor=0.3), shapes.ring_curves(are_linked)
    assert genus_of(mesh) == [1, 1]
    away = np.linalg.norm(points[:48, None] - points[48:], axis=2).min()
    assert away > 0.99  # more than two radii of a tube: the rings do not touch
    np.testing.assert_allclose(np.linalg.norm(mesh.vertices[:, None] - points, axis=2).min(axis=1), 0.3, atol=0.01)
    assert len(edges) == len(points) == 96
