"""The decisions of a run as padded arrays: the tape of one component, for `device.playback`.

The edits before and after the iterations are linear in the positions, with known shares, and are recorded as one sparse
matrix each. `stretches` records the iterations.
"""

from typing import Any, NamedTuple

import numpy as np
from scipy import sparse

from msf_jax.base.layout import Layout, layout_for
from msf_jax.meso import packing
from msf_jax.meso.collapse import CollapseRound
from msf_jax.meso.meso import Compaction, Meso
from msf_jax.meso.split import SplitRound
from msf_jax.numerics.reconstruction import LowPass
from msf_jax.recording.records import ComponentRecord, FoundPoles, Step
from msf_jax.recording.stretches import Capacity, Planned, merged, record_steps, rung, size_for, stretches_of

LEAST_DETERMINANT = 1e-5  # of three edges of a tetrahedron, over their product, for a well-conditioned circumcentre


class Capacities(NamedTuple):
    """The capacities of a component's tape: of its stretches, of the entries of its two sparse matrices, of vertices of
    the meso-skeleton, and of nodes; 0 if not known yet."""

    stretches: tuple[Capacity, ...] = ()
    gather: int = 0
    thinned: int = 0
    meso: int = 0
    nodes: int = 0


def record_component(
    record: ComponentRecord, before: Capacities | None = None
) -> tuple[dict[str, Any], list[Layout], Layout | None]:
    """The arrays of `device.playback.Part`, by name, and the layouts of its stretches and of its mesh filter.

    ``before``: the capacities of another tape, which are used if they suffice, so that both share programs.
    """
    before, start, steps = before or Capacities(), record.start, record.steps
    num = len(record.vertices)
    place, blend = edit_matrices(start.edits, num)
    capacity = place.shape[0]
    order = np.arange(capacity)
    plan = stretches_of(steps, before.stretches)
    if steps:
        order, capacity = steps[0].order, plan[0].layout.capacity
    mesh_filter, mesh_layout = record_mesh_filter(start.mesh_filter, record.vertices, record.faces)
    stretches, meso_row = record_steps(steps, plan, record.num_meso, before.stretches)
    thinned = edit_matrices(record.thinning, record.num_meso)[0]
    is_node = record.node_of_meso >= 0
    node, vertex = record.node_of_meso[is_node], np.flatnonzero(is_node)
    share = 1.0 / np.bincount(node, minlength=record.num_nodes)[node]
    means = sparse.csr_matrix((share, (node, vertex)), shape=(record.num_nodes, len(is_node)))
    is_held = np.zeros(size_for(record.num_nodes, 64, before.nodes), dtype=bool)
    is_held[record.node_of_pin] = True
    pin_count = np.bincount(record.node_of_pin, minlength=len(is_held))
    is_pin = np.zeros(num, dtype=bool)
    is_pin[record.pins] = True
    arrays = {
        "vertices": record.vertices,
        "vertex_of_input": record.vertex_of_input.astype(np.int32),
        "is_pin": is_pin,
        "mesh_filter": mesh_filter,
        "gather": entries(place[order], blend[order], before.gather),
        "site_filter": record_site_filter(start.found.kept if start.found else None, steps, plan),
        **record_poles(start.found, order, capacity),
        "stretches": stretches,
        "meso_row": packing.pad(meso_row, size_for(len(meso_row), 512, before.meso), 0, np.dtype(np.int32)),
        "nodes": entries(means @ thinned, before=before.thinned),
        "pin_node": record.node_of_pin.astype(np.int32),
        "pin_input": record.vertex_of_input[record.pins].astype(np.int32),
        "pin_share": 1.0 / np.maximum(pin_count[record.node_of_pin], 1),
        "is_held": is_held,
        "centre": record.frame.centre,
        "diagonal": np.asarray(record.frame.diagonal),
        "axes": record.frame.axes,
    }
    return arrays, [planned.layout for planned in plan], mesh_layout


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


def entries(place: Any, blend: Any = None, before: int = 0) -> dict[str, np.ndarray]:
    """The matrices' entries, by the names of `device.playback.Mixing`, padded with zeros."""
    blend = place if blend is None else blend
    row, column = (abs(place) + abs(blend)).nonzero()
    size = size_for(len(row), 256, before)
    shares = {name: np.asarray(matrix[row, column]).ravel() for name, matrix in (("share", place), ("blend", blend))}
    arrays = {"row": row.astype(np.int32), "column": column.astype(np.int32), **shares}
    return {name: packing.pad(values, size, 0, values.dtype) for name, values in arrays.items()}


def record_site_filter(kept: LowPass | None, steps: list[Step], plan: list[Planned]) -> dict[str, Any] | None:
    """The filter of the sites of poles, for the first rows of the flow, by the names of `device.playback`."""
    if kept is None or not steps:
        return None
    if kept.basis is not None:
        return {"basis": packing.pad(kept.basis[steps[0].order], plan[0].layout.capacity, 0, kept.basis.dtype)}
    layout, first = plan[0].layout, steps[0]
    own = np.arange(layout.capacity)
    return _polynomial(kept, packing.slots(first.rings, first.degree, layout), first.degree, own, own)


def record_mesh_filter(
    kept: LowPass | None, vertices: np.ndarray, faces: np.ndarray
) -> tuple[dict[str, Any] | None, Layout | None]:
    """The filter of the mesh itself, with its own one-rings, and their layout."""
    if kept is None:
        return None, None
    if kept.basis is not None:
        return {"basis": kept.basis}, None
    meso = Meso.from_mesh(vertices, faces)
    layout = layout_for(meso.num_rows, packing.rows_beyond(meso))
    order, _, fields = packing.pack(meso, layout, np.empty(0), np.dtype(np.float64))
    row = np.argsort(order)
    vertex = packing.pad(order, layout.capacity, 0, order.dtype)
    return _polynomial(kept, fields["rings"], fields["degree"], vertex, row), layout


def _polynomial(
    kept: LowPass, rings: tuple[np.ndarray, ...], degree: np.ndarray, vertex: np.ndarray, row: np.ndarray
) -> dict[str, Any]:
    neighbour, _, _, is_used = rings
    return {
        "vertex": vertex.astype(np.int32),
        "row": row.astype(np.int32),
        "neighbour": neighbour,
        "is_used": is_used,
        "degree": packing.pad(degree, len(vertex), 0, np.dtype(np.float64)),
        "share": packing.pad(kept.share, rung(len(kept.share), 32), 0, np.dtype(np.float64)),
        "top": np.asarray(kept.top),
    }


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
