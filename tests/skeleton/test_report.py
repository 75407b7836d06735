"""What a report knows of a curve beyond its counts: limbs that are none, paths that are arbitrary."""

from dataclasses import replace

import numpy as np
import pytest
import trimesh

import msf_jax
from msf_jax.skeleton.report import assessed
from msf_jax.solid.enclosure import Enclosure


def box(*sides: float) -> Enclosure:
    """A box around the origin, in small triangles."""
    mesh = trimesh.creation.box(sides).subdivide_to_size(0.15)
    return Enclosure(np.array(mesh.vertices), np.array(mesh.faces))


def comb(teeth: int, length: float) -> tuple[np.ndarray, np.ndarray]:
    """A line along x from -0.8 to 0.8 with so many side branches along y."""
    line = np.stack([np.linspace(-0.8, 0.8, teeth + 2), np.zeros(teeth + 2), np.zeros(teeth + 2)], axis=1)
    missed_limbs = np.concatenate([line[1:-1] + [0, part * length, 0] for part in (0.5, 1.0)])
    own, first, last = np.arange(1, teeth + 1), np.arange(teeth) + teeth + 2, np.arange(teeth) + 2 * teeth + 2
    edges = [(np.arange(teeth + 1), np.arange(1, teeth + 2)), (own, first), (first, last)]
    return np.concatenate([line, missed_limbs]), np.concatenate([np.stack(pair, axis=1) for pair in edges])


@pytest.mark.parametrize(("teeth", "is_doubted"), [(22, False), (24, True)])
def test_many_limbs_that_are_hardly_longer_than_wide_are_in_doubt(teeth, is_doubted):
    """Side branches in a block: none of them is a limb of it."""
    doubts = tuple(each for each in assessed(box(2.0, 1.0, 1.0), *comb(teeth, 0.3))["doubts"] if "limbs" in each)
    expected = (f"{teeth + 2} of {teeth + 2} limbs are hardly longer than wide: the surface may be rough",)
    assert doubts == (expected if is_doubted else ())


@pytest.mark.parametrize("aside", [0.0, 0.05, 0.1])
@pytest.mark.parametrize(("side", "share"), [(0.3, 0.0), (0.72, 0.0), (0.84, 1.0), (1.6, 1.0)])
def test_the_share_of_a_curve_in_sheets(side, share, aside):
    """Bars 0.3 thick: the points around a rectangle's edge are 2 half thicknesses from its centre, on average, where it
    is 2.6 times as wide as thick. Also where the curve is not in the middle."""
    x = np.full((41, 3), [0, 0, aside])
    x[:, 0] = np.linspace(-0.8, 0.8, 41)
    edges = np.stack([np.arange(40), np.arange(1, 41)], axis=1)
    assert assessed(box(2.0, side, 0.3), x, edges)["in_sheets"] == pytest.approx(share, abs=0.06)


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
    assert "42% of the curve's length is in sheets" in str(replace(report, in_sheets=0.42))
    assert "sheets" not in str(report)
    doubted = replace(report, doubts=("the surface may be rough",))
    assert not doubted.is_sound and "in doubt: the surface may be rough" in str(doubted)
    assert skeleton.resample(0.1).report.is_sound
