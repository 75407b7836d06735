"""Other diagonals in flat places, where triangles are long and thin: the same surface, in better triangles.

A function that is linear on needles runs in zigzags, and what is solved on them can be wrong by any factor: on a
cylinder of needles, a mean exit time was a fifth of the right one. An edge between two triangles in one plane is
replaced by their other diagonal while the angles opposite to it add up to more than 180 degrees,

    cot a + cot b < 0,

so that each flat face ends as the Delaunay triangulation of its vertices (Lawson, 1977).
"""

import numpy as np

from msf_jax.solid.geometry import cross
from msf_jax.topology.graphs import half_edges

LEAST_BEND = 1e-3  # sine of the angle between two triangles that are not in one plane
ROUNDED = 1e-6  # of the surface's extent: coordinates in single precision, not too far from the origin, are as exact
MOST_ROUNDS = 100  # of flips: a cylinder of 17,000 needles took 36. After the last one the surface is right, too
EQUAL = 1e-3  # of two cotangents: both diagonals of a rectangle are as good, and rounding does not choose one


def reconnected(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """The faces (F, 3) of a surface ``(vertices (V, 3), faces (F, 3))``, with other edges where it is flat."""
    least = ROUNDED * float(np.linalg.norm(np.ptp(vertices, axis=0)))
    faces, number = faces.astype(np.int64), np.arange(faces.size)
    onward, before = (number - number % 3 + (number + step) % 3 for step in (1, 2))
    cotangent = _cotangents(vertices[faces])
    for _ in range(MOST_ROUNDS):
        twin = half_edges(faces).twin
        edge = np.flatnonzero(number < twin)
        one, two = cotangent.ravel()[edge], cotangent.ravel()[twin[edge]]
        is_wrong = one + two < -EQUAL * (np.abs(one) + np.abs(two))
        edge = edge[is_wrong][np.argsort(np.round((one + two)[is_wrong], 6), kind="stable")]
        # From a to b, between the triangles a, b, c and b, a, d; it becomes the edge from c to d.
        corner, back = faces.ravel(), twin[edge]
        ends = np.stack([corner[each] for each in (edge, back, before[edge], before[back])])
        may_flip = _is_flat(vertices[ends], least) & _is_new(corner, corner[onward], *ends[2:])
        # Of the edges of a triangle, the worst one goes first.
        pair = np.stack([edge, back], axis=1)[may_flip] // 3
        is_first = np.zeros(pair.size, dtype=bool)
        is_first[np.unique(pair, return_index=True)[1]] = True
        chosen = is_first.reshape(-1, 2).all(axis=1)
        if not chosen.any():
            break
        a, b, c, d = ends[:, may_flip][:, chosen]
        face, other = pair[chosen].T
        faces[face], faces[other] = np.stack([c, a, d], axis=1), np.stack([d, b, c], axis=1)
        changed = pair[chosen].ravel()
        cotangent[changed] = _cotangents(vertices[faces[changed]])
    return faces


def _cotangents(corners: np.ndarray) -> np.ndarray:
    """(F, 3) of the triangles ``corners`` (F, 3, 3), opposite to the edges from each corner to the next one."""
    apex = np.roll(corners, 1, axis=1)
    one, other = corners - apex, np.roll(corners, -1, axis=1) - apex
    area = np.linalg.norm(cross(one, other), axis=2)
    return np.einsum("fkc,fkc->fk", one, other) / np.maximum(area, 1e-300)


def _is_flat(corners: np.ndarray, least: float) -> np.ndarray:
    """(E,) whether the triangles a, b, c and b, a, d, of ``corners`` (4, E, 3), are in one plane, beside each other.

    The lines from a to b and from c to d pass each other within ``least``, or `LEAST_BEND` of the lower
    triangle's height."""
    a, b, c, d = corners
    one, other, across = cross(b - a, c - a), cross(a - b, d - b), cross(b - a, d - c)
    height = np.minimum(np.linalg.norm(one, axis=1), np.linalg.norm(other, axis=1))
    height /= np.maximum(np.linalg.norm(b - a, axis=1), 1e-300)
    apart = np.abs(np.einsum("ei,ei->e", across, c - a))
    is_near = apart <= np.maximum(LEAST_BEND * height, least) * np.linalg.norm(across, axis=1)
    return is_near & (np.einsum("ei,ei->e", one, other) >= 0)


def _is_new(tail: np.ndarray, head: np.ndarray, c: np.ndarray, d: np.ndarray) -> np.ndarray:
    """(E,) whether no edge from ``tail`` to ``head`` joins c and d (E,), and no pair before in the list does."""
    num = int(tail.max(initial=-1)) + 1
    code = np.minimum(c, d) * num + np.maximum(c, d)
    is_first = np.zeros(len(code), dtype=bool)
    is_first[np.unique(code, return_index=True)[1]] = True
    return is_first & (c != d) & ~np.isin(code, tail * num + head)
