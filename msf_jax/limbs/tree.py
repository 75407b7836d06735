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

from functools import cached_property
from typing import NamedTuple

import numpy as np

from msf_jax.limbs import ends, fronts
from msf_jax.limbs.levels import Levels, levels
from msf_jax.meshes.reconnecting import reconnected
from msf_jax.numerics.compiled import Ints, Points, kernel, part
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import RESOLUTION, triangle_areas
from msf_jax.topology import graphs

SOURCES = 32  # points, far from each other, whose distances are averaged; with 16, mirrored limbs differ by a sixth
DIGITS = 6  # of distances that are compared: those of a symmetric solid differ by rounding
SPLIT = 1_000  # squares of the longest edge that a component's area may have at least: rings follow its limbs then
LEVELS = 800  # of a function on a component
WHOLE, HALF = 0.97, 0.5  # of the component's area, without and with handles: what is larger is no limb of it
FEWEST = 6  # vertices of a limb, and levels of an arc: fewer are noise of the triangles
# Radii: least persistence of a limb at the detail 0.5, over the least slenderness, 0.5. Heads, feet, noses and snouts
# have 0.36 and more, corners of a block 0.28; those of a thin plate, up to 0.4, may be limbs.
PERSISTENCE = 0.7
FINEST = 0.95  # detail: any limb that could stand out


class Arcs(NamedTuple):
    """The merge tree of a function. A parent comes after its children.

    top: (a,) the highest vertex of each arc. parent: (a,), -1 at a root. persistence: (a,) at the last level that
    counts, -inf without enough of them. of_vertex, value: (V,) the arc of each vertex, and the function.

    The levels of all arcs, each arc's from its top down: arc (r,), height (r,), and slenderness (r,) of the ring that
    cuts it off, -inf where that cuts off no limb."""

    top: np.ndarray
    parent: np.ndarray
    persistence: np.ndarray
    of_vertex: np.ndarray
    value: np.ndarray
    arc: np.ndarray
    height: np.ndarray
    slenderness: np.ndarray

    def bases(self) -> np.ndarray:
        """(a,) the level (r,) of the most slender ring of each arc, -1 without one that counts."""
        found = np.full(len(self.top), -1)
        order = np.argsort(self.slenderness, kind="stable")
        order = order[self.slenderness[order] > -np.inf]
        found[self.arc[order]] = order
        return found


class Limb(NamedTuple):
    """tip: the highest vertex. region: (r,) its vertices, up to its base, the most slender ring. slenderness: of its
    base. detail: the least at which it is a limb (see `Config`). place: (3,) of the tip."""

    tip: int
    region: np.ndarray
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
    """A component of a surface. member: (v,) the numbers of its vertices, which follow each other. is_ball: without
    handles."""

    member: np.ndarray
    shape: Enclosure
    is_ball: bool


