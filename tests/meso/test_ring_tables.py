"""Ring tables, to faces and back, and the compiled edits against NumPy, or against their own text interpreted."""

import types

import numpy as np
import pytest
import trimesh
from conftest import blob, torus
from hypothesis import given, settings
from hypothesis import strategies as st
from meso_cases import SURFACES, case, manifold_euler, meso_of, neighbours_of, turned, typical_length

from msf_jax.base.errors import MeshError
from msf_jax.meso import edits, kernels, ring_tables
from msf_jax.meso.meso import Meso
from msf_jax.numerics import compiled


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
    ball = trimesh.creation.icosphere(2)
    for vertex, ring in enumerate(ring_tables.rings_from_faces(np.array(ball.faces), len(ball.vertices))):
        ring = ring[ring >= 0]  # counter-clockwise, seen from outside
        turn = np.cross(ball.vertices[ring], ball.vertices[np.roll(ring, -1)]) @ ball.vertices[vertex]
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


def test_compaction_renumbers_everything():
    mesh = blob(7)
    meso = meso_of(np.array(mesh.vertices), np.array(mesh.faces))
    edits.collapse_short_edges(meso, 2 * typical_length(meso))
    small = meso.compacted()
    live = np.flatnonzero(meso.degree)
    assert small.num_rows == small.num_live == len(live) < meso.num_rows
    assert turned(live[small.faces()]) == turned(meso.faces())
    for name in ("positions", "poles", "has_pole", "is_fixed"):
        np.testing.assert_array_equal(getattr(small, name), getattr(meso, name)[live])
    np.testing.assert_array_equal(live[small.node_of_input], meso.node_of_input)
    assert small.volume() == pytest.approx(meso.volume(), rel=1e-12)
    assert manifold_euler(small.faces()) == 2


def short_edges(meso: Meso, is_touched: np.ndarray, limit: float) -> np.ndarray:
    return edits.Waiting().find(kernels.short_edges, meso, is_touched, limit).T


def edges_in_numpy(meso: Meso, is_touched: np.ndarray) -> tuple[np.ndarray, ...]:
    """Every edge with an end that is touched, from the smaller one that is, and what `short_edges` says of it."""
    vertex, slot = np.nonzero((meso.rings >= 0) & is_touched[:, None])
    other = meso.rings[vertex, slot]
    rows = (other > vertex) | ~is_touched[other]
    a, b = np.minimum(vertex, other)[rows], np.maximum(vertex, other)[rows]
    return a, b, *ring_tables.apexes(meso.rings, meso.degree, a, b), edits.edge_lengths(meso.positions, a, b)


@pytest.mark.parametrize("share", [0.0, 0.1, 1.0])
@pytest.mark.parametrize("mesh", [blob(71, 2), torus()], ids=["blob", "torus"])
def test_short_edges_are_those_of_numpy(mesh, share):
    """In the same order; on the torus, lengths are tied."""
    meso, random = Meso.from_mesh(np.array(mesh.vertices), np.array(mesh.faces)), np.random.default_rng(2)
    is_touched = random.uniform(size=meso.num_rows) < share
    a, b, left, right, length = edges_in_numpy(meso, is_touched)
    if share == 1.0:  # thin vertices make their edges long
        meso.scale = random.uniform(0.5, 1.0, meso.num_rows)
        length = length / np.minimum(meso.scale[a], meso.scale[b])
    around = [set(ring[ring >= 0].tolist()) for ring in meso.rings]
    for limit in (0.0, np.median(length) if len(length) else 1.0, 9.0):
        rows = np.flatnonzero(length < limit)
        common = [len(around[i] & around[j]) for i, j in zip(a[rows], b[rows], strict=True)]
        expected = np.stack([a[rows], b[rows], left[rows], right[rows], np.array(common, dtype=np.int64)])
        np.testing.assert_array_equal(short_edges(meso, is_touched, float(limit)), expected)


@given(st.data())
@settings(deadline=None, max_examples=60)
def test_what_is_chosen_apart_is_what_a_greedy_loop_chooses(data):
    vertex = st.integers(0, 9)
    claims = data.draw(st.lists(st.lists(vertex, min_size=3, max_size=3, unique=True), max_size=12))
    order = data.draw(st.permutations(range(len(claims))))
    taken: set[int] = set()
    expected = []
    for row in order:
        if not taken & set(claims[row]):
            taken |= set(claims[row])
            expected.append(row)
    rows = np.array(claims, dtype=np.int64).reshape(-1, 3)
    found = edits.first_apart(rows, np.array(order, dtype=np.int64), 10)
    assert found.tolist() == sorted(expected)


def interpreted(kernel: compiled.Kernel) -> types.FunctionType:
    """The kernel as Python runs it, with its parts."""
    names = kernel.function.__globals__
    used = {name: names[name] for name in kernel.function.__code__.co_names if name in names}
    parts = {name: interpreted(value) for name, value in used.items() if isinstance(value, compiled.Kernel)}
    return types.FunctionType(kernel.function.__code__, {**names, **parts})


@pytest.mark.parametrize("kernel", [kernels.collapse, kernels.cut], ids=["collapse", "cut"])
def test_surgery_does_what_its_text_says(kernel, monkeypatch):
    """A surface of random classes, edited by the compiled loop and by the same text, interpreted."""
    ring, found = torus(around=12, across=8), []
    for name in ("compiled", "interpreted"):
        meso = meso_of(ring.vertices, ring.faces)
        meso.classes = np.where(meso.rings >= 0, np.random.default_rng(4).integers(-99, 99, meso.rings.shape), 0)
        if name == "interpreted":
            monkeypatch.setattr(kernels, kernel.__name__, interpreted(kernel))
        if kernel.__name__ == "collapse":
            edits.collapse_short_edges(meso, 0.12)
        else:
            edits.split_long_edges(meso, 0.12)
        found.append((meso.rings, meso.classes * (meso.rings >= 0), meso.degree, meso.positions))
        assert len(meso.edits) > 1
    for one, other in zip(*found, strict=True):
        np.testing.assert_array_equal(one, other)
