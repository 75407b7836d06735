"""Files that are not as they were written, or ask for too much: refused with a reason, and nothing else."""

import json
import os
import re
import subprocess
import sys

import numpy as np
import pytest
import trimesh
from conftest import blob
from file_cases import glb, gltf, tetrahedron_3mf, write_3mf

import msf_jax
from msf_jax import Config, ConfigError, MeshError, Tape
from msf_jax.app.cli import main
from msf_jax.meshes import checking, reading
from msf_jax.meshes.files import unpacking
from msf_jax.skeleton.formats.whole import plain_json
from msf_jax.skeleton.skeleton import curve_of

ONCE = Config(max_iterations=3)


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    """A tape and a curve of one mesh, as arrays by name."""
    folder = tmp_path_factory.mktemp("written")
    flow = msf_jax.contract(blob(5, 2), config=ONCE)
    flow.tape.save(folder / "tape.npz")
    flow.skeleton.save(folder / "skeleton.npz")
    found = {}
    for kind in ("tape", "skeleton"):
        with np.load(folder / f"{kind}.npz") as file:
            found[kind] = dict(file)
    return found


def load(kind, path):
    if kind == "tape":
        return Tape.load(path)
    return msf_jax.read_curve(path)


FORGED = [
    ("tape", "parts/0/stretches/0/left", lambda a: np.full_like(a, np.nan)),
    ("tape", "parts/0/tetrahedron", lambda a: -1 - a),
    ("tape", "node_row", lambda a: a + 10**6),
    ("tape", "edges", lambda a: a.astype(float)),
    ("tape", "is_inside", lambda a: a[:-1]),
    ("tape", "triangles", lambda a: a - 10**6),
    ("skeleton", "edges", lambda a: a.astype(float)),
    ("skeleton", "mesh_map", lambda a: a.astype(float)),
    ("skeleton", "radii", lambda a: -1 - a),
    ("skeleton", "edges", lambda a: a[1:]),
    ("skeleton", "vertices", lambda a: a.astype(np.int64)),
    ("skeleton", "areas", lambda a: a * np.nan),
    ("skeleton", "surface_faces", lambda a: a[:0]),
    ("skeleton", "surface_vertices", lambda a: np.ones_like(a)),
    ("skeleton", "input_of_vertex", lambda a: a.astype(float)),
]


@pytest.mark.parametrize(("kind", "name", "change"), FORGED)
def test_altered_arrays_are_refused(written, tmp_path, kind, name, change):
    """Types, shapes, ranges and indices."""
    assert name in written[kind], sorted(written[kind])
    np.savez(tmp_path / "file.npz", **written[kind])
    load(kind, tmp_path / "file.npz")
    np.savez(tmp_path / "file.npz", **written[kind] | {name: change(written[kind][name])})
    # The tests turn NumPy's warnings into errors; users see only warnings.
    with np.errstate(all="ignore"), pytest.raises(ConfigError, match=f"is no {kind}, or a damaged one"):
        load(kind, tmp_path / "file.npz")


PART = b'<components><component objectid="%d"/><component objectid="%d"/></components>'
TWICE = b"".join(b'<object id="%d">%s</object>' % (k + 1, PART % (k, k)) for k in range(1, 9))


@pytest.mark.parametrize(
    ("parts", "num"),
    [
        ({"build": b'<item objectid="1"/>'}, 1),
        ({"build": b'<item objectid="1" partnumber="A"/>' * 2}, 2),
        ({"more": TWICE, "build": b'<item objectid="9"/>'}, 256),
    ],
)
def test_every_item_and_part_of_a_3mf_is_read(tmp_path, parts, num):
    """Also those with one part number, and parts of parts: 2^8 tetrahedra."""
    objects = tetrahedron_3mf(1) + parts.pop("more", b"")
    vertices, faces = reading.read(write_3mf(tmp_path / "sound.3mf", objects, **parts))
    assert (len(vertices), len(faces), faces.max()) == (4 * num, 4 * num, 4 * num - 1)


