"""Limits of what is read: a small file can unpack to more than memory, or show the same triangles many times."""

import zipfile
from pathlib import Path

# Limits of the unpacked bytes: ratio to the packed bytes; bytes always allowed; the largest. XML takes ten times its
# bytes as a tree.
LARGEST_RATIO, SMALL_ARCHIVE, LARGEST_UNPACKED = 50, 10_000_000, 80_000_000
# Of the parts, at most: triangles of all instances, and instances. Two million triangles with normals, colours and
# texture coordinates take up to 0.8 GB.
MOST_TRIANGLES, MOST_INSTANCES = 2_000_000, 20_000
MOST_TIMES = 2  # times that the triangles of a file may be shown, if they are over MOST_TRIANGLES


def check_archive(path: Path) -> None:
    """Raise a ValueError if an archive would need too much memory, or has parts that trimesh mistakes for others."""
    with zipfile.ZipFile(path) as archive:
        members = archive.infolist()
    unpacked, packed = sum(member.file_size for member in members), path.stat().st_size
    most = min(max(LARGEST_RATIO * packed, SMALL_ARCHIVE), LARGEST_UNPACKED)
    if unpacked > most:
        raise ValueError(f"it unpacks to {unpacked} bytes: expected at most {most}")
    models = [member.filename for member in members if member.filename.lower().endswith(".model")]
    if len(models) > 1:  # their objects have the same ids
        raise ValueError(f"it has {len(models)} models, of which one is supported: export it as one")


def check_shown(instances: int, triangles: int, own: int) -> None:
    """Raise a ValueError if a file with ``own`` triangles shows too many."""
    if instances > MOST_INSTANCES or triangles > max(MOST_TRIANGLES, MOST_TIMES * own):
        raise ValueError(f"its parts have {instances} instances and {triangles} triangles, which is too many")
