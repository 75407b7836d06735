"""Losses of followed curves, for training. Each is a number, 0 at best, of one curve, with its rows of padding.

    found = msf_jax.follow(skeleton.binding, vertices)
    loss = losses.near(found, skeleton.binding, target) + 0.1 * losses.clearance(found, skeleton.binding, 0.01)

For a batch, `jax.vmap` a loss over all arguments. Targets are in the mesh's units. Losses are in squared diagonals of
the mesh, so that those of meshes of any size can be added. They are means over the nodes. A node whose cross-section
has vanished is NaN, and so is the loss: ``jnp.where(jnp.isnan(loss), 0, loss)`` leaves such a mesh out, also out of the
gradient. Arguments of other shapes or kinds are a `ConfigError`.
"""

from typing import Any

import jax
import jax.numpy as jnp
from jax import lax

from msf_jax.base.binding import Binding
from msf_jax.base.errors import ConfigError
from msf_jax.gradients.follow import numbers_of

SAMPLES = 4  # points along each edge of a curve
SHORTEST = 1e-4  # diagonals: shorter edges count less in the turning, in proportion to their length
BLOCK = 32  # points whose nearest ones are found in one step: bounds memory
TINY = 1e-24  # diagonals squared: below this squared length, the gradient of a length is 0


def near(found: Any, binding: Binding, target: Any, mask: Any = None) -> jax.Array:
    """Mean squared distance between the curve and a ``target``, in squared diagonals: the mean of both directions.

    One direction is from points spread evenly over the curve's length to the nearest target point. The other is from
    each target point to the nearest of those points, or of nodes without an edge. It needs no correspondence.

    Args:
        found: of `msf_jax.follow`, nodes (N, 3).
        binding: the binding that was followed.
        target: (P, 3) points along the wanted curve, in the mesh's units.
        mask: (P,) bool: points that count; all if not given. If none counts, the loss is 0.

    Differentiable in: nodes, target, with the nearest points held fixed.
    """
    nodes = _nodes(found, binding)
    target = _scaled(binding, numbers_of("target", target, ConfigError))
    if target.ndim != 2 or target.shape[1] != 3:
        raise ConfigError(f"target has shape {target.shape}: expected points (P, 3)")
    is_point = jnp.ones(len(target), bool) if mask is None else jnp.asarray(mask)
    if is_point.shape != (len(target),) or is_point.dtype != bool:
        raise ConfigError(f"mask has shape {is_point.shape}, type {is_point.dtype}: expected ({len(target)},) bool")
    a, b = nodes[binding.edges.T]
    share = (jnp.arange(SAMPLES, dtype=nodes.dtype) + 0.5) / SAMPLES
    points = (a[:, None] + share[None, :, None] * (b - a)[:, None]).reshape(-1, 3)
    is_sample, weight = (jnp.repeat(x, SAMPLES) for x in (binding.edge_mask, norm(b - a)))
    # A node without an edge has no length, so it counts only if the curve has no edges at all.
    at_edge = jnp.zeros(len(nodes), bool).at[binding.edges].max(binding.edge_mask[:, None])
    is_lone = binding.node_mask & ~at_edge
    points, is_sample = jnp.concatenate([points, nodes]), jnp.concatenate([is_sample, is_lone])
    weight = jnp.concatenate([weight, (is_lone & ~binding.edge_mask.any()).astype(weight.dtype)])
    there = jnp.where(is_point.any(), _to_nearest(points, target, is_point | ~is_point.any()), 0.0)
    back = _to_nearest(target, points, is_sample)
    return (_mean(there, jnp.where(is_sample, weight, 0.0)) + _mean(back, is_point)) / 2


def branch_lengths(found: Any, binding: Binding) -> jax.Array:
    """(E,) the length of each branch, in the mesh's units, in the order of `Skeleton.branches`, without those that have
    no edge; 0 in padding.

    Differentiable in: nodes; the gradient at an edge of length 0 is 0.
    """
    a, b = _nodes(found, binding)[binding.edges.T]
    along = jnp.where(binding.edge_mask, norm(b - a), 0.0)
    return jnp.asarray(binding.diagonal, along.dtype) * jax.ops.segment_sum(along, binding.branch, len(along))


def smoothness(found: Any, binding: Binding) -> jax.Array:
    """Mean over nodes with two neighbours of one minus the cosine of the angle by which the curve turns there.

    Differentiable in: nodes.
    """
    return turning(_nodes(found, binding), binding.edges, binding.edge_mask, binding.node_mask)