def test_a_3mf_that_asks_for_too_much_or_shows_what_it_has_not_is_refused(tmp_path, monkeypatch):
    """Before its arrays are made."""
    monkeypatch.setattr(unpacking, "MOST_TRIANGLES", 40)
    monkeypatch.setattr(unpacking, "MOST_ELEMENTS", 50)
    mesh = tetrahedron_3mf(1)
    cases = {
        "over 50 elements that are no part of a mesh": {"objects": tetrahedron_3mf(1, b"<a/>" * 60)},
        "declares entities": {"objects": mesh, "before": b'<!DOCTYPE model [<!ENTITY a "ha">]>'},
        "triangles, which is too many": {"objects": b'<object id="1">%s</object>' % (PART % (1, 1))},
        "an object '1' in another, or twice": {"objects": mesh + mesh},
        "an object '7' that it does not have": {"objects": mesh, "build": b'<item objectid="7"/>'},
        "several models": {"objects": mesh, "build": b'<item objectid="1" path="/3D/a.model"/>'},
        "11 instances and 44 triangles": {"objects": mesh, "build": b'<item objectid="1"/>' * 11},
        r"unpacks to \d+ bytes: expected at most 10000000": {"objects": b" " * 20_000_000},
    }
    for says, parts in cases.items():
        with pytest.raises(MeshError, match=says):
            reading.read(write_3mf(tmp_path / "bomb.3mf", **parts))


def test_a_scene_that_shows_too_much_is_refused(tmp_path, monkeypatch):
    (tmp_path / "scene.gltf").write_text(json.dumps(gltf(nodes=30)))
    assert len(reading.read(tmp_path / "scene.gltf")[1]) == 30
    monkeypatch.setattr(unpacking, "MOST_INSTANCES", 20)
    with pytest.raises(MeshError, match="30 instances"):
        reading.read(tmp_path / "scene.gltf")


def changed_gltf(path, **changes):
    """A triangle as glTF, with members of its JSON changed: of the first accessor, buffer view, buffer or mesh."""
    document = gltf()
    for place, change in changes.items():
        document[place][0] |= change
        document[place][0] = {key: value for key, value in document[place][0].items() if value is not None}
    path.write_text(json.dumps(document))
    return path


@pytest.mark.parametrize(
    ("says", "changes"),
    [
        ("POSITION has no bufferView, and so no data", {"accessors": {"bufferView": None}}),
        ("accessors have 2400000012 bytes", {"accessors": {"bufferView": None, "count": 200_000_000}}),
        ("accessor 0 has 36 bytes: expected 2400000000", {"accessors": {"count": 200_000_000}}),
        ("accessor 0 has 36 bytes: expected 40", {"accessors": {"byteOffset": 4}}),
        ("buffer view 0 ends after its buffer", {"bufferViews": {"byteLength": 49}}),
        (r"buffer 0 has \d+ bytes: expected 4000000000", {"buffers": {"byteLength": 4_000_000_000}}),
        ("-1' for a count", {"accessors": {"count": -1}}),
    ],
)
def test_gltf_has_bytes_behind_its_numbers_before_it_is_loaded(tmp_path, monkeypatch, says, changes):
    assert len(reading.read(changed_gltf(tmp_path / "a.gltf"))[1]) == 1
    monkeypatch.setattr(trimesh, "load_scene", None)
    with pytest.raises(MeshError, match=says):
        reading.read(changed_gltf(tmp_path / "a.gltf", **changes))


