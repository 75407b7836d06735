"""How the level sets of a function on a closed surface are connected: its Reeb graph, at the resolution of a step.

Levels, one step apart, cut the surface into pieces, and two pieces meet at a ring. If the function grows along a limb,
a ring is a cross-section of the limb, and the middles of successive rings are its curve (Lazarus, Verroust 1999, level
set diagrams). The graph has a cycle for each handle that is larger than the step, and no other cycles.

The levels cut an edge into stretches. Stretches of a face between the same two levels belong to one piece, and points
of a face on the same level belong to one ring.
"""

from typing import NamedTuple

import numpy as np

from msf_jax.numerics.compiled import Ints, Points, Reals, Rows, kernel, part
from msf_jax.solid.geometry import ROUNDING, cross, unit
from msf_jax.solid.kernels import norm

MOST_POINTS = 1_000_000  # intersections of levels and edges: if there are more, the step is doubled


class Levels(NamedTuple):
    """Rings between pieces of the surface.

    centre: (R, 3) centroid of the area inside a ring. normal: (R, 3) its unit normal, to where the function grows if
    the ring goes around the solid. perimeter: (R,) of a ring. size: (R,) twice its area over its perimeter, the radius
    of a disc. below, above: (R,) the pieces that meet there. level: (R,) the number of steps. height: (R,) the function
    there. piece: (V,) the piece of each vertex. contents: (P, 5) of each piece, also of those without a vertex, its
    area, its area vector, and the sum of x . n over it. step: between levels."""

    centre: np.ndarray
    normal: np.ndarray
    perimeter: np.ndarray
    size: np.ndarray
    below: np.ndarray
    above: np.ndarray
    level: np.ndarray
    height: np.ndarray
    piece: np.ndarray
    contents: np.ndarray
    step: float


class Cuts(NamedTuple):
    """Edges of a surface that levels cut. faces: (F, 3). of_face: (F, 3) the edge from each corner to the next. ends:
    (E, 2) the lower end of an edge, and the upper one. low, high: (E,) the levels below its ends. point, stretch: (E,)
    the number of its first point, and of its first stretch, from the lower end up. Stretches follow the vertices."""

    faces: Rows
    of_face: Rows
    ends: Rows
    low: Ints
    high: Ints
    point: Ints
    stretch: Ints


@part
def first_of(root: Ints, member: int) -> int:
    """The member that stands for the set of ``member``; ``root`` leads there."""
    while root[member] != member:
        root[member] = root[root[member]]
        member = root[member]
    return member


@part
def join(root: Ints, one: int, other: int) -> None:
    """Make one of the sets of two members; the first member of both stands for it."""
    one, other = first_of(root, one), first_of(root, other)
    root[max(one, other)] = min(one, other)


@part
def number(root: Ints) -> int:
    """Replace each member's ``root`` by the number of its set, in the order of first members; returns their count."""
    count = 0
    for member in range(len(root)):
        if root[member] == member:
            root[member] = count
            count += 1
        else:
            root[member] = root[root[member]]  # a number already: the first member comes first
    return count


@kernel
def connect(cuts: Cuts, piece: Ints, ring: Ints, segments: Rows) -> int:
    """Number the pieces of vertices and stretches, ``piece``, and the rings of points, ``ring``; both hold the numbers
    0, 1, ... before. ``segments`` (S, 2): the points at the ends of the rings' segments, which have their upper side on
    the left, seen from outside. Returns the number of pieces."""
    for edge in range(len(cuts.ends)):
        join(piece, cuts.ends[edge, 0], cuts.stretch[edge])
        join(piece, cuts.ends[edge, 1], cuts.stretch[edge] + cuts.high[edge] - cuts.low[edge])
    row = 0
    for k in range(3):
        for face in range(len(cuts.of_face)):
            one, other = cuts.of_face[face, k], cuts.of_face[face, (k + 1) % 3]
            bottom, top = max(cuts.low[one], cuts.low[other]), min(cuts.high[one], cuts.high[other])
            for level in range(bottom, top + 1):
                join(piece, cuts.stretch[one] + level - cuts.low[one], cuts.stretch[other] + level - cuts.low[other])
            is_up = cuts.ends[one, 1] == cuts.faces[face, (k + 1) % 3]
            for level in range(bottom, top):
                a, b = cuts.point[one] + level - cuts.low[one], cuts.point[other] + level - cuts.low[other]
                join(ring, a, b)
                segments[row, 0], segments[row, 1] = (b, a) if is_up else (a, b)
                row += 1
    number(ring)
    return number(piece)


@kernel
def measure_rings(points: Points, segments: Rows, ring: Ints, sums: Points) -> None:
    """Sums over the ``segments`` of each ring, in columns of ``sums`` (R, 14), which are 0 before: the length; the
    middle; the area of the triangles between the segments and the middle; their area times their middles; twice their
    area vector; and one of its points."""
    for row in range(len(segments)):
        a, b, own = points[segments[row, 0]], points[segments[row, 1]], sums[ring[segments[row, 0]]]
        length = norm((b[0] - a[0], b[1] - a[1], b[2] - a[2]))
        own[0] += length
        for i in range(3):
            own[1 + i] += length * ((a[i] + b[i]) / 2)
            own[11 + i] = a[i]
    for row in range(len(sums)):
        for i in range(3):
            sums[row, 1 + i] /= max(sums[row, 0], 1e-300)
    for row in range(len(segments)):
        a, b, own = points[segments[row, 0]], points[segments[row, 1]], sums[ring[segments[row, 0]]]
        ax, ay, az = a[0] - own[1], a[1] - own[2], a[2] - own[3]
        bx, by, bz = b[0] - own[1], b[1] - own[2], b[2] - own[3]
        x, y, z = ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx
        area = norm((x, y, z))
        own[4] += area
        for i in range(3):
            own[5 + i] += area * ((a[i] + b[i] + own[1 + i]) / 3)
        own[8] += x
        own[9] += y
        own[10] += z


