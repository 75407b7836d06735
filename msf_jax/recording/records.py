"""The records of a run's decisions, and the tape of a component that is made of them on request, for `device.playback`.

The edits before and after the iterations are linear in positions and weights: one sparse matrix each. All collapses of
an iteration are a group and a share for each row. A split is not linear: its place, the projection of an apex, is
computed anew; its three rows are recorded.
"""

from itertools import pairwise, zip_longest
from typing import Any, NamedTuple

import numpy as np
from scipy import sparse

from msf_jax.base.decisions import Mixing, Part, Polynomial, Stretch
from msf_jax.base.layout import FEW, Layout, capacity_for, layout_for
from msf_jax.meso import packing
from msf_jax.meso.edits import CollapseRound, SplitRound
from msf_jax.meso.frame import UnitFrame
from msf_jax.meso.meso import Compaction, Meso
from msf_jax.numerics.reconstruction import LowPass
from msf_jax.solid.geometry import RESOLUTION

SPLIT_TOGETHER = 64  # splits in a round of a tape: a run's own rounds have some 300, then 50, then few


class FoundPoles(NamedTuple):
    """Poles (n, 3) of a surface: kept filters its vertices to the sites (n, 3), tetrahedron (n, 4) has the sites whose
    circumcentre the pole is, or is near as the centre of a ball, is_inside (n,) whether it pulls."""

    kept: LowPass | None
    sites: np.ndarray
    poles: np.ndarray
    tetrahedron: np.ndarray
    is_inside: np.ndarray


class Start(NamedTuple):
    """The preparation of a component: the filter of its mesh, edits, and poles."""

    mesh_filter: LowPass | None
    edits: list[Any]
    found: FoundPoles | None


class Step(NamedTuple):
    """One iteration on a surface of m vertices, and the edits after it.

    order: (m,) the vertex in each packed row; the other arrays are by rows. positions: (m, 3) float32, before the
    iteration. rings: (m, K), see `packing.pack`. degree, free, pull: (m,). left: (2, m, 3), of `cg.SolveReport`.
    factor: on w_L.
    """

    order: np.ndarray
    positions: np.ndarray
    rings: np.ndarray
    degree: np.ndarray
    free: np.ndarray
    pull: np.ndarray
    left: np.ndarray
    factor: float
    edits: list[Any]


class ComponentRecord(NamedTuple):
    """The data for the tape of a component.

    vertices: (V, 3) in the frame. vertex_of_input: (V,) the caller's vertex for each. pins: vertices held in place.
    num_meso: number of vertices of the contracted surface. thinning: its edits before the curve was extracted.
    node_of_meso: the node whose position each vertex contributes to, or -1. node_of_pin: the node of each pin.
    """

    vertices: np.ndarray
    faces: np.ndarray
    vertex_of_input: np.ndarray
    frame: UnitFrame
    pins: np.ndarray
    start: Start
    steps: list[Step]
    num_meso: int
    thinning: list[Any]
    node_of_meso: np.ndarray
    node_of_pin: np.ndarray
    num_nodes: int


class Recording(NamedTuple):
    """A run's components, and the caller's mesh. is_joined: whether repair made vertices."""

    components: tuple[ComponentRecord, ...]
    vertices: np.ndarray
    faces: np.ndarray
    is_joined: bool


def record_component(record: ComponentRecord) -> tuple[Part, tuple[Layout, ...], tuple[int, int]]:
    """The tape of a component, the layouts of its stretches, and its numbers m and N without padding."""
    start, steps, num = record.start, record.steps, len(record.vertices)
    place = edit_matrix(start.edits, num)
    plan = layouts_of(steps)
    order, capacity = (steps[0].order, plan[0][2].capacity) if steps else (np.arange(place.shape[0]), place.shape[0])
    row = site = np.argsort(order)  # of each vertex: its row, and the row of the first stretch whose pole it has
    stretches = []
    for first, last, layout in plan:
        stretch, row, site = record_stretch(steps[first:last], layout, row, site)
        stretches.append(stretch)
    mesh_filter = site_filter = None
    if start.mesh_filter:
        meso = Meso.from_mesh(record.vertices, record.faces)
        mesh_filter = record_filter(start.mesh_filter, np.arange(num), meso.rings, meso.degree, capacity_for(num))
    if start.found and start.found.kept and steps:
        site_filter = record_filter(start.found.kept, order, steps[0].rings, steps[0].degree, capacity)
    is_node = record.node_of_meso >= 0
    node, vertex = record.node_of_meso[is_node], np.flatnonzero(is_node)
    share = 1.0 / np.bincount(node, minlength=record.num_nodes)[node]
    means = sparse.csr_matrix((share, (node, vertex)), shape=(record.num_nodes, len(is_node)))
    num_pins = np.bincount(record.node_of_pin, minlength=record.num_nodes)
    part = Part(
        vertices=padded(record.vertices),
        vertex_of_input=padded(record.vertex_of_input.astype(np.int32)),
        is_pin=padded(np.isin(np.arange(num), record.pins)),
        mesh_filter=mesh_filter,
        gather=entries(place[order]),
        site_filter=site_filter,
        **record_poles(start.found, order, capacity),
        stretches=tuple(stretches),
        meso_row=padded(row.astype(np.int32)),
        nodes=entries(means @ edit_matrix(record.thinning, record.num_meso)),
        pins=Mixing(
            padded(record.node_of_pin.astype(np.int32)),
            padded(record.vertex_of_input[record.pins].astype(np.int32)),
            padded(1.0 / num_pins[record.node_of_pin]),
        ),
        is_held=padded(num_pins > 0),
        centre=record.frame.centre,
        diagonal=np.asarray(record.frame.diagonal),
        axes=record.frame.axes,
    )
    return part, tuple(layout for *_, layout in plan), (len(row), record.num_nodes)


