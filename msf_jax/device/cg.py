"""Conjugate gradients for A x = b with a symmetric positive definite operator A, differentiated implicitly.

jaxopt's `solve_cg` reports neither its steps nor its residual. So the loop is a jaxopt `IterativeSolver`, whose state
has both. Derivatives are those of the solution, A dx = db - dA x, in forward and reverse mode. Each derivative costs
one more solve. With a `jax.checkpoint` whose policy saves the name "solution", the backward pass does not repeat the
solve for x. The functions in `PRECONDITIONERS` use JAX; `host/factors.py` has a preconditioner on the host.
"""

import warnings
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any, NamedTuple, Protocol

import jax
import jax.numpy as jnp
from jax import lax
from jax.ad_checkpoint import checkpoint_name

with warnings.catch_warnings():
    warnings.simplefilter("ignore", DeprecationWarning)  # jaxopt announces on import that it is no longer maintained
    from jaxopt import base, loop

from msf_jax.base.options import Solver

LOOSE = 1e-3  # relative residual: tolerances from here on are reached in float32, whose rounding is 6e-8
LONG = 4096  # entries: XLA on the CPU has a library for longer reductions
MOST_HALVINGS = 6  # so that the compiled code does not grow with the mesh
SOLUTION = "solution"  # name of a solve's result, for the policy of a `jax.checkpoint`


class Operator(Protocol):
    """A symmetric positive definite matrix (n, n); a pytree, and differentiable in its arrays."""

    def __call__(self, x: jax.Array, /) -> jax.Array:
        """A x for x (n, c)."""
        ...

    def diagonal(self) -> jax.Array:
        """(n,) the diagonal of A."""
        ...


def _jacobi(operator: Operator) -> Callable[[jax.Array], jax.Array]:
    inverse = 1.0 / operator.diagonal()[:, None]
    return lambda r: inverse * r


# A preconditioner maps an operator to the function r -> M r, with a symmetric positive definite M near A's inverse.
PRECONDITIONERS: dict[str, Callable[[Any], Callable[[jax.Array], jax.Array]]] = {"jacobi": _jacobi}


class SolveReport(NamedTuple):
    """The result of a solve of A x = b, or of A x = b - |b| left, besides x.

    steps: of CG. residual: the norm of ``left``. is_solved: whether it reached its tolerance. left: (n, c) the residual
    over |b|; CG's recursive one, which differs from the right-hand side minus A x by rounding, or that difference.
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

    ``error`` is the norm of the recursive residual. It is set to 0 once a step changes every entry by less than
    ``smallest``. It is NaN, which ends the solve unsolved, if A or M turns out not to be positive definite.
    """

    matvec: Any
    precondition: Any
    smallest: Any
    maxiter: int
    tol: Any
    implicit_diff: bool = False
    jit: bool = True
    unroll: bool = False
    verbose: bool = False

    def init_state(self, init_params: jax.Array, b: jax.Array) -> CGState:
        del init_params  # zero: the residual is b
        z = self.precondition(b)
        return CGState(jnp.asarray(0), jnp.sqrt(dot(b, b)), b, z, dot(b, z))

    def update(self, params: jax.Array, state: CGState, b: jax.Array) -> base.OptStep:
        del b
        product = self.matvec(state.direction)
        curvature = dot(state.direction, product)
        # Make no step if rounding leaves no curvature, for example once the residual is exactly zero.
        is_curved = (curvature > 0) & (state.gamma > 0)
        step = jnp.where(is_curved, state.gamma / jnp.where(is_curved, curvature, 1.0), 0.0)
        residual = state.residual - step * product
        z = self.precondition(residual)
        gamma = dot(residual, z)
        beta = gamma / jnp.where(state.gamma > 0, state.gamma, 1.0)
        is_small = (jnp.abs(step * state.direction) < self.smallest).all()
        error = jnp.sqrt(dot(residual, residual))
        error = jnp.where(is_curved | (error <= self.tol), jnp.where(is_small, 0.0, error), jnp.nan)
        following = CGState(state.iter_num + 1, error, residual, z + beta * state.direction, gamma)
        return base.OptStep(params + step * state.direction, following)

    def run(self, init_params: jax.Array, *args: Any, **kwargs: Any) -> base.OptStep:
        """Like the base class, but with the first update inside the loop. The loop's body then exists once, and
        compiles in two thirds of the time. The first update always runs, and passes a NaN in the right-hand side on."""

        def is_on(step: base.OptStep) -> jax.Array:
            return (step.state.iter_num == 0) | (step.state.error > self.tol)

        def follow(step: base.OptStep) -> base.OptStep:
            return self.update(step.params, step.state, *args, **kwargs)

        start = base.OptStep(init_params, self.init_state(init_params, *args, **kwargs))
        return loop.while_loop(is_on, follow, start, self.maxiter, unroll=self.unroll, jit=self.jit)

    def optimality_fun(self, params: jax.Array, b: jax.Array) -> jax.Array:
        return self.matvec(params) - b


def dot(x: jax.Array, y: jax.Array) -> jax.Array:
    """Sum of x y over all entries.

    One half of the rows is added to the other until few entries are left: additions are fast on the CPU in all versions
    of XLA, unlike a long reduction (see `buffers.added`), and they round less.
    """
    products = x * y
    for _ in range(MOST_HALVINGS):
        half, is_odd = divmod(len(products), 2)
        if is_odd or products.size < LONG:
            break
        products = products[:half] + products[half:]
    return products.sum()


