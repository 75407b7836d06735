"""`follow`: the finished curve of a mesh whose vertices have moved, in pure JAX and without a run; `stack` for many.

Unlike `replay` it depends on no decisions of a run, and averages cross-sections: its derivatives are moderate. As in
graph libraries, every array of a batch has the size of the largest member, and masks tell rows from padding.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from jax.core import Tracer

from msf_jax.base.binding import Binding, capacity_for, padded, unpadded
from msf_jax.base.errors import ConfigError, MeshError
from msf_jax.device import following
from msf_jax.device.buffers import real_dtype
from msf_jax.device.following import Followed
from msf_jax.skeleton.skeleton import Skeleton


def follow(skeleton: Skeleton | Binding, vertices: Any) -> Followed:
    """The curve of ``skeleton`` for its mesh with moved ``vertices`` (V, 3) and the same faces, without a run.

    Each node is tied to cross-sections of its limb (see `msf_jax.base.binding`), or to its own vertices; pins move with
    theirs. An affine map of the mesh maps the curve by the same map. At the recorded vertices the result is
    ``skeleton.vertices``, to rounding. The mesh must keep its limbs: a new limb, or a limb bent through itself, needs a
    fresh run; `msf_jax.track` detects it.

    Works under `jax.jit`, `grad`, `vmap`, `jacfwd` and `jacrev`, also for second derivatives. The first call for a
    skeleton computes its binding, in well under a second. A jitted function of ``skeleton.binding`` is compiled once
    for all skeletons of its capacity. `msf_jax.stack` makes batches.

    Args:
        skeleton: of a run, also after `Skeleton.prune`, `resample` and `smooth`, or read from an ``.npz`` file. Or its
            padded ``binding``: then nodes and radii are padded by rows of zeros; see ``binding.node_mask``.
        vertices: (V, 3), in the order and the units of the mesh of the run. For a binding V may be any number up to
            its capacity, ``binding.num_vertices``.

    Returns:
        The nodes and radii: exact distances to the moved mesh, negative for a node outside. Signs are right unless the
        moved mesh crosses itself. Both have the floating-point type of ``vertices``, at least float32, and JAX's
        default for an integer type. Under `jax.jit`, a node whose cross-section has vanished is NaN.

    Differentiable in: vertices, with the nearest triangle held fixed. In a triangle soup, where every face has its own
    vertices, the first of several coincident vertices has the whole derivative; the others have 0.

    Raises:
        ConfigError: ``skeleton`` has no source mesh.
        MeshError: ``vertices`` has another shape or is not finite, or the section of a node has vanished.
    """
    binding = binding_of(skeleton)
    rows = slice(None if isinstance(skeleton, Binding) else len(skeleton.vertices))
    # The body needs neither of JAX's strict modes, which a caller may have set.
    with jax.numpy_dtype_promotion("standard"), jax.numpy_rank_promotion("allow"):
        array = checked_vertices(skeleton, vertices)
        if isinstance(array, Tracer) or isinstance(binding.faces, Tracer):
            nodes, radii = _follow(binding, jnp.pad(array, ((0, binding.num_vertices - len(array)), (0, 0))))
            return Followed(nodes[rows], radii[rows])
        nodes, radii = evaluated(binding, array)
    gone = np.flatnonzero(np.isnan(nodes).any(axis=1))
    if len(gone):
        raise MeshError(
            f"the sections of {len(gone)} nodes, the first {gone[0]}, have vanished: expected a mesh with the same "
            "limbs; run skeletonize on this one"
        )
    return Followed(*(jax.device_put(part[rows].copy(), _device_of(array)) for part in (nodes, radii)))


_follow = jax.jit(following.follow)


def evaluated(binding: Binding, vertices: Any) -> tuple[np.ndarray, np.ndarray]:
    """Nodes and radii with rows of padding, NaN at a node whose section has vanished, computed where ``vertices`` are.

    NumPy pads, because JAX would compile this for every size.
    """
    padded = np.pad(jax.device_get(vertices), ((0, binding.num_vertices - len(vertices)), (0, 0)))
    return tuple(jax.device_get(_follow(*jax.device_put((binding, padded), _device_of(vertices)))))


def _device_of(array: Any) -> Any:
    """The one device of a JAX array, or None."""
    devices = array.devices() if isinstance(array, jax.Array) else ()
    return next(iter(devices)) if len(devices) == 1 else None


def binding_of(skeleton: Any) -> Binding:
    """The binding of ``skeleton``, which may be a binding itself."""
    if isinstance(skeleton, Binding):
        return skeleton
    if not isinstance(skeleton, Skeleton):
        raise ConfigError(f"skeleton is a {type(skeleton).__name__}: expected a msf_jax.Skeleton, or its binding")
    return skeleton.binding


def checked_vertices(skeleton: Skeleton | Binding, vertices: Any) -> Any:
    """``vertices`` as a JAX or NumPy array (V, 3). Only the shape of a traced array is checked. Vertices that no face
    of the surface uses may be at any position."""
    binding, array = binding_of(skeleton), numbers_of("vertices", vertices, MeshError)
    is_whole = jnp.isdtype(array.dtype, "integral")
    wide = real_dtype() if is_whole else jnp.promote_types(array.dtype, jnp.float32)
    array = array.astype(jax.dtypes.canonicalize_dtype(wide))
    least = most = len(skeleton.mesh_map) if isinstance(skeleton, Skeleton) else binding.num_vertices
    if isinstance(skeleton, Binding):  # padding may be left out
        least = 0 if isinstance(binding.faces, Tracer) else int(np.max(binding.live.vertices))
    if array.ndim != 2 or array.shape[1] != 3 or not least <= len(array) <= most:
        up_to = f" or up to {most}, the binding's capacity" if least < most else ""
        raise MeshError(
            f"vertices has shape {array.shape}: expected ({least}, 3), as in the mesh of the skeleton{up_to}"
        )
    if not isinstance(array, Tracer) and not isinstance(binding.faces, Tracer):
        is_used = np.zeros(len(array), dtype=bool)
        is_used[np.asarray(binding.faces)] = True
        check_finite(array, is_used)
    return array


def numbers_of(name: str, value: Any, error: type[Exception]) -> Any:
    """``value`` as an array of real numbers of JAX or NumPy; else an ``error`` that names it."""
    try:
        array = value if isinstance(value, Tracer | np.ndarray) else jnp.asarray(value)
        is_real = jnp.isdtype(array.dtype, ("real floating", "integral"))
    except (TypeError, ValueError) as cause:
        raise error(f"{name} is a {type(value).__name__}: expected an array of real numbers") from cause
    if not is_real:
        raise error(f"{name} has the type {array.dtype}: expected real numbers")
    return array


def check_finite(vertices: Any, is_used: Any = True) -> None:
    """Raise a `MeshError` if some of ``vertices`` (V, 3) that are used are not finite."""
    bad = np.flatnonzero(~np.isfinite(jax.device_get(vertices)).all(axis=1) & is_used)
    if len(bad):
        raise MeshError(f"{len(bad)} of the vertices, the first {bad[0]}, are not finite: expected finite positions")


@jax.tree_util.register_dataclass
@dataclass(frozen=True, eq=False)
class Batch:
    """B curves and their meshes, padded to one capacity: N nodes and V vertices. A pytree of arrays.

    Attributes:
        bindings: the argument of `msf_jax.follow`; every array has a first axis of length B.
        vertices: (B, V, 3) of the recorded meshes, in the units of each; 0 in padding.
        vertex_mask, node_mask: (B, V) and (B, N) bool: rows that are vertices, rows that are nodes.
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


