"""Move the nodes of a curve to the middle of the solid; its graph does not change.

The middle of a limb is the centroid c of its cross-section. The nodes x of a curve minimise

    sum_i w_i |P_i (x_i - c_i)|^2  +  sum_i (l_i / h_i)^4 |x_{i-1} - 2 x_i + x_{i+1}|^2,

where P_i removes the component along the branch. This is a smoothing spline: its stiffness acts over a length l, a part
of the limb's size, or of a sheet's half width, for any spacing h of the nodes. In a loop of n nodes
(2 - 2 cos(2 pi / n)) (x_i - mean x) is added to the second difference, which is then 0 for a circle. Arcs of other
loops in a sheet, and branches between loops, have the geometric mean of its size and half width. Nodes keep their
shares of their branch's length, so they move across it only; those of a loop get equal shares. Near a junction a
cross-section cuts several limbs and is no guide, so w falls to 0 there. The branches then continue straight, and the
junction comes to where the axes of its limbs meet.

A section turns with the curve, and in a wide one the centroid moves much farther than the nodes: an iteration with c
held fixed does not converge. So each round is a Gauss-Newton step with the derivative of c by the plane
(`sections.Sections`), and with the weights of a Geman-McClure loss of the distance to c, from the round before.

Each move of a curve's nodes keeps edges inside, and around the same handles. A node takes its step if afterwards

    the node is inside, no nearer to the surface than it may be;
    an edge that was inside is inside;
    an edge is of the class of its old place, changed by the classes of the steps of its two ends (see `Handles`).
"""

from typing import NamedTuple

import numpy as np
from scipy import sparse
from scipy.sparse import linalg

from msf_jax.curve import branches as measures
from msf_jax.curve.branches import BranchPath
from msf_jax.solid import sections
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import TOUCHING, unit
from msf_jax.solid.handles import Handles
from msf_jax.topology import graphs

# These give the least mean errors on the ground-truth shapes and the research meshes: see `tests.benchmarks.curves`.
ROUNDS = 6  # limit on the rounds of a centring: in sheets, where it ends most, more bring nothing
TOLERANCE = 0.02  # clearances: a round in which the root mean square of all steps is less is the last
STIFFNESS = 0.35  # limb sizes, or half widths of a sheet: the length l
ROUNDNESS = 4  # exponent of (median radius of the branch / radius of the section) in the weight, if below 1
STRAY = 0.3  # section radii: a centroid at this distance has a quarter of its weight
DAMPING = 0.05  # weight of the square of a step
DAMPING_ALONG = 0.3  # more of its component along the branch: else nodes at a junction of limbs that touch fold
LONGEST_STEP = 0.5  # clearances: limit on a node's step in a round
LEAST_CLEARANCE = 0.25  # share of its first clearance that a move leaves to a node: the coarse surface is not exact


class Places(NamedTuple):
    """Nodes x (N, 3) with their clearance (N,), and that (N,) which moves leave to each at least."""

    x: np.ndarray
    clearance: np.ndarray
    least: np.ndarray


def places_of(shape: Enclosure, x: np.ndarray) -> Places:
    """The places of nodes ``x`` (N, 3) before their first move."""
    clearance = shape.clearance(x)
    return Places(x, clearance, np.maximum(LEAST_CLEARANCE * clearance, 2 * TOUCHING))


def take_steps(shape: Enclosure, handles: Handles, places: Places, step: np.ndarray, edges: np.ndarray) -> Places:
    """The places after each ``step`` (N, 3) that the rule allows. ``shape`` may be about the same surface as that of
    ``handles`` with fewer triangles."""
    x, goal = places.x, Places(*(field.copy() for field in places))
    is_free = (step != 0).any(axis=1)
    goal.x[is_free] += step[is_free]
    goal.clearance[is_free] = shape.distances(goal.x[is_free])
    edges = edges[is_free[edges].any(axis=1)]
    was_open = _is_open(shape, places, places, edges)
    class_of = handles.classes(x[edges[:, 0]], x[edges[:, 1]]) if handles.genus else np.zeros(len(edges), np.int64)
    moved = np.flatnonzero(is_free)
    is_bad, is_back = np.zeros((2, len(x)), dtype=bool)
    is_bad[moved] = (goal.clearance < np.minimum(places.least, places.clearance))[moved]
    is_bad[moved] |= ~shape.contains(goal.x[moved])
    rows = np.flatnonzero(~is_bad[edges].any(axis=1))
    while True:
        at_stake = edges[rows]
        is_kept = ~was_open[rows] | _is_open(shape, goal, goal, at_stake)
        is_kept[is_kept] = _keeps_class(handles, places, goal.x, at_stake[is_kept], class_of[rows[is_kept]])
        is_bad[at_stake[~is_kept]] = True
        is_bad &= is_free & ~is_back
        if not is_bad.any():
            return goal
        # Nodes that would break the rule go back, and the edges of those that went back are asked again.
        for field, before in zip(goal, places, strict=True):
            field[is_bad] = before[is_bad]
        rows, is_back = np.flatnonzero(is_bad[edges].any(axis=1)), is_back | is_bad


