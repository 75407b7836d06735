"""Curves that stay inside of a solid: what is led round, what comes in, and what is cut off."""

import manifold3d
import numpy as np
import pytest
import trimesh
from curve_cases import bow, is_inside, length_of, none_held, path, tube, unit_shape

import msf_jax
from msf_jax.curve import finishing
from msf_jax.inside import containment
from msf_jax.inside.containment import Roadmap
from msf_jax.solid.enclosure import Enclosure
from msf_jax.topology.graphs import cycle_count
from tests.benchmarks import ground_truth


def test_an_edge_across_a_bend_is_led_round_it():
    shape, scale = unit_shape(tube(bow(0.6)))
    x, edges = path(scale * bow(0.6)[[2, -3]])
    assert not is_inside(shape, x, edges)
    led, led_edges = containment.contain(Roadmap(shape), x, edges, none_held(x))
    assert is_inside(shape, led, led_edges)
    assert cycle_count(len(led), led_edges) == (1, 0)
    np.testing.assert_array_equal(led[:2], x)
    assert length_of(led, led_edges) < 2 * np.pi * 0.6 * scale * 1.6  # the way round, and no tour of the tube


def test_nodes_outside_come_in_and_held_ones_stay():
    shape, scale = unit_shape(tube(bow(0.25)))
    middle = scale * bow(0.25)[[10, 20, 30, 40, 50]]
    out = middle.copy()
    out[2] *= 1.3
    x, edges = containment.contain(Roadmap(shape), *path(out), none_held(out))
    assert is_inside(shape, x, edges)
    np.testing.assert_array_equal(x[[0, 1, 3, 4]], out[[0, 1, 3, 4]])
    assert np.linalg.norm(x[2] - middle[2]) < 0.15 * scale
    held = np.arange(5) == 2
    x, _ = containment.contain(Roadmap(shape), *path(out), held)
    np.testing.assert_array_equal(x[2], out[2])


def test_a_curve_that_is_inside_is_not_touched():
    shape, scale = unit_shape(tube(bow(0.25)))
    before, edges = path(scale * bow(0.25)[5:-5])
    x, after = containment.contain(Roadmap(shape), before, edges, none_held(before))
    np.testing.assert_array_equal(x, before)
    np.testing.assert_array_equal(np.sort(after, axis=1), edges)


def test_a_segment_through_a_fold_inside_the_solid_is_inside():
    """Two balls that overlap, one surface: it crosses itself, but between the centres nothing is outside."""
    one, other = trimesh.creation.icosphere(2, 1.0), trimesh.creation.icosphere(2, 1.0)
    other.apply_translation([1.2, 0, 0])
    both = trimesh.util.concatenate([one, other])
    shape = Enclosure(np.asarray(both.vertices), np.asarray(both.faces))
    ends = np.array([[0.0, 0, 0], [1.2, 0, 0], [0.6, 0.5, 0], [0.6, 1.2, 0]])
    a, b = ends[[0, 0, 0]], ends[[1, 2, 3]]
    assert shape.holds(a, b).tolist() == [True, True, False]


@pytest.mark.parametrize("seed", range(5))
def test_a_segment_that_leaves_along_a_face_is_not_inside(seed):
    """A ray in the plane of a face does not hit it, and may miss its neighbours by rounding."""
    random = np.random.default_rng(seed)
    step = manifold3d.Manifold.cube([2, 2, 1]).translate([-1, -1, -1])
    step += manifold3d.Manifold.cube([1, 2, 2]).translate([-1, -1, -1])
    found = step.to_mesh()
    turn = trimesh.transformations.random_rotation_matrix(random.uniform(size=3))[:3, :3]
    shape = Enclosure(found.vert_properties[:, :3].astype(float) @ turn.T, np.array(found.tri_verts))
    y = random.uniform(-0.8, 0.8, (2, 50))
    a = np.stack([random.uniform(-0.8, -0.2, 50), y[0], np.zeros(50)], axis=1) @ turn.T
    b = np.stack([random.uniform(1.1, 2, 50), y[1], np.zeros(50)], axis=1) @ turn.T
    assert shape.contains(a).all() and not shape.contains(b).any()
    assert not shape.holds(a, b).any()


