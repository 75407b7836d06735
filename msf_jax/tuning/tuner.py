"""`tune`: weights with a lower objective, as numbers by fresh runs, or as fields over the vertices on one tape.

A finished curve is no continuous function of the weights: decisions of a run depend on them. So numbers are proposed by
CMA-ES (Hansen and Ostermeier 2001), which uses the order of the values alone. With `Config.smooth` a run decides
nothing, and the replay of one tape is the run at any weights. There gradients move a weight for every vertex.
"""

import numbers
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, NamedTuple

import cma
import jax
import jax.numpy as jnp
import numpy as np
from tqdm import tqdm

from msf_jax.base.errors import ConfigError, FlowError
from msf_jax.base.options import Config, Weights
from msf_jax.flow import loop
from msf_jax.flow.loop import checked_options
from msf_jax.flow.state import Flow
from msf_jax.gradients.replay import Tape, replay_meso
from msf_jax.meshes import checking, reading
from msf_jax.tuning.objectives import Objective, as_objective, of_skeleton, of_surface

WIDEST = (1e-6, 1e4)  # default bounds of a weight, without unit
FIELDS = ("w_H", "w_M")  # only their ratios to w_L matter, and smoothing has little effect
FIELD_BOUNDS = (0.01, 100.0)  # with w_H at 1e-5 of w_L, tape and fresh run differed by 2e-3 at a tolerance of 1e-6
MOST_PAIRS = 36  # pairs of numbers that are tried on a tape before the fields
SPREAD = 0.8  # natural logarithms: first standard deviation of the proposals around the best given point
RATE = 0.2  # natural logarithms: how much Adam's first step changes a weight; steps fall to 0 along a cosine
MEAN, SQUARE, LEAST = 0.9, 0.999, 1e-8  # Adam's decay of the mean slope and of the mean square, and its least root
AGREEMENT = 1e-3  # relative difference of the objective between tape and fresh run, above which they disagree


class TuningStep(NamedTuple):
    """One proposal. The first is the start."""

    weights: Weights
    expected: float  # the objective by the tape; NaN if none was used
    found: float  # the objective of fresh runs; inf if one failed, NaN if none was made
    is_taken: bool  # whether the weights became the best
    converges: bool  # whether all of the fresh runs did


@dataclass(frozen=True)
class Tuned:
    """The result of `tune`.

    Attributes:
        weights: the best weights.
        value: the objective there, by fresh runs, the mean over the meshes.
        flows: those runs, one for each mesh.
        trajectory: every proposal, in order.
        reason: why it stopped.
        of_defaults: the objective at the system's default weights, within the bounds; NaN if they were not tried.
    """

    weights: Weights
    value: float
    flows: tuple[Flow, ...]
    trajectory: tuple[TuningStep, ...]
    reason: str
    of_defaults: float = np.nan

    def __repr__(self) -> str:
        return (
            f"Tuned({self.value:.6g} at {_line(self.weights)}, after {len(self.trajectory) - 1} steps, {self.reason})"
        )

    def __str__(self) -> str:
        lines = [f"{len(self.trajectory) - 1} steps, {self.reason}"]
        if not np.isnan(self.of_defaults):
            beaten = "" if self.value < self.of_defaults else ": nothing beats them"
            lines.append(f"default weights: {self.of_defaults:.6g}{beaten}")
        lines.append("objective   by the tape")
        for step in self.trajectory:
            found, expected = ("-" if np.isnan(value) else f"{value:.6g}" for value in (step.found, step.expected))
            lines.append(f"{found:<11} {expected:<11} {'taken' if step.is_taken else '':<5}  {_line(step.weights)}")
        return "\n".join(lines)


def _line(weights: Weights) -> str:
    return ", ".join(
        f"{name} {np.min(weight):.4g} to {np.max(weight):.4g}" if np.ndim(weight) else f"{name} {weight:.4g}"
        for name, weight in vars(weights).items()
    )


