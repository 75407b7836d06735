"""Following: the recorded curve at the recorded mesh, affine maps carried along, closed forms, batches, bad input.
Its derivatives are in test_transformations."""

import functools
import pickle

import jax
import jax.numpy as jnp
import numpy as np
import pytest
import trimesh
from conftest import blob, torus
from run_cases import flow_of
from scipy.spatial.transform import Rotation
from test_transformations import in_process

import msf_jax
from msf_jax import ConfigError, MeshError
from msf_jax.base.binding import SMALLEST_SIZES, capacity_for, padded, unpadded
from msf_jax.solid.solid import Solid
from tests.benchmarks import ground_truth

KNOWN = {"y": "y_coarse", "tube": "straight_coarse"}


@functools.cache
def curve(name):
    """A mesh and its curve: three limbs, a short straight tube, two parts, or a square beam of 12 x 2 x 2 along x."""
    if name in KNOWN:
        mesh, skeleton = ground_truth.make(KNOWN[name]).mesh, flow_of(KNOWN[name]).skeleton
    elif name == "two":
        mesh = trimesh.util.concatenate([blob(4, 2), torus().apply_translation([1.5, 0, 0])])
        skeleton = msf_jax.skeletonize(mesh)
    else:
        mesh = trimesh.creation.box([12, 2, 2])
        while len(mesh.vertices) < 300:
            mesh = mesh.subdivide()
        skeleton = msf_jax.skeletonize(mesh)
    return np.array(mesh.vertices), np.array(mesh.faces), skeleton


@pytest.fixture(scope="module")
def limbs():
    return curve("y")


@pytest.fixture(scope="module")
def tube():
    return curve("tube")


@pytest.fixture(scope="module")
def batch():
    return msf_jax.stack([curve(name)[2] for name in ("tube", "y")])


def diagonal(vertices):
    return float(np.linalg.norm(np.ptp(vertices, axis=0)))


def turn_by(angle):
    return Rotation.from_rotvec(angle * np.array([0.5, -0.6, 0.6])).as_matrix()


def moved(vertices):
    """Smoothly, and not the same everywhere; rows that pad move, too."""
    return vertices + 0.05 * np.sin(2 * np.asarray(vertices)[..., [1, 2, 0]] + 0.3)


@pytest.mark.parametrize("name", ["y", "two"])
def test_an_affine_map_of_the_mesh_maps_the_curve(name):
    """None, turned, stretched, sheared and moved far away, made small; and turned, radii are as they were."""
    vertices, _, skeleton = curve(name)
    turn = turn_by(0.9)
    shear = np.eye(3) + 0.3 * np.random.default_rng(2).normal(size=(3, 3))
    for matrix, shift in ((np.eye(3), 0.0), (turn, 0.0), (3.0 * turn, 70.0), (1e-3 * turn, 0.0), (shear, -5.0)):
        near = (1e-12 if matrix[0, 1] == 0 else 1e-9) * diagonal(vertices)
        nodes, radii = msf_jax.follow(skeleton, vertices @ matrix.T + shift)
        np.testing.assert_allclose(nodes, skeleton.vertices @ matrix.T + shift, rtol=0, atol=near)
        if matrix is not shear:
            np.testing.assert_allclose(radii, np.linalg.norm(matrix[0]) * skeleton.radii, rtol=0, atol=near)


