"""Implicit Laplacian smoothing, (I - lambda L) V' = V with fixed vertices held (article 3.2.3; Desbrun et al. 1999)."""

import jax
import jax.numpy as jnp

from msf_jax.device import contraction
from msf_jax.device.contraction import SolveReport
from msf_jax.device.laplacian import Rows


def smooth(
    positions: jax.Array,
    rows: Rows,
    ring: jax.Array,
    free: jax.Array,
    strength: jax.Array,
    tolerance: jax.Array,
    max_steps: int,
) -> tuple[jax.Array, SolveReport]:
    """One implicit step of ``strength`` lambda (dimensionless, like L) for positions (n, 3), free (n,).

    The matrix is not symmetric, so its normal equations are solved, for the displacement D: with A = I - lambda L and
    the fixed rows out, A D = lambda L V becomes A^T A D = A^T lambda L V. Differentiable in: positions, rows, strength.
    """
    operator = contraction.gram(rows, ring, free, jnp.ones_like(free), 1.0, -strength, jnp.zeros_like(free))
    pull = contraction.slot_product(rows.out, -rows.out.sum(0), ring, positions)
    right = strength * free[:, None] * pull
    b = free[:, None] * contraction.slot_product(operator.weights[1], operator.diagonal, ring, right)
    displacement, report = contraction.solve(operator, operator.jacobi(), b, tolerance, max_steps)
    return positions + free[:, None] * displacement, report
