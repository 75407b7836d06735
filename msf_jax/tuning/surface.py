"""Tuning of the contracted surface on tapes: a weight for every vertex, or weights as a function of surface features.

With `Config.smooth` a run takes no decisions, so the replay of one tape is the run, at any weights. First w_H and w_M
are searched as numbers (see `search`). Then their logarithms are fields over the vertices,

    log w = log w_0 + F theta,

where F is the identity (a weight for every vertex of one mesh), or has the features of each mesh in its rows, so that
all meshes share theta. theta is found by Adam (Kingma and Ba 2015). The objective has a kink wherever a nearest point
changes, at which L-BFGS becomes slow: 2.40 after 62 evaluations, where Adam has 1.76. At the end one fresh run of each
mesh is made, whose objective must be that of the tape.
"""

from collections.abc import Sequence
from functools import partial
from typing import Any, NamedTuple

import jax
import numpy as np

from msf_jax.base.errors import ConfigError
from msf_jax.base.options import Weights
from msf_jax.flow import loop
from msf_jax.flow.state import Flow
from msf_jax.gradients.replay import replay_meso
from msf_jax.gradients.tape import Tape
from msf_jax.tuning.features import FeatureWeights, features_of
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


class Member(NamedTuple):
    """A mesh's tape, its objective, and its features (V, K); None if every vertex has its own weight."""

    tape: Tape
    objective: Objective
    features: np.ndarray | None


class Point(NamedTuple):
    """Logarithms (n,) of the numbers, theta (n, K), and the objective there, by the tapes."""

    base: np.ndarray
    theta: np.ndarray
    value: float


class _OnTapes:
    """The objective's mean over the meshes as a function of a `Point`, by replays; and the best point so far."""

    def __init__(self, members: list[Member], weights: Weights, free: list[str], low: np.ndarray, high: np.ndarray):
        self.members, self.weights, self.free, self.low, self.high = members, weights, free, low, high
        features = members[0].features
        self.size = len(members[0].tape.vertices) if features is None else features.shape[1]
        here = np.array([float(logarithms(weights)[name]) for name in free])
        self.start = self.best = Point(here, np.zeros((len(free), self.size)), np.inf)

    def weights_of(self, member: Member, point: Point) -> Weights:
        """Arrays (V,) for the free weights of a mesh."""
        return with_logarithms(self.weights, self._fields(member, point)[0])

    def _fields(self, member: Member, point: Point) -> tuple[dict[str, np.ndarray], np.ndarray]:
        """Logarithms of the free weights, and where they are within their bounds (n, V)."""
        change = point.theta if member.features is None else point.theta @ member.features.T
        wanted = point.base[:, None] + change
        held = np.clip(wanted, self.low[:, None], self.high[:, None])
        return dict(zip(self.free, held, strict=True)), held == wanted

    def at(self, point: Point) -> tuple[Point, np.ndarray]:
        """The point with its value, and the slope in theta (n, K)."""
        values, slopes = [], []
        for member in self.members:
            fields, is_free = self._fields(member, point)
            value, slope = _value_and_slope(member.objective, fields, self.weights, member.tape)
            slope = np.where(is_free, np.stack([np.asarray(slope[name]) for name in self.free]), 0.0)
            values.append(float(value))
            slopes.append(slope if member.features is None else slope @ member.features)
        found = point._replace(value=float(np.mean(values)))
        if found.value < self.best.value:
            self.best = found
        return found, np.mean(slopes, axis=0)


@partial(jax.jit, static_argnums=0)
def _value_and_slope(objective: Objective, fields: dict[str, Any], weights: Weights, tape: Tape) -> Any:
    def value(fields: dict[str, Any]) -> jax.Array:
        found = replay_meso(tape, with_logarithms(weights, fields), tolerance=SEARCH_TOLERANCE)
        return of_surface(objective, tape, found)

    return jax.value_and_grad(value)(fields)


