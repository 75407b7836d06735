"""Joining of closed parts that overlap, touch or nearly touch to one solid, on request.

The library Manifold (Apache-2.0) computes the union. Parts are swollen by a hundredth of their thickness, because
coincident faces, as of a pin in its hole, would leave many slits. Afterwards vertices return to their positions. Solids
that are still apart are bridged where they are nearest, along a spanning tree, so that no loops are made: a capsule at
each gap, half as thick as the solids there, and another union. Voids between parts, closed from outside, are filled; a
part's own cavities are left.

Manifold does not unite a solid with itself. So a box is put around each place where a part crosses itself. Inside it,
the limbs that cross are pieces of their own, and they are united with what is outside of the boxes: the points around
which the surface winds at least once. A place where a piece still crosses itself, as a fold, is left as it is.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from manifold3d import Manifold, Mesh64, OpType
from scipy import spatial
from scipy.cluster.hierarchy import DisjointSet

from msf_jax.base.writing import counted
from msf_jax.meshes.repair import WELD, radius_of
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import signed_volume, triangle_areas, unit, vertex_normals
from msf_jax.topology import graphs

SWELL = 0.01  # radii of a part, by which it is swollen for the union
TOUCH = WELD  # diagonals: solids closer than this touch
MOST_TRIES = 4  # rounds of bridging; each makes capsules twice as thick
PROJECTIONS = 4  # alternating projections between two surfaces that find the ends of a gap
# A capsule's radius: ratio to the thickness at its ends; least ratio to the smaller radius.
GLUE, THINNEST_CAPSULE = 0.5, 0.1
SECTIONS = 8  # sides of a capsule's circles
SAME = 1e-12  # diagonals: distance between a vertex of the union and the same vertex of a part, at most
MARGINS = 0.1, 0.3, 1.0  # sizes of a crossing, by which its box is larger on each side; the first that serves is taken
MOST_PLACES = 100  # crossings of a part that are tried; each costs some unions

MeshArrays = tuple[np.ndarray, np.ndarray]


class Joined(NamedTuple):
    """vertices: (V, 3). faces: (F, 3). source: (V,) the vertex of the parts, counted through all of them, or -1 for one
    that the union made. vertex_of_part: (P,) the new vertex for each vertex of the parts, or -1 if it is inside now or
    was cut away. repairs: the changes, a sentence each."""

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
    faces: list[int]

    @property
    def length(self) -> float:
        return float(np.linalg.norm(self.ends[1] - self.ends[0]))


class Untangled(NamedTuple):
    """vertices: (V, 3). faces: (F, 3). origin: (V,) the given vertex of each, or -1. num, num_left: places that were
    resolved, and those that were not."""

    vertices: np.ndarray
    faces: np.ndarray
    origin: np.ndarray
    num: int
    num_left: int


def joined(parts: Sequence[MeshArrays], reach: float) -> Joined:
    """Join ``parts``, closed surfaces oriented outwards: ``(vertices (n, 3), faces (m, 3))`` each.

    Parts that overlap become one; their cavities, wound inwards, stay. Gaps are bridged up to ``reach``, in diagonals
    of the whole mesh, or up to the radius of the smaller solid if that is larger. With a ``reach`` of 0, only solids
    that touch are bridged."""
    every = np.concatenate([vertices for vertices, _ in parts])
    low, high = every.min(axis=0), every.max(axis=0)
    centre, diagonal = low + (high - low) / 2, float(np.linalg.norm(high - low))
    simple = [untangled((vertices - centre) / diagonal, faces) for vertices, faces in parts]
    swollen = [_swollen(part.vertices, part.faces) for part in simple]
    solids = [solid_of(moved, part.faces) for moved, part in zip(swollen, simple, strict=True)]
    united = Manifold.batch_boolean(solids, OpType.Add)
    whole, voids = _filled(united), _given(solids, united)
    num_solids, repairs = len(whole.decompose()), []
    num_resolved, num_folds = sum(part.num for part in simple), sum(part.num_left for part in simple)
    if num_solids < len(parts):
        repairs.append(f"joined {len(parts)} parts that overlap or touch to {counted(num_solids, 'solid')}")
    elif len(parts) > 1:
        repairs.append(f"joined none of {len(parts)} parts by overlap")
    elif not num_resolved:
        repairs.append("joined nothing: one part")
    if num_resolved:
        repairs.append(f"resolved {counted(num_resolved, 'place')} where a part crossed itself")
    if num_folds:
        repairs.append(f"left {counted(num_folds, 'place')} where a part crosses itself, as a fold")
    if num_voids := len(_parted(united)[1]) - len(voids):
        repairs.append(f"filled {counted(num_voids, 'void')} between parts")
    whole = _bridged(whole, reach, diagonal, repairs)
    vertices, faces = arrays_of(_hollowed(whole, voids, united) if voids else whole)
    first = np.cumsum([0, *(len(own) for own, _ in parts)])[:-1]
    origin = np.concatenate([np.where(p.origin < 0, -1, p.origin + k) for p, k in zip(simple, first, strict=True)])
    of_simple = _same_place(np.concatenate(swollen), vertices)
    source = np.where(of_simple < 0, -1, origin[of_simple])
    back = np.where(of_simple[:, None] < 0, vertices, np.concatenate([part.vertices for part in simple])[of_simple])
    vertex_of_part = np.full(len(every), -1)
    vertex_of_part[source[source >= 0]] = np.flatnonzero(source >= 0)
    placed = np.where(source[:, None] < 0, centre + diagonal * back, every[source])
    return Joined(placed, faces, source, vertex_of_part, tuple(repairs))


def _same_place(known: np.ndarray, points: np.ndarray) -> np.ndarray:
    """(P,) one of ``known`` (K, 3) that coincides with each of ``points`` (P, 3), or -1."""
    away, found = spatial.KDTree(known).query(points, distance_upper_bound=SAME)
    return np.where(np.isfinite(away), found, -1)


def _bridged(whole: Manifold, reach: float, diagonal: float, repairs: list[str]) -> Manifold:
    """The solid with capsules over its gaps of up to ``reach``, and sentences about them in ``repairs``."""
    bodies, bridged = [Enclosure(*arrays_of(piece)) for piece in whole.decompose()], []
    num_solids = len(bodies)
    for tries in range(MOST_TRIES):
        gaps = _spanning(bodies, reach) if len(bodies) > 1 else []
        if not gaps:
            break
        bridged += [(gap.length, min(radius_of(bodies[gap.one]), radius_of(bodies[gap.other]))) for gap in gaps]
        capsules = [_capsule(bodies, gap, 2**tries) for gap in gaps]
        whole = _filled(Manifold.batch_boolean([whole, *capsules], OpType.Add))
        bodies = [Enclosure(*arrays_of(piece)) for piece in whole.decompose()]
    if bridged:
        longest, radius = max(bridged, key=lambda each: each[0])
        over = f"over gaps of up to {longest * diagonal:.3g} ({longest / radius:.2g} radii of the smaller)"
        over = over if longest > TOUCH else "that touch"
        repairs.append(f"joined {num_solids} solids to {len(bodies)} at {counted(len(bridged), 'place')} {over}")
    if len(bodies) > 1:
        largest = max(bodies, key=lambda body: np.linalg.norm(np.ptp(body.vertices, axis=0)))
        others = np.concatenate([body.vertices for body in bodies if body is not largest])
        gap = float(largest.distances(others).min())
        repairs.append(
            f"left {len(bodies)} solids apart: the largest is {gap * diagonal:.3g} from the next ({gap:.2g} diagonals; "
            "Repair(join=...) sets the largest gap)"
        )
    return whole


def _swollen(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """The vertices moved outwards by ``SWELL`` times the radius of the ball with the part's ratio of volume to area."""
    area = triangle_areas(vertices[faces]).sum()
    return vertices + SWELL * 3 * signed_volume(vertices, faces) / area * unit(vertex_normals(vertices, faces))


