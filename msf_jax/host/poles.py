"""Voronoi poles: for each vertex a point of the medial axis (article 3.1.2; Amenta et al. 2001).

The Voronoi vertices of the sites' diagram are the circumcentres of its Delaunay tetrahedra. The pole of a vertex v
with outward normal n is the Voronoi vertex w of its cell, inside the bounding box, with the most negative <n, w - v>.
"""

from typing import NamedTuple

import numpy as np
from scipy import spatial

from msf_jax.errors import FlowError


class Poles(NamedTuple):
    """position: (V, 3), the vertex itself where it has no pole. tetrahedron: (V, 4) the sites whose circumcentre the
    pole is, -1 where there is none. radius: (V,) distance from vertex to pole, 0 where there is none."""

    position: np.ndarray
    tetrahedron: np.ndarray
    radius: np.ndarray

    @property
    def is_found(self) -> np.ndarray:
        """(V,) True where the vertex has a pole."""
        return self.tetrahedron[:, 0] >= 0


def vertex_normals(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Area-weighted vertex normals (V, 3), not normalised: only the sign and order of <n, w - v> matter."""
    a, b, c = vertices[faces[:, 0]], vertices[faces[:, 1]], vertices[faces[:, 2]]
    normal = np.cross(b - a, c - a)
    corner = faces.T.ravel()
    return np.stack(
        [np.bincount(corner, weights=np.tile(normal[:, axis], 3), minlength=len(vertices)) for axis in range(3)], axis=1
    )


def circumcentres(vertices: np.ndarray, tetrahedra: np.ndarray) -> np.ndarray:
    """Circumcentres (T, 3); not finite for a tetrahedron without volume.

    With edge vectors a, b, c from the first vertex: (|a|^2 b x c + |b|^2 c x a + |c|^2 a x b) / (2 a . (b x c)).
    """
    origin = vertices[tetrahedra[:, 0]]
    a, b, c = (vertices[tetrahedra[:, k]] - origin for k in (1, 2, 3))
    bc, ca, ab = np.cross(b, c), np.cross(c, a), np.cross(a, b)
    square = [np.einsum("ij,ij->i", v, v)[:, None] for v in (a, b, c)]
    determinant = np.einsum("ij,ij->i", a, bc)[:, None]
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        return origin + (square[0] * bc + square[1] * ca + square[2] * ab) / (2 * determinant)


def voronoi_poles(sites: np.ndarray, faces: np.ndarray) -> Poles:
    """The pole of every vertex of the closed mesh ``(sites, faces)``.

    A vertex whose cell has no Voronoi vertex behind the surface and inside the bounding box has no pole.

    Raises:
        FlowError: the vertices span no volume, or hold non-finite values.
    """
    try:
        tetrahedra = spatial.Delaunay(sites).simplices
    except (spatial.QhullError, ValueError) as error:
        raise FlowError(
            f"no Voronoi diagram of {len(sites)} vertices: {str(error).strip().splitlines()[0]}; "
            "expected points that span a volume: check the mesh, or turn the poles off (use_poles=False)"
        ) from error
    centre = circumcentres(sites, tetrahedra)
    low, high = sites.min(axis=0), sites.max(axis=0)
    is_inside_box = ((centre >= low) & (centre <= high)).all(axis=1)  # False, too, where a centre is not finite
    tetrahedra, centre = tetrahedra[is_inside_box], centre[is_inside_box]

    normal = vertex_normals(sites, faces)
    site = tetrahedra.ravel()
    tetrahedron = np.repeat(np.arange(len(tetrahedra)), 4)
    depth = np.einsum("ij,ij->i", normal[site], centre[tetrahedron] - sites[site])
    deepest = np.zeros(len(sites))
    np.minimum.at(deepest, site, depth)
    is_pole = (depth == deepest[site]) & (depth < 0)
    site, tetrahedron = site[is_pole], tetrahedron[is_pole]
    chosen = np.full(len(sites), -1)
    chosen[site[::-1]] = tetrahedron[::-1]  # several at the same depth (cospherical sites): the first

    found = chosen >= 0
    position = np.array(sites, dtype=np.float64)
    position[found] = centre[chosen[found]]
    corners = np.full((len(sites), 4), -1)
    corners[found] = tetrahedra[chosen[found]]
    return Poles(position, corners, np.linalg.norm(position - sites, axis=1))
