"""Extrusion of the rim of a hole whose lid would cut through the surface; a flat lid closes the extruded rim.

The lid over the uneven rim of a height field or a bent sheet passes above the surface in some places and below it in
others. The closed surface is then several solids that meet in curves, and no skeleton can stay inside. The area vector
of the surface (the sum of its faces' normals times areas, which depends on the rim only) gives the direction of its
front; the inside is behind it. The rim is extruded backwards, past all of the piece, and closed there, like the base of
a relief; or forwards, if that is better. The extrusion has a new vertex for each vertex of the rim.
"""

from typing import NamedTuple

import numpy as np

from msf_jax.meshes.filling import Hole, lid_of
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import signed_volume, unit
from msf_jax.topology import graphs
from msf_jax.topology.half_edges import by_label

LARGEST_CUT = 0.01  # share of a piece's area whose inner side is outside of the closed solid, at most
MARGIN = 0.05  # extents of the rim: distance between the piece and the end of the extrusion
FLAT = 1e-6  # extents of the rim: a rim of less height has a flat lid, which needs no extrusion
FEWEST_FACES = 100  # faces of a piece whose rim may be extruded: smaller pieces are fragments
MOST_TESTED = 200  # pieces with an uneven rim that are tested, those with the most faces first
BESIDE = 1e-5  # extents of the piece: depth below the centre of a face of the point that is tested to be inside


class Extruded(NamedTuple):
    """A surface without holes.

    vertices: (V, 3), those given, then those of extrusions. faces: (F, 3). source: (M,) the vertex of the rim for each
    new vertex. repairs: the changes, a sentence each.
    """

    vertices: np.ndarray
    faces: np.ndarray
    source: np.ndarray
    repairs: list[str]


class RimExtrusion(NamedTuple):
    """ring: (n, 3) the new vertices, in the order of the rim. faces: (S, 3) those of the extrusion and its lid."""

    ring: np.ndarray
    faces: np.ndarray


def extruded(vertices: np.ndarray, faces: np.ndarray, holes: list[Hole]) -> Extruded:
    """The surface of ``faces`` (F, 3) with the lids of ``holes``; a rim is extruded if its lid cuts through the piece.

    Only the longest rim of a piece can be extruded.
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
        rims = "1 rim, whose lid" if len(instead) == 1 else f"{len(instead)} rims, whose lids"
        repairs.append(f"extruded {rims} would cut through the surface: {made} new vertices")
    if num_kept:
        lids = "the lid of 1 hole cuts" if num_kept == 1 else f"the lids of {num_kept} holes cut"
        repairs.append(f"{lids} through the surface, and so would an extruded rim: the curve may be outside there")
    if len(uneven) > MOST_TESTED:
        repairs.append(f"tested lids only in the largest {MOST_TESTED} of {len(uneven)} pieces with uneven rims")
    lids = [instead.get(number, hole.lid) for number, hole in enumerate(holes)]
    return Extruded(np.concatenate(rings), np.concatenate([faces, *lids]), np.concatenate(sources), repairs)


def share_cut_off(vertices: np.ndarray, faces: np.ndarray, num_given: int) -> float:
    """The share of the area of the first ``num_given`` of closed ``faces`` (F, 3) whose inner side is outside."""
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
    """For each large piece whose longest rim is uneven: that hole, the piece's faces, its other holes.

    Pieces with the most faces come first.
    """
    if not holes:
        return []
    label = graphs.labels_of_faces(faces, len(vertices))
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
    """(3,) twice the area vector of any surface bounded by the loop ``rim`` (n, 3)."""
    around = rim - rim.mean(axis=0)
    return np.cross(around, np.roll(around, -1, axis=0)).sum(axis=0)


def _extrusion(vertices: np.ndarray, faces: np.ndarray, loop: np.ndarray, side: int) -> RimExtrusion:
    """The extrusion of the rim ``loop`` (n,) past the piece of ``faces``; new vertices count from ``len(vertices)``.

    With ``side`` 1 it goes in the direction of the lid's normal, behind the surface; with -1 in the other direction.
    """
    rim = vertices[loop]
    along = side * unit(_area_vector(rim))
    end = (vertices[np.unique(faces)] @ along).max() + MARGIN * np.ptp(rim, axis=0).max()
    ring = rim + (end - rim @ along)[:, None] * along
    below = len(vertices) + np.arange(len(loop))
    after, below_after = np.roll(loop, -1), np.roll(below, -1)
    band = [np.stack([loop, after, below_after], axis=1), np.stack([loop, below_after, below], axis=1)]
    lid = np.array(lid_of(ring, list(range(len(loop))), set()), dtype=np.int64).reshape(-1, 3) + len(vertices)
    return RimExtrusion(ring, np.concatenate([*band, lid]))
