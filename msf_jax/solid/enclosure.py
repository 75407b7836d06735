"""Whether a point is inside a surface, and its distance from it: for poles, radii and the report.

Both are exact, by a search in a tree of the triangles' bounding boxes (see `kernels`). The winding number counts signed
crossings of a vertical ray. For a closed mesh it equals the generalised winding number of Jacobson et al. 2013
everywhere off the surface, also where the mesh crosses itself.
"""

from functools import cached_property, reduce
from typing import NamedTuple

import numpy as np
from scipy import spatial

from msf_jax.solid import kernels
from msf_jax.solid.geometry import ROUNDING, axes_across, cross, distinct, unit
from msf_jax.solid.handles import Handles
from msf_jax.solid.kernels import Mesh, tree_of
from msf_jax.topology.graphs import HalfEdges, half_edges

MOST_TESTED = 200  # tests of a side against a triangle, for each triangle, to find those that cross; fans need more
SAMPLE_SPACING = 0.02  # extents between samples of a triangle, or more, for `MOST_SAMPLES`
MOST_SAMPLES = 200_000  # approximate limit on the samples of a surface, for memory


class Samples(NamedTuple):
    """Samples of the surface: a tree of them, and a triangle (S,) at each."""

    tree: spatial.KDTree
    triangle: np.ndarray


class Crossed(NamedTuple):
    """Pairs (P, 2) of triangles that cross, and whether the search was cut short."""

    pairs: np.ndarray
    is_cut: bool


