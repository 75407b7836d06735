"""The passes after the flow: containment, centring, pruning, tips; and shapes whose curve is known."""

from functools import partial

import manifold3d
import numpy as np
import pytest
import trimesh
from conftest import blob, torus
from curve_cases import bored, bow, draft_of, is_inside, job_of, length_of, none_held, path, tube, turns_of, unit_shape
from scipy import spatial

import msf_jax
from msf_jax import Config, CurveOptions, PreprocessingOptions, ground_truth, metrics
from msf_jax.curve import branch_paths, branches, centring, finishing, handle_loops, moves, resampling
from msf_jax.curve.draft import Draft, Job
from msf_jax.inside import containment
from msf_jax.inside.roadmap import Roadmap
from msf_jax.limbs.caps import Caps
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.frame import RESOLUTION
from msf_jax.solid.geometry import unit
from msf_jax.topology.graphs import cycle_count


def test_an_edge_across_a_bend_is_led_round_it():
    shape, scale = unit_shape(tube(bow(0.6)))
    x, edges = path(scale * bow(0.6)[[2, -3]])
    assert not is_inside(shape, x, edges)
    led, led_edges = containment.contain(shape, x, edges, none_held(x))
    assert is_inside(shape, led, led_edges)
    assert cycle_count(len(led), led_edges) == (1, 0)
    np.testing.assert_array_equal(led[:2], x)
    assert length_of(led, led_edges) < 2 * np.pi * 0.6 * scale * 1.6  # the way round, and no tour of the tube


def test_nodes_outside_come_in_and_held_ones_stay():
    shape, scale = unit_shape(tube(bow(0.25)))
    middle = scale * bow(0.25)[[10, 20, 30, 40, 50]]
    out = middle.copy()
    out[2] *= 1.3
    x, edges = containment.contain(shape, *path(out), none_held(out))
    assert is_inside(shape, x, edges)
    np.testing.assert_array_equal(x[[0, 1, 3, 4]], out[[0, 1, 3, 4]])
    assert np.linalg.norm(x[2] - middle[2]) < 0.15 * scale
    held = np.arange(5) == 2
    x, _ = containment.contain(shape, *path(out), held)
    np.testing.assert_array_equal(x[2], out[2])


def test_a_curve_that_is_inside_is_not_touched():
    shape, scale = unit_shape(tube(bow(0.25)))
    before, edges = path(scale * bow(0.25)[5:-5])
    x, after = containment.contain(shape, before, edges, none_held(before))
    np.testing.assert_array_equal(x, before)
    np.testing.assert_array_equal(np.sort(after, axis=1), edges)


def test_a_segment_through_a_fold_inside_the_solid_is_inside():
    """Two balls that overlap, one surface: it crosses itself, but between the centres nothing is outside."""
    one, other = trimesh.creation.icosphere(2, 1.0), trimesh.creation.icosphere(2, 1.0)
    other.apply_translation([1.2, 0, 0])
    both = trimesh.util.concatenate([one, other])
    shape = Enclosure(np.asarray(both.vertices), np.asarray(both.faces))
    ends = np.array([[0.0, 0, 0], [1.2, 0, 0], [0.6, 0.5, 0], [0.6, 1.2, 0]])
    a, b = ends[[0, 0, 0]], ends[[1, 2, 3]]
    assert containment.is_inside(shape, a, b).tolist() == [True, True, False]


@pytest.mark.parametrize(("width", "is_in"), [(RESOLUTION / 4, True), (4 * RESOLUTION, False)])
def test_a_loop_may_graze_the_surface(width, is_in):
    """A segment through the tip of a wedge that is cut out of a block, where the wedge is ``width`` wide."""
    block = manifold3d.Manifold.cube([1.0, 1.0, 0.2], True)
    wedge = manifold3d.Manifold.cube([1.0, 1.0, 1.0], True).rotate([0, 0, 45]).translate([0, np.sqrt(0.5), 0])
    found = (block - wedge).to_mesh()
    shape = Enclosure(found.vert_properties[:, :3].astype(float), found.tri_verts.astype(np.int64))
    a, b = np.array([[-0.1, width / 2, 0.01]]), np.array([[0.1, width / 2, 0.01]])
    assert not containment.is_inside(shape, a, b).any()
    assert containment.is_inside(shape, a, b, sliver=RESOLUTION).tolist() == [is_in]
    is_out = handle_loops.proof(
        shape, np.concatenate([a, b, [[0.0, -0.1, 0.01]]]), np.array([[0, 1], [1, 2], [0, 2]])
    ).outside
    assert (len(is_out) == 0) == is_in


