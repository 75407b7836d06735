"""The finished curve as a function of the mesh's vertices: the equation of `msf_jax.base.binding` in JAX.

A section's corners are p_k = (1 - t_k) V_tail + t_k V_head. Its area vector is N = sum_k p_k x p_{k+1} / 2. Its
centroid is that of the area projected along N. So a corner that moves along the limb moves the centroid along the limb,
and not across, to first order.
"""

from typing import NamedTuple

import jax
import jax.numpy as jnp

from msf_jax.base.binding import Binding
from msf_jax.device.nearest import signed_distances

# Ratio of a section's area to its recorded area (scaled by the growth of all sections), and to the mean squared
# distance of its corners from their mean: below it, the section has vanished.
VANISHED = 1e-3


class MovedCurve(NamedTuple):
    """nodes (N, 3) and radii (N,), in the mesh's units."""

    nodes: jax.Array
    radii: jax.Array


class MovedSections(NamedTuple):
    """The moved cross-sections.

    centroid: (S, 3). area: (S,). normal: (S, 3) unit. warp: (S,) the RMS distance of the corners from their plane, over
    that from their mean.
    """

    centroid: jax.Array
    area: jax.Array
    normal: jax.Array
    warp: jax.Array


def corners(binding: Binding, vertices: jax.Array) -> jax.Array:
    """(C, 3) corners of the sections for ``vertices`` (V, 3), both in the binding's unit and relative to its centre."""
    tail, head = vertices[binding.tail], vertices[binding.head]
    return tail + jnp.asarray(binding.part, vertices.dtype)[:, None] * (head - tail)


def centroids(binding: Binding, place: jax.Array) -> MovedSections:
    """The sections whose corners are at ``place`` (C, 3)."""
    num, dtype = len(binding.node), place.dtype
    share = jnp.asarray(binding.share, dtype)[:, None]

    def total(value: jax.Array) -> jax.Array:
        return jax.ops.segment_sum(value, binding.section, num, indices_are_sorted=True)

    mean = total(share * place)
    p = place - mean[binding.section]
    onward = p[binding.onward]
    cross = jnp.cross(p, onward)
    vector = total(cross)
    twice2 = (vector * vector).sum(1)
    is_some = twice2 > 0
    twice = jnp.where(is_some, jnp.sqrt(jnp.where(is_some, twice2, 1.0)), 0.0)
    normal = vector / jnp.where(is_some, twice, 1.0)[:, None]
    part = (cross * normal[binding.section]).sum(1)
    spread2 = total(share[:, 0] * (p * p).sum(1))
    recorded, is_loop = jnp.asarray(binding.area, dtype), jnp.asarray(binding.is_loop)
    # A segment sum adds in order, so that the result does not depend on the amount of padding.
    areas = jnp.stack([jnp.where(is_loop, twice / 2, 0.0), recorded], axis=1)
    now, before = jax.ops.segment_sum(areas, jnp.zeros(num, jnp.int32), 1, indices_are_sorted=True)[0]
    grown = now / jnp.maximum(before, jnp.finfo(dtype).tiny)
    is_there = is_loop & (twice / 2 > VANISHED * jnp.maximum(grown * recorded, spread2))
    off = total(part[:, None] * (p + onward)) / (3 * jnp.where(is_there, twice, 1.0))[:, None]
    height2 = total(share[:, 0] * (p * normal[binding.section]).sum(1) ** 2)
    warp = jnp.sqrt(height2 / jnp.where(spread2 > 0, spread2, 1.0))
    area = jnp.where(is_there | ~is_loop, twice / 2, 0.0)
    return MovedSections(mean + jnp.where(is_there[:, None], off, 0.0), area, normal, jax.lax.stop_gradient(warp))


def follow(binding: Binding, vertices: jax.Array) -> MovedCurve:
    """The curve for ``vertices`` (V, 3), in the caller's units; NaN at a node whose section has vanished, 0 in
    padding."""
    dtype = vertices.dtype
    unit = jnp.asarray(binding.unit, dtype)
    entered = (vertices - jnp.asarray(binding.centre, dtype)) / unit
    found = centroids(binding, corners(binding, entered))
    num = len(binding.rest)

    def product(row: jax.Array, column: jax.Array, value: jax.Array, of: jax.Array) -> jax.Array:
        entries = jnp.asarray(value, dtype)[:, None] * of[column]
        return jax.ops.segment_sum(entries, row, num, indices_are_sorted=True)

    nodes = product(binding.a_row, binding.a_column, binding.a_value, found.centroid)
    turned = product(binding.b_row, binding.b_column, binding.b_value, entered)
    nodes = nodes + turned + jnp.asarray(binding.rest, dtype)
    is_vanished = (jnp.asarray(binding.is_loop) & (found.area == 0)).astype(jnp.int32)
    is_gone = jax.ops.segment_max(is_vanished, binding.node, num) > 0
    nodes = jnp.where(is_gone[:, None], jnp.nan, nodes)
    radii = signed_distances(binding, nodes, entered)
    is_node = binding.node_mask
    placed = jnp.where(is_node[:, None], jnp.asarray(binding.centre, dtype) + unit * nodes, 0.0)
    return MovedCurve(placed, jnp.where(is_node, unit * radii, 0.0))
