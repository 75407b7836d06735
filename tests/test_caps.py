"""Caps of a surface: closed forms on solids whose limbs are known, and one branch for each limb."""

import pickle
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from functools import partial
from itertools import pairwise

import manifold3d
import numpy as np
import pytest
import trimesh
from scipy.spatial.transform import Rotation
from test_branches import as_edges, chain

import msf_jax
from msf_jax import ground_truth
from msf_jax.host.curve import branches, centring, containment, finishing
from msf_jax.host.poles.roadmap import Roadmap
from msf_jax.host.solid.enclosure import Enclosure
from msf_jax.host.thin import caps, one_branch
from msf_jax.host.thin.caps import RATIO, Cap, Caps

RADIUS = 0.3
NOT_HELD = np.zeros(3, dtype=bool)
LIMB = {
    "short cylinder": (manifold3d.Manifold.cylinder(0.6, RADIUS, RADIUS, 48), 2.0),
    "long cylinder": (manifold3d.Manifold.cylinder(1.5, RADIUS, RADIUS, 48), 5.0),
    "cone": (manifold3d.Manifold.cylinder(1.2, RADIUS, 0.0, 48), (np.hypot(1.2, RADIUS) / RADIUS - 1) / 2),
    "half ball": (manifold3d.Manifold.sphere(1.0, 48), 0.5),
}


Curve = tuple[np.ndarray, np.ndarray]


def solid(found: manifold3d.Manifold, edge: float = 0.25) -> Enclosure:
    mesh = found.refine_to_length(edge).to_mesh()
    return Enclosure(np.array(mesh.vert_properties[:, :3], dtype=float), np.array(mesh.tri_verts, dtype=np.int64))


def block() -> manifold3d.Manifold:
    """A block of 4 x 4 x 2 whose top is at height 0."""
    return manifold3d.Manifold.cube((4, 4, 2), True).translate((0, 0, -1))


def fingers() -> manifold3d.Manifold:
    """The block with four fingers, each four radii long."""
    each = [manifold3d.Manifold.cylinder(1.0, 0.25, 0.25, 24).translate((x, 0, 0)) for x in (-1.2, -0.4, 0.4, 1.2)]
    return manifold3d.Manifold.batch_boolean([block(), *each], manifold3d.OpType.Add)


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


def limbs(shape: Enclosure, least: float, *more: int) -> list[Cap]:
    found = Caps(shape)
    return found.limbs(least, np.concatenate([found.tips(), np.array(more, dtype=np.int64)]))[0]


def nearest(shape: Enclosure, point) -> int:
    return int(((shape.vertices - point) ** 2).sum(axis=1).argmin())


def none(shape: Enclosure) -> np.ndarray:
    return np.zeros(len(shape.vertices), dtype=np.int64)


@pytest.mark.parametrize("name", LIMB)
def test_slenderness_has_closed_forms(name):
    """Of the largest cap on the limb; discs differ by `RATIO`, so it may be that much smaller."""
    limb, expected = LIMB[name]
    shape = solid(block() + limb, 0.07)
    top = shape.vertices[:, 2].max()
    rows, _ = Caps(shape).grown(nearest(shape, (0, 0, top)), none(shape))
    along = top + RADIUS if "cylinder" in name else np.hypot(top, RADIUS) if name == "cone" else np.pi / 2
    most = rows[rows[:, 1] < 1.05 * along, 0].max()
    assert expected / RATIO**1.5 - 0.05 < most < 1.08 * expected + 0.05


def test_a_flat_disc_has_none_and_the_middle_of_its_curve_is_its_tip():
    shape = solid(block(), 0.1)
    tip = nearest(shape, (0, 0, 0))
    rows, region = Caps(shape).grown(tip, none(shape))
    flat = rows[rows[:, 1] < 1.8]
    assert len(flat) > 10 and np.abs(flat[:, 0]).max() < 0.06
    np.testing.assert_allclose(flat[:, 2], np.pi * flat[:, 1] ** 2, rtol=0.15)
    np.testing.assert_allclose(flat[:, 3:], np.broadcast_to(shape.vertices[tip], (len(flat), 3)), atol=0.05)
    assert tip in region and rows[-1, 2] < shape.mesh.triangles.size


