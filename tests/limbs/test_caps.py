"""Caps of a surface: closed forms on solids whose limbs are known, and one branch for each limb."""

import pickle
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import manifold3d
import numpy as np
import pytest
import trimesh
from limb_cases import LIMB, RADIUS, block, fingers, solid
from scipy.spatial.transform import Rotation

import msf_jax
from msf_jax.limbs import caps
from msf_jax.limbs.caps import RATIO, Cap, Caps
from msf_jax.solid.enclosure import Enclosure


@pytest.fixture(scope="module")
def with_fingers() -> msf_jax.Skeleton:
    """The skeleton of the block with four fingers."""
    shape = solid(fingers(), 0.4)
    return msf_jax.skeletonize((shape.vertices, shape.faces))


def limbs(shape: Enclosure, least: float) -> list[Cap]:
    return Caps(shape).limbs(least).caps


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
    np.testing.assert_allclose(flat[:, 3:6], np.broadcast_to(shape.vertices[tip], (len(flat), 3)), atol=0.05)
    assert tip in region and rows[-1, 2] < shape.mesh.triangles.size


@pytest.mark.parametrize(
    "change", ["permuted", *(pytest.param(name, marks=pytest.mark.slow) for name in ("moved", "split"))]
)
def test_limbs_belong_to_the_surface(change):
    shape = solid(fingers(), 0.15)
    x, faces = shape.vertices, shape.faces
    rng = np.random.default_rng(1)
    if change == "moved":
        other = Enclosure(1e3 * Rotation.random(random_state=3).apply(x), faces)
    elif change == "split":
        other = Enclosure(*trimesh.remesh.subdivide(x, faces))
    else:
        order = rng.permutation(len(x))
        other = Enclosure(x[order], np.argsort(order)[faces][rng.permutation(len(faces))])
    found = [limbs(each, 1.2) for each in (shape, other)]
    assert [len(each) for each in found] == [4, 4]
    value = [sorted(cap.slenderness for cap in each) for each in found]
    np.testing.assert_allclose(*value, rtol=1e-6 if change == "moved" else 0.15)
    for cap in found[0]:
        assert abs(cap.slenderness - 4) < 0.6 and shape.vertices[cap.tip, 2] > 0.9


def test_a_ring_a_ball_and_the_middle_of_a_tube_are_no_limbs():
    """A cap is cut off by one curve, and is less than half of the surface."""
    ring = trimesh.creation.torus(1.0, 0.25, 48, 18)
    assert not limbs(Enclosure(ring.vertices, ring.faces), 0.9)
    ball = trimesh.creation.icosphere(3)
    assert not limbs(Enclosure(ball.vertices, ball.faces), 0.9)
    tube = solid(manifold3d.Manifold.cylinder(6.0, 0.3, 0.3, 32), 0.1)
    assert sorted(round(tube.vertices[cap.tip, 2]) for cap in limbs(tube, 1.2)) == [0, 6]


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


def test_a_body_with_a_handle_has_two_ends():
    """A mug: its ends are blunter than limbs."""
    handle = manifold3d.Manifold.revolve(manifold3d.CrossSection.circle(0.4, 24).translate((1.8, 0)), 64)
    shape = solid(
        manifold3d.Manifold.cylinder(6, 1.5, 1.5, 32, True) + handle.rotate((90, 0, 0)).translate((1.3, 0, 0))
    )
    found = limbs(shape, 1.0)
    assert sorted(np.sign(shape.vertices[cap.tip, 2]) for cap in found) == [-1, 1]
    assert max(cap.slenderness for cap in found) < 1.0


def test_two_stubs_of_a_ring_are_no_ends():
    """`BODY`: they are as slender as the ends of a mug, and hold little of the surface; so are corners of a truss."""
    ring = manifold3d.Manifold.revolve(manifold3d.CrossSection.circle(0.5, 24).translate((3, 0)), 64)
    stubs = manifold3d.Manifold.cylinder(7.8, 0.45, 0.45, 24, True).rotate((0, 90, 0))
    stubs -= manifold3d.Manifold.cylinder(4, 3, 3, 64, True)
    found = Caps(solid(ring + stubs, 0.1))
    most = [found.grown(tip, none(found.shape))[0][:, 0].max(initial=0.0) for tip in found.tips()]
    assert (np.array(most) > caps.BLUNT).sum() >= 2 and max(most) < 1.0 and not found.limbs(1.0).caps


