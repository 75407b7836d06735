"""The curve of each component: extracted from the contracted surface, finished, and joined with the others."""

from functools import partial
from typing import Any, NamedTuple

import numpy as np
from scipy import spatial

from msf_jax.base.clock import Clock
from msf_jax.base.options import Config
from msf_jax.curve import branches, extraction, finishing
from msf_jax.curve.extraction import Curve
from msf_jax.curve.finishing import Draft, Finished, Job
from msf_jax.flow.state import State
from msf_jax.inside.containment import Roadmap
from msf_jax.limbs import one_branch
from msf_jax.meshes.checking import Surface
from msf_jax.meso import edits, surgery
from msf_jax.meso.meso import Meso

MOST_VOLUME = 0.1  # share of the first volume: with more left, the curve is a tangle, and is not finished


class ComponentCurve(NamedTuple):
    """The curve of one component, in its frame.

    curve: the flow's curve, without the branches that were pruned. finished: the same nodes, moved, and new ones.
    found: the curve as extracted from the surface ``meso``, with all branches. is_held: (n,) nodes that have a pin.
    slenderness: (N,) of the finished curve's leaves (see `one_branch.slenderness`); None if limbs were not sought.
    """

    curve: Curve
    found: Curve
    finished: Finished
    meso: Meso
    is_held: np.ndarray
    slenderness: np.ndarray | None


def curve_of(state: State, config: Config, clock: Clock) -> ComponentCurve:
    """The curve of a component's contracted surface, as extracted and finished; a tangle, with more than
    ``MOST_VOLUME`` left, is not finished, unless geodesic wavefronts over the surface make the curve."""
    with clock.stage("curve"):
        meso = state.meso if config.flow.edit_connectivity else _thinned(state.meso, config.flow.threshold_min)
        if clock.reason:  # a surface that has hardly contracted has so many edges that its extraction takes seconds
            meso = _thinned(meso, config.flow.threshold_max)
        pinned, by_surgery = meso.node_of_input[state.pins], config.curve.surgery
        found = extraction.extract_curve(meso.positions, meso.rings, meso.classes, pinned, by_surgery)
        nodes, node_of_pin = found.nodes.copy(), found.node_of_meso[pinned]
        is_held = np.isin(np.arange(len(nodes)), node_of_pin)
        nodes[is_held] = means(state.outside.vertices[state.pins], node_of_pin, len(nodes))[is_held]
    with clock.stage("finishing"):
        coarse = state.coarse if state.shape is state.outside else state.shape  # with the cavities
        limbs: Any = state.limbs and state.limbs.result
        every = np.arange(len(nodes))
        done = finishing.finish(
            Job(state.shape, coarse, config.least_slenderness, Roadmap(state.shape), limbs, config.detail),
            Draft(nodes, found.edges, is_held, every, every),
            centre=config.curve.centre,
            extend=config.curve.extend_tips,
            is_thin=meso.scale is not None,
            is_tangle=is_tangle(state),
            outside=state.outside,
            first=partial(_recentred, meso, found) if by_surgery else None,
            clock=clock,
        )
        slenderness = None
        if state.limbs is not None and not clock.reason:
            slenderness = one_branch.slenderness(limbs(), done.draft.vertices, done.draft.edges)
    state.limbs = None  # as large as the surface
    # The edges of a removed node go to the node that replaces it, so that the curve stays connected.
    stands_for = (np.cumsum(done.is_kept) - 1)[done.target]
    edges = stands_for[found.edges]
    kept = found._replace(
        nodes=nodes[done.is_kept],
        edges=finishing.in_order(edges[edges[:, 0] != edges[:, 1]]),
        node_of_meso=stands_for[found.node_of_meso],
    )
    return ComponentCurve(kept, found, done, meso, is_held[done.is_kept], slenderness)


def _thinned(meso: Meso, t_c: float) -> Meso:
    """A copy of the surface, in which edges shorter than ``t_c`` are collapsed as in an iteration of the flow."""
    meso = meso.copied()
    edits.collapse_short_edges(meso, t_c)
    return meso.compacted()


