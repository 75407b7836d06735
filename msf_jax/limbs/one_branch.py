"""One branch for each limb of a solid: which leaves stay, and branches for limbs without one.

Limbs are found on the surface (see `caps`), wherever the curve runs. Of the leaves in a limb, the one farthest from its
base stays. A limb without a leaf can get a branch, through the middles of the curves around its discs. All other leaves
are removed. A component without loops keeps two leaves: the ends of its longest path, from its limb if it has one.
"""

import itertools
from typing import NamedTuple

import numpy as np
from scipy import spatial
from scipy.sparse import csgraph

from msf_jax.inside.containment import is_inside
from msf_jax.limbs import pruning
from msf_jax.limbs.caps import Caps
from msf_jax.limbs.ends import LAST, RING_SPACING, LimbAxis, is_near_end
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import arc_length, at, largest_of_each
from msf_jax.topology import graphs
from msf_jax.topology.graphs import trace

TRIED = 64  # nodes, those with the nearest balls first, that a new branch may begin at; else it is the nearest node


class Choice(NamedTuple):
    """worth: (N,) of each leaf: infinite for one that stays, else the slenderness of its cap, 0 in a limb that has a
    better leaf. leaf: of each limb, the leaf that stays, or -1. axes: of the limbs. was_hit: whether the search ended
    early."""

    worth: np.ndarray
    leaf: list[int]
    axes: list[LimbAxis]
    was_hit: bool


def choose(
    caps: Caps, shape: Enclosure, vertices: np.ndarray, edges: np.ndarray, is_held: np.ndarray, least: float
) -> Choice:
    """The leaves of a curve ``(vertices (N, 3), edges (E, 2))`` for the limbs of slenderness ``least`` of a solid.

    Of several leaves in a limb, the one farthest from the limb's base stays: a middle finger and not a thumb, on the
    left as on the right. A held one of ``is_held`` (N,) within a width of the limb's end stays instead. A leaf behind a
    hole across the limb is not at its end.
    """
    leaves, limbs = leaves_of(edges), caps.limbs(least)
    axes = [caps.axis(shape, limbs, number) for number in range(len(limbs.caps))]
    foot = feet(caps.shape, vertices[leaves])
    own = limbs.owner[foot]
    worth, leaf = np.zeros(len(vertices)), []
    worth[leaves] = np.where(own > 0, 0.0, limbs.slenderness[caps.tip_of[foot]])
    for number, (cap, time) in enumerate(zip(limbs.caps, limbs.times, strict=True), 1):
        mine = np.flatnonzero(own == number)
        away = np.sqrt(2 * (time[cap.region].max() - time[foot[mine]]))
        is_end = is_held[leaves[mine]] & is_near_end(time, *cap[2:], foot[mine])
        order = np.lexsort((away, ~is_end))
        first = mine[order[away[order] < axes[number - 1].reach][:1]]
        worth[leaves[first]] = np.inf
        leaf.append(int(leaves[first[0]]) if len(first) else -1)
    return Choice(worth, leaf, axes, caps.was_hit)


def slenderness(caps: Caps, vertices: np.ndarray, edges: np.ndarray, enough: float = np.inf) -> np.ndarray:
    """(N,) the largest slenderness of the caps around each leaf's tip without another leaf, infinite for other nodes.

    With ``enough`` it is some value of at least that, of caps around the nearest vertex, which is faster.
    """
    leaves, found = leaves_of(edges), np.full(len(vertices), np.inf)
    foot = feet(caps.shape, vertices[leaves])
    found[leaves] = caps.slenderness(foot, caps.tip_of[foot] if enough == np.inf else foot, enough)
    return found


def leaves_of(edges: np.ndarray) -> np.ndarray:
    """The nodes (l,) with one edge; a duplicate edge counts once."""
    return np.flatnonzero(np.bincount(np.unique(np.sort(edges, axis=1), axis=0).ravel()) == 1)


def feet(shape: Enclosure, points: np.ndarray) -> np.ndarray:
    """The vertex (P,) nearest to each of ``points`` (P, 3), of the triangle nearest to it."""
    near = shape.faces[shape.approximate_closest(points)[1]]
    away = np.linalg.norm(shape.vertices[near] - points[:, None], axis=2)
    return near[np.arange(len(near)), away.argmin(axis=1)]


