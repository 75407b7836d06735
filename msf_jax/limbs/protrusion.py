"""Where a surface stands out, at each scale: the tips of limbs that are short, blunt, or beside longer ones.

After a heat flow of scale s, a point x of the surface has come to x_s, the mean of the surface around it:

    (M + s^2 / 4 L) x_s = M x,    protrusion h = n . (x - x_s) / s,

with cotangent weights L and areas M. It is at most 1 / 4 on a long cylinder and `BALL` on a ball, 1 / 2 at the end of a
thin rod, and more where that narrows. Tips are the points where h is largest
among their neighbours, and around them, for some s.
"""

import numpy as np
from scipy import sparse

from msf_jax.limbs import ends
from msf_jax.numerics.factors import surface_factor
from msf_jax.solid.geometry import cross, unit

SCALES = 0.2 * 1.8 ** -np.arange(5)  # square roots of the area: from a head's to a toe's; between two, h falls by 4 %
BALL = 0.36  # the largest protrusion of a ball, 1 / sqrt(8) for s = sqrt(2) R, and a little more
APART = 0.6  # of the larger scale: tips are that far from one with more protrusion
MOST = 200  # tips, those with the largest protrusion


def protrusions(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """(S, V) the protrusion of each vertex at each of `SCALES`."""
    matrix, share = ends.laplacian(vertices, faces)
    size, corners = float(np.sqrt(share.sum())), vertices[faces]
    around = cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normal = unit(
        np.stack([np.bincount(faces.ravel(), np.repeat(column, 3), len(vertices)) for column in around.T], axis=1)
    )
    found, mass = np.empty((len(SCALES), len(vertices))), sparse.diags_array(share)
    for row, scale in enumerate(sorted(SCALES * size)):
        solver = surface_factor((mass + scale**2 / 4 * matrix).tocsc())
        found[row] = np.einsum("vi,vi->v", normal, vertices - solver.solve(share[:, None] * vertices)) / scale
    return found


def tips(vertices: np.ndarray, faces: np.ndarray, least: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Vertices (t,) with a protrusion of at least ``least``, the largest one first, that protrusion (t,), and its scale
    (t,), a length."""
    height, scale = protrusions(vertices, faces), np.sort(SCALES) * np.sqrt(ends.laplacian(vertices, faces)[1].sum())
    tail, head = faces.ravel(), np.roll(faces, -1, axis=1).ravel()
    row, vertex = [], []
    for number, own in enumerate(height):
        is_tip = own >= least
        is_tip[tail[own[head] > own[tail]]] = is_tip[head[own[tail] > own[head]]] = False
        vertex.append(np.flatnonzero(is_tip))
        row.append(np.full(len(vertex[-1]), number))
    rows, places = np.concatenate(row), np.concatenate(vertex)
    order = np.lexsort((places, -height[rows, places]))[: 4 * MOST]
    rows, places = rows[order], places[order]
    kept: list[int] = []
    for number in range(len(rows)):
        reach = APART * np.maximum(scale[rows[kept]], scale[rows[number]])
        away = np.linalg.norm(vertices[places[kept]] - vertices[places[number]], axis=1)
        if (away > reach).all() and len(kept) < MOST:
            kept.append(number)
    return places[kept], height[rows[kept], places[kept]], scale[rows[kept]]
