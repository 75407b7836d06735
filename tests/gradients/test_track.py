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
from msf_jax.gradients import track as tracking
from msf_jax.gradients.track import Tracker
from tests.benchmarks import ground_truth


@pytest.fixture(scope="module")
def tube():
    """A short straight tube, and its curve."""
    mesh = ground_truth.make("straight_coarse").mesh
    return np.array(mesh.vertices), np.array(mesh.faces), flow_of("straight_coarse").skeleton


def num_compiled() -> int:
    return getattr(tracking._followed, "_cache_size")()  # noqa: B009 - of JAX, without a type


def turned(vertices, angle):
    return vertices @ Rotation.from_rotvec([0, angle, 0.2]).as_matrix().T


def pinched(vertices, skeleton):
    """The tube with its middle crushed to a point."""
    middle = skeleton.vertices[np.linalg.norm(skeleton.vertices - vertices.mean(axis=0), axis=1).argmin()]
    is_near = np.linalg.norm(vertices - middle, axis=1) < 0.3
    return np.where(is_near[:, None], middle, vertices)


def test_every_frame_is_followed_and_compiled_for_once(tube):
    vertices, faces, skeleton = tube
    frames = [turned(vertices, angle) for angle in np.linspace(0, 1, 6)]
    msf_jax.track(skeleton, frames[:1])
    compiled = num_compiled()
    done = msf_jax.track(skeleton, frames)
    assert num_compiled() == compiled
    assert done.nodes.shape == (6, *skeleton.vertices.shape) and done.radii.shape == (6, len(skeleton.vertices))
    for number, (frame, angle) in enumerate(zip(done.frames, np.linspace(0, 1, 6), strict=True)):
        np.testing.assert_allclose(frame.nodes, turned(skeleton.vertices, angle), atol=1e-9)
        assert frame.number == number and frame.inside == 1.0 and not frame.wants_run
    assert str(done) == "6 frames, 0 of them need a fresh run"
    mixed = msf_jax.track(skeleton, iter([frames[1], (frames[1], faces), trimesh.Trimesh(frames[1], faces)]))
    np.testing.assert_array_equal(mixed.nodes[1:], mixed.nodes[:1].repeat(2, axis=0))
    # `follow` is another program, and a compiler may sum in another order: a few units in the last place of the size.
    alone, size = msf_jax.follow(skeleton, frames[1]).nodes, np.ptp(vertices, axis=0).max()
    np.testing.assert_allclose(mixed.nodes, alone[None].repeat(3, axis=0), rtol=0, atol=8 * np.spacing(size))


def test_frames_that_no_longer_hold_say_which_nodes(tube):
    """A tube that is crushed has lost a section; one whose vertices are shuffled is beyond any curve."""
    vertices, _, skeleton = tube
    shuffled = np.random.default_rng(0).permutation(vertices)
    done = msf_jax.track(skeleton, [vertices, pinched(vertices, skeleton), shuffled])
    assert [frame.wants_run for frame in done.frames] == [False, True, True]
    good, crushed, _ = done.frames
    assert 0 < len(crushed.vanished) < len(skeleton.vertices)
    assert np.isnan(crushed.nodes[crushed.vanished]).all() and np.isnan(crushed.nodes).any(axis=1).sum() == len(
        crushed.vanished
    )
    assert "2 of them need a fresh run" in str(done) and f"the first {crushed.vanished[0]}" in str(done)
    curve = done.curve(0)
    np.testing.assert_array_equal(curve.vertices, good.nodes)
    with pytest.raises(ConfigError, match="frame 1 has no curve"):
        done.curve(1)
    with pytest.raises(ConfigError, match="no frame 3: expected one of the 3"):
        done.curve(3)


def test_a_frame_without_extent_has_no_curve(tube):
    vertices, _, skeleton = tube
    done = msf_jax.track(skeleton, [0 * vertices, vertices.tolist()])
    assert len(done.frames[0].vanished) == len(skeleton.vertices) and np.isnan(done.frames[0].inside)
    assert not done.frames[1].wants_run


