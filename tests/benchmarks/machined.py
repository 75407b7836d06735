"""Machined solids with a known right curve: are ends where they belong, on the axis, and is nothing too long?

    python -m tests.benchmarks.machined [--seed N] [--only NAME,..] [--forms FORM,..] [--jobs N] [--limit SECONDS]
        [--pictures FOLDER] [--cases FOLDER] [--output FILE]

Run from the project's root. Solids are those of `tests.benchmarks.solids` and `tests.benchmarks.parts`, each coarse,
fine, as made and turned. A name may have wildcards. ``--cases`` scores the files of that folder instead, see
`tests.benchmarks.cases`; ``--pictures`` draws each miss from two sides.

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

import argparse
import fnmatch
import multiprocessing
import signal
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from scipy import spatial
from scipy.optimize import linear_sum_assignment

from tests.benchmarks import cases, parts, solids
from tests.benchmarks.curves import configure_jax, line, opening, publish
from tests.benchmarks.solids import Solid

SOLIDS = solids.SOLIDS | parts.PARTS
SIDEWAYS, OFF_AXIS, ASYMMETRY = 0.3, 0.3, 0.15  # half widths
ALONG, ASIDE = 1.0, 2.0  # half widths: of an end from its place
STEPS = 1000  # points on a curve for a mean distance
COLUMNS = ["solid", "vertices", "ends", "cycles", "sideways", "off axis", "asymmetry", "length", "in sheets", "sound"]
COLUMNS += ["seconds", "ok", "why not"]
Figures = dict[str, Any]


def sampled(vertices: np.ndarray, edges: np.ndarray) -> np.ndarray:
    """Points evenly on a curve."""
    from msf_jax import metrics

    total = float(np.linalg.norm(vertices[edges[:, 0]] - vertices[edges[:, 1]], axis=1).sum())
    return metrics.sample_curve(vertices, edges, max(total, 1e-12) / STEPS)[0]


def apart(one: np.ndarray, other: np.ndarray) -> float:
    """Mean distance between two sets of points, both ways."""
    return float(np.mean([spatial.KDTree(a).query(b)[0].mean() for a, b in ((one, other), (other, one))]))


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


def scored(solid: Solid, vertices: np.ndarray, edges: np.ndarray) -> Figures:
    """The figures of a curve in the solid's own place."""
    leaves = vertices[np.bincount(edges.ravel(), minlength=len(vertices)) == 1]
    matched, sideways = ends_of(solid, leaves)
    points = sampled(vertices, edges)
    length = float(np.linalg.norm(vertices[edges[:, 0]] - vertices[edges[:, 1]], axis=1).sum())
    found: Figures = {"found": len(leaves), "matched": matched, "sideways": sideways, "length": length / solid.length}
    if solid.axis:
        lines = [np.linspace(a, b, 200) for path in solid.axis for a, b in pairwise(path)]
        found["off"] = float(spatial.KDTree(np.concatenate(lines)).query(points)[0].mean() / solid.width)
    images = [apart(points, points @ matrix.T) / solid.width for matrix in solid.symmetries]
    return found | {"asymmetry": max(images, default=0.0)}


def reasons(solid: Solid, figures: Figures, *, has_way: bool) -> list[str]:
    """What is wrong with a curve; nothing if it is right."""
    if "failure" in figures:
        return [figures["failure"]]
    found = []
    asked = len(solid.ends)
    if has_way and not figures["found"] == figures["matched"] == asked:
        found.append(f"{figures['matched']} of {asked} ends, {figures['found']} leaves")
    if not has_way and figures["found"] > 2:
        found.append(f"{figures['found']} leaves")
    if figures["cycles"] != solid.cycles:
        found.append(f"{figures['cycles']} cycles for {solid.cycles}")
    bounds = {"sideways": SIDEWAYS, "off": OFF_AXIS, "asymmetry": ASYMMETRY, "length": solid.slack}
    found += [f"{key} {figures[key]:.2f}" for key, bound in bounds.items() if figures.get(key, 0.0) > bound]
    return found + (["outside"] if figures["inside"] < 0.999 else [])


