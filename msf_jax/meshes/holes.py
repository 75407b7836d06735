"""Holes: lids by ear clipping without new vertices, or the extrusion of a rim whose lid would cut through the surface.

The lid over the uneven rim of a height field or a bent sheet passes above the surface in some places and below it in
others. The closed surface is then several solids that meet in curves, and no skeleton can stay inside. The area vector
of the surface (the sum of its faces' normals times areas, which depends on the rim only) gives the direction of its
front; the inside is behind it. The rim is extruded backwards, past all of the piece, and closed there, like the base of
a relief. The extrusion has a new vertex for each vertex of the rim.
"""

import heapq
import math
from typing import NamedTuple

import numpy as np

from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import signed_volume, unit
from msf_jax.topology import graphs
from msf_jax.topology.graphs import by_label, edge_codes

Face = tuple[int, int, int]

LARGEST_CUT = 0.01  # share of a piece's area whose inner side is outside of the closed solid, at most
MARGIN = 0.05  # extents of the rim: distance between the piece and the end of the extrusion
EVEN = 1e-6  # extents of the rim: a rim of less height has a flat lid, which needs no extrusion
FEWEST_FACES = 100  # faces of a piece whose rim may be extruded: smaller pieces are fragments
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
    """Triangles over a rim by ear clipping: convex ears first, among these the shortest chord; none if the rim cannot
    be closed. No chord may be one of the half-edges ``known``, in either direction; those of the triangles are added.
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


def extruded(
    vertices: np.ndarray, faces: np.ndarray, holes: list[Hole], repairs: list[str]
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The surface of ``faces`` (F, 3) with the lids of ``holes``; the longest rim of a piece is extruded if its lid
    cuts through the piece. ``repairs`` gets a sentence for each change.

    Returns the vertices, new ones last, the faces, and the vertex of the rim for each new vertex."""
    sources, vertices_of, num_cut = [np.empty(0, dtype=np.int64)], [vertices], 0
    lids = [hole.lid for hole in holes]
    for number, mine, others in _uneven(vertices, faces, holes):
        known = np.concatenate([faces[mine], *(holes[other].lid for other in others)])
        if share_cut_off(vertices, np.concatenate([known, holes[number].lid]), len(mine)) <= LARGEST_CUT:
            continue
        loop = np.array(holes[number].loop)
        ring, band = _extrusion(vertices, known, loop)
        every = np.concatenate([vertices, ring])
        if share_cut_off(every, np.concatenate([known, band]), len(mine)) > LARGEST_CUT:
            num_cut += 1
            continue
        first = sum(map(len, vertices_of))
        lids[number] = np.where(band < len(vertices), 0, first - len(vertices)) + band
        vertices_of.append(ring)
        sources.append(loop)
    source = np.concatenate(sources)
    if len(source):
        rims = "1 rim, whose lid" if len(sources) == 2 else f"{len(sources) - 1} rims, whose lids"
        repairs.append(f"extruded {rims} would cut through the surface: {len(source)} new vertices")
    if num_cut:
        cut = "the lid of 1 hole cuts" if num_cut == 1 else f"the lids of {num_cut} holes cut"
        repairs.append(f"{cut} through the surface, and so would an extruded rim: the curve may be outside there")
    return np.concatenate(vertices_of), np.concatenate([faces, *lids]), source


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


def _uneven(vertices: np.ndarray, faces: np.ndarray, holes: list[Hole]) -> list[tuple[int, np.ndarray, list[int]]]:
    """For each large piece whose longest rim is uneven, those with the most faces first: that hole, the piece's faces,
    its other holes."""
    if not holes:
        return []
    label = graphs.labels_of_faces(faces, len(vertices))
    piece_of_hole = label[[hole.loop[0] for hole in holes]]
    faces_of, uneven = by_label(label[faces[:, 0]]), []
    for piece in dict.fromkeys(piece_of_hole.tolist()):
        numbers = np.flatnonzero(piece_of_hole == piece).tolist()
        longest = max(numbers, key=lambda number: len(holes[number].loop))
        rim = vertices[holes[longest].loop]
        height = np.ptp((rim - rim[0]) @ unit(_area_vector(rim)))
        if len(faces_of[piece]) >= FEWEST_FACES and height > EVEN * np.ptp(rim, axis=0).max():
            uneven.append((longest, faces_of[piece], [number for number in numbers if number != longest]))
    return sorted(uneven, key=lambda each: -len(each[1]))


def _area_vector(rim: np.ndarray) -> np.ndarray:
    """(3,) twice the area vector of any surface bounded by the loop ``rim`` (n, 3)."""
    around = rim - rim.mean(axis=0)
    return np.cross(around, np.roll(around, -1, axis=0)).sum(axis=0)


def _extrusion(vertices: np.ndarray, faces: np.ndarray, loop: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The extrusion of the rim ``loop`` (n,) past the piece of ``faces``, behind its surface: the new vertices (n, 3),
    which count from ``len(vertices)``, in the order of the rim, and the faces with those of the lid."""
    rim = vertices[loop]
    along = unit(_area_vector(rim))
    end = (vertices[np.unique(faces)] @ along).max() + MARGIN * np.ptp(rim, axis=0).max()
    ring = rim + (end - rim @ along)[:, None] * along
    below = len(vertices) + np.arange(len(loop))
    after, below_after = np.roll(loop, -1), np.roll(below, -1)
    band = [np.stack([loop, after, below_after], axis=1), np.stack([loop, below_after, below], axis=1)]
    lid = np.array(lid_of(ring, list(range(len(loop))), set()), dtype=np.int64).reshape(-1, 3) + len(vertices)
    return ring, np.concatenate([*band, lid])
