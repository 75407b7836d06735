"""The formats of files, with one writer for each.

A writer is imported on first use, because the command line's help only needs the suffixes.
"""

import importlib
import os
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from msf_jax.base.errors import ConfigError

if TYPE_CHECKING:
    from msf_jax.skeleton.skeleton import Skeleton

HOLD_REPORT = ".npz, .json or .swc"  # formats that contain the report
# The function of `writers`, or the table of `Skeleton.columns`, of each format. Longer suffixes stand before those with
# which they end.
WRITERS = {
    ".swc": "swc",
    ".obj": "obj",
    ".polylines.txt": "polylines",
    ".ply": "ply",
    ".vtp": "vtp",
    ".graphml": "graphml",
    ".nodes.csv": "nodes",
    ".axes.csv": "axes",
    ".cylinders.csv": "cylinders",
    ".csv": "branches",
    ".npz": "npz",
    ".json": "plain_json",
    ".glb": "",
}


def writer_for(path: str | os.PathLike[str]) -> "Callable[[Skeleton, Any], str | bytes]":
    """The function from a skeleton and its mesh to the content of a file, for the suffix of ``path``.

    Raises:
        ConfigError: no format has that suffix. The function raises one if the format has the mesh, and none is given.
    """
    name = Path(path).name
    suffix = next((each for each in WRITERS if name.lower().endswith(each)), None)
    if suffix is None:
        beams = "; skeleton.frame().save(...) in Python writes beams" if name.lower().endswith(".inp") else ""
        raise ConfigError(f"no format for {name!r}: expected one of the suffixes {', '.join(WRITERS)}{beams}")
    if suffix == ".glb":
        return importlib.import_module(f"{__package__}.gltf").skinned
    module = importlib.import_module(f"{__package__}.writers")
    is_table = suffix.endswith(".csv")
    write = partial(module.table, of=WRITERS[suffix]) if is_table else getattr(module, WRITERS[suffix])
    return lambda skeleton, mesh: write(skeleton)
