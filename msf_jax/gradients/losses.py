"""Losses of followed curves, for training. Each is a number, 0 at best, of one curve, with its rows of padding.

    binding = skeleton.binding
    found = msf_jax.follow(binding, vertices)
    loss = losses.near(found, binding, target) + 0.1 * losses.clearance(found, binding, 0.01)

For a batch, `jax.vmap` a loss over all arguments. ``binding`` has the masks of nodes and edges, and the size of the
mesh. Targets are in the mesh's units. Losses have none: squared lengths are in squared diagonals of the mesh, so that
losses of meshes of any size can be added. They are means, so that they do not depend on the number of nodes. A node
whose cross-section has vanished is NaN, and so is the loss: ``jnp.where(jnp.isnan(loss), 0, loss)`` leaves such a mesh
out, also out of the gradient.

Arguments of other shapes or kinds are a `ConfigError`. A target for nodes or branches may end before the padding. If
JAX traces the binding, as an argument of a jitted function, the number of its nodes is not known: then a target for too
few of them makes the loss NaN.
"""

from collections.abc import Callable
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from jax import lax

from msf_jax.base.binding import Binding
from msf_jax.base.errors import ConfigError
from msf_jax.base.options import is_traced

SAMPLES = 4  # points along each edge of a curve
SHORTEST = 1e-4  # diagonals: shorter edges count less in the turning, in proportion to their length
BLOCK = 32  # points whose nearest ones are found in one step
REAL = ("real floating", "integral")  # kinds of numbers that a target may have
TINY = 1e-24  # diagonals squared: below this squared length, the gradient of a length is 0


def near(found: Any, binding: Binding, target: Any, mask: Any = None, *, samples: int = SAMPLES) -> jax.Array:
    """Mean squared distance between the curve and a ``target``, in squared diagonals: the mean of both directions.

    One direction is from points spread evenly over the curve's length to the nearest target point. The other is from
    each target point to the nearest of those points, or of nodes without an edge. It needs no correspondence.

    Args:
        found: of `msf_jax.follow`, nodes (N, 3).
        binding: the binding that was followed.
        target: (P, 3) points along the wanted curve, in the mesh's units.
        mask: (P,) bool: points that count; all if not given. If none counts, the loss is 0.
        samples: points on each edge of the curve.

    Differentiable in: nodes, target, with the nearest points held fixed.
    """
    nodes = _scaled(binding, _checked(found, binding).nodes)
    target = _array("target", target, "points (P, 3)", lambda shape: len(shape) == 2 and shape[1] == 3)
    target, is_point = _scaled(binding, target), _counting(mask, (len(target),))
    a, b = nodes[binding.edges[:, 0]], nodes[binding.edges[:, 1]]
    share = (jnp.arange(samples, dtype=nodes.dtype) + 0.5) / samples
    points = (a[:, None] + share[None, :, None] * (b - a)[:, None]).reshape(-1, 3)
    is_sample, weight = (jnp.repeat(x, samples) for x in (binding.edge_mask, norm(b - a)))
    # A node without an edge has no length, so it counts only if the curve has no edges at all.
    at_edge = jnp.zeros(len(nodes), bool).at[binding.edges].max(binding.edge_mask[:, None])
    is_lone = binding.node_mask & ~at_edge
    points, is_sample = jnp.concatenate([points, nodes]), jnp.concatenate([is_sample, is_lone])
    weight = jnp.concatenate([weight, (is_lone & ~binding.edge_mask.any()).astype(weight.dtype)])
    there = jnp.where(is_point.any(), _to_nearest(points, target, is_point | ~is_point.any()), 0.0)
    back = _to_nearest(target, points, is_sample)
    return (_mean(there, jnp.where(is_sample, weight, 0.0)) + _mean(back, is_point)) / 2


def radii(found: Any, binding: Binding, target: Any) -> jax.Array:
    """Mean over the nodes of the squared difference between the radii and the ``target``, in squared diagonals.

    Args:
        found: of `msf_jax.follow`.
        binding: the binding that was followed.
        target: a number, or (N,) one for each node, with or without padding, in the mesh's units.

    Differentiable in: radii, target.
    """
    away = _checked(found, binding).radii - _of_nodes("target", target, found, binding)
    return _mean(_scaled(binding, away) ** 2, binding.node_mask)


