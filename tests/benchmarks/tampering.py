"""Files that were altered, and files that unpack: for `tests/project/test_tampering.py`.

Altered: tapes, checkpoints and curves with bytes or arrays changed, by seed. One that was changed is refused, or gives
the curve that it would have given. Some have a digest made anew: those may give another curve, as a digest is no
signature, but never a traceback. Bombs: small files that ask for memory or time, each read in a process of 1 GB.
"""

import io
import json
import os
import struct
import subprocess
import sys
import tempfile
import traceback
import zipfile
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import trimesh

import msf_jax
from msf_jax import Config, ConfigError, FlowError, MeshError, Skeleton, Tape
from msf_jax.base import archive

LIMIT = 1_000_000_000  # bytes of address space
LONGEST = 60  # seconds
SHORT = Config(max_iterations=6, check=True)


def shape() -> trimesh.Trimesh:
    """A ball with a bump."""
    ball = trimesh.creation.icosphere(2)
    ball.vertices *= [1.0, 0.6, 0.5] * (1 + 0.3 * np.cos(3 * ball.vertices[:, :1]))
    return ball


def curve_of(kind: str, path: Path) -> bytes:
    """What the file at ``path`` gives: the bits of a curve, by loading it."""
    if kind == "tape":
        nodes = np.asarray(msf_jax.replay(Tape.load(path, shape()), Tape.load(path).weights))
        return nodes.tobytes()
    if kind == "checkpoint":
        found: Skeleton = msf_jax.skeletonize(shape(), config=SHORT, checkpoint=path)
    else:
        found = msf_jax.read_curve(path)
        msf_jax.follow(found, shape().vertices)
    return b"".join(np.ascontiguousarray(each).tobytes() for each in (found.vertices, found.edges, found.radii))


def originals(folder: Path) -> dict[str, bytes]:
    """One file of each kind."""
    flow = msf_jax.contract(shape(), config=SHORT, checkpoint=folder / "checkpoint.npz")
    flow.tape.save(folder / "tape.npz")
    flow.skeleton.save(folder / "skeleton.npz")
    return {kind: (folder / f"{kind}.npz").read_bytes() for kind in ("tape", "checkpoint", "skeleton")}


def with_bytes_changed(content: bytes, random: np.random.Generator) -> bytes:
    """Some bytes others, left out, or put in."""
    start = int(random.integers(len(content)))
    end = min(len(content), start + int(random.choice([1, 4, 100])))
    filling = random.bytes(end - start)
    return [content[:start] + filling + content[end:], content[:start] + content[end:], content[:start]][
        random.integers(3)
    ]


def with_an_array_changed(content: bytes, random: np.random.Generator, *, forge: bool) -> bytes:
    """One array, or one number of the header, is another; the digest is made anew if it is to be forged."""
    with np.load(io.BytesIO(content)) as file:
        arrays: dict[str, Any] = {name: file[name] for name in file.files}
    digest = arrays.pop(archive.DIGEST)
    names = [name for name in arrays if name not in (archive.HEADER_ENTRY, "report")]
    name = str(random.choice([*names, archive.HEADER_ENTRY]))
    if name == archive.HEADER_ENTRY:
        header = json.loads(str(arrays[name]))
        _change_a_number(header, random)
        arrays[name] = np.array(json.dumps(header))
    else:
        arrays[name] = _changed(arrays[name], random)
        if arrays[name] is None:
            del arrays[name]
    header = json.loads(str(arrays.pop(archive.HEADER_ENTRY)))
    kind, version = header.pop("format").removeprefix("msf_jax "), header.pop("version")
    made = archive.packed(kind, version, header, arrays, compress=False)
    if forge:
        return made
    with np.load(io.BytesIO(made)) as file:
        arrays = {name: file[name] for name in file.files} | {archive.DIGEST: digest}
    stream = io.BytesIO()
    np.savez(stream, **arrays)
    return stream.getvalue()


