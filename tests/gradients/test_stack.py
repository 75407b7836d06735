"""Curves in batches: what pads changes no bit and has no gradient; one program for a capacity; dtypes;
transformations of JAX."""

import os
import pickle
import subprocess
import sys
from functools import partial
from pathlib import Path

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from run_cases import flow_of

import msf_jax
from msf_jax import ConfigError, MeshError
from msf_jax.base.binding import SMALLEST_SIZES, capacity_for, padded, unpadded
from tests.benchmarks import ground_truth

NAMES = ("straight_coarse", "y_coarse")


@pytest.fixture(scope="module")
def curves():
    """A tube and three limbs, 128 and 948 vertices: positions and curve of each."""
    return [(np.array(ground_truth.make(name).mesh.vertices), flow_of(name).skeleton) for name in NAMES]


@pytest.fixture(scope="module")
def batch(curves):
    return msf_jax.stack([skeleton for _, skeleton in curves])


def moved(vertices, amount=0.05):
    """Smoothly, and not the same everywhere; rows that pad move, too."""
    return vertices + amount * np.sin(2 * np.asarray(vertices)[..., [1, 2, 0]] + 0.3)


def weight_of(found):
    """A number that all nodes and radii have a part in, each another one."""
    nodes, radii = found
    factor = jnp.cos(jnp.arange(len(radii), dtype=nodes.dtype))
    return (factor[:, None] * nodes * jnp.array([1.0, 0.7, -0.4], nodes.dtype)).sum() + (factor * radii**2).sum()


def weighed(binding, vertices):
    return weight_of(msf_jax.follow(binding, vertices))


every_follow = jax.jit(jax.vmap(msf_jax.follow))
slopes = jax.jit(jax.vmap(jax.value_and_grad(weighed, argnums=1)))
slope = jax.jit(jax.value_and_grad(weighed, argnums=1))


def test_a_batch_has_capacity_for_all_and_masks_for_each(curves, batch):
    assert len(batch) == 2 and batch.vertices.shape == (2, 1024, 3) and batch.node_mask.shape == (2, 320)
    for k, (vertices, skeleton) in enumerate(curves):
        assert batch.vertex_mask[k].sum() == len(vertices) and batch.node_mask[k].sum() == len(skeleton.vertices)
        np.testing.assert_allclose(batch.vertices[k][np.asarray(batch.vertex_mask[k])], vertices, rtol=0, atol=1e-14)
        assert not np.asarray(batch.vertices)[k][~np.asarray(batch.vertex_mask)[k]].any()
    assert repr(batch) == "Batch(2 curves, 320 rows of nodes, 1024 of vertices)"
    assert repr(batch.bindings).startswith("Binding(2 curves, capacity of 320 nodes and 1024")


def test_every_curve_of_a_batch_is_what_it_is_alone(curves, batch):
    """Nodes, radii, and their gradients; in padding there is nothing."""
    everywhere = jnp.asarray(moved(batch.vertices))
    found = every_follow(batch.bindings, everywhere)
    values, by_vertex = slopes(batch.bindings, everywhere)
    one_by_one = batch.unstack(found)
    for k, (vertices, skeleton) in enumerate(curves):
        alone = msf_jax.follow(skeleton, moved(vertices))
        for part, other in zip(one_by_one[k], alone, strict=True):
            np.testing.assert_allclose(part, other, rtol=0, atol=1e-13)
        rows = np.zeros((skeleton.binding.num_vertices, 3))
        rows[: len(vertices)] = moved(vertices)
        value, by_own = slope(skeleton.binding, rows)
        np.testing.assert_allclose(values[k], value, rtol=1e-12)
        np.testing.assert_allclose(by_vertex[k, : len(vertices)], by_own[: len(vertices)], rtol=0, atol=1e-12)
        assert np.abs(by_own).max() > 1e-2
    for padding in (np.asarray(found.nodes)[~batch.node_mask], np.asarray(found.radii)[~batch.node_mask]):
        assert not padding.any()
    assert not np.asarray(by_vertex)[~np.asarray(batch.vertex_mask)].any()


