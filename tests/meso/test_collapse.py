"""Collapse of short edges: its rounds, replayed on a plain list of faces, where every rule is checked the slow way."""

import numpy as np
import pytest
import trimesh
from conftest import blob
from meso_cases import (
    SURFACES,
    case,
    is_tetrahedron,
    manifold_euler,
    meso_of,
    neighbours_of,
    turned,
    twisted_torus,
    typical_length,
    watch_rounds,
)

from msf_jax.meso import collapse, kernels, ring_tables
from msf_jax.meso.meso import Meso


def assert_nothing_left_to_collapse(meso: Meso, t_c: float) -> None:
    """No edge shorter than ``t_c``, not fixed at both ends, whose ends have just two common neighbours."""
    around = neighbours_of(meso.faces())
    for a in around:
        for b in around[a]:
            is_short = np.linalg.norm(meso.positions[a] - meso.positions[b]) < t_c * (1 - 1e-12)
            if a < b and is_short and not (meso.is_fixed[a] and meso.is_fixed[b]):
                assert len(around[a] & around[b]) > 2 or is_tetrahedron(around, a), f"{a}-{b} could go"


def replay_collapse(
    before: Meso, rounds: list[collapse.CollapseRound], t_c: float
) -> tuple[set, np.ndarray, np.ndarray]:
    """The rounds on a plain face list, each rule checked; returns the faces, positions and poles at the end."""
    faces = turned(before.faces())
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
    return faces, positions, poles


@pytest.mark.parametrize("fixed", [0.0, 0.3])
@pytest.mark.parametrize("name", SURFACES)
def test_collapse(research_mesh, monkeypatch, name, fixed):
    """Closed, of the same genus after every round; nothing left to collapse; the same as the replay of its rounds."""
    meso = case(name, research_mesh, fixed)
    before = case(name, research_mesh, fixed)
    t_c = 1.5 * typical_length(meso)
    seen = watch_rounds(monkeypatch)
    rounds = collapse.collapse_short_edges(meso, t_c, check=True)
    euler = manifold_euler(before.faces())
    assert len(rounds) > 1 and seen == [euler] * len(rounds)
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
    collapse.collapse_short_edges(meso, 100.0, check=True)
    assert meso.num_live == 4 and len(turned(meso.faces())) == 4
    assert ring_tables.euler_characteristic(meso.rings) == 2


@pytest.mark.parametrize("twist", [0, 1, 5])
def test_a_torus_collapses_to_an_irreducible_torus(twist):
    """The 21 irreducible triangulations of the torus have 7 to 10 vertices (Lawrencenko 1987)."""
    mesh = twisted_torus(twist)
    meso = meso_of(np.array(mesh.vertices), np.array(mesh.faces))
    collapse.collapse_short_edges(meso, 100.0, check=True)
    assert 7 <= meso.num_live <= 10
    assert ring_tables.euler_characteristic(meso.rings) == 0


def test_an_edge_that_a_collapse_frees_goes_too():
    """A vertex inside the face (b, x, y) keeps xy from collapsing; once it has gone into b, xy can and must go."""
    sphere = trimesh.creation.icosphere(1)
    vertices, faces = np.array(sphere.vertices), np.array(sphere.faces)
    b, x, y = faces[40]
    middle = (vertices[x] + vertices[y]) / 2
    vertices[[x, y]] = middle + 0.5 * (vertices[[x, y]] - middle)
    inner = vertices[b] + 0.1 * ((vertices[b] + vertices[x] + vertices[y]) / 3 - vertices[b])
    fan = [[b, x, 42], [x, y, 42], [y, b, 42]]
    meso = Meso.from_mesh(np.vstack([vertices, inner]), np.concatenate([np.delete(faces, 40, axis=0), fan]))
    around = neighbours_of(meso.faces())
    assert len(around[int(x)] & around[int(y)]) == 3
    t_c = 1.2 * float(np.linalg.norm(vertices[x] - vertices[y]))
    assert len(collapse.collapse_short_edges(meso, t_c, check=True)) == 2
    assert meso.num_live == 41 and meso.node_of_input[x] == meso.node_of_input[y]
    assert_nothing_left_to_collapse(meso, t_c)


def test_the_edges_of_a_round_are_a_maximal_set():
    """No two have equal or neighbouring ends, and every other edge that could collapse does with a shorter one."""
    mesh = blob(10)
    meso = meso_of(np.array(mesh.vertices), np.array(mesh.faces))
    around = neighbours_of(meso.faces())
    t_c = 2 * typical_length(meso)
    edges = collapse.Waiting().find(kernels.short_edges, meso, np.ones(meso.num_rows, dtype=bool), t_c)
    can = edges[(edges[:, 4] == 2) & (meso.degree[edges[:, 2:4]] > 3).all(axis=1)]
    length = collapse.edge_lengths(meso.positions, can[:, 0], can[:, 1])
    blocked: set[int] = set()
    greedy = set()
    for a, b in can[np.lexsort((can[:, 1], can[:, 0], np.round(length / (1e-6 * t_c)))), :2].tolist():
        if not {a, b} & blocked:
            greedy.add((a, b))
            blocked |= around[a] | around[b] | {a, b}
    first = collapse.collapse_short_edges(meso, t_c)[0]
    assert set(zip(first.survivor.tolist(), first.removed.tolist(), strict=True)) == greedy and len(greedy) > 10
