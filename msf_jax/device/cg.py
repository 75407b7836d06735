"""Conjugate gradients for A x = b with a symmetric positive definite operator A, differentiated implicitly.

jaxopt's `solve_cg` reports neither its steps nor its residual. So the loop is a jaxopt `IterativeSolver`, whose state
has both. It is the solve of a `lax.custom_linear_solve`. So derivatives of any order, in every transformation, are
those of the solution, A dx = db - dA x. Each derivative costs one more solve. With a `jax.checkpoint` whose policy is
`keeps_solutions`, the backward pass does not repeat the solve for x. The functions in `PRECONDITIONERS` use JAX;
`numerics/factors.py` has a preconditioner on the host.
"""

import warnings
from collections.abc import Callable, Sequence
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

    def least(self) -> tuple[jax.Array, jax.Array]:
        """(n,) d, such that A - diag(d) has no negative eigenvalue, for the bound of an error; and the quotient
        x A x / x x that is expected of an error x, for its estimate."""
        ...


def _jacobi(operator: Operator) -> Callable[[jax.Array], jax.Array]:
    inverse = 1.0 / operator.diagonal()[:, None]
    return lambda r: inverse * r


# A preconditioner maps an operator to the function r -> M r, with a symmetric positive definite M near A's inverse.
PRECONDITIONERS: dict[str, Callable[[Any], Callable[[jax.Array], jax.Array]]] = {"jacobi": _jacobi}


class SolveReport(NamedTuple):
    """The result of a solve of A x = b, or of A x = b - |b| left, besides x.

    steps: of CG. left: (n, c) the right-hand side minus A x, over |b|. residual: the norm of that. is_solved: whether
    the ``bound`` is at most the error that was allowed, or without one, whether the residual reached its tolerance, but
    for rounding. has_ended: whether it ended by its tolerance or by a short step, and not by the number of steps or an
    A without positive curvature. error: an estimate of the norm of x minus the solution, which may be far too small.
    bound: that norm is not larger. Both are explained at `_reported`.
    """

    steps: jax.Array
    residual: jax.Array
    is_solved: jax.Array
    has_ended: jax.Array
    left: jax.Array
    error: jax.Array
    bound: jax.Array


class Ritz(NamedTuple):
    """What `Ritz.after` needs of the steps before, see there; a scalar each."""

    turn: jax.Array  # beta over the length of the step
    last: jax.Array  # |R^-1 e|^2, for the last unit vector e
    most: jax.Array  # |R^-1 v|^2, for a unit vector v that makes it large
    both: jax.Array  # the scalar product of R^-1 e and R^-1 v

    def after(self, step: jax.Array, beta: jax.Array) -> "Ritz":
        """With one more step of CG. 1 / ``most`` estimates the smallest Ritz value, which tends to the least eigenvalue
        of M A from above.

        Steps and betas are the Cholesky factor R of the Lanczos matrix. R grows by a column, and v is turned towards
        the new unit vector so that |R^-1 v| is largest (Meurant, Tichy 2019, "Approximating the extreme Ritz values").
        """
        tilt = jnp.sqrt(self.turn * step)
        last, across = tilt**2 * self.last + step, -tilt * self.both
        angle = 0.5 * jnp.arctan2(2 * across, self.most - last)
        most = (self.most + last) / 2 + jnp.hypot((self.most - last) / 2, across)
        both = jnp.cos(angle) * across + jnp.sin(angle) * last
        return Ritz(beta / jnp.where(step > 0, step, 1.0), last, most, both)


class CGState(NamedTuple):
    """State of the iteration; ``iter_num`` and ``error`` are jaxopt's names. share: of the squared length of the
    direction that is the residual's, both measured by M."""

    iter_num: jax.Array
    error: jax.Array
    residual: jax.Array
    direction: jax.Array
    gamma: jax.Array
    share: jax.Array
    ritz: Ritz


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
        gamma = dot(b, z)
        zero = jnp.zeros_like(gamma)
        return CGState(jnp.asarray(0), jnp.sqrt(dot(b, b)), b, z, gamma, zero + 1, Ritz(zero, zero, zero, zero))

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
        share = state.share / (state.share + beta)
        ritz = state.ritz.after(step, beta)
        following = CGState(state.iter_num + 1, error, residual, z + beta * state.direction, gamma, share, ritz)
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
    operator: Any,
    b: jax.Array,
    solver: Solver,
    smallest: Any = 0.0,
    left: jax.Array | None = None,
    allowed: Any = 0.0,
) -> tuple[jax.Array, SolveReport]:
    """Solve A x = b - |b| left for an `Operator` A and b (n, c), from x = 0; without ``left``, A x = b.

    Stops when the norm of the residual is at most the solver's tolerance times |b|, or when a step changes every entry
    of x by less than ``smallest``. With ``allowed``, a norm, it counts as solved if the bound of its error is at most
    that.
    If the tolerance is loose, it runs in float32, where a step takes two thirds of the time. The entries of A must then
    be in float32's range. Under differentiation it runs in the type of b.
    Differentiable in: operator, b; implicitly, to any order, by solves to the tolerance. A derivative whose solve does
    not reach the tolerance is NaN.
    """
    # A traced tolerance may be tight.
    if isinstance(solver.tolerance, float) and solver.tolerance >= LOOSE:
        return _rounded(solver, operator, b, (smallest, allowed), left)
    return _solved(solver, operator, b, (smallest, allowed), left)


