"""Measures of followed curves, for losses: lengths, chords, means along branches, areas of sections, angles.

    found = msf_jax.follow(skeleton.binding, vertices)
    length = measures.lengths(found, skeleton.binding)
    radius = measures.means(found, skeleton.binding, found.radii)

Those of branches have a row for each branch with an edge, in the order of `Skeleton.branches`, and rows of zeros up to
the number of edges (E,). In a binding by `msf_jax.stack` the branches of a mesh begin at the row of its first edge:
``binding.split(length, "edges")`` has them mesh by mesh. All are in the mesh's units, and exact for the polyline of the
nodes. Arguments of other shapes or kinds are a `ConfigError`.
"""

from typing import Any

import jax
import jax.numpy as jnp
from jax import lax

from msf_jax.base.binding import Binding
from msf_jax.base.errors import ConfigError
from msf_jax.device import following
from msf_jax.gradients.follow import checked_vertices, numbers_of, promoting
from msf_jax.gradients.losses import checked, norm

NEAR, FAR = 1.0, 3.0  # radii of its first node: between these, a branch has its direction


@promoting()
def lengths(found: Any, binding: Binding) -> jax.Array:
    """(E,) the length of each branch.

    Differentiable in: nodes; the gradient at an edge of length 0 is 0.
    """
    return integrals(found, binding, jnp.ones(len(checked(found, binding)), found.nodes.dtype))


@promoting()
def chords(found: Any, binding: Binding) -> jax.Array:
    """(E,) the distance between the ends of each branch; 0 for a loop. Length over chord is its tortuosity.

    Differentiable in: nodes; the gradient at a distance of 0 is 0.
    """
    ends = checked(found, binding)[_ends(binding)]
    return norm(ends[:, 1] - ends[:, 0])


@promoting()
def integrals(found: Any, binding: Binding, values: Any) -> jax.Array:
    """(E,) the integral of ``values`` (N,) of the nodes along each branch, linear on each edge. (The resistance to a
    Poiseuille flow is 8 viscosity / pi times that of ``radius**-4``.)

    Differentiable in: nodes, values.
    """
    nodes, values = checked(found, binding), jnp.asarray(numbers_of("values", values, ConfigError))
    if values.shape != (len(nodes),):
        raise ConfigError(f"values has shape {values.shape}: expected ({len(nodes)},), a number for each row of nodes")
    a, b = binding.edges.T
    of_edge = jnp.where(binding.edge_mask, norm(nodes[b] - nodes[a]) * (values[a] + values[b]) / 2, 0.0)
    return following.sorted_sum(of_edge, binding.branch, len(of_edge))


@promoting()
def means(found: Any, binding: Binding, values: Any) -> jax.Array:
    """(E,) the mean of ``values`` (N,) along each branch, such as ``found.radii`` or `areas`. Differentiable as
    `integrals` is."""
    length = lengths(found, binding)
    return integrals(found, binding, values) / jnp.where(length > 0, length, 1.0)


@promoting()
def areas(skeleton: Any, vertices: Any) -> jax.Array:
    """(N,) the area of the cross-section at each node, across the curve, for arguments of `msf_jax.follow`.

    It is projected along the curve. A node without a section of its own, as near a junction, has the weighted mean of
    those that it is smoothed over. NaN if these are none: at a pin, in a sheet; 0 in padding.

    Differentiable in: vertices.
    """
    binding, array = checked_vertices(skeleton, vertices)
    area = _areas(binding, array)
    return area if isinstance(skeleton, Binding) else area[: len(skeleton.vertices)]


