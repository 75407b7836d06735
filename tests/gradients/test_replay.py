"""The replay: equal to the run, differentiable, and the same whatever the padding."""

import os
import subprocess
import sys
from dataclasses import replace
from functools import partial
from pathlib import Path

import jax
import jax.numpy as jnp
import numpy as np
import pytest
import trimesh
from conftest import blob, torus
from device_cases import central_difference

import msf_jax
from msf_jax import Config, ConfigError, MeshError, PreprocessingOptions, Weights
from msf_jax.base.layout import layout_for
from msf_jax.gradients import replay, tape
from msf_jax.recording import padded
from msf_jax.recording.padded import Planned

pytestmark = pytest.mark.usefixtures("few_rows")
TIGHT = 1e-15  # of the solves, where differences of replays are taken


def ellipsoid(subdivisions: int = 3) -> trimesh.Trimesh:
    """Stretched, bumpy, and far from the origin."""
    mesh = blob(3, subdivisions)
    mesh.apply_scale([1.0, 0.5, 0.4])
    mesh.apply_translation([5.0, -3.0, 100.0])
    return mesh


def pinched() -> trimesh.Trimesh:
    """Two ellipsoids that share a vertex, and a vertex that no face uses."""
    one, other = ellipsoid(2), ellipsoid(2)
    tip = int(one.vertices[:, 0].argmax())
    back = int(other.vertices[:, 0].argmin())
    other.apply_translation(one.vertices[tip] - other.vertices[back])
    faces = np.where(other.faces == back, tip, other.faces + len(one.vertices))
    vertices = np.concatenate([one.vertices, other.vertices])
    return trimesh.Trimesh(vertices, np.concatenate([one.faces, faces]), process=False)


def parts() -> trimesh.Trimesh:
    ring = torus(around=16, across=8)
    ring.apply_translation([0.0, 4.0, 100.0])
    return trimesh.util.concatenate([pinched(), ring])


def varied(num: int) -> Weights:
    """Another weight at every vertex."""
    random = np.random.default_rng(0)
    w_H, w_M, smoothing = (base * np.exp(0.4 * random.normal(size=num)) for base in (0.1, 0.4, 0.001))
    return Weights(1.0, w_H, w_M, smoothing)


@pytest.fixture(scope="module")
def flow() -> msf_jax.Flow:
    """A small and short one with edits: what takes time is compiling, and solves that are as tight as can be."""
    few = PreprocessingOptions(refine=0.0)  # the vertices of the mesh
    return msf_jax.contract(ellipsoid(2), config=Config(max_iterations=5, preprocessing=few))


CASES = {
    "parts, one pinched, pins, another weight at each vertex, eigenvectors": (
        parts,
        None,
        Config(max_iterations=9, preprocessing=PreprocessingOptions(reconstruct_mesh=80, exact_reconstruction=True)),
        [0, 5, 100],
    ),
    "resampled, filtered mesh, trusted poles, uniform": (
        lambda: ellipsoid(2),
        Weights(),
        Config.tagliasacchi2012(
            preprocessing={"resample": 0.05, "reconstruct_mesh": 80, "pole_confidence": True},
            flow={"threshold_min": 0.01, "laplacian": "uniform"},
        ),
        None,
    ),
}


@pytest.mark.slow  # nodes are also those of the run in test_tape, and of another system in test_au2008
@pytest.mark.parametrize("name", CASES)
def test_it_equals_the_run(name):
    make, weights, config, pins = CASES[name]
    mesh = make()
    weights = varied(len(mesh.vertices)) if weights is None else weights
    flow = msf_jax.contract(mesh, weights, config, pins=pins)
    nodes = msf_jax.replay(flow.tape, flow.weights)
    bound = 1e-9 * mesh.scale
    assert np.abs(nodes - flow.curve.vertices).max() < bound
    assert np.abs(msf_jax.replay_meso(flow.tape, flow.weights) - flow.meso_skeleton[0]).max() < bound
    radii = np.asarray(msf_jax.replay_radii(flow.tape, nodes))
    is_inside = flow.curve.radii > 0
    assert np.abs(radii - flow.curve.radii)[is_inside].max() < bound
    assert (radii[~is_inside] <= bound).all()


