"""Frames that are beyond a curve say so, by what the whole moved surface is asked; frames that are not do not."""

import functools

import numpy as np
import pytest
import trimesh
from run_cases import flow_of
from scipy.spatial.transform import Rotation

import msf_jax
from msf_jax import ground_truth
from msf_jax.gradients.track import Tracker
from msf_jax.solid import crossings


def capsule(height):
    axis = np.linspace([0, 0, 0], [0, 0, height], 30)
    return ground_truth.swept_tube(axis, np.full(30, 0.3), 10, "round")


def capsules(gap=1.5):
    """Two of them, whose axes are ``gap`` apart."""
    return trimesh.util.concatenate([capsule(2.0), capsule(2.0).apply_translation([gap, 0, 0])])


def u_tube():
    """Legs along z at x of -0.8 and 0.8, of radius 0.25, and a half circle between them."""
    turn, leg = np.linspace(0, np.pi, 40)[1:], np.linspace(-2, 0, 30)
    axis = [[-0.8, 0, z] for z in leg] + [[-0.8 * np.cos(t), 0, 0.8 * np.sin(t)] for t in turn]
    axis += [[0.8, 0, z] for z in leg[::-1][1:]]
    return ground_truth.swept_tube(np.array(axis, dtype=float), np.full(len(axis), 0.25), 10, "round")


MAKERS = {"capsules": capsules, "u_tube": u_tube, "y": lambda: ground_truth.make("y_coarse").mesh}


@functools.cache
def tracked(name):
    """Vertices, faces, the curve, and what tracks it."""
    mesh = MAKERS[name]()
    skeleton = flow_of("y_coarse").skeleton if name == "y" else msf_jax.skeletonize(mesh)
    return np.array(mesh.vertices), np.array(mesh.faces), skeleton, Tracker(skeleton)


@pytest.mark.slow  # a limb that has grown is below
@pytest.mark.parametrize("gap", [0.1, 0.3, 0.5])
def test_a_part_in_another_is_seen(gap):
    vertices, _, _, tracker = tracked("capsules")
    is_other = np.arange(len(vertices)) >= len(vertices) // 2
    frame = tracker.frame(0, vertices - np.outer(is_other, [1.5 - gap, 0, 0]))
    assert frame.wants_run and frame.crossings > 0 and "the surface crosses itself" in str(frame)
    if gap <= 0.1:  # each axis is well inside of the other one
        assert len(frame.overlaps) > len(frame.nodes) / 2 and frame.overlapped > 0.5
    near = tracker.frame(0, vertices - np.outer(is_other, [1.5 - 0.7, 0, 0]))
    assert not near.wants_run and near.faults == {}


@pytest.mark.slow  # parts that do are above
def test_legs_that_come_into_each_other_are_seen():
    vertices, _, _, tracker = tracked("u_tube")
    share = np.clip((-vertices[:, 2] - 0.1) / 0.8, 0, 1) * np.sign(vertices[:, 0])
    for push, is_wrong in ((0.3, False), (0.6, True), (0.75, True)):
        frame = tracker.frame(0, vertices - np.outer(share, [push, 0, 0]))
        assert frame.wants_run == is_wrong and (frame.crossings > 0) == is_wrong
    assert len(frame.overlaps) > 10


def test_a_limb_that_has_grown_is_seen():
    """Out of the side of a limb, by two of its radii or ten; a swelling of a quarter of one is none."""
    vertices, faces, skeleton, tracker = tracked("y")
    normal = trimesh.Trimesh(vertices, faces, process=False).vertex_normals
    middle = skeleton.vertices[np.argmax(skeleton.radii)]
    top = np.argmin(np.linalg.norm(vertices - middle, axis=1))
    radius = skeleton.radii[skeleton.mesh_map[top]]
    bump = np.exp(-(((vertices - vertices[top]) / (0.5 * radius)) ** 2).sum(axis=1)) * (normal @ normal[top] > 0)
    for radii, is_wrong in ((0.25, False), (2, True), (10, True)):
        frame = tracker.frame(0, vertices + radii * radius * bump[:, None] * normal[top])
        assert frame.wants_run == is_wrong and (frame.unexplained > 0) == is_wrong
    assert "of the surface is far from the curve" in str(frame)


def bent(vertices, skeleton, angle):
    """The whole mesh bent about y over two radii along z, where half of it is."""
    height, width = np.median(vertices[:, 2]), 2 * np.median(skeleton.radii)
    share = np.clip((vertices[:, 2] - height) / width, 0, 1)
    turn = np.radians(angle) * share
    straight = vertices[:, 2] - height - share * width
    reach = width / np.radians(angle)
    away = np.where(vertices[:, 2] > height, straight, 0.0)
    x = vertices[:, 0] * np.cos(turn) + reach * (1 - np.cos(turn)) + away * np.sin(turn)
    z = -vertices[:, 0] * np.sin(turn) + reach * np.sin(turn) + away * np.cos(turn)
    is_over = vertices[:, 2] > height
    return np.where(is_over[:, None], np.stack([x, vertices[:, 1], height + z], axis=1), vertices)


