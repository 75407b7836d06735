"""Conjugate gradients for A x = b with a symmetric positive definite operator A, differentiated implicitly.

jaxopt's `solve_cg` reports neither its steps nor its residual. So the loop is a jaxopt `IterativeSolver`, whose state
has both. It is the solve of a `lax.custom_linear_solve`. So derivatives of any order, in every transformation, are
those of the solution, A dx = db - dA x. Each derivative costs one more solve. With a `jax.checkpoint` whose policy is
`keeps_solutions`, the backward pass does not repeat the solve for x. The functions in `PRECONDITIONERS` use JAX;
`numerics/factors.py` has a preconditioner on the host.
"""

import warnings
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any, NamedTuple, Protocol

import jax
import jax.numpy as jnp
from jax import lax

with warnings.catch_warnings():
    warnings.simplefilter("ignore", DeprecationWarning)  # jaxopt announces on import that it is no longer maintained
    from jaxopt import base, loop

from msf_jax.base.options import Solver

LOOSE = 1e-3  # relative residual: tolerances from here on are reached in float32, whose rounding is 6e-8
WINDOW = 16  # steps whose lengths are compared with those of as many before, see `_distance_left`
SLOWEST = 0.95  # largest ratio of the two that is believed: an error of 19 times the last steps
LONG_REDUCTION = 4096  # entries: XLA on the CPU has a library for longer reductions
MOST_HALVINGS = 6  # so that the compiled code does not grow with the mesh


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

    steps: of CG. residual: the norm of ``left``. is_solved: whether it reached its tolerance, or ended by its last step
    with an ``error`` below the norm of x and a residual below 1. left: (n, c) the residual over |b|; CG's recursive
    one, which differs from the right-hand side minus A x by rounding, or that difference. error: an estimate of the
    norm of x minus the solution, see `_distance_left`.
    """

    steps: jax.Array
    residual: jax.Array
    is_solved: jax.Array
    left: jax.Array
    error: jax.Array


class CGState(NamedTuple):
    """State of the iteration; ``iter_num`` and ``error`` are jaxopt's names. lengths: of the last steps, in a ring."""

    iter_num: jax.Array
    error: jax.Array
    residual: jax.Array
    direction: jax.Array
    gamma: jax.Array
    lengths: jax.Array


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
        return CGState(jnp.asarray(0), jnp.sqrt(dot(b, b)), b, z, dot(b, z), jnp.zeros(2 * WINDOW, b.dtype))

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
        length = step * jnp.sqrt(dot(state.direction, state.direction))
        lengths = state.lengths.at[state.iter_num % (2 * WINDOW)].set(length)
        following = CGState(state.iter_num + 1, error, residual, z + beta * state.direction, gamma, lengths)
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
    of XLA, unlike a long reduction, and they round less.
    """
    products = x * y
    for _ in range(MOST_HALVINGS):
        half, is_odd = divmod(len(products), 2)
        if is_odd or products.size < LONG_REDUCTION:
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
    If the tolerance is loose, it runs in float32, where a step takes two thirds of the time. The entries of A must then
    be in float32's range. Under differentiation it runs in the type of b.
    Differentiable in: operator, b; implicitly, to any order, by solves to the tolerance. A derivative whose solve does
    not reach the tolerance is NaN.
    """
    # A traced tolerance may be tight.
    if isinstance(solver.tolerance, float) and solver.tolerance >= LOOSE:
        return _rounded(solver, operator, b, smallest, left)
    return _solved(solver, operator, b, smallest, left)


def keeps_solutions(primitive: Any, *_: Any, **__: Any) -> bool:
    """A policy for `jax.checkpoint` that stores the results of solves, and recomputes the rest."""
    return primitive is lax.linear_solve_p


