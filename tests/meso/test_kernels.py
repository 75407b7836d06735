"""Compiled loops against the same said in NumPy, or in the kernel's own text interpreted, on cases without mercy."""

import subprocess
import sys
import threading
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
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.triangles import boxes, point_triangle_distance2, tree_of

lattice = st.integers(-2, 2).map(float)  # few values, so that points coincide, and lie on lines, edges and faces
point = st.tuples(lattice, lattice, lattice)


def distance2_in_numpy(point: np.ndarray, triangle: np.ndarray) -> np.ndarray:
    """Squared distance (c,) from each point to each triangle, by masks, to the same bits."""
    best = np.full(len(point), np.inf)
    for k in range(3):  # to the three edges
        a, b = triangle[:, k], triangle[:, (k + 1) % 3]
        along, offset = b - a, point - a
        length2 = np.einsum("ij,ij->i", along, along)
        t = np.einsum("ij,ij->i", offset, along) / np.where(length2 > 0, length2, 1.0)
        rest = offset - np.clip(t, 0.0, 1.0)[:, None] * along
        best = np.minimum(best, np.einsum("ij,ij->i", rest, rest))
    # To the plane, where the foot of the perpendicular lies in the triangle.
    a, ab, ac = triangle[:, 0], triangle[:, 1] - triangle[:, 0], triangle[:, 2] - triangle[:, 0]
    normal, offset = np.cross(ab, ac), point - a
    area2 = np.einsum("ij,ij->i", normal, normal)
    safe = np.where(area2 > 0, area2, 1.0)
    v = np.einsum("ij,ij->i", np.cross(offset, ac), normal) / safe
    w = np.einsum("ij,ij->i", np.cross(ab, offset), normal) / safe
    is_over = (v >= 0) & (w >= 0) & (v + w <= 1) & (area2 > 0)
    return np.where(is_over, np.minimum(best, np.einsum("ij,ij->i", offset, normal) ** 2 / safe), best)


@given(st.lists(st.tuples(point, point, point, point), min_size=1, max_size=20))
@settings(deadline=None, max_examples=60)
def test_distances_are_those_of_numpy_bit_for_bit(rows):
    """Triangles that are segments and points among them, and points on edges and corners."""
    cases = np.array(rows)
    found = point_triangle_distance2(cases[:, 0].copy(), cases[:, 1:].copy())
    np.testing.assert_array_equal(found, distance2_in_numpy(cases[:, 0], cases[:, 1:]))


def test_distances_of_triangles_in_general_position_are_those_of_numpy_bit_for_bit():
    random = np.random.default_rng(1)
    points, triangles = random.normal(size=(3000, 3)), random.normal(size=(3000, 3, 3))
    np.testing.assert_array_equal(point_triangle_distance2(points, triangles), distance2_in_numpy(points, triangles))


@given(st.lists(point, min_size=3, max_size=8), st.data())
@settings(deadline=None, max_examples=60)
def test_the_nearest_triangle_is_the_first_of_the_nearest(corners, data):
    """Any soup of triangles, degenerate, coincident and symmetric ones, and points as far from one as from another."""
    vertices = np.array(corners)
    corner = st.integers(0, len(vertices) - 1)
    faces = np.array(data.draw(st.lists(st.tuples(corner, corner, corner), min_size=1, max_size=9)))
    points = np.array(data.draw(st.lists(point, min_size=1, max_size=9)))
    triangles = vertices[faces]
    away = np.stack([distance2_in_numpy(np.tile(row, (len(faces), 1)), triangles) for row in points])
    if np.ptp(vertices, axis=0).max() > 0:  # samples of the surface need an extent
        distance, triangle = Enclosure(vertices, faces).nearest(points)
        np.testing.assert_array_equal(distance, np.sqrt(away.min(axis=1)))
        np.testing.assert_array_equal(triangle, away.argmin(axis=1))


@pytest.mark.parametrize("num", [1, 2, 3, 5, 8, 13, 100])
def test_every_box_of_the_tree_holds_those_below_it(num):
    low = np.random.default_rng(num).normal(size=(num, 3))
    found, order = tree_of(low, low + 0.1)
    assert sorted(order.tolist()) == list(range(num))
    np.testing.assert_array_equal(found[num:], np.concatenate([low, low + 0.1], axis=1)[order])
    for node in range(1, num):
        below = found[[2 * node, 2 * node + 1]]
        np.testing.assert_array_equal(found[node], np.r_[below[:, :3].min(axis=0), below[:, 3:].max(axis=0)])


def test_points_on_the_rim_of_a_face_and_rays_along_one():
    """Heights of a box that are those of its walls and edges: rays along faces, through edges, and from the surface."""
    shape = Enclosure(*(np.array(part) for part in (trimesh.creation.box().vertices, trimesh.creation.box().faces)))
    place = np.array([-0.5, -0.25, 0.0, 0.25, 0.5])
    points = np.stack(np.meshgrid(place, place, place, indexing="ij"), axis=-1).reshape(-1, 3)
    for axis in np.concatenate([np.eye(3), -np.eye(3)]):
        found = shape.ray_lengths(points, np.tile(axis, (len(points), 1)), np.full(len(points), 3.0))
        is_inner = (np.abs(points[:, axis == 0]) < 0.5).all(axis=1) & (points @ axis < 0.5) & (points @ axis > -0.5)
        np.testing.assert_allclose(found[is_inner], 0.5 - points[is_inner] @ axis, rtol=1e-12)
    distance, triangle = shape.nearest(points)
    is_on = np.abs(points).max(axis=1) == 0.5
    np.testing.assert_array_equal(distance == 0, is_on)
    low, high = boxes(shape.triangles[triangle[is_on]])
    assert ((points[is_on] >= low) & (points[is_on] <= high)).all()


# Edits


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


# What every kernel shares


def test_arrays_of_another_kind_are_taken_as_copies():
    """Other types, strides and byte orders, and arrays that may not be written to."""
    shape = Enclosure(np.array(blob(73, 1).vertices), np.array(blob(73, 1).faces))
    points = np.random.default_rng(5).integers(-1, 2, (20, 3)) / 2
    frozen = points.copy()
    frozen.flags.writeable = False
    plain = shape.nearest(points), shape.winding_numbers(points)
    others = points.astype(np.float32), np.asfortranarray(points), frozen, points.astype(">f8"), points[::-1][::-1]
    for other in others:
        np.testing.assert_array_equal(shape.nearest(other), plain[0])
        np.testing.assert_array_equal(shape.winding_numbers(other), plain[1])


PROGRAM = """
import sys
import msf_jax
from msf_jax.solid import triangles
assert "llvmlite" not in sys.modules
import numpy as np
print(triangles.point_triangle_distance2(np.ones((1, 3)), np.eye(3)[None])[0])
assert "numba" not in sys.modules
"""


@pytest.mark.system
def test_neither_numba_nor_a_folder_is_needed():
    found = subprocess.run([sys.executable, "-c", PROGRAM], capture_output=True, text=True, timeout=300)
    assert float(found.stdout) == pytest.approx(4 / 3), found.stderr


def test_threads_may_call_kernels_at_once():
    points, triangles = (
        np.random.default_rng(6).normal(size=(2000, 3)),
        np.random.default_rng(7).normal(size=(2000, 3, 3)),
    )
    expected, found = point_triangle_distance2(points, triangles), {}
    threads = [
        threading.Thread(target=lambda k=k: found.update({k: point_triangle_distance2(points, triangles)}))
        for k in range(4)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for each in found.values():
        np.testing.assert_array_equal(each, expected)
