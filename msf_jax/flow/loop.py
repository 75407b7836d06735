"""The flow, Algorithm 2: every component of a mesh is started, and stepped until it is done; then curves.

`starting` prepares a component, `stepping` runs one iteration (the only place where host and device meet), `ending`
says whether and why to stop, and `curves` reads them off, and `assembly` puts the run together.
"""

import os
from typing import Any

import numpy as np
from tqdm import tqdm

from msf_jax.base.errors import Interrupted
from msf_jax.base.interruption import held_back
from msf_jax.base.options import Config, Weights
from msf_jax.flow import assembly
from msf_jax.flow.checkpoint import Checkpoint, run_of
from msf_jax.flow.curves import curve_of
from msf_jax.flow.ending import done
from msf_jax.flow.request import checked_options, checked_pins, weights_of_vertices
from msf_jax.flow.starting import init
from msf_jax.flow.state import LIMITS, Flow, Limits, Stopwatch
from msf_jax.flow.stepping import step
from msf_jax.host.compiled import announce
from msf_jax.host.mesh import checking
from msf_jax.host.mesh.checking import Surface
from msf_jax.host.mesh.repair import Repair, as_repair
from msf_jax.host.meso import collapse
from msf_jax.host.meso import kernels as edits
from msf_jax.host.meso.meso import Meso
from msf_jax.host.solid import kernels as walks
from msf_jax.host.solid import loops

INTERRUPTED = "interrupted"
KERNELS = (  # of every run, in the order in which it needs them
    *(edits.short_edges, edits.apart, edits.merge),
    *(walks.windings, edits.wide_edges, edits.cut),
    *(walks.nearest, walks.hits, loops.loops, loops.measures),
)


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
        FlowError: the mesh has no Voronoi diagram.
        Interrupted: Ctrl-C, once the iteration has ended; it is a KeyboardInterrupt, and holds the flow as it was.
    """
    weights, config = checked_options(weights, config)
    announce(KERNELS)
    watch = Stopwatch()
    with watch.stage("front door"):
        checked = mesh if isinstance(mesh, Surface) else checking.prepare(mesh, repair)
    held, pinned = checked_pins(pins, checked)
    of_vertices = weights_of_vertices(weights, checked)
    identity = run_of(checked.given, weights, config, held, as_repair(repair)) if checkpoint is not None else {}
    keeper = Checkpoint(checkpoint, identity)
    states, reasons, parts = [], [], []
    with tqdm(desc="msf_jax", unit="it", disable=None if progress else True) as bar, held_back() as interruption:
        for number, component in enumerate(checked.components):
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
