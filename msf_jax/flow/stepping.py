"""One iteration of the flow (the loop of Algorithm 2): contract and smooth on the device, then edit on the host."""

from contextlib import nullcontext
from dataclasses import replace
from typing import Any, NamedTuple

import jax
import numpy as np

from msf_jax.base.clock import Clock
from msf_jax.base.layout import Layout, layout_after, layout_for
from msf_jax.base.options import FACTORED, Config, Weights
from msf_jax.device.buffers import Buffers, Rings, real_dtype
from msf_jax.flow.programs import compile_moves, compiled_move
from msf_jax.flow.state import LIMITS, Iteration, Limits, State
from msf_jax.meso import collapse, fixing, packing, split
from msf_jax.meso.meso import Meso
from msf_jax.recording.records import Step
from msf_jax.solid.geometry import signed_volume, triangle_areas

LARGEST_FACTOR = 2.0**100  # the largest factor on w_L, without unit: its square is finite in float64
BLOW_UP = 1.0  # diagonals: a larger coordinate means that a step diverged; corners of the box have at most half
SHORTER = 0.1  # factor on w_L for each repetition of a step that diverged


def compile_ahead(meso: Meso, config: Config) -> None:
    """Compile the program for the size of ``meso``, and begin that of the smallest layout, which all runs reach."""
    beyond = packing.rows_beyond(meso)
    layouts = {layout_for(meso.num_rows, beyond)}
    if config.flow.edit_connectivity and config.max_iterations > 1:
        layouts.add(layout_for(1, []))
    compile_moves(config.on_device, sorted(layouts, reverse=True), meso.weights is not None)


def step(state: State, weights: Weights, config: Config, clock: Clock, limits: Limits = LIMITS) -> State:
    """Run one iteration in place. If coordinates are not finite or diverge, set ``state.failure`` instead."""
    is_double = config.solver.preconditioner == FACTORED
    with jax.enable_x64(True) if is_double else nullcontext():
        packed = _pack(state, weights, clock)
        moved = _moved(state, packed, config, clock, limits)
    state.capacity = packed.layout.capacity
    if moved is None:
        state.failure = (
            f"non-finite: a step gave coordinates that are not finite or diverge, also when it was repeated "
            f"{limits.retries} times, each time with a tenth of the w_L; the surface before it was kept"
        )
        return state
    meso, order = state.meso, packed.order
    before = meso.positions[order].astype(np.float32)
    displacement = float(np.sqrt(((moved.positions - meso.positions) ** 2).sum(axis=1).max()))
    meso.positions = moved.positions
    num_collapses, num_splits = _edited(state, config, clock) if config.flow.edit_connectivity else (0, 0)
    meso = state.meso

    solves, num, faces = moved.solves, len(order), meso.faces()
    left = solves.left[:, :num].copy()
    free, pull = (np.array(values[:num]) for values in (packed.buffers.free, packed.buffers.pull))
    state.steps.append(Step(order, before, packed.rings, packed.degree, free, pull, left, moved.factor, meso.edits))
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
            redone=moved.retries,
            has_ended=bool(solves.has_ended.all()),
        )
    )
    state.t_c = fixing.threshold(len(state.history), *config.flow.thresholds)
    state.w_L_factor = min(state.w_L_factor * config.flow.w_L_growth, LARGEST_FACTOR)
    return state


class _Packed(NamedTuple):
    """The padded surface for a device step, still on the host; ``weights`` are those of its rows. See `packing`."""

    order: np.ndarray
    rings: np.ndarray
    degree: np.ndarray
    layout: Layout
    buffers: Buffers
    weights: Weights


class _Moved(NamedTuple):
    """The new positions (n, 3), the solves' reports, the factor on w_L, and how often the step was repeated."""

    positions: np.ndarray
    solves: Any
    factor: float
    retries: int


def _pack(state: State, weights: Weights, clock: Clock) -> _Packed:
    meso = state.meso
    with clock.stage("solve"):
        layout = layout_after(state.capacity, meso.num_rows, packing.rows_beyond(meso))
        order, rings, fields = packing.pack(
            meso, layout, state.first_ring_area, np.dtype(real_dtype()), _smallest(state)
        )
        buffers = Buffers(**{**fields, "rings": Rings(*fields["rings"])})
        of_rows = _of_rows(weights, meso.weights, order, layout.capacity)
        return _Packed(order, rings, meso.degree[order], layout, buffers, of_rows)


def _smallest(state: State) -> float:
    """The least t_c of any limb, in diagonals: of the tolerance of the solves, and the unit of their errors."""
    scale = state.meso.scale
    return state.t_c if scale is None else state.t_c * float(scale[state.meso.degree > 0].min())


def _moved(state: State, packed: _Packed, config: Config, clock: Clock, limits: Limits) -> _Moved | None:
    """The device's step, repeated with a tenth of w_L while coordinates diverge; None if they always do."""
    dtype = np.dtype(real_dtype())
    for retries in range(limits.retries + 1):
        factor = state.w_L_factor * SHORTER**retries
        scaled = replace(packed.weights, w_L=packed.weights.w_L * factor)
        scaled = jax.tree_util.tree_map(lambda weight: np.asarray(weight, dtype), scaled)
        buffers, scaled = jax.device_put((packed.buffers, scaled))
        with clock.stage("compile"):
            move = compiled_move(config.on_device, packed.layout, np.ndim(scaled.w_L) > 0)
        with clock.stage("solve"):
            moved = jax.device_get(move(buffers, scaled))
        positions = packing.unpack(moved.positions, packed.order)
        is_finite = np.isfinite(moved.solves.residual).all()
        if is_finite and np.isfinite(positions).all() and np.abs(positions).max() <= BLOW_UP:
            return _Moved(positions, moved.solves, factor, retries)
    return None


def _edited(state: State, config: Config, clock: Clock) -> tuple[int, int]:
    """Collapse, split and fix. Returns how many edges were collapsed, and how many were split."""
    meso = state.meso
    with clock.stage("collapse"):
        rounds = collapse.collapse_short_edges(meso, state.t_c, check=config.check)
    with clock.stage("split"):
        t_f = fixing.degenerate_length(state.t_c)
        cuts, is_full = split.split_obtuse_edges(meso, config.flow.split_angle, t_f, state.max_rows, check=config.check)
    if is_full:
        state.failure = f"out of vertices: the next split would give the surface more than {state.max_rows} vertices"
    with clock.stage("fix"):
        fixing.fix_degenerate_vertices(meso, t_f)
        state.meso = meso.compacted()
    return sum(len(done.removed) for done in rounds), sum(len(done.new) for done in cuts)


def _of_rows(weights: Weights, of_vertices: np.ndarray | None, order: np.ndarray, capacity: int) -> Weights:
    """The weights for a packed surface: scalars as they are, or one value a row."""
    if of_vertices is None:
        return weights
    return Weights(*packing.pad(of_vertices[order], capacity, 1.0, np.dtype(np.float64)).T)