class Enclosure:
    """A closed, oriented surface, ``vertices`` (V, 3) in any unit and ``faces`` (F, 3), prepared for many queries."""

    def __init__(self, vertices: np.ndarray, faces: np.ndarray):
        self.vertices = np.require(vertices, np.float64, ["C", "W"])  # the kernels' type
        self.faces = np.require(faces, np.int64, ["C", "W"])
        self.triangles = self.vertices[self.faces]
        self.centroids = (self.triangles[:, 0] + self.triangles[:, 1] + self.triangles[:, 2]) / 3

    def prepare(self) -> None:
        """Make now, beside other work, what takes long: the trees."""
        _ = self.mesh, self.samples

    @cached_property
    def reaches(self) -> np.ndarray:
        """(F,) the largest distance from the middle of each triangle to one of its corners."""
        away = [(self.triangles[:, k] - self.centroids).T for k in range(3)]
        return np.sqrt(reduce(np.maximum, [x**2 + y**2 + z**2 for x, y, z in away]))

    @cached_property
    def normals(self) -> np.ndarray:
        """(F, 3) outward unit normals; 0 for a triangle without area."""
        a, b, c = self.triangles[:, 0], self.triangles[:, 1], self.triangles[:, 2]
        return unit(cross(b - a, c - a))

    @cached_property
    def edges(self) -> HalfEdges:
        """The half-edges of the faces."""
        return half_edges(self.faces)

    @cached_property
    def mesh(self) -> Mesh:
        """The surface as the kernels take it."""
        corners = np.moveaxis(self.triangles, 1, 0)  # NumPy is slow over axes of length 3
        boxes = (reduce(choice, corners) for choice in (np.minimum, np.maximum))
        return Mesh(self.vertices, self.edges.origin, self.triangles, self.edges.twin, *tree_of(*boxes))

    @cached_property
    def extent(self) -> float:
        """The longest side of the bounding box."""
        return float(np.ptp(self.vertices, axis=0).max())

    @cached_property
    def handles(self) -> Handles:
        """The handles of the solid, to find those that a curve inside goes around."""
        return Handles(self.vertices, self.faces)

    @cached_property
    def samples(self) -> Samples:
        """Every used vertex, and a grid of points in every large triangle."""
        reaches, (used, corner) = self.reaches, np.unique(self.faces, return_index=True)
        spacing = max(SAMPLE_SPACING * self.extent, float(np.sqrt((reaches**2).sum() / MOST_SAMPLES)))
        points, owners = [self.vertices[used]], [corner // 3]
        parts = np.ceil(reaches / spacing).astype(np.int64)
        for number in np.unique(parts[parts > 1]):
            i, j = (part.ravel() for part in np.indices((number + 1, number + 1)))
            i, j = i[i + j <= number], j[i + j <= number]
            weights = (np.stack([i, j, number - i - j], axis=1) + 1 / 3) / (number + 1)
            large = np.flatnonzero(parts == number)
            points.append(np.einsum("sk,fki->fsi", weights, self.triangles[large]).reshape(-1, 3))
            owners.append(np.repeat(large, len(weights)))
        # Boxes that are split in the middle, and not shrunk, are built faster and are several times as fast for points
        # on the axis of a cone, as far from many samples.
        tree = spatial.KDTree(np.concatenate(points), leafsize=32, balanced_tree=False, compact_nodes=False)
        return Samples(tree, np.concatenate(owners))

    @cached_property
    def sites(self) -> tuple[np.ndarray, np.ndarray]:
        """The tree of the samples, see `kernels.tree_of`."""
        points = np.asarray(self.samples.tree.data)
        return tree_of(points, points)

    @cached_property
    def crossed(self) -> Crossed:
        """Where the surface crosses itself: a side of a triangle passes through another, and both have corners on
        both sides of the other's plane. Triangles with a corner in common do not count."""
        tail, head, twin = self.edges
        half = np.flatnonzero(np.arange(len(twin)) < twin)
        a, b = self.vertices[tail[half]], self.vertices[head[half]]
        length = np.linalg.norm(b - a, axis=1)
        along = (b - a) / np.maximum(length, 1e-300)[:, None]
        start, reach = a + ROUNDING * (b - a), (1 - 2 * ROUNDING) * length  # not at a corner, where a fan is met
        ray, face, _, is_cut = self.ray_hits(start, along, reach, MOST_TESTED * len(self.faces))
        half = half[ray]
        sides = np.concatenate([half, twin[half]])
        pairs = np.stack([sides // 3, np.tile(face, 2)], axis=1)
        ends = np.stack([tail[sides], head[sides]], axis=1)
        is_through = np.ones(len(pairs), dtype=bool)
        for corner, over in ((ends, pairs[:, 1]), (self.faces[pairs[:, 1]], pairs[:, 0])):
            off = self.vertices[corner] - self.centroids[over][:, None]
            height = np.einsum("pki,pi->pk", off, self.normals[over]) / (ROUNDING * self.extent)  # within 1, they touch
            is_through &= (height.min(axis=1) < -1) & (height.max(axis=1) > 1)
        pairs = np.sort(pairs[is_through], axis=1)
        pairs = np.stack(np.divmod(distinct(pairs[:, 0] * len(self.faces) + pairs[:, 1]), len(self.faces)), axis=1)
        if len(pairs):
            place = np.unique(self.vertices, axis=0, return_inverse=True)[1].ravel()
            one, other = place[self.faces[pairs.T]]
            pairs = pairs[(one[:, :, None] != other[:, None]).all(axis=(1, 2))]
        return Crossed(pairs, is_cut)

    def winding_numbers(self, points: np.ndarray) -> np.ndarray:
        """Winding number (P,) of the surface around each point: 1 inside, 0 outside an embedded surface."""
        winding = np.empty(len(points), dtype=np.int64)
        kernels.windings(points, self.mesh, winding)
        return winding

    def contains(self, points: np.ndarray) -> np.ndarray:
        """(P,) True where the surface winds around the point at least once."""
        return self.winding_numbers(points) > 0

    def distances(self, points: np.ndarray) -> np.ndarray:
        """Unsigned distance (P,) from each point to the surface."""
        return self.nearest(points)[0]

    def nearest(self, points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Unsigned distance (P,) from each point to the surface, and the first of the nearest triangles (P,)."""
        tree, triangle = self.samples
        distance2, found = np.empty(len(points)), np.empty(len(points), dtype=np.int64)
        kernels.nearest(points, self.mesh, triangle[tree.query(points)[1]], distance2, found)
        return np.sqrt(distance2), found

    def clearance(self, points: np.ndarray) -> np.ndarray:
        """Radius (P,) of the largest ball around each point inside the surface, 0 for a point outside."""
        return np.where(self.contains(points), self.distances(points), 0.0)

    def surface_points(self, most: int) -> tuple[np.ndarray, np.ndarray]:
        """At most ``most`` samples (P, 3) of the surface inside its triangles, and the unit normals there."""
        tree, triangle = self.samples
        sample = np.arange(0, len(triangle), -(-len(triangle) // most))
        triangle = triangle[sample]
        normal = self.normals[triangle]
        has_area = normal.any(axis=1)
        # A vertex has no normal of its own, so each sample is moved towards the middle of its triangle.
        points = 0.75 * np.asarray(tree.data)[sample] + 0.25 * self.centroids[triangle]
        return points[has_area], normal[has_area]

    def ray_lengths(self, points: np.ndarray, directions: np.ndarray, reach: np.ndarray) -> np.ndarray:
        """Distance (P,) to the surface from each point along its unit vector, at most ``reach`` (P,)."""
        length = reach.astype(float)
        ray, _, distance, _ = self.ray_hits(points, directions, reach)
        np.minimum.at(length, ray, distance)
        return length

    def ray_hits(
        self, points: np.ndarray, directions: np.ndarray, reach: np.ndarray, most: int = -1
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray, bool]:
        """Every hit (H,) of the rays from ``points`` (P, 3) along unit vectors, up to ``reach`` (P,): ray, triangle and
        distance; and whether the search ended after ``most`` tests of a ray and a triangle, if that is positive.

        A hit on an edge or a vertex may count for one or several of the triangles there. A ray that starts on the
        surface may hit it at 0 or not at all."""
        axes = np.concatenate([axes_across(directions), directions[:, None]], axis=1)  # along it, a ray is a point
        slack = ROUNDING * float(np.ptp(self.mesh.boxes[1].reshape(2, 3), axis=0).max())
        capacity = len(points) + len(self.faces)  # there are seldom more hits
        while True:
            left, (ray, face), distance = np.array([most]), np.empty((2, capacity), dtype=np.int64), np.empty(capacity)
            count = kernels.hits(points, axes, reach, slack, self.mesh, left, ray, face, distance)
            if count <= capacity:
                return ray[:count], face[:count], distance[:count], left[0] == 0
            capacity = count

    def holds(
        self,
        a: np.ndarray,
        b: np.ndarray,
        covered: np.ndarray | float = 0.0,
        sliver: float = ROUNDING,
        are_inside: bool = False,
    ) -> np.ndarray:
        """(E,) whether the segments from a (E, 3) to b (E, 3) are inside, up to stretches shorter than ``sliver``
        between hits of the surface. A segment shorter than ``covered`` (E,), the sum of the radii of balls around its
        ends, is inside without a test. ``are_inside``: all ends are known to be.

        At a hit the segment leaves the solid or crosses a fold inside: the middles of the stretches between hits
        decide. A ray along a face, or from the surface, may miss its exit, so both ends are tested, too."""
        along = b - a
        length = np.linalg.norm(along, axis=1)
        is_in = length < covered
        rows = np.flatnonzero(~is_in)
        for ends in () if are_inside else (a, b):
            rows = rows[self.contains(ends[rows])]
        is_in[rows] = True
        a, length = a[rows], length[rows]
        along = along[rows] / np.maximum(length, 1e-300)[:, None]
        ray, _, stop, _ = self.ray_hits(a, along, length)
        if not len(ray):
            return is_in
        hit = np.unique(ray)
        ray, stop = np.concatenate([hit, ray, hit]), np.concatenate([np.zeros(len(hit)), stop, length[hit]])
        order = np.lexsort((stop, ray))
        ray, stop = ray[order], stop[order]
        here = np.flatnonzero((np.diff(ray) == 0) & (np.diff(stop) > sliver))
        half = (stop[here] + stop[here + 1]) / 2
        middle = a[ray[here]] + half[:, None] * along[ray[here]]
        is_in[rows[ray[here[~self.contains(middle)]]]] = False
        return is_in
