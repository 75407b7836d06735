"""Runs that many tests look at, a short run, and what two runs of the same must have in common."""

from functools import cache

import jax
import numpy as np

import msf_jax
from msf_jax import Config, Flow, SolverOptions, ground_truth

SLOW = Config(max_iterations=5, solver=SolverOptions(step_tolerance=0.1))


@cache
def flow_of(name: str) -> Flow:
    """The run of a known shape with the defaults, once in a process: for tests that change nothing in it."""
    return msf_jax.contract(ground_truth.make(name).mesh)


def assert_same_bits(one, other):
    """Curve, map, history, tape."""
    for name in ("vertices", "edges", "radii", "mesh_map"):
        for left, right in ((one.skeleton, other.skeleton), (one.curve, other.curve)):
            np.testing.assert_array_equal(getattr(left, name), getattr(right, name))
    assert one.history == other.history
    leaves = [jax.tree_util.tree_leaves(run.tape) for run in (one, other)]
    for left, right in zip(*leaves, strict=True):
        np.testing.assert_array_equal(left, right)
