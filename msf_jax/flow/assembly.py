"""Make one `Flow` of all components, in the caller's units: curves, report, and the data for a tape."""

import math
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np
from scipy import spatial

from msf_jax import metrics
from msf_jax.base.clock import Clock, begin
from msf_jax.base.options import Config, Weights
from msf_jax.base.writing import counted
from msf_jax.curve import branches, finishing
from msf_jax.flow import curves
from msf_jax.flow.curves import MOST_VOLUME, ComponentCurve, Stitched, is_left
from msf_jax.flow.state import Flow, Iteration, State, stage_at
from msf_jax.limbs import one_branch
from msf_jax.meshes.checking import Surface
from msf_jax.recording.records import ComponentRecord, Recording
from msf_jax.skeleton.report import Report, assessed, bare_ends, loops_of
from msf_jax.skeleton.skeleton import Skeleton, Source
from msf_jax.solid.solid import Solid
from msf_jax.topology import graphs

NAMED = 4  # ends of limbs of a finer detail that a note names
UNCHECKED = "the run ended before the curve was checked: its loops are not proved"
MOST_STAGES = 12  # surfaces of the contraction that are kept for pictures


def assemble(
    checked: Surface,
    solid: Solid,
    pins: np.ndarray,
    states: list[State],
    reasons: list[tuple[bool, str]],
    parts: list[ComponentCurve],
    weights: Weights,
    config: Config,
    clock: Clock,
) -> Flow:
    """The `Flow` of a run. ``solid`` has the surface, ``pins`` are the caller's."""
    as_left, finished = curves.stitched(checked, states, parts, clock)
    history = tuple(line for state in states for line in state.history)
    with clock.stage("report"):
        followed = None if checked.is_made.any() else checked.input_of_vertex
        if followed is not None:  # the first of several welded vertices represents all of them
            pins = np.unique(followed[checked.vertex_of_input[pins]])
        starts = np.cumsum([0, *(len(state.meso.positions) for state in states)]).tolist()
        vertices = np.concatenate([state.frame.leave(state.meso.positions) for state in states])
        faces = np.concatenate([state.meso.faces() + num for state, num in zip(states, starts, strict=False)])
        is_fixed = np.concatenate([state.meso.is_fixed for state in states])
        records = tuple(map(partial(_record, checked), states, parts, checked.members))
        last = max(len(state.steps) for state in states)
        shown = np.unique(np.linspace(0, last, MOST_STAGES).round().astype(int)).tolist()
        stages = tuple(stage_at(iteration, records, vertices, faces, is_fixed) for iteration in shown)
        source = Source(solid, _areas_of_input(checked, solid), pins, stages, followed)
        is_scored = config.evaluate and not clock.reason
        figures = metrics.figures_of(solid.shape, solid.enter(finished.vertices), finished.edges) if is_scored else {}
        report = Report(
            components=0,  # these, the cycles and the inside are those of a curve: see `_skeleton`
            mesh_components=len(reasons),  # including those that an interrupted run did not begin
            genus=checked.genus,
            cycles=0,
            inside=np.nan,
            converged=all(is_converged for is_converged, _ in reasons),
            reason="; ".join(dict.fromkeys(reason for _, reason in reasons)),
            iterations=len(history),
            fixed=int(is_fixed.sum()),
            live=sum(state.meso.num_live for state in states),
            volume=max(abs(state.history[-1].volume) if state.history else 1.0 for state in states),
            out_of_steps=sum(not line.has_ended for line in history),
            solve_steps=sum(line.steps + line.smoothing_steps for line in history),
            coarsened=sum(state.num_coarsened for state in states),
            left_out=checked.num_left_out,
            joined_handles=checked.joined_handles,
            repairs=checked.repairs,
            notes=tuple(_notes(states, parts, history)),
            figures=figures,
            seconds=clock.seconds,
            pruned=sum(part.finished.draft.num_pruned for part in parts),
            grown=sum(part.finished.draft.num_grown for part in parts),
            wavefronts=sum(part.finished.node_of_vertex is not None for part in parts),
        )
        curve = _skeleton(as_left, checked, report, source, clock, is_finished=False)
        skeleton = _finished_skeleton(finished, checked, report, source, clock)
    return Flow(
        weights=weights,
        config=config,
        meso_skeleton=(vertices, faces),
        is_fixed=is_fixed,
        history=history,
        curve=curve,
        skeleton=skeleton,
        recording=Recording(records, *checked.given, bool(checked.is_made.any())),
        source=source,
    )


