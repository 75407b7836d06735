"""`follow`: the finished curve of a mesh whose vertices have moved, in pure JAX and without a run; `stack` for many.

Unlike `replay` it depends on no decisions of a run, and averages cross-sections: its derivatives are moderate.
"""

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from jax import export
from jax.core import Tracer

from msf_jax.base.binding import Binding, Sizes, capacity_for, joined, padded, unpadded
from msf_jax.base.errors import ConfigError, MeshError
from msf_jax.device import following
from msf_jax.device.buffers import real_dtype
from msf_jax.device.following import Followed
from msf_jax.skeleton.skeleton import Skeleton

for _tuple in (Binding, Sizes, Followed):  # functions of these can be written by `jax.export`
    export.register_namedtuple_serialization(_tuple, serialized_name=f"msf_jax.{_tuple.__name__}")


@contextmanager
def promoting() -> Iterator[None]:
    """Leaves JAX's strict modes, which the bodies of functions do not need and a caller may have set."""
    with jax.numpy_dtype_promotion("standard"), jax.numpy_rank_promotion("allow"):
        yield


@promoting()
def follow(skeleton: Skeleton | Binding, vertices: Any) -> Followed:
    """The curve of ``skeleton`` for its mesh with moved ``vertices`` (V, 3) and the same faces, without a run.

    Each node is tied to cross-sections of its limb (see `msf_jax.base.binding`), or to its own vertices; pins move with
    theirs. An affine map of the mesh maps the curve by the same map. At the recorded vertices the result is
    ``skeleton.vertices``, to rounding. A mesh with a new limb, or a limb bent through itself, needs a fresh run;
    `msf_jax.track` detects it.

    Works under all transformations of JAX, also for second derivatives. A jitted function of ``skeleton.binding`` is
    compiled once for all skeletons of its capacity. `msf_jax.stack` makes a binding of many meshes.

    Args:
        skeleton: of a run, also after changes of it, or read from an ``.npz`` file. Or its ``binding``, or that of a
            batch: then nodes and radii are padded by rows of zeros; see ``binding.node_mask``.
        vertices: (V, 3), in the order and the units of the mesh of the run. For a binding they have its rows of
            padding, as ``binding.vertices`` has; a binding that is not traced takes them without, too.

    Returns:
        The nodes and radii: exact distances to the moved mesh, negative for a node outside. Signs are right unless the
        moved mesh crosses itself. Both have the floating-point type of ``vertices``, at least float32, and JAX's
        default for whole numbers. Under `jax.jit`, a node whose cross-section has vanished is NaN.

    Differentiable in: vertices, not the binding, with the nearest triangle held fixed. Of several welded vertices the
    first has the whole derivative.

    Raises:
        ConfigError: ``skeleton`` has no source mesh.
        MeshError: ``vertices`` has another shape or is not finite, or the section of a node has vanished.
    """
    binding, array = checked_vertices(skeleton, vertices)
    rows = slice(None if isinstance(skeleton, Binding) else len(skeleton.vertices))
    if any(isinstance(leaf, Tracer) for leaf in jax.tree.leaves((binding, array))):
        nodes, radii = _follow(binding, array)
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
    """Nodes and radii with rows of padding, NaN where a section has vanished, computed where ``vertices`` are."""
    return tuple(jax.device_get(_follow(*jax.device_put((binding, vertices), _device_of(vertices)))))


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


def checked_vertices(skeleton: Skeleton | Binding, vertices: Any) -> tuple[Binding, Any]:
    """The binding of ``skeleton``, and ``vertices`` (V, 3) as an array with its rows of padding. Numbers are checked if
    they are not traced. Vertices that no face uses may be at any position."""
    binding, array = binding_of(skeleton), numbers_of("vertices", vertices, MeshError)
    is_whole = jnp.isdtype(array.dtype, "integral")
    wide = real_dtype() if is_whole else jnp.promote_types(array.dtype, jnp.float32)
    array = array.astype(jax.dtypes.canonicalize_dtype(wide))
    rows = {len(skeleton.mesh_map) if isinstance(skeleton, Skeleton) else binding.capacity.vertices}
    if isinstance(skeleton, Binding) and not isinstance(binding.faces, Tracer):  # padding may be left out
        rows.add(int(np.asarray(binding.live.vertices).sum()))
    if array.ndim != 2 or array.shape[1] != 3 or len(array) not in rows:
        padding = " and its padding, as binding.vertices has it" if isinstance(skeleton, Binding) else ""
        raise MeshError(
            f"vertices has shape {array.shape}: expected ({' or '.join(map(str, sorted(rows)))}, 3), as in the mesh of "
            f"the skeleton{padding}"
        )
    more = (0, binding.capacity.vertices - len(array)), (0, 0)
    if isinstance(array, Tracer) or isinstance(binding.faces, Tracer):
        return binding, jnp.pad(array, more)
    is_used = np.zeros(len(array), dtype=bool)
    is_used[np.asarray(binding.faces)] = True
    check_finite(array, is_used)
    padded, device = np.pad(jax.device_get(array), more), _device_of(array)  # JAX would compile this for every size
    return binding, padded if device is None else jax.device_put(padded, device)


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


def stack(skeletons: Iterable[Skeleton | Binding]) -> Binding:
    """The curves of B meshes of any sizes as one binding: ``batch = stack(skeletons)``, ``follow(batch, vertices)``.

    As graph libraries batch, rows of all meshes follow each other, in ``batch.vertices``, in the nodes and the radii.
    ``batch.mesh_of("nodes")`` has the mesh of each row, ``batch.split(found.nodes)`` the nodes mesh by mesh. Padding is
    at the end: there nodes, radii and gradients are zero. ``stack(others).like(batch)`` has the capacity of ``batch``,
    whose compiled programs serve it.

    A `ConfigError` is raised if ``skeletons``, which may be bindings, are none, or one has no source mesh.
    """
    every = list(skeletons) if isinstance(skeletons, Iterable) and not isinstance(skeletons, Binding) else []
    if not every or not all(isinstance(each, Skeleton | Binding) for each in every):
        kinds = ", ".join(sorted({type(each).__name__ for each in every})) or "nothing"
        raise ConfigError(
            f"skeletons is a {type(skeletons).__name__} of {kinds}: expected a list of at least one msf_jax.Skeleton"
        )
    together = joined([unpadded(binding_of(each)) for each in every])
    return jax.tree.map(jnp.asarray, padded(together, capacity_for(together.live), jnp.asarray))
