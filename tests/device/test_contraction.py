"""The contraction against dense least squares: values, what the solve reports, fixed vertices and gradients."""

from functools import partial
from typing import NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from device_cases import (
    TIGHT,
    Case,
    Diagonal,
    Solver,
    bipyramid,
    build,
    case_with_everything,
    central_difference,
    dense_contract,
    jitted_contract,
    one_level,
    plain_contract,
    quick_jit,
    reference_laplacian,
    strict,
)

from msf_jax.base.options import LAPLACIANS, SolverOptions, StepSettings, Weights
from msf_jax.device import cg, iteration
from msf_jax.device.buffers import Buffers, Rings
from msf_jax.device.contraction import Energy, relaxed
from msf_jax.device.laplacian import LaplacianRows

W_L, W_H, W_M = 1.3, 0.2, 0.35
solve = quick_jit(cg.solve, static_argnames="solver")  # operation by operation, XLA compiles a hundred programs


@pytest.fixture(scope="module")
def case() -> Case:
    return case_with_everything(layout=one_level(128, 8))


def contracted(case, w_L=W_L, w_H=W_H, w_M=W_M, **options):
    """New positions of the vertices, in their order."""
    return case.to_vertices(jitted_contract(case.buffers, w_L, w_H, w_M, case.layout, **options)[0])


def expected(case, w_L=W_L, w_H=W_H, w_M=W_M):
    L = reference_laplacian("mean_value", case.vertices, case.faces)
    return dense_contract(L, case.vertices, case.poles, case.is_fixed, w_L, w_H, w_M * case.has_pole)


# Values


def test_it_minimises_the_energy_with_vertices_fixed_and_without_poles(case):
    assert 5 < case.is_fixed.sum() < 40
    assert 5 < (~case.has_pole).sum() < 60
    np.testing.assert_allclose(contracted(case), expected(case), atol=1e-8)


def test_weights_per_row(case):
    random = np.random.default_rng(11)
    weights = [scale * np.exp(random.normal(size=len(case.vertices))) for scale in (1.0, 0.3, 0.3)]
    moved = contracted(case, *(jnp.asarray(case.to_rows(w)) for w in weights))
    np.testing.assert_allclose(moved, expected(case, *weights), atol=1e-8)


def test_gradients_are_finite_where_nothing_moves(case, slopes):
    factors = np.arange(case.buffers.positions.size, dtype=float).reshape(case.buffers.positions.shape)
    w_L, _, w_M, positions = slopes(factors, 0.0, W_H, 0.0, case.buffers.positions)
    assert float(w_L) == float(w_M) == 0.0  # only their squares count
    np.testing.assert_array_equal(positions, factors)


# Fixed vertices


@pytest.mark.parametrize("weights", [(1.0, 0.1, 0.4), (1e3, 1e-2, 0.0), (1.0, 0.1, 1e3), (1e-3, 10.0, 1.0)])
def test_fixed_vertices_stay_bit_for_bit(case, weights):
    moved = contracted(case, *weights)
    np.testing.assert_array_equal(moved[case.is_fixed], case.vertices[case.is_fixed])
    assert (moved[~case.is_fixed] != case.vertices[~case.is_fixed]).any(axis=1).all()


def chain():
    """Vertices at 0, 1, 2 on the x axis, the first one fixed, with the uniform Laplacian's rows."""
    rings = Rings(
        neighbour=jnp.array([1, 0, 1, 0, 2, 2]),  # slot 0 of three rows, then slot 1
        after=jnp.array([1, 2, 1, 0, 0, 2]),
        before=jnp.array([1, 2, 1, 0, 0, 2]),
        is_used=jnp.array([True, True, True, False, True, False]),
    )
    positions = jnp.array([[0.0, 0, 0], [1, 0, 0], [2, 0, 0]])
    one = jnp.ones(3)
    buffers = Buffers(
        positions, rings, jnp.array([1.0, 2, 1]), jnp.array([0.0, 1, 1]), positions, 0 * one, jnp.zeros(()), one
    )
    return buffers, LaplacianRows(rings.is_used.astype(float), rings.is_used.astype(float))


def test_chain_with_a_fixed_end_by_hand():
    """With w_L = w_H = 1: minimise (x2 - 2 x1)^2 + (x1 - x2)^2 + (x1 - 1)^2 + (x2 - 2)^2, so x = 0, 1, 5/3.

    With the fixed end's rows zeroed, but its column left among the unknowns, that end would drift.
    """
    buffers, rows = chain()
    one = jnp.ones(3)
    step = quick_jit(relaxed, static_argnums=(3, 4))
    new, _ = step(buffers, rows, Energy(0 * one, one, one, 0 * one), one_level(3, 2), Solver(TIGHT, 100))
    np.testing.assert_allclose(new, [[0, 0, 0], [1, 0, 0], [5 / 3, 0, 0]], atol=1e-14)
    assert float(new[0, 0]) == 0.0


