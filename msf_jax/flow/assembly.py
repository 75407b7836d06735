"""Put the components of a run together again, in the caller's units, and write the report."""

from dataclasses import replace
from typing import NamedTuple

import numpy as np
from scipy import spatial

from msf_jax import metrics
from msf_jax.base.options import Config, Weights
from msf_jax.flow.state import Flow, State, Stopwatch
from msf_jax.host.curve import branches, extraction, finishing
from msf_jax.host.curve.extraction import Curve
from msf_jax.host.curve.finishing import Finished
from msf_jax.host.mesh.checking import Surface
from msf_jax.host.meso import ring_tables
from msf_jax.host.meso.meso import Meso
from msf_jax.host.recording.records import ComponentRecord, Recording
from msf_jax.host.solid.solid import Solid
from msf_jax.skeleton.report import Report
from msf_jax.skeleton.skeleton import Skeleton
from msf_jax.skeleton.source import Source, Stage

MOST_STAGES = 12  # of the contraction that are kept to be looked at
MOST_VOLUME = 0.1  # that may be left of a component whose curve is worth finishing


class Part(NamedTuple):
    """The curve of one component, in its frame.

    curve: as the flow left it, without the branches that were pruned. finished: the same nodes and more, moved.
    found: as it was read off the surface ``meso``, with those. is_held: (n,) which of the curve's nodes hold a pin.
    """

    curve: Curve
    found: Curve
    finished: Finished
    meso: Meso
    is_held: np.ndarray


def read_curve(state: State, meso: Meso, config: Config, watch: Stopwatch) -> Part:
    """The curve of a contracted surface ``meso``, as it is and finished.

    That of a surface with more than ``MOST_VOLUME`` left is a tangle that no pass can mend, and stays as it is.
    """
    with watch.stage("curve"):
        pinned = meso.node_of_input[state.pins]
        found = extraction.extract_curve(meso.positions, meso.rings, meso.classes, pinned)
        nodes = found.nodes.copy()
        node_of_pin = found.node_of_meso[pinned]
        is_held = np.zeros(len(nodes), dtype=bool)
        is_held[node_of_pin] = True
        nodes[is_held] = _means(state.shape.vertices[state.pins], node_of_pin, len(nodes))[is_held]
    with watch.stage("finishing"):
        if is_tangle(state):
            every = np.arange(len(nodes))
            done = Finished(nodes, found.edges, np.ones(len(nodes), dtype=bool), every)
        else:
            done = finishing.finish(
                state.shape,
                nodes,
                found.edges,
                is_held,
                persistence=config.prune,
                centre=config.centre,
                extend=config.extend_tips,
                rough=state.rough,
            )
    rank = np.cumsum(done.is_kept) - 1
    kept = Curve(
        nodes[done.is_kept],
        rank[found.edges[done.is_kept[found.edges].all(axis=1)]],
        rank[done.target[found.node_of_meso]],
    )
    return Part(kept, found, done, meso, is_held[done.is_kept])


def is_tangle(state: State) -> bool:
    """Whether so much of the volume is left that there is no curve to speak of."""
    return abs(state.history[-1].volume if state.history else 1.0) > MOST_VOLUME