def _recentred(meso: Meso, found: Curve, draft: Draft, job: Job) -> Draft:
    """A pass that moves the nodes left by surgery back to the middle of the solid."""
    row, shape = meso.node_of_input, job.shape
    contracted = found.node_of_meso[row], meso.positions[row]
    x = surgery.recentred(draft.vertices, draft.edges, *contracted, shape.vertices, shape.faces)
    x[draft.is_held] = draft.vertices[draft.is_held]
    return draft.changed(x)


def is_tangle(state: State) -> bool:
    """Whether the surface has not become a curve, as too much of its volume is left."""
    return abs(state.history[-1].volume if state.history else 1.0) > MOST_VOLUME


def is_left(state: State, part: ComponentCurve) -> bool:
    """Whether the curve is a tangle that was not finished."""
    return is_tangle(state) and part.finished.node_of_vertex is None


class Stitched(NamedTuple):
    """A curve in the caller's units: vertices (N, 3), edges (E, 2), node_of_vertex (V,) of the checked surface, and, if
    known, slenderness (N,) of leaves."""

    vertices: np.ndarray
    edges: np.ndarray
    node_of_vertex: np.ndarray
    slenderness: np.ndarray | None = None


def stitched(
    checked: Surface, states: list[State], parts: list[ComponentCurve], clock: Clock
) -> tuple[Stitched, Stitched]:
    """The flow's curves, component by component, and the finished curves: the flow's nodes come first, with the same
    ids, then the new ones."""
    flow, finished = [], []
    for state, part in zip(states, parts, strict=True):
        own, done, curve = curve_node_of_input(part), part.finished, part.finished.draft[:2]
        node = own if done.node_of_vertex is None else done.node_of_vertex
        if not (is_left(state, part) or done.is_cut or clock.reason):
            node = branches.nearest_on_branch(*curve, state.outside.vertices, node)
        flow.append((part.curve.nodes, part.curve.edges, own))
        finished.append((*curve, node))
    (as_left, _), (done, order) = (_joined(checked, states, parts, curves) for curves in (flow, finished))
    known = [part.slenderness for part in parts if part.slenderness is not None]
    if len(known) == len(parts):
        done = done._replace(slenderness=np.concatenate(known)[order])
    return as_left, done


def _joined(
    checked: Surface, states: list[State], parts: list[ComponentCurve], curves: list[tuple[np.ndarray, ...]]
) -> tuple[Stitched, np.ndarray]:
    """One curve of ``curves``: nodes, edges, and node_of_vertex of each component, in its frame; and the order (N,) of
    these nodes there: those of the flow's curves come first. A pin has its input position, to the last bit."""
    vertices, edges, is_new, first = [], [], [], 0
    node_of_vertex = np.empty(len(checked.vertices), dtype=np.int64)
    for number, (state, part, (nodes, own, node)) in enumerate(zip(states, parts, curves, strict=True)):
        member, lining, count = checked.members[number][state.order], checked.linings[number], len(part.curve.nodes)
        exact = means(checked.vertices[member[state.pins]], curve_node_of_input(part)[state.pins], count)
        placed = state.frame.leave(nodes)
        placed[:count][part.is_held] = exact[part.is_held]
        vertices.append(placed)
        edges.append(first + own)
        is_new.append(np.arange(len(nodes)) >= count)
        node_of_vertex[member] = first + node
        node_of_vertex[lining] = first + spatial.KDTree(nodes).query(state.frame.enter(checked.vertices[lining]))[1]
        first += len(nodes)
    order = np.argsort(np.concatenate(is_new), kind="stable")
    rank = np.argsort(order)
    edges = finishing.in_order(rank[np.concatenate(edges)])
    return Stitched(np.concatenate(vertices)[order], edges, rank[node_of_vertex]), order


def curve_node_of_input(part: ComponentCurve) -> np.ndarray:
    """(V,) the node of the flow's curve for each sorted vertex of the component."""
    return part.curve.node_of_meso[part.meso.node_of_input]


def means(points: np.ndarray, group: np.ndarray, num: int) -> np.ndarray:
    """(num, 3) mean of the points of each group; 0 for an empty group."""
    count = np.maximum(np.bincount(group, minlength=num), 1)
    return np.stack([np.bincount(group, weights=points[:, axis], minlength=num) / count for axis in range(3)], axis=1)
