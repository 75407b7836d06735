"""Distances to triangles, and the tree of their boxes, against NumPy, on points and triangles that coincide."""

import numpy as np
import pytest
import trimesh
from hypothesis import given, settings
from hypothesis import strategies as st

from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.kernels import tree_of

lattice = st.integers(-2, 2).map(float)  # few values, so that points coincide, and lie on lines, edges and faces


point = st.tuples(lattice, lattice, lattice)


def distance2_in_numpy(point: np.ndarray, triangle: np.ndarray) -> np.ndarray:
    """Squared distance (c,) from each point to each triangle, by masks, to the same bits."""
    best = np.full(len(point), np.inf)
    for k in range(3):  # to the three edges
        a, b = triangle[:, k], triangle[:, (k + 1) % 3]
        along, offset = b - a, point - a
        length2 = np.einsum("ij,ij->i", along, along)
        t = np.einsum("ij,ij->i", offset, along) / np.where(length2 > 0, length2, 1.0)
        rest = offset - np.clip(t, 0.0, 1.0)[:, None] * along
        best = np.minimum(best, np.einsum("ij,ij->i", rest, rest))
    # To the plane, where the foot of the perpendicular lies in the triangle.
    a, ab, ac = triangle[:, 0], triangle[:, 1] - triangle[:, 0], triangle[:, 2] - triangle[:, 0]
    normal, offset = np.cross(ab, ac), point - a
    area2 = np.einsum("ij,ij->i", normal, normal)
    safe = np.where(area2 > 0, area2, 1.0)
    v = np.einsum("ij,ij->i", np.cross(offset, ac), normal) / safe
    w = np.einsum("ij,ij->i", np.cross(ab, offset), normal) / safe
    is_over = (v >= 0) & (w >= 0) & (v + w <= 1) & (area2 > 0)
    return np.where(is_over, np.minimum(best, np.einsum("ij,ij->i", offset, normal) ** 2 / safe), best)


@given(st.lists(point, min_size=3, max_size=8), st.data())
@settings(deadline=None, max_examples=60)
def test_the_nearest_triangle_is_the_first_of_the_nearest(corners, data):
    """Any soup of triangles, degenerate, coincident and symmetric ones, and points as far from one as from another."""
    vertices = np.array(corners)
    corner = st.integers(0, len(vertices) - 1)
    faces = np.array(data.draw(st.lists(st.tuples(corner, corner, corner), min_size=1, max_size=9)))
    points = np.array(data.draw(st.lists(point, min_size=1, max_size=9)))
    triangles = vertices[faces]
    away = np.stack([distance2_in_numpy(np.tile(row, (len(faces), 1)), triangles) for row in points])
    if np.ptp(vertices, axis=0).max() > 0:  # samples of the surface need an extent
        distance, triangle = Enclosure(vertices, faces).nearest(points)
        np.testing.assert_array_equal(distance, np.sqrt(away.min(axis=1)))
        np.testing.assert_array_equal(triangle, away.argmin(axis=1))


@pytest.mark.parametrize("num", [1, 2, 3, 5, 8, 13, 100])
def test_every_box_of_the_tree_holds_those_below_it(num):
    low = np.random.default_rng(num).normal(size=(num, 3))
    found, order = tree_of(low, low + 0.1)
    assert sorted(order.tolist()) == list(range(num))
    np.testing.assert_array_equal(found[num:], np.concatenate([low, low + 0.1], axis=1)[order])
    for node in range(1, num):
        below = found[[2 * node, 2 * node + 1]]
        np.testing.assert_array_equal(found[node], np.r_[below[:, :3].min(axis=0), below[:, 3:].max(axis=0)])


def test_points_on_the_rim_of_a_face_and_rays_along_one():
    """Heights of a box that are those of its walls and edges: rays along faces, through edges, and from the surface."""
    shape = Enclosure(*(np.array(part) for part in (trimesh.creation.box().vertices, trimesh.creation.box().faces)))
    place = np.array([-0.5, -0.25, 0.0, 0.25, 0.5])
    points = np.stack(np.meshgrid(place, place, place, indexing="ij"), axis=-1).reshape(-1, 3)
    for axis in np.concatenate([np.eye(3), -np.eye(3)]):
        found = shape.ray_lengths(points, np.tile(axis, (len(points), 1)), np.full(len(points), 3.0))
        is_inner = (np.abs(points[:, axis == 0]) < 0.5).all(axis=1) & (points @ axis < 0.5) & (points @ axis > -0.5)
        np.testing.assert_allclose(found[is_inner], 0.5 - points[is_inner] @ axis, rtol=1e-12)
    distance, triangle = shape.nearest(points)
    is_on = np.abs(points).max(axis=1) == 0.5
    np.testing.assert_array_equal(distance == 0, is_on)
    corners = shape.triangles[triangle[is_on]]
    assert ((points[is_on] >= corners.min(axis=1)) & (points[is_on] <= corners.max(axis=1))).all()
