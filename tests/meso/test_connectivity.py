"""Ring tables, and the edits that the host makes to them: collapse, split, fixing.

The edits return their rounds. The tests replay these on a plain list of faces, where every rule is checked the slow
way, and compare what comes out with the ring table that the package edited.
"""

from collections import defaultdict

import numpy as np
import pytest
import trimesh
from conftest import blob, torus

from msf_jax.base.errors import FlowError, MeshError
from msf_jax.meso import collapse, fixing, kernels, ring_tables, split
from msf_jax.meso.meso import Meso

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


def watch_rounds(monkeypatch) -> list[int]:
    """Check the surface independently after every round of an edit; returns the list of Euler characteristics seen."""
    seen: list[int] = []
    original = ring_tables.check_closed_manifold

    def check(rings, euler):
        original(rings, euler)
        seen.append(manifold_euler(ring_tables.faces_from_rings(rings)))

    monkeypatch.setattr(ring_tables, "check_closed_manifold", check)
    return seen


SURFACES = ["torus", "twisted torus", "blob", "two parts", "bunny"]


# Ring tables


@pytest.mark.parametrize("name", [*SURFACES, "three-holes"])
def test_faces_to_rings_and_back(research_mesh, name):
    meso = case(name, research_mesh)
    faces = meso.faces()
    again = ring_tables.faces_from_rings(ring_tables.rings_from_faces(faces, meso.num_rows))
    assert len(faces) == len(turned(faces))
    assert turned(again) == turned(faces)


@pytest.mark.parametrize("seed", range(4))
def test_rings_do_not_depend_on_how_the_faces_are_written(seed):
    """Faces shuffled, each turned at random, vertices renumbered: the rings hold the same faces."""
    random = np.random.default_rng(seed)
    mesh = blob(seed, 2)
    number = random.permutation(len(mesh.vertices))
    faces = number[np.array(mesh.faces)]
    shuffled = np.array([np.roll(face, random.integers(3)) for face in random.permutation(faces)])
    rings = ring_tables.rings_from_faces(shuffled, len(number))
    assert turned(ring_tables.faces_from_rings(rings)) == turned(faces)
    for vertex, around in neighbours_of(faces).items():
        assert set(rings[vertex][rings[vertex] >= 0].tolist()) == around
        assert (rings[vertex] >= 0).sum() == len(around)


def test_rings_run_counter_clockwise_seen_from_outside():
    """Around each vertex of a sphere, consecutive neighbours turn left about the outward direction."""
    mesh = trimesh.creation.icosphere(2)
    rings = ring_tables.rings_from_faces(np.array(mesh.faces), len(mesh.vertices))
    for vertex, ring in enumerate(rings):
        ring = ring[ring >= 0]
        turn = np.cross(mesh.vertices[ring], mesh.vertices[np.roll(ring, -1)]) @ mesh.vertices[vertex]
        assert (turn > 0).all()


@pytest.mark.parametrize(("name", "euler"), [("torus", 0), ("blob", 2), ("two parts", 2), ("three-holes", -4)])
def test_euler_characteristic(research_mesh, name, euler):
    meso = case(name, research_mesh)
    assert ring_tables.euler_characteristic(meso.rings) == euler == manifold_euler(meso.faces())


def test_edges_and_apexes_of_a_ring_table():
    """Every edge once; left and right apex complete the face that runs along the edge and the one that runs back."""
    meso = meso_of(*(lambda m: (np.array(m.vertices), np.array(m.faces)))(blob(9, 2)))
    third = {}
    for a, b, c in meso.faces().tolist():
        third[a, b], third[b, c], third[c, a] = c, a, b
    a, b = ring_tables.edges_from_rings(meso.rings)
    assert set(zip(a.tolist(), b.tolist(), strict=True)) == {edge for edge in third if edge[0] < edge[1]}
    assert len(a) == len(third) // 2
    left, right = ring_tables.apexes(meso.rings, meso.degree, a, b)
    for i, j, k, m in zip(a.tolist(), b.tolist(), left.tolist(), right.tolist(), strict=True):
        assert third[i, j] == k and third[j, i] == m


def test_a_surface_with_a_hole_or_a_pinch_has_no_rings():
    faces = np.array(trimesh.creation.icosphere(1).faces)
    with pytest.raises(MeshError, match="closed surface"):
        ring_tables.rings_from_faces(faces[1:], 42)
    with pytest.raises(MeshError, match="closed surface"):
        ring_tables.rings_from_faces(faces, 43)  # a vertex in no face
    pinched = np.concatenate([faces, np.where(faces == 0, 0, faces + 41)])
    with pytest.raises(MeshError, match="several fans"):
        ring_tables.rings_from_faces(pinched, 83)


