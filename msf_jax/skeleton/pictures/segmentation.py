"""Segmentation of the surface by branch, with the map from the surface to the curve."""

from typing import TYPE_CHECKING, Any

import numpy as np
import trimesh

from msf_jax.host.mesh import reading

if TYPE_CHECKING:
    from msf_jax.skeleton.skeleton import Skeleton


def branch_of_node(skeleton: "Skeleton") -> np.ndarray:
    """(N,) the index in ``skeleton.branches`` of each node's branch; at a junction, the first."""
    number = np.full(len(skeleton.vertices), -1)
    for k, branch in reversed(list(enumerate(skeleton.branches))):
        number[np.asarray(branch.nodes)] = k
    return number


def colours(num: int) -> np.ndarray:
    """(num, 4) uint8 colours; those of successive numbers have very different hues."""
    hue = np.arange(num) * 0.61803398875 % 1.0  # the golden ratio
    angle = 2 * np.pi * (hue[:, None] + np.array([0, 1 / 3, 2 / 3]))
    return np.column_stack([150 + 90 * np.cos(angle), np.full(num, 255)]).astype(np.uint8)


def segments(skeleton: "Skeleton", mesh: Any) -> list[trimesh.Trimesh]:
    """See `Skeleton.segments`."""
    vertices, faces = reading.read(mesh, finite=False)
    reading.check_map(skeleton.mesh_map, len(vertices))
    branch = branch_of_node(skeleton)[skeleton.mesh_map]
    of_face = branch[faces[:, 0]]
    palette = colours(len(skeleton.branches))
    parts = []
    for number in range(len(palette)):
        used, local = np.unique(faces[of_face == number], return_inverse=True)
        node = skeleton.mesh_map[used]
        local = local.reshape(-1, 3)
        colour = np.tile(palette[number], (len(local), 1))
        part = trimesh.Trimesh(vertices[used], local, process=False, face_colors=colour)
        part.vertex_attributes |= {"radius": skeleton.radii[node], "node": node, "branch": branch[used]}
        parts.append(part)
    return parts
