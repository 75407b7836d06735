"""One jitted iteration of the flow: update L, contract, smooth (the first three lines of Algorithm 2's loop)."""

from functools import partial
from typing import NamedTuple

import jax
import jax.numpy as jnp

from msf_jax.device import contraction, laplacian, smoothing
from msf_jax.device.buffers import Buffers
from msf_jax.device.contraction import SolveReport
from msf_jax.options import Config, Weights


class Moved(NamedTuple):
    """Where the vertices went, and how the two solves ended."""

    positions: jax.Array
    contraction: SolveReport
    smoothing: SolveReport


def move(buffers: Buffers, weights: Weights, config: Config) -> Moved:
    """One iteration on ``buffers``; weights are scalars or (n,), one value a row.

    Differentiable in: buffers.positions, buffers.poles, weights.
    """
    _, ring, degree, free, poles, pull, area = buffers
    positions = buffers.positions
    tolerance, max_steps = config.solve_tolerance, config.solve_steps
    rows = laplacian.limit(laplacian.assemble(config.laplacian, positions, ring, degree))
    w_H = weights.w_H * jnp.ones_like(free)
    if config.w_H_follows_area:
        w_H = w_H * jnp.sqrt(area / laplacian.one_ring_areas(positions, ring, degree))
    w_L, w_M = weights.w_L * jnp.ones_like(free), weights.w_M * pull
    positions, contracted = contraction.contract(
        positions, rows, ring, free, poles, w_L, w_H, w_M, tolerance, max_steps
    )
    rows = laplacian.limit(laplacian.assemble(config.laplacian, positions, ring, degree))
    positions, smoothed = smoothing.smooth(positions, rows, ring, free, weights.smoothing, tolerance, max_steps)
    return Moved(positions, contracted, smoothed)


jitted_move = partial(jax.jit, static_argnames="config")(move)
