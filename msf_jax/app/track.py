"""``msf-jax track``: a curve for each mesh of a folder, and a table of their checks."""

import csv
import io
import re
from pathlib import Path

from tqdm import tqdm

from msf_jax.base.errors import ConfigError, MeshError
from msf_jax.base.writing import made_folder, write_whole
from msf_jax.gradients.track import Track, Tracker
from msf_jax.meshes import reading
from msf_jax.skeleton.formats import writers
from msf_jax.skeleton.skeleton import Skeleton

TABLE = "frames.csv"  # file of the table, in the folder of the results
SHARES = ("inside", "crowded", "grown")  # columns of the table, attributes of a `TrackedFrame`


def frames_in(folder: str, output: str) -> list[Path]:
    """The meshes in ``folder``, frame2 before frame10; a `ConfigError` if there is none, two have one name, or
    ``output`` is that folder."""
    paths = reading.meshes_in(folder, output)
    if len({path.stem for path in paths}) < len(paths):
        raise ConfigError(f"two meshes in {folder!r} have one name and two suffixes: expected one for each frame")
    parts_of = {path: re.split(r"(\d+)", path.stem) for path in paths}  # text and numbers, alternating
    return sorted(paths, key=lambda path: [int(part) if part.isdigit() else part for part in parts_of[path]])


def run(
    skeleton: Skeleton, paths: list[Path], output: str, *, suffix: str, progress: bool
) -> tuple[Path, int, list[str]]:
    """Follow ``skeleton`` through the meshes at ``paths``, and write a curve with ``suffix`` for each to ``output``.
    Returns the table's path, how many frames have no curve, and a line about each frame that needs a fresh run. After
    the `MeshError` of a frame that cannot be read, or has other faces, those before it have their curves and rows."""
    folder, tracker, text = made_folder(output), Tracker(skeleton), io.StringIO()
    table = csv.writer(text)
    table.writerow(["frame", "mesh", "curve", "vanished", *SHARES, "wants_run"])
    num_lacking, doubts = 0, []
    try:
        for number, path in enumerate(tqdm(paths, desc="track", unit="frame", disable=None if progress else True)):
            try:
                mesh = reading.read(path)
                frame = tracker.frame(number, mesh)
            except MeshError as error:
                raise MeshError(f"{path.name!r}: {error}") from error
            has_curve, target = not len(frame.vanished), folder / f"{path.stem}{suffix}"
            if has_curve:
                write_whole(target, writers.writer_for(target)(Track(skeleton, (frame,)).curve(0), mesh))
            num_lacking += not has_curve
            if frame.wants_run:
                doubts.append(f"{path.name}: {frame}")
            shares = [f"{getattr(frame, name):.6g}" for name in SHARES]
            curve = target.name if has_curve else ""
            table.writerow([number, path.name, curve, len(frame.vanished), *shares, int(frame.wants_run)])
    finally:  # after a bad frame or an interruption, the table has the frames before it
        write_whole(folder / TABLE, text.getvalue())
    return folder / TABLE, num_lacking, doubts
