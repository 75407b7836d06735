"""Parts that belong together become one solid: what is joined, over which gap, and that all speak of the caller's."""

import numpy as np
import pytest
import trimesh

import msf_jax
from msf_jax import Config, ConfigError, MeshError, Repair, Weights
from msf_jax.app.cli import main
from msf_jax.meshes import checking
from tests.benchmarks import faults, ground_truth

BALL = trimesh.creation.icosphere(2)
QUICK = Config(max_iterations=1)


def ball(at: tuple[float, float, float], size: float = 1.0) -> faults.Pair:
    """A sphere of 162 vertices."""
    return np.array(BALL.vertices) * size + at, np.array(BALL.faces)


def beads(gap: float, num: int = 4) -> faults.Pair:
    """Balls of radius 1 in a row."""
    return faults.joined(*(ball(((2 + gap) * k, 0, 0)) for k in range(num)))


def overlapping() -> faults.Pair:
    """Two cubes of edge 1, a corner of each inside the other; they share a cube of edge 0.45."""
    return faults.joined(faults.box(), faults.box((0.55, 0.55, 0.55)))


def volume(found: checking.Surface) -> float:
    """By the divergence theorem."""
    return float(np.linalg.det(found.vertices[found.faces]).sum() / 6)


def test_parts_that_overlap_are_one():
    mesh = overlapping()
    found = checking.prepare(mesh, "join")
    assert [part.genus for part in found.components] == [0]
    assert volume(found) == pytest.approx(2 - 0.45**3, rel=0.01)
    assert found.repairs == ("joined 2 parts that overlap or touch to 1 solid",)


def test_what_is_not_the_callers_is_known():
    vertices, _ = mesh = overlapping()
    found = checking.prepare(mesh, "join")
    own = ~found.is_made
    np.testing.assert_array_equal(found.vertices[own], vertices[found.input_of_vertex[own]])
    row = found.vertex_of_input[found.input_of_vertex]
    np.testing.assert_array_equal(row[own], np.flatnonzero(own))
    first, second = vertices[:98], vertices[98:]
    is_inside = np.concatenate([(first > 0.05).all(axis=1), (second < 0.5).all(axis=1)])
    assert is_inside.sum() > 1
    np.testing.assert_array_equal(found.vertex_of_input < 0, is_inside)
    np.testing.assert_array_equal(found.strays, vertices[is_inside])
    away = np.linalg.norm(found.vertices - vertices[found.input_of_vertex], axis=1)
    assert found.is_made.any() and away[found.is_made].max() < 0.3  # a face's edge is 0.25


def test_beads_that_nearly_touch_become_a_string():
    found = checking.prepare(beads(0.1), "join")
    assert [part.genus for part in found.components] == [0]
    (line,) = found.repairs[1:]
    assert line.startswith("joined 4 solids to 1 at 3 places over gaps of up to ")
    told = float(line.split("up to ")[1].split()[0])
    assert 0.07 < told < 0.11  # the union is of parts that are a hundredth of a radius larger


def test_beads_that_touch_become_a_string():
    found = checking.prepare(beads(0.0), "join")
    assert [part.genus for part in found.components] == [0]
    assert found.repairs == ("joined 4 parts that overlap or touch to 1 solid",)


def test_parts_that_are_far_apart_stay_apart():
    found = checking.prepare(beads(3.0, 2), "join")
    assert len(found.components) == 2 and volume(found) == pytest.approx(2 * BALL.volume)
    assert any(line.startswith("left 2 solids apart: the largest is 2.9") for line in found.repairs)
    assert len(checking.prepare(beads(3.0, 2), Repair(join=0.5)).components) == 1


def test_no_gap_is_bridged_where_none_is_asked_for():
    assert len(checking.prepare(beads(0.1), Repair(join=0.0)).components) == 4
    touching = faults.joined(faults.box(), faults.box((1, 0, 0)))
    assert len(checking.prepare(touching, Repair(join=0.0)).components) == 1
    assert len(checking.prepare(beads(0.0), True).components) == 4


