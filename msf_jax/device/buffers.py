"""Padded buffers, what a jitted step sees of the surface, and the sums over one-rings that read them.

Rows and slots are laid out by `layout.Layout`. A padded row has no neighbours and is not free; an unused slot points at
its own row. Neither adds to any sum, so values and gradients do not depend on the padding.
"""

from functools import partial
from typing import NamedTuple

import jax
import jax.numpy as jnp

from msf_jax.base.layout import Layout, Level

UNROLLED_SLOTS = 8  # up to here a level is one gather a slot, added up in a Python loop; beyond, one gather in all


class Rings(NamedTuple):
    """The one-rings, flat: entry s is slot k of row i, the directed edge i -> j with its two apexes.

    An unused slot names its own row three times.
    """

    neighbour: jax.Array  # (S,) int32: j
    after: jax.Array  # (S,) int32: the neighbour after j, counter-clockwise around i
    before: jax.Array  # (S,) int32: the one before
    is_used: jax.Array  # (S,) bool


class Buffers(NamedTuple):
    """A padded surface; everything the host tells a step."""

    positions: jax.Array  # (n, 3), fractions of the diagonal
    rings: Rings
    degree: jax.Array  # (n,)
    free: jax.Array  # (n,) 1.0 where the vertex may move
    poles: jax.Array  # (n, 3)
    pull: jax.Array  # (n,) 1.0 where the pole pulls, less where it is trusted less
    t_c: jax.Array  # (), the collapse threshold: what moves by a small part of it has arrived
    area: jax.Array  # (n,) one-ring areas at the start of the flow, for the system whose w_H follows them


# For what a step uses many times over: tracing it once for each layout makes a start with a full cache shorter.
traced_once = partial(jax.jit, static_argnames="layout", inline=True)


def real_dtype() -> jnp.dtype:
    """float64 when JAX has it on, float32 otherwise."""
    return jax.dtypes.canonicalize_dtype(float)


@traced_once
def at_rows(layout: Layout, values: jax.Array) -> jax.Array:
    """``values`` (n, ...) of the row that each slot belongs to, (S, ...), without a gather."""
    return jnp.concatenate([values[: level.rows] for level in layout.levels for _ in range(level.slots)])


def _raised(rows: int, lower: jax.Array) -> jax.Array:
    """``lower`` with zero rows appended up to ``rows``."""
    return jnp.pad(lower, [(0, rows - lower.shape[0])] + [(0, 0)] * (lower.ndim - 1))


@traced_once
def slot_sum(layout: Layout, values: jax.Array) -> jax.Array:
    """Sum (n,) of ``values`` (S,) over the slots of each row."""
    total = jnp.zeros(layout.levels[-1].rows, values.dtype)
    for level in reversed(layout.levels):
        block = values[level.offset : level.end].reshape(level.slots, level.rows)
        total = block.sum(0) + _raised(level.rows, total)
    return total


@traced_once
def slot_product(layout: Layout, weights: jax.Array, neighbour: jax.Array, x: jax.Array) -> jax.Array:
    """y_i = sum over the slots of row i of weight times x[neighbour], for weights (S,) and x (n, c).

    From the tail up: each level adds to the prefix of rows below it.
    """
    total = jnp.zeros((layout.levels[-1].rows, x.shape[1]), x.dtype)
    for level in reversed(layout.levels):
        total = _level_product(level, weights, neighbour, x) + _raised(level.rows, total)
    return total


def _level_product(level: Level, weights: jax.Array, neighbour: jax.Array, x: jax.Array) -> jax.Array:
    w = weights[level.offset : level.end].reshape(level.slots, level.rows)
    j = neighbour[level.offset : level.end].reshape(level.slots, level.rows)
    if level.slots > UNROLLED_SLOTS:
        return jnp.einsum("kr,krc->rc", w, x[j])
    part = w[0][:, None] * x[j[0]]
    for k in range(1, level.slots):
        part = part + w[k][:, None] * x[j[k]]
    return part
