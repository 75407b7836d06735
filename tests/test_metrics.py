"""Figures of curves: closed forms of cylinders, round ends and rings, and what a figure must not depend on."""

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
import trimesh
from conftest import torus

from msf_jax import metrics
from msf_jax.base.errors import MeshError
from msf_jax.metrics import compare, curve_distance, evaluate
from tests.benchmarks.ground_truth import swept_tube

Curve = tuple[np.ndarray, np.ndarray]

LENGTH = 6.0  # of the tubes, whose radius is 1, along z from 0


def straight_tube(ends: str = "flat") -> trimesh.Trimesh:
    """A tube of radius 1 from z = 0 to z = LENGTH, with half balls beyond that if its ends are round."""
    points = np.zeros((50, 3))
    points[:, 2] = np.linspace(0, LENGTH, 50)
    return swept_tube(points, np.ones(50), 24, ends)


@pytest.fixture(scope="module")
def tube() -> trimesh.Trimesh:
    return straight_tube()


@pytest.fixture(scope="module")
def capsule() -> trimesh.Trimesh:
    return straight_tube("round")


def diagonal(mesh: trimesh.Trimesh) -> float:
    """Of the bounding box, the unit of all lengths."""
    return float(np.linalg.norm(mesh.extents))


def line_of(points: Any, *, closed: bool = False) -> Curve:
    """A curve through ``points`` (N, 3) in their order, and back to the first if closed."""
    vertices = np.asarray(points, dtype=float)
    after = np.roll(np.arange(len(vertices)), -1)
    return vertices, np.stack([np.arange(len(vertices)), after], axis=1)[: None if closed else -1]


def upright(start: float, end: float, num: int = 61, aside: float = 0.0) -> Curve:
    """A curve along z, parallel to the axis of the tubes."""
    z = np.linspace(start, end, num)
    return line_of(np.stack([0 * z + aside, 0 * z, z], axis=1))


def circle(num: int = 240, radius: float = 1.0) -> Curve:
    """A closed curve around z."""
    angle = 2 * np.pi * np.arange(num) / num
    return line_of(radius * np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1), closed=True)


def bent() -> tuple[trimesh.Trimesh, Curve]:
    """A tube along an arc, and a curve off its axis that branches and leaves it: no figure at its best."""
    t = np.linspace(0, 2.5, 80)
    mesh = swept_tube(np.stack([3 * np.cos(t), 3 * np.sin(t), 0 * t], axis=1), 0.6 - 0.1 * t, 16)
    s = np.linspace(0.3, 2.3, 30)
    arc = np.stack([2.9 * np.cos(s), 2.9 * np.sin(s), 0.1 * np.sin(9 * s)], axis=1)
    spur = arc[10] + np.array([0.05, 0.1, 0.3]) * np.arange(1, 5)[:, None]
    vertices, edges = line_of(arc)
    chain = np.array([[10, 30], [30, 31], [31, 32], [32, 33]])
    return mesh, (np.concatenate([vertices, spur]), np.concatenate([edges, chain]))


def assert_same(found: dict[str, float], expected: dict[str, float], rel: float = 1e-9) -> None:
    """The same figures in the same order, to rounding."""
    assert list(found) == list(expected)
    assert found == pytest.approx(expected, rel=rel, abs=1e-12)


# A tube and its axis


def test_the_axis_of_a_tube_is_as_good_as_can_be(tube):
    figures = evaluate(tube, upright(1, LENGTH - 1))
    assert list(figures) == [
        *("mesh_components", "genus", "components", "cycles", "loops", "leaves", "inside", "boundedness"),
        *("off_centre", "missed_95", "missed_max", "smoothness", "tip_gap", "length"),
    ]
    counts = [figures[name] for name in ("mesh_components", "components", "genus", "cycles", "loops", "leaves")]
    assert counts == [1, 1, 0, 0, 0, 2]
    assert figures["inside"] == figures["boundedness"] == 1
    assert figures["off_centre"] < 1e-9 and figures["smoothness"] == pytest.approx(1, abs=1e-9)
    assert figures["length"] == pytest.approx((LENGTH - 2) / diagonal(tube))


@pytest.mark.parametrize("shift", [0.1, 0.3, 0.6, 0.9])
def test_off_centre_is_the_shift_in_radii(tube, shift):
    assert evaluate(tube, upright(1, 5, aside=shift))["off_centre"] == pytest.approx(shift, rel=0.01)


