"""Ends of limbs: closed forms of the mean exit time, axes of solids with one branch, and blind holes."""

import itertools

import manifold3d
import numpy as np
import pytest
import trimesh
from hypothesis import given, settings
from hypothesis import strategies as st
from limb_cases import Solid, as_shape, box, i_beam, round_bar
from scipy.spatial.transform import Rotation

import msf_jax
from msf_jax.limbs import ends, one_branch
from msf_jax.limbs.caps import Caps
from msf_jax.solid import sections
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import triangle_areas


def ends_of(shape: Enclosure) -> np.ndarray:
    """(n, 3) the ends of its limbs, the one with the least x first."""
    caps = Caps(shape)
    limbs = caps.limbs(0.9)
    found = [caps.axis(shape, limbs, number).places[0] for number in range(len(limbs.caps))]
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


def axis_of(shape: Enclosure, is_limb: np.ndarray) -> ends.LimbAxis:
    """The axis of the vertices of ``is_limb`` (V,)."""
    time = exit_time(shape, is_limb)
    return ends.axis(shape, shape.vertices, shape.faces, time, np.flatnonzero(is_limb))


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


@pytest.mark.parametrize("name", ["frustum", "cone"])
def test_a_limb_that_narrows_ends_on_its_axis(name):
    """`WIDEST`, `LEAST`: no ball fills the end of a cone, which is a point, and its curve goes near it, not to it."""
    low, high = 1.0, 0.5 if name == "frustum" else 0.0
    for edge in (None, 0.6):
        found = ends_of(as_shape(round_bar(6, low, high), edge))
        assert len(found) == 2 and np.abs(found[:, 1:]).max() < 0.03
        gap = 3.0 - np.abs(found[:, 0])
        assert 0.24 < gap[0] < 0.36  # 0.3 within a fifth: the largest ball that fills the cone's wide end is smaller
        assert (0.14 < gap[1] < 0.25) if name == "frustum" else (0.05 < gap[1] < 0.4)


@pytest.mark.parametrize(
    ("solid", "across"),
    [(box(2, 2, 2), 8.0), (Solid.sphere(1.0, 32), 2 * np.pi), (box(4, 4, 0.4), 8.8), (box(1.03, 1, 0.1), 2.2)],
)
def test_a_cube_a_ball_and_a_square_plate_are_halved_by_their_shortest_line(solid, across):
    """`EQUAL_EIGENVALUES`, `MOST_LINES`: not through corners, which takes 1.06 to 1.4 times as much."""
    shape = as_shape(solid, 0.2)
    value, is_long = ends.halves(TURN.apply(shape.vertices), shape.faces)
    assert not is_long
    assert ends.zero_line(shape.vertices, shape.faces, value) == pytest.approx(across, rel=0.01)
    for each in (shape.vertices[:, 0], shape.vertices[:, 0] + shape.vertices[:, 1]):
        assert ends.zero_line(shape.vertices, shape.faces, each + 1e-9) > 0.98 * across


@pytest.mark.parametrize(("size", "gap"), [((2, 2, 2), 0.3), pytest.param((3, 3, 0.5), 0.075, marks=pytest.mark.slow)])
def test_a_cube_and_a_square_plate_have_a_straight_curve_from_face_to_face(size, gap):
    shape = as_shape(box(*size))
    skeleton = msf_jax.skeletonize((TURN.apply(shape.vertices), shape.faces))
    ends_at = TURN.inv().apply(skeleton.vertices[one_branch.leaves_of(skeleton.edges)])
    assert len(ends_at) == 2
    np.testing.assert_allclose(np.sort(np.abs(ends_at), axis=1), [[0, 0, size[0] / 2 - gap]] * 2, atol=0.04)


@pytest.mark.parametrize(("solid", "turn"), [(box(3, 1, 1), 0.0), (round_bar(4), 30.0), (box(1.2, 1, 0.1), 70.0)])
def test_the_halves_of_a_long_solid_are_on_both_sides_of_its_middle(solid, turn):
    """`EQUAL_EIGENVALUES`: a plate of 1.2 : 1, too."""
    shape = as_shape(solid, 0.1)
    x = Rotation.from_euler("xyz", [turn] * 3, degrees=True).apply(shape.vertices)
    value, is_long = ends.halves(x, shape.faces)
    assert is_long
    along = shape.vertices[:, 0] * np.sign(value @ shape.vertices[:, 0])
    far = np.abs(along) > 0.1
    assert (np.sign(value) == np.sign(along))[far].all()


