"""STL files, which have no indices."""

from pathlib import Path

import numpy as np
import pytest
import trimesh

from msf_jax.meshes import checking, reading


@pytest.mark.parametrize("kind", ["stl", "stl_ascii"])
def test_an_stl_has_each_vertex_once_and_asks_for_no_repair(tmp_path: Path, kind):
    """It has no indices; and some programs write the corners of one vertex with other last bits."""
    torus = trimesh.creation.torus(1.0, 0.3, 24, 12)
    shaken = torus.triangles.reshape(-1, 3) * (1 + 2.0**-24 * np.random.default_rng(1).integers(-1, 2, (3 * 576, 3)))
    loose = trimesh.Trimesh(shaken, np.arange(3 * 576).reshape(-1, 3), process=False)
    loose.export(tmp_path / "torus.stl", file_type=kind)
    vertices, faces = reading.read(tmp_path / "torus.stl")
    assert vertices.shape == torus.vertices.shape and faces.shape == torus.faces.shape
    np.testing.assert_allclose(vertices[faces], torus.triangles, atol=1e-6)
    assert checking.prepare(tmp_path / "torus.stl").repairs == ()