def keeps_solutions(primitive: Any, *_: Any, **__: Any) -> bool:
    """A policy for `jax.checkpoint` that stores the results of solves, and recomputes the rest."""
    return primitive is lax.linear_solve_p


def _solved(
    solver: Solver, operator: Any, b: jax.Array, lengths: tuple[Any, Any], left: Any, is_short: bool = False
) -> tuple[jax.Array, SolveReport]:
    """`solve` in the type of b, or in float32 if ``is_short``. ``lengths``: smallest and allowed.

    Six further rows of the right-hand side have the limits of the solve, |b| and ``lengths``; those of the unknown have
    its report. JAX calls the same function for derivatives, whose limits are 0: they are solved to the tolerance,
    and are NaN if not. (Limits as a second array are refused, because JAX transposes only what depends on the tangents
    altogether. A report as auxiliary data becomes a batch under `jax.jacfwd`, which is refused, too.)
    """
    operator, b, left, lengths = _together((operator, b, left, lengths))
    size = norm(b)
    right = b if left is None else b - size * left
    zero = jnp.zeros((), b.dtype)
    limits = jnp.stack([size, *(jnp.asarray(length, b.dtype) for length in lengths), zero, zero, zero])
    limits = lax.stop_gradient(limits)

    def columns(rows: jax.Array) -> jax.Array:
        return jnp.broadcast_to(rows[:, None], (6, b.shape[1]))

    def product(unknown: jax.Array) -> jax.Array:
        return jnp.concatenate([operator(unknown[:-6]), unknown[-6:]])

    def solved(_: Any, given: jax.Array) -> jax.Array:
        rhs, size, lengths = given[:-6], given[-6, 0], (given[-5, 0], given[-4, 0])
        is_first = ~(size == 0)
        x, report = _run(operator, rhs, jnp.where(is_first, size, norm(rhs)), solver, lengths, is_short)
        said = (report.steps, report.residual, report.is_solved, report.has_ended, report.error, report.bound)
        said = columns(jnp.stack([jnp.asarray(value, b.dtype) for value in said]))
        is_given = is_first | (rhs == 0).all()  # a first solve for 0, too
        x = jnp.where(is_given | report.is_solved, x, jnp.nan)
        return jnp.concatenate([x, jnp.where(is_first, said, jnp.zeros_like(said))])

    given = jnp.concatenate([right, columns(limits)])
    found = lax.custom_linear_solve(product, given, solved, symmetric=True)
    steps, residual, is_solved, has_ended, error, bound = lax.stop_gradient(found[-6:, 0])
    x, given, operator = lax.stop_gradient((found[:-6], right, operator))
    rest = (given - operator(x)) / lax.stop_gradient(_scale(size))
    is_nothing = lax.stop_gradient(size) == 0
    is_solved, has_ended = (is_solved > 0) | is_nothing, (has_ended > 0) | is_nothing
    return found[:-6], SolveReport(steps.astype(int), residual, is_solved, has_ended, rest, error, bound)


def _together(values: Any) -> Any:
    """``values``, each declared to differ between the devices of a `jax.shard_map` if one of them does.

    JAX would declare it inside the solve, where it is refused if a scan has declared the values outside since.
    """
    arrays, structure = jax.tree_util.tree_flatten(values)
    arrays = [jnp.asarray(array) for array in arrays]
    axes = [jax.typeof(array).mat.varying for array in arrays]
    every = frozenset().union(*axes)
    spread = (
        lax.pcast(array, tuple(every - own), to="varying") if every - own else array
        for array, own in zip(arrays, axes, strict=True)
    )
    return structure.unflatten(spread)


@partial(jax.custom_jvp, nondiff_argnums=(0,))
def _rounded(solver: Solver, operator: Any, b: jax.Array, lengths: Any, left: Any) -> tuple[jax.Array, SolveReport]:
    """`solve` in float32. Partial evaluation may drop the rule below: then derivatives are computed in float32, too."""
    return _solved(solver, operator, b, lengths, left, is_short=True)


@_rounded.defjvp
def _rounded_jvp(solver: Solver, primals: Any, tangents: Any) -> Any:
    return jax.jvp(partial(_solved, solver), primals, tangents)


