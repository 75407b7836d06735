"""Whole files, written under another name and then renamed; folders, there or made; words that are printed."""

import os
import secrets
import shutil
from pathlib import Path

from msf_jax.base.errors import ConfigError


def made_folder(path: str | os.PathLike[str]) -> Path:
    """The folder ``path``. It is made, and those above it, where they are missing.

    Raises:
        ConfigError: a file, or a link to nothing, has this name or that of a folder above it.
        OSError: it cannot be made.
    """
    folder = Path(path)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except (FileExistsError, NotADirectoryError):
        taken = next(each for each in (folder, *folder.parents) if os.path.lexists(each) and not each.is_dir())
        raise ConfigError(f"{str(taken)!r} is no folder: expected one, or a name that is free") from None
    return folder


def write_whole(path: str | os.PathLike[str], content: str | bytes) -> None:
    """Write ``content`` to a new file and rename that to ``path``, which is never a partly written file. If ``path`` is
    a link, its target is replaced. The new file has the permissions of the old one. Text is UTF-8, but for bytes of
    names, which Python keeps as halves of surrogate pairs."""
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


def plain(line: str) -> str:
    """``line``, safe to print on a terminal: characters that are not printable are escaped."""
    return "".join(one if one.isprintable() else one.encode("unicode_escape").decode() for one in line)


def counted(count: int, noun: str) -> str:
    """ "1 hole", "2 holes"."""
    return f"{count} {noun}{'' if count == 1 else 's'}"
