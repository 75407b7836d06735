"""The derivative of the nodes with respect to the mesh's vertices, as a sparse matrix, and covariances under noise.

It differentiates the equation of `msf_jax.base.binding` at the recorded mesh. No two cross-sections share a corner, so
three products with the transpose give the derivatives of all centroids.
"""

from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from scipy import sparse

from msf_jax.base.binding import Binding, unpadded
from msf_jax.base.errors import ConfigError
from msf_jax.device import following
from msf_jax.device.buffers import real_dtype


def jacobian(padded: Binding, vertices: np.ndarray) -> sparse.csr_matrix:
    """(3 N, 3 V) d nodes / d ``vertices`` (V, 3)."""
    binding = unpadded(padded)
    num, num_sections, many = len(binding.rest), len(binding.node), len(vertices)
    entered = np.pad((vertices - binding.centre) / binding.unit, ((0, padded.num_vertices - many), (0, 0)))
    slopes = np.asarray(_slopes(padded, entered.astype(real_dtype())), dtype=np.float64)  # axis, corner, axis
    corner = np.arange(len(binding.section))
    slopes = slopes[:, : len(corner)]
    ends: Any = sparse.coo_matrix(
        (np.r_[1 - binding.part, binding.part], (np.tile(corner, 2), np.r_[binding.tail, binding.head])),
        shape=(len(corner), many),
    ).tocsr()
    a: Any = sparse.csr_matrix((binding.a_value, (binding.a_row, binding.a_column)), shape=(num, num_sections))
    b: Any = sparse.csr_matrix((binding.b_value, (binding.b_row, binding.b_column)), shape=(num, many))
    rows = []
    for i in range(3):
        by_axis = []
        for j in range(3):
            at = binding.section, corner
            centroid = sparse.csr_matrix((slopes[i, :, j], at), shape=(num_sections, len(corner)))
            block: Any = a @ (centroid @ ends)
            by_axis.append((block + b if i == j else block).tocoo())
        rows.append(by_axis)
    row = np.concatenate([3 * block.row + i for i in range(3) for block in rows[i]])
    column = np.concatenate([3 * rows[i][j].col + j for i in range(3) for j in range(3)])
    value = np.concatenate([block.data for by_axis in rows for block in by_axis])
    return sparse.csr_matrix((value, (row, column)), shape=(3 * num, 3 * many))


@jax.jit
def _slopes(binding: Binding, entered: jax.Array) -> jax.Array:
    """(3, C, 3): derivative of a centroid along axis i with respect to each corner of its section along axis j."""
    place = following.corners(binding, entered)
    pull_back = jax.vjp(lambda corners: following.centroids(binding, corners).centroid, place)[1]
    return jax.vmap(lambda axis: pull_back(jnp.zeros((len(binding.node), 3), place.dtype).at[:, axis].set(1.0))[0])(
        jnp.arange(3)
    )


def spread_of(sigma: Any, num: int) -> np.ndarray:
    """(num,) standard deviations from a number, or from an array; a ConfigError for anything else."""
    try:
        spread = np.asarray(sigma, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise ConfigError(f"sigma is a {type(sigma).__name__}: expected a number, or one for each vertex") from error
    if spread.shape not in ((), (num,)):
        raise ConfigError(f"sigma has shape {spread.shape}: expected a number, or ({num},), one for each vertex")
    if not (np.isfinite(spread) & (spread >= 0)).all():
        raise ConfigError("sigma has values that are negative or not finite: expected lengths of 0 or more")
    return np.broadcast_to(spread, num)


def covariance(slopes: Any, sigma: np.ndarray) -> np.ndarray:
    """(N, 3, 3) diagonal blocks of J diag(sigma^2) J^T, one for each node, for noise of ``sigma`` (V,) on each axis."""
    by_axis: list[Any] = [slopes[axis::3] for axis in range(3)]
    variance = np.repeat(sigma**2, 3)
    found = np.empty((slopes.shape[0] // 3, 3, 3))
    for i in range(3):
        for j in range(i + 1):
            found[:, i, j] = found[:, j, i] = by_axis[i].multiply(by_axis[j]) @ variance
    return found
