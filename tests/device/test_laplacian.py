"""Laplacian rows against closed forms, a plain NumPy version, the stiffness matrix, and degenerate triangles."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from conftest import blob, torus
from device_cases import (
    build,
    central_difference,
    jitted_rows,
    outwards,
    pebble,
    quick_jit,
    reference_laplacian,
    reference_weights,
    ring_areas,
    slot_rows,
)
from scipy.spatial import ConvexHull, Delaunay

from msf_jax.base.options import LAPLACIANS
from msf_jax.device import laplacian
from msf_jax.device.buffers import slot_product, slot_sum


def rows_of(case, kind, positions=None):
    buffers = case.buffers
    positions = buffers.positions if positions is None else positions
    return jitted_rows(kind, positions, buffers.rings, buffers.degree, case.layout)


def edges_of(case):
    """Used slots, and the vertices i and j of each."""
    used = np.asarray(case.buffers.rings.is_used)
    neighbour = np.asarray(case.buffers.rings.neighbour)
    return used, case.order[slot_rows(case.layout)[used]], case.order[neighbour[used]]


def weight_matrices(case, kind):
    """Dense off-diagonal weights, once as row i's ``out`` to j, once as the ``into`` that i -> j holds for j -> i."""
    rows = rows_of(case, kind)
    used, i, j = edges_of(case)
    out, into = np.zeros((2, len(case.vertices), len(case.vertices)))
    out[i, j] = np.asarray(rows.out)[used]
    into[j, i] = np.asarray(rows.into)[used]
    return out, into


@pytest.fixture(scope="module")
def surfaces():
    """A blob, a torus, and a pebble with many degrees, as cases."""
    ring = torus(around=20)
    made = {"blob": (blob(1, 2).vertices, blob(1, 2).faces), "torus": (ring.vertices, ring.faces), "pebble": pebble(0)}
    return {
        name: build(np.array(vertices) / np.linalg.norm(np.ptp(vertices, axis=0)), np.array(faces))
        for name, (vertices, faces) in made.items()
    }


@pytest.mark.parametrize("kind", LAPLACIANS)
@pytest.mark.parametrize("name", ["blob", "torus", "pebble"])
def test_all_rows_agree_with_half_edges_in_numpy(surfaces, name, kind):
    case = surfaces[name]
    reference = reference_weights(kind, case.vertices, case.faces)
    rows = rows_of(case, kind)
    used, i, j = edges_of(case)
    assert used.sum() == 3 * len(case.faces)
    np.testing.assert_allclose(np.asarray(rows.out)[used], reference[i, j], rtol=1e-10, atol=1e-10)
    np.testing.assert_allclose(np.asarray(rows.into)[used], reference[j, i], rtol=1e-10, atol=1e-10)
    assert not np.asarray(rows.out)[~used].any()
    assert not np.asarray(rows.into)[~used].any()


def stiffness(vertices, faces):
    """G^T M G: gradients of the hat functions on every face, weighted with its area."""
    G, M = np.zeros((3 * len(faces), len(vertices))), np.zeros(3 * len(faces))
    for f, corners in enumerate(faces):
        p = vertices[corners]
        normal = np.cross(p[1] - p[0], p[2] - p[0])
        for k in range(3):
            opposite = p[(k + 2) % 3] - p[(k + 1) % 3]
            G[3 * f : 3 * f + 3, corners[k]] = np.cross(normal, opposite) / (normal @ normal)
        M[3 * f : 3 * f + 3] = np.linalg.norm(normal) / 2
    return G.T @ (M[:, None] * G)


def test_cotangent_is_the_stiffness_matrix_where_no_weight_is_negative():
    points = blob(0, 2).vertices
    points = points / np.linalg.norm(points, axis=1, keepdims=True)  # a hull of points on a sphere is Delaunay
    case = build(points, outwards(points, ConvexHull(points).simplices))
    K = stiffness(case.vertices, case.faces)
    assert (K - np.diag(np.diag(K)) <= 1e-12).all()
    out, into = weight_matrices(case, "cotangent")
    np.testing.assert_allclose(out - np.diag(out.sum(axis=1)), -K, atol=1e-11)
    np.testing.assert_allclose(into, out, atol=1e-13)


