"""Tuning by fresh runs and by gradient, and sensitivity."""

import json
from dataclasses import replace
from functools import partial

import jax
import jax.numpy as jnp
import numpy as np
import pytest
import trimesh
from device_cases import central_difference

import msf_jax
from msf_jax import Config, ConfigError, Weights, objectives
from msf_jax.tuning import gradient, tuner
from msf_jax.tuning.search import Search

pytestmark = pytest.mark.usefixtures("few_rows")


def bone() -> trimesh.Trimesh:
    """A capsule that is thinner in the middle: a profile turned about the axis, as trimesh's own differ by version."""
    angle = np.radians(np.concatenate([np.arange(-90, 1, 15), np.arange(0, 91, 15)]))
    end = np.repeat([-1.0, 1.0], 7)
    mesh = trimesh.creation.revolve(np.stack([0.4 * np.cos(angle), end + 0.4 * np.sin(angle)], axis=1), sections=12)
    mesh.merge_vertices()
    mesh.vertices[:, :2] *= 0.7 + 0.3 * np.cos(np.pi * mesh.vertices[:, 2:]) ** 2
    return mesh


OBJECTIVE = objectives.explained() + 0.02 * objectives.centred()


def check_taken(found, steps):
    """Each proposal that was taken is better than those before, and the last one is the result."""
    taken = [step.found for step in found.trajectory if step.is_taken]
    assert found.value == min(taken) and taken == sorted(taken, reverse=True)
    assert len(found.trajectory) <= steps + 2 and found.reason


@pytest.mark.slow  # the way by fresh runs is quick
def test_poor_weights_get_better():
    """Every value is a fresh run's, the best is kept, and no weight leaves its bounds. More steps: below."""
    poor = Weights(10.0, 0.05, 0.1, 0.001)
    found = msf_jax.tune(bone(), OBJECTIVE, poor, of="flow", steps=1, inner_steps=1, bounds={"w_L": (0.01, 12.0)})
    values = [step.found for step in found.trajectory]
    check_taken(found, 1)
    assert found.value < values[0]
    config = found.flows[0].config
    assert (config.solver.tolerance, config.solver.step_tolerance) == (1e-6, 0.0)  # else tapes do not predict runs
    again = msf_jax.contract(bone(), found.weights, config)
    assert objectives.value(OBJECTIVE, again.tape, again.weights) == pytest.approx(found.value, rel=1e-6)
    assert all(0.01 <= float(step.weights.w_L) <= 12.0 for step in found.trajectory)
    assert found.trajectory[1].weights == Weights() and found.of_defaults == values[1]  # they are tried first
    assert ("nothing beats them" in str(found)) == (found.value == found.of_defaults)
    last = found.trajectory[-1]
    assert 0 < last.changed.different <= last.changed.total
    assert str(found).count("\n") == len(found.trajectory) + 2


@pytest.mark.slow
def test_a_run_that_does_not_converge_has_no_use():
    """The defaults are tried; where they do not converge either, nothing is proposed."""
    stuck = Weights(0.01, 1.0, 4.0, 0.0)
    found = msf_jax.tune(bone(), OBJECTIVE, stuck, config=Config(max_iterations=1), of="flow", steps=1)
    assert found.reason == "runs do not converge (max_iterations (1) reached)" and len(found.trajectory) == 2
    tried = found.trajectory[1].weights
    assert tried.w_L == pytest.approx(1.0) and tried.w_M == pytest.approx(0.4) and tried.smoothing == 0.0


@pytest.mark.slow
def test_tapes_of_one_mesh_share_programs(compilations):
    """A tape in the buffers of the one before: of two more steps, the objective alone is compiled again."""
    numbers = []
    for steps in (1, 3):
        compilations.clear()
        found = msf_jax.tune(bone(), OBJECTIVE, Weights(w_H=0.2), of="flow", steps=steps, inner_steps=1)
        numbers.append(len(compilations))
        check_taken(found, steps)
    assert numbers[1] <= 6 and len(found.trajectory) > 3


