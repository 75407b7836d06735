"""Cross-sections of the solid at nodes (area, perimeter, diameters), and the volume around each branch."""

from typing import NamedTuple

import numpy as np

from msf_jax.host import graphs
from msf_jax.host.solid import openings, sections
from msf_jax.host.solid.enclosure import Enclosure
from msf_jax.host.solid.geometry import cross, unit
from msf_jax.host.solid.solid import Solid

DIRECTIONS = 48  # directions in half a turn in which a section's width is measured, to an error of 0.1 %


class Profiles(NamedTuple):
    """Cross-sections at nodes (N,), in the caller's units, NaN where none was found. largest, least: diameters between
    parallel lines, as measured by a calliper."""

    area: np.ndarray
    perimeter: np.ndarray
    largest: np.ndarray
    least: np.ndarray


def profiles_of(solid: Solid, nodes: np.ndarray, tangents: np.ndarray, radii: np.ndarray) -> Profiles:
    """The sections of ``solid`` through ``nodes`` (N, 3), normal to ``tangents`` (N, 3), with radii of about ``radii``
    (N,).

    A node at an opening, or so near an oblique or uneven one that the plane cuts its lid, has the section just inside
    the rim, across the limb: of a tube that was cut off obliquely the tube's, and not the larger one of the rim.
    """
    num, points = len(nodes), openings.moved_inside(solid.enter(nodes), tangents, solid.openings)
    found = sections.corners(solid.shape, points, tangents, radii / solid.diagonal)
    unknown = np.full(num, np.nan)
    if not len(found.loop):
        return Profiles(unknown, unknown, unknown, unknown)
    place = found.places(solid.shape) - points[found.loop]
    first = np.flatnonzero(np.r_[True, found.loop[1:] != found.loop[:-1]])
    row = found.loop[first]
    onward = np.r_[place[1:], place[:1]]
    onward[np.r_[first[1:] - 1, len(place) - 1]] = place[first]
    area = sections.areas(solid.shape, found, tangents)[row]
    perimeter = np.add.reduceat(np.linalg.norm(onward - place, axis=1), first)
    across = unit(cross(tangents, np.eye(3)[np.abs(tangents).argmin(axis=1)]))
    beside = cross(tangents, across)
    u = np.einsum("ci,ci->c", place, across[found.loop])
    v = np.einsum("ci,ci->c", place, beside[found.loop])
    angle = np.pi * np.arange(DIRECTIONS) / DIRECTIONS
    shade = u[:, None] * np.cos(angle) + v[:, None] * np.sin(angle)
    width = np.maximum.reduceat(shade, first) - np.minimum.reduceat(shade, first)
    is_whole = found.is_closed[row] & (area > 0)

    def full(values: np.ndarray, power: int) -> np.ndarray:
        result = unknown.copy()
        result[row] = np.where(is_whole, values * solid.diagonal**power, np.nan)
        return result

    return Profiles(full(area, 2), full(perimeter, 1), full(width.max(axis=1), 1), full(width.min(axis=1), 1))


def swept_volumes(corners: np.ndarray, feet: np.ndarray, group: np.ndarray, num: int) -> np.ndarray:
    """(num,) the volume between the faces of each ``group`` (F,) and the curve.

    ``corners`` (F, 3, 3) of each face move straight to their ``feet`` (F, 3, 3) on the curve. The sides of the volume
    that a face sweeps are shared with its neighbours, so the volumes of all faces of a closed surface add up to the
    enclosed volume, because a curve encloses none.
    """

    def under(a: np.ndarray, b: np.ndarray, c: np.ndarray) -> np.ndarray:
        return np.einsum("fi,fi->f", a, cross(b, c)) / 6

    a, b = np.moveaxis(corners, 1, 0), np.moveaxis(feet, 1, 0)
    volume = under(*a) - under(*b)
    for k in range(3):  # a side is a ruled surface: take the mean of its two triangulations
        p, q = k, (k + 1) % 3
        one = under(a[q], a[p], b[p]) + under(a[q], b[p], b[q])
        other = under(a[q], a[p], b[q]) + under(a[p], b[p], b[q])
        volume = volume + (one + other) / 2
    return np.bincount(group, weights=volume, minlength=num)


def volumes_of(shape: Enclosure, nodes: np.ndarray, edges: np.ndarray, node_of_vertex: np.ndarray) -> np.ndarray:
    """(B,) the volume between each branch of a curve ``(nodes (N, 3), edges (E, 2))`` and the faces that belong to it.

    A face belongs to the branch of its first corner's node: ``node_of_vertex`` (V,), for the vertices of ``shape``.
    """
    branches = graphs.trace(len(nodes), edges)
    branch = np.full(len(nodes), -1)
    for number, path in reversed(list(enumerate(branches))):
        branch[path] = number
    node = node_of_vertex[shape.faces]
    return swept_volumes(shape.triangles, nodes[node], branch[node[:, 0]], len(branches))
