"""Following: the recorded curve at the recorded mesh, affine maps carried along, closed forms, batches, bad input.
Its derivatives are in test_transformations."""

import functools
import importlib.util
import pickle

import jax
import jax.numpy as jnp
import numpy as np
import pytest
import trimesh
from conftest import blob, torus
from device_cases import quick_jit
from jax import export
from run_cases import flow_of
from scipy.spatial.transform import Rotation
from test_transformations import in_process

import msf_jax
from msf_jax import ConfigError, MeshError, losses
from msf_jax.base.binding import capacity_for, unpadded
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
    changed = skeleton.prune(50.0).resample(0.1)
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
    """In padding there is nothing."""
    assert str(batch).startswith("Binding(2 curves, capacity of")
    found = jax.jit(msf_jax.follow)(batch, moved(batch.vertices))
    nodes, radii, at = batch.split(found.nodes), batch.split(found.radii), batch.split(batch.vertices, "vertices")
    for k, name in enumerate(("tube", "y")):
        vertices, _, skeleton = curve(name)
        np.testing.assert_allclose(at[k], vertices, rtol=0, atol=1e-14)
        for part, other in zip((nodes[k], radii[k]), msf_jax.follow(skeleton, moved(vertices)), strict=True):
            np.testing.assert_allclose(part, other, rtol=0, atol=1e-13)
        assert (batch.mesh_of("nodes") == k)[batch.node_mask].sum() == len(skeleton.vertices)
    assert not np.asarray(batch.vertices)[~batch.vertex_mask].any()
    for part in found:
        assert not np.asarray(part)[~batch.node_mask].any()


BITS = """
import pickle, sys
import jax, numpy as np
jax.config.update("jax_enable_x64", True)
import msf_jax
from msf_jax.base.binding import padded, unpadded
import test_follow as cases

curves = pickle.load(open(sys.argv[1], "rb"))
batch = msf_jax.stack([skeleton for _, skeleton in curves])
split = lambda values, kind="nodes": batch.split(values, kind)
everywhere = jax.numpy.asarray(cases.moved(batch.vertices))

def value(binding, vertices):  # linear in the nodes: powers of them are rounded by how many there are
    found = msf_jax.follow(binding, vertices)
    before = jax.numpy.cumsum(binding.live.nodes) - binding.live.nodes
    row = jax.numpy.arange(len(found.radii)) - before[binding.mesh_of("nodes")]
    factor = jax.numpy.cos(row.astype(found.radii.dtype))
    whole = (factor[:, None] * found.nodes * np.array([1.0, 0.7, -0.4])).sum() + (factor * found.radii ** 2).sum()
    return whole, found

slope = jax.jit(jax.value_and_grad(value, argnums=1, has_aux=True))
(_, found), by_vertex = slope(batch, everywhere)
large = padded(unpadded(batch), type(batch.live)(*(2 * most for most in batch.capacity)))  # a program of its own
for k, (vertices, skeleton) in enumerate(curves):
    binding = msf_jax.stack([skeleton]).like(large)
    rows = np.zeros((binding.capacity.vertices, 3))
    rows[: len(vertices)] = split(everywhere, "vertices")[k]
    (_, alone), by_own = slope(binding, rows)
    for one, other in zip(found, alone):
        np.testing.assert_array_equal(split(one)[k], binding.split(other)[0])
    np.testing.assert_array_equal(split(by_vertex, "vertices")[k], binding.split(by_own, "vertices")[0])
print("same bits")
"""


@pytest.mark.system
def test_padding_and_company_change_no_bit(tmp_path):
    """Of values and slopes: in a batch, and alone, padded to twice as much."""
    curves = [curve(name)[::2] for name in ("tube", "y")]
    assert "same bits" in in_process(tmp_path, BITS, curves)


