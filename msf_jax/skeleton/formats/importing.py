"""Curves of other programs, to score, to draw and to write anew: SWC and CGAL's polylines."""

import os
from pathlib import Path

import numpy as np

from msf_jax.base.errors import ConfigError
from msf_jax.skeleton.formats import polylines, swc
from msf_jax.skeleton.skeleton import Skeleton, curve_of


def read_curve(path: str | os.PathLike[str]) -> Skeleton:
    """The curve in an ``.swc`` or a ``.polylines.txt`` file.

    Returns:
        A skeleton with an empty map, and a report that knows counts only. SWC has radii, and edges that this program
        cut are joined again; polylines have radii 0, and ends in the same place are one node.

    Raises:
        ConfigError: the suffix is another, or a line is not of the format: which, and what was expected.
        OSError: the file cannot be read.
    """
    name = Path(path).name
    content = Path(path).read_bytes()
    if b"\0" in content:
        raise ConfigError(f"{name!r} is no text: expected an .swc or a .polylines.txt file")
    try:
        lines = content.decode("utf-8-sig").splitlines()
    except UnicodeDecodeError:
        lines = content.decode("latin-1").splitlines()  # comments; numbers are the same in both
    for suffix, parsed in READERS.items():
        if name.lower().endswith(suffix):
            return _checked(name, *parsed(name, lines))
    raise ConfigError(f"cannot read {name!r}: expected an .swc or a .polylines.txt file")


def _checked(name: str, vertices: np.ndarray, edges: object, radii: np.ndarray) -> Skeleton:
    pairs = np.unique(np.sort(np.array(edges, dtype=np.int64).reshape(-1, 2), axis=1), axis=0)
    pairs = pairs[pairs[:, 0] != pairs[:, 1]]
    if len(vertices) == 0 or not np.isfinite(vertices).all() or not np.isfinite(radii).all():
        raise ConfigError(f"{name!r} holds {len(vertices)} nodes, not all finite: expected at least one, with numbers")
    return curve_of(vertices, pairs, radii)


READERS = {".swc": swc.parsed, ".polylines.txt": polylines.parsed}
