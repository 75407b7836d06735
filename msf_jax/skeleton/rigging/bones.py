"""Bones from a curve: the joints, the parent of each bone, and its part of the curve.

A bone turns about its joint, where it begins. The root's joint is at the pelvis or the thickest junction; its part of
the curve is inside the ball there. Each branch at a junction begins where it leaves the junction's ball, as an arm
leaves a shoulder, and has more bones where it bends most, or is long. In a shape with a mirror plane both sides have
the joints of the mean of a branch and its mirror image. Left is the side with the larger coordinate across the plane:
of a figure that looks along z with y up, as in glTF, or along -y with z up, as in Blender.

Girdles are where pairs of limbs meet the body: pelvis, shoulders, and often a head with ears or horns. The trunk lies
between the two neighbours whose connection is thickest at its narrowest place, since a neck is narrower than a trunk.
A trunk ends in a pair of legs, which go on from it, and in a head, see `find_girdles`. No direction in space decides.
Limbs that are across a trunk at both ends are the legs and the wings of a bird, or legs of a body that is no biped.
"""

from dataclasses import dataclass
from itertools import combinations, pairwise
from typing import NamedTuple

import networkx as nx
import numpy as np
from scipy import spatial

from msf_jax.base.errors import ConfigError
from msf_jax.skeleton import trees
from msf_jax.skeleton.centrelines import direct_paths
from msf_jax.solid.geometry import arc_length, at, to_segment, unit
from msf_jax.topology import graphs

ALIKE = 0.1  # diagonals of the curve: distance between a part's ends and those of its mirror image, at most
MATCHED = 0.04  # diagonals: distance of a mirrored node from the curve, at most, if it counts as matched
ENOUGH = 0.6  # share of the curve's length that has a mirror image in a symmetric shape, at least
LEAST_LIMB = 0.6  # radii of the junction's ball: a limb that sticks out of the ball by less has no bone
STANDARDS = ("mixamo", "vrm", "unreal")
# What a bone is: its name in each of the standards, with {} for the side.
NAMES = {
    "hips": ("mixamorig:Hips", "hips", "pelvis"),
    "spine": ("mixamorig:Spine", "spine", "spine_01"),
    "chest": ("mixamorig:Spine1", "chest", "spine_02"),
    "upper chest": ("mixamorig:Spine2", "upperChest", "spine_03"),
    "neck": ("mixamorig:Neck", "neck", "neck_01"),
    "head": ("mixamorig:Head", "head", "head"),
    "upper arm": ("mixamorig:{}Arm", "{}UpperArm", "upperarm_{}"),
    "lower arm": ("mixamorig:{}ForeArm", "{}LowerArm", "lowerarm_{}"),
    "hand": ("mixamorig:{}Hand", "{}Hand", "hand_{}"),
    "upper leg": ("mixamorig:{}UpLeg", "{}UpperLeg", "thigh_{}"),
    "lower leg": ("mixamorig:{}Leg", "{}LowerLeg", "calf_{}"),
    "foot": ("mixamorig:{}Foot", "{}Foot", "foot_{}"),
    "toes": ("mixamorig:{}ToeBase", "{}Toes", "ball_{}"),
}
SIDE_NAMES = {1: ("Left", "left", "l"), -1: ("Right", "right", "r"), 0: ("", "", "")}
STOPS = np.linspace(0.0, 1.0, 201)  # places along a branch where its line is known
BENT = 0.35  # radii: a bone's part of the curve is cut if it is farther than this from a straight line
LIMB = 3.0  # radii: a longer limb of a pair has a knee or an elbow
STRAIGHT = np.radians(15.0)  # a limb that turns by less is cut at the half of its length, where anatomy has the joint
ASTRIDE = np.radians(58.0)  # between legs and trunk, at most: bipeds had up to 47, animals on four legs from 69
NECK = 1 / 3  # share of the way from the shoulders to the top of the head, where the head turns
WRIST = 0.75, 0.87  # share of an arm, where the hand is part of it, and where it ends at the fingers' junction
LOWER = 0.55  # share of a leg: the ankle is below
ANKLE = 0.85  # share of a leg without a bend there
FEET = 0.05  # of a leg's length: feet that stand out by less do not tell where the front is
LONGEST_BONE = 6.0  # radii: a longer bone is cut
LEAVES = 0.6  # share of a branch's length that the ball at its start may cover, at most
EXACT = 0.006  # diagonals: mean distance of a tip from its image, at most, if joints are moved to be symmetric
SPINE = (0.2, 0.4, 0.6, 0.8, 1.0)  # shares of the way from the hips to the arms: the root's joint, and the spine's
SIDE_SUFFIXES = {1: ".L", -1: ".R", 0: ""}


