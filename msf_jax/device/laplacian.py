"""Laplacians on padded one-ring slots: mean value (article Eq. 4), cotangent and uniform.

``ring`` (K, n) holds, for slot k of vertex i, its k-th neighbour counter-clockwise; a padded slot points at i itself.
Slot k of vertex i needs only the positions of i, of the neighbour j, and of the two apexes, which are the neighbours in
the slots before and after. The weight that j gives to i is computed from the same four points, so that the product
with the transpose is a gather too. Every length is a fraction of the diagonal.
"""

from typing import NamedTuple

import jax
import jax.numpy as jnp

LAPLACIANS = ("mean_value", "cotangent", "uniform")

# Floors that keep weights and gradients finite on degenerate triangles; both are far below anything the flow keeps.
SHORTEST = 1e-7  # an edge length, as a fraction of the diagonal
STEEPEST = 1e6  # tan(alpha / 2) and cot(alpha): angles within 1e-4 degrees of pi and 0

# Largest entry that the flow takes, see `limit`; a regular mesh has 1.2.
LARGEST = 20.0


class Rows(NamedTuple):
    """L in slots: (L x)_i = sum_k out[k, i] (x[ring[k, i]] - x_i), and into[k, i] is the weight L[j, i] for that j."""

    out: jax.Array  # (K, n)
    into: jax.Array  # (K, n)


def is_slot(ring: jax.Array, degree: jax.Array) -> jax.Array:
    """(K, n) True for the slots that hold a neighbour."""
    return jnp.arange(ring.shape[0])[:, None] < degree[None, :]


def assemble(kind: str, positions: jax.Array, ring: jax.Array, degree: jax.Array) -> Rows:
    """Weights of the Laplacian named ``kind``, dimensionless, for positions (n, 3), ring (K, n), degree (n,).

    Mean-value rows are multiplied by the mean length of their one-ring edges, which takes their unit away; cotangent
    and uniform weights have none. Differentiable in: positions (finite everywhere, degenerate triangles included).
    """
    used = is_slot(ring, degree)
    edge = positions[ring] - positions[None]  # e_k = v_j - v_i, (K, n, 3)
    last = jnp.maximum(degree - 1, 0)
    at_last = jnp.take_along_axis(edge, last[None, :, None], axis=0)
    k = jnp.arange(ring.shape[0])[:, None]
    after = jnp.where((k == last)[..., None], edge[:1], jnp.roll(edge, -1, axis=0))
    before = jnp.concatenate([at_last, edge[:-1]], axis=0)
    if kind == "uniform":
        weight = used.astype(positions.dtype)
        return Rows(weight, weight)
    if kind == "cotangent":
        weight = 0.5 * (_cotangent(after, after - edge) + _cotangent(before, before - edge))
        weight = jnp.where(used, jnp.maximum(weight, 0.0), 0.0)
        return Rows(weight, weight)
    length = _length(edge)
    tangent = _half_angle_tangent(edge, after)  # of the angle at i between slots k and k + 1
    tangent_before = jnp.concatenate([jnp.take_along_axis(tangent, last[None], axis=0), tangent[:-1]], axis=0)
    mean_length = jnp.where(used, length, 0.0).sum(0) / jnp.maximum(degree, 1)
    out = (tangent + tangent_before) / length * mean_length
    at_j = _half_angle_tangent(-edge, after - edge) + _half_angle_tangent(-edge, before - edge)
    into = at_j / length * mean_length[ring]
    return Rows(jnp.where(used, out, 0.0), jnp.where(used, into, 0.0))


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


def _ratio(numerator: jax.Array, denominator: jax.Array) -> jax.Array:
    """numerator / denominator for a numerator >= 0, clamped to [-STEEPEST, STEEPEST] with a zero gradient there."""
    is_tame = numerator < STEEPEST * jnp.abs(denominator)
    clamped = jnp.where(denominator < 0, -STEEPEST, STEEPEST)
    return jnp.where(is_tame, numerator / jnp.where(is_tame, denominator, 1.0), jnp.where(numerator > 0, clamped, 0.0))


def _half_angle_tangent(a: jax.Array, b: jax.Array) -> jax.Array:
    """tan(alpha / 2) = |a x b| / (|a| |b| + a . b) for the angle alpha between a and b."""
    return _ratio(_cross_length(a, b), _length(a) * _length(b) + (a * b).sum(-1))


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


def one_ring_areas(positions: jax.Array, ring: jax.Array, degree: jax.Array) -> jax.Array:
    """Area (n,) of the triangles around each vertex, at least SHORTEST squared; 1 for a padded row."""
    edge = positions[ring] - positions[None]
    k = jnp.arange(ring.shape[0])[:, None]
    after = jnp.where((k == degree - 1)[..., None], edge[:1], jnp.roll(edge, -1, axis=0))
    area = jnp.where(is_slot(ring, degree), 0.5 * _cross_length(edge, after), 0.0).sum(0)
    return jnp.where(degree > 0, jnp.maximum(area, SHORTEST**2), 1.0)
