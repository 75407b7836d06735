"""Losses of followed curves, to train with: each a number, 0 at best, of one curve, padded or not.

    found = msf_jax.follow(binding, vertices)
    loss = losses.near(found, binding, target) + 0.1 * losses.clearance(found, binding, 0.01)

For a batch, `jax.vmap` them over everything. ``binding`` says which rows are nodes and edges, and how large the mesh
is: lengths are divided by its diagonal, so that losses have no unit and one sum serves meshes of any size. All are
means, so that a curve of many nodes weighs as much as one of few. A node that has vanished is NaN, and so is the loss:
``jnp.where(jnp.isnan(loss), 0, loss)`` leaves such a mesh out, its gradient too.
"""

from typing import Any

import jax
import jax.numpy as jnp

from msf_jax.base.binding import Binding
from msf_jax.base.errors import ConfigError

SAMPLES = 4  # along each edge of a curve
SHORTEST = 1e-4  # edge, in diagonals, whose direction counts in full
TINY = 1e-24  # squared length, in diagonals, below which a length has no gradient


def near(found: Any, binding: Binding, target: Any, mask: Any = None, *, samples: int = SAMPLES) -> jax.Array:
    """Squared distance between the curve and a ``target``, in both directions, the mean of the two.

    From points spread evenly over the curve's length, each to the nearest of the target; and from each point of the
    target, to the nearest of those. No correspondence is needed, nor as many nodes.

    Args:
        found: of `msf_jax.follow`, nodes (N, 3).
        binding: what it was followed by.
        target: (P, 3) points along the wanted curve, in the mesh's units.
        mask: (P,) bool, which of them count; all if not given. Where none does, the loss is 0.
        samples: points on each edge of the curve.

    Differentiable in: nodes, target. Which point is nearest is a decision.
    """
    nodes, target = _scaled(binding, _checked(found, binding).nodes), _scaled(binding, target)
    is_point = jnp.ones(len(target), bool) if mask is None else jnp.asarray(mask)
    a, b = nodes[binding.edges[:, 0]], nodes[binding.edges[:, 1]]
    share = (jnp.arange(samples, dtype=nodes.dtype) + 0.5) / samples
    points = (a[:, None] + share[:, None] * (b - a)[:, None]).reshape(-1, 3)
    is_edge = binding.edge_mask
    weight = jnp.repeat(jnp.where(is_edge, norm(b - a), 0.0), samples)
    away = ((points[:, None] - target) ** 2).sum(-1)
    there = jnp.where(is_point | ~is_point.any(), away, jnp.inf).min(axis=1) * is_point.any()
    back = jnp.where(jnp.repeat(is_edge, samples)[:, None], away, jnp.inf).min(axis=0)
    return (_mean(there, weight) + _mean(back, is_point)) / 2


def radii(found: Any, binding: Binding, target: Any) -> jax.Array:
    """Squared difference between the radii and the ``target`` (N,) ones, in the mesh's units; mean over the nodes.

    Differentiable in: radii, target.
    """
    return _mean(_scaled(binding, _checked(found, binding).radii - jnp.asarray(target)) ** 2, binding.node_mask)


def lengths(found: Any, binding: Binding, target: Any) -> jax.Array:
    """Squared difference between the lengths of the branches and the ``target`` (E,) ones, as `branch_lengths` gives
    them; mean over the branches that have a length in the target.

    Differentiable in: nodes, target.
    """
    wanted = jnp.asarray(target)
    return _mean(_scaled(binding, branch_lengths(found, binding) - wanted) ** 2, wanted > 0)


def branch_lengths(found: Any, binding: Binding) -> jax.Array:
    """(E,) the length of each branch, in the mesh's units: of those of `Skeleton.branches` that have edges, in their
    order; 0 in the rows after the last.

    Differentiable in: nodes; zero gradient at an edge without a length.
    """
    nodes = _checked(found, binding).nodes
    along = norm(_scaled(binding, nodes[binding.edges[:, 1]] - nodes[binding.edges[:, 0]]))
    along = jnp.where(binding.edge_mask, along, 0.0)
    return jnp.asarray(binding.diagonal, along.dtype) * jax.ops.segment_sum(along, binding.branch, len(along))


