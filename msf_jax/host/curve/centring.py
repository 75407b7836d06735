"""Move the nodes of a curve to the middle of the solid, and leave its graph alone.

The middle of a limb is the centroid c of its cross-section. The nodes x of a curve are where they make least of

    sum_i w_i |P_i (x_i - c_i)|^2  +  sum_i (l_i / h_i)^4 |x_{i-1} - 2 x_i + x_{i+1}|^2  +  sum_j a_j |x_j - y_j|^2,

where P_i takes away most of what is along the branch: a smoothing spline, whose stiffness reaches over a part l of the
limb's size whatever the spacing h of the nodes. Nodes keep their shares of their branch's length, so that they move
across it only. Near a junction a cross-section cuts several limbs and says nothing: w falls to 0 there, and the
branches run straight on, so that the junction comes to where the axes of its limbs meet. That is right for tubes. Where
the solid is roomier around y, the place that the flow found for a junction, than around the straight way (the rump of a
horse, a shell on a back), a holds the junction there.

The section turns with the curve, and where it is wide its centroid turns with it much farther than the nodes went: to
take c as given makes a round that never ends. So each round is a step of Gauss and Newton, with the derivative of c by
the plane (`sections.Sections`), and weights from the round before (a Geman-McClure loss of the distance to c). Weights
are smooth in the nodes. But a section has jumps, where it begins to cut another limb, too: a node on such a brink
counts less each time that it goes over it. The rounds end when the nodes hardly move any more.
"""

import itertools

import numpy as np
from scipy import sparse
from scipy.sparse import linalg

from msf_jax.host.curve import branch_paths as measures
from msf_jax.host.curve.branch_paths import BranchPath
from msf_jax.host.curve.containment import is_inside
from msf_jax.host.poles.roadmap import TOUCHING
from msf_jax.host.solid import sections
from msf_jax.host.solid.enclosure import Enclosure
from msf_jax.host.solid.geometry import unit

# Chosen on the ground-truth shapes and the research meshes, for the mean distance to the true curve, off-centre and
# missed together; see `tests.benchmarks.curves`.
ROUNDS = 12  # at most
TOLERANCE = 0.02  # sizes of the limb: a round in which the root mean square of all steps is less is the last
AFRESH = 0.01  # sizes moved, or radians turned, after which a section is cut again; until then it is linear in both
STIFFNESS = 0.35  # the length l, in sizes of the limb
STIFFEST = 1e5  # of (l / h)^4
ZONE, MARGIN = 0.7, 0.4  # sizes of a junction, within which sections do not count, and over which they come to do so
LOPSIDED, STEEP = 1.6, 8  # a section so many times as wide as its limb counts half, by this power of the ratio
ROUNDNESS = 4  # a section wider than its branch's usual one counts less, by this power of the ratio
STRAY = 0.3  # section radii: a centroid so far away counts for a quarter
SLIDING = 0.03  # what is left of w along the branch
ANCHOR, JUNCTION_ANCHOR = 0.003, 0.2  # a: in general, at a junction, and
DEEP_ANCHOR, DEEPER = 4.0, 1.0  # so much more there where the flow's place is roomier by this part; and by this
FORMER_JUNCTION_DEEPER = 0.25  # where a junction has been: what was pruned was all that held the curve in its blob
DAMPING = 0.05  # of a step, and
DAMPING_ALONG = 0.3  # of what is along the branch
LONGEST_STEP = 0.5  # sizes, in one round
FARTHEST = 20.0  # steps of a node, that a centroid may be expected to go with it
HELD = 1e9  # a, for a node that is not to move
MOST_CORNERS = 5_000_000  # of all sections that are cut for a curve; then each centring is left after a round
THINNEST = 0.25  # of its clearance, that a step must leave to a node
HALVINGS = 2  # of a step that goes too far, before none is taken
SLIGHT = 0.05  # of its room: a shorter step of a node leads nowhere else
CLOSE = 0.005  # diagonals, to the surface, where it is measured exactly; elsewhere, of what is about the clearance,
SURE = 0.5  # that part is
NEARBY, DETOUR = 0.5, 1.5  # balls, between a junction and the place where the solid is roomiest; times that, under way
CLIMBS, FINEST = 30, 0.004  # steps on the way there, and balls, the last of them
DIRECTIONS = unit(np.array([each for each in itertools.product((-1.0, 0.0, 1.0), repeat=3) if any(each)]))
SETTLING = 4  # rounds, after which a node that goes over a brink counts less,
BRINK, FADE = 1.25, 0.5  # where its weight over its width changes by that factor, by this one