@dataclass
class BonePath:
    """A branch directed away from the root. nodes: (n,) from the junction on. part: (n,) the place of each node on the
    line: 0 at its start, 1 at its end, and negative within the ball of the junction. line: (201, 3) its points at
    `STOPS`, and size: (201,) the limb's radii. is_limb: whether it ends in a tip. cuts: places where its bones begin,
    and where the last ends. image: the number of the path that is its mirror image, -1 without one. side: 1 on the
    left, -1 on the right, 0 else. roles: of its bones, if they are a biped's, see `NAMES`. is_spine: from the pelvis
    towards the shoulders."""

    nodes: np.ndarray
    part: np.ndarray
    line: np.ndarray
    size: np.ndarray
    is_limb: bool
    cuts: tuple[float, ...] = (0.0, 1.0)
    image: int = -1
    side: int = 0
    roles: tuple[str, ...] = ()
    is_spine: bool = False


def find_bend(path: BonePath, begin: float, end: float, long: float) -> tuple[float, float]:
    """The badness of one bone for a piece of a branch, which should be at most 1 and is 0 for one that is too short to
    be cut; and the place to cut it at. A piece of more than ``long`` radii is bad."""
    stops = np.r_[begin, STOPS[np.abs(2 * STOPS - begin - end) < end - begin], end]
    points = at(path.line, STOPS, stops)
    along = arc_length(points)
    length = float(along[-1])
    radius = max(float(np.interp(stops, STOPS, path.size).max()), 1e-12)
    if length < 2 * radius:
        return 0.0, 0.0
    is_free = (along >= radius) & (length - along >= radius)  # no bone is shorter
    off = np.where(is_free, to_segment(points, points[0], points[-1]), -1.0)
    worst = int(off.argmax())
    bent, excess = float(off[worst]) / (BENT * radius), length / (long * radius)
    # A chain of two equal bones that turns by an angle a is half its length times sin(a / 2) off its chord.
    is_bent = off[worst] > length / 2 * np.sin(STRAIGHT / 2) and bent >= min(excess, 1.0)
    where = float(stops[worst]) if is_bent else float(np.interp(length / 2, along, stops))
    return max(bent, excess), where


class Mirror(NamedTuple):
    """The plane of the points x with x . normal = offset. size: the diagonal of the curve."""

    normal: np.ndarray
    offset: float
    size: float

    def height(self, points: np.ndarray) -> np.ndarray:
        """(...,) the signed distance of points (..., 3) from the plane."""
        return points @ self.normal - self.offset

    def flipped(self, points: np.ndarray, times: float = 2.0) -> np.ndarray:
        """(..., 3) the mirror images of points (..., 3), or with 1 for ``times`` their feet on the plane."""
        return points - times * self.height(points)[..., None] * self.normal

    def images(self, points: np.ndarray) -> np.ndarray:
        """(P,) the mirror image of each of ``points`` (P, 3): the nearest to the mirrored one, if both say so and are
        within `ALIKE`; -1 without one. In the middle it is the point itself."""
        if not len(points):
            return np.empty(0, dtype=np.int64)
        away, image = map(np.asarray, spatial.KDTree(points).query(self.flipped(points)))
        return np.where((away < ALIKE * self.size) & (image[image] == np.arange(len(points))), image, -1)


