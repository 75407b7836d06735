"""Padded buffers, the input of a jitted step, and sums over one-rings, in the rows and slots of a `layout.Layout`.

A padded row has no neighbours and is not free; an unused slot refers to its own row. Neither adds to any sum.
"""

from typing import NamedTuple

import jax
import jax.numpy as jnp
from jax import lax

from msf_jax.base.layout import Layout, Level


class Rings(NamedTuple):
    """The one-rings as flat arrays: entry s is slot k of row i, the directed edge i -> j with its two apexes."""

    neighbour: jax.Array  # (S,) int32: j
    after: jax.Array  # (S,) int32: the neighbour after j, counter-clockwise around i
    before: jax.Array  # (S,) int32: the neighbour before j
    is_used: jax.Array  # (S,) bool


class Buffers(NamedTuple):
    """A padded surface, with all data that a step gets from the host."""

    positions: jax.Array  # (n, 3), fractions of the diagonal
    rings: Rings
    degree: jax.Array  # (n,)
    free: jax.Array  # (n,) 1.0 where the vertex may move
    poles: jax.Array  # (n, 3)
    pull: jax.Array  # (n,) 1.0 where the pole pulls, 0.0 where it does not, between if it is trusted less
    t_c: jax.Array  # (), the collapse threshold, in diagonals: solves end when vertices move by a small part of it
    area: jax.Array  # (n,) one-ring areas at the start of the flow, for systems whose w_H follows them


def real_dtype() -> jnp.dtype:
    """float64 if JAX has it enabled, else float32."""
    return jax.dtypes.canonicalize_dtype(float)


def at_rows(layout: Layout, values: jax.Array) -> jax.Array:
    """``values`` (n, ...) of the row that each slot belongs to, (S, ...), without a gather."""
    return jnp.concatenate([values[: level.rows] for level in layout.levels for _ in range(level.slots)])


def slot_sum(layout: Layout, values: jax.Array) -> jax.Array:
    """Sum (n,) of ``values`` (S,) over the slots of each row."""
    total = jnp.zeros(layout.levels[-1].rows, values.dtype)
    for level in reversed(layout.levels):
        block = values[level.offset : level.end].reshape(level.slots, level.rows)
        total = block.sum(0) + jnp.pad(total, (0, level.rows - len(total)))
    return total


def slot_product(layout: Layout, weights: jax.Array, neighbour: jax.Array, x: jax.Array) -> jax.Array:
    """y_i = sum over the slots of row i of weight times x[neighbour], for weights (S,) and x (n, c). From the last
    level on, each is added to a prefix of the rows of the level before it."""
    total = _level_product(layout.levels[-1], weights, neighbour, x)
    for level in layout.levels[-2::-1]:
        lower, total = total, _level_product(level, weights, neighbour, x)
        rows = lower.shape[0]
        total = lax.dynamic_update_slice(total, total[:rows] + lower, (0, 0))  # in place, unlike a sum of padded arrays
    return total


def _level_product(level: Level, weights: jax.Array, neighbour: jax.Array, x: jax.Array) -> jax.Array:
    w = weights[level.offset : level.end].reshape(level.slots, level.rows)
    j = neighbour[level.offset : level.end].reshape(level.slots, level.rows)
    return (w[:, :, None] * x[j]).sum(0)