class Budget:
    """What centring may cost: corners of sections, ``left`` of them, and if it was left early for that."""

    def __init__(self) -> None:
        self.left = MOST_CORNERS
        self.was_hit = False


def centre(
    shape: Enclosure,
    vertices: np.ndarray,
    edges: np.ndarray,
    is_held: np.ndarray,
    rounds: int = ROUNDS,
    places: np.ndarray | None = None,
    former_junctions: np.ndarray | None = None,
    is_far: bool = True,
    budget: Budget | None = None,
) -> np.ndarray:
    """The nodes ``vertices`` (N, 3) of the curve, centred; those of ``is_held`` (N,) stay where they are.

    ``places`` (N, 3) are those that the flow found, ``vertices`` if not given. ``former_junctions`` (N,) are nodes that
    were junctions, and are held where the clearance is larger, too; none if not given. ``is_far`` says that the curve
    is not near the middle yet: then the first round takes it there, however far that is. A step that would leave the
    solid is cut short; a node that is outside stays there. When ``budget`` is spent, which others may share, one round
    must do.
    """
    budget = Budget() if budget is None else budget
    x, num = vertices.copy(), len(vertices)
    y = vertices.copy() if places is None else np.where(is_held[:, None], vertices, places)
    degree = np.bincount(edges.ravel(), minlength=num)
    paths = measures.paths_of(x, edges, is_held)
    if not paths:
        return x
    is_former_junction = (degree == 2) & (False if former_junctions is None else former_junctions)
    junction = np.flatnonzero((degree > 2) | is_former_junction)
    is_lost = ~shape.contains(y[junction])  # a place outside holds nothing
    y[junction[is_lost]] = x[junction[is_lost]]
    clearance_at_place = np.where(is_lost, 0.0, shape.distances(y[junction]))
    clearance, near = shape.approximate_clearance(x)
    least = np.maximum(THINNEST * clearance, 2 * TOUCHING)
    size, faded, before = clearance.copy(), np.ones(num), np.zeros(num)
    known = _Known(x, budget)
    for number in range(-1, rounds):  # the first only finds out how large limbs are
        if number > 0 and budget.left < 0:
            budget.was_hit = True
            break
        clearance[junction] = shape.distances(x[junction])
        chord = measures.chords(x, paths, size)
        ahead = chord @ x
        tangent = unit(ahead)
        clear = measures.clear_of_junctions(x, paths, degree, size, ZONE, MARGIN)
        limb = np.flatnonzero((degree > 0) & (clear > 0) & ~is_held & (clearance > 0))
        found = known.at(shape, x, tangent, size, near, limb)
        limb = limb[found.is_around]
        found = sections.Sections(*(field[found.is_around] for field in found))
        weight = clear[limb] / (1 + (found.radius / (LOPSIDED * found.size)) ** STEEP)
        # A node on the brink between two limbs counts less each time that it crosses it.
        pull = np.zeros(num)
        pull[limb] = weight / found.radius
        if number >= SETTLING:
            is_over = np.maximum(pull, before) > BRINK * np.minimum(pull, before)
            faded[is_over & (np.abs(pull - before) * size > 0.1)] *= FADE
        before = pull
        weight *= faded[limb]
        width = np.full(num, np.nan)
        width[limb[weight > 1e-6]] = found.radius[weight > 1e-6]
        weight *= np.minimum(1.0, np.nan_to_num(measures.usual(paths, width)[limb] / found.radius)) ** ROUNDNESS
        everywhere = np.zeros((2, num))
        everywhere[:, limb] = found.size, weight
        size = measures.sizes(x, paths, everywhere[0], everywhere[1], clearance)
        if number < 0:
            continue
        anchor = np.full(num, ANCHOR)
        usual = np.where(is_former_junction, size, measures.second_sizes(paths, everywhere[0], everywhere[1]))[junction]
        deeper = np.clip(
            (clearance_at_place / usual - 1) / np.where(is_former_junction, FORMER_JUNCTION_DEEPER, DEEPER)[junction],
            0,
            1,
        )
        anchor[junction] = np.where(is_former_junction[junction] | is_lost, ANCHOR, JUNCTION_ANCHOR)
        anchor[junction] += DEEP_ANCHOR * deeper**2 * (3 - 2 * deeper)
        anchor[is_held] = HELD
        system = _System(x, paths, size, limb, found, tangent, ahead, chord, anchor, y)
        is_blind = is_far and number == 0
        away = np.zeros(len(limb)) if is_blind else np.linalg.norm(system.off, axis=1)
        step = system.step(weight / (1 + (away / (STRAY * found.radius)) ** 2) ** 2)
        if is_blind:
            away = np.linalg.norm(system.off + system.moved(step), axis=1)
            step = system.step(weight / (1 + (away / (STRAY * found.radius)) ** 2) ** 2)
        step = measures.spread(x + step, paths) - x
        step[is_held] = 0.0
        part = np.linalg.norm(step, axis=1) / np.maximum(np.maximum(clearance, 0.3 * size), 1e-300)
        is_last = np.sqrt(np.mean(part**2)) < TOLERANCE
        step *= np.minimum(1.0, LONGEST_STEP / np.maximum(part, 1e-300))[:, None]
        x, clearance, near = _taken(shape, x, step, clearance, near, edges, ~is_held & (clearance > 0), least)
        if is_last:
            break
    return x