def test_a_handle_is_a_loop():
    ring = trimesh.creation.torus(1.0, 0.2, major_sections=24, minor_sections=8)
    block = trimesh.creation.box([1.0, 3.0, 1.0]).subdivide()
    found = checking.prepare(faults.joined(faults.pair(ring), (block.vertices - [1.2, 0, 0], block.faces)), "join")
    assert [part.genus for part in found.components] == [1]


def test_ends_of_a_tube_that_lie_in_each_other_are_one_place():
    """Of one turn, with round ends, whose tips are in the tube and cross nothing."""
    angle = np.linspace(0, 2 * np.pi, 200)
    circle = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    tube = ground_truth.swept_tube(circle, np.full(200, 0.15), 10, "round")
    found = checking.prepare(faults.pair(tube), "join")
    assert [part.genus for part in found.components] == [1]


def test_a_pin_fills_its_hole_without_slits():
    """Their faces lie on each other, but for the tessellation: 24 sections in 30."""
    nut = trimesh.creation.annulus(1.0, 2.0, 1.0, sections=30)
    pin = trimesh.creation.cylinder(1.0, 3.0, sections=24)
    found = checking.prepare(faults.joined(faults.pair(nut), faults.pair(pin)), "join")
    assert [part.genus for part in found.components] == [0]


def test_what_is_inside_another_goes():
    found = checking.prepare(faults.joined(ball((0, 0, 0)), ball((0, 0, 0), 0.5)), "join")
    assert volume(found) == pytest.approx(BALL.volume) and not found.is_made.any()
    np.testing.assert_array_equal(found.vertex_of_input < 0, np.arange(324) >= 162)


def test_the_callers_vertices_pins_and_weights_are_understood():
    vertices, _ = mesh = overlapping()
    corner = int(np.flatnonzero((vertices == -0.5).all(axis=1))[0])
    swallowed = int(np.flatnonzero((vertices == 0.5).all(axis=1))[0])
    weights = Weights(w_H=np.linspace(0.1, 0.2, len(vertices)))
    run = msf_jax.contract(mesh, weights, QUICK, pins=[corner], repair="join")
    skeleton = run.skeleton
    assert len(skeleton.mesh_map) == len(vertices) and skeleton.source.areas.sum() == pytest.approx(1.0)
    np.testing.assert_array_equal(skeleton.vertices[skeleton.mesh_map[corner]], vertices[corner])
    nearest = np.linalg.norm(skeleton.vertices - vertices[swallowed], axis=1).argmin()
    assert skeleton.mesh_map[swallowed] == nearest
    with pytest.raises(ConfigError, match=f"pins has vertex {swallowed}"):
        msf_jax.contract(mesh, config=QUICK, pins=[swallowed], repair="join")


@pytest.mark.slow  # that of another repair is in test_repair, and what a run says of it above
@pytest.mark.usefixtures("few_rows_once")
def test_the_tape_of_joined_parts_knows_the_run():
    vertices, _ = mesh = overlapping()
    weights = Weights(w_H=np.linspace(0.1, 0.2, len(vertices)))
    run = msf_jax.contract(mesh, weights, QUICK, repair="join")
    tape = run.tape
    nodes = np.asarray(msf_jax.replay(tape, weights))
    assert np.abs(nodes - run.curve.vertices).max() < 1e-9
    with pytest.raises(MeshError, match="repair made vertices where it joined parts"):
        msf_jax.replay(tape, weights, vertices)


@pytest.mark.slow  # the option is one of `repair` above
def test_the_command_line_joins(tmp_path, capsys):
    vertices, faces = overlapping()
    path, out = tmp_path / "boxes.off", tmp_path / "boxes.npz"
    trimesh.Trimesh(vertices, faces, process=False).export(path)
    assert main(["skeletonize", str(path), "-o", str(out), "--max-iterations", "2", "--repair", "join"]) == 0
    assert "joined 2 parts" in capsys.readouterr().out
    assert main(["skeletonize", str(path), "--max-iterations", "2", "-o", str(out), "--repair"]) == 0
    assert "joined" not in capsys.readouterr().out
