"""One ``.npz`` file of arrays and a header, written atomically, and read without trusting it.

It contains no code: NumPy reads plain numbers only, and the header is JSON. Sizes are checked before memory is
allocated. A digest of the content shows damage. It is no signature, because whoever can change the file can change the
digest; so the readers of an archive also check its values.
"""

import errno
import hashlib
import io
import json
import os
import zipfile
from collections.abc import Iterator, Mapping, MutableMapping
from contextlib import contextmanager
from typing import Any

import numpy as np

from msf_jax.base.errors import ConfigError
from msf_jax.base.writing import write_whole

HEADER_ENTRY = "header"  # name of the entry with everything that is not an array
DIGEST = "digest"  # name of the entry with the digest of all other entries
LONGEST_HEADER = 64_000_000  # bytes: a longer header is refused
LARGEST_RATIO = 100  # unpacked bytes over bytes of the file. Curves have 2 to 10; beyond it a file is refused as a bomb
SMALL_ARCHIVE = 10_000_000  # bytes: what unpacks to no more is read whatever its ratio


def write(
    path: str | os.PathLike[str],
    kind: str,
    version: int,
    header: Mapping[str, Any],
    arrays: Mapping[str, np.ndarray],
    *,
    compress: bool,
) -> None:
    """Write ``arrays`` and ``header`` as a file of that ``kind`` to ``path``, atomically.

    Raises:
        OSError: the file cannot be written; what was there before is untouched.
    """
    write_whole(path, packed(kind, version, header, arrays, compress=compress))


def packed(
    kind: str, version: int, header: Mapping[str, Any], arrays: Mapping[str, np.ndarray], *, compress: bool
) -> bytes:
    """The bytes that `write` writes."""
    text = json.dumps({"format": f"msf_jax {kind}", "version": version, **header})
    named: dict[str, Any] = {HEADER_ENTRY: np.array(text), **arrays}
    buffer = io.BytesIO()
    named[DIGEST] = _digest(named)
    (np.savez_compressed if compress else np.savez)(buffer, **named)
    if compress and sum(np.asarray(array).nbytes for array in named.values()) > LARGEST_RATIO * buffer.tell() / 2:
        return packed(kind, version, header, arrays, compress=False)  # it would be refused as a bomb
    return buffer.getvalue()


def _digest(arrays: Mapping[str, np.ndarray]) -> np.ndarray:
    """(32,) uint8 of names, types, shapes and values."""
    total = hashlib.sha256()
    for name in sorted(arrays):
        array = np.asarray(arrays[name])
        total.update(repr((name, array.dtype.str, array.shape)).encode())
        total.update(np.ascontiguousarray(array).tobytes())
    return np.frombuffer(total.digest(), dtype=np.uint8)


@contextmanager
def reading(
    path: str | os.PathLike[str], kind: str, version: int, advice: str, *, version_without_digest: int | None = None
) -> Iterator[tuple[Any, Any]]:
    """The header and a dictionary of the arrays of a file that `write` made. Errors in this context count as damage.

    Files of version ``version_without_digest`` are read as well, although they have no digest.

    Raises:
        ConfigError: the file is no ``kind``, is damaged, or was written by another version. It ends with ``advice``.
        OSError: the file cannot be read.
    """
    name = f"{str(path)!r}"
    if os.path.exists(path) and not os.path.isfile(path):  # opening a pipe would block
        raise ConfigError(f"{name} is no file, and no {kind}: {advice}")
    with open(path, "rb") as stream:
        if not zipfile.is_zipfile(stream):
            raise ConfigError(f"{name} is no {kind}, or a truncated one: {advice}")
        stream.seek(0)
        try:
            _check_sizes(stream)
            with np.load(stream, allow_pickle=False) as file:
                header = json.loads(str(file[HEADER_ENTRY])) if HEADER_ENTRY in file else None
                if not isinstance(header, dict) or header.get("format") != f"msf_jax {kind}":
                    raise ConfigError(f"{name} is no {kind}: {advice}")
                if header["version"] not in (version, version_without_digest):
                    raise ConfigError(
                        f"{name} is a {kind} of version {header['version']!r}: this program reads {version}; {advice}"
                    )
                arrays = {entry: file[entry] for entry in file.files}
            digest = arrays.pop(DIGEST, None)
            if header["version"] == version and not np.array_equal(digest, _digest(arrays)):
                raise ValueError("the file was changed: its digest does not fit its content")
            yield header, {entry: array for entry, array in arrays.items() if entry != HEADER_ENTRY}
        except ConfigError:
            raise
        except Exception as error:  # for a damaged file, zip, zlib, json and NumPy raise exceptions of many types
            if isinstance(error, OSError) and error.errno != errno.EINVAL:  # EINVAL: a negative offset in the file
                raise
            raise ConfigError(
                f"{name} is no {kind}, or a damaged one ({type(error).__name__}: {error}): {advice}"
            ) from error


def _check_sizes(stream: Any) -> None:
    """Raise a ValueError if the sizes of the entries are inconsistent, or too large for the file."""
    size = stream.seek(0, os.SEEK_END)
    with zipfile.ZipFile(stream) as archive:
        entries = archive.infolist()
        total = sum(entry.file_size for entry in entries)
        if total > max(LARGEST_RATIO * size, SMALL_ARCHIVE):
            raise ValueError(f"its {size} bytes unpack to {total}: expected at most {LARGEST_RATIO} times as many")
        for entry in entries:
            with archive.open(entry) as member:
                major, _ = np.lib.format.read_magic(member)
                read = np.lib.format.read_array_header_1_0 if major == 1 else np.lib.format.read_array_header_2_0
                shape, _, dtype = read(member)
                needed = int(np.prod([int(count) for count in shape], dtype=object)) * dtype.itemsize
                most = LONGEST_HEADER if entry.filename == f"{HEADER_ENTRY}.npy" else entry.file_size
                if not 0 <= needed <= min(most, entry.file_size):
                    raise ValueError(
                        f"entry {entry.filename!r} claims {needed} bytes: expected {min(most, entry.file_size)} at most"
                    )
    stream.seek(0)


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
