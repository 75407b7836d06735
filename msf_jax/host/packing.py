"""Padding: the meso-skeleton's arrays at a fixed capacity, ready for the device."""

import numpy as np

from msf_jax.host.meso import Meso


def pad(array: np.ndarray, size: int, fill: float, dtype: np.dtype) -> np.ndarray:
    """``array`` as ``dtype``, with rows of ``fill`` appended up to ``size``."""
    padded = np.full((size, *array.shape[1:]), fill, dtype=dtype)
    padded[: len(array)] = array
    return padded


def pack(meso: Meso, size: int, ring_size: int, area: np.ndarray, dtype: np.dtype) -> dict[str, np.ndarray]:
    """The arrays of `device.buffers.Buffers`, by field: ``size`` rows, ``ring_size`` slots, numbers as ``dtype``."""
    ring = np.repeat(np.arange(size, dtype=np.int32)[None], ring_size, axis=0)  # an unused slot points at its own row
    columns = meso.rings[:, :ring_size].T
    np.copyto(ring[: len(columns), : meso.num_rows], columns, where=columns >= 0, casting="same_kind")
    return {
        "positions": pad(meso.positions, size, 0, dtype),
        "ring": ring,
        "degree": pad(meso.degree, size, 0, np.dtype(np.int32)),
        "free": pad(~meso.is_fixed & meso.is_live, size, 0, dtype),
        "poles": pad(meso.poles, size, 0, dtype),
        "pull": pad(meso.has_pole, size, 0, dtype),
        "area": pad(area, size, 1, dtype),
    }
