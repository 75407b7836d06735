"""How far the nodes of a curve move with the vertices of its mesh, as a sparse matrix, and what noise makes of them.

The derivative of the equation of `msf_jax.base.recipe` at the mesh as it was recorded. No two sections share a corner,
so that three products with the transpose give the derivatives of all centroids.
"""

from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from scipy import sparse

from msf_jax.base.errors import ConfigError
from msf_jax.base.recipe import Recipe
from msf_jax.device import following
from msf_jax.device.buffers import real_dtype


def jacobian(recipe: Recipe, vertices: np.ndarray) -> sparse.csr_matrix:
    """(3 N, 3 V) d nodes / d ``vertices`` (V, 3)."""
    num, num_sections, many = len(recipe.rest), len(recipe.node), len(vertices)
    entered = jnp.asarray((vertices - recipe.centre) / recipe.diagonal, real_dtype())
    slopes = np.asarray(_slopes(recipe, following.corners(recipe, entered)), dtype=np.float64)  # axis, corner, axis
    corner = np.arange(len(recipe.section))
    ends: Any = sparse.coo_matrix(
        (np.r_[1 - recipe.part, recipe.part], (np.tile(corner, 2), np.r_[recipe.tail, recipe.head])),
        shape=(len(corner), many),
    ).tocsr()
    a: Any = sparse.csr_matrix((recipe.a_value, (recipe.a_row, recipe.a_column)), shape=(num, num_sections))
    b: Any = sparse.csr_matrix((recipe.b_value, (recipe.b_row, recipe.b_column)), shape=(num, many))
    rows = []
    for i in range(3):
        by_axis = []
        for j in range(3):
            centroid = sparse.csr_matrix((slopes[i, :, j], (recipe.section, corner)), shape=(num_sections, len(corner)))
            block: Any = a @ (centroid @ ends)
            by_axis.append((block + b if i == j else block).tocoo())
        rows.append(by_axis)
    row = np.concatenate([3 * block.row + i for i in range(3) for block in rows[i]])
    column = np.concatenate([3 * rows[i][j].col + j for i in range(3) for j in range(3)])
    value = np.concatenate([block.data for by_axis in rows for block in by_axis])
    return sparse.csr_matrix((value, (row, column)), shape=(3 * num, 3 * many))


@jax.jit
def _slopes(recipe: Recipe, place: jax.Array) -> jax.Array:
    """(3, C, 3): how far along axis i the centroid of its section moves with each corner along axis j."""
    pull_back = jax.vjp(lambda corners: following.centroids(recipe, corners).centroid, place)[1]
    return jax.vmap(lambda axis: pull_back(jnp.zeros((len(recipe.node), 3), place.dtype).at[:, axis].set(1.0))[0])(
        jnp.arange(3)
    )


def spread_of(sigma: Any, num: int) -> np.ndarray:
    """(num,) standard deviations from a number, or from one for each vertex; a ConfigError for anything else."""
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
    """(N, 3, 3) of every node, J diag(sigma^2) J^T by blocks, for noise of ``sigma`` (V,) along each axis."""
    by_axis: list[Any] = [slopes[axis::3] for axis in range(3)]
    variance = np.repeat(sigma**2, 3)
    found = np.empty((slopes.shape[0] // 3, 3, 3))
    for i in range(3):
        for j in range(i + 1):
            found[:, i, j] = found[:, j, i] = by_axis[i].multiply(by_axis[j]) @ variance
    return found
