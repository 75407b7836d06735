"""Following: the recorded curve at the recorded mesh, affine maps carried along, closed forms, slopes, bad input."""

import functools
import importlib

import jax
import numpy as np
import pytest
import trimesh
from conftest import blob, torus
from device_cases import strict
from run_cases import flow_of
from scipy.spatial.transform import Rotation

import msf_jax
from msf_jax import ConfigError, MeshError
from msf_jax.solid.solid import Solid
from tests.benchmarks import ground_truth

KNOWN = {"y": "y_coarse", "tube": "straight_coarse"}


@functools.cache
def curve(name):
    """A mesh and its curve."""
    if name in KNOWN:
        mesh, skeleton = ground_truth.make(KNOWN[name]).mesh, flow_of(KNOWN[name]).skeleton
    else:
        mesh = trimesh.util.concatenate([blob(4, 2), torus().apply_translation([1.5, 0, 0])])
        skeleton = msf_jax.skeletonize(mesh)
    return np.array(mesh.vertices), np.array(mesh.faces), skeleton


@pytest.fixture(scope="module", params=["y", "two"])
def shape(request):
    return curve(request.param)


@pytest.fixture(scope="module")
def limbs():
    """The mesh of three limbs, and its curve."""
    return curve("y")


@pytest.fixture(scope="module")
def tube():
    """That of a short straight one."""
    return curve("tube")


@pytest.fixture(scope="module")
def beam():
    """A square beam of 12 x 2 x 2 along x, and its curve."""
    mesh = trimesh.creation.box([12, 2, 2])
    while len(mesh.vertices) < 300:
        mesh = mesh.subdivide()
    return np.array(mesh.vertices), np.array(mesh.faces), msf_jax.skeletonize(mesh)


def diagonal(vertices):
    return float(np.linalg.norm(np.ptp(vertices, axis=0)))


def turn_by(angle):
    return Rotation.from_rotvec(angle * np.array([0.5, -0.6, 0.6])).as_matrix()


def test_at_the_recorded_mesh_it_is_the_recorded_curve(shape):
    vertices, _, skeleton = shape
    nodes, radii = msf_jax.follow(skeleton, vertices)
    np.testing.assert_allclose(nodes, skeleton.vertices, rtol=0, atol=1e-12 * diagonal(vertices))
    np.testing.assert_allclose(radii, skeleton.radii, rtol=0, atol=1e-12 * diagonal(vertices))


def test_an_affine_map_of_the_mesh_maps_the_curve(shape):
    """Turned, stretched, sheared and moved far away, made small; and turned, radii are as they were."""
    vertices, _, skeleton = shape
    random = np.random.default_rng(2)
    turn = turn_by(0.9)
    shear = np.eye(3) + 0.3 * random.normal(size=(3, 3))
    for matrix, shift in ((turn, 0.0), (3.0 * turn, 70.0), (1e-3 * turn, 0.0), (shear, -5.0)):
        nodes, radii = msf_jax.follow(skeleton, vertices @ matrix.T + shift)
        expected = skeleton.vertices @ matrix.T + shift
        np.testing.assert_allclose(nodes, expected, rtol=0, atol=1e-9 * diagonal(vertices))
        if matrix is not shear:
            size = np.linalg.norm(matrix[0])
            np.testing.assert_allclose(radii, size * skeleton.radii, rtol=0, atol=1e-9 * diagonal(vertices))


@pytest.mark.parametrize("scale", [(1, 0.2, 1), (0.2, 1, 1), (3, 1, 0.3)])
def test_radii_are_exact_in_a_mesh_that_is_squashed(limbs, scale):
    """Other walls are nearest there than were at first."""
    vertices, faces, skeleton = limbs
    moved = vertices * scale
    nodes, radii = msf_jax.follow(skeleton, moved)
    np.testing.assert_allclose(radii, Solid(moved, faces).radii(np.asarray(nodes)), rtol=0, atol=1e-12)


