"""Where a branch is cut into bones: at its bends, or in halves if it is straight and long."""

import heapq
from itertools import pairwise

import numpy as np

from msf_jax.skeleton.rigging.rooting import SHORTEST, USUAL, BonePath
from msf_jax.solid.geometry import arc_length, at

BENT = 0.35  # radii: a bone's part of the curve is cut if it is farther than this from a straight line
LONGEST_BONE = 6.0  # radii: a longer bone is cut
LIMB = 3.0  # radii: a longer limb of a pair has a knee or an elbow
STRAIGHT = np.radians(15.0)  # a limb that turns by less is cut at the half of its length, where anatomy has the joint
SPINE_STEP = 0.2  # share of the way from the hips to the arms between two joints of a spine
SPINE_JOINTS = 3
FEWEST_HELD = 4  # vertices of a bone, at least


def cuts_of(
    paths: list[BonePath], most: int, held: np.ndarray, fill: bool, fixed: dict[int, list[float]]
) -> list[np.ndarray]:
    """For each branch the places where its bones begin, and where the last ends.

    Branches of which the places are ``fixed`` have those. A spine is cut first. Then the longest bone that is too bent
    or too long is cut, until there is none or there are ``most`` bones. To ``fill`` up to ``most``, bones are cut that
    are neither, as long as they are not too short; those of a spine last. Mirror images are cut together. A cut leaves
    `FEWEST_HELD` vertices on both sides; nodes have ``held`` (N,).
    """
    cuts = [[path.begin, 1.0] for path in paths]
    for number, stops in fixed.items():
        cuts[number] = stops
    left = most - sum(len(stops) - 1 for stops in cuts)
    heap: list[tuple[bool, bool, float, int, float, float, float]] = []

    def consider(number: int, begin: float, end: float, long: float = LONGEST_BONE) -> None:
        badness, where, length = bend(paths[number], begin, end, long)
        if badness > 1 or (fill and badness > 0):
            is_spine = paths[number].is_spine
            heapq.heappush(heap, (is_spine, badness <= 1, -length, number, begin, end, where))

    for number, (path, stops) in enumerate(zip(paths, cuts, strict=True)):
        if number in fixed or -1 < path.image < number:  # its image is cut with it
            continue
        if path.is_spine and left >= SPINE_JOINTS - 1:
            cuts[number] = [path.begin + SPINE_STEP * k for k in range(SPINE_JOINTS)] + [1.0]
            left -= SPINE_JOINTS - 1
            for begin, end in pairwise(cuts[number] if fill else []):
                consider(number, begin, end)
        else:
            consider(number, *stops, long=LIMB if path.side else LONGEST_BONE)
    while heap and left > 0:
        *_, number, begin, end, where = heapq.heappop(heap)
        both = [number] if paths[number].image < 0 else [number, paths[number].image]
        pieces = ((paths[each], *piece) for each in both for piece in ((begin, where), (where, end)))
        if len(both) <= left and all(_held(held, *piece) >= FEWEST_HELD for piece in pieces):
            for each in both:
                cuts[each] = sorted([*cuts[each], where])
            left -= len(both)
            consider(number, begin, where)
            consider(number, where, end)
    return [np.array(stops) for stops in cuts]


def _held(held: np.ndarray, path: BonePath, begin: float, end: float) -> int:
    """The number of vertices at a piece of a path."""
    is_inside = (path.part >= begin) & ((path.part < end) | (end >= 1))
    return int(held[path.nodes[1:]][is_inside[1:]].sum())


def bend(path: BonePath, begin: float, end: float, long: float) -> tuple[float, float, float]:
    """The badness of one bone for a piece of a branch, which should be at most 1 and is 0 for one that is too short to
    be cut; the place to cut it at; and its length."""
    inner = (path.stops > begin) & (path.stops < end)
    stops = np.r_[begin, path.stops[inner], end]
    points = at(path.line, path.stops, stops)
    along = arc_length(points)
    length = float(along[-1])
    radius = max(float(np.percentile(np.interp(stops, path.stops, path.size), USUAL)), 1e-12)
    if length < 2 * SHORTEST * radius:
        return 0.0, 0.0, length
    is_free = (along >= SHORTEST * radius) & (length - along >= SHORTEST * radius)
    chord = points[-1] - points[0]
    t = np.clip((points - points[0]) @ chord / max(float(chord @ chord), 1e-300), 0, 1)
    off = np.where(is_free, np.linalg.norm(points - points[0] - t[:, None] * chord, axis=1), -1.0)
    worst = int(off.argmax())
    bend, excess = float(off[worst]) / (BENT * radius), length / (long * radius)
    # A chain of two equal bones that turns by an angle a is half its length times sin(a / 2) off its chord.
    is_bent = off[worst] > length / 2 * np.sin(STRAIGHT / 2)
    if is_bent and bend >= min(excess, 1.0):
        return max(bend, excess), float(stops[worst]), length
    return max(bend, excess), float(np.interp(length / 2, along, stops)), length