def tune(
    meshes: Any,
    objective: Objective | Callable[..., Any],
    weights: Weights | None = None,
    *,
    config: Config | None = None,
    bounds: dict[str, tuple[float, float]] | tuple[float, float] | None = None,
    of: str = "skeleton",
    steps: int = 24,
    progress: bool = False,
) -> Tuned:
    """Find weights with a lower objective: numbers by fresh runs, or a weight for every vertex by gradients.

    Args:
        meshes: one mesh, as `contract` takes it, or a list of them, whose mean objective is reduced.
        objective: one of `msf_jax.objectives`, a sum of them, or a JAX function of ``(nodes (N, 3), radii (N,))`` that
            returns a number; lower is better.
        weights: the start, numbers; those of ``config``'s system if not given. A weight that is 0 is not changed.
        config: of the runs. For of="surface" the default is `Config.smooth`, else ``Config()``.
        bounds: lowest and highest value of every weight, or by name. A weight with equal bounds is not changed. The
            default is 1e-6 to 1e4, and 0.01 to 100 for of="surface": beyond, the solves are no longer tight.
        of: "skeleton" for the objective of the finished curve, or "surface" for that of the contracted surface, whose
            vertices count as nodes, see `objectives.of_surface`.
        steps: the number of fresh runs on each mesh, after the first. For of="surface" that of steps of Adam.
        progress: show a progress bar on standard error, if that is a terminal.

    CMA-ES proposes numbers, after the start and the default weights; the same arguments give the same proposals. Only
    the ratios of w_L, w_H and w_M matter, so w_L is held constant if all three may change. Weights whose runs converge
    are preferred, whatever the objective. The result is the best of the tried weights, after Ctrl-C the best so far.

    With of="surface" one tape is enough: numbers w_H and w_M are searched on it, then made fields by Adam, a weight for
    every vertex. One fresh run ends the tuning, and ``reason`` says how far its value is from the tape's.

    Raises:
        ConfigError: a weight is out of ``bounds``, an option has a wrong type, the objective returns no number, or its
            value at the start is not finite.
        MeshError, FlowError: see `contract`.
    """
    if of not in ("skeleton", "surface"):
        raise ConfigError(f"of is {of!r}: expected 'skeleton' or 'surface'")
    is_surface = of == "surface"
    weights, config = checked_options(weights, Config.smooth() if is_surface and config is None else config)
    objective = as_objective(objective)
    for name in (name for name, weight in vars(weights).items() if np.ndim(weight)):
        raise ConfigError(f"{name} is an array: expected a number; of='surface' makes arrays of numbers")
    if isinstance(steps, bool) or not isinstance(steps, numbers.Integral) or steps < 1:
        raise ConfigError(f"steps is {steps!r}: expected a whole number of 1 or more")
    if is_surface and config.flow.edit_connectivity:
        raise ConfigError("of='surface' was given, and the run edits edges: expected Config.smooth()")
    default = dict.fromkeys(FIELDS, FIELD_BOUNDS) if is_surface else WIDEST
    low, high = _checked_bounds(weights, default if bounds is None else bounds)
    listed = [reading.read(mesh) for mesh in (meshes if isinstance(meshes, list) else [meshes])]
    if not listed or (is_surface and len(listed) > 1):
        raise ConfigError(f"meshes has {len(listed)} meshes: expected one, or for of='skeleton' a list of them")
    trials, steps = _Trials(listed, objective, config.tight() if is_surface else config, is_surface), int(steps)
    space = _Space(weights, config.default_weights(), low, high, FIELDS if is_surface else tuple(vars(weights)))
    total = min(steps, MOST_PAIRS) + steps if is_surface else steps + 1
    with tqdm(
        total=total, desc="tune", unit="step" if is_surface else "run", disable=None if progress else True
    ) as bar:
        reason, values = (_tune_fields if is_surface else _tune_numbers)(trials, space, steps, bar)
    best, num = trials.best, len(space.given)  # the default weights are the last given point
    of_defaults = values[num - 1] if len(values) >= num else np.nan
    return Tuned(best.weights, best.found, trials.flows, tuple(trials.steps), reason, of_defaults)


class _Trials:
    """Fresh runs of ``meshes``, all proposals, and the best of them with its runs."""

    best: TuningStep
    flows: tuple[Flow, ...]

    def __init__(self, meshes: list[Any], objective: Objective, config: Config, is_surface: bool):
        self.meshes, self.objective, self.config, self.is_surface = meshes, objective, config, is_surface
        self.surfaces = [checking.prepare(mesh) for mesh in meshes]  # checked once, not for every run
        self.steps: list[TuningStep] = []

    def run(self, weights: Weights, expected: float = np.nan) -> float:
        """The objective's mean over fresh runs with ``weights``; inf if one failed or did not converge."""
        try:
            flows = tuple(loop.contract(surface, weights, self.config) for surface in self.surfaces)
        except FlowError:
            if not self.steps:
                raise
            self.steps.append(TuningStep(weights, expected, np.inf, False, False))
            return np.inf
        if self.is_surface:
            value = float(of_surface(self.objective, flows[0].tape, flows[0].meso_skeleton[0]))
        else:
            pairs = zip(flows, self.meshes, strict=True)
            value = float(np.mean([of_skeleton(self.objective, flow.skeleton, mesh) for flow, mesh in pairs]))
        if not self.steps and not np.isfinite(value):
            raise ConfigError(f"objective {self.objective.name} is {value} at the start: expected a finite number")
        converges = all(flow.skeleton.report.converged for flow in flows)
        step = TuningStep(weights, expected, value, False, converges)
        if not self.steps or (np.isfinite(value) and self._rank(step) > self._rank(self.best)):
            step = step._replace(is_taken=True)
            self.best, self.flows = step, flows
        self.steps.append(step)
        return value if converges else np.inf

    def _rank(self, step: TuningStep) -> tuple[bool, float]:
        """Higher is better. The last iteration of a run without decisions is given, wherever its surface is then."""
        return step.converges or self.is_surface, -step.found


