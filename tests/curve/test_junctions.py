"""Junctions are where the axes of their branches meet."""

from itertools import pairwise

import numpy as np
import pytest
import trimesh

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
    """It was in front of the crotch, where the ball is half as large."""
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


def test_rods_that_cross_at_one_place_have_one_junction():
    """The flow has two, with a stretch between on the bisector, in front of both crotches."""
    way = np.array([[np.sin(0.35), 0, np.cos(0.35)], [-np.sin(0.35), 0, np.cos(0.35)]])
    rods = np.concatenate([9 * way, -9 * way])
    mesh = shapes.solid_around(rods, np.array([[0, 2], [1, 3]]), np.ones(4), 0.3)
    line, crotch = np.linspace(0, 1, 40)[1:, None], np.array([0, 0, 1.2])
    legs = [
        np.where(line < 0.4, end + line / 0.4 * (0.4 * rod - end), line * rod)
        for end, rod in zip((crotch, crotch, -crotch, -crotch), rods, strict=True)
    ]
    x = np.concatenate([[crotch, -crotch], np.linspace(crotch, -crotch, 7)[1:-1], *legs])
    chains = [np.r_[0, 2:7, 1], *(np.r_[k // 2, 7 + 39 * k + np.arange(39)] for k in range(4))]
    edges = np.concatenate([np.stack([chain[:-1], chain[1:]], axis=1) for chain in chains])
    shape = Enclosure(np.asarray(mesh.vertices), np.asarray(mesh.faces))
    found = moved(shape, x, edges)
    assert np.linalg.norm(found[:7], axis=1).max() < 0.15


def test_a_branch_on_the_surface_has_no_axis():
    """Of an open part: its nodes have no radius, but for the one at a ball."""
    x, edges = np.arange(6.0)[:, None] * [1.0, 0, 0], np.array([*pairwise(range(6))])
    curve = junctions.Branches(x, edges, np.array([1.0, 0, 0, 0, 0, 0]))
    assert curve.axis(np.arange(6)) is None


def test_a_held_junction_stays():
    shape, x, edges, _ = fork(30, 2.9)
    np.testing.assert_array_equal(moved(shape, x, edges, np.arange(len(x)) == 0), x)


BASES = np.array([[0, 0, 0], [0, 0, 12.0], [0, 0, 20]])
TOPS = np.array([[0, 30, 30], [0, -30, -18.0], [30, 0, 50]])


def side_branches(*heights, num=60):
    """A solid of a trunk of radius 3 along z and side branches of radius 1 from `BASES` to `TOPS`, and a curve whose
    side branches run along the trunk and leave it at ``heights``; the nodes where they do."""
    line, count = np.linspace(0, 1, num)[:, None], len(heights)
    points = np.concatenate([[[0, 0, -30], [0, 0, 40]], BASES[:count], TOPS[:count]])
    ends = np.array([[0, 1], *([2 + k, 2 + count + k] for k in range(count))])
    mesh = shapes.solid_around(points, ends, np.array([3.0, 3.0] + 2 * count * [1.0]), 1.0)
    x = points[0] + line * (points[1] - points[0])
    first = [int(np.abs(x[:num, 2] - height).argmin()) for height in heights]
    edges = [np.stack([np.arange(num - 1), np.arange(1, num)], axis=1)]
    for node, base, top in zip(first, BASES, TOPS, strict=False):
        start = base + 0.0167 * (top - base)  # on the side branch's axis, in the trunk
        legs = np.concatenate([x[node] + line[1:10] / line[9] * (start - x[node]), start + line * (top - start)])
        chain = np.r_[node, len(x) + np.arange(len(legs))]
        x, edges = np.concatenate([x, legs]), [*edges, np.stack([chain[:-1], chain[1:]], axis=1)]
    return Enclosure(np.asarray(mesh.vertices), np.asarray(mesh.faces)), x, np.concatenate(edges), first


@pytest.mark.parametrize("heights", [(-8.0,), (8.0,), (5.0, 7.5), (5.0, 7.5, 9.5)])
def test_a_side_branch_begins_where_its_axis_meets_the_trunk(heights):
    """Wherever it ran along the trunk, and also where the trunk is too short for an axis between them."""
    shape, x, edges, first = side_branches(*heights)
    found = moved(shape, moved(shape, x, edges), edges)  # as a run does: one between two others comes after them
    assert (np.linalg.norm(x[first] - BASES[: len(first)], axis=1) > 4).all()
    assert np.linalg.norm(found[first] - BASES[: len(first)], axis=1).max() < 0.2
    assert np.abs(found[:60, :2]).max() < 0.1 and (np.diff(found[:60, 2]) > 0).all()  # the trunk stays in order


def test_a_junction_in_a_ball_with_thin_branches_is_its_middle():
    """The axes of neurites pass the middle of their soma, each on a side of its own."""
    way = np.array([[1.0, 0, 0], [-0.5, 0.8, 0.2], [-0.4, -0.9, 0.3]])
    way /= np.linalg.norm(way, axis=1)[:, None]
    beside = 1.5 * np.cross(way, [0, 0, 1.0])
    tubes = [
        trimesh.creation.cylinder(0.8, segment=[side + 3 * along, side + 20 * along], sections=12)
        for along, side in zip(way, beside, strict=True)
    ]
    mesh = trimesh.boolean.union([trimesh.creation.icosphere(3, 5.0), *tubes])
    first = np.array([[1.0, -1.0, 0.5]])
    legs = [side + np.linspace(2, 19, 35)[:, None] * along for along, side in zip(way, beside, strict=True)]
    edges = np.concatenate([np.stack([np.r_[0, k + 1 : k + 35], k + 1 + np.arange(35)], axis=1) for k in (0, 35, 70)])
    found = moved(Enclosure(np.asarray(mesh.vertices), np.asarray(mesh.faces)), np.concatenate([first, *legs]), edges)
    assert np.linalg.norm(found[0]) < 0.1 * 5


@pytest.mark.parametrize(("aside", "moves"), [(0.6, False), (1.8, True)])
def test_a_junction_at_the_wall_of_a_trunk_meets_lines_that_pass_each_other(aside, moves):
    """The trunk's two sides run 0.45 of its radius beside its axis. Its ball tells, and not that of the thin branch."""
    shape, x, edges, (first,) = side_branches(0.0)
    height = np.clip(x[:60, 2] - x[first, 2], -1.0, 1.0)
    x[:60, 0] += 1.35 * height
    x[first, 1] += aside
    assert 1.0 < shape.clearance(x[[first]])[0] < 2.6
    assert (np.abs(moved(shape, x, edges)[first] - x[first]).max() > 0.5) == moves