def _parted(whole: Manifold) -> tuple[list[Manifold], list[Manifold]]:
    """The surfaces of a solid: those around solids, and those around voids, wound inwards."""
    pieces = whole.decompose()
    return [piece for piece in pieces if piece.volume() > 0], [piece for piece in pieces if piece.volume() <= 0]


def _filled(whole: Manifold) -> Manifold:
    """The solid without its voids."""
    outer, voids = _parted(whole)
    return Manifold.batch_boolean(outer, OpType.Add) if voids else whole


def _given(parts: list[Manifold], united: Manifold) -> list[Manifold]:
    """The voids of ``united`` that are what is left of cavities of ``parts``, as solids."""
    cavities = [arrays_of(piece)[0] for part in parts for piece in _parted(part)[1]]
    if not cavities:
        return []
    known, found = np.concatenate(cavities), [arrays_of(piece) for piece in _parted(united)[1]]
    return [solid_of(x, faces[:, ::-1]) for x, faces in found if (_same_place(known, x) >= 0).any()]


def _hollowed(whole: Manifold, voids: list[Manifold], united: Manifold) -> Manifold:
    """The solid ``whole`` without ``voids``, but with the solids of ``united`` in them."""
    shapes = [Enclosure(*arrays_of(void)) for void in voids]
    within = [piece for piece in _parted(united)[0] if any(one.contains(arrays_of(piece)[0][:1])[0] for one in shapes)]
    return Manifold.batch_boolean([Manifold.batch_boolean([whole, *voids], OpType.Subtract), *within], OpType.Add)


