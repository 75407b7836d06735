"""Ends of limbs: closed forms of the mean exit time, axes of solids with one branch, and blind holes."""

import itertools

import numpy as np
import pytest
import trimesh
from hypothesis import given, settings
from hypothesis import strategies as st
from limb_cases import as_shape, box, i_beam, round_bar
from manifold3d import Manifold
from scipy.spatial.transform import Rotation

import msf_jax
from msf_jax.limbs import ends, one_branch
from msf_jax.limbs.tree import LimbTree
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import triangle_areas


def ends_of(shape: Enclosure) -> np.ndarray:
    """(n, 3) the ends of its limbs, the one with the least x first."""
    tree = LimbTree(shape)
    limbs = tree.limbs(0.5, 0.5)
    found = [tree.axis(shape, limbs, number).places[0] for number in range(len(limbs.limbs))]
    return np.array(sorted(found, key=tuple)).reshape(-1, 3)


def lathed(profile: list, step: float = 0.05, sections: int = 48) -> Enclosure:
    """The solid of revolution of a profile of (radius, height) from the axis to the axis, with a ring every ``step``,
    and another one at each corner; the axis is z."""
    points = [np.array(profile[:1], dtype=float)]
    for a, b in itertools.pairwise(profile):
        num = max(1, round(float(np.linalg.norm(np.subtract(b, a))) / step))
        points.append(np.linspace(a, b, num + 1)[1:])
    mesh = trimesh.creation.revolve(np.concatenate(points), sections=sections)
    return Enclosure(np.array(mesh.vertices), np.array(mesh.faces))


def exit_time(shape: Enclosure, owner: np.ndarray) -> np.ndarray:
    return ends.exit_times(shape.vertices, shape.faces, owner.astype(np.int64))


@pytest.mark.parametrize(("degrees", "sides"), [(45, 64), (60, 4)])
def test_a_limb_that_is_cut_off_obliquely_ends_on_its_axis(degrees, sides):
    """Its rings lead to the acute edge."""
    angle = np.radians(degrees)
    rod = Manifold.cylinder(10, 1, 1, sides).trim_by_plane((-np.sin(angle), 0, -np.cos(angle)), -8 * np.cos(angle))
    found = rod.refine_to_length(0.35).to_mesh()
    shape = Enclosure(found.vert_properties[:, :3].astype(float), found.tri_verts.astype(np.int64))
    assert np.abs(ends_of(shape)[:, :2]).max() < 0.06


def test_a_laplacian_has_the_cotangents_of_a_triangle():
    """Half of a square of side 2: the cotangents are 0 at the right angle and 1 at the others."""
    matrix, share = ends.laplacian(np.array([[0.0, 0, 0], [2, 0, 0], [0, 2, 0]]), np.array([[0, 1, 2]]))
    np.testing.assert_allclose(matrix.toarray(), [[1, -0.5, -0.5], [-0.5, 0.5, 0], [-0.5, 0, 0.5]], atol=1e-15)
    np.testing.assert_allclose(share, 2 / 3)


def test_a_laplacian_is_the_energy_of_gradients():
    """x^T L x is the integral of the squared gradient of x, which is linear on each triangle."""
    rng = np.random.default_rng(2)
    mesh = trimesh.creation.icosphere(2)
    x = np.array(mesh.vertices) + rng.normal(0, 0.03, mesh.vertices.shape)
    matrix, share = ends.laplacian(x, mesh.faces)
    value, energy = rng.normal(size=len(x)), 0.0
    for corners, own in zip(x[mesh.faces], value[mesh.faces], strict=True):
        sides = corners[1:] - corners[0]
        gradient = np.linalg.pinv(sides) @ (own[1:] - own[0])
        energy += np.linalg.norm(np.cross(*sides)) / 2 * gradient @ gradient
    assert value @ (matrix @ value) == pytest.approx(energy, rel=1e-12)
    assert np.abs(matrix.sum(axis=1)).max() < 1e-12 and abs(matrix - matrix.T).max() == 0
    assert share.sum() == pytest.approx(triangle_areas(x[mesh.faces]).sum())


def test_the_mean_exit_time_of_a_wall_is_a_parabola():
    """-u'' = 1 between two bases at a distance of 2 L: (L^2 - z^2) / 2, exactly at the vertices of a regular mesh."""
    shape = lathed([(0, -2), (1, -2), (1, 2), (0, 2)], 0.25)
    z, wall = shape.vertices[:, 2], np.hypot(*shape.vertices[:, :2].T) > 0.99
    found = exit_time(shape, wall & (np.abs(z) < 1.99))
    np.testing.assert_allclose(found[wall], (4 - z[wall] ** 2) / 2, atol=1e-9)
    assert not found[~wall].any()


def test_each_part_sees_the_others_as_its_base():
    """Two halves of the wall: of one, the first ring of the other is the base."""
    shape = lathed([(0, -2), (1, -2), (1, 2), (0, 2)], 0.25)
    z, wall = shape.vertices[:, 2], np.hypot(*shape.vertices[:, :2].T) > 0.99
    found = exit_time(shape, np.where(wall & (np.abs(z) < 1.99), np.where(z > 0.01, 1, 2), 0))
    upper = wall & (z > 0.01)
    np.testing.assert_allclose(found[upper], (z * (2 - z) / 2)[upper], atol=1e-9)
    lower = wall & (z < 0.01)
    np.testing.assert_allclose(found[lower], ((z + 2) * (0.25 - z) / 2)[lower], atol=1e-9)
    assert not exit_time(shape, np.zeros(len(z))).any()


