"""Curves of angles and channels, straight and bent: in the corner and in the web, from end to end."""

import manifold3d
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import msf_jax

ANGLE = np.array([[0, 0], [3, 0], [3, 0.8], [0.8, 0.8], [0.8, 3], [0, 3]]) - 0.4
CHANNEL = np.array([[-1.5, -0.3], [1.5, -0.3], [1.5, 1.9], [0.9, 1.9], [0.9, 0.3], [-0.9, 0.3], [-0.9, 1.9],
                    [-1.5, 1.9]])  # fmt: skip
BEND = 24.0  # from the axis about which a bent profile turns


@pytest.mark.parametrize(
    ("profile", "half", "edge", "is_bent"),
    [
        (ANGLE, 0.4, 50.0, False),
        pytest.param(CHANNEL, 0.3, 0.5, True, marks=pytest.mark.slow),
    ],
)
def test_the_curve_of_a_profile_is_in_the_middle_of_its_material(profile, half, edge, is_bent):
    """The middle of the corner or of the web is at 0. It was in one flange, or in both in turn."""
    length = 12.0
    body = manifold3d.Manifold.extrude(manifold3d.CrossSection([profile]), length).refine_to_length(edge)
    mesh = body.to_mesh64()
    x, y, z = np.array(mesh.vert_properties[:, :3]).T
    if is_bent:
        x, z = (BEND + x) * np.cos(z / BEND) - BEND, (BEND + x) * np.sin(z / BEND)
    turn = Rotation.random(rng=np.random.default_rng(1)).as_matrix()
    skeleton = msf_jax.skeletonize((np.stack([x, y, z], 1) @ turn.T, np.array(mesh.tri_verts, dtype=np.int64)))
    x, y, z = (skeleton.vertices @ turn).T
    if is_bent:
        x, z = np.hypot(BEND + x, z) - BEND, np.arctan2(z, BEND + x) * BEND
    assert (np.bincount(skeleton.edges.ravel()) == 1).sum() == 2
    assert np.hypot(x, y).max() < 0.25 * half
    assert 0 < z.min() < half and length - half < z.max() < length
    # As before, the report says that such a limb is a sheet.
    assert (skeleton.report.in_sheets or 0.0) > 0.9 and not skeleton.report.is_sound
