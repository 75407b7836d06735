"""Keep the curve inside the solid: nodes off the surface, and edges that do not cross it.

A node outside is moved into the solid behind its nearest triangle, to the middle of the limb there. An edge that leaves
the solid is replaced by a path inside along the edges of a roadmap (see `roadmap`), which prefers short paths and large
balls.
"""

import itertools

import numpy as np

from msf_jax.inside import balls
from msf_jax.inside.roadmap import TOUCHING, Roadmap
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import ROUNDING, arc_length, barycentric
from msf_jax.topology import graphs

SHALLOWER = 10  # candidates for the ball behind the surface, each with half the radius of the one before


def contain(
    shape: Enclosure,
    vertices: np.ndarray,
    edges: np.ndarray,
    is_held: np.ndarray,
    roadmap: Roadmap | None = None,
) -> tuple[np.ndarray, np.ndarray]:
    """Move the curve ``(vertices, edges)`` into a solid of diagonal 1: returns its nodes, new ones last, and its edges.

    ``roadmap`` is that of the solid, if there is one already. Nodes of ``is_held`` do not move. An edge for which no
    path inside is found stays as it is.
    """
    x, edges = vertices.copy(), edges.copy()
    radii = shape.clearance(x)
    is_out = (radii < TOUCHING) & ~is_held
    roadmap = Roadmap(shape, is_inside) if roadmap is None else roadmap
    if is_out.any():
        x[is_out] = _inward(shape, x[is_out])
        radii[is_out] = shape.clearance(x[is_out])
        # If the surface is inside out there, no ball is behind its triangle: the nearest ball of the roadmap is taken.
        is_out = (radii < TOUCHING) & ~is_held
        x[is_out], radii[is_out] = roadmap.nearest(x[is_out], radii[is_out])

    is_bad = ~is_inside(shape, x[edges[:, 0]], x[edges[:, 1]], radii[edges].sum(axis=1))
    return _replaced(x, edges, is_bad, roadmap.paths(x, edges[is_bad]))


def cut_off(
    shape: Enclosure, vertices: np.ndarray, edges: np.ndarray, is_held: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Remove the ends of branches beyond an edge that is outside: which nodes stay, and the target of each node (N,).

    Where a noisy surface crosses itself, a leaf can be in a bubble that no path inside leads to. An end that is longer
    than the largest radius of its branch is no bubble: the solid may be in pieces there. Nodes of ``is_held`` (N,) stay
    and so do the nodes that join them to the rest, and at least two nodes of each branch.
    """
    stays, target = np.ones(len(vertices), dtype=bool), np.arange(len(vertices))
    degree = np.bincount(edges.ravel(), minlength=len(vertices))
    radii = shape.clearance(vertices)
    for path in graphs.trace(len(vertices), edges):
        for nodes in (np.array(path), np.array(path[::-1])):
            if degree[nodes[0]] != 1 or not stays[nodes].all():
                continue
            is_out = ~is_inside(shape, vertices[nodes[:-1]], vertices[nodes[1:]])
            is_end = arc_length(vertices[nodes])[1:] < radii[nodes].max()
            is_end &= ~np.logical_or.accumulate(is_held[nodes[:-1]])
            is_end[len(nodes) - 2 :] &= degree[nodes[-1]] > 2  # else only one node would be left
            last = np.flatnonzero(is_out & is_end)
            if len(last):
                gone = nodes[: last[-1] + 1]
                stays[gone], target[gone] = False, nodes[last[-1] + 1]
    return stays, target


def is_inside(
    shape: Enclosure, a: np.ndarray, b: np.ndarray, covered: np.ndarray | None = None, sliver: float = ROUNDING
) -> np.ndarray:
    """(E,) True for a segment from a (E, 3) to b (E, 3) that is inside the solid, up to stretches shorter than
    ``sliver`` between its ends.

    A segment shorter than ``covered`` (E,) is inside without a test: the sum of the radii of balls around its ends.
    """
    if covered is None:
        return shape.holds(a, b, sliver)
    is_in = np.linalg.norm(b - a, axis=1) < covered
    rows = np.flatnonzero(~is_in)
    is_in[rows] = shape.holds(a[rows], b[rows], sliver)
    return is_in


def between(num_nodes: int, edges: np.ndarray) -> np.ndarray:
    """(3, k) the nodes with two edges, and the two neighbours of each."""
    ends = np.concatenate([edges, edges[:, ::-1]])
    ends = ends[np.argsort(ends[:, 0], kind="stable")]
    inner = np.flatnonzero(np.bincount(edges.ravel(), minlength=num_nodes) == 2)
    start = np.searchsorted(ends[:, 0], inner)
    return np.stack([inner, ends[start, 1], ends[start + 1, 1]])


def refine(
    shape: Enclosure, vertices: np.ndarray, edges: np.ndarray, spacing: float, most: int
) -> tuple[np.ndarray, np.ndarray, bool]:
    """Split edges longer than ``spacing`` times the smaller radius at their ends, and longer than 1/400 diagonal.

    If that would need more than ``most`` nodes, all edges are split less, and the third result is True.
    """
    radii = shape.nearest(vertices, is_exact=False)[0]
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


def _inward(shape: Enclosure, points: np.ndarray) -> np.ndarray:
    """For points outside or on the surface: the centre of the ball that touches the nearest triangle from inside.

    The ball is found among samples of the surface. If a triangle between samples is nearer, a smaller ball is taken.
    """
    _, triangle = shape.nearest(points)
    corner, normal = shape.triangles[triangle], shape.normals[triangle]
    entry = np.einsum("pk,pki->pi", barycentric(points, corner, 0.05), corner) - TOUCHING / 2 * normal
    depth = balls.shrinking_balls(entry, normal, shape.samples.tree, balls.FIRST, 1.0).radius
    shallower = 0.5 ** np.arange(SHALLOWER)
    choice = entry[:, None] - (depth[:, None] * shallower)[..., None] * normal[:, None]
    clearance = shape.clearance(choice.reshape(-1, 3)).reshape(len(points), len(shallower))
    is_bounded = clearance >= 0.7 * depth[:, None] * shallower
    found = choice[np.arange(len(points)), is_bounded.argmax(axis=1)]
    # Samples can miss a far nearer wall, such as the other side of a plate of two triangles: take half of the chord.
    rows = np.flatnonzero(~is_bounded.any(axis=1))
    chord = shape.ray_lengths(entry[rows], -normal[rows], depth[rows])
    found[rows] = entry[rows] - (chord / 2)[:, None] * normal[rows]
    return found
