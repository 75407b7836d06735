"""The page and the segments: what is in them, and that the sliders name the traces that they should."""

import re
from dataclasses import replace

import numpy as np
import pytest
import trimesh
from conftest import blob, torus

import msf_jax
from msf_jax import Config, ConfigError, MeshError, shapes
from msf_jax.app.cli import main
from msf_jax.skeleton.skeleton import curve_of
from tests.benchmarks import ground_truth


@pytest.fixture(scope="module")
def hand():
    mesh = shapes.hand(0.1)
    return msf_jax.skeletonize(mesh, config=Config(least_slenderness=0.0)), mesh


@pytest.fixture(scope="module")
def drawn(hand, tmp_path_factory):
    """Plotly's figure of the hand, and the text of its page."""
    skeleton, mesh = hand
    path = tmp_path_factory.mktemp("drawn") / "hand.html"
    return skeleton.view(mesh, path), path.read_text()


def test_stages_lead_from_the_mesh_to_the_meso_skeleton(hand):
    skeleton, mesh = hand
    stages = skeleton.source.stages
    assert [stage.iteration for stage in stages] == sorted({stage.iteration for stage in stages})
    assert stages[0].iteration == 0 and stages[-1].iteration == skeleton.report.iterations
    for stage in stages:
        surface = trimesh.Trimesh(stage.vertices, stage.faces, process=False)
        assert surface.is_watertight and surface.euler_number == 0 and len(stage.is_fixed) == len(stage.vertices)
    volumes = [abs(trimesh.Trimesh(stage.vertices, stage.faces, process=False).volume) for stage in stages]
    assert volumes[0] == pytest.approx(mesh.volume, rel=0.02) and volumes[-1] < 0.01 * volumes[0]
    assert not stages[0].is_fixed.any() and stages[-1].is_fixed.sum() == skeleton.report.fixed


def test_each_stop_of_a_slider_shows_its_own_traces(hand, drawn):
    skeleton, drawing = hand[0], drawn[0]
    names = [trace.name for trace in drawing.data]
    contraction, pruning = drawing.layout.sliders
    for stage, step in zip(skeleton.source.stages, contraction.steps[1:], strict=True):
        shown, traces = step.args
        visible = [names[trace] for trace, is_shown in zip(traces, shown["visible"], strict=True) if is_shown]
        assert visible == [f"after {stage.iteration} iterations", "fixed vertices"]
    assert not any(contraction.steps[0].args[0]["visible"])
    sizes = []
    for step in pruning.steps:
        shown, traces = step.args
        (trace,) = (trace for trace, is_shown in zip(traces, shown["visible"], strict=True) if is_shown)
        assert names[trace] == "curve"
        sizes.append(len(drawing.data[trace].x))
    assert len(sizes) > 1 and sizes == sorted(sizes, reverse=True)
    assert sizes[0] == 3 * len(skeleton.edges)
    touched = {trace for slider in drawing.layout.sliders for trace in slider.steps[0].args[1]}
    assert touched | {0, 1} == set(range(len(names)))


def test_the_page_is_one_file_that_needs_no_network(hand, drawn, tmp_path):
    (skeleton, mesh), text = hand, drawn[1]
    assert not re.search(r"<(script|link|img)[^>]+(src|href)=(?!.data:,)", text)
    assert "Plotly.newPlot" in text and f"{len(skeleton.vertices)} nodes, 1 cycle for genus 1, " in text
    with pytest.raises(ConfigError, match=r"written as .html, not as '.png'"):
        skeleton.view(mesh, tmp_path / "hand.png")
    with pytest.raises(MeshError, match="expected the same mesh"):
        skeleton.view(torus())


def test_all_is_in_view_and_stays_where_it_is(hand):
    """Through plotly's camera, an eye with 45 degrees from top to bottom; hiding a part does not move the rest."""
    skeleton, mesh = hand
    for stretch in ((1, 1, 1), (6, 1, 1), (1, 1, 0.01)):
        curve = curve_of(skeleton.vertices * stretch, skeleton.edges, skeleton.radii)
        drawing = curve.view((mesh.vertices * stretch, mesh.faces))
        scene = drawing.layout.scene
        limits = np.array([scene[f"{axis}axis"].range for axis in "xyz"], dtype=float).T
        points = np.stack([np.asarray(drawing.data[0][axis], dtype=float) for axis in "xyz"], axis=1)
        assert ((points >= limits[0] - 1e-6) & (points <= limits[1] + 1e-6)).all()
        points = (points - limits.mean(axis=0)) / np.linalg.norm(np.ptp(limits, axis=0))
        eye, up = (np.array([scene.camera[part][axis] for axis in "xyz"]) for part in ("eye", "up"))
        ahead = -eye / np.linalg.norm(eye)
        depth = (points - eye) @ ahead
        assert (depth > 0).all()
        height = (points - eye) @ up / depth / np.tan(np.radians(22.5))
        width = (points - eye) @ np.cross(ahead, up) / depth / np.tan(np.radians(22.5))
        assert np.abs(height).max() <= 1 and np.abs(width).max() <= 1.3
        assert max(np.abs(height).max(), np.abs(width).max() / 1.3) > 0.75