@pytest.mark.parametrize("change", ["scaled", "turned", "permuted", "split"])
def test_limbs_belong_to_the_surface(change):
    shape = solid(fingers(), 0.15)
    x, faces = shape.vertices, shape.faces
    turn = Rotation.random(random_state=3)
    rng = np.random.default_rng(1)
    if change == "scaled":
        other = Enclosure(1e3 * x, faces)
    elif change == "turned":
        other = Enclosure(turn.apply(x), faces)
    elif change == "split":
        other = Enclosure(*trimesh.remesh.subdivide(x, faces))
    else:
        order = rng.permutation(len(x))
        other = Enclosure(x[order], np.argsort(order)[faces][rng.permutation(len(faces))])
    found = [limbs(each, 1.2) for each in (shape, other)]
    assert [len(each) for each in found] == [4, 4]
    value = [sorted(cap.slenderness for cap in each) for each in found]
    np.testing.assert_allclose(*value, rtol=1e-6 if change in ("scaled", "turned") else 0.15)
    for cap in found[0]:
        assert abs(cap.slenderness - 4) < 0.6 and shape.vertices[cap.tip, 2] > 0.9


def test_a_ring_a_ball_and_the_middle_of_a_tube_are_no_limbs():
    """A cap is cut off by one curve, and is less than half of the surface."""
    ring = trimesh.creation.torus(1.0, 0.25, 64, 24)
    assert not limbs(Enclosure(ring.vertices, ring.faces), 0.9)
    ball = trimesh.creation.icosphere(4)
    assert not limbs(Enclosure(ball.vertices, ball.faces), 0.9)
    tube = solid(manifold3d.Manifold.cylinder(6.0, 0.3, 0.3, 32), 0.1)
    side = nearest(tube, (0.3, 0, 3.0))
    found = limbs(tube, 1.2, side)
    assert sorted(round(tube.vertices[cap.tip, 2]) for cap in found) == [0, 6]
    assert side not in [cap.tip for cap in found]


def test_a_small_island_belongs_to_the_cap_and_a_large_one_does_not():
    """Around a finger's base, a disc cuts the finger off besides: it fills it while it is smaller than the disc."""
    shape = solid(block() + LIMB["long cylinder"][0], 0.1)
    tip, top = nearest(shape, (0.9, 0, 0)), nearest(shape, (0, 0, 1.5))
    rows, region = Caps(shape).grown(tip, none(shape))
    assert top in region
    others = none(shape)
    others[top] = 1
    stopped, region = Caps(shape).grown(tip, others)
    assert 0 < len(stopped) < len(rows) and top not in region
    np.testing.assert_array_equal(stopped, rows[: len(stopped)])


def test_a_limb_keeps_the_leaf_farthest_from_its_base_and_others_are_missing():
    points = np.array([[0, 0, 1.0], [0, 0, 0.5], [3, 0, 1.0], [9, 9, 9]])
    limbs = [Cap(0, 2.0, 1.0, points[:1], 0.1, np.array([0, 1])), Cap(2, 3.0, 2.0, points[2:3], 0.1, np.array([2]))]
    foot = np.array([1, 0, 3])

    def from_base(_: Cap) -> np.ndarray:
        return points[:, 2]

    rank, missing = one_branch.matched(foot, NOT_HELD, limbs, 4, from_base)
    assert rank.tolist() == [1, 0, -1] and [cap.tip for cap in missing] == [2]
    for size, expected in ((0.24, [1, 0, -1]), (0.26, [0, 1, -1])):  # a held one is 0.5 lower: by a radius, or less
        near = [limbs[0]._replace(step=size), limbs[1]]
        rank, _ = one_branch.matched(foot, np.array([True, False, False]), near, 4, from_base)
        assert rank.tolist() == expected


