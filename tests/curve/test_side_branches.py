"""A thin side branch begins where its axis meets its trunk."""

from itertools import pairwise

import numpy as np
import pytest

import msf_jax
from msf_jax import shapes
from msf_jax.curve import side_branches
from msf_jax.solid.enclosure import Enclosure
from msf_jax.topology import graphs
from tests.benchmarks import plants


def test_the_axis_of_a_side_branch_ends_at_the_first_stretch_of_trunk():
    """Of a trunk that turns back: it passes the first stretch at a tenth of a radius, and crosses the second."""
    x = np.array([[4, 0, -6], [4, 0, -1], [4, 0, 0], [4, 0, 1], [4, 0, 6], [0, 0, 6], [0, 0, 1], [0, 0, 0], [0, 0, -6]])
    x = np.concatenate([x + [0, 0, 0.0], [[4 + k, 0.1, 0] for k in (0.0, 1.0, 2.0, 3.0, 8.0)]])
    x[:5, 1] = -0.1
    edges = np.array([*pairwise(range(9)), (2, 9), *pairwise(range(9, 14))])
    side = side_branches.Side(np.r_[2, 9:14], 0.3, x[10], 3, np.array([7.0, 0, 0]), np.array([1.0, 0, 0]))
    radii, is_trunk = np.where(np.arange(14) < 9, 1.0, 0.3), np.arange(len(edges)) < 8
    found = side_branches.meeting(side, x, edges, is_trunk, radii)
    assert found is not None and found.edge in (1, 2)
    np.testing.assert_allclose(found.place, [4, -0.1, 0], atol=1e-9)


def test_an_edge_without_length_does_not_part_a_trunk():
    """A side branch of 20 degrees: its axis comes near to the trunk above such an edge, and meets it below."""
    way = np.array([np.sin(np.radians(20)), 0, np.cos(np.radians(20))])
    trunk = np.array([6, 0.6, 0.3, 0.3, 0, -0.6, -6])[:, None] * [0, 0, 1.0]
    x = np.concatenate([trunk, np.array([3, 4, 6, 12])[:, None] * way])
    edges = np.array([*pairwise(range(7)), (0, 7), *pairwise(range(7, 11))])
    side = side_branches.Side(np.r_[0, 7:11], 0.3, x[7], 3, x[9], way)
    found = side_branches.meeting(side, x, edges, np.arange(len(edges)) < 6, np.where(np.arange(11) < 7, 1.0, 0.3))
    assert found is not None
    np.testing.assert_allclose(found.place, 0, atol=1e-9)


def side_branch(astray, num=60):
    """A solid of a trunk of radius 3 along z and a side branch of radius 1 from 0, 45 degrees up, and a curve whose
    side branch runs along the trunk for ``astray`` before it leaves it."""
    top = np.array([0, 30, 30])
    points = np.array([[0, 0, -30], [0, 0, 40], [0, 0, 0], top], dtype=float)
    mesh = shapes.solid_around(points, np.array([[0, 1], [2, 3]]), np.array([3.0, 3.0, 1.0, 1.0]), 1.0)
    line = np.linspace(0, 1, num)[:, None]
    trunk = points[0] + line * (points[1] - points[0])
    first = int(np.abs(trunk[:, 2] - astray).argmin())
    leaves = np.array([0, 0.5, 0.5])  # on the side branch's axis, in the trunk
    legs = np.concatenate(
        [trunk[first] + line[1:10] / line[9] * (leaves - trunk[first]), leaves + line * (top - leaves)]
    )
    chain = np.r_[first, num + np.arange(len(legs))]
    edges = np.concatenate([np.stack([c[:-1], c[1:]], axis=1) for c in (np.arange(num), chain)])
    return Enclosure(np.asarray(mesh.vertices), np.asarray(mesh.faces)), np.concatenate([trunk, legs]), edges, first


@pytest.mark.parametrize("astray", [-8.0, 8.0])
def test_a_side_branch_begins_where_its_axis_meets_the_trunk(astray):
    """`THIN`, `STRETCH`: wherever it ran along the trunk."""
    shape, x, edges, first = side_branch(astray)
    held = np.zeros(len(x), dtype=bool)
    found, found_edges = side_branches.attached(shape, x, edges, held, shape.clearance(x))
    degree = np.bincount(found_edges.ravel())
    assert (degree > 2).sum() == 1 and degree[first] == 2
    assert np.linalg.norm(found[degree > 2]) < 0.1
    assert len(found) == len(x) + 1 and len(found_edges) == len(edges) + 1
    np.testing.assert_array_equal(found[:60], x[:60])  # the trunk stays


