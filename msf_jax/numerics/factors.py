"""Sparse factors of matrices over a surface, and a preconditioner for very ill-conditioned systems made of one.

The preconditioner is a factor of the square root of the normal equations. The normal operator A^T A + D with
A = beta L (see `device.contraction`) and D = shift is nearly the square of

    K = D^(1/2) - A,    K^T K = A^T A + D - (D^(1/2) A + A^T D^(1/2)).

|K x|^2 is at most twice x^T (A^T A + D) x, for any A. If D is constant, and A symmetric and negative, as a cotangent
Laplacian is, |K x|^2 is at least x^T (A^T A + D) x. Then the eigenvalues of (K^T K)^-1 (A^T A + D) are between 1/2 and
1, however large w_L is. For varying D the largest was at most ten in experiments. K is as sparse as L.
"""

from collections.abc import Callable

import numpy as np
from scipy import sparse
from scipy.sparse import linalg

from msf_jax.base.layout import Layout


def surface_factor(matrix: sparse.csc_matrix | sparse.csc_array) -> linalg.SuperLU:
    """The factors of a ``matrix`` (V, V) with the pattern of a surface's edges, and a diagonal that can be divided by,
    as that of a positive definite matrix."""
    # relax=1: SuperLU joins no columns of unlike patterns. Joined, those of a round solid took up to 20 times as long.
    return linalg.splu(
        matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, relax=1, options={"SymmetricMode": True}
    )


def factored(
    neighbour: np.ndarray, out: np.ndarray, own: np.ndarray, shift: np.ndarray, free: np.ndarray, layout: Layout
) -> Callable[[np.ndarray], np.ndarray]:
    """The function r (n, c) -> (K^T K)^-1 r on the rows of ``free`` (n,), and r -> r on the others.

    neighbour, out: (S,) A's off-diagonal entries in the slots of ``layout``. own: (n,) A's diagonal. shift: (n,). If a
    number is not finite, the function is r -> r on all rows, and the solve reports the fault.
    """
    if not all(np.isfinite(values).all() for values in (out, own, shift)):
        return lambda r: r
    is_free = free > 0
    row = np.concatenate([np.arange(level.rows) for level in layout.levels for _ in range(level.slots)])
    is_entry = (out != 0) & is_free[row] & is_free[neighbour]
    live = np.flatnonzero(is_free)
    rank = np.cumsum(is_free) - 1
    ends = rank[row[is_entry]], rank[neighbour[is_entry]]
    diagonal = sparse.diags(np.sqrt(shift[live]) - own[live])
    K = diagonal - sparse.coo_matrix((out[is_entry], ends), shape=(len(live), len(live)))
    factor = surface_factor(K.tocsc())

    def apply(r: np.ndarray) -> np.ndarray:
        found = np.array(r)
        found[live] = factor.solve(factor.solve(np.ascontiguousarray(found[live]), "T"))
        return found

    return apply
