"""Bones from a curve: the joints, the parent of each bone, and its part of the curve.

A bone begins at its joint, about which it turns. The root's joint is at the pelvis or the thickest junction; its part
of the curve is inside the ball there. Each branch at a junction begins with its own joint, where it leaves the
junction's ball, as an arm leaves a shoulder. So each limb turns on its own. A branch has more bones where it bends
most, or where it is long. In a shape with a mirror plane both sides have the same joints and cuts: those of the mean of
a branch and its mirror image.
"""

from itertools import pairwise
from typing import NamedTuple

import numpy as np
from scipy import spatial

from msf_jax.curve import branches
from msf_jax.skeleton.centrelines import direct_paths
from msf_jax.skeleton.rigging import body
from msf_jax.skeleton.rigging.body import LIMB, SHORTEST, STOPS, BonePath, Mirror, find_bend
from msf_jax.solid.geometry import arc_length, at
from msf_jax.topology import graphs

LONGEST_BONE = 6.0  # radii: a longer bone is cut
LEAVES = 0.6  # share of a branch's length that the ball at its start may cover, at most
EXACT = 0.006  # diagonals: mean distance of a tip from its image, at most, if joints are moved to be symmetric
SPINE = (0.2, 0.4, 0.6, 0.8, 1.0)  # shares of the way from the hips to the arms: the root's joint, and the spine's
SIDE_SUFFIXES = {1: ".L", -1: ".R", 0: ""}


class Bones(NamedTuple):
    """B bones, parents before children.

    joints: (B, 3) the start of each, about which it turns. tails: (B, 3) the end. parents: (B,) -1 for a root. names:
    of each. of_node: (N,) the bone of every node of the curve. notes: what is not known of a body.
    """

    joints: np.ndarray
    tails: np.ndarray
    parents: np.ndarray
    names: tuple[str, ...]
    of_node: np.ndarray
    notes: tuple[str, ...] = ()


def bones_of(
    vertices: np.ndarray, edges: np.ndarray, radii: np.ndarray, size: np.ndarray, standard: str | None = None
) -> Bones:
    """The bones of a curve ``(vertices (N, 3), edges (E, 2))`` with balls of ``radii`` (N,) in limbs of ``size`` (N,);
    with the joints and names of a biped if a ``standard`` of `body.STANDARDS` is given.

    Raises:
        ConfigError: a biped was asked for, and this is none.
    """
    num = len(vertices)
    tips = np.flatnonzero(graphs.degrees(num, edges) == 1)  # without those that cuts make
    edges = edges[branches.cut_loops(num, edges, size)]
    plane = body.find_mirror(vertices, edges, tips)
    girdles = body.find_girdles(vertices, edges, radii, tips, plane)
    vertices, edges, size, target = _contract_short(vertices, edges, radii, size, {girdles.pelvis, girdles.shoulders})
    pelvis, notes = girdles.pelvis, []
    if not girdles.is_sure:
        notes = ["limbs do not tell which end of the trunk is the pelvis: the other one is where a blunter limb begins"]
    rank = np.where(graphs.degrees(num, edges) > 2, 1, 0)  # of a root: the pelvis, then girdles, then junctions
    rank[target[girdles.nodes]] = 2
    rank[[pelvis] if pelvis >= 0 else []] = 3
    roots = branches.roots_of(num, edges, rank + size / (1 + size.max()), None)
    roots = [root for root in roots if target[root] == root]
    paths = _direct_paths(vertices, edges, size, roots, girdles.shoulders)
    if plane is not None:
        _pair_paths(vertices, paths, plane)
    starts = [_place_root(vertices, size, paths, root, plane if root == pelvis else None) for root in roots]
    for number, path in enumerate(paths):
        if not path.is_spine and not -1 < path.image < number:
            stops = _find_cuts(path, 0.0, 1.0, LIMB if path.side else LONGEST_BONE)
            for each in [path, *([paths[path.image]] if path.image >= 0 else [])]:
                each.cuts = (0.0, *stops, 1.0)
    if standard:
        notes += body.plan_biped(paths, girdles, plane, len(roots))
    return _lay_bones(roots, starts, paths, target, standard)._replace(notes=tuple(notes))


