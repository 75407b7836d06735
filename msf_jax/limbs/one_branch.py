"""One branch for each limb of a solid: which leaves stay, and branches for limbs without one.

Limbs are found on the surface (see `limbs.tree`), wherever the curve runs. Of the leaves in a limb, the one farthest
from its base stays. A limb without a leaf can get a branch, through the middles of its rings. All other leaves are
removed. A component without loops keeps two leaves: the ends of its longest path, from its limb if it has one.
"""

import itertools
from typing import NamedTuple

import numpy as np
from scipy import optimize, spatial
from scipy.sparse import csgraph

from msf_jax.limbs.ends import SPACING, LimbAxis
from msf_jax.limbs.tree import Limbs, LimbTree
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import arc_length, at, largest_of_each
from msf_jax.solid.solid import JUST_INSIDE, Solid, is_end, lids_of
from msf_jax.topology import graphs
from msf_jax.topology.graphs import trace


def choose(
    tree: LimbTree, limbs: Limbs, shape: Enclosure, vertices: np.ndarray, edges: np.ndarray, is_held: np.ndarray
) -> tuple[np.ndarray, list[LimbAxis]]:
    """Of a curve ``(vertices (N, 3), edges (E, 2))``, the leaf (l,) that stays for each of the ``limbs`` of a solid, -1
    for none (see `LimbTree.limbs`), and the limbs' axes.

    Of several leaves in a limb, the one farthest from the limb's base stays: a middle finger and not a thumb, on the
    left as on the right. A held one of ``is_held`` (N,) within a width of the limb's end stays instead."""
    leaves = leaves_of(edges)
    foot = feet(tree.shape, vertices[leaves])
    own, time, leaf = limbs.owner[foot], limbs.time, np.full(len(limbs.limbs), -1)
    axes = [tree.axis(shape, limbs, number) for number in range(len(leaf))]
    for number, limb in enumerate(limbs.limbs):
        mine = np.flatnonzero(own == number + 1)
        away = np.sqrt(2 * (time[limb.region].max() - time[foot[mine]]))
        order = np.lexsort((away, ~(is_held[leaves[mine]] & (away <= axes[number].width))))
        leaf[number] = leaves[mine[order[0]]] if len(mine) else -1
    return leaf, axes


def slenderness(tree: LimbTree, vertices: np.ndarray, edges: np.ndarray) -> np.ndarray:
    """(N,) the slenderness of the part of the surface around each leaf, see `LimbTree`; infinite for other nodes."""
    leaves, found = leaves_of(edges), np.full(len(vertices), np.inf)
    found[leaves] = tree.slenderness(feet(tree.shape, vertices[leaves]))
    return found


def leaves_of(edges: np.ndarray) -> np.ndarray:
    """The nodes (l,) with one edge; a duplicate edge counts once."""
    return np.flatnonzero(np.bincount(np.unique(np.sort(edges, axis=1), axis=0).ravel()) == 1)


def feet(shape: Enclosure, points: np.ndarray) -> np.ndarray:
    """The vertex (P,) nearest to each of ``points`` (P, 3), of the triangle nearest to it."""
    near = shape.faces[shape.nearest(points)[1]]
    away = np.linalg.norm(shape.vertices[near] - points[:, None], axis=2)
    return near[np.arange(len(near)), away.argmin(axis=1)]


