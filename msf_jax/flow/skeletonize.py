"""The one call: a mesh in, its curve skeleton out."""

import os
from typing import Any

from msf_jax.base.options import Config, Weights
from msf_jax.flow import loop
from msf_jax.host.mesh.repair import Repair
from msf_jax.skeleton.skeleton import Skeleton


def skeletonize(
    mesh: Any,
    weights: Weights | None = None,
    config: Config | None = None,
    *,
    pins: Any = None,
    repair: bool | str | Repair = False,
    checkpoint: str | os.PathLike[str] | None = None,
    progress: bool = False,
) -> Skeleton:
    """The curve skeleton of a closed triangle mesh, by Medial Skeletonization Flow.

    Args:
        mesh: a path that trimesh reads, a `trimesh.Trimesh`, or ``(vertices (V, 3), faces (F, 3))``. It is not changed.
            Several components are skeletonised each, and returned as one skeleton.
        weights: of the flow; those of ``config``'s system if not given.
        config: the system and its options; ``Config()``, the article's own, if not given.
        pins: numbers of vertices of the mesh that are held in place; the curve goes through them.
        repair: True, or a `Repair` that says how far it may go, for a mesh that is not a closed manifold: weld, fill
            holes, separate what meets in an edge, and the like. "join" also makes one solid of closed parts that
            overlap, touch or nearly touch. Every change is counted in ``report.repairs``.
        checkpoint: a file to keep the state in, so that a run that was killed goes on; see `contract`.
        progress: show a progress bar on standard error, if that is a terminal.

    Returns:
        The curve in the caller's units, with radii, the map from the input's vertices, and a report to look at first.

    Raises:
        MeshError: the mesh is not a closed manifold that encloses a volume, and cannot be repaired without a doubt.
        ConfigError: a weight or an option is out of range, or a pin is no vertex of the surface.
        FlowError: the mesh has no Voronoi diagram, or this process was forked from one in which a run was made.
        Interrupted: Ctrl-C; a KeyboardInterrupt that holds the curve so far, as ``flow.skeleton``.
    """
    run = loop.contract(mesh, weights, config, pins=pins, repair=repair, checkpoint=checkpoint, progress=progress)
    return run.skeleton
