"""Holes filled without new vertices: ear after ear over a rim."""

import heapq
import math

import numpy as np

from msf_jax.host.mesh.half_edges import edge_codes


def filled(vertices: np.ndarray, faces: np.ndarray, size: float) -> tuple[np.ndarray, int, int]:
    """Faces and those that fill the holes whose rim fits into a box with diagonal ``size``; how many of each."""
    edge, _, count = edge_codes(faces)
    origin, target = faces.ravel(), faces[:, [1, 2, 0]].ravel()
    half = np.flatnonzero(count[edge] == 1)
    after = dict(zip(target[half].tolist(), origin[half].tolist(), strict=True))  # along the hole, not the face
    known = set(zip(origin.tolist(), target.tolist(), strict=True))
    new: list[tuple[int, int, int]] = []
    num_holes = 0
    while after:
        start = current = next(iter(after))
        loop = []
        while current in after:
            loop.append(current)
            current = after.pop(current)
        points = vertices[loop]
        if current == start and np.linalg.norm(np.ptp(points, axis=0)) <= size:
            lid = cap(vertices, loop, known)
            num_holes += bool(lid)
            new += lid
    lids = np.array(new, dtype=faces.dtype).reshape(-1, 3)
    return np.concatenate([faces, lids]), num_holes, len(new)


def cap(vertices: np.ndarray, loop: list[int], known: set[tuple[int, int]]) -> list[tuple[int, int, int]]:
    """Triangles over a rim: ear after ear, the shortest chord first, those that bulge the right way before others.

    ``known`` are the half-edges there are, to which the new ones are added: no chord may be one of them. Returns no
    triangle where it cannot be closed.
    """
    around = vertices[loop] - vertices[loop].mean(axis=0)
    normal = np.cross(around, np.roll(around, -1, axis=0)).sum(axis=0)
    num = len(loop)
    before, after = list(range(-1, num - 1)), [*range(1, num), 0]
    before[0] = num - 1
    is_left, faces, chords = [True] * num, [], set()

    def rank(place: int) -> tuple[bool, float, int, int, int]:
        a, b, c = (vertices[loop[k]] for k in (before[place], place, after[place]))
        is_wrong = bool(np.cross(b - a, c - a) @ normal < 0)
        return is_wrong, math.dist(a, c), place, before[place], after[place]

    heap = [rank(place) for place in range(num)]
    heapq.heapify(heap)
    while num > 3 and heap:
        _, _, place, a, c = heapq.heappop(heap)
        if not is_left[place] or before[place] != a or after[place] != c:
            continue
        chord = (loop[a], loop[c])
        if chord in known or chord[::-1] in known or chord in chords or chord[::-1] in chords:
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
