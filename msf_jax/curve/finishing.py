"""From the flow's curve to the finished curve: inside, pruned, centred, and extended to the ends of the limbs.

Each step is a pass from a `Draft` to a `Draft`. The flow's nodes that stay keep their order, and new nodes come after
them: a function of the flow's nodes, such as a loss on a replay, means the same nodes in the finished curve.
"""

from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import numpy as np
from scipy import spatial

from msf_jax.base.clock import Clock, Stopped
from msf_jax.curve import branches, centring, handle_loops, junctions
from msf_jax.inside import containment
from msf_jax.limbs import one_branch, reeb_curve
from msf_jax.limbs.ends import SPACING
from msf_jax.limbs.tree import LimbTree
from msf_jax.solid.enclosure import Enclosure
from msf_jax.topology import graphs

MOST_NODES = 5_000  # nodes of a finished curve; if `SPACING` needs more, nodes are farther apart
ASTRAY = 0.05  # share of its length outside: with more, the flow's curve is astray; 0.03 is usual


class Draft(NamedTuple):
    """A curve on its way to being finished.

    vertices: (N, 3). edges: (E, 2). is_held: (N,) nodes that do not move. origin: (N,) the number of each node in the
    flow's curve, ascending; -1 for new nodes, which come last. node_of_flow: (n,) the node for each of the flow's
    nodes: itself, or the junction that its branch was pruned from. is_sparse: whether nodes are farther apart than
    `SPACING`, because of `MOST_NODES`. num_pruned, num_grown: ends of branches that were removed because they are no
    limbs, and that were added because the flow had missed them. finer: limbs of a finer detail, as the least detail and
    the place (3,) of the end of each."""

    vertices: np.ndarray
    edges: np.ndarray
    is_held: np.ndarray
    origin: np.ndarray
    node_of_flow: np.ndarray
    is_sparse: bool = False
    num_pruned: int = 0
    num_grown: int = 0
    finer: tuple[tuple[float, np.ndarray], ...] = ()

    def changed(self, vertices: np.ndarray, edges: np.ndarray | None = None) -> "Draft":
        """The draft with moved nodes, new ones last, and with other edges if they are given."""
        new, edges = (0, len(vertices) - len(self.vertices)), self.edges if edges is None else edges
        is_held, origin = np.pad(self.is_held, new), np.pad(self.origin, new, constant_values=-1)
        return self._replace(vertices=vertices, edges=edges, is_held=is_held, origin=origin)

    def is_leaf(self) -> np.ndarray:
        """(N,) True for a node with one edge."""
        return graphs.degrees(len(self.vertices), self.edges) == 1


class Job(NamedTuple):
    """The inputs of all passes. shape: the solid, of diagonal 1. coarse: about the same surface with fewer triangles,
    fine enough for centring. prune: least slenderness of a limb, 0 for no pruning (see `limbs.tree`). roadmap: paths
    through the solid. limbs: returns the merge trees of the surface. detail: of limbs (see `Config`)."""

    shape: Enclosure
    coarse: Enclosure
    prune: float
    roadmap: containment.Roadmap
    limbs: Callable[[], LimbTree]
    detail: float


def reduced(draft: Draft, stays: np.ndarray, target: np.ndarray) -> Draft:
    """The draft with the nodes of ``stays`` (N,) only; the others are replaced by their ``target`` (N,)."""
    rank = np.cumsum(stays) - 1
    edges, of_flow = rank[draft.edges[stays[draft.edges].all(axis=1)]], rank[target[draft.node_of_flow]]
    x, is_held, origin = draft.vertices[stays], draft.is_held[stays], draft.origin[stays]
    return draft._replace(vertices=x, edges=edges, is_held=is_held, origin=origin, node_of_flow=of_flow)


class Finished(NamedTuple):
    """A finished curve, and its Roadmap, which knows the limits that searches reached. is_kept: (n,) which of the
    flow's nodes are in it. They come first, in their order. target: (n,) the flow's node that represents each: itself,
    or the junction that its branch was pruned from. node_of_vertex: (V,) for a Reeb curve, the node of each vertex of
    the solid; else None. is_cut: whether the run had to end before all passes were done."""

    draft: Draft
    roadmap: containment.Roadmap
    is_kept: np.ndarray
    target: np.ndarray
    node_of_vertex: np.ndarray | None
    is_cut: bool


