"""Implicit Laplacian smoothing, (I - lambda L) V' = V with fixed vertices held (article 3.2.3; Desbrun et al. 1999)."""

import jax
import jax.numpy as jnp

from msf_jax.base.layout import Layout
from msf_jax.device import contraction
from msf_jax.device.buffers import Buffers, at_rows, slot_product, slot_sum
from msf_jax.device.contraction import SolveReport
from msf_jax.device.laplacian import Rows


def smooth(
    buffers: Buffers,
    rows: Rows,
    layout: Layout,
    strength: jax.Array,
    tolerance: float,
    max_steps: int,
    left: jax.Array | None = None,
) -> tuple[jax.Array, SolveReport]:
    """One implicit step of ``strength`` lambda (dimensionless, like L, per row (n,)): the new positions (n, 3).

    The matrix is not symmetric, so its normal equations are solved, for the displacement D: with A = I - lambda L and
    the fixed rows out, A D = lambda L V becomes A^T A D = A^T lambda L V. ``left`` (n, 3) is a residual to leave, over
    the norm of the right-hand side.
    Differentiable in: buffers.positions, rows, strength.
    """
    positions, free = buffers.positions, buffers.free[:, None]
    scaled = Rows(rows.out * at_rows(layout, strength), rows.into * strength[buffers.rings.neighbour])
    operator = contraction.gram(scaled, buffers, layout, jnp.ones_like(buffers.free), 1.0, -1.0, jnp.zeros(()))
    pull = slot_product(layout, scaled.out, buffers.rings.neighbour, positions)
    pull = free * (pull - slot_sum(layout, scaled.out)[:, None] * positions)
    b = slot_product(layout, operator.weights[1], buffers.rings.neighbour, pull) + operator.diagonal[:, None] * pull
    displacement, report = contraction.solve(operator, layout, free * b, tolerance, max_steps, left=left)
    return positions + free * displacement, report
