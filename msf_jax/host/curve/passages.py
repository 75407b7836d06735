"""Ways through a solid: a graph of balls inside it, made once, whose edges are looked at when a way wants them.

The nodes are centres of balls that touch the surface from inside, one for each place: a ball among others of its size
that overlap it says nothing new. Where two balls overlap, the segment between their centres is inside without a look.
Any other edge is taken for open until a shortest way uses it; then rays tell, and the next way does without those that
are not (lazy shortest paths; Dellin, Srinivasa 2016). The cost follows the ways that are asked for, and has a bound.
"""

from collections.abc import Callable

import numpy as np
from scipy import sparse, spatial
from scipy.sparse import csgraph

from msf_jax.host.poles.balls import shrinking_balls
from msf_jax.host.solid.enclosure import Enclosure

TOUCHING = 1e-5  # diagonals: a point with less room than that counts as outside
MOST_SEEDS = 20_000  # points of the surface, behind which balls are sought
FIRST = 0.01  # diagonals, radius of the first ball that is tried
CORRECTIONS = 4  # of a ball's radius, by the triangles between the samples
NEIGHBOURS = 12  # of a ball, of any size, and
LARGER = 3  # of each larger size
FAR = 3.0  # times the sum of their radii: balls that are farther apart than that are no neighbours
NEAR_BY = 10.0  # times what the straight way would cost in the median ball: so far a way is sought at first
UNSEEN = 3.0  # times as long as it is counts an edge that nobody has looked at
SEARCHES = 300  # that a curve may cost, and one more for every
EDGES_A_SEARCH = 10  # of its edges outside
AT_ONCE = 256  # edges out of a pocket that are looked at together

Test = Callable[[Enclosure, np.ndarray, np.ndarray], np.ndarray]


