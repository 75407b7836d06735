"""Junctions of tubes: where the axes of their branches meet.

Near a junction sections are no guide, and the nodes there follow what is wide: a side branch pulls the curve of its
trunk towards it, and the flow's junction of a narrow fork is in front of the crotch, where its branches bend around it.
Farther on, where each branch has its usual radius, it is on its axis. A line continues that, or a parabola if it is
bent, with the tangent p + t d at the place of the junction. The point m nearest to all tangents,

    minimise  sum over the branches |(I - d d^T) (m - p)|^2,

is the junction, if it is nearly on each, and sees the places where the branches are on their axes. A blob
where limbs meet, such as a rump, has a larger ball than tubes have, and its junction stays in its middle.
"""

import numpy as np

from msf_jax.inside.containment import is_inside
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import arc_length, at, unit
from msf_jax.topology import graphs

TUBES = 1.3  # of the largest usual radius: largest ball of a junction of tubes; 5 / 4 where three equal ones form a T
BENT = 0.05  # radii: a stretch whose middle is nearer to its chord is straight; 0.08 for an arc of 6 radii
OFF = 0.2  # radii: largest distance of the meeting point from an axis
THIN = 0.6  # of the trunk's radius: largest usual radius of a side branch that is attached anew
THICK = 2.0  # of the usual radius of a side branch: where it has more, it is in its trunk; a cone has 1.3 to 1.6 there
CLEAR, STRETCH = 3.0, 6.0  # radii of a side branch from its trunk, where its axis begins, and the length that gives it
SHARED = 0.5  # radii of a side branch: it begins at a junction of the trunk that is nearer than that
FAR = 4.0  # of the trunk's radius: largest distance to it from where a side branch is on its axis, 15 degrees from it
USUAL = 0.9  # of the usual radius of a branch: a radius beyond the place where it has as much, its axis begins
BEGIN = 1.5  # radii from the place where it has its usual radius: there a branch is on its axis
MIDDLE = 0.4  # of a branch between two junctions: there at the latest
AXIS = 2.0  # radii: length of the stretch that gives a branch's axis
# least eigenvalue of the sum: 0.13 for a fork of 30 degrees; below it, axes are parallel and meet nowhere
SPREAD = 0.05


