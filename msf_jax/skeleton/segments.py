"""Segmentation of the surface by branch, with the map from the surface to the curve."""

from typing import TYPE_CHECKING

import numpy as np
import trimesh

from msf_jax.meshes import reading
from msf_jax.meshes.reading import MeshLike

if TYPE_CHECKING:
    from msf_jax.skeleton.skeleton import Skeleton


def segments(skeleton: "Skeleton", mesh: "MeshLike") -> list[trimesh.Trimesh]:
    """See `Skeleton.segments`."""
    vertices, faces = reading.read(mesh, finite=False)
    reading.check_map(skeleton.mesh_map, len(vertices))
    branch_of_node = np.full(len(skeleton.vertices), -1)
    for number, one in reversed(list(enumerate(skeleton.branches))):  # a junction has the first of its branches
        branch_of_node[np.asarray(one.nodes)] = number
    branch = branch_of_node[skeleton.mesh_map]
    first, second, third = branch[faces].T
    of_face = np.where(second == third, second, first)
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
