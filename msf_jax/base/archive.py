"""One ``.npz`` file of arrays, read without trusting it.

It contains no code: NumPy reads plain numbers only, and the header, with its kind and version, is JSON.
"""

import errno
import io
import json
import os
import zipfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager

import numpy as np

from msf_jax.base.errors import ConfigError

HEADER_ENTRY = "header"  # name of the entry that says which kind of file it is
LARGEST = 4_000_000_000  # bytes: of all arrays of a file; a file that claims more is refused


def packed(kind: str, version: int, arrays: Mapping[str, np.ndarray]) -> bytes:
    """The bytes of a file of that ``kind`` with ``arrays``."""
    header = np.array(json.dumps({"format": f"msf_jax {kind}", "version": version}))
    buffer = io.BytesIO()
    np.savez_compressed(buffer, **{HEADER_ENTRY: header, **arrays})  # pyright: ignore[reportArgumentType]
    return buffer.getvalue()


@contextmanager
def reading(path: str | os.PathLike[str], kind: str, version: int, advice: str) -> Iterator[dict[str, np.ndarray]]:
    """The arrays by name of a file that `packed` made. Errors in this context count as damage.

    Raises:
        ConfigError: the file is no ``kind``, is damaged, or was written by another version. It ends with ``advice``.
        OSError: the file cannot be read.
    """
    name = f"{str(path)!r}"
    if os.path.exists(path) and not os.path.isfile(path):  # opening a pipe would block
        raise ConfigError(f"{name} is no file, and no {kind}: {advice}")
    with open(path, "rb") as stream:
        try:
            with zipfile.ZipFile(stream) as entries:
                total = sum(entry.file_size for entry in entries.infolist())
            if total > LARGEST:
                raise ValueError(f"it unpacks to {total} bytes: expected at most {LARGEST}")
            stream.seek(0)
            with np.load(stream, allow_pickle=False) as file:
                header = json.loads(str(file[HEADER_ENTRY]))
                if header["format"] != f"msf_jax {kind}" or header["version"] != version:
                    raise ValueError(f"it is {header['format']!r} of version {header['version']!r}, not {version}")
                yield {entry: file[entry] for entry in file.files if entry != HEADER_ENTRY}
        except ConfigError:
            raise
        except Exception as error:  # for a damaged file, zip, zlib, json and NumPy raise exceptions of many types
            if isinstance(error, OSError) and error.errno != errno.EINVAL:  # EINVAL: a negative offset in the file
                raise
            raise ConfigError(
                f"{name} is no {kind}, or a damaged one ({type(error).__name__}: {error}): {advice}"
            ) from error
