"""The least-squares contraction, by conjugate gradients on its normal equations (article Eq. 2).

Minimise |W_L L V'|^2 + |W_H (V' - V)|^2 + |W_M (V' - poles)|^2 over the free vertices, the fixed ones held exactly:
their rows are zero and their columns are on the right-hand side. In the displacement D = V' - V, which is zero at fixed
vertices and the natural start of the iteration, the normal equations read

    P (L^T W_L^2 L + W_H^2 + W_M^2) P D = P (W_M^2 (poles - V) - L^T W_L^2 L V),      P = 1 on free vertices, else 0.

This is the one module that imports jaxopt for a solve. jaxopt's `solve_cg` reports neither its steps nor its residual,
so the loop is a jaxopt `IterativeSolver`, whose state holds both. It is differentiated implicitly, forwards and in
reverse, at the cost of one more solve; a `jax.checkpoint` that keeps what is named "solution" does not run it again.
"""

import warnings
from dataclasses import dataclass
from functools import partial
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
from jax import lax
from jax.ad_checkpoint import checkpoint_name

with warnings.catch_warnings():
    warnings.simplefilter("ignore", DeprecationWarning)  # jaxopt announces on import that it is no longer maintained
    from jaxopt import base

from msf_jax.base.layout import Layout
from msf_jax.device.buffers import Buffers, at_rows, slot_product, slot_sum
from msf_jax.device.laplacian import Rows

SOLUTION = "solution"  # name of a solve's result, for a `jax.checkpoint` that keeps it


class SolveReport(NamedTuple):
    """How a solve of A x = b ended.

    steps: of CG. residual: |b - A x| / |b|. is_solved: whether that will do. left: (n, c) all of (b - A x) / |b|.
    """

    steps: jax.Array
    residual: jax.Array
    is_solved: jax.Array
    left: jax.Array


class CGState(NamedTuple):
    """State of the iteration; ``iter_num`` and ``error`` are jaxopt's names."""

    iter_num: jax.Array
    error: jax.Array
    residual: jax.Array
    direction: jax.Array
    gamma: jax.Array


@dataclass(eq=False)
class ConjugateGradients(base.IterativeSolver):
    """Preconditioned CG for A x = b from x = 0.

    ``error`` is the norm of the residual that the iteration carries; 0 once a step changes no entry by ``smallest``.
    """

    matvec: Any
    precondition: Any
    smallest: Any = 0.0
    maxiter: int = 2000
    tol: Any = 0.0
    implicit_diff: bool = False
    jit: bool = True
    unroll: bool = False
    verbose: bool = False

    def init_state(self, init_params: jax.Array, b: jax.Array) -> CGState:
        del init_params  # zero: the residual is b
        z = self.precondition(b)
        return CGState(jnp.asarray(0), jnp.sqrt(_dot(b, b)), b, z, _dot(b, z))

    def update(self, params: jax.Array, state: CGState, b: jax.Array) -> base.OptStep:
        del b
        product = self.matvec(state.direction)
        curvature = _dot(state.direction, product)
        # No step where rounding leaves no curvature, as once the residual is exactly zero.
        step = jnp.where(curvature > 0, state.gamma / jnp.where(curvature > 0, curvature, 1.0), 0.0)
        residual = state.residual - step * product
        z = self.precondition(residual)
        gamma = _dot(residual, z)
        beta = gamma / jnp.where(state.gamma > 0, state.gamma, 1.0)
        is_small = jnp.abs(step * state.direction).max() < self.smallest
        error = jnp.where(is_small, 0.0, jnp.sqrt(_dot(residual, residual)))
        following = CGState(state.iter_num + 1, error, residual, z + beta * state.direction, gamma)
        return base.OptStep(params + step * state.direction, following)

    def optimality_fun(self, params: jax.Array, b: jax.Array) -> jax.Array:
        return self.matvec(params) - b


def _dot(x: jax.Array, y: jax.Array) -> jax.Array:
    """Sum of x y over all entries; as a dot product it is several times as fast on the CPU as a sum."""
    return jnp.vdot(x, y, precision=lax.Precision.HIGHEST)


def norm(x: jax.Array) -> jax.Array:
    """Euclidean norm of all entries, taken of x over its largest one: squares of squared weights overflow float32.

    Differentiable in: x, with a zero gradient at 0.
    """
    largest = lax.stop_gradient(jnp.abs(x).max())
    scale = jnp.where((largest > 0) & jnp.isfinite(largest), largest, 1.0)
    square = ((x / scale) ** 2).sum()
    return jnp.where(square == 0, 0.0, scale * jnp.sqrt(jnp.where(square == 0, 1.0, square)))


