"""Holes that repair fills; rims whose flat lid would cut through the surface are extruded behind it."""

import numpy as np
import pytest
import trimesh
from repair_cases import BALL, FACES, VERTICES, assert_sound, volumes

import msf_jax
from msf_jax import Config, MeshError
from msf_jax.meshes import checking, holes
from tests.benchmarks import faults


def test_holes_are_filled_without_new_vertices():
    keep = np.random.default_rng(1).random(len(FACES)) > 0.15
    found = checking.prepare((VERTICES, FACES[keep]), True)
    assert_sound(found, len(VERTICES))
    assert [part.genus for part in found.components] == [0]
    assert volumes(found)[0] == pytest.approx(BALL.volume, rel=0.02)
    assert sum("filled" in sentence for sentence in found.repairs) == 1


def test_a_flat_hole_is_filled_flat():
    """A box without its lid: 16 vertices around the hole, so 14 faces, and the volume is as before."""
    vertices, faces = faults.box()
    keep = vertices[faces][:, :, 2].min(axis=1) < 0.5
    found = checking.prepare((vertices, faces[keep]), True)
    assert found.repairs == ("filled 1 hole with 14 faces",)
    assert volumes(found) == pytest.approx([1.0])


def relief(num: int = 16) -> tuple[np.ndarray, np.ndarray]:
    """A wavy height field over a square, its faces looking up, whose flat lid would be now above it and now below."""
    x, y = (axis.ravel() for axis in np.meshgrid(np.linspace(0, 1, num), np.linspace(0, 1, num), indexing="ij"))
    corner = (np.arange(num - 1)[:, None] * num + np.arange(num - 1)).ravel()
    a, b, c, d = corner, corner + num, corner + num + 1, corner + 1
    faces = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    return np.stack([x, y, 0.15 * np.sin(7 * x) * np.cos(5 * y)], axis=1), faces


@pytest.mark.parametrize("is_turned", [False, True])
def test_a_lid_that_would_cut_through_the_surface_goes_to_the_end_of_an_extruded_rim(is_turned):
    """What is closed is the relief and the block behind it: a prism behind each face."""
    vertices, faces = relief()
    faces = faces[:, ::-1] if is_turned else faces
    rim = 4 * 15
    found = checking.prepare((vertices, faces), True)
    assert found.repairs[1:] == (f"extruded 1 rim, whose lid would cut through the surface: {rim} new vertices",)
    mesh = trimesh.Trimesh(found.vertices, found.faces, process=False)
    assert mesh.is_watertight and mesh.is_winding_consistent and found.is_made.sum() == rim
    np.testing.assert_array_equal(found.vertices[found.vertex_of_input], vertices)
    rim, base = vertices[found.input_of_vertex[found.is_made]], found.vertices[found.is_made]
    across = np.linalg.svd(base - base.mean(axis=0))[2][2]
    np.testing.assert_allclose((base - base[0]) @ across, 0, atol=1e-9)  # flat
    np.testing.assert_allclose(np.cross(base - rim, across), 0, atol=1e-9)  # each straight behind its own of the rim
    assert base[:, 2].min() > 0.15 if is_turned else base[:, 2].max() < -0.15
    corners = vertices[faces]
    area = np.abs(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) @ across) / 2
    prisms = np.abs((corners.mean(axis=1) - base[0]) @ across) * area
    assert mesh.volume == pytest.approx(prisms.sum())
    assert holes.share_cut_off(found.vertices, found.faces, len(faces)) == 0


@pytest.mark.slow  # so does that of joined parts, in test_joining
def test_a_curve_of_a_relief_speaks_of_the_callers_vertices():
    vertices, faces = relief(10)
    run = msf_jax.contract((vertices, faces), config=Config(max_iterations=2), repair=True)
    assert len(run.skeleton.mesh_map) == len(vertices) and run.source.areas.sum() == pytest.approx(1.0)
    with pytest.raises(MeshError, match=r"repair made vertices where it joined parts or extruded a rim"):
        msf_jax.replay(run.tape, run.weights, vertices)


@pytest.mark.slow  # that lids are made is in test_filling
def test_a_lid_stays_where_an_extruded_rim_would_cut_as_well():
    """A ribbon that is twisted round twice looks every way: nothing is behind all of it."""
    turn, out = (axis.ravel() for axis in np.meshgrid(np.linspace(0, 4 * np.pi, 60), [-1.0, 0.1, 1.0], indexing="ij"))
    vertices = np.stack([out * np.cos(turn), out * np.sin(turn), turn], axis=1)
    corner = (np.arange(59)[:, None] * 3 + np.arange(2)).ravel()
    a, b, c, d = corner, corner + 3, corner + 4, corner + 1
    faces = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    found = checking.prepare((vertices, faces), True)
    assert not found.is_made.any()
    assert "the lid of 1 hole cuts through the surface, and so would an extruded rim" in found.repairs[1]
    report = msf_jax.skeletonize((vertices, faces), repair=True).report
    assert report.inside < 1 and any("no path inside was found for" in note for note in report.notes)
