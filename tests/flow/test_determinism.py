"""The same bits in fresh processes, whatever the hash seed and the threads.

``MSF_JAX_PROCESSES`` processes are compared, 2 if it is not set. They compute in float32, which is what JAX does unless
it is told.
"""

import os
import subprocess
import sys
from concurrent.futures import Future
from pathlib import Path

import numpy as np
import pytest
from run_cases import flow_of

import msf_jax
from msf_jax.flow import starting
from tests.benchmarks import ground_truth

PROCESSES = int(os.environ.get("MSF_JAX_PROCESSES", "2"))
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
from msf_jax import shapes
config = msf_jax.Config().replace(flow={"threshold_min": 0.003})
run = loop.contract(shapes.hand(0.1), config=config)
digest = hashlib.sha256(repr(run.history).encode())
for array in (*jax.tree_util.tree_leaves(run.tape), *vars(run.skeleton).values()):
    if isinstance(array, np.ndarray):
        digest.update(array.tobytes())
print(len(run.history), digest.hexdigest())
"""


def test_limbs_from_another_thread_are_the_same(monkeypatch):
    """They are looked for while poles and the flow are computed; without pruning and ends nobody looks for them."""
    mesh, names = ground_truth.make("straight_coarse").mesh, []

    def at_once(function, *arguments):
        names.append(function.__name__)
        done = Future()
        done.set_result(function(*arguments))
        return done

    skeletons = [flow_of("straight_coarse").skeleton]
    monkeypatch.setattr(starting, "begin", at_once)
    skeletons.append(msf_jax.skeletonize(mesh))
    assert names == ["scales", "prepare", "_find_limbs"]
    np.testing.assert_array_equal(skeletons[0].vertices, skeletons[1].vertices)
    np.testing.assert_array_equal(skeletons[0].edges, skeletons[1].edges)
    flow = msf_jax.Config(least_slenderness=0.0, curve=msf_jax.CurveOptions(extend_tips=False))
    assert msf_jax.skeletonize(mesh, config=flow).num_leaves >= skeletons[0].num_leaves
    assert names[3:] == ["scales", "prepare"]


def start(threads, seed="0"):
    """The program in a process of its own, which prints how many iterations it took and a hash of everything."""
    environment = os.environ | {
        "PYTHONHASHSEED": seed,
        "OMP_NUM_THREADS": str(threads),
        "TF_CPP_MIN_LOG_LEVEL": "3",
        "XLA_FLAGS": "",  # with all optimisations
    }
    command = [sys.executable, "-c", PROGRAM, str(threads)]
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


@pytest.mark.system  # in float64 in one process; in others, the files of a curve: in test_batch
def test_the_same_bits_in_every_process():
    """Each compiles what it needs, with one thread or two."""
    (expected,) = results(PROCESSES)
    assert int(expected.split()[0]) > 5
