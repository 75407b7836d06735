"""The flow, Algorithm 2: the only place where host and device meet.

`init` prepares a component, `step` runs one iteration (update L, contract and smooth on the device; collapse, split,
fix and raise the threshold on the host), `done` says whether and why to stop, and `contract` runs them all and reads
the curve off what is left.
"""

import os
import reprlib
from collections.abc import Iterable
from dataclasses import replace
from typing import Any

import jax
import numpy as np
from tqdm import tqdm

from msf_jax.base.errors import ConfigError, Interrupted, MeshError
from msf_jax.base.interruption import held_back
from msf_jax.base.layout import layout_for
from msf_jax.base.options import Config, Weights
from msf_jax.device.buffers import Buffers, Rings, real_dtype
from msf_jax.device.iteration import compiled_move
from msf_jax.flow import assembly
from msf_jax.flow.checkpoint import EVERY, Checkpoint, run_of
from msf_jax.flow.state import Flow, Iteration, State, Stopwatch
from msf_jax.host import reconstruction
from msf_jax.host.mesh import checking
from msf_jax.host.mesh.checking import Component
from msf_jax.host.mesh.repair import Repair, as_repair
from msf_jax.host.meso import collapse, fixing, homology, packing, split
from msf_jax.host.meso.meso import Meso
from msf_jax.host.poles import voronoi
from msf_jax.host.reconstruction import LowPass
from msf_jax.host.recording.records import FoundPoles, Start, Step
from msf_jax.host.solid.enclosure import Enclosure
from msf_jax.host.solid.frame import RESOLUTION, frame_of, sort_mesh

STALL_ITERATIONS = 30  # without progress, after which the flow gives up: longer than a tooth of the default threshold
LARGEST_FACTOR = 2.0**20  # where a growing w_L stops: past it the other weights no longer count
FLATTEST = 1e-9  # volume, in diagonals cubed, that must be left when coordinates are rounded to the frame's resolution
MOST_COARSENED = 0.05  # of the volume may go with short edges
GROWTH_LIMIT, GROWTH_ROOM = 3, 1000  # splitting may take the surface to so many times its first vertices, and so many
BLOW_UP = 1.0  # diagonals from the centre, twice as far as any corner of the box: nothing that contracts goes there
SHORTER, MOST_RETRIES = 0.1, 3  # factor on w_L, when a step has left sensible numbers, and how often it is tried
INTERRUPTED = "interrupted"


def init(
    component: Component,
    number: int,
    config: Config,
    watch: Stopwatch,
    pins: np.ndarray | None = None,
    weights: np.ndarray | None = None,
) -> State:
    """The component at the start of its flow: in its own frame, resampled if asked, with its poles.

    ``pins`` are vertices of the component that are fixed from the start, ``weights`` (V, 4) those of its vertices where
    they differ.
    """
    frame = frame_of(component.vertices)
    entered = frame.enter(component.vertices)
    order, faces = sort_mesh(entered, component.faces)
    original = vertices = entered[order]
    shape = Enclosure(vertices, faces)
    pins = np.flatnonzero(np.isin(order, [] if pins is None else pins))
    mesh_filter = None
    if config.reconstruct_mesh:
        with watch.stage("reconstruction"):
            vertices, mesh_filter = _rebuilt(vertices, faces, config.reconstruct_mesh, config)
            vertices[pins] = original[pins]
    meso = Meso.from_mesh(vertices, faces)
    meso.is_fixed[pins] = True
    meso.weights = None if weights is None else weights[order]
    if abs(meso.volume()) < FLATTEST:
        raise MeshError(
            f"component {number} is too thin: no volume is left of it at the flow's resolution, "
            f"{RESOLUTION:.0e} of its diagonal; expected a solid"
        )
    if 0 < component.genus <= homology.LARGEST_GENUS:
        with watch.stage("homology"):
            meso.classes = homology.ring_classes(original, faces, meso.rings)
    max_rows = GROWTH_LIMIT * meso.num_rows + GROWTH_ROOM
    if config.resample:
        with watch.stage("resampling"):
            meso = _resampled(meso, config.resample, check=config.check)
            max_rows = max(max_rows, GROWTH_LIMIT * meso.num_rows)
    num_coarsened, rough = 0, shape
    if config.coarsen:
        with watch.stage("coarsening"):
            coarse = _copy(meso)
            collapse.collapse_short_edges(coarse, config.coarsen, keep_faces=True, check=config.check)
            if abs(coarse.volume() - meso.volume()) <= MOST_COARSENED * abs(meso.volume()):
                num_coarsened = coarse.num_rows - coarse.num_live
                meso = coarse.compacted()
        if num_coarsened > meso.num_rows and not (config.reconstruct_mesh or config.resample):
            rough = Enclosure(meso.positions, meso.faces())
    found = None
    if config.use_poles:
        found = _poles(meso, shape, config, watch)
        meso.poles, meso.has_pole = np.where(found.is_inside[:, None], found.poles, meso.positions), found.is_inside
        meso.trust = found.trust if config.pole_confidence else None
    start = Start(mesh_filter, meso.edits, found)
    meso.edits = []
    return State(
        component=component,
        number=number,
        frame=frame,
        order=order,
        shape=shape,
        rough=rough,
        pins=pins,
        first_volume=meso.volume(),
        max_rows=max_rows,
        num_coarsened=num_coarsened,
        first_area=meso.area(),
        first_ring_area=_one_ring_areas(meso) if config.w_H_follows_area else np.empty(0),
        poles=meso.poles[meso.node_of_input],
        has_pole=meso.has_pole[meso.node_of_input],
        start=start,
        meso=meso,
        t_c=config.t_min,
        w_L_factor=1.0,
    )


