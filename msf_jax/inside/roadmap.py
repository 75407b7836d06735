"""Shortest paths inside a solid, in a roadmap of inscribed balls whose edges are tested when they are needed.

The nodes are centres of balls that touch the surface from inside, one for each place and size. If two balls overlap,
the segment between their centres is inside; other segments are tested with rays. First the parts of the graph between
which a path is requested are joined, each by the nearest of its edges that is inside, as in Boruvka's spanning tree
(1926). Then it is known which paths exist. Any other edge counts as open until a shortest path uses it, and is tested
then (lazy shortest paths; Dellin, Srinivasa 2016). A path is searched near the edge that it replaces, and farther away
only if there is none, so that it stays on the same side of a hole, and the search is local. So at first there are only
balls near the edges; the roadmap of all balls is made once it is needed. All searches together have bounds.
"""

from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import numpy as np
from scipy import sparse, spatial
from scipy.sparse import csgraph

from msf_jax.inside import balls
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import arc_length, at, distinct
from msf_jax.topology import graphs
from msf_jax.topology.graphs import down_forest

TOUCHING = 1e-5  # diagonals: a point of less clearance counts as outside
CORRECTIONS = 4  # corrections of a ball's radius by the triangles between samples
NEIGHBOURS = 12  # nearest balls of any size that a ball has edges to
LARGER = 3  # nearest balls of each larger size that a ball has edges to
MOST_TESTS = 15_000  # tests of edges in joining, for one curve
MOST_TESTS_FOR_LOOPS = 60_000  # tests of edges in the search for missing loops
REACHES = (2.0, 6.0)  # lengths of the edge to replace: longest detour over a ball, in the first and the second search
TRIES = 8  # searches that may use untested edges; afterwards only tested edges are used
PIECES = 8  # of each leg of a path, between which a straight line may lead past the ball
VISITS = 5_000_000  # visits of balls by all searches for one curve

Test = Callable[[Enclosure, np.ndarray, np.ndarray], np.ndarray]