@pytest.mark.parametrize("at", [2.0, 7.5])
def test_a_pin_on_the_side_of_a_bar_leaves_both_its_ends(at):
    mesh = ground_truth.swept_tube(np.linspace([0, 0, 0], [10, 0, 0], 100), np.full(100, 0.6), 16)
    pin = int(np.linalg.norm(np.asarray(mesh.vertices) - [at, 0.6, 0], axis=1).argmin())
    skeleton = msf_jax.skeletonize(mesh, pins=[pin])
    assert skeleton.vertices[:, 0].min() < 0.4 and skeleton.vertices[:, 0].max() > 9.6
    assert np.isclose(skeleton.vertices, np.asarray(mesh.vertices)[pin]).all(axis=1).any()


def test_distances_from_the_base_of_a_finger_are_its_length():
    shape = solid(block() + LIMB["long cylinder"][0], 0.1)
    (cap,) = [cap for cap in limbs(shape, 2.0) if shape.vertices[cap.tip, 2] > 1]
    away = Caps(shape).from_base(cap)
    side = (np.abs(np.hypot(*shape.vertices[:, :2].T) - RADIUS) < 1e-6) & (shape.vertices[:, 2] > 0.5)
    base = (shape.vertices[side, 2] - away[side]).mean()  # below it, near the block's top
    assert abs(base) < 0.2 and np.ptp(shape.vertices[side, 2] - away[side]) < 0.15


def test_a_limb_keeps_its_leaf_and_the_one_farthest_from_it():
    x, edges = legs(
        [(0, 0, 0), (1, 0, 0)], [(0, 0, 0), (-1, 0, 0)], [(0, 0, 0), (0, 1, 0)], [(0, 0, 0), (0, 0, 2)], step=0.5
    )
    leaf = np.flatnonzero(np.bincount(edges.ravel()) == 1)
    worth = np.zeros(len(x))
    worth[leaf] = [np.inf, 0.4, 0.2, 0.3]
    stays, target = one_branch.kept(x, edges, worth, np.zeros(len(x), dtype=bool))
    left = np.flatnonzero(np.bincount(edges[stays[edges].all(axis=1)].ravel(), minlength=len(x)) == 1)
    assert left.tolist() == [leaf[0], leaf[3]]
    assert set(target[~stays].tolist()) == {0} and (target[stays] == np.flatnonzero(stays)).all()
    held = np.isin(np.arange(len(x)), leaf[1])
    stays, _ = one_branch.kept(x, edges, worth, held)
    assert stays[leaf].tolist() == [True, True, False, False]


def test_components_keep_their_longest_path_unless_they_have_a_loop_or_two_limbs():
    tree = legs([(0, 0, 0), (1, 0, 0)], [(0, 0, 0), (-2, 0, 0)], [(0, 0, 0), (0, 3, 0)], step=1.0)
    ring = np.array([(0.0, 0, 9), (1, 0, 9), (0, 1, 9), (-4, 0, 9)]), as_edges([(0, 1), (1, 2), (2, 0), (0, 3)])
    parts = [tree, (tree[0] + (0, 0, 5), tree[1]), ring]
    first = np.cumsum([0] + [len(x) for x, _ in parts])
    x = np.concatenate([part[0] for part in parts])
    edges = np.concatenate([part[1] + at for part, at in zip(parts, first, strict=False)])
    leaf = one_branch.leaves_of(tree[1])
    stays = np.zeros(len(x), dtype=bool)
    stays[leaf[:2] + first[1]] = True
    assert np.flatnonzero(one_branch.ends(x, edges, stays)).tolist() == leaf[1:].tolist()
    stays[:] = False
    stays[leaf[0]] = True
    found = np.flatnonzero(one_branch.ends(x, edges, stays))
    assert found.tolist() == [leaf[0], leaf[2], *(leaf[1:] + first[1])]


