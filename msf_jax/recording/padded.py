"""The decisions of a run as padded arrays: the tape of one component, for `device.playback`.

The edits before and after the iterations are linear in the positions, with known shares, and are recorded as one sparse
matrix each. In an iteration, collapses are linear in the positions: after all collapses of an iteration, a vertex is a
weighted sum of others, with shares that are powers of one half. So they are recorded as a group and a share for each
row, however many rounds there were. A split is not linear: its place, the projection of an apex, is computed anew; its
three rows are recorded.
"""

from typing import Any, NamedTuple

import numpy as np
from scipy import sparse

from msf_jax.base.decisions import Basis, Mixing, Part, Polynomial, Shape, Stretch
from msf_jax.base.layout import Layout, layout_for
from msf_jax.meso import packing
from msf_jax.meso.edits import CollapseRound, SplitRound
from msf_jax.meso.meso import Compaction, Meso
from msf_jax.numerics.reconstruction import LowPass
from msf_jax.recording.records import ComponentRecord, FoundPoles, Step

LEAST_DETERMINANT = 1e-5  # of three edges of a tetrahedron, over their product, for a well-conditioned circumcentre
FEWEST_LINES = 8  # smallest capacity of a stretch, in iterations; idle ones cost almost nothing
FEWEST_ROUNDS, FEWEST_CUTS = 16, 64  # smallest capacities of rounds of splits in an iteration, and of splits in a round
WORTH_A_LAYOUT = 0.7  # ratio of the cost of two layouts to that of one, below which two are compiled


class Planned(NamedTuple):
    """Iterations from ``first`` up to, but not including, ``last`` share ``layout``."""

    first: int
    last: int
    layout: Layout


class Row(NamedTuple):
    """For every vertex (num_rows,): its row of the workspace, and the row of the first stretch whose pole it has."""

    workspace: np.ndarray
    site: np.ndarray


def rung(count: int, smallest: int = 1) -> int:
    """The smallest of ``smallest``, twice that, four times, ... that is at least ``count``; so there are few sizes."""
    size = smallest
    while size < count:
        size *= 2
    return size


