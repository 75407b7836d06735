"""Losses of followed curves: a number, 0 at best, of each mesh; rows of padding do not count.

    found = msf_jax.follow(skeleton.binding, skeleton.binding.vertices)
    loss = losses.near(found, skeleton.binding, target) + 0.1 * losses.clearance(found, skeleton.binding, 0.01)

For the binding of one skeleton a loss is a number, for one by `msf_jax.stack` of B meshes (B,). Targets are in the
mesh's units, losses in squared diagonals of the mesh, so that those of meshes of any size can be added. The loss of a
mesh with a vanished cross-section is NaN: ``jnp.where(jnp.isnan(loss), 0, loss)`` leaves it out, also out of the
gradient. Arguments of other shapes or kinds are a `ConfigError`. Lengths, areas and angles are in `msf_jax.measures`.
"""

from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from jax import lax

from msf_jax.base.binding import Binding
from msf_jax.base.errors import ConfigError
from msf_jax.device import laplacian
from msf_jax.gradients.follow import numbers_of, promoting

SAMPLES = 4  # points along each edge of a curve
SHORTEST = 1e-4  # diagonals: shorter edges count less in the turning, in proportion to their length
TOGETHER = 64  # points, and other points to look at, in one step: bounds memory
TINY = 1e-24  # diagonals squared: below this squared length, the gradient of a length is 0


@promoting()
def near(found: Any, binding: Binding, target: Any, mesh: Any = None) -> jax.Array:
    """Mean squared distance between the curve and a ``target``, in squared diagonals: the mean of both directions.

    One direction is from points spread evenly over the curve's length to the nearest target point. The other is from
    each target point to the nearest of those points, or of nodes without an edge. Target points that are h apart along
    the curve leave h^2 / 24 of a curve through all of them: take them close together.

    Args:
        found, binding: of `msf_jax.follow`, and the binding that was followed.
        target: (P, 3) points along the wanted curves, in the units of their meshes.
        mesh: (P,) the number of the mesh that each point belongs to, in any order; all to the first if not given. A
            point of -1 does not count. The loss of a mesh without points is 0.

    Differentiable in: nodes, target, with the nearest points held fixed.
    """
    nodes = _nodes(found, binding)
    target = jnp.asarray(numbers_of("target", target, ConfigError))
    if target.ndim != 2 or target.shape[1] != 3:
        raise ConfigError(f"target has shape {target.shape}: expected points (P, 3)")
    if mesh is None and jnp.ndim(binding.diagonal):
        raise ConfigError(
            f"mesh is None, and the binding has {len(binding.diagonal)} meshes: expected (P,) their numbers"
        )
    mesh = numbers_of("mesh", np.zeros(len(target), np.int32) if mesh is None else mesh, ConfigError)
    if mesh.shape != (len(target),) or not jnp.isdtype(mesh.dtype, "integral"):
        raise ConfigError(f"mesh has shape {mesh.shape}, type {mesh.dtype}: expected ({len(target)},) whole numbers")
    num = jnp.size(binding.diagonal)
    mesh = jnp.where((mesh >= 0) & (mesh < num), mesh, num).astype(jnp.int32)  # those of padding come last
    order = jnp.argsort(mesh)
    mesh, target = mesh[order], target[order]
    diagonal = lax.stop_gradient(jnp.reshape(jnp.asarray(binding.diagonal, target.dtype), -1))
    target = target / diagonal[jnp.minimum(mesh, num - 1)][:, None]
    # The points of each curve follow those of the meshes before: nodes, and samples of edges.
    of_edge, of_node = (jnp.asarray(binding.mesh_of(kind)) for kind in ("edges", "nodes"))
    a, b = nodes[binding.edges.T]
    share = (jnp.arange(SAMPLES, dtype=nodes.dtype) + 0.5) / SAMPLES
    points = (a[:, None] + share[None, :, None] * (b - a)[:, None]).reshape(-1, 3)
    is_sample, weight, of_sample = (jnp.repeat(x, SAMPLES) for x in (binding.edge_mask, norm(b - a), of_edge))
    # A node without an edge has no length, so it counts only if its curve has no edges at all.
    at_edge = jnp.zeros(len(nodes), bool).at[binding.edges].max(binding.edge_mask[:, None])
    is_lone = binding.node_mask & ~at_edge
    is_bare = jnp.asarray(binding.live.edges).reshape(-1)[of_node] == 0
    points, is_sample = jnp.concatenate([points, nodes]), jnp.concatenate([is_sample, is_lone])
    weight = jnp.concatenate([weight, (is_lone & is_bare).astype(weight.dtype)])
    own = jnp.where(is_sample, jnp.concatenate([of_sample, of_node]), num)
    order = jnp.argsort(own)
    points, is_sample, weight, own = (x[order] for x in (points, is_sample, weight, own))
    there, back = _to_nearest(points, own, target, mesh, num), _to_nearest(target, mesh, points, own, num)
    loss = _mean(there, jnp.where(is_sample, weight, 0.0), own, num) + _mean(back, mesh < num, mesh, num)
    return _nan_if_vanished(found, binding, (loss / 2).reshape(jnp.shape(binding.diagonal)))


