"""The article's preprocessing for a user's mesh: poles and the filtered surface, in the caller's units."""

import numpy as np
import pytest
import trimesh
from conftest import blob, torus

from msf_jax import preprocessing
from msf_jax.base.errors import ConfigError
from msf_jax.inside import balls


def arrays(mesh: trimesh.Trimesh) -> tuple[np.ndarray, np.ndarray]:
    """Plain arrays of a Trimesh."""
    return np.array(mesh.vertices), np.array(mesh.faces)


SHAPES = {"blob": lambda: blob(11), "slab": lambda: jittered(torus(), [3.0, 1, 0.3]), "torus": torus}


def jittered(mesh: trimesh.Trimesh, scale) -> trimesh.Trimesh:
    """The mesh scaled, and shaken out of general symmetry."""
    noise = 1e-3 * np.random.default_rng(4).normal(size=mesh.vertices.shape)
    return trimesh.Trimesh((mesh.vertices + noise) * scale, mesh.faces, process=False)


def test_the_public_call_gives_one_pole_a_vertex_in_the_callers_units():
    """Two spheres far from the origin: each one's poles are at its own centre; the input stays as it is."""
    centres = np.array([[100.0, 0, 0], [0, 50, 0]])
    parts = [trimesh.creation.icosphere(3, radius=r).apply_translation(c) for r, c in zip((1, 5), centres, strict=True)]
    mesh = trimesh.util.concatenate(parts)
    before = mesh.vertices.copy()
    found = preprocessing.voronoi_poles(mesh)
    assert found.shape == (1284, 3)
    np.testing.assert_allclose(found, np.repeat(centres, 642, axis=0), atol=1e-2)
    np.testing.assert_array_equal(mesh.vertices, before)


def test_the_public_call_says_nan_where_there_is_no_pole():
    vertices, faces = arrays(SHAPES["slab"]())
    has = balls.voronoi_poles(vertices, faces).is_found
    found = preprocessing.voronoi_poles((vertices, faces))
    np.testing.assert_array_equal(np.isnan(found).all(axis=1), ~has)
    assert np.isfinite(found[has]).all()


def test_the_public_reconstruction_treats_each_component_alone():
    parts = [blob(17, 2), torus().apply_translation([6, 0, 0])]
    joined = trimesh.util.concatenate(parts)
    before = joined.vertices.copy()
    smooth = preprocessing.reconstruct(joined, 30)
    np.testing.assert_array_equal(smooth.faces, joined.faces)
    np.testing.assert_array_equal(joined.vertices, before)
    alone = [preprocessing.reconstruct(part, 30).vertices for part in parts]
    np.testing.assert_allclose(smooth.vertices, np.concatenate(alone), atol=1e-9)
    assert np.abs(smooth.vertices - joined.vertices).max() > 1e-3
    np.testing.assert_allclose(preprocessing.reconstruct(joined, 10**6).vertices, joined.vertices, atol=1e-12)


@pytest.mark.parametrize("k", [3, 0, -5])
def test_too_few_eigenvectors_are_refused(k):
    with pytest.raises(ConfigError, match=f"k is {k}: expected a whole number of at least 4"):
        preprocessing.reconstruct(torus(), k)
