"""A solid in the caller's units, the closed parts of a surface that bound solids and cavities, and lids of openings.

A part is nested in another if it is all inside. A part that is inverted beside the outermost part around it is a
cavity, if it is in the full there. In a file that is inside out as a whole, outer parts are inverted, and cavities are
not. A part that is not inverted beside the outermost one is a solid: where the full is around it, it overlaps it.

Openings are boundary loops where a limb was cut off, such as a vessel's, and which repair closed with a lid. A lid is
the end of a limb. It bounds no ball, and no section: where a plane across the limb cuts the lid, as it does near an
oblique one, a part of the limb is missing.
"""

from concurrent.futures import Future
from functools import cached_property, partial
from typing import NamedTuple

import numpy as np

from msf_jax.base.clock import begin_in_turn
from msf_jax.solid import sections
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import ROUNDING, cross, signed_volume, triangle_areas, unit
from msf_jax.topology import graphs
from msf_jax.topology.graphs import by_label

STEEPEST = 0.5  # cosine between a lid and the walls at its rim: 0 where a tube is cut off, 1 for a hole in a wall
NARROWEST = 0.5  # radii of the limb: least radius of a lid; where a hole is in a ridge, the limb goes on beside it
JUST_INSIDE = 0.05  # radii of a lid: depth below the lid at which the limb is whole


