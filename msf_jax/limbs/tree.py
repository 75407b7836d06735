"""The limbs of a solid: arcs of the merge tree of a function on its surface.

Let f grow towards the ends of limbs. Sweep f from the top down: the surface above a level is a number of components.
Each begins at a maximum of f, and two become one at a saddle. An *arc* of the tree is a component between such events
(Carr, Snoeyink, Axen 2003). At each of its levels a component has an area A, and rings that cut it off: level sets of
f. If one ring of length P cuts it off, its *slenderness* is

    2 pi A / P^2 - 1 / 2,

0 for a flat disc, 1 / 2 for half a ball, and h / radius for a cylinder that sticks out by h from a larger body. Where
the arc ends, its *persistence* is how far its top is above that level, in radii P / 2 pi of the ring.

f is the average geodesic distance (Hilaga, Shinagawa, Kohmura, Kunii 2001). A limb is an arc that stands out enough, by
its persistence, and upon which no other such arc stands; see `LimbTree.limbs`. A solid without handles that has fewer
than three slender limbs has one branch from end to end: in a sheet, the places with the largest average distance are
its corners. Its limbs are the two halves by the first eigenfunction of its Laplacian, or, where a half has several ends
as the head of a hammer has, the arcs of the mean exit time from that half (see `ends`).
"""

from collections.abc import Callable
from functools import cached_property
from typing import NamedTuple

import numpy as np

from msf_jax.limbs import ends, fronts
from msf_jax.limbs.levels import Levels, levels
from msf_jax.meshes.reconnecting import reconnected
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.frame import RESOLUTION
from msf_jax.solid.geometry import largest_of_each, triangle_areas
from msf_jax.topology import graphs

SOURCES = 32  # points, far from each other, whose distances are averaged; with 16, mirrored limbs differ by a sixth
DIGITS = 6  # of distances that are compared: those of a symmetric solid differ by rounding
SPLIT = 1_000  # squares of the longest edge that a component's area may have at least: rings follow its limbs then
LEVELS = 800  # of a function on a component
OFFSET = 0.37  # steps: from the lowest vertex to one of them, so that no level goes through many vertices
WHOLE, HALF = 0.97, 0.5  # of the component's area, without and with handles: what is larger is no limb of it
FEWEST = 6  # vertices of a limb, and levels of an arc: fewer are noise of the triangles
# Radii: least persistence of a limb at the detail 0.5, over the least slenderness, 0.5. Ears, noses and snouts have
# 0.46 and more, corners of a block 0.28, those of a thin plate up to 0.4.
PERSISTENCE = 0.8
FLAT = -0.08  # slenderness of an elliptic disc of 2 : 1, the least of a limb: less, and a ring is no section
FINEST = 0.95  # detail: any limb that could stand out


class Arcs(NamedTuple):
    """The merge tree of a function. A parent comes after its children.

    top: (a,) the highest vertex of each arc. parent: (a,), -1 at a root. persistence: (a,) at the last level that
    counts, -inf without enough of them. of_vertex, value: (V,) the arc of each vertex, and the function.

    The levels of all arcs, each arc's from its top down: arc (r,), height (r,), area (r,) above, and slenderness (r,)
    of the ring that cuts it off, -inf where that cuts off no limb.
    """

    top: np.ndarray
    parent: np.ndarray
    persistence: np.ndarray
    of_vertex: np.ndarray
    value: np.ndarray
    arc: np.ndarray
    height: np.ndarray
    area: np.ndarray
    slenderness: np.ndarray

    def bases(self) -> np.ndarray:
        """(a,) the level (r,) of the most slender ring of each arc, -1 without one that counts."""
        found = np.full(len(self.top), -1)
        order = np.argsort(self.slenderness, kind="stable")
        order = order[self.slenderness[order] > -np.inf]
        found[self.arc[order]] = order
        return found

    def slenderness_of_arcs(self) -> np.ndarray:
        """(a,) the largest slenderness of each arc's rings, -inf without one that counts."""
        found = np.full(len(self.top), -np.inf)
        np.maximum.at(found, self.arc, self.slenderness)
        return found

    def standing_on(self, chosen: list[int]) -> np.ndarray:
        """(a,) which of the ``chosen`` arcs, by its place there, each arc is or stands on; -1 for none."""
        found = np.full(len(self.parent) + 1, -1)
        found[chosen] = np.arange(len(chosen))
        for arc in range(len(self.parent) - 1, -1, -1):
            found[arc] = max(found[arc], found[self.parent[arc]])
        return found[:-1]


