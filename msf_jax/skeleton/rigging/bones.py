"""Bones from a curve: the joints, the parent of each bone, and its part of the curve.

A bone begins at its joint, about which it turns. The root's joint is at the pelvis or the thickest junction; its part
of the curve is inside the ball there. Each branch at a junction begins with its own joint, where it leaves the
junction's ball, as an arm leaves a shoulder. So each limb turns on its own. A branch has more bones where it bends
most, or where it is long. In a shape with a mirror plane both sides have the same joints and cuts: those of the mean of
a branch and its mirror image.
"""

from itertools import pairwise
from typing import Any, NamedTuple

import networkx as nx
import numpy as np

from msf_jax.curve import branches
from msf_jax.skeleton.centrelines import direct_paths
from msf_jax.skeleton.rigging import body, cutting
from msf_jax.skeleton.rigging.body import ALIKE, Girdles, Mirror
from msf_jax.skeleton.rigging.cutting import BonePath
from msf_jax.solid.geometry import arc_length, at
from msf_jax.topology import graphs

LEAST_LIMB = 0.6  # radii of the junction's ball: a limb that sticks out of the ball by less has no bone
FOR_LIMBS = 0.6  # share of all bones for the first bones of branches, at most; the rest is for bends
LEAVES = 0.6  # share of a branch's length that the ball at its start may cover, at most
EXACT = 0.006  # diagonals: mean distance of a tip from its image, at most, if joints are moved to be symmetric
SPINE = 0.4  # share of the way from the hips to the arms where the spine's first joint is: the second of five steps
PELVIS = 0.2  # the same for the root's joint
SIDE_SUFFIXES = {1: ".L", -1: ".R", 0: ""}


class BoneRoot(NamedTuple):
    """node: of the curve. joint, tail: (3,) of its bone."""

    node: int
    joint: np.ndarray
    tail: np.ndarray


class CutCurve(NamedTuple):
    """What bones are made of: roots, branches away from them, parents first, and the places where each branch is cut.

    vertices: (N, 3). target: (N,) the node that stands for each; those that stand for themselves are part of a branch,
    or of a component without a bone.
    """

    roots: list[BoneRoot]
    paths: list[BonePath]
    cuts: list[list[float]]
    biped: body.BipedPlan | None
    vertices: np.ndarray
    target: np.ndarray