def deepest_points(shape: Enclosure, points: np.ndarray) -> np.ndarray:
    """For each of ``points`` (P, 3) inside, where the solid is roomiest, if that is within ``NEARBY`` of its ball.

    There is such a place in a blob where limbs meet, and it does not depend on how it was found: the point to where
    they are alike. Along a trunk the way to it is long, and the point stays. By steps in 26 directions, halved.
    """
    clearance = shape.approximate_closest(points)[0]
    x, best, step = points.copy(), clearance.copy(), NEARBY / 2 * clearance
    away, is_near = np.zeros(len(x)), np.ones(len(x), dtype=bool)
    for _ in range(CLIMBS):
        live = np.flatnonzero(is_near & (step > FINEST * clearance))
        if not len(live):
            break
        tried = x[live, None] + step[live, None, None] * DIRECTIONS
        found = shape.approximate_closest(tried.reshape(-1, 3))[0].reshape(len(live), -1)
        most = found.argmax(axis=1)
        found, tried = found[np.arange(len(live)), most], tried[np.arange(len(live)), most]
        is_better = found > best[live]
        x[live[is_better]], best[live[is_better]] = tried[is_better], found[is_better]
        step[live[~is_better]] /= 2
        away = np.linalg.norm(x - points, axis=1)
        is_near = away < DETOUR * NEARBY * clearance
    return np.where(((away < NEARBY * clearance) & (step <= FINEST * clearance))[:, None], x, points)


