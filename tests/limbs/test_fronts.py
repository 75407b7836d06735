"""Distances on a surface against plain searches and closed forms."""

import networkx as nx
import numpy as np
import pytest
import trimesh
from conftest import blob

from msf_jax.limbs import fronts
from msf_jax.solid.enclosure import Enclosure


@pytest.mark.parametrize("num", [1, 3])
def test_distances_are_between_those_in_space_and_those_along_edges(num):
    mesh = blob(92, 3)
    x, faces = np.array(mesh.vertices), np.array(mesh.faces)
    sources = np.random.default_rng(1).choice(len(x), num, replace=False)
    found = fronts.distances(Enclosure(x, faces))(indices=sources)
    graph = nx.Graph()
    for a, b in np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]).tolist():
        graph.add_edge(a, b, weight=float(np.linalg.norm(x[a] - x[b])))
    along = nx.multi_source_dijkstra_path_length(graph, set(sources.tolist()))
    assert (found <= np.array([along[k] for k in range(len(x))]) * (1 + 1e-12)).all()
    assert (found >= np.linalg.norm(x[:, None] - x[sources], axis=2).min(axis=1) * (1 - 1e-12)).all()


@pytest.mark.parametrize(("half", "slope"), [(1.0, 0.0), (3.0, 0.5), (3.0, 1.0)])
def test_a_path_goes_straight_through_the_ridge_of_a_roof(half, slope):
    """And not through the gables' edges, which lead to the same corner on a longer way."""
    ridge, eaves = [[0.0, -half, slope], [0, half, slope]], [[1.0, 0, 0], [-1, 0, 0]]
    x = np.array([*ridge, *eaves, [0.0, 0, -9]])
    faces = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 4], [3, 1, 4], [1, 2, 4], [2, 0, 4]])
    assert fronts.distances(Enclosure(x, faces))(indices=[2])[3] == pytest.approx(2 * np.hypot(1.0, slope))


def test_a_path_that_would_miss_an_edge_goes_around_its_end():
    """From tip to tip of a kite that is bent at its short diagonal, which lies aside of the line between the tips."""
    x = np.array([[0.0, 0, 0], [0, 1, 0], [-1.0, 3, 0], [1.0, 2, 0], [0, 1, -9]])
    faces = np.array([[0, 1, 2], [0, 3, 1], [0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4]])
    direct = np.linalg.norm(x[2] - x[1]) + np.linalg.norm(x[3] - x[1])
    assert fronts.distances(Enclosure(x, faces))(indices=[2])[3] == pytest.approx(direct)


def test_distances_on_a_fine_ball_are_two_per_cent_too_long():
    ball = trimesh.creation.icosphere(4)
    x = np.array(ball.vertices)
    found = fronts.distances(Enclosure(x, np.array(ball.faces)))(indices=[0])
    exact = np.arccos(np.clip(x @ x[0], -1, 1))
    ratio = found[exact > 0.3] / exact[exact > 0.3]
    assert ratio.min() > 0.99 and ratio.mean() < 1.025 and ratio.max() < 1.1
