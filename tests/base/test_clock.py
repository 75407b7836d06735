"""Ctrl-C and ``max_seconds`` in every stage of a run: an answer at once, and what there is so far."""

import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import Future
from contextlib import suppress
from types import SimpleNamespace

import numpy as np
import pytest
from conftest import torus
from run_cases import SLOW, assert_same_bits

import msf_jax
from msf_jax import Config, ConfigError, FlowError, FlowOptions, Interrupted, SolverOptions
from msf_jax.app import cli
from msf_jax.app.cli import main
from msf_jax.base import clock as clocks
from msf_jax.base.clock import Clock, Stopped, counted
from msf_jax.curve import finishing
from msf_jax.flow import assembly, curves, loop, programs, starting, stepping
from msf_jax.meshes import reading
from msf_jax.meso import collapse
from msf_jax.meso.meso import Meso
from msf_jax.meso.ring_tables import faces_from_rings
from msf_jax.solid import solid as solids

PATIENT = 60  # seconds after which a test gives up that waits for a thread


@pytest.fixture(scope="module")
def mesh():
    return torus()


@pytest.fixture
def endless(monkeypatch, ctrl_c):
    """A function that makes another one press Ctrl-C when it is called, and then not return for a minute.

    It presses once, however often it is called. Its event is set when the call was ended by an exception.
    """

    def arrange(module, name):
        ended, presses = threading.Event(), [signal.SIGINT]

        def hang(*_, **__):
            try:
                for press in presses[:1]:
                    presses.clear()
                    signal.raise_signal(press)
                for _ in range(100 * PATIENT):
                    time.sleep(0.01)
            except BaseException:
                ended.set()
                raise
            raise AssertionError("nobody has ended it")

        monkeypatch.setattr(module, name, hang)
        return ended

    return arrange


@pytest.mark.parametrize(
    ("module", "name"),
    [
        (loop.checking, "prepare"),
        (loop, "Solid"),
        (starting, "_entered"),
        (starting, "_surface"),
        (starting.thickness, "scales"),
        (starting.homology, "ring_classes"),
        (starting, "_refined"),
        (starting, "_coarsened"),
        (starting, "_poles"),
    ],
)
def test_a_stage_before_the_first_iteration_is_ended_and_nothing_is_kept(mesh, endless, module, name):
    ended = endless(module, name)
    with pytest.raises(KeyboardInterrupt, match="before the first iteration has ended: there is no curve yet") as at:
        loop.contract(mesh)
    assert not isinstance(at.value, Interrupted)
    assert ended.wait(PATIENT)  # the abandoned thread does not go on
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def test_a_compiler_is_not_waited_for(mesh, monkeypatch, ctrl_c):
    program = Future()
    timer = threading.Timer(PATIENT, program.set_exception, [AssertionError("it was waited for")])
    timer.start()

    def announced(*_):
        signal.raise_signal(signal.SIGINT)
        monkeypatch.setattr(programs, "_announced", lambda *_: program)
        return program

    monkeypatch.setattr(programs, "_announced", announced)
    with pytest.raises(KeyboardInterrupt, match="there is no curve yet"):
        loop.contract(mesh)
    timer.cancel()


def test_tracing_is_ended_at_once(mesh, endless, monkeypatch):
    monkeypatch.setattr(programs, "_programs", {})
    monkeypatch.setattr(programs, "_file", lambda _: None)
    endless(programs, "_arguments")
    with pytest.raises(KeyboardInterrupt, match="there is no curve yet"):
        loop.contract(mesh)


def test_the_command_writes_nothing_before_the_first_iteration(mesh, endless, tmp_path, capsys):
    mesh.export(tmp_path / "torus.off")
    endless(starting, "_coarsened")
    assert main(["skeletonize", str(tmp_path / "torus.off"), "-q", "--checkpoint", str(tmp_path / "run.npz")]) == 130
    assert "there is no curve yet" in capsys.readouterr().err
    assert [path.name for path in tmp_path.iterdir()] == ["torus.off"]