def test_a_tilted_curve_is_off_by_where_its_sections_are(tube):
    """A section across the curve has its centroid on the axis, where the plane meets it: (u - v.z) / v_z up from 0."""
    start, end = np.array([0.5, 0, 2.0]), np.array([-0.1, 0, 4.0])
    vertices, edges = line_of(np.linspace(start, end, 2))
    normal, middle = (end - start) / np.linalg.norm(end - start), (start + end) / 2
    on_axis = np.array([0, 0, middle @ normal / normal[2]])
    angle = (np.arange(5000) + 0.5) * 2 * np.pi / 5000
    ellipse = np.stack([np.cos(angle) / normal[2], np.sin(angle)], axis=1)
    pace = np.linalg.norm(ellipse - np.roll(ellipse, 1, axis=0), axis=1)
    mean = (np.linalg.norm(ellipse, axis=1) * pace).sum() / pace.sum()
    expected = np.linalg.norm(on_axis - middle) / mean
    assert evaluate(tube, (vertices, edges))["off_centre"] == pytest.approx(expected, rel=0.02)


@pytest.mark.parametrize("nodes", [5, 160])
def test_half_of_a_curve_is_outside(tube, nodes):
    """By length, whatever the nodes: these are three quarters inside, or all but a few."""
    z = np.concatenate([np.linspace(LENGTH - 2, LENGTH - 0.1, nodes - 1), [LENGTH + 2]])
    figures = evaluate(tube, line_of(np.stack([0.1 + 0 * z, 0 * z, z], axis=1)))
    assert figures["inside"] == pytest.approx(0.5, abs=0.04)
    assert figures["boundedness"] == pytest.approx(1 - 1 / nodes)


def test_what_a_curve_misses_of_a_cylinder_is_its_rim(tube):
    """Nearest to an end is the ball one radius back: a point at r from the axis, or 1 - r up the side, misses the same.

    More than that is missed by 2 pi (1 - r^2) of the ends and 4 pi (1 - r) of the sides, of 14 pi in all.
    """
    figures = evaluate(tube, upright(0.01, LENGTH - 0.01))
    assert figures["missed_max"] == pytest.approx((np.sqrt(2) - 1) / diagonal(tube), rel=0.04)
    r = np.sqrt(1 + (6 - 14 * 0.05) / 2) - 1
    assert figures["missed_95"] == pytest.approx((np.sqrt(1 + r**2) - 1) / diagonal(tube), rel=0.04)


@pytest.mark.parametrize("gap", [0.4, 2.0])
@pytest.mark.parametrize("ends", ["flat", "round"])
def test_the_gap_of_a_tip_is_measured_in_radii(tube, capsule, ends, gap):
    mesh, beyond = (tube, 0.0) if ends == "flat" else (capsule, 1.0)
    figures = evaluate(mesh, upright(gap - beyond, LENGTH + beyond - gap))
    assert figures["tip_gap"] == pytest.approx(gap, rel=0.02)


# Turns


def test_a_corner_is_one_turn_among_many(capsule):
    """Two legs of a fifth of the diagonal each, at right angles: at every hundredth of it 39 turns, one of cosine 0."""
    leg = 0.2 * diagonal(capsule)
    vertices = np.array([[0, 0, 1], [0, 0, 1 + leg], [leg, 0, 1 + leg]])
    for num in (1, 7):  # with however many nodes on a leg
        places = np.concatenate(
            [np.linspace(vertices[0], vertices[1], num + 1)[:-1], np.linspace(*vertices[1:], num + 1)]
        )
        assert evaluate(capsule, line_of(places))["smoothness"] == pytest.approx(38 / 39, abs=1e-6)


# Handles and parts


def test_a_ring_and_its_circle():
    mesh = torus(1.0, 0.35, 60, 24)
    figures = evaluate(mesh, circle())
    assert [figures[name] for name in ("genus", "cycles", "loops", "leaves", "components")] == [1, 1, 1, 0, 1]
    assert figures["inside"] == figures["boundedness"] == 1 and np.isnan(figures["tip_gap"])
    assert figures["length"] == pytest.approx(2 * np.pi / diagonal(mesh), rel=1e-3)
    assert figures["smoothness"] == pytest.approx(np.cos(metrics.STRIDE * diagonal(mesh)), rel=1e-3)
    assert figures["off_centre"] < 0.01 and figures["missed_max"] < 0.01
    assert evaluate(mesh, circle(radius=1.1))["off_centre"] == pytest.approx(0.1 / 0.35, rel=0.03)


