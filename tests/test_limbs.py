"""Slenderness of branches: closed forms in solids whose limbs are known, and pruning against a plain search."""

from itertools import pairwise

import manifold3d
import networkx as nx
import numpy as np
import pytest
import trimesh
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation
from test_branches import GRAPHS, NONE, as_edges, chain, degrees, graphs

from msf_jax.host.curve import limbs
from msf_jax.host.curve.limbs import Limbs, Pruning, limbs_of, limbs_without, measure, prune
from msf_jax.host.solid.enclosure import Enclosure

Curve = tuple[np.ndarray, np.ndarray]


def solid(found: manifold3d.Manifold, edge: float = 0.25) -> Enclosure:
    mesh = found.refine_to_length(edge).to_mesh()
    return Enclosure(np.array(mesh.vert_properties[:, :3], dtype=float), np.array(mesh.tri_verts, dtype=np.int64))


def legs(*polylines: list, step: float = 0.05) -> Curve:
    """Branches out of one node, where all courses begin, each a polyline with a node every ``step``, the leaf last."""
    vertices, pairs = [np.array(polylines[0][0], dtype=float)], []
    for polyline in polylines:
        last = 0
        for a, b in pairwise(np.array(polyline, dtype=float)):
            num = max(1, round(np.linalg.norm(b - a) / step))
            new = range(len(vertices), len(vertices) + num)
            vertices += list(a + np.arange(1, num + 1)[:, None] / num * (b - a))
            pairs += chain(last, *new)
            last = new[-1]
    return np.array(vertices), as_edges(pairs)


def by_leaf(vertices: np.ndarray, edges: np.ndarray, found: Limbs) -> dict[int, float]:
    """The slenderness of the branches that end in leaves."""
    degree = degrees(len(vertices), edges)
    branches = measure(vertices, edges, found)
    return {leaf: one.slenderness for one in branches for leaf in one.nodes if degree[leaf] == 1}


def of_last(shape: Enclosure, curve: Curve) -> float:
    return by_leaf(*curve, limbs_of(shape, *curve))[len(curve[0]) - 1]


# Closed forms: a limb upward, out of a block of 4 x 4 x 2 whose top is at height 0


def block() -> manifold3d.Manifold:
    return manifold3d.Manifold.cube((4, 4, 2), True).translate((0, 0, -1))


def up(top: float) -> Curve:
    """A trunk through the block, and from its middle a branch up to the height ``top``."""
    return legs([(0, 0, -1.02), (1.4, 0, -1)], [(0, 0, -1.02), (-1.4, 0, -1)], [(0, 0, -1.02), (0, 0, top)])


def round_limb(height: float, low: float, high: float) -> manifold3d.Manifold:
    """A cylinder or a cone, which begins in the block, where it is as wide as at height 0."""
    shaft = manifold3d.Manifold.cylinder(0.5, low, low, 48).translate((0, 0, -0.5))
    return manifold3d.Manifold.cylinder(height, low, high, 48) + shaft


def sheet(outline: np.ndarray, thickness: float = 0.1) -> manifold3d.Manifold:
    """What is within an outline (k, 2) of the plane y = 0, so thick."""
    flat = manifold3d.Manifold.extrude(manifold3d.CrossSection([outline.tolist()]), thickness)
    return flat.translate((0, 0, -thickness / 2)).rotate((90, 0, 0))


BLADE = np.array([[0.5, -0.5], [0.5, 4], [-0.5, 4], [-0.5, -0.5]])


def half_ellipse(across: float, height: float) -> np.ndarray:
    angle = np.linspace(0, np.pi, 49)
    arc = np.stack([across * np.cos(angle), height * np.sin(angle)], axis=1)
    return np.concatenate([arc, [[-across, -0.5], [across, -0.5]]])


@pytest.mark.parametrize("height", [0.3, 0.8, 2.0, 4.0])
def test_a_cylinder_has_its_length_over_its_radius(height):
    """As far as nodes tell where it begins. What is ahead of the leaf counts as a cone, since most ends are round."""
    radius, ahead, step = 0.4, 0.05, 0.05
    shape = solid(block() + round_limb(height, radius, radius))
    found = of_last(shape, up(height - ahead))
    assert found == pytest.approx((height - ahead / 2) / radius, abs=0.6 * step / radius)


@pytest.mark.parametrize("degrees_of_half", [10, 25, 40])
def test_a_cone_has_half_the_cotangent_of_its_angle(degrees_of_half):
    slope = np.tan(np.radians(degrees_of_half))
    height = 0.8 / slope
    shape = solid(block() + round_limb(height, 0.8, 0.0))
    assert of_last(shape, up(0.97 * height)) == pytest.approx(1 / (2 * slope), rel=0.03)


