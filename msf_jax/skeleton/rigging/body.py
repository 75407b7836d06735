"""The body of a curve: its mirror plane, its girdles, and the joints of a biped.

Left is the side with the larger coordinate across the plane: the left of a figure that looks along z with y up, as in
glTF, or along -y with z up, as in Blender.

Girdles are where pairs of limbs meet the body: pelvis, shoulders, and often a head with ears or horns. The trunk lies
between the two girdles whose connection is thickest at its narrowest place, since a neck is narrower than a trunk. Of
these two the shoulders are those with the head beyond: with more pairs (ears, horns), or, if as many, with the larger
volume, which a head has and a tail has not. The other one is the pelvis. No direction in space decides, so turned and
mirrored shapes have the same.

The legs of a biped go on in the direction of its trunk: in the mean of the spine's and of that from its hands to its
feet, whose places are sure where a fat body hides those of girdles. On four legs they are across it.
"""

from collections.abc import Sequence
from itertools import combinations
from typing import NamedTuple

import networkx as nx
import numpy as np
from scipy import spatial

from msf_jax.base.errors import ConfigError
from msf_jax.skeleton.rigging import cutting
from msf_jax.skeleton.rigging.cutting import BonePath
from msf_jax.solid.geometry import arc_length, at, unit
from msf_jax.topology import graphs