def solve_outside(
    operator: Any,
    b: jax.Array,
    solver: Solver,
    precondition: Callable[[jax.Array], jax.Array],
    smallest: Any = 0.0,
    allowed: Any = 0.0,
) -> tuple[jax.Array, SolveReport]:
    """Like `solve`, with a loop in Python. It cannot be jitted or differentiated.

    So ``precondition``, r -> M r, may be a function on the host, unlike those of `PRECONDITIONERS`. M is to be almost
    A's inverse: the bound of the error takes it for that.
    """
    scale = _scale(norm(b))
    A, right = partial(_product, operator), b / scale
    solving = ConjugateGradients(
        A, precondition, smallest / scale, solver.max_steps, solver.tolerance, jit=False, unroll=True
    )
    x, state = solving.run(jnp.zeros_like(right), right)
    return _reported(operator, right, scale, x, state, solver, allowed, precondition)


@jax.jit
def _product(operator: Any, x: jax.Array) -> jax.Array:
    return operator(x)


def _scale(size: jax.Array) -> jax.Array:
    """b over it has norm 1, or nearly if something is left, so no square overflows float32."""
    return jnp.where((size > 0) & jnp.isfinite(size), size, 1.0)


def _run(
    operator: Any, b: jax.Array, size: jax.Array, solver: Solver, lengths: Sequence[Any], is_short: bool
) -> tuple[jax.Array, SolveReport]:
    """Solve, in float32 if it ``is_short``; residuals are relative to ``size``. ``lengths``: smallest and allowed."""

    def short(values: Any) -> jax.Array:
        is_real = jnp.issubdtype(jnp.result_type(values), jnp.floating)
        return jnp.asarray(values, jnp.float32 if is_real and is_short else None)

    scale = _scale(size)
    A, right, smallest = jax.tree_util.tree_map(short, (operator, b / scale, lengths[0] / scale))
    M = PRECONDITIONERS[solver.preconditioner](A)
    solving = ConjugateGradients(A, M, smallest, solver.max_steps, solver.tolerance)
    x, state = solving.run(jnp.zeros_like(right), right)
    below = operator.least()[0]
    below = jnp.maximum(below, jnp.finfo(below.dtype).tiny)[:, None]
    return _reported(operator, b / scale, scale, x.astype(b.dtype), state, solver, lengths[1], lambda r: r / below)


def _reported(
    operator: Any,
    b: jax.Array,
    scale: jax.Array,
    x: jax.Array,
    state: CGState,
    solver: Solver,
    allowed: Any,
    above: Callable[[jax.Array], jax.Array],
) -> tuple[jax.Array, SolveReport]:
    """The solution for ``scale`` times b, where b is of about norm 1 and CG ended at x, and what is said about it.

    It is said of r = b - A x, computed in the type of b: rounding leaves more than CG's own, recursive residual says.
    A residual at its tolerance may become twice that, or cost half of the type's digits. ``above`` is r -> W r for a
    symmetric W that is not below A's inverse. So the error's square in A's norm, r A^-1 r, is at most r W r. Over the
    least d of `Operator.least` that bounds its square in the plain norm, whatever the error is like.

    The estimate is CG's: the square in A's norm is at most r M r for the recursive r, times the share of r in the
    direction, over the least eigenvalue of M A (Meurant, Tichy 2019: a simpler bound than that of Gauss and Radau). It
    takes the smallest Ritz value for that, which is right once CG has met the slowest part of the error, and what
    `Operator.least` expects for A. So it may be far too small, for example where the shift of A is uneven.
    """
    left = b - _product(operator, x)
    residual = jnp.sqrt(dot(left, left))
    below, expected = operator.least()
    bound = jnp.sqrt(dot(left, above(left)) / jnp.maximum(below.min(), jnp.finfo(below.dtype).tiny))
    of_A = expected.astype(state.gamma.dtype)
    found = jnp.where(state.ritz.most > 0, 1 / state.ritz.most, 0.0)
    error = jnp.where(state.gamma == 0, 0.0, jnp.sqrt(state.gamma * state.share / (found * of_A))).astype(b.dtype)
    recursive = jnp.sqrt(dot(state.residual, state.residual))
    is_near = (residual <= 2 * solver.tolerance) | (residual <= float(jnp.finfo(b.dtype).eps) ** 0.5)
    has_ended = (state.error <= solver.tolerance) & ((recursive > solver.tolerance) | is_near)
    is_solved = ~jnp.isnan(state.error) & jnp.where(
        allowed > 0, scale * bound <= allowed, (recursive <= solver.tolerance) & is_near
    )
    error, bound = scale * jnp.minimum(error, bound), scale * bound
    return scale * x, SolveReport(state.iter_num, residual, is_solved, has_ended, left, error, bound)
