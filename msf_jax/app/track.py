"""``msf-jax track``: a curve for each mesh of a folder, and a table of their checks."""

import csv
import io
import re
from pathlib import Path

from msf_jax.base.errors import ConfigError, MeshError
from msf_jax.base.progress import shown
from msf_jax.base.writing import made_folder, write_whole
from msf_jax.gradients.track import FAULTS, Tracker, curve_of
from msf_jax.meshes import reading
from msf_jax.skeleton.formats import export
from msf_jax.skeleton.skeleton import Skeleton

TABLE = "frames.csv"  # file of the table, in the folder of the results


def frames_in(folder: str, output: str) -> list[Path]:
    """The meshes in ``folder``, frame2 before frame10.

    Raises:
        ConfigError: the folder has no mesh or two of one name, or ``output`` is that folder.
    """
    paths = reading.meshes_in(folder, output)
    stems = [path.stem for path in paths]
    twice = sorted({stem for stem in stems if stems.count(stem) > 1})
    if twice:
        raise ConfigError(f"two meshes in {folder!r} have the name {twice[0]!r}: expected one for each frame")
    return sorted(paths, key=lambda path: [int(part) if part.isdigit() else part for part in _parts(path.stem)])


def _parts(name: str) -> list[str]:
    """``name`` split into text and numbers, alternating."""
    return re.split(r"(\d+)", name)


def run(
    skeleton: Skeleton, paths: list[Path], output: str, *, suffix: str, progress: bool
) -> tuple[Path, list[str], list[str]]:
    """Follow ``skeleton`` through the meshes at ``paths``, and write a curve with ``suffix`` for each to ``output``.

    Returns:
        The table's path, lines about frames without a curve, and lines about frames that need a fresh run.

    Raises:
        MeshError: a frame cannot be read, or has other faces. The frames before it have their curves and rows.
    """
    folder = made_folder(output)
    tracker = Tracker(skeleton)
    lacking, doubtful, text = [], [], io.StringIO()
    table = csv.writer(text)
    table.writerow(["frame", "mesh", "curve", "inside", *FAULTS, "wants_run"])
    try:
        for number, path in enumerate(shown(paths, "track", "frames", progress)):
            try:
                mesh = reading.read(path, finite=not skeleton.report.repairs)
                frame = tracker.frame(number, mesh)
            except MeshError as error:
                named = "" if path.name in str(error) else f"{path.name!r}, "
                raise MeshError(f"{named}{error}") from error
            target = folder / f"{path.stem}{suffix}"
            if len(frame.vanished):
                lacking.append(f"{path.name}: {frame}")
            else:
                write_whole(target, export.writer_for(target)(curve_of(skeleton, frame), mesh))
                if frame.wants_run:
                    doubtful.append(f"{path.name}: {frame}")
            curve = "" if len(frame.vanished) else target.name
            faults = [f"{frame.faults.get(name, 0):.6g}" for name in FAULTS]
            table.writerow([number, path.name, curve, f"{frame.inside:.6g}", *faults, int(frame.wants_run)])
    finally:  # after a bad frame or an interruption, the table has the frames before it
        write_whole(folder / TABLE, text.getvalue())
    return folder / TABLE, lacking, doubtful
