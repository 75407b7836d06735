"""Tables as comma-separated text: ``.csv`` has a row for each branch, ``.nodes.csv`` for each node."""

import csv
import io
from typing import TYPE_CHECKING

import numpy as np

from msf_jax.skeleton.centrelines.table import Columns, branch_columns, node_columns

if TYPE_CHECKING:
    from msf_jax.skeleton.skeleton import Skeleton


def branch_rows(skeleton: "Skeleton") -> str:
    """The table of branches; unknown values are empty."""
    return _text(branch_columns(skeleton))


def node_rows(skeleton: "Skeleton") -> str:
    """The table of nodes; unknown values are empty."""
    return _text(node_columns(skeleton))


def _text(columns: Columns) -> str:
    buffer = io.StringIO()
    table = csv.writer(buffer, lineterminator="\n")
    table.writerow(columns)
    for row in zip(*(values.tolist() for values in columns.values()), strict=True):
        table.writerow(["" if isinstance(value, float) and np.isnan(value) else value for value in row])
    return buffer.getvalue()
