"""One branch for each limb of a solid: which leaves stay, and branches for limbs without one.

Limbs are found on the surface (see `caps`), wherever the curve runs. Of the leaves in a limb, the one farthest from its
base stays. A limb without a leaf can get a branch, through the middles of the curves around its discs. All other leaves
are removed. A component without loops keeps two leaves: the ends of its longest path, from its limb if it has one.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from scipy import sparse
from scipy.sparse import csgraph

from msf_jax.host.curve import pruning
from msf_jax.host.curve.containment import is_inside
from msf_jax.host.solid.enclosure import Enclosure
from msf_jax.host.solid.geometry import arc_length, at, largest_of_each
from msf_jax.host.thin.caps import Cap, Caps

TRIED = 64  # nodes, those with the nearest balls first, that a new branch may begin at; else it is the nearest node


class Choice(NamedTuple):
    """worth: (N,) of each leaf: infinite for one that stays, else the slenderness of its cap, 0 in a limb that has a
    better leaf. missing: the limbs without a leaf. was_hit: whether the search ended early."""

    worth: np.ndarray
    missing: list[Cap]
    was_hit: bool


def choose(caps: Caps, vertices: np.ndarray, edges: np.ndarray, is_held: np.ndarray, least: float) -> Choice:
    """The leaves of a curve ``(vertices (N, 3), edges (E, 2))`` for the limbs of slenderness ``least`` of a surface.

    Of several leaves in a limb, the one farthest from the limb's base stays, or a held one of ``is_held`` (N,) near it.
    Other held ones stay, too, beside it.
    """
    leaves = leaves_of(edges)
    foot = feet(caps.shape, vertices[leaves])
    tips = caps.tips()
    tips = np.concatenate([tips, np.setdiff1d(caps.tip_of[foot], tips)])
    found, slenderness = caps.limbs(least, tips, with_blunt=True)
    rank, missing = matched(foot, is_held[leaves], found, len(caps.tip_of), caps.from_base)
    of_tip = np.zeros(len(caps.tip_of))
    of_tip[tips] = slenderness
    worth = np.zeros(len(vertices))
    worth[leaves] = np.where(rank == 0, np.inf, np.where(rank > 0, 0.0, of_tip[caps.tip_of[foot]]))
    return Choice(worth, missing, caps.was_hit)


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


def matched(
    foot: np.ndarray, is_held: np.ndarray, caps: list[Cap], num_vertices: int, from_base: Callable[[Cap], np.ndarray]
) -> tuple[np.ndarray, list[Cap]]:
    """The rank of each leaf in its limb, -1 outside of limbs: 0 for the one farthest from the limb's base: a middle
    finger and not a thumb, on the left as on the right. A held one within a limb's radius of it goes before.

    ``foot`` (l,) are the leaves' nearest vertices, ``is_held`` (l,) says which are held, and ``from_base`` gives the
    distance (V,) of vertices from a limb's base. Also returns the limbs without a leaf, the largest first.
    """
    rank = np.full(len(foot), -1)
    own = np.full(num_vertices, -1)
    order = sorted(range(len(caps)), key=lambda k: -caps[k].area)
    for k in order:
        own[caps[k].region] = k
    missing = []
    for k in order:
        mine = np.flatnonzero(own[foot] == k)
        away = from_base(caps[k])[foot[mine]] if len(mine) > 1 else np.zeros(len(mine))
        is_end = is_held[mine] & (away >= away.max(initial=0.0) - 2 * caps[k].step)
        rank[mine[np.lexsort((-away, ~is_end))]] = range(len(mine))
        missing += [] if len(mine) else [caps[k]]
    return rank, missing


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
    length = np.linalg.norm(vertices[edges[:, 0]] - vertices[edges[:, 1]], axis=1)
    graph = sparse.coo_matrix((length, (edges[:, 0], edges[:, 1])), (num, num)).tocsr()
    component = csgraph.connected_components(graph, directed=False)[1]

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


def grown(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray, caps: list[Cap]) -> tuple[np.ndarray, np.ndarray]:
    """The curve in the solid ``shape`` with a branch in each of ``caps``: nodes, new ones last, and edges.

    A branch begins at the node whose ball is nearest to the limb's base, so a finger begins in the palm and not at the
    finger beside it. The way there must be inside: a hand at the hip does not begin in the body. Leaves are left out.
    """
    old, radius = vertices, shape.approximate_clearance(vertices)[0]
    radius[leaves_of(edges)] = -np.inf
    for cap in caps:
        places = cap.middles[::-1]
        away = np.linalg.norm(old - places[0], axis=1)
        near = np.argsort(away - radius, kind="stable")[:TRIED]
        is_open = is_inside(shape, old[near], np.repeat(places[:1], len(near), axis=0))
        first = near[is_open.argmax()] if is_open.any() else away.argmin()
        along = arc_length(places)
        num = max(2, int(np.ceil(along[-1] / cap.step)) + 1) if along[-1] else 1
        places = at(places, along, np.linspace(0, along[-1], num))
        new = np.arange(len(vertices), len(vertices) + num)
        edges = np.concatenate([edges, np.stack([np.append(first, new[:-1]), new], axis=1)])
        vertices = np.concatenate([vertices, places])
    return vertices, edges
