"""The flow, Algorithm 2: each component of a mesh is contracted until it is done, then its curve is extracted.

`starting` prepares a component. `stepping` runs one iteration; only there host and device meet. `done` decides whether
to stop, and says why. `curves` extracts and finishes the curves. `assembly` makes one result of all components.
"""

import reprlib
from collections.abc import Iterable
from typing import Any

import numpy as np
from tqdm import tqdm

from msf_jax.base.clock import Clock, Stopped, begin
from msf_jax.base.errors import ConfigError, FlowError, Interrupted
from msf_jax.base.options import Config, Weights, is_traced, traced
from msf_jax.flow import assembly
from msf_jax.flow.curves import curve_of
from msf_jax.flow.starting import init
from msf_jax.flow.state import LIMITS, Flow, Iteration, Limits, State
from msf_jax.flow.stepping import step
from msf_jax.meshes import checking
from msf_jax.meshes.checking import Surface
from msf_jax.meshes.reading import MeshLike
from msf_jax.meshes.repair import Repair
from msf_jax.meso import fixing
from msf_jax.solid.solid import Solid

SETTLED = 0.02  # share of the first volume: a flow that has settled may leave this much, of any shape
MEMBRANES = 0.1  # share of the first volume: it may leave this much in thin membranes between fixed vertices
THINNED = 1 / 3  # membranes are at most this part as thick as the solid was (ratio of volume share to area share)
PROGRESS = 0.1  # share of the area: a flow that loses less in a period of the threshold has settled
SHORTEST_PERIOD = 20  # iterations: shorter periods of the threshold count as this long
STALL_ITERATIONS = 30  # iterations without progress until the flow gives up; a default period is shorter


def contract(
    mesh: "MeshLike",
    weights: Weights | None = None,
    config: Config | None = None,
    *,
    pins: Any = None,
    repair: bool | str | Repair = False,
    progress: bool = False,
    limits: Limits = LIMITS,
) -> Flow:
    """Run the flow on ``mesh`` and return all of it. `skeletonize` returns the finished curve alone.

    Args:
        mesh: a path that trimesh reads, a `trimesh.Trimesh`, or ``(vertices, faces)``: closed triangle surfaces. Or a
            `Surface` that was checked before.
        weights: of the flow; those of ``config``'s system if not given. Each is a number, or an array (V,) with one for
            every vertex of the mesh. A merged vertex gets the mean of its vertices' weights; a vertex that splits an
            edge gets an interpolated weight.
        config: the system and its options; ``Config()``, the article's, if not given.
        pins: ids of vertices of the mesh that are held in place; the curve goes through them.
        repair: True, or a `Repair` with limits, to repair a mesh that is not a closed manifold; "join" also makes one
            solid of parts that overlap, touch or nearly touch. Every change is counted in ``skeleton.report.repairs``.
        progress: show a progress bar on standard error, if that is a terminal.
        limits: bounds that only tests change.

    Raises:
        MeshError: the mesh is not a closed manifold that encloses a volume, and ``repair`` was not given or could not
            make it one.
        ConfigError: a weight or an option is out of range, or a pin is no vertex of the surface.
        FlowError: the mesh has no Voronoi diagram, or ``config.max_seconds`` had passed before the first iteration had
            ended.
        Interrupted: Ctrl-C; a KeyboardInterrupt with the unfinished flow. Before the first iteration has ended there is
            none, and a plain KeyboardInterrupt is raised.
    """
    weights, config = checked_options(weights, config)
    clock = Clock(config.max_seconds)
    with clock.listening(), tqdm(desc="msf_jax", unit="it", disable=None if progress else True) as bar:
        with clock.stage("validation"):
            checked = mesh if isinstance(mesh, Surface) else checking.prepare(mesh, repair)
        solid = Solid(checked.vertices, checked.faces)
        held, pinned = checked_pins(pins, checked)
        of_vertices = weights_of_vertices(weights, checked)
        prepared = begin(solid.prepare)
        states, reasons, parts = [], [], []
        for number, component in enumerate(checked.components):
            pins_here = np.flatnonzero(np.isin(checked.members[number], pinned))
            of_members = None if of_vertices is None else of_vertices[checked.members[number]]
            state = None
            try:
                state = init(component, number, config, clock, pins_here, of_members, limits)
                while (end := done(state, config)) is None:
                    clock.check()
                    step(state, weights, config, clock, limits)
                    if state.history:
                        bar.set_postfix(vertices=state.history[-1].live, volume=f"{state.history[-1].volume:.1e}")
                    bar.update()
            except Stopped:
                end = False, clock.reason
                if state is None or not state.history:  # then there is no curve of it yet
                    break
            states.append(state)
            parts.append(curve_of(state, config, clock))
            reasons.append((False, clock.reason) if parts[-1].finished.is_cut else end)
            if clock.reason:  # the time that is left is for the curve so far
                break
        if not parts and clock.was_pressed:
            raise KeyboardInterrupt("interrupted before the first iteration has ended: there is no curve yet")
        if not parts:
            when = "before the first iteration has ended: there is no curve"
            raise FlowError(f"{clock.reason} {when}; expected more seconds")
        if len(parts) < len(checked.components):
            reasons += [(False, "not begun")] * (len(checked.components) - len(parts))
            checked = checked.first(len(parts))
            held = held[checked.vertex_of_input[held] >= 0]
            solid = Solid(checked.vertices, checked.faces)
        elif not clock.reason:
            with clock.stage("report"):
                prepared.result()
        run = assembly.assemble(checked, solid, held, states, reasons, parts, weights, config, clock)
    if clock.was_pressed:
        count = len(run.history)
        raise Interrupted(f"interrupted after {count} iterations: the curve so far is in this exception's flow", run)
    return run


