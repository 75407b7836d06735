"""The same bits in fresh processes: whatever the hash seed and the threads, and after any number of kills.

``MSF_JAX_PROCESSES`` processes are compared, 2 if it is not set, and ``MSF_JAX_KILLS`` runs killed, 2 if it is not.
They compute in float32, which is what JAX does unless it is told.
"""

import os
import subprocess
import sys
import time
from concurrent.futures import Future
from pathlib import Path

import numpy as np
import pytest
from run_cases import flow_of

import msf_jax
from msf_jax import ground_truth
from msf_jax.base.clock import Clock

PROCESSES, KILLS = int(os.environ.get("MSF_JAX_PROCESSES", "2")), int(os.environ.get("MSF_JAX_KILLS", "2"))
ROOT = Path(__file__).parents[2]
PROGRAM = """
import hashlib, os, sys
threads = int(sys.argv[1])
if hasattr(os, "sched_setaffinity"):  # before XLA counts them
    os.sched_setaffinity(0, sorted(os.sched_getaffinity(0))[:threads])
import jax
import numpy as np
import msf_jax
from msf_jax.flow import loop
from msf_jax.flow.state import Limits
from msf_jax import shapes
checkpoint = sys.argv[2] if len(sys.argv) > 2 else None
often = Limits(checkpoint_every=1)
config = msf_jax.Config().replace(flow={"threshold_min": 0.003})
run = loop.contract(shapes.hand(0.1), config=config, checkpoint=checkpoint, limits=often)
digest = hashlib.sha256(repr(run.history).encode())
for array in (*jax.tree_util.tree_leaves(run.tape), *vars(run.skeleton).values()):
    if isinstance(array, np.ndarray):
        digest.update(array.tobytes())
print(len(run.history), digest.hexdigest())
"""


class AtOnce:
    """A pool that computes on the caller's thread, and knows what it was asked for."""

    def __init__(self):
        self.names = []

    def submit(self, function, *arguments):
        self.names.append(function.__name__)
        done = Future()
        done.set_result(function(*arguments))
        done.end = lambda: None
        return done


def test_limbs_from_another_thread_are_the_same(monkeypatch):
    """They are looked for while poles and the flow are computed; without pruning and ends nobody looks for them."""
    mesh = ground_truth.make("straight_coarse").mesh
    found = [flow_of("straight_coarse").skeleton]
    pool = AtOnce()
    monkeypatch.setattr(Clock, "begin", lambda _, *asked: pool.submit(*asked))
    found.append(msf_jax.skeletonize(mesh))
    assert pool.names == ["prepare", "_with_limbs"]
    np.testing.assert_array_equal(found[0].vertices, found[1].vertices)
    np.testing.assert_array_equal(found[0].edges, found[1].edges)
    flow = msf_jax.Config(least_slenderness=0.0, curve=msf_jax.CurveOptions(extend_tips=False))
    assert msf_jax.skeletonize(mesh, config=flow).num_leaves >= found[0].num_leaves
    assert pool.names[2:] == ["prepare"]


def start(threads, *checkpoint, seed="0"):
    """The program in a process of its own, which prints how many iterations it took and a hash of everything."""
    environment = os.environ | {
        "PYTHONHASHSEED": seed,
        "OMP_NUM_THREADS": str(threads),
        "TF_CPP_MIN_LOG_LEVEL": "3",
        "XLA_FLAGS": "",  # with all optimisations
    }
    command = [sys.executable, "-c", PROGRAM, str(threads), *map(str, checkpoint)]
    return subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, text=True, cwd=ROOT)


def result(process):
    output, _ = process.communicate(timeout=300)
    assert process.returncode == 0
    return output


def results(count):
    """What the program printed with other hash seeds, one thread or two, two processes at a time."""
    found = set()
    for number in range(0, count, 2):
        pair = [start(1 + k % 2, seed=str(k)) for k in range(number, min(number + 2, count))]
        found |= {result(process) for process in pair}
    return found


@pytest.mark.system  # in float64 in one process: in test_checkpoint; in others, the files of a curve: in test_batch
def test_the_same_bits_in_every_process_and_after_kills(tmp_path):
    """kill -9 at random moments; each time the next one goes on from what is in the file. Expected is what others print
    that are not killed, each of which compiles what it needs, with one thread or two."""
    path, random = tmp_path / "run.npz", np.random.default_rng(0)
    (expected,) = results(PROCESSES)
    assert int(expected.split()[0]) > 5
    num_killed = 0
    for _ in range(10 * KILLS):
        with start(2, path, seed="1") as process:
            wait_for_writes(process, path, int(random.integers(1, 5)))
            time.sleep(random.uniform(0, 0.05))
            if process.poll() is None:
                process.kill()
                num_killed += 1
            else:
                path.unlink()  # it had ended: once more from the start
        if num_killed == KILLS:
            break
    assert num_killed == KILLS
    assert result(start(2, path, seed="1")) == expected


def wait_for_writes(process, path, count):
    """Until ``path`` was written so many times, or the process has ended."""
    last = path.stat().st_mtime_ns if path.exists() else None
    while count and process.poll() is None:
        time.sleep(0.001)
        now = path.stat().st_mtime_ns if path.exists() else None
        count -= now != last
        last = now