class Bones(NamedTuple):
    """B bones, parents before children.

    joints: (B, 3) the start of each, about which it turns. tails: (B, 3) the end. parents: (B,) -1 for a root. branch:
    (B,) the branch of the curve, -1 for a root. place: (B,) the position along the branch, from 0. is_limb: (B,)
    whether the branch ends in a tip. side: (B,) 1 on the left, -1 on the right, and 0 without a mirror image.
    is_spine: (B,) whether it is of a spine. role: (B,) of a biped's bone, see `body.NAMES`, or "". twin: (B,) the bone
    that is the mirror image, -1 without one. of_node: (N,) the bone of every node of the curve.
    """

    joints: np.ndarray
    tails: np.ndarray
    parents: np.ndarray
    branch: np.ndarray
    place: np.ndarray
    is_limb: np.ndarray
    side: np.ndarray
    is_spine: np.ndarray
    role: np.ndarray
    twin: np.ndarray
    of_node: np.ndarray
    curve: CutCurve

    @property
    def is_needed(self) -> np.ndarray:
        """(B,) roots, and bones of a spine or with a role of a biped."""
        return (self.parents < 0) | self.is_spine | (self.role != "")

    def names(self, standard: str | None = None) -> tuple[str, ...]:
        """A unique name for each bone; those of a biped as in ``standard``, one of `body.STANDARDS`.

        ``root``; ``trunk2_1`` for the first bone of the second branch between two junctions; ``limb5_3.L`` for the
        third bone of the fifth branch that ends in a tip. The first are those that lead to the tips farthest from all
        others, as the place of a tip hardly depends on how the curve was made. Two branches that are mirror images have
        the same number, with ``.L`` and ``.R``, by which Blender finds the other side.
        """
        number: dict[int, int] = {}  # of each branch; its mirror image has the same
        names, roots, count = [], int((self.parents < 0).sum()), {"limb": 0, "trunk": 0}
        for bone, branch in enumerate(self.branch.tolist()):
            side, role = int(self.side[bone]), str(self.role[bone])
            kind = "limb" if self.is_limb[bone] else "trunk"
            if standard and role:
                k = body.STANDARDS.index(standard)
                names.append(body.NAMES[role][k].format(body.SIDE_NAMES[side][k]))
            elif branch < 0:
                names.append("root" if roots == 1 else f"root{bone + 1}")
            else:
                if branch not in number:
                    count[kind] += 1
                    number[branch] = count[kind]
                    if self.twin[bone] >= 0:
                        number[int(self.branch[self.twin[bone]])] = count[kind]
                names.append(f"{kind}{number[branch]}_{self.place[bone] + 1}{SIDE_SUFFIXES[side]}")
        return tuple(names)

    def without(self, gone: set[int]) -> tuple["Bones", np.ndarray]:
        """The bones without those ``gone``, no roots, and the new number (B,) of every old bone, or of its heir.

        The first bone of a branch is joined to the next one of the branch, so that the branch still begins at its root.
        Another one is joined to its parent.
        """
        cuts, heir = [list(stops) for stops in self.curve.cuts], np.arange(len(self.parents))
        for bone in sorted(gone, reverse=True):
            stops, place = cuts[self.branch[bone]], int(self.place[bone])
            is_first = place == 0 and len(stops) > 2
            heir[bone] = heir[bone + 1] if is_first else self.parents[bone]
            del stops[1 if is_first else place]
        rank = np.cumsum(heir == np.arange(len(heir))) - 1
        while (heir != heir[heir]).any():
            heir = heir[heir]
        return lay_bones(self.curve._replace(cuts=cuts)), rank[heir]


def bones_of(
    vertices: np.ndarray,
    edges: np.ndarray,
    radii: np.ndarray,
    most: int,
    size: np.ndarray | None = None,
    held: np.ndarray | None = None,
    for_limbs: float = FOR_LIMBS,
    fill: bool = False,
    is_biped: bool = False,
) -> Bones:
    """At most ``most`` bones for a curve ``(vertices (N, 3), edges (E, 2))`` with balls of ``radii`` (N,). If there are
    too many components, the longest have bones.

    Args:
        size: (N,) of the limbs; the radii unless given.
        held: (N,) the number of the mesh's vertices at each node; any number unless given.
        for_limbs: the share of ``most`` for the first bones of branches, at most.
        fill: as many bones as there is length for, up to ``most``, also where nothing is bent or long.
        is_biped: whether the joints are those of a biped.

    Raises:
        ConfigError: a biped was asked for, and this is none.
    """
    size = radii if size is None else size
    held = np.full(len(vertices), cutting.FEWEST_HELD) if held is None else held
    tips = np.flatnonzero(graphs.degrees(len(vertices), edges) == 1)  # without those that cuts make
    edges = edges[branches.cut_loops(len(vertices), edges, size)]
    plane = body.find_mirror(vertices, edges, tips)
    girdles = body.find_girdles(vertices, edges, radii, tips, plane)
    forest = nx.Graph()  # the branches, each with its nodes
    for nodes in graphs.trace(len(vertices), edges):
        forest.add_edge(nodes[0], nodes[-1], nodes=nodes) if len(nodes) > 1 else forest.add_node(nodes[0])
    target = np.arange(len(vertices))
    _remove_limbs(forest, target, vertices, radii, max(1, int(for_limbs * most)), plane)
    stay = [node for node in girdles.nodes if target[node] == node]
    vertices, size = _join_junctions(forest, target, vertices, size, radii, plane, girdles)
    girdles = girdles._replace(nodes=[int(target[node]) for node in stay])
    roots, paths = _root_paths(forest, vertices, size, most, plane, girdles)
    biped = body.plan_biped(paths, girdles, plane, len(roots)) if is_biped else None
    cuts = cutting.cut_paths(paths, most - len(roots), held, fill, biped.stops if biped else {})
    bones = lay_bones(CutCurve(roots, paths, cuts, biped, vertices, target))
    while len(bones.joints) > most:  # a junction of more limbs than that
        length = np.linalg.norm(bones.tails - bones.joints, axis=1)
        bones = bones.without({int(np.where((bones.parents < 0) | (bones.role != ""), np.inf, length).argmin())})[0]
    return bones