def clearance(found: Any, binding: Binding, least: Any) -> jax.Array:
    """Mean over the nodes of the squared shortfall of the radii below ``least``, in squared diagonals.

    It is 0 if the solid is at least twice as thick as ``least`` along its curve, as casting and printing need. For a
    node outside, its distance to the surface is added to the shortfall.

    Args:
        found: of `msf_jax.follow`.
        binding: the binding that was followed.
        least: a number, or one for each row of the nodes, in the mesh's units.

    Differentiable in: radii, least.
    """
    rows, least = len(_nodes(found, binding)), numbers_of("least", least, ConfigError)
    if least.shape not in ((), (rows,)):
        raise ConfigError(f"least has shape {least.shape}: expected a number, or ({rows},), one for each row of nodes")
    return _mean(jnp.maximum(_scaled(binding, least - found.radii), 0.0) ** 2, binding.node_mask)


def turning(nodes: jax.Array, edges: Any, is_edge: Any, is_node: Any) -> jax.Array:
    """See `smoothness`; ``nodes`` (N, 3) in diagonals, ``edges`` (E, 2)."""
    num, (a, b) = len(nodes), edges.T
    along = nodes[b] - nodes[a]
    along = jnp.where(is_edge[:, None], along / jnp.maximum(norm(along), SHORTEST)[:, None], 0.0)
    total = jax.ops.segment_sum(along, a, num) - jax.ops.segment_sum(along, b, num)
    one = is_edge.astype(nodes.dtype)
    is_passed = is_node & (jax.ops.segment_sum(one, a, num) + jax.ops.segment_sum(one, b, num) == 2)
    # Unit vectors u, v to both neighbours cancel where the curve is straight: |u + v|^2 = 2 (1 - cos turn).
    return _mean((total * total).sum(1) / 2, is_passed)


def _to_nearest(points: jax.Array, others: jax.Array, counts: jax.Array) -> jax.Array:
    """(P,) squared distance from each of ``points`` (P, 3) to the nearest of ``others`` (Q, 3) that ``counts`` (Q,);
    inf if none does. NaN passes through."""
    if not len(others):
        return jnp.full(len(points), jnp.inf, points.dtype)
    fixed = lax.stop_gradient(others)

    def nearest(point: jax.Array) -> jax.Array:
        return jnp.where(counts, ((point[None] - fixed) ** 2).sum(-1), jnp.inf).argmin()

    found = lax.map(nearest, lax.stop_gradient(points), batch_size=BLOCK)
    away = ((points - others[found]) ** 2).sum(-1)
    return jnp.where(counts.any(), away, jnp.inf)


def _nodes(found: Any, binding: Binding) -> jax.Array:
    """The nodes (N, 3) of ``found``, in diagonals, if it is of one curve with as many rows as ``binding``."""
    if not isinstance(binding, Binding) or not hasattr(found, "nodes"):
        raise ConfigError(
            f"found is a {type(found).__name__}, and binding a {type(binding).__name__}: expected what msf_jax.follow "
            "returned, and then the binding that was followed, such as skeleton.binding"
        )
    rows, shape = jnp.shape(binding.rest)[-2], jnp.shape(found.nodes)
    if shape != (rows, 3) or jnp.ndim(binding.diagonal):
        raise ConfigError(
            f"found has nodes of shape {shape}: expected ({rows}, 3), as msf_jax.follow(binding, vertices) gives them; "
            "of a batch, jax.vmap the loss over both"
        )
    return _scaled(binding, found.nodes)


def _scaled(binding: Binding, lengths: Any) -> jax.Array:
    """``lengths`` in diagonals of the recorded mesh."""
    lengths = jnp.asarray(lengths)
    return lengths / jnp.asarray(binding.diagonal, lengths.dtype)


def _mean(values: jax.Array, weight: jax.Array) -> jax.Array:
    """The mean of ``values`` weighted by ``weight``, which may be a mask; 0 if all weights are 0."""
    weight = weight.astype(values.dtype)
    total = weight.sum()
    # Values with weight 0 may be infinite.
    return (weight * jnp.where(weight > 0, values, 0.0)).sum() / jnp.where(total > 0, total, 1.0)


def norm(vectors: jax.Array) -> jax.Array:
    """Norm over the last axis. At length 0, its gradient is 0."""
    square = (vectors * vectors).sum(-1)
    is_short = square <= TINY  # False for NaN, which passes through
    return jnp.where(is_short, 0.0, jnp.sqrt(jnp.where(is_short, 1.0, square)))
