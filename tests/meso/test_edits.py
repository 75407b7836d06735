"""Collapses, splits and fixing: their rounds, replayed on a plain list of faces, where every rule is checked."""

import numpy as np
import pytest
from conftest import blob, torus
from meso_cases import (
    OBTUSE,
    SURFACES,
    case,
    is_tetrahedron,
    manifold_euler,
    meso_of,
    neighbours_of,
    turned,
    twisted_torus,
    typical_length,
)

from msf_jax.meso import edits, ring_tables
from msf_jax.meso.meso import Meso


def assert_nothing_left_to_collapse(meso: Meso, t_c: float) -> None:
    """No edge shorter than ``t_c``, not fixed at both ends, whose ends have just two common neighbours."""
    around = neighbours_of(meso.faces())
    for a in around:
        for b in around[a]:
            is_short = np.linalg.norm(meso.positions[a] - meso.positions[b]) < t_c * (1 - 1e-12)
            if a < b and is_short and not (meso.is_fixed[a] and meso.is_fixed[b]):
                assert len(around[a] & around[b]) > 2 or is_tetrahedron(around, a), f"{a}-{b} could go"


def replay_collapse(before: Meso, rounds: list[edits.CollapseRound], t_c: float) -> tuple[set, np.ndarray, np.ndarray]:
    """The rounds on a plain face list, each rule checked; returns the faces, positions and poles at the end."""
    faces = turned(before.faces())
    euler = manifold_euler(faces)
    positions, poles, has_pole = before.positions.copy(), before.poles.copy(), before.has_pole.copy()
    for done in rounds:
        around = neighbours_of(faces)
        blocked: set[int] = set()
        for s, r in zip(done.survivor.tolist(), done.removed.tolist(), strict=True):
            assert not {s, r} & blocked, "two edges of a round have equal or neighbouring ends"
            blocked |= around[s] | around[r]
        target = {}
        for s, r, fraction, takes_pole in zip(*(column.tolist() for column in done), strict=True):
            assert r in around[s] and len(around[s] & around[r]) == 2
            assert np.linalg.norm(positions[s] - positions[r]) < t_c
            assert not before.is_fixed[r], "a fixed vertex never goes"
            assert fraction == (0.0 if before.is_fixed[s] else 0.5)
            middle = positions[s] if before.is_fixed[s] else (positions[s] + positions[r]) / 2
            reach = [np.linalg.norm(poles[end] - middle) if has_pole[end] else np.inf for end in (s, r)]
            assert takes_pole == (reach[1] < reach[0])
            positions[s] = middle
            if takes_pole:
                poles[s], has_pole[s] = poles[r], True
            target[r] = s
        renamed = [tuple(target.get(v, v) for v in face) for face in faces]
        faces = turned(face for face in renamed if len(set(face)) == 3)
        assert len(faces) == len(renamed) - 2 * len(target)  # each collapse takes its two faces and no others
        assert manifold_euler(faces) == euler
    return faces, positions, poles


@pytest.mark.parametrize("fixed", [0.0, 0.3])
@pytest.mark.parametrize("name", SURFACES)
def test_collapse(research_mesh, name, fixed):
    """Closed, of the same genus after every round; nothing left to collapse; the same as the replay of its rounds."""
    meso = case(name, research_mesh, fixed)
    before = case(name, research_mesh, fixed)
    t_c = 1.5 * typical_length(meso)
    rounds = edits.collapse_short_edges(meso, t_c)
    assert len(rounds) > 1
    assert_nothing_left_to_collapse(meso, t_c)

    faces, positions, poles = replay_collapse(before, rounds, t_c)
    assert turned(meso.faces()) == faces
    live = meso.degree > 0
    assert set(np.flatnonzero(live)) == {v for face in faces for v in face}
    np.testing.assert_allclose(meso.positions[live], positions[live], rtol=0, atol=1e-15)
    np.testing.assert_array_equal(meso.poles[live], poles[live])
    np.testing.assert_array_equal(meso.degree, ring_tables.ring_degrees(meso.rings))
    is_fixed = before.is_fixed
    assert live[is_fixed].all()
    np.testing.assert_array_equal(meso.positions[is_fixed], before.positions[is_fixed])

    # Every input vertex is still somewhere, and where following the merges leads.
    target = np.arange(meso.num_rows)
    for done in rounds:
        target[done.removed] = done.survivor
        target = target[target]
    while (target[target] != target).any():
        target = target[target]
    np.testing.assert_array_equal(meso.node_of_input, target)
    assert live[meso.node_of_input].all()
    assert set(meso.node_of_input.tolist()) == set(np.flatnonzero(live).tolist())


