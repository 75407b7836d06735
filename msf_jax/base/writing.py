"""Atomic writing of files: a file is written under another name, then renamed."""

import os
import secrets
import shutil
from pathlib import Path


def write_whole(path: str | os.PathLike[str], content: str | bytes) -> None:
    """Write ``content`` to a new file and rename that to ``path``. So ``path`` is never a partly written file.

    If ``path`` is a link, its target is replaced. The new file has the permissions of the old one. Text is UTF-8.
    Bytes of a name that are not, which Python keeps as halves of surrogate pairs, are written as they are.
    """
    target = Path(os.path.realpath(path))
    data = content.encode("utf-8", "surrogateescape") if isinstance(content, str) else content
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
