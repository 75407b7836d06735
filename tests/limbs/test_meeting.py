"""Discs that grow together: closed forms on a rod."""

import manifold3d
import numpy as np
import pytest
from limb_cases import solid

from msf_jax.limbs import caps
from msf_jax.solid.geometry import triangle_areas

RADIUS, HALF = 0.5, 3.0


def rod() -> caps.Patch:
    shape = solid(manifold3d.Manifold.cylinder(2 * HALF, RADIUS, RADIUS, 48, True), 0.15)
    x, faces = shape.vertices, shape.faces
    return caps.Patch(np.arange(len(x)), x, faces, triangle_areas(x[faces]))


def from_end(x: np.ndarray, side: int) -> np.ndarray:
    """The geodesic distance from the middle of an end of the rod, exact but on the other end."""
    return np.hypot(x[:, 0], x[:, 1]) + HALF - side * x[:, 2]


@pytest.mark.parametrize("first", [2.0, 3.0, 3.6])
def test_discs_at_both_ends_grow_until_they_meet(first):
    """Half of the rod sticks out by 3, six times its radius, and has half of the surface."""
    part = rod()
    x, away = part.points, np.stack([from_end(part.points, side) for side in (-1, 1)])
    grown = caps.grown_together(part, away.argmin(axis=1), away, np.full(2, first), 1.06)
    for side, cap in zip((-1, 1), grown, strict=True):
        assert (side * x[cap.region, 2]).min() > -0.2
        assert cap.area == pytest.approx(part.area.sum() / 2, rel=0.06)
        assert cap.slenderness == pytest.approx(HALF / RADIUS, rel=0.06)
    assert not np.isin(grown[0].region, grown[1].region).any()


def test_a_cap_has_its_small_pieces_but_not_the_rest():
    """Below z = 1 is the rest; a hole in the cap is filled, and its edge does not count."""
    part = rod()
    x = part.points
    top = np.where(np.linalg.norm(x - [RADIUS, 0, 2], axis=1) < 0.3, -1.0, x[:, 2] - 1)
    whole = x[:, 2] - 1
    found, plain = (caps.cap_where(part, 0, value) for value in (top, whole))
    assert (top <= 0).sum() > (whole <= 0).sum()
    np.testing.assert_array_equal(found.region, plain.region)
    assert found.slenderness == plain.slenderness == pytest.approx(2 / RADIUS, rel=0.01)
