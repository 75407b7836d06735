"""The limbs of a solid, found on its surface: caps that are long for the curve that cuts them off.

The points of the surface within a geodesic distance of a *tip* are a disc. Its longest boundary curve, of length P,
cuts off a *cap* of area A: the disc, and the smaller parts that its other boundary curves enclose. The cap's
*slenderness* is

    2 pi A / P^2 - 1 / 2,

and half of that if A is less than `SMALL_CAP` of the surface. It is 0 for a flat disc, 1 / 2 for half a ball, and
h / radius for a cylinder that sticks out by h from a larger body. Unlike a measure along a curve, it does not depend on
where the curve runs, and little on the size of the triangles. The smallest cap around a tip that is slender enough is a
*limb*, unless it overlaps a smaller one and one has the other's tip: else the two share what they both have, and
grow on together (see `grown_together`). A very small limb must be twice as slender: it has too few triangles in most
meshes, and its slenderness changes by a fifth with them.

A tip is a vertex whose average geodesic distance from the surface is larger than that of its neighbours (Hilaga,
Shinagawa, Kohmura, Kunii 2001).

Limbs that are short, blunt, or beside longer ones only stand out, see `protrusions`. The apex of a mitre looks like a
limb and is none, see `is_apex`.
"""

from collections.abc import Callable
from functools import cached_property
from typing import NamedTuple

import numpy as np
import trimesh
from scipy import sparse

from msf_jax.limbs import ends, fronts
from msf_jax.limbs.levels import Levels, levels
from msf_jax.meshes.reconnecting import reconnected
from msf_jax.numerics.factors import surface_factor
from msf_jax.solid import sections
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import ROUNDING, cross, largest_of_each, unit
from msf_jax.topology import graphs

SOURCES = 16  # points, far from each other, whose distances are averaged
DIGITS = 6  # of distances that are compared: those of a symmetric solid differ by rounding
SMOOTHINGS = 5  # of the average distance, each a mean with the neighbours: so noise makes few tips
FIRST_RADIUS = 0.002  # of the first disc, in square roots of the surface's area
RATIO = 1.06  # of the radii of successive discs
SMALL_CAP = 0.0012  # of the surface, 24 triangles of 20,000: a smaller cap counts half, see `fronts.SMALLER`
BLUNT = 0.6  # of the least slenderness: enough for blunt ends, see `Caps.limbs`; more than corners of a box have
BODY = 0.25  # of the surface of a solid with handles: its two blunt ends have more, corners of a truss have less
NEARLY = 0.7  # of the least slenderness: then the neighbours of a tip are tried, too
ROUND_END = 0.5  # least slenderness of a limb's end, before a disc goes around a handle or a larger part: half a ball
RAISED = 0.43  # protrusion of a limb's tip: more than a ball has, less than the end of a rod; see `protrusions`
LEAST_RAISED = 0.35  # of what a limb needs: less is none at any detail; of four more with 0.2, nobody drew one
LARGEST_CAP = 0.25  # of the surface: caps of limbs that only stand out
OBLIQUE = 3.5  # slenderness from which on a base can be oblique: at the end, rings are so by exp(-4) of that
DROP = 0.6  # of a limb's slenderness: a larger cap, of what it stands on, has less
# Volume over area to the 3 / 2, and least slenderness, for that of a limb: 1.2 times that of the corner of a thin
# plate, and of thicker ones; and more than half a ball, 0.5, which is the corner of a frame of rods.
CORNER = (0.0, 0.083, 0.105, 0.13), (0.6, 0.5, 0.39, 0.6)
TRIANGLES = 32  # fewest of a limb that only stands out, 16 vertices: 48 are as many as the ears of a horse have
MOST_DISCS = 200  # radii: more than from the first one to the whole of a surface
SPLIT_BELOW = 1_000  # vertices of a surface: of one with fewer, triangles are split, so that discs follow its limbs
MOST_TIPS = 100  # places of a component, besides the curve's leaves, those with the largest average distance first
MOST_AREA = 100.0  # surfaces of a component: area of all its discs together; then no further tip of it is tried
# Square roots of the area: from a head's to a toe's; between two, the protrusion falls by 4 %.
HEAT_SCALES = 0.2 * 1.8 ** -np.arange(5)
BALL = 0.36  # the largest protrusion of a ball, 1 / sqrt(8) for s = sqrt(2) R, and a little more
TIPS_APART = 0.6  # of the larger scale: tips are that far from one with more protrusion
MOST_RAISED = 200  # tips, those with the largest protrusion
MITRE_STEP = 0.1  # of their distance from the tip: rings of a front around a mitre's apex are that far apart
MITRE_WIDER = 3  # rings of a front that are compared: fewer apart, their lengths are noise of the triangles
MITRE_RINGS = 6  # rings of a bar beyond the corner, over almost the distance from the tip to the corner


