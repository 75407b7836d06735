"""Keep the curve inside the solid: nodes off the surface, and edges that do not cross it.

A node outside is moved into the solid behind its nearest triangle, to the middle of the limb there. For an edge that
leaves the solid a short path with a large clearance is sought, in a window around it. The nodes of that graph are the
ends of the edge, and centres of balls that touch the surface from inside, one for each place and size. If two balls
overlap, the segment between their centres is inside. Where that joins no path, segments between near balls of different
parts are tested, the shortest for their balls first. Only an edge without a path in its windows is searched for in the
whole solid, whose balls are then kept. All searches for a curve together have a bound.

Loops around handles that have none are shortest paths over all balls, with all segments tested.
"""

import itertools
from collections.abc import Iterator
from functools import cached_property
from typing import NamedTuple

import numpy as np
from scipy import spatial
from scipy.sparse import csgraph
from trimesh.triangles import closest_point

from msf_jax.inside import balls
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import TOUCHING, distinct
from msf_jax.topology import graphs
from msf_jax.topology.graphs import down_forest

NEIGHBOURS = 4  # nearest balls of its own and of each larger size, by powers of two, to which a ball may have links
REACHES = 2.0, 6.0  # lengths of an edge: diameters of the windows in which a path is sought; beyond them is all else
AT_ONCE = 2_000  # segments that are tested before it is asked again which parts of a graph are joined
MOST_TESTS = 200_000  # segments that are tested in one graph: some 2 seconds
MOST_VISITS = 2_000_000  # balls in the graphs of all searches for one curve together: some 20 seconds


class Network(NamedTuple):
    """Balls inside a solid, and segments between their centres.

    centre: (B, 3). radius: (B,). size: (B,) of each ball, as a power of two; -inf for ends of paths and nodes of the
    curve, which may have links to balls of all sizes. links: (E, 2) balls between which the segment is inside.
    others: (U, 2) those between which it is not known to be, the shortest for their radii first."""

    centre: np.ndarray
    radius: np.ndarray
    size: np.ndarray
    links: np.ndarray
    others: np.ndarray

    def costs(self) -> np.ndarray:
        """(E,) the length of each link over the smaller radius of its ends."""
        length = graphs.lengths(self.centre, self.links)
        return np.maximum(length / np.maximum(self.radius[self.links].min(axis=1), TOUCHING), 1e-9)


NO_BALLS = Network(np.empty((0, 3)), np.empty(0), np.empty(0), *np.empty((2, 0, 2), dtype=np.int64))