def lengths(found: Any, binding: Binding, target: Any) -> jax.Array:
    """Mean over the branches of the squared difference between their lengths and the ``target``, in squared diagonals.

    Args:
        found: of `msf_jax.follow`.
        binding: the binding that was followed.
        target: lengths as `branch_lengths` returns them, in the mesh's units: (E,), or one for each branch. Branches
            with a target of 0 are left out.

    Differentiable in: nodes, target.
    """
    along = branch_lengths(found, binding)
    branch, edges, num = binding.branch, binding.live.edges, None
    if not is_traced(branch) and not is_traced(edges):
        num = int(np.max(jax.device_get(branch)[: int(jax.device_get(edges))], initial=-1)) + 1
    # A branch without a target is left out.
    wanted = _of_rows("target", target, num, np.zeros(len(along), bool), along.dtype, "branch")
    return _mean(_scaled(binding, along - wanted) ** 2, wanted > 0)


def branch_lengths(found: Any, binding: Binding) -> jax.Array:
    """(E,) the length of each branch, in the mesh's units, in the order of `Skeleton.branches`, without those that have
    no edge; 0 in padding.

    Differentiable in: nodes; the gradient at an edge of length 0 is 0.
    """
    nodes = _checked(found, binding).nodes
    along = norm(_scaled(binding, nodes[binding.edges[:, 1]] - nodes[binding.edges[:, 0]]))
    along = jnp.where(binding.edge_mask, along, 0.0)
    return jnp.asarray(binding.diagonal, along.dtype) * jax.ops.segment_sum(along, binding.branch, len(along))


def smoothness(found: Any, binding: Binding) -> jax.Array:
    """Mean over nodes with two neighbours of one minus the cosine of the angle by which the curve turns there.

    Differentiable in: nodes.
    """
    return turning(
        _scaled(binding, _checked(found, binding).nodes), binding.edges, binding.edge_mask, binding.node_mask
    )


def clearance(found: Any, binding: Binding, least: Any) -> jax.Array:
    """Mean over the nodes of the squared shortfall of the radii below ``least``, in squared diagonals.

    It is 0 if the solid is at least twice as thick as ``least`` along its curve, as casting and printing need. For a
    node outside, its distance to the surface is added to the shortfall.

    Args:
        found: of `msf_jax.follow`.
        binding: the binding that was followed.
        least: a number, or (N,) one for each node, with or without padding, in the mesh's units.

    Differentiable in: radii, least.
    """
    radii = _checked(found, binding).radii
    short = jnp.maximum(_scaled(binding, _of_nodes("least", least, found, binding) - radii), 0.0)
    return _mean(short**2, binding.node_mask)


def markers(found: Any, binding: Binding, node: Any, target: Any, mask: Any = None) -> jax.Array:
    """Mean squared distance of chosen nodes, such as the ends of limbs, from their targets, in squared diagonals.

    Args:
        found: of `msf_jax.follow`.
        binding: the binding that was followed.
        node: (M,) ids of the nodes, from 0. One that JAX traces and that is no node makes the loss NaN.
        target: (M, 3) in the mesh's units.
        mask: (M,) bool: nodes that count; all if not given.

    Differentiable in: nodes, target.
    """
    nodes = _checked(found, binding).nodes
    row = _array("node", node, "ids (M,) of nodes", lambda shape: len(shape) == 1, "integral")
    target = _array("target", target, f"({len(row)}, 3), one for each node", lambda shape: shape == (*row.shape, 3))
    counts, num = _counting(mask, row.shape), binding.live.nodes
    if not any(map(is_traced, (*jax.tree.leaves((node, mask)), num))):
        given, num = np.asarray(jax.device_get(node)), int(jax.device_get(num))
        bad = ((given < 0) | (given >= num)) & (True if mask is None else np.asarray(jax.device_get(mask), bool))
        if bad.any():
            raise ConfigError(f"node has {given[bad][0]}: expected ids of nodes, from 0 to {num - 1}")
    is_node = (row >= 0) & jnp.asarray(binding.node_mask).at[row].get(mode="fill", fill_value=False)
    away = jnp.where(is_node[:, None], jnp.asarray(nodes)[row], jnp.nan) - target
    away = _scaled(binding, jnp.where(counts[:, None], away, 0.0))
    return _mean((away * away).sum(-1), counts)


def turning(nodes: jax.Array, edges: Any, is_edge: Any, is_node: Any) -> jax.Array:
    """See `smoothness`; ``nodes`` (N, 3) in diagonals, ``edges`` (E, 2)."""
    num, (a, b) = len(nodes), (edges[:, 0], edges[:, 1])
    along = nodes[b] - nodes[a]
    along = along / jnp.maximum(norm(along), SHORTEST)[:, None]
    along = jnp.where(is_edge[:, None], along, 0.0)
    total = jax.ops.segment_sum(along, a, num) - jax.ops.segment_sum(along, b, num)
    one = is_edge.astype(nodes.dtype)
    is_passed = is_node & (jax.ops.segment_sum(one, a, num) + jax.ops.segment_sum(one, b, num) == 2)
    # Unit vectors u, v to both neighbours cancel where the curve is straight: |u + v|^2 = 2 (1 - cos turn).
    return _mean((total * total).sum(1) / 2, is_passed)


