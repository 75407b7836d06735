"""Splits of obtuse and of long edges: their rounds, replayed on a plain list of faces."""

import numpy as np
import pytest
from meso_cases import OBTUSE, case, manifold_euler, turned, typical_length, watch_rounds

from msf_jax.meso import collapse, ring_tables, split
from msf_jax.meso.meso import Meso


def angle_at(positions: np.ndarray, apex: int, a: int, b: int) -> float:
    """Angle in degrees that ab subtends at ``apex``."""
    p, q = positions[a] - positions[apex], positions[b] - positions[apex]
    return float(np.degrees(np.arctan2(np.linalg.norm(np.cross(p, q)), p @ q)))


def third_vertices(faces) -> dict[tuple[int, int], int]:
    """The third vertex of the face that runs along each directed edge."""
    return {edge: k for i, j, m in faces for edge, k in (((i, j), m), ((j, m), i), ((m, i), j))}


def replay_split(before: Meso, rounds: list[split.SplitRound], shortest: float) -> tuple[set, np.ndarray, np.ndarray]:
    """The rounds on a plain face list, each rule checked; returns the faces, positions and poles at the end."""
    faces, positions, poles = turned(before.faces()), before.positions.copy(), before.poles.copy()
    for done in rounds:
        third = third_vertices(faces)
        claimed: list[int] = []
        for a, b, new, fraction, at in zip(*(column.tolist() for column in done), strict=True):
            left, right = third[a, b], third[b, a]
            claimed += [a, b, left, right]
            angles = angle_at(positions, left, a, b), angle_at(positions, right, a, b)
            along = positions[b] - positions[a]
            assert min(angles) > OBTUSE and np.linalg.norm(along) > shortest
            apex = left if angles[0] >= angles[1] else right
            assert at == apex or abs(angles[0] - angles[1]) < 1e-9
            assert fraction == pytest.approx((positions[apex] - positions[a]) @ along / (along @ along), abs=1e-9)
            assert 0 < fraction < 1
            assert new == len(positions)
            positions = np.vstack([positions, positions[a] + fraction * along])
            poles = np.vstack([poles, poles[a] + fraction * (poles[b] - poles[a])])
            faces -= turned([(a, b, left), (b, a, right)])
            faces |= turned([(a, new, left), (new, b, left), (b, new, right), (new, a, right)])
        assert len(set(claimed)) == len(claimed), "two cuts of a round share a vertex"
    return faces, positions, poles


def long_triangles(name: str, load) -> Meso:
    """A surface with many edges to split: a twisted torus, or one that a collapse has left ragged, squeezed."""
    if name == "twisted torus":
        return case(name, load)
    meso = case(name, load)
    collapse.collapse_short_edges(meso, 1.5 * typical_length(meso))
    meso = meso.compacted()
    meso.positions = meso.positions * [1.0, 0.3, 0.1]
    return meso


@pytest.mark.parametrize("name", ["twisted torus", "blob", "two parts", pytest.param("bunny", marks=pytest.mark.slow)])
def test_split(research_mesh, monkeypatch, name):
    """Closed and of the same genus after every round; no obtuse pair left; no volume gained; equal to its replay."""
    meso, before = long_triangles(name, research_mesh), long_triangles(name, research_mesh)
    shortest = 0.02 * typical_length(meso)
    seen = watch_rounds(monkeypatch)
    rounds, is_full = split.split_obtuse_edges(meso, OBTUSE, shortest, 10**6, check=True)
    assert not is_full
    num_new = sum(len(done.new) for done in rounds)
    assert num_new >= 10 and meso.num_rows == before.num_rows + num_new
    assert seen == [manifold_euler(before.faces())] * len(rounds)

    faces, positions, poles = replay_split(before, rounds, shortest)
    assert turned(meso.faces()) == faces
    np.testing.assert_allclose(meso.positions, positions, rtol=0, atol=1e-12)
    np.testing.assert_allclose(meso.poles, poles, rtol=0, atol=1e-12)
    assert meso.volume() == pytest.approx(before.volume(), rel=1e-9)
    fresh = slice(before.num_rows, None)
    assert not meso.has_pole[fresh].any() and not meso.is_fixed[fresh].any()
    np.testing.assert_array_equal(meso.has_pole[: before.num_rows], before.has_pole)
    np.testing.assert_array_equal(meso.node_of_input, before.node_of_input)
    np.testing.assert_array_equal(meso.degree, ring_tables.ring_degrees(meso.rings))

    third = third_vertices(turned(meso.faces()))
    for a, b in third:
        if a < b and np.linalg.norm(meso.positions[a] - meso.positions[b]) > shortest:
            angles = [angle_at(meso.positions, apex, a, b) for apex in (third[a, b], third[b, a])]
            assert min(angles) <= OBTUSE + 1e-6


def test_split_stops_before_the_surface_outgrows_its_capacity(research_mesh):
    meso = long_triangles("twisted torus", research_mesh)
    capacity = meso.num_rows + 3
    split.split_obtuse_edges(meso, OBTUSE, 1e-3, capacity, check=True)
    assert meso.num_rows <= capacity


def test_one_edge_is_cut_where_its_apex_projects():
    """A rhombus roof over a long edge from (0,0,0) to (10,0,0): apex at x = 3 is flatter, so the cut is there."""
    vertices = np.array([[0, 0, 0], [10, 0, 0], [3, 1, 0], [5, -2, 0], [5, 0, -20]], dtype=float)
    faces = np.array([[0, 1, 2], [1, 0, 3], [1, 4, 2], [2, 4, 0], [0, 4, 3], [3, 4, 1]])
    meso = Meso.from_mesh(vertices, faces)
    meso.poles = vertices + np.array([0, 0, 7.0])
    meso.has_pole[:] = True
    rounds, _ = split.split_obtuse_edges(meso, OBTUSE, 1.0, 100, check=True)
    assert len(rounds) == 1
    np.testing.assert_allclose(meso.positions[5], [3, 0, 0], atol=1e-12)
    np.testing.assert_allclose(meso.poles[5], [3, 0, 7], atol=1e-12)
    assert meso.has_pole.tolist() == [True] * 5 + [False]
    assert set(meso.rings[5][meso.rings[5] >= 0].tolist()) == {0, 1, 2, 3}


def test_an_edge_shorter_than_the_shortest_is_not_split(research_mesh):
    meso = long_triangles("twisted torus", research_mesh)
    assert split.split_obtuse_edges(meso, OBTUSE, 10.0, 10**6) == ([], False)


@pytest.mark.parametrize("name", ["blob", "torus"])
def test_halving_long_edges(research_mesh, name):
    """No edge longer than asked is left; shape, volume and genus stay."""
    meso = case(name, research_mesh)
    volume, euler = meso.volume(), manifold_euler(meso.faces())
    longest = 0.7 * typical_length(meso)
    split.split_long_edges(meso, longest)
    faces = meso.faces()
    assert manifold_euler(faces) == euler
    assert np.linalg.norm(meso.positions[faces] - meso.positions[faces[:, [1, 2, 0]]], axis=2).max() <= longest
    assert meso.volume() == pytest.approx(volume, rel=1e-12)
