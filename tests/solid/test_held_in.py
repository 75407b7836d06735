"""Middles of sections that are held in the material: known ones, halves of an area, and continuity."""

import manifold3d
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from msf_jax.solid import sections
from msf_jax.solid.enclosure import Enclosure

ARC = np.linspace(0, np.pi, 41)
HALF_PIPE = np.concatenate([r * np.stack([np.cos(ARC), np.sin(ARC)], 1)[::way] for r, way in ((2.0, 1), (1.5, -1))])


def angle(a: float, b: float, t: float) -> np.ndarray:
    """An angle of walls a and b, t thick, counterclockwise from its corner."""
    return np.array([[0, 0], [a, 0], [a, t], [t, t], [t, b], [0, b]], dtype=float)


def channel(a: float, h: float, t: float, web: float) -> np.ndarray:
    """A channel with flanges h high and t thick on a web, whose middle is at 0."""
    half = np.array([[a / 2, -web / 2], [a / 2, h], [a / 2 - t, h], [a / 2 - t, web / 2]])
    return np.concatenate([half, half[::-1] * [-1, 1]])


def extruded(profile: np.ndarray, length: float = 10.0) -> Enclosure:
    """Along z, from 0 on."""
    mesh = manifold3d.Manifold.extrude(manifold3d.CrossSection([profile]), length).to_mesh64()
    return Enclosure(np.array(mesh.vert_properties[:, :3]), np.array(mesh.tri_verts, dtype=np.int64))


def middle(profile: np.ndarray, normal=(0.0, 0.0, 1.0), turn=None) -> tuple[np.ndarray, sections.Sections]:
    """The middle (3,) of the section at z = 5 across ``normal``, in the frame of the profile, and the section as
    measured. The solid is turned by ``turn`` (3, 3)."""
    turn = np.eye(3) if turn is None else turn
    shape = extruded(profile)
    shape = Enclosure(shape.vertices @ turn.T, shape.faces)
    # Beside the first side, which is a wall of each profile.
    inward = np.array([profile[0, 1] - profile[1, 1], profile[1, 0] - profile[0, 0]])
    start = np.append(profile[:2].mean(axis=0) + 1e-3 * inward, 5.0)
    normals = (turn @ np.array(normal) / np.linalg.norm(normal))[None]
    points = (turn @ start)[None]
    found = sections.cut(shape, points, normals, np.array([1.0]))
    return sections.held_in(shape, normals, found).middle[0] @ turn, found


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("profile, expected", [
    (angle(3, 3, 0.8), (0.4, 0.4)),
    (angle(3, 3, 0.1), (0.05, 0.05)),
    (channel(3, 2.2, 0.6, 0.6), (0, 0)),
    (channel(3, 4, 0.2, 0.5), (0, 0)),
    (HALF_PIPE, (0, 1.75)),
])  # fmt: skip
def test_middles_are_the_corner_of_an_angle_the_web_of_a_channel_and_the_back_of_half_a_pipe(profile, expected, seed):
    turn = Rotation.random(rng=np.random.default_rng(seed)).as_matrix()
    found, plain = middle(profile, turn=turn)
    assert plain.is_around.all()
    assert np.linalg.norm(plain.centroid[0] @ turn - [*expected, 5]) > 0.3
    np.testing.assert_allclose(found, [*expected, 5], atol=2e-3)


@given(st.floats(2, 4), st.floats(2, 4), st.floats(0.2, 0.6))
@settings(max_examples=30, deadline=None)
def test_a_middle_is_in_the_wall_and_halves_the_area(a, b, t):
    """Where the longer wall of an unequal angle is cut through, a straight cut across it halves the area."""
    found, _ = middle(angle(a, b, t))
    lengths = (a, b) if a >= b else (b, a)
    place = found[:2] if a >= b else found[1::-1]
    across = (lengths[0] - lengths[1] + t) / 2  # t (a - s) = t (a + b - t) / 2
    if across >= t + 0.01:
        np.testing.assert_allclose(place, [across, t / 2], atol=0.02 * t + 2e-3)
    else:
        assert (place >= 0.25 * t).all() and (place <= t).all()


@pytest.mark.parametrize("profile", [
    np.array([[0, 0], [3, 0], [3, 1], [0, 1.0]]),
    np.array([[0, 0], [3, 0], [0, 2.0]]),
    angle(3, 3, 1.5),
    HALF_PIPE[:41],
])  # fmt: skip
def test_a_centroid_inside_its_loop_stays(profile):
    found, plain = middle(profile)
    np.testing.assert_array_equal(found, plain.centroid[0])


def test_the_middle_of_a_pipe_stays_in_its_bore():
    """The centroid is in no material, but inside the loop around the pipe."""
    circle = manifold3d.CrossSection.circle
    mesh = manifold3d.Manifold.extrude(circle(2, 48) - circle(1.5, 48), 10).to_mesh64()
    shape = Enclosure(np.array(mesh.vert_properties[:, :3]), np.array(mesh.tri_verts, dtype=np.int64))
    point, normal = np.array([[1.9, 0, 5]]), np.array([[0.0, 0, 1]])
    found = sections.cut(shape, point, normal, np.array([0.2]))
    assert found.is_around.all() and not shape.contains(found.centroid).any()
    np.testing.assert_array_equal(sections.held_in(shape, normal, found).middle, found.centroid)
