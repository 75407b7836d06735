"""Mitres of bars are no limbs, and limbs at their corners are."""

import numpy as np
import pytest
from limb_cases import Solid, as_shape, mitred, zigzag

from msf_jax.limbs import caps
from msf_jax.limbs.caps import Caps


def ends_of(solid: Solid, edge: float | None) -> int:
    return len(Caps(as_shape(solid, edge)).limbs(1.0).caps)


@pytest.mark.parametrize(("angle", "edge"), [(30, 0.35), (30, None), (45, 1.0), (60, 1.0), (60, None)])
def test_a_mitre_is_no_limb(angle, edge):
    turned = mitred(zigzag(angle, 2, 14.0)).rotate((20, 50, 70))
    assert ends_of(turned, edge) == 2


@pytest.mark.parametrize(("arms", "length"), [(4, 14.0), (3, 9.0)])
def test_letters_have_two_ends(arms, length):
    assert ends_of(mitred(zigzag(60 if length < 10 else 40, arms, length)), 1.0) == 2


def test_the_front_of_a_mitre_gets_longer_but_no_faster_than_its_distance():
    distance = 2.0 * np.exp(caps.MITRE_STEP * np.arange(12))
    assert caps._is_widening(distance) and caps._is_widening(4 + distance)
    assert caps._is_widening(np.r_[distance[:-2], 3 * distance[-2:]])  # about to divide
    assert not caps._is_widening(np.full(12, 4.0))
    assert not caps._is_widening(np.r_[4 + distance[:6], 4 + distance[:6]])
    assert not caps._is_widening(distance**1.3)
    assert not caps._is_widening(distance[:3])
    assert not caps._is_widening(np.exp(0.12 * np.arange(12)))  # 0.1 is the step, in their distance
    dip = 4 + distance
    dip[6:10] = dip[5]
    assert not caps._is_widening(dip)