@jax.jit
def _areas(binding: Binding, vertices: jax.Array) -> jax.Array:
    binding, dtype = jax.tree.map(lax.stop_gradient, binding), vertices.dtype
    nodes, num = following.follow(binding, vertices).nodes, len(binding.rest)
    place = following.corners(binding, vertices - binding.spread(jnp.asarray(binding.centre, dtype), "vertices"))
    vector = jnp.where(binding.is_loop[:, None], following.area_vectors(binding, place)[1] / 2, 0.0)
    vector = jax.ops.segment_sum(vector, binding.node, num)  # a node has one section at most
    along = nodes[binding.edges[:, 1]] - nodes[binding.edges[:, 0]]
    length = norm(along)
    along = along / jnp.where(length > 0, length, 1.0)[:, None]
    # The projection is the same for both directions of an edge, and a node has the mean of the squares at its edges.
    square = sum(jax.ops.segment_sum((vector[end] * along).sum(1) ** 2, end, num) for end in binding.edges.T)
    square = square / jnp.maximum(jnp.bincount(binding.edges.ravel(), length=num), 1)
    is_some = square > 0
    area = jnp.where(is_some, jnp.sqrt(jnp.where(is_some, square, 1.0)), 0.0)
    # The mean over neighbours is one-sided at an end: 5 % off in a taper that is three times as wide at one end.
    of = binding.node[binding.a_column]
    weight = jnp.asarray(binding.a_value, dtype) * is_some[of]
    total, sums = (following.sorted_sum(each, binding.a_row, num) for each in (weight, weight * area[of]))
    mean = jnp.where(total > 0, sums / jnp.where(total > 0, total, 1.0), jnp.nan)
    return jnp.where(binding.node_mask, jnp.where(is_some, area, mean), 0.0)


@promoting()
def angles(found: Any, binding: Binding, one: Any, other: Any) -> jax.Array:
    """The angle in radians between branches ``one`` and ``other`` where they meet; pi if one goes straight on.

    The direction of a branch is that of the chord from `NEAR` to `FAR` times the radius of the node where both meet,
    along the branch, or over all of one that is shorter. ``one`` and ``other`` are rows of branches, numbers or arrays
    of one shape, which the result has. NaN if they do not meet; if they meet twice, the angle at the first end of one.

    Differentiable in: nodes, radii.
    """
    nodes, num, ends = checked(found, binding), len(binding.edges), _ends(binding)
    one, other = (jnp.asarray(numbers_of(name, of, ConfigError)) for name, of in (("one", one), ("other", other)))
    along = nodes[binding.edges[:, 1]] - nodes[binding.edges[:, 0]]
    length = jnp.where(binding.edge_mask, norm(along), 0.0)
    total = lengths(found, binding)
    stop = jnp.cumsum(length) - (jnp.cumsum(total) - total)[binding.branch]  # in its branch, at the end of each edge

    def direction(end: int) -> jax.Array:
        radius = jnp.abs(found.radii[ends[:, end]])
        low, high = jnp.minimum(NEAR * radius, total / 2), jnp.minimum(FAR * radius, total)
        if end:
            low, high = total - high, total - low
        part = jnp.clip(stop, low[binding.branch], high[binding.branch])
        part = part - jnp.clip(stop - length, low[binding.branch], high[binding.branch])
        step = (part / jnp.where(length > 0, length, 1.0))[:, None] * along
        chord = following.sorted_sum(step, binding.branch, num)
        return -chord if end else chord

    away = jnp.stack([direction(0), direction(1)], axis=1)
    one, other = jnp.broadcast_arrays(one, other)
    meets = (ends[one][..., :, None] == ends[other][..., None, :]).reshape(*one.shape, 4)
    meets &= ((total[one] > 0) & (total[other] > 0))[..., None]  # of rows that are branches
    first = meets.argmax(-1)
    u, v = away[one, first // 2], away[other, first % 2]
    return jnp.where(meets.any(-1), jnp.arctan2(norm(jnp.cross(u, v)), (u * v).sum(-1)), jnp.nan)


def _ends(binding: Binding) -> jax.Array:
    """(E, 2) the first and the last node of each branch; one node twice in rows that are none."""
    edges, rows = jnp.asarray(binding.edges), jnp.arange(len(binding.edges))
    first, stop = (jnp.searchsorted(jnp.asarray(binding.branch), rows, side=side) for side in ("left", "right"))
    start = edges[jnp.minimum(first, len(edges) - 1), 0]
    return jnp.stack([start, jnp.where(stop > first, edges[stop - 1, 1], start)], axis=1)
