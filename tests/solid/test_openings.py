"""Openings: ends, lengths, areas and radii of tubes that were cut off, beside closed forms."""

import numpy as np
import pandas
import pytest
import trimesh

import msf_jax
from msf_jax.flow import assembly
from msf_jax.limbs import one_branch
from msf_jax.meshes.checking import prepare
from msf_jax.solid.solid import Solid, is_end

SLOW = pytest.mark.slow  # more cases
AROUND = 48  # corners of a tube: its area is 0.3 % below a circle's, and its inner radius 0.2 %


R = 1.5


JAGGED = R * np.random.default_rng(5).uniform(-0.3, 0.3, AROUND)


def tube(length, low=0.0, flat=1.0, rows=50):
    """An open tube of radius R along z from ``low``, at each corner, to ``length``; ``flat`` times as wide as high."""
    angle = 2 * np.pi * np.arange(AROUND) / AROUND
    z = low + (length - low) * np.linspace(0, 1, rows + 1)[:, None] + np.zeros(AROUND)
    vertices = np.stack([R * np.cos(angle) + 0 * z, R / flat * np.sin(angle) + 0 * z, z], axis=-1).reshape(-1, 3)
    here = (AROUND * np.arange(rows)[:, None] + np.arange(AROUND)).ravel()
    beside = (AROUND * np.arange(rows)[:, None] + (np.arange(AROUND) + 1) % AROUND).ravel()
    faces = np.concatenate(
        [np.stack([here, beside, beside + AROUND], axis=1), np.stack([here, beside + AROUND, here + AROUND], axis=1)]
    )
    return trimesh.Trimesh(vertices, faces, process=False)


def with_outlet(radius, height, length=8.0):
    """An open tube of radius R along z with an open outlet of ``radius`` along x that sticks out by ``height``."""
    trunk = trimesh.creation.cylinder(R, length, sections=AROUND)
    outlet = trimesh.creation.cylinder(radius, R + height, sections=AROUND)
    outlet.apply_translation([0, 0, (R + height) / 2])
    outlet.apply_transform(trimesh.transformations.rotation_matrix(np.pi / 2, [0, 1, 0]))
    mesh = trimesh.boolean.union([trunk, outlet], engine="manifold").subdivide_to_size(0.5)
    middle = mesh.triangles_center
    is_lid = np.isclose(np.abs(middle[:, 2]), length / 2) | np.isclose(middle[:, 0], R + height)
    return trimesh.Trimesh(mesh.vertices, mesh.faces[~is_lid])


def length_of(skeleton):
    return np.linalg.norm(np.diff(skeleton.vertices[skeleton.edges], axis=1), axis=2).sum()


def at(skeleton, place, tolerance=1e-6):
    """The node of the opening at ``place``."""
    (node,) = [n for n in skeleton.openings if np.linalg.norm(skeleton.vertices[n] - place) < tolerance]
    return node


slope = R * np.cos(2 * np.pi * np.arange(AROUND) / AROUND)


@pytest.mark.parametrize(
    ("mesh", "length", "flat"),
    [
        pytest.param(tube(15.0, low=np.tan(np.radians(70)) * slope), 15.0, 1.0, marks=SLOW),  # cut off at 70 degrees
        (tube(15.0, low=slope, flat=5.0), 15.0, 5.0),
        pytest.param(tube(15.0, low=JAGGED), 15.0, 1.0, marks=SLOW),
        pytest.param(tube(2.2, rows=12), 2.2, 1.0, marks=SLOW),  # shorter than wide: its curve would lie across
    ],
    ids=["oblique70", "flattened5_oblique45", "jagged", "short"],
)
def test_a_tube_that_was_cut_off_is_whole_up_to_its_openings(mesh, length, flat):
    skeleton = msf_jax.skeletonize(mesh, repair=True)
    low = round(float(mesh.vertices[:AROUND, 2].mean()), 9)
    degree = np.bincount(skeleton.edges.ravel())
    assert len(skeleton.openings) == 2 and (degree == 1).sum() == 2 and (degree > 2).sum() == 0
    # An uneven rim is seen along its area vector, which leans by a few degrees; a flat one has an exact middle.
    nodes = [at(skeleton, [0, 0, low], 0.01 * R if low else 1e-6), at(skeleton, [0, 0, length])]
    assert length_of(skeleton) == pytest.approx(length - low, rel=0.003)
    rows = pandas.DataFrame(skeleton.columns("nodes")).iloc[nodes]
    np.testing.assert_allclose(rows["area"], np.pi * R**2 / flat, rtol=0.01)
    np.testing.assert_allclose(rows["radius"], R / flat, rtol=0.03)
    np.testing.assert_allclose(rows["least_diameter"], 2 * R / flat, rtol=0.01)
    np.testing.assert_allclose(rows["largest_diameter"], 2 * R, rtol=0.01)
    everywhere = pandas.DataFrame(skeleton.columns("nodes"))
    np.testing.assert_allclose(everywhere["area"], np.pi * R**2 / flat, rtol=0.02)
    assert skeleton.radii.min() > 0.97 * R / flat
    followed = msf_jax.follow(skeleton, np.asarray(skeleton.binding.vertices[skeleton.binding.vertex_mask]))
    np.testing.assert_allclose(
        followed.radii, skeleton.radii, rtol=1e-5 if followed.radii.dtype == np.float32 else 1e-9
    )
    assert pandas.DataFrame(skeleton.columns())["least_radius"].min() > 0.97 * R / flat