@pytest.mark.parametrize(("degree", "capacity"), [(3, 8), (8, 8), (9, 12), (17, 24), (32, 32), (33, 64), (200, 224)])
def test_ring_capacities_are_few(degree, capacity):
    assert ring_tables.ring_capacity(degree) == capacity


def test_a_vertex_of_large_degree_has_slots():
    """A double pyramid over a 50-gon: two vertices of degree 50."""
    around = np.arange(50)
    after = (around + 1) % 50
    faces = np.concatenate(
        [np.stack([around, after, np.full(50, 50)], 1), np.stack([after, around, np.full(50, 51)], 1)]
    )
    rings = ring_tables.rings_from_faces(faces, 52)
    assert ring_tables.ring_degrees(rings).tolist() == [4] * 50 + [50, 50]
    assert turned(ring_tables.faces_from_rings(rings)) == turned(faces)


# The debug check


def sound_rings() -> np.ndarray:
    """Rings of a sphere with 42 vertices."""
    return ring_tables.rings_from_faces(np.array(trimesh.creation.icosphere(1).faces), 42)


def swap_two(rings):
    rings[20, [0, 1]] = rings[20, [1, 0]]


def forget_one(rings):
    rings[20] = np.append(np.delete(rings[20], 2), -1)


def repeat_one(rings):
    rings[20, 1] = rings[20, 0]


def make_self(rings):
    rings[20, 1] = 20


def leave_gap(rings):
    degree = (rings[20] >= 0).sum()
    rings[20, degree - 1], rings[20, degree] = -1, rings[20, degree - 1]


def reverse_one(rings):
    degree = (rings[20] >= 0).sum()
    rings[20, :degree] = rings[20, :degree][::-1].copy()


def strange_neighbour(rings):
    far = np.setdiff1d(np.arange(42), [*rings[20], 20])[0]
    rings[20, 0] = far


@pytest.mark.parametrize(
    ("damage", "what"),
    [
        (swap_two, "has a face that its neighbours do not have"),
        (reverse_one, "has a face that its neighbours do not have"),
        (forget_one, "is not a neighbour of its neighbour"),
        (strange_neighbour, "is not a neighbour of its neighbour"),
        (repeat_one, "neighbour twice"),
        (make_self, "its own neighbour"),
        (leave_gap, "gap in its ring"),
    ],
)
def test_a_broken_table_is_found(damage, what):
    rings = sound_rings()
    ring_tables.check_closed_manifold(rings, 2)
    damage(rings)
    with pytest.raises(FlowError, match=what):
        ring_tables.check_closed_manifold(rings, 2)


def test_a_change_of_topology_is_found():
    with pytest.raises(FlowError, match="Euler characteristic 2, was 0"):
        ring_tables.check_closed_manifold(sound_rings(), 0)


def test_two_faces_back_to_back_are_no_surface():
    """Three vertices, two faces: every vertex has two neighbours only."""
    rings = np.full((3, 8), -1)
    rings[:, :2] = [[1, 2], [2, 0], [0, 1]]
    with pytest.raises(FlowError, match="fewer than three neighbours"):
        ring_tables.check_closed_manifold(rings, 2)


# Collapse


def is_tetrahedron(around: dict[int, set[int]], a: int) -> bool:
    """Whether the component of ``a`` is a tetrahedron."""
    return len(around[a]) == 3 and all(around[b] == around[a] - {b} | {a} for b in around[a])


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


def test_compaction_renumbers_everything():
    mesh = blob(7)
    meso = meso_of(np.array(mesh.vertices), np.array(mesh.faces))
    collapse.collapse_short_edges(meso, 2 * typical_length(meso))
    small = meso.compacted()
    live = np.flatnonzero(meso.degree)
    assert small.num_rows == small.num_live == len(live) < meso.num_rows
    assert turned(live[small.faces()]) == turned(meso.faces())
    for name in ("positions", "poles", "has_pole", "is_fixed"):
        np.testing.assert_array_equal(getattr(small, name), getattr(meso, name)[live])
    np.testing.assert_array_equal(live[small.node_of_input], meso.node_of_input)
    assert small.volume() == pytest.approx(meso.volume(), rel=1e-12)
    ring_tables.check_closed_manifold(small.rings, 2)


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