def tuned_on_tapes(
    runs: Runs,
    objectives: Sequence[Objective],
    weights: Weights,
    free: list[str],
    given: list[np.ndarray],
    low: np.ndarray,
    high: np.ndarray,
    steps: int,
    bar: Any,
) -> Tuned:
    """At most ``TRIES`` pairs of numbers, those of ``given`` first, then ``steps`` steps of Adam, then fresh runs.

    The tapes are those of one run of each mesh with ``weights``. ``low`` and ``high`` are bounds of the ``free``
    weights' logarithms, and points of ``given`` are such logarithms.
    """
    flows = tuple(loop.contract(surface, weights, runs.config) for surface in runs.surfaces)
    before = _mean(objectives, flows)
    if not np.isfinite(before):
        raise ConfigError(f"the objective is {before} at the start: expected a finite number")
    is_one = len(flows) == 1
    members = [
        Member(flow.tape, objective, None if is_one else features_of(surface))
        for flow, objective, surface in zip(flows, objectives, runs.surfaces, strict=True)
    ]
    problem = _OnTapes(members, weights, free, low, high)
    first, reason = TuningStep(weights, before, before, True, FIRST_SPREAD, _converge(flows), None), "all steps made"
    tried, of_defaults = [], np.nan
    try:
        of_defaults = _searched(problem, given, min(steps, TRIES), bar)
        number = problem.best
        scalars = with_logarithms(weights, dict(zip(free, number.base.tolist(), strict=True)))
        tried.append(TuningStep(scalars, number.value, np.nan, False, FIRST_SPREAD, _converge(flows), None))
        _descended(problem, steps, bar)
    except KeyboardInterrupt:
        reason = "interrupted"
    best = problem.best
    each = [problem.weights_of(member, best) for member in members]
    fresh = tuple(loop.contract(*run, runs.config) for run in zip(runs.surfaces, each, strict=True))
    after = _mean(objectives, fresh)
    off = abs(after - best.value) / max(abs(after), 1e-300)
    agrees = "have the tape's value to" if off <= AGREEMENT else "do not have the tape's value: they differ by"
    reason = f"{reason}; fresh runs {agrees} {off:.0e}"
    if off > AGREEMENT:
        reason += ", as decisions or solves that are not tight make them; expected Config.smooth() in float64"
    number = with_logarithms(weights, dict(zip(free, best.base.tolist(), strict=True)))
    is_taken = after < before
    last = TuningStep(each[0] if is_one else number, best.value, after, is_taken, RATE, _converge(fresh), None)
    trajectory = (first, *tried, last)
    if not is_taken:
        return Tuned(weights, before, flows, trajectory, f"{reason}; nothing beats the start", of_defaults)
    if is_one:
        return Tuned(each[0], after, fresh, trajectory, reason, of_defaults)
    theta = dict(zip(free, best.theta, strict=True))
    bounds = {name: (float(np.exp(a)), float(np.exp(b))) for name, a, b in zip(free, low, high, strict=True)}
    return Tuned(number, after, fresh, trajectory, reason, of_defaults, FeatureWeights(number, theta, bounds))


def _searched(problem: _OnTapes, given: list[np.ndarray], tries: int, bar: Any) -> float:
    """Try ``tries`` pairs of numbers. Returns the value of the last one of ``given``, the default weights."""
    search = Search(given, problem.low, problem.high)
    for _ in range(tries):
        (base,) = search.ask()
        found, _ = problem.at(problem.start._replace(base=base))
        search.tell(base[None], np.array([found.value if np.isfinite(found.value) else np.inf]))
        bar.update(1, f"objective {problem.best.value:.4g}")
    return float(search.values[len(given) - 1]) if tries >= len(given) else np.nan


def _descended(problem: _OnTapes, steps: int, bar: Any) -> None:
    """``steps`` steps of Adam from the best numbers; fewer if the slope is 0, or a solve fails."""
    point, scale = problem.best, 0.0
    first = RATE if problem.members[0].features is None else RATE / problem.size  # all features act on each weight
    mean = square = np.zeros_like(point.theta)
    for number in range(steps + 1):
        found, slope = problem.at(point)
        scale = scale or float(np.abs(slope).max())  # so that LEAST has no unit
        if number == steps or not np.isfinite(found.value) or not np.isfinite(slope).all() or scale == 0:
            return
        slope = slope / scale
        mean, square = MEAN * mean + (1 - MEAN) * slope, SQUARE * square + (1 - SQUARE) * slope**2
        root = np.sqrt(square / (1 - SQUARE ** (number + 1))) + LEAST
        rate = first * (1 + np.cos(np.pi * number / steps)) / 2
        point = point._replace(theta=point.theta - rate * mean / (1 - MEAN ** (number + 1)) / root)
        bar.update(1, f"objective {problem.best.value:.4g}")


def _mean(objectives: Sequence[Objective], flows: Sequence[Flow]) -> float:
    """The objective's mean over the contracted surfaces of runs."""
    pairs = zip(objectives, flows, strict=True)
    return float(np.mean([float(of_surface(one, flow.tape, flow.meso_skeleton[0])) for one, flow in pairs]))


def _converge(flows: Sequence[Flow]) -> bool:
    return all(flow.skeleton.report.converged for flow in flows)
