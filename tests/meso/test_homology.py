"""Classes of edges: which loops vanish in the solid. Against linking numbers known by hand, and through all edits."""

import numpy as np
import pytest
from conftest import torus
from meso_cases import check_classes, loop_class, ring_classes

from msf_jax.curve import extraction
from msf_jax.meso import edits
from msf_jax.meso.meso import Meso
from msf_jax.topology import graphs


def with_classes(mesh):
    vertices, faces = np.array(mesh.vertices) / np.linalg.norm(mesh.extents), np.array(mesh.faces)
    meso = Meso.from_mesh(vertices, faces)
    meso.classes = ring_classes(vertices, faces, meso.rings)
    return meso


def test_around_a_torus_is_kept_and_across_it_vanishes():
    meso = with_classes(torus(around=24, across=12))
    check_classes(meso)
    around, across = np.arange(24) * 12, np.arange(12)
    assert loop_class(meso, across) == 0
    assert loop_class(meso, around) != 0
    assert loop_class(meso, around + 5) == loop_class(meso, around)


def test_classes_follow_collapses_and_splits():
    meso = with_classes(torus(around=30, across=14))
    t_c = 0.06
    assert len(edits.collapse_short_edges(meso, t_c)) > 1
    check_classes(meso)
    meso.positions *= [1.0, 1.0, 0.05]
    assert len(edits.split_obtuse_edges(meso, 110, 1e-4, 10**6)[0]) > 0
    check_classes(meso)
    meso = meso.compacted()
    check_classes(meso)


@pytest.mark.parametrize("seed", range(30))
def test_the_curve_keeps_its_cycle_in_whatever_order_edges_go(seed):
    """With random lengths the published rule may pinch the handle itself; with classes it never does."""
    meso = with_classes(torus(around=12, across=6))
    noise = np.random.default_rng(seed).normal(size=meso.positions.shape)
    found = extraction.extract_curve(noise, meso.rings, meso.classes)
    assert graphs.cycle_count(len(found.nodes), found.edges) == (1, 1)
