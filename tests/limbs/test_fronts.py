"""The compiled fronts against the same said in plain Python."""

import heapq

import networkx as nx
import numpy as np
import pytest
from conftest import blob

from msf_jax.limbs import fronts
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


def marched(x: np.ndarray, faces: np.ndarray, sources: list[int]) -> np.ndarray:
    """Distances (V,), vertex by vertex."""
    around = [[] for _ in x]
    for face in faces.tolist():
        for corner in face:
            around[corner].append(face)
    away, final = np.full(len(x), np.inf), set()
    away[sources] = 0.0
    queue = [(0.0, source) for source in sources]
    while queue:
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


@pytest.mark.parametrize("num", [1, 3])
def test_spread_gives_the_distances_of_a_plain_march(num):
    """And of no march at all they are between those in space and those along edges."""
    mesh = blob(92, 3)
    x, faces = np.array(mesh.vertices), np.array(mesh.faces)
    sources = np.random.default_rng(1).choice(len(x), num, replace=False)
    found = fronts.distances(Enclosure(x, faces))(sources)
    np.testing.assert_allclose(found, marched(x, faces, sources.tolist()), rtol=1e-12)
    graph = nx.Graph()
    for a, b in np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]).tolist():
        graph.add_edge(a, b, weight=float(np.linalg.norm(x[a] - x[b])))
    along = nx.multi_source_dijkstra_path_length(graph, set(sources.tolist()))
    assert (found <= np.array([along[k] for k in range(len(x))]) * (1 + 1e-12)).all()
    assert (found >= np.linalg.norm(x[:, None] - x[sources], axis=2).min(axis=1) * (1 - 1e-12)).all()
