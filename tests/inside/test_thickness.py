"""The thickness that balls tell of, and thin shapes, which keep their length."""

import numpy as np
import trimesh

from msf_jax.inside import balls
from msf_jax.meso import edits
from msf_jax.meso.meso import Meso
from tests.benchmarks import ground_truth


def coil(radius: float, length: float = 2.0, sides: int = 12) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """A bent tube of about that radius and length over its diagonal: vertices, faces, points of its axis."""
    angle = np.linspace(0, 2.2 * np.pi * length, 4000)
    axis = np.stack([np.cos(angle), np.sin(angle), 0.15 * angle], axis=1)
    axis /= np.linalg.norm(np.ptp(axis, axis=0))
    axis = axis[: int(np.searchsorted(np.r_[0, np.cumsum(np.linalg.norm(np.diff(axis, axis=0), axis=1))], length))]
    mesh = ground_truth.swept_tube(axis, np.full(len(axis), radius), sides, "round")
    noise = np.random.default_rng(0).normal(0, 0.02 * radius, mesh.vertices.shape)
    return np.array(mesh.vertices) + noise, np.array(mesh.faces), axis


def test_a_thick_solid_has_no_scale_and_a_thin_limb_has_its_own():
    box = trimesh.creation.box((0.5, 0.5, 0.5)).subdivide().subdivide().subdivide().subdivide()
    assert balls.scales(np.array(box.vertices), np.array(box.faces)) is None  # balls vanish at its edges
    vertices, faces, _ = coil(0.002, 0.6)
    scale = balls.scales(vertices, faces)
    assert scale is not None
    assert abs(np.median(scale) - 0.002 / balls.THIN) < 0.1 * 0.002 / balls.THIN


def test_edges_of_a_thin_limb_outlive_a_length_that_others_do_not():
    vertices, faces, _ = coil(0.002, 0.3, 6)
    meso = Meso.from_mesh(vertices, faces)
    meso.scale = np.full(meso.num_rows, 0.1)
    whole = meso.copied()
    whole.scale = None
    assert edits.collapse_short_edges(whole, 0.004) and not edits.collapse_short_edges(meso, 0.004)
    meso.scale = np.linspace(0.1, 1.0, meso.num_rows)
    edits.split_long_edges(meso, 0.001)
    meso = meso.compacted()
    assert meso.scale is not None and len(meso.scale) == meso.num_rows and meso.scale.min() >= 0.1
