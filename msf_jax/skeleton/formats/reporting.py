"""The report in a curve's file, to be printed again: all of it in NPZ and JSON, its lines in an SWC file's comments."""

import json
import os
from pathlib import Path

from msf_jax.base.errors import ConfigError
from msf_jax.skeleton.formats import export, swc, whole
from msf_jax.skeleton.report import Report


def lines_of(path: str | os.PathLike[str]) -> list[str]:
    """The lines of the report of the curve in a file that `Skeleton.save` wrote.

    Raises:
        ConfigError: the file's format holds no report, or this file does not.
        OSError: the file cannot be read.
    """
    name = Path(path).name
    suffix = Path(path).suffix.lower()
    if suffix == ".npz":
        return str(whole.read_npz(path)[1]).splitlines()
    if suffix not in (".json", ".swc"):
        raise ConfigError(f"{name!r} holds no report: expected an {export.HOLD_REPORT} file that msf_jax has written")
    text = Path(path).read_text(errors="replace")
    try:
        found = swc.report_lines(text) if suffix == ".swc" else str(Report.from_dict(json.loads(text)["report"]))
    except (ValueError, KeyError, TypeError) as error:
        raise ConfigError(f"{name!r} holds no report ({type(error).__name__}): expected one from msf_jax") from error
    if not found:
        raise ConfigError(f"{name!r} holds no report: expected one that msf_jax wrote, and after a run")
    return found if isinstance(found, list) else found.splitlines()
