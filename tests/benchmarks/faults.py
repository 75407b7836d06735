"""Everything that can be wrong with a mesh, tried on the whole program: a curve with a clean account, or a clear error.

    python -m tests.benchmarks.faults [files] [arrays] [topology] [geometry] [voids]

Prints a table: each kind of input, how many variants of it, and what came back without repair and with it. Whatever is
neither a curve with finite numbers nor a `MeshError` fails, and so does one that takes longer than a minute.
"""

import struct
import sys
import tempfile
import time
import traceback
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jax
import numpy as np
import trimesh
from scipy.spatial.transform import Rotation

import msf_jax
from msf_jax import FlowError, MeshError

BILLION = 1_000_000_000
LONGEST = 300.0  # seconds; what takes longer hangs
Pair = tuple[Any, Any]


def limb() -> trimesh.Trimesh:
    """A capsule that is not symmetric."""
    mesh = trimesh.creation.capsule(height=2.0, radius=0.4, count=[12, 14])
    mesh.vertices += 0.2 * np.sin(2 * mesh.vertices[:, [2, 2, 0]])
    return trimesh.Trimesh(mesh.vertices, mesh.faces, process=False)


def torus(around: int = 32, across: int = 12) -> trimesh.Trimesh:
    """A ring, its sampling as symmetric as can be."""
    return trimesh.creation.torus(1.0, 0.3, major_sections=around, minor_sections=across)


def pair(mesh: trimesh.Trimesh) -> tuple[np.ndarray, np.ndarray]:
    """Copies of its arrays."""
    return np.array(mesh.vertices, dtype=float), np.array(mesh.faces)


def joined(*meshes: Pair) -> Pair:
    """All of them in one pair."""
    start = np.cumsum([0, *(len(vertices) for vertices, _ in meshes)])
    faces = [np.asarray(faces) + first for (_, faces), first in zip(meshes, start[:-1], strict=True)]
    return np.concatenate([vertices for vertices, _ in meshes]), np.concatenate(faces)


def welded(mesh: Pair) -> Pair:
    """With vertices in one place made one."""
    vertices, inverse = np.unique(np.round(mesh[0], 9), axis=0, return_inverse=True)
    return vertices, inverse.ravel()[mesh[1]]


def box(at: tuple[float, float, float] = (0, 0, 0)) -> Pair:
    """A cube of edge 1, its faces subdivided."""
    vertices, faces = pair(trimesh.creation.box().subdivide().subdivide())
    return vertices + at, faces


def strip(twists: float) -> Pair:
    """A band of triangles with so many half turns."""
    angle = np.arange(60) * 2 * np.pi / 60
    side, turn = np.repeat([-0.3, 0.3], 60), np.tile(twists * angle / 2, 2)
    x, y = ((1 + side * np.cos(turn)) * np.tile(way, 2) for way in (np.cos(angle), np.sin(angle)))
    a = np.arange(60)
    b, c, d = a + 60, (a + 1) % 60, (a + 1) % 60 + 60
    if twists % 2:  # the last side meets the first one turned over
        c[-1], d[-1] = d[-1], c[-1]
    return np.stack([x, y, side * np.sin(turn)], axis=1), np.concatenate(
        [np.stack([a, c, b], 1), np.stack([b, c, d], 1)]
    )


def inverted(mesh: trimesh.Trimesh) -> trimesh.Trimesh:
    found = mesh.copy()
    found.invert()
    return found


def together(*parts: trimesh.Trimesh) -> trimesh.Trimesh:
    return trimesh.util.concatenate(list(parts))


def hollow(seed: int) -> tuple[trimesh.Trimesh, int]:
    """A bar, turned at random, with one to three cavities in a row, balls or rings; and how many of these are rings."""
    random = np.random.default_rng(seed)
    num = int(random.integers(1, 4))
    size = random.uniform(1.6, 2.4, 2)
    parts = [trimesh.creation.box((2.0 * num, *size)).subdivide_to_size(0.5)]
    is_ring = random.random(num) < 0.4
    for place in range(num):
        ring = trimesh.creation.torus(1.0, 0.35, major_sections=24, minor_sections=12)
        cavity = ring if is_ring[place] else trimesh.creation.icosphere(2)
        cavity.apply_scale(random.uniform(0.3, 0.5))
        cavity.apply_transform(trimesh.transformations.random_rotation_matrix(random.random(3)))
        parts.append(inverted(cavity.apply_translation([2.0 * place - num + 1, *random.uniform(-0.1, 0.1, 2)])))
    turn = trimesh.transformations.random_rotation_matrix(random.random(3))
    return together(*parts).apply_transform(turn), int(is_ring.sum())