def kept(
    vertices: np.ndarray, edges: np.ndarray, worth: np.ndarray, is_held: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Remove the branches that end in leaves of finite ``worth`` (N,), but not in `ends`; see `pruning.prune`."""
    is_end = np.zeros(len(worth), dtype=bool)
    is_end[leaves_of(edges)] = True
    worth = np.where(ends(vertices, edges, is_end & ((worth == np.inf) | is_held)), np.inf, worth)
    return pruning.prune(len(worth), edges, lambda nodes: float(worth[next(nodes)]), np.inf, is_held)


def ends(vertices: np.ndarray, edges: np.ndarray, stays: np.ndarray) -> np.ndarray:
    """(N,) True for the ends of the longest path of each component without loops that has fewer than two leaves of
    ``stays`` (N,): from the one that it has, or else between any two."""
    num = len(vertices)
    graph = graphs.weighted(num, *edges.T, weight=graphs.lengths(vertices, edges))
    component = graphs.labels(num, *edges.T)

    def farthest(sources: np.ndarray) -> np.ndarray:
        return largest_of_each(component, csgraph.dijkstra(graph, directed=False, indices=sources, min_only=True))

    is_tree = np.bincount(component) - np.bincount(component[edges[:, 0]], minlength=component.max() + 1) == 1
    count = np.bincount(component, stays)
    first = np.where(
        count == 1, largest_of_each(component, stays), farthest(np.unique(component, return_index=True)[1])
    )
    found = np.zeros(num, dtype=bool)
    for each in (first, farthest(first)):
        found[each[is_tree & (count < 2)]] = True
    return found


def grown(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray, choice: Choice) -> tuple[np.ndarray, np.ndarray]:
    """The curve in the solid ``shape`` with a branch in each limb without a leaf: nodes, new ones last, and edges.

    A branch begins at the node whose ball is nearest to the limb's base, so a finger begins in the palm and not at the
    finger beside it. The way there must be inside: a hand at the hip does not begin in the body. Where a node's ball
    holds the limb's axis before, the branch begins there: a toe that the leg ends in is no second strand of the leg.
    """
    x, radius = vertices, shape.approximate_clearance(vertices)[0]
    radius[leaves_of(edges)] = -np.inf
    for leaf, axis in zip(choice.leaf, choice.axes, strict=True):
        if leaf < 0:
            away = spatial.distance.cdist(axis.places[1:-1], vertices) - radius
            own = axis.places[: int(np.argmax(np.append((away <= 0).any(axis=1), True))) + 2]
            first = beginning(shape, vertices, radius, own[-1])
            places = np.concatenate([own, vertices[[first]]])
            x, edges = relaid(x, edges, [], first, places, RING_SPACING * axis.width)
    return x, edges


def laid(
    vertices: np.ndarray, edges: np.ndarray, is_held: np.ndarray, leaf: list[int], axes: list[LimbAxis]
) -> tuple[np.ndarray, np.ndarray]:
    """The curve with its ends laid on the rings of the limbs: nodes, new ones last, and edges.

    ``leaf`` is the leaf of each limb, or -1, and ``axes`` are those of the limbs. The last stretch of its branch,
    `LAST` widths of the limb, is replaced, but no held node. A branch with two ends that has no other stretch is
    replaced as a whole.
    """
    x = vertices.copy()
    axis_of = {node: axis for node, axis in zip(leaf, axes, strict=True) if node >= 0 and not is_held[node]}
    for nodes in trace(len(vertices), edges):
        path = np.array(nodes)
        sides = [
            (part, axis_of[int(part[0])], _stretch(vertices[part], is_held[part], axis_of[int(part[0])]))
            for part in (path, path[::-1])
            if int(part[0]) in axis_of and len(part) > 1
        ]
        if len(sides) == 2 and sides[0][2] + sides[1][2] >= len(path):
            one, other = sides[0][1], sides[1][1]
            places = np.concatenate([one.places, other.places[::-1]])
            x[path[-1]] = places[-1]
            x, edges = relaid(x, edges, nodes[:-1], nodes[-1], places, RING_SPACING * min(one.width, other.width))
            continue
        for part, axis, number in sides:
            stop = vertices[part[number]]
            near = max(1, int(np.linalg.norm(axis.places - stop, axis=1).argmin()))
            places = np.concatenate([axis.places[:near], stop[None]])
            x, edges = relaid(x, edges, part[:number].tolist(), int(part[number]), places, RING_SPACING * axis.width)
    return x, edges


def _stretch(points: np.ndarray, is_held: np.ndarray, axis: LimbAxis) -> int:
    """How many of the ``points`` (k, 3) of a branch are within `LAST` widths of the limb's end, before a held one. A
    branch that runs back is replaced from its nearest point on."""
    away = np.linalg.norm(points - axis.places[0], axis=1)
    last = int(np.argmax(np.append(is_held[1:], True))) + 1
    near = int(away[:last].argmin())
    first = near + int(np.argmax(np.append(away[near:] > LAST * axis.width, True)))
    return min(max(1, first), last, len(points) - 1)


def relaid(
    x: np.ndarray, edges: np.ndarray, old: list[int], stop: int, places: np.ndarray, spacing: float
) -> tuple[np.ndarray, np.ndarray]:
    """The curve ``(x (N, 3), edges (E, 2))`` with an end laid on ``places`` (k, 3), from the end to the node ``stop``.

    ``old`` are the nodes from a leaf to that one, without it; none for a new branch. Nodes ``spacing`` apart are added.
    """
    along = arc_length(places)
    num = max(len(old), int(np.ceil(along[-1] / spacing)), 1)
    places = at(places, along, np.linspace(0.0, along[-1], num + 1))[:-1]
    chain = [*old[-1:], *range(len(x), len(x) + num - len(old)), stop]
    is_left = (np.sort(edges, axis=1) != sorted(chain[:1] + [stop])).any(axis=1)
    x = np.concatenate([x, places[len(old) :]])
    x[old] = places[: len(old)]
    return x, np.concatenate([edges[is_left], np.array(list(itertools.pairwise(chain)), dtype=np.int64)])


def beginning(shape: Enclosure, vertices: np.ndarray, radius: np.ndarray, place: np.ndarray) -> int:
    """The node of ``vertices`` (N, 3), with balls of ``radius`` (N,), at which a branch to ``place`` (3,) begins."""
    away = np.linalg.norm(vertices - place, axis=1)
    near = np.argsort(away - radius, kind="stable")[:TRIED]
    is_open = is_inside(shape, vertices[near], np.repeat(place[None], len(near), axis=0))
    return int(near[is_open.argmax()] if is_open.any() else np.where(radius == -np.inf, np.inf, away).argmin())
