"""From the curve as the flow left it to the finished one: inside, pruned, centred, and out to the ends of the limbs.

Each step is a pass: a function from a `Draft` to a `Draft`. The nodes of the flow that stay keep their order, and new
ones come after them, so that whatever speaks of the flow's nodes (a loss on a replay, say) speaks of the same ones in
the finished curve.
"""

from collections.abc import Callable
from functools import partial
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from scipy import spatial

from msf_jax.host.curve import branches, centring, containment, leaf_extension, limbs, loops, resampling
from msf_jax.host.poles.roadmap import Roadmap
from msf_jax.host.solid.enclosure import Enclosure
from msf_jax.host.thin import missed_limbs, reeb_curve

SPACING = 0.5  # radii, between the nodes of a finished curve
MOST_NODES = 5_000  # that this may take, or they are farther apart
SHARPEST = 40.0  # degrees, that a finished branch turns at a node
HOLDS = 1.1  # of a node's ball: a junction whose ball is within that is none of its own place
FIRST_ROUNDS = 2  # of centring, before it is decided what to prune; tips, too, set out from there


class Draft(NamedTuple):
    """A curve on its way to being finished.

    vertices: (N, 3). edges: (E, 2). is_held: (N,) nodes that do not move. origin: (N,) the flow's node that each is,
    in ascending order, and -1 for the new ones, which come last. node_of_flow: (n,) the node that stands for each of
    the flow's: itself, or the junction that its branch was pruned from. place: (N, 3) where each was found at first,
    or, of a junction, where it is to be. is_former_junction: (N,) those junctions, and what is left of them when their
    branches are pruned. is_sparse: whether nodes are farther apart than they should be, as there would be too many.
    num_pruned, num_grown: branches that were taken away as they are no limbs, and that the flow had lost, counted by
    their ends.
    """

    vertices: np.ndarray
    edges: np.ndarray
    is_held: np.ndarray
    origin: np.ndarray
    node_of_flow: np.ndarray
    place: np.ndarray
    is_former_junction: np.ndarray
    is_sparse: bool = False
    num_pruned: int = 0
    num_grown: int = 0

    def changed(self, vertices: np.ndarray, edges: np.ndarray | None = None) -> "Draft":
        """The same with its nodes moved, new ones last, and with other edges if they are given."""
        new = (0, len(vertices) - len(self.vertices))
        return self._replace(
            vertices=vertices,
            edges=self.edges if edges is None else edges,
            is_held=np.pad(self.is_held, new),
            is_former_junction=np.pad(self.is_former_junction, new),
            origin=np.pad(self.origin, new, constant_values=-1),
            place=np.concatenate([self.place, vertices[len(self.vertices) :]]),
        )

    def is_leaf(self) -> np.ndarray:
        """(N,) True for a node with one edge."""
        return np.bincount(self.edges.ravel(), minlength=len(self.vertices)) == 1


class Job(NamedTuple):
    """What a pass may ask.

    shape: the solid, of diagonal 1. coarse: much the same of fewer triangles, good enough to find the middle of.
    prune: slenderness below which branches are pruned, 0 for none (see `limbs`). is_thin: whether limbs of the solid
    are (see `poles.thickness`).
    roadmap: ways through the solid. budget: of all centring.
    """

    shape: Enclosure
    coarse: Enclosure
    prune: float
    is_thin: bool
    roadmap: Roadmap
    budget: centring.Budget


class Finished(NamedTuple):
    """vertices (N, 3) and edges (E, 2) of the finished curve.

    is_kept: (n,) which of the flow's nodes are in it, in their order, before all others.
    target: (n,) the flow's node that stands for each: itself, or the junction that its branch was pruned from.
    num_refused: edges outside that were left there, as a bound was hit. num_closed: those with no way inside.
    is_cut_short: whether centring was left early, as its bound was hit. is_sparse, num_pruned, num_grown: see `Draft`.
    node_of_vertex: (V,) where waves have made the curve, the node that each vertex of the solid goes to; else None.
    """

    vertices: np.ndarray
    edges: np.ndarray
    is_kept: np.ndarray
    target: np.ndarray
    num_refused: int = 0
    num_closed: int = 0
    is_cut_short: bool = False
    is_sparse: bool = False
    num_pruned: int = 0
    num_grown: int = 0
    node_of_vertex: np.ndarray | None = None


