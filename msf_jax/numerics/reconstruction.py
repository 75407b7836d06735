"""Spectral reconstruction: the surface without its small details, V' = Phi Phi^T V (article 3.1.1).

Phi has the eigenvectors of the k smallest eigenvalues of the symmetric uniform graph Laplacian L = D - A. A filter that
is not exact does without them: Phi Phi^T is the function of L that is 1 up to the k-th eigenvalue and 0 above, and is
replaced by a polynomial p(L) with a smooth step, in a twentieth of the time or less (Chebyshev filtering; Hammond et
al. 2011, Di Napoli et al. 2016).
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from scipy import fft, sparse, special
from scipy.sparse import linalg

from msf_jax.numerics.factors import surface_factor
from msf_jax.topology import graphs

SHIFT = -1e-4  # eigenvalue: the shift of shift-invert, slightly below 0 because D - A is singular

SOFTNESS = 0.15  # width of the filter's step, as a share of the wave number there
PROBES = 8  # random vectors that count eigenvalues, to 3.5 % for 200 eigenvalues, 10 % for 30
MOST_TERMS = 3000  # terms of the polynomial; if it needs more, as on a long thin mesh, eigenvectors are computed


def graph_laplacian(faces: np.ndarray, num_vertices: int) -> sparse.csc_matrix:
    """The uniform graph Laplacian D - A (V, V) of the triangles' edges."""
    a, b = faces.ravel(), faces[:, [1, 2, 0]].ravel()
    once = graphs.weighted(num_vertices, a, b)
    adjacency = (once + once.T).sign()
    degree = np.asarray(adjacency.sum(axis=1)).ravel()
    return sparse.csc_matrix(sparse.diags(degree) - adjacency)


def spectral_basis(faces: np.ndarray, num_vertices: int, k: int) -> np.ndarray:
    """Orthonormal eigenvectors (V, k) of the ``k`` smallest eigenvalues of the graph Laplacian; dense for a k of V / 3
    or more, where the iterative solver is no faster, and cannot return all of the vectors."""
    laplacian = graph_laplacian(faces, num_vertices)
    if 3 * k >= num_vertices:
        return np.linalg.eigh(laplacian.toarray())[1][:, :k]
    factor = surface_factor(laplacian - SHIFT * sparse.identity(num_vertices, format="csc"))
    inverse = linalg.LinearOperator(laplacian.shape, matvec=factor.solve, dtype=np.float64)  # pyright: ignore
    start = np.cos(np.arange(num_vertices))  # a fixed vector, for the same bits on every run; it is no eigenvector
    return linalg.eigsh(laplacian, k=k, sigma=SHIFT, OPinv=inverse, v0=start)[1]


class LowPass(NamedTuple):
    """A low-pass filter of coordinates, a linear map: Phi Phi^T, or a polynomial of the graph Laplacian L.

    basis: (V, k) Phi, or None for the polynomial, the sum over j of share_j T_j(1 - 2 L / top).
    """

    basis: np.ndarray | None
    share: np.ndarray
    top: float


def low_pass(faces: np.ndarray, num_vertices: int, k: int, *, exact: bool) -> LowPass | None:
    """The filter that keeps ``k`` eigenvectors, exactly or about, see ``exact``; None if ``k`` is V or more.

    With cos(theta) = 1 - 2 L / top, the polynomial is erfc((theta - edge) / width) / 2, scaled to be 1 at 0, so that
    constants are kept.
    """
    if k >= num_vertices:
        return None
    if not exact:
        laplacian = graph_laplacian(faces, num_vertices)
        degree = laplacian.diagonal()
        tail, head = laplacian.nonzero()
        # An upper bound of the eigenvalues (Anderson, Morley 1985).
        top = float((degree[tail] + degree[head])[tail != head].max())
        # Weyl's law: of equal triangles with n vertices, the k-th eigenvalue is about 4 sqrt(3) pi k / n = 21.8 k / n.
        edge = _edge_of(_cosine(laplacian, top), k, guess=np.sqrt(4 * 21.8 * k / num_vertices / top))
        width = SOFTNESS * edge
        num_terms = int(np.ceil(6 / width))  # the truncated terms are below exp(-9)
        if num_terms <= MOST_TERMS:
            theta = (np.arange(4 * num_terms) + 0.5) * np.pi / (4 * num_terms)
            share = np.asarray(fft.dct(special.erfc((theta - edge) / width), type=2))[:num_terms]
            share[0] /= 2
            return LowPass(None, share / share.sum(), top)
    return LowPass(spectral_basis(faces, num_vertices, k), np.empty(0), 0.0)