def test_a_lost_limb_gets_a_branch_through_its_middle():
    shape = solid(block() + LIMB["long cylinder"][0], 0.1)
    trunk = legs([(0, 0, -1.02), (1.4, 0, -1)], [(0, 0, -1.02), (-1.4, 0, -1)])
    found = [cap for cap in limbs(shape, 1.2) if shape.vertices[cap.tip, 2] > 1]
    assert len(found) == 1
    x, edges = one_branch.grown(shape, *trunk, found)
    assert branches.cycle_count(len(x), edges) == (1, 0)
    np.testing.assert_array_equal(x[: len(trunk[0])], trunk[0])
    new = x[len(trunk[0]) :]
    assert np.hypot(*new[:, :2].T).max() < 0.5 * RADIUS
    assert new[:, 2].max() == pytest.approx(1.5 - 0.3 * RADIUS, abs=0.03)


def test_a_finger_begins_in_the_palm_and_not_at_the_finger_beside_it_nor_in_a_body_nearby():
    """The nearest node is of the other finger, and the nearest ball is the body's, across a gap."""
    palm = manifold3d.Manifold.cube((2, 0.6, 2), True)
    finger = manifold3d.Manifold.cylinder(1.5, 0.2, 0.2, 24)
    body = manifold3d.Manifold.sphere(3.0, 64).translate((0, 3.35, 1.2))
    bridge = manifold3d.Manifold.cylinder(1.5, 0.25, 0.25, 24).rotate((-90, 0, 0)).translate((0, 0, -0.8))
    parts = [palm, finger.translate((0.3, 0, 0.8)), finger.translate((-0.3, 0, 0.8)), body, bridge]
    shape = solid(manifold3d.Manifold.batch_boolean(parts, manifold3d.OpType.Add), 0.3)
    x, edges = legs(
        [(0, 0, -0.4), (0.3, 0, 0.6), (0.3, 0, 2.1)],
        [(0, 0, -0.4), (0, 0, -0.8), (0, 3.35, -0.8), (0, 3.35, 2.0)],
        step=0.1,
    )
    base = np.array([-0.3, 0, 1.2])
    found = Cap(0, 4.0, 0.1, np.array([(-0.3, 0, 2.1), base]), 0.1, np.empty(0, dtype=np.int64))
    radius, away = shape.approximate_clearance(x)[0], np.linalg.norm(x - base, axis=1)
    assert x[away.argmin(), 2] > 1.0 and x[(away - radius).argmin(), 1] > 0.5
    _, grown = one_branch.grown(shape, x, edges, [found])
    begin = x[grown[len(edges)].min()]
    assert grown[len(edges)].max() == len(x) and abs(begin[1]) < 0.1 and begin[2] < 1.0


def test_the_body_is_a_limb_beyond_half_of_the_surface():
    """Two ears on a ball: each ear is one, and the ball is the third, though it has most of the surface."""
    ears = [LIMB["long cylinder"][0].translate((x, 0, 0.7)) for x in (-0.35, 0.35)]
    shape = solid(
        manifold3d.Manifold.batch_boolean([manifold3d.Manifold.sphere(1.0, 48), *ears], manifold3d.OpType.Add), 0.1
    )
    found = limbs(shape, 1.2)
    assert sorted(round(shape.vertices[cap.tip, 2], 1) > 0 for cap in found) == [False, True, True]


def test_a_part_with_a_handle_is_no_limb():
    """A handle of a large ball: no cap without the handle is slender, and a curve has a loop there, not a leaf."""
    ring = manifold3d.Manifold.revolve(manifold3d.CrossSection.circle(0.2, 24).translate((0.8, 0)), 64)
    shape = solid(manifold3d.Manifold.sphere(1.0, 64) + ring.rotate((90, 0, 0)).translate((1.5, 0, 0)), 0.1)
    assert not limbs(shape, 1.2)