@pytest.mark.slow  # one that ends late is in test_checkpoint
def test_an_iteration_that_does_not_end_is_left_out(mesh, endless, monkeypatch):
    step, whole = loop.step, loop.contract(mesh, config=SLOW)

    def third(state, *arguments):
        if len(state.history) == 2:
            endless(stepping.jax, "device_get")
        return step(state, *arguments)

    monkeypatch.setattr(loop, "step", third)
    with pytest.raises(Interrupted, match="interrupted after 2 iterations") as at:
        loop.contract(mesh, config=SLOW)
    assert at.value.flow.history == whole.history[:2]
    assert at.value.flow.skeleton.report.reason == "interrupted"


@pytest.mark.parametrize("name", ["prune_and_extend", "enforce_topology"])
def test_finishing_that_does_not_end_leaves_the_curve_so_far(mesh, endless, name):
    ended = endless(finishing, name)
    with pytest.raises(Interrupted) as at:
        loop.contract(mesh)
    skeleton = at.value.flow.skeleton
    report = skeleton.report
    assert ended.wait(PATIENT)
    assert not report.is_sound and not report.converged and report.reason == "interrupted"
    assert "the run had to end before 1 of 1 curves had been finished" in report.notes
    assert (report.cycles, report.components) == (1, 1)
    assert len(skeleton.mesh_map) == len(mesh.vertices) and skeleton.mesh_map.max() < len(skeleton.vertices)


def test_the_curve_so_far_waits_for_no_classes_of_loops(mesh, endless, monkeypatch):
    extract = curves.extraction.extract_curve
    ended = endless(curves.extraction, "extract_curve")
    hang = curves.extraction.extract_curve
    monkeypatch.setattr(
        curves.extraction,
        "extract_curve",
        lambda positions, rings, classes, pinned: (extract if classes is None else hang)(
            positions, rings, classes, pinned
        ),
    )
    with pytest.raises(Interrupted) as at:
        loop.contract(mesh)
    assert ended.wait(PATIENT)
    assert len(at.value.flow.skeleton.edges) and at.value.flow.skeleton.report.components == 1


@pytest.mark.slow  # that there is a curve so far is in other tests
@pytest.mark.usefixtures("few_rows_once")
def test_the_curve_so_far_is_that_of_a_thinner_surface(mesh, endless, monkeypatch):
    """The surface after one iteration has too many edges for the loop in Python that extracts the curve."""
    step, extract, given = loop.step, curves.extraction.extract_curve, []

    def second(state, *arguments):
        if state.history:
            endless(stepping.jax, "device_get")
        return step(state, *arguments)

    def seeing(positions, rings, classes, pinned):
        given.append((positions, rings))
        return extract(positions, rings, classes, pinned)

    monkeypatch.setattr(loop, "step", second)
    monkeypatch.setattr(curves.extraction, "extract_curve", seeing)
    config = Config(max_iterations=7, solver=SolverOptions(step_tolerance=0.1), flow=FlowOptions(threshold_max=0.1))
    with pytest.raises(Interrupted, match="interrupted after 1 iterations") as at:
        loop.contract(mesh, config=config)
    flow = at.value.flow
    for positions, rings in given:
        assert not collapse.collapse_short_edges(
            Meso.from_mesh(positions, faces_from_rings(rings)), config.flow.threshold_max
        )
        assert len(positions) < flow.history[-1].live / 2
    assert given and len(flow.meso_skeleton[0]) == flow.history[-1].live
    replayed = msf_jax.replay(flow.tape, flow.weights)
    np.testing.assert_allclose(replayed, flow.curve.vertices, rtol=0, atol=1e-9)


def test_a_curve_that_could_not_be_checked_is_not_sound(mesh, endless):
    endless(assembly, "assessed")
    with pytest.raises(Interrupted) as at:
        loop.contract(mesh)
    report = at.value.flow.skeleton.report
    assert report.doubts == (assembly.UNCHECKED,) and report.loops is None and not report.is_sound


@pytest.fixture
def a_second_each(monkeypatch):
    """A clock on which an iteration takes a second, and all the rest no time."""
    now, step = [100.0], loop.step

    class Time:
        perf_counter = staticmethod(time.perf_counter)

        @staticmethod
        def monotonic():
            return now[0]

    def counting(*arguments):
        state = step(*arguments)
        now[0] += 1.0
        return state

    monkeypatch.setattr(clocks, "time", Time)
    monkeypatch.setattr(loop, "step", counting)