def test_a_loop_around_a_hole_is_not_folded_flat():
    """Of a triangle around it, with two more nodes on one side: each turns, and all shortcuts are inside."""
    shape, scale = unit_shape(torus(1.0, 0.6, 48, 24))
    angle = np.radians([0, 120, 240])
    x = 1.2 * scale * np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    edges = np.array([[0, 1], [1, 2], [0, 2]])
    assert is_inside(shape, x, edges)
    np.testing.assert_array_equal(resampling.straighten(shape, x, edges, none_held(x), 90.0), x)
    spike = np.concatenate([x, [x[0] * 1.2]])  # there and back, beside the way from 0 to 1
    chain = np.array([[0, 3], [1, 3], [1, 2], [0, 2]])
    straight = resampling.straighten(shape, spike, chain, np.arange(4) < 3, 90.0)
    np.testing.assert_allclose(straight[3], (x[0] + x[1]) / 2, atol=1e-12)


def loops_and_rank(shape, draft, job):
    """How many cycles there are in space, and how many handles they go around."""
    done = finishing.merge_coincident(draft, job)
    return cycle_count(len(done.vertices), done.edges)[1], handle_loops.proof(shape, done.vertices, done.edges).rank


def moved_to(shape, edges, x, goal):
    """The nodes x, moved as far to their goals as the rule of moves allows."""
    return moves.taken(shape, shape.handles, moves.places_of(shape, x), goal - x, edges).x


@pytest.mark.parametrize("step", [finishing.straighten, partial(finishing.centre_nodes, hold_leaves=False)])
@pytest.mark.parametrize("genus", [1, 0])
def test_no_pass_folds_a_loop_flat(step, genus):
    """One that is nearly inside a single ball, too, around a bore that is far finer than the limb; what goes around
    nothing may be folded."""
    line = np.linspace([0, 0, 0], [2, 0, 0], 60)
    rod = manifold3d.Manifold.cylinder(2.0, 0.15, 0.15, 16).rotate((0.0, 90.0, 0.0))
    shape, scale = unit_shape(bored(rod, line[31, :2], 0.004) if genus else tube(line))
    axis = scale * line[[5, 30, 32]]
    away = np.array([0, 0.01, 0])
    x = np.concatenate([axis[:2], [axis[2] + away, axis[2] - away]])
    draft, job = draft_of(x, np.array([[0, 1], [1, 2], [2, 3], [1, 3]])), job_of(shape)
    assert loops_and_rank(shape, draft, job) == (1, genus)
    assert loops_and_rank(shape, step(draft, job), job) == (genus, genus)


@pytest.mark.parametrize(
    ("x", "edges", "moved"),
    [
        # A loop whose junctions alone were moved, with a leg at each; and a ring that begins with the node that was.
        ([[0, 0, 0], [2, 0, 0], [1, 1, 0], [-1, 0, 0], [3, 0, 0]], [[0, 1], [0, 2], [1, 2], [0, 3], [1, 4]], [0, 1]),
        ([[0, 0, 0], [1, 1, 0], [2, 0, 0]], [[0, 1], [1, 2], [0, 2]], [0]),
    ],
)
def test_loops_that_their_junctions_fold_are_put_back(x, edges, moved):
    """They go around a hole at (1, 0.4)."""
    plate = manifold3d.Manifold.cube([8, 6, 1], True).translate((1.0, 0.0, 0.0))
    shape, scale = unit_shape(bored(plate, (1.0, 0.4), 0.1))
    x, flat = scale * np.array(x, dtype=float), scale * np.array(x, dtype=float)
    flat[moved] = scale * np.array([[0, 1, 0], [2, 1, 0]] if len(moved) == 2 else [[3, -1, 0]])
    draft, job = draft_of(x, np.array(edges)), job_of(shape)
    assert loops_and_rank(shape, draft.changed(flat), job) == (0, 0)
    assert loops_and_rank(shape, draft.changed(moved_to(shape, draft.edges, x, flat)), job) == (1, 1)


def test_a_loop_is_not_moved_over_a_hole():
    """To the other side, where it would be as long as before, and a node beside it goes where it is to."""
    plate = manifold3d.Manifold.cube([8, 6, 1], True).translate((1.0, 0.0, 0.0))
    shape, scale = unit_shape(bored(plate, (1.0, 0.4), 0.1))
    x = scale * np.array([[0, 0, 0], [2, 0, 0], [1, 1, 0], [-1, 0, 0]], dtype=float)
    draft, job = draft_of(x, np.array([[0, 1], [1, 2], [0, 2], [0, 3]])), job_of(shape)
    over = x + scale * np.array([[0, 0, 0], [0, 0, 0], [0, -1.5, 0], [0, 0.2, 0]])
    assert loops_and_rank(shape, draft.changed(over), job) == (1, 0)
    kept = moved_to(shape, draft.edges, x, over)
    assert loops_and_rank(shape, draft.changed(kept), job) == (1, 1)
    np.testing.assert_array_equal(kept[3], over[3])


