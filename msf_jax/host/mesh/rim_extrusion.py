"""Holes whose lid would cut through the surface: a skirt is let down from the rim, and the lid goes flat on its end.

The lid over the uneven rim of a height field or a bent sheet passes now above the surface and now below it: what it
closes falls into solids that hang together by nothing, and no curve can stay inside. The area vector of the surface
(the sum of its faces' normals times their areas, which is its rim's alone) says where the surface looks; behind it is
the inside. The rim is carried that way, past all of the piece, and the lid is put there: as the base of a relief.
The other way is taken where that side is the better one. A skirt has new vertices, one for each of the rim.
"""

from typing import NamedTuple

import numpy as np
from scipy import sparse
from scipy.sparse import csgraph

from msf_jax.host.mesh.filling import Hole, cap
from msf_jax.host.mesh.half_edges import by_label
from msf_jax.host.solid.enclosure import Enclosure
from msf_jax.host.solid.geometry import signed_volume, unit

LARGEST_CUT = 0.01  # of a piece's area, that may have its inside outside of what a lid closes
MARGIN = 0.05  # of the rim's extent, between the piece and the end of a skirt
FLAT = 1e-6  # of a piece's extent: a rim that is no higher has a flat lid
FEWEST_FACES = 100  # of a piece that may have a skirt: fewer are a crumb, or a patch of something else
MOST_TESTED = 200  # pieces with an uneven lid, those with the most faces first
BESIDE = 1e-5  # of a piece's extent, behind the middle of a face, where it is asked whether that is inside


class Extruded(NamedTuple):
    """A surface without holes.

    vertices: (V, 3), those that were given and the skirts', which come last. faces: (F, 3). source: (M,) the vertex of
    the rim that each of a skirt's was carried from. repairs: what was done, a sentence each.
    """

    vertices: np.ndarray
    faces: np.ndarray
    source: np.ndarray
    repairs: list[str]


class RimExtrusion(NamedTuple):
    """ring: (n, 3) the vertices at its end, in the order of the rim. faces: its own and the lid's, (S, 3)."""

    ring: np.ndarray
    faces: np.ndarray


def extruded(vertices: np.ndarray, faces: np.ndarray, holes: list[Hole]) -> Extruded:
    """The surface of ``faces`` (F, 3) with the lids of ``holes``, or a skirt where a lid cuts through its piece.

    Of the holes of a piece the one with the longest rim can have one.
    """
    uneven = _uneven(vertices, faces, holes)
    sources, rings, instead, num_kept = [np.empty(0, dtype=np.int64)], [vertices], {}, 0
    for number, mine, others in uneven[:MOST_TESTED]:
        known = np.concatenate([faces[mine], *(holes[other].lid for other in others)])
        if share_cut_off(vertices, np.concatenate([known, holes[number].lid]), len(mine)) <= LARGEST_CUT:
            continue
        loop = np.array(holes[number].loop)
        for side in (1, -1):
            extrusion = _extrusion(vertices, known, loop, side)
            every = np.concatenate([vertices, extrusion.ring])
            if share_cut_off(every, np.concatenate([known, extrusion.faces]), len(mine)) <= LARGEST_CUT:
                first = sum(map(len, rings))
                instead[number] = np.where(extrusion.faces < len(vertices), 0, first - len(vertices)) + extrusion.faces
                rings.append(extrusion.ring)
                sources.append(loop)
                break
        else:
            num_kept += 1
    repairs = []
    if instead:
        made = sum(map(len, rings)) - len(vertices)
        lids, rim_extrusion = ("1 lid", "a skirt") if len(instead) == 1 else (f"{len(instead)} lids", "skirts")
        repairs.append(
            f"put {lids} that would cut through the surface at the end of {rim_extrusion}: {made} new vertices"
        )
    if num_kept:
        lids = "the lid of 1 hole cuts" if num_kept == 1 else f"the lids of {num_kept} holes cut"
        repairs.append(f"{lids} through the surface, and so would a skirt: the curve may be outside there")
    if len(uneven) > MOST_TESTED:
        repairs.append(f"looked if lids cut through the surface in the largest {MOST_TESTED} of {len(uneven)} pieces")
    lids = [instead.get(number, hole.lid) for number, hole in enumerate(holes)]
    return Extruded(np.concatenate(rings), np.concatenate([faces, *lids]), np.concatenate(sources), repairs)


