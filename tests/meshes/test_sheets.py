"""Walls inside, ribs and flanges: they go, and the solid stays."""

from itertools import pairwise

import numpy as np
import pytest
from repair_cases import BALL, FACES, VERTICES, assert_sound, volumes

from msf_jax.meshes import checking, sheets
from tests.benchmarks import faults


def test_a_wall_inside_goes_and_the_solid_stays():
    mesh = faults.topology_variants()["a wall inside"]
    found = checking.prepare(mesh, True)
    assert volumes(found) == pytest.approx([1.0])
    assert any(sentence.startswith("left out") for sentence in found.repairs)


@pytest.mark.parametrize(
    ("cells", "genus"), [(np.ones((3, 3, 2)), 0), (np.array([[1, 1, 1], [1, 0, 1], [1, 1, 1]]), 1)]
)
def test_walls_between_many_cells_go(cells, genus):
    """As many as four walls meet at an edge, turned this way or that; the solid is that of all cells together."""
    shifts = np.argwhere(np.atleast_3d(cells))
    vertices, faces = faults.welded(faults.joined(*(faults.box(shift) for shift in shifts)))
    is_turned = np.random.default_rng(5).random(len(faces)) < 0.5
    faces[is_turned] = faces[is_turned, ::-1]
    found = checking.prepare((vertices, faces), True)
    assert_sound(found, len(vertices))
    assert volumes(found) == pytest.approx([len(shifts)])
    assert [part.genus for part in found.components] == [genus]


def test_walls_that_a_hole_leads_to_stay():
    """What is seen from outside is no internal wall: a cell with a hole in its own outer face is open."""
    vertices, faces = faults.welded(faults.joined(faults.box(), faults.box((1, 0, 0))))
    faces = faces[np.sort(np.unique(np.sort(faces, axis=1), axis=0, return_index=True)[1])]
    hidden = sheets.is_wall(vertices, faces)
    assert (vertices[faces[hidden]][:, :, 0] == 0.5).all() and hidden.any()
    is_far = (vertices[faces][:, :, 0] == 1.5).all(axis=1)
    assert not sheets.is_wall(vertices, faces[np.arange(len(faces)) != np.flatnonzero(is_far)[0]]).any()


def test_ribs_and_a_flange_go_and_the_solid_stays():
    """Where every edge has a fin, no face of the solid is joined to another; a flange may have more faces than it."""
    edges = np.unique(np.sort(np.concatenate([FACES[:, [0, 1]], FACES[:, [1, 2]], FACES[:, [2, 0]]]), axis=1), axis=0)
    tips = 1.2 * VERTICES[edges].mean(axis=1)
    fins = np.column_stack([edges, len(VERTICES) + np.arange(len(edges))])
    found = checking.prepare((np.concatenate([VERTICES, tips]), np.concatenate([FACES, fins])), True)
    assert volumes(found) == pytest.approx([BALL.volume])
    vertices, faces = faults.box()
    rim = np.flatnonzero(vertices[:, 2] == 0)
    rim = rim[np.argsort(np.arctan2(vertices[rim, 1], vertices[rim, 0]))]
    rings = [rim]
    for step in range(1, 16):
        rings.append(len(vertices) + np.arange(len(rim)))
        vertices = np.concatenate([vertices, vertices[rim] * (1 + step / 5)])
    flange = [
        face
        for inner, outer in pairwise(rings)
        for a, b, c, d in zip(inner, np.roll(inner, -1), outer, np.roll(outer, -1), strict=True)
        for face in ([a, b, c], [b, d, c])
    ]
    assert len(flange) > len(faces)
    found = checking.prepare((vertices, np.concatenate([faces, flange])), True)
    assert volumes(found) == pytest.approx([1.0])


@pytest.mark.parametrize("seed", range(4))
def test_which_faces_were_turned_does_not_matter(seed):
    """Two boxes with a wall between them: the wall goes, whatever the orientation was."""
    mesh = faults.welded(faults.joined(faults.box(), faults.box((0, 0, 1))))
    middle = mesh[0][mesh[1]][:, :, 2]
    inner = np.flatnonzero((middle == 0.5).all(axis=1))
    keep = np.setdiff1d(np.arange(len(mesh[1])), inner[len(inner) // 2 :])  # one of the two lids
    faces = mesh[1][keep].copy()
    is_turned = np.random.default_rng(seed).random(len(faces)) < 0.5
    faces[is_turned] = faces[is_turned, ::-1]
    found = checking.prepare((mesh[0], faces), True)
    assert volumes(found) == pytest.approx([2.0])
