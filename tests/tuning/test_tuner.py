"""Tuning of numbers by fresh runs, and of fields over the vertices on one tape."""

from dataclasses import replace

import jax.numpy as jnp
import numpy as np
import pytest
import trimesh
from scipy import spatial

import msf_jax
from msf_jax import Config, ConfigError, Weights, objectives
from msf_jax.tuning import tuner
from tests.benchmarks import ground_truth

pytestmark = pytest.mark.usefixtures("few_rows")
OBJECTIVE = objectives.explained() + 0.02 * objectives.centred()
LINE = np.linspace([0, 0, 0], [2.2, 0, 0], 100)  # the axis of the tube below


def bone() -> trimesh.Trimesh:
    """A capsule that is thinner in the middle: a profile turned about the axis, as trimesh's own differ by version."""
    angle = np.radians(np.concatenate([np.arange(-90, 1, 15), np.arange(0, 91, 15)]))
    end = np.repeat([-1.0, 1.0], 7)
    mesh = trimesh.creation.revolve(np.stack([0.4 * np.cos(angle), end + 0.4 * np.sin(angle)], axis=1), sections=12)
    mesh.merge_vertices()
    mesh.vertices[:, :2] *= 0.7 + 0.3 * np.cos(np.pi * mesh.vertices[:, 2:]) ** 2
    return mesh


def tube(radius=0.12, sides=6):
    points = np.linspace([0, 0, 0], [2.2, 0, 0], 401)
    return ground_truth.swept_tube(points, np.full(401, radius), sides)


def apart(vertices, points, mesh):
    """`objectives.near` by SciPy."""
    there, back = (
        spatial.KDTree(one).query(other)[0].mean() for one, other in ((vertices, points), (points, vertices))
    )
    return (there + back) / 2 / np.linalg.norm(np.ptp(mesh.vertices, axis=0))


def test_the_finished_curve_by_fresh_runs():
    """Every value is that of a fresh run, the best is kept, and the defaults are tried first."""
    poor, bounds = Weights(10.0, 0.05, 0.1, 0.001), {"smoothing": (0.001, 0.001), "w_L": (0.01, 12.0)}
    found = msf_jax.tune(bone(), OBJECTIVE, poor, steps=3, bounds=bounds)
    taken = [step.found for step in found.trajectory if step.is_taken]
    assert len(found.trajectory) == 4 and found.value == min(taken) and taken == sorted(taken, reverse=True)
    first, usual, *proposed = [step.weights for step in found.trajectory]
    assert first == poor and usual == replace(Weights(), smoothing=0.001)
    assert all(weights.smoothing == 0.001 and weights.w_L == 10.0 for weights in proposed)  # only ratios matter
    assert found.of_defaults == found.trajectory[1].found and f"default weights: {found.of_defaults:.6g}" in str(found)
    assert ("nothing beats them" in str(found)) == (found.value == found.of_defaults)
    again = msf_jax.skeletonize(bone(), found.weights)
    np.testing.assert_array_equal(again.vertices, found.flows[0].skeleton.vertices)
    assert objectives.of_skeleton(OBJECTIVE, again, bone()) == found.value
    with pytest.raises(ConfigError, match="expected the same mesh"):
        objectives.of_skeleton(OBJECTIVE, again, trimesh.creation.box())


def test_the_defaults_are_tried_to_the_last_bit():
    """A logarithm and back would change last bits, and those can make another curve. A weight of 0 stays."""
    low, high = (dict.fromkeys(vars(Weights()), np.log(end)) for end in (1e-6, 1e4))
    for start in (Weights(w_H=0.3), Weights(w_L=5.0, smoothing=0.0)):
        within = tuner._Space(start, Weights(), low, high, tuple(vars(start)))
        assert [within.weights_at(point) for point in within.given] == [
            start,
            replace(Weights(), smoothing=start.smoothing),
        ]


def test_proposals_go_around_runs_that_break_down():
    """Where half of the space has no value and bounds are narrow; the same again, and better than the given points."""
    low, high = (dict.fromkeys(vars(Weights()), np.log(end)) for end in (1e-3, 1.2))
    within = tuner._Space(Weights(1.0, 0.5, 1.0, 0.05), Weights(), low, high, ("w_L", "w_H", "w_M", "smoothing"))
    asked, before = [], np.random.get_state()[1].copy()  # noqa: NPY002

    def value_at(point):
        assert (within.low <= point).all() and (point <= within.high).all()
        asked.append(point)
        return np.inf if point[0] < -3.0 else float(1 + ((point - [-2.5, -3.0, -5.0]) ** 2).sum())

    tuner.minimise(value_at, within, 60)
    values = [value_at(point) for point in asked[:60]]
    assert min(values) < 2.0 < 9.0 < min(values[:2])
    tuner.minimise(value_at, within, 60)
    np.testing.assert_array_equal(asked[:60], asked[-60:])
    np.testing.assert_array_equal(np.random.get_state()[1], before)  # noqa: NPY002 - NumPy's numbers are the caller's
    asked.clear()
    within = tuner._Space(Weights(w_H=0.5), Weights(), low, high, ("w_H",))  # one weight, and no value anywhere
    tuner.minimise(lambda point: asked.append(point) or np.inf, within, 20)
    assert len(np.unique(asked, axis=0)) == 20 and np.isfinite(asked).all()


