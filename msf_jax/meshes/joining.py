"""Joining of closed parts that overlap, touch or nearly touch to one solid, on request.

The library Manifold (Apache-2.0) computes the union. Where a part crosses itself, it is resolved before (see
`untangling`). Parts are swollen by a hundredth of their thickness, because
coincident faces, as of a pin in its hole, would leave many slits. Afterwards vertices return to their positions. Solids
that are still apart are bridged where they are nearest, along a spanning tree, so that no loops are made: a capsule at
each gap, half as thick as the solids there, and another union. Voids between parts, closed from outside, are filled; a
part's own cavities are left.
"""

from collections.abc import Sequence
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from scipy import spatial
from scipy.cluster.hierarchy import DisjointSet

from msf_jax.meshes.untangling import MeshArrays, Untangled, arrays_of, solid_of, untangled
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import signed_volume, unit, vertex_normals

if TYPE_CHECKING:
    from manifold3d import Manifold

SWELL = 0.01  # radii of a part, by which it is swollen for the union
TOUCH = 1e-6  # diagonals: solids closer than this touch
MOST_SITES = 60_000  # sample points on faces, besides vertices, between which gaps are measured
MOST_TRIES = 4  # rounds of bridging; each makes capsules twice as thick
MOST_PAIRS = 20_000  # pairs of solids whose gap is measured, those with the nearest boxes first
PROJECTIONS = 4  # alternating projections between two surfaces that find the ends of a gap
# A capsule's radius: ratio to the thickness at its ends; least ratio to the smaller radius.
GLUE, THINNEST_CAPSULE = 0.5, 0.1
SECTIONS = 8  # sides of a capsule's circles
SAME = 1e-12  # diagonals: distance between a vertex of the union and the same vertex of a part, at most


class Joined(NamedTuple):
    """The result of joining parts.

    vertices: (V, 3). faces: (F, 3). source: (V,) the vertex of the parts, counted through all of them, or -1 for one
    that the union made. vertex_of_part: (P,) the new vertex for each vertex of the parts, or -1 if it is inside now or
    was cut away. repairs: the changes, a sentence each.
    """

    vertices: np.ndarray
    faces: np.ndarray
    source: np.ndarray
    vertex_of_part: np.ndarray
    repairs: tuple[str, ...]


class Gap(NamedTuple):
    """The nearest points of two solids, ``one`` and ``other``. ends: (2, 3). faces: the faces of the ends."""

    one: int
    other: int
    ends: np.ndarray
    faces: tuple[int, int]

    @property
    def length(self) -> float:
        return float(np.linalg.norm(self.ends[1] - self.ends[0]))


class ClosedSurface:
    """One closed connected surface, oriented outwards, in diagonals of the whole mesh.

    vertices: (V, 3). faces: (F, 3). radius: of the ball with its ratio of volume to area. size: its box's diagonal.
    """

    def __init__(self, solid: "Manifold") -> None:
        self.vertices, self.faces = arrays_of(solid)
        self.radius = 3 * solid.volume() / solid.surface_area()
        self.size = float(np.linalg.norm(np.ptp(self.vertices, axis=0)))

    @cached_property
    def shape(self) -> Enclosure:
        return Enclosure(self.vertices, self.faces)

    def foot(self, point: np.ndarray) -> tuple[np.ndarray, int]:
        """The point of the surface that is nearest to ``point`` (3,), and its face."""
        face = int(self.shape.nearest(point[None])[1][0])
        return _on_triangle(point, self.shape.triangles[face]), face

    def thickness(self, point: np.ndarray, face: int) -> float:
        """Half of the distance through the solid from a ``point`` (3,) of its ``face``, at most two radii."""
        a, b, c = self.shape.triangles[face]
        inward = -unit(np.cross(b - a, c - a))[None]
        return float(self.shape.ray_lengths(point[None] + TOUCH * inward, inward, np.array([4 * self.radius]))[0]) / 2


