"""The two steps before the flow as separate functions: spectral reconstruction and Voronoi poles."""

import numbers

import numpy as np
import trimesh

from msf_jax.base.errors import ConfigError
from msf_jax.inside import balls
from msf_jax.meshes import checking
from msf_jax.meshes.reading import MeshLike
from msf_jax.numerics import reconstruction


def reconstruct(mesh: "MeshLike", k: int = 400) -> trimesh.Trimesh:
    """The mesh without its small details: V' = Phi Phi^T V with ``k`` eigenvectors (article 3.1.1).

    Args:
        mesh: as `skeletonize` takes it; it is not changed.
        k: eigenvectors of the uniform graph Laplacian to keep, 4 or more; the number of vertices or more keeps all.

    Returns:
        A new mesh with the repaired input's faces.

    Raises:
        MeshError: see `skeletonize`.
        ConfigError: ``k`` is below 4.
    """
    if not isinstance(k, numbers.Integral) or isinstance(k, bool) or k < 4:
        raise ConfigError(f"k is {k!r}: expected a whole number of at least 4; fewer eigenvectors rebuild no volume")
    k = int(k)
    checked = checking.prepare(mesh)
    vertices = checked.vertices.copy()
    for component, member in zip(checked.components, checked.members, strict=True):
        centre = component.vertices.mean(axis=0)
        vertices[member] = centre + reconstruction.reconstruct(component.vertices - centre, component.faces, k)
    return trimesh.Trimesh(vertices, checked.faces, process=False)


def voronoi_poles(mesh: "MeshLike") -> np.ndarray:
    """The Voronoi pole of every vertex of the unfiltered mesh (article 3.1.2; Amenta et al. 2001).

    Args:
        mesh: as `skeletonize` takes it; it is not changed.

    Returns:
        (V, 3), in the caller's units: one pole for each vertex of the repaired mesh, NaN if a vertex has none. The
        distance from a vertex to its pole is the radius of the ball that touches the surface there.

    Raises:
        MeshError: see `skeletonize`.
        FlowError: the vertices have no Voronoi diagram.
    """
    checked = checking.prepare(mesh)
    positions = np.full(checked.vertices.shape, np.nan)
    for component, member in zip(checked.components, checked.members, strict=True):
        centre = (component.vertices.min(axis=0) + component.vertices.max(axis=0)) / 2
        found = balls.voronoi_poles(component.vertices - centre, component.faces)
        positions[member[found.is_found]] = centre + found.position[found.is_found]
    return positions
