"""The passes over a curve that finish it, and shapes whose curve is known."""

import manifold3d
import numpy as np
import pytest
from curve_cases import bored, draft_of, job_of, rank, unit_shape
from run_cases import flow_of
from scipy import spatial

import msf_jax
from msf_jax import Config, CurveOptions, PreprocessingOptions, metrics
from msf_jax.curve import finishing
from tests.benchmarks import ground_truth


def test_centring_folds_no_loop_flat():
    """One that is nearly inside a single ball, around a bore that is far finer than the limb."""
    line = np.linspace([0, 0, 0], [2, 0, 0], 60)
    rod = manifold3d.Manifold.cylinder(2.0, 0.15, 0.15, 16).rotate((0.0, 90.0, 0.0))
    shape, scale = unit_shape(bored(rod, line[31, :2], 0.004))
    axis = scale * line[[5, 30, 32]]
    away = np.array([0, 0.01, 0])
    x = np.concatenate([axis[:2], [axis[2] + away, axis[2] - away]])
    draft = draft_of(x, np.array([[0, 1], [1, 2], [2, 3], [1, 3]]))
    assert rank(shape, draft) == rank(shape, finishing.centre_and_meet(draft, job_of(shape), hold_leaves=False)) == 1


def score(shape, skeleton):
    """Mean distances to and from the true curve over the tube's radius, and the worst gap at a tip over its own."""
    figures = metrics.evaluate(shape.mesh, skeleton, truth=(shape.points, shape.edges))
    size = np.linalg.norm(np.ptp(shape.mesh.vertices, axis=0))
    span = np.linalg.norm(shape.points[shape.edges[:, 0]] - shape.points[shape.edges[:, 1]], axis=1)
    radius = (span * shape.radii[shape.edges].max(axis=1)).sum() / span.sum() / size
    leaves = skeleton.vertices[np.bincount(skeleton.edges.ravel()) == 1]
    gap = (spatial.KDTree(leaves).query(shape.tips)[0] / shape.tip_radii).max() if len(leaves) else 0.0
    return figures["to_truth_mean"] / radius, figures["from_truth_mean"] / radius, gap, figures["leaves"]


def junctions_off(shape, skeleton):
    """The largest distance of a true junction from one of the curve, over its own radius; 0 without junctions."""
    places = shape.points[np.bincount(shape.edges.ravel()) > 2]
    radii = shape.radii[np.bincount(shape.edges.ravel()) > 2]
    found = skeleton.vertices[np.bincount(skeleton.edges.ravel()) > 2]
    assert len(found) == len(places)
    return (spatial.KDTree(found).query(places)[0] / radii).max() if len(places) else 0.0


@pytest.mark.parametrize(
    "name",
    [
        "y_coarse",
        *(pytest.param(name, marks=pytest.mark.slow) for name in ("comb", "theta")),
    ],
)
def test_a_tube_gives_its_curve_back(name):
    shape, skeleton = ground_truth.make(name), flow_of(name).skeleton
    to_truth, from_truth, gap, leaves = score(shape, skeleton)
    assert skeleton.report.is_sound
    assert skeleton.report.inside == 1.0
    assert leaves == shape.num_leaves
    assert to_truth < 0.04
    assert from_truth < 0.05
    assert gap < 0.5
    assert junctions_off(shape, skeleton) < 0.1


@pytest.mark.parametrize("name", ["helix_coarse", pytest.param("octopus_low", marks=pytest.mark.slow)])
def test_a_coarse_mesh_keeps_its_curve_inside(name):
    shape = ground_truth.make(name)
    # Nor are its long edges split first: then a flow would keep inside by itself.
    flow = msf_jax.contract(shape.mesh, config=Config(preprocessing=PreprocessingOptions(refine=0.0)))
    report = flow.skeleton.report
    assert report.inside == 1.0
    assert (report.components, report.cycles, report.loops) == (1, shape.genus, shape.genus)
    if name == "octopus_low":
        assert flow.curve.report.inside < 0.95  # the flow alone leaves it


def test_noise_moves_the_curve_by_less_than_twice_itself_and_adds_no_branch():
    amount = 0.005
    plain = ground_truth.make("straight_coarse")
    one = flow_of("straight_coarse").skeleton
    other = msf_jax.skeletonize(ground_truth.noisy(plain, amount, seed=3).mesh)
    figures = metrics.evaluate(plain.mesh, other, truth=one)
    assert figures["leaves"] == 2
    assert figures["to_truth_mean"] < 2 * amount
    assert figures["from_truth_mean"] < 2 * amount


@pytest.fixture(scope="module")
def y_flow():
    return flow_of("y_coarse")


def test_the_nodes_of_the_flow_come_first_in_the_finished_curve(y_flow):
    curve, skeleton = y_flow.curve, y_flow.skeleton
    num = len(curve.vertices)
    assert len(skeleton.vertices) >= num
    near = np.linalg.norm(skeleton.vertices[:num] - curve.vertices, axis=1)
    assert np.median(near) < 0.02 * np.ptp(curve.vertices)
    degree, new_degree = np.bincount(curve.edges.ravel()), np.bincount(skeleton.edges.ravel())
    assert np.array_equal(np.flatnonzero(degree > 2), np.flatnonzero(new_degree > 2))
    assert curve.report.cycles == skeleton.report.cycles


def test_without_its_passes_the_finished_curve_is_that_of_the_flow():
    flow = msf_jax.contract(
        ground_truth.make("straight_coarse").mesh,
        config=Config(least_slenderness=0, curve=CurveOptions(centre=False, extend_tips=False)),
    )
    np.testing.assert_array_equal(flow.skeleton.vertices, flow.curve.vertices)
    np.testing.assert_array_equal(flow.skeleton.edges, flow.curve.edges)


def test_the_map_goes_to_a_node_near_by(y_flow):
    mesh, skeleton = ground_truth.make("y_coarse").mesh, y_flow.skeleton
    away = np.linalg.norm(mesh.vertices - skeleton.vertices[skeleton.mesh_map], axis=1)
    nearest = spatial.KDTree(skeleton.vertices).query(mesh.vertices)[0]
    assert skeleton.mesh_map.min() >= 0
    assert (away < nearest + 0.3).mean() > 0.99
    assert len(np.unique(skeleton.mesh_map)) > 0.3 * len(skeleton.vertices)


def test_the_report_has_the_figures_where_asked(y_flow):
    mesh = ground_truth.make("arc_coarse").mesh
    skeleton = msf_jax.skeletonize(mesh, config=Config(evaluate=True))
    figures = metrics.evaluate(mesh, skeleton)
    assert skeleton.report.figures == {name: pytest.approx(figures[name]) for name in skeleton.report.figures}
    assert "off_centre" in str(skeleton.report)
    assert y_flow.skeleton.report.figures == {}
