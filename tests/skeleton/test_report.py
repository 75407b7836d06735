"""What a report knows of a curve beyond its counts: its loops, limbs that are none, paths that are arbitrary."""

from dataclasses import replace
from itertools import pairwise

import limb_cases
import numpy as np
import pytest
import trimesh
from conftest import torus
from limb_cases import as_shape, mitred, zigzag
from loop_cases import cycle

import msf_jax
from msf_jax import Config, metrics
from msf_jax.skeleton import skeleton as skeletons
from msf_jax.skeleton.report import assessed, bare_ends, loops_of
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.solid import Solid


def box(*sides: float) -> Enclosure:
    """A box around the origin, in small triangles."""
    mesh = trimesh.creation.box(sides).subdivide_to_size(0.15)
    return Enclosure(np.array(mesh.vertices), np.array(mesh.faces))


@pytest.mark.parametrize("aside", [0.0, 0.05, 0.1])
@pytest.mark.parametrize(("side", "share"), [(0.3, 0.0), (0.72, 0.0), (0.84, 1.0), (1.6, 1.0)])
def test_the_share_of_a_curve_in_sheets(side, share, aside):
    """Bars 0.3 thick: the points around a rectangle's edge are 2 half thicknesses from its centre, on average, where it
    is 2.6 times as wide as thick. Also where the curve is not in the middle."""
    x = np.full((41, 3), [0, 0, aside])
    x[:, 0] = np.linspace(-0.8, 0.8, 41)
    edges = np.stack([np.arange(40), np.arange(1, 41)], axis=1)
    assert assessed(box(2.0, side, 0.3), x, edges)["in_sheets"] == pytest.approx(share, abs=0.06)


def through(*corners: tuple[float, float, float]) -> tuple[np.ndarray, np.ndarray]:
    """A curve through ``corners``, with nodes 0.05 apart."""
    sides = [
        np.linspace(a, b, round(float(np.linalg.norm(np.subtract(b, a))) / 0.05) + 1) for a, b in pairwise(corners)
    ]
    x = np.concatenate([side[int(number > 0) :] for number, side in enumerate(sides)])
    return x, np.stack([np.arange(len(x) - 1), np.arange(1, len(x))], axis=1)


def folds(shape: Enclosure, x: np.ndarray, edges: np.ndarray) -> list[str]:
    return [doubt for doubt in assessed(shape, x, edges)["doubts"] if "turns back" in doubt or "more" in doubt]


@pytest.mark.parametrize("aside", [0.0, 0.2])
def test_a_curve_that_runs_out_and_back_is_in_doubt(aside):
    """In a bar of half width 1, two long strands whose ends are 0.2 apart: they are one."""
    bar = as_shape(limb_cases.box(6, 2, 2), 1.0)
    assert folds(bar, *through((-2, 0, 0), (2, 0, 0), (-2, aside, 0))) == ["the curve turns back at node 80"]
    there = [(-2.0, 0.0, 0.0), (1.5, 0.0, 0.0)]
    expected = [f"the curve turns back at node {70 * number}" for number in range(1, 6)]
    assert folds(bar, *through(*4 * there)) == [*expected, "and at 1 more"]
    assert not folds(bar, *through((-2, 0, 0), (2, 0, 0)))


@pytest.mark.parametrize("angle", [25, 60])
def test_a_narrow_corner_of_a_solid_is_not_in_doubt(angle):
    axis = zigzag(angle, 2, 12.0)
    assert not folds(as_shape(mitred(axis), 1.0), *through(*axis))


@pytest.mark.parametrize(
    ("radius", "length", "bore", "top", "is_told"),
    [(1.0, 6.0, 0, 1.0, True), (1.0, 6.0, 0, 2.7, False), (2.0, 0.6, 0, 0.0, False), (1.5, 6.0, 0.8, -0.4, False)],
)
def test_a_flat_end_without_a_branch_is_told(radius, length, bore, top, is_told):
    """Not one that has a branch, nor a seat that is thin for its radius, nor the floor of a bore."""
    mesh = trimesh.creation.cylinder(radius, length, sections=32)
    if bore:
        hole = trimesh.creation.cylinder(bore, 4.0, sections=32).apply_translation([0, 0, 3.0])
        mesh = trimesh.boolean.difference([mesh, hole])
    mesh = mesh.subdivide_to_size(0.3)
    solid = Solid(np.array(mesh.vertices), np.array(mesh.faces))
    x, edges = through((0, 0, 0.3 - length / 2), (0, 0, top), (0.3, 0, top))
    notes = bare_ends(solid, x, edges)
    assert len(notes) == is_told and all(f", {length / 2:.4g})" in note for note in notes)


