"""Tracking: the same nodes in every frame, a report that tells good frames from bad, files on the command line."""

import csv
import functools

import numpy as np
import pytest
import trimesh
from run_cases import flow_of
from scipy.spatial.transform import Rotation

import msf_jax
from msf_jax import ConfigError, MeshError
from msf_jax.app.cli import main
from msf_jax.gradients.track import Tracker
from tests.benchmarks import ground_truth


@pytest.fixture(scope="module")
def tube():
    """A short straight tube, and its curve."""
    mesh = ground_truth.make("straight_coarse").mesh
    return np.array(mesh.vertices), np.array(mesh.faces), flow_of("straight_coarse").skeleton


def turned(vertices, angle):
    return vertices @ Rotation.from_rotvec([0, angle, 0.2]).as_matrix().T


def pinched(vertices, skeleton):
    """The tube with its middle crushed to a point."""
    middle = skeleton.vertices[np.linalg.norm(skeleton.vertices - vertices.mean(axis=0), axis=1).argmin()]
    is_near = np.linalg.norm(vertices - middle, axis=1) < 0.3
    return np.where(is_near[:, None], middle, vertices)


def test_every_frame_is_followed_and_compiled_for_once(tube, compilations):
    """Turned, blown up, and inside out along its axis, where the curve is outside of nothing."""
    vertices, faces, skeleton = tube
    angles = np.linspace(0, 1, 6)
    frames = [turned(vertices, angle) for angle in angles]
    msf_jax.track(skeleton, frames[:1])
    compilations.clear()
    done = msf_jax.track(skeleton, frames)
    assert not compilations
    assert done.nodes.shape == (6, *skeleton.vertices.shape) and done.radii.shape == (6, len(skeleton.vertices))
    for number, (frame, angle) in enumerate(zip(done.frames, angles, strict=True)):
        np.testing.assert_allclose(frame.nodes, turned(skeleton.vertices, angle), atol=1e-9)
        assert frame.number == number and frame.inside == 1.0 and not frame.wants_run
    assert str(done) == "6 frames, 0 of them need a fresh run"
    mixed = msf_jax.track(skeleton, iter([frames[1], (frames[1], faces), trimesh.Trimesh(frames[1], faces)]))
    np.testing.assert_array_equal(mixed.nodes[1:], mixed.nodes[:1].repeat(2, axis=0))
    # `follow` is another program, and a compiler may sum in another order: a few units in the last place of the size.
    alone, size = msf_jax.follow(skeleton, frames[1]).nodes, np.ptp(vertices, axis=0).max()
    np.testing.assert_allclose(mixed.nodes, alone[None].repeat(3, axis=0), rtol=0, atol=8 * np.spacing(size))
    blown, mirrored = msf_jax.track(skeleton, [2 * vertices, vertices * [1, 1, -1]]).frames
    assert (blown.inside, mirrored.inside) == (1.0, 0.0) and not blown.wants_run and mirrored.wants_run


def test_frames_that_no_longer_hold_say_which_nodes(tube):
    """A tube that is crushed has lost a section; one whose vertices are shuffled is beyond any curve, and one without
    extent has none."""
    vertices, _, skeleton = tube
    shuffled = np.random.default_rng(0).permutation(vertices)
    done = msf_jax.track(skeleton, [vertices.tolist(), pinched(vertices, skeleton), shuffled, 0 * vertices])
    assert [frame.wants_run for frame in done.frames] == [False, True, True, True]
    good, crushed, _, point = done.frames
    assert 0 < len(crushed.vanished) < len(skeleton.vertices) == len(point.vanished)
    np.testing.assert_array_equal(np.flatnonzero(np.isnan(crushed.nodes).any(axis=1)), crushed.vanished)
    assert np.isnan(point.inside)
    assert "3 of them need a fresh run" in str(done) and f"the first {crushed.vanished[0]}" in str(done)
    np.testing.assert_array_equal(done.curve(0).vertices, good.nodes)
    with pytest.raises(ConfigError, match="frame 1 has no curve"):
        done.curve(1)
    with pytest.raises(ConfigError, match="no frame 4: expected one of the 4"):
        done.curve(4)


