"""Small solids that came out wrong and were called sound, with the right values of the README in their folder.

    python -m tests.benchmarks.cases FOLDER [--only NAME,..] [--jobs N] [--pictures FOLDER] [--output FILE]

Ends are right within 0.15 radii of their limb (0.3 at openings and at the flat end of an elliptic limb), lengths within
3 %, radii within 5 %, angles within 3 degrees. A leaf of a closed limb belongs 0.3 radii before its end face, one of an
opening at its rim.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from scipy import sparse
from scipy.optimize import linear_sum_assignment
from scipy.sparse import csgraph

from tests.benchmarks import frame

COLUMNS = ["leaves", "cycles", "length", "least radius"]
LENGTH, RADIUS, ANGLE = 0.03, 0.05, 3.0  # parts, parts, degrees
OUTER = 3.623, 13.523  # x and z where the fork's daughters end: 14 long, 15 degrees from z
STEM = [  # where pedicels meet the middle of the stem: the bases of their tubes
    (11.46, 46.41, -10.51),
    (11.74, 49.06, -10.72),
    (12.05, 52.15, -11.00),
    (12.24, 54.87, -11.20),
    (12.45, 56.98, -11.34),
    (12.57, 59.19, -11.51),
    (12.70, 61.42, -11.60),
    (12.86, 63.60, -11.71),
    (12.98, 66.21, -11.86),
]


@dataclass(frozen=True)
class Case:
    """What is right of a curve.

    Attributes:
        ends: where leaves belong; others are wrong, but for ``is_partial``.
        reach: how far from there they may be.
        length: of the curve; not asked if 0.
        radius: least one of the table of branches; not asked if 0.
        cycles: of the curve.
        repair: as `skeletonize` takes it.
        more: other faults of a curve, in words.
        is_partial: whether there are more ends than ``ends``.
    """

    ends: Sequence[tuple[float, float, float]] = ()
    reach: float = 0.15
    length: float = 0.0
    radius: float = 0.0
    cycles: int = 0
    repair: Any = False
    more: Callable[[Any], list[str]] | None = None
    is_partial: bool = False


def wrong_ends(case: Case, leaves: np.ndarray) -> list[str]:
    found = [] if case.is_partial or len(leaves) == len(case.ends) else [f"{len(leaves)} leaves for {len(case.ends)}"]
    if not case.ends or not len(leaves):
        return found
    ends = np.array(case.ends)
    away = np.linalg.norm(ends[:, None] - leaves, axis=2)
    end, leaf = linear_sum_assignment(away)
    for k, best in zip(end, leaf, strict=True):
        if away[k, best] > case.reach:
            at = ", ".join(f"{value:.2f}" for value in leaves[best])
            found.append(f"({at}) is {away[k, best] / case.reach:.1f} times too far from an end")
    return found


def faults(case: Case, skeleton: Any) -> list[str]:
    """What is wrong with a curve, in words."""
    found = wrong_ends(case, frame.ends((skeleton.vertices, skeleton.edges)))
    if case.length and abs(skeleton.length - case.length) > LENGTH * case.length:
        found.append(f"length {skeleton.length:.4g} for {case.length:g}")
    if skeleton.report.cycles != case.cycles:
        found.append(f"{skeleton.report.cycles} cycles for {case.cycles}")
    least = least_radius(skeleton)
    # A surface that crosses itself has radii to walls inside of the solid: a doubt is right, too.
    if case.radius and abs(least - case.radius) > RADIUS * case.radius and skeleton.report.is_sound:
        found.append(f"least radius {least:.3g} for {case.radius:g}")
    return found + (case.more(skeleton) if case.more else [])


def least_radius(skeleton: Any) -> float:
    return float(np.min(skeleton.columns()["least_radius"]))


def fork(skeleton: Any) -> list[str]:
    """The daughters' angles, and where the junction is: where the axes meet, within a radius of the trunk."""
    junction = frame.junctions((skeleton.vertices, skeleton.edges))
    found = [] if len(junction) == 1 else [f"{len(junction)} junctions for 1"]
    if len(junction) and (away := np.linalg.norm(junction, axis=1).max()) > 1.0:
        found.append(f"junction {away:.2f} from the meeting of the axes")
    table = skeleton.columns()
    angle = np.asarray(table["angle"])[np.asarray(table["parent"]) >= 0]
    if len(angle) != 2 or (np.abs(angle - 15) > ANGLE).any():
        found.append(f"angles {', '.join(f'{each:.0f}' for each in angle)} for 15, 15")
    return found


