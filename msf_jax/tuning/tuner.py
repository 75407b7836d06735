"""`tune`: tuning of the flow's weights, for one mesh or for several jointly.

Scalar weights are searched by fresh runs and a model of them (`search`), weights per vertex by gradient: of the
contracted surface without decisions (`surface`), or of the flow's curve (`gradient`). `runs` computes the objective.
"""

import numbers
import os
from collections.abc import Callable
from dataclasses import fields
from typing import Any

import numpy as np

from msf_jax.base.errors import ConfigError
from msf_jax.base.options import Config, Weights
from msf_jax.base.progress import showing
from msf_jax.flow.loop import checked_options
from msf_jax.tuning.gradient import descend, logarithms, with_logarithms
from msf_jax.tuning.objectives import Objective, as_objective
from msf_jax.tuning.result import Tuned, TuningStep, shown
from msf_jax.tuning.runs import OF, Runs
from msf_jax.tuning.search import FIRST_SPREAD, Search
from msf_jax.tuning.surface import FIELD_BOUNDS, FIELDS, tuned_on_tape

WIDEST = (1e-6, 1e4)  # default bounds of a weight, without unit


def tune(
    meshes: Any,
    objective: Objective | Callable[..., Any],
    weights: Weights | None = None,
    *,
    config: Config | None = None,
    bounds: dict[str, tuple[float, float]] | tuple[float, float] = WIDEST,
    of: str = "skeleton",
    steps: int = 24,
    inner_steps: int = 3,
    jobs: int = 1,
    checkpoint: str | os.PathLike[str] | None = None,
    progress: bool = False,
) -> Tuned:
    """Find weights with a lower objective, by fresh runs and a model of them, or by gradients.

    Args:
        meshes: one mesh, as `contract` takes it, or a list of them; for a list the mean of the objective is reduced.
        objective: one of `msf_jax.objectives`, a sum of them, or a JAX function of ``(nodes (N, 3), radii (N,))`` that
            returns a number; lower is better.
        weights: the start; those of ``config``'s system if not given. A weight that is 0, or an array that contains 0,
            is not changed. Arrays, with one value for each vertex, are possible for a single mesh.
        config: of the runs. For of="surface" the default is `Config.smooth`, else ``Config()``.
        bounds: lowest and highest value of every weight, or by name. A weight with equal bounds is not changed. For
            of="surface" the default is 0.01 to 100 for w_H and w_M: beyond, the solves are no longer tight.
        of: "skeleton" for the objective of the finished curve, "flow" for that of the flow's curve, or "surface" for
            that of the contracted surface, whose vertices count as nodes, see `objectives.of_surface`.
        steps: the number of fresh runs on each mesh, after the first. For of="surface" that of steps of Adam.
        inner_steps: steps of L-BFGS on the tapes before each fresh run, if gradients are used.
        jobs: processes that make fresh runs in parallel; more than one needs ``if __name__ == "__main__":``.
        checkpoint: a file that stores the values of runs. An interrupted tuning continues from it, with the same
            proposals. It identifies the meshes and the config, but an objective only by its name.
        progress: show a progress bar on standard error, or plain lines if that is no terminal.

    Returns:
        The best weights, their runs, every proposal, the value of the default weights, and why the tuning stopped.

    Scalar weights are searched by fresh runs, see `tuning.search`. Only the ratios of w_L, w_H and w_M matter, so w_L
    is held constant if all three may change. Weights per vertex, and any weights for the flow's curve, are moved by the
    tapes' gradients and confirmed by fresh runs, see `tuning.gradient`. These have tight solves (`Config.tight`): use
    ``tuned.flows[0].config`` with the weights. ``jobs`` and ``checkpoint`` are not supported there.

    With of="surface" nothing is decided in a run of one mesh, and one tape is enough: numbers w_H and w_M are searched
    on it, then made fields by Adam, a weight for every vertex. One fresh run ends the tuning. ``reason`` says how far
    its value is from the tape's. See `tuning.surface`.

    Weights whose runs converge are preferred to others, whatever the objective. The result is the best of the
    tried weights, not a global minimum. After Ctrl-C it is the best so far.

    Raises:
        ConfigError: a weight is out of ``bounds``, an option has a wrong type, the objective returns no number, or its
            value or gradient is not finite.
        MeshError, FlowError: see `contract`.
    """
    weights, config = checked_options(weights, Config.smooth() if of == "surface" and config is None else config)
    meshes = _listed(meshes)
    objective = as_objective(objective)
    if of == "surface" and len(meshes) > 1:
        raise ConfigError(
            f"of='surface' was given with {len(meshes)} meshes: expected one, whose vertices have weights"
        )
    if of == "surface" and bounds is WIDEST:
        bounds = dict.fromkeys(FIELDS, FIELD_BOUNDS)
    low, high = _checked_bounds(weights, bounds)
    for name, number in (("steps", steps), ("inner_steps", inner_steps), ("jobs", jobs)):
        if isinstance(number, bool) or not isinstance(number, numbers.Integral) or number < 1:
            raise ConfigError(f"{name} is {number!r}: expected a whole number of 1 or more")
    if of not in OF:
        raise ConfigError(f"of is {of!r}: expected one of {', '.join(OF)}")
    is_plain = all(np.ndim(weight) == 0 for weight in vars(weights).values())
    by_search = of == "skeleton" and is_plain
    if not by_search and (jobs > 1 or checkpoint is not None):
        raise ConfigError(f"jobs or checkpoint was given with arrays of weights or of={of!r}: expected neither there")
    if of == "surface" and (config.flow.edit_connectivity or not is_plain):
        what = "edits edges" if config.flow.edit_connectivity else "has weights per vertex already"
        raise ConfigError(f"of='surface' was given, and the run {what}: expected numbers, and Config.smooth()")
    if not by_search:
        config = config.tight()
    runs = Runs(meshes, objective, config, of, jobs, checkpoint)
    with showing(int(steps), "tune", "runs", progress) as bar:
        if of == "surface":
            here = logarithms(weights)
            free = [name for name in FIELDS if name in here and low[name] < high[name]]
            if not free:
                raise ConfigError("w_H and w_M are 0 or held by their bounds: expected one that is free to change")
            given = [np.frombuffer(point) for point in _given(weights, config, free, low, high)]
            ends = _ends(low, free), _ends(high, free)
            return tuned_on_tape(runs, objective, weights, free, given, *ends, int(steps), bar)
        if by_search:
            return _searched(runs, weights, low, high, int(steps), bar)
        return descend(runs, weights, low, high, int(steps), int(inner_steps), bar)