def _changed(array: np.ndarray, random: np.random.Generator) -> Any:
    match int(random.integers(8)):
        case 0:
            return None
        case _ if array.dtype.kind not in "biuf":  # text is turned into no other numbers
            return np.array(1j)
        case 1:
            return array[: len(array) // 2] if array.ndim else array.astype(complex)
        case 2:
            return array.astype(np.float32 if array.dtype.kind != "f" else np.int64)
        case 3:
            return array[..., None]
        case 4:
            return ~array if array.dtype.kind == "b" else -array.astype(np.int64 if array.dtype.kind in "iu" else float)
        case 5:
            return random.permutation(array.ravel()).reshape(array.shape) if array.size > 1 else array + 1
        case 6:
            return np.full_like(array, 2**30 if array.dtype.kind == "i" else 1)
    changed = np.array(array)
    if changed.size:
        flat = changed.reshape(-1)
        place = random.integers(flat.size)
        flat[place] = (
            flat[place] ^ 1 if array.dtype.kind != "f" else random.choice([np.nan, np.inf, 1e30, random.normal()])
        )
    return changed


def _change_a_number(header: Any, random: np.random.Generator) -> None:
    places: list[tuple[Any, Any]] = []

    def visit(value: Any) -> None:
        for key, member in value.items() if isinstance(value, dict) else enumerate(value):
            if isinstance(member, dict | list):
                visit(member)
            elif key not in ("format", "version"):
                places.append((value, key))

    visit(header)
    if places:
        holder, key = places[random.integers(len(places))]
        holder[key] = [0.999, -1, "x", None, 10**12, True][random.integers(6)]


def try_files(seed: int, num: int) -> list[str]:
    """Print a table; returns what is wrong."""
    random, wrong, counts = np.random.default_rng(seed), [], Counter()
    allowed = ConfigError, MeshError, FlowError
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        whole = originals(folder)
        expected = {kind: curve_of(kind, folder / f"{kind}.npz") for kind in whole}
        for number in range(num):
            kind, change = list(whole)[number % 3], ("bytes", "array", "forged")[number // 3 % 3]
            if change == "bytes":
                content = with_bytes_changed(whole[kind], random)
            else:
                content = with_an_array_changed(whole[kind], random, forge=change == "forged")
            path = folder / f"{number}.npz"
            path.write_bytes(content)
            try:
                found = curve_of(kind, path)
            except allowed:
                outcome = "refused"
            except Exception:
                outcome = "FAILED"
                wrong.append(f"altered file {number}, {kind}, {change}: {traceback.format_exc()}")
            else:
                outcome = "the same curve" if found == expected[kind] else "another curve"
            if outcome == "another curve" and change != "forged":
                wrong.append(f"altered file {number}, {kind}, {change}: another curve was loaded")
            counts[kind, change, outcome] += 1
            path.unlink(missing_ok=True)
    outcomes = ("refused", "the same curve", "another curve", "FAILED")
    print(f"| file | altered | {' | '.join(outcomes)} |\n{'| --- ' * 6}|")
    for kind in whole:
        for change in ("bytes", "array", "forged"):
            print(f"| {kind} | {change} | {' | '.join(str(counts[kind, change, outcome]) for outcome in outcomes)} |")
    return wrong


def _zipped(name: str, text: bytes) -> bytes:
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as file:
        file.writestr(name, text)
    return stream.getvalue()


def _model(inside: bytes, before: bytes = b"", build: bytes = b'<item objectid="1"/>') -> bytes:
    space = b'xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02" unit="millimeter"'
    text = before + b"<model " + space + b"><resources>" + inside + b"</resources><build>" + build + b"</build></model>"
    return _zipped("3D/3dmodel.model", text)


def _mesh(number: int, inside: bytes = b"") -> bytes:
    corners = b"".join(
        b'<vertex x="%d" y="%d" z="%d"/>' % place for place in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))
    )
    sides = b"".join(
        b'<triangle v1="%d" v2="%d" v3="%d"/>' % face for face in ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2))
    )
    mesh = b"<vertices>" + corners + inside + b"</vertices><triangles>" + sides + b"</triangles>"
    return b'<object id="%d" type="model"><mesh>' % number + mesh + b"</mesh></object>"


def _of_itself(depth: int) -> bytes:
    """Ten parts of ten parts of ten parts."""
    parts = [_mesh(1)]
    for number in range(2, depth + 2):
        ten = b"".join(b'<component objectid="%d"/>' % (number - 1) for _ in range(10))
        parts.append(b'<object id="%d" type="model"><components>' % number + ten + b"</components></object>")
    return _model(b"".join(parts), build=b'<item objectid="%d"/>' % (depth + 1))