class _Space:
    """Points (n,): the natural logarithms of the weights that may change, of ``names``, within their bounds.

    given: the points of the start and of the default weights within their bounds, once if these are the same.
    """

    def __init__(
        self, start: Weights, usual: Weights, low: dict[str, float], high: dict[str, float], names: tuple[str, ...]
    ):
        free = [name for name in names if getattr(start, name) > 0 and low[name] < high[name]]
        # Only the ratios of w_L, w_H and w_M matter. Where w_L may not change, the default ratios are to the start's.
        scale = float(start.w_L) / float(usual.w_L) if "w_L" not in free and start.w_L > 0 < usual.w_L else 1.0
        values = {name: getattr(usual, name) * (1.0 if name == "smoothing" else scale) for name in free}
        values = {name: np.clip(x, np.exp(low[name]), np.exp(high[name])) for name, x in values.items() if x > 0}
        default = replace(start, **values)
        if {"w_L", "w_H", "w_M"} <= set(free):
            free.remove("w_L")
        self.start, self.free = start, free
        self.low, self.high = (np.array([ends[name] for name in free]) for ends in (low, high))
        self.given = [self._point_of(start), self._point_of(default)]
        # A logarithm and an exponential change the last bits, which can change a curve.
        self.exact = {self.given[1].tobytes(): default, self.given[0].tobytes(): start}
        if np.allclose(self.given[0], self.given[1]):
            self.given.pop()

    def _point_of(self, weights: Weights) -> np.ndarray:
        scale = self.start.w_L / weights.w_L if self.start.w_L > 0 else 1.0
        values = [getattr(weights, name) * (1.0 if name == "smoothing" else scale) for name in self.free]
        return np.clip(np.log(np.array(values)), self.low, self.high)

    def weights_at(self, point: np.ndarray) -> Weights:
        """The weights at a point (n,), or with arrays (V,) at one of shape (n, V)."""
        values = dict(zip(self.free, np.exp(point), strict=True))
        return self.exact.get(point.tobytes()) or replace(self.start, **values)


def _tune_numbers(trials: _Trials, space: _Space, steps: int, bar: Any) -> tuple[str, list[float]]:
    """``steps`` fresh runs after the start. Returns why they ended, and the values in order."""

    def value_at(point: np.ndarray) -> float:
        value = trials.run(space.weights_at(point))
        bar.update()
        bar.set_postfix_str(f"objective {trials.best.found:.4g}")
        return value

    reason = "all steps made" if space.free else "no weight is free to change"
    try:
        minimise(value_at, space, steps + 1 if space.free else 1)
    except KeyboardInterrupt:
        if not trials.steps:
            raise
        reason = "interrupted"
    return reason, [step.found for step in trials.steps]


def minimise(value_at: Callable[[np.ndarray], float], space: _Space, num: int, spread: float = SPREAD) -> None:
    """Ask for ``num`` values: at the given points of ``space``, then where CMA-ES proposes, from the best of them.

    spread: the first standard deviation of CMA-ES, in natural logarithms. The same arguments give the same points.
    """
    random = np.random.default_rng(0)
    values = [value_at(point) for point in space.given[:num]]
    if num <= len(values):
        return
    # Numbers of our own: with a seed, CMA-ES would set that of NumPy's global ones.
    options = {"randn": lambda *shape: random.standard_normal(shape), "seed": np.nan, "verbose": -9}
    options["bounds"] = [space.low.tolist(), space.high.tolist()]
    search = cma.CMAEvolutionStrategy(space.given[int(np.argmin(values))], spread, options)
    left = num - len(values)
    while left > 0:
        points = search.ask()
        values = [value_at(point) for point in points[:left]]
        left -= len(values)
        if len(values) == len(points):
            search.tell(points, values)


