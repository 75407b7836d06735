"""The tape and its replay: equal to the run, the same whatever the padding, pickled and refused. Its derivatives
are in test_transformations."""

import pickle
from functools import partial

import jax
import numpy as np
import pytest
import trimesh
from conftest import blob, torus
from test_transformations import recorded

import msf_jax
from msf_jax import Config, ConfigError, MeshError, PreprocessingOptions, Weights
from msf_jax.base.layout import layout_for
from msf_jax.gradients import replay, tape
from msf_jax.recording import records

pytestmark = pytest.mark.usefixtures("few_rows")


def ellipsoid() -> trimesh.Trimesh:
    """Stretched, bumpy, and far from the origin."""
    return blob(3, 2).apply_scale([1.0, 0.5, 0.4]).apply_translation([5.0, -3.0, 100.0])


def parts() -> trimesh.Trimesh:
    """Two ellipsoids that share a vertex, a vertex that no face uses, and a ring."""
    one, other = ellipsoid(), ellipsoid()
    tip, back = int(one.vertices[:, 0].argmax()), int(other.vertices[:, 0].argmin())
    other.apply_translation(one.vertices[tip] - other.vertices[back])
    faces = np.where(other.faces == back, tip, other.faces + len(one.vertices))
    vertices = np.concatenate([one.vertices, other.vertices])
    pinched = trimesh.Trimesh(vertices, np.concatenate([one.faces, faces]), process=False)
    ring = torus(around=16, across=8).apply_translation([0.0, 4.0, 100.0])
    return trimesh.util.concatenate([pinched, ring])


def varied(num: int) -> Weights:
    """Another weight at every vertex."""
    random = np.random.default_rng(0)
    w_H, w_M, smoothing = (base * np.exp(0.4 * random.normal(size=num)) for base in (0.1, 0.4, 0.001))
    return Weights(1.0, w_H, w_M, smoothing)


@pytest.fixture(scope="module")
def flow() -> msf_jax.Flow:
    return recorded()


CASES = {
    "parts, one pinched, pins, another weight at each vertex, eigenvectors": (
        parts,
        None,
        Config(max_iterations=9, preprocessing=PreprocessingOptions(reconstruct_mesh=80, exact_reconstruction=True)),
        [0, 5, 100],
    ),
    "resampled, filtered mesh, trusted poles, uniform": (
        ellipsoid,
        Weights(),
        Config.tagliasacchi2012(
            preprocessing={"resample": 0.05, "reconstruct_mesh": 80},
            flow={"threshold_min": 0.01, "laplacian": "uniform"},
        ),
        None,
    ),
}


@pytest.mark.slow  # that of another system is in test_au2008
@pytest.mark.parametrize("name", CASES)
def test_it_equals_the_run(name):
    """Also with a pickled tape."""
    make, weights, config, pins = CASES[name]
    mesh = make()
    flow = msf_jax.contract(mesh, varied(len(mesh.vertices)) if weights is None else weights, config, pins=pins)
    nodes = msf_jax.replay(pickle.loads(pickle.dumps(flow.tape)), flow.weights)
    bound = 1e-9 * mesh.scale
    assert np.abs(nodes - flow.curve.vertices).max() < bound
    assert np.abs(msf_jax.replay_meso(flow.tape, flow.weights) - flow.meso_skeleton[0]).max() < bound
    radii = np.asarray(msf_jax.replay_radii(flow.tape, nodes))
    is_inside = flow.curve.radii > 0
    assert np.abs(radii - flow.curve.radii)[is_inside].max() < bound
    assert (radii[~is_inside] <= bound).all()


@pytest.mark.slow  # that a step's layout does not show is in test_padding
def test_padding_does_not_matter(flow, monkeypatch):
    """In a larger layout, and in two stretches instead of one: the same nodes."""

    def other_plan(steps, *_):
        beyond = [4] * 20
        return [(0, 1, layout_for(500, beyond)), (1, len(steps), layout_for(400, beyond))]

    nodes = msf_jax.replay(flow.tape, flow.weights)
    monkeypatch.setattr(records, "layouts_of", other_plan)
    again = tape.record(flow.recording, flow.weights, flow.config, flow.curve, flow.source)
    assert again.layouts != flow.tape.layouts
    np.testing.assert_allclose(msf_jax.replay(again, flow.weights), nodes, atol=1e-10)


@pytest.mark.slow  # traces a gradient of its own
def test_reverse_mode_keeps_states_and_no_solver_steps(flow):
    """What is kept for the way back is a few surfaces an iteration, however many steps the solves take."""

    run = jax.eval_shape(lambda weights: jax.vjp(partial(msf_jax.replay, flow.tape), weights)[1], flow.weights)
    kept = sum(leaf.size * leaf.dtype.itemsize for leaf in jax.tree.leaves(run))
    states = sum(
        len(stretch.factor) * 8 * (7 * (layout.capacity + stretch.cut[0, ..., 0].size) + 6 * layout.capacity)
        for stretch, layout in zip(flow.tape.parts[0].stretches, flow.tape.layouts[0], strict=True)
    )
    of_tape = sum(np.asarray(leaf).nbytes for leaf in jax.tree.leaves(flow.tape))
    assert kept < 1.5 * states + 2 * of_tape


def test_radii_are_distances_to_the_recorded_triangle(flow):
    """By the solid's own measure for small moves; negative, with an unbroken slope, through the surface."""
    tape, nodes = flow.tape, flow.curve.vertices
    moved = nodes + 1e-7 * np.random.default_rng(2).normal(size=nodes.shape)
    radii = np.maximum(jax.jit(msf_jax.replay_radii)(tape, moved), 0.0)  # the solid's own are 0 outside
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


@pytest.mark.parametrize(
    ("arguments", "error", "says"),
    [
        (lambda tape: ("tape", Weights()), ConfigError, "tape is a str: expected a Tape"),
        (lambda tape: (tape, (1.0, 0.1)), ConfigError, "weights is a tuple: expected a msf_jax.Weights"),
        (lambda tape: (tape, Weights(w_H=np.ones(3))), ConfigError, r"w_H has shape \(3,\): expected a number, or"),
        (lambda tape: (tape, Weights(), np.zeros((5, 3))), MeshError, r"shape \(5, 3\): expected \(162, 3\)"),
        (lambda tape: (tape, Weights(), tape.vertices * np.nan), MeshError, "162 of the vertices, the first 0, are"),
        (lambda tape: (tape, Weights(), "abc"), MeshError, "vertices is a str: expected an array of real"),
        (lambda tape: (tape, jax.tree.map(lambda _: -1.0, Weights())), ConfigError, "w_L is -1.0: expected a"),
        (lambda tape: (tape, jax.tree.map(lambda _: 0.0, Weights())), ConfigError, "w_H is 0.0: expected more"),
    ],
)
def test_wrong_arguments(flow, arguments, error, says):
    with pytest.raises(error, match=says):
        msf_jax.replay(*arguments(flow.tape))
    with pytest.raises(ConfigError, match="tolerance is 0: expected a number above 0"):
        msf_jax.replay(flow.tape, flow.weights, tolerance=0)
    with pytest.raises(ConfigError, match=r"nodes has shape \(2, 3\)"):
        msf_jax.replay_radii(flow.tape, np.zeros((2, 3)))
    with pytest.raises(ConfigError, match=r"w_M has shape \(3,\): expected a number, or \(162,\)"):
        msf_jax.contract(ellipsoid(), Weights(w_M=np.ones(3)))
