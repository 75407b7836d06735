"""Tune the flow's weights by gradient, for one mesh or for several jointly.

A run is recorded, and the objective of its replay minimised in the logarithms of the weights, within a box around them:
there the tape may be trusted. Then a fresh run, with decisions of its own, says what the new weights are worth. If they
are better they are taken, with a larger box around them; if not, a full step down the slope is tried, then one up it,
and then the box shrinks, and the old tape is minimised again.
A run that did not converge is no ground for a gradient: then the weights go half-way to the system's own.

This is the one module besides `device.cg` that imports jaxopt.
"""

import numbers
import os
import warnings
from collections.abc import Callable
from dataclasses import dataclass, fields
from functools import partial
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
from tqdm import tqdm

with warnings.catch_warnings():
    warnings.simplefilter("ignore", DeprecationWarning)  # jaxopt announces on import that it is no longer maintained
    import jaxopt

from msf_jax.base.errors import ConfigError, FlowError
from msf_jax.base.options import Config, Weights
from msf_jax.flow import loop
from msf_jax.flow.request import checked_options
from msf_jax.flow.state import Flow
from msf_jax.gradients.replay import replay
from msf_jax.gradients.tape import Comparison, Tape
from msf_jax.tuning.objectives import Objective, as_objective, value_at

SEARCH_TOLERANCE = 1e-8  # of the solves in a replay: enough for a direction
FIRST_BOX, LARGEST_BOX, SMALLEST_BOX = 1.0, 2.5, 0.02  # half its width, in logarithms
GROWTH, SHRINKAGE = 1.6, 0.35
TIMID = 0.1  # of the box: proposals nearer than that are none
SIDES = (-1, 1)
# What is proposed from a tape, in turn, until something is taken. Its minimum may be its own alone, so a step down the
# slope is next; and where small triangles make the tape's slope steep and short, the flow's own may be the opposite.
MINIMUM, DOWN, UP = range(3)
HALF_WAY, NEARLY_THERE = 0.5, 0.99  # parts of the way to the system's own weights
WIDEST = (1e-6, 1e4)  # bounds of a weight, where none are given


class TuningStep(NamedTuple):
    """One proposal. The first is the start.

    weights: proposed. expected: of the objective, by the tapes; NaN for a proposal without them. found: by fresh runs;
    inf if one broke down. is_taken: whether the weights were. box: half the width of the trust region, in logarithms.
    converges: whether all of the fresh runs did. changed: decisions that they made differently from the runs of the
    weights before, of all that they made.
    """

    weights: Weights
    expected: float
    found: float
    is_taken: bool
    box: float
    converges: bool
    changed: Comparison


@dataclass(frozen=True)
class Tuned:
    """The result of `tune`.

    Attributes:
        weights: the best that were found.
        value: of the objective there, by fresh runs, the mean over the meshes.
        flows: those runs, one for each mesh.
        trajectory: every proposal, in order.
        reason: why it stopped.
    """

    weights: Weights
    value: float
    flows: tuple[Flow, ...]
    trajectory: tuple[TuningStep, ...]
    reason: str

    def __str__(self) -> str:
        lines = [f"{len(self.trajectory) - 1} steps, {self.reason}", "objective   expected   box    decisions changed"]
        for step in self.trajectory:
            weights = ", ".join(f"{name} {_shown(weight)}" for name, weight in vars(step.weights).items())
            changed = f"{step.changed.different} of {step.changed.total}"
            mark = "taken" if step.is_taken else "     "
            lines.append(f"{step.found:<11.6g} {step.expected:<10.6g} {step.box:.3f}  {changed:<16} {mark}  {weights}")
        return "\n".join(lines)


