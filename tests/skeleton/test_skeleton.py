"""What can be done with a skeleton once it is there: branches, prune, resample."""

import numpy as np
import pytest
from run_cases import flow_of

import msf_jax
from msf_jax import ConfigError, Skeleton
from msf_jax.solid.enclosure import Enclosure
from tests.benchmarks import ground_truth


@pytest.fixture(scope="module")
def whole():
    """A coarse Y with all the branches that the flow found."""
    mesh = ground_truth.noisy(ground_truth.make("y_coarse"), 0.005, 2).mesh
    return mesh, msf_jax.skeletonize(mesh, config=msf_jax.Config(least_slenderness=0))


def num_leaves(skeleton):
    return int((np.bincount(skeleton.edges.ravel(), minlength=len(skeleton.vertices)) == 1).sum())


def check(mesh, skeleton, like):
    """A sound skeleton of the same mesh and the same topology."""
    assert skeleton.report.components == like.report.components
    assert skeleton.report.cycles == like.report.cycles == len(skeleton.edges) - len(skeleton.vertices) + 1
    assert skeleton.report.loops == skeleton.report.cycles
    assert skeleton.report.inside == 1.0
    assert len(skeleton.mesh_map) == len(mesh.vertices)
    assert skeleton.mesh_map.min() >= 0
    assert skeleton.mesh_map.max() < len(skeleton.vertices)
    assert (skeleton.edges[:, 0] < skeleton.edges[:, 1]).all()
    distance = Enclosure(np.asarray(mesh.vertices), np.asarray(mesh.faces)).distances(skeleton.vertices)
    assert np.abs(skeleton.radii - distance).max() < 1e-6 * np.ptp(mesh.vertices)


def test_a_slid_threshold_takes_spurs_first_and_limbs_later(whole):
    mesh, skeleton = whole
    leaves = []
    for least in (0.0, 0.75, 100.0):
        pruned = skeleton.prune(least)
        check(mesh, pruned, skeleton)
        leaves.append(num_leaves(pruned))
        assert all(branch.slenderness >= least for branch in pruned.branches)
    assert leaves[0] > leaves[1] == 3 > leaves[2] == 2
    assert len(skeleton.prune(0).vertices) == len(skeleton.vertices)


@pytest.mark.slow  # afterwards is above
def test_pruning_while_running_and_afterwards_take_the_same_branches(whole):
    """And the report counts them."""
    mesh, skeleton = whole
    run, later = msf_jax.skeletonize(mesh), skeleton.prune(msf_jax.Config().least_slenderness)
    assert num_leaves(run) == num_leaves(later) and skeleton.report.pruned == 0 == run.report.grown
    assert later.report.pruned == num_leaves(skeleton) - num_leaves(later) > 0
    assert run.report.pruned > 0 and f"{run.report.pruned} pruned" in str(run.report)
    assert later.prune(100.0).report.pruned == later.report.pruned + 1


