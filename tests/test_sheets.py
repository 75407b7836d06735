"""Discs in sheets: how wide they are in plates and tubes, what they cover, and which branches they make one with."""

import numpy as np
import pytest
import trimesh
from scipy.spatial.transform import Rotation

import msf_jax
from msf_jax import ground_truth
from msf_jax.host.curve.branches import prune
from msf_jax.host.solid.enclosure import Enclosure
from msf_jax.host.solid.sheets import WIDEST, Discs, away_from, discs, flats_of

TURN = Rotation.from_rotvec([0.3, -0.7, 0.4])
HALF = np.array([1.0, 0.8, 0.1])  # of the plate


def plate() -> Enclosure:
    """Turned, and of many triangles."""
    box = trimesh.creation.box(2 * HALF)
    for _ in range(4):
        box = box.subdivide()
    return Enclosure(TURN.apply(box.vertices), np.array(box.faces))


def test_a_disc_in_a_plate_lies_along_it_and_reaches_its_rim():
    """In the middle, beside a long side, beside a corner, and where the ball touches the rim, too."""
    points = np.array([[0, 0, 0], [0.2, 0.5, 0.02], [0.7, -0.5, 0], [0.9, 0, 0]])
    found = discs(plate(), TURN.apply(points), np.array([0.1, 0.08, 0.1, 0.1]))
    assert (np.abs(found.normal[:3] @ TURN.as_matrix()[:, 2]) > 0.999).all()
    # Rays are 30 degrees apart, so that the shortest is not always straight to the rim.
    assert (found.radius[:3] >= [0.8, 0.3, 0.3]).all()
    assert (found.radius[:3] <= np.array([0.8, 0.3, 0.3]) / np.cos(np.radians(15)) + 1e-9).all()
    assert found.radius[3] == pytest.approx(0.1, rel=0.05)


def test_no_disc_is_wider_than_twelve_balls():
    assert discs(plate(), np.zeros((1, 3)), np.array([0.05])).radius == pytest.approx(0.05 * WIDEST)


def test_a_tube_a_ball_and_a_cube_have_no_discs():
    """Across the diagonal of a cube there is one that is a fifth wider than its ball: but no way is flatter there."""
    line = np.stack([0 * np.arange(20.0), 0 * np.arange(20.0), np.linspace(-1, 1, 20)], axis=1)
    tube = ground_truth.swept_tube(TURN.apply(line), np.full(20, 0.2), 24)
    ball = trimesh.creation.icosphere(3)
    cube = trimesh.creation.box([2.0, 2, 2]).subdivide().subdivide().subdivide()
    middle = np.zeros((1, 3))
    for mesh, points, radius in ((tube, TURN.apply(line[5:-5]), 0.198), (ball, middle, 0.99), (cube, middle, 1.0)):
        shape, radii = Enclosure(np.array(mesh.vertices), np.array(mesh.faces)), np.full(len(points), radius)
        np.testing.assert_allclose(discs(shape, points, radii).radius, radii)


def test_nothing_is_around_a_point_without_room():
    found = discs(plate(), np.zeros((1, 3)), np.zeros(1))
    assert found.radius == 0 and np.isfinite(found.normal).all()
    assert discs(plate(), np.empty((0, 3)), np.empty(0)).radius.shape == (0,)


def test_a_disc_covers_what_its_ball_does_from_all_places_in_it():
    """Against many balls; without discs, or where they are no wider than the balls, it is these that count."""
    random = np.random.default_rng(5)
    points = random.uniform(-2, 2, (40, 3))
    centre, normal = np.array([[0.3, -0.2, 0.1]]), TURN.apply([[0.0, 0, 1]])
    angle, part = np.meshgrid(np.linspace(0, 2 * np.pi, 200), np.linspace(0, 1, 50))
    flat = 0.8 * part[..., None] * np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=2)
    places = centre + TURN.apply(flat.reshape(-1, 3))
    nearest = np.linalg.norm(points[:, None] - places, axis=2).min(axis=1) - 0.2
    found = away_from(centre, np.array([0.2]), Discs(normal, np.array([1.0])), points)
    np.testing.assert_allclose(found[:, 0], nearest, atol=0.01)
    plain = np.linalg.norm(points - centre, axis=1) - 0.2
    for none in (None, Discs(normal, np.array([0.2]))):
        np.testing.assert_allclose(away_from(centre, np.array([0.2]), none, points)[:, 0], plain)