def find_mirror(vertices: np.ndarray, edges: np.ndarray, tips: np.ndarray) -> Mirror | None:
    """The best mirror plane of a curve ``(vertices (N, 3), edges (E, 2))`` with ends ``tips`` (T,).

    Tried are planes across the coordinate axes, and across the principal axes of the curve. Each is moved to half-way
    between tips and their images, then to where it fits best, and counts by the length that has a mirror image; at
    least two tips must be each other's image."""
    if len(tips) < 2:
        return None
    used = np.unique(edges)
    points, tree = vertices[used], spatial.KDTree(vertices[used])
    weight = np.bincount(edges.ravel(), np.repeat(graphs.lengths(vertices, edges), 2), len(vertices))[used]
    weight /= weight.sum()
    size = float(np.linalg.norm(np.ptp(points, axis=0)))
    middle = weight @ points
    principal = np.linalg.eigh((points - middle).T @ ((points - middle) * weight[:, None]))[1].T
    best, plane = 0.0, None
    for normal in (*np.eye(3), *principal):
        tried = Mirror(normal, float(middle @ normal), size)
        image = tried.images(vertices[tips])
        is_other = (image >= 0) & (image != np.arange(len(tips)))
        if not is_other.any():
            continue
        halfway = (vertices[tips[is_other]] + vertices[tips[image[is_other]]]) / 2
        tried = tried._replace(offset=float(np.median(halfway @ normal)))
        for _ in range(30):  # more than most need
            # With q the point nearest to the mirror image of p, the sum of w |flip(p) - q|^2 is least where the normal
            # is the first eigenvector of the symmetric part of -sum w p q^T, about the means of p and q. Only the
            # better half counts, as a limb may be bent on one side, and the tips, without which nothing fixes a plane
            # through a straight trunk.
            away, match = tree.query(tried.flipped(points))
            order = np.argsort(away, kind="stable")
            half = away[order[np.searchsorted(np.cumsum(weight[order]), 0.5)]]
            share = weight * ((away <= half) | (np.isin(used, tips) & (away < MATCHED * size)))
            center, partner = share @ points / share.sum(), share @ points[match] / share.sum()
            moment = -((points - center) * share[:, None]).T @ (points[match] - partner)
            normal = np.linalg.eigh(moment + moment.T)[1][:, -1]
            normal = normal * np.sign(normal[np.abs(normal).argmax()])
            tried = Mirror(normal, float((center + partner) @ normal / 2), size)
        share = float(weight @ (tree.query(tried.flipped(points))[0] < MATCHED * size))
        if share > max(best, ENOUGH):
            best, plane = share, tried
    return plane


class Girdles(NamedTuple):
    """nodes: where pairs of limbs begin. pelvis and shoulders: the ends of the trunk, or -1. legs and arms: (2, 3) the
    directions of the longest limbs at these, on both sides of the plane. angle: between the legs and the way on from
    the trunk, in radians. is_sure: whether it is known which end is the pelvis."""

    nodes: list[int]
    pelvis: int = -1
    shoulders: int = -1
    legs: np.ndarray = np.zeros((2, 3))
    arms: np.ndarray = np.zeros((2, 3))
    angle: float = 0.0
    is_sure: bool = True