def _searched(
    runs: Runs, weights: Weights, low: dict[str, float], high: dict[str, float], steps: int, bar: Any
) -> Tuned:
    """At most ``steps`` runs after the first, proposed by a model of earlier runs; see `tuning.search`."""
    here = logarithms(weights)
    free = [name for name in here if low[name] < high[name]]
    if {"w_L", "w_H", "w_M"} <= set(free):
        free.remove("w_L")  # only ratios matter

    given = _given(weights, runs.config, free, low, high)

    def placed(point: np.ndarray) -> Weights:
        return given.get(point.tobytes()) or with_logarithms(weights, dict(zip(free, point.tolist(), strict=True)))

    best = runs.found([weights])[0]
    if not np.isfinite(best.value):
        raise ConfigError(f"objective {runs.objective.name} is {best.value} at the start: expected a finite number")
    trajectory = [TuningStep(weights, best.value, best.value, True, FIRST_SPREAD, best.converges, None)]
    if not free:
        return Tuned(weights, best.value, runs.flows(weights), tuple(trajectory), "no weight is free to change")
    reason, found_at = "all steps made", weights
    search = Search([np.frombuffer(point) for point in given], _ends(low, free), _ends(high, free))
    search.tell(search.ask(), np.array([best.value if best.converges else np.inf]))
    try:
        while len(trajectory) <= steps:
            points = search.ask(min(runs.jobs, steps + 1 - len(trajectory)))
            expected, spread = search.expected(points), search.spread
            proposals = [placed(point) for point in points]
            found = runs.found(proposals)
            search.tell(points, np.array([one.value if one.converges else np.inf for one in found]))
            for proposal, one, guess in zip(proposals, found, expected.tolist(), strict=True):
                is_taken = np.isfinite(one.value) and (one.converges, -one.value) > (best.converges, -best.value)
                trajectory.append(TuningStep(proposal, guess, one.value, is_taken, spread, one.converges, None))
                if is_taken:
                    best, found_at = one, proposal
            bar.update(len(points), f"objective {best.value:.4g}")
    except KeyboardInterrupt:
        reason = "interrupted"
    finally:
        runs.close()
    usual = [step.found for step in trajectory if step.weights is list(given.values())[-1]]
    of_defaults = usual[0] if usual else np.nan
    return Tuned(found_at, best.value, runs.flows(found_at), tuple(trajectory), reason, of_defaults=of_defaults)