def _solved(
    solver: Solver, operator: Any, b: jax.Array, smallest: Any, left: Any, is_short: bool = False
) -> tuple[jax.Array, SolveReport]:
    """`solve` in the type of b, or in float32 if ``is_short``.

    Four further rows of the right-hand side have the limits of the solve, |b| and ``smallest``; those of the unknown
    have its report. JAX calls the same function for derivatives, whose limits are 0: they are solved to the tolerance,
    and are NaN if not. (Limits as a second array are refused, because JAX transposes only what depends on the tangents
    altogether. A report as auxiliary data becomes a batch under `jax.jacfwd`, which is refused, too.)
    """
    size = norm(b)
    right = b if left is None else b - size * left
    zero = jnp.zeros((), b.dtype)
    limits = lax.stop_gradient(jnp.stack([size, jnp.asarray(smallest, b.dtype), zero, zero]))

    def columns(rows: jax.Array) -> jax.Array:
        return jnp.broadcast_to(rows[:, None], (4, b.shape[1]))

    def product(unknown: jax.Array) -> jax.Array:
        return jnp.concatenate([operator(unknown[:-4]), unknown[-4:]])

    def solved(_: Any, given: jax.Array) -> jax.Array:
        rhs, size, smallest = given[:-4], given[-4, 0], given[-3, 0]
        is_first = ~(size == 0)
        x, report = _run(operator, rhs, jnp.where(is_first, size, norm(rhs)), solver, smallest, is_short)
        said = (report.steps, report.residual, report.is_solved, report.error)
        said = columns(jnp.stack([jnp.asarray(value, b.dtype) for value in said]))
        is_given = is_first | (rhs == 0).all()  # a first solve for 0, too
        x = jnp.where(is_given | report.is_solved, x, jnp.nan)
        return jnp.concatenate([x, jnp.where(is_first, said, given[-4:])])

    given = jnp.concatenate([right, columns(limits)])
    found = lax.custom_linear_solve(product, given, solved, symmetric=True)
    steps, residual, is_solved, error = lax.stop_gradient(found[-4:, 0])
    x, given, operator = lax.stop_gradient((found[:-4], right, operator))
    rest = (given - operator(x)) / lax.stop_gradient(_scale(size))
    is_solved = (is_solved > 0) | (lax.stop_gradient(size) == 0)
    return found[:-4], SolveReport(steps.astype(int), residual, is_solved, rest, error)


@partial(jax.custom_jvp, nondiff_argnums=(0,))
def _rounded(solver: Solver, operator: Any, b: jax.Array, smallest: Any, left: Any) -> tuple[jax.Array, SolveReport]:
    """`solve` in float32. Partial evaluation may drop the rule below: then derivatives are computed in float32, too."""
    return _solved(solver, operator, b, smallest, left, is_short=True)


@_rounded.defjvp
def _rounded_jvp(solver: Solver, primals: Any, tangents: Any) -> Any:
    return jax.jvp(partial(_solved, solver), primals, tangents)


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
    return scale * found[0], found[1]._replace(error=scale * found[1].error)


@jax.jit
def _product(operator: Any, x: jax.Array) -> jax.Array:
    return operator(x)


def _scale(size: jax.Array) -> jax.Array:
    """b over it has norm 1, or nearly if something is left, so no square overflows float32."""
    return jnp.where((size > 0) & jnp.isfinite(size), size, 1.0)


def _run(
    operator: Any, b: jax.Array, size: jax.Array, solver: Solver, smallest: Any, is_short: bool
) -> tuple[jax.Array, SolveReport]:
    """Solve for b; residuals are relative to ``size``.

    If it ``is_short``, it runs in float32. The residual is computed from x, so that what the solve leaves is as exact
    as b, and the solve counts as solved if rounding has at most doubled it.
    """

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
    return scale * x, report._replace(error=scale * report.error.astype(scale.dtype))


def _distance_left(state: CGState) -> jax.Array:
    """An estimate of the norm of x minus the solution: the lengths of the last steps, continued geometrically.

    A step's own length bounds nothing, as many short ones may follow. Nor is this a bound: on three surfaces it was
    between an eighth of the error and 18 times as much, with a median of 1.4. It was less than half of it in solves of
    20 to 40 steps, and down to a fortieth with weights of almost 0. Bounds of Gauss and Radau, from the least of
    w_H^2 + w_M^2, are right, and were 4 to 1,300 times too large.
    """
    window = jnp.clip(state.iter_num // 2, 1, WINDOW)
    age = (state.iter_num - 1 - jnp.arange(2 * WINDOW)) % (2 * WINDOW)
    last = jnp.where(age < window, state.lengths, 0).sum()
    before = jnp.where((age >= window) & (age < 2 * window), state.lengths, 0).sum()
    ratio = jnp.where(before > 0, jnp.minimum(last / jnp.where(before > 0, before, 1.0), SLOWEST), 0.5)
    return last * ratio / (1 - ratio)


def _iterated(
    matvec: Any, precondition: Any, b: jax.Array, solver: Solver, smallest: Any, **options: bool
) -> tuple[jax.Array, SolveReport]:
    """Solve for b of about norm 1."""
    solving = ConjugateGradients(matvec, precondition, smallest, solver.max_steps, solver.tolerance, **options)
    x, state = solving.run(jnp.zeros_like(b), b)
    residual = jnp.sqrt(dot(state.residual, state.residual))
    error = _distance_left(state)
    is_close = (residual < 1) & (error <= jnp.maximum(jnp.sqrt(dot(x, x)), smallest * x.size**0.5))
    is_solved = (state.error <= solver.tolerance) & (is_close | (residual <= solver.tolerance))
    return x, SolveReport(state.iter_num, residual, is_solved, state.residual, error)
