"""The merge tree against a plain search, closed forms of slenderness, and which limbs solids have."""

from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from itertools import pairwise

import manifold3d
import networkx as nx
import numpy as np
import pytest
import trimesh
from conftest import blob
from limb_cases import LIMB, RADIUS, Solid, block, box, fingers, i_beam, round_bar, solid
from scipy.spatial.transform import Rotation

import msf_jax
from msf_jax.limbs import tree
from msf_jax.limbs.tree import LimbTree
from msf_jax.solid.enclosure import Enclosure


def limbs(shape: Enclosure, least: float = 0.5, detail: float = 0.5) -> list[tree.Limb]:
    return LimbTree(shape).limbs(least, detail).limbs


def joined(*parts: Solid) -> Solid:
    return Solid.batch_boolean(parts, manifold3d.OpType.Add)


def above(x: np.ndarray, faces: np.ndarray, height: np.ndarray, level: float) -> list[tuple[float, float, int]]:
    """Area, length of the boundary, and number of its curves, of each part of a surface above a level."""
    graph, area, length, sides = nx.Graph(), {}, {}, nx.Graph()
    for face in faces[(height[faces] > level).any(axis=1)].tolist():
        polygon, cut = [], []
        for a, b in pairwise([*face, face[0]]):
            if height[a] > level:
                polygon.append(x[a])
            if (height[a] > level) != (height[b] > level):
                cut.append(x[a] + (level - height[a]) / (height[b] - height[a]) * (x[b] - x[a]))
                polygon.append(cut[-1])
                sides.add_edge(tuple(face), frozenset((a, b)))
        inner = [corner for corner in face if height[corner] > level]
        nx.add_path(graph, inner)
        fan = [np.cross(p - polygon[0], q - polygon[0]) for p, q in pairwise(polygon[1:])]
        area[inner[0]] = area.get(inner[0], 0.0) + sum(np.linalg.norm(each) for each in fan) / 2
        if cut:
            length[inner[0]] = length.get(inner[0], 0.0) + float(np.linalg.norm(cut[1] - cut[0]))
    of_curve = [next(node for node in curve if isinstance(node, tuple)) for curve in nx.connected_components(sides)]
    found = []
    for part in nx.connected_components(graph):
        rings = sum(any(corner in part for corner in face) for face in of_curve)
        found.append((sum(area.get(k, 0.0) for k in part), sum(length.get(k, 0.0) for k in part), rings))
    return sorted(found)


def test_each_level_has_the_parts_of_a_plain_search():
    """Areas, rings and tops, of a function with many maxima on a ball."""
    mesh = blob(91)
    x, faces = np.array(mesh.vertices), np.array(mesh.faces)
    height = np.random.default_rng(3).normal(size=(4, 3)) @ x.T
    height = np.sin(3 * height).sum(axis=0)
    arcs = tree.merge_tree(Enclosure(x, faces), height, 1.0)
    for level in np.unique(arcs.height)[::40]:
        expected, own = above(x, faces, height, level), np.flatnonzero(arcs.height == level)
        assert len(own) == len(expected)
        single = [2 * np.pi * area / length**2 - 0.5 for area, length, num in expected if num == 1]
        for slenderness in arcs.slenderness[own][arcs.slenderness[own] > -np.inf]:
            assert np.abs(np.array(single) / slenderness - 1).min() < 1e-6
    for arc, parent in enumerate(arcs.parent):
        assert arc < parent or parent < 0
        assert height[arcs.top[parent]] >= height[arcs.top[arc]] or parent < 0
    assert (height[arcs.top[arcs.of_vertex]] >= height).all()


@pytest.mark.parametrize("name", LIMB)
def test_slenderness_has_closed_forms(name):
    """Of a limb on a block, at its base."""
    limb, expected = LIMB[name]
    shape = solid(block() + limb, 0.07)
    found = LimbTree(shape)
    tip = int(shape.vertices[:, 2].argmax())
    low = [
        int(((found.shape.vertices - place) ** 2).sum(axis=1).argmin()) for place in ([1.9, 1.9, -2], [-1.9, 1.9, -2])
    ]
    # The rings of the average distance are a little oblique.
    assert found.slenderness(np.array([tip, *low]))[0] == pytest.approx(expected, rel=0.15, abs=0.25)