@pytest.mark.parametrize(
    ("limb", "top", "expected"),
    [
        (lambda: sheet(half_ellipse(1.0, 1.0)), 1.0, np.pi / 4),  # half a disc on a rim
        (lambda: sheet(half_ellipse(0.6, 1.2)), 1.2, np.pi / 2),  # an ear
        (lambda: manifold3d.Manifold.sphere(1.0, 64), 1.0, np.pi / 4),  # half a ball on a wall
        (lambda: sheet(BLADE), 4.0, 4 / 0.5),  # a blade
        (lambda: sheet(BLADE, 0.02), 4.0, 4 / 0.5),  # a thinner one
    ],
)
def test_a_sheet_is_as_wide_as_it_is_whatever_its_thickness(limb, top, expected):
    found = of_last(solid(block() + limb()), up(top - 0.03))
    assert found == pytest.approx(expected, rel=0.02, abs=0.06)  # as far as nodes tell where it begins


CORNERS = np.array(np.meshgrid([-1.0, 1.0], [-1.0, 1.0], [-1.0, 1.0])).reshape(3, -1).T


def test_a_sheet_is_as_wide_for_a_curve_that_bends_in_it():
    """A curve that zigzags by 45 degrees along a plate of width 2: its sections are across the plate, not askew."""
    shape = solid(manifold3d.Manifold.cube([8, 2, 0.1], True))
    along = np.linspace(-3, 3, 121)
    x = np.stack([along, 0.05 * np.tile([0, 1, 0, -1], 31)[:121], np.zeros(121)], axis=1)
    edges = np.stack([np.arange(120), np.arange(1, 121)], axis=1)
    width = limbs_of(shape, x, edges).width[25:-25]
    np.testing.assert_allclose(width, 1.0, atol=0.1)  # askew: 1.41


def test_only_nodes_of_branches_with_a_leaf_have_a_width():
    """Unless all are asked for; the slenderness is the same."""
    ring = trimesh.creation.torus(1.0, 0.2, major_sections=48, minor_sections=16)
    vertices, faces = np.array(ring.vertices), np.array(ring.faces)
    angle = np.linspace(0, 2 * np.pi, 49)[:-1]
    x = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    x = np.concatenate([x, [[1.05, 0.0, 0.0], [1.1, 0.0, 0.0]]])
    edges = np.array([*((k, (k + 1) % 48) for k in range(48)), (0, 48), (48, 49)])
    some, whole = (limbs_of(Enclosure(vertices, faces), x, edges, is_whole) for is_whole in (False, True))
    assert np.isnan(some.width[1:48]).all() and not np.isnan(whole.width[1:48]).any()
    np.testing.assert_allclose(whole.width[1:48], 0.2, rtol=0.1)
    assert by_leaf(x, edges, some) == by_leaf(x, edges, whole)


def test_corners_are_less_slender_than_half_a_disc():
    """Of a plate sqrt(s^2 + t^2) is half the width at s from a corner: 0.6 at 1.5 t, and 0.5 farther in."""
    s = np.linspace(0.01, 20, 4000)
    expected = ((s * np.hypot(s, 1) + np.arcsinh(s)) / 2 / (s**2 + 1)).max()
    plate = solid(manifold3d.Manifold.cube((2, 2, 0.2), True), 0.1)
    curve = legs(*([(0, 0, 0), (0.995 * x, 0.995 * y, 0)] for x in (-1, 1) for y in (-1, 1)), step=0.02)
    found = by_leaf(*curve, limbs_of(plate, *curve))
    np.testing.assert_allclose([*found.values()], expected, rtol=0.03)
    assert expected == pytest.approx(0.6, abs=0.001)
    cube = solid(manifold3d.Manifold.cube((2, 2, 2), True))
    for chosen in (CORNERS, CORNERS[[0, 3, 5, 6]]):  # all eight hide one another where sections are hexagons
        curve = legs(*([np.zeros(3), 0.95 * corner] for corner in chosen))
        found = [*by_leaf(*curve, limbs_of(cube, *curve)).values()]
        assert max(found) - min(found) < 1e-6 and 1 / (2 * np.sqrt(2)) < max(found) < 0.7


def test_a_pipe_counts_once():
    """Its sections go all around: of two spurs along its wall neither is free, and one is as slender as the pipe."""
    outer, inner = (manifold3d.Manifold.cylinder(6, radius, radius, 48, True) for radius in (1.0, 0.8))
    shape = solid(outer - inner)
    angle = np.linspace(0, 2 * np.pi, 41)[:-1]
    ring = 0.9 * np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    spur = np.linspace(0, 2.95, 31)[1:, None] * [0, 0, 1.0]
    vertices = np.concatenate([ring, ring[0] + spur, ring[20] + spur])
    edges = as_edges(chain(*range(40), 0) + chain(0, *range(40, 70)) + chain(20, *range(70, 100)))
    assert max(by_leaf(vertices, edges, limbs_of(shape, vertices, edges)).values()) < 0.1
    num = len(vertices) - 30
    one = vertices[:num], edges[:-30]
    assert of_last(shape, one) == pytest.approx(3, rel=0.03)
    stays, _ = prune(vertices, edges, limbs_of(shape, vertices, edges), 0.75)
    assert num == stays.sum()  # the second is free when the first is gone
    found = measure(*one, limbs_of(shape, *one))
    assert sorted(branch.slenderness == np.inf for branch in found) == [False, True]  # around the bore it cannot go


