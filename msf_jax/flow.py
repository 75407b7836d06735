"""The flow, Algorithm 2: the only place where host and device meet.

`init` prepares a component, `step` runs one iteration (update L, contract and smooth on the device; collapse, split,
fix and raise the threshold on the host), `done` says whether and why to stop, and `contract` runs them all and reads
the curve off what is left.
"""

from dataclasses import replace
from typing import Any

import jax
import numpy as np
from scipy import spatial
from tqdm import tqdm

from msf_jax.device.buffers import Buffers, Rings, real_dtype
from msf_jax.device.iteration import jitted_move
from msf_jax.errors import ConfigError, MeshError
from msf_jax.host import collapse, curve, fixing, homology, packing, poles, reconstruction, split, surface
from msf_jax.host.curve import Curve
from msf_jax.host.enclosure import Enclosure
from msf_jax.host.frame import RESOLUTION, frame_of, sort_mesh
from msf_jax.host.meso import Meso
from msf_jax.host.surface import Component, Surface
from msf_jax.layout import next_layout
from msf_jax.metrics import inside_fraction
from msf_jax.options import Config, Weights
from msf_jax.run import Flow, Iteration, State, Stopwatch
from msf_jax.skeleton import Report, Skeleton

STALL_ITERATIONS = 30  # without progress, after which the flow gives up: longer than a tooth of the default threshold
LARGEST_FACTOR = 2.0**20  # where a growing w_L stops: past it the other weights no longer count
FLATTEST = 1e-9  # volume, in diagonals cubed, that must be left when coordinates are rounded to the frame's resolution
GROWTH_LIMIT = 3  # splitting may not take the surface past so many times its first number of vertices
BLOW_UP = 10.0  # diagonals from the centre: nothing that contracts goes there


def init(component: Component, number: int, config: Config, watch: Stopwatch) -> State:
    """The component at the start of its flow: in its own frame, resampled if asked, with its poles."""
    frame = frame_of(component.vertices)
    entered = frame.enter(component.vertices)
    order, faces = sort_mesh(entered, component.faces)
    original = vertices = entered[order]
    input_surface = Enclosure(vertices, faces)
    if config.reconstruct_mesh:
        with watch.stage("reconstruction"):
            vertices = reconstruction.reconstruct(vertices, faces, config.reconstruct_mesh)
    meso = Meso.from_mesh(vertices, faces)
    if abs(meso.volume()) < FLATTEST:
        raise MeshError(
            f"component {number} is too thin: no volume is left of it at the flow's resolution, "
            f"{RESOLUTION:.0e} of its diagonal; expected a solid"
        )
    if 0 < component.genus <= homology.LARGEST_GENUS:
        with watch.stage("homology"):
            meso.classes = homology.ring_classes(original, faces, meso.rings)
    max_rows = GROWTH_LIMIT * meso.num_rows + 1000
    if config.resample:
        with watch.stage("resampling"):
            meso = _resampled(meso, config.resample, check=config.check)
            max_rows = max(max_rows, GROWTH_LIMIT * meso.num_rows)
    if config.use_poles:
        meso.poles, meso.has_pole = _poles(meso, input_surface, config, watch)
    return State(
        component=component,
        number=number,
        frame=frame,
        order=order,
        first_volume=meso.volume(),
        max_rows=max_rows,
        first_area=meso.area(),
        first_ring_area=_one_ring_areas(meso) if config.w_H_follows_area else np.empty(0),
        poles=meso.poles.copy(),
        has_pole=meso.has_pole.copy(),
        meso=meso,
        t_c=config.t_min,
        w_L_factor=1.0,
        layout=None,
    )


def _resampled(meso: Meso, length: float, *, check: bool) -> Meso:
    """Edges between 4/5 and 4/3 of ``length``, as far as the topology lets them."""
    for _ in range(3):
        split.split_long_edges(meso, 4 / 3 * length, check=check)
        collapse.collapse_short_edges(meso, 4 / 5 * length, check=check)
        meso = meso.compacted()
    return meso


def _poles(meso: Meso, input_surface: Enclosure, config: Config, watch: Stopwatch) -> tuple[np.ndarray, np.ndarray]:
    """Poles of the (reconstructed) surface; one that lies outside the input's surface does not pull."""
    sites, faces = meso.positions, meso.faces()
    if config.reconstruct_poles:
        with watch.stage("reconstruction"):
            sites = reconstruction.reconstruct(sites, faces, config.reconstruct_poles)
    with watch.stage("poles"):
        found = poles.voronoi_poles(sites, faces, box=input_surface.vertices)
        has_pole = found.is_found.copy()
        has_pole[has_pole] = input_surface.contains(found.position[has_pole])
        return np.where(has_pole[:, None], found.position, meso.positions), has_pole


