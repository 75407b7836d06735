"""`follow`: the finished curve of a mesh whose vertices have moved, in pure JAX and without a run.

Unlike `replay` it has no decisions in it: sections of limbs are averaged, which is tame. See `msf_jax.base.binding`.
"""

from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
from jax.core import Tracer

from msf_jax.base import forking
from msf_jax.base.binding import Binding
from msf_jax.base.errors import ConfigError, MeshError
from msf_jax.device import following
from msf_jax.device.buffers import real_dtype
from msf_jax.skeleton.skeleton import Skeleton

MOST_PROGRAMS = 16  # that are kept, some 8 MB each: one for each capacity and floating-point type


class Followed(NamedTuple):
    """nodes: (N, 3), in the mesh's units. radii: (N,) signed distance to the surface, negative for a node outside."""

    nodes: jax.Array
    radii: jax.Array

    def __repr__(self) -> str:
        parts = (f"{name} {part.dtype}{list(part.shape)}" for name, part in self._asdict().items())
        return f"Followed({', '.join(parts)})"


def follow(skeleton: Skeleton | Binding, vertices: Any) -> Followed:
    """The ``skeleton`` in its mesh as it is with its vertices at ``vertices`` (V, 3): the same faces, no run.

    Every node keeps to the cross-sections of its limb, which are recorded as fractions of mesh edges and move with
    them; what it is off their middle turns and stretches with the limb. Junctions and bare ends are carried by the
    sections next to them, pins by their vertices. An affine map of the mesh maps the curve along. Where the vertices
    were recorded this is ``skeleton.vertices``, to rounding. It is for meshes of the same limbs: a new limb, or one
    that is bent through itself, wants a fresh run; `msf_jax.track` says when.

    Works under `jax.jit`, `grad`, `vmap`, `jacfwd` and `jacrev`, and twice. The first call for a skeleton records its
    sections, in well under a second. A function that is jitted over ``skeleton.binding`` is compiled once for all
    skeletons of its capacity; many at once are what `msf_jax.stack` is for.

    Args:
        skeleton: of a run, also after `Skeleton.prune`, `resample` and `smooth`, or read from an ``.npz`` file. Or its
            ``binding``, with padding: then nodes and radii are padded, too, by rows of zeros; ``binding.node_mask``
            says which.
        vertices: (V, 3), in the order of the mesh that the run was given, and in its units. For a binding V may be
            anything up to the number of rows that it has room for, ``binding.num_vertices``.

    Returns:
        The nodes, and the distance of each to the surface: to the nearest of all triangles as they are now, negative
        for a node on their outer side. It is exact, however the mesh has moved; its sign is that of the moved solid
        unless that runs through itself. Both are in the floating-point type of ``vertices``, float32 for less, and in
        JAX's usual one for whole numbers. Under `jax.jit`, a node whose own section has vanished is NaN.

    Differentiable in: vertices. Which triangle is nearest is a decision. In a triangle soup, where every face has
    vertices of its own, the first of equal ones moves the surface, and has the whole slope; the others have 0.

    Raises:
        ConfigError: ``skeleton`` does not know the mesh that it was made from.
        MeshError: ``vertices`` has another shape or is not finite, or a section has vanished: whose.
        FlowError: this process was forked from one in which a run was made.
    """
    forking.check()
    binding = binding_of(skeleton)
    array = checked_vertices(skeleton, vertices)
    room, num = binding.num_vertices, len(array)
    if isinstance(array, Tracer) or isinstance(binding.faces, Tracer):
        found = Followed(*_follow(binding, jnp.pad(array, ((0, room - num), (0, 0)))))
        return found if isinstance(skeleton, Binding) else Followed(*(part[: len(skeleton.vertices)] for part in found))
    _in_room(binding, array.dtype)
    # Padded and cut by NumPy: JAX would compile that for every size.
    found = _follow(_in_dtype(binding, array.dtype), np.pad(np.asarray(array), ((0, room - num), (0, 0))))
    nodes, radii = (np.asarray(part) for part in found)
    gone = np.flatnonzero(np.isnan(nodes).any(axis=1))
    if len(gone):
        raise MeshError(
            f"{len(gone)} of the nodes, the first {gone[0]}, have no section around them any more: expected a mesh "
            "with the same limbs; run skeletonize on this one"
        )
    if isinstance(skeleton, Binding):
        return Followed(*found)
    num = len(skeleton.vertices)
    return Followed(jax.device_put(nodes[:num].copy()), jax.device_put(radii[:num].copy()))


