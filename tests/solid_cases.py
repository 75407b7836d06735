"""Surfaces of several parts and of triangles of many sizes, as arrays."""

import numpy as np
import trimesh
from conftest import blob, torus


def arrays(mesh: trimesh.Trimesh) -> tuple[np.ndarray, np.ndarray]:
    """Plain arrays of a Trimesh."""
    return np.array(mesh.vertices), np.array(mesh.faces)


def two_parts() -> trimesh.Trimesh:
    """Two balls that overlap: a surface that crosses itself."""
    return trimesh.util.concatenate([blob(61, 2), blob(62, 2).apply_translation([0.9, 0.1, 0])])


def large_and_small() -> trimesh.Trimesh:
    """A fine ball beside a box of twelve large triangles: sizes that differ by a hundred."""
    return trimesh.util.concatenate([blob(63), trimesh.creation.box([40.0, 30, 20]).apply_translation([22, 0, 0])])


def graded() -> trimesh.Trimesh:
    """A ball drawn out like a pear: triangles of all sizes from one to twenty, side by side."""
    mesh = trimesh.creation.icosphere(2)
    return trimesh.Trimesh(mesh.vertices * np.exp(1.5 * mesh.vertices[:, 2:]) / 4, mesh.faces, process=False)


SHAPES = {
    "blob": lambda: blob(60),
    "torus": torus,
    "two parts": two_parts,
    "large and small": large_and_small,
    "graded": graded,
}


def outward_normals(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Sum of the unit normals of the faces at each vertex times their angle there, one corner at a time."""
    normals = np.zeros_like(vertices)
    for face in faces:
        for k in range(3):
            corner, one, other = vertices[np.roll(face, -k)]
            one, other = one - corner, other - corner
            normal = np.cross(one, other)
            cosine = one @ other / np.linalg.norm(one) / np.linalg.norm(other)
            normals[face[k]] += np.arccos(np.clip(cosine, -1, 1)) * normal / np.linalg.norm(normal)
    return normals
