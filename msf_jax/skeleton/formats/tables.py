"""Tables of measurements, as columns and as comma-separated text: a row for each branch, node, axis or cylinder."""

import csv
import io
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from msf_jax.base.errors import ConfigError
from msf_jax.skeleton.centrelines import Columns, axis_columns, branch_columns, cylinder_columns, node_columns

if TYPE_CHECKING:
    from msf_jax.skeleton.skeleton import Skeleton

TABLES = {"branches": branch_columns, "nodes": node_columns, "axes": axis_columns, "cylinders": cylinder_columns}


def columns_of(skeleton: "Skeleton", of: str) -> Columns:
    """See `Skeleton.columns`."""
    if of not in TABLES:
        raise ConfigError(f"there is no table of {of!r}: expected one of {', '.join(map(repr, TABLES))}")
    return TABLES[of](skeleton)


def rows(of: str, skeleton: "Skeleton") -> str:
    """One of the `TABLES` as text; unknown values are empty."""
    columns = TABLES[of](skeleton)
    buffer = io.StringIO()
    table = csv.writer(buffer, lineterminator="\n")
    table.writerow(columns)
    for row in zip(*(values.tolist() for values in columns.values()), strict=True):
        table.writerow(["" if isinstance(value, float) and np.isnan(value) else value for value in row])
    return buffer.getvalue()


branch_rows, node_rows, axis_rows, cylinder_rows = (partial(rows, of) for of in TABLES)
