"""Which handles a curve goes around, and loops that are laid: against ranks and linking numbers known by hand."""

from fractions import Fraction

import manifold3d
import numpy as np
import pytest
import trimesh
from conftest import torus
from loop_cases import NO_EDGES, RING, circle, cycle, shape_of, theta, torus_knot, windings

import msf_jax
from msf_jax import metrics
from msf_jax.curve import handle_loops
from msf_jax.inside.containment import Roadmap
from msf_jax.skeleton.report import loops_of
from msf_jax.solid import handles
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import RESOLUTION
from msf_jax.topology.graphs import cycle_count, shortest_forest
from tests.benchmarks import solids


@pytest.mark.parametrize(("width", "is_in"), [(RESOLUTION / 4, True), (4 * RESOLUTION, False)])
def test_a_loop_may_graze_the_surface(width, is_in):
    """A segment through the tip of a wedge that is cut out of a block, where the wedge is ``width`` wide."""
    block = manifold3d.Manifold.cube([1.0, 1.0, 0.2], True)
    wedge = manifold3d.Manifold.cube([1.0, 1.0, 1.0], True).rotate([0, 0, 45]).translate([0, np.sqrt(0.5), 0])
    found = (block - wedge).to_mesh()
    shape = Enclosure(found.vert_properties[:, :3].astype(float), found.tri_verts.astype(np.int64))
    a, b = np.array([[-0.1, width / 2, 0.01]]), np.array([[0.1, width / 2, 0.01]])
    assert not shape.holds(a, b).any()
    assert shape.holds(a, b, sliver=RESOLUTION).tolist() == [is_in]
    is_out = handle_loops.proof(
        shape, np.concatenate([a, b, [[0.0, -0.1, 0.01]]]), np.array([[0, 1], [1, 2], [0, 2]])
    ).outside
    assert (len(is_out) == 0) == is_in


def proof(shape, *polylines):
    """Of closed ``polylines`` (n, 3)."""
    first = np.cumsum([0, *map(len, polylines)]).tolist()
    edges = np.concatenate([cycle(len(line), start) for line, start in zip(polylines, first, strict=False)])
    return handle_loops.proof(shape, np.concatenate(polylines), edges)


def counts(found):
    """rank, and how many cycles go around nothing, again around others, several times, or outside."""
    return found.rank, len(found.none), len(found.again), len(found.several), len(found.outside)


@pytest.mark.parametrize(
    ("curves", "expected"),
    [
        ([circle(1.0)], (1, 0, 0, 0, 0)),
        ([circle(0.1, (1.0, 0, 0))], (0, 1, 0, 0, 0)),  # moved off the hole, into the tube
        ([circle(1.0), circle(1.05)], (1, 0, 1, 0, 0)),
        ([circle(0.1, (1.0, 0, 0)), circle(1.0), circle(1.05), circle(0.95)], (1, 1, 2, 0, 0)),
        ([torus_knot(2, 1)], (1, 0, 0, 1, 0)),  # twice around: a rank of 1, but no middle of the ring
        ([torus_knot(2, 1), torus_knot(3, 1)], (1, 0, 1, 1, 0)),
        ([circle(0.6, (1.0, 0, 0))[:, [0, 2, 1]]], (0, 0, 0, 0, 1)),  # around the tube, outside
        ([circle(1.4)], (0, 0, 0, 0, 1)),  # around the ring, outside
    ],
)
def test_proof_of_curves_in_a_ring(curves, expected):
    assert counts(proof(RING, *curves)) == expected


def test_two_loops_are_no_basis_where_one_is_the_other_and_twice_a_third():
    """Around holes a and a + 2 b of a plate: a rank of 2, and still no curve of it."""
    shape = shape_of(solids.plate(2))
    one, other = circle(1.8, (2.5, 3.0, 0.5)), circle(-1.8, (7.5, 3.0, 0.5))
    assert counts(proof(shape, one, other)) == (2, 0, 0, 0, 0)
    both = np.concatenate([one, [[5.0, 3.0, 0.5]], other, circle(-1.6, (7.5, 3.0, 0.5)), [[5.0, 3.0, 0.4]]])
    assert counts(proof(shape, both, circle(1.7, (2.5, 3.0, 0.4)))) == (2, 0, 0, 1, 0)


