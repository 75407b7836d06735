"""The whole flow: topology, map, units, symmetries, the same bits twice, and the three systems."""

import jax
import numpy as np
import pytest
import trimesh
from conftest import blob, torus
from run_cases import flow_of

import msf_jax
from msf_jax import Config, ConfigError, PreprocessingOptions, SolverOptions, Weights, shapes
from msf_jax.base import layout
from msf_jax.base.clock import Clock
from msf_jax.flow import loop, programs, stepping
from msf_jax.flow.state import Iteration
from msf_jax.meshes import checking
from msf_jax.meso import packing
from tests.benchmarks import ground_truth


def diagonal(vertices):
    return np.linalg.norm(np.ptp(vertices, axis=0))


def tubes():
    """A torus and a Y of tubes, as (mesh, genus)."""
    return [(torus(minor=0.2, around=60, across=16), 1), (three_arms(0.1), 0)]


def three_arms(spacing):
    points = np.array([[0, 0, 0], [0, 0, 1.0], [0.9, 0, -0.5], [-0.8, 0.3, -0.6]])
    return shapes.solid_around(points, np.array([[0, 1], [0, 2], [0, 3]]), np.full(4, 0.15), spacing)


def check_map(run):
    """Every input vertex has a node, and most of the flow's nodes have input vertices (not all: some are of splits)."""
    for skeleton in (run.curve, run.skeleton):
        assert skeleton.mesh_map.min() >= 0
        assert skeleton.mesh_map.max() < len(skeleton.vertices)
    assert len(np.unique(run.curve.mesh_map)) >= 0.75 * len(run.curve.vertices)


@pytest.fixture(scope="module")
def y_flow():
    """Its long edges are not split before the flow, so that its history begins with the vertices of the mesh."""
    return loop.contract(tubes()[1][0], config=Config(preprocessing=PreprocessingOptions(refine=0.0)))


@pytest.mark.parametrize("which", [0, 1])
def test_tubes_become_curves_of_their_topology(which):
    mesh, genus = tubes()[which]
    run = loop.contract(mesh)
    report = run.skeleton.report
    assert report.converged
    assert (report.components, report.cycles, report.loops, report.genus) == (1, genus, genus, genus)
    assert report.inside == 1.0
    assert run.skeleton.mesh_map.shape == (len(mesh.vertices),)
    check_map(run)


def test_the_history_adds_up(y_flow):
    history = y_flow.history
    live = len(tubes()[1][0].vertices) - y_flow.skeleton.report.coarsened
    for line in history:
        live += line.splits - line.collapses
        assert line.live == live
        assert 0 <= line.fixed <= line.live
        assert np.isfinite(line.residual)
        assert line.steps > 0
    assert history[-1].volume <= y_flow.config.flow.volume_tolerance
    assert y_flow.skeleton.report.iterations == len(history)
    assert len(y_flow.is_fixed) == history[-1].live == len(y_flow.meso_skeleton[0])


def test_the_surface_of_every_iteration_is_that_of_its_line_in_the_history(y_flow):
    """Its vertices, and its volume by an independent measure, as a share of that of the first one."""
    whole = trimesh.Trimesh(*y_flow.surface(0)[1:3], process=False)
    for number, line in enumerate(y_flow.history, start=1):
        stage = y_flow.surface(number)
        assert len(stage.vertices) == line.live and stage.is_fixed.sum() == line.fixed
        surface = trimesh.Trimesh(stage.vertices, stage.faces, process=False)
        assert surface.is_watertight and surface.is_winding_consistent and surface.euler_number == 2
        assert abs(surface.volume / whole.volume) == pytest.approx(line.volume, abs=1e-3)
    np.testing.assert_array_equal(stage.vertices, y_flow.meso_skeleton[0])
    with pytest.raises(ConfigError, match="expected a whole number from 0 to"):
        y_flow.surface(len(y_flow.history) + 1)