def _notes(states: list[State], parts: list[ComponentCurve], history: tuple[Iteration, ...]) -> list[str]:
    """The report's notes: about the finishing of the curves, limbs of a finer detail, loops, and steps."""
    done, of = [part.finished for part in parts], f"of {len(parts)} curves"
    refused, closed = sum(one.roadmap.num_refused for one in done), sum(one.roadmap.num_closed for one in done)
    laid = sum(one.node_of_vertex is not None for one in done)
    sparse = sum(one.draft.is_sparse for one in done)
    cut, unsought = sum(one.is_cut for one in done), sum(one.roadmap.num_unsought for one in done)
    tangles = sum(map(is_left, states, parts))
    limbs = sorted(
        (detail, state.frame.leave(place).tolist())
        for state, one in zip(states, done, strict=True)
        for detail, place in one.draft.finer
    )
    detail = math.ceil(20 * limbs[0][0]) / 20 if limbs else 0.0
    places = [place for least, place in limbs if least <= detail]
    ends = ", ".join("({:.4g}, {:.4g}, {:.4g})".format(*place) for place in places[:NAMED])
    ends += ", ..." * (len(places) > NAMED)
    redone = sum(line.redone > 0 for line in history)
    steps, edges = "step was" if redone == 1 else "steps were", partial(counted, noun="edge")
    notes = {
        f"{edges(refused)} of the curve may be outside: the search for paths inside reached its limit": refused,
        f"no path inside was found for {edges(closed)} of the curve: the solid may be in pieces there": closed,
        f"edges are longer than the limbs' radius: geodesic wavefronts made the first form of {laid} {of}": laid,
        f"nodes of {sparse} {of} are far apart: the curves are long for their thickness": sparse,
        f"the search for loops around {unsought} handles reached its limit": unsought,
        f"the run had to end before {cut} {of} had been finished": cut,
        f"{tangles} {of} not finished: over {MOST_VOLUME:.0%} of the volume is left": tangles,
        f"{counted(len(places), 'more limb')} at detail {detail:g}: ends at {ends}": places,
        f"{redone} {steps} repeated with a smaller w_L: coordinates diverged": redone,
    }
    return [note for note, holds in notes.items() if holds]


def _skeleton(
    stitched: Stitched, checked: Surface, report: Report, source: Source, clock: Clock, is_finished: bool = True
) -> Skeleton:
    vertices, edges, node_of_vertex, slenderness = stitched
    solid = source.solid
    components, cycles = graphs.cycle_count(len(vertices), edges)
    radii, curve = solid.radii(vertices), (solid.shape, solid.enter(vertices), edges, node_of_vertex)
    inside = metrics.inside_fraction(*curve[:3], radii / solid.diagonal)
    is_used = checked.vertex_of_input >= 0  # a vertex of the caller's mesh that no face uses gets the nearest node
    mesh_map = np.where(is_used, node_of_vertex[checked.vertex_of_input], -1)
    mesh_map[~is_used] = spatial.KDTree(vertices).query(checked.strays)[1]
    skeleton = Skeleton(vertices, edges, radii, mesh_map, report, source)
    if slenderness is not None:
        new = np.full(len(vertices) - len(slenderness), np.inf)
        vars(skeleton)["_slenderness"] = np.concatenate([slenderness, new])
    found: dict[str, Any] = {"doubts": (UNCHECKED,)}
    if not clock.reason:
        is_joined = report.joined_handles is not None
        about = *curve, lambda: skeleton.branches, is_joined, solid.lids
        bare = begin(bare_ends, solid, vertices, edges) if is_finished else None
        found = assessed(*about) if is_finished else loops_of(*curve)
        found["notes"] = (*report.notes, *(bare.result() if bare else ()))
    # The frozen skeleton has no other reader yet, and keeps what it knows of its leaves.
    vars(skeleton)["report"] = replace(report, components=components, cycles=cycles, inside=inside, **found)
    return skeleton


