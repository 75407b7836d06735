"""The finished curve as a function of the mesh's vertices: the equation of `msf_jax.base.binding` in JAX.

A section's corners are p_k = (1 - t_k) V_tail + t_k V_head, its area vector is N = sum_k p_k x p_{k+1} / 2, and its
centroid that of the area projected along N: a corner that moves along the limb moves it along the limb, to first order.
"""

from functools import partial
from typing import NamedTuple

import jax
import jax.numpy as jnp
from jax import lax

from msf_jax.base.binding import Binding
from msf_jax.device.laplacian import norm
from msf_jax.device.nearest import signed_distances

sorted_sum = partial(jax.ops.segment_sum, indices_are_sorted=True)

VANISHED = 1e-3  # of a section's area to the mean square of its corners' distances from their mean: below, it is none


class Followed(NamedTuple):
    """nodes: (N, 3), in the mesh's units. radii: (N,) signed distance to the surface without the lids of openings,
    negative for a node outside."""

    nodes: jax.Array
    radii: jax.Array

    def __repr__(self) -> str:
        parts = (f"{name} {part.dtype}{list(part.shape)}" for name, part in self._asdict().items())
        return f"Followed({', '.join(parts)})"


def corners(binding: Binding, vertices: jax.Array) -> jax.Array:
    """(C, 3) corners of the sections for ``vertices`` (V, 3), both in the binding's unit and relative to its centre."""
    tail, head = vertices[binding.tail], vertices[binding.head]
    return tail + jnp.asarray(binding.part, vertices.dtype)[:, None] * (head - tail)


def area_vectors(binding: Binding, place: jax.Array) -> tuple[jax.Array, jax.Array, jax.Array]:
    """The means (S, 3) of the corners at ``place`` (C, 3) of each section, twice its area vector N (S, 3), and the
    parts (C, 3) of that."""
    num, share = len(binding.node), jnp.asarray(binding.share, place.dtype)[:, None]
    mean = sorted_sum(share * place, binding.section, num)
    p = place - mean[binding.section]
    cross = jnp.cross(p, p[binding.onward])
    return mean, sorted_sum(cross, binding.section, num), cross


def centroids(binding: Binding, place: jax.Array) -> tuple[jax.Array, jax.Array]:
    """The centroids (S, 3) of the sections whose corners are at ``place`` (C, 3), and whether each vanished (S,)."""
    num, dtype = len(binding.node), place.dtype
    mean, vector, cross = area_vectors(binding, place)
    p = place - mean[binding.section]
    onward = p[binding.onward]
    twice = norm(vector)
    normal = vector / jnp.where(twice > 0, twice, 1.0)[:, None]
    part = (cross * normal[binding.section]).sum(1)
    spread2 = sorted_sum(jnp.asarray(binding.share, dtype) * (p * p).sum(1), binding.section, num)
    is_loop = jnp.asarray(binding.is_loop)
    is_there = is_loop & (twice / 2 > VANISHED * spread2)
    off = sorted_sum(part[:, None] * (p + onward), binding.section, num)
    off = off / (3 * jnp.where(is_there, twice, 1.0))[:, None]
    return mean + jnp.where(is_there[:, None], off, 0.0), is_loop & ~is_there


def follow(binding: Binding, vertices: jax.Array) -> Followed:
    """The curve for ``vertices`` (V, 3), in the caller's units; NaN at a node whose section has vanished, 0 in
    padding."""
    dtype = vertices.dtype
    binding = jax.tree.map(lax.stop_gradient, binding)
    unit, centre = jnp.asarray(binding.unit, dtype)[..., None], jnp.asarray(binding.centre, dtype)
    entered = (vertices - binding.spread(centre, "vertices")) / binding.spread(unit, "vertices")
    centroid, is_vanished = centroids(binding, corners(binding, entered))
    num = len(binding.rest)

    def product(row: jax.Array, column: jax.Array, value: jax.Array, of: jax.Array) -> jax.Array:
        return sorted_sum(jnp.asarray(value, dtype)[:, None] * of[column], row, num)

    nodes = product(binding.a_row, binding.a_column, binding.a_value, centroid)
    turned = product(binding.b_row, binding.b_column, binding.b_value, entered)
    nodes = nodes + turned + jnp.asarray(binding.rest, dtype)
    is_gone = jax.ops.segment_max(is_vanished.astype(jnp.int32), binding.node, num) > 0
    unit, centre = binding.spread(unit, "nodes"), binding.spread(centre, "nodes")
    radii = unit[..., 0] * signed_distances(binding, nodes, entered)
    is_node = binding.node_mask
    placed = jnp.where(is_node[:, None], jnp.where(is_gone[:, None], jnp.nan, centre + unit * nodes), 0.0)
    return Followed(placed, jnp.where(is_node, jnp.where(is_gone, jnp.nan, radii), 0.0))