def find_girdles(
    vertices: np.ndarray, edges: np.ndarray, radii: np.ndarray, tips: np.ndarray, plane: Mirror | None
) -> Girdles:
    """The girdles of a tree ``(vertices (N, 3), edges (E, 2))`` in limbs of ``radii`` (N,) with ends ``tips``."""
    if plane is None:
        return Girdles([])
    tree, degree = nx.Graph(edges.tolist()), graphs.degrees(len(vertices), edges)
    pairs: list[tuple[float, int, list[int]]] = []  # the length, the girdle, the nodes from tip to tip
    image = plane.images(vertices[tips])
    for k in np.flatnonzero(image > np.arange(len(tips))):
        one, other = int(tips[k]), int(tips[image[k]])
        nodes = nx.shortest_path(tree, one, other) if nx.has_path(tree, one, other) else [one]
        off = np.where(degree[nodes] > 2, np.abs(plane.height(vertices[nodes])) - radii[nodes], np.inf)
        is_middle = off <= np.clip(off.min(), 0.0, MATCHED * plane.size)
        girdle = nodes[int(np.where(is_middle, radii[nodes], -1.0).argmax())]
        length = float(arc_length(vertices[nodes])[-1])
        if is_middle.any() and length > 2 * (1 + LEAST_LIMB) * radii[girdle]:
            pairs.append((length, girdle, nodes))
    nodes = sorted({girdle for _, girdle, _ in pairs})
    trunks: list[tuple[float, list[int]]] = []  # the least radius in the middle half, as a crotch is thin; the nodes
    for one, other in combinations(nodes, 2):
        trunk = nx.shortest_path(tree, one, other) if nx.has_path(tree, one, other) else []
        along = arc_length(vertices[trunk]) if trunk else np.zeros(1)
        if along[-1] > max(radii[one], radii[other]) and not set(nodes) & set(trunk[1:-1]):
            thick = np.interp(along[-1] * np.linspace(0.25, 0.75, len(STOPS)), along, radii[trunk])
            trunks.append((float(thick.min()), trunk))
    if not trunks:
        return Girdles(nodes)
    trunk = max(trunks)[1]
    own = {node for _, girdle, nodes in pairs if girdle in (trunk[0], trunk[-1]) for node in nodes} - set(trunk)
    rest = tree.copy()
    rest.remove_nodes_from(own)
    rest.remove_edges_from(pairwise(trunk))

    def describe_end(half: list[int], other: int) -> tuple[tuple, float, int, np.ndarray, float]:
        """What tells the end of a trunk, the first of its ``half``, larger at shoulders: whether its limbs do not go on
        where the trunk ends, the number of pairs beyond, whether a limb in the middle is, and whether limbs that do not
        go on are apart, as wings; the mean radius of the outer half of the limb in the middle, as a head is blunter
        than a tail; the end, and the directions and the angle of its longest limbs."""
        pair = np.array(max(pair for pair in pairs if pair[1] == half[0])[2])[[0, -1]]  # of the longest limbs
        limbs = unit(vertices[pair[np.argsort(plane.height(vertices[pair]))]] - vertices[half[0]])
        angle = between(limbs, unit(vertices[half[0]] - vertices[other]))
        beyond = {end: nodes for start in half for end, nodes in nx.single_source_shortest_path(rest, start).items()}
        count = sum(girdle in beyond and girdle != half[0] for _, girdle, _ in pairs)
        middle = max(beyond.values(), key=lambda nodes: float(arc_length(vertices[nodes])[-1]))
        along = arc_length(vertices[middle])
        is_out, is_wing = bool(along[-1] > (1 + LEAST_LIMB) * radii[middle[0]]), min(angle, between(*limbs)) > ASTRIDE
        thick = float(radii[middle][along >= along[-1] / 2].mean())
        return (angle > ASTRIDE, count, is_out, is_wing), thick, half[0], limbs, angle

    inner = len(trunk) // 2
    ends = describe_end(trunk[:inner], trunk[-1]), describe_end(trunk[: -inner - 1 : -1], trunk[0])
    (one, _, pelvis, legs, angle), (other, _, shoulders, arms, _) = sorted(ends, key=lambda end: end[:3])
    return Girdles(nodes, pelvis, shoulders, legs, arms, angle, one != other)


def between(one: np.ndarray, other: np.ndarray) -> float:
    """The mean angle between unit vectors (n, 3) and others, in radians."""
    return float(np.arccos(np.clip((one * other).sum(axis=-1), -1, 1)).mean())