def _one_ring_areas(meso: Meso) -> np.ndarray:
    a, b, c = (meso.positions[corner] for corner in meso.faces().T)
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
    return np.bincount(meso.faces().T.ravel(), weights=np.tile(area, 3), minlength=meso.num_rows)


def step(state: State, weights: Weights, config: Config, watch: Stopwatch) -> State:
    """One iteration, in place; on numbers that are not finite or run away, ``state.failure`` says so instead."""
    meso = state.meso
    dtype = np.dtype(real_dtype())
    with watch.stage("solve"):
        state.layout = next_layout(state.layout, meso.num_rows, packing.rows_beyond(meso))
        order, packed = packing.pack(meso, state.layout, state.first_ring_area, dtype)
        packed["rings"] = Rings(*packed["rings"])
        scaled = replace(weights, w_L=weights.w_L * state.w_L_factor)
        scaled = jax.tree_util.tree_map(lambda weight: np.asarray(weight, dtype), scaled)
        moved = jax.device_get(jitted_move(Buffers(**packed), scaled, config, state.layout))
    positions = packing.unpack(moved.positions, order)
    is_solved = np.isfinite(moved.contraction.residual) and np.isfinite(moved.smoothing.residual)
    if not is_solved or not np.isfinite(positions).all() or np.abs(positions).max() > BLOW_UP:
        state.failure = "a step left finite or sensible coordinates; the one before it was kept"
        return state
    displacement = float(np.sqrt(((positions - meso.positions) ** 2).sum(axis=1).max()))
    meso.positions = positions

    num_collapses = num_splits = 0
    if config.edit_connectivity:
        with watch.stage("collapse"):
            rounds = collapse.collapse_short_edges(meso, state.t_c, check=config.check)
            num_collapses = sum(len(done.removed) for done in rounds)
        with watch.stage("split"):
            t_f = fixing.degenerate_length(state.t_c)
            cuts = split.split_obtuse_edges(meso, config.split_angle, t_f, state.max_rows, check=config.check)
            num_splits = sum(len(done.new) for done in cuts)
        with watch.stage("fix"):
            fixing.fix_degenerate_vertices(meso, t_f)
            state.meso = meso = meso.compacted()
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
            smoothing_steps=int(moved.smoothing.steps),
            smoothing_residual=float(moved.smoothing.residual),
            moved=displacement,
        )
    )
    state.t_c = fixing.threshold(len(state.history), config.t_min, config.t_step, config.t_max)
    state.w_L_factor = min(state.w_L_factor * config.growth, LARGEST_FACTOR)
    return state


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
    mesh: Any, weights: Weights | None = None, config: Config | None = None, *, progress: bool = False
) -> Flow:
    """Run the flow on ``mesh`` and keep everything; `skeletonize` is the short way to the curve alone.

    Args:
        mesh: a path that trimesh reads, a `trimesh.Trimesh`, or ``(vertices, faces)``: closed triangle surfaces.
        weights: of the flow; those of ``config``'s system if not given.
        config: the system and its options; ``Config()``, the article's own, if not given.
        progress: show a progress bar on standard error, if that is a terminal.

    Raises:
        MeshError: the mesh is not a closed manifold that encloses a volume, and cannot be repaired without a doubt.
        ConfigError: a weight or an option is out of range.
        FlowError: the mesh has no Voronoi diagram.
    """
    weights, config = _checked_options(weights, config)
    watch = Stopwatch()
    with watch.stage("front door"):
        checked = surface.prepare(mesh)
    states, reasons, curves = [], [], []
    with tqdm(desc="msf_jax", unit="it", disable=None if progress else True) as bar:
        for number, component in enumerate(checked.components):
            state = init(component, number, config, watch)
            while (end := done(state, config)) is None:
                step(state, weights, config, watch)
                if state.history:
                    bar.set_postfix(vertices=state.history[-1].live, volume=f"{state.history[-1].volume:.1e}")
                bar.update()
            states.append(state)
            reasons.append(end)
            with watch.stage("curve"):
                curves.append(_curve(state.meso, config))
    return _finish(checked, states, reasons, curves, weights, config, watch)


def _checked_options(weights: Any, config: Any) -> tuple[Weights, Config]:
    if not isinstance(config, Config | None):
        raise ConfigError(f"config is a {type(config).__name__}: expected a msf_jax.Config")
    if not isinstance(weights, Weights | None):
        raise ConfigError(f"weights is a {type(weights).__name__}: expected a msf_jax.Weights (config comes after it)")
    config = Config() if config is None else config
    return (config.default_weights() if weights is None else weights), config


