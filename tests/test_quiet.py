"""XLA's false alarm is kept off standard error, in a library call and on all threads; nothing else is, nor for long."""

import os
import subprocess
import sys
import threading
import warnings
from pathlib import Path

import pytest

from msf_jax.device.quiet import pass_on, quieten_cache, without_alarm

ALARM = b"E1123 1 cpu_aot_loader.cc:195] Loading XLA:CPU AOT result. Target machine feature is not supported.\n"


def test_the_alarm_is_kept_back_and_all_else_is_passed_on_right_after(capfd):
    with without_alarm():
        os.write(2, b"before\n" + ALARM + b"after, without an end of line")
        assert capfd.readouterr().err == ""
    assert capfd.readouterr().err == "before\nafter, without an end of line"
    os.write(2, ALARM)
    assert capfd.readouterr().err == ALARM.decode()


def test_what_is_held_back_can_be_passed_on_before(capfd):
    with without_alarm():
        os.write(2, b"the last words\n" + ALARM)
        pass_on()
        assert capfd.readouterr().err == "the last words\n"
    os.write(2, b"open\n")
    assert capfd.readouterr().err == "open\n"


def test_threads_that_overlap_restore_standard_error_once(capfd):
    inside, leave = threading.Barrier(5), threading.Event()

    def load(number: int) -> None:
        with without_alarm():
            os.write(2, ALARM + f"line {number}\n".encode())
            inside.wait()
            leave.wait(0.05 * number)

    threads = [threading.Thread(target=load, args=(number,)) for number in range(4)]
    for thread in threads:
        thread.start()
    inside.wait()
    for thread in threads:
        thread.join()
    os.write(2, b"open again\n")
    lines = capfd.readouterr().err.splitlines()
    assert sorted(lines[:4]) == [f"line {number}" for number in range(4)] and lines[4:] == ["open again"]


def test_an_error_inside_is_raised_and_standard_error_restored(capfd):
    try:
        with without_alarm():
            raise RuntimeError("inside")
    except RuntimeError:
        os.write(2, b"seen\n")
    assert capfd.readouterr().err == "seen\n"


def test_jax_has_the_place_where_it_loads_programs():
    """If not, a new JAX has moved it: find where, or the alarm is printed again."""
    assert quieten_cache() and quieten_cache()


@pytest.mark.system
def test_a_library_call_prints_nothing_with_an_empty_and_with_a_full_cache(tmp_path):
    program = f"""
import jax, msf_jax
from msf_jax import ground_truth
jax.config.update("jax_enable_x64", True)
msf_jax.cache_compilations({str(tmp_path / "cache")!r})
msf_jax.skeletonize(ground_truth.make("straight_coarse").mesh)
"""
    root = str(Path(__file__).parents[1])
    for _ in range(2):
        done = subprocess.run(
            [sys.executable, "-c", program],
            capture_output=True,
            timeout=300,
            env={name: value for name, value in os.environ.items() if name != "XLA_FLAGS"} | {"PYTHONPATH": root},
            cwd=tmp_path,
        )
        assert (done.returncode, done.stderr, done.stdout) == (0, b"", b"")
    assert any((tmp_path / "cache").rglob("*"))


@pytest.mark.parametrize("kind", [DeprecationWarning, FutureWarning])
def test_what_others_deprecate_among_themselves_fails_no_test(kind):
    """By the filters of `pyproject.toml`: a call from this project's code does."""
    for module in ("msf_jax.flow.loop", "tests.pages", "test_quiet", "conftest", "block"):
        with pytest.raises(kind):
            warnings.warn_explicit("old", kind, "file.py", 1, module)
    with warnings.catch_warnings(record=True) as shown:
        warnings.warn_explicit("old", kind, "file.py", 1, "scipy.spatial")
    assert [str(each.message) for each in shown] == ["old"]
    with pytest.raises(RuntimeWarning):
        warnings.warn_explicit("overflow", RuntimeWarning, "file.py", 1, "scipy.spatial")