def tune(
    meshes: Any,
    objective: Objective | Callable[..., Any],
    weights: Weights | None = None,
    *,
    config: Config | None = None,
    bounds: dict[str, tuple[float, float]] | tuple[float, float] = WIDEST,
    steps: int = 12,
    inner_steps: int = 3,
    progress: bool = False,
) -> Tuned:
    """Find weights whose curves are better, by gradient steps on recorded runs that fresh runs confirm.

    Args:
        meshes: one mesh, as `contract` takes it, or a list of them, which are tuned jointly: the mean counts.
        objective: one of `msf_jax.objectives`, a sum of them, or a JAX function of ``(nodes (N, 3), radii (N,))`` that
            returns a number, the less the better.
        weights: to start from; those of ``config``'s system if not given. One that is 0, or an array with a 0 in it,
            stays as it is. Arrays, one value for each vertex, are possible for a single mesh.
        config: of the runs.
        bounds: lowest and highest value of every weight, or of each by name; where they are the same it stays.
        steps: fresh runs on each mesh, after the first.
        inner_steps: of L-BFGS on the tapes, before each.
        progress: show a progress bar on standard error, if that is a terminal.

    Returns:
        The best weights, their runs, every proposal, and why it stopped.

    The gradient knows the decisions of the recorded run, and not how they would change: what an iteration merges, and
    how many iterations there are. So many proposals are not taken, and what is found is the best of what was tried, no
    global minimum. ``trajectory`` says how many decisions each fresh run changed. Weights whose runs converge are
    preferred to those whose do not, whatever the objective says; from a start that does not converge the first steps
    lead half-way, in logarithms, to the weights of ``config``'s system. Ctrl-C ends it with what was found so far.

    Raises:
        ConfigError: a weight is out of ``bounds``, an option is of the wrong kind, the objective returns no number, or
            it or its slope is not finite.
        MeshError, FlowError: see `contract`.
    """
    objective = as_objective(objective)
    weights, config = checked_options(weights, config)
    meshes = _listed(meshes)
    low, high = _checked_bounds(weights, bounds)
    for name, number in (("steps", steps), ("inner_steps", inner_steps)):
        if isinstance(number, bool) or not isinstance(number, numbers.Integral) or number < 1:
            raise ConfigError(f"{name} is {number!r}: expected a whole number of 1 or more")

    search = _Search(meshes, objective, config)
    search.start(weights)
    box, way, kind, reason = FIRST_BOX, HALF_WAY, MINIMUM, "as many as were asked for"
    with tqdm(total=steps, desc="tune", unit="run", disable=None if progress else True) as bar:
        try:
            for _ in range(steps):
                here = _logarithms(search.weights)
                if search.is_converged:
                    there, expected, kind = _proposal(search, here, box, low, high, kind, int(inner_steps))
                    nowhere = f"{objective.name} does not depend on the weights, by the tapes"
                else:  # such a run is stuck in a few vertices, and its gradient is theirs
                    goal = _logarithms(config.default_weights())
                    there = {name: here[name] + way * (goal.get(name, here[name]) - here[name]) for name in here}
                    there, expected = {name: np.clip(there[name], low[name], high[name]) for name in here}, np.nan
                    nowhere = f"runs do not converge ({search.why}), nor is there a way on to the system's own weights"
                reach = _distance(here, there)
                if not reach > 0:
                    reason = nowhere
                    break
                is_taken = search.propose(_with_logarithms(search.weights, there), expected, box)
                if search.is_converged:
                    if is_taken:
                        box, kind = min(box * GROWTH, LARGEST_BOX), MINIMUM
                    elif kind == UP:
                        box, kind = box * SHRINKAGE, MINIMUM
                    else:
                        kind += 1
                else:
                    way = HALF_WAY if is_taken else (way + 1) / 2
                bar.set_postfix(objective=f"{search.value:.4g}", box=f"{box:.2f}")
                bar.update()
                if box < SMALLEST_BOX or way > NEARLY_THERE:
                    reason = "no better weights nearby"
                    break
        except KeyboardInterrupt:
            reason = "interrupted"
    return Tuned(search.weights, search.value, search.flows, tuple(search.trajectory), reason)


class _Search:
    """The best weights so far, their runs, and what was tried."""

    def __init__(self, meshes: list[Any], objective: Objective, config: Config):
        self.meshes, self.objective, self.config = meshes, objective, config
        self.trajectory: list[TuningStep] = []

    def start(self, weights: Weights) -> None:
        self.weights = weights
        self.flows = tuple(loop.contract(mesh, weights, self.config) for mesh in self.meshes)
        self.value = _found(self.objective, self.flows)
        if not np.isfinite(self.value):
            raise ConfigError(f"objective {self.objective.name} is {self.value} at the start: expected a finite number")
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
            fresh = tuple(loop.contract(mesh, weights, self.config) for mesh in self.meshes)
        except FlowError:
            self.trajectory.append(TuningStep(weights, expected, np.inf, False, box, False, Comparison(0, 0)))
            return False
        found = _found(self.objective, fresh)
        converges = all(run.skeleton.report.converged for run in fresh)
        is_taken = (converges, -found) > (self.is_converged, -self.value) and bool(np.isfinite(found))
        changed = _compared(self.flows, fresh)
        self.trajectory.append(TuningStep(weights, expected, found, is_taken, box, converges, changed))
        if is_taken:
            self.weights, self.flows, self.value = weights, fresh, found
        return is_taken