@pytest.mark.parametrize("change", ["permuted", "mirrored", "moved", pytest.param("split", marks=pytest.mark.slow)])
def test_limbs_belong_to_the_surface(change):
    shape = solid(fingers(), 0.15)
    x, faces = shape.vertices, shape.faces
    rng = np.random.default_rng(1)
    if change == "moved":
        other = Enclosure(1e3 * Rotation.random(random_state=3).apply(x), faces)
    elif change == "mirrored":
        other = Enclosure(-x, faces[:, ::-1])
    elif change == "split":
        other = Enclosure(*trimesh.remesh.subdivide(x, faces))
    else:
        order = rng.permutation(len(x))
        other = Enclosure(x[order], np.argsort(order)[faces][rng.permutation(len(faces))])
    found = [sorted(limbs(each), key=lambda limb: len(limb.region)) for each in (shape, other)]
    found = [
        [limb for limb in each if limb.slenderness > 1 and len(limb.region) < len(each[-1].region) / 2]
        for each in found
    ]
    assert [len(each) for each in found] == [4, 4]
    np.testing.assert_allclose(*(sorted(limb.slenderness for limb in each) for each in found), rtol=0.1)
    assert all(abs(limb.slenderness - 4) < 0.6 and limb.place[2] > 0.9 for limb in found[0])


EARS = [LIMB["long cylinder"][0].translate((x, 0, 0.7)) for x in (-0.35, 0.35)]
FLUKE = Solid.sphere(1.0, 32).scale((0.9, 0.45, 0.1))
FLUKES = [FLUKE.rotate((0, 20 * side, 0)).translate((0.8 * side, 0, -0.2)) for side in (-1, 1)]
SOLIDS = {
    "ring": (Solid.revolve(manifold3d.CrossSection.circle(0.25, 18).translate((1.0, 0)), 48), 0),
    "ball": (Solid.sphere(1.0, 48), 2),
    "tube": (round_bar(6.0, 0.3, 0.3), 2),
    "slab": (box(10, 6, 1), 2),
    "I-beam": (i_beam(12), 2),
    "bar with a blind hole": (box(10, 3, 3) - Solid.cylinder(2.2, 0.6, 0.6, 24).translate((0.7, 0.1, 0)), 2),
    "hammer": (joined(round_bar(4.0, 0.7, 0.7), Solid.cylinder(9.0, 0.6, 0.6, 32)), 3),
    "ball with two ears": (joined(Solid.sphere(1.0, 48), *EARS), 3),
    "two flukes": (joined(Solid.cylinder(6.0, 0.2, 1.0, 32), *FLUKES), 3),
}


@pytest.mark.parametrize(("made", "ends"), SOLIDS.values(), ids=SOLIDS)
def test_solids_have_the_limbs_that_people_see(made, ends):
    """Whatever their triangles; blind holes, corners of sheets and handles are none."""
    for edge in (None, 0.3):
        shape = solid(made, edge) if edge else Enclosure(*_as_made(made))
        assert len(limbs(shape)) == ends, edge


def _as_made(made: Solid) -> tuple[np.ndarray, np.ndarray]:
    mesh = made.to_mesh()
    return np.array(mesh.vert_properties[:, :3], dtype=float), np.array(mesh.tri_verts, dtype=np.int64)


def test_a_finer_detail_has_the_limbs_of_a_coarser_one_and_names_the_others():
    bumps = [Solid.sphere(r, 32).translate((x, 0, 0)) for x, r in ((-1.4, 0.2), (-0.6, 0.3), (0.4, 0.4))]
    found = LimbTree(solid(joined(fingers(), *(bump.translate((0, 1.4, 0)) for bump in bumps)), 0.1))
    regions = [[set(limb.region.tolist()) for limb in found.limbs(0.5, detail).limbs] for detail in (0.1, 0.5, 0.8)]
    assert len(regions[0]) <= len(regions[1]) <= len(regions[2]) and len(regions[2]) > len(regions[0])
    for coarse, fine in pairwise(regions):
        assert all(any(other <= each for other in fine) for each in coarse)
    finer = found.limbs(0.5, 0.1).finer
    assert finer and all(limb.detail > 0.1 for limb in finer)


