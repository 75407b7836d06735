"""The flow, Algorithm 2: each component of a mesh is contracted until it is done, then its curve is extracted.

`starting` prepares a component. `stepping` runs one iteration; only there host and device meet. `done` decides whether
to stop, and says why. `curves` extracts and finishes the curves. `assembly` makes one result of all components.
"""

import os
from contextlib import suppress
from typing import Any

import numpy as np
from tqdm import tqdm

from msf_jax.base import forking
from msf_jax.base.clock import Clock, Stopped, counted
from msf_jax.base.errors import Interrupted
from msf_jax.base.options import Config, Weights
from msf_jax.flow import assembly
from msf_jax.flow.checkpoint import Checkpoint, run_of
from msf_jax.flow.curves import curve_of
from msf_jax.flow.request import checked_options, checked_pins, weights_of_vertices
from msf_jax.flow.starting import init
from msf_jax.flow.state import LIMITS, Flow, Iteration, Limits, State
from msf_jax.flow.stepping import step
from msf_jax.meshes import checking
from msf_jax.meshes.checking import Surface
from msf_jax.meshes.reading import MeshLike
from msf_jax.meshes.repair import Repair, as_repair
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
    checkpoint: str | os.PathLike[str] | None = None,
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
        checkpoint: a file to which the state is written every few iterations, atomically. If the file exists and is of
            the same run, the run continues from it, with the same result to the last bit. The file is not deleted.
        progress: show a progress bar on standard error, if that is a terminal.
        limits: bounds that only tests change.

    Raises:
        MeshError: the mesh is not a closed manifold that encloses a volume, and ``repair`` was not given or could not
            make it one.
        ConfigError: a weight or an option is out of range, a pin is no vertex of the surface, or the checkpoint is of
            another run or cannot be written.
        FlowError: the mesh has no Voronoi diagram, this process was forked after a run, the installed compiler
            computes wrong sums, or ``config.max_seconds`` had passed before the first iteration had ended.
        Interrupted: Ctrl-C; a KeyboardInterrupt with the unfinished flow. Before the first iteration has ended there is
            none, and a plain KeyboardInterrupt is raised.
    """
    weights, config = checked_options(weights, config)
    forking.check()
    with counted() as presses:
        clock = Clock(config.max_seconds, presses)
        with clock.holding(), tqdm(desc="msf_jax", unit="it", disable=None if progress else True) as bar:
            with clock.before_curve():
                with clock.stage("validation"):
                    checked = mesh if isinstance(mesh, Surface) else clock.call(checking.prepare, mesh, repair)
                solid = clock.call(Solid, checked.vertices, checked.faces)
            held, pinned = checked_pins(pins, checked)
            of_vertices = weights_of_vertices(weights, checked)
            identity = run_of(checked.given, weights, config, held, as_repair(repair)) if checkpoint is not None else {}
            keeper = Checkpoint(checkpoint, identity)
            prepared = clock.begin(solid.prepare)
            states, reasons, parts = [], [], []
            for number, component in enumerate(checked.components):
                pins_here = np.flatnonzero(np.isin(checked.members[number], pinned))
                of_members = None if of_vertices is None else of_vertices[checked.members[number]]
                state = None
                try:
                    state = init(component, number, config, clock, pins_here, of_members, limits)
                    keeper.restore(state, config)
                    while (end := done(state, config)) is None:
                        clock.check()
                        step(state, weights, config, clock, limits)
                        if state.history:
                            bar.set_postfix(vertices=state.history[-1].live, volume=f"{state.history[-1].volume:.1e}")
                            if len(state.history) % limits.checkpoint_every == 0:
                                keeper.save([*states, state])
                        bar.update()
                except Stopped:
                    end = False, clock.reason
                    if state is None or not state.history:  # then there is no curve of it yet
                        break
                states.append(state)
                keeper.save(states)
                parts.append(curve_of(state, config, clock))
                reasons.append((False, clock.reason) if parts[-1].finished.is_cut else end)
                if clock.reason:  # the time that is left is for the curve so far
                    break
            with clock.before_curve():
                if not parts:
                    raise Stopped
            notes = [keeper.failure] if keeper.failure else []
            if len(parts) < len(checked.components):
                reasons += [(False, "not begun")] * (len(checked.components) - len(parts))
                checked = checked.first(len(parts))
                held = held[checked.vertex_of_input[held] >= 0]
                solid = Solid(checked.vertices, checked.faces)
            else:
                with clock.stage("report"), suppress(Stopped):
                    clock.wait(prepared)
            run = assembly.assemble(checked, solid, held, states, reasons, parts, weights, config, clock, notes)
    if clock.was_pressed:
        kept = f"; run it again with checkpoint={str(checkpoint)!r} to go on" if checkpoint and not notes else ""
        raise Interrupted(
            f"interrupted after {len(run.history)} iterations: the curve so far is in this exception's flow{kept}", run
        )
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
