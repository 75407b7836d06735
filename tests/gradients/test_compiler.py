"""The sums of a step against NumPy at sizes where a compiler was wrong, compiled with and without optimisation."""

import os

import jax
import jax.numpy as jnp
import pytest

from msf_jax import FlowError
from msf_jax.gradients import compiler

DTYPES = ("float32", "float64")


@pytest.mark.parametrize("dtype", DTYPES)
@pytest.mark.parametrize("level", [0, 3])
def test_sums_are_those_of_numpy(dtype, level):
    """At level 3, as users compile; other tests do without (see conftest)."""
    emitters = "xla_cpu_use_fusion_emitters"
    emitters = {emitters: level == 3} if emitters in os.environ["XLA_FLAGS"] else {}
    compiler.check_sums(dtype, options={"xla_backend_optimization_level": level, **emitters})


@pytest.mark.parametrize("dtype", DTYPES)
@pytest.mark.parametrize("name", compiler.SUMS)
def test_a_wrong_sum_is_named(name, dtype):
    """One entry of the last row is too large by one, or the whole sum."""

    def wrong(*given):
        right = compiler.SUMS[name](*given)
        return right.at[(-1,) * right.ndim].add(1)

    with pytest.raises(FlowError, match=rf"jax {jax.__version__} and jaxlib .*{dtype}.*of {name} differ.*install"):
        compiler.check_sums(dtype, {**compiler.SUMS, name: wrong})


def test_it_is_checked_once_also_inside_a_users_program(monkeypatch):
    checked = []
    monkeypatch.setattr(compiler, "_right", set())
    monkeypatch.setattr(compiler, "check_sums", checked.append)
    compiler.check()
    compiler.check()
    assert checked == ["float32", "float64"]
    monkeypatch.undo()

    @jax.jit
    def program(x):
        compiler.check_sums("float64")
        return jnp.sin(x)

    assert program(0.0) == 0