BITS = """
import sys, pickle, hashlib
import jax, numpy as np
jax.config.update("jax_enable_x64", True)
import msf_jax
from msf_jax.base.binding import padded, unpadded
import test_stack as cases

curves = pickle.load(open(sys.argv[1], "rb"))
batch = msf_jax.stack([skeleton for _, skeleton in curves])
everywhere = jax.numpy.asarray(cases.moved(batch.vertices))

def weighed(binding, vertices):
    found = msf_jax.follow(binding, vertices)
    return cases.weight_of(found), found

slope = jax.value_and_grad(weighed, argnums=1, has_aux=True)
(_, found), by_vertex = jax.jit(jax.vmap(slope))(batch.bindings, everywhere)
slope = jax.jit(slope)
for k, (vertices, skeleton) in enumerate(curves):
    own = unpadded(skeleton.binding)
    shared = batch.bindings.capacity._asdict()  # one program for both
    twice = own.live._replace(**{name: 2 * capacity for name, capacity in shared.items()})
    num, nodes = len(vertices), len(skeleton.vertices)
    binding = padded(own, twice)
    rows = np.zeros((binding.num_vertices, 3))
    rows[:num] = everywhere[k, :num]
    (_, alone), by_own = slope(binding, rows)
    for one, other in ((found.nodes, alone.nodes), (found.radii, alone.radii)):
        np.testing.assert_array_equal(np.asarray(one)[k, :nodes], np.asarray(other)[:nodes])
    np.testing.assert_array_equal(np.asarray(by_vertex)[k, :num], np.asarray(by_own)[:num])
print("same bits")
"""


@pytest.mark.system
def test_padding_and_company_change_no_bit(curves, tmp_path):
    """In a process whose programs are optimised as a user's are: in a batch, and alone, padded to twice as much."""
    with open(tmp_path / "curves.pkl", "wb") as file:
        pickle.dump(curves, file)
    (tmp_path / "bits.py").write_text(BITS)
    done = _in_process(tmp_path / "bits.py", str(tmp_path / "curves.pkl"))
    assert "same bits" in done


def _in_process(script, *arguments, **variables):
    """What ``script`` writes, in a process that imports this folder's modules and optimises what it compiles."""
    tests = Path(__file__).parents[1]
    inherited = {name: value for name, value in os.environ.items() if name not in ("XLA_FLAGS",)}
    path = os.pathsep.join(map(str, (tests.parent, tests, Path(__file__).parent)))
    names = {"PYTHONPATH": path, **variables}
    command = [sys.executable, str(script), *arguments]
    done = subprocess.run(command, env=inherited | names, capture_output=True, text=True, timeout=600)
    assert done.returncode == 0, done.stderr[-3000:]
    return done.stdout


def test_gradients_in_a_batch_are_those_of_central_differences(batch):
    vertices = jnp.asarray(moved(batch.vertices))
    direction = np.random.default_rng(3).normal(size=vertices.shape)
    direction /= np.linalg.norm(direction, axis=(1, 2), keepdims=True)
    by_vertex = np.asarray(slopes(batch.bindings, vertices)[1])
    step = 1e-5
    ahead, behind = (np.asarray(slopes(batch.bindings, vertices + sign * step * direction)[0]) for sign in (1, -1))
    expected = (by_vertex * direction).sum(axis=(1, 2))
    size = np.linalg.norm(by_vertex, axis=(1, 2)) / np.sqrt(vertices[0].size)
    np.testing.assert_array_less(np.abs((ahead - behind) / (2 * step) - expected), 1e-3 * size)


@pytest.mark.slow  # first derivatives have the tests around it; of replays: in test_second_derivatives
def test_grad_of_vmap_is_vmap_of_grad_and_slopes_have_slopes(batch):
    """Second derivatives of nodes against differences of first ones, along one direction. Radii have kinks there."""
    vertices = jnp.asarray(moved(batch.vertices))

    def total(one, vertices):
        return jax.vmap(one)(batch.bindings, vertices).sum()

    def cubes(binding, vertices):
        return (msf_jax.follow(binding, vertices).nodes ** 3).sum()

    first = jax.jit(jax.grad(partial(total, weighed)))(vertices)
    np.testing.assert_allclose(first, slopes(batch.bindings, vertices)[1], rtol=0, atol=1e-12)
    slope = jax.jit(jax.grad(partial(total, cubes)))
    direction = jnp.asarray(np.random.default_rng(4).normal(size=vertices.shape))
    second = jax.jit(lambda at: jax.jvp(slope, (at,), (direction,))[1])(vertices)
    step = 1e-6
    expected = np.asarray(slope(vertices + step * direction) - slope(vertices - step * direction)) / (2 * step)
    size = np.linalg.norm(expected)
    assert size > 1e-2 and np.linalg.norm(np.asarray(second) - expected) < 1e-4 * size


