"""The limbs of a solid, found on its surface: caps that are long for the curve that cuts them off.

The points of the surface within a geodesic distance of a *tip* are a disc. Its longest boundary curve, of length P,
cuts off a *cap* of area A: the disc, and the smaller parts that its other boundary curves enclose. The cap's
*slenderness* is

    2 pi A / P^2 - 1 / 2.

It is 0 for a flat disc, 1 / 2 for half a ball, and h / radius for a cylinder that sticks out by h from a larger body.
Unlike a measure along a curve, it does not depend on where the curve runs, and little on the size of the triangles. The
smallest cap around a tip that is slender enough is a *limb*, unless it overlaps a smaller one.

A tip is a vertex whose average geodesic distance from the surface is larger than that of its neighbours (Hilaga,
Shinagawa, Kohmura, Kunii 2001).
"""

from typing import NamedTuple

import numpy as np

from msf_jax.host.solid.enclosure import Enclosure
from msf_jax.host.thin import fronts

SOURCES = 16  # points, far from each other, whose distances are averaged
FIRST_RADIUS = 0.002  # of the first disc, in square roots of the surface's area
RATIO = 1.06  # of the radii of successive discs
BLUNT = 0.6  # least slenderness of a limb's own end: above half a ball, 0.5, and the corner of a box
GAP = 0.3  # radii of the limb between the end of its curve and the tip
MOST_DISCS = 200  # radii: more than from the first one to the whole of a surface
MOST_TIPS = 100  # places that are tried, besides the curve's leaves, those with the largest average distance first
MOST_AREA = 100.0  # surfaces: area of all discs together; then no further tip is tried


class Cap(NamedTuple):
    """tip: a vertex. slenderness, area: of the cap. middles: (k, 3) of the curves of the tip's discs, from the tip on,
    up to the one that cuts the cap off. step: half the mean radius of these curves. region: (r,) the cap's vertices."""

    tip: int
    slenderness: float
    area: float
    middles: np.ndarray
    step: float
    region: np.ndarray