def attached(
    shape: Enclosure, x: np.ndarray, edges: np.ndarray, is_held: np.ndarray, radii: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """The curve with each thin side branch on a straight line to the place of its trunk that its axis meets: nodes
    (M, 3), new ones last, and edges (E, 2).

    The flow leaves the junction of a thin branch anywhere in the trunk, whose ball is larger, and the branch runs along
    the trunk until there. A new node of the trunk takes it; the old junction stays, and may be a leaf then.
    """
    x, radii, sides = x.copy(), radii.copy(), []
    degree = np.bincount(edges.ravel(), minlength=len(x))
    paths, thickest = graphs.trace(len(x), edges), radii.copy()  # of each junction, also in front of a crotch
    for path in paths:
        thickest[[path[0], path[-1]]] = np.maximum(thickest[[path[0], path[-1]]], np.median(radii[path]))
    for each in paths:
        path = np.array(each if degree[each[-1]] == 1 else each[::-1])
        size = float(np.median(radii[path[len(path) // 2 :]]))
        if degree[path[-1]] == 1 and degree[path[0]] > 2 and size < THIN * thickest[path[0]]:
            sides.append((path, size))
    in_side = np.zeros(len(x), dtype=bool)
    in_side[[node for path, _ in sides for node in path[1:]]] = True
    is_trunk = ~in_side[edges].any(axis=1)
    for path, size in sides:
        along, thick = arc_length(x[path]), np.flatnonzero(radii[path[: len(path) // 2]] > THICK * size)
        begin = int(np.searchsorted(along, along[thick[-1] if len(thick) else 0] + CLEAR * size))
        if begin >= len(path) or along[begin] + STRETCH * size > along[-1] or is_held[path[: begin + 1]].any():
            continue
        place = x[path[begin]]
        heading = unit(at(x[path], along, along[begin : begin + 1] + STRETCH * size)[0] - place)
        trunk = edges[is_trunk]
        if not len(trunk):
            break
        share, meet, off, back = _nearest_on(x[trunk], place, -heading)
        ball = (1 - share) * radii[trunk[:, 0]] + share * radii[trunk[:, 1]]
        is_near = (size < THIN * ball) & (off < OFF * ball) & (back < FAR * ball)
        if not is_near.any():  # also where all branches end here, and there is no trunk
            continue
        best = int(np.where(is_near, off / np.maximum(ball, 1e-300), np.inf).argmin())
        if not is_inside(shape, meet[best : best + 1], place[None])[0]:
            continue
        # Branches that begin at one place share its node.
        nodes = np.intersect1d(trunk, np.flatnonzero(np.bincount(edges.ravel()) > 2))
        away = np.linalg.norm(x[nodes] - meet[best], axis=1)
        is_shared, new = bool((away < SHARED * size).any()), len(x)
        if is_shared:
            new = int(nodes[away.argmin()])
            meet[best] = x[new]
        x[path[1 : begin + 1]] = meet[best] + np.linspace(0, 1, begin + 1)[1:, None] * (place - meet[best])
        is_first = (np.sort(edges, axis=1) == np.sort(path[:2])).all(axis=1)
        gone = np.flatnonzero(is_first).tolist()
        added, is_added = [[new, int(path[1])]], [False]
        if not is_shared:
            x, radii = np.append(x, meet[best : best + 1], axis=0), np.append(radii, ball[best])
            gone.append(int(np.flatnonzero(is_trunk)[best]))
            added += [[int(trunk[best, 0]), new], [new, int(trunk[best, 1])]]
            is_added += [True, True]
        edges = np.concatenate([np.delete(edges, gone, axis=0), added])
        is_trunk = np.append(np.delete(is_trunk, gone), is_added)
    return x, edges


def _nearest_on(
    segment: np.ndarray, place: np.ndarray, heading: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Of each ``segment`` (S, 2, 3), where it is nearest to the ray from ``place`` (3,) along the unit vector
    ``heading`` (3,): the share (S,) of its length, the point (S, 3), its distance (S,) from the ray, and from
    ``place`` along the ray (S,)."""
    start, span = segment[:, 0] - place, segment[:, 1] - segment[:, 0]
    # Without the component along the ray, the nearest point of the segment to the origin.
    flat, flat_span = (each - np.outer(each @ heading, heading) for each in (start, span))
    share = np.clip(-np.einsum("si,si->s", flat, flat_span) / np.maximum((flat_span**2).sum(axis=1), 1e-300), 0.0, 1.0)
    meet = segment[:, 0] + share[:, None] * span
    back = (meet - place) @ heading
    off = np.linalg.norm(meet - place - np.maximum(back, 0.0)[:, None] * heading, axis=1)
    return share, meet, off, back


def met(shape: Enclosure, x: np.ndarray, edges: np.ndarray, is_held: np.ndarray, radii: np.ndarray) -> np.ndarray:
    """The nodes (N, 3) with junctions of tubes where the axes of their branches meet, and the nodes on the line to each
    branch's own stretch on its line."""
    x = x.copy()
    at_node: dict[int, list[np.ndarray]] = {}
    for each in graphs.trace(len(x), edges):
        for path in (each, each[::-1]):
            at_node.setdefault(path[0], []).append(np.array(path))
    for node, paths in at_node.items():
        usual = np.array([float(np.median(radii[path[1:]])) for path in paths if len(path) > 1])
        if len(paths) < 3 or is_held[node] or radii[node] > TUBES * usual.max(initial=0.0):
            continue
        begins, lines = [], []
        for path, size in zip(paths, usual, strict=True):
            along, is_own = arc_length(x[path]), radii[path] >= USUAL * size
            margin, is_link = BEGIN * size, len(at_node[path[-1]]) > 2
            if is_link:
                margin = min(margin, MIDDLE * along[-1])
            start = along[is_own.argmax()] + margin
            length = min(AXIS * size, along[-1] - is_link * margin - start)
            begin = int(np.searchsorted(along, start))
            if margin < size or length <= 0 or is_held[path[: begin + 1]].any():
                break
            # Through three points of the branch's own stretch, or two if it is straight.
            place = start + length * np.array([0.0, 0.5, 1.0])
            three = at(x[path], along, place)
            is_bent = np.linalg.norm(three[1] - (three[0] + three[2]) / 2) > BENT * size
            step = slice(None, None, 1 if is_bent else 2)
            begins.append(begin)
            lines.append(np.pad(np.polyfit(place[step], three[step], 1 + is_bent), ((1 - is_bent, 0), (0, 0))))
        if len(begins) < len(paths):
            continue
        p, d = np.array([line[2] for line in lines]), unit(np.array([line[1] for line in lines]))
        flat = np.eye(3) - d[:, :, None] * d[:, None, :]
        total = flat.sum(axis=0)
        if np.linalg.eigvalsh(total)[0] < SPREAD:
            continue
        meet = np.linalg.solve(total, np.einsum("bij,bj->i", flat, p))
        off = np.linalg.norm(np.einsum("bij,bj->bi", flat, meet - p), axis=1)
        begun = x[[path[begin] for path, begin in zip(paths, begins, strict=True)]]
        if (off > OFF * usual).any() or not is_inside(shape, np.repeat(meet[None], len(p), axis=0), begun).all():
            continue
        for path, begin, (square, slope, start) in zip(paths, begins, lines, strict=True):
            along = arc_length(x[path[: begin + 1]])[:, None]
            x[path[: begin + 1]] = start + along * (slope + along * square) + (1 - along / along[-1]) * (meet - start)
    return x