class Cap(NamedTuple):
    """tip: a vertex. slenderness, area: of the cap, see `caps`. region: (r,) the cap's vertices."""

    tip: int
    slenderness: float
    area: float
    region: np.ndarray


class Patch(NamedTuple):
    """A component of a surface. member: (v,) its vertices. points: (v, 3). faces: (f, 3). area: (f,)."""

    member: np.ndarray
    points: np.ndarray
    faces: np.ndarray
    area: np.ndarray


def grown_together(part: Patch, tips: np.ndarray, away: np.ndarray, radius: np.ndarray, ratio: float) -> list[Cap]:
    """The caps of discs that grow together around ``tips`` (t,), such as the two ends of a hammer's head, with the
    distances ``away`` (t, v) from them, from the radii ``radius`` (t,) on.

    A disc around one end is oblique at the middle of the head, and passes it before its cap is slender enough. With the
    geodesic distances d_i from the tips and the radii r_i, the disc of tip i is where

        min(r_i - d_i, max(d_j - d_i, d_j - r_j) for all j)

    is positive: within its own radius, and nearer to its tip than to another one whose disc is there, too. All radii
    grow by ``ratio`` while the least slender cap gets more slender.
    """
    found: list[Cap] = []
    while True:
        value = radius[:, None] - away
        for one, other in np.ndindex(len(away), len(away)):
            if one != other:
                beside = np.maximum(away[other] - away[one], away[other] - radius[other])
                value[one] = np.minimum(value[one], beside)
        caps = [cap_where(part, tip, own) for tip, own in zip(tips.tolist(), value, strict=True)]
        if found and min(cap.slenderness for cap in caps) <= min(cap.slenderness for cap in found):
            return found
        found, radius = caps, ratio * radius


def cap_where(part: Patch, tip: int, value: np.ndarray) -> Cap:
    """The cap around ``tip`` where ``value`` (v,) is positive: all but the largest piece where it is not."""
    tail, head = part.faces.ravel(), np.roll(part.faces, -1, axis=1).ravel()
    is_out = (value[tail] <= 0) & (value[head] <= 0)
    piece = graphs.labels(len(value), tail[is_out], head[is_out])
    share = np.bincount(part.faces.ravel(), np.repeat(part.area, 3), len(value))
    is_beyond = piece == np.bincount(piece, np.where(value <= 0, share, 0.0)).argmax()
    # Of a face with one corner on one side, that side has the part s t, if it has the parts s and t of the edges there.
    is_in = ~is_beyond[part.faces]
    count, corner = is_in.sum(axis=1), value[part.faces]
    odd = (is_in == (count == 1)[:, None]).argmax(axis=1)
    p, a, b = (np.take_along_axis(corner, (odd[:, None] + k) % 3, axis=1)[:, 0] for k in range(3))
    is_cut = (count == 1) | (count == 2)
    cut = p**2 / np.where(is_cut, (p - a) * (p - b), 1.0)
    area = float(part.area @ np.where(is_cut, np.where(count == 1, cut, 1 - cut), count == 3))
    perimeter = ends.zero_line(part.points, part.faces[is_cut], value)
    return Cap(tip, 2 * np.pi * area / perimeter**2 - 0.5, area, part.member[~is_beyond])


class Raised(NamedTuple):
    """A limb that stands out only: ``detail`` is the least detail (see `Config`) at which it is one."""

    detail: float
    cap: Cap


class Limbs(NamedTuple):
    """The limbs of a surface, see `Caps.limbs`.

    caps: of the limbs. owner: (V,) the number of the limb of each vertex, from 1; 0 for none. times: of each limb, (V,)
    the mean exit time from it (see `ends`): how far a vertex is from the limb's base. slenderness: (V,) at each tip,
    the largest of its caps, infinite for a tip that was not tried; 0 elsewhere. finer: the limbs of a finer detail.
    """

    caps: list[Cap]
    owner: np.ndarray
    times: list[np.ndarray]
    slenderness: np.ndarray
    finer: list[Raised]


