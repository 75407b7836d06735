"""Openings: rims at which a limb was cut, a vessel for one, and that repair has closed with a lid.

The curve of such a limb goes on to the middle of the lid, and balls are measured against the wall, not against the lid.
"""

from typing import NamedTuple

import numpy as np

from msf_jax.host.solid.geometry import cross, unit
from msf_jax.host.solid.solid import Solid

FARTHEST = 3.0  # radii of an opening, from its middle to the tip of the curve that it belongs to
STEEPEST = 0.5  # cosine between the way there and the lid's normal, at least
NARROWEST = 0.5  # radii of the limb at that tip, that an opening has at least: others are holes


class Opened(NamedTuple):
    """A curve that goes on to its openings. nodes: (N, 3), new ones last. edges: (E, 2). ends: (k,) the new nodes.
    lids: (L,) the solid's faces that are no wall."""

    nodes: np.ndarray
    edges: np.ndarray
    ends: np.ndarray
    lids: np.ndarray


def opened(solid: Solid, nodes: np.ndarray, edges: np.ndarray, rims: list[np.ndarray]) -> Opened:
    """Lead the tips of a curve ``(nodes (N, 3), edges (E, 2))`` on to the middles of those ``rims``, vertices of
    ``solid``, that its limbs end in."""
    degree = np.bincount(edges.ravel(), minlength=len(nodes))
    tips = np.flatnonzero(degree == 1)
    taken: set[int] = set()
    new, ends, lids = [], [], []
    vertices = solid.leave(solid.shape.vertices)
    for rim in rims:
        is_rim = np.zeros(len(vertices), dtype=bool)
        is_rim[rim] = True
        lid = np.flatnonzero(is_rim[solid.shape.faces].all(axis=1))
        free = np.array([tip for tip in tips.tolist() if tip not in taken], dtype=np.int64)
        if not len(lid) or not len(free):
            continue
        corner = vertices[solid.shape.faces[lid]]
        twice = cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
        area = np.linalg.norm(twice, axis=1)
        middle = (area[:, None] * corner.mean(axis=1)).sum(axis=0) / max(float(area.sum()), 1e-300)
        normal, radius = unit(twice.sum(axis=0)), float(np.sqrt(area.sum() / 2 / np.pi))
        away = middle - nodes[free]
        distance = np.linalg.norm(away, axis=1)
        tip = free[distance.argmin()]
        inner = edges[(edges == tip).any(axis=1)][0].sum() - tip
        onward = unit(middle - nodes[inner])
        if distance.min() > FARTHEST * radius or onward @ normal < STEEPEST:
            continue
        limb = float(Solid(vertices, solid.shape.faces, lid).radii(nodes[[tip]])[0])
        if radius >= NARROWEST * limb:
            taken.add(int(tip))
            ends.append(len(nodes) + len(new))
            new.append(middle)
            edges = np.vstack([edges, [tip, ends[-1]]])
            lids.append(lid)
    every = np.vstack([nodes, *new]) if new else nodes
    return Opened(every, edges, np.array(ends, dtype=np.int64), np.concatenate([np.empty(0, dtype=np.int64), *lids]))