def _contract_short(
    vertices: np.ndarray, edges: np.ndarray, radii: np.ndarray, size: np.ndarray, stays: set[int]
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Contract limbs that are too short for a bone to their junctions, and then trunks without length for one, because
    how many junctions a hand or a head has is chance; the shortest first.

    The pelvis and the shoulders, the nodes of ``stays``, stay where they are. Other junctions of a trunk become one in
    their middle, of their largest size. Returns vertices (N, 3), edges, sizes (N,), and the node
    that stands for each (N,).
    """
    vertices, size, target = vertices.copy(), size.copy(), np.arange(len(vertices))
    count = np.ones(len(vertices))  # of junctions that became one
    while True:
        degree = graphs.degrees(len(vertices), edges)
        limbs, trunks = [], []  # the length over the least one of each, and its nodes
        for nodes in graphs.trace(len(vertices), edges):
            nodes = nodes if degree[nodes[-1]] > 1 else nodes[::-1]
            one, other, length = nodes[0], nodes[-1], float(arc_length(vertices[nodes])[-1])
            if degree[one] == 1 and degree[other] > 2:
                limbs.append(((length - radii[other]) / (body.LEAST_LIMB * radii[other]), nodes))
            elif min(degree[one], degree[other]) > 2 and not stays.issuperset((one, other)):
                out = length - min(max(size[one], size[other]), LEAVES * length)
                trunks.append((out / (SHORTEST * float(np.median(radii[nodes]))), nodes))
        for pieces in (limbs, trunks):
            share, nodes = min(pieces, default=(1.0, []))
            if share < 1:
                break
        else:
            return vertices, edges, size, target
        one, other = target[[nodes[0], nodes[-1]]].tolist()
        is_first = one in stays or (other not in stays and size[one] >= size[other])
        own, gone = (one, other) if pieces is trunks and is_first else (other, one)
        if pieces is trunks:
            size[own] = max(size[own], size[gone])
            if own not in stays:
                vertices[own] = np.average(vertices[[own, gone]], axis=0, weights=count[[own, gone]])
            count[own] += count[gone]
        target[np.isin(target, [*nodes, gone])] = own
        edges = target[edges]
        edges = edges[edges[:, 0] != edges[:, 1]]


def _direct_paths(
    vertices: np.ndarray, edges: np.ndarray, size: np.ndarray, roots: list[int], shoulders: int
) -> list[BonePath]:
    """The branches directed away from the ``roots``, each after the one that it begins at; else those first beyond
    which is the tip that is farthest from all tips: an order that does not change with the numbers of nodes, nor much
    with the places of junctions. The spine, from the pelvis to the ``shoulders`` (-1 for none), is one branch."""
    degree, traced = graphs.degrees(len(vertices), edges), graphs.trace(len(vertices), edges)
    nodes, above, _ = direct_paths((np.array(path) for path in traced if len(path) > 1), roots)
    tips = np.flatnonzero(degree == 1)
    value = dict(zip(tips.tolist(), spatial.distance.cdist(vertices[tips], vertices[tips]).sum(axis=1), strict=True))
    for number in reversed(above):
        start, end = int(nodes[number][0]), int(nodes[number][-1])
        value[start] = max(value.get(start, 0.0), value[end])
    order = sorted(above, key=lambda number: -value[int(nodes[number][-1])])
    spine, number = [], next((number for number in above if shoulders in nodes[number][1:]), -1)
    while number >= 0:
        spine, number = [number, *spine], above[number]
    if spine:
        nodes[spine[0]] = np.concatenate([nodes[number][min(k, 1) :] for k, number in enumerate(spine)])
    paths = []
    for number in (number for number in order if number not in spine[1:]):
        along = arc_length(vertices[nodes[number]])
        start = min(float(size[nodes[number][0]]), LEAVES * float(along[-1]))
        part = (along - start) / max(float(along[-1]) - start, 1e-300)
        line, thick = at(vertices[nodes[number]], part, STOPS), np.interp(STOPS, part, size[nodes[number]])
        is_limb = bool(degree[nodes[number][-1]] == 1)
        paths.append(BonePath(nodes[number], part, line, thick, is_limb, is_spine=number in spine))
    return paths


def _pair_paths(vertices: np.ndarray, paths: list[BonePath], plane: Mirror) -> None:
    """Give the ``paths`` their images: of tips that are images of each other, those on their ways from the root, which
    is itself as far as it is the same, and then in their order. Both have the mean of their lines, if the shape is as
    symmetric."""
    leads = {node: number for number, path in enumerate(paths) for node in path.nodes[1:].tolist()}
    ways: list[list[int]] = []
    for number, path in enumerate(paths):
        above = leads.get(int(path.nodes[0]), -1)
        ways.append([*(ways[above] if above >= 0 else []), number])
    tips = np.array([number for number, path in enumerate(paths) if path.is_limb], dtype=np.int64)
    ends = vertices[np.array([path.nodes[-1] for path in paths], dtype=np.int64)]
    match, image = plane.images(ends[tips]), np.full(len(paths), -1)
    for one, other in zip(tips[match >= 0].tolist(), tips[match[match >= 0]].tolist(), strict=True):
        way, twin_way = ways[one], ways[other]
        pairs = list(zip(way, twin_way, strict=False))
        if len(way) != len(twin_way):  # a palm that one side has not is nobody's image
            pairs = [*pairs[: max(len(pairs) - 1, 1)], (one, other)]
        for number, twin in pairs:
            if image[number] == image[twin] == -1:
                image[number], image[twin] = twin, number
    paired = tips[image[tips] >= 0]
    away = np.linalg.norm(ends[paired] - plane.flipped(ends[image[paired]]), axis=1)
    is_exact = len(paired) > 0 and bool(np.mean(away) < EXACT * plane.size)
    for number, other in enumerate(image.tolist()):
        if other < number:  # no image, or the pair is done
            continue
        path, twin = paths[number], paths[other]
        path.size = twin.size = (path.size + twin.size) / 2
        path.is_limb = twin.is_limb = path.is_limb or twin.is_limb  # an arm, though one side only has fingers
        mirrored = plane.flipped(twin.line)
        if is_exact and (np.linalg.norm(path.line - mirrored, axis=1) / 2 < path.size).all():
            path.line = (path.line + mirrored) / 2  # else a bent arm beside a straight one
            twin.line = plane.flipped(path.line) if other > number else path.line
        if other > number:
            path.image, twin.image = other, number
            path.side = int(np.sign(plane.height(ends[number]))) or 1
            twin.side = -path.side


def _place_root(
    vertices: np.ndarray, size: np.ndarray, paths: list[BonePath], root: int, plane: Mirror | None
) -> np.ndarray:
    """(2, 3) the joint and the tail of the bone of a root, along the spine or the longest branch. The ``plane`` is
    given for the pelvis; the spine then begins between the hips."""
    first = [path for path in paths if path.nodes[0] == root]
    if plane is not None:
        spine = next(path for path in first if path.is_spine)
        hips = [path.line[0] for path in first if path.side] or [vertices[root]]
        line = plane.flipped(np.vstack([np.mean(hips, axis=0), vertices[spine.nodes]]), times=1.0)
        part = arc_length(line) / arc_length(line)[-1]
        spine.part, spine.line = part[1:], at(line, part, STOPS)
        spine.size, spine.cuts = np.interp(STOPS, part, size[[root, *spine.nodes]]), SPINE[1:]
        return at(line, part, np.array(SPINE[:2]))
    lines = [vertices[[root, root]], *(path.line for path in first)]
    return np.stack([vertices[root], max(lines, key=lambda line: float(arc_length(line)[-1]))[0]])


def _find_cuts(path: BonePath, begin: float, end: float, long: float) -> list[float]:
    """The places where a piece of a branch is cut, and where these parts are, until no bone is too bent or too long."""
    badness, where = find_bend(path, begin, end, long)
    if badness <= 1:
        return []
    return [*_find_cuts(path, begin, where, LONGEST_BONE), where, *_find_cuts(path, where, end, LONGEST_BONE)]


def _lay_bones(
    roots: list[int], starts: list[np.ndarray], paths: list[BonePath], target: np.ndarray, standard: str | None
) -> Bones:
    """The bones of the roots, and of the pieces into which branches are cut, each with a name of its own.

    ``root``; ``trunk2_1`` for the first bone of the second branch between two junctions; ``limb5_3.L`` for the third
    bone of the fifth branch that ends in a tip. Two branches that are mirror images have the same number, with ``.L``
    and ``.R``, by which Blender finds the other side. A biped's bones have those of the ``standard``.
    """
    which = body.STANDARDS.index(standard) if standard else 0
    ends, parents = [*starts], [-1] * len(roots)
    names = ["root" if len(roots) == 1 else f"root{number}" for number in range(1, len(roots) + 1)]
    if standard:
        names[0] = body.NAMES["hips"][which]
    of_node, count, numbers = np.full(len(target), -1), {"limb": 0, "trunk": 0}, dict[int, int]()
    of_node[roots] = np.arange(len(roots))
    for number, path in enumerate(paths):
        kind, above, first = "limb" if path.is_limb else "trunk", int(of_node[path.nodes[0]]), len(parents)
        if number not in numbers:
            count[kind] += 1
            numbers |= {number: count[kind], path.image: count[kind]}
        joints = at(path.line, STOPS, np.array(path.cuts))
        for k, bone in enumerate(pairwise(joints)):
            ends.append(np.stack(bone))
            parents.append(above if k == 0 else len(parents) - 1)
            role = body.NAMES[path.roles[k]][which] if path.roles else ""
            own = f"{kind}{numbers[number]}_{k + 1}{SIDE_SUFFIXES[path.side]}"
            names.append(role.format(body.SIDE_NAMES[path.side][which]) or own)
        piece = np.minimum(np.searchsorted(path.cuts, path.part, side="right"), len(path.cuts) - 1) - 1
        of_node[path.nodes[1:]] = np.where(piece < 0, above, first + piece)[1:]
    joints, tails = np.stack(ends, axis=1)
    return Bones(joints, tails, np.array(parents), tuple(names), of_node[target])