def test_a_small_limb_counts_half():
    """`SMALL_CAP`, `SMALLER`: of a finger on blocks of any size, and a finger of that share is a limb or none."""
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
    shape = solid(fingers())
    found = Caps(shape)
    for x in (-1.2, -0.4, 0.4, 1.2):
        tip = found.tip_of[nearest(shape, (x + 0.25, 0, 0.5))]
        assert abs(shape.vertices[tip, 0] - x) < 0.26 and shape.vertices[tip, 2] > 0.99
    assert set(found.tips()) == set(found.tip_of)


def test_components_do_not_see_each_other():
    """Two solids in one surface have the tips and limbs that each of them has."""
    one, other = solid(fingers(), 0.4), solid(block() + LIMB["long cylinder"][0])
    x = np.concatenate([one.vertices, other.vertices + [9.0, 0, 0]])
    both = Enclosure(x, np.concatenate([one.faces, other.faces + len(one.vertices)]))
    tips = [set(Caps(shape).tips().tolist()) for shape in (one, other, both)]
    assert tips[2] == tips[0] | {tip + len(one.vertices) for tip in tips[1]}
    found = [sorted(round(cap.slenderness, 6) for cap in limbs(shape, 1.2)) for shape in (one, other, both)]
    assert found[2] == sorted(found[0] + found[1])


@pytest.mark.parametrize("name", ["fingers", pytest.param("ears", marks=pytest.mark.slow)])
def test_pruning_again_removes_nothing_and_further_the_fingers(name, with_fingers):
    """A run, and `Skeleton.prune` with the same threshold, choose the same limbs."""
    skeleton = with_fingers
    if name == "ears":
        body = manifold3d.Manifold.sphere(1.0, 48)
        for x in (-0.35, 0.35):
            body += LIMB["long cylinder"][0].translate((x, 0, 0.7))
        shape = solid(body, 0.15)
        skeleton = msf_jax.skeletonize((shape.vertices, shape.faces))
    assert skeleton.num_leaves == (4 if name == "fingers" else 3)
    assert skeleton.prune().num_leaves == skeleton.num_leaves
    finite = [branch.slenderness for branch in skeleton.branches if np.isfinite(branch.slenderness)]
    assert len(finite) == skeleton.num_leaves and min(finite) >= 1.0
    assert skeleton.prune(100.0).num_leaves == 2


def bumpy_ball(has_hole: bool) -> Enclosure:
    """A ball with six bumps, and a hole through it."""
    bumps = [
        manifold3d.Manifold.sphere(0.45, 32).translate(tuple(0.8 * direction))
        for direction in np.concatenate([np.eye(3), -np.eye(3)])
    ]
    ball = manifold3d.Manifold.batch_boolean([manifold3d.Manifold.sphere(0.8, 48), *bumps], manifold3d.OpType.Add)
    if has_hole:
        ball -= manifold3d.Manifold.cylinder(4, 0.2, 0.2, 24, True).rotate((35, 35, 0))
    return solid(ball, 0.22)


@pytest.mark.slow  # limbs that are slender have the tests above
@pytest.mark.parametrize(("has_hole", "leaves"), [(False, 6), (True, 0)])
def test_a_solid_with_neither_limbs_nor_handles_keeps_its_blunt_ends(has_hole, leaves):
    """`BLUNT`: six bumps on a ball, each less slender than 1; with a hole through it, the ball has a loop instead."""
    shape = bumpy_ball(has_hole)
    assert len(limbs(shape, 1.0)) == leaves and len(limbs(shape, caps.BLUNT)) == 6
    skeleton = msf_jax.skeletonize((shape.vertices, shape.faces))
    assert skeleton.num_leaves == leaves and skeleton.report.loops == (leaves == 0)
    assert skeleton.prune().num_leaves == leaves