@pytest.mark.parametrize("seed", range(5))
def test_a_segment_that_leaves_along_a_face_is_not_inside(seed):
    """A ray in the plane of a face does not hit it, and may miss its neighbours by rounding."""
    random = np.random.default_rng(seed)
    step = manifold3d.Manifold.cube([2, 2, 1]).translate([-1, -1, -1])
    step += manifold3d.Manifold.cube([1, 2, 2]).translate([-1, -1, -1])
    found = step.to_mesh()
    turn = trimesh.transformations.random_rotation_matrix(random.uniform(size=3))[:3, :3]
    shape = Enclosure(found.vert_properties[:, :3].astype(float) @ turn.T, np.array(found.tri_verts))
    y = random.uniform(-0.8, 0.8, (2, 50))
    a = np.stack([random.uniform(-0.8, -0.2, 50), y[0], np.zeros(50)], axis=1) @ turn.T
    b = np.stack([random.uniform(1.1, 2, 50), y[1], np.zeros(50)], axis=1) @ turn.T
    assert shape.contains(a).all() and not shape.contains(b).any()
    assert not containment.is_inside(shape, a, b).any()


def test_where_the_corner_cannot_be_cut_a_half_of_it_is():
    shape, scale = unit_shape(tube(bow(0.6)))
    x, edges = path(scale * np.array([1, 1.1, 1])[:, None] * bow(0.6)[[2, 14, 26]])
    assert is_inside(shape, x, edges) and not is_inside(shape, x[[0, 2]], np.array([[0, 1]]))
    found = resampling.straighten(shape, x, edges, np.arange(3) != 1, most=40.0)
    assert is_inside(shape, found, edges) and 0 < turns_of(found, edges)[0] < turns_of(x, edges)[0] - 5


def test_centring_takes_no_edge_out_of_a_plate_with_holes(monkeypatch):
    """So that the finished curve, which must be inside, is not led back there over kinks."""
    plate = manifold3d.Manifold.cube([3, 2, 0.05], True)
    for x in (-1, 0, 1):
        plate -= manifold3d.Manifold.cylinder(1, 0.45, circular_segments=16, center=True).translate([x, 0, 0])
    found = plate.to_mesh()
    mesh = trimesh.Trimesh(found.vert_properties[:, :3].astype(float), found.tri_verts)
    seen = []

    def watched(shape, x, edges, *others):
        y = centre(shape, x, edges, *others)
        seen.append([containment.is_inside(shape, z[edges[:, 0]], z[edges[:, 1]]).all() for z in (x, y)])
        return y

    centre = centring.centre
    monkeypatch.setattr(centring, "centre", watched)
    curve = msf_jax.skeletonize(mesh)
    assert np.array(seen).shape == (2, 2) and np.array(seen).all()
    assert curve.report.loops == curve.report.cycles == 3 and (turns_of(curve.vertices, curve.edges) > 45).sum() <= 2


def test_a_shifted_axis_goes_back_to_the_middle():
    line = np.stack([np.linspace(-1, 1, 41), np.zeros(41), np.zeros(41)], axis=1)
    shape, scale = unit_shape(tube(line, 0.2))
    wavy = scale * (line[4:-4] + np.array([0, 0.1, 0.05]) * np.cos(7 * line[4:-4, :1]))
    x = centring.centre(shape, *path(wavy), none_held(wavy))
    assert np.linalg.norm(x[:, 1:], axis=1).max() < 0.01 * 0.2 * scale
    held = np.arange(len(wavy)) == 10
    x = centring.centre(shape, *path(wavy), held)
    np.testing.assert_array_equal(x[10], wavy[10])
    assert np.linalg.norm(x[:, 1:], axis=1)[20:].max() < 0.02 * 0.2 * scale


def test_centring_comes_to_an_end():
    """A further round moves no node, and nodes stay where they were along the curve."""
    shape, scale = unit_shape(tube(bow(0.3)))
    curve, edges = path(scale * (bow(0.3)[4:-4] + 0.05 * np.cos(9 * bow(0.3)[4:-4, 1:2])))
    held = np.isin(np.arange(len(curve)), [0, len(curve) - 1])
    x = centring.centre(shape, curve, edges, held)
    again = centring.centre(shape, x, edges, held, rounds=1, places=curve, is_far=False)
    assert np.linalg.norm(again - x, axis=1).max() < 1e-3 * 0.15 * scale
    assert np.linalg.norm(x - curve, axis=1).max() > 0.1 * 0.15 * scale
    share = [np.cumsum(np.linalg.norm(np.diff(y, axis=0), axis=1)) for y in (curve, x)]
    np.testing.assert_allclose(share[0] / share[0][-1], share[1] / share[1][-1], atol=2e-3)


