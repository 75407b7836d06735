"""Curves from files: of other programs, SWC and CGAL's polylines, and this one's own with all that they hold."""

import os
from pathlib import Path

import numpy as np

from msf_jax.base.errors import ConfigError
from msf_jax.skeleton.formats import polylines, swc, whole
from msf_jax.skeleton.skeleton import Skeleton, curve_of


def read_curve(path: str | os.PathLike[str]) -> Skeleton:
    """The curve in an ``.swc``, a ``.polylines.txt`` or an ``.npz`` file.

    Returns:
        A skeleton; an ``.npz`` that `Skeleton.save` wrote has all that it had but the stages of its flow, so that it
        can be pruned, resampled and followed. The others have an empty map, and a report that knows counts only: SWC
        has radii, and edges that this program cut are joined again; polylines have radii 0, and ends in the same place
        are one node.

    Raises:
        ConfigError: the suffix is another, or a line is not of the format: which, and what was expected; or the
            ``.npz`` is damaged, or none of a skeleton.
        OSError: the file cannot be read.
    """
    name = Path(path).name
    if name.lower().endswith(".npz"):
        arrays, report, source = whole.read_npz(path)
        return Skeleton(**arrays, report=report, source=source)
    if Path(path).exists() and not Path(path).is_file():  # a pipe would be waited for
        raise ConfigError(f"{name!r} is no file: expected an .swc, .polylines.txt or .npz file")
    content = Path(path).read_bytes()
    if b"\0" in content:
        raise ConfigError(f"{name!r} is no text: expected an .swc, .polylines.txt or .npz file")
    try:
        lines = content.decode("utf-8-sig").splitlines()
    except UnicodeDecodeError:
        lines = content.decode("latin-1").splitlines()  # comments; numbers are the same in both
    for suffix, parsed in READERS.items():
        if name.lower().endswith(suffix):
            return _checked(name, *parsed(name, lines))
    raise ConfigError(f"cannot read {name!r}: expected an .swc, .polylines.txt or .npz file")


def _checked(name: str, vertices: np.ndarray, edges: object, radii: np.ndarray) -> Skeleton:
    pairs = np.unique(np.sort(np.array(edges, dtype=np.int64).reshape(-1, 2), axis=1), axis=0)
    pairs = pairs[pairs[:, 0] != pairs[:, 1]]
    if len(vertices) == 0 or not np.isfinite(vertices).all() or not np.isfinite(radii).all():
        raise ConfigError(f"{name!r} holds {len(vertices)} nodes, not all finite: expected at least one, with numbers")
    return curve_of(vertices, pairs, radii)


READERS = {".swc": swc.parsed, ".polylines.txt": polylines.parsed}
