"""The second verdict of a report, `are_limbs`: false where lengths, radii and angles of the curve mean nothing."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
import trimesh
from test_frame import bars, cube

import msf_jax
from msf_jax import Repair
from msf_jax.meshes.checking import prepare
from msf_jax.skeleton.report import shares_of
from msf_jax.solid.enclosure import Enclosure
from tests.benchmarks import solids


def chain(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """A curve through ``points``."""
    return points, np.stack([np.arange(len(points) - 1), np.arange(1, len(points))], axis=1)


def tube(length: float, radius: float = 0.1) -> Enclosure:
    """A cylinder along z around the origin, in small triangles."""
    mesh = trimesh.creation.cylinder(radius, length, sections=24).subdivide_to_size(0.05)
    return Enclosure(np.array(mesh.vertices), np.array(mesh.faces))


@pytest.mark.parametrize("angle", [0.0, 15.0, 30.0, 45.0])
def test_what_a_zigzag_is_longer_than_its_solid_explains(angle):
    """At an angle a to the axis it is 1 / cos a as long; sections are across its chords, which are along the axis."""
    z = np.linspace(-0.99, 0.99, 793)
    away = (0.04 - np.abs(np.mod(z, 0.16) - 0.08)) * np.tan(np.radians(angle))
    points = np.stack([away, 0 * z, z], axis=1)
    found = shares_of(tube(2.0), *chain(points))
    assert found["unexplained"] == pytest.approx(1 - np.cos(np.radians(angle)), abs=0.03)


def test_two_strands_in_one_limb_are_twice_as_long_as_it_explains():
    """They part at one end, and run side by side; each has half of the volume."""
    z = np.linspace(-0.9, 0.9, 91)
    one, other = np.stack([0 * z + 0.04, 0 * z, z], axis=1), np.stack([0 * z - 0.04, 0 * z, z], axis=1)
    points = np.concatenate([one, other])
    edges = np.concatenate([chain(one)[1], chain(other)[1] + 91, [[0, 91]]])
    assert shares_of(tube(2.0), points, edges)["unexplained"] == pytest.approx(0.5, abs=0.05)


def test_a_solid_whose_cross_section_changes_explains_its_axis():
    """Most sections of an ellipsoid are larger than the mean, its volume over its length; a bottle's neck is narrow."""
    mesh = trimesh.creation.icosphere(3)
    ellipsoid = Enclosure(np.array(mesh.vertices) * [0.2, 0.2, 1.0], np.array(mesh.faces))
    z = np.linspace(-0.95, 0.95, 191)
    assert shares_of(ellipsoid, *chain(np.stack([0 * z, 0 * z, z], axis=1)))["unexplained"] < 0.01
    profile = [[0.0, -1.0], [0.2, -1.0], [0.2, 0.2], [0.06, 0.5], [0.06, 1.0], [0.0, 1.0]]
    mesh = trimesh.creation.revolve(profile, sections=32)
    bottle = Enclosure(np.array(mesh.vertices), np.array(mesh.faces))
    assert shares_of(bottle, *chain(np.stack([0 * z, 0 * z, z], axis=1)))["unexplained"] < 0.01


def test_long_triangles_explain_a_frame():
    """The bars of a cube have vertices only at their ends, so that a face's corners are far from most nodes."""
    points, members = cube()
    mesh = bars(points, members, 0.3)
    t = np.arange(1, 40)[:, None] / 40
    inner = [(1 - t) * points[a] + t * points[b] for a, b in members]
    edges = []
    for k, (a, b) in enumerate(members.tolist()):
        edges += pairwise([a, *range(8 + 39 * k, 8 + 39 * (k + 1)), b])
    nodes = np.concatenate([points, *inner])
    found = shares_of(Enclosure(mesh.vertices, mesh.faces), nodes, np.sort(np.array(edges), axis=1))
    assert found["unexplained"] < 0.02


@pytest.fixture(scope="module")
def rod():
    return msf_jax.skeletonize(trimesh.creation.capsule(height=3.0, radius=0.4, count=[12, 12]))


def test_a_rod_is_a_limb(rod):
    assert rod.report.are_limbs and rod.report.not_limbs == () and "limbs: yes" in str(rod.report)
    assert rod.resample(0.2).report.are_limbs


@pytest.mark.slow
def test_a_plate_is_sound_and_no_limb():
    """Half of the length of its curve, which goes around four holes, is not in sheets."""
    found = msf_jax.skeletonize(solids.plate(4)).report
    assert found.is_sound and found.in_sheets is not None and found.in_sheets < 0.5
    assert not found.are_limbs and "in sheets" in found.not_limbs[0]


def test_what_was_not_measured_is_no_limb(rod, tmp_path):
    rod.save(tmp_path / "rod.swc")
    found = msf_jax.read_curve(tmp_path / "rod.swc").report
    assert not found.are_limbs and "not measured" in found.not_limbs[0] and "limbs" not in repr(found)
    rod.save(tmp_path / "rod.npz")
    assert msf_jax.read_curve(tmp_path / "rod.npz").report.are_limbs


def test_parts_beyond_the_most_and_handles_of_joining_are_told(rod):
    ball = trimesh.creation.capsule(height=1.0, radius=0.3, count=[8, 8])
    three = trimesh.util.concatenate([ball.copy().apply_translation([2.0 * k, 0, 0]) for k in range(3)])
    assert prepare(three, Repair(most_parts=2)).num_left_out == 1 and prepare(three, True).num_left_out == 0
    bars = [trimesh.creation.box((4.0, 0.5, 0.5)), trimesh.creation.box((0.5, 0.5, 4.0))]
    frame = [bars[0].copy().apply_translation([0, 0, side]) for side in (-1.5, 1.5)]
    frame += [bars[1].copy().apply_translation([side, 0, 0]) for side in (-1.5, 1.5)]
    assert prepare(trimesh.util.concatenate(frame), "join").joined_handles == 1
    assert prepare(trimesh.util.concatenate(frame[:3]), "join").joined_handles == 0
    assert replace(rod.report, left_out=1).not_limbs == ("repair left out 1 part, which has no curve",)
    (reason,) = replace(rod.report, joined_handles=2).not_limbs
    assert reason == "joining made 2 handles, where parts touch in several places"