def knotted(seed: int) -> tuple[trimesh.Trimesh, int, float, np.ndarray]:
    """A closed tube that crosses itself once or three times in a plane; the genus of its union; its radius; its axis.

    The radius is that of the ball in the tube, which has twelve sides.
    """
    random = np.random.default_rng(seed)
    t, radius = 2 * np.pi * np.arange(96) / 96, random.uniform(0.2, 0.3)
    if random.random() < 0.6:
        path, genus = np.stack([2 * np.sin(t), random.uniform(1.0, 1.5) * np.sin(2 * t)], axis=1), 2
    else:
        path, genus = np.stack([np.sin(t) + 2 * np.sin(2 * t), np.cos(t) - 2 * np.cos(2 * t)], axis=1), 4
    ahead = np.roll(path, -1, axis=0) - np.roll(path, 1, axis=0)
    across = np.stack([-ahead[:, 1], ahead[:, 0]], axis=1) / np.linalg.norm(ahead, axis=1, keepdims=True)
    angle = 2 * np.pi * np.arange(12) / 12
    rings = path[:, None] + radius * np.cos(angle)[:, None] * across[:, None]
    height = np.broadcast_to(radius * np.sin(angle), rings.shape[:2])
    i, j = (each.ravel() for each in np.indices((96, 12)))
    a, b, c, d = (((i + k) % 96) * 12 + (j + m) % 12 for k, m in ((0, 0), (1, 0), (1, 1), (0, 1)))
    faces = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    mesh = trimesh.Trimesh(np.concatenate([rings, height[..., None]], axis=2).reshape(-1, 3), faces, process=False)
    turn = trimesh.transformations.random_rotation_matrix(random.random(3))
    axis = trimesh.transform_points(np.pad(path, ((0, 0), (0, 1))), turn)
    mesh = (mesh if mesh.volume > 0 else inverted(mesh)).apply_transform(turn)
    return mesh, genus, radius * np.cos(np.pi / 12), axis


def array_variants() -> dict[str, Any]:
    """Arguments that are no mesh, and arrays with wrong values."""
    vertices, faces = pair(limb())

    def changed(row: int, value: Any, of: np.ndarray = vertices) -> np.ndarray:
        copy = of.copy()
        copy[row] = value
        return copy

    return {
        "None": None,
        "a number": 3,
        "an empty list": [],
        "three arrays": (vertices, faces, faces),
        "no vertices": (np.empty((0, 3)), faces),
        "no faces": (vertices, np.empty((0, 3), dtype=int)),
        "flat vertices": (vertices[:, :2], faces),
        "text for vertices": (np.full((5, 3), "a"), faces),
        "complex vertices": (vertices + 1j, faces),
        "quads": (vertices, np.column_stack([faces, faces[:, 0]])),
        "faces of different length": (vertices, [[0, 1, 2], [0, 1, 2, 3]]),
        "faces of halves": (vertices, faces + 0.5),
        "whole faces as floats": (vertices, faces.astype(float)),
        "faces counted from 1": (vertices, faces + 1),
        "a negative index": (vertices, changed(3, [-1, 0, 1], faces)),
        "a huge index": (vertices, changed(3, [2**40, 0, 1], faces)),
        "one NaN": (changed(7, np.nan), faces),
        "one infinite": (changed(7, [0, np.inf, 0]), faces),
        "all NaN": (np.full_like(vertices, np.nan), faces),
        "lists": (vertices.tolist(), faces.tolist()),
        "float16": (vertices.astype(np.float16), faces),
        "uint8 faces": (vertices[:200], faces[(faces < 200).all(axis=1)].astype(np.uint8)),
        "Fortran order": (np.asfortranarray(vertices), np.asfortranarray(faces)),
    }