def test_the_mean_exit_time_of_a_tube_with_a_round_end():
    """What flows through a ring is the area beyond it. On the tube u' = R + s, with s from the half ball on; on that,
    u falls by -2 R^2 ln cos(angle / 2) from its top."""
    angle = np.linspace(np.pi / 2, 0, 33)
    shape = lathed([(0, -3), (1, -3), *zip(np.sin(angle), np.cos(angle), strict=True)], sections=96)
    z, top = shape.vertices[:, 2], shape.vertices[:, 2].argmax()
    found = exit_time(shape, z > -2.99)
    assert found[top] == pytest.approx(np.log(2) + 3 + 4.5, rel=5e-3)
    tube, ball = (z > -2.9) & (z < 0), z >= 0
    np.testing.assert_allclose(found[tube], 3 + z[tube] + (9 - z[tube] ** 2) / 2, rtol=5e-3)
    polar = np.arccos(np.clip(z[ball], -1, 1))
    np.testing.assert_allclose(found[top] - found[ball], -2 * np.log(np.cos(polar / 2)), atol=5e-3)


LONG = {
    "bar": (box(10, 4, 4), 2.0),
    "short bar": (box(7, 4, 4), 2.0),
    "short cylinder": (round_bar(3), 1.0),
    "beam": (box(16, 2, 1), 0.5),
    "cylinder": (round_bar(8), 1.0),
    "I-beam": (i_beam(12), 0.25),
    "slab": (box(8, 4, 0.4), 0.2),
}


@pytest.mark.parametrize(
    ("name", "edge"),
    [
        *((name, None) for name in ("bar", "beam", "short cylinder", "I-beam", "slab")),
        *((name, 0.4) for name in ("short cylinder", "slab")),
        *(pytest.param(name, 0.4, marks=pytest.mark.slow) for name in ("short bar", "cylinder", "I-beam")),
    ],
)
def test_an_end_is_on_the_axis_and_0_3_radii_before_the_surface(name, edge):
    """Whatever its triangles, of the solid as made and with short edges; in a sheet, too."""
    solid, radius = LONG[name]
    shape = as_shape(solid, edge)
    found = ends_of(shape)
    assert len(found) == 2
    half = shape.vertices[:, 0].max()
    # The slab as made is 1.5 thousandths of its width off: its half thickness is a fifteenth of that.
    assert np.abs(found[:, 1:]).max() < (0.05 if name == "slab" and edge is None else 0.03) * radius
    assert ((half - np.abs(found[:, 0])) / radius > 0.29).all()
    assert ((half - np.abs(found[:, 0])) / radius < 0.38).all()


TURN = Rotation.random(random_state=3)


def test_ends_turn_and_are_mirrored_with_the_solid():
    shape = as_shape(round_bar(6, 1.0, 0.5), 0.4)
    x, faces, found = shape.vertices, shape.faces, ends_of(shape)
    turned = ends_of(Enclosure(7.0 * TURN.apply(x), faces))
    np.testing.assert_allclose(np.array(sorted(TURN.inv().apply(turned) / 7.0, key=tuple)), found, atol=0.02)
    mirrored = ends_of(Enclosure(-x, faces[:, ::-1]))
    np.testing.assert_allclose(-mirrored[::-1], found, atol=0.02)


@pytest.mark.parametrize(("size", "gap"), [((2, 2, 2), 0.3), pytest.param((3, 3, 0.5), 0.075, marks=pytest.mark.slow)])
def test_a_cube_and_a_square_plate_have_a_straight_curve_from_face_to_face(size, gap):
    shape = as_shape(box(*size))
    skeleton = msf_jax.skeletonize((TURN.apply(shape.vertices), shape.faces))
    ends_at = TURN.inv().apply(skeleton.vertices[one_branch.leaves_of(skeleton.edges)])
    assert len(ends_at) == 2
    np.testing.assert_allclose(np.sort(np.abs(ends_at), axis=1), [[0, 0, size[0] / 2 - gap]] * 2, atol=0.04)


@settings(max_examples=2, deadline=None)
@given(st.integers(0, 1000), st.floats(1e-3, 1e3), st.booleans(), st.sampled_from(["short bar", "cylinder"]))
def test_a_solid_turned_scaled_and_mirrored_has_the_ends_of_the_solid(seed, scale, is_mirrored, name):
    shape = as_shape(LONG[name][0], 0.6)
    turn = scale * Rotation.random(random_state=seed).as_matrix() * (-1 if is_mirrored else 1)
    faces = shape.faces[:, ::-1] if is_mirrored else shape.faces
    found = ends_of(Enclosure(shape.vertices @ turn.T, faces)) @ np.linalg.inv(turn).T
    np.testing.assert_allclose(np.array(sorted(found, key=tuple)), ends_of(shape), atol=0.03)


def test_triangles_of_a_lid_in_a_line_have_exit_times():
    """Of a tetrahedron, an edge has a vertex in its middle on one side only, and a triangle without area between."""
    vertices = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0.5, 0, 0]])
    faces = np.array([[0, 2, 1], [0, 1, 4], [0, 4, 3], [4, 1, 3], [0, 3, 2], [1, 2, 3]])
    assert trimesh.Trimesh(vertices, faces, process=False).is_watertight
    time = ends.exit_times(vertices, faces, np.array([1, 1, 1, 0, 1]))
    plain = ends.exit_times(
        vertices[:4], np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]), np.array([1, 1, 1, 0])
    )
    np.testing.assert_allclose(time[:3], plain[:3], rtol=0.2)  # other triangles, so another discretisation
