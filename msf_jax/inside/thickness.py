"""The thickness of the solid at each vertex, which the lengths of the flow adapt to.

Lengths are fractions of the diagonal, and a wire, a vessel or a neurite is thin compared with that. The ball at a
vertex (see `balls`) gives the thickness. But at a sharp edge, a bump or a dent balls are small on every solid. So the
thickness comes from the largest nearby ball: at a distance d from a ball of radius r, it is at least r - SLOPE d.
"""

import numpy as np
from scipy import spatial
from scipy.sparse import csgraph

from msf_jax.inside.balls import MOST_SAMPLES, shrinking_balls
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import unit, vertex_normals
from msf_jax.topology import graphs

THIN = 0.005  # diagonals: a limb of a smaller radius is thin
SLOPE = 0.25  # fall of the radius per distance; with it, right angles, whose balls shrink to 0, do not count as thin
LEAST_THICKNESS = 0.02  # ratio to `THIN`: the least thickness, a hundred times the frame's resolution
LENGTH = 2.0  # radii of a limb: longer edges of a coarse surface are too long to resolve the limb
NEAREST_SAMPLES = 16  # nearest samples of the surface whose balls give the thickness at a point
FEW = 0.01  # share of the vertices: with fewer thin ones, the solid counts as not thin


def scales(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray | None:
    """(V,) the limb's radius at each vertex over `THIN`, at most 1; None if it is 1 nearly everywhere.

    Args:
        vertices: (V, 3), of diagonal 1.
        faces: (F, 3), closed and oriented.
    """
    normals, tree = unit(vertex_normals(vertices, faces)), spatial.KDTree(vertices)
    every = np.arange(len(vertices))
    radius = shrinking_balls(vertices, normals, tree, 2 * THIN, 2 * THIN, every).radius
    if (radius < THIN).mean() > FEW:
        pairs = np.stack([faces, np.roll(faces, -1, axis=1)], axis=2).reshape(-1, 2)
        radius = limb_radii(vertices, pairs, every, radius, 2 * THIN)
    if (radius < THIN).mean() <= FEW:
        return None
    return np.clip(radius / THIN, LEAST_THICKNESS, 1.0)


def edge_lengths(shape: Enclosure, points: np.ndarray, longest: np.ndarray) -> np.ndarray:
    """(P,) the longest edge at each of ``points`` (P, 3), of a solid of diagonal 1, that still resolves the limb.

    Values of at least ``longest`` (P,), the longest edge at each point, are only lower bounds: larger balls and more of
    them would cost most of the time. The balls touch samples of the surface, which are also between its vertices.
    """
    samples, normals = shape.surface_points(MOST_SAMPLES)
    tree, limit = spatial.KDTree(samples), np.zeros(len(points))
    for count in (1, min(NEAREST_SAMPLES, len(samples))):  # the nearest ball is enough at most points
        left = np.flatnonzero(limit < longest)
        away, near = (found.reshape(len(left), count) for found in map(np.asarray, tree.query(points[left], k=count)))
        enough, radius = np.zeros((2, len(samples)))
        np.maximum.at(enough, near, longest[left, None] + SLOPE * away)
        asked = np.flatnonzero(enough)
        radius[asked] = shrinking_balls(samples[asked], normals[asked], tree, 2 * THIN, enough[asked], asked).radius
        limit[left] = LENGTH * (radius[near] - SLOPE * away).max(axis=1)
    return limit


def limb_radii(points: np.ndarray, pairs: np.ndarray, some: np.ndarray, radius: np.ndarray, most: float) -> np.ndarray:
    """(P,) lower bounds of the solid's radius at all points, from balls of ``radius``, up to ``most``, at ``some``.

    ``pairs`` (E, 2) are edges between ``points`` (P, 3) of the surface or the curve.

    The maximum of r_u - SLOPE |u - v| over all u is computed as ``most`` minus a shortest path to v, from an extra node
    with an edge of length most - r_u to each u.
    """
    (tail, head), num = pairs.T, len(points)
    length = SLOPE * np.linalg.norm(points[tail] - points[head], axis=1)
    cost = np.maximum(np.r_[length, most - radius], 1e-12)
    paths = graphs.weighted(num + 1, np.r_[tail, np.full(len(some), num)], np.r_[head, some], cost)
    return most - csgraph.dijkstra(paths, directed=False, indices=num)[:num]