def topology_variants() -> dict[str, Any]:
    """Finite triangles that are no closed, oriented, manifold surface, or hardly one."""
    vertices, faces = pair(limb())
    random = np.random.default_rng(0)
    soup = vertices[faces].reshape(-1, 3), np.arange(3 * len(faces)).reshape(-1, 3)
    turned = faces.copy()
    turned[::2] = turned[::2, ::-1]
    inner = pair(limb())[0] * 0.5, faces
    corners, tetrahedron = np.eye(4)[:, :3], np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
    sphere = trimesh.creation.icosphere(2)
    half = sphere.vertices[sphere.faces].mean(axis=1)[:, 2] > 0
    pinch = pair(sphere)[0] + [0, 0, 1 - 1e-9], sphere.faces
    cube = box()
    rim = np.flatnonzero(cube[0][:, 2] == 0)
    rim = rim[np.argsort(np.arctan2(cube[0][rim, 1], cube[0][rim, 0]))]
    wall = np.stack([np.full(len(rim), len(cube[0])), rim, np.roll(rim, -1)], axis=1)
    return {
        "a hole": (vertices, faces[1:]),
        "many holes": (vertices, faces[random.random(len(faces)) > 0.1]),
        "half of it": (sphere.vertices, sphere.faces[half]),
        "a soup": soup,
        "a soup with gaps of 1e-9": (soup[0] + random.normal(0, 1e-9, soup[0].shape), soup[1]),
        "a soup with gaps of 1e-3": (soup[0] + random.normal(0, 1e-3, soup[0].shape), soup[1]),
        "faces twice": (vertices, np.concatenate([faces, faces[:50]])),
        "faces twice, turned": (vertices, np.concatenate([faces, faces[:50, ::-1]])),
        "everything twice": (vertices, np.concatenate([faces, faces])),
        "a corner twice": (vertices, np.concatenate([faces, [[0, 0, 5]]])),
        "random orientation": (vertices, turned),
        "inside out": (vertices, faces[:, ::-1]),
        "a fin": (np.concatenate([vertices, [[3.0, 3, 3]]]), np.concatenate([faces, [[*faces[9, :2], len(vertices)]]])),
        "a wall inside": (np.concatenate([cube[0], [[0, 0, 0]]]), np.concatenate([cube[1], wall])),
        "random faces": (vertices, random.integers(0, len(vertices), (300, 3))),
        "it and random faces": (vertices, np.concatenate([faces, random.integers(0, len(vertices), (60, 3))])),
        "two boxes that share a vertex": welded(joined(box(), box((1, 1, 1)))),
        "two boxes that share an edge": welded(joined(box(), box((1, 1, 0)))),
        "two boxes that share a face": welded(joined(box(), box((1, 0, 0)))),
        "two boxes that overlap": joined(box(), box((0.5, 0.3, 0.2))),
        "twice the same limb": joined((vertices, faces), (vertices, faces)),
        "nested, both outwards": joined((vertices, faces), inner),
        "nested, a cavity": joined((vertices, faces), (inner[0], faces[:, ::-1])),
        "two spheres that touch": welded(joined(pair(sphere), pinch)),
        "a band": strip(2),
        "a Moebius band": strip(1),
        "one triangle": (vertices[:3], [[0, 1, 2]]),
        "two triangles back to back": (vertices[:3], [[0, 1, 2], [0, 2, 1]]),
        "a tetrahedron": (corners, tetrahedron),
        "unused vertices": (np.concatenate([vertices, random.normal(size=(20, 3))]), faces),
        "250 crumbs": joined((vertices, faces), *(((corners + k) * 1e-3, tetrahedron) for k in range(250))),
    }