def passes(centre: bool, extend: bool) -> list[Callable[[Draft, Job], Draft]]:
    """The passes in their order; ``centre`` and ``extend`` switch those that belong to them."""
    return [
        contained,
        looped,
        # What to prune is decided on a curve that is centred.
        *([straightened, placed, partial(centred, rounds=FIRST_ROUNDS, is_far=True), straightened] if centre else []),
        merged,
        *([refined] if centre else []),
        *([extended, completed] if extend else []),
        *([partial(centred, hold_leaves=extend)] if centre else []),
        # All branches are candidates now, and one measure decides which of them are limbs.
        pruned,
        *([partial(centred, hold_leaves=extend, rounds=FIRST_ROUNDS)] if centre else []),
        contained,
        *([partial(straightened, most=SHARPEST), contained] if centre else []),
        pruned,
        coincident_merged,
        looped,
        *([corners_rounded] if centre else []),
    ]


def finish(
    shape: Enclosure,
    nodes: np.ndarray,
    edges: np.ndarray,
    is_held: np.ndarray,
    *,
    prune: float,
    centre: bool,
    extend: bool,
    is_thin: bool = False,
    is_tangle: bool = False,
    coarse: Enclosure | None = None,
    first: Callable[[Draft, Job], Draft] | None = None,
) -> Finished:
    """Finish the curve ``(nodes (n, 3), edges)`` of a solid of diagonal 1; nodes of ``is_held`` (n,) do not move.

    Of a solid too coarse for the flow waves make another curve (see `thin.reeb_curve`), if both steps are wanted and no
    node is held.

    ``prune`` is the slenderness below which branches are pruned; ``centre`` and ``extend`` switch those steps.
    ``is_thin`` says that it has thin limbs, of which waves may make the curve. ``is_tangle`` says that the flow has
    left a tangle, which no pass can mend: it stays as it is, unless waves make a curve. ``coarse`` is much the same
    surface of fewer triangles, which is good enough to find the middle of. ``first`` is a pass that comes before all
    others, and may say where the flow's nodes are to be.
    """
    job = Job(
        shape,
        shape if coarse is None else coarse,
        prune,
        is_thin,
        Roadmap(shape, containment.is_inside),
        centring.Budget(),
    )
    if is_thin and centre and extend and not is_held.any():
        laid = reeb_curve.reeb_curve(shape, containment.is_inside)
        if laid is not None:
            return _of_reeb_curve(laid, nodes, job)
    if is_tangle:
        return Finished(nodes, edges, np.ones(len(nodes), dtype=bool), np.arange(len(nodes)))
    draft = Draft(nodes, edges, is_held, np.arange(len(nodes)), np.arange(len(nodes)), nodes, np.zeros_like(is_held))
    for each in [*([] if first is None else [first]), *passes(centre, extend)]:
        draft = each(draft, job)
    is_kept = np.isin(np.arange(len(nodes)), draft.origin)
    return Finished(
        draft.vertices,
        in_order(draft.edges),
        is_kept,
        draft.origin[draft.node_of_flow],
        job.roadmap.num_refused,
        job.roadmap.num_closed,
        job.budget.was_hit,
        draft.is_sparse,
        draft.num_pruned,
        draft.num_grown,
    )


def _of_reeb_curve(laid: reeb_curve.ReebCurve, nodes: np.ndarray, job: Job) -> Finished:
    """The curve that waves have ``laid``. Each of the flow's ``nodes`` (n, 3) is the one that is nearest to it; where
    several are, the first stays. It is in the middle and out to the ends: centring and tips are left out. In its draft
    the solid's vertices follow the nodes, in place of the flow's."""
    x, num = laid.vertices, len(laid.vertices)
    none = np.zeros(num, dtype=bool)
    draft = Draft(x, laid.edges, none, np.arange(num), laid.node_of_vertex, x, none)
    for each in (contained, opened, pruned, straightened, contained, coincident_merged, looped, corners_rounded):
        draft = each(draft, job)
    near = np.asarray(spatial.KDTree(draft.vertices).query(nodes)[1])
    taken, first, place = np.unique(near, return_index=True, return_inverse=True)
    is_kept = np.isin(np.arange(len(nodes)), first)
    every = np.arange(len(draft.vertices))
    source = np.concatenate([near[is_kept], np.setdiff1d(every, taken)])
    rank = np.empty_like(every)
    rank[source] = every
    return Finished(
        draft.vertices[source],
        in_order(rank[draft.edges]),
        is_kept,
        first[place],
        job.roadmap.num_refused,
        job.roadmap.num_closed,
        num_pruned=draft.num_pruned,
        node_of_vertex=rank[draft.node_of_flow],
    )