def nested(parts: list[Enclosure], volume: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The nesting of closed connected ``parts`` with their signed ``volume`` (k,) as given, not 0: the owner (k,), for
    a cavity the solid that it is in, for a solid itself; and which parts (k,) are solids inside another."""
    num, sizes = len(parts), np.abs(volume)
    low = np.array([part.vertices.min(axis=0) for part in parts])
    high = np.array([part.vertices.max(axis=0) for part in parts])
    owner, winding, is_within = np.arange(num), np.ones(num, dtype=np.int64), np.zeros(num, dtype=bool)

    def is_in(part: Enclosure, other: Enclosure) -> bool:
        return all(other.winding_numbers(points).all() for points in (part.vertices[:1], part.vertices))

    for each in np.argsort(-sizes, kind="stable").tolist():
        is_around = ((low < low[each]) & (high > high[each])).all(axis=1) & (sizes > sizes[each])
        around = [k for k in np.flatnonzero(is_around).tolist() if is_in(parts[each], parts[k])]
        if not around:
            continue
        outermost = max(around, key=lambda k: sizes[k])
        is_full = winding[around].sum() > 0
        if is_full and (volume[each] < 0) != (volume[outermost] < 0):
            winding[each] = -1
            owner[each] = min((k for k in around if winding[k] > 0), key=lambda k: sizes[k])
        else:
            is_within[each] = is_full
    return owner, is_within


class Body(NamedTuple):
    """A solid of a surface: its vertices and its faces, those of cavities too, and the faces of its outside, by number.

    is_within: whether it is inside another solid, and so counts twice."""

    vertices: np.ndarray
    faces: np.ndarray
    outside: np.ndarray
    is_within: bool


def bodies(shape: Enclosure) -> list[Body]:
    """The solids of a closed surface."""
    faces = shape.faces
    rows, parts = by_label(graphs.pieces(faces, len(shape.vertices))), []
    if len(rows) == 1:
        return [Body(np.flatnonzero(np.bincount(faces.ravel())), rows[0], rows[0], False)]
    for mine in rows:
        member, corners = np.unique(faces[mine], return_inverse=True)
        parts.append(Enclosure(shape.vertices[member], corners.reshape(-1, 3)))
    owner, is_within = nested(parts, np.array([signed_volume(part.vertices, part.faces) for part in parts]))
    found = []
    for number in np.flatnonzero(owner == np.arange(len(owner))).tolist():
        mine = np.concatenate([rows[k] for k in np.flatnonzero(owner == number).tolist()])
        found.append(Body(np.unique(faces[mine]), mine, rows[number], bool(is_within[number])))
    return found


class Lid(NamedTuple):
    """The lid of an opening.

    faces: (l,). rim: (r, 3) its corners. middle: (3,) of the area that is seen along the ``normal``, at the mean height
    of the rim, so that the lid's triangles do not matter. normal: (3,) unit, outwards. area: as seen along it. reach:
    the largest distance of the rim from the middle. uneven: the same along the normal; 0 for a flat rim."""

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
    found = []
    for own in by_label(graphs.pieces(faces[lids], len(vertices))) if len(lids) else []:
        own = lids[own]
        corner, rim = vertices[faces[own]], vertices[np.unique(faces[own])]
        twice = cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
        normal = unit(twice.sum(axis=0))
        seen = np.maximum(twice @ normal, 0.0)  # a lid that is folded over still has its middle between its corners
        middle = seen @ corner.mean(axis=1) / max(float(seen.sum()), 1e-300)
        middle += (rim.mean(axis=0) - middle) @ normal * normal
        away = rim - middle
        reach, uneven = np.linalg.norm(away, axis=1).max(), np.abs(away @ normal).max()
        found.append(Lid(own, rim, middle, normal, float(seen.sum()) / 2, float(reach), float(uneven)))
    return found


def is_end(shape: Enclosure, lid: Lid) -> bool:
    """Whether a limb of ``shape`` ends at the ``lid``, which else closes a hole in the wall of a limb.

    The lid of a hole goes on as the wall around it does. A hole can also be in a ridge, such as the edge of an ear,
    where the section just below the lid is much larger than the lid."""
    is_lid = np.zeros(len(shape.faces), dtype=bool)
    is_lid[lid.faces] = True
    twin = shape.mesh.twins.reshape(-1, 3)[lid.faces].ravel()
    at_rim = ~is_lid[twin // 3]
    edge = shape.triangles[lid.faces] - np.roll(shape.triangles[lid.faces], -1, axis=1)
    length = np.linalg.norm(edge.reshape(-1, 3)[at_rim], axis=1)
    walls = length @ shape.normals[twin[at_rim] // 3] / max(float(length.sum()), 1e-300)
    if lid.area <= 0 or walls @ lid.normal > STEEPEST:
        return False
    place = moved_inside(lid.middle[None], lid.normal[None], [lid])
    found = sections.cut(shape, place, lid.normal[None], np.array([lid.radius()]))
    return bool(found.is_around[0]) and lid.area >= NARROWEST**2 * float(found.area[0])


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


class Solid:
    """A closed surface with queries in the caller's units.

    It is stored centred and with a diagonal of 1, so that no square overflows or underflows.

    Args:
        vertices: (V, 3), in the caller's units.
        faces: (F, 3), closed and oriented.
        lids: (L,) the faces that close openings, if any: they do not bound a ball.
    """

    def __init__(self, vertices: np.ndarray, faces: np.ndarray, lids: np.ndarray | None = None):
        self.vertices = np.array(vertices)  # as given: `leave` of the stored ones would be rounded
        low, high = vertices.min(axis=0), vertices.max(axis=0)
        unit = float((high - low).max())
        self.centre = low + (high - low) / 2
        self.diagonal = unit * float(np.linalg.norm((high - low) / unit))
        self.shape = Enclosure((vertices - self.centre) / self.diagonal, faces)
        self.lids = np.empty(0, dtype=np.int64) if lids is None else lids
        self.openings = lids_of(self.shape.vertices, faces, self.lids)
        self._wall = None
        if len(self.lids):  # the wall has no vertices that only lids use
            used, corners = np.unique(np.delete(faces, self.lids, axis=0), return_inverse=True)
            # It is open, so that only its distances mean anything: nothing is inside or outside of it.
            self._wall = Enclosure(self.shape.vertices[used], corners.reshape(-1, 3))

    @cached_property
    def outside(self) -> Enclosure:
        """The outsides of the solids, which have the limbs: without cavities. Vertices keep their numbers."""
        shape, outside = self.shape, np.sort(np.concatenate([body.outside for body in bodies(self.shape)]))
        return shape if len(outside) == len(shape.faces) else Enclosure(shape.vertices, shape.faces[outside])

    def begin(self) -> Future:
        """Begin to make, beside the flow, what takes long after it: the shape's trees, handles, crossings; areas."""
        of_shape = [partial(getattr, self.shape, name) for name in ("mesh", "samples", "handles", "crossed")]
        return begin_in_turn([*of_shape, lambda: self.vertex_areas])

    def enter(self, points: np.ndarray) -> np.ndarray:
        """``points`` (P, 3) in units of the diagonal, around the centre."""
        return (points - self.centre) / self.diagonal

    def leave(self, points: np.ndarray) -> np.ndarray:
        """The inverse of `enter`."""
        return self.centre + self.diagonal * points

    def radii(self, points: np.ndarray) -> np.ndarray:
        """Radius (P,) of the largest ball inside around each point; 0 for a point outside.

        With lids, only the wall bounds a ball. A point that is no farther in front of a lid than the lid's rim is
        uneven counts as inside."""
        entered = self.enter(points)
        clearance = self.shape.clearance(entered)
        if self._wall is not None:
            distance, face = self.shape.nearest(entered)
            slack = np.zeros(len(self.shape.faces))
            for lid in self.openings:
                slack[lid.faces] = lid.uneven + ROUNDING
            is_in = (clearance > 0) | (distance < slack[face])
            clearance[is_in] = self._wall.distances(entered[is_in])
        return self.diagonal * clearance

    @cached_property
    def vertex_areas(self) -> np.ndarray:
        """(V,) a third of the area of the faces around each vertex, as a fraction of the whole area."""
        area = triangle_areas(self.shape.triangles)
        corners = self.shape.faces.T.ravel()
        return np.bincount(corners, weights=np.tile(area, 3), minlength=len(self.shape.vertices)) / (3 * area.sum())
