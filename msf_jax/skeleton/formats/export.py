"""Saving in the formats of other programs, with one writer for each format. Files are written atomically.

A writer is imported on first use, because the command line's help only needs the suffixes.
"""

import csv
import importlib
import io
import os
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from msf_jax.base.errors import ConfigError

if TYPE_CHECKING:
    from msf_jax.skeleton.skeleton import Skeleton

HOLD_REPORT = ".npz, .json or .swc"  # formats that contain the report
NEED_MESH = (".glb",)  # formats whose writer takes the mesh, too
# Module and function of the writer of each format, or the table that it has. Longer suffixes stand before those with
# which they end.
WRITERS = {
    ".swc": "text.swc",
    ".obj": "text.obj",
    ".polylines.txt": "text.polylines",
    ".ply": "text.ply",
    ".vtp": "vtk.vtp",
    ".graphml": "text.graphml",
    ".nodes.csv": "nodes",
    ".axes.csv": "axes",
    ".cylinders.csv": "cylinders",
    ".csv": "branches",
    ".npz": "whole.npz",
    ".json": "whole.plain_json",
    ".glb": "gltf.skinned",
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
    module, _, function = WRITERS[suffix].partition(".")
    if not function:
        return lambda skeleton, mesh: rows(skeleton, module)
    writer = getattr(importlib.import_module(f"{__package__}.{module}"), function)
    if suffix not in NEED_MESH:
        return lambda skeleton, mesh: writer(skeleton)

    def with_mesh(skeleton: "Skeleton", mesh: Any) -> str | bytes:
        if mesh is None:
            raise ConfigError(f"a {suffix} file contains the mesh, too: expected save(path, mesh)")
        return writer(skeleton, mesh)

    return with_mesh


def rows(skeleton: "Skeleton", of: str) -> str:
    """One of the tables of `Skeleton.columns` as comma-separated text; unknown values are empty."""
    columns = skeleton.columns(of)
    buffer = io.StringIO()
    table = csv.writer(buffer, lineterminator="\n")
    table.writerow(columns)
    for row in zip(*(values.tolist() for values in columns.values()), strict=True):
        table.writerow(["" if value != value else value for value in row])  # NaN is not itself
    return buffer.getvalue()
