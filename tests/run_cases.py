"""Runs that many tests look at, a short run, and what two runs of the same must have in common."""

from functools import cache

import msf_jax
from msf_jax import Config, Flow, SolverOptions
from tests.benchmarks import ground_truth

SLOW = Config(max_iterations=5, solver=SolverOptions(step_tolerance=0.1))


@cache
def flow_of(name: str) -> Flow:
    """The run of a known shape with the defaults, once in a process: for tests that change nothing in it."""
    return msf_jax.contract(ground_truth.make(name).mesh)
