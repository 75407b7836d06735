"""Au et al. 2008: the preconditioner, the surgery, the recentring, and the system as a whole."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from conftest import blob, torus

import msf_jax
from msf_jax import Config, ground_truth
from msf_jax.base.layout import layout_for
from msf_jax.base.options import Weights
from msf_jax.curve import extraction
from msf_jax.device.buffers import Buffers, Rings
from msf_jax.device.iteration import _equations, _jitted_energies
from msf_jax.meso import packing, surgery
from msf_jax.meso.meso import Meso
from msf_jax.numerics.factors import factored
from msf_jax.topology import graphs


def system(mesh, w_L, w_H, area=1.0, fixed=()):
    """The dense normal operator, the sparse factor's inverse, which rows are free, and the layout's capacity."""
    vertices = mesh.vertices / mesh.scale
    meso = Meso.from_mesh(vertices, np.array(mesh.faces))
    meso.is_fixed[list(fixed)] = True
    layout = layout_for(meso.num_rows, packing.rows_beyond(meso))
    order, _, fields = packing.pack(meso, layout, np.full(meso.num_rows, area), np.dtype(np.float64))
    buffers = Buffers(**{**fields, "rings": Rings(*fields["rings"])})
    settings = Config.au2008().on_device
    energy = _jitted_energies(buffers, Weights(w_L, w_H, 0.0, 0.0), settings, layout)[0]
    operator, b = _equations(buffers, energy, settings, layout)
    num = len(order)
    eye = jnp.eye(layout.capacity)[:, :num]
    dense = np.asarray(jax.jit(lambda A: A(eye))(operator))[:num]
    arrays = jax.device_get((operator.neighbour, operator.weights[0], operator.own, operator.shift, operator.free))
    inverse = factored(*arrays, layout)
    return dense, inverse(np.asarray(eye))[:num], np.asarray(b)[:num], inverse


def test_the_factor_is_within_a_half_of_the_inverse_however_large_w_L_is():
    mesh = blob(3, 2)
    area = float(mesh.area / mesh.scale**2)  # of no ring: w_H varies over the surface
    for w_L in (1.0, 1e3, 1e6):
        dense, inverse, _, _ = system(mesh, w_L, 1.0, area, fixed=(0, 5))
        value = np.linalg.eigvals(inverse @ dense)
        assert np.abs(value.imag).max() < 1e-4
        assert value.real.min() > 0.49
        assert value.real.max() < 1.3
        if w_L > 1:  # what the diagonal makes of it
            by_diagonal = np.linalg.eigvals(dense / np.diag(dense)[:, None]).real
            assert by_diagonal.max() / by_diagonal.min() > 1e4


def test_what_is_fixed_is_left_alone_and_nothing_is_made_of_what_is_no_number():
    mesh = blob(3, 2)
    _, inverse, _, apply = system(mesh, 10.0, 1.0, fixed=(7,))
    row = np.argmax(np.isclose(np.abs(inverse - np.eye(len(inverse))).sum(axis=1), 0))
    assert (inverse[row] == np.eye(len(inverse))[row]).all()
    r = np.random.default_rng(0).normal(size=(2048, 3))
    assert not np.array_equal(apply(r), r)
    bad = np.full(4, np.nan)
    layout = layout_for(4, [4, 4, 4])
    slots = np.zeros(layout.num_slots)
    assert factored(slots.astype(int), slots, bad, bad, bad, layout)(bad) is bad


def test_the_costs_are_those_of_the_paper():
    """F_a from the lines of all edges that were gathered, F_b from the lengths that are left, edge by edge."""
    mesh = blob(1, 2)
    x = np.array(mesh.vertices)
    a, b = mesh.edges_unique.T
    work = surgery._Costs(x, a, b)
    around = [set(neighbours) for neighbours in mesh.vertex_neighbors]
    lines = [[(i, j) for j in around[i]] for i in range(len(x))]

    def expected(i, j):
        shape = 0.0
        for start, end in lines[i] + lines[j]:
            along = (x[end] - x[start]) / np.linalg.norm(x[end] - x[start])
            shape += (np.cross(along, x[j] - x[start]) ** 2).sum()
        return shape + 0.1 * np.linalg.norm(x[i] - x[j]) * sum(np.linalg.norm(x[i] - x[k]) for k in around[i])

    random = np.random.default_rng(4)
    for _ in range(60):
        i = int(random.choice([v for v in range(len(x)) if around[v]]))
        j = int(random.choice(sorted(around[i])))
        assert work.cost(i, j) == pytest.approx(expected(i, j), rel=1e-9)
        work.merge(i, j)
        lines[j] += lines[i]
        for k in around[i]:
            around[k] = (around[k] - {i}) | ({j} if k != j else set())
        around[j] |= around[i] - {j}
        around[i] = set()


@pytest.mark.parametrize("seed", range(4))
def test_surgery_keeps_the_cycle_and_a_vertex_for_a_node(seed):
    from msf_jax.meso.homology import ring_classes

    mesh = torus(around=12, across=6)
    meso = Meso.from_mesh(mesh.vertices, np.array(mesh.faces))
    classes = ring_classes(meso.positions, meso.faces(), meso.rings)
    x = np.random.default_rng(seed).normal(size=meso.positions.shape)
    found = extraction.operated_curve(x, meso.rings, classes)
    assert graphs.cycle_count(len(found.nodes), found.edges) == (1, 1)
    assert found.is_counted is not None
    assert np.array_equal(np.sort(found.node_of_meso[found.is_counted]), np.arange(len(found.nodes)))
    assert np.array_equal(found.nodes[found.node_of_meso[found.is_counted]], x[found.is_counted])


def test_a_straight_thin_tube_keeps_its_ends():
    """Of a tube that has been contracted to its axis but for a thousandth, surgery leaves nodes all along it."""
    mesh = ground_truth.make("straight").mesh
    vertices = np.array(mesh.vertices)
    centre, axis = vertices.mean(axis=0), np.linalg.svd(vertices - vertices.mean(axis=0), full_matrices=False)[2][0]
    along = np.outer((vertices - centre) @ axis, axis)
    thin = centre + along + 1e-3 * (vertices - centre - along)
    meso = Meso.from_mesh(thin, np.array(mesh.faces))
    found = extraction.operated_curve(thin, meso.rings)
    assert graphs.cycle_count(len(found.nodes), found.edges) == (1, 0)
    assert len(found.nodes) > 20
    assert np.ptp(found.nodes @ axis) > 0.9 * np.ptp(vertices @ axis)


def test_recentring_brings_a_shifted_contraction_back():
    mesh = torus(around=40, across=16)
    vertices, faces = np.array(mesh.vertices), np.array(mesh.faces)
    angle = np.arctan2(vertices[:, 1], vertices[:, 0])
    node = np.floor((angle + np.pi) / (2 * np.pi) * 10).astype(int) % 10
    off = np.array([0.03, -0.02, 0.05])  # where the contraction has taken every ring, from its middle
    middle = (
        np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1) * (np.linalg.norm(vertices[:, :2], axis=1)).mean()
    )
    contracted = middle + off
    nodes = np.stack([contracted[node == k].mean(axis=0) for k in range(10)])
    ring = np.stack([np.arange(10), (np.arange(10) + 1) % 10], axis=1)
    back = surgery.recentred(nodes, ring, node, contracted, vertices, faces)
    radius = np.linalg.norm(vertices[:, :2], axis=1).mean()
    assert np.abs(np.linalg.norm(nodes[:, :2], axis=1) - radius).max() > 0.02
    assert np.abs(back[:, 2]).max() < 0.01  # it was 0.05 off
    assert np.abs(np.linalg.norm(back[:, :2], axis=1) - radius).max() < 0.02
    # A leaf goes with the node before it.
    chain = ring[:-1]
    moved = surgery.recentred(nodes, chain, node, contracted, vertices, faces) - nodes
    assert np.allclose(moved[0], moved[1])
    assert np.allclose(moved[9], moved[8])


@pytest.mark.parametrize("name", [pytest.param("y_coarse", marks=pytest.mark.slow), "helix_coarse"])
def test_the_system_contracts_to_a_millionth_and_draws_the_curve(name):
    shape = ground_truth.make(name)
    plain = msf_jax.skeletonize(shape.mesh, config=Config.au2008(check=True))
    report = plain.report
    assert report.converged
    assert report.volume < 1e-6
    assert report.iterations <= 20
    assert report.unsolved == 0
    assert (report.components, report.cycles, report.loops, report.inside) == (1, shape.genus, shape.genus, 1.0)
    assert len(np.unique(plain.mesh_map)) > 4
    done = msf_jax.skeletonize(
        shape.mesh, config=Config.au2008(evaluate=True, curve={"centre": True, "extend_tips": True})
    )
    assert done.report.figures["leaves"] == shape.num_leaves
    assert done.report.figures["off_centre"] < 0.12
    assert done.report.inside == 1.0
    other = msf_jax.skeletonize(shape.mesh, config=Config.au2008(curve={"surgery": False}))
    assert (other.report.cycles, other.report.loops, other.report.inside) == (shape.genus, shape.genus, 1.0)


def test_a_ring_keeps_its_loop():
    report = msf_jax.skeletonize(torus(minor=0.2, around=40, across=12), config=Config.au2008()).report
    assert report.converged
    assert (report.genus, report.cycles, report.loops, report.inside) == (1, 1, 1, 1.0)


def test_plain_conjugate_gradients_do_not_follow():
    """By the diagonal alone, the same solves take so many steps; by the factor, at most 30 in any iteration."""
    mesh = ground_truth.make("y_coarse").mesh
    run = msf_jax.contract(mesh, config=Config.au2008())
    plain = msf_jax.contract(mesh, config=Config.au2008(solver={"preconditioner": "jacobi", "max_steps": 20000}))
    assert max(line.steps for line in run.history) <= 30
    assert max(line.steps for line in plain.history) > 300


def test_float32_is_not_asked_for_by_the_system():
    mesh = ground_truth.make("y_coarse").mesh
    double = msf_jax.skeletonize(mesh, config=Config.au2008())
    jax.config.update("jax_enable_x64", False)
    try:
        single = msf_jax.skeletonize(mesh, config=Config.au2008())
    finally:
        jax.config.update("jax_enable_x64", True)
    assert np.array_equal(single.vertices, double.vertices)


@pytest.mark.slow
def test_a_short_run_is_replayed_with_its_gradient():
    mesh = ground_truth.make("straight_coarse").mesh
    flow = msf_jax.contract(mesh, config=Config.au2008(max_iterations=2, flow={"volume_tolerance": 0.0}))
    vertices = np.array(mesh.vertices)
    nodes = msf_jax.replay(flow.tape, flow.weights)
    assert np.abs(nodes - flow.curve.vertices).max() < 1e-9 * mesh.scale
    random = np.random.default_rng(3)
    towards, direction = random.normal(size=nodes.shape), random.normal(size=vertices.shape)

    @jax.jit
    @jax.value_and_grad
    def loss(step):
        weights = Weights(1 + step, 1.0, 0.0, 0.0)
        return (towards * msf_jax.replay(flow.tape, weights, vertices + step * direction, tolerance=1e-13)).sum()

    h = 1e-7
    difference = float(loss(h)[0] - loss(-h)[0]) / (2 * h)
    assert float(loss(0.0)[1]) == pytest.approx(difference, rel=1e-4)