def led(x, edges, first, places):
    """The curve of `side_branch` with the side branch from its ``first`` node through ``places`` to its axis."""
    stays = np.arange(len(x)) < 60
    stays[60:] = x[60:, 1] >= places[-1][1]
    chain = np.r_[first, len(x) + np.arange(len(places)), np.flatnonzero(stays)[60:]]
    trunk = edges[(edges < 60).all(axis=1)]
    x, edges = np.concatenate([x, places]), np.concatenate([trunk, np.stack([chain[:-1], chain[1:]], axis=1)])
    nodes, edges = np.unique(edges, return_inverse=True)
    return x[nodes], edges.reshape(-1, 2)


@pytest.mark.parametrize(
    ("places", "is_attached"),
    [
        ([[1.5, 0.0, z] for z in np.linspace(8, -2, 20)] + [[0.0, 2.5, 2.5]], True),  # beside the trunk's axis
        ([[0.5, 0.0, 6.0], [0.0, 1.0, 2.0], [0.0, 10.0, 10.0]], True),  # no node for 14 radii after it left the trunk
        ([[0.0, 2.0, 10.0], [0.0, 10.0, 10.0]], True),  # it leaves the trunk 3 of its radii from where the axes meet
        ([[0.0, 2.0, 20.0], [0.0, 5.0, 20.0], [0.0, 10.0, 10.0]], False),  # 7 of them
    ],
)
def test_a_side_branch_is_in_its_trunk_where_it_is_in_its_balls(places, is_attached):
    """`AXIS_REACH`: a stretch in the trunk is no axis, however straight, and it has at most four radii there."""
    shape, x, edges, first = side_branch(8.0)
    x, edges = led(x, edges, first, np.array(places))
    found, found_edges = side_branches.attached(shape, x, edges, np.zeros(len(x), dtype=bool), shape.clearance(x))
    (junction,) = np.flatnonzero(np.bincount(found_edges.ravel()) > 2)
    assert (np.linalg.norm(found[junction]) < 0.1) == is_attached
    assert len(found) == len(x) + is_attached


@pytest.mark.parametrize("height", [-11.0, 7.0, 11.0])
def test_a_side_branch_may_run_past_a_neighbour_in_its_trunk(height):
    """Its junction is 12 radii from where it should be, and another branch leaves the trunk in between."""
    shape, x, edges, _ = side_branch(12.0 * np.sign(height))
    start = int(np.abs(x[:60, 2] - height).argmin())
    other = x[start] - np.linspace(0, 20, 40)[1:, None] * [0.0, 1.0, 0.0]
    chain = np.r_[start, len(x) + np.arange(len(other))]
    radii = np.append(shape.clearance(x), np.where(other[:, 1] > -3, 2.0, 1.0))
    x, edges = np.concatenate([x, other]), np.concatenate([edges, np.stack([chain[:-1], chain[1:]], axis=1)])
    found, _ = side_branches.attached(shape, x, edges, np.zeros(len(x), dtype=bool), radii)
    assert np.linalg.norm(found[len(x) :], axis=1).min() < 0.1


@pytest.mark.slow
@pytest.mark.parametrize("seed", [2, 3])
def test_the_branches_of_a_plant_of_long_triangles_are_on_their_axes(seed):
    """Each of the two, of 35 axes, had one that was not: knots in the stem, where branches wander to the first ring
    outside of it, by an edge that is five of their radii long."""
    made = plants.plant(seed, 35)
    angle, winding, radius = plants.measured(msf_jax.skeletonize(made.mesh), made)
    assert len(angle) == 35
    assert angle.max() < 5 and winding.max() < 1.05 and np.abs(radius - 1).max() < 0.2