@pytest.mark.slow
def test_a_part_with_a_handle_beside_it_changes_no_blunt_end():
    shape, ring = bumpy_ball(False), trimesh.creation.torus(3.0, 0.5)
    both = trimesh.util.concatenate([trimesh.Trimesh(shape.vertices, shape.faces, process=False), ring])
    skeleton = msf_jax.skeletonize(both)
    assert skeleton.num_leaves == skeleton.prune().num_leaves == 6 and skeleton.report.loops == 1


@pytest.mark.slow  # a part below a slenderness of 1 is rare
def test_the_blunt_nose_of_a_head_with_ears_is_a_limb():
    """`Caps.limbs`: it sticks out by less than its radius, and the head that ends there is slender with its ears."""
    head = manifold3d.Manifold.cylinder(1.6, 0.5, 0.5, 48) + manifold3d.Manifold.sphere(0.5, 48).translate((0, 0, 1.6))
    ear = manifold3d.Manifold.cylinder(0.9, 0.12, 0.12, 24)
    ears = [ear.rotate((0, angle, 0)).translate((0, 0, 1.2)) for angle in (90, -90)]
    shape = solid(manifold3d.Manifold.batch_boolean([block(), head, *ears], manifold3d.OpType.Add), 0.15)
    top = nearest(shape, (0, 0, 2.1))
    found = Caps(shape)
    others = none(shape)
    others[[nearest(shape, (x, 0, 1.2)) for x in (-0.9, 0.9)]] = 1
    assert caps.BLUNT < found.grown(top, others)[0][:, 0].max() < 2.0
    for least in (1.2, 1.6):
        assert [cap for cap in limbs(shape, least) if shape.vertices[cap.tip, 2] > 1.9], least


@pytest.mark.parametrize(("length", "width", "is_turned"), [(3.6, 1.4, True), (4.8, 2.0, False)])
def test_both_ends_of_the_head_of_a_hammer_are_limbs(length, width, is_turned):
    """`meeting`: discs around them pass the middle before they are slender enough. Each limb has its half."""
    rod = manifold3d.Manifold.cylinder(8.0, 0.5, 0.5, 32).translate((0, 0, -8))
    shape = solid(rod + manifold3d.Manifold.cube((length, width, width), True), 0.3)
    x = shape.vertices
    turn = Rotation.random(random_state=5) if is_turned else Rotation.identity()
    found = limbs(Enclosure(turn.apply(x), shape.faces), 1.0)
    tips = x[[cap.tip for cap in found]]
    np.testing.assert_allclose(np.sort(tips[:, 0]), [-length / 2, tips[tips[:, 2].argmin(), 0], length / 2], atol=0.05)
    assert abs(tips[:, 2].min() + 8) < 0.05
    one, other = (cap for cap in found if x[cap.tip, 2] > -7)
    assert not np.isin(one.region, other.region).any()
    for cap in (one, other):
        assert (x[cap.region, 0] * np.sign(x[cap.tip, 0])).min() > -0.5


@pytest.mark.parametrize("edge", [0.25, 0.6])
def test_the_back_of_a_chair_ends_in_its_middle(edge):
    """`ends.times_across`: the disc that finds it is around an upper corner, and the base is oblique."""
    seat = manifold3d.Manifold.cube((4, 4, 0.6), True).translate((0, 0, 0.3))
    back = manifold3d.Manifold.cube((0.6, 4, 4.6), True).translate((-1.7, 0, 2.3))
    legs = [
        manifold3d.Manifold.cube((0.6, 0.6, 4), True).translate((u, v, -2)) for u in (-1.7, 1.7) for v in (-1.7, 1.7)
    ]
    shape = solid(manifold3d.Manifold.batch_boolean([seat, back, *legs], manifold3d.OpType.Add), edge)
    caps = Caps(shape)
    found = caps.limbs(1.0)
    (number,) = (n for n, cap in enumerate(found.caps) if caps.shape.vertices[cap.tip, 2] > 4)
    assert len(found.caps) == 5 and abs(caps.shape.vertices[found.caps[number].tip, 1]) > 1.5
    places = caps.axis(shape, found, number).places
    np.testing.assert_allclose(places[0, :2], (-1.7, 0), atol=0.1)
    assert 4.3 < places[0, 2] < 4.6 and np.abs(places[:, 1]).max() < 0.1


