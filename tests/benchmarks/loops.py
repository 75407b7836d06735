"""Do the curve's loops go around the solid's handles: of machined parts and of meshes as found, as a Markdown table.

    python -m tests.benchmarks.loops [--meshes FOLDER] [--wild FOLDER] [--only NAME,..] [--oracle FILE]
        [--limit SECONDS] [--cache FOLDER] [--output FILE]

Run from the project's root. Parts are those of `msf_jax.shapes`: plates with holes, raw and with edges cut to about
0.05 and 0.02 diagonals, and turned ten times; pipes, brackets, rings. Files are all of the two folders that have
handles (``MSF_JAX_MESHES``, else ``../shared/meshes``, and ``MSF_JAX_WILD``, else ``../shared/wild``); one that is
refused as found is joined (``repair="join"``). ``--only`` takes names of parts, and of files with their suffix.

- rank: handles that the cycles go around, by the program ``--oracle`` (``../shared/tools/loops.py``), which shares
  nothing with the project: its ``rank(mesh, nodes, edges)`` returns cycles, genus, rank and how far its numbers are
  from whole ones. ``-`` where it is absent. ``loops`` is what the project's own report says.
- CGAL: the same rank of CGAL's curve, component by component, where compas_cgal is installed; ``-`` where it fails.
- mutants: of two curves made wrong (a loop moved off its hole, a loop doubled in place of another), those that the
  report still calls sound, doubts about sheets aside: 0 is right.
- seconds: without compiling, of a process that is warm.

A row is in order (``ok``) if rank = loops = cycles = genus, the report has no other doubt, and no mutant is sound.
Each case is a process of its own. ``JAX_COMPILATION_CACHE_DIR`` saves compilations.
"""

import argparse
import importlib.util
import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import trimesh
from scipy import sparse
from scipy.sparse import csgraph

from tests.benchmarks import solids
from tests.benchmarks.curves import ROOT, Case, configure_jax, installed, line, opening, peer_result, publish

COLUMNS = ["mesh", "vertices", "genus", "cycles", "loops", "rank", "CGAL", "inside", "mutants", "seconds", "ok"]
CUTS = {"raw": None, "0.05": 0.05, "0.02": 0.02}  # diagonals, that edges are cut to
TURNS = 10
SUFFIXES = (".off", ".obj", ".ply", ".stl", ".glb", ".3mf")
MOST_HANDLES_OF_ORACLE = 60  # it goes through all pairs of loops and cycles


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
    for seed in range(TURNS):
        found[f"plate-4-turned-{seed}"] = lambda seed=seed: turned(solids.plate(4), seed)
    for wall in (0.5, 0.25, 0.1, 0.03):
        for name, cut in CUTS.items():
            found[f"pipe-{wall:g}-{name}"] = partial(solids.pipe, wall, longest=cut and cut * pipe_size)
    return found | {
        "bracket-4": solids.bracket,
        "bracket-8": partial(solids.bracket, 8),
        "rings-linked": partial(solids.rings, True),
        "rings-apart": partial(solids.rings, False),
    }


def oracle_of(path: Path) -> Callable[..., tuple[int, int, int, float]] | None:
    """The function ``rank`` of the program at ``path``, if that is there."""
    spec = importlib.util.spec_from_file_location("oracle_of_loops", path) if path.exists() else None
    if spec is None or spec.loader is None:
        return None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.rank


