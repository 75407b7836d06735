"""Rays and nearest triangles of a surface: against every triangle, one formula at a time."""

import numpy as np
import pytest
import trimesh
from conftest import blob
from scipy.spatial.transform import Rotation
from solid_cases import SHAPES, arrays

from msf_jax.solid.enclosure import Enclosure


@pytest.fixture(scope="module", params=SHAPES)
def shape(request) -> Enclosure:
    return Enclosure(*arrays(SHAPES[request.param]()))


def random_directions(random: np.random.Generator, num: int) -> np.ndarray:
    """Unit vectors (num, 3), evenly in all rays."""
    rays = random.normal(size=(num, 3))
    return rays / np.linalg.norm(rays, axis=1)[:, None]


def random_points(shape: Enclosure, random: np.random.Generator, num: int) -> np.ndarray:
    """Points (num, 3) in the bounding box, and a little beyond; half of them around the small triangles."""
    low, high = shape.vertices.min(axis=0), shape.vertices.max(axis=0)
    points = random.uniform(low - 0.2, high + 0.2, (num, 3))
    points[::2] = random.uniform(-1.1, 1.1, (len(points[::2]), 3))
    return points


def moeller_trumbore(points: np.ndarray, rays: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """(P,) how far each ray goes to the first of all triangles; infinite where it meets none."""
    first = np.full(len(points), np.inf)
    ab, ac = triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]
    for row, (point, ray) in enumerate(zip(points, rays, strict=True)):
        p = np.cross(ray, ac)
        determinant = (ab * p).sum(axis=1)
        offset = point - triangles[:, 0]
        u = (offset * p).sum(axis=1) / determinant
        q = np.cross(offset, ab)
        v, t = q @ ray / determinant, (q * ac).sum(axis=1) / determinant
        is_hit = (u >= 0) & (v >= 0) & (u + v <= 1) & (t >= 0)
        first[row] = t[is_hit].min(initial=np.inf)
    return first


def test_rays_go_as_far_as_the_nearest_of_all_triangles(shape):
    """With reaches from far less than the ray to the surface to far more."""
    random, num = np.random.default_rng(1), 250
    points, rays = random_points(shape, random, num), random_directions(random, num)
    first = moeller_trumbore(points, rays, shape.triangles)
    reach = np.where(np.isfinite(first), first, 1.0) * random.uniform(0.2, 4, num)
    found = shape.ray_lengths(points, rays, reach)
    np.testing.assert_allclose(found, np.minimum(first, reach), rtol=1e-9)
    assert (found == reach).sum() > 50 and (found < reach).sum() > 40 and np.isinf(first).sum() > 10


def test_a_ray_ends_at_its_reach():
    """From the middle of a box, whose side is one half away."""
    shape = Enclosure(*arrays(trimesh.creation.box()))
    reach = np.array([0.0, 0.3, 0.4999, 0.5, 0.5001, 7.0])
    rays = np.tile([0, 0.6, 0.8], (6, 1))
    found = shape.ray_lengths(np.zeros((6, 3)), np.tile([1.0, 0, 0], (6, 1)), reach)
    np.testing.assert_allclose(found, np.minimum(reach, 0.5), rtol=1e-12)
    np.testing.assert_allclose(shape.ray_lengths(np.zeros((6, 3)), rays, reach), np.minimum(reach, 0.625), rtol=1e-12)


@pytest.mark.parametrize("inverted", [False, True])
def test_rays_stop_on_either_side_of_a_triangle(inverted):
    vertices, faces = arrays(blob(64, 2))
    shape = Enclosure(vertices, faces[:, ::-1] if inverted else faces)
    random = np.random.default_rng(3)
    rays = random_directions(random, 50)
    out = shape.ray_lengths(np.zeros((50, 3)), rays, np.full(50, 10.0))
    back = shape.ray_lengths(10 * rays, -rays, np.full(50, 10.0))
    np.testing.assert_allclose(out, moeller_trumbore(np.zeros((50, 3)), rays, shape.triangles), rtol=1e-9)
    np.testing.assert_allclose(back, moeller_trumbore(10 * rays, -rays, shape.triangles), rtol=1e-9)


