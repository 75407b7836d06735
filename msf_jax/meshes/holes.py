"""Holes: lids by ear clipping without new vertices, and what no lid can close.

The lid over the uneven rim of a height field or a bent sheet passes above the surface in some places and below it in
others. The closed surface would be several solids that meet in curves, and no skeleton can stay inside.
"""

import heapq
import math
from typing import NamedTuple

import numpy as np

from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import signed_volume, unit
from msf_jax.topology import graphs
from msf_jax.topology.half_edges import by_label, edge_codes

Face = tuple[int, int, int]

LARGEST_CUT = 0.01  # share of a piece's area whose inner side is outside of the closed solid, at most
EVEN = 1e-6  # extents of the rim: a rim of less height has a flat lid, which cannot cut
FEWEST_FACES = 100  # faces of a piece whose lid is tested: smaller pieces are fragments
BESIDE = 1e-5  # extents of the piece: depth below the centre of a face of the point that is tested to be inside


class Hole(NamedTuple):
    """A filled hole. loop: the vertices of its rim, in the lid's orientation. lid: (L, 3) the faces that fill it."""

    loop: list[int]
    lid: np.ndarray


def filled(vertices: np.ndarray, faces: np.ndarray, size: float) -> list[Hole]:
    """The holes whose rim fits into a box of diagonal ``size``, each with the faces that fill it. Those whose rims
    share a vertex, or cannot be closed, may be left open."""
    edge, _, count = edge_codes(faces)
    origin, target = faces.ravel(), faces[:, [1, 2, 0]].ravel()
    half = np.flatnonzero(count[edge] == 1)
    after = dict(zip(target[half].tolist(), origin[half].tolist(), strict=True))  # in the lid's direction
    known = set(zip(origin.tolist(), target.tolist(), strict=True))
    holes = []
    while after:
        start = current = next(iter(after))
        loop = []
        while current in after:
            loop.append(current)
            current = after.pop(current)
        points = vertices[loop]
        if current == start and np.linalg.norm(np.ptp(points, axis=0)) <= size:
            lid = lid_of(vertices, loop, known)
            if lid:
                holes.append(Hole(loop, np.array(lid, dtype=faces.dtype)))
    return holes


def lid_of(vertices: np.ndarray, loop: list[int], known: set[tuple[int, int]]) -> list[Face]:
    """Triangles over a rim by ear clipping: convex ears first, among these the shortest chord.

    ``known`` are the half-edges of the mesh. A chord may not be one of them, in either direction. The half-edges of the
    triangles are added to them. Returns no triangles if the rim cannot be closed.
    """
    # Plain numbers, because a file can have thousands of small holes, and NumPy is slow for short vectors.
    points, (nx, ny, nz) = vertices[loop].tolist(), _area_vector(vertices[loop]).tolist()
    num = len(loop)
    before, after = list(range(-1, num - 1)), [*range(1, num), 0]
    before[0] = num - 1
    is_left, faces, chords = [True] * num, [], set()

    def rank(place: int) -> tuple[bool, float, int, int, int]:
        a, b, c = points[before[place]], points[place], points[after[place]]
        ux, uy, uz = b[0] - a[0], b[1] - a[1], b[2] - a[2]
        vx, vy, vz = c[0] - a[0], c[1] - a[1], c[2] - a[2]
        along = (uy * vz - uz * vy) * nx + (uz * vx - ux * vz) * ny + (ux * vy - uy * vx) * nz
        return along < 0, math.dist(a, c), place, before[place], after[place]

    heap = [rank(place) for place in range(num)]
    heapq.heapify(heap)
    while num > 3 and heap:
        _, _, place, a, c = heapq.heappop(heap)
        if not is_left[place] or before[place] != a or after[place] != c:
            continue
        chord = (loop[a], loop[c])
        if chord in known or chord[::-1] in known or chord in chords:
            continue
        chords |= {chord, chord[::-1]}
        faces.append((loop[a], loop[place], loop[c]))
        is_left[place] = False
        after[a], before[c] = c, a
        num -= 1
        for neighbour in (a, c):
            heapq.heappush(heap, rank(neighbour))
    if num != 3:
        return []
    last = is_left.index(True)
    faces.append((loop[before[last]], loop[last], loop[after[last]]))
    known |= {(a, b) for face in faces for a, b in zip(face, (*face[1:], face[0]), strict=True)}
    return faces


def lid_that_cuts(vertices: np.ndarray, faces: np.ndarray, holes: list[Hole]) -> Hole | None:
    """The first of ``holes`` of ``faces`` (F, 3) whose lid cuts through its piece, of which the longest is tried."""
    if not holes:
        return None
    label = graphs.labels_of_faces(faces, len(vertices))
    piece_of_hole = label[[hole.loop[0] for hole in holes]]
    faces_of = by_label(label[faces[:, 0]])
    for piece in dict.fromkeys(piece_of_hole.tolist()):
        own = [holes[number] for number in np.flatnonzero(piece_of_hole == piece)]
        longest = max(own, key=lambda hole: len(hole.loop))
        rim, mine = vertices[longest.loop], faces[faces_of[piece]]
        height = np.ptp((rim - rim[0]) @ unit(_area_vector(rim)))
        if len(mine) >= FEWEST_FACES and height > EVEN * np.ptp(rim, axis=0).max():
            closed = np.concatenate([mine, *(hole.lid for hole in own)])
            if share_cut_off(vertices, closed, len(mine)) > LARGEST_CUT:
                return longest
    return None


def share_cut_off(vertices: np.ndarray, faces: np.ndarray, num_given: int) -> float:
    """The share of the area of the first ``num_given`` of closed ``faces`` (F, 3) whose inner side is outside."""
    used, corners = np.unique(faces, return_inverse=True)
    points, corners = vertices[used], corners.reshape(-1, 3)
    extent = float(np.ptp(points, axis=0).max())
    points = (points - points.mean(axis=0)) / (extent or 1.0)
    if signed_volume(points, corners) < 0:
        corners = corners[:, ::-1]
    given = points[corners[:num_given]]
    normal = np.cross(given[:, 1] - given[:, 0], given[:, 2] - given[:, 0])
    area = np.linalg.norm(normal, axis=1)
    is_outside = ~Enclosure(points, corners).contains(given.mean(axis=1) - BESIDE * unit(normal))
    return float(area[is_outside].sum() / max(area.sum(), 1e-300))


def _area_vector(rim: np.ndarray) -> np.ndarray:
    """(3,) twice the area vector of any surface bounded by the loop ``rim`` (n, 3)."""
    around = rim - rim.mean(axis=0)
    return np.cross(around, np.roll(around, -1, axis=0)).sum(axis=0)