def test_a_fully_fixed_surface_does_not_collapse():
    mesh = torus()
    meso = meso_of(np.array(mesh.vertices), np.array(mesh.faces), fixed=1.0)
    assert collapse.collapse_short_edges(meso, 100.0) == []
    assert meso.num_live == 288


def test_an_edge_of_just_the_threshold_stays():
    """A cube's edges have length 1, its diagonals sqrt 2: t_c = 1 takes none, a little more takes some."""
    box = trimesh.creation.box()
    meso = Meso.from_mesh(np.array(box.vertices), np.array(box.faces))
    assert collapse.collapse_short_edges(meso, 1.0) == []
    assert collapse.collapse_short_edges(meso, 1.01)


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


# Split


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


@pytest.mark.parametrize("name", ["twisted torus", "blob", "two parts", "bunny"])
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


@pytest.mark.parametrize("name", ["torus", "blob", "bunny"])
def test_a_few_iterations_of_all_edits(research_mesh, monkeypatch, name):
    """Squeeze, collapse, split, fix, again and again, as the flow does: closed and of the same genus throughout."""
    meso = case(name, research_mesh)
    euler = manifold_euler(meso.faces())
    seen = watch_rounds(monkeypatch)
    t_c = 0.6 * typical_length(meso)
    rounds = 0
    for _ in range(6):
        meso.positions = np.where(meso.is_fixed[:, None], meso.positions, meso.positions * [0.95, 0.7, 0.5])
        rounds += len(collapse.collapse_short_edges(meso, t_c, check=True))
        rounds += len(split.split_obtuse_edges(meso, OBTUSE, t_c / 10, 10**6, check=True)[0])
        fixing.fix_degenerate_vertices(meso, t_c / 10)
        meso = meso.compacted()
        t_c *= 1.3
    assert seen == [euler] * rounds and rounds > 10
    assert np.isfinite(meso.positions).all()
    assert set(meso.node_of_input.tolist()) <= set(range(meso.num_rows))


# Fixing


def test_a_thread_is_fixed():
    """A tube of triangles around a ring: no edge across can go, so every vertex has two, and all become fixed."""
    mesh = torus(1.0, 0.01, 24, 3)
    meso = Meso.from_mesh(np.array(mesh.vertices), np.array(mesh.faces))
    across = 2 * 0.01 * np.sin(np.pi / 3)
    assert fixing.fix_degenerate_vertices(meso, 0.99 * across) == 0
    assert fixing.fix_degenerate_vertices(meso, 1.01 * across) == 72
    assert meso.is_fixed.all()
    assert fixing.fix_degenerate_vertices(meso, 1.01 * across) == 0


def test_one_short_edge_is_not_enough_to_be_fixed():
    """The same tube flattened: each ring of three has one short edge, and none of its vertices has two."""
    mesh = torus(1.0, 0.01, 24, 3)
    meso = Meso.from_mesh(mesh.vertices * [1, 1, 0.5], np.array(mesh.faces))
    assert fixing.fix_degenerate_vertices(meso, 0.01) == 0  # one edge of 0.00866 and two of 0.0156
    assert not meso.is_fixed.any()
    assert fixing.fix_degenerate_vertices(meso, 0.016) == 72


@pytest.mark.parametrize("name", ["torus", "blob", "three-holes"])
def test_fixing_follows_its_rule(research_mesh, name):
    """Fixed are just the vertices with two or more short edges that cannot collapse, counted the slow way."""
    meso = case(name, research_mesh, fixed=0.05)
    meso.positions = meso.positions * [1.0, 0.3, 0.05]
    collapse.collapse_short_edges(meso, 3 * typical_length(meso))
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
    fresh = fixing.fix_degenerate_vertices(meso, t_f)
    np.testing.assert_array_equal(meso.is_fixed, was_fixed | (stuck >= 2))
    assert fresh == int(((stuck >= 2) & ~was_fixed).sum())
    assert (stuck == 1).any() or (stuck >= 2).any()


def test_the_saw_tooth():
    """It rises step by step and falls back once it would pass the top; t_f is a tenth of it."""
    seen = [fixing.threshold(k, 0.002, 0.0001, 0.016) for k in range(300)]
    assert seen[0] == 0.002
    assert max(seen) == pytest.approx(0.016, abs=1e-12)  # (0.016 - 0.002) / 0.0001 = 140 steps take it to the top
    assert [k for k in range(1, 300) if seen[k] < seen[k - 1]] == [141, 282]
    assert fixing.threshold(7, 0.002, 0.0, 0.016) == 0.002
    assert fixing.degenerate_length(0.016) == pytest.approx(0.0016)
