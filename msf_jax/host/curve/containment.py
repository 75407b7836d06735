"""Keep the curve inside: nodes off the surface, edges that do not cross it, whatever the flow did.

A node outside goes into the solid behind the nearest triangle, as deep as the limb is there. An edge that leaves the
solid is led through it: over the middle of its own cross-section, if that will do, or else over middles of chords of
the solid around it, by the shortest and roomiest way that does not cross the surface.
"""

import itertools

import numpy as np
from scipy import sparse, spatial
from scipy.sparse import csgraph

from msf_jax.host.solid import sections
from msf_jax.host.solid.enclosure import Enclosure
from msf_jax.host.solid.geometry import unit

UNFOLDINGS = 20  # rounds
HALVINGS = 2  # of an edge that is not inside, before a way is looked for
TOUCHING = 1e-5  # diagonals: a point with less room than that counts as outside
MOST_WAYS = (
    100  # that are looked for: a curve that needs more of them is beyond help, and each takes a tenth of a second
)
NEIGHBOURS = 16  # of a point, in the search for a way


def contain(
    shape: Enclosure, vertices: np.ndarray, edges: np.ndarray, is_held: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """The curve ``(vertices, edges)`` of a solid of diagonal 1, inside: its nodes, new ones last, and its edges.

    Nodes of ``is_held`` stay where they are. An edge that cannot be led through the solid stays as it is.
    """
    x, edges = vertices.copy(), edges.copy()
    radii = shape.clearance(x)
    is_out = (radii < TOUCHING) & ~is_held
    x[is_out] = _inward(shape, x[is_out])
    radii[is_out] = shape.clearance(x[is_out])
    for _ in range(HALVINGS):
        is_bad = ~is_inside(shape, x[edges[:, 0]], x[edges[:, 1]], radii[edges].sum(axis=1))
        middle, is_near = _middles(shape, x[edges[is_bad, 0]], x[edges[is_bad, 1]])
        is_bad[is_bad] = is_near
        x, edges = _replaced(x, edges, is_bad, [point[None] for point in middle[is_near]])
        radii = np.concatenate([radii, shape.clearance(x[len(radii) :])])
    is_bad = ~is_inside(shape, x[edges[:, 0]], x[edges[:, 1]], radii[edges].sum(axis=1))
    is_bad[np.flatnonzero(is_bad)[MOST_WAYS:]] = False
    return _replaced(x, edges, is_bad, [_way(shape, x[a], x[b]) for a, b in edges[is_bad]])


def is_inside(shape: Enclosure, a: np.ndarray, b: np.ndarray, covered: np.ndarray | None = None) -> np.ndarray:
    """(E,) True for a segment from a (E, 3) to b (E, 3) that is inside the solid.

    One shorter than ``covered`` (E,), the radii of balls inside around its ends together, is inside without a look.
    """
    length = np.linalg.norm(b - a, axis=1)
    is_in = np.zeros(len(a), dtype=bool) if covered is None else length < covered
    unknown = np.flatnonzero(~is_in)
    is_in[unknown] = shape.contains(a[unknown]) & shape.contains(b[unknown])
    rows = unknown[is_in[unknown]]
    ray, hit = shape.ray_hits(a[rows], unit(b - a)[rows], length[rows])
    # Where it meets the surface it comes out, or only crosses a fold of the surface inside: the stretches between tell.
    edge = np.concatenate([rows[ray], np.unique(rows[ray])])
    stop = np.concatenate([hit, np.zeros(len(edge) - len(hit))])
    order = np.lexsort((stop, edge))
    edge, stop = edge[order], stop[order]
    onward = np.append(stop[1:], 0.0)
    is_last = np.append(edge[1:] != edge[:-1], True)[: len(edge)]
    onward = np.where(is_last, length[edge], onward[: len(edge)])
    middle = a[edge] + ((stop + onward) / 2)[:, None] * unit(b - a)[edge]
    is_stretch = onward - stop > 1e-9
    is_in[edge[is_stretch][~shape.contains(middle[is_stretch])]] = False
    return is_in


def unfold(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray, is_held: np.ndarray) -> np.ndarray:
    """The nodes (N, 3) without sharp turns: where a branch turns back at a node, it cuts the corner if that is inside.

    A node that came in from outside, or is caught in a fold of the surface, would make a spike of the branch.
    """
    x = vertices.copy()
    ends = np.concatenate([edges, edges[:, ::-1]])
    ends = ends[np.argsort(ends[:, 0], kind="stable")]
    degree = np.bincount(edges.ravel(), minlength=len(x))
    inner = np.flatnonzero((degree == 2) & ~is_held)
    start = np.searchsorted(ends[:, 0], inner)
    before, after = ends[start, 1], ends[start + 1, 1]
    for _ in range(UNFOLDINGS):
        turns_back = np.einsum("ni,ni->n", x[inner] - x[before], x[after] - x[inner]) < 0
        turns_back[turns_back] = is_inside(shape, x[before[turns_back]], x[after[turns_back]])
        if not turns_back.any():
            break
        x[inner[turns_back]] = (x[before[turns_back]] + x[after[turns_back]]) / 2
    return x


def refine(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray, spacing: float) -> tuple[np.ndarray, np.ndarray]:
    """Split edges longer than ``spacing`` times the smaller of the radii at their ends, down to 1/400 diagonal."""
    radii = shape.approach(vertices)[0]
    a, b = vertices[edges[:, 0]], vertices[edges[:, 1]]
    length = np.linalg.norm(b - a, axis=1)
    target = np.maximum(spacing * radii[edges].min(axis=1), 1 / 400)
    count = np.ceil(length / target).astype(np.int64)
    is_long = count > 1
    chains = [
        start + np.linspace(0, 1, num + 1)[1:-1, None] * (end - start)
        for start, end, num in zip(a[is_long], b[is_long], count[is_long], strict=True)
    ]
    return _replaced(vertices, edges, is_long, chains)


def _replaced(
    x: np.ndarray, edges: np.ndarray, is_gone: np.ndarray, chains: list[np.ndarray]
) -> tuple[np.ndarray, np.ndarray]:
    """The curve with edges of ``is_gone`` led over the new nodes of ``chains``, one (k, 3) for each."""
    joined, count = [], len(x)
    for (a, b), chain in zip(edges[is_gone].tolist(), chains, strict=True):
        stops = [a, *range(count, count + len(chain)), b]
        joined += list(itertools.pairwise(stops))
        count += len(chain)
    new = np.array(joined, dtype=np.int64).reshape(-1, 2)
    return np.concatenate([x, *chains]), np.concatenate([edges[~is_gone], new])


def _middles(shape: Enclosure, a: np.ndarray, b: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """A point inside for the middle of each edge, and whether it is near enough to the edge to be on its way."""
    middle = (a + b) / 2
    inner = middle.copy()
    is_out = shape.clearance(middle) < TOUCHING
    inner[is_out] = _inward(shape, middle[is_out])
    room = shape.clearance(inner)
    found = sections.cut(shape, inner, unit(b - a), np.maximum(room, 0.01))
    is_better = found.is_around & (shape.clearance(found.centroid) > np.maximum(room, TOUCHING))
    inner = np.where(is_better[:, None], found.centroid, inner)
    return inner, np.linalg.norm(inner - middle, axis=1) < np.linalg.norm(b - a, axis=1)


def _inward(shape: Enclosure, points: np.ndarray) -> np.ndarray:
    """For points outside or on the surface, one on the chord behind the nearest triangle.

    It is the middle of the chord, or less deep where another wall is nearer than that: behind the flat end of a limb
    the chord goes all along the limb.
    """
    _, triangle = shape.nearest(points)
    a, b, c = np.moveaxis(shape.triangles[triangle], 1, 0)
    normal = np.cross(b - a, c - a)
    area2 = np.maximum(np.einsum("ij,ij->i", normal, normal), 1e-300)
    # Barycentric weights of the foot of the perpendicular, kept off the triangle's edges.
    sides = ((b, c), (c, a), (a, b))
    weight = np.stack([np.einsum("ij,ij->i", normal, np.cross(u - points, v - points)) / area2 for u, v in sides])
    weight = np.clip(weight, 0.05, 1.0)
    entry = np.einsum("kp,kpi->pi", weight / weight.sum(axis=0), np.stack([a, b, c]))
    entry, behind = entry - TOUCHING / 2 * unit(normal), -unit(normal)
    depth = np.linalg.norm(chord_middles(shape, entry, behind) - entry, axis=1)
    shallower = 0.5 ** np.arange(8)
    choice = entry[:, None] + (depth[:, None] * shallower)[..., None] * behind[:, None]
    room = shape.clearance(choice.reshape(-1, 3)).reshape(len(points), len(shallower))
    is_bounded = room >= 0.7 * depth[:, None] * shallower
    is_bounded[:, -1] = True
    return choice[np.arange(len(points)), is_bounded.argmax(axis=1)]


def chord_middles(shape: Enclosure, points: np.ndarray, ways: np.ndarray) -> np.ndarray:
    """The middle (P, 3) of the way from each point to the surface, along unit vectors."""
    length = np.full(len(points), np.inf)
    reach = 0.05
    while (is_far := ~(length < np.inf)).any() and reach < 2:
        found = shape.ray_lengths(points[is_far], ways[is_far], np.full(int(is_far.sum()), reach))
        length[is_far] = np.where(found < reach, found, np.inf)
        reach *= 3
    return points + np.where(length < np.inf, length / 2, 0.0)[:, None] * ways


def _way(shape: Enclosure, a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Points (k, 3) from a to b, with segments that are inside; none if there is no such way.

    It is looked for close by first, and then ever farther.
    """
    is_hopeless = not shape.contains(np.array([a, b])).all()  # a held node may be on the surface, or outside
    for effort in () if is_hopeless else (1, 2, 4, 8):
        reach = effort * (float(np.linalg.norm(b - a)) + 0.05)
        found = _way_within(shape, a, b, reach, effort * NEIGHBOURS)
        if len(found):
            return found
    return np.empty((0, 3))


def _way_within(shape: Enclosure, a: np.ndarray, b: np.ndarray, reach: float, neighbours: int) -> np.ndarray:
    """The same, over the middles of chords behind the faces within ``reach``, each joined to its neighbours."""
    middle = (a + b) / 2
    near = np.linalg.norm(shape.centroids - middle, axis=1) < reach
    corner = shape.triangles[near]
    behind = -unit(np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]))
    points = chord_middles(shape, shape.centroids[near] + TOUCHING / 2 * behind, behind)
    room = shape.clearance(points)
    points, room = points[room > TOUCHING], room[room > TOUCHING]
    # One for each cell of about half its ball: faces around a limb all have their chords' middles on its axis.
    size = 2.0 ** np.floor(np.log2(room) - 1)
    cells = np.concatenate([size[:, None], np.round(points / size[:, None])], axis=1)
    chosen = np.unique(cells, axis=0, return_index=True)[1]
    points, room = points[chosen], room[chosen]
    points, room = np.concatenate([points, [a, b]]), np.concatenate([room, shape.clearance(np.array([a, b]))])
    distance, other = spatial.KDTree(points).query(points, k=min(neighbours, len(points)))
    tail = np.repeat(np.arange(len(points)), other.size // len(points))
    head, length = other.ravel(), distance.ravel()
    is_open = tail != head
    is_open[is_open] = is_inside(shape, points[tail[is_open]], points[head[is_open]])
    cost = length[is_open] / np.maximum(np.minimum(room[tail], room[head])[is_open], TOUCHING)  # roomy ways first
    graph = sparse.coo_matrix((cost, (tail[is_open], head[is_open])), shape=(len(points),) * 2)
    start, end = len(points) - 2, len(points) - 1
    before = csgraph.dijkstra(graph.tocsr(), directed=False, indices=start, return_predecessors=True)[1]
    stops = []
    while before[end] >= 0:
        end = before[end]
        stops.append(end)
    return points[stops[-2::-1]] if len(stops) > 1 else np.empty((0, 3))