def test_counts_of_a_mesh_of_two_parts():
    ring = torus().apply_translation([0, 0, 3])
    mesh = trimesh.util.concatenate([ring, torus(0.8, 0.2)])
    vertices, edges = circle(radius=0.8)
    other, others = circle()
    both = np.concatenate([vertices, other + [0, 0, 3]]), np.concatenate([edges, others + len(vertices)])
    figures = evaluate(mesh, both)
    assert [figures[name] for name in ("mesh_components", "genus", "components", "cycles", "loops")] == [2, 2, 2, 2, 2]
    assert figures["inside"] == 1
    alone = evaluate(mesh, (vertices, edges))
    assert [alone[name] for name in ("mesh_components", "genus", "components", "cycles", "loops")] == [2, 2, 1, 1, 1]
    assert alone["missed_max"] * diagonal(mesh) == pytest.approx(np.hypot(3.35, 0.2) - 0.2, rel=0.02)


# Distance from and to a truth


@pytest.mark.parametrize("aside", [0.0, 0.25])
def test_a_parallel_curve_is_equally_far_both_directions(tube, aside):
    figures = evaluate(tube, upright(1, 5, aside=aside), truth=upright(1, 5, 3))
    for name in ("to_truth_mean", "to_truth_max", "from_truth_mean", "from_truth_max"):
        assert figures[name] == pytest.approx(aside / diagonal(tube), abs=1e-12)


def test_distances_from_a_truth_are_means_by_length(tube):
    """Three hundred edges of next to no length at one end, which is off the truth by 0.5, do not count."""
    z = np.r_[1, np.linspace(4.99, 5, 300)]
    slope = line_of(np.stack([0.5 * (z - 1) / 4, 0 * z, z], axis=1))
    figures = evaluate(tube, slope, truth=upright(1, 5))
    assert figures["to_truth_mean"] == pytest.approx(0.25 / diagonal(tube), rel=0.01)
    assert figures["to_truth_max"] == pytest.approx(0.5 / diagonal(tube), rel=1e-3)


def segment_distance(point: np.ndarray, a: np.ndarray, b: np.ndarray) -> float:
    """Distance from a point to the segment ab, whose ends may be equal."""
    squared = (b - a) @ (b - a)
    t = np.clip((point - a) @ (b - a) / squared, 0, 1) if squared else 0.0
    return float(np.linalg.norm(point - a - t * (b - a)))


@pytest.mark.parametrize("at_once", [4_000_000, 100, 1])
def test_the_distance_is_that_to_the_nearest_edge(monkeypatch, at_once):
    monkeypatch.setattr(metrics, "PAIRS_AT_ONCE", at_once)
    random = np.random.default_rng(2)
    vertices, edges, points = (
        random.normal(size=(15, 3)),
        random.integers(15, size=(20, 2)),
        random.normal(size=(60, 3)),
    )
    edges[3] = 7  # a single place
    expected = [min(segment_distance(point, *vertices[edge]) for edge in edges) for point in points]
    np.testing.assert_allclose(curve_distance(points, vertices, edges), expected, rtol=1e-12)


# Two curves, where both run


def with_spur(aside: float) -> Curve:
    """A line parallel to the axis, and a spur across the tube from its middle."""
    vertices, edges = upright(1, 5, aside=aside)
    spur = vertices[30] + np.array([0, 0.1, 0]) * np.arange(1, 9)[:, None]
    chain = np.stack([[30, *range(61, 68)], range(61, 69)], axis=1)
    return np.concatenate([vertices, spur]), np.concatenate([edges, chain])


def test_a_spur_is_not_where_both_curves_run(tube):
    line, more = upright(1, 5, aside=0.3), with_spur(0.3)
    figures = compare(tube, line, more)
    assert figures["common"] == 1 and figures["other_common"] == pytest.approx(4 / 4.8, rel=1e-9)
    assert figures["off_centre"] == figures["other_off_centre"] == pytest.approx(0.3, rel=0.01)
    assert figures["missed_95"] == figures["other_missed_95"] > 0
    assert evaluate(tube, more)["off_centre"] < 0.295 and evaluate(tube, more)["missed_95"] < figures["missed_95"]


def test_a_curve_beside_itself_and_in_the_other_order():
    mesh, (vertices, edges) = bent()
    points = np.concatenate([vertices[edges].mean(axis=1), vertices])  # every edge as two, below the spacing
    middle = np.arange(len(edges))
    fine = points, np.stack([np.r_[middle, middle], len(edges) + np.r_[edges[:, 0], edges[:, 1]]], axis=1)
    same, whole = compare(mesh, fine, fine), evaluate(mesh, fine)
    assert same["common"] == same["other_common"] == 1
    assert same["off_centre"] == same["other_off_centre"] == pytest.approx(whole["off_centre"], rel=0.02)
    assert same["missed_95"] == same["other_missed_95"] == whole["missed_95"]
    line = line_of(3 * np.stack([np.cos(s := np.linspace(0.3, 2.3, 30)), np.sin(s), 0 * s], axis=1))
    one, two = compare(mesh, fine, line), compare(mesh, line, fine)
    assert {name.removeprefix("other_") if "other_" in name else f"other_{name}": two[name] for name in two} == one
    assert one["other_off_centre"] < one["off_centre"] and one["common"] < 0.95 < one["other_common"]


