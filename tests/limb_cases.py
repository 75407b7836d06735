"""Solids whose limbs are known, and curves in them."""

from itertools import pairwise

import manifold3d
import numpy as np
from graph_cases import as_edges, chain

from msf_jax.solid.enclosure import Enclosure

Solid = manifold3d.Manifold


def as_shape(solid: Solid, edge: float | None = None) -> Enclosure:
    """The solid's surface as made, or with edges of at most ``edge``."""
    mesh = (solid if edge is None else solid.refine_to_length(edge)).to_mesh()
    return Enclosure(np.array(mesh.vert_properties[:, :3], dtype=float), np.array(mesh.tri_verts, dtype=np.int64))


def box(*size: float) -> Solid:
    return Solid.cube(size, True)


def round_bar(length: float, low: float = 1.0, high: float = 1.0) -> Solid:
    """Along x, with one radius at its low end and another one at its high end."""
    return Solid.cylinder(length, low, high, 32, True).rotate((0, 90, 0))


def i_beam(length: float) -> Solid:
    flanges = [box(length, 3, 0.5).translate((0, 0, z)) for z in (-2, 2)]
    return Solid.batch_boolean([box(length, 0.5, 4), *flanges], manifold3d.OpType.Add)


def zigzag(angle: float, arms: int = 2, length: float = 9.0) -> np.ndarray:
    """A polyline (arms + 1, 3) in the plane z = 0 that turns left and right, ``angle`` degrees between its arms."""
    half = np.radians(angle) / 2
    step = length * np.array([[np.sin(half), -np.cos(half) if arm % 2 else np.cos(half), 0] for arm in range(arms)])
    return np.concatenate([np.zeros((1, 3)), np.cumsum(step, axis=0)])


def mitred(axis: np.ndarray) -> Solid:
    """Square bars, two wide, along a polyline (k, 3) in the plane z = 0, with mitres at its corners."""
    along = np.diff(axis[:, :2], axis=0)
    side = np.stack([-along[:, 1], along[:, 0]], axis=1) / np.linalg.norm(along, axis=1)[:, None]
    before, after = np.vstack([side[:1], side]), np.vstack([side, side[-1:]])
    edge = (before + after) / (1 + (before * after).sum(axis=1))[:, None]  # one wide from both arms
    outline = np.concatenate([axis[:, :2] - edge, (axis[:, :2] + edge)[::-1]])
    return Solid.extrude(manifold3d.CrossSection([outline]), 2.0).translate((0, 0, -1))


RADIUS = 0.3


LIMB = {
    "short cylinder": (Solid.cylinder(0.6, RADIUS, RADIUS, 48), 2.0),
    "long cylinder": (Solid.cylinder(1.5, RADIUS, RADIUS, 48), 5.0),
    "cone": (Solid.cylinder(1.2, RADIUS, 0.0, 48), (np.hypot(1.2, RADIUS) / RADIUS - 1) / 2),
    "half ball": (Solid.sphere(1.0, 48), 0.5),
}


Curve = tuple[np.ndarray, np.ndarray]


def solid(found: Solid, edge: float = 0.25) -> Enclosure:
    mesh = found.refine_to_length(edge).to_mesh()
    return Enclosure(np.array(mesh.vert_properties[:, :3], dtype=float), np.array(mesh.tri_verts, dtype=np.int64))


def block() -> Solid:
    """A block of 4 x 4 x 2 whose top is at height 0."""
    return Solid.cube((4, 4, 2), True).translate((0, 0, -1))


def fingers() -> Solid:
    """The block with four fingers, each four radii long."""
    each = [Solid.cylinder(1.0, 0.25, 0.25, 24).translate((x, 0, 0)) for x in (-1.2, -0.4, 0.4, 1.2)]
    return Solid.batch_boolean([block(), *each], manifold3d.OpType.Add)


def legs(*polylines: list, step: float = 0.05) -> Curve:
    """Branches out of one node, where all courses begin, each a polyline with a node every ``step``, the leaf last."""
    vertices, pairs = [np.array(polylines[0][0], dtype=float)], []
    for polyline in polylines:
        last = 0
        for a, b in pairwise(np.array(polyline, dtype=float)):
            num = max(1, round(np.linalg.norm(b - a) / step))
            new = range(len(vertices), len(vertices) + num)
            vertices += list(a + np.arange(1, num + 1)[:, None] / num * (b - a))
            pairs += chain(last, *new)
            last = new[-1]
    return np.array(vertices), as_edges(pairs)