@partial(jax.jit, static_argnames="tolerance")
def probe(tape, logarithms, vertices, towards, tolerance=None):
    """<towards, nodes>, less what it was, and its slope in the logarithms (4, V) of weights and in vertices (V, 3)."""

    def value(logarithms, vertices):
        nodes = msf_jax.replay(tape, Weights(*jnp.exp(logarithms)), vertices, tolerance=tolerance)
        return (towards * (nodes - jnp.asarray(tape.vertices).mean(axis=0))).sum(), nodes

    (found, nodes), slopes = jax.value_and_grad(value, argnums=(0, 1), has_aux=True)(logarithms, vertices)
    return found, slopes, nodes


def probed(tape, seed=0):
    """Arguments for `probe` at what was recorded, one weight a vertex."""
    weights = np.array(list(vars(tape.weights).values()))
    towards = np.random.default_rng(seed).normal(size=(tape.num_nodes, 3))
    return np.log(np.tile(weights[:, None], len(tape.vertices))), np.asarray(tape.vertices), towards


@pytest.mark.slow  # slopes of a step are in test_padding, that a replay equals its run is below
def test_gradients_agree_with_central_differences(flow):
    """Along a change of all weights of all vertices, of all vertices' places, and of one vertex's weights: 1e-5."""
    tape, random = flow.tape, np.random.default_rng(0)
    first, vertices, towards = probed(tape)
    _, slopes, _ = probe(tape, first, vertices, towards, TIGHT)
    replayed = jax.jit(partial(msf_jax.replay, tolerance=TIGHT))
    middle = vertices.mean(axis=0)

    def value(logarithms, vertices):
        return (towards * (replayed(tape, Weights(*np.exp(logarithms)), vertices) - middle)).sum()

    no_log, none = np.zeros_like(first), np.zeros_like(vertices)
    every, one, moved = random.normal(size=(4, 1)) * np.ones_like(first), no_log.copy(), none.copy()
    one[1:, random.integers(len(vertices))] = 1.0
    moved[random.choice(len(vertices), 5, replace=False)] = random.normal(size=(5, 3))
    for log_step, step, h in ((every, none, 2e-6), (no_log, moved, 2e-6), (one, none, 1e-4)):
        found = (slopes[0] * log_step).sum() + (slopes[1] * step).sum()
        measured = central_difference(
            lambda t, log_step=log_step, step=step: value(first + t * log_step, vertices + t * step),
            np.zeros(()),
            1.0,
            h,
        )
        np.testing.assert_allclose(found, measured, rtol=1e-5)


@pytest.mark.slow  # that a step's layout does not show is in test_padding
def test_padding_does_not_matter(flow, monkeypatch):
    """In a larger layout, and in two stretches instead of one: the same nodes, and the same gradient."""

    def other_plan(steps, before):
        beyond = [4] * 20
        return [Planned(0, 1, layout_for(500, beyond)), Planned(1, len(steps), layout_for(400, beyond))]

    assert flow.tape.num_nodes  # recorded by now
    monkeypatch.setattr(padded, "stretches_of", other_plan)
    again = tape.record(flow.recording, flow.weights, flow.config, flow.curve, flow.source)
    assert again.shapes != flow.tape.shapes
    _, slopes, nodes = probe(flow.tape, *probed(flow.tape), TIGHT)
    _, other_slopes, other_nodes = probe(again, *probed(again), TIGHT)
    np.testing.assert_allclose(other_nodes, nodes, atol=1e-10)
    for one, other in zip(slopes, other_slopes, strict=True):
        np.testing.assert_allclose(other, one, rtol=1e-6, atol=1e-7 * np.abs(one).max())