_follow = jax.jit(following.follow)
_kept: set[tuple[Any, ...]] = set()  # capacities and types, whose programs are


def _in_room(binding: Binding, dtype: Any) -> None:
    """Forget all programs where there would be more than ``MOST_PROGRAMS``."""
    key = *binding.capacity, np.shape(binding.diagonal), str(dtype)
    if key not in _kept and len(_kept) >= MOST_PROGRAMS:
        _follow.clear_cache()  # pyright: ignore[reportAttributeAccessIssue]
        _kept.clear()
    _kept.add(key)


def binding_of(skeleton: Any) -> Binding:
    """What ``skeleton`` follows its mesh by."""
    if isinstance(skeleton, Binding):
        return skeleton
    if not isinstance(skeleton, Skeleton):
        raise ConfigError(f"skeleton is a {type(skeleton).__name__}: expected a msf_jax.Skeleton, or its binding")
    return skeleton.binding


def checked_vertices(skeleton: Skeleton | Binding, vertices: Any) -> Any:
    """``vertices`` as (V, 3) for the device, of JAX or of NumPy. What is being traced is checked for its shape only,
    and vertices that are not of the surface of ``skeleton`` may be anywhere."""
    is_plain = isinstance(vertices, np.ndarray) and vertices.dtype.kind in "fiu"
    try:
        array = vertices if is_plain else jnp.asarray(vertices)  # which compiles a copy of NumPy's for every size
    except (TypeError, ValueError) as error:
        raise MeshError(f"vertices is a {type(vertices).__name__}, no table of numbers: expected (V, 3)") from error
    if not jnp.isdtype(array.dtype, ("real floating", "integral")):
        raise MeshError(f"vertices holds {array.dtype}: expected real numbers, (V, 3)")
    is_real = jnp.isdtype(array.dtype, "real floating")
    dtype = jnp.promote_types(array.dtype, jnp.float32) if is_real else real_dtype()
    array = array.astype(jax.dtypes.canonicalize_dtype(dtype))
    binding = binding_of(skeleton)
    if isinstance(skeleton, Binding):
        if array.ndim != 2 or array.shape[1] != 3 or len(array) > binding.num_vertices:
            raise MeshError(
                f"vertices has shape {array.shape}: expected (V, 3), V at most {binding.num_vertices}, for which the "
                "binding has room"
            )
    elif array.shape != (num := len(skeleton.mesh_map), 3):
        raise MeshError(f"vertices has shape {array.shape}: expected ({num}, 3), those of the mesh of the skeleton")
    if isinstance(array, Tracer) or isinstance(binding.faces, Tracer):
        return array
    used = np.zeros(binding.num_vertices, dtype=bool)
    used[np.asarray(binding.faces)] = True
    if used[len(array) :].any():
        raise MeshError(
            f"vertices has shape {array.shape}: expected ({int(binding.live.vertices)}, 3), those of the mesh of the "
            "skeleton"
        )
    bad = np.flatnonzero(~np.isfinite(np.asarray(array)).all(axis=1) & used[: len(array)])
    if len(bad):
        raise MeshError(f"{len(bad)} of the vertices, the first {bad[0]}, are not finite: expected finite positions")
    return array


def _in_dtype(binding: Binding, dtype: Any) -> Binding:
    """``binding`` with its real numbers in ``dtype``, if it holds NumPy arrays: no other type reaches the device."""

    def cast(values: Any) -> Any:
        is_other = isinstance(values, np.ndarray) and values.dtype.kind == "f" and values.dtype != dtype
        return values.astype(dtype) if is_other else values

    return jax.tree.map(cast, binding)
