"""The tape and its replay: equal to the run, the same whatever the padding, pickled and refused. Its derivatives
are in test_transformations."""

import dataclasses
import pickle
from functools import partial

import jax
import numpy as np
import pytest
import trimesh
from conftest import blob, torus
from scipy.spatial.transform import Rotation
from test_transformations import recorded

import msf_jax
from msf_jax import Config, ConfigError, MeshError, PreprocessingOptions, Weights
from msf_jax.base.layout import layout_for
from msf_jax.device import playback
from msf_jax.gradients import replay
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


@pytest.mark.slow
def test_the_curve_of_a_turned_mesh_is_nearly_the_turned_curve(flow):
    """But for loose solves, whose residuals do not turn. With poles that kept their direction it was off by 0.023."""
    turn = 1.1 * Rotation.from_rotvec([0.1, 0.05, -0.08]).as_matrix()
    curve, other = (np.asarray(msf_jax.replay(flow.tape, flow.weights, x)) for x in (None, flow.tape.vertices @ turn.T))
    assert np.linalg.norm(other - curve @ turn.T, axis=1).max() < 0.01


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


@pytest.mark.slow  # that a step's layout does not show is in test_padding
def test_padding_does_not_matter(flow, monkeypatch):
    """In a larger layout, and in two stretches instead of one: the same nodes. Of few kinds of tapes programs stay."""

    def other_plan(steps, *_):
        return [(0, 1, layout_for(500, [4] * 20)), (1, len(steps), layout_for(400, [4] * 20))]

    nodes = msf_jax.replay(flow.tape, flow.weights)
    monkeypatch.setattr(records, "layouts_of", other_plan)
    again = replay.record(flow.recording, flow.weights, flow.config, flow.source.areas)
    assert again.layouts != flow.tape.layouts
    monkeypatch.setattr(replay, "MOST_KINDS", 1)
    np.testing.assert_allclose(msf_jax.replay(again, flow.weights), nodes, atol=1e-10)
    assert playback.replay_part._cache_size() == len(replay._kinds) == 1


@pytest.mark.slow  # traces a gradient of its own
def test_reverse_mode_keeps_states_and_no_solver_steps(flow):
    """What is kept for the way back is a few surfaces an iteration, however many steps the solves take."""

    run = jax.eval_shape(lambda weights: jax.vjp(partial(msf_jax.replay, flow.tape), weights)[1], flow.weights)
    kept = sum(leaf.size * leaf.dtype.itemsize for leaf in jax.tree.leaves(run))
    states = sum(
        len(stretch.factor) * 8 * (7 * (layout.capacity + stretch.cut[0, ..., 0].size) + 6 * layout.capacity)
        for stretch, layout in zip(flow.tape.parts[0].stretches, flow.tape.layouts[0], strict=True)
    )
    assert kept < 1.5 * states + 2 * sum(np.asarray(leaf).nbytes for leaf in jax.tree.leaves(flow.tape))


@pytest.mark.slow  # so is a derivative, in test_second_derivatives
def test_an_unsolved_replay_is_nan(flow, monkeypatch):
    monkeypatch.setattr(replay, "MOST_STEPS", 2)
    assert np.isnan(msf_jax.replay(flow.tape, flow.weights)).all()


DERIVATIVES = {
    "grad": jax.grad,
    "grad of jit": lambda f: jax.grad(jax.jit(f)),
    "jvp": lambda f: lambda x: jax.jvp(f, (x,), (x,)),
    "linearize": lambda f: lambda x: jax.linearize(f, x)[0],
    "hessian": jax.hessian,
    "vmap of grad": lambda f: lambda x: jax.vmap(jax.grad(f))(x[None]),
    "grad of vmap": lambda f: jax.grad(lambda x: jax.vmap(f)(x[None]).sum()),
    "grad of checkpoint": lambda f: jax.grad(jax.checkpoint(f)),
    "grad of scan": lambda f: jax.grad(lambda x: jax.lax.scan(lambda sum, _: (sum + f(x), None), 0.0, length=2)[0]),
}


@pytest.mark.parametrize("name", DERIVATIVES)
def test_a_derivative_in_float32_is_refused_when_it_is_traced(flow, name):
    """By the weights and by the vertices; the value is not, nor one whose arguments are held fixed."""
    of_weights = lambda x: msf_jax.replay(flow.tape, Weights(*x)).sum()  # noqa: E731
    of_vertices = lambda x: msf_jax.replay_meso(flow.tape, flow.weights, x).sum()  # noqa: E731
    with jax.enable_x64(False):
        for function, at in ((of_weights, np.ones(4, np.float32)), (of_vertices, np.float32(flow.tape.vertices))):
            with pytest.raises(ConfigError, match=r"in float32.*jax_enable_x64.*or msf_jax\.follow"):
                jax.eval_shape(DERIVATIVES[name](function), at)
            assert jax.eval_shape(jax.jit(function), at).dtype == np.float32
            jax.eval_shape(DERIVATIVES[name](lambda x, f=function: f(jax.lax.stop_gradient(x))), at)


@pytest.mark.slow
def test_one_program_serves_all_tolerances_and_tapes_of_a_size(flow):
    first = np.asarray(msf_jax.replay(flow.tape, flow.weights, tolerance=1e-3))
    num_programs = playback.replay_part._cache_size()
    assert np.abs(np.asarray(msf_jax.replay(flow.tape, flow.weights)) - first).max() > 0
    for depth in (0.4, 0.41, 0.42):  # one of these may be a little too large for the program of the others
        run = msf_jax.contract(
            blob(5, 2).apply_scale([1.0, 0.5, depth]), config=dataclasses.replace(flow.config, max_iterations=2)
        )
        np.testing.assert_allclose(msf_jax.replay(run.tape, run.weights), run.curve.vertices, rtol=0, atol=1e-9)
    assert playback.replay_part._cache_size() <= num_programs + 1


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
    with pytest.raises(ConfigError, match="need a factorisation, which a replay has not"):
        msf_jax.replay(dataclasses.replace(flow.tape, config=Config.au2008()), flow.weights)
    with pytest.raises(ConfigError, match=r"w_M has shape \(3,\): expected a number, or \(162,\)"):
        msf_jax.contract(ellipsoid(), Weights(w_M=np.ones(3)))