def joined(parts: Sequence[MeshArrays], reach: float) -> Joined:
    """Join ``parts``, closed surfaces oriented outwards: ``(vertices (n, 3), faces (m, 3))`` each.

    Parts that overlap become one; their cavities, wound inwards, stay. Gaps are bridged up to ``reach``, in diagonals
    of the whole mesh, or up to the radius of the smaller solid if that is larger. With a ``reach`` of 0, only solids
    that touch are bridged.
    """
    from manifold3d import Manifold, OpType  # imported here, because most runs do not need it

    every = np.concatenate([vertices for vertices, _ in parts])
    low, high = every.min(axis=0), every.max(axis=0)
    centre, diagonal = low + (high - low) / 2, float(np.linalg.norm(high - low))
    simple = [untangled((vertices - centre) / diagonal, faces) for vertices, faces in parts]
    swollen = [_swollen(part.vertices, part.faces) for part in simple]
    solids = [solid_of(moved, part.faces) for moved, part in zip(swollen, simple, strict=True)]
    united = Manifold.batch_boolean(solids, OpType.Add)
    whole, voids = _filled(united), _given(solids, united)
    num_voids = len(_parted(united)[1]) - len(voids)
    pieces = whole.decompose()
    repairs = [_overlapped(len(parts), len(pieces))] if len(parts) > 1 or not any(part.num for part in simple) else []
    if num := sum(part.num for part in simple):
        repairs.append(f"resolved {_count(num, 'place')} where a part crossed itself")
    if num := sum(part.num_left for part in simple):
        repairs.append(f"left {_count(num, 'place')} where a part crosses itself, as a fold")
    if num_voids:
        repairs.append(f"filled {_count(num_voids, 'void')} between parts")
    bodies, bridged, num_unmeasured = [ClosedSurface(piece) for piece in pieces], [], 0
    for tries in range(MOST_TRIES):
        if len(bodies) == 1:
            break
        gaps, num_unmeasured = _spanning(bodies, reach)
        if not gaps:
            break
        bridged += [(gap, min(bodies[gap.one].radius, bodies[gap.other].radius)) for gap in gaps]
        capsules = [_capsule(bodies, gap, 2**tries) for gap in gaps]
        whole = _filled(Manifold.batch_boolean([whole, *capsules], OpType.Add))
        bodies = [ClosedSurface(piece) for piece in whole.decompose()]
    if bridged:
        repairs.append(_joined_over(len(pieces), len(bodies), bridged, diagonal))
    if len(bodies) > 1:
        repairs.append(_apart(bodies, diagonal))
    if num_unmeasured:
        repairs.append(f"left {_count(num_unmeasured, 'pair')} of solids unmeasured: over {MOST_PAIRS} are near")
    vertices, faces = arrays_of(_hollowed(whole, voids, united) if voids else whole)
    larger = np.concatenate(swollen)
    of_simple, vertex = _same_place(larger, vertices), _same_place(vertices, larger)
    back = np.where(of_simple[:, None] < 0, vertices, np.concatenate([part.vertices for part in simple])[of_simple])
    origin, image = _identities([(x - centre) / diagonal for x, _ in parts], simple)
    source = np.where(of_simple < 0, -1, origin[of_simple])
    vertex_of_part = np.where(image < 0, -1, vertex[image])
    placed = np.where(source[:, None] < 0, centre + diagonal * back, every[source])
    return Joined(placed, faces, source, vertex_of_part, tuple(repairs))


def _identities(given: list[np.ndarray], simple: list[Untangled]) -> tuple[np.ndarray, np.ndarray]:
    """The vertex of the ``given`` parts for each of the ``simple`` ones, through all, or -1; and the reverse."""
    origin, image, first, last = [], [], 0, 0
    for before, after in zip(given, simple, strict=True):
        if after.num:
            there, here = _same_place(before, after.vertices), _same_place(after.vertices, before)
        else:
            there = here = np.arange(len(before))
        origin.append(np.where(there < 0, -1, there + first))
        image.append(np.where(here < 0, -1, here + last))
        first, last = first + len(before), last + len(after.vertices)
    return np.concatenate(origin), np.concatenate(image)


def _same_place(known: np.ndarray, points: np.ndarray) -> np.ndarray:
    """(P,) one of ``known`` (K, 3) that coincides with each of ``points`` (P, 3), or -1."""
    away, found = spatial.KDTree(known).query(points, distance_upper_bound=SAME)
    return np.where(np.isfinite(away), found, -1)


def _count(number: int, what: str) -> str:
    return f"{number} {what}{'' if number == 1 else 's'}"


def _overlapped(num_parts: int, num_bodies: int) -> str:
    if num_bodies < num_parts:
        return f"joined {num_parts} parts that overlap or touch to {_count(num_bodies, 'solid')}"
    return f"joined none of {_count(num_parts, 'part')} by overlap" if num_parts > 1 else "joined nothing: one part"