class Limb(NamedTuple):
    """tip: the highest vertex. region: (r,) its vertices, up to its base, the most slender ring. area: of that.
    slenderness: of its base. detail: the least at which it is a limb (see `Config`). place: (3,) of the tip."""

    tip: int
    region: np.ndarray
    area: float
    slenderness: float
    detail: float
    place: np.ndarray


class Limbs(NamedTuple):
    """The limbs of a surface. owner: (V,) the number of the limb of each vertex, from 1; 0 for none. time: (V,) the
    mean exit time from it (see `ends`). finer: those of a finer detail, the coarsest first."""

    limbs: list[Limb]
    owner: np.ndarray
    time: np.ndarray
    finer: list[Limb]


class Patch(NamedTuple):
    """A component of a surface. member: (v,) the numbers of its vertices, which follow each other. points: (v, 3).
    faces: (f, 3). is_ball: without handles."""

    member: np.ndarray
    points: np.ndarray
    faces: np.ndarray
    is_ball: bool


class LimbTree:
    """The merge trees of the closed surface ``shape``, whose long triangles are split."""

    parts: list[Patch]  # its components

    def __init__(self, shape: Enclosure):
        if ((faces := reconnected(shape.vertices, shape.faces)) != shape.faces).any():
            shape = Enclosure(shape.vertices, faces)
        self.parts, self._found = _patches(shape), dict[tuple[float, float], Limbs]()
        points = np.concatenate([part.points for part in self.parts])
        faces = np.concatenate([part.member[part.faces] for part in self.parts])
        self.shape = shape if np.array_equal(points, shape.vertices) else Enclosure(points, faces)
        self._component = np.repeat(np.arange(len(self.parts)), [len(part.points) for part in self.parts])

    @cached_property
    def _away(self) -> Callable[[np.ndarray], np.ndarray]:
        """See `fronts.distances`."""
        return fronts.distances(self.shape)

    @cached_property
    def trees(self) -> list[Arcs]:
        """Of each component, the merge tree of the average geodesic distance."""
        height = average_distance(self.shape, self._component, self._away)
        return [
            merge_tree(part.points, part.faces, height[part.member], WHOLE if part.is_ball else HALF)
            for part in self.parts
        ]

    def limbs(self, least: float, detail: float) -> Limbs:
        """The limbs of at least the slenderness ``least``, or that stand out enough for the ``detail``.

        At a detail d, a persistence of `PERSISTENCE` ``least`` (1 - d) / d is enough; of slender ones, always that of
        the detail 0.5. On a component with handles only slender ones count: others are often the blunt ends of a body
        around a hole.
        """
        if (least, detail) not in self._found:
            self._found[least, detail] = self._search(least, detail)
        return self._found[least, detail]

    def _search(self, least: float, detail: float) -> Limbs:
        limbs, finer, halves = list[Limb](), list[Limb](), list[Limb]()
        for part, arcs in zip(self.parts, self.trees, strict=True):
            chosen = limbs_among(arcs, least, 0.0)
            if not part.is_ball:
                limbs += _limbs_of(part, arcs, chosen, least)
            elif len(chosen) < 3:
                halves += _halves(part)
            else:
                chosen = limbs_among(arcs, least, detail)
                limbs += _limbs_of(part, arcs, chosen, least)
                more = _limbs_of(part, arcs, limbs_among(arcs, least, FINEST), least)
                finer += [each for each in more if each.tip not in part.member[arcs.top[chosen]]]
        limbs += self._parted(halves, least, detail)
        owner, time = self._times(limbs)
        return Limbs(limbs, owner, time, sorted(finer, key=lambda each: each.detail))

    def _parted(self, halves: list[Limb], least: float, detail: float) -> list[Limb]:
        """The halves of components, or the limbs of a half that has more than one, as the head of a hammer has.

        The function is how far from the half's end the mean exit time is, see `ends`.
        """
        owner, time = self._times(halves)
        last = np.zeros(len(halves) + 1)
        np.maximum.at(last, owner, time)
        whole = np.sqrt(2 * last)[owner]
        height = whole - np.sqrt(np.maximum(whole**2 - 2 * time, 0.0))
        found: dict[int, list[Limb]] = {}
        for part in self.parts:
            if height[part.member].any():
                arcs = merge_tree(part.points, part.faces, height[part.member], WHOLE, whole[part.member])
                for each in _limbs_of(part, arcs, limbs_among(arcs, least, detail), least):
                    found.setdefault(int(owner[each.tip]), []).append(each)
        parted = list[Limb]()
        for number, half in enumerate(halves, 1):
            own = found.get(number, [])
            if len(own) < 2:
                parted.append(half)
                continue
            near = np.argmin([self._away(np.array([each.tip]))[half.region] for each in own], axis=0)
            parted += [each._replace(region=half.region[near == k]) for k, each in enumerate(own)]
        return parted

    def _times(self, limbs: list[Limb]) -> tuple[np.ndarray, np.ndarray]:
        """(V,) the number of the limb of each vertex, from 1, and the mean exit time from it; 0 for none."""
        owner = np.zeros(len(self.shape.vertices), dtype=np.int64)
        for number, each in enumerate(limbs, 1):
            owner[each.region] = number
        return owner, ends.exit_times(self.shape.vertices, self.shape.faces, owner)

    def axis(self, shape: Enclosure, limbs: Limbs, number: int) -> ends.LimbAxis:
        """The curve of one of the limbs in the solid ``shape``."""
        return ends.axis(shape, self.shape.vertices, self.shape.faces, limbs.time, limbs.limbs[number].region)

    def slenderness(self, feet: np.ndarray) -> np.ndarray:
        """(l,) the slenderness of the largest part of the surface around each of the vertices ``feet`` (l,) without
        another one of them: at the most slender of its rings, 0 without one."""
        found = np.zeros(len(feet))
        for part, arcs in zip(self.parts, self.trees, strict=True):
            mine = np.flatnonzero(np.isin(feet, part.member))
            found[mine] = _slenderness_around(arcs, np.searchsorted(part.member, feet[mine]))
        return found


