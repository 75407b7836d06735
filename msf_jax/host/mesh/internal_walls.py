"""Faces inside a solid: walls between its cells, which are not connected to the outside.

A mesh of cells, or of bodies that share faces, has internal walls, and at an edge as many faces as cells. Around an
edge, the side of a face is connected to the facing side of the next face. Connected sides form a shell. The shell of a
cell encloses its volume; the outer shell encloses the sum of all volumes, with the opposite sign. A face with neither
side in the outer shell is a wall. (Shells of cells around an edge: Zhou et al. 2016.)
"""

import numpy as np
from scipy import sparse
from scipy.sparse import csgraph

from msf_jax.host.mesh.half_edges import edge_codes
from msf_jax.host.mesh.sheets import angles_around


def is_wall(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """(F,) whether each of ``faces`` (F, 3) is an internal wall of its edge-connected piece.

    There are none if a hole connects inside and outside, or if no edge has more than two faces.
    """
    num = len(faces)
    edge, _, count = edge_codes(faces)
    if not (count > 2).any():
        return np.zeros(num, dtype=bool)
    origin, target, apex = (faces[:, corners].ravel() for corners in ([0, 1, 2], [1, 2, 0], [2, 0, 1]))
    low, high = np.minimum(origin, target), np.maximum(origin, target)
    angle = angles_around(vertices[low], vertices[high], vertices[apex])
    order = np.lexsort((angle, edge))
    is_last = np.append(edge[order][1:] != edge[order][:-1], True)
    first = np.concatenate([[0], np.flatnonzero(is_last)[:-1] + 1])
    following = np.append(order[1:], 0)
    following[is_last] = order[first]
    # The side that the normal of face f points to has the id f, the other side f + F.
    is_forward = origin == low
    ahead = order // 3 + num * ~is_forward[order]
    back = following // 3 + num * is_forward[following]
    graph = sparse.coo_matrix((np.ones(3 * num), (ahead, back)), shape=(2 * num, 2 * num))
    shell = csgraph.connected_components(graph, directed=False)[1]
    both = sparse.coo_matrix((np.ones(num), (shell[:num], shell[num:])), shape=(shell.max() + 1,) * 2)
    chunk = csgraph.connected_components(both, directed=False)[1]
    a, b, c = (vertices[corner] - vertices[faces].mean(axis=(0, 1)) for corner in faces.T)
    volume = np.einsum("fi,fi->f", a, np.cross(b, c)) / 6
    enclosed = np.bincount(shell[num:], weights=volume, minlength=len(chunk))
    enclosed -= np.bincount(shell[:num], weights=volume, minlength=len(chunk))
    by_chunk = np.lexsort((enclosed, chunk))
    is_outer = np.zeros(len(chunk), dtype=bool)
    is_outer[by_chunk[np.append(True, chunk[by_chunk][1:] != chunk[by_chunk][:-1])]] = True
    return ~(is_outer[shell[:num]] | is_outer[shell[num:]])
