"""What neurons are saved with: a root that is a soma or is not sure to be, labels, pieces joined, what radii are."""

from dataclasses import replace
from itertools import pairwise

import manifold3d
import numpy as np
import pytest
import trimesh
from scipy.sparse.csgraph import minimum_spanning_tree
from scipy.spatial.distance import cdist

import msf_jax
from msf_jax import ConfigError
from msf_jax.skeleton.skeleton import curve_of


def neuron(soma: float):
    """A fibre of 40 nodes with a fork at 20 and another at 30; the ball at its node 3 is of radius ``soma``."""
    main = np.stack([np.arange(40.0), np.zeros(40), np.zeros(40)], axis=1)
    missed_limbs = [[start + 0.5 * k, 1.0 * k, 0.0] for start in (20, 30) for k in range(1, 6)]
    edges = [(k, k + 1) for k in range(39)] + [(20, 40), (30, 45)]
    edges += [(k, k + 1) for k in (40, 41, 42, 43, 45, 46, 47, 48)]
    radii = np.full(50, 0.1)
    radii[[25, 26]] = 0.3  # a thick neurite
    radii[3] = soma
    return curve_of(np.concatenate([main, missed_limbs]), np.array(edges), radii)


def rows_of(path) -> np.ndarray:
    return np.array([line.split() for line in path.read_text().splitlines() if line[0] != "#"], dtype=float)


@pytest.mark.parametrize(("size", "is_sure"), [(2.0, True), (0.45, True), (0.35, False), (0.1, False)])
def test_a_soma_is_sure_where_it_stands_out(size, is_sure):
    found = neuron(size).soma()
    assert found.is_sure == is_sure
    if size > 0.3:
        assert found.node == 3 and found.contrast == pytest.approx(size / 0.3)
    tree = neuron(size).to_tree("soma")
    assert tree.roots == (found.node,) and ("NOT SURE" in tree.report.notes[-1]) != is_sure


def test_a_curve_of_one_thickness_or_one_ball_has_no_soma():
    assert not neuron(0.1).soma().is_sure
    ball = curve_of(np.zeros((1, 3)), np.empty((0, 2), dtype=int), np.ones(1))
    assert not ball.soma().is_sure


def test_labels_of_an_swc_are_soma_forks_and_ends(tmp_path):
    neuron(2.5).to_tree("soma").save(tmp_path / "a.swc")
    rows = rows_of(tmp_path / "a.swc")
    assert rows[0, :3].tolist() == [1, 1, 3] and rows[0, 6] == -1
    count = {label: int((rows[:, 1] == label).sum()) for label in (0, 1, 5, 6)}
    assert count == {0: 41, 1: 1, 5: 2, 6: 4}  # two ends of the fibre, two side branches
    assert set(rows[rows[:, 1] == 6, 2]) == {0.0, 39.0, 22.5, 32.5}
    neuron(0.3).to_tree("soma").save(tmp_path / "b.swc", label=3)
    assert set(rows_of(tmp_path / "b.swc")[:, 1]) == {3.0}
    for name, label in (("a.obj", 3), ("a.swc", -1)):
        with pytest.raises(ConfigError, match=f"label is {label} for '{name}': expected a whole number"):
            neuron(2.5).save(tmp_path / name, label=label)


def area_of(rows: np.ndarray) -> float:
    """Of the membrane, as simulators count it: a soma of one node is a ball, and its neurites begin with their own
    first node; along other links it is that of a cone."""
    area = 0.0
    for _, label, *place, radius, parent in rows:
        above = rows[int(parent) - 1] if parent > 0 else None
        if label == 1:
            area += 4 * np.pi * radius**2
        elif above is not None and above[1] != 1:
            slant = np.hypot(np.linalg.norm(place - above[2:5]), radius - above[5])
            area += np.pi * (radius + above[5]) * slant
    return area


@pytest.mark.parametrize("size", [2.5, 7.0])
def test_the_area_of_an_swc_is_that_of_a_ball_and_its_neurites(size, tmp_path):
    """Nodes in the soma are as wide as the ball is there; neurites go on through it, and taper."""
    directions = np.array([[0, 0, 1], [0.94, 0, -0.33], [-0.47, 0.82, -0.33]])
    along = np.linspace(0, size + 40, 300)[1:]
    width = np.sqrt(np.maximum(size**2 - along**2, 0))
    thin = np.linspace(0.8, 0.3, 299)
    places = [
        np.zeros((1, 3)),
        *(along[:, None] * one for one in directions / np.linalg.norm(directions, axis=1)[:, None]),
    ]
    edges = [(0 if k == 0 else 299 * arm + k, 299 * arm + k + 1) for arm in range(3) for k in range(299)]
    radii = np.concatenate([[size], *3 * [np.maximum(width, thin)]])
    curve = replace(curve_of(np.concatenate(places), np.array(edges), radii), units="um")
    curve.to_tree("soma").save(tmp_path / "a.swc", label=3)
    rows = rows_of(tmp_path / "a.swc")
    at = np.interp(size, along, thin)
    cones = 3 * np.pi * (at + 0.3) * np.hypot(40, at - 0.3)
    assert area_of(rows) == pytest.approx(4 * np.pi * size**2 + cones, rel=1e-3)
    assert set(rows[1:, 1]) == {3.0} and rows[0].tolist() == [1, 1, 0, 0, 0, size, -1]
    begins = rows[rows[:, 6] == 1]
    assert len(begins) == 3 and np.linalg.norm(begins[:, 2:5], axis=1) == pytest.approx(size)
    assert begins[:, 5] == pytest.approx(at, rel=0.01)
    again = msf_jax.read_curve(tmp_path / "a.swc")
    assert again.report.components == 1 and again.report.cycles == 0 and again.units == "um"