def _patches(shape: Enclosure) -> list[Patch]:
    """The components of a surface, each with its long triangles split as if it were alone."""
    from manifold3d import Manifold, Mesh64

    found, num = list[Patch](), 0
    of_face = graphs.labels_of_faces(shape.faces, len(shape.vertices))[shape.faces[:, 0]]
    first = np.cumsum(np.unique(of_face, return_counts=True)[1])[:-1]  # a vertex without a face has a label, too
    for faces in np.split(shape.faces[np.argsort(of_face, kind="stable")], first):
        member, faces = np.unique(faces, return_inverse=True)
        x, faces = shape.vertices[member], faces.reshape(-1, 3)
        corners = x[faces]
        finest = float(np.sqrt(triangle_areas(corners).sum() / SPLIT))
        if (np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2) > finest).any():
            mesh = Manifold(Mesh64(x, faces.astype(np.uint64))).refine_to_length(finest).to_mesh64()
            x, faces = np.array(mesh.vert_properties[:, :3]), np.array(mesh.tri_verts, dtype=np.int64)
        found.append(Patch(np.arange(num, num + len(x)), x, faces, 2 * len(x) - len(faces) == 4))  # Euler's formula
        num += len(x)
    return found


def _slenderness_around(arcs: Arcs, feet: np.ndarray) -> np.ndarray:
    """See `LimbTree.slenderness`; ``feet`` (l,) are vertices of the component."""
    found = np.zeros(len(feet))
    inner, level = np.zeros((len(arcs.parent) + 1, 2), dtype=np.int64), np.zeros((len(arcs.arc), 2), dtype=np.int64)
    own = inner.copy()
    for number, vertex in enumerate(feet.tolist()):  # how many feet are above each level, and the sum of their numbers
        arc = arcs.of_vertex[vertex]
        own[arc] += 1, number
        level[(arcs.arc == arc) & (arcs.height <= arcs.value[vertex])] += 1, number
    for arc, parent in enumerate(arcs.parent.tolist()):
        inner[parent] += inner[arc] + own[arc]
    level += inner[arcs.arc]
    is_alone = level[:, 0] == 1
    np.maximum.at(found, level[is_alone, 1], arcs.slenderness[is_alone])
    return found


