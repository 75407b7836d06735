"""Repair on request: what comes out is closed, oriented and manifold, and every change is told."""

from itertools import pairwise

import numpy as np
import pytest
import trimesh
from conftest import blob, torus
from repair_cases import BALL, FACES, VERTICES, assert_sound, volumes

import msf_jax
from msf_jax import Config, ConfigError, MeshError, Repair
from msf_jax.meshes import checking
from tests.benchmarks import faults


def test_a_sound_mesh_stays_as_it_is():
    found = checking.prepare((VERTICES, FACES), True)
    assert found.repairs == ()
    np.testing.assert_array_equal(found.vertices, VERTICES)
    np.testing.assert_array_equal(found.faces, FACES)


@pytest.mark.parametrize("gap", [0.0, 1e-9])
def test_a_soup_is_welded(gap):
    soup = VERTICES[FACES].reshape(-1, 3)
    soup += np.random.default_rng(0).uniform(-gap, gap, soup.shape)
    found = checking.prepare((soup, np.arange(len(soup)).reshape(-1, 3)), True)
    assert_sound(found, len(soup))
    assert len(found.vertices) == len(VERTICES)
    assert found.repairs == (f"welded {len(soup) - len(VERTICES)} vertices at the rim of a hole to another",)


def test_a_hole_larger_than_asked_stays_and_is_refused():
    half = VERTICES[FACES][:, :, 2].min(axis=1) > 0
    with pytest.raises(MeshError, match=r"after repair, the mesh is open: .*or let Repair do more"):
        checking.prepare((VERTICES, FACES[half]), Repair(largest_hole=0.2))


def test_orientation_is_made_consistent_and_counted():
    turned = FACES.copy()
    turned[100:150] = turned[100:150, ::-1]
    found = checking.prepare((VERTICES, turned), True)
    assert_sound(found, len(VERTICES))
    assert found.repairs == ("turned 50 faces round",)


def test_doubled_and_degenerate_faces_go():
    faces = np.concatenate([FACES, FACES[:7], FACES[7:9, ::-1], [[4, 4, 5]]])
    found = checking.prepare((VERTICES, faces), True)
    assert_sound(found, len(VERTICES))
    assert found.repairs == ("left out 1 face with a corner twice", "left out 9 faces that were there already")


@pytest.mark.parametrize("shift", [(1, 1, 0), (1, 1, 1)])
@pytest.mark.parametrize("is_turned", [False, True])
def test_boxes_that_touch_are_taken_apart(shift, is_turned):
    other = faults.box(shift)
    other = other[0], other[1][:, ::-1] if is_turned else other[1]
    mesh = faults.welded(faults.joined(faults.box(), other))
    found = checking.prepare(mesh, True)
    assert_sound(found, len(mesh[0]))
    assert volumes(found) == pytest.approx([1.0, 1.0])


def test_many_vertices_in_one_place_are_welded_in_little_memory():
    """The tip of a cone of 20,000 triangles, which a soup holds as often: 2e8 pairs."""
    angle = np.linspace(0, 2 * np.pi, 10_000, endpoint=False)
    rim = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    place = np.arange(len(rim))
    up = np.stack([np.full_like(place, 0), place + 2, np.roll(place, -1) + 2], axis=1)
    down = np.stack([np.full_like(place, 1), np.roll(place, -1) + 2, place + 2], axis=1)
    vertices = np.concatenate([[[0, 0, 1], [0, 0, -1]], rim])
    soup = vertices[np.concatenate([up, down])].reshape(-1, 3)
    found = checking.prepare((soup, np.arange(len(soup)).reshape(-1, 3)), True)
    assert len(found.vertices) == len(vertices)


def test_specks_are_left_out_and_named_unless_all_parts_are_wanted():
    """A flake beside, inside and away from a rod, and none of a hair that is as thin."""
    rod, hair = trimesh.creation.cylinder(radius=3.0, height=20.0), trimesh.creation.box((0.05, 0.05, 9.0))
    hair.apply_translation((0, 0, 14.0))
    for x in (3.1, 2.0, 30.0):
        flake = trimesh.creation.box((0.05, 0.5, 1.2)).apply_translation((x, 0, 1.0))
        mesh = trimesh.util.concatenate([rod, flake, hair])
        found = checking.prepare(mesh, True)
        assert found.repairs == (f"left out 1 piece smaller than smallest_part, at ({x:g}, 0, 1)",)
        assert len(found.components) == 2 and len(found.strays) == 8
        assert (found.vertex_of_input >= 0).sum() == len(found.vertices) == len(mesh.vertices) - 8
        everything = checking.prepare(mesh, Repair(smallest_part=0.0))
        assert len(everything.components) == 3 and not everything.repairs


