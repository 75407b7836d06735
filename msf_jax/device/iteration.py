"""One jitted iteration of the flow: update L, contract, smooth (the first three lines of Algorithm 2's loop)."""

from collections.abc import Callable, Hashable
from functools import partial
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
from jax import lax

from msf_jax.base.layout import Layout
from msf_jax.base.options import Config, Weights
from msf_jax.device import contraction, laplacian, smoothing
from msf_jax.device.buffers import Buffers
from msf_jax.device.contraction import SolveReport


class Moved(NamedTuple):
    """Where the vertices went, and how the two solves ended."""

    positions: jax.Array
    contraction: SolveReport
    smoothing: SolveReport


def move(buffers: Buffers, weights: Weights, config: Config, layout: Layout, left: Any = (None, None)) -> Moved:
    """One iteration on ``buffers``; weights are scalars or (n,), one value a row.

    ``left`` (2, n, 3) are residuals that the contraction and the smoothing are to leave: those that they reported of
    another run.
    Differentiable in: buffers.positions, buffers.poles, weights; with ``buffers.t_c`` 0, which solves to the tolerance.
    """
    one = jnp.ones_like(buffers.free)
    # Only the ratios of w_L, w_H and w_M matter, and their fourth powers must stay within float32's range.
    largest = lax.stop_gradient(
        jnp.maximum(jnp.maximum(jnp.max(weights.w_L), jnp.max(weights.w_H)), jnp.max(weights.w_M))
    )
    tolerance, max_steps = config.solve_tolerance, config.solve_steps
    w_L, w_H, w_M = (weight / largest * one for weight in (weights.w_L, weights.w_H, weights.w_M))
    if config.w_H_follows_area:
        area = laplacian.one_ring_areas(buffers.positions, buffers.rings, buffers.degree, layout)
        w_H = w_H * jnp.sqrt(buffers.area / area)
    positions, contracted = contraction.contract(
        buffers,
        _rows(buffers, config, layout),
        layout,
        w_L,
        w_H,
        w_M * buffers.pull,
        tolerance,
        max_steps,
        config.step_tolerance * buffers.t_c,
        left[0],
    )
    buffers = buffers._replace(positions=positions)
    positions, smoothed = smoothing.smooth(
        buffers, _rows(buffers, config, layout), layout, weights.smoothing * one, tolerance, max_steps, left[1]
    )
    return Moved(positions, contracted, smoothed)


def _rows(buffers: Buffers, config: Config, layout: Layout) -> laplacian.Rows:
    rows = laplacian.assemble(config.laplacian, buffers.positions, buffers.rings, buffers.degree, layout)
    return laplacian.limit(rows)


jitted_move = partial(jax.jit, static_argnames=("config", "layout"))(move)

_compiled: dict[Hashable, Callable[[Buffers, Weights], Moved]] = {}


def compiled_move(
    buffers: Buffers, weights: Weights, config: Config, layout: Layout
) -> Callable[[Buffers, Weights], Moved]:
    """`move` for such arguments, as a function of the first two; compiled at the first call, which takes seconds."""
    if jax.config.jax_disable_jit:  # pyright: ignore[reportAttributeAccessIssue]
        return lambda buffers, weights: move(buffers, weights, config, layout)
    leaves = jax.tree_util.tree_leaves((buffers, weights))
    key = (config, layout, *((leaf.shape, leaf.dtype, leaf.sharding) for leaf in leaves))
    if key not in _compiled:
        _compiled[key] = jitted_move.lower(buffers, weights, config, layout).compile()
    return _compiled[key]