def test_a_side_branch_within_a_limb_is_none():
    shape = solid(manifold3d.Manifold.cylinder(8, 1, 1, 48, True))
    for end in ((0, 0.6, 0), (0, 0.9, 0.2), (0, 0.5, 0.5)):
        assert of_last(shape, legs([(0, 0, 0), (0, 0, 3.7)], [(0, 0, 0), (0, 0, -3.7)], [(0, 0, 0), end])) < 0.4
    # Beside the trunk, however long: the trunk is in all of its sections.
    assert of_last(shape, legs([(0, 0, 0), (0, 0, 3.7)], [(0, 0, 0), (0, 0, -3.7)], [(0, 0, 0), (0, 0.5, 3.6)])) < 0.3


# What must not matter


def three(edge: float = 0.25) -> Enclosure:
    """The block with a finger, an ear and a stump."""
    found = block() + round_limb(2.0, 0.3, 0.3) + sheet(half_ellipse(0.5, 1.0)).translate((1, 0, 0))
    return solid(found + round_limb(0.5, 0.3, 0.1).translate((-1, 0, 0)), edge)


THREE_LEGS = legs(
    [(0, 0, -1.02), (0, 0, 1.9)],
    [(0, 0, -1.02), (1, 0, -0.72), (1, 0, 0.95)],
    [(0, 0, -1.02), (-1, 0, -0.72), (-1, 0, 0.45)],
    [(0, 0, -1.02), (0, 1.4, -1)],
    [(0, 0, -1.02), (0, -1.4, -1)],
)


@pytest.mark.parametrize("seed", range(3))
def test_place_size_turn_and_the_order_of_nodes_do_not_matter(seed):
    random = np.random.default_rng(seed)
    shape, (x, edges) = three(), THREE_LEGS
    plain = by_leaf(x, edges, limbs_of(shape, x, edges))
    turn, scale, shift = Rotation.random(rng=random), 10.0 ** random.uniform(-4, 4), random.normal(size=3)
    place = [scale * (turn.apply(points) + shift) for points in (shape.vertices, x)]
    order = random.permutation(len(x))
    renamed = np.argsort(order)[edges][random.permutation(len(edges))]
    renamed = np.where(random.random((len(edges), 1)) < 0.5, renamed, renamed[:, ::-1])
    moved, places = Enclosure(place[0], shape.faces), place[1][order]
    found = by_leaf(places, renamed, limbs_of(moved, places, renamed))
    assert {int(order[leaf]) for leaf in found} == set(plain)
    for leaf, value in found.items():
        assert value == pytest.approx(plain[int(order[leaf])], rel=1e-6)


def test_finer_triangles_and_nodes_do_not_matter():
    x, edges = THREE_LEGS
    coarse, fine = (by_leaf(x, edges, limbs_of(three(size), x, edges)) for size in (0.5, 0.1))
    assert coarse == pytest.approx(fine, rel=0.03)
    leaves = sorted(fine)
    middle = len(x) + np.arange(len(edges))
    twice = np.concatenate([x, x[edges].mean(axis=1)])
    split = np.concatenate([np.stack([edges[:, 0], middle], axis=1), np.stack([middle, edges[:, 1]], axis=1)])
    found = by_leaf(twice, split, limbs_of(three(), twice, split))
    assert [found[leaf] for leaf in leaves] == pytest.approx([fine[leaf] for leaf in leaves], rel=0.08)


def test_sections_are_cut_in_portions(monkeypatch):
    shape, (x, edges) = three(), THREE_LEGS
    whole = limbs_of(shape, x, edges)
    monkeypatch.setattr(limbs, "AT_ONCE", 7)
    monkeypatch.setattr("msf_jax.host.curve.limbs.PAIRS_AT_ONCE", 50)
    parts = limbs_of(shape, x, edges)
    for one, other in zip(whole[:3], parts[:3], strict=True):
        np.testing.assert_array_equal(one, other)
    assert set(zip(whole.node, whole.edge, strict=True)) == set(zip(parts.node, parts.edge, strict=True))


# Constants: each test fails when the one that it names is doubled, or halved


