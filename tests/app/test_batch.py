"""Many meshes: the same table from processes and from a cluster, errors alone, nothing done twice."""

import csv
import multiprocessing.connection
import os
import shutil
import signal
import subprocess
import sys
import threading
import time
import warnings
from concurrent.futures import Executor, Future
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

import jax
import numpy as np
import pytest
import trimesh

from msf_jax import Config, ConfigError, Weights, batch
from msf_jax.app.cli import main

NUM, BROKEN = 5, 2
WORK = batch.work


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Capsules of several sizes in two folders, and two files that are no meshes."""
    folder = tmp_path_factory.mktemp("meshes")
    (folder / "more").mkdir()
    for number in range(NUM):
        mesh = trimesh.creation.capsule(height=1.0 + number, radius=0.4, count=[10 + number, 12])
        mesh.export(folder / ("more" if number % 2 else ".") / f"{number}.off")
    (folder / "broken.off").write_text("OFF\n3 1 0\n")
    mesh = trimesh.creation.icosphere(2)
    trimesh.Trimesh(mesh.vertices, mesh.faces[1:], process=False).export(folder / "more" / "open.ply")
    return folder


def paths_in(folder):
    return [path for path in folder.rglob("*") if path.suffix in (".off", ".ply")]


def table(path):
    """The rows of the table, without what differs from run to run."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        row["output"] = Path(row["output"]).name
        row.pop("seconds")
    return rows


class Here(Executor):
    """Does each job at once, in this thread."""

    def submit(self, call, /, *args, **options):
        future = Future()
        try:
            future.set_result(call(*args, **options))
        except Exception as error:
            future.set_exception(error)
        return future


@pytest.fixture
def here(monkeypatch):
    """No process is started: this one does the work of all. How many were asked for."""
    asked = []

    @contextmanager
    def alone(num, is_double):
        asked.append(num)
        yield Here()

    monkeypatch.setattr(batch, "_processes", alone)
    return asked


def test_what_failed_or_is_missing_or_has_other_settings_is_done_again(folder, here, tmp_path):
    paths = [folder / "0.off", folder / "broken.off", folder / "0.off"]
    done = batch.run(paths, tmp_path)
    assert [Path(row["path"]).name for row in done.rows if row["error"]] == ["broken.off"]
    assert [(row["is_sound"], row["not_limbs"]) for row in table(done.manifest)] == [("True", ""), ("", "")]
    assert (tmp_path / "0.off.swc").read_text().startswith("# curve skeleton")
    again = batch.run(paths, tmp_path)
    assert again.num_done == 0 and table(again.manifest) == table(done.manifest)
    assert batch.run(paths, tmp_path, retry=True).num_done == 1
    (tmp_path / "0.off.swc").unlink()
    assert batch.run(paths, tmp_path).num_done == 1
    assert batch.run(paths, tmp_path, weights=Weights(w_M=0.3)).num_done == 2
    with jax.enable_x64(False):  # as a user has it who forgot
        assert batch.run(paths[1:2], tmp_path).num_done == 1


def test_a_second_batch_into_a_folder_is_refused_meanwhile(folder, here, tmp_path, monkeypatch):
    first, second = [folder / "0.off", folder / "2.off"], [folder / "4.off"]

    def late(job):
        with pytest.raises(ConfigError, match="another batch writes to"):
            batch.run(second, tmp_path)
        return WORK(job)

    monkeypatch.setattr(batch, "work", late)
    assert batch.run(first, tmp_path).num_failed == 0
    monkeypatch.setattr(batch, "work", WORK)
    done = batch.run(second, tmp_path)
    assert [Path(row["path"]).name for row in table(done.manifest)] == ["0.off", "2.off", "4.off"]
    (tmp_path / "4.off.swc").unlink()  # a row without its curve is not in the table, nor one of other settings
    changed = batch.run(first[:1], tmp_path, weights=Weights(w_M=0.3))
    assert [Path(row["path"]).name for row in table(changed.manifest)] == ["0.off", "2.off"] and len(changed.rows) == 1


