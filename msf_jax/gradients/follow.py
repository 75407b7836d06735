"""`follow`: the finished curve of a mesh whose vertices have moved, in pure JAX and without a run.

Unlike `replay` it has no decisions in it: sections of limbs are averaged, which is tame. See `msf_jax.base.recipe`.
"""

from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
from jax.core import Tracer

from msf_jax.base.errors import ConfigError, MeshError
from msf_jax.base.recipe import Recipe
from msf_jax.device import following
from msf_jax.device.buffers import real_dtype
from msf_jax.skeleton.skeleton import Skeleton


class Followed(NamedTuple):
    """nodes: (N, 3), in the mesh's units. radii: (N,) signed distance to the surface, negative for a node outside."""

    nodes: jax.Array
    radii: jax.Array

    def __repr__(self) -> str:
        parts = (f"{name} {part.dtype}{list(part.shape)}" for name, part in self._asdict().items())
        return f"Followed({', '.join(parts)})"


def follow(skeleton: Skeleton, vertices: Any) -> Followed:
    """The ``skeleton`` in its mesh as it is with its vertices at ``vertices`` (V, 3): the same faces, no run.

    Every node keeps to the cross-sections of its limb, which are recorded as fractions of mesh edges and move with
    them; what it is off their middle turns and stretches with the limb. Junctions and bare ends are carried by the
    sections next to them, pins by their vertices. An affine map of the mesh maps the curve along. Where the vertices
    were recorded this is ``skeleton.vertices``, to rounding. It is for meshes of the same limbs: a new limb, or one
    that is bent through itself, wants a fresh run; `msf_jax.track` says when.

    Works under `jax.jit`, `grad`, `vmap`, `jacfwd` and `jacrev`. The first call for a skeleton records its sections,
    in well under a second.

    Args:
        skeleton: of a run, also after `Skeleton.prune`, `resample` and `smooth`, or read from an ``.npz`` file.
        vertices: (V, 3), in the order of the mesh that the run was given, and in its units.

    Returns:
        The nodes, and the distance of each to the surface: of the triangles that were within twice its radius, in each
        of 150 directions the nearest. Under `jax.jit`, a node whose own section has vanished is NaN.

    Differentiable in: vertices.

    Raises:
        ConfigError: ``skeleton`` does not know the mesh that it was made from.
        MeshError: ``vertices`` has another shape or is not finite, or a section has vanished: whose.
    """
    recipe = recipe_of(skeleton)
    array = checked_vertices(skeleton, vertices)
    found = Followed(*_follow(recipe, array))
    if not isinstance(array, Tracer):
        gone = np.flatnonzero(np.isnan(np.asarray(found.nodes)).any(axis=1))
        if len(gone):
            raise MeshError(
                f"{len(gone)} of the nodes, the first {gone[0]}, have no section around them any more: expected a mesh "
                "with the same limbs; run skeletonize on this one"
            )
    return found


_follow = jax.jit(following.follow)


def recipe_of(skeleton: Any) -> Recipe:
    """What ``skeleton`` follows its mesh by."""
    if not isinstance(skeleton, Skeleton):
        raise ConfigError(f"skeleton is a {type(skeleton).__name__}: expected a msf_jax.Skeleton")
    return skeleton.recipe


def checked_vertices(skeleton: Skeleton, vertices: Any) -> jax.Array:
    """``vertices`` as (V, 3) for the device. What is being traced is checked for its shape only, and vertices that are
    not of the surface of ``skeleton`` may be anywhere."""
    num = len(skeleton.mesh_map)
    try:
        array = jnp.asarray(vertices)
    except (TypeError, ValueError) as error:
        raise MeshError(f"vertices is a {type(vertices).__name__}, no table of numbers: expected (V, 3)") from error
    if not jnp.isdtype(array.dtype, ("real floating", "integral")):
        raise MeshError(f"vertices holds {array.dtype}: expected real numbers, (V, 3)")
    array = array.astype(real_dtype())
    if array.shape != (num, 3):
        raise MeshError(f"vertices has shape {array.shape}: expected ({num}, 3), those of the mesh of the skeleton")
    if not isinstance(array, Tracer):
        used = skeleton.surface.vertex
        bad = np.unique(used[~np.isfinite(np.asarray(array)[used]).all(axis=1)])
        if len(bad):
            raise MeshError(
                f"{len(bad)} of the vertices, the first {bad[0]}, are not finite: expected finite positions"
            )
    return array
