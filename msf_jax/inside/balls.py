"""Poles, and the thickness of a solid, by balls inside.

A shrinking ball becomes the largest ball that touches the surface at a point from inside (Ma, Bae, Choi 2012).

The ball of radius r that touches the surface at v, with outward unit normal n, has its centre at c = v - r n. If
another point q of the surface is inside, the ball through v and q that touches at v is smaller, and has the radius

    r = |q - v|^2 / (2 n . (v - q)).

The empty ball has the least of these radii. A search is fast for a small ball, so balls start small, and double while
they are empty. A point q that is close to v as seen from the centre of its ball is noise, and does not count (Peters
2018).

A Voronoi pole is a point of the medial axis for a vertex (article 3.1.2; Amenta et al. 2001): of a vertex v with
outward normal n the vertex w of its Voronoi cell, inside the bounding box, with the most negative <n, w - v>.

The lengths of the flow adapt to the thickness of the solid at each vertex, as a wire, a vessel or a neurite is thin
compared with the diagonal. At a sharp edge, a bump or a dent balls are small on every solid. So the thickness comes
from the largest nearby ball: at a distance d from a ball of radius r, it is at least r - SLOPE d.
"""

from typing import NamedTuple

import numpy as np
from scipy import spatial
from scipy.sparse import csgraph

from msf_jax.base.errors import FlowError
from msf_jax.numerics.compiled import Ints, Points, Reals, kernel
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import RESOLUTION, cross, largest_of_each, unit, vertex_normals
from msf_jax.solid.kernels import dot, is_within, minus, onward, point_of, tree_of
from msf_jax.topology import graphs

NOISE = np.cos(np.radians(25))  # q is noise if the angle v-c-q is under 25 degrees; this is its cosine
MOST_SAMPLES = 20_000  # of a surface, between its vertices, at which balls start
THIN = 0.005  # diagonals: a limb of a smaller radius is thin
SLOPE = 0.25  # fall of the radius per distance; with it, right angles, whose balls shrink to 0, do not count as thin
LENGTH = 2.0  # radii of a limb: longer edges of a coarse surface are too long to resolve the limb
NEAREST_SAMPLES = 16  # nearest samples of the surface whose balls give the thickness at a point
FEW = 0.01  # share of the vertices: with fewer thin ones, the solid counts as not thin


Radius = float | np.ndarray
Tree = tuple[np.ndarray, np.ndarray]


class Poles(NamedTuple):
    """position: (V, 3), the vertex itself if it has no pole. tetrahedron: (V, 4) the sites whose circumcentre the pole
    is, -1 without a pole. radius: (V,) distance from vertex to pole, 0 without a pole."""

    position: np.ndarray
    tetrahedron: np.ndarray
    radius: np.ndarray

    @property
    def is_found(self) -> np.ndarray:
        """(V,) True where the vertex has a pole."""
        return self.tetrahedron[:, 0] >= 0


def circumcentres(diagram: spatial.Delaunay) -> np.ndarray:
    """Circumcentres (T, 3) of the tetrahedra; not finite for a tetrahedron without volume.

    Lifted to the paraboloid z = |x|^2, a tetrahedron spans the hyperplane n . x + m z + c = 0, and its circumcentre is
    -n / 2m. Qhull computes one for all tetrahedra of the same empty ball, of which some may be flat."""
    plane = diagram.equations
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        return -plane[:, :3] / (2 * diagram.paraboloid_scale * plane[:, 3:4])


