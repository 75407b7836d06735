"""A run that was cut short, resumed: the same bits. Ctrl-C: a partial curve. Files from strangers: refused."""

import io
import json
import signal
import threading
import zipfile

import numpy as np
import pytest
import trimesh
from conftest import torus
from run_cases import SLOW, assert_same_bits

import msf_jax
from msf_jax import Config, ConfigError, Interrupted, Tape, Weights
from msf_jax.base import archive
from msf_jax.flow import loop, programs, starting, stepping
from msf_jax.flow.state import Limits
from msf_jax.skeleton.formats import export

ONCE = Config(max_iterations=1)


@pytest.fixture(scope="module")
def mesh():
    """Two components, one with a handle."""
    ball = trimesh.creation.icosphere(2)
    ball.apply_scale([0.6, 0.4, 1.0])
    ball.apply_translation([3.0, 0, 0])
    return trimesh.util.concatenate([torus(), ball])


@pytest.fixture(scope="module")
def begun(mesh, tmp_path_factory):
    """The checkpoint of one iteration."""
    path = tmp_path_factory.mktemp("begun") / "run.npz"
    loop.contract(mesh, config=ONCE, checkpoint=path)
    return path.read_bytes()


@pytest.fixture(scope="module")
def undisturbed(mesh):
    return loop.contract(mesh, config=SLOW)


class Killed(Exception):
    """What `dying_after` raises."""


@pytest.fixture
def dying_after(monkeypatch):
    """A function that lets `loop.step` die, or do something else, in its n-th call from now."""

    def arrange(count, action=None):
        calls, step = [], loop.step

        def counted(*arguments):
            calls.append(1)
            if len(calls) == count:
                if action is None:
                    raise Killed
                action()
            return step(*arguments)

        monkeypatch.setattr(loop, "step", counted)
        return calls

    return arrange


@pytest.mark.parametrize("count", [pytest.param(4, marks=pytest.mark.slow), 8])
def test_a_run_that_died_goes_on_to_the_same_bits(mesh, undisturbed, dying_after, monkeypatch, tmp_path, count):
    """In the first or the second component, before the first write or after."""
    path = tmp_path / "run.npz"
    with monkeypatch.context():
        calls = dying_after(count)
        with pytest.raises(Killed):
            loop.contract(mesh, config=SLOW, checkpoint=path, limits=Limits(checkpoint_every=2))
        monkeypatch.undo()
    calls = dying_after(100)
    assert_same_bits(loop.contract(mesh, config=SLOW, checkpoint=path), undisturbed)
    first = sum(line.component == 0 for line in undisturbed.history)
    done = min(count - 1, first)  # iterations of the first component before it died, which is written when it ends
    kept = done if done == first else done // 2 * 2
    assert len(undisturbed.history) - len(calls) == kept + (count - 1 - done) // 2 * 2


@pytest.mark.slow  # one of a part of a run is above
def test_a_finished_checkpoint_gives_the_curve_again(mesh, undisturbed, dying_after, tmp_path):
    path = tmp_path / "run.npz"
    loop.contract(mesh, config=SLOW, checkpoint=path)
    dying_after(1)
    assert_same_bits(loop.contract(mesh, config=SLOW, checkpoint=path), undisturbed)


@pytest.mark.parametrize(
    ("change", "what"),
    [
        ({"weights": Weights(w_M=0.5)}, "weights"),
        ({"config": Config(max_iterations=6)}, "config"),
        ({"pins": [3]}, "pins"),
        ({"repair": True}, "repair"),
    ],
)
def test_another_run_does_not_go_on_from_it(mesh, begun, tmp_path, change, what):
    path = tmp_path / "run.npz"
    path.write_bytes(begun)
    with pytest.raises(ConfigError, match=f"is of another run, with another {what}: choose another path, or delete it"):
        loop.contract(mesh, **{"config": ONCE, **change}, checkpoint=path)
    assert path.read_bytes() == begun


def test_another_mesh_does_not_go_on_from_it(begun, tmp_path):
    path = tmp_path / "run.npz"
    path.write_bytes(begun)
    with pytest.raises(ConfigError, match="with another mesh"):
        loop.contract(torus(), config=ONCE, checkpoint=path)


@pytest.mark.slow
def test_the_two_ways_to_ask_for_repair_are_one_run(mesh, tmp_path):
    loop.contract(mesh, config=ONCE, checkpoint=tmp_path / "run.npz", repair=True)
    loop.contract(mesh, config=ONCE, checkpoint=tmp_path / "run.npz", repair=msf_jax.Repair())


def replaced(header, *keys, value):
    """``header`` with what ``keys`` leads to replaced, or left out."""
    inside = header
    for step in keys[:-1]:
        inside = inside[step]
    if value is None:
        del inside[keys[-1]]
    else:
        inside[keys[-1]] = value