def test_max_seconds_ends_a_run_with_the_curve_so_far(mesh, a_second_each, tmp_path):
    whole, path = loop.contract(mesh, config=SLOW), tmp_path / "run.npz"
    short = SLOW.replace(max_seconds=2.5)
    run = loop.contract(mesh, config=short, checkpoint=path)
    report = run.skeleton.report
    assert run.history == whole.history[:3]
    assert report.reason == "max_seconds (2.5) reached" and not report.converged and not report.is_sound
    assert report.cycles == report.loops == 1
    assert_same_bits(loop.contract(mesh, config=SLOW, checkpoint=path), whole)  # with more time it goes on


def test_max_seconds_before_the_first_iteration_is_an_error(mesh):
    with pytest.raises(FlowError, match=r"max_seconds \(1e-09\) reached before the first iteration has ended"):
        msf_jax.skeletonize(mesh, config=Config(max_seconds=1e-9))


@pytest.mark.slow  # a call that does is above
def test_the_command_keeps_the_checkpoint_of_a_run_out_of_time(mesh, a_second_each, tmp_path, capsys):
    mesh.export(tmp_path / "torus.off")
    asked = ["skeletonize", str(tmp_path / "torus.off"), "-o", str(tmp_path / "a.swc"), "--max-seconds", "1.5"]
    asked += ["--checkpoint", str(tmp_path / "run.npz")]
    assert main(asked) == 0
    shown = capsys.readouterr()
    assert "NOT converged: max_seconds (1.5) reached, after 2 iterations" in shown.out
    assert "the same command continues from" in shown.err and (tmp_path / "run.npz").exists()
    assert main(asked) == 0
    assert "after 4 iterations" in capsys.readouterr().out


@pytest.mark.parametrize("seconds", [-1.0, True, "60", float("nan")])
def test_max_seconds_is_a_number_or_none(seconds):
    with pytest.raises(ConfigError, match="max_seconds"):
        Config(max_seconds=seconds)


def test_a_press_that_other_code_swallows_is_kept(mesh, ctrl_c):
    with counted() as presses:
        assert presses is not None
        with suppress(BaseException):  # as in an import of an optional module
            signal.raise_signal(signal.SIGINT)
        with pytest.raises(KeyboardInterrupt, match="before the first iteration"):
            loop.contract(mesh)
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


@pytest.mark.parametrize("name", ["skeletonize", "shapes"])
def test_a_press_in_the_import_of_a_name_is_kept_until_its_end(monkeypatch, ctrl_c, name):
    done = []

    def imported(module):
        with suppress(BaseException):  # as a callback of JAX's
            signal.raise_signal(signal.SIGINT)
            done.append(module)
        return SimpleNamespace(**{name: module})

    monkeypatch.setattr("importlib.import_module", imported)
    monkeypatch.delitem(vars(msf_jax), name, raising=False)  # as before its first use
    with pytest.raises(KeyboardInterrupt):
        getattr(msf_jax, name)
    assert len(done) == 1  # it was not interrupted
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def test_the_import_of_jax_is_not_waited_for_and_not_interrupted(mesh, monkeypatch, ctrl_c, tmp_path, capsys):
    mesh.export(tmp_path / "torus.off")
    over, ended = threading.Event(), []

    def imported(name):
        if name == "jax":
            signal.raise_signal(signal.SIGINT)
            ended.append(over.wait(PATIENT))

    monkeypatch.setattr(cli, "importlib", SimpleNamespace(import_module=imported))
    assert main(["skeletonize", str(tmp_path / "torus.off"), "-q"]) == 130
    assert not ended and "interrupted" in capsys.readouterr().err
    assert [path.name for path in tmp_path.iterdir()] == ["torus.off"]
    over.set()
    while not ended:
        time.sleep(0.01)
    assert ended == [True]


