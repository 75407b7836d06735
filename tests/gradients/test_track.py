"""Tracking: the same nodes in every frame, a report that tells good frames from bad, files on the command line."""

import csv

import numpy as np
import pytest
import trimesh
from run_cases import flow_of
from scipy.spatial.transform import Rotation

import msf_jax
from msf_jax import ConfigError, MeshError, ground_truth
from msf_jax.app.cli import main
from msf_jax.gradients import track as tracking


@pytest.fixture(scope="module")
def tube():
    """A short straight tube, and its curve."""
    mesh = ground_truth.make("straight_coarse").mesh
    return np.array(mesh.vertices), np.array(mesh.faces), flow_of("straight_coarse").skeleton


def num_compiled() -> int:
    return getattr(tracking._tracked, "_cache_size")()  # noqa: B009 - of JAX, without a type


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
    """A tube that is crushed has lost a section, one whose vertices are shuffled all of them; a sheared one leans."""
    vertices, _, skeleton = tube
    shuffled = np.random.default_rng(0).permutation(vertices)
    axis = np.linalg.svd(vertices - vertices.mean(axis=0))[2]
    leaning = vertices + 6 * (vertices @ axis[1])[:, None] * axis[0]
    done = msf_jax.track(skeleton, [vertices, pinched(vertices, skeleton), shuffled, leaning])
    assert [frame.wants_run for frame in done.frames] == [False, True, True, True]
    good, crushed, wild, sheared = done.frames
    assert 0 < len(crushed.vanished) < len(skeleton.vertices)
    assert np.isnan(crushed.nodes[crushed.vanished]).all() and np.isnan(crushed.nodes).any(axis=1).sum() == len(
        crushed.vanished
    )
    assert len(wild.loose) + len(wild.vanished) > len(skeleton.vertices) / 2
    assert len(sheared.loose) > len(skeleton.vertices) / 2 and not len(sheared.vanished)
    assert "3 of them need a fresh run" in str(done) and f"the first {crushed.vanished[0]}" in str(done)
    curve = done.curve(0)
    np.testing.assert_array_equal(curve.vertices, good.nodes)
    with pytest.raises(ConfigError, match="frame 1 has no curve"):
        done.curve(1)
    with pytest.raises(ConfigError, match="no frame 4: expected one of the 4"):
        done.curve(4)


def test_a_frame_without_extent_has_no_curve(tube):
    vertices, _, skeleton = tube
    done = msf_jax.track(skeleton, [0 * vertices, vertices.tolist()])
    assert len(done.frames[0].vanished) == len(skeleton.vertices) and done.frames[0].inside == 0.0
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