def has_volume(state: State, config: Config) -> bool:
    """Whether there is more to contract: volume, or area, because a flat sheet has no volume.

    A contracted curve still has some area. It counts as contracted when three iterations remove less than a tenth.
    """
    last = state.history[-1]
    if abs(last.volume) > config.flow.volume_tolerance:
        return True
    is_settled = len(state.history) > 3 and last.area > 0.9 * state.history[-4].area
    return last.area > config.flow.area_tolerance and not is_settled


def is_settled(history: list[Iteration], config: Config) -> bool:
    """Whether little volume is left, and the area has hardly fallen over a whole period of the threshold.

    Membranes between fixed vertices do not contract further: their edges are split as fast as they collapse. A curve
    is extracted from membranes as from any thin surface.
    """
    period = max(fixing.num_periods(*config.flow.thresholds), SHORTEST_PERIOD)
    volume = abs(history[-1].volume)
    is_thin = volume <= MEMBRANES and volume <= THINNED * history[-1].area
    if len(history) <= period or not (is_thin or volume <= SETTLED):
        return False
    return history[-1].area > (1 - PROGRESS) * history[-1 - period].area


def done(state: State, config: Config) -> tuple[bool, str] | None:
    """None while the surface has volume and the flow can continue; else whether it converged, and why it stops."""
    if state.failure:
        return False, state.failure
    if not state.history:
        return None
    last = state.history[-1]
    if config.flow.volume_tolerance == 0:  # nothing but the number of iterations ends the run
        is_last = len(state.history) >= config.max_iterations
        return (abs(last.volume) <= SETTLED, f"all of {config.max_iterations} iterations made") if is_last else None
    if not has_volume(state, config):
        return True, "no volume left"
    if last.live - last.fixed <= config.flow.free_tolerance * last.live:
        return True, "all vertices fixed"
    if is_settled(state.history, config):
        return True, f"settled: {abs(last.volume):.1%} of the volume is left, between fixed vertices"
    if len(state.history) >= config.max_iterations:
        return False, f"max_iterations ({config.max_iterations}) reached"
    if len(state.history) > STALL_ITERATIONS:
        before = state.history[-1 - STALL_ITERATIONS]
        recent = state.history[-STALL_ITERATIONS:]
        best = min(abs(line.volume) for line in recent)
        if best > 0.99 * abs(before.volume) and last.live - last.fixed >= before.live - before.fixed:
            return False, f"stalled: no progress in {STALL_ITERATIONS} iterations"
    return None


def checked_options(weights: Any, config: Any) -> tuple[Weights, Config]:
    """The weights and the config, with defaults for None; a `ConfigError` if a type is wrong or a weight traced."""
    if not isinstance(config, Config | None):
        raise ConfigError(f"config is a {type(config).__name__}: expected a msf_jax.Config")
    if not isinstance(weights, Weights | None):
        shape = getattr(weights, "shape", None)
        if isinstance(shape, tuple) and shape[1:] == (3,):
            raise ConfigError(
                f"weights has shape {tuple(shape)}, as faces have: pass the mesh as one argument, (vertices, faces)"
            )
        raise ConfigError(f"weights is a {type(weights).__name__}: expected a msf_jax.Weights (config comes after it)")
    if weights is not None and any(map(is_traced, vars(weights).values())):
        raise ConfigError(traced("weights", "msf_jax.replay") + ", with the tape of msf_jax.contract")
    config = Config() if config is None else config
    return (config.default_weights() if weights is None else weights), config


def weights_of_vertices(weights: Weights, checked: Surface) -> np.ndarray | None:
    """(V, 4) weights of the checked surface's vertices, or None if all weights are scalars."""
    num = len(checked.vertex_of_input)
    columns = []
    for name, value in vars(weights).items():
        if np.shape(value) not in ((), (num,)):
            raise ConfigError(
                f"Weights.{name} has shape {np.shape(value)}: expected a number, or ({num},): one for each vertex"
            )
        columns.append(np.broadcast_to(np.asarray(value, dtype=np.float64), num)[checked.input_of_vertex])
    return None if all(np.ndim(value) == 0 for value in vars(weights).values()) else np.stack(columns, axis=1)


def checked_pins(pins: Any, checked: Surface) -> tuple[np.ndarray, np.ndarray]:
    """The caller's ``pins`` as an array of ids, and the ids of these vertices in the checked surface."""
    num = len(checked.vertex_of_input)
    if pins is None:
        listed: Any = []
    elif isinstance(pins, np.ndarray) or not isinstance(pins, Iterable):
        listed = np.atleast_1d(pins)
    else:
        listed = list(pins)
    try:
        given: np.ndarray = np.array(listed)
    except ValueError:  # lists of different lengths
        given = np.empty((0, 0))
    if given.size == 0 and given.ndim == 1:
        return np.empty(0, dtype=np.int64), np.empty(0, dtype=np.int64)
    if given.ndim != 1 or given.dtype.kind not in "iu" or given.min() < 0 or given.max() >= num:
        raise ConfigError(f"pins is {reprlib.repr(pins)}: expected vertex numbers from 0 to {num - 1}")
    rows = checked.vertex_of_input[given]
    if (rows < 0).any():
        raise ConfigError(f"pins has vertex {given[rows < 0][0]}, which no face uses: expected vertices of the surface")
    is_lining = np.isin(rows, np.concatenate(checked.linings))
    if is_lining.any():
        raise ConfigError(f"pins has vertex {given[is_lining][0]} of a cavity: expected vertices of the outer surface")
    return np.unique(given).astype(np.int64), np.unique(rows)