def test_a_limb_is_not_changed_by_what_stands_on_it():
    """A heel was the leg's base, too, so that the leg's end was in the calf, and its toe was lost."""
    post = manifold3d.Manifold.cylinder(8, 1, 1, 32)
    stud = manifold3d.Manifold.cylinder(2, 0.3, 0.3, 16).rotate((0, 90, 0)).translate((0, 0, 7))
    shape = solid(block() + post + stud, 0.2)
    caps, (x, y, z) = Caps(shape), shape.vertices.T
    region = np.flatnonzero((z > 0.5) & (np.hypot(x, y) < 3))
    limb = Cap(nearest(shape, (0, 0, 8)), 4.0, 50.0, region)
    small = Cap(nearest(shape, (2, 0, 7)), 3.0, 2.0, np.flatnonzero(x > 1.01))
    small = small._replace(region=np.intersect1d(small.region, region))
    owner = none(shape)
    alone, both = caps._owned([limb], owner), caps._owned([limb, small], owner)
    np.testing.assert_array_equal(both[0], alone[0])
    assert (owner[small.region] == 2).all() and (both[1][small.region] < alone[0][small.region]).all()


@pytest.mark.parametrize("name", ["tee", pytest.param("plus", marks=pytest.mark.slow)])
def test_few_triangles_do_not_hide_limbs(name):
    """`SPLIT_BELOW`: solids of bars with 16 to 32 vertices."""
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


@pytest.mark.slow  # so it is for curves of any kind, in test_pruning
def test_a_lower_threshold_never_prunes_more(with_fingers):
    """Below half a ball, all thresholds are that of half a ball."""
    leaves = [with_fingers.prune(least).num_leaves for least in (0, 0.4, 3.0, 100.0)]
    assert leaves == [4, 4, 4, 2]


@pytest.mark.slow  # of a budget that is spent, a quick test is below
def test_many_components_have_a_budget_each(monkeypatch):
    """`MOST_TIPS`, `MOST_AREA` are those of a component: here a third of each, so that few components are many."""
    monkeypatch.setattr(caps, "MOST_TIPS", caps.MOST_TIPS // 3)
    monkeypatch.setattr(caps, "MOST_AREA", caps.MOST_AREA / 3)
    one = solid(block() + LIMB["long cylinder"][0], 0.4)
    num, size = 10, len(one.vertices)
    assert num * len(Caps(one).tips()) > 1.5 * caps.MOST_TIPS
    x = np.concatenate([one.vertices + [5.0 * k, 0, 0] for k in range(num)])
    many = Caps(Enclosure(x, np.concatenate([one.faces + k * size for k in range(num)])))
    found = many.limbs(2.0).caps
    assert sorted(cap.tip // size for cap in found) == list(range(num)) and not many.was_hit


def test_a_skeleton_is_pruned_by_several_threads_and_pickled(with_fingers):
    skeleton = replace(with_fingers)  # none of its properties is computed yet
    with ThreadPoolExecutor(4) as threads:
        found = [*threads.map(lambda least: skeleton.prune(least).num_leaves, (1.0, 100.0) * 2)]
    assert found == [4, 2] * 2
    bare = replace(skeleton, source=None)
    for each in (skeleton, bare):
        again = pickle.loads(pickle.dumps((each.branches, each)[1]))
        assert [one.slenderness for one in again.branches] == [one.slenderness for one in each.branches]


def test_beyond_its_budget_no_tip_is_tried_and_that_is_said(monkeypatch):
    shape = solid(block() + LIMB["long cylinder"][0], 0.15)
    monkeypatch.setattr(caps, "MOST_AREA", -1.0)
    none = Caps(shape)
    found = none.limbs(1.2)
    assert len(found.caps) == 2  # the halves of the solid, which need no tip
    assert none.was_hit and (found.slenderness[none.tips()] == np.inf).all()
    monkeypatch.setattr(caps, "MOST_TIPS", 2)
    few = Caps(shape)
    assert len(few.tips()) == 2 and few.was_hit
