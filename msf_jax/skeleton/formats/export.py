"""Saving in the formats of other programs, with one writer for each format. Files are written atomically.

A writer is imported on first use, because the command line's help only needs the suffixes.
"""

import importlib
import os
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from msf_jax.base.errors import ConfigError
from msf_jax.base.writing import write_whole

if TYPE_CHECKING:
    from msf_jax.meshes.reading import MeshLike
    from msf_jax.skeleton.skeleton import Skeleton


def save(skeleton: "Skeleton", path: str | os.PathLike[str], mesh: "MeshLike | None" = None) -> None:
    """Write ``skeleton`` to ``path`` in the format of its suffix; see `Skeleton.save`."""
    write_whole(path, writer_for(path)(skeleton, mesh))


def writer_for(path: str | os.PathLike[str]) -> "Callable[[Skeleton, Any], str | bytes]":
    """The function from a skeleton and its mesh to the content of a file, for the suffix of ``path``.

    Raises:
        ConfigError: no format has that suffix.
    """
    name = Path(path).name.lower()
    for suffix, place in WRITERS.items():
        if name.endswith(suffix):
            module, _, function = place.partition(".")
            writer = getattr(importlib.import_module(f"{__package__}.{module}"), function)
            if suffix not in NEED_MESH:
                return lambda skeleton, mesh: writer(skeleton)
            return lambda skeleton, mesh: writer(skeleton, _needed(mesh, suffix))
    beams = "; skeleton.frame().save(...) in Python writes beams" if name.endswith(".inp") else ""
    raise ConfigError(f"no format for {Path(path).name!r}: expected one of the suffixes {', '.join(WRITERS)}{beams}")


def _needed(mesh: "MeshLike | None", suffix: str) -> Any:
    if mesh is None:
        raise ConfigError(f"a {suffix} file contains the mesh, too: expected save(path, mesh)")
    return mesh


HOLD_REPORT = ".npz, .json or .swc"  # formats that contain the report
NEED_MESH = (".glb",)  # formats whose writer takes the mesh, too
# Module and function of the writer of each format.
WRITERS = {
    ".swc": "swc.written",
    ".obj": "graphs.obj",
    ".cg": "graphs.cg",
    ".polylines.txt": "polylines.written",
    ".ply": "graphs.ply",
    ".vtp": "graphs.vtp",
    ".graphml": "graphs.graphml",
    ".gml": "graphs.gml",
    ".nodes.csv": "tables.node_rows",
    ".axes.csv": "tables.axis_rows",
    ".cylinders.csv": "tables.cylinder_rows",
    ".csv": "tables.branch_rows",
    ".npz": "whole.npz",
    ".json": "whole.plain_json",
    ".glb": "gltf.skinned",
}