def geometry_variants() -> dict[str, Any]:
    """Sound surfaces with numbers that are hard."""
    vertices, faces = pair(limb())
    random = np.random.default_rng(0)
    short = vertices.copy()
    for a, b, _ in faces[::40]:
        short[b] = short[a] + 1e-12 * random.normal(size=3)
    on_face = vertices.copy()
    on_face[faces[50, 0]] = on_face[faces[50, 1:]].mean(axis=0)
    prism = trimesh.creation.cylinder(0.4, 2.0, sections=6).subdivide().subdivide()
    ball = trimesh.creation.icosphere(3)
    return {
        **{f"scale {scale:g}": (vertices * scale, faces) for scale in (1e-300, 1e-30, 1e-6, 1e6, 1e30, 1e150, 1e300)},
        **{f"{away:g} from the origin": (vertices + away, faces) for away in (1e3, 1e6, 1e9, 1e15)},
        **{f"{ratio:g} times as long": (vertices * [1, 1, ratio], faces) for ratio in (1e2, 1e4, 1e8)},
        **{f"flattened to {ratio:g}": (vertices * [1, 1, ratio], faces) for ratio in (1e-2, 1e-4, 1e-8, 0)},
        "edges of 1e-12": (short, faces),
        "a triangle without area": (on_face, faces),
        "all vertices in one place": (np.zeros_like(vertices), faces),
        "a cube of 8 vertices": pair(trimesh.creation.box()),
        "a cube": box(),
        "an icosahedron": pair(trimesh.creation.icosahedron()),
        "an icosphere": pair(ball),
        "a torus": pair(torus()),
        "a prism": pair(prism),
        "a turned prism": (prism.vertices @ Rotation.from_euler("xyz", [1, 2, 3]).as_matrix(), prism.faces),
        "on a lattice": (np.round(vertices * 8) / 8 + 1e-9 * vertices, faces),
        "jittered until it crosses itself": (vertices + random.normal(0, 0.05, vertices.shape), faces),
    }


def void_variants() -> dict[str, Any]:
    """Twelve solids with cavities, and twelve tubes that cross themselves, by seed."""
    cavities = {f"cavity {seed}": pair(hollow(seed)[0]) for seed in range(12)}
    return cavities | {f"crossing {seed}": pair(knotted(seed)[0]) for seed in range(12)}


