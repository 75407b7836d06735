"""Laplacians on padded one-ring slots: mean value (article Eq. 4), cotangent and uniform.

Every entry needs only the positions of its edge i -> j and of the two apexes. The weight that j gives to i is computed
from the same four points, so that the product with the transpose is a gather too. Lengths are fractions of the
diagonal.
"""

from typing import NamedTuple

import jax
import jax.numpy as jnp

from msf_jax.device.buffers import Rings, at_rows, slot_sum
from msf_jax.layout import Layout

# Floors that keep weights and gradients finite on degenerate triangles; both are far below anything the flow keeps.
SHORTEST = 1e-7  # an edge length, as a fraction of the diagonal
STEEPEST = 1e6  # tan(alpha / 2) and cot(alpha): angles within 1e-4 degrees of pi and 0

# Largest entry that the flow takes, see `limit`; a regular mesh has 1.2.
LARGEST = 20.0


class Rows(NamedTuple):
    """L in slots: (L x)_i = sum over slots of out (x_j - x_i); ``into`` is the weight L[j, i] of the same edge."""

    out: jax.Array  # (S,)
    into: jax.Array  # (S,)


def assemble(kind: str, positions: jax.Array, rings: Rings, degree: jax.Array, layout: Layout) -> Rows:
    """Weights of the Laplacian named ``kind``, dimensionless, for positions (n, 3), rings (S,) each, degree (n,).

    Mean-value rows are multiplied by the mean length of their one-ring edges, which takes their unit away; cotangent
    and uniform weights have none. Differentiable in: positions (finite everywhere, degenerate triangles included).
    """
    used = rings.is_used
    if kind == "uniform":
        weight = used.astype(positions.dtype)
        return Rows(weight, weight)
    at_i = at_rows(layout, positions)
    edge = positions[rings.neighbour] - at_i
    after = positions[rings.after] - at_i
    before = positions[rings.before] - at_i
    if kind == "cotangent":
        weight = 0.5 * (_cotangent(after, after - edge) + _cotangent(before, before - edge))
        weight = jnp.where(used, jnp.maximum(weight, 0.0), 0.0)
        return Rows(weight, weight)
    length = _length(edge)
    mean_length = slot_sum(layout, jnp.where(used, length, 0.0)) / jnp.maximum(degree, 1)
    at_i_tangents = _half_angle_tangent(edge, after) + _half_angle_tangent(before, edge)
    at_j_tangents = _half_angle_tangent(-edge, after - edge) + _half_angle_tangent(before - edge, -edge)
    out = at_i_tangents / length * at_rows(layout, mean_length)
    into = at_j_tangents / length * mean_length[rings.neighbour]
    return Rows(jnp.where(used, out, 0.0), jnp.where(used, into, 0.0))


def one_ring_areas(positions: jax.Array, rings: Rings, degree: jax.Array, layout: Layout) -> jax.Array:
    """Area (n,) of the triangles around each vertex, at least SHORTEST squared; 1 for a padded row."""
    at_i = at_rows(layout, positions)
    area = 0.5 * _cross_length(positions[rings.neighbour] - at_i, positions[rings.after] - at_i)
    total = slot_sum(layout, jnp.where(rings.is_used, area, 0.0))
    return jnp.where(degree > 0, jnp.maximum(total, SHORTEST**2), 1.0)


def limit(rows: Rows, largest: float = LARGEST) -> Rows:
    """The same rows with no entry above ``largest``.

    Two vertices that nearly coincide, or a flat triangle, make an entry as large as one likes; all it says is that the
    two vertices belong together, and 20 times the regular weight says it as well. The condition number of the normal
    equations grows with the square of the largest entry: on homer this halves the iterations and the CG steps.
    Differentiable in: rows, with a zero gradient where an entry is limited.
    """
    return Rows(jnp.minimum(rows.out, largest), jnp.minimum(rows.into, largest))


def _length(vector: jax.Array) -> jax.Array:
    """Norm over the last axis, at least SHORTEST, with a zero gradient below it."""
    square = (vector * vector).sum(-1)
    is_long = square > SHORTEST**2
    return jnp.where(is_long, jnp.sqrt(jnp.where(is_long, square, 1.0)), SHORTEST)


def _half_angle_tangent(a: jax.Array, b: jax.Array) -> jax.Array:
    """tan(alpha / 2) for the angle alpha between a and b, from 0 to STEEPEST, with a zero gradient at the clamp.

    |a x b| / (|a| |b| + a . b), or (|a| |b| - a . b) / |a x b| for an obtuse angle, where the first would cancel.
    """
    cross, dot = _cross_length(a, b), (a * b).sum(-1)
    product = _length(a) * _length(b)
    is_obtuse = dot < 0
    numerator = jnp.where(is_obtuse, product - dot, cross)
    denominator = jnp.where(is_obtuse, cross, product + dot)
    is_tame = numerator < STEEPEST * denominator
    return jnp.where(is_tame, numerator / jnp.where(is_tame, denominator, 1.0), STEEPEST)


def _cotangent(a: jax.Array, b: jax.Array) -> jax.Array:
    """cot(alpha) = a . b / |a x b|."""
    dot, cross = (a * b).sum(-1), _cross_length(a, b)
    is_tame = jnp.abs(dot) < STEEPEST * cross
    return jnp.where(is_tame, dot / jnp.where(is_tame, cross, 1.0), STEEPEST * jnp.sign(dot))


def _cross_length(a: jax.Array, b: jax.Array) -> jax.Array:
    """|a x b|, with a zero gradient where it vanishes."""
    square = (jnp.cross(a, b) ** 2).sum(-1)
    is_wide = square > 0
    return jnp.where(is_wide, jnp.sqrt(jnp.where(is_wide, square, 1.0)), 0.0)