def turned_ball(seed: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Vertices and faces of a ball that lies along no axis, and a start for a ray to each of its vertices."""
    mesh = trimesh.creation.icosphere(2)
    vertices = np.array(mesh.vertices) @ Rotation.random(random_state=seed).as_matrix()
    return vertices, np.array(mesh.faces), np.random.default_rng(seed).uniform(-0.3, 0.3, vertices.shape)


def assert_rays_reach(shape: Enclosure, points: np.ndarray, targets: np.ndarray) -> None:
    """Rays from ``points`` end at ``targets``."""
    length = np.linalg.norm(targets - points, axis=1)
    found = shape.ray_lengths(points, (targets - points) / length[:, None], np.full(len(points), 4.0))
    np.testing.assert_allclose(found, length, rtol=1e-6)


@pytest.mark.parametrize("seed", range(5))
def test_no_ray_slips_out_between_two_triangles(seed):
    """From within, at points of the edges, as exactly as floats tell."""
    vertices, faces, points = turned_ball(seed)
    ends = vertices[faces[: len(points), :2]]
    share = np.random.default_rng(seed).uniform(0, 1, (len(points), 1))
    assert_rays_reach(Enclosure(vertices, faces), points, share * ends[:, 0] + (1 - share) * ends[:, 1])


def test_no_ray_slips_out_at_a_vertex():
    for seed in range(20):
        vertices, faces, points = turned_ball(seed)
        assert_rays_reach(Enclosure(vertices, faces), points, vertices)


def corner_piece() -> tuple[np.ndarray, np.ndarray]:
    """An L of height 1; the planes of its two inner walls go on into the solid."""
    outline = np.array([[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2.0]])
    vertices = np.concatenate([np.pad(outline, ((0, 0), (0, 1)), constant_values=z) for z in (0.0, 1.0)])
    floor = np.array([[1, 0, 3], [2, 1, 3], [3, 0, 5], [4, 3, 5]])
    i, j = np.arange(6), (np.arange(6) + 1) % 6
    walls = np.concatenate([np.stack([i, j, j + 6], axis=1), np.stack([i, j + 6, i + 6], axis=1)])
    return vertices, np.concatenate([floor, floor[:, ::-1] + 6, walls])


def test_rays_in_the_plane_of_a_wall_go_past_it():
    """The wall at x = 1 is in the ray's plane, exactly, and not on its way."""
    points, rays = np.tile([1.0, 0.5, 0.5], (4, 1)), np.array([[0.0, -1, 0], [0, 0, 1], [0, 0, -1], [-1, 0, 0]])
    np.testing.assert_array_equal(
        Enclosure(*corner_piece()).ray_lengths(points, rays, np.full(4, 3.0)), [0.5] * 3 + [1]
    )


def test_rays_in_the_plane_of_a_turned_wall_go_past_it():
    vertices, faces = corner_piece()
    points, rays = np.tile([1.0, 0.5, 0.5], (3, 1)), np.array([[0.0, -1, 0], [0, 0, 1], [0, 0, -1]])
    for seed in range(200):
        turn = Rotation.random(random_state=seed).as_matrix().T
        shift = np.random.default_rng(seed).normal(size=3)
        shape = Enclosure(vertices @ turn + shift, faces)
        np.testing.assert_allclose(shape.ray_lengths(points @ turn + shift, rays @ turn, np.full(3, 3.0)), 0.5)


def all_hits(point: np.ndarray, ray: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """How far along a ray each triangle is that it meets, in ascending order."""
    basis = np.stack(
        [triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0], -np.tile(ray, (len(triangles), 1))]
    )
    u, v, t = np.linalg.solve(np.moveaxis(basis, 0, 2), (point - triangles[:, 0])[..., None])[..., 0].T
    return np.sort(t[(u >= 0) & (v >= 0) & (u + v <= 1) & (t >= 0)])


def test_every_hit_of_a_ray_is_found(shape):
    """From within there is an odd number of them, where the surface does not cross itself."""
    random, num = np.random.default_rng(10), 120
    points, rays, reach = random_points(shape, random, num), random_directions(random, num), np.full(num, 80.0)
    reach[::3] = random.uniform(0, 2, len(reach[::3]))
    ray, _, distance, _ = shape.ray_hits(points, rays, reach)
    counts = []
    for row in range(num):
        expected = all_hits(points[row], rays[row], shape.triangles)
        np.testing.assert_allclose(np.sort(distance[ray == row]), expected[expected <= reach[row]], rtol=1e-9)
        counts.append(len(expected))
    np.testing.assert_array_equal(shape.winding_numbers(points) % 2, np.array(counts) % 2)
    assert set(counts) >= {0, 1, 2}


def distances_to_all(points: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """(P, F) distance from each point to each triangle, by trimesh, one point at a time."""
    return np.stack(
        [
            np.linalg.norm(
                trimesh.triangles.closest_point(triangles, np.tile(point, (len(triangles), 1))) - point, axis=1
            )
            for point in points
        ]
    )


def test_the_nearest_triangle_is_at_the_least_of_all_distances(shape):
    points = random_points(shape, np.random.default_rng(6), 100)
    away = distances_to_all(points, shape.triangles)
    distance, triangle = shape.nearest(points)
    np.testing.assert_allclose(distance, away.min(axis=1), rtol=1e-9, atol=1e-12)
    np.testing.assert_allclose(away[np.arange(100), triangle], distance, rtol=1e-9, atol=1e-12)
    np.testing.assert_array_equal(shape.distances(points), distance)
    assert len(np.unique(triangle)) > 20


def test_the_nearest_triangle_of_a_vertex_is_one_of_its_own(shape):
    distance, triangle = shape.nearest(shape.vertices)
    assert (distance == 0).all()
    assert (shape.faces[triangle] == np.arange(len(shape.vertices))[:, None]).any(axis=1).all()


def test_a_corner_of_a_regular_solid_is_on_its_surface():
    """Every corner of an equilateral triangle is as far from its centroid as it reaches: a bound of 0 has no slack."""
    corners = np.array([[1.0, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]])
    faces = np.array([[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]])
    for size in np.arange(1, 200) / 100:
        shape = Enclosure(corners * size + [0.3, 0.7, 0.9], faces)
        np.testing.assert_array_equal(shape.nearest(shape.vertices)[0], 0.0)
