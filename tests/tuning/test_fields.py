"""Runs without decisions, and weights as fields over the vertices, tuned on one tape."""

import jax.numpy as jnp
import numpy as np
import pytest
from scipy import spatial

import msf_jax
from msf_jax import Config, ConfigError, Weights, ground_truth, objectives
from msf_jax.tuning import surface

pytestmark = pytest.mark.usefixtures("few_rows")
LINE = np.linspace([0, 0, 0], [2.2, 0, 0], 100)  # the axis of the tube below


def tube(radius=0.12, sides=6):
    points = np.linspace([0, 0, 0], [2.2, 0, 0], 401)
    return ground_truth.swept_tube(points, np.full(401, radius), sides)


def apart(vertices, points, mesh):
    """`objectives.near` by SciPy."""
    there, back = (
        spatial.KDTree(one).query(other)[0].mean() for one, other in ((vertices, points), (points, vertices))
    )
    return (there + back) / 2 / np.linalg.norm(np.ptp(mesh.vertices, axis=0))


@pytest.mark.parametrize("iterations", [1, 4])
def test_a_smooth_run_makes_its_iterations_and_no_decisions(iterations):
    """However little volume is left, and with the vertices that it was given."""
    mesh = tube()
    flow = msf_jax.contract(mesh, Weights(w_H=2.0), Config.smooth(iterations))
    assert len(flow.history) == iterations
    assert not sum(line.collapses + line.splits + line.fixed for line in flow.history)
    assert len(flow.meso_skeleton[0]) == len(mesh.vertices) and all(line.has_ended for line in flow.history)
    report = flow.skeleton.report
    assert report.reason == f"all of {iterations} iterations made"
    assert report.converged == (report.volume <= 0.02) == (iterations == 4)  # 2 % of the volume, as where it settles


def test_a_smooth_config_takes_changes():
    assert Config.smooth(9) == Config.smooth(9, coarsen=0.0) != Config.smooth(9, coarsen=0.01)
    assert Config.smooth(9).max_iterations == 9


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
    held = {"w_H": (0.02, 5.0), "w_M": (0.02, 5.0)}
    found = msf_jax.tune(mesh, objectives.near(LINE), of="surface", steps=4, config=Config.smooth(1), bounds=held)
    start, numbers, last = found.trajectory
    assert found.value == last.found == pytest.approx(last.expected, rel=surface.AGREEMENT)
    assert last.expected < numbers.expected < start.found == start.expected
    again = msf_jax.contract(mesh, found.weights, Config.smooth(1))
    assert apart(again.meso_skeleton[0], LINE, mesh) == pytest.approx(found.value, rel=1e-9)
    assert found.weights.w_H.shape == (len(mesh.vertices),) and found.weights.w_L == 1.0
    for name, (low, high) in held.items():
        assert (low <= getattr(found.weights, name)).all() and (getattr(found.weights, name) <= high).all()
    assert found.reason.startswith("all steps made; a fresh run has the tape's value to ")
    assert str(found).count("\n") == 5 and "nan" not in str(found)


@pytest.mark.parametrize(
    ("options", "says"),
    [
        ({"config": Config()}, "the run edits edges: expected numbers, and Config.smooth"),
        ({"weights": Weights(w_H=np.full(128, 0.1))}, "has weights per vertex already"),
        ({"bounds": (0.1, 0.1), "weights": Weights(0.1, 0.1, 0.1, 0.1)}, "w_H and w_M are 0 or held"),
        ({"objective": [objectives.near(LINE)] * 2}, "objective"),
        ({"meshes": [tube(), tube()]}, "with 2 meshes: expected one, whose vertices have weights"),
        ({"objective": objectives.explained()}, "no radii and no edges"),
        ({"objective": lambda nodes, radii: jnp.inf * nodes.sum()}, "is (inf|nan) at the start"),
        ({"jobs": 2}, "jobs or checkpoint was given with arrays of weights or of='surface'"),
    ],
)
def test_wrong_options(options, says):
    arguments = {"meshes": tube(), "objective": objectives.near(LINE), "config": Config.smooth(1)} | options
    with pytest.raises(ConfigError, match=says):
        msf_jax.tune(of="surface", steps=1, **arguments)
