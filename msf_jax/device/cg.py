"""Conjugate gradients for A x = b with a symmetric positive definite operator A, differentiated implicitly.

jaxopt's `solve_cg` reports neither its steps nor its residual, so jaxopt's loop has another body here. The loop is the
solve of a `lax.custom_linear_solve`: derivatives of any order are those of the solution, A dx = db - dA x, by one more
solve each. Under a `jax.checkpoint` with the policy `keeps_solutions`, the backward pass does not repeat the solve.
"""

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from importlib import util
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import jax
import jax.numpy as jnp
from jax import lax

from msf_jax.base.options import SolverOptions, is_traced

if TYPE_CHECKING:
    from jaxopt import loop
else:  # from its file: the package imports all of its solvers, which takes 0.2 s, or 0.35 where numba is installed
    _spec = util.spec_from_file_location("loop", Path(util.find_spec("jaxopt").origin).parent / "_src" / "loop.py")
    loop = util.module_from_spec(_spec)
    _spec.loader.exec_module(loop)

Map = Callable[[jax.Array], jax.Array]  # of vectors (n, c)
LOOSE = 1e-3  # relative residual: tolerances from here on are reached in float32, whose rounding is 6e-8
LONG_REDUCTION = 4096  # entries: XLA on the CPU has a library for longer reductions


class SolveReport(NamedTuple):
    """steps: of CG. left: (n, c) the right-hand side minus A x, over |b|, for the final x. residual: the norm of that.
    has_ended: whether the solve ended by its tolerance or by a short step, see `_has_ended`."""

    steps: jax.Array
    residual: jax.Array
    has_ended: jax.Array
    left: jax.Array


class Descent(NamedTuple):
    """The state of CG: the residual r = b - A x that its recursion has, the direction p of the next step, and
    gamma = r M r. error: |r|, or 0 after a short step, or NaN if A or M is not positive definite."""

    steps: jax.Array
    error: jax.Array
    x: jax.Array
    residual: jax.Array
    direction: jax.Array
    gamma: jax.Array


def _descended(A: Map, M: Map, b: jax.Array, smallest: Any, solver: SolverOptions, in_python: bool = False) -> Descent:
    """CG for A x = b from x = 0, preconditioned by M, a symmetric positive definite operator near A's inverse. It also
    ends after a step that changes every entry by less than ``smallest``. The first step, which passes a NaN in b on, is
    always made, in the loop, whose body then is compiled once."""

    def follow(now: Descent) -> Descent:
        product = A(now.direction)
        curvature = dot(now.direction, product)
        # Make no step if rounding leaves no curvature, for example once the residual is exactly zero.
        is_curved = (curvature > 0) & (now.gamma > 0)
        step = jnp.where(is_curved, now.gamma / jnp.where(is_curved, curvature, 1.0), 0.0)
        residual = now.residual - step * product
        z = M(residual)
        gamma = dot(residual, z)
        beta = gamma / jnp.where(now.gamma > 0, now.gamma, 1.0)
        is_small = (jnp.abs(step * now.direction) < smallest).all()
        error = jnp.sqrt(dot(residual, residual))
        error = jnp.where(is_curved | (error <= solver.tolerance), jnp.where(is_small, 0.0, error), jnp.nan)
        x = now.x + step * now.direction
        return Descent(now.steps + 1, error, x, residual, z + beta * now.direction, gamma)

    def is_on(now: Descent) -> jax.Array:
        return (now.steps == 0) | (now.error > solver.tolerance)

    z = M(b)
    start = Descent(jnp.asarray(0), jnp.sqrt(dot(b, b)), jnp.zeros_like(b), b, z, dot(b, z))
    return loop.while_loop(is_on, follow, start, solver.max_steps, unroll=in_python, jit=not in_python)