def contained(draft: Draft, job: Job) -> Draft:
    """Nodes and edges inside, without the ends that no way leads to."""

    def inside(draft: Draft) -> Draft:
        return draft.changed(*containment.contain(job.shape, draft.vertices, draft.edges, draft.is_held, job.roadmap))

    draft = inside(draft)
    if job.roadmap.num_closed:
        stays, target = containment.cut_off(job.shape, draft.vertices, draft.edges, draft.is_held)
        draft = draft if stays.all() else inside(_left(draft, stays, target))
    return draft


def opened(draft: Draft, job: Job) -> Draft:
    """With no loop but those around handles of the solid, one around each at most."""
    if not job.shape.handles.genus:
        return draft
    return draft._replace(edges=draft.edges[loops.independent(job.shape, draft.vertices, draft.edges)])


def looped(draft: Draft, job: Job) -> Draft:
    """With a loop around every handle of the solid, and no other."""
    draft = opened(draft, job)
    x, edges = draft.vertices, draft.edges
    missing = job.shape.handles.genus - branches.cycle_count(len(x), edges)[1]
    if missing:
        x, edges, _ = containment.refine(job.shape, x, edges, SPACING, MOST_NODES)
        x, edges = loops.completed(job.roadmap, x, edges, missing)
    return draft.changed(x, edges)


def straightened(draft: Draft, job: Job, most: float = 90.0) -> Draft:
    """No branch turns by more than ``most`` degrees at a node, if it need not."""
    x = containment.straighten(job.shape, draft.vertices, draft.edges, draft.is_held, most)
    return draft.changed(_around(draft, job, x))


def placed(draft: Draft, job: Job) -> Draft:
    """With the places of junctions where the solid is roomiest, if that is near, or a ball there holds theirs."""
    is_former_junction = (np.bincount(draft.edges.ravel(), minlength=len(draft.vertices)) > 2) & ~draft.is_held
    is_former_junction[is_former_junction] = job.coarse.contains(draft.place[is_former_junction])
    place = draft.place.copy()
    if is_former_junction.any():
        own, clearance = (job.coarse.approximate_clearance(x)[0] for x in (place[is_former_junction], draft.vertices))
        is_held_in = np.asarray(
            spatial.distance.cdist(place[is_former_junction], draft.vertices) + own[:, None] <= HOLDS * clearance
        )
        largest = np.where(is_held_in, clearance, -1.0).argmax(axis=1)
        place[is_former_junction] = np.where(
            np.any(is_held_in, axis=1, keepdims=True), draft.vertices[largest], place[is_former_junction]
        )
    place[is_former_junction] = centring.deepest_points(job.coarse, place[is_former_junction])
    return draft._replace(place=place, is_former_junction=is_former_junction)


def centred(
    draft: Draft, job: Job, rounds: int = centring.ROUNDS, hold_leaves: bool = False, is_far: bool = False
) -> Draft:
    """Nodes in the middle of the solid."""
    is_held = draft.is_held | draft.is_leaf() if hold_leaves else draft.is_held
    x = centring.centre(
        job.coarse,
        draft.vertices,
        draft.edges,
        is_held,
        rounds,
        draft.place,
        draft.is_former_junction,
        is_far,
        job.budget,
    )
    return draft.changed(_around(draft, job, x))


def _around(draft: Draft, job: Job, x: np.ndarray) -> np.ndarray:
    """Nodes ``x`` (N, 3) that a pass has moved, but for branches that would go around other handles then: those stay.

    An edge goes around the same ones exactly if its class is the same, but for what the ways of its ends add.
    """
    handles, before, x = job.shape.handles, draft.vertices, x.copy()
    if not handles.genus:
        return x
    a, b = draft.edges.T
    own, paths = handles.classes(before[a], before[b]), branches.trace(len(x), draft.edges)
    while True:
        moved = handles.classes(before, x)
        is_bad = handles.classes(x[a], x[b]) != own + moved[b] - moved[a]
        if not is_bad.any():
            return x
        bad = {frozenset(edge) for edge in draft.edges[is_bad].tolist()}
        for nodes in paths:
            if not bad.isdisjoint(map(frozenset, pairwise(nodes))):
                x[nodes] = before[nodes]


