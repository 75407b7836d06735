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
from msf_jax.limbs.levels import first_of, levels
from msf_jax.meshes.reconnecting import reconnected
from msf_jax.numerics.compiled import Ints, Points, kernel
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import RESOLUTION, triangle_areas
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
APART = 0.9  # of the distance from a second end of its half: a vertex nearer than that to an end is of that limb
FINEST = 0.95  # detail: any limb that could stand out


class Arcs(NamedTuple):
    """The merge tree of a function. A parent comes after its children.

    top: (a,) the highest vertex of each arc. parent: (a,), -1 at a root. persistence: (a,) at the last level that
    counts, -inf without enough of them. of_vertex, value: (V,) the arc of each vertex, and the function.

    The levels of all arcs, each arc's from its top down: arc (r,), height (r,), area (r,) above, and slenderness (r,)
    of the ring that cuts it off, -inf where that cuts off no limb."""

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
        self._away = fronts.distances(self.shape)

    @cached_property
    def trees(self) -> list[Arcs]:
        """Of each component, the merge tree of the average geodesic distance."""
        component = np.repeat(np.arange(len(self.parts)), [len(part.points) for part in self.parts])
        height = average_distance(self.shape, component, self._away)
        return [
            merge_tree(part.points, part.faces, height[part.member], WHOLE if part.is_ball else HALF)
            for part in self.parts
        ]

    def limbs(self, least: float, detail: float) -> Limbs:
        """The limbs of at least the slenderness ``least``, or that stand out enough for the ``detail``.

        At a detail d, a persistence of `PERSISTENCE` ``least`` (1 - d) / d is enough; of slender ones, always that of
        the detail 0.5. On a component with handles only slender ones count: others are often the blunt ends of a body
        around a hole."""
        if (least, detail) in self._found:
            return self._found[least, detail]
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
        self._found[least, detail] = Limbs(limbs, owner, time, sorted(finer, key=lambda each: each.detail))
        return self._found[least, detail]

    def _parted(self, halves: list[Limb], least: float, detail: float) -> list[Limb]:
        """The halves of components, or the limbs of a half that has more than one, as the head of a hammer has.

        The function is how far from the half's end the mean exit time is, see `ends`."""
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
            away = np.array([self._away(np.array([each.tip]))[half.region] for each in own])
            first, second = np.sort(away, axis=0)[:2]
            near = np.where(first < APART * second, np.argmin(away, axis=0), -1)
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
    for own in graphs.by_label(graphs.pieces(shape.faces, len(shape.vertices))):
        member, faces = np.unique(shape.faces[own], return_inverse=True)
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
    slenderness, need = np.append(arcs.slenderness, -np.inf)[arcs.bases()], PERSISTENCE * least
    found = need / (need + np.maximum(arcs.persistence, 1e-300))
    found[arcs.persistence <= 0] = np.inf
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
    value, found = ends.halves(part.points, part.faces), []
    share = np.bincount(part.faces.ravel(), np.repeat(triangle_areas(part.points[part.faces]) / 3, 3))
    for side in (value, -value):
        tip, region = int(side.argmax()), np.flatnonzero(side > 0)
        area = float(share[region].sum())
        found.append(Limb(int(part.member[tip]), part.member[region], area, np.inf, 0.0, part.points[tip]))
    return found


def _limbs_of(part: Patch, arcs: Arcs, chosen: list[int], least: float) -> list[Limb]:
    """The limbs of arcs ``chosen`` of a component, none of which stands on another one."""
    base, detail = arcs.bases()[chosen], details(arcs, least)[chosen]
    of_arc = np.full(len(arcs.parent) + 1, -1)  # which of the chosen arcs each arc is or stands on
    of_arc[chosen] = np.arange(len(chosen))
    for arc in range(len(arcs.parent) - 1, -1, -1):
        of_arc[arc] = max(of_arc[arc], of_arc[arcs.parent[arc]])
    number = of_arc[arcs.of_vertex]
    number[arcs.value < np.append(arcs.height[base], np.inf)[number]] = -1
    figures = zip(arcs.area[base].tolist(), arcs.slenderness[base].tolist(), detail.tolist(), strict=True)
    return [
        Limb(int(part.member[tip]), part.member[number == k], *of_limb, part.points[tip])
        for k, (tip, of_limb) in enumerate(zip(arcs.top[chosen].tolist(), figures, strict=True))
    ]


