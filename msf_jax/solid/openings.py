"""Openings: boundary loops where a limb was cut off, such as a vessel's, and which repair closed with a lid.

A lid is the end of a limb. It bounds no ball, and no section: where a plane across the limb cuts the lid, as it does
near an oblique one, a part of the limb is missing.
"""

from typing import NamedTuple

import numpy as np

from msf_jax.solid import sections
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import cross, unit
from msf_jax.topology import graphs
from msf_jax.topology.half_edges import by_label

STEEPEST = 0.5  # cosine between a lid and the walls at its rim: 0 where a tube is cut off, 1 for a hole in a wall
NARROWEST = 0.5  # radii of the limb: least radius of a lid; where a hole is in a ridge, the limb goes on beside it
JUST_INSIDE = 0.05  # radii of a lid: depth below the lid at which the limb is whole


class Lid(NamedTuple):
    """The lid of an opening.

    faces: (l,). rim: (r, 3) the places of its corners. middle: (3,) of the area that is seen along the ``normal``, at
    the mean height of the rim, so that it does not depend on the lid's triangles. normal: (3,) unit, outwards. area: as
    seen along it. reach: the largest distance of the rim from the middle. uneven: the same along the normal; 0 for a
    flat rim.
    """

    faces: np.ndarray
    rim: np.ndarray
    middle: np.ndarray
    normal: np.ndarray
    area: float
    reach: float
    uneven: float

    def radius(self) -> float:
        """The radius of a disc of the lid's area."""
        return float(np.sqrt(self.area / np.pi))


def lids_of(vertices: np.ndarray, faces: np.ndarray, lids: np.ndarray) -> list[Lid]:
    """The lids that the faces ``lids`` (L,) of a surface ``(vertices (V, 3), faces (F, 3))`` make: a piece each."""
    if not len(lids):
        return []
    return [_lid(vertices, faces, lids[own]) for own in by_label(graphs.pieces(faces[lids], len(vertices)))]


def _lid(vertices: np.ndarray, faces: np.ndarray, own: np.ndarray) -> Lid:
    corner, rim = vertices[faces[own]], vertices[np.unique(faces[own])]
    twice = cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    normal = unit(twice.sum(axis=0))
    seen = np.maximum(twice @ normal, 0.0)  # a lid that is folded over still has its middle between its corners
    middle = seen @ corner.mean(axis=1) / max(float(seen.sum()), 1e-300)
    middle += (rim.mean(axis=0) - middle) @ normal * normal
    uneven = float(np.abs((rim - middle) @ normal).max())
    return Lid(
        own, rim, middle, normal, float(seen.sum()) / 2, float(np.linalg.norm(rim - middle, axis=1).max()), uneven
    )


def is_end(shape: Enclosure, lid: Lid) -> bool:
    """Whether a limb of ``shape`` ends at the ``lid``, which else closes a hole in the wall of a limb.

    The lid of a hole goes on as the wall around it does. A hole can also be in a ridge, such as the edge of an ear,
    where the section just below the lid is much larger than the lid.
    """
    is_lid = np.zeros(len(shape.faces), dtype=bool)
    is_lid[lid.faces] = True
    half = 3 * lid.faces[:, None] + np.arange(3)
    twin = shape.mesh.twins[half.ravel()]
    at_rim = ~is_lid[twin // 3]
    edge = shape.triangles[lid.faces] - np.roll(shape.triangles[lid.faces], -1, axis=1)
    length = np.linalg.norm(edge.reshape(-1, 3)[at_rim], axis=1)
    walls = length @ shape.normals[twin[at_rim] // 3] / max(float(length.sum()), 1e-300)
    if lid.area <= 0 or walls @ lid.normal > STEEPEST:
        return False
    place = moved_inside(lid.middle[None], lid.normal[None], [lid])
    corners = sections.corners(shape, place, lid.normal[None], np.array([lid.radius()]))
    found = sections.measured(shape, place, lid.normal[None], corners)
    area = float(sections.areas(shape, corners, lid.normal[None])[0])
    return bool(found.is_around[0]) and lid.area >= NARROWEST**2 * area


def moved_inside(points: np.ndarray, normals: np.ndarray, lids: list[Lid]) -> np.ndarray:
    """``points`` (P, 3), moved along ``normals`` (P, 3) so far that planes across these cut none of the ``lids`` near
    them."""
    places = points.copy()
    for lid in lids:
        outward = normals * np.where(normals @ lid.normal < 0, -1.0, 1.0)[:, None]
        depth = np.einsum("pri,pi->pr", points[:, None] - lid.rim, outward).max(axis=1) + JUST_INSIDE * lid.radius()
        # A plane that cuts the rim of a lid ahead is across a point within the lid's reach.
        is_near = (np.linalg.norm(points - lid.middle, axis=1) <= lid.reach) & (depth > 0)
        places[is_near] = (points - depth[:, None] * outward)[is_near]
    return places