def torus(skeleton: Any) -> list[str]:
    away = float(np.abs(np.linalg.norm(skeleton.vertices[:, :2], axis=1) - 1.0).max())
    return [f"{away:.2f} off the circle of radius 1"] if away > 0.15 else []


def stem(skeleton: Any) -> list[str]:
    """A junction within 0.15 of each pedicel's base and of no other place; 17.30 from the first base to the eighth."""
    x, edges, places = skeleton.vertices, skeleton.edges, np.array(STEM)
    junction = frame.junctions((x, edges))
    if not len(junction):
        return ["no junctions"]
    missed = int((frame.away(places, junction) > 0.15).sum())
    strayed = int((frame.away(junction, places) > 0.15).sum())
    found = [f"{missed} of {len(places)} pedicels without a junction"] if missed else []
    found += [f"{strayed} of {len(junction)} junctions over 0.15 off"] if strayed else []
    first, last = (int(np.linalg.norm(x - places[k], axis=1).argmin()) for k in (0, 7))
    step = np.linalg.norm(x[edges[:, 0]] - x[edges[:, 1]], axis=1)
    graph = sparse.coo_matrix((step, tuple(edges.T)), (len(x), len(x)))
    length = float(csgraph.dijkstra(graph.tocsr(), directed=False, indices=first)[last])
    return found + ([f"stem {length:.2f} for 17.30"] if not abs(length - 17.3) <= LENGTH * 17.3 else [])


_X, _Z = OUTER[0] - 0.24 * np.sin(np.radians(15)), OUTER[1] - 0.24 * np.cos(np.radians(15))
CASES: dict[str, Case] = {
    "trimesh-cylinder-3.off": Case([(0, 0, -1.2), (0, 0, 1.2)], length=2.4),
    "cylinder-8-n24-h0.2.off": Case([(0, 0, 0.3), (0, 0, 7.7)], length=7.4),
    "beam-6.off": Case([(0, 0, -2.85), (0, 0, 2.85)], 0.075, length=5.7),
    "short-outlet.off": Case([(0, 0, -10), (0, 0, 10), (4.5, 0, 0)], 0.36, length=24.5, repair=True),
    "open-tube-oblique45.off": Case([(0, 0, 0), (0, 0, 40)], 0.6, length=40.0, repair=True),
    "open-elliptic-3to1.off": Case([(0, 0, 0), (0, 0, 30)], 0.3, length=30.0, repair=True),
    "jagged-open-tube.off": Case([(0, 0, 2), (0, 0, 38)], 0.6, length=36.0, radius=1.98, repair=True),
    "two-crossing-tubes.off": Case([(-9.7, 0, 0), (9.7, 0, 0), (0, -9.7, 0.5), (0, 9.7, 0.5)], radius=0.988),
    "torus-095.off": Case(length=6.283, radius=0.95, cycles=1, more=torus),
    "fork-30.off": Case([(0, 0, -9.7), (-_X, 0, _Z), (_X, 0, _Z)], radius=0.8, more=fork),
    "flat-end-elliptic.obj": Case([(0, 0, 0.14)], 0.0065, is_partial=True),
    "plant-stem.obj": Case(repair="join", more=stem, is_partial=True),
}


def job_of(name: str) -> frame.Job:
    """Of the path of a file."""
    from msf_jax.meshes import reading

    case = CASES[Path(name).name]

    def judge(skeleton: Any) -> tuple[dict[str, str], list[str]]:
        cells = [str(skeleton.num_leaves), str(skeleton.report.cycles), f"{skeleton.length:.4g}"]
        cells.append(f"{least_radius(skeleton):.3g}")
        return dict(zip(COLUMNS, cells, strict=True)), faults(case, skeleton)

    return frame.Job(name, judge, {"repair": case.repair}, reading.read(Path(name)))


def main() -> None:
    parser = frame.parser_for("cases", __doc__)
    parser.add_argument("folder", type=Path, help="of the cases")
    wanted = parser.parse_args()
    names = [str(wanted.folder / name) for name in CASES]
    frame.publish(frame.report("Small cases", COLUMNS, names, job_of, wanted), wanted.output)


if __name__ == "__main__":
    main()
