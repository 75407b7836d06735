"""Tune weights by gradient: what a grid cannot do, a value for every vertex, or what the flow itself is to learn.

A run is recorded, and the objective of its replay minimised in the logarithms of the weights, within a box around them:
there the tape may be trusted. Then a fresh run, with decisions of its own, says what the new weights are worth. If they
are better they are taken, with a larger box around them; if not, a full step down the slope is tried, then one up it,
and then the box shrinks, and the old tape is minimised again. A run that did not converge is no ground for a gradient:
then the weights go half-way to the system's own.

This is the one module besides `device.cg` that imports jaxopt.
"""

import warnings
from functools import partial
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

with warnings.catch_warnings():
    warnings.simplefilter("ignore", DeprecationWarning)  # jaxopt announces on import that it is no longer maintained
    import jaxopt

from msf_jax.base.errors import ConfigError, FlowError
from msf_jax.base.options import Weights
from msf_jax.flow.state import Flow
from msf_jax.gradients.replay import replay
from msf_jax.gradients.tape import Comparison, Tape
from msf_jax.tuning.objectives import Objective, value_at
from msf_jax.tuning.result import Tuned, TuningStep
from msf_jax.tuning.runs import Runs

FIRST_BOX, LARGEST_BOX, SMALLEST_BOX = 1.0, 2.5, 0.02  # half its width, in logarithms
GROWTH, SHRINKAGE = 1.6, 0.35
HALF_WAY, NEARLY_THERE = 0.5, 0.99  # parts of the way to the system's own weights
SEARCH_TOLERANCE = 1e-8  # of the solves in a replay: enough for a direction
TIMID = 0.1  # of the box: proposals nearer than that are none
SIDES = (-1, 1)
# What is proposed from a tape, in turn, until something is taken. Its minimum may be its own alone, so a step down the
# slope is next; and where small triangles make the tape's slope steep and short, the flow's own may be the opposite.
MINIMUM, DOWN, UP = range(3)


def descend(
    runs: Runs,
    weights: Weights,
    low: dict[str, float],
    high: dict[str, float],
    steps: int,
    inner_steps: int,
    bar: Any,
) -> Tuned:
    """At most ``steps`` proposals by the tapes, from ``weights``; a taken one has been confirmed by fresh runs."""
    search = _Descent(runs, weights)
    config = runs.config
    box, way, kind, reason = FIRST_BOX, HALF_WAY, MINIMUM, "as many as were asked for"
    try:
        for _ in range(steps):
            here = logarithms(search.weights)
            if search.is_converged:
                tapes = [run.tape for run in search.flows]
                there, expected, kind = proposal(
                    runs.objective, search.weights, tapes, here, box, low, high, kind, inner_steps
                )
                nowhere = f"{runs.objective.name} does not depend on the weights, by the tapes"
            else:  # such a run is stuck in a few vertices, and its gradient is theirs
                goal = logarithms(config.default_weights())
                there = {name: here[name] + way * (goal.get(name, here[name]) - here[name]) for name in here}
                there, expected = {name: np.clip(there[name], low[name], high[name]) for name in here}, np.nan
                nowhere = f"runs do not converge ({search.why}), nor is there a way on to the system's own weights"
            if not distance(here, there) > 0:
                reason = nowhere
                break
            is_taken = search.propose(with_logarithms(search.weights, there), expected, box)
            if search.is_converged:
                if is_taken:
                    box, kind = min(box * GROWTH, LARGEST_BOX), MINIMUM
                elif kind == UP:
                    box, kind = box * SHRINKAGE, MINIMUM
                else:
                    kind += 1
            else:
                way = HALF_WAY if is_taken else (way + 1) / 2
            bar.update(1, f"objective {search.value:.4g}, box {box:.2f}")
            if box < SMALLEST_BOX or way > NEARLY_THERE:
                reason = "no better weights nearby"
                break
    except KeyboardInterrupt:
        reason = "interrupted"
    return Tuned(search.weights, search.value, search.flows, tuple(search.trajectory), reason)


class _Descent:
    """The best weights so far, their runs, and what was tried."""

    def __init__(self, runs: Runs, weights: Weights):
        self.runs, self.weights, self.flows = runs, weights, runs.flows(weights)
        self.value = runs.value(self.flows)
        if not np.isfinite(self.value):
            raise ConfigError(f"objective {runs.objective.name} is {self.value} at the start: expected a finite number")
        none = Comparison(0, sum(len(run.tape.decisions) for run in self.flows))
        self.trajectory = [TuningStep(weights, self.value, self.value, True, FIRST_BOX, self.is_converged, none)]

    @property
    def is_converged(self) -> bool:
        """Whether all of the best weights' runs ended as they should."""
        return all(run.skeleton.report.converged for run in self.flows)

    @property
    def why(self) -> str:
        """Why the first that did not ended."""
        return next(run.skeleton.report.reason for run in self.flows if not run.skeleton.report.converged)

    def propose(self, weights: Weights, expected: float, box: float) -> bool:
        """Run with ``weights``; take them if they are better, or if their runs converge and those before did not."""
        try:
            fresh = self.runs.flows(weights)
        except FlowError:
            self.trajectory.append(TuningStep(weights, expected, np.inf, False, box, False, Comparison(0, 0)))
            return False
        found = self.runs.value(fresh)
        converges = all(run.skeleton.report.converged for run in fresh)
        is_taken = (converges, -found) > (self.is_converged, -self.value) and bool(np.isfinite(found))
        changed = _compared(self.flows, fresh)
        self.trajectory.append(TuningStep(weights, expected, found, is_taken, box, converges, changed))
        if is_taken:
            self.weights, self.flows, self.value = weights, fresh, found
        return is_taken