def _joined_over(before: int, after: int, bridged: list[tuple[Gap, float]], diagonal: float) -> str:
    gap, radius = max(bridged, key=lambda one: one[0].length)
    over = "that touch"
    if gap.length > TOUCH:
        over = f"over gaps of up to {gap.length * diagonal:.3g} ({gap.length / radius:.2g} radii of the smaller)"
    return f"joined {before} solids to {after} at {_count(len(bridged), 'place')} {over}"


def _apart(bodies: list[ClosedSurface], diagonal: float) -> str:
    """The report about solids that stay apart, with the distance from the largest to the next."""
    largest = max(bodies, key=lambda body: body.size)
    others = np.concatenate([body.vertices for body in bodies if body is not largest])
    gap = float(largest.shape.distances(others).min())
    return (
        f"left {len(bodies)} solids apart: the largest is {gap * diagonal:.3g} from the next ({gap:.2g} diagonals; "
        "Repair(join=...) sets the largest gap)"
    )


def _swollen(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """The vertices moved outwards by ``SWELL`` times the radius of the ball with the part's ratio of volume to area."""
    a, b, c = np.moveaxis(vertices[faces], 1, 0)
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2
    return vertices + SWELL * 3 * signed_volume(vertices, faces) / area * unit(vertex_normals(vertices, faces))


def _parted(whole: "Manifold") -> tuple[list["Manifold"], list["Manifold"]]:
    """The surfaces of a solid: those around solids, and those around voids, wound inwards."""
    pieces = whole.decompose()
    return [piece for piece in pieces if piece.volume() > 0], [piece for piece in pieces if piece.volume() <= 0]


def _filled(whole: "Manifold") -> "Manifold":
    """The solid without its voids."""
    from manifold3d import Manifold, OpType

    outer, voids = _parted(whole)
    return Manifold.batch_boolean(outer, OpType.Add) if voids else whole


def _given(parts: list["Manifold"], united: "Manifold") -> list["Manifold"]:
    """The voids of ``united`` that are what is left of cavities of ``parts``, as solids."""
    cavities = [arrays_of(piece)[0] for part in parts for piece in _parted(part)[1]]
    if not cavities:
        return []
    known, found = np.concatenate(cavities), [arrays_of(piece) for piece in _parted(united)[1]]
    return [solid_of(x, faces[:, ::-1]) for x, faces in found if (_same_place(known, x) >= 0).any()]


def _hollowed(whole: "Manifold", voids: list["Manifold"], united: "Manifold") -> "Manifold":
    """The solid ``whole`` without ``voids``, but with the solids of ``united`` in them."""
    from manifold3d import Manifold, OpType

    shapes = [Enclosure(*arrays_of(void)) for void in voids]
    within = [piece for piece in _parted(united)[0] if any(one.contains(arrays_of(piece)[0][:1])[0] for one in shapes)]
    return Manifold.batch_boolean([Manifold.batch_boolean([whole, *voids], OpType.Subtract), *within], OpType.Add)


def _spanning(bodies: list[ClosedSurface], reach: float) -> tuple[list[Gap], int]:
    """The gaps of a spanning tree that are short enough to bridge, shortest first, and the number of unmeasured pairs.

    Gaps are found between sample points of the surfaces, and then measured between the surfaces.
    """
    radius = np.array([body.radius for body in bodies])
    spacing, sites = _sites(bodies)
    pairs, bounds = _near_pairs(bodies, radius, reach)
    trees: dict[int, spatial.KDTree] = {}
    found = []
    for (one, other), bound in zip(pairs[:MOST_PAIRS].tolist(), bounds.tolist(), strict=False):
        if len(sites[one]) < len(sites[other]):
            one, other = other, one
        if one not in trees:
            trees[one] = spatial.KDTree(sites[one])
        away, place = trees[one].query(sites[other], distance_upper_bound=bound + spacing)
        nearest = int(np.argmin(away))
        if away[nearest] < np.inf:
            found.append((float(away[nearest]), one, other, int(np.asarray(place)[nearest]), nearest, bound))
    sets, bridged = DisjointSet(range(len(bodies))), []
    for _, one, other, at_one, at_other, bound in sorted(found):
        if not sets.connected(one, other):
            gap = _measured(bodies, one, other, sites[one][at_one], sites[other][at_other])
            if gap.length <= bound:
                sets.merge(one, other)
                bridged.append(gap)
    return bridged, max(len(pairs) - MOST_PAIRS, 0)


def _near_pairs(bodies: list[ClosedSurface], radius: np.ndarray, reach: float) -> tuple[np.ndarray, np.ndarray]:
    """Pairs (n, 2) of bodies whose boxes are near enough for a bridge, nearest first, and its largest length."""
    low = np.array([body.vertices.min(axis=0) for body in bodies])
    high = np.array([body.vertices.max(axis=0) for body in bodies])
    pairs, bounds, gaps = [], [], []
    for number in range(len(bodies) - 1):
        after = slice(number + 1, None)
        away = np.maximum(np.maximum(low[after] - high[number], low[number] - high[after]), 0)
        gap = np.linalg.norm(away, axis=1)
        bound = np.maximum(np.minimum(radius[after], radius[number]), reach) if reach > 0 else np.full(len(gap), TOUCH)
        near = np.flatnonzero(gap <= bound)
        pairs.append(np.stack([np.full(len(near), number), number + 1 + near], axis=1))
        bounds.append(bound[near])
        gaps.append(gap[near])
    order = np.argsort(np.concatenate(gaps), kind="stable")
    return np.concatenate(pairs)[order], np.concatenate(bounds)[order]


def _sites(bodies: list[ClosedSurface]) -> tuple[float, list[np.ndarray]]:
    """The spacing of sample points on large faces, and sample points of each surface, with its vertices."""
    corners = [body.vertices[body.faces] for body in bodies]
    a, b, c = np.moveaxis(np.concatenate(corners), 1, 0)
    spacing = float(np.sqrt(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / MOST_SITES))
    sites = []
    for body, triangles in zip(bodies, corners, strict=True):
        longest = np.linalg.norm(triangles - np.roll(triangles, 1, axis=1), axis=2).max(axis=1)
        parts = np.ceil(longest / spacing).astype(int)
        points = [body.vertices]
        for num in np.unique(parts[parts > 1]).tolist():
            i, j = np.divmod(np.arange((num + 1) ** 2), num + 1)
            share = np.stack([i, j, num - i - j], axis=1)[i + j <= num] / num
            points.append(np.einsum("sk,tkx->tsx", share, triangles[parts == num]).reshape(-1, 3))
        sites.append(np.concatenate(points))
    return spacing, sites


def _measured(bodies: list[ClosedSurface], one: int, other: int, at_one: np.ndarray, at_other: np.ndarray) -> Gap:
    """The gap between two surfaces near the points ``at_one`` and ``at_other`` (3,), by alternating projections."""
    start, end, first, last = at_one, at_other, 0, 0
    for _ in range(PROJECTIONS):
        start, first = bodies[one].foot(end)
        end, last = bodies[other].foot(start)
    return Gap(one, other, np.stack([start, end]), (first, last))


def _capsule(bodies: list[ClosedSurface], gap: Gap, factor: float) -> "Manifold":
    """The capsule that bridges ``gap``: the hull of two balls around its ends, ``factor`` times the usual thickness."""
    from manifold3d import Manifold

    pair = bodies[gap.one], bodies[gap.other]
    smaller = min(body.radius for body in pair)
    thickness = min(body.thickness(end, face) for body, end, face in zip(pair, gap.ends, gap.faces, strict=True))
    radius = factor * float(np.clip(GLUE * thickness, THINNEST_CAPSULE * smaller, smaller))
    ball = arrays_of(Manifold.sphere(radius, SECTIONS))[0]
    return Manifold.hull_points(np.concatenate([ball + end for end in gap.ends]))


def _on_triangle(point: np.ndarray, triangle: np.ndarray) -> np.ndarray:
    """The point of ``triangle`` (3, 3) nearest to ``point`` (3,): inside it, or on its nearest edge."""
    a, b, c = triangle
    normal = unit(np.cross(b - a, c - a))
    foot = point - ((point - a) @ normal) * normal
    ahead = np.roll(triangle, -1, axis=0) - triangle
    if (np.cross(ahead, foot - triangle) @ normal >= 0).all() and normal.any():
        return foot
    share = ((point - triangle) * ahead).sum(axis=1) / np.maximum((ahead**2).sum(axis=1), 1e-300)
    feet = triangle + np.clip(share, 0, 1)[:, None] * ahead
    return feet[np.linalg.norm(feet - point, axis=1).argmin()]