def _keeps_class(handles: Handles, places: Places, y: np.ndarray, edges: np.ndarray, classes: np.ndarray) -> np.ndarray:
    """(E,) whether ``edges`` (E, 2) of ``classes`` (E,) go around the same handles when nodes move to y (N, 3), as they
    do if the places of both ends, old and new, are in one ball around an old end, which is convex and inside."""
    if not handles.genus:
        return np.ones(len(edges), dtype=bool)
    x, is_in_doubt = places.x, np.ones(len(edges), dtype=bool)
    for one, other in (edges.T, edges[:, ::-1].T):
        away = np.stack([x[other], y[one], y[other]], axis=1) - x[one][:, None]
        is_in_doubt &= np.linalg.norm(away, axis=2).max(axis=1) >= places.clearance[one]
    a, b = edges[is_in_doubt].T
    along, *steps = np.split(handles.classes(np.r_[y[a], x[a], x[b]], np.r_[y[b], y[a], y[b]]), 3)
    is_in_doubt[is_in_doubt] = along != classes[is_in_doubt] + steps[1] - steps[0]
    return ~is_in_doubt


def _is_open(shape: Enclosure, starts: Places, ends: Places, pairs: np.ndarray) -> np.ndarray:
    """(W,) whether the segments from the start a to the end b for (a, b) of ``pairs`` (W, 2) are inside."""
    a, b = pairs.T
    return shape.holds(starts.x[a], ends.x[b], starts.clearance[a] + ends.clearance[b])


def centre(
    shape: Enclosure,
    vertices: np.ndarray,
    edges: np.ndarray,
    is_held: np.ndarray,
    rounds: int = ROUNDS,
    is_far: bool = True,
    handles: Handles | None = None,
) -> np.ndarray:
    """Centre the nodes ``vertices`` (N, 3) of the curve; those of ``is_held`` (N,) do not move. ``is_far``: it is not
    near the middle yet, and the first round ignores distances to centroids. Steps keep the rule of `take_steps`, with
    the ``handles`` of the solid, default those of ``shape``."""
    paths, size = measures.paths_of(vertices, edges, is_held), None
    if not paths:
        return vertices.copy()
    is_arc = graphs.core(len(vertices), edges)
    for path in paths:
        is_arc[path.nodes] &= not path.is_loop
    rings = [path.nodes[:-1] for path in paths if path.is_loop and not is_held[path.nodes].any()]
    at = places_of(shape, vertices)
    for number in range(rounds):
        x, clearance, _ = at
        limbs = limb_sections(shape, x, paths, is_held, clearance, size)
        size, wide = limbs.size, measures.usual(paths, len(x), limbs.node, limbs.found.radius)
        # Arcs of a loop with junctions have no circle for rest: all the width would draw them to their hole.
        reach = np.where(is_arc, np.sqrt(wide * size), wide)
        system = _System(x, paths, np.where(wide > measures.WIDE * size, reach, size), limbs, is_held)
        is_blind = is_far and number == 0
        step = system.step(limbs.weight if is_blind else limbs.robust(system.off))
        if is_blind:
            step = system.step(limbs.robust(system.off + system.moved(step)))
        for ring in rings:  # its nodes do not go round: shares of its length count from the first one
            step[ring] -= (step[ring[0]] @ limbs.tangent[ring[0]]) * limbs.tangent[ring]
        step = measures.spread(x + step, paths) - x
        step[is_held] = 0.0
        part = np.linalg.norm(step, axis=1) / np.maximum(np.maximum(clearance, 0.3 * size), 1e-300)
        step *= np.minimum(1.0, LONGEST_STEP / np.maximum(part, 1e-300))[:, None]
        at = take_steps(shape, handles or shape.handles, at, step, edges)
        if float(np.sqrt(np.mean(np.minimum(part, 1.0) ** 2))) < TOLERANCE:
            break
    return at.x


class LimbSections(NamedTuple):
    """The sections of the limbs that a curve of N nodes runs in.

    node: (L,) the nodes that a section of their limb is around. found: these sections. weight: (L,) of each, before its
    distance from the node counts. size: (N,) of the limb at every node. chord: (N, N) the matrix to the nodes' chords.
    tangent: (N, 3) their directions, which the sections are across."""

    node: np.ndarray
    found: sections.Sections
    weight: np.ndarray
    size: np.ndarray
    chord: sparse.csr_matrix
    tangent: np.ndarray

    def robust(self, off: np.ndarray) -> np.ndarray:
        """(L,) the weights of sections with their centroids ``off`` (L, 3) from where they are expected."""
        return self.weight / (1 + (np.linalg.norm(off, axis=1) / (STRAY * self.found.radius)) ** 2) ** 2