@promoting()
def smoothness(found: Any, binding: Binding) -> jax.Array:
    """Mean over nodes with two neighbours of one minus the cosine of the angle by which the curve turns there.

    Differentiable in: nodes.
    """
    turns = turning(_nodes(found, binding), binding.edges, binding.edge_mask)
    return _nan_if_vanished(found, binding, _mean_of_nodes(binding, *turns))


@promoting()
def clearance(found: Any, binding: Binding, least: Any) -> jax.Array:
    """Mean over the nodes of the squared shortfall of the radii below ``least``, in squared diagonals.

    It is 0 if the solid is at least twice as thick as ``least`` along its curve. For a node outside, its distance to
    the surface is added. ``least`` is a number, or one for each row of the nodes, in the mesh's units.

    Differentiable in: radii, least.
    """
    rows, least = len(_nodes(found, binding)), numbers_of("least", least, ConfigError)
    if least.shape not in ((), (rows,)):
        raise ConfigError(f"least has shape {least.shape}: expected a number, or ({rows},), one for each row of nodes")
    short = jnp.maximum(_scaled(binding, (least - found.radii)[:, None])[:, 0], 0.0)
    return _mean_of_nodes(binding, short**2, binding.node_mask)


def turning(nodes: jax.Array, edges: Any, is_edge: Any) -> tuple[jax.Array, jax.Array]:
    """One minus the cosine of the turn at each of ``nodes`` (N, 3), in diagonals, and whether it has two edges."""
    num, (a, b) = len(nodes), edges.T
    along = nodes[b] - nodes[a]
    along = jnp.where(is_edge[:, None], along / jnp.maximum(norm(along), SHORTEST)[:, None], 0.0)
    total = jax.ops.segment_sum(along, a, num) - jax.ops.segment_sum(along, b, num)
    one = is_edge.astype(nodes.dtype)
    is_passed = jax.ops.segment_sum(one, a, num) + jax.ops.segment_sum(one, b, num) == 2
    # Unit vectors u, v to both neighbours cancel where the curve is straight: |u + v|^2 = 2 (1 - cos turn).
    return (total * total).sum(1) / 2, is_passed


def _to_nearest(points: jax.Array, own: jax.Array, others: jax.Array, their: jax.Array, num: int) -> jax.Array:
    """(P,) squared distance from each of ``points`` (P, 3) of the meshes ``own`` (P,) to the nearest of ``others``
    (Q, 3) of the same mesh, where ``their`` (Q,) ascends; 0 if there is none. Rows of mesh ``num`` are padding."""
    if not len(others):
        return jnp.zeros(len(points), points.dtype)
    fixed = lax.stop_gradient(others)
    first, stop = (jnp.searchsorted(their, jnp.arange(num), side=side) for side in ("left", "right"))

    def nearest(given: tuple[jax.Array, jax.Array]) -> jax.Array:
        point, mesh = given
        until = jnp.where(mesh < num, stop[jnp.minimum(mesh, num - 1)], 0)

        def step(state: tuple[jax.Array, ...]) -> tuple[jax.Array, ...]:
            at, best, which = state
            rows = at + jnp.arange(TOGETHER, dtype=at.dtype)
            away = ((point - fixed[jnp.minimum(rows, len(fixed) - 1)]) ** 2).sum(-1)
            away = jnp.where(rows < until, away, jnp.inf)
            row = away.argmin()
            is_nearer = away[row] < best
            return at + TOGETHER, jnp.where(is_nearer, away[row], best), jnp.where(is_nearer, rows[row], which)

        at = first[jnp.minimum(mesh, num - 1)]
        start = at, jnp.inf + 0 * point[0], at  # not a constant: in a `jax.shard_map` it varies from device to device
        return lax.while_loop(lambda state: state[0] < until, step, start)[2]

    found = lax.map(nearest, (lax.stop_gradient(points), own), batch_size=TOGETHER)
    found = jnp.minimum(found, len(others) - 1)
    return jnp.where(their[found] == own, ((points - others[found]) ** 2).sum(-1), 0.0)