def dot(x: jax.Array, y: jax.Array) -> jax.Array:
    """Sum of x y over all entries. Halves of the rows are added until few are left: on the CPU that is faster than a
    long reduction in some versions of XLA, and rounds less."""
    products = x * y
    while products.size >= LONG_REDUCTION and len(products) % 2 == 0:
        products = products[: len(products) // 2] + products[len(products) // 2 :]
    return products.sum()


def norm(x: jax.Array) -> jax.Array:
    """Euclidean norm of all entries, which are first divided by the largest: squares can overflow float32.
    Differentiable in: x; the gradient at 0 is 0."""
    largest = lax.stop_gradient(jnp.abs(x).max())
    scale = _scale(largest)
    unit = x / scale
    square = dot(unit, unit)
    return jnp.where(square == 0, 0.0, scale * jnp.sqrt(jnp.where(square == 0, 1.0, square)))


def solve(
    operator: Any, b: jax.Array, solver: SolverOptions, smallest: Any = 0.0, left: jax.Array | None = None
) -> tuple[jax.Array, SolveReport]:
    """Solve A x = b - |b| left for b (n, c), from x = 0; without ``left``, A x = b.

    A is a symmetric positive definite ``operator``: a pytree that is called with x, and has its ``diagonal()`` (n,).
    CG ends when the norm of the residual is at most the solver's tolerance times |b|, or when a step changes every
    entry of x by less than ``smallest``. If the tolerance is loose, CG runs in float32, where a step takes two thirds
    of the time. The entries of A must then be in float32's range.
    Differentiable in: operator, b; implicitly, to any order, by solves to the same tolerance. A derivative whose solve
    does not end by it is NaN.

    JAX calls the same solve for derivatives. One more row tells them from this one: in its right-hand side it is 1, and
    0 in theirs; in the unknown it is the number of steps, negative if the solve has not ended. (`jax.jacfwd` refuses
    them as auxiliary data.)
    """
    is_short = isinstance(solver.tolerance, float) and solver.tolerance >= LOOSE  # a traced one may be tight
    operator, b, smallest, left = _together((operator, b, smallest, left))
    if is_traced(solver.tolerance):
        solver = replace(solver, tolerance=_together((solver.tolerance, b))[0])
    size = norm(b)
    right = b if left is None else b - size * left
    own_size, own_smallest = lax.stop_gradient((size, smallest))

    def short(values: jax.Array) -> jax.Array:
        return values.astype(jnp.float32) if is_short and jnp.issubdtype(values.dtype, jnp.floating) else values

    def product(unknown: jax.Array) -> jax.Array:
        return jnp.concatenate([operator(unknown[:-1]), unknown[-1:]])

    def solved(_: Any, given: jax.Array) -> jax.Array:
        rhs, is_own = given[:-1], given[-1, 0] == 1
        scale = _scale(jnp.where(is_own, own_size, norm(rhs)))
        least = jnp.where(is_own, own_smallest, 0.0) / scale
        A, unit, least = jax.tree_util.tree_map(short, (operator, rhs / scale, least))
        inverse = 1.0 / A.diagonal()[:, None]  # Jacobi's preconditioner
        end = _descended(A, lambda r: inverse * r, unit, least, solver)
        x = end.x.astype(b.dtype)
        has_ended = _has_ended(end, rhs / scale - operator(x), solver)
        steps = jnp.where(has_ended, end.steps, -end.steps).astype(b.dtype)
        x = jnp.where(is_own | has_ended, scale * x, jnp.nan)
        return jnp.concatenate([x, jnp.broadcast_to(steps, given[-1:].shape)])

    marked = jnp.concatenate([right, jnp.ones_like(right[:1])])
    found = lax.custom_linear_solve(product, marked, solved, symmetric=True)
    fixed, right, operator, size = lax.stop_gradient((found, right, operator, size))
    rest, steps = (right - operator(fixed[:-1])) / _scale(size), fixed[-1, 0].astype(int)
    return found[:-1], SolveReport(abs(steps), jnp.sqrt(dot(rest, rest)), steps > 0, rest)


def keeps_solutions(primitive: Any, *_: Any, **__: Any) -> bool:
    """A policy for `jax.checkpoint` that stores the results of solves, and recomputes the rest."""
    return primitive is lax.linear_solve_p


def _together(values: Any) -> Any:
    """``values``, each declared to differ between the devices of a `jax.shard_map` if one of them does: within the
    solve JAX refuses what a scan has declared outside."""
    arrays = jax.tree.map(jnp.asarray, values)
    every = frozenset().union(*(jax.typeof(array).mat.varying for array in jax.tree.leaves(arrays)))

    def spread(array: jax.Array) -> jax.Array:
        lacking = tuple(every - jax.typeof(array).mat.varying)
        return lax.pcast(array, lacking, to="varying") if lacking else array

    return jax.tree.map(spread, arrays)


def solve_outside(
    operator: Any, b: jax.Array, solver: SolverOptions, precondition: Map, smallest: Any = 0.0
) -> tuple[jax.Array, SolveReport]:
    """Like `solve`, with a loop in Python, so that ``precondition``, r -> M r near A^-1 r, may be a function on the
    host, see `numerics.factors`. It cannot be jitted or differentiated."""
    scale, A = _scale(norm(b)), partial(jax.jit(type(operator).__call__), operator)
    end = _descended(A, precondition, b / scale, smallest / scale, solver, in_python=True)
    left = b / scale - A(end.x)
    return scale * end.x, SolveReport(end.steps, jnp.sqrt(dot(left, left)), _has_ended(end, left, solver), left)


def _scale(size: jax.Array) -> jax.Array:
    """A divisor with which no square overflows float32: ``size``, or 1 if that is 0 or not finite."""
    return jnp.where((size > 0) & jnp.isfinite(size), size, 1.0)


def _has_ended(end: Descent, left: jax.Array, solver: SolverOptions) -> jax.Array:
    """Whether CG ended by a short step or by its tolerance. For rounding, ``left``, b - A x for the final x in the type
    of b, may be twice the tolerance, or cost half of the type's digits."""
    residual, recursive = jnp.sqrt(dot(left, left)), jnp.sqrt(dot(end.residual, end.residual))
    is_near = (residual <= 2 * solver.tolerance) | (residual <= float(jnp.finfo(left.dtype).eps) ** 0.5)
    return (end.error <= solver.tolerance) & ((recursive > solver.tolerance) | is_near)
