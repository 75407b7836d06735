"""`stack`: curves of many meshes, of any sizes, as one padded batch for `jax.vmap`, with one compiled program.

As in graph libraries, every array has the size of the largest member, and masks tell rows from padding.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

from msf_jax.base.binding import Binding, Sizes, capacity_for, padded, unpadded
from msf_jax.base.errors import ConfigError
from msf_jax.device.buffers import real_dtype
from msf_jax.gradients.follow import Followed
from msf_jax.skeleton.skeleton import Skeleton

# Floating-point types that `follow` supports.
REALS = (np.float32, np.float64, np.dtype("float32"), np.dtype("float64"), "float32", "float64")


@jax.tree_util.register_dataclass
@dataclass(frozen=True, eq=False)
class Batch:
    """B curves and their meshes, padded to one capacity: N nodes and V vertices. A pytree of arrays.

    Attributes:
        bindings: the argument of `msf_jax.follow`; every array has a first axis of length B.
        vertices: (B, V, 3) of the recorded meshes, in the units of each; 0 in padding.
        vertex_mask: (B, V) bool: rows that are vertices.
        node_mask: (B, N) bool: rows that are nodes.
    """

    bindings: Binding
    vertices: Any
    vertex_mask: Any
    node_mask: Any

    def __repr__(self) -> str:
        nodes, vertices = self.node_mask.shape[1], self.vertices.shape[1]
        return f"Batch({len(self)} curves, {nodes} rows of nodes, {vertices} of vertices)"

    def __len__(self) -> int:
        return self.vertices.shape[0]

    def unstack(self, followed: Any) -> list[Followed]:
        """The followed curves one by one, without padding, as NumPy arrays.

        Args:
            followed: the result of ``jax.vmap(msf_jax.follow)`` for this batch, nodes (B, N, 3) and radii (B, N).
        """
        counts = np.asarray(self.bindings.live.nodes)
        nodes, radii = (jax.device_get(part) for part in followed)
        return [Followed(nodes[k, :count], radii[k, :count]) for k, count in enumerate(counts)]

    def members(self) -> list[tuple[Binding, np.ndarray]]:
        """What was stacked, one by one: of each mesh the binding, as `Skeleton.binding` is, and vertices (V, 3)."""
        found, vertices = [], np.asarray(self.vertices)
        for k in range(len(self)):
            binding = unpadded(jax.tree.map(lambda values, k=k: np.asarray(values)[k], self.bindings))
            found.append((padded(binding, capacity_for(binding.live)), vertices[k, : binding.live.vertices]))
        return found


def stack(skeletons: Iterable[Skeleton], *, like: Batch | None = None, dtype: Any = None) -> Batch:
    """Curves of many meshes as one batch: ``jax.vmap(msf_jax.follow)(batch.bindings, batch.vertices)``.

    Capacities are those of the largest mesh and the largest curve, so stack meshes of similar size; see
    ``skeleton.binding.capacity``. In padding, nodes, radii and gradients are zero. Padding does not change other rows.

    Args:
        skeletons: of runs, at least one; as `msf_jax.follow` takes them.
        like: an earlier batch. If all skeletons fit into its capacity, that capacity is used, and a program that was
            compiled for it can be used again, if the number of curves is the same, too.
        dtype: of all real numbers, float32 or float64. The default is float64 if JAX has it enabled, else float32.

    Raises:
        ConfigError: ``skeletons`` is empty, a skeleton has no source mesh, or ``like`` or ``dtype`` has a wrong type.
    """
    if isinstance(skeletons, Skeleton) or not isinstance(skeletons, Iterable):
        raise ConfigError(f"skeletons is a {type(skeletons).__name__}: expected several, such as [skeleton]")
    if like is not None and not isinstance(like, Batch):
        raise ConfigError(f"like is a {type(like).__name__}: expected a batch that msf_jax.stack made")
    if dtype is not None and dtype not in REALS:
        raise ConfigError(f"dtype is {dtype!r}: expected float32 or float64")
    every = list(skeletons)
    others = [type(each).__name__ for each in every if not isinstance(each, Skeleton)]
    if others or not every:
        found = others[0] if others else "none"
        raise ConfigError(f"skeletons has {found}: expected at least one msf_jax.Skeleton, and nothing else")
    bare = [unpadded(skeleton.binding) for skeleton in every]
    sizes: list[Sizes] = [binding.live for binding in bare]
    capacity = capacity_for(*sizes)
    if like is not None and all(one <= most for one, most in zip(capacity, like.bindings.capacity, strict=True)):
        capacity = like.bindings.capacity
    dtype = jnp.dtype(real_dtype() if dtype is None else dtype)

    def together(*values: Any) -> jax.Array:
        stacked = np.stack(values)
        return jnp.asarray(stacked.astype(dtype) if stacked.dtype.kind == "f" else stacked)

    bindings: Binding = jax.tree.map(together, *(padded(binding, capacity) for binding in bare))
    vertices = np.zeros((len(every), capacity.vertices, 3), dtype=dtype)
    for row, skeleton in zip(vertices, every, strict=True):
        given = skeleton.bound_surface.given(len(skeleton.mesh_map))
        row[: len(given)] = given
    return Batch(bindings, jnp.asarray(vertices), bindings.vertex_mask, bindings.node_mask)