def _proposal(
    search: _Search,
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

    tapes = [run.tape for run in search.flows]
    around = tuple(clipped({name: here[name] + side * box for name in here}) for side in SIDES)
    found, slope = first = _mean_value(search.objective, here, search.weights, tapes)
    steepest = max(float(np.abs(part).max()) for part in slope.values())
    if not np.isfinite(found) or not np.isfinite(steepest):
        raise ConfigError(
            f"objective {search.objective.name} has the value {float(found)} and a slope of {steepest} at the recorded "
            "curve: expected finite numbers"
        )
    if steepest == 0:
        return here, float(found), kind
    if kind == MINIMUM:

        def fun(logarithms: dict[str, Any]) -> Any:
            is_first = all(np.array_equal(logarithms[name], here[name]) for name in here)
            return first if is_first else _mean_value(search.objective, logarithms, search.weights, tapes)

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
        if np.isfinite(state.fun_val) and _distance(here, there) >= TIMID * box:
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
        return replay(tape, _with_logarithms(weights, logarithms), tolerance=SEARCH_TOLERANCE)

    nodes, pull_back = jax.vjp(nodes_at, logarithms)
    found, slope = _at_nodes(objective, nodes, tape)
    return found, pull_back(slope)[0]


@partial(jax.jit, static_argnums=0)
def _at_nodes(objective: Objective, nodes: jax.Array, tape: Tape) -> tuple[jax.Array, jax.Array]:
    return jax.value_and_grad(lambda nodes: value_at(objective, tape, nodes))(nodes)


def _found(objective: Objective, flows: tuple[Flow, ...]) -> float:
    """The objective's mean over runs, of their curves as the flow left them."""
    found = [_at_nodes(objective, jnp.asarray(run.curve.vertices), run.tape)[0] for run in flows]
    return float(np.mean([float(one) for one in found]))


def _distance(one: dict[str, np.ndarray], other: dict[str, np.ndarray]) -> float:
    return max(float(np.abs(one[name] - other[name]).max()) for name in one)


def _compared(before: tuple[Flow, ...], after: tuple[Flow, ...]) -> Comparison:
    pairs = [one.tape.compare(other.tape) for one, other in zip(before, after, strict=True)]
    return Comparison(sum(pair.different for pair in pairs), sum(pair.total for pair in pairs))


def _logarithms(weights: Weights) -> dict[str, np.ndarray]:
    """Of the weights that are not 0, by name."""
    named = {name: np.asarray(weight, dtype=np.float64) for name, weight in vars(weights).items()}
    return {name: np.log(weight) for name, weight in named.items() if (weight > 0).all()}


def _with_logarithms(weights: Weights, logarithms: dict[str, Any]) -> Weights:
    exp = jnp.exp if any(isinstance(value, jax.Array) for value in logarithms.values()) else np.exp
    return Weights(**(vars(weights) | {name: exp(value) for name, value in logarithms.items()}))


def _listed(meshes: Any) -> list[Any]:
    """One mesh or many as a list; a pair of arrays is one mesh."""

    def is_mesh(item: Any) -> bool:
        is_pair = isinstance(item, tuple) and len(item) == 2
        return isinstance(item, str | os.PathLike) or hasattr(item, "faces") or is_pair

    if isinstance(meshes, list | tuple) and not len(meshes):
        raise ConfigError("meshes is empty: expected one mesh, or a list of them; no mesh, nothing to tune for")
    if isinstance(meshes, list | tuple) and all(is_mesh(item) for item in meshes):
        return list(meshes)
    return [meshes]


def _checked_bounds(weights: Weights, bounds: Any) -> tuple[dict[str, float], dict[str, float]]:
    """Logarithms of the lowest and the highest value of every weight."""
    names = [member.name for member in fields(Weights)]
    pairs: dict[str, Any] = bounds if isinstance(bounds, dict) else dict.fromkeys(names, bounds)
    low, high = {}, {}
    for name in [*names, *pairs]:
        pair = pairs.get(name, WIDEST)
        if name not in names:
            raise ConfigError(f"bounds name {name!r}: expected one of {', '.join(names)}")
        try:
            first, last = (float(end) for end in pair)
        except (TypeError, ValueError):
            first = last = 0.0
        if not 0 < first <= last < np.inf:
            raise ConfigError(
                f"bounds of {name} are {pair!r}: expected (lowest, highest), finite, with 0 < lowest <= highest"
            )
        weight = np.asarray(getattr(weights, name), dtype=np.float64)
        if (weight > 0).all() and not ((first <= weight) & (weight <= last)).all():
            raise ConfigError(f"Weights.{name} is {_shown(weight)}: expected a start within its bounds {pair!r}")
        low[name], high[name] = np.log(first), np.log(last)
    return low, high


def _shown(weight: Any) -> str:
    return f"{float(weight):.4g}" if np.ndim(weight) == 0 else f"{np.min(weight):.3g} to {np.max(weight):.3g}"
