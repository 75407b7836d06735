"""Contraction and smoothing (an implicit Laplacian step; Desbrun et al. 1999): the same least-squares step with
different parameters (article Eq. 2 and 3.2.3).

The unknown is the displacement D = V' - V, which is zero at fixed vertices. The step minimises

    |A D + beta L V|^2 + |hold^(1/2) D|^2 + |attract^(1/2) (V + D - poles)|^2,    A = diag(alpha) + diag(beta) L.

    contraction: alpha = 0, beta = w_L, hold = w_H^2, attract = w_M^2;
                 |W_L L V'|^2 + |W_H (V' - V)|^2 + |W_M (V' - poles)|^2
    smoothing:   alpha = 1, beta = -lambda, hold = attract = 0;
                 |(I - lambda L) V' - V|^2, which is 0 where (I - lambda L) V' = V

Fixed vertices are held exactly: their rows are zero, and their columns are on the right-hand side. Normal equations:

    P (A^T A + hold + attract) P D = P (attract (poles - V) - A^T beta L V),      P = 1 on free vertices, else 0.
"""

from dataclasses import dataclass, field
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
from jax import lax

from msf_jax.base.layout import Layout
from msf_jax.base.options import SolverOptions
from msf_jax.device import cg
from msf_jax.device.buffers import Buffers, at_rows, slot_product, slot_sum
from msf_jax.device.cg import SolveReport
from msf_jax.device.laplacian import LaplacianRows


class Energy(NamedTuple):
    """The parameters of a step, see the module: (n,) each, one value a row."""

    alpha: jax.Array
    beta: jax.Array
    hold: jax.Array
    attract: jax.Array


@jax.tree_util.register_dataclass
@dataclass(frozen=True)
class Gram:
    """The normal operator x -> P (A^T A + shift) P x on free vertices, and the identity on the others.

    weights: (2, S) A's off-diagonal entries, by row and then by column. own: (n,) A's diagonal. shift: (n,). free: (n,)
    1.0 for free vertices, 0.0 for fixed and padded ones. neighbour: (S,). layout: of the slots.
    """

    weights: jax.Array
    own: jax.Array
    shift: jax.Array
    free: jax.Array
    neighbour: jax.Array
    layout: Layout = field(metadata={"static": True})

    def __call__(self, x: jax.Array) -> jax.Array:
        free = self.free[:, None]
        return free * (self.transposed_after(self.own, free * x) + self.shift[:, None] * x) + (1.0 - free) * x

    def diagonal(self) -> jax.Array:
        """(n,) the operator's diagonal."""
        square = self.own**2 + slot_sum(self.layout, self.weights[1] ** 2)
        return self.free * (square + self.shift) + (1.0 - self.free)

    def transposed_after(self, diagonal: jax.Array, x: jax.Array) -> jax.Array:
        """A^T (A + diag(diagonal - own)) x: ``diagonal`` (n,) replaces the diagonal of the first factor.

        Two steps of one scan: XLA on the CPU would fuse two calls into a kernel that computes A x for every slot."""

        def product(y: jax.Array, line: Any) -> tuple[jax.Array, None]:
            own, weights = line
            return own[:, None] * y + slot_product(self.layout, weights, self.neighbour, y), None

        return lax.scan(product, x, (jnp.stack([diagonal, self.own]), self.weights))[0]


def relaxed(
    buffers: Buffers,
    rows: LaplacianRows,
    energy: Energy,
    layout: Layout,
    solver: SolverOptions,
    smallest: Any = 0.0,
    left: jax.Array | None = None,
) -> tuple[jax.Array, SolveReport]:
    """The positions (n, 3) that minimise ``energy`` for the surface in ``buffers`` with the Laplacian ``rows``.

    ``left`` (n, 3) is the residual to leave, over the norm of the right-hand side. For ``smallest`` see `cg.solve`.
    Differentiable in: buffers.positions, buffers.poles, rows, energy.
    """
    operator, b = normal_equations(buffers, rows, energy, layout)
    displacement, report = cg.solve(operator, b, solver, smallest, left)
    return buffers.positions + buffers.free[:, None] * displacement, report


def normal_equations(buffers: Buffers, rows: LaplacianRows, energy: Energy, layout: Layout) -> tuple[Gram, jax.Array]:
    """The operator, and the right-hand side (n, 3), of the displacement that minimises ``energy``; see the module.
    Differentiable as `relaxed` is."""
    positions, free, neighbour = buffers.positions, buffers.free[:, None], buffers.rings.neighbour
    beta = buffers.free * energy.beta
    out, into = at_rows(layout, beta) * rows.out, beta[neighbour] * rows.into
    towards = slot_sum(layout, out)
    own = buffers.free * energy.alpha - towards
    shift = buffers.free * (energy.hold + energy.attract)
    operator = Gram(jnp.stack([out, into]), own, shift, buffers.free, neighbour, layout)
    bent = operator.transposed_after(-towards, positions)  # A^T beta L V
    return operator, free * (energy.attract[:, None] * (buffers.poles - positions) - bent)
