"""Surfaces in buffers for the tests of `device`, and what they are compared with: NumPy over half-edges."""

from contextlib import contextmanager
from functools import partial
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
import scipy.sparse as sp
from scipy.spatial import ConvexHull

from msf_jax.base.layout import Layout, Level, fits, layout_for
from msf_jax.base.options import SolverOptions
from msf_jax.device import laplacian
from msf_jax.device.buffers import Buffers, Rings
from msf_jax.device.contraction import Energy, relaxed
from msf_jax.meso import packing
from msf_jax.meso.meso import Meso

TIGHT = 1e-13  # relative residual of solves that are compared with direct ones
MANY = 5000  # CG steps that no test needs


def Solver(tolerance: Any, max_steps: Any) -> SolverOptions:
    """Options of numbers that JAX may trace."""
    return SolverOptions(tolerance=tolerance, max_steps=max_steps)


class Case(NamedTuple):
    """A surface as the tests know it (in the order of its vertices), and the same in buffers (in rows)."""

    vertices: np.ndarray
    faces: np.ndarray
    is_fixed: np.ndarray
    poles: np.ndarray
    has_pole: np.ndarray
    layout: Layout
    order: np.ndarray  # the vertex in each live row
    buffers: Buffers

    @property
    def rank(self) -> np.ndarray:
        """The row of each vertex."""
        return np.argsort(self.order)

    def to_rows(self, values: np.ndarray, fill: float = 0.0) -> np.ndarray:
        """``values`` of the vertices in their rows, ``fill`` in the padded ones."""
        rows = np.full((self.layout.capacity, *np.shape(values)[1:]), fill, dtype=np.float64)
        rows[: len(self.order)] = np.asarray(values)[self.order]
        return rows

    def to_vertices(self, rows: np.ndarray) -> np.ndarray:
        """The vertices' part of ``rows``, in their order."""
        return np.asarray(rows)[self.rank]


def build(vertices, faces, *, is_fixed=None, poles=None, has_pole=None, layout=None, dtype=np.float64) -> Case:
    """``vertices`` (as they are) and ``faces`` in buffers, the way that the flow packs them."""
    vertices, faces = np.array(vertices, dtype=np.float64), np.array(faces)
    meso = Meso.from_mesh(vertices, faces)
    if is_fixed is not None:
        meso.is_fixed = np.array(is_fixed, dtype=bool)
    if poles is not None:
        meso.poles, meso.has_pole = np.array(poles), np.ones(len(vertices), dtype=bool)
    if has_pole is not None:
        meso.has_pole = np.array(has_pole, dtype=bool)
    layout = small_layout(len(vertices), packing.rows_beyond(meso.degree)) if layout is None else layout
    order, _, fields = packing.pack(meso, layout, ring_areas(vertices, faces), np.dtype(dtype))
    fields["rings"] = Rings(*fields["rings"])
    buffers = jax.tree_util.tree_map(jnp.asarray, Buffers(**fields))
    return Case(vertices, faces, meso.is_fixed, meso.poles, meso.has_pole, layout, order, buffers)


