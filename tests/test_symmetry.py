"""The mirror images of a surface in itself, and limbs that are limbs on both sides or on none."""

import numpy as np
import pytest

from msf_jax.limbs import symmetry
from msf_jax.limbs.caps import Caps
from msf_jax.solid.enclosure import Enclosure
from tests.test_ends import Solid, as_shape, box

TURN = np.linalg.qr(np.random.default_rng(3).normal(size=(3, 3)))[0]


def moved(solid: Solid, noise: float = 0.0, bend: float = 0.0) -> Enclosure:
    """The solid at a diagonal of 1, and turned. Its upper half is shifted in x, to and fro, by up to ``bend``."""
    shape = as_shape(solid, 0.1)
    x = shape.vertices / np.linalg.norm(np.ptp(shape.vertices, axis=0))
    x = x + np.random.default_rng(1).normal(0, noise, x.shape) * (noise > 0)
    x[:, 0] += bend * np.sin(2 * np.pi * x[:, 1] / np.ptp(x[:, 1])) * np.sign(x[:, 2])
    return Enclosure(x @ TURN, shape.faces)


def images_of(shape: Enclosure) -> list[np.ndarray]:
    corners = shape.vertices[shape.faces]
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
    share = np.bincount(shape.faces.ravel(), np.repeat(area / 3, 3))
    return symmetry.images(shape, share, np.zeros(len(share), dtype=np.int64))


def test_a_box_has_three_planes_and_the_images_in_all_of_them():
    shape = moved(box(5, 3, 1.6))
    found = images_of(shape)
    assert len(found) == 7
    x, spacing = shape.vertices @ TURN.T, 0.04
    for signs in ([-1, 1, 1], [1, -1, 1], [-1, -1, 1], [-1, -1, -1]):
        away = [np.linalg.norm(x[image] - x * signs, axis=1).max() for image in found]
        assert min(away) < spacing


@pytest.mark.parametrize(("bend", "num"), [(0.0, 7), (0.004, 7), (0.008, 0)])
def test_what_is_symmetric_has_its_images_on_its_surface(bend, num):
    """`FARTHEST_IMAGE`: the images of a bent box are 0.57 of the bend from its surface in the mean, in each plane."""
    assert len(images_of(moved(box(5, 3, 1.6), bend=bend))) == num


def with_feet(first: float, second: float) -> Solid:
    """A box with two feet of these heights, round rods with round ends, on one of its sides."""
    solid = box(5, 3, 1.6)
    for x, height in ((1.2, first), (-1.2, second)):
        foot = Solid.cylinder(0.8 + height - 0.3, 0.3, 0.3, 24) + Solid.sphere(0.3, 24).translate((0, 0, 0.5 + height))
        solid += foot.translate((x, 0, 0))
    return solid


def feet(shape: Enclosure, detail: float) -> tuple[int, list[float]]:
    """How many feet are limbs, and the details of others."""
    limbs = Caps(shape, detail).limbs(1.0)
    height = (shape.vertices @ TURN.T)[:, 2]
    return sum(height[cap.tip] > 0.2 for cap in limbs.caps), [
        each.detail for each in limbs.finer if height[each.cap.tip] > 0.2
    ]


def test_two_feet_of_a_symmetric_body_are_of_one_detail():
    _, details = feet(moved(with_feet(0.45, 0.45), noise=0.001), 0.0)
    assert len(details) == 2 and details[0] == details[1]


def horns(first: float, second: float) -> int:
    """How many of two rods of these lengths, on one end of a box, are limbs by their slenderness."""
    solid = box(5, 3, 1.6)
    for y, length in ((1.1, first), (-1.1, second)):
        solid += Solid.cylinder(1 + length, 0.3, 0.3, 24).rotate((0, 90, 0)).translate((1.5, y, 0))
    shape = moved(solid)
    x = shape.vertices @ TURN.T
    tips = x[[cap.tip for cap in Caps(shape, 0.0).limbs(1.0).caps]]
    return int(((tips[:, 0] > x[:, 0].max() - 0.05) & (np.abs(tips[:, 1]) > 0.1)).sum())


def test_a_horn_is_a_limb_on_both_sides():
    """The shorter one alone would be none; the solid is 0.002 diagonals off its mirror image."""
    assert horns(0.4, 0.3) == 2
    assert horns(0.3, 0.3) < 2
