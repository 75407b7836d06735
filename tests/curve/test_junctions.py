"""Junctions of tubes are where the axes of their branches meet."""

from itertools import pairwise

import numpy as np
import pytest
import trimesh

import msf_jax
from msf_jax import shapes
from msf_jax.curve import junctions
from msf_jax.solid.enclosure import Enclosure
from msf_jax.topology import graphs
from tests.benchmarks import plants


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
    """`USUAL`, `AXIS`: it was in front of the crotch, where the ball is half as large."""
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


@pytest.mark.parametrize("degrees", [35, pytest.param(65, marks=pytest.mark.slow)])
def test_an_oblique_branch_begins_where_its_axis_meets_its_trunk(degrees):
    """`LATER`: its curve bends from the junction, where the rods part, and is on its axis only farther on."""
    turn = np.radians(degrees)
    way = np.array([np.cos(turn), np.sin(turn), 0])
    edges, radii = np.array([[0, 1], [0, 2], [0, 3]]), np.array([1.0, 1.0, 1.0, 0.7])
    mesh = shapes.solid_around(np.array([[0, 0, 0], [12, 0, 0], [-9, 0, 0], 12 * way]), edges, radii, 0.3)
    found = msf_jax.skeletonize(mesh)
    (junction,) = found.vertices[np.bincount(found.edges.ravel()) > 2]
    assert np.linalg.norm(junction) < 0.3


