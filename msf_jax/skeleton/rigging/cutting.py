"""Where a branch is cut into bones: at its bends, or in halves if it is straight and long."""

import heapq
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from msf_jax.solid.geometry import arc_length, at, to_segment

SHORTEST = 1.0  # radii: the least length of a bone after a cut, and of one between two junctions
USUAL = 75  # percentile of the radii along a bone that counts as the bone's radius
BENT = 0.35  # radii: a bone's part of the curve is cut if it is farther than this from a straight line
LONGEST_BONE = 6.0  # radii: a longer bone is cut
LIMB = 3.0  # radii: a longer limb of a pair has a knee or an elbow
STRAIGHT = np.radians(15.0)  # a limb that turns by less is cut at the half of its length, where anatomy has the joint
SPINE_STEP = 0.2  # share of the way from the hips to the arms between two joints of a spine
SPINE_JOINTS = 3
FEWEST_HELD = 4  # vertices of a bone, at least


class BonePath(NamedTuple):
    """A branch directed away from the root.

    nodes: (n,) from the junction on. part: (n,) the place of each node on the line: 0 at its start, 1 at its end, and
    negative within the ball of the junction. stops: (m,) places from 0 to 1, line: (m, 3) its points there, and size:
    (m,) the radii. begin: the place of the first joint. is_limb: whether it ends in a tip. image: the path that is its
    mirror image, -1 without one. side: 1 on the left, -1 on the right, 0 else. is_spine: from the pelvis towards the
    shoulders.
    """

    nodes: np.ndarray
    part: np.ndarray
    stops: np.ndarray
    line: np.ndarray
    size: np.ndarray
    is_limb: bool
    begin: float = 0.0
    image: int = -1
    side: int = 0
    is_spine: bool = False


def spine_stops(path: BonePath) -> list[float]:
    """The places where the bones of a spine begin, and its end."""
    return [*(path.begin + SPINE_STEP * k for k in range(SPINE_JOINTS)), 1.0]


def cut_paths(
    paths: list[BonePath], most: int, held: np.ndarray, fill: bool, fixed: dict[int, list[float]]
) -> list[list[float]]:
    """For each branch the places where its bones begin, and where the last ends.

    Branches of which the places are ``fixed`` have those. A spine is cut first. Then the longest bone that is too bent
    or too long is cut, until there is none or there are ``most`` bones. To ``fill`` up to ``most``, bones are cut that
    are neither, as long as they are not too short; those of a spine last. Mirror images are cut together. A cut leaves
    `FEWEST_HELD` vertices on both sides; nodes have ``held`` (N,).
    """
    cuts = [fixed.get(number, [path.begin, 1.0]) for number, path in enumerate(paths)]
    left = most - sum(len(stops) - 1 for stops in cuts)
    heap: list[tuple[bool, bool, float, int, float, float, float]] = []

    def consider(number: int, begin: float, end: float, long: float = LONGEST_BONE) -> None:
        badness, where, length = bend(paths[number], begin, end, long)
        if badness > 1 or (fill and badness > 0):
            heapq.heappush(heap, (paths[number].is_spine, badness <= 1, -length, number, begin, end, where))

    def count_held(path: BonePath, begin: float, end: float) -> int:
        is_inside = (path.part >= begin) & ((path.part < end) | (end >= 1))
        return int(held[path.nodes[1:]][is_inside[1:]].sum())

    for number, (path, stops) in enumerate(zip(paths, cuts, strict=True)):
        if number in fixed or -1 < path.image < number:  # its image is cut with it
            continue
        if path.is_spine and left >= SPINE_JOINTS - 1:
            cuts[number] = spine_stops(path)
            left -= SPINE_JOINTS - 1
            for begin, end in pairwise(cuts[number] if fill else []):
                consider(number, begin, end)
        else:
            consider(number, *stops, long=LIMB if path.side else LONGEST_BONE)
    while heap and left > 0:
        *_, number, begin, end, where = heapq.heappop(heap)
        both = [number] if paths[number].image < 0 else [number, paths[number].image]
        pieces = ((paths[each], *piece) for each in both for piece in ((begin, where), (where, end)))
        if len(both) <= left and all(count_held(*piece) >= FEWEST_HELD for piece in pieces):
            for each in both:
                cuts[each] = sorted([*cuts[each], where])
            left -= len(both)
            consider(number, begin, where)
            consider(number, where, end)
    return cuts


def bend(path: BonePath, begin: float, end: float, long: float) -> tuple[float, float, float]:
    """The badness of one bone for a piece of a branch, which should be at most 1 and is 0 for one that is too short to
    be cut; the place to cut it at; and its length."""
    stops = np.r_[begin, path.stops[(path.stops > begin) & (path.stops < end)], end]
    points = at(path.line, path.stops, stops)
    along = arc_length(points)
    length = float(along[-1])
    radius = max(float(np.percentile(np.interp(stops, path.stops, path.size), USUAL)), 1e-12)
    if length < 2 * SHORTEST * radius:
        return 0.0, 0.0, length
    is_free = (along >= SHORTEST * radius) & (length - along >= SHORTEST * radius)
    off = np.where(is_free, to_segment(points, points[0], points[-1]), -1.0)
    worst = int(off.argmax())
    bent, excess = float(off[worst]) / (BENT * radius), length / (long * radius)
    # A chain of two equal bones that turns by an angle a is half its length times sin(a / 2) off its chord.
    is_bent = off[worst] > length / 2 * np.sin(STRAIGHT / 2) and bent >= min(excess, 1.0)
    where = float(stops[worst]) if is_bent else float(np.interp(length / 2, along, stops))
    return max(bent, excess), where, length
