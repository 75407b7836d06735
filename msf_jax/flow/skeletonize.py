"""`skeletonize`: from a mesh to its curve skeleton in one call."""

from dataclasses import replace
from typing import Any

import numpy as np

from msf_jax import metrics
from msf_jax.base.errors import ConfigError, Interrupted
from msf_jax.base.options import Config, Weights
from msf_jax.flow import loop
from msf_jax.flow.loop import checked_options
from msf_jax.meshes.reading import MeshLike
from msf_jax.meshes.repair import Repair
from msf_jax.skeleton.skeleton import Skeleton

JITTER = 1e-4  # diagonals: standard deviation, along each axis, of the vertex noise in ``jittered_runs``
SAMPLE_SPACING = 0.005  # diagonals: spacing of the sample points at which two curves are compared


def skeletonize(
    mesh: "MeshLike",
    weights: Weights | None = None,
    config: Config | None = None,
    *,
    pins: Any = None,
    repair: bool | str | Repair = False,
    progress: bool = False,
    jittered_runs: int = 0,
) -> Skeleton:
    """The curve skeleton of a closed triangle mesh, by Medial Skeletonization Flow.

    Args:
        mesh: a path that trimesh reads, a `trimesh.Trimesh`, or ``(vertices (V, 3), faces (F, 3))``. It is not changed.
            Each component is skeletonised; the result is one skeleton.
        weights: of the flow; those of ``config``'s system if not given.
        config: the system and its options; ``Config()``, the article's, if not given.
        pins: ids of vertices of the mesh that are held in place; the curve goes through them.
        repair: True, or a `Repair` with limits, to repair a mesh that is not a closed manifold: weld, fill holes,
            separate sheets that share an edge, and the like. "join" also makes one solid of closed parts that overlap,
            touch or nearly touch. Every change is counted in ``report.repairs``.
        progress: show a progress bar on standard error, if that is a terminal.
        jittered_runs: the number of extra runs on the mesh with noise of 1e-4 diagonals at every vertex.
            ``report.figures`` says how far their curves are from this one: "spread" is the mean distance in both
            directions, in median radii; "spread_leaves" is the largest difference in the number of leaves.

    Returns:
        The curve in the caller's units, with radii, the map from the input's vertices, and a report. Look at the report
        first.

    Raises:
        MeshError: the mesh is not a closed manifold that encloses a volume, and ``repair`` was not given or could not
            make it one.
        ConfigError: a weight or an option is out of range, or a pin is no vertex of the surface; or ``jittered_runs``
            was given with pins or with arrays of weights.
        FlowError: the mesh has no Voronoi diagram, or ``config.max_seconds`` had passed before the first iteration had
            ended.
        Interrupted: Ctrl-C; a KeyboardInterrupt with the unfinished flow, whose curve is ``flow.skeleton``. Before the
            first iteration has ended there is none, and a plain KeyboardInterrupt is raised.
    """
    if isinstance(jittered_runs, bool) or not isinstance(jittered_runs, int | np.integer) or jittered_runs < 0:
        raise ConfigError(f"jittered_runs is {jittered_runs!r}: expected a number of runs, 0 or more")
    weights, config = checked_options(weights, config)
    if jittered_runs and (pins is not None or any(np.ndim(value) for value in vars(weights).values())):
        raise ConfigError("jittered_runs was given with pins, or with weights for each vertex: expected neither")
    run = loop.contract(mesh, weights, config, pins=pins, repair=repair, progress=progress)
    if not jittered_runs:
        return run.skeleton
    try:
        spreads = _spread(run.skeleton, weights, config, int(jittered_runs))
    except KeyboardInterrupt:
        raise Interrupted(
            "interrupted in a run for the spread: the whole curve is in this exception's flow", run
        ) from None
    figures = run.skeleton.report.figures | spreads
    return replace(run.skeleton, report=replace(run.skeleton.report, figures=figures))


def _spread(skeleton: Skeleton, weights: Weights, config: Config, num: int) -> dict[str, float]:
    """How far the curves of ``num`` runs on the mesh with noise are from ``skeleton``."""
    solid, random = skeleton.known_source.solid, np.random.default_rng(0)
    unit = max(float(np.median(skeleton.radii)), SAMPLE_SPACING * solid.diagonal)
    away, leaves = [], []
    for _ in range(num):
        vertices = solid.leave(solid.shape.vertices + random.normal(0, JITTER, solid.shape.vertices.shape))
        other = loop.contract((vertices, solid.shape.faces), weights, config).skeleton
        for one, two in ((skeleton, other), (other, skeleton)):
            points, length, _ = metrics.sample_curve(one.vertices, one.edges, SAMPLE_SPACING * solid.diagonal)
            away.append(np.average(metrics.curve_distance(points, two.vertices, two.edges), weights=length))
        leaves.append(abs(other.num_leaves - skeleton.num_leaves))
    return {"spread": float(np.mean(away)) / unit, "spread_leaves": float(max(leaves))}
