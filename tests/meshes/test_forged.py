"""Files that are not as they were written, or ask for too much: refused with a reason, and nothing else."""

import json
import os
import re
import subprocess
import sys
import zipfile

import numpy as np
import pytest
import trimesh
from conftest import blob
from file_cases import glb

import msf_jax
from msf_jax import Config, ConfigError, MeshError
from msf_jax.app.cli import main
from msf_jax.meshes import checking, reading, scenes


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    """A curve, as arrays by name."""
    path = tmp_path_factory.mktemp("written") / "skeleton.npz"
    msf_jax.skeletonize(blob(5, 2), config=Config(max_iterations=3)).save(path)
    with np.load(path) as file:
        return dict(file)


@pytest.mark.parametrize(
    ("name", "change"),
    [
        ("mesh_map", lambda a: a.astype(float)),
        ("radii", lambda a: -1 - a),
        ("edges", lambda a: a[1:]),
        ("areas", lambda a: a * np.nan),
        ("surface_faces", lambda a: a[:0]),
        ("surface_vertices", lambda a: np.ones_like(a)),
        ("edges", lambda a: a + 10**6),
        ("mesh_map", lambda a: a[:, None]),
        ("openings", lambda a: np.array([10**6])),
        ("vertices", lambda a: a + 1e300),
        ("vertices", lambda a: a.astype(str)),
        ("report", lambda a: np.array(json.dumps(json.loads(str(a)) | {"notes": [[1]]}))),
        ("report", lambda a: np.array(json.dumps(json.loads(str(a)) | {"inside": "all"}))),
        ("report", lambda a: np.array(json.dumps(json.loads(str(a)) | {"genus": None}))),
    ],
)
def test_altered_arrays_are_refused(written, tmp_path, name, change):
    """Types, shapes, ranges and indices; and places of arrays that are before the file."""
    path = tmp_path / "file.npz"
    np.savez(path, **written)
    msf_jax.read_curve(path)
    content = path.read_bytes()
    np.savez(path, **written | {name: change(written[name])})
    for forged in (path.read_bytes(), content[:100] + content[2000:]):
        path.write_bytes(forged)
        # The tests turn NumPy's warnings into errors; users see only warnings.
        with np.errstate(all="ignore"), pytest.raises(ConfigError, match="is no skeleton, or a damaged one"):
            msf_jax.read_curve(path)


def test_a_3mf_that_asks_for_too_much_or_shows_what_it_has_not_is_refused(tmp_path, monkeypatch):
    """Before its arrays are made."""
    monkeypatch.setattr(scenes, "MOST_TRIANGLES", 100)
    whole = trimesh.creation.box().export(file_type="3mf")
    (tmp_path / "a.3mf").write_bytes(whole)
    assert len(reading.read(tmp_path / "a.3mf")[1]) == 12
    with zipfile.ZipFile(tmp_path / "a.3mf") as file:
        name = next(name for name in file.namelist() if name.endswith(".model"))
        model = file.read(name).decode()
    item = re.search(r"<item [^>]*/>", model)[0]
    with zipfile.ZipFile(tmp_path / "sliced.3mf", "w") as file:
        stack = '<slicestack id="9"><slice ztop="1"><vertices><vertex x="0" y="0"/></vertices></slice></slicestack>'
        file.writestr(name, model.replace("<resources>", f"<resources>{stack}"))
    assert len(reading.read(tmp_path / "sliced.3mf")[1]) == 12
    for says, text in {
        "an object '1' twice": model.replace("</resources>", '<object id="1"/></resources>'),
        "an object '7' that it does not have": model.replace(item, '<item objectid="7"/>'),
        "several models": model.replace(item, item.replace("/>", ' path="/3D/a.model"/>')),
        "20 instances and 108 triangles": model.replace(item, 20 * item),
        r"unpacks to \d+ bytes: expected at most 10000000": model + " " * 20_000_000,
    }.items():
        with zipfile.ZipFile(tmp_path / "a.3mf", "w", zipfile.ZIP_DEFLATED) as file:
            file.writestr(name, text)
        with pytest.raises(MeshError, match=says):
            reading.read(tmp_path / "a.3mf")


@pytest.mark.parametrize(
    ("says", "place", "change"),
    [
        ("has no bufferView, and so no data", "accessors", {"bufferView": None}),
        (r"its accessors have \d+ bytes, but its buffers", "accessors", {"count": 200_000_000}),
        (r"its views have \d+ bytes, but its buffers", "bufferViews", {"byteLength": 10**9}),
        ("-1' for a count", "accessors", {"bufferView": -1}),
        ("-1' for a count", "accessors", {"count": -1}),
        ("30000 instances", "nodes", {}),
    ],
)
def test_gltf_asks_for_no_more_than_its_bytes_before_it_is_loaded(tmp_path, monkeypatch, says, place, change):
    def forge(document):
        if place == "nodes":
            document["nodes"] = [{"mesh": 0}] * 30_000
            document["scenes"] = [{"nodes": list(range(30_000))}]
        for each in document[place]:
            each |= change
            for name in [name for name, value in change.items() if value is None]:
                each.pop(name)

    monkeypatch.setattr(trimesh, "load_scene", None)
    with pytest.raises(MeshError, match=says):
        reading.read(glb(tmp_path / "a.glb", forge))


def test_a_lack_of_memory_while_a_file_is_read_is_an_error_of_the_mesh(tmp_path, monkeypatch):
    def fail(*_, **__):
        raise MemoryError

    monkeypatch.setattr(reading, "_meshes_of", fail)
    with pytest.raises(MeshError, match=r"too large.*MemoryError"):
        checking.prepare(glb(tmp_path / "a.glb"))


@pytest.mark.system
@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="there are no named pipes here")
def test_a_pipe_is_no_file(tmp_path):
    """Nobody writes to it, so that reading it would never end."""
    paths = [tmp_path / name for name in ("mesh.off", "x.npz", "x.swc")]
    for path in paths:
        os.mkfifo(path)
    script = "import sys; from msf_jax.app.cli import main; a, *b = sys.argv[1:]\n"
    script += "sys.exit([main(['skeletonize', a]), *(main(['report', each]) for each in b)] != [2] * 3)"
    done = subprocess.run([sys.executable, "-c", script, *paths], capture_output=True, text=True, timeout=120)
    says = "is a pipe or a device|is no file"
    assert done.returncode == 0 and len(re.findall(says, done.stderr)) == 3, done.stderr


def test_escapes_are_not_sent_to_the_terminal(tmp_path, capsys):
    path = tmp_path / "curve.swc"
    path.write_text("# report: \x1b]0;owned\x07\x1b[2Jconverged\n1 0 0 0 0 1 -1\n")
    assert main(["report", str(path)]) == 0
    assert capsys.readouterr().out == "\\x1b]0;owned\\x07\\x1b[2Jconverged\n"
    assert main(["report", str(tmp_path / "\x1b[2Jnone.swc")]) == 2
    assert "\x1b" not in capsys.readouterr().err
