"""Laplacians on padded one-ring slots: mean value (article Eq. 4), cotangent in two forms, and uniform.

Entries i -> j and j -> i are computed from the same four points, so that the product with the transpose is a gather,
too. Lengths are fractions of the diagonal.
"""

from typing import NamedTuple

import jax
import jax.numpy as jnp

from msf_jax.base.layout import Layout
from msf_jax.device.buffers import Rings, at_rows, slot_sum

# Bounds that keep weights and gradients finite on degenerate triangles; the flow keeps no triangle near them.
SHORTEST = 1e-7  # diagonals: least length of an edge
STEEPEST = 1e4  # largest tan(alpha / 2) and cot(alpha): angles within a hundredth of a degree of pi and 0
# Height over longest edge: flatter triangles have their cotangents reduced, see `_signed_cotangents`. With 0.001
# vertices at the tips of limbs diverge along the limbs; with 0.1 they sometimes do.
LEAST_HEIGHT = 0.3
# Largest entry in the flow, without unit; a regular mesh has 1.2. Larger ones, of vertices that nearly coincide or of a
# flat triangle, only keep two vertices together, too, and the condition number grows with the square of the largest.
LARGEST_ENTRY = 20.0


class LaplacianRows(NamedTuple):
    """L in slots: (L x)_i = sum over slots of out (x_j - x_i); ``into`` is the weight L[j, i] of the same edge."""

    out: jax.Array  # (S,)
    into: jax.Array  # (S,)


def assemble(kind: str, positions: jax.Array, rings: Rings, degree: jax.Array, layout: Layout) -> LaplacianRows:
    """Weights of the Laplacian named ``kind``, dimensionless, for positions (n, 3), rings (S,) each, degree (n,).

    Differentiable in: positions (finite everywhere, degenerate triangles included).
    """
    rows = WEIGHTS[kind](positions, rings, degree, layout)
    return LaplacianRows(*(jnp.where(rings.is_used, weight, 0.0) for weight in rows))


def _mean_value(positions: jax.Array, rings: Rings, degree: jax.Array, layout: Layout) -> LaplacianRows:
    """(tan(alpha / 2) + tan(beta / 2)) / length, for the angles at i beside the edge (article Eq. 4).

    Rows are multiplied by the mean length of their one-ring edges, so that they have no unit.
    """
    # Weights at i and at j use their own differences, so that L and its transpose agree on needles despite rounding.
    ends = jnp.stack([at_rows(layout, positions), positions[rings.neighbour]])
    edge = ends[::-1] - ends
    length = norm(edge[0], SHORTEST)
    mean_length = slot_sum(layout, jnp.where(rings.is_used, length, 0.0)) / jnp.maximum(degree, 1)
    sides = jnp.stack([positions[rings.after], positions[rings.before]])[None] - ends[:, None]
    tangents = _half_angle_tangent(edge[:, None], sides).sum(1)
    means = jnp.stack([at_rows(layout, mean_length), mean_length[rings.neighbour]])
    return LaplacianRows(*(tangents / length[None] * means))


def _cotangents(positions: jax.Array, rings: Rings, degree: jax.Array, layout: Layout) -> LaplacianRows:
    """(cot(alpha) + cot(beta)) / 2 for the angles opposite the edge, or 0 if that is negative."""
    at_i = at_rows(layout, positions)
    edge, after, before = (positions[corner] - at_i for corner in (rings.neighbour, rings.after, rings.before))
    weight = 0.5 * (_cotangent(after, after - edge) + _cotangent(before, before - edge))
    weight = jnp.maximum(weight, 0.0)
    return LaplacianRows(weight, weight)


def _signed_cotangents(positions: jax.Array, rings: Rings, degree: jax.Array, layout: Layout) -> LaplacianRows:
    """(cot(alpha) + cot(beta)) / 2, which may be negative: L x is the gradient of the area. A flat triangle then does
    not pull its outer corners together, which would shorten a thin limb (see `_flattened`)."""
    at_i, at_j = at_rows(layout, positions), positions[rings.neighbour]
    square = squared(at_j - at_i)
    after, before = positions[rings.after], positions[rings.before]
    weight = 0.5 * (_flattened(after - at_i, after - at_j, square) + _flattened(before - at_i, before - at_j, square))
    return LaplacianRows(weight, weight)