def size_for(count: int, smallest: int) -> int:
    """A capacity for ``count``: a `rung` for a quarter more, so that a slightly longer run has the same."""
    return rung(count + count // 4, smallest)


def stretches_of(steps: list[Step]) -> list[Planned]:
    """Divide the iterations into one or two layouts, whichever is cheaper.

    Each layout takes seconds to compile. But a surface shrinks fast, and with one layout for all iterations, the late
    ones would consist mostly of padding.
    """
    if not steps:
        return []

    def needed(first: int, last: int) -> tuple[int, list[int]]:
        beyond = [packing.rows_beyond(step.degree) for step in steps[first:last]]
        most = np.zeros((len(beyond), max(map(len, beyond))), dtype=np.int64)
        for row, counts in zip(most, beyond, strict=True):
            row[: len(counts)] = counts
        return max(len(step.order) for step in steps[first:last]), most.max(axis=0).tolist()

    def planned(first: int, last: int) -> Planned:
        return Planned(first, last, layout_for(*needed(first, last)))

    def cost(plan: list[Planned]) -> float:
        return sum(size_for(last - first, FEWEST_LINES) * layout.num_slots for first, last, layout in plan)

    whole = [planned(0, len(steps))]
    plans = [[planned(0, k), planned(k, len(steps))] for k in range(1, len(steps))]
    best = min(plans, key=cost, default=whole)
    return best if cost(best) < WORTH_A_LAYOUT * cost(whole) else whole


def record_steps(steps: list[Step], plan: list[Planned], num_meso: int) -> tuple[tuple[Stretch, ...], np.ndarray]:
    """A `Stretch` for each of ``plan``, and the row (m,) of each vertex of the meso-skeleton in the last workspace."""
    if not steps:
        return (), np.arange(num_meso)
    first = np.argsort(steps[0].order)
    at = Row(first, first)
    stretches = []
    for start, end, layout in plan:
        stretch, at = _stretch(steps[start:end], layout, at)
        stretches.append(stretch)
    return tuple(stretches), at.workspace


def _stretch(steps: list[Step], layout: Layout, at: Row) -> tuple[Stretch, Row]:
    capacity = layout.capacity
    cuts = [[edit for edit in step.edits if isinstance(edit, SplitRound)] for step in steps]
    num_rounds = size_for(max(map(len, cuts)), FEWEST_ROUNDS)
    num_cuts = size_for(max((len(done.a) for rounds in cuts for done in rounds), default=1), FEWEST_CUTS)
    own = np.arange(capacity, dtype=np.int32)
    lines, handovers = [], []
    for number, (step, rounds) in enumerate(zip(steps, cuts, strict=True)):
        num_rows = len(step.order)
        rank = np.empty(num_rows, dtype=np.int64)
        rank[step.order] = np.arange(num_rows)
        enter, site = packing.pad(at.workspace[step.order], capacity, 0, np.dtype(np.int32)), at.site[step.order]
        handovers.append(enter)
        # Edits have ids of vertices. Here they become rows: of the buffers, and, for new vertices, of the workspace.
        group, share, blend = merged([edit for edit in step.edits if isinstance(edit, CollapseRound)], num_rows)
        row_of, site_of = _rows_after(step, rank, at.site)
        cut = np.zeros((num_rounds, num_cuts, 3), dtype=np.int32)
        for k, done in enumerate(rounds):
            row_of[done.new] = capacity + k * num_cuts + np.arange(len(done.new))
            apex = done.a if done.apex is None else done.apex
            cut[k, : len(done.a)] = np.stack([row_of[done.a], row_of[done.b], row_of[apex]], axis=1)
        lines.append(
            {
                "rings": packing.slots(step.rings, step.degree, layout),
                "degree": packing.pad(step.degree, capacity, 0, np.dtype(np.float64)),
                "free": packing.pad(step.free, capacity, 0, np.dtype(np.float64)),
                "pull": packing.pad(step.pull, capacity, 0, np.dtype(np.float64)),
                "site": packing.pad(site, capacity, 0, np.dtype(np.int32)),
                "left": np.pad(step.left.astype(np.float64), ((0, 0), (0, capacity - num_rows), (0, 0))),
                "factor": np.asarray(step.factor),
                "enter": enter if number else own,
                "group": np.concatenate([rank[group[step.order]], own[num_rows:]]).astype(np.int32),
                "share": packing.pad(share[step.order], capacity, 1, np.dtype(np.float64)),
                "blend": packing.pad(blend[step.order], capacity, 1, np.dtype(np.float64)),
                "cut": cut,
            }
        )
        live = [edit.live for edit in step.edits if isinstance(edit, Compaction)]
        at = Row(*((row_of, site_of) if not live else (row_of[live[0]], site_of[live[0]])))
    idle = _idle(lines[0], layout)
    lines = [idle] * (size_for(len(lines), FEWEST_LINES) - len(lines)) + lines
    rings = tuple(np.stack(values) for values in zip(*(line["rings"] for line in lines), strict=True))
    stacked = {name: np.stack([line[name] for line in lines]) for name in lines[0] if name != "rings"}
    return Stretch(**stacked, rings=rings, handover=handovers[0]), at


def _rows_after(step: Step, rank: np.ndarray, site: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The row of every vertex, extended for new vertices, and the site of its pole after the collapses."""
    num_new = sum(len(edit.new) for edit in step.edits if isinstance(edit, SplitRound))
    site = np.concatenate([site, np.zeros(num_new, dtype=np.int64)])  # a new vertex has no pole that pulls
    for edit in step.edits:
        if isinstance(edit, CollapseRound):
            site[edit.survivor] = np.where(edit.takes_pole, site[edit.removed], site[edit.survivor])
    return np.concatenate([rank, np.zeros(num_new, dtype=np.int64)]), site


def _idle(line: dict[str, Any], layout: Layout) -> dict[str, Any]:
    """An iteration that does nothing: no vertex is free or has neighbours, and there are no collapses or splits."""
    own = np.arange(layout.capacity, dtype=np.int32)
    of_slot = np.concatenate([own[: level.rows] for level in layout.levels for _ in range(level.slots)])
    idle = {name: np.zeros_like(values) for name, values in line.items() if name != "rings"}
    ones = {name: np.ones_like(line[name]) for name in ("factor", "share", "blend")}
    rings = (of_slot, of_slot, of_slot, np.zeros(len(of_slot), dtype=bool))
    return idle | ones | {"rings": rings, "enter": own, "group": own}


def merged(rounds: list[CollapseRound], num_rows: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The row (n,) that each row is merged into in ``rounds``, its share of that row's position, and of its weights."""
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


def record_component(record: ComponentRecord) -> tuple[Part, Shape]:
    """The tape of a component, and the layouts of its stretches and of its mesh filter."""
    start, steps = record.start, record.steps
    num = len(record.vertices)
    place, blend = edit_matrices(start.edits, num)
    capacity = place.shape[0]
    order = np.arange(capacity)
    plan = stretches_of(steps)
    if steps:
        order, capacity = steps[0].order, plan[0].layout.capacity
    mesh_filter, mesh_layout = record_mesh_filter(start.mesh_filter, record.vertices, record.faces)
    stretches, meso_row = record_steps(steps, plan, record.num_meso)
    thinned = edit_matrices(record.thinning, record.num_meso)[0]
    is_node = record.node_of_meso >= 0
    node, vertex = record.node_of_meso[is_node], np.flatnonzero(is_node)
    share = 1.0 / np.bincount(node, minlength=record.num_nodes)[node]
    means = sparse.csr_matrix((share, (node, vertex)), shape=(record.num_nodes, len(is_node)))
    is_held = np.zeros(size_for(record.num_nodes, 64), dtype=bool)
    is_held[record.node_of_pin] = True
    pin_count = np.bincount(record.node_of_pin, minlength=len(is_held))
    is_pin = np.zeros(num, dtype=bool)
    is_pin[record.pins] = True
    part = Part(
        vertices=record.vertices,
        vertex_of_input=record.vertex_of_input.astype(np.int32),
        is_pin=is_pin,
        mesh_filter=mesh_filter,
        gather=entries(place[order], blend[order]),
        site_filter=record_site_filter(start.found.kept if start.found else None, steps, plan),
        **record_poles(start.found, order, capacity),
        stretches=stretches,
        meso_row=packing.pad(meso_row, size_for(len(meso_row), 512), 0, np.dtype(np.int32)),
        nodes=entries(means @ thinned),
        pin_node=record.node_of_pin.astype(np.int32),
        pin_input=record.vertex_of_input[record.pins].astype(np.int32),
        pin_share=1.0 / np.maximum(pin_count[record.node_of_pin], 1),
        is_held=is_held,
        centre=record.frame.centre,
        diagonal=np.asarray(record.frame.diagonal),
        axes=record.frame.axes,
    )
    return part, Shape(tuple(planned.layout for planned in plan), mesh_layout)


def edit_matrices(edits: list[Any], num_rows: int) -> tuple[Any, Any]:
    """The effect of ``edits`` with known fractions on positions and on weights: sparse matrices (rows after, before).

    They differ at a fixed vertex: in a collapse it keeps its position, but gets the mean of the weights.
    """
    place: Any = sparse.csr_matrix(sparse.identity(num_rows))
    blend = place
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


def entries(place: Any, blend: Any = None) -> Mixing:
    """The matrices' entries, padded with zeros."""
    blend = place if blend is None else blend
    row, column = (abs(place) + abs(blend)).nonzero()
    size = size_for(len(row), 256)
    shares = (np.asarray(matrix[row, column]).ravel() for matrix in (place, blend))
    arrays = row.astype(np.int32), column.astype(np.int32), *shares
    return Mixing(*(packing.pad(values, size, 0, values.dtype) for values in arrays))


def record_site_filter(kept: LowPass | None, steps: list[Step], plan: list[Planned]) -> Basis | Polynomial | None:
    """The filter of the sites of poles, for the first rows of the flow."""
    if kept is None or not steps:
        return None
    if kept.basis is not None:
        return Basis(packing.pad(kept.basis[steps[0].order], plan[0].layout.capacity, 0, kept.basis.dtype))
    layout, first = plan[0].layout, steps[0]
    own = np.arange(layout.capacity)
    return _polynomial(kept, packing.slots(first.rings, first.degree, layout), first.degree, own, own)


def record_mesh_filter(
    kept: LowPass | None, vertices: np.ndarray, faces: np.ndarray
) -> tuple[Basis | Polynomial | None, Layout | None]:
    """The filter of the mesh itself, with its own one-rings, and their layout."""
    if kept is None:
        return None, None
    if kept.basis is not None:
        return Basis(kept.basis), None
    meso = Meso.from_mesh(vertices, faces)
    layout = layout_for(meso.num_rows, packing.rows_beyond(meso.degree))
    order, _, fields = packing.pack(meso, layout, np.empty(0), np.dtype(np.float64))
    row = np.argsort(order)
    vertex = packing.pad(order, layout.capacity, 0, order.dtype)
    return _polynomial(kept, fields["rings"], fields["degree"], vertex, row), layout


def _polynomial(
    kept: LowPass, rings: tuple[np.ndarray, ...], degree: np.ndarray, vertex: np.ndarray, row: np.ndarray
) -> Polynomial:
    neighbour, _, _, is_used = rings
    return Polynomial(
        vertex=vertex.astype(np.int32),
        row=row.astype(np.int32),
        neighbour=neighbour,
        is_used=is_used,
        degree=packing.pad(degree, len(vertex), 0, np.dtype(np.float64)),
        share=packing.pad(kept.share, rung(len(kept.share), 32), 0, np.dtype(np.float64)),
        top=np.asarray(kept.top),
    )


def record_poles(found: FoundPoles | None, order: np.ndarray, capacity: int) -> dict[str, np.ndarray]:
    """Tetrahedra of the poles, by packed rows (n, ...).

    is_firm: whether the circumcentre of the four sites is well-conditioned; if not, the pole moves with their mean.
    offset: (n, 3) the pole as it was found, minus the circumcentre or the mean.
    """
    if found is None:
        empty = np.zeros((capacity, 4), dtype=np.int32), np.zeros(capacity, dtype=bool), np.zeros((capacity, 3))
        return dict(zip(("tetrahedron", "is_firm", "offset"), empty, strict=True))
    rank = np.argsort(order)
    corner = found.sites[found.tetrahedron]
    a, b, c = (corner[:, k] - corner[:, 0] for k in (1, 2, 3))
    square = [np.einsum("ij,ij->i", edge, edge) for edge in (a, b, c)]
    determinant = np.einsum("ij,ij->i", a, np.cross(b, c))
    has_volume = np.abs(determinant) > LEAST_DETERMINANT * np.sqrt(square[0] * square[1] * square[2])
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