def details(arcs: Arcs, least: float) -> np.ndarray:
    """(a,) the least detail at which each arc is a limb (see `LimbTree.limbs`); infinite if at none."""
    slenderness, need = arcs.slenderness_of_arcs(), PERSISTENCE * least
    found = need / (need + np.maximum(arcs.persistence, 1e-300))
    found[(slenderness < FLAT) | (arcs.persistence <= 0)] = np.inf
    found[(slenderness >= least) & (found <= 0.5)] = 0.0
    return found


def limbs_among(arcs: Arcs, least: float, detail: float) -> list[int]:
    """The arcs that are limbs, upon which no other limb stands. Where one limb that only stands out is upon a slender
    one, that is the limb: the other is a corner of its end."""
    needed = details(arcs, least)
    upon = [list[int]() for _ in range(len(needed) + 1)]
    for arc, parent in enumerate(arcs.parent.tolist()):
        is_corner = needed[arc] == 0 and len(upon[arc]) == 1 and needed[upon[arc][0]] > 0
        if needed[arc] <= detail and (not upon[arc] or is_corner):
            upon[arc] = [arc]
        upon[parent] += upon[arc]
    return sorted(upon[-1])


def _halves(part: Patch) -> list[Limb]:
    """The halves of a component, as limbs (see `ends.halves`)."""
    value, found = ends.halves(part.points, part.faces)[0], []
    share = np.bincount(part.faces.ravel(), np.repeat(triangle_areas(part.points[part.faces]) / 3, 3))
    for side in (value, -value):
        tip, region = int(side.argmax()), np.flatnonzero(side > 0)
        area = float(share[region].sum())
        found.append(Limb(int(part.member[tip]), part.member[region], area, np.inf, 0.0, part.points[tip]))
    return found


def _limbs_of(part: Patch, arcs: Arcs, chosen: list[int], least: float) -> list[Limb]:
    """The limbs of arcs ``chosen`` of a component, none of which stands on another one."""
    base, detail = arcs.bases()[chosen], details(arcs, least)[chosen]
    number = arcs.standing_on(chosen)[arcs.of_vertex]
    number[arcs.value < np.append(arcs.height[base], np.inf)[number]] = -1
    regions = _grouped(number + 1, len(chosen) + 1)[1:]
    return [
        Limb(int(part.member[tip]), part.member[own], area, slenderness, least_detail, part.points[tip])
        for tip, own, area, slenderness, least_detail in zip(
            arcs.top[chosen], regions, arcs.area[base], arcs.slenderness[base], detail, strict=True
        )
    ]


