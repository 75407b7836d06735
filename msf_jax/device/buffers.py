"""Fixed-capacity padded buffers: what a jitted step sees of the surface.

A capacity is compiled once, so there are few: 256 times 1, 1.5, 2, 3, 4, ... for vertices, `ring_capacity` for
neighbours. A padded row has no neighbours, is not free, and its slots point at itself, as unused slots of live rows
do. Neither adds to any sum, so values and gradients do not depend on the padding.
"""

from typing import NamedTuple

import jax
import jax.numpy as jnp

SMALLEST = 256


class Buffers(NamedTuple):
    """A padded surface of capacity n with K slots a ring; everything the host tells a step."""

    positions: jax.Array  # (n, 3), fractions of the diagonal
    ring: jax.Array  # (K, n) int32, neighbours counter-clockwise
    degree: jax.Array  # (n,) int32
    free: jax.Array  # (n,) 1.0 where the vertex may move
    poles: jax.Array  # (n, 3)
    pull: jax.Array  # (n,) 1.0 where the pole pulls
    area: jax.Array  # (n,) one-ring areas at the start of the flow, for the system whose w_H follows them


def capacity(count: int) -> int:
    """The smallest capacity for ``count`` vertices: 256 times 1, 1.5, 2, 3, 4, 6, 8, ..."""
    size = SMALLEST
    while size < count:
        if size * 3 // 2 >= count:
            return size * 3 // 2
        size *= 2
    return size


def next_capacity(current: int, count: int) -> int:
    """Where a buffer of capacity ``current`` goes for ``count`` vertices: up when outgrown, down when half empty."""
    return capacity(count) if count > current or 2 * count <= current else current


def real_dtype() -> jnp.dtype:
    """float64 when JAX has it on, float32 otherwise."""
    return jnp.zeros(()).dtype