def test_the_finished_curve_by_fresh_runs(tmp_path):
    """Every value is that of a fresh run; a second call knows them, and ends the same; another tuning's file is not."""
    poor, path = Weights(10.0, 0.05, 0.1, 0.001), tmp_path / "tune.json"
    arguments = {"steps": 2, "bounds": {"smoothing": (0.001, 0.001)}, "checkpoint": path}
    found = msf_jax.tune(bone(), OBJECTIVE, poor, **arguments)
    assert found.value == min(step.found for step in found.trajectory) <= found.trajectory[0].found
    assert found.of_defaults == found.trajectory[1].found and f"default weights: {found.of_defaults:.6g}" in str(found)
    assert all(step.weights.smoothing == 0.001 and step.weights.w_L == 10.0 for step in found.trajectory)
    again = msf_jax.skeletonize(bone(), found.weights)
    np.testing.assert_array_equal(again.vertices, found.flows[0].skeleton.vertices)
    assert objectives.of_skeleton(OBJECTIVE, again, bone()) == found.value
    with pytest.raises(ConfigError, match="expected the same mesh"):
        objectives.of_skeleton(OBJECTIVE, again, trimesh.creation.box())
    known = json.loads(path.read_text())
    assert len(known["values"]) == 3
    known["values"] = {name: [value - 1.0, good] for name, (value, good) in known["values"].items()}
    path.write_text(json.dumps(known))
    resumed = msf_jax.tune(bone(), OBJECTIVE, poor, **arguments)
    assert resumed.value == pytest.approx(found.value - 1.0) and resumed.weights == found.weights
    with pytest.raises(ConfigError, match="is of another tuning"):
        msf_jax.tune(bone(), objectives.smooth(), poor, **arguments)
    for content in ("{}", "[" * 100_000):
        path.write_text(content)
        with pytest.raises(ConfigError, match="is no checkpoint of a tuning"):
            msf_jax.tune(bone(), OBJECTIVE, poor, **arguments)


@pytest.mark.slow
def test_the_defaults_are_tried_to_the_last_bit():
    """A logarithm and back would change last bits, and those can make another curve."""
    found = msf_jax.tune(bone(), OBJECTIVE, Weights(w_H=0.3), steps=1)
    assert found.trajectory[1].weights == Weights()
    held = msf_jax.tune(bone(), OBJECTIVE, Weights(w_H=0.3, smoothing=0.0), steps=1)
    assert held.trajectory[1].weights.smoothing == 0.0 and held.trajectory[1].weights.w_H == pytest.approx(0.1)


def bowl(point):
    """Curved, and with jumps of one in a hundred, as a run's decisions make them."""
    lowest, shape = np.array([0.8, -0.6, 0.4]), np.array([[1.0, 0.5, 0.0], [0.0, 1.5, 0.3], [0.2, 0.0, 0.7]])
    jump = np.sin(1e4 * np.round(point, 1) @ np.array([1.0, 2.0, 3.0]))
    return (1.0 + np.log1p(((shape @ (point - lowest)) ** 2).sum())) * (1 + 0.01 * jump)


def test_the_search_beats_chance():
    """At 30 values, from ten starts: better than as many random points in the median, and never far off."""
    low, high = np.full(3, -14.0), np.full(3, 9.0)
    ours, chance = [], []
    for seed in range(10):
        random = np.random.default_rng(seed)
        start = 2.3 * np.sign(random.normal(size=3))
        search = Search([start, np.zeros(3)], low, high, seed)
        for _ in range(15):
            points = search.ask(2)
            assert (points >= low).all() and (points <= high).all() and len(np.unique(points, axis=0)) == 2
            search.tell(points, np.array([bowl(point) for point in points]))
        ours.append(search.values.min())
        around = random.uniform(np.minimum(start, 0) - 1.1, np.maximum(start, 0) + 1.1, size=(30, 3))
        chance.append(min(bowl(point) for point in around))
    assert np.median(ours) < 1.1 < np.median(chance) and max(ours) < 1.3


def test_the_search_goes_around_runs_that_break_down():
    """Where half of the space has no value, bounds are narrow, and points repeat; twice, it asks for the same."""
    asked = []
    for _ in range(2):
        search = Search([np.array([1.0, 1.0])], np.array([0.0, 0.0]), np.array([1.5, 1.5]))
        for _ in range(25):
            point = search.ask()
            search.tell(point, np.array([np.inf if point[0, 0] < 0.5 else float((point**2).sum())]))
        asked.append(search.points)
    np.testing.assert_array_equal(*asked)
    assert search.values.min() < 0.45  # of 2 at the start, and 0.25 at best


def test_the_search_goes_on_while_all_runs_break_down():
    search = Search([np.array([1.0, 1.0]), np.zeros(2)], np.full(2, -9.0), np.full(2, 9.0))
    for _ in range(15):
        points = search.ask()
        assert np.isnan(search.expected(points)).all()
        search.tell(points, np.array([np.inf]))
    assert len(np.unique(search.points, axis=0)) == 15 and (np.abs(search.points) <= 9.0).all()


@pytest.mark.slow
def test_several_meshes_and_a_function_of_ones_own():
    wider = bone()
    wider.apply_scale([1.3, 1.3, 1.0])
    found = msf_jax.tune([bone(), wider], lambda nodes, radii: -radii.mean(), steps=1)
    assert len(found.flows) == 2
    expected = -np.mean([run.skeleton.radii.mean() for run in found.flows])
    assert found.value == pytest.approx(expected)