def test_rings_are_half_a_radius_apart():
    """`RING_SPACING`: of a long tube, whose width is its radius."""
    shape = as_shape(round_bar(20), 0.3)
    found = axis_of(shape, shape.vertices[:, 0] > -5)
    assert found.width == pytest.approx(1.0, rel=0.05)
    np.testing.assert_allclose(-np.diff(found.places[3:, 0]), 0.5, atol=0.05)


def test_a_flange_does_not_attract_the_end():
    """`HALF`: the cap's rings are in both flanges before they are around the beam."""
    shape = as_shape(i_beam(12), 0.3)
    for sign in (-1, 1):
        places = axis_of(shape, sign * shape.vertices[:, 0] > 0.2).places
        assert np.abs(places[:, 1:]).max() < 0.05


def cone_in_a_block(height: float) -> Enclosure:
    """A round block whose top is at 0, with a cone of radius 0.5 that sticks out, or goes in if it is negative."""
    return lathed([(0, -2), (2, -2), (2, 0), (0.5, 0), (0, height)])


@pytest.mark.parametrize("height", [1.0, -1.0])
def test_the_volume_of_a_cap_is_that_of_its_solid(height):
    """Closed by a fan, against a cone that is cut by a plane; negative for one that goes in, which is no limb."""
    shape = cone_in_a_block(height)
    tip = int(np.linalg.norm(shape.vertices - [0, 0, height], axis=1).argmin())
    rows, _ = Caps(shape).grown(tip, np.zeros(len(shape.vertices), dtype=np.int64))
    slant = np.hypot(0.5, 1.0)
    on_cone = rows[(rows[:, 1] > 0.3 * slant) & (rows[:, 1] < slant)]
    assert len(on_cone) > 10
    for slenderness, radius, *_, volume in on_cone:
        level = height * (1 - radius / slant)
        cone = trimesh.creation.revolve([(0, level), (0.5 * radius / slant, level), (0, height)], sections=48)
        assert volume == pytest.approx(np.sign(height) * abs(cone.volume), rel=1e-6)
        assert slenderness > 0.3 if height > 0 else slenderness == 0


def drilled(solid: Solid, at: tuple, radius: float, depth: float) -> Solid:
    """With a blind hole from the top."""
    top = solid.bounding_box()[5]
    whole = solid.to_mesh()
    mesh = trimesh.Trimesh(whole.vert_properties[:, :3], whole.tri_verts)
    drill = trimesh.creation.cylinder(radius, 2 * depth, sections=24).apply_translation([*at, top])
    found = trimesh.boolean.difference([mesh, drill], engine="manifold")
    return Solid(manifold3d.Mesh(np.array(found.vertices, dtype=np.float32), np.array(found.faces, dtype=np.uint32)))


HOLE = {
    "bar": (box(10, 3, 3), (0.7, 0.14), 0.77, 2.27),
    "bar, beside its end": (box(10, 3, 3), (3.4, 0.4), 0.64, 1.48),
    "cylinder": (round_bar(6), (1.94, 0.04), 0.3, 1.03),
    "plate": (box(4, 4, 1), (0.5, -0.7), 0.4, 0.6),
    "ring": (Solid.revolve(manifold3d.CrossSection.circle(0.6, 24).translate((2.0, 0)), 48), (2.0, 0.0), 0.25, 0.8),
}


@pytest.mark.parametrize(
    "name", [name if name in ("bar", "ring") else pytest.param(name, marks=pytest.mark.slow) for name in HOLE]
)
def test_a_blind_hole_is_no_limb_and_changes_no_end(name):
    """Wherever it crosses the axis; only the ball of an end beside it is smaller."""
    solid, at, radius, depth = HOLE[name]
    plain, other = as_shape(solid, 0.4), as_shape(drilled(solid, at, radius, depth), 0.4)
    found = [ends_of(shape) for shape in (plain, other)]
    assert len(found[0]) == len(found[1]) == (0 if name == "ring" else 2)
    half = plain.vertices[:, 2].max()
    # A square plate may have its ends at either pair of sides.
    across = found[0][:, [1, 0, 2]]
    turned = [found[0], *([across, across[::-1]] if name == "plate" else [])]
    assert min(np.linalg.norm(found[1] - each, axis=1).max(initial=0.0) for each in turned) < 0.3 * half