# The report


def relative_residual(case, new):
    """Of the normal equations in the displacement, relative to their right-hand side, by dense matrices."""
    free = ~case.is_fixed
    L = np.where(case.is_fixed[:, None], 0.0, reference_laplacian("mean_value", case.vertices, case.faces))
    w_M = W_M * case.has_pole
    A = W_L**2 * (L.T @ L) + np.diag(W_H**2 + w_M**2)
    b = (w_M**2)[:, None] * (case.poles - case.vertices) - W_L**2 * L.T @ (L @ case.vertices)
    displacement = case.to_vertices(new) - case.vertices
    return np.linalg.norm((b - A @ displacement)[free]) / np.linalg.norm(b[free])


@pytest.mark.parametrize("tolerance", [1e-2, 1e-5])
def test_solve_ends_when_the_residual_it_reports_is_below_the_tolerance(case, tolerance):
    new, report = jitted_contract(case.buffers, W_L, W_H, W_M, case.layout, tolerance=tolerance)
    residual, steps = float(report.residual), int(report.steps)
    assert residual <= tolerance
    assert 1 < steps < 300
    np.testing.assert_allclose(residual, relative_residual(case, new), rtol=1e-6)
    _, before = jitted_contract(case.buffers, W_L, W_H, W_M, case.layout, tolerance=tolerance, max_steps=steps - 1)
    assert float(before.residual) > tolerance
    assert int(before.steps) == steps - 1


def test_what_is_no_number_stays_none(case, slopes):
    """Whether NaN comes in from before or, as a slope, from behind: zeros would look like a result."""
    bad = case.buffers._replace(poles=case.buffers.poles.at[3, 1].set(jnp.nan))
    new, report = jitted_contract(bad, W_L, W_H, W_M, case.layout)
    assert np.isnan(new).any() and not bool(report.has_ended)
    factors = np.full(case.buffers.positions.shape, np.nan)
    assert np.isnan(slopes(factors, W_L, W_H, W_M, case.buffers.positions)[0])


class Dense(NamedTuple):
    """A full matrix (n, n)."""

    entries: jax.Array

    def __call__(self, x):
        return self.entries @ x

    def diagonal(self):
        return jnp.diagonal(self.entries)


@pytest.mark.parametrize("smallest", [0.0, 1e-3])
@pytest.mark.parametrize("entries", [[1.0, -1.0, 1.0], [2.0, 3.0, -1e-3], [0.0, 0.0, 0.0]])
def test_no_solve_of_what_is_not_positive_definite_has_ended(entries, smallest):
    """Along a direction without curvature no step is taken: that none moves anything says nothing then."""
    operator = Diagonal(jnp.asarray(entries))
    b = jnp.asarray([[0.0], [0.0], [1.0]]) if entries[2] < 0 else jnp.asarray([[0.0], [1.0], [0.0]])
    solver = Solver(1e-9, 50)
    outside = cg.solve_outside(operator, b, solver, lambda r: r, smallest)
    for x, report in (solve(operator, b, solver, smallest), outside):
        assert not bool(report.has_ended) and float(report.residual) > 0.9 and int(report.steps) < 50
        np.testing.assert_array_equal(x, 0.0)
    assert bool(solve(operator, 0.0 * b, solver, smallest)[1].has_ended)  # nothing solves that


@pytest.mark.parametrize("size", [1e-50, 1e-40, 1.0, 1e40])
def test_a_loose_solve_is_right_for_right_hand_sides_beyond_float32(size):
    random = np.random.default_rng(6)
    operator = Diagonal(jnp.asarray(random.uniform(1, 4, 40)))
    b = size * jnp.asarray(random.normal(size=(40, 3)))
    x, report = solve(operator, b, Solver(3e-3, 50))
    assert bool(report.has_ended) and 0 < float(report.residual) <= 3e-3
    np.testing.assert_allclose(operator(x) / size, b / size, atol=0.05)


def test_a_loose_solve_that_float32_cannot_do_has_not_ended():
    """The recursive residual reaches the tolerance, the true one does not: A has a condition of 1e10."""
    random = np.random.default_rng(7)
    basis = np.linalg.qr(random.normal(size=(60, 60)))[0]
    operator = Dense(jnp.asarray(basis @ np.diag(np.logspace(-10, 0, 60)) @ basis.T))
    _, report = solve(operator, jnp.asarray(random.normal(size=(60, 1))), Solver(3e-3, 20_000))
    assert float(report.residual) > 6e-3 and not bool(report.has_ended)


