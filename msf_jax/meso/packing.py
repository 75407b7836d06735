"""Packing of the meso-skeleton's arrays into a padded layout for the device, and unpacking."""

from typing import Any

import numpy as np

from msf_jax.base.layout import Layout
from msf_jax.meso.meso import Meso


def rows_beyond(degree: np.ndarray) -> list[int]:
    """The number of vertices with more than k neighbours, for k up to the largest degree, which a layout depends on."""
    return (len(degree) - np.cumsum(np.bincount(degree)))[:-1].tolist()


def pad(array: np.ndarray, size: int, fill: float, dtype: np.dtype) -> np.ndarray:
    """``array`` as ``dtype``, with rows of ``fill`` appended up to ``size``."""
    padded = np.full((size, *array.shape[1:]), fill, dtype=dtype)
    padded[: len(array)] = array
    return padded


def pack(
    meso: Meso, layout: Layout, area: np.ndarray, dtype: np.dtype, t_c: float = 0.0
) -> tuple[np.ndarray, np.ndarray, dict[str, Any]]:
    """The surface of m vertices in ``layout``: rows sorted by degree, the largest first; real numbers are ``dtype``.

    Returns the vertex (m,) in each row, the rows (m, K) of its neighbours, of which those beyond its degree are not
    defined, and the arrays of `device.buffers.Buffers`, by name.
    """
    order = np.argsort(-meso.degree, kind="stable")
    rank = np.empty(meso.num_rows + 1, dtype=np.int32)
    rank[order] = np.arange(meso.num_rows, dtype=np.int32)
    degree = meso.degree[order]
    rings = rank[meso.rings[order, : max(1, int(degree.max()))]]  # padding -1 takes the spare last entry
    size = layout.capacity
    fields = {
        "positions": pad(meso.positions[order], size, 0, dtype),
        "rings": slots(rings, degree, layout),
        "degree": pad(degree, size, 0, dtype),
        "free": pad(~meso.is_fixed[order] & (degree > 0), size, 0, dtype),
        "poles": pad(meso.poles[order], size, 0, dtype),
        "pull": pad(meso.has_pole[order], size, 0, dtype),
        "t_c": np.asarray(t_c, dtype=dtype),
        "area": pad(area[order] if len(area) else area, size, 1, dtype),
    }
    return order, rings, fields


def slots(rings: np.ndarray, degree: np.ndarray, layout: Layout) -> tuple[np.ndarray, ...]:
    """The fields of `device.buffers.Rings` for ``rings`` (m, K), rows by ``degree`` (m,), the largest first."""
    last = np.arange(len(rings)), degree - 1
    after = np.concatenate([rings[:, 1:], rings[:, :1]], axis=1)
    after[last] = rings[:, 0]
    before = np.concatenate([rings[last][:, None], rings[:, :-1]], axis=1)

    flat, is_used, slot = np.empty((3, layout.num_slots), dtype=np.int32), np.zeros(layout.num_slots, dtype=bool), 0
    for level in layout.levels:
        own = np.arange(level.rows, dtype=np.int32)
        for k in range(level.slots):  # an unused slot refers to its own row
            part = slice(level.offset + k * level.rows, level.offset + (k + 1) * level.rows)
            count = int(np.searchsorted(-degree, -slot, side="left"))  # rows with more than `slot` neighbours
            flat[:, part] = own
            if count:
                flat[:, part][:, :count] = [table[:count, slot] for table in (rings, after, before)]
            is_used[part][:count] = True
            slot += 1
    return *flat, is_used


def unpack(rows: np.ndarray, order: np.ndarray) -> np.ndarray:
    """The live ``rows`` of a device array, as float64 and in the order of the vertices."""
    vertices = np.empty((len(order), *rows.shape[1:]), dtype=np.float64)
    vertices[order] = rows[: len(order)]
    return vertices
