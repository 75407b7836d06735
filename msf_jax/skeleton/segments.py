"""Segmentation of the surface by branch, with the map from the surface to the curve."""

from typing import TYPE_CHECKING

import numpy as np
import trimesh

from msf_jax.meshes import reading
from msf_jax.meshes.reading import MeshLike
from msf_jax.topology import graphs

if TYPE_CHECKING:
    from msf_jax.skeleton.skeleton import Skeleton

SMALL_PIECE = 0.5  # of the number of faces of its branch's largest piece: a piece with fewer is reassigned


def _of_faces(vertices: np.ndarray, faces: np.ndarray, branch: np.ndarray) -> np.ndarray:
    """(F,) the branch of each face: the ``branch`` (V,) of most of its corners.

    Around a junction, vertices of several branches are mixed. There a small piece goes to the branch around it.
    """
    corner = branch[faces]
    of_face = np.where(corner[:, 1] == corner[:, 2], corner[:, 1], corner[:, 0])
    place = np.unique(vertices, axis=0, return_inverse=True)[1].ravel()  # so that faces across a seam are neighbours
    a, b = np.reshape(trimesh.graph.face_adjacency(place[faces]), (-1, 2)).T
    while True:
        same = of_face[a] == of_face[b]
        piece = graphs.labels(len(faces), a[same], b[same])
        size = np.bincount(piece)
        owner = np.zeros(len(size), dtype=np.int64)
        owner[piece] = of_face
        largest = np.zeros(int(branch.max(initial=0)) + 1, dtype=np.int64)
        np.maximum.at(largest, owner, size)
        is_small = size < SMALL_PIECE * largest[owner]
        ends = np.concatenate([piece[np.stack([a, b], axis=1)[~same]], piece[np.stack([b, a], axis=1)[~same]]])
        ends = ends[is_small[ends[:, 0]] & ~is_small[ends[:, 1]]]
        if not len(ends):
            return of_face
        border, count = np.unique(ends, axis=0, return_counts=True)
        border = border[np.lexsort((count, border[:, 0]))]  # the longest border last: the last assignment below wins
        owner[border[:, 0]] = owner[border[:, 1]]
        of_face = owner[piece]


def segments(skeleton: "Skeleton", mesh: "MeshLike") -> list[trimesh.Trimesh]:
    """See `Skeleton.segments`."""
    vertices, faces = reading.read(mesh, finite=False)
    reading.check_map(skeleton.mesh_map, len(vertices))
    branch_of_node = np.full(len(skeleton.vertices), -1)
    for number, one in reversed(list(enumerate(skeleton.branches))):  # a junction has the first of its branches
        branch_of_node[np.asarray(one.nodes)] = number
    branch = branch_of_node[skeleton.mesh_map]
    of_face = _of_faces(vertices, faces, branch)
    parts = []
    for number in range(len(skeleton.branches)):
        hue = number * 0.61803398875 + np.array([0, 1 / 3, 2 / 3])  # the golden ratio: unlike those before
        colour = [*(150 + 90 * np.cos(2 * np.pi * hue)).astype(np.uint8), 255]
        used, local = np.unique(faces[of_face == number], return_inverse=True)
        node, local = skeleton.mesh_map[used], local.reshape(-1, 3)
        part = trimesh.Trimesh(vertices[used], local, process=False, face_colors=np.tile(colour, (len(local), 1)))
        part.vertex_attributes |= {"radius": skeleton.radii[node], "node": node, "branch": branch[used]}
        parts.append(part)
    return parts