def norm(x: jax.Array) -> jax.Array:
    """Euclidean norm of all entries. Entries are first divided by the largest, because squares can overflow float32.

    Differentiable in: x; the gradient at 0 is 0.
    """
    largest = lax.stop_gradient(jnp.abs(x).max())
    scale = jnp.where((largest > 0) & jnp.isfinite(largest), largest, 1.0)
    unit = x / scale
    square = dot(unit, unit)
    return jnp.where(square == 0, 0.0, scale * jnp.sqrt(jnp.where(square == 0, 1.0, square)))


def solve(
    operator: Any, b: jax.Array, solver: Solver, smallest: Any = 0.0, left: jax.Array | None = None
) -> tuple[jax.Array, SolveReport]:
    """Solve A x = b - |b| left for an `Operator` A and b (n, c), from x = 0; without ``left``, A x = b.

    Stops when the norm of the residual is at most the solver's tolerance times |b|, or when a step changes every entry
    of x by less than ``smallest``.
    Differentiable in: operator, b; implicitly, in forward and reverse mode, by a solve to the tolerance.
    """
    size = norm(b)
    b = b if left is None else b - size * left
    x, report = _run(*lax.stop_gradient((operator, b, size)), solver, lax.stop_gradient(smallest), may_round=True)
    report = report._replace(is_solved=checkpoint_name(report.is_solved, SOLUTION))
    return _solution(solver, operator, b, checkpoint_name(x, SOLUTION)), report


def solve_outside(
    operator: Any, b: jax.Array, solver: Solver, precondition: Callable[[jax.Array], jax.Array], smallest: Any = 0.0
) -> tuple[jax.Array, SolveReport]:
    """Like `solve`, with a loop in Python. It cannot be jitted or differentiated.

    So ``precondition``, r -> M r, may be a function on the host, unlike those of `PRECONDITIONERS`.
    """
    scale = _scale(norm(b))
    found = _iterated(
        partial(_product, operator), precondition, b / scale, solver, smallest / scale, jit=False, unroll=True
    )
    return scale * found[0], found[1]


@jax.jit
def _product(operator: Any, x: jax.Array) -> jax.Array:
    return operator(x)


def _scale(size: jax.Array) -> jax.Array:
    """b over it has norm 1, or nearly if something is left, so no square overflows float32."""
    return jnp.where((size > 0) & jnp.isfinite(size), size, 1.0)


def _run(
    operator: Any, b: jax.Array, size: jax.Array, solver: Solver, smallest: Any = 0.0, may_round: bool = False
) -> tuple[jax.Array, SolveReport]:
    """Solve for b; residuals are relative to ``size``.

    If the tolerance is loose and it ``may_round``, it runs in float32, where a step takes two thirds of the time. The
    entries of A must then be in float32's range. The residual is computed from x, so that what the solve leaves is as
    exact as b, and the solve counts as solved if rounding has at most doubled it.
    """
    # A traced tolerance may be tight.
    is_short = may_round and isinstance(solver.tolerance, float) and solver.tolerance >= LOOSE

    def short(values: Any) -> jax.Array:
        is_real = jnp.issubdtype(jnp.result_type(values), jnp.floating)
        return jnp.asarray(values, jnp.float32 if is_real and is_short else None)

    scale = _scale(size)
    A, right, least = jax.tree_util.tree_map(short, (operator, b / scale, smallest / scale))
    x, report = _iterated(A, PRECONDITIONERS[solver.preconditioner](A), right, solver, least)
    if x.dtype != b.dtype:
        x = x.astype(b.dtype)
        left = b / scale - operator(x)
        residual = jnp.sqrt(dot(left, left))
        ends_by_step = report.residual > solver.tolerance  # each entry changed by less than ``smallest``
        is_solved = report.is_solved & (ends_by_step | (residual <= 2 * solver.tolerance))
        report = report._replace(left=left, residual=residual, is_solved=is_solved)
    return scale * x, report


def _iterated(
    matvec: Any, precondition: Any, b: jax.Array, solver: Solver, smallest: Any, **options: bool
) -> tuple[jax.Array, SolveReport]:
    """Solve for b of about norm 1."""
    solving = ConjugateGradients(matvec, precondition, smallest, solver.max_steps, solver.tolerance, **options)
    x, state = solving.run(jnp.zeros_like(b), b)
    residual = jnp.sqrt(dot(state.residual, state.residual))
    return x, SolveReport(state.iter_num, residual, state.error <= solver.tolerance, state.residual)


@partial(jax.custom_jvp, nondiff_argnums=(0,))
def _solution(solver: Solver, operator: Any, b: jax.Array, x: jax.Array) -> Any:
    """x, which solves A x = b. Its derivative is that of the solution: A dx = db - dA x."""
    del solver, operator, b
    return x


@_solution.defjvp
def _solution_jvp(solver: Solver, primals: Any, tangents: Any) -> Any:
    (operator, b, x), (d_operator, db, _) = primals, tangents
    x = _solution(solver, operator, b, x)  # so that second derivatives see that x depends on A and b
    _, right = jax.jvp(lambda A, rhs: rhs - A(x), (operator, b), (d_operator, db))

    def solved(_: Any, rhs: jax.Array) -> jax.Array:
        return _run(operator, rhs, norm(rhs), solver)[0]

    return x, lax.custom_linear_solve(operator, right, solved, symmetric=True)
