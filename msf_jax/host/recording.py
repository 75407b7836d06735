"""What the host decided in a run, as padded arrays: the tape of one component, for `device.replay`.

A collapse is linear in the positions: where all of a phase's collapses put a vertex is a sum of a few others, with
shares that are powers of one half. So a phase of collapses, however many rounds it has, is a group and a share for each
row, and all that comes before the flow, or after it, is one sparse matrix. A split is not: its place is where an apex
projects, which is computed anew. Which rows, in which round, is recorded; `device.replay` does the arithmetic.
"""

from typing import Any, NamedTuple

import numpy as np
from scipy import sparse

from msf_jax.host import packing
from msf_jax.host.collapse import CollapseRound
from msf_jax.host.frame import Frame
from msf_jax.host.meso import Compaction, Meso
from msf_jax.host.reconstruction import LowPass
from msf_jax.host.split import SplitRound
from msf_jax.layout import Layout, layout_for

FLATTEST = 1e-5  # a tetrahedron of less volume, over the product of three edges, says nothing sure of its circumcentre


class FoundPoles(NamedTuple):
    """Poles of a surface of n vertices.

    kept: the filter that made the sites of its vertices. sites: (n, 3). poles: (n, 3). tetrahedron: (n, 4) the sites
    whose circumcentre a pole is. is_inside: (n,) whether it pulls. trust: (n,).
    """

    kept: LowPass | None
    sites: np.ndarray
    poles: np.ndarray
    tetrahedron: np.ndarray
    is_inside: np.ndarray
    trust: np.ndarray


class Start(NamedTuple):
    """What was done to a component before its flow: the mesh filtered, edited, and its poles sought."""

    mesh_filter: LowPass | None
    edits: list[Any]
    found: FoundPoles | None


class Step(NamedTuple):
    """One iteration: the buffers as packed, residuals (2, n, 3) of its solves, w_L's factor, and the edits after it."""

    layout: Layout
    order: np.ndarray
    fields: dict[str, Any]
    left: np.ndarray
    factor: float
    edits: list[Any]


class ComponentRecord(NamedTuple):
    """Everything that the tape of a component is made from.

    vertices: (V, 3) in the frame. vertex_of_input: (V,) the caller's vertex that each is. pins: vertices held in place.
    num_meso: vertices of the contracted surface. thinning: edits of it before the curve was read off.
    node_of_meso: the node (-1 for one that was pruned) of each vertex that was left. node_of_pin: that of each pin.
    """

    vertices: np.ndarray
    faces: np.ndarray
    vertex_of_input: np.ndarray
    frame: Frame
    pins: np.ndarray
    start: Start
    steps: list[Step]
    num_meso: int
    thinning: list[Any]
    node_of_meso: np.ndarray
    node_of_pin: np.ndarray
    num_nodes: int


class Recording(NamedTuple):
    """A run's components, and the caller's mesh; ``input_of_vertex`` is the caller's vertex of each checked one."""

    components: tuple[ComponentRecord, ...]
    vertices: np.ndarray
    faces: np.ndarray
    input_of_vertex: np.ndarray


def rung(count: int) -> int:
    """``count`` or a little more, of few different values: arrays of recorded runs are as long, and compile once."""
    size = 1
    while size < count:
        if size * 3 // 2 >= count and size >= 2:
            return size * 3 // 2
        size *= 2
    return size


def edit_matrices(edits: list[Any], num_rows: int) -> tuple[sparse.csr_matrix, sparse.csr_matrix]:
    """What ``edits`` of known fractions do to positions, and what to weights, as matrices (rows after, rows before).

    They differ at a fixed vertex, which keeps its place in a collapse, but takes the mean of the weights.
    """
    place = blend = sparse.identity(num_rows, format="csr")
    collapses: list[CollapseRound] = []
    for edit in [*edits, None]:
        if isinstance(edit, CollapseRound):
            collapses.append(edit)
            continue
        if collapses:
            group, share, mean = merged(collapses, num_rows)
            row = np.arange(num_rows)
            place = sparse.csr_matrix((share, (group, row)), shape=(num_rows, num_rows)) @ place
            blend = sparse.csr_matrix((mean, (group, row)), shape=(num_rows, num_rows)) @ blend
            collapses = []
        if isinstance(edit, SplitRound):
            fresh = np.arange(len(edit.a))
            shares, rows = np.concatenate([1 - edit.fraction, edit.fraction]), np.concatenate([fresh, fresh])
            cut = sparse.csr_matrix((shares, (rows, np.concatenate([edit.a, edit.b]))), shape=(len(fresh), num_rows))
            place, blend = sparse.vstack([place, cut @ place]).tocsr(), sparse.vstack([blend, cut @ blend]).tocsr()
            num_rows += len(fresh)
        elif isinstance(edit, Compaction):
            place, blend = place[edit.live], blend[edit.live]
            num_rows = len(edit.live)
    return place, blend