class TooLong(Exception):
    """A solid took longer than its limit."""


def stop(*_: Any) -> None:
    raise TooLong


def row_of(job: tuple[str, str], seed: int, limit: float, pictures: Path | None) -> tuple[str, list[str], Figures]:
    """A row: its cells, and its figures with ``wrong``, the reasons why it is."""
    import msf_jax

    name, form = job
    solid = (SOLIDS | solids.DOUBTFUL)[name](solids.size_of(name, seed))
    turn = solids.turn_of(name, form, seed)
    mesh = solid.mesh(form)
    has_way, skeleton = name in SOLIDS, None
    figures: Figures
    signal.signal(signal.SIGALRM, stop)
    signal.setitimer(signal.ITIMER_REAL, limit)
    start = time.perf_counter()
    try:
        skeleton = msf_jax.skeletonize((mesh.vertices @ turn.T, mesh.faces))
        signal.setitimer(signal.ITIMER_REAL, 0)
        report = skeleton.report
        figures = {"seconds": time.perf_counter() - start - report.seconds.get("compile", 0.0)}
        figures |= {key: getattr(report, key) for key in ("cycles", "inside", "is_sound", "in_sheets")}
        figures |= scored(solid, skeleton.vertices @ turn, skeleton.edges)
    except Exception as error:  # a row, not the end of the table
        text = f"no end in {limit:g} s" if isinstance(error, TooLong) else f"{type(error).__name__}: {error}"
        figures = {"failure": text[:120], "seconds": time.perf_counter() - start}
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
    wrong = reasons(solid, figures, has_way=has_way)
    figures["wrong"] = wrong
    if pictures and wrong and skeleton is not None:
        curve = (skeleton.vertices @ turn, skeleton.edges)
        drawn((mesh.vertices, mesh.faces), curve, solid, f"{name} {form}: {', '.join(wrong)}", pictures, name, form)
    cells = [f"{name} {form}", f"{len(mesh.vertices):,}"]
    if "failure" in figures:
        cells += [""] * (len(COLUMNS) - 5)
    else:
        asked = str(len(solid.ends)) if has_way else "-"
        cells += [f"{figures['found']}/{figures['matched']}/{asked}", f"{figures['cycles']}/{solid.cycles}"]
        cells += [f"{figures[key]:.2f}" if key in figures else "-" for key in ("sideways", "off", "asymmetry")]
        share = figures["in_sheets"]
        cells += [f"{figures['length']:.3f}", "-" if share is None else f"{share:.2f}"]
        cells.append("yes" if figures["is_sound"] else "no")
    return name, [*cells, f"{figures['seconds']:.1f}", "NO" if wrong else "ok", "; ".join(wrong)], figures


def drawn(
    mesh: tuple[np.ndarray, np.ndarray],
    curve: tuple[np.ndarray, np.ndarray],
    solid: Solid | None,
    title: str,
    folder: Path,
    *names: str,
) -> None:
    """A PNG: the mesh faint, its curve bold, the right ends as crosses, from two sides."""
    from matplotlib.figure import Figure
    from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection

    vertices, faces = mesh
    figure = Figure(figsize=(12, 6), layout="constrained")
    figure.suptitle(title[:150], fontsize=9)
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    for number, (elevation, azimuth) in enumerate(((20, -70), (80, -85))):
        axes: Any = figure.add_subplot(1, 2, number + 1, projection="3d", proj_type="ortho")
        faint = {"facecolor": (0.55, 0.62, 0.72, 0.08), "edgecolor": (0.3, 0.35, 0.4, 0.12), "linewidth": 0.3}
        axes.add_collection3d(Poly3DCollection(vertices[faces], **faint))
        axes.add_collection3d(Line3DCollection(curve[0][curve[1]], color="crimson", linewidth=2.5))
        if solid is not None and len(solid.ends):
            axes.scatter(*solid.places.T, marker="x", color="black", s=30, depthshade=False)
        axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
        axes.set_box_aspect(high - low)
        axes.view_init(elevation, azimuth)
        axes.set_axis_off()
    folder.mkdir(parents=True, exist_ok=True)
    figure.savefig(folder / f"{'-'.join(names)}.png", dpi=80)