class Passages:
    """Ways through the solid ``shape``, of diagonal 1.

    Args:
        shape: the solid.
        test: which segments from a (E, 3) to b (E, 3) are inside it.
    """

    def __init__(self, shape: Enclosure, test: Test):
        self.shape = shape
        self.test = test
        self.num_searches = 0
        self.num_refused = 0  # ways that were not looked for, as the bound was hit
        self.num_closed = 0  # ways that were looked for at last, between points inside, where there is none
        self._balls: tuple[np.ndarray, np.ndarray] | None = None

    def ways(self, x: np.ndarray, pairs: np.ndarray) -> list[np.ndarray]:
        """Points (k, 3) from x[a] to x[b] for each of ``pairs`` (E, 2), with segments inside; none where there is none.

        The roomiest and shortest one is taken.
        """
        self.num_closed = 0
        if not len(pairs):
            return []
        ends, place = np.unique(pairs, return_inverse=True)
        is_inside = self.shape.contains(x[ends])
        graph = _Graph(self.shape, self.test, *self._with(x[ends]), len(ends))
        bound = SEARCHES + len(pairs) // EDGES_A_SEARCH
        found = []
        for (a, b), (row, other) in zip(pairs, place.reshape(-1, 2), strict=True):
            del a, b
            way, is_refused = np.empty((0, 3)), False
            if is_inside[row] and is_inside[other]:
                if self.num_searches < bound:
                    way, num = graph.way(int(row), int(other), bound - self.num_searches)
                    self.num_searches += num
                is_refused = not len(way) and self.num_searches >= bound
                self.num_closed += not is_refused and not len(way)
            self.num_refused += is_refused
            found.append(way)
        return found

    def nearest(self, points: np.ndarray, radii: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Centre (P, 3) and radius (P,) of the ball nearest to each point; what is given, if there is none."""
        if not len(points):
            return points, radii
        centre, radius = self._all_balls()
        if not len(centre):
            return points, radii
        found = spatial.KDTree(centre).query(points)[1]
        return centre[found], radius[found]

    def _all_balls(self) -> tuple[np.ndarray, np.ndarray]:
        if self._balls is None:
            self._balls = inner_balls(self.shape)
        return self._balls

    def _with(self, ends: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        centre, radius = self._all_balls()
        return np.concatenate([ends, centre]), np.concatenate([self.shape.clearance(ends), radius])


class _Graph:
    """Balls, the first ``num_ends`` of which are ends of ways, and the edges between neighbours."""

    def __init__(self, shape: Enclosure, test: Test, centre: np.ndarray, radius: np.ndarray, num_ends: int):
        self.shape, self.test, self.centre = shape, test, centre
        self.usual = max(float(np.median(radius[num_ends:])) if len(radius) > num_ends else 0.0, TOUCHING)
        tail, head = _neighbours(centre, radius, num_ends)
        length = np.linalg.norm(centre[tail] - centre[head], axis=1)
        self.tail, self.head = tail, head
        self.is_seen = length < radius[tail] + radius[head]
        room = np.maximum(np.minimum(radius[tail], radius[head]), TOUCHING)
        self.cost = np.maximum(length / room, 1e-9) * np.where(self.is_seen, 1.0, UNSEEN)  # roomy ways first
        every, shape_of = np.arange(1, len(tail) + 1), (len(centre),) * 2
        both = np.concatenate([tail, head]), np.concatenate([head, tail])
        self.matrix = sparse.csr_matrix((np.tile(every, 2), both), shape=shape_of)
        edge = np.asarray(self.matrix.data) - 1  # of each entry
        self.matrix.data = self.cost[edge].astype(np.float64)
        self.entries = np.argsort(edge, kind="stable").reshape(-1, 2)  # the two of each edge

    def way(self, start: int, end: int, most: int) -> tuple[np.ndarray, int]:
        """Points (k, 3) between the two, none if there is no way, after at most so many searches; and their number."""
        num = len(self.centre)
        # Near by at first: a search costs as much as it reaches.
        limit = self._limit(start, end)
        for number in range(1, most + 1):
            before = csgraph.dijkstra(self.matrix, indices=start, return_predecessors=True, limit=limit)[1]
            stops = [end]
            while before[stops[-1]] >= 0:
                stops.append(int(before[stops[-1]]))
            if stops[-1] != start:
                if limit == np.inf:
                    return np.empty((0, 3)), number
                limit = np.inf
                continue
            low, high = np.minimum(stops[1:], stops[:-1]), np.maximum(stops[1:], stops[:-1])
            edge = np.searchsorted(self.tail * num + self.head, low * num + high)
            unseen = edge[~self.is_seen[edge]]
            if not len(unseen):
                return self.centre[stops[-2:0:-1]], number
            if not self._look(unseen).all():
                self._look(self._frontier(start, end))
        return np.empty((0, 3)), most

    def _limit(self, start: int, end: int) -> float:
        """What a way near by costs at most."""
        length = float(np.linalg.norm(self.centre[start] - self.centre[end]))
        bounds = self.matrix.indptr
        own = [self.matrix.data[bounds[ball] : bounds[ball + 1]].min(initial=np.inf) for ball in (start, end)]
        return NEAR_BY * (length / self.usual + sum(own))

    def _look(self, edge: np.ndarray) -> np.ndarray:
        """Whether each of these edges is inside, which is known from then on."""
        is_open = self.test(self.shape, self.centre[self.tail[edge]], self.centre[self.head[edge]])
        self.is_seen[edge] = True
        self.cost[edge] = np.where(is_open, self.cost[edge] / UNSEEN, np.inf)
        self.matrix.data[self.entries[edge]] = self.cost[edge][:, None]
        return is_open

    def _frontier(self, start: int, end: int) -> np.ndarray:
        """The cheapest unseen edges that lead out of what is known to be joined to one of two balls.

        The smaller such part is taken: it may be a pocket that no way leads out of.
        """
        is_joined = self.is_seen & np.isfinite(self.cost)
        known = sparse.coo_matrix(
            (np.ones(is_joined.sum()), (self.tail[is_joined], self.head[is_joined])), shape=self.matrix.shape
        )
        part = csgraph.connected_components(known, directed=False)[1]
        if part[start] == part[end]:
            return np.empty(0, dtype=np.int64)
        is_own = min((part == part[ball] for ball in (start, end)), key=np.count_nonzero)
        leads_out = np.flatnonzero(~self.is_seen & (is_own[self.tail] != is_own[self.head]))
        return leads_out[np.argsort(self.cost[leads_out], kind="stable")[:AT_ONCE]]


def inner_balls(shape: Enclosure) -> tuple[np.ndarray, np.ndarray]:
    """Centres (B, 3) and radii (B,) of balls inside the solid, touching it: one for each place and size."""
    points, normals = shape.surface_points(MOST_SEEDS)
    tree = shape.sample_tree()
    radius = shrinking_balls(points, normals, tree, FIRST, 1.0).radius
    for _ in range(CORRECTIONS):  # between the samples of large triangles
        foot = shape.feet(points - radius[:, None] * normals)
        to_foot = foot - points
        depth = -np.einsum("ij,ij->i", normals, to_foot)
        length2 = np.einsum("ij,ij->i", to_foot, to_foot)
        smaller = length2 / np.where(depth > 1e-9, 2 * depth, 1.0)
        is_smaller = (depth > 1e-9) & (smaller < radius) & (smaller > TOUCHING)
        radius[is_smaller] = smaller[is_smaller]
    centre = points - radius[:, None] * normals
    chosen = _one_for_each_place(centre, radius)
    room = shape.clearance(centre[chosen])
    chosen, room = chosen[room > TOUCHING], room[room > TOUCHING]
    again = _one_for_each_place(centre[chosen], room)
    return centre[chosen[again]], room[again]


def _one_for_each_place(centre: np.ndarray, radius: np.ndarray) -> np.ndarray:
    """Rows of the balls that are the first in their cell, of about half their radius."""
    size = 2.0 ** np.floor(np.log2(np.maximum(radius, TOUCHING)) - 1)
    cells = np.concatenate([size[:, None], np.round(centre / size[:, None])], axis=1)
    return np.sort(np.unique(cells, axis=0, return_index=True)[1])


def _neighbours(centre: np.ndarray, radius: np.ndarray, num_ends: int) -> tuple[np.ndarray, np.ndarray]:
    """Pairs of balls, the smaller number first, in ascending order: each with those next to it, and larger ones."""
    num = len(centre)
    level = np.floor(np.log2(np.maximum(radius, TOUCHING))).astype(np.int64)
    level[:num_ends] = level.min()  # an end is joined to balls of all sizes
    pairs = [_nearest(centre, np.arange(num), np.arange(num), NEIGHBOURS + 1)]
    for size in np.unique(level)[1:]:
        pairs.append(_nearest(centre, np.flatnonzero(level < size), np.flatnonzero(level == size), LARGER))
    both = np.concatenate(pairs)
    both = np.sort(both[both[:, 0] != both[:, 1]], axis=1)
    both = np.unique(both[:, 0] * num + both[:, 1])
    tail, head = both // num, both % num
    apart = np.asarray(spatial.KDTree(centre).query(centre, k=2)[0])[:, 1]
    reach = FAR * (radius[tail] + radius[head]) + 2 * np.maximum(apart[tail], apart[head])
    is_near = (np.linalg.norm(centre[tail] - centre[head], axis=1) < reach) | (tail < num_ends)
    return tail[is_near], head[is_near]


def _nearest(centre: np.ndarray, rows: np.ndarray, others: np.ndarray, num: int) -> np.ndarray:
    """(R k, 2): each of ``rows`` with its nearest ``num`` of ``others``."""
    num = min(num, len(others))
    found = spatial.KDTree(centre[others]).query(centre[rows], k=num)[1].reshape(-1)
    return np.stack([np.repeat(rows, num), others[found]], axis=1)
