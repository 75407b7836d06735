"""How much of a curve is in limbs: its length in sheets, beyond what the solid explains, and where radii jump; and how
slender the limbs are.

For a branch of length l outside the balls of its junctions, in a part of the solid of volume V (see
`centrelines.profiles.swept_volumes`) with cross-sections of median area A,

    unexplained = max(l - V / A, 0),

because a limb of that cross-section and volume is V / A long. A curve that winds, runs to and fro, or has two strands
in one limb is longer. On the axis of a limb, radii change slowly: by the sine of half of a cone's angle.
"""

from typing import NamedTuple

import numpy as np
from scipy import spatial

from msf_jax.curve import branch_paths
from msf_jax.skeleton.centrelines.profiles import volumes_of
from msf_jax.solid import sections
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import arc_length, unit
from msf_jax.topology import graphs

SHEET = 2.0  # balls' radii: mean radius of a sheet's cross-section; that of a rectangle 2.6 times as wide as thick
# Mean radius of a sheet's section, over twice its area over its edge: 1 for a disc, 1.1 for a square, 1.4 for the
# rectangle above
FLAT_SECTION = 1.35
STEEP = 0.7  # change of the radius over the length of an edge; a cone with an angle of 89 degrees at its tip has it


class Shares(NamedTuple):
    """Shares of a curve's length, 0 to 1. in_sheets: in sheets, or in the wall around a void. unexplained: more than a
    limb of the same cross-sections and volume has. jumping: where radii change faster than on the axis of a limb.
    elongation is not a share: the length of a branch in its median diameters, the largest."""

    in_sheets: float
    unexplained: float
    jumping: float
    elongation: float


def shares_of(
    shape: Enclosure, vertices: np.ndarray, edges: np.ndarray, node_of_vertex: np.ndarray | None = None
) -> Shares:
    """The `Shares` of a curve ``(vertices (N, 3), edges (E, 2))`` in the solid ``shape``.

    ``node_of_vertex`` (V,) is the node of each vertex of the solid; the nearest one if not given.
    """
    radius, near = shape.approximate_clearance(vertices)
    paths = branch_paths.paths_of(vertices, edges, np.zeros(len(vertices), dtype=bool))
    length = np.linalg.norm(vertices[edges[:, 0]] - vertices[edges[:, 1]], axis=1)
    own = np.bincount(edges.ravel(), np.repeat(length, 2), len(vertices))
    # A junction has no cross-section, and the ball of an end is small.
    own[np.bincount(edges.ravel(), minlength=len(vertices)) != 2] = 0.0
    asked = np.flatnonzero(own * radius > 0)
    normal = unit(branch_paths.chords(vertices, paths, radius) @ vertices)[asked] if paths else vertices[asked]
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
    unexplained, jumping, elongation = _of_branches(vertices, edges, radius, area, volume)
    total = max(float(length.sum()), 1e-300)
    return Shares(in_sheets, unexplained / total, jumping / total, elongation)


def _of_branches(
    vertices: np.ndarray, edges: np.ndarray, radius: np.ndarray, area: np.ndarray, volume: np.ndarray
) -> tuple[float, float, float]:
    """The unexplained length, and the length of edges along which the radius jumps, both outside the junctions' balls;
    and the elongation.

    A ball within a radius of a tip touches the end of the limb, so its radius is left out."""
    degree = np.bincount(edges.ravel(), minlength=len(vertices))
    unexplained = jumping = elongation = 0.0
    for number, branch in enumerate(graphs.trace(len(vertices), edges)):
        nodes = np.array(branch)
        along, size = arc_length(vertices[nodes]), radius[nodes]
        begin, end = (float(size[k]) if degree[nodes[k]] > 2 else 0.0 for k in (0, -1))
        is_own = (along >= begin) & (along <= along[-1] - end)
        areas = area[nodes][is_own]
        areas = areas[areas > 0]
        if len(areas):
            unexplained += max(along[-1] - begin - end - float(volume[number] / np.median(areas)), 0.0)
        usual = float(np.median(size))
        elongation = max(elongation, float(along[-1]) / max(2 * usual, 1e-300))
        first, last = (usual if degree[nodes[k]] == 1 else 0.0 for k in (0, -1))
        is_inner = is_own & (along >= first) & (along <= along[-1] - last)
        step = np.diff(along)
        jumping += float(step[is_inner[1:] & is_inner[:-1] & (np.abs(np.diff(size)) > STEEP * step)].sum())
    return unexplained, jumping, elongation
