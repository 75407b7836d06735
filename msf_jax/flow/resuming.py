"""Checks of a checkpoint's states: types, shapes, ranges, and whether this run can have produced them.

The file's digest only shows that the file is complete. These checks show that its content can be of this run: t_c and
the factor on w_L follow from the number of iterations, edits refer to existing rows, and a surface has the same arrays
as at the start.
"""

from typing import Any

import numpy as np

from msf_jax.base.options import Config
from msf_jax.flow.state import Iteration, State
from msf_jax.meso import fixing, ring_tables
from msf_jax.meso.collapse import CollapseRound
from msf_jax.meso.meso import Compaction, Fixing, Meso
from msf_jax.meso.split import SplitRound
from msf_jax.recording.records import Step

LARGEST_COORDINATE = 1.0  # diagonals: the largest coordinate that a run accepts, see `stepping.BLOW_UP`
LARGEST_FACTOR = 2.0**100  # on w_L, without unit, see `stepping.LARGEST_FACTOR`
PER_ROW = ("trust", "classes", "scale", "weights")  # optional arrays of a surface


def check_states(states: Any, changing: tuple[str, ...]) -> None:
    """Raise a ValueError unless a run can have saved ``states``: valid dictionaries with the names ``changing``."""
    for state in states:
        if set(state) != set(changing):
            raise ValueError("a state lacks a part, or has one too many")
        meso, history, steps = state["meso"], state["history"], state["steps"]
        kinds = ((history, Iteration), (steps, Step))
        if not isinstance(meso, Meso) or any(not isinstance(item, kind) for items, kind in kinds for item in items):
            raise ValueError("a part of a state is of another kind")
        _check_surface(meso)
        numbers = [state["t_c"], state["w_L_factor"], *(value for line in history for value in line)]
        if not all(isinstance(value, int | float) and np.isfinite(value) for value in numbers):
            raise ValueError("a number of a state is not finite")
        is_whole = isinstance(state["failure"], str) and type(state["capacity"]) is int and state["capacity"] >= 0
        if not is_whole or len(history) != len(steps) or not 0 < state["t_c"] < 1 or meso.edits:
            raise ValueError("the parts of a state do not fit together")
        lengths = [*(len(step.order) for step in steps), len(meso.positions)]
        for step, following in zip(steps, lengths[1:], strict=True):
            if _check_step(step) != following:
                raise ValueError("a step does not lead to the next one")


def check_goes_on(state: State, saved: dict[str, Any], config: Config) -> None:
    """Raise a ValueError unless a run with ``config`` can lead from ``state``, its first state, to ``saved``."""
    first, meso, num = state.meso, saved["meso"], len(saved["history"])
    factor = state.w_L_factor
    for _ in range(num):
        factor = min(factor * config.flow.w_L_growth, LARGEST_FACTOR)
    expected = fixing.threshold(num, *config.flow.thresholds) if num else state.t_c
    if saved["t_c"] != expected or saved["w_L_factor"] != factor or num > config.max_iterations:
        raise ValueError("its threshold, or its factor, is not that of its iterations")
    if any(line.component != state.number or line.iteration != row + 1 for row, line in enumerate(saved["history"])):
        raise ValueError("its history is of another component")
    if len(meso.node_of_input) != len(first.node_of_input):
        raise ValueError("its surface is of another component")
    if any((getattr(meso, name) is None) != (getattr(first, name) is None) for name in PER_ROW):
        raise ValueError("its surface has other arrays than the run's")
    if not meso.is_fixed[meso.node_of_input[state.pins]].all():
        raise ValueError("a pin is not held")
    euler = ring_tables.euler_characteristic(first.rings)
    if ring_tables.euler_characteristic(meso.rings) != euler or saved["capacity"] > 8 * max(state.max_rows, 4096):
        raise ValueError("its surface is of another genus, or its buffers are of another size")
    if saved["steps"] and len(saved["steps"][0].order) != len(first.positions):
        raise ValueError("its first step is of another surface")


