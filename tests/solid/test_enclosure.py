"""Inside or outside, and how far from the surface: against plain solid angles, brute force and closed forms."""

import numpy as np
import pytest
import trimesh
from conftest import blob, torus

from msf_jax.solid.enclosure import Enclosure


def arrays(mesh: trimesh.Trimesh) -> tuple[np.ndarray, np.ndarray]:
    """Plain arrays of a Trimesh."""
    return np.array(mesh.vertices), np.array(mesh.faces)


def solid_angle_winding(points: np.ndarray, vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Generalised winding numbers: signed solid angles (Van Oosterom and Strackee 1983) over 4 pi, all pairs."""
    a, b, c = (vertices[faces[:, k]][None] - points[:, None] for k in range(3))
    la, lb, lc = (np.linalg.norm(v, axis=2) for v in (a, b, c))
    determinant = np.einsum("pfi,pfi->pf", a, np.cross(b, c))
    dot = [np.einsum("pfi,pfi->pf", u, v) for u, v in ((a, b), (b, c), (c, a))]
    angle = 2 * np.arctan2(determinant, la * lb * lc + dot[0] * lc + dot[1] * la + dot[2] * lb)
    return angle.sum(axis=1) / (4 * np.pi)


def assert_winding(points: np.ndarray, vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """The package's winding numbers, which equal the solid angles' at ``points``."""
    expected = solid_angle_winding(points, vertices, faces)
    assert np.abs(expected - np.round(expected)).max() < 1e-6, "a point of the test lies on the surface"
    found = Enclosure(vertices, faces).winding_numbers(points)
    np.testing.assert_array_equal(found, np.round(expected).astype(int))
    return found


def crossed() -> trimesh.Trimesh:
    """Two balls that overlap, the second inside out: windings 1, 0 in the overlap, and -1."""
    one, two = trimesh.creation.icosphere(2), trimesh.creation.icosphere(2).apply_translation([0.9, 0.03, 0.02])
    two.invert()
    return trimesh.util.concatenate([one, two])


def doubled() -> trimesh.Trimesh:
    """Two balls that overlap: winding 2 where they do."""
    one, two = trimesh.creation.icosphere(2), trimesh.creation.icosphere(2).apply_translation([0.9, 0.03, 0.02])
    return trimesh.util.concatenate([one, two])


SHAPES = {"blob": lambda: blob(21), "torus": torus, "crossed": crossed, "doubled": doubled}


# Inside or outside


@pytest.mark.parametrize("name", SHAPES)
def test_winding_numbers_equal_the_solid_angles(name):
    vertices, faces = arrays(SHAPES[name]())
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    points = np.random.default_rng(1).uniform(low - 0.3, high + 0.3, (600, 3))
    found = assert_winding(points, vertices, faces)
    expected_values = {"blob": {0, 1}, "torus": {0, 1}, "crossed": {-1, 0, 1}, "doubled": {0, 1, 2}}[name]
    assert set(found.tolist()) == expected_values
    np.testing.assert_array_equal(Enclosure(vertices, faces).contains(points), found > 0)


def test_an_inverted_surface_winds_the_other_way():
    vertices, faces = arrays(torus())
    points = np.random.default_rng(2).uniform(-1.3, 1.3, (300, 3)) * [1, 1, 0.3]
    forth = Enclosure(vertices, faces).winding_numbers(points)
    back = Enclosure(vertices, faces[:, ::-1]).winding_numbers(points)
    np.testing.assert_array_equal(forth, -back)
    assert forth.any() and not Enclosure(vertices, faces[:, ::-1]).contains(points).any()


@pytest.mark.parametrize("seed", range(4))
def test_rays_through_edges_count_once_however_the_vertices_are_numbered(seed):
    """Points below the middle of every upper edge of a polyhedron with dyadic coordinates."""
    mesh = trimesh.creation.icosphere(1)
    vertices, faces = np.round(np.array(mesh.vertices) * 64) / 64, np.array(mesh.faces)
    number = np.random.default_rng(seed).permutation(len(vertices))
    vertices, faces = vertices[np.argsort(number)], number[faces]
    edges = np.unique(np.sort(np.concatenate([faces[:, :2], faces[:, 1:]]), axis=1), axis=0)
    # Edges whose middle is above no vertex: only the edge itself is met exactly.
    points = vertices[edges].mean(axis=1)
    is_generic = ~(points[:, None, :2] == vertices[None, :, :2]).all(axis=2).any(axis=1)
    points = (points * [1, 1, 0.5])[is_generic & (points[:, 2] > 0.1)]
    # Under the silhouette a point may lie outside, which the solid angle knows, or on a vertical face.
    points = points[brute_force(points, vertices, faces) > 1e-3]
    assert len(points) > 20
    assert_winding(points, vertices, faces)


@pytest.mark.parametrize("offset", [0.0, 1e3])
def test_winding_numbers_far_from_the_origin(offset):
    vertices, faces = arrays(blob(23, 2))
    points = np.random.default_rng(5).uniform(-1, 1, (200, 3))
    here = solid_angle_winding(points, vertices, faces)
    found = Enclosure(vertices + offset, faces).winding_numbers(points + offset)
    np.testing.assert_array_equal(found, np.round(here).astype(int))


# How far


def brute_force(points: np.ndarray, vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Distance to the nearest of all triangles, by trimesh's closest point on a triangle, one point at a time."""
    triangles = vertices[faces]
    return np.array(
        [
            np.linalg.norm(
                trimesh.triangles.closest_point(triangles, np.tile(point, (len(triangles), 1))) - point, axis=1
            ).min()
            for point in points
        ]
    )


def with_large_faces() -> trimesh.Trimesh:
    """A fine ball beside a box of twelve large triangles: sizes that differ by a hundred."""
    return trimesh.util.concatenate([blob(25), trimesh.creation.box([40.0, 30, 20]).apply_translation([30, 0, 0])])


@pytest.mark.parametrize("name", ["blob", "torus", "large and small"])
def test_distances_equal_brute_force(name):
    vertices, faces = arrays(with_large_faces() if name == "large and small" else SHAPES[name]())
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    points = np.random.default_rng(7).uniform(low - 0.5, high + 0.5, (150, 3))
    found = Enclosure(vertices, faces).distances(points)
    np.testing.assert_allclose(found, brute_force(points, vertices, faces), rtol=1e-10, atol=1e-12)


def test_distances_to_a_box():
    """Outside: the length of the excess over each half side; inside: the least of what is missing."""
    half = np.array([3.0, 2.0, 0.5])
    vertices, faces = arrays(trimesh.creation.box(2 * half))
    points = np.random.default_rng(8).uniform(-5, 5, (3000, 3)) * [1, 0.8, 0.3]
    excess = np.abs(points) - half
    expected = np.where((excess < 0).all(axis=1), -excess.max(axis=1), np.linalg.norm(np.maximum(excess, 0), axis=1))
    found = Enclosure(vertices, faces).distances(points)
    np.testing.assert_allclose(found, expected, rtol=1e-12, atol=1e-12)
    assert (excess < 0).all(axis=1).sum() > 50


def test_slivers_in_a_surface_do_not_disturb_its_distances():
    """A box with a vertex in the middle of an edge, so that two faces have no area."""
    half = 0.5
    vertices, faces = arrays(trimesh.creation.box())
    a, b = vertices[faces[0, 0]], vertices[faces[0, 1]]
    vertices = np.concatenate([vertices, [(a + b) / 2]])
    flat = np.array([[faces[0, 0], faces[0, 1], 8], [faces[0, 1], faces[0, 0], 8]])
    points = np.random.default_rng(12).uniform(-1, 1, (300, 3))
    excess = np.abs(points) - half
    expected = np.where((excess < 0).all(axis=1), -excess.max(axis=1), np.linalg.norm(np.maximum(excess, 0), axis=1))
    enclosure = Enclosure(vertices, np.concatenate([faces, flat]))
    np.testing.assert_allclose(enclosure.distances(points), expected, rtol=1e-12, atol=1e-12)
    np.testing.assert_array_equal(enclosure.contains(points), (excess < 0).all(axis=1))


@pytest.mark.parametrize("subdivisions", [0, 1, 2])
def test_rays_through_vertices_count_once(subdivisions):
    """Points exactly below, between and above the vertices of a ball."""
    vertices, faces = arrays(trimesh.creation.icosphere(subdivisions))
    points = np.concatenate([vertices * [1, 1, height] for height in (0.5, -0.3, 3, -3)])
    points = points[brute_force(points, vertices, faces) > 1e-3]
    assert_winding(points, vertices, faces)


def test_rays_through_the_vertices_and_edges_of_a_box():
    """A box cut into small triangles, and points on its own grid, also exactly below and above its walls."""
    vertices, faces = arrays(trimesh.creation.box().subdivide().subdivide())
    place = np.arange(-6, 7) / 8
    points = np.stack(np.meshgrid(place, place, [-2, -0.3, 0.3, 2], indexing="ij"), axis=-1).reshape(-1, 3)
    is_inside = (np.abs(points) < 0.5).all(axis=1)
    is_on = (np.abs(points) <= 0.5).all(axis=1) & ~is_inside
    found = Enclosure(vertices, faces).winding_numbers(points[~is_on])
    np.testing.assert_array_equal(found, is_inside[~is_on])


def test_vertices_of_no_face_are_no_surface():
    """Points near one are as far from the surface, and near the same triangles, as if it were not there."""
    vertices, faces = arrays(trimesh.creation.icosphere(2))
    points = np.array([[0.2, 0.1, 0.3], [0.9, 0.0, 0.1], [1.5, 1.5, 1.5]])
    with_strays = Enclosure(np.concatenate([points, vertices]), faces + len(points))
    found, expected = (each.nearest(points) for each in (with_strays, Enclosure(vertices, faces)))
    np.testing.assert_array_equal(found, expected)
