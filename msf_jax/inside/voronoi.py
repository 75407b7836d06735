"""Voronoi poles: for each vertex a point of the medial axis (article 3.1.2; Amenta et al. 2001).

The Voronoi vertices of the sites' diagram are the circumcentres of its Delaunay tetrahedra. The pole of a vertex v
with outward normal n is the Voronoi vertex w of its cell, inside the bounding box, with the most negative <n, w - v>.
"""

from typing import NamedTuple

import numpy as np
from scipy import spatial

from msf_jax.base.errors import FlowError
from msf_jax.solid.geometry import vertex_normals


class Poles(NamedTuple):
    """position: (V, 3), the vertex itself if it has no pole. tetrahedron: (V, 4) the sites whose circumcentre the pole
    is, -1 without a pole. radius: (V,) distance from vertex to pole, 0 without a pole."""

    position: np.ndarray
    tetrahedron: np.ndarray
    radius: np.ndarray

    @property
    def is_found(self) -> np.ndarray:
        """(V,) True where the vertex has a pole."""
        return self.tetrahedron[:, 0] >= 0


def spoke_angles(found: Poles, sites: np.ndarray) -> np.ndarray:
    """Largest angle (V,) between the spokes from each pole to its four sites, in radians; 0 without a pole.

    It is near pi for a ball that touches the surface on opposite sides, and small for a ball caused by noise (Amenta et
    al. 2001; Tagliasacchi et al. 2012).
    """
    spokes = sites[found.tetrahedron] - found.position[:, None]
    spokes /= np.maximum(np.linalg.norm(spokes, axis=2, keepdims=True), 1e-300)
    cosines = np.einsum("vai,vbi->vab", spokes, spokes).min(axis=(1, 2))
    return np.where(found.is_found, np.arccos(np.clip(cosines, -1, 1)), 0.0)


def circumcentres(diagram: spatial.Delaunay) -> np.ndarray:
    """Circumcentres (T, 3) of the tetrahedra; not finite for a tetrahedron without volume.

    Lifted to the paraboloid z = |x|^2, a tetrahedron spans the hyperplane n . x + m z + c = 0, and its circumcentre is
    -n / 2m. Qhull computes one hyperplane for all tetrahedra of the same empty ball (cospherical sites, common on
    symmetric meshes). The formula in the four corners would divide rounding errors for flat tetrahedra.
    """
    plane = diagram.equations
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        return -plane[:, :3] / (2 * diagram.paraboloid_scale * plane[:, 3:4])


def voronoi_poles(sites: np.ndarray, faces: np.ndarray, box: np.ndarray | None = None) -> Poles:
    """The pole of every vertex of the closed mesh ``(sites, faces)``.

    Poles must be inside the bounding box of the points ``box`` (P, 3), by default of the sites. A vertex has no pole if
    its cell has no Voronoi vertex behind the surface and inside the box.

    Raises:
        FlowError: the vertices span no volume, or have non-finite values.
    """
    try:
        diagram = spatial.Delaunay(sites)
    except (spatial.QhullError, ValueError) as error:
        raise FlowError(
            f"no Voronoi diagram of {len(sites)} vertices: {str(error).strip().splitlines()[0]}; "
            "expected points that span a volume: check the mesh, or turn poles off: "
            "Config(preprocessing=PreprocessingOptions(use_poles=False))"
        ) from error
    tetrahedra, centre = diagram.simplices, circumcentres(diagram)
    box = sites if box is None else box
    low, high = box.min(axis=0), box.max(axis=0)
    is_inside_box = ((centre >= low) & (centre <= high)).all(axis=1)  # False if a centre is not finite
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
    chosen[site[::-1]] = tetrahedron[::-1]  # the first of several at the same depth (cospherical sites)

    found = chosen >= 0
    position = np.array(sites, dtype=np.float64)
    position[found] = centre[chosen[found]]
    corners = np.full((len(sites), 4), -1)
    corners[found] = tetrahedra[chosen[found]]
    return Poles(position, corners, np.linalg.norm(position - sites, axis=1))
