"""The tape as a thing of its own: saved, loaded, refused, compared."""

import json

import jax
import numpy as np
import pytest
import trimesh
from conftest import blob

import msf_jax
from msf_jax import Config, ConfigError, MeshError, PreprocessingOptions, Tape, Weights

pytestmark = pytest.mark.usefixtures("few_rows")


def mesh() -> trimesh.Trimesh:
    return blob(5, 2)


@pytest.fixture(scope="module")
def flow() -> msf_jax.Flow:
    return msf_jax.contract(mesh(), config=Config(preprocessing=PreprocessingOptions(reconstruct_mesh=60)))


@pytest.fixture
def path(flow, tmp_path):
    flow.tape.save(tmp_path / "run.npz")
    return tmp_path / "run.npz"


def test_what_is_loaded_is_what_was_saved(flow, path):
    loaded = Tape.load(path, mesh())
    (before, same), (after, structure) = jax.tree_util.tree_flatten(flow.tape), jax.tree_util.tree_flatten(loaded)
    assert same == structure
    for one, other in zip(before, after, strict=True):
        np.testing.assert_array_equal(one, other)


def test_a_run_is_not_changed_by_recording_it(flow):
    again = msf_jax.contract(mesh(), config=Config(preprocessing=PreprocessingOptions(reconstruct_mesh=60)))
    assert again.recording is not flow.recording
    np.testing.assert_array_equal(again.curve.vertices, flow.curve.vertices)
    assert flow.tape is flow.tape
    assert repr(flow.tape) == f"Tape({len(flow.curve.vertices)} nodes, {len(flow.tape.decisions)} decisions, " + (
        f"mesh {flow.tape.mesh_id[:8]})"
    )


def test_of_another_mesh(path):
    other = mesh()
    other.apply_scale(1.001)
    with pytest.raises(MeshError, match="tape is of another mesh: it was recorded for one of 162 vertices"):
        Tape.load(path, other)


def test_of_another_version(path):
    with np.load(path) as file:
        arrays = dict(file)
    arrays["header"] = np.array(json.dumps(json.loads(str(arrays["header"])) | {"version": 999}))
    np.savez(path, **arrays)
    with pytest.raises(ConfigError, match="is 'msf_jax tape' of version 999, not 4"):
        Tape.load(path)


def _cut_short(path):
    path.write_bytes(path.read_bytes()[:1000])


def _text(path):
    path.write_text("no tape at all")


def _other_arrays(path):
    np.savez(path, a=np.ones(3))


def _without_an_array(path):
    with np.load(path) as file:
        arrays = {name: file[name] for name in file.files if name != "parts/0/offset"}
    np.savez(path, **arrays)


def _objects(path):
    with np.load(path) as file:
        arrays = dict(file)
    arrays["edges"] = np.array([{}], dtype=object)
    np.savez(path, allow_pickle=True, **arrays)


def _other_shapes(path):
    with np.load(path) as file:
        arrays = dict(file)
    arrays["vertices"] = arrays["vertices"][:3]
    np.savez(path, **arrays)


def _flipped_bytes(path):
    data = bytearray(path.read_bytes())
    data[2000:2100] = bytes(100)
    path.write_bytes(data)


@pytest.mark.parametrize(
    "damage", [_cut_short, _text, _other_arrays, _without_an_array, _objects, _other_shapes, _flipped_bytes]
)
def test_what_is_no_tape(path, damage):
    damage(path)
    with pytest.raises(ConfigError, match=r"run.npz' is no tape"):
        Tape.load(path)


def test_files_that_cannot_be(flow, tmp_path):
    with pytest.raises(ConfigError, match=r"saved as .npz, not as '.swc'"):
        flow.tape.save(tmp_path / "run.swc")
    with pytest.raises(FileNotFoundError):
        Tape.load(tmp_path / "none.npz")
    with pytest.raises(FileNotFoundError):
        flow.tape.save(tmp_path / "none" / "run.npz")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.slow  # that every edit is one is below
def test_decisions_are_counted():
    """None for the same run; the more, the farther the weights are; the names of vertices do not depend on rows."""
    config = Config(max_iterations=4)
    first = msf_jax.contract(mesh(), config=config).tape
    same, near, far = (msf_jax.contract(mesh(), Weights(w_L=w_L), config).tape for w_L in (1.0, 1.001, 3.0))
    assert first.compare(same) == (0, len(first.decisions))
    shares = [first.compare(tape).different / len(tape.decisions) for tape in (near, far)]
    assert 0 < shares[0] < shares[1] <= 1
    assert first.compare(far).different - far.compare(first).different == len(far.decisions) - len(first.decisions)
    twice = mesh()
    twice.apply_scale(2.0)
    assert first.compare(msf_jax.contract(twice, config=config).tape) == (0, len(first.decisions))
    bumpy = mesh()
    bumpy.vertices *= 1 + 0.02 * np.sin(40 * bumpy.vertices[:, :1])
    moved = first.compare(msf_jax.contract(bumpy, config=config).tape)
    assert 0 < moved.different <= moved.total
    with pytest.raises(MeshError, match="meshes with different faces"):
        first.compare(msf_jax.contract(blob(5, 1), config=config).tape)


def test_every_edit_is_a_decision():
    flow = msf_jax.contract(mesh(), config=Config(coarsen=0.0))
    edits = sum(line.collapses + line.splits for line in flow.history)
    fixed = sum(
        len(edit.vertex)
        for step in flow.recording.components[0].steps
        for edit in step.edits
        if hasattr(edit, "vertex")
    )
    begun = sum(len(edit.new) for edit in flow.recording.components[0].start.edits)  # splits of long edges
    mapped = (flow.recording.components[0].node_of_meso >= 0).sum()
    assert len(flow.tape.decisions) == begun + edits + fixed + mapped
    assert len(np.unique(flow.tape.decisions)) == len(flow.tape.decisions)


@jax.jit
def replayed(tape, weights):
    """Nodes and radii."""
    nodes = msf_jax.replay(tape, weights)
    return nodes, msf_jax.replay_radii(tape, nodes)


def shapes(tape):
    return [np.shape(leaf) for leaf in jax.tree.leaves(tape)], jax.tree.structure(tape)
