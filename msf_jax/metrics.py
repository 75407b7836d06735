"""Figures of a curve in its mesh."""

import numpy as np

from msf_jax.host.enclosure import Enclosure

SAMPLES_PER_EDGE = 16


def inside_fraction(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray) -> float:
    """Fraction of the length of the curve ``(vertices (N, 3), edges (E, 2))`` that is inside the surface ``shape``.

    A point is inside where the winding number is positive; each edge is sampled at the middles of 16 equal parts. A
    curve without length counts its nodes.
    """
    a, b = vertices[edges[:, 0]], vertices[edges[:, 1]]
    length = np.linalg.norm(b - a, axis=1)
    if length.sum() == 0:
        return float(shape.contains(vertices).mean())
    t = (np.arange(SAMPLES_PER_EDGE) + 0.5) / SAMPLES_PER_EDGE
    points = a[:, None] + t[None, :, None] * (b - a)[:, None]
    is_inside = shape.contains(points.reshape(-1, 3)).reshape(len(edges), -1)
    return float((is_inside.mean(axis=1) * length).sum() / length.sum())