def test_a_node_that_leaves_the_solid_is_seen(tube):
    """The mesh turned inside out along its axis has its curve outside of nothing; one blown up keeps it."""
    vertices, _, skeleton = tube
    mirrored = vertices * [1, 1, -1]
    blown = 2 * vertices
    done = msf_jax.track(skeleton, [mirrored, blown])
    assert done.frames[0].inside == 0.0 and done.frames[0].wants_run
    assert done.frames[1].inside == 1.0 and not done.frames[1].wants_run


def test_a_frame_of_another_mesh_is_named(tube):
    vertices, faces, skeleton = tube
    with pytest.raises(MeshError, match=r"frame 1: vertices has shape"):
        msf_jax.track(skeleton, [vertices, vertices[1:]])
    with pytest.raises(MeshError, match=r"frame 1: 1 of the vertices, the first 3, are not finite"):
        msf_jax.track(skeleton, [vertices, np.where(np.arange(len(vertices))[:, None] == 3, np.inf, vertices)])
    with pytest.raises(MeshError, match=r"frame 0: its \d+ faces are not those"):
        msf_jax.track(skeleton, [(vertices, np.roll(faces, 1, axis=0)[:-1])])
    with pytest.raises(ConfigError, match="frames is a str"):
        msf_jax.track(skeleton, "frames")
    with pytest.raises(ConfigError, match="frames is empty"):
        msf_jax.track(skeleton, [])


@pytest.fixture
def folder(tube, tmp_path, monkeypatch):
    vertices, faces, skeleton = tube
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    (tmp_path / "frames").mkdir()
    for number in (10, 2, 1):
        mesh = trimesh.Trimesh(turned(vertices, number / 10), faces, process=False)
        mesh.export(tmp_path / "frames" / f"frame{number}.off")
    skeleton.save(tmp_path / "first.npz")
    return tmp_path


def test_the_command_writes_a_curve_for_every_frame(folder, tube, capsys):
    arguments = [str(folder / "first.npz"), str(folder / "frames"), "-o", str(folder / "out"), "--format", ".npz"]
    assert main(["track", *arguments]) == 0
    said = capsys.readouterr()
    assert "3 frames, 3 curves" in said.out and "\r" not in said.err  # no bar where there is no terminal
    rows = list(csv.DictReader((folder / "out" / "frames.csv").read_text().splitlines()))
    assert [row["mesh"] for row in rows] == ["frame1.off", "frame2.off", "frame10.off"]
    assert {row["wants_run"] for row in rows} == {"0"} and {row["inside"] for row in rows} == {"1"}
    curve = msf_jax.read_curve(folder / "out" / "frame10.npz")
    np.testing.assert_allclose(curve.vertices, turned(tube[2].vertices, 1.0), atol=1e-6)


def test_the_command_says_which_frame_is_bad(folder, tube, capsys):
    vertices, faces, skeleton = tube
    frames, first = folder / "frames", str(folder / "first.npz")
    trimesh.Trimesh(pinched(vertices, skeleton), faces, process=False).export(frames / "frame3.off")
    assert main(["track", first, str(frames), "-o", str(folder / "out"), "-q"]) == 1
    assert "frame3.off: frame 2: " in capsys.readouterr().err
    assert not (folder / "out" / "frame3.swc").exists() and (folder / "out" / "frame10.swc").exists()
    trimesh.creation.box().export(frames / "frame4.off")
    assert main(["track", first, str(frames), "-o", str(folder / "out"), "-q"]) == 2
    assert "'frame4.off', frame 3: its 12 faces" in capsys.readouterr().err
    assert len((folder / "out" / "frames.csv").read_text().splitlines()) == 1 + 3  # those before it
    assert main(["track", first, str(frames), "-o", str(frames), "-q"]) == 2
    assert main(["track", first, str(folder), "-o", str(folder / "out"), "-q"]) == 2
    assert "no mesh in" in capsys.readouterr().err


# What a frame is checked for


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
        assert len(frame.overlaps) > len(frame.nodes) / 2
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
        assert frame.wants_run == is_wrong and (len(frame.changed) > 0) == is_wrong
    assert "whose distance from the surface has changed" in str(frame)


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
        assert frame.wants_run == is_wrong and bool(frame.faults) == is_wrong


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
