"""Checks whether a followed curve is still valid in the moved mesh, against the whole moved surface.

`follow` uses only the recorded cross-sections. They can look right although a limb has entered another one, or a new
limb has grown. So these checks do not use them. Distances to the whole moved surface are exact. Winding numbers are
compared with those in the recorded mesh. Faces that are far apart along the surface must not cross. The balls of the
curve must still cover the surface as well as before, and each vertex must still be near its own node. Lengths are
compared relative to the growth of the mesh. A fault counts only if it also shows against the recorded mesh under the
best fitting affine map, so that stretching the whole mesh is no fault.
"""

from typing import NamedTuple

import numpy as np
from scipy import spatial

from msf_jax.recording.following import BoundSurface
from msf_jax.solid.crossings import Crossings
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import repeated
from msf_jax.solid.solid import Solid
from msf_jax.topology import graphs

# Chosen on three shapes (a capsule, a hand, three limbs) and tested on others, see tests/benchmarks/adversary.py. In
# brackets is the worst value in good frames: bends of up to 60 degrees, noise of 0.001 diagonals.
MISJUDGED = 0.35  # relative error of a followed radius that counts as wrong (0.05)
PINCHED = 0.5  # ratio of a node's radius to the recorded one, below which its ball has shrunk (0.8)
UNEXPLAINED = 1.0  # radii: growth of a vertex's distance from all balls that counts as a new limb (0.5; new limbs: 2)
WIDE = 0.25  # share of the recorded distance that the growth must exceed in addition; it is large in sheets
STRETCHED = 2.5  # ratio of a stretch's length to the recorded one, above which it is strained (1.03)
SHORTENED = 0.4  # the same ratio, below which it is strained (0.9)
NEAR_CROSSING = 0.75  # radii: crossings this near to faces that crossed in the recorded mesh are not new
SLIGHT = 0.005  # diagonals: radii count as at least this, because noise dominates shorter lengths
HELD = 1e-6  # diagonals: nodes this near to the surface were pinned to it, and are neither inside nor outside
NEAREST = 4  # nearest centres whose balls are tested, among balls of similar size
SAMPLES = 16  # sample points on an edge that the balls of its ends do not cover


class Held(NamedTuple):
    """The checks of a curve in a frame. `track.TrackedFrame` describes the fields."""

    radii: np.ndarray
    inside: float
    overlapped: float
    overlaps: np.ndarray
    crossings: int
    unexplained: float
    misjudged: np.ndarray
    pinched: np.ndarray
    strained: np.ndarray


class Measured(NamedTuple):
    """Lengths of a curve in a surface.

    radii: (N,) exact. gap: (V,) distance of each vertex from the balls. reach: (V,) distance of each vertex from its
    own node. length: (E,) of edges.
    """

    radii: np.ndarray
    gap: np.ndarray
    reach: np.ndarray
    length: np.ndarray

    def scaled(self, factor: float) -> "Measured":
        """All lengths multiplied by ``factor``."""
        return Measured(*(factor * values for values in self))


class Stretches(NamedTuple):
    """S stretches of branches; each consists of the consecutive edges ``order[first:last]``."""

    order: np.ndarray
    first: np.ndarray
    last: np.ndarray

    def lengths(self, of_edge: np.ndarray) -> np.ndarray:
        """(S,) the sum over each stretch of a quantity ``of_edge`` (E,); NaN counts as 0."""
        along = np.r_[0.0, np.cumsum(np.nan_to_num(of_edge[self.order].astype(float)))]
        return along[self.last] - along[self.first]

    def edges_of(self, chosen: np.ndarray) -> np.ndarray:
        """The edges that are in any of the ``chosen`` (S,) stretches."""
        change = np.zeros(len(self.order) + 1, dtype=np.int64)
        np.add.at(change, self.first[chosen], 1)
        np.add.at(change, self.last[chosen], -1)
        return self.order[np.cumsum(change)[:-1] > 0]