def test_a_plane_that_cuts_off_the_side_of_a_trunk_is_in_no_sheet():
    """Where an arm begins in a block, a section across the arm is wide, and thick as well."""
    arm = trimesh.creation.box((0.5, 0.5, 2.0), trimesh.transformations.translation_matrix([0, 0, 2.4]))
    mesh = trimesh.boolean.union([trimesh.creation.box((3, 3, 3)), arm]).subdivide_to_size(0.15)
    solid = Enclosure(np.array(mesh.vertices), np.array(mesh.faces))
    x = np.zeros((23, 3))
    x[:, 2] = np.linspace(1.1, 3.3, 23)
    edges = np.stack([np.arange(22), np.arange(1, 23)], axis=1)
    assert assessed(solid, x, edges)["in_sheets"] == 0.0


def test_a_report_says_what_it_weighs():
    skeleton = msf_jax.skeletonize(trimesh.creation.capsule(height=3.0, radius=0.4, count=[12, 12]))
    report = skeleton.report
    assert report.is_sound and report.in_sheets == 0.0 and report.doubts == ()
    doubted = replace(report, doubts=("the surface may be rough",))
    assert not doubted.is_sound and "in doubt: the surface may be rough" in str(doubted)
    assert skeleton.resample(0.1).report.is_sound


@pytest.fixture(scope="module")
def ring_curve():
    return msf_jax.skeletonize(torus(minor=0.3), config=Config(least_slenderness=0.0))


def changed(skeleton, vertices, edges):
    return skeletons.changed(skeleton, np.array(vertices), np.array(edges), np.arange(len(skeleton.vertices))).report


def test_a_mutated_curve_is_not_sound(ring_curve):
    """Its loop moved off the hole, doubled, gone round twice, cut, or led through the hole."""
    assert ring_curve.report.is_sound and ring_curve.report.loops == 1
    x, edges = ring_curve.vertices, ring_curve.edges
    num = len(x)
    assert changed(ring_curve, x, edges).is_sound
    beside = x[0] + 0.02 * (x - x.mean(axis=0))
    report = changed(ring_curve, beside, edges)
    assert (report.loops, report.cycles, report.inside, report.is_sound) == (0, 1, 1.0, False)
    assert "goes around no handle" in report.doubts[0] and "in doubt: the loop" in str(report)
    assert "1 cycle for genus 1, around ONLY 0 handles" in str(report)
    bridge = [[0, num]]
    report = changed(ring_curve, np.concatenate([x, 1.01 * x]), np.concatenate([edges, edges + num, bridge]))
    assert (report.loops, report.cycles, report.is_sound) == (1, 2, False) and "of others" in report.doubts[0]
    cut = changed(ring_curve, x, edges[1:])
    assert (cut.loops, cut.cycles, cut.is_sound) == (0, 0, False)
    through = changed(ring_curve, 1.4 * x, edges)
    assert (through.loops, through.is_sound) == (0, False) and "leaves the solid" in through.doubts[0]
    angle = np.arange(240) * 4 * np.pi / 240
    twice = np.stack([np.cos(angle), np.sin(angle), 0.05 * np.sin(angle / 2)], axis=1)
    solid = ring_curve.source.solid
    around = loops_of(solid.shape, solid.enter(twice), cycle(240))
    report = replace(ring_curve.report, cycles=1, **around)
    assert report.loops == 1 and not report.is_sound and "more than once" in report.doubts[0]


def test_a_tree_of_a_curve_in_doubt_stays_in_doubt(ring_curve):
    x, edges = ring_curve.vertices, ring_curve.edges
    false = skeletons.changed(ring_curve, x[0] + 0.02 * (x - x.mean(axis=0)), edges, np.arange(len(x)))
    assert not false.to_tree().report.is_sound and ring_curve.to_tree().report.is_sound


def test_the_figures_count_loops(ring_curve):
    mesh = torus(minor=0.3)
    assert metrics.evaluate(mesh, ring_curve)["loops"] == 1
    beside = ring_curve.vertices[0] + 0.02 * ring_curve.vertices
    assert metrics.evaluate(mesh, (beside, ring_curve.edges))["loops"] == 0
