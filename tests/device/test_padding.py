"""Padding, layout, the order of the vertices: nothing of it shows in values or gradients, nor compiles anew."""

from functools import partial

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from device_cases import (
    MANY,
    TIGHT,
    case_with_everything,
    quick_jit,
)

from msf_jax.base.layout import Layout, rectangle, staircase
from msf_jax.base.options import Config, FlowOptions, SolverOptions, Weights
from msf_jax.device import iteration

CONFIG = Config(
    solver=SolverOptions(tolerance=TIGHT, max_steps=MANY),
    flow=FlowOptions(w_H_follows_area=True, edit_connectivity=False),
)
WEIGHTS = Weights(w_L=0.9, w_H=0.2, w_M=0.3, smoothing=0.05)
OWN = staircase(256, 11)
OTHER = rectangle(256, 11)


@partial(quick_jit, static_argnames="layout")
def step_with_gradients(buffers, weights, factors, layout: Layout):
    """New positions in rows, and the gradients of their product with ``factors`` in weights and in floating buffers.

    Of a whole iteration, which has both solves.
    """

    def scalar(weights, positions, poles, area):
        moved = buffers._replace(positions=positions, poles=poles, area=area)
        new = iteration.move(moved, weights, CONFIG.on_device, layout).positions
        return (factors * new).sum(), new

    floats = (buffers.positions, buffers.poles, buffers.area)
    gradients, new = jax.grad(scalar, argnums=(0, 1, 2, 3), has_aux=True)(weights, *floats)
    return new, *gradients


def outcome(case):
    """Values and gradients in rows, for factors that are those of the vertices, and zero in padded rows."""
    factors = case.to_rows(np.random.default_rng(17).normal(size=case.vertices.shape))
    weights = jax.tree_util.tree_map(jnp.asarray, WEIGHTS)
    return step_with_gradients(case.buffers, weights, jnp.asarray(factors), case.layout)


def assert_same(case, found, reference_case, reference):
    """Equal values and gradients, vertex by vertex and weight by weight; nothing in padded rows."""
    new, by_weights, *by_rows = found
    np.testing.assert_allclose(case.to_vertices(new), reference_case.to_vertices(reference[0]), atol=1e-12)
    scale = max(float(abs(g)) for g in jax.tree_util.tree_leaves(reference[1]))
    assert scale > 1e-3
    for ours, theirs in zip(*map(jax.tree_util.tree_leaves, (by_weights, reference[1])), strict=True):
        np.testing.assert_allclose(ours, theirs, atol=1e-10 * scale)
    for ours, theirs in zip(by_rows, reference[2:], strict=True):
        scale = 1 + np.abs(np.asarray(theirs)).max()
        vertices = reference_case.to_vertices(theirs)
        np.testing.assert_allclose(case.to_vertices(ours), vertices, atol=1e-10 * scale)
        np.testing.assert_array_equal(np.asarray(ours)[len(case.order) :], 0.0)
    for leaf in jax.tree_util.tree_leaves(found):
        assert np.isfinite(leaf).all()


@pytest.fixture(scope="module")
def own():
    """The surface in its own layout, and what the step makes of it."""
    case = case_with_everything(layout=OWN)
    return case, outcome(case)


@pytest.mark.slow
def test_layout_does_not_show(own):
    elsewhere = case_with_everything(layout=OTHER)
    assert_same(elsewhere, outcome(elsewhere), *own)


@pytest.mark.slow
def test_values_in_padded_rows_do_not_show(own):
    case, expected = own
    random, count = np.random.default_rng(8), len(case.order)

    def scrambled(array, low, high):
        junk = random.uniform(low, high, size=np.shape(array))
        return jnp.concatenate([array[:count], jnp.asarray(junk[count:])])

    buffers = case.buffers._replace(
        positions=scrambled(case.buffers.positions, -100, 100),
        poles=scrambled(case.buffers.poles, -1e4, 1e4),
        area=scrambled(case.buffers.area, 1e-3, 1e3),
    )
    strewn = case._replace(buffers=buffers)
    found = outcome(strewn)
    assert_same(strewn, found, case, expected)
    np.testing.assert_array_equal(found[0][count:], buffers.positions[count:])