def test_a_frame_of_another_mesh_is_named(tube):
    vertices, faces, skeleton = tube
    bad = np.where(np.arange(len(vertices))[:, None] == 3, np.inf, vertices)
    for frames, error, says in (
        ([vertices, vertices[1:]], MeshError, r"frame 1: vertices has shape"),
        ([vertices, bad], MeshError, r"frame 1: 1 of the vertices, the first 3, are not finite"),
        ([(vertices, np.roll(faces, 1, axis=0)[:-1])], MeshError, r"frame 0: its \d+ faces are not those"),
        ("frames", ConfigError, "frames is a str"),
        ([], ConfigError, "frames is empty"),
    ):
        with pytest.raises(error, match=says):
            msf_jax.track(skeleton, frames)


def test_the_command_writes_a_curve_for_every_frame_and_says_which_is_bad(tube, tmp_path, monkeypatch, capsys):
    vertices, faces, skeleton = tube
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    frames, out = tmp_path / "frames", tmp_path / "out"
    frames.mkdir()
    for number in (10, 2, 1):
        trimesh.Trimesh(turned(vertices, number / 10), faces, process=False).export(frames / f"frame{number}.off")
    skeleton.save("first.npz")
    assert main(["track", "first.npz", "frames", "-o", "out", "--format", ".npz"]) == 0
    said = capsys.readouterr()
    assert "3 frames, 3 curves" in said.out and "\r" not in said.err  # no bar where there is no terminal
    rows = list(csv.DictReader((out / "frames.csv").read_text().splitlines()))
    assert [row["mesh"] for row in rows] == ["frame1.off", "frame2.off", "frame10.off"]
    assert {row["wants_run"] for row in rows} == {"0"} and {row["inside"] for row in rows} == {"1"}
    np.testing.assert_allclose(
        msf_jax.read_curve(out / "frame10.npz").vertices, turned(skeleton.vertices, 1), atol=1e-6
    )
    trimesh.Trimesh(pinched(vertices, skeleton), faces, process=False).export(frames / "frame3.off")
    run = ["track", "first.npz", "frames", "-o", "out", "-q"]
    assert main(run) == 1 and "frame3.off: frame 2: " in capsys.readouterr().err
    assert not (out / "frame3.swc").exists() and (out / "frame10.swc").exists()
    trimesh.creation.box().export(frames / "frame4.off")
    assert main(run) == 2 and "'frame4.off': frame 3: its 12 faces" in capsys.readouterr().err
    assert len((out / "frames.csv").read_text().splitlines()) == 1 + 3  # those before it
    assert main(["track", "first.npz", "frames", "-o", "frames", "-q"]) == 2
    assert main(["track", "first.npz", ".", "-o", "out", "-q"]) == 2 and "no mesh in" in capsys.readouterr().err


# What a frame is checked for


def u_tube():
    """Legs along z at x of -0.8 and 0.8, of radius 0.25, and a half circle between them."""
    turn, leg = np.linspace(0, np.pi, 40)[1:], np.linspace(-2, 0, 30)
    axis = [[-0.8, 0, z] for z in leg] + [[-0.8 * np.cos(t), 0, 0.8 * np.sin(t)] for t in turn]
    axis += [[0.8, 0, z] for z in leg[::-1][1:]]
    return ground_truth.swept_tube(np.array(axis, dtype=float), np.full(len(axis), 0.25), 10, "round")


MAKERS = {"u_tube": u_tube, "y": lambda: ground_truth.make("y_coarse").mesh}


@functools.cache
def tracked(name):
    """Vertices, faces, the curve, and what tracks it."""
    mesh = MAKERS[name]()
    skeleton = flow_of("y_coarse").skeleton if name == "y" else msf_jax.skeletonize(mesh)
    return np.array(mesh.vertices), np.array(mesh.faces), skeleton, Tracker(skeleton)