def test_centring_turns_with_the_solid():
    line = bow(0.3)
    mesh = tube(line)
    turn = trimesh.transformations.random_rotation_matrix(np.array([0.1, 0.7, 0.4]))[:3, :3]
    shape, scale = unit_shape(mesh)
    turned = Enclosure(shape.vertices @ turn.T, shape.faces)
    wavy = scale * (line[5:-5] + 0.05 * np.sin(9 * line[5:-5, :1]))
    x = centring.centre(shape, *path(wavy), none_held(wavy))
    y = centring.centre(turned, *path(wavy @ turn.T), none_held(wavy))
    assert np.abs(y - x @ turn.T).max() < 1e-7


def test_junctions_go_to_the_middle_of_a_blob_but_not_along_a_trunk():
    """Wherever the flow has found them; places too far from the roomiest one, and pins, stay."""
    ball = manifold3d.Manifold.sphere(1.0, 32)
    for offset in np.r_[np.eye(3), -np.eye(3)[:2]]:
        ball += manifold3d.Manifold.sphere(0.4, 32).translate(tuple(offset))
    found = ball.to_mesh()
    shape, scale = unit_shape(trimesh.Trimesh(found.vert_properties[:, :3].astype(float), found.tri_verts))
    places = scale * np.array([[0.2, -0.1, 0.1], [-0.15, 0.2, 0.05], [0.1, 0.1, -0.2]])
    middle = centring.deepest_points(shape, places)
    assert np.linalg.norm(middle, axis=1).max() < 0.05 * scale
    x = np.concatenate([places, 1.2 * scale * np.eye(3)])
    edges = np.array([[0, 3], [0, 4], [0, 5]])
    job = job_of(shape)
    for is_held in (none_held(x), np.arange(6) == 0):
        draft = Draft(x, edges, is_held, np.arange(6), np.arange(6), x, none_held(x))
        place, is_former_junction = finishing.place_junctions(draft, job)[5:7]
        assert is_former_junction.tolist() == [not is_held[0]] + 5 * [False]
        np.testing.assert_array_equal(place[1:], x[1:])
        assert (place[0] == x[0]).all() == is_held[0]
    cone = ground_truth.swept_tube(np.linspace([0, 0, 0], [8, 0, 0], 80), np.linspace(0.3, 0.6, 80), 24)
    shape, scale = unit_shape(cone)
    trunk = scale * np.array([[3.0, 0.05, 0]])
    np.testing.assert_array_equal(centring.deepest_points(shape, trunk), trunk)


def test_a_curve_goes_to_the_middle_of_a_blob_that_it_had_a_junction_in():
    """Between two limbs that leave it side by side it runs straight on, when nothing holds it."""
    ball = manifold3d.Manifold.sphere(1.0, 48)
    for side in (-0.5, 0.5):
        limb = np.linspace([0.6, side, 0], [2.5, 1.4 * side, 0], 9)
        ball += manifold3d.Manifold.batch_hull([manifold3d.Manifold.sphere(0.2, 16).translate(tuple(p)) for p in limb])
    found = ball.refine_to_length(0.15).to_mesh()
    shape, scale = unit_shape(trimesh.Trimesh(found.vert_properties[:, :3].astype(float), found.tri_verts))
    legs = [np.linspace([2.5, 1.4 * side, 0], [0.8, 1.1 * side, 0], 18) for side in (-0.5, 0.5)]
    into = [np.linspace(leg[-1], [0, 0, 0], 5)[1:-1] for leg in legs]
    x = scale * np.concatenate([legs[0], into[0], np.zeros((1, 3)), into[1][::-1], legs[1][::-1]])
    curve, edges = path(x)
    middle = len(legs[0]) + len(into[0])
    held, former_junctions = np.isin(np.arange(len(x)), [0, len(x) - 1]), np.arange(len(x)) == middle
    away = [
        np.linalg.norm(centring.centre(shape, curve, edges, held, former_junctions=each, is_far=False), axis=1).min()
        / scale
        for each in (none_held(x), former_junctions)
    ]
    assert away[1] < 0.3 < 0.45 < away[0]


def test_a_budget_that_is_spent_leaves_one_round():
    budget = centring.Budget()
    budget.left = 0
    shape, scale = unit_shape(tube(bow(0.3)))
    wavy = scale * (bow(0.3)[5:-5] + 0.05 * np.sin(9 * bow(0.3)[5:-5, :1]))
    x = centring.centre(shape, *path(wavy), none_held(wavy), budget=budget)
    np.testing.assert_array_equal(x, centring.centre(shape, *path(wavy), none_held(wavy), rounds=1))
    assert budget.was_hit