def _finished_skeleton(stitched: Stitched, checked: Surface, report: Report, source: Source, clock: Clock) -> Skeleton:
    """The finished curve, extended to the centres of the openings that repair has closed."""
    is_held = np.zeros(len(stitched.vertices), dtype=bool)
    is_held[stitched.node_of_vertex[checked.vertex_of_input[source.pins]]] = True
    curve = source.solid, stitched.vertices, stitched.edges, is_held
    found = one_branch.opened(*curve, lids_of_repair(checked)) if checked.rims else None
    if found is None or not len(found.ends):
        return _skeleton(stitched, checked, report, source, clock)
    solid = Solid(checked.vertices, checked.faces, found.lids)
    solid.shape = source.solid.shape  # the same, with its trees and crossings
    source = replace(source, solid=solid)
    node = branches.nearest_on_branch(found.nodes, found.edges, checked.vertices, stitched.node_of_vertex)
    led = stitched._replace(vertices=found.nodes, edges=finishing.in_order(found.edges), node_of_vertex=node)
    num = counted(len(found.ends), "opening")
    report = replace(report, notes=(*report.notes, f"the curve ends in the centre of {num} that repair has closed"))
    return replace(_skeleton(led, checked, report, source, clock), openings=tuple(found.ends.tolist()))


def lids_of_repair(checked: Surface) -> np.ndarray:
    """The faces that close the rims of holes: all corners are on one, and no face of the caller's mesh has them."""
    number = np.zeros(len(checked.vertices) + 1, dtype=np.int64)  # the last one is for vertices that are not there
    for count, rim in enumerate(checked.rims, 1):
        number[checked.vertex_of_input[rim]] = count
    number[-1] = 0
    of_corner = number[checked.faces]
    lids = np.flatnonzero((of_corner[:, 0] > 0) & (of_corner == of_corner[:, :1]).all(axis=1))
    given = np.sort(checked.vertex_of_input[checked.given[1]], axis=1)
    rows = np.concatenate([given, np.sort(checked.faces[lids], axis=1)])
    both = np.unique(rows, axis=0, return_inverse=True)[1].ravel()
    return lids[~np.isin(both[len(given) :], both[: len(given)])]


def _record(checked: Surface, state: State, part: ComponentCurve, member: np.ndarray) -> ComponentRecord:
    """The data of a component for the tape. A vertex that is not counted contributes to no node's position."""
    node = np.where(part.finished.is_kept, np.cumsum(part.finished.is_kept) - 1, -1)[part.found.node_of_meso]
    return ComponentRecord(
        vertices=state.outside.vertices,
        faces=state.outside.faces,
        vertex_of_input=checked.input_of_vertex[member[state.order]],
        frame=state.frame,
        pins=state.pins,
        start=state.start,
        steps=state.steps,
        num_meso=len(state.meso.positions),
        thinning=part.meso.edits,
        node_of_meso=np.where(part.found.is_counted, node, -1),
        node_of_pin=curves.curve_node_of_input(part)[state.pins],
        num_nodes=len(part.curve.nodes),
    )


def _areas_of_input(checked: Surface, solid: Solid) -> np.ndarray:
    """(V,) the area that belongs to each vertex of the caller's mesh. Welded vertices share theirs equally.

    The area of a vertex that repair made goes to the caller's vertex that represents it.
    """
    vertex, area, made = checked.vertex_of_input, solid.vertex_areas.copy(), np.flatnonzero(checked.is_made)
    np.add.at(area, vertex[checked.input_of_vertex[made]], area[made])
    is_used = vertex >= 0
    area = area / np.maximum(np.bincount(vertex[is_used], minlength=len(checked.vertices)), 1)
    return np.where(is_used, area[vertex], 0.0)
