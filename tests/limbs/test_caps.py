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