def test_limbs_without_a_leaf_get_one_and_leaves_in_the_body_go():
    """Three leaves in a block with four fingers: a component keeps two until fingers have theirs."""
    shape = solid(fingers(), 0.15)
    x, edges = legs(*[[(0, 0, -1.02), (a, b, -1)] for a, b in ((1.4, 1.4), (-1.4, -1.4), (-1.4, 1.4))])
    number, none = np.arange(len(x)), np.zeros(len(x), dtype=bool)
    draft = finishing.Draft(x, edges, none, number, number, x, none)
    job = finishing.Job(
        shape, shape, 1.2, False, Roadmap(shape, containment.is_inside), centring.Budget(), partial(Caps, shape)
    )
    found = finishing.limbed(draft, job, grows=True)
    leaves = found.vertices[found.is_leaf()]
    assert len(leaves) == 4 and (leaves[:, 2] > 0.8).all() and (found.num_grown, found.num_pruned) == (4, 3)
    assert branches.cycle_count(len(found.vertices), found.edges) == (1, 0)


def test_a_small_limb_counts_half():
    """`SMALL`, `SMALLER`: of a finger on blocks of any size, and a finger of that share is a limb or none."""
    length, radius, refined = 0.75, 0.25, 0.1  # three radii long
    finger = manifold3d.Manifold.cylinder(length, radius, radius, 32).refine_to_length(refined)
    own = 2 * np.pi * radius * length + np.pi * radius**2
    most = []
    for share in (0.002, 0.0016, 0.0009, 0.0007):
        size = np.sqrt(own / share / 64)
        body = manifold3d.Manifold.cube((4 * size, 4 * size, 2 * size), True).translate((0, 0, -size))
        mesh = (body.refine_to_length(size / 2) + finger).to_mesh()
        shape = Enclosure(np.array(mesh.vert_properties[:, :3], dtype=float), np.array(mesh.tri_verts, dtype=np.int64))
        most.append(Caps(shape).grown(nearest(shape, (0, 0, length)), none(shape))[0][:, 0].max())
    assert most[0] == pytest.approx(length / radius, rel=0.15)
    np.testing.assert_allclose(np.array(most) / most[0], (1, 1, 0.5, 0.5), rtol=0.02)


def test_beside_the_top_of_a_blunt_limb_its_top_is_found():
    """`NEARLY`: the caps around a neighbour of the top are less slender by a fifth."""
    shape = solid(block() + manifold3d.Manifold.sphere(0.45, 48).translate((0, 0, 0.2)), 0.1)
    found, top = Caps(shape), nearest(shape, (0, 0, 0.65))
    beside = int(np.setdiff1d(shape.faces[(shape.faces == top).any(axis=1)], [top])[0])
    own = [found.grown(tip, none(shape))[0][:, 0].max() for tip in (beside, top)]
    assert own[0] < 0.95 * own[1]
    asked = none(shape), own[0] / 0.8, 0.5
    tip, rows, _ = found._slenderest(beside, *asked)
    assert tip != beside and rows[:, 0].max() > own[0]
    assert found._slenderest(beside, none(shape), own[0] / 0.5, 0.5)[0] == beside  # not nearly a limb


def test_noise_makes_few_tips():
    """`SMOOTHINGS`: the vertices of a ball are moved by a third of an edge."""
    ball = trimesh.creation.icosphere(4)
    noise = np.random.default_rng(5).normal(0, 0.02, ball.vertices.shape)
    num = [len(Caps(Enclosure(ball.vertices + part * noise, ball.faces)).tips()) for part in (0, 1)]
    assert num[1] < 45 and num[0] < 30


def test_a_vertex_leads_to_the_tip_of_its_finger():
    shape = solid(fingers(), 0.15)
    found = Caps(shape)
    for x in (-1.2, -0.4, 0.4, 1.2):
        tip = found.tip_of[nearest(shape, (x + 0.25, 0, 0.5))]
        assert abs(shape.vertices[tip, 0] - x) < 0.26 and shape.vertices[tip, 2] > 0.99
    assert set(found.tips()) == set(found.tip_of)