@pytest.mark.parametrize(
    ("options", "says"),
    [
        ({"objective": lambda nodes, radii: nodes}, "expected one number"),
        ({"objective": lambda nodes, radii: jnp.nan * nodes.sum()}, "is nan at the start: expected a finite number"),
        ({"objective": "explained"}, "objective is a str"),
        ({"weights": (1.0, 0.1)}, "weights is a tuple"),
        ({"weights": Weights(w_L=20.0), "bounds": (0.1, 10.0)}, "w_L is 20: expected a start within its bounds"),
        ({"bounds": {"w_X": (0.1, 1.0)}}, "bounds has 'w_X': expected one of w_L"),
        ({"bounds": {"w_L": (1.0, 0.1)}}, r"bounds of w_L are \(1.0, 0.1\)"),
        ({"objective": lambda nodes: nodes.sum()}, r"objective is a function, .*: expected one of"),
        ({"objective": objectives.explained}, "with its parentheses"),
        ({"bounds": 3}, "bounds of w_L are 3"),
        ({"steps": 0}, "steps is 0: expected a whole number"),
        ({"config": Weights()}, "config is a Weights"),
        ({"of": "curve"}, "of is 'curve': expected one of skeleton, flow"),
        ({"jobs": 0}, "jobs is 0: expected a whole number"),
        ({"of": "flow", "jobs": 2}, "jobs or checkpoint was given with arrays of weights"),
    ],
)
def test_wrong_options(options, says):
    arguments = {"objective": OBJECTIVE, "weights": None} | options
    with pytest.raises(ConfigError, match=says):
        msf_jax.tune(bone(), arguments.pop("objective"), arguments.pop("weights"), **arguments)


def test_no_mesh():
    with pytest.raises(ConfigError, match="meshes is empty"):
        msf_jax.tune([], OBJECTIVE)


def test_one_mesh_or_many():
    pair = (np.zeros((4, 3)), np.zeros((2, 3)))
    assert tuner._listed(pair) == [pair]
    assert tuner._listed([pair, pair]) == [pair, pair]
    assert tuner._listed("a.off") == ["a.off"]
    assert tuner._listed(["a.off", bone()])[0] == "a.off"
    assert len(tuner._listed([bone()])) == 1


@pytest.mark.slow  # its derivatives are those that the replay's own tests compare
def test_sensitivity():
    """To a weight and a vertex by central differences; by columns and by rows it is the same."""
    mesh = trimesh.creation.icosphere(2)
    mesh.apply_scale([1.0, 0.4, 0.4])
    flow = msf_jax.contract(mesh, config=Config(max_iterations=4))
    with pytest.warns(UserWarning, match=r"the tape is of a run with loose solves.*expected that of contract"):
        found = msf_jax.sensitivity(flow.tape, tolerance=1e-14)
    assert found.weights == flow.weights
    towards = np.random.default_rng(0).normal(size=flow.curve.vertices.shape)
    replayed = jax.jit(partial(msf_jax.replay, tolerance=1e-15))

    def along(w_M):
        return (towards * replayed(flow.tape, Weights(w_M=w_M))).sum()

    assert (towards * found.by_weight.w_M).sum() == pytest.approx(central_difference(along, 0.4, 1.0, 1e-6), rel=1e-5)
    column, row = found.of_vertex(7), found.of_node(2)
    np.testing.assert_allclose(column[2], row[7], atol=1e-9)
    assert column.shape == (len(towards), 3, 3) and row.shape == (162, 3, 3)
    np.testing.assert_allclose(row.sum(axis=0), np.eye(3), atol=1e-7)  # a mesh that moves as a whole moves its nodes
    for wrong in (lambda: found.of_vertex(162), lambda: found.of_node(-1), lambda: found.of_vertex(1.5)):
        with pytest.raises(ConfigError, match="expected a number from 0 to"):
            wrong()
    with pytest.raises(ConfigError, match="tape is a Flow: expected a Tape"):
        msf_jax.sensitivity(flow)
    tight = replace(flow.tape, config=flow.tape.config.tight())  # it warns of nothing
    with pytest.raises(ConfigError, match=r"w_L has shape \(2,\): expected a number"):
        msf_jax.sensitivity(tight, Weights(w_L=np.ones(2)))


def test_weights_at_bounds_that_the_slope_leads_out_of_try_the_other_direction(monkeypatch):
    """A slope of 1 in each weight, all at their lower bounds; and no slope, or no other weights, for no proposal."""
    here = gradient.logarithms(Weights())
    low, high = ({name: float(value) + side for name, value in here.items()} for side in (0, 1))
    slope = {name: np.ones_like(value) for name, value in here.items()}
    monkeypatch.setattr(gradient, "_mean_value", lambda *_: (1.0, slope))
    there, _, kind = gradient.proposal(OBJECTIVE, Weights(), [], here, 0.5, low, high, gradient.DOWN, 3)
    assert kind == gradient.UP and gradient.distance(here, there) == pytest.approx(0.5)
    assert gradient.distance(here, gradient.proposal(OBJECTIVE, Weights(), [], here, 0.5, low, low, 1, 3)[0]) == 0
    slope = {name: np.zeros_like(value) for name, value in here.items()}
    assert gradient.distance(here, gradient.proposal(OBJECTIVE, Weights(), [], here, 0.5, low, high, 1, 3)[0]) == 0
