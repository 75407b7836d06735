"""Tuning of weights as fields over the vertices on one tape, and the runs without decisions that it needs."""

import jax.numpy as jnp
import numpy as np
import pytest
from scipy import spatial

import msf_jax
from msf_jax import Config, ConfigError, Weights
from tests.benchmarks import ground_truth
from tests.benchmarks.tuning import near

pytestmark = pytest.mark.usefixtures("few_rows")
LINE = np.linspace([0, 0, 0], [2.2, 0, 0], 100)  # the axis of the tube below


def tube(radius=0.12, sides=6):
    points = np.linspace([0, 0, 0], [2.2, 0, 0], 401)
    return ground_truth.swept_tube(points, np.full(401, radius), sides)


def apart(vertices, points):
    """`near` by SciPy."""
    pairs = (vertices, points), (points, vertices)
    return np.mean([spatial.KDTree(one).query(other)[0].mean() for one, other in pairs])


def test_a_smooth_run_makes_its_iterations_and_no_decisions():
    """However little volume is left, and with the vertices that it was given."""
    mesh = tube()
    flow = msf_jax.contract(mesh, Weights(w_H=2.0), Config.smooth(4))
    assert len(flow.history) == 4 and flow.skeleton.report.reason == "all of 4 iterations made"
    assert not sum(line.collapses + line.splits + line.fixed for line in flow.history)
    assert len(flow.meso_skeleton[0]) == len(mesh.vertices) and all(line.has_ended for line in flow.history)
    assert flow.skeleton.report.converged and flow.skeleton.report.volume <= 0.02  # 2 % of the volume


@pytest.mark.slow
def test_a_weight_for_every_vertex_is_tuned_on_one_tape():
    """The fresh run at the end has the value of the tape, and SciPy finds the same."""
    mesh = tube()
    found = msf_jax.tune(mesh, near(LINE), steps=4, config=Config.smooth(1), bounds=(0.02, 5.0))
    assert len(found.trajectory) == 1 + 4 * 4 + 5 and found.value == pytest.approx(found.trajectory.min(), rel=1e-3)
    before = msf_jax.contract(mesh, config=Config.smooth(1))
    assert found.value < 0.9 * found.trajectory[0]
    assert found.trajectory[0] == pytest.approx(apart(before.meso_skeleton[0], LINE), rel=1e-3)
    again = msf_jax.contract(mesh, found.weights, Config.smooth(1).tight())
    np.testing.assert_array_equal(again.meso_skeleton[0], found.flow.meso_skeleton[0])
    assert apart(again.meso_skeleton[0], LINE) == pytest.approx(found.value, rel=1e-9)
    assert found.weights.w_L == 1.0 and found.weights.smoothing == 0.001
    for field in (found.weights.w_H, found.weights.w_M):
        assert field.shape == (len(mesh.vertices),) and (field >= 0.02).all() and (field <= 5.0).all()


@pytest.mark.parametrize(
    ("options", "says"),
    [
        (
            {"objective": lambda vertices: vertices},
            r"returned float64 of shape \(\d+, 3\): expected one floating-point",
        ),
        ({"objective": len}, "returned int.*: expected one floating-point number"),
        ({"objective": lambda vertices: None}, "returned NoneType: expected a number"),
        pytest.param(
            {"objective": lambda vertices: jnp.nan * vertices.sum()},
            "is nan at the start: expected a finite number",
            marks=pytest.mark.slow,
        ),
        ({"objective": 3.0}, "objective is a float: expected a function of"),
        ({"weights": Weights(w_H=20.0), "bounds": (0.1, 10.0)}, "w_H is 20 to 20: expected a start within 0.1 to 10"),
        ({"bounds": (1.0, 0.1)}, r"bounds is \(1.0, 0.1\)"),
        ({"bounds": 3}, "bounds is 3"),
        ({"steps": 0}, "steps is 0: expected a whole number"),
        ({"config": Config()}, "the run edits edges: expected Config.smooth"),
    ],
)
def test_wrong_options(options, says):
    arguments = {"mesh": tube(), "objective": near(LINE), "steps": 1, "config": Config.smooth(1)} | options
    with pytest.raises(ConfigError, match=says):
        msf_jax.tune(**arguments)