@pytest.fixture(scope="module")
def in_processes(folder, tmp_path_factory):
    """All of the folder, by two processes: what was done, and where."""
    out = tmp_path_factory.mktemp("out")
    return batch.run(paths_in(folder), out, jobs=2), out


@pytest.mark.system
def test_errors_stay_alone_and_a_second_run_does_nothing(folder, in_processes, tmp_path, request):
    done, out = in_processes
    assert (len(done.rows), done.num_done, done.num_failed) == (NUM + BROKEN, NUM + BROKEN, BROKEN)
    rows = {Path(row["path"]).name: row for row in table(done.manifest)}
    assert "the mesh is open" in rows["open.ply"]["error"] and "cannot read" in rows["broken.off"]["error"]
    assert rows["3.off"]["cycles"] == "0" and rows["3.off"]["converged"] == "True"
    before = (out / "0.off.swc").stat().st_mtime_ns
    again = batch.run(paths_in(folder), out, jobs=2)
    assert again.num_done == 0 and table(again.manifest) == table(done.manifest)
    assert (out / "0.off.swc").stat().st_mtime_ns == before
    request.getfixturevalue("here")  # what is left and what failed is chosen before a process is started
    shutil.copytree(out, tmp_path / "copied")
    (tmp_path / "copied" / "0.off.swc").unlink()
    assert batch.run(paths_in(folder), tmp_path / "copied", jobs=1, retry=True).num_done == 1 + BROKEN
    repaired = batch.run([folder / "more" / "open.ply"], tmp_path / "other", jobs=1, repair=True, suffix=".npz")
    assert repaired.num_failed == 0 and "filled 1 hole" in table(repaired.manifest)[0]["repairs"]


@pytest.mark.system
def test_a_cluster_gives_the_same_table(folder, in_processes, tmp_path):
    distributed = pytest.importorskip("distributed")
    done, out = in_processes
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # its own, on closing
        with distributed.LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=None) as cluster:
            asked = [path for path in paths_in(folder) if path.stem in ("0", "3", "open")]
            there = batch.run(asked, tmp_path / "there", scheduler=cluster.scheduler_address)
    assert there.num_done == 3
    assert table(there.manifest) == [r for r in table(done.manifest) if Path(r["path"]).stem in ("0", "3", "open")]
    for name in ("0.off.swc", "more/3.off.swc"):
        assert (tmp_path / "there" / name).read_bytes() == (out / name).read_bytes()


@pytest.mark.system
def test_killed_half_way_it_does_the_rest(folder, here, tmp_path):
    """kill -9 of all its processes, once some rows are there."""
    command = [sys.executable, "-m", "msf_jax", "batch", str(folder), str(tmp_path), "--jobs", "1", "-q"]
    process = subprocess.Popen(
        command, start_new_session=True, stderr=subprocess.DEVNULL, cwd=Path(__file__).parents[2]
    )
    rows, end = tmp_path / batch.ROWS, time.monotonic() + 120
    while len(list(rows.glob("*.json"))) < 3 and time.monotonic() < end:
        time.sleep(0.01)
    os.killpg(process.pid, signal.SIGKILL)
    process.wait()
    num_done = len(list(rows.glob("*.json")))
    assert 3 <= num_done < NUM + BROKEN
    done = batch.run(paths_in(folder), tmp_path, jobs=1)
    assert done.num_done == NUM + BROKEN - num_done
    assert len(table(done.manifest)) == NUM + BROKEN and done.num_failed == BROKEN


def dying(job):
    """A worker that is killed on one of the meshes, as by the system when memory runs out."""
    if job.source.endswith("2.off"):
        os.kill(os.getpid(), signal.SIGKILL)
    return WORK(job)


@pytest.mark.system
def test_a_worker_that_dies_takes_one_mesh_with_it(folder, tmp_path, monkeypatch):
    monkeypatch.setattr(batch, "work", dying)
    done = batch.run([folder / "0.off", folder / "2.off"], tmp_path, jobs=2)
    assert {Path(row["path"]).name: row["error"] for row in done.rows} == {"0.off": "", "2.off": batch.DIED}


