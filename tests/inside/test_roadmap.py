"""Paths through a solid, along balls inside of it: led round, and bounded."""

import numpy as np
import trimesh

from msf_jax.inside import containment
from msf_jax.inside.roadmap import Roadmap, inner_balls
from msf_jax.solid.enclosure import Enclosure
from tests.benchmarks import ground_truth


def bent_tube() -> Enclosure:
    angle = np.linspace(0, 1.6 * np.pi, 80)
    axis = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    mesh = ground_truth.swept_tube(axis, np.full(len(axis), 0.12), 10)
    vertices = np.array(mesh.vertices)
    return Enclosure(vertices / np.linalg.norm(np.ptp(vertices, axis=0)), np.array(mesh.faces))


def test_inner_balls_are_inside():
    for shape in (bent_tube(), Enclosure(*(np.array(part) for part in (BOX.vertices, BOX.faces)))):
        centre, radius = inner_balls(shape)
        assert len(centre) and (shape.winding_numbers(centre) == 1).all()
        assert (shape.distances(centre) >= radius * (1 - 1e-9)).all()


BOX = trimesh.creation.box((0.9, 0.4, 0.01))  # thinner than its surface is sampled


def test_a_path_is_led_round_and_searches_are_bounded(monkeypatch):
    shape = bent_tube()
    roadmap = Roadmap(shape, containment.is_inside)
    centre, _ = inner_balls(shape)
    ends = centre[[0, len(centre) - 1]]
    ends = centre[[centre[:, 0].argmin(), centre[:, 1].argmin()]]
    (path,) = roadmap.paths(ends, np.array([[0, 1]]))
    points = np.concatenate([ends[:1], path, ends[1:]])
    assert containment.is_inside(shape, points[:-1], points[1:]).all()
    assert roadmap.num_refused == 0
    monkeypatch.setattr("msf_jax.inside.roadmap.VISITS", -1)
    refused = Roadmap(shape, containment.is_inside)
    assert not len(refused.paths(ends, np.array([[0, 1]]))[0])
    assert refused.num_refused == 1


def test_a_path_near_its_edge_needs_no_balls_elsewhere():
    """From a ball in a bent tube to the nearest one that it does not see."""
    shape = bent_tube()
    centre, _ = inner_balls(shape)
    first = centre[[centre[:, 0].argmin()]]
    is_seen = containment.is_inside(shape, np.repeat(first, len(centre), axis=0), centre)
    ends = np.concatenate([first, centre[[np.where(is_seen, np.inf, np.linalg.norm(centre - first, axis=1)).argmin()]]])
    roadmap = Roadmap(shape, containment.is_inside)
    (path,) = roadmap.paths(ends, np.array([[0, 1]]))
    points = np.concatenate([ends[:1], path, ends[1:]])
    assert len(path) and containment.is_inside(shape, points[:-1], points[1:]).all()
    assert roadmap._balls is None


def test_paths_keep_to_their_own_sides_of_a_hole():
    shape = Enclosure(*(np.array(part) for part in (RING.vertices, RING.faces)))
    angle = np.radians([0, 120, 240])
    x = 0.4 * np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    pairs = np.array([[0, 1], [1, 2], [2, 0]])
    roadmap = Roadmap(shape, containment.is_inside)
    for (a, b), path in zip(pairs, roadmap.paths(x, pairs), strict=True):
        points = np.concatenate([x[[a]], path, x[[b]]])
        assert containment.is_inside(shape, points[:-1], points[1:]).all()
        turned = np.unwrap(np.arctan2(points[:, 1], points[:, 0]))
        assert np.isclose(turned[-1] - turned[0], np.radians(120)) and np.ptp(turned) < np.radians(140)


RING = trimesh.creation.torus(0.4, 0.05, major_sections=48, minor_sections=8)


def test_no_path_between_two_solids_takes_no_search():
    one, other = trimesh.creation.box([0.4] * 3), trimesh.creation.box([0.4] * 3)
    other.apply_translation([0.45, 0, 0])
    both = trimesh.util.concatenate([one, other])
    shape = Enclosure(np.array(both.vertices), np.array(both.faces))
    roadmap = Roadmap(shape, containment.is_inside)
    ends = np.array([[0.0, 0, 0], [0.45, 0, 0]])
    (path,) = roadmap.paths(ends, np.array([[0, 1]]))
    assert not len(path) and roadmap.num_visits == 0 and roadmap.num_refused == 0
    assert roadmap.num_closed == 1
    assert not roadmap.paths(ends, np.empty((0, 2), dtype=int)) and roadmap.num_closed == 0


def test_joining_has_a_bound(monkeypatch):
    """What is not known to be apart then counts as refused, and not as closed."""
    one, other = trimesh.creation.box([0.4] * 3), trimesh.creation.box([0.1] * 3)
    other.apply_translation([0.26, 0, 0])
    both = trimesh.util.concatenate([one, other])
    monkeypatch.setattr("msf_jax.inside.roadmap.MOST_TESTS", -1)
    roadmap = Roadmap(Enclosure(np.array(both.vertices), np.array(both.faces)), containment.is_inside)
    assert not len(roadmap.paths(np.array([[0.0, 0, 0], [0.26, 0, 0]]), np.array([[0, 1]]))[0])
    assert roadmap.num_refused == 1 and roadmap.num_closed == 0
