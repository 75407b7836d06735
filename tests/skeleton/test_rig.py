"""Rigs: few bones, none empty, smooth weights of few influences; what a .glb file holds, read without this library."""

import json
import struct
from itertools import pairwise

import jax
import jax.numpy as jnp
import numpy as np
import pytest
import trimesh
from PIL import Image
from scipy import spatial

from msf_jax import ConfigError, MeshError
from msf_jax.meshes import reading
from msf_jax.skeleton.rigging.bones import Bones, bones_of
from msf_jax.skeleton.rigging.rig import heat_weights, reduce_along_tree, subtract_rest
from msf_jax.skeleton.skeleton import Skeleton, curve_of
from tests.benchmarks import ground_truth

SHAPES = ["y", "comb", "octopus_low", "sheet_and_limb", "s_curve", "pawn_low"]


def known(name: str) -> tuple[Skeleton, trimesh.Trimesh]:
    """The true curve of a shape, refined to half a radius, each vertex of its mesh with the nearest node; no run."""
    shape = ground_truth.make(name)
    nodes, edges, radii = [*shape.points], [], [*shape.radii]
    for a, b in shape.edges:
        num = max(1, int(np.linalg.norm(shape.points[b] - shape.points[a]) / 0.06))
        chain = [a, *range(len(nodes), len(nodes) + num - 1), b]
        for t in np.arange(1, num) / num:
            nodes.append((1 - t) * shape.points[a] + t * shape.points[b])
            radii.append((1 - t) * shape.radii[a] + t * shape.radii[b])
        edges += list(pairwise(chain))
    curve = curve_of(np.array(nodes), np.sort(np.array(edges), axis=1), np.array(radii))
    nearest = spatial.KDTree(curve.vertices).query(shape.mesh.vertices)[1]
    return Skeleton(curve.vertices, curve.edges, curve.radii, nearest, curve.report), shape.mesh


def bones_from(points, edges, radii, standard: str | None = None) -> Bones:
    return bones_of(points, edges, radii, radii, standard)


def turned(angle: float, axis: int) -> np.ndarray:
    return spatial.transform.Rotation.from_rotvec(angle * np.eye(3)[axis]).as_matrix()


@pytest.mark.parametrize("name", SHAPES)
def test_every_bone_has_vertices_and_no_edge_stretches_to_twice_its_length_at_40_degrees(name):
    skeleton, mesh = known(name)
    made = skeleton.rig(mesh=mesh)
    weights = made.weights.toarray()
    assert len(made.joints) > 1
    assert (made.parents < np.arange(len(made.parents))).all() and (made.parents[1:] >= 0).all()
    assert weights.min() >= 0 and (weights > 0).sum(axis=1).max() <= 4
    np.testing.assert_allclose(weights.sum(axis=1), 1, rtol=1e-12)
    a, b = mesh.edges_unique.T
    length = np.linalg.norm(mesh.vertices[a] - mesh.vertices[b], axis=1)
    for bone in made.names:
        for axis in range(3):
            bent = made.posed(mesh.vertices, {bone: turned(np.radians(40), axis)})
            assert (np.linalg.norm(bent[a] - bent[b], axis=1) / length).max() < 2


@pytest.mark.parametrize(
    ("name", "most"),
    [
        ("trefoil", 4.0),
        pytest.param("theta", 3.0, marks=pytest.mark.slow),
        pytest.param("cube_frame", 6.0, marks=pytest.mark.slow),
    ],
)
def test_where_a_loop_was_cut_the_surface_is_not_torn(name, most):
    """When a bone of a loop turns, the other side of the cut is stretched along its limb, and not across one edge."""
    skeleton, mesh = known(name)
    made = skeleton.rig(mesh=mesh)
    assert [note[:17] for note in made.notes] == ["a loop was cut at"] and made.notes[0] in str(made)
    a, b = mesh.edges_unique.T
    length = np.linalg.norm(mesh.vertices[a] - mesh.vertices[b], axis=1)
    for bone in made.names:
        for axis in range(3):
            bent = made.posed(mesh.vertices, {bone: turned(np.radians(40), axis)})
            assert (np.linalg.norm(bent[a] - bent[b], axis=1) / length).max() < most


