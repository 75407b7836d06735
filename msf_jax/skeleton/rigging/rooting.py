"""The root of a rig, and the branches of the curve directed away from it, paired left and right.

The root is the pelvis, see `girdles`. Without one it is the thickest girdle, or the thickest junction.
"""

from typing import NamedTuple

import networkx as nx
import numpy as np

from msf_jax.skeleton.rigging.girdles import BodyGirdles
from msf_jax.skeleton.rigging.mirror import ALIKE, Mirror, images
from msf_jax.solid.geometry import arc_length, at
from msf_jax.topology import graphs

SHORTEST = 1.0  # radii: the least length of a bone after a cut, and of one between two junctions
USUAL = 75  # percentile of the radii along a bone that counts as the bone's radius
LEAVES = 0.6  # share of a branch's length that the ball at its start may cover, at most
EXACT = 0.006  # diagonals: mean distance of a tip from its image, at most, if joints are moved to be symmetric
SPINE = 0.4  # share of the way from the hips to the arms where the spine's first joint is: the second of five steps
PELVIS = 0.2  # the same for the root's joint


class BonePath(NamedTuple):
    """A branch directed away from the root.

    nodes: (n,) from the junction on. part: (n,) the place of each node on the line: 0 at its start, 1 at its end, and
    negative within the ball of the junction. stops: (m,) places from 0 to 1, line: (m, 3) its points there, and size:
    (m,) the radii. begin: the place of the first joint. is_limb: whether it ends in a tip.
    image: the path that is its mirror image, -1 without one.
    side: 1 on the left, -1 on the right, 0 else. is_spine: from the pelvis towards the shoulders.
    """

    nodes: np.ndarray
    part: np.ndarray
    stops: np.ndarray
    line: np.ndarray
    size: np.ndarray
    begin: float
    is_limb: bool
    image: int = -1
    side: int = 0
    is_spine: bool = False


class Root(NamedTuple):
    """node: of the curve. joint, tail: (3,) of its bone."""

    node: int
    joint: np.ndarray
    tail: np.ndarray


def paths_of(
    vertices: np.ndarray,
    edges: np.ndarray,
    radii: np.ndarray,
    stays: np.ndarray,
    most: int,
    plane: Mirror | None,
    body: BodyGirdles,
) -> tuple[list[Root], list[BonePath]]:
    """The root of each component, and the branches directed away from it, each after the one that it begins at; else
    those first beyond which is the tip that is farthest from all tips."""
    num = len(vertices)
    degree = np.bincount(edges.ravel(), minlength=num)
    label = graphs.labels(num, *edges.T)
    size = np.where(stays, radii, -1.0)
    tree = nx.Graph()
    tree.add_nodes_from(np.flatnonzero(stays).tolist())
    tree.add_edges_from(edges.tolist())
    tips = np.flatnonzero(stays & (degree == 1))
    rank = (degree > 2).astype(int)
    rank[body.girdles] = 2
    if body.pelvis is not None:
        rank[body.pelvis] = 3
    order = np.lexsort((-size, -rank))
    order = order[stays[order]]
    roots = order[np.sort(np.unique(label[order], return_index=True)[1])]
    length = np.bincount(label[edges[:, 0]], np.linalg.norm(np.diff(vertices[edges], axis=1)[:, 0], axis=1), num)
    roots = roots[np.argsort(-length[label[roots]], kind="stable")]
    is_end = (degree != 2) & stays
    is_end[roots] = True
    chosen: list[int] = []
    paths: list[BonePath] = []
    for root in roots.tolist():
        if len(chosen) + len(paths) + 1 + tree.degree[root] > most and chosen:
            break
        chosen.append(root)
        own = len(paths)
        rank_of = _by_tips(vertices, tree, root, tips)
        queue = [(root, -1)]
        for node, before in queue:
            for onward in sorted(set(tree[node]) - {before}, key=lambda each: (-rank_of[each], each)):
                nodes = [node, onward]
                while not is_end[nodes[-1]]:
                    nodes.append(next(other for other in sorted(tree[nodes[-1]]) if other != nodes[-2]))
                paths.append(_path(vertices, radii, np.array(nodes), bool(degree[nodes[-1]] == 1)))
                queue.append((nodes[-1], nodes[-2]))
        paths[own:] = sorted(paths[own:], key=lambda path: -rank_of[int(path.nodes[-1])])
    if plane is not None:
        paths = _paired(vertices, paths, plane)
    return [_rooted(vertices, radii, paths, root, plane, root == body.pelvis) for root in chosen], paths


def _path(vertices: np.ndarray, radii: np.ndarray, nodes: np.ndarray, is_limb: bool) -> BonePath:
    along = arc_length(vertices[nodes])
    start = min(float(radii[nodes[0]]), LEAVES * float(along[-1]))
    part = (along - start) / max(float(along[-1]) - start, 1e-300)
    stops = np.r_[0.0, part[(part > 0) & (part < 1)], 1.0]
    line = at(vertices[nodes], part, stops)
    return BonePath(nodes, part, stops, line, np.interp(stops, part, radii[nodes]), 0.0, is_limb)