class Caps:
    """The caps of the closed surface ``shape``, whose triangles are split if they are few.

    Of the limbs that only stand out, those of ``detail`` are found. ``was_hit``: whether `MOST_TIPS` or `MOST_AREA` was
    reached. Not for several threads at once.
    """

    def __init__(self, shape: Enclosure, detail: float = 0.5, ask: Callable[[], None] = lambda: None):
        self.detail, self._ask = detail, ask
        if ((faces := reconnected(shape.vertices, shape.faces)) != shape.faces).any():
            shape = Enclosure(shape.vertices, faces)
        while len(shape.vertices) < SPLIT_BELOW:
            split = trimesh.remesh.subdivide(shape.vertices, shape.faces)
            shape = Enclosure(split[0], split[1])
        self.shape = shape
        x, faces = shape.vertices, shape.faces
        around = np.argsort(faces.ravel(), kind="stable") // 3
        first = np.concatenate([[0], np.cumsum(np.bincount(faces.ravel(), minlength=len(x)))])
        a, b, c = shape.triangles[:, 0], shape.triangles[:, 1], shape.triangles[:, 2]
        vector = cross(b - a, c - a) / 2
        area, volume = np.linalg.norm(vector, axis=1), np.einsum("fi,fi->f", a, vector) / 3
        size = np.concatenate([area[:, None], vector, volume[:, None]], axis=1)
        self.surface, self.area = fronts.FrontSurface(x, faces, shape.mesh.twins, first, around, size), area
        component = graphs.labels_of_faces(faces, len(x)).astype(np.int64)
        self._component = component
        count, of_face = np.bincount(component), component[faces[:, 0]]
        self._total = np.bincount(of_face, area, len(count))[component]
        # Two vertices more than half of the faces: Euler's formula for a component without handles.
        self._is_ball = 2 * count - np.bincount(of_face, minlength=len(count)) == 4
        num, size = len(x), 9 * len(faces)
        state, order, filled, stack = np.zeros((4, num), dtype=np.int64)
        key, value = np.empty(size), np.empty(size, dtype=np.int64)
        ring = np.full(len(faces), -1)
        self._front = fronts.Scratch(np.full(num, np.inf), state, order, filled, stack, key, value, ring)
        self._left, self.was_hit = np.full(component.max() + 1, MOST_AREA), False
        self._rows = np.empty((MOST_DISCS + 4, 9))
        self._region = np.empty(len(x) + 1, dtype=np.int64)
        self._found: dict[float, Limbs] = {}
        self._apexes: dict[tuple[int, float], bool] = {}

    def grown(
        self, tip: int, others: np.ndarray, enough: float = np.inf, share: float = 0.5, least: float = SMALL_CAP
    ) -> tuple[np.ndarray, np.ndarray]:
        """The caps around ``tip``, one in each row (k, 7), and the vertices (r,) of the slenderest cap.

        A row is slenderness, radius of the disc, area, middle of the curve and volume. The last cap is the first one of
        ``enough`` slenderness, or the last one below that ``share`` of the surface and without a vertex of ``others``
        (V,). A cap of less than the share ``least`` counts half.
        """
        self._ask()
        total = float(self._total[tip])
        first, small, most = FIRST_RADIUS * np.sqrt(total), least * total, share * total
        count = fronts.cap(
            self.surface, self._front, int(tip), first, RATIO, enough, small, most, others, self._rows, self._region
        )
        end = int(np.argmax(self._region == -1))
        self._left[self._component[tip]] -= self._rows[count - 1, 2] / total if count else 0.0
        return self._rows[:count, :7].copy(), self._region[:end].copy()

    @cached_property
    def height(self) -> np.ndarray:
        """(V,) the average geodesic distance of each vertex from its component, smoothed against noise."""
        x, faces, component = self.surface.points, self.surface.faces, self._component
        share = np.bincount(faces.ravel(), np.repeat(self.area / 3, 3), len(x))
        whole = np.bincount(component, share)
        middle = np.stack([np.bincount(component, share * axis) / whole for axis in x.T], axis=1)

        def farthest(distance: np.ndarray) -> np.ndarray:
            """Of each component; of places that are equally far, the last one, however their distances are rounded."""
            return largest_of_each(component, np.round(distance, DIGITS))

        source = farthest(self._distances(farthest(-np.linalg.norm(x - middle[component], axis=1))))
        away = np.empty((SOURCES, len(x)))
        for row in range(SOURCES):
            away[row] = self._distances(source)
            source = farthest(away[: row + 1].min(axis=0))
        pair = away.argmin(axis=0) * len(whole) + component
        weight = np.bincount(pair, share, SOURCES * len(whole)).reshape(SOURCES, -1)
        found = np.einsum("sv,sv->v", (weight / whole)[:, component], away)
        tail, head = faces.ravel(), np.roll(faces, -1, axis=1).ravel()
        degree = np.bincount(tail, minlength=len(x))
        for _ in range(SMOOTHINGS):
            found = (found + np.bincount(tail, found[head], len(x)) / degree) / 2
        return found

    @cached_property
    def tip_of(self) -> np.ndarray:
        """(V,) the tip that each vertex leads to, if the largest height among its neighbours is followed."""
        tail, head = self.surface.faces.ravel(), np.roll(self.surface.faces, -1, axis=1).ravel()
        above = np.arange(len(self.height))
        order = np.argsort(self.height[head], kind="stable")
        order = order[self.height[head[order]] > self.height[tail[order]]]
        above[tail[order]] = head[order]  # of several, the last and highest is kept
        while (above != above[above]).any():
            above = above[above]
        return above

    def tips(self) -> np.ndarray:
        """Vertices (t,) where `height` is largest among their neighbours, the largest of each component first."""
        found = np.unique(self.tip_of)
        found = found[np.lexsort((-self.height[found], self._component[found]))]
        own = self._component[found]
        is_first = np.arange(len(found)) - np.searchsorted(own, own) < MOST_TIPS
        self.was_hit |= not is_first.all()
        return found[is_first]

    def _distances(self, sources: np.ndarray) -> np.ndarray:
        fronts.spread(self.surface, self._front, sources)
        found = self._front.distance.copy()
        self._front.distance[:], self._front.state[:] = np.inf, 0
        return found

    def limbs(self, least: float) -> Limbs:
        """The limbs of at least that slenderness, but `ROUND_END`.

        First come caps below half of the surface. Then the rest may be a limb, too, up to the first ones: the body of a
        bunny is the other end of its ears. A component without limbs has its blunt ends instead; one with handles has
        two, as a mug, or none, as a kettlebell. If a component without handles has one or two limbs, and a
        direction, it has one branch, and its halves are the limbs (see `ends.halves`): in a sheet, discs around tips
        find its corners. The same goes for one without limbs, such as a cube. Last come limbs that only stand out.
        """
        if least not in self._found:
            self._found[least] = self._search(max(least, ROUND_END))
        return self._found[least]

    def _search(self, least: float) -> Limbs:
        tips = self.tips()
        most = np.full(len(self.surface.points), np.inf)
        owner = np.zeros(len(most), dtype=np.int64)
        # Of each limb, its tip and the slenderness of its cap: below half of the surface, the largest one.
        found = self._slender(tips, owner, most, least, 0.5)
        limbs = [(tip, np.inf, cap) for tip, cap in found]
        if limbs:
            found = self._slender(tips[owner[tips] == 0], owner, most, least, 1.0)
            limbs += [(tip, least, cap) for tip, cap in found]
        blunt = max(BLUNT * least, ROUND_END)
        is_whole = np.bincount(self._component, owner) == 0
        rest = tips[is_whole[self._component[tips]]]
        limbs += [(tip, np.inf, cap) for tip, cap in self._slender(rest, owner, most, blunt, 0.5)]
        caps = [
            cap or self._of(tip, ((owner > 0) & (owner != number)).astype(np.int64), enough)
            for number, (tip, enough, cap) in enumerate(limbs, 1)
        ]
        around = [cap.tip for cap in caps]
        count = np.bincount(self._component[around], minlength=len(self._is_ball))
        held = np.bincount(self._component[around], [cap.area for cap in caps] / self._total[around], len(count))
        has_loops = is_whole & ~self._is_ball & ((count != 2) | (held < BODY))
        caps = [cap for cap in caps if not has_loops[self._component[cap.tip]]]
        for number in np.flatnonzero((count < 3) & self._is_ball).tolist():
            two, is_long = self._halves(number)
            if (is_long or not count[number]) and min(cap.slenderness for cap in two) >= blunt:
                caps = [cap for cap in caps if self._component[cap.tip] != number] + two
        times = self._owned(caps, owner)
        raised = self._raised(caps, owner, times, least)
        added = [each.cap for each in raised if each.detail <= self.detail]
        if added:
            caps += added
            times = self._owned(caps, owner)
        at_tips = np.where(np.bincount(tips, minlength=len(most)) > 0, most, 0.0)
        return Limbs(caps, owner, times, at_tips, [each for each in raised if each.detail > self.detail])

    def _owned(self, caps: list[Cap], owner: np.ndarray) -> list[np.ndarray]:
        """Of each of the limbs ``caps``, which are numbered in ``owner`` (V,), the mean exit times (V,) from it.

        A limb with its tip on another one is part of that, a heel of a leg: its base is no base of the leg."""
        owner[:], order = 0, np.argsort([-cap.area for cap in caps], kind="stable").tolist()  # the smaller one last
        below, times = np.zeros_like(owner), dict[int, np.ndarray]()
        depth = np.zeros(len(caps), dtype=np.int64)  # how many larger limbs each stands on
        for number in order:
            region = caps[number].region
            depth[number], owner[region] = below[caps[number].tip], number + 1
            below[region] += 1
        for level in np.unique(depth):
            own, here = np.zeros_like(owner), [number for number in order if depth[number] == level]
            for number in here:
                own[caps[number].region] = number + 1
            blunt = [number + 1 for number in here if caps[number].slenderness < OBLIQUE]
            times |= dict.fromkeys(here, ends.times_across(self.surface.points, self.surface.faces, own, blunt))
        return [times[number] for number in range(len(caps))]

    def _raised(self, caps: list[Cap], owner: np.ndarray, times: list[np.ndarray], least: float) -> list[Raised]:
        """Limbs around tips where the surface stands out (see `protrusions`), besides the limbs ``caps``, and beyond
        their ends, by their numbers ``owner`` (V,) and exit times (V,) of each.

        Of the caps around such a tip, up to the next tip of a limb, the slenderest one counts that is followed by a
        much less slender one: a foot ends where the body begins. It is more slender than the corner of a plate, or half
        a ball, with as much volume for its area.
        """
        x, raised = self.surface.points, []
        others = np.zeros(len(x), dtype=np.int64)
        others[[cap.tip for cap in caps]] = 1
        for tip, height, scale in zip(*raised_tips(x, self.surface.faces, BALL), strict=True):
            near = np.flatnonzero(others)
            is_end = (np.linalg.norm(x[near] - x[tip], axis=1) <= TIPS_APART * scale).any()
            own = owner[tip] - 1
            if is_end or (own >= 0 and ends.is_near_end(times[own], *caps[own][2:], np.array([tip]))[0]):
                continue
            if self._left[self._component[tip]] < 0:
                self.was_hit = True
                continue
            rows, _ = self.grown(tip, others, np.inf, LARGEST_CAP, 0.0)
            if not len(rows):
                continue
            value, after = rows[:, 0], np.minimum.accumulate(rows[::-1, 0])[::-1]
            is_counted = np.append(after[1:], np.inf) <= DROP * value
            best = int(np.where(is_counted, value, -1.0).argmax())
            need = least * float(np.interp(rows[best, 6] / rows[best, 2] ** 1.5, *CORNER))
            score = min(height / RAISED, value[best] / need)
            if not is_counted[best] or score < LEAST_RAISED:
                continue
            region = self.grown(tip, others, float(value[best]), LARGEST_CAP, 0.0)[1]
            if 2 * len(region) >= TRIANGLES and not self._is_apex(tip, region, least):
                cap = Cap(int(tip), float(value[best]), float(rows[best, 2]), region)
                raised.append(Raised(max(1.0 - score / 2, 0.01), cap))
                others[tip] = 1
        return raised

    def _is_apex(self, tip: int, region: np.ndarray, least: float) -> bool:
        """Whether the cap ``region`` (r,) around ``tip`` is the apex of a mitre (see `is_apex`)."""
        if (tip, least) not in self._apexes:
            self._apexes[tip, least] = is_apex(self.shape, self._distances(np.array([tip])), region, least)
        return self._apexes[tip, least]

    def _halves(self, number: int) -> tuple[list[Cap], bool]:
        """The halves of a component, as caps, and whether it is long in one direction (see `ends.halves`)."""
        part = self._part(number)
        value, is_long = ends.halves(part.points, part.faces)
        return [cap_where(part, int(part.member[side.argmax()]), side) for side in (value, -value)], is_long

    def axis(self, shape: Enclosure, limbs: Limbs, number: int) -> ends.LimbAxis:
        """The curve of one of the limbs in the solid ``shape``."""
        return ends.axis(shape, self.surface.points, self.surface.faces, limbs.times[number], limbs.caps[number].region)

    def _slender(
        self, tips: np.ndarray, owner: np.ndarray, most: np.ndarray, least: float, share: float
    ) -> list[tuple[int, Cap | None]]:
        """The tips of limbs with caps of at most that ``share`` of the surface, up to the limbs in ``owner`` (V,).

        Caps that overlap, but not each other's tips, grow together: these tips come with their caps. It numbers
        their vertices in ``owner``, and sets ``most`` (V,) to the largest slenderness around the tips.
        """
        others, found = (owner > 0).astype(np.int64), []
        for tip in tips.tolist():
            if self._left[self._component[tip]] < 0:
                self.was_hit = True
                continue
            best, rows, region = self._slenderest(tip, others, least, share)
            most[tip] = rows[:, 0].max(initial=0.0)
            if most[tip] >= least and _own(rows) >= ROUND_END and not self._is_apex(best, region, least):
                found.append((rows[-1, 2], best, rows[-1, 1], region))
        disc: dict[int, tuple[int, float]] = {}  # of each limb, by its number: tip and radius
        group: dict[int, dict[int, Cap]] = {}  # of each limb that shares: its own cap, and of those that it meets
        for _, tip, radius, region in sorted(found, key=lambda each: each[:2]):
            number, met = int(owner.max()) + 1, set(owner[region].tolist()) - {0}
            if met:
                is_apart = owner[tip] == 0 and not np.isin([disc[each][0] for each in met], region).any()
                if not is_apart or self._left[self._component[tip]] < 0:
                    continue
                members = sorted(met.union(*(group.get(each, {}) for each in met)))
                caps = self._meeting([(tip, radius)] + [disc[each] for each in members])
                if min(cap.slenderness for cap in caps) < least:
                    continue
                own = dict(zip([number, *members], caps, strict=True))
                group |= dict.fromkeys(own, own)
                for each, cap in own.items():
                    owner[cap.region[np.isin(owner[cap.region], [0, *own])]] = each
            else:
                owner[region] = number
            disc[number] = tip, radius
        return [(tip, group[number][number] if number in group else None) for number, (tip, _) in disc.items()]

    def _meeting(self, discs: list[tuple[int, float]]) -> list[Cap]:
        """The caps of ``discs``, tips and radii, that grow together (see `grown_together`)."""
        part, (tips, radii) = self._part(int(self._component[discs[0][0]])), np.array(discs).T
        away = np.stack([self._distances(np.array([tip]))[part.member] for tip, _ in discs])
        self._left[self._component[discs[0][0]]] -= len(discs)
        return grown_together(part, tips.astype(np.int64), away, radii, RATIO)

    def _part(self, number: int) -> Patch:
        """A component of the surface."""
        of_face, member = self._component[self.surface.faces[:, 0]] == number, np.flatnonzero(self._component == number)
        faces = np.searchsorted(member, self.surface.faces[of_face])
        return Patch(member, self.surface.points[member], faces, self.area[of_face])

    def _slenderest(
        self, tip: int, others: np.ndarray, least: float, share: float
    ) -> tuple[int, np.ndarray, np.ndarray]:
        """``tip``, or a neighbour of it, with its caps (see `grown`): those of a blunt limb change with their tip."""
        best, (rows, region) = tip, self.grown(tip, others, least, share)
        most = rows[:, 0].max(initial=0.0)
        if NEARLY * least <= most < least:
            around = self.surface.around[self.surface.first[tip] : self.surface.first[tip + 1]]
            for near in np.setdiff1d(self.surface.faces[around], [tip]).tolist():
                other, other_region = self.grown(near, others, least, share)
                if other[:, 0].max(initial=0.0) > most:
                    most, best, rows, region = other[:, 0].max(), near, other, other_region
        return best, rows, region

    def slenderness(self, foot: np.ndarray, tip: np.ndarray, enough: float = np.inf) -> np.ndarray:
        """The largest slenderness (l,) of the caps around each of the vertices ``tip`` (l,), without another one of
        them or another ``foot`` (l,), or some value of at least ``enough``. One tip of several feet stands for none."""
        tip = np.where(np.bincount(tip, minlength=len(self._total))[tip] > 1, foot, tip)
        found = np.zeros(len(tip))
        for number in range(len(tip)):
            others = np.zeros(len(self._total), dtype=np.int64)
            others[np.delete(foot, number)] = others[np.delete(tip, number)] = 1
            others[tip[number]] = 0
            found[number] = self.grown(tip[number], others, enough, 1.0)[0][:, 0].max(initial=0.0)
        return found

    def _of(self, tip: int, others: np.ndarray, enough: float) -> Cap:
        """The slenderest cap around ``tip`` below half of the surface without a vertex of ``others`` (V,), or the first
        cap of any size that is slender ``enough``."""
        rows, region = self.grown(tip, others, enough, 0.5 if enough == np.inf else 1.0)
        best = int(rows[:, 0].argmax())
        return Cap(tip, float(rows[best, 0]), float(rows[best, 2]), region)