def lay_bones(curve: CutCurve) -> Bones:
    """The bones of the pieces into which branches are cut."""
    roots, paths, cuts, biped, vertices, target = curve
    rows: list[tuple[Any, ...]] = []
    of_node, last, first_of = np.full(len(vertices), -1), {}, []
    for number, root in enumerate(roots):
        role = "hips" if biped and number == 0 else ""
        rows.append((root.joint, root.tail, -1, -1, 0, False, 0, False, role))
        of_node[root.node] = last[root.node] = number  # the last bone of the branch that ends in a node
    for number, (path, stops) in enumerate(zip(paths, cuts, strict=True)):
        above = last[int(path.nodes[0])]
        first_of.append(len(rows))
        ends, side = at(path.line, path.stops, np.array(stops)), -path.side if biped and biped.is_swapped else path.side
        for k in range(len(stops) - 1):
            role = biped.roles[number][k] if biped and number in biped.roles else ""
            parent = above if k == 0 else len(rows) - 1
            rows.append((ends[k], ends[k + 1], parent, number, k, path.is_limb, side, path.is_spine, role))
        piece = np.minimum(np.searchsorted(stops, path.part, side="right"), len(stops) - 1) - 1
        own = np.where(piece < 0, above, first_of[-1] + piece)
        of_node[path.nodes[1:]] = own[1:]
        last[int(path.nodes[-1])] = int(own[-1])
    columns = [np.array(column) for column in zip(*rows, strict=True)]
    twin = np.full(len(rows), -1)
    for bone, (branch, place) in enumerate(zip(*columns[3:5], strict=True)):
        image = paths[branch].image if branch >= 0 else -1
        if image >= 0 and place < len(cuts[image]) - 1:
            twin[bone] = first_of[image] + place
    known = np.flatnonzero(of_node >= 0)
    lost = np.flatnonzero((of_node < 0) & (target == np.arange(len(target))))  # of components without a bone
    for node in lost:
        of_node[node] = of_node[known[np.linalg.norm(vertices[node] - vertices[known], axis=1).argmin()]]
    return Bones._make([*columns, twin, of_node[target], curve])


def _nodes_from(forest: nx.Graph, start: int, end: int) -> list[int]:
    nodes = forest.edges[start, end]["nodes"]
    return nodes if nodes[0] == start else nodes[::-1]