def test_what_is_like_another_shares_its_programs(batch, compilations):
    """Another curve of the same mesh, resampled; and a batch of fewer meshes, whose padding says so."""
    vertices, _, skeleton = curve("y")
    tube, other = curve("tube")[2], skeleton.resample(0.2)
    compiled = jax.jit(msf_jax.follow)
    compiled(batch, batch.vertices)
    msf_jax.follow(skeleton.binding, vertices)
    second = msf_jax.stack([tube]).like(batch)
    compilations.clear()
    assert len(other.vertices) != len(skeleton.vertices)
    of_other = msf_jax.follow(other.binding.like(skeleton.binding), vertices)
    found = compiled(second, second.vertices)
    assert not compilations
    np.testing.assert_allclose(of_other.nodes[: len(other.vertices)], other.vertices, rtol=0, atol=1e-12)
    assert second.mesh_mask.tolist() == [True, False] and second.capacity == batch.capacity
    (nodes,) = second.split(found.nodes)
    np.testing.assert_allclose(nodes, tube.vertices, rtol=0, atol=1e-12)
    with pytest.raises(ConfigError, match=r"needs 948 vertices in a capacity of 128, .*fits into the other"):
        skeleton.binding.like(tube.binding)
    with pytest.raises(ConfigError, match="needs 2 meshes in a capacity of 1,"):
        batch.like(skeleton.binding)


def test_a_capacity_has_room_for_what_is_asked_and_for_padding():
    """And is at most by the square root of two more, in each field by itself."""
    sizes = unpadded(curve("y")[2].binding).live
    assert capacity_for(sizes).nodes > sizes.nodes
    for num in range(100, 12_001, 7):
        capacity = capacity_for(sizes._replace(vertices=num, turning=9 * num))
        assert num <= capacity.vertices <= 1.4143 * num and 9 * num <= capacity.turning <= 1.4143 * 9 * num
        assert capacity.corners == capacity_for(sizes).corners


def test_a_binding_is_data_and_no_parameter(batch):
    """Its gradient is 0, also where it is a part of a model; and it can be exported as an argument."""
    skeleton = curve("tube")[2]

    def value(binding):
        found = msf_jax.follow(binding, skeleton.binding.vertices)
        return (found.nodes**2).sum() + (found.radii**2).sum() + losses.near(found, binding, np.ones((3, 3)))

    slopes = quick_jit(jax.grad(value, allow_int=True))(skeleton.binding)
    assert not any(np.any(part) for part in jax.tree.leaves(slopes) if part.dtype != jax.dtypes.float0)
    exported = export.export(jax.jit(msf_jax.follow))(batch, batch.vertices)
    again = export.deserialize(exported.serialize()) if importlib.util.find_spec("flatbuffers") else exported
    np.testing.assert_array_equal(
        again.call(batch, batch.vertices).nodes, jax.jit(msf_jax.follow)(batch, batch.vertices).nodes
    )


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


def test_through_jax_and_files(tube, batch, tmp_path):
    """A binding and a batch through jit, tree.map, pickle, and a file of leaves, and back."""
    vertices, _, skeleton = tube
    for tree in (skeleton.binding, batch):
        leaves, structure = jax.tree.flatten(tree)
        np.savez(tmp_path / "leaves.npz", *leaves)  # as Equinox and Orbax write trees
        with np.load(tmp_path / "leaves.npz") as file:
            read = jax.tree.unflatten(structure, list(file.values()))
        copies = jax.jit(lambda tree: tree)(tree), jax.tree.map(jnp.asarray, tree), pickle.loads(pickle.dumps(tree))
        for back in (*copies, read):
            assert jax.tree.structure(back) == structure
            for one, other in zip(jax.tree.leaves(back), leaves, strict=True):
                np.testing.assert_array_equal(one, other)
                assert one.dtype == other.dtype
    back = pickle.loads(pickle.dumps(skeleton.prune(0.1)))  # with its limbs
    np.testing.assert_allclose(msf_jax.follow(back, vertices).nodes, skeleton.vertices, rtol=0, atol=1e-12)


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
    for wrong in (vertices, vertices[:5]):  # a traced binding does not say how many rows are padding
        with pytest.raises(MeshError, match=r"expected \(1024, 3\), .* and its padding, as binding\.vertices"):
            jax.jit(msf_jax.follow)(skeleton.binding, wrong)


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
    with pytest.raises(ConfigError, match="others are Skeleton"):
        skeleton.binding.like(skeleton)
    for sigma, says in ((-1.0, "negative"), ([1.0, 2.0], "shape")):
        with pytest.raises(ConfigError, match=says):
            skeleton.covariance(sigma)