def _own(rows: np.ndarray) -> float:
    """The largest slenderness of the caps of `Caps.grown` before a disc goes around a handle or a larger part."""
    gap = np.flatnonzero(rows[1:, 1] > 1.01 * RATIO * rows[:-1, 1])
    return float(rows[: gap[0] + 1 if len(gap) else None, 0].max())


def protrusions(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """(S, V) the protrusion of each vertex at each of `HEAT_SCALES`: where a surface stands out.

    After a heat flow of scale s, a point x of the surface has come to x_s, the mean of the surface around it:

        (M + s^2 / 4 L) x_s = M x,    protrusion h = n . (x - x_s) / s,

    with cotangent weights L and areas M. It is at most 1 / 4 on a long cylinder and `BALL` on a ball, 1 / 2 at the end
    of a thin rod, and more where that narrows.
    """
    matrix, share = ends.laplacian(vertices, faces)
    size, corners = float(np.sqrt(share.sum())), vertices[faces]
    around = cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normal = unit(
        np.stack([np.bincount(faces.ravel(), np.repeat(column, 3), len(vertices)) for column in around.T], axis=1)
    )
    found, mass = np.empty((len(HEAT_SCALES), len(vertices))), sparse.diags_array(share)
    for row, scale in enumerate(sorted(HEAT_SCALES * size)):
        solver = surface_factor((mass + scale**2 / 4 * matrix).tocsc())
        found[row] = np.einsum("vi,vi->v", normal, vertices - solver.solve(share[:, None] * vertices)) / scale
    return found


def raised_tips(vertices: np.ndarray, faces: np.ndarray, least: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Vertices (t,) whose protrusion is the largest around them at some scale: with a protrusion of at least ``least``,
    the largest one first, that protrusion (t,), and its scale (t,), a length."""
    height, scale = (
        protrusions(vertices, faces),
        np.sort(HEAT_SCALES) * np.sqrt(ends.laplacian(vertices, faces)[1].sum()),
    )
    tail, head = faces.ravel(), np.roll(faces, -1, axis=1).ravel()
    row, vertex = [], []
    for number, own in enumerate(height):
        is_tip = own >= least
        is_tip[tail[own[head] > own[tail]]] = is_tip[head[own[tail] > own[head]]] = False
        vertex.append(np.flatnonzero(is_tip))
        row.append(np.full(len(vertex[-1]), number))
    rows, places = np.concatenate(row), np.concatenate(vertex)
    order = np.lexsort((places, -height[rows, places]))[: 4 * MOST_RAISED]
    rows, places = rows[order], places[order]
    kept: list[int] = []
    for number in range(len(rows)):
        reach = TIPS_APART * np.maximum(scale[rows[kept]], scale[rows[number]])
        away = np.linalg.norm(vertices[places[kept]] - vertices[places[number]], axis=1)
        if (away > reach).all() and len(kept) < MOST_RAISED:
            kept.append(number)
    return places[kept], height[rows[kept], places[kept]], scale[rows[kept]]


def is_apex(shape: Enclosure, away: np.ndarray, region: np.ndarray, least: float) -> bool:
    """Whether the cap ``region`` (r,) of the solid ``shape`` is the apex of a mitre, and no limb that sticks out of the
    bars there by ``least`` of their half widths. ``away`` (V,) is the distance from the cap's tip.

    A mitre, where two bars meet in an acute corner, looks like a limb, and is the outside of a bend. A disc around its
    apex grows until its front divides into two rings, around the two bars. Let lines along their axes, in the unit
    directions d and e from the corner, pass each other at p, and let u = -(d + e) / |d + e|. Beyond p the solid of a
    mitre is where both bars go on:

        (x - p) . u > 0   only for x within the section of each bar, moved along its axis.

    A limb sticks out of one of them. If it does so by h in the direction u, a point at its end is h sin(a / 2) outside
    the sides of bars that meet at the angle a.
    """
    first = last = float(away[region].max())
    while True:
        last *= np.exp(MITRE_STEP * MITRE_RINGS)
        near, local = np.unique(shape.faces[(away < last)[shape.faces].any(axis=1)], return_inverse=True)
        height = np.log(np.clip(away[near], first / 2, last)) / MITRE_STEP
        found = levels(shape.vertices[near], local.reshape(-1, 3), height, 1.0)
        pieces, rings, arms = _followed(found, int(found.piece[away[near].argmin()]))
        if arms and len(rings) < 2 * MITRE_WIDER:  # the cap reaches beyond
            first, last = first / 2, last / np.exp(MITRE_STEP * MITRE_RINGS)
            continue
        if not _is_widening(found.perimeter[rings]):
            return False
        if arms and len(rings) + MITRE_RINGS <= np.log(2 * last / first) / MITRE_STEP:
            apex = shape.vertices[near[np.isin(found.piece, pieces)]]
            return len(arms) == 2 and min(map(len, arms)) > 1 and _is_in_both(shape, found, arms, apex, least)
        if last >= away[np.isfinite(away)].max():
            return False


def _above(found: Levels, piece: int) -> np.ndarray:
    """The rings upon a piece, without those around bumps."""
    above = np.flatnonzero(found.below == piece)
    return above[found.perimeter[above] > ends.HALF * found.perimeter[above].max(initial=0.0)]


def _followed(found: Levels, piece: int) -> tuple[list[int], list[int], list[list[int]]]:
    """Where the front goes from ``piece`` on: its pieces and rings up to where it divides, and the rings of each of
    the parts beyond, up to the narrowest."""
    pieces, rings = [piece], []
    while len(above := _above(found, pieces[-1])) == 1:
        rings.append(int(above[0]))
        pieces.append(int(found.above[above[0]]))
    arms = [[ring] for ring in above.tolist()]
    for arm in arms:
        while len(arm) < MITRE_RINGS and len(above := _above(found, int(found.above[arm[-1]]))) == 1:
            arm.append(int(above[0]))
        arm[:] = arm[: int(found.perimeter[arm].argmin()) + 1]
    return pieces, rings, arms


def _is_widening(length: np.ndarray) -> bool:
    """Whether rings of ``length`` (k,) get longer, as those of a wedge do, and no faster than their distance from the
    tip. The first ones, around a tip on an edge, need not, and the last ones may where the front divides."""
    growth = length[MITRE_WIDER:] / length[:-MITRE_WIDER]
    if not len(growth):
        return False
    is_longer = growth[min(MITRE_WIDER, len(growth) - 1) :] > 1
    return bool(is_longer.all() and (growth[:-MITRE_WIDER] <= np.exp(MITRE_STEP * MITRE_WIDER) + ROUNDING).all())


def _is_in_both(shape: Enclosure, found: Levels, arms: list[list[int]], apex: np.ndarray, least: float) -> bool:
    """Whether the points ``apex`` (k, 3) beyond the axes of two ``arms``, and there are some, are within both."""
    (p, d, one), (q, e, other) = (_axis(shape, found, arm) for arm in arms)
    if d @ e <= 0 or np.linalg.norm(cross(d, e)) < ROUNDING:
        return False
    s, t = np.linalg.lstsq(np.stack([d, -e], axis=1), q - p, rcond=None)[0]
    u = -unit(d + e)
    apex = apex[(apex - (p + s * d + q + t * e) / 2) @ u > 0]
    sine = np.linalg.norm(cross(d, u))
    bars = (p, d, one), (q, e, other)
    return len(apex) > 0 and all(_outside(shape, *bar, apex) <= least * bar[2] * sine for bar in bars)


def _axis(shape: Enclosure, found: Levels, rings: list[int]) -> tuple[np.ndarray, np.ndarray, float]:
    """A point (3,) on the axis of a bar, its direction (3,), and half of its width."""
    pair = [rings[-1], rings[len(rings) // 2 - 1]]
    places, size = found.centre[pair], found.size[pair]
    for _ in range(ends.LINE_ROUNDS):
        places = ends.centred(shape, places, unit(places[0] - places[1]), size)
    return places[0], unit(places[0] - places[1]), float(size[0])


def _outside(shape: Enclosure, place: np.ndarray, along: np.ndarray, size: float, points: np.ndarray) -> float:
    """How far ``points`` (k, 3) are outside a bar ``along`` (3,) with the section at ``place`` (3,), the largest."""
    corners = sections.corners(shape, place[None], along[None], np.array([size]))
    if not corners.is_closed[0]:
        return np.inf
    aside = points - place
    aside = aside - (aside @ along)[:, None] * along
    edge = (unit(aside) @ (corners.places(shape) - place).T).max(axis=1)
    return float((np.linalg.norm(aside, axis=1) - edge).max())