ALIKE = 0.1  # diagonals of the curve: distance between a part's ends and those of its mirror image, at most
MATCHED = 0.04  # diagonals: distance of a mirrored node from the curve, at most, if it counts as matched
BETTER = 0.02  # share of the length: a plane that is tried later must match so much more, so that coordinates win
ENOUGH = 0.6  # share of the curve's length that has a mirror image in a symmetric shape, at least
MAIN_LIMB = 0.5  # of the longest pair of limbs: shorter pairs, such as fingers of a hand, make no girdle
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
ASTRIDE = np.radians(58.0)  # between legs and trunk, at most: bipeds had up to 47, animals on four legs from 69
NECK = 1 / 3  # share of the way from the shoulders to the top of the head, where the head turns
WRIST = 0.75, 0.87  # share of an arm, where the hand is part of it, and where it ends at the fingers' junction
LOWER = 0.55  # share of a leg: the ankle is below
ANKLE = 0.85  # share of a leg without a bend there
FEET = 0.05  # of a leg's length: feet that stand out by less do not tell where the front is


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

    Tried are planes across the coordinate axes, and across the principal axes of the curve, as a plane of symmetry is
    across one of these. Each is moved to half-way between tips and their images, then to where it fits best, and counts
    by the length that has a mirror image; at least two tips must be each other's image.
    """
    if len(tips) < 2:
        return None
    used = np.unique(edges)
    points, is_tip = vertices[used], np.isin(used, tips)
    step = np.linalg.norm(vertices[edges[:, 0]] - vertices[edges[:, 1]], axis=1)
    weight = np.bincount(edges.ravel(), np.repeat(step / 2, 2), len(vertices))[used]
    weight /= max(float(weight.sum()), 1e-300)
    size = float(np.linalg.norm(np.ptp(points, axis=0)))
    middle, tree = weight @ points, spatial.KDTree(points)
    principal = np.linalg.eigh((points - middle).T @ ((points - middle) * weight[:, None]))[1].T
    best, plane = 0.0, None
    for axis in (*np.eye(3), *principal):  # later ones count only if they are clearly better
        normal = axis * np.sign(axis[np.abs(axis).argmax()])
        tried = Mirror(normal, float(middle @ normal), size)
        image = tried.images(vertices[tips])
        is_other = (image >= 0) & (image != np.arange(len(tips)))
        if is_other.any():
            halfway = (vertices[tips[is_other]] + vertices[tips[image[is_other]]]) / 2
            tried = tried._replace(offset=float(np.median(halfway @ normal)))
            tried = _fit_mirror(tried, points, weight, is_tip, tree)
            share = float(weight @ (tree.query(tried.flipped(points))[0] < MATCHED * size))
            if share > max(best + BETTER, ENOUGH):
                best, plane = share, tried
    return plane


def _fit_mirror(
    mirror: Mirror, points: np.ndarray, weight: np.ndarray, is_tip: np.ndarray, tree: spatial.KDTree
) -> Mirror:
    """The plane that fits best, so that it does not depend on the axes that were tried. ``weight`` (P,) of ``points``.

    With q the point nearest to the mirror image of p, the sum of w |flip(p) - q|^2 is least where the normal is the
    first eigenvector of the symmetric part of -sum w p q^T, about the means of p and q. Only the better half counts, as
    a limb may be bent on one side, and the tips, without which nothing fixes a plane through a straight trunk. It ends
    when each q is that of an earlier step.
    """
    seen: set[bytes] = set()
    while True:
        away, match = tree.query(mirror.flipped(points))
        if match.tobytes() in seen:
            return mirror
        seen.add(match.tobytes())
        order = np.argsort(away, kind="stable")
        half = away[order[np.searchsorted(np.cumsum(weight[order]), weight.sum() / 2)]]
        share = weight * ((away <= half) | (is_tip & (away < MATCHED * mirror.size)))
        middle, partner = share @ points / share.sum(), share @ points[match] / share.sum()
        moment = -((points - middle) * share[:, None]).T @ (points[match] - partner)
        normal = np.linalg.eigh(moment + moment.T)[1][:, -1]
        normal *= np.sign(normal @ mirror.normal) or 1.0
        mirror = mirror._replace(normal=normal, offset=float((middle + partner) @ normal / 2))


class Girdles(NamedTuple):
    """nodes: where pairs of long limbs begin. pelvis and shoulders: two of them, if there are two."""

    nodes: list[int]
    pelvis: int | None = None
    shoulders: int | None = None


class LimbPair(NamedTuple):
    """Two limbs that are mirror images: the node in the middle where they begin, the nodes from tip to tip, and the
    length of both, outside the ball there."""

    girdle: int
    nodes: list[int]
    length: float


def find_girdles(
    vertices: np.ndarray, edges: np.ndarray, radii: np.ndarray, tips: np.ndarray, plane: Mirror | None
) -> Girdles:
    """The girdles of a tree ``(vertices (N, 3), edges (E, 2))`` in limbs of ``radii`` (N,) with ends ``tips``."""
    tree, degree, pairs = nx.Graph(edges.tolist()), graphs.degrees(len(vertices), edges), []
    image = np.full(len(tips), -1) if plane is None else plane.images(vertices[tips])
    for k in np.flatnonzero(image > np.arange(len(tips))):
        one, other = int(tips[k]), int(tips[image[k]])
        nodes = nx.shortest_path(tree, one, other) if nx.has_path(tree, one, other) else []
        is_middle = degree[nodes] > 2
        if plane is not None:
            is_middle &= np.abs(plane.height(vertices[nodes])) < radii[nodes]
        if is_middle.any():
            girdle = nodes[int(np.where(is_middle, radii[nodes], -1.0).argmax())]
            length = float(arc_length(vertices[nodes])[-1]) - 2 * float(radii[girdle])
            pairs.append(LimbPair(girdle, nodes, length))
    longest = max((pair.length for pair in pairs), default=0.0)
    main = [pair for pair in pairs if pair.length >= MAIN_LIMB * longest]
    trunks = []
    for one, other in combinations(sorted({pair.girdle for pair in main}), 2):
        if nx.has_path(tree, one, other):
            nodes = nx.shortest_path(tree, one, other)
            trunks.append((float(radii[nodes].min()), -len(nodes), nodes))
    if not trunks:
        return Girdles([pair.girdle for pair in main])
    trunk = max(trunks)[2]

    def beyond(end: int) -> tuple[int, float]:
        """What is beyond an end of the trunk, without its own long limbs: the number of pairs, and the integral of
        radius^2 along the curve outside the end's ball."""
        own = {node for pair in main if pair.girdle == end for node in pair.nodes} - {end}
        rest = nx.restricted_view(tree, [trunk[1] if end == trunk[0] else trunk[-2], *own], [])
        nodes = nx.node_connected_component(rest, end)
        a, b = np.array(list(rest.subgraph(nodes).edges), dtype=np.int64).reshape(-1, 2).T
        step = np.linalg.norm(vertices[a] - vertices[b], axis=1)
        is_out = np.linalg.norm((vertices[a] + vertices[b]) / 2 - vertices[end], axis=1) > radii[end]
        count = sum(pair.girdle in nodes and pair.girdle != end for pair in pairs)
        return count, float((step * radii[a] * radii[b])[is_out].sum())

    return Girdles([pair.girdle for pair in main], *sorted((trunk[0], trunk[-1]), key=beyond))


class BipedPlan(NamedTuple):
    """stops: of each branch that has a part in it, the places where its bones begin, and its end. roles: of these.
    is_swapped: whether left and right are the other way round than by coordinates, as the feet tell."""

    stops: dict[int, list[float]]
    roles: dict[int, Sequence[str]]
    is_swapped: bool


