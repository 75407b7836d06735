"""One iteration of the flow (the loop of Algorithm 2): contract and smooth on the device, then edit on the host.

`ending` decides whether it was the last one, and says why.
"""

from contextlib import nullcontext
from dataclasses import replace
from typing import Any

import jax
import numpy as np

from msf_jax.base.clock import Clock
from msf_jax.base.layout import Layout, layout_for
from msf_jax.base.options import FACTORED, Config, Weights
from msf_jax.device.buffers import Buffers, Rings, real_dtype
from msf_jax.flow.programs import compiled_move
from msf_jax.flow.state import Iteration, State
from msf_jax.meso import edits, packing
from msf_jax.recording.records import Step
from msf_jax.solid.geometry import signed_volume, triangle_areas

LARGEST_FACTOR = 2.0**100  # the largest factor on w_L, without unit: its square is finite in float64
BLOW_UP = 1.0  # diagonals: a larger coordinate means that a step diverged; corners of the box have at most half
SHORTER = 0.1  # factor on w_L for each repetition of a step that diverged
RETRIES = 3  # of a step whose coordinates are not finite or diverge
SETTLED = 0.02  # share of the first volume: a flow that has settled may leave this much, of any shape
MEMBRANES = 0.1  # share of the first volume: it may leave this much in thin membranes between fixed vertices
THINNED = 1 / 3  # membranes are at most this part as thick as the solid was (ratio of volume share to area share)
PROGRESS = 0.1  # share of the area: a flow that loses less in a period of the threshold has settled
SHORTEST_PERIOD = 20  # iterations: shorter periods of the threshold count as this long
STALL_ITERATIONS = 30  # iterations without progress until the flow gives up; a default period is shorter


def step(state: State, weights: Weights, config: Config, clock: Clock) -> None:
    """Run one iteration in place. If coordinates are not finite or diverge, set ``state.failure`` instead."""
    meso, is_double = state.meso, config.solver.preconditioner == FACTORED
    with jax.enable_x64(True) if is_double else nullcontext():
        with clock.stage("solve"):
            layout, order, rings, buffers, weights = packed(state, weights)
        moved = _moved(state, buffers, weights, layout, order, config, clock)
    if moved is None:
        state.failure = (
            f"non-finite: a step gave coordinates that are not finite or diverge, also when it was repeated "
            f"{RETRIES} times, each time with a tenth of the w_L; the surface before it was kept"
        )
        return
    solves, positions, factor, retries = moved
    before, degree = meso.positions[order].astype(np.float32), meso.degree[order]
    displacement = float(np.sqrt(((positions - meso.positions) ** 2).sum(axis=1).max()))
    meso.positions = positions
    num_collapses, num_splits = _edited(state, config, clock) if config.flow.edit_connectivity else (0, 0)
    meso = state.meso

    num, faces = len(order), meso.faces()
    free, pull, left = (np.array(values) for values in (buffers.free[:num], buffers.pull[:num], solves.left[:, :num]))
    state.steps.append(Step(order, before, rings, degree, free, pull, left, factor, meso.edits))
    meso.edits = []
    state.history.append(
        Iteration(
            component=state.number,
            iteration=len(state.history) + 1,
            t_c=state.t_c,
            live=meso.num_live,
            fixed=int(meso.is_fixed.sum()),
            collapses=num_collapses,
            splits=num_splits,
            volume=signed_volume(meso.positions, faces) / state.first_volume,
            area=float(triangle_areas(meso.positions[faces]).sum()) / state.first_area,
            steps=int(solves.steps[0]),
            residual=float(solves.residual[0]),
            smoothing_steps=int(solves.steps[1]),
            smoothing_residual=float(solves.residual[1]),
            moved=displacement,
            redone=retries,
            has_ended=bool(solves.has_ended.all()),
        )
    )
    state.t_c = edits.threshold(len(state.history), *config.flow.thresholds)
    state.w_L_factor = min(state.w_L_factor * config.flow.w_L_growth, LARGEST_FACTOR)


def packed(state: State, weights: Weights) -> tuple[Layout, np.ndarray, np.ndarray, Buffers, Weights]:
    """The padded surface for a device step, still on the host: its layout, what `packing.pack` returns, and the
    weights, one value a row if they are by vertex."""
    meso = state.meso
    layout = layout_for(meso.num_rows, packing.rows_beyond(meso.degree))
    # Solves end when vertices move by a small part of the least t_c of any limb.
    least = state.t_c if meso.scale is None else state.t_c * float(meso.scale[meso.degree > 0].min())
    order, rings, fields = packing.pack(meso, layout, state.first_ring_area, np.dtype(real_dtype()), least)
    if meso.weights is not None:
        weights = Weights(*packing.pad(meso.weights[order], layout.capacity, 1.0, np.dtype(np.float64)).T)
    return layout, order, rings, Buffers(**{**fields, "rings": Rings(*fields["rings"])}), weights