def apply(kept: LowPass | None, vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Vertex positions (V, 3) after the filter ``kept``; a copy for None."""
    if kept is None:
        return np.array(vertices, dtype=np.float64)
    if kept.basis is not None:
        return kept.basis @ (kept.basis.T @ vertices)
    total = np.zeros(vertices.shape)
    cosine = _cosine(graph_laplacian(faces, len(vertices)), kept.top)
    for term, share in zip(_chebyshev(cosine, vertices, len(kept.share)), kept.share, strict=True):
        total += share * term
    return total


def reconstruct(vertices: np.ndarray, faces: np.ndarray, k: int) -> np.ndarray:
    """Vertex positions (V, 3) of the mesh rebuilt from ``k`` eigenvectors; ``k`` of V or more returns a copy."""
    return apply(low_pass(faces, len(vertices), k, exact=True), vertices, faces)


def _cosine(laplacian: sparse.csc_matrix, top: float) -> sparse.csr_matrix:
    return sparse.csr_matrix(sparse.identity(laplacian.indptr.size - 1) - 2 / top * laplacian)


def _chebyshev(matrix: sparse.csr_matrix, start: np.ndarray, num: int) -> Iterator[np.ndarray]:
    """T_0(A) x, T_1(A) x, ... , by T_j = 2 A T_{j-1} - T_{j-2}."""
    before, now, twice = np.asarray(matrix @ start), start, 2 * matrix  # T_{-1} = T_1
    for _ in range(num):
        yield now
        before, now = now, twice @ now - before


def _edge_of(cosine: sparse.csr_matrix, k: int, guess: float) -> float:
    """The theta below which ``k`` eigenvalues of the Laplacian lie, about ``guess`` (Weyl's law for a regular mesh).

    The number of eigenvalues below an edge is the trace of a step function, whose Chebyshev coefficients are known in
    closed form. The trace of T_j is estimated by the mean of <r, T_j r> over random signs r (kernel polynomial method;
    Weisse et al. 2006). Half of the products suffice: <T_i r, T_j r> is half the sum of the moments i + j and i - j.
    """
    num = cosine.indptr.size - 1
    signs = np.random.default_rng(0).choice([-1.0, 1.0], (num, PROBES))
    half = int(np.clip(8 / guess, 32, 400))
    moments = np.empty(2 * half)
    last = signs
    for j, term in enumerate(_chebyshev(cosine, signs, half + 1)):
        if j:
            moments[2 * j - 1] = 2 * (term * last).sum() - moments[1] if j > 1 else (term * last).sum()
        if j < half:
            moments[2 * j] = 2 * (term * term).sum() - moments[0] if j else (term * term).sum()
        last = term
    order = np.arange(1, 2 * half)
    # Jackson's damping factors keep the polynomial between 0 and 1.
    step = np.pi / (2 * half + 1)
    damping = ((2 * half + 1 - order) * np.cos(order * step) + np.sin(order * step) / np.tan(step)) / (2 * half + 1)
    edges = np.linspace(0, np.pi, 8 * half + 1)
    series = np.sin(np.outer(edges, order)) @ (damping * moments[1:] / order)
    count = (edges * moments[0] + 2 * series) / np.pi / PROBES
    return float(edges[1:][np.maximum.accumulate(count)[1:] >= k][0])
