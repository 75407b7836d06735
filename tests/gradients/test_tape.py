"""The tape as a thing of its own: saved, loaded, refused."""

import json

import jax
import numpy as np
import pytest
import trimesh
from conftest import blob

import msf_jax
from msf_jax import Config, ConfigError, MeshError, PreprocessingOptions, Tape

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
    assert repr(flow.tape) == f"Tape({len(flow.curve.vertices)} nodes, mesh {flow.tape.mesh_id[:8]})"


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
    with pytest.raises(ConfigError, match="is 'msf_jax tape' of version 999, not 5"):
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