def _gltf(accessor: dict[str, Any], uri: str | None = None, nodes: int = 1) -> bytes:
    content: dict[str, Any] = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": list(range(nodes))}],
        "nodes": [{"mesh": 0}] * nodes,
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"componentType": 5126, "count": 3, "type": "VEC3", "bufferView": 0, **accessor},
            {"componentType": 5125, "count": 3, "type": "SCALAR", "bufferView": 1},
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": 36},
            {"buffer": 0, "byteOffset": 36, "byteLength": 12},
        ],
        "buffers": [{"byteLength": 48, "uri": uri or "data:application/octet-stream;base64," + "A" * 64}],
    }
    return json.dumps(content).encode()


def _repeated(what: str, num: int) -> bytes:
    """A glTF with its primitive, or its first buffer view, so many times."""
    document = json.loads(_gltf({}))
    if what == "meshes":
        document["meshes"][0]["primitives"] *= num
    else:
        document[what] += num * document[what][:1]
    return json.dumps(document).encode()


def strips(num: int, length: int = 10_000) -> bytes:
    """A binary glTF that has one strip of about ``length`` triangles, with all attributes, so many times."""
    places = np.stack([np.arange(length), np.arange(length) % 2, np.zeros(length)], axis=1).astype("<f4")
    corners = np.arange(length - 2)[:, None] + np.arange(3)
    attributes = {"POSITION": places, "NORMAL": places, "TEXCOORD_0": places[:, :2], "COLOR_0": np.ones((length, 4))}
    arrays = [corners.astype("<u4").ravel(), *(value.astype("<f4") for value in attributes.values())]
    start = np.cumsum([0, *(each.nbytes for each in arrays)]).tolist()
    primitive = {"attributes": {name: 1 + k for k, name in enumerate(attributes)}, "indices": 0}
    content = {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [primitive] * num}],
        "accessors": [
            {"componentType": kind, "count": len(each), "type": width, "bufferView": k}
            for k, (each, kind, width) in enumerate(
                zip(arrays, (5125, *[5126] * 4), ("SCALAR", "VEC3", "VEC3", "VEC2", "VEC4"), strict=True)
            )
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": first, "byteLength": each.nbytes}
            for first, each in zip(start[:-1], arrays, strict=True)
        ],
        "buffers": [{"byteLength": start[-1]}],
    }
    text = json.dumps(content).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I", len(text)) + b"JSON" + text + struct.pack("<I", start[-1]) + b"BIN\0"
    return b"glTF" + struct.pack("<II", 2, 12 + len(chunks) + start[-1]) + chunks + b"".join(map(bytes, arrays))


def _vertices(num: int) -> bytes:
    """Elements that do not compress to nothing: 40 bytes each."""
    places = np.random.default_rng(0).integers(0, 10**6, (num, 3)).tolist()
    return b"".join(b'<vertex x="%d" y="%d" z="%d"/>' % tuple(place) for place in places)


DECLARED = b'<?xml version="1.0"?><!DOCTYPE model [<!ENTITY a "ha">' + b"".join(
    b'<!ENTITY %c "%s">' % (98 + k, b"&%c;" % (97 + k) * 30) for k in range(8)
) + b"]>"  # fmt: skip