def kept(
    vertices: np.ndarray, edges: np.ndarray, is_end: np.ndarray, is_held: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """The curve without the paths that lead only to leaves not of ``is_end`` (N,), and to no `ends`: which nodes stay
    (N,), and the one (N,) along the curve that stands for each. Cycles and nodes of ``is_held`` (N,) stay."""
    num, stays = len(vertices), np.zeros(len(vertices), dtype=bool)
    leaves = leaves_of(edges)
    stays[leaves] = (is_end | is_held)[leaves]
    stays |= ends(vertices, edges, stays) | is_held | (graphs.degrees(num, edges) == 0)
    # What stays is what a graph without leaves has, in which each end is in a triangle of its own with two more nodes.
    end = np.flatnonzero(stays)
    more = [np.stack([end, np.full_like(end, num + k)], axis=1) for k in (0, 1)]
    stays = graphs.core(num + 2, np.concatenate([edges, *more, [[num, num + 1]]]))[:num]
    return stays, graphs.nearest_along(vertices, edges, stays)


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
    any_node = np.unique(component, return_index=True)[1]
    first = np.where(count == 1, largest_of_each(component, stays), farthest(any_node))
    found = np.zeros(num, dtype=bool)
    for each in (first, farthest(first)):
        found[each[is_tree & (count < 2)]] = True
    return found


def grown(
    shape: Enclosure, vertices: np.ndarray, edges: np.ndarray, leaf: np.ndarray, axes: list[LimbAxis]
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The curve in the solid ``shape`` with a branch in each limb that has -1 for its ``leaf`` (l,): nodes, new ones
    last, edges, and the leaf (l,) of each limb.

    A branch begins at the node whose ball is nearest to the limb's base, so a finger begins in the palm and not at the
    finger beside it. The way there must be inside: a hand at the hip does not begin in the body."""
    x, radius, leaf = vertices, shape.clearance(vertices), leaf.copy()
    radius[leaves_of(edges)] = -np.inf
    for number in np.flatnonzero(leaf < 0).tolist():
        axis, leaf[number] = axes[number], len(x)
        first = beginning(shape, vertices, radius, axis.places[-1])
        places = np.concatenate([axis.places, vertices[[first]]])
        x, edges = relaid(x, edges, [], first, places, SPACING * axis.width)
    return x, edges, leaf


def laid(
    vertices: np.ndarray, edges: np.ndarray, is_held: np.ndarray, leaf: np.ndarray, axes: list[LimbAxis]
) -> tuple[np.ndarray, np.ndarray]:
    """The curve with its ends laid on the rings of the limbs: nodes, new ones last, and edges.

    ``leaf`` (l,) is the leaf of each limb, or -1, and ``axes`` are those of the limbs. The last stretch of its branch,
    as far as the axis reaches, is replaced, but no held node: from a held leaf on, the branch goes on to its end. A
    branch that runs back is replaced from its nearest point on."""
    x, is_held = vertices, is_held.copy()
    axis_of = {node: axis for node, axis in zip(leaf.tolist(), axes, strict=True) if node >= 0}
    for _ in range(2):  # of a branch with two ends, one end each
        for nodes in trace(len(x), edges):
            path = np.array(nodes if nodes[0] in axis_of else nodes[::-1])
            if len(path) < 2 or int(path[0]) not in axis_of:
                continue
            axis = axis_of.pop(int(path[0]))
            away = np.linalg.norm(x[path] - axis.places[0], axis=1)
            last = int(np.append(is_held[path[:-1]], True).argmax())
            # Not where another end of the branch is beside this one, as in a tube whose ends overlap.
            is_near = arc_length(x[path[: max(last, 1)]]) <= away[0] + axis.reach
            near = int(away[: max(last, 1)][is_near].argmin())
            number = min(max(1, near + int(np.append(away[near:] > axis.reach, True).argmax())), last)
            stop = int(path[number])
            near = max(1, int(np.linalg.norm(axis.places - x[stop], axis=1).argmin()))
            places = np.concatenate([axis.places[:near], x[[stop]]])
            x, edges = relaid(x, edges, path[:number].tolist(), stop, places, SPACING * axis.width)
            is_held = np.pad(is_held, (0, len(x) - len(is_held)))
    return x, edges


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
    """The node of ``vertices`` (N, 3), with balls of ``radius`` (N,), at which a branch to ``place`` (3,) begins: that
    of the nearest ball from which the way there is inside, or else the nearest node."""
    away = np.linalg.norm(vertices - place, axis=1)
    near = np.argsort(away - radius, kind="stable")
    for some in np.split(near, 2 ** np.arange((len(near) - 1).bit_length())):  # mostly one of the first few
        is_open = shape.holds(vertices[some], np.repeat(place[None], len(some), axis=0))
        if is_open.any():
            return int(some[is_open.argmax()])
    return int(np.where(radius == -np.inf, np.inf, away).argmin())


class Opened(NamedTuple):
    """A curve that is led to its openings. nodes: (N, 3), new ones last. edges: (E, 2). ends: (k,) the nodes there.
    lids: (L,) the faces of the solid that are their lids."""

    nodes: np.ndarray
    edges: np.ndarray
    ends: np.ndarray
    lids: np.ndarray


def opened(solid: Solid, nodes: np.ndarray, edges: np.ndarray, is_held: np.ndarray, lids: np.ndarray) -> Opened:
    """Lead the curve ``(nodes (N, 3), edges (E, 2))`` to the middles of those of the faces ``lids`` (L,) where a limb
    ends. Nodes of ``is_held`` (N,) do not move.

    A leaf that is no farther from a middle than the rim is a limb's end there. Within this distance a lid cuts off a
    part of the limb's sections, which drew the curve to one side, so the branch goes straight there. A limb without a
    leaf, which is short, gets a straight branch."""
    shape, start, num = solid.shape, solid.enter(nodes), len(nodes)
    wanted = [lid for lid in lids_of(shape.vertices, shape.faces, lids) if is_end(shape, lid)]
    # A place below the middle of a lid, and below all of its faces.
    below = [lid.middle - (lid.uneven + JUST_INSIDE * lid.radius()) * lid.normal for lid in wanted]
    axes = [
        LimbAxis(np.stack([lid.middle, place]), lid.radius(), lid.reach)
        for lid, place in zip(wanted, below, strict=True)
    ]
    leaves, middles = leaves_of(edges), np.array([lid.middle for lid in wanted]).reshape(-1, 3)
    away = spatial.distance.cdist(middles, start[leaves])
    is_near = (away <= np.array([lid.reach for lid in wanted])[:, None]).any(axis=0)
    away, leaves = away[:, is_near], leaves[is_near]
    # In a tube that is shorter than wide, both ends of the curve may be near the same lid.
    is_open = [shape.holds(start[leaves], np.repeat(place[None], len(leaves), axis=0)) for place in below]
    away = np.where(np.reshape(is_open, away.shape), away, 1e3)  # farther than any, as the solid's diagonal is 1
    leaf = np.full(len(wanted), -1)
    for lid, column in zip(*optimize.linear_sum_assignment(away), strict=True):
        leaf[lid] = leaves[column] if away[lid, column] < 1e3 else -1
    x, edges, _ = grown(shape, *laid(start, edges, is_held, leaf, axes), leaf, axes)
    moved, is_left = solid.leave(x), (x[:num] == start).all(axis=1)
    moved[:num][is_left] = nodes[is_left]
    ends = np.array(spatial.KDTree(x).query(middles)[1], dtype=np.int64)
    return Opened(moved, edges, ends, np.concatenate([lids[:0], *(lid.faces for lid in wanted)]))
