"""A skeleton of a curve without its mesh, as files of other programs have it."""

import numpy as np

from msf_jax.skeleton.report import Report
from msf_jax.skeleton.skeleton import Skeleton
from msf_jax.topology import graphs


def curve_of(vertices: np.ndarray, edges: np.ndarray, radii: np.ndarray) -> Skeleton:
    """A skeleton of a curve from a file, without a map; its report has only the counts."""
    components, cycles = graphs.cycle_count(len(vertices), edges)
    report = Report(
        components=components,
        mesh_components=components,
        genus=cycles,
        cycles=cycles,
        inside=float("nan"),
        converged=True,
        reason="read from a file",
        iterations=0,
        fixed=0,
        live=0,
        volume=0.0,
        solve_steps=0,
    )
    return Skeleton(vertices, edges, radii, np.empty(0, dtype=np.int64), report)