@pytest.mark.slow  # slopes in a batch are above
def test_a_step_of_training_in_a_scan(batch):
    """Descent along the batch's gradient, five steps in one program, lowers what it is for."""

    def value(vertices):
        nodes, _ = jax.vmap(msf_jax.follow)(batch.bindings, vertices)
        return (nodes[..., 2] ** 2).sum()

    def step(vertices, _):
        now, slope = jax.value_and_grad(value)(vertices)
        return vertices - 0.3 * slope, now

    values = jax.jit(lambda start: jax.lax.scan(step, start, length=5)[1])(batch.vertices)
    assert (np.diff(values) < 0).all()


SHARDED = """
import sys, pickle
import jax, numpy as np
jax.config.update("jax_enable_x64", True)
from jax.sharding import Mesh, PartitionSpec
import msf_jax
import test_stack as cases

assert jax.device_count() == 2
curves, expected = pickle.load(open(sys.argv[1], "rb"))
batch = msf_jax.stack([skeleton for _, skeleton in curves])
vertices = jax.numpy.asarray(cases.moved(batch.vertices))
along = PartitionSpec("meshes")
spread = jax.shard_map(
    jax.vmap(jax.value_and_grad(cases.weighed, argnums=1)),
    mesh=Mesh(np.array(jax.devices()), ("meshes",)), in_specs=(along, along), out_specs=(along, along),
)
for one, other in zip(jax.jit(spread)(batch.bindings, vertices), expected, strict=True):
    assert len(one.sharding.device_set) == 2
    np.testing.assert_allclose(one, other, rtol=1e-12, atol=1e-12)
there = jax.devices()[1]
vertices, skeleton = curves[0]
for followed in (skeleton, skeleton.binding):
    assert msf_jax.follow(followed, jax.device_put(vertices, there)).nodes.devices() == {there}
print("spread over", jax.device_count())
"""


@pytest.mark.system
def test_a_batch_is_spread_over_devices(curves, batch, tmp_path):
    """In a process that has two. Values and slopes are those of this one, which has one."""
    expected = jax.device_get(slopes(batch.bindings, jnp.asarray(moved(batch.vertices))))
    with open(tmp_path / "curves.pkl", "wb") as file:
        pickle.dump((curves, expected), file)
    (tmp_path / "sharded.py").write_text(SHARDED)
    flags = f"{os.environ.get('XLA_FLAGS', '')} --xla_force_host_platform_device_count=2"
    assert "spread over 2" in _in_process(tmp_path / "sharded.py", str(tmp_path / "curves.pkl"), XLA_FLAGS=flags)


def test_curves_of_a_capacity_share_a_program(curves, compilations):
    """Another curve of the same mesh, pruned and resampled, and the tube with the capacity of the three limbs."""
    vertices, skeleton = curves[1]
    other = skeleton.resample(0.2)
    assert other.binding.capacity == skeleton.binding.capacity and len(other.vertices) != len(skeleton.vertices)
    rows = np.zeros((skeleton.binding.num_vertices, 3))
    rows[: len(vertices)] = vertices
    slope(skeleton.binding, rows)
    msf_jax.follow(skeleton, vertices)
    bare = unpadded(curves[0][1].binding)
    compilations.clear()
    for binding in (other.binding, padded(bare, skeleton.binding.capacity)):
        value, by_vertex = slope(binding, rows)
        assert np.isfinite(value) and np.abs(by_vertex).max() > 0
    msf_jax.follow(other, vertices)
    msf_jax.follow(other.binding, vertices)
    assert not compilations


