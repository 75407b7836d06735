"""Solids: which closed parts of a surface bound them and their cavities; and a `Solid` in the caller's units.

A part is nested in another if it is all inside. A part that is inverted beside the outermost part around it is a
cavity, if it is in the full there. In a file that is inside out as a whole, outer parts are inverted, and cavities are
not. A part that is not inverted beside the outermost one is a solid: where the full is around it, it overlaps it.
"""

from functools import cached_property
from typing import NamedTuple

import numpy as np

from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import ROUNDING, signed_volume, triangle_areas
from msf_jax.solid.openings import lids_of
from msf_jax.topology import graphs
from msf_jax.topology.half_edges import by_label


class Nesting(NamedTuple):
    """owner: (k,) for a cavity the solid that it is in; a solid is its own. is_within: (k,) solids inside another."""

    owner: np.ndarray
    is_within: np.ndarray

    @property
    def is_cavity(self) -> np.ndarray:
        """(k,) which parts are cavities."""
        return self.owner != np.arange(len(self.owner))


def nested(parts: list[Enclosure], volume: np.ndarray) -> Nesting:
    """The nesting of closed connected ``parts`` with their signed ``volume`` (k,) as given, not 0."""
    num, sizes = len(parts), np.abs(volume)
    low = np.array([part.vertices.min(axis=0) for part in parts])
    high = np.array([part.vertices.max(axis=0) for part in parts])
    owner, winding, is_within = np.arange(num), np.ones(num, dtype=np.int64), np.zeros(num, dtype=bool)
    for each in np.argsort(-sizes, kind="stable").tolist():
        is_around = ((low < low[each]) & (high > high[each])).all(axis=1) & (sizes > sizes[each])
        around = [k for k in np.flatnonzero(is_around).tolist() if _is_in(parts[each], parts[k])]
        if not around:
            continue
        outermost = max(around, key=lambda k: sizes[k])
        is_full = winding[around].sum() > 0
        if is_full and (volume[each] < 0) != (volume[outermost] < 0):
            winding[each] = -1
            owner[each] = min((k for k in around if winding[k] > 0), key=lambda k: sizes[k])
        else:
            is_within[each] = is_full
    return Nesting(owner, is_within)


def _is_in(part: Enclosure, other: Enclosure) -> bool:
    """Whether all of ``part`` is inside ``other``, however that is oriented."""
    return bool(other.winding_numbers(part.vertices[:1])[0]) and bool(other.winding_numbers(part.vertices).all())


class Body(NamedTuple):
    """A solid of a surface: its vertices and its faces, those of cavities too, and the faces of its outside, by number.

    is_within: whether it is inside another solid, and so counts twice.
    """

    vertices: np.ndarray
    faces: np.ndarray
    outside: np.ndarray
    is_within: bool


def bodies(shape: Enclosure) -> list[Body]:
    """The solids of a closed surface."""
    faces = shape.faces
    label = graphs.pieces(faces, len(shape.vertices))
    if not label.any():
        every = np.arange(len(faces))
        return [Body(np.unique(faces), every, every, False)]
    rows, parts = by_label(label), []
    for mine in rows:
        member, corners = np.unique(faces[mine], return_inverse=True)
        parts.append(Enclosure(shape.vertices[member], corners.reshape(-1, 3)))
    owner, is_within = nested(parts, np.array([signed_volume(part.vertices, part.faces) for part in parts]))
    found = []
    for number in np.flatnonzero(owner == np.arange(len(owner))).tolist():
        mine = np.concatenate([rows[k] for k in np.flatnonzero(owner == number).tolist()])
        found.append(Body(np.unique(faces[mine]), mine, rows[number], bool(is_within[number])))
    return found


def without_cavities(shape: Enclosure) -> Enclosure:
    """The outsides of the solids of a surface; ``shape`` itself if it has no cavity. Vertices keep their numbers."""
    outside = np.sort(np.concatenate([body.outside for body in bodies(shape)]))
    return shape if len(outside) == len(shape.faces) else Enclosure(shape.vertices, shape.faces[outside])


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
        self.openings = lids_of(self.shape.vertices, faces, self.lids) if len(self.lids) else []
        self._wall = None
        if len(self.lids):  # the wall has no vertices that only lids use
            used, corners = np.unique(np.delete(faces, self.lids, axis=0), return_inverse=True)
            # It is open, so that only its distances mean anything: nothing is inside or outside of it.
            self._wall = Enclosure(self.shape.vertices[used], corners.reshape(-1, 3))

    @cached_property
    def outside(self) -> Enclosure:
        """The surface without that of cavities: it has the limbs."""
        return without_cavities(self.shape)

    def prepare(self) -> None:
        """Make now, beside the flow, what takes long after it: the shape's trees, and the areas."""
        self.shape.prepare()
        _ = self.vertex_areas

    def enter(self, points: np.ndarray) -> np.ndarray:
        """``points`` (P, 3) in units of the diagonal, around the centre."""
        return (points - self.centre) / self.diagonal

    def leave(self, points: np.ndarray) -> np.ndarray:
        """The inverse of `enter`."""
        return self.centre + self.diagonal * points

    def radii(self, points: np.ndarray) -> np.ndarray:
        """Radius (P,) of the largest ball inside around each point; 0 for a point outside.

        With lids, only the wall bounds a ball. A point that is no farther in front of a lid than the lid's rim is
        uneven counts as inside.
        """
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