@pytest.mark.parametrize(("share", "is_limb"), [(0.2, False), (0.3, True)])
def test_a_limb_reaches_out_by_a_quarter_of_the_ball_that_it_grows_out_of(share, is_limb):
    """LEAST_SHARE: a needle on a block is slender however short it is, and roughness when it is short."""
    shape = solid(block() + round_limb(share, 0.02, 0.02), 0.1)
    x, edges = legs(
        [(0, 0, -0.999), (1.4, 0, -0.999)], [(0, 0, -0.999), (-1.4, 0, -0.999)], [(0, 0, -0.999), (0, 0, share - 0.005)]
    )
    found = limbs_of(shape, x, edges)
    radius = found.radius.copy()
    radius[0] = 1.0
    assert (by_leaf(x, edges, found._replace(radius=radius))[len(x) - 1] > 5) == is_limb


def test_a_branch_is_cut_across_what_it_does_within_a_radius():
    """CHORD: a leaf looks straight ahead after a bend 1.5 radii back; turns within a radius do not turn a section."""
    shape = solid(manifold3d.Manifold.cylinder(4, 1, 1, 48, True))
    x, edges = legs([(-0.5, 0, 0.2), (0, 0, 0.2), (0, 0, 1.2)], step=0.1)
    radius = 0.8
    assert shape.distances(x[-1:])[0] == pytest.approx(radius, rel=0.01)
    assert limbs_of(shape, x, edges).ahead[-1] == pytest.approx(radius, rel=1e-6)
    along, away = np.arange(-15, 16) * 0.2, 0.15 * np.tile([0, 1, 0, -1], 8)[:31]
    scale = 2 * np.hypot(0.2, 0.15)  # half the length of a wave; the chord of all of one does not see it
    zigzag = np.stack([0 * along, away, along], axis=1)
    x, edges = zigzag, as_edges(chain(*range(31)))
    wire = solid(manifold3d.Manifold.cylinder(8, scale, scale, 96, True))
    width = limbs_of(wire, x, edges).width
    middle = np.flatnonzero(away == 0)[4:-4]
    np.testing.assert_allclose(width[middle], scale, rtol=0.01)


def test_a_wall_is_looked_for_four_radii_ahead():
    """AHEAD: a leaf far from the end of its limb is not carried there by its tip."""
    shape = solid(manifold3d.Manifold.cylinder(20, 0.4, 0.4, 48, True))
    for left, expected in ((1.2, 1.2), (2.4, 1.6)):
        x, edges = legs([(0, 0, 0), (0, 0, 10 - left)], step=0.2)
        found = limbs_of(shape, x, edges)
        assert found.ahead[-1] == pytest.approx(expected, rel=0.01)


# On graphs: sections are discs, and what goes through them is made up


def star_of(lengths: list[float], radius: float, step: float = 0.25) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Up to six legs out of node 0, at right angles, with a node every ``step``."""
    vertices, pairs = [np.zeros(3)], []
    for direction, length in zip(np.concatenate([np.eye(3), -np.eye(3)]), lengths, strict=False):
        first, num = len(vertices), round(length / step)
        pairs += chain(0, *range(first, first + num))
        vertices += [direction * length * (k + 1) / num for k in range(num)]
    return np.array(vertices), as_edges(pairs), np.full(len(vertices), radius)


def in_discs(vertices: np.ndarray, edges: np.ndarray, radii: np.ndarray) -> tuple[np.ndarray, np.ndarray, Limbs]:
    return vertices, edges, limbs_without(vertices, edges, radii)


@pytest.mark.parametrize("scale", [1e-9, 1.0, 1e6])
def test_without_a_solid_sections_are_discs(scale):
    """The half edge at the junction does not count, and half of the tip's ball does."""
    vertices, edges, radii = star_of([1.0, 2.5, 0.75], 0.1)
    found = by_leaf(*in_discs(scale * vertices, edges, scale * radii))
    assert sorted(found.values()) == pytest.approx([(length - 0.125) / 0.1 + 0.5 for length in (0.75, 1.0, 2.5)])


@pytest.mark.parametrize("radius", [0.0, np.nan])
def test_where_no_width_is_known_all_stays_and_what_is_outside_goes(radius):
    vertices, edges, radii = star_of([1.0, 2.5, 0.75], 0.1)
    limb = in_discs(vertices, edges, np.full(len(vertices), radius))
    assert set(by_leaf(*limb).values()) == {np.inf} and prune(*limb, 100.0)[0].all()
    radii[-3:] = 0.0
    limb = in_discs(vertices, edges, radii)
    assert by_leaf(*limb)[len(vertices) - 1] == 0 and not prune(*limb, 0.1)[0][-3:].any()


def test_a_leaf_on_the_surface_has_no_limb_ahead():
    """Half an edge of 3 belongs to the leaf, and the limb is 1 wide: nothing is made of the way to a wall that is 0."""
    x = np.array([[0.0, 0, 0], [-1, 0, 0], [1, 0, 0], [0, 0, 3]])
    edges, ones = as_edges([(0, 1), (0, 2), (0, 3)]), np.ones(4)
    nothing = np.empty(0, dtype=np.int64)
    found = Limbs(ones, np.where(degrees(4, edges) < 3, ones, np.nan), np.zeros(4), nothing, nothing)
    assert by_leaf(x, edges, found)[3] == pytest.approx(1.5)