def _curve(meso: Meso, config: Config) -> tuple[Curve, Meso]:
    """The curve of a contracted surface; one whose edges were never edited first loses its short ones."""
    if not config.edit_connectivity:
        meso = replace(meso, **{name: value.copy() for name, value in vars(meso).items() if value is not None})
        collapse.collapse_short_edges(meso, config.t_min, check=config.check)
        meso = meso.compacted()
    return curve.extract_curve(meso.positions, meso.rings, meso.classes), meso


def _finish(
    checked: Surface,
    states: list[State],
    reasons: list[tuple[bool, str]],
    curves: list[tuple[Curve, Meso]],
    weights: Weights,
    config: Config,
    watch: Stopwatch,
) -> Flow:
    """Put the components together again, in the caller's units, and write the report."""
    nodes, edges, meso_vertices, meso_faces = [], [], [], []
    node_of_vertex = np.empty(len(checked.vertices), dtype=np.int64)
    num_nodes = num_meso = 0
    for state, (found, meso), member in zip(states, curves, checked.members, strict=True):
        nodes.append(state.frame.leave(found.nodes))
        edges.append(found.edges + num_nodes)
        node_of_vertex[member[state.order]] = found.node_of_meso[meso.node_of_input] + num_nodes
        meso_vertices.append(state.frame.leave(state.meso.positions))
        meso_faces.append(state.meso.faces() + num_meso)
        num_nodes += len(found.nodes)
        num_meso += len(state.meso.positions)
    vertices, all_edges = np.concatenate(nodes), np.concatenate(edges)
    with watch.stage("report"):
        # In units of the whole mesh, so that no square leaves the range of floating point.
        low, high = checked.vertices.min(axis=0), checked.vertices.max(axis=0)
        centre, unit = (low + high) / 2, float((high - low).max())
        shape = Enclosure((checked.vertices - centre) / unit, checked.faces)
        points = (vertices - centre) / unit
        radii = unit * np.where(shape.contains(points), shape.distances(points), 0.0)
        inside = inside_fraction(shape, points, all_edges)
        mesh_map = _map_of_input(checked, vertices, node_of_vertex)
        components, cycles = curve.cycle_count(len(vertices), all_edges)
    history = tuple(line for state in states for line in state.history)
    report = Report(
        components=components,
        mesh_components=len(checked.components),
        genus=sum(component.genus for component in checked.components),
        cycles=cycles,
        inside=inside,
        converged=all(is_converged for is_converged, _ in reasons),
        reason="; ".join(dict.fromkeys(reason for _, reason in reasons)),
        iterations=len(history),
        fixed=sum(int(state.meso.is_fixed.sum()) for state in states),
        live=sum(state.meso.num_live for state in states),
        volume=max(abs(state.history[-1].volume) if state.history else 1.0 for state in states),
        unsolved=sum(
            (not line.residual <= config.solve_tolerance) + (not line.smoothing_residual <= config.solve_tolerance)
            for line in history
        ),
        solve_steps=sum(line.steps + line.smoothing_steps for line in history),
        repairs=checked.repairs,
        seconds=watch.seconds,
    )
    skeleton = Skeleton(vertices, all_edges, radii, mesh_map, report)
    return Flow(
        weights=weights,
        config=config,
        meso_skeleton=(np.concatenate(meso_vertices), np.concatenate(meso_faces)),
        is_fixed=np.concatenate([state.meso.is_fixed for state in states]),
        poles=_by_vertex([state.frame.leave(state.poles) for state in states], states, checked),
        has_pole=_by_vertex([state.has_pole for state in states], states, checked),
        history=history,
        curve=skeleton,
        skeleton=skeleton,
    )


def _by_vertex(parts: list[np.ndarray], states: list[State], checked: Surface) -> np.ndarray:
    """One array for the whole surface from one for each component; joined as they are where these were resampled."""
    joined = np.concatenate(parts)
    if len(joined) != len(checked.vertices):
        return joined
    whole = np.empty_like(joined)
    orders = [member[state.order] for member, state in zip(checked.members, states, strict=True)]
    whole[np.concatenate(orders)] = joined
    return whole


def _map_of_input(checked: Surface, nodes: np.ndarray, node_of_vertex: np.ndarray) -> np.ndarray:
    """(V,) the node of every vertex of the caller's mesh; one that no face uses goes to the nearest node."""
    is_used = checked.vertex_of_input >= 0
    mesh_map = np.where(is_used, node_of_vertex[checked.vertex_of_input], -1)
    mesh_map[~is_used] = spatial.KDTree(nodes).query(checked.strays)[1]
    return mesh_map
