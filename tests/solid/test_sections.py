"""Plane sections: closed forms of balls, cylinders, ellipsoids and boxes, and loops that the test joins by itself."""

from typing import NamedTuple

import networkx as nx
import numpy as np
import pytest
import trimesh
from conftest import blob, torus
from scipy.spatial.transform import Rotation

from msf_jax.solid import sections
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.sections import Sections, cut


def enclosure(mesh: trimesh.Trimesh) -> Enclosure:
    """A surface to cut."""
    return Enclosure(np.array(mesh.vertices), np.array(mesh.faces))


def cut_one(mesh: trimesh.Trimesh, point, normal, radius: float = 0.5) -> Sections:
    """The section around a single point, without its leading axis."""
    normal = np.array([normal], dtype=float) / np.linalg.norm(normal)
    found = cut(enclosure(mesh), np.array([point], dtype=float), normal, np.array([radius]))
    return Sections._make([*(field[0] for field in found[:-1]), found.corners])


def random_normals(random: np.random.Generator, num: int) -> np.ndarray:
    """Unit vectors (num, 3), evenly in all directions."""
    normals = random.normal(size=(num, 3))
    return normals / np.linalg.norm(normals, axis=1)[:, None]


def assert_same(found: Sections, expected: Sections, atol: float = 1e-10) -> None:
    """Two answers agree in all that they say."""
    np.testing.assert_array_equal(found.is_found, expected.is_found)
    np.testing.assert_array_equal(found.is_around, expected.is_around)
    np.testing.assert_allclose(found.centroid, expected.centroid, rtol=0, atol=atol)
    np.testing.assert_allclose(found.radius, expected.radius, rtol=0, atol=atol)


def assert_nothing(found: Sections, point) -> None:
    """No loop: the point itself, and no radius."""
    assert not found.is_found and not found.is_around and found.radius == 0
    np.testing.assert_array_equal(found.centroid, point)


# Closed forms


def test_the_section_of_a_ball_is_a_circle_around_the_foot_of_its_centre():
    random = np.random.default_rng(1)
    centre, size, num = np.array([3.0, -2, 1]), 2.0, 40
    mesh = trimesh.creation.icosphere(4, radius=size).apply_translation(centre)
    normals = random_normals(random, num)
    points = centre + size * 0.85 * random_normals(random, num) * random.uniform(0, 1, (num, 1))
    height = np.einsum("pi,pi->p", points - centre, normals)
    found = cut(enclosure(mesh), points, normals, np.full(num, 0.5))
    assert found.is_found.all() and found.is_around.all()
    np.testing.assert_allclose(found.centroid, centre + height[:, None] * normals, atol=0.01)
    np.testing.assert_allclose(found.radius, np.sqrt(size**2 - height**2), rtol=0.005)
    assert np.ptp(found.radius) > 0.3


def test_the_sections_of_an_ellipsoid_lie_around_the_conjugate_diameter():
    """The plane n.x = h cuts x.x / a^2 = 1 in an ellipse around h a^2 n / (n.a^2 n)."""
    random = np.random.default_rng(2)
    axes, num = np.array([1.0, 1.7, 0.6]), 40
    mesh = trimesh.creation.icosphere(4)
    mesh.vertices *= axes
    normals = random_normals(random, num)
    points = axes * random_normals(random, num) * random.uniform(0, 0.7, (num, 1))
    height = np.einsum("pi,pi->p", points, normals)
    spread = axes**2 * normals
    expected = spread * (height / np.einsum("pi,pi->p", normals, spread))[:, None]
    found = cut(enclosure(mesh), points, normals, np.full(num, 0.3))
    assert found.is_around.all()
    np.testing.assert_allclose(found.centroid, expected, atol=0.01)
    foot = height[:, None] * normals  # where a ball's centre would be
    assert np.linalg.norm(expected - foot, axis=1).max() > 0.2


# Against loops that are joined from trimesh's segments


class Loop(NamedTuple):
    """corners: (k, 2) in order. segments: (k, 2, 2). is_outer: whether an even number of other loops goes around it."""

    corners: np.ndarray
    segments: np.ndarray
    is_outer: bool


def plane_axes(normal: np.ndarray) -> np.ndarray:
    """Two unit vectors (2, 3) that span the plane."""
    u = np.cross(normal, np.eye(3)[np.abs(normal).argmin()])
    return np.stack([u, np.cross(normal, u)]) / np.linalg.norm(u)