class LimbTree:
    """The merge trees of the closed surface ``shape``, whose long triangles are split."""

    parts: list[Patch]  # its components

    def __init__(self, shape: Enclosure):
        if ((faces := reconnected(shape.vertices, shape.faces)) != shape.faces).any():
            shape = Enclosure(shape.vertices, faces)
        self.parts, self._found = _patches(shape), dict[tuple[float, float], Limbs]()
        points = np.concatenate([part.shape.vertices for part in self.parts])
        faces = np.concatenate([part.member[part.shape.faces] for part in self.parts])
        self.shape = Enclosure(points, faces) if len(self.parts) > 1 else self.parts[0].shape

    @cached_property
    def trees(self) -> list[Arcs]:
        """Of each component, the merge tree of the average geodesic distance."""
        return [
            merge_tree(part.shape, average_distance(part.shape), WHOLE if part.is_ball else HALF) for part in self.parts
        ]

    def limbs(self, least: float, detail: float) -> Limbs:
        """The limbs of at least the slenderness ``least``, or that stand out enough for the ``detail``.

        At a detail d, a persistence of `PERSISTENCE` ``least`` (1 - d) / d is enough; of slender ones, always that of
        the detail 0.5. On a component with handles only slender ones count: others are often the blunt ends of a body
        around a hole."""
        if (least, detail) in self._found:
            return self._found[least, detail]
        limbs, finer = list[Limb](), list[Limb]()
        for patch, arcs in zip(self.parts, self.trees, strict=True):
            chosen = limbs_among(arcs, least, 0.0)
            if not patch.is_ball:
                limbs += _limbs_of(patch, arcs, chosen, least)
            elif len(chosen) < 3:
                limbs += _halves(patch, least, detail)
            else:
                chosen = limbs_among(arcs, least, detail)
                limbs += _limbs_of(patch, arcs, chosen, least)
                more = _limbs_of(patch, arcs, limbs_among(arcs, least, FINEST), least)
                finer += [each for each in more if each.tip not in patch.member[arcs.top[chosen]]]
        owner = np.zeros(len(self.shape.vertices), dtype=np.int64)
        for number, each in enumerate(limbs, 1):
            owner[each.region] = number
        time = ends.exit_times(self.shape.vertices, self.shape.faces, owner)
        self._found[least, detail] = Limbs(limbs, owner, time, sorted(finer, key=lambda each: each.detail))
        return self._found[least, detail]

    def axis(self, shape: Enclosure, limbs: Limbs, number: int) -> ends.LimbAxis:
        """The curve of one of the limbs in the solid ``shape``."""
        return ends.axis(shape, self.shape.vertices, self.shape.faces, limbs.time, limbs.limbs[number].region)

    def slenderness(self, feet: np.ndarray) -> np.ndarray:
        """(l,) the slenderness of the largest part of the surface around each of the vertices ``feet`` (l,) without
        another one of them: at the most slender of its rings, 0 without one."""
        found = np.zeros(len(feet))
        for patch, arcs in zip(self.parts, self.trees, strict=True):
            mine = np.flatnonzero(np.isin(feet, patch.member))
            found[mine] = _slenderness_around(arcs, np.searchsorted(patch.member, feet[mine]))
        return found


def _patches(shape: Enclosure) -> list[Patch]:
    """The components of a surface, each with its long triangles split as if it were alone; some fall apart then."""
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
        for piece in graphs.by_label(graphs.pieces(faces, len(x))):  # what touched itself at a vertex falls apart
            used, corner = np.unique(faces[piece], return_inverse=True)
            is_whole = np.array_equal(x[used], shape.vertices)  # then what is known of it is kept
            own_shape = shape if is_whole else Enclosure(x[used], corner.reshape(-1, 3))
            is_ball = 2 * len(used) - len(piece) == 4  # Euler's formula
            found.append(Patch(np.arange(num, num + len(used)), own_shape, is_ball))
            num += len(used)
    return found


def _slenderness_around(arcs: Arcs, feet: np.ndarray) -> np.ndarray:
    """See `LimbTree.slenderness`; ``feet`` (l,) are vertices of the component."""
    rows = [np.empty(0, dtype=np.int64)]  # the levels of the tree below each foot
    for vertex in feet.tolist():
        below = [arcs.of_vertex[vertex]]
        while arcs.parent[below[-1]] >= 0:
            below.append(arcs.parent[below[-1]])
        rows.append(np.flatnonzero(np.isin(arcs.arc, below) & (arcs.height <= arcs.value[vertex])))
    count = np.bincount(np.concatenate(rows), minlength=len(arcs.arc))
    return np.array([arcs.slenderness[own[count[own] == 1]].max(initial=0.0) for own in rows[1:]])


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


def _halves(part: Patch, least: float, detail: float) -> list[Limb]:
    """The halves of a component (see `ends.halves`), or the limbs of a half that has more than one, as the head of a
    hammer has. These are arcs of how far from a half's end the mean exit time is, see `ends`."""
    x, faces, found = part.shape.vertices, part.shape.faces, list[Limb]()
    value = ends.halves(x, faces)
    side = np.where(value > 0, 1, 2)
    time = ends.exit_times(x, faces, side)
    whole = np.sqrt(2 * np.array([time[side == half].max() for half in (1, 2)]))[side - 1]
    arcs = merge_tree(part.shape, whole - np.sqrt(np.maximum(whole**2 - 2 * time, 0.0)), WHOLE, whole)
    limbs = _limbs_of(part, arcs, limbs_among(arcs, least, detail), least)
    for half, tip in ((1, int(value.argmax())), (2, int(value.argmin()))):
        region = part.member[side == half]
        own = [each for each in limbs if each.tip in region]
        if len(own) < 2:
            own = [Limb(int(part.member[tip]), region, np.inf, 0.0, x[tip])]
        else:  # a vertex belongs to the end that it is nearest to, unless another one is about as near
            away = fronts.distances(part.shape)
            away = np.array([away(indices=[each.tip - part.member[0]])[side == half] for each in own])
            first, second = np.sort(away, axis=0)[:2]
            nearest = np.where(first < ends.ALIKE * second, away.argmin(axis=0), -1)
            own = [each._replace(region=region[nearest == k]) for k, each in enumerate(own)]
        found += own
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
    figures = zip(arcs.top[chosen].tolist(), arcs.slenderness[base].tolist(), detail.tolist(), strict=True)
    return [
        Limb(int(part.member[tip]), part.member[number == k], slenderness, needed, part.shape.vertices[tip])
        for k, (tip, slenderness, needed) in enumerate(figures)
    ]


