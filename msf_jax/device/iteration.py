"""One jitted iteration of the flow: update L, contract, smooth (the first three lines of Algorithm 2's loop)."""

from collections.abc import Callable
from functools import partial, reduce
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
from jax import lax

from msf_jax.base.layout import Layout
from msf_jax.base.options import StepSettings, Weights
from msf_jax.device import cg, laplacian
from msf_jax.device.buffers import Buffers
from msf_jax.device.cg import SolveReport
from msf_jax.device.contraction import Energy, Gram, normal_equations, relaxed
from msf_jax.device.laplacian import LaplacianRows


class Moved(NamedTuple):
    """The new positions, and the reports of both solves, (2, ...): contraction first."""

    positions: jax.Array
    solves: SolveReport


def move(buffers: Buffers, weights: Weights, settings: StepSettings, layout: Layout, left: Any = None) -> Moved:
    """One iteration on ``buffers``; weights are scalars or (n,), one value a row. ``left`` (2, n, 3): the residuals
    that the solves shall leave, as a run reported them. Both are steps of one scan, so that one body is compiled.

    Differentiable in: buffers.positions, buffers.poles, weights; with ``buffers.t_c`` 0, which solves to the tolerance.
    """
    energies = _energies(buffers, weights, settings, layout)
    smallest = settings.solver.step_tolerance * buffers.t_c

    def relax(positions: jax.Array, line: Any) -> tuple[jax.Array, SolveReport]:
        energy, smallest, left = line
        moved = buffers._replace(positions=positions)
        return relaxed(moved, _rows(moved, settings, layout), energy, layout, settings.solver, smallest, left)

    least = jnp.stack([smallest, jnp.zeros_like(smallest)])
    lines = jax.tree.map(lambda *both: jnp.stack(both), *energies), least, left
    return Moved(*lax.scan(relax, buffers.positions, lines))


def _energies(buffers: Buffers, weights: Weights, settings: StepSettings, layout: Layout) -> tuple[Energy, Energy]:
    """The energies of the contraction and of the smoothing."""
    one, zero = jnp.ones_like(buffers.free), jnp.zeros_like(buffers.free)
    # Only the ratios of w_L, w_H and w_M matter, and their fourth powers must stay within float32's range.
    three = weights.w_L, weights.w_H, weights.w_M
    largest = lax.stop_gradient(reduce(jnp.maximum, map(jnp.max, three)))
    w_L, w_H, w_M = (weight / largest * one for weight in three)
    if settings.w_H_follows_area:
        area = laplacian.one_ring_areas(buffers.positions, buffers.rings, buffers.degree, layout)
        w_H = w_H * jnp.sqrt(buffers.area / area)
    return Energy(zero, w_L, w_H**2, (w_M * buffers.pull) ** 2), Energy(one, -(weights.smoothing * one), zero, zero)


def _rows(buffers: Buffers, settings: StepSettings, layout: Layout) -> LaplacianRows:
    """The Laplacian of the surface in ``buffers``, with limited entries, whose gradient is 0."""
    rows = laplacian.assemble(settings.laplacian, buffers.positions, buffers.rings, buffers.degree, layout)
    largest = jnp.inf if settings.laplacian in laplacian.BOUNDED else laplacian.LARGEST_ENTRY
    return LaplacianRows(*(jnp.minimum(weight, largest) for weight in rows))


def move_factored(
    buffers: Buffers, weights: Weights, settings: StepSettings, layout: Layout, factoring: Callable
) -> Moved:
    """`move` with a preconditioner on the host, and loops in Python. It cannot be jitted or differentiated.

    ``factoring`` makes r (n, c) -> M r of neighbour (S,), out (S,), own, shift and free (n,), see `contraction.Gram`,
    and the layout."""
    positions, reports = buffers.positions, []
    smallest = settings.solver.step_tolerance * buffers.t_c
    for energy, least in zip(_jitted_energies(buffers, weights, settings, layout), (smallest, 0.0), strict=True):
        moved = buffers._replace(positions=positions)
        operator, b = _equations(moved, energy, settings, layout)
        arrays = operator.neighbour, operator.weights[0], operator.own, operator.shift, operator.free
        precondition = factoring(*jax.device_get(arrays), layout)
        displacement, report = cg.solve_outside(operator, b, settings.solver, precondition, least)
        positions = positions + buffers.free[:, None] * displacement
        reports.append(report)
    return Moved(positions, jax.tree_util.tree_map(lambda *both: jnp.stack(both), *reports))


@partial(jax.jit, static_argnames=("settings", "layout"))
def _equations(buffers: Buffers, energy: Energy, settings: StepSettings, layout: Layout) -> tuple[Gram, jax.Array]:
    return normal_equations(buffers, _rows(buffers, settings, layout), energy, layout)


_jitted_energies = partial(jax.jit, static_argnames=("settings", "layout"))(_energies)
jitted_move = partial(jax.jit, static_argnames=("settings", "layout"))(move)