def _tune_fields(trials: _Trials, space: _Space, steps: int, bar: Any) -> tuple[str, list[float]]:
    """Numbers on the tape of the start, ``steps`` steps of Adam from the best of them, and one fresh run.

    The objective has a kink wherever a nearest point changes, where a quasi-Newton method becomes slow: 3.07 after 60
    evaluations of SciPy's L-BFGS-B (by jaxopt), where Adam (Kingma and Ba 2015) has 1.67.
    """
    if not space.free:
        raise ConfigError("w_H and w_M are 0 or held by their bounds: expected one that is free to change")
    trials.run(space.start)
    tape = trials.flows[0].tape
    shape = len(space.free), len(tape.vertices)
    points: list[np.ndarray] = []
    values: list[float] = []

    def at(point: np.ndarray) -> tuple[float, np.ndarray]:
        """The objective by the tape, and its slope (n, V) in the logarithms."""
        fields = dict(zip(space.free, point, strict=True))
        value, slope = _value_and_slope(trials.objective, fields, space.start, tape)
        points.append(point)
        values.append(float(value) if np.isfinite(value) else np.inf)
        bar.update()
        bar.set_postfix_str(f"objective {min(values):.4g}")
        return values[-1], np.stack([np.asarray(slope[name]) for name in space.free])

    reason = "all steps made"
    try:
        spread = float(np.mean(space.high - space.low)) / 3  # as the authors of CMA-ES advise
        minimise(lambda pair: at(np.broadcast_to(pair[:, None], shape))[0], space, min(steps, MOST_PAIRS), spread)
        point = points[int(np.argmin(values))]
        trials.steps.append(TuningStep(space.weights_at(point[:, 0]), min(values), np.nan, False, False))
        mean = square = np.zeros(shape)
        scale = 0.0
        for number in range(steps + 1):
            value, slope = at(point)
            scale = scale or float(np.abs(slope).max())  # LEAST has no unit
            if number == steps or not np.isfinite(value) or not np.isfinite(slope).all() or scale == 0:
                break
            mean = MEAN * mean + (1 - MEAN) * slope / scale
            square = SQUARE * square + (1 - SQUARE) * (slope / scale) ** 2
            root = np.sqrt(square / (1 - SQUARE ** (number + 1))) + LEAST
            rate = RATE * (1 + np.cos(np.pi * number / steps)) / 2
            moved = point - rate * mean / (1 - MEAN ** (number + 1)) / root
            point = np.clip(moved, space.low[:, None], space.high[:, None])
    except KeyboardInterrupt:
        reason = "interrupted"
    if values:
        expected = min(values)
        trials.run(space.weights_at(points[int(np.argmin(values))]), expected)
        found = trials.steps[-1].found
        off = abs(found - expected) / max(abs(found), 1e-300)
        if off <= AGREEMENT:
            reason += f"; a fresh run has the tape's value to {off:.0e}"
        else:
            reason += f"; a fresh run differs from the tape by {off:.0e}: expected Config.smooth() in float64"
    if trials.best.weights is space.start:
        reason += "; nothing beats the start"
    return reason, values


@partial(jax.jit, static_argnums=0)
def _value_and_slope(objective: Objective, fields: dict[str, Any], weights: Weights, tape: Tape) -> Any:
    def value(fields: dict[str, Any]) -> jax.Array:
        at = replace(weights, **{name: jnp.exp(field) for name, field in fields.items()})
        return of_surface(objective, tape, replay_meso(tape, at))

    return jax.value_and_grad(value)(fields)


def _checked_bounds(weights: Weights, bounds: Any) -> tuple[dict[str, float], dict[str, float]]:
    """Natural logarithms of the lowest and the highest value of every weight."""
    pairs: dict[str, Any] = bounds if isinstance(bounds, dict) else dict.fromkeys(vars(weights), bounds)
    for name in pairs.keys() - vars(weights).keys():
        raise ConfigError(f"bounds has {name!r}: expected one of {', '.join(vars(weights))}")
    low, high = {}, {}
    for name, weight in vars(weights).items():
        pair = pairs.get(name, WIDEST)
        try:
            first, last = (float(end) for end in pair)
        except (TypeError, ValueError):
            first = last = 0.0
        if not 0 < first <= last < np.inf:
            raise ConfigError(
                f"bounds of {name} are {pair!r}: expected (lowest, highest), finite, with 0 < lowest <= highest"
            )
        if weight > 0 and not first <= weight <= last:
            raise ConfigError(f"Weights.{name} is {weight:g}: expected a start within its bounds {pair!r}")
        low[name], high[name] = np.log(first), np.log(last)
    return low, high
