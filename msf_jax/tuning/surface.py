"""Tuning of the contracted surface on one tape: a weight for every vertex.

With `Config.smooth` a run takes no decisions, so the replay of one tape is the run, at any weights. First w_H and w_M
are searched as numbers (see `search`). Then their logarithms are fields over the vertices, which Adam (Kingma and Ba
2015) moves. The objective has a kink wherever a nearest point changes, at which L-BFGS becomes slow: 2.40 after 62
evaluations, where Adam has 1.76. At the end one fresh run is made, whose objective must be that of the tape.
"""

from functools import partial
from typing import Any, NamedTuple

import jax
import numpy as np

from msf_jax.base.errors import ConfigError
from msf_jax.base.options import Weights
from msf_jax.flow import loop
from msf_jax.gradients.replay import replay_meso
from msf_jax.gradients.tape import Tape
from msf_jax.tuning.gradient import SEARCH_TOLERANCE, logarithms, with_logarithms
from msf_jax.tuning.objectives import Objective, of_surface
from msf_jax.tuning.result import Tuned, TuningStep
from msf_jax.tuning.runs import Runs
from msf_jax.tuning.search import FIRST_SPREAD, Search

FIELDS = ("w_H", "w_M")  # only their ratios to w_L matter, and smoothing has little effect
FIELD_BOUNDS = (0.01, 100.0)  # with w_H at 1e-5 of w_L, tape and fresh run differed by 2e-3 at a tolerance of 1e-6
TRIES = 24  # pairs of numbers that are tried first, at most
RATE = 0.2  # natural logarithms: how much Adam's first step changes a weight; steps fall to 0 along a cosine
MEAN, SQUARE, LEAST = 0.9, 0.999, 1e-8  # Adam's decay of the mean slope and of the mean square, and its least root
AGREEMENT = 1e-3  # relative difference of the objective between tape and fresh run, above which they disagree


class Point(NamedTuple):
    """Logarithms (n,) of the numbers, their changes (n, V) at the vertices, and the objective there, by the tape."""

    base: np.ndarray
    change: np.ndarray
    value: float


class _OnTape:
    """The objective as a function of a `Point`, by replays; and the best point so far."""

    def __init__(
        self, tape: Tape, objective: Objective, weights: Weights, free: list[str], low: np.ndarray, high: np.ndarray
    ):
        self.tape, self.objective, self.weights, self.free, self.low, self.high = (
            tape,
            objective,
            weights,
            free,
            low,
            high,
        )
        here = np.array([float(logarithms(weights)[name]) for name in free])
        self.start = self.best = Point(here, np.zeros((len(free), len(tape.vertices))), np.inf)

    def weights_of(self, point: Point) -> Weights:
        """Arrays (V,) for the free weights."""
        return with_logarithms(self.weights, self._fields(point)[0])

    def numbers_of(self, point: Point) -> Weights:
        """The numbers that the fields of ``point`` are changes of."""
        return with_logarithms(self.weights, dict(zip(self.free, point.base.tolist(), strict=True)))

    def _fields(self, point: Point) -> tuple[dict[str, np.ndarray], np.ndarray]:
        """Logarithms of the free weights, and where they are within their bounds (n, V)."""
        wanted = point.base[:, None] + point.change
        held = np.clip(wanted, self.low[:, None], self.high[:, None])
        return dict(zip(self.free, held, strict=True)), held == wanted

    def at(self, point: Point) -> tuple[Point, np.ndarray]:
        """The point with its value, and the slope in its changes (n, V)."""
        fields, is_free = self._fields(point)
        value, slope = _value_and_slope(self.objective, fields, self.weights, self.tape)
        found = point._replace(value=float(value))
        if found.value < self.best.value:
            self.best = found
        return found, np.where(is_free, np.stack([np.asarray(slope[name]) for name in self.free]), 0.0)


@partial(jax.jit, static_argnums=0)
def _value_and_slope(objective: Objective, fields: dict[str, Any], weights: Weights, tape: Tape) -> Any:
    def value(fields: dict[str, Any]) -> jax.Array:
        found = replay_meso(tape, with_logarithms(weights, fields), tolerance=SEARCH_TOLERANCE)
        return of_surface(objective, tape, found)

    return jax.value_and_grad(value)(fields)