@pytest.mark.parametrize(("degrees", "below", "is_attached"), [(11.0, 40, False), (18.0, 40, True), (18.0, 0, False)])
def test_legs_are_side_branches_of_a_body_that_goes_on_at_an_angle(degrees, below, is_attached):
    """`AXIS_REACH`: nearly parallel, the axis of each meets the body's anywhere, one here and one there. A body that
    ends in two legs forks, and none of them is aside."""
    above = np.array([0, 0, 1.2 / np.tan(np.radians(degrees))])  # where the axes meet, above the fork of the curve
    feet = above + 40.0 * np.array(
        [[0, side * np.sin(np.radians(degrees)), -np.cos(np.radians(degrees))] for side in (-1, 1)]
    )
    points = np.array([[0, 0, -below], [0, 0, 40], above, *feet])
    mesh = shapes.solid_around(points, np.array([[0, 1], [2, 3], [2, 4]]), np.array([3.0, 3.0, 1.0, 1.0, 1.0]), 1.0)
    line = np.linspace(0, 1, 60)[:, None]
    legs = [above + line * (foot - above) for foot in feet]
    lines = [line * points[1], *(leg[leg[:, 2] < -1] for leg in legs), *([line[1:] * points[0]] if below else [])]
    x = np.concatenate(lines)
    first = np.cumsum([len(each) for each in lines])
    chains = [np.arange(60), *(np.r_[0, range(start, stop)] for start, stop in pairwise(first.tolist()))]
    edges = np.concatenate([np.stack([chain[:-1], chain[1:]], axis=1) for chain in chains])
    shape = Enclosure(np.asarray(mesh.vertices), np.asarray(mesh.faces))
    found, _ = side_branches.attached(shape, x, edges, np.zeros(len(x), dtype=bool), shape.clearance(x))
    assert (len(found) > len(x)) == is_attached


def test_a_node_without_edges_is_no_side_branch():
    """A curve of one node, of a ball. No median is taken of nothing."""
    with np.errstate(all="raise"):
        sides, is_trunk = side_branches.thin_sides(
            np.zeros((1, 3)), np.empty((0, 2), np.int64), np.zeros(1, bool), np.ones(1)
        )
    assert sides == [] and is_trunk.shape == (0,)


@pytest.mark.slow
@pytest.mark.parametrize("noise", [0.0, 1e-5])
@pytest.mark.parametrize(("degrees", "length"), [(45.0, 3.4), (45.0, 4.0), (60.0, 2.4), (60.0, 3.7)])
def test_a_side_branch_may_fork_soon(degrees, length, noise):
    """Its axis has one radius of its own and more. It had to have nine: with less, the trunk's junction was beside its
    place by .6 to 1.1 of the trunk's radius. It was again where rounding put the flow's nodes a little off its axis."""
    angle = np.radians(degrees + np.array([0.0, -35.0, 35.0]))
    heading = np.stack([np.sin(angle), np.zeros(3), np.cos(angle)], axis=1)
    fork = length * heading[0]
    points = np.array([[0, 0, -6], [0, 0, 10], [0, 0, 0], fork, *(fork + 4 * heading[1:])])
    edges, radii = np.array([[0, 1], [2, 3], [3, 4], [3, 5]]), np.array([1.0, 1.0, 0.3, 0.3, 0.24, 0.24])
    mesh = shapes.solid_around(points, edges, radii, 0.3)
    moved = mesh.vertices + noise * np.random.default_rng(4).normal(size=mesh.vertices.shape)
    found = msf_jax.skeletonize((moved, np.array(mesh.faces)))
    junctions_found = found.vertices[np.bincount(found.edges.ravel()) > 2]
    assert len(junctions_found) == 2 and found.num_leaves == 4
    assert np.linalg.norm(junctions_found, axis=1).min() < 0.15
    assert np.linalg.norm(junctions_found - fork, axis=1).min() < 0.15