def _moved(
    state: State, buffers: Buffers, weights: Weights, layout: Layout, order: np.ndarray, config: Config, clock: Clock
) -> tuple[Any, np.ndarray, float, int] | None:
    """The device's step, repeated with a tenth of w_L while coordinates diverge: the solves' reports, the new positions
    (n, 3), the factor on w_L, and how often the step was repeated; None if coordinates always diverge."""
    dtype = np.dtype(real_dtype())
    for retries in range(RETRIES + 1):
        factor = state.w_L_factor * SHORTER**retries
        scaled = replace(weights, w_L=weights.w_L * factor)
        scaled = jax.tree_util.tree_map(lambda weight: np.asarray(weight, dtype), scaled)
        on_device, scaled = jax.device_put((buffers, scaled))
        with clock.stage("compile"):
            move = compiled_move(config.on_device, layout, np.ndim(scaled.w_L) > 0)
        with clock.stage("solve"):
            moved = jax.device_get(move(on_device, scaled))
        positions = packing.unpack(moved.positions, order)
        is_finite = np.isfinite(moved.solves.residual).all()
        if is_finite and np.isfinite(positions).all() and np.abs(positions).max() <= BLOW_UP:
            return moved.solves, positions, factor, retries
    return None


def _edited(state: State, config: Config, clock: Clock) -> tuple[int, int]:
    """Collapse, split and fix. Returns how many edges were collapsed, and how many were split."""
    meso, t_f = state.meso, state.t_c / 10  # an edge shorter than t_f counts as a point
    with clock.stage("collapse"):
        rounds = edits.collapse_short_edges(meso, state.t_c)
    with clock.stage("split"):
        cuts, is_full = edits.split_obtuse_edges(meso, config.flow.split_angle, t_f, state.max_rows)
    if is_full:
        state.failure = f"out of vertices: the next split would give the surface more than {state.max_rows} vertices"
    with clock.stage("fix"):
        edits.fix_degenerate_vertices(meso, t_f)
        state.meso = meso.compacted()
    return sum(len(done.removed) for done in rounds), sum(len(done.new) for done in cuts)


def is_settled(history: list[Iteration], config: Config) -> bool:
    """Whether little volume is left, and the area has hardly fallen over a whole period of the threshold, as membranes
    between fixed vertices do not contract further: their edges are split as fast as they collapse."""
    period = max(edits.num_periods(*config.flow.thresholds), SHORTEST_PERIOD)
    volume = abs(history[-1].volume)
    is_thin = volume <= MEMBRANES and volume <= THINNED * history[-1].area
    if len(history) <= period or not (is_thin or volume <= SETTLED):
        return False
    return history[-1].area > (1 - PROGRESS) * history[-1 - period].area


def ending(state: State, config: Config) -> tuple[bool, str] | None:
    """None while the surface has volume and the flow can continue; else whether it converged, and why it stops."""
    if state.failure:
        return False, state.failure
    if not state.history:
        return None
    last = state.history[-1]
    if config.flow.volume_tolerance == 0:  # nothing but the number of iterations ends the run
        is_last = len(state.history) >= config.max_iterations
        return (abs(last.volume) <= SETTLED, f"all of {config.max_iterations} iterations made") if is_last else None
    # A flat sheet has no volume: its area counts, too, until three iterations remove less than a tenth of it.
    is_still = len(state.history) > 3 and last.area > 0.9 * state.history[-4].area
    if abs(last.volume) <= config.flow.volume_tolerance and (last.area <= config.flow.area_tolerance or is_still):
        return True, "no volume left"
    if last.live - last.fixed <= config.flow.free_tolerance * last.live:
        return True, "all vertices fixed"
    if is_settled(state.history, config):
        return True, f"settled: {abs(last.volume):.1%} of the volume is left, between fixed vertices"
    if len(state.history) >= config.max_iterations:
        return False, f"max_iterations ({config.max_iterations}) reached"
    if len(state.history) > STALL_ITERATIONS:
        before, *recent = state.history[-1 - STALL_ITERATIONS :]
        best = min(abs(line.volume) for line in recent)
        if best > 0.99 * abs(before.volume) and last.live - last.fixed >= before.live - before.fixed:
            return False, f"stalled: no progress in {STALL_ITERATIONS} iterations"
    return None
