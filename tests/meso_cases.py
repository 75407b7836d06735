"""Surfaces for the tests of `meso`, and what is asked of a plain list of their faces."""

from collections import defaultdict

import numpy as np
import pytest
import trimesh
from conftest import blob, torus

from msf_jax.meso import ring_tables
from msf_jax.meso.meso import Meso
from msf_jax.solid.handles import Handles

OBTUSE = 110.0


def twisted_torus(twist: int = 5) -> trimesh.Trimesh:
    """A torus whose mesh lines wind ``twist`` times around the tube: a mesh of long, obtuse triangles."""
    mesh = torus()
    u, v = np.meshgrid(np.arange(24), np.arange(12), indexing="ij")
    phi, psi = 2 * np.pi * u.ravel() / 24, 2 * np.pi * v.ravel() / 12 + twist * 2 * np.pi * u.ravel() / 24
    ring = 1 + 0.35 * np.cos(psi)
    mesh.vertices = np.stack([ring * np.cos(phi), ring * np.sin(phi), 0.35 * np.sin(psi)], axis=1)
    return mesh


def meso_of(vertices: np.ndarray, faces: np.ndarray, seed: int = 0, fixed: float = 0.0) -> Meso:
    """The surface in units of its diagonal, with random poles, some of them missing, and a random part fixed."""
    random = np.random.default_rng(seed)
    meso = Meso.from_mesh(vertices / np.linalg.norm(np.ptp(vertices, axis=0)), np.asarray(faces))
    meso.poles = meso.positions + 0.05 * random.normal(size=meso.positions.shape)
    meso.has_pole = random.random(meso.num_rows) < 0.8
    meso.is_fixed = random.random(meso.num_rows) < fixed
    return meso


def case(name: str, load, fixed: float = 0.0) -> Meso:
    """A named surface: in code, or a research mesh."""
    made = {
        "torus": torus,
        "twisted torus": twisted_torus,
        "blob": lambda: blob(7),
        "two parts": lambda: trimesh.util.concatenate([blob(8, 2), torus().apply_translation([4, 0, 0])]),
    }
    vertices, faces = load(name) if name not in made else (lambda m: (m.vertices, m.faces))(made[name]())
    return meso_of(np.array(vertices), np.array(faces), seed=len(name), fixed=fixed)


def typical_length(meso: Meso) -> float:
    """Median length of the edges."""
    faces = meso.faces()
    return float(np.median(np.linalg.norm(meso.positions[faces] - meso.positions[faces[:, [1, 2, 0]]], axis=2)))


def turned(faces) -> set[tuple[int, int, int]]:
    """The faces as a set, each with its smallest corner first, orientation kept."""
    rows = [tuple(map(int, face)) for face in faces]
    return {min((a, b, c), (b, c, a), (c, a, b)) for a, b, c in rows}


def neighbours_of(faces) -> dict[int, set[int]]:
    """Neighbours of each vertex."""
    around: dict[int, set[int]] = defaultdict(set)
    for face in faces:
        for vertex in face:
            around[int(vertex)] |= {int(other) for other in face} - {int(vertex)}
    return around


def manifold_euler(faces) -> int:
    """V - E + F, having checked that every directed edge occurs once with its reverse and every vertex has one fan."""
    faces = [tuple(map(int, face)) for face in faces]
    directed = [edge for a, b, c in faces for edge in ((a, b), (b, c), (c, a))]
    assert len(set(directed)) == len(directed), "a directed edge occurs twice"
    assert {(b, a) for a, b in directed} == set(directed), "an edge has one face"
    step: dict[int, dict[int, int]] = defaultdict(dict)
    for a, b, c in faces:
        step[a][b], step[b][c], step[c][a] = c, a, b
    for follow in step.values():
        start = at = next(iter(follow))
        length = 0
        while length == 0 or at != start:
            at, length = follow[at], length + 1
        assert length == len(follow) >= 3, "a vertex has several fans, or is no vertex at all"
    return len(step) - len(directed) // 2 + len(faces)


SURFACES = ["torus", "twisted torus", "blob", "two parts", pytest.param("bunny", marks=pytest.mark.slow)]


def is_tetrahedron(around: dict[int, set[int]], a: int) -> bool:
    """Whether the component of ``a`` is a tetrahedron."""
    return len(around[a]) == 3 and all(around[b] == around[a] - {b} | {a} for b in around[a])


def ring_classes(vertices, faces, rings):
    """The classes of all edges, beside the rings."""
    return ring_tables.beside_rings(rings, faces, Handles(vertices, faces).half_edge_classes())


def class_of(meso, a, b):
    return int(meso.classes[a, np.flatnonzero(meso.rings[a] == b)[0]])


def loop_class(meso, loop):
    return sum(class_of(meso, a, b) for a, b in zip(loop, np.roll(loop, -1), strict=True))


def check_classes(meso):
    """Opposite half-edges have opposite classes, and around every face they add up to zero."""
    for a, b, c in meso.faces():
        assert class_of(meso, a, b) == -class_of(meso, b, a)
        assert loop_class(meso, [a, b, c]) == 0