@pytest.mark.slow  # writes files of many megabytes
def test_what_gltf_repeats_is_counted_before_it_is_loaded(tmp_path, monkeypatch):
    """A primitive, a node, and the bytes of a buffer."""
    monkeypatch.setattr(trimesh, "load_scene", None)
    document = gltf()
    repeated = {
        "its parts have 30000 instances": lambda d: d["meshes"][0].update(
            primitives=30_000 * d["meshes"][0]["primitives"]
        ),
        "30000 instances and 90000 triangles": lambda d: d.update(nodes=30_000 * d["nodes"]),
        "views have 14400012 bytes": lambda d: d["bufferViews"].extend(399_999 * d["bufferViews"][:1]),
    }
    for says, change in repeated.items():
        copy = json.loads(json.dumps(document))
        change(copy)
        (tmp_path / "a.gltf").write_text(json.dumps(copy))
        with pytest.raises(MeshError, match=says):
            reading.read(tmp_path / "a.gltf")


@pytest.mark.parametrize(
    ("module", "place"),
    [*((reading, place) for place in ("parts", "_as_vertices", "_as_faces")), (checking, "_checked")],
)
def test_a_lack_of_memory_is_an_error_of_the_mesh(tmp_path, monkeypatch, module, place):
    def fail(*_, **__):
        raise MemoryError

    monkeypatch.setattr(module, place, fail)
    with pytest.raises(MeshError, match="needs more memory than there is"):
        checking.prepare(changed_gltf(tmp_path / "a.gltf"))


PEAK = """
import sys
from msf_jax.meshes import reading
def peak(): return int(open("/proc/self/status").read().split("VmHWM:")[1].split()[0])  # rusage has the parent's, too
before = peak()
try: reading.read(sys.argv[1])
except reading.MeshError: pass
print((peak() - before) // 1000)
"""


@pytest.mark.system
def test_a_small_file_that_shows_as_much_as_it_may_needs_less_than_a_gigabyte(tmp_path):
    """In MB, with all attributes that are loaded."""
    ball = trimesh.creation.icosphere(5)
    ball.visual.vertex_colors = np.full((len(ball.vertices), 4), 200)
    num = unpacking.MOST_TRIANGLES // len(ball.faces) - 1
    path = glb(
        tmp_path / "balls.glb", lambda d: d["meshes"][0].update(primitives=num * d["meshes"][0]["primitives"]), ball
    )
    done = subprocess.run([sys.executable, "-c", PEAK, str(path)], capture_output=True, text=True, check=True)
    assert 300 < int(done.stdout) < 900


@pytest.mark.system
@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="there are no named pipes here")
def test_a_pipe_is_no_file(tmp_path):
    """Nobody writes to it, so that reading it would never end."""
    paths = [tmp_path / name for name in ("mesh.off", "x.npz", "x.swc", "x.json")]
    for path in paths:
        os.mkfifo(path)
    script = "import sys; from msf_jax.app.cli import main; a, *b = sys.argv[1:]\n"
    script += "sys.exit([main(['skeletonize', a]), *(main(['report', each]) for each in b)] != [2] * 4)"
    done = subprocess.run([sys.executable, "-c", script, *paths], capture_output=True, text=True, timeout=120)
    assert done.returncode == 0 and len(re.findall("is no file", done.stderr)) == 4


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("deep.json", "[" * 100_000),
        ("deeper.json", '{"report": ' + '{"a": ' * 100_000),
        ("list.json", "[]"),
        ("text.json", {"report": {"volume": "much"}}),
        ("infinite.json", {"report": {"volume": 1e999}}),
        ("flags.json", {"report": {"iterations": True}}),
        ("notes.json", {"report": {"notes": [[1]]}}),
        ("figures.json", {"report": {"figures": 3}}),
        ("cycles.json", {"report": {"cycles": 1, "genus": 1}}),
        ("radii.json", {"radii": [-5.0]}),
        ("edges.json", {"edges": [[0.7, 1.9]]}),
    ],
)
def test_a_report_that_is_none_or_has_no_curve_is_not_printed(tmp_path, capsys, name, content):
    if isinstance(content, dict):
        whole = json.loads(plain_json(curve_of(np.zeros((1, 3)), np.zeros((0, 2), dtype=np.int64), np.ones(1))))
        (tmp_path / name).write_text(json.dumps(whole))
        assert main(["report", str(tmp_path / name)]) == 0 and capsys.readouterr().out
        content = json.dumps(whole | content | {"report": whole["report"] | content.get("report", {})})
    (tmp_path / name).write_text(content)
    assert main(["report", str(tmp_path / name)]) == 2
    said = capsys.readouterr()
    assert f"{name}' has no curve" in said.err and not said.out