def test_a_step_that_goes_back_is_shortened(monkeypatch):
    """Steps that go as far beyond the middle as they came from: the second one, halved, ends there."""
    shape, scale = unit_shape(tube(np.linspace([-1, 0, 0], [1, 0, 0], 41), 0.2))
    nodes, edges = path(scale * np.linspace([-0.5, 0, 0.02], [0.5, 0, 0.02], 9))
    seen = []

    class Overshooting:
        def __init__(self, x, paths, span, limb, *rest):
            seen.append(x)
            self.off = np.zeros((len(limb), 3))

        def step(self, weight):
            return np.array([0, 0, -2]) * seen[-1]

    monkeypatch.setattr(centring, "_System", Overshooting)
    x = centring.centre(shape, nodes, edges, none_held(nodes), is_far=False)
    np.testing.assert_allclose(np.array([*seen, x])[:, 4, 2], 0.02 * scale * np.array([1, -1, 0, 0]), atol=1e-12)


@pytest.mark.parametrize(("num", "held"), [(48, []), (200, []), (200, [100])])
def test_the_nodes_of_a_ring_do_not_go_round(monkeypatch, num, held):
    """However unevenly they are spaced: a ring has no end that would hold them. Nor does it fold back on itself."""
    shape, scale = unit_shape(trimesh.creation.torus(1.0, 0.2, major_sections=64, minor_sections=24))
    angle = 2 * np.pi * np.linspace(0, 1, num, endpoint=False) ** 1.3
    nodes = scale * np.stack([1.05 * np.cos(angle), 1.05 * np.sin(angle), 0.03 * np.cos(5 * angle)], axis=1)
    edges = np.stack([np.arange(num), np.roll(np.arange(num), -1)], axis=1)
    monkeypatch.setattr(centring, "ANCHOR", 0.0)
    x = centring.centre(shape, nodes, edges, np.isin(np.arange(num), held))
    ahead = unit(np.roll(x, -1, axis=0) - x)
    assert np.einsum("ni,ni->n", ahead, np.roll(ahead, 1, axis=0)).min() > (0.5 if held else 0.97)
    if not held:
        assert np.abs(np.linalg.norm(x[:, :2], axis=1) / scale - 1).max() < 0.01
        assert np.abs(x[:, 2]).max() < 0.01 * scale
        assert np.abs(np.angle((x[:, 0] + 1j * x[:, 1]) * np.exp(-1j * angle))).max() < 0.01


def test_how_large_a_limb_is_near_by_is_a_mean_over_the_branch():
    """With weights of a bell over the way along it, and next to none, but not none, far away."""
    random = np.random.default_rng(3)
    curve, edges = path(np.cumsum(random.uniform(0.1, 1.0, (400, 3)), axis=0))
    size, weight, clearance = random.uniform(0.5, 2.0, (3, len(curve)))
    weight[100:150] = 0.0
    weight[300:] = 0.0  # nothing is known within many sizes of the end
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(curve, axis=0), axis=1))])
    usual = np.average(size, weights=weight)
    bell = (np.exp(-0.5 * ((along[:, None] - along) / usual) ** 2) + 1e-9) * weight
    expected = bell @ size / bell.sum(axis=1)
    found = branch_paths.sizes(curve, branch_paths.paths_of(curve, edges, none_held(curve)), size, weight, clearance)
    np.testing.assert_allclose(found, expected, rtol=1e-5)


def test_a_long_curve_has_no_more_nodes_than_it_may(monkeypatch):
    line = bow(0.3)
    shape, scale = unit_shape(tube(line))
    coarse = path(scale * line[5:-5:5])
    fine, _, is_sparse = containment.refine(shape, *coarse, 0.1, 1000)
    assert len(fine) > 2 * len(coarse[0]) and not is_sparse
    few, edges, is_sparse = containment.refine(shape, *coarse, 0.1, len(fine) // 2)
    assert len(coarse[0]) < len(few) < 0.8 * len(fine) and is_sparse and cycle_count(len(few), edges) == (1, 0)
    monkeypatch.setattr(finishing, "MOST_NODES", 3)
    report = msf_jax.skeletonize(tube(line)).report
    assert report.is_sound and any("far apart" in note for note in report.notes)


def test_points_go_to_the_nearest_node_of_their_own_branch():
    # A Y: branches 0-1-2, 0-3-4 and 0-5-6.
    nodes = np.array([[0.0, 0, 0], [2, 0, 0], [4, 0, 0], [0, 2, 0], [0, 4, 0], [-2, 0, 0], [-4, 0, 0]])
    edges = np.array([[0, 1], [1, 2], [0, 3], [3, 4], [0, 5], [5, 6]])
    points = np.array([[3.9, 1, 0], [0.1, 1, 0], [0, 3.9, 0], [-1.9, 0, 0], [-1.9, 0, 0]])
    found = branches.nearest_on_branch(nodes, edges, points, np.array([1, 2, 1, 1, 0]))
    assert found.tolist() == [2, 0, 0, 0, 5]


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
        *("arc_coarse", "ring", "comb", "y_coarse"),
        *(pytest.param(name, marks=pytest.mark.slow) for name in ("straight", "taper", "y", "tee", "theta")),
    ],
)
def test_a_tube_gives_its_curve_back(name):
    shape = ground_truth.make(name)
    skeleton = msf_jax.skeletonize(shape.mesh)
    to_truth, from_truth, gap, leaves = score(shape, skeleton)
    assert skeleton.report.is_sound
    assert skeleton.report.inside == 1.0
    assert leaves == shape.num_leaves
    assert to_truth < 0.04
    assert from_truth < 0.05
    assert gap < 0.5
    assert junctions_off(shape, skeleton) < 0.1