def test_the_root_is_at_the_thickest_junction_and_limbs_begin_where_they_leave_its_ball():
    skeleton, mesh = known("y")
    made = skeleton.rig(mesh=mesh)
    np.testing.assert_allclose(made.joints[0], 0, atol=1e-12)
    first = np.flatnonzero(made.parents == 0)
    assert len(first) == 3
    assert (np.linalg.norm(made.joints[first], axis=1) > 0.13).all()
    tips = set(range(len(made.joints))) - set(made.parents.tolist())
    ends = ground_truth.make("y").tips
    assert spatial.KDTree(made.tails[sorted(tips)]).query(ends)[0].max() < 1e-9


def test_a_limb_gets_joints_where_it_bends():
    """A straight arm of four radii to the elbow, and four from there."""
    stops = np.linspace(0, 1, 21)[:, None]
    nodes = np.concatenate([stops * [1, 0, 0], [1, 0, 0] + stops[1:] * [0, 1, 0]])
    edges = np.stack([np.arange(40), np.arange(1, 41)], axis=1)
    found = bones_from(nodes, edges, np.r_[np.full(2, 0.3), np.full(39, 0.25)])
    assert np.linalg.norm(found.joints - [1, 0, 0], axis=1).min() < 0.01


def test_a_straight_limb_has_a_bone_for_at_most_six_radii():
    """One of some twenty radii has four, each half of a half."""
    nodes = np.linspace(0, 1, 41)[:, None] * [1.0, 0, 0]
    edges = np.stack([np.arange(40), np.arange(1, 41)], axis=1)
    found = bones_from(nodes, edges, np.r_[0.06, np.full(40, 0.05)])
    length = np.linalg.norm(found.tails - found.joints, axis=1)[1:] / 0.05
    assert len(length) == 4 and length.max() <= 6 and length.min() > 3


def test_few_influences_leave_no_jump():
    """Along a path through the weights of nine bones, those of four change by little in each of its many steps."""
    random = np.random.default_rng(4)
    stops = random.dirichlet(np.full(9, 0.5), 12)
    fine = np.concatenate([np.linspace(a, b, 2000) for a, b in pairwise(stops)])
    few = np.pad(random.dirichlet(np.ones(4), 50), ((0, 0), (0, 5)))
    for found in (reduce_along_tree(fine, np.array([-1, 0, 0, 0, 1, 1, 2, 3, 7])), subtract_rest(fine)):
        np.testing.assert_allclose(found.sum(axis=1), 1, rtol=1e-12)
        assert (found > 0).sum(axis=1).max() == 4 and found.min() >= 0
    step = np.abs(np.diff(fine, axis=0)).max()
    assert np.abs(np.diff(reduce_along_tree(fine, np.array([-1, 0, 0, 0, 1, 1, 2, 3, 7])), axis=0)).max() < 60 * step
    left = (fine - np.sort(fine, axis=1)[:, 4:5]).clip(0).sum(axis=1)  # beyond the fifth largest
    assert (np.abs(np.diff(subtract_rest(fine), axis=0)).max(axis=1) < 20e-3 / left[1:]).all()
    np.testing.assert_allclose(subtract_rest(few), few, atol=1e-5)


def test_heat_on_a_long_tube_falls_as_its_equation_says():
    """Two bones that meet in the middle: w = exp(-x / d) / 2 beyond, for w'' = (w - p) / d^2; here d is 1.3 radii."""
    radius, stops, sides = 0.2, np.linspace(-3, 3, 241), 24
    angle = 2 * np.pi * np.arange(sides) / sides
    points = np.array([[radius * np.cos(a), radius * np.sin(a), z] for z in stops for a in angle])
    first = sides * np.arange(len(stops) - 1)[:, None] + np.arange(sides)
    after = sides * np.arange(len(stops) - 1)[:, None] + (np.arange(sides) + 1) % sides
    quads = [first.ravel(), after.ravel(), after.ravel() + sides, first.ravel() + sides]
    faces = np.concatenate([np.stack([quads[a], quads[b], quads[c]], axis=1) for a, b, c in ((0, 1, 2), (0, 2, 3))])
    weight = heat_weights(points, faces, np.full(len(points), 1.3 * radius), (points[:, 2] > 0).astype(int), 2)[:, 1]
    beyond = (points[:, 2] < -0.1) & (points[:, 2] > -1)
    np.testing.assert_allclose(weight[beyond], np.exp(points[beyond, 2] / (1.3 * radius)) / 2, rtol=0.06)