class Caps:
    """The caps of the closed, connected surface ``shape``. ``was_hit``: whether `MOST_AREA` was reached."""

    def __init__(self, shape: Enclosure):
        x, faces = shape.vertices, shape.faces
        around = np.argsort(faces.ravel(), kind="stable") // 3
        first = np.concatenate([[0], np.cumsum(np.bincount(faces.ravel(), minlength=len(x)))])
        a, b, c = shape.triangles[:, 0], shape.triangles[:, 1], shape.triangles[:, 2]
        area = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
        self.surface = fronts.Surface(x, faces, shape.mesh.twins, first, around, area)
        num, size = len(x), 9 * len(faces)
        state, order, filled, stack = np.zeros((4, num), dtype=np.int64)
        key, value = np.empty(size), np.empty(size, dtype=np.int64)
        ring = np.full(len(faces), -1)
        self._front = fronts.Scratch(np.full(num, np.inf), state, order, filled, stack, key, value, ring)
        self._left, self.was_hit = MOST_AREA, False
        self._rows = np.empty((MOST_DISCS + 3, 6))
        self._region = np.empty(len(x) + 1, dtype=np.int64)

    def grown(
        self, tip: int, others: np.ndarray, enough: float = np.inf, share: float = 0.5
    ) -> tuple[np.ndarray, np.ndarray]:
        """The caps around ``tip``, one in each row (k, 6), and the vertices (r,) of the last cap.

        A row is slenderness, radius of the disc, area and middle of the curve. The last cap is the first one of
        ``enough`` slenderness, or the last one below that ``share`` of the surface and without a vertex of ``others``
        (V,).
        """
        total = float(self.surface.area.sum())
        first, most = FIRST_RADIUS * np.sqrt(total), share * total
        count = fronts.cap(
            self.surface, self._front, int(tip), first, RATIO, enough, most, others, self._rows, self._region
        )
        end = int(np.argmax(self._region == -1))
        self._left -= self._rows[count - 1, 2] / total if count else 0.0
        return self._rows[:count].copy(), self._region[:end].copy()

    def tips(self) -> np.ndarray:
        """Vertices (t,) where the average geodesic distance is largest among their neighbours, the largest first."""
        x, faces = self.surface.points, self.surface.faces
        share = np.bincount(faces.ravel(), np.repeat(self.surface.area / 3, 3), len(x))
        source = int(((x - share @ x / share.sum()) ** 2).sum(axis=1).argmin())
        away = np.empty((SOURCES, len(x)))
        source = int(np.nan_to_num(self._distances(source), posinf=-1.0).argmax())
        for row in range(SOURCES):
            away[row] = self._distances(source)
            source = int(np.nan_to_num(away[: row + 1].min(axis=0), posinf=-1.0).argmax())
        weight = np.bincount(away.argmin(axis=0), share, SOURCES)
        height = weight @ np.nan_to_num(away, posinf=0.0) / weight.sum()
        tail, head = faces.ravel(), np.roll(faces, -1, axis=1).ravel()
        above = np.full(len(x), -np.inf)
        np.maximum.at(above, tail, height[head])
        top = np.flatnonzero(height >= above)
        return top[np.argsort(-height[top], kind="stable")][:MOST_TIPS]

    def _distances(self, source: int) -> np.ndarray:
        fronts.spread(self.surface, self._front, source)
        found = self._front.distance.copy()
        self._front.distance[:], self._front.state[:] = np.inf, 0
        return found

    def limbs(self, least: float, more: np.ndarray) -> tuple[list[Cap], np.ndarray]:
        """The limbs of at least that slenderness, with tips among `tips` and the vertices ``more`` (m,).

        First come caps below half of the surface. Then the rest may be a limb, too, up to the first ones: the body of a
        bunny is the other end of its ears. Last come blunt ends of parts with limbs, such as the nose of a head with
        ears. Also returns the largest slenderness (m,) of the caps around ``more``, as far as they were grown, infinite
        for vertices that were not tried.
        """
        tips = np.array(list(dict.fromkeys([*self.tips().tolist(), *more.tolist()])), dtype=np.int64)
        most = np.zeros(len(self.surface.points))
        owner = np.zeros(len(most), dtype=np.int64)  # the number of the limb of each vertex, from 1; 0 for none
        # Of each limb, its tip and the slenderness of its cap: below half of the surface, the largest one.
        limbs = [(tip, np.inf) for tip in self._slender(tips, owner, most, least, 0.5)]
        if limbs:
            limbs += [(tip, least) for tip in self._slender(tips[owner[tips] == 0], owner, most, least, 1.0)]
            limbs += self._blunt(tips[owner[tips] == 0], owner, least)
        caps = [
            self._of(tip, ((owner > 0) & (owner != number)).astype(np.int64), enough)
            for number, (tip, enough) in enumerate(limbs, 1)
        ]
        return caps, most[more]

    def _slender(self, tips: np.ndarray, owner: np.ndarray, most: np.ndarray, least: float, share: float) -> list[int]:
        """The tips of limbs with caps of at most that ``share`` of the surface.

        Numbers their vertices in ``owner`` (V,), and sets ``most`` (V,) to the largest slenderness around the tips.
        """
        is_tip, found = np.zeros_like(owner), []
        if share > 0.5:
            is_tip[:] = owner > 0
        for tip in tips.tolist():
            if self._left < 0:
                most[tip], self.was_hit = np.inf, True
                continue
            rows, region = self.grown(tip, is_tip, least, share)
            most[tip] = rows[:, 0].max(initial=0.0)
            if most[tip] >= least and _own(rows) >= BLUNT:
                found.append((rows[-1, 2], tip, region))
                is_tip[tip] = share <= 0.5  # no disc grows over the tip of a limb that was found before
        limbs = []
        for _, tip, region in sorted(found, key=lambda each: each[:2]):
            if not owner[region].any():
                limbs.append(tip)
                owner[region] = owner.max() + 1
        return limbs

    def _blunt(self, tips: np.ndarray, owner: np.ndarray, least: float) -> list[tuple[int, float]]:
        """The tips of blunt ends, and their slenderness up to the limbs that ``owner`` (V,) numbers. It numbers theirs.

        Together with these limbs, the part that ends there is slender.
        """
        found = []
        for tip in tips.tolist() if self._left > 0 else []:
            own = self.grown(tip, (owner > 0).astype(np.int64))[0][:, 0].max(initial=0.0)
            if not BLUNT <= own < least:
                continue
            if self.grown(tip, np.zeros_like(owner), least)[0][:, 0].max(initial=0.0) >= least:
                found.append((own, tip))
        limbs = []
        for own, tip in sorted(found, key=lambda each: (-each[0], each[1])):
            rows, region = self.grown(tip, (owner > 0).astype(np.int64), own)
            if len(rows) and rows[-1, 0] >= own:
                limbs.append((tip, own))
                owner[region] = owner.max() + 1
        return limbs

    def _of(self, tip: int, others: np.ndarray, enough: float) -> Cap:
        """The slenderest cap around ``tip`` below half of the surface without a vertex of ``others`` (V,), or the first
        cap of any size that is slender ``enough``."""
        share = 0.5 if enough == np.inf else 1.0
        rows, region = self.grown(tip, others, enough, share)
        if enough == np.inf:
            rows, region = self.grown(tip, others, float(rows[:, 0].max()), share)
        radius = np.sqrt(rows[:, 2] / (2 * np.pi * (rows[:, 0] + 0.5)))  # the curve's length over 2 pi
        size = float(np.median(radius[len(rows) // 2 :]))
        rows = rows[min(int((rows[:, 1] > GAP * size).argmax()), len(rows) - 1) :]
        return Cap(tip, float(rows[-1, 0]), float(rows[-1, 2]), rows[:, 3:], size / 2, region)


def _own(rows: np.ndarray) -> float:
    """The largest slenderness of the caps of `Caps.grown` before a disc goes around a handle or a larger part."""
    gap = np.flatnonzero(rows[1:, 1] > 1.01 * RATIO * rows[:-1, 1])
    return float(rows[: gap[0] + 1 if len(gap) else None, 0].max())
