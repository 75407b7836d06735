"""Shrinking balls, the thickness that they tell of, and thin shapes; paths through a solid."""

import numpy as np
import pytest
import trimesh
from conftest import blob, torus
from scipy import spatial

import msf_jax
from msf_jax import Config, PreprocessingOptions, ground_truth
from msf_jax.base.errors import ConfigError
from msf_jax.flow import loop
from msf_jax.flow.state import Iteration
from msf_jax.inside import balls, containment, thickness
from msf_jax.inside.roadmap import Roadmap, inner_balls
from msf_jax.meso import collapse, split
from msf_jax.meso.meso import Meso
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import unit, vertex_normals
from msf_jax.topology.graphs import cycle_count


def coil(radius: float, length: float = 2.0, sides: int = 12) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """A bent tube of about that radius and length over its diagonal: vertices, faces, points of its axis."""
    angle = np.linspace(0, 2.2 * np.pi * length, 4000)
    axis = np.stack([np.cos(angle), np.sin(angle), 0.15 * angle], axis=1)
    axis /= np.linalg.norm(np.ptp(axis, axis=0))
    axis = axis[: int(np.searchsorted(np.r_[0, np.cumsum(np.linalg.norm(np.diff(axis, axis=0), axis=1))], length))]
    mesh = ground_truth.swept_tube(axis, np.full(len(axis), radius), sides, "round")
    noise = np.random.default_rng(0).normal(0, 0.02 * radius, mesh.vertices.shape)
    return np.array(mesh.vertices) + noise, np.array(mesh.faces), axis


def test_balls_are_empty_and_touch_two_points():
    mesh = blob(3)
    points, faces = np.array(mesh.vertices), np.array(mesh.faces)
    normals = unit(vertex_normals(points, faces))
    every = np.arange(len(points))
    found = balls.shrinking_balls(points, normals, spatial.KDTree(points), 0.02, 5.0, every)
    assert (found.touching >= 0).all() and (found.touching != every).all()
    centre = points - found.radius[:, None] * normals
    np.testing.assert_allclose(np.linalg.norm(points[found.touching] - centre, axis=1), found.radius, rtol=1e-9)
    nearest = np.linalg.norm(points[None] - centre[:, None], axis=2).min(axis=1)  # by brute force
    is_empty = nearest > (1 - 1e-6) * found.radius
    assert is_empty.mean() > 0.9  # but for points beside the vertex, which count as noise
    cosine = np.einsum("ij,ij->i", unit(points - centre), unit(points[found.touching] - centre))
    assert cosine.max() < balls.NOISE + 1e-9


def test_balls_of_a_sphere_and_of_a_tube_have_its_radius():
    ball = trimesh.creation.icosphere(4, 0.3)
    found = balls.ball_poles(np.array(ball.vertices), np.array(ball.faces))
    assert found.is_found.all()
    assert np.abs(found.radius - 0.3).max() < 0.01
    ring = torus(1.0, 0.2, 80, 24)
    found = balls.ball_poles(np.array(ring.vertices), np.array(ring.faces))
    assert np.abs(found.radius - 0.2).max() < 0.01


def test_a_thick_solid_has_no_scale_and_a_thin_limb_has_its_own():
    box = trimesh.creation.box((0.5, 0.5, 0.5)).subdivide().subdivide().subdivide().subdivide()
    assert thickness.scales(np.array(box.vertices), np.array(box.faces)) is None  # balls vanish at its edges
    vertices, faces, _ = coil(0.002, 0.6)
    scale = thickness.scales(vertices, faces)
    assert scale is not None
    assert abs(np.median(scale) - 0.002 / thickness.THIN) < 0.1 * 0.002 / thickness.THIN


