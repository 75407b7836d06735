"""Lead a curve to its openings: the branch of each limb that was cut off ends in the middle of the lid."""

from typing import NamedTuple

import numpy as np

from msf_jax.inside.containment import is_inside
from msf_jax.limbs import one_branch
from msf_jax.limbs.ends import RING_SPACING
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.openings import JUST_INSIDE, Lid, is_end, lids_of
from msf_jax.solid.solid import Solid
from msf_jax.topology.graphs import trace


class Opened(NamedTuple):
    """A curve that is led to its openings. nodes: (N, 3), new ones last. edges: (E, 2). ends: (k,) the nodes at the
    openings. lids: (L,) the faces of the solid that are their lids."""

    nodes: np.ndarray
    edges: np.ndarray
    ends: np.ndarray
    lids: np.ndarray


def opened(solid: Solid, nodes: np.ndarray, edges: np.ndarray, is_held: np.ndarray, lids: np.ndarray) -> Opened:
    """Lead the curve ``(nodes (N, 3), edges (E, 2))`` to the middles of those of the faces ``lids`` (L,) where a limb
    ends. Nodes of ``is_held`` (N,) do not move.

    A leaf that is no farther from a middle than the rim is a limb's end there. Within this distance a lid cuts off a
    part of the limb's sections, which drew the curve to one side, so the branch goes straight there. A limb without a
    leaf, which is short, gets a straight branch.
    """
    shape, start, num = solid.shape, solid.enter(nodes), len(nodes)
    wanted = [lid for lid in lids_of(shape.vertices, shape.faces, lids) if is_end(shape, lid)]
    x, ball, ends, led = start, shape.approximate_clearance(start)[0], [], [lids[:0]]
    leaf_of = _leaves(shape, x, one_branch.leaves_of(edges), wanted)
    ball[list(leaf_of.values())] = -np.inf
    for number, lid in enumerate(wanted):
        if number in leaf_of:
            paths = (path for each in trace(len(x), edges) for path in (each, each[::-1]))
            path = np.array(next(path for path in paths if path[0] == leaf_of[number]))
            away = np.array([np.linalg.norm(x[path] - each.middle, axis=1) - each.reach for each in wanted])
            stays = (away > 0).all(axis=0) | np.isin(path, np.flatnonzero(is_held))
            first = min(int(np.append(stays, True).argmax()), len(path) - 1)
            first = int(np.flatnonzero(_is_open(shape, x[path[: first + 1]], lid))[-1])
            old, stop = path[:first].tolist(), int(path[first])
        else:
            old, stop = [], one_branch.beginning(shape, x[:num], ball, _inside(lid))
            if not _is_open(shape, x[[stop]], lid)[0]:
                continue
        ends.append(old[0] if old else len(x))
        places = np.stack([lid.middle, x[stop]])
        x, edges = one_branch.relaid(x, edges, old, stop, places, RING_SPACING * lid.radius())
        led.append(lid.faces)
    moved = np.concatenate([nodes, solid.leave(x[num:])])
    is_moved = (x[:num] != start).any(axis=1)
    moved[:num][is_moved] = solid.leave(x[:num][is_moved])
    return Opened(moved, edges, np.array(ends, dtype=np.int64), np.concatenate(led))


def _leaves(shape: Enclosure, x: np.ndarray, leaves: np.ndarray, lids: list[Lid]) -> dict[int, int]:
    """The leaf of each of the ``lids`` by its number, if there is one: of ``leaves`` (l,) near lids, the nearest pairs
    first. In a tube that is shorter than wide, both ends of the curve may be near the same lid."""
    away = np.array([np.linalg.norm(x[leaves] - lid.middle, axis=1) for lid in lids]).reshape(len(lids), len(leaves))
    is_near = np.any(away <= np.array([lid.reach for lid in lids])[:, None], axis=0)
    found: dict[int, int] = {}
    for pair in np.argsort(away, axis=None, kind="stable").tolist():
        number, column = pair // len(leaves), pair % len(leaves)
        leaf = int(leaves[column])
        is_free = is_near[column] and number not in found and leaf not in found.values()
        if is_free and _is_open(shape, x[[leaf]], lids[number])[0]:
            found[number] = leaf
    return found


def _inside(lid: Lid) -> np.ndarray:
    """(3,) a place below the middle of the ``lid``, and below all of its faces."""
    return lid.middle - (lid.uneven + JUST_INSIDE * lid.radius()) * lid.normal


def _is_open(shape: Enclosure, points: np.ndarray, lid: Lid) -> np.ndarray:
    """(P,) whether the way from each of ``points`` (P, 3) to the ``lid`` is inside."""
    return is_inside(shape, points, np.repeat(_inside(lid)[None], len(points), axis=0))