def _rebuilt(vertices: np.ndarray, faces: np.ndarray, k: int, config: Config) -> tuple[np.ndarray, LowPass | None]:
    kept = reconstruction.low_pass(faces, len(vertices), k, exact=config.exact_reconstruction)
    return reconstruction.apply(kept, vertices, faces), kept


def _resampled(meso: Meso, length: float, *, check: bool) -> Meso:
    """Edges between 4/5 and 4/3 of ``length``, as far as the topology lets them."""
    for _ in range(3):
        split.split_long_edges(meso, 4 / 3 * length, check=check)
        collapse.collapse_short_edges(meso, 4 / 5 * length, check=check)
        meso = meso.compacted()
    return meso


def _poles(meso: Meso, shape: Enclosure, config: Config, watch: Stopwatch) -> FoundPoles:
    """Poles of the (reconstructed) surface, which of them pull (none outside the input's surface), and their trust.

    A pole is trusted by (1 - cos(spoke angle)) / 2.
    """
    sites, faces, kept = meso.positions, meso.faces(), None
    if config.reconstruct_poles:
        with watch.stage("reconstruction"):
            sites, kept = _rebuilt(sites, faces, config.reconstruct_poles, config)
    with watch.stage("poles"):
        found = voronoi.voronoi_poles(sites, faces, box=shape.vertices)
        has_pole = found.is_found.copy()
        has_pole[has_pole] = shape.contains(found.position[has_pole])
        trust = (1 - np.cos(voronoi.spoke_angles(found, sites))) / 2
        return FoundPoles(kept, sites, found.position, found.tetrahedron, has_pole, trust)


def _one_ring_areas(meso: Meso) -> np.ndarray:
    a, b, c = (meso.positions[corner] for corner in meso.faces().T)
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
    return np.bincount(meso.faces().T.ravel(), weights=np.tile(area, 3), minlength=meso.num_rows)


