"""`follow`: the finished curve of a mesh whose vertices have moved, in pure JAX and without a run.

Unlike `replay` it depends on no decisions of a run. It averages cross-sections of limbs, so its derivatives are
moderate. See `msf_jax.base.binding`.
"""

import random
from collections.abc import Callable, Hashable
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
from jax.core import Tracer

from msf_jax.base.binding import Binding
from msf_jax.base.errors import ConfigError, MeshError
from msf_jax.device import following
from msf_jax.device.buffers import real_dtype
from msf_jax.skeleton.skeleton import Skeleton

MOST_PROGRAMS = 16  # compiled programs that are kept, about 8 MB each: one for each capacity and floating-point type


class Followed(NamedTuple):
    """nodes: (N, 3), in the mesh's units. radii: (N,) signed distance to the surface, negative for a node outside."""

    nodes: jax.Array
    radii: jax.Array

    def __repr__(self) -> str:
        parts = (f"{name} {part.dtype}{list(part.shape)}" for name, part in self._asdict().items())
        return f"Followed({', '.join(parts)})"


def follow(skeleton: Skeleton | Binding, vertices: Any) -> Followed:
    """The curve of ``skeleton`` for its mesh with moved ``vertices`` (V, 3) and the same faces, without a run.

    Each node is tied to cross-sections of its limb. Their corners are stored as fractions of mesh edges, so they move
    with the mesh. The offset of a node from the centroids turns and stretches with the limb. Junctions, and ends
    without a cross-section, move with the nearest cross-sections; pins move with their vertices. An affine map of the
    mesh maps the curve by the same map. At the recorded vertices the result is ``skeleton.vertices``, to rounding. The
    mesh must keep its limbs: a new limb, or a limb bent through itself, needs a fresh run; `msf_jax.track` detects it.

    Works under `jax.jit`, `grad`, `vmap`, `jacfwd` and `jacrev`, also for second derivatives. The first call for a
    skeleton computes its binding, in well under a second. A jitted function of ``skeleton.binding`` is compiled once
    for all skeletons of its capacity. `msf_jax.stack` makes batches.

    Args:
        skeleton: of a run, also after `Skeleton.prune`, `resample` and `smooth`, or read from an ``.npz`` file. Or its
            padded ``binding``: then nodes and radii are padded by rows of zeros; see ``binding.node_mask``.
        vertices: (V, 3), in the order of the mesh that the run was given, and in its units. For a binding V may be
            any number up to its capacity, ``binding.num_vertices``.

    Returns:
        The nodes and radii. A radius is the exact distance to the nearest triangle of the moved mesh, negative for a
        node outside. Its sign is right unless the moved mesh crosses itself. Both have the floating-point type of
        ``vertices``: float32 if that is narrower, and JAX's default if it is an integer type. Under `jax.jit`, a node
        whose cross-section has vanished is NaN.

    Differentiable in: vertices, with the nearest triangle held fixed. In a triangle soup, where every face has its own
    vertices, the first of several coincident vertices has the whole derivative; the others have 0.

    Raises:
        ConfigError: ``skeleton`` has no source mesh.
        MeshError: ``vertices`` has another shape or is not finite, or the section of a node has vanished.
        FlowError: this process was forked after a run.
    """
    binding = binding_of(skeleton)
    # The body needs neither of JAX's strict modes, which a caller may have set.
    with jax.numpy_dtype_promotion("standard"), jax.numpy_rank_promotion("allow"):
        array = checked_vertices(skeleton, vertices)
        rest = ((0, binding.num_vertices - len(array)), (0, 0))
        if isinstance(array, Tracer) or isinstance(binding.faces, Tracer):
            found = _follow(binding, array if rest[0][1] == 0 else _padded(array, rest))
            return Followed(*(found if isinstance(skeleton, Binding) else _cut(found, len(skeleton.vertices))))
        devices = array.devices() if isinstance(array, jax.Array) else ()
        device = next(iter(devices)) if len(devices) == 1 else None
        # NumPy pads and cuts, because JAX would compile this for every size.
        arguments = _in_dtype(binding, array.dtype), np.pad(jax.device_get(array), rest)
        program = _program((*binding.capacity, np.shape(binding.diagonal), str(array.dtype), device))
        found = program(*jax.device_put(arguments, device))
    nodes, radii = jax.device_get(found)
    gone = np.flatnonzero(np.isnan(nodes).any(axis=1))
    if len(gone):
        raise MeshError(
            f"the sections of {len(gone)} nodes, the first {gone[0]}, have vanished: expected a mesh with the same "
            "limbs; run skeletonize on this one"
        )
    if isinstance(skeleton, Binding):
        return Followed(*found)
    num = len(skeleton.vertices)
    return Followed(*(jax.device_put(part[:num].copy(), device) for part in (nodes, radii)))