def proposal(
    objective: Objective,
    weights: Weights,
    tapes: list[Tape],
    here: dict[str, Any],
    box: float,
    low: dict[str, float],
    high: dict[str, float],
    kind: int,
    inner_steps: int,
) -> tuple[dict[str, Any], float, int]:
    """The logarithms within ``box`` of ``here`` that are best by the tapes, the objective there, and which kind it is.

    Where no minimum is found, or another ``kind`` is asked for, those at the end of the box down the slope, or up.
    """

    def clipped(point: dict[str, Any]) -> dict[str, Any]:
        return {name: np.clip(np.asarray(point[name]), low[name], high[name]) for name in here}

    around = tuple(clipped({name: here[name] + side * box for name in here}) for side in SIDES)
    found, slope = first = _mean_value(objective, here, weights, tapes)
    steepest = max(float(np.abs(part).max()) for part in slope.values())
    if not np.isfinite(found) or not np.isfinite(steepest):
        raise ConfigError(
            f"objective {objective.name} has the value {float(found)} and a slope of {steepest} at the recorded "
            "curve: expected finite numbers"
        )
    if steepest == 0:
        return here, float(found), kind
    if kind == MINIMUM:

        def fun(logarithms: dict[str, Any]) -> Any:
            is_first = all(np.array_equal(logarithms[name], here[name]) for name in here)
            return first if is_first else _mean_value(objective, logarithms, weights, tapes)

        solver = jaxopt.ScipyBoundedMinimize(
            fun=fun,
            method="L-BFGS-B",
            maxiter=inner_steps,
            options={"maxfun": 2 * inner_steps},
            value_and_grad=True,
            jit=False,
        )
        there, state = solver.run(here, around)
        there = clipped(there)
        if np.isfinite(state.fun_val) and distance(here, there) >= TIMID * box:
            return there, float(state.fun_val), MINIMUM
        kind = DOWN  # its line search has failed
    length = box / steepest * (-1 if kind == DOWN else 1)
    return clipped({name: here[name] + length * np.asarray(slope[name]) for name in here}), np.nan, kind


def _mean_value(objective: Objective, logarithms: dict[str, Any], weights: Weights, tapes: list[Tape]) -> Any:
    """The objective's mean over the tapes, and its gradient in the logarithms."""
    results = [_value_and_grad(objective, logarithms, weights, tape) for tape in tapes]
    mean, gradient = jax.tree_util.tree_map(lambda *parts: sum(parts) / len(parts), *results)
    return mean, gradient


def _value_and_grad(objective: Objective, logarithms: dict[str, Any], weights: Weights, tape: Tape) -> Any:
    """In two halves, as a fresh tape has another number of nodes: the replay, the slow one to compile, is padded."""

    def nodes_at(logarithms: dict[str, Any]) -> jax.Array:
        return replay(tape, with_logarithms(weights, logarithms), tolerance=SEARCH_TOLERANCE)

    nodes, pull_back = jax.vjp(nodes_at, logarithms)
    found, slope = _at_nodes(objective, nodes, tape)
    return found, pull_back(slope)[0]


def distance(one: dict[str, np.ndarray], other: dict[str, np.ndarray]) -> float:
    return max(float(np.abs(one[name] - other[name]).max()) for name in one)


def logarithms(weights: Weights) -> dict[str, np.ndarray]:
    """Of the weights that are not 0, by name."""
    named = {name: np.asarray(weight, dtype=np.float64) for name, weight in vars(weights).items()}
    return {name: np.log(weight) for name, weight in named.items() if (weight > 0).all()}


def with_logarithms(weights: Weights, logarithms: dict[str, Any]) -> Weights:
    exp = jnp.exp if any(isinstance(value, jax.Array) for value in logarithms.values()) else np.exp
    return Weights(**(vars(weights) | {name: exp(value) for name, value in logarithms.items()}))


@partial(jax.jit, static_argnums=0)
def _at_nodes(objective: Objective, nodes: jax.Array, tape: Tape) -> tuple[jax.Array, jax.Array]:
    return jax.value_and_grad(lambda nodes: value_at(objective, tape, nodes))(nodes)


def _compared(before: tuple[Flow, ...], after: tuple[Flow, ...]) -> Comparison:
    pairs = [one.tape.compare(other.tape) for one, other in zip(before, after, strict=True)]
    return Comparison(sum(pair.different for pair in pairs), sum(pair.total for pair in pairs))
