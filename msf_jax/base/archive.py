"""One ``.npz`` file of arrays and a header, read without trusting it.

It contains no code: NumPy reads plain numbers only, and the header is JSON. What an array claims to hold must be in the
file, so that memory is allocated for no more. The readers of an archive also check its values.
"""

import errno
import io
import json
import os
import zipfile
from collections.abc import Iterator, Mapping, MutableMapping
from contextlib import contextmanager
from typing import Any

import numpy as np

from msf_jax.base.errors import ConfigError

HEADER_ENTRY = "header"  # name of the entry with everything that is not an array
LARGEST = 4_000_000_000  # bytes: of all arrays of a file; a file that claims more is refused


def packed(kind: str, version: int, header: Mapping[str, Any], arrays: Mapping[str, np.ndarray]) -> bytes:
    """The bytes of a file of that ``kind`` with ``arrays`` and ``header``."""
    text = json.dumps({"format": f"msf_jax {kind}", "version": version, **header})
    buffer = io.BytesIO()
    named: dict[str, Any] = {HEADER_ENTRY: np.array(text), **arrays}
    np.savez_compressed(buffer, **named)
    return buffer.getvalue()


@contextmanager
def reading(path: str | os.PathLike[str], kind: str, version: int, advice: str) -> Iterator[tuple[Any, Any]]:
    """The header and a dictionary of the arrays of a file that `packed` made. Errors in this context count as damage.

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
                yield header, {entry: file[entry] for entry in file.files if entry != HEADER_ENTRY}
        except ConfigError:
            raise
        except Exception as error:  # for a damaged file, zip, zlib, json and NumPy raise exceptions of many types
            if isinstance(error, OSError) and error.errno != errno.EINVAL:  # EINVAL: a negative offset in the file
                raise
            raise ConfigError(
                f"{name} is no {kind}, or a damaged one ({type(error).__name__}: {error}): {advice}"
            ) from error


def encoded(value: Any, arrays: MutableMapping[str, Any], records: Mapping[str, Any], name: str = "") -> Any:
    """``value`` in JSON's types. Arrays in it are put into ``arrays``, named by their path in ``value``.

    ``value`` consists of plain values, lists, tuples, dictionaries, and the named tuples and dataclasses in
    ``records``, by their names: what makes each from its members.
    """

    def each(members: Mapping[str, Any]) -> dict[str, Any]:
        return {key: encoded(member, arrays, records, f"{name}/{key}") for key, member in members.items()}

    if isinstance(value, np.generic):
        return value.item()
    if hasattr(value, "__array__"):
        arrays[name[1:]] = np.asarray(value)
        return {"array": name[1:]}
    kind = type(value).__name__
    if kind in records:
        return {"record": kind, "members": each(value._asdict() if hasattr(value, "_asdict") else vars(value))}
    if isinstance(value, dict):
        return {"members": each(value)}
    if isinstance(value, list | tuple):
        return {kind: list(each({str(number): member for number, member in enumerate(value)}).values())}
    return value


def decoded(value: Any, arrays: Mapping[str, np.ndarray], records: Mapping[str, Any]) -> Any:
    """The inverse of `encoded`. It raises a KeyError, a TypeError or an AttributeError for input that `encoded` never
    returns."""
    if not isinstance(value, dict):
        return value
    if "array" in value:
        return arrays[value["array"]]
    for sequence in (list, tuple):
        if sequence.__name__ in value:
            return sequence(decoded(member, arrays, records) for member in value[sequence.__name__])
    members = {key: decoded(member, arrays, records) for key, member in value["members"].items()}
    return records[value["record"]](**members) if "record" in value else members
