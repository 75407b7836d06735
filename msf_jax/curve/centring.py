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

A section turns with the curve. In a wide section the centroid then moves much farther than the nodes, and an iteration
with c held fixed does not converge. So each round is a Gauss-Newton step with the derivative of c by the plane
(`sections.Sections`), and with the weights of a Geman-McClure loss of the distance to c, from the round before. The
rounds end when the nodes hardly move any more. In a sheet, weight and section change each other, and nodes go back and
forth: a step against the one before is shortened.

Each move of a curve's nodes keeps edges inside, and around the same handles. Each node takes its step, or a half or a
quarter of it, or none, so that afterwards

    the node is inside, no nearer to the surface than it may be, and so is the way to its new place;
    an edge that was inside is inside;
    an edge is of the class of its old place, changed by the classes of the steps of its two ends (see `Handles`).

So a loop around a hole cannot slip off it.
"""

from typing import NamedTuple

import numpy as np
from scipy import sparse
from scipy.sparse import linalg

from msf_jax.curve import branches as measures
from msf_jax.curve.branches import BranchPath
from msf_jax.inside.containment import TOUCHING, is_inside
from msf_jax.solid import sections
from msf_jax.solid.enclosure import SURE, Enclosure
from msf_jax.solid.geometry import unit
from msf_jax.solid.handles import Handles
from msf_jax.topology import graphs

# These give the least mean errors on the ground-truth shapes and the research meshes: see `tests.benchmarks.curves`.
CENTRING_ROUNDS = 6  # limit on the rounds of a centring: in sheets, where it ends most, more bring nothing
TOLERANCE = 0.02  # clearances: a round in which the root mean square of all steps is less is the last
AFRESH = 0.01  # limb sizes moved or radians turned: then a section is cut again; before, it is extrapolated
STIFFNESS = 0.35  # limb sizes, or half widths of a sheet: the length l
FOLDED = 1e-3  # limb sizes, of two for a straight branch: a shorter chord has no direction, as the branch runs back
LOPSIDED, STEEP = 1.6, 8  # section radius over size at which a section of a loop counts half; exponent of that ratio
ROUNDNESS = 4  # exponent of (median radius of the branch / radius of the section) in the weight, if below 1
STRAY = 0.3  # section radii: a centroid at this distance has a quarter of its weight
DAMPING = 0.05  # damping of a step, as a weight of its square
DAMPING_ALONG = 0.3  # more damping of its component along the branch
HELD = 1e9  # that of a node that does not move
LONGEST_STEP = 0.5  # clearances: limit on a node's step in a round
MOST_CORNERS = 5_000_000  # corners of all sections that are cut for a curve; then each centring ends after one round
BACK = 0.5  # part of a step that is taken by a node that goes back, against its step of the round before
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


def take_steps(shape: Enclosure, handles: Handles, places: Places, step: np.ndarray, edges: np.ndarray) -> Places:
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
        new_clearance[changed], triangle[changed] = shape.nearest(goal[changed], is_exact=False)
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


class Budget:
    """The cost limit of centring: ``left`` is the number of section corners left; ``was_hit`` is True if it ran out."""

    def __init__(self) -> None:
        self.left = MOST_CORNERS
        self.was_hit = False


def centre(
    shape: Enclosure,
    vertices: np.ndarray,
    edges: np.ndarray,
    is_held: np.ndarray,
    rounds: int = CENTRING_ROUNDS,
    is_far: bool = True,
    budget: Budget | None = None,
    handles: Handles | None = None,
) -> np.ndarray:
    """Centre the nodes ``vertices`` (N, 3) of the curve; those of ``is_held`` (N,) do not move.

    ``is_far`` says that the curve is not near the middle yet: the first round then ignores distances to centroids.
    Steps keep the rule of `take_steps`, with the ``handles`` of the solid, default those of ``shape``. When ``budget``,
    which other calls may share, is spent, there is one round only.
    """
    budget = Budget() if budget is None else budget
    x, num = vertices.copy(), len(vertices)
    paths = measures.paths_of(x, edges, is_held)
    if not paths:
        return x
    is_arc = graphs.core(num, edges)
    for path in paths:
        is_arc[path.nodes] &= not path.is_loop
    rings = [path.nodes[:-1] for path in paths if path.is_loop and not is_held[path.nodes].any()]
    at = places_of(shape, x)
    size = at.clearance.copy()
    limbs = LimbSections(shape, x, edges, paths, is_held, budget)
    before = np.zeros_like(x)
    for number in range(-1, rounds):  # round -1 only measures the limbs' sizes
        if number > 0 and budget.left < 0:
            budget.was_hit = True
            break
        x, clearance, near, _ = at
        chord, limb, found, weight, size = limbs.at(x, size, clearance, near)
        ahead = chord @ x
        tangent = unit(ahead)
        wide = np.full(num, np.nan)
        wide[limb] = found.radius
        wide = measures.usual(paths, wide)
        # Arcs of a loop with junctions have no circle for rest: all the width would draw them to their hole.
        reach = np.where(is_arc, np.sqrt(wide * size), wide)
        span = np.where(wide > measures.WIDE * size, reach, size)
        if number < 0:
            continue
        system = _System(x, paths, span, limb, found, tangent, ahead, chord, is_held)
        is_blind = is_far and number == 0
        away = np.where(is_blind, 0.0, np.linalg.norm(system.off, axis=1))
        step = system.step(weight / (1 + (away / (STRAY * found.radius)) ** 2) ** 2)
        if is_blind:
            away = np.linalg.norm(system.off + system.moved(step), axis=1)
            step = system.step(weight / (1 + (away / (STRAY * found.radius)) ** 2) ** 2)
        for ring in rings:  # its nodes do not go round: shares of its length count from the first one
            step[ring] -= (step[ring[0]] @ tangent[ring[0]]) * tangent[ring]
        step = measures.spread(x + step, paths) - x
        step[is_held] = 0.0
        step[np.einsum("ni,ni->n", step, before) < 0] *= BACK
        part = np.linalg.norm(step, axis=1) / np.maximum(np.maximum(clearance, 0.3 * size), 1e-300)
        is_last = float(np.sqrt(np.mean(np.minimum(part, 1.0) ** 2))) < TOLERANCE
        step *= np.minimum(1.0, LONGEST_STEP / np.maximum(part, 1e-300))[:, None]
        at = take_steps(shape, handles or shape.handles, at, step, edges)
        before = at.x - x
        if is_last:
            break
    return at.x


class LimbSections:
    """The sections of the limbs that a curve runs in: which nodes they are around, and what they say of the middle.

    The last section of a node is used until the node has moved or turned by `AFRESH`. Nodes ``is_off`` (N,) have none.
    """

    def __init__(
        self,
        shape: Enclosure,
        x: np.ndarray,
        edges: np.ndarray,
        paths: list[BranchPath],
        is_off: np.ndarray,
        budget: Budget,
    ):
        self.shape, self.paths, self.is_off, self.budget = shape, paths, is_off, budget
        self.degree, self.in_loop = np.bincount(edges.ravel(), minlength=len(x)), graphs.core(len(x), edges)
        self.place, self.normal = np.full_like(x, np.inf), np.zeros_like(x)
        self.found = sections.nowhere(x)

    def at(
        self, x: np.ndarray, size: np.ndarray, clearance: np.ndarray, near: np.ndarray
    ) -> tuple[sparse.csr_matrix, np.ndarray, sections.Sections, np.ndarray, np.ndarray]:
        """For nodes at ``x`` (N, 3): the matrix (N, N) to their chords, which sections are across; the nodes (L,) that
        a section of their limb is around; these sections; their weights (L,), before distances from nodes count; and
        the size (N,) of the limb at every node.

        ``size`` (N,): an estimate. ``clearance``, ``near`` (N,): of a ball at each node, and a triangle near it.
        """
        chord = measures.chords(x, self.paths, size)
        ahead = chord @ x
        tangent = unit(ahead)
        clear = measures.clear_of_others(x, self.paths, tangent, size, clearance)
        is_across = np.linalg.norm(ahead, axis=1) > FOLDED * size
        limb = np.flatnonzero((self.degree > 0) & (clear > 0) & is_across & ~self.is_off & (clearance > 0))
        found = self._cut(x, tangent, size, near, limb)
        middle, reach = np.zeros_like(x), np.zeros(len(x))
        middle[limb], reach[limb] = found.centroid, found.radius
        is_own = found.is_around & ~measures.crossed_again(x, self.paths, tangent, middle, reach)[limb]
        limb, found = limb[is_own], sections.Sections(*(field[is_own] for field in found))
        # In a loop, sections across a whole plate count less than those beside a hole. In a branch they may be all.
        wide = np.where(self.in_loop[limb], found.radius / (LOPSIDED * found.size), 0.0)
        weight = clear[limb] / (1 + wide**STEEP)
        width = np.full(len(x), np.nan)
        width[limb[weight > 1e-6]] = found.radius[weight > 1e-6]
        weight *= np.minimum(1.0, np.nan_to_num(measures.usual(self.paths, width)[limb] / found.radius)) ** ROUNDNESS
        everywhere = np.zeros((2, len(x)))
        everywhere[:, limb] = found.size, weight
        return chord, limb, found, weight, measures.sizes(x, self.paths, *everywhere, clearance=clearance)

    def _cut(
        self, x: np.ndarray, tangent: np.ndarray, size: np.ndarray, near: np.ndarray, limb: np.ndarray
    ) -> sections.Sections:
        """The sections of the nodes ``limb``; for a node that moved a little, the centroid is extrapolated."""
        moved = np.linalg.norm(x[limb] - self.place[limb], axis=1) / size[limb]
        turned = np.linalg.norm(tangent[limb] - self.normal[limb], axis=1)
        old = limb[(moved > AFRESH) | (turned > AFRESH)]
        if len(old):
            corners = sections.corners(self.shape, x[old], tangent[old], size[old], near[old])
            self.budget.left -= len(corners.loop)
            found = sections.measured(self.shape, x[old], tangent[old], corners)
            found = sections.held_in(self.shape, tangent[old], corners, found)
            for field, value in zip(self.found, found, strict=True):
                field[old] = value
            self.place[old], self.normal[old] = x[old], tangent[old]
        found = sections.Sections(*(field[limb] for field in self.found))
        normal = self.normal[limb]
        along = np.einsum("ni,ni->n", normal, x[limb] - self.place[limb])[:, None]
        shift = (found.slide + normal) * along + np.einsum("nij,nj->ni", found.turn, tangent[limb] - normal)
        return found._replace(centroid=found.centroid + shift)


class _System:
    """A Gauss-Newton step: the rows of a least-squares problem in the nodes' steps.

    off: (L, 3) P (x - c) of the nodes of ``limb``.
    """

    def __init__(
        self,
        x: np.ndarray,
        paths: list[BranchPath],
        size: np.ndarray,
        limb: np.ndarray,
        found: sections.Sections,
        tangent: np.ndarray,
        ahead: np.ndarray,
        chord: sparse.csr_matrix,
        is_held: np.ndarray,
    ):
        num, t = len(x), tangent[limb]
        flat = np.eye(3) - t[:, :, None] * t[:, None, :]
        self.off = np.einsum("nij,nj->ni", flat, x[limb] - found.centroid)
        slide = np.einsum("nij,nj->ni", flat, found.slide)
        own = flat - slide[:, :, None] * t[:, None, :]
        turn = -flat @ found.turn @ flat / np.linalg.norm(ahead[limb], axis=1)[:, None, None]
        reach = chord[limb].tocoo()
        row = np.concatenate([np.arange(len(limb)), reach.row])
        column = np.concatenate([limb, reach.col])
        block = np.concatenate([own, turn[reach.row] * reach.data[:, None, None]])
        i = 3 * row[:, None, None] + np.arange(3)[:, None] + np.zeros((3, 3), dtype=np.int64)
        j = 3 * column[:, None, None] + np.arange(3) + np.zeros((3, 3), dtype=np.int64)
        bend, stiffness, rest = measures.bending(x, paths, STIFFNESS * size)
        self.stiff, bent = np.repeat(stiffness, 3), bend.tocoo()
        i = np.concatenate([i.ravel(), (3 * (len(limb) + bent.row[:, None]) + np.arange(3)).ravel()])
        j = np.concatenate([j.ravel(), (3 * bent.col[:, None] + np.arange(3)).ravel()])
        entries = np.concatenate([block.ravel(), np.repeat(bent.data, 3)]), (i, j)
        self.rows = sparse.csr_matrix(entries, (3 * (len(limb) + len(stiffness)), 3 * num))
        self.value = np.concatenate([self.off.ravel(), (bend @ x - rest).ravel()])
        held = np.where(is_held, HELD, DAMPING)[:, None, None] * np.eye(3)
        held = held + DAMPING_ALONG * tangent[:, :, None] * tangent[:, None, :]
        self.held = sparse.bsr_matrix((held, np.arange(num), np.arange(num + 1)), shape=(3 * num, 3 * num)).tocsc()

    def step(self, weight: np.ndarray) -> np.ndarray:
        """The step (N, 3) that minimises the energy, with ``weight`` (L,) of the sections."""
        scale = np.concatenate([np.repeat(weight, 3), self.stiff])
        back = self.rows.T.tocsr()
        back.data *= scale[back.indices]
        matrix = (back @ self.rows).tocsc() + self.held
        # The matrix is symmetric and positive definite: no pivots are sought.
        factors = linalg.splu(matrix, "MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})
        return factors.solve(-(back @ self.value)).reshape(-1, 3)

    def moved(self, step: np.ndarray) -> np.ndarray:
        """(L, 3) the change of `off` in a step."""
        return (self.rows @ step.ravel())[: self.off.size].reshape(-1, 3)
