"""Bones from a curve: the joints, the parent of each bone, and its part of the curve.

A bone begins at its joint, about which it turns. The root's joint is at the thickest junction; its part of the curve is
inside the ball there. Each branch at a junction begins with its own joint, where it leaves the junction's ball, as an
arm leaves a shoulder. So each limb turns on its own. A branch has more bones where it bends most, or where it is long.
"""

import heapq
import itertools
from typing import NamedTuple

import networkx as nx
import numpy as np

from msf_jax.host import graphs
from msf_jax.host.curve import branches
from msf_jax.host.solid.geometry import arc_length, at

LEAST_LIMB = 0.6  # radii of the junction's ball: a limb that sticks out of the ball by less has no bone
FOR_LIMBS = 0.6  # share of all bones for the first bones of branches, at most; the rest is for bends
BENT = 0.35  # radii: a bone's part of the curve is cut if it is farther than this from a straight line
LONG = 6.0  # radii: a longer bone is cut
SHORTEST = 1.0  # radii: the least length of a bone after a cut, and of one between two junctions
USUAL = 75  # percentile of the radii along a bone that counts as the bone's radius
LEAVES = 0.6  # share of a branch's length that the ball at its start may cover, at most


class Bones(NamedTuple):
    """B bones, parents before children.

    joints: (B, 3) the start of each, about which it turns. tails: (B, 3) the end. parents: (B,) -1 for a root. branch:
    (B,) the branch of the curve, -1 for a root. place: (B,) the position along the branch, from 0. is_limb: (B,)
    whether the branch ends in a tip. of_node: (N,) the bone of every node of the curve.
    """

    joints: np.ndarray
    tails: np.ndarray
    parents: np.ndarray
    branch: np.ndarray
    place: np.ndarray
    is_limb: np.ndarray
    of_node: np.ndarray


class _BonePath(NamedTuple):
    """A branch directed away from the root. along: (n,) arc length of its nodes. start: that of its first joint. above:
    the branch before it, -1 at the root's junction."""

    nodes: np.ndarray
    along: np.ndarray
    start: float
    above: int
    is_limb: bool


def bones_of(vertices: np.ndarray, edges: np.ndarray, radii: np.ndarray, most: int) -> Bones:
    """At most ``most`` bones for a curve ``(vertices (N, 3), edges (E, 2))`` in limbs of ``radii`` (N,). If there are
    too many components, the longest have bones."""
    edges = edges[branches.cut_loops(len(vertices), edges, radii)]
    stays, target = _limbs(vertices, edges, radii, max(1, int(FOR_LIMBS * most)))
    roots, paths = _paths(vertices, edges[stays[edges].all(axis=1)], radii, stays, most)
    cuts = _cuts(vertices, radii, paths, most - len(roots))
    joints, tails, parents, branch, place, is_limb = [], [], [], [], [], []
    of_node, last = np.full(len(vertices), -1), {}
    for number, root in enumerate(roots):
        joints.append(vertices[root])
        first = [path for path in paths if path.nodes[0] == root]
        longest = max(first, key=lambda path: path.along[-1]) if first else None
        tails.append(vertices[root] if longest is None else _at(vertices, longest, longest.start))
        parents.append(-1)
        branch.append(-1)
        place.append(0)
        is_limb.append(False)
        of_node[root] = number
        last[int(root)] = number  # maps the last node of a branch to its last bone
    for number, (path, stops) in enumerate(zip(paths, cuts, strict=True)):
        above = last[int(path.nodes[0])]
        first = len(joints)
        for k, (begin, end) in enumerate(itertools.pairwise(stops)):
            joints.append(_at(vertices, path, begin))
            tails.append(_at(vertices, path, end))
            parents.append(above if k == 0 else len(joints) - 2)
            branch.append(number)
            place.append(k)
            is_limb.append(path.is_limb)
        piece = np.minimum(np.searchsorted(stops, path.along, side="right") - 1, len(stops) - 2)
        own = np.where(piece < 0, above, first + piece)
        of_node[path.nodes[1:]] = own[1:]
        last[int(path.nodes[-1])] = own[-1]
    known = np.flatnonzero(of_node >= 0)
    lost = np.flatnonzero((of_node < 0) & stays)  # nodes of components without a bone
    if len(lost):
        away = np.linalg.norm(vertices[lost][:, None] - vertices[known], axis=2)
        of_node[lost] = of_node[known[away.argmin(axis=1)]]
    columns = np.array(joints), np.array(tails), np.array(parents), np.array(branch), np.array(place), np.array(is_limb)
    found = Bones(*columns, of_node[target])
    while len(found.joints) > most:  # a junction of more limbs than that
        length = np.linalg.norm(found.tails - found.joints, axis=1)
        found = without(found, np.arange(len(length)) == np.where(found.parents < 0, np.inf, length).argmin())
    return found


