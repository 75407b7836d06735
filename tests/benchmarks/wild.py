"""Meshes as found, and machined parts: what this project makes of each, and CGAL beside it, as a Markdown table.

    python -m tests.benchmarks.wild [FOLDER ..] [--parts] [--only NAME,..] [--repair MODE] [--oracle FILE]
        [--jobs N] [--limit SECONDS] [--cache FOLDER] [--output FILE]

Run from the project's root. The folder is ``MSF_JAX_WILD``, else ``../shared/wild``; ``--only`` takes names with their
suffix. ``--parts`` are plates with holes, raw and with edges cut to about 0.05 and 0.02 diagonals, and turned ten
times; pipes, brackets, rings. A mesh that is refused is run with ``--repair`` (join by default). Each is in a process
of its own, which may take ``--limit`` seconds, and so may CGAL for each component of the repaired surface; ``-`` where
it fails on one. ``JAX_COMPILATION_CACHE_DIR`` saves compilations.

- cycles: of the curve, of the genus. loops: handles that the cycles go around, by the report.
- rank: the same by the program ``--oracle`` (``../shared/tools/loops.py``), which shares nothing with the project: its
  ``rank(mesh, nodes, edges)`` returns cycles, genus, rank and how far its numbers are from whole ones. ``-`` where it
  is absent. CGAL's rank is that of its curve.

A row is in order (``ok``) that converged, with rank = loops = cycles = genus, all components and inside 1.0000, within
20 s or 5 times CGAL's time.
"""

import importlib.util
import os
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import trimesh

from tests.benchmarks import curves, frame, solids

SECONDS, TIMES_CGAL = 20.0, 5.0  # that a file may take: the larger of the two
MOST_PARTS = 200  # that CGAL is called for: each is a process
MOST_HANDLES_OF_ORACLE = 60  # it goes through all pairs of loops and cycles
CUTS = {"raw": None, "0.05": 0.05, "0.02": 0.02}  # diagonals, that edges are cut to
TURNS = 10
COLUMNS = ["mode", "components", "cycles", "loops", "rank", "CGAL's", "CGAL, s", "inside", "iterations", "end"]


def turned(mesh: trimesh.Trimesh, seed: int) -> trimesh.Trimesh:
    turn = trimesh.transformations.random_rotation_matrix(np.random.default_rng(seed).uniform(size=3))
    return mesh.copy().apply_transform(turn)


def parts() -> dict[str, Callable[[], trimesh.Trimesh]]:
    """What makes each part, by name."""
    plate_size, pipe_size = float(np.linalg.norm([10, 6, 1])), float(np.linalg.norm([2, 2, 4]))
    found: dict[str, Callable[[], trimesh.Trimesh]] = {}
    for name, cut in CUTS.items():
        for num in (1, 2, 4, 9, 16):
            found[f"plate-{num}-{name}"] = partial(solids.plate, num, cut and cut * plate_size)
        for wall in (0.5, 0.25, 0.1, 0.03):
            found[f"pipe-{wall:g}-{name}"] = partial(solids.pipe, wall, longest=cut and cut * pipe_size)
    found |= {f"plate-4-turned-{seed}": lambda seed=seed: turned(solids.plate(4), seed) for seed in range(TURNS)}
    found |= {"bracket-4": solids.bracket, "bracket-8": partial(solids.bracket, 8)}
    return found | {"rings-linked": partial(solids.rings, True), "rings-apart": partial(solids.rings, False)}


def rank_of(oracle: Path, mesh: frame.Mesh, curve: frame.Curve) -> int | None:
    """By the program at ``oracle``; None without it."""
    spec = importlib.util.spec_from_file_location("oracle_of_loops", oracle) if oracle.exists() else None
    if spec is None or spec.loader is None:
        return None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    edges = np.unique(np.sort(curve[1][curve[1][:, 0] != curve[1][:, 1]], axis=1), axis=0)
    return module.rank(trimesh.Trimesh(*mesh, process=False), curve[0], edges)[2] if len(edges) else 0