def voronoi_poles(sites: np.ndarray, faces: np.ndarray, box: np.ndarray | None = None) -> Poles:
    """The pole of every vertex of the closed mesh ``(sites, faces)``; none if its cell has no Voronoi vertex behind the
    surface and inside the bounding box of the points ``box`` (P, 3), by default of the sites.

    Raises:
        FlowError: the vertices span no volume, or have non-finite values.
    """
    try:
        diagram = spatial.Delaunay(sites)
    except (spatial.QhullError, ValueError) as error:
        raise FlowError(
            f"no Voronoi diagram of {len(sites)} vertices: {str(error).strip().splitlines()[0]}; "
            "expected points that span a volume: check the mesh, or turn poles off: "
            "Config(preprocessing=PreprocessingOptions(use_poles=False))"
        ) from error
    tetrahedra, centre = diagram.simplices, circumcentres(diagram)
    box = sites if box is None else box
    low, high = box.min(axis=0), box.max(axis=0)
    is_inside_box = ((centre >= low) & (centre <= high)).all(axis=1)  # False if a centre is not finite
    tetrahedra, centre = tetrahedra[is_inside_box], centre[is_inside_box]

    normal = vertex_normals(sites, faces)
    site = tetrahedra.ravel()
    tetrahedron = np.repeat(np.arange(len(tetrahedra)), 4)
    depth = np.einsum("ij,ij->i", normal[site], centre[tetrahedron] - sites[site])
    deepest = np.zeros(len(sites))
    np.minimum.at(deepest, site, depth)
    is_pole = (depth == deepest[site]) & (depth < 0)
    site, tetrahedron = site[is_pole], tetrahedron[is_pole]
    chosen = np.full(len(sites), -1)
    chosen[site[::-1]] = tetrahedron[::-1]  # the first of several at the same depth (cospherical sites)

    found = chosen >= 0
    position = np.array(sites, dtype=np.float64)
    position[found] = centre[chosen[found]]
    corners = np.full((len(sites), 4), -1)
    corners[found] = tetrahedra[chosen[found]]
    return Poles(position, corners, np.linalg.norm(position - sites, axis=1))


@kernel
def shrink(
    points: Points,
    normals: Points,
    largest: Reals,
    own: Ints,
    boxes: Points,
    order: Ints,
    radius: Reals,
    touching: Ints,
) -> None:
    """See `shrinking_balls`; ``radius`` (P,) holds the first radii, ``touching`` (P,) -1.

    A ball that shrinks stays in the one before, so one search of the tree is enough."""
    num = len(order)
    for row in range(len(points)):
        v, n, r, hit = point_of(points, row), point_of(normals, row), radius[row], -1
        is_growing = dot(n, n) > 0.5  # points without a normal keep the first radius
        while is_growing:
            node = 1
            while node:
                is_met = is_within((v[0] - r * n[0], v[1] - r * n[1], v[2] - r * n[2]), boxes, node, r * r)
                q = order[node - num] if is_met and node >= num else own[row]
                away = minus(v, point_of(boxes, node))
                length2, depth = dot(away, away), dot(away, n)
                node = onward(node, num, is_met)
                # n . (q - c) / r is the cosine of the angle between v and q at the new centre c.
                is_hit = q != own[row] and 2 * depth * r > length2 > 0
                if is_hit and length2 - 2 * depth * depth < NOISE * length2:
                    r, hit = length2 / (2 * depth), q
            is_growing = hit < 0 and r < largest[row]
            if is_growing:
                r = min(2 * r, largest[row])
        radius[row], touching[row] = r, hit


def shrinking_balls(
    points: np.ndarray, normals: np.ndarray, sites: Tree, first: Radius, largest: Radius, own: np.ndarray | int
) -> tuple[np.ndarray, np.ndarray]:
    """The largest ball behind each of ``points`` (P, 3) with outward unit ``normals``, empty of the ``sites``, of which
    `kernels.tree_of` makes the tree.

    Radii start at ``first``, above 0, and are at most ``largest``: numbers or (P,). ``own`` (P,) is the index of each
    point in the sites, because a point is not its own hit, or -1 if the points are none of them.

    Returns the radii (P,), and the other site (P,) that each ball touches; -1 if it touches none, because it has the
    largest radius, or the point has no normal and its ball the first radius."""
    num, touching = len(points), np.full(len(points), -1)
    largest, own = np.array(np.broadcast_to(largest, num), dtype=float), np.array(np.broadcast_to(own, num))
    radius = np.array(np.broadcast_to(np.minimum(first, largest), num), dtype=float)
    shrink(points, normals, largest, own, *sites, radius, touching)
    return radius, touching