def _at(vertices: np.ndarray, path: _BonePath, stop: float) -> np.ndarray:
    """The point (3,) of a branch at the arc length ``stop``."""
    return at(vertices[path.nodes], path.along, np.array([stop]))[0]


def without(bones: Bones, is_left_out: np.ndarray) -> Bones:
    """The bones without those of ``is_left_out`` (B,), none of them roots. Their nodes go to their parents."""
    heir = np.arange(len(bones.parents))
    for bone in np.flatnonzero(is_left_out):
        heir[bone] = heir[bones.parents[bone]]
    stays = ~is_left_out
    rank = np.cumsum(stays) - 1
    parents = bones.parents[stays]
    parents = np.where(parents < 0, -1, rank[heir[parents]])
    place = bones.place.copy()
    for bone in np.flatnonzero(is_left_out):
        place[(bones.branch == bones.branch[bone]) & (bones.place > bones.place[bone])] -= 1
    return Bones(
        bones.joints[stays],
        bones.tails[stays],
        parents,
        bones.branch[stays],
        place[stays],
        bones.is_limb[stays],
        rank[heir[bones.of_node]],
    )


def _limbs(vertices: np.ndarray, edges: np.ndarray, radii: np.ndarray, most: int) -> tuple[np.ndarray, np.ndarray]:
    """Remove limbs that are too short for a bone, then the shortest limbs until there are ``most`` branches. A limb's
    length counts from the ball at its junction. Returns which nodes stay (N,), and the node that replaces each (N,)."""
    target = np.arange(len(vertices))
    paths = dict(enumerate(graphs.trace(len(vertices), edges)))
    at_end: dict[int, set[int]] = {}
    for number, nodes in paths.items():
        for end in {nodes[0], nodes[-1]}:
            at_end.setdefault(end, set()).add(number)
    length = {number: arc_length(vertices[nodes])[-1] for number, nodes in paths.items()}

    def reach(number: int) -> tuple[float, int, int]:
        """How far a limb sticks out, its junction and its tip; infinite for a branch that is no limb."""
        first, last = paths[number][0], paths[number][-1]
        degrees = len(at_end[first]), len(at_end[last])
        if sorted(degrees)[0] != 1 or sorted(degrees)[1] < 3:
            return np.inf, first, last
        junction, tip = (first, last) if degrees[1] == 1 else (last, first)
        return length[number] - radii[junction], junction, tip

    while True:
        limbs = [(*reach(number), number) for number in paths]
        far, junction, tip, number = min(limbs, default=(np.inf, 0, 0, 0))
        short = [(*limb[:3], limb[3]) for limb in limbs if limb[0] < LEAST_LIMB * radii[limb[1]]]
        if short:
            far, junction, tip, number = min(short)
        elif len(paths) <= most or far == np.inf:
            break
        gone = [node for node in paths.pop(number) if node != junction]
        target[gone] = junction
        at_end[junction].discard(number)
        del at_end[tip]
        if len(at_end[junction]) == 2:  # it is no longer a junction: its two branches become one
            a, b = sorted(at_end.pop(junction))
            one = paths[a] if paths[a][-1] == junction else paths[a][::-1]
            other = paths[b] if paths[b][0] == junction else paths[b][::-1]
            paths[a] = one + other[1:]
            length[a] += length[b]
            del paths[b]
            for end in {paths[a][0], paths[a][-1]}:
                at_end[end] = (at_end[end] - {b}) | {a}
    while (target[target] != target).any():
        target = target[target]
    return target == np.arange(len(vertices)), target