def _remove_limbs(
    forest: nx.Graph, target: np.ndarray, vertices: np.ndarray, radii: np.ndarray, most: int, plane: Mirror | None
) -> None:
    """Remove limbs that are too short for a bone, then the shortest limbs until there are ``most`` branches. A limb's
    length counts from the ball at its junction; mirror images stay or go together. Its junction becomes the ``target``
    of its nodes."""
    for *_, branch in forest.edges(data=True):
        branch["length"] = arc_length(vertices[branch["nodes"]])[-1]

    def reach(tip: int) -> tuple[Any, Any]:
        """How far the limb of a tip sticks out of the ball at its junction, and the radius of that ball; infinite for a
        branch without a junction."""
        (junction,) = forest[tip]
        if forest.degree[junction] < 3:
            return np.inf, 0.0
        return forest.edges[tip, junction]["length"] - radii[junction], radii[junction]

    tips = [node for node in sorted(forest) if forest.degree[node] == 1]
    image = np.arange(len(tips)) if plane is None else plane.images(vertices[tips])
    pair = {tip: {tip, tips[k]} if k >= 0 else {tip} for tip, k in zip(tips, image.tolist(), strict=True)}
    while True:
        far = {tip: reach(tip) for tip in tips if tip in forest}
        mean = {tip: np.mean([far[each] for each in pair[tip] if each in far], axis=0) for tip in far}
        short = {tip: each for tip, each in mean.items() if each[0] < LEAST_LIMB * each[1]}
        if not short and forest.number_of_edges() + nx.number_of_isolates(forest) <= most:
            break
        least, tip = min(((float(each[0]), tip) for tip, each in (short or mean).items()), default=(np.inf, 0))
        if least == np.inf:
            break
        for each in (each for each in pair[tip] if each in forest and reach(each)[0] < np.inf):
            (junction,) = forest[each]
            target[_nodes_from(forest, each, junction)[:-1]] = junction
            forest.remove_node(each)
            if forest.degree[junction] == 2:  # it is no longer a junction: its two branches become one
                one, other = forest[junction]
                nodes = _nodes_from(forest, one, junction) + _nodes_from(forest, junction, other)[1:]
                length = forest.edges[one, junction]["length"] + forest.edges[junction, other]["length"]
                forest.remove_node(junction)
                forest.add_edge(one, other, nodes=nodes, length=length)
    while (target[target] != target).any():
        target[:] = target[target]


def _join_junctions(
    forest: nx.Graph,
    target: np.ndarray,
    vertices: np.ndarray,
    size: np.ndarray,
    radii: np.ndarray,
    plane: Mirror | None,
    girdles: Girdles,
) -> tuple[np.ndarray, np.ndarray]:
    """Join junctions with no length for a bone between them: how many of them a hand or a head has is chance.

    The pelvis and the shoulders stay where they are; others are joined in their middle, with their largest ``size``
    (N,). Mirror images stay or go together. Returns vertices and sizes.
    """
    of_place, vertices, size = vertices, vertices.copy(), size.copy()
    body_ends, joined = {girdles.pelvis, girdles.shoulders}, {node: {node} for node in forest}

    def between(nodes: list[int]) -> float:
        """The length of a branch outside the larger ball at its ends, over the least length of a bone."""
        length = float(arc_length(vertices[nodes])[-1])
        start = min(float(size[[nodes[0], nodes[-1]]].max()), LEAVES * length)
        return (length - start) / max(cutting.SHORTEST * float(np.percentile(radii[nodes], cutting.USUAL)), 1e-300)

    while True:
        trunks = [
            (one, other)
            for one, other in sorted(map(sorted, forest.edges))
            if min(forest.degree[one], forest.degree[other]) > 2 and not body_ends.issuperset((one, other))
        ]
        length = np.array([between(_nodes_from(forest, *trunk)) for trunk in trunks])
        if not (length < 1).any():
            return vertices, size
        first = int(length.argmin())
        middle = vertices[trunks].mean(axis=1)
        image = first if plane is None else int(plane.images(middle)[first])
        for trunk in {first, image} - {-1}:
            ends = [int(target[node]) for node in trunks[trunk]]
            own = next(
                (end for end in ends if end in body_ends), ends[0] if size[ends[0]] >= size[ends[1]] else ends[1]
            )
            other = ends[0] if own == ends[1] else ends[1]
            target[np.isin(target, [other, *_nodes_from(forest, own, other)[1:-1]])] = own
            size[own] = size[ends].max()
            joined[own] |= joined.pop(other)
            if own not in body_ends:
                vertices[own] = of_place[sorted(joined[own])].mean(axis=0)
            for beyond in set(forest[other]) - {own}:
                forest.add_edge(own, beyond, nodes=[own, *_nodes_from(forest, other, beyond)[1:]])
            forest.remove_node(other)


