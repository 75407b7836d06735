"""Machined solids with a known right curve: are ends where they belong, on the axis, and is nothing too long?

    python -m tests.benchmarks.machined [--seed N] [--only NAME,..] [--forms FORM,..] [--jobs N] [--limit SECONDS]
        [--pictures FOLDER] [--output FILE]

Run from the project's root. Solids are those of `solids`, each coarse, fine, as made and turned; ``--only "bar *"``
takes all forms of one.

- ends: leaves found, matched and asked. One is matched that is within one half width of its place along the axis, the
  documented 0.3 radii before the end face, and within two half widths sideways.
- sideways: the largest distance of a matched end from the axis, in half widths; right is at most 0.3.
- off axis: mean distance of the curve from the axes, in half widths; right is at most 0.3. Pockets may push it.
- asymmetry: mean distance between the curve and its mirror images, in half widths, the largest over the solid's
  symmetries; right is at most 0.15.
- length: of the curve, over that of the axes; right is at most 1.02, or 1.06 with holes, which the curve goes around.
- in sheets, sound: what the report says; sheets, such as an I-beam or a channel, are rightly not sound.
- seconds: without compiling.

A half width is the radius of the disc that has the area of the limb's section. The first table has the 57
solids (228 forms) that have a right curve. The second has four without a preferred way, of which only one short branch
is asked.
"""

from functools import partial
from itertools import pairwise
from typing import Any

import numpy as np
from scipy.optimize import linear_sum_assignment

from tests.benchmarks import frame, solids
from tests.benchmarks.frame import Curve
from tests.benchmarks.solids import SOLIDS, Solid

SIDEWAYS, OFF_AXIS, ASYMMETRY = 0.3, 0.3, 0.15  # half widths
ALONG, ASIDE = 1.0, 2.0  # half widths: of an end from its place
STEPS = 1000  # points on a curve for a mean distance
COLUMNS = ["ends", "cycles", "sideways", "off axis", "asymmetry", "length", "in sheets"]
Figures = dict[str, Any]


def ends_of(solid: Solid, leaves: np.ndarray) -> tuple[int, float]:
    """How many of the solid's ends have a leaf of their own, and the largest offset sideways, in half widths."""
    if not len(leaves) or not len(solid.ends):
        return 0, 0.0
    away = leaves[None] - solid.places[:, None]
    along = (away * solid.outwards[:, None]).sum(axis=2)
    aside = np.linalg.norm(away - along[..., None] * solid.outwards[:, None], axis=2) / solid.widths[:, None]
    is_near = (np.abs(along) <= ALONG * solid.widths[:, None]) & (aside <= ASIDE)
    end, leaf = linear_sum_assignment(np.where(is_near, aside, 1e6))
    kept = is_near[end, leaf]
    return int(kept.sum()), float(aside[end, leaf][kept].max(initial=0.0))


def scored(solid: Solid, curve: Curve) -> Figures:
    """The figures of a curve in the solid's own place."""
    leaves, length = frame.ends(curve), frame.length(curve)
    matched, sideways = ends_of(solid, leaves)
    points = frame.sampled(curve, max(length, 1e-12) / STEPS)
    found: Figures = {"found": len(leaves), "matched": matched, "sideways": sideways, "length": length / solid.length}
    if solid.axis:
        lines = [np.linspace(a, b, 200) for path in solid.axis for a, b in pairwise(path)]
        found["off axis"] = float(frame.away(points, np.concatenate(lines)).mean() / solid.width)
    images = [frame.apart(points, points @ matrix.T) / solid.width for matrix in solid.symmetries]
    return found | {"asymmetry": max(images, default=0.0)}


def reasons(solid: Solid, figures: Figures, *, has_way: bool) -> list[str]:
    """What is wrong with a curve; nothing if it is right."""
    wrong, asked = [], len(solid.ends)
    if has_way and not figures["found"] == figures["matched"] == asked:
        wrong.append(f"{figures['matched']} of {asked} ends, {figures['found']} leaves")
    if not has_way and figures["found"] > 2:
        wrong.append(f"{figures['found']} leaves")
    if figures["cycles"] != solid.cycles:
        wrong.append(f"{figures['cycles']} cycles for {solid.cycles}")
    bounds = {"sideways": SIDEWAYS, "off axis": OFF_AXIS, "asymmetry": ASYMMETRY, "length": solid.slack}
    wrong += [f"{key} {figures[key]:.2f}" for key, bound in bounds.items() if figures.get(key, 0.0) > bound]
    return wrong + (["outside"] if figures["inside"] < 0.999 else [])


def job_of(name: str, seed: int) -> frame.Job:
    """Of "SOLID FORM"."""
    kind, form = name.rsplit(" ", 1)
    solid = (SOLIDS | solids.DOUBTFUL)[kind](solids.size_of(kind, seed))
    turn, mesh, has_way = solids.turn_of(kind, form, seed), solid.mesh(form), kind in SOLIDS

    def judge(skeleton: Any) -> tuple[dict[str, str], list[str]]:
        report = skeleton.report
        figures = scored(solid, (skeleton.vertices @ turn, skeleton.edges))
        figures |= {"cycles": report.cycles, "inside": report.inside}
        cells = {name: f"{figures[name]:.2f}" if name in figures else "-" for name in COLUMNS[2:5]}
        cells["ends"] = f"{figures['found']}/{figures['matched']}/{len(solid.ends) if has_way else '-'}"
        cells["cycles"], cells["length"] = f"{report.cycles}/{solid.cycles}", f"{figures['length']:.3f}"
        cells["in sheets"] = "-" if report.in_sheets is None else f"{report.in_sheets:.2f}"
        return cells, reasons(solid, figures, has_way=has_way)

    shown = (np.asarray(mesh.vertices), np.asarray(mesh.faces))
    return frame.Job((mesh.vertices @ turn.T, mesh.faces), judge, {}, shown, solid.places, turn)


def main() -> None:
    parser = frame.parser_for("machined", __doc__, limit=60)
    parser.add_argument("--seed", type=int, default=0, help="of sizes and turns")
    parser.add_argument("--forms", type=frame.words, default=list(solids.FORMS), help=",".join(solids.FORMS))
    wanted = parser.parse_args()
    make = partial(job_of, seed=wanted.seed)

    def both() -> frame.Pieces:
        for title, kinds in (("Machined solids", SOLIDS), ("Solids without a preferred way", solids.DOUBTFUL)):
            names = [f"{kind} {form}" for kind in kinds for form in wanted.forms]
            yield from frame.report(f"{title}, seed {wanted.seed}", COLUMNS, names, make, wanted)

    frame.publish(both(), wanted.output)


if __name__ == "__main__":
    main()