def _spanning(bodies: list[Enclosure], reach: float) -> list[Gap]:
    """The gaps of a spanning tree that are short enough to bridge, shortest first: found between samples of the
    surfaces, and then measured between the surfaces."""
    radius = np.array([radius_of(body) for body in bodies])
    low, high = (np.array([end(body.vertices, axis=0) for body in bodies]) for end in (np.min, np.max))
    found = []
    for one in range(len(bodies) - 1):
        away = np.maximum(np.maximum(low[one + 1 :] - high[one], low[one] - high[one + 1 :]), 0)
        bound = np.maximum(np.minimum(radius[one + 1 :], radius[one]), reach) if reach > 0 else TOUCH
        for other in (one + 1 + np.flatnonzero(np.linalg.norm(away, axis=1) <= bound)).tolist():
            more, less = sorted((one, other), key=lambda each: -len(bodies[each].faces))
            points = np.asarray(bodies[less].samples.tree.data)
            distance = bodies[more].distances(points)
            found.append((float(distance.min()), more, less, points[distance.argmin()]))
    sets, gaps = DisjointSet(range(len(bodies))), list[Gap]()
    for _, one, other, point in sorted(found, key=lambda each: each[0]):
        if not sets.connected(one, other):
            gap, smaller = _measured(bodies, one, other, point), float(radius[[one, other]].min())
            if gap.length <= (max(smaller, reach) if reach > 0 else TOUCH):
                sets.merge(one, other)
                gaps.append(gap)
    return sorted(gaps, key=lambda gap: gap.length)


def _measured(bodies: list[Enclosure], one: int, other: int, end: np.ndarray) -> Gap:
    """The gap between two surfaces near the point ``end`` (3,) of the other one, by alternating projections."""
    ends, faces = [end, end], [0, 0]
    for step in range(2 * PROJECTIONS):
        here, body = step % 2, bodies[(one, other)[step % 2]]
        faces[here] = int(body.nearest(ends[1 - here][None])[1][0])
        ends[here] = _on_triangle(ends[1 - here], body.triangles[faces[here]])
    return Gap(one, other, np.stack(ends), faces)


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