def plan_biped(paths: list[BonePath], girdles: Girdles, plane: Mirror | None, num_pieces: int) -> list[str]:
    """Give the cuts and roles of a biped to the ``paths`` of a curve in ``num_pieces``, and its left to its left side.

    Returns what is not known of it.

    Raises:
        ConfigError: the shape is none; the message says why.
    """

    def refused(reason: str) -> ConfigError:
        apart = f"; the curve is in {num_pieces} pieces, and that of a biped in one" * (num_pieces > 1)
        return ConfigError(f"names are for bipeds, and this is none: {reason}{apart}: expected names=None")

    if plane is None:
        raise refused(f"no plane across its axes has mirror images of two ends and {ENOUGH:.0%} of its curve")
    if not girdles.nodes:
        raise refused("no pair of limbs are mirror images")
    if girdles.pelvis < 0:
        raise refused("all pairs of limbs begin at one place, and those of a biped at two ends of a trunk")
    if girdles.angle > ASTRIDE:
        angle = f"the limbs at its pelvis are at {np.degrees(girdles.angle):.0f} degrees to its trunk"
        if between(*girdles.legs) > ASTRIDE:
            raise refused(f"{angle}, to its two sides")
        if between(girdles.legs, girdles.arms) < ASTRIDE:
            raise refused(f"{angle}, and those at its shoulders go the same way, as on four legs")
    legs, arms = (_longest_pair(paths, node) for node in (girdles.pelvis, girdles.shoulders))
    upper = [path for path in paths if path.nodes[0] == girdles.shoulders and not path.side]
    spine = next((path for path in paths if path.is_spine), None)
    if spine is None or not legs or not arms or not upper:
        part = "legs" if spine is None or not legs else "arms" if not arms else "neck and head"
        raise refused(f"there are no {part}")
    down = unit(spine.line[0] - spine.line[-1])
    wrist, has_toes = WRIST[0 if arms[0].is_limb else 1], legs[0].is_limb
    ankle = float(np.mean([_find_ankle(leg) for leg in legs]))
    elbow, knee = (
        where if 0.2 * end < (where := find_bend(limb, 0.0, end, LIMB)[1]) < 0.8 * end else end / 2
        for limb, end in ((arms[0], wrist), (legs[0], ankle))
    )
    neck = max(upper, key=lambda path: float(path.size.mean()))
    spine.roles = "spine", "chest", "upper chest"
    neck.cuts, neck.roles = (0.0, NECK, 1.0), ("neck", "head")
    for arm in arms:
        arm.cuts, arm.roles = (0.0, elbow, wrist, 1.0), ("upper arm", "lower arm", "hand")
    for leg in legs:
        leg.cuts, leg.roles = (0.0, knee, ankle, 1.0), ("upper leg", "lower leg", "foot")
        if has_toes:
            leg.cuts, leg.roles = (0.0, knee, ankle, (1 + ankle) / 2, 1.0), (*leg.roles, "toes")
    foot = np.mean([leg.line[-1] - at(leg.line, STOPS, np.array([ankle]))[0] for leg in legs], axis=0)
    front = foot - (foot @ down) * down
    left = np.cross(-down, front) @ plane.normal  # the left of a figure that looks to the front
    least = FEET * arc_length(legs[0].line)[-1]
    if left < -least:
        for path in paths:
            path.side *= -1
    return [] if abs(left) > least else ["which side is the left is not known, as feet do not stand out to the front"]


def _longest_pair(paths: list[BonePath], node: int) -> list[BonePath]:
    """The pair of branches that begins at a node and has the farthest tip beyond; empty if there is none, or if it ends
    before the lower part of its limbs, which fork there."""
    reach: dict[int, float] = {}  # from each node to the farthest tip beyond
    first, longest = None, 0.0
    for path in reversed(paths):
        length = float(arc_length(path.line)[-1])
        whole = length + reach.get(int(path.nodes[-1]), 0.0)
        reach[int(path.nodes[0])] = max(reach.get(int(path.nodes[0]), 0.0), whole)
        if path.nodes[0] == node and path.image >= 0 and whole > longest:
            first, longest = (path if length > LOWER * whole else None), whole
    return [] if first is None else [first, paths[first.image]]


def _find_ankle(path: BonePath) -> float:
    """The place where the lower part of a leg bends most, or `ANKLE`."""
    _, where = find_bend(path, LOWER, 1.0, LIMB)
    one, other = unit(np.diff(at(path.line, STOPS, np.array([LOWER, where, 1.0])), axis=0))
    return where if between(one, other) > STRAIGHT and LOWER < where < 0.95 else ANKLE


