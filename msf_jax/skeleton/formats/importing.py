"""Curves from files: of other programs, and this one's own with all that they hold."""

import os
from pathlib import Path

import numpy as np

from msf_jax.base.errors import ConfigError
from msf_jax.skeleton.formats import parsing, polylines, swc, whole
from msf_jax.skeleton.skeleton import Skeleton, curve_of


def read_curve(path: str | os.PathLike[str]) -> Skeleton:
    """The curve in a file that `Skeleton.save` wrote, or another program: ``.npz``, ``.json``, ``.swc``, ``.obj``,
    ``.cg``, ``.ply``, ``.graphml`` or ``.polylines.txt``. Not read are ``.vtp``, ``.csv`` and ``.glb``.

    Returns:
        A skeleton. An ``.npz`` has all that was saved but the stages of the flow, so that it can be pruned, resampled
        and followed; a ``.json`` of this program all but the surface. The others have an empty map, and a report that
        knows counts only: SWC has radii, and edges that this program cut are joined again; PLY and GraphML have radii
        if the file does; OBJ, CG and polylines have radii 0, and ends of polylines in the same place are one node.

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
    suffix = next((suffix for suffix in [".json", *READERS] if name.lower().endswith(suffix)), None)
    if suffix is None:
        raise ConfigError(f"cannot read {name!r}: expected one of {', '.join(['.npz', '.json', *READERS])}")
    if b"\0" in content:
        raise ConfigError(f"{name!r} is no text: expected a {suffix} file as text")
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = content.decode("latin-1")  # comments; numbers are the same in both
    if suffix == ".json":
        arrays, report = whole.read_json(name, text)
        return Skeleton(**arrays, report=report)
    return _checked(name, *READERS[suffix](name, text.splitlines()))


def _checked(name: str, vertices: np.ndarray, edges: object, radii: np.ndarray) -> Skeleton:
    pairs = np.unique(np.sort(np.array(edges, dtype=np.int64).reshape(-1, 2), axis=1), axis=0)
    pairs = pairs[pairs[:, 0] != pairs[:, 1]]
    if len(pairs) and not (pairs.min() >= 0 and pairs.max() < len(vertices)):
        raise ConfigError(f"{name!r} has edges to nodes that it does not hold: expected numbers below {len(vertices)}")
    if len(vertices) == 0 or not np.isfinite(vertices).all() or not np.isfinite(radii).all():
        raise ConfigError(f"{name!r} holds {len(vertices)} nodes, not all finite: expected at least one, with numbers")
    return curve_of(vertices, pairs, radii)


READERS = {
    ".swc": swc.parsed,
    ".polylines.txt": polylines.parsed,
    ".obj": parsing.obj,
    ".cg": parsing.cg,
    ".ply": parsing.ply,
    ".graphml": parsing.graphml,
}
