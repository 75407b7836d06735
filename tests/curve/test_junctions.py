"""Junctions of tubes are where the axes of their branches meet."""

import numpy as np
import pytest

from msf_jax import shapes
from msf_jax.curve import junctions
from msf_jax.solid.enclosure import Enclosure


def ways(degrees):
    """(2, 3) the directions of the daughters of a fork."""
    angle = np.radians(degrees / 2)
    return np.array([[np.sin(angle), 0, np.cos(angle)], [-np.sin(angle), 0, np.cos(angle)]])


def fork_mesh(degrees):
    points = np.concatenate([[[0, 0, 0], [0, 0, -8]], 10 * ways(degrees)])
    return shapes.solid_around(points, np.array([[0, 1], [0, 2], [0, 3]]), np.array([1.0, 1.0, 0.8, 0.8]), 0.3)


def fork(degrees, first, num=40):
    """A solid of a trunk and two daughters that meet at 0, and a curve whose junction is ``first`` above it."""
    way, mesh = ways(degrees), fork_mesh(degrees)
    line = np.linspace(0, 1, num)[1:, None]
    crotch = np.array([0, 0, first])
    trunk = crotch + line * ([0, 0, -7.7] - crotch)
    clear = first + 0.7  # from there on, a leg is on its axis
    legs = [
        np.where(9.7 * line < clear, crotch + 9.7 * line / clear * (clear * each - crotch), 9.7 * line * each)
        for each in way
    ]
    x = np.concatenate([[crotch], trunk, *legs])
    chains = [np.r_[0, 1 + k * (num - 1) + np.arange(num - 1)] for k in range(3)]
    edges = np.concatenate([np.stack([chain[:-1], chain[1:]], axis=1) for chain in chains])
    return Enclosure(np.asarray(mesh.vertices), np.asarray(mesh.faces)), x, edges, chains


def moved(shape, x, edges, is_held=None):
    radii = shape.clearance(x)
    return junctions.met(shape, x, edges, np.zeros(len(x), dtype=bool) if is_held is None else is_held, radii)


def test_the_junction_of_a_narrow_fork_is_where_its_axes_meet():
    """`AXIS`: it was in front of the crotch, where the ball is half as large."""
    shape, x, edges, chains = fork(30, 2.9)
    assert shape.clearance(x[:1])[0] < 0.6
    found = moved(shape, x, edges)
    assert np.linalg.norm(found[0]) < 0.5
    assert shape.clearance(found[[0, *chains[1][:20], *chains[2][:20]]]).min() > 0.75
    for chain, sign in zip(chains[1:], (1, -1), strict=True):
        axis = np.array([sign * np.sin(np.radians(15)), 0, np.cos(np.radians(15))])
        off = np.linalg.norm(np.cross(found[chain], axis), axis=1)
        assert off.max() < 0.3


@pytest.mark.parametrize(("degrees", "first"), [(20, 4.5), (30, 2.9)])
def test_branches_of_a_fork_do_not_run_back_along_themselves(degrees, first):
    """Each lies on its line by its own arc length, from before the junction moved."""
    shape, x, edges, chains = fork(degrees, first)
    found = moved(shape, x, edges)
    assert np.linalg.norm(found[0] - x[0]) > 1.0
    for chain in chains:
        step = np.diff(found[chain], axis=0)
        assert np.einsum("ki,ki->k", step[1:], step[:-1]).min() > 0


@pytest.mark.parametrize("degrees", [60, 120, 180])
@pytest.mark.parametrize("off", [0.2, 0.3])
def test_the_junction_of_a_wide_fork_is_where_its_axes_meet(degrees, off):
    """The ball beside the axes is larger; in a T of equal tubes by 5 / 4, at 1 / 4 of the radius."""
    shape, x, edges, _ = fork(degrees, -off if degrees == 180 else off)
    found = moved(shape, x, edges)
    assert np.linalg.norm(found[0]) < 0.05
    np.testing.assert_array_equal(found[[20, 60, 100]], x[[20, 60, 100]])  # farther on, branches stay


def bend(degrees, below, ball=0.0, num=60):
    """A solid of two rods that meet at 0, with a ball there, and a curve that turns ``below`` that."""
    rods = 12 * ways(degrees)
    mesh = shapes.solid_around(
        np.array([[0.0, 0, 0], *rods]), np.array([[0, 1], [0, 2]]), np.array([max(ball, 1.0), 1.0, 1.0]), 0.3
    )
    line = np.linspace(0, 1, num)[:, None]
    turn = np.array([0, 0, below])
    sides = [np.where(line < 0.4, turn + line / 0.4 * (0.4 * rod - turn), line * rod) for rod in rods]
    x = np.concatenate([sides[0][:0:-1], sides[1]])
    return (
        Enclosure(np.asarray(mesh.vertices), np.asarray(mesh.faces)),
        x,
        np.stack([np.arange(len(x))] * 2, 1)[:-1] + [0, 1],
    )


@pytest.mark.parametrize(("degrees", "below", "ball"), [(30, 3.0, 0.0), (60, 1.5, 0.0), (60, 1.5, 2.5)])
def test_an_acute_bend_is_where_its_axes_meet(degrees, below, ball):
    shape, x, edges = bend(degrees, below, ball)
    found = moved(shape, x, edges)
    assert np.linalg.norm(found, axis=1).min() < 0.2
    away = np.minimum(*[np.linalg.norm(np.cross(found, way), axis=1) for way in ways(degrees)])
    assert away.max() < 0.2 and x[:, 2].min() > below - 0.1


def test_a_bend_of_a_right_angle_stays():
    shape, x, edges = bend(100, 0.7)
    np.testing.assert_array_equal(moved(shape, x, edges), x)


def test_a_branch_on_the_surface_has_no_axis():
    """Of an open part: its nodes have no radius, but for the one at a ball."""
    x, path = np.arange(6.0)[:, None] * [1.0, 0, 0], np.arange(6)
    assert junctions._own_stretch(x, path, 0.0, np.array([1.0, 0, 0, 0, 0, 0]), False, True) is None


def test_a_held_junction_stays():
    shape, x, edges, _ = fork(30, 2.9)
    np.testing.assert_array_equal(moved(shape, x, edges, np.arange(len(x)) == 0), x)
