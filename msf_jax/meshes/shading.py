"""Normals with which a viewer shows a surface smooth, and its creases sharp.

A corner of a face belongs to the fan of faces around its place that are joined across edges below `CREASE`. Its normal
is the mean of theirs, weighted by their angles there (Thürmer and Wüthrich 1998). Places are positions, not vertices:
shading does not show where a texture has a seam.
"""

import numpy as np

from msf_jax.solid.geometry import unit
from msf_jax.topology import graphs

# Degrees between normals across an edge: a limb of six sides (60) is round, the edge of a box (90) is sharp.
CREASE = 75.0


def corner_normals(vertices: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Unit normals of the corners of ``faces`` (F, 3), as (F, 3, 3), and for each corner the number (F, 3) of its fan.
    Corners of one fan have one normal. That of faces without area is (0, 0, 1)."""
    corners = vertices[faces]
    ahead, back = (np.roll(corners, shift, axis=1) - corners for shift in (-1, 1))
    across = np.cross(ahead, back)  # (F, 3, 3) twice the area's vector, at each corner
    angle = np.arctan2(np.linalg.norm(across, axis=2), (ahead * back).sum(axis=2))
    face_normal = unit(across[:, 0])
    fan = _fans(np.unique(vertices, axis=0, return_inverse=True)[1].reshape(-1)[faces], face_normal)
    weighted = (angle[:, :, None] * face_normal[:, None]).reshape(-1, 3)
    total = np.stack([np.bincount(fan, weighted[:, axis]) for axis in range(3)], axis=1)
    normal = unit(total)
    normal[~normal.any(axis=1)] = [0.0, 0.0, 1.0]
    return normal[fan].reshape(-1, 3, 3), fan.reshape(-1, 3)


def _fans(places: np.ndarray, face_normal: np.ndarray) -> np.ndarray:
    """(3F,) the number of each corner's fan, for the ``places`` (F, 3) of all corners."""
    corner = np.arange(places.size).reshape(-1, 3)
    start, end = corner.ravel(), np.roll(corner, -1, axis=1).ravel()  # of each half-edge, as corners
    place = places.ravel()
    is_up = place[start] < place[end]
    low, high = np.where(is_up, start, end), np.where(is_up, end, start)
    order = np.lexsort((place[high], place[low]))
    low, high, normal = low[order], high[order], face_normal[order // 3]
    is_same = (place[low[1:]] == place[low[:-1]]) & (place[high[1:]] == place[high[:-1]])
    is_smooth = is_same & ((normal[1:] * normal[:-1]).sum(axis=1) > np.cos(np.radians(CREASE)))
    one, other = np.flatnonzero(is_smooth), np.flatnonzero(is_smooth) + 1
    return graphs.labels(len(place), np.r_[low[one], high[one]], np.r_[low[other], high[other]])