@pytest.mark.parametrize(("module", "name"), [(reading, "read"), (loop.checking, "prepare")])
def test_the_seconds_of_a_command_count_from_its_begin(mesh, monkeypatch, tmp_path, capsys, module, name):
    mesh.export(tmp_path / "torus.off")
    ended = threading.Event()

    def hang(*_, **__):
        try:
            for _ in range(100 * PATIENT):
                time.sleep(0.01)
        finally:
            ended.set()

    monkeypatch.setattr(module, name, hang)
    assert main(["skeletonize", str(tmp_path / "torus.off"), "-q", "--max-seconds", "0.2"]) == 2
    assert "max_seconds (0.2) reached before the first iteration" in capsys.readouterr().err
    assert ended.wait(PATIENT)


def test_a_run_in_a_command_has_what_is_left_of_the_seconds(mesh, ctrl_c):
    with counted() as presses:
        assert presses is not None
        presses.begun -= PATIENT
        with pytest.raises(FlowError, match="reached before the first iteration has ended"):
            loop.contract(mesh, config=Config(max_seconds=PATIENT))


def test_ctrl_c_in_a_run_for_the_spread_gives_the_curve(mesh, monkeypatch, ctrl_c):
    scales, calls = starting.thickness.scales, []

    def second(*arguments):
        calls.append(arguments)
        if len(calls) == 2:
            signal.raise_signal(signal.SIGINT)
        return scales(*arguments)

    monkeypatch.setattr(starting.thickness, "scales", second)
    with pytest.raises(Interrupted, match="the whole curve is in this exception's flow") as at:
        msf_jax.skeletonize(mesh, jittered_runs=1)
    assert at.value.flow.skeleton.report.is_sound


def test_areas_are_made_beside_the_flow_and_not_after_it(mesh, monkeypatch):
    areas, seen = solids.triangle_areas, []

    def seeing(triangles):
        seen.append(threading.current_thread())
        return areas(triangles)

    monkeypatch.setattr(solids, "triangle_areas", seeing)
    loop.contract(mesh, config=SLOW)
    assert len(seen) == 1 and seen[0] is not threading.current_thread()


@pytest.mark.slow  # rare
def test_another_thread_than_the_main_one_computes_all_itself(mesh, monkeypatch, ctrl_c):
    """There, no Ctrl-C arrives. On the main one, the same stage is on a thread of its own, with the same bits."""
    scales, seen, found = starting.thickness.scales, [], []

    def seeing(*arguments):
        seen.append(threading.current_thread())
        return scales(*arguments)

    monkeypatch.setattr(starting.thickness, "scales", seeing)
    thread = threading.Thread(target=lambda: found.append(loop.contract(mesh, config=SLOW)))
    thread.start()
    thread.join()
    assert seen == [thread]
    assert_same_bits(loop.contract(mesh, config=SLOW), found[0])
    assert seen[1] not in (thread, threading.current_thread())


def test_a_call_has_the_callers_context_and_its_errors():
    clock = Clock(max_seconds=PATIENT)
    with np.errstate(divide="raise"), pytest.raises(FloatingPointError):
        clock.call(np.divide, 1.0, 0.0)
    assert clock.call(divmod, 7, 2) == (3, 1)
    over = Clock(max_seconds=0.0)
    with pytest.raises(Stopped):
        over.check()
    over.check()  # the time after it, in which the curve so far is finished
    assert over.reason == "max_seconds (0) reached"


PRESSED = """
import signal, sys, threading, time
signal.signal(signal.SIGINT, signal.default_int_handler)
from msf_jax.app import cli
from msf_jax.flow import starting

def hang(*_):
    threading.Thread(target=time.sleep, args=(60,)).start()  # as one that compiles
    time.sleep(0.2)
    signal.raise_signal(signal.SIGINT)
    time.sleep(60)

starting._coarsened = hang
sys.argv = ["msf-jax", "skeletonize", "torus.off", "-q"]
cli.command()
"""


@pytest.mark.system
def test_the_process_ends_with_its_message_and_waits_for_no_thread(mesh, tmp_path):
    mesh.export(tmp_path / "torus.off")
    done = subprocess.run([sys.executable, "-c", PRESSED], cwd=tmp_path, capture_output=True, text=True, timeout=50)
    assert done.returncode == 130 and "there is no curve yet" in done.stderr
    assert [path.name for path in tmp_path.iterdir()] == ["torus.off"]