@pytest.mark.parametrize("name", ["octopus_low", "pawn_low", "helix_coarse"])
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
    plain = ground_truth.make("straight")
    one = msf_jax.skeletonize(plain.mesh)
    other = msf_jax.skeletonize(ground_truth.noisy(plain, amount, seed=3).mesh)
    figures = metrics.evaluate(plain.mesh, other, truth=one)
    assert figures["leaves"] == 2
    assert figures["to_truth_mean"] < 2 * amount
    assert figures["from_truth_mean"] < 2 * amount


@pytest.fixture(scope="module")
def y_flow():
    return msf_jax.contract(ground_truth.make("y_coarse").mesh)


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
        ground_truth.make("arc").mesh,
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


def test_pins_hold_vertices_in_place_and_the_curve_goes_through_them():
    mesh = torus(minor=0.3, around=40, across=16)
    pins = [3, 200, 411]
    flow = msf_jax.contract(mesh, pins=pins, config=Config(check=True))
    for skeleton in (flow.curve, flow.skeleton):
        for pin in pins:
            at_pin = np.flatnonzero((skeleton.vertices == mesh.vertices[pin]).all(axis=1))
            assert len(at_pin) == 1
            assert skeleton.mesh_map[pin] == at_pin[0]
    assert flow.skeleton.report.loops == flow.skeleton.report.cycles == 1
    assert flow.skeleton.report.components == 1
    assert flow.is_fixed.sum() >= 3


def test_pins_are_the_callers_vertices_whatever_their_order():
    mesh = blob(5)
    order = np.random.default_rng(4).permutation(len(mesh.vertices))
    renamed = mesh.vertices[order], np.argsort(order)[mesh.faces]
    one = msf_jax.skeletonize(mesh, pins=[int(order[7])])
    other = msf_jax.skeletonize(renamed, pins=np.array([7]))
    assert np.abs(one.vertices - other.vertices).max() < 1e-9


@pytest.mark.parametrize("pins", [[-1], [10_000], [0.5], [[1, 2]], ["a"]])
def test_a_pin_that_is_no_vertex_is_refused(pins):
    with pytest.raises(msf_jax.ConfigError, match="expected vertex numbers from 0 to 639"):
        msf_jax.skeletonize(torus(minor=0.3, around=40, across=16), pins=pins)


def test_a_pin_that_no_face_uses_is_refused():
    mesh = torus(minor=0.3, around=40, across=16)
    vertices = np.concatenate([mesh.vertices, [[5.0, 5, 5]]])
    with pytest.raises(msf_jax.ConfigError, match="vertex 640, which no face uses"):
        msf_jax.skeletonize((vertices, mesh.faces), pins=[640])


def test_an_end_in_a_bubble_goes_and_one_in_another_piece_stays():
    along = np.stack([np.linspace(-1, 1, 40), np.zeros(40), np.zeros(40)], axis=1)
    for place, is_bubble in ((1.1, True), (1.6, False)):
        ball = trimesh.creation.icosphere(2, 0.08).apply_translation([place, 0, 0])
        shape, scale = unit_shape(trimesh.util.concatenate([tube(along, 0.3), ball]))
        line = scale * np.append(np.linspace(-0.5, 0.95, 8), place)[:, None] * [1.0, 0, 0]
        for nodes in (line, line[::-1]):
            stays, target = containment.cut_off(shape, *path(nodes), none_held(nodes))
            gone = np.abs(nodes[:, 0] - scale * place) < 1e-9 if is_bubble else none_held(nodes)
            np.testing.assert_array_equal(stays, ~gone)
            np.testing.assert_allclose(nodes[target[gone], 0], 0.95 * scale)
            assert containment.cut_off(shape, *path(nodes), ~none_held(nodes))[0].all()
            assert containment.cut_off(shape, *path(line[-2:]), none_held(line[-2:]))[0].all()