def pressed_in(vertices, skeleton):
    """A bump pressed in, past the nodes of a limb."""
    leaf = int(np.flatnonzero(np.bincount(skeleton.edges.ravel()) == 1)[0])
    path = next(branch.nodes for branch in skeleton.branches if leaf in (branch.nodes[0], branch.nodes[-1]))
    middle, along = skeleton.vertices[path[len(path) // 2]], skeleton.vertices[path[-1]] - skeleton.vertices[path[0]]
    side = np.cross(along, [0.3, 0.5, 0.8])
    side /= np.linalg.norm(side)
    away = vertices - middle
    bump = np.exp(-(((away @ along) / (along @ along) / 0.12) ** 2)) * (np.linalg.norm(away, axis=1) < 1.5)
    return vertices - (bump * 1.9 * np.maximum(away @ side, 0))[:, None] * side


def test_radii_are_exact_and_negative_outside(limbs):
    """In meshes that are squashed, where other walls are nearest than were at first, and where nodes leave the mesh:
    distance and side are those of the solid as it is then."""
    vertices, faces, skeleton = limbs
    outside = 0
    for given in (*(vertices * scale for scale in ([1, 0.2, 1], [0.2, 1, 1], [3, 1, 0.3])), pressed_in(*limbs[::2])):
        nodes, radii = map(np.asarray, msf_jax.follow(skeleton, given))
        solid = Solid(given, faces)
        winding = solid.shape.winding_numbers(solid.enter(nodes))
        assert set(winding) <= {0, 1}
        outside += (winding == 0).sum()
        expected = solid.diagonal * solid.shape.distances(solid.enter(nodes)) * np.where(winding > 0, 1, -1)
        np.testing.assert_allclose(radii, expected, rtol=0, atol=1e-12)
    assert outside


def test_a_beam_takes_its_nodes_along():
    """Bent, its middle goes to a circle whose length is the beam's; stretched unevenly, the nodes stretch alike."""
    vertices, faces, skeleton = curve("beam")
    curvature = np.radians(60) / 12

    def bent(points):
        x, y, z = points.T
        angle = curvature * x
        return np.stack([(1 / curvature - y) * np.sin(angle), (y - 1 / curvature) * np.cos(angle), z], axis=1)

    nodes, radii = msf_jax.follow(skeleton, bent(vertices))
    np.testing.assert_allclose(nodes, bent(skeleton.vertices), rtol=0, atol=0.05)
    np.testing.assert_allclose(radii, Solid(bent(vertices), faces).radii(np.asarray(nodes)), atol=1e-10)
    stretched = vertices + np.outer(0.5 * np.sin(0.5 * vertices[:, 0]), [1, 0, 0])
    expected = skeleton.vertices + np.outer(0.5 * np.sin(0.5 * skeleton.vertices[:, 0]), [1, 0, 0])
    off = (np.asarray(msf_jax.follow(skeleton, stretched).nodes) - expected)[
        np.abs(skeleton.vertices[:, 0]) < 3.5
    ]  # away from the ends
    np.testing.assert_allclose(off, 0, atol=0.06)


def test_a_node_is_in_the_middle_of_the_area_of_its_section():
    """One of the four long edges is pulled out: the centroid of the new quadrangle, by its two triangles."""
    vertices, _, skeleton = curve("beam")
    given = vertices.copy()
    is_edge = (vertices[:, 1] == 1) & (vertices[:, 2] == 1)
    given[is_edge, 1:] += 1.0
    # The sides beside the edge stay flat.
    for axis in (1, 2):
        side = (vertices[:, axis] == 1) & ~is_edge
        share = (vertices[side, 3 - axis] + 1) / 2
        given[side, axis] = 1 + share
        given[side, 3 - axis] = -1 + 3 * share
    corners = np.array([[-1, -1], [1, -1], [2, 2], [-1, 1.0]])
    one, other = corners[[0, 1, 2]], corners[[0, 2, 3]]
    area = [np.linalg.det(part[1:] - part[0]) / 2 for part in (one, other)]
    expected = (area[0] * one.mean(axis=0) + area[1] * other.mean(axis=0)) / sum(area)
    found = np.asarray(msf_jax.follow(skeleton, given).nodes)[np.abs(skeleton.vertices[:, 0]) < 3.5, 1:]
    np.testing.assert_allclose(found, np.broadcast_to(expected, found.shape), rtol=0, atol=0.01)
    assert np.linalg.norm(corners.mean(axis=0) - expected) > 0.05  # which is not the mean of the corners


def test_the_jacobian_is_that_of_jax(limbs):
    """And a mesh that is moved or turned as a whole moves every node alike."""
    vertices, _, skeleton = limbs
    jacobian, num = skeleton.jacobian(), len(skeleton.vertices)
    back = np.random.default_rng(1).normal(size=(num, 3))
    reverse = jax.jit(jax.grad(lambda at: (back * msf_jax.follow(skeleton, at).nodes).sum()))(vertices)
    shift = np.array([0.3, -2.0, 0.7])
    for motion, expected in (
        (np.tile(shift, (len(vertices), 1)), np.tile(shift, (num, 1))),
        (np.cross(shift, vertices), np.cross(shift, skeleton.vertices)),
    ):
        np.testing.assert_allclose((jacobian @ motion.ravel()).reshape(-1, 3), expected, rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose((jacobian.T @ back.ravel()).reshape(-1, 3), reverse, rtol=1e-9, atol=1e-9)
    sigma = np.zeros(len(vertices))
    sigma[17] = 0.5
    block = jacobian.toarray()[:, 51:54].reshape(-1, 3, 3)
    np.testing.assert_allclose(skeleton.covariance(sigma), 0.25 * block @ block.transpose(0, 2, 1), atol=1e-14)


def test_a_changed_curve_is_followed_and_one_from_a_file(limbs, tmp_path):
    vertices, _, skeleton = limbs
    changed = skeleton.prune(50.0).resample(0.1).smooth(5)
    assert len(changed.vertices) < len(skeleton.vertices)
    turn = turn_by(1.4)
    np.testing.assert_allclose(msf_jax.follow(changed, vertices).nodes, changed.vertices, atol=1e-10)
    np.testing.assert_allclose(msf_jax.follow(changed, vertices @ turn.T).nodes, changed.vertices @ turn.T, atol=1e-9)
    changed.save(tmp_path / "y.npz")
    read = msf_jax.read_curve(tmp_path / "y.npz")
    nodes = msf_jax.follow(read, moved(vertices)).nodes  # a file has the mesh to the last bit
    np.testing.assert_array_equal(nodes, msf_jax.follow(changed, moved(vertices)).nodes)
    assert read.report == changed.report
    assert [branch.slenderness for branch in read.branches] == [branch.slenderness for branch in changed.branches]


def test_vertices_are_the_callers_and_pins_are_where_theirs_are(tube):
    """Every face has corners of its own, welded for the run; the last of a pin's is named. One vertex is in no face."""
    vertices, faces, _ = tube
    top = int(vertices[:, 2].argmax())
    pin = int(np.flatnonzero(faces.ravel() == top)[-1])
    apart = np.concatenate([vertices[faces.ravel()], [[9.0, 9.0, 9.0]]])
    skeleton = msf_jax.skeletonize((apart, np.arange(faces.size).reshape(-1, 3)), pins=[pin])
    assert skeleton.report.repairs
    turn = turn_by(2.1)
    nodes, _ = msf_jax.follow(skeleton, apart @ turn.T)
    np.testing.assert_allclose(nodes, skeleton.vertices @ turn.T, atol=1e-9)
    given = vertices + np.random.default_rng(0).normal(0, 0.01, vertices.shape)
    nodes, _ = msf_jax.follow(skeleton, np.concatenate([given[faces.ravel()], [[np.nan] * 3]]))
    np.testing.assert_allclose(nodes[skeleton.mesh_map[pin]], given[top], atol=1e-12)


def test_a_section_that_vanished_is_named(limbs):
    """The limb of the first leaf is crushed to a line."""
    vertices, _, skeleton = limbs
    leaf = int(np.flatnonzero(np.bincount(skeleton.edges.ravel()) == 1)[0])
    node = int(skeleton.edges[(skeleton.edges == leaf).any(axis=1)].sum() - leaf)
    centre = skeleton.vertices[node]
    given = np.where(np.linalg.norm(vertices - centre, axis=1)[:, None] < 0.3, centre, vertices)
    with pytest.raises(MeshError, match=r"the sections of \d+ nodes, the first \d+, have vanished"):
        msf_jax.follow(skeleton, given)
    nodes = jax.jit(lambda at: msf_jax.follow(skeleton, at).nodes)(given)
    is_gone = np.isnan(np.asarray(nodes)[:, 0])
    assert is_gone[node] and not is_gone.all()


# Batches


def test_every_curve_of_a_batch_is_what_it_is_alone(batch):
    """In padding there is nothing. One program serves every curve of a capacity."""
    assert len(batch) == 2 and batch.vertices.shape == (2, 1024, 3) and batch.node_mask.shape == (2, 320)
    assert repr(batch) == "Batch(2 curves, 320 rows of nodes, 1024 of vertices)"
    found = jax.jit(jax.vmap(msf_jax.follow))(batch.bindings, moved(batch.vertices))
    for k, name in enumerate(("tube", "y")):
        vertices, _, skeleton = curve(name)
        is_vertex = np.asarray(batch.vertex_mask[k])
        np.testing.assert_allclose(batch.vertices[k][is_vertex], vertices, rtol=0, atol=1e-14)
        assert not np.asarray(batch.vertices)[k][~is_vertex].any()
        alone = msf_jax.follow(skeleton, moved(vertices))
        for part, other in zip(batch.unstack(found)[k], alone, strict=True):
            np.testing.assert_allclose(part, other, rtol=0, atol=1e-13)
    for padding in (np.asarray(found.nodes)[~batch.node_mask], np.asarray(found.radii)[~batch.node_mask]):
        assert not padding.any()


BITS = """
import pickle, sys
import jax, numpy as np
jax.config.update("jax_enable_x64", True)
import msf_jax
from msf_jax.base.binding import padded, unpadded
import test_follow as cases

curves = pickle.load(open(sys.argv[1], "rb"))
batch = msf_jax.stack([skeleton for _, skeleton in curves])
everywhere = jax.numpy.asarray(cases.moved(batch.vertices))

def value(binding, vertices):  # linear in the nodes: powers of them are rounded by how many there are
    found = msf_jax.follow(binding, vertices)
    factor = jax.numpy.cos(jax.numpy.arange(len(found.radii), dtype=found.radii.dtype))
    whole = (factor[:, None] * found.nodes * np.array([1.0, 0.7, -0.4])).sum() + (factor * found.radii ** 2).sum()
    return whole, found

slope = jax.value_and_grad(value, argnums=1, has_aux=True)
(_, found), by_vertex = jax.jit(jax.vmap(slope))(batch.bindings, everywhere)
slope = jax.jit(slope)
for k, (vertices, skeleton) in enumerate(curves):
    own = unpadded(skeleton.binding)
    shared = batch.bindings.capacity._asdict()  # one program for both
    num, nodes = len(vertices), len(skeleton.vertices)
    binding = padded(own, own.live._replace(**{name: 2 * capacity for name, capacity in shared.items()}))
    rows = np.zeros((binding.num_vertices, 3))
    rows[:num] = everywhere[k, :num]
    (_, alone), by_own = slope(binding, rows)
    for one, other in zip(found, alone):
        np.testing.assert_array_equal(np.asarray(one)[k, :nodes], np.asarray(other)[:nodes])
    np.testing.assert_array_equal(np.asarray(by_vertex)[k, :num], np.asarray(by_own)[:num])
print("same bits")
"""


@pytest.mark.system
def test_padding_and_company_change_no_bit(tmp_path):
    """Of values and slopes: in a batch, and alone, padded to twice as much."""
    curves = [curve(name)[::2] for name in ("tube", "y")]
    assert "same bits" in in_process(tmp_path, BITS, curves)


def test_curves_of_a_capacity_share_a_program(batch, compilations, monkeypatch):
    """Another curve of the same mesh, pruned and resampled; and a second batch that takes the capacity of the first,
    though its largest mesh is smaller."""
    vertices, _, skeleton = curve("y")
    other, tube = skeleton.resample(0.2), curve("tube")[2]
    assert other.binding.capacity == skeleton.binding.capacity and len(other.vertices) != len(skeleton.vertices)
    for name, capacity in (("vertices", 256), ("faces", 640)):  # so that the tube has another capacity than the limbs
        monkeypatch.setitem(SMALLEST_SIZES, name, capacity)
    second = msf_jax.stack([tube, tube], like=batch)
    together = jax.jit(jax.vmap(msf_jax.follow))
    together(batch.bindings, batch.vertices)
    msf_jax.follow(skeleton, vertices)
    compilations.clear()
    msf_jax.follow(other, vertices)
    msf_jax.follow(other.binding, vertices)
    msf_jax.follow(padded(unpadded(tube.binding), skeleton.binding.capacity), curve("tube")[0])
    found = together(second.bindings, second.vertices)
    assert not compilations
    for nodes, _ in second.unstack(found):
        np.testing.assert_allclose(nodes, tube.vertices, rtol=0, atol=1e-12)
    assert msf_jax.stack([tube]).vertices.shape[1] < second.vertices.shape[1]


def test_a_capacity_has_room_for_what_is_asked_and_for_padding():
    """A mesh of twice the vertices is one step up: meshes of 500 to 12,000 vertices have five capacities."""
    sizes = unpadded(curve("y")[2].binding).live
    capacity = capacity_for(sizes)
    assert all(one >= other for one, other in zip(capacity, sizes, strict=True)) and capacity.nodes > sizes.nodes
    many = {capacity_for(sizes._replace(vertices=num, faces=2 * num)).vertices for num in range(500, 12_001, 7)}
    assert many == {1024, 2048, 4096, 8192, 16384}


@pytest.mark.parametrize("dtype", [np.float32, np.float64, np.float16, np.int32])
def test_numbers_stay_what_they_are(tube, dtype):
    """float32 in, float32 out, though x64 is on; less is float32, whole numbers are float64, as everywhere in JAX."""
    vertices, _, skeleton = tube
    expected = {np.float16: np.float32, np.int32: np.float64}.get(dtype, dtype)
    given = (100 * vertices).astype(dtype)
    for followed in (skeleton, skeleton.binding):
        assert {part.dtype for part in msf_jax.follow(followed, given)} == {np.dtype(expected)}
    with jax.transfer_guard("disallow"):  # no implicit copies to a device
        nodes = np.asarray(jax.device_get(msf_jax.follow(skeleton, given).nodes))
    close = 1 if dtype in (np.float16, np.int32) else 2e-3 if dtype == np.float32 else 1e-10
    np.testing.assert_allclose(nodes, 100 * skeleton.vertices, rtol=0, atol=close)


def test_through_jax_and_files(tube, batch, compilations, tmp_path):
    """A binding, a batch and a skeleton through jit, tree.map, pickle, and a file of leaves, and back."""
    vertices, _, skeleton = tube
    for tree in (skeleton.binding, batch, skeleton):
        leaves, structure = jax.tree.flatten(tree)
        np.savez(tmp_path / "leaves.npz", *leaves)  # as Equinox and Orbax write trees
        with np.load(tmp_path / "leaves.npz") as file:
            read = jax.tree.unflatten(structure, list(file.values()))
        copies = jax.jit(lambda tree: tree)(tree), jax.tree.map(jnp.asarray, tree), pickle.loads(pickle.dumps(tree))
        for back in (*copies, read):
            assert tree is skeleton or jax.tree.structure(back) == structure
            for one, other in zip(jax.tree.leaves(back), leaves, strict=True):
                np.testing.assert_array_equal(one, other)
                assert one.dtype == other.dtype
    nodes = jax.jit(lambda skeleton, vertices: msf_jax.follow(skeleton, vertices).nodes)
    np.testing.assert_allclose(nodes(skeleton, vertices), skeleton.vertices, rtol=0, atol=1e-12)
    back = jax.tree.map(np.copy, skeleton)
    assert back.report == skeleton.report and back.prune(90.0).length <= skeleton.length
    compilations.clear()
    nodes(back, vertices)
    assert not compilations


# Bad input


@pytest.mark.parametrize(
    ("given", "says"),
    [
        (lambda v: v[:-1], r"shape \(\d+, 3\): expected"),
        (lambda v: np.where(np.arange(len(v))[:, None] == 5, np.nan, v), "1 of the vertices, the first 5, are not"),
        (lambda v: "hand.off", "expected an array of real numbers"),
        (lambda v: v + 1j, "the type complex128: expected real"),
        (lambda v: np.zeros((10_000, 3)), r"shape \(10000, 3\): expected"),
    ],
)
def test_bad_vertices_are_refused(limbs, given, says):
    """With a skeleton and with its binding, whose padding may be left out."""
    vertices, _, skeleton = limbs
    for followed in (skeleton, skeleton.binding):
        with pytest.raises(MeshError, match=says):
            msf_jax.follow(followed, given(vertices))
    with pytest.raises(MeshError, match="as in the mesh of the skeleton"):
        jax.jit(lambda moved: msf_jax.follow(skeleton.binding, moved).nodes)(vertices[:5])


def test_a_curve_without_its_mesh_and_what_is_no_curve_are_refused(limbs, tmp_path):
    vertices, _, skeleton = limbs
    skeleton.save(tmp_path / "y.swc")
    bare = msf_jax.read_curve(tmp_path / "y.swc")
    for ask in (
        lambda: msf_jax.follow(bare, vertices),
        bare.jacobian,
        lambda: msf_jax.track(bare, [vertices]),
        lambda: msf_jax.stack([bare]),
    ):
        with pytest.raises(ConfigError, match="does not know the mesh that it was made from"):
            ask()
    with pytest.raises(ConfigError, match="skeleton is a ndarray"):
        msf_jax.follow(vertices, vertices)  # pyright: ignore[reportArgumentType]
    for given, says in (([], "a list of nothing"), ([skeleton, vertices], "of Skeleton, nd"), (skeleton, "a Skeleton")):
        with pytest.raises(ConfigError, match=f"skeletons is .*{says}"):
            msf_jax.stack(given)
    with pytest.raises(ConfigError, match="like is a Skeleton"):
        msf_jax.stack([skeleton], like=skeleton)  # pyright: ignore[reportArgumentType]
    for sigma, says in ((-1.0, "negative"), ([1.0, 2.0], "shape")):
        with pytest.raises(ConfigError, match=says):
            skeleton.covariance(sigma)