def ball_poles(sites: np.ndarray, faces: np.ndarray, box: np.ndarray | None = None) -> Poles:
    """The centre of the ball at every vertex, in the form of `voronoi_poles`. The circumcentre of its tetrahedron is
    near to it, and moves as it does: of the face at the vertex that is most across the ball's radius, and the vertex
    that the ball touches. A pole outside the bounding box of ``box`` counts as not found."""
    normals, every = unit(vertex_normals(sites, faces)), np.arange(len(sites))
    extent, box = float(np.ptp(sites, axis=0).max()), sites if box is None else box
    radius, touching = shrinking_balls(sites, normals, tree_of(sites, sites), 2 * THIN * extent, extent, every)
    centre = sites - radius[:, None] * normals
    is_found = (touching >= 0) & ((centre >= box.min(axis=0)) & (centre <= box.max(axis=0))).all(axis=1)
    corners = sites[faces]
    across = unit(cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]))
    face = largest_of_each(faces.ravel(), np.einsum("fi,fki->fk", across, normals[faces]).ravel()) // 3
    tetrahedron = np.where(is_found[:, None], np.column_stack([faces[face], touching]), -1)
    return Poles(np.where(is_found[:, None], centre, sites), tetrahedron, np.where(is_found, radius, 0.0))


def scales(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray | None:
    """(V,) the limb's radius at each vertex over `THIN`, at most 1; None if it is 1 nearly everywhere. ``vertices``
    (V, 3) are of diagonal 1, ``faces`` (F, 3) closed and oriented.

    The limb's radius is the maximum of r_u - SLOPE |u - v| over all u, with |u - v| along edges: the largest r, 2 THIN,
    minus a shortest path to v, from an extra node with an edge of length 2 THIN - r_u to each u. The balls at some u
    show a lower bound, with which most solids are not thin."""
    normals, num, most = unit(vertex_normals(vertices, faces)), len(vertices), 2 * THIN
    tree, radius = tree_of(vertices, vertices), np.zeros(num)
    for step in sorted({-(-num // MOST_SAMPLES), 1}, reverse=True):
        some = np.arange(0, num, step)
        radius[some] = shrinking_balls(vertices[some], normals[some], tree, most, most, some)[0]
        if (radius < THIN).mean() > FEW:
            tail, head = faces.ravel(), faces[:, [1, 2, 0]].ravel()
            tail, head = tail[tail < head], head[tail < head]
            length = SLOPE * np.linalg.norm(vertices[tail] - vertices[head], axis=1)
            cost = np.maximum(np.r_[length, most - radius], 1e-12)
            paths = graphs.weighted(num + 1, np.r_[tail, np.full(num, num)], np.r_[head, np.arange(num)], cost)
            radius = most - csgraph.dijkstra(paths, directed=False, indices=num)[:num]
        if (radius < THIN).mean() <= FEW:
            return None
    return np.clip(radius, 100 * RESOLUTION, THIN) / THIN


def edge_lengths(shape: Enclosure, points: np.ndarray, longest: np.ndarray) -> np.ndarray:
    """(P,) the longest edge at each of ``points`` (P, 3), of a solid of diagonal 1, that still resolves the limb.

    Values of at least ``longest`` (P,), the longest edge at each point, are only lower bounds: larger balls and more of
    them would cost most of the time. The balls touch samples of the surface, which are also between its vertices."""
    samples, normals = shape.surface_points(MOST_SAMPLES)
    tree, sites, limit = spatial.KDTree(samples), tree_of(samples, samples), np.zeros(len(points))
    for count in (1, min(NEAREST_SAMPLES, len(samples))):  # the nearest ball is enough at most points
        left = np.flatnonzero(limit < longest)
        away, near = (found.reshape(len(left), count) for found in map(np.asarray, tree.query(points[left], k=count)))
        enough, radius = np.zeros((2, len(samples)))
        np.maximum.at(enough, near, longest[left, None] + SLOPE * away)
        asked = np.flatnonzero(enough)
        radius[asked] = shrinking_balls(samples[asked], normals[asked], sites, 2 * THIN, enough[asked], asked)[0]
        limit[left] = LENGTH * (radius[near] - SLOPE * away).max(axis=1)
    return limit
