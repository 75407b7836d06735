"""Second derivatives through solves, in every transformation and mode, and derivatives whose solve fails."""

from functools import partial

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from conftest import blob
from device_cases import Diagonal, Solver, quick_jit

import msf_jax
from msf_jax import Config, FlowOptions, PreprocessingOptions, Weights
from msf_jax.device import cg

FIRST = {"forward": jax.jacfwd, "reverse": jax.jacrev}
AT = 4.0 ** (1 / 3)  # 1 / x has there the second derivative 0.5


def solved(a):
    """As in a replay. The report must not become a batch where the value is none."""
    x, report = cg.solve(Diagonal(jnp.stack([a, 2 * a])), jnp.ones((2, 1)), Solver(1e-12, 10))
    return jnp.where(report.has_ended, x[0, 0], jnp.nan)


def scanned(function, a):
    return jax.lax.scan(lambda total, _: (total + function(a), None), 0 * a, length=2)[0] / 2


def checkpointed(function):
    return jax.checkpoint(function, policy=cg.keeps_solutions)


def test_a_scalar_solve_has_its_second_derivative():
    """The slope of a gradient, through a branch, a loop and a checkpoint."""
    function = lambda a: jax.lax.cond(a > 0, partial(scanned, checkpointed(solved)), lambda a: a, a)  # noqa: E731
    np.testing.assert_allclose(quick_jit(jax.jacfwd(jax.grad(function)))(jnp.asarray(AT)), 0.5, rtol=1e-6)


@pytest.mark.parametrize("direction", FIRST)
def test_a_derivative_whose_solve_fails_is_nan(direction):
    """Three eigenvalues need three steps."""
    entries, b = jnp.asarray([1.0, 2.0, 3.0]), jnp.ones((3, 1))

    def total(a, steps):
        x, report = cg.solve(Diagonal(a * entries), b, Solver(1e-12, steps), smallest=1e3)
        return x.sum(), report.has_ended

    slope = quick_jit(FIRST[direction](lambda a, steps: total(a, steps)[0]))
    for steps, is_nan in ((1, True), (50, False)):
        # The value ends by the length of its first step; the derivative does not.
        assert bool(quick_jit(total)(1.0, steps)[1])
        assert np.isnan(slope(1.0, steps)) == is_nan


def loops_of(jaxpr):
    """How many `while` loops, those inside other equations included."""
    total = 0
    for equation in jaxpr.eqns:
        total += equation.primitive.name == "while"
        if equation.primitive is jax.lax.linear_solve_p:
            total += 1
            continue
        for value in jax.tree.leaves(equation.params, is_leaf=lambda x: hasattr(x, "eqns") or hasattr(x, "jaxpr")):
            inner = getattr(value, "jaxpr", value)
            total += loops_of(inner) if hasattr(inner, "eqns") else 0
    return total


def test_the_backward_pass_does_not_repeat_the_solve():
    """One solve forward and one backward, and one more without the policy."""
    for function, expected in ((checkpointed(solved), 2), (jax.checkpoint(solved), 3)):
        program = jax.make_jaxpr(jax.grad(partial(scanned, lambda a, f=function: f(a) ** 2)))(AT)
        assert loops_of(program.jaxpr) == expected


def differences(slope, at, h=1e-4):
    """The Hessian by central differences of ``slope``."""
    rows = [(slope(at + step) - slope(at - step)) / (2 * h) for step in h * np.eye(len(at))]
    return np.stack(rows)


def check(hessian, measured, rtol=1e-5):
    hessian, largest = np.asarray(hessian), np.abs(measured).max()
    np.testing.assert_allclose(hessian, hessian.T, atol=1e-8 * largest)
    np.testing.assert_allclose(hessian, measured, atol=rtol * largest)


def at_weights(logarithms):
    return Weights(*jnp.exp(logarithms))


@pytest.mark.slow
@pytest.mark.usefixtures("few_rows_once")
def test_the_hessian_of_a_replay():
    """In the four weights: iterations with collapses and splits in a scan, with a checkpoint."""
    mesh = blob(3, 1)
    mesh.apply_scale([1.0, 0.5, 0.4])
    config = Config(
        max_iterations=2,
        preprocessing=PreprocessingOptions(refine=0.0),
        flow=FlowOptions(threshold_min=0.05, threshold_max=0.05),
    )
    flow = msf_jax.contract(mesh, Weights(w_H=0.6, w_M=0.6, smoothing=0.05), config)
    assert len(flow.history) == 2 and flow.history[0].collapses and flow.history[0].splits
    pull = np.random.default_rng(2).normal(size=flow.curve.vertices.shape)

    def value(logarithms):
        return (pull * msf_jax.replay(flow.tape, at_weights(logarithms), tolerance=1e-13)).sum()

    # One program for the gradient and its slope: compiling takes most of the time.
    both = quick_jit(lambda at, along: jax.jvp(jax.grad(value), (at,), (along,)))
    start = np.log(jax.tree.leaves(flow.weights))
    measured = differences(lambda at: both(at, np.zeros(4))[0], start)
    hessian = np.stack([both(start, along)[1] for along in np.eye(4)])
    check(hessian, measured)
    # Only the ratios of w_L, w_H and w_M matter.
    np.testing.assert_allclose(hessian @ [1, 1, 1, 0], 0, atol=1e-8 * np.abs(measured).max())