def is_around(corners: np.ndarray, place: np.ndarray) -> bool:
    """Even and odd: whether the ray from ``place`` to the right crosses an odd number of sides."""
    a, b = corners, np.roll(corners, -1, axis=0)
    crosses = (a[:, 1] > place[1]) != (b[:, 1] > place[1])
    a, b = a[crosses], b[crosses]
    x = a[:, 0] + (place[1] - a[:, 1]) / (b[:, 1] - a[:, 1]) * (b[:, 0] - a[:, 0])
    return bool((x > place[0]).sum() % 2)


def loops_of(mesh: trimesh.Trimesh, point: np.ndarray, normal: np.ndarray) -> list[Loop]:
    """All loops of the section, seen from ``point`` in the plane."""
    lines = trimesh.intersections.mesh_plane(mesh, normal, point)
    flat = (lines - point) @ plane_axes(normal).T
    names, number = np.unique(np.round(flat.reshape(-1, 2), 8), axis=0, return_inverse=True)
    graph = nx.Graph(number.reshape(-1, 2).tolist())
    assert all(degree == 2 for _, degree in graph.degree)
    polygons = [names[[a for a, _ in nx.find_cycle(graph.subgraph(part))]] for part in nx.connected_components(graph)]
    found = []
    for k, corners in enumerate(polygons):
        others = polygons[:k] + polygons[k + 1 :]
        depth = sum(is_around(other, corners[0]) for other in others)
        found.append(Loop(corners, np.stack([corners, np.roll(corners, -1, axis=0)], axis=1), depth % 2 == 0))
    return found


def distance_of(loop: Loop) -> float:
    """From the origin to the nearest of the loop's segments."""
    a, along = loop.segments[:, 0], loop.segments[:, 1] - loop.segments[:, 0]
    t = np.clip(-(a * along).sum(axis=1) / (along**2).sum(axis=1), 0, 1)
    return float(np.linalg.norm(a + t[:, None] * along, axis=1).min())


def centroid_of(corners: np.ndarray) -> np.ndarray:
    """Of the area of a polygon, by the shoelace formula."""
    following = np.roll(corners, -1, axis=0)
    twice = corners[:, 0] * following[:, 1] - corners[:, 1] * following[:, 0]
    return ((corners + following) * twice[:, None]).sum(axis=0) / (3 * twice.sum())


def mean_distance(loop: Loop, place: np.ndarray) -> float:
    """Of the points of a loop from ``place``, with 20 points on each segment."""
    t = (np.arange(20) + 0.5)[:, None] / 20
    a, along = loop.segments[:, :1], loop.segments[:, 1:] - loop.segments[:, :1]
    length = np.linalg.norm(along, axis=2)[:, 0]
    away = np.linalg.norm(a + t * along - place, axis=2).mean(axis=1)
    return float((length * away).sum() / length.sum())


def dented(seed: int) -> trimesh.Trimesh:
    """A blob with waves across it, so that planes cut it into several loops, nested ones among them."""
    mesh = blob(seed)
    waves = 0.25 * np.cos(9 * np.array(mesh.vertices)).prod(axis=1)
    return trimesh.Trimesh(np.array(mesh.vertices) * (1 + waves[:, None]), mesh.faces, process=False)


def hollow(seed: int) -> trimesh.Trimesh:
    """A dented blob with a cavity of its own shape."""
    outer, inner = dented(seed), dented(seed).apply_scale(0.6)
    inner.invert()
    return trimesh.util.concatenate([outer, inner])