def test_components_do_not_see_each_other():
    """Two solids in one surface have the limbs that each of them has."""
    one, other = solid(fingers(), 0.2), solid(block() + LIMB["long cylinder"][0], 0.2)
    x = np.concatenate([one.vertices, other.vertices + [9.0, 0, 0]])
    both = Enclosure(x, np.concatenate([one.faces, other.faces + len(one.vertices)]))
    found = [
        sorted((len(limb.region), round(limb.slenderness, 6)) for limb in limbs(shape)) for shape in (one, other, both)
    ]
    assert found[2] == sorted(found[0] + found[1])


@pytest.fixture(scope="module")
def with_fingers() -> msf_jax.Skeleton:
    """The skeleton of the block with four fingers."""
    shape = solid(fingers(), 0.4)
    return msf_jax.skeletonize((shape.vertices, shape.faces))


def test_pruning_again_removes_nothing_and_further_the_fingers(with_fingers):
    """A run, and `Skeleton.prune` with the same threshold, choose the same limbs; at most two ends are left."""
    assert with_fingers.num_leaves == 5  # and the block's end
    assert [with_fingers.prune(least).num_leaves for least in (0, 0.5, 100.0)] == [5, 5, 2]
    finite = sorted(branch.slenderness for branch in with_fingers.branches if np.isfinite(branch.slenderness))
    assert finite[-4:] == pytest.approx([4.0] * 4, rel=0.2)
    skeleton = replace(with_fingers)  # none of its properties is computed yet
    with ThreadPoolExecutor(4) as threads:
        assert [*threads.map(lambda least: skeleton.prune(least).num_leaves, (0.5, 100.0) * 2)] == [5, 2] * 2


def test_a_pit_is_no_limb():
    """On a block with four fingers, a cone that sticks out is one; one that goes in has no volume, closed by a fan."""
    cone = Solid.cylinder(1.0, 0.4, 0.0, 32).translate((0, 1.3, 0))
    for made, has_limb in ((fingers() + cone, True), (fingers() - cone.rotate((180, 0, 0)), False)):
        places = [limb.place for limb in limbs(solid(made, 0.1))]
        tip = [0, 1.3, 1] if has_limb else [0, -1.3, -1]
        assert any(np.linalg.norm(place - tip) < RADIUS for place in places) == has_limb
        assert sum(place[2] > 0.9 for place in places) == 4 + has_limb


def test_each_prong_of_a_sawn_bar_has_its_own_middle():
    """Half a bar has two ends there: which of them is nearer to its far part is a matter of rounding."""
    length, width, depth, gap = 30.0, 2.0, 1.2, 0.06
    slit = box(2 * depth, gap, 2 * width)
    shape = solid(
        box(length, width, width) - slit.translate((length / 2, 0, 0)) - slit.translate((-length / 2, 0, 0)), 9.0
    )
    scale = length / np.ptp(shape.vertices[:, 0])
    trees = LimbTree(shape)
    found = trees.limbs(0.5, 0.5)
    ends = np.array([trees.axis(shape, found, k).places[0] for k in range(len(found.limbs))]) * scale
    right = np.array([[x, y, 0.0] for x in (-1, 1) for y in (-1, 1)]) * [length / 2, (width + gap) / 4, 0.0]
    away = np.linalg.norm(ends[:, None] - ends.mean(axis=0) - right, axis=2)
    assert sorted(away.argmin(axis=1)) == [0, 1, 2, 3]
    assert away.min(axis=1).max() < 0.3 * width


def test_solids_that_touch_at_a_vertex_have_trees_of_their_own():
    one = trimesh.creation.box((1.0, 1.0, 4.0))
    vertices, faces = np.concatenate([one.vertices, -one.vertices]), np.concatenate([one.faces, one.faces[:, ::-1] + 8])
    vertices[8:] += 2 * one.vertices[7]
    faces[faces == 15] = 7  # the vertex that is the same
    tree = LimbTree(Enclosure(vertices, faces))
    assert len(tree.parts) == 2 and all(part.is_ball for part in tree.parts)
    assert all(np.isfinite(arcs.value).all() for arcs in tree.trees)
