"""Where a surface stands out: closed forms of the protrusion, and limbs that only stand out."""

import numpy as np
import pytest
import trimesh
from limb_cases import Solid, as_shape, box, round_bar

import msf_jax
from msf_jax.limbs import caps
from msf_jax.solid.enclosure import Enclosure


def protrusions_and_scales(shape: Enclosure) -> tuple[np.ndarray, np.ndarray]:
    """(S, V) protrusions, and (S, 1) their scales as lengths."""
    area = trimesh.Trimesh(shape.vertices, shape.faces, process=False).area
    return caps.protrusions(shape.vertices, shape.faces), np.sort(caps.HEAT_SCALES)[:, None] * np.sqrt(area)


def test_the_protrusion_of_a_ball_is_that_of_the_closed_form():
    """x is an eigenfunction of the Laplacian on a ball, to the eigenvalue 2 / R^2: so h = u / (2 + u^2), u = s / R."""
    ball = trimesh.creation.icosphere(subdivisions=4, radius=2.0)
    found, scale = protrusions_and_scales(Enclosure(np.array(ball.vertices), np.array(ball.faces)))
    u = scale / 2.0
    np.testing.assert_allclose(np.median(found, axis=1), (u / (2 + u**2))[:, 0], rtol=0.01)


def test_the_protrusion_in_the_middle_of_a_cylinder_is_that_of_the_closed_form():
    """Across it, x is an eigenfunction to the eigenvalue 1 / R^2: h = u / (4 + u^2)."""
    shape = as_shape(round_bar(30), 0.3)
    found, scale = protrusions_and_scales(shape)
    middle = np.abs(shape.vertices[:, 0]) < 1
    expected = scale / (4 + scale**2)
    np.testing.assert_allclose(found[1:3, middle].mean(axis=1), expected[1:3, 0], rtol=0.05)


def test_the_end_of_a_rod_stands_out_by_half_the_scale():
    """On a half line, x_s is the mean of x with the weight exp(-2 x / s): s / 2 from the end.
    A rod is 0.5 wide: a sixth of the scale."""
    shape = as_shape(box(120, 0.5, 0.5), 0.25)
    found, scale = protrusions_and_scales(shape)
    end = np.linalg.norm(shape.vertices - [60, 0, 0], axis=1).argmin()
    assert scale[-1] > 3
    assert found[-1, end] == pytest.approx(0.5, rel=0.1)


@pytest.mark.slow  # limbs of a detail are above
def test_a_curve_is_pruned_to_a_coarser_detail():
    """A bar with a short rod on its side, which is a limb at a finer detail than the default."""
    rod = Solid.cylinder(1.3, 0.6, 0.6, 32) + Solid.sphere(0.6, 32).translate((0, 0, 1.3))
    shape = as_shape(box(12, 2, 2) + rod, 0.8)
    mesh = trimesh.Trimesh(shape.vertices, shape.faces)
    fine = msf_jax.skeletonize(mesh, config=msf_jax.Config(detail=0.65))
    assert fine.num_leaves == 3
    assert fine.prune(1.0, detail=0.65).num_leaves == 3
    assert fine.prune(1.0, detail=0.0).num_leaves == 2
    coarse = msf_jax.skeletonize(mesh, config=msf_jax.Config(detail=0.0))
    assert coarse.num_leaves == coarse.prune().num_leaves == 2
    # And to a finer one: its nodes stay, and the new branch is on the rod's axis, at x = y = 0.
    added = coarse.prune(1.0, detail=0.65)
    assert added.num_leaves == 3 and added.report.grown == coarse.report.grown + 1 and added.report.inside == 1
    np.testing.assert_array_equal(added.vertices[: len(coarse.vertices)], coarse.vertices)
    new = added.vertices[len(coarse.vertices) :]
    assert np.hypot(*new[new[:, 2] > 1, :2].T).max() < 0.3 * 0.6 and new[:, 2].max() > 1.4
    assert added.prune(1.0, detail=0.0).num_leaves == 2
    with pytest.raises(msf_jax.ConfigError, match="detail is 2"):
        fine.prune(1.0, detail=2)
    with pytest.raises(msf_jax.ConfigError, match="limbs are not known"):
        fine.prune(0, detail=0.6)
