"""Au et al. 2008: the recentring, and the system as a whole."""

import numpy as np
from conftest import torus

import msf_jax
from msf_jax import Config
from msf_jax.meso import surgery
from tests.benchmarks import ground_truth


def test_recentring_brings_a_shifted_contraction_back():
    mesh = torus(around=40, across=16)
    vertices, faces = np.array(mesh.vertices), np.array(mesh.faces)
    angle = np.arctan2(vertices[:, 1], vertices[:, 0])
    node = np.floor((angle + np.pi) / (2 * np.pi) * 10).astype(int) % 10
    off = np.array([0.03, -0.02, 0.05])  # where the contraction has taken every ring, from its middle
    middle = (
        np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1) * (np.linalg.norm(vertices[:, :2], axis=1)).mean()
    )
    contracted = middle + off
    nodes = np.stack([contracted[node == k].mean(axis=0) for k in range(10)])
    ring = np.stack([np.arange(10), (np.arange(10) + 1) % 10], axis=1)
    back = surgery.recentred(nodes, ring, node, contracted, vertices, faces)
    radius = np.linalg.norm(vertices[:, :2], axis=1).mean()
    assert np.abs(np.linalg.norm(nodes[:, :2], axis=1) - radius).max() > 0.02
    assert np.abs(back[:, 2]).max() < 0.01  # it was 0.05 off
    assert np.abs(np.linalg.norm(back[:, :2], axis=1) - radius).max() < 0.02
    # A leaf goes with the node before it.
    chain = ring[:-1]
    moved = surgery.recentred(nodes, chain, node, contracted, vertices, faces) - nodes
    assert np.allclose(moved[0], moved[1])
    assert np.allclose(moved[9], moved[8])


def test_the_system_contracts_to_a_millionth_and_draws_the_curve():
    shape = ground_truth.make("helix_coarse")
    config = Config.au2008(evaluate=True, curve={"centre": True, "extend_tips": True})
    done = msf_jax.skeletonize(shape.mesh, config=config)
    report = done.report
    assert report.converged
    assert report.volume < 1e-6
    assert report.iterations <= 20
    assert report.out_of_steps == 0
    assert (report.components, report.cycles, report.loops, report.inside) == (1, shape.genus, shape.genus, 1.0)
    assert len(np.unique(done.mesh_map)) > 4
    assert report.figures["leaves"] == shape.num_leaves
    assert report.figures["off_centre"] < 0.12
    other = msf_jax.skeletonize(shape.mesh, config=Config.au2008(curve={"surgery": False}))
    assert (other.report.cycles, other.report.loops, other.report.inside) == (shape.genus, shape.genus, 1.0)


def test_a_ring_keeps_its_loop():
    report = msf_jax.skeletonize(torus(minor=0.2, around=40, across=12), config=Config.au2008()).report
    assert report.converged
    assert (report.genus, report.cycles, report.loops, report.inside) == (1, 1, 1, 1.0)