def test_a_node_without_a_section_is_as_wide_as_its_ball_and_one_outside_adds_nothing():
    """As far as the two can be told apart: one that is askew does not count, either, for a median of three is taken."""
    shape, curve = solid(block() + round_limb(2.0, 0.4, 0.4)), up(1.95)
    found, value = limbs_of(shape, *curve), of_last(shape, curve)
    some = np.arange(len(curve[0]) - 30, len(curve[0]), 4)
    for wrong in (np.nan, 3.0, 0.001):
        width = found.width.copy()
        width[some] = wrong
        assert by_leaf(*curve, found._replace(width=width))[len(curve[0]) - 1] == pytest.approx(value, rel=0.02)
    x = np.concatenate([curve[0], [[0, 0, 2.4], [0, 0, 2.8], [0, 0, 3.2]]])
    edges = np.concatenate([curve[1], len(curve[0]) - 1 + np.array([[0, 1], [1, 2], [2, 3]])])
    assert of_last(shape, (x, edges)) < value + 0.45 / 0.4  # half of the edge that leads out


@pytest.mark.parametrize("name", ["path", "edge", "loop", "theta", "lone node", "figure eight", "spectacles"])
def test_what_cannot_go_is_infinitely_slender(name):
    """Loops, paths between junctions, and whole components."""
    num, pairs, _ = GRAPHS[name]
    curve = in_discs(np.random.default_rng(2).normal(size=(num, 3)), as_edges(pairs), np.full(num, 100.0))
    found = measure(*curve)
    assert found and all(branch.slenderness == np.inf for branch in found)
    assert prune(*curve, np.inf)[0].all()


def test_only_the_stick_of_a_lollipop_can_go():
    num, pairs, _ = GRAPHS["lollipop"]
    curve = in_discs(np.random.default_rng(3).normal(size=(num, 3)), as_edges(pairs), np.full(num, 99.0))
    stick, sweet = sorted(measure(*curve))
    assert stick.nodes[0] == 0 and 0 <= stick.slenderness < 1
    assert sweet.nodes[0] == 2 and sweet.slenderness == np.inf
    stays, target = prune(*curve, np.inf)
    assert stays.tolist() == [False, False, True, True, True] and target.tolist() == [2, 2, 2, 3, 4]


def test_an_edge_that_is_there_twice_counts_once():
    shape, (x, edges) = three(), THREE_LEGS
    doubled = np.concatenate([edges, edges[20:60, ::-1], edges[-3:]])
    found = measure(x, doubled, limbs_of(shape, x, doubled))
    plain = measure(x, edges, limbs_of(shape, x, edges))
    assert sorted(one.slenderness for one in found) == pytest.approx(sorted(one.slenderness for one in plain))
    for least in (0.75, 3.0):
        stays = [prune(x, e, limbs_of(shape, x, e), least)[0] for e in (edges, doubled)]
        np.testing.assert_array_equal(*stays)


def test_lengths_are_those_of_the_paths():
    vertices, edges, radii = star_of([1.0, 2.5, 0.75], 0.1)
    found = measure(*in_discs(vertices, edges, radii))
    assert sorted(branch.length for branch in found) == pytest.approx([0.75, 1.0, 2.5])
    square = np.array([[0.0, 0, 0], [2, 0, 0], [2, 3, 0], [0, 3, 0]])
    (loop,) = measure(*in_discs(square, as_edges(chain(0, 1, 2, 3, 0)), np.ones(4)))
    assert loop.length == pytest.approx(10) and loop.nodes[0] == loop.nodes[-1]
    (lone,) = measure(*in_discs(np.zeros((1, 3)), NONE, np.ones(1)))
    assert lone.length == 0 and lone.nodes == [0]


def test_the_surface_of_a_branch_is_that_of_its_own_nodes():
    """Its junctions are not among them; a loop names its first node twice, and counts it once."""
    share = np.arange(1.0, 8.0)
    num, pairs, _ = GRAPHS["spectacles"]
    branches = measure(*in_discs(np.eye(7)[:, :3], as_edges(pairs), np.ones(num)), share)
    found = {min(tuple(one.nodes), tuple(one.nodes[::-1])): one.surface for one in branches}
    expected = {(0, 1, 2, 0): share[[1, 2]].sum(), (0, 6, 3): share[6], (3, 4, 5, 3): share[[4, 5]].sum()}
    assert found == pytest.approx(expected)
    (loop,) = measure(*in_discs(np.eye(4)[:, :3], as_edges(chain(0, 1, 2, 3, 0)), np.ones(4)), np.ones(4))
    assert loop.surface == pytest.approx(4)
    assert np.isnan(measure(*in_discs(np.eye(2, 3), as_edges([(0, 1)]), np.ones(2)))[0].surface)


# Pruning