def _nodes(found: Any, binding: Binding) -> jax.Array:
    """The nodes (N, 3) of ``found``, in diagonals; 0 for vanished ones, of which even a gradient of 0 would be NaN."""
    nodes = checked(found, binding)
    return _scaled(binding, jnp.where(jnp.isnan(nodes), 0.0, nodes))


def _nan_if_vanished(found: Any, binding: Binding, loss: jax.Array) -> jax.Array:
    """``loss`` of each mesh; NaN for one with a vanished node."""
    is_gone = jnp.isnan(found.nodes).any(axis=1).astype(jnp.int32)
    is_gone = jax.ops.segment_max(is_gone, jnp.asarray(binding.mesh_of("nodes")), jnp.size(binding.diagonal))
    return jnp.where(is_gone.reshape(loss.shape) > 0, jnp.nan, loss)


def checked(found: Any, binding: Binding) -> jax.Array:
    """The nodes (N, 3) of ``found``, if it has as many rows as ``binding``."""
    if not isinstance(binding, Binding) or not hasattr(found, "nodes"):
        raise ConfigError(
            f"found is a {type(found).__name__}, and binding a {type(binding).__name__}: expected what msf_jax.follow "
            "returned, and then the binding that was followed, such as skeleton.binding"
        )
    rows, shape = jnp.shape(binding.rest)[0], jnp.shape(found.nodes)
    if shape != (rows, 3):
        raise ConfigError(
            f"found has nodes of shape {shape}: expected ({rows}, 3), as msf_jax.follow(binding, vertices) gives them"
        )
    return jnp.asarray(found.nodes)


def _scaled(binding: Binding, lengths: Any) -> jax.Array:
    """``lengths`` (N, ...) of nodes in diagonals of the recorded mesh."""
    lengths = jnp.asarray(lengths)
    diagonal = lax.stop_gradient(jnp.asarray(binding.diagonal, lengths.dtype))
    return lengths / binding.spread(diagonal[..., None], "nodes")


def _mean_of_nodes(binding: Binding, values: jax.Array, counts: jax.Array) -> jax.Array:
    """The mean of ``values`` (N,) over the nodes that ``counts`` (N,), of each mesh."""
    of, num = jnp.asarray(binding.mesh_of("nodes")), jnp.size(binding.diagonal)
    return _mean(values, binding.node_mask & counts, of, num).reshape(jnp.shape(binding.diagonal))


def _mean(values: jax.Array, weight: jax.Array, mesh: jax.Array, num: int) -> jax.Array:
    """(num,) the mean of ``values`` of each ``mesh``, weighted by ``weight``, which may be a mask; 0 if all are 0."""
    weight = weight.astype(values.dtype)
    total = jax.ops.segment_sum(weight, mesh, num)
    # Values with weight 0 may be infinite.
    sums = jax.ops.segment_sum(weight * jnp.where(weight > 0, values, 0.0), mesh, num)
    return sums / jnp.where(total > 0, total, 1.0)


def norm(vectors: jax.Array) -> jax.Array:
    """Norm over the last axis. At length 0, to rounding, its gradient is 0."""
    return laplacian.norm(jnp.where(laplacian.squared(vectors)[..., None] <= TINY, 0.0, vectors))