def _to_nearest(points: jax.Array, others: jax.Array, counts: jax.Array) -> jax.Array:
    """(P,) squared distance from each of ``points`` (P, 3) to the nearest of ``others`` (Q, 3) that ``counts`` (Q,);
    inf if none does. Memory is for BLOCK points and all others. NaN passes through."""
    if not len(others):
        return jnp.full(len(points), jnp.inf, points.dtype)
    held = lax.stop_gradient(others)

    def nearest(point: jax.Array) -> jax.Array:
        return jnp.where(counts, ((point[None] - held) ** 2).sum(-1), jnp.inf).argmin()

    found = lax.map(nearest, lax.stop_gradient(points), batch_size=BLOCK)
    away = ((points - others[found]) ** 2).sum(-1)
    return jnp.where(counts.any(), away, jnp.inf)


def _checked(found: Any, binding: Binding) -> Any:
    """``found``, if it is of one curve with as many rows as ``binding``; else a `ConfigError`."""
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
    return found


def _array(
    name: str, value: Any, expected: str, is_right: Callable[[tuple[int, ...]], bool], kind: Any = REAL
) -> jax.Array:
    """``value`` as an array, if it is of ``kind`` and its shape ``is_right``; else a `ConfigError`."""
    try:
        array = jnp.asarray(value)
    except (TypeError, ValueError) as error:
        raise ConfigError(f"{name} is a {type(value).__name__}: expected {expected}") from error
    if not jnp.isdtype(array.dtype, kind) or not is_right(array.shape):
        raise ConfigError(f"{name} has shape {array.shape} and type {array.dtype}: expected {expected}")
    return array


def _of_nodes(name: str, value: Any, found: Any, binding: Binding) -> jax.Array:
    """``value``, a number or one for each node, for the rows of ``found``."""
    num = None if is_traced(binding.live.nodes) else int(jax.device_get(binding.live.nodes))
    return _of_rows(name, value, num, binding.node_mask, found.radii.dtype, "node", also=((),))


def _of_rows(
    name: str, value: Any, num: int | None, is_needed: Any, dtype: Any, of: str, also: tuple[tuple[()], ...] = ()
) -> jax.Array:
    """``value``, a number for each of ``num`` things ``of`` a kind, for all rows, or of a shape that is ``also`` right.

    Of a ``num`` that is not known it may have any. Rows beyond it are 0, and NaN where ``is_needed``.
    """
    most = len(is_needed)
    right = (*also, (num,), (most,))
    array = _array(
        name,
        value,
        f"{'a number, ' if also else ''}({'n' if num is None else num},) or ({most},), one for each {of}, without or "
        "with padding",
        lambda shape: shape in right or (num is None and len(shape) == 1 and shape[0] < most),
    )
    if array.shape in ((), (most,)):
        return array
    array = array if jnp.isdtype(array.dtype, "real floating") else array.astype(dtype)
    rest = jnp.where(jnp.asarray(is_needed)[len(array) :], jnp.nan, 0.0)
    return jnp.concatenate([array, rest.astype(array.dtype)])


def _counting(mask: Any, shape: tuple[int, ...]) -> jax.Array:
    """``mask`` of this shape; True everywhere if it is None."""
    if mask is None:
        return jnp.ones(shape, bool)
    return _array("mask", mask, f"{shape} bool", lambda its: its == shape, ("bool", "integral")).astype(bool)


def _scaled(binding: Binding, lengths: Any) -> jax.Array:
    """``lengths`` in diagonals of the recorded mesh."""
    lengths = jnp.asarray(lengths)
    return lengths / jnp.asarray(binding.diagonal, lengths.dtype)


def _mean(values: jax.Array, weight: jax.Array) -> jax.Array:
    """The mean of ``values`` weighted by ``weight``, which may be a mask; 0 if all weights are 0."""
    weight = weight.astype(values.dtype)
    total = weight.sum()
    # Values with weight 0 may be infinite.
    return jnp.where(weight > 0, weight * jnp.where(weight > 0, values, 0.0), 0.0).sum() / jnp.where(
        total > 0, total, 1.0
    )


def norm(vectors: jax.Array) -> jax.Array:
    """Norm over the last axis. At length 0, its gradient is 0."""
    square = (vectors * vectors).sum(-1)
    is_short = square <= TINY  # False for NaN, which passes through
    return jnp.where(is_short, 0.0, jnp.sqrt(jnp.where(is_short, 1.0, square)))
