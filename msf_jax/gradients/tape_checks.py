"""Checks of a tape from a file: types, shapes, ranges, and indices.

Another program can write a file with a valid digest. Without these checks, an invalid value would raise an obscure
error in a replay, or make it NaN.
"""

from typing import Any

import numpy as np

from msf_jax.base.layout import Layout
from msf_jax.device.playback import Basis, Mixing, Part, Polynomial, Shape, Stretch


def check_part(part: Part, shape: Shape, num: int) -> int:
    """Raise a ValueError unless ``part`` is valid for a mesh of ``num`` vertices. Returns its number of node rows."""
    own, rows, nodes = len(part.vertices), len(part.tetrahedron), len(part.is_held)
    numbers(part.vertices, (own, 3), "vertices")
    indices(part.vertex_of_input, (own,), num, "vertex_of_input")
    flags(part.is_pin, (own,), "is_pin")
    indices(part.tetrahedron, (rows, 4), rows, "tetrahedron")
    flags(part.is_firm, (rows,), "is_firm")
    numbers(part.offset, (rows, 3), "offset")
    _check_mixing(part.gather, rows, own, "gather")
    _check_filter(part.mesh_filter, own, own, shape.mesh_layout)
    _check_filter(part.site_filter, rows, rows, shape.layouts[0] if shape.layouts else None)
    if len(part.stretches) != len(shape.layouts):
        raise ValueError(f"it has {len(part.stretches)} stretches: expected {len(shape.layouts)}, one for each layout")
    before = rows
    for stretch, layout in zip(part.stretches, shape.layouts, strict=True):
        before = _check_stretch(stretch, layout, before, rows)
    indices(part.meso_row, (len(part.meso_row),), before, "meso_row")
    _check_mixing(part.nodes, nodes, len(part.meso_row), "nodes")
    pins = len(part.pin_node)
    indices(part.pin_node, (pins,), nodes, "pin_node")
    indices(part.pin_input, (pins,), num, "pin_input")
    numbers(part.pin_share, (pins,), "pin_share")
    flags(part.is_held, (nodes,), "is_held")
    numbers(part.centre, (3,), "centre")
    numbers(part.axes, (3, 3), "axes")
    if not numbers(part.diagonal, (), "diagonal") > 0:
        raise ValueError("diagonal is not positive")
    return nodes


def _check_stretch(stretch: Stretch, layout: Layout, before: int, sites: int) -> int:
    """The number of rows of the workspace after ``stretch``, for ``before`` rows before it."""
    _check_layout(layout)
    lines, size = len(stretch.factor), layout.capacity
    if np.ndim(stretch.cut) != 4:
        raise ValueError(f"cut has shape {np.shape(stretch.cut)}: expected four axes")
    rounds, cuts = np.shape(stretch.cut)[1:3]
    num_rows = size + rounds * cuts
    indices(stretch.handover, (size,), before, "handover")
    indices(stretch.enter, (lines, size), num_rows, "enter")
    indices(stretch.site, (lines, size), sites, "site")
    indices(stretch.group, (lines, size), size, "group")
    indices(stretch.cut, (lines, rounds, cuts, 3), num_rows, "cut")
    if len(stretch.rings) != 4:
        raise ValueError(f"rings are {len(stretch.rings)} tables: expected four")
    for table in stretch.rings[:3]:
        indices(table, (lines, layout.num_slots), size, "rings")
    flags(stretch.rings[3], (lines, layout.num_slots), "rings")
    for name in ("degree", "free", "pull", "share", "blend"):
        numbers(getattr(stretch, name), (lines, size), name)
    numbers(stretch.left, (lines, 2, size, 3), "left")
    if not (numbers(stretch.factor, (lines,), "factor") > 0).all():
        raise ValueError("factor is not positive")
    return num_rows


def _check_layout(layout: Any) -> None:
    if not isinstance(layout, Layout) or not layout.levels:
        raise ValueError(f"a layout is {layout!r:.80}: expected a Layout with levels")
    offset, most = 0, layout.capacity
    for level in layout.levels:
        whole = all(isinstance(value, int) and not isinstance(value, bool) for value in level)
        if not (whole and level.offset == offset and level.slots > 0 and 0 <= level.rows <= most):
            raise ValueError("the levels of a layout do not follow each other")
        offset, most = level.end, level.rows


def _check_mixing(mixing: Any, rows: int, columns: int, name: str) -> None:
    if not isinstance(mixing, Mixing):
        raise ValueError(f"{name} is a {type(mixing).__name__}: expected a Mixing")
    size = (len(mixing.row),)
    indices(mixing.row, size, rows, name)
    indices(mixing.column, size, columns, name)
    numbers(mixing.share, size, name)
    numbers(mixing.blend, size, name)


def _check_filter(kept: Any, most: int, rows: int, layout: Layout | None) -> None:
    """Raise a ValueError unless ``kept`` is a valid filter of ``most`` values, ``rows`` of which are used."""
    if kept is None:
        return
    if isinstance(kept, Basis):
        if np.ndim(kept.basis) != 2 or len(kept.basis) > most:
            raise ValueError(f"a basis has shape {np.shape(kept.basis)}: expected at most {most} rows")
        numbers(kept.basis, np.shape(kept.basis), "basis")
        return
    if not isinstance(kept, Polynomial) or layout is None:
        raise ValueError(f"a filter is a {type(kept).__name__}: expected a Basis, or a Polynomial with a layout")
    _check_layout(layout)
    size = layout.capacity
    indices(kept.vertex, (size,), most, "vertex")
    indices(kept.row, (rows,), size, "row")
    indices(kept.neighbour, (layout.num_slots,), size, "neighbour")
    flags(kept.is_used, (layout.num_slots,), "is_used")
    numbers(kept.degree, (size,), "degree")
    numbers(kept.share, (len(kept.share),), "share")
    if not numbers(kept.top, (), "top") > 0:
        raise ValueError("top is not positive")


def indices(array: Any, shape: tuple[int, ...], num: int, name: str) -> np.ndarray:
    """Raise a ValueError unless ``array`` has that shape and integers from 0 to ``num`` - 1."""
    array = np.asarray(array)
    if array.dtype.kind not in "iu" or array.shape != shape:
        raise ValueError(f"{name} is {array.dtype} of shape {array.shape}: expected whole numbers, {shape}")
    if array.size and not (array.min() >= 0 and array.max() < num):
        expected = f"0 to {num - 1}" if num else "none"
        raise ValueError(f"{name} is from {array.min()} to {array.max()}: expected {expected}")
    return array


def numbers(array: Any, shape: tuple[int, ...], name: str) -> np.ndarray:
    """Raise a ValueError unless ``array`` has that shape and finite real numbers."""
    array = np.asarray(array)
    if array.dtype.kind not in "fiu" or array.shape != shape:
        raise ValueError(f"{name} is {array.dtype} of shape {array.shape}: expected numbers, {shape}")
    if not np.isfinite(array).all():
        raise ValueError(f"{name} has values that are not finite")
    return array


def flags(array: Any, shape: tuple[int, ...], name: str) -> np.ndarray:
    """Raise a ValueError unless ``array`` has that shape and is boolean."""
    array = np.asarray(array)
    if array.dtype.kind != "b" or array.shape != shape:
        raise ValueError(f"{name} is {array.dtype} of shape {array.shape}: expected True and False, {shape}")
    return array