@pytest.mark.parametrize("name", ["blob", "dented", "hollow"])
@pytest.mark.parametrize("seed", [0, pytest.param(1, marks=pytest.mark.slow)])
def test_the_nearest_loop_is_the_one_that_is_joined_from_all_segments(name, seed):
    random = np.random.default_rng(seed)
    mesh = {"blob": blob, "dented": dented, "hollow": hollow}[name](40 + seed)
    shape, num = enclosure(mesh), 60
    points, normals = random.uniform(-0.9, 0.9, (num, 3)), random_normals(random, num)
    found = cut(shape, points, normals, np.full(num, 0.4))
    counts = []
    for k in range(num):
        loops = loops_of(mesh, points[k], normals[k])
        counts.append(len(loops))
        loop = min(loops, key=distance_of, default=None)
        assert found.is_found[k] == (loop is not None and loop.is_outer)
        if loop is None or not loop.is_outer:
            assert_nothing(Sections._make([*(field[k] for field in found[:-1]), found.corners]), points[k])
            continue
        assert found.is_around[k] == is_around(loop.corners, np.zeros(2))
        middle = centroid_of(loop.corners)
        np.testing.assert_allclose(found.centroid[k], points[k] + middle @ plane_axes(normals[k]), atol=1e-6)
        assert found.radius[k] == pytest.approx(mean_distance(loop, middle), rel=0.02)
    assert found.is_around.sum() > 10 and (found.is_found & ~found.is_around).sum() > 5
    assert name != "hollow" or (~found.is_found & (np.array(counts) > 0)).sum() > 5
    assert max(counts) > 1 or name == "blob"


# Which loop, and whether there is one


@pytest.mark.parametrize("turn", [0.1, 1.3, 4.0])
def test_of_the_two_loops_of_a_ring_the_own_one_is_taken(turn):
    spoke = np.array([np.cos(turn), np.sin(turn), 0])
    across = np.cross(spoke, [0, 0, 1])
    for side in (1, -1):
        for off in ([0, 0, 0], 0.2 * spoke, [0, 0, 0.15], -0.2 * spoke):
            found = cut_one(torus(), side * spoke + off, across, 0.35)
            assert found.is_found and found.is_around
            np.testing.assert_allclose(found.centroid, side * spoke, atol=0.02)
            assert found.radius == pytest.approx(0.35, rel=0.04)


def test_a_ring_in_its_own_plane_has_an_outer_loop_and_a_hole():
    """Near the outer loop a section goes around the whole ring; near the hole the nearest loop bounds no area."""
    outer = cut_one(torus(), [1.2, 0.1, 0.01], [0, 0, 1], 0.2)
    assert outer.is_found and outer.is_around
    np.testing.assert_allclose(outer.centroid, [0, 0, 0.01], atol=1e-3)
    assert outer.radius == pytest.approx(1.35, rel=0.02)
    for place in (0.8, 0.5, 0.0):  # in the ring, beyond it, and in the middle of the hole
        assert_nothing(cut_one(torus(), [place, 0.1, 0.01], [0, 0, 1], 0.2), [place, 0.1, 0.01])


def test_in_a_shell_the_cavity_bounds_no_section():
    shell, cavity = trimesh.creation.icosphere(3), trimesh.creation.icosphere(3, radius=0.5)
    cavity.invert()
    mesh = trimesh.util.concatenate([shell, cavity])
    near_shell = cut_one(mesh, [0.9, 0, 0.1], [0, 0, 1], 0.1)
    assert near_shell.is_found and near_shell.is_around
    np.testing.assert_allclose(near_shell.centroid, [0, 0, 0.1], atol=1e-3)
    for place in (0.6, 0.3):
        assert_nothing(cut_one(mesh, [place, 0, 0.1], [0, 0, 1], 0.1), [place, 0, 0.1])
    above = cut_one(mesh, [0.1, 0, 0.6], [0, 0, 1], 0.1)  # this plane misses the cavity
    assert above.is_around and above.radius == pytest.approx(0.8, rel=0.01)


@pytest.mark.parametrize("guess", [0.0, 0.04, 0.1, 0.5, 9.0])
def test_a_loop_is_found_however_far_it_is(guess):
    found = cut_one(trimesh.creation.box().subdivide().subdivide(), [0, 0, 0.1], [0, 0, 1], guess)
    assert found.is_found and found.is_around
    assert not cut_one(trimesh.creation.box(), [0, 0, 0.6], [0, 0, 1], guess).is_found


def test_planes_through_vertices_and_along_faces():
    """What lies in the plane counts as above it: at the top of a box its rim is cut, at the bottom there is nothing."""
    mesh = trimesh.creation.box().subdivide().subdivide()
    for height in (-0.25, 0.0, 0.25, 0.5):
        found = cut_one(mesh, [0.1, 0.2, height], [0, 0, 1])
        assert found.is_found and found.is_around
        np.testing.assert_allclose(found.centroid, [0, 0, height], atol=1e-12)
    assert_nothing(cut_one(mesh, [0.1, 0.2, -0.5], [0, 0, 1]), [0.1, 0.2, -0.5])
    for normal in ([1, 1, 0], [1, 1, 1], [1, -1, 0], [0, 1, 1]):  # along diagonals, through corners
        found = cut_one(mesh, [0.0, 0, 0], normal)
        assert found.is_found and found.is_around
        np.testing.assert_allclose(found.centroid, 0, atol=1e-12)