def test_a_long_curve_has_no_more_nodes_than_it_may(monkeypatch):
    line = bow(0.3)
    shape, scale = unit_shape(tube(line))
    coarse = path(scale * line[5:-5:5])
    fine, _, is_sparse = containment.refine(shape, *coarse, 0.1, 1000)
    assert len(fine) > 2 * len(coarse[0]) and not is_sparse
    few, edges, is_sparse = containment.refine(shape, *coarse, 0.1, len(fine) // 2)
    assert len(coarse[0]) < len(few) < 0.8 * len(fine) and is_sparse and cycle_count(len(few), edges) == (1, 0)
    monkeypatch.setattr(finishing, "MOST_NODES", 3)
    report = msf_jax.skeletonize(tube(line)).report
    assert report.is_sound and any("far apart" in note for note in report.notes)


@pytest.mark.slow  # a part that crosses itself is in test_hollow
def test_the_curve_of_a_noisy_surface_that_crosses_itself_is_inside():
    wavy = ground_truth.noisy(ground_truth.make("y"), 0.005, 1)
    report = msf_jax.skeletonize(wavy.mesh).report
    assert report.inside == 1 and not report.notes and report.is_sound


def test_nodes_of_an_inside_out_pocket_come_in():
    block, pocket = trimesh.creation.box([0.4] * 3), trimesh.creation.box([0.2] * 3)
    pocket.invert()
    pocket.apply_translation([0.35, 0, 0])
    both = trimesh.util.concatenate([block, pocket])
    shape = Enclosure(np.array(both.vertices), np.array(both.faces))
    line = np.linspace([-0.1, 0, 0], [0.35, 0, 0], 10)
    edges = np.stack([np.arange(9), np.arange(1, 10)], axis=1)
    x, edges = containment.contain(Roadmap(shape), line, edges, np.zeros(10, dtype=bool))
    assert shape.holds(x[edges[:, 0]], x[edges[:, 1]]).all()
    assert cycle_count(len(x), edges) == (1, 0)


def test_balls_behind_the_surface_are_inside():
    """A box is thinner than its surface is sampled."""
    for mesh in (tube(bow(0.8)), trimesh.creation.box((0.9, 0.4, 0.01))):
        shape, _ = unit_shape(mesh)
        network = Roadmap(shape).whole
        assert len(network.centre) and (shape.winding_numbers(network.centre) == 1).all()
        np.testing.assert_allclose(shape.distances(network.centre), network.radius)


def test_paths_keep_to_their_own_sides_of_a_hole():
    shape, scale = unit_shape(trimesh.creation.torus(0.4, 0.05, major_sections=48, minor_sections=8))
    angle = np.radians([0, 120, 240])
    x = 0.4 * scale * np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    edges = np.array([[0, 1], [1, 2], [2, 0]])
    led, led_edges = containment.contain(Roadmap(shape), x, edges, none_held(x))
    assert is_inside(shape, led, led_edges) and cycle_count(len(led), led_edges) == (1, 1)
    assert length_of(led, led_edges) < 1.2 * 2 * np.pi * 0.4 * scale


def test_each_edge_has_a_path_of_its_own_near_it():
    """Two short edges cross the slits of both forks of a long bar: neither path runs to the other end."""
    bar = manifold3d.Manifold.cube([2.0, 0.2, 0.2], True)
    for end in (-1.0, 1.0):
        bar -= manifold3d.Manifold.cube([0.4, 0.004, 0.4], True).translate([end, 0.0, 0.0])
    found = bar.to_mesh()
    shape, scale = unit_shape(trimesh.Trimesh(found.vert_properties[:, :3].astype(float), found.tri_verts))
    x = scale * np.array([[-0.85, -0.05, 0], [-0.85, 0.05, 0], [0.85, -0.05, 0], [0.85, 0.05, 0]])
    led, edges = containment.contain(Roadmap(shape), x, np.array([[0, 1], [2, 3]]), none_held(x))
    assert is_inside(shape, led, edges) and cycle_count(len(led), edges) == (2, 0)
    assert length_of(led, edges) < scale


def test_searches_are_bounded_and_solids_in_pieces_are_told_from_that(monkeypatch):
    one, other = trimesh.creation.box([0.4] * 3), trimesh.creation.box([0.4] * 3)
    shape, _ = unit_shape(trimesh.util.concatenate([one, other.apply_translation([0.45, 0, 0])]))
    x, edges = path(shape.vertices.reshape(2, 8, 3).mean(axis=1))
    counts = []
    for name in (None, "MOST_TESTS", "MOST_VISITS"):
        if name:
            monkeypatch.setattr(containment, name, -1)
        roadmap = Roadmap(shape)
        assert len(containment.contain(roadmap, x, edges, none_held(x))[0]) == 2
        counts.append((roadmap.num_closed, roadmap.num_refused))
    assert counts == [(1, 0), (0, 1), (0, 1)]