@pytest.mark.parametrize("where", ["device", "host"])
def test_a_short_step_ends_a_solve(where):
    """The larger the step that counts as short, the sooner; that is no solution: many steps may follow it."""
    entries = jnp.asarray(np.logspace(-4, 0, 400))
    b = jnp.asarray(np.random.default_rng(0).normal(size=(400, 1)))
    solver, steps = Solver(1e-9, 5000), []

    def ran(smallest):
        if where == "device":
            return cg.solve(Diagonal(entries), b, solver, smallest)
        return cg.solve_outside(Diagonal(entries), b, solver, lambda r: r / entries[:, None] ** 0.5, smallest)

    ran = quick_jit(ran) if where == "device" else ran
    for smallest in (0.0, 1e-3, 0.1, 1.0, 10.0, 100.0) if where == "device" else (0.0, 10.0):
        x, report = ran(smallest)
        assert bool(report.has_ended) and (float(report.residual) <= solver.tolerance) == (smallest == 0)
        np.testing.assert_allclose(report.left, (b - entries[:, None] * x) / np.linalg.norm(b), atol=1e-13)
        steps.append(int(report.steps))
    assert (np.diff(steps) < 0).all()
    assert where == "host" or steps[-1] == 1  # ends with its first step, far away


@pytest.mark.parametrize("solver", [Solver(3e-3, 50), Solver(1e-9, 50)])
def test_a_solve_of_nothing_reports_nothing(solver):
    x, report = quick_jit(lambda b: cg.solve(Diagonal(jnp.asarray([1.0, 2.0])), b, solver, 0.25))(jnp.zeros((2, 3)))
    for value in (x, report.residual, report.left):
        np.testing.assert_array_equal(value, 0.0)
    assert int(report.steps) <= 1 and bool(report.has_ended)


# Gradients


def product_of(case):
    """The scalar product of the result with factors, as a function of those, the weights and the positions in rows."""

    def product(factors, w_L, w_H, w_M, positions):
        new, _ = plain_contract(case.buffers._replace(positions=positions), w_L, w_H, w_M, case.layout)
        return (factors * new).sum()

    return product


def on_arrays(function):
    """Compiled, and once for all numbers, Python's and NumPy's."""
    compiled = quick_jit(function)
    return lambda *arguments: compiled(*map(np.asarray, arguments))


@pytest.fixture(scope="module")
def slopes(case):
    """Of the product, in the weights and the positions, by reverse mode."""
    return on_arrays(jax.grad(product_of(case), argnums=(1, 2, 3, 4)))


@pytest.fixture(scope="module")
def factors(case):
    return case.to_rows(np.random.default_rng(21).normal(size=case.vertices.shape))


@pytest.fixture(scope="module")
def scalar(case, factors):
    """The product with these factors."""
    return partial(on_arrays(product_of(case)), factors)


@pytest.fixture(scope="module")
def gradients(case, slopes, factors):
    """Of the scalar, in all four arguments."""
    return slopes(factors, W_L, W_H, W_M, case.buffers.positions)


@pytest.mark.parametrize("number", [0, 1, 2])
def test_gradient_in_the_weights(case, scalar, gradients, number):
    weights = np.array([W_L, W_H, W_M])
    slope = central_difference(lambda w: scalar(*w, case.buffers.positions), weights, np.eye(3)[number], h=1e-4)
    assert abs(slope) > 1e-3
    np.testing.assert_allclose(gradients[number], slope, rtol=1e-5)


def test_gradient_in_the_positions(case, scalar, gradients):
    random = np.random.default_rng(5)
    for _ in range(4):
        direction = case.to_rows(random.normal(size=case.vertices.shape))
        slope = central_difference(lambda x: scalar(W_L, W_H, W_M, x), case.buffers.positions, direction, h=1e-6)
        np.testing.assert_allclose((gradients[3] * direction).sum(), slope, rtol=1e-5)


@pytest.fixture(scope="module")
def small() -> Case:
    """Eight vertices, one of them fixed."""
    vertices, faces = bipyramid(6, 0.4, 0.5, 0.3)
    vertices = vertices + 0.03 * np.random.default_rng(1).normal(size=vertices.shape)
    is_fixed = np.arange(8) == 2
    return build(vertices, faces, is_fixed=is_fixed, poles=0.1 * vertices, layout=one_level(8, 8))


@pytest.mark.parametrize(
    "kind", [kind if kind == "mean_value" else pytest.param(kind, marks=pytest.mark.slow) for kind in LAPLACIANS]
)
def test_an_iteration_works_in_the_strict_modes_of_jax(small, kind):
    """With a loose solve, in float32, and with w_H that follows areas."""
    settings = StepSettings(kind, SolverOptions(max_steps=10, step_tolerance=0.0), True)
    with strict():
        slope = jax.grad(lambda w_H: iteration.move(small.buffers, Weights(1.0, w_H), settings, small.layout)[0].sum())
        jax.eval_shape(slope, 0.1)