@pytest.mark.parametrize(
    ("keys", "value"),
    [
        (("states",), 5),
        (("states",), {"list": [3]}),
        (("states", "list", 0, "members", "meso"), 3),
        (("states", "list", 0, "members", "meso"), None),
        (("states", "list", 0, "members", "history"), {"list": []}),
        (("states", "list", 0, "members", "other"), 1),
        (("states", "list", 0, "members", "t_c"), 1e9),
        (("states", "list", 0, "members", "meso", "members", "rings"), {"array": "0/meso/positions"}),
        (("states", "list", 0, "members", "steps", "list", 0, "record"), "Meso"),
    ],
)
def test_a_changed_checkpoint_is_a_clear_error(mesh, begun, tmp_path, keys, value):
    path = tmp_path / "run.npz"
    with np.load(io.BytesIO(begun)) as file:
        arrays = {name: file[name] for name in file.files}
    header = json.loads(str(arrays["header"]))
    replaced(header, *keys, value=value)
    kind, version = header.pop("format").removeprefix("msf_jax "), header.pop("version")
    arrays = {name: array for name, array in arrays.items() if name not in ("header", archive.DIGEST)}
    path.write_bytes(archive.packed(kind, version, header, arrays, compress=False))
    with pytest.raises(ConfigError, match="is no checkpoint, or a damaged one"):
        loop.contract(mesh, config=ONCE, checkpoint=path)


@pytest.mark.parametrize("content", [b"", b"precious notes", b"PK\x03\x04"])
def test_a_file_of_another_kind_is_left_alone(mesh, tmp_path, content):
    path = tmp_path / "run.npz"
    path.write_bytes(content)
    with pytest.raises(ConfigError, match=r"run.npz' is no checkpoint"):
        loop.contract(mesh, checkpoint=path)
    assert path.read_bytes() == content


def test_a_folder_or_no_folder_is_refused_before_the_run(mesh, tmp_path):
    for path in (tmp_path, tmp_path / "absent" / "run.npz"):
        with pytest.raises(ConfigError, match="cannot write a checkpoint"):
            loop.contract(mesh, checkpoint=path)


@pytest.mark.slow  # that a file which is written goes on is above
def test_a_full_disk_is_noted_and_nothing_is_lost(mesh, undisturbed, monkeypatch, tmp_path):
    path = tmp_path / "run.npz"

    def full(*_):
        raise OSError(28, "No space left on device", str(path))

    monkeypatch.setattr("msf_jax.base.archive.write_whole", full)
    run = loop.contract(mesh, config=SLOW, checkpoint=path)
    assert_same_bits(run, undisturbed)
    assert run.skeleton.report.notes[0].endswith("run.npz' could not be written: No space left on device")
    assert "No space left on device" in str(run.skeleton.report)


def test_ctrl_c_gives_a_partial_curve_and_the_checkpoint_goes_on(
    mesh, undisturbed, dying_after, tmp_path, monkeypatch, ctrl_c
):
    path = tmp_path / "run.npz"
    started = []
    monkeypatch.setattr(loop, "init", lambda *given: started.append(given[1]) or starting.init(*given))
    dying_after(3, lambda: signal.raise_signal(signal.SIGINT))
    with pytest.raises(
        Interrupted, match=r"interrupted after 3 iterations: .*in this exception's flow; run it again"
    ) as at:
        loop.contract(mesh, config=SLOW, checkpoint=path)
    assert isinstance(at.value, KeyboardInterrupt)
    partial = at.value.flow
    assert len(partial.history) == 3
    report = partial.skeleton.report
    assert not report.converged and not report.is_sound and report.reason == "interrupted; not begun"
    assert started == [0]  # the second component costs nothing
    assert len(partial.skeleton.mesh_map) == len(mesh.vertices) and (report.components, report.mesh_components) == (
        1,
        2,
    )
    ball = mesh.vertices[:, 0] > 2
    away = np.linalg.norm(partial.skeleton.vertices - mesh.vertices[ball][:1], axis=1)
    assert partial.skeleton.mesh_map[ball][0] == away.argmin()  # what was not begun goes to the nearest node
    assert report.loops == report.cycles == report.genus == 1
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    monkeypatch.undo()
    assert_same_bits(loop.contract(mesh, config=SLOW, checkpoint=path), undisturbed)


def test_a_second_ctrl_c_stops_at_once(mesh, dying_after, ctrl_c):
    def twice():
        signal.raise_signal(signal.SIGINT)
        signal.raise_signal(signal.SIGINT)

    dying_after(2, twice)
    with pytest.raises(KeyboardInterrupt) as at:
        loop.contract(mesh, config=SLOW)
    assert not isinstance(at.value, Interrupted)
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