@pytest.mark.parametrize("num_holes", [0, 1, 4, 9])
def test_a_plate_has_a_loop_around_each_hole_and_one_around_several_adds_none(num_holes):
    shape = shape_of(solids.plate(num_holes))
    assert shape.handles.genus == num_holes
    columns = {0: 1, 1: 1, 4: 3, 9: 4}[num_holes]
    rows = -(-num_holes // columns)
    cell = np.array([10 / columns, 6 / max(rows, 1)])
    places = [np.array([k % columns + 0.5, k // columns + 0.5]) * cell for k in range(num_holes)]
    around = [circle(0.3 * cell.min(), (*place, 0.5)) for place in places]
    rim = np.linspace(0, 2 * np.pi, 120, endpoint=False)
    frame = np.clip(1.5 * np.stack([np.cos(rim), np.sin(rim)], axis=1), -1, 1) * [4.9, 2.9] + [5.0, 3.0]
    all_of_them = np.column_stack([frame, np.full(120, 0.4)])
    corner = circle(0.1, (0.2, 0.2, 0.5))
    assert counts(proof(shape, *around, all_of_them, corner)) == (
        (num_holes, 1, 1, 0, 0) if num_holes else (0, 2, 0, 0, 0)
    )


def test_the_linking_number_tells_linked_rings_from_rings_apart():
    for are_linked in (True, False):
        mesh, (points, edges) = solids.rings(are_linked), solids.ring_curves(are_linked)
        assert counts(handle_loops.proof(shape_of(mesh), points, edges)) == (2, 0, 0, 0, 0)
        one, _ = mesh.split()
        own = proof(shape_of(one), points[:48]).rank + proof(shape_of(one), points[48:]).rank
        assert own == 1
        of_other = [windings(shape_of(one), line).any() for line in (points[:48], points[48:])]
        assert sorted(of_other) == [are_linked, True]


@pytest.mark.parametrize("seed", range(8))
def test_moves_scales_and_numbers_do_not_matter(seed):
    vertices, faces, points, edges = theta()
    assert counts(handle_loops.proof(Enclosure(vertices, faces), points, edges)) == (2, 1, 2, 0, 0)
    random = np.random.default_rng(seed)
    turn = trimesh.transformations.random_rotation_matrix(random.uniform(size=3))[:3, :3]
    scale, shift = 10.0 ** random.uniform(-3, 3), random.normal(size=3)
    order, number = random.permutation(len(vertices)), random.permutation(len(points))
    moved, nodes = (scale * (each @ turn.T + shift) for each in (vertices, points))
    turned = np.where(random.random((len(edges), 1)) < 0.5, edges, edges[:, ::-1])
    found = handle_loops.proof(
        Enclosure(moved[order], random.permutation(np.argsort(order)[faces])),
        nodes[np.argsort(number)],
        number[turned][random.permutation(len(edges))],
    )
    assert counts(found) == (2, 1, 2, 0, 0)


def test_edges_side_by_side_are_cycles_around_nothing():
    """The same edge twice, either way, and an edge from a node to itself; components apart; no edge; no node."""
    line, ends = circle(1.0), cycle(120)
    doubled = np.concatenate([ends, ends[:3], ends[5:7, ::-1], [[9, 9]]])
    assert counts(handle_loops.proof(RING, line, doubled)) == (1, 6, 0, 0, 0)
    assert handle_loops.independent(RING, line, doubled).sum() == 120
    for nodes in (line[:1], line[:0]):
        assert counts(handle_loops.proof(RING, nodes, NO_EDGES)) == (0, 0, 0, 0, 0)
    ball = shape_of(trimesh.creation.icosphere(2, 2.0))
    assert counts(proof(ball, line)) == (0, 1, 0, 0, 0) and ball.handles.genus == 0


def rank_by_fractions(matrix):
    rows, rank = [[Fraction(int(value)) for value in row] for row in matrix], 0
    for column in range(matrix.shape[1]):
        pivot = next((k for k in range(rank, len(rows)) if rows[k][column]), None)
        if pivot is None:
            continue
        rows[rank], rows[pivot] = rows[pivot], rows[rank]
        for k in range(rank + 1, len(rows)):
            factor = rows[k][column] / rows[rank][column]
            rows[k] = [one - factor * other for one, other in zip(rows[k], rows[rank], strict=True)]
        rank += 1
    return rank


@pytest.mark.parametrize("seed", range(10))
def test_the_rank_modulo_a_prime_is_that_of_fractions(seed):
    """Row by row; entries of either sign, some as large as the prime."""
    random = np.random.default_rng(seed)
    few = random.integers(-3, 4, (3, 8))
    matrix = np.concatenate([few, random.integers(-2, 3, (6, 3)) @ few, random.integers(-(2**40), 2**40, (3, 8))])
    matrix = matrix[random.permutation(len(matrix))]
    span = handles.Span()
    for k, row in enumerate(matrix):
        before, after = (rank_by_fractions(matrix[:num]) for num in (k, k + 1))
        assert span.add(row[None])[0] == (after > before)


def rank_modulo(matrix, prime):
    """Which rows (k,) of a matrix are outside the span of those before, by Python's integers."""
    basis, is_new = [], []
    for row in (matrix % prime).tolist():
        for pivot, other in basis:
            row = [(one - row[pivot] * two) % prime for one, two in zip(row, other, strict=True)]
        pivot = next((k for k, one in enumerate(row) if one), None)
        is_new.append(pivot is not None)
        if pivot is not None:
            basis.append((pivot, [one * pow(row[pivot], -1, prime) % prime for one in row]))
    return is_new


@pytest.mark.parametrize("prime", [handles.PRIME, *handle_loops.FACTORS])
def test_many_vectors_at_once_are_added_as_one_by_one(prime):
    """More than a block holds, with entries of all sizes; a rank by halves of numbers is exact."""
    random, num = np.random.default_rng(5), 2 * handles.BLOCK + 10
    few = random.integers(0, handles.PRIME, (num, num + 5))
    mixed = random.integers(-3, 4, (num, num)) @ few % handles.PRIME
    matrix = np.concatenate([few[:50], few[:20] + few[10:30], few[40:], mixed[:30]])
    expected = rank_modulo(matrix, prime)
    span = handles.Span(prime)
    assert span.add(matrix[:70]).tolist() + [span.add(row[None])[0] for row in matrix[70:]] == expected
    assert sum(expected) == num or prime in handle_loops.FACTORS
    assert not span.add(matrix).any()


@pytest.fixture(scope="module")
def plate():
    """A plate with two holes, and its skeleton."""
    return (mesh := solids.plate(2)), msf_jax.skeletonize(mesh)


@pytest.mark.slow  # ranks and their proofs have many tests above
def test_too_many_handles_are_not_proved_and_the_report_says_so(plate, monkeypatch):
    """A limit on linking numbers just below, and far below, what the curve of a plate needs."""
    mesh, skeleton = plate
    curve, num = (skeleton.vertices, skeleton.edges), len(skeleton.edges)
    assert skeleton.report.is_sound and skeleton.report.loops == 2
    monkeypatch.setattr(handle_loops, "MOST_LINKING", 4 * num)
    assert loops_of(shape_of(mesh), *curve)["loops"] == 2
    monkeypatch.setattr(handle_loops, "MOST_LINKING", 4 * num - 1)
    doubt = f"the loops were not proved: 2 handles are too many for a curve of {num} edges"
    assert loops_of(shape_of(mesh), *curve) == {"loops": None, "doubts": (doubt,)}
    assert np.isnan(metrics.evaluate(mesh, skeleton)["loops"])
    monkeypatch.setattr(handle_loops, "MOST_LINKING", 0)
    report = msf_jax.skeletonize(torus()).report
    assert report.loops is None and not report.is_sound and "too many for a curve" in str(report)


@pytest.mark.slow  # as rare
def test_a_search_that_reaches_its_limit_says_so(plate, monkeypatch):
    """Of a curve without loops in a plate with two holes, before the first path is tried."""
    mesh, skeleton = plate
    is_in_tree = shortest_forest(len(skeleton.vertices), skeleton.edges, np.zeros(len(skeleton.edges)))
    curve = skeleton.vertices, skeleton.edges[is_in_tree]
    whole, cut = (Roadmap(shape_of(mesh)) for _ in range(2))
    assert len(handle_loops.completed(whole, *curve, 2)[1]) > len(curve[1])
    assert whole.num_unsought == 0 and whole.num_linked > 0
    monkeypatch.setattr(handle_loops, "MOST_LINKING", 4 * len(curve[1]))
    cut.num_linked = handle_loops.MOST_LINKING
    assert len(handle_loops.completed(cut, *curve, 2)[1]) == len(curve[1]) and cut.num_unsought == 2
    monkeypatch.setattr(handle_loops, "MOST_LINKING", 0)
    cut.num_unsought = 0
    assert handle_loops.completed(cut, *curve, 2)[1] is curve[1] and cut.num_unsought == 2


def test_a_loop_proves_nothing_by_what_it_crosses_of_another_solid():
    """Two bodies overlap: a loop in one, around the tube of the other where that is in the first, goes around none."""
    ring, ball = torus(minor=0.2), trimesh.creation.icosphere(3, 0.6).apply_translation([1.0, 0, 0])
    both = trimesh.util.concatenate([ring, ball])
    shape = shape_of(both)
    across = circle(0.4, (1.0, 0.0, 0.0))[:, [0, 2, 1]]
    assert shape.holds(across, np.roll(across, -1, axis=0)).all()
    node_of_vertex = np.r_[np.zeros(len(ring.vertices), int), np.full(len(ball.vertices), 120)]
    nodes, edges = np.concatenate([circle(1.0), across]), np.concatenate([cycle(120), cycle(120, 120)])
    assert counts(handle_loops.proof(shape, nodes, edges, node_of_vertex)) == (1, 1, 0, 0, 0)
    assert counts(handle_loops.proof(shape, nodes, edges)) == (1, 1, 0, 0, 0)


def test_a_ring_within_a_ring_has_its_own_loop():
    """A ring within a ring: both curves are in the middle, or one is beside the other."""
    outer, inner = torus(minor=0.35), torus(minor=0.15)
    shape = shape_of(trimesh.util.concatenate([outer, inner]))
    edges = np.concatenate([cycle(120), cycle(120, 120)])
    node_of_vertex = np.r_[np.zeros(len(outer.vertices), int), np.full(len(inner.vertices), 120)]
    both = np.concatenate([circle(1.0), circle(1.0)])
    assert counts(handle_loops.proof(shape, both, edges, node_of_vertex)) == (2, 0, 0, 0, 0)
    beside = np.concatenate([circle(1.0, (0, 0, 0.25)), circle(1.0)])
    assert counts(handle_loops.proof(shape, beside, edges)) == (2, 0, 0, 0, 0)
    report = msf_jax.skeletonize(trimesh.util.concatenate([outer, inner.invert() or inner])).report
    assert report.loops == report.cycles == report.genus == 2  # a cavity that is one: all of the curve is in its wall
    assert report.doubts[0] == "100% of the curve's length is in sheets, where its path is arbitrary"


def test_a_loop_that_is_missing_is_laid_around_the_hole():
    """From half a ring, and from a lone node; a path from one part of a curve to another is no loop."""
    shape = Enclosure(RING.vertices / 3, RING.faces)
    half = circle(1 / 3)[:60]
    edges = cycle(60)[:-1]
    for nodes, links in ((half, edges), (half[:1], NO_EDGES)):
        x, e = handle_loops.completed(Roadmap(shape), nodes, links, 1)
        assert cycle_count(len(x), e) == (1, 1) and counts(handle_loops.proof(shape, x, e)) == (1, 0, 0, 0, 0)
        np.testing.assert_array_equal(x[: len(nodes)], nodes)
    apart = np.concatenate([half[5:25], half[35:55]])
    x, e = handle_loops.completed(Roadmap(shape), apart, np.concatenate([edges[:19], edges[:19] + 20]), 1)
    assert (len(x), len(e)) == (40, 38)


def test_no_loop_is_laid_where_there_is_none_or_no_node_to_begin_at():
    shape = Enclosure(RING.vertices / 3, RING.faces)
    whole, edges = circle(1 / 3), cycle(120)
    x, e = handle_loops.completed(Roadmap(shape), whole, edges, 1)
    assert len(x) == 120 and len(e) == 120
    outside = circle(0.6)[:50]
    assert list(Roadmap(shape).loops_from(outside, edges[:49])) == []


def test_false_cycles_are_cut_at_their_longest_edge_and_true_ones_stay():
    nodes = np.concatenate([circle(1.0), circle(0.1, (1.0, 0, 0), 12), circle(1.05)])
    edges = np.concatenate([cycle(120), cycle(12, 120), cycle(120, 132)])
    nodes[125] += [-0.02, 0.0, 0.0]  # its two edges are the longest of the small one
    stays = handle_loops.independent(RING, nodes, edges)
    length = np.linalg.norm(nodes[edges[:, 0]] - nodes[edges[:, 1]], axis=1)
    gone = np.flatnonzero(~stays)
    assert len(gone) == 2 and 120 <= gone[0] < 132 <= gone[1]
    assert length[gone[0]] == length[120:132].max()
    assert counts(handle_loops.proof(RING, nodes, edges[stays])) == (1, 0, 0, 0, 0)