def test_two_junctions_where_rods_cross_come_to_one_place():
    """At 30 degrees, with a stretch between them: the axes of all other branches meet in its middle."""
    line, way = np.linspace(0, 1, 40)[1:, None], [[0.966, s * 0.259, 0] for s in (1, -1)]
    ends = [9 * u * np.array(each) for u in (1, -1) for each in way]
    edges = np.array([[0, 1], [0, 2], [0, 3], [0, 4]])
    mesh = shapes.solid_around(np.array([[0, 0, 0], *ends]), edges, np.ones(5), 0.3)
    middle = np.array([[4.5, 0, 0], [-4.5, 0, 0]])
    link = middle[0] + line[:-1] * (middle[1] - middle[0])
    bend = 9 * line / 5.5  # from there on, an arm is on its axis
    arms = [
        np.where(bend < 1, middle[k // 2] + bend * (5.5 / 9 * end - middle[k // 2]), line * end)
        for k, end in enumerate(ends)
    ]
    x = np.concatenate([middle, link, *arms])
    num = len(link)
    chains = [np.r_[0, 2 + np.arange(num), 1]]
    chains += [np.r_[k // 2, 2 + num + k * len(line) + np.arange(len(line))] for k in range(4)]
    edges = np.concatenate([np.stack([chain[:-1], chain[1:]], axis=1) for chain in chains])
    found = moved(Enclosure(np.asarray(mesh.vertices), np.asarray(mesh.faces)), x, edges)
    assert np.linalg.norm(found[chains[0]], axis=1).max() < 0.1
    x[chains[1][1:], 2] += 0.5  # beside the others: each junction has its own three branches
    found = moved(Enclosure(np.asarray(mesh.vertices), np.asarray(mesh.faces)), x, edges)
    assert np.linalg.norm(found[0] - found[1]) > 3


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


@pytest.mark.parametrize("radius", [1.5, 2.5])
def test_a_junction_in_a_blob_is_where_the_axes_meet(radius):
    """The middle of the ball is beside them."""
    _, x, edges, _ = fork(120, 0.3)
    blob = trimesh.creation.icosphere(subdivisions=3, radius=radius).apply_translation(x[0])
    mesh = trimesh.boolean.union([fork_mesh(120), blob], engine="manifold")
    shape = Enclosure(np.asarray(mesh.vertices), np.asarray(mesh.faces))
    assert np.linalg.norm(moved(shape, x, edges)[0]) < 0.05


def test_the_axis_of_a_side_branch_ends_at_the_first_stretch_of_trunk():
    """Of a trunk that turns back: it passes the first stretch at a tenth of a radius, and crosses the second."""
    x = np.array([[4, 0, -6], [4, 0, -1], [4, 0, 0], [4, 0, 1], [4, 0, 6], [0, 0, 6], [0, 0, 1], [0, 0, 0], [0, 0, -6]])
    x = np.concatenate([x + [0, 0, 0.0], [[4 + k, 0.1, 0] for k in (0.0, 1.0, 2.0, 3.0, 8.0)]])
    x[:5, 1] = -0.1
    edges = np.array([*pairwise(range(9)), (2, 9), *pairwise(range(9, 14))])
    side = junctions.Side(np.r_[2, 9:14], 0.3, x[10], 3, np.array([7.0, 0, 0]), np.array([1.0, 0, 0]))
    radii, is_trunk = np.where(np.arange(14) < 9, 1.0, 0.3), np.arange(len(edges)) < 8
    found = junctions.meeting(side, x, edges, is_trunk, radii)
    assert found is not None and found.edge in (1, 2)
    np.testing.assert_allclose(found.place, [4, -0.1, 0], atol=1e-9)


def test_a_held_junction_stays():
    shape, x, edges, _ = fork(30, 2.9)
    np.testing.assert_array_equal(moved(shape, x, edges, np.arange(len(x)) == 0), x)


def test_axes_that_are_nearly_parallel_meet_nowhere():
    """`SPREAD`: legs of a person, 12 degrees apart."""
    shape, x, edges, _ = fork(12, 6.0)
    np.testing.assert_array_equal(moved(shape, x, edges), x)


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
    found, found_edges = junctions.attached(shape, x, edges, held, shape.clearance(x))
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
    found, found_edges = junctions.attached(shape, x, edges, np.zeros(len(x), dtype=bool), shape.clearance(x))
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
    found, _ = junctions.attached(shape, x, edges, np.zeros(len(x), dtype=bool), radii)
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
    found, _ = junctions.attached(shape, x, edges, np.zeros(len(x), dtype=bool), shape.clearance(x))
    assert (len(found) > len(x)) == is_attached


def test_a_node_without_edges_is_no_side_branch():
    """A curve of one node, of a ball. No median is taken of nothing."""
    with np.errstate(all="raise"):
        sides, is_trunk = junctions.thin_sides(
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
    found, found_edges = junctions.attached(shape, x, edges, np.zeros(len(x), dtype=bool), radii)
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
    trunk, is_aside, is_part = junctions.bulged(x, edges, np.zeros(len(x), dtype=bool), shape.clearance(x))
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
    found, found_edges = junctions.attached(shape, x, edges, held, shape.clearance(x))
    assert np.abs(found[: len(x)][bend, 0]).max() < 0.05
    assert np.linalg.norm(found[np.bincount(found_edges.ravel()) > 2]) < 0.1


def test_a_side_branch_is_on_its_axis_where_it_is_beside_it_no_more():
    """`OFF`: nodes on a slight bend keep three quarters of the radius, and their line would miss the trunk's axis."""
    shape, x, edges, _ = side_branch(-8.0)
    bend = (x[:, 1] > 2.5) & (x[:, 1] < 4.2)
    x[bend, 0] = 0.24
    held, radii = np.zeros(len(x), dtype=bool), shape.clearance(x)
    radii[bend] = 0.8  # of a smooth tube; this one has corners
    found, found_edges = junctions.attached(shape, x, edges, held, radii)
    assert np.abs(found[: len(x)][bend, 0]).max() < 0.05
    assert np.linalg.norm(found[np.bincount(found_edges.ravel()) > 2]) < 0.1


def test_a_limb_that_is_nearly_as_thick_as_its_trunk_stays():
    """`THIN`: a T of equal tubes has no thin branch."""
    shape, x, edges, _ = fork(120, 0.3)
    assert len(junctions.attached(shape, x, edges, np.zeros(len(x), dtype=bool), shape.clearance(x))[0]) == len(x)


@pytest.mark.parametrize(("radius", "aside"), [(2.0, 0.0), (4.0, 0.22)])
def test_a_rod_meets_the_middle_of_a_ring(radius, aside):
    """Both ends of the loop begin at the one junction, and bend with a radius of four of theirs or more. In the flow's
    curve it was half a radius out in the rod, and more. `KEPT`: where they are ``aside`` later, they are on no axis."""

    def circle(angle, radius):
        return np.asarray(radius).reshape(-1, 1) * np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)

    points = np.concatenate([circle(np.linspace(0, 2 * np.pi, 48, endpoint=False), radius), [[radius + 6, 0, 0]]])
    edges = np.concatenate([np.stack([np.arange(48), (np.arange(48) + 1) % 48], axis=1), [[0, 48]]])
    mesh = shapes.solid_around(points, edges, np.full(49, 0.5), 0.25)
    # The curve: its junction is 0.4 out, and the ring comes there within a length of 0.5.
    first = np.array([radius + 0.4, 0, 0])
    angle = np.linspace(0.5, 2 * np.pi * radius - 0.5, 60) / radius
    beyond = radius * np.minimum(angle, 2 * np.pi - angle) - 1.0
    ring = circle(angle, radius + aside * np.exp(-((beyond / 0.3) ** 2)))
    share = np.linspace(0, 1, 4)[1:-1, None]
    loop = np.concatenate([first + share * (ring[0] - first), ring, ring[-1] + share * (first - ring[-1])])
    rod = first + np.linspace(0, 1, 30)[1:, None] * ([radius + 5.7, 0, 0] - first)
    x = np.concatenate([[first], loop, rod])
    chains = [[0, *range(1, len(loop) + 1), 0], [0, *range(len(loop) + 1, len(x))]]
    edges = np.concatenate([np.stack([chain[:-1], chain[1:]], axis=1) for chain in chains])
    shape = Enclosure(np.asarray(mesh.vertices), np.asarray(mesh.faces))
    found = junctions.met(shape, x, edges, np.zeros(len(x), dtype=bool), shape.approximate_clearance(x)[0])
    assert np.linalg.norm(found[0] - (radius, 0, 0)) < 0.3 * 0.5 and np.linalg.norm(x[0] - found[0]) > 0.25


@pytest.mark.parametrize(("aside", "is_met"), [(0.3, True), (0.55, False)])
def test_axes_that_pass_each_other_far_off_do_not_meet(aside, is_met):
    """`APART`: one branch beside the plane of the others, which leaves it a smaller ball."""
    shape, x, edges, chains = fork(120, 0.3)
    x[chains[1][1:], 1] += aside
    assert (moved(shape, x, edges)[0] != x[0]).any() == is_met


@pytest.mark.parametrize("radius", [0.3, 0.65])
def test_a_fat_ring_has_no_bend(radius):
    """Its curve turns back between the places three radii before and behind each node."""
    angle = np.linspace(0, 2 * np.pi, 61)
    x = np.stack([np.cos(angle), np.sin(angle), np.zeros(61)], axis=1)
    assert not junctions._bends(x, np.arange(61), np.full(61, radius))