def _root_paths(
    forest: nx.Graph, vertices: np.ndarray, size: np.ndarray, most: int, plane: Mirror | None, girdles: Girdles
) -> tuple[list[BoneRoot], list[BonePath]]:
    """The root of each component, and the branches directed away from it, each after the one that it begins at; else
    those first beyond which is the tip that is farthest from all tips: an order that does not change with the numbers
    of nodes, nor much with the places of junctions. The root is the pelvis, or the thickest girdle or junction."""
    degree, tips = dict(forest.degree), [node for node in sorted(forest) if forest.degree[node] == 1]
    rank = {node: 1 for node in forest if degree[node] > 2} | dict.fromkeys(girdles.nodes, 2) | {girdles.pelvis: 3}
    value = {tip: float(np.linalg.norm(vertices[tips] - vertices[tip], axis=1).sum()) for tip in tips}
    pieces = []
    for ends in nx.connected_components(forest):
        own = [np.array(nodes) for *_, nodes in forest.subgraph(ends).edges(data="nodes")]
        nodes = np.unique(np.concatenate([sorted(ends), *own]))
        first = min(nodes.tolist(), key=lambda node: (-rank.get(node, 0), -size[node], node))
        length = sum(float(arc_length(vertices[nodes])[-1]) for nodes in own)
        pieces.append((-length, -rank.get(first, 0), -size[first], first, own))
    chosen: list[int] = []
    paths: list[BonePath] = []
    for *_, root, own in sorted(pieces, key=lambda piece: piece[:4]):
        stops = [[0, *(np.flatnonzero(nodes[1:-1] == root) + 1), len(nodes) - 1] for nodes in own]
        halves = [nodes[a : b + 1] for nodes, stop in zip(own, stops, strict=True) for a, b in pairwise(stop)]
        if len(chosen) + len(paths) + 1 + sum(root in half[[0, -1]] for half in halves) > most and chosen:
            break
        chosen.append(root)
        nodes, above = direct_paths(halves, [root])
        for number in reversed(above):
            start, end = int(nodes[number][0]), int(nodes[number][-1])
            value[start] = max(value.get(start, 0.0), value[end])
        nodes, above = direct_paths(sorted(nodes, key=lambda each: (-value[int(each[-1])], each[1])), [root])
        for number in sorted(above, key=lambda k: -value[int(nodes[k][-1])]):
            paths.append(_path_of(vertices, size, nodes[number], degree.get(int(nodes[number][-1])) == 1))
    paths = paths if plane is None else _pair_paths(vertices, paths, plane)
    return [_root_of(vertices, size, paths, root, plane, root == girdles.pelvis) for root in chosen], paths


def _path_of(vertices: np.ndarray, size: np.ndarray, nodes: np.ndarray, is_limb: bool) -> BonePath:
    along = arc_length(vertices[nodes])
    start = min(float(size[nodes[0]]), LEAVES * float(along[-1]))
    part = (along - start) / max(float(along[-1]) - start, 1e-300)
    stops = np.r_[0.0, part[(part > 0) & (part < 1)], 1.0]
    return BonePath(nodes, part, stops, at(vertices[nodes], part, stops), np.interp(stops, part, size[nodes]), is_limb)


def _pair_paths(vertices: np.ndarray, paths: list[BonePath], plane: Mirror) -> list[BonePath]:
    """The paths with their images; each has the mean of its line and its image's, if the shape is as symmetric."""
    ends = np.array([path.nodes[-1] for path in paths], dtype=np.int64)
    image = _find_images(vertices, paths, plane)
    tips = [k for k in np.flatnonzero(image >= 0) if paths[k].is_limb and paths[image[k]].is_limb]
    away = np.linalg.norm(vertices[ends[tips]] - plane.flipped(vertices[ends[image[tips]]]), axis=1)
    is_exact = len(tips) > 0 and bool(np.mean(away) < EXACT * plane.size)
    paired = list(paths)
    for number in np.flatnonzero(image >= 0).tolist():
        path, twin = paths[number], paths[image[number]]
        stops = np.union1d(path.stops, twin.stops)
        line, mirrored = at(path.line, path.stops, stops), plane.flipped(at(twin.line, twin.stops, stops))
        size = (np.interp(stops, path.stops, path.size) + np.interp(stops, twin.stops, twin.size)) / 2
        if is_exact and (np.linalg.norm(line - mirrored, axis=1) / 2 < size).all():
            line = (line + mirrored) / 2  # else a bent arm beside a straight one
        is_limb = path.is_limb or twin.is_limb  # an arm, though the curve has fingers on one side only
        path = path._replace(stops=stops, line=line, size=size, is_limb=is_limb)
        if image[number] != number:
            side = int(np.sign(plane.height(vertices[ends[number]]))) or 1
            path = path._replace(image=int(image[number]), side=side)
        paired[number] = path
    return paired