def test_branches_cover_the_curve_and_the_surface(whole):
    _, skeleton = whole
    found = skeleton.branches
    assert sum(branch.length for branch in found) == pytest.approx(skeleton.length)
    junctions = np.flatnonzero(np.bincount(skeleton.edges.ravel()) > 2)
    at_junctions = skeleton.source.areas[np.isin(skeleton.mesh_map, junctions)].sum()
    assert sum(branch.surface for branch in found) + at_junctions == pytest.approx(1.0)
    nodes = max((branch.nodes for branch in found), key=len)
    split = skeleton.to_tree(nodes[len(nodes) // 2]).columns()  # by a root, which belongs to one of both pieces
    assert len(split["surface"]) == len(found) + 1 and split["surface"].sum() + at_junctions == pytest.approx(1.0)
    degree = np.bincount(skeleton.edges.ravel())
    for branch in found:
        is_limb = min(degree[branch.nodes[0]], degree[branch.nodes[-1]]) == 1
        assert np.isfinite(branch.slenderness) == is_limb


@pytest.mark.parametrize("spacing", [0.02, 0.1, 0.5])
def test_resampled_edges_are_as_long_as_asked(whole, spacing):
    mesh, skeleton = whole
    size = np.ptp(mesh.vertices)
    resampled = skeleton.resample(spacing * size)
    check(mesh, resampled, skeleton)
    length = np.linalg.norm(np.diff(resampled.vertices[resampled.edges], axis=1)[:, 0], axis=1)
    assert length.max() < 1.5 * spacing * size
    if spacing < 0.05:
        assert np.median(length) == pytest.approx(spacing * size, rel=0.25)
    degree, before = (np.bincount(s.edges.ravel()) for s in (resampled, skeleton))
    assert (degree != 2).sum() == (before != 2).sum()
    away = np.linalg.norm(resampled.vertices[resampled.mesh_map] - skeleton.vertices[skeleton.mesh_map], axis=1)
    assert away.max() < 0.76 * spacing * size


def test_a_larger_spacing_never_gives_more_nodes():
    """In a helix, which a long edge leaves: it is bisected, and not all that it skips comes back."""
    shape, skeleton = ground_truth.make("helix_coarse"), flow_of("helix_coarse").skeleton
    found = [skeleton.resample(spacing * np.ptp(shape.mesh.vertices)) for spacing in np.linspace(0.02, 1.0, 15)]
    count = [len(one.vertices) for one in found]
    assert (np.diff(count) <= 0).all() and count[-1] < 0.25 * len(skeleton.vertices)
    for one in found[::5]:
        check(shape.mesh, one, skeleton)


def test_the_original_is_not_changed(whole):
    _, skeleton = whole
    before = [skeleton.vertices.copy(), skeleton.edges.copy(), skeleton.radii.copy(), skeleton.mesh_map.copy()]
    skeleton.prune(3), skeleton.resample(0.1)
    for array, copy in zip((skeleton.vertices, skeleton.edges, skeleton.radii, skeleton.mesh_map), before, strict=True):
        np.testing.assert_array_equal(array, copy)


def test_a_skeleton_without_its_surface_keeps_its_radii(whole):
    _, skeleton = whole
    bare = Skeleton(skeleton.vertices, skeleton.edges, skeleton.radii, skeleton.mesh_map, skeleton.report)
    resampled = bare.resample(0.05)
    nearest = np.linalg.norm(resampled.vertices[:, None] - skeleton.vertices, axis=2).argmin(axis=1)
    np.testing.assert_array_equal(resampled.radii, skeleton.radii[nearest])
    assert np.isnan([branch.surface for branch in bare.branches]).all()


def test_a_twig_within_a_limb_goes_with_the_surface_and_without_it(whole):
    skeleton = whole[1].prune(2.0)
    longest = max(skeleton.branches, key=lambda branch: branch.length)
    node = int(longest.nodes[len(longest.nodes) // 2])
    twig = skeleton.vertices[node] + skeleton.radii[node] * np.array([0.3, 0.3, 0.3])
    vertices, radii = np.vstack([skeleton.vertices, twig]), np.append(skeleton.radii, 0.4 * skeleton.radii[node])
    edges = np.vstack([skeleton.edges, [node, len(skeleton.vertices)]])
    for source in (skeleton.source, None):
        forked = Skeleton(vertices, edges, radii, skeleton.mesh_map, skeleton.report, source)
        assert num_leaves(forked) == 4
        left = forked.prune(2.0)
        assert num_leaves(left) == 3 and len(left.vertices) == len(skeleton.vertices)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda s: s.prune(-1), "slenderness is -1: expected a number of 0 or more"),
        (lambda s: s.prune(float("nan")), "slenderness is nan"),
        (lambda s: s.resample(0), "spacing is 0: expected a length above 0"),
        (lambda s: s.resample(1e-320), "at most ten million nodes; is it in the mesh's units"),
        (lambda s: s.resample(1e-12), "at most ten million nodes"),
    ],
)
def test_arguments_out_of_range_are_refused(whole, call, message):
    with pytest.raises(ConfigError, match=message):
        call(whole[1])