def average_distance(shape: Enclosure, component: np.ndarray, spread: Callable[[np.ndarray], np.ndarray]) -> np.ndarray:
    """(V,) the average geodesic distance of each vertex from its ``component`` (V,).

    ``spread``: see `fronts.distances`.
    """
    x, faces = shape.vertices, shape.faces
    share = np.bincount(faces.ravel(), np.repeat(triangle_areas(shape.triangles) / 3, 3), len(x))
    whole = np.bincount(component, share)
    middle = np.stack([np.bincount(component, share * axis) / whole for axis in x.T], axis=1)

    def farthest(distance: np.ndarray) -> np.ndarray:
        """Of each component; of places that are equally far, the last one, however their distances are rounded."""
        return largest_of_each(component, np.round(distance, DIGITS))

    source = farthest(spread(farthest(-np.linalg.norm(x - middle[component], axis=1))))
    away = np.empty((SOURCES, len(x)))
    for row in range(SOURCES):
        away[row] = spread(source)
        source = farthest(away[: row + 1].min(axis=0))
    pair = away.argmin(axis=0) * len(whole) + component
    weight = np.bincount(pair, share, SOURCES * len(whole)).reshape(SOURCES, -1)
    return np.einsum("sv,sv->v", (weight / whole)[:, component], away)


def _grouped(group: np.ndarray, num: int) -> list[list[int]]:
    """The numbers of each ``group`` (n,) of 0 to ``num`` - 1."""
    order = np.argsort(group, kind="stable").tolist()
    ends = np.cumsum(np.bincount(group, minlength=num)).tolist()
    return [order[start:end] for start, end in zip([0, *ends], ends, strict=False)]


class _Union:
    """Pieces of a surface that are joined, ring by ring. contents: (P, 6) `Levels.contents`, and the number of
    vertices, of the part for which each piece stands."""

    def __init__(self, contents: np.ndarray):
        self.contents, self._root = contents.copy(), list(range(len(contents)))

    def first(self, piece: int) -> int:
        """The piece that stands for the part with ``piece``."""
        root = self._root
        while root[piece] != piece:
            root[piece] = root[root[piece]]
            piece = root[piece]
        return piece

    def join(self, piece: int, other: int) -> None:
        """Make one of the parts for which these pieces stand; ``piece`` stands for it."""
        self._root[other] = piece
        self.contents[piece] += self.contents[other]


class _Sides(NamedTuple):
    """The part of the surface below each ring, up to its level. part: (R,) its number. contents: (R, 6) of it.
    num_rings: (R,) how many rings bound it."""

    part: np.ndarray
    contents: np.ndarray
    num_rings: np.ndarray


def _swept_up(found: Levels, bands: list[list[int]], contents: np.ndarray) -> _Sides:
    """The parts below the rings of a function's level sets, whose pieces are listed band by band, the lowest first."""
    upon, under = (_grouped(pieces, found.num_pieces) for pieces in (found.below, found.above))
    part, num_rings = np.zeros((2, len(found.below)), dtype=np.int64)
    union, held = _Union(contents), np.zeros((len(found.below), 6))
    for members in bands:
        for piece in members:
            for ring in under[piece]:
                here, other = union.first(piece), union.first(int(found.below[ring]))
                if here != other:
                    union.join(here, other)
        above = [ring for piece in members for ring in upon[piece]]
        part[above] = [union.first(int(found.below[ring])) for ring in above]
        held[above] = union.contents[part[above]]
        num_rings[above] = np.bincount(part[above])[part[above]]
    return _Sides(part, held, num_rings)


