"""Compiled steps in a folder: found without compiling, whatever happens to the files."""

import importlib.metadata
import os
import subprocess
import sys
from pathlib import Path

import jax
import numpy as np
import pytest
from device_cases import build, one_level, pebble
from jax.experimental.compilation_cache import compilation_cache

import msf_jax
from msf_jax import Config, FlowOptions, SolverOptions, Weights
from msf_jax.flow import programs

SETTINGS = Config(flow=FlowOptions(laplacian="uniform"), solver=SolverOptions(max_steps=49)).on_device
LAYOUT = one_level(128, 16)


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """An empty one, which JAX keeps its programs in, for the length of a test."""
    before = jax.config.jax_compilation_cache_dir
    monkeypatch.setattr(programs, "_programs", {})
    msf_jax.cache_compilations(tmp_path)
    yield tmp_path / programs.KEPT
    jax.config.update("jax_compilation_cache_dir", before)
    compilation_cache.reset_cache()


@pytest.fixture(scope="module")
def case():
    return build(*pebble(3, 60), layout=LAYOUT)


def moved(case):
    """Positions and residuals after a step, by a program that this process has forgotten."""
    programs._programs.clear()
    weights = jax.tree_util.tree_map(np.asarray, Weights())
    found = jax.device_get(programs.compiled_move(SETTINGS, LAYOUT, False)(case.buffers, weights))
    programs._workers.shutdown()  # what is to be kept has been written
    programs._workers = programs.ThreadPoolExecutor(2)
    return found


def same(one, other):
    for a, b in zip(jax.tree_util.tree_leaves(one), jax.tree_util.tree_leaves(other), strict=True):
        np.testing.assert_array_equal(a, b)


def test_it_is_compiled_once_for_all_processes_and_damage_is_no_harm(case, folder, compilations):
    first = moved(case)
    (file,) = folder.iterdir()
    assert len(compilations) == 1
    whole = file.read_bytes()
    compilations.clear()
    same(moved(case), first)
    assert not compilations
    for damaged in (b"", whole[:1000], whole[:-1] + bytes([whole[-1] ^ 1]), _signed(b"no program")):
        file.write_bytes(damaged)
        same(moved(case), first)
        data = file.read_bytes()
        assert data != damaged and data[:32] == _signed(data[32:])[:32]


def _signed(data):
    return programs.hashlib.sha256(data).digest() + data


def test_another_machine_or_version_has_files_of_its_own(folder, monkeypatch):
    names = {programs._file("step")}
    for part in range(len(programs._machine())):
        other = list(programs._machine())
        other[part] += "+"
        with monkeypatch.context() as patch:
            patch.setattr(programs, "_machine", lambda other=other: tuple(other))
            names.add(programs._file("step"))
    assert len(names) == 1 + len(programs._machine())
    jax.config.update("jax_compilation_cache_dir", None)
    assert programs._file("step") is None


@pytest.mark.parametrize("package", ["jax", "jaxlib", "jaxopt"])
def test_another_version_of_what_is_compiled_has_files_of_its_own(package, monkeypatch):
    before, version = programs._machine(), importlib.metadata.version
    monkeypatch.setattr(importlib.metadata, "version", lambda name: "0.0" if name == package else version(name))
    assert programs._machine.__wrapped__() != before


@pytest.mark.system
def test_a_library_call_prints_nothing_with_an_empty_and_with_a_full_cache(tmp_path):
    """With the setting that hides a false alarm of XLA in some versions; see `cache_compilations`."""
    program = f"""
import jax, msf_jax
from msf_jax import ground_truth
jax.config.update("jax_enable_x64", True)
msf_jax.cache_compilations({str(tmp_path / "cache")!r})
msf_jax.skeletonize(ground_truth.make("straight_coarse").mesh)
"""
    names = {"PYTHONPATH": str(Path(__file__).parents[2]), "TF_CPP_MIN_LOG_LEVEL": "3"}
    for _ in range(2):
        command = [sys.executable, "-c", program]
        done = subprocess.run(command, capture_output=True, timeout=300, env=os.environ | names, cwd=tmp_path)
        assert (done.returncode, done.stderr, done.stdout) == (0, b"", b"")
    assert any((tmp_path / "cache").rglob("*"))
