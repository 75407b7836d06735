"""How thick the solid is at each vertex, for the lengths that the flow may use there.

A wire, a vessel or a neurite is thin beside the diagonal that lengths are fractions of. The ball that touches at a
vertex (see `balls`) knows how thin; but at a sharp edge, a bump or a dent it is small on the thickest solid. So a limb
is as thick as the largest ball near by: at a distance d from one of radius r, at least r - SLOPE d.
"""

import numpy as np
from scipy import sparse, spatial
from scipy.sparse import csgraph

from msf_jax.host.poles.balls import shrinking_balls
from msf_jax.host.solid.enclosure import Enclosure
from msf_jax.host.solid.geometry import unit, vertex_normals

THIN = 0.005  # diagonals: a limb of a larger radius is not thin
SLOPE = 0.25  # right angles, whose balls shrink to nothing, do not make a solid thin
THINNEST = 0.02  # of `THIN`: the frame's resolution is a hundredth of that
SAMPLED, MANY = 8, 30_000  # of so many vertices one is asked first, where there are more than that
LENGTH = 2.0  # radii of a limb: edges of a coarse surface that are longer hide where the limb is
AROUND = 16  # samples of the surface near a point, of whose balls the largest tells how thick the solid is there
MOST_SAMPLES = 20_000
FEW = 0.01  # of the vertices: a solid of which no more is thin is taken as it always was


def scales(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray | None:
    """(V,) the limb's radius at each vertex over `THIN`, 1 where it is larger; None where it is nearly everywhere.

    Args:
        vertices: (V, 3), of diagonal 1.
        faces: (F, 3), closed and oriented.
    """
    normals, tree = unit(vertex_normals(vertices, faces)), spatial.KDTree(vertices)
    radius = np.empty(0)
    # Of many vertices the balls at some show already that the solid is thick, if it is: radii are no less than those.
    for step in (SAMPLED, 1) if len(vertices) > MANY else (1,):
        some = np.arange(0, len(vertices), step)
        radius = shrinking_balls(vertices[some], normals[some], tree, 2 * THIN, 2 * THIN, some).radius
        if step > 1 or (radius < THIN).mean() > FEW:
            pairs = np.stack([faces, np.roll(faces, -1, axis=1)], axis=2).reshape(-1, 2)
            radius = limb_radii(vertices, pairs, some, radius, 2 * THIN)
        if (radius < THIN).mean() <= FEW:
            return None
    return np.clip(radius / THIN, THINNEST, 1.0)


def edge_lengths(shape: Enclosure, points: np.ndarray, longest: np.ndarray) -> np.ndarray:
    """(P,) how long an edge at each of ``points`` (P, 3) of a solid of diagonal 1 may be for the flow to see the limb,
    or at least `LENGTH` times ``longest`` (P,), the length of the longest one there.

    Balls that touch samples of the surface, between its vertices, too, tell how thick the solid is near by. None has to
    be larger than it takes for the longest edge, which saves most of their queries.
    """
    samples, normals = shape.surface_points(MOST_SAMPLES)
    tree = spatial.KDTree(samples)
    away, near = tree.query(points, k=min(AROUND, len(samples)))
    enough = np.zeros(len(samples))
    np.maximum.at(enough, near, longest[:, None] + SLOPE * away)
    asked = np.flatnonzero(enough)
    radius = np.zeros(len(samples))
    radius[asked] = shrinking_balls(samples[asked], normals[asked], tree, enough[asked], enough[asked], asked).radius
    return LENGTH * (radius[near] - SLOPE * away).max(axis=1, initial=0.0)


def limb_radii(points: np.ndarray, pairs: np.ndarray, some: np.ndarray, radius: np.ndarray, most: float) -> np.ndarray:
    """(P,) how thick the solid is at all points, at least, as balls of ``radius``, up to ``most``, are at ``some``.

    ``pairs`` (E, 2) are the edges between points (P, 3) of its surface or its curve.

    The largest of r_u - SLOPE |u - v| over all u is the most less a shortest way, from one more node joined to all u.
    """
    (tail, head), num = pairs.T, len(points)
    length = SLOPE * np.linalg.norm(points[tail] - points[head], axis=1)
    paths = sparse.coo_matrix(
        (np.maximum(np.r_[length, most - radius], 1e-12), (np.r_[tail, np.full(len(some), num)], np.r_[head, some])),
        shape=(num + 1, num + 1),
    )
    return most - csgraph.dijkstra(paths.tocsr(), directed=False, indices=num)[:num]