def limb_sections(
    shape: Enclosure,
    x: np.ndarray,
    paths: list[BranchPath],
    is_off: np.ndarray,
    clearance: np.ndarray,
    size: np.ndarray | None = None,
) -> LimbSections:
    """The sections of a curve with the nodes x (N, 3) along ``paths``; nodes ``is_off`` (N,) have none. ``clearance``
    (N,): of a ball at each node. ``size`` (N,): an estimate of the size of the limb; without, limbs are measured first.
    """
    if size is None:
        size = limb_sections(shape, x, paths, is_off, clearance, clearance).size
    chord = measures.chords(x, paths, size)
    ahead = chord @ x
    tangent = unit(ahead)
    clear = measures.clear_of_others(x, paths, tangent, size, clearance)
    node = np.flatnonzero(ahead.any(axis=1) & (clear > 0) & ~is_off & (clearance > 0))
    found = sections.held_in(shape, tangent[node], sections.cut(shape, x[node], tangent[node], size[node]))
    middle, reach = np.zeros_like(x), np.zeros(len(x))
    middle[node], reach[node] = found.middle, found.radius
    is_own = found.is_around & ~measures.crossed_again(x, paths, tangent, middle, reach)[node]
    node, found = node[is_own], found.only(is_own)
    is_clear = clear[node] > 1e-6
    width = measures.usual(paths, len(x), node[is_clear], found.radius[is_clear])
    weight = clear[node] * np.minimum(1.0, np.nan_to_num(width[node] / found.radius)) ** ROUNDNESS
    everywhere = np.zeros((2, len(x)))
    everywhere[:, node] = found.size, weight
    return LimbSections(node, found, weight, measures.sizes(x, paths, *everywhere, clearance=clearance), chord, tangent)


class _System:
    """A Gauss-Newton step: the rows of a least-squares problem in the nodes' steps. off: (L, 3) P (x - c) of the nodes
    with a section. ``size`` (N,): the length over which branches are stiff."""

    def __init__(
        self, x: np.ndarray, paths: list[BranchPath], size: np.ndarray, limbs: LimbSections, is_held: np.ndarray
    ):
        node, found, t = limbs.node, limbs.found, limbs.tangent[limbs.node]
        flat = np.eye(3) - t[:, :, None] * t[:, None, :]
        self.off = np.einsum("nij,nj->ni", flat, x[node] - found.middle)
        slide = np.einsum("nij,nj->ni", flat, found.slide)
        own = flat - slide[:, :, None] * t[:, None, :]
        turn = -flat @ found.turn @ flat / np.linalg.norm(limbs.chord[node] @ x, axis=1)[:, None, None]
        reach = limbs.chord[node].tocoo()
        row = np.concatenate([np.arange(len(node)), reach.row])
        column = np.concatenate([node, reach.col])
        block = np.concatenate([own, turn[reach.row] * reach.data[:, None, None]])
        i = 3 * row[:, None, None] + np.arange(3)[:, None] + np.zeros((3, 3), dtype=np.int64)
        j = 3 * column[:, None, None] + np.arange(3) + np.zeros((3, 3), dtype=np.int64)
        sectioned = sparse.csr_matrix((block.ravel(), (i.ravel(), j.ravel())), shape=(3 * len(node), 3 * len(x)))
        bend, stiffness, rest = measures.bending(x, paths, STIFFNESS * size)
        self.stiff, self.is_free = np.repeat(stiffness, 3), np.repeat(~is_held, 3)
        self.rows = sparse.csr_matrix(sparse.vstack([sectioned, sparse.kron(bend, np.eye(3))]))[:, self.is_free]
        self.value = np.concatenate([self.off.ravel(), (bend @ x - rest).ravel()])
        ahead, each = limbs.tangent[~is_held], np.arange(np.count_nonzero(~is_held) + 1)
        damping = DAMPING * np.eye(3) + DAMPING_ALONG * ahead[:, :, None] * ahead[:, None, :]
        self.damping = sparse.bsr_matrix((damping, each[:-1], each), shape=(3 * len(ahead), 3 * len(ahead)))

    def step(self, weight: np.ndarray) -> np.ndarray:
        """The step (N, 3) that minimises the energy, with ``weight`` (L,) of the sections."""
        step = np.zeros(len(self.is_free))
        if not self.is_free.any():
            return step.reshape(-1, 3)
        back = self.rows.T.tocsr()
        back.data *= np.concatenate([np.repeat(weight, 3), self.stiff])[back.indices]
        matrix = (back @ self.rows + self.damping).tocsc()
        # The matrix is symmetric and positive definite: no pivots are sought.
        factors = linalg.splu(matrix, "MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})
        step[self.is_free] = factors.solve(-(back @ self.value))
        return step.reshape(-1, 3)

    def moved(self, step: np.ndarray) -> np.ndarray:
        """(L, 3) the change of `off` in a step."""
        return (self.rows @ step.ravel()[self.is_free])[: self.off.size].reshape(-1, 3)