def test_a_threshold_is_not_pruned_itself():
    curve = in_discs(*star_of([1.0, 2.0, 3.0], 0.5))
    least = min(by_leaf(*curve).values())
    assert prune(*curve, least)[0].all()
    stays, target = prune(*curve, np.nextafter(least, 9))
    np.testing.assert_array_equal(np.flatnonzero(~stays), np.arange(1, 5))
    assert (target[1:5] == 0).all()


def test_the_least_goes_first_and_the_rest_is_measured_again():
    """Of three legs all below the threshold only the shortest goes: the others are one branch then, without an end."""
    for order in ([1.0, 1.5, 2.0], [2.0, 1.0, 1.5], [1.5, 2.0, 1.0]):
        stays, target = prune(*in_discs(*star_of(order, 0.5)), 8.0)
        start = 1 + round(sum(order[: order.index(1.0)]) / 0.25)
        np.testing.assert_array_equal(np.flatnonzero(~stays), np.arange(start, start + 4))
        assert (target[~stays] == 0).all()


def test_at_no_limit_a_tree_becomes_a_path():
    stays, _ = prune(*in_discs(*star_of([1.0, 2.0, 3.0, 4.0, 5.0], 0.5)), np.inf)
    assert np.flatnonzero(stays).tolist() == [0, *range(25, 61)]  # the two longest legs


def test_of_equal_ones_the_order_of_nodes_decides():
    stays, _ = prune(*in_discs(*star_of([1.0, 1.0, 1.0, 1.0], 0.5)), np.inf)
    assert np.flatnonzero(~stays).tolist() == [*range(1, 9)]


def test_a_fork_that_loses_a_prong_is_one_limb():
    """Its prongs are half a radius long each; that which stays is measured with the stem, and stays."""
    shape = solid(block() + round_limb(2.0, 0.4, 0.4))
    x, edges = up(1.5)
    is_held, tip = np.arange(len(x) + 2) < 30, len(x) - 1  # the trunk
    prongs = x[tip] + np.array([[0.02, 0, 0.2], [-0.02, 0, 0.25]])
    x, edges = np.concatenate([x, prongs]), np.concatenate([edges, [[tip, tip + 1], [tip, tip + 2]]])
    found = limbs_of(shape, x, edges)
    before = by_leaf(x, edges, found)
    assert max(before[tip + 1], before[tip + 2]) < 0.75
    stays, target = prune(x, edges, found, 4.0, is_held)
    (gone,) = np.flatnonzero(~stays[tip:]) + tip
    assert gone in (tip + 1, tip + 2) and target[gone] == tip
    assert not prune(x, edges, found, 6.0, is_held)[0][tip - 20 :].any()  # less slender than that, all of it goes


def test_two_branches_in_one_limb_are_one():
    """Side by side, neither is free; when one has gone the other is, and stays."""
    shape = solid(block() + round_limb(2.0, 0.4, 0.4))
    trunk = [(0, 0, -1), (1.4, 0, -1)], [(0, 0, -1), (-1.4, 0, -1)]
    x, edges = legs(*trunk, [(0, 0, -1), (0.1, 0, -0.5), (0.1, 0, 1.9)], [(0, 0, -1), (-0.1, 0, -0.5), (-0.1, 0, 1.8)])
    found = limbs_of(shape, x, edges)
    values = sorted(by_leaf(x, edges, found).items())[-2:]
    assert max(value for _, value in values) < 0.75
    stays, _ = prune(x, edges, found, 0.75)
    assert stays[[leaf for leaf, _ in values]].sum() == 1


def test_a_node_goes_to_a_junction_that_stays():
    """A spur on a spur: what went to the first junction goes on to the second with it."""
    vertices, edges, radii = star_of([3.0, 3.0, 1.0], 0.5)
    leaf = len(vertices) - 1
    vertices = np.concatenate([vertices, vertices[leaf - 1 : leaf] + [[0.1, 0, 0]]])
    edges = np.concatenate([edges, [[leaf - 1, leaf + 1]]])
    stays, target = prune(*in_discs(vertices, edges, np.r_[radii, 0.5]), 4.0)
    np.testing.assert_array_equal(np.flatnonzero(~stays), np.arange(25, leaf + 2))
    assert (target[25:] == 0).all()


def test_a_held_branch_stays_and_others_go():
    """Also where it is held by a node in its middle; its junction stays anyhow, and holds nothing."""
    each = {1: range(1, 5), 2: range(5, 10), 3: range(10, 16), 4: range(16, 24)}  # lengths 1, 1.25, 1.5, 2
    vertices, edges, radii = star_of([1.0, 1.25, 1.5, 2.0], 0.5)
    for held, gone in ((None, (1, 2)), (2, (2, 3)), (4, (2, 3)), (11, (1, 2)), (23, (1, 2)), (0, (1, 2))):
        is_held = np.zeros(len(vertices), dtype=bool)
        is_held[[] if held is None else held] = True
        stays, _ = prune(*in_discs(vertices, edges, radii), 100.0, is_held)
        assert np.flatnonzero(~stays).tolist() == [node for leg in gone for node in each[leg]], held


