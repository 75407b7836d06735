"""Reading of curves from files, of this program and of others."""

import os
from dataclasses import replace
from pathlib import Path

import numpy as np

from msf_jax.base.errors import ConfigError
from msf_jax.meshes.decoding import decoded, lines_of
from msf_jax.skeleton.bare import curve_of
from msf_jax.skeleton.formats import parsing, polylines, swc, whole
from msf_jax.skeleton.skeleton import Skeleton


def read_curve(path: str | os.PathLike[str]) -> Skeleton:
    """The curve in a file that `Skeleton.save` or another program wrote: ``.npz``, ``.json``, ``.swc``, ``.obj``,
    ``.cg``, ``.ply``, ``.graphml`` or ``.polylines.txt``. It cannot read ``.gml``, ``.vtp``, ``.csv``, ``.glb``.

    Returns:
        A skeleton. That of an ``.npz`` has all but the stages of the flow, so that it can be pruned, resampled and
        followed. That of a ``.json`` has all but the surface. Others have an empty map, and a report with counts only.
        SWC has radii, and of files of this program the units; edges that it cut are joined again. PLY and GraphML have
        radii if the file has. In OBJ, CG and polylines radii are 0, and coincident ends of polylines become one node.

    Raises:
        ConfigError: the suffix is unknown, a line is not of the format (the message says which, and what was expected),
            or an ``.npz`` is damaged or of another kind.
        OSError: the file cannot be read.
    """
    name = Path(path).name
    if name.lower().endswith(".npz"):
        arrays, report, source = whole.read_npz(path)
        return Skeleton(**arrays, report=report, source=source)
    if Path(path).exists() and not Path(path).is_file():  # opening a pipe would block
        raise ConfigError(f"{name!r} is no file: expected an .swc, .polylines.txt or .npz file")
    content = Path(path).read_bytes()
    suffix = next((suffix for suffix in [".json", *READERS] if name.lower().endswith(suffix)), None)
    if suffix is None:
        raise ConfigError(f"cannot read {name!r}: expected one of {', '.join(['.npz', '.json', *READERS])}")
    try:
        text = decoded(content)
    except ValueError as error:
        raise ConfigError(f"{name!r} is no text: expected a {suffix} file as text ({error})") from None
    if suffix == ".json":
        arrays, report = whole.read_json(name, text)
        return Skeleton(**arrays, report=report)
    lines = lines_of(text)
    vertices, edges, radii = READERS[suffix](name, lines)
    try:
        pairs = np.unique(np.sort(np.array(edges, dtype=np.int64).reshape(-1, 2), axis=1), axis=0)
        pairs = pairs[pairs[:, 0] != pairs[:, 1]]
        checked = whole.checked_curve({"vertices": vertices, "edges": pairs, "radii": radii})
    except OverflowError:  # an id is too large for the array
        raise ConfigError(f"{name!r} has edges to nodes that it does not have: its ids have too many digits") from None
    except ValueError as error:
        raise ConfigError(f"{name!r} is no curve: {error}") from None
    found = curve_of(checked["vertices"], checked["edges"], checked["radii"])
    return replace(found, units=swc.units_of(lines)) if suffix == ".swc" else found


READERS = {
    ".swc": swc.parsed,
    ".polylines.txt": polylines.parsed,
    ".obj": parsing.obj,
    ".cg": parsing.cg,
    ".ply": parsing.ply,
    ".graphml": parsing.graphml,
}
