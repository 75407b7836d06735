"""The compiled fronts against the same said in plain Python: distances, and what a disc cuts off, face by face."""

import heapq
from itertools import pairwise

import networkx as nx
import numpy as np
import pytest
import trimesh
from conftest import blob

from msf_jax.limbs.caps import Caps
from msf_jax.solid.enclosure import Enclosure


def unfolded(p, q, r, from_p: float, from_q: float) -> float:
    """How far r is from a source at such distances from p and q: in the plane of complex numbers, p = 0, q > 0."""
    length = np.linalg.norm(q - p)
    along = (r - p) @ (q - p) / length
    third = complex(along, np.sqrt(max((r - p) @ (r - p) - along**2, 0.0)))
    x = (from_p**2 - from_q**2 + length**2) / (2 * length)
    if from_p**2 < x**2:
        return np.inf
    source = complex(x, -np.sqrt(from_p**2 - x**2))
    share = -source.imag / (third - source).imag  # of the line from the source, up to the edge
    return abs(third - source) if 0 <= (source + share * (third - source)).real <= length else np.inf


def marched(x: np.ndarray, faces: np.ndarray, sources: list[int], level: float = np.inf) -> np.ndarray:
    """Distances (V,) when all that are below ``level`` are final."""
    around = [[] for _ in x]
    for face in faces.tolist():
        for corner in face:
            around[corner].append(face)
    away, final = np.full(len(x), np.inf), set()
    away[sources] = 0.0
    queue = [(0.0, source) for source in sources]
    while queue and queue[0][0] < level:
        vertex = heapq.heappop(queue)[1]
        if vertex in final:
            continue
        final.add(vertex)
        for face in around[vertex]:
            one, other = (corner for corner in face if corner != vertex)
            for near, far in ((one, other), (other, one)):
                if far not in final:
                    found = away[vertex] + np.linalg.norm(x[vertex] - x[far])
                    if near in final:
                        found = min(found, unfolded(x[near], x[vertex], x[far], away[near], away[vertex]))
                    if found < away[far]:
                        away[far] = found
                        heapq.heappush(queue, (found, far))
    return away


def cut_off(x: np.ndarray, faces: np.ndarray, away: np.ndarray, level: float) -> tuple[int, list[float]]:
    """How many curves are at that distance; and of the part below it the slenderness, the area, the middle of its
    curve, and the volume when a fan around that middle closes it."""
    triangles, sides, graph = [], [], nx.Graph()
    for face in faces[(away[faces] < level).any(axis=1)].tolist():
        polygon, ends = [], []
        for a, b in pairwise([*face, face[0]]):
            if away[a] < level:
                polygon.append(x[a])
            if (away[a] < level) != (away[b] < level):
                ends.append(x[a] + (level - away[a]) / (away[b] - away[a]) * (x[b] - x[a]))
                polygon.append(ends[-1])
                graph.add_edge(tuple(face), frozenset((a, b)))
        triangles += [(polygon[0], *pair) for pair in pairwise(polygon[1:])]
        sides += [ends] if ends else []
    corners, ends = np.array(triangles), np.array(sides)
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum() / 2
    length = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    middle = length @ ends.mean(axis=1) / length.sum()
    volume = np.linalg.det(corners - middle).sum() / 6
    slenderness = 2 * np.pi * area / length.sum() ** 2 - 0.5 if volume > 0 else 0.0
    return nx.number_connected_components(graph), [slenderness, area, *middle, volume]


def pear() -> tuple[trimesh.Trimesh, list[float]]:
    """A ball that is drawn out to one side, and its tip."""
    mesh = blob(91)
    return trimesh.Trimesh(mesh.vertices * np.exp(0.6 * mesh.vertices[:, 2:]), mesh.faces, process=False), [0, 0, 9]


def dented() -> tuple[trimesh.Trimesh, list[float]]:
    """A ball with a dent, and the bottom of that."""
    mesh = trimesh.creation.icosphere(3)
    x = mesh.vertices + 1e-3 * np.random.default_rng(2).normal(size=mesh.vertices.shape)
    x[:, 2] = np.minimum(x[:, 2], 1.6 - x[:, 2])
    return trimesh.Trimesh(x, mesh.faces, process=False), [0, 0, 0.6]


def caps_of(mesh: trimesh.Trimesh) -> Caps:
    return Caps(Enclosure(np.array(mesh.vertices), np.array(mesh.faces)))


@pytest.mark.parametrize("num", [1, 3])
def test_spread_gives_the_distances_of_a_plain_march(num):
    """And of no march at all they are between those in space and those along edges."""
    caps = caps_of(blob(92, 2))
    x, faces = caps.surface.points, caps.surface.faces
    sources = np.random.default_rng(1).choice(len(x), num, replace=False)
    found = caps._distances(sources)
    np.testing.assert_allclose(found, marched(x, faces, sources.tolist()), rtol=1e-12)
    graph = nx.Graph()
    for a, b in np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]).tolist():
        graph.add_edge(a, b, weight=float(np.linalg.norm(x[a] - x[b])))
    along = nx.multi_source_dijkstra_path_length(graph, set(sources.tolist()))
    assert (found <= np.array([along[k] for k in range(len(x))]) * (1 + 1e-12)).all()
    assert (found >= np.linalg.norm(x[:, None] - x[sources], axis=2).min(axis=1) * (1 - 1e-12)).all()


@pytest.mark.parametrize("make", [pear, pytest.param(dented, marks=pytest.mark.slow)])
def test_cap_measures_what_a_disc_cuts_off(make):
    """Its figures are those of all faces that are cut one by one; a pocket has no slenderness."""
    mesh, tip = make()
    caps = caps_of(mesh)
    x, faces = caps.surface.points, caps.surface.faces
    tip = int(np.linalg.norm(x - tip, axis=1).argmin())
    rows, region = caps.grown(tip, np.zeros(len(x), dtype=np.int64), least=0.0)
    num = 0
    for level, row in zip(rows[:, 1], np.delete(rows, 1, axis=1), strict=True):
        away = marched(x, faces, [tip], level)
        rings, expected = cut_off(x, faces, away, level)
        if rings == 1:
            np.testing.assert_allclose(row, expected, rtol=1e-9, atol=1e-9)
            num += 1
        if level == rows[rows[:, 0].argmax(), 1]:
            assert rings > 1 or set(region.tolist()) == set(np.flatnonzero(away < level).tolist())
    assert num > 5
    assert (rows[:4, 0] == 0).all() == (make is dented)