def plan_biped(paths: list[BonePath], girdles: Girdles, plane: Mirror | None, num_pieces: int) -> BipedPlan:
    """The joints of a biped, of a curve in ``num_pieces``.

    Raises:
        ConfigError: the shape is none; the message says why.
    """

    def refused(reason: str) -> ConfigError:
        return ConfigError(f"names are for bipeds, and this is none: {reason}: expected names=None")

    if plane is None or girdles.pelvis is None or girdles.shoulders is None:
        apart = f'; the curve is in {num_pieces} pieces, and repair="join" makes one solid of parts'
        raise refused("no two pairs of limbs are mirror images" + (apart if num_pieces > 1 else ""))
    trunk = [number for number, path in enumerate(paths) if path.is_spine and path.nodes[-1] == girdles.shoulders]
    if not trunk:
        raise refused("the pelvis and the shoulders are not the two ends of one branch")
    legs, arms = (_longest_pair(paths, node) for node in (girdles.pelvis, girdles.shoulders))
    upper = [number for number, path in enumerate(paths) if path.nodes[0] == girdles.shoulders and not path.side]
    if not legs or not arms or not upper:
        raise refused(f"there are no {'legs' if not legs else 'arms' if not arms else 'neck and head'}")
    spine = paths[trunk[0]]
    down = unit(spine.line[0] - spine.line[-1])
    along = unit(np.mean([paths[leg].line[-1] - paths[leg].line[0] for leg in legs], axis=0))  # without the spread
    hands, feet = (np.mean([paths[limb].line[-1] for limb in pair], axis=0) for pair in (arms, legs))
    between = float(np.mean(np.arccos(np.clip([along @ down, along @ unit(feet - hands)], -1, 1))))
    if between > ASTRIDE:
        raise refused(
            f"it stands on four legs: its hind legs are at {np.degrees(between):.0f} degrees to its trunk, and those "
            f"of a biped at {np.degrees(ASTRIDE):.0f} at most"
        )
    neck = max(upper, key=lambda number: float(paths[number].size.mean()))
    wrist, has_toes = WRIST[0 if paths[arms[0]].is_limb else 1], paths[legs[0]].is_limb
    ankle = float(np.mean([_find_ankle(paths[leg]) for leg in legs]))
    elbow, knee = (
        where if 0.2 * end < (where := cutting.bend(paths[limb], 0.0, end, cutting.LIMB)[1]) < 0.8 * end else end / 2
        for limb, end in ((arms[0], wrist), (legs[0], ankle))
    )
    stops = {trunk[0]: cutting.spine_stops(spine), neck: [0.0, NECK, 1.0]}
    stops |= {arm: [0.0, elbow, wrist, 1.0] for arm in arms}
    stops |= {leg: [0.0, knee, ankle, *[(1 + ankle) / 2] * has_toes, 1.0] for leg in legs}
    roles = {trunk[0]: ("spine", "chest", "upper chest"), neck: ("neck", "head")}
    roles |= dict.fromkeys(arms, ("upper arm", "lower arm", "hand"))
    roles |= dict.fromkeys(legs, ("upper leg", "lower leg", "foot", *["toes"] * has_toes))
    ends = [at(paths[leg].line, paths[leg].stops, np.array([ankle, 1.0])) for leg in legs]
    foot = np.mean([end - begin for begin, end in ends], axis=0)
    front = foot - (foot @ down) * down
    left = np.cross(-down, front) @ plane.normal  # the left of a figure that looks to the front
    return BipedPlan(stops, roles, bool(left < -FEET * arc_length(paths[legs[0]].line)[-1]))


def _longest_pair(paths: list[BonePath], node: int) -> list[int]:
    """The longest pair of branches that begins at a node; empty if there is none."""
    sided = [number for number, path in enumerate(paths) if path.nodes[0] == node and path.image >= 0]
    first = max(sided, key=lambda number: float(arc_length(paths[number].line)[-1]), default=-1)
    return [] if first < 0 else [first, paths[first].image]


def _find_ankle(path: BonePath) -> float:
    """The place where the lower part of a leg bends most, or `ANKLE`."""
    _, where, _ = cutting.bend(path, LOWER, 1.0, cutting.LIMB)
    one, other = np.diff(at(path.line, path.stops, np.array([LOWER, where, 1.0])), axis=0)
    turn = np.arccos(np.clip(one @ other / max(np.linalg.norm(one) * np.linalg.norm(other), 1e-300), -1, 1))
    return where if turn > cutting.STRAIGHT and LOWER < where < 0.95 else ANKLE
