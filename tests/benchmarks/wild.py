"""Meshes as found: what this project makes of each file of a folder, and CGAL beside it, as a Markdown table.

    python -m tests.benchmarks.wild [--wild FOLDER] [--only NAME,..] [--repair MODE] [--limit SECONDS] [--warm]
        [--cache FOLDER] [--output FILE]

Run from the project's root. The folder is ``MSF_JAX_WILD``, else ``../shared/wild``; ``--only`` takes names with their
suffix. Every file is run as it is, and with ``repair`` where it is refused (``--repair join`` for another mode). Each
run is a process of its own, which may take ``--limit`` seconds, and so may CGAL's for one file, with all its components
and what is read and repaired before. Seconds are without compiling; with ``--warm``, of a second run in the same
process, if the first took less than half of the limit. CPU seconds are beside them, as a machine may have other work.
CGAL gets the repaired surface, component by component; ``-`` where it fails on one, or is not done in time.
``JAX_COMPILATION_CACHE_DIR`` saves compilations.

A row is in order (``ok``) that converged, with cycles = genus, all components and inside 1.0000, within 20 s or 5 times
CGAL's time.
"""

import argparse
import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from tests.benchmarks.curves import ROOT, Case, configure_jax, line, opening, peer_result, publish

SECONDS, TIMES_CGAL = 20.0, 5.0  # that a file may take: the larger of the two
MOST_PARTS = 200  # that CGAL is called for: each is a process
COLUMNS = [
    "file",
    "mode",
    "vertices",
    "seconds",
    "CPU",
    "CGAL",
    "components",
    "cycles",
    "inside",
    "iterations",
    "end",
    "ok",
]


def run_one(path: str, mode: str, again: float) -> dict[str, Any]:
    """One file, in this process: the row's figures, or ``failure``; of a second run if the first took less than
    ``again`` seconds."""
    import msf_jax

    repair: Any = {"as found": False, "True": True}.get(mode, mode)
    figures: dict[str, Any] = {}
    for number in range(2):
        start, cpu = time.perf_counter(), time.process_time()
        try:
            skeleton = msf_jax.skeletonize(path, repair=repair)
        except (msf_jax.MeshError, msf_jax.FlowError) as error:
            return {"failure": str(error)}
        took, report = time.perf_counter() - start, skeleton.report
        figures = {
            "seconds": took - report.seconds.get("compile", 0.0),
            "cpu": time.process_time() - cpu,
            "vertices": len(skeleton.mesh_map),
            "components": report.components,
            "mesh_components": report.mesh_components,
            "cycles": report.cycles,
            "genus": report.genus,
            "inside": report.inside,
            "converged": report.converged,
            "iterations": report.iterations,
            "reason": report.reason,
            "notes": list(report.notes),
        }
        if number or took >= again:
            break
    return figures


def in_time(arguments: list[str], limit: float) -> dict[str, Any]:
    """What this program prints with ``arguments``, from a process that may take ``limit`` seconds with all its own."""
    command = [sys.executable, "-m", "tests.benchmarks.wild", *arguments]
    with subprocess.Popen(
        command,
        cwd=ROOT,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        errors="replace",
        start_new_session=True,
    ) as process:
        try:
            output, errors = process.communicate(timeout=limit)
        except BaseException as error:
            os.killpg(process.pid, signal.SIGKILL)
            if isinstance(error, subprocess.TimeoutExpired):
                return {"failure": f"no end in {limit:g} s"}
            raise
    if process.returncode:
        return {"failure": ["no message", *errors.strip().splitlines()][-1][:100]}
    return json.loads(output.strip().splitlines()[-1])