class Roadmap:
    """Paths inside the solid ``shape``, of diagonal 1.

    Args:
        shape: the solid.
        test: whether each segment from a (E, 3) to b (E, 3) is inside it.
    """

    def __init__(self, shape: Enclosure, test: Test):
        self.shape = shape
        self.test = test
        self.num_visits = self.num_tests = 0
        # Results of the last call of `paths`:
        self.num_refused = 0  # edges without a search, because a bound was reached
        self.num_closed = 0  # edges between points inside for which there is no path
        # Results of the search for loops, see `loops.completed`:
        self.num_linked = 0  # linking numbers of the paths that were tried
        self.is_cut_short = False  # whether a bound was reached
        self.num_unsought = 0  # handles left without a loop because of that
        self._balls: tuple[np.ndarray, np.ndarray] | None = None
        self._links: _Links | None = None

    def paths(self, x: np.ndarray, pairs: np.ndarray) -> list[np.ndarray]:
        """Points (k, 3) of a path inside from x[a] to x[b] for each of ``pairs`` (E, 2), without its ends; empty if
        there is none. The path is short, near the edge, and has large clearance.
        """
        self.num_closed = self.num_refused = 0
        found = [np.empty((0, 3)) for _ in pairs]
        for is_local in (True, False):
            left = [row for row, path in enumerate(found) if not len(path)]
            if not left or (is_local and self._balls is not None):
                continue
            for row, path in zip(left, self._search(x, pairs[left], is_local), strict=True):
                found[row] = path
        return found

    def _search(self, x: np.ndarray, pairs: np.ndarray, is_local: bool) -> list[np.ndarray]:
        """The paths of `paths`, over the balls near the edges that they replace, or over all balls."""
        self.num_closed = self.num_refused = 0
        ends, place = np.unique(pairs, return_inverse=True)
        clearance = self.shape.clearance(x[ends])
        is_inside, place = clearance > 0, place.reshape(-1, 2)
        if is_local:
            length = np.linalg.norm(x[pairs[:, 0]] - x[pairs[:, 1]], axis=1)
            reach = REACHES[-1] / 2 * length + clearance[place].sum(axis=1)
            graph = self._graph(x[ends[is_inside]], inner_balls(self.shape, x[pairs].mean(axis=1), reach))
        else:
            graph = self._graph(x[ends[is_inside]])
        number = graph.first_end + np.cumsum(is_inside) - 1
        is_asked = np.logical_and(*is_inside[place].T)
        is_joined = graph.join(number[place[is_asked]], MOST_TESTS - self.num_tests)
        self.num_tests += graph.num_tests
        found = []
        for (start, end), has_ends in zip(number[place].tolist(), is_asked.tolist(), strict=True):
            path = np.empty((0, 3))
            if has_ends and graph.part[start] == graph.part[end] and self.num_visits <= VISITS:
                path = self._shortened(graph.centre[start], graph.path(start, end), graph.centre[end])
                self.num_visits += graph.num_visits
            elif has_ends and graph.part[start] != graph.part[end] and is_joined:
                self.num_closed += 1
            else:
                self.num_refused += has_ends
            found.append(path)
        if not is_local:
            self._links = graph.links_of_balls()
        return found

    def _shortened(self, start: np.ndarray, path: np.ndarray, end: np.ndarray) -> np.ndarray:
        """Points (k, 3) of a path inside along the ``path`` (k, 3), without detours to the centres of its balls."""
        if not len(path):
            return path
        stops = np.concatenate([start[None], path, end[None]])
        along = arc_length(stops)
        whole = np.linspace(0, 1, PIECES, endpoint=False)
        places = at(stops, along, np.append((along[:-1, None] + np.diff(along)[:, None] * whole).ravel(), along[-1]))
        chosen, last = [0], len(places) - 1
        while chosen[-1] < last:
            ahead = np.arange(chosen[-1] + 2, last + 1)
            is_open = self.test(self.shape, np.repeat(places[chosen[-1:]], len(ahead), axis=0), places[ahead])
            chosen.append(int(ahead[is_open].max(initial=chosen[-1] + 1)))
        return places[chosen[1:-1]]

    def loops_from(self, x: np.ndarray, edges: np.ndarray, is_complete: bool) -> Iterator[tuple[int, int, np.ndarray]]:
        """Paths inside that make loops around handles with the curve ``(x (N, 3), edges (E, 2))``, the shortest first.

        Each edge of the roadmap, with shortest paths from its ends to the curve, is a candidate. Of candidates around
        the same handles only the shortest is kept; those around no handle are dropped. Only edges between overlapping
        balls are used, or, if ``is_complete``, all edges that are inside.

        Yields:
            start, end: nodes. path: (k, 3) points between them.
        """
        node_of_end = np.flatnonzero(self.shape.clearance(x) > TOUCHING)
        if not len(node_of_end):
            return
        graph = self._graph(x[node_of_end])
        if is_complete:
            self.is_cut_short |= not graph.test_all(MOST_TESTS_FOR_LOOPS)
            self._links = graph.links_of_balls()
        links, first, handles = graph.links, graph.first_end, self.shape.handles
        tail, head, cost = (field[links.is_open] for field in (links.tail, links.head, links.cost))
        value = handles.classes(graph.centre[tail], graph.centre[head])
        tail, head, cost, value = np.r_[tail, head], np.r_[head, tail], np.tile(cost, 2), np.r_[value, -value]
        away, before, source = csgraph.dijkstra(
            graphs.weighted(len(graph.centre), tail, head, cost),
            indices=np.arange(first, len(graph.centre)),
            return_predecessors=True,
            min_only=True,
        )
        a, b = x[edges[:, 0]], x[edges[:, 1]]
        of_curve = graphs.cycles(len(x), edges, handles.classes(a, b), np.linalg.norm(a - b, axis=1))[2]
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
            yield int(node[there[-1]]), int(node[back[-1]]), graph.centre[[*there[-2::-1], *back[:-1]]]

    def nearest(self, points: np.ndarray, radii: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Centre (P, 3) and radius (P,) of the ball nearest to each point; the arguments if there are no balls."""
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

    def _graph(self, ends: np.ndarray, some: tuple[np.ndarray, np.ndarray] | None = None) -> "_Graph":
        """The graph of all balls, or of ``some``, and after them the ``ends`` of paths."""
        centre, radius = some or self._all_balls()
        links = None if some else self._links
        if links is None:
            links = _links(centre, radius, *_neighbours(centre, radius))
            self._links = self._links if some else links
        of_ends = _links_of_ends(centre, radius, ends, self.shape.clearance(ends))
        links = _Links(*(np.concatenate(both) for both in zip(links, of_ends, strict=True)))
        return _Graph(self.shape, self.test, np.concatenate([centre, ends]), len(centre), links)


class _Links(NamedTuple):
    """Edges (E,) from ball ``tail`` to ball ``head``. gap: length over the sum of the radii. cost: length over the
    smaller radius. is_tested: whether ``is_open``, which says that the edge is inside, is known."""

    tail: np.ndarray
    head: np.ndarray
    gap: np.ndarray
    cost: np.ndarray
    is_tested: np.ndarray
    is_open: np.ndarray


class _Graph:
    """The centres of balls, from ``first_end`` on ends of paths, and the edges between neighbours."""

    def __init__(self, shape: Enclosure, test: Test, centre: np.ndarray, first_end: int, links: _Links):
        self.shape, self.test, self.centre, self.first_end, self.links = shape, test, centre, first_end, links
        self.num_visits = self.num_tests = 0
        self.tree = spatial.KDTree(centre)
        both, every = (np.r_[links.tail, links.head], np.r_[links.head, links.tail]), np.arange(1, len(links.tail) + 1)
        self.number: Any = graphs.weighted(len(centre), *both, np.tile(every, 2))  # of each edge, from 1 on
        self.part = np.empty(0, dtype=np.int64)  # of each ball: the component by edges known to be inside

    def links_of_balls(self) -> _Links:
        """The edges between balls, with the results of their tests."""
        return _Links(*(each[self.links.head < self.first_end] for each in self.links))

    def join(self, pairs: np.ndarray, most_tests: int) -> bool:
        """Test edges until the two balls of each of ``pairs`` (W, 2) are in one part, if they can be. Returns False if
        a bound stopped it. It tests edges of the smaller of two parts, which may be an enclosed pocket: in the first
        round one of each part, and in each next round twice as many.
        """
        tail, head, gap, _, is_tested, is_open = self.links
        most = 1
        while True:
            self.part = graphs.labels(len(self.centre), tail[is_open], head[is_open])
            both = self.part[pairs[self.part[pairs[:, 0]] != self.part[pairs[:, 1]]]]
            count = np.bincount(self.part)
            is_asked = np.isin(np.arange(len(count)), np.where(count[both[:, 0]] < count[both[:, 1]], *both.T))
            across = np.flatnonzero(~is_tested & (self.part[tail] != self.part[head]))
            owner, edge = self.part[np.concatenate([tail[across], head[across]])], np.tile(across, 2)
            owner, edge = owner[is_asked[owner]], edge[is_asked[owner]]
            if not len(edge) or self.num_tests >= most_tests:
                return not len(edge)
            order = np.lexsort((gap[edge], owner))
            owner, edge = owner[order], edge[order]
            rank = np.arange(len(owner)) - np.searchsorted(owner, owner)
            chosen = np.unique(edge[rank < most])[: most_tests - self.num_tests]
            self._test_edges(chosen)
            self.num_tests += len(chosen)
            most *= 2

    def test_all(self, most: int) -> bool:
        """Test at most ``most`` edges, those between the nearest balls first. Returns whether these are all."""
        untested = np.flatnonzero(~self.links.is_tested)
        self._test_edges(untested[np.argsort(self.links.gap[untested], kind="stable")[:most]])
        return len(untested) <= most

    def _test_edges(self, edge: np.ndarray) -> bool:
        """Test the edges ``edge``. Returns whether all are inside."""
        tail, head = self.links.tail[edge], self.links.head[edge]
        self.links.is_open[edge] = self.test(self.shape, self.centre[tail], self.centre[head])
        self.links.is_tested[edge] = True
        return bool(self.links.is_open[edge].all())

    def path(self, start: int, end: int) -> np.ndarray:
        """Points (k, 3) of a path between two balls of the same part, without its ends."""
        self.num_visits = 0
        if start == end:
            return np.empty((0, 3))
        ends = self.centre[[start, end]]
        length = float(np.linalg.norm(ends[1] - ends[0]))
        for reach in REACHES:
            near: np.ndarray = np.sort(self.tree.query_ball_point(ends.mean(axis=0), 1.001 * reach * length / 2))
            detour = np.linalg.norm(self.centre[near, None] - ends, axis=2).sum(axis=1)
            near = near[detour <= reach * length]
            for number in range(TRIES + 1):
                stops, untested = self._shortest(start, end, near, number < TRIES)
                if not len(stops):
                    break
                if not len(untested) or self._test_edges(untested):
                    return self.centre[stops[1:-1]]
        stops, _ = self._shortest(start, end, np.arange(len(self.centre)), may_be_untested=False)
        return self.centre[stops[1:-1]]

    def _shortest(self, start: int, end: int, near: np.ndarray, may_be_untested: bool) -> tuple[np.ndarray, np.ndarray]:
        """The balls (k,) of a shortest path over ``near``, which is ascending, or none; and its untested edges."""
        _, _, _, cost, is_tested, is_open = self.links
        self.num_visits += len(near)
        number = self.number if len(near) == len(self.centre) else self.number[near][:, near]
        edge = number.data - 1
        price = cost[edge]
        price[~is_open[edge] & (is_tested[edge] | (not may_be_untested))] = np.inf
        matrix = sparse.csr_matrix((price, number.indices, number.indptr), number.shape)
        first, last = np.searchsorted(near, [start, end]).tolist()
        # Without this limit, SciPy below 1.16 uses closed edges, whose price is infinite.
        most = float(np.finfo(float).max)
        before = np.asarray(csgraph.dijkstra(matrix, indices=first, return_predecessors=True, limit=most)[1])
        stops = _ascent(before, last)
        if stops[-1] != first:
            return np.empty(0, dtype=np.int64), np.empty(0, dtype=np.int64)
        used = np.asarray(number[stops[:-1], stops[1:]]).ravel() - 1
        return near[stops[::-1]], used[~is_tested[used]]


def _ascent(before: np.ndarray, last: int) -> list[int]:
    """The path from ``last`` to the root of a tree with predecessors ``before`` (B,)."""
    stops = [last]
    while before[stops[-1]] >= 0:
        stops.append(int(before[stops[-1]]))
    return stops


def inner_balls(
    shape: Enclosure, places: np.ndarray | None = None, reach: np.ndarray | None = None
) -> tuple[np.ndarray, np.ndarray]:
    """Centres (B, 3) and radii (B,) of balls that touch the solid from inside: one for each place and size.

    With ``places`` (P, 3) they touch the surface within ``reach`` (P,) of one of them.
    """
    points, normals = shape.surface_points(balls.MOST_SAMPLES)
    if places is not None:
        near = spatial.KDTree(points).query_ball_point(places, reach)
        asked = distinct(np.concatenate([np.empty(0, dtype=np.int64), *near]).astype(np.int64))
        points, normals = points[asked], normals[asked]
    tree = shape.samples.tree
    radius = balls.shrinking_balls(points, normals, tree, balls.FIRST, 1.0).radius
    left = np.arange(len(points))
    for _ in range(CORRECTIONS):  # large triangles can be nearer than any sample
        foot = shape.feet(points[left] - radius[left, None] * normals[left])
        to_foot = foot - points[left]
        depth = -np.einsum("ij,ij->i", normals[left], to_foot)
        length2 = np.einsum("ij,ij->i", to_foot, to_foot)
        smaller = length2 / np.where(depth > 1e-9, 2 * depth, 1.0)
        is_smaller = (depth > 1e-9) & (smaller < radius[left]) & (smaller > TOUCHING)
        left, smaller = left[is_smaller], smaller[is_smaller]
        radius[left] = smaller
    centre = points - radius[:, None] * normals
    chosen = _one_for_each_place(centre, radius)
    clearance = shape.clearance(centre[chosen])
    chosen, clearance = chosen[clearance > TOUCHING], clearance[clearance > TOUCHING]
    again = _one_for_each_place(centre[chosen], clearance)
    return centre[chosen[again]], clearance[again]


def _one_for_each_place(centre: np.ndarray, radius: np.ndarray) -> np.ndarray:
    """The first ball in each cell of a grid, whose cells have about half the radius of their balls."""
    size = 2.0 ** np.floor(np.log2(np.maximum(radius, TOUCHING)) - 1)
    cells = np.concatenate([size[:, None], np.round(centre / size[:, None])], axis=1)
    order = np.lexsort(cells.T)  # stable: the first ball of each cell comes first
    is_first = np.ones(len(order), dtype=bool)
    is_first[1:] = (cells[order[1:]] != cells[order[:-1]]).any(axis=1)
    return np.sort(order[is_first])


def _links(centre: np.ndarray, radius: np.ndarray, tail: np.ndarray, head: np.ndarray) -> _Links:
    length = np.linalg.norm(centre[tail] - centre[head], axis=1)
    gap = length / np.maximum(radius[tail] + radius[head], TOUCHING)
    clearance = np.maximum(np.minimum(radius[tail], radius[head]), TOUCHING)
    return _Links(tail, head, gap, np.maximum(length / clearance, 1e-9), gap < 1, gap < 1)


def _levels(radius: np.ndarray) -> np.ndarray:
    return np.floor(np.log2(np.maximum(radius, TOUCHING))).astype(np.int64)


def _neighbours(centre: np.ndarray, radius: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Pairs of balls, the smaller id first, sorted: each ball with its nearest ones, and with nearest larger ones."""
    num, level, count = len(centre), _levels(radius), min(NEIGHBOURS + 1, len(centre))
    if not num:
        return np.empty(0, dtype=np.int64), np.empty(0, dtype=np.int64)
    near = np.asarray(spatial.KDTree(centre).query(centre, k=count)[1])
    pairs = [np.stack([np.repeat(np.arange(num), count), near.ravel()], axis=1)]
    for size in np.unique(level)[1:]:
        smaller = np.flatnonzero(level < size)
        pairs.append(_nearest(centre[smaller], smaller, centre, np.flatnonzero(level == size), LARGER))
    tail, head = np.concatenate(pairs).T
    both = distinct(np.minimum(tail, head) * num + np.maximum(tail, head))
    tail, head = both // num, both % num
    return tail[tail < head], head[tail < head]


def _links_of_ends(centre: np.ndarray, radius: np.ndarray, ends: np.ndarray, clearance: np.ndarray) -> _Links:
    """Edges to ``ends`` (P, 3), whose ids follow those of balls, from the nearest balls, and from some of each size."""
    number, level = len(centre) + np.arange(len(ends)), _levels(radius)
    pairs = [_nearest(ends, number, centre, np.arange(len(centre)), NEIGHBOURS)]
    pairs += [_nearest(ends, number, centre, np.flatnonzero(level == size), LARGER) for size in np.unique(level)]
    num, (end, ball) = len(centre), np.concatenate(pairs).T
    both = distinct(end * num + ball)
    return _links(np.concatenate([centre, ends]), np.concatenate([radius, clearance]), both % num, both // num)


def _nearest(points: np.ndarray, number: np.ndarray, centre: np.ndarray, others: np.ndarray, num: int) -> np.ndarray:
    """(P k, 2): the id ``number`` of each point with its ``num`` nearest of ``others``, by their ``centre``."""
    num = min(num, len(others))
    if not num:
        return np.empty((0, 2), dtype=np.int64)
    found = np.asarray(spatial.KDTree(centre[others]).query(points, k=num)[1]).reshape(-1)
    return np.stack([np.repeat(number, num), others[found]], axis=1)