def pillow(seed):
    """Two copies of a Delaunay triangulation of a disc, glued along the rim: flat around every vertex but the rim's."""
    random = np.random.default_rng(seed)
    turn, rim = 2 * np.pi * np.arange(14) / 14, 14
    radius, angle = 0.75 * np.sqrt(random.uniform(size=25)), random.uniform(0, 2 * np.pi, size=25)
    disc = np.stack([np.r_[np.cos(turn), radius * np.cos(angle)], np.r_[np.sin(turn), radius * np.sin(angle)]], axis=1)
    top = Delaunay(disc).simplices
    a, b, c = (disc[corner] for corner in top.T)
    is_clockwise = (b - a)[:, 0] * (c - a)[:, 1] < (b - a)[:, 1] * (c - a)[:, 0]
    top = np.where(is_clockwise[:, None], top[:, ::-1], top)
    bottom = np.where(top < rim, top, top + 25)[:, ::-1]
    plane = np.concatenate([disc, disc[rim:]])
    tilt = np.linalg.qr(random.normal(size=(3, 3)))[0]
    vertices = np.concatenate([plane, np.zeros((len(plane), 1))], axis=1) @ tilt
    return vertices, np.concatenate([top, bottom]), np.arange(len(plane)) >= rim


@pytest.mark.parametrize("kind", ["mean_value", "cotangent"])
def test_linear_functions_have_no_laplacian_where_the_surface_is_flat(kind):
    vertices, faces, is_flat = pillow(5)
    case = build(vertices, faces)
    rows, rings = rows_of(case, kind), case.buffers.rings
    linear = case.buffers.positions @ jnp.array([[1.0], [-2.0], [0.5]]) + 3.0
    value = slot_product(case.layout, rows.out, rings.neighbour, linear)[:, 0]
    value = case.to_vertices(value - slot_sum(case.layout, rows.out) * linear[:, 0])
    assert np.abs(value[is_flat]).max() < 1e-11
    assert np.abs(value[~is_flat]).min() > 1e-3  # the rim is a fold; the weights are not just zero


@pytest.mark.parametrize("kind", LAPLACIANS)
def test_slot_sums_and_products_are_those_of_the_matrix(kind):
    case = build(*pebble(1))
    rows, L = rows_of(case, kind), reference_laplacian(kind, case.vertices, case.faces)
    x = np.random.default_rng(0).normal(size=(len(L), 2))
    product = slot_product(case.layout, rows.out, case.buffers.rings.neighbour, jnp.asarray(case.to_rows(x)))
    transposed = slot_product(case.layout, rows.into, case.buffers.rings.neighbour, jnp.asarray(case.to_rows(x)))
    diagonal = case.to_vertices(slot_sum(case.layout, rows.out))
    np.testing.assert_allclose(diagonal, -np.diag(L), rtol=1e-12)
    np.testing.assert_allclose(case.to_vertices(product) - diagonal[:, None] * x, L @ x, atol=1e-12)
    np.testing.assert_allclose(case.to_vertices(transposed) - diagonal[:, None] * x, L.T @ x, atol=1e-12)
    constant = case.to_vertices(slot_product(case.layout, rows.out, case.buffers.rings.neighbour, jnp.ones((256, 1))))
    np.testing.assert_allclose(constant[:, 0], diagonal, rtol=1e-13)


@pytest.mark.parametrize("kind", LAPLACIANS)
@pytest.mark.parametrize("factor", [1e-3, 0.37, 41.0])
def test_weights_have_no_unit(kind, factor):
    case = build(*pebble(2))
    rows, scaled = rows_of(case, kind), rows_of(case, kind, factor * case.buffers.positions)
    np.testing.assert_allclose(scaled.out, rows.out, rtol=1e-11, atol=1e-12)
    np.testing.assert_allclose(scaled.into, rows.into, rtol=1e-11, atol=1e-12)


def test_one_ring_areas():
    case = build(*pebble(3))
    buffers = case.buffers
    areas_of = quick_jit(laplacian.one_ring_areas, static_argnums=3)
    area = areas_of(buffers.positions, buffers.rings, buffers.degree, case.layout)
    np.testing.assert_allclose(case.to_vertices(area), ring_areas(case.vertices, case.faces), rtol=1e-12)
    assert (np.asarray(area)[len(case.order) :] == 1).all()
    flat = areas_of(0 * buffers.positions, buffers.rings, buffers.degree, case.layout)
    assert (np.asarray(flat) > 0).all()