def test_a_smooth_run_makes_its_iterations_and_no_decisions():
    """However little volume is left, and with the vertices that it was given."""
    mesh = tube()
    flow = msf_jax.contract(mesh, Weights(w_H=2.0), Config.smooth(4))
    assert len(flow.history) == 4 and flow.skeleton.report.reason == "all of 4 iterations made"
    assert not sum(line.collapses + line.splits + line.fixed for line in flow.history)
    assert len(flow.meso_skeleton[0]) == len(mesh.vertices) and all(line.has_ended for line in flow.history)
    assert flow.skeleton.report.converged and flow.skeleton.report.volume <= 0.02  # 2 % of the volume


def test_the_objective_of_a_surface_is_that_of_its_vertices():
    mesh = tube()
    flow = msf_jax.contract(mesh, config=Config.smooth(1))
    vertices = flow.meso_skeleton[0]
    found = float(objectives.of_surface(objectives.near(LINE), flow.tape, vertices))
    assert found == pytest.approx(apart(vertices, LINE, mesh), rel=1e-9)
    for needy in (objectives.explained(), objectives.smooth(), objectives.centred(), lambda nodes, radii: radii.mean()):
        with pytest.raises(ConfigError, match="no radii and no edges: expected one of positions only"):
            objectives.of_surface(needy, flow.tape, vertices)


@pytest.mark.slow
def test_a_weight_for_every_vertex_is_tuned_on_one_tape():
    """The fresh run at the end has the value of the tape, and SciPy finds the same."""
    mesh = tube()
    bounds = {"w_H": (0.02, 5.0), "w_M": (0.02, 5.0)}
    found = msf_jax.tune(mesh, objectives.near(LINE), of="surface", steps=4, config=Config.smooth(1), bounds=bounds)
    start, numbers, last = found.trajectory
    assert found.value == last.found == pytest.approx(last.expected, rel=tuner.AGREEMENT)
    assert last.expected < numbers.expected < start.found and found.of_defaults == pytest.approx(start.found, rel=1e-6)
    again = msf_jax.contract(mesh, found.weights, Config.smooth(1))
    assert apart(again.meso_skeleton[0], LINE, mesh) == pytest.approx(found.value, rel=1e-9)
    assert found.weights.w_H.shape == (len(mesh.vertices),) and found.weights.w_L == 1.0
    for name, (low, high) in bounds.items():
        assert (low <= getattr(found.weights, name)).all() and (getattr(found.weights, name) <= high).all()
    assert found.reason.startswith("all steps made; a fresh run has the tape's value to ")
    assert "nan" not in str(found)


@pytest.mark.parametrize(
    ("options", "says"),
    [
        ({"objective": lambda nodes, radii: nodes}, "expected one floating-point number"),
        ({"objective": lambda nodes, radii: jnp.nan * nodes.sum()}, "is nan at the start: expected a finite number"),
        ({"objective": objectives.explained}, "with its parentheses"),
        ({"weights": Weights(w_L=20.0), "bounds": (0.1, 10.0)}, "w_L is 20: expected a start within its bounds"),
        ({"weights": Weights(w_H=np.full(128, 0.1))}, "w_H is an array: expected a number"),
        ({"bounds": {"w_X": (0.1, 1.0)}}, "bounds has 'w_X': expected one of w_L"),
        ({"bounds": {"w_L": (1.0, 0.1)}}, r"bounds of w_L are \(1.0, 0.1\)"),
        ({"bounds": 3}, "bounds of w_L are 3"),
        ({"steps": 0}, "steps is 0: expected a whole number"),
        ({"of": "flow"}, "of is 'flow': expected 'skeleton' or 'surface'"),
        ({"meshes": []}, "meshes has 0 meshes: expected one"),
        ({"of": "surface", "config": Config()}, "the run edits edges: expected Config.smooth"),
        ({"of": "surface", "bounds": (0.1, 0.1), "weights": Weights(0.1, 0.1, 0.1, 0.1)}, "w_H and w_M are 0 or held"),
        ({"of": "surface", "meshes": [tube(), tube()]}, "meshes has 2 meshes: expected one"),
        ({"of": "surface", "config": Config.smooth(1)}, "no radii and no edges"),
    ],
)
def test_wrong_options(options, says):
    arguments = {"meshes": bone(), "objective": OBJECTIVE, "steps": 1} | options
    with pytest.raises(ConfigError, match=says):
        msf_jax.tune(**arguments)
