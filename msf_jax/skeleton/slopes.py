"""The curve as a function of the mesh's vertices, its derivative as a sparse matrix, and covariances under noise.

The derivative is that of the equation of `msf_jax.base.binding` at the recorded mesh. No two cross-sections share a
corner, so three products with the transpose give the derivatives of all centroids.
"""

from typing import TYPE_CHECKING, Any

import jax
import jax.numpy as jnp
import numpy as np
from scipy import sparse

from msf_jax.base import binding as bindings
from msf_jax.base.binding import Binding
from msf_jax.base.errors import ConfigError
from msf_jax.device import following
from msf_jax.device.buffers import real_dtype
from msf_jax.recording.following import record

if TYPE_CHECKING:
    from msf_jax.skeleton.skeleton import Skeleton


def binding_of(skeleton: "Skeleton") -> Binding:
    """See `Skeleton.binding`."""
    surface = skeleton.bound_surface
    pins = np.asarray(skeleton.source.pins if skeleton.source else [], dtype=np.int64)
    pinned = skeleton.mesh_map[pins]
    pins_of_node = {int(node): pins[pinned == node] for node in np.unique(pinned)}
    binding = record(surface, len(skeleton.mesh_map), skeleton.vertices, skeleton.edges, pins_of_node)
    return bindings.padded(binding, bindings.capacity_for(binding.live))


def jacobian(skeleton: "Skeleton") -> sparse.csr_matrix:
    """See `Skeleton.jacobian`."""
    padded = skeleton.binding
    binding = bindings.unpadded(padded)
    num, num_sections, many = len(binding.rest), len(binding.node), len(binding.vertices)
    entered = (padded.vertices - padded.centre) / padded.unit
    slopes = np.asarray(_slopes(padded, entered.astype(real_dtype())), dtype=np.float64)  # axis, corner, axis
    corner = np.arange(len(binding.section))
    ends: Any = sparse.coo_matrix(
        (np.r_[1 - binding.part, binding.part], (np.tile(corner, 2), np.r_[binding.tail, binding.head])),
        shape=(len(corner), many),
    ).tocsr()
    a: Any = sparse.csr_matrix((binding.a_value, (binding.a_row, binding.a_column)), shape=(num, num_sections))
    b: Any = sparse.csr_matrix((binding.b_value, (binding.b_row, binding.b_column)), shape=(num, many))
    total: Any = sparse.kron(b, sparse.eye_array(3), format="csr")
    for i, j in np.ndindex(3, 3):
        of_corners = slopes[i, : len(corner), j], (binding.section, corner)
        centroid = sparse.csr_matrix(of_corners, shape=(num_sections, len(corner)))
        axes = sparse.csr_matrix(([1.0], ([i], [j])), shape=(3, 3))
        total = total + sparse.kron(a @ (centroid @ ends), axes, format="csr")
    return sparse.csr_matrix(total)


@jax.jit
def _slopes(binding: Binding, entered: jax.Array) -> jax.Array:
    """(3, C, 3): derivative of a centroid along axis i with respect to each corner of its section along axis j."""
    place = following.corners(binding, entered)
    pull_back = jax.vjp(lambda corners: following.centroids(binding, corners)[0], place)[1]
    return jax.vmap(lambda axis: pull_back(jnp.zeros((len(binding.node), 3), place.dtype).at[:, axis].set(1.0))[0])(
        jnp.arange(3)
    )


def covariance(skeleton: "Skeleton", sigma: Any) -> np.ndarray:
    """See `Skeleton.covariance`: the diagonal blocks of J diag(sigma^2) J^T."""
    num = len(skeleton.mesh_map)
    spread = np.asarray(sigma, dtype=np.float64)
    if spread.shape not in ((), (num,)):
        raise ConfigError(f"sigma has shape {spread.shape}: expected a number, or ({num},), one for each vertex")
    if not (np.isfinite(spread) & (spread >= 0)).all():
        raise ConfigError("sigma has values that are negative or not finite: expected lengths of 0 or more")
    slopes: Any = skeleton.jacobian()
    by_axis = [slopes[axis::3] for axis in range(3)]
    variance = np.repeat(np.broadcast_to(spread, num) ** 2, 3)
    blocks = np.empty((len(skeleton.vertices), 3, 3))
    for i in range(3):
        for j in range(i + 1):
            blocks[:, i, j] = blocks[:, j, i] = by_axis[i].multiply(by_axis[j]) @ variance
    return blocks