class Roadmap:
    """Paths inside the solid ``shape``, of diagonal 1.

    num_refused: edges for which the last `paths` found none because of a bound. num_closed: edges between points inside
    that have none. num_linked, is_cut_short, num_unsought: of the search for loops (see `handle_loops.completed`), the
    linking numbers that were computed, whether a bound was reached, and handles left without a loop because of it."""

    def __init__(self, shape: Enclosure):
        self.shape = shape
        self.num_visits = self.num_refused = self.num_closed = self.num_linked = self.num_unsought = 0
        self.is_cut_short = False

    @cached_property
    def surface(self) -> tuple[np.ndarray, np.ndarray]:
        """Points (P, 3) of the surface and their normals, at which balls may start."""
        return self.shape.surface_points(balls.MOST_SAMPLES // 2)

    @cached_property
    def _balls(self) -> np.ndarray:
        """(P, 4) the centre and the radius of the ball behind each point of the surface; NaN before it is asked for."""
        return np.full((len(self.surface[0]), 4), np.nan)

    @cached_property
    def whole(self) -> Network:
        """All balls inside the solid, and the links between those that overlap."""
        return self._linked_balls(np.ones(len(self.surface[0]), dtype=bool))

    @cached_property
    def joined(self) -> Network:
        """All balls, with segments tested that may join the parts of the solid."""
        return _tested(self.shape, self.whole, is_joining=True)

    @cached_property
    def complete(self) -> Network:
        """All balls, with all segments tested."""
        return _tested(self.shape, self.whole, is_joining=False)

    def _linked_balls(self, asked: np.ndarray) -> Network:
        """The balls behind those points of the surface that are ``asked`` for (P,): one for each place and size."""
        new = asked & np.isnan(self._balls[:, 3])
        self._balls[new] = np.column_stack(balls_behind(self.shape, *(each[new] for each in self.surface)))
        centre, radius = np.split(self._balls[asked & (self._balls[:, 3] > TOUCHING)], [3], axis=1)
        radius = radius[:, 0]
        size = np.floor(np.log2(radius))
        cell = 2.0 ** (size - 1)[:, None]
        cells = np.concatenate([cell, np.round(centre / cell)], axis=1)
        first = np.sort(np.unique(cells, axis=0, return_index=True)[1])
        return _linked(NO_BALLS, centre[first], radius[first], size[first])

    def paths(self, x: np.ndarray, radii: np.ndarray, pairs: np.ndarray) -> list[np.ndarray]:
        """Points (k, 3) of a path inside from x[a] to x[b] for each of ``pairs`` (E, 2), without its ends; empty if
        there is none. ``radii`` (N,) are clearances. The path is short, near the edge, and has large clearance."""
        self.num_closed = self.num_refused = 0
        return [self._path(x[pair], radii[pair]) if radii[pair].all() else np.empty((0, 3)) for pair in pairs]

    def _path(self, ends: np.ndarray, clearance: np.ndarray) -> np.ndarray:
        """The path of `paths` between two ``ends`` (2, 3)."""
        networks = self._networks(ends, clearance)
        while self.num_visits <= MOST_VISITS and (network := next(networks, None)) is not None:
            self.num_visits += len(network.centre)
            stops = _shortest(network, ends)
            if len(stops):
                return self._shortened(stops)
        is_known = self.num_visits <= MOST_VISITS and not len(self.joined.others)
        self.num_closed += is_known
        self.num_refused += not is_known
        return np.empty((0, 3))

    def _networks(self, ends: np.ndarray, clearance: np.ndarray) -> Iterator[Network]:
        """Graphs of balls in which a path between ``ends`` (2, 3) is sought, one after the other; ends come last."""
        both = ends, clearance, np.full(2, -np.inf)
        away = np.linalg.norm(self.surface[0] - ends.mean(axis=0), axis=1)
        for reach in REACHES:
            near = away < reach / 2 * np.linalg.norm(ends[1] - ends[0]) + clearance.sum()
            network = _linked(self._linked_balls(near), *both)
            yield network
            yield _tested(self.shape, network, is_joining=True)
        network = _linked(self.joined._replace(others=NO_BALLS.others), *both)
        yield _tested(self.shape, network, is_joining=True)

    def _shortened(self, stops: np.ndarray) -> np.ndarray:
        """Inner points (k, 3) of a path over some of ``stops`` (s, 3), from each to the last one in its sight."""
        chosen, last = [0], len(stops) - 1
        while chosen[-1] < last:
            ahead = np.arange(chosen[-1] + 2, last + 1)
            is_seen = self.shape.holds(np.repeat(stops[chosen[-1:]], len(ahead), axis=0), stops[ahead])
            chosen.append(int(ahead[is_seen].max(initial=chosen[-1] + 1)))
        return stops[chosen[1:-1]]

    def loops_from(self, x: np.ndarray, edges: np.ndarray) -> Iterator[tuple[int, int, np.ndarray]]:
        """Paths inside that make loops around handles with the curve ``(x (N, 3), edges (E, 2))``, the shortest first.

        Each link between balls, with shortest paths from its ends to the curve, is a candidate. Of candidates around
        the same handles only the shortest is kept; those around no handle are dropped.

        Yields:
            start, end: nodes. path: (k, 3) points between them.
        """
        clearance = self.shape.clearance(x)
        node_of_end = np.flatnonzero(clearance > TOUCHING)
        if not len(node_of_end):
            return
        first, nodes = len(self.complete.centre), (x[node_of_end], clearance[node_of_end])
        network = _linked(self.complete, *nodes, np.full(len(node_of_end), -np.inf))
        self.is_cut_short |= len(self.complete.others) > 0
        centre, (tail, head), cost = network.centre, network.links.T, network.costs()
        value = self.shape.handles.classes(centre[tail], centre[head])
        tail, head, cost, value = np.r_[tail, head], np.r_[head, tail], np.tile(cost, 2), np.r_[value, -value]
        paths, ends = graphs.weighted(len(centre), tail, head, cost), np.arange(first, len(centre))
        away, before, source = csgraph.dijkstra(paths, indices=ends, return_predecessors=True, min_only=True)
        a, b = x[edges[:, 0]], x[edges[:, 1]]
        of_curve = graphs.cycles(len(x), edges, self.shape.handles.classes(a, b), np.linalg.norm(a - b, axis=1))[2]
        last, is_step = np.zeros(len(before), dtype=np.int64), before[head] == tail
        last[head[is_step]] = value[is_step]
        node = node_of_end[np.maximum(source, first) - first]  # where the path from the curve to each ball begins
        to_ball = of_curve[node] + down_forest(before, last)
        around = to_ball[tail] + value - to_ball[head]
        length = away[tail] + cost + away[head]
        part = np.where(source < 0, -1, graphs.labels(len(x), *edges.T)[node])
        # A path between two parts of the curve closes no loop. A negative class is the same loop the other way round.
        rows = np.flatnonzero((part[tail] >= 0) & (part[tail] == part[head]) & (around > 0))
        rows = rows[np.lexsort((length[rows], around[rows]))]
        rows = rows[np.diff(around[rows], prepend=0) > 0]
        for row in rows[np.argsort(length[rows], kind="stable")].tolist():
            there, back = (_ascent(before, int(ball[row])) for ball in (tail, head))
            yield int(node[there[-1]]), int(node[back[-1]]), centre[[*there[-2::-1], *back[:-1]]]


def _linked(network: Network, centre: np.ndarray, radius: np.ndarray, size: np.ndarray) -> Network:
    """The network with more balls: they have links to their nearest ones of their own and of each larger size."""
    num, old = len(network.centre) + len(centre), len(network.centre)
    centre, radius = np.concatenate([network.centre, centre]), np.concatenate([network.radius, radius])
    size, pairs = np.concatenate([network.size, size]), [NO_BALLS.links]
    for each in np.unique(size):
        smaller, larger = old + np.flatnonzero(size[old:] <= each), np.flatnonzero(size == each)
        count = min(NEIGHBOURS + 1, len(larger))  # of which one may be the ball itself
        near = np.asarray(spatial.KDTree(centre[larger]).query(centre[smaller], k=count)[1]).ravel()
        pairs.append(np.stack([np.repeat(smaller, count), larger[near]], axis=1))
    low, high = np.sort(np.concatenate(pairs), axis=1).T
    both = distinct((low * num + high)[low < high])
    found = np.stack([both // max(num, 1), both % max(num, 1)], axis=1)
    gap = graphs.lengths(centre, found) / np.maximum(radius[found].sum(axis=1), TOUCHING)
    found, is_open = found[np.argsort(gap, kind="stable")], np.sort(gap) < 1
    links, others = np.concatenate([network.links, found[is_open]]), np.concatenate([network.others, found[~is_open]])
    return Network(centre, radius, size, links, others)


def _tested(shape: Enclosure, network: Network, is_joining: bool) -> Network:
    """The network with its other segments tested, up to a bound; if ``is_joining``, only those between its parts."""
    links, others = network.links, network.others
    for _ in range(MOST_TESTS // AT_ONCE):
        if is_joining:
            part = graphs.labels(len(network.centre), *links.T)
            others = others[part[others[:, 0]] != part[others[:, 1]]]
        if not len(others):
            break
        some, others = others[:AT_ONCE], others[AT_ONCE:]
        is_open = shape.holds(*network.centre[some.T], are_inside=True)
        links = np.concatenate([links, some[is_open]])
    return network._replace(links=links, others=others)


def _shortest(network: Network, ends: np.ndarray) -> np.ndarray:
    """The centres (k, 3) of a shortest path between the last two balls of a network, the ``ends`` (2, 3); or none. The
    cost of a link grows with the detour over it, so that a path stays on its own side of a hole."""
    num = len(network.centre)
    detour = np.linalg.norm(network.centre[:, None] - ends, axis=2).sum(axis=1)
    cost = network.costs() * detour[network.links].max(axis=1) / max(float(np.linalg.norm(ends[1] - ends[0])), TOUCHING)
    paths = graphs.weighted(num, *network.links.T, weight=cost)
    before = csgraph.dijkstra(paths, directed=False, indices=num - 2, return_predecessors=True)[1]
    stops = _ascent(before, num - 1)
    return network.centre[stops[::-1] if stops[-1] == num - 2 else []]


def _ascent(before: np.ndarray, last: int) -> list[int]:
    """The path from ``last`` to the root of a tree with predecessors ``before`` (B,)."""
    stops = [last]
    while before[stops[-1]] >= 0:
        stops.append(int(before[stops[-1]]))
    return stops


def balls_behind(shape: Enclosure, points: np.ndarray, normals: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Centres (P, 3) of balls that touch ``points`` (P, 3) of the surface from inside, and their clearances (P,). Among
    samples of the surface a far nearer wall, such as the other side of a plate of two triangles, can be missed: none
    reaches beyond half of the chord behind its point."""
    points = points - TOUCHING / 2 * normals
    radius = balls.shrinking_balls(points, normals, shape.sites, 2 * balls.THIN, 1.0, own=-1)[0]
    centre = points - shape.ray_lengths(points, -normals, 2 * radius)[:, None] / 2 * normals
    return centre, shape.clearance(centre)


def contain(
    roadmap: Roadmap, vertices: np.ndarray, edges: np.ndarray, is_held: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Move the curve ``(vertices, edges)`` into a solid of diagonal 1: returns its nodes, new ones last, and its edges.

    Nodes of ``is_held`` do not move. An edge for which no path inside is found stays as it is."""
    x, shape = vertices.copy(), roadmap.shape
    radii = shape.clearance(x)
    is_out = (radii < TOUCHING) & ~is_held
    if is_out.any():
        triangle = shape.nearest(x[is_out])[1]
        foot = 0.85 * closest_point(shape.triangles[triangle], x[is_out]) + 0.15 * shape.centroids[triangle]
        centre, clearance = balls_behind(shape, foot, shape.normals[triangle])
        entered = np.flatnonzero(is_out)[clearance >= TOUCHING]
        x[entered], radii[entered] = centre[clearance >= TOUCHING], clearance[clearance >= TOUCHING]
        # If the surface is inside out there, no ball is behind its triangle: the nearest ball of all is taken.
        is_out = (radii < TOUCHING) & ~is_held
        if is_out.any() and len(roadmap.whole.centre):
            ball = spatial.KDTree(roadmap.whole.centre).query(x[is_out])[1]
            x[is_out], radii[is_out] = roadmap.whole.centre[ball], roadmap.whole.radius[ball]

    is_bad = ~shape.holds(x[edges[:, 0]], x[edges[:, 1]], radii[edges].sum(axis=1))
    return _replaced(x, edges, is_bad, roadmap.paths(x, radii, edges[is_bad]))


def refine(
    shape: Enclosure, vertices: np.ndarray, edges: np.ndarray, spacing: float, most: int
) -> tuple[np.ndarray, np.ndarray, bool]:
    """Split edges longer than ``spacing`` times the smaller radius at their ends, and longer than 1/400 diagonal. If
    that would need more than ``most`` nodes, all edges are split less, and the third result is True."""
    radii = shape.distances(vertices)
    a, b = vertices[edges[:, 0]], vertices[edges[:, 1]]
    length = np.linalg.norm(b - a, axis=1)
    target = np.maximum(spacing * radii[edges].min(axis=1), 1 / 400)
    wanted = float((length / target).sum())
    count = np.ceil(length / (target * max(wanted / most, 1.0))).astype(np.int64)
    is_long = count > 1
    chains = [
        start + np.linspace(0, 1, num + 1)[1:-1, None] * (end - start)
        for start, end, num in zip(a[is_long], b[is_long], count[is_long], strict=True)
    ]
    return *_replaced(vertices, edges, is_long, chains), wanted > most


def _replaced(
    x: np.ndarray, edges: np.ndarray, is_gone: np.ndarray, chains: list[np.ndarray]
) -> tuple[np.ndarray, np.ndarray]:
    """The curve with each edge of ``is_gone`` replaced by a path over the new nodes of its chain (k, 3)."""
    joined, count = [], len(x)
    for (a, b), chain in zip(edges[is_gone].tolist(), chains, strict=True):
        stops = [a, *range(count, count + len(chain)), b]
        joined += list(itertools.pairwise(stops))
        count += len(chain)
    new = np.array(joined, dtype=np.int64).reshape(-1, 2)
    return np.concatenate([x, *chains]), np.concatenate([edges[~is_gone], new])
