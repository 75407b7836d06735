"""A run that has to end: by Ctrl-C or its seconds, with the curve so far, whatever it does then."""

import os
import signal
import subprocess
import sys
import threading
import time

import pytest
from conftest import torus

import msf_jax
from msf_jax import Config, FlowError, FlowOptions, Interrupted
from msf_jax.app.cli import main
from msf_jax.base import clock
from msf_jax.base.clock import Clock, Stopped, begin, begin_in_turn
from msf_jax.curve import finishing
from msf_jax.flow import loop, starting

SLOW = Config(flow=FlowOptions(threshold_min=0.003))


@pytest.fixture(scope="module")
def mesh():
    return torus()


def pressing(monkeypatch, module, name, when=1):
    """Let the ``when``-th call of a function press Ctrl-C before it computes."""
    function, calls = getattr(module, name), []

    def pressed(*given, **options):
        calls.append(given)
        if len(calls) == when:
            signal.raise_signal(signal.SIGINT)
        return function(*given, **options)

    monkeypatch.setattr(module, name, pressed)
    return calls


@pytest.mark.parametrize("when", [1, 3])
def test_ctrl_c_in_an_iteration_gives_the_curve_so_far(mesh, monkeypatch, ctrl_c, when):
    calls = pressing(monkeypatch, loop, "step", when)
    with pytest.raises(Interrupted, match=rf"interrupted after {when} iterations: the curve so far") as at:
        msf_jax.skeletonize(mesh, config=SLOW)
    assert len(calls) == when
    flow = at.value.flow
    assert flow.skeleton.report.reason == "interrupted" and not flow.skeleton.report.is_sound
    assert len(flow.history) == when and flow.skeleton.report.components == 1
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def test_a_second_ctrl_c_ends_at_once(mesh, monkeypatch, ctrl_c):
    monkeypatch.setattr(loop, "step", lambda *_: [signal.raise_signal(signal.SIGINT) for _ in range(2)])
    with pytest.raises(KeyboardInterrupt) as at:
        msf_jax.skeletonize(mesh)
    assert not isinstance(at.value, Interrupted)


def test_before_the_first_iteration_there_is_no_curve(mesh, monkeypatch, ctrl_c, tmp_path, capsys):
    with pytest.raises(FlowError, match=r"max_seconds \(0\) reached before the first iteration has ended"):
        msf_jax.skeletonize(mesh, config=Config(max_seconds=0))
    pressing(monkeypatch, starting, "_coarsened")
    with pytest.raises(KeyboardInterrupt, match="before the first iteration has ended: there is no curve yet"):
        msf_jax.skeletonize(mesh)
    mesh.export(tmp_path / "torus.off")
    pressing(monkeypatch, starting, "_coarsened")
    assert main(["skeletonize", str(tmp_path / "torus.off"), "-q"]) == 130
    assert "interrupted" in capsys.readouterr().err
    assert [path.name for path in tmp_path.iterdir()] == ["torus.off"]


def test_finishing_ends_between_two_passes(mesh, monkeypatch):
    """The curve is that of the passes before, and nothing of it is proved."""
    monkeypatch.setattr(clock, "GRACE", 0.0)
    contain, clocks, init = finishing.contain, [], Clock.__init__

    def late(draft, job):
        clocks[0]._end, clocks[0]._why = 0.0, "it is late"
        return contain(draft, job)

    monkeypatch.setattr(Clock, "__init__", lambda self, *seconds: (clocks.append(self), init(self, *seconds))[1])
    monkeypatch.setattr(finishing, "contain", late)
    report = msf_jax.skeletonize(mesh, config=SLOW).report
    assert any("the run had to end before 1 of 1 curves had been finished" in note for note in report.notes)
    assert report.reason == "it is late" and not report.is_sound and "not proved" in report.doubts[0]


def test_what_follows_the_end_has_a_grace():
    over = Clock(max_seconds=0.0)
    with pytest.raises(Stopped):
        over.check()
    over.check()
    assert over.reason == "max_seconds (0) reached"
    over._end = time.monotonic()
    with pytest.raises(Stopped):
        over.check()


def test_what_is_begun_meanwhile_comes_before_the_next_of_several():
    done, pause = list[str](), threading.Event()
    several = begin_in_turn([lambda: pause.wait(60), lambda: done.append("next")])
    begin(done.append, "meanwhile")
    pause.set()
    several.result(60)
    assert done == ["meanwhile", "next"]
    with pytest.raises(ZeroDivisionError):
        begin_in_turn([lambda: 1 // 0, lambda: done.append("after an error")]).result(60)
    assert len(done) == 2


PROGRAM = """
import os, threading, time
from msf_jax.base.clock import begin, begin_in_turn
begin(int).result()
if os.fork() == 0:
    os._exit(begin(int).result(60))
print(os.waitstatus_to_exitcode(os.wait()[1]), end=" ")
def late():
    threading.main_thread().join()
    time.sleep(0.5)
    print(begin(sum, [1, 2]).result(), begin_in_turn([int, int]).result(), flush=True)
threading.Thread(target=late).start()
"""


@pytest.mark.system
@pytest.mark.skipif(not hasattr(os, "fork"), reason="this system has no fork")
def test_the_worker_is_there_in_a_forked_process_and_at_the_end_of_the_program():
    found = subprocess.run([sys.executable, "-c", PROGRAM], capture_output=True, text=True, timeout=300)
    assert found.stdout.split() == ["0", "3", "None"], found.stderr
