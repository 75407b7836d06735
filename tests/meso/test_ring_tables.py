"""Ring tables: to faces and back, their edges, and what is wrong with a broken one."""

import numpy as np
import pytest
import trimesh
from conftest import blob
from meso_cases import SURFACES, case, meso_of, neighbours_of, turned

from msf_jax.base.errors import FlowError, MeshError
from msf_jax.meso import ring_tables


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
