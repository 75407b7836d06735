"""How thick the solid is at each vertex, for the lengths that the flow may use there.

A wire, a vessel or a neurite is thin beside the diagonal that lengths are fractions of. The ball that touches at a
vertex (see `balls`) knows how thin; but at a sharp edge, a bump or a dent it is small on the thickest solid. So a limb
is as thick as the largest ball near by: at a distance d from one of radius r, at least r - SLOPE d.
"""

import numpy as np
from scipy import sparse, spatial
from scipy.sparse import csgraph

from msf_jax.host.poles.balls import shrinking_balls
from msf_jax.host.solid.geometry import unit, vertex_normals

THIN = 0.005  # diagonals: a limb of a larger radius is not thin
SLOPE = 0.25  # right angles, whose balls shrink to nothing, do not make a solid thin
THINNEST = 0.02  # of `THIN`: the frame's resolution is a hundredth of that
FEW = 0.01  # of the vertices: a solid of which no more is thin is taken as it always was


def scales(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray | None:
    """(V,) the limb's radius at each vertex over `THIN`, 1 where it is larger; None where it is nearly everywhere.

    Args:
        vertices: (V, 3), of diagonal 1.
        faces: (F, 3), closed and oriented.
    """
    most = 2 * THIN
    normals = unit(vertex_normals(vertices, faces))
    balls = shrinking_balls(vertices, normals, spatial.KDTree(vertices), most, most, np.arange(len(vertices)))
    if (balls.radius < THIN).mean() <= FEW:
        return None
    # The largest of r_u - SLOPE |u - v| over all u is most less a shortest way, from one more node joined to all.
    tail, head = faces.ravel(), np.roll(faces, -1, axis=1).ravel()
    num = len(vertices)
    source = np.full(num, num)
    length = SLOPE * np.linalg.norm(vertices[tail] - vertices[head], axis=1)
    start = most - balls.radius
    ways = sparse.coo_matrix(
        (np.maximum(np.r_[length, start], 1e-12), (np.r_[tail, source], np.r_[head, np.arange(num)])),
        shape=(num + 1, num + 1),
    )
    radius = most - csgraph.dijkstra(ways.tocsr(), indices=num)[:num]
    return None if (radius < THIN).mean() <= FEW else np.clip(radius / THIN, THINNEST, 1.0)
