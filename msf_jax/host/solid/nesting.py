"""Which closed parts of a surface bound solids, and which bound cavities in them: by their nesting and their windings.

A part is nested in another if it is all inside. A part that is inverted beside the outermost part around it is a
cavity, if it is in the full there. In a file that is inside out as a whole, outer parts are inverted, and cavities are
not. A part that is not inverted beside the outermost one is a solid: where the full is around it, it overlaps it.
"""

from typing import NamedTuple

import numpy as np
from scipy import sparse
from scipy.sparse import csgraph

from msf_jax.host.mesh.half_edges import by_label
from msf_jax.host.solid.enclosure import Enclosure
from msf_jax.host.solid.geometry import signed_volume


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
    faces, num = shape.faces, len(shape.vertices)
    graph = sparse.coo_matrix((np.ones(2 * len(faces)), faces[:, [0, 1, 1, 2]].reshape(-1, 2).T), shape=(num, num))
    label = np.unique(csgraph.connected_components(graph, directed=False)[1][faces[:, 0]], return_inverse=True)[1]
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
