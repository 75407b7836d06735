"""Curves and solids for the tests of `curve` and `limbs`, and what is asked of them."""

from functools import partial

import manifold3d
import numpy as np
import trimesh

from msf_jax import metrics
from msf_jax.curve import handle_loops
from msf_jax.curve.finishing import Draft, Job
from msf_jax.inside.containment import Roadmap
from msf_jax.limbs.tree import LimbTree
from msf_jax.solid.enclosure import Enclosure
from tests.benchmarks import ground_truth


def path(points):
    """A polyline as (vertices, edges)."""
    points = np.array(points, dtype=float)
    return points, np.stack([np.arange(len(points) - 1), np.arange(1, len(points))], axis=1)


def unit_shape(mesh):
    """The mesh with a diagonal of 1 as an Enclosure, and the factor."""
    size = np.linalg.norm(np.ptp(mesh.vertices, axis=0))
    return Enclosure(np.asarray(mesh.vertices) / size, np.asarray(mesh.faces)), 1 / size


def is_inside(shape, x, edges):
    """By dense samples of the winding number, not by rays."""
    points = metrics.sample_curve(x, edges, 1e-4)[0]
    return shape.contains(points).all()


def none_held(x):
    return np.zeros(len(x), dtype=bool)


def length_of(x, edges):
    return np.linalg.norm(x[edges[:, 0]] - x[edges[:, 1]], axis=1).sum()


def tube(points, radius=0.15, sides=16):
    points = np.array(points, dtype=float)
    return ground_truth.swept_tube(points, np.full(len(points), radius), sides)


def bow(turn, num=60):
    """Points of an arc of radius 1 that goes ``turn`` of the way round."""
    angle = np.linspace(0, 2 * np.pi * turn, num)
    return np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)


def turns_of(x, edges):
    """Degrees by which the curve turns at each node with two edges."""
    ends = np.concatenate([edges, edges[:, ::-1]])
    ends = ends[np.argsort(ends[:, 0], kind="stable")]
    inner = np.flatnonzero(np.bincount(edges.ravel(), minlength=len(x)) == 2)
    start = np.searchsorted(ends[:, 0], inner)
    a, b = x[inner] - x[ends[start, 1]], x[ends[start + 1, 1]] - x[inner]
    cosine = np.einsum("ni,ni->n", a, b) / np.linalg.norm(a, axis=1) / np.linalg.norm(b, axis=1)
    return np.degrees(np.arccos(np.clip(cosine, -1, 1)))


def job_of(shape):
    """What a pass may ask of the solid ``shape``."""
    return Job(shape, shape, 1.5, Roadmap(shape), partial(LimbTree, shape), 0.5)


def draft_of(x, edges):
    """A curve as the flow leaves it, of which nothing is held."""
    every = np.arange(len(x))
    return Draft(x, edges, none_held(x), every, every)


def bored(solid, at, radius):
    """The mesh of a manifold3d solid with a hole along z drilled at (x, y)."""
    drill = manifold3d.Manifold.cylinder(10.0, radius, radius, 12, True).translate((*at, 0.0))
    found = (solid - drill).to_mesh()
    return trimesh.Trimesh(found.vert_properties[:, :3].astype(float), found.tri_verts)


def rank(shape, draft):
    """How many handles the cycles of a curve go around."""
    return handle_loops.proof(shape, draft.vertices, draft.edges).rank