def assemble(
    checked: Surface,
    pins: np.ndarray,
    states: list[State],
    reasons: list[tuple[bool, str]],
    parts: list[Part],
    weights: Weights,
    config: Config,
    watch: Stopwatch,
    notes: list[str],
) -> Flow:
    """The whole run, with the caller's ``pins``, and ``notes`` for the report.

    Nodes of the flow come first, component by component, then those that finishing added.
    """
    flow_nodes, flow_edges, moved_nodes, new_nodes, edges, records = [], [], [], [], [], []
    meso_vertices, meso_faces = [], []
    num_flow = sum(len(part.curve.nodes) for part in parts)
    num_old = num_new = num_meso = 0
    vertex_to_flow = np.empty(len(checked.vertices), dtype=np.int64)
    vertex_to_node = np.empty(len(checked.vertices), dtype=np.int64)
    for state, part, member in zip(states, parts, checked.members, strict=True):
        own, done = part.curve, part.finished
        count = len(own.nodes)
        leave, where = state.frame.leave, member[state.order]
        node_of_vertex = own.node_of_meso[part.meso.node_of_input]
        exact = _means(checked.vertices[where[state.pins]], node_of_vertex[state.pins], count)
        records.append(
            ComponentRecord(
                vertices=state.shape.vertices,
                faces=state.shape.faces,
                vertex_of_input=checked.input_of_vertex[where],
                frame=state.frame,
                pins=state.pins,
                start=state.start,
                steps=state.steps,
                num_meso=len(state.meso.positions),
                thinning=part.meso.edits,
                node_of_meso=np.where(done.is_kept, np.cumsum(done.is_kept) - 1, -1)[part.found.node_of_meso],
                node_of_pin=node_of_vertex[state.pins],
                num_nodes=count,
            )
        )
        for nodes, into in ((own.nodes, flow_nodes), (done.vertices[:count], moved_nodes)):
            placed = leave(nodes)
            placed[part.is_held] = exact[part.is_held]  # a pin is where it was, to the last bit
            into.append(placed)
        new_nodes.append(leave(done.vertices[count:]))
        number = np.arange(len(done.vertices))
        number = np.where(number < count, num_old + number, num_flow + num_new + number - count)
        flow_edges.append(own.edges + num_old)
        edges.append(number[done.edges])
        vertex_to_flow[where] = node_of_vertex + num_old
        if not is_tangle(state):
            node_of_vertex = finishing.nearest_on_branch(
                done.vertices, done.edges, state.shape.vertices, node_of_vertex
            )
        vertex_to_node[where] = number[node_of_vertex]
        meso_vertices.append(leave(state.meso.positions))
        meso_faces.append(state.meso.faces() + num_meso)
        num_old += count
        num_new += len(done.vertices) - count
        num_meso += len(state.meso.positions)
    with watch.stage("report"):
        solid = Solid(checked.vertices, checked.faces)
        source = Source(solid, _areas_of_input(checked, solid), pins, _stages(states))
        drafts = []
        for vertices, joined, of_vertex in (
            (np.concatenate(flow_nodes), np.concatenate(flow_edges), vertex_to_flow),
            (np.concatenate([*moved_nodes, *new_nodes]), finishing.in_order(np.concatenate(edges)), vertex_to_node),
        ):
            components, cycles = branches.cycle_count(len(vertices), joined)
            radii = solid.radii(vertices)
            inside = metrics.inside_fraction(solid.shape, solid.enter(vertices), joined, radii / solid.diagonal)
            figures = {"components": components, "cycles": cycles, "inside": inside}
            drafts.append((vertices, joined, radii, _map_of_input(checked, vertices, of_vertex), figures))
        scores = {}
        if config.evaluate:
            scores = metrics.figures_of(solid.shape, solid.enter(drafts[1][0]), drafts[1][1])
    history = tuple(line for state in states for line in state.history)
    if tangles := sum(map(is_tangle, states)):
        notes = [
            *notes,
            f"{tangles} of {len(states)} curves not finished: over {MOST_VOLUME:.0%} of the volume is left",
        ]
    redone = sum(line.redone > 0 for line in history)
    if redone:
        notes = [*notes, f"{redone} {'step was' if redone == 1 else 'steps were'} redone shorter: numbers ran away"]
    report = Report(
        components=0,
        mesh_components=len(checked.components),
        genus=sum(component.genus for component in checked.components),
        cycles=0,
        inside=0.0,
        converged=all(is_converged for is_converged, _ in reasons),
        reason="; ".join(dict.fromkeys(reason for _, reason in reasons)),
        iterations=len(history),
        fixed=sum(int(state.meso.is_fixed.sum()) for state in states),
        live=sum(state.meso.num_live for state in states),
        volume=max(abs(state.history[-1].volume) if state.history else 1.0 for state in states),
        unsolved=sum(not line.is_solved for line in history),
        solve_steps=sum(line.steps + line.smoothing_steps for line in history),
        coarsened=sum(state.num_coarsened for state in states),
        repairs=checked.repairs,
        notes=tuple(notes),
        figures=scores,
        seconds=watch.seconds,
    )
    as_left, finished = (
        Skeleton(vertices, joined, radii, mesh_map, replace(report, **figures), source)
        for vertices, joined, radii, mesh_map, figures in drafts
    )
    return Flow(
        weights=weights,
        config=config,
        meso_skeleton=(np.concatenate(meso_vertices), np.concatenate(meso_faces)),
        is_fixed=np.concatenate([state.meso.is_fixed for state in states]),
        poles=_by_vertex([state.frame.leave(state.poles) for state in states], states, checked),
        has_pole=_by_vertex([state.has_pole for state in states], states, checked),
        history=history,
        curve=as_left,
        skeleton=finished,
        recording=Recording(tuple(records), *checked.given, checked.input_of_vertex, checked.is_made),
        source=source,
    )


