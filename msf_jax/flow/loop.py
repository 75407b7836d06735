"""The flow, Algorithm 2: each component of a mesh is contracted until it is done, then its curve is extracted. The
steps of a run are in `guide/architecture.md`."""

import reprlib
from collections.abc import Iterable
from functools import cache
from typing import Any

import numpy as np
from tqdm import tqdm

from msf_jax.base.clock import Clock, Stopped
from msf_jax.base.errors import ConfigError, FlowError, Interrupted
from msf_jax.base.options import Config, Weights, is_traced, traced
from msf_jax.flow import assembly
from msf_jax.flow.curves import curve_of
from msf_jax.flow.starting import init
from msf_jax.flow.state import Flow
from msf_jax.flow.stepping import ending, step
from msf_jax.meshes import checking
from msf_jax.meshes.checking import Surface
from msf_jax.meshes.reading import MeshLike
from msf_jax.meshes.repair import Repair
from msf_jax.skeleton.skeleton import Skeleton
from msf_jax.solid.solid import Solid


def contract(
    mesh: "MeshLike",
    weights: Weights | None = None,
    config: Config | None = None,
    *,
    pins: Any = None,
    repair: bool | str | Repair = False,
    progress: bool = False,
) -> Flow:
    """Run the flow on ``mesh`` and return all of it. For arguments and errors see `skeletonize`, which returns the
    finished curve alone. ``mesh`` may also be a `Surface` that was checked before."""
    weights, config = checked_options(weights, config)
    clock = Clock(config.max_seconds)
    with clock.listening(), tqdm(desc="msf_jax", unit="it", disable=None if progress else True) as bar:
        with clock.stage("validation"):
            checked = mesh if isinstance(mesh, Surface) else checking.prepare(mesh, repair)
        solid = Solid(checked.vertices, checked.faces)
        pins_given, pins = checked_pins(pins, checked)
        of_vertices, begin_rest = weights_of_vertices(weights, checked), cache(solid.begin)
        states, reasons, parts = [], [], []
        for number, component in enumerate(checked.components):
            pins_here = np.flatnonzero(np.isin(checked.members[number], pins))
            of_members = None if of_vertices is None else of_vertices[checked.members[number]]
            state = None
            try:
                state = init(component, number, config, clock, pins_here, of_members, begin_rest)
                while (end := ending(state, config)) is None:
                    clock.check()
                    step(state, weights, config, clock)
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
        if not parts:
            when = "before the first iteration has ended: there is no curve"
            if clock.was_pressed:
                raise KeyboardInterrupt(f"interrupted {when} yet")
            raise FlowError(f"{clock.reason} {when}; expected more seconds")
        if len(parts) < len(checked.components):
            reasons += [(False, "not begun")] * (len(checked.components) - len(parts))
            checked = checked.first(len(parts))
            pins_given = pins_given[checked.vertex_of_input[pins_given] >= 0]
            solid = Solid(checked.vertices, checked.faces)
        elif not clock.reason:
            with clock.stage("report"):
                begin_rest().result()
        run = assembly.assemble(checked, solid, pins_given, states, reasons, parts, weights, config, clock)
    if clock.was_pressed:
        count = len(run.history)
        raise Interrupted(f"interrupted after {count} iterations: the curve so far is in this exception's flow", run)
    return run


def skeletonize(
    mesh: "MeshLike",
    weights: Weights | None = None,
    config: Config | None = None,
    *,
    pins: Any = None,
    repair: bool | str | Repair = False,
    progress: bool = False,
) -> Skeleton:
    """The curve skeleton of a closed triangle mesh, by Medial Skeletonization Flow.

    Args:
        mesh: a path that trimesh reads, a `trimesh.Trimesh`, or ``(vertices (V, 3), faces (F, 3))``. It is not changed.
            Each component is skeletonised; the result is one skeleton.
        weights: of the flow; those of ``config``'s system if not given. Each is a number, or an array (V,) with one for
            every vertex of the mesh. Weights of a merged or a new vertex are interpolated as its position is.
        config: the system and its options; ``Config()``, the article's, if not given.
        pins: ids of vertices of the mesh that are held in place; the curve goes through them.
        repair: True, or a `Repair` with limits, to repair a mesh that is not a closed manifold: weld, fill holes,
            separate sheets that share an edge, and the like. "join" also makes one solid of closed parts that overlap,
            touch or nearly touch. Every change is counted in ``report.repairs``.
        progress: show a progress bar on standard error, if that is a terminal.

    Returns:
        The curve in the caller's units, with radii, the map from the input's vertices, and a report. Look at the report
        first.

    Raises:
        MeshError: the mesh is not a closed manifold that encloses a volume, and ``repair`` was not given or could not
            make it one.
        ConfigError: a weight or an option is out of range, or a pin is no vertex of the surface.
        FlowError: the mesh has no Voronoi diagram for its poles, or ``config.max_seconds`` had passed before the first
            iteration had ended.
        Interrupted: Ctrl-C; a KeyboardInterrupt with the unfinished flow, whose curve is ``flow.skeleton``. Before the
            first iteration has ended there is none, and a plain KeyboardInterrupt is raised.
    """
    return contract(mesh, weights, config, pins=pins, repair=repair, progress=progress).skeleton


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
    weights.check(num)
    values = [np.asarray(value, dtype=np.float64) for value in vars(weights).values()]
    columns = [np.broadcast_to(value, num)[checked.input_of_vertex] for value in values]
    return None if all(value.ndim == 0 for value in values) else np.stack(columns, axis=1)


def checked_pins(pins: Any, checked: Surface) -> tuple[np.ndarray, np.ndarray]:
    """The caller's ``pins`` as an array of ids, and the ids of these vertices in the checked surface."""
    num = len(checked.vertex_of_input)
    listed = [] if pins is None else list(pins) if isinstance(pins, Iterable) else [pins]
    try:
        given: np.ndarray = np.array(listed)
    except ValueError:  # lists of different lengths
        given = np.empty((0, 0))
    if given.shape == (0,):
        return given.astype(np.int64), given.astype(np.int64)
    if given.ndim != 1 or given.dtype.kind not in "iu" or given.min() < 0 or given.max() >= num:
        raise ConfigError(f"pins is {reprlib.repr(pins)}: expected vertex numbers from 0 to {num - 1}")
    rows = checked.vertex_of_input[given]
    if (rows < 0).any():
        raise ConfigError(f"pins has vertex {given[rows < 0][0]}, which no face uses: expected vertices of the surface")
    is_lining = np.isin(rows, np.concatenate(checked.linings))
    if is_lining.any():
        raise ConfigError(f"pins has vertex {given[is_lining][0]} of a cavity: expected vertices of the outer surface")
    return np.unique(given).astype(np.int64), np.unique(rows)