def passes(centre: bool, extend: bool) -> list[Callable[[Draft, Job], Draft]]:
    """The passes in their order; ``centre`` and ``extend`` switch the passes for these steps."""
    meet = partial(centre_and_meet, hold_leaves=extend)
    centred = [partial(meet, is_far=True), refine, meet]
    inside = [contain, complete_cycles]
    return [*inside, partial(prune_and_extend, extend=extend), *(centred if centre else [merge_junctions]), *inside]


def finish(
    job: Job,
    draft: Draft,
    *,
    centre: bool,
    extend: bool,
    is_thin: bool,
    is_tangle: bool,
    outside: Enclosure,
    first: Callable[[Draft, Job], Draft] | None,
    clock: Clock,
) -> Finished:
    """Finish the ``draft`` of the flow's curve; its held nodes do not move.

    ``centre`` and ``extend`` switch those passes. If both are on and no node is held, a solid that is too coarse for
    the flow gets a Reeb curve (see `limbs.reeb_curve`): if it ``is_thin``, or more than `ASTRAY` of the flow's curve is
    outside, unless more of the Reeb curve is. ``is_tangle`` says that the flow ended in a tangle that no pass can
    repair: it stays as it is, unless there is a Reeb curve. ``outside`` is the surface without cavities. ``first`` is a
    pass that comes before all others. If ``clock`` says that the run has to end, the curve is the one after the last
    pass that was done."""
    nodes, laid, is_cut = draft.vertices, None, False
    try:
        if centre and extend and not draft.is_held.any():
            clock.check()
            laid = _by_wavefronts(outside, nodes, draft.edges, job, is_thin, is_tangle)
        if laid is not None:
            draft, first, is_tangle = _of_reeb_curve(laid, nodes), None, False
        for each in [] if is_tangle else [*([first] if first else []), *passes(centre, extend)]:
            clock.check()
            draft = each(draft, job)
    except Stopped:
        is_cut = True
    if (draft.origin < 0).all():  # every node is new, so the first one stands for the flow's nearest node
        draft.origin[0] = np.linalg.norm(nodes - draft.vertices[0], axis=1).argmin()
    is_kept, of_flow = np.isin(np.arange(len(nodes)), draft.origin), draft.node_of_flow[: len(nodes)]
    target = draft.origin[graphs.nearest_along(draft.vertices, draft.edges, draft.origin >= 0)[of_flow]]
    of_vertex = None if laid is None else draft.node_of_flow[len(nodes) :]
    draft = draft._replace(edges=in_order(draft.edges))
    return Finished(draft, job.roadmap, is_kept, target, of_vertex, is_cut)


def _by_wavefronts(
    outside: Enclosure, nodes: np.ndarray, edges: np.ndarray, job: Job, is_thin: bool, is_tangle: bool
) -> reeb_curve.ReebCurve | None:
    """The Reeb curve that takes the place of the flow's, see `finish`. That can be inside because it lost limbs."""
    astray = 1.0 if is_tangle else _outside(job, nodes, edges)
    if not (is_thin or astray > ASTRAY):
        return None
    laid = reeb_curve.reeb_curve(outside)
    is_worse = laid is not None and _outside(job, *laid[:2]) > max(astray, ASTRAY)
    return None if is_worse else laid


def _outside(job: Job, nodes: np.ndarray, edges: np.ndarray) -> float:
    """The share of a curve's length in edges that are not inside: rings of a body with arms are no sections of it."""
    is_out = ~job.shape.holds(*nodes[edges.T])
    length = graphs.lengths(nodes, edges)
    return float(length[is_out].sum() / max(length.sum(), 1e-300))


def _of_reeb_curve(laid: reeb_curve.ReebCurve, nodes: np.ndarray) -> Draft:
    """The draft of a Reeb curve. The first of the flow's ``nodes`` (n, 3) nearest to a node becomes that one, others go
    there. In ``node_of_flow`` (n + V,), the solid's vertices come after the flow's nodes."""
    near = np.asarray(spatial.KDTree(laid.vertices).query(nodes)[1])
    taken, first = np.unique(near, return_index=True)
    origin = np.full(len(laid.vertices), len(nodes))
    origin[taken] = first
    order = np.argsort(origin, kind="stable")
    rank, origin = np.argsort(order), np.where(origin < len(nodes), origin, -1)[order]
    of_flow = rank[np.concatenate([near, laid.node_of_vertex])]
    return Draft(laid.vertices[order], rank[laid.edges], np.zeros(len(order), dtype=bool), origin, of_flow)