@st.composite
def curves(draw) -> tuple[np.ndarray, np.ndarray, Limbs]:
    """A graph with random places, widths and radii, some of them unknown or 0, and edges through random sections."""
    num, edges = draw(graphs(is_connected=draw(st.booleans())))
    random = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    degree = degrees(num, edges)
    radii = random.uniform(0, draw(st.sampled_from([0.2, 1.0, 4.0])), num)
    if draw(st.booleans()):
        radii[random.integers(num)] = 0.0
    width = np.where(random.random(num) < 0.8, random.uniform(0.05, 3, num), np.nan)
    some, count = np.flatnonzero((degree > 0) & (degree < 3)), int(random.integers(0, 8))
    node = random.choice(some, count) if len(some) else some
    edge = random.integers(0, max(len(edges), 1), len(node))
    ahead = random.uniform(0, 1, num) * (degree == 1)
    return random.normal(size=(num, 3)), edges, Limbs(radii, width, ahead, node, edge)


def plain_slenderness(curve: tuple[np.ndarray, np.ndarray, Limbs], graph: nx.Graph) -> dict[int, tuple[list, float]]:
    """For each leaf that leads to a junction, the nodes up to there and its slenderness, by its definition."""
    x, edges, limb = curve
    wide = np.where(np.isnan(limb.width), limb.radius, limb.width)
    found = {}
    for leaf in (node for node, degree in graph.degree if degree == 1):
        own, onward = [leaf], next(iter(graph[leaf]))
        while graph.degree[onward] == 2:
            own.append(onward)
            (onward,) = set(graph[onward]) - set(own[-2:])
        if graph.degree[onward] < 3:
            continue
        steps = {frozenset(step) for step in pairwise([*own, onward])}
        length = np.linalg.norm(np.diff(x[[*own, onward]], axis=0), axis=1)
        width = [np.median(wide[[own[max(k - 1, 0)], own[k], own[min(k + 1, len(own) - 1)]]]) for k in range(len(own))]
        there = [frozenset(edges[e].tolist()) for e in limb.edge]
        is_free = [
            all(e in steps or not graph.has_edge(*e) for n, e in zip(limb.node, there, strict=True) if n == node)
            for node in own
        ]
        part = is_free * (length + np.r_[0.0, length[:-1]]) / 2
        reach = limb.ahead[leaf] + np.cumsum(part)
        area = limb.ahead[leaf] * wide[leaf] / 2 + np.cumsum(part * width)
        slope = np.diff(width) / length[:-1]
        before = np.r_[wide[leaf] / max(limb.ahead[leaf], 1e-300), slope]  # of the width, before each node
        end = np.array(width) + np.minimum(before, np.r_[slope, np.inf]) * length / 2
        widest = np.maximum.accumulate([wide[leaf], *np.maximum(width, end)])[1:]
        counts = (area / np.maximum(widest, 1e-100) ** 2)[(reach >= 0.25 * limb.radius[onward]) & (widest > 0)]
        found[leaf] = own, counts.max(initial=0.0)
    return found


def graph_of(curve: tuple[np.ndarray, np.ndarray, Limbs]) -> nx.Graph:
    graph = nx.empty_graph(len(curve[0]))
    graph.add_edges_from(curve[1].tolist())
    return graph


@settings(max_examples=150, deadline=None)
@given(curves())
def test_slenderness_is_what_its_definition_says(curve):
    expected = plain_slenderness(curve, graph_of(curve))
    degree = degrees(len(curve[0]), curve[1])
    for branch in measure(*curve):
        leaves = [node for node in (branch.nodes[0], branch.nodes[-1]) if node in expected]
        if leaves:
            own, value = expected.pop(leaves[0])
            assert set(own) == set(branch.nodes) - set(np.flatnonzero(degree > 2)) and len(leaves) == 1
            assert branch.slenderness == pytest.approx(value, rel=1e-9)
        else:
            assert branch.slenderness == np.inf
    assert not expected


@settings(max_examples=150, deadline=None)
@given(curves(), st.floats(0.1, 8), st.data())
def test_pruning_leaves_cycles_and_components_and_nothing_below_the_threshold(curve, least, data):
    num = len(curve[0])
    flags = data.draw(st.none() | st.lists(st.booleans(), min_size=num, max_size=num))
    is_held = None if flags is None else np.array(flags)
    stays, target = prune(*curve, least, is_held)
    graph = graph_of(curve)
    left = graph.subgraph(np.flatnonzero(stays).tolist())
    assert nx.number_connected_components(left) == nx.number_connected_components(graph)
    assert left.number_of_edges() - left.number_of_nodes() == len(curve[1]) - num
    for own, value in plain_slenderness(curve, left).values():
        assert value >= least * (1 - 1e-9) or (is_held is not None and is_held[own].any())
    # What goes to a node hangs on it, and the node stays.
    np.testing.assert_array_equal(target[stays], np.flatnonzero(stays))
    assert stays[target].all()
    for node in np.unique(target).tolist():
        assert nx.is_connected(graph.subgraph([node, *np.flatnonzero((target == node) & ~stays).tolist()]))
    if is_held is not None:
        assert stays[is_held].all()