def tuned_on_tape(
    runs: Runs,
    objective: Objective,
    weights: Weights,
    free: list[str],
    given: list[np.ndarray],
    low: np.ndarray,
    high: np.ndarray,
    steps: int,
    bar: Any,
) -> Tuned:
    """At most ``TRIES`` pairs of numbers, those of ``given`` first, then ``steps`` steps of Adam, then a fresh run.

    The tape is that of a run with ``weights``. ``low`` and ``high`` are bounds of the ``free`` weights' logarithms, and
    points of ``given`` are such logarithms.
    """
    (mesh,) = runs.surfaces

    def run(at: Weights) -> tuple[Any, float, bool]:
        """A fresh run, the objective of its contracted surface, and whether it converges."""
        flow = loop.contract(mesh, at, runs.config)
        value = float(of_surface(objective, flow.tape, flow.meso_skeleton[0]))
        return flow, value, flow.skeleton.report.converged

    flow, before, converges = run(weights)
    if not np.isfinite(before):
        raise ConfigError(f"the objective is {before} at the start: expected a finite number")
    problem = _OnTape(flow.tape, objective, weights, free, low, high)
    trajectory = [TuningStep(weights, before, before, True, FIRST_SPREAD, converges, None)]
    reason, of_defaults = "all steps made", np.nan
    try:
        of_defaults = _searched(problem, given, min(steps, TRIES), bar)
        numbers = problem.numbers_of(problem.best)
        trajectory.append(TuningStep(numbers, problem.best.value, np.nan, False, FIRST_SPREAD, converges, None))
        _descended(problem, steps, bar)
    except KeyboardInterrupt:
        reason = "interrupted"
    best = problem.weights_of(problem.best)
    fresh, after, converges = run(best)
    off = abs(after - problem.best.value) / max(abs(after), 1e-300)
    agrees = "has the tape's value to" if off <= AGREEMENT else "does not have the tape's value: they differ by"
    reason = f"{reason}; a fresh run {agrees} {off:.0e}"
    if off > AGREEMENT:
        reason += ", as decisions or solves that are not tight make them; expected Config.smooth() in float64"
    is_taken = after < before
    trajectory.append(TuningStep(best, problem.best.value, after, is_taken, RATE, converges, None))
    if not is_taken:
        return Tuned(weights, before, (flow,), tuple(trajectory), f"{reason}; nothing beats the start", of_defaults)
    return Tuned(best, after, (fresh,), tuple(trajectory), reason, of_defaults)


def _searched(problem: _OnTape, given: list[np.ndarray], tries: int, bar: Any) -> float:
    """Try ``tries`` pairs of numbers. Returns the value of the last one of ``given``, the default weights."""
    search = Search(given, problem.low, problem.high)
    for _ in range(tries):
        (base,) = search.ask()
        found, _ = problem.at(problem.start._replace(base=base))
        search.tell(base[None], np.array([found.value if np.isfinite(found.value) else np.inf]))
        bar.update(1, f"objective {problem.best.value:.4g}")
    return float(search.values[len(given) - 1]) if tries >= len(given) else np.nan


def _descended(problem: _OnTape, steps: int, bar: Any) -> None:
    """``steps`` steps of Adam from the best numbers; fewer if the slope is 0, or a solve fails."""
    point, scale = problem.best, 0.0
    mean = square = np.zeros_like(point.change)
    for number in range(steps + 1):
        found, slope = problem.at(point)
        scale = scale or float(np.abs(slope).max())  # so that LEAST has no unit
        if number == steps or not np.isfinite(found.value) or not np.isfinite(slope).all() or scale == 0:
            return
        slope = slope / scale
        mean, square = MEAN * mean + (1 - MEAN) * slope, SQUARE * square + (1 - SQUARE) * slope**2
        root = np.sqrt(square / (1 - SQUARE ** (number + 1))) + LEAST
        rate = RATE * (1 + np.cos(np.pi * number / steps)) / 2
        point = point._replace(change=point.change - rate * mean / (1 - MEAN ** (number + 1)) / root)
        bar.update(1, f"objective {problem.best.value:.4g}")