def average_distance(shape: Enclosure, component: np.ndarray, spread: Callable[[np.ndarray], np.ndarray]) -> np.ndarray:
    """(V,) the average geodesic distance of each vertex from its ``component`` (V,), numbered in order.

    ``spread``: see `fronts.distances`."""
    x, faces = shape.vertices, shape.faces
    share = np.bincount(faces.ravel(), np.repeat(triangle_areas(shape.triangles) / 3, 3), len(x))
    whole, first = np.bincount(component, share), np.flatnonzero(np.diff(component, prepend=-1))
    middle = np.stack([np.bincount(component, share * axis) / whole for axis in x.T], axis=1)

    def farthest(distance: np.ndarray) -> np.ndarray:
        """Of each component; of places that are equally far, the last one, however their distances are rounded."""
        distance, source = np.round(distance, DIGITS), np.empty(len(whole), dtype=np.int64)
        last = np.flatnonzero(distance == np.maximum.reduceat(distance, first)[component])
        source[component[last]] = last
        return source

    source = farthest(spread(farthest(-np.linalg.norm(x - middle[component], axis=1))))
    away, nearest, of_source = np.empty((SOURCES, len(x))), np.full(len(x), np.inf), np.zeros(len(x), dtype=np.int64)
    for row in range(SOURCES):
        away[row] = spread(source)
        of_source[away[row] < nearest] = row
        nearest = np.minimum(nearest, away[row])
        source = farthest(nearest)
    weight = np.bincount(of_source * len(whole) + component, share, SOURCES * len(whole)).reshape(SOURCES, -1)
    return np.einsum("sv,sv->v", (weight / whole)[:, component], away)


class Parts(NamedTuple):
    """The parts of a surface on one side of each level. piece: (P,) the piece that stands for the part with each piece,
    up to its level. Of the pieces that stand for one: loops (P,), how many rings close a loop in the part; highest
    (P,), the largest of its pieces' numbers; contents (P, c), the sum of its pieces'."""

    piece: Ints
    loops: Ints
    highest: Ints
    contents: Points


@kernel
def sweep(first: Ints, here: Ints, there: Ints, root: Ints, parts: Parts) -> None:
    """Join the pieces ``here`` (R,) and ``there`` (R,) at rings, level by level; level k begins with ring
    ``first[k]``. All pieces there have been reached before those here. ``root`` and ``parts.piece`` hold 0, 1, ..."""
    for level in range(len(first) - 1):
        for ring in range(first[level], first[level + 1]):
            one, other = first_of(root, here[ring]), first_of(root, there[ring])
            if one == other:
                parts.loops[one] += 1
                continue
            root[other] = one
            parts.loops[one] += parts.loops[other]
            parts.highest[one] = max(parts.highest[one], parts.highest[other])
            for i in range(parts.contents.shape[1]):
                parts.contents[one, i] += parts.contents[other, i]
        for ring in range(first[level], first[level + 1]):
            parts.piece[here[ring]] = first_of(root, here[ring])


def _swept(here: np.ndarray, there: np.ndarray, level: np.ndarray, highest: np.ndarray, contents: np.ndarray) -> Parts:
    """The parts on the side of the pieces ``there`` of the rings, of the lowest ``level`` (R,) first; see `sweep`."""
    order, num = np.lexsort((here, level)), len(contents)
    first = np.searchsorted(level[order], np.arange(level.min(initial=0), level.max(initial=0) + 2))
    parts = Parts(np.arange(num), np.zeros(num, dtype=np.int64), highest.copy(), contents.copy())
    sweep(first, here[order], there[order], np.arange(num), parts)
    return parts