@part
def share_below(low: float, middle: float, high: float, level: float) -> float:
    """The share of a triangle's area below a ``level`` of a function with these values, in order, at its corners."""
    if level >= high:
        return 1.0
    if level <= middle:
        above = min(max(level - low, 0.0), middle - low)
        return above * above / max((middle - low) * (high - low), 1e-300)
    below = min(high - level, high - middle)
    return 1.0 - below * below / max((high - middle) * (high - low), 1e-300)


@kernel
def fill_pieces(cuts: Cuts, height: Reals, step: float, measures: Points, piece: Ints, contents: Points) -> None:
    """Add each face's ``measures`` (F, m) to the ``contents`` (P, m) of its pieces, by their shares of its area."""
    for face in range(len(cuts.faces)):
        a, b, c = height[cuts.faces[face, 0]], height[cuts.faces[face, 1]], height[cuts.faces[face, 2]]
        low, high = min(a, b, c), max(a, b, c)
        middle = max(min(a, b), min(max(a, b), c))
        edge = cuts.of_face[face, 0]  # with all bands of the face: from its lowest to its highest corner
        for k in range(1, 3):
            other = cuts.of_face[face, k]
            rise = height[cuts.ends[edge, 1]] - height[cuts.ends[edge, 0]]
            if height[cuts.ends[other, 1]] - height[cuts.ends[other, 0]] > rise:
                edge = other
        before = 0.0
        for level in range(cuts.low[edge], cuts.high[edge] + 1):
            below = share_below(low, middle, high, (level + 1) * step)
            owner = piece[cuts.stretch[edge] + level - cuts.low[edge]]
            for i in range(measures.shape[1]):
                contents[owner, i] += (below - before) * measures[face, i]
            before = below


def levels(vertices: np.ndarray, faces: np.ndarray, height: np.ndarray, step: float) -> Levels:
    """The level sets of ``height`` (V,), at odd multiples of half a ``step``, linear on each of ``faces`` (F, 3).

    No level is at 0, where many vertices often are."""
    num = len(vertices)
    tail, head = faces.ravel(), np.roll(faces, -1, axis=1).ravel()
    key, of_face = np.unique(np.minimum(tail, head) * num + np.maximum(tail, head), return_inverse=True)
    ends = np.stack(np.divmod(key, num), axis=1)
    is_down = height[ends[:, 0]] > height[ends[:, 1]]
    ends[is_down] = ends[is_down, ::-1]
    rise = float((height[ends[:, 1]] - height[ends[:, 0]]).sum())
    while rise / step > MOST_POINTS:
        step *= 2
    height = height + step / 2
    low, high = np.floor(height[ends.T] / step).astype(np.int64)
    count = high - low
    point = np.cumsum(count) - count
    stretch = num + point + np.arange(len(ends))
    cuts = Cuts(faces, of_face.reshape(-1, 3), ends, low, high, point, stretch)
    edge, place = np.repeat(np.arange(len(ends)), count), np.arange(count.sum())
    level = place - np.repeat(point - low - 1, count)
    start, stop = height[ends[edge].T]
    share = ((level * step - start) / (stop - start))[:, None]
    points = (1 - share) * vertices[ends[edge, 0]] + share * vertices[ends[edge, 1]]
    # The longest edge of a face has a point for each of the face's segments.
    piece, ring = np.arange(num + len(points) + len(ends)), np.arange(len(points))
    segments = np.empty((int(count[cuts.of_face].max(axis=1).sum()), 2), dtype=np.int64)
    contents = np.zeros((connect(cuts, piece, ring, segments), 5))
    sums = np.zeros((int(ring.max(initial=-1)) + 1, 14))
    measure_rings(points, segments, ring, sums)
    corners = vertices[faces]
    vector = cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) / 2
    moment = np.einsum("fi,fi->f", corners[:, 0], vector)
    measures = np.column_stack([np.linalg.norm(vector, axis=1), vector, moment])
    fill_pieces(cuts, height, step, measures, piece, contents)
    below, above, own = np.zeros((3, len(sums)), dtype=np.int64)
    lower = place + num + edge  # the stretch below each point
    below[ring], above[ring], own[ring] = piece[lower], piece[lower + 1], level
    perimeter, middle, area, centre, normal, point = np.split(sums, [1, 4, 5, 8, 11], axis=1)
    # A ring without a length is a point: all of its segments start and end there.
    centre = np.where(area <= ROUNDING * perimeter**2, middle, centre / np.maximum(area, 1e-300))
    centre = np.where(perimeter > 0, centre, point)
    size = (area / np.maximum(perimeter, 1e-300))[:, 0]
    at = (own - 0.5) * step
    return Levels(centre, unit(normal), perimeter[:, 0], size, below, above, own, at, piece[:num], contents, step)