def _check_surface(meso: Meso) -> None:
    num = len(meso.positions)
    kinds = {"positions": "f", "poles": "f", "rings": "i", "degree": "i", "node_of_input": "i", "classes": "iu"}
    kinds |= {"has_pole": "b", "is_fixed": "b", "trust": "f", "scale": "f", "weights": "f"}
    present = {name: getattr(meso, name) for name in kinds if getattr(meso, name) is not None}
    is_whole = all(isinstance(array, np.ndarray) and array.dtype.kind in kinds[name] for name, array in present.items())
    if not is_whole or any(len(array) != num for name, array in present.items() if name != "node_of_input"):
        raise ValueError("the arrays of a surface are of another kind")
    is_whole = meso.positions.shape == meso.poles.shape == (num, 3) and num > 0
    is_whole &= meso.rings.ndim == 2 and (meso.classes is None or meso.classes.shape == meso.rings.shape)
    is_whole &= all(getattr(meso, name).ndim == 1 for name in ("degree", "has_pole", "is_fixed", "node_of_input"))
    is_whole &= meso.weights is None or meso.weights.shape == (num, 4)
    is_whole &= bool((meso.node_of_input >= 0).all() and (meso.node_of_input < num).all())
    is_whole &= bool((meso.rings >= -1).all() and (meso.rings < num).all())
    for name in ("positions", "poles", "trust", "scale", "weights"):
        is_whole &= name not in present or bool(np.isfinite(present[name]).all())
    is_whole &= bool((np.abs(meso.positions) <= LARGEST_COORDINATE).all())
    for name in ("trust", "scale"):
        is_whole &= name not in present or bool(((present[name] >= 0) & (present[name] <= 1)).all())
    is_whole = is_whole and np.array_equal(meso.degree, ring_tables.ring_degrees(meso.rings))
    if not is_whole:
        raise ValueError("the arrays of a surface do not fit together")
    ring_tables.check_closed_manifold(meso.rings, ring_tables.euler_characteristic(meso.rings))


def _check_step(step: Step) -> int:
    """The number of rows of the surface after ``step``; a ValueError if the step is invalid."""
    num, kinds = len(step.order), ("i", "f", "iu", "iu", "f", "f", "f")
    arrays = (step.order, step.positions, step.rings, step.degree, step.free, step.pull, step.left)
    for array, kind in zip(arrays, kinds, strict=True):
        if not isinstance(array, np.ndarray) or array.dtype.kind not in kind:
            raise ValueError("the arrays of a step are of another kind")
    shapes = [array.shape for array in arrays]
    width = step.rings.shape[1:]
    if shapes != [(num,), (num, 3), (num, *width), (num,), (num,), (num,), (2, num, 3)] or len(width) != 1:
        raise ValueError("the arrays of a step do not fit together")
    used = step.rings[np.arange(width[0]) < step.degree[:, None]]
    is_whole = np.array_equal(np.sort(step.order), np.arange(num)) and bool(((used >= 0) & (used < num)).all())
    is_whole &= bool((step.degree >= 0).all() and (step.degree <= width[0]).all())
    is_whole &= all(bool(np.isfinite(array).all()) for array in (step.positions, step.free, step.pull, step.left))
    if not (is_whole and isinstance(step.factor, int | float) and 0 < step.factor < np.inf):
        raise ValueError("the values of a step are out of range")
    for edit in step.edits:
        num = _rows_after(edit, num)
    return num


def _rows_after(edit: Any, num: int) -> int:
    """The number of rows after one edit of a surface with ``num`` rows; a ValueError if the edit is invalid."""
    rows: dict[type, tuple[str, ...]] = {
        CollapseRound: ("survivor", "removed"),
        SplitRound: ("a", "b", "apex"),
        Fixing: ("vertex",),
        Compaction: ("live",),
    }
    if type(edit) not in rows:
        raise ValueError("an edit is of no known kind")
    named = {name: getattr(edit, name) for name in rows[type(edit)] if getattr(edit, name) is not None}
    count = len(next(iter(named.values())))
    for array in named.values():
        if array.dtype.kind not in "iu" or array.shape != (count,) or not ((array >= 0) & (array < num)).all():
            raise ValueError("an edit refers to rows that do not exist")
    fraction = getattr(edit, "fraction", np.zeros(count))
    # A projection on an edge is between its ends, up to rounding in float32.
    if fraction.shape != (count,) or not ((fraction >= -1e-6) & (fraction <= 1 + 1e-6)).all():
        raise ValueError("an edit's fraction is not between 0 and 1")
    if isinstance(edit, CollapseRound) and not (edit.takes_pole.shape == (count,) and edit.takes_pole.dtype == bool):
        raise ValueError("an edit is of another kind")
    if isinstance(edit, SplitRound):
        if not np.array_equal(edit.new, num + np.arange(count)):
            raise ValueError("the new rows of an edit do not follow its last row")
        return num + count
    return count if isinstance(edit, Compaction) else num
