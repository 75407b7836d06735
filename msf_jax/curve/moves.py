"""The rule for a move of a curve's nodes: an edge stays inside, and goes around the same handles.

Each node takes its step, or a half or a quarter of it, or none, so that afterwards

    the node is inside, no nearer to the surface than it may be, and so is the way to its new place;
    an edge that was inside is inside;
    an edge is of the class of its old place, changed by the classes of the steps of its two ends (see `Handles`).

So a loop around a hole cannot slip off it.
"""

from typing import NamedTuple

import numpy as np

from msf_jax.inside.containment import is_inside
from msf_jax.inside.roadmap import TOUCHING
from msf_jax.solid.enclosure import SURE, Enclosure
from msf_jax.solid.handles import Handles

LEAST_CLEARANCE = 0.25  # share of its first clearance that a move leaves to a node: the coarse surface is not exact
HALVINGS = 2  # times that a step that goes too far is halved, before none is taken


class Places(NamedTuple):
    """Nodes x (N, 3) with their approximate clearance (N,) and a triangle (N,) near each, and the clearance (N,) that
    moves leave to each at least."""

    x: np.ndarray
    clearance: np.ndarray
    near: np.ndarray
    least: np.ndarray


def places_of(shape: Enclosure, x: np.ndarray) -> Places:
    """The places of nodes ``x`` (N, 3) before their first move."""
    clearance, near = shape.approximate_clearance(x)
    return Places(x, clearance, near, np.maximum(LEAST_CLEARANCE * clearance, 2 * TOUCHING))


def taken(shape: Enclosure, handles: Handles, places: Places, step: np.ndarray, edges: np.ndarray) -> Places:
    """The places after as much of each node's ``step`` (N, 3) as the rule allows. A node outside does not move.

    ``shape`` may be about the same surface as that of ``handles`` with fewer triangles.
    """
    x, clearance, near, least = places
    is_free = step.any(axis=1) & (clearance > 0)
    part = is_free.astype(float)
    goal, new_clearance, triangle = x.copy(), clearance.copy(), near.copy()
    changed = np.flatnonzero(is_free)
    edges = edges[is_free[edges].any(axis=1)]
    edges = edges[_is_open(shape, x, x, clearance, clearance, edges)]
    class_of = handles.classes(x[edges[:, 0]], x[edges[:, 1]]) if handles.genus else np.zeros(len(edges), np.int64)
    trial = 0
    while True:
        goal[changed] = x[changed] + part[changed, None] * step[changed]
        new_clearance[changed], triangle[changed] = shape.approximate_closest(goal[changed])
        moved = changed[part[changed] > 0]
        is_bad, is_tried = np.zeros((2, len(x)), dtype=bool)
        is_tried[changed] = True
        is_bad[moved] = ~shape.contains(goal[moved]) | (new_clearance[moved] < np.minimum(least, clearance)[moved])
        moved = moved[~is_bad[moved]]
        pairs = np.stack([moved, moved], axis=1)
        is_bad[moved] = ~_is_open(shape, x, goal, clearance, new_clearance, pairs)
        rows = np.flatnonzero(~is_bad[edges].any(axis=1) & is_tried[edges].any(axis=1))
        at_stake = edges[rows]
        is_kept = _is_open(shape, goal, goal, new_clearance, new_clearance, at_stake)
        is_kept[is_kept] = _keeps_class(handles, x, goal, clearance, at_stake[is_kept], class_of[rows[is_kept]])
        is_bad[at_stake[~is_kept]] = True
        changed = np.flatnonzero(is_bad & (part > 0))
        if not len(changed):
            return Places(goal, new_clearance, triangle, least)
        part[changed] *= 0.5 if trial < HALVINGS else 0.0
        trial += 1


def _keeps_class(
    handles: Handles, x: np.ndarray, y: np.ndarray, clearance: np.ndarray, edges: np.ndarray, class_of: np.ndarray
) -> np.ndarray:
    """(E,) whether ``edges`` (E, 2) of class ``class_of`` (E,) go around the same handles when nodes move from x to y.

    They do if the places of both ends, old and new, are in one ball around an old end, which is convex and inside.
    """
    if not handles.genus:
        return np.ones(len(edges), dtype=bool)
    is_in_doubt = np.ones(len(edges), dtype=bool)
    for one, other in (edges.T, edges[:, ::-1].T):
        places = np.stack([x[other], y[one], y[other]], axis=1)
        is_in_doubt &= np.linalg.norm(places - x[one][:, None], axis=2).max(axis=1) >= SURE * clearance[one]
    a, b = edges[is_in_doubt].T
    along, *steps = np.split(handles.classes(np.r_[y[a], x[a], x[b]], np.r_[y[b], y[a], y[b]]), 3)
    is_in_doubt[is_in_doubt] = along != class_of[is_in_doubt] + steps[1] - steps[0]
    return ~is_in_doubt


def _is_open(
    shape: Enclosure,
    x: np.ndarray,
    y: np.ndarray,
    clearance: np.ndarray,
    its_clearance: np.ndarray,
    pairs: np.ndarray,
) -> np.ndarray:
    """(W,) whether the segments from x[a] to y[b] for (a, b) of ``pairs`` (W, 2) are inside; clearances are
    approximate."""
    a, b = pairs.T
    return is_inside(shape, x[a], y[b], SURE * (clearance[a] + its_clearance[b]))