def test_components_do_not_see_each_other():
    """Two solids in one surface have the tips and limbs that each of them has."""
    one, other = solid(fingers(), 0.15), solid(block() + LIMB["long cylinder"][0], 0.15)
    x = np.concatenate([one.vertices, other.vertices + [9.0, 0, 0]])
    both = Enclosure(x, np.concatenate([one.faces, other.faces + len(one.vertices)]))
    tips = [set(Caps(shape).tips().tolist()) for shape in (one, other, both)]
    assert tips[2] == tips[0] | {tip + len(one.vertices) for tip in tips[1]}
    found = [sorted(round(cap.slenderness, 6) for cap in limbs(shape, 1.2)) for shape in (one, other, both)]
    assert found[2] == sorted(found[0] + found[1])


@pytest.mark.parametrize("name", ["fingers", "ears"])
def test_pruning_again_removes_nothing_and_further_the_fingers(name):
    """A run, and `Skeleton.prune` with the same threshold, choose the same limbs."""
    body = fingers() if name == "fingers" else manifold3d.Manifold.sphere(1.0, 48)
    if name == "ears":
        for x in (-0.35, 0.35):
            body += LIMB["long cylinder"][0].translate((x, 0, 0.7))
    shape = solid(body, 0.15)
    skeleton = msf_jax.skeletonize((shape.vertices, shape.faces))
    assert skeleton.num_leaves == (4 if name == "fingers" else 3)
    assert skeleton.prune().num_leaves == skeleton.num_leaves
    finite = [branch.slenderness for branch in skeleton.branches if np.isfinite(branch.slenderness)]
    assert len(finite) == skeleton.num_leaves and min(finite) >= 1.0
    assert skeleton.prune(100.0).num_leaves == 2


def test_a_solid_with_neither_limbs_nor_handles_keeps_its_blunt_ends():
    """`BLUNT`: six bumps on a ball, each less slender than 1; with a hole through it, the ball has a loop instead."""
    bumps = [
        manifold3d.Manifold.sphere(0.45, 32).translate(tuple(0.8 * direction))
        for direction in np.concatenate([np.eye(3), -np.eye(3)])
    ]
    ball = manifold3d.Manifold.batch_boolean([manifold3d.Manifold.sphere(0.8, 48), *bumps], manifold3d.OpType.Add)
    drill = manifold3d.Manifold.cylinder(4, 0.2, 0.2, 24, True).rotate((35, 35, 0))
    whole = solid(ball, 0.12)
    for shape, leaves in ((whole, 6), (solid(ball - drill, 0.12), 0)):
        assert not limbs(shape, 1.0) and len(limbs(shape, caps.BLUNT)) == 6
        skeleton = msf_jax.skeletonize((shape.vertices, shape.faces))
        assert skeleton.num_leaves == leaves and skeleton.report.loops == (leaves == 0)
        assert skeleton.prune().num_leaves == leaves
    ring = trimesh.creation.torus(3.0, 0.5)  # a part with a handle beside the ball changes nothing in the ball
    both = trimesh.util.concatenate([trimesh.Trimesh(whole.vertices, whole.faces, process=False), ring])
    skeleton = msf_jax.skeletonize(both)
    assert skeleton.num_leaves == skeleton.prune().num_leaves == 6 and skeleton.report.loops == 1


def test_the_blunt_nose_of_a_head_with_ears_is_a_limb():
    """`Caps.limbs`: it sticks out by less than its radius, and the head that ends there is slender with its ears."""
    head = manifold3d.Manifold.cylinder(1.6, 0.5, 0.5, 48) + manifold3d.Manifold.sphere(0.5, 48).translate((0, 0, 1.6))
    ear = manifold3d.Manifold.cylinder(0.9, 0.12, 0.12, 24)
    ears = [ear.rotate((0, angle, 0)).translate((0, 0, 1.2)) for angle in (90, -90)]
    shape = solid(manifold3d.Manifold.batch_boolean([block(), head, *ears], manifold3d.OpType.Add), 0.1)
    top = nearest(shape, (0, 0, 2.1))
    found = Caps(shape)
    others = none(shape)
    others[[nearest(shape, (x, 0, 1.2)) for x in (-0.9, 0.9)]] = 1
    assert caps.BLUNT < found.grown(top, others)[0][:, 0].max() < 2.0
    for least in (1.2, 1.6, 3.0):
        assert [cap for cap in limbs(shape, least) if shape.vertices[cap.tip, 2] > 1.9], least


