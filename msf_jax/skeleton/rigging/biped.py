"""Bipeds: which branch is an arm, a leg, the neck; where their joints are; and what programs call their bones.

A biped has a pelvis and shoulders with one pair of limbs each, see `girdles`, and its legs go on in the direction of
its trunk: in the mean of the spine's and of that from its hands to its feet, whose places are sure where a fat body
hides those of girdles. On four legs they are across it.
"""

from typing import NamedTuple

import numpy as np

from msf_jax.base.errors import ConfigError
from msf_jax.skeleton.rigging import cutting
from msf_jax.skeleton.rigging.girdles import BodyGirdles
from msf_jax.skeleton.rigging.mirror import Mirror
from msf_jax.skeleton.rigging.rooting import BonePath
from msf_jax.solid.geometry import arc_length, at, unit

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
SIDE_NAMES = {1: ("Left", "left", "l"), -1: ("Right", "right", "r")}
ASTRIDE = np.radians(58.0)  # between legs and trunk, at most: bipeds had up to 47, animals on four legs from 69
NECK = 1 / 3  # share of the way from the shoulders to the top of the head, where the head turns
WRIST = 0.75, 0.87  # share of an arm, where the hand is part of it, and where it ends at the fingers' junction
LOWER = 0.55  # share of a leg: the ankle is below
ANKLE = 0.85  # share of a leg without a bend there
FEET = 0.05  # of a leg's length: feet that stand out by less do not tell where the front is


class Plan(NamedTuple):
    """stops: of each branch that has a part in it, the places where its bones begin, and its end. roles: of these.
    is_swapped: whether left and right are the other way round than by coordinates, as the feet tell."""

    stops: dict[int, list[float]]
    roles: dict[int, tuple[str, ...]]
    is_swapped: bool


def plan(paths: list[BonePath], body: BodyGirdles, plane: Mirror | None, num_pieces: int) -> Plan:
    """The joints of a biped, of a curve in ``num_pieces``.

    Raises:
        ConfigError: the shape is none; the message says why.
    """
    if plane is None or body.pelvis is None or body.shoulders is None:
        apart = f'; the curve is in {num_pieces} pieces, and repair="join" makes one solid of parts'
        raise _refused("no two pairs of limbs are mirror images" + (apart if num_pieces > 1 else ""))
    trunk = [number for number, path in enumerate(paths) if path.is_spine and path.nodes[-1] == body.shoulders]
    if not trunk:
        raise _refused("the pelvis and the shoulders are not the two ends of one branch")
    legs, arms = (_pair(paths, node) for node in (body.pelvis, body.shoulders))
    upper = [number for number, path in enumerate(paths) if path.nodes[0] == body.shoulders and not path.side]
    if not legs or not arms or not upper:
        raise _refused(f"there are no {'legs' if not legs else 'arms' if not arms else 'neck and head'}")
    line = paths[trunk[0]].line
    down = line[0] - line[-1]
    along = unit(np.mean([paths[leg].line[-1] - paths[leg].line[0] for leg in legs], axis=0))  # without the spread
    hands, feet = (np.mean([paths[limb].line[-1] for limb in pair], axis=0) for pair in (arms, legs))
    between = float(np.mean(np.arccos(np.clip([along @ unit(down), along @ unit(feet - hands)], -1, 1))))
    if between > ASTRIDE:
        raise _refused(
            f"it stands on four legs: its hind legs are at {np.degrees(between):.0f} degrees to its trunk, and those "
            f"of a biped at {np.degrees(ASTRIDE):.0f} at most"
        )
    found = Plan({}, {}, False)
    spine = paths[trunk[0]].begin
    found.stops[trunk[0]] = [*(spine + cutting.SPINE_STEP * k for k in range(cutting.SPINE_JOINTS)), 1.0]
    found.roles[trunk[0]] = ("spine", "chest", "upper chest")
    neck = max(upper, key=lambda number: float(paths[number].size.mean()))
    found.stops[neck] = [0.0, NECK, 1.0]
    found.roles[neck] = ("neck", "head")
    wrist = WRIST[0 if paths[arms[0]].is_limb else 1]
    ankle = float(np.mean([_ankle(paths[leg]) for leg in legs]))
    has_toes = paths[legs[0]].is_limb
    elbow, knee = (_middle(paths[both[0]], end) for both, end in ((arms, wrist), (legs, ankle)))
    for arm in arms:
        found.stops[arm], found.roles[arm] = [0.0, elbow, wrist, 1.0], ("upper arm", "lower arm", "hand")
    for leg in legs:
        found.stops[leg] = [0.0, knee, ankle, *([(1 + ankle) / 2] if has_toes else []), 1.0]
        found.roles[leg] = ("upper leg", "lower leg", "foot", *(["toes"] if has_toes else []))
    foot = np.mean(
        [paths[leg].line[-1] - at(paths[leg].line, paths[leg].stops, np.array([ankle]))[0] for leg in legs], axis=0
    )
    down /= np.linalg.norm(down)
    front = foot - (foot @ down) * down
    left = np.cross(-down, front) @ plane.normal  # the left of a figure that looks to the front
    return found._replace(is_swapped=bool(left < -FEET * arc_length(paths[legs[0]].line)[-1]))


def named(role: str, side: int, standard: str) -> str:
    """The name of a bone in one of `STANDARDS`."""
    number = STANDARDS.index(standard)
    return NAMES[role][number].format(SIDE_NAMES[side][number] if side else "")


def _refused(reason: str) -> ConfigError:
    return ConfigError(f"names are for bipeds, and this is none: {reason}: expected names=None")


def _pair(paths: list[BonePath], node: int) -> list[int]:
    """The longest pair of branches that begins at a node; empty if there is none."""
    sided = [number for number, path in enumerate(paths) if path.nodes[0] == node and path.image >= 0]
    if not sided:
        return []
    first = max(sided, key=lambda number: float(arc_length(paths[number].line)[-1]))
    return [first, paths[first].image]


def _middle(path: BonePath, end: float) -> float:
    """The place of an elbow or a knee: at the bend, or half-way."""
    where = cutting.bend(path, 0.0, end, cutting.LIMB)[1]
    return where if 0.2 * end < where < 0.8 * end else end / 2


def _ankle(path: BonePath) -> float:
    """The place where the lower part of a leg bends most, or `ANKLE`."""
    _, where, _ = cutting.bend(path, LOWER, 1.0, cutting.LIMB)
    points = at(path.line, path.stops, np.array([LOWER, where, 1.0]))
    one, other = np.diff(points, axis=0)
    turn = np.arccos(np.clip(one @ other / max(np.linalg.norm(one) * np.linalg.norm(other), 1e-300), -1, 1))
    return where if turn > cutting.STRAIGHT and LOWER < where < 0.95 else ANKLE