def contain(draft: Draft, job: Job) -> Draft:
    """Nodes and edges are inside."""
    return draft.changed(*containment.contain(job.roadmap, draft.vertices, draft.edges, draft.is_held))


def complete_cycles(draft: Draft, job: Job) -> Draft:
    """There is one loop around every handle of the solid, and no other loop."""
    x, edges, genus = draft.vertices, draft.edges, job.shape.handles.genus
    if graphs.cycle_count(len(x), edges)[1]:
        edges = edges[handle_loops.independent(job.shape, x, edges)]
    missing = genus - graphs.cycle_count(len(x), edges)[1]
    job.roadmap.num_unsought = 0
    if missing > 0:
        x, edges, _ = containment.refine(job.shape, x, edges, SPACING, MOST_NODES)
        x, edges = handle_loops.completed(job.roadmap, x, edges, missing)
    return draft.changed(x, edges)


def merge_junctions(draft: Draft, job: Job) -> Draft:
    """Junctions inside the ball of another one are merged."""
    if not job.prune:
        return draft
    x, radii = draft.vertices, job.shape.distances(draft.vertices)
    stays, target, edges = branches.merge_junctions(x, draft.edges, radii, draft.is_held, job.shape.handles)
    return reduced(draft._replace(edges=edges), stays, target)


def centre_and_meet(draft: Draft, job: Job, hold_leaves: bool, is_far: bool = False) -> Draft:
    """Nodes are in the middle of the solid, and junctions are where the axes of their branches meet."""
    curve = draft.vertices, draft.edges, draft.is_held | draft.is_leaf() if hold_leaves else draft.is_held
    rounds = centring.ROUNDS // 3 if is_far else centring.ROUNDS  # a few before junctions are sought
    draft = draft.changed(centring.centre(job.coarse, *curve, rounds, is_far, job.shape.handles))
    radii = job.coarse.clearance(draft.vertices)
    step = junctions.met(job.shape, draft.vertices, draft.edges, draft.is_held, radii) - draft.vertices
    at = centring.places_of(job.shape, draft.vertices)
    x = centring.take_steps(job.shape, job.shape.handles, at, step, draft.edges).x
    return merge_junctions(draft.changed(x), job)


def refine(draft: Draft, job: Job) -> Draft:
    """Nodes are about ``SPACING`` radii apart."""
    x, edges, is_sparse = containment.refine(job.shape, draft.vertices, draft.edges, SPACING, MOST_NODES)
    return draft.changed(x, edges)._replace(is_sparse=is_sparse)


def prune_and_extend(draft: Draft, job: Job, extend: bool) -> Draft:
    """Every limb of the solid has one branch, and no other branch ends in a leaf, but for held nodes. ``extend``:
    whether branches are laid to the ends of their limbs, and limbs without a branch get one."""
    if not (job.prune or extend):
        return draft
    tree = job.limbs()
    limbs = tree.limbs(job.prune, job.detail)
    leaf, axes = one_branch.choose(tree, limbs, job.coarse, draft.vertices, draft.edges, draft.is_held)
    num_leaves, is_lost, missing = int(draft.is_leaf().sum()), leaf < 0, 0
    if job.prune:
        if extend:
            missing = int(is_lost.sum())
            x, edges, leaf = one_branch.grown(job.coarse, draft.vertices, draft.edges, leaf, axes)
            draft = draft.changed(x, edges)
        is_end = np.isin(np.arange(len(draft.vertices)), leaf)
        stays, target = one_branch.kept(draft.vertices, draft.edges, is_end, draft.is_held)
        draft, leaf = reduced(draft, stays, target), np.cumsum(stays)[leaf] - 1
    num_pruned = num_leaves + missing - int(draft.is_leaf().sum())
    if extend:
        leaf[is_lost | draft.is_held[leaf]] = -1  # a held one is an end
        curve = draft.vertices, draft.edges, draft.is_held
        draft = contain(draft.changed(*one_branch.laid(*curve, leaf, axes)), job)
    finer = tuple((each.detail, each.place) for each in limbs.finer)
    return draft._replace(num_pruned=num_pruned, num_grown=missing, finer=finer)


def in_order(edges: np.ndarray) -> np.ndarray:
    """Edges with their smaller node first, in ascending order."""
    return np.unique(np.sort(edges, axis=1), axis=0).reshape(-1, 2)