def test_a_second_batch_takes_the_capacity_of_the_first(curves, batch, compilations, monkeypatch):
    """And compiles nothing, though its largest mesh is smaller."""
    for name, capacity in (("vertices", 256), ("faces", 640)):  # so that the tube has another capacity than the limbs
        monkeypatch.setitem(SMALLEST_SIZES, name, capacity)
    tube = curves[0][1]
    every_follow(batch.bindings, batch.vertices)
    second = msf_jax.stack([tube, tube], like=batch)
    compilations.clear()
    found = every_follow(second.bindings, second.vertices)
    assert not compilations
    for nodes, _ in second.unstack(found):
        np.testing.assert_allclose(nodes, tube.vertices, rtol=0, atol=1e-12)
    assert msf_jax.stack([tube]).vertices.shape[1] < second.vertices.shape[1]
    assert msf_jax.stack([curves[1][1]], like=msf_jax.stack([tube])).vertices.shape[1] == 1024


def test_ladders_have_few_rungs(curves):
    """Capacity for what is asked and for the rows of padding; a mesh of twice the vertices is one rung up."""
    sizes = unpadded(curves[1][1].binding).live
    capacity = capacity_for(sizes)
    assert all(one >= other for one, other in zip(capacity, sizes, strict=True)) and capacity.nodes > sizes.nodes
    full = sizes._replace(nodes=capacity.nodes, vertices=capacity.vertices)
    assert capacity_for(full).nodes == 4 * capacity.nodes and capacity_for(full).vertices == capacity.vertices
    assert capacity_for(sizes, full._replace(vertices=2 * capacity.vertices)).vertices == 2 * capacity.vertices
    many = {capacity_for(sizes._replace(vertices=num, faces=2 * num)).vertices for num in range(500, 12_001, 7)}
    assert many == {1024, 2048, 4096, 8192, 16384}