def _find_images(vertices: np.ndarray, paths: list[BonePath], plane: Mirror) -> np.ndarray:
    """(P,) the mirror image of each path: beyond it are the images of the tips beyond the path, and of several such it
    is the one that begins nearest to the image of its beginning; -1 if none begins near it.

    Tips are where the shape has them. At which of some junctions near each other a finger begins is chance.
    """
    leaves = np.array([path.nodes[-1] for path in paths if path.is_limb], dtype=np.int64)
    partner = plane.images(vertices[leaves])
    twin = {int(tip): int(leaves[k]) for tip, k in zip(leaves, partner, strict=True) if k >= 0}
    at_node: dict[int, frozenset[int]] = {}  # the tips with an image beyond each node
    alike: dict[frozenset[int], list[int]] = {}
    beyond = [frozenset[int]()] * len(paths)
    for number in range(len(paths) - 1, -1, -1):
        start, end = int(paths[number].nodes[0]), int(paths[number].nodes[-1])
        beyond[number] = at_node.get(end, frozenset()) | (twin.keys() & {end})
        at_node[start] = at_node.get(start, frozenset()) | beyond[number]
        alike.setdefault(beyond[number], []).insert(0, number)
    starts = vertices[np.array([path.nodes[0] for path in paths], dtype=np.int64)]
    image = np.full(len(paths), -1)
    for number, tips in enumerate(beyond):
        others = alike.get(frozenset(twin[tip] for tip in tips), []) if tips else []
        away = np.linalg.norm(starts[others] - plane.flipped(starts[number]), axis=1)
        if away.min(initial=np.inf) < ALIKE * plane.size:
            image[number] = others[int(away.argmin())]
    return np.where(image[image] == np.arange(len(paths)), image, -1)


def _root_of(
    vertices: np.ndarray, size: np.ndarray, paths: list[BonePath], node: int, plane: Mirror | None, is_pelvis: bool
) -> BoneRoot:
    """The bone of a root, along the spine or the longest branch. The spine is put into ``paths``."""
    first = [number for number, path in enumerate(paths) if path.nodes[0] == node]
    trunks = [number for number in first if not (paths[number].is_limb or paths[number].side)]
    hips = [paths[number].line[0] for number in first if paths[number].side]
    if is_pelvis and plane is not None and len(trunks) == 1 and len(hips) >= 2:
        nodes = paths[trunks[0]].nodes
        line = plane.flipped(np.vstack([np.mean(hips, axis=0), vertices[nodes]]), times=1.0)
        stops = arc_length(line)
        stops /= stops[-1]
        spine = {"part": stops[1:], "stops": stops, "line": line, "size": size[[node, *nodes]]}
        paths[trunks[0]] = paths[trunks[0]]._replace(**spine, begin=SPINE, is_spine=True)
        return BoneRoot(node, *at(line, stops, np.array([PELVIS, SPINE])))
    lines = [paths[number].line for number in first]
    longest = max(lines, key=lambda line: float(np.linalg.norm(np.diff(line, axis=0), axis=1).sum()), default=vertices)
    return BoneRoot(node, vertices[node], longest[0] if lines else vertices[node])