def smoothness(found: Any, binding: Binding) -> jax.Array:
    """One minus the cosine of the angle by which the curve turns at a node; mean over the nodes with two neighbours.

    Differentiable in: nodes.
    """
    return turning(
        _scaled(binding, _checked(found, binding).nodes), binding.edges, binding.edge_mask, binding.node_mask
    )


def clearance(found: Any, binding: Binding, least: Any) -> jax.Array:
    """Squared shortfall of the radii below ``least``, in the mesh's units, a number or (N,); mean over the nodes.

    0 where the solid is at least twice as thick as that all along its curve, which casting and printing want; a node
    outside falls short by its distance to the surface, too.
    Differentiable in: radii, least.
    """
    short = jnp.maximum(_scaled(binding, jnp.asarray(least) - _checked(found, binding).radii), 0.0)
    return _mean(short**2, binding.node_mask)


def markers(found: Any, binding: Binding, node: Any, target: Any, mask: Any = None) -> jax.Array:
    """Squared distance of some nodes, such as the ends of limbs, from where they should be; mean over those.

    Args:
        found: of `msf_jax.follow`.
        binding: what it was followed by.
        node: (M,) their numbers.
        target: (M, 3) in the mesh's units.
        mask: (M,) bool, which of them count; all if not given.

    Differentiable in: nodes, target.
    """
    away = _scaled(binding, _checked(found, binding).nodes[jnp.asarray(node)] - jnp.asarray(target))
    return _mean((away * away).sum(-1), jnp.ones(len(away), bool) if mask is None else jnp.asarray(mask))


def turning(nodes: jax.Array, edges: Any, is_edge: Any, is_node: Any) -> jax.Array:
    """See `smoothness`; ``nodes`` (N, 3) in diagonals, ``edges`` (E, 2)."""
    num, (a, b) = len(nodes), (edges[:, 0], edges[:, 1])
    along = nodes[b] - nodes[a]
    along = along / jnp.maximum(norm(along), SHORTEST)[:, None]
    along = jnp.where(is_edge[:, None], along, 0.0)
    total = jax.ops.segment_sum(along, a, num) - jax.ops.segment_sum(along, b, num)
    one = is_edge.astype(nodes.dtype)
    is_passed = is_node & (jax.ops.segment_sum(one, a, num) + jax.ops.segment_sum(one, b, num) == 2)
    # Unit vectors to both neighbours add up to nothing where the curve is straight: |u + v|^2 = 2 (1 - cos turn).
    return _mean((total * total).sum(1) / 2, is_passed)


def _checked(found: Any, binding: Binding) -> Any:
    """``found``, which is that of one curve, in as many rows as ``binding`` has."""
    rows, shape = jnp.shape(binding.rest)[-2], jnp.shape(found.nodes)
    if shape != (rows, 3) or jnp.ndim(binding.diagonal):
        raise ConfigError(
            f"found has nodes of shape {shape}: expected ({rows}, 3), as msf_jax.follow(binding, vertices) gives them; "
            "of a batch, jax.vmap the loss over both"
        )
    return found


def _scaled(binding: Binding, lengths: Any) -> jax.Array:
    """``lengths`` in diagonals of the mesh as it was recorded."""
    lengths = jnp.asarray(lengths)
    return lengths / jnp.asarray(binding.diagonal, lengths.dtype)


def _mean(values: jax.Array, weight: jax.Array) -> jax.Array:
    """Of ``values`` with those weights, or where that is True; 0 if there is none."""
    weight = weight.astype(values.dtype)
    total = weight.sum()
    # What counts for nothing may be infinite.
    return jnp.where(weight > 0, weight * jnp.where(weight > 0, values, 0.0), 0.0).sum() / jnp.where(
        total > 0, total, 1.0
    )


def norm(vectors: jax.Array) -> jax.Array:
    """Norm over the last axis, with a zero gradient where there is none."""
    square = (vectors * vectors).sum(-1)
    is_short = square <= TINY  # NaN is not
    return jnp.where(is_short, 0.0, jnp.sqrt(jnp.where(is_short, 1.0, square)))
