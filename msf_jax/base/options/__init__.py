"""The options of a run: weights, which are differentiable, and the configuration with its groups, which is not."""

from msf_jax.base.options.config import SYSTEMS, TIGHT, Config, Solver, StepSettings
from msf_jax.base.options.groups import (
    FACTORED,
    GROUPS,
    LAPLACIANS,
    POLES,
    SOLVED_BY,
    CurveOptions,
    FlowOptions,
    PreprocessingOptions,
    SolverOptions,
)
from msf_jax.base.options.weights import Weights, is_traced, traced

__all__ = [
    "FACTORED",
    "GROUPS",
    "LAPLACIANS",
    "POLES",
    "SOLVED_BY",
    "SYSTEMS",
    "TIGHT",
    "Config",
    "CurveOptions",
    "FlowOptions",
    "PreprocessingOptions",
    "Solver",
    "SolverOptions",
    "StepSettings",
    "Weights",
    "is_traced",
    "traced",
]
