"""JAX's transformations of `follow`, `stack` and `replay`, each beside one compiled value and gradient; and that beside
differences at several steps."""

import functools
import os
import pickle
import subprocess
import sys
from collections.abc import Callable
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from conftest import blob, fewer_rows
from device_cases import central_difference, strict
from jax import export
from run_cases import flow_of

import msf_jax
from msf_jax import Config, PreprocessingOptions, Weights

STEPS = (1e-4, 1e-5, 1e-6)  # of differences: the best one counts, as large ones bend and small ones round
PLATFORMS = ("cpu", "cuda", "tpu")  # XLA compiles for the last two where such a device is; all operations are lowered


class Case(NamedTuple):
    """A number as a function of an array, three places, a direction, and by how much slopes may be off."""

    value: Callable
    places: np.ndarray
    direction: np.ndarray
    off: float


@functools.cache
def recorded() -> msf_jax.Flow:
    """A small and short run with edits: what takes time is compiling, and solves that are as tight as can be."""
    few = PreprocessingOptions(refine=0.0)  # the vertices of the mesh
    mesh = blob(3, 2).apply_scale([1.0, 0.5, 0.4])
    with contextmanager(fewer_rows)():
        flow = msf_jax.contract(mesh, config=Config(max_iterations=3, preprocessing=few))
        assert flow.tape.num_nodes and sum(line.collapses for line in flow.history) > 0
    return flow


@functools.cache
def curves() -> list[msf_jax.Skeleton]:
    """A tube and three limbs, 128 and 948 vertices."""
    return [flow_of(name).skeleton for name in ("straight_coarse", "y_coarse")]


def weighed(found):
    """A number that all nodes have a part in, each another one, with a second derivative."""
    x, y, z = found.nodes.T
    return (jnp.cos(jnp.arange(len(x), dtype=x.dtype)) * (x + y**2 + z**3)).sum()


@functools.cache
def case(name: str) -> Case:
    """Of a replay by its weights or vertices, or of nodes, radii and a batch of nodes by vertices."""
    random = np.random.default_rng(0)
    batch, limbs = msf_jax.stack(curves()), curves()[1]
    if name in ("weights", "vertices"):  # the run that is replayed
        tape = recorded().tape
        towards = random.normal(size=(tape.num_nodes, 3))

    def replayed(weights, vertices=None):
        return (towards * msf_jax.replay(tape, weights, vertices)).sum()

    values = {
        "weights": lambda x: replayed(Weights(*jnp.exp(x))),
        "vertices": lambda x: replayed(tape.weights, x),
        "nodes": lambda x: weighed(msf_jax.follow(limbs, x)),
        "radii": lambda x: (msf_jax.follow(limbs, x).radii ** 2).sum(),
        "batch": lambda x: weighed(msf_jax.follow(batch, x)),
    }
    moved = np.asarray(batch.vertices) + 0.05 * np.sin(2 * np.asarray(batch.vertices)[:, [1, 2, 0]] + 0.3)
    start = moved if name == "batch" else batch.split(moved, "vertices")[1]
    if name in ("weights", "vertices"):
        start = np.log(jax.tree.leaves(tape.weights)) if name == "weights" else np.asarray(tape.vertices)
    direction = random.normal(size=start.shape)
    if name == "radii":  # they have kinks where another triangle becomes the nearest
        direction /= np.linalg.norm(direction)
    far = 1e-7 if name == "vertices" else 1e-2  # the slope of a replay holds for tiny motions of vertices only
    off = {"weights": 1e-4, "vertices": 1e-4, "radii": 1e-3}.get(name, 1e-6)
    return Case(values[name], start + far * np.multiply.outer([0, 1, -2], direction), direction, off)


@functools.cache
def both(name: str):
    """The compiled value and gradient, and what they are at each place."""
    program = jax.jit(jax.value_and_grad(case(name).value))
    values, slopes = zip(*map(program, case(name).places), strict=True)
    return program, np.array(values), np.array(slopes)


def agree(found, expected, off=1e-7):
    expected = np.asarray(expected)
    np.testing.assert_allclose(found, expected, rtol=0, atol=off * np.abs(expected).max())


def check_grad(name):
    _, places, direction, off = case(name)
    program, _, slopes = both(name)
    measured = [central_difference(lambda x: program(x)[0], places[0], direction, h) for h in STEPS]
    size = np.linalg.norm(slopes[0]) * np.linalg.norm(direction) / np.sqrt(direction.size)
    assert size > 1e-3 and np.abs(np.array(measured) - (slopes[0] * direction).sum()).min() < off * size


def check_forward(name):
    value, places, direction, _ = case(name)
    run = jax.jit(lambda x, along: jax.jvp(value, (x,), (along,)))
    agree(run(places[0], direction), (both(name)[1][0], (both(name)[2][0] * direction).sum()))


def check_grad_of_vmap(name):
    value, places, *_ = case(name)
    agree(jax.jit(jax.grad(lambda x: jax.vmap(value)(x).sum()))(places), both(name)[2])


def check_scan(name):
    value, places, *_ = case(name)
    _, values, slopes = both(name)
    found = jax.jit(lambda x: jax.lax.scan(lambda _, one: (0, jax.value_and_grad(value)(one)), 0, x)[1])(places)
    agree(found[0], values)
    agree(found[1], slopes)


def check_second(name):
    value, places, direction, _ = case(name)
    program = both(name)[0]
    second = jax.jit(lambda x: jax.jvp(jax.grad(value), (x,), (direction,))[1])(places[0])
    measured = [(program(places[0] + h * direction)[1] - program(places[0] - h * direction)[1]) / 2 / h for h in STEPS]
    size = np.linalg.norm(measured[-1])
    assert size > 1e-2 and min(np.linalg.norm(each - second) for each in measured) < 1e-5 * size