def small_layout(count: int, rows_beyond: list[int]) -> Layout:
    """A staircase with fewer rows than the flow's smallest, and fewer slots: a program takes time for each."""
    for rows in (256, 512):
        layout = Layout(rows, (Level(6, rows, 0), Level(2, rows // 2, 6 * rows), Level(2, rows // 8, 7 * rows)))
        if fits(layout, count, rows_beyond):
            return layout
    return layout_for(count, rows_beyond)


def one_level(capacity: int, slots: int) -> Layout:
    """A small layout without stairs, for cases of a few vertices."""
    return Layout(capacity, (Level(slots, capacity, 0),))


# Operators of `cg.solve`


class Diagonal(NamedTuple):
    """A diagonal matrix (n, n). Its preconditioner is 1, so CG needs a step for each different entry."""

    entries: jax.Array

    def __call__(self, x):
        return self.entries[:, None] * x

    def diagonal(self):
        return jnp.ones_like(self.entries)


# Surfaces


def pebble(seed: int, count: int = 120) -> tuple[np.ndarray, np.ndarray]:
    """Vertices and faces of a bumpy convex-ish surface of diagonal 1, triangles and degrees irregular, genus 0."""
    random = np.random.default_rng(seed)
    height = 1 - (2 * np.arange(count) + 1) / count
    turn = np.pi * (1 + 5**0.5) * np.arange(count)
    points = np.stack([np.cos(turn), np.sin(turn), np.zeros(count)], axis=1) * np.sqrt(1 - height**2)[:, None]
    points[:, 2] = height
    points += 0.6 / np.sqrt(count) * random.normal(size=points.shape)
    points /= np.linalg.norm(points, axis=1, keepdims=True)
    faces = outwards(points, ConvexHull(points).simplices)
    points *= (
        1 + 0.2 * np.sin(3 * points[:, :1] + 1) * np.cos(2 * points[:, 1:2]) + 0.02 * random.normal(size=(count, 1))
    )
    points *= [1.0, 0.7, 1.6]
    return points / np.linalg.norm(np.ptp(points, axis=0)), faces


def outwards(points: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """``faces`` of a convex body around the origin, turned to face outwards."""
    a, b, c = (points[corner] for corner in faces.T)
    is_inwards = np.einsum("ij,ij->i", np.cross(b - a, c - a), a) < 0
    return np.where(is_inwards[:, None], faces[:, ::-1], faces).astype(np.int64)


def bipyramid(sides: int, radius: float, top: float, bottom: float) -> tuple[np.ndarray, np.ndarray]:
    """A regular polygon (vertices 0, 1, ...) with an apex at height ``top`` and one at -``bottom`` (the last two)."""
    turn = 2 * np.pi * np.arange(sides) / sides
    ring = np.stack([radius * np.cos(turn), radius * np.sin(turn), np.zeros(sides)], axis=1)
    i, j = np.arange(sides), (np.arange(sides) + 1) % sides
    upper = np.stack([i, j, np.full(sides, sides)], axis=1)
    lower = np.stack([j, i, np.full(sides, sides + 1)], axis=1)
    return np.concatenate([ring, [[0, 0, top], [0, 0, -bottom]]]), np.concatenate([upper, lower])


def case_with_everything(seed: int = 3, *, layout=None, order=None) -> Case:
    """A pebble with some vertices fixed, poles off the surface, and vertices without one; ``order`` renumbers it."""
    vertices, faces = pebble(seed)
    random = np.random.default_rng(seed + 100)
    is_fixed = random.uniform(size=len(vertices)) < 0.15
    poles = 0.3 * vertices + 0.02 * random.normal(size=vertices.shape)
    has_pole = random.uniform(size=len(vertices)) < 0.8
    if order is not None:
        number = np.argsort(order)
        vertices, poles, is_fixed, has_pole = vertices[order], poles[order], is_fixed[order], has_pole[order]
        faces = number[faces]
    return build(vertices, faces, is_fixed=is_fixed, poles=poles, has_pole=has_pole, layout=layout)


# References


def ring_areas(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Area of the triangles around each vertex."""
    a, b, c = (vertices[corner] for corner in faces.T)
    total = np.zeros(len(vertices))
    for corner in faces.T:
        np.add.at(total, corner, 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1))
    return total


def corner_angles(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """(F, 3) interior angles."""
    angles = []
    for k in range(3):
        a, b, c = (vertices[faces[:, (k + m) % 3]] for m in range(3))
        cross = np.linalg.norm(np.cross(b - a, c - a), axis=1)
        angles.append(np.arctan2(cross, np.einsum("ij,ij->i", b - a, c - a)))
    return np.stack(angles, axis=1)


def reference_weights(kind: str, vertices: np.ndarray, faces: np.ndarray, largest: float = np.inf) -> sp.csr_array:
    """Off-diagonal entries (V, V) of the Laplacian ``kind``, added up face by face from angles (article Eq. 4)."""
    count, angles = len(vertices), corner_angles(vertices, faces)
    i, j, part = [], [], []
    for k in range(3):
        a, b, c = (faces[:, (k + m) % 3] for m in range(3))
        if kind == "mean_value":  # the angle at a counts for both edges that leave a
            i, j, part = [*i, a, a], [*j, b, c], [*part, np.tan(angles[:, k] / 2), np.tan(angles[:, k] / 2)]
        elif kind in ("cotangent", "signed_cotangent"):  # the angle at a counts for the edge opposite, both ways
            half = 0.5 / np.tan(angles[:, k])
            if kind == "signed_cotangent":
                half = half * roundness(vertices, faces)
            i, j, part = [*i, b, c], [*j, c, b], [*part, half, half]
        else:  # every edge i -> j is that of one face
            assert kind == "uniform", f"no reference for the Laplacian {kind}"
            i, j, part = [*i, a], [*j, b], [*part, np.ones(len(a))]
    entries = (np.concatenate(part), (np.concatenate(i), np.concatenate(j)))
    weights = sp.coo_array(entries, shape=(count, count)).tocsr().tocoo()
    row, column = weights.coords
    value = weights.data
    if kind == "mean_value":
        length = np.linalg.norm(vertices[row] - vertices[column], axis=1)
        mean_length = np.bincount(row, weights=length) / np.bincount(row)
        value = value / length * mean_length[row]
    if kind == "cotangent":
        value = np.maximum(value, 0.0)
    return sp.coo_array((np.minimum(value, largest), (row, column)), shape=(count, count)).tocsr()


def roundness(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """(F,) the factor on signed cotangents: a triangle's height over its longest edge, over 0.3, up to 1."""
    p, q, r = (vertices[corner] for corner in faces.T)
    longest2 = np.max([((end - start) ** 2).sum(axis=1) for start, end in ((p, q), (q, r), (r, p))], axis=0)
    return np.minimum(1.0, np.linalg.norm(np.cross(q - p, r - p), axis=1) / longest2 / 0.3)


def reference_laplacian(kind: str, vertices: np.ndarray, faces: np.ndarray, largest: float = np.inf) -> np.ndarray:
    """The dense matrix L with (L x)_i = sum of w_ij (x_j - x_i)."""
    weights = reference_weights(kind, vertices, faces, largest).toarray()
    return weights - np.diag(weights.sum(axis=1))


def slot_rows(layout: Layout) -> np.ndarray:
    """(S,) the row of every slot, from the definition: level by level, slot by slot."""
    rows = np.full(layout.num_slots, -1)
    for level in layout.levels:
        for k in range(level.slots):
            for row in range(level.rows):
                rows[level.offset + k * level.rows + row] = row
    return rows


# The package's functions on weights that are scalars or (n,), plain and compiled once for each layout

quick_jit = partial(jax.jit, compiler_options={"xla_backend_optimization_level": 0})  # compiles in half the time


@contextmanager
def strict():
    """Both modes of JAX that a user may have set for all programs; an error names its own."""
    with jax.numpy_dtype_promotion("strict"), jax.numpy_rank_promotion("raise"):
        yield


def plain_rows(kind: str, positions, rings, degree, layout) -> laplacian.LaplacianRows:
    """`laplacian.assemble`."""
    return laplacian.assemble(kind, positions, rings, degree, layout)


def plain_contract(buffers, w_L, w_H, w_M, layout, kind="mean_value", tolerance=TIGHT, max_steps=MANY):
    """The contraction's step, rows assembled from the same positions."""
    one = jnp.ones_like(buffers.free)
    rows = laplacian.assemble(kind, buffers.positions, buffers.rings, buffers.degree, layout)
    energy = Energy(0 * one, w_L * one, (w_H * one) ** 2, (w_M * buffers.pull) ** 2)
    return relaxed(buffers, rows, energy, layout, Solver(tolerance, max_steps))


def plain_smooth(buffers, strength, layout, kind="mean_value", tolerance=TIGHT, max_steps=MANY):
    """The smoothing's step, rows assembled from the same positions."""
    rows = laplacian.assemble(kind, buffers.positions, buffers.rings, buffers.degree, layout)
    one = jnp.ones_like(buffers.free)
    energy = Energy(one, -strength * one, 0 * one, 0 * one)
    return relaxed(buffers, rows, energy, layout, Solver(tolerance, max_steps))


jitted_rows = quick_jit(plain_rows, static_argnames=("kind", "layout"))
compiled_contract = quick_jit(plain_contract, static_argnames=("layout", "kind"))
compiled_smooth = quick_jit(plain_smooth, static_argnames=("layout", "kind"))


def jitted_contract(buffers, w_L, w_H, w_M, layout, kind="mean_value", tolerance=TIGHT, max_steps=MANY):
    """`plain_contract`, compiled once for all numbers."""
    w_L, w_H, w_M, tolerance, max_steps = map(np.asarray, (w_L, w_H, w_M, tolerance, max_steps))
    return compiled_contract(buffers, w_L, w_H, w_M, layout, kind, tolerance, max_steps)


def jitted_smooth(buffers, strength, layout, kind="mean_value", tolerance=TIGHT, max_steps=MANY):
    """`plain_smooth`, likewise."""
    strength, tolerance, max_steps = map(np.asarray, (strength, tolerance, max_steps))
    return compiled_smooth(buffers, strength, layout, kind, tolerance, max_steps)


def dense_contract(L, vertices, poles, is_fixed, w_L, w_H, w_M) -> np.ndarray:
    """Article Eq. 2 by `numpy.linalg.lstsq` on the stacked rows [W_L L; W_H; W_M], fixed vertices eliminated."""
    free = ~is_fixed
    w_L, w_H, w_M = (np.broadcast_to(w, len(vertices))[free] for w in (w_L, w_H, w_M))
    among, towards_fixed = L[np.ix_(free, free)], L[np.ix_(free, is_fixed)]
    A = np.concatenate([w_L[:, None] * among, np.diag(w_H), np.diag(w_M)])
    known = -w_L[:, None] * (towards_fixed @ vertices[is_fixed])
    b = np.concatenate([known, w_H[:, None] * vertices[free], w_M[:, None] * poles[free]])
    moved = vertices.copy()
    moved[free] = np.linalg.lstsq(A, b, rcond=None)[0]
    return moved


def dense_smooth(L, vertices, is_fixed, strength) -> np.ndarray:
    """(I - lambda L) V' = V by `numpy.linalg.solve`, with V' = V for fixed vertices."""
    strength = np.where(is_fixed, 0.0, np.broadcast_to(strength, len(vertices)))
    return np.linalg.solve(np.eye(len(vertices)) - strength[:, None] * L, vertices)


def central_difference(function, x: np.ndarray, direction: np.ndarray, h: float = 1e-5) -> float:
    """Slope of a scalar ``function`` at ``x`` along ``direction``, by differences of fourth order."""
    x, direction = np.asarray(x, dtype=np.float64), np.asarray(direction, dtype=np.float64)
    near = float(function(x + h * direction)) - float(function(x - h * direction))
    far = float(function(x + 2 * h * direction)) - float(function(x - 2 * h * direction))
    return (8 * near - far) / (12 * h)