def test_a_node_that_leaves_the_mesh_has_a_negative_radius(limbs):
    """A bump is pressed in, past the nodes of a limb: distance and side are those of the solid as it is then."""
    vertices, faces, skeleton = limbs
    leaf = int(np.flatnonzero(np.bincount(skeleton.edges.ravel()) == 1)[0])
    path = next(branch.nodes for branch in skeleton.branches if leaf in (branch.nodes[0], branch.nodes[-1]))
    middle, along = skeleton.vertices[path[len(path) // 2]], skeleton.vertices[path[-1]] - skeleton.vertices[path[0]]
    side = np.cross(along, [0.3, 0.5, 0.8])
    side /= np.linalg.norm(side)
    away = vertices - middle
    bump = (
        np.exp(-(((away @ along) / (along @ along) / 0.12) ** 2))
        * (away @ side > 0)
        * (np.linalg.norm(away, axis=1) < 1.5)
    )
    moved = vertices - (bump * 1.9 * np.maximum(away @ side, 0))[:, None] * side
    nodes, radii = map(np.asarray, msf_jax.follow(skeleton, moved))
    solid = Solid(moved, faces)
    winding = solid.shape.winding_numbers(solid.enter(nodes))
    assert (winding == 0).any() and set(winding) <= {0, 1}
    expected = solid.diagonal * solid.shape.distances(solid.enter(nodes)) * np.where(winding > 0, 1, -1)
    np.testing.assert_allclose(radii, expected, rtol=0, atol=1e-12)


def middle(skeleton):
    """Nodes that are far from the beam's ends."""
    return np.abs(skeleton.vertices[:, 0]) < 3.5


def test_a_beam_that_is_bent_has_its_nodes_on_the_arc(beam):
    """Every plane across the beam turns about an axis: its middle goes to a circle whose length is the beam's."""
    vertices, faces, skeleton = beam
    curvature = np.radians(60) / 12

    def bent(points):
        x, y, z = points.T
        angle = curvature * x
        return np.stack([(1 / curvature - y) * np.sin(angle), (y - 1 / curvature) * np.cos(angle), z], axis=1)

    nodes, radii = msf_jax.follow(skeleton, bent(vertices))
    np.testing.assert_allclose(nodes, bent(skeleton.vertices), rtol=0, atol=0.05)
    still = np.linalg.norm(bent(skeleton.vertices) - skeleton.vertices - [0, 1 / curvature, 0], axis=1)
    assert np.abs(still).max() > 0.5  # it was a bend to speak of
    np.testing.assert_allclose(radii, Solid(bent(vertices), faces).radii(np.asarray(nodes)), atol=1e-10)


def test_a_beam_that_is_stretched_unevenly_takes_its_nodes_along(beam):
    vertices, _, skeleton = beam
    moved, expected = vertices.copy(), skeleton.vertices.copy()
    for points in (moved, expected):
        points[:, 0] += 0.5 * np.sin(0.5 * points[:, 0])
    nodes, _ = msf_jax.follow(skeleton, moved)
    np.testing.assert_allclose(np.asarray(nodes)[middle(skeleton)], expected[middle(skeleton)], rtol=0, atol=0.06)


def test_a_node_is_in_the_middle_of_the_area_of_its_section(beam):
    """One of the four long edges is pulled out: the centroid of the new quadrangle, by its two triangles."""
    vertices, _, skeleton = beam
    moved = vertices.copy()
    is_edge = (vertices[:, 1] == 1) & (vertices[:, 2] == 1)
    moved[is_edge, 1:] += 1.0
    corners = np.array([[-1, -1], [1, -1], [2, 2], [-1, 1.0]])
    # Between the edge and its neighbours the sides of the beam are not flat: vertices in them stay.
    is_side = ((vertices[:, 1] == 1) | (vertices[:, 2] == 1)) & ~is_edge
    along = np.where(vertices[:, 1] == 1, vertices[:, 2], vertices[:, 1])
    for axis, fixed in ((1, vertices[:, 1] == 1), (2, vertices[:, 2] == 1)):
        side = is_side & fixed
        share = (along[side] + 1) / 2
        moved[side, axis] = 1 + share
        moved[side, 3 - axis] = -1 + 3 * share
    one, other = corners[[0, 1, 2]], corners[[0, 2, 3]]
    area = [np.linalg.det(part[1:] - part[0]) / 2 for part in (one, other)]
    expected = (area[0] * one.mean(axis=0) + area[1] * other.mean(axis=0)) / sum(area)
    nodes, _ = msf_jax.follow(skeleton, moved)
    found = np.asarray(nodes)[middle(skeleton), 1:]
    np.testing.assert_allclose(found, np.broadcast_to(expected, found.shape), rtol=0, atol=0.01)
    assert np.linalg.norm(corners.mean(axis=0) - expected) > 0.05  # which is not the mean of the corners


@pytest.fixture(scope="module")
def pull(limbs):
    """The gradient (V, 3) of a sum over nodes and radii with weights, compiled once."""
    return jax.jit(lambda moved, *back: jax.vjp(lambda v: tuple(msf_jax.follow(limbs[2], v)), moved)[1](back)[0])


@pytest.fixture(scope="module")
def push(limbs):
    """Nodes (N, 3), and how they move with the vertices, compiled once."""
    return jax.jit(
        lambda moved, direction: jax.jvp(lambda v: msf_jax.follow(limbs[2], v).nodes, (moved,), (direction,))
    )


def test_slopes_are_those_of_central_differences(limbs, pull):
    """Radii have kinks where another triangle becomes the nearest: for them all vertices together go one step. Nodes on
    the axis of a limb, up to its end, are as near to many triangles."""
    vertices, _, skeleton = limbs
    target = np.random.default_rng(5).normal(size=skeleton.vertices.shape)

    def values(moved):
        nodes, radii = msf_jax.follow(skeleton, moved)
        return np.array([(nodes * target).sum(), (radii**2).sum()])

    slopes = pull(vertices, target, 0 * skeleton.radii), pull(vertices, 0 * target, 2 * skeleton.radii)
    for step, tolerances in ((1e-6, [1e-4, 1e-4]), (1e-4, [1e-3, 0.05])):
        random = np.random.default_rng(0).normal(size=vertices.shape)
        for k, direction in enumerate([random, random / np.linalg.norm(random)]):
            h = step * diagonal(vertices)
            central = (values(vertices + h * direction) - values(vertices - h * direction))[k] / (2 * h)
            size = np.linalg.norm(slopes[k]) * np.linalg.norm(direction) / np.sqrt(vertices.size)
            assert abs(central - (slopes[k] * direction).sum()) < tolerances[k] * size


def test_the_jacobian_is_that_of_both_modes(limbs, pull, push):
    """And a mesh that is moved as a whole moves every node as far."""
    vertices, _, skeleton = limbs
    jacobian = skeleton.jacobian()
    num = len(skeleton.vertices)
    assert jacobian.shape == (3 * num, vertices.size)
    random = np.random.default_rng(1)
    direction, back = random.normal(size=vertices.shape), random.normal(size=(num, 3))
    forward = push(vertices, direction)[1]
    np.testing.assert_allclose((jacobian @ direction.ravel()).reshape(-1, 3), forward, rtol=1e-9, atol=1e-9)
    reverse = pull(vertices, back, np.zeros(num))
    np.testing.assert_allclose((jacobian.T @ back.ravel()).reshape(-1, 3), reverse, rtol=1e-9, atol=1e-9)
    shift = np.array([0.3, -2.0, 0.7])
    moved = jacobian @ np.tile(shift, len(vertices))
    np.testing.assert_allclose(moved.reshape(-1, 3), np.tile(shift, (num, 1)), atol=1e-9)
    turning = np.cross(shift, vertices)  # an infinitesimal turn about the origin
    turned = (jacobian @ turning.ravel()).reshape(-1, 3)
    np.testing.assert_allclose(turned, np.cross(shift, skeleton.vertices), atol=1e-9)


@pytest.mark.slow  # slopes are those of central differences above
def test_noise_moves_nodes_less_than_vertices_and_as_the_covariance_says(tube):
    """Many noisy meshes at once, by `jax.vmap`."""
    vertices, _, skeleton = tube
    sigma = 1e-4 * diagonal(vertices)
    noise = np.random.default_rng(0).normal(0, sigma, (500, *vertices.shape))
    nodes = jax.jit(jax.vmap(lambda moved: msf_jax.follow(skeleton, moved).nodes))(vertices + noise)
    away = np.asarray(nodes) - skeleton.vertices
    assert np.sqrt((away**2).sum(axis=2).mean()) < 0.5 * np.sqrt(3) * sigma
    measured = np.einsum("mni,mnj->nij", away, away) / len(noise)
    expected = skeleton.covariance(sigma)
    size = np.trace(expected, axis1=1, axis2=2)
    assert (np.abs(measured - expected) < 0.2 * size[:, None, None]).all()
    np.testing.assert_array_less(0, size)


def test_covariance_of_one_noisy_vertex_is_its_block_of_the_jacobian(limbs):
    vertices, _, skeleton = limbs
    sigma = np.zeros(len(vertices))
    sigma[17] = 0.5
    block = skeleton.jacobian().toarray()[:, 51:54].reshape(-1, 3, 3)
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
    moved = vertices + 0.05 * np.sin(3 * vertices[:, [1, 2, 0]])
    nodes = msf_jax.follow(read, moved).nodes
    np.testing.assert_array_equal(nodes, msf_jax.follow(changed, moved).nodes)  # a file has the mesh to the last bit
    assert read.report == changed.report
    np.testing.assert_array_equal(read.prune(90.0).edges, changed.prune(90.0).edges)
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
    moved = vertices + np.random.default_rng(0).normal(0, 0.01, vertices.shape)
    nodes, _ = msf_jax.follow(skeleton, np.concatenate([moved[faces.ravel()], [[np.nan] * 3]]))
    np.testing.assert_allclose(nodes[skeleton.mesh_map[pin]], moved[top], atol=1e-12)


def crushed(vertices, skeleton):
    """The mesh with the limb of its first leaf crushed to a line, and a node of that limb."""
    leaf = int(np.flatnonzero(np.bincount(skeleton.edges.ravel()) == 1)[0])
    node = int(skeleton.edges[(skeleton.edges == leaf).any(axis=1)].sum() - leaf)
    centre = skeleton.vertices[node]
    moved = vertices.copy()
    moved[np.linalg.norm(vertices - centre, axis=1) < 0.3] = centre
    return moved, node


def test_a_section_that_vanished_is_named(limbs, push):
    vertices, _, skeleton = limbs
    moved, node = crushed(vertices, skeleton)
    with pytest.raises(MeshError, match=r"the sections of \d+ nodes, the first \d+, have vanished"):
        msf_jax.follow(skeleton, moved)
    nodes, _ = push(moved, moved)
    is_gone = np.isnan(np.asarray(nodes)[:, 0])
    assert is_gone[node] and not is_gone.all()


@pytest.mark.parametrize(
    ("given", "says"),
    [
        (lambda v: v[:-1], r"shape \(\d+, 3\): expected"),
        (lambda v: np.where(np.arange(len(v))[:, None] == 5, np.nan, v), "1 of the vertices, the first 5, are not"),
        (lambda v: "hand.off", "expected an array of numbers"),
        (lambda v: v + 1j, "the type complex128: expected real"),
    ],
)
def test_bad_vertices_are_refused(limbs, given, says):
    vertices, _, skeleton = limbs
    with pytest.raises(MeshError, match=says):
        msf_jax.follow(skeleton, given(vertices))


def test_a_curve_without_its_mesh_is_refused(limbs, tmp_path):
    vertices, _, skeleton = limbs
    skeleton.save(tmp_path / "y.swc")
    bare = msf_jax.read_curve(tmp_path / "y.swc")
    for ask in (lambda: msf_jax.follow(bare, vertices), bare.jacobian, lambda: msf_jax.track(bare, [vertices])):
        with pytest.raises(ConfigError, match="does not know the mesh that it was made from"):
            ask()
    with pytest.raises(ConfigError, match="skeleton is a ndarray"):
        msf_jax.follow(vertices, vertices)  # pyright: ignore[reportArgumentType]


@pytest.mark.parametrize(("sigma", "says"), [(-1.0, "negative"), ([1.0, 2.0], "shape"), ("loud", "is a str")])
def test_noise_that_is_none_is_refused(limbs, sigma, says):
    with pytest.raises(ConfigError, match=says):
        limbs[2].covariance(sigma)


def test_a_capacity_over_the_limit_does_not_make_every_program_again(monkeypatch):
    """In rounds, where the one that was used longest ago is always the next."""
    module = importlib.import_module("msf_jax.gradients.follow")
    monkeypatch.setattr(module, "_programs", {})
    num, made = module.MOST_PROGRAMS + 1, []
    for _ in range(20):
        before = dict(module._programs)
        found = {key: module._program(key) for key in range(num)}
        made.append(sum(before.get(key) is not program for key, program in found.items()))
        assert len(module._programs) == module.MOST_PROGRAMS
    assert made[0] == num and np.mean(made[1:]) < num / 3


@pytest.mark.slow  # so does an iteration, in test_contraction
@pytest.mark.parametrize("mode", ["dtypes and ranks", "transfers"])
def test_it_works_in_the_strict_modes_of_jax(limbs, mode):
    """With the type of the vertices, float32, and without implicit copies to the device."""
    vertices, _, skeleton = limbs
    array = jax.device_put(vertices.astype(np.float32))
    modes = {"dtypes and ranks": strict(), "transfers": jax.transfer_guard("disallow")}
    slope = jax.jit(jax.grad(lambda array: msf_jax.follow(skeleton, array).nodes.sum()))
    with modes[mode]:
        for given in (array, vertices.astype(np.float32)):
            assert msf_jax.follow(skeleton, given).nodes.dtype == np.float32
        if mode != "transfers":  # compiling copies constants
            jax.eval_shape(slope, array)