def test_names_tell_the_side_where_a_shape_is_symmetric():
    """A T with arms along x: one branch down, two that are each other's image."""
    nodes = np.array([[0, 0, 0], [1.0, 0, 0], [2, 0, 0], [-1, 0, 0], [-2, 0, 0], [0, -1, 0], [0, -2.5, 0]])
    edges = np.array([[0, 1], [1, 2], [0, 3], [3, 4], [0, 5], [5, 6]])
    found = bones_from(nodes, edges, np.full(7, 0.3))
    names = found.names
    side = {name: joint[0] for name, joint in zip(names, found.joints, strict=True)}
    assert names[0] == "root" and len(set(names)) == len(names)
    left = [name for name in names if name.endswith(".L")]
    assert left and all(side[name] > 0 > side[name[:-1] + "R"] for name in left)
    bent = nodes * [1, 1, 0] + [0, 0, 1] * nodes[:, :1] ** 2 * (nodes[:, :1] > 0)
    lopsided = bones_from(bent, edges, np.full(7, 0.3))
    assert not any(name.endswith((".L", ".R")) for name in lopsided.names)


def document_of(path) -> tuple[dict, list[np.ndarray]]:
    """The JSON of a .glb file, and the arrays of its accessors, by the format's own rules."""
    content = path.read_bytes()
    assert content[:4] == b"glTF" and struct.unpack("<I", content[8:12])[0] == len(content)
    size = struct.unpack("<I", content[12:16])[0]
    document, binary = json.loads(content[20 : 20 + size]), content[28 + size :]
    kinds = {5121: "<u1", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
    columns = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
    arrays = []
    for accessor in document["accessors"]:
        view, width = document["bufferViews"][accessor["bufferView"]], columns[accessor["type"]]
        at = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        flat = np.frombuffer(binary, kinds[accessor["componentType"]], accessor["count"] * width, at)
        arrays.append(flat.reshape(-1, width))
    return document, arrays


def skinned(path, turns: dict[str, np.ndarray]) -> np.ndarray:
    """Where the format says that the vertices of a file go when joints turn: sum of w J inverse(bind) x."""
    document, arrays = document_of(path)
    nodes, skin = document["nodes"], document["skins"][0]
    above = {child: number for number, node in enumerate(nodes) for child in node.get("children", [])}

    def matrix(number: int) -> np.ndarray:
        own = np.eye(4)
        own[:3, 3] = nodes[number].get("translation", [0, 0, 0])
        own[:3, :3] = turns.get(nodes[number]["name"], np.eye(3))
        return matrix(above[number]) @ own if number in above else own

    inverse = arrays[skin["inverseBindMatrices"]].reshape(-1, 4, 4).transpose(0, 2, 1).astype(float)
    joints = np.array([matrix(joint) for joint in skin["joints"]]) @ inverse
    found = []
    for node in nodes:
        if "mesh" not in node:
            continue
        attributes = document["meshes"][node["mesh"]]["primitives"][0]["attributes"]
        at, bound, weight = (arrays[attributes[name]] for name in ("POSITION", "JOINTS_0", "WEIGHTS_0"))
        whole = np.c_[at, np.ones(len(at))]
        found.append(np.einsum("vk,vkab,vb->va", weight, joints[bound], whole)[:, :3])
    return np.concatenate(found)


def test_a_pose_has_slopes_in_its_rotations_and_vertices():
    skeleton, mesh = known("y")
    made, axis = skeleton.rig(mesh=mesh), np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 0]])
    at_rest, above = np.array(mesh.vertices), turned(0.3, 1)

    def spread(angle, vertices):
        turn = jnp.eye(3) + jnp.sin(angle) * axis + (1 - jnp.cos(angle)) * axis @ axis
        return (made.posed(vertices, {made.names[-1]: turn, made.names[0]: above}) ** 3).sum()

    with jax.enable_x64(True):
        assert spread(0.4, at_rest) == pytest.approx(
            (made.posed(at_rest, {made.names[-1]: turned(0.4, 2), made.names[0]: above}) ** 3).sum(), rel=1e-12
        )
        by_angle, by_vertex = jax.jit(jax.grad(spread, (0, 1)))(0.4, jnp.asarray(at_rest))
        way = np.random.default_rng(0).normal(size=at_rest.shape)
        for step in (1e-3, 1e-4, 1e-5):
            ahead, behind = (spread(0.4 + sign * step, at_rest + sign * step * way) for sign in (1, -1))
            assert (ahead - behind) / (2 * step) == pytest.approx(float(by_angle + (by_vertex * way).sum()), rel=1e-4)


