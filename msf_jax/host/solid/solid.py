"""A solid in the caller's units, and the radius of the largest ball inside it around a point."""

from functools import cached_property

import numpy as np

from msf_jax.host.solid.enclosure import Enclosure
from msf_jax.host.solid.nesting import without_cavities

ON_LID = 1e-9  # diagonals from a lid within which a point is on it and counts as inside


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
        self._wall = None
        if len(self.lids):  # the wall has no vertices that only lids use
            used, corners = np.unique(np.delete(faces, self.lids, axis=0), return_inverse=True)
            self._wall = Enclosure(self.shape.vertices[used], corners.reshape(-1, 3))

    @cached_property
    def outside(self) -> Enclosure:
        """The surface without that of cavities: it has the limbs."""
        return without_cavities(self.shape)

    def enter(self, points: np.ndarray) -> np.ndarray:
        """``points`` (P, 3) in units of the diagonal, around the centre."""
        return (points - self.centre) / self.diagonal

    def leave(self, points: np.ndarray) -> np.ndarray:
        """The inverse of `enter`."""
        return self.centre + self.diagonal * points

    def radii(self, points: np.ndarray) -> np.ndarray:
        """Radius (P,) of the largest ball inside around each point; 0 for a point outside.

        With lids, only the wall bounds a ball.
        """
        entered = self.enter(points)
        clearance = self.shape.clearance(entered)
        if self._wall is not None:
            distance, face = self.shape.nearest(entered)
            is_in = (clearance > 0) | ((distance < ON_LID) & np.isin(face, self.lids))
            clearance[is_in] = self._wall.distances(entered[is_in])
        return self.diagonal * clearance

    def vertex_areas(self) -> np.ndarray:
        """(V,) a third of the area of the faces around each vertex, as a fraction of the whole area."""
        a, b, c = np.moveaxis(self.shape.triangles, 1, 0)
        area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
        corners = self.shape.faces.T.ravel()
        return np.bincount(corners, weights=np.tile(area, 3), minlength=len(self.shape.vertices)) / (3 * area.sum())
