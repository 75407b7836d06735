"""The nearest of all triangles of a moved surface, and the side of it: beside distances and windings by NumPy."""

import functools

import jax
import numpy as np
import pytest
import trimesh
from conftest import blob, torus
from run_cases import flow_of

import msf_jax
from msf_jax.device import nearest
from msf_jax.solid.solid import Solid
from tests.benchmarks import ground_truth


def needle():
    """A tetrahedron with sharp corners, where the normal of a single face may point the wrong way."""
    corners = np.array([[0, 0, 0], [1, 0.02, 0], [1.1, 0.1, 0.03], [0.9, 0.05, 0.12]])
    faces = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
    return trimesh.Trimesh(corners, faces, process=False).subdivide().subdivide()


MAKERS = {
    "limbs": lambda: ground_truth.make("y_coarse").mesh,
    "parts": lambda: trimesh.util.concatenate([blob(4, 2), torus().apply_translation([4, 0, 0])]),
    "needle": needle,
}
SHEAR = np.array([[1, 0.8, 0], [0, 0.5, -0.6], [0.3, 0, 1.4]])
MOVES = {"rest": np.eye(3), "shear": SHEAR}


@functools.cache
def bound(name):
    """Vertices and faces of a shape, and a binding to it that every row is a node of."""
    mesh = MAKERS[name]()
    binding = (flow_of("y_coarse").skeleton if name == "limbs" else msf_jax.skeletonize(mesh)).binding
    rows = binding.rest.shape[0]
    live = binding.live._replace(nodes=np.asarray(rows, dtype=np.int32))
    return np.array(mesh.vertices), np.array(mesh.faces), binding._replace(live=live, side=np.ones(rows))


def about(vertices, num):
    """Points in and around a shape, most of them near its edges and corners."""
    random = np.random.default_rng(0)
    size = np.ptp(vertices, axis=0)
    near = vertices[random.integers(0, len(vertices), num)] + random.normal(0, 0.05, (num, 3)) * size
    low = vertices.min(axis=0) - 0.2 * size
    return np.where(random.random((num, 1)) < 0.7, near, low + 1.4 * size * random.random((num, 3)))


SLOW = pytest.mark.slow
signed = jax.jit(nearest.signed_distances)


@pytest.mark.parametrize("move", MOVES)
@pytest.mark.parametrize(
    "name", ["limbs", *(pytest.param(each, marks=pytest.mark.slow) for each in ("needle", "parts"))]
)
def test_distances_and_sides_are_those_of_the_moved_solid(name, move):
    vertices, faces, binding = bound(name)
    moved = vertices @ MOVES[move].T
    if np.linalg.det(MOVES[move]) < 0:
        moved = -moved
    points = about(moved, len(binding.rest))
    solid = Solid(moved, faces)
    expected = solid.diagonal * solid.shape.distances(solid.enter(points))
    is_inside = solid.shape.contains(solid.enter(points))
    assert 5 < is_inside.sum() < len(points) - 5
    rows = np.zeros((binding.capacity.vertices, 3))
    rows[: len(moved)] = moved
    found = np.asarray(signed(binding, points, rows))
    np.testing.assert_allclose(np.abs(found), expected, rtol=0, atol=1e-12 * solid.diagonal)
    is_clear = expected > 1e-9 * solid.diagonal
    np.testing.assert_array_equal((found > 0)[is_clear], is_inside[is_clear])


def test_slopes_are_those_of_the_nearest_triangle():
    """One unit along the normal, and against central differences."""
    vertices, _, binding = bound("limbs")
    moved = np.zeros((binding.capacity.vertices, 3))
    moved[: len(vertices)] = vertices
    points = about(vertices, len(binding.rest))
    total = jax.jit(jax.grad(lambda *given: nearest.signed_distances(*given).sum(), argnums=(1, 2)))
    slope = total(binding, points, moved)
    np.testing.assert_allclose(np.linalg.norm(slope[0], axis=1), 1, atol=1e-9)
    direction = np.random.default_rng(1).normal(size=points.shape)
    step = 1e-7
    ahead, behind = (np.asarray(signed(binding, points + sign * step * direction, moved)) for sign in (1, -1))
    np.testing.assert_allclose((ahead - behind) / (2 * step), (slope[0] * direction).sum(axis=1), atol=1e-5)
    np.testing.assert_allclose(
        slope[1].sum(axis=0), -slope[0].sum(axis=0), atol=1e-9
    )  # moved together, nothing changes


@pytest.mark.slow  # compiles three programs
def test_points_and_runs_are_looked_at_some_at_a_time(monkeypatch):
    """In blocks and windows of 8 as all together; each mesh of a batch as alone, though two lie on each other."""
    skeletons = [flow_of(name).skeleton for name in ("y_coarse", "straight_coarse", "y_coarse")]
    batch = msf_jax.stack(skeletons)
    points, vertices = np.array(batch.rest), np.array(batch.vertices)
    points[:] = about(vertices[np.asarray(batch.vertex_mask)], len(points))
    expected = np.asarray(nearest.nearest_faces(batch, points, vertices))
    parts = [msf_jax.stack([each]) for each in skeletons]
    start = np.cumsum([0, *batch.live.faces])
    for number, (part, rows) in enumerate(zip(parts, batch.split(points), strict=True)):
        own = np.zeros((len(part.rest), 3))
        own[: len(rows)] = rows
        alone = np.asarray(nearest.nearest_faces(part, own, part.vertices))[: len(rows)]
        np.testing.assert_array_equal(start[number] + alone, batch.split(expected)[number])
    for name in ("TOGETHER", "AT_ONCE"):
        monkeypatch.setattr(nearest, name, 8)
    np.testing.assert_array_equal(nearest.nearest_faces(batch, points, vertices), expected)


@pytest.mark.slow
def test_where_a_surface_runs_through_itself_sides_are_as_recorded():
    """Two bars that cross: in one the nearest wall may be the other's, seen from outside."""
    bars = [trimesh.creation.box([6, 1, 1]), trimesh.creation.box([1, 6, 0.9])]
    for bar in bars:
        while len(bar.vertices) < 150:
            bar.vertices, bar.faces = trimesh.remesh.subdivide(bar.vertices, bar.faces)
    mesh = trimesh.util.concatenate(bars)
    skeleton = msf_jax.skeletonize(mesh)
    assert (skeleton.binding.side == -1).any() and (skeleton.radii > 0).all()
    np.testing.assert_allclose(msf_jax.follow(skeleton, mesh.vertices).radii, skeleton.radii, atol=1e-12)