def step(state: State, weights: Weights, config: Config, watch: Stopwatch) -> State:
    """One iteration, in place; on numbers that are not finite or run away, ``state.failure`` says so instead."""
    meso = state.meso
    dtype = np.dtype(real_dtype())
    with watch.stage("solve"):
        layout = layout_for(meso.num_rows, packing.rows_beyond(meso))
        order, rings, packed = packing.pack(meso, layout, state.first_ring_area, dtype, state.t_c)
        packed["rings"] = Rings(*packed["rings"])
        degree = meso.degree[order]
        of_rows = _of_rows(weights, meso.weights, order, layout.capacity)
        on_host = Buffers(**packed)
    for retries in range(MOST_RETRIES + 1):
        factor = state.w_L_factor * SHORTER**retries
        scaled = replace(of_rows, w_L=of_rows.w_L * factor)
        scaled = jax.tree_util.tree_map(lambda weight: np.asarray(weight, dtype), scaled)
        buffers, scaled = jax.device_put((on_host, scaled))
        with watch.stage("compile"):
            move = compiled_move(buffers, scaled, config.on_device, layout)
        with watch.stage("solve"):
            moved = jax.device_get(move(buffers, scaled))
        positions = packing.unpack(moved.positions, order)
        is_finite = np.isfinite(moved.contraction.residual) and np.isfinite(moved.smoothing.residual)
        if is_finite and np.isfinite(positions).all() and np.abs(positions).max() <= BLOW_UP:
            break
    else:
        state.failure = (
            f"non-finite: {MOST_RETRIES + 1} tries of a step, each with a tenth of the w_L of the one before, left "
            "finite or sensible coordinates; the surface before it was kept"
        )
        return state
    before = meso.positions[order].astype(np.float32)
    displacement = float(np.sqrt(((positions - meso.positions) ** 2).sum(axis=1).max()))
    meso.positions = positions

    num_collapses = num_splits = 0
    if config.edit_connectivity:
        with watch.stage("collapse"):
            rounds = collapse.collapse_short_edges(meso, state.t_c, check=config.check)
            num_collapses = sum(len(done.removed) for done in rounds)
        with watch.stage("split"):
            t_f = fixing.degenerate_length(state.t_c)
            cuts, is_full = split.split_obtuse_edges(meso, config.split_angle, t_f, state.max_rows, check=config.check)
            num_splits = sum(len(done.new) for done in cuts)
        if is_full:
            state.failure = f"out of vertices: splitting would take the surface past {state.max_rows}"
        with watch.stage("fix"):
            fixing.fix_degenerate_vertices(meso, t_f)
            state.meso = meso = meso.compacted()
    num = len(order)
    left = np.stack([moved.contraction.left[:num], moved.smoothing.left[:num]])
    free, pull = packed["free"][:num].copy(), packed["pull"][:num].copy()
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
            volume=meso.volume() / state.first_volume,
            area=meso.area() / state.first_area,
            steps=int(moved.contraction.steps),
            residual=float(moved.contraction.residual),
            is_solved=bool(moved.contraction.is_solved and moved.smoothing.is_solved),
            smoothing_steps=int(moved.smoothing.steps),
            smoothing_residual=float(moved.smoothing.residual),
            moved=displacement,
            redone=retries,
        )
    )
    state.t_c = fixing.threshold(len(state.history), config.t_min, config.t_step, config.t_max)
    state.w_L_factor = min(state.w_L_factor * config.growth, LARGEST_FACTOR)
    return state


def _of_rows(weights: Weights, of_vertices: np.ndarray | None, order: np.ndarray, capacity: int) -> Weights:
    """The weights for a packed surface: scalars as they are, or one value a row."""
    if of_vertices is None:
        return weights
    return Weights(*packing.pad(of_vertices[order], capacity, 1.0, np.dtype(np.float64)).T)


def has_volume(state: State, config: Config) -> bool:
    """Whether there is more to contract: volume, or, as a flat sheet has none, area that is not yet down to a curve's.

    A thin curve still has some area; it is as small as it gets when three iterations take less than a tenth of it away.
    """
    last = state.history[-1]
    if abs(last.volume) > config.volume_tolerance:
        return True
    is_settled = len(state.history) > 3 and last.area > 0.9 * state.history[-4].area
    return last.area > config.area_tolerance and not is_settled


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
    if len(state.history) >= config.max_iterations:
        return False, f"max_iterations ({config.max_iterations}) reached"
    if len(state.history) > STALL_ITERATIONS:
        before = state.history[-1 - STALL_ITERATIONS]
        recent = state.history[-STALL_ITERATIONS:]
        best = min(abs(line.volume) for line in recent)
        if best > 0.99 * abs(before.volume) and last.live - last.fixed >= before.live - before.fixed:
            return False, f"stalled: no progress in {STALL_ITERATIONS} iterations"
    return None


