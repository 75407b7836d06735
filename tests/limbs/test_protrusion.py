"""Where a surface stands out: closed forms of the protrusion, and limbs that only stand out."""

import numpy as np
import pytest
import trimesh
from limb_cases import Solid, as_shape, box, i_beam, round_bar

import msf_jax
from msf_jax.limbs import protrusion
from msf_jax.limbs.caps import Caps, Limbs
from msf_jax.solid.enclosure import Enclosure


def protrusions_and_scales(shape: Enclosure) -> tuple[np.ndarray, np.ndarray]:
    """(S, V) protrusions, and (S, 1) their scales as lengths."""
    area = trimesh.Trimesh(shape.vertices, shape.faces, process=False).area
    return protrusion.protrusions(shape.vertices, shape.faces), np.sort(protrusion.SCALES)[:, None] * np.sqrt(area)


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


def ball_with_feet(height: float, radius: float = 0.3) -> Solid:
    """A ball of radius 1 with two feet, round rods that end ``height`` above it, at a right angle."""
    foot = Solid.cylinder(1 + height - radius, radius, radius, 24) + Solid.sphere(radius, 24).translate(
        (0, 0, 1 + height - radius)
    )
    return Solid.sphere(1.0, 64) + foot + foot.rotate((90, 0, 0))


def limbs_of(solid: Solid, edge: float, detail: float) -> Limbs:
    shape = as_shape(solid, edge)
    return Caps(Enclosure(shape.vertices / np.linalg.norm(np.ptp(shape.vertices, axis=0)), shape.faces), detail).limbs(
        1.0
    )


def test_finer_details_only_add_limbs():
    """`RAISED`, `LEAST_RAISED`: feet that are too short for a slenderness of 1; the next ones are named."""
    found = {detail: limbs_of(ball_with_feet(0.28), 0.15, detail) for detail in (0.0, 0.5, 0.65)}
    regions = {detail: {cap.tip for cap in limbs.caps} for detail, limbs in found.items()}
    assert regions[0.0] <= regions[0.5] <= regions[0.65]
    assert len(regions[0.0]) == 0 and len(regions[0.65]) == 2
    named = {each.cap.tip for each in found[0.0].finer}
    assert regions[0.65] == regions[0.0] | named
    assert all(each.detail > 0.5 for each in found[0.5].finer)


@pytest.mark.parametrize(("height", "num"), [(0.17, 2), (0.05, 0)])
def test_the_finest_detail_asks_for_a_third_of_what_a_limb_needs(height, num):
    """`LEAST_RAISED`: feet that stick out by half of their radius, and by a sixth."""
    assert len(limbs_of(ball_with_feet(height), 0.15, 0.6).caps) == 0
    assert len(limbs_of(ball_with_feet(height), 0.15, 1.0).caps) == num


@pytest.mark.parametrize(
    ("solid", "edge"),
    [
        (box(3, 3, 3), 0.5),
        (round_bar(3), 0.3),
        (Solid.sphere(1, 32), 0.4),
        pytest.param(box(6, 6, 0.4), 0.4, marks=pytest.mark.slow),
        pytest.param(i_beam(9), 0.3, marks=pytest.mark.slow),
    ],
)
def test_corners_and_rims_are_no_limbs_at_the_default(solid, edge):
    """`CORNER`: of a cube 1 / 6, of a thin plate 1 / 2; rims are within a width of a limb's end."""
    plain, fine = limbs_of(solid, edge, 0.0), limbs_of(solid, edge, 0.5)
    assert [cap.tip for cap in fine.caps] == [cap.tip for cap in plain.caps]


def test_half_a_ball_on_a_wall_is_no_limb_and_a_longer_one_is():
    """At the border, the height is 1.4 to 1.6 radii: see the guide."""
    wall = box(12, 12, 8).translate((0, 0, -4))
    for height, num in ((1.0, 0), (1.7, 1)):
        stub = Solid.cylinder(height + 1, 1, 1, 32).translate((0, 0, -2)) + Solid.sphere(1, 32).translate(
            (0, 0, height - 1)
        )
        limbs = limbs_of(wall + stub, 0.5, 0.5)
        x = as_shape(wall + stub, 0.5).vertices
        assert sum(x[cap.tip, 2] > 0.5 for cap in limbs.caps) == num


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