def pushed(vertices, push):
    """The legs of the u-tube, each moved towards the other by ``push`` at their ends."""
    share = np.clip((-vertices[:, 2] - 0.1) / 0.8, 0, 1) * np.sign(vertices[:, 0])
    return vertices - np.outer(share, [push, 0, 0])


@pytest.mark.slow  # a limb that has grown is below
def test_legs_that_come_into_each_other_are_seen():
    vertices, _, _, tracker = tracked("u_tube")
    for push, is_wrong in ((0.3, False), (0.6, False), (0.75, True)):  # apart, touching, each around the other's axis
        frame = tracker.frame(0, pushed(vertices, push))
        assert frame.wants_run == is_wrong and (frame.crowded > 0.05) == is_wrong


def test_a_limb_that_has_grown_is_seen():
    """Out of the side of a limb, by three of its radii or ten; a swelling of one is none."""
    vertices, faces, skeleton, tracker = tracked("y")
    normal = trimesh.Trimesh(vertices, faces, process=False).vertex_normals
    middle = skeleton.vertices[np.argmax(skeleton.radii)]
    top = np.argmin(np.linalg.norm(vertices - middle, axis=1))
    radius = skeleton.radii[skeleton.mesh_map[top]]
    bump = np.exp(-(((vertices - vertices[top]) / radius) ** 2).sum(axis=1)) * (normal @ normal[top] > 0)
    for radii, is_wrong in ((0.25, False), (1, False), (3, True), (10, True)):
        frame = tracker.frame(0, vertices + radii * radius * bump[:, None] * normal[top])
        assert frame.wants_run == is_wrong and (frame.grown > 0.01) == is_wrong
    assert "% grown; needs a fresh run" in str(frame)


def bent(vertices, skeleton, angle):
    """The whole mesh bent about y over 1.3 radii along z, where half of it is."""
    height, width = np.median(vertices[:, 2]), 1.3 * np.median(skeleton.radii)
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
    for angle in (30, 60, 75, 90):  # its inner side is folded from 75 degrees on
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
        assert not frame.wants_run
        np.testing.assert_allclose(frame.nodes, skeleton.vertices @ matrix.T, atol=1e-9)


def test_a_limb_that_has_been_drawn_in_is_seen():
    """A limb shrinks to a bud of a tenth of its size; one of 0.7 is right."""
    vertices, _, skeleton, tracker = tracked("y")
    path = next(np.array(branch.nodes) for branch in skeleton.branches)
    degree = np.bincount(skeleton.edges.ravel())
    path = path if degree[path[-1]] == 1 else path[::-1]
    radius = np.median(skeleton.radii[path])
    start = np.argmax(np.linalg.norm(skeleton.vertices[path] - skeleton.vertices[path[0]], axis=1) > 2 * radius)
    is_far = np.isin(skeleton.mesh_map, path[start:])
    root = skeleton.vertices[path[start]]
    for left, is_wrong in ((0.7, False), (0.1, True)):
        moved = np.where(is_far[:, None], root + left * (vertices - root), vertices)
        frame = tracker.frame(0, moved)
        assert frame.wants_run == is_wrong, str(frame)


@pytest.mark.slow  # that a bend is none is quick
def test_noise_of_a_thousandth_is_no_fault():
    """Also if balls do not cover much of a body, and if the mesh of the run crosses itself."""
    capsule = ground_truth.swept_tube(np.linspace([0, 0, 0], [0, 0, 2], 30), np.full(30, 0.3), 10, "round")
    two = trimesh.util.concatenate([capsule, capsule.copy().apply_translation([0.5, 0, 0])])
    for mesh in (ground_truth.make("octopus_low").mesh, two):
        vertices, random = np.array(mesh.vertices), np.random.default_rng(0)
        tracker, diagonal = Tracker(msf_jax.skeletonize(mesh)), np.linalg.norm(np.ptp(mesh.vertices, axis=0))
        frames = [tracker.frame(0, vertices + random.normal(0, 1e-3 * diagonal, vertices.shape)) for _ in range(10)]
        assert [str(frame) for frame in frames if frame.wants_run] == []