# What does not matter


def questions(seed: int, num: int = 50) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Points, normals and guesses around a blob."""
    random = np.random.default_rng(seed)
    return random.uniform(-0.9, 0.9, (num, 3)), random_normals(random, num), random.uniform(0.2, 0.6, num)


@pytest.mark.parametrize("scale", [1e-3, 1.0, 1e4])
def test_sections_move_scale_and_turn_with_the_surface(scale):
    mesh, (points, normals, radii) = dented(51), questions(5)
    plain = cut(enclosure(mesh), points, normals, radii)
    turn, shift = Rotation.random(random_state=5).as_matrix(), scale * np.array([3.0, -1, 2])
    moved = Enclosure(scale * np.array(mesh.vertices) @ turn.T + shift, np.array(mesh.faces))
    found = cut(moved, scale * points @ turn.T + shift, normals @ turn.T, scale * radii)
    expected = plain._replace(centroid=scale * plain.centroid @ turn.T + shift, radius=scale * plain.radius)
    assert_same(found, expected, atol=1e-9 * scale)
    assert plain.is_around.sum() > 10


def test_the_order_of_faces_corners_and_vertices_does_not_matter():
    mesh, (points, normals, radii) = hollow(52), questions(6)
    vertices, faces = np.array(mesh.vertices), np.array(mesh.faces)
    plain = cut(Enclosure(vertices, faces), points, normals, radii)
    random = np.random.default_rng(6)
    number = random.permutation(len(vertices))
    turned = (np.arange(3) + random.integers(3, size=(len(faces), 1))) % 3
    shuffled = number[np.take_along_axis(faces, turned, axis=1)][random.permutation(len(faces))]
    assert_same(cut(Enclosure(vertices[np.argsort(number)], shuffled), points, normals, radii), plain)


def test_points_do_not_depend_on_each_other(monkeypatch):
    """All at once, one at a time, and where there is no room for them at first."""
    shape, (points, normals, radii) = enclosure(dented(54)), questions(8, 30)
    together = cut(shape, points, normals, radii)
    alone = [cut(shape, points[k : k + 1], normals[k : k + 1], radii[k : k + 1]) for k in range(30)]
    for k, one in enumerate(alone):
        assert_same(one, together.only(np.arange(30) == k))
    monkeypatch.setattr(sections, "isqrt", lambda num: 0)
    many = cut(shape, np.tile(points, (100, 1)), np.tile(normals, (100, 1)), np.tile(radii, 100))
    for k in range(100):
        assert_same(many.only(np.arange(3000) // 30 == k), together)


def test_the_centroid_moves_as_it_says_when_the_plane_slides_and_turns():
    """On a cone, whose sections change with both, against differences."""
    mesh = trimesh.creation.cone(1.0, 3.0, sections=200)
    shape = Enclosure(np.asarray(mesh.vertices), np.asarray(mesh.faces))
    point = np.array([[0.1, 0.05, 1.0]])
    normal = np.array([[0.2, 0.1, 1.0]])
    normal /= np.linalg.norm(normal)
    radius, step = np.array([0.5]), 1e-4
    here = sections.cut(shape, point, normal, radius)

    def flat(vector):
        return vector - (vector @ normal[0]) * normal[0]

    ends = [sections.cut(shape, point + side * step * normal, normal, radius).centroid[0] for side in (1, -1)]
    expected = flat((ends[0] - ends[1]) / (2 * step))
    assert np.linalg.norm(expected) > 0.02
    np.testing.assert_allclose(flat(here.slide[0]), expected, atol=0.1 * np.linalg.norm(expected))
    turn = np.cross(normal[0], [1.0, 0, 0])
    turned = [normal + side * step * turn for side in (1, -1)]
    ends = [sections.cut(shape, point, n / np.linalg.norm(n), radius).centroid[0] for n in turned]
    expected = flat((ends[0] - ends[1]) / (2 * step))
    assert np.linalg.norm(expected) > 0.02
    np.testing.assert_allclose(flat(here.turn[0] @ turn), expected, atol=0.1 * np.linalg.norm(expected))