def in_turn(work: Callable[[Any], Any], jobs: list[Any], num: int) -> Iterator[Any]:
    """What ``work`` makes of each job, in their order, by ``num`` processes that stay."""
    context = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(num, mp_context=context, initializer=configure_jax) as pool:
        yield from pool.map(work, jobs)


def summary(done: list[Figures], what: str) -> str:
    wrong = [figures for figures in done if figures["wrong"]]
    sound = sum(bool(figures.get("is_sound")) for figures in wrong)
    text = f"\n{len(done) - len(wrong)} of {len(done)} {what} are right; of the others {sound} are called sound. "
    return text + f"{sum(figures['seconds'] for figures in done):.0f} s.\n"


def report(wanted: argparse.Namespace) -> Iterator[str]:
    yield opening("Machined solids", [], []) + f"\nSeed {wanted.seed}.\n"
    head = "\n" + line(COLUMNS) + line(["---"] * len(COLUMNS))
    work = partial(row_of, seed=wanted.seed, limit=wanted.limit, pictures=wanted.pictures)
    for what, names in (("solids", SOLIDS), ("solids without a preferred way", solids.DOUBTFUL)):
        chosen = [name for name in names if any(fnmatch.fnmatch(name, pattern) for pattern in wanted.only)]
        done, right = [], dict.fromkeys(chosen, 0)
        rows = in_turn(work, [(name, form) for name in chosen for form in wanted.forms], wanted.jobs)
        for number, (name, cells, figures) in enumerate(rows if chosen else ()):
            yield ("" if number else head) + line(cells)
            done.append(figures)
            right[name] += not figures["wrong"]
        if done:
            whole = sum(count == len(wanted.forms) for count in right.values())
            yield summary(done, what) + f"{whole} of {len(chosen)} are right in all their forms.\n"


def report_on_cases(wanted: argparse.Namespace) -> Iterator[str]:
    yield opening("Small cases", [], []) + "\n" + line(cases.COLUMNS) + line(["---"] * len(cases.COLUMNS))
    right = asked = 0
    chosen = [name for name in cases.CASES if any(fnmatch.fnmatch(name, pattern) for pattern in wanted.only)]
    for name, cells, wrong, shown in in_turn(partial(cases.row_of, folder=wanted.cases), chosen, wanted.jobs):
        yield line(cells)
        is_asked = cases.CASES[name].is_asked
        asked, right = asked + is_asked, right + (is_asked and not wrong)
        if wanted.pictures and wrong and shown is not None:
            drawn(shown[:2], shown[2:], None, f"{name}: {'; '.join(wrong)}", wanted.pictures, Path(name).stem)
    yield f"\n{right} of {asked} are right.\n"


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.machined", description=__doc__.splitlines()[0])

    def words(text: str) -> list[str]:
        return text.split(",")

    parser.add_argument("--seed", type=int, default=0, help="of sizes and turns")
    parser.add_argument("--only", type=words, default=["*"], help="names, with commas between; * is any text")
    parser.add_argument("--forms", type=words, default=list(solids.FORMS), help=",".join(solids.FORMS))
    parser.add_argument("--jobs", type=int, default=1, help="processes at a time")
    parser.add_argument("--limit", type=float, default=60, help="seconds for one solid")
    parser.add_argument("--pictures", type=Path, help="folder for a picture of each miss")
    parser.add_argument("--cases", type=Path, help="folder of small cases, which are scored instead")
    parser.add_argument("--output", type=Path, help="file for the tables")
    wanted = parser.parse_args()
    publish(report_on_cases(wanted) if wanted.cases else report(wanted), wanted.output)


if __name__ == "__main__":
    main()
