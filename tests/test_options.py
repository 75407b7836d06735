"""Options say what is wrong with them; weights are a pytree."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

import msf_jax
from msf_jax import Config, ConfigError, Weights
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
    ("bad", "message"),
    [
        ({"preconditioner": "ilu"}, "unknown preconditioner 'ilu': expected one of jacobi, factored"),
        ({"surgery": 1}, "Config.surgery is 1: expected True or False"),
        ({"weights_of": "mcf"}, "unknown system 'mcf': expected one of msf, tagliasacchi2012, au2008"),
        ({"laplacian": "cot"}, "unknown Laplacian 'cot'"),
        ({"t_min": -0.1}, "Config.t_min is -0.1"),
        ({"t_min": 0.02}, "below t_min"),
        ({"split_angle": 60}, "Config.split_angle is 60: expected a number from 90 to 180"),
        ({"max_iterations": 0}, "Config.max_iterations"),
        ({"max_iterations": True}, "Config.max_iterations"),
        ({"max_iterations": 1.5}, "Config.max_iterations is 1.5: expected a whole number"),
        ({"use_poles": "no"}, "Config.use_poles is 'no': expected True or False"),
        ({"resample": 1e-9}, "Config.resample"),
        ({"w_H_follows_area": True}, "edit_connectivity=False"),
        ({"solve_tolerance": "loose"}, "Config.solve_tolerance"),
        ({"reconstruct_poles": 2}, "fewer than 4 eigenvectors"),
    ],
)
def test_an_option_out_of_range_is_named(bad, message):
    with pytest.raises(ConfigError, match=message):
        Config(**bad)


def test_a_config_is_hashable_and_equal_by_value():
    assert hash(Config()) == hash(Config())
    assert Config() == Config.named("msf")
    assert Config.tagliasacchi2012() != Config.au2008()


def test_an_unknown_system_is_named():
    with pytest.raises(ConfigError, match=r"unknown system 'cgal'"):
        Config.named("cgal")


def test_the_three_systems_differ_as_their_papers_do():
    ours, tagliasacchi, au = Config(), Config.tagliasacchi2012(), Config.au2008()
    assert (ours.laplacian, tagliasacchi.laplacian, au.laplacian) == ("mean_value", "cotangent", "signed_cotangent")
    assert ours.t_step > 0
    assert tagliasacchi.t_step == 0
    assert tagliasacchi.resample > 0
    assert not au.use_poles
    assert au.growth > 1
    assert au.w_H_follows_area
    assert au.surgery
    assert (ours.preconditioner, tagliasacchi.preconditioner, au.preconditioner) == ("jacobi", "jacobi", "factored")
    assert au.default_weights().w_M == 0
    assert tagliasacchi.default_weights().smoothing == 0


def test_weights_are_a_pytree_that_gradients_flow_through():
    gradient = jax.grad(lambda w: w.w_L**2 + 3 * w.w_M)(Weights(w_L=2.0, w_M=1.0))
    assert isinstance(gradient, Weights)
    assert float(gradient.w_L) == 4.0
    assert float(gradient.w_M) == 3.0
    stacked = jax.vmap(lambda x: Weights(w_L=x))(jnp.arange(3.0))
    assert stacked.w_L.shape == (3,)


def test_the_wrong_kind_of_options_is_refused():
    with pytest.raises(ConfigError, match=r"config is a dict"):
        msf_jax.contract((None, None), config={"system": "msf"})  # type: ignore[arg-type]
    with pytest.raises(ConfigError, match=r"weights is a float"):
        msf_jax.contract((None, None), weights=1.0)  # type: ignore[arg-type]


def test_jax_may_put_anything_into_a_tree_of_weights():
    assert jax.tree_util.tree_map(lambda w: -w, Weights()).w_H == -Weights().w_H
    axes = Weights(w_L=0.0, w_H=1.0)
    axes = jax.tree_util.tree_map(lambda _: 0, axes)
    total = jax.vmap(lambda w: w.w_L + w.w_H, in_axes=(axes,))(jax.tree_util.tree_map(jnp.atleast_1d, Weights()))
    assert total.shape == (1,)


def test_a_step_depends_on_these_options_and_on_no_others():
    """All fields of its settings come from the options, none from a default that nobody chose."""
    other = {"laplacian": "uniform", "solve_tolerance": 1e-4, "solve_steps": 7, "step_tolerance": 0.5}
    other["preconditioner"] = "factored"
    for name, value in other.items():
        assert Config(**{name: value}).on_device != Config().on_device
    assert Config.au2008(laplacian="mean_value").on_device != Config().on_device
    assert Config(t_min=0.004, prune=0.0, coarsen=0.0, max_iterations=3).on_device == Config().on_device
    settings = vars(Config().on_device)
    assert set(settings) == {"laplacian", "solver", "step_tolerance", "w_H_follows_area"}
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
    with pytest.raises(TypeError, match="system"):
        Config(system="au2008")  # type: ignore[call-arg]  # pyright: ignore[reportCallIssue]
    for name in ("msf", "tagliasacchi2012", "au2008"):
        assert Config.named(name).weights_of == name