def _given(
    weights: Weights, config: Config, free: list[str], low: dict[str, float], high: dict[str, float]
) -> dict[bytes, Weights]:
    """The first weights to try, by the bytes of their points: the start, and the system's default weights.

    Default weights are clipped to their bounds. The dictionary keeps exact weights, because a logarithm and an
    exponential change their last bits, which can change a curve.
    """
    here, usual = logarithms(weights), config.default_weights()
    own = logarithms(usual)
    lift = 0.0 if "w_L" in free or "w_L" not in here else here["w_L"] - own["w_L"]  # only ratios matter
    start = np.array([float(here[name]) for name in free])
    wanted = [own[name] + lift * (name != "smoothing") if name in own else here[name] for name in free]
    clipped = np.clip(np.array(wanted, dtype=np.float64), _ends(low, free), _ends(high, free))
    given = {start.tobytes(): weights}
    if not np.allclose(start, clipped):
        is_own = lift == 0 and np.array_equal(wanted, clipped) and set(own) == set(here) <= {*free, "w_L"}
        given[clipped.tobytes()] = usual if is_own else with_logarithms(weights, dict(zip(free, clipped, strict=True)))
    return given


def _ends(bounds: dict[str, float], free: list[str]) -> np.ndarray:
    return np.array([bounds[name] for name in free])


def _listed(meshes: Any) -> list[Any]:
    """One mesh or many as a list; a pair of arrays is one mesh."""

    def is_mesh(item: Any) -> bool:
        is_pair = isinstance(item, tuple) and len(item) == 2
        return isinstance(item, str | os.PathLike) or hasattr(item, "faces") or is_pair

    if isinstance(meshes, list | tuple) and not len(meshes):
        raise ConfigError("meshes is empty: expected one mesh, or a list of meshes")
    if isinstance(meshes, list | tuple) and all(is_mesh(item) for item in meshes):
        return list(meshes)
    return [meshes]


def _checked_bounds(weights: Weights, bounds: Any) -> tuple[dict[str, float], dict[str, float]]:
    """Natural logarithms of the lowest and the highest value of every weight."""
    names = [member.name for member in fields(Weights)]
    pairs: dict[str, Any] = bounds if isinstance(bounds, dict) else dict.fromkeys(names, bounds)
    low, high = {}, {}
    for name in [*names, *pairs]:
        pair = pairs.get(name, WIDEST)
        if name not in names:
            raise ConfigError(f"bounds has {name!r}: expected one of {', '.join(names)}")
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
            raise ConfigError(f"Weights.{name} is {shown(weight)}: expected a start within its bounds {pair!r}")
        low[name], high[name] = np.log(first), np.log(last)
    return low, high