# Three programs, also of an eager gradient: the large one is the same for all meshes of a capacity.
_follow = jax.jit(following.follow)
_padded = jax.jit(jnp.pad, static_argnums=1)
_cut = jax.jit(lambda parts, num: tuple(part[:num] for part in parts), static_argnums=1)


_programs: dict[Hashable, Callable[..., Any]] = {}
_chance = random.Random(0)


def _program(key: Hashable) -> Callable[..., Any]:
    """A function of its own for each capacity, type and device, so that each can be dropped when there are too many.

    Which one is left to chance. Where more capacities than the limit take turns, the least recently used is always the
    next one, so that every round would compile all of them again.
    """
    found = _programs.get(key)
    if found is None:
        while len(_programs) >= MOST_PROGRAMS:
            _programs.pop(_chance.choice(list(_programs)), None)
        found = _programs[key] = jax.jit(lambda binding, vertices: following.follow(binding, vertices))
    return found


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
    is_plain = isinstance(vertices, Tracer) or (isinstance(vertices, np.ndarray) and vertices.dtype.kind in "fiu")
    try:
        array = vertices if is_plain else jnp.asarray(vertices)  # of others, this compiles a copy for every size
    except (TypeError, ValueError) as error:
        raise MeshError(f"vertices is a {type(vertices).__name__}: expected an array of numbers (V, 3)") from error
    if not jnp.isdtype(array.dtype, ("real floating", "integral")):
        raise MeshError(f"vertices has the type {array.dtype}: expected real numbers, (V, 3)")
    is_real = jnp.isdtype(array.dtype, "real floating")
    dtype = jnp.promote_types(array.dtype, jnp.float32) if is_real else real_dtype()
    dtype = jax.dtypes.canonicalize_dtype(dtype)
    array = array if array.dtype == dtype else array.astype(dtype)
    binding = binding_of(skeleton)
    if isinstance(skeleton, Binding):
        if array.ndim != 2 or array.shape[1] != 3 or len(array) > binding.num_vertices:
            raise MeshError(
                f"vertices has shape {array.shape}: expected (V, 3), V at most {binding.num_vertices}, the capacity of "
                "the binding"
            )
    elif array.shape != (num := len(skeleton.mesh_map), 3):
        raise MeshError(f"vertices has shape {array.shape}: expected ({num}, 3), as in the mesh of the skeleton")
    if isinstance(binding.faces, Tracer):
        return array
    used = np.zeros(binding.num_vertices, dtype=bool)
    used[np.asarray(binding.faces)] = True
    if used[len(array) :].any():
        raise MeshError(
            f"vertices has shape {array.shape}: expected ({int(binding.live.vertices)}, 3), as in the mesh of the "
            "skeleton"
        )
    if isinstance(array, Tracer):
        return array
    bad = np.flatnonzero(~np.isfinite(jax.device_get(array)).all(axis=1) & used[: len(array)])
    if len(bad):
        raise MeshError(f"{len(bad)} of the vertices, the first {bad[0]}, are not finite: expected finite positions")
    return array


def _in_dtype(binding: Binding, dtype: Any) -> Binding:
    """``binding`` with its real NumPy arrays converted to ``dtype``, so that no other type reaches the device."""

    def cast(values: Any) -> Any:
        is_other = isinstance(values, np.ndarray) and values.dtype.kind == "f" and values.dtype != dtype
        return values.astype(dtype) if is_other else values

    return jax.tree.map(cast, binding)