def test_edges_of_a_thin_limb_outlive_a_length_that_others_do_not():
    vertices, faces, _ = coil(0.002, 0.3, 6)
    meso = Meso.from_mesh(vertices, faces)
    meso.scale = np.full(meso.num_rows, 0.1)
    whole = meso.copied()
    whole.scale = None
    assert collapse.collapse_short_edges(whole, 0.004) and not collapse.collapse_short_edges(meso, 0.004)
    meso.scale = np.linspace(0.1, 1.0, meso.num_rows)
    split.split_long_edges(meso, 0.001)
    meso = meso.compacted()
    assert meso.scale is not None and len(meso.scale) == meso.num_rows and meso.scale.min() >= 0.1


@pytest.mark.parametrize("radius", [0.004, 0.001])
def test_a_wire_keeps_its_length(radius):
    vertices, faces, axis = coil(radius, 1.2 if radius > 0.002 else 0.5, 8)
    extent = np.linalg.norm(np.ptp(vertices, axis=0))
    skeleton = msf_jax.skeletonize((vertices, faces))
    report = skeleton.report
    assert report.converged and report.is_sound and report.inside == 1.0
    ends = skeleton.vertices[skeleton.edges]
    length = np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1).sum()
    assert abs(length / np.linalg.norm(np.diff(axis, axis=0), axis=1).sum() - 1) < 0.02, extent
    away = spatial.KDTree(axis).query(skeleton.vertices)[0]
    assert away.mean() < 0.2 * radius


@pytest.mark.slow  # Voronoi poles do in test_replay
def test_balls_replay_to_the_run():
    run = msf_jax.contract(
        blob(3, 2), config=Config(max_iterations=3, preprocessing=PreprocessingOptions(poles="balls"))
    )
    assert np.abs(np.asarray(msf_jax.replay(run.tape, run.weights)) - run.curve.vertices).max() < 1e-9
    with pytest.raises(ConfigError, match="unknown poles 'ball'"):
        Config(preprocessing=PreprocessingOptions(poles="ball"))


# Paths through a solid


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
    monkeypatch.setattr("msf_jax.inside.roadmap.LONGEST_EDGE", 100.0)  # there are edges from one to the other
    monkeypatch.setattr("msf_jax.inside.roadmap.MOST_TESTS", -1)
    roadmap = Roadmap(Enclosure(np.array(both.vertices), np.array(both.faces)), containment.is_inside)
    assert not len(roadmap.paths(np.array([[0.0, 0, 0], [0.26, 0, 0]]), np.array([[0, 1]]))[0])
    assert roadmap.num_refused == 1 and roadmap.num_closed == 0


def test_nodes_of_an_inside_out_pocket_come_in():
    block, pocket = trimesh.creation.box([0.4] * 3), trimesh.creation.box([0.2] * 3)
    pocket.invert()
    pocket.apply_translation([0.35, 0, 0])
    both = trimesh.util.concatenate([block, pocket])
    shape = Enclosure(np.array(both.vertices), np.array(both.faces))
    line = np.linspace([-0.1, 0, 0], [0.35, 0, 0], 10)
    edges = np.stack([np.arange(9), np.arange(1, 10)], axis=1)
    x, edges = containment.contain(shape, line, edges, np.zeros(10, dtype=bool))
    assert containment.is_inside(shape, x[edges[:, 0]], x[edges[:, 1]]).all()
    assert cycle_count(len(x), edges) == (1, 0)


def test_a_flow_that_only_turns_on_the_spot_has_settled():
    def history(volume, area):
        return [
            Iteration(0, k + 1, 0.005, 100, 50, 9, 9, volume, area(k), 1, 0.0, True, 1, 0.0, 0.01) for k in range(40)
        ]

    assert loop.is_settled(history(0.01, lambda k: 0.05 + 0.002 * (k % 2)), Config())
    assert not loop.is_settled(history(0.01, lambda k: 0.5 * 0.95**k), Config())
    assert not loop.is_settled(history(0.05, lambda k: 0.05), Config())
    assert loop.is_settled(history(0.08, lambda k: 0.4), Config())  # a fifth as thick as at first: membranes
    assert not loop.is_settled(history(0.15, lambda k: 0.9), Config())
    assert not loop.is_settled(history(0.01, lambda k: 0.05)[:10], Config())