def mutants(skeleton: Any) -> list[Any]:
    """Reports on the curve with a loop off its hole, and with one doubled in place of another, if there is one.

    Each has as many cycles as before.
    """
    x, edges, num = skeleton.vertices, skeleton.edges, len(skeleton.vertices)
    graph = sparse.coo_matrix((np.ones(len(edges)), tuple(edges.T)), (num, num)).tocsr()
    label = csgraph.connected_components(graph, directed=False)[1]
    found: list[tuple[np.ndarray, np.ndarray]] = []
    for part in range(label.max() + 1):
        start = int(np.flatnonzero(label == part)[0])
        before = csgraph.breadth_first_order(graph, start, directed=False)[1]
        is_left = (
            (before[edges[:, 0]] == edges[:, 1]) | (before[edges[:, 1]] == edges[:, 0]) | (label != part)[edges[:, 0]]
        )
        closing = np.flatnonzero(~is_left)
        if not len(closing):
            continue
        cut = np.delete(edges, closing[0], axis=0)
        widest = int(np.where(label == part, skeleton.radii, 0).argmax())
        off = np.concatenate([x, x[widest] + 0.2 * skeleton.radii[widest] * np.eye(3)[:2]])
        found.append((off, np.concatenate([cut, [[widest, num], [num, num + 1], [widest, num + 1]]])))
        if len(closing) > 1:
            paths = [[int(end)] for end in edges[closing[-1]]]
            for path in paths:
                while before[path[-1]] >= 0:
                    path.append(int(before[path[-1]]))
            while len(paths[0]) > 1 and len(paths[1]) > 1 and paths[0][-2] == paths[1][-2]:
                paths = [path[:-1] for path in paths]
            loop = np.array([*paths[0], *paths[1][-2::-1]])
            beside = x[loop] + 0.05 * skeleton.radii[loop, None] * np.array([0.36, 0.48, 0.8])
            number = num + np.arange(len(loop))
            links = np.concatenate([np.stack([number, np.roll(number, -1)], axis=1), [[loop[0], num]]])
            found.append((np.concatenate([x, beside]), np.concatenate([cut, links])))
        break
    from msf_jax.skeleton.skeleton import changed

    return [changed(skeleton, vertices, links, np.arange(num)).report for vertices, links in found]


def run_one(name: str, oracle: Path, limit: float, cache: Path | None) -> dict[str, Any]:
    """One case, in this process: the row's figures, or ``failure``."""
    import msf_jax
    from msf_jax.meshes import checking

    made = parts()
    mesh: Any = made[name]() if name in made else name
    repair: Any = False
    try:
        checked = checking.prepare(mesh)
    except msf_jax.MeshError:
        repair = "join"
        try:
            checked = checking.prepare(mesh, repair)
        except msf_jax.MeshError as error:
            return {"failure": str(error)}
    genus = sum(component.genus for component in checked.components)
    if not genus:
        return {"genus": 0}
    msf_jax.skeletonize(mesh, repair=repair)
    start = time.perf_counter()
    skeleton = msf_jax.skeletonize(mesh, repair=repair)
    report = skeleton.report
    figures = {
        "seconds": time.perf_counter() - start - report.seconds.get("compile", 0.0),
        "vertices": len(checked.vertices),
        "genus": genus,
        "cycles": report.cycles,
        "loops": report.loops,
        "inside": report.inside,
        "is_right": is_right(report),
        "doubts": list(report.doubts),
        "mutants": [is_right(each) for each in mutants(skeleton)],
    }
    rank = oracle_of(oracle)
    if rank is None or genus > MOST_HANDLES_OF_ORACLE:
        return figures
    solid = trimesh.Trimesh(checked.vertices, checked.faces, process=False)
    _, _, figures["rank"], figures["error"] = rank(solid, skeleton.vertices, skeleton.edges)
    if not installed(["cgal"]):
        return figures
    total = 0
    for number, part in enumerate(checked.components):
        case = Case(f"{Path(name).name}-{number}", part.vertices, part.faces)
        curve = peer_result("cgal", case, limit, cache) if part.genus else {"vertices": np.zeros((1, 3)), "edges": []}
        if "failure" in curve:
            return figures
        edges = np.asarray(curve["edges"], dtype=np.int64).reshape(-1, 2)
        edges = np.unique(np.sort(edges[edges[:, 0] != edges[:, 1]], axis=1), axis=0)
        if len(edges):
            solid = trimesh.Trimesh(part.vertices, part.faces, process=False)
            total += rank(solid, np.asarray(curve["vertices"], dtype=np.float64), edges)[2]
    return figures | {"cgal": total}


