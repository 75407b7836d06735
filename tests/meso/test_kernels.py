"""The compiled edits against the same said in NumPy, or in the kernel's own text interpreted."""

import types

import numpy as np
import pytest
import trimesh
from conftest import blob, torus
from hypothesis import given, settings
from hypothesis import strategies as st

from msf_jax.meso import collapse, kernels, ring_tables, split
from msf_jax.meso.meso import Meso
from msf_jax.numerics import compiled


def meso_of(mesh: trimesh.Trimesh) -> Meso:
    return Meso.from_mesh(np.array(mesh.vertices), np.array(mesh.faces))


def short_edges(meso: Meso, is_touched: np.ndarray, limit: float) -> np.ndarray:
    return collapse.Waiting().find(kernels.short_edges, meso, is_touched, limit).T


def edges_in_numpy(meso: Meso, is_touched: np.ndarray) -> tuple[np.ndarray, ...]:
    """Every edge with an end that is touched, from the smaller one that is, and what `short_edges` says of it."""
    vertex, slot = np.nonzero((meso.rings >= 0) & is_touched[:, None])
    other = meso.rings[vertex, slot]
    rows = (other > vertex) | ~is_touched[other]
    a, b = np.minimum(vertex, other)[rows], np.maximum(vertex, other)[rows]
    return a, b, *ring_tables.apexes(meso.rings, meso.degree, a, b), collapse.edge_lengths(meso.positions, a, b)


@pytest.mark.parametrize("share", [0.0, 0.1, 1.0])
@pytest.mark.parametrize("mesh", [blob(71, 2), torus()], ids=["blob", "torus"])
def test_short_edges_are_those_of_numpy(mesh, share):
    """In the same order; on the torus, lengths are tied."""
    meso, random = meso_of(mesh), np.random.default_rng(2)
    is_touched = random.uniform(size=meso.num_rows) < share
    a, b, left, right, length = edges_in_numpy(meso, is_touched)
    around = [set(ring[ring >= 0].tolist()) for ring in meso.rings]
    for limit in (0.0, np.median(length) if len(length) else 1.0, 9.0):
        rows = np.flatnonzero(length < limit)
        common = [len(around[i] & around[j]) for i, j in zip(a[rows], b[rows], strict=True)]
        expected = np.stack([a[rows], b[rows], left[rows], right[rows], np.array(common, dtype=np.int64)])
        np.testing.assert_array_equal(short_edges(meso, is_touched, float(limit)), expected)


def test_scales_of_thin_vertices_make_their_edges_long():
    meso = meso_of(blob(72, 1))
    meso.scale = np.random.default_rng(3).uniform(0.1, 1.0, meso.num_rows)
    every = np.ones(meso.num_rows, dtype=bool)
    a, b, _, _, length = edges_in_numpy(meso, every)
    limit = 2 * float(np.median(length))
    is_short = length < limit * np.minimum(meso.scale[a], meso.scale[b])
    found = short_edges(meso, every, limit)
    np.testing.assert_array_equal(found[:2], [a[is_short], b[is_short]])
    assert 0 < is_short.sum() < len(a)


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
    found = collapse.first_apart(rows, np.array(order, dtype=np.int64), 10)
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
    found = []
    for name in ("compiled", "interpreted"):
        meso = meso_of(torus(around=12, across=8))
        meso.classes = np.where(meso.rings >= 0, np.random.default_rng(4).integers(-99, 99, meso.rings.shape), 0)
        if name == "interpreted":
            monkeypatch.setattr(kernels, kernel.__name__, interpreted(kernel))
        if kernel.__name__ == "collapse":
            collapse.collapse_short_edges(meso, 0.35, check=True)
        else:
            split.split_long_edges(meso, 0.35, check=True)
        found.append((meso.rings, meso.classes * (meso.rings >= 0), meso.degree, meso.positions))
        assert len(meso.edits) > 1
    for one, other in zip(*found, strict=True):
        np.testing.assert_array_equal(one, other)


def test_a_surface_of_other_types_is_edited_alike():
    """As a checkpoint of another machine may have them: smaller, of the other byte order, read-only."""
    found = []
    for kind in (np.float32, np.float64, ">f8"):
        mesh = meso_of(blob(74, 2))
        mesh.positions = mesh.positions.astype(np.float32).astype(kind)
        mesh.poles, mesh.weights = mesh.positions[::-1], np.ones((mesh.num_rows, 4), dtype=kind)
        mesh.scale = np.ones(mesh.num_rows, dtype=kind)
        mesh.positions.flags.writeable = False
        collapse.collapse_short_edges(mesh, 0.3, check=True)
        split.split_long_edges(mesh, 0.4, check=True)
        found.append((mesh.positions, mesh.rings, mesh.poles, mesh.scale))
        assert len(mesh.edits) > 3
    for other in found[1:]:
        for one, same in zip(found[0], other, strict=True):
            np.testing.assert_array_equal(one, same)