class Bones(NamedTuple):
    """B bones, parents before children. joints: (B, 3) the start of each, about which it turns. tails: (B, 3) the end.
    parents: (B,) -1 for a root. names: of each. of_node: (N,) the bone of every node of the curve. notes: what is not
    known of a body."""

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
    with the joints and names of a biped if a ``standard`` of `STANDARDS` is given.

    Raises:
        ConfigError: a biped was asked for, and this is none.
    """
    num = len(vertices)
    tips = np.flatnonzero(graphs.degrees(num, edges) == 1)  # without those that cuts make
    edges = edges[trees.cut_loops(num, edges, size)]
    plane = find_mirror(vertices, edges, tips)
    girdles = find_girdles(vertices, edges, radii, tips, plane)
    vertices, edges, size, target = _contract_short(vertices, edges, radii, size, {girdles.pelvis, girdles.shoulders})
    pelvis, notes = girdles.pelvis, []
    if not girdles.is_sure:
        notes = ["limbs do not tell which end of the trunk is the pelvis: the other one is where a blunter limb begins"]
    rank = np.where(graphs.degrees(num, edges) > 2, 1, 0)  # of a root: the pelvis, then girdles, then junctions
    rank[target[girdles.nodes]] = 2
    rank[[pelvis] if pelvis >= 0 else []] = 3
    roots = trees.roots_of(num, edges, rank + size / (1 + size.max()), None)
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
        notes += plan_biped(paths, girdles, plane, len(roots))
    return _lay_bones(roots, starts, paths, target, standard)._replace(notes=tuple(notes))


def _contract_short(
    vertices: np.ndarray, edges: np.ndarray, radii: np.ndarray, size: np.ndarray, stays: set[int]
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Contract limbs that are too short for a bone to their junctions, and then trunks without length for one, because
    how many junctions a hand or a head has is chance; the shortest first. The nodes of ``stays`` stay where they are.
    Other junctions of a trunk become one in their middle, of their largest size. Returns vertices (N, 3), edges, sizes
    (N,), and the node that stands for each (N,)."""
    vertices, size, target = vertices.copy(), size.copy(), np.arange(len(vertices))
    count = np.ones(len(vertices))  # of junctions that became one
    while True:
        degree = graphs.degrees(len(vertices), edges)
        limbs, trunks = [], []  # the length over the least one of each, and its nodes
        for nodes in graphs.trace(len(vertices), edges):
            nodes = nodes if degree[nodes[-1]] > 1 else nodes[::-1]
            one, other, length = nodes[0], nodes[-1], float(arc_length(vertices[nodes])[-1])
            if degree[one] == 1 and degree[other] > 2:
                limbs.append(((length - radii[other]) / (LEAST_LIMB * radii[other]), nodes))
            elif min(degree[one], degree[other]) > 2 and not stays.issuperset((one, other)):
                out = length - min(max(size[one], size[other]), LEAVES * length)
                trunks.append((out / float(np.median(radii[nodes])), nodes))
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
    """The bones of the roots, and of the pieces into which branches are cut, each with a name of its own: ``root``;
    ``trunk2_1`` for the first bone of the second branch between two junctions; ``limb5_3.L`` for the third bone of the
    fifth branch that ends in a tip. Two branches that are mirror images have the same number, with ``.L`` and ``.R``,
    by which Blender finds the other side. A biped's bones have those of the ``standard``."""
    which = STANDARDS.index(standard) if standard else 0
    ends, parents = [*starts], [-1] * len(roots)
    names = ["root" if len(roots) == 1 else f"root{number}" for number in range(1, len(roots) + 1)]
    if standard:
        names[0] = NAMES["hips"][which]
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
            role = NAMES[path.roles[k]][which] if path.roles else ""
            own = f"{kind}{numbers[number]}_{k + 1}{SIDE_SUFFIXES[path.side]}"
            names.append(role.format(SIDE_NAMES[path.side][which]) or own)
        piece = np.minimum(np.searchsorted(path.cuts, path.part, side="right"), len(path.cuts) - 1) - 1
        of_node[path.nodes[1:]] = np.where(piece < 0, above, first + piece)[1:]
    joints, tails = np.stack(ends, axis=1)
    return Bones(joints, tails, np.array(parents), tuple(names), of_node[target])