def test_the_curve_of_a_noisy_surface_that_crosses_itself_is_inside():
    wavy = ground_truth.noisy(ground_truth.make("y"), 0.005, 1)
    report = msf_jax.skeletonize(wavy.mesh).report
    assert report.inside == 1 and not report.notes and report.is_sound


@pytest.mark.slow
@pytest.mark.parametrize("turn", [0.0, 0.7])
def test_a_cube_has_one_straight_branch_and_its_bumps_have_one_each(turn):
    """Not legs into corners, and no bump is left out, however it is turned."""

    def cube(size):
        return manifold3d.Manifold.cube((size, size, size), True)

    bumps = [
        manifold3d.Manifold.sphere(0.45, 24).translate(tuple(place)) for place in 1.2 * np.r_[np.eye(3), -np.eye(3)]
    ]
    for solid, count in ((cube(2.0), 1), (sum(bumps, cube(2.0)), 6)):
        found = solid.rotate((40 * turn, 70 * turn, 20 * turn)).refine_to_length(0.15).to_mesh()
        vertices = np.array(found.vert_properties[:, :3], dtype=float)
        branches = msf_jax.skeletonize((vertices, found.tri_verts)).branches
        assert len(branches) == count
        assert max(branch.length for branch in branches) < 1.06 * min(branch.length for branch in branches) < 3.6 * 1.06


def test_a_corner_that_cannot_be_cut_is_rounded_in_its_ball():
    """In an angle of two bars, where all shortcuts leave it: small turns, inside, and no node but the corner moves."""
    angle = manifold3d.Manifold.cube([2, 2, 0.1])
    angle -= manifold3d.Manifold.cube([1.9, 1.9, 0.2]).translate([0.1, 0.1, -0.05])
    found = angle.to_mesh()
    shape, scale = unit_shape(trimesh.Trimesh(found.vert_properties[:, :3].astype(float), found.tri_verts))
    x, edges = path(scale * np.array([[1.5, 0.06, 0.05], [0.8, 0.06, 0.05], [0.09, 0.09, 0.05], [0.06, 1.5, 0.05]]))
    np.testing.assert_array_equal(resampling.straighten(shape, x, edges, none_held(x), 40.0), x)
    y, led = resampling.round_corners(shape, x, edges, none_held(x), 40.0)
    assert is_inside(shape, y, led) and cycle_count(len(y), led) == (1, 0)
    assert resampling.turns(x, edges).max() > 80 and resampling.turns(y, led).max() < 40
    np.testing.assert_array_equal(y[[0, 1, 3]], x[[0, 1, 3]])
    assert np.linalg.norm(y[2] - x[2]) < shape.clearance(x[[2]])[0]
    held = np.arange(4) == 2
    np.testing.assert_array_equal(resampling.round_corners(shape, x, edges, held, 40.0)[0], x)


@pytest.mark.parametrize("num_cycles", [0, 1])
def test_corners_side_by_side_are_rounded(num_cycles):
    """Of a ring, all; of a zigzag, those between its ends."""
    shape, _ = unit_shape(trimesh.creation.icosphere(3))
    x, edges = path(0.2 * np.array([[1.0, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]]))
    if num_cycles:
        edges = np.concatenate([edges, [[0, 3]]])
    else:
        x, edges = path(0.02 * np.array([[k, k % 2, 0] for k in range(-5, 6)]))
    y, led = resampling.round_corners(shape, x, edges, none_held(x), 40.0)
    assert np.count_nonzero(resampling.turns(x, edges) > 80) == (4 if num_cycles else 9)
    assert resampling.turns(y, led).max() < 40
    assert cycle_count(len(y), led) == (1, num_cycles)


def test_corners_are_rounded_whatever_is_beside_them():
    """A sharper one that is outside, and a held node that another is in one place with."""
    shape, _ = unit_shape(trimesh.creation.icosphere(3))
    x, edges = path(0.2 * np.array([[-1, 5, 0], [0, 5, 0], [-3, 0, 0], [-1, 0, 0], [0, 0, 0], [0, 1, 0], [0, 1.5, 0]]))
    y, led = resampling.round_corners(shape, x, edges, np.arange(7) == 2, 40.0)
    turn = resampling.turns(y, led)
    assert turn[1] > 120 and np.delete(turn, [1, 2]).max() < 40
    x, edges = path(0.2 * np.array([[-1, 0, 0], [-0.2, 0, 0], [-0.2, 0, 0], [0, 0, 0], [0, 1, 0]]))
    y, led = resampling.round_corners(shape, x, edges, np.arange(5) == 2, 40.0)
    np.testing.assert_array_equal(y[2], x[2])
    assert resampling.turns(y, led)[3:].max() < 40