def average_distance(shape: Enclosure) -> np.ndarray:
    """(V,) the average geodesic distance of each vertex of a connected surface from all of it."""
    x, faces, spread = shape.vertices, shape.faces, fronts.distances(shape)
    share = np.bincount(faces.ravel(), np.repeat(triangle_areas(shape.triangles) / 3, 3))
    share /= share.sum()

    def farthest(distance: np.ndarray) -> np.ndarray:
        """Of places that are equally far, the last one, however their distances are rounded."""
        distance = np.round(distance, DIGITS)
        return np.flatnonzero(distance == distance.max())[-1:]

    source = farthest(spread(indices=farthest(-np.linalg.norm(x - share @ x, axis=1))))
    away, nearest, of_source = np.empty((SOURCES, len(x))), np.full(len(x), np.inf), np.zeros(len(x), dtype=np.int64)
    for row in range(SOURCES):
        away[row] = spread(indices=source)
        of_source[away[row] < nearest] = row
        nearest = np.minimum(nearest, away[row])
        source = farthest(nearest)
    return np.einsum("s,sv->v", np.bincount(of_source, share, SOURCES), away)


class Parts(NamedTuple):
    """The parts of a surface above each level. piece: (P,) the piece that stands for the part with each piece,
    down to its level. Of the pieces that stand for one: loops (P,), how many rings close a loop in the part; highest
    (P,), the largest of its pieces' numbers; contents (P, c), the sum of its pieces'."""

    piece: Ints
    loops: Ints
    highest: Ints
    contents: Points


@part
def first_of(root: Ints, member: int) -> int:
    """The member that stands for the set of ``member``; ``root`` leads there."""
    while root[member] != member:
        root[member] = root[root[member]]
        member = root[member]
    return member


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


def _swept(found: Levels, highest: np.ndarray, contents: np.ndarray) -> Parts:
    """The parts above each level, with the ``highest`` vertex (P,) and ``contents`` (P, c) of each piece."""
    order, num = np.lexsort((found.below, -found.level)), len(contents)
    first = np.searchsorted(-found.level[order], np.arange(-found.level.max(initial=0), 1))
    parts = Parts(np.arange(num), np.zeros(num, dtype=np.int64), highest.copy(), contents.copy())
    sweep(first, found.below[order], found.above[order], np.arange(num), parts)
    return parts


def merge_tree(shape: Enclosure, height: np.ndarray, most: float, last: np.ndarray | None = None) -> Arcs:
    """The merge tree of ``height`` (V,) on a closed connected surface, at `LEVELS` levels. More than the share ``most``
    of its area is no limb.

    A limb is cut off by one ring. Of several, the others bound pits, such as blind holes, or handles.

    How far a top is above a level is the difference of their heights. With ``last`` (V,), heights are last - d for the
    distance d from the end of a limb by the mean exit time; squares of d add up (see `ends`)."""
    low, high = float(height.min()), float(height.max())
    step = max(high - low, 1e-300) / LEVELS
    found = levels(shape.vertices, shape.faces, height - low, step)
    num, by_height = len(found.contents), np.argsort(height, kind="stable")
    band, highest = np.zeros(num, dtype=np.int64), np.full(num, -1)
    band[found.below], band[found.above] = found.level - 1, found.level
    highest[found.piece[by_height]] = np.arange(len(height))
    contents = np.hstack([found.contents, np.bincount(found.piece, minlength=num)[:, None]])
    down = _swept(found, highest, contents)
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
    level, ring, num_rings = np.unique(part[found.above], return_index=True, return_counts=True)
    own = stands[level]
    sums, is_disc = down.contents[own], (down.loops[own] == 0) & (num_rings == 1)
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
    return Arcs(top, parent, persistence, arc_of[part[found.piece]], height, arc, at, slenderness)
