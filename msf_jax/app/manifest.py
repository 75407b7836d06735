"""The table of a batch: a row for each mesh whose curve, or whose error, is in the folder of the results.

Several batches can write to one folder at the same time. Each row is a file of its own, and the table is made of all of
them. It is written again if rows were added meanwhile, so whoever writes last has seen all rows.
"""

import csv
import io
import json
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from msf_jax.base.writing import write_whole

TableRow = dict[str, Any]
Stamps = dict[str, tuple[int, ...]]  # of each file of a row: they change when it is replaced


class Manifest:
    """The table in ``file`` of all rows in the folder ``rows``.

    Args:
        own: for the name of each row of this batch, the key that it has with the present settings, and its curve's
            file. With another key a row is out of date, and is left out.
    """

    def __init__(self, file: Path, rows: Path, own: Mapping[str, tuple[str, str]]) -> None:
        self.file, self._folder, self._own = file, rows, own
        self._known: dict[str, tuple[tuple[int, ...], TableRow | None]] = {}  # rows that were read, with their stamps

    def write(self) -> None:
        """Write the table of the rows that are there now."""
        self._write(self._stamps())

    def complete(self) -> None:
        """Write the table until no other batch has added a row meanwhile."""
        stamps = self._stamps()
        while True:
            self._write(stamps)
            now = self._stamps()
            if now == stamps:
                return
            stamps = now

    def _stamps(self) -> Stamps:
        with os.scandir(self._folder) as files:
            found = ((file.name, file.stat()) for file in files if file.name.endswith(".json"))
            return {name: (state.st_mtime_ns, state.st_ino, state.st_size) for name, state in found}

    def _write(self, stamps: Stamps) -> None:
        rows = [row for name, stamp in stamps.items() if (row := self._row(name, stamp)) and self._is_due(name, row)]
        write_whole(self.file, text_of(rows))

    def _row(self, name: str, stamp: tuple[int, ...]) -> TableRow | None:
        """The row in a file; None if it is damaged."""
        if name not in self._known or self._known[name][0] != stamp:
            try:
                row = json.loads((self._folder / name).read_text())
                row = row if {"path", "output", "error", "key"} <= set(row) else None
            except (OSError, ValueError, TypeError):
                row = None
            self._known[name] = stamp, row
        return self._known[name][1]

    def _is_due(self, name: str, row: TableRow) -> bool:
        """Whether a row is in the table: its curve is there, or else its error, and its mesh."""
        key, curve = self._own.get(name, (row["key"], row["output"]))
        if row["error"]:
            return row["key"] == key and (name in self._own or os.path.exists(row["path"]))
        return row["key"] == key and os.path.exists(curve)


def text_of(rows: list[TableRow]) -> str:
    """The rows as comma-separated text, sorted by path; lists are joined by semicolons."""
    ordered = sorted(rows, key=lambda row: row["path"])
    columns = list(dict.fromkeys(name for row in ordered for name in row if name not in ("key", "figures")))
    figures = list(dict.fromkeys(name for row in ordered for name in row.get("figures") or {}))
    buffer = io.StringIO()
    table = csv.writer(buffer, lineterminator="\n")
    table.writerow([*columns, *figures])
    for row in ordered:
        values = [row.get(name, "") for name in columns] + [
            (row.get("figures") or {}).get(name, "") for name in figures
        ]
        table.writerow(["; ".join(value) if isinstance(value, list) else value for value in values])
    return buffer.getvalue()
