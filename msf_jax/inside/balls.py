"""Poles by shrinking balls: the largest ball that touches the surface at a point from inside (Ma, Bae, Choi 2012).

The ball of radius r that touches the surface at v, with outward unit normal n, has its centre at c = v - r n. If
another point q of the surface is inside, the ball through v and q that touches at v is smaller, and has the radius

    r = |q - v|^2 / (2 n . (v - q)).

With q the point nearest to c, the ball shrinks until it is empty, after four to seven queries of a k-d tree. Queries
are fast for small balls, so balls start small, and double while they are empty. A point q that is close to v as seen
from the centre is noise, and does not count (Peters 2018).
"""

from typing import NamedTuple

import numpy as np
from scipy import spatial

from msf_jax.inside.voronoi import Poles
from msf_jax.solid.geometry import ROUNDING, unit, vertex_normals

FIRST = 0.01  # first radius, as a ratio to the largest side of the bounding box (to the diagonal if there is a solid)
NOISE = np.cos(np.radians(25))  # q is noise if the angle v-c-q is under 25 degrees; this is its cosine
MOST_SAMPLES = 20_000  # of a surface, between its vertices, at which balls start
MOST_QUERIES = 60  # queries for each ball, at most


class Balls(NamedTuple):
    """radius: (P,) of the ball at each point. touching: (P,) the other point that it touches; -1 if it touches none: it
    has the largest radius, or the point has no normal and its ball the first radius."""

    radius: np.ndarray
    touching: np.ndarray


def shrinking_balls(
    points: np.ndarray,
    normals: np.ndarray,
    tree: spatial.KDTree,
    first: float | np.ndarray,
    largest: float | np.ndarray,
    own: np.ndarray | None = None,
) -> Balls:
    """The largest ball behind each of ``points`` (P, 3) with outward unit ``normals``, empty of the points of ``tree``.

    Radii start at ``first``, and are at most ``largest``: numbers or (P,). ``own`` (P,) is the index of each point in
    the tree, because a point is not its own hit. Leave it out if the points are not in the tree.
    """
    num = len(points)
    largest = np.broadcast_to(largest, num)
    radius = np.broadcast_to(np.minimum(first, largest), num).astype(np.float64)
    touching = np.full(num, -1)
    own = np.full(num, -1) if own is None else own
    # Points without a normal keep the first radius.
    active = np.flatnonzero(np.einsum("ij,ij->i", normals, normals) > 0.5)
    grows = np.ones(num, dtype=bool)
    for _ in range(MOST_QUERIES):
        if not len(active):
            break
        v, n, r = points[active], normals[active], radius[active]
        away, found = tree.query(v - r[:, None] * n, k=2, distance_upper_bound=float(r.max()))
        away, found = np.asarray(away), np.asarray(found)
        is_own = found[:, 0] == own[active]
        away, found = np.where(is_own, away[:, 1], away[:, 0]), np.where(is_own, found[:, 1], found[:, 0])
        is_hit = away < (1 - ROUNDING) * r
        to_q = tree.data[np.where(is_hit, found, 0)] - v
        length2 = np.einsum("ij,ij->i", to_q, to_q)
        depth = -np.einsum("ij,ij->i", n, to_q)
        is_hit &= (depth > 0) & (length2 > 0)
        smaller = length2 / np.where(is_hit, 2 * depth, 1.0)
        # n . (q - c) / r is the cosine of the angle between v and q at the new centre.
        is_hit &= 1 - depth / np.where(is_hit, smaller, 1.0) < NOISE
        radius[active[is_hit]], touching[active[is_hit]] = smaller[is_hit], found[is_hit]
        grows[active[is_hit]] = False
        is_open = ~is_hit & grows[active] & (r < largest[active])
        radius[active[is_open]] = np.minimum(2 * r, largest[active])[is_open]
        active = active[is_hit | is_open]
    return Balls(radius, touching)


def ball_poles(sites: np.ndarray, faces: np.ndarray, box: np.ndarray | None = None) -> Poles:
    """The centre of the ball at every vertex of the closed mesh ``(sites, faces)``, in the form of `voronoi_poles`.

    Instead of a tetrahedron, it has the two vertices that the ball touches, each twice. A pole outside the bounding box
    of the points ``box`` (by default ``sites``) counts as not found.
    """
    normals = unit(vertex_normals(sites, faces))
    extent = float(np.ptp(sites, axis=0).max())
    every = np.arange(len(sites))
    found = shrinking_balls(sites, normals, spatial.KDTree(sites), FIRST * extent, extent, every)
    centre = sites - found.radius[:, None] * normals
    box = sites if box is None else box
    is_found = (found.touching >= 0) & ((centre >= box.min(axis=0)) & (centre <= box.max(axis=0))).all(axis=1)
    pair = np.stack([every, found.touching, every, found.touching], axis=1)
    return Poles(
        np.where(is_found[:, None], centre, sites),
        np.where(is_found[:, None], pair, -1),
        np.where(is_found, found.radius, 0.0),
    )
