"""The shapes that skeletons are scored on: closed, of the genus they claim, and around their true curve."""

from dataclasses import dataclass
from functools import cached_property

import networkx as nx
import numpy as np
import pytest
import trimesh

from msf_jax import ground_truth
from msf_jax.base.errors import ConfigError
from msf_jax.ground_truth import KnownShape
from msf_jax.meshes import checking
from msf_jax.solid.enclosure import Enclosure

NAMES = ground_truth.names()
SMOOTH = [name for name in NAMES if not name.endswith(("_coarse", "_noisy", "_low")) and name != "sheet_and_limb"]
JOINTED = ["y", "tee", "tree", "star", "comb", "theta", "hand", "cube_frame", "y_fine"]


@dataclass(frozen=True)
class Case:
    """A shape, points all along its true curve with the radius there, and what tells the mesh's side."""

    shape: KnownShape

    @cached_property
    def enclosure(self) -> Enclosure:
        return Enclosure(np.asarray(self.shape.mesh.vertices), np.asarray(self.shape.mesh.faces))

    @cached_property
    def samples(self) -> tuple[np.ndarray, np.ndarray]:
        """At most 500 points (S, 3) on the curve and the radius (S,) of each, none near a tip."""
        shape, (a, b) = self.shape, self.shape.edges.T
        t = np.linspace(0, 1, max(2, 500 // len(a)), endpoint=False)[:, None, None]
        points = ((1 - t) * shape.points[a] + t * shape.points[b]).reshape(-1, 3)
        radii = ((1 - t[..., 0]) * shape.radii[a] + t[..., 0] * shape.radii[b]).ravel()
        is_away = self.away(points, shape.tips, 0.3 * shape.tip_radii)
        points, radii = points[is_away], radii[is_away]
        chosen = np.unique(np.linspace(0, len(points) - 1, 500).astype(int))
        return points[chosen], radii[chosen]

    @cached_property
    def degree(self) -> np.ndarray:
        return np.bincount(self.shape.edges.ravel(), minlength=len(self.shape.points))

    @staticmethod
    def away(points: np.ndarray, places: np.ndarray, distances: np.ndarray) -> np.ndarray:
        """(P,) True where a point is farther from each place than that place's distance."""
        return (np.linalg.norm(points[:, None] - places, axis=2) > distances).all(axis=1)


@pytest.fixture(scope="module", params=NAMES)
def case(request) -> Case:
    return Case(ground_truth.make(request.param))


def test_the_mesh_is_closed_oriented_and_of_its_genus(case):
    mesh = case.shape.mesh
    assert mesh.is_watertight and mesh.is_winding_consistent and mesh.volume > 0
    assert mesh.body_count == 1
    assert mesh.euler_number == 2 - 2 * case.shape.genus
    assert np.isfinite(mesh.vertices).all() and len(np.unique(mesh.faces)) == len(mesh.vertices)


def test_the_mesh_needs_no_repair(case):
    checked = checking.prepare(case.shape.mesh)
    assert checked.repairs == () and [component.genus for component in checked.components] == [case.shape.genus]


def test_the_mesh_is_as_large_as_it_should_be(case):
    name, num = case.shape.name, len(case.shape.mesh.vertices)
    if name.endswith("_low"):
        low, high = 420, 520
    elif case.shape.is_coarse:
        low, high = 100, 3_000
    elif name.endswith("_fine"):
        low, high = 20_000, 30_000
    else:
        low, high = 1_500, 9_000 if name == "hand" else 6_200
    assert low <= num <= high


def test_the_curve_is_inside(case):
    points, _ = case.samples
    assert len(points) > 20
    assert (case.enclosure.winding_numbers(points) == 1).all()  # 2 would be a tube that crosses itself


@pytest.mark.parametrize("case", SMOOTH, indirect=True)
def test_the_radius_is_the_distance_to_the_surface(case):
    shape = case.shape
    assert shape.is_tube and not shape.is_noisy and not shape.is_coarse
    points, radii = case.samples
    joint = case.degree > 2
    is_plain = case.away(points, shape.tips, 1.5 * shape.tip_radii)
    is_plain &= case.away(points, shape.points[joint], 3 * shape.radii[joint])
    assert is_plain.sum() > 20
    ratio = case.enclosure.distances(points[is_plain]) / radii[is_plain]
    if shape.name == "hand":  # fingers of few grid cells; fillets, wide enough to thicken the palm and the handle
        assert ratio.min() > 0.85 and ratio.max() < 1.45
    else:
        assert ratio.min() > 0.93 and ratio.max() < 1.07


@pytest.mark.parametrize("case", JOINTED, indirect=True)
def test_a_ball_at_a_joint_fits_in(case):
    """Limbs that meet leave room for the larger of them at least."""
    shape, joint = case.shape, case.degree > 2
    assert joint.any() and (case.enclosure.distances(shape.points[joint]) > 0.9 * shape.radii[joint]).all()


def test_tips_are_on_the_surface(case):
    shape = case.shape
    assert shape.tips.shape == (shape.num_leaves, 3) and shape.tip_radii.shape == (shape.num_leaves,)
    if shape.num_leaves:
        gap = case.enclosure.distances(shape.tips) / shape.tip_radii
        assert (shape.tip_radii > 0).all() and (gap < (0.2 if shape.is_coarse else 0.12)).all()


def test_every_end_of_the_curve_is_a_tip(case):
    shape = case.shape
    ends = shape.points[case.degree == 1]
    if shape.name == "sheet_and_limb":  # the limb's curve also ends in the plate, where no tip is
        ends = ends[case.enclosure.distances(ends) < 0.1 * shape.tip_radii]
    assert len(ends) == shape.num_leaves
    np.testing.assert_array_equal(ends, shape.tips)
    assert (shape.radii < 1e-9).sum() == shape.num_leaves


def test_the_curve_has_as_many_loops_as_the_mesh_has_handles(case):
    shape = case.shape
    graph = nx.Graph(shape.edges.tolist())
    assert sorted(graph) == list(range(len(shape.points))) and nx.is_connected(graph)
    assert len(shape.edges) == graph.number_of_edges() and len(shape.radii) == len(shape.points)
    if shape.is_tube:
        assert len(shape.edges) - len(shape.points) + 1 == shape.genus


def test_the_names():
    assert len(set(NAMES)) == len(NAMES)
    leaves = {"straight": 2, "y": 3, "tree": 7, "star": 6, "comb": 7, "hand": 5, "octopus_low": 8, "sheet_and_limb": 1}
    for name, num in leaves.items():
        shape = ground_truth.make(name)
        assert shape.name == name and shape.num_leaves == num


@pytest.mark.parametrize("name", ["arc", "y_coarse", "ring_noisy", "octopus_low"])
def test_a_shape_is_the_same_each_time(name):
    first, again = ground_truth.make(name), ground_truth.make(name)
    np.testing.assert_array_equal(first.mesh.vertices, again.mesh.vertices)
    np.testing.assert_array_equal(first.mesh.faces, again.mesh.faces)
    np.testing.assert_array_equal(first.points, again.points)


def test_noise_has_the_size_it_is_asked_for():
    shape = ground_truth.make("straight")
    noisy_shape = ground_truth.noisy(shape, 0.004, 7)
    shift = noisy_shape.mesh.vertices - shape.mesh.vertices
    along = (shift * shape.mesh.vertex_normals).sum(axis=1)
    np.testing.assert_allclose(np.abs(along), np.linalg.norm(shift, axis=1), atol=1e-12)
    assert along.std() == pytest.approx(0.004 * np.linalg.norm(shape.mesh.extents), rel=0.05)
    assert noisy_shape.is_noisy and not shape.is_noisy and noisy_shape.points is shape.points


@pytest.mark.parametrize("sides", [3, 6, 11])
@pytest.mark.parametrize("ends", ["flat", "round"])
def test_a_tube_of_any_number_of_sides_is_closed(sides, ends):
    t = np.linspace(0, 1, 100)
    points, radii = np.stack([np.cos(2 * t), np.sin(3 * t), t], axis=1), 0.1 + 0.05 * t
    mesh = ground_truth.swept_tube(points, radii, sides, ends)
    assert mesh.is_watertight and mesh.is_winding_consistent and mesh.volume > 0 and mesh.euler_number == 2


@pytest.mark.parametrize("sides", [3, 4, 7, 12])
def test_a_closed_tube_closes_without_a_seam(sides):
    """A curve out of the plane turns its frame; where the last ring meets the first, triangles are as everywhere."""
    t = 2 * np.pi * np.arange(300) / 300
    points = np.stack([np.cos(t), np.sin(t), 0.4 * np.sin(2 * t) + 0.2 * np.cos(3 * t)], axis=1)
    mesh = ground_truth.swept_tube(points, np.full(300, 0.15), sides, closed=True)
    assert mesh.is_watertight and mesh.is_winding_consistent and mesh.volume > 0 and mesh.euler_number == 0
    assert np.ptp(np.bincount(mesh.faces.ravel())) == 0  # every vertex of degree 6
    seam = np.isin(mesh.faces, np.arange(sides)).any(axis=1)
    edges = np.linalg.norm(mesh.triangles - np.roll(mesh.triangles, 1, axis=1), axis=2)
    assert edges[seam].max() < 1.1 * edges[~seam].max()


def test_a_mesh_is_found_by_name(tmp_path, monkeypatch):
    """Made here, or read from the reader's folder; else the error lists what there is."""
    monkeypatch.setenv("MSF_JAX_MESHES", str(tmp_path))
    ball = trimesh.creation.icosphere(2)
    ball.export(tmp_path / "ball.off")
    assert np.array_equal(ground_truth.mesh_named("ball").faces, ball.faces)
    assert np.array_equal(ground_truth.mesh_named("y").vertices, ground_truth.make("y").mesh.vertices)
    with pytest.raises(ConfigError, match="cube_frame"):
        ground_truth.mesh_named("bal")