def test_the_skeleton_scales_shifts_and_turns_with_the_mesh():
    mesh, plain = ground_truth.make("y_coarse").mesh, flow_of("y_coarse").skeleton
    vertices, faces = np.array(mesh.vertices), np.array(mesh.faces)
    size = diagonal(vertices)
    shift = 1e4 * size * np.array([1.0, -0.5, 0.3])
    turn = np.array([[0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [-1.0, 0.0, 0.0]])
    moved = msf_jax.skeletonize((1000 * (vertices @ turn.T + shift), faces))
    assert np.array_equal(moved.edges, plain.edges)
    assert np.abs((moved.vertices / 1000 - shift) @ turn - plain.vertices).max() <= 1e-6 * size


def test_a_permutation_of_vertices_and_faces_leaves_the_curve_as_it_is():
    mesh = ground_truth.make("y_coarse").mesh
    vertices, faces = mesh.vertices, mesh.faces
    random = np.random.default_rng(0)
    order = random.permutation(len(vertices))
    renamed = np.roll(np.argsort(order)[faces], 1, axis=1)[random.permutation(len(faces))]
    plain = flow_of("y_coarse").skeleton
    permuted = msf_jax.skeletonize((vertices[order], renamed))
    assert np.array_equal(permuted.edges, plain.edges)
    assert np.abs(permuted.vertices - plain.vertices).max() <= 1e-9 * diagonal(vertices)
    assert np.array_equal(permuted.mesh_map, plain.mesh_map[order])


def test_float32_gives_a_sound_curve_too():
    mesh, genus = torus(), 1
    jax.config.update("jax_enable_x64", False)
    try:
        report = msf_jax.skeletonize(mesh).report
    finally:
        jax.config.update("jax_enable_x64", True)
    assert report.converged
    assert report.loops == report.cycles == genus
    assert report.inside == 1.0


def test_the_system_of_tagliasacchi_ends_in_a_curve():
    """Its own spacing would make many vertices. That of Au is in test_au2008."""
    mesh, options = three_arms(0.1), {"preprocessing": {"resample": 0.08}}
    skeleton = msf_jax.skeletonize(mesh, config=Config.named("tagliasacchi2012", **options))
    assert skeleton.report.components == 1
    assert skeleton.report.cycles == 0
    assert len(skeleton.vertices) >= 4
    assert len(skeleton.mesh_map) == len(mesh.vertices)
    assert skeleton.mesh_map.min() >= 0


def test_the_callers_mesh_is_not_changed():
    mesh = ground_truth.make("straight_coarse").mesh.copy()
    mesh.invert()
    vertices, faces = mesh.vertices.copy(), mesh.faces.copy()
    skeleton = msf_jax.skeletonize(mesh)
    assert np.array_equal(mesh.vertices, vertices)
    assert np.array_equal(mesh.faces, faces)
    assert any("inside out" in repair for repair in skeleton.report.repairs)


def test_weights_that_blow_up_are_said():
    state = loop.init(checking.prepare(blob(1)).components[0], 0, Config(), Clock())
    state.meso.poles[:] = 1e9
    loop.step(state, Weights(w_M=1e3), Config(), Clock())
    ended = loop.ending(state, Config())
    assert ended is not None
    assert not ended[0]
    assert "coordinates" in ended[1]
    assert np.abs(state.meso.positions).max() < 1


def length_of(skeleton):
    return np.linalg.norm(
        skeleton.vertices[skeleton.edges[:, 0]] - skeleton.vertices[skeleton.edges[:, 1]], axis=1
    ).sum()


def test_a_solid_thinner_than_the_shortest_edge_keeps_its_length():
    """Coarsening would collapse its cross-section, and with it the solid: it is left out."""
    skeleton = msf_jax.skeletonize(trimesh.creation.cylinder(radius=0.002, height=1, sections=8))
    assert skeleton.report.coarsened == 0
    assert skeleton.report.converged
    assert 0.98 < length_of(skeleton) < 1.0 and skeleton.num_leaves == 2


def test_a_part_with_long_faces_is_centred_in_its_own_surface():
    """It is refined and then coarsened, and more triangles are left than it had."""
    mesh = trimesh.creation.annulus(0.5, 2, 0.2, sections=64)
    state = loop.init(checking.prepare(mesh).components[0], 0, Config(), Clock())
    assert state.num_coarsened > state.meso.num_rows > len(mesh.vertices) == len(state.coarse.vertices)


def test_coarsening_takes_short_edges_and_leaves_the_shape():
    """A fine torus: no short edge that could go is left, no volume lost, and poles are still those of the vertices."""
    mesh = torus(around=80, across=28)
    config = Config(max_iterations=1, coarsen=0.03)
    state = loop.init(checking.prepare(mesh).components[0], 0, config, Clock())
    coarse = trimesh.Trimesh(state.meso.positions, state.meso.faces(), process=False)
    assert state.num_coarsened > 0.5 * len(mesh.vertices)
    assert state.num_coarsened + len(coarse.vertices) == len(mesh.vertices)
    assert len(state.coarse.vertices) == state.meso.num_rows
    assert coarse.is_watertight
    assert coarse.euler_number == 0
    # A polygon of chords 0.045 long in a circle of radius 0.09 has 4.1 % less area.
    assert abs(coarse.volume * diagonal(mesh.vertices) ** 3 / mesh.volume - 1) < 0.06
    assert np.percentile(coarse.edges_unique_length, 2) > 0.0225
    poles = state.frame.leave(state.meso.poles[state.meso.node_of_input])
    off = np.hypot(np.hypot(poles[:, 0], poles[:, 1]) - 1.0, poles[:, 2])
    assert np.median(off) < 0.02
    along = np.einsum("vi,vi->v", poles[:, :2], mesh.vertices[state.order, :2])
    assert (along > 0).all()  # a vertex's pole is on its own side


@pytest.mark.slow  # for those who look for a NaN
def test_a_flow_without_jit():
    """Slow, but it runs, for those who look for a NaN."""
    with jax.disable_jit():
        run = loop.contract(blob(1, subdivisions=1), config=Config(max_iterations=1, solver=SolverOptions(max_steps=3)))
    assert len(run.history) == 1
    assert np.isfinite(run.skeleton.vertices).all()


@pytest.mark.slow  # so does an iteration, in test_padding
def test_a_run_compiles_once_for_each_capacity_and_another_compiles_nothing(compilations, monkeypatch):
    """Not for a second mesh, nor for options that a jitted step does not see."""
    monkeypatch.setattr(layout, "SMALLEST_CAPACITY", 256)  # small ones are compiled in less time
    monkeypatch.setattr(programs, "_file", lambda key: None)  # a run of the tests before this one has kept them
    config = Config(solver=SolverOptions(tolerance=0.00123))  # one that no other test compiles for
    states = []
    for number, mesh in enumerate((blob(11, 2), torus())):
        states.append(loop.init(checking.prepare(mesh).components[0], number, config, Clock()))
    layouts = {layout.layout_for(1, [])}
    for state in states:
        while loop.ending(state, config) is None:
            layouts.add(layout.layout_for(state.meso.num_rows, packing.rows_beyond(state.meso.degree)))
            loop.step(state, Weights(), config, Clock())
    assert len(layouts) > 1
    assert len(compilations) == len(layouts)
    changed = config.replace(
        least_slenderness=0.0,
        max_iterations=50,
        coarsen=0.0,
        flow={"threshold_min": 0.008, "threshold_step": 0.001},
    )
    loop.contract(blob(11, 2), Weights(w_M=0.3), changed)
    assert len(compilations) == len(layouts)


def test_an_iteration_sends_the_surface_once_and_fetches_positions_and_residuals(monkeypatch):
    """One transfer each way, explicit: fewer than 400 bytes a row there, three vectors a row back."""
    sent, fetched = [], []
    put, get = jax.device_put, jax.device_get
    monkeypatch.setattr(jax, "device_put", lambda tree: sent.append(tree) or put(tree))
    monkeypatch.setattr(jax, "device_get", lambda tree: fetched.append(tree) or get(tree))
    mesh = blob(5)
    loop.contract(mesh, config=Config(max_iterations=1))  # what a process asks its device once
    sent.clear()
    fetched.clear()
    with jax.transfer_guard("disallow"):
        run = loop.contract(mesh, config=Config(max_iterations=3))
    assert len(sent) == len(fetched) == len(run.history)
    size = [sum(leaf.nbytes for leaf in jax.tree_util.tree_leaves(tree)) for tree in (sent[0], fetched[0])]
    rows = layout.capacity_for(len(mesh.vertices))
    assert size[0] < 400 * rows and size[1] < (3 * 24 + 1) * rows


@pytest.mark.parametrize("sections", [(32, 32), (24, 10)])
def test_a_torus_goes_on_from_a_flat_ring_to_a_curve(sections):
    """A flat ring has no volume either; its curve must not cut across the hole."""
    mesh = trimesh.creation.torus(2, 0.6, major_sections=sections[0], minor_sections=sections[1])
    skeleton = msf_jax.skeletonize(mesh)
    assert skeleton.report.converged
    assert (skeleton.report.cycles, skeleton.report.loops, skeleton.report.inside) == (1, 1, 1.0)
    away = np.linalg.norm(mesh.vertices - skeleton.vertices[skeleton.mesh_map], axis=1)
    assert away.max() < 1.5 * 0.6 + 0.3


def test_too_thin_a_plate_is_refused_by_every_system():
    plate = trimesh.creation.box((1, 1, 1e-7)).subdivide().subdivide()
    for system in ("msf", "tagliasacchi2012", "au2008"):
        with pytest.raises(msf_jax.MeshError, match="too thin"):
            msf_jax.skeletonize(plate, config=Config.named(system))


def test_a_flow_that_only_turns_on_the_spot_has_settled():
    def history(volume, area):
        return [
            Iteration(0, k + 1, 0.005, 100, 50, 9, 9, volume, area(k), 1, 0.0, True, 1, 0.0, 0.01) for k in range(40)
        ]

    assert stepping.is_settled(history(0.01, lambda k: 0.05 + 0.002 * (k % 2)), Config())
    assert not stepping.is_settled(history(0.01, lambda k: 0.5 * 0.95**k), Config())
    assert not stepping.is_settled(history(0.05, lambda k: 0.05), Config())
    assert stepping.is_settled(history(0.08, lambda k: 0.4), Config())  # a fifth as thick as at first: membranes
    assert not stepping.is_settled(history(0.15, lambda k: 0.9), Config())
    assert not stepping.is_settled(history(0.01, lambda k: 0.05)[:10], Config())
