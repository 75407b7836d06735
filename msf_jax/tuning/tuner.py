"""`tune`: a weight for every vertex, by gradients through the contracted surface.

A finished curve is no continuous function of the weights: decisions of a run depend on them. With `Config.smooth` a run
decides nothing, and the replay of one tape is the run at any weights. So w_H and w_M, whose ratios to w_L are all that
matters, become fields over the vertices, moved by Adam (Kingma and Ba 2015) in their logarithms: a distance has a kink
wherever a nearest point changes, where quasi-Newton methods become slow.
"""

import itertools
import numbers
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from tqdm import tqdm

from msf_jax.base.errors import ConfigError
from msf_jax.base.options import Config, Weights
from msf_jax.flow.loop import checked_options, contract
from msf_jax.flow.state import Flow
from msf_jax.gradients.replay import Tape, replay_meso

FIELDS = ("w_H", "w_M")
WIDEST = (0.01, 100.0)  # of w_L: with w_H at 1e-5 of it, tape and fresh run differed by 2e-3 at a tolerance of 1e-6
GRID = 6  # values of each weight that are tried together before the fields: from the defaults, Adam can stay far behind
RATE = 0.2  # natural logarithms: how much Adam's first step changes a weight; steps fall to 0 along a cosine
MEAN, SQUARE, LEAST = 0.9, 0.999, 1e-8  # Adam's decay of the mean slope and of the mean square, and its least root


@dataclass(frozen=True)
class Tuned:
    """The result of `tune`.

    Attributes:
        weights: the best weights; w_H and w_M have a value for every vertex of the mesh.
        value: the objective there, by a fresh run.
        flow: that run.
        trajectory: (k,) the objective by the tape: at the start, on a grid of numbers, then for each step of Adam.
    """

    weights: Weights
    value: float
    flow: Flow
    trajectory: np.ndarray

    def __repr__(self) -> str:
        off = abs(self.value - self.trajectory.min()) / max(abs(self.value), 1e-300)
        return f"Tuned({self.value:.6g}, from {self.trajectory[0]:.6g}; the fresh run and the tape differ by {off:.0e})"


def tune(
    mesh: Any,
    objective: Callable[[jax.Array], Any],
    weights: Weights | None = None,
    *,
    config: Config | None = None,
    bounds: tuple[float, float] = WIDEST,
    steps: int = 60,
    progress: bool = False,
) -> Tuned:
    """Find a w_H and a w_M for every vertex that lower an ``objective`` of the contracted surface.

    Args:
        mesh: as `contract` takes it.
        objective: a JAX function of the contracted surface's vertices (V, 3), in the mesh's units, that returns one
            number; lower is better.
        weights: the start; those of ``config``'s system if not given. A w_M that is 0 anywhere is not changed.
        config: of the run, without decisions: `Config.smooth()` if not given.
        bounds: lowest and highest value of w_H and w_M, for a w_L of 1. Beyond the default, solves are no longer tight.
        steps: of Adam, after at most 36 numbers on a grid within ``bounds``; each costs a replay and its gradient.
        progress: show a progress bar on standard error, if that is a terminal.

    JAX must have float64 enabled. One tape serves all steps, and a fresh run ends the tuning. After Ctrl-C the result
    is the best so far. The finished curve gains nothing by it: see the guide.

    Raises:
        ConfigError: an option has a wrong type or value, the run edits edges, a weight is out of ``bounds``, or the
            objective at the start is not one finite number.
        MeshError, FlowError: see `contract`.
    """
    if not callable(objective):
        raise ConfigError(f"objective is a {type(objective).__name__}: expected a function of vertices (V, 3)")
    weights, config = checked_options(weights, Config.smooth() if config is None else config)
    if config.flow.edit_connectivity:
        raise ConfigError("the run edits edges: expected Config.smooth()")
    if isinstance(steps, bool) or not isinstance(steps, numbers.Integral) or steps < 1:
        raise ConfigError(f"steps is {steps!r}: expected a whole number of 1 or more")
    try:
        low, high = map(float, bounds)
    except (TypeError, ValueError):
        low = high = 0.0
    if not 0 < low <= high < np.inf:
        raise ConfigError(f"bounds is {bounds!r}: expected (lowest, highest), finite, with 0 < lowest <= highest")
    for name in FIELDS:
        weight = np.asarray(getattr(weights, name))
        if not ((weight == 0) | ((low <= weight) & (weight <= high))).all():
            raise ConfigError(
                f"Weights.{name} is {weight.min():g} to {weight.max():g}: expected a start within {low:g} to {high:g}"
            )
    config = config.tight()
    tape = contract(mesh, weights, config).tape
    start = {name: np.broadcast_to(getattr(weights, name), len(tape.vertices)) for name in FIELDS}
    start = {name: np.log(weight) for name, weight in start.items() if (weight > 0).all()}
    slope_at = partial(_value_and_slope, objective, weights, tape)
    total = 2 + min(GRID, steps) ** len(start) + steps
    with tqdm(total=total, desc="tune", unit="step", disable=None if progress else True) as bar:
        fields, values = _descend(slope_at, start, np.log(low), np.log(high), int(steps), bar)
    found = replace(weights, **{name: np.exp(field) for name, field in fields.items()})
    flow = contract(mesh, found, config)
    return Tuned(found, float(_number(objective, flow.meso_skeleton[0])), flow, np.array(values))


