"""Reading the report from a curve's file: all of it from NPZ and JSON, its lines from the comments of SWC."""

import os
from pathlib import Path

from msf_jax.base.errors import ConfigError
from msf_jax.meshes.decoding import decoded
from msf_jax.skeleton.formats import export, importing, swc, text


def lines_of(path: str | os.PathLike[str]) -> list[str]:
    """The lines of the report of the curve in a file that `Skeleton.save` wrote.

    Raises:
        ConfigError: files of this format have no report, this file has none, or its curve is damaged.
        OSError: the file cannot be read.
    """
    name = Path(path).name
    suffix = Path(path).suffix.lower()
    if suffix not in (".npz", ".json", ".swc"):
        raise ConfigError(f"{name!r} has no report: expected an {export.HOLD_REPORT} file that msf_jax has written")
    report = importing.read_curve(path).report  # a report of a curve that is damaged says nothing
    found = swc.report_lines(decoded(Path(path).read_bytes())) if suffix == ".swc" else str(report).splitlines()
    if not found:
        raise ConfigError(f"{name!r} has no report: expected a file that msf_jax wrote after a run")
    return [text.plain(line) for line in found]