def spider(reaches: dict[tuple[float, float, float], float]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Legs of ten nodes from the origin, by direction and length; and balls of a plate 0.2 thick."""
    vertices = [np.zeros(3)]
    edges = []
    for way, reach in reaches.items():
        first = len(vertices)
        vertices += list(np.linspace(0, reach, 11)[1:, None] * np.array(way) / np.linalg.norm(way))
        edges += [(0, first), *((node, node + 1) for node in range(first, first + 9))]
    return np.array(vertices), np.array(edges), np.full(len(vertices), 0.1)


def in_plate(vertices: np.ndarray):
    """The discs of a square plate with sides of 2 around nodes of it; beyond it there are none."""

    def found(nodes: np.ndarray) -> Discs:
        rim = 1 - np.abs(vertices[nodes, :2]).max(axis=1)
        rim[np.abs(vertices[nodes, 2]) > 0.1] = 0.0
        return Discs(np.tile([0.0, 0, 1], (len(nodes), 1)), np.maximum(rim, 0.1))

    return found


def test_branches_to_the_corners_of_a_plate_are_none_and_a_limb_out_of_it_is():
    """Out of a side, or up: it need be no longer than a leg to a corner, which persists by its balls alone."""
    corners = {(1, 1, 0): 1.3, (1, -1, 0): 1.25, (-1, 1, 0): 1.2, (-1, -1, 0): 1.28}
    for limb in ((1.0, 0.1, 0.0), (0.0, 0.2, 1.0)):
        vertices, edges, radii = spider(corners | {limb: 2.0})
        assert prune(vertices, edges, radii, 1.5)[0].all()
        flats = flats_of(vertices, radii, np.bincount(edges.ravel()), in_plate(vertices))
        stays = prune(vertices, edges, radii, 1.5, None, flats)[0]
        leaves = np.flatnonzero(np.bincount(edges[stays[edges].all(axis=1)].ravel(), minlength=len(vertices)) == 1)
        assert leaves.tolist() == [10, 50]  # the longest way through the plate goes on out of it


def test_a_limb_at_the_rim_grows_out_of_the_whole_sheet():
    """At its junction the disc is no wider than the ball, but there is a wide one that it is in."""
    vertices, edges, _ = spider({(1, 0, 0): 0.9, (-1, 0, 0): 0.9, (0, 1, 0): 0.9, (0, -1, 0): 0.9})
    twigs = vertices[10] + np.array([[0.1, 0.1, 0], [0.1, -0.1, 0]])
    vertices, edges = np.concatenate([vertices, twigs]), np.concatenate([edges, [[10, 41], [10, 42]]])
    flats = flats_of(vertices, np.full(43, 0.1), np.bincount(edges.ravel()), in_plate(vertices))
    assert flats is not None and flats.discs.radius[10] == 0.1
    assert flats.size[10] == flats.discs.radius[0] == 1.0
    assert flats.size[5] == flats.discs.radius[5] < 0.6


def test_far_from_the_junctions_in_sheets_nodes_have_their_balls():
    """And where no leaf is near such a junction there are no discs at all."""
    vertices, edges, radii = spider({(1, 1, 0): 1.3, (1, -1, 0): 1.25, (0, 0.2, 1): 9.0})
    flats = flats_of(vertices, radii, np.bincount(edges.ravel()), in_plate(0.3 * vertices))
    assert flats is not None and flats.discs.normal[:24].any(axis=1).all() and not flats.discs.normal[24:].any()
    vertices, edges, radii = spider({(1, 0, 0): 9.0, (-1, 0, 0): 9.0, (0, 0, 1): 9.0})
    assert flats_of(vertices, radii, np.bincount(edges.ravel()), in_plate(0.3 * vertices)) is None


def test_where_no_junction_is_in_a_sheet_nothing_else_is_asked():
    vertices, edges, radii = spider({(1, 0, 0): 1.0, (0, 1, 0): 1.0, (0, 0, 1): 1.0})
    asked = []

    def round_ones(nodes: np.ndarray) -> Discs:
        asked.append(nodes.tolist())
        return Discs(np.zeros((len(nodes), 3)), radii[nodes])

    assert flats_of(vertices, radii, np.bincount(edges.ravel()), round_ones) is None and asked == [[0]]


@pytest.mark.parametrize("turn", [None, 3])
def test_a_box_has_one_straight_branch(turn):
    """As long as it is but for what is left at the ends; before, it had legs into four corners."""
    box = trimesh.creation.box([1.0, 2, 3])
    for _ in range(4):
        box = box.subdivide()
    vertices = np.array(box.vertices)
    skeleton = msf_jax.skeletonize((vertices if turn is None else Rotation.random(rng=turn).apply(vertices), box.faces))
    (branch,) = skeleton.branches
    assert branch.length == pytest.approx(2.7, rel=0.05)
    ends = skeleton.vertices[[branch.nodes[0], branch.nodes[-1]]]
    assert np.linalg.norm(ends[0] - ends[1]) > 0.98 * branch.length