@pytest.mark.parametrize("seed", range(3))
def test_a_sphere_collapses_to_a_tetrahedron(seed):
    """Every triangulated sphere but the tetrahedron has an edge that can be contracted (Steinitz)."""
    mesh = blob(seed, 2)
    meso = meso_of(np.array(mesh.vertices), np.array(mesh.faces))
    edits.collapse_short_edges(meso, 100.0)
    assert meso.num_live == 4 and manifold_euler(meso.faces()) == 2


@pytest.mark.parametrize("twist", [0, 1, 5])
def test_a_torus_collapses_to_an_irreducible_torus(twist):
    """The 21 irreducible triangulations of the torus have 7 to 10 vertices (Lawrencenko 1987)."""
    mesh = twisted_torus(twist)
    meso = meso_of(np.array(mesh.vertices), np.array(mesh.faces))
    edits.collapse_short_edges(meso, 100.0)
    assert 7 <= meso.num_live <= 10 and manifold_euler(meso.faces()) == 0


def angle_at(positions: np.ndarray, apex: int, a: int, b: int) -> float:
    """Angle in degrees that ab subtends at ``apex``."""
    p, q = positions[a] - positions[apex], positions[b] - positions[apex]
    return float(np.degrees(np.arctan2(np.linalg.norm(np.cross(p, q)), p @ q)))


def third_vertices(faces) -> dict[tuple[int, int], int]:
    """The third vertex of the face that runs along each directed edge."""
    return {edge: k for i, j, m in faces for edge, k in (((i, j), m), ((j, m), i), ((m, i), j))}


def replay_split(before: Meso, rounds: list[edits.SplitRound], shortest: float) -> tuple[set, np.ndarray, np.ndarray]:
    """The rounds on a plain face list, each rule checked; returns the faces, positions and poles at the end."""
    faces, positions, poles = turned(before.faces()), before.positions.copy(), before.poles.copy()
    euler = manifold_euler(faces)
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
        assert manifold_euler(faces) == euler
    return faces, positions, poles


def long_triangles(name: str, load) -> Meso:
    """A surface with many edges to split: a twisted torus, or one that a collapse has left ragged, squeezed."""
    if name == "twisted torus":
        return case(name, load)
    meso = case(name, load)
    edits.collapse_short_edges(meso, 1.5 * typical_length(meso))
    meso = meso.compacted()
    meso.positions = meso.positions * [1.0, 0.3, 0.1]
    return meso


@pytest.mark.parametrize("name", ["twisted torus", "blob", "two parts", pytest.param("bunny", marks=pytest.mark.slow)])
def test_split(research_mesh, name):
    """Closed and of the same genus after every round; no obtuse pair left; no volume gained; equal to its replay."""
    meso, before = long_triangles(name, research_mesh), long_triangles(name, research_mesh)
    shortest = 0.02 * typical_length(meso)
    rounds, is_full = edits.split_obtuse_edges(meso, OBTUSE, shortest, 10**6)
    assert not is_full
    num_new = sum(len(done.new) for done in rounds)
    assert num_new >= 10 and meso.num_rows == before.num_rows + num_new
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
    edits.split_obtuse_edges(meso, OBTUSE, 1e-3, capacity)
    assert meso.num_rows <= capacity


def test_one_edge_is_cut_where_its_apex_projects():
    """A rhombus roof over a long edge from (0,0,0) to (10,0,0): apex at x = 3 is flatter, so the cut is there."""
    vertices = np.array([[0, 0, 0], [10, 0, 0], [3, 1, 0], [5, -2, 0], [5, 0, -20]], dtype=float)
    faces = np.array([[0, 1, 2], [1, 0, 3], [1, 4, 2], [2, 4, 0], [0, 4, 3], [3, 4, 1]])
    meso = Meso.from_mesh(vertices, faces)
    meso.poles = vertices + np.array([0, 0, 7.0])
    meso.has_pole[:] = True
    rounds, _ = edits.split_obtuse_edges(meso, OBTUSE, 1.0, 100)
    assert len(rounds) == 1
    np.testing.assert_allclose(meso.positions[5], [3, 0, 0], atol=1e-12)
    np.testing.assert_allclose(meso.poles[5], [3, 0, 7], atol=1e-12)
    assert meso.has_pole.tolist() == [True] * 5 + [False]
    assert set(meso.rings[5][meso.rings[5] >= 0].tolist()) == {0, 1, 2, 3}


