"""Keep the curve inside: nodes off the surface, edges covered by balls that are inside, whatever the flow did.

The ball around a point with the distance to the surface as its radius is inside the solid. Where the balls at the ends
of an edge overlap, so is the edge. An edge without such a cover is halved, and its new node moved to where there is
room, again and again; where that fails, it is led through a graph of overlapping balls, the shortest way.
"""

import itertools

import numpy as np
from scipy import sparse, spatial
from scipy.sparse import csgraph

from msf_jax.host import sections
from msf_jax.host.centring import clearance, unit
from msf_jax.host.enclosure import Enclosure

HALVINGS = 6  # of an edge that is not inside, with new nodes
LOOKS = 8  # halvings of an edge without new nodes, to see whether it is inside
TOUCHING = 1e-4  # diagonals: a point with less room than that counts as outside
BALL_NEIGHBOURS = 24


def contain(
    shape: Enclosure, vertices: np.ndarray, edges: np.ndarray, is_held: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """The curve ``(vertices, edges)`` of a solid of diagonal 1, inside: its nodes, new ones last, and its edges.

    Nodes of ``is_held`` stay where they are. An edge that cannot be led through the solid stays as it is.
    """
    x = vertices.copy()
    is_out = (clearance(shape, x) < TOUCHING) & ~is_held
    x[is_out] = _inward(shape, x[is_out])
    edges = edges.copy()
    for _ in range(HALVINGS):
        is_bad = ~is_inside(shape, x[edges[:, 0]], x[edges[:, 1]])
        if not is_bad.any():
            return x, edges
        middles = _roomy_middles(shape, x[edges[is_bad, 0]], x[edges[is_bad, 1]])
        x, edges = _replaced(x, edges, is_bad, [middle[None] for middle in middles])
    is_bad = ~is_inside(shape, x[edges[:, 0]], x[edges[:, 1]])
    return _replaced(x, edges, is_bad, [_way(shape, x[a], x[b]) for a, b in edges[is_bad]])


def is_inside(shape: Enclosure, a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """(E,) True for a segment from a (E, 3) to b (E, 3) that balls inside the surface cover."""
    room_a, room_b = clearance(shape, a), clearance(shape, b)
    is_covered = np.ones(len(a), dtype=bool)
    edge = np.arange(len(a))
    for _ in range(LOOKS):
        is_open = np.linalg.norm(a - b, axis=1) >= room_a + room_b
        a, b, room_a, room_b, edge = a[is_open], b[is_open], room_a[is_open], room_b[is_open], edge[is_open]
        if not len(edge):
            break
        middle = (a + b) / 2
        room = clearance(shape, middle)
        is_covered[edge[room < TOUCHING]] = False
        a, b = np.concatenate([a, middle]), np.concatenate([middle, b])
        room_a, room_b = np.concatenate([room_a, room]), np.concatenate([room, room_b])
        edge = np.concatenate([edge, edge])
        is_left = is_covered[edge]
        a, b, room_a, room_b, edge = a[is_left], b[is_left], room_a[is_left], room_b[is_left], edge[is_left]
    is_covered[edge] = False
    return is_covered


def refine(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray, spacing: float) -> tuple[np.ndarray, np.ndarray]:
    """Split edges longer than ``spacing`` times the smaller of the radii at their ends, down to 1/400 diagonal."""
    radii = clearance(shape, vertices)
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


def _roomy_middles(shape: Enclosure, a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """A point for the middle of each edge: of its cross-section there, or inwards from it where it is outside."""
    middle = (a + b) / 2
    room = clearance(shape, middle)
    is_out = room < TOUCHING
    middle[is_out] = _inward(shape, middle[is_out])
    room = clearance(shape, middle)
    found = sections.cut(shape, middle, unit(b - a), np.maximum(room, 0.01))
    is_better = found.is_around & (clearance(shape, found.centroid) > np.maximum(room, TOUCHING))
    return np.where(is_better[:, None], found.centroid, middle)


def _inward(shape: Enclosure, points: np.ndarray) -> np.ndarray:
    """For points outside or on the surface, the middle of the chord that starts at the nearest triangle."""
    _, triangle = shape.nearest(points)
    a, b, c = np.moveaxis(shape.triangles[triangle], 1, 0)
    normal = np.cross(b - a, c - a)
    area2 = np.maximum(np.einsum("ij,ij->i", normal, normal), 1e-300)
    # Barycentric weights of the foot of the perpendicular, kept off the triangle's edges.
    sides = ((b, c), (c, a), (a, b))
    weight = np.stack([np.einsum("ij,ij->i", normal, np.cross(u - points, v - points)) / area2 for u, v in sides])
    weight = np.clip(weight, 0.05, 1.0)
    entry = np.einsum("kp,kpi->pi", weight / weight.sum(axis=0), np.stack([a, b, c]))
    behind = -unit(normal)
    return chord_middles(shape, entry + TOUCHING / 2 * behind, behind)


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
    """Centres (k, 3) from a to b, each ball overlapping the next; none if there is no such way.

    The balls are those in the middles of chords behind the vertices around.
    """
    middle, reach = (a + b) / 2, 2 * np.linalg.norm(b - a) + 0.05
    near = np.linalg.norm(shape.triangles.mean(axis=1) - middle, axis=1) < reach
    corner = shape.triangles[near]
    behind = -unit(np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]))
    centre = chord_middles(shape, corner.mean(axis=1) + TOUCHING / 2 * behind, behind)
    room = clearance(shape, centre)
    centre, room = centre[room > TOUCHING], room[room > TOUCHING]
    centre, room = np.concatenate([centre, [a, b]]), np.concatenate([room, clearance(shape, np.array([a, b]))])
    distance, near = spatial.KDTree(centre).query(centre, k=min(BALL_NEIGHBOURS, len(centre)))
    tail = np.repeat(np.arange(len(centre)), near.size // len(centre))
    head, length = near.ravel(), distance.ravel()
    is_joined = (length < room[tail] + room[head]) & (tail != head)
    cost = length[is_joined] / np.maximum(np.minimum(room[tail], room[head])[is_joined], 1e-9)
    graph = sparse.coo_matrix((cost, (tail[is_joined], head[is_joined])), shape=(len(centre),) * 2)
    start, end = len(centre) - 2, len(centre) - 1
    before = csgraph.dijkstra(graph.tocsr(), directed=False, indices=start, return_predecessors=True)[1]
    stops = []
    while before[end] >= 0:
        end = before[end]
        stops.append(end)
    return centre[stops[-2::-1]] if len(stops) > 1 else np.empty((0, 3))