@settings(max_examples=2, deadline=None)
@given(st.floats(-0.7, 0.7), st.floats(-0.5, 0.5), st.floats(0.15, 0.55), st.floats(0.2, 0.8))
def test_a_blind_hole_anywhere_in_a_bar_is_no_limb(x, y, radius, depth):
    solid = box(10, 3, 3)
    found = ends_of(as_shape(drilled(solid, (5 * x, 1.5 * y), 0.8 * radius, 3 * depth), 0.4))
    assert len(found) == 2
    np.testing.assert_allclose(found, [[-4.55, 0, 0], [4.55, 0, 0]], atol=0.3 * 1.5)


@settings(max_examples=2, deadline=None)
@given(st.integers(0, 1000), st.floats(1e-3, 1e3), st.booleans(), st.sampled_from(["short bar", "cylinder"]))
def test_a_solid_turned_scaled_and_mirrored_has_the_ends_of_the_solid(seed, scale, is_mirrored, name):
    shape = as_shape(LONG[name][0], 0.6)
    turn = scale * Rotation.random(random_state=seed).as_matrix() * (-1 if is_mirrored else 1)
    faces = shape.faces[:, ::-1] if is_mirrored else shape.faces
    found = ends_of(Enclosure(shape.vertices @ turn.T, faces)) @ np.linalg.inv(turn).T
    np.testing.assert_allclose(np.array(sorted(found, key=tuple)), ends_of(shape), atol=0.03)


@pytest.mark.parametrize(("length", "sections", "rows", "seed"), [(60, 16, 6, 0), (60, 8, 6, 1), (200, 12, 8, 0)])
def test_a_limb_of_long_triangles_ends_on_its_axis(length, sections, rows, seed):
    """`LINE_ROUNDS`: where triangles are longer than the limb is wide, rings are bent, and some
    that are near its end lie on its side."""
    half = length / 2
    rings = [(1, z) for z in np.linspace(-half, half, rows)]
    mesh = trimesh.creation.revolve([(0, -half), *rings, (0, half)], sections=sections)
    x = np.array(mesh.vertices)[:, [2, 0, 1]]
    is_between = np.abs(x[:, 0]) < half - 1e-9
    x[is_between, 0] += 0.3 * length / (rows - 1) * np.random.default_rng(seed).uniform(-1, 1, is_between.sum())
    found = ends_of(Enclosure(x, np.array(mesh.faces)))
    np.testing.assert_allclose(found, [[0.3 - half, 0, 0], [half - 0.3, 0, 0]], atol=0.1)


@pytest.mark.parametrize("sides", [4, 12])
def test_a_long_rod_of_few_vertices_ends_on_its_axis(sides):
    """Rings crowd in a corner of its end, in a line, as those of a cone do."""
    turn = Rotation.random(rng=np.random.default_rng(5)).as_matrix()
    rod = Solid.cube((2, 2, 250)).translate((-1, -1, 0)) if sides == 4 else Solid.cylinder(250, 1, 1, sides)
    mesh = rod.to_mesh()
    found = msf_jax.skeletonize((np.array(mesh.vert_properties[:, :3], dtype=float) @ turn.T, np.array(mesh.tri_verts)))
    assert np.linalg.norm((found.vertices @ turn)[:, :2], axis=1).max() < 0.3


@pytest.mark.parametrize(("length", "thick", "wide"), [(3, 1, 1.2), (3, 0.8, 1.5), (2.5, 0.7, 1)])
def test_a_limb_with_a_foot_ends_at_its_toes(length, thick, wide):
    """`STEADY`: the foot's sections are flat, so their balls are smaller than those of the leg."""
    foot = Solid.cube((length + 1, 2 * wide, thick)).translate((-1, -wide, 0))
    body = Solid.cube((6, 6, 6), True).translate((0, 0, 10))
    found = ends_of(as_shape(Solid.cylinder(8, 1, 0.9, 32) + foot + body, 0.5))
    toes = found[found[:, 2] < 4]
    assert len(toes) == 1 and toes[0, 0] > length - 0.3 and abs(toes[0, 1]) < 0.1 and 0.1 < toes[0, 2] < thick - 0.1