def test_a_glb_bends_as_the_rig_does(tmp_path):
    skeleton, mesh = known("y")
    made = skeleton.rig(mesh=mesh)
    skeleton.save(tmp_path / "y.glb", mesh)
    at_rest = skinned(tmp_path / "y.glb", {})
    row = spatial.KDTree(mesh.vertices).query(at_rest)[1]  # a vertex at a crease is there more than once
    assert set(row.tolist()) == set(range(len(mesh.vertices)))
    np.testing.assert_allclose(at_rest, mesh.vertices[row], atol=1e-6)
    turns = {made.names[1]: turned(0.7, 0), made.names[2]: turned(-0.4, 1), made.names[0]: turned(0.3, 2)}
    bent = made.posed(mesh.vertices, turns)
    assert np.linalg.norm(bent - mesh.vertices, axis=1).max() > 0.2
    np.testing.assert_allclose(skinned(tmp_path / "y.glb", turns), bent[row], atol=1e-5)
    document, arrays = document_of(tmp_path / "y.glb")
    assert [document["nodes"][joint]["name"] for joint in document["skins"][0]["joints"]] == list(made.names)
    attributes = document["meshes"][0]["primitives"][0]["attributes"]
    assert (arrays[attributes["WEIGHTS_0"]] > 0).sum(axis=1).max() <= 4


def test_materials_uvs_and_normals_of_all_parts_are_kept(tmp_path):
    """Two limbs in one scene, each with an image of its own; the rig speaks of both."""
    _, mesh = known("s_curve")
    scene = trimesh.Scene()
    for number, colour in enumerate([(250, 10, 10), (10, 10, 250)]):
        material = trimesh.visual.material.PBRMaterial(baseColorTexture=Image.new("RGB", (4, 4), colour))
        visual = trimesh.visual.TextureVisuals(uv=mesh.vertices[:, :2] % 1.0, material=material)
        part = trimesh.Trimesh(mesh.vertices, mesh.faces, process=False, visual=visual)
        part.vertex_normals  # noqa: B018  trimesh writes those that it has
        scene.add_geometry(
            part, geom_name=f"limb {number}", transform=np.eye(4) + np.eye(4, k=3) * [0, 0, 0, 3 * number]
        )
    scene.export(tmp_path / "in.glb")
    skeleton, _ = known("s_curve")
    num = len(skeleton.vertices)
    two = curve_of(
        np.concatenate([skeleton.vertices, skeleton.vertices + [3, 0, 0]]),
        np.concatenate([skeleton.edges, skeleton.edges + num]),
        np.tile(skeleton.radii, 2),
    )
    vertices, _ = reading.read(tmp_path / "in.glb")  # one limb after the other, as the scene has them
    nearest = spatial.KDTree(two.vertices).query(vertices)[1]
    Skeleton(two.vertices, two.edges, two.radii, nearest, two.report).save(tmp_path / "out.glb", tmp_path / "in.glb")
    found = sorted(trimesh.load(tmp_path / "out.glb").geometry.values(), key=lambda part: part.bounds[0, 0])
    assert len(found) == 2
    for part, colour in zip(found, [(250, 10, 10), (10, 10, 250)], strict=True):
        assert part.visual.material.baseColorTexture.getpixel((1, 1))[:3] == colour
        np.testing.assert_allclose(part.visual.uv, mesh.vertices[:, :2] % 1.0, atol=1e-6)
    document, _ = document_of(tmp_path / "out.glb")
    assert all("NORMAL" in mesh["primitives"][0]["attributes"] for mesh in document["meshes"])
    np.testing.assert_allclose(skinned(tmp_path / "out.glb", {}), vertices, atol=1e-6)