@pytest.mark.slow
def test_many_weights_at_once(flow):
    w_L = jnp.array([0.8, 1.0, 1.3])
    batch = jax.vmap(lambda w_L: msf_jax.replay(flow.tape, replace(flow.weights, w_L=w_L)))(w_L)
    for row, one in zip(batch, w_L, strict=True):
        expected = msf_jax.replay(flow.tape, replace(flow.weights, w_L=float(one)))
        np.testing.assert_allclose(row, expected, atol=1e-8)
    assert np.abs(batch[0] - batch[2]).max() > 1e-4


@pytest.mark.slow  # traces a gradient of its own
def test_reverse_mode_keeps_states_and_no_solver_steps(flow):
    """What is kept for the way back is a few surfaces an iteration, however many steps the solves take."""

    run = jax.eval_shape(lambda weights: jax.vjp(partial(msf_jax.replay, flow.tape), weights)[1], flow.weights)
    kept = sum(leaf.size * leaf.dtype.itemsize for leaf in jax.tree_util.tree_leaves(run))
    part, shape = flow.tape.parts[0], flow.tape.shapes[0]
    states = sum(
        len(stretch.factor) * 8 * (7 * (layout.capacity + stretch.cut[0, ..., 0].size) + 6 * layout.capacity)
        for stretch, layout in zip(part.stretches, shape.layouts, strict=True)
    )
    of_tape = sum(np.asarray(leaf).nbytes for leaf in jax.tree_util.tree_leaves(flow.tape))
    assert kept < 1.5 * states + 2 * of_tape


def test_radii_are_distances_to_the_recorded_triangle(flow):
    """By the solid's own measure for small moves; negative, with an unbroken slope, through the surface."""
    tape = flow.tape
    nodes = flow.curve.vertices
    random = np.random.default_rng(2)
    moved = nodes + 1e-7 * random.normal(size=nodes.shape)
    measured = jax.jit(msf_jax.replay_radii)
    radii = np.maximum(measured(tape, moved), 0.0)  # the solid's own are 0 outside
    np.testing.assert_allclose(radii, flow.source.solid.radii(moved), atol=1e-8)
    triangle = tape.vertices[tape.triangles[0]]
    normal = np.cross(triangle[1] - triangle[0], triangle[2] - triangle[0])
    normal /= np.linalg.norm(normal)
    both = jax.jit(jax.value_and_grad(lambda x: msf_jax.replay_radii(tape, x)[0]))
    for height in (-0.01, -1e-9, 1e-9, 0.01):
        placed = nodes.copy()
        placed[0] = triangle.mean(axis=0) + height * normal
        radius, slope = both(placed)
        np.testing.assert_allclose(radius, -height, atol=1e-12)
        np.testing.assert_allclose(slope[0], -normal, atol=1e-9)


@pytest.mark.slow  # so is a derivative, in test_second_derivatives
def test_an_unsolved_replay_is_nan(flow, monkeypatch):
    monkeypatch.setattr(replay, "MOST_STEPS", 2)
    assert np.isnan(msf_jax.replay(flow.tape, flow.weights)).all()


