"""Mitres of bars are no limbs, and limbs at their corners are."""

import manifold3d
import numpy as np
import pytest
from limb_cases import Solid, as_shape, box, mitred, zigzag

from msf_jax.limbs import mitre
from msf_jax.limbs.caps import Caps


def ends_of(solid: Solid, edge: float | None) -> int:
    return len(Caps(as_shape(solid, edge)).limbs(1.0).caps)


def union(*solids: Solid) -> Solid:
    return Solid.batch_boolean(list(solids), manifold3d.OpType.Add)


def letter_a(angle: float) -> Solid:
    axis = zigzag(angle, 2, 16.0)
    bar = np.stack([0.4 * axis[1] + 0.6 * axis[0], 0.4 * axis[1] + 0.6 * axis[2]])
    return union(mitred(axis), mitred(bar))


def with_stem(angle: float, out: float, width: float = 2.0) -> Solid:
    """Two bars, and a third one that sticks out of their mitre by ``out`` half widths."""
    axis = zigzag(angle, 2, 14.0)
    length = 1 / np.sin(np.radians(angle / 2)) + out
    return union(mitred(axis), box(width, length, 2).translate(axis[1] + [0, length / 2, 0]))


@pytest.mark.parametrize(("angle", "edge"), [(30, 0.35), (30, None), (45, 1.0), (60, 1.0), (60, None)])
def test_a_mitre_is_no_limb(angle, edge):
    turned = mitred(zigzag(angle, 2, 14.0)).rotate((20, 50, 70))
    assert ends_of(turned, edge) == 2


@pytest.mark.parametrize(("arms", "length"), [(4, 14.0), (3, 9.0)])
def test_letters_have_two_ends(arms, length):
    assert ends_of(mitred(zigzag(60 if length < 10 else 40, arms, length)), 1.0) == 2


@pytest.mark.parametrize("angle", [30, 60])
def test_an_apex_over_a_handle_is_no_limb(angle):
    assert ends_of(letter_a(angle), 1.0) == 2


def cone(angle: float) -> Solid:
    """A cone on the corner of two bars."""
    axis = zigzag(angle, 2, 14.0)
    return union(mitred(axis), Solid.cylinder(8, 1, 0, 32).rotate((-90, 0, 0)).translate(axis[1]))


@pytest.mark.parametrize("angle", [40, 60])
def test_a_limb_at_a_corner_stays(angle):
    for stem in (with_stem(angle, 2.5), cone(angle)):
        assert ends_of(stem, 0.5) == 3


def test_arms_of_a_star_stay():
    arms = [box(6, 1.2, 1.2).translate((3, 0, 0)).rotate((0, 0, 72 * number)) for number in range(5)]
    assert ends_of(union(*arms), 0.35) == 5


@pytest.mark.parametrize(("out", "is_apex"), [(0.0, True), (0.6, True), (1.4, False), (4.0, False)])
def test_a_limb_sticks_out_of_both_bars(out, is_apex):
    """By more than it needs, in half widths."""
    shape = as_shape(with_stem(60, out, 0.2), 0.35)
    caps = Caps(shape)
    tip = int(((caps.shape.vertices - zigzag(60, 2, 14.0)[1] - [0, 2 + out, 0]) ** 2).sum(axis=1).argmin())
    away = caps._distances(np.array([tip]))
    assert mitre.is_apex(caps.shape, away, np.flatnonzero(away < 3.0), 1.0) is is_apex


def test_the_front_of_a_mitre_gets_longer_but_no_faster_than_its_distance():
    distance = 2.0 * np.exp(mitre.STEP * np.arange(12))
    assert mitre._is_widening(distance) and mitre._is_widening(4 + distance)
    assert mitre._is_widening(np.r_[distance[:-2], 3 * distance[-2:]])  # about to divide
    assert not mitre._is_widening(np.full(12, 4.0))
    assert not mitre._is_widening(np.r_[4 + distance[:6], 4 + distance[:6]])
    assert not mitre._is_widening(distance**1.3)
    assert not mitre._is_widening(distance[:3])
    assert not mitre._is_widening(np.exp(0.12 * np.arange(12)))  # 0.1 is the step, in their distance
    dip = 4 + distance
    dip[6:10] = dip[5]
    assert not mitre._is_widening(dip)