def degenerate_positions(name):
    """Vertices of the pebble, some of its triangles degenerate."""
    vertices, faces = pebble(0)
    a, b, c = faces[0]
    along = vertices[b] - vertices[a]
    if name == "zero edge":
        vertices[b] = vertices[a]
    elif name == "angles 0 and pi":
        vertices[c] = (vertices[a] + vertices[b]) / 2
    elif name == "flat, outside":
        vertices[c] = vertices[a] + 3 * along
    elif name == "triangle in a point":
        vertices[b] = vertices[c] = vertices[a]
    elif name == "one-ring in a point":
        vertices[np.unique(faces[(faces == a).any(axis=1)])] = vertices[a]
    elif name == "all in a point":
        vertices[:] = vertices[a]
    elif name == "all in the origin":
        vertices[:] = 0
    elif name == "all on a line":
        vertices[:, :2] = 0
    elif name == "all on a lattice line":
        vertices = np.round(8 * vertices) / 8 * [0, 1, 0]
    elif name == "folded flat":
        vertices[:, 2] = 0
    return vertices, faces


DEGENERATE = [
    "zero edge",
    "angles 0 and pi",
    "flat, outside",
    "triangle in a point",
    "one-ring in a point",
    "all in a point",
    "all in the origin",
    "all on a line",
    "all on a lattice line",
    "folded flat",
]


def mixed_sum(rows, seed=1):
    """A scalar in which every weight has its own factor."""
    factors = jnp.asarray(np.random.default_rng(seed).normal(size=(2, *rows.out.shape)), rows.out.dtype)
    return (factors[0] * rows.out + factors[1] * rows.into).sum()


@pytest.fixture(scope="module")
def value_and_slope():
    """For a case, a kind and positions: the rows, and the gradient of their mixed sum; compiled once for each kind."""

    def function(positions, buffers, kind, layout):
        rows = laplacian.assemble(kind, positions, buffers.rings, buffers.degree, layout)
        return mixed_sum(rows), rows

    compiled = quick_jit(jax.grad(function, has_aux=True), static_argnames=("kind", "layout"))

    def call(case, kind, positions):
        slope, rows = compiled(positions, case.buffers, kind, case.layout)
        return rows, np.asarray(slope)

    return call


@pytest.mark.parametrize("dtype", [np.float64, pytest.param(np.float32, marks=pytest.mark.slow)])
@pytest.mark.parametrize("kind", ["mean_value", "signed_cotangent"])
def test_nearly_degenerate_triangles_have_finite_weights_and_gradients(value_and_slope, kind, dtype):
    """On the way into each degenerate surface, at distances down to far below a rounding error."""
    start = pebble(0)[0]
    for name in DEGENERATE:
        end, faces = degenerate_positions(name)
        case = build(start, faces, dtype=dtype)
        for distance in 10.0 ** -np.arange(1, 24, 2):
            positions = case.to_rows(end + distance * (start - end)).astype(dtype)
            rows, slope = value_and_slope(case, kind, positions)
            assert rows.out.dtype == rows.into.dtype == slope.dtype == dtype
            assert np.isfinite(rows.out).all(), (name, distance)
            assert np.isfinite(rows.into).all(), (name, distance)
            assert np.isfinite(slope).all(), (name, distance)


@pytest.mark.parametrize("kind", ["mean_value", "cotangent", "signed_cotangent"])
def test_gradient_agrees_with_central_differences(value_and_slope, kind):
    mesh = blob(2, 2)
    case = build(mesh.vertices / np.linalg.norm(mesh.extents), mesh.faces)
    _, slope = value_and_slope(case, kind, case.buffers.positions)
    assert np.abs(slope).max() > 1
    assert not slope[len(case.order) :].any()

    def scalar(vertices):
        return mixed_sum(rows_of(case, kind, jnp.asarray(case.to_rows(vertices))))

    random = np.random.default_rng(9)
    for _ in range(8):
        direction = random.normal(size=case.vertices.shape)
        expected = central_difference(scalar, case.vertices, direction, h=1e-6)
        np.testing.assert_allclose((case.to_vertices(slope) * direction).sum(), expected, rtol=1e-6)


@pytest.mark.parametrize("name", DEGENERATE)
def test_the_energy_of_signed_cotangents_is_never_negative(name):
    """Not of a surface with flat triangles, nor of one that is on its way there."""
    start, (end, faces) = pebble(0)[0], degenerate_positions(name)
    for distance in (0.0, 1e-6, 1e-2):
        rows = rows_of(case := build(end + distance * (start - end), faces), "signed_cotangent")
        used, i, j = edges_of(case)
        L = np.zeros((len(end), len(end)))
        L[i, j] = np.asarray(rows.out)[used]
        value = np.linalg.eigvalsh(np.diag(L.sum(axis=1)) - L)
        assert value.min() >= -1e-12 * value.max()
