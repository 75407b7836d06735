"""Spectral reconstruction: the surface without its small details, V' = Phi Phi^T V (article 3.1.1).

Phi holds the eigenvectors of the k smallest eigenvalues of the uniform graph Laplacian D - A, which is symmetric, so a
symmetric solver with shift-invert returns them orthonormal (DESIGN "Spectral reconstruction").
"""

import numpy as np
from scipy import sparse
from scipy.sparse import linalg

# Shift-invert needs a matrix that can be factorised: D - A is singular, so the shift lies a little below zero.
SHIFT = -1e-4


def graph_laplacian(faces: np.ndarray, num_vertices: int) -> sparse.csc_matrix:
    """The uniform graph Laplacian D - A (V, V) of the triangles' edges."""
    a, b = faces.ravel(), faces[:, [1, 2, 0]].ravel()
    once = sparse.coo_matrix((np.ones(len(a)), (a, b)), shape=(num_vertices, num_vertices)).tocsr()
    adjacency = (once + once.T).sign()
    degree = np.asarray(adjacency.sum(axis=1)).ravel()
    return sparse.csc_matrix(sparse.diags(degree) - adjacency)


class _Inverse:
    """A factorised matrix's inverse, as SciPy's `aslinearoperator` takes it."""

    def __init__(self, factor: linalg.SuperLU, size: int):
        self.matvec = factor.solve
        self.shape = (size, size)
        self.dtype = np.dtype(np.float64)


def spectral_basis(faces: np.ndarray, num_vertices: int, k: int) -> np.ndarray:
    """Orthonormal eigenvectors (V, k) of the ``k`` smallest eigenvalues of the graph Laplacian.

    Small meshes (k of V / 3 or more) are decomposed densely: the iterative solver is no faster there, and cannot
    return all of the vectors.
    """
    laplacian = graph_laplacian(faces, num_vertices)
    if 3 * k >= num_vertices:
        return np.linalg.eigh(laplacian.toarray())[1][:, :k]
    factor = linalg.splu(
        laplacian - SHIFT * sparse.identity(num_vertices, format="csc"),
        permc_spec="MMD_AT_PLUS_A",
        diag_pivot_thresh=0.0,
        options={"SymmetricMode": True},
    )
    inverse = linalg.aslinearoperator(_Inverse(factor, num_vertices))
    start = np.cos(np.arange(num_vertices))  # any fixed vector that is not an eigenvector: the same bits on every run
    return linalg.eigsh(laplacian, k=k, sigma=SHIFT, OPinv=inverse, v0=start)[1]


def project(vertices: np.ndarray, basis: np.ndarray) -> np.ndarray:
    """V' = Phi Phi^T V (V, 3)."""
    return basis @ (basis.T @ vertices)


def reconstruct(vertices: np.ndarray, faces: np.ndarray, k: int) -> np.ndarray:
    """Vertex positions (V, 3) of the mesh rebuilt from ``k`` eigenvectors; ``k`` of V or more returns a copy."""
    if k >= len(vertices):
        return np.array(vertices, dtype=np.float64)
    return project(vertices, spectral_basis(faces, len(vertices), k))