def test_curves_of_64_meshes_need_at_most_six_programs(curves):
    """Of 500 to 12,000 vertices. Sizes as measured on stars of limbs: the coarsest have the most nodes."""
    sizes = unpadded(curves[1][1].binding).live
    measured = {  # vertices: the most nodes, corners, entries of a and of b that were seen about there
        500: (363, 4854, 19090, 30866),
        1000: (280, 4700, 7700, 40000),
        2000: (180, 5300, 6000, 95000),
        4000: (150, 8409, 5000, 84234),
        8000: (160, 13140, 5000, 116951),
        12000: (160, 14000, 5000, 120000),
    }
    capacities = set()
    for vertices in np.geomspace(500, 12_000, 64).astype(int):
        for few in (1, 2):
            near = min(measured, key=lambda num, vertices=vertices: abs(np.log(num / vertices)))
            nodes, corners, smoothing, turning = (count // few for count in measured[near])
            mesh = {"vertices": vertices, "faces": 2 * vertices}
            curve = {"nodes": nodes, "edges": nodes - 1, "sections": nodes, "corners": corners}
            capacities.add(capacity_for(sizes._replace(**mesh, **curve, smoothing=smoothing, turning=turning)))
    assert len(capacities) <= 6


@pytest.mark.parametrize("dtype", [np.float32, np.float64, np.float16, np.int32])
def test_numbers_stay_what_they_are(curves, dtype):
    """float32 in, float32 out, though x64 is on; less is float32, whole numbers are float64, as everywhere in JAX."""
    vertices, skeleton = curves[0]
    expected = {np.float16: np.float32, np.int32: np.float64}.get(dtype, dtype)
    given = (100 * vertices).astype(dtype)
    for binding in (skeleton, skeleton.binding):
        found = msf_jax.follow(binding, given)
        assert {part.dtype for part in found} == {np.dtype(expected)}
    close = 0.5 if dtype in (np.float16, np.int32) else 1e-3 if dtype == np.float32 else 1e-10
    nodes = np.asarray(msf_jax.follow(skeleton, given).nodes)
    np.testing.assert_allclose(nodes, 100 * skeleton.vertices, rtol=0, atol=2 * close)


def test_through_jax_and_files(curves, batch, tmp_path):
    """A binding and a batch through jit, tree.map, pickle, and a file of leaves, and back."""
    for tree in (curves[1][1].binding, batch):
        for back in (
            jax.jit(lambda tree: tree)(tree),
            jax.tree.map(jnp.asarray, tree),
            pickle.loads(pickle.dumps(tree)),
            _by_leaves(tree, tmp_path / "leaves.npz"),
        ):
            assert jax.tree.structure(back) == jax.tree.structure(tree)
            for one, other in zip(jax.tree.leaves(back), jax.tree.leaves(tree), strict=True):
                np.testing.assert_array_equal(one, other)
                assert one.dtype == other.dtype
    found = batch.members()
    for (binding, vertices), (given, skeleton) in zip(found, curves, strict=True):
        np.testing.assert_allclose(vertices, given, rtol=0, atol=1e-14)
        for one, other in zip(jax.tree.leaves(binding), jax.tree.leaves(skeleton.binding), strict=True):
            np.testing.assert_array_equal(one, other)


def test_a_skeleton_through_jax_and_back(curves, compilations, tmp_path):
    """As an argument of a jitted function, and as what it returns; its binding goes with it."""
    vertices, skeleton = curves[0]
    nodes = jax.jit(lambda skeleton, vertices: msf_jax.follow(skeleton, vertices).nodes)
    found = nodes(skeleton, vertices)
    np.testing.assert_allclose(found, skeleton.vertices, rtol=0, atol=1e-12)
    compilations.clear()
    back = jax.tree.map(np.asarray, jax.jit(lambda skeleton: skeleton)(skeleton))
    back = jax.tree.map(np.copy, pickle.loads(pickle.dumps(back)))
    np.testing.assert_array_equal(back.edges, skeleton.edges)
    np.testing.assert_array_equal(msf_jax.follow(back, vertices).nodes, msf_jax.follow(skeleton, vertices).nodes)
    assert back.report == skeleton.report and back.prune(90.0).length <= skeleton.length
    larger = jax.tree.map(lambda values: 2 * values if values.dtype.kind == "f" else values, skeleton)
    np.testing.assert_array_equal(larger.vertices, 2 * skeleton.vertices)
    compilations.clear()
    nodes(jax.tree.map(lambda values: values, skeleton), vertices)
    assert not compilations
    skeleton.save(tmp_path / "tube.swc")
    bare = jax.tree.map(np.copy, msf_jax.read_curve(tmp_path / "tube.swc"))
    assert bare.source is None and len(bare.vertices) == len(skeleton.vertices)


def _by_leaves(tree, path):
    """Written and read as Equinox and Orbax do: the leaves, in order; the structure is that of something alike."""
    leaves, structure = jax.tree.flatten(tree)
    np.savez(path, *leaves)
    with np.load(path) as held:
        return jax.tree.unflatten(structure, [held[f"arr_{k}"] for k in range(len(leaves))])


def test_equinox_writes_and_reads_it(batch, tmp_path):
    equinox = pytest.importorskip("equinox")
    equinox.tree_serialise_leaves(tmp_path / "batch.eqx", batch)
    back = equinox.tree_deserialise_leaves(tmp_path / "batch.eqx", jax.tree.map(jnp.zeros_like, batch))
    for one, other in zip(jax.tree.leaves(back), jax.tree.leaves(batch), strict=True):
        np.testing.assert_array_equal(one, other)


def test_what_is_no_batch_is_refused(curves, tmp_path):
    vertices, skeleton = curves[0]
    for given, says in (([], "has none"), ([skeleton, vertices], "has ndarray")):
        with pytest.raises(ConfigError, match=says):
            msf_jax.stack(given)
    for given, options, says in (
        (skeleton, {}, "skeletons is a Skeleton"),
        (3, {}, "skeletons is a int"),
        ([skeleton], {"like": skeleton}, "like is a Skeleton"),
        ([skeleton], {"dtype": int}, "dtype is .*int"),
        ([skeleton], {"dtype": "half"}, "dtype is 'half'"),
    ):
        with pytest.raises(ConfigError, match=says):
            msf_jax.stack(given, **options)
    for short in (vertices[:-1], np.zeros((10_000, 3))):
        with pytest.raises(MeshError, match=r"vertices has shape \(\d+, 3\): expected"):
            msf_jax.follow(skeleton.binding, short)
    skeleton.save(tmp_path / "tube.swc")
    with pytest.raises(ConfigError, match="does not know the mesh"):
        msf_jax.stack([msf_jax.read_curve(tmp_path / "tube.swc")])