def test_no_ball_fills_the_point_of_a_cone():
    """`WIDEST`, `LEAST`, `DEEP`: its balls are half as large as they are far from it. It ends where the ball is
    0.3 * 0.25 of the one three rings from the point at 0."""
    radius = 4 * np.tan(np.pi / 6)
    shape = as_shape(Solid.cylinder(4, radius, 0, 96).translate((0, 0, -4)), 0.2)
    middles = np.array([[0, 0, z] for z in (-0.3, -0.6, -0.9, -1.2, -1.5)])
    down, size = np.tile([0.0, 0.0, -1.0], (len(middles), 1)), -middles[:, 2] * np.tan(np.pi / 6)
    found = ends.to_end(shape, middles, down, 2 * np.pi * size, size, 2, 0.3, 0.9)
    assert np.abs(found[:, :2]).max() < 1e-9 and (np.diff(found[:, 2]) < 0).all()
    assert -found[0, 2] == pytest.approx(0.075 * 0.9, rel=0.25)


def test_a_ring_in_a_corner_of_a_plates_end_does_not_begin_its_curve():
    """`WHOLE` of the next one's length: it is oblique, and as large for its length as those around the plate."""
    shape = as_shape(box(8, 4, 0.6), 0.3)
    middles = np.array([[3.5, 0.8, 0], [3.0, 0, 0], [2.5, 0, 0], [2.0, 0, 0]])
    inward, perimeter = np.tile([-1.0, 0.0, 0.0], (len(middles), 1)), np.array([6.6, 9.2, 9.2, 9.2])
    found = ends.to_end(shape, middles, inward, perimeter, np.full(len(middles), 0.5), 0, 0.5, 1.5)
    assert np.abs(found[:, 1:]).max() < 0.01 and found[0, 0] == pytest.approx(4 - 0.09, abs=0.02)


@settings(max_examples=3, deadline=None)
@given(st.floats(1.5, 6), st.floats(1.5, 5), st.integers(0, 1000))
def test_a_cone_on_a_cylinder_ends_near_its_point(length, height, seed):
    """Its rings are shorter and shorter, though they go around it; its triangles are as long as it is."""
    solid = Solid.cylinder(length, 1, 1, 32).translate((0, 0, -length)) + Solid.cylinder(height, 1, 0, 32)
    shape, turn = as_shape(solid), Rotation.random(random_state=seed)
    found = turn.inv().apply(ends_of(Enclosure(turn.apply(shape.vertices), shape.faces)))
    found = found[found[:, 2].argsort()]
    assert len(found) == 2 and np.abs(found[:, :2]).max() < 0.1
    assert 0.25 < found[0, 2] + length < 0.4 and 0.01 < 1 - found[1, 2] / height < 0.1


def test_the_end_of_a_channel_is_not_beyond_it():
    """The middles of its rings are outside, and no line through them meets its end."""
    shape = as_shape(box(10, 3, 3) - box(12, 2.4, 3).translate((0, 0, 0.3)), 0.3)
    for sign in (-1, 1):
        places = axis_of(shape, sign * shape.vertices[:, 0] > 0.05).places
        assert 4 < sign * places[0, 0] <= 5 and np.abs(places[:, 1]).max() < 0.05


def test_a_bolt_with_a_socket_ends_on_its_axis():
    """Two rings of the underside of its head have one middle, and no line leads through them."""
    profile = [(0, -6.3), (0.63, -6.3), (0.63, 0), (1.25, 0), (1.25, 1), (0.52, 1), (0.52, 0.5), (0, 0.5)]
    found = ends_of(lathed(profile, 0.1))
    assert len(found) == 2 and np.abs(found[:, :2]).max() < 0.03
    assert sorted(found[:, 2]) == pytest.approx([-6.3 + 0.3 * 0.63, 0.3], abs=0.15)


def test_a_bar_of_triangles_as_long_as_a_quarter_of_it_ends_on_its_axis():
    """They are five hundred times as long as wide, and the first rings lie in a corner of the end."""
    mesh = trimesh.creation.box((1, 0.002, 0.002)).subdivide().subdivide()
    found = ends_of(Enclosure(np.array(mesh.vertices), np.array(mesh.faces)))
    assert found.shape == (2, 3) and np.abs(found[:, 1:]).max() < 1e-4
    np.testing.assert_allclose(np.abs(found[:, 0]), 0.5 - 0.3e-3, atol=1e-4)