def test_vertices_in_one_place_stay_together():
    """A seam: the mesh cut along an edge loop into two lists of vertices, as a file with UVs has it."""
    skeleton, mesh = known("y")
    is_other = mesh.triangles_center[:, 2] > 0.3
    faces = mesh.faces.copy()
    faces[is_other] += len(mesh.vertices)
    doubled = Skeleton(
        skeleton.vertices, skeleton.edges, skeleton.radii, np.tile(skeleton.mesh_map, 2), skeleton.report
    )
    weights = doubled.rig(mesh=(np.tile(mesh.vertices, (2, 1)), faces)).weights.toarray()
    np.testing.assert_allclose(*np.split(weights, 2), atol=1e-9)
    np.testing.assert_allclose(weights[: len(mesh.vertices)], skeleton.rig(mesh=mesh).weights.toarray(), atol=1e-6)


def test_what_cannot_be_rigged_is_named(tmp_path):
    skeleton, mesh = known("y")
    with pytest.raises(ConfigError, match="does not know the mesh"):
        skeleton.rig()
    with pytest.raises(MeshError, match="expected the same mesh"):
        skeleton.rig(mesh=ground_truth.make("straight").mesh)
    made = skeleton.rig(mesh=mesh)
    with pytest.raises(ConfigError, match=r"for a rig in .*: expected the suffix .glb"):
        made.save(tmp_path / "y.fbx", mesh)
    with pytest.raises(ConfigError, match=r"turns has 'elbow' with shape .*: expected a bone's name"):
        made.posed(mesh.vertices, {"elbow": np.eye(3)})
    with pytest.raises(ConfigError, match="vertices has shape"):
        made.posed(mesh.vertices[1:], {})
    assert list(tmp_path.iterdir()) == []


