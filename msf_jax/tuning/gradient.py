"""Tuning by gradient, for weights per vertex, and for objectives of the flow's curve.

A run is recorded, and the objective of its replay is minimised in the logarithms of the weights, within a trust region,
the box. Then a fresh run, with its own decisions, gives the value of the new weights. If it is better, the weights are
accepted, and the box grows. If not, a full step down the slope is tried, then one up the slope; then the box shrinks,
and the old tape is minimised again. The system's default weights are tried first. The gradient of a run that did not
converge is of no use. Runs have tight solves: else a tape does not predict them, even where no decision changes.
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

FIRST_BOX = 1.0  # natural logarithms: half the width of the first box
LARGEST_BOX = 2.5  # natural logarithms: its largest value
SMALLEST_BOX = 0.02  # natural logarithms: the tuning ends below it
GROWTH = 1.6  # factor on the box after an accepted proposal
SHRINKAGE = 0.35  # factor on the box after rejected ones
SEARCH_TOLERANCE = 1e-8  # relative residual of the solves in a replay, sufficient for a direction
TIMID = 0.1  # share of the box: a minimum closer to the start is not proposed
BOX_SIDES = (-1, 1)  # the lower and the upper side of the box
# The kinds of proposals from a tape, tried in turn until one is accepted. The tape's minimum may be an artefact of the
# tape, so a step down the slope follows. Small triangles can make the tape's slope the opposite of the flow's, so a
# step up the slope comes last.
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
    """Make at most ``steps`` proposals by the tapes, from ``weights``. Fresh runs confirm a proposal."""
    search = _Descent(runs, weights)
    box, kind, reason = FIRST_BOX, MINIMUM, "all steps made"
    try:
        search.try_defaults(low, high)
        for _ in range(steps):
            if not search.is_converged:
                reason = f"runs do not converge ({search.why})"
                break
            here = logarithms(search.weights)
            there, expected, kind = proposal(
                runs.objective, search.weights, search.tapes(), here, box, low, high, kind, inner_steps
            )
            if not distance(here, there) > 0:
                reason = f"{runs.objective.name} does not depend on the weights within their bounds, by the tapes"
                break
            if search.propose(with_logarithms(search.weights, there), expected, box):
                box, kind = min(box * GROWTH, LARGEST_BOX), MINIMUM
            elif kind == UP:
                box, kind = box * SHRINKAGE, MINIMUM
            else:
                kind += 1
            bar.update(1, f"objective {search.value:.4g}, box {box:.2f}")
            if box < SMALLEST_BOX:
                reason = "no better weights nearby"
                break
    except KeyboardInterrupt:
        reason = "interrupted"
    return Tuned(
        search.weights, search.value, search.flows, tuple(search.trajectory), reason, of_defaults=search.of_defaults
    )


class _Descent:
    """The best weights so far, their runs, and all proposals."""

    def __init__(self, runs: Runs, weights: Weights):
        self.runs, self.weights, self.flows = runs, weights, runs.flows(weights)
        self.value = runs.value(self.flows)
        self.of_defaults = np.nan
        self.padded: list[Tape] = []
        if not np.isfinite(self.value):
            raise ConfigError(f"objective {runs.objective.name} is {self.value} at the start: expected a finite number")
        none = Comparison(0, sum(len(run.tape.decisions) for run in self.flows))
        self.trajectory = [TuningStep(weights, self.value, self.value, True, FIRST_BOX, self.is_converged, none)]

    def try_defaults(self, low: dict[str, float], high: dict[str, float]) -> None:
        """Propose the system's default weights, within the bounds, where weights may change."""
        here, usual = logarithms(self.weights), vars(self.runs.config.default_weights())
        there = {  # numbers as they are: a logarithm and back changes last bits, and those can change a curve
            name: np.full_like(value, np.clip(usual[name], np.exp(low[name]), np.exp(high[name])))
            for name, value in here.items()
            if usual[name] > 0
        }
        self.of_defaults = self.value
        if any((vars(self.weights)[name] != value).any() for name, value in there.items()):
            self.propose(Weights(**(vars(self.weights) | there)), np.nan, FIRST_BOX)
            self.of_defaults = self.trajectory[-1].found

    def tapes(self) -> list[tuple[Tape, Tape]]:
        """The tape of each of the best runs, and the same in the buffers of the one before, to compile few programs."""
        held = self.padded or [run.tape.padded() for run in self.flows]
        self.padded = [run.tape_like(one) for run, one in zip(self.flows, held, strict=True)]
        return [(run.tape, one) for run, one in zip(self.flows, self.padded, strict=True)]

    @property
    def is_converged(self) -> bool:
        """Whether all runs of the best weights converged."""
        return all(run.skeleton.report.converged for run in self.flows)

    @property
    def why(self) -> str:
        """Why the first run that did not converge ended."""
        return next(run.skeleton.report.reason for run in self.flows if not run.skeleton.report.converged)

    def propose(self, weights: Weights, expected: float, box: float) -> bool:
        """Run with ``weights``. Accept them if only their runs
        converge, or if as many do and the value is better."""
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
    tapes: list[tuple[Tape, Tape]],
    here: dict[str, Any],
    box: float,
    low: dict[str, float],
    high: dict[str, float],
    kind: int,
    inner_steps: int,
) -> tuple[dict[str, Any], float, int]:
    """A proposal: logarithms within ``box`` of ``here``, the objective there by the tapes, and the kind of proposal.

    ``tapes``: of each mesh, and the same padded. A minimum is replaced by the point at the end of the box, down the
    slope, if there is none, or none as far away as `TIMID`; one at bounds that block it by the other direction.
    """

    def clipped(point: dict[str, Any]) -> dict[str, Any]:
        return {name: np.clip(np.asarray(point[name]), low[name], high[name]) for name in here}

    around = tuple(clipped({name: here[name] + side * box for name in here}) for side in BOX_SIDES)
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
        kind = DOWN  # no minimum was found, or none as far away as `TIMID`
    there = here
    for tried in range(kind, UP + 1):
        kind, length = tried, box / steepest * (-1 if tried == DOWN else 1)
        there = clipped({name: here[name] + length * np.asarray(slope[name]) for name in here})
        if distance(here, there) > 0:  # else all weights are at bounds that the slope leads out of
            break
    return there, np.nan, kind