def merged(draft: Draft, job: Job) -> Draft:
    """With one junction where several are well within one ball."""
    if not job.prune:
        return draft
    x = draft.vertices
    stays, target, edges = branches.merge_junctions(
        x, draft.edges, job.shape.approximate_closest(x)[0], draft.is_held, job.shape.handles
    )
    return _left(draft._replace(edges=edges), stays, target)


def pruned(draft: Draft, job: Job) -> Draft:
    """Without the branches that are no limbs."""
    if not job.prune:
        return draft
    x, e = draft.vertices, draft.edges
    left = _left(draft, *limbs.prune(x, e, limbs.limbs_of(job.shape, x, e), job.prune, draft.is_held))
    return left._replace(num_pruned=draft.num_pruned + int(draft.is_leaf().sum() - left.is_leaf().sum()))


def _left(draft: Draft, stays: np.ndarray, target: np.ndarray) -> Draft:
    """The nodes that stay (N,); the others go to their ``target`` (N,)."""
    x, e, is_held = draft.vertices, draft.edges, draft.is_held
    rank = np.cumsum(stays) - 1
    left = rank[e[stays[e].all(axis=1)]]
    of_flow = rank[target[draft.node_of_flow]]
    return draft._replace(
        vertices=x[stays],
        edges=left,
        is_held=is_held[stays],
        origin=draft.origin[stays],
        node_of_flow=of_flow,
        place=draft.place[stays],
        is_former_junction=draft.is_former_junction[stays],
    )


def refined(draft: Draft, job: Job) -> Draft:
    """With nodes about every ``SPACING`` radii."""
    x, edges, is_sparse = containment.refine(job.shape, draft.vertices, draft.edges, SPACING, MOST_NODES)
    return draft.changed(x, edges)._replace(is_sparse=is_sparse)


def extended(draft: Draft, job: Job) -> Draft:
    """Leaves at the ends of their limbs."""
    return draft.changed(*leaf_extension.extend(job.shape, draft.vertices, draft.edges, draft.is_held))


def completed(draft: Draft, job: Job) -> Draft:
    """With the thin limbs that the flow has lost."""
    more = draft.changed(*missed_limbs.grow(job.coarse, draft.vertices, draft.edges))
    return more._replace(num_grown=int(more.is_leaf().sum() - draft.is_leaf().sum()))


def coincident_merged(draft: Draft, job: Job) -> Draft:
    """No edge twice, and none without length: cycles are cycles in space."""
    stays, target, edges = branches.merge_coincident(draft.vertices, draft.edges, draft.is_held)
    return _left(draft._replace(edges=edges), stays, target)


def corners_rounded(draft: Draft, job: Job) -> Draft:
    """With corners that cannot be cut rounded within their balls."""
    return draft.changed(*resampling.round_corners(job.shape, draft.vertices, draft.edges, draft.is_held, SHARPEST))


def in_order(edges: np.ndarray) -> np.ndarray:
    """Edges with their smaller node first, in ascending order."""
    return np.unique(np.sort(edges, axis=1), axis=0).reshape(-1, 2)


def nearest_on_branch(
    nodes: np.ndarray, edges: np.ndarray, points: np.ndarray, node_of_point: np.ndarray
) -> np.ndarray:
    """Let each point (P, 3) go to the nearest node of its own branch; one at a junction, of any that meet there.

    Nodes have moved along their branches, and there are new ones, since a point was given its node. Returns (P,) nodes.
    """
    found = node_of_point.copy()
    least = np.full(len(points), np.inf)
    order = np.argsort(node_of_point, kind="stable")
    bounds = np.searchsorted(node_of_point[order], np.arange(len(nodes) + 1))
    for path in branches.trace(len(nodes), edges):
        own = np.concatenate([order[bounds[node] : bounds[node + 1]] for node in dict.fromkeys(path)])
        if len(own):
            on_way = np.array(path)
            away, place = spatial.KDTree(nodes[on_way]).query(points[own])
            is_nearer = away < least[own]
            found[own[is_nearer]] = on_way[np.asarray(place)[is_nearer]]
            least[own[is_nearer]] = away[is_nearer]
    return found