@pytest.mark.parametrize("is_far", [False, True])
def test_a_place_outside_does_not_hold_a_junction(is_far):
    """The curve of a Y is then as if no place had been found."""
    shape, scale = unit_shape(ground_truth.make("y").mesh)
    truth = ground_truth.make("y")
    x, edges = scale * truth.points, truth.edges
    (junction,) = np.flatnonzero(np.bincount(edges.ravel()) > 2)
    places = x.copy()
    places[junction] += np.array([0, 0, 8.0 if is_far else 2.5]) * scale * truth.radii.mean()
    assert not shape.contains(places[[junction]]).any()
    found = centring.centre(shape, x, edges, none_held(x), places=places)
    plain = centring.centre(shape, x, edges, none_held(x))
    radius = shape.distances(plain[[junction]])[0]
    assert np.linalg.norm(found[junction] - plain[junction]) < 0.05 * radius
    assert shape.distances(found[[junction]])[0] > 0.9 * radius


def test_a_junction_goes_to_the_node_whose_ball_holds_its_own():
    """Of two legs that meet low in a trunk, to the trunk; a spur's on a limb that hardly widens stays."""
    trunk = manifold3d.Manifold.sphere(1.0, 48) + manifold3d.Manifold.cylinder(3, 0.6, 0.6, 32)
    for side in (-1, 1):
        trunk += manifold3d.Manifold.cylinder(3, 0.25, 0.25, 32).translate((0, 0, -3.5)).rotate((0, 20 * side, 0))
    found = trunk.refine_to_length(0.3).to_mesh()
    shape, scale = unit_shape(trimesh.Trimesh(found.vert_properties[:, :3].astype(float), found.tri_verts))
    legs = [[0.9, 0, -2.5], [-0.9, 0, -2.5]]
    x = scale * np.array([[0, 0, -0.75], [0, 0, -0.3], [0, 0, 0.05], [0, 0, 1.6], [0, 0.3, 1.6], [0, 0, 2.5], *legs])
    edges = np.array([[0, 1], [1, 2], [2, 3], [3, 4], [3, 5], [0, 6], [0, 7]])
    roadmap = Roadmap(shape, containment.is_inside)
    job = Job(shape, shape, 0.75, roadmap, centring.Budget(), partial(Caps, shape))
    every = np.arange(len(x))
    draft = Draft(x, edges, none_held(x), every, every, x, none_held(x))
    place = finishing.place_junctions(draft, job).place / scale
    assert np.linalg.norm(place[0]) < 0.1
    assert np.linalg.norm(place[3] - [0, 0, 1.6]) < 0.35


def test_what_is_pruned_to_a_new_node_goes_to_the_flows_nearest_one(monkeypatch):
    """A limb that was grown can begin at a node that is not the flow's, and the flow's own tip beyond goes there."""
    shape, scale = unit_shape(tube(bow(0.3)))
    nodes, edges = path(scale * bow(0.3)[[20, 30, 40, 50]])

    def one(draft, job):
        middle = draft.vertices[2:].mean(axis=0, keepdims=True)
        more = draft.changed(np.concatenate([draft.vertices, middle]), np.array([[0, 1], [1, 2], [2, 4], [4, 3]]))
        return finishing.reduced(more, np.arange(5) != 3, np.array([0, 1, 2, 4, 4]))

    monkeypatch.setattr(finishing, "passes", lambda centre, extend: [one])
    found = finishing.finish(shape, nodes, edges, np.zeros(4, dtype=bool), prune=0.9, centre=True, extend=True)
    np.testing.assert_array_equal(found.is_kept, [True, True, True, False])
    np.testing.assert_array_equal(found.target, [0, 1, 2, 2])


def test_if_no_node_of_the_flow_is_left_the_first_new_one_stands_for_the_nearest(monkeypatch):
    """Limbs of their own can replace all branches of a small curve."""
    shape, scale = unit_shape(tube(bow(0.3)))
    nodes, edges = path(scale * bow(0.3)[[20, 30, 40, 50]])

    def other(draft, job):
        more = draft.changed(np.concatenate([nodes, nodes[1:3] + 1e-3]), np.array([[0, 1], [1, 2], [2, 3], [4, 5]]))
        return finishing.reduced(more, np.arange(6) > 3, np.array([4, 4, 5, 5, 4, 5]))

    monkeypatch.setattr(finishing, "passes", lambda centre, extend: [other])
    found = finishing.finish(shape, nodes, edges, np.zeros(4, dtype=bool), prune=0.9, centre=True, extend=True)
    np.testing.assert_array_equal(found.is_kept, [False, True, False, False])
    np.testing.assert_array_equal(found.target, [1, 1, 1, 1])
    assert len(found.vertices) == 2 and found.edges.tolist() == [[0, 1]]
