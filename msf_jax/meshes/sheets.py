"""Sheets that share an edge or a vertex: which faces belong together, their orientation, their twins, internal walls.

A mesh of cells, or of bodies that share faces, has internal walls, and at an edge as many faces as cells. Around an
edge, the side of a face is connected to the facing side of the next face. Connected sides form a shell. The shell of a
cell encloses its volume; the outer shell encloses the sum of all volumes, with the opposite sign. A face with neither
side in the outer shell is a wall. (Shells of cells around an edge: Zhou et al. 2016.)
"""

import numpy as np

from msf_jax.topology import graphs
from msf_jax.topology.half_edges import edge_codes


def left_alone(faces: np.ndarray) -> np.ndarray:
    """(3F,) half-edges, at an edge of more than two faces, that are not paired with the others there.

    These are the faces of open patches, such as a fin, if the other faces are an even number. Of an odd number of faces
    it is the one of the smallest patch, preferably an open one, which is more likely a wall than part of a solid.
    """
    edge, _, count = edge_codes(faces)
    order = np.argsort(edge, kind="stable")
    start = np.concatenate([[0], np.cumsum(count)])
    patch, size, is_open = _patches(edge, count)
    alone = np.zeros(len(edge), dtype=bool)
    for number in np.flatnonzero(count > 2):
        halves = order[start[number] : start[number + 1]]
        own = patch[halves // 3]
        num_closed = int((~is_open[own]).sum())
        if num_closed and num_closed % 2 == 0:
            alone[halves[is_open[own]]] = True
        elif len(halves) % 2:
            alone[halves[np.lexsort((size[own], ~is_open[own]))[0]]] = True
    return alone


def _patches(edge: np.ndarray, count: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """For each face its patch, connected across edges of two faces; for each patch its size, and whether it is open."""
    order = np.argsort(edge, kind="stable")
    pair = order[(count[edge] == 2)[order]].reshape(-1, 2) // 3
    patch = graphs.labels(len(edge) // 3, *pair.T)
    on_rim = (count[edge] == 1).reshape(-1, 3).any(axis=1)
    return patch, np.bincount(patch), np.bincount(patch, weights=on_rim) > 0


def oriented(faces: np.ndarray, alone: np.ndarray) -> tuple[np.ndarray, int]:
    """Orient faces consistently across edges with two faces that are not ``alone`` (3F,). Returns how many were turned.

    In each connected patch, the smaller number of faces is turned. Each face is twice in a graph, as it is and turned,
    and faces that fit are connected. A patch is then two components, one of which is used. A patch with one side only
    is a single component, and is not changed.
    """
    edge, _, count = edge_codes(faces)
    num_joined = np.bincount(edge[~alone], minlength=len(count))
    order = np.argsort(edge, kind="stable")
    half = order[((num_joined[edge] == 2) & ~alone)[order]].reshape(-1, 2)
    origin, face = faces.ravel(), half // 3
    is_same = (origin[half[:, 0]] == origin[half[:, 1]]).astype(np.int64)
    num = len(faces)
    a = np.concatenate([face[:, 0], face[:, 0] + num])
    b = np.concatenate([face[:, 1] + num * is_same, face[:, 1] + num * (1 - is_same)])
    as_is, turned = graphs.labels(2 * num, a, b).reshape(2, -1)
    is_turned = as_is > turned
    patch = np.minimum(as_is, turned)
    share = np.bincount(patch, weights=is_turned) / np.maximum(np.bincount(patch), 1)
    is_turned ^= (share[patch] > 0.5) & (as_is != turned)
    return np.where(is_turned[:, None], faces[:, ::-1], faces), int(is_turned.sum())


def twins(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """(3F,) the twin of each half-edge, or -1.

    At an edge of more than two faces, half-edges of opposite directions are paired, those that enclose the smallest
    angle of the inside first. Half-edges that are left alone are paired only within their patch.
    """
    edge, _, count = edge_codes(faces)
    alone, patch = left_alone(faces), _patches(edge, count)[0]
    order = np.argsort(edge, kind="stable")
    start = np.concatenate([[0], np.cumsum(count)])
    origin, target, apex = (faces[:, corners].ravel() for corners in ([0, 1, 2], [1, 2, 0], [2, 0, 1]))
    twin = np.full(len(origin), -1)
    pair = order[(count[edge] == 2)[order]].reshape(-1, 2)
    pair = pair[origin[pair[:, 0]] != origin[pair[:, 1]]]
    twin[pair[:, 0]], twin[pair[:, 1]] = pair[:, 1], pair[:, 0]
    low, high = np.minimum(origin, target), np.maximum(origin, target)
    crowded, angles = np.flatnonzero(count[edge] > 2), np.zeros(len(origin))
    angles[crowded] = angles_around(vertices[low[crowded]], vertices[high[crowded]], vertices[apex[crowded]])
    for number in np.flatnonzero(count > 2):
        halves = order[start[number] : start[number + 1]]
        angle, is_forward = angles[halves], origin[halves] == low[halves]
        ahead, back = np.flatnonzero(is_forward), np.flatnonzero(~is_forward)
        wedge = (angle[ahead][:, None] - angle[back]) % (2 * np.pi)  # inside is in the direction of smaller angles
        one, other = halves[ahead][:, None], halves[back]
        is_barred = (alone[one] | alone[other]) & (patch[one // 3] != patch[other // 3])
        wedge[is_barred] = np.inf
        for _ in range(min(wedge.shape)):
            i, j = np.unravel_index(np.argmin(wedge), wedge.shape)
            if wedge[i, j] < np.inf:
                twin[one[i, 0]], twin[other[j]] = other[j], one[i, 0]
            wedge[i], wedge[:, j] = np.inf, np.inf
    return twin


def is_double(faces: np.ndarray) -> np.ndarray:
    """(F,) faces at an edge of more than two faces."""
    edge, _, count = edge_codes(faces)
    return np.any(count[edge].reshape(-1, 3) > 2, axis=1)


def angles_around(start: np.ndarray, end: np.ndarray, points: np.ndarray) -> np.ndarray:
    """(n,) angles of ``points`` (n, 3) around the axes from ``start`` to ``end`` (n, 3), counter-clockwise."""
    axis = end - start
    length = np.linalg.norm(axis, axis=1, keepdims=True)
    axis = np.where(length > 0, axis / np.maximum(length, 1e-300), [0.0, 0.0, 1.0])
    u = np.cross(axis, np.eye(3)[np.abs(axis).argmin(axis=1)])
    away, v = points - start, np.cross(axis, u)
    return np.arctan2(np.einsum("ij,ij->i", away, v), np.einsum("ij,ij->i", away, u))


def cut_apart(faces: np.ndarray, twin: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """One vertex for each fan of faces around it: new faces, and the old vertex of each new one."""
    num = len(twin)
    half = np.flatnonzero(twin >= 0)
    after = twin - twin % 3 + (twin + 1) % 3  # the corner at the end of the twin
    fan = graphs.labels(num, half, after[half])
    owner = faces.ravel()[np.unique(fan, return_index=True)[1]]
    order = np.argsort(owner, kind="stable")
    number = np.argsort(order)
    return number[fan].reshape(-1, 3), owner[order]


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
    shell = graphs.labels(2 * num, ahead, back)
    chunk = graphs.labels(shell.max() + 1, shell[:num], shell[num:])
    a, b, c = (vertices[corner] - vertices[faces].mean(axis=(0, 1)) for corner in faces.T)
    volume = np.einsum("fi,fi->f", a, np.cross(b, c)) / 6
    enclosed = np.bincount(shell[num:], weights=volume, minlength=len(chunk))
    enclosed -= np.bincount(shell[:num], weights=volume, minlength=len(chunk))
    by_chunk = np.lexsort((enclosed, chunk))
    is_outer = np.zeros(len(chunk), dtype=bool)
    is_outer[by_chunk[np.append(True, chunk[by_chunk][1:] != chunk[by_chunk][:-1])]] = True
    return ~(is_outer[shell[:num]] | is_outer[shell[num:]])