class Holding:
    """The recorded curve that frames are compared with: ``nodes`` (N, 3), ``edges`` (E, 2), in ``surface``'s units."""

    def __init__(self, surface: BoundSurface, nodes: np.ndarray, edges: np.ndarray):
        self.solid, self.node, self.edges, self.nodes = surface.solid, surface.node, edges, nodes
        shape, x = self.solid.shape, self.solid.enter(nodes)
        self.winding = shape.winding_numbers(x)
        along = shape.winding_numbers(_samples(x, edges, np.arange(len(edges)))).reshape(-1, SAMPLES)
        self.most, self.along = np.maximum(self.winding, 1), np.maximum(along, 1)  # a winding number of 1 is no overlap
        self.recorded = _measured(shape, x, self.node, edges, np.ones(len(x), dtype=bool), self.winding)
        thick, length = np.maximum(self.recorded.radii, SLIGHT), self.recorded.length
        self.crossings = Crossings(shape.vertices, shape.faces, self.node, thick, edges, length)
        # Near faces that crossed in the recorded mesh, noise makes other faces cross: these are no fault.
        self.tangle = spatial.KDTree(self.crossings.place[self.crossings.found(shape.vertices).ravel()])
        self.stretches = _stretches(len(x), edges, length, thick)
        self.sides = _sides(shape)

    def held(self, vertices: np.ndarray, nodes: np.ndarray, followed: np.ndarray) -> Held:
        """The checks of a frame: ``vertices`` (v, 3) of the surface, ``nodes`` (N, 3), NaN where they have vanished,
        and the ``followed`` (N,) radii. All lengths are in the caller's units."""
        is_there = np.asarray(np.isfinite(nodes).all(axis=1))
        everyone = np.arange(len(nodes))
        if not (is_there.any() and np.ptp(vertices, axis=0).any()):
            return Held(np.full(len(nodes), np.nan), 0.0, 1.0, everyone, 0, 1.0, *[everyone[:0]] * 3)
        solid = Solid(vertices, self.solid.shape.faces)
        x = solid.enter(np.where(is_there[:, None], nodes, solid.centre))
        winding = solid.shape.winding_numbers(x)
        now = _measured(solid.shape, x, self.node, self.edges, is_there, winding)
        inside, overlapped = self._wound(solid.shape, x, now, winding, is_there)
        was = self.recorded
        is_free = is_there & (was.radii > HELD)
        sides = _sides(solid.shape)
        scale = float(np.median(sides / np.maximum(self.sides, 1e-300)))
        faults = self._faults(now, was.scaled(scale), is_free)
        if any(fault.any() for fault in faults):
            stretched = self._stretched(solid)
            if stretched is not None:
                again = self._faults(now, stretched, is_free)
                faults = [fault & other for fault, other in zip(faults, again, strict=True)]
        gap, pinched, strained = faults
        off = np.abs(np.abs(followed) / solid.diagonal - now.radii)
        misjudged = is_free & (off > MISJUDGED * np.maximum(now.radii, 0.2 * scale * was.radii) + SLIGHT * MISJUDGED)
        return Held(
            radii=np.where(is_there, np.where(winding > 0, 1.0, -1.0) * solid.diagonal * now.radii, np.nan),
            inside=inside,
            overlapped=overlapped,
            overlaps=np.flatnonzero(is_free & (winding > self.most)),
            crossings=self._num_crossed(solid.shape.vertices),
            unexplained=float(solid.vertex_areas[gap].sum()),
            misjudged=np.flatnonzero(misjudged),
            pinched=np.flatnonzero(pinched),
            strained=np.flatnonzero(strained),
        )

    def _num_crossed(self, vertices: np.ndarray) -> int:
        """Number of pairs of faces that cross away from the faces that crossed in the recorded mesh."""
        pairs, of = self.crossings.found(vertices), self.crossings
        away = self.tangle.query(of.place[pairs])[0]
        return int((away > np.maximum(NEAR_CROSSING * of.radii[of.node[pairs]], SLIGHT)).any(axis=1).sum())

    def _wound(
        self, shape: Enclosure, x: np.ndarray, now: Measured, winding: np.ndarray, is_there: np.ndarray
    ) -> tuple[float, float]:
        """Fractions of the curve's length: with a positive winding number; with one above 1 and above the recorded."""
        there = np.flatnonzero(is_there[self.edges].all(axis=1))
        length, ends = now.length[there], self.edges[there]
        changed = winding > self.most
        if not length.sum() > 0:  # without length, count nodes
            return float((winding > 0)[is_there].mean()), float(changed[is_there].mean())
        # If the balls of its ends cover an edge, the surface does not cross it, and needs no samples.
        inside, other = (winding > 0)[ends[:, 0]].astype(float), changed[ends[:, 0]].astype(float)
        balls = np.where(winding > 0, now.radii, 0.0)
        is_open = (length >= balls[ends].sum(axis=1)) | (winding[ends] <= 0).any(axis=1)
        rows = there[is_open]
        found = shape.winding_numbers(_samples(x, self.edges, rows)).reshape(-1, SAMPLES)
        inside[is_open], other[is_open] = (found > 0).mean(axis=1), (found > self.along[rows]).mean(axis=1)
        return tuple(float((share * length).sum() / length.sum()) for share in (inside, other))  # type: ignore

    def _faults(self, now: Measured, was: Measured, is_free: np.ndarray) -> list[np.ndarray]:
        """(v,) vertices outside of all balls, (N,) nodes whose ball has shrunk, (N,) nodes in strained stretches."""
        thick = np.maximum(np.maximum(was.radii, np.nan_to_num(now.radii))[self.node], SLIGHT)
        # A new limb may be inside the ball of another limb; then only the distance from its own node has grown.
        gap = now.gap - was.gap > UNEXPLAINED * thick + WIDE * was.gap
        gap |= now.reach - was.reach > UNEXPLAINED * thick + WIDE * was.reach
        pinched = is_free & (now.radii < PINCHED * was.radii - SLIGHT * PINCHED)
        stretch = self.stretches.lengths(now.length) / np.maximum(self.stretches.lengths(was.length), 1e-300)
        is_gone = self.stretches.lengths(np.asarray(~is_free[self.edges].all(axis=1))) > 0
        edges = self.stretches.edges_of(~is_gone & ((stretch > STRETCHED) | (stretch < SHORTENED)))
        strained = np.zeros(len(is_free), dtype=bool)
        strained[self.edges[edges].ravel()] = True
        return [gap, pinched, strained]

    def _stretched(self, solid: Solid) -> Measured | None:
        """The recorded curve and mesh under the affine map that best fits the moved mesh; None if it reflects."""
        before, after = self.solid.shape.vertices, solid.shape.vertices
        mean, away = before.mean(axis=0), after.mean(axis=0)
        matrix = np.linalg.lstsq(before - mean, after - away, rcond=None)[0]
        if np.linalg.det(matrix) <= 0:
            return None
        shape = Enclosure((before - mean) @ matrix + away, solid.shape.faces)
        x = (self.solid.enter(self.nodes) - mean) @ matrix + away
        return _measured(shape, x, self.node, self.edges, np.ones(len(x), dtype=bool), self.winding)


