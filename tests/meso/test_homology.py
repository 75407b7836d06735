"""Classes of edges: which loops vanish in the solid. Against linking numbers known by hand, and through all edits."""

import numpy as np
import pytest
from conftest import torus
from meso_cases import check_classes, loop_class

import msf_jax
from msf_jax import Config, shapes
from msf_jax.curve import extraction
from msf_jax.meso import collapse, homology, split
from msf_jax.meso.meso import Meso
from msf_jax.topology import graphs

TURN = np.linspace(0, 2 * np.pi, 60, endpoint=False)


RING = np.stack([np.cos(TURN), np.sin(TURN), 0 * TURN], axis=1)


LINKED = np.stack([1 + np.cos(TURN), 0 * TURN, np.sin(TURN)], axis=1)


def test_linking_numbers_of_rings():
    """A Hopf link, turned round, apart, and a curve that winds three times around the ring's core."""
    winding = np.stack(
        [
            (1 + 0.3 * np.cos(3 * TURN)) * np.cos(TURN),
            (1 + 0.3 * np.cos(3 * TURN)) * np.sin(TURN),
            0.3 * np.sin(3 * TURN),
        ],
        axis=1,
    )
    numbers = homology.linking_numbers([RING], [LINKED, LINKED[::-1], LINKED + 5, winding])[0]
    assert abs(numbers[0]) == 1
    assert numbers[1] == -numbers[0]
    assert numbers[2] == 0
    assert abs(numbers[3]) == 3


def with_classes(mesh):
    vertices, faces = np.array(mesh.vertices) / np.linalg.norm(mesh.extents), np.array(mesh.faces)
    meso = Meso.from_mesh(vertices, faces)
    meso.classes = homology.ring_classes(vertices, faces, meso.rings)
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
    assert len(collapse.collapse_short_edges(meso, t_c, check=True)) > 1
    check_classes(meso)
    meso.positions *= [1.0, 1.0, 0.05]
    assert len(split.split_obtuse_edges(meso, 110, 1e-4, 10**6, check=True)[0]) > 0
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


def test_a_run_without_linking_numbers_has_its_cycle_and_says_how(monkeypatch):
    monkeypatch.setattr(homology, "half_edge_classes", lambda *_: None)
    report = msf_jax.skeletonize(torus(around=24, across=12)).report
    assert (report.genus, report.cycles, report.loops) == (1, 1, 1)
    assert any("told apart by their lengths only" in note for note in report.notes)


@pytest.mark.slow  # plates with holes are in test_handle_loops
def test_a_plate_with_a_small_hole_keeps_it():
    """The loop around the hole is far shorter than the loops around the plate's rim, which must go."""
    step, x = 0.08, np.arange(-1.3, 1.3, 0.08)
    grid = np.stack(np.meshgrid(x, x, np.arange(-0.4, 0.4, step), indexing="ij"), axis=-1)
    slab = np.maximum(np.abs(grid[..., :2]).max(axis=-1) - 1, np.abs(grid[..., 2]) - 0.13)
    hole = 0.15 - np.hypot(grid[..., 0] - 0.3, grid[..., 1] - 0.2)
    mesh = shapes.level_set(np.maximum(slab, hole), np.array([x[0], x[0], -0.4]), step)
    report = msf_jax.skeletonize(mesh, config=Config(check=True)).report
    assert (report.components, report.genus, report.cycles, report.loops) == (1, 1, 1, 1)