@pytest.mark.parametrize("name", ["tee", "plus"])
def test_few_triangles_do_not_hide_limbs(name):
    """`FEWEST`: solids of bars with 16 to 32 vertices."""
    bars = [(6, 1, 1), (1, 6, 1)] if name == "plus" else [(6, 1, 1)]
    body = manifold3d.Manifold.batch_boolean(
        [manifold3d.Manifold.cube(bar, True) for bar in bars], manifold3d.OpType.Add
    )
    if name == "tee":
        body += manifold3d.Manifold.cube((1, 3, 1), True).translate((0, 1.5, 0))
    mesh = body.to_mesh()
    x, faces = np.array(mesh.vert_properties[:, :3], dtype=float), np.array(mesh.tri_verts, dtype=np.int64)
    assert len(x) < 40 and len(limbs(Enclosure(x, faces), 1.0)) == (4 if name == "plus" else 3)
    assert msf_jax.skeletonize((x, faces)).num_leaves == (4 if name == "plus" else 3)


def test_a_lower_threshold_never_prunes_more():
    """Below half a ball, all thresholds are that of half a ball."""
    shape = solid(fingers(), 0.15)
    skeleton = msf_jax.skeletonize((shape.vertices, shape.faces))
    leaves = [skeleton.prune(least).num_leaves for least in (0, 1e-9, 0.1, 0.4, 1.0, 3.0, 100.0)]
    assert leaves == [4, 4, 4, 4, 4, 4, 2]


def test_many_components_have_a_budget_each():
    """`MOST_TIPS`, `MOST_AREA` are those of a component."""
    one = solid(block() + LIMB["long cylinder"][0], 0.4)
    num, size = 150, len(one.vertices)
    x = np.concatenate([one.vertices + [5.0 * k, 0, 0] for k in range(num)])
    many = Caps(Enclosure(x, np.concatenate([one.faces + k * size for k in range(num)])))
    found = many.limbs(2.0, many.tips())[0]
    assert sorted(cap.tip // size for cap in found) == list(range(num)) and not many.was_hit


def test_a_skeleton_is_pruned_by_several_threads_and_pickled():
    shape = solid(fingers(), 0.15)
    skeleton = msf_jax.skeletonize((shape.vertices, shape.faces))
    with ThreadPoolExecutor(4) as threads:
        found = [*threads.map(lambda least: skeleton.prune(least).num_leaves, (1.0, 3.0, 100.0) * 4)]
    assert found == [4, 4, 2] * 4
    bare = replace(skeleton, source=None)
    for each in (skeleton, bare):
        again = pickle.loads(pickle.dumps((each.branches, each)[1]))
        assert [one.slenderness for one in again.branches] == [one.slenderness for one in each.branches]


def test_beyond_its_budget_no_tip_is_tried_and_that_is_said(monkeypatch):
    shape = solid(block() + LIMB["long cylinder"][0], 0.15)
    top = np.array([nearest(shape, (0, 0, 1.5))])
    monkeypatch.setattr(caps, "MOST_AREA", -1.0)
    none = Caps(shape)
    assert none.limbs(1.2, top)[0] == [] and none.was_hit and none.limbs(1.2, top)[1].tolist() == [np.inf]
    monkeypatch.setattr(caps, "MOST_TIPS", 2)
    few = Caps(shape)
    assert len(few.tips()) == 2 and few.was_hit