def _stages(states: list[State]) -> tuple[Stage, ...]:
    """At most ``MOST_STAGES`` surfaces, from the first to the last, all components together."""
    last = max(len(state.steps) for state in states)
    stages = []
    for iteration in np.unique(np.linspace(0, last, MOST_STAGES).round().astype(int)).tolist():
        vertices, faces, is_fixed, num = [], [], [], 0
        for state in states:
            if iteration < len(state.steps):
                step = state.steps[iteration]
                is_past = np.arange(step.rings.shape[1]) >= step.degree[:, None]
                faces.append(ring_tables.faces_from_rings(np.where(is_past, -1, step.rings)) + num)
                vertices.append(state.frame.leave(step.positions))
                is_fixed.append(~step.free.astype(bool))
            else:
                faces.append(state.meso.faces() + num)
                vertices.append(state.frame.leave(state.meso.positions))
                is_fixed.append(state.meso.is_fixed)
            num += len(vertices[-1])
        joined = np.concatenate(vertices), np.concatenate(faces).astype(np.int32)
        stages.append(Stage(iteration, *joined, np.concatenate(is_fixed)))
    return tuple(stages)


def _means(points: np.ndarray, group: np.ndarray, num: int) -> np.ndarray:
    """(num, 3) mean of the points of each group, 0 for a group without one."""
    count = np.maximum(np.bincount(group, minlength=num), 1)
    return np.stack([np.bincount(group, weights=points[:, axis], minlength=num) / count for axis in range(3)], axis=1)


def _by_vertex(parts: list[np.ndarray], states: list[State], checked: Surface) -> np.ndarray:
    """One array for the whole surface from one for each component."""
    joined = np.concatenate(parts)
    whole = np.empty_like(joined)
    orders = [member[state.order] for member, state in zip(checked.members, states, strict=True)]
    whole[np.concatenate(orders)] = joined
    return whole


def _map_of_input(checked: Surface, nodes: np.ndarray, node_of_vertex: np.ndarray) -> np.ndarray:
    """(V,) the node of every vertex of the caller's mesh; one that no face uses goes to the nearest node."""
    is_used = checked.vertex_of_input >= 0
    mesh_map = np.where(is_used, node_of_vertex[checked.vertex_of_input], -1)
    mesh_map[~is_used] = spatial.KDTree(nodes).query(checked.strays)[1]
    return mesh_map


def _areas_of_input(checked: Surface, solid: Solid) -> np.ndarray:
    """(V,) share of the area that belongs to every vertex of the caller's mesh; welded ones share theirs.

    That of a vertex that was made where parts were joined goes to the caller's that stands for it.
    """
    vertex, area, made = checked.vertex_of_input, solid.vertex_areas(), np.flatnonzero(checked.is_made)
    np.add.at(area, vertex[checked.input_of_vertex[made]], area[made])
    is_used = vertex >= 0
    area = area / np.maximum(np.bincount(vertex[is_used], minlength=len(checked.vertices)), 1)
    return np.where(is_used, area[vertex], 0.0)