def is_right(report: Any) -> bool:
    """Whether the report calls the topology sound. That a curve lies in sheets is a doubt, too, but not about loops."""
    return replace(report, doubts=tuple(doubt for doubt in report.doubts if doubt not in report.not_limbs)).is_sound


def in_time(arguments: list[str], limit: float) -> dict[str, Any]:
    """What this program prints with ``arguments``, from a process that may take ``limit`` seconds with all its own."""
    command = [sys.executable, "-m", "tests.benchmarks.loops", *arguments]
    with subprocess.Popen(
        command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True
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


def row_of(name: str, figures: dict[str, Any]) -> str:
    if "failure" in figures:
        return line([name, *[""] * (len(COLUMNS) - 3), figures["failure"][:120], "NO"])
    rank = figures.get("rank")
    same = {figures[key] for key in ("genus", "cycles", "loops")} | ({rank} if rank is not None else set())
    is_ok = len(same) == 1 and figures["is_right"] and not any(figures["mutants"])
    shown = [f"{figures['vertices']:,}", *(str(figures.get(key, "-")) for key in COLUMNS[2:6])]
    shown += [str(figures.get("cgal", "-")), f"{figures['inside']:.4f}", str(sum(figures["mutants"]))]
    return line([name, *shown, f"{figures['seconds']:.2f}", "ok" if is_ok else "NO"])


def report(wanted: argparse.Namespace) -> Iterator[str]:
    yield opening("Loops", ["cgal"], installed(["cgal"])) + "\n" + line(COLUMNS) + line(["---"] * len(COLUMNS))
    files = [path for folder in (wanted.meshes, wanted.wild) if folder.exists() for path in sorted(folder.iterdir())]
    files = [
        path.resolve() for path in files if path.suffix.lower() in (".off", ".obj", ".ply", ".stl", ".glb", ".3mf")
    ]
    options = ["--oracle", str(wanted.oracle.resolve()), "--limit", str(wanted.limit)]
    options += ["--cache", str(wanted.cache.resolve())] if wanted.cache else []
    count, right = 0, 0
    for name in [*parts(), *map(str, files)]:
        short = Path(name).name
        if not wanted.only or short in wanted.only:
            figures = in_time(["--one", name, *options], wanted.limit)
            if figures.get("genus", 1):
                row = row_of(short, figures)
                count, right = count + 1, right + row.endswith("| ok |\n")
                yield row
    yield f"\n{right} of {count} in order.\n"


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.loops", description=__doc__.splitlines()[0])
    folder = ROOT.parent / "shared"
    parser.add_argument("--meshes", type=Path, default=os.environ.get("MSF_JAX_MESHES", folder / "meshes"))
    parser.add_argument("--wild", type=Path, default=os.environ.get("MSF_JAX_WILD", folder / "wild"))
    parser.add_argument("--only", type=lambda text: text.split(","), help="names of cases, with commas between")
    parser.add_argument("--oracle", type=Path, default=folder / "tools/loops.py", help="program that tells the rank")
    parser.add_argument("--limit", type=float, default=300, help="seconds for one case, with CGAL's and the oracle's")
    parser.add_argument("--cache", type=Path, help="folder that keeps CGAL's results")
    parser.add_argument("--output", type=Path, help="file for the table")
    parser.add_argument("--one", help=argparse.SUPPRESS)
    wanted = parser.parse_args()
    if wanted.cache:
        wanted.cache.mkdir(parents=True, exist_ok=True)
    if wanted.one:
        configure_jax()
        print(json.dumps(run_one(wanted.one, wanted.oracle, wanted.limit, wanted.cache), default=int))
        return
    publish(report(wanted), wanted.output)


if __name__ == "__main__":
    main()