def merge_tree(
    vertices: np.ndarray, faces: np.ndarray, height: np.ndarray, most: float, last: np.ndarray | None = None
) -> Arcs:
    """The merge tree of ``height`` (V,) on a closed connected surface ``(vertices (V, 3), faces (F, 3))``, at `LEVELS`
    levels. More than the share ``most`` of its area is no limb.

    Of several rings that cut off a limb, all but one bound pits, such as blind holes, if each bounds a part of the
    surface below by itself. Such a part is filled, and belongs to the limb. Else the limb is a part of a handle there.

    How far a top is above a level is the difference of their heights. With ``last`` (V,), heights are last - d for the
    distance d from the end of a limb by the mean exit time; squares of d add up (see `ends`)."""
    low, high = float(height.min()), float(height.max())
    step = max(high - low, 1e-300) / LEVELS
    found = levels(vertices, faces, height - low, step, OFFSET)
    num, by_height = len(found.contents), np.argsort(height, kind="stable")
    band, highest = np.zeros(num, dtype=np.int64), np.full(num, -1)
    band[found.below], band[found.above] = found.level - 1, found.level
    highest[found.piece[by_height]] = np.arange(len(height))
    contents = np.hstack([found.contents, np.bincount(found.piece, minlength=num)[:, None]])
    up = _swept(found.above, found.below, found.level, highest, contents)
    down = _swept(found.below, found.above, -found.level, highest, contents)
    # The parts above a level, those of the highest level first, and which of the next level each belongs to.
    order = np.argsort(-band, kind="stable")
    first, part = np.unique(down.piece[order], return_index=True, return_inverse=True)[1:]
    part[order] = np.argsort(np.argsort(first))[part]
    stands, upon = down.piece[order[np.sort(first)]], np.full(len(first), -1)
    upon[part[found.above]] = part[found.below]
    # A part with one part upon it continues its arc.
    below = np.flatnonzero(upon >= 0)
    begins, arc_of = np.bincount(upon[below], minlength=len(upon)) != 1, np.arange(len(upon))
    arc_of[upon[below]] = below
    arc_of[begins] = np.flatnonzero(begins)
    while (arc_of[arc_of] != arc_of).any():
        arc_of = arc_of[arc_of]
    arc_of = (np.cumsum(begins) - 1)[arc_of]
    top, parent = by_height[down.highest[stands]], np.full(begins.sum(), -1)
    joins = below[arc_of[below] != arc_of[upon[below]]]
    parent[arc_of[joins]] = arc_of[upon[joins]]
    # The ring with the largest part below it cuts off a limb; those beside it bound pits.
    under, owner = up.piece[found.below], part[found.above]
    by_area = np.lexsort((found.above, -up.contents[under, 0], owner))
    ring = by_area[np.diff(owner[by_area], prepend=-1) > 0]
    pit = np.lexsort((found.above, owner))
    pit = pit[~np.isin(pit, ring)]
    level, at_pit = owner[ring], np.searchsorted(owner[ring], owner[pit])
    own, sums = stands[level], down.contents[stands[level]]
    np.add.at(sums, at_pit, up.contents[under[pit]])
    is_disc = (down.loops[own] == 0) & (sums[:, 0] < 2 * down.contents[own, 0])
    is_disc[at_pit[np.bincount(under)[under[pit]] > 1]] = False
    arc, peaks, top = arc_of[level], height[top[level]], top[begins]
    area, vector, moment, count = np.split(sums, [1, 4, 5], axis=1)
    area, length, at = area[:, 0], np.maximum(found.perimeter[ring], 1e-300), found.height[ring] + low
    # Closed by a fan over its ring, a pit has a negative volume, and a part of a flat face none but for rounding.
    volume = moment[:, 0] - np.einsum("ri,ri->r", found.centre[ring], vector)
    is_solid = is_disc & (volume > -4 * RESOLUTION * area)
    counts = is_solid & (count[:, 0] >= FEWEST) & (area < most * found.contents[:, 0].sum())
    far = peaks - at
    if last is not None:
        from_end = last[top[arc]]
        far = np.sqrt(np.maximum((from_end - at) ** 2 - (from_end - peaks) ** 2, 0.0))
    persistence = np.full(len(top), -np.inf)
    persistence[arc[counts]] = (2 * np.pi * far / length)[counts]  # the last level of an arc stays
    num_levels, num_solid, num_counting = (
        np.bincount(arc[which], minlength=len(top)) for which in (slice(None), is_solid, counts)
    )
    persistence[(num_counting < FEWEST) | (2 * num_solid < num_levels)] = -np.inf  # or mostly a pit
    slenderness = np.where(counts, 2 * np.pi * area / length**2 - 0.5, -np.inf)
    return Arcs(top, parent, persistence, arc_of[part[found.piece]], height, arc, at, area, slenderness)
