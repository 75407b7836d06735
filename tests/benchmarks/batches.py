"""A batch over generated meshes, five of them broken: one process, two, a Dask cluster of two, killed and resumed.

    python -m tests.benchmarks.batches [--meshes N]

Prints meshes per minute, and whether all tables are the same.
"""

import argparse
import csv
import os
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
import trimesh

from msf_jax import batch, ground_truth

BROKEN = 5


def make(folder: Path, num: int) -> list[Path]:
    """``num`` tubes along random curves, and five files that are no closed meshes."""
    for number in range(num):
        random = np.random.default_rng(number)
        stops = np.cumsum(random.normal(0, 1, (4, 3)) + [1.5, 0, 0], axis=0)
        points = trimesh.path.simplify.resample_spline(stops, count=60)
        radii = 0.25 + 0.1 * np.sin(np.linspace(0, random.uniform(3, 9), len(points)))
        ground_truth.swept_tube(points, radii, int(random.integers(8, 30)), "round").export(folder / f"{number}.off")
    ball = trimesh.creation.icosphere(2)
    nan = ball.vertices.copy()
    nan[3] = np.nan
    trimesh.Trimesh(ball.vertices, ball.faces[1:], process=False).export(folder / "open.off")
    trimesh.Trimesh(nan, ball.faces, process=False).export(folder / "nan.off")
    trimesh.Trimesh(ball.vertices, np.vstack([ball.faces, [[0, 1, 50]]]), process=False).export(folder / "fin.off")
    (folder / "cut.off").write_text((folder / "0.off").read_text()[:5000])
    (folder / "empty.off").write_text("")
    return sorted(folder.glob("*.off"))


def table(path: Path) -> list[dict[str, str]]:
    """The rows without what differs from run to run."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    return [{name: value for name, value in row.items() if name not in ("seconds", "output")} for row in rows]


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--meshes", type=int, default=200)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        root = Path(name)
        (root / "in").mkdir()
        paths = make(root / "in", arguments.meshes)
        batch.run(paths[:20], root / "warm", jobs=2)  # compiles
        tables = {}
        print("| run | computed | failed | s | meshes a minute |\n| --- | --- | --- | --- | --- |")

        def tell(what: str, done: batch.BatchResult, spent: float) -> None:
            tables[what] = table(done.manifest)
            rate = 60 * done.num_done / spent
            print(f"| {what} | {done.num_done} | {done.num_failed} | {spent:.0f} | {rate:.0f} |", flush=True)

        for jobs in (1, 2):
            start = time.perf_counter()
            done = batch.run(paths, root / f"out{jobs}", jobs=jobs)
            tell(f"{jobs} process{'es' if jobs > 1 else ''}", done, time.perf_counter() - start)
        out = root / "killed"
        command = [sys.executable, "-m", "msf_jax", "batch", str(root / "in"), str(out), "--jobs", "2", "-q"]
        process = subprocess.Popen(command, start_new_session=True)
        while len(list((out / batch.ROWS).glob("*.json"))) < arguments.meshes // 2:
            time.sleep(0.05)
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        start = time.perf_counter()
        done = batch.run(paths, out, jobs=2)
        tell("killed half-way, resumed", done, time.perf_counter() - start)
        import distributed

        with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
            start = time.perf_counter()
            done = batch.run(paths, root / "dask", scheduler=cluster.scheduler_address)
            tell("Dask, 2 workers", done, time.perf_counter() - start)
        first = next(iter(tables.values()))
        print("\nsame table:", all(rows == first for rows in tables.values()))


if __name__ == "__main__":
    import jax

    jax.config.update("jax_enable_x64", True)
    main()
