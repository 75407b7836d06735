"""Holes that repair fills."""

import numpy as np
import pytest
from repair_cases import BALL, FACES, VERTICES, assert_sound, volumes

from msf_jax.meshes import checking
from tests.benchmarks import faults


def test_holes_are_filled_without_new_vertices():
    keep = np.random.default_rng(1).random(len(FACES)) > 0.15
    found = checking.prepare((VERTICES, FACES[keep]), True)
    assert_sound(found, len(VERTICES))
    assert [part.genus for part in found.components] == [0]
    assert volumes(found)[0] == pytest.approx(BALL.volume, rel=0.02)
    assert sum("filled" in sentence for sentence in found.repairs) == 1


def test_a_flat_hole_is_filled_flat():
    """A box without its lid: 16 vertices around the hole, so 14 faces, and the volume is as before."""
    vertices, faces = faults.box()
    keep = vertices[faces][:, :, 2].min(axis=1) < 0.5
    found = checking.prepare((vertices, faces[keep]), True)
    assert found.repairs == ("filled 1 hole with 14 faces",)
    assert volumes(found) == pytest.approx([1.0])