@pytest.mark.parametrize("bend", [0.0, 2.0])
def test_a_side_branch_that_forks_itself_begins_where_its_axis_meets_the_trunk(bend):
    """Only a straight one: a limb that bends, such as an arm with a hand, stays as it was centred. `BENT`."""
    shape, x, edges, first = side_branch(8.0)
    chain = 60 + np.arange(len(x) - 60)
    fork = chain[np.abs(x[chain, 2] - 20).argmin()]
    x[chain, 0] += bend * np.sin(np.pi * np.clip(x[chain, 2] / 20, 0, 1))
    line = x[fork] + np.linspace(0, 8, 20)[1:, None] * [1.0, 0, 0]
    ids = np.r_[fork, len(x) + np.arange(len(line))]
    x, edges = np.concatenate([x, line]), np.concatenate([edges, np.stack([ids[:-1], ids[1:]], axis=1)])
    radii = np.append(shape.clearance(x[: -len(line)]), np.full(len(line), 0.5))  # as of a branch of half its radius
    found, found_edges = side_branches.attached(shape, x, edges, np.zeros(len(x), dtype=bool), radii)
    assert graphs.cycle_count(len(found), found_edges) == (1, 0)
    degree = np.bincount(found_edges.ravel())
    if bend:
        assert len(found) == len(x) and degree[first] == 3
    else:
        assert degree[first] == 2 and sorted(np.flatnonzero(degree > 2)) == [fork, len(x)]
        assert np.linalg.norm(found[len(x)]) < 0.1


def test_sections_of_a_trunk_do_not_count_where_a_side_branch_leaves_it():
    """`BULGE`: the axis of the side branch leaves the trunk at a height of 3, and the branch from 1.6 to 4.4."""
    shape, x, edges, _ = side_branch(8.0)
    trunk, is_aside, is_part = side_branches.bulged(x, edges, np.zeros(len(x), dtype=bool), shape.clearance(x))
    assert len(trunk) == 59 and is_part[:60].all() and not is_part[60:].any()
    height = x[is_aside, 2]
    assert not is_aside[60:].any() and -0.5 < height.min() < 1.5 and 4.3 < height.max() < 6.0
    inner = (x[:60, 2] > 1.6) & (x[:60, 2] < 4.4)
    assert is_aside[:60][inner].all()


def test_a_side_branch_is_on_its_axis_where_it_keeps_its_radius():
    """`KEPT`: nodes on a bend beside its axis are nearer to the surface, and its line begins beyond them."""
    shape, x, edges, _ = side_branch(-8.0)
    bend = (x[:, 1] > 4) & (x[:, 1] < 7)
    x[bend, 0] = 0.6
    held = np.zeros(len(x), dtype=bool)
    found, found_edges = side_branches.attached(shape, x, edges, held, shape.clearance(x))
    assert np.abs(found[: len(x)][bend, 0]).max() < 0.05
    assert np.linalg.norm(found[np.bincount(found_edges.ravel()) > 2]) < 0.1


def test_a_side_branch_is_on_its_axis_where_it_is_beside_it_no_more():
    """`OFF`: nodes on a slight bend keep three quarters of the radius, and their line would miss the trunk's axis."""
    shape, x, edges, _ = side_branch(-8.0)
    bend = (x[:, 1] > 2.5) & (x[:, 1] < 4.2)
    x[bend, 0] = 0.24
    held, radii = np.zeros(len(x), dtype=bool), shape.clearance(x)
    radii[bend] = 0.8  # of a smooth tube; this one has corners
    found, found_edges = side_branches.attached(shape, x, edges, held, radii)
    assert np.abs(found[: len(x)][bend, 0]).max() < 0.05
    assert np.linalg.norm(found[np.bincount(found_edges.ravel()) > 2]) < 0.1


def test_a_limb_that_is_nearly_as_thick_as_its_trunk_stays():
    """`THIN`: a T whose stem has seven tenths of the radius has no thin branch."""
    ends, radii = np.array([[0, 0, -9], [0, 0, 9], [9, 0, 0.0]]), np.array([1.0, 1.0, 1.0, 0.7, 0.7])
    mesh = shapes.solid_around(
        np.r_[np.zeros((1, 3)), ends[:2], np.zeros((1, 3)), ends[2:]], np.array([[0, 1], [0, 2], [3, 4]]), radii, 0.3
    )
    shape, line = Enclosure(np.asarray(mesh.vertices), np.asarray(mesh.faces)), np.linspace(0, 0.97, 40)[1:, None]
    x = np.concatenate([np.zeros((1, 3)), *(line * end for end in ends)])
    chains = [np.r_[0, 1 + k * len(line) + np.arange(len(line))] for k in range(3)]
    edges = np.concatenate([np.stack([chain[:-1], chain[1:]], axis=1) for chain in chains])
    assert not side_branches.thin_sides(x, edges, np.zeros(len(x), dtype=bool), shape.clearance(x))[0]
