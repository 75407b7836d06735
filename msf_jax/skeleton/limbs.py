"""How much of a curve is in limbs: its length in sheets, and beyond what the solid explains; and how slender the limbs
are.

For a branch of length l outside the balls of its junctions, in a part of the solid of volume V (see
`measures.swept_volumes`) with cross-sections of area A,

    unexplained = max(l - V / A, 0),

because a limb of that cross-section and volume is V / A long. A curve that winds, runs to and fro, or has two strands
in one limb is longer. A is the median of the areas, or their mean along the branch if that is less: planes near a
junction cut the trunk, too, and in an ellipsoid most areas are above the mean.
"""

from typing import NamedTuple

import numpy as np
from scipy import spatial

from msf_jax.curve import branches
from msf_jax.skeleton.measures import volumes_of
from msf_jax.solid import sections
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import arc_length, unit
from msf_jax.topology import graphs

SHEET = 2.0  # balls' radii: mean radius of a sheet's cross-section; that of a rectangle 2.6 times as wide as thick
# Mean radius of a sheet's section, over twice its area over its edge: 1 for a disc, 1.1 for a square, 1.4 for the
# rectangle above
FLAT_SECTION = 1.35
THINNEST = 1e-9  # diagonals: a branch whose balls are smaller is in a part without volume, and has no elongation


class Shares(NamedTuple):
    """Shares of a curve's length, 0 to 1. in_sheets: in sheets, or in the wall around a void. unexplained: more than a
    limb of the same cross-sections and volume has. elongation is not a share: the length of a branch in its median
    diameters, the largest."""

    in_sheets: float
    unexplained: float
    elongation: float


def shares_of(
    shape: Enclosure, vertices: np.ndarray, edges: np.ndarray, node_of_vertex: np.ndarray | None = None
) -> Shares:
    """The `Shares` of a curve ``(vertices (N, 3), edges (E, 2))`` in the solid ``shape``.

    ``node_of_vertex`` (V,) is the node of each vertex of the solid; the nearest one if not given.
    """
    radius, near = shape.approximate_clearance(vertices)
    paths = branches.paths_of(vertices, edges, np.zeros(len(vertices), dtype=bool))
    length = np.linalg.norm(vertices[edges[:, 0]] - vertices[edges[:, 1]], axis=1)
    own = np.bincount(edges.ravel(), np.repeat(length, 2), len(vertices))
    # A junction has no cross-section, and the ball of an end is small.
    own[np.bincount(edges.ravel(), minlength=len(vertices)) != 2] = 0.0
    asked = np.flatnonzero(own * radius > 0)
    normal = unit(branches.chords(vertices, paths, radius) @ vertices)[asked] if paths else vertices[asked]
    places = vertices[asked], normal
    corners = sections.corners(shape, *places, radius[asked], near[asked])
    found = sections.measured(shape, *places, corners)
    # Where a limb begins, a plane across it cuts off the trunk's side, and a ball beside an axis is small: a section is
    # wider than the ball there, and not flat. In the middle of a round section of a shell is a void. Next to its inner
    # wall, the void is beside the curve, and the section is a wall around it.
    is_flat = (found.radius > FLAT_SECTION * found.size) | ~shape.contains(found.centroid)
    is_wide = (found.radius > SHEET * radius[asked]) & is_flat | ~found.is_found
    known = own[asked] * corners.is_closed
    in_sheets = float(known[is_wide].sum() / max(known.sum(), 1e-300))
    area = np.full(len(vertices), np.nan)
    area[asked] = np.where(corners.is_closed & found.is_found, sections.areas(shape, corners, normal), np.nan)
    if node_of_vertex is None:
        node_of_vertex = np.asarray(spatial.KDTree(vertices).query(shape.vertices)[1])
    volume = volumes_of(shape, vertices, edges, radius, node_of_vertex)
    unexplained, elongation = _of_branches(vertices, edges, radius, area, volume)
    total = max(float(length.sum()), 1e-300)
    return Shares(in_sheets, unexplained / total, elongation)


def _of_branches(
    vertices: np.ndarray, edges: np.ndarray, radius: np.ndarray, area: np.ndarray, volume: np.ndarray
) -> tuple[float, float]:
    """The unexplained length, outside the junctions' balls, and the elongation."""
    degree = np.bincount(edges.ravel(), minlength=len(vertices))
    unexplained = elongation = 0.0
    for number, branch in enumerate(graphs.trace(len(vertices), edges)):
        nodes = np.array(branch)
        along, size, areas = arc_length(vertices[nodes]), radius[nodes], area[nodes]
        begin, end = (float(size[k]) if degree[nodes[k]] > 2 else 0.0 for k in (0, -1))
        is_known = (along >= begin) & (along <= along[-1] - end) & (areas > 0)
        if is_known.any():
            mean = np.average(areas[is_known], weights=np.gradient(along)[is_known])
            usual = min(float(np.median(areas[is_known])), float(mean))
            # Where parts overlap, the volume beside a branch may be negative: nothing of it is explained.
            unexplained += max(float(along[-1] - begin - end - max(volume[number], 0.0) / usual), 0.0)
        thickness = 2 * float(np.median(size))
        elongation = max(elongation, float(along[-1]) / thickness if thickness > THINNEST else 0.0)
    return unexplained, elongation