@pytest.mark.slow  # threads that prune are in test_caps
def test_threads_do_not_disturb_each_other(mesh, undisturbed, tmp_path):
    """Two runs at once in one process, with a checkpoint each: the same bits as alone."""
    found = {}

    def run(number):
        found[number] = loop.contract(mesh, config=SLOW, checkpoint=tmp_path / f"{number}.npz")

    threads = [threading.Thread(target=run, args=(number,)) for number in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for number in range(2):
        assert_same_bits(found[number], undisturbed)


def moved_away(times):
    """A `compiled_move` whose first ``times`` calls leave numbers that run away."""
    calls = []

    def compiled(*program):
        move = programs.compiled_move(*program)

        def run(buffers, weights):
            calls.append(float(weights.w_L))
            moved = move(buffers, weights)
            bad = np.full_like(moved.positions, np.nan if len(calls) % 2 else 1e6)
            return moved._replace(positions=bad) if len(calls) <= times else moved

        return run

    return compiled, calls


@pytest.mark.slow
@pytest.mark.usefixtures("few_rows_once")
def test_a_step_that_ran_away_is_redone_shorter(mesh, monkeypatch):
    """With a tenth of the contraction, twice; the tape knows, and the report says so."""
    compiled, calls = moved_away(2)
    monkeypatch.setattr(stepping, "compiled_move", compiled)
    run = loop.contract(torus(), config=SLOW)
    np.testing.assert_allclose(calls[:4], [1.0, 0.1, 0.01, 1.0])
    assert [line.redone for line in run.history] == [2] + [0] * (len(run.history) - 1)
    assert run.skeleton.report.notes == ("1 step was repeated with a smaller w_L: coordinates diverged",)
    nodes = np.asarray(msf_jax.replay(run.tape, run.weights))
    assert np.abs(nodes - run.curve.vertices).max() < 1e-9


def test_a_step_that_always_runs_away_ends_the_flow(monkeypatch):
    compiled, calls = moved_away(10**6)
    monkeypatch.setattr(stepping, "compiled_move", compiled)
    run = loop.contract(torus(), config=SLOW)
    assert len(calls) == 4 and not run.history
    assert run.skeleton.report.reason.startswith(
        "non-finite: a step gave coordinates that are not finite or diverge, also when it was repeated 3 times"
    )
    assert np.isfinite(run.skeleton.vertices).all()


def test_a_surface_that_outgrows_its_capacity_ends_the_flow():
    mesh = trimesh.creation.capsule(height=4.0, radius=0.4, count=[24, 24])
    run = loop.contract(mesh, config=Config(coarsen=0.0), limits=Limits(growth=0, growth_margin=300))
    assert run.skeleton.report.reason == "out of vertices: the next split would give the surface more than 300 vertices"
    assert run.skeleton.report.cycles == 0


def entry(shape, size):
    """An ``.npy`` file that says it has ``shape``."""
    stream = io.BytesIO()
    np.lib.format.write_array_header_1_0(stream, {"descr": "<f8", "fortran_order": False, "shape": shape})
    return stream.getvalue() + b"\0" * size


@pytest.mark.parametrize(
    ("entries", "says"),
    [
        ({"header.npy": entry((10**12,), 8)}, "claims 8000000000000 bytes"),
        ({"header.npy": entry((1,), 8), "x.npy": entry((1 << 40, 1 << 40), 8)}, "claims"),
        ({"header.npy": entry((1,), 8), "x.npy": b"\0" * 10**8}, "bytes unpack to"),
        ({"header.npy": b"cos\nsystem\n(S'true'\ntR."}, "is no tape, or a damaged one"),
    ],
)
@pytest.mark.parametrize("kind", ["tape", "checkpoint"])
def test_a_strangers_file_takes_no_memory(mesh, tmp_path, entries, says, kind):
    path = tmp_path / "file.npz"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in entries.items():
            archive.writestr(name, content)
    with pytest.raises(ConfigError, match=says.replace("tape", kind)):
        _ = Tape.load(path) if kind == "tape" else loop.contract(mesh, checkpoint=path)


def test_nothing_that_runs_code_is_in_the_package():
    """No pickle, no eval, no exec."""
    package = list((export.Path(msf_jax.__file__).parent).rglob("*.py"))
    assert len(package) > 40
    for path in package:
        text = path.read_text()
        assert "import pickle" not in text and "allow_pickle=True" not in text
        assert not any(word in text for word in (" eval(", " exec(", "os.system", "shell=True"))


def test_what_compresses_too_well_is_written_as_it_is(tmp_path):
    """Zeros shrink a thousandfold, and a reader would take the file for a bomb."""
    path = tmp_path / "zeros.npz"
    archive.write(path, "thing", 1, {}, {"zeros": np.zeros(2_000_000)}, compress=True)
    with archive.reading(path, "thing", 1, "write it again") as (_, arrays):
        assert not arrays["zeros"].any()
    path.write_bytes(path.read_bytes()[:-300] + bytes(300))
    with pytest.raises(ConfigError, match="write it again"), archive.reading(path, "thing", 1, "write it again"):
        pass