BOMBS: dict[str, Callable[[], bytes]] = {
    "empty elements.3mf": lambda: _model(_mesh(1, b"<a/>" * 50_000_000)),
    "100 MB.3mf": lambda: _model(_mesh(1, _vertices(2_500_000))),
    "vertices.3mf": lambda: _model(_mesh(1, b'<vertex x="0" y="0" z="0"/>' * 8_000_000)),
    "zeros.3mf": lambda: _zipped("3D/3dmodel.model", b"<model>" + b"\0" * 2**30),
    "parts of parts.3mf": lambda: _of_itself(12),
    "entities.3mf": lambda: _model(_mesh(1) + b"&i;", DECLARED),
    "deep.3mf": lambda: _model(b"<a>" * 100_000 + b"</a>" * 100_000),
    "count.gltf": lambda: _gltf({"count": 3_000_000_000}),
    "without a view.gltf": lambda: _gltf({"count": 3_000_000_000, "bufferView": None}),
    "zeros.gltf": lambda: _gltf({"count": 200_000_000, "bufferView": None}),
    "primitives.gltf": lambda: _repeated("meshes", 300_000),
    "strips.glb": lambda: strips(12_000, 330),
    "views.gltf": lambda: _repeated("bufferViews", 500_000),
    "strides.gltf": lambda: _gltf({"type": "MAT4", "count": 3_000_000}),
    "endless.gltf": lambda: _gltf({}, "../../../../../../../../dev/zero"),
    "instances.gltf": lambda: _gltf({}, nodes=200_000),
    "wide.gltf": lambda: b'{"a":[' + b"{}," * 3_000_000 + b"{}]}",
    "nested.gltf": lambda: b'{"a":' * 1_000_000,
    "endless.obj": lambda: b"mtllib ../../../../../../../../dev/zero\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    "counts.off": lambda: b"OFF\n2000000000 2000000000 0\n0 0 0\n",
    "polygon.off": lambda: b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2000000000 0 1 2\n",
    "count.ply": lambda: (
        b"ply\nformat ascii 1.0\nelement vertex 1\nproperty list uint double x\nend_header\n4000000000 1 2 3\n"
    ),
    "counts.ply": lambda: (
        b"ply\nformat binary_little_endian 1.0\nelement vertex 2000000000\nproperty float x\n"
        b"property float y\nproperty float z\nelement face 2000000000\nproperty list uchar int vertex_indices\n"
        b"end_header\n" + bytes(60)
    ),
    "count.stl": lambda: bytes(80) + b"\xff\xff\xff\xff" + bytes(50),
    "pipe.off": bytes,
    "pipe.npz": bytes,
    "zeros.npz": lambda: _zipped("header.npy", bytes(2**30)),
    "deep.json": lambda: b"[" * 1_000_000,
    "deep too.json": lambda: b'{"report": ' + b'{"a": ' * 1_000_000,
    "text for numbers.json": lambda: json.dumps({"report": _report() | {"volume": "much"}}).encode(),
    "huge.obj": lambda: b"v 1e308 0 0\nv -1e308 0 0\nv 0 1e308 0\nf 1 2 3\n",
    "escapes.swc": lambda: b"# report: \x1b]0;owned\x07\x1b[2Jhello\n1 0 0 0 0 1 -1\n",
}

READ = """
import resource, sys
resource.setrlimit(resource.RLIMIT_AS, ({limit}, {limit}))
from msf_jax.base.errors import ConfigError, MeshError
try:
    if sys.argv[1].endswith(("npz", "json", "swc")):
        from msf_jax.skeleton.formats.importing import report_lines as lines_of
        print("read", *lines_of(sys.argv[1]))
    else:
        from msf_jax.meshes import reading
        print("read", len(reading.read(sys.argv[1])[1]))
except (ConfigError, MeshError) as error:
    print("refused:", error)
print(int(open("/proc/self/status").read().split("VmHWM:")[1].split()[0]) // 1000, "MB")
"""


def _report() -> dict[str, Any]:
    from msf_jax.skeleton.skeleton import curve_of as bare

    return bare(np.zeros((1, 3)), np.zeros((0, 2), dtype=np.int64), np.ones(1)).report.to_dict()


def try_bomb(name: str, folder: Path) -> tuple[str, str]:
    """What came of one: what is said, and what is wrong, empty if nothing is."""

    path = folder / name
    if name.startswith("pipe"):
        os.mkfifo(path)
    else:
        path.write_bytes(BOMBS[name]())
    command = [sys.executable, "-c", READ.format(limit=LIMIT), str(path)]
    environment = os.environ | {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
    size = 0 if name.startswith("pipe") else path.stat().st_size
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=LONGEST, env=environment)
    except subprocess.TimeoutExpired:
        return f"{size} bytes", f"{name}: no end in {LONGEST} s"
    finally:
        path.unlink()
    said = " ".join(done.stdout.split())
    if done.returncode or "\x1b" in said:
        return said[:100], f"{name}: {said[:200]!r} {done.stderr[-500:]}"
    return f"{size} bytes, {said[:60]} ... {said.split()[-2]} MB", ""


def try_bombs() -> list[str]:
    """Print a line for each; returns what is wrong."""
    wrong = []
    with tempfile.TemporaryDirectory() as folder:
        for name in BOMBS:
            said, fault = try_bomb(name, Path(folder))
            print(f"{name}: {said}", flush=True)
            wrong += [fault] if fault else []
    return wrong