def _capsule(bodies: list[Enclosure], gap: Gap, factor: float) -> Manifold:
    """The capsule that bridges ``gap``: the hull of two balls around its ends, ``factor`` times the usual thickness."""
    pair = bodies[gap.one], bodies[gap.other]
    smaller, chords = min(map(radius_of, pair)), []
    for body, end, face in zip(pair, gap.ends, gap.faces, strict=True):
        inward = -body.normals[[face]]
        chords.append(body.ray_lengths(end + TOUCH * inward, inward, np.array([4 * radius_of(body)]))[0])
    radius = factor * float(np.clip(GLUE * min(chords) / 2, THINNEST_CAPSULE * smaller, smaller))
    ball = arrays_of(Manifold.sphere(radius, SECTIONS))[0]
    return Manifold.hull_points(np.concatenate([ball + end for end in gap.ends]))


def untangled(vertices: np.ndarray, faces: np.ndarray) -> Untangled:
    """Resolve where the closed part ``vertices`` (V, 3), ``faces`` (F, 3) crosses itself."""
    shape = Enclosure(vertices, faces)
    pairs = shape.crossed.pairs
    places, boxes, strands = _places(shape, pairs) if len(pairs) else [], [], []
    whole = solid_of(vertices, faces)
    for low, high in places[:MOST_PLACES]:
        for margin in MARGINS:
            size = (1 + 2 * margin) * (high - low)
            box = Manifold.cube(size.tolist(), True).translate(((low + high) / 2).tolist())
            pieces = (whole ^ box).decompose()
            if len(pieces) > 1 and all(map(_is_simple, pieces)):
                boxes.append(box)
                strands += pieces
                break
    if not boxes:
        return Untangled(vertices, faces, np.arange(len(vertices)), 0, len(places))
    rest = Manifold.batch_boolean([whole, *boxes], OpType.Subtract)
    outer, voids = _parted(rest)  # what is left of a strand may be inside another's
    made, faces = arrays_of(Manifold.batch_boolean([*([rest] if voids else outer), *strands], OpType.Add))
    return Untangled(made, faces, _same_place(vertices, made), len(boxes), len(places) - len(boxes))


def solid_of(vertices: np.ndarray, faces: np.ndarray) -> Manifold:
    return Manifold(Mesh64(np.ascontiguousarray(vertices), np.ascontiguousarray(faces, dtype=np.uint64)))


def arrays_of(solid: Manifold) -> MeshArrays:
    mesh = solid.to_mesh64()
    return np.array(mesh.vert_properties)[:, :3], np.array(mesh.tri_verts).astype(np.int64)


def _is_simple(piece: Manifold) -> bool:
    """Whether a piece is a solid, no cavity, and does not cross itself."""
    return piece.volume() > 0 and not Enclosure(*arrays_of(piece)).crossed.pairs.size


def _places(shape: Enclosure, pairs: np.ndarray) -> list[tuple[np.ndarray, np.ndarray]]:
    """The boxes (low, high) around the places where faces cross, those that overlap united, largest first."""
    face, row = np.unique(pairs, return_inverse=True)
    one, other = row.reshape(pairs.shape).T
    # Faces that cross, and faces with a corner in common, are of one place.
    corner, of_face = shape.faces[face].ravel(), np.repeat(np.arange(len(face)), 3)
    ends = np.concatenate([one, of_face]), np.concatenate([other, len(face) + corner])
    place = graphs.labels(len(face) + len(shape.vertices), *ends)[: len(face)]
    low, high = shape.triangles[face].min(axis=1), shape.triangles[face].max(axis=1)
    while True:
        boxes = [(low[place == each].min(axis=0), high[place == each].max(axis=0)) for each in np.unique(place)]
        low, high = (np.array(each) for each in zip(*boxes, strict=True))
        reach = MARGINS[0] * (high - low)
        meet = ((low - reach)[:, None] <= (high + reach)[None]).all(axis=2)
        place = graphs.labels(len(low), *np.nonzero(meet & meet.T))
        if place.max() + 1 == len(low):
            return sorted(boxes, key=lambda box: -float(np.prod(box[1] - box[0])))
