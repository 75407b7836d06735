"""A finished curve in the mesh as it has moved: the equation of `msf_jax.base.recipe`, live in the vertices.

A section's corners are p_k = (1 - t_k) V_tail + t_k V_head, its area vector is N = sum_k p_k x p_{k+1} / 2, and its
centroid that of the area in the direction of N, so that a corner that moves along the limb moves the centroid along it,
not across, to first order.
"""

from typing import NamedTuple

import jax
import jax.numpy as jnp

from msf_jax.base.recipe import Recipe
from msf_jax.device.playback import clearance

VANISHED = 1e-3  # of its recorded area, as all sections have grown, and of the square of its corners' spread: a section
# of less is none


class Curve(NamedTuple):
    """nodes (N, 3) and radii (N,), in the mesh's units."""

    nodes: jax.Array
    radii: jax.Array


class Sections(NamedTuple):
    """Sections as they have moved.

    centroid: (S, 3). area: (S,). normal: (S, 3) unit. warp: (S,) how far the corners are off a plane, root mean
    square, over how far they are from the centroid.
    """

    centroid: jax.Array
    area: jax.Array
    normal: jax.Array
    warp: jax.Array


def corners(recipe: Recipe, vertices: jax.Array) -> jax.Array:
    """(C, 3) of the sections, in diagonals around the centre, for ``vertices`` (V, 3) in those units."""
    tail, head = vertices[recipe.tail], vertices[recipe.head]
    return tail + jnp.asarray(recipe.part, vertices.dtype)[:, None] * (head - tail)


def centroids(recipe: Recipe, place: jax.Array) -> Sections:
    """Of the sections whose corners are at ``place`` (C, 3)."""
    num, dtype = len(recipe.node), place.dtype
    share = jnp.asarray(recipe.share, dtype)[:, None]

    def total(value: jax.Array) -> jax.Array:
        return jax.ops.segment_sum(value, recipe.section, num, indices_are_sorted=True)

    mean = total(share * place)
    p = place - mean[recipe.section]
    onward = p[recipe.onward]
    cross = jnp.cross(p, onward)
    vector = total(cross)
    twice2 = (vector * vector).sum(1)
    is_some = twice2 > 0
    twice = jnp.where(is_some, jnp.sqrt(jnp.where(is_some, twice2, 1.0)), 0.0)
    normal = vector / jnp.where(is_some, twice, 1.0)[:, None]
    part = (cross * normal[recipe.section]).sum(1)
    spread2 = total(share[:, 0] * (p * p).sum(1))
    recorded, is_loop = jnp.asarray(recipe.area, dtype), jnp.asarray(recipe.is_loop)
    grown = jnp.where(is_loop, twice / 2, 0.0).sum() / jnp.maximum(recorded.sum(), jnp.finfo(dtype).tiny)
    is_there = is_loop & (twice / 2 > VANISHED * jnp.maximum(grown * recorded, spread2))
    off = total(part[:, None] * (p + onward)) / (3 * jnp.where(is_there, twice, 1.0))[:, None]
    height2 = total(share[:, 0] * (p * normal[recipe.section]).sum(1) ** 2)
    warp = jnp.sqrt(height2 / jnp.where(spread2 > 0, spread2, 1.0))
    area = jnp.where(is_there | ~is_loop, twice / 2, 0.0)
    return Sections(mean + jnp.where(is_there[:, None], off, 0.0), area, normal, jax.lax.stop_gradient(warp))


def follow(recipe: Recipe, vertices: jax.Array) -> Curve:
    """The curve for ``vertices`` (V, 3), in the caller's units; NaN at a node whose own section has vanished."""
    dtype = vertices.dtype
    diagonal = jnp.asarray(recipe.diagonal, dtype)
    entered = (vertices - jnp.asarray(recipe.centre, dtype)) / diagonal
    found = centroids(recipe, corners(recipe, entered))
    num = len(recipe.rest)

    def product(row: jax.Array, column: jax.Array, value: jax.Array, of: jax.Array) -> jax.Array:
        entries = jnp.asarray(value, dtype)[:, None] * of[column]
        return jax.ops.segment_sum(entries, row, num, indices_are_sorted=True)

    nodes = product(recipe.a_row, recipe.a_column, recipe.a_value, found.centroid)
    nodes = nodes + product(recipe.b_row, recipe.b_column, recipe.b_value, entered) + jnp.asarray(recipe.rest, dtype)
    is_gone = jax.ops.segment_max((jnp.asarray(recipe.is_loop) & (found.area == 0)).astype(jnp.int32), recipe.node, num)
    nodes = jnp.where((is_gone > 0)[:, None], jnp.nan, nodes)
    radii = _radii(nodes, entered[recipe.nearby], jnp.asarray(recipe.is_inside))
    return Curve(jnp.asarray(recipe.centre, dtype) + diagonal * nodes, diagonal * radii)


def _radii(nodes: jax.Array, triangles: jax.Array, is_inside: jax.Array) -> jax.Array:
    """Signed distance (N,) to the nearest of the ``triangles`` (N, K, 3, 3) of each node.

    Which is nearest is found first, so that derivatives are taken of one distance a node.
    """
    nearest = _distances2(*jax.lax.stop_gradient((nodes, triangles))).argmin(axis=1)
    return clearance(nodes, triangles[jnp.arange(len(nodes)), nearest], is_inside)


def _distances2(nodes: jax.Array, triangles: jax.Array) -> jax.Array:
    """(N, K) squared distance of each node to each of its triangles: to the plane over it, else to the nearest edge."""
    along = jnp.roll(triangles, -1, axis=2) - triangles
    offset = nodes[:, None, None] - triangles
    length2 = (along * along).sum(-1)
    t = jnp.clip((offset * along).sum(-1) / jnp.where(length2 > 0, length2, 1.0), 0.0, 1.0)
    rest = offset - t[..., None] * along
    to_edge = (rest * rest).sum(-1).min(-1)
    normal = jnp.cross(along[:, :, 0], along[:, :, 1])
    area2 = (normal * normal).sum(-1)
    is_over = ((jnp.cross(along, offset) * normal[:, :, None]).sum(-1) >= 0).all(-1) & (area2 > 0)
    height = (offset[:, :, 0] * normal).sum(-1)
    return jnp.where(is_over, height * height / jnp.where(area2 > 0, area2, 1.0), to_edge)
