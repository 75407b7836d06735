"""One branch for each limb of a solid: which leaves stay, and branches for limbs without one.

Limbs are found on the surface (see `caps`), wherever the flow's curve runs. Of the leaves in a limb, the one nearest to
its tip stays. A limb without a leaf gets a branch, through the middles of the curves around its discs. All other leaves
are removed. A component without loops keeps two leaves: of those outside of limbs, the ones with the slenderest caps.
"""

import numpy as np
from scipy import spatial

from msf_jax.host.curve import limbs
from msf_jax.host.solid.geometry import arc_length, at
from msf_jax.host.thin.caps import Cap


def matched(
    leaves: np.ndarray, is_held: np.ndarray, foot: np.ndarray, caps: list[Cap], points: np.ndarray
) -> tuple[np.ndarray, list[Cap]]:
    """The rank of each of ``leaves`` (l, 3) in its limb, -1 outside of limbs: 0 for a held one of ``is_held``
    (l,), or the one nearest to the limb's tip.

    ``foot`` (l,) are their nearest vertices among ``points`` (V, 3) of the surface. Also returns the limbs without a
    leaf, the largest first.
    """
    rank = np.full(len(leaves), -1)
    own = np.full(len(points), -1)
    order = sorted(range(len(caps)), key=lambda k: -caps[k].area)
    for k in order:
        own[caps[k].region] = k
    missing = []
    for k in order:
        mine = np.flatnonzero(own[foot] == k)
        away = np.linalg.norm(leaves[mine] - points[caps[k].tip], axis=1)
        rank[mine[np.lexsort((away, ~is_held[mine]))]] = range(len(mine))
        missing += [] if len(mine) else [caps[k]]
    return rank, missing


def kept(
    vertices: np.ndarray, edges: np.ndarray, worth: np.ndarray, is_held: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Remove the branches that end in leaves of finite ``worth`` (N,), the least first; see `prune`."""
    stays, target = np.ones(len(vertices), dtype=bool), np.arange(len(vertices))
    held = set(np.flatnonzero(is_held).tolist())
    pruning = limbs.Pruning(vertices, edges, limbs.limbs_without(vertices, edges, np.ones(len(vertices))))
    gone = True
    while gone:
        gone = False
        for leaf in sorted(pruning.leaves(), key=lambda each: (worth[each], each)):
            nodes = pruning.branch(leaf)
            if worth[leaf] < np.inf and held.isdisjoint(nodes[:-1]) and pruning.slenderness(leaf) < np.inf:
                stays[nodes[:-1]] = False
                target[nodes[:-1]] = nodes[-1]
                pruning.take_away(leaf)
                gone = True
    while (target != target[target]).any():
        target = target[target]
    return stays, target


def grown(vertices: np.ndarray, edges: np.ndarray, caps: list[Cap]) -> tuple[np.ndarray, np.ndarray]:
    """The curve with a branch in each of ``caps``, from its nearest node: nodes, new ones last, and edges."""
    for cap in caps:
        places = cap.middles[::-1]
        first = spatial.KDTree(vertices).query(places[0])[1]
        along = arc_length(places)
        num = max(2, int(np.ceil(along[-1] / cap.step)) + 1) if along[-1] else 1
        places = at(places, along, np.linspace(0, along[-1], num))
        new = np.arange(len(vertices), len(vertices) + num)
        edges = np.concatenate([edges, np.stack([np.append(first, new[:-1]), new], axis=1)])
        vertices = np.concatenate([vertices, places])
    return vertices, edges