def stack(skeletons: Iterable[Skeleton], *, like: Batch | None = None) -> Batch:
    """Curves of many meshes as one batch: ``jax.vmap(msf_jax.follow)(batch.bindings, batch.vertices)``.

    Capacities are those of the largest mesh and the largest curve, so stack meshes of similar size; see
    ``skeleton.binding.capacity``. In padding, nodes, radii and gradients are zero, and it changes no other row. Real
    numbers are float64 if JAX has it enabled, else float32.

    Args:
        skeletons: of runs, at least one; as `msf_jax.follow` takes them.
        like: an earlier batch. If all skeletons fit into its capacity, that capacity is used, and a program that was
            compiled for it can be used again, if the number of curves is the same, too.

    Raises:
        ConfigError: ``skeletons`` is empty, a skeleton has no source mesh, or ``like`` has a wrong type.
    """
    every = list(skeletons) if isinstance(skeletons, Iterable) else []
    if not every or not all(isinstance(each, Skeleton) for each in every):
        kinds = ", ".join(sorted({type(each).__name__ for each in every})) or "nothing"
        raise ConfigError(
            f"skeletons is a {type(skeletons).__name__} of {kinds}: expected a list of at least one msf_jax.Skeleton"
        )
    if like is not None and not isinstance(like, Batch):
        raise ConfigError(f"like is a {type(like).__name__}: expected a batch that msf_jax.stack made")
    bare = [unpadded(skeleton.binding) for skeleton in every]
    capacity = capacity_for(*(binding.live for binding in bare))
    if like is not None and all(one <= most for one, most in zip(capacity, like.bindings.capacity, strict=True)):
        capacity = like.bindings.capacity
    bindings: Binding = jax.tree.map(
        lambda *values: jnp.asarray(np.stack(values)), *(padded(binding, capacity) for binding in bare)
    )
    vertices = np.zeros((len(every), capacity.vertices, 3))
    for row, skeleton in zip(vertices, every, strict=True):
        given = skeleton.bound_surface.given(len(skeleton.mesh_map))
        row[: len(given)] = given
    return Batch(bindings, jnp.asarray(vertices), bindings.vertex_mask, bindings.node_mask)