FORMS = {
    "tuple": lambda vertices, edges: (vertices, edges),
    "any object": lambda vertices, edges: SimpleNamespace(vertices=vertices.tolist(), edges=edges),
    "small numbers": lambda vertices, edges: (vertices, edges.astype(np.uint8)),
}


@pytest.mark.parametrize("form", FORMS)
def test_a_curve_in_any_form_has_the_same_figures(form):
    mesh, (vertices, edges) = bent()
    plain = evaluate(mesh, (vertices, edges), truth=(vertices[:20], edges[:19]))
    curve, truth = FORMS[form](vertices, edges), FORMS[form](vertices[:20], edges[:19])
    assert evaluate((mesh.vertices, mesh.faces), curve, truth=truth) == plain
    assert plain["to_truth_max"] > 0.1 and plain["leaves"] == 3


@pytest.mark.parametrize("scale", [1e-100, 7.0, 1e100])
def test_figures_do_not_depend_on_the_unit(scale):
    mesh, (vertices, edges) = bent()
    plain = evaluate(mesh, (vertices, edges), truth=(vertices[:20], edges[:19]))
    scaled = vertices * scale
    assert_same(evaluate((mesh.vertices * scale, mesh.faces), (scaled, edges), truth=(scaled[:20], edges[:19])), plain)


def test_figures_do_not_depend_on_the_order_of_nodes_edges_and_faces():
    mesh, (vertices, edges) = bent()
    random = np.random.default_rng(4)
    number = random.permutation(len(vertices))
    turned = np.where(random.random((len(edges), 1)) < 0.5, edges, edges[:, ::-1])
    curve = vertices[np.argsort(number)], number[turned][random.permutation(len(edges))]
    shuffled = mesh.vertices, mesh.faces[random.permutation(len(mesh.faces))]
    assert_same(evaluate(shuffled, curve), evaluate(mesh, (vertices, edges)))


def test_what_comes_in_is_left_as_it_is():
    mesh, (vertices, edges) = bent()
    corners, faces = np.array(mesh.vertices), np.array(mesh.faces)[:, ::-1].copy()  # inside out, so that it is repaired
    arrays = [corners, faces, vertices, edges]
    copies = [array.copy() for array in arrays]
    for array in arrays:
        array.flags.writeable = False
    evaluate((corners, faces), (vertices, edges), truth=(vertices, edges))
    for array, copy in zip(arrays, copies, strict=True):
        np.testing.assert_array_equal(array, copy)


# What it refuses

LINE = [[0, 0, 1.0], [0, 0, 2.0]]


@pytest.mark.parametrize(
    ("curve", "message"),
    [
        ({"vertices": LINE, "edges": [[0, 1]]}, "dict is no curve"),
        ((LINE,), "tuple is no curve"),
        ((LINE, None), "no curve|edges of the curve"),
        ((LINE, [[0, 1, 0]]), "no curve|edges of the curve"),
        (([["a", "b", "c"]], []), "tuple is no curve"),
        (([], []), r"vertices of the curve have shape \(0,\)"),
        (([[0, 0], [1, 1]], [[0, 1]]), r"vertices of the curve have shape \(2, 2\)"),
        (([[0, 0, np.nan]], []), "expected .* finite numbers"),
        ((LINE, [[0, 2]]), "edges of the curve are no ids of nodes: expected whole numbers from 0 to 1"),
        ((LINE, [[-1, 0]]), "edges of the curve are no ids of nodes: expected whole numbers from 0 to 1"),
        ((LINE, [[0.5, 1]]), "edges of the curve are no ids of nodes"),
        ((LINE, [[False, True]]), "edges of the curve are no ids of nodes"),
    ],
)
def test_what_is_no_curve_is_refused(tube, curve, message):
    with pytest.raises(MeshError, match=message):
        evaluate(tube, curve)


@pytest.mark.parametrize("extra", [[0, 1], [1, 0], [1, 1]])
def test_an_edge_that_comes_twice_or_leads_nowhere_is_no_cycle(tube, extra):
    figures = evaluate(tube, (LINE, [[0, 1], extra]))
    assert figures["cycles"] == 0 and figures["leaves"] == 2
    assert figures == evaluate(tube, (LINE, [[0, 1]]))
