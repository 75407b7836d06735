"""Openings: boundary loops where a limb was cut off, such as a vessel's, and which repair closed with a lid.

The curve of such a limb is led to the middle of the lid, and radii are measured to the wall, not to the lid.
"""

from typing import NamedTuple

import numpy as np

from msf_jax.host.solid.geometry import cross, unit
from msf_jax.host.solid.solid import Solid

FARTHEST = 3.0  # radii of an opening: largest distance from its middle to the tip that is led to it
STEEPEST = 0.5  # least cosine between the direction from the tip's neighbour to the middle and the lid's normal
NARROWEST = 0.5  # radii of the limb at the tip: least radius of an opening; a smaller one is a hole in the wall


class Opened(NamedTuple):
    """A curve that is led to its openings. nodes: (N, 3), new ones last. edges: (E, 2). ends: (k,) the new nodes.
    lids: (L,) the faces of the solid that are lids."""

    nodes: np.ndarray
    edges: np.ndarray
    ends: np.ndarray
    lids: np.ndarray


def opened(solid: Solid, nodes: np.ndarray, edges: np.ndarray, rims: list[np.ndarray]) -> Opened:
    """Lead the tips of a curve ``(nodes (N, 3), edges (E, 2))`` to the middles of the openings where its limbs end.
    Each of the ``rims`` lists the vertices of one boundary loop of ``solid``."""
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