def test_a_ring_does_not_go_to_the_middle_of_the_body_that_its_limb_stands_on():
    """The section along a rod and through its block is many times as large as the rod's ring."""
    rod = manifold3d.Manifold.cylinder(1.5, 0.2, 0.2, 32).translate((0, 0, 0.5))
    shape, place = as_shape(manifold3d.Manifold.cube((2, 2, 2), True) + rod, 0.2), [0.0, 0, 1.4]
    ring = sections.cut(shape, np.array([place]), np.array([[0.0, 0, 1]]), np.array([0.2]))
    along = sections.cut(shape, np.array([place]), np.array([[1.0, 0, 0]]), np.array([0.2]))
    assert along.is_around[0] and along.centroid[0, 2] < 0.5 and along.size[0] > 3 * ring.size[0]
    np.testing.assert_array_equal(ends.centred(shape, np.array([place]), np.array([1.0, 0, 0]), ring.size)[0], place)


@settings(max_examples=2, deadline=None)
@given(st.floats(0.4, 0.9), st.floats(1.8, 2.8), st.floats(0.3, 0.8), st.integers(0, 1000))
def test_a_nail_ends_on_its_axis_in_its_head(radius, head, height, seed):
    """The rings of the underside of its head have one middle, and no line leads through them."""
    shape = as_shape(Solid.cylinder(6, radius).translate((0, 0, -6)) + Solid.cylinder(height, head), 0.4)
    turn = Rotation.random(random_state=seed)
    found = turn.inv().apply(ends_of(Enclosure(turn.apply(shape.vertices), shape.faces)))
    found = found[found[:, 2].argsort()]
    assert len(found) == 2 and np.abs(found[:, :2]).max() < 0.1 * radius
    assert -6 < found[0, 2] < -6 + 0.5 * radius and 0 < found[1, 2] < height


@settings(max_examples=4, deadline=None)
@given(st.floats(1.5, 3.0), st.floats(0.6, 0.9), st.integers(0, 1000))
@pytest.mark.slow  # other holes are above and below
def test_a_bar_with_a_blind_hole_in_its_end_ends_at_the_floor_of_the_hole(depth, radius, seed):
    """Its rings begin at the floor, run out in the hole, and come back around the bar, with middles in the hole."""
    hole = Solid.cylinder(2 * depth, radius, radius, 24, True).rotate((0, 90, 0)).translate((4.5, 0, 0))
    shape = as_shape(box(9, 3, 3) - hole, 0.4)
    turn = Rotation.random(random_state=seed)
    found = turn.inv().apply(ends_of(Enclosure(turn.apply(shape.vertices), shape.faces)))
    found = found[found[:, 0].argsort()]
    assert len(found) == 2 and np.abs(found[:, 1:]).max() < 0.05
    assert found[0, 0] == pytest.approx(-4.5 + 0.3 * 1.5, abs=0.1)
    assert 4.5 - depth - 1.5 < found[1, 0] < 4.5 - depth


@settings(max_examples=3, deadline=None)
@given(st.floats(25, 40), st.floats(5.5, 6.5), st.integers(0, 1000))
def test_crossed_rods_end_on_their_axes(angle, length, seed):
    """`WHOLE`: the first rings can be in the rim of an end, where its triangles are as long as the rods."""
    rod = Solid.cylinder(2 * length, 0.7, 0.7, 32, True).rotate((90, 0, 0))
    shape = as_shape(rod.rotate((0, 0, 90 - angle)) + rod.rotate((0, 0, angle - 90)) + Solid.sphere(0.75, 32))
    turn = Rotation.random(random_state=seed)
    found = turn.inv().apply(ends_of(Enclosure(turn.apply(shape.vertices), shape.faces)))
    ways = [(i * np.cos(np.radians(angle)), j * np.sin(np.radians(angle)), 0) for i in (-1, 1) for j in (-1, 1)]
    away = np.linalg.norm(found[:, None] - (length - 0.21) * np.array(ways), axis=2)
    assert len(found) == 4 and away.min(axis=0).max() < 0.1 and away.min(axis=1).max() < 0.1