def cgal_seconds(path: Path, limit: float, cache: Path | None) -> float:
    """What CGAL takes for all components of the repaired surface; NaN where it fails on one."""
    from msf_jax.meshes import checking

    try:
        components = checking.prepare(path, repair=True).components
    except ValueError:
        return np.nan
    total = 0.0
    for number, component in enumerate(components[:MOST_PARTS]):
        case = Case(f"{path.name}-{number}", component.vertices, component.faces)
        result = peer_result("cgal", case, limit, cache)
        if "failure" in result:
            return np.nan
        total += float(result["seconds"])
    return total if len(components) <= MOST_PARTS else np.nan


def row_of(path: Path, mode: str, limit: float, is_warm: bool, cache: Path | None) -> str:
    again = str(limit / 2 if is_warm else 0.0)
    used, figures = "as found", in_time(["--one", str(path), "as found", again], limit)
    if "failure" in figures and not figures["failure"].startswith("no end"):
        used, figures = mode, in_time(["--one", str(path), mode, again], limit)
    kept = ["--cache", str(cache.resolve())] if cache else []
    cgal = float(in_time(["--cgal", str(path), "--limit", str(limit), *kept], limit).get("seconds", np.nan))
    beside = "-" if np.isnan(cgal) else f"{cgal:.1f}"
    if "failure" in figures:
        return line([path.name, used, "", "", "", beside, *[""] * 4, figures["failure"][:120], "NO"])
    counts = [f"{figures['components']}/{figures['mesh_components']}", f"{figures['cycles']}/{figures['genus']}"]
    is_right = figures["converged"] and figures["cycles"] == figures["genus"] and figures["inside"] > 0.99995
    is_right &= figures["components"] == figures["mesh_components"]
    is_fast = figures["seconds"] <= max(SECONDS, 0.0 if np.isnan(cgal) else TIMES_CGAL * cgal)
    end = "; ".join([figures["reason"], *figures["notes"]])
    cells = [path.name, used, f"{figures['vertices']:,}", f"{figures['seconds']:.1f}", f"{figures['cpu']:.1f}"]
    cells += [beside, *counts]
    cells += [f"{figures['inside']:.4f}", str(figures["iterations"]), end[:160]]
    return line([*cells, "ok" if is_right and is_fast else "right" if is_right else "NO"])


def report(wanted: argparse.Namespace) -> Iterator[str]:
    yield opening("Meshes as found", ["cgal"], ["cgal"]) + "\n" + line(COLUMNS) + line(["---"] * len(COLUMNS))
    for path in sorted(wanted.wild.iterdir()):
        is_mesh = path.suffix.lower() not in (".md", ".swc")
        if is_mesh and (not wanted.only or path.name in wanted.only):
            yield row_of(path.resolve(), wanted.repair, wanted.limit, wanted.warm, wanted.cache)


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.wild", description=__doc__.splitlines()[0])
    parser.add_argument("--wild", type=Path, default=os.environ.get("MSF_JAX_WILD", ROOT.parent / "shared/wild"))
    parser.add_argument("--only", type=lambda text: text.split(","), help="names of files, with commas between")
    parser.add_argument("--repair", default="True", help="for files that are refused as found: True, or a mode")
    parser.add_argument("--limit", type=float, default=120, help="seconds for one file, and for CGAL's")
    parser.add_argument("--warm", action="store_true", help="time a second run in the same process")
    parser.add_argument("--cache", type=Path, help="folder that keeps CGAL's results")
    parser.add_argument("--output", type=Path, help="file for the table")
    parser.add_argument("--one", nargs=3, help=argparse.SUPPRESS)
    parser.add_argument("--cgal", type=Path, help=argparse.SUPPRESS)
    wanted = parser.parse_args()
    if wanted.one:
        configure_jax()
        print(json.dumps(run_one(*wanted.one[:2], float(wanted.one[2]))))
        return
    if wanted.cgal:
        print(json.dumps({"seconds": cgal_seconds(wanted.cgal, wanted.limit, wanted.cache)}))
        return
    if wanted.cache:
        wanted.cache.mkdir(parents=True, exist_ok=True)
    publish(report(wanted), wanted.output)


if __name__ == "__main__":
    main()