def _by_tips(vertices: np.ndarray, tree: nx.Graph, root: int, tips: np.ndarray) -> dict[int, float]:
    """For each node the largest sum of distances from a tip beyond it to all tips: an order of branches that does not
    change with the numbers of nodes, nor much with the places of junctions."""
    apart = {int(tip): float(np.linalg.norm(vertices[tips] - vertices[tip], axis=1).sum()) for tip in tips}
    found: dict[int, float] = {}
    for node in nx.dfs_postorder_nodes(tree, root):
        found[node] = max([apart.get(node, 0.0), *(found[other] for other in tree[node] if other in found)])
    return found


def _paired(vertices: np.ndarray, paths: list[BonePath], plane: Mirror) -> list[BonePath]:
    """The paths with their images; each has the mean of its line and its image's, if the shape is as symmetric."""
    ends = np.array([path.nodes[-1] for path in paths], dtype=np.int64)
    image = _images(vertices, paths, plane)
    tips = [k for k in np.flatnonzero(image >= 0) if paths[k].is_limb and paths[image[k]].is_limb]
    away = np.linalg.norm(vertices[ends[tips]] - plane.flipped(vertices[ends[image[tips]]]), axis=1)
    is_exact = len(tips) > 0 and bool(np.mean(away) < EXACT * plane.size)
    found = []
    for number, (path, other) in enumerate(zip(paths, image.tolist(), strict=True)):
        if other < 0:
            found.append(path)
            continue
        twin = paths[other]
        stops = np.union1d(path.stops, twin.stops)
        own, mirrored = at(path.line, path.stops, stops), plane.flipped(at(twin.line, twin.stops, stops))
        size = (np.interp(stops, path.stops, path.size) + np.interp(stops, twin.stops, twin.size)) / 2
        if (
            is_exact and (np.linalg.norm(own - mirrored, axis=1) / 2 < size).all()
        ):  # else a bent arm beside a straight one
            own = (own + mirrored) / 2
        side = 0 if other == number else int(np.sign(plane.height(vertices[ends[number]]))) or 1
        image_of = -1 if other == number else other
        is_limb = path.is_limb or twin.is_limb  # an arm, though the curve has fingers on one side only
        found.append(path._replace(stops=stops, line=own, size=size, is_limb=is_limb, image=image_of, side=side))
    return found


def _images(vertices: np.ndarray, paths: list[BonePath], plane: Mirror) -> np.ndarray:
    """(P,) the mirror image of each path: beyond it are the images of the tips beyond the path, and of several such it
    is the one that begins nearest to the image of its beginning; -1 if none begins near it.

    Tips are where the shape has them. At which of some junctions near each other a finger begins is chance.
    """
    leaves = np.array([path.nodes[-1] for path in paths if path.is_limb], dtype=np.int64)
    partner = images(plane, vertices[leaves])
    twin = {int(tip): int(leaves[k]) for tip, k in zip(leaves, partner, strict=True) if k >= 0}
    at_node: dict[int, frozenset[int]] = {}  # the tips with an image beyond each node
    beyond = [frozenset[int]()] * len(paths)
    for number in range(len(paths) - 1, -1, -1):
        start, end = int(paths[number].nodes[0]), int(paths[number].nodes[-1])
        beyond[number] = at_node.get(end, frozenset()) | (twin.keys() & {end})
        at_node[start] = at_node.get(start, frozenset()) | beyond[number]
    alike: dict[frozenset[int], list[int]] = {}
    for number, tips in enumerate(beyond):
        alike.setdefault(tips, []).append(number)
    starts = vertices[[int(path.nodes[0]) for path in paths]] if paths else np.empty((0, 3))
    image = np.full(len(paths), -1)
    for number, tips in enumerate(beyond):
        others = alike.get(frozenset(twin[tip] for tip in tips), []) if tips else []
        away = np.linalg.norm(starts[others] - plane.flipped(starts[number]), axis=1)
        if away.min(initial=np.inf) < ALIKE * plane.size:
            image[number] = others[int(away.argmin())]
    return np.where(image[image] == np.arange(len(paths)), image, -1)


def _rooted(
    vertices: np.ndarray, radii: np.ndarray, paths: list[BonePath], node: int, plane: Mirror | None, is_pelvis: bool
) -> Root:
    """The bone of a root, along the spine or the longest branch. The spine is put into ``paths``."""
    first = [number for number, path in enumerate(paths) if path.nodes[0] == node]
    joint = vertices[node]
    trunks = [number for number in first if not (paths[number].is_limb or paths[number].side)]
    hips = [paths[number].line[0] for number in first if paths[number].side]
    if is_pelvis and plane is not None and len(trunks) == 1 and len(hips) >= 2:
        number = trunks[0]
        nodes = paths[number].nodes
        line = np.vstack([plane.dropped(np.mean(hips, axis=0)), plane.dropped(vertices[nodes])])
        stops = arc_length(line)
        stops /= stops[-1]
        size = np.r_[radii[node], radii[nodes]]
        joint, tail = at(line, stops, np.array([PELVIS, SPINE]))
        paths[number] = paths[number]._replace(
            part=stops[1:], stops=stops, line=line, size=size, begin=SPINE, is_spine=True
        )
        return Root(node, joint, tail)
    longest = max(first, key=lambda number: _length(paths[number]), default=None)
    return Root(node, joint, joint if longest is None else paths[longest].line[0])


def _length(path: BonePath) -> float:
    return float(np.linalg.norm(np.diff(path.line, axis=0), axis=1).sum())