def test_the_callers_arrays_stay_as_they_are():
    vertices, faces = faults.topology_variants()["many holes"]
    copies = vertices.copy(), faces.copy()
    checking.prepare((vertices, faces), True)
    np.testing.assert_array_equal(vertices, copies[0])
    np.testing.assert_array_equal(faces, copies[1])


@pytest.mark.parametrize("make", [lambda seed: blob(seed), lambda seed: torus()])
@pytest.mark.parametrize("seed", range(3))
def test_a_mesh_that_was_broken_in_every_way_has_its_genus_again(make, seed):
    """Faces lost, turned, doubled and reordered, corners rotated, vertices doubled and shuffled."""
    mesh, random = make(seed), np.random.default_rng(seed)
    vertices, faces = np.array(mesh.vertices), np.array(mesh.faces)
    keep = np.ones(len(faces), dtype=bool)
    keep[random.choice(len(faces), 6, replace=False)] = False
    faces = faces[keep]
    faces = np.concatenate([faces, faces[:5]])[random.permutation(len(faces) + 5)]
    faces = faces[np.arange(len(faces))[:, None], (np.arange(3) + random.integers(3, size=len(faces))[:, None]) % 3]
    is_turned = random.random(len(faces)) < 0.3
    faces[is_turned] = faces[is_turned, ::-1]
    corners = vertices[faces].reshape(-1, 3)
    order = random.permutation(len(corners))
    place = np.argsort(order)
    found = checking.prepare((corners[order], place.reshape(-1, 3)), True)
    assert_sound(found, len(corners))
    euler = len(mesh.vertices) - len(mesh.faces) // 2
    assert [part.genus for part in found.components] == [(2 - euler) // 2]
    assert volumes(found)[0] == pytest.approx(mesh.volume, rel=0.01)


@pytest.mark.slow  # made ones are in the other tests
@pytest.mark.parametrize("name", ["camel-pinched"])
def test_research_meshes_become_curves(research_mesh, name):
    mesh = research_mesh(name)
    found = checking.prepare(mesh, True)
    assert_sound(found, len(mesh[0]))
    skeleton = msf_jax.skeletonize(mesh, repair=True)
    assert skeleton.report.repairs == found.repairs
    assert skeleton.report.loops == skeleton.report.cycles == skeleton.report.genus and len(skeleton.mesh_map) == len(
        mesh[0]
    )


@pytest.mark.slow  # that of a joined one is in test_joining
@pytest.mark.usefixtures("few_rows_once")
def test_the_tape_of_a_repaired_mesh_speaks_of_the_callers_vertices():
    vertices, faces = faults.topology_variants()["many holes"]
    run = msf_jax.contract((vertices, faces), config=Config(max_iterations=4), repair=True)
    assert run.tape.vertices.shape == vertices.shape
    np.testing.assert_array_equal(run.tape.vertices, vertices)
    nodes = np.asarray(msf_jax.replay(run.tape, run.weights))
    assert np.abs(nodes - run.curve.vertices).max() < 1e-9


def test_of_very_many_parts_the_largest_are_kept():
    """Their vertices are all accounted for, and the report says how many are left out; joined, none is."""
    boxes = [trimesh.creation.box([1 + k % 3] * 3).apply_translation([10.0 * k, 0, 0]) for k in range(9)]
    mesh = trimesh.util.concatenate(boxes)
    found = checking.prepare(mesh, Repair(most_parts=4))
    assert len(found.components) == 4
    assert sorted(np.ptp(part.vertices, axis=0).max() for part in found.components) == [2.0, 3.0, 3.0, 3.0]
    assert any("left out 5 pieces, the smallest, beyond most_parts = 4" in line for line in found.repairs)
    assert len(found.vertex_of_input) == len(mesh.vertices) and (found.vertex_of_input < 0).sum() == 5 * 8
    assert len(checking.prepare(mesh, Repair(most_parts=4, join=0.0)).components) == 9


@pytest.mark.parametrize(
    ("make", "says"),
    [
        (lambda: Repair(smallest_part=-1.0), "Repair.smallest_part is -1.0: expected a number from 0 to 1"),
        (lambda: Repair(largest_hole=True), "Repair.largest_hole is True"),
        (lambda: Repair(most_parts=0), "Repair.most_parts is 0: expected a whole number of 1 or more"),
        (lambda: msf_jax.skeletonize((VERTICES, FACES), repair="yes"), "repair is 'yes': expected True, False"),
    ],
)
def test_options_are_checked(make, says):
    with pytest.raises(ConfigError, match=says):
        make()


def test_nothing_left_is_an_error_that_says_what_was_done():
    with pytest.raises(
        MeshError, match=r"no piece is left that encloses a volume and has 5 vertices: .*repaired: filled 1 hole"
    ):
        checking.prepare((VERTICES[:3], [[0, 1, 2]]), True)


# Sheets


@pytest.mark.parametrize(
    ("cells", "genus"), [(np.ones((3, 3, 2)), 0), (np.array([[1, 1, 1], [1, 0, 1], [1, 1, 1]]), 1)]
)
def test_walls_between_many_cells_go(cells, genus):
    """As many as four walls meet at an edge, turned this way or that; the solid is that of all cells together."""
    shifts = np.argwhere(np.atleast_3d(cells))
    vertices, faces = faults.welded(faults.joined(*(faults.box(shift) for shift in shifts)))
    is_turned = np.random.default_rng(5).random(len(faces)) < 0.5
    faces[is_turned] = faces[is_turned, ::-1]
    found = checking.prepare((vertices, faces), True)
    assert_sound(found, len(vertices))
    assert volumes(found) == pytest.approx([len(shifts)])
    assert [part.genus for part in found.components] == [genus]


def test_ribs_and_a_flange_go_and_the_solid_stays():
    """Where every edge has a fin, no face of the solid is joined to another; a flange may have more faces than it."""
    edges = np.unique(np.sort(np.concatenate([FACES[:, [0, 1]], FACES[:, [1, 2]], FACES[:, [2, 0]]]), axis=1), axis=0)
    tips = 1.2 * VERTICES[edges].mean(axis=1)
    fins = np.column_stack([edges, len(VERTICES) + np.arange(len(edges))])
    found = checking.prepare((np.concatenate([VERTICES, tips]), np.concatenate([FACES, fins])), True)
    assert volumes(found) == pytest.approx([BALL.volume])
    vertices, faces = faults.box()
    rim = np.flatnonzero(vertices[:, 2] == 0)
    rim = rim[np.argsort(np.arctan2(vertices[rim, 1], vertices[rim, 0]))]
    rings = [rim]
    for step in range(1, 16):
        rings.append(len(vertices) + np.arange(len(rim)))
        vertices = np.concatenate([vertices, vertices[rim] * (1 + step / 5)])
    flange = [
        face
        for inner, outer in pairwise(rings)
        for a, b, c, d in zip(inner, np.roll(inner, -1), outer, np.roll(outer, -1), strict=True)
        for face in ([a, b, c], [b, d, c])
    ]
    assert len(flange) > len(faces)
    found = checking.prepare((vertices, np.concatenate([faces, flange])), True)
    assert volumes(found) == pytest.approx([1.0])


@pytest.mark.parametrize("seed", range(4))
def test_which_faces_were_turned_does_not_matter(seed):
    """Two boxes with a wall between them: the wall goes, whatever the orientation was."""
    mesh = faults.welded(faults.joined(faults.box(), faults.box((0, 0, 1))))
    middle = mesh[0][mesh[1]][:, :, 2]
    inner = np.flatnonzero((middle == 0.5).all(axis=1))
    keep = np.setdiff1d(np.arange(len(mesh[1])), inner[len(inner) // 2 :])  # one of the two lids
    faces = mesh[1][keep].copy()
    is_turned = np.random.default_rng(seed).random(len(faces)) < 0.5
    faces[is_turned] = faces[is_turned, ::-1]
    found = checking.prepare((mesh[0], faces), True)
    assert volumes(found) == pytest.approx([2.0])