def file_variants(folder: Path) -> dict[str, Any]:
    """Files that are not what they say."""
    vertex = "property float x\nproperty float y\nproperty float z\n"
    face = "property list uchar int vertex_indices\n"
    ply = f"element vertex {BILLION}\n{vertex}element face {BILLION}\n{face}end_header\n"
    off = str(limb().export(file_type="off"))
    files: dict[str, bytes | str] = {
        **{f"empty.{suffix}": "" for suffix in ("off", "obj", "ply", "stl")},
        **{f"binary.{suffix}": np.random.default_rng(0).bytes(5000) for suffix in ("off", "obj", "ply", "stl")},
        "billion.off": f"OFF\n{BILLION} {BILLION} 0\n0 0 0\n",
        "billion faces.off": f"OFF\n3 {BILLION} 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
        "negative.off": "OFF\n-5 -7 0\n0 0 0\n",
        "index.off": f"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 {BILLION}\n",
        "truncated.off": off[: len(off) // 2],
        "words.off": off.replace("0.4", "zero", 1),
        "ascii billion.ply": f"ply\nformat ascii 1.0\n{ply}0 0 0\n",
        "billion.ply": f"ply\nformat binary_little_endian 1.0\n{ply}" + "\0" * 50,
        "billion.stl": b"\0" * 80 + struct.pack("<I", 2**32 - 1) + b"\0" * 50,
        "solid.stl": "solid x\nfacet normal 0 0 1\nfacet normal 0 0 1\n",
        "index.obj": f"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 {BILLION}\n",
        "no vertices.obj": "f -1 -2 -3\n",
        "other file.obj": "mtllib /etc/passwd\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
        "an off.ply": off,
        "length.glb": b"glTF" + struct.pack("<IIII", 2, 2**32 - 1, 2**32 - 6, 0x4E4F534A),
        "from 0.obj": "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n",
        "before the first.obj": "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -4\n",
        "wide.obj": "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".encode("utf-16-le"),
        "cut off.stl": limb().export(file_type="stl")[:-7],
        "cut off too.stl": limb().export(file_type="stl_ascii")[:-30],
        "far.obj": "v 1e308 0 0\nv -1e308 0 0\nv 0 1e308 0\nf 1 2 3\n",
        "false list.ply": limb().export(file_type="ply", encoding="ascii").replace(b"\n3 ", b"\n4 ", 1),
        "nested.gltf": '{"a":' * 100_000,
        "archive.zip": "PK",
        "unknown.xyzzy": "0 0 0",
        "no suffix": off,
    }
    for name, content in files.items():
        (folder / name).write_bytes(content if isinstance(content, bytes) else content.encode())
    return {name: folder / name for name in [*files, "absent.off"]} | {"a folder": folder}


KINDS: dict[str, Callable[[], dict[str, Any]]] = {
    "arrays": array_variants,
    "topology": topology_variants,
    "geometry": geometry_variants,
    "voids": void_variants,
}


def wound(points: np.ndarray, corners: np.ndarray) -> np.ndarray:
    """(P,) winding number of the triangles (F, 3, 3) around each point, by solid angles."""
    winding = np.empty(len(points))
    for first in range(0, len(points), 64):
        rows = slice(first, first + 64)
        a, b, c = np.moveaxis(corners[None] - points[rows, None, None], 2, 0)
        la, lb, lc = (np.linalg.norm(x, axis=2) for x in (a, b, c))
        ab, bc, ca = ((x * y).sum(axis=2) for x, y in ((a, b), (b, c), (c, a)))
        above = (a * np.cross(b, c)).sum(axis=2)
        winding[rows] = np.arctan2(above, la * lb * lc + ab * lc + bc * la + ca * lb).sum(axis=1) / (2 * np.pi)
    return winding


def outcome(mesh: Any, *, repair: bool) -> str:
    """What comes of ``mesh``: "a curve" of a clean report, "a doubtful curve", "refused", or "FAILED: ..."."""
    start = time.perf_counter()
    try:
        skeleton = msf_jax.skeletonize(mesh, repair=repair)
    except (MeshError, FlowError) as error:
        found = "refused" if len(str(error)) > 20 else f"FAILED: says only {error}"
    except Exception:
        return f"FAILED: {traceback.format_exc()}"
    else:
        num = len(skeleton.vertices)
        is_whole = (
            num > 0
            and np.isfinite(skeleton.vertices).all()
            and np.isfinite(skeleton.radii).all()
            and ((skeleton.mesh_map >= 0) & (skeleton.mesh_map < num)).all()
            and ((skeleton.edges >= 0) & (skeleton.edges < num)).all()
            and skeleton.report.cycles == skeleton.report.genus
            and skeleton.report.components == skeleton.report.mesh_components
        )
        found = "a curve" if skeleton.report.is_sound else "a doubtful curve"
        found = found if is_whole else f"FAILED: the curve is not whole: {skeleton.report}"
        if skeleton.report.is_sound and not repair and len(skeleton.edges):
            points = skeleton.vertices[skeleton.edges].mean(axis=1)
            if (np.abs(wound(points, np.array(mesh[0])[np.array(mesh[1]).astype(int)])) < 0.5).any():
                found = "FAILED: a sound curve is outside of the given solid"
    return found if time.perf_counter() - start < LONGEST else "FAILED: too slow"


def main() -> int:
    """Print the table, and every failure."""
    failures, wanted = [], sys.argv[1:] or ["files", *KINDS]
    print("| kind | precision | variants | without repair | with repair |\n| --- | --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as folder:
        for is_double in (True, False):
            jax.config.update("jax_enable_x64", is_double)
            kinds = {"files": file_variants(Path(folder))} | {name: variants() for name, variants in KINDS.items()}
            for kind, variants in [(kind, kinds[kind]) for kind in wanted]:
                columns = []
                for repair in (False, True):
                    found = {name: outcome(mesh, repair=repair) for name, mesh in variants.items()}
                    bad = {name: text for name, text in found.items() if text.startswith("FAILED")}
                    failures += [f"{kind}, {name}, repair={repair}: {text}" for name, text in bad.items()]
                    counts = Counter("FAILED" if name in bad else text for name, text in found.items())
                    columns.append(", ".join(f"{count} {what}" for what, count in sorted(counts.items())))
                precision = "float64" if is_double else "float32"
                print(f"| {kind} | {precision} | {len(variants)} | {columns[0]} | {columns[1]} |", flush=True)
    print("\n\n".join(failures))
    return min(len(failures), 1)


if __name__ == "__main__":
    sys.exit(main())
