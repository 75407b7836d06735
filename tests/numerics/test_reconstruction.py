"""The spectral reconstruction of a surface, and the filter in its place: against a dense projection."""

import numpy as np
import pytest
import trimesh
from conftest import blob, torus

from msf_jax.numerics import reconstruction


def arrays(mesh: trimesh.Trimesh) -> tuple[np.ndarray, np.ndarray]:
    """Plain arrays of a Trimesh."""
    return np.array(mesh.vertices), np.array(mesh.faces)


def dense_laplacian(faces: np.ndarray, num_vertices: int) -> np.ndarray:
    """D - A, one entry at a time."""
    laplacian = np.zeros((num_vertices, num_vertices))
    for a, b in {tuple(sorted(pair)) for face in faces.tolist() for pair in (face[:2], face[1:], face[::2])}:
        laplacian[[a, b], [a, b]] += 1
        laplacian[[a, b], [b, a]] -= 1
    return laplacian


def uneven(seed: int) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """A sphere meshed without symmetry, so that eigenvalues are apart: vertices, faces, eigenvalues, eigenvectors."""
    points = np.random.default_rng(seed).normal(size=(220, 3))
    mesh = trimesh.convex.convex_hull(points / np.linalg.norm(points, axis=1)[:, None])
    vertices, faces = arrays(mesh)
    vertices = vertices * [3, 1, 1] + 0.1 * np.sin(7 * vertices[:, [1, 2, 0]])
    return vertices, faces, *np.linalg.eigh(dense_laplacian(faces, len(vertices)))


@pytest.mark.parametrize(("low", "high"), [(4, 12), (20, 60), (90, 130)])
def test_reconstruction_equals_the_dense_projection(low, high):
    """At the widest gap between eigenvalues in a range, where the subspace is well defined."""
    vertices, faces, values, vectors = uneven(3)
    k = low + int(np.argmax(np.diff(values)[low - 1 : high - 1]))
    assert values[k] - values[k - 1] > 1e-3
    basis = vectors[:, :k]
    expected = basis @ (basis.T @ vertices)
    assert np.abs(expected - vertices).max() > 1e-2
    np.testing.assert_allclose(reconstruction.reconstruct(vertices, faces, k), expected, atol=1e-8)


@pytest.mark.parametrize("k", [20, 100])
def test_reconstruction_is_a_linear_projection(k):
    """Twice is once; sums and multiples pass through; a constant shift, the first eigenvector, is kept."""
    vertices, faces, values, _ = uneven(5)
    k += int(np.argmax(np.diff(values)[k - 1 : k + 9]))
    other = np.random.default_rng(6).normal(size=vertices.shape)

    def rebuilt(x):
        return reconstruction.reconstruct(x, faces, k)

    once = rebuilt(vertices)
    np.testing.assert_allclose(rebuilt(once), once, atol=1e-9)
    np.testing.assert_allclose(rebuilt(2 * vertices - 3 * other), 2 * once - 3 * rebuilt(other), atol=1e-9)
    np.testing.assert_allclose(rebuilt(vertices + np.array([1, 2, 3])), once + np.array([1, 2, 3]), atol=1e-9)
    assert np.linalg.norm(once - vertices) < np.linalg.norm(vertices - vertices.mean(axis=0))
    # What is lost is orthogonal to what is kept.
    np.testing.assert_allclose(once.T @ (vertices - once), 0, atol=1e-8)


@pytest.mark.parametrize(
    ("name", "k"),
    [
        ("tube", 150),
        *(pytest.param(*each, marks=pytest.mark.slow) for each in (("torus", 60), ("blob", 150))),
    ],
)
def test_the_filter_keeps_about_k_eigenvectors_and_loses_the_others(name, k):
    """Against dense eigenvectors: 1 well below the k-th wave number, 0 well above, and a trace of about k."""
    mesh = {
        "torus": lambda: torus(around=60, across=20),
        "blob": lambda: blob(3),
        "tube": lambda: torus(3.0, 0.1, around=200, across=5),  # long triangles, all waves along it
    }[name]()
    num = len(mesh.vertices)
    laplacian = reconstruction.graph_laplacian(mesh.faces, num).toarray()
    values, vectors = np.linalg.eigh(laplacian)
    matrix = reconstruction.apply(reconstruction.low_pass(mesh.faces, num, k, exact=False), np.eye(num), mesh.faces)
    np.testing.assert_allclose(matrix, matrix.T, atol=1e-10)
    response = (vectors * (matrix @ vectors)).sum(axis=0)
    assert np.abs(matrix @ vectors - vectors * response).max() < 1e-8  # it has the Laplacian's own eigenvectors
    assert abs(response.sum() - k) < 0.15 * k
    wave = np.sqrt(np.maximum(values, 0))
    edge = wave[k - 1]
    assert response[wave < 0.65 * edge].min() > 0.95
    assert np.abs(response[wave > 1.45 * edge]).max(initial=0) < 0.05
    assert response.min() > -1e-3 and response.max() < 1 + 1e-3
