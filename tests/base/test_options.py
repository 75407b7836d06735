"""Options say what is wrong with them; weights are a pytree."""

import dataclasses

import jax
import jax.numpy as jnp
import numpy as np
import pytest
import trimesh

import msf_jax
from msf_jax import Config, ConfigError, CurveOptions, FlowOptions, PreprocessingOptions, SolverOptions, Weights
from msf_jax.app.parser import whole_parser
from msf_jax.base.options import StepSettings


@pytest.mark.parametrize(
    "bad",
    [
        {"w_L": -1.0},
        {"w_H": float("nan")},
        {"w_M": float("inf")},
        {"w_H": 0},
        {"smoothing": "a"},
        {"w_H": np.array(-1.0)},
        {"w_M": None},
    ],
)
def test_a_weight_out_of_range_is_named(bad):
    with pytest.raises(ConfigError, match=next(iter(bad))):
        Weights(**bad)


@pytest.mark.parametrize(
    ("kind", "bad", "message"),
    [
        (
            SolverOptions,
            {"preconditioner": "ilu"},
            "preconditioner is 'ilu': expected one of jacobi, factored",
        ),
        (CurveOptions, {"surgery": 1}, "CurveOptions.surgery is 1: expected True or False"),
        (FlowOptions, {"laplacian": "cot"}, "FlowOptions.laplacian is 'cot': expected one of mean_value"),
        (FlowOptions, {"threshold_min": -0.1}, "FlowOptions.threshold_min is -0.1"),
        (FlowOptions, {"threshold_min": 0.02}, "below threshold_min"),
        (FlowOptions, {"split_angle": 60}, "FlowOptions.split_angle is 60: expected a number from 90 to 180"),
        (Config, {"max_iterations": 0}, "Config.max_iterations"),
        (Config, {"max_iterations": True}, "Config.max_iterations"),
        (Config, {"max_iterations": 1.5}, "Config.max_iterations is 1.5: expected a whole number"),
        (Config, {"detail": 1.5}, "Config.detail is 1.5: expected a number from 0 to 1"),
        (Config, {"evaluate": 1}, "Config.evaluate is 1: expected True or False"),
        (PreprocessingOptions, {"use_poles": "no"}, "PreprocessingOptions.use_poles is 'no': expected True or False"),
        (PreprocessingOptions, {"resample": 1e-9}, "PreprocessingOptions.resample"),
        (FlowOptions, {"w_H_follows_area": True}, "edit_connectivity=False"),
        (SolverOptions, {"tolerance": "loose"}, "SolverOptions.tolerance"),
        (PreprocessingOptions, {"reconstruct_poles": 2}, "fewer than 4 eigenvectors"),
        (Config, {"flow": 3}, "Config.flow is a int: expected a msf_jax.FlowOptions"),
    ],
)
def test_an_option_out_of_range_is_named(kind, bad, message):
    with pytest.raises(ConfigError, match=message):
        kind(**bad)


def test_weights_are_a_pytree_that_gradients_flow_through():
    gradient = jax.grad(lambda w: w.w_L**2 + 3 * w.w_M)(Weights(w_L=2.0, w_M=1.0))
    assert isinstance(gradient, Weights)
    assert float(gradient.w_L) == 4.0
    assert float(gradient.w_M) == 3.0
    stacked = jax.vmap(lambda x: Weights(w_L=x))(jnp.arange(3.0))
    assert stacked.w_L.shape == (3,)


def test_a_step_depends_on_these_options_and_on_no_others():
    """All fields of its settings come from the options, none from a default that nobody chose."""
    other = {"tolerance": 1e-4, "max_steps": 7, "step_tolerance": 0.5, "preconditioner": "factored"}
    for name, value in other.items():
        assert Config(solver=SolverOptions(**{name: value})).on_device != Config().on_device
    assert Config(flow=FlowOptions(laplacian="uniform")).on_device != Config().on_device
    assert Config.au2008(flow={"laplacian": "mean_value"}).on_device != Config().on_device
    others = Config(least_slenderness=0.0, coarsen=0.0, max_iterations=3, flow=FlowOptions(threshold_min=0.004))
    assert others.on_device == Config().on_device
    settings = Config().on_device._asdict()
    assert set(settings) == {"laplacian", "solver", "w_H_follows_area"}
    for name in settings:
        with pytest.raises(TypeError, match=name):
            StepSettings(**{key: value for key, value in settings.items() if key != name})


def test_weights_are_equal_by_their_numbers():
    assert Weights(w_L=np.ones(3)) == Weights(w_L=jnp.ones(3)) != Weights(w_L=np.array([1.0, 1.0, 2.0]))
    assert Weights() == Weights() != Weights(w_L=np.ones(3)) and hash(Weights()) == hash(Weights())
    assert Weights() != (1.0, 0.1, 0.4, 0.001)
    assert not jax.jit(lambda weights: weights == Weights())(Weights())  # no number is known yet


def test_a_system_is_no_word_beside_the_options_of_another():
    """`Config(system="au2008")` was a run of the default system with other weights."""
    for wrong in (lambda: Config(system="au2008"), lambda: Config().replace(system="au2008")):
        with pytest.raises(ConfigError, match=r"Config\.named"):
            wrong()
    assert dataclasses.replace(Config.au2008(), detail=0.6) == Config.au2008(detail=0.6)
    for name in ("msf", "tagliasacchi2012", "au2008"):
        assert Config.named(name).system == name


def test_changes_of_a_group_leave_its_other_values():
    slow = Config.au2008(flow={"w_L_growth": 1.2}, max_iterations=9)
    assert (slow.flow.w_L_growth, slow.flow.w_H_follows_area, slow.max_iterations) == (1.2, True, 9)
    assert slow.replace(flow={"w_L_growth": 2.0}, max_iterations=200) == Config.au2008()
    whole = slow.replace(flow=FlowOptions(edit_connectivity=False))
    assert whole.flow == FlowOptions(edit_connectivity=False) and whole.curve == slow.curve and whole.system == "au2008"
    for wrong in (lambda: slow.replace(flow={"growth": 1.0}), lambda: Config(growths=1.0)):
        with pytest.raises(TypeError, match="growth"):
            wrong()


def test_a_skeleton_is_the_same_after_a_map_of_its_leaves():
    """Its unit, what its radii mean, and its openings are no leaves."""
    skeleton = msf_jax.skeletonize(trimesh.creation.capsule(3.0, 0.5, [12, 12]))
    skeleton = dataclasses.replace(skeleton, units="nm", radius_of="section", openings=(1,))
    mapped = jax.tree.map(lambda leaf: leaf, skeleton)
    for field in dataclasses.fields(skeleton):
        assert getattr(mapped, field.name) is getattr(skeleton, field.name)


def test_the_command_line_has_the_names_of_options_in_messages():
    """An error names `Config.least_slenderness`; ``--prune`` is its short name."""
    for option in ("--prune", "--least-slenderness"):
        assert whole_parser().parse_args(["skeletonize", "hand.off", option, "3"]).least_slenderness == 3