@pytest.mark.slow  # a limb that has grown is above
def test_a_bend_is_right_until_the_limb_is_folded():
    axis = np.linspace([0, 0, -2], [0, 0, 2], 60)
    mesh = ground_truth.swept_tube(axis, np.full(60, 0.3), 12, "round")
    skeleton = msf_jax.skeletonize(mesh)
    tracker = Tracker(skeleton)
    vertices, diagonal = np.array(mesh.vertices), np.linalg.norm(np.ptp(mesh.vertices, axis=0))
    random = np.random.default_rng(0)
    for angle in (15, 30, 45, 60):
        for noise in (0.0, 1e-3):
            moved = bent(vertices, skeleton, angle) + random.normal(0, noise * diagonal, vertices.shape)
            assert not tracker.frame(0, moved).wants_run
    for angle in (165, 180):
        assert tracker.frame(0, bent(vertices, skeleton, angle)).wants_run


def test_a_mesh_that_is_stretched_as_a_whole_is_right():
    vertices, _, skeleton, tracker = tracked("y")
    random = np.random.default_rng(1)
    for factors in ([1, 0.5, 1], [1, 1, 2.5], [0.7, 1.3, 2]):
        matrix = Rotation.random(random_state=random).as_matrix() * factors
        frame = tracker.frame(0, vertices @ matrix.T)
        assert frame.faults == {}
        np.testing.assert_allclose(frame.nodes, skeleton.vertices @ matrix.T, atol=1e-9)


def test_a_limb_that_has_been_drawn_in_is_seen():
    """A limb is telescoped to 0.03 of its length. Its sections keep their shape, so each lies next to the other."""
    vertices, _, skeleton, tracker = tracked("y")
    path = next(np.array(branch.nodes) for branch in skeleton.branches)
    degree = np.bincount(skeleton.edges.ravel())
    path = path if degree[path[-1]] == 1 else path[::-1]
    radius = np.median(skeleton.radii[path])
    start = np.argmax(np.linalg.norm(skeleton.vertices[path] - skeleton.vertices[path[0]], axis=1) > 2 * radius)
    is_far = np.isin(skeleton.mesh_map, path[start:])
    at, root = skeleton.vertices[skeleton.mesh_map], skeleton.vertices[path[start]]
    for left, is_wrong in ((0.7, False), (0.03, True)):
        moved = np.where(is_far[:, None], vertices + (left - 1) * (at - root), vertices)
        frame = tracker.frame(0, moved)
        assert frame.wants_run == is_wrong and (len(frame.strained) > 0) == is_wrong


@pytest.mark.slow  # that a bend is none is quick
def test_noise_of_a_thousandth_is_no_fault():
    """Also if balls do not cover much of a body, and if the mesh of the run crosses itself."""
    for mesh in (ground_truth.make("octopus_low").mesh, capsules(0.5)):
        vertices, random = np.array(mesh.vertices), np.random.default_rng(0)
        tracker, diagonal = Tracker(msf_jax.skeletonize(mesh)), np.linalg.norm(np.ptp(mesh.vertices, axis=0))
        frames = [tracker.frame(0, vertices + random.normal(0, 1e-3 * diagonal, vertices.shape)) for _ in range(10)]
        assert [str(frame) for frame in frames if frame.wants_run] == []


@pytest.mark.slow  # radii beside the solid's own are in test_follow
def test_radii_are_exact_to_the_whole_surface():
    """Also where what is nearest now was far away: brute force over points of all faces."""
    vertices, faces, _, tracker = tracked("u_tube")
    share = np.clip((-vertices[:, 2] - 0.1) / 0.8, 0, 1) * np.sign(vertices[:, 0])
    moved = vertices - np.outer(share, [0.65, 0, 0])
    frame = tracker.frame(0, moved)
    a, b, c = np.moveaxis(moved[faces], 1, 0)
    s, t = np.meshgrid(np.linspace(0, 1, 25), np.linspace(0, 1, 25))
    s, t = s[s + t <= 1][:, None, None], t[s + t <= 1][:, None, None]
    points = (a + s * (b - a) + t * (c - a)).reshape(-1, 3)
    away = np.array([np.linalg.norm(points - node, axis=1).min() for node in frame.nodes])
    spacing = np.linalg.norm(moved[faces] - np.roll(moved[faces], 1, axis=1), axis=2).max() / 24
    assert (np.abs(frame.radii) <= away + 1e-12).all()
    assert (away**2 - frame.radii**2 <= spacing**2 + 2 * spacing * np.abs(frame.radii)).all()
    assert not len(frame.misjudged)  # `follow` asks all triangles, so it knows of the other leg


def test_the_search_in_a_tangled_mesh_stops_early(monkeypatch):
    """The vertices are shuffled. So nearly all faces share the few cells of the grid, and cross each other."""
    vertices, _, _, tracker = tracked("y")
    shape = tracker.holding.solid.shape
    shuffled = np.random.default_rng(0).permutation(shape.vertices)
    monkeypatch.setattr(crossings, "PAIRS_AT_ONCE", 10_000)
    monkeypatch.setattr(crossings, "MOST_CROSSED", 1000)
    found = tracker.holding.crossings.found(shuffled)
    assert 1000 < len(found) <= 1000 + 10_000 + len(shape.faces)
    assert tracker.frame(0, np.random.default_rng(0).permutation(vertices)).wants_run
