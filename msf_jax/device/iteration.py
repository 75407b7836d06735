"""One jitted iteration of the flow: update L, contract, smooth (the first three lines of Algorithm 2's loop)."""

from functools import partial
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
from jax import lax

from msf_jax.base.layout import Layout
from msf_jax.base.options import StepSettings, Weights
from msf_jax.device import laplacian
from msf_jax.device.buffers import Buffers
from msf_jax.device.cg import SolveReport
from msf_jax.device.contraction import contracting, relaxed, smoothing


class Moved(NamedTuple):
    """Where the vertices went, and how the solves ended: fields of ``solves`` are (2, ...), contraction first."""

    positions: jax.Array
    solves: SolveReport

    @property
    def contraction(self) -> SolveReport:
        """How the contraction ended."""
        return SolveReport(*(both[0] for both in self.solves))

    @property
    def smoothing(self) -> SolveReport:
        """How the smoothing ended."""
        return SolveReport(*(both[1] for both in self.solves))


def move(buffers: Buffers, weights: Weights, settings: StepSettings, layout: Layout, left: Any = None) -> Moved:
    """One iteration on ``buffers``; weights are scalars or (n,), one value a row.

    ``left`` (2, n, 3) are residuals that the contraction and the smoothing are to leave: those that they reported of
    another run. The two are trips of one scan: one body to compile, and to read.
    Differentiable in: buffers.positions, buffers.poles, weights; with ``buffers.t_c`` 0, which solves to the tolerance.
    """
    one = jnp.ones_like(buffers.free)
    # Only the ratios of w_L, w_H and w_M matter, and their fourth powers must stay within float32's range.
    largest = lax.stop_gradient(
        jnp.maximum(jnp.maximum(jnp.max(weights.w_L), jnp.max(weights.w_H)), jnp.max(weights.w_M))
    )
    w_L, w_H, w_M = (weight / largest * one for weight in (weights.w_L, weights.w_H, weights.w_M))
    if settings.w_H_follows_area:
        area = laplacian.one_ring_areas(buffers.positions, buffers.rings, buffers.degree, layout)
        w_H = w_H * jnp.sqrt(buffers.area / area)
    energies = contracting(w_L, w_H, w_M * buffers.pull), smoothing(weights.smoothing * one)
    smallest = settings.step_tolerance * buffers.t_c

    def relax(positions: jax.Array, line: Any) -> tuple[jax.Array, SolveReport]:
        energy, smallest, left = line
        moved = buffers._replace(positions=positions)
        rows = laplacian.assemble(settings.laplacian, positions, buffers.rings, buffers.degree, layout)
        return relaxed(moved, laplacian.limit(rows), energy, layout, settings.solver, smallest, left)

    lines = (
        jax.tree_util.tree_map(lambda *both: jnp.stack(both), *energies),
        jnp.stack([smallest, jnp.zeros_like(smallest)]),
        left,
    )
    return Moved(*lax.scan(relax, buffers.positions, lines))


jitted_move = partial(jax.jit, static_argnames=("settings", "layout"))(move)
