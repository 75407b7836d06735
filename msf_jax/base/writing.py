"""Files are written beside their target and renamed: the old one or the new one, never half."""

import os
import secrets
import shutil
from pathlib import Path


def write_whole(path: str | os.PathLike[str], content: str | bytes) -> None:
    """Write a file beside ``path`` and rename it, so that ``path`` is the old file or the new one, never half.

    A link is followed, and a file that is replaced keeps its permissions.
    """
    target = Path(os.path.realpath(path))
    data = content.encode() if isinstance(content, str) else content
    beside = target.with_name(f".msf_jax-{secrets.token_hex(8)}.tmp")
    try:
        with open(beside, "xb") as file:
            file.write(data)
        if target.exists():
            shutil.copymode(target, beside)
        os.replace(beside, target)
    except BaseException as error:
        beside.unlink(missing_ok=True)
        if isinstance(error, OSError):
            raise type(error)(error.errno, error.strerror, str(path)) from error
        raise