@pytest.mark.parametrize("name", ["blob", "torus"])
def test_halving_long_edges(research_mesh, name):
    """No edge longer than asked is left; shape, volume and genus stay."""
    meso = case(name, research_mesh)
    volume, euler = meso.volume(), manifold_euler(meso.faces())
    longest = 0.7 * typical_length(meso)
    edits.split_long_edges(meso, longest)
    faces = meso.faces()
    assert manifold_euler(faces) == euler
    assert np.linalg.norm(meso.positions[faces] - meso.positions[faces[:, [1, 2, 0]]], axis=2).max() <= longest
    assert meso.volume() == pytest.approx(volume, rel=1e-12)


def test_a_thread_is_fixed():
    """A tube of triangles around a ring: no edge across can go, so every vertex has two, and all become fixed."""
    mesh = torus(1.0, 0.01, 24, 3)
    meso = Meso.from_mesh(np.array(mesh.vertices), np.array(mesh.faces))
    across = 2 * 0.01 * np.sin(np.pi / 3)
    edits.fix_degenerate_vertices(meso, 0.99 * across)
    assert not meso.is_fixed.any()
    edits.fix_degenerate_vertices(meso, 1.01 * across)
    assert meso.is_fixed.all()


@pytest.mark.parametrize("name", ["torus", "blob", "three-holes"])
def test_fixing_follows_its_rule(research_mesh, name):
    """Fixed are just the vertices with two or more short edges that cannot collapse, counted the slow way."""
    meso = case(name, research_mesh, fixed=0.05)
    meso.positions = meso.positions * [1.0, 0.3, 0.05]
    edits.collapse_short_edges(meso, 3 * typical_length(meso))
    meso = meso.compacted()
    t_f = 1.2 * typical_length(meso)
    around = neighbours_of(meso.faces())
    stuck = np.zeros(meso.num_rows, dtype=int)
    for a in around:
        for b in around[a]:
            is_short = np.linalg.norm(meso.positions[a] - meso.positions[b]) < t_f
            if is_short and (len(around[a] & around[b]) > 2 or is_tetrahedron(around, a)):
                stuck[a] += 1
    was_fixed = meso.is_fixed.copy()
    edits.fix_degenerate_vertices(meso, t_f)
    np.testing.assert_array_equal(meso.is_fixed, was_fixed | (stuck >= 2))
    assert stuck.any()


def test_the_saw_tooth():
    """It rises step by step and falls back once it would pass the top."""
    seen = [edits.threshold(k, 0.002, 0.0001, 0.016) for k in range(300)]
    assert seen[0] == 0.002
    assert max(seen) == pytest.approx(0.016, abs=1e-12)  # (0.016 - 0.002) / 0.0001 = 140 steps take it to the top
    assert [k for k in range(1, 300) if seen[k] < seen[k - 1]] == [141, 282]
    assert edits.threshold(7, 0.002, 0.0, 0.016) == 0.002


@pytest.mark.parametrize("name", ["torus", "blob", pytest.param("bunny", marks=pytest.mark.slow)])
def test_a_few_iterations_of_all_edits(research_mesh, name):
    """Squeeze, collapse, split, fix, again and again, as the flow does: closed and of the same genus throughout."""
    meso = case(name, research_mesh)
    euler = manifold_euler(meso.faces())
    t_c = 0.6 * typical_length(meso)
    for _ in range(6):
        meso.positions = np.where(meso.is_fixed[:, None], meso.positions, meso.positions * [0.95, 0.7, 0.5])
        edits.collapse_short_edges(meso, t_c)
        edits.split_obtuse_edges(meso, OBTUSE, t_c / 10, 10**6)
        edits.fix_degenerate_vertices(meso, t_c / 10)
        meso = meso.compacted()
        assert manifold_euler(meso.faces()) == euler
        t_c *= 1.3
    assert np.isfinite(meso.positions).all()
    assert set(meso.node_of_input.tolist()) <= set(range(meso.num_rows))
