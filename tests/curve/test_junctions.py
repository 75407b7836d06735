"""Junctions of tubes are where the axes of their branches meet."""

import numpy as np
import pytest
import trimesh

import msf_jax
from msf_jax import shapes
from msf_jax.curve import junctions
from msf_jax.solid.enclosure import Enclosure
from msf_jax.topology import graphs


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


def ball_with(radius, limbs):
    """The curve of a ball around 0 with limbs: (from, to, radius) each; its junctions, and the run's report."""
    ball = trimesh.creation.icosphere(subdivisions=3, radius=radius)
    rods = [shapes.solid_around(np.array([p, q]), np.array([[0, 1]]), np.array([r, r]), 0.35) for p, q, r in limbs]
    found = msf_jax.skeletonize(trimesh.boolean.union([ball, *rods], engine="manifold"))
    return found.vertices[np.bincount(found.edges.ravel()) > 2], found


@pytest.mark.parametrize(("ball", "aside"), [(2.0, 0.8), (1.1, 0.2), pytest.param(2.0, 0.4, marks=pytest.mark.slow)])
def test_a_limb_is_on_its_own_behind_the_ball_that_it_leaves(ball, aside):
    """`BALL`: in there, the curve runs to the ball's middle, and its line misses the place where the axes meet."""
    meet, turn = np.array([aside, 0, 0.0]), np.radians(40)
    ways = [[np.cos(turn), np.sin(turn), 0], [np.cos(turn), -np.sin(turn), 0], [-1.0, 0, 0]]
    junctions, found = ball_with(ball, [(meet, meet + 7 * np.array(way), 0.5) for way in ways])
    assert len(junctions) == 1 and np.linalg.norm(junctions - meet) < 0.05
    assert found.report.is_sound


@pytest.mark.slow  # two limbs are below
def test_the_middle_of_a_ball_counts_where_axes_do_not_tell():
    """`SPREAD`: parallel but for 2 degrees of error, they had drawn the junction half a radius along themselves."""
    arms = [(np.array([0, y, 0]), np.array([7, y, 0]), 0.4) for y in (-1.0, 0.0, 1.0)]
    junctions, _ = ball_with(2.0, [*arms, (np.zeros(3), np.array([-7.0, 0, 0]), 0.52)])
    assert len(junctions) == 1 and np.linalg.norm(junctions) < 0.15


def arms_of(ball, bend):
    """The junctions of a ball with four arms of radius 0.5 that bend down with a radius ``bend``."""
    turn = np.linspace(0, min(2.0, 12 / bend), 14)
    arc = np.stack([0.6 * ball + bend * np.sin(turn), 0 * turn, bend * (np.cos(turn) - 1)], axis=1)
    solids = [trimesh.creation.icosphere(subdivisions=3, radius=ball)]
    for k in range(4):
        around = trimesh.transformations.rotation_matrix(np.pi / 2 * k, [0, 0, 1])[:3, :3]
        edges = np.stack([np.arange(13), np.arange(1, 14)], axis=1)
        solids.append(shapes.solid_around(arc @ around.T, edges, np.full(14, 0.5), 0.4))
    found = msf_jax.skeletonize(trimesh.boolean.union(solids, engine="manifold"))
    return found.vertices[np.bincount(found.edges.ravel()) > 2]


@pytest.mark.slow
@pytest.mark.parametrize(("ball", "bend"), [(3.0, 5.0), (5.0, 2.5)])
def test_a_limb_that_is_curved_is_not_prolonged_as_a_line(ball, bend):
    """Over four radii it looked straight; prolonged by six, it missed the ball's middle by 1.2 to 3.2."""
    junctions = arms_of(ball, bend)
    assert len(junctions) == 1 and np.linalg.norm(junctions) < 0.5


def test_limbs_that_leave_a_ball_side_by_side_begin_near_its_middle():
    """Two of 0.45, parallel, and one behind: the junction had been at their crotch, and aside."""
    arms = [(np.array([0, s * 0.7, 0]), np.array([7, s * 0.7, 0]), 0.45) for s in (1, -1)]
    junctions, found = ball_with(2.0, [*arms, (np.zeros(3), np.array([-7.0, 0, 0]), 0.6)])
    assert len(junctions) == 1 and np.abs(junctions[0]).max(initial=0) < 0.3 and abs(junctions[0, 1]) < 0.05
    x = np.asarray(found.vertices)
    for path in graphs.trace(len(x), found.edges):  # each turns into its axis gradually
        step = np.diff(x[path], axis=0)
        step /= np.linalg.norm(step, axis=1)[:, None]
        assert np.einsum("ki,ki->k", step[1:], step[:-1]).min() > np.cos(np.radians(15))


def test_a_branch_on_the_surface_has_no_axis():
    """Of an open part: its nodes have no radius, but for the one at a ball."""
    x, path = np.arange(6.0)[:, None] * [1.0, 0, 0], np.arange(6)
    assert junctions._own_stretch(x, path, 0.0, np.array([1.0, 0, 0, 0, 0, 0]), False, True) is None


def test_a_held_junction_stays():
    shape, x, edges, _ = fork(30, 2.9)
    np.testing.assert_array_equal(moved(shape, x, edges, np.arange(len(x)) == 0), x)


def test_axes_that_are_nearly_parallel_meet_nowhere():
    """`SPREAD`: legs of a person, 12 degrees apart."""
    shape, x, edges, _ = fork(12, 6.0)
    np.testing.assert_array_equal(moved(shape, x, edges), x)


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