def test_a_limb_ends_in_front_of_a_hole_through_it():
    """Beside the hole its rings are in either wall."""
    bore = Solid.cylinder(4, 0.95, 0.95, 24, True).translate((2, 0, 0))
    shape = as_shape(box(12, 3, 3) - bore, 0.3)
    places = axis_of(shape, shape.vertices[:, 0] > -0.5).places
    assert np.abs(places[:, 1:]).max() < 0.05
    assert places[0, 0] == pytest.approx(6 - 0.3 * 1.5, abs=0.05) and places[-1, 0] > 2 + 0.95


@pytest.mark.parametrize(("solid", "angle"), [(round_bar(14), 50.0), (box(10, 2, 2), 45.0)])
def test_a_bar_that_is_cut_off_obliquely_ends_on_its_axis(solid, angle):
    """`ends._cut_off`: the middles of rings lead to the acute edge, the tangent of the angle ahead and one aside."""
    a = np.radians(angle)
    cut = solid.trim_by_plane((-np.cos(a), 0, -np.sin(a)), -2.0)
    for shape in (as_shape(cut), as_shape(cut, 0.5)):
        found = ends_of(shape)
        assert len(found) == 2 and np.abs(found[:, 1:]).max() < 0.1
        tip = found[found[:, 0].argmax(), 0] - 2.0 / np.cos(a)
        assert -0.7 < tip < 0.0  # 0.3 to 0.5 before the plane


@pytest.mark.parametrize("bend", [45.0, 60.0])
def test_a_short_arm_of_an_elbow_keeps_its_end(bend):
    """It leaves the tube of the long one, and its end is no plane across that: `NEAR`, `STEADY`."""
    a = np.radians(bend)
    arm = Solid.cylinder(2.5, 1, 1, 32).rotate((0, 90 - bend, 0))
    both = round_bar(12).translate((-6, 0, 0)) + Solid.sphere(1, 32) + arm
    found = ends_of(as_shape(both, 0.5))
    away = np.linalg.norm(found - (2.2 * np.cos(a), 0, 2.2 * np.sin(a)), axis=1)
    assert len(found) == 2 and away.min() < 0.3


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


def along_z(places: list) -> np.ndarray:
    return np.array([(x, y, z) for x, y, z in places], dtype=float)


def test_uneven_rings_of_a_flange_lead_to_the_middle_of_its_end():
    """Rings on the underside of a flange crowd, and their middles are a little aside. Across the line through two of
    them the section of the flange is oblique, with its middle far aside; a ring a radius on shows the axis."""
    body = Solid.cylinder(9, 0.8, 0.8, 32) + box(3, 3, 0.7).translate((0, 0, 0.35))
    deep = [(0, 0, 0.93), (0, 0, 1.24), (0, 0, 1.58), (0, 0, 1.95), (0, 0, 2.33)]
    middles = along_z([(0, 0, 0.1), (-0.01, 0.01, 0.65), (-0.02, 0.02, 0.7), (-0.02, 0.03, 0.7), *deep])
    perimeter = np.array([12.08, 10.61, 7.81, 5.57, 5.03, 5.03, 5.03, 5.03, 5.03])
    size = np.array([1.51, 1.58, 1.23, 0.88, 0.8, 0.8, 0.8, 0.8, 0.8])
    places = ends.to_end(as_shape(body), middles, np.tile([0.0, 0, 1], (9, 1)), perimeter, size, 1, 0.4, 1.4)
    assert np.linalg.norm(places[0, :2]) < 0.05 and 0.1 < places[0, 2] < 0.4


def test_a_shaft_before_a_cam_is_not_cut_off_obliquely():
    """`WHOLE`: the length of rings jumps where the cam begins; towards an acute edge it falls step by step."""
    cam = Solid.cylinder(1.2, 1.25, 1.25, 32).translate((0.45, 0, 2.5))
    shape = as_shape(Solid.cylinder(14, 0.8, 0.8, 32) + cam, 0.3)
    rings = along_z([*((0, 0, z) for z in (0.05, 0.2, 0.75, 1.25, 1.75, 2.3)), (0.45, 0, 2.55), (0.45, 0, 3.2)])
    length = np.array([2.2, 5.0, 5.0, 5.0, 5.0, 5.0, 7.7, 7.9])
    near = (shape.vertices[shape.faces, 2] < 4).all(axis=1)
    assert ends._cut_off(shape.vertices, shape.faces[near], shape.vertices[:, 2], rings, length, 0.5) == 0