def test_the_command_takes_what_skeletonize_takes_and_lists_what_failed(folder, tmp_path, monkeypatch, capsys):
    seen = {}
    rows = ({"path": "a.off", "error": ""}, {"path": "b.off", "error": "MeshError: the mesh is open"})
    done = batch.BatchResult(rows, tmp_path / "manifest.csv", 2, 1)
    monkeypatch.setattr(batch, "run", lambda *_, **options: seen.update(options) or done)
    options = ["--system", "tagliasacchi2012", "--w-M", "0.8", "--prune", "0", "--evaluate", "--jobs", "3"]
    assert main(["batch", str(folder), str(tmp_path), *options]) == 1
    assert seen["config"] == Config.tagliasacchi2012(least_slenderness=0.0, evaluate=True) and seen["jobs"] == 3
    assert seen["weights"] == replace(seen["config"].default_weights(), w_M=0.8)
    said = capsys.readouterr()
    assert "2 meshes, 2 of them now, 1 failed" in said.out and "b.off: MeshError: the mesh is open" in said.err
    for wrong, message in ((folder / "absent", "no folder"), (tmp_path, "no mesh in")):
        assert main(["batch", str(wrong), str(tmp_path / "out")]) == 2
        assert message in capsys.readouterr().err


def test_ctrl_c_ends_a_batch_with_the_rows_so_far(folder, here, tmp_path, monkeypatch, ctrl_c):
    def interrupted(running, **_):
        raise KeyboardInterrupt

    monkeypatch.setattr(batch, "wait", interrupted)
    paths = [folder / f"{number}.off" for number in (0, 2, 4)]
    with pytest.raises(KeyboardInterrupt, match="interrupted: 2 of 3 done; start again to go on"):
        batch.run(paths, tmp_path, jobs=1)
    assert len(table(tmp_path / batch.MANIFEST)) == 2


def endless(job):
    """A worker that does not end by itself, and says that it has begun."""
    Path(job.row).with_suffix(".begun").touch()
    time.sleep(600)


@pytest.mark.system
def test_workers_are_not_waited_for_after_ctrl_c(folder, tmp_path, monkeypatch, ctrl_c):
    monkeypatch.setattr(batch, "work", endless)

    def press():
        while not list((tmp_path / batch.ROWS).glob("*.begun")):
            time.sleep(0.05)
        os.kill(os.getpid(), signal.SIGINT)

    threading.Thread(target=press, daemon=True).start()
    with pytest.raises(KeyboardInterrupt, match="0 of 2 done"):
        batch.run([folder / "0.off", folder / "2.off"], tmp_path, jobs=2)
    for process in multiprocessing.active_children():
        # Its exit code would be None where the pool's own thread has just asked for it.
        assert multiprocessing.connection.wait([process.sentinel], 60)  # of 600 seconds


@pytest.mark.parametrize(
    ("options", "says"),
    [
        ({"paths": []}, "there are no meshes"),
        ({"paths": "a.off"}, "a list of paths"),
        ({"suffix": ".xyz"}, "expected one of the suffixes .swc"),
        ({"jobs": 0}, "jobs is 0: expected a whole number"),
        ({"weights": Weights(w_L=np.ones(3))}, "weights that are numbers"),
        pytest.param({"scheduler": "tcp://127.0.0.1:1"}, "no Dask scheduler at", marks=pytest.mark.system),
    ],
)
def test_options_are_checked(tmp_path, options, says):
    with pytest.raises(ConfigError, match=says):
        batch.run(**{"paths": ["a.off"], "out": tmp_path, **options})


def test_a_place_is_not_taken_by_another_mesh_or_file(here, tmp_path):
    """Names are relative to what the meshes of a call have in common: the same name can be another mesh's."""
    for folder in ("one", "two"):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / "x.off").write_text("no mesh")
    batch.run([tmp_path / "one" / "x.off"], tmp_path / "out", jobs=1)
    with pytest.raises(ConfigError, match="by an earlier batch"):
        batch.run([tmp_path / "two" / "x.off"], tmp_path / "out", jobs=1)
    (tmp_path / "link").symlink_to(tmp_path / "nothing")
    for taken in ("link", "one/x.off"):
        with pytest.raises(ConfigError, match=f"{taken}' is no folder: expected one"):
            batch.run(["a.off"], tmp_path / taken / "inner")
