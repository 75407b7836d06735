"""A check, once in a process, that the installed XLA computes the sums of this package right.

One version of jaxlib does not, from 16,385 rows on: silently, and only in optimised programs. So before the first solve
or replay these sums are compiled as a user's programs are, and compared with NumPy. All values are small whole numbers,
whose sums are exact in any order: the results must be equal.
"""

import importlib.metadata
import threading
from collections.abc import Callable, Mapping
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

from msf_jax.base.errors import FlowError
from msf_jax.base.layout import Layout, Level
from msf_jax.device import cg
from msf_jax.device.buffers import real_dtype, slot_product, slot_sum

ROWS = 40_960  # float64 was wrong from 16,385 rows on, float32 from 32,769
# Two levels, so that sums over both are compared: four slots of all rows, two more of the first half.
LAYOUT = Layout(ROWS, (Level(4, ROWS, 0), Level(2, ROWS // 2, 4 * ROWS)))
# (weights (S,), neighbour (S,), x (n, 3)) -> the sum that the name describes
SUMS: dict[str, Callable[..., jax.Array]] = {
    "products over the slots of a row": lambda weights, neighbour, x: slot_product(LAYOUT, weights, neighbour, x),
    "values over the slots of a row": lambda weights, neighbour, x: slot_sum(LAYOUT, weights),
    "products over all rows": lambda weights, neighbour, x: cg.dot(x, x),
    "squares of a row times a matrix": lambda weights, neighbour, x: jax.vmap(
        lambda row: ((jnp.eye(3, dtype=x.dtype) @ row) ** 2).sum()
    )(x),
}

_right: set[str] = set()  # names of the types whose sums were right
_lock = threading.Lock()


def check() -> None:
    """Compare the sums in the types that programs use now; only the first call in a process takes time.

    Raises:
        FlowError: a sum is wrong.
    """
    with _lock:
        for dtype in sorted({"float32", str(real_dtype())} - _right):
            check_sums(dtype)
            _right.add(dtype)


def check_sums(
    dtype: str, sums: Mapping[str, Callable[..., jax.Array]] = SUMS, options: dict[str, str | bool] | None = None
) -> None:
    """Compare ``sums``, compiled for ``dtype`` with ``options`` of XLA, with NumPy. Raises FlowError."""
    given = _values(np.dtype(dtype))
    with jax.enable_x64(dtype == "float64"):
        program = jax.jit(lambda *given: {name: total(*given) for name, total in sums.items()})
        found = jax.device_get(program.lower(*given).compile(compiler_options=options)(*given))
    expected = _expected(*given)
    wrong = [name for name in sums if not np.array_equal(found[name], expected[name])]
    if wrong:
        versions = " and ".join(f"{name} {importlib.metadata.version(name)}" for name in ("jax", "jaxlib"))
        raise FlowError(
            f"{versions}: its compiler adds wrongly on {jax.default_backend()} ({dtype}, {ROWS:,} rows: sums of "
            f"{', and of '.join(wrong)} differ from NumPy's), so curves may be wrong: install another version, for "
            "example with pip install -U jax"
        )


def _values(dtype: np.dtype[Any]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    slots = np.arange(LAYOUT.num_slots)
    x = np.arange(3 * ROWS).reshape(ROWS, 3) % 7 - 3
    return (slots % 5 - 2).astype(dtype), (slots * 7919 % ROWS).astype(np.int32), x.astype(dtype)


def _expected(weights: np.ndarray, neighbour: np.ndarray, x: np.ndarray) -> dict[str, Any]:
    products, values = np.zeros_like(x), np.zeros_like(x[:, 0])
    for level in LAYOUT.levels:
        for first in range(level.offset, level.end, level.rows):
            slot = slice(first, first + level.rows)
            products[: level.rows] += weights[slot, None] * x[neighbour[slot]]
            values[: level.rows] += weights[slot]
    squares = x**2
    return dict(zip(SUMS, (products, values, squares.sum(), squares.sum(1)), strict=True))