@pytest.mark.slow  # one of a run is above
def test_a_curve_of_a_file_and_one_of_a_single_node_can_be_viewed(tmp_path):
    (tmp_path / "a.swc").write_text("1 0 0 0 0 1 -1\n2 0 1 0 0 1 1\n")
    assert len(msf_jax.read_curve(tmp_path / "a.swc").view().data) == 1
    limb = ground_truth.make("straight_coarse").mesh
    assert len(msf_jax.skeletonize(limb).view(limb).data) > 3
    alone = curve_of(np.zeros((1, 3)), np.empty((0, 2), int), np.ones(1)).view(None, tmp_path / "alone.html")
    assert (tmp_path / "alone.html").stat().st_size > 1e6
    assert np.isfinite(list(alone.layout.scene.camera.eye.to_plotly_json().values())).all()
    large = curve_of(np.array([[0, 0, 0], [1e120, 0, 0]]), np.array([[0, 1]]), np.ones(2)).view()
    assert np.isfinite(list(large.layout.scene.camera.eye.to_plotly_json().values())).all()


def test_segments_share_the_surface_between_the_branches(hand):
    skeleton, mesh = hand
    parts = skeleton.segments(mesh)
    assert len(parts) == len(skeleton.branches)
    assert sum(len(part.faces) for part in parts) == len(mesh.faces)
    assert sum(part.area for part in parts) == pytest.approx(mesh.area)
    for number, part in enumerate(parts):
        if len(part.faces):
            of_corner = part.vertex_attributes["branch"][part.faces]
            assert ((of_corner == number).sum(axis=1) >= 2).mean() > 0.7
            node = part.vertex_attributes["node"]
            np.testing.assert_array_equal(part.vertex_attributes["radius"], skeleton.radii[node])
    colours = {tuple(part.visual.face_colors[0]) for part in parts if len(part.faces)}
    assert len(colours) == sum(bool(len(part.faces)) for part in parts)


def test_segments_are_in_one_piece_with_even_borders():
    """A tube has three branches. Its vertices have the nearest, except for a speck. A file with UVs has a seam."""
    shape = ground_truth.make("straight")
    along = (shape.mesh.vertices - shape.points[0]) @ (shape.points[-1] - shape.points[0]) / 2.2**2
    third = np.minimum((3 * np.clip(along, 0, 1)).astype(int), 2)
    near = np.argsort(np.linalg.norm(shape.mesh.vertices - shape.mesh.vertices[third == 1][0], axis=1))
    third[near[:7]] = 2
    nodes = shape.points[0] + np.linspace(0, 1, 4)[:, None] * (shape.points[-1] - shape.points[0])
    twigs = nodes[1:3] + 0.01
    edges = np.array([[0, 1], [1, 2], [1, 4], [2, 3], [2, 5]])  # two twigs, so that there are three branches
    curve = curve_of(np.concatenate([nodes, twigs]), edges, np.full(6, 0.1))
    number = {tuple(sorted(branch.nodes)): k for k, branch in enumerate(curve.branches)}
    is_other = np.arange(len(shape.mesh.faces)) % 2 == 1
    doubled = shape.mesh.faces + len(shape.mesh.vertices) * is_other[:, None]
    for vertices, faces in (
        (shape.mesh.vertices, shape.mesh.faces),
        (np.tile(shape.mesh.vertices, (2, 1)), doubled),
    ):
        node = np.array([0, 1, 3])[third]
        mesh_map = np.tile(node, len(vertices) // len(third))
        parts = replace(curve, mesh_map=mesh_map).segments((vertices, faces))
        given = [parts[number[ends]] for ends in ((0, 1), (1, 2), (2, 3)) if len(parts[number[ends]].faces)]
        assert len(given) >= 2
        for part in given:
            joined = trimesh.Trimesh(part.vertices, part.faces, process=False)
            joined.merge_vertices()
            assert joined.body_count == 1


@pytest.mark.slow  # a page is above, and what a command takes in test_cli
def test_view_and_completion_on_the_command_line(tmp_path, capsys):
    mesh = tmp_path / "limb.off"
    ground_truth.make("straight_coarse").mesh.export(mesh)
    assert main(["view", str(mesh), "-q"]) == 0
    assert (tmp_path / "limb.html").stat().st_size > 1e6
    assert main(["view", str(mesh), "-o", str(tmp_path / "limb.pdf")]) == 2
    assert "ends in .html" in capsys.readouterr().err
    assert main(["completion", "bash"]) == 0
    assert "msf" in capsys.readouterr().out


def test_a_page_far_from_the_origin_keeps_its_shape():
    """Coordinates go into the page as float32: a million away, nothing else would be left of a unit."""
    ball = blob(3)
    far = curve_of(1e7 + np.array([[0, 0, 0], [0, 0, 0.1]]), np.array([[0, 1]]), np.ones(2))
    drawing = far.view((ball.vertices + 1e7, ball.faces))
    shown = np.stack([np.asarray(drawing.data[0][axis], dtype=np.float64) for axis in "xyz"], axis=1)
    assert np.allclose(np.ptp(shown, axis=0), np.ptp(ball.vertices, axis=0), atol=1e-6)


def test_a_curve_of_another_program_is_shown_in_its_mesh():
    """It has no map, so that its surface is grey only."""
    ball = blob(3)
    curve = curve_of(np.array([[0, 0, 0], [0, 0, 0.1]]), np.array([[0, 1]]), np.ones(2))
    names = [trace.name for trace in curve.view(ball).data]
    assert names[0] == "surface" and "surface by node" not in names


def test_a_path_given_as_the_mesh_is_told():
    with pytest.raises(ConfigError, match=r"path='hand\.html'"):
        curve_of(np.zeros((1, 3)), np.empty((0, 2), int), np.ones(1)).view("hand.html")