SHARDED = """
import jax, numpy as np
jax.config.update("jax_enable_x64", True)
from jax.sharding import Mesh, PartitionSpec
import msf_jax
from msf_jax import Config, Weights
from msf_jax.base import layout
from conftest import blob

assert jax.device_count() == 4
layout.SMALLEST_CAPACITY = 64
flow = msf_jax.contract(blob(1, 1), config=Config(max_iterations=1))
many = jax.vmap(jax.value_and_grad(lambda weights: (msf_jax.replay(flow.tape, weights, tolerance=1e-14) ** 2).sum()))
spread = jax.jit(jax.shard_map(
    many, mesh=Mesh(np.array(jax.devices()), ("w",)), in_specs=PartitionSpec("w"), out_specs=PartitionSpec("w")
))

def found(logarithms):
    values, slopes = spread(Weights(*np.exp(logarithms)))
    assert len(values.sharding.device_set) == 4
    return np.array(values), np.exp(logarithms) * np.array(jax.tree.leaves(slopes))

start = np.log(np.tile(jax.tree.leaves(flow.weights), (4, 1)).T)
start[1] += np.linspace(0.0, 1.0, 4)
values, slopes = found(start)
np.testing.assert_allclose(values[0], (flow.curve.vertices**2).sum(), rtol=1e-6)
step = 1e-5 * np.random.default_rng(0).normal(size=start.shape)
(ahead, _), (behind, _) = found(start + step), found(start - step)
np.testing.assert_allclose((slopes * 2 * step).sum(axis=0), ahead - behind, rtol=1e-4)
assert np.ptp(values) > 1e-3 * values[0]
print("spread over", jax.device_count())
"""


@pytest.mark.system
def test_replays_are_spread_over_devices(tmp_path):
    """And checked: what differs between devices is declared so, loops inside the solves included. The first device has
    the run's own weights, and its value; slopes of each are those of central differences of its own values."""
    (tmp_path / "sharded.py").write_text(SHARDED)
    tests = Path(__file__).parents[1]
    flags = os.environ.get("XLA_FLAGS", "") + " --xla_force_host_platform_device_count=4"
    paths = f"{tests.parent}{os.pathsep}{tests}"
    done = subprocess.run(
        [sys.executable, str(tmp_path / "sharded.py")],
        env=os.environ | {"XLA_FLAGS": flags, "PYTHONPATH": paths},
        capture_output=True,
        text=True,
        timeout=600,
    )
    assert "spread over 4" in done.stdout, done.stderr[-3000:]


@pytest.mark.parametrize(
    ("arguments", "error", "says"),
    [
        (lambda tape: ("tape", Weights()), ConfigError, "tape is a str: expected a Tape"),
        (lambda tape: (tape, (1.0, 0.1)), ConfigError, "weights is a tuple: expected a msf_jax.Weights"),
        (lambda tape: (tape, Weights(w_H=np.ones(3))), ConfigError, r"w_H has shape \(3,\): expected a number, or"),
        (lambda tape: (tape, Weights(), np.zeros((5, 3))), MeshError, r"shape \(5, 3\): expected \(162, 3\)"),
        (
            lambda tape: (tape, Weights(), tape.vertices * np.nan),
            MeshError,
            "162 of the vertices, the first 0, are not",
        ),
        (lambda tape: (tape, Weights(), "abc"), MeshError, "vertices is a str: expected an array of numbers"),
        (lambda tape: (tape, jax.tree_util.tree_map(lambda x: -x, Weights())), ConfigError, "w_L is -1.0: expected a"),
        (
            lambda tape: (tape, jax.tree_util.tree_map(lambda x: 0.0, Weights())),
            ConfigError,
            "w_H is 0.0: expected more",
        ),
    ],
)
def test_wrong_arguments(flow, arguments, error, says):
    with pytest.raises(error, match=says):
        msf_jax.replay(*arguments(flow.tape))


def test_wrong_tolerance(flow):
    with pytest.raises(ConfigError, match="tolerance is 0: expected a number above 0"):
        msf_jax.replay(flow.tape, flow.weights, tolerance=0)


def test_radii_of_other_nodes(flow):
    with pytest.raises(ConfigError, match=r"nodes has shape \(2, 3\)"):
        msf_jax.replay_radii(flow.tape, np.zeros((2, 3)))


def test_weights_of_the_wrong_length_are_refused_by_the_flow():
    with pytest.raises(ConfigError, match=r"w_M has shape \(3,\): expected a number, or \(162,\)"):
        msf_jax.contract(ellipsoid(2), Weights(w_M=np.ones(3)))