def test_a_place_before_the_file_is_damage(written, tmp_path):
    """What the list at the end of a file says of places in it may be anything."""
    path = tmp_path / "file.npz"
    np.savez(path, **written["skeleton"])
    content = path.read_bytes()
    path.write_bytes(content[:100] + content[2000:])
    with pytest.raises(ConfigError, match="is no skeleton, or a damaged one"):
        msf_jax.read_curve(path)


def test_escapes_are_not_sent_to_the_terminal(tmp_path, capsys):
    path = tmp_path / "curve.swc"
    path.write_text("# report: \x1b]0;owned\x07\x1b[2Jconverged\n1 0 0 0 0 1 -1\n")
    assert main(["report", str(path)]) == 0
    assert capsys.readouterr().out == "\\x1b]0;owned\\x07\\x1b[2Jconverged\n"
    assert main(["report", str(tmp_path / "\x1b[2Jnone.swc")]) == 2
    assert "\x1b" not in capsys.readouterr().err


def test_weights_are_no_pipe_and_no_deep_list(tmp_path):
    os.mkfifo(tmp_path / "pipe.json")
    (tmp_path / "deep.json").write_text("[" * 100_000)
    for name, says in (("pipe.json", "is not a regular file"), ("deep.json", "has no weights")):
        with pytest.raises(ConfigError, match=says):
            msf_jax.read_weights(tmp_path / name)


def curve_json(tmp_path, **changes):
    """The file of a curve of two nodes, with members changed, and those of its report."""
    skeleton = curve_of(np.array([[0.0, 0, 0], [1, 0, 0]]), np.array([[0, 1]]), np.ones(2))
    skeleton.save(tmp_path / "a.json")
    content = json.loads((tmp_path / "a.json").read_text())
    content |= changes | {"report": content["report"] | changes.get("report", {})}
    (tmp_path / "a.json").write_text(json.dumps(content))
    return tmp_path / "a.json"


@pytest.mark.parametrize(
    "changes",
    [
        {"radii": [1.0, -5.0]},
        {"radii": [1.0]},
        {"radii": [True, 1.0]},
        {"edges": [[0.7, 1.9]]},
        {"edges": [[0, 2]]},
        {"edges": []},
        {"edges": [[0, 1], [1, 0]]},
        {"edges": [[0, 1], [1, 1]], "report": {"cycles": 1}},
        {"report": {"components": 2}},
        {"report": {"cycles": 1}},
        {"edges": [[0, 2**70]]},
        {"edges": [0, 1]},
        {"edges": [[False, True]]},
        {"mesh_map": [0.0]},
        {"mesh_map": [[0]]},
        {"roots": [0.5]},
        {"openings": [2]},
        {"vertices": [[0.0, 0, 0], [1e308, 0, 0]]},
        {"vertices": [["0", 0, 0], [1, 0, 0]]},
        {"units": "\ud800"},
        {"units": 3},
        {"report": {"inside": 1e9}},
        {"report": {"inside": -0.1}},
        {"report": {"in_sheets": 2}},
        {"report": {"converged": "no"}},
        {"report": {"genus": -1}},
        {"report": {"loops": True}},
        {"report": {"doubts": "no"}},
    ],
)
def test_an_altered_json_is_no_curve(tmp_path, changes):
    msf_jax.read_curve(curve_json(tmp_path))
    with pytest.raises(ConfigError, match=r"'a\.json' has no curve"):
        msf_jax.read_curve(curve_json(tmp_path, **changes))