def check_strict(name):
    value, places, *_ = case(name)
    with strict():
        assert jax.eval_shape(jax.grad(value), places[0]).shape == places[0].shape


def check_export(name):
    """With fixed sizes, for the CPU and for machines that are not at hand."""
    value, places, *_ = case(name)
    exported = export.export(jax.jit(jax.grad(value)), platforms=PLATFORMS)(places[0])
    assert exported.platforms == PLATFORMS
    agree(exported.call(places[0]), both(name)[2][0])
    with pytest.raises(ValueError, match="shape"):
        exported.call(places[0][1:])


TABLE = {  # transformations of each function; the slow ones come last, as those of a replay compile for seconds
    "nodes": ["grad", "forward", "second", "strict", "export"],
    "radii": ["grad", "forward"],
    "batch": ["grad", "grad_of_vmap", "scan", "second", "strict"],
    "weights": ["grad", "export"],
    "vertices": ["grad", "grad_of_vmap"],
}
PAIRS = [(name, each) for name, some in TABLE.items() for each in some]


@pytest.mark.parametrize(
    ("name", "transformation"),
    [pytest.param(*pair, marks=() if pair == ("nodes", "grad") else pytest.mark.slow) for pair in PAIRS],
)
def test_a_transformation_gives_what_the_plain_function_gives(name, transformation):
    globals()[f"check_{transformation}"](name)


@pytest.mark.slow
def test_derivatives_by_weight_and_by_vertex_are_those_of_jacfwd():
    """As the guide has them, and by forward mode."""
    tape = recorded().tape
    towards = np.random.default_rng(0).normal(size=(tape.num_nodes, 3))
    moved = lambda at: msf_jax.replay(tape, tape.weights, jnp.asarray(tape.vertices).at[7].set(at))  # noqa: E731
    column = jax.jit(jax.jacfwd(moved))(tape.vertices[7])
    agree((towards[:, :, None] * column).sum(axis=(0, 1)), both("vertices")[2][0][7], 1e-5)
    by_weight = vars(jax.jit(jax.jacfwd(msf_jax.replay, argnums=1))(tape, tape.weights)).values()
    scaled = [weight * slope for weight, slope in zip(jax.tree.leaves(tape.weights), by_weight, strict=True)]
    agree([(towards * slope).sum() for slope in scaled], both("weights")[2][0], 1e-5)
    np.testing.assert_allclose(sum(scaled[:3]), 0, atol=1e-6 * np.abs(scaled[1]).max())  # only ratios matter


SHARDED = """
import pickle, sys
import jax, numpy as np
jax.config.update("jax_enable_x64", True)
from jax.sharding import Mesh, PartitionSpec
import msf_jax
from msf_jax import Weights
import test_transformations as cases

assert jax.device_count() == 2
tape, curves, places, values, slopes, followed = pickle.load(open(sys.argv[1], "rb"))
mesh, along = Mesh(np.array(jax.devices()), ("each",)), PartitionSpec("each")
spread = lambda run: jax.jit(jax.shard_map(jax.vmap(run), mesh=mesh, in_specs=along, out_specs=along))
towards = np.random.default_rng(0).normal(size=(tape.num_nodes, 3))
value = lambda x: (towards * msf_jax.replay(tape, Weights(*jax.numpy.exp(x)))).sum()
found = spread(jax.value_and_grad(value))(places)
np.testing.assert_allclose(found[0], values, rtol=1e-7)
np.testing.assert_allclose(found[1], slopes, rtol=0, atol=1e-6 * np.abs(slopes).max())
assert len(found[0].sharding.device_set) == 2
equal = [skeleton.binding.like(curves[1].binding) for skeleton in curves]  # of one capacity: they can be mapped over
bindings = jax.tree.map(lambda *parts: np.stack(parts), *equal)
found = spread(lambda binding: cases.weighed(msf_jax.follow(binding, binding.vertices)))(bindings)
np.testing.assert_allclose(found, followed, rtol=1e-12)
there = jax.devices()[1]
for skeleton in (curves[0], curves[0].binding):
    vertices = jax.device_put(equal[0].vertices[: len(curves[0].mesh_map)], there)
    assert msf_jax.follow(skeleton, vertices).nodes.devices() == {there}
print("spread over", jax.device_count())
"""


def in_process(folder: Path, script: str, given, **variables) -> str:
    """What ``script`` writes, in a process that imports this folder's modules, and reads ``given`` from a file."""
    (folder / "script.py").write_text(script)
    (folder / "given.pkl").write_bytes(pickle.dumps(given))
    here = Path(__file__).parent
    variables["PYTHONPATH"] = os.pathsep.join(map(str, (here.parents[1], here.parent, here)))
    command = [sys.executable, str(folder / "script.py"), str(folder / "given.pkl")]
    done = subprocess.run(command, env=os.environ | variables, capture_output=True, text=True, timeout=600)
    assert done.returncode == 0, done.stderr[-3000:]
    return done.stdout


@pytest.mark.system
def test_replays_and_batches_are_spread_over_devices(tmp_path):
    """In a process that has two. Values and slopes are those of this one, which has one."""
    both_of = [curves()[0].binding.like(curves()[1].binding), curves()[1].binding]
    followed = [float(weighed(msf_jax.follow(each, each.vertices))) for each in both_of]
    _, values, slopes = both("weights")
    given = recorded().tape, curves(), case("weights").places[:2], values[:2], slopes[:2], np.asarray(followed)
    flags = f"{os.environ.get('XLA_FLAGS', '')} --xla_force_host_platform_device_count=2"
    assert "spread over 2" in in_process(tmp_path, SHARDED, given, XLA_FLAGS=flags)
