"""CGAL's polylines, one line of text for each branch: writing and reading."""

from typing import TYPE_CHECKING

import numpy as np

from msf_jax.base.errors import ConfigError
from msf_jax.skeleton.formats.text import point
from msf_jax.topology import graphs

if TYPE_CHECKING:
    from msf_jax.skeleton.skeleton import Skeleton


def written(skeleton: "Skeleton") -> str:
    """A line for each branch: the number of points, and their coordinates."""
    return "".join(
        f"{len(branch)} {' '.join(point(skeleton.vertices[node]) for node in branch)}\n"
        for branch in graphs.trace(len(skeleton.vertices), skeleton.edges)
    )


def parsed(name: str, lines: list[str]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Nodes (N, 3), edges and radii (N,), which are 0. Coincident ends become one node."""
    points, edges = [], []
    for number, line in enumerate(lines, 1):
        if not line.strip():
            continue
        try:
            count, *values = line.split()
            path = np.array(values, dtype=np.float64).reshape(max(int(count), 0), 3)
        except (ValueError, OverflowError):
            raise ConfigError(
                f"line {number} of {name!r} is no polyline: expected a count, and as many points of three numbers"
            ) from None
        start = len(points)
        points += path.tolist()
        edges += [(k, k + 1) for k in range(start, len(points) - 1)]
    given = np.array(points).reshape(-1, 3)
    first, inverse = np.unique(given, axis=0, return_index=True, return_inverse=True)[1:]
    order = np.argsort(first)  # the order of the file
    rank = np.argsort(order)
    joined = rank[inverse.ravel()][np.array(edges, dtype=np.int64).reshape(-1, 2)]
    return given[first[order]], joined, np.zeros(len(order))