def _uniform(positions: jax.Array, rings: Rings, degree: jax.Array, layout: Layout) -> LaplacianRows:
    """1 for every edge."""
    weight = jnp.ones(rings.is_used.shape, positions.dtype)
    return LaplacianRows(weight, weight)


# By the names of `base.options.LAPLACIANS`. `assemble` overwrites the values of unused slots.
WEIGHTS = {
    "mean_value": _mean_value,
    "cotangent": _cotangents,
    "signed_cotangent": _signed_cotangents,
    "uniform": _uniform,
}
BOUNDED = ("signed_cotangent",)  # kinds that are bounded without that limit, which would break their symmetry


def norm(vectors: jax.Array, least: float = 0.0) -> jax.Array:
    """Norm over the last axis; ``least``, with gradient 0, where it is not larger, or its square is close to denormal,
    as below 1e-15 in float32. NaN passes through."""
    square = squared(vectors)
    is_short = square <= max(least**2, 1e8 * float(jnp.finfo(square.dtype).tiny))
    return jnp.where(is_short, least, jnp.sqrt(jnp.where(is_short, 1.0, square)))


def _sine_and_cosine(a: jax.Array, b: jax.Array) -> tuple[jax.Array, jax.Array]:
    """|a x b| and a . b of the directions of a and b: of order one, so that no gradient overflows float32."""
    a, b = a / norm(a, SHORTEST)[..., None], b / norm(b, SHORTEST)[..., None]
    return norm(jnp.cross(a, b)), (a * b).sum(-1)


def _half_angle_tangent(a: jax.Array, b: jax.Array) -> jax.Array:
    """tan(alpha / 2) for the angle alpha between a and b, clamped to STEEPEST, with gradient 0 where it is clamped.

    It is sin / (1 + cos), or (1 - cos) / sin for an obtuse angle, where 1 + cos cancels; but for an edge shorter than
    SHORTEST, where sin^2 + cos^2 is not 1, always the first: no jump at 90 degrees.
    """
    sine, cosine = _sine_and_cosine(a, b)
    is_obtuse = (cosine < 0) & (sine * sine + cosine * cosine > 0.99999)  # 1, but for rounding in float32
    numerator = jnp.where(is_obtuse, 1 - cosine, sine)
    denominator = jnp.where(is_obtuse, sine, 1 + cosine)
    is_tame = numerator < STEEPEST * denominator
    return jnp.where(is_tame, numerator / jnp.where(is_tame, denominator, 1.0), STEEPEST)


def _cotangent(a: jax.Array, b: jax.Array) -> jax.Array:
    """cot(alpha) for the angle alpha between a and b, clamped to -STEEPEST and STEEPEST, likewise."""
    sine, cosine = _sine_and_cosine(a, b)
    is_tame = jnp.abs(cosine) < STEEPEST * sine
    return jnp.where(is_tame, cosine / jnp.where(is_tame, sine, 1.0), STEEPEST * jnp.sign(cosine))


def _flattened(a: jax.Array, b: jax.Array, square: jax.Array) -> jax.Array:
    """a . b / |a x b| for two edges of a triangle whose third has the length squared ``square``. The divisor is at
    least LEAST_HEIGHT times the square of the longest edge: one factor reduces all three cotangents of a flat triangle,
    and its energy, an area, is never negative."""
    longest2 = jnp.maximum(jnp.maximum(squared(a), squared(b)), square)
    is_point = longest2 < SHORTEST**4
    unit = jnp.sqrt(jnp.where(is_point, 1.0, longest2))[..., None]
    a, b = a / unit, b / unit
    return jnp.where(is_point, 0.0, (a * b).sum(-1) / jnp.maximum(norm(jnp.cross(a, b)), LEAST_HEIGHT))


def squared(vector: jax.Array) -> jax.Array:
    return (vector * vector).sum(-1)


def one_ring_areas(positions: jax.Array, rings: Rings, degree: jax.Array, layout: Layout) -> jax.Array:
    """Area (n,) of the triangles around each vertex, at least SHORTEST squared; 1 for a padded row."""
    at_i = at_rows(layout, positions)
    area = 0.5 * norm(jnp.cross(positions[rings.neighbour] - at_i, positions[rings.after] - at_i))
    total = slot_sum(layout, jnp.where(rings.is_used, area, 0.0))
    return jnp.where(degree > 0, jnp.maximum(total, SHORTEST**2), 1.0)