def _taken(
    shape: Enclosure,
    x: np.ndarray,
    step: np.ndarray,
    clearance: np.ndarray,
    near: np.ndarray,
    edges: np.ndarray,
    is_free: np.ndarray,
    least: np.ndarray,
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The nodes (N, 3) after as much of their ``step`` as leaves no wall behind, with their room and what is near.

    A node that would come too near to the surface, or go through it, goes a half or a quarter of its way, or stays; so
    do both ends of an edge that was inside and would not be. A loop around a hole does not slip off it that way.
    """
    part = is_free.astype(float)
    goal, new_clearance, triangle = x.copy(), clearance.copy(), near.copy()
    length = np.linalg.norm(step, axis=1)
    is_slight = is_free & (length < SLIGHT * clearance) & (clearance - length > least)  # no need to look
    goal[is_slight] += step[is_slight]
    new_clearance[is_slight] -= length[is_slight]
    changed = np.flatnonzero(is_free & ~is_slight)
    edges = edges[np.isin(edges, changed).any(axis=1)]
    edges = edges[_is_open(shape, x, x, clearance, clearance, edges)]
    trial = 0
    while True:
        goal[changed] = x[changed] + part[changed, None] * step[changed]
        new_clearance[changed], triangle[changed] = shape.approximate_closest(goal[changed])
        close = changed[new_clearance[changed] < CLOSE]
        new_clearance[close] = shape.distances(goal[close])
        moved = changed[part[changed] > 0]
        is_bad = np.zeros(len(x), dtype=bool)
        is_bad[moved] = ~shape.contains(goal[moved]) | (new_clearance[moved] < np.minimum(least, clearance)[moved])
        moved = moved[~is_bad[moved]]
        paths = np.stack([moved, moved], axis=1)
        is_bad[moved] = ~_is_open(shape, x, goal, clearance, new_clearance, paths)
        at_stake = edges[~is_bad[edges].any(axis=1) & np.isin(edges, changed).any(axis=1)]
        is_bad[at_stake[~_is_open(shape, goal, goal, new_clearance, new_clearance, at_stake)]] = True
        changed = np.flatnonzero(is_bad & (part > 0))
        if not len(changed):
            return goal, new_clearance, triangle
        part[changed] *= 0.5 if trial < HALVINGS else 0.0
        trial += 1


def _is_open(
    shape: Enclosure, x: np.ndarray, y: np.ndarray, clearance: np.ndarray, its_clearance: np.ndarray, paths: np.ndarray
) -> np.ndarray:
    """(W,) whether the segments from x[a] to y[b] for (a, b) of ``paths`` (W, 2) are inside; rooms are not exact."""
    a, b = paths.T
    return is_inside(shape, x[a], y[b], SURE * (clearance[a] + its_clearance[b]))


class _Known:
    """Sections that were cut, until their nodes have moved on too far."""

    def __init__(self, x: np.ndarray, budget: Budget):
        self.budget = budget
        self.place, self.normal = np.full_like(x, np.inf), np.zeros_like(x)
        self.found = sections.nowhere(x)

    def at(
        self,
        shape: Enclosure,
        x: np.ndarray,
        tangent: np.ndarray,
        size: np.ndarray,
        near: np.ndarray,
        limb: np.ndarray,
    ) -> sections.Sections:
        """The sections of the nodes ``limb``; one that moved a little has the centroid that is expected there."""
        moved = np.linalg.norm(x[limb] - self.place[limb], axis=1) / size[limb]
        turned = np.linalg.norm(tangent[limb] - self.normal[limb], axis=1)
        old = limb[(moved > AFRESH) | (turned > AFRESH)]
        if len(old):
            corners = sections.corners(shape, x[old], tangent[old], size[old], near[old])
            self.budget.left -= len(corners.loop)
            for field, value in zip(self.found, sections.measured(shape, x[old], tangent[old], corners), strict=True):
                field[old] = value
            self.place[old], self.normal[old] = x[old], tangent[old]
        found = sections.Sections(*(field[limb] for field in self.found))
        normal = self.normal[limb]
        along = np.einsum("ni,ni->n", normal, x[limb] - self.place[limb])[:, None]
        shift = (found.slide + normal) * along + np.einsum("nij,nj->ni", found.turn, tangent[limb] - normal)
        return found._replace(centroid=found.centroid + shift)


class _System:
    """One step of Gauss and Newton: rows of a least-squares problem in the nodes' steps.

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
        anchor: np.ndarray,
        places: np.ndarray,
    ):
        num, t = len(x), tangent[limb]
        both = t[:, :, None] * t[:, None, :]
        flat = np.eye(3) - both
        across = flat + SLIDING * both
        self.off = np.einsum("nij,nj->ni", across, x[limb] - found.centroid)
        slide = np.einsum("nij,nj->ni", flat, found.slide)
        slide *= _bound(slide)[:, None]
        own = across - slide[:, :, None] * t[:, None, :]
        length = np.maximum(np.linalg.norm(ahead[limb], axis=1), 1e-300)
        turn = -flat @ found.turn @ flat / length[:, None, None]
        turn *= _bound(turn.reshape(-1, 9))[:, None, None]
        reach = chord[limb].tocoo()
        row = np.concatenate([np.arange(len(limb)), reach.row])
        column = np.concatenate([limb, reach.col])
        block = np.concatenate([own, turn[reach.row] * reach.data[:, None, None]])
        triple, spacing = measures.triples(x, paths)
        stiff = np.minimum((STIFFNESS * size[triple[:, 1]] / np.maximum(spacing, 1e-12)) ** 4, STIFFEST)
        self.stiff = np.repeat(stiff, 3)
        bent = x[triple[:, 0]] - 2 * x[triple[:, 1]] + x[triple[:, 2]]
        bend = np.tile([1.0, -2.0, 1.0], len(triple))[:, None, None] * np.eye(3)
        row = np.concatenate([row, len(limb) + np.repeat(np.arange(len(triple)), 3)])
        column, block = np.concatenate([column, triple.ravel()]), np.concatenate([block, bend])
        i = 3 * row[:, None, None] + np.arange(3)[:, None] + np.zeros((3, 3), dtype=np.int64)
        j = 3 * column[:, None, None] + np.arange(3) + np.zeros((3, 3), dtype=np.int64)
        self.rows = sparse.coo_matrix(
            (block.ravel(), (i.ravel(), j.ravel())), (3 * (len(limb) + len(triple)), 3 * num)
        ).tocsr()
        self.value = np.concatenate([self.off.ravel(), bent.ravel()])
        held = (DAMPING + anchor)[:, None, None] * np.eye(3)
        held = held + DAMPING_ALONG * tangent[:, :, None] * tangent[:, None, :]
        self.held = sparse.bsr_matrix((held, np.arange(num), np.arange(num + 1)), shape=(3 * num, 3 * num)).tocsc()
        self.pull = (anchor[:, None] * (places - x)).ravel()

    def step(self, weight: np.ndarray) -> np.ndarray:
        """The step (N, 3) that makes least of it, with ``weight`` (L,) of the sections."""
        scale = np.concatenate([np.repeat(weight, 3), self.stiff])
        back = self.rows.T.tocsr().multiply(scale).tocsr()
        matrix = (back @ self.rows).tocsc() + self.held
        return linalg.splu(matrix).solve(self.pull - back @ self.value).reshape(-1, 3)

    def moved(self, step: np.ndarray) -> np.ndarray:
        """(L, 3) by how much `off` changes in a step."""
        return (self.rows @ step.ravel())[: self.off.size].reshape(-1, 3)


def _bound(derivative: np.ndarray) -> np.ndarray:
    """(L,) the part of each row of ``derivative`` (L, k) that is kept: a section through a sliver has any one."""
    return np.minimum(1.0, FARTHEST / np.maximum(np.linalg.norm(derivative, axis=1), 1e-300))