def padded(values: np.ndarray) -> np.ndarray:
    """``values`` with zeros up to a capacity."""
    return packing.pad(values, capacity_for(len(values)), 0, values.dtype)


def layouts_of(steps: list[Step]) -> list[tuple[int, int, Layout]]:
    """One or two layouts for the iterations, whichever have fewer slots, each after its first iteration and the first
    one beyond: each takes seconds to compile, but in one for all, late iterations would be mostly padding."""

    def planned(*bounds: int) -> list[tuple[int, int, Layout]]:
        plan = []
        for first, last in pairwise(bounds):
            beyond = zip_longest(*(packing.rows_beyond(step.degree) for step in steps[first:last]), fillvalue=0)
            most = max(len(step.order) for step in steps[first:last])
            plan.append((first, last, layout_for(most, list(map(max, beyond)))))
        return plan

    plans = [planned(0, *cut, len(steps)) for cut in [(), *((k,) for k in range(1, len(steps)))]] if steps else [[]]
    return min(plans, key=lambda plan: sum((last - first) * layout.num_slots for first, last, layout in plan))


def record_stretch(
    steps: list[Step], layout: Layout, row: np.ndarray, site: np.ndarray
) -> tuple[Stretch, np.ndarray, np.ndarray]:
    """The `Stretch` of ``steps`` in one layout. ``row`` (m,): of the workspace before, for every vertex. ``site`` (m,):
    the row of the first stretch whose pole each vertex has. Returns what these are afterwards, too."""
    capacity = layout.capacity
    cuts = [[edit for edit in step.edits if isinstance(edit, SplitRound)] for step in steps]
    num_rounds = capacity_for(max(sum(-(-len(done.a) // SPLIT_TOGETHER) for done in rounds) for rounds in cuts), FEW)
    own, lines = np.arange(capacity), []

    def in_rows(values: np.ndarray, fill: float = 0.0, dtype: type = np.float64) -> np.ndarray:
        return packing.pad(values, capacity, fill, np.dtype(dtype))

    start = in_rows(row[steps[0].order], dtype=np.int32)
    for step, rounds in zip(steps, cuts, strict=True):
        rank, num_rows = np.argsort(step.order), len(step.order)
        row_before, pole = row, in_rows(site[step.order], dtype=np.int32)
        group, share = merged([edit for edit in step.edits if isinstance(edit, CollapseRound)], num_rows)
        # Ids of vertices become rows of the buffers, and those of new ones, which have no pole, of the workspace.
        fresh = np.zeros(sum(len(done.new) for done in rounds), dtype=np.int64)
        row, site = np.concatenate([rank, fresh]), np.concatenate([site, fresh])
        cut, first = np.zeros((num_rounds * SPLIT_TOGETHER, 3), dtype=np.int32), 0
        for done in rounds:
            place = first + np.arange(len(done.new))
            row[done.new] = capacity + place
            cut[place] = np.stack([row[done.a], row[done.b], row[done.apex]], axis=1)
            first += -(-len(place) // SPLIT_TOGETHER) * SPLIT_TOGETHER
        line = Stretch(
            start=None,
            rings=packing.slots(step.rings, step.degree, layout),
            enter=(in_rows(row_before[step.order]) if lines else own).astype(np.int32),
            degree=in_rows(step.degree),
            free=in_rows(step.free),
            pull=in_rows(step.pull),
            site=pole,
            left=np.pad(step.left.astype(np.float64), ((0, 0), (0, capacity - num_rows), (0, 0))),
            factor=np.asarray(step.factor),
            group=np.concatenate([rank[group[step.order]], own[num_rows:]]).astype(np.int32),
            share=in_rows(share[step.order], 1.0),
            cut=cut.reshape(num_rounds, SPLIT_TOGETHER, 3),
        )
        lines.append(line)
        for edit in step.edits:
            if isinstance(edit, CollapseRound):
                site[edit.survivor] = np.where(edit.takes_pole, site[edit.removed], site[edit.survivor])
            elif isinstance(edit, Compaction):
                row, site = row[edit.live], site[edit.live]
    idle = lines[0]._replace(factor=np.zeros(()))
    lines = [idle] * (capacity_for(len(steps), FEW) - len(steps)) + lines
    rings = tuple(np.stack(table) for table in zip(*(line.rings for line in lines), strict=True))
    stacked = {name: np.stack([getattr(line, name) for line in lines]) for name in Stretch._fields[2:]}
    return Stretch(start=start, rings=rings, **stacked), row, site


def merged(rounds: list[CollapseRound], num_rows: int) -> tuple[np.ndarray, np.ndarray]:
    """The row (n,) that each row is merged into in ``rounds``, and its share of that."""
    group, share = np.arange(num_rows), np.ones(num_rows)
    for done in rounds:
        target, keeps = np.arange(num_rows), np.ones(num_rows)
        target[done.removed] = done.survivor
        keeps[done.survivor], keeps[done.removed] = 1 - done.fraction, done.fraction
        share *= keeps[group]
        group = target[group]
    return group, share


def edit_matrix(edits: list[Any], num_rows: int) -> Any:
    """The effect of ``edits`` with known fractions: a sparse matrix (rows after, before)."""
    matrix: Any = sparse.csr_matrix(sparse.identity(num_rows))
    for edit in edits:
        row = np.arange(matrix.shape[0])
        if isinstance(edit, CollapseRound):
            group, share = merged([edit], len(row))
            matrix = sparse.csr_matrix((share, (group, row)), shape=(len(row), len(row))) @ matrix
        elif isinstance(edit, SplitRound):
            fresh, ends = np.arange(len(edit.a)), np.r_[edit.a, edit.b]
            shares = np.r_[1 - edit.fraction, edit.fraction]
            cut = sparse.csr_matrix((shares, (np.r_[fresh, fresh], ends)), shape=(len(fresh), len(row)))
            matrix = sparse.vstack([matrix, cut @ matrix], format="csr")
        elif isinstance(edit, Compaction):
            matrix = matrix[edit.live]
    return matrix


def entries(matrix: Any) -> Mixing:
    """The entries of a sparse ``matrix`` that are not 0, padded."""
    row, column, share = sparse.find(matrix)
    return Mixing(padded(row.astype(np.int32)), padded(column.astype(np.int32)), padded(share))


def record_filter(
    kept: LowPass, order: np.ndarray, rings: np.ndarray, degree: np.ndarray, capacity: int
) -> np.ndarray | Polynomial:
    """The filter on vertices ``order`` (n,), padded to ``capacity``. Of their neighbours ``rings`` (n, K) the first
    ``degree`` (n,) count."""
    if kept.basis is not None:
        return packing.pad(kept.basis[order], capacity, 0, np.dtype(np.float64))
    width, count = rings.shape[1], len(kept.share)
    neighbour = np.zeros((capacity, capacity_for(width, FEW)), dtype=np.int32)
    neighbour[: len(rings), :width] = np.where(np.arange(width) < degree[:, None], rings, 0)
    share = packing.pad(kept.share, capacity_for(count, FEW), 0, np.dtype(np.float64))
    return Polynomial(neighbour, packing.pad(degree, capacity, 0, np.dtype(np.float64)), share, np.asarray(kept.top))


def record_poles(found: FoundPoles | None, order: np.ndarray, capacity: int) -> dict[str, np.ndarray]:
    """Tetrahedra of the poles, by packed rows (n, ...). is_firm: whether the circumcentre of the four sites is
    well-conditioned, by the determinant of three edges over their product, and near the pole; if not, the pole moves
    with their mean. offset: (n, 3) of the pole from either; of the first in multiples of the edges, to turn with them.
    """
    if found is None:
        empty = np.zeros((capacity, 4), dtype=np.int32), np.zeros(capacity, dtype=bool), np.zeros((capacity, 3))
        return dict(zip(("tetrahedron", "is_firm", "offset"), empty, strict=True))
    corner, is_inside = found.sites[found.tetrahedron], found.is_inside[:, None]
    edges = corner[:, 1:] - corner[:, :1]
    square, determinant = (edges * edges).sum(axis=2), np.linalg.det(edges)
    is_firm = found.is_inside & (np.abs(determinant) > RESOLUTION * np.sqrt(square.prod(axis=1)))
    centre = corner.mean(axis=1)
    around = np.linalg.solve(edges[is_firm], square[is_firm, :, None] / 2)[:, :, 0]
    pole = (found.poles - corner[:, 0])[is_firm]
    is_near = np.linalg.norm(around - pole, axis=1) < np.linalg.norm(pole, axis=1)  # one far away moves much faster
    is_firm[is_firm] = is_near
    centre[is_firm] = corner[is_firm, 0] + around[is_near]
    offset, along = np.where(is_inside, found.poles - centre, 0.0), edges[is_firm].transpose(0, 2, 1)
    offset[is_firm] = np.linalg.solve(along, offset[is_firm, :, None])[:, :, 0]
    tetrahedron = np.where(is_inside, np.argsort(order)[found.tetrahedron], 0).astype(np.int32)
    fields = {"tetrahedron": tetrahedron, "is_firm": is_firm, "offset": offset}
    return {name: packing.pad(values[order], capacity, 0, values.dtype) for name, values in fields.items()}