def _mean_value(
    objective: Objective, logarithms: dict[str, Any], weights: Weights, tapes: list[tuple[Tape, Tape]]
) -> Any:
    """The objective's mean over the tapes, and its gradient in the logarithms."""
    results = [_value_and_grad(objective, logarithms, weights, *pair) for pair in tapes]
    mean, gradient = jax.tree_util.tree_map(lambda *parts: sum(parts) / len(parts), *results)
    return mean, gradient


def _value_and_grad(
    objective: Objective, logarithms: dict[str, Any], weights: Weights, tape: Tape, padded: Tape
) -> Any:
    """The objective and its gradient. Only the objective's own program depends on the number of nodes."""
    nodes, pull_back = _replayed(logarithms, weights, padded)
    found, slope = _at_nodes(objective, np.asarray(nodes)[: tape.num_nodes], tape)
    rest = ((0, len(nodes) - tape.num_nodes), (0, 0))
    return found, _pulled(pull_back, np.pad(np.asarray(slope), rest))


@jax.jit
def _replayed(logarithms: dict[str, Any], weights: Weights, tape: Tape) -> Any:
    """The nodes, and the function that pulls their derivative back, which is a pytree."""

    def nodes_at(logarithms: dict[str, Any]) -> jax.Array:
        return replay(tape, with_logarithms(weights, logarithms), tolerance=SEARCH_TOLERANCE)

    return jax.vjp(nodes_at, logarithms)


@jax.jit
def _pulled(pull_back: Any, slope: jax.Array) -> dict[str, jax.Array]:
    return pull_back(slope)[0]


def distance(one: dict[str, np.ndarray], other: dict[str, np.ndarray]) -> float:
    return max(float(np.abs(one[name] - other[name]).max()) for name in one)


def logarithms(weights: Weights) -> dict[str, np.ndarray]:
    """The natural logarithms of the weights that are positive everywhere, by name."""
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