class Gram(NamedTuple):
    """x -> A^T A x + shift x for A = scale (alpha I + beta L) in slots, fixed vertices' rows and columns out.

    The two products are two trips of one scan over the stacked weights: written as two calls, XLA on the CPU fuses them
    into one kernel that computes L x anew for every slot.
    """

    weights: jax.Array  # (2, S): A's off-diagonal entries by row, then by column
    diagonal: jax.Array  # (n,): A's diagonal
    shift: jax.Array  # (n,)
    free: jax.Array  # (n,) 1.0 for free vertices, 0.0 for fixed and padded ones
    neighbour: jax.Array  # (S,)

    def twice(self, layout: Layout, x: jax.Array) -> jax.Array:
        """A^T A x, for any x, fixed entries included."""

        def product(y: jax.Array, weights: jax.Array) -> tuple[jax.Array, None]:
            return self.diagonal[:, None] * y + slot_product(layout, weights, self.neighbour, y), None

        return lax.scan(product, x, self.weights)[0]

    def normal(self, layout: Layout, x: jax.Array) -> jax.Array:
        """The normal operator on free vertices; the identity on the others, to keep it definite."""
        free = self.free[:, None]
        return free * (self.twice(layout, free * x) + self.shift[:, None] * x) + (1.0 - free) * x

    def jacobi(self, layout: Layout) -> jax.Array:
        """Diagonal (n,) of the normal operator."""
        square = self.diagonal**2 + slot_sum(layout, self.weights[1] ** 2)
        return self.free * (square + self.shift) + (1.0 - self.free)


def solve(
    operator: Gram,
    layout: Layout,
    b: jax.Array,
    tolerance: float,
    max_steps: int,
    smallest: Any = 0.0,
    left: jax.Array | None = None,
) -> tuple[jax.Array, SolveReport]:
    """Solve A x = b - |b| left for the normal operator A by Jacobi-preconditioned CG from x = 0.

    Stops when the norm of the residual is at most ``tolerance`` times that of ``b``, or when a step changes no entry of
    x by ``smallest``.
    Differentiable in: operator, b; implicitly, in forward and reverse mode, by a solve to the tolerance.
    """
    b = b if left is None else b - norm(b) * left
    x, report = _run(*lax.stop_gradient((operator, b)), layout, tolerance, max_steps, lax.stop_gradient(smallest))
    report = report._replace(is_solved=checkpoint_name(report.is_solved, SOLUTION))
    return _solution(layout, tolerance, max_steps, operator, b, checkpoint_name(x, SOLUTION)), report


def _run(
    operator: Gram, b: jax.Array, layout: Layout, tolerance: float, max_steps: int, smallest: Any = 0.0
) -> tuple[jax.Array, SolveReport]:
    inverse = 1.0 / operator.jacobi(layout)[:, None]
    size = norm(b)
    scale = jnp.where((size > 0) & jnp.isfinite(size), size, 1.0)  # inside, no square leaves float32's range
    solver = ConjugateGradients(
        matvec=lambda x: operator.normal(layout, x),
        precondition=lambda r: inverse * r,
        smallest=smallest / scale,
        maxiter=max_steps,
        tol=tolerance,
    )
    x, state = solver.run(jnp.zeros_like(b), b / scale)
    left = jnp.sqrt(_dot(state.residual, state.residual))
    return scale * x, SolveReport(state.iter_num, left, state.error <= tolerance, state.residual)


@partial(jax.custom_jvp, nondiff_argnums=(0, 1, 2))
def _solution(layout: Layout, tolerance: float, max_steps: int, operator: Gram, b: jax.Array, x: jax.Array) -> Any:
    """x, for an x that solves A x = b; its derivative is that of the solution: A dx = db - dA x."""
    del layout, tolerance, max_steps, operator, b
    return x


@_solution.defjvp
def _solution_jvp(layout: Layout, tolerance: float, max_steps: int, primals: Any, tangents: Any) -> Any:
    (operator, b, x), (d_operator, db, _) = primals, tangents
    x = _solution(layout, tolerance, max_steps, operator, b, x)  # for second derivatives: it depends on both
    _, right = jax.jvp(lambda gram, rhs: rhs - gram.normal(layout, x), (operator, b), (d_operator, db))
    return x, lax.custom_linear_solve(
        lambda y: operator.normal(layout, y),
        right,
        lambda _, rhs: _run(operator, rhs, layout, tolerance, max_steps)[0],
        symmetric=True,
    )


def gram(
    rows: Rows, buffers: Buffers, layout: Layout, row_scale: jax.Array, alpha: float, beta: Any, shift: Any
) -> Gram:
    """The operator of `Gram` for A = diag(row_scale) (alpha I + beta L), rows of fixed vertices zero."""
    scale = buffers.free * row_scale
    neighbour = buffers.rings.neighbour
    out = beta * at_rows(layout, scale) * rows.out
    into = beta * scale[neighbour] * rows.into
    diagonal = scale * (alpha - beta * slot_sum(layout, rows.out))
    return Gram(jnp.stack([out, into]), diagonal, shift * buffers.free, buffers.free, neighbour)


def contract(
    buffers: Buffers,
    rows: Rows,
    layout: Layout,
    w_L: jax.Array,
    w_H: jax.Array,
    w_M: jax.Array,
    tolerance: float,
    max_steps: int,
    smallest: Any = 0.0,
    left: jax.Array | None = None,
) -> tuple[jax.Array, SolveReport]:
    """Article Eq. 2 for the surface in ``buffers`` and weights (n,) each, one per row: the new positions (n, 3).

    ``left`` (n, 3) is a residual to leave, over the norm of the right-hand side.
    Differentiable in: buffers.positions, buffers.poles, rows, w_L, w_H, w_M.
    """
    positions, free = buffers.positions, buffers.free[:, None]
    operator = gram(rows, buffers, layout, w_L, 0.0, 1.0, w_H**2 + w_M**2)
    b = free * ((w_M**2)[:, None] * (buffers.poles - positions) - operator.twice(layout, positions))
    displacement, report = solve(operator, layout, b, tolerance, max_steps, smallest, left)
    return positions + free * displacement, report