def test_files_say_what_radii_and_units_they_have(tmp_path):
    curve = replace(neuron(2.0), units="µm\nand more")
    curve.save(tmp_path / "a.swc")
    text = (tmp_path / "a.swc").read_text()
    assert "# radius: of the largest ball inside\n" in text and "# units: µm and more\n" in text
    assert msf_jax.read_curve(tmp_path / "a.swc").units == "µm and more"
    curve.save(tmp_path / "a.npz")
    again = msf_jax.read_curve(tmp_path / "a.npz")
    assert (again.units, again.radius_of) == (curve.units, "ball")


@pytest.mark.parametrize("seed", range(5))
def test_pieces_are_joined_by_the_least_length(seed):
    """Lone nodes are pieces: the links are a minimum spanning tree, by SciPy on all distances."""
    points = np.random.default_rng(seed).random((12, 3))
    healed = curve_of(points, np.empty((0, 2), dtype=int), np.full(12, 0.01)).heal()
    assert healed.report.components == 1 and len(healed.edges) == 11
    assert healed.length == pytest.approx(minimum_spanning_tree(cdist(points, points)).sum())


def test_pieces_farther_apart_than_the_reach_stay_apart():
    points = np.array([[0.0, 0, 0], [1, 0, 0], [3, 0, 0], [4, 0, 0], [9, 0, 0], [10, 0, 0], [10.5, 0, 0]])
    curve = curve_of(points, np.array([[0, 1], [2, 3], [4, 5]]), np.full(7, 0.1))
    healed = curve.heal(2.5)
    assert healed.report.components == 2 and len(healed.edges) == 5
    assert "2 pieces were joined" in healed.report.notes[-1]
    assert curve.heal(0.1) is curve
    with pytest.raises(ConfigError, match="reach is -1: expected a length above 0"):
        curve.heal(-1)


@pytest.mark.parametrize("tolerance", [0.02, 0.1, 0.5])
def test_fewer_nodes_keep_the_curve_within_the_tolerance(tolerance):
    """A wave, a straight fork and a ring: ends and the fork stay, the straight part has no node between."""
    x = np.linspace(0, 6, 200)
    wave = np.stack([x, np.sin(2 * x), 0 * x], axis=1)
    straight = [[6.0 + 0.1 * k, np.sin(12.0), 0] for k in range(1, 30)]
    angle = 2 * np.pi * np.arange(60) / 60
    ring = np.stack([np.cos(angle), np.sin(angle), np.full(60, 9.0)], axis=1)
    edges = [(k, k + 1) for k in range(228)] + [(100, 229)] + [(230 + k, 230 + (k + 1) % 60) for k in range(60)]
    points = np.concatenate([wave, straight, [[wave[100, 0], 3.0, 0]], ring])
    curve = curve_of(points, np.sort(np.array(edges), axis=1), np.full(len(points), 0.1))
    found = curve.simplify(tolerance)
    assert found.report.cycles == 1 and found.report.components == 2
    assert len(found.vertices) < 0.5 * len(points)
    away = msf_jax.metrics.curve_distance(points, found.vertices, found.edges)
    assert away.max() <= tolerance + 1e-12
    for kept in (points[0], points[100], points[228], points[229]):
        assert (found.vertices == kept).all(axis=1).any()
    assert not ((found.vertices[:, 0] > 6.05) & (found.vertices[:, 0] < 8.85)).any()
    with pytest.raises(ConfigError, match="tolerance is 0: expected a length above 0"):
        curve.simplify(0)
    # Two junctions at one place, and a triangle of many nodes.
    points = np.array([[0, 0, 0], [1, 0, 0], [1, 0, 0], [2, 0, 0], [1, 1, 0], [1, -1, 0.0]])
    edges = np.array([[0, 1], [1, 2], [2, 3], [1, 4], [2, 5]])
    same = curve_of(points, edges, np.full(6, 0.1)).simplify(0.1)
    assert same.edges.tolist() == sorted(edges.tolist()) and (same.vertices == points).all()
    corner = np.array([[0, 0, 0], [3, 0, 0], [1, 2, 0.0]])
    share = np.linspace(0, 1, 10, endpoint=False)[:, None]
    points = np.concatenate([a + share * (b - a) for a, b in zip(corner, np.roll(corner, -1, axis=0), strict=True)])
    edges = np.sort([(k, (k + 1) % 30) for k in range(30)], axis=1)
    assert len(curve_of(points, edges, np.full(30, 0.1)).simplify(0.1).vertices) == 3