@pytest.mark.slow  # the ends of a tube are quick
@pytest.mark.parametrize(("radius", "height"), [(0.6, 0.1)])
def test_a_short_outlet_ends_in_its_opening(radius, height):
    """However short: without a limb on the surface, too, and though its radius is below half of the trunk's."""
    skeleton = msf_jax.skeletonize(with_outlet(radius, height), repair=True)
    nodes = [at(skeleton, place) for place in ([0, 0, -4], [0, 0, 4], [R + height, 0, 0])]
    degree = np.bincount(skeleton.edges.ravel())
    assert len(skeleton.openings) == 3 == (degree == 1).sum() and (degree > 2).sum() == 1
    for least in (1.0, 9.0):
        pruned = skeleton.prune(least)
        assert pruned.num_leaves == 3 == len(set(pruned.openings))
    assert length_of(skeleton) == pytest.approx(8 + R + height, rel=0.03)
    rows = pandas.DataFrame(skeleton.columns("nodes")).iloc[nodes]
    np.testing.assert_allclose(rows["area"], np.pi * np.array([R, R, radius]) ** 2, rtol=0.01)
    np.testing.assert_allclose(rows["radius"], [R, R, radius], rtol=0.03)
    (branch,) = pandas.DataFrame(skeleton.columns()).query("is_tip and mean_radius < 1.2").to_dict("records")
    assert branch["volume"] > np.pi * radius**2 * height  # its vertices are the branch's


def test_holes_in_a_wall_are_no_openings():
    """A narrow one, and one of two thirds of the tube's radius."""
    mesh = tube(15.0)
    is_wall = np.ones(len(mesh.faces), dtype=bool)
    for radius, height in ((0.4, 5.0), (1.0, 10.0)):
        is_wall &= np.linalg.norm(mesh.triangles_center - [R, 0, height], axis=1) > radius
    skeleton = msf_jax.skeletonize(trimesh.Trimesh(mesh.vertices, mesh.faces[is_wall]), repair=True)
    assert len(skeleton.openings) == 2 == (np.bincount(skeleton.edges.ravel()) == 1).sum()


@pytest.mark.parametrize(("angle", "expected"), [(52, False), (68, True)])
def test_a_lid_that_goes_on_as_the_wall_does_is_a_hole(angle, expected):
    """The rim of a cap of a ball is at this angle from the pole, and so are the lid and the walls there."""
    ball = trimesh.creation.icosphere(4)
    cap = np.flatnonzero(ball.triangles_center[:, 2] > np.cos(np.radians(angle)))
    # Flat, as repair closes it.
    vertices = np.array(ball.vertices)
    inner = np.setdiff1d(ball.faces[cap], np.delete(ball.faces, cap, axis=0))
    vertices[inner, 2] = np.cos(np.radians(angle))
    (lid,) = Solid(vertices, ball.faces, cap).openings
    assert is_end(Solid(vertices, ball.faces).shape, lid) == expected


def test_a_pin_near_an_opening_stays():
    checked = prepare(tube(15.0), repair=True)
    solid, lids = Solid(checked.vertices, checked.faces), assembly.lids_of_repair(checked)
    nodes = np.stack([np.full(12, 0.3), np.zeros(12), np.linspace(0.4, 14.6, 12)], axis=1)
    edges = np.stack([np.arange(11), np.arange(1, 12)], axis=1)
    is_held = np.arange(12) == 0
    found = one_branch.opened(solid, nodes, edges, is_held, lids)
    np.testing.assert_array_equal(found.nodes[:11], nodes[:11])
    np.testing.assert_allclose(found.nodes[found.ends], [[0, 0, 0], [0, 0, 15]], atol=1e-9)
    assert set(found.ends) == {11, 12} and [0, 12] in np.sort(found.edges, axis=1).tolist()
