"""The flow, Algorithm 2: every component of a mesh is started, and stepped until it is done; then curves.

`starting` prepares a component, `stepping` runs one iteration (the only place where host and device meet), `done` says
whether and why to stop, `curves` reads the curves off, and `assembly` puts the run together.
"""

import os
from typing import Any

import numpy as np
from tqdm import tqdm

from msf_jax.base import forking
from msf_jax.base.errors import Interrupted
from msf_jax.base.interruption import held_back
from msf_jax.base.options import Config, Weights
from msf_jax.flow import assembly
from msf_jax.flow.checkpoint import Checkpoint, run_of
from msf_jax.flow.curves import curve_of
from msf_jax.flow.request import checked_options, checked_pins, weights_of_vertices
from msf_jax.flow.starting import init
from msf_jax.flow.state import LIMITS, Flow, Iteration, Limits, State, Stopwatch
from msf_jax.flow.stepping import step
from msf_jax.host.mesh import checking
from msf_jax.host.mesh.checking import Surface
from msf_jax.host.mesh.repair import Repair, as_repair
from msf_jax.host.meso import collapse, fixing
from msf_jax.host.meso.meso import Meso

INTERRUPTED = "interrupted"
SETTLED = 0.02  # of the volume may be left, however it is; or, in membranes,
MEMBRANES, THINNED = 0.1, 0.25  # that much, if what is left is that part as thick as the solid was
PROGRESS = 0.1  # of the area, that a tooth must take away, or the flow has settled;
FEWEST = 20  # iterations, that a tooth counts for at least
STALL_ITERATIONS = 30  # without progress, after which the flow gives up: longer than a tooth of the default threshold


def contract(
    mesh: Any,
    weights: Weights | None = None,
    config: Config | None = None,
    *,
    pins: Any = None,
    repair: bool | str | Repair = False,
    checkpoint: str | os.PathLike[str] | None = None,
    progress: bool = False,
    limits: Limits = LIMITS,
) -> Flow:
    """Run the flow on ``mesh`` and keep everything; `skeletonize` is the short way to the curve alone.

    Args:
        mesh: a path that trimesh reads, a `trimesh.Trimesh`, or ``(vertices, faces)``: closed triangle surfaces. Or the
            `Surface` that has been made of one.
        weights: of the flow; those of ``config``'s system if not given. Each is a number, or an array (V,) with one for
            every vertex of the mesh: merged vertices take the mean of theirs, one that splits an edge interpolates.
        config: the system and its options; ``Config()``, the article's own, if not given.
        pins: numbers of vertices of the mesh that are held in place; the curve goes through them.
        repair: True, or a `Repair` that says how far it may go, for a mesh that is not a closed manifold; "join" also
            makes one solid of parts that overlap, touch or nearly touch. Every change is counted in
            ``skeleton.report.repairs``.
        checkpoint: a file that the state is written to every few iterations, whole or not at all. If it is there, and
            of this very run, that goes on from it, to the same bits. It stays when the run has ended.
        progress: show a progress bar on standard error, if that is a terminal.
        limits: bounds that only tests change.

    Raises:
        MeshError: the mesh is not a closed manifold that encloses a volume, and cannot be repaired without a doubt.
        ConfigError: a weight or an option is out of range, a pin is no vertex of the surface, or the checkpoint is of
            another run or cannot be written.
        FlowError: the mesh has no Voronoi diagram, or this process was forked from one in which a run was made.
        Interrupted: Ctrl-C, once the iteration has ended; it is a KeyboardInterrupt, and holds the flow as it was.
    """
    weights, config = checked_options(weights, config)
    forking.check()
    watch = Stopwatch()
    with watch.stage("validation"):
        checked = mesh if isinstance(mesh, Surface) else checking.prepare(mesh, repair)
    held, pinned = checked_pins(pins, checked)
    of_vertices = weights_of_vertices(weights, checked)
    identity = run_of(checked.given, weights, config, held, as_repair(repair)) if checkpoint is not None else {}
    keeper = Checkpoint(checkpoint, identity)
    states, reasons, parts = [], [], []
    with tqdm(desc="msf_jax", unit="it", disable=None if progress else True) as bar, held_back() as interruption:
        for number, component in enumerate(checked.components):
            if interruption and parts:
                break
            pins_here = np.flatnonzero(np.isin(checked.members[number], pinned))
            of_members = None if of_vertices is None else of_vertices[checked.members[number]]
            state = init(component, number, config, watch, pins_here, of_members, limits)
            keeper.restore(state, config)
            states.append(state)
            while (end := done(state, config)) is None:
                if interruption:
                    end = False, INTERRUPTED
                    break
                step(state, weights, config, watch, limits)
                if state.history:
                    bar.set_postfix(vertices=state.history[-1].live, volume=f"{state.history[-1].volume:.1e}")
                    if len(state.history) % limits.checkpoint_every == 0:
                        keeper.save(states)
                bar.update()
            keeper.save(states)
            reasons.append(end)
            parts.append(curve_of(state, _thinned(state.meso, config), config, watch))
        notes = [keeper.failure] if keeper.failure else []
        if len(parts) < len(checked.components):
            reasons += [(False, "not begun")] * (len(checked.components) - len(parts))
            checked = checked.first(len(parts))
            held = held[checked.vertex_of_input[held] >= 0]
        run = assembly.assemble(checked, held, states, reasons, parts, weights, config, watch, notes)
    if interruption:
        kept = f"; run it again with checkpoint={str(checkpoint)!r} to go on" if checkpoint and not notes else ""
        raise Interrupted(
            f"interrupted after {len(run.history)} iterations: the curve so far is in this exception's flow{kept}", run
        )
    return run


def _thinned(meso: Meso, config: Config) -> Meso:
    """The surface to read the curve off: one that was never edited first loses its short edges."""
    if config.edit_connectivity:
        return meso
    meso = meso.copied()
    collapse.collapse_short_edges(meso, config.t_min, check=config.check)
    return meso.compacted()


def has_volume(state: State, config: Config) -> bool:
    """Whether there is more to contract: volume, or, as a flat sheet has none, area that is not yet down to a curve's.

    A thin curve still has some area; it is as small as it gets when three iterations take less than a tenth of it away.
    """
    last = state.history[-1]
    if abs(last.volume) > config.volume_tolerance:
        return True
    is_settled = len(state.history) > 3 and last.area > 0.9 * state.history[-4].area
    return last.area > config.area_tolerance and not is_settled


def is_settled(history: list[Iteration], config: Config) -> bool:
    """Whether next to nothing is left, and has not become less in a whole tooth of the threshold.

    Membranes between fixed vertices have nowhere to go: their edges are split as fast as they collapse. The curve is
    read off them as it is of anything thin.
    """
    period = max(fixing.num_periods(config.t_min, config.t_step, config.t_max), FEWEST)
    volume = abs(history[-1].volume)
    is_thin = volume <= MEMBRANES and volume <= THINNED * history[-1].area
    if len(history) <= period or not (is_thin or volume <= SETTLED):
        return False
    return history[-1].area > (1 - PROGRESS) * history[-1 - period].area


def done(state: State, config: Config) -> tuple[bool, str] | None:
    """None while the surface has volume and the flow can go on; else whether it converged, and why it stops."""
    if state.failure:
        return False, state.failure
    if not state.history:
        return None
    last = state.history[-1]
    if not has_volume(state, config):
        return True, "no volume left"
    if last.live - last.fixed <= config.free_tolerance * last.live:
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
