"""A short run, and what two runs of the same must have in common."""

import jax
import numpy as np

from msf_jax import Config, SolverOptions

SLOW = Config(max_iterations=7, solver=SolverOptions(step_tolerance=0.1))


def assert_same_bits(one, other):
    """Curve, map, history, tape."""
    for name in ("vertices", "edges", "radii", "mesh_map"):
        for left, right in ((one.skeleton, other.skeleton), (one.curve, other.curve)):
            np.testing.assert_array_equal(getattr(left, name), getattr(right, name))
    assert one.history == other.history
    leaves = [jax.tree_util.tree_leaves(run.tape) for run in (one, other)]
    for left, right in zip(*leaves, strict=True):
        np.testing.assert_array_equal(left, right)
