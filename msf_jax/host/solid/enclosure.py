"""Is a point inside the surface, and how far is it from it: for poles, radii and the report.

Both questions are answered exactly, by walks down a tree of boxes around the triangles (see `kernels`). The winding
number counts signed crossings of a vertical ray; for a closed mesh it equals the generalised winding number of Jacobson
et al. 2013 everywhere off the surface, also where the mesh crosses itself.
"""

from collections.abc import Iterator
from functools import cached_property

import numpy as np
from scipy import spatial

from msf_jax.host.solid import kernels
from msf_jax.host.solid.geometry import PAIRS_AT_ONCE, barycentric, cross, unit
from msf_jax.host.solid.handles import Handles
from msf_jax.host.solid.kernels import Mesh
from msf_jax.host.solid.triangles import Samples, boxes, middles, reaches, sampled, tree_of

HITS_AT_FIRST = 8  # of a ray, that there is room for; there are more once in a while
ROUNDING = 1e-9  # of the extent, by which the box around a ray is larger than it


class Enclosure:
    """A closed surface prepared for many point queries.

    Args:
        vertices: (V, 3), any unit.
        faces: (F, 3), closed and oriented.
    """

    def __init__(self, vertices: np.ndarray, faces: np.ndarray):
        self.vertices = np.require(vertices, np.float64, ["C", "W"])  # as kernels take them
        self.faces = np.require(faces, np.int64, ["C", "W"])
        self.triangles = self.vertices[self.faces]
        self.centroids = middles(self.triangles)

    @cached_property
    def reaches(self) -> np.ndarray:
        """(F,) how far the corners of each triangle are from its middle, at most."""
        return reaches(self.triangles)

    @cached_property
    def normals(self) -> np.ndarray:
        """(F, 3) outward unit normals; 0 for a triangle without area."""
        a, b, c = self.triangles[:, 0], self.triangles[:, 1], self.triangles[:, 2]
        return unit(cross(b - a, c - a))

    @cached_property
    def mesh(self) -> Mesh:
        """All that kernels ask of the surface."""
        tail, head = self.faces.ravel(), np.roll(self.faces, -1, axis=1).ravel()
        num = len(self.vertices)
        twins = np.empty(len(tail), dtype=np.int64)
        twins[np.argsort(tail * num + head)] = np.argsort(head * num + tail)
        return Mesh(self.vertices, tail, self.triangles, twins, *tree_of(*boxes(self.triangles)))

    @cached_property
    def handles(self) -> Handles:
        """What tells which handles a curve inside goes around."""
        return Handles(self.vertices, self.faces)

    @cached_property
    def _samples(self) -> Samples:
        return sampled(self.vertices, self.faces, self.reaches)

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
        """Unsigned distance (P,) from each point to the surface, and the nearest triangle (P,).

        That is the first, where several are as near.
        """
        return self._nearest(points, is_exact=True)

    def approximate_closest(self, points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Nearly what `nearest` says, in half the time: distance (P,) to a near triangle, and that triangle (P,).

        It is the nearest of those at the nearest sample of the surface. Samples are its vertices and, in triangles that
        reach farther than a fiftieth of the whole, a grid of points. The distance is never too small. For samples s
        apart it is too large by about s^2 / 2d at most, at a distance d of more than s, and by s close to the surface.
        """
        return self._nearest(points, is_exact=False)

    def _nearest(self, points: np.ndarray, is_exact: bool) -> tuple[np.ndarray, np.ndarray]:
        tree, first, fan = self._samples
        distance2, found = np.empty(len(points)), np.empty(len(points), dtype=np.int64)
        sample = tree.query(points)[1]
        kernels.nearest(points, self.mesh, sample, first, fan, is_exact, distance2, found)
        return np.sqrt(distance2), found

    def clearance(self, points: np.ndarray) -> np.ndarray:
        """Radius (P,) of the largest ball around each point inside the surface, 0 for a point outside."""
        return np.where(self.contains(points), self.distances(points), 0.0)

    def approximate_clearance(self, points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """About what `clearance` says, in half the time, and a triangle (P,) near each point."""
        away, near = self.approximate_closest(points)
        return np.where(self.contains(points), away, 0.0), near

    def sample_tree(self) -> spatial.KDTree:
        """A tree of samples of the surface, see `approximate_closest`."""
        return self._samples.tree

    def surface_points(self, most: int) -> tuple[np.ndarray, np.ndarray]:
        """Samples (P, 3) of the surface, ``most`` of them at most, inside triangles, and the unit normals there."""
        tree, first, fan = self._samples
        sample = np.arange(0, len(first) - 1, -(-(len(first) - 1) // most))
        triangle = fan[first[sample]]
        corners = self.triangles[triangle]
        normal = cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        size = np.linalg.norm(normal, axis=1)
        # A corner of a triangle has no normal: a point a little inside it has.
        points = 0.75 * np.asarray(tree.data)[sample] + 0.25 * self.centroids[triangle]
        return points[size > 0], normal[size > 0] / size[size > 0, None]

    def feet(self, points: np.ndarray) -> np.ndarray:
        """A point (P, 3) of the triangle of `approximate_closest`: the foot of the perpendicular, or one on its rim."""
        triangle = self.triangles[self.approximate_closest(points)[1]]
        return np.einsum("pk,pki->pi", barycentric(points, triangle, 0.0), triangle)

    def triangles_near(self, points: np.ndarray, reach: np.ndarray) -> Iterator[tuple[np.ndarray, np.ndarray]]:
        """Batches of (point, triangle) index pairs: all triangles that come within ``reach`` (P,) of each point.

        A few that do not come so near are among them. All pairs of a point are in one batch.
        """
        start, room, ends = 0, PAIRS_AT_ONCE, np.empty(len(points), dtype=np.int64)
        while start < len(points):
            point, triangle = np.empty((2, room), dtype=np.int64)
            stop = kernels.around(points, reach, start, self.mesh, ends, point, triangle)
            if stop > start:
                count = ends[stop - 1]
                yield point[:count], triangle[:count]
            else:
                room *= 2  # that one point has more
            start = stop

    def ray_lengths(self, points: np.ndarray, directions: np.ndarray, reach: np.ndarray) -> np.ndarray:
        """How far (P,) the surface is from each point along its unit vector; ``reach`` (P,) where it is farther."""
        length = reach.astype(float)
        ray, distance = self.ray_hits(points, directions, reach)
        np.minimum.at(length, ray, distance)
        return length

    def ray_hits(self, points: np.ndarray, directions: np.ndarray, reach: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Every hit (H,) of the rays from ``points`` (P, 3) along unit vectors, up to ``reach`` (P,): ray and distance.

        A hit on an edge or a vertex counts for each triangle there, or for some. A ray that starts on the surface may
        hit it at 0 or not at all.
        """
        # Two axes across each ray: seen along it, the ray is a point.
        across = cross(directions, np.eye(3)[np.abs(directions).argmin(axis=1)])
        across /= np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-300)
        axes = np.stack([across, cross(directions, across), directions], axis=1)
        slack = ROUNDING * float(np.ptp(self.mesh.boxes[1].reshape(2, 3), axis=0).max())
        room = HITS_AT_FIRST * len(points)
        while True:
            ray, distance = np.empty(room, dtype=np.int64), np.empty(room)
            count = kernels.hits(points, axes, reach, slack, self.mesh, np.empty((3, 3)), ray, distance)
            if count <= room:
                return ray[:count], distance[:count]
            room = count
