"""Filling of holes by ear clipping, without new vertices."""

import heapq
import math
from typing import NamedTuple

import numpy as np

from msf_jax.topology.half_edges import edge_codes

Face = tuple[int, int, int]


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
    around = vertices[loop] - vertices[loop].mean(axis=0)
    normal = np.cross(around, np.roll(around, -1, axis=0)).sum(axis=0)
    # Plain numbers, because a file can have thousands of small holes, and NumPy is slow for short vectors.
    points, (nx, ny, nz) = vertices[loop].tolist(), normal.tolist()
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