def test_the_root_of_a_tree_may_be_given_by_a_point():
    curve = neuron(0.1)
    assert curve.to_tree((38.6, 0.3, 0.0)).roots == curve.to_tree(np.array([40, 0, 0])).roots == (39,)
    for wrong in ((0.0, 1.0), (0.0, np.nan, 1.0), "x", True):
        with pytest.raises(ConfigError, match="a point"):
            curve.to_tree(wrong)


def test_a_root_in_no_soma_is_told_first_and_cut_loops_are_counted():
    curve = neuron(0.3)
    report = replace(curve.report, genus=24, cycles=11)
    assert "EXPECTED 24" in str(report)
    tree = replace(curve, report=replace(report, notes=("another",))).to_tree("soma").report
    tree = replace(tree, cut=11)
    assert tree.lines()[0] == tree.notes[-1] and "NOT SURE" in tree.lines()[0] and tree.lines()[-1] == "another"
    assert "0 cycles, EXPECTED 13 for genus 24, 11 more cut" in str(tree)
    assert not tree.is_sound  # thirteen loops were missing before
    assert "NOT SURE" not in neuron(2.0).to_tree("soma").report.lines()[0]


def winding(random, start, direction, length) -> list[np.ndarray]:
    """Twelve straight pieces, each at nine degrees to the one before."""
    places = [start]
    for _ in range(12):
        places.append(places[-1] + direction * length / 12)
        side = np.cross(direction, random.normal(size=3))
        direction = direction + np.tan(np.radians(9)) * side / np.linalg.norm(side)
        direction /= np.linalg.norm(direction)
    return places


def made_neuron(seed: int) -> tuple[trimesh.Trimesh, float, int]:
    """A surface, the radius of its soma, a ball at the origin, and the number of its neurites, which taper."""
    random, ball = np.random.default_rng(seed), manifold3d.Manifold.sphere
    size, count = random.uniform(5, 9), 1 + seed
    solid = ball(size, 32)
    for direction in np.array([[0, 0, 1], [0.94, 0, -0.33], [-0.47, 0.82, -0.33], [-0.47, -0.82, -0.33]])[:count]:
        direction = direction / np.linalg.norm(direction)
        places = winding(random, 0.8 * size * direction, direction, random.uniform(40, 70))
        widths = np.linspace(random.uniform(1.0, 1.6), 0.6, 13)
        balls = [ball(width, 16).translate(place.tolist()) for width, place in zip(widths, places, strict=True)]
        for pair in pairwise(balls):
            solid += (pair[0] + pair[1]).hull()
    mesh = solid.to_mesh64()
    return trimesh.Trimesh(mesh.vert_properties[:, :3], mesh.tri_verts, process=False), size, count


@pytest.mark.slow  # areas of curves without a mesh are above
@pytest.mark.parametrize("seed", range(4))
def test_the_swc_of_a_neuron_has_the_area_of_its_mesh(seed, tmp_path):
    mesh, size, count = made_neuron(seed)
    tree = msf_jax.skeletonize(mesh).to_tree("soma").with_radii("section")
    tree.save(tmp_path / "a.swc", label=3)
    rows = rows_of(tmp_path / "a.swc")
    assert area_of(rows) == pytest.approx(mesh.area, rel=0.03)
    assert np.linalg.norm(rows[0, 2:5]) < 0.1 * size and rows[0, 5] == pytest.approx(size, rel=0.04)
    assert (rows[:, 6] == 1).sum() == count and set(rows[1:, 1]) == {3.0}


@pytest.mark.slow  # units and labels of a file are below
def test_navis_knows_the_units_and_the_labels(tmp_path):
    navis = pytest.importorskip("navis")
    curve = replace(neuron(2.0).to_tree("soma"), units="um")
    curve.save(tmp_path / "a.swc")
    read = navis.read_swc(str(tmp_path / "a.swc"), read_meta=True)
    assert str(read.units) in ("1 micrometer", "micrometer") and read.n_nodes == 48  # the soma had five
    assert read.cable_length == pytest.approx(curve.length, rel=1e-5)
    assert read.soma == 1
    soma = read.nodes[read.nodes["label"] == 1]
    assert len(soma) == 1 and soma[["x", "y", "z"]].to_numpy().tolist() == [[3.0, 0.0, 0.0]]
    assert msf_jax.read_curve(tmp_path / "a.swc").length == pytest.approx(curve.length)