def _paths(
    vertices: np.ndarray, edges: np.ndarray, radii: np.ndarray, stays: np.ndarray, most: int
) -> tuple[list[int], list[_BonePath]]:
    """The root of each component, and the branches directed away from it, those nearer to it first."""
    num = len(vertices)
    degree = np.bincount(edges.ravel(), minlength=num)
    label = graphs.labels(num, *edges.T)
    size = np.where(stays, radii, -1.0)
    order = np.lexsort((-size, -(degree > 2).astype(int)))  # junctions before others, the thickest first
    order = order[stays[order]]
    roots = order[np.sort(np.unique(label[order], return_index=True)[1])]
    length = np.bincount(label[edges[:, 0]], np.linalg.norm(np.diff(vertices[edges], axis=1)[:, 0], axis=1), num)
    roots = roots[np.argsort(-length[label[roots]], kind="stable")]
    beside = nx.Graph()
    beside.add_nodes_from(np.flatnonzero(stays).tolist())
    beside.add_edges_from(edges.tolist())
    is_end = (degree != 2) & stays
    is_end[roots] = True
    chosen: list[int] = []
    paths: list[_BonePath] = []
    for root in roots.tolist():
        if len(chosen) + len(paths) + 1 + beside.degree[root] > most and chosen:
            break
        chosen.append(root)
        queue = [(root, -1, -1)]
        for node, before, above in queue:
            for onward in sorted(beside[node]):
                if onward == before:
                    continue
                nodes = [node, onward]
                while not is_end[nodes[-1]]:
                    nodes.append(next(other for other in sorted(beside[nodes[-1]]) if other != nodes[-2]))
                along = arc_length(vertices[nodes])
                is_limb = degree[nodes[-1]] == 1
                start = min(radii[node], LEAVES * along[-1])
                if not is_limb and along[-1] - start < SHORTEST * np.percentile(radii[nodes], USUAL):
                    start = along[-1]  # the junctions are too close for a bone between them
                paths.append(_BonePath(np.array(nodes), along, float(start), above, is_limb))
                queue.append((nodes[-1], nodes[-2], len(paths) - 1))
    return chosen, paths


def _cuts(vertices: np.ndarray, radii: np.ndarray, paths: list[_BonePath], most: int) -> list[np.ndarray]:
    """For each branch the arc lengths where its bones begin, and where the last ends.

    The longest bone that is too bent or too long is cut, until there is none or there are ``most`` bones.
    """
    cuts = [[path.start, path.along[-1]] if path.start < path.along[-1] else [path.along[-1]] for path in paths]
    left = most - sum(len(stops) - 1 for stops in cuts)
    heap: list[tuple[float, int, float, float, float]] = []

    def consider(number: int, begin: float, end: float) -> None:
        badness, where = _bend(vertices, radii, paths[number], begin, end)
        if badness > 1:
            heapq.heappush(heap, (begin - end, number, begin, end, where))

    for number, stops in enumerate(cuts):
        if len(stops) > 1:
            consider(number, *stops)
    while heap and left > 0:
        _, number, begin, end, where = heapq.heappop(heap)
        cuts[number] = sorted([*cuts[number], where])
        left -= 1
        consider(number, begin, where)
        consider(number, where, end)
    return [np.array(stops) for stops in cuts]


def _bend(vertices: np.ndarray, radii: np.ndarray, path: _BonePath, begin: float, end: float) -> tuple[float, float]:
    """The badness of one bone for a piece of a branch, which should be at most 1, and the arc length to cut it at."""
    inner = (path.along > begin) & (path.along < end)
    stops = np.r_[begin, path.along[inner], end]
    points = at(vertices[path.nodes], path.along, stops)
    size = np.interp(stops, path.along, radii[path.nodes])
    radius = max(float(np.percentile(size, USUAL)), 1e-12)
    is_free = (stops - begin >= SHORTEST * radius) & (end - stops >= SHORTEST * radius)
    if not is_free.any():
        return 0.0, 0.0
    chord = points[-1] - points[0]
    t = np.clip((points - points[0]) @ chord / max(float(chord @ chord), 1e-300), 0, 1)
    off = np.where(is_free, np.linalg.norm(points - points[0] - t[:, None] * chord, axis=1), -1.0)
    worst = int(off.argmax())
    bend, length = off[worst] / (BENT * radius), (end - begin) / (LONG * radius)
    if bend >= min(length, 1.0):
        return float(max(bend, length)), float(stops[worst])
    return float(length), (begin + end) / 2
