"""Reading the report from a curve's file: all of it from NPZ and JSON, its lines from the comments of SWC."""

import json
import os
from pathlib import Path

from msf_jax.base.errors import ConfigError
from msf_jax.meshes.decoding import decoded
from msf_jax.skeleton.formats import export, swc, text, whole


def lines_of(path: str | os.PathLike[str]) -> list[str]:
    """The lines of the report of the curve in a file that `Skeleton.save` wrote.

    Raises:
        ConfigError: files of this format have no report, or this file has none.
        OSError: the file cannot be read.
    """
    name = Path(path).name
    suffix = Path(path).suffix.lower()
    if suffix not in (".npz", ".json", ".swc"):
        raise ConfigError(f"{name!r} has no report: expected an {export.HOLD_REPORT} file that msf_jax has written")
    if Path(path).exists() and not Path(path).is_file():  # opening a pipe would block
        raise ConfigError(f"{name!r} is no file: expected one that msf_jax has written")
    try:
        if suffix == ".npz":
            found = str(whole.read_npz(path)[1]).splitlines()
        else:
            content = decoded(Path(path).read_bytes())
            found = swc.report_lines(content) if suffix == ".swc" else _of_json(content)
    except (ValueError, KeyError, TypeError, RecursionError, MemoryError) as error:
        if isinstance(error, ConfigError):
            raise
        raise ConfigError(f"{name!r} has no report ({type(error).__name__}): expected a file of msf_jax") from error
    if not found:
        raise ConfigError(f"{name!r} has no report: expected a file that msf_jax wrote after a run")
    return [text.plain(line) for line in found]


def _of_json(content: str) -> list[str]:
    values = json.loads(content)
    if not isinstance(values, dict):
        raise TypeError("no skeleton")
    return str(whole.checked_report(values["report"])).splitlines()
