"""Reading of curves and reports from files, of this program and of others."""

import os
from dataclasses import replace
from pathlib import Path

import numpy as np

from msf_jax.base.errors import ConfigError
from msf_jax.base.writing import plain
from msf_jax.meshes import decoding
from msf_jax.skeleton.formats import export, text, whole
from msf_jax.skeleton.skeleton import Skeleton, curve_of

READERS = {
    ".swc": text.read_swc,
    ".polylines.txt": text.read_polylines,
    ".obj": text.read_obj,
    ".ply": text.read_ply,
    ".graphml": text.read_graphml,
}


def read_curve(path: str | os.PathLike[str]) -> Skeleton:
    """The curve in a file that `Skeleton.save` or another program wrote: ``.npz``, ``.json``, ``.swc``, ``.obj``,
    ``.ply``, ``.graphml`` or ``.polylines.txt``. It cannot read ``.vtp``, ``.csv``, ``.glb``.

    Returns:
        A skeleton. That of an ``.npz`` has all but the stages of the flow, so that it can be pruned, resampled and
        followed. That of a ``.json`` has all but the surface. Others have an empty map, and a report with counts only.
        SWC has radii, and of files of this program the units; edges that it cut are joined again. PLY and GraphML have
        radii if the file has. In OBJ and polylines radii are 0, and coincident ends of polylines become one node.

    Raises:
        ConfigError: the suffix is unknown, a line is not of the format (the message says which, and what was expected),
            or an ``.npz`` is damaged or of another kind.
        OSError: the file cannot be read.
    """
    name = Path(path).name
    if name.lower().endswith(".npz"):
        return Skeleton(**whole.read_npz(path))
    suffix = next((suffix for suffix in [".json", *READERS] if name.lower().endswith(suffix)), None)
    if suffix is None:
        raise ConfigError(f"cannot read {name!r}: expected one of {', '.join(['.npz', '.json', *READERS])}")
    content = _text_of(path)
    if suffix == ".json":
        return Skeleton(**whole.read_json(name, content))
    lines = decoding.lines_of(content)
    vertices, edges, radii = READERS[suffix](name, lines)
    try:
        pairs = np.unique(np.sort(np.array(edges, dtype=np.int64).reshape(-1, 2), axis=1), axis=0)
        pairs = pairs[pairs[:, 0] != pairs[:, 1]]
        curve = whole.checked_curve({"vertices": vertices, "edges": pairs, "radii": radii})
    except OverflowError:  # an id is too large for the array
        raise ConfigError(f"{name!r} has edges to nodes that it does not have: its ids have too many digits") from None
    except ValueError as error:
        raise ConfigError(f"{name!r} is no curve: {error}") from None
    units = text.comments(lines, text.UNITS) if suffix == ".swc" else []
    return replace(curve_of(curve["vertices"], curve["edges"], curve["radii"]), units=units[0] if units else "")


def report_lines(path: str | os.PathLike[str]) -> list[str]:
    """The lines of the report of the curve in a file that `Skeleton.save` wrote, safe to print: all of it from NPZ and
    JSON, from SWC what stands in the comments.

    Raises:
        ConfigError: files of this format have no report, this file has none, or its curve is damaged.
        OSError: the file cannot be read.
    """
    name, suffix = Path(path).name, Path(path).suffix.lower()
    if suffix not in (".npz", ".json", ".swc"):
        raise ConfigError(f"{name!r} has no report: expected an {export.HOLD_REPORT} file that msf_jax has written")
    lines = str(read_curve(path).report).splitlines()  # also of SWC: a report of a curve that is damaged says nothing
    if suffix == ".swc":
        lines = text.comments(decoding.lines_of(_text_of(path)), text.REPORT)
    if not lines:
        raise ConfigError(f"{name!r} has no report: expected a file that msf_jax wrote after a run")
    return [plain(line) for line in lines]


def _text_of(path: str | os.PathLike[str]) -> str:
    if Path(path).exists() and not Path(path).is_file():  # opening a pipe would block
        raise ConfigError(f"{Path(path).name!r} is no file: expected one of a curve")
    try:
        return decoding.decoded(Path(path).read_bytes())
    except ValueError as error:
        raise ConfigError(f"{Path(path).name!r} is no text: expected a file of a curve as text ({error})") from None