def merge_tree(
    vertices: np.ndarray, faces: np.ndarray, height: np.ndarray, most: float, last: np.ndarray | None = None
) -> Arcs:
    """The merge tree of ``height`` (V,) on a closed connected surface ``(vertices (V, 3), faces (F, 3))``, at `LEVELS`
    levels. More than the share ``most`` of its area is no limb.

    Of several rings that cut off a limb, all but one bound pits, such as blind holes, if each bounds a part of the
    surface below by itself. Such a part is filled, and belongs to the limb. Else the limb is a part of a handle there.

    How far a top is above a level is the difference of their heights. With ``last`` (V,), heights are last - d for the
    distance d from the end of a limb by the mean exit time; squares of d add up (see `ends`).
    """
    low, high = float(height.min()), float(height.max())
    step = max(high - low, 1e-300) / LEVELS
    found = levels(vertices, faces, height - low + OFFSET * step, step)
    num = found.num_pieces
    band, highest = np.zeros(num, dtype=np.int64), np.full(num, -1)
    band[found.below], band[found.above] = found.level - 1, found.level
    order = np.argsort(height, kind="stable")
    highest[found.piece[order]] = order
    peak = np.where(highest >= 0, height[highest], -np.inf)
    bands, contents = _grouped(band, LEVELS + 2), np.bincount(found.piece, minlength=num)[:, None]
    contents = np.hstack([found.contents, contents])
    upon, under = (_grouped(pieces, num) for pieces in (found.below, found.above))
    below = _swept_up(found, bands, contents)
    union, arcs = _Union(contents), [set[int]() for _ in range(num)]
    loops, of_piece = np.zeros((2, num), dtype=np.int64)  # handles of each part
    top: list[int] = []
    parent: list[int] = []
    rows: list[tuple[int, int, float, bool]] = []  # of each level its arc, ring, peak, and whether a limb is cut off
    sums: list[np.ndarray] = []
    for members in reversed(bands):
        for piece in members:
            for ring in upon[piece]:
                here, other = union.first(piece), union.first(int(found.above[ring]))
                loops[here] += loops[other] if here != other else 1
                if here != other:
                    union.join(here, other)
                    arcs[here] |= arcs[other]
                    if peak[other] > peak[here]:
                        peak[here], highest[here] = peak[other], highest[other]
        together: dict[int, list[int]] = {}
        for piece in members:
            together.setdefault(union.first(piece), []).append(piece)
        for here, pieces in together.items():
            if len(arcs[here]) != 1:
                for each in arcs[here]:
                    parent[each] = len(top)
                arcs[here] = {len(top)}
                top.append(int(highest[here]))
                parent.append(-1)
            (arc,) = arcs[here]
            of_piece[pieces] = arc
            rings = [ring for piece in pieces for ring in under[piece]]
            if rings:
                main = max(rings, key=lambda ring: below.contents[ring, 0])
                pits, own, is_disc = [ring for ring in rings if ring != main], union.contents[here], loops[here] == 0
                for pit in pits:
                    is_disc &= below.num_rings[pit] == 1
                    own = own + below.contents[pit]
                rows.append((arc, main, peak[here], is_disc and own[0] < 2 * union.contents[here, 0]))
                sums.append(own.copy())
    arc, ring, peaks, is_disc = (np.array(column) for column in zip(*rows, strict=True))
    area, vector, moment, count = np.split(np.array(sums), [1, 4, 5], axis=1)
    area, length, at = area[:, 0], np.maximum(found.perimeter[ring], 1e-300), (found.level[ring] - OFFSET) * step + low
    # Closed by a fan over its ring, a pit has a negative volume, and a part of a flat face none but for rounding.
    volume = moment[:, 0] - np.einsum("ri,ri->r", found.centre[ring], vector)
    is_solid = is_disc & (volume > -4 * RESOLUTION * area)
    counts = is_solid & (count[:, 0] >= FEWEST) & (area < most * found.contents[:, 0].sum())
    far = peaks - at
    if last is not None:
        from_end = last[np.array(top)[arc]]
        far = np.sqrt(np.maximum((from_end - at) ** 2 - (from_end - peaks) ** 2, 0.0))
    persistence = np.full(len(top), -np.inf)
    persistence[arc[counts]] = (2 * np.pi * far / length)[counts]  # the last level of an arc stays
    num_levels, num_solid, num_counting = (
        np.bincount(arc[which], minlength=len(top)) for which in (slice(None), is_solid, counts)
    )
    persistence[(num_counting < FEWEST) | (2 * num_solid < num_levels)] = -np.inf  # or mostly a pit
    slenderness = np.where(counts, 2 * np.pi * area / length**2 - 0.5, -np.inf)
    of_vertex = of_piece[found.piece]
    return Arcs(np.array(top), np.array(parent), persistence, of_vertex, height, arc, at, area, slenderness)
