"""Curves that surgery makes of a contracted surface."""

import numpy as np
import pytest
from conftest import torus
from meso_cases import ring_classes

from msf_jax.curve import extraction
from msf_jax.meso.meso import Meso
from msf_jax.topology import graphs
from tests.benchmarks import ground_truth


@pytest.mark.parametrize("seed", range(4))
def test_surgery_keeps_the_cycle_and_a_vertex_for_a_node(seed):
    mesh = torus(around=12, across=6)
    meso = Meso.from_mesh(mesh.vertices, np.array(mesh.faces))
    classes = ring_classes(meso.positions, meso.faces(), meso.rings)
    x = np.random.default_rng(seed).normal(size=meso.positions.shape)
    found = extraction.extract_curve(x, meso.rings, classes, by_surgery=True)
    assert graphs.cycle_count(len(found.nodes), found.edges) == (1, 1)
    assert np.array_equal(np.sort(found.node_of_meso[found.is_counted]), np.arange(len(found.nodes)))
    assert np.array_equal(found.nodes[found.node_of_meso[found.is_counted]], x[found.is_counted])


def test_a_straight_thin_tube_keeps_its_ends():
    """Of a tube that has been contracted to its axis but for a thousandth, surgery leaves nodes all along it."""
    mesh = ground_truth.make("straight").mesh
    vertices = np.array(mesh.vertices)
    centre, axis = vertices.mean(axis=0), np.linalg.svd(vertices - vertices.mean(axis=0), full_matrices=False)[2][0]
    along = np.outer((vertices - centre) @ axis, axis)
    thin = centre + along + 1e-3 * (vertices - centre - along)
    meso = Meso.from_mesh(thin, np.array(mesh.faces))
    found = extraction.extract_curve(thin, meso.rings, by_surgery=True)
    assert graphs.cycle_count(len(found.nodes), found.edges) == (1, 0)
    assert len(found.nodes) > 20
    assert np.ptp(found.nodes @ axis) > 0.9 * np.ptp(vertices @ axis)