def figure(
    shift: float, head: float, front: float = 0.0, palms: tuple[float, ...] = ()
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """A biped as a curve with radii; its legs meet ``shift`` beside the middle, as an uneven curve has it. Feet go
    by ``front`` to the front, which is z. Three fingers begin at x = 4 and three at x = -4, but for the second and the
    third of each side, which begin by one of ``palms`` beyond."""
    chains = [
        [(shift, 5.0, 0), (0, 8.0, 0)],  # from the pelvis to the arms
        [(0, 8.0, 0), (0, 10.5, 0)],
        [(shift, 5.0, 0), (1.0, 3.0, 0), (1.0, 0, 0)],
        [(shift, 5.0, 0), (-1.0, 3.0, 0), (-1.0, 0, 0)],
        [(0, 8.0, 0), (4.0, 8.0, 0)],
        [(0, 8.0, 0), (-4.0, 8.0, 0)],
    ]
    if front:
        chains += [[(side, 0, 0), (side, 0, front)] for side in (1.0, -1.0)]
    for side, palm in zip((1.0, -1.0), palms, strict=False):
        begin, other = (side * 4.0, 8.0, 0), (side * (4.0 + palm), 8.0, 0)
        chains += [[begin, (side * 6.0, 8.0, 0.5)], [other, (side * 6.2, 8.0, 0)], [other, (side * 6.1, 8.0, -0.5)]]
        chains += [[begin, other]] if palm else []
    points = np.unique(
        np.concatenate([np.linspace(a, b, 26) for chain in chains for a, b in pairwise(np.array(chain))]).round(9),
        axis=0,
    )
    tree = spatial.KDTree(points)
    edges = np.concatenate(
        [
            np.stack([line[:-1], line[1:]], axis=1)
            for chain in chains
            for a, b in pairwise(np.array(chain))
            for line in [tree.query(np.linspace(a, b, 26))[1]]
        ]
    )
    radii = np.where(np.abs(points[:, 0]) > 1.5, 0.3, np.where(points[:, 1] < 4, 0.4, 0.9))
    radii[points[:, 1] > 9.5] = head
    return points, np.unique(np.sort(edges, axis=1), axis=0), radii


@pytest.mark.parametrize("shift", [0.0, 0.4, -0.4])
def test_a_biped_stands_on_its_pelvis_and_is_the_same_on_both_sides(shift):
    """The head is the thickest part, and the chest as thick as the pelvis."""
    points, edges, radii = figure(shift, head=2.0)
    found = bones_from(points, edges, radii)
    names = found.names
    assert len(set(names)) == len(names) and found.joints[0, 1] < 6 and abs(found.joints[0, 0]) < 1e-9
    spine = [k for k, name in enumerate(names) if name.startswith("trunk")]
    assert len(spine) == 3 and found.parents[spine].tolist() == [0, *spine[:2]]
    if not shift:  # from the hips to the arms the second to the fifth of five equal steps
        places = [*found.joints[[0, *spine], 1], found.tails[spine[-1], 1]]
        np.testing.assert_allclose(np.diff(places) / (places[-1] - places[0]), 1 / 4, atol=1e-9)
    left = [name for name in names if name.endswith(".L")]
    assert len(left) == sum(name.endswith(".R") for name in names) >= 4  # an arm and a leg of two bones or more
    for name in left:
        one, other = names.index(name), names.index(name[:-1] + "R")
        np.testing.assert_allclose(found.joints[one] * [-1, 1, 1], found.joints[other], atol=1e-9)
    arm = [name for name in left if found.joints[names.index(name), 1] > 7]
    begin, elbow = sorted(found.joints[names.index(name), 0] for name in arm)
    assert abs(elbow - (begin + 4) / 2) < 1e-9  # straight: at the half


@pytest.mark.parametrize("palms", [(0.1, 0.0), (0.0, 0.35), (0.1, 0.35), (0.7, 0.0)])
def test_where_fingers_begin_changes_no_name(palms):
    """At one junction or at two, near each other or with a bone between them, on one side or on both."""
    alike, other = (bones_from(*figure(0.0, 1.0, palms=each)) for each in ((0.0, 0.0), palms))
    names = [[name for name in found.names if "trunk" not in name] for found in (alike, other)]
    assert sorted(names[0]) == sorted(names[1]) and sum(name.endswith("_1.L") for name in names[0]) == 4
    is_one = max(palms) < 0.5  # there is no length for a bone between the junctions
    assert len(alike.joints) == len(other.joints) - (0 if is_one else 1)
    names = other.names
    for name in (each for each in names if is_one and each.endswith(".L")):
        one, image = other.joints[names.index(name)], other.joints[names.index(name[:-1] + "R")]
        np.testing.assert_allclose(one * [-1, 1, 1], image, atol=0.2)


def four_legged(head: float, ears: bool, tail: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """A curve with radii: legs 2 long at z 0 and 4, a neck from the front legs to a head that has horns and ears as
    long as the legs, and perhaps a tail of radius ``tail``."""
    chains = [((0, 0, 0), (0, 0.3, 4), 0.7), ((0, 0.3, 4), (0, 2.5, 6), 0.5)]
    chains += [((0, 0, 0), (side, -2, -0.2), 0.25) for side in (1, -1)]
    chains += [((0, 0.3, 4), (side, -2, 4.2), 0.25) for side in (1, -1)]
    if ears:
        chains += [((0, 2.5, 6), (2.4 * side, 3, 6.0), 0.25) for side in (1, -1)]
        chains += [((0, 2.5, 6), (side, 4.5, 5.8), 0.25) for side in (1, -1)]
    if tail:
        chains += [((0, 0, 0), (0, 0.5, -3), tail)]
    points, edges, radii = curve_along(chains)
    radii[np.linalg.norm(points - [0, 2.5, 6], axis=1) < 0.8] = head
    return points, edges, radii


def curve_along(chains: list) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """A curve with radii along ``chains`` of a beginning, an end and a radius, the largest where these meet."""
    points = np.concatenate([np.linspace(a, b, 41) for a, b, _ in chains]).round(9)
    at, of = np.unique(points, axis=0, return_inverse=True)
    edges = of.ravel().reshape(-1, 41)
    radii = np.zeros(len(at))
    np.maximum.at(radii, edges.ravel(), np.repeat([radius for *_, radius in chains], 41))
    return (
        at,
        np.unique(np.sort(np.stack([edges[:, :-1].ravel(), edges[:, 1:].ravel()], axis=1), axis=1), axis=0),
        radii,
    )


def body_of(leg: float, arm: float, tail: float, bow: float = 0.0, sprawl: float = 0.0, lift: float = 0.0) -> tuple:
    """A curve with radii of a body whose trunk is 2 long and bowed to the front, which is z, by ``bow`` radians, on
    legs with feet; ``tail`` is its length, 0 for none, and the tail is thicker than the head. Legs are turned to their
    sides by ``sprawl``, and arms from their sides in the direction of the legs by ``lift``."""
    chest = np.array([0, 2 * np.cos(bow), 2 * np.sin(bow)])
    chains = [((0, 0, 0), chest, 0.45), (chest, 1.5 * chest + [0, 0.4, 0], 0.2)]
    for side in (1, -1):
        ankle = leg * np.array([side * np.sin(sprawl + 0.2), -np.cos(sprawl + 0.2), 0])
        hand = chest + arm * np.array([side * np.cos(lift), -np.sin(lift), 0])
        chains += [((0, 0, 0), ankle, 0.15), (ankle, ankle + [0, 0, 0.2 * leg], 0.1), (chest, hand, 0.15)]
    return curve_along([*chains, *([((0, 0, 0), (0, -0.3, -tail), 0.4)] if tail else [])])


@pytest.mark.parametrize(
    ("head", "ears", "tail"), [(1.2, True, 0.0), (0.5, True, 0.6), (0.9, False, 0.0), (0.9, False, 0.2)]
)
@pytest.mark.parametrize("seed", [0, 1])
def test_the_pelvis_is_the_end_of_the_trunk_without_the_head_however_it_is_turned(head, ears, tail, seed):
    """Horns and ears are as long as legs, and the head is the thickest part."""
    points, edges, radii = four_legged(head, ears, tail)
    turn = turned(2.0 + seed, 0) @ turned(1.0, 1) @ turned(0.7, 2) @ np.diag([1, 1, 1 - 2.0 * seed])
    straight, other = (bones_from(at, edges, radii) for at in (points, points @ turn.T))
    assert np.linalg.norm(straight.joints[0]) < 1.5
    np.testing.assert_allclose(np.sort(other.joints @ turn, axis=0), np.sort(straight.joints, axis=0), atol=1e-4)
    names = straight.names
    assert sorted(name[:-1] for name in names if name.endswith(".L")) == sorted(
        name[:-1] for name in names if name.endswith(".R")
    )
    first = next(k for k, name in enumerate(names) if name.startswith("trunk") and straight.parents[k] == 0)
    spine = [k for k, name in enumerate(names) if name.startswith(names[first][:-1])]
    assert len(spine) == 3 and straight.parents[spine].tolist() == [0, *spine[:2]]


REQUIRED = "hips spine head UpperLeg LowerLeg Foot UpperArm LowerArm Hand"  # of VRM's humanoid, by its specification


@pytest.mark.parametrize("front", [1.2, -1.2])
def test_the_bones_of_a_biped_have_the_names_of_a_standard_and_its_left_is_where_its_feet_tell(front):
    found = bones_from(*figure(0.0, 1.0, front), "vrm")
    at = dict(zip(found.names, found.joints, strict=True))
    required = REQUIRED.split()
    assert set(required[:3]) | {side + name for side in ("left", "right") for name in required[3:]} <= set(at)
    assert at["leftHand"][0] * front > 0 and at["rightFoot"][0] * front < 0
    for side in ("left", "right"):
        np.testing.assert_allclose(abs(at[f"{side}Foot"]), [1, 0, 0], atol=0.15)  # the ankle is where the leg bends
        np.testing.assert_allclose(abs(at[f"{side}LowerLeg"]), [1, 3, 0], atol=0.5)  # so is the knee
        assert 1.9 < abs(at[f"{side}LowerArm"][0]) < abs(at[f"{side}Hand"][0]) < 3.3
    assert 8 < at["neck"][1] < at["head"][1] < 10
    for standard, some in (("mixamo", ("LeftUpLeg", "RightForeArm")), ("unreal", ("thigh_l", "hand_r"))):
        names = bones_from(*figure(0.0, 1.0, front), standard).names
        assert len(set(names)) == len(found.joints) and set(some) <= {name.split(":")[-1] for name in names}


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize(
    ("shape", "reason"),
    [
        ({"tail": 2.5}, ""),
        ({"tail": 1.5, "bow": 0.4}, ""),  # leaning, as those with tails do
        ({"tail": 1.5, "bow": 1.4}, ""),  # a bird with wings to the sides
        ({"leg": 0.9, "arm": 2.5, "tail": 0.0}, ""),
        ({"tail": 2.0, "bow": 1.57, "sprawl": 1.3}, "at [789]. degrees to its trunk, to its two sides"),
        ({"tail": 2.0, "bow": 1.57, "lift": 1.4}, "at [789]. degrees to its trunk, and those at its shoulders go"),
    ],
)
def test_a_biped_is_what_stands_on_one_end_of_its_trunk_however_it_is_turned_and_mirrored(shape, reason, seed):
    random = np.random.default_rng(seed)
    points, edges, radii = body_of(**{"leg": random.uniform(1.4, 2.2), "arm": random.uniform(1.4, 2.0)} | shape)
    turn = spatial.transform.Rotation.random(rng=random).as_matrix() @ np.diag([1.0, 1, (-1.0) ** seed])
    if reason:
        with pytest.raises(ConfigError, match=reason):
            bones_from(points @ turn.T, edges, radii, "vrm")
        return
    found = bones_from(points @ turn.T, edges, radii, "vrm")
    at = dict(zip(found.names, found.joints @ turn, strict=True))
    assert np.linalg.norm(at["hips"]) < 0.6 and np.linalg.norm(at["head"]) > 2
    side = -np.linalg.det(turn)  # of a figure that looks along z with y up the left is at positive x
    assert at["leftFoot"][0] * side < 0 < at["rightHand"][0] * side
    assert not found.notes


def test_what_is_no_biped_is_refused_with_the_reason():
    tips = [(np.cos(angle), np.sin(angle), 0) for angle in 0.4 * np.pi * np.arange(5)]
    with pytest.raises(ConfigError, match="all pairs of limbs begin at one place"):
        bones_from(*curve_along([((0, 0, 0), tip, 0.1) for tip in tips]), "vrm")
    skeleton, mesh = known("y")
    with pytest.raises(ConfigError, match=r"all pairs of limbs begin at one place.*: expected names=None"):
        skeleton.rig(mesh=mesh, names="unreal")
    points, edges, radii = figure(0.0, 1.0)
    two = np.concatenate([points, points * [1, 0.7, 1] + [9, 0, 0]]), np.concatenate([edges, edges + len(points)])
    with pytest.raises(ConfigError, match="the curve is in 2 pieces, and that of a biped in one"):
        bones_from(*two, np.tile(radii, 2), "vrm")
    with pytest.raises(ConfigError, match="names is 'maya': expected None or one of mixamo, vrm, unreal"):
        skeleton.rig(mesh=mesh, names="maya")