def _stretches(num: int, edges: np.ndarray, length: np.ndarray, thick: np.ndarray) -> Stretches:
    """A stretch from each edge along its branch, as long as the limb's radius ``thick`` (N,) there.

    A stretch ends at the end of its branch. If it is then shorter than half of that radius, it is left out.
    """
    paths = [np.asarray(path) for path in graphs.trace(num, edges) if len(path) > 1]
    empty = np.zeros(0, dtype=np.int64)
    pairs = np.concatenate([np.empty((0, 2), np.int64), *(np.stack([path[:-1], path[1:]], axis=1) for path in paths)])
    code = np.sort(edges, axis=1) @ [num, 1]
    by_code = np.argsort(code)
    order = by_code[np.searchsorted(code[by_code], np.sort(pairs, axis=1) @ [num, 1])] if len(pairs) else empty
    count = np.array([len(path) - 1 for path in paths], dtype=np.int64)
    end, first = np.repeat(np.cumsum(count), count), np.arange(len(order))
    along = np.r_[0.0, np.cumsum(length[order])]
    reach = thick[pairs[:, 0]]
    last = np.minimum(np.maximum(np.searchsorted(along, along[first] + reach), first + 1), end)
    is_long = along[last] - along[first] >= 0.5 * reach
    return Stretches(order, first[is_long], last[is_long])


def _samples(x: np.ndarray, edges: np.ndarray, rows: np.ndarray) -> np.ndarray:
    """``SAMPLES`` evenly spaced points on each of the edges ``rows``."""
    t = ((np.arange(SAMPLES) + 0.5) / SAMPLES)[:, None]
    a, b = x[edges[rows, 0]], x[edges[rows, 1]]
    return (a[:, None] + t * (b - a)[:, None]).reshape(-1, 3)


def _sides(shape: Enclosure) -> np.ndarray:
    """(F, 3) lengths of the sides of all faces."""
    return np.linalg.norm(np.roll(shape.triangles, -1, axis=1) - shape.triangles, axis=2)


def _measured(
    shape: Enclosure, x: np.ndarray, node: np.ndarray, edges: np.ndarray, is_there: np.ndarray, winding: np.ndarray
) -> Measured:
    """The lengths of a curve with nodes ``x`` (N, 3), of which those with ``is_there`` exist.

    The balls are those of the nodes, and interpolated balls on edges, half a radius apart.
    """
    radii = np.full(len(x), np.nan)
    radii[is_there] = shape.distances(x[is_there])
    ball = np.where(is_there & (winding > 0), radii, 0.0)
    length = np.linalg.norm(x[edges[:, 0]] - x[edges[:, 1]], axis=1)
    # Balls below a thousandth of the diagonal are as far apart as if they were that large.
    count = np.ceil(2 * length / np.maximum(ball[edges].mean(axis=1), 1e-3))
    count = np.where(is_there[edges].all(axis=1), np.clip(count, 1, 64), 0).astype(np.int64)
    edge, step = repeated(count)
    t = (step + 0.5) / count[edge]
    ends = edges[edge]
    centre = np.concatenate([x[is_there], (1 - t)[:, None] * x[ends[:, 0]] + t[:, None] * x[ends[:, 1]]])
    ball = np.concatenate([ball[is_there], (1 - t) * ball[ends[:, 0]] + t * ball[ends[:, 1]]])
    # Among balls of similar size, the nearest ball is nearly always one with a nearest centre.
    gap = np.full(len(shape.vertices), np.inf)
    size = np.floor(2 * np.log2(np.maximum(ball, 1e-6)))  # balls of no radius are those of a millionth of the diagonal
    for value in np.unique(size):
        rows = np.flatnonzero(size == value)
        away, nearest = spatial.KDTree(centre[rows]).query(shape.vertices, k=min(NEAREST, len(rows)))
        gap = np.minimum(gap, (away - ball[rows[nearest]]).reshape(len(gap), -1).min(axis=1))
    gap = np.maximum(gap, 0.0)
    reach = np.where(is_there[node], np.linalg.norm(shape.vertices - x[node], axis=1), 0.0)
    return Measured(radii, gap, reach, np.where(is_there[edges].all(axis=1), length, np.nan))
