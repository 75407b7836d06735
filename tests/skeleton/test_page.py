"""Pages and the camera: what is in them, where it is seen from, and that the slider names its own traces."""

import numpy as np
import pytest
import trimesh
from conftest import blob, torus
from mpl_toolkits.mplot3d import proj3d

import msf_jax
from msf_jax import Config, ConfigError, MeshError, shapes, view
from msf_jax.skeleton.skeleton import curve_of
from msf_jax.view import looking


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
    assert stages[0].iteration == 0 and stages[-1].iteration == skeleton.report.iterations
    surfaces = [trimesh.Trimesh(stage.vertices, stage.faces, process=False) for stage in stages]
    assert all(surface.is_watertight and surface.euler_number == 0 for surface in surfaces)
    assert surfaces[0].volume == pytest.approx(mesh.volume, rel=0.02)
    assert abs(surfaces[-1].volume) < 0.01 * surfaces[0].volume


def test_each_stop_of_the_slider_shows_its_own_trace(hand, drawn):
    skeleton, drawing = hand[0], drawn[0]
    names = [trace.name for trace in drawing.data]
    (contraction,) = drawing.layout.sliders
    shown = []
    for step in contraction.steps[1:]:
        style, traces = step.args
        (trace,) = (trace for trace, is_shown in zip(traces, style["visible"], strict=True) if is_shown)
        shown.append(trace)
    assert shown == list(range(1, len(names) - 1))
    assert names == ["surface", *(f"after {stage.iteration} iterations" for stage in skeleton.source.stages), "curve"]
    assert not any(contraction.steps[0].args[0]["visible"])
    assert len(drawing.data[-1].x) == 3 * len(skeleton.edges)


def test_the_page_is_one_file(hand, drawn, tmp_path):
    (skeleton, mesh), text = hand, drawn[1]
    assert "Plotly.newPlot" in text and f"{len(skeleton.vertices)} nodes, " in text and len(text) > 1e6
    with pytest.raises(ConfigError, match=r"written as .html, not as '.png'"):
        skeleton.view(mesh, tmp_path / "hand.png")
    with pytest.raises(MeshError, match="expected the same mesh"):
        skeleton.view(torus())


def test_all_is_in_view(hand):
    """Through plotly's camera, an eye with 45 degrees from top to bottom."""
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
        right = np.cross(ahead, up) / np.linalg.norm(np.cross(ahead, up))
        depth = (points - eye) @ ahead
        seen = (points - eye) @ np.stack([right, np.cross(right, ahead)], axis=1) / depth[:, None]
        assert (depth > 0).all() and 0.5 < np.abs(seen).max() / np.tan(np.radians(22.5)) <= 1


@pytest.mark.parametrize(
    ("extents", "axis", "up"),
    [
        ((3.0, 0.6, 6.0), 1, 2),  # a person, z up
        ((3.0, 6.0, 0.6), 2, 1),  # y up
        ((0.6, 3.0, 6.0), 0, 2),  # facing along x
        ((0.6, 6.0, 3.0), 0, 1),
        ((0.8, 4.0, 3.0), 0, 2),  # an animal
        ((0.8, 3.0, 4.0), 0, 1),
        ((6.0, 3.0, 0.6), 2, 1),  # on the table
        ((2, 2, 2), 1, 2),  # no axis is the shortest
    ],
)
def test_a_thing_is_seen_along_its_shortest_axis_and_the_right_way_up(extents, axis, up):
    """By plotly and by matplotlib: what is up is up in the picture, and the eye is in front."""
    vertices = trimesh.creation.box(extents).vertices + [100, -50, 3]
    curve = curve_of(vertices, np.array([[0, 1]]), np.ones(8))
    assert looking(vertices)[0] == up
    camera = curve.view().layout.scene.camera
    eye = np.array([camera.eye[one] for one in "xyz"])
    assert np.abs(eye).argmax() == axis and camera.up["xyz"[up]] == 1
    assert eye @ ([0.5, -1, 0] if up == 2 else [0.5, 0, 1]) > 0
    shown = view.panels([view.Panel(points=vertices)]).axes[0]
    middle = vertices.mean(axis=0)
    x, y, depth = proj3d.proj_transform(
        *np.stack([middle, middle + 0.1 * np.eye(3)[up], middle + 0.1 * eye]).T, shown.get_proj()
    )
    assert y[1] > y[0] and abs(x[1] - x[0]) < 0.05 * (y[1] - y[0]) and depth[2] != depth[0]
    assert abs(x[2] - x[0]) + abs(y[2] - y[0]) < 0.2 * (y[1] - y[0])


@pytest.mark.slow  # one of a run is above
def test_a_curve_of_a_file_and_one_of_a_single_node_can_be_viewed(tmp_path):
    (tmp_path / "a.swc").write_text("1 0 0 0 0 1 -1\n2 0 1 0 0 1 1\n")
    assert len(msf_jax.read_curve(tmp_path / "a.swc").view().data) == 1
    alone = curve_of(np.zeros((1, 3)), np.empty((0, 2), int), np.ones(1)).view()
    assert np.isfinite(list(alone.layout.scene.camera.eye.to_plotly_json().values())).all()


def test_a_page_far_from_the_origin_keeps_its_shape():
    """Coordinates go into the page as float32: a million away, nothing else would be left of a unit. A curve of another
    program has no map, so that its surface is grey only."""
    ball = blob(3)
    far = curve_of(1e7 + np.array([[0, 0, 0], [0, 0, 0.1]]), np.array([[0, 1]]), np.ones(2))
    drawing = far.view((ball.vertices + 1e7, ball.faces))
    shown = np.stack([np.asarray(drawing.data[0][axis], dtype=np.float64) for axis in "xyz"], axis=1)
    assert np.allclose(np.ptp(shown, axis=0), np.ptp(ball.vertices, axis=0), atol=1e-6)
    assert [trace.name for trace in drawing.data] == ["surface", "curve"]