def merged(rounds: list[CollapseRound], num_rows: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The row (n,) that each row goes into in ``rounds``, its share of that one's position, and of its weights."""
    group, share, mean = np.arange(num_rows), np.ones(num_rows), np.ones(num_rows)
    for done in rounds:
        target, keeps, halves = np.arange(num_rows), np.ones(num_rows), np.ones(num_rows)
        target[done.removed] = done.survivor
        keeps[done.survivor], keeps[done.removed] = 1 - done.fraction, done.fraction
        halves[done.survivor] = halves[done.removed] = 0.5
        share *= keeps[group]
        mean *= halves[group]
        group = target[group]
    return group, share, mean


def entries(place: sparse.csr_matrix, blend: sparse.csr_matrix | None = None) -> dict[str, np.ndarray]:
    """The matrices' entries, by `device.replay.Mixing`'s names, padded with zeros that do nothing."""
    both = [np.abs(matrix) for matrix in (place, blend) if matrix is not None]
    row, column = sum(both[1:], both[0]).nonzero()
    size = rung(len(row))
    shares = {
        name: np.asarray(matrix[row, column]).ravel()
        for name, matrix in (("share", place), ("blend", place if blend is None else blend))
    }
    arrays = {"row": row.astype(np.int32), "column": column.astype(np.int32), **shares}
    return {name: packing.pad(values, size, 0, values.dtype) for name, values in arrays.items()}


def record_site_filter(kept: LowPass | None, steps: list[Step]) -> dict[str, Any] | None:
    """The filter of the sites of poles, for the rows that the flow begins with, by `device.replay`'s names."""
    if kept is None or not steps:
        return None
    if kept.basis is not None:
        return {"basis": kept.basis[steps[0].order]}
    own = np.arange(steps[0].layout.capacity)
    return _polynomial(kept, steps[0].fields, own, own)


def record_mesh_filter(
    kept: LowPass | None, vertices: np.ndarray, faces: np.ndarray
) -> tuple[dict[str, Any] | None, Layout | None]:
    """The filter that the mesh itself went through, on rings of its own, and their layout."""
    if kept is None:
        return None, None
    if kept.basis is not None:
        return {"basis": kept.basis}, None
    meso = Meso.from_mesh(vertices, faces)
    layout = layout_for(meso.num_rows, packing.rows_beyond(meso))
    order, fields = packing.pack(meso, layout, np.empty(0), np.dtype(np.float64))
    row = np.empty(len(order), dtype=np.int64)
    row[order] = np.arange(len(order))
    return _polynomial(kept, fields, packing.pad(order, layout.capacity, 0, order.dtype), row), layout


def _polynomial(kept: LowPass, fields: dict[str, Any], vertex: np.ndarray, row: np.ndarray) -> dict[str, Any]:
    neighbour, _, _, is_used = fields["rings"]
    return {
        "vertex": vertex.astype(np.int32),
        "row": row.astype(np.int32),
        "neighbour": neighbour,
        "is_used": is_used,
        "degree": fields["degree"],
        "share": kept.share,
        "top": np.asarray(kept.top),
    }


def record_poles(found: FoundPoles | None, order: np.ndarray, capacity: int) -> dict[str, np.ndarray]:
    """Tetrahedra of the poles, by packed rows (n, ...).

    is_firm: where the circumcentre of the four sites is well determined; elsewhere a pole goes with their mean.
    offset: (n, 3) what is to be added to that to give the pole as it was found.
    """
    if found is None:
        empty = np.zeros((capacity, 4), dtype=np.int32), np.zeros(capacity, dtype=bool), np.zeros((capacity, 3))
        return dict(zip(("tetrahedron", "is_firm", "offset"), empty, strict=True))
    rank = np.empty(len(order), dtype=np.int64)
    rank[order] = np.arange(len(order))
    corner = found.sites[found.tetrahedron]
    a, b, c = (corner[:, k] - corner[:, 0] for k in (1, 2, 3))
    square = [np.einsum("ij,ij->i", edge, edge) for edge in (a, b, c)]
    determinant = np.einsum("ij,ij->i", a, np.cross(b, c))
    has_volume = np.abs(determinant) > FLATTEST * np.sqrt(square[0] * square[1] * square[2])
    is_firm = found.is_inside & has_volume
    sum_ = sum(s[:, None] * n for s, n in zip(square, (np.cross(b, c), np.cross(c, a), np.cross(a, b)), strict=True))
    centre = corner[:, 0] + sum_ / (2 * np.where(is_firm, determinant, 1.0))[:, None]
    offset = found.poles - np.where(is_firm[:, None], centre, corner.mean(axis=1))
    tetrahedron = np.where(found.is_inside[:, None], rank[found.tetrahedron], 0)
    offset = np.where(found.is_inside[:, None], offset, 0.0)
    return {
        "tetrahedron": packing.pad(tetrahedron[order], capacity, 0, np.dtype(np.int32)),
        "is_firm": packing.pad(is_firm[order], capacity, 0, np.dtype(bool)),
        "offset": packing.pad(offset[order], capacity, 0, np.dtype(np.float64)),
    }


def record_component(record: ComponentRecord) -> tuple[dict[str, Any], list[Layout], Layout | None]:
    """The arrays of `device.replay.Part`, by name, and the layouts of its stretches and of its mesh filter."""
    start, steps = record.start, record.steps
    num = len(record.vertices)
    place, blend = edit_matrices(start.edits, num)
    order, capacity = np.arange(place.shape[0]), place.shape[0]
    if steps:
        order, capacity = steps[0].order, steps[0].layout.capacity
    mesh_filter, mesh_layout = record_mesh_filter(start.mesh_filter, record.vertices, record.faces)
    stretches, meso_row = record_steps(steps, record.num_meso)
    thinned = edit_matrices(record.thinning, record.num_meso)[0]
    is_node = record.node_of_meso >= 0
    share = is_node / np.maximum(np.bincount(record.node_of_meso[is_node], minlength=record.num_nodes), 1)[
        record.node_of_meso
    ]
    size = record.num_nodes, len(record.node_of_meso)
    means = sparse.csr_matrix((share, (np.maximum(record.node_of_meso, 0), np.arange(size[1]))), shape=size)
    is_held = np.zeros(rung(record.num_nodes), dtype=bool)
    is_held[record.node_of_pin] = True
    pin_count = np.bincount(record.node_of_pin, minlength=len(is_held))
    is_pin = np.zeros(num, dtype=bool)
    is_pin[record.pins] = True
    arrays = {
        "vertices": record.vertices,
        "vertex_of_input": record.vertex_of_input.astype(np.int32),
        "is_pin": is_pin,
        "mesh_filter": mesh_filter,
        "gather": entries(place[order], blend[order]),
        "site_filter": record_site_filter(start.found.kept if start.found else None, steps),
        **record_poles(start.found, order, capacity),
        "stretches": [fields for _, fields in stretches],
        "meso_row": packing.pad(meso_row, rung(len(meso_row)), 0, np.dtype(np.int32)),
        "nodes": entries(means @ thinned),
        "pin_node": record.node_of_pin.astype(np.int32),
        "pin_input": record.vertex_of_input[record.pins].astype(np.int32),
        "pin_share": 1.0 / np.maximum(pin_count[record.node_of_pin], 1),
        "is_held": is_held,
        "centre": record.frame.centre,
        "diagonal": np.asarray(record.frame.diagonal),
        "axes": record.frame.axes,
    }
    return arrays, [layout for layout, _ in stretches], mesh_layout


class Recorded(NamedTuple):
    """Arrays of the iterations in one layout, by the names of `device.replay.Stretch`."""

    layout: Layout
    fields: dict[str, Any]


class Row(NamedTuple):
    """Where every vertex (num_rows,) is: the row that holds it, and the first row whose pole it has."""

    workspace: np.ndarray
    site: np.ndarray


def record_steps(steps: list[Step], num_meso: int) -> tuple[list[Recorded], np.ndarray]:
    """The stretches of a flow, and the row (m,) of the last workspace that each vertex of the meso-skeleton is in."""
    if not steps:
        return [], np.arange(num_meso)
    first = np.empty(len(steps[0].order), dtype=np.int64)
    first[steps[0].order] = np.arange(len(first))
    at = Row(first, first)
    stretches: list[Recorded] = []
    start = 0
    while start < len(steps):
        layout = steps[start].layout
        end = start
        while end < len(steps) and steps[end].layout == layout:
            end += 1
        fields, at = _stretch(steps[start:end], layout, at)
        stretches.append(Recorded(layout, fields))
        start = end
    return stretches, at.workspace


def _stretch(steps: list[Step], layout: Layout, at: Row) -> tuple[dict[str, Any], Row]:
    capacity = layout.capacity
    cuts = [[edit for edit in step.edits if isinstance(edit, SplitRound)] for step in steps]
    num_rounds = rung(max(map(len, cuts))) if any(cuts) else 0
    num_cuts = rung(max((len(done.a) for rounds in cuts for done in rounds), default=1))
    own = np.arange(capacity, dtype=np.int32)
    lines = []
    for number, (step, rounds) in enumerate(zip(steps, cuts, strict=True)):
        num_rows = len(step.order)
        rank = np.empty(num_rows, dtype=np.int64)
        rank[step.order] = np.arange(num_rows)
        source, site = at.workspace[step.order], at.site[step.order]
        if number == 0:
            handover = packing.pad(source, capacity, 0, np.dtype(np.int32))
        # Edits speak of vertices; here everything is a row: of the buffers, then of the workspace with the new ones.
        group, share, blend = merged([edit for edit in step.edits if isinstance(edit, CollapseRound)], num_rows)
        row_of, site_of = list_of_rows(step, rank, at.site)
        cut = np.zeros((num_rounds, num_cuts, 3), dtype=np.int32)
        for k, done in enumerate(rounds):
            row_of[done.new] = capacity + k * num_cuts + np.arange(len(done.new))
            apex = done.a if done.apex is None else done.apex
            cut[k, : len(done.a)] = np.stack([row_of[done.a], row_of[done.b], row_of[apex]], axis=1)
        lines.append(
            {
                "rings": step.fields["rings"],
                "degree": step.fields["degree"],
                "free": step.fields["free"],
                "pull": step.fields["pull"],
                "site": packing.pad(site, capacity, 0, np.dtype(np.int32)),
                "left": step.left,
                "factor": np.asarray(step.factor),
                "enter": packing.pad(source, capacity, 0, np.dtype(np.int32)) if number else own,
                "group": np.concatenate([rank[group[step.order]], own[num_rows:]]).astype(np.int32),
                "share": packing.pad(share[step.order], capacity, 1, np.dtype(np.float64)),
                "blend": packing.pad(blend[step.order], capacity, 1, np.dtype(np.float64)),
                "cut": cut,
            }
        )
        live = [edit.live for edit in step.edits if isinstance(edit, Compaction)]
        at = Row(*((row_of, site_of) if not live else (row_of[live[0]], site_of[live[0]])))
    idle = _idle(lines[0], layout)
    lines = [idle] * (rung(len(lines)) - len(lines)) + lines
    fields = {name: np.stack([line[name] for line in lines]) for name in lines[0] if name != "rings"}
    fields["rings"] = tuple(np.stack(values) for values in zip(*(line["rings"] for line in lines), strict=True))
    fields["handover"] = handover
    return fields, at


def list_of_rows(step: Step, rank: np.ndarray, site: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The row of every vertex, with room for new ones, and the site of the pole that it has after the collapses."""
    num_new = sum(len(edit.new) for edit in step.edits if isinstance(edit, SplitRound))
    site = np.concatenate([site, np.zeros(num_new, dtype=np.int64)])  # a new vertex has no pole that pulls
    for edit in step.edits:
        if isinstance(edit, CollapseRound):
            site[edit.survivor] = np.where(edit.takes_pole, site[edit.removed], site[edit.survivor])
    return np.concatenate([rank, np.zeros(num_new, dtype=np.int64)]), site


def _idle(line: dict[str, Any], layout: Layout) -> dict[str, Any]:
    """An iteration that does nothing: no vertex is free, none has neighbours, none is merged or cut."""
    own = np.arange(layout.capacity, dtype=np.int32)
    of_slot = np.concatenate([own[: level.rows] for level in layout.levels for _ in range(level.slots)])
    idle = {name: np.zeros_like(values) for name, values in line.items() if name != "rings"}
    ones = {name: np.ones_like(line[name]) for name in ("factor", "share", "blend")}
    rings = (of_slot, of_slot, of_slot, np.zeros(len(of_slot), dtype=bool))
    return idle | ones | {"rings": rings, "enter": own, "group": own}