@settings(max_examples=100, deadline=None)
@given(curves(), st.lists(st.floats(0.1, 8), min_size=2, max_size=4))
def test_a_higher_threshold_keeps_fewer_nodes_and_all_of_them_stay_at_a_lower_one(curve, thresholds):
    kept = [prune(*curve, least)[0] for least in sorted(thresholds)]
    for lower, higher in pairwise(kept):
        assert not (higher & ~lower).any()


@settings(max_examples=100, deadline=None)
@given(curves(), st.floats(0.1, 8))
def test_pruning_takes_the_least_as_long_as_it_is_below_the_threshold(curve, least):
    """Against a loop in plain Python; branches that are equally slender can go in either order."""
    graph = graph_of(curve)
    while True:
        found = sorted(plain_slenderness(curve, graph).values(), key=lambda one: one[1])
        if not found or found[0][1] >= least:
            break
        if len(found) > 1 and found[1][1] < found[0][1] + 1e-9:
            return
        graph.remove_nodes_from(found[0][0])
    assert np.flatnonzero(prune(*curve, least)[0]).tolist() == sorted(graph)


def comb(teeth: np.ndarray, spacing: int = 8) -> tuple[np.ndarray, np.ndarray]:
    """A long trunk with a tooth of four nodes on every eighth of its own."""
    num = spacing * (len(teeth) + 1) + 1
    vertices = [0.25 * np.arange(num)[:, None] * [1.0, 0, 0]]
    pairs = chain(*range(num))
    for k, period in enumerate(teeth):
        foot, first = spacing * (k + 1), num + 4 * k
        vertices.append(vertices[0][foot] + period * np.arange(1, 5)[:, None] / 4 * [0, 1.0, 0])
        pairs += chain(foot, *range(first, first + 4))
    return np.concatenate(vertices), as_edges(pairs)


@pytest.mark.parametrize("order", ["one end to the other", "at random", "equal", "hidden"])
def test_pruning_is_linear_in_the_branches(order, monkeypatch):
    """Counted in nodes walked to, and edges looked up; twice as many teeth may take a tenth more than twice that."""
    counts = [0]
    walk, at = Pruning._walk, Pruning._branch_at

    def counted_walk(self, leaf):
        for each in walk(self, leaf):
            counts[0] += 1
            yield each

    def counted_at(self, edge):
        counts[0] += 1
        return at(self, edge)

    monkeypatch.setattr(Pruning, "_walk", counted_walk)
    monkeypatch.setattr(Pruning, "_branch_at", counted_at)
    spent = []
    for num in (100, 200, 400):
        teeth = np.full(num, 0.3) if order == "equal" else np.linspace(0.05, 0.6, num)
        teeth = np.random.default_rng(1).permutation(teeth) if order == "at random" else teeth
        x, edges = comb(teeth)
        limb = limbs_without(x, edges, np.full(len(x), 0.5))
        if order == "hidden":  # every tooth is in the sections of the trunk around it
            edge = np.arange(len(edges) - 4 * num, len(edges))
            node = np.clip(8 * (1 + (edge - edge[0]) // 4)[:, None] + np.array([-2, -1, 1, 2]), 1, None)
            limb = limb._replace(node=node.ravel(), edge=np.repeat(edge, 4))
        counts[0] = 0
        stays, _ = prune(x, edges, limb, 5.0)
        assert stays.sum() == len(x) - 4 * num
        spent.append(counts[0])
    assert spent[1] < 2.2 * spent[0] and spent[2] < 2.2 * spent[1]


def test_the_curve_is_left_as_it_is():
    shape, (x, edges) = three(), THREE_LEGS
    copies = x.copy(), edges.copy()
    found = limbs_of(shape, x, edges)
    fields = [field.copy() for field in found]
    prune(x, edges, found, 5.0)
    for array, copy in zip((x, edges, *found), (*copies, *fields), strict=True):
        np.testing.assert_array_equal(array, copy)


@pytest.mark.parametrize("num", [0, 1, 2])
def test_a_curve_of_next_to_nothing(num):
    shape = Enclosure(np.array(trimesh.creation.icosphere(2).vertices), np.array(trimesh.creation.icosphere(2).faces))
    x, edges = np.zeros((num, 3)), as_edges([(0, 1)] * (num > 1))  # two nodes in one place
    found = limbs_of(shape, x, edges)
    assert prune(x, edges, found, 9.0)[0].all() and len(measure(x, edges, found)) == (num > 0)