def share_cut_off(vertices: np.ndarray, faces: np.ndarray, num_given: int) -> float:
    """The share of the area of the first ``num_given`` of closed ``faces`` (F, 3) that has its inside outside."""
    used, corners = np.unique(faces, return_inverse=True)
    points, corners = vertices[used], corners.reshape(-1, 3)
    extent = float(np.ptp(points, axis=0).max())
    points = (points - points.mean(axis=0)) / (extent or 1.0)
    if signed_volume(points, corners) < 0:
        corners = corners[:, ::-1]
    given = points[corners[:num_given]]
    normal = np.cross(given[:, 1] - given[:, 0], given[:, 2] - given[:, 0])
    area = np.linalg.norm(normal, axis=1)
    is_outside = ~Enclosure(points, corners).contains(given.mean(axis=1) - BESIDE * unit(normal))
    return float(area[is_outside].sum() / max(area.sum(), 1e-300))


def _uneven(vertices: np.ndarray, faces: np.ndarray, holes: list[Hole]) -> list[tuple[int, np.ndarray, list[int]]]:
    """The hole with the longest rim of each large piece, if that is uneven; the piece's faces; its other holes.

    Pieces with the most faces come first.
    """
    if not holes:
        return []
    ends, num = (faces.ravel(), faces[:, [1, 2, 0]].ravel()), len(vertices)
    graph = sparse.coo_matrix((np.ones(len(ends[0])), ends), (num, num))
    label = csgraph.connected_components(graph, directed=False)[1]
    holes_of: dict[int, list[int]] = {}
    for number, hole in enumerate(holes):
        holes_of.setdefault(int(label[hole.loop[0]]), []).append(number)
    faces_of, found = by_label(label[faces[:, 0]]), []
    for own, numbers in holes_of.items():
        if len(faces_of[own]) < FEWEST_FACES:
            continue
        longest = max(numbers, key=lambda number: len(holes[number].loop))
        rim = vertices[holes[longest].loop]
        if np.ptp((rim - rim[0]) @ unit(_area_vector(rim))) > FLAT * np.ptp(rim, axis=0).max():
            others = [number for number in numbers if number != longest]
            found.append((longest, faces_of[own], others))
    return sorted(found, key=lambda each: -len(each[1]))


def _area_vector(rim: np.ndarray) -> np.ndarray:
    """(3,) twice the area vector of any surface that a loop (n, 3) goes round."""
    around = rim - rim.mean(axis=0)
    return np.cross(around, np.roll(around, -1, axis=0)).sum(axis=0)


def _extrusion(vertices: np.ndarray, faces: np.ndarray, loop: np.ndarray, side: int) -> RimExtrusion:
    """The skirt from a ``loop`` (n,) round a hole past the piece of ``faces``, numbered from ``len(vertices)``.

    It goes to where the lid looks, which is behind the surface, or with ``side`` -1 the other way.
    """
    rim = vertices[loop]
    along = side * unit(_area_vector(rim))
    end = (vertices[np.unique(faces)] @ along).max() + MARGIN * np.ptp(rim, axis=0).max()
    ring = rim + (end - rim @ along)[:, None] * along
    below = len(vertices) + np.arange(len(loop))
    after, below_after = np.roll(loop, -1), np.roll(below, -1)
    band = [np.stack([loop, after, below_after], axis=1), np.stack([loop, below_after, below], axis=1)]
    lid = np.array(cap(ring, list(range(len(loop))), set()), dtype=np.int64).reshape(-1, 3) + len(vertices)
    return RimExtrusion(ring, np.concatenate([*band, lid]))