def contract(
    mesh: Any,
    weights: Weights | None = None,
    config: Config | None = None,
    *,
    pins: Any = None,
    repair: bool | str | Repair = False,
    checkpoint: str | os.PathLike[str] | None = None,
    progress: bool = False,
) -> Flow:
    """Run the flow on ``mesh`` and keep everything; `skeletonize` is the short way to the curve alone.

    Args:
        mesh: a path that trimesh reads, a `trimesh.Trimesh`, or ``(vertices, faces)``: closed triangle surfaces.
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

    Raises:
        MeshError: the mesh is not a closed manifold that encloses a volume, and cannot be repaired without a doubt.
        ConfigError: a weight or an option is out of range, a pin is no vertex of the surface, or the checkpoint is of
            another run or cannot be written.
        FlowError: the mesh has no Voronoi diagram.
        Interrupted: Ctrl-C, once the iteration has ended; it is a KeyboardInterrupt, and holds the flow as it was.
    """
    weights, config = checked_options(weights, config)
    watch = Stopwatch()
    with watch.stage("front door"):
        checked = checking.prepare(mesh, repair)
    held, pinned = _checked_pins(pins, checked)
    of_vertices = _weights_of_vertices(weights, checked)
    identity = run_of(checked.given, weights, config, held, as_repair(repair)) if checkpoint is not None else {}
    keeper = Checkpoint(checkpoint, identity)
    states, reasons, parts = [], [], []
    with tqdm(desc="msf_jax", unit="it", disable=None if progress else True) as bar, held_back() as interruption:
        for number, component in enumerate(checked.components):
            pins_here = np.flatnonzero(np.isin(checked.members[number], pinned))
            of_members = None if of_vertices is None else of_vertices[checked.members[number]]
            state = init(component, number, config, watch, pins_here, of_members)
            keeper.restore(state)
            states.append(state)
            while (end := done(state, config)) is None:
                if interruption:
                    end = False, INTERRUPTED
                    break
                step(state, weights, config, watch)
                if state.history:
                    bar.set_postfix(vertices=state.history[-1].live, volume=f"{state.history[-1].volume:.1e}")
                    if len(state.history) % EVERY == 0:
                        keeper.save(states)
                bar.update()
            keeper.save(states)
            reasons.append(end)
            parts.append(assembly.read_curve(state, _thinned(state.meso, config), config, watch))
        notes = [keeper.failure] if keeper.failure else []
        run = assembly.assemble(checked, held, states, reasons, parts, weights, config, watch, notes)
    if interruption:
        kept = f"; run it again with checkpoint={str(checkpoint)!r} to go on" if checkpoint and not notes else ""
        raise Interrupted(
            f"interrupted after {len(run.history)} iterations: the curve so far is in this exception's flow{kept}", run
        )
    return run


def checked_options(weights: Any, config: Any) -> tuple[Weights, Config]:
    """The weights and the config that are meant, or a `ConfigError`."""
    if not isinstance(config, Config | None):
        raise ConfigError(f"config is a {type(config).__name__}: expected a msf_jax.Config")
    if not isinstance(weights, Weights | None):
        raise ConfigError(f"weights is a {type(weights).__name__}: expected a msf_jax.Weights (config comes after it)")
    config = Config() if config is None else config
    return (config.default_weights() if weights is None else weights), config


def _weights_of_vertices(weights: Weights, checked: checking.Surface) -> np.ndarray | None:
    """(V, 4) the weights of the checked surface's vertices, or None if all are scalars."""
    num = len(checked.vertex_of_input)
    columns = []
    for name, value in vars(weights).items():
        if np.shape(value) not in ((), (num,)):
            raise ConfigError(
                f"Weights.{name} has shape {np.shape(value)}: expected a number, or ({num},): one for each vertex"
            )
        columns.append(np.broadcast_to(np.asarray(value, dtype=np.float64), num)[checked.input_of_vertex])
    return None if all(np.ndim(value) == 0 for value in vars(weights).values()) else np.stack(columns, axis=1)


def _copy(meso: Meso) -> Meso:
    return replace(meso, **{name: value.copy() for name, value in vars(meso).items() if value is not None})


def _thinned(meso: Meso, config: Config) -> Meso:
    """The surface to read the curve off: one whose edges were never edited first loses its short ones."""
    if config.edit_connectivity:
        return meso
    meso = _copy(meso)
    collapse.collapse_short_edges(meso, config.t_min, check=config.check)
    return meso.compacted()


def _checked_pins(pins: Any, checked: checking.Surface) -> tuple[np.ndarray, np.ndarray]:
    """The caller's ``pins`` as numbers, and the rows of the checked surface that those vertices became."""
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
        raise ConfigError(
            f"pins name vertex {given[rows < 0][0]}, which no face uses: expected vertices of the surface"
        )
    return np.unique(given).astype(np.int64), np.unique(rows)
