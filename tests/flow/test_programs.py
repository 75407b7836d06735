"""Compiled steps: once for all processes, and with right sums."""

import os
import subprocess
import sys
from functools import partial
from pathlib import Path
from types import SimpleNamespace

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from device_cases import build, one_level, pebble
from jax.experimental.compilation_cache import compilation_cache
from jaxlib import utils  # pyright: ignore[reportAttributeAccessIssue]

import msf_jax
from msf_jax import Config, FlowOptions, SolverOptions, Weights
from msf_jax.base.clock import begin
from msf_jax.device.buffers import real_dtype, slot_product, slot_sum
from msf_jax.flow import programs

SETTINGS = Config(flow=FlowOptions(laplacian="uniform"), solver=SolverOptions(max_steps=49)).on_device
LAYOUTS = [one_level(64, 10), one_level(96, 10)]


def test_steps_from_the_cache_are_those_that_were_compiled(tmp_path, monkeypatch):
    """Two layouts, one compiled by the worker; read by a process that traces none; by one that finds one damaged. XLA
    prints no errors while they are looked up, and then prints them again. A short function stands for an iteration."""
    levels, traced, found, before = [], [], [], jax.config.jax_compilation_cache_dir
    monkeypatch.setattr(utils, "absl_set_min_log_level", levels.append)
    msf_jax.cache_compilations(tmp_path)
    weights = jax.tree.map(np.asarray, Weights())

    @partial(jax.jit, static_argnames=("settings", "layout"))
    def short(buffers, weights, settings, layout):
        traced.append(layout)
        return slot_sum(layout, jnp.sin(weights.w_L * buffers.positions[buffers.rings.neighbour, 0]))

    monkeypatch.setattr(programs, "jitted_move", short)
    for expected in (2, 2, 3):
        monkeypatch.setattr(programs, "_programs", {})
        jax.clear_caches()
        programs.compile_moves(SETTINGS, LAYOUTS, False)
        for layout in LAYOUTS:
            case = build(*pebble(3, 60), layout=layout)
            found.append(np.asarray(programs.compiled_move(SETTINGS, layout, False)(case.buffers, weights)))
        begin(int).result()  # the worker has written
        assert len(traced) == expected
        if len(found) == 4:
            min(tmp_path.glob("msf_jax-move-*")).write_bytes(b"no program")
    jax.config.update("jax_compilation_cache_dir", before)
    compilation_cache.reset_cache()
    assert set(levels) == {3, levels[-1]} == {3, int(os.environ.get("TF_CPP_MIN_LOG_LEVEL", "1"))}
    assert all(map(np.array_equal, found, 3 * found[:2])) and all(one.any() for one in found)


def test_a_thread_with_other_settings_gets_programs_of_its_own(monkeypatch):
    """The worker traces in float64, as the process does."""
    program = SimpleNamespace(compile=lambda **_: str(real_dtype()))
    monkeypatch.setattr(programs, "_programs", {})
    monkeypatch.setattr(programs, "_file", lambda _: None)
    monkeypatch.setattr(programs, "jitted_move", SimpleNamespace(lower=lambda *_: program))
    for dtype in ("float32", "float64"):
        with jax.enable_x64(dtype == "float64"):
            programs.compile_moves(SETTINGS, LAYOUTS, False)
            assert [programs.compiled_move(SETTINGS, layout, False) for layout in LAYOUTS] == [dtype] * 2


@pytest.mark.parametrize("dtype", ["float32", "float64"])
def test_sums_over_many_rows_are_those_of_numpy(dtype):
    """jaxlib 0.10.2 added wrongly from 16,385 rows on. All values are small whole numbers: sums are exact."""
    rows = 40_960
    layout = one_level(rows, 4)
    slots = np.arange(layout.num_slots)
    weights, neighbour = (slots % 5 - 2).astype(dtype), (slots * 7919 % rows).astype(np.int32)
    x = (np.arange(3 * rows).reshape(rows, 3) % 7 - 3).astype(dtype)
    products, sums = jax.jit(lambda w, n, x: (slot_product(layout, w, n, x), slot_sum(layout, w)))(
        weights, neighbour, x
    )
    by_slot = weights.reshape(4, rows)
    np.testing.assert_array_equal(sums, by_slot.sum(axis=0))
    np.testing.assert_array_equal(products, (by_slot[:, :, None] * x[neighbour.reshape(4, rows)]).sum(axis=0))


@pytest.mark.system
def test_a_library_call_prints_nothing_with_an_empty_and_with_a_full_cache(tmp_path):
    """Not even the false alarm of XLA in some versions, see `programs`."""
    program = f"""
import jax, msf_jax
from tests.benchmarks import ground_truth
jax.config.update("jax_enable_x64", True)
msf_jax.cache_compilations({str(tmp_path / "cache")!r})
msf_jax.skeletonize(ground_truth.make("straight_coarse").mesh)
"""
    names = {"PYTHONPATH": str(Path(__file__).parents[2]), "TF_CPP_MIN_LOG_LEVEL": "1"}
    for _ in range(2):
        command = [sys.executable, "-c", program]
        done = subprocess.run(command, capture_output=True, timeout=300, env=os.environ | names, cwd=tmp_path)
        assert (done.returncode, done.stderr, done.stdout) == (0, b"", b"")
    assert any((tmp_path / "cache").rglob("*"))