def by_cgal(name: str, checked: Any, oracle: Path | None, limit: float, cache: Path | None) -> tuple[float, int | None]:
    """Seconds for all components, NaN where it fails on one; and the rank of its curves, if there is an oracle."""
    if not importlib.util.find_spec("compas_cgal") or len(checked.components) > MOST_PARTS:
        return np.nan, None
    seconds, ranks = 0.0, []
    for number, part in enumerate(checked.components):
        mesh = (part.vertices, part.faces)
        result = curves.peer_result("cgal", curves.Case(f"{name}-{number}", mesh), limit, cache)
        if "failure" in result:
            return np.nan, None
        seconds += float(result["seconds"])
        if oracle and part.genus:
            ranks.append(rank_of(oracle, mesh, (result["vertices"], result["edges"])))
    return seconds, None if not oracle or None in ranks else sum(rank or 0 for rank in ranks)


def job_of(name: str, repair: str, oracle: Path, limit: float, cache: Path | None) -> frame.Job:
    """Of a file, or of a part."""
    import msf_jax
    from msf_jax.meshes import checking

    mesh: Any = parts()[name]() if name in parts() else name
    mode: Any = False
    try:
        checked = checking.prepare(mesh)
    except msf_jax.MeshError:
        mode = {"True": True}.get(repair, repair)
        checked = checking.prepare(mesh, mode)
    genus = sum(component.genus for component in checked.components)

    def judge(skeleton: Any) -> tuple[dict[str, str], list[str]]:
        report = skeleton.report
        has_oracle = 0 < genus <= MOST_HANDLES_OF_ORACLE
        whole = (checked.vertices, checked.faces)
        rank = rank_of(oracle, whole, (skeleton.vertices, skeleton.edges)) if has_oracle else None
        theirs, their_rank = by_cgal(Path(name).name, checked, oracle if has_oracle else None, limit, cache)
        took = sum(seconds for stage, seconds in report.seconds.items() if stage != "compile")
        cells = ["as found" if mode is False else str(mode), f"{report.components}/{report.mesh_components}"]
        cells += [f"{report.cycles}/{report.genus}", str(report.loops)]
        cells += ["-" if each is None else str(each) for each in (rank, their_rank)]
        cells += ["-" if np.isnan(theirs) else f"{theirs:.1f}", f"{report.inside:.4f}", str(report.iterations)]
        cells.append("; ".join([report.reason, *report.notes])[:160])
        is_right = {
            "not converged": report.converged,
            "loops": {report.cycles, report.loops, *([] if rank is None else [rank])} == {report.genus},
            "components": report.components == report.mesh_components,
            "outside": report.inside > 0.99995,
            "slow": took <= max(SECONDS, 0.0 if np.isnan(theirs) else TIMES_CGAL * theirs),
        }
        return dict(zip(COLUMNS, cells, strict=True)), [fault for fault, right in is_right.items() if not right]

    return frame.Job(mesh, judge, {"repair": mode})


def main() -> None:
    parser = frame.parser_for("wild", __doc__)
    parser.set_defaults(jobs=0)
    parser.add_argument("folders", nargs="*", type=Path, help="of meshes")
    parser.add_argument("--parts", action="store_true", help="machined parts instead of files")
    parser.add_argument("--repair", default="join", help="for files that are refused as found: True, or a mode")
    parser.add_argument("--oracle", type=Path, default=frame.SHARED / "tools/loops.py", help="program for the rank")
    parser.add_argument("--cache", type=Path, help="folder that keeps CGAL's results")
    wanted = parser.parse_args()
    folders = wanted.folders or [Path(os.environ.get("MSF_JAX_WILD", frame.SHARED / "wild"))]
    files = [path.resolve() for folder in folders if not wanted.parts for path in sorted(folder.iterdir())]
    names = [*parts()] if wanted.parts else [str(path) for path in files if path.suffix not in (".md", ".swc")]
    make = partial(job_of, repair=wanted.repair, oracle=wanted.oracle, limit=wanted.limit, cache=wanted.cache)
    frame.publish(frame.report("Meshes as found", COLUMNS, names, make, wanted), wanted.output)


if __name__ == "__main__":
    main()
