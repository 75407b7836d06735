"""Is a point inside the surface, and how far is it from it: for poles, radii and the report.

Both questions are answered exactly, in vectorised NumPy. The winding number counts signed crossings of a vertical ray;
for a closed mesh it equals the generalised winding number of Jacobson et al. 2013 everywhere off the surface, also
where the mesh crosses itself. The distance is that to the nearest point of the nearest triangle (Ericson 2005, 5.1.5).
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from scipy import spatial

from msf_jax.host.solid import triangles as batches
from msf_jax.host.solid.geometry import barycentric, cross, repeated
from msf_jax.host.solid.handles import Handles
from msf_jax.host.solid.triangles import (
    SizeClass,
    boxes,
    middles,
    near,
    pieces,
    point_triangle_distance2,
    reaches,
    size_classes,
)

SAMPLE_SPACING = 0.02  # of the extent, in `approach`; more where that would make more than so many samples:
MOST_SAMPLES = 200_000
LARGEST_PIECE = 0.02  # of the extent, of a face or an edge, in `nearest`; larger where that would make about
MOST_PIECES = 200_000
ROUNDING = 1e-9  # of the extent, by which the box around a ray is larger than it


class Feet(NamedTuple):
    """Points f of the surface, ``centre[f]``, such that a perpendicular on it ends within ``reach[f]`` of one of them,
    in a triangle of ``fan[first[f] : first[f + 1]]``: vertices, and pieces of large faces and their edges."""

    centre: np.ndarray
    reach: np.ndarray
    first: np.ndarray
    fan: np.ndarray
    classes: list[SizeClass]


class Samples(NamedTuple):
    """Points of the surface: a tree of them, and the triangles at sample s, ``fan[first[s] : first[s + 1]]``."""

    tree: spatial.KDTree
    first: np.ndarray
    fan: np.ndarray


class Links(NamedTuple):
    """For the directed edge 3 f + k, from corner k of face f to the next, (3 F,) each: the corner opposite, the edge on
    its other side, and those on the other side of the next one in f and of the last one."""

    apex: np.ndarray
    twin: np.ndarray
    twin_of_next: np.ndarray
    twin_of_last: np.ndarray


class Enclosure:
    """A closed surface prepared for many point queries.

    Args:
        vertices: (V, 3), any unit.
        faces: (F, 3), closed and oriented.
    """

    def __init__(self, vertices: np.ndarray, faces: np.ndarray):
        self.triangles = vertices[faces]
        self.faces = faces
        self.vertices = vertices
        self.centroids = middles(self.triangles)
        self.reaches = reaches(self.triangles)
        low, high = boxes(self.triangles)
        self.low, self.high = low.T.copy(), high.T.copy()
        self._rounding = ROUNDING * float((high.max(axis=0) - low.min(axis=0)).max())
        self._grid: _Grid | None = None
        self._classes: list[SizeClass] | None = None
        self._feet: Feet | None = None
        self._samples: Samples | None = None
        self._links: Links | None = None
        self._handles: Handles | None = None

    def winding_numbers(self, points: np.ndarray) -> np.ndarray:
        """Winding number (P,) of the surface around each point: 1 inside, 0 outside an embedded surface."""
        if self._grid is None:
            self._grid = _Grid(self.triangles)
        winding = np.zeros(len(points), dtype=np.int64)
        for point, triangle in self._grid.pairs(points):
            for axis, bound, passes in self._grid.bounds:  # most pairs fail one of these, which are cheap
                is_left = passes(points[point, axis], bound[triangle])
                point, triangle = point[is_left], triangle[is_left]
            winding += np.bincount(
                point, weights=self._crossings(points[point], self.faces[triangle]), minlength=len(points)
            ).astype(np.int64)
        return winding

    def contains(self, points: np.ndarray) -> np.ndarray:
        """(P,) True where the surface winds around the point at least once."""
        return self.winding_numbers(points) > 0

    def _crossings(self, point: np.ndarray, face: np.ndarray) -> np.ndarray:
        """+1, -1 or 0 (c,): how the upward ray from each point crosses each face.

        Seen from above the ray is a point. It is in the triangle if it is on the same side of all three edges. The side
        is computed with an edge's ends in order of index, so that both faces at the edge agree; a point on the line is
        taken as shifted by (e, e^2) for a vanishing e, so that a ray through a vertex or along a wall is no exception.
        """
        side = np.empty((len(face), 3))
        is_left = np.empty((len(face), 3), dtype=bool)
        for k in range(3):
            start, end = face[:, k], face[:, (k + 1) % 3]
            low, high = self.vertices[np.minimum(start, end)], self.vertices[np.maximum(start, end)]
            dx, dy = high[:, 0] - low[:, 0], high[:, 1] - low[:, 1]
            value = dx * (point[:, 1] - low[:, 1]) - dy * (point[:, 0] - low[:, 0])
            is_positive = (value > 0) | ((value == 0) & ((dy < 0) | ((dy == 0) & (dx > 0))))
            is_left[:, k] = is_positive == (start < end)
            side[:, k] = np.where(start < end, value, -value)
        # Height at which the ray meets the plane, by barycentric weights: edge k is opposite corner k + 2.
        corner_height = self.vertices[face][:, :, 2]
        total = side.sum(axis=1)
        height = np.einsum("ck,ck->c", side[:, [1, 2, 0]], corner_height) / np.where(total == 0, 1.0, total)
        is_above = np.clip(height, corner_height.min(axis=1), corner_height.max(axis=1)) > point[:, 2]
        return np.where(is_above, is_left.all(axis=1).astype(float) - ~is_left.any(axis=1), 0.0)

    def distances(self, points: np.ndarray) -> np.ndarray:
        """Unsigned distance (P,) from each point to the surface."""
        return self.nearest(points)[0]

    def nearest(self, points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Unsigned distance (P,) from each point to the surface, and the nearest triangle (P,).

        `approach` bounds it. The foot of the perpendicular on the nearest triangle is inside a face or inside an edge,
        or it is a vertex, which `approach` sees. From a point of that face or edge, a reach from the foot, the point
        then is no farther than sqrt(bound^2 + reach^2), by Pythagoras: few are. They are searched in classes of like
        reach, so that a few large ones do not widen the search for all.
        """
        centre, reach, first, fan, classes = self._all_feet()
        bound, chosen = self.approach(points)
        best2 = bound**2
        for size_class in classes:
            for point, foot in near([size_class], points, lambda most, bound=bound: np.hypot(bound, most)):
                away = points[point] - centre[foot]
                may_be = np.einsum("ci,ci->c", away, away) <= (bound[point] ** 2 + reach[foot] ** 2) * (1 + 1e-12)
                point, foot = point[may_be], foot[may_be]
                count = first[foot + 1] - first[foot]
                batch = np.cumsum(count) // batches.PAIRS_AT_ONCE
                for number in np.unique(batch):
                    rows = batch == number
                    self._look(points, *_fans(point[rows], first[foot[rows]], count[rows], fan), best2, chosen)
            bound = np.sqrt(best2)
        return np.sqrt(best2), chosen

    def _look(
        self, points: np.ndarray, point: np.ndarray, triangle: np.ndarray, best2: np.ndarray, chosen: np.ndarray
    ) -> None:
        """Look if each triangle is nearer than the ``chosen`` (P,), at a squared distance of ``best2`` (P,).

        The pairs come point by point.
        """
        may_be = self._box_distance2(points[point], triangle) <= best2[point] * (1 + 1e-12)
        point, triangle = point[may_be], triangle[may_be]
        if not len(point):
            return
        distance2 = point_triangle_distance2(points[point], self.triangles[triangle])
        start = np.flatnonzero(np.r_[True, point[1:] != point[:-1]])
        least = np.minimum.reduceat(distance2, start)
        row = point[start]
        is_nearer = least < best2[row]
        is_least = distance2 == np.repeat(np.where(is_nearer, least, -1.0), np.diff(np.r_[start, len(point)]))
        chosen[point[is_least][::-1]] = triangle[is_least][::-1]
        best2[row] = np.minimum(best2[row], least)

    def _box_distance2(self, point: np.ndarray, triangle: np.ndarray) -> np.ndarray:
        """Squared distance (c,) from each point (c, 3) to the box around each triangle (c,): cheap, and never more than
        that to the triangle."""
        total = np.zeros(len(point))
        for axis in range(3):
            away = np.maximum(self.low[axis][triangle] - point[:, axis], point[:, axis] - self.high[axis][triangle])
            total += np.maximum(away, 0.0) ** 2
        return total

    def _all_feet(self) -> Feet:
        if self._feet is None:
            size = float(np.ptp(self.vertices, axis=0).max())
            largest = max(LARGEST_PIECE * size, float(np.sqrt((self.reaches**2).sum() / MOST_PIECES)))
            # No point of a face or an edge is farther than the face's reach from all of its corners.
            is_large = self.reaches > largest
            of_vertex = np.zeros(len(self.vertices))
            np.maximum.at(of_vertex, self.faces[~is_large].ravel(), np.repeat(self.reaches[~is_large], 3))
            vertex = np.flatnonzero(of_vertex)
            _, first, fan = self._all_samples()
            count = first[vertex + 1] - first[vertex]
            fans = _fans(vertex, first[vertex], count, fan)[1]
            # A large one is cut up.
            rows = np.flatnonzero(is_large)
            corners = self.triangles[rows]
            faces, of_face = pieces(corners, largest)
            sides = np.stack([corners, np.roll(corners, -1, axis=1)], axis=2).reshape(-1, 2, 3)
            edges, of_edge = pieces(sides, largest)
            centre = np.concatenate([self.vertices[vertex], middles(faces), middles(edges)])
            reach = np.concatenate([of_vertex[vertex], reaches(faces), reaches(edges)])
            fan = np.concatenate([fans, rows[of_face], rows[of_edge // 3]])
            first = np.concatenate([[0], np.cumsum(count), len(fans) + 1 + np.arange(len(fan) - len(fans))])
            self._feet = Feet(centre, reach, first, fan, size_classes(centre, reach))
        return self._feet

    def clearance(self, points: np.ndarray) -> np.ndarray:
        """Radius (P,) of the largest ball around each point inside the surface, 0 for a point outside."""
        return np.where(self.contains(points), self.distances(points), 0.0)

    def about_clearance(self, points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """About what `clearance` says, many times as fast, and a triangle (P,) near each point."""
        away, near = self.approach(points)
        return np.where(self.contains(points), away, 0.0), near

    def approach(self, points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Nearly what `nearest` says, many times as fast: distance (P,) to a near triangle, and that triangle (P,).

        It is the nearest of those at the nearest sample of the surface. Samples are its vertices and, in triangles that
        reach farther than a fiftieth of the whole, a grid of points. The distance is never too small. For samples s
        apart it is too large by about s^2 / 2d at most, at a distance d of more than s, and by s close to the surface.
        """
        tree, first, fan = self._all_samples()
        sample = tree.query(points)[1]
        count = first[sample + 1] - first[sample]
        if count.sum() > batches.PAIRS_AT_ONCE and len(points) > 1:  # a hub of thousands of faces
            halves = [self.approach(half) for half in np.array_split(points, 2)]
            return np.concatenate([half[0] for half in halves]), np.concatenate([half[1] for half in halves])
        point, triangle = _fans(np.arange(len(points)), first[sample], count, fan)
        distance2 = point_triangle_distance2(points[point], self.triangles[triangle])
        least = np.minimum.reduceat(distance2, np.cumsum(count) - count) if len(points) else np.empty(0)
        chosen = np.flatnonzero(distance2 == np.repeat(least, count))[::-1]
        found = np.empty(len(points), dtype=np.int64)
        found[point[chosen]] = triangle[chosen]
        return np.sqrt(least), found

    def _all_samples(self) -> Samples:
        if self._samples is None:
            self._samples = _sampled(self.vertices, self.faces, self.reaches)
        return self._samples

    def sample_tree(self) -> spatial.KDTree:
        """A tree of samples of the surface, see `approach`."""
        return self._all_samples().tree

    def surface_points(self, most: int) -> tuple[np.ndarray, np.ndarray]:
        """Samples (P, 3) of the surface, ``most`` of them at most, inside triangles, and the unit normals there."""
        tree, first, fan = self._all_samples()
        sample = np.arange(0, len(first) - 1, -(-(len(first) - 1) // most))
        sample = sample[first[sample + 1] > first[sample]]  # a vertex of no face
        triangle = fan[first[sample]]
        corners = self.triangles[triangle]
        normal = cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        size = np.linalg.norm(normal, axis=1)
        # A corner of a triangle has no normal: a point a little inside it has.
        points = 0.75 * np.asarray(tree.data)[sample] + 0.25 * self.centroids[triangle]
        return points[size > 0], normal[size > 0] / size[size > 0, None]

    def feet(self, points: np.ndarray) -> np.ndarray:
        """A point (P, 3) of the near triangle of `approach`: the foot of the perpendicular, or one on its rim."""
        triangle = self.triangles[self.approach(points)[1]]
        return np.einsum("pk,pki->pi", barycentric(points, triangle, 0.0), triangle)

    def triangles_near(self, points: np.ndarray, reach: np.ndarray) -> Iterator[tuple[np.ndarray, np.ndarray]]:
        """Batches of (point, triangle) index pairs: all triangles that come within ``reach`` (P,) of each point.

        A few that do not come so near are among them. All pairs of a point are in one batch.
        """
        if self._classes is None:
            self._classes = size_classes(self.centroids, self.reaches)
        return near(self._classes, points, lambda most: reach + most)

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
        rays, distances = [np.empty(0, dtype=np.int64)], [np.empty(0)]
        ends = points, points + reach[:, None] * directions
        low, high = np.minimum(*ends).T - self._rounding, np.maximum(*ends).T + self._rounding
        for point, triangle in self.triangles_near(points + reach[:, None] / 2 * directions, reach / 2):
            for axis in range(3):  # most pairs have boxes that are apart
                may_be = self.low[axis][triangle] <= high[axis][point]
                may_be &= self.high[axis][triangle] >= low[axis][point]
                point, triangle = point[may_be], triangle[may_be]
            corners = np.einsum("cki,cai->cka", self.triangles[triangle] - points[point][:, None], axes[point])
            x, y, depth = np.moveaxis(corners, 2, 0)
            side = x * np.roll(y, -1, axis=1) - np.roll(x, -1, axis=1) * y  # of edge k to k + 1; k + 2 is opposite
            total = side.sum(axis=1)
            # Seen edge-on a triangle has no area but rounding errors, and is no hit.
            is_broad = np.abs(total) > 1e-14 * (x**2 + y**2).max(axis=1)
            is_hit = ((side >= 0).all(axis=1) | (side <= 0).all(axis=1)) & is_broad
            t = np.einsum("ck,ck->c", side, np.roll(depth, 1, axis=1)) / np.where(is_hit, total, 1.0)
            t = np.clip(t, depth.min(axis=1), depth.max(axis=1))
            is_hit &= (t >= 0) & (t <= reach[point])
            rays.append(point[is_hit])
            distances.append(t[is_hit])
        return np.concatenate(rays), np.concatenate(distances)

    def handles(self) -> Handles:
        """What tells which handles a curve inside goes around."""
        if self._handles is None:
            self._handles = Handles(self.vertices, self.faces)
        return self._handles

    def links(self) -> "Links":
        """How the directed edges of the faces hang together."""
        if self._links is None:
            tail, head = self.faces.ravel(), np.roll(self.faces, -1, axis=1).ravel()
            num = len(self.vertices)
            there, back = np.argsort(tail * num + head), np.argsort(head * num + tail)
            twin = np.empty(len(tail), dtype=np.int64)
            twin[there] = back
            twins = twin.reshape(-1, 3)
            tables = ((self.faces, 1), (twins, 0), (twins, -1), (twins, 1))
            self._links = Links(*(np.roll(table, by, axis=1).ravel() for table, by in tables))
        return self._links


def _fans(point: np.ndarray, first: np.ndarray, count: np.ndarray, fan: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Each of ``point`` (c,) beside every member of its stretch ``fan[first : first + count]``."""
    row, place = repeated(count)
    return point[row], fan[first[row] + place]


def _sampled(vertices: np.ndarray, faces: np.ndarray, reaches: np.ndarray) -> Samples:
    """Every vertex with its fan of triangles, and a grid of points in every triangle that is large, with that one."""
    spacing = max(
        SAMPLE_SPACING * float(np.ptp(vertices, axis=0).max()), float(np.sqrt((reaches**2).sum() / MOST_SAMPLES))
    )
    points, owners = [vertices], []
    parts = np.ceil(reaches / spacing).astype(np.int64)
    for number in np.unique(parts[parts > 1]):
        i, j = (part.ravel() for part in np.indices((number + 1, number + 1)))
        i, j = i[i + j <= number], j[i + j <= number]
        weights = (np.stack([i, j, number - i - j], axis=1) + 1 / 3) / (number + 1)
        large = np.flatnonzero(parts == number)
        points.append(np.einsum("sk,fki->fsi", weights, vertices[faces[large]]).reshape(-1, 3))
        owners.append(np.repeat(large, len(weights)))
    corner = faces.ravel()
    fan = np.concatenate([np.argsort(corner, kind="stable") // 3, *owners])
    count = np.bincount(corner, minlength=len(vertices))
    first = np.concatenate([[0], np.cumsum(count), len(corner) + 1 + np.arange(len(fan) - len(corner))])
    return Samples(spatial.KDTree(np.concatenate(points), leafsize=32), first, fan)


class _Grid:
    """Triangles binned by the cells of a horizontal grid that their bounding rectangles touch."""

    def __init__(self, triangles: np.ndarray):
        lows, highs = boxes(triangles)
        low, high = lows.T, highs.T
        # What a ray that meets a triangle passes: below its top, and within its rectangle.
        self.bounds = [
            (2, high[2].copy(), np.less),
            *((axis, low[axis].copy(), np.greater_equal) for axis in (0, 1)),
            *((axis, high[axis].copy(), np.less_equal) for axis in (0, 1)),
        ]
        self.low = lows[:, :2].min(axis=0)
        extent = np.maximum(highs[:, :2].max(axis=0) - self.low, 1e-300)
        size = np.median((highs - lows)[:, :2].max(axis=1))
        size = max(float(size), float(extent.max()) / 2048, 1e-300)
        self.shape = np.maximum(1, np.ceil(extent / size)).astype(np.int64)
        self.size = size
        first = self._cell(lows[:, :2])
        span = self._cell(highs[:, :2]) - first + 1
        count = span[:, 0] * span[:, 1]
        triangle = np.repeat(np.arange(len(triangles)), count)
        step = np.arange(len(triangle)) - np.repeat(np.cumsum(count) - count, count)
        row, column = first[triangle, 0] + step // span[triangle, 1], first[triangle, 1] + step % span[triangle, 1]
        code = row * self.shape[1] + column
        order = np.argsort(code, kind="stable")
        self.triangle = triangle[order]
        self.start = np.searchsorted(code[order], np.arange(self.shape[0] * self.shape[1] + 1))

    def _cell(self, flat: np.ndarray) -> np.ndarray:
        return np.clip(((flat - self.low) / self.size).astype(np.int64), 0, self.shape - 1)

    def pairs(self, points: np.ndarray) -> Iterator[tuple[np.ndarray, np.ndarray]]:
        """Batches of (point, triangle) index pairs that share a cell; a point outside the grid is in no pair."""
        cell = self._cell(points[:, :2])
        is_on_grid = ((points[:, :2] >= self.low) & (points[:, :2] <= self.low + self.shape * self.size)).all(axis=1)
        code = cell[:, 0] * self.shape[1] + cell[:, 1]
        count = np.where(is_on_grid, self.start[code + 1] - self.start[code], 0)
        batch = np.cumsum(count) // batches.PAIRS_AT_ONCE
        for number in np.unique(batch):
            chosen = np.flatnonzero((batch == number) & (count > 0))
            num = count[chosen]
            point = np.repeat(chosen, num)
            step = np.arange(len(point)) - np.repeat(np.cumsum(num) - num, num)
            yield point, self.triangle[self.start[code[point]] + step]