def _descend(
    slope_at: Callable[[dict[str, Any]], Any], start: dict[str, Any], low: float, high: float, steps: int, bar: Any
) -> tuple[dict[str, Any], list[float]]:
    """The best fields of ``start``, of a grid of numbers from ``low`` to ``high``, and of Adam from the best of these;
    and the values of all, in this order."""
    points, values = list[np.ndarray](), list[float]()

    def at(point: np.ndarray) -> np.ndarray:
        value, slopes = jax.device_get(slope_at(dict(zip(start, point, strict=True))))
        if not values and not np.isfinite(value):
            raise ConfigError(f"objective is {value} at the start: expected a finite number")
        points.append(point)
        values.append(float(value) if np.isfinite(value) else np.inf)
        bar.update()
        bar.set_postfix_str(f"objective {min(values):.4g}")
        return np.stack([slopes[name] for name in start])

    try:
        at(np.stack(list(start.values())))
        for pair in itertools.product(np.linspace(low, high, min(GRID, steps)), repeat=len(start)):
            at(np.broadcast_to(np.array(pair)[:, None], points[0].shape))
        point = points[int(np.argmin(values))]
        mean, square, scale = np.zeros_like(point), np.zeros_like(point), 0.0
        for number in range(steps + 1):
            slope = at(point)
            scale = scale or float(np.abs(slope).max())  # LEAST has no unit
            if scale == 0 or not np.isfinite(values[-1]) or not np.isfinite(slope).all():
                break
            mean = MEAN * mean + (1 - MEAN) * slope / scale
            square = SQUARE * square + (1 - SQUARE) * (slope / scale) ** 2
            root = np.sqrt(square / (1 - SQUARE ** (number + 1))) + LEAST
            rate = RATE * (1 + np.cos(np.pi * number / steps)) / 2
            point = np.clip(point - rate * mean / (1 - MEAN ** (number + 1)) / root, low, high)
    except KeyboardInterrupt:
        if not values:
            raise
    return dict(zip(start, points[int(np.argmin(values))], strict=True)), values


@partial(jax.jit, static_argnums=0)
def _value_and_slope(objective: Callable, weights: Weights, tape: Tape, fields: dict[str, Any]) -> Any:
    def value(fields: dict[str, Any]) -> jax.Array:
        at = replace(weights, **{name: jnp.exp(field) for name, field in fields.items()})
        return _number(objective, replay_meso(tape, at, tolerance=1e-8))

    return jax.value_and_grad(value)(fields)


def _number(objective: Callable, vertices: Any) -> jax.Array:
    returned = objective(jnp.asarray(vertices))
    try:
        number = jnp.asarray(returned)
    except (TypeError, ValueError):
        raise ConfigError(f"objective returned {type(returned).__name__}: expected a number") from None
    if number.shape != () or not jnp.issubdtype(number.dtype, jnp.floating):
        what = f"{number.dtype} of shape {number.shape}"
        raise ConfigError(f"objective returned {what}: expected one floating-point number, shape ()")
    return number
